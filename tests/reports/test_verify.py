# SPDX-License-Identifier: Apache-2.0
"""A report is checked against the design inside it."""

import hashlib
import io
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from random import Random

import pytest
from pypdf import PdfReader, PdfWriter
from pypdf.generic import (
    DecodedStreamObject,
    NameObject,
)

from assistant.cli import main
from calc.design.limits import PDF_BYTES
from calc.sheet.errors import BadInput
from calc.sheet.version import VERSION
from reports.made import others, versions
from reports.pdf.attach import NAME, RESULTS
from reports.report import render
from reports.verify.verify import NOTHING, Difference, Verdict, verify
from tests.conftest import DESIGNS, ROOT
from tests.reports.reading import V12, solved
from tests.test_imports import loaded

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
    assert found.verdict is Verdict.IDENTICAL and found.made == versions() and not others(found.made)


def test_a_copy_with_other_bytes_is_said_to_be_one(
    made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """As a program leaves it that makes a document smaller; what is inside is compared, whatever its pages show."""
    path = tmp_path / "anew.pdf"
    path.write_bytes(written(PdfWriter(clone_from=io.BytesIO(made))))
    found = verify(path.read_bytes(), "r.pdf")
    assert (found.verdict, found.differences) == (Verdict.NOT_AS_WRITTEN, ())
    assert main(["verify", str(path)]) == 4
    *_, compared, last = capsys.readouterr().out.splitlines()
    assert "values and verdicts were compared: the same to 1e-9" in compared
    assert last.startswith("not as written: ") and "pages were not looked at" in last
    assert main(["verify", str(path), "--original", str(tmp_path / "ours.pdf")]) == 2
    assert not (tmp_path / "ours.pdf").exists()


def test_a_changed_design_is_found_and_what_it_changes(made: bytes) -> None:
    raw = PdfReader(io.BytesIO(made)).attachments[NAME][0]
    assert b"rated_speed_rpm = " in raw
    found = verify(rewritten(made, {NAME: raw.replace(b"rated_speed_rpm = ", b"rated_speed_rpm = 1")}), "r.pdf")
    assert found.changed == (NAME,) and found.verdict is Verdict.NOT_AS_WRITTEN
    assert any(one.what.startswith("values imbalance.") for one in found.differences)


def test_changed_values_are_found(made: bytes) -> None:
    kept = json.loads(PdfReader(io.BytesIO(made)).attachments[RESULTS][0])
    kept["values"]["engine.stroke"] += 1.0
    kept["steps"]["engine"] = "fail"
    found = verify(rewritten(made, {RESULTS: json.dumps(kept).encode()}), "r.pdf")
    assert found.changed == (RESULTS,)
    assert [one.what for one in found.differences][:2] == ["steps engine", "values engine.stroke"]


def test_the_versions_are_taken_from_the_report(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With them the same bytes are written; that they are others here is said."""
    v12, theirs = solved(V12), {"program": "0.0.9", "python": "3.13.1", "numpy": "1.26.4", "scipy": "1.11.0rc1"}
    old = render(v12.document, v12.results, v12.raw, depth="summary", made=theirs)
    found = verify(old, "x.pdf")
    assert (found.verdict, found.made) == (Verdict.IDENTICAL, theirs)
    path = tmp_path / "old.pdf"
    path.write_bytes(old)
    assert main(["verify", str(path)]) == 0
    out = capsys.readouterr().out
    assert "made with program 0.0.9; here is " in out and "made with scipy 1.11.0rc1; here is " in out
    assert "Contralbero 0.0.9" in PdfReader(io.BytesIO(old)).pages[0].extract_text()
    assert "Computed with Python 3.13.1, numpy 1.26.4, scipy 1.11.0rc1." in " ".join(
        PdfReader(io.BytesIO(old)).pages[0].extract_text().split()
    )


def test_a_report_of_an_older_program_is_compared(
    made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It has no fields and no versions; its words for verdicts may be others."""
    kept = json.loads(PdfReader(io.BytesIO(made)).attachments[RESULTS][0])
    kept["values"]["engine.stroke"] += 1.0
    kept["steps"]["imbalance"] = "pass"
    raw = json.dumps(kept).encode()
    about = f"Contralbero 0.1.0, depth:engineer, lang:en, sha256:{hashlib.sha256(V12.encode()).hexdigest()}, results:"
    path = tmp_path / "old.pdf"
    path.write_bytes(rewritten(made, {RESULTS: raw}, keywords=about + hashlib.sha256(raw).hexdigest()))
    assert main(["verify", str(path)]) == 1
    out = capsys.readouterr().out
    assert re.search(r"made by 0\.1\.0; \d+ values and verdicts were compared: 2 changed since:", out)
    assert "steps imbalance: pass in the report, computed now" in out


def test_a_report_of_an_older_program_with_a_design_of_schema_1_is_compared_with_it_in_schema_2() -> None:
    """No value differs by that; one that is new since is said to be."""
    raw = (ROOT / "tests" / "data" / "designs_0_1" / "r754ie4_balance_shafts.toml").read_bytes()
    design, middle = solved(raw), "countershaft.shaft.reaction_middle"
    made = render(design.document, design.results, raw, depth="summary")
    kept = json.loads(PdfReader(io.BytesIO(made)).attachments[RESULTS][0])
    del kept["values"][middle]
    results = json.dumps(kept).encode()
    about = f"Contralbero 0.1.0, depth:summary, lang:en, sha256:{hashlib.sha256(raw).hexdigest()}, results:"
    found = verify(rewritten(made, {RESULTS: results}, keywords=about + hashlib.sha256(results).hexdigest()), "old.pdf")
    assert found.verdict is Verdict.NOT_AS_WRITTEN and not found.changed and found.compared > 200
    assert [(one.what, one.was) for one in found.differences] == [(f"values {middle}", NOTHING)]


def test_no_reader_of_pdf_is_loaded(made: bytes, tmp_path: Path) -> None:
    """Nor of signatures, of a file that has some: those are read in a process of their own."""
    path = tmp_path / "r.pdf"
    path.write_bytes(made + b"% more")
    names = loaded(f"from assistant.cli import main; main(['verify', {str(path)!r}])")
    assert "reportlab" in names and not names & {"pypdf", "pyhanko", "pypdfium2", "pikepdf"}


def test_exit_codes_and_words(made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "r.pdf"
    path.write_bytes(made)
    assert main(["verify", str(path)]) == 0
    assert capsys.readouterr().out.splitlines()[-1].startswith("identical: byte for byte")
    raw = PdfReader(io.BytesIO(made)).attachments[NAME][0]
    path.write_bytes(rewritten(made, {NAME: raw.replace(b"rated_speed_rpm = ", b"rated_speed_rpm = 1")}))
    assert main(["verify", str(path)]) == 1
    short = capsys.readouterr().out
    assert (
        "the attachment design.toml is not one that" in short
        and short.splitlines()[-1].startswith("not as written: ")
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
    with pytest.raises(BadInput, match=r"no attachment design\.toml"):
        verify(written(writer), "x.pdf")


def test_results_that_can_not_be_read_are_refused(made: bytes) -> None:
    with pytest.raises(BadInput, match="damaged"):
        verify(rewritten(made, {RESULTS: b"{"}), "x.pdf")


def written(writer: PdfWriter) -> bytes:
    out = io.BytesIO()
    writer.write(out)
    return out.getvalue()


def test_keywords_that_no_report_has_are_refused(made: bytes) -> None:
    about = str(PdfReader(io.BytesIO(made)).metadata.keywords)  # type: ignore[union-attr]
    for wrong in (
        about.replace("depth:engineer", "depth:foo"),
        about.replace("lang:en", "lang:xx"),
        f"Contralbero {VERSION}",
    ):
        with pytest.raises(BadInput, match="no report of this program"):
            verify(rewritten(made, keywords=wrong), "x.pdf")
    found = verify(rewritten(made, keywords=about + ", depth:audit"), "x.pdf")
    assert found.verdict is Verdict.NOT_AS_WRITTEN and not found.differences, "the first counts"


def test_a_file_hidden_beside_the_design_is_not_as_written(made: bytes) -> None:
    """What else such a file holds is looked at as little as its pages."""
    writer = PdfWriter(clone_from=io.BytesIO(made))
    writer.add_attachment("other.toml", b"x = 1")
    found = verify(written(writer), "x.pdf")
    assert found.verdict is Verdict.NOT_AS_WRITTEN and not found.changed


def test_what_a_terminal_would_obey_is_written_out(
    made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "x.pdf"
    path.write_bytes(rewritten(made, {RESULTS: json.dumps({"values": {"x\x1b[2K\ridentical\x1b[8m": 1.0}}).encode()}))
    assert main(["verify", str(path), "--all"]) == 1
    out = capsys.readouterr().out
    assert "\x1b" not in out and "\\u001b[2K" in out and out.splitlines()[-1].startswith("not as written: ")


def test_more_than_results_in_the_results_is_found(made: bytes) -> None:
    kept = json.loads(PdfReader(io.BytesIO(made)).attachments[RESULTS][0])
    raw = json.dumps({**kept, "approved": "by everybody"}).encode()
    about = str(PdfReader(io.BytesIO(made)).metadata.keywords)  # type: ignore[union-attr]
    sums = [hashlib.sha256(one).hexdigest() for one in (PdfReader(io.BytesIO(made)).attachments[RESULTS][0], raw)]
    found = verify(rewritten(made, {RESULTS: raw}, keywords=about.replace(*sums)), "x.pdf")
    assert not found.changed and found.differences[-1] == Difference("approved", "by everybody", NOTHING)


def test_an_encrypted_file_is_refused_by_name(made: bytes) -> None:
    writer = PdfWriter(clone_from=io.BytesIO(made))
    writer.encrypt("secret", algorithm="RC4-128")
    with pytest.raises(BadInput, match="is encrypted"):
        verify(written(writer), "x.pdf")


def test_results_that_are_too_deep_are_refused(made: bytes) -> None:
    with pytest.raises(BadInput, match="damaged"):
        verify(rewritten(made, {RESULTS: b'{"a":' + b"[" * 200_000}), "x.pdf")


@pytest.mark.parametrize(
    "raw", [b"{}", b'{"values": 1, "checks": {}, "steps": {}}', b'{"values": {"engine.stroke": NaN}}']
)
def test_results_of_any_shape_are_others(made: bytes, raw: bytes) -> None:
    found = verify(rewritten(made, {RESULTS: raw}), "x.pdf")
    assert found.changed == (RESULTS,) and len(found.differences) > 100
    assert all(one.was in (NOTHING, "nan") for one in found.differences if one.what.startswith("values "))


@pytest.mark.slow
@pytest.mark.parametrize("seed", ["1", "7"])
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
    assert run.stdout.splitlines()[-1].startswith("identical: byte for byte"), run.stdout


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
