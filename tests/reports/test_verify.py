# SPDX-License-Identifier: Apache-2.0
"""A report is checked against the design inside it."""

import hashlib
import io
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Sequence
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
from calc.design.limits import PDF_BYTES
from calc.sheet.errors import BadInput
from reports.blocks import title_block
from reports.pdf import binding
from reports.pdf.attach import NAME, RESULTS
from reports.verify import verify as verifying
from reports.verify.verify import Verdict, verify
from tests.conftest import DESIGNS, ROOT
from tests.reports.forgeries import EMPTY
from tests.reports.reading import V12, solved

pytestmark = pytest.mark.usefixtures("written_once")


def rewritten(
    pdf: bytes, files: dict[str, bytes] | None = None, page: tuple[bytes, bytes] | None = None, keywords: str = ""
) -> bytes:
    """The report with other attachments, with a word of its first page changed, or with other keywords; the rest as it
    was."""
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
    assert found.verdict is Verdict.IDENTICAL and found.version == verifying.VERSION and not found.differences


def test_a_copy_with_other_bytes_is_said_to_be_one(
    made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """As a program leaves it that makes a document smaller; whatever it holds, nobody vouches for it."""
    path = tmp_path / "anew.pdf"
    path.write_bytes(written(PdfWriter(clone_from=io.BytesIO(made))))
    found = verify(path.read_bytes(), "r.pdf")
    assert (found.verdict, found.differences) == (Verdict.SAVED_ANEW, ())
    assert main(["verify", str(path)]) == 1
    assert capsys.readouterr().out.splitlines()[-1].startswith("saved anew: ")


def test_a_changed_design_is_found_and_what_it_changes(made: bytes) -> None:
    raw = PdfReader(io.BytesIO(made)).attachments[NAME][0]
    assert b"rated_speed_rpm = " in raw
    found = verify(rewritten(made, {NAME: raw.replace(b"rated_speed_rpm = ", b"rated_speed_rpm = 1")}), "r.pdf")
    assert found.changed == (NAME,) and found.verdict is Verdict.DIFFERS
    assert any(one.what.startswith("value imbalance.") for one in found.differences)


def test_changed_values_are_found(made: bytes) -> None:
    kept = json.loads(PdfReader(io.BytesIO(made)).attachments[RESULTS][0])
    kept["values"]["engine.stroke"] += 1.0
    kept["steps"]["engine"] = "fail"
    found = verify(rewritten(made, {RESULTS: json.dumps(kept).encode()}), "r.pdf")
    assert found.changed == (RESULTS,)
    assert [one.what for one in found.differences][:2] == ["step engine", "value engine.stroke"]


def test_a_changed_page_is_found(made: bytes) -> None:
    data = PdfReader(io.BytesIO(made)).pages[0].get_contents().get_data()  # type: ignore[union-attr]
    word = max(re.findall(rb"<[0-9a-f]+>(?= Tj)", data), key=len)
    found = verify(rewritten(made, page=(word, b"<" + word[3:])), "r.pdf")
    assert not found.changed and "page 1" in [one.what for one in found.differences]


def test_another_version_is_a_word_of_its_own(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its version stands at the foot of every page; that alone is no difference."""
    with monkeypatch.context() as then:
        for module in (binding, title_block):
            then.setattr(module, "PROGRAM", "Contralbero 0.0.9")
        old = solved(V12).report("summary")
    found = verify(old, "x.pdf")
    assert (found.version, found.verdict, found.differences) == ("0.0.9", Verdict.OTHER_VERSION, ())
    path = tmp_path / "old.pdf"
    path.write_bytes(old)
    assert main(["verify", str(path)]) == 1
    out = capsys.readouterr().out
    assert "written by version 0.0.9" in out and out.splitlines()[-1].startswith("another version: ")


def test_exit_codes_and_words(made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "r.pdf"
    path.write_bytes(made)
    assert main(["verify", str(path)]) == 0
    assert capsys.readouterr().out.endswith("identical, byte for byte\n")
    raw = PdfReader(io.BytesIO(made)).attachments[NAME][0]
    path.write_bytes(rewritten(made, {NAME: raw.replace(b"rated_speed_rpm = ", b"rated_speed_rpm = 1")}))
    assert main(["verify", str(path)]) == 1
    short = capsys.readouterr().out
    assert (
        "the attachment design.toml is not the one" in short
        and short.endswith("differs\n")
        and "--all lists them" in short
    )
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
    for wrong in (
        about.replace("depth:engineer", "depth:foo"),
        about.replace("lang:en", "lang:xx"),
        f"Contralbero {verifying.VERSION}",
    ):
        with pytest.raises(BadInput, match="no report of this program"):
            verify(rewritten(made, keywords=wrong), "x.pdf")
    found = verify(rewritten(made, keywords=about + ", depth:audit"), "x.pdf")
    assert "the document's keywords" in [one.what for one in found.differences], (
        "of a keyword that stands twice the first counts"
    )


def test_what_is_laid_over_a_page_or_hidden_beside_the_design_is_found(made: bytes) -> None:
    writer = PdfWriter(clone_from=io.BytesIO(made))
    writer.add_annotation(0, FreeText(text="0.0001", rect=(100, 600, 300, 700)))
    (over,) = verify(written(writer), "x.pdf").differences
    assert (over.what, over.was) == ("page 1, laid over it", "FreeText")
    writer = PdfWriter(clone_from=io.BytesIO(made))
    writer.add_attachment("other.toml", b"x = 1")
    found = verify(written(writer), "x.pdf")
    assert found.changed == ("other.toml",) and found.verdict is Verdict.DIFFERS


def forged(made: bytes, how: Callable[[PdfWriter], None]) -> list[str]:
    writer = PdfWriter(clone_from=io.BytesIO(made))
    how(writer)
    found = verify(written(writer), "x.pdf")
    return [*(f"attachment {name}" for name in found.changed), *(one.what for one in found.differences)]


def painted(writer: PdfWriter) -> StreamObject:
    """What an annotation may look like: a green field over everything."""
    stream = DecodedStreamObject()
    stream.set_data(b"0 1 0 rg 0 0 500 500 re f")
    stream.update(
        {
            NameObject("/Subtype"): NameObject("/Form"),
            NameObject("/BBox"): ArrayObject(map(NumberObject, (0, 0, 500, 500))),
        }
    )
    return writer._add_object(stream)


def laid(
    writer: PdfWriter, number: int = 0, rect: Sequence[float] = (50, 600, 500, 700), **kind: str
) -> DictionaryObject:
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
        (retitled, "the document's metadata"),
        (another_file, "attachment design.toml"),
        (opened, "the document as a whole"),
        (lambda w: w.add_metadata({"/Title": "all checks pass"}), "the document's title"),
        (
            lambda w: w._root_object["/Names"].update({NameObject("/JavaScript"): DictionaryObject()}),
            "the document as a whole",
        ),
    ],
    ids=[
        "crop",
        "turn",
        "font",
        "link",
        "button",
        "stamp",
        "script of a field",
        "alt",
        "xmp",
        "file",
        "action",
        "title",
        "script",
    ],
)
def test_what_a_reader_would_see_or_take_otherwise_is_found(
    made: bytes, how: Callable[[PdfWriter], None], what: str
) -> None:
    assert what in forged(made, how)


def test_a_clone_alone_is_no_forgery(made: bytes) -> None:
    assert not forged(made, lambda writer: None)


def test_a_name_that_a_terminal_would_obey_is_written_out(
    made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    writer = PdfWriter(clone_from=io.BytesIO(made))
    writer.add_attachment("x\x1b[2K\ridentical\x1b[8m", b"1")
    path = tmp_path / "x.pdf"
    path.write_bytes(written(writer))
    assert main(["verify", str(path)]) == 1
    out = capsys.readouterr().out
    assert "\x1b" not in out and "\\u001b[2K" in out and out.endswith("differs\n")


def test_more_than_results_in_the_results_is_found(made: bytes) -> None:
    kept = json.loads(PdfReader(io.BytesIO(made)).attachments[RESULTS][0])
    raw = json.dumps({**kept, "approved": "by everybody"}).encode()
    about = str(PdfReader(io.BytesIO(made)).metadata.keywords)  # type: ignore[union-attr]
    sums = [hashlib.sha256(one).hexdigest() for one in (PdfReader(io.BytesIO(made)).attachments[RESULTS][0], raw)]
    found = verify(rewritten(made, {RESULTS: raw}, keywords=about.replace(*sums)), "x.pdf")
    assert not found.changed and found.differences[0].was == "approved"


def test_a_line_drawn_otherwise_is_found(made: bytes) -> None:
    data = PdfReader(io.BytesIO(made)).pages[0].get_contents().get_data()  # type: ignore[union-attr]
    rule = next(line for line in data.splitlines() if line.endswith(b"re f"))
    found = verify(rewritten(made, page=(rule, b"0 0 0 rg 0 0 500 500 re f")), "r.pdf")
    assert "page 1, what is drawn on it" in [one.what for one in found.differences]


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


def test_what_is_no_file_of_a_report_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A pipe would be waited for, and a device read for ever."""
    large = tmp_path / "large.pdf"
    with large.open("wb") as file:
        file.truncate(PDF_BYTES + 1)
    paths = [tmp_path, large, tmp_path / "missing.pdf", Path("a\0b.pdf")]
    if os.name == "posix":
        os.mkfifo(tmp_path / "pipe.pdf")
        paths += [tmp_path / "pipe.pdf", Path(os.devnull)]
    for path, reason in zip(
        paths,
        ("Is a directory", f"at most {PDF_BYTES:,}", "cannot be read", "cannot be read", *("is no regular file",) * 2),
    ):
        assert main(["verify", str(path)]) == 2
        assert reason in capsys.readouterr().err


def test_another_program_that_appends_is_accepted(made: bytes) -> None:
    """Its table of objects is a stream, and leaves itself out."""
    writer = PdfWriter(io.BytesIO(made), incremental=True)
    rect = ArrayObject(map(FloatObject, EMPTY))
    names = {"Type": "Annot", "Subtype": "Widget", "FT": "Sig"}
    field = DictionaryObject({NameObject(f"/{key}"): NameObject(f"/{value}") for key, value in names.items()})
    field |= {NameObject("/T"): TextStringObject("s"), NameObject("/F"): NumberObject(4), NameObject("/Rect"): rect}
    known = writer._add_object(field)
    page = writer.pages[0]
    page[NameObject("/Annots")] = ArrayObject([*page.get("/Annots", []), known])
    writer.root_object[NameObject("/AcroForm")] = DictionaryObject({NameObject("/Fields"): ArrayObject([known])})
    found = verify(written(writer), "x.pdf")
    assert (found.verdict, found.signed) == (Verdict.SIGNED, (1,))
