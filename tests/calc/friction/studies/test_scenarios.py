# SPDX-License-Identifier: Apache-2.0
"""Scenarios: each is the design solved with its own words, those of the friction thesis have their recorded values."""

import numpy as np
import pytest

from calc.design.toml_file import read
from calc.sheet.errors import BadInput
from calc.solve import solve
from tests.calc.friction.documents import DESIGNS, changed, design, gamma, pair
from tests.calc.friction.pairs import recorded

RECORDED = recorded("friction_spur_pair.json")
SUMMARY = {(row["oil"], row["load_sharing"]): row for row in RECORDED["at_40_C_and_100_W"]}
THESIS = "friction thesis "


def friction_of(document):
    return solve(design(document)).outcomes["friction"]


def alone(document, **said):
    """The scenario "s" of the document, which says this."""
    return friction_of(changed(document, friction={"scenarios": [{"name": "s", **said}]})).result.scenarios["s"]


def with_words(document, oil=None, oil_temperature_C=None, **said):
    """The design itself with a scenario's words.  Oil and temperature that come from the bearings are changed there
    too."""
    own = {
        **said,
        **({"oil": oil} if oil else {}),
        **({"oil_temperature_C": oil_temperature_C} if oil_temperature_C else {}),
    }
    if "bearings" not in document.data:
        return changed(document, friction=own)
    there = {
        **({"oil": oil} if oil else {}),
        **({"supply_temperature_C": oil_temperature_C} if oil_temperature_C else {}),
    }
    return changed(document, friction=own, bearings=there)


# --- the same train
@pytest.mark.parametrize("document", [gamma(), pair()], ids=["gamma", "pair"])
@pytest.mark.parametrize(
    "said",
    [
        {},
        {"oil": "SAE 30"},
        {"oil_temperature_C": 85.0},
        {"load_sharing": "smooth"},
        {"flank_roughness_um": [0.3, 0.5]},
        {"oil": "0W-20", "oil_temperature_C": 100.0, "flank_roughness_um": 1.2, "load_sharing": "smooth"},
    ],
)
def test_a_scenario_is_the_design_with_its_words(document, said):
    scenario = alone(document, **said)
    expected = friction_of(with_words(document, **said)).result
    assert scenario.total_loss == pytest.approx(expected.total_loss, rel=2e-9)
    assert scenario.crank_torque == pytest.approx(expected.crank_torque, rel=2e-9)
    assert scenario.mesh_loss == pytest.approx(expected.mesh_loss, rel=2e-9)
    assert scenario.bearing_loss == (
        None if expected.bearing_loss is None else pytest.approx(expected.bearing_loss, rel=2e-9)
    )
    assert scenario.oil_viscosity == expected.oil_viscosity
    for key, mesh in expected.meshes.items():
        ours = scenario.meshes[key]
        for name in ("loss", "film_min", "lambda_min", "temperature_max", "friction_mean", "pressure_max"):
            assert getattr(ours.judged, name) == pytest.approx(getattr(mesh.judged, name), rel=2e-9), name
            assert getattr(ours.source, name) == pytest.approx(getattr(mesh.source, name), rel=2e-9), name


def test_teeth_with_an_oil_of_their_own_leave_the_journals_theirs():
    """A scenario's oil and temperature are then those of the teeth alone."""
    own = changed(gamma(), friction={"oil": "SAE 30", "oil_temperature_C": 100.0})
    for said in ({"oil": "0W-20"}, {"oil_temperature_C": 70.0}):
        scenario = alone(own, **said)
        expected = friction_of(changed(own, friction=said)).result
        assert scenario.total_loss == pytest.approx(expected.total_loss, rel=2e-9)
        assert scenario.bearing_loss == pytest.approx(friction_of(own).result.bearing_loss, rel=1e-3)


def test_a_scenario_of_another_power():
    assert alone(pair(), power_kW=5.0).total_loss == pytest.approx(
        friction_of(changed(pair(), gears={"power_kW": 5.0})).result.total_loss, rel=1e-9
    )


def test_its_own_temperature_counts_before_a_measured_bulk():
    measured = changed(pair(), friction={"bulk_temperature_C": 70.0})
    kept, own = alone(measured, oil="SAE 30"), alone(measured, oil_temperature_C=50.0)
    expected = friction_of(changed(measured, friction={"oil": "SAE 30"})).result
    assert kept.oil_viscosity == expected.oil_viscosity
    assert own.oil_viscosity == friction_of(changed(pair(), friction={"oil_temperature_C": 50.0})).result.oil_viscosity


def test_the_design_itself_is_untouched():
    with_them = friction_of(changed(pair(), friction={"scenarios": [{"name": "hot", "oil_temperature_C": 100.0}]}))
    assert with_them.result.total_loss == friction_of(pair()).result.total_loss
    assert with_them.result.scenarios["hot"].total_loss != with_them.result.total_loss


# --- what is wrong with one
def test_an_unknown_oil_is_an_error_with_its_place():
    with pytest.raises(BadInput, match=r'friction\.scenarios\.0\.oil: "SAE 31"') as caught:
        design(changed(pair(), friction={"scenarios": [{"name": "thick", "oil": "SAE 31"}]}))
    assert caught.value.place.endswith("timing_pair.toml") and caught.value.errors[0].line > 0


@pytest.mark.parametrize(
    "said, key",
    [
        ({"oil_temperature_C": 900.0}, "oil_temperature_C"),
        ({"flank_roughness_um": 0.0}, "flank_roughness_um"),
        ({"power_kW": -1.0}, "power_kW"),
        ({"load_sharing": "half"}, "load_sharing"),
        ({"speed": 1.0}, "speed"),
    ],
)
def test_other_mistakes_have_theirs(said, key):
    with pytest.raises(BadInput, match=rf"friction\.scenarios\.0\.{key}"):
        design(changed(pair(), friction={"scenarios": [{"name": "x", **said}]}))


def test_two_of_one_name_are_refused():
    with pytest.raises(BadInput, match=r"friction\.scenarios\.1\.name"):
        design(changed(pair(), friction={"scenarios": [{"name": "x"}, {"name": "x"}]}))


def test_a_scenario_without_solution_is_named():
    outcome = friction_of(changed(pair(), friction={"scenarios": [{"name": "much", "power_kW": 1e5}]}))
    assert outcome.state == "no_solution" and outcome.reason.startswith("scenario much: ")


# --- the three of the friction thesis
def thesis(name):
    outcome = friction_of(read(DESIGNS / f"thesis_{name}.toml"))
    return outcome, {key: one.meshes["crank_camshaft"].source for key, one in outcome.result.scenarios.items()}


NAMES = {"10W-40": "10W40", "0W-30": "0W30", "10W-40-synthetic": "10W40 synthetic", "MIL-L-23699E": "MIL-L-23699E"}


def agree(found, row):
    for ours, key in (
        ("loss", "loss_W"),
        ("efficiency", "efficiency"),
        ("loss_factor", "loss_factor"),
        ("friction_mean", "friction_mean"),
        ("lambda_min", "lambda_min"),
    ):
        assert getattr(found, ours) == pytest.approx(row[key], rel=1e-4), ours
    assert found.pressure_max / 1e6 == pytest.approx(row["pressure_max_MPa"], rel=1e-4)
    ends = [float(np.asarray(found.local.h)[i]) * 1e6 for i in (0, -1)]
    assert ends == pytest.approx([row["film_A_um"], row["film_E_um"]], rel=1e-4)


def test_first_scenario_temperatures():
    outcome, found = thesis("temperatures")
    agree(found["10W-40-40-C"], SUMMARY[THESIS + "10W40", "linear"])
    loaded = RECORDED["runs"][0]
    assert found["10W-40-40-C"].loss == pytest.approx(loaded["loss_W"], rel=1e-4)
    for name in NAMES:
        losses = [found[f"{name}-{T}-C"].loss for T in (40, 50, 60)]
        assert losses == sorted(losses), "thinner oil, more load on the roughness"
    assert outcome.result.scenarios["10W-40-40-C"].total_loss == pytest.approx(outcome.result.total_loss, rel=1e-9)


def test_second_scenario_oils():
    _, found = thesis("oils")
    for key, oil in NAMES.items():
        agree(found[f"{key}-40-C"], SUMMARY[THESIS + oil, "linear"])


def test_both_scenarios_are_the_same_twelve_runs():
    (_, by_oil), (_, by_temperature) = thesis("temperatures"), thesis("oils")
    assert {key: run.loss for key, run in by_oil.items()} == {key: run.loss for key, run in by_temperature.items()}
    assert list(by_oil) == [f"{name}-{T}-C" for name in NAMES for T in (40, 50, 60)]
    assert list(by_temperature) == [f"{name}-{T}-C" for T in (40, 50, 60) for name in NAMES]


def test_third_scenario_tip_relief():
    _, found = thesis("tip_relief")
    agree(found["as-generated"], SUMMARY[THESIS + "10W40", "linear"])
    agree(found["tips-relieved"], SUMMARY[THESIS + "10W40", "smooth"])


@pytest.mark.parametrize(
    "name, number, figures",
    [("temperatures", 12, [*NAMES]), ("oils", 12, ["40 °C", "50 °C", "60 °C"]), ("tip_relief", 2, [""])],
)
def test_they_are_shown_side_by_side(name, number, figures):
    """In the figures of the thesis: three temperatures of each oil (22 to 26), four oils at each temperature (27 to
    29)."""
    outcome = friction_of(read(DESIGNS / f"thesis_{name}.toml")).whole
    tables = [t for t in outcome.tables if t.id.startswith("scenarios_")]
    assert [len(t.rows) for t in tables] == [number, number]
    assert [len(t.rows) for t in outcome.tables if t.id == "scenarios"] == [number]
    curves = [c for c in outcome.curves if c.id.startswith("scenarios_")]
    assert len({c.id for c in curves}) == len(curves) == 9 * len(figures)  # the thesis' six, pressure, λ, temperature
    assert [c.id for c in outcome.key_curves if c.short][1:] == [c.id for c in curves], "the short report has them"
    for n, curve in enumerate(curves):
        assert figures[n // 9] in curve.title
        drawn = [name for name, s in outcome.result.scenarios.items() if s.figure == figures[n // 9]]
        assert [s.label for s in curve.series] == 2 * drawn and len(drawn) == number // len(figures)
        assert len(curve.variants) == 2
        for series in curve.series:
            assert (np.diff(series.x) >= 0).all()
            there = np.flatnonzero(np.isfinite(series.y))  # a relieved tip that carries next to nothing may be left out
            assert there.size > 0.8 * len(series.x) and there.size == there[-1] - there[0] + 1
