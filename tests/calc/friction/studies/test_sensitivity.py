# SPDX-License-Identifier: Apache-2.0
"""What the open constants do: every end is the design solved with that constant, the widest comes first."""

import pytest

from calc.friction.mesh.mixed import LOAD_SHARES
from calc.friction.studies import sensitivity
from calc.solve import solve
from tests.calc.friction.documents import changed, design, gamma, pair

LOADED = changed(pair(), gears={"power_kW": 20.0})  # mixed friction: every constant counts
OWN_OIL = {"name": "own", "nu40_mm2_s": 90.0, "nu100_mm2_s": 14.0, "rho15_kgm3": 865.0, "base": "mineral"}


def friction_of(document):
    return solve(design(document)).outcomes["friction"]


def rows(document):
    """Constant → (low end in words, high end, power at each)."""
    found = next(t for t in friction_of(document).whole.tables if t.id == "tornado")
    return {row[0]: row[1:] for row in found.rows}


def loss(document, **friction):
    return friction_of(changed(document, friction=friction)).result.total_loss


# --- the ends
@pytest.mark.parametrize("document", [LOADED, gamma()], ids=["pair", "gamma"])
@pytest.mark.parametrize(
    "name, low, high",
    [
        ("friction of the solids μ_s", {"solid_friction": 0.065}, {"solid_friction": 0.1}),
        ("flank roughness Ra", {"flank_roughness_um": 0.56}, {"flank_roughness_um": 1.04}),
        ("density of the oil mist", {"mist_density_kgm3": 1.2}, {"mist_density_kgm3": 48.0}),
        ("viscosity under pressure", {"pressure_law": "roelands"}, {"pressure_law": "barus"}),
        ("film", {"film": "judged"}, {"film": "source"}),
    ],
)
def test_an_end_is_the_design_with_that_constant(document, name, low, high):
    _, _, at_low, at_high, *_ = rows(document)[name]
    assert at_low == pytest.approx(loss(document, **low), rel=1e-8)
    assert at_high == pytest.approx(loss(document, **high), rel=1e-8)


@pytest.mark.parametrize("document, T", [(LOADED, 40.0), (gamma(), 120.0)], ids=["pair", "gamma"])
def test_the_ends_of_the_temperature_of_the_teeth(document, T):
    _, _, at_low, at_high, *_ = rows(document)["temperature of the teeth"]
    assert (at_low, at_high) == pytest.approx(
        (loss(document, bulk_temperature_C=T), loss(document, bulk_temperature_C=T + 10)), rel=1e-8
    )


def test_the_ends_of_the_limiting_shear():
    """By an oil of the design's own."""

    def with_shear(**more):
        return changed(LOADED, oil=[{**OWN_OIL, **more}], friction={"oil": "own"})

    _, _, at_low, at_high, *_ = rows(with_shear(limiting_shear=0.05))["limiting shear Λ"]
    assert at_low == pytest.approx(friction_of(with_shear(limiting_shear=0.03)).result.total_loss, rel=1e-8)
    assert at_high == pytest.approx(friction_of(with_shear(limiting_shear=0.07)).result.total_loss, rel=1e-8)


def test_the_ends_of_the_pressure_viscosity():
    def with_alpha(alpha):
        return changed(LOADED, oil=[{**OWN_OIL, "pressure_viscosity_40_1_GPa": alpha}], friction={"oil": "own"})

    _, _, at_low, at_high, *_ = rows(with_alpha(20.0))["pressure-viscosity α"]
    assert at_low == pytest.approx(friction_of(with_alpha(16.0)).result.total_loss, rel=1e-8)
    assert at_high == pytest.approx(friction_of(with_alpha(24.0)).result.total_loss, rel=1e-8)


def test_the_ends_of_a_friction_that_is_given():
    _, _, at_low, at_high, *_ = rows(changed(LOADED, friction={"solid_friction": 0.12}))["friction of the solids μ_s"]
    assert (at_low, at_high) == pytest.approx(
        (loss(LOADED, solid_friction=0.096), loss(LOADED, solid_friction=0.144)), rel=1e-8
    )


@pytest.mark.parametrize("document", [LOADED, gamma()], ids=["pair", "gamma"])
def test_the_load_shares_that_cost_least_and_most(document):
    low, high, at_low, at_high, *_ = rows(document)["load share of the roughness"]
    found = {str(law.title): loss(document, load_share=name) for name, law in LOAD_SHARES.items()}
    assert (at_low, at_high) == pytest.approx((min(found.values()), max(found.values())), rel=1e-8)
    assert (found[str(low)], found[str(high)]) == pytest.approx((at_low, at_high), rel=1e-8)


def test_the_load_sharing_of_a_spur_pair_only():
    _, _, at_low, at_high, *_ = rows(LOADED)["load sharing of two pairs"]
    assert (at_low, at_high) == pytest.approx((loss(LOADED), loss(LOADED, load_sharing="smooth")), rel=1e-8)
    assert "load sharing of two pairs" not in rows(gamma())


def test_without_rolling_nothing_is_left_of_it():
    """One end counts the sliding of every mesh alone."""
    outcome = friction_of(pair())
    _, _, at_low, at_high, *_ = rows(pair())["rolling of the rigid film"]
    rolling = sum(mesh.judged.rolling_loss for mesh in outcome.result.meshes.values())
    assert (at_low, at_high) == pytest.approx(
        (outcome.result.total_loss - rolling, outcome.result.total_loss), rel=1e-9
    )


# --- their order and range
@pytest.mark.parametrize("document", [LOADED, gamma(), pair()], ids=["loaded", "gamma", "pair"])
def test_the_nominal_lies_inside_and_the_widest_is_first(document):
    nominal = friction_of(document).result.total_loss
    found = rows(document)
    spans = [row[4] for row in found.values()]
    assert spans == sorted(spans, reverse=True)
    for name, (low, high, at_low, at_high, span, why) in found.items():
        assert low and high and why, name
        if name == "density of the oil mist" or "law" in why or "film" in name:
            continue
        assert min(at_low, at_high) - 1e-8 <= nominal <= max(at_low, at_high) + 1e-8, name
        assert span == pytest.approx(max(at_low, at_high, nominal) - min(at_low, at_high, nominal), abs=1e-9)


@pytest.mark.parametrize(
    "said, gone",
    [
        ({"bulk_temperature_C": 60.0}, "temperature of the teeth"),
        ({"bulk": "estimated"}, "temperature of the teeth"),
        ({"film": "source"}, "rolling of the rigid film"),
    ],
)
def test_what_is_no_open_constant_of_a_design_is_left_out(said, gone):
    assert gone in rows(LOADED)
    found = rows(changed(LOADED, friction=said))
    assert gone not in found and len(found) >= len(rows(LOADED)) - 2


def test_thin_mist_goes_down_to_air_and_no_further():
    low, _, at_low, *_ = rows(changed(LOADED, friction={"mist_density_kgm3": 0.6}))["density of the oil mist"]
    assert low == "0.6 kg/m³"
    assert at_low == pytest.approx(loss(LOADED, mist_density_kgm3=0.6), rel=1e-9)


def test_the_bars_are_the_table():
    outcome = friction_of(LOADED)
    curve = next(c for c in outcome.whole.curves if c.id == "open_constants")
    table = next(t for t in outcome.whole.tables if t.id == "tornado")
    assert curve.bars and curve.names == tuple(row[0] for row in table.rows)
    nominal = outcome.result.total_loss
    for i, row in enumerate(table.rows):
        assert [float(s.y[i]) for s in curve.series] == pytest.approx([row[3] - nominal, row[4] - nominal], abs=1e-9)


def test_a_law_without_solution_is_left_out_and_an_end_without_counts_nothing():
    swing = sensitivity.Swing("x", "X", "a", "b", None, 12.0, "why")
    assert swing.span(10.0) == 2.0
    curve, table = sensitivity.tornado((swing,), 10.0)
    assert [float(s.y[0]) for s in curve.series] == [0.0, 2.0]
    assert table.rows[0][3:6] == (None, 12.0, 2.0)
