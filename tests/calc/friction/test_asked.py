# SPDX-License-Identifier: Apache-2.0
"""What a user writes into [friction], what is refused with place and remedy, and what the notes say about it."""

import json
from pathlib import Path

import pytest

from assistant.cli import main
from calc.design.toml_file import design
from calc.sheet.errors import BadInput
from calc.solve import solve
from tests.calc.friction.documents import changed, gamma, pair

HELICAL = {
    "gears": {"helix_angle_deg": 20.0, "pressure_angle_deg": 20.0, "power_kW": 5.0},
}


def friction_of(document):
    return solve(design(document)).outcomes["friction"]


def refused(document):
    with pytest.raises(BadInput) as caught:
        design(document)
    return str(caught.value)


# --- refused
@pytest.mark.parametrize(
    "kind, entry",
    [
        ("seals", {"diameter_mm": 40.0}),
        ("rolling_bearings", {"bore_mm": 20.0, "outside_diameter_mm": 42.0}),
        ("plain_bearings", {"diameter_mm": 20.0, "length_mm": 12.0, "clearance_um": 40.0}),
        ("dips", {"depth_mm": 5.0, "oil_volume_L": 2.0}),
        ("jets", {"flow_L_min": 1.0}),
        ("other_losses", {"power_W": 3.0}),
    ],
)
def test_a_wheel_that_is_not_there_is_refused_and_one_that_is_carries(kind, entry):
    said = refused(changed(gamma(), friction={kind: [{"name": "x", "wheel": "idlr", **entry}]}))
    assert f"friction.{kind}.0.wheel" in said and 'did you mean "idler"?' in said
    found = friction_of(
        changed(gamma(), friction={kind: [{"name": "shaft-x", "wheel": "idler", **entry}]})
    ).result.wheels
    assert sum(found["idler"].parts()) > sum(friction_of(gamma()).result.wheels["idler"].parts())
    assert not any("begin with that of no wheel" in note for note in friction_of(gamma()).notes)


def test_skf_asks_for_a_series_it_knows():
    said = refused(
        changed(
            gamma(),
            friction={
                "rolling_bearings": [{"name": "idler", "bore_mm": 25.0, "outside_diameter_mm": 52.0, "method": "skf"}]
            },
        )
    )
    assert "friction.rolling_bearings.0.series" in said and '"62"' in said and "palmgren" in said
    needle = {
        "name": "idler",
        "bore_mm": 25.0,
        "outside_diameter_mm": 52.0,
        "method": "skf",
        "kind": "needle-roller",
        "series": "62",
    }
    assert "deep-groove-ball and cylindrical-roller only" in refused(
        changed(gamma(), friction={"rolling_bearings": [needle]})
    )


def test_teeth_are_measured_or_estimated():
    assert "friction.bulk_temperature_C" in refused(
        changed(pair(), friction={"bulk": "estimated", "bulk_temperature_C": 50.0})
    )


def test_the_power_of_a_scenario_is_that_of_a_train_alone():
    assert "friction.scenarios.0.power_kW" in refused(
        changed(gamma(), friction={"scenarios": [{"name": "a", "power_kW": 1.0}]})
    )


# --- what once broke
def test_a_helical_train_alone_with_bearings_is_shown_whole():
    wheels = [{"name": f"w{i}", "teeth": z} for i, z in enumerate((25, 36, 39))]
    meshes = [{"driver": "w0", "driven": "w1"}, {"driver": "w1", "driven": "w2"}]
    gears = {**HELICAL["gears"], "wheels": wheels, "meshes": meshes, "normal_module_mm": 2.0, "face_width_mm": 15.0}
    bearing = {"name": "w1", "bore_mm": 20.0, "outside_diameter_mm": 42.0}
    outcome = friction_of(changed(pair(), gears=gears, friction={"rolling_bearings": [bearing]})).whole
    assert {"over_speed", "open_constants"} <= {c.id for c in outcome.curves}
    assert outcome.result.wheels["w1"].bearing_force > 0


@pytest.mark.parametrize("said, count", [({}, 1), ({"count": 2}, 2)])
def test_rolling_bearings_say_how_many_they_are(said, count):
    """One, unless the design says otherwise; the part without load counts once for each."""
    bearing = {"name": "pinion", "bore_mm": 20.0, "outside_diameter_mm": 42.0, "f_1": 0.0}
    outcome = friction_of(changed(pair(), friction={"rolling_bearings": [bearing | said]}))
    single = friction_of(changed(pair(), friction={"rolling_bearings": [bearing | {"count": 1}]}))
    ours, one = ({n: w.bearing_loss for n, w in o.result.wheels.items() if w.bearing_loss} for o in (outcome, single))
    assert ours == {name: pytest.approx(count * loss, rel=1e-3) for name, loss in one.items()} and ours
    assert any(f"share each load: pinion {count}." in note for note in outcome.notes)


def test_teeth_that_run_away_are_no_solution():
    hot = {"bulk": "estimated", "solid_friction": 0.9, "oil_temperature_C": 120.0}
    outcome = friction_of(changed(pair(), gears={"power_kW": 3000.0}, friction=hot))
    assert outcome.state == "no_solution" and "1500 °C" in outcome.reason


def test_an_estimated_temperature_of_the_teeth_is_judged():
    outcome = friction_of(changed(pair(), gears={"power_kW": 200.0}, friction={"bulk": "estimated"}))
    judged = {c.id: c for c in outcome.checks}["friction.crank_camshaft.bulk_temperature"]
    assert judged.value == pytest.approx(outcome.result.meshes["crank_camshaft"].judged.bulk_temperature)
    assert judged.kind == "caution"


def test_linke_has_no_gain():
    seals = {
        "seals": [{"name": "camshaft", "diameter_mm": 40.0, "method": "linke"}],
        "oil": "friction thesis MIL-L-23699E",
        "oil_temperature_C": 150.0,
    }
    outcome = friction_of(changed(pair(), friction=seals))
    assert outcome.result.seal_loss == 0.0
    assert any("Linke" in note and "simrit" in note for note in outcome.notes)


def test_a_jet_faster_than_the_teeth_is_told():
    outcome = friction_of(
        changed(pair(), friction={"jets": [{"name": "camshaft", "flow_L_min": 2.0, "jet_speed_m_s": 30.0}]})
    )
    assert outcome.result.thrown_oil_loss < 0
    assert any("drives its wheel" in note for note in outcome.notes)


def test_rolling_that_is_not_counted_is_told():
    """Cold oil ends the rigid film: its bound goes, and what EHL films roll stands beside."""
    outcome = friction_of(changed(gamma(), bearings={"supply_temperature_C": 20.0}))
    mesh = outcome.result.meshes["crank_central"].judged
    assert mesh.rolling_loss == 0.0 and mesh.rolling_estimate > 0.2 * mesh.loss
    assert any("rolling is not counted" in note for note in outcome.notes)
    balance = next(t for t in outcome.tables if t.id == "balance")
    assert "Not counted: rolling of EHL films" in balance.note


# --- asked for
def test_a_scenario_is_explained_as_the_design_that_it_is(tmp_path, capsys):
    file = tmp_path / "design.toml"
    text = Path(gamma().place).read_text(encoding="utf-8")
    file.write_text(text + '\n[[friction.scenarios]]\nname = "cold"\noil_temperature_C = 60.0\n', encoding="utf-8")
    assert main(["explain", str(file), "friction.scenarios.cold.crank_torque"]) == 0
    said = capsys.readouterr().out
    assert "bearings.supply_temperature_C = 60.0" in said and "definition of torque" in said
    assert main(["check", str(file), "--step", "friction", "--json"]) in (0, 1)
    values = json.loads(capsys.readouterr().out)["values"]
    shown = values["friction.scenarios.cold.crank_torque"]["value"]
    assert f"friction.crank_torque = {shown:.6g}" in said


def test_a_list_that_may_be_one_number_is_swept(capsys):
    asked = [
        "sweep",
        gamma().place,
        "--vary",
        "friction.flank_roughness_um=0.4,0.8",
        "--step",
        "friction",
        "--values",
        "friction.mesh_loss",
    ]
    assert main(asked) == 0
    smooth, rough = (float(line.split(",")[1]) for line in capsys.readouterr().out.splitlines()[1:3])
    assert smooth < rough


def test_a_scenario_leaves_a_measured_temperature_as_its_design_does():
    from calc.friction.studies.scenarios import as_design

    asked = changed(
        gamma(), friction={"bulk_temperature_C": 130.0, "scenarios": [{"name": "cold", "oil_temperature_C": 60.0}]}
    )
    scenario = friction_of(asked).result.scenarios["cold"]
    document, friction = asked, design(asked).friction
    for key, value in as_design(friction, friction.scenarios[0], True).items():
        document = document.with_value(key, value)
    assert friction_of(document).result.total_loss == pytest.approx(scenario.total_loss, rel=1e-8)


def test_scenarios_stand_beside_the_design():
    outcome = friction_of(
        changed(gamma(), friction={"scenarios": [{"name": "rough", "flank_roughness_um": 1.6}]})
    ).whole
    table = next(t for t in outcome.tables if t.id == "scenarios")
    assert [row[0] for row in table.rows] == ["as designed", "rough"]
    assert "Ra 1.6 µm" in table.rows[1][1]
