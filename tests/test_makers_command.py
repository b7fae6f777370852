"""`contralbero makers`: the journals that makers print, and of one engine all of its sheet with its address."""

import json

import pytest

from assistant.cli import main
from calc.library.makers import maker_sheets


def test_all_journals_a_row_each(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["makers"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 118
    assert all(any(line.startswith(f"  {name} ") for line in lines) for name in maker_sheets())
    (row,) = (line for line in lines if line.startswith("  Westerbeke 65A"))
    assert row.split() == ["Westerbeke", "65A", "2", "threaded", "50.93", "70–159", "2.25"]


def test_all_of_one_sheet_with_its_whole_address(capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("Kawasaki EN500", "en500"):
        assert main(["makers", name]) == 0
        out = capsys.readouterr().out
        sheet = maker_sheets()["Kawasaki EN500"]
        assert f"\n{sheet.title}\n{sheet.address}\n" in out and "not opened again" in out
        words = " ".join(out.split())
        for expected in (
            "27.987–27.993, 27.994–28",
            "31.008–31.016, 31.017–31.024",
            "Clearance, worn to 0.09 mm",
            "27.96",
            "0.05",
        ):
            assert expected in words, expected


def test_a_sheet_without_a_journal_says_what_it_has(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["makers", "5S-FE"]) == 0
    out = capsys.readouterr().out
    assert "0.060-0.100 (with tool)" in out and ": journals" not in out


def test_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["makers", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["schema"] == 1 and list(found["tables"]) == ["makers"]
    assert list(dict.fromkeys(row[0] for row in found["tables"]["makers"]["rows"])) == list(maker_sheets())
    assert main(["makers", "ER-6n", "--json"]) == 0
    one = json.loads(capsys.readouterr().out)
    assert one["engine"] == "Kawasaki ER-6n" and one["address"].startswith("manualslib.com/")
    assert set(one["tables"]) == {"maker", "maker_journals"}


@pytest.mark.parametrize(
    ("word", "words"),
    [("kawasaki", 'may be "Kawasaki ER-6n", "Kawasaki EN500"'), ("Trabant", "is not known"), ("", "may be")],
)
def test_a_word_of_several_engines_or_of_none_is_said(
    word: str, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["makers", word]) == 2
    told = capsys.readouterr()
    assert told.out == "" and told.err.startswith("contralbero makers: ") and words in told.err
