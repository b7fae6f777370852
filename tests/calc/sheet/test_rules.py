"""Declared checks: each of the kind that it shall be, each made by its declaration, and what it names is there."""

import csv
import re
from functools import cache
from pathlib import Path

import pytest

import calc.measurements.residuals  # noqa: F401  loaded where something was measured
from calc.bearings.kinds import KINDS as BEARINGS
from calc.design.model import Design
from calc.design.toml_file import design, read
from calc.design.upgrade import current
from calc.sheet.check import KINDS, LETTER, RULES, CheckRule
from calc.sheet.quantity import keys
from calc.solve import Results, solve
from calc.studies.fit_results import IDENTIFIED
from tests.conftest import SHIPPED

list(BEARINGS.values()), IDENTIFIED  # what is loaded when it is asked for

REFERENCE = Path(__file__).parents[2] / "reference"
OLD = sorted((REFERENCE / "designs_0_1").glob("*.toml"))
# what the checks shall be: decided check by check before they were declared
SHALL_BE = {row["id"]: row for row in csv.DictReader((REFERENCE / "severities.csv").open(encoding="utf-8"))}
FORM = re.compile(r"[a-z_.BMNWDJRC0-9]+")
INPUTS = re.compile(r"[a-z]+\.inputs\..+")  # what is asked of inputs, not of the engine


@cache
def solved(file: Path) -> Results:
    return solve(design(read(file)))


def twins(id: str) -> str:
    """The id of the declaration that a row of the table stands for."""
    id = re.sub(r"countershaft\.(bolts|further_bolts\.N)\.", "countershaft.J.", id)
    id = re.sub(r"countershaft\.slope_(front|rear)", "countershaft.slope_B", id)
    return re.sub(r"countershaft\.(drain|further_drains\.N)\.", "countershaft.D.", id)


@pytest.mark.parametrize("row", SHALL_BE.values(), ids=list(SHALL_BE))
def test_every_check_is_what_it_shall_be(row: dict[str, str]) -> None:
    rule = RULES.get(twins(row["id"]))
    if row["kind"] == "none":
        assert rule is None
        return
    assert rule is not None
    assert (rule.kind, rule.role) == (row["kind"], row["role"])
    assert (rule.demand, rule.exact) == ("demand" in row["flags"], "exact" in row["flags"])
    assert not row["zero_scale"] or rule.zero


def test_no_check_is_declared_that_nobody_decided_on() -> None:
    known = {twins(id) for id, row in SHALL_BE.items() if row["kind"] != "none"}
    assert {id for id in RULES if not INPUTS.fullmatch(id)} == known


def test_the_declarations_are_well_formed() -> None:
    for rule in RULES.values():
        assert FORM.fullmatch(rule.id) and rule.why.endswith(".") and rule.kind in KINDS, rule.id
        assert rule.cause != rule.id and rule.sense in (">=", ">", "<=", "<", "in"), rule.id
        assert all(factor > 1 and weaker.kind != "method" for weaker, factor in rule.weakens), rule.id


@pytest.mark.parametrize(
    ("id", "pattern", "at", "of"),
    [
        ("bearings.B.film_edge", "bearings.*.film_edge", "front", "bearings.front.film_edge"),
        ("gears.M.notch_W", "gears.*.notch_*", ("crank_idler", "idler"), "gears.crank_idler.notch_idler"),
        ("countershaft.residual", "countershaft.residual", (), "countershaft.residual"),
    ],
)
def test_the_ids_of_a_declaration(id: str, pattern: str, at: str | tuple[str, ...], of: str) -> None:
    assert RULES[id].pattern == pattern and RULES[id].of(at) == of


def inputs(cls: type, before: str = "") -> set[str]:
    """All keys of the design file; elements of arrays as *."""
    known = set()
    for key, about in keys(cls).items():
        here = f"{before}.{key}" if before else key
        known.add(here)
        if about.about.table is not None:
            known |= inputs(about.about.table, here + (".*" if about.about.kind == "tables" else ""))
    return known


def test_the_keys_that_move_a_check_are_inputs() -> None:
    known = inputs(Design)
    for rule in RULES.values():
        for key in rule.moved_by:
            pattern = re.sub(r"\b(DRIVER|DRIVEN|N|W|S|B|#)(?=\.|$)|#", "*", key)
            assert pattern in known, (rule.id, key)


@pytest.mark.parametrize("file", [*SHIPPED, *OLD], ids=lambda file: f"{file.parent.name}/{file.stem}")
def test_every_check_made_is_on_the_values_that_it_names(file: Path) -> None:
    results = solved(file)
    values = results.values()
    checks = list(results.checks())
    assert len({check.id for check in checks}) == len(checks), "an id twice"
    for check in checks:
        assert RULES[check.rule.id] is check.rule and check.name, check.id
        if check.limit_id:
            assert values[check.limit_id].shown == pytest.approx(check.limit, rel=1e-12), check.id
        if check.value_id and check.value == check.value:
            value = values[check.value_id]
            assert (value.shown, value.unit) == (pytest.approx(check.value, rel=1e-12), check.unit), check.id
        assert all(current({}, key) == key for key in check.moved_by), check.id  # none of schema 1
        assert bool(check.missing) >= bool(check.taken) and (not check.missing or check.at_best is not None), check.id


def matches(rule: CheckRule, id: str) -> bool:
    parts = re.sub(LETTER, "@", rule.id)
    return re.fullmatch(re.escape(parts).replace("@", r"[A-Za-z0-9_.-]+?"), id) is not None


def test_an_id_belongs_to_its_declaration() -> None:
    for file in OLD:
        for check in solved(file).checks():
            assert matches(check.rule, solved(file).design.former_id(check.id)), check.id


def test_every_limit_of_nought_has_a_scale() -> None:
    for file in [*SHIPPED, *OLD]:
        for check in solved(file).checks():
            if check.limit == 0 and check.unit != "°C":
                assert check.rule.zero and check.scale > 0, check.id
