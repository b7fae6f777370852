# SPDX-License-Identifier: Apache-2.0
"""Document control: what the title block is made of, from [document] and from the keys that old files have at their
top."""

import tomllib

import pytest

from calc.design.other_tables import DocumentControl
from calc.design.toml_file import design, parse
from calc.sheet.errors import BadInput
from calc.studies.compare import inputs
from calc.studies.shipped import DESIGNS

WHOLE = (DESIGNS / "timing_pair.toml").read_text(encoding="utf-8")


def control(top: str = "", end: str = "") -> DocumentControl:
    return design(parse(f"{top}\n{WHOLE}\n{end}".encode(), "d.toml")).control


def test_a_date_is_a_date_of_toml_or_its_text() -> None:
    made = control(
        end='[document]\nnumber = "C-1"\nprepared = { name = "A", date = 2026-03-14 }\nchecked = { date = '
        '"2026-03-15" }'
    )
    assert made.prepared is not None and made.checked is not None and made.approved is not None
    assert (made.number, made.prepared.date, made.checked.date, made.approved.name) == (
        "C-1",
        "2026-03-14",
        "2026-03-15",
        "",
    )


def test_what_old_files_say_at_their_top_goes_where_it_belongs() -> None:
    made = control('author = "A"\nchecker = "C"\nrevision = "B"\ndate = "1 May 2024"')
    assert made.prepared is not None and made.checked is not None
    assert (made.prepared.name, made.prepared.date, made.checked.name, made.revision) == ("A", "1 May 2024", "C", "B")
    assert control("date = 2024-05-01").prepared == control(end="[document.prepared]\ndate = 2024-05-01").prepared


@pytest.mark.parametrize(
    ("line", "named", "words"),
    [
        ("prepared = { date = 2026-03-14T10:00:00 }", "document.prepared.date", "year-month-day"),
        ('prepared = { date = "2026-02-30" }', "document.prepared.date", "year-month-day"),
        ('approved = { date = "14.3.2026" }', "document.approved.date", "year-month-day"),
        ('changes = [ { revision = "A", what = "x", date = 3 } ]', "document.changes.0.date", "year-month-day"),
        ('logo = "../logo.png"', "document.logo", "bare name"),
        ('logo = "C:logo.png"', "document.logo", "bare name"),
        ('logo = "logo.svg"', "document.logo", "PNG"),
        ('prepared = { name = "B" }', "author", "document.prepared.name"),
    ],
)
def test_what_is_refused_is_named_with_what_is_allowed(line: str, named: str, words: str) -> None:
    with pytest.raises(BadInput) as bad:
        control('author = "A"', f"[document]\n{line}")
    assert [error.key for error in bad.value.errors] == [named] and words in str(bad.value)


def test_two_notations_of_one_date_do_not_differ() -> None:
    a, b = (tomllib.loads(f"document.prepared.date = {date}") for date in ("2026-03-14", '"2026-03-14"'))
    assert not inputs(a, b)
