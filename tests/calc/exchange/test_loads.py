"""The loads of a design: against values of others, against bodies that turn, and against the engine's own data."""

import json
import math
import tomllib
from functools import cache

import numpy as np
import pytest

from calc.design.predicted import at_speed
from calc.design.toml_file import design, load_design, parse
from calc.exchange.loads import KINDS, default_speeds, loads, variants
from calc.exchange.loads_text import amplitude_and_phase, csv_text, json_text
from calc.exchange.mesh_loads import mesh_orders, meshes, on_driver
from calc.sheet.record import replace
from calc.sheet.value import recorded
from calc.solve import solve
from tests.calc.exchange.loads_table import read, signal
from tests.conftest import DESIGNS, GAMMA, ROOT, each_shipped

GIVEN = json.loads((ROOT / "tests" / "reference" / "loads.json").read_text())["given"]
AT_SPEED = [row for row in GIVEN if "rpm" in row["quantity"]]
OLD = ROOT / "tests" / "reference" / "designs_0_1"
TURN = np.linspace(0, 4 * math.pi, 97)
G = 9.80665


def of_shafts_alone(design):
    return replace(design, gears=None, bearings=None, friction=None)


@cache
def made(name, speeds, variant="shaft", turned="", change=None):
    """The rows in the file, and the design with its results."""
    design = load_design(DESIGNS / f"{name}.toml")
    if turned:
        design = replace(design, mounting=replace(design.mounting, rotation_seen_from_front=turned))
    design = change(design) if change is not None else design
    with recorded(False):
        results = solve(design)
    found = loads(results, [speed / 60 for speed in speeds], variant)
    assert found.closes, found.sums
    return read(csv_text(found, design.name, "")), results, found


@cache
def at(results, speed):
    """The values of the design at that speed."""
    with recorded(False):
        return solve(at_speed(results.design, speed / 60, results.values()), compared=False).values()


def picked(rows, **wanted):
    return [row for row in rows if all(getattr(row, name) == value for name, value in wanted.items())]


# --- values of others


def on_outer_two(design):
    """The first shaft of the pair on its outer bearings alone, as the given values have it."""
    own = design.shafts[0]
    return of_shafts_alone(design.with_shaft(replace(own, bearings=(own.bearings[0], own.bearings[-1]))))


@cache
def given_rows(case):
    name, change, speeds = {
        "gamma": (OLD / "r753ie4_gamma.toml", of_shafts_alone, (900, 2600)),
        "r754_left": (OLD / "r754ie4_balance_shafts.toml", on_outer_two, (3000,)),
    }[case]
    results = solve(change(load_design(name)))
    return read(csv_text(loads(results, [speed / 60 for speed in speeds]), "", ""))


@pytest.mark.parametrize("given", AT_SPEED, ids=lambda given: given["quantity"])
def test_given_values(given):
    speed, place, order, part = (word.strip() for word in given["quantity"].removeprefix("loads:").split(","))
    rows = picked(
        given_rows(given["case"]), kind="bearing", speed=float(speed.split()[0]), order=float(order.split()[1])
    )
    row = next(row for row in rows if row.place.split(".")[-1] == place)
    component = row.force["xy".index(part[2])]
    if "phase" in part:
        assert math.degrees(np.angle(component)) % 360 == pytest.approx(given["is"], abs=given["abs"])
    else:
        assert abs(component) == pytest.approx(given["is"], rel=given["rel"])


def test_given_force_of_the_teeth():
    *_, row = GIVEN
    case = row["case"]
    alpha, beta = math.radians(case["alpha_wt_deg"]), math.radians(case["beta_w_deg"])
    F_t = 2 * case["torque_Nm"] / (case["working_diameter_mm"] * 1e-3)
    gamma = math.radians(case["pitch_point_deg"])
    across, along = on_driver(F_t, F_t * math.tan(alpha), F_t * math.tan(beta), gamma, case["turn"], case["hand"])
    of = {"F_x": across.real, "F_y": across.imag, "F_z": along}
    wanted = {row["quantity"].split()[-2]: row["is"] for row in GIVEN if "pitch point" in row["quantity"]}
    assert of == pytest.approx(wanted, rel=1e-9)


# --- bodies that turn


PAIR = """schema = 2
name = "two shafts at an odd angle"
[engine]
name = "four"
layout = "inline"
cylinders = 4
strokes = 4
bore_mm = 80.0
crank_radius_mm = 40.0
rod_length_mm = 130.0
cylinder_pitch_mm = 90.0
crank_angles_deg = [0.0, 180.0, 180.0, 0.0]
firing_order = [1, 3, 4, 2]
piston_mass_g = 400.0
rod_mass_g = 500.0
rated_speed_rpm = 5000.0
[imbalance]
crank_balance_fraction = 0.5
kinematics = "exact"
[[shafts]]
name = "left"
material = "42CrMo4"
speed_ratio = 2
axis_mm = [-70.0, -90.0]
bearings = [ { name = "front", position_mm = -90.0 }, { name = "rear", position_mm = 70.0 } ]
masses = [
    { name = "one", mass_kg = 0.8, radius_mm = 15.0, angle_deg = 163.0, z_mm = -31.0 },
    { name = "two", mass_kg = 0.5, radius_mm = 11.0, angle_deg = 47.0, z_mm = 52.0 },
]
[[shafts]]
name = "right"
mirrors = "left"
"""
MASSES = ((0.8, 15e-3, 163.0, -31e-3), (0.5, 11e-3, 47.0, 52e-3))


@cache
def pair_rows():
    return read(csv_text(loads(solve(design(parse(PAIR.encode(), "pair.toml"))), (50.0,)), "", ""))


@pytest.mark.parametrize("shaft, sense", [("left", 1.0), ("right", -1.0)])
def test_phasors_are_the_turning_vector(shaft, sense):
    """Forward and backward: every bearing carries by its lever what masses put on it that turn about the axis."""
    omega = 2 * math.pi * 2 * 50.0
    for place, z_B, z_o in (("front", -90e-3, 70e-3), ("rear", 70e-3, -90e-3)):
        (row,) = picked(pair_rows(), place=f"{shaft}.{place}", order=2.0)
        assert row.on == "block"
        wanted = np.zeros((TURN.size, 2))
        for m, r, angle, z in MASSES:
            direction = sense * math.radians(angle) + sense * 2 * TURN  # of the mirror image at minus the angle
            share = (z - z_o) / (z_B - z_o)
            wanted += (omega**2 * m * r * share) * np.stack([np.cos(direction), np.sin(direction)], 1)
        size = np.abs(wanted).max()
        assert np.abs(signal([row], TURN)[:, :2] - wanted).max() < 1e-12 * size
        assert row.at == pytest.approx([-0.07, -0.09 * sense, z_B])


# --- the engine, from its own data


def test_the_engine_from_the_file_alone():
    """Inertia of pistons, of rods as two masses each and of counterweights, over a turn, against the rows."""
    rows, _, _ = made("r753ie4_alpha", (2600,), change=of_shafts_alone)
    engine, imbalance = tomllib.loads((DESIGNS / "r753ie4_alpha.toml").read_text(encoding="utf-8"))["engine"], 0.5
    r, l = engine["crank_radius_mm"] * 1e-3, engine["rod_length_mm"] * 1e-3
    at_piston = engine["rod_cg_to_big_end_mm"] * 1e-3 / l
    m = (engine["piston_mass_g"] + engine["rod_mass_g"] * at_piston) * 1e-3
    omega, N = 2 * math.pi * 2600 / 60, 720
    epsilon = np.arange(N) * 2 * math.pi / N
    fires = {1: 0.0, 3: 240.0, 2: 480.0}
    F, M = np.zeros((N, 3)), np.zeros((N, 3))
    for cylinder, fired in fires.items():
        z = (cylinder - 2) * engine["cylinder_pitch_mm"] * 1e-3
        theta = epsilon - math.radians(fired)
        s, c = np.sin(theta), np.cos(theta)
        root = np.sqrt(l**2 - (r * s) ** 2)
        x = r * c + root
        acceleration = omega**2 * (-r * c - r**2 * (c**2 - s**2) / root - r**4 * (s * c) ** 2 / root**3)
        of_weight = -imbalance * m * r * omega**2
        force = np.stack([-m * acceleration + of_weight * c, of_weight * s, np.zeros(N)], 1)
        side = m * acceleration * (r * s) / (r * c - x)  # the rod pushes the piston against its wall, at the height x
        F += force
        M += np.cross([0.0, 0.0, z], force) + np.stack([np.zeros(N), np.zeros(N), x * side], 1)
    of_rows = {row.order: row for row in picked(rows, kind="engine")}
    size = np.abs(M).max()
    for order in range(1, 9):
        wanted = [2 / N * np.exp(-1j * order * epsilon) @ signal for signal in (F, M)]
        row = of_rows.get(float(order))
        force, moment = (row.force, row.moment) if row is not None else (np.zeros(3), np.zeros(3))
        assert np.abs(force - wanted[0]).max() < 1e-10 * size
        assert np.abs(moment - wanted[1]).max() < 1e-10 * size, order
    assert set(of_rows) >= {1.0, 2.0, 3.0}


# --- the other way round


def test_an_engine_that_turns_the_other_way_is_the_mirror_image():
    """Moduli stay; Y of forces, X and Z of moments change their sign.  Not the hand of the teeth: their thrust turns
    round with the sense of rotation, and what it tilts with it."""
    one, results, _ = made("r753ie4_mounting", (2600,), turned="clockwise")
    other, _, found = made("r753ie4_mounting", (2600,), turned="anticlockwise")
    assert "turns about -Z" in str(found.frame.words)
    mirror = np.array([1, -1, 1])
    by_key = {row.key: row for row in other}
    assert len(by_key) == len(one) and {row.kind for row in one} == {"bearing", "weight", "mesh", "engine", "mount"}
    for row in one:
        same = by_key[row.key]
        assert same.at == pytest.approx(row.at * mirror)
        assert same.moment == pytest.approx(row.moment * -mirror, rel=1e-12, abs=1e-12)
        if row.kind == "mesh":
            assert same.force == pytest.approx(row.force * [1, -1, -1], rel=1e-12)
        elif row.kind != "bearing" or row.order:
            assert same.force == pytest.approx(row.force * mirror, rel=1e-12, abs=1e-9)
    thrust = at(results, 2600)["gears.shaft.thrust"].inside
    for rows, sign in ((one, 1.0), (other, -1.0)):
        (rear,) = picked(rows, kind="bearing", place="rear", order=0.0)
        assert rear.force[2].real == pytest.approx(sign * thrust, rel=1e-9)


@pytest.mark.parametrize("turned", ["clockwise", "anticlockwise"])
def test_the_teeth_drive_the_wheels_in_their_sense(turned):
    """What a driver loses of power its mesh gives to the driven wheel: both by the torque of the row about their axes."""
    rows, results, _ = made("r753ie4_mounting", (2600,), turned=turned)
    train, flip = results.train, 1.0 if turned == "clockwise" else -1.0
    meshes = picked(rows, kind="mesh", order=0.0)
    assert len(meshes) == 2 * len(train.meshes)
    for row in meshes:
        mesh, wheel = train.meshes[row.place], row.on.removeprefix("wheel ")
        axis = train.layout.wheels[wheel].position
        arm = row.at - np.array([axis.real, flip * axis.imag, row.at[2]])
        power = np.cross(arm, row.force.real)[2] * train.speeds[wheel] * flip * 2 * math.pi
        passed = at(results, 2600)[f"friction.{row.place}.power_in"].inside
        assert power == pytest.approx(passed if wheel == mesh.driven else -passed, rel=0.05)
        assert (power > 0) == (wheel == mesh.driven)
    forces = sum(row.force for row in meshes)
    assert np.abs(forces).max() < 1e-12 * np.abs(meshes[0].force).max()


# --- what stands still


def test_bearings_at_order_0():
    rows, results, _ = made("r753ie4_mounting", (2600,), turned="clockwise")
    values, standing = at(results, 2600), picked(rows, kind="bearing", order=0.0)
    assert [row.place for row in standing] == ["front", "rear"]
    (weight,) = picked(rows, kind="weight")
    assert weight.on == "shaft shaft"
    assert weight.force == pytest.approx([-values["countershaft.mass"].inside * G, 0, 0])
    (on_wheel,) = picked(rows, kind="mesh", on="wheel shaft", order=0.0)
    whole = sum(row.force for row in standing)
    assert whole == pytest.approx(weight.force + on_wheel.force, rel=1e-12, abs=1e-12)
    moments = [sum(row.moment_about_origin() for row in of)[:2] for of in (standing, [weight, on_wheel])]
    assert moments[0] == pytest.approx(moments[1], rel=1e-12)
    for row in standing:  # what the design judges by takes all of it for the worse
        bound = values[f"countershaft.stationary_{row.place}"].inside
        assert 0.2 * bound < np.abs(row.force[:2]).max() < 1.01 * bound
        assert row.moment[2].real < 0  # a shaft that turns against a clockwise crank drags its block along
    torque = -sum(row.moment[2].real for row in standing)
    omega = 2 * math.pi * 2600 / 60
    assert torque == pytest.approx(values["friction.bearing_loss"].inside / omega, rel=1e-9)
    assert standing[0].force[2] == 0  # no thrust: the rear one locates it, since none is said to


def tilted(design):
    mounting = replace(design.mounting, up=(0.8, 0.0, 0.6))
    return of_shafts_alone(replace(design, mounting=mounting))


def located_in_front(design):
    own = design.shafts[0]
    front, *others = own.bearings
    return tilted(design.with_shaft(replace(own, bearings=(replace(front, locates=True), *others))))


@pytest.mark.parametrize("change, locating", [(tilted, "rear"), (located_in_front, "front")])
def test_weight_acts_against_up(change, locating):
    """Across the shaft by levers, along it at the bearing that locates, else at the rear one, which is said."""
    rows, results, found = made("r753ie4_mounting", (2600,), change=change)
    weight = results.values()["countershaft.mass"].inside * G
    front, rear = picked(rows, kind="bearing", order=0.0)
    assert {row.place: row.force[2] for row in (front, rear) if row.force[2]} == {
        locating: pytest.approx(-0.6 * weight)
    }
    assert front.force[0] + rear.force[0] == pytest.approx(-0.8 * weight)
    assert picked(rows, kind="weight")[0].force == pytest.approx([-0.8 * weight, 0, -0.6 * weight])
    assert any("locate" in note for note in found.notes) == (locating == "rear")


# --- several shafts on more bearings than two


def on_films_alone(design):
    return replace(design, gears=None, friction=None)


def test_three_bearings_and_a_mirror_image():
    """Shares that move with the films; with the rows of inertia they are the unbalance of the masses."""
    rows, results, found = made("r754ie4_balance_shafts", (1000,), change=on_films_alone)
    left = tomllib.loads((DESIGNS / "r754ie4_balance_shafts.toml").read_text(encoding="utf-8"))["shafts"][0]
    U = sum(
        mass["mass_kg"] * mass["radius_mm"] * 1e-3 * np.exp(1j * math.radians(mass["angle_deg"]))
        for mass in left["masses"]
    )
    omega = 2 * math.pi * 2 * 1000 / 60
    for shaft, sense in (("left", 1.0), ("right", -1.0)):
        mine = [row for row in picked(rows, order=2.0) if row.place.split(".")[0] == shaft]
        assert len(picked(mine, kind="bearing")) == 3 and picked(mine, kind="inertia", on=f"shaft {shaft}")
        F_x, F_y, F_z = sum(row.force for row in mine)
        assert F_x == pytest.approx(omega**2 * (U if sense > 0 else U.conjugate()), rel=1e-9)
        assert F_y == pytest.approx(-1j * sense * F_x, rel=1e-9) and not F_z
    for place in ("front", "middle", "rear"):
        (one,), (other,) = (picked(rows, place=f"{shaft}.{place}", order=2.0) for shaft in ("left", "right"))
        assert other.force == pytest.approx(one.force * [1, -1, 1], rel=1e-9)
    middle = np.abs(picked(rows, place="left.middle", order=2.0)[0].force[0])
    at_rated = results.values()["bearings.left.middle.load"].inside
    assert abs(middle / (at_rated / 9) - 1) > 0.01  # not as the square of speed
    assert len([words for words in found.notes if "outline" in words]) == 2


# --- the teeth over a turn


IN_THE_HEAD = [
    ("r753ie4_gamma", 2600, ["countershaft.reaction_*_levers"]),
    ("r753ie4_rolling", 2600, ["bearings.*.load"]),
    ("r754ie4_balance_shafts", 3000, ["bearings.left.*.load"] * 2),
    ("twin_mounting", 5500, ["countershaft.reaction_*"]),
]


@pytest.mark.parametrize("name, rpm, patterns", IN_THE_HEAD)
def test_the_head_says_which_values_of_check_the_bearings_are(name, rpm, patterns):
    rows, results, found = made(name, (rpm,))
    values, shafts = results.values(), results.design.resolved
    for shaft, pattern, line in zip(shafts, patterns, map(str, found.bearings), strict=True):
        assert f"{shaft.name}: the rows bearing equal {pattern} of check" in line
        for bearing in shaft.inputs.bearings:
            place = f"{shaft.name}.{bearing.name}" if len(shafts) > 1 else bearing.name
            turning = [row for row in picked(rows, kind="bearing", place=place) if row.order]
            value = values[pattern.replace("*", bearing.name)].shown
            assert [abs(row.force[0]) for row in turning] == [pytest.approx(value, rel=1e-9)]
            assert f"{bearing.name} {value:.6g} N" in line
    assert f"at {rpm:g} rpm" in str(found.bearings[0])


def test_the_head_has_both_numbers_where_they_differ():
    _, results, found = made("r754ie4_balance_shafts", (3000,))
    line, rigid = str(found.bearings[0]), results.values()["countershaft.left.reaction_middle"].shown
    assert "not countershaft.left.reaction_* of rigid bearings" in line and f"not {rigid:.6g}" in line
    assert not made("r754ie4_balance_shafts", (3000,), "half")[2].bearings


def test_the_orders_of_a_mesh_are_its_force_over_the_cycle():
    """While flanks stay closed: from the least to the most force of the drive, at the line of action."""
    design = load_design(DESIGNS / "r754ie4_balance_shafts.toml")
    with recorded(False):
        train = solve(design).train
    found = mesh_orders(train.drive, [50.0])
    force_of = {key: force for key, force in meshes(train, design.gears.hands()).items() if force is not None}
    assert len(force_of) == 5
    epsilon = np.linspace(0, 4 * math.pi, 2881)
    for key, mesh in train.meshes.items():
        assert not found.part[key][0]
        at_rated = mesh.over_speed.operations["rated"]
        over = sum(np.real(F * np.exp(1j * order * epsilon)) for order, F in found.at(key, 0).items())
        swing = at_rated.most_force - at_rated.least_force
        assert over.max() - over.min() == pytest.approx(swing, rel=1e-3)
        up, side, thrust = force_of[key].of(100.0)  # of a force along the line of action: all of it across the axis
        assert math.hypot(up, side) == pytest.approx(100.0)
        assert abs(thrust) == pytest.approx(
            100.0 * math.cos(mesh.working_pressure_angle) * math.tan(mesh.working_helix_angle)
        )


# --- mounts


def test_mounts_pass_on_what_the_mounting_step_has():
    rows, results, _ = made("r753ie4_mounting", (2600,), turned="clockwise")
    values, mounts = results.values(), picked(rows, kind="mount")
    checked = 0
    for row in mounts:
        shown = values.get(f"mounting.rated.shaft.{row.place}.order_{row.order:g}.force".replace(".5.", "_5."))
        if shown is not None:
            peaks = np.linalg.norm(row.force)
            assert shown.inside == pytest.approx(math.sqrt(0.5) * peaks, rel=1e-9)
            checked += 1
    assert checked >= 12
    for name in {row.place for row in mounts}:
        whole = math.sqrt(sum(np.linalg.norm(row.force) ** 2 for row in picked(mounts, place=name)) / 2)
        assert whole == pytest.approx(values[f"mounting.rated.shaft.{name}.force"].inside, rel=1e-9)
    driving = [row for row in rows if row.kind in ("engine", "bearing") and row.order == 1.5]
    assert [row.kind for row in driving] == ["engine"]


def test_engine_and_bearings_are_what_the_mounts_have_to_take():
    """All rows on the block of an order, about the centre of gravity, are the wrench that drives the mounting step."""
    rows, results, _ = made("twin_mounting", (3000,))
    driven = results.mounting.result.drive
    wrench = driven.wrench(np.array([50.0]), driven.torque(np.array([50.0])))[0, :, driven.variants.index("shaft")]
    r_G = np.array(results.design.mounting.centre_of_gravity)
    size = np.abs(wrench).max()
    for order, six in zip(driven.orders, wrench):
        mine = [row for row in picked(rows, order=order) if row.kind in ("engine", "bearing")]
        force = sum((row.force for row in mine), np.zeros(3))
        moment = sum((row.moment_about_origin() for row in mine), np.zeros(3)) - np.cross(r_G, force)
        assert np.abs(np.concatenate([force, moment]) - six).max() < 1e-9 * size


def test_mounts_of_other_variants_and_shafts_that_are_off():
    assert variants(made("twin_mounting", (3000,))[1]) == ("half", "shaft", "scatter")
    by = {name: made("twin_mounting", (3000,), name)[0] for name in ("half", "shaft", "scatter")}
    assert {row.kind for row in by["half"]} == {"engine", "mount"}
    loudest = {
        name: max(np.linalg.norm(row.force) for row in picked(rows, kind="mount", order=1.0))
        for name, rows in by.items()
    }
    assert loudest["half"] > loudest["scatter"] > loudest["shaft"]
    (exact, late) = (picked(by[name], kind="bearing", order=1.0)[0].force[0] for name in ("shaft", "scatter"))
    assert abs(late) == pytest.approx(abs(exact))
    assert 0 < abs(math.degrees(np.angle(late / exact))) < 2


@pytest.mark.slow
def test_one_tooth_off_turns_the_forces_of_the_shaft():
    rows = {name: made("r753ie4_mounting", (2600,), name, "clockwise")[0] for name in ("shaft", "tooth")}
    teeth = made("r753ie4_mounting", (2600,), "tooth", "clockwise")[1].train.wheels["shaft"].teeth
    exact, late = (picked(of, kind="bearing", place="front", order=1.0)[0].force[0] for of in rows.values())
    assert late / exact == pytest.approx(np.exp(-2j * math.pi / teeth), rel=1e-9)  # late: behind, whichever its sense


# --- the file


def test_each_contact_has_one_side():
    rows, _, _ = made("r753ie4_mounting", (2600,), turned="clockwise")
    assert len({row.key for row in rows}) == len(rows)
    sides = {kind: {row.on.split()[0] for row in picked(rows, kind=kind)} for kind in {row.kind for row in rows}}
    wanted = {"bearing": {"block"}, "engine": {"block"}, "weight": {"shaft"}, "mesh": {"wheel"}, "mount": {"chassis"}}
    assert sides == wanted
    for row in picked(rows, kind="mesh"):
        mate = [other for other in picked(rows, kind="mesh", place=row.place, order=row.order, speed=row.speed)]
        assert np.abs(sum(other.force for other in mate)).max() < 1e-9


def test_both_formats_say_the_same_and_twice_the_same():
    _, results, found = made("twin_mounting", (1700, 3000))
    text = csv_text(found, "name\nof two lines", "abc")
    again = loads(results, [1700 / 60, 3000 / 60])
    assert csv_text(again, "name\nof two lines", "abc") == text
    of = json.loads(json_text(found, "name", "abc"))
    assert "np." not in text and "-0.0," not in text
    table = read(text)
    assert len(of["rows"]) == len(table)
    for row, other in zip(table, of["rows"]):
        assert row.key == tuple(other[name] for name in ("speed_rpm", "kind", "place", "on", "order"))
        assert row.at * 1e3 == pytest.approx(other["at_mm"])
        assert row.force == pytest.approx([complex(*part) for part in other["force_N"]], rel=1e-12, abs=1e-12)
        assert row.moment == pytest.approx([complex(*part) for part in other["moment_Nm"]], rel=1e-12, abs=1e-12)
    heads = [line for line in text.splitlines() if line.startswith("#")]
    assert any(line == "# sha256: abc" for line in heads)
    assert sum("closes to" in line for line in heads) == len(found.sums)
    assert of["frame"]["sum_check"] and of["frame"]["not_in_it"]


@pytest.mark.slow
@pytest.mark.parametrize("path", each_shipped())
def test_sums_close_in_the_files_of_all_shipped_designs(path):
    design = load_design(path)
    if design.engine is None:
        pytest.skip("no engine")
    results = solve(design)
    for variant in variants(results):
        found = loads(results, default_speeds(design), variant)
        assert found.closes and found.rows, (variant, found.sums)
        assert {row.kind for row in found.rows} <= set(KINDS)


def test_cells_of_a_phasor():
    assert amplitude_and_phase(-3 + 0j, 0.0) == ("-3.0", "")
    assert amplitude_and_phase(0j, 1.0) == ("0.0", "")
    assert amplitude_and_phase(np.complex128(2j), 2.0) == ("2.0", "90.0")
    assert amplitude_and_phase(1 - 1e-13j, 1.0)[1] == "0.0"


def test_speeds_where_none_are_given():
    design = load_design(GAMMA)
    found = [round(speed * 60) for speed in default_speeds(design)]
    assert found == [800, 950, 1150, 1350, 1500, 1700, 1850, 2050, 2250, 2400, 2600]
    slow = replace(design, engine=replace(design.engine, rated_speed=110 / 60))
    assert [round(speed * 60) for speed in default_speeds(slow)] == [50, 100, 110]


def test_where_a_shaft_has_no_place_its_cells_are_empty():
    rows, _, found = made("r753ie4_gamma", (2600,))
    (front,) = picked(rows, kind="bearing", place="front", order=1.0)
    assert np.isnan(front.at[:2]).all() and front.at[2] == pytest.approx(-0.1675)
    assert any("axis_mm" in words for words in found.notes)
    assert any("position_mm" in words for words in found.left_out) and not picked(rows, kind="mesh")
