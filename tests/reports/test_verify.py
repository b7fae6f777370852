# SPDX-License-Identifier: Apache-2.0
"""A report is checked against the design inside it."""

import hashlib
import io
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from random import Random

import pytest
from pypdf import PdfReader, PdfWriter
from pypdf.annotations import FreeText
from pypdf.generic import (
    ArrayObject,
    DecodedStreamObject,
    DictionaryObject,
    FloatObject,
    NameObject,
    NumberObject,
    StreamObject,
    TextStringObject,
)

from assistant.cli import main
from calc.design_file import Document
from calc.sheet.errors import BadInput
from calc.solve import Results
from reports import binding, title_block
from reports import verify as verifying
from reports.attach import NAME, RESULTS
from reports.paper import LEFT, WIDTH
from reports.printed import printed
from reports.report import render
from reports.verify import verify

from ..conftest import DESIGNS, ROOT
from .reading import V12, solved, spans


@pytest.fixture(scope="module")
def made() -> bytes:
    return solved(V12).report()


@pytest.fixture(autouse=True, scope="module")
def written_once() -> Iterator[None]:
    """The same design at the same depth gives the same report, byte for byte (test_same_bytes): it is written for comparison once."""
    known: dict[tuple[object, ...], bytes] = {}

    def again(document: Document, results: Results, raw: bytes, *, depth: str, lang: str, logo_file: bytes | None) -> bytes:
        asked = (raw, depth, lang, binding.PROGRAM)
        if asked not in known:
            known[asked] = render(document, results, raw, depth=depth, lang=lang, logo_file=logo_file)
        return known[asked]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(verifying, "render", again)
        yield


def rewritten(pdf: bytes, files: dict[str, bytes] | None = None, page: tuple[bytes, bytes] | None = None, keywords: str = "") -> bytes:
    """The report with other attachments, with a word of its first page changed, or with other keywords; the rest as it was."""
    reader, writer = PdfReader(io.BytesIO(pdf)), PdfWriter()
    for old in reader.pages:
        writer.add_page(old)
    writer.add_metadata({"/Keywords": keywords or str(reader.metadata.keywords)})  # type: ignore[union-attr]
    for name, contents in reader.attachments.items():
        writer.add_attachment(name, (files or {}).get(name, contents[0]))
    if page is not None:
        first = writer.pages[0]
        data = first.get_contents().get_data()  # type: ignore[union-attr]
        assert page[0] in data
        stream = DecodedStreamObject()
        stream.set_data(data.replace(page[0], page[1], 1))
        first[NameObject("/Contents")] = writer._add_object(stream)
    out = io.BytesIO()
    writer.write(out)
    return out.getvalue()


@pytest.mark.parametrize(("depth", "lang"), [("summary", "en"), ("engineer", "it"), ("audit", "en")])
def test_what_was_written_is_identical(depth: str, lang: str) -> None:
    found = verify(solved(V12).report(depth, lang), "r.pdf")
    assert found.identical and found.same_bytes and found.same_version and not found.differences


def test_a_copy_with_other_bytes_says_the_same(made: bytes) -> None:
    """As a program that signs a document, or makes it smaller, leaves it."""
    found = verify(rewritten(made), "r.pdf")
    assert found.identical and not found.same_bytes


def test_a_changed_design_is_found_and_what_it_changes(made: bytes) -> None:
    raw = PdfReader(io.BytesIO(made)).attachments[NAME][0]
    assert b"rated_speed_rpm = " in raw
    found = verify(rewritten(made, {NAME: raw.replace(b"rated_speed_rpm = ", b"rated_speed_rpm = 1")}), "r.pdf")
    assert found.changed == (NAME,) and not found.identical
    assert any(one.what.startswith("value imbalance.") for one in found.differences)


def test_changed_values_are_found(made: bytes) -> None:
    kept = json.loads(PdfReader(io.BytesIO(made)).attachments[RESULTS][0])
    kept["values"]["engine.stroke"] += 1.0
    kept["steps"]["engine"] = "fail"
    found = verify(rewritten(made, {RESULTS: json.dumps(kept).encode()}), "r.pdf")
    assert found.changed == (RESULTS,)
    assert [one.what for one in found.differences] == ["step engine", "value engine.stroke"]


def test_a_changed_page_is_found(made: bytes) -> None:
    data = PdfReader(io.BytesIO(made)).pages[0].get_contents().get_data()  # type: ignore[union-attr]
    word = max(re.findall(rb"<[0-9a-f]+>(?= Tj)", data), key=len)
    found = verify(rewritten(made, page=(word, b"<" + word[3:])), "r.pdf")
    assert not found.changed and [one.what for one in found.differences] == ["page 1"]


def test_another_version_is_said(made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    about = str(PdfReader(io.BytesIO(made)).metadata.keywords)  # type: ignore[union-attr]
    path = tmp_path / "old.pdf"
    path.write_bytes(rewritten(made, keywords=about.replace(verifying.VERSION, "0.0.1")))
    assert main(["verify", str(path)]) == 0
    assert "written by version 0.0.1" in capsys.readouterr().out


def test_exit_codes_and_words(made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "r.pdf"
    path.write_bytes(made)
    assert main(["verify", str(path)]) == 0
    assert capsys.readouterr().out.endswith("identical, byte for byte\n")
    raw = PdfReader(io.BytesIO(made)).attachments[NAME][0]
    path.write_bytes(rewritten(made, {NAME: raw.replace(b"rated_speed_rpm = ", b"rated_speed_rpm = 1")}))
    assert main(["verify", str(path)]) == 1
    short = capsys.readouterr().out
    assert "the attachment design.toml is not the one" in short and short.endswith("differs\n") and "--all lists them" in short
    assert main(["verify", str(path), "--all"]) == 1
    assert len(capsys.readouterr().out) > len(short)


@pytest.mark.parametrize("raw", [b"", b"%PDF-1.7", b"no report", b"%PDF-1.4\n%%EOF\n" * 9])
def test_what_is_no_report_is_refused(raw: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "x.pdf"
    path.write_bytes(raw)
    assert main(["verify", str(path)]) == 2
    assert str(path) in capsys.readouterr().err


def test_a_report_that_lost_its_attachments_is_refused(made: bytes, tmp_path: Path) -> None:
    writer = PdfWriter()
    for page in PdfReader(io.BytesIO(made)).pages:
        writer.add_page(page)
    with pytest.raises(BadInput, match="no report of this program"):
        verify(written(writer), "x.pdf")
    writer.add_metadata({"/Keywords": str(PdfReader(io.BytesIO(made)).metadata.keywords)})  # type: ignore[union-attr]
    with pytest.raises(BadInput, match=r"no attachment design\.toml and none results\.json"):
        verify(written(writer), "x.pdf")


def test_results_that_can_not_be_read_are_refused(made: bytes) -> None:
    with pytest.raises(BadInput, match="damaged"):
        verify(rewritten(made, {RESULTS: b"{"}), "x.pdf")
    with pytest.raises(BadInput, match="damaged"):
        verify(rewritten(made, {RESULTS: b"[]"}), "x.pdf")


def written(writer: PdfWriter) -> bytes:
    out = io.BytesIO()
    writer.write(out)
    return out.getvalue()


def test_keywords_that_no_report_has_are_refused(made: bytes) -> None:
    about = str(PdfReader(io.BytesIO(made)).metadata.keywords)  # type: ignore[union-attr]
    for wrong in (about.replace("depth:engineer", "depth:foo"), about.replace("lang:en", "lang:xx"), "Contralbero 0.1.0"):
        with pytest.raises(BadInput, match="no report of this program"):
            verify(rewritten(made, keywords=wrong), "x.pdf")
    found = verify(rewritten(made, keywords=about + ", depth:audit"), "x.pdf")
    assert found.identical, "of a keyword that stands twice the first counts"


def test_what_is_laid_over_a_page_or_hidden_beside_the_design_is_found(made: bytes) -> None:
    writer = PdfWriter(clone_from=io.BytesIO(made))
    writer.add_annotation(0, FreeText(text="0.0001", rect=(100, 600, 300, 700)))
    (over,) = verify(written(writer), "x.pdf").differences
    assert (over.what, over.was) == ("page 1, laid over it", "FreeText")
    writer = PdfWriter(clone_from=io.BytesIO(made))
    writer.add_attachment("other.toml", b"x = 1")
    found = verify(written(writer), "x.pdf")
    assert found.changed == ("other.toml",) and not found.identical


def forged(made: bytes, how: Callable[[PdfWriter], None]) -> list[str]:
    writer = PdfWriter(clone_from=io.BytesIO(made))
    how(writer)
    found = verify(written(writer), "x.pdf")
    return [*(f"attachment {name}" for name in found.changed), *(one.what for one in found.differences)]


def painted(writer: PdfWriter) -> StreamObject:
    """What an annotation may look like: a green field over everything."""
    stream = DecodedStreamObject()
    stream.set_data(b"0 1 0 rg 0 0 500 500 re f")
    stream.update({NameObject("/Subtype"): NameObject("/Form"), NameObject("/BBox"): ArrayObject(map(NumberObject, (0, 0, 500, 500)))})
    return writer._add_object(stream)


def laid(writer: PdfWriter, number: int = 0, rect: Sequence[float] = (50, 600, 500, 700), **kind: str) -> DictionaryObject:
    """An annotation that paints over a page."""
    one = DictionaryObject({NameObject("/Rect"): ArrayObject(map(FloatObject, rect))})
    one.update({NameObject(f"/{key}"): NameObject(f"/{value}") for key, value in kind.items()})
    one[NameObject("/AP")] = DictionaryObject({NameObject("/N"): painted(writer)})
    page = writer.pages[number]
    page[NameObject("/Annots")] = ArrayObject([*page.get("/Annots", []), writer._add_object(one)])
    return one


def another_font(writer: PdfWriter) -> None:
    fonts = {one.idnum: one for page in writer.pages for one in page["/Resources"]["/Font"].values()}  # type: ignore[index]
    file = next(iter(fonts.values())).get_object()["/FontDescriptor"]["/FontFile2"]  # type: ignore[index]
    file.set_data(file.get_data()[:-4] + b"abcd")


def another_file(writer: PdfWriter) -> None:
    """A specification may name its file twice, and readers differ in which of them they take."""
    names = writer._root_object["/Names"]["/EmbeddedFiles"]["/Names"]  # type: ignore[index]
    specification = names[1].get_object()
    raw = DecodedStreamObject()
    raw.set_data(b"schema = 1")
    specification["/EF"][NameObject("/F")] = writer._add_object(raw)


def opened(writer: PdfWriter) -> None:
    action = {NameObject("/S"): NameObject("/URI"), NameObject("/URI"): TextStringObject("https://example.org")}
    writer._root_object[NameObject("/OpenAction")] = DictionaryObject(action)


def spoken(writer: PdfWriter) -> None:
    """A figure whose words are others: seen by nobody, but read out."""
    top = writer._root_object["/StructTreeRoot"]["/K"]  # type: ignore[index]
    figure = next(one.get_object() for one in top["/K"] if one.get_object()["/S"] == "/Figure")
    figure[NameObject("/Alt")] = TextStringObject("all checks pass")


def retitled(writer: PdfWriter) -> None:
    stream = writer._root_object["/Metadata"].get_object()
    stream.set_data(stream.get_data().replace(b"V12 at", b"approved: V12 at"))


@pytest.mark.parametrize(
    ("how", "what"),
    [
        (lambda w: w.pages[0].cropbox.__setitem__(3, NumberObject(400)), "page 1, what is drawn on it"),
        (lambda w: w.pages[0].rotate(180), "page 1, what is drawn on it"),
        (another_font, "page 1, what is drawn on it"),
        (lambda w: laid(w, Subtype="Link"), "page 1, laid over it"),
        (lambda w: laid(w, Subtype="Widget", FT="Btn"), "page 1, laid over it"),
        (lambda w: laid(w, rect=(0, 0, 5, 5), Subtype="Stamp", FT="Sig"), "page 1, laid over it"),
        (lambda w: laid(w, rect=(0, 0, 5, 5), Subtype="Widget", FT="Sig", AA="Bl"), "page 1, laid over it"),
        (spoken, "the document's structure"),
        (retitled, "the document's title"),
        (another_file, "attachment design.toml"),
        (opened, "the document as a whole"),
        (lambda w: w.add_metadata({"/Title": "all checks pass"}), "the document's title"),
        (lambda w: w._root_object["/Names"].update({NameObject("/JavaScript"): DictionaryObject()}), "the document as a whole"),
    ],
    ids=["crop", "turn", "font", "link", "button", "stamp", "script of a field", "alt", "xmp", "file", "action", "title", "script"],
)
def test_what_a_reader_would_see_or_take_otherwise_is_found(made: bytes, how: Callable[[PdfWriter], None], what: str) -> None:
    assert what in forged(made, how)


def test_a_clone_alone_is_no_forgery(made: bytes) -> None:
    assert not forged(made, lambda writer: None)


def test_a_signature_over_what_is_printed_is_a_difference(made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A green PASS set over the verdict as the look of a signature is no signature."""
    verdict = next(span for span in spans(made) if span.size == 15.0)
    writer = PdfWriter(clone_from=io.BytesIO(made))
    laid(writer, rect=(verdict.x, verdict.y, verdict.end, verdict.y + 12), Subtype="Widget", FT="Sig")
    path = tmp_path / "stamped.pdf"
    path.write_bytes(written(writer))
    assert main(["verify", str(path)]) == 1
    out = capsys.readouterr().out
    assert f"page 1, under the field of a signature: covered in the report, “{verdict.text}" in out and out.endswith("differs\n")


def test_a_signature_over_a_figure_is_a_difference(made: bytes) -> None:
    page = next(n for n, page in enumerate(PdfReader(io.BytesIO(made)).pages) if b"/Figure" in page.get_contents().get_data())  # type: ignore[union-attr]
    box = next(box for box, words in printed(PdfReader(io.BytesIO(made)).pages[page]) if words == "figure")
    writer = PdfWriter(clone_from=io.BytesIO(made))
    laid(writer, page, rect=(box[0] + 1, box[1] + 1, box[0] + 9, box[1] + 9), Subtype="Widget", FT="Sig")
    assert [one.what for one in verify(written(writer), "x.pdf").differences] == [f"page {page + 1}, under the field of a signature"]


def test_a_signature_in_its_box_is_said_and_no_difference(made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A field that fills the box to sign in, whichever row it is, covers nothing."""
    for row in ("Prepared", "Checked", "Approved"):
        label = next(span for span in spans(made) if span.text == row)
        top = label.y + 0.64 * title_block.SIGN
        left, right = LEFT + title_block.SIGN_AT[3], LEFT + WIDTH
        writer = PdfWriter(clone_from=io.BytesIO(made))
        laid(writer, rect=(left, top - title_block.SIGN, right, top), Subtype="Widget", FT="Sig")
        path = tmp_path / f"{row}.pdf"
        path.write_bytes(written(writer))
        found = verify(path.read_bytes(), "x.pdf")
        assert found.kept and not found.identical and found.signed == (1,)
    assert main(["verify", str(path)]) == 0
    out = capsys.readouterr().out
    assert "page 1 carries the field of a signature" in out and out.splitlines()[-1].startswith("signed, or prepared for it")


def test_a_name_that_a_terminal_would_obey_is_written_out(made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    writer = PdfWriter(clone_from=io.BytesIO(made))
    writer.add_attachment("x\x1b[2K\ridentical\x1b[8m", b"1")
    path = tmp_path / "x.pdf"
    path.write_bytes(written(writer))
    assert main(["verify", str(path)]) == 1
    out = capsys.readouterr().out
    assert "\x1b" not in out and "\\x1b[2K" in out and out.endswith("differs\n")


def test_more_than_results_in_the_results_is_found(made: bytes) -> None:
    kept = json.loads(PdfReader(io.BytesIO(made)).attachments[RESULTS][0])
    raw = json.dumps({**kept, "approved": "by everybody"}).encode()
    about = str(PdfReader(io.BytesIO(made)).metadata.keywords)  # type: ignore[union-attr]
    sums = [hashlib.sha256(one).hexdigest() for one in (PdfReader(io.BytesIO(made)).attachments[RESULTS][0], raw)]
    found = verify(rewritten(made, {RESULTS: raw}, keywords=about.replace(*sums)), "x.pdf")
    assert not found.changed and [one.was for one in found.differences] == ["approved"]


def test_a_report_of_another_version_is_compared_by_its_texts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its version stands at the foot of every page; that alone is no difference."""
    with monkeypatch.context() as then:
        for module in (binding, title_block):
            then.setattr(module, "PROGRAM", "Contralbero 0.0.9")
        old = solved(V12).report("summary")
    found = verify(old, "x.pdf")
    assert found.version == "0.0.9" and not found.same_version and found.identical


def test_a_line_drawn_otherwise_is_found(made: bytes) -> None:
    data = PdfReader(io.BytesIO(made)).pages[0].get_contents().get_data()  # type: ignore[union-attr]
    rule = next(line for line in data.splitlines() if line.endswith(b"re f"))
    found = verify(rewritten(made, page=(rule, b"0 0 0 rg 0 0 500 500 re f")), "r.pdf")
    assert [one.what for one in found.differences] == ["page 1, what is drawn on it"]


def test_an_encrypted_file_is_refused_by_name(made: bytes) -> None:
    writer = PdfWriter(clone_from=io.BytesIO(made))
    writer.encrypt("secret", algorithm="RC4-128")
    with pytest.raises(BadInput, match="is encrypted"):
        verify(written(writer), "x.pdf")


@pytest.mark.parametrize("raw", [b"[" * 200_000, b"{}", b"[]", b'{"values": 1, "checks": {}, "steps": {}}'])
def test_results_of_any_shape_are_refused(made: bytes, raw: bytes) -> None:
    with pytest.raises(BadInput, match="damaged"):
        verify(rewritten(made, {RESULTS: raw}), "x.pdf")


@pytest.mark.parametrize("seed", ["1", pytest.param("7", marks=pytest.mark.slow)])
def test_the_order_of_a_set_changes_nothing(seed: str, tmp_path: Path) -> None:
    """An Italian report is written, and verified in another process, whose sets have another order."""
    path = tmp_path / "r.pdf"
    for seeded, arguments in (
        (seed, ["report", str(DESIGNS / "thesis_tip_relief.toml"), "--lang", "it", "-o", str(path)]),
        ("0", ["verify", str(path)]),
    ):
        run = subprocess.run(
            [sys.executable, "-m", "assistant", *arguments],
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": seeded},
            capture_output=True,
            text=True,
        )
        assert run.stdout.strip() and not run.stderr
    assert run.stdout.endswith("identical, byte for byte\n"), run.stdout


def test_verify_never_breaks_on_damage(made: bytes) -> None:
    """Any byte may be lost: the answer is a verdict or a refusal in words."""
    summary = solved(V12).report("summary")
    random = Random(7)
    for _ in range(12):
        at, n = random.randrange(len(summary)), random.randrange(1, 40)
        try:
            verify(summary[:at] + bytes(random.randrange(256) for _ in range(n)) + summary[at + n :], "x.pdf")
        except BadInput as refused:
            assert "x.pdf" in str(refused)
