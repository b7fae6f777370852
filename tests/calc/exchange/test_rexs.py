"""A model of REXS: what the given file has in which order, its numbers against the design's, every kind of shaft,
bearing and drive, and that a file which is none is refused."""

import json
import math
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from calc.design.toml_file import design, load, parse
from calc.exchange.rexs import Rexs, has_parts, rexs
from calc.exchange.rexs_file import Component, FaultyFile, RexsModel, faults, file_of, pose
from calc.sheet.errors import BadInput
from calc.sheet.value import recorded
from calc.solve import Results, solve
from tests.conftest import DESIGNS, GAMMA, each_shipped

DATA = Path(__file__).parent / "data"
PAIR, ROLLING = DESIGNS / "r754ie4_balance_shafts.toml", DESIGNS / "r753ie4_rolling.toml"
MOUNTED, TRAIN = DESIGNS / "r753ie4_mounting.toml", DESIGNS / "timing_pair.toml"
AS_GIVEN = """
[[material]]
name = "20CrNi4"
E_GPa = 206.0
density_kgm3 = 7860.0
expansion_1e6_K = 11.5
"""
OTHERWISE = (
    ("angle_deg = 180.0", "angle_deg = 150.0"),
    ('supply = "hole"', 'supply = "shaft"'),
    ('shaft = "left"\n', 'shaft = "left"\nmaterial = "EN-GJL-250"\n'),
)


def solved(text: str) -> Results:
    with recorded(False):
        return solve(design(parse(text.encode(), "x.toml")), compared=False)


@cache
def of(path: Path, *changes: tuple[str, str], more: str = "") -> tuple[Results, Rexs]:
    """The results and the model of a design with some of its lines otherwise."""
    text = path.read_text(encoding="utf-8")
    for old, new in changes:
        assert text.count(old), old
        text = text.replace(old, new)
    results = solved(text + more)
    return results, rexs(results)


def gamma() -> Rexs:
    return of(GAMMA, more=AS_GIVEN)[1]


def named(model: Rexs, kind: str, name: str) -> Component:
    (found,) = (one for one in model.model.of_kind(kind) if one.name == name)
    return found


def read(file: bytes) -> tuple[list[Any], list[Any]]:
    """Components and relations of a file, without the attributes."""
    root = ElementTree.fromstring(file)
    components = [(one.get("id"), one.get("type"), one.get("name")) for one in root.iter("component")]
    relations = [
        (one.get("id"), one.get("type"), [(ref.get("id"), ref.get("role"), ref.get("hint")) for ref in one])
        for one in root.iter("relation")
    ]
    return components, relations


def attributes(file: bytes) -> dict[tuple[str, str, str], Any]:
    """By kind and name of the component and id: unit and content of each attribute."""
    found = {}
    for component in ElementTree.fromstring(file).iter("component"):
        for one in component:
            content = [part.text for part in one.iter("c")] or one.text
            found[component.get("type") or "", component.get("name") or "", one.get("id") or ""] = (
                one.get("unit"),
                content,
            )
    return found


# --- the file that is given


def test_components_and_relations_are_those_of_the_given_file():
    components, relations = read((DATA / "rexs_gamma.rexs").read_bytes())
    ours = read(gamma().file())
    # the material of the wheels' own shafts was typed in there; the design leaves it at steel
    assert ours[0] == [(id, kind, "steel" if id in ("5", "9", "13") else name) for id, kind, name in components]
    assert ours[1] == relations


def test_units_are_those_of_the_given_file():
    ours, theirs = attributes(gamma().file()), attributes((DATA / "rexs_gamma.rexs").read_bytes())
    both = [key for key in theirs if key in ours]
    assert len(both) > 250 and not [key for key in theirs if key not in ours and key[0] != "material"]
    assert [ours[key][0] for key in both] == [theirs[key][0] for key in both]


def given(row: Mapping[str, Any]) -> float:
    model, words = gamma(), row["quantity"].removeprefix("REXS: ")
    if words.startswith("number of"):
        return len(model.model.components if "components" in words else model.model.relations)
    if words.startswith("sum of"):
        return sum(float(one.attributes["mass_of_component"]) for one in model.model.of_kind("additional_mass"))
    kind, name, rest = words.split("'")[0].strip(), words.split("'")[1], words.split("'")[2].split()
    content = attributes(model.file())[kind, name, rest[0]][1]
    return float(content["uvw".index(rest[1])] if len(rest) > 1 else content)


ROWS = json.loads((DATA / "rexs.json").read_text(encoding="utf-8"))["given"]


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["quantity"])
def test_given_value(row):
    assert given(row) == pytest.approx(row["is"], rel=row["rel"])


UNITS = {
    ("gear_casing", "engine block", "temperature_lubricant"): ("C", 120.0),
    ("lubricant", "10W-40 Q8 T905", "viscosity_at_40_degree_celsius"): ("mm^2 / s", 95.7),
    ("lubricant", "10W-40 Q8 T905", "density_at_15_degree_celsius"): ("kg / dm^3", 0.86),
    ("material", "20CrNi4", "elastic_modulus"): ("N / mm^2", 206000.0),
    ("material", "20CrNi4", "density"): ("kg / dm^3", 7.86),
    ("material", "20CrNi4", "thermal_expansion_coefficient_plus"): ("1e-6 / C", 11.5),
    ("hydrodynamic_radial_plain_bearing", "front", "feed_pressure_plain_bearing"): ("N / mm^2", 0.4),
    ("cylindrical_gear", "central", "lower_backlash_allowance_referenced_to_span"): ("mum", -20.0),
    ("cylindrical_gear", "idler", "arithmetic_average_roughness_flank"): ("mum", 0.8),
    ("cylindrical_gear", "crank", "helix_angle_reference_diameter"): ("deg", 21.916),
    ("cylindrical_gear", "central", "helix_angle_reference_diameter"): ("deg", -21.916),
    ("cylindrical_stage", "idler_shaft", "lower_center_distance_allowance"): ("mum", 55.0),
    ("cylindrical_stage", "idler_shaft", "center_distance"): ("mm", 68.698),
}  # fmt: skip
RESULTS = {  # in the unit of the file over that in which the program shows it
    ("hydrodynamic_radial_plain_bearing", "rear", "lubricant_flow_through_bearing"): ("bearings.rear.oil_flow", 1.0),
    ("hydrodynamic_radial_plain_bearing", "rear", "diameter_clearance_plain_bearing"): ("bearings.rear.clearance", 1.0),
    ("hydrodynamic_radial_plain_bearing", "rear", "relative_eccentricity_plain_bearing"): ("bearings.rear.eccentricity", 1.0),
    ("cylindrical_stage", "central_idler", "minimum_normal_backlash"): ("gears.central_idler.backlash_min", 1e-3),
    ("cylindrical_stage", "central_idler", "total_contact_ratio"): ("gears.central_idler.total_contact_ratio", 1.0),
    ("cylindrical_gear", "shaft", "root_form_diameter"): ("gears.shaft.form_diameter", 1.0),
    ("external_load", "crank drive", "torque_around_u_axis"): ("friction.crank_torque", 1.0),
    ("shaft", "shaft", "mass_of_component"): ("countershaft.mass", 1.0),
}  # fmt: skip


def test_numbers_stand_in_their_units():
    results, model = of(GAMMA, more=AS_GIVEN)
    written, values = attributes(model.file()), results.values()
    for key, (unit, number) in UNITS.items():
        assert written[key][0] == unit and float(written[key][1]) == pytest.approx(number), key
    for key, (id, factor) in RESULTS.items():
        assert float(written[key][1]) == pytest.approx(values[id].shown * factor, rel=1e-9), key


# --- masses


WITH_EXTRA = (
    '[[shafts]]\nname = "left"',
    '[[shafts]]\nname = "left"\nsector_material = "tungsten"\nbore_diameter_mm = 8.0',
)
TUNGSTEN = '\n[[material]]\nname = "tungsten"\nE_GPa = 350.0\ndensity_kgm3 = 17500.0\nexpansion_1e6_K = 5.0\n'
EXTRA = (
    "# assumed: the outline; the sectors",
    '[[shafts.extras]]\nname = "pin"\nmass_kg = 0.02\nradius_mm = 9.0\nangle_deg = 30.0\nz_mm = 115.0\n# the sectors',
)


@pytest.mark.parametrize(
    "model",
    [
        pytest.param(lambda: of(GAMMA, more=AS_GIVEN), id="gamma"),
        pytest.param(lambda: of(PAIR), id="two shafts"),
        pytest.param(lambda: of(PAIR, WITH_EXTRA, EXTRA, more=TUNGSTEN), id="hollow, heavier sectors, an extra mass"),
        pytest.param(
            lambda: of(PAIR, ("half_angle_deg = 85.1\nangle_deg = 180.0\n", ""), ("core_radius_mm = 10.0\n", "")),
            id="plain",
        ),
    ],
)
def test_sections_and_additional_masses_weigh_what_the_shaft_does(model):
    results, written = model()
    parts: dict[int, float] = {}
    for relation in written.model.relations:
        part = relation.parts.get("part")
        if part is None or part.kind not in ("shaft_section", "additional_mass"):
            continue
        shaft, mass = relation.parts["assembly"], part.attributes.get("mass_of_component")
        if mass is None:
            d, d_i, l = (part.attributes[x] for x in ("outer_diameter_begin", "inner_diameter_begin", "length"))
            (material,) = (
                other.parts["referenced"] for other in written.model.relations if other.parts.get("origin") == shaft
            )
            mass = material.attributes["density"] * math.pi / 4 * (d**2 - d_i**2) * l
        parts[shaft.number] = parts.get(shaft.number, 0.0) + mass
    shafts = {
        shaft.number: shaft.attributes["mass_of_component"]
        for shaft in written.model.of_kind("shaft")
        if "mass_of_component" in shaft.attributes
    }
    assert len(shafts) == len(results.design.resolved)
    for shaft, mass in shafts.items():
        assert parts[shaft] == pytest.approx(mass, rel=1e-12)


def test_moments_of_a_sector_are_about_its_axes_on_the_shaft():
    """Against a sum over small cells: nobody has to add the eccentricity once more."""
    results, written = of(PAIR)
    sector = written.model.of_kind("additional_mass")[0]
    piece = next(p for p in results.view("left").shaft.outline.pieces if p.half_angle)
    n = 400
    r = piece.core_radius + (np.arange(n) + 0.5) / n * (piece.outer_radius - piece.core_radius)
    phi = piece.angle + ((np.arange(n) + 0.5) / n * 2 - 1) * piece.half_angle
    cell = r[:, None] * (piece.outer_radius - piece.core_radius) / n * 2 * piece.half_angle / n
    v, w = r[:, None] * np.cos(phi), r[:, None] * np.sin(phi)
    rho, l = results.design.materials["42CrMo4"].density, piece.length
    mass = (cell * np.ones_like(v)).sum() * rho * l
    wanted = {
        "mass_of_component": mass,
        "moment_of_inertia_u_axis": ((v**2 + w**2) * cell).sum() * rho * l,
        "moment_of_inertia_v_axis": (w**2 * cell).sum() * rho * l + mass * l**2 / 12,
        "moment_of_inertia_w_axis": (v**2 * cell).sum() * rho * l + mass * l**2 / 12,
    }
    for id, value in wanted.items():
        assert sector.attributes[id] == pytest.approx(value, rel=1e-4), id
    assert sector.attributes["eccentricity_vector"][1] == pytest.approx((v * cell).sum() * rho * l / mass, rel=1e-4)


# --- turned the other way, twins, bearings, drives


def test_an_anticlockwise_engine_is_written_in_right_handed_axes():
    """v = X is up, w = Y the opposite of the design's side; speeds and torques change their sign, hands do not."""
    turn = "\n[mounting]", '\n[mounting]\nrotation_seen_from_front = "anticlockwise"'
    there, back = attributes(of(MOUNTED)[1].file()), attributes(of(MOUNTED, turn)[1].file())
    assert there.keys() == back.keys()
    for key, (_, content) in there.items():
        other = back[key][1]
        if key[2] in ("rotational_speed", "torque", "torque_around_u_axis", "direction_vector_gravity_w"):
            assert float(other) == -float(content) or float(content) == 0
        elif key[2] in ("support_vector", "eccentricity_vector"):
            u, v, w = map(float, content)
            assert [float(x) for x in other] == [u, v, -w]
        else:
            assert other == content, key
    assert float(there["cylindrical_gear", "crank", "helix_angle_reference_diameter"][1]) != 0


def test_a_mirrored_shaft_has_its_own_angles_and_place():
    results, written = of(PAIR, *OTHERWISE)
    masses = written.model.of_kind("additional_mass")
    (_, v, w), (_, v_m, w_m) = (masses[n].attributes["eccentricity_vector"] for n in (0, 2))
    assert w > 0 and (v_m, w_m) == (v, pytest.approx(-w))
    left, right = (named(written, "shaft", name) for name in ("left", "right"))
    assert right.attributes["rotational_speed"] == -left.attributes["rotational_speed"] == -100.0
    (u, v, w), (u_m, v_m, w_m) = (shaft.attributes["support_vector"] for shaft in (left, right))
    assert (u_m, v_m, w_m) == (u, v, -w) and results.design.shafts[0].axis == (v, w)
    assert [one.name for one in written.model.of_kind("hydrodynamic_radial_plain_bearing")][2:4] == [
        "left rear",
        "right front",
    ]


def test_rolling_bearings():
    model = of(ROLLING)[1]
    front = named(model, "rolling_bearing_with_catalog_geometry", "front").attributes
    assert front["catalogue_designation"] == "6207" and front["bearing_type"] == "radial_grooved_ball_bearing"
    assert front["axial_force_absorption"] == "both_directions"
    written = attributes(model.file())
    key = "rolling_bearing_with_catalog_geometry", "front"
    assert written[*key, "outer_diameter"] == ("mm", "72.0")
    unit, rating = written[*key, "radial_dynamic_load_rating"]
    assert unit == "kN" and 20 < float(rating) < 30


def test_shells_with_a_groove():
    """All round, or from and to angles from the load, which turns: these are left out and named."""
    shells = "clearance_um = 40.0", 'clearance_um = 40.0\nseat = "shells"\nwall_mm = [1.5, 1.51]'
    round_ = 'supply = "hole"  ', 'supply = "groove"\ngroove_width_mm = 4.0 '
    model = of(PAIR, shells, round_, ("hole_diameter_mm = 4.0", ""))[1]
    groove = model.model.of_kind("radial_plain_bearing_groove")[0].attributes
    assert (groove["width"], groove["starting_angle_plain_bearing_feature"]) == (0.004, 0.0)
    assert attributes(model.file())["radial_plain_bearing_groove", "oil groove", "end_angle_plain_bearing_feature"] == (
        "deg",
        "360.0",
    )
    arc = 'supply = "hole"  ', 'supply = "groove"\ngroove_width_mm = 4.0\ngroove_arc_deg = [90.0, 270.0] '
    model = of(PAIR, arc, ("hole_diameter_mm = 4.0", ""))[1]
    assert "end_angle_plain_bearing_feature" not in model.model.of_kind("radial_plain_bearing_groove")[0].attributes
    assert any("angles from the load" in note for note in model.notes)


def test_oil_through_the_shaft_comes_from_inside():
    model = of(PAIR, *OTHERWISE)[1]
    assert {one.attributes["lubricant_side"] for one in model.model.of_kind("radial_plain_bearing_hole")} == {
        "inner_side"
    }


CHAINED = (
    'driver = "crank"\ndriven = "right-first"\ntolerance_um = 40\n',
    'driver = "right-first"\ndriven = "right-second"\ntolerance_um = 40\nscissor = { torque_Nm = 3.0 }\n\n[[gears.stages]]\n'
    'name = "chain"\nkind = "chain"\ndriver = "crank"\ndriven = "right-first"\ndriver_teeth = 40\ndriven_teeth = 20\nside = "inner"\n'
    "pitch_mm = 8.0\n",
)


def test_a_chain_and_a_split_wheel_are_named():
    again = (
        '\n[[gears.meshes]]\ndriver = "right-first"\ndriven = "right-second"\ntolerance_um = 40\n\n[[gears.meshes]]',
        "\n[[gears.meshes]]",
    )
    turned = (
        'mirrors = "left"                # its mirror image, turning the other way',
        'repeats = "left"\naxis_mm = [-60.0, 95.0]',
    )
    results, model = of(PAIR, again, CHAINED, turned)
    assert any(note.startswith("chain: ") for note in model.notes)
    assert any("without its spring" in note for note in model.notes)
    heads = {one.name: one.attributes["defines_speed"] for one in model.model.of_kind("shaft")}
    assert [name for name, first in heads.items() if first] == ["crank", "right-first"]
    assert len(model.model.of_kind("cylindrical_stage")) == len(results.train.meshes) == 4
    assert not list(faults(model.file()))


def test_shafts_on_chains_alone():
    """Where their axes say; where these are not known, in a row.  The crank has no wheel, and so no shaft."""
    text = PAIR.read_text(encoding="utf-8")
    head, rest = text.split("[[gears.wheels]]", 1)
    chains = "".join(
        f'[[gears.stages]]\nname = "to-{name}"\nkind = "chain"\ndriver = "crank"\ndriven = "{name}"\ndriver_teeth = 40\n'
        f'driven_teeth = 20\nside = "{side}"\npitch_mm = 8.0\n'
        for name, side in (("left", "inner"), ("right", "outer"))
    )
    text = f"{head}{chains}\n[friction]{rest.split('[friction]')[1]}"
    model = rexs(solved(text))
    assert [one.name for one in model.model.of_kind("shaft")] == ["left", "right"]
    assert named(model, "shaft", "right").attributes["support_vector"] == (-0.14, -0.06, 0.095)
    assert any(note.startswith("The crank is left out") for note in model.notes)
    text = "".join(line for line in text.splitlines(keepends=True) if not line.startswith("axis_mm"))
    apart = {one.attributes["support_vector"][1:] for one in rexs(solved(text)).model.of_kind("shaft")}
    assert len(apart) == 2 and (0.0, 0.0) not in apart


def test_wheels_stand_where_z_says():
    """Those in mesh with one of which it is said too."""
    model = of(TRAIN, ("teeth = 38", "teeth = 38\nz_mm = 12.5"))[1]
    assert [one.attributes["support_vector"][0] for one in model.model.of_kind("cylindrical_gear")] == [0.0125, 0.0125]


def test_z_of_a_wheel_on_a_shaft_is_the_shafts():
    with pytest.raises(BadInput, match="gear_z_mm of the shaft"):
        of(PAIR, ('shaft = "left"\nteeth', 'shaft = "left"\nz_mm = 3.0\nteeth'))


def test_a_wheel_of_another_material_than_its_shaft_has_its_own():
    model = of(PAIR, *OTHERWISE)[1]
    (relation,) = (
        one
        for one in model.model.relations
        if one.parts.get("origin", Component(0, "", "", {})).kind == "cylindrical_gear"
    )
    assert relation.parts["origin"].name == "left" and relation.parts["referenced"].name == "EN-GJL-250"


def test_torques_are_passed_on_without_loss_each_with_its_own_sense():
    results, model = of(GAMMA, more=AS_GIVEN)
    for key, mesh in results.train.meshes.items():
        one, two = (
            named(model, "cylindrical_stage_gear_data", f"{name} in {key}").attributes
            for name in (mesh.driver, mesh.driven)
        )
        z = [results.train.wheels[name].teeth for name in (mesh.driver, mesh.driven)]
        assert two["torque"] == pytest.approx(-one["torque"] * z[1] / z[0], rel=1e-12)
        assert one["torque"] * results.train.speeds[mesh.driver] > 0
        assert abs(one["torque"]) == mesh.rating.mean_torque


def test_nothing_to_write():
    assert not has_parts(solve(load(DESIGNS / "makers" / "er6n.toml")[1]))
    assert has_parts(of(TRAIN)[0])


# --- the file


def test_the_same_design_is_the_same_bytes():
    assert rexs(of(GAMMA, more=AS_GIVEN)[0]).file() == rexs(of(GAMMA, more=AS_GIVEN)[0]).file()


@pytest.mark.slow
@pytest.mark.parametrize("path", each_shipped())
def test_each_shipped_design(path):
    results = solve(load(path)[1])
    if has_parts(results):
        assert not list(faults(rexs(results).file()))


def _sabotaged(old: bytes, new: bytes) -> bytes:
    file = gamma().file()
    assert old in file
    return file.replace(old, new, 1)


@pytest.mark.parametrize(
    "old, new, said",
    [
        pytest.param(b'id="length" unit="mm"', b'id="length" unit="m"', "the unit is mm, not m", id="unit"),
        pytest.param(b'id="number_of_teeth"', b'id="teeth"', "teeth is none of its attributes", id="id"),
        pytest.param(b'role="gear_1"', b'role="gear_3"', "gear_3", id="role"),
        pytest.param(b'type="flank"', b'type="flanks"', "there is none of type flanks", id="relation"),
        pytest.param(b">120.0<", b">warm<", "'warm' is no number", id="a word for a number"),
        pytest.param(b">120.0<", b">np.float64(120.0)<", "is no number", id="numpy"),
        pytest.param(b">120.0<", b">nan<", "is no number", id="nan"),
        pytest.param(b">120.0<", b">-300.0<", "out of its range", id="range"),
        pytest.param(b">both_directions<", b">both<", "none of its words", id="word"),
        pytest.param(b'id="support_vector"', b'id="u_axis_vector"', "support_vector is missing", id="pose"),
        pytest.param(b'<component id="5"', b'<component id="4"', "its id stands twice", id="twice"),
        pytest.param(b'<relation id="5"', b'<relation id="4"', "its id stands twice", id="relation twice"),
        pytest.param(b'hint="gear_casing"', b'hint="shaft"', "is a gear_casing, not a shaft", id="hint"),
        pytest.param(b'version="1.7"', b'version="1.6"', "version 1.6", id="version"),
    ],
)  # fmt: skip
def test_a_file_that_is_none_is_told(old, new, said):
    assert any(said in fault for fault in faults(_sabotaged(old, new)))


def test_a_model_that_is_none_is_not_written():
    model = RexsModel()
    model.add("gear_unit", "x", model_name="x", **pose((0.0, 0.0, 0.0)))
    model.add("shaft", "y", defines_speed=True)
    with pytest.raises(FaultyFile, match="support_vector is missing"):
        file_of(model, "2026-01-01T00:00:00+00:00")


def test_what_is_said_of_a_file_stands_at_its_head():
    model = RexsModel()
    model.add("gear_casing", "x", temperature_lubricant=1.0)
    file = file_of(model, "d", ("a -- b", "--->")).decode()
    assert ElementTree.fromstring(file).tag == "model" and file.splitlines()[2].startswith(" a")
    assert "sense of rotation is assumed" in gamma().file().decode().partition("<model")[0]


def test_what_is_not_known_is_left_out():
    model = RexsModel()
    one = model.add("gear_casing", "x", temperature_lubricant=None, name="", width=math.nan, length=np.float64(1.5))
    assert one.attributes == {"length": 1.5}


def test_a_name_with_marks_nobody_sees_is_well_formed():
    model = RexsModel()
    model.add("gear_casing", 'a<b>"&\x01', temperature_lubricant=1.0)
    assert ElementTree.fromstring(file_of(model, "d"))[1][0].get("name") == 'a<b>"&\\u0001'
