"""The shaft of Finotti 2013, Table 4.1, and what must hold for any shaft."""

import math

import pytest

from calc.design.toml_file import design
from calc.solve import solve


def shaft(document, **changes):
    for key, value in changes.items():
        document = document.with_value(key, value)
    return solve(design(document)).outcomes["countershaft"]


def test_table_4_1(gamma):
    """289.375 + 283.547 = 572.921 N·m at +30°; static difference 91.8 g·mm, 6.81 N."""
    r = shaft(gamma).result
    assert r.couple == pytest.approx(572.921, abs=5e-4)
    assert math.degrees(r.couple_phase) == pytest.approx(30)
    assert r.static_unbalance * 1e6 == pytest.approx(91.8, abs=0.05)
    assert r.force == pytest.approx(6.81, abs=5e-3)
    assert r.sums.residual_order_1_couple == pytest.approx(0.011, abs=5e-4)
    assert r.sums.residual_order_1_force == pytest.approx(6.81, abs=5e-3)


def test_reactions_of_a_pure_couple(gamma):
    """±C/l: 572.9/0.335 = 1710.15 N in the source."""
    same = gamma.with_value("shafts.shaft.masses.front.mass_kg", 2.688).with_value(
        "shafts.shaft.masses.front.radius_mm", 18.731
    )
    r = shaft(same).result
    assert r.force == pytest.approx(0, abs=1e-6)
    assert r.loads_by_levers["front"] == pytest.approx(r.couple / 0.335)
    assert r.loads_by_levers["rear"] == pytest.approx(r.loads_by_levers["front"])


def test_one_degree_of_mistiming_leaves_ten_newton_metres(gamma):
    turned = gamma.with_value("shafts.shaft.masses.front.angle_deg", 211.0).with_value(
        "shafts.shaft.masses.rear.angle_deg", 31.0
    )
    assert shaft(turned).result.sums.residual_order_1_couple == pytest.approx(10.0, abs=0.05)


def test_a_shaft_without_mass_changes_nothing(gamma):
    bare = gamma.with_value("shafts.shaft.masses.front.mass_kg", 0.0).with_value(
        "shafts.shaft.masses.rear.mass_kg", 0.0
    )
    outcome = shaft(bare)
    assert outcome.result.sums.residual_order_1_couple == pytest.approx(572.932, abs=5e-4)
    assert outcome.verdict == "fail"


def test_a_shaft_without_mass_leaves_bearings_without_a_film(gamma):
    bare = gamma.with_value("shafts.shaft.masses.front.mass_kg", 0.0).with_value(
        "shafts.shaft.masses.rear.mass_kg", 0.0
    )
    results = solve(design(bare))
    assert results.outcomes["bearings"].state == "no_solution"
    assert "no load" in results.outcomes["bearings"].reason


def test_a_shaft_out_of_static_balance_fails(gamma):
    outcome = shaft(gamma.with_value("shafts.shaft.masses.front.radius_mm", 30.0))
    assert {c.id: c.verdict for c in outcome.checks}["countershaft.residual_force"] == "fail"


def test_the_slopes_that_are_given_are_judged_where_the_outline_is_not_known(gamma):
    bare = gamma.with_value("shafts.shaft.core_radius_mm", None)
    outcome = shaft(bare)
    assert {c.id: c.verdict for c in outcome.checks}["countershaft.slope_front"] == "pass"
    assert outcome.result.mass is None and any("core_radius_mm" in note for note in outcome.notes)
    outcome = shaft(bare.with_value("shafts.shaft.bearings.rear.slope_mrad", 0.3))
    assert {c.id: c.verdict for c in outcome.checks}["countershaft.slope_rear"] == "warn"


def test_the_figure_of_the_loaded_shaft_says_what_the_tables_say(gamma):
    """The bent shaft throws its mass outwards and loads its bearings a little more than statics; figure and table read
    one number."""
    outcome = shaft(gamma)
    (figure,) = (curve for curve in outcome.curves if curve.id == "loads")
    held = sorted(abs(load.size) for load in figure.loads if load.held)
    assert held == pytest.approx(sorted(outcome.result.loads.values()), rel=1e-12)
