# SPDX-License-Identifier: Apache-2.0
"""The power balance of the train: it closes, up and down, and refuses what has no meaning."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.design.toml_file import design, read
from calc.friction import power_balance as power
from calc.friction.inputs import OtherLoss, carrier
from calc.sheet.errors import NoSolution
from calc.sheet.expression import line_text
from calc.sheet.value import link_of
from calc.solve import solve
from tests.calc.friction.pairs import CRANK_SPEED, SHAFT_POWER, closed, r753, recorded, shown, spur_pair
from tests.conftest import GAMMA

RECORDED = recorded("friction_r753.json")
DESIGNS = Path(__file__).parents[3] / "designs"
TRAIN = closed()
VALUES = shown(TRAIN)


def only(mesh):
    return {mesh.name: mesh}


# --- the balance
def test_the_losses_are_the_power_at_the_crank():
    parts = sum(VALUES[f"{part}_loss"] for part in ("bearing", "mesh", "windage", "other"))
    assert parts == pytest.approx(VALUES["total_loss"], rel=1e-9)
    assert VALUES["total_loss"] == pytest.approx(VALUES["crank_power"], rel=1e-9)
    assert VALUES["crank_torque"] == pytest.approx(VALUES["crank_power"] / (2 * np.pi * CRANK_SPEED), rel=1e-9)


def test_the_losses_as_a_share_of_what_the_engine_gives(gamma_results):
    outcome = gamma_results.outcomes["friction"]
    share = outcome.result.engine_share
    assert share == pytest.approx(outcome.result.total_loss / 50e3) == pytest.approx(228.7 / 50e3, rel=1e-3)
    assert link_of(share).arguments["P_e"].link == "engine.rated_power_kW"
    assert TRAIN.result.engine_share is None
    own = design(read(GAMMA).with_value("gears.speed_rpm", 5200))  # at which the engine's power is not known
    assert solve(own).outcomes["friction"].result.engine_share is None


def test_what_the_bearings_lose_of_the_rated_power_is_judged_and_what_rolling_ones_would(gamma_results):
    """220 W of both journals at 2600 rpm and 120 °C are 0.44 % of 50 kW and more than 1 % of 20 kW; two NU205 lose 18 W
    there, by an oracle of its own."""
    P = gamma_results.outcomes["friction"].result.bearing_loss
    for rated, verdict in ((50.0, "pass"), (20.0, "note")):
        document = read(GAMMA).with_value("engine.rated_power_kW", rated)
        outcome = solve(design(document), gamma_results).outcomes["friction"]
        assert outcome.result.bearing_share == pytest.approx(P / rated / 1e3)
        assert {c.id: c.verdict for c in outcome.checks}["friction.train.bearing_share"] == verdict
        said = [str(note) for note in outcome.notes if "balls and rollers in their places" in str(note)]
        assert len(said) == (verdict == "note")
    would = float(re.search(r"would lose about ([\d.]+) W", said[0]).group(1))
    assert 10 < would < 60
    assert TRAIN.result.bearing_share is None and "friction.train.bearing_share" not in {c.id for c in TRAIN.checks}


def test_every_mesh_passes_on_what_the_next_takes_in():
    names, wheels = list(r753()), [mesh.driven.name for mesh in r753().values()]
    for name, wheel, following in zip(names, wheels, [*names[1:], None]):
        takes = VALUES[f"{following}.power_in"] if following else SHAFT_POWER
        assert VALUES[f"{name}.power_out"] == pytest.approx(takes + VALUES[f"{wheel}.windage"], rel=1e-12)
        assert VALUES[f"{name}.power_in"] - VALUES[f"{name}.power_out"] == pytest.approx(
            VALUES[f"{name}.loss"], rel=1e-9
        )
        assert VALUES[f"{name}.efficiency"] == pytest.approx(
            VALUES[f"{name}.power_out"] / VALUES[f"{name}.power_in"], rel=1e-9
        )


def test_the_train_is_of_the_expected_size():
    """Rolling 1.5, 1.6, 1.6 W and the source's sliding 4.9, 4.0, 5.3 W from the shaft up; 285 to 295 W, 1.05 to 1.08
    N·m at the crank."""
    for name, rolling, sliding in (("idler_shaft", 1.5, 4.9), ("central_idler", 1.6, 4.0), ("crank_central", 1.6, 5.3)):
        assert VALUES[f"{name}.rolling_loss"] == pytest.approx(rolling, abs=0.06)
        assert VALUES[f"{name}.source.loss"] == pytest.approx(sliding, abs=0.06)
        assert VALUES[f"{name}.rigid_share"] == 100
    assert 285 < VALUES["crank_power"] < 295
    assert 1.05 < VALUES["crank_torque"] < 1.08


@pytest.mark.parametrize("name", RECORDED["values"])
def test_recorded(name):
    assert VALUES[name] == pytest.approx(RECORDED["values"][name], rel=1e-9)


@pytest.mark.parametrize("film", ["judged", "source"])
def test_down_the_train_is_up_the_train(film):
    up = closed(film=film)
    into_first = next(iter(up.result.meshes.values())).power_in
    down = shown(closed(shaft_power=None, power=into_first, film=film))
    assert down["delivered_power"] == pytest.approx(SHAFT_POWER, rel=1e-9)
    for name in r753():
        assert down[f"{name}.loss"] == pytest.approx(shown(up)[f"{name}.loss"], rel=1e-8)
    assert down["crank_power"] == pytest.approx(down["total_loss"] + down["delivered_power"], rel=1e-9)
    assert "bearing_loss" not in down


def test_a_mesh_alone():
    pair = spur_pair()
    found = closed(
        shaft_power=None,
        power=10000.0,
        speed=25.0,
        T=60.0,
        meshes=only(pair),
        film="source",
        oil="friction thesis 10W40",
    )
    values = shown(found)
    assert values["pinion_gear.loss"] == pytest.approx(66.1994, abs=1e-3)
    assert values["pinion_gear.power_in"] == 10000.0
    assert values["crank_power"] == pytest.approx(10000.0 + values["pinion.windage"])
    assert values["delivered_power"] == pytest.approx(values["crank_power"] - values["total_loss"])
    assert values["gear.speed"] == pytest.approx(750.0)


def test_a_jump_of_the_loss_does_not_stop_the_balance():
    pair = spur_pair()

    def jumping(name, P):
        return 4.0 if P < 104.0 - 1e-3 else 3.99

    P = power.upstream(only(pair), jumping, lambda loads: {"pinion": 0.0, "gear": 100.0})[pair.name]
    assert abs(100.0 + jumping("", P) - P) < 0.011


def test_a_mesh_that_eats_more_than_it_gets_is_no_solution():
    pair = spur_pair()
    with pytest.raises(NoSolution, match="power balance of mesh pinion_gear"):
        power.upstream(only(pair), lambda name, P: 1.2 * P, lambda loads: {"pinion": 0.0, "gear": 100.0})


# --- what is carried where
def test_other_losses_enter_at_the_wheel_that_they_name():
    base = VALUES["crank_power"]
    at_crank, at_idler, anywhere = (
        shown(closed(other_losses=(OtherLoss(name=name, power=20.0),)))
        for name in ("crank seal", "idler bearing", "fuel pump")
    )
    assert at_crank["crank_power"] == pytest.approx(base + 20, rel=1e-9)
    assert base + 20 < at_idler["crank_power"] < anywhere["crank_power"]
    assert anywhere["shaft.other_loss"] == 20
    for values in (at_crank, at_idler, anywhere):
        assert values["other_loss"] == 20
        assert values["total_loss"] == pytest.approx(values["crank_power"], rel=1e-9)


def test_a_train_that_branches_closes_upwards_and_is_refused_downwards():
    meshes = r753()
    pump = replace(meshes["idler_shaft"].driven, name="pump")
    branch = replace(meshes["idler_shaft"], driven=pump)
    last = meshes.pop("idler_shaft")
    branched = {**meshes, branch.name: branch, last.name: last}
    values = shown(closed(meshes=branched, other_losses=(OtherLoss(name="pump", power=50.0),)))
    assert values["total_loss"] == pytest.approx(values["crank_power"], rel=1e-9)
    assert values["central_idler.power_out"] == pytest.approx(
        values["idler_pump.power_in"] + values["idler_shaft.power_in"] + values["idler.windage"], rel=1e-12
    )
    with pytest.raises(NoSolution, match="branches"):
        closed(shaft_power=None, power=300.0, meshes=branched)


def test_the_film_that_is_chosen_is_judged():
    source = shown(closed(film="source"))
    for name in r753():
        assert source[f"{name}.loss"] == source[f"{name}.source.loss"]
        assert source[f"{name}.rolling_loss"] == 0
        assert source[f"{name}.by_regime.loss"] > source[f"{name}.by_regime.sliding_loss"]
    assert source["mesh_loss"] > VALUES["mesh_loss"]  # its peaks rub far more than the rigid film rolls


def test_reversing_a_mesh_swaps_approach_and_recess():
    mesh = r753()["idler_shaft"]
    turned = replace(mesh, driver=mesh.driven, driven=mesh.driver)
    one = shown(closed(meshes=only(mesh), speed=1000 / 60))
    two = shown(closed(meshes=only(turned), speed=1000 / 60 * 39 / 25))
    for name in ("loss", "film_min", "pressure_max", "loss_factor"):
        assert two[f"{turned.name}.{name}"] == pytest.approx(one[f"{mesh.name}.{name}"], rel=1e-4)


def test_fuel_is_asked_for():
    assert "fuel" not in VALUES
    assert shown(closed(specific_fuel_consumption=220e-3 / 3.6e6))["fuel"] == pytest.approx(
        0.220 * VALUES["total_loss"]
    )


def test_no_shaft_loss_leaves_the_windage():
    values = shown(closed(shaft_power=0.0))
    assert 0 < values["crank_power"] < 1
    assert values["total_loss"] == pytest.approx(values["crank_power"], rel=1e-9)


# --- what is said about it
def test_checks_note_the_regime_and_rough_flanks():
    verdicts = {c.id: c.verdict for c in TRAIN.checks}
    assert verdicts["friction.train.balance"] == "pass"
    for name in r753():
        assert verdicts[f"friction.{name}.regime"] == "note"
        assert verdicts[f"friction.{name}.lambda"] == "note"
        assert verdicts[f"friction.{name}.deborah"] == "pass"
        assert verdicts[f"friction.{name}.power_out"] == "pass"
    limits = {"friction.train.balance", *(f"friction.{name}.power_out" for name in r753())}
    assert {c.id for c in TRAIN.checks if c.kind == "limit"} == limits
    assert all(c.advice and c.source for c in TRAIN.checks)


def test_at_high_load_the_ehl_formula_holds():
    found = closed(shaft_power=None, power=50000.0, speed=25.0, T=40.0, meshes=only(spur_pair()))
    assert {c.id: c.verdict for c in found.checks}["friction.pinion_gear.regime"] == "pass"
    assert "friction.pinion_gear.film_min" not in [e.about for e in found.errata]


def test_the_errors_of_the_source_stand_beside():
    """The film that it takes everywhere, and a viscosity that contradicts what stands beside it."""
    errata = {e.about: e for e in TRAIN.errata}
    assert set(errata) == {f"friction.{name}.film_min" for name in r753()}
    assert errata["friction.idler_shaft.film_min"].source_value < VALUES["idler_shaft.film_min"]
    spur = closed(
        shaft_power=None, power=100.0, speed=25.0, T=40.0, meshes=only(spur_pair()), oil="friction thesis 10W40"
    )
    theirs = {e.about: e.source_value for e in spur.errata}
    assert set(theirs) == {"friction.pinion_gear.film_min", "friction.oil_viscosity"}
    assert theirs["friction.oil_viscosity"] == 128.58


def test_lines_stand_once_and_can_be_read():
    about = {line.about for line in TRAIN.lines}
    assert {"oil", "mist", "wheel idler", "mesh idler–shaft", "mesh idler–shaft, source model", "train"} <= about
    judged = [line.formula.__name__ for line in TRAIN.lines if line.about == "mesh idler–shaft"]
    assert judged.count("sliding_loss") == judged.count("film_temperature") == judged.count("power_in") == 1
    for line in TRAIN.lines:
        assert all(line_text(line))


# --- the mesh that eats its power
def failing(outcome):
    return {c.id for c in outcome.checks if c.verdict == "fail"}


def test_a_train_that_delivers_nothing_fails():
    pair = only(spur_pair())
    much, little, none = (
        closed(shaft_power=None, power=P, speed=25.0, T=40.0, meshes=pair) for P in (100.0, 1.0, 1e-9)
    )
    assert not failing(much)
    assert failing(little) == {"friction.train.delivered"}
    assert failing(none) == {"friction.train.delivered", "friction.pinion_gear.power_out"}
    assert all("gears.power_kW" in c.moved_by and "more power" in c.advice for c in none.checks if c.verdict == "fail")


def test_a_chain_that_runs_dry_on_the_way_says_so():
    with pytest.raises(NoSolution, match=r"mesh central–idler: power; −?-?[0-9.]+ W come in.*gears\.power_kW"):
        closed(shaft_power=None, power=0.2)


# --- who carries what
@pytest.mark.parametrize(
    "loss, wheel",
    [
        ("crank", "crank"),
        ("crank seal", "crank"),
        ("crank-seal", "crank"),
        ("crank: seal", "crank"),
        ("crankcase-seal", "shaft"),
        ("crank2 seal", "shaft"),
        ("pump", "shaft"),
        ("seal of crank", "shaft"),
        ("idler-2 bearing", "idler-2"),
        ("idler-3", "idler"),
    ],
)
def test_the_carrier_of_a_loss(loss, wheel):
    wheels = ("crank", "idler", "idler-2", "shaft")
    assert carrier(OtherLoss(name=loss, power=1.0), wheels, "shaft") == wheel
    assert carrier(OtherLoss(name=loss, power=1.0, wheel="idler"), wheels, "shaft") == "idler"


def test_a_note_says_which_wheel_carries_a_loss():
    losses = (
        OtherLoss(name="idler seal", power=5.0),
        OtherLoss(name="crankcase-seal", power=7.0),
        OtherLoss(name="idler: oil", power=1.0),
    )
    outcome = closed(other_losses=losses)
    notes = [n for n in outcome.notes if n.startswith("Other loss")]
    assert notes[0] == 'Other loss "idler seal", 5 W: carried by wheel idler.'
    assert notes[1].startswith('Other loss "crankcase-seal", 7 W: carried by wheel shaft, the last')
    assert (shown(outcome)["idler.other_loss"], shown(outcome)["shaft.other_loss"], shown(outcome)["other_loss"]) == (
        6,
        7,
        13,
    )


# --- every value can be explained
@pytest.mark.parametrize("name", ["r753ie4_gamma.toml", "timing_pair.toml"])
def test_every_value_is_what_a_line_returned_or_an_input(name):
    drawn = design(read(DESIGNS / name))
    outcome = solve(drawn).outcomes["friction"]
    assert [v.id for v in outcome.values() if link_of(v.inside) is None] == []


def test_what_the_given_power_means_is_said():
    document = read(DESIGNS / "r753ie4_gamma.toml")
    rates = "gears.power_kW rates the teeth only; the losses are those of the closed balance."
    assert rates not in solve(design(document)).outcomes["friction"].notes
    assert rates in solve(design(document.with_value("gears.power_kW", 1.35))).outcomes["friction"].notes
    alone = solve(design(read(DESIGNS / "timing_pair.toml"))).outcomes["friction"].notes
    assert any("plus its own windage" in n for n in alone)


def test_errata_are_methods_save_what_is_printed():
    found = closed(
        shaft_power=None, power=100.0, speed=25.0, T=40.0, meshes=only(spur_pair()), oil="friction thesis 10W40"
    )
    sources = {e.about: e.source for e in found.errata}
    assert sources.pop("friction.oil_viscosity").startswith("printed viscosity")
    assert len(sources) == 1 and all(s.startswith("method of the gear friction thesis") for s in sources.values())


# --- what has no meaning
@pytest.mark.parametrize("value", [float("nan"), float("inf"), -1.0])
@pytest.mark.parametrize("what", ["shaft_power", "speed", "T"])
def test_numbers_without_meaning_are_refused(what, value):
    with pytest.raises(NoSolution):
        closed(**{what: value if what != "T" else value * 1e3})


@pytest.mark.parametrize(
    "said",
    [
        {"flank_roughness": (0.0,)},
        {"flank_roughness": (float("nan"),)},
        {"solid_friction": -0.1},
        {"solid_friction": float("nan")},
        {"mist_density": 0.0},
        {"bulk_temperature": float("nan")},
        {"other_losses": (OtherLoss(name="pump", power=-5.0),)},
        {"meshes": {}},
        {"speed": 0.0},
        {"shaft_power": None},
        {"shaft_power": None, "power": 0.0},
        {"shaft_power": None, "power": float("nan")},
    ],
)
def test_inputs_without_meaning_are_refused(said):
    with pytest.raises(NoSolution):
        closed(**said)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    "said, words",
    [
        ({"power": 1e8}, "above 1500 °C, where the laws of the oil end"),
        ({"power": 1e300}, "no number|above 1500"),
        ({"flank_roughness": (1e-306,)}, r"1·10⁻³⁰⁰ µm is so small.*friction\.flank_roughness_um"),
        ({"power": float("nan")}, "is no value"),
        ({"power": float("inf")}, "is ∞"),
    ],
)
def test_numbers_far_outside_give_words_and_no_warning(said, words):
    with pytest.raises(NoSolution, match=words) as caught:
        closed(**{"shaft_power": None, "power": 100.0, "speed": 25.0, "T": 40.0, "meshes": only(spur_pair()), **said})
    assert caught.value.advice and "nan" not in str(caught.value)


@pytest.mark.filterwarnings("error")
@settings(max_examples=40, deadline=None)
@given(
    power=st.floats(-15, 9),
    speed=st.floats(-3, 3.3),
    T=st.floats(-40, 200),
    Ra=st.floats(-200, -5),
    b=st.floats(-9, 0.3),
    film=st.sampled_from(["judged", "source"]),
)
def test_any_numbers_give_finite_values_or_words(power, speed, T, Ra, b, film):
    pair = spur_pair()
    pair = replace(pair, driver=replace(pair.driver, face_width=10**b), driven=replace(pair.driven, face_width=10**b))
    try:
        outcome = closed(
            shaft_power=None,
            power=10**power,
            speed=10**speed,
            T=T,
            meshes=only(pair),
            flank_roughness=(10**Ra,),
            film=film,
        )
    except NoSolution as none:
        assert none.what and none.advice and "nan" not in str(none)
        return
    assert all(np.isfinite(v.shown) for v in outcome.values())
    assert all(np.isfinite(c.value) for c in outcome.checks)


def test_a_mesh_that_nothing_drives_is_refused():
    meshes = r753()
    with pytest.raises(NoSolution, match="nothing drives central"):
        closed(meshes={name: meshes[name] for name in ("idler_shaft", "central_idler")})


@settings(max_examples=25, deadline=None)
@given(
    shaft_power=st.floats(1e-3, 1e5),
    speed=st.floats(0.5, 300.0),
    T=st.floats(0.0, 150.0),
    Ra=st.floats(0.05e-6, 5e-6),
    film=st.sampled_from(["judged", "source"]),
)
def test_any_sensible_train_closes(shaft_power, speed, T, Ra, film):
    values = shown(closed(shaft_power=shaft_power, speed=speed, T=T, flank_roughness=(Ra,), film=film))
    assert values["total_loss"] == pytest.approx(values["crank_power"], rel=1e-9)
    for name in r753():
        assert 0 < values[f"{name}.efficiency"] < 1
        assert values[f"{name}.film_min"] > 0


if __name__ == "__main__":
    import json

    chosen = (
        "loss",
        "sliding_loss",
        "rolling_loss",
        "loss_factor",
        "friction_mean",
        "film_min",
        "temperature_max",
        "source.loss",
    )
    names = [f"{mesh}.{name}" for mesh in r753() for name in chosen] + [
        "mesh_loss",
        "windage_loss",
        "crank_power",
        "crank_torque",
    ]
    print(json.dumps({name: VALUES[name] for name in names}, indent=1))
