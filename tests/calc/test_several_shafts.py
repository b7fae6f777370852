"""Whole designs with several shafts: what is given of them, symmetries, names in ids, and what is solved again."""

import copy
import functools
import math
from dataclasses import replace

import pytest

from calc import solve as recipe
from calc.bearings.plain.result import PlainResult
from calc.countershaft.supports import gear_place
from calc.design.step_inputs import parts_of_power, power, shaft_drive
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput
from calc.sheet.step import OF_SHAFTS, Outcome
from calc.solve import Results, solve
from calc.studies.repair.levers import free_keys
from calc.studies.repair.state import state_of
from tests.calc.countershaft.systems import called, document, rows, tolerance
from tests.conftest import DESIGNS, GAMMA

GIVEN = [*rows(scatter=False), *rows(scatter=True)]


def solved(data: dict) -> Results:
    return solve(design(Document(data)))


@functools.cache
def of_case(case: str) -> Results:
    return solve(design(document(case)))


@pytest.mark.parametrize("row", GIVEN, ids=called)
def test_what_is_given_of_whole_designs(row):
    value = of_case(row["case"]).values()[row["value"]]
    shown = value.shown % 360 if value.unit == "°" else value.shown
    assert value.unit == row["unit"]
    assert shown == pytest.approx(row["is"], **tolerance(row))


# --- symmetries


def moduli(results: Results) -> dict[str, float]:
    """What shafts supply, and what they leave; of phasors their amounts."""
    wanted = ("countershaft.", "gears.")
    shown = ("force", "couple", "roll", "roll_torque", "unbalance")
    return {
        id: value.shown
        for id, value in results.values().items()
        if id.startswith(wanted) and not id.endswith("_phase") and any(word in id.rpartition(".")[2] for word in shown)
    }


def exchanged(id: str) -> str:
    """What turns with the crank, as that which turns against it."""
    return id.replace("forward", "*").replace("backward", "forward").replace("*", "backward")


def image(data: dict) -> dict:
    """The shafts as their mirror images in the vertical plane through the crank, without their wheels."""
    data = {key: copy.deepcopy(value) for key, value in data.items() if key != "gears"}
    for shaft in data["shafts"]:
        for mass in shaft.get("masses", ()):
            mass["angle_deg"] *= -1
        if "axis_mm" in shaft:
            shaft["axis_mm"][1] *= -1
    return data


@pytest.mark.parametrize("twins", [True, False])
@pytest.mark.parametrize("case", ["r754", "i4-silent", "twin-360-pair", "single-four"])
def test_the_mirror_image_of_an_upright_engine_has_the_same_amounts(case, twins):
    """Its pistons move up and down, so that it is its own mirror image; what turned with the crank turns against it.

    But for the torque of its inertia, whose sense is the crank's, and so the roll that is left."""
    data = document(case).data
    if not twins:
        data = data | {"shafts": [shaft for shaft in data["shafts"] if "mirrors" not in shaft]}
    other = image(data)
    for shaft in other["shafts"]:
        if "speed_ratio" in shaft:
            shaft["speed_ratio"] *= -1
    as_it_is, as_seen = moduli(solved(image(image(data)))), moduli(solved(other))
    kept = {id: value for id, value in as_it_is.items() if "roll_left" not in id}
    assert kept == {id: pytest.approx(as_seen[exchanged(id)], rel=1e-9, abs=1e-6) for id in kept}
    assert len(kept) > 12 and (twins or kept != pytest.approx({id: as_seen[id] for id in kept}))


@pytest.mark.parametrize("case", ["r754", "i4-silent", "twin-270", "v2-45", "v6-90", "inline-5"])
def test_the_mirror_image_run_backward_has_the_same_amounts(case):
    """Banks, crank pins and masses are turned over; run backward, every shaft has its own sense again."""
    other = image(document(case).data)
    engine = other["engine"]
    if engine["layout"] == "vee":
        engine["bank_of_cylinder"] = [1 - bank for bank in engine.get("bank_of_cylinder", [0, 1])]
    if "crank_angles_deg" in engine:
        engine["crank_angles_deg"] = [-angle % 360 for angle in engine["crank_angles_deg"]]
    elif "firing_order" in engine:
        first, *others = engine["firing_order"]
        engine["firing_order"] = [first, *reversed(others)]
    as_it_is = moduli(solved(image(image(document(case).data))))
    assert len(as_it_is) > 8
    assert moduli(solved(other)) == pytest.approx(as_it_is, rel=1e-9, abs=1e-6)


def test_a_shaft_repeated_where_it_is_counts_as_one_of_double_masses():
    data = copy.deepcopy(document("twin-270").data)
    data.pop("gears")
    (shaft,) = data["shafts"]
    beside = {"name": "again", "repeats": shaft["name"], "axis_mm": [25.0, 82.0 + 1e-9]}  # about one axis is refused
    twice = solved({**data, "shafts": [shaft, beside]}).values()
    for mass in shaft["masses"]:
        mass["mass_kg"] *= 2
    double = solved(data).values()
    sums = [id for id in double if id.startswith(("countershaft.residual", "countershaft.roll"))]
    assert "countershaft.residual_order_1_force" in sums and "countershaft.roll_left_order_1" in sums
    for id in sums:
        if id != "countershaft.roll_torque":  # that of one shaft
            assert twice[id].shown == pytest.approx(double[id].shown, rel=1e-7), id


def test_the_name_of_the_only_shaft_changes_nothing():
    data = read(GAMMA).data
    renamed = copy.deepcopy(data)
    renamed["shafts"][0]["name"] = "lower"
    renamed["gears"]["wheels"][-1]["shaft"] = "lower"
    one, other = solved(data), solved(renamed)
    assert {id: value.inside for id, value in one.values().items()} == {
        id: value.inside for id, value in other.values().items()
    }
    assert [(c.id, c.verdict, c.value) for c in one.checks()] == [(c.id, c.verdict, c.value) for c in other.checks()]


# --- a shaft and its mirror image


@functools.cache
def gamma_and_its_image() -> Results:
    """The shaft of the R753IE4 with a mirror image, which the train does not turn, as a file of schema 1 may have it."""
    document = read(GAMMA)
    data = copy.deepcopy(document.data)
    data["accepted"] = {
        "countershaft.residual": "the image leaves as much",
        "bearings.front.film_edge": "as the source has it",
        "bearings.shaft.rear.film_edge": "by its new name",
    }
    data["measured"] = [{"value": "bearings.front.outlet_temperature", "is": 130.0, "unit": "°C"}]
    data["shafts"].append({"name": "image", "mirrors": "shaft"})
    return solve(design(replace(document, data=data)))


def test_the_ids_of_a_shaft_with_a_twin_have_its_name_and_are_found_by_the_old_ones():
    alone, both = solve(design(read(GAMMA))), gamma_and_its_image()
    values = both.values()
    of_shaft = [id for id in alone.values() if id.partition(".")[0] in OF_SHAFTS]
    assert len(of_shaft) > 100
    for id in of_shaft:
        step, _, rest = id.partition(".")
        named = f"{step}.shaft.{rest}"
        assert id in values
        if named in values:
            assert values[id] is values[named]
        else:  # what all shafts leave together
            assert rest.startswith("residual")
    was = alone.values()["bearings.front.film"]
    assert values["bearings.shaft.front.film"].inside == pytest.approx(was.inside, rel=1e-9)
    assert both.value(PlainResult.film).id == "bearings.shaft.front.film"
    assert both.check("bearings.front.film_edge") is both.check("bearings.shaft.front.film_edge")
    assert both.check("countershaft.slope_front") is both.check("countershaft.shaft.slope_front") is not None
    assert both.check("countershaft.residual").id == "countershaft.residual"
    assert both.check("countershaft.image.slope_front") is None  # is not judged twice


def test_what_is_accepted_and_measured_by_an_old_id_counts():
    both = gamma_and_its_image()
    for id in ("countershaft.residual", "bearings.shaft.front.film_edge", "bearings.shaft.rear.film_edge"):
        assert both.check(id).accepted, id
    (row,) = both.design.measured
    temperature, _ = both.predicted.of(row)
    assert temperature == both.values()["bearings.shaft.front.outlet_temperature"].shown
    (table,) = [table for table in both.outcomes["bearings"].tables if table.id == "measured"]
    assert temperature in table.rows[0]


def test_a_mirror_image_gives_what_is_not_its_originals():
    values = gamma_and_its_image().values()
    mine = {id.removeprefix("countershaft.image.") for id in values if id.startswith("countershaft.image.")}
    standing = {"weight", *(f"{what}_{row}" for what in ("weight", "stationary") for row in ("front", "rear"))}
    peaks = {f"reaction_{row}_{what}" for row in ("front", "rear") for what in ("peak", "phase")}
    solid = {f"inertia.{a}" for a in ("xx", "yy", "zz", "xy", "yz", "zx")}
    solid |= {"centre_of_gravity_up", "centre_of_gravity_side"}
    assert mine == {"couple", "couple_phase", "force"} | standing | peaks | solid  # no axis, no wheel
    shaft, image = values["countershaft.shaft.couple_phase"].shown, values["countershaft.image.couple_phase"].shown
    assert image % 360 == pytest.approx(-shaft % 360)
    assert values["countershaft.image.couple"].shown == values["countershaft.shaft.couple"].shown
    assert values["countershaft.shaft_mass"].shown == pytest.approx(2 * values["countershaft.shaft.mass"].shown)
    J = values["countershaft.shaft.moment_of_inertia"].shown
    assert values["countershaft.moment_of_inertia_at_crank"].shown == pytest.approx(2 * J)


# --- two shafts of their own


def two(right: dict | None = None, **tables: object) -> dict:
    """A parallel twin with two shafts at −1 beside the crank, a wheel each; `right`: what of the second one is
    otherwise (its masses are a little larger), or all of it."""
    data = copy.deepcopy(read(DESIGNS / "twin_drive.toml").data)
    sizes = {"diameter_mm": 40.0, "length_mm": 30.0, "clearance_um": 60.0}
    surfaces = {"journal_roughness_um": 0.2, "housing_roughness_um": 0.4}
    places = {"front": -88.0, "rear": 88.0}
    shaft = {
        "material": "42CrMo4",
        "speed_ratio": -1,
        "outer_radius_mm": 30.0,
        "core_radius_mm": 14.0,
        "half_length_mm": 60.0,
        "fillet_radius_mm": 1.5,
        "bearings": [{"name": name, "position_mm": z, **sizes, **surfaces} for name, z in places.items()],
    }
    first = {"name": "left", "axis_mm": [0.0, -66.5], "masses": masses(0.3, 0.3), **shaft}
    second = {"name": "right", "axis_mm": [0.0, 66.5], "masses": masses(0.32, 0.3), **shaft}
    data["shafts"] = [first, right if right and "repeats" in right else second | (right or {})]
    crank, *_, last = data["gears"]["wheels"]
    names = [shaft["name"] for shaft in data["shafts"]]
    data["gears"]["wheels"] = [crank, *(last | {"name": f"wheel-{name}", "shaft": name} for name in names)]
    data["gears"]["meshes"] = [{"driver": "crank", "driven": f"wheel-{name}", "tolerance_um": 40} for name in names]
    del data["optimise"]
    return data | tables


def masses(front: float, rear: float) -> list[dict]:
    places = (("front", front, -35.0), ("rear", rear, 35.0))
    return [{"name": n, "mass_kg": m, "radius_mm": 20.0, "angle_deg": 180.0, "z_mm": z} for n, m, z in places]


ALIKE = {"masses": masses(0.3, 0.3)}


@functools.cache
def of_two() -> Results:
    return solved(two())


def test_two_shafts_each_on_bearings_with_a_wheel():
    results = of_two()
    assert {key: outcome.state for key, outcome in results.outcomes.items() if outcome.state != "solved"} == {
        "mounting": "not_asked"
    }
    values = results.values()
    left, right = values["countershaft.left.force"].shown, values["countershaft.right.force"].shown
    assert right == pytest.approx(left * 0.62 / 0.6)
    engine = values["imbalance.order_1.force_backward"].shown
    kept = values["countershaft.residual.order_1.force_backward"].shown
    assert kept == pytest.approx(abs(engine - left - right))
    parts = [values[f"friction.{name}.bearing_loss"].shown for name in ("left", "right")]
    assert values["friction.bearing_loss"].shown == pytest.approx(sum(parts)) and parts[0] != parts[1]
    # each journal carries its own shaft's reactions
    for name in ("left", "right"):
        for row in ("front", "rear"):
            of_shaft = values[f"countershaft.{name}.reaction_{row}"].inside
            assert values[f"bearings.{name}.{row}.load"].inside == pytest.approx(of_shaft)
    assert results.check("bearings.left.front.film_edge") is not None
    assert results.check("bearings.front.film_edge") is None  # there are several


def test_a_given_power_is_that_of_the_whole_drive():
    """Shared as the powers of the balance stand to each other; where there is none, in equal parts."""
    results = of_two()
    train, f, none = results.train, results.outcomes["friction"], Outcome("friction", "not_asked")
    asked = replace(results.design, gears=replace(results.design.gears, power=3000.0))
    parts, equal = parts_of_power(asked, train, f), parts_of_power(asked, train, none)
    taken = {key: mesh.power_in for key, mesh in f.result.meshes.items()}
    whole = sum(taken.values())
    assert parts == pytest.approx({key: 3000.0 * power / whole for key, power in taken.items()})
    assert len(set(parts.values())) == 2 and list(equal.values()) == [1500.0, 1500.0]
    assert shaft_drive(asked, train, f, parts, "left").power == parts["crank_wheel-left"]
    assert power(asked.gears, f, parts).of == parts
    assert parts_of_power(results.design, train, f) == {}  # not given
    pump = replace(train.tree.links[0], key="pump", driver="wheel-left", driven="pump")  # nobody knows what it takes
    further = replace(train, tree=replace(train.tree, links=(*train.tree.links, pump)))
    assert parts_of_power(asked, further, none) == {**equal, "crank_wheel-left": 3000.0, "pump": 3000.0}
    alone = replace(train, shafts={"left": train.shafts["left"]})
    assert parts_of_power(asked, alone, none) == {}  # which takes it whole


def test_a_shaft_without_a_wheel_is_a_finding_that_names_the_wheel():
    """No error: a file of schema 1 has no words for the wheel of a twin, and is one of schema 2 after an upgrade."""
    data = two()
    last = data["gears"]["wheels"].pop()
    data["gears"]["meshes"].pop()
    results = solved(data)
    check = results.check("gears.right.speed_ratio")
    assert check.verdict == "not_verified"
    for said in (f"teeth = {last['teeth']}", 'shaft = "right"', 'driver = "crank"'):
        assert said in str(check.advice)
    assert "No wheel of the train turns right" in " ".join(map(str, results.outcomes["friction"].notes))


def test_the_pull_of_a_chain_stands_on_the_bearings_of_its_shaft():
    data = two(ALIKE)
    data["gears"]["wheels"].pop(), data["gears"]["meshes"].pop()
    chain = {"name": "chain", "driver": "crank", "driven": "right", "driver_teeth": 25, "driven_teeth": 25}
    data["gears"]["stages"] = [{**chain, "kind": "chain", "side": "outer", "pitch_mm": 9.525, "tensioner_N": 100.0}]
    results = solve(design(Document(data)), of_two(), compared=False)
    values, n = results.values(), abs(results.train.speeds["right"])
    torque = values["friction.chain.power_in"].inside / (2 * math.pi * n)
    d = values["gears.chain.pitch_diameter_driven"].inside
    assert values["countershaft.right.chain_pull"].shown == pytest.approx(2 * torque / d + 200.0)
    for row in ("front", "rear"):
        stands = values[f"countershaft.right.stationary_{row}"].inside
        assert values[f"friction.journals.right.{row}.standing_load"].inside == pytest.approx(stands)
    assert "countershaft.left.chain_pull" not in values
    beyond = replace(results.design.views["right"].own, gear_z=-0.3)  # its sprocket is no piece of the outline
    assert gear_place(beyond, results.views["right"].shaft.outline) == -0.3


# --- bolts of a support that holds several

BOLTS = {
    "thread": "M8",
    "torque_Nm": 25.0,
    "friction": 0.12,
    "across_flats_mm": 13.0,
    "hole_diameter_mm": 9.0,
    "count": 4,
}


def bolted(**keys) -> dict:
    """The pair under the inline four, without its train; what the bolts of the left shaft say."""
    data = {key: table for key, table in document("r754").data.items() if key != "gears"}
    left, right = data["shafts"]
    return {**data, "shafts": [{**left, "bolts": {**BOLTS, **keys}}, right]}


def test_the_bolts_of_one_support_hold_what_all_its_shafts_put_on_it():
    """The pair's forces meet upright: twice that of one; itself counts whether it is named or not."""
    alone, both = solved(bolted()), solved(bolted(carries=["right"]))
    ids = [f"countershaft.left.bolt_{name}" for name in ("end_force", "slip_safety", "preload")]
    one, two = ([results.values()[id].shown for id in ids] for results in (alone, both))
    assert two == pytest.approx([2 * one[0], one[1] / 2, one[2]])
    notes, held = (" ".join(results.outcomes["countershaft"].notes) for results in (alone, both))
    assert "name them (carries)" in notes and "hold left and right together" not in notes
    assert "name them (carries)" not in held and "hold left and right together" in held
    assert {c.id for c in alone.checks() if ".bolts." in c.id} == {c.id for c in both.checks() if ".bolts." in c.id}
    own = solved(bolted(carries=["left"]))
    assert [own.values()[id].shown for id in ids] == pytest.approx(one)
    assert "name them (carries)" not in " ".join(own.outcomes["countershaft"].notes)


def test_bolts_hold_shafts_of_the_design():
    with pytest.raises(BadInput) as bad:
        design(Document(bolted(carries=["rihgt", "left", "front"])))
    reasons = [(error.key, str(error.reason)) for error in bad.value.errors]
    assert reasons == [
        ("shafts.0.bolts.carries", '"rihgt" is not known; did you mean "right"?'),
        ("shafts.0.bolts.carries", '"front" is not known; known are left, right'),
    ]
    for wrong_list in ("right", [], ["right", 1]):
        with pytest.raises(BadInput, match="must be a list of names"):
            design(Document(bolted(carries=wrong_list)))


def test_shafts_that_are_alike_give_alike():
    values = solved(two(ALIKE)).values()
    drawn = ("_median", "_95", "_99", "_largest")  # of the train by chance, each shaft with draws of its own
    of_left = [id for id in values if ".left." in id and not id.endswith(drawn)]
    assert len(of_left) > 300
    for id in of_left:
        other = values[id.replace(".left.", ".right.")]
        assert values[id].shown == pytest.approx(other.shown, rel=1e-9, nan_ok=True), id


def test_a_repeated_shaft_gives_what_the_same_shaft_written_out_gives():
    again = {"name": "right", "repeats": "left", "axis_mm": [0.0, 66.5]}
    written, repeated = solved(two(ALIKE)), solved(two(again))
    known = repeated.values()
    mine = [id for id in known if id.startswith("countershaft.right.")]
    assert {"countershaft.right.gear_force_tangential", "countershaft.right.weight_front"} <= set(mine)
    for id, value in written.values().items():
        if id in known:
            assert known[id].shown == pytest.approx(value.shown, rel=1e-9, nan_ok=True), id
    sums = {id for id in written.values() if ".right." not in id}
    assert sums <= known.keys()


def test_each_shaft_in_view_is_as_one_alone():
    results = of_two()
    assert list(results.views) == ["left", "right"]
    values = results.values()
    for name, view in results.views.items():
        mine = view.values()
        assert [shaft.name for shaft in view.design.shafts] == [name]
        assert mine["countershaft.force"].inside == values[f"countershaft.{name}.force"].inside
        assert mine["bearings.rear.film"].inside == values[f"bearings.{name}.rear.film"].inside
        assert mine["friction.total_loss"].inside == values["friction.total_loss"].inside  # of the whole
        assert "countershaft.residual_order_1_force" not in mine
        assert view.check("bearings.front.film_edge").value == results.check(f"bearings.{name}.front.film_edge").value
        keys = {str(key) for key in view.check("countershaft.fatigue").moved_by}
        assert keys == {str(key) for key in results.check(f"countershaft.{name}.fatigue").moved_by}
    one = solve(design(read(GAMMA)))
    assert list(one.views.values()) == [one]


def test_the_one_shaft_beside_its_twin_is_the_whole_view():
    both = gamma_and_its_image()
    (view,) = both.views.values()
    assert view is both or view.design is both.design


NARROW = {"mode": "size", "outer_radius_mm": 15.0, "half_length_mm": 10.0}


def test_a_shaft_without_solution_stops_what_needs_all_of_them_and_keeps_the_others():
    data = two(NARROW)
    del data["shafts"][1]["masses"]
    results = solved(data)
    step = results.outcomes["countershaft"]
    assert step.state == "no_solution" and str(step.reason).startswith("right: ")
    assert step.result is None
    assert {key: results.outcomes[key].state for key in ("bearings", "friction")} == dict.fromkeys(
        ("bearings", "friction"), "blocked"
    )
    assert results.check("countershaft.left.fatigue").verdict == "pass"
    assert results.check("countershaft.right.fatigue") is None
    assert results.check("countershaft.residual") is None  # nothing is known of what is left
    view = results.views["left"]
    assert view.outcomes["countershaft"].state == "solved"
    assert results.views["right"].outcomes["countershaft"].state == "no_solution"
    assert not any(id.startswith("countershaft.") for id in results.values())


PUMP = {"name": "pump", "power_kW": 1.0}


def test_what_stands_on_the_bearings_of_a_twin_is_judged_where_it_is_more():
    """Of a mirror image that drives a pump the bearings carry what its original's do not."""
    second = {"repeats": "left", "name": "right", "axis_mm": [0.0, 66.5]}
    alike, loaded = solved(two(second)), solved(two(second | {"loads": [PUMP]}))
    assert not any(id.startswith("bearings.right.") for id in (*alike.values(), *(c.id for c in alike.checks())))
    values = loaded.values()
    for row in ("front", "rear"):
        stands = values[f"bearings.right.{row}.standing_load"].inside
        assert stands == pytest.approx(values[f"friction.journals.right.{row}.standing_load"].inside)
        assert stands == pytest.approx(values[f"countershaft.right.stationary_{row}"].inside)
        assert stands > 1.1 * values[f"bearings.left.{row}.standing_load"].inside
        mine, other = (loaded.check(f"bearings.{name}.{row}.film_edge_standing") for name in ("right", "left"))
        assert mine.value < other.value and mine.moved_by == other.moved_by
    assert not any(id.startswith("bearings.right.") and id.endswith(".film_edge") for id in values)


def test_what_is_wrong_with_a_twin_is_mended_at_its_original():
    second = {"repeats": "left", "name": "right", "axis_mm": [0.0, 66.5], "loads": [PUMP]}
    state = state_of(Document(two(second)))
    mine, other = (f"bearings.{name}.front.film_edge_standing" for name in ("right", "left"))
    near, _ = free_keys(state, "bearings", [state.results.check(mine)])
    assert near == free_keys(state, "bearings", [state.results.check(other)])[0]
    assert "shafts.left.bearings.front.length_mm" in near
    assert state.view(mine).own.name == "left"


def test_a_shaft_that_is_sized_takes_what_a_given_one_leaves():
    results = of_case("twin-270-beside")
    assert list(results.of_shafts) == ["small", "rest"]
    order = copy.deepcopy(document("twin-270-beside").data)
    order["shafts"].reverse()
    turned = solved(order).values()
    for id, value in results.values().items():
        assert turned[id].shown == pytest.approx(value.shown, rel=1e-9, abs=1e-9), id


def test_of_a_shaft_with_given_loads_only_the_bearings_are_judged():
    data = two()
    data.pop("gears"), data.pop("friction")
    loaded = [row | {"load_N": 1500.0} for row in data["shafts"][1]["bearings"]]
    data["shafts"][1] = {"name": "right", "mode": "bearings", "bearings": loaded}
    data["bearings"]["journal_material"] = "42CrMo4"
    results = solved(data)
    values = results.values()
    assert results.outcomes["countershaft"].state == results.outcomes["bearings"].state == "solved"
    assert values["bearings.right.front.load"].shown == pytest.approx(1500.0)
    assert values["bearings.left.front.load"].shown == pytest.approx(values["countershaft.left.reaction_front"].shown)
    assert not any(id.startswith("countershaft.right.") for id in values)
    assert list(results.of_shafts["right"]) == ["bearings"]


def beside_bearings(**of_bearings: object) -> dict:
    """Two shafts, and one of which only the bearings are asked, without their loads."""
    data = two(bearings=two()["bearings"] | of_bearings)
    data.pop("gears"), data.pop("friction")
    rows = [{key: x for key, x in row.items() if key != "load_N"} for row in data["shafts"][0]["bearings"]]
    data["shafts"].append({"name": "pump", "mode": "bearings", "bearings": rows})
    return data


def wrong(data: dict) -> set[str]:
    with pytest.raises(BadInput) as caught:
        design(Document(data))
    return {error.key for error in caught.value.errors}


def test_bearings_alone_need_their_loads_and_a_material_wherever_they_stand():
    needed = {f"shafts.2.bearings.{i}.load_N" for i in (0, 1)}
    assert wrong(beside_bearings()) == needed | {"bearings.journal_material"}
    data = beside_bearings(journal_material="42CrMo4")
    assert wrong(data) == needed
    data["shafts"].insert(0, data["shafts"].pop())
    assert wrong(data) == {key.replace("shafts.2", "shafts.0") for key in needed}


@pytest.mark.parametrize("twin", [{"mirrors": "pump"}, {"repeats": "pump", "axis_mm": [0.0, 90.0]}])
def test_bearings_alone_have_no_twin(twin):
    data = beside_bearings(journal_material="42CrMo4")
    for row in data["shafts"][2]["bearings"]:
        row["load_N"] = 500.0
    assert wrong({**data, "shafts": [*data["shafts"], {"name": "image", **twin}]}) == {f"shafts.3.{next(iter(twin))}"}


def test_the_speeds_of_the_journals_are_not_given_where_shafts_turn_at_unlike_ratios():
    data = two({"speed_ratio": 2})
    data.pop("gears"), data.pop("friction")
    data["bearings"]["speed_range_rpm"] = [1000.0, 5000.0]
    assert wrong(data) == {"bearings.speed_range_rpm"}
    data["shafts"][1]["speed_ratio"] = -data["shafts"][0]["speed_ratio"]
    design(Document(data))


# --- what is solved again


def counted(monkeypatch, module, name: str = "solve") -> list[str]:
    """The names of the shafts that a part is called for, in their order."""
    calls, function = [], getattr(module, name)

    @functools.wraps(function)
    def called_for(first, *others, **more):
        calls.append(getattr(first, "name", ""))
        return function(first, *others, **more)

    monkeypatch.setattr(module, name, called_for)
    return calls


def test_a_change_of_one_shaft_does_not_solve_the_other_again(monkeypatch):
    before = of_two()
    calls, turns = counted(monkeypatch, recipe.countershaft), counted(monkeypatch, recipe.bearings)
    other = solve(design(Document(two({"masses": masses(0.33, 0.3)}))), before)
    assert calls == ["right"] and len(turns) == 1
    values, were = other.values(), before.values()
    assert values["countershaft.right.force"].inside != were["countershaft.right.force"].inside
    fresh = solved(two({"masses": masses(0.33, 0.3)})).values()
    assert {id: value.shown for id, value in values.items()} == pytest.approx(
        {id: value.shown for id, value in fresh.items()}, nan_ok=True
    )


def test_nothing_is_solved_again_where_nothing_changed(monkeypatch):
    before = of_two()
    calls = counted(monkeypatch, recipe.countershaft)
    turns = counted(monkeypatch, recipe.bearings)
    solve(design(Document(two())), before)
    assert calls == turns == []


def test_what_is_enough_is_asked_of_all_shafts_by_their_names():
    """As a search does that only wants one check of one shaft: it ends as soon as this is known."""
    wanted = "bearings.left.front.film_edge"
    known = of_two().check(wanted)
    ended = solve(design(Document(two())), enough=lambda outcome: any(check.id == wanted for check in outcome.checks))
    assert ended.check(wanted).value == known.value
    assert "friction" not in ended.outcomes and ended.check("bearings.right.front.film_edge") is None
