# SPDX-License-Identifier: Apache-2.0
"""The nomenclature: each symbol of a chapter's formulas once, with its meaning, its unit and the first page on which it
stands."""

import re
from importlib import import_module

import pytest

from calc.locale import language
from calc.sheet.expression import Expr, symbol
from calc.sheet.formula import FORMULAS, units
from reports.blocks.nomenclature import BY_NAME, _in_common, _origin, _short, noted
from reports.context import Context
from reports.report import blocks
from reports.report import context_of as whole_context
from reports.typesetting.boxes import BETWEEN, SIGN
from reports.typesetting.equation import spoken
from reports.typesetting.pagination import Block, Formula, TextContent
from reports.typesetting.prose import NOTE, run
from tests.calc.dimension import dimension
from tests.conftest import ROOT
from tests.reports.reading import Solved, pages_of, solved, text_of


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
    assert "MA Tightening torque" in own and "ω Angular speed" in own
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


# --- every symbol of a proof


def leaves_of(tree: Expr) -> set[str]:
    return {tree.name} if tree.head == "symbol" else set().union(*map(leaves_of, tree.args))


def set_symbols(content: Formula) -> set[str]:
    """The symbols on the left and right of a formula, as they are set; π, e and i mean the same everywhere."""
    if (first := content.first) is None:
        return set()
    return ({first.symbol} | (leaves_of(first.formula) if first.formula else set())) - {"π", "e", "i"}


def noted_in(block: Block) -> set[str]:
    """The symbols under whose names the nomenclature leads to a block."""
    return {name.split(SIGN)[2] for name in block.indexed.split(BETWEEN) if name.startswith(SIGN)}


Made = tuple[Context, list[Block]]


@pytest.fixture(scope="module")
def proven(example: Solved) -> Made:
    """The engineer's report as blocks, with the symbols that were noted in making them."""
    return (context := context_of(example, "engineer")), blocks(context)


def nameless(made: list[Block]) -> list[tuple[str, set[str]]]:
    """The formulas of a report with the symbols that stand in them and lead nowhere."""
    found = []
    for block in made:
        if isinstance(block.content, Formula) and (lost := set_symbols(block.content) - noted_in(block)):
            found.append((spoken(block.content.first), lost))  # type: ignore[arg-type]
    return found


def test_every_symbol_of_the_proofs_has_its_meaning(proven: Made) -> None:
    assert nameless(proven[1]) == []
    assert len(proven[0].symbols) > 200


@pytest.mark.slow
@pytest.mark.parametrize("name", ["r753ie4_rolling", "r753ie4_drive_over_speed", "r753ie4_mounting", "twin_drive"])
def test_every_symbol_of_other_designs_has_its_meaning(name: str) -> None:
    made = solved((ROOT / "designs" / f"{name}.toml").read_bytes())
    assert nameless(blocks(context_of(made, "engineer"))) == []


def test_symbols_that_are_quoted_have_their_meaning(proven: Made) -> None:
    """Those of the values that a proof takes from elsewhere."""
    quoted = [block for block in proven[1] if isinstance(block.content, TextContent) and block.indexed]
    assert len(quoted) > 10
    for block in quoted:
        words = block.content.words  # type: ignore[union-attr]
        names = set(re.findall(r"(\S+) = ", words))
        assert names and names <= noted_in(block), words


def test_a_meaning_is_of_what_the_formula_takes(example: Solved) -> None:
    """Every argument of every line has one, and it is of no other quantity of the same letter: it has the dimension
    that its formula asks for."""
    context, count = context_of(example, "engineer"), 0
    for context.chapter, outcome in example.results.outcomes.items():
        for line in (line for line in outcome.lines if not line.formula.shows):
            known, said = units(line.formula), line.formula.meanings
            for name, value in line.arguments.items():
                if name in said:
                    continue
                origin = _origin(context, line.formula.names.get(name) or symbol(name), value)
                assert origin is not None, (line.formula.__name__, name)
                assert dimension(origin[1]) == dimension(known.get(name, "")), (line.formula.__name__, name, origin)
                count += 1
    assert count > 5000


@pytest.mark.slow
@pytest.mark.parametrize("name", ["r753ie4_gamma", "r753ie4_rolling", "r753ie4_drive_over_speed"])
def test_every_symbol_of_an_audit_has_its_meaning(name: str) -> None:
    made = solved((ROOT / "designs" / f"{name}.toml").read_bytes())
    context = whole_context(made.document, made.results, made.raw, depth="audit", lang="en")
    assert nameless(blocks(context)) == []


def test_a_letter_with_several_meanings_stands_with_each_of_them(proven: Made) -> None:
    """Each with its own first page, and with the unit of what it is; none under the meaning of another."""
    known: dict[tuple[str, str], dict[str, str]] = {}
    for entry in proven[0].symbols.values():
        known.setdefault((entry.chapter, entry.name), {})[entry.meaning] = entry.unit
    for place, meanings in {
        ("imbalance", "n"): {"Rated speed": "rpm"},
        ("bearings", "B"): {"bending stiffness of the section": "N·m²"},
        ("bearings", "α_H"): {"Thermal expansion of the seat": "1/K"},
        ("gears", "a_min,F"): {"Smallest centre distance, with the runout of both wheels": "mm"},
        ("gears", "α_T"): {"Thermal expansion of the part": "1/K"},
        ("gears", "Δφ"): {"Free turn of the last wheel by backlash": "°", "Free turn of the first driver": "°"},
    }.items():
        assert known[place] == meanings


def test_what_is_declared_is_a_parameter() -> None:
    declared = [(one, name) for one in FORMULAS.values() for name in one.meanings]
    assert len(declared) > 80
    assert all(name in (*one.parameters, "return") for one, name in declared)
