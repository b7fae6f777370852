# SPDX-License-Identifier: Apache-2.0
"""`contralbero report --format docx`: which file is written, and what is missing for it."""

import zipfile
from importlib.util import find_spec
from pathlib import Path

import pytest

from assistant.cli import main
from tests.conftest import DESIGNS
from tests.test_imports import loaded

PAIR = DESIGNS / "timing_pair.toml"


def said(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, str, str]:
    code = main(["report", *map(str, arguments)])
    out, err = capsys.readouterr()
    return code, out, err


@pytest.mark.skipif(find_spec("docx") is None or find_spec("pypdfium2") is None, reason="needs the extra docx")
def test_it_is_written_by_its_ending_or_when_asked_for(tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert said(capsys, PAIR, "-o", "a.docx", "--depth", "summary")[0] == 0
    code, out, _ = said(capsys, PAIR, "--format", "docx", "--depth", "summary")
    assert code == 0 and out.endswith("timing_pair.docx\n")
    for name in ("a.docx", "timing_pair.docx"):
        assert "word/document.xml" in zipfile.ZipFile(name).namelist()


def test_without_the_extra_it_says_what_to_install(tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.setattr("assistant.extras.find_spec", lambda name: None)
    target = tmp_path / "a.docx"
    code, out, err = said(capsys, PAIR, "-o", target)
    assert code == 2 and out == "" and not target.exists()
    assert "--format docx: needs the extra `docx`: pip install 'contralbero[docx]'" in err


def test_what_does_not_go_together_is_refused(tmp_path: Path, capsys) -> None:
    code, _, err = said(capsys, PAIR, "-o", tmp_path / "a.pdf", "--format", "docx")
    assert code == 2 and "ends in .pdf, but --format docx writes .docx" in err
    code, _, err = said(capsys, PAIR, "--format", "docx", "--depth", "audit")
    assert code == 2 and "is written as a PDF only" in err


@pytest.mark.slow
def test_the_pdf_needs_none_of_it(tmp_path: Path) -> None:
    names = loaded(
        f"from assistant.cli import main; "
        f"main({['report', str(PAIR), '--depth', 'summary', '-o', str(tmp_path / 'a.pdf')]!r})"
    )
    assert "reportlab" in names and not names & {"docx", "pypdfium2", "lxml"}
