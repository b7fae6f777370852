"""The table of all checks: every check of the program has one row, every row a check, and what a row names is there."""

import ast
import re
from functools import cache
from pathlib import Path

import pytest

from calc.design.model import Design
from calc.design.toml_file import design, read
from calc.sheet.check import KINDS, elements, letters, rule_of, rules
from calc.sheet.quantity import keys
from calc.solve import Results, solve
from calc.studies.shipped import DESIGNS

CALC = Path(__file__).parents[3] / "calc"
ROWS = {rule.id: rule for rule in rules()}
FORM = re.compile(r"[a-z_.BMNW0-9]+")


@cache
def shipped() -> tuple[Results, ...]:
    return tuple(solve(design(read(file))) for file in sorted(DESIGNS.glob("*.toml")))


def test_the_table_is_well_formed():
    assert len(ROWS) == len(rules()) > 150
    for rule in rules():
        assert FORM.fullmatch(rule.id) and rule.why.endswith("."), rule.id
        assert rule.kinds and set(rule.kinds) <= set(KINDS) and rule.cause != rule.id, rule.id


def test_the_limits_of_the_contract_are_limits():
    bearing = "film_edge film_double_load temperature specific_load heat_index clearance_cold transition"
    ids = [f"bearings.B.{name}" for name in bearing.split()]
    ids += [f"countershaft.{name}" for name in ("residual", "slope_front", "slope_rear", "envelope")]
    ids += [
        "gears.M.backlash",
        "gears.M.contact_ratio",
        "gears.W.undercut",
        "gears.W.tip_thickness",
        "gears.M.safety_contact",
    ]
    assert all(ROWS[id].kinds[0] == "limit" for id in [*ids, "gears.W.safety_bending"])


def inputs(cls: type, before: str = "") -> set[str]:
    """All keys of the design file; elements of arrays as *."""
    found = set()
    for key, about in keys(cls).items():
        here = f"{before}.{key}" if before else key
        found.add(here)
        if about.about.table is not None:
            found |= inputs(about.about.table, here + (".*" if about.about.kind == "tables" else ""))
    return found


def test_the_keys_that_move_a_check_are_inputs():
    known = inputs(Design)
    for rule in rules():
        for key in rule.moved_by:
            pattern = re.sub(r"\b(DRIVER|DRIVEN|N|W|#)(?=\.|$)|#", "*", key)
            forms = {pattern.replace("B", place) for place in ("front", "rear")}
            assert forms <= known, (rule.id, key)


@pytest.mark.parametrize("number", range(len(list(DESIGNS.glob("*.toml")))))
def test_every_check_has_the_kind_of_its_row_and_is_on_a_value_that_there_is(number):
    results = shipped()[number]
    values = results.values()
    for check in results.checks():
        rule = rule_of(check.id)
        assert check.kind in rule.kinds and check.cause == rule.cause and check.demand is rule.demand
        if check.limit_id:
            assert values[check.limit_id].shown == pytest.approx(check.limit, rel=1e-12), check.id
        if check.value_id:
            value = values[check.value_id]
            assert (value.shown, value.unit) == (pytest.approx(check.value, rel=1e-12), check.unit), check.id


def templates() -> set[str]:
    """The ids of all checks in the code, as patterns of regular expressions: what an f-string puts in may be
    anything."""
    found = set()
    for file in CALC.rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Name)):
                continue
            id = node.args[0] if node.func.id in ("check", "_least") else None
            if node.func.id == "replace":  # a check made from another one
                id = next((k.value for k in node.keywords if k.arg == "id"), None)
            if id is not None:
                parts = id.values if isinstance(id, ast.JoinedStr) else [id]
                found.add("".join(re.escape(str(p.value)) if isinstance(p, ast.Constant) else ".+" for p in parts))
    return found


def test_every_row_has_a_check_and_every_check_a_row():
    sites = templates() - {".+"}
    assert len(sites) > 100
    ids = {rule.id.replace("M", "a_b").replace("W", "w").replace("N", "n").replace("B", "b") for rule in rules()}
    ids |= {id.rpartition(".")[2] for id in ids}  # a site may make the rest of the id elsewhere
    for site in sites:
        assert any(re.fullmatch(site, id) for id in ids), site
    solved = {c.id for results in shipped() for c in results.checks()}
    for rule in rules():
        id = rule.id.replace("M", "a_b").replace("W", "w").replace("N", "n").replace("B", "b")
        assert any(re.fullmatch(site, id) for site in sites) or any(rule_of(one).why == rule.why for one in solved), (
            rule.id
        )


def test_letters_stand_for_elements():
    assert set("".join(part for rule in rules() for part in rule.id.split(".") if part.isupper())) <= set(elements())
    assert rule_of("gears.rear_front.notch_front").value == "gears.rear_front.notch_parameter_front"
    assert rule_of("gears.rear_front.backlash", 2).moved_by[2] == "gears.meshes.2.tolerance_um"
    assert not any("meshes" in key for key in rule_of("gears.rear_front.backlash").moved_by)
    wheels = ("gears.wheels.rear.span_allowance_um", "gears.wheels.front.span_allowance_um")
    assert rule_of("gears.rear_front.backlash").moved_by[:2] == wheels
    names = {"B": "b", "M": "m", "N": "n", "W": "w", "#": "2", "DRIVER": "d"}
    asked = "x.M.WW_B.root_W|N|BX.W_y.XW|a.#.b_W.c|DRIVER.DRIVERS"
    assert letters().sub(lambda letter: names[letter[0]], asked) == "x.m.WW_B.root_w|n|BX.W_y.XW|a.2.b_W.c|d.DRIVERS"
    with pytest.raises(KeyError, match="has no row"):
        rule_of("gears.rear_front.no_such_check")
