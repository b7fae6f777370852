# SPDX-License-Identifier: Apache-2.0
"""Inputs that can not be meant: what is far from usual, or does not fit the other numbers, does not pass without a
word; what is shipped has nothing of the kind."""

import math
from dataclasses import replace
from pathlib import Path

import pytest

from calc.design.model import STEP_KEYS, Design
from calc.design.toml_file import Document, design, parse, read
from calc.design.unusual import doubts, told, unusual, with_doubts
from calc.design.upgrade import current
from calc.sheet.check import Check
from calc.sheet.errors import BadInput
from calc.sheet.step import Outcome
from calc.sheet.value import recorded
from calc.sheet.verdict import grouped
from calc.solve import Results, solve
from calc.studies.shipped import DESIGNS, engine_design, engine_inputs, engines, shipped_name
from tests.conftest import SCREENED, SHIPPED

GAMMA, SIZED, TWIN, SET = "r753ie4_gamma", "r753ie4_sized", "twin_drive", "generating_set_mounting"
BLOCK, MOUNTED = SCREENED, "twin_mounting"

REFUSED = "refused"  # the file is not taken: an error at its line
NOTHING = ""  # passes without a word

# shipped design, changes, the check that says it, and what was meant
WRONG: list[tuple[str, dict[str, object], str, dict[str, object]]] = [
    # units of length
    (SIZED, {"engine.bore_mm": 0.094}, "engine.inputs.bore_mm", {"engine.bore_mm": 94}),
    (SIZED, {"engine.bore_mm": 9.4}, "engine.inputs.bore_mm", {"engine.bore_mm": 94}),
    (SIZED, {"engine.bore_mm": 3.7}, "engine.inputs.bore_mm", {"engine.bore_mm": 93.98}),
    (TWIN, {"engine.crank_radius_mm": 4.3}, "engine.inputs.crank_radius_mm", {"engine.crank_radius_mm": 43}),
    (SIZED, {"engine.rod_length_mm": 0.163}, REFUSED, {}),
    (SIZED, {"engine.cylinder_pitch_mm": 11.2}, "engine.inputs.cylinder_pitch_mm", {"engine.cylinder_pitch_mm": 112}),
    (TWIN, {"countershaft.core_radius_mm": 0.0285}, "countershaft.inputs.core_radius_mm",
     {"countershaft.core_radius_mm": 28.5}),
    (TWIN, {"gears.normal_module_mm": 0.25}, "gears.inputs.normal_module_mm", {"gears.normal_module_mm": 2.5}),
    (TWIN, {"gears.face_width_mm": 1.9}, "gears.inputs.face_width", {"gears.face_width_mm": 19}),
    (SIZED, {"gears.face_width_mm": 1.5}, "gears.inputs.face_width_mm", {"gears.face_width_mm": 15}),
    (TWIN, {"gears.wheels.central.bore_diameter_mm": 0.049}, "gears.inputs.wheels.central.bore_diameter_mm",
     {"gears.wheels.central.bore_diameter_mm": 49}),
    (TWIN, {"gears.meshes.0.tolerance_um": 0.04}, "gears.inputs.meshes.0.tolerance_um",
     {"gears.meshes.0.tolerance_um": 40}),
    (TWIN, {"gears.wheels.crank.span_allowance_um": [-0.03, -0.04]}, "gears.inputs.wheels.crank.span_allowance_um",
     {"gears.wheels.crank.span_allowance_um": [-30, -40]}),
    # roughness in mm
    (SIZED, {"bearings.front.journal_roughness_um": 0.0002}, "bearings.inputs.front.journal_roughness_um",
     {"bearings.front.journal_roughness_um": 0.2}),
    (SIZED, {"bearings.rear.housing_roughness_um": 0.0004}, "bearings.inputs.rear.housing_roughness_um",
     {"bearings.rear.housing_roughness_um": 0.4}),
    (TWIN, {"friction.flank_roughness_um": 0.0008}, "friction.inputs.flank_roughness_um",
     {"friction.flank_roughness_um": [0.8]}),
    # a radius for a diameter, a stroke for its half
    (SIZED, {"engine.bore_mm": 47.0}, "engine.inputs.stroke_ratio", {"engine.bore_mm": 94}),
    (TWIN, {"engine.bore_mm": 40.25}, "engine.inputs.stroke_ratio", {"engine.bore_mm": 80.5}),
    (GAMMA, {"engine.crank_radius_mm": 107.0}, "engine.inputs.crank_ratio", {"engine.crank_radius_mm": 53.5}),
    (SIZED, {"bearings.front.diameter_mm": 29.75}, "bearings.inputs.front.core", {"bearings.front.diameter_mm": 59.5}),
    (TWIN, {"bearings.rear.diameter_mm": 44.25}, "bearings.inputs.rear.core", {"bearings.rear.diameter_mm": 88.5}),
    # masses
    (GAMMA, {"engine.piston_mass_g": 1015.0, "engine.rod_mass_g": 1178.0}, "engine.inputs.masses",
     {"engine.piston_mass_g": 1178, "engine.rod_mass_g": 1015}),
    (TWIN, {"engine.piston_mass_g": 540.0, "engine.rod_mass_g": 420.0}, "engine.inputs.masses",
     {"engine.piston_mass_g": 420, "engine.rod_mass_g": 540}),
    (SIZED, {"engine.piston_mass_g": 1.178}, "engine.inputs.piston_mass_g", {"engine.piston_mass_g": 1178}),
    (SIZED, {"engine.crankpin_bearing_mass_g": 0.055}, "engine.inputs.crankpin_bearing_mass_g",
     {"engine.crankpin_bearing_mass_g": 55}),
    (MOUNTED, {"mounting.mass_kg": 0.1}, "mounting.inputs.mass", {"mounting.mass_kg": 100}),
    # the rod from its other end
    (GAMMA, {"engine.rod_cg_to_big_end_mm": 113.0}, "engine.inputs.rod_cg", {"engine.rod_cg_to_big_end_mm": 50}),
    # speeds in radians or turns a second
    (SIZED, {"engine.rated_speed_rpm": 272.3}, "engine.inputs.rated_speed_rpm", {"engine.rated_speed_rpm": 2600.27}),
    (SIZED, {"engine.rated_speed_rpm": 43.33}, "engine.inputs.rated_speed_rpm", {"engine.rated_speed_rpm": 2599.8}),
    (TWIN, {"engine.rated_speed_rpm": 576.0}, "engine.inputs.piston_speed", {"engine.rated_speed_rpm": 5500.39}),
    (SET, {"mounting.idle_speed_rpm": 16.67}, "mounting.inputs.idle_speed_rpm", {"mounting.idle_speed_rpm": 1000.2}),
    # power in PS and in W, consumption in kg
    (SET, {"engine.rated_power_kW": 160.4}, "engine.rated_power", {}),  # above what its gas gives
    (SIZED, {"engine.rated_power_kW": 68.0}, NOTHING, {}),  # without the gas a diesel with a turbocharger gives that
    (SIZED, {"engine.rated_power_kW": 50000.0}, "engine.inputs.rated_power_kW", {"engine.rated_power_kW": 50}),
    (SIZED, {"friction.specific_fuel_consumption_g_kWh": 0.22}, "friction.inputs.specific_fuel_consumption_g_kWh",
     {"friction.specific_fuel_consumption_g_kWh": 220}),
    # angles in radians
    (SIZED, {"bearings.slope_mrad": [0.00015625, 0.115]}, "bearings.inputs.front.slope_mrad",
     {"shafts.shaft.bearings.front.slope_mrad": 0.15625}),
    (BLOCK, {"engine.crank_angles_deg": [0.0, 3.14159, 3.14159, 0.0]}, "engine.inputs.crank_angles",
     {"engine.crank_angles_deg": [0, 180, 180, 0]}),
    (TWIN, {"gears.helix_angle_deg": 0.349066}, "gears.inputs.helix_angle_deg", {"gears.helix_angle_deg": 20}),
    # pressures in MPa
    (SIZED, {"bearings.supply_pressure_bar": 0.4}, "bearings.inputs.supply_pressure",
     {"bearings.supply_pressure_bar": 4}),
    (SET, {"engine.gas.intake_pressure_bar": 0.24}, "engine.inputs.gas", {"engine.gas.intake_pressure_bar": 2.4}),
    # per cent as a share
    (TWIN, {"countershaft.overdesign_percent": 0.015}, "countershaft.inputs.overdesign_percent",
     {"countershaft.overdesign_percent": 1.5}),
    # a load in kN, a viscosity in Pa·s, both given in place of what other steps give
    (SIZED, {"bearings.front.load_N": 2.4}, "bearings.inputs.front.load", {"bearings.front.load_N": 2400}),
    (SIZED, {"bearings.viscosity_mPas": 0.012}, "bearings.inputs.viscosity", {"bearings.viscosity_mPas": 12}),
    # one place, one spring or one pressure in another unit than the others
    (SIZED, {"countershaft.axis_mm": [0.103, 0.13]}, "countershaft.inputs.axis", {"countershaft.axis_mm": [103, 130]}),
    (SET, {"mounting.mounts.0.position_mm": [-0.26, -0.32, -0.25]}, "mounting.inputs.front-left.place",
     {"mounting.mounts.front-left.position_mm": [-260, -320, -250]}),
    (SET, {"mounting.mounts.0.stiffness_N_mm": [620e3, 260e3, 260e3]}, "mounting.inputs.front-left.stiffness",
     {"mounting.mounts.front-left.stiffness_N_mm": [620, 260, 260]}),
    (SET, {"mounting.operation.1.peak_pressure_bar": 0.165}, "mounting.inputs.operation.rated.peak_pressure_bar",
     {"mounting.operation.rated.peak_pressure_bar": 165}),
]  # fmt: skip


ROWS = "shafts.shaft.bearings"


def changed(name: str, changes: dict[str, object]) -> Document:
    document = read(DESIGNS / f"{name}.toml")
    for key, value in changes.items():
        document = document.with_value(key, value)
    return document


def solved(name: str, changes: dict[str, object]) -> Results:
    with recorded(False):
        return solve(design(changed(name, changes)), compared=False)


def words_of(row: tuple[str, dict[str, object], str, dict[str, object]]) -> str:
    return f"{row[0]}-{next(iter(row[1]))}-{next(iter(row[1].values()))}"


def test_there_are_forty_wrong_inputs_and_at_most_three_pass_without_a_word() -> None:
    assert len(WRONG) >= 40
    assert sum(row[2] == NOTHING for row in WRONG) <= 3


@pytest.mark.parametrize(
    "row", [pytest.param(row, marks=pytest.mark.slow if n % 3 else ()) for n, row in enumerate(WRONG)], ids=words_of
)
def test_a_wrong_input_does_not_pass_without_a_word(
    row: tuple[str, dict[str, object], str, dict[str, object]],
) -> None:
    name, wrong, id, meant = row
    if id == REFUSED:
        with pytest.raises(BadInput, match=next(iter(wrong))):
            design(changed(name, wrong))
        return
    results = solved(name, wrong)
    found = {check.id: check for check in results.checks()}
    if id == NOTHING:
        assert not any(check.rule.of_input for check in found.values())
        return
    assert results.verdict not in ("pass", "computed")  # check --strict does not end in 0
    check = found[id]
    assert check.verdict in ("warn", "fail")
    if not meant:
        return
    assert check.kind == "caution" and check.rule.of_input
    first = check.remedies[0]
    keys = {current(changed(name, wrong).data, key): value for key, value in meant.items()}  # as they are called now
    assert dict(first.changes) == {key: pytest.approx(value) for key, value in keys.items()}
    assert str(check.advice).startswith("Did you mean ") and str(first.words) in check.advice
    # what was meant makes it go
    assert id not in {check.id for check in solved(name, dict(wrong) | dict(first.changes)).checks()}


def all_doubts(asked: Design) -> list[Check]:
    return [check for step in asked.asked() for check in doubts(asked, step.key)]


@pytest.mark.parametrize("path", SHIPPED, ids=shipped_name)
def test_nothing_that_is_shipped_is_doubted(path: Path) -> None:
    assert all_doubts(design(read(path))) == []


@pytest.mark.parametrize("name", engines())
def test_no_engine_to_begin_with_is_doubted(name: str) -> None:
    assert all_doubts(Design(schema=1, name=name, engine=engine_inputs(name))) == []


@pytest.mark.slow
@pytest.mark.parametrize("name", engines())
def test_no_design_that_is_begun_is_doubted(name: str) -> None:
    assert all_doubts(design(parse(engine_design(name).encode(), name))) == []


# Journals as their makers print them: diameter and length in mm (an unprinted length: 0.7 of the diameter), the least
# and the greatest clearance in µm, rpm of the shaft.
JOURNALS = [
    ("GM LD9", 29.96, 20.0, 44, 111, 12000),
    ("GM L61 front", 20.01, 18.0, 30, 63, 12000),
    ("GM L61 rear", 36.733, 20.0, 33, 102, 12000),
    ("Ford V10", 26.95, 18.9, 25, 76, 4250),
    ("Mazda WL-C front", 41.952, 22.0, 50, 115, 7000),
    ("Mitsubishi 4M41", 40.0, 28.0, 70, 136, 7600),
    ("Suzuki J24B", 24.95, 18.0, 30, 72, 12000),
    ("Kubota V3307", 48.942, 24.0, 50, 146, 5200),
    ("Westerbeke 65A", 50.93, 35.7, 70, 159, 5600),
    ("Caterpillar 3304", 52.895, 35.0, 50, 229, 4400),
    ("AGCO 49", 36.008, 25.2, 34, 75, 4400),
    ("Kawasaki ER-6n", 28.0, 18.0, 15, 50, 8500),
    ("Yamaha R1", 24.0, 16.8, 12, 43, 12500),
    ("Suzuki GSX-R1000", 23.0, 16.1, 15, 45, 24000),
    ("John Deere STX38", 19.97, 20.0, 25, 63, 3400),
]


@pytest.mark.parametrize("journal", JOURNALS, ids=lambda journal: journal[0])
@pytest.mark.parametrize("end", [3, 4])
def test_no_journal_of_a_maker_is_doubted(journal: tuple[str, float, float, float, float, float], end: int) -> None:
    text = f"""
schema = 1
name = "journal"
[bearings]
oil = "5W-30"
supply_temperature_C = 100.0
supply_pressure_bar = 3.5
supply = "hole"
hole_diameter_mm = 3.0
housing_material = "EN AC-43100"
journal_material = "42CrMo4"
speed_rpm = {journal[5]}.0
"""
    for place in ("front", "rear"):
        text += f"""
[bearings.{place}]
diameter_mm = {journal[1]}
length_mm = {journal[2]}
clearance_um = {journal[end]}.0
load_N = 2500.0
journal_roughness_um = 0.2
housing_roughness_um = 0.4
"""
    assert all_doubts(design(parse(text.encode(), "journal"))) == []


# --- what is far


@pytest.mark.parametrize(
    ("key", "near", "far"),
    [
        ("engine.bore_mm", 16.7, 16.6),  # a third of 50
        ("engine.bore_mm", 449.0, 451.0),  # three times 150
        ("engine.crankpin_bearing_mass_g", 1499.0, 1501.0),  # two widths beyond 500
        ("engine.crankpin_bearing_mass_g", 0.51, 0.49),  # would be usual in kg
        ("bearings.supply_temperature_C", 179.0, 181.0),  # 50 K beyond 130
        ("bearings.supply_temperature_C", 21.0, 19.0),
        ("gears.wheels.central.profile_shift", 0.0001, None),  # a number without a unit
        ("gears.wheels.crank.tip_diameter_tolerance_um", [0.0, -299.0], [0.0, -301.0]),  # two widths beyond -100
        ("gears.wheels.crank.span_allowance_um", [-0.081, -0.09], [-0.079, -0.09]),  # would be usual in mm
        ("gears.wheels.crank.span_allowance_um", [99.0, 90.0], [101.0, 90.0]),  # two widths beyond -20
        ("bearings.front.journal_roughness_um", 0.0334, 0.0333),
        ("bearings.front.journal_roughness_um", 0.9, 2.41),
        ("engine.crankpin_bearing_mass_g", 0.0, None),
        ("engine.rod_cg_to_big_end_mm", 0.0, None),
    ],
)
def test_what_is_far(key: str, near: object, far: object) -> None:
    step, _, rest = key.partition(".")
    id = f"{step}.inputs.{rest}"

    def ids(number: object) -> list[str]:
        return [check.id for check in doubts(design(changed(GAMMA, {key: number})), step)]

    assert id not in ids(near)
    assert far is None or id in ids(far)


@pytest.mark.parametrize(
    ("name", "key", "id", "good", "bad"),
    [
        # the same ratio just inside and just outside
        (TWIN, "engine.rod_mass_g", "engine.inputs.masses", 420 * 0.81, 420 * 0.79),
        (TWIN, "engine.rod_mass_g", "engine.inputs.masses", 420 * 1.59, 420 * 1.61),
        (SIZED, "engine.rod_mass_g", "engine.inputs.masses", 1178 * 1.14, 1178 * 1.16),
        (SIZED, "engine.piston_mass_g", "engine.inputs.masses", 1015 / 0.61, 1015 / 0.59),
        (TWIN, "engine.bore_mm", "engine.inputs.masses", 73.3, 73.1),  # 0.96 kg over its cube: 2438 and 2458 kg/m³
        (SIZED, "engine.rated_speed_rpm", "engine.inputs.piston_speed", 1130.0, 1110.0),
        (SIZED, "engine.rated_speed_rpm", "engine.inputs.piston_speed", 8400.0, 8420.0),
        (SIZED, "engine.rod_length_mm", "engine.inputs.crank_ratio", 53.5 / 0.41, 53.5 / 0.43),
        (SIZED, "engine.rod_length_mm", "engine.inputs.crank_ratio", 53.5 / 0.151, 53.5 / 0.149),
        (SIZED, "engine.bore_mm", "engine.inputs.stroke_ratio", 107 / 1.79, 107 / 1.81),
        (SIZED, "engine.bore_mm", "engine.inputs.stroke_ratio", 107 / 0.41, 107 / 0.39),
        (SIZED, "engine.cylinder_pitch_mm", "engine.inputs.cylinder_pitch", 94 * 1.89, 94 * 1.91),
        (SIZED, "engine.rod_cg_to_big_end_mm", "engine.inputs.rod_cg", 163 * 0.49, 163 * 0.51),
        (SIZED, "engine.rod_cg_to_big_end_mm", "engine.inputs.rod_cg", 163 * 0.11, 163 * 0.09),
        (SIZED, "engine.rated_power_kW", "engine.inputs.rated_power", 154.0, 155.0),
        (SIZED, "engine.rated_power_kW", "engine.inputs.rated_power", 7.3, 7.2),
        (BLOCK, "engine.crank_angles_deg", "engine.inputs.crank_angles", [0.0, 6.3, 6.3, 0.0], [0.0, 6.2, -6.2, 0.0]),
        (SET, "engine.gas.peak_pressure_bar", "engine.inputs.gas", 633.0, 636.0),
        (SIZED, "bearings.supply_pressure_bar", "bearings.inputs.supply_pressure", 1.0, 0.99),
        (SIZED, "bearings.supply_pressure_bar", "bearings.inputs.supply_pressure", 0.0, 0.34),
        (SIZED, "bearings.viscosity_mPas", "bearings.inputs.viscosity", 0.51, 0.49),
        (SIZED, "bearings.viscosity_mPas", "bearings.inputs.viscosity", 1990.0, 2010.0),
        (SIZED, "bearings.front.diameter_mm", "bearings.inputs.front.core", 36.1, 35.9),
        (TWIN, "bearings.front.diameter_mm", "bearings.inputs.front.core", 57.1, 56.9),
        (SIZED, "bearings.front.length_mm", "bearings.inputs.front.core", 0.85 * 35 - 0.1, 0.85 * 35 + 0.1),
        (TWIN, "bearings.front.length_mm", "bearings.inputs.front.length", 159.0, 161.0),
        (TWIN, "bearings.front.length_mm", "bearings.inputs.front.length", 12.1, 11.9),
        (TWIN, "bearings.front.clearance_um", "bearings.inputs.front.clearance", 790.0, 810.0),
        (TWIN, "bearings.front.clearance_um", "bearings.inputs.front.clearance", 16.1, 15.9),
        (TWIN, "bearings.front.load_N", "bearings.inputs.front.load", 45.0, 44.0),
        (TWIN, "bearings.front.load_N", "bearings.inputs.front.load", 671e3, 673e3),
        (TWIN, "gears.face_width_mm", "gears.inputs.face_width", 5.01, 4.99),
        (TWIN, "gears.face_width_mm", "gears.inputs.face_width", 149.0, 151.0),
        (TWIN, "gears.wheels.crank.face_width_mm", "gears.inputs.crank.face_width", 5.01, 4.99),
        (TWIN, "gears.wheels.crank.face_width_mm", "gears.inputs.crank.face_width", 149.0, 151.0),
        (SIZED, "gears.power_kW", "gears.inputs.power", 50.0, 50.1),
        (SET, "mounting.mass_kg", "mounting.inputs.mass", 89.0, 88.0),
        (SET, "mounting.mass_kg", "mounting.inputs.mass", 5890.0, 5910.0),
    ],
)  # fmt: skip
def test_inputs_that_do_not_fit_each_other(name: str, key: str, id: str, good: object, bad: object) -> None:
    step = id.partition(".")[0]
    short = {"bearings.front.diameter_mm": 35.0} if key == "bearings.front.length_mm" and name == SIZED else {}

    def ids(content: object) -> list[str]:
        return [check.id for check in doubts(design(changed(name, short | {key: content})), step)]

    assert id not in ids(good)
    assert id in ids(bad)


STIFF = math.sqrt(6 * (620e3 + 260e3 + 260e3) / 3 / 1150) / (2 * math.pi)  # Hz, of the mounts as they are
# shipped design, changes, the check that doubts them, its value and its limit as shown, and all that may be meant
DOUBTED: list[tuple[str, dict[str, object], str, float, object, list[dict[str, object]]]] = [
    (TWIN, {"engine.rod_mass_g": 300.0}, "engine.inputs.masses", 300 / 420, (0.8, 1.6),
     [{"engine.piston_mass_g": 300, "engine.rod_mass_g": 420}]),
    (TWIN, {"engine.rod_mass_g": 200.0}, "engine.inputs.masses", 200 / 420, (0.8, 1.6), []),
    (TWIN, {"engine.crank_radius_mm": 18.5, "engine.rated_speed_rpm": 344.0}, "engine.inputs.piston_speed",
     4 * 0.0185 * 344 / 60, (4.0, 30.0), [{"engine.rated_speed_rpm": 3284.96}, {"engine.rated_speed_rpm": 20640}]),
    (TWIN, {"engine.rated_speed_rpm": 1077.0}, "engine.inputs.piston_speed", 4 * 0.043 * 1077 / 60, (4.0, 30.0),
     [{"engine.rated_speed_rpm": 10284.6}]),
    (SIZED, {"engine.rod_length_mm": 64.5}, "engine.inputs.crank_ratio", 53.5 / 64.5, (0.15, 0.42),
     [{"engine.crank_radius_mm": 26.75}]),
    (SIZED, {"engine.rod_length_mm": 360.0}, "engine.inputs.crank_ratio", 53.5 / 360, (0.15, 0.42), []),
    (SIZED, {"engine.bore_mm": 47.0}, "engine.inputs.stroke_ratio", 107 / 47, (0.4, 1.8), [{"engine.bore_mm": 94}]),
    (SIZED, {"engine.bore_mm": 300.0}, "engine.inputs.stroke_ratio", 107 / 300, (0.4, 1.8), []),
    (TWIN, {"engine.bore_mm": 23.5}, "engine.inputs.cylinder_pitch", 88 / 23.5, 1.9, [{"engine.bore_mm": 47}]),
    (TWIN, {"engine.bore_mm": 42.9}, "engine.inputs.stroke_ratio", 86 / 42.9, (0.4, 1.8), [{"engine.bore_mm": 85.8}]),
    (SIZED, {"engine.rod_cg_to_big_end_mm": 83.13}, "engine.inputs.rod_cg", 0.51, (0.1, 0.5),
     [{"engine.rod_cg_to_big_end_mm": 79.87}]),
    (SIZED, {"engine.rod_cg_to_big_end_mm": 145.07}, "engine.inputs.rod_cg", 0.89, (0.1, 0.5),
     [{"engine.rod_cg_to_big_end_mm": 17.93}]),
    (BLOCK, {"engine.crank_angles_deg": [0.0, 3.14159, -3.14159, 0.0]}, "engine.inputs.crank_angles", 3.14159,
     2 * math.pi, [{"engine.crank_angles_deg": [0, 180, -180, 0]}]),
    # power over displacement and cycles a second
    (SIZED, {"engine.rated_power_kW": 160.0}, "engine.inputs.rated_power",
     160e3 / (3 * math.pi / 4 * 0.094**2 * 0.107 * 2600 / 120) / 1e5, (1.5, 32.0), [{"engine.rated_power_kW": 117.68}]),
    (TWIN, {"engine.bore_mm": 50.0, "engine.crank_radius_mm": 25.0, "engine.rated_speed_rpm": 3000.0,
            "engine.piston_mass_g": 120.0, "engine.rod_mass_g": 150.0, "engine.rated_power_kW": 1000.0},
     "engine.inputs.rated_power", 1e6 / (2 * math.pi / 4 * 0.05**2 * 0.05 * 3000 / 120) / 1e5, (1.5, 32.0),
     [{"engine.rated_power_kW": 1}]),
    (SET, {"engine.gas.intake_pressure_bar": 0.23, "engine.gas.peak_pressure_bar": 600.0}, "engine.inputs.gas",
     600 / (0.23 * 16.5**1.35), 6.0, [{"engine.gas.intake_pressure_bar": 2.3}]),
    (SET, {"engine.gas.intake_pressure_bar": 0.225, "engine.gas.peak_pressure_bar": 600.0}, "engine.inputs.gas",
     600 / (0.225 * 16.5**1.35), 6.0, []),
    (SET, {"engine.gas.intake_pressure_bar": None, "engine.gas.peak_pressure_bar": 280.0}, "engine.inputs.gas",
     280 / 16.5**1.35, 6.0, []),
    (SIZED, {"bearings.front.diameter_mm": 18.5}, "bearings.inputs.front.core", 18.5 / 36, 1.0,
     [{"bearings.front.diameter_mm": 37}]),
    (SIZED, {"bearings.front.diameter_mm": 17.5, "bearings.front.length_mm": 30.0}, "bearings.inputs.front.core",
     17.5 / 36, 1.0, []),
    (TWIN, {"bearings.front.length_mm": 5.6}, "bearings.inputs.front.length", 0.07, (0.15, 2.0),
     [{"bearings.front.length_mm": 56}, {"bearings.front.length_mm": 142.24}]),
    (TWIN, {"bearings.front.length_mm": 0.12, "bearings.front.diameter_mm": 160.0, "bearings.hole_diameter_mm": 0.1},
     "bearings.inputs.front.length", 0.00075, (0.15, 2.0), [{"bearings.front.length_mm": 120}]),
    (TWIN, {"bearings.rear.diameter_mm": 8.0}, "bearings.inputs.rear.length", 7.0, (0.15, 2.0),
     [{"bearings.rear.diameter_mm": 80}, {"bearings.rear.diameter_mm": 203.2}]),
    (TWIN, {"bearings.front.clearance_um": 0.2}, "bearings.inputs.front.clearance", 0.0025, (0.2, 10.0),
     [{"bearings.front.clearance_um": 200}]),
    (TWIN, {"bearings.front.clearance_um": 12.0}, "bearings.inputs.front.clearance", 0.15, (0.2, 10.0),
     [{"bearings.front.clearance_um": 120}]),
    (TWIN, {"bearings.rear.clearance_um": 1600.0}, "bearings.inputs.rear.clearance", 1600 / 88.5, (0.2, 10.0),
     [{"bearings.rear.clearance_um": 160}]),
    (TWIN, {"bearings.front.load_N": 40.0}, "bearings.inputs.front.load", 40 / (80 * 56), (0.01, 150.0),
     [{"bearings.front.load_N": 40000}]),
    (TWIN, {"bearings.front.load_N": 5.0}, "bearings.inputs.front.load", 5 / (80 * 56), (0.01, 150.0),
     [{"bearings.front.load_N": 5000}]),
    (TWIN, {"bearings.front.load_N": 700e3}, "bearings.inputs.front.load", 700e3 / (80 * 56), (0.01, 150.0), []),
    (SIZED, {"bearings.supply_pressure_bar": 0.4}, "bearings.inputs.supply_pressure", 0.4, 1.0,
     [{"bearings.supply_pressure_bar": 4}]),
    (SIZED, {"bearings.viscosity_mPas": 0.012}, "bearings.inputs.viscosity", 0.012, (0.5, 2000.0),
     [{"bearings.viscosity_mPas": 12}]),
    (SIZED, {"bearings.viscosity_mPas": 12e3}, "bearings.inputs.viscosity", 12e3, (0.5, 2000.0),
     [{"bearings.viscosity_mPas": 12}]),
    (TWIN, {"gears.face_width_mm": 1.9}, "gears.inputs.face_width", 0.76, (2.0, 60.0), [{"gears.face_width_mm": 19}]),
    (TWIN, {"gears.face_width_mm": 160.0}, "gears.inputs.face_width", 64.0, (2.0, 60.0), []),
    (TWIN, {"gears.wheels.crank.face_width_mm": 1.9}, "gears.inputs.crank.face_width", 0.76, (2.0, 60.0),
     [{"gears.wheels.crank.face_width_mm": 19}]),
    (SIZED, {"gears.power_kW": 400.0}, "gears.inputs.power", 8.0, 1.0, [{"gears.power_kW": 0.4}]),
    (SIZED, {"gears.power_kW": 50100.0}, "gears.inputs.power", 1002.0, 1.0, []),
    (SET, {"mounting.mass_kg": 88.0}, "mounting.inputs.mass", 88 / (math.pi * 0.115**2 * 0.142), (15e3, 1e6), []),
    (SET, {"mounting.mass_kg": 1.15}, "mounting.inputs.mass", 1.15 / (math.pi * 0.115**2 * 0.142), (15e3, 1e6),
     [{"mounting.mass_kg": 1150}]),
    (SET, {"mounting.mass_kg": 9e5}, "mounting.inputs.mass", 9e5 / (math.pi * 0.115**2 * 0.142), (15e3, 1e6),
     [{"mounting.mass_kg": 900}]),
    (SET, {"mounting.inertia_kgm2": [290e4, 300e4, 62e4]}, "mounting.inputs.inertia", 1e5 * math.sqrt(300 / 1150),
     (30.0, 3000.0), [{"mounting.inertia_kgm2": [2900, 3000, 620]}, {"mounting.inertia_kgm2": [290, 300, 62]},
                      {"mounting.inertia_kgm2": [2.9, 3, 0.62]}]),
    (SET, {"mounting.inertia_kgm2": [0.29, 0.3, 0.062], "mounting.inertia_coupling_kgm2": None},
     "mounting.inputs.inertia", 1e3 * math.sqrt(0.062 / 1150), (30.0, 3000.0), []),
    (SET, {f"mounting.mounts.{n}.stiffness_N_mm": [620e3, 260e3, 260e3] for n in range(6)},
     "mounting.inputs.stiffness", STIFF * math.sqrt(1000), (1.0, 100.0), []),
    # one number by itself: a unit, a digit, an inch; of three readings the first two
    (SIZED, {"engine.bore_mm": 3.7}, "engine.inputs.bore_mm", 3.7, (50.0, 150.0), [{"engine.bore_mm": 93.98}]),
    (TWIN, {"gears.wheels.central.bore_diameter_mm": 0.5}, "gears.inputs.wheels.central.bore_diameter_mm", 0.5,
     (5.0, 500.0), [{"gears.wheels.central.bore_diameter_mm": 500}, {"gears.wheels.central.bore_diameter_mm": 5}]),
    (TWIN, {"gears.wheels.central.bore_diameter_mm": 1.5}, "gears.inputs.wheels.central.bore_diameter_mm", 1.5,
     (5.0, 500.0), [{"gears.wheels.central.bore_diameter_mm": 15}, {"gears.wheels.central.bore_diameter_mm": 38.1}]),
    (SIZED, {"engine.rated_speed_rpm": 272.3}, "engine.inputs.rated_speed_rpm", 272.3, (1000.0, 13000.0),
     [{"engine.rated_speed_rpm": 272.3 * 30 / math.pi}, {"engine.rated_speed_rpm": 2723}]),
    (SIZED, {"engine.rated_speed_rpm": 43.33}, "engine.inputs.rated_speed_rpm", 43.33, (1000.0, 13000.0),
     [{"engine.rated_speed_rpm": 2599.8}]),
    (SIZED, {"engine.rated_speed_rpm": 5.0}, "engine.inputs.rated_speed_rpm", 5.0, (1000.0, 13000.0),
     [{"engine.rated_speed_rpm": 5000}]),
    (TWIN, {"gears.helix_angle_deg": 0.349066}, "gears.inputs.helix_angle_deg", 0.349066, math.radians(30),
     [{"gears.helix_angle_deg": 20}]),
    (TWIN, {"countershaft.overdesign_percent": 0.015}, "countershaft.inputs.overdesign_percent", 0.015, 0.05,
     [{"countershaft.overdesign_percent": 1.5}]),
    (SIZED, {"bearings.front.clearance_factor": 6.1}, "bearings.inputs.front.clearance_factor", 6.1, (0.4, 0.8),
     [{"bearings.front.clearance_factor": 0.61}]),
    (MOUNTED, {"mounting.mounts.engine.loss_factor": 0.0009}, "mounting.inputs.mounts.engine.loss_factor", 0.0009,
     (0.03, 0.2), [{"mounting.mounts.engine.loss_factor": 0.09}]),
    (MOUNTED, {"mounting.mounts.engine.loss_factor": 0.0001}, "mounting.inputs.mounts.engine.loss_factor", 0.0001,
     (0.03, 0.2), [{"mounting.mounts.engine.loss_factor": 0.1}]),
    (GAMMA, {"countershaft.material": "ADI", "material.0.expansion_1e6_K": 1.4},
     "countershaft.inputs.material.ADI.expansion_1e6_K", 1.4, (5.0, 30.0), [{"material.ADI.expansion_1e6_K": 14}]),
    # lists: what is furthest outside, and all numbers in one unit
    (SIZED, {"bearings.slope_mrad": [0.1, 1.5]}, "bearings.inputs.rear.slope_mrad", 1.5, (0.0, 0.25),
     [{"shafts.shaft.bearings.rear.slope_mrad": 0.0015}, {"shafts.shaft.bearings.rear.slope_mrad": 0.15}]),
    (SIZED, {"bearings.slope_mrad": [0.3, 0.0001]}, "bearings.inputs.rear.slope_mrad", 0.0001, 0.00025,
     [{"shafts.shaft.bearings.rear.slope_mrad": 0.1}]),
    (TWIN, {"gears.wheels.crank.span_allowance_um": [-0.03, -0.04]}, "gears.inputs.wheels.crank.span_allowance_um",
     -0.03, (-80.0, -20.0), [{"gears.wheels.crank.span_allowance_um": [-30, -40]}]),
]  # fmt: skip


@pytest.mark.parametrize(("name", "changes", "id", "value", "limit", "meant"), DOUBTED)
def test_what_may_have_been_meant(
    name: str, changes: dict[str, object], id: str, value: float, limit: object, meant: list[dict[str, object]]
) -> None:
    document = changed(name, changes)
    (check,) = (x for x in doubts(design(document), id.partition(".")[0]) if x.id == id)
    assert check.value == pytest.approx(value) and check.limit == pytest.approx(limit)
    assert not check.holds and check.source
    assert [dict(way.changes) for way in check.remedies] == [
        {current(document.data, key): pytest.approx(x, rel=1e-5) for key, x in way.items()} for way in meant
    ]
    assert str(check.advice).startswith("Did you mean ") is bool(meant)


@pytest.mark.parametrize(
    ("name", "changes"),
    [
        (SIZED, {"engine.crank_angles_deg": [0.0, 0.0, 0.0]}),  # pins in line, not radians
        (TWIN, {"engine.rod_mass_g": 0.0}),  # a rod that is left out
        (TWIN, {"gears.power_kW": 10.0}),  # of an engine whose power is not known
    ],
)
def test_what_says_nothing_is_not_doubted(name: str, changes: dict[str, object]) -> None:
    assert all_doubts(design(changed(name, changes))) == []


def test_only_cylinders_in_a_row_have_a_pitch_to_doubt() -> None:
    twin = design(changed(TWIN, {})).engine
    assert twin is not None
    far = replace(twin, cylinder_pitch=0.19)
    one, vee = replace(far, cylinders=1), replace(far, layout="vee", bank_angle=math.pi / 2, crank_angles=(0.0, 0.0))
    found = [doubts(Design(schema=1, name="twin", engine=engine), "engine") for engine in (far, one, vee)]
    assert [[check.id for check in checks] for checks in found] == [["engine.inputs.cylinder_pitch"], [], []]


@pytest.mark.parametrize(("good", "bad"), [(100.0 - 1, 100.0 + 1), (1.01, 0.99)])
def test_mounts_that_do_not_carry_their_mass_are_doubted(good: float, bad: float) -> None:
    """By the frequency at which the mass stands on them, in Hz."""

    def ids(frequency: float) -> list[str]:
        stiffness = [x * (frequency / STIFF) ** 2 for x in (620.0, 260.0, 260.0)]
        mounts: dict[str, object] = {f"mounting.mounts.{n}.stiffness_N_mm": stiffness for n in range(6)}
        return [check.id for check in doubts(design(changed(SET, mounts)), "mounting")]

    assert ids(good) == [] and ids(bad) == ["mounting.inputs.stiffness"]


@pytest.mark.parametrize(("good", "bad"), [(0.0168, 0.0165), (34.4, 34.6)])
def test_an_inertia_that_does_not_fit_its_mass_is_doubted(good: float, bad: float) -> None:
    def ids(share: float) -> list[str]:
        inertia = [290.0 * share, 300.0 * share, 62.0 * share]
        scaled = {"mounting.inertia_kgm2": inertia, "mounting.inertia_coupling_kgm2": [0.0, 0.0, 14.0 * share]}
        return [check.id for check in doubts(design(changed(SET, scaled)), "mounting")]

    assert ids(good) == [] and ids(bad) == ["mounting.inputs.inertia"]


def test_a_material_of_the_design_is_doubted_where_it_is_used() -> None:
    steel = changed(GAMMA, {"countershaft.material": "ADI", "material.0.expansion_1e6_K": 1.4e-5})
    (check,) = doubts(design(steel), "countershaft")
    assert check.id == "countershaft.inputs.material.ADI.expansion_1e6_K"
    assert dict(check.remedies[0].changes) == {"material.ADI.expansion_1e6_K": pytest.approx(14.0)}
    assert doubts(design(steel), "gears") == ()


def test_what_is_far_outside_is_doubted_once() -> None:
    """The other checks that it falls through as well would only say the same, and mean other things."""
    found = doubts(design(changed(SIZED, {"engine.bore_mm": 0.094})), "engine")
    assert [check.id for check in found] == ["engine.inputs.bore_mm"]


# --- where it stands, and what it counts


def test_it_stands_first_counts_and_can_be_accepted() -> None:
    wrong: dict[str, object] = {"engine.bore_mm": 9.4}
    results = solved(SIZED, wrong)
    first = grouped(results.checks())[0]
    assert first[0].id == "engine.inputs.bore_mm"
    assert str(first[0]).startswith("▲ Far from usual: bore: 9.4 mm (50 to 150 mm")
    engine = results.outcomes["engine"]
    assert (engine.verdict, engine.counts.cautions) == ("warn", 1)
    assert results.counts.cautions == solved(SIZED, {}).counts.cautions + 1
    accepted = solved(SIZED, wrong | {"accepted": {first[0].id: "a model engine"}})
    assert accepted.outcomes["engine"].verdict == "computed"
    assert "no such check" not in " ".join(map(str, accepted.outcomes["engine"].notes))


def test_it_stands_before_a_limit_that_fails() -> None:
    gamma = solved(GAMMA, {"bearings.supply_pressure_bar": 0.4})
    assert gamma.verdict == "fail"
    assert grouped(gamma.checks())[0][0].id == "bearings.inputs.supply_pressure"
    assert gamma.outcomes["bearings"].causes[0][0].id == "bearings.inputs.supply_pressure"


def test_a_note_does_not_repeat_it_where_the_step_is_solved() -> None:
    wrong = changed(SIZED, {"engine.bore_mm": 9.4, "engine.rated_speed_rpm": 900.0})
    asked = design(wrong)
    assert {"engine.bore_mm", "engine.rated_speed_rpm"} <= {odd.key for odd in unusual(asked)}
    with recorded(False):
        keys = [odd.key for odd in unusual(asked, STEP_KEYS, solve(asked).checks())]
    assert "engine.bore_mm" not in keys and "engine.rated_speed_rpm" in keys


def test_what_is_further_outside_stands_first() -> None:
    """By the widths of the ranges, and of a list by the number furthest outside; of more than four the rest counts."""
    changes: dict[str, object] = {
        "engine.bore_mm": 200.0,
        "engine.rod_length_mm": 74.5,
        "bearings.slope_mrad": [0.1, 0.35],
        "bearings.front.clearance_factor": 0.82,
        "bearings.front.journal_roughness_um": 1.01,
    }
    outliers = unusual(design(changed(SIZED, changes)))
    assert [(x.key, x.number, x.beyond, x.far) for x in outliers] == [
        ("engine.bore_mm", pytest.approx(200.0), pytest.approx(50 / 100), False),
        (f"{ROWS}.rear.slope_mrad", pytest.approx(0.35), pytest.approx(0.1 / 0.25), False),
        (f"{ROWS}.front.journal_roughness_um", pytest.approx(1.01), pytest.approx(0.21 / 0.7), False),
        (f"{ROWS}.front.clearance_factor", pytest.approx(0.82), pytest.approx(0.02 / 0.4), False),
        ("engine.rod_length_mm", pytest.approx(74.5), pytest.approx(5.5 / 220), False),
    ]
    assert str(told(outliers)).startswith("5 inputs are not usual: ") and str(told(outliers)).endswith("; 1 more")
    assert "more" not in str(told(outliers[:4]))


@pytest.mark.parametrize(("numbers", "furthest"), [([-10.0, -110.0], -110.0), ([10.0, -95.0], 10.0)])
def test_of_a_list_the_number_furthest_outside_is_shown(numbers: list[float], furthest: float) -> None:
    """Usual: -80 to -20."""
    (outlier,) = unusual(design(changed(TWIN, {"gears.wheels.crank.span_allowance_um": numbers})))
    assert (outlier.number, outlier.beyond, outlier.far) == (pytest.approx(furthest), pytest.approx(30 / 60), False)


def test_the_doubts_of_a_step_stand_before_its_other_checks() -> None:
    asked = design(changed(SIZED, {"engine.bore_mm": 9.4}))
    (doubt,) = doubts(asked, "engine")
    others = doubts(design(changed(SIZED, {"engine.rod_length_mm": 360.0})), "engine")
    outcomes = [Outcome("engine", state, checks=others) for state in ("solved", "no_solution", "blocked")]
    ids = [[check.id for check in outcome.checks] for outcome in with_doubts(asked, outcomes)]
    assert ids == [[doubt.id, others[0].id], [doubt.id, others[0].id], [others[0].id]]
