"""The loads of the support that are handed to finite elements, and what the other parts of the making are given."""

import cmath
from dataclasses import replace
from types import SimpleNamespace

import pytest

from calc.countershaft.making import parts
from calc.countershaft.making.inputs import ShaftSupport
from calc.countershaft.making.unbalance import permitted
from calc.design.toml_file import design
from tests.calc.countershaft.shafts import (
    ENVELOPE,
    FRONT,
    JOURNALS,
    OMEGA,
    REAR,
    SEATED,
    bearing_rows,
    document,
    outcome,
    result,
    rows,
)

SUPPORT = {"material": "EN AC-43100"}
BOLTS = {
    "thread": "M10",
    "torque_Nm": 45.0,
    "friction": 0.12,
    "head_diameter_mm": 15.0,
    "hole_diameter_mm": 11.0,
    "count": 4,
    "method": "source",
}


def cases(**shaft):
    return [table for table in outcome(**shaft).tables if table.id == "support_loads"]


def test_the_four_cases_of_the_source():
    """Finotti 2013, 4.7 (in chapter 6): 1710.15 N on either bearing, opposite each other, in four directions, and 27
    086 N of each bolt; its shaft leaves 6.8 N of force, so that its two reactions differ."""
    (table,) = cases(support=SUPPORT, bolts=BOLTS)
    front = [complex(*row[2:4]) for row in table.rows]
    rear = [complex(*row[4:6]) for row in table.rows]
    assert (
        [round(cmath.phase(F) * 180 / cmath.pi) % 360 for F in front]
        == [row[1] for row in table.rows]
        == [0, 90, 180, 270]
    )
    assert all(abs(F) == pytest.approx(1710.15, rel=3e-3) and abs(F + other) < 10 for F, other in zip(front, rear))
    assert all(row[6] == pytest.approx(27085.957, abs=1e-3) for row in table.rows)
    assert [row[0] for row in table.rows] == [1, 2, 3, 4]
    F, C = (getattr(result(), name) for name in ("force_vector", "couple_vector"))
    on_rear = -(C + 0.1675 * F) / 0.335
    turned = cmath.exp(-1j * cmath.phase(-(F + on_rear)))
    assert [front[0], rear[0]] == pytest.approx([-(F + on_rear) * turned, on_rear * turned])
    assert "-0.0" not in str(table.rows)


def test_no_cases_without_a_support_and_no_preload_without_bolts():
    assert not cases(bolts=BOLTS)
    assert [len(row) for row in cases(support=SUPPORT)[0].rows] == [6] * 4
    assert not cases(support=SUPPORT, bearings=rows(places=(-167.5, 0.0, 167.5)))


def test_a_shaft_that_presses_on_nothing_has_no_cases():
    shaft = parts.ShaftInputs(name="shaft", material="20CrNi4", bearings=bearing_rows((-0.1675, 0.1675)))
    assert not parts.table(shaft, replace(result(), reactions=(0j, 0j)))
    assert parts.table(shaft, result())


# --- what the parts are given
SIZE = {"mode": "size", **ENVELOPE, "bearings": SEATED}
COST = {
    "pieces_per_year": 100,
    "alternatives": [
        {"material": "20CrNi4", "tooling_EUR": 1000.0, "piece_EUR": 20.0},
        {"material": "steel", "tooling_EUR": 2000.0, "piece_EUR": 10.0},
    ],
}
SCATTER = {"mass_g": 1.0, "radius_mm": 0.001, "angle_deg": 0.001, "z_mm": 0.001, "shafts": 100}
HOLES = {"diameter_mm": 14.0, "depth_mm": 20.0, "count": 4}


@pytest.mark.parametrize("shaft, compared", [({}, False), ({"cost": COST}, True), (SIZE, True)])
def test_materials_are_compared_where_there_is_a_cost_or_a_shaft_to_size(shaft, compared):
    assert (result(**shaft).alternative is not None) is compared


@pytest.mark.parametrize("order", [1, -1])
def test_what_is_given_of_the_largest_seat(order, monkeypatch):
    given = []
    monkeypatch.setattr(parts, "compared", lambda *args: given.append(args[-1] and vars(args[-1])))
    made = result(cost=COST, bearings=rows(JOURNALS[::order]))
    load = made.loads["rear"] if order == 1 else made.loads["front"]
    middle = [JOURNALS[0], {"diameter_mm": 90.0, "length_mm": 25.0}, JOURNALS[1]]
    result(cost=COST, bearings=rows(middle[::order], (-167.5, 0.0, 167.5)))
    assert given.pop()["diameter"] == 81e-3, "an outer one"
    result(cost=COST)
    assert given == [{"diameter": 81e-3, "length": 26.5e-3, "load": load}, None]


def test_a_support_in_the_middle_has_no_plane_of_its_own(monkeypatch):
    """The outer ones are those of balancing and of the scatter, which asks for what balances the engine."""
    targets = []
    scattered = parts.scatter.scattered
    monkeypatch.setattr(parts.scatter, "scattered", lambda *args: targets.append(args[3]) or scattered(*args))
    shaft = design(document(**SIZE, scatter=SCATTER)).countershaft
    shaft = replace(shaft, bearings=bearing_rows((-0.1675, 0.01, 0.2)))
    todo = SimpleNamespace(C=300 - 500j, F=20 + 10j, couple=abs(300 - 500j), may_leave=28.0)
    step, whole = parts.ShaftStep(shaft, todo, {}, (), OMEGA), result(**SIZE)
    wanted = permitted("G6.3", whole.mass, OMEGA, whole.centre_of_gravity, -0.1675, 0.2, todo.couple)
    assert vars(parts._permitted(step, whole)) == vars(wanted)
    parts._scatter(step, shaft.masses, replace(whole, tolerance=wanted, couple_against=3.0))
    (target,) = targets
    assert (target.z_f, target.z_r, target.couple, target.force) == (-0.1675, 0.2, -300 + 500j, -20 - 10j)
    assert (target.permitted_front, target.permitted_rear, target.couple_left) == (
        wanted.residual_unbalance_permitted_front,
        wanted.residual_unbalance_permitted_rear,
        3.0,
    )


def test_without_the_mass_of_the_whole_shaft_nothing_is_permitted():
    made = outcome(scatter=SCATTER)
    assert made.result.tolerance is made.result.scatter is None
    assert any("needs the mass of the whole shaft" in note for note in made.notes)
    step, whole = parts.ShaftStep(None, None, {}, (), OMEGA), result(**SIZE)
    for name in ("mass", "centre_of_gravity"):
        assert parts._permitted(step, replace(whole, **{name: None})) is None


@pytest.mark.parametrize(
    "shaft, words",
    [
        (SIZE, ()),
        ({**SIZE, "holes": {**HOLES, "count": 5}}, ("5 holes on 2 masses",)),
        ({"masses": [FRONT, REAR]}, ("give the outer radius",)),
        ({"outer_radius_mm": 43.0}, ("give the core radius", "the outline has none")),
        ({**SIZE, "masses": [FRONT]}, ()),
    ],
)
def test_what_of_the_holes_is_not_judged_is_said(shaft, words):
    notes = [note for note in outcome(**{"holes": HOLES, **shaft}).notes if "Calibration holes" in note]
    assert len(notes) == len(words) and all(word in note for word, note in zip(words, notes))


def test_what_the_holes_may_take_is_what_is_beyond_the_couple_of_the_engine():
    checks = {c.id: c for c in outcome(**SIZE, overdesign_percent=1.4, holes=HOLES).checks}
    assert checks["countershaft.holes.range"].value == pytest.approx(0.014 * 572.93196)


@pytest.mark.parametrize(
    "support, journals, wall",
    [
        ({"wall": 6e-3, "wall_at_seat": 81e-3}, ((59.5e-3, 0.0), (85e-3, 0.0)), 4e-3),
        ({"wall": 6e-3, "wall_at_seat": 81e-3}, ((85e-3, 0.0), (59.5e-3, 0.0)), 4e-3),
        ({"wall": 6e-3, "wall_at_seat": 81e-3}, (), 6e-3),
        ({"wall": 6e-3}, ((85e-3, 0.0),), 6e-3),
        ({"wall_at_seat": 81e-3}, ((85e-3, 0.0),), None),
    ],
)
def test_the_wall_beside_the_largest_seat(support, journals, wall):
    shaft = parts.ShaftInputs(name="shaft", material="", support=ShaftSupport(material="", **support))
    assert parts._with_wall(shaft, journals).support.wall == pytest.approx(wall)
    bare = replace(shaft, support=None)
    assert parts._with_wall(bare, journals) is bare


def test_drains_that_are_not_asked_for_are_none():
    assert result().further_drains is None and result().drain is None
