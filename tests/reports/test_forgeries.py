# SPDX-License-Identifier: Apache-2.0
"""No forged report is called identical or signed, whoever signs it after; and what is, looks as the report to other
readers."""

import io
from random import Random
from typing import Any

import pypdfium2
import pytest
from pypdf import PdfWriter

from calc.sheet.errors import BadInput
from reports.verify.verify import Verdict, verify
from tests.reports.forged_looks import free, looks, value, within
from tests.reports.forgeries import KINDS, Update
from tests.reports.reading import V12, solved
from tests.reports.signing import sealed, sign

pytestmark = pytest.mark.usefixtures("written_once")
ACCEPTED = (Verdict.IDENTICAL, Verdict.SIGNED)
ENDLESS = [kind for kind in KINDS if kind.startswith("without end: ")]
OTHERS = [kind for kind in KINDS if kind not in ENDLESS]
# a program that signs by what PDF 2.0 has may say that it is that
APPENDING = [
    kind for kind in OTHERS if not kind.startswith(("smuggled", "sealed", "anew")) and kind != "document: version"
]


@pytest.fixture(scope="module")
def made() -> bytes:
    return solved(V12).report("summary")


@pytest.fixture(scope="module")
def signed(made: bytes) -> bytes:
    return sign(made)


def verdict(raw: bytes) -> Verdict | None:
    """None for what is refused."""
    try:
        return verify(raw, "x.pdf").verdict
    except BadInput as refused:
        assert "x.pdf" in str(refused)
        return None


def test_there_are_many_kinds() -> None:
    assert len(KINDS) >= 120


@pytest.mark.parametrize(
    "kind", [pytest.param(kind, marks=pytest.mark.slow if n % 2 else ()) for n, kind in enumerate(OTHERS)]
)
def test_no_forgery_is_accepted(made: bytes, read_here: None, kind: str) -> None:
    forged = KINDS[kind](made)
    assert forged != made
    assert verdict(forged) not in ACCEPTED


@pytest.mark.parametrize(
    "kind", [pytest.param(kind, marks=pytest.mark.slow if n % 5 else ()) for n, kind in enumerate(ENDLESS)]
)
def test_what_has_no_end_ends_its_reader(made: bytes, monkeypatch: pytest.MonkeyPatch, kind: str) -> None:
    """In a process of its own, of which only the time is waited for."""
    monkeypatch.setattr("reports.apart.APPENDED_SECONDS", 5)
    assert verdict(KINDS[kind](made)) is Verdict.APPENDED


@pytest.mark.parametrize(
    "kind", [pytest.param(kind, marks=pytest.mark.slow if n % 10 else ()) for n, kind in enumerate(OTHERS)]
)
def test_no_forgery_is_accepted_that_is_signed_after_or_was_before(
    made: bytes, signed: bytes, read_here: None, kind: str
) -> None:
    """By anybody, in a field of the report, so that the signature covers the forgery; or behind a sound signature."""
    try:
        forged = KINDS[kind](made)
        after = sign(forged)
    except Exception:  # it can not even be signed
        pass
    else:
        assert forged.strip() == made.strip() or verdict(after) not in ACCEPTED  # white space that is signed is nothing
    try:
        before = KINDS[kind](signed)
    except (AssertionError, KeyError, ValueError):  # it has no place for this
        return
    assert before == signed or verdict(before) not in ACCEPTED


@pytest.mark.parametrize(
    "kind", [pytest.param(kind, marks=pytest.mark.slow if n % 5 else ()) for n, kind in enumerate(APPENDING)]
)
def test_no_forgery_is_accepted_in_a_revision_that_is_signed(
    made: bytes, read_here: None, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    """By somebody who signs as is right, over all that is there."""
    plain = Update.written

    def written(update: Update, **how: Any) -> bytes:
        update.last(free(update), b"/V %d 0 R" % value(update))
        return sealed(plain(update, **how) if how else update.written_with_stream(), len(update.pdf))

    monkeypatch.setattr(Update, "written", written)
    try:
        forged = KINDS[kind](made)
    except (AssertionError, KeyError, ValueError):  # it has no place for this
        return
    assert verdict(forged) not in ACCEPTED


def test_without_what_is_forged_it_is_accepted(made: bytes, signed: bytes) -> None:
    """So that it is the forgery that is found, and not how it is appended."""
    assert (verdict(made), verdict(signed)) == ACCEPTED
    assert verdict(within(made)) is verdict(within(made, looks())) is verdict(within(signed)) is Verdict.SIGNED


def saved_by(program: str, raw: bytes) -> bytes:
    out = io.BytesIO()
    if program.startswith("qpdf"):
        pikepdf = pytest.importorskip("pikepdf")
    match program:
        case "pypdf":
            PdfWriter(clone_from=io.BytesIO(raw)).write(out)
        case "pdfium":
            pypdfium2.PdfDocument(raw).save(out)
        case "qpdf, linear":
            pikepdf.open(io.BytesIO(raw)).save(out, linearize=True)
        case "qpdf, plain":
            pikepdf.open(io.BytesIO(raw)).save(out, object_stream_mode=pikepdf.ObjectStreamMode.disable)
    return out.getvalue()


@pytest.mark.parametrize("program", ["pypdf", "pdfium", "qpdf, linear", "qpdf, plain"])
def test_what_any_program_saves_anew_is_not_as_written(made: bytes, signed: bytes, program: str) -> None:
    """And with a signature it is no signed report any more: the bytes that were signed are gone.  What is inside is
    compared, and nobody says that it looks the same."""
    for raw in (made, signed):
        found = verify(saved_by(program, raw), "x.pdf")
        assert found.verdict is Verdict.NOT_AS_WRITTEN and not found.differences and not found.changed
        assert found.compared > 100


# --- a second engine


def mutant(raw: bytes, start: int, random: Random) -> bytes:
    """A file with some of what was appended to it lost, doubled, or another byte."""
    tail = bytearray(raw[start:])
    at = random.randrange(len(tail))
    to = at + random.randrange(1, 40)
    match random.randrange(3):
        case 0:
            tail[at] = random.randrange(256)
        case 1:
            del tail[at:to]
        case _:
            tail[at:at] = tail[at:to]
    return raw[:start] + bytes(tail)


def test_a_mutant_that_is_accepted_is_drawn_as_the_report(made: bytes, signed: bytes, read_here: None) -> None:
    random = Random(7)
    before = drawn(made)
    for _ in range(60):
        raw = mutant(signed, len(made), random)
        if raw != signed and verdict(raw) in ACCEPTED:
            assert drawn(raw) == before


def drawn(raw: bytes) -> list[tuple[str, bytes, tuple[int, int]]]:
    """What the pages of a document say and how they look: a sign of a pixel a point."""
    document = pypdfium2.PdfDocument(raw)
    document.init_forms()
    found = []
    for page in document:
        picture = page.render(scale=1, may_draw_forms=True).to_pil().convert("RGB")
        found.append((page.get_textpage().get_text_bounded(), picture.tobytes(), picture.size))
    return found


def test_a_second_engine_sees_the_report_in_what_is_signed(made: bytes, signed: bytes) -> None:
    """A signature without a look changes nothing that is seen."""
    before, after = drawn(made), drawn(signed)
    assert [(text, size) for text, _, size in before] == [(text, size) for text, _, size in after]
