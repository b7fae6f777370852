# SPDX-License-Identifier: Apache-2.0
"""The nomenclature: each symbol of a chapter's formulas once, with its meaning, its unit and the first page on which it
stands."""

import re
from importlib import import_module

from calc.locale import language
from calc.sheet.formula import FORMULAS
from reports.blocks.nomenclature import BY_NAME, _in_common, _short, noted
from reports.context import Context
from reports.report import blocks
from reports.typesetting.boxes import SIGN
from reports.typesetting.prose import NOTE, run
from tests.conftest import ROOT
from tests.reports.reading import Solved, pages_of, text_of


def part(pdf: bytes) -> str:
    """The nomenclature as text."""
    read = text_of(pdf)
    return read[read.index("Symbol, meaning, unit and first page") : read.rindex("Drawing sheet")]


def context_of(example: Solved, depth: str) -> Context:
    return Context(example.document, example.results, "0" * 64, depth, language("en"))


def test_symbols_stand_with_meaning_unit_and_page(engineer: bytes) -> None:
    for meaning, unit in (
        ("Specific load", "MPa"),
        ("Temperature of the wheels", "°C"),
        ("Safety against tooth breakage", ""),
    ):
        assert re.search(rf"{meaning}\s+{unit}\s*\d+", part(engineer)), meaning


def test_the_first_page_holds_the_symbol(engineer: bytes) -> None:
    """Every page named is one of the report before the nomenclature."""
    rows, read = part(engineer), pages_of(engineer)
    start = next(n for n, page in enumerate(read, 1) if "Symbol, meaning, unit and first page" in page)
    # a line of a meaning may end with "at 40" (°C)
    named = [int(number) for number in re.findall(r"(?<!of)(?<!at) (\d+)$", rows, re.M)]
    assert len(named) > 60 and max(named) <= start and min(named) >= 2


def test_no_symbol_stands_twice_in_a_chapter(example: Solved) -> None:
    context = context_of(example, "engineer")
    made = blocks(context)
    assert len(context.symbols) > 150
    names = [one for block in made for one in block.indexed.split("\n") if one.startswith(SIGN)]
    assert {one.indexed for one in context.symbols.values()} == set(names), "each symbol has its page"


def test_tables_give_their_symbols_to_the_audit_only(example: Solved) -> None:
    for depth, count in (("engineer", 0), ("audit", 1)):
        context = context_of(example, depth)
        context.chapter = "gears"
        noted(context, "z", "Teeth", "")
        assert len(context.symbols) == count


def test_a_long_meaning_ends_at_a_mark() -> None:
    long = "reciprocating force as two turning vectors, here for any order, throws and banks"
    assert _short(long) == "reciprocating force as two turning vectors"
    assert run(_short(long), NOTE).width < run(long, NOTE).width and _short("mean temperature") == "mean temperature"


def test_every_formula_says_what_it_gives() -> None:
    """By its source, or in a word of its own, which is one that is needed."""
    for path in sorted((ROOT / "calc").rglob("*.py")):
        if (
            "@formula" in (source := path.read_text(encoding="utf-8"))
            and path.parent.name != "sheet"
            and "__main__" not in source
        ):
            import_module(".".join(path.relative_to(ROOT).with_suffix("").parts))
    silent = {
        one.__name__ for name, one in FORMULAS.items() if name.startswith("calc.") and ": " not in str(one.source)
    }
    assert silent == set(BY_NAME)


def test_an_input_is_called_by_its_own_name_and_what_is_made_of_it_is_not(engineer: bytes) -> None:
    """M_A is not the torque at the gear, z no place of a bearing; the tolerance of a diameter is no diameter."""
    read = text_of(engineer)
    own = read[read.rindex("Nomenclature") :]
    assert "MA Tightening torque" in own and "z Position" in own and "ω Angular speed" in own
    assert not re.search(r"T[JS] Journal diameter", own)


def test_what_is_of_each_wheel_is_not_called_that_of_the_first() -> None:
    """Unless the names differ in more than the part."""
    wheel = "gears.crank_central.form_factor_central"
    assert _in_common("Form factor of crank", "Form factor of central", wheel) == "Form factor"
    assert (
        _in_common("Nominal root stress of crank, K = 1", "Nominal root stress of central, K = 1", wheel)
        == "Nominal root stress"
    )
    for one, other in (
        ("Safety against pitting, on stress", "Safety against breakage"),
        ("Its limit, one pair carries all",) * 2,
    ):
        assert _in_common(one, other, wheel) == one
