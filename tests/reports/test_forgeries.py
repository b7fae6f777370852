# SPDX-License-Identifier: Apache-2.0
"""No forged report is called identical, and what is accepted looks to other readers as it should."""

import io
from random import Random

import pypdfium2
import pytest
from pypdf import PdfReader, PdfWriter

from calc.sheet.errors import BadInput
from reports.verify.difference import page_references, printed
from reports.verify.pdf_file import Pdf
from reports.verify.signature import fields
from reports.verify.verify import Verdict, verify
from tests.reports.forgeries import EMPTY, KINDS, Update
from tests.reports.reading import V12, solved

UNSEEN = 0.2  # points: narrower is no letter
SAME_AS_BEFORE = {  # which change bytes and nothing that is read; another word than identical is what they get
    "anew: as it was",
    "bytes: another comment",
    "bytes: another head",
}


pytestmark = pytest.mark.usefixtures("written_once")


@pytest.fixture(scope="module")
def made() -> bytes:
    return solved(V12).report("summary")


def verdict(raw: bytes) -> Verdict | None:
    """None for what is refused."""
    try:
        return verify(raw, "x.pdf").verdict
    except BadInput as refused:
        assert "x.pdf" in str(refused)
        return None


def test_there_are_many_kinds() -> None:
    assert len(KINDS) >= 60


@pytest.mark.parametrize("kind", KINDS)
def test_no_forgery_is_accepted(made: bytes, kind: str) -> None:
    forged = KINDS[kind](made)
    assert forged != made
    found = verdict(forged)
    assert found not in (Verdict.IDENTICAL, Verdict.SIGNED)
    assert (found is Verdict.SAVED_ANEW) == (kind in SAME_AS_BEFORE)


def test_without_what_is_forged_it_is_accepted(made: bytes) -> None:
    """So that it is the forgery that is found, and not how it is appended."""
    update = Update(made)
    assert verdict(made) is Verdict.IDENTICAL
    update.sign()
    assert verdict(update.written()) is Verdict.SIGNED
    assert verdict(update.written_with_stream()) is Verdict.SIGNED


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
def test_what_any_program_saves_anew_is_said_to_be_that(made: bytes, signed: bytes, program: str) -> None:
    """And with a signature it is no signed report any more: the bytes that were signed are gone."""
    assert verdict(saved_by(program, made)) is Verdict.SAVED_ANEW
    assert verdict(saved_by(program, signed)) is Verdict.DIFFERS


# --- a second engine
@pytest.fixture(scope="module")
def signed(made: bytes) -> bytes:
    """A report with a field whose look would paint over the whole page."""
    update = Update(made)
    update.sign()
    raw = update.written()
    assert verdict(raw) is Verdict.SIGNED
    return raw


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


def test_a_mutant_that_is_accepted_is_drawn_as_the_report(made: bytes, signed: bytes) -> None:
    """Whatever is accepted has the text of the report, and other colours only under its field."""
    random = Random(7)
    before = drawn(made)
    accepted = 0
    for _ in range(150):
        raw = mutant(signed, len(made), random)
        if verdict(raw) is Verdict.SIGNED:
            accepted += 1
            after = drawn(raw)
            assert [text for text, _, _ in before] == [text for text, _, _ in after]
            sheets = page_references(Pdf(made))
            places = [place for _, place in fields(made, raw, sheets)]
            assert all(any(within(point, place) for place in places) for point in other_points(before, after))
    assert accepted, "what a field shows may be anything"


def drawn(raw: bytes) -> list[tuple[str, bytes, tuple[int, int]]]:
    """What the pages of a document say and how they look: a sign of a pixel a point."""
    document = pypdfium2.PdfDocument(raw)
    document.init_forms()
    found = []
    for page in document:
        picture = page.render(scale=1, may_draw_forms=True).to_pil().convert("RGB")
        found.append((page.get_textpage().get_text_bounded(), picture.tobytes(), picture.size))
    return found


def test_a_second_engine_sees_a_signature_in_its_place_and_nowhere_else(made: bytes, signed: bytes) -> None:
    before, after = drawn(made), drawn(signed)
    assert [text for text, _, _ in before] == [text for text, _, _ in after]
    assert [size for _, _, size in before] == [size for _, _, size in after]
    other = other_points(before, after)
    assert other, "the field is drawn"
    assert all(within(point, EMPTY) for point in other)


def other_points(
    before: list[tuple[str, bytes, tuple[int, int]]], after: list[tuple[str, bytes, tuple[int, int]]]
) -> list[tuple[int, int]]:
    """Where the pages of two documents have other colours."""
    found = []
    for (_, old, (wide, high)), (_, new, size) in zip(before, after, strict=True):
        assert size == (wide, high)
        if old != new:
            found += [
                (n // 3 % wide, high - n // 3 // wide)
                for n in range(0, len(old), 3)
                if old[n : n + 3] != new[n : n + 3]
            ]
    return found


def within(point: tuple[int, int], place: tuple[float, float, float, float]) -> bool:
    """Whether a pixel touches a rectangle."""
    (x, y), (left, low, right, top) = point, place
    return left - 1 <= x <= right + 1 and low - 1 <= y <= top + 1


def test_a_second_engine_reads_the_same_keys_and_files(made: bytes, signed: bytes) -> None:
    for raw in (made, signed):
        second = pypdfium2.PdfDocument(raw)
        ours = Pdf(raw)
        assert second.get_metadata_dict(skip_empty=True)["Keywords"].encode() == ours.info["Keywords"]
        files = [second.get_attachment(n) for n in range(second.count_attachments())]
        assert {file.get_name(): bytes(file.get_data()) for file in files} == {
            name: some[0] for name, some in PdfReader(io.BytesIO(raw)).attachments.items()
        }


def test_a_second_engine_finds_no_letter_outside_what_is_known_to_be_printed(engineer: bytes) -> None:
    """Every letter that it finds lies in a piece of text or a figure that a field may not cover; some are there to be
    copied, not seen."""
    pdf, second = Pdf(engineer), pypdfium2.PdfDocument(engineer)
    pages = page_references(pdf)
    assert len(pages) == len(second)
    for reference, page in zip(pages, second):
        known = [box for box, _ in printed(pdf, reference)]
        text = page.get_textpage()
        for left, low, right, top in map(text.get_charbox, range(text.count_chars())):
            x, y = (left + right) / 2, (low + top) / 2
            assert right - left < UNSEEN or any(a - 1 <= x <= c + 1 and b - 1 <= y <= d + 1 for a, b, c, d in known)


@pytest.mark.parametrize("kind", [name for name in KINDS if name.startswith(("twice:", "table:", "page:"))])
def test_what_readers_may_see_otherwise_is_never_accepted(made: bytes, kind: str) -> None:
    """Where the second engine shows another page than the report's, the verdict must not be one that speaks for it."""
    forged = KINDS[kind](made)
    try:
        seen = drawn(forged)
    except pypdfium2.PdfiumError:
        return
    if seen != drawn(made):
        assert verdict(forged) not in (Verdict.IDENTICAL, Verdict.SIGNED, Verdict.SAVED_ANEW)
