"""Whole designs whose shafts are sized beside inner bearings, hollow, of heavy sectors, or laid in: the given sizing
cases, what must hold whatever is asked, and what is refused."""

import cmath
import copy
import json
import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.countershaft.checks import InPlace, shafts_clear, swept
from calc.countershaft.insertion import Opening, Passing, room
from calc.countershaft.sizing.shares import share_of
from calc.countershaft.solve import solve as solve_shaft
from calc.design.step_inputs import sized_alike
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.drawings import shafts as drawn
from calc.studies.drawings import sheets
from tests.conftest import DESIGNS, ROOT

GIVEN = json.loads((ROOT / "tests" / "data" / "shafts.json").read_text(encoding="utf-8"))
CASES = GIVEN["parameters"]["sizing"]
FOUR = GIVEN["cases"]["r754"]
TUNGSTEN = {"name": "tungsten", "E_GPa": 360.0, "poisson": 0.28, "density_kgm3": 17600.0, "expansion_1e6_K": 5.0}
STEEL = {"name": "steel", "E_GPa": 206.0, "poisson": 0.29, "density_kgm3": 7860.0, "expansion_1e6_K": 11.5}
KEYS = {"material": "steel", "speed_ratio": 2, "outer_radius_mm": 30.0, "core_radius_mm": 11.0, "half_length_mm": 80.0}


def rows(places, length=20.0, diameter=30.0):
    names = ["front", *(f"inner-{n}" for n in range(1, len(places) - 1)), "rear"]
    return [
        {"name": name, "position_mm": z, "diameter_mm": diameter, "length_mm": length} for name, z in zip(names, places)
    ]


def document(places=(-100.0, 0.0, 100.0), others=(), materials=(STEEL, TUNGSTEN), bearings=None, **keys):
    shaft = {"name": "left", "mode": "size", **KEYS, "bearings": bearings or rows(places), **keys}
    shaft = {key: value for key, value in shaft.items() if value is not None}
    tables = {"engine": FOUR["engine"], "imbalance": FOUR["imbalance"], "material": list(materials)}
    return Document({"schema": 2, "name": "sized", **tables, "shafts": [shaft, *copy.deepcopy(list(others))]})


def outcome(*arguments, **keys):
    return solve(design(document(*arguments, **keys))).outcomes["countershaft"]


def result(*arguments, **keys):
    made = outcome(*arguments, **keys)
    assert made.state == "solved", made.reason
    return made.result


def errors(*arguments, **keys):
    with pytest.raises(BadInput) as caught:
        design(document(*arguments, **keys))
    return {error.key: str(error.reason) for error in caught.value.errors}


def check(made, id):
    return next((c for c in made.checks if c.id == f"countershaft.{id}"), None)


# --- the given values, each through a whole design
def asked_of(case):
    """U and P of a case, and its stretches as half-length, inner bearings and gap."""
    U = cmath.rect(case.get("unbalance_kgm", 0.0), math.radians(case.get("unbalance_deg", 0.0)))
    P = cmath.rect(case.get("product_kgm2", 0.0), math.radians(case.get("product_deg", 0.0)))
    if "stretches_mm" not in case:
        return U, P, case["half_length_mm"], [0.0], case["gap_mm"]
    where = case["stretches_mm"]
    gaps = [(a, b) for (_, a), (b, _) in pairwise(where)]
    return U, P, where[-1][1], [(a + b) / 2 for a, b in gaps], gaps[0][1] - gaps[0][0]


def asked_by_the_engine():
    """What the shaft at twice the speed of the crank has to bring, of order 2."""
    tables = {key: FOUR[key] for key in ("engine", "imbalance")}
    outcomes = solve(design(Document({"schema": 2, "name": "alone", **tables}))).outcomes
    F, _, C, _ = outcomes["imbalance"].result.orders["order_2"].vectors
    omega = 2 * outcomes["engine"].result.angular_speed
    return -F / omega**2, -C / omega**2


def brought(name, U, z):
    """A further element of that unbalance, 1 m from the axis."""
    return {
        "name": name,
        "mass_kg": abs(U),
        "radius_mm": 1000.0,
        "angle_deg": math.degrees(cmath.phase(U)),
        "z_mm": z * 1e3,
    }


@pytest.mark.parametrize("name", CASES)
def test_the_given_sizes_through_a_whole_design(name):
    """Two further elements bring what the engine asks beyond the case.  Its sectors are then those of the design."""
    case = CASES[name]
    U, P, z_max, inner, gap = asked_of(case)
    U_e, P_e = asked_by_the_engine()
    arm = 0.1
    one, other = ((U_e - U) / 2 + way * (P_e - P) / (2 * arm) for way in (-1, 1))
    ends = z_max + 30.0
    found = result(
        (-ends, *inner, ends),
        materials=[{**STEEL, "density_kgm3": case["density_kgm3"]}],
        outer_radius_mm=case["outer_radius_mm"],
        core_radius_mm=case["core_radius_mm"],
        half_length_mm=z_max,
        gap_mm=gap,
        extras=[brought("one", one, -arm), brought("other", other, arm)],
    )
    sectors = list(found.sector.values())
    last = sectors[-1]
    said = dict(utilisation=found.utilisation, mass=found.eccentric_mass, length=last.length, z=last.z)
    said["half_angle"] = math.degrees(last.half_angle)
    for number, sector in enumerate(sectors, 1):
        turned = math.degrees(sector.angle)
        opposite = case["kind"] != "moments" and math.cos(sector.angle) < 0
        said[f"sector.{number}.half_angle"] = math.degrees(sector.half_angle) * (-1 if opposite else 1)
        said[f"sector.{number}.angle"] = turned % 360
        for side, face in ((-1, "from"), (1, "to")):
            said[f"sector.{number}.{face}"] = (sector.z + side * sector.length / 2) * 1e3
    values = [row for row in GIVEN["given"] if row["case"] == name]
    assert len(values) >= 3
    for row in values:
        near = pytest.approx(row["is"], rel=row.get("rel"), abs=row.get("abs"))
        assert said[row["value"]] == near, row["value"]
    assert found.force_vector == pytest.approx(U_e * found.omega**2, rel=1e-9)


# --- what must hold whatever is asked
@settings(max_examples=12, deadline=None)
@given(st.integers(-25, 25), st.just(0.0) | st.floats(0.1, 4.0), st.sampled_from([7860.0, 12000.0]))
def test_sectors_keep_their_gap_and_take_the_whole_force(middle, fillet, density):
    """Whatever the place of the inner bearing and the fillet: the sectors end two fillets beside its journal, their sum
    is what is asked, and heavier ones are lighter in sum."""
    keys = dict(materials=[{**STEEL, "density_kgm3": density}], fillet_radius_mm=fillet or None, outer_radius_mm=36.0)
    made = outcome((-100.0, middle, 100.0), **keys)
    if made.state != "solved":  # beside a bearing far off the middle one stretch may not hold it
        assert "does not fit" in made.reason
        return
    found, room = made.result, check(made, "between")
    faces = [one.z + way * one.length / 2 for one in found.sector.values() for way in (-1, 1)]
    nearest = min(abs(face - middle * 1e-3) for face in faces) - 0.01
    assert room.value == pytest.approx(nearest * 1e3, abs=1e-6) and nearest >= 2e-3 * fillet - 1e-9
    assert room.verdict == "pass"
    assert found.force_vector == pytest.approx(asked_by_the_engine()[0] * found.omega**2, rel=1e-7)
    assert sum(one.mass for one in found.sector.values()) == pytest.approx(found.eccentric_mass)
    assert found.outline.heavier == 1.0


def test_two_bearings_take_the_pair_as_ever():
    """Without an inner bearing gap and share change nothing."""
    plain, same = result((-100.0, 100.0)), result((-100.0, 100.0), gap_mm=20.0, share_percent=100.0)
    assert list(plain.sector) == ["front", "rear"]
    assert (same.utilisation, same.mass, same.sector_length) == (plain.utilisation, plain.mass, plain.sector_length)


def test_force_and_couple_apart_take_two_stretches_and_no_more():
    extras = [{"name": "x", "mass_kg": 0.02, "radius_mm": 30.0, "angle_deg": 70.0, "z_mm": 60.0}]
    made = outcome(extras=extras, outer_radius_mm=34.0)
    assert made.state == "solved" and any("not the lightest" in str(note) for note in made.notes)
    refused = outcome((-100.0, -30.0, 30.0, 100.0), extras=extras, outer_radius_mm=40.0)
    assert refused.state == "no_solution" and "give the masses (mode given)" in refused.reason


def test_what_would_help_a_small_envelope_helps():
    """Each of the sizes that are named, alone; of the density by the material of the sectors."""
    keys = dict(outer_radius_mm=24.0, assembly="split")
    reason = outcome(**keys).reason
    assert "does not fit" in reason and "leave a half-length of 90 mm" in reason

    def told(before, after):
        return float(reason.partition(before)[2].partition(after)[0])

    larger = told("an outer radius of ", " mm")
    assert outcome(**{**keys, "outer_radius_mm": larger}).result.utilisation == pytest.approx(1.0, abs=2e-3)
    longer = told("a half-length of ", " mm")
    assert outcome((-150, 0, 150), **keys, half_length_mm=longer).result.utilisation == pytest.approx(1.0, abs=2e-3)
    density = told("sectors of ", " kg")
    heavy = {**TUNGSTEN, "density_kgm3": density}
    found = result(**keys, materials=[STEEL, heavy], sector_material="tungsten")
    assert found.utilisation == pytest.approx(1.0, abs=2e-4)


# --- a share, and twins
@pytest.mark.parametrize(
    ("repeats", "mirrors", "like", "against"),
    [(0, 0, 1, 0), (0, 1, 1, 1), (1, 0, 1, 0), (1, 2, 1, 1), (1, 1, 1, 0.5), (0, 2, 0.5, 1), (0, 3, 1 / 3, 1)],
)
def test_sized_shafts_and_their_twins_take_all_of_one_sense_and_no_more_of_any(repeats, mirrors, like, against):
    """By default equal shares, by the sum of their vectors: what turns like the shaft, and its mirror image."""
    twins = [{"name": f"again-{n}", "repeats": "left", "axis_mm": [-50.0, 90.0 + n]} for n in range(repeats)]
    twins += [{"name": f"mirror-{n}", "mirrors": "left", "axis_mm": [-150.0, 90.0 + n]} for n in range(mirrors)]
    made = design(document(axis_mm=[-50.0, -90.0], others=twins))
    own, V = made.shafts[0], 3 + 4j
    taken = {own.speed_ratio: 0j, -own.speed_ratio: 0j}
    for shaft in made.resolved:
        part = share_of(own, sized_alike(made, own.name)) * V
        taken[shaft.inputs.speed_ratio] += part.conjugate() if shaft.how == "mirrors" else part
    assert list(taken.values()) == pytest.approx([like * V, against * V.conjugate()])
    assert share_of(replace(own, share=0.3), 2) == 0.3


def test_a_share_scales_force_and_couple_of_what_is_asked():
    made = design(document())
    solved = solve(made)
    arguments = (
        made.own,
        solved.outcomes["imbalance"].result,
        solved.outcomes["engine"].result.angular_speed,
        made.materials,
        None,
    )
    whole = solve_shaft(*arguments, judged=False).result
    part = solve_shaft(replace(made.own, share=0.4), *arguments[1:], judged=False, alike=2).result
    assert part.force_vector == pytest.approx(0.4 * whole.force_vector, rel=1e-9)
    assert part.eccentric_mass < whole.eccentric_mass


def test_a_pair_takes_both_senses_only_where_they_are_mirror_images():
    right = {"name": "right", "mirrors": "left"}
    assert outcome(others=[right]).state == "solved"  # order 2 of an inline engine stands in the plane of its cylinders
    balanced = document((-100.0, 100.0), others=[right], speed_ratio=-1, outer_radius_mm=60.0)
    single = GIVEN["cases"]["twin-360-one"]  # half of the crank: order 1 is backward
    data = {**balanced.data, "engine": single["engine"], "imbalance": single["imbalance"]}
    refused = solve(design(Document(data))).outcomes["countershaft"]
    assert refused.state == "no_solution" and "write two shafts" in refused.reason


# --- hollow, and of heavy sectors
def test_a_bore_is_lighter_and_weaker_and_unbalances_nothing():
    solid, hollow = result(core_radius_mm=13.0), result(core_radius_mm=13.0, bore_diameter_mm=20.0)
    volume = math.pi * 0.01**2 * (solid.outline.end - solid.outline.start)
    assert solid.mass - hollow.mass == pytest.approx(7860.0 * volume, rel=1e-9)
    assert solid.moment_of_inertia - hollow.moment_of_inertia == pytest.approx(7860.0 * volume * 0.01**2 / 2, rel=1e-7)
    assert hollow.force_vector == solid.force_vector and hollow.eccentric_mass == solid.eccentric_mass
    assert hollow.slopes["front"] > 1.05 * solid.slopes["front"]
    assert hollow.bending.bending_stress > solid.bending.bending_stress


def test_heavy_sectors_alone_are_heavier():
    """Of twice the density, and of half the unbalance per volume asked of it: the outline of the same sectors."""
    doubled = {**STEEL, "name": "double", "density_kgm3": 2 * 7860.0}
    keys = dict(materials=[STEEL, doubled], outer_radius_mm=34.0)
    light, heavy = result(**keys), result(**keys, sector_material="double")
    assert heavy.utilisation == pytest.approx(light.utilisation / 2, rel=1e-9)
    assert heavy.force_vector == pytest.approx(light.force_vector, rel=1e-9) and heavy.outline.heavier == 2.0
    core = [piece for piece in heavy.outline.pieces]
    volume = sum(
        p.length * math.pi * (p.core_radius if p.half_angle is not None else p.outer_radius) ** 2 for p in core
    )
    assert heavy.mass == pytest.approx(heavy.eccentric_mass + 7860.0 * volume, rel=1e-9)
    carried = np.sum(heavy.reactions)
    assert abs(carried) == pytest.approx(heavy.force, rel=0.02)  # and what the bent shaft adds of its own
    given_ = {key: value for key, value in KEYS.items() if key != "half_length_mm"} | {"outer_radius_mm": 34.0}
    masses = [
        {
            "name": f"m{name}",
            "mass_kg": one.mass,
            "radius_mm": one.radius * 1e3,
            "angle_deg": math.degrees(one.angle),
            "z_mm": one.z * 1e3,
        }
        for name, one in heavy.sector.items()
    ]
    same = result(**{**keys, **given_}, mode="given", half_length_mm=None, sector_material="double", masses=masses)
    assert same.mass == pytest.approx(heavy.mass, rel=1e-9)  # masses that are given become the same heavy sectors
    assert same.bending.natural_frequency == pytest.approx(heavy.bending.natural_frequency, rel=1e-6)


def test_a_shaft_of_heavy_sectors_vibrates_between_a_light_and_a_heavy_one():
    """The same shape in steel, in a steel of twice the density, and with sectors of it: whole shafts as 1/√ρ, with the
    rotary inertia of their sections too."""
    doubled = {**STEEL, "name": "double", "density_kgm3": 2 * 7860.0}
    shape = [(-110.0, -90.0, 15.0, False), (-90.0, 90.0, 30.0, True), (90.0, 110.0, 15.0, False)]
    sections = [
        {"from_mm": a, "to_mm": b, "outer_radius_mm": R}
        | ({"core_radius_mm": 9.0, "half_angle_deg": 80.0, "angle_deg": 0.0} if eccentric else {})
        for a, b, R, eccentric in shape
    ]
    masses = [{"name": "m", "mass_kg": 1.0, "radius_mm": 16.0, "angle_deg": 0.0, "z_mm": 0.0}]
    keys = dict(mode="given", half_length_mm=None, outer_radius_mm=None, core_radius_mm=None, sections=sections)
    keys |= dict(masses=masses, materials=[STEEL, doubled], bearings=rows((-100.0, 100.0)))
    light = result(**keys).bending
    mixed = result(**keys, sector_material="double").bending
    heavy = result(**{**keys, "material": "double"}).bending
    assert heavy.natural_frequency == pytest.approx(light.natural_frequency / math.sqrt(2), rel=1e-6)
    for name in ("natural_frequency", "natural_frequency_without_rotary"):
        assert getattr(heavy, name) < getattr(mixed, name) < getattr(light, name)
    rotary = [1 - bent.natural_frequency / bent.natural_frequency_without_rotary for bent in (light, mixed, heavy)]
    assert 0.005 < rotary[0] < 0.05 and rotary == pytest.approx([rotary[0]] * 3, rel=0.15)


def test_a_bore_is_drawn():
    hollow = solve(design(document(core_radius_mm=13.0, bore_diameter_mm=20.0, outer_radius_mm=34.0)))
    lines = [mark for mark in drawn(hollow)[0] if mark.layer == "HIDDEN"]
    assert [line.points[0][1] for line in lines] == pytest.approx([0.01, -0.01])
    (sheet,) = sheets(hollow)
    words = " ".join(str(getattr(mark, "text", "")) for mark in sheet.marks)
    assert "Bored through, ⌀20" in words
    solid = solve(design(document(core_radius_mm=13.0, outer_radius_mm=34.0)))
    assert not [mark for mark in drawn(solid)[0] if mark.layer == "HIDDEN"]


def test_a_bore_that_a_journal_does_not_hold_leaves_no_outline():
    made = outcome(core_radius_mm=17.0, bore_diameter_mm=32.0, outer_radius_mm=36.0)
    assert made.result.outline is None and any("a bore of 32 mm leaves nothing" in str(note) for note in made.notes)


# --- how it comes into its seats
CARRIER = [{**row, "carrier_bore_mm": 66.0} if row["name"] == "front" else row for row in rows((-100.0, 0.0, 100.0))]


def test_what_has_to_pass_where():
    """Threaded: the seats on the way in.  Laid in: nothing.  In a cartridge: the bore of its carrier."""
    threaded = outcome(outer_radius_mm=32.0)
    assert (
        check(threaded, "envelope").value == pytest.approx(15.0 - 32.0)
        and check(threaded, "envelope").verdict == "fail"
    )
    assert (
        check(outcome(outer_radius_mm=32.0, assembly="threaded"), "envelope").value == check(threaded, "envelope").value
    )
    for word in ("split", "caps", "module"):
        assert check(outcome(outer_radius_mm=32.0, assembly=word), "envelope") is None
    outer_two = [CARRIER[0], CARRIER[-1]]
    carried = check(outcome(outer_radius_mm=32.0, assembly="cartridge", bearings=outer_two), "envelope")
    assert carried.value == pytest.approx(1.0) and carried.verdict == "pass"
    from_rear = outcome(outer_radius_mm=32.0, assembly="cartridge", bearings=outer_two, insert_from="rear")
    assert check(from_rear, "envelope").value == pytest.approx(15.0 - 32.0)  # the rear seat has no carrier
    large = [{**row, "diameter_mm": 68.0} if row["name"] == "rear" else row for row in outer_two]
    found = outcome(outer_radius_mm=32.0, assembly="cartridge", bearings=large, insert_from="front")
    assert check(found, "envelope").value == pytest.approx(-1.0)  # the rear journal has to pass it too
    # an inner seat that is not divided stops what lies behind it
    stopped = check(outcome(outer_radius_mm=32.0, assembly="cartridge", bearings=CARRIER), "envelope")
    assert stopped.value == pytest.approx(15.0 - 32.0)


@pytest.mark.parametrize(
    "pieces, openings, front, rear",
    [
        (  # journals that step by 2 mm, as those of the Mazda WL-C: each passes the seat before it by 1 mm
            [(-120, 20.976), (-60, 19.5), (0, 19.976), (60, 18.5), (120, 18.991)],
            [(-120, 42.035), (0, 40.064), (120, 38.065)],
            1.041,
            -1.9435,
        ),
        ([(0, 20.0), (150, 18.3665)], [(-150, 42.0), (150, 36.8)], 1.0, -1.6),  # GM L61: a carrier, and a bush
        ([(0, 37.0)], [], math.inf, math.inf),  # a divided crankcase
    ],
)
def test_the_room_on_the_way_in(pieces, openings, front, rear):
    """Computed independently for the specification; printed diameters as the makers have them."""
    parts = [Passing(z / 1e3, R / 1e3) for z, R in pieces]
    seats = [Opening(z / 1e3, D / 1e3) for z, D in openings]
    assert room(parts, seats, front=True) * 1e3 == pytest.approx(front, rel=1e-6)
    assert room(parts, seats, front=False) * 1e3 == pytest.approx(rear, rel=1e-6)


def test_the_speed_of_the_shaft_is_its_own():
    """At twice the speed of the crank: critical speeds against 2ω; its slopes are four times those of one at ω under
    the same masses."""
    masses = [{"name": "m", "mass_kg": 0.4, "radius_mm": 16.0, "angle_deg": 180.0, "z_mm": 0.0}]
    keys = dict(mode="given", half_length_mm=None, masses=masses, bearings=rows((-100.0, 100.0)))
    slow, fast = (outcome(speed_ratio=ratio, **keys) for ratio in (1, 2))
    rated = FOUR["engine"]["rated_speed_rpm"]
    for made, ratio in ((slow, 1), (fast, 2)):
        assert check(made, "first_critical_speed").limit == pytest.approx(1.2 * ratio * rated)
        assert check(made, "rigid").limit == pytest.approx(1.5 * ratio * rated)
        assert made.result.omega == pytest.approx(ratio * rated * 2 * math.pi / 60)
    assert fast.result.slopes["front"] == pytest.approx(4 * slow.result.slopes["front"], rel=2e-2)
    assert fast.result.slopes["front"] > 4 * slow.result.slopes["front"]  # its own mass adds to it


# --- whether sectors keep away from bearings that are given with masses
def test_given_sectors_keep_one_fillet_from_an_inner_bearing():
    masses = [
        {"name": f"m{n}", "mass_kg": 0.35, "radius_mm": 17.0, "angle_deg": 180.0, "z_mm": z}
        for n, z in ((1, -45.0), (2, 45.0))
    ]
    keys = dict(mode="given", half_length_mm=None, masses=masses, outer_radius_mm=30.0, fillet_radius_mm=1.5)
    plain = check(outcome(**keys), "between")
    assert (plain.limit, plain.verdict) == (1.5, "pass") and plain.value > 1.5
    asked = check(outcome(**keys, gap_mm=80.0), "between")
    assert (asked.limit, asked.value, asked.verdict) == (30.0, plain.value, "fail")
    assert check(outcome((-100.0, 100.0), **keys), "between") is None


@pytest.mark.parametrize("face, verdict", [(100.0, "pass"), (100.1, "fail"), (102.0, "fail")])
def test_given_sections_keep_one_fillet_from_the_outer_bearings_too(face, verdict):
    """The shipped balance shafts, whose outer journals reach from 101.5 mm outwards, with longer sectors."""
    longer = read(DESIGNS / "r754ie4_balance_shafts.toml")
    for key in ("3.to_mm", "4.from_mm"):
        longer = longer.with_value(f"shafts.left.sections.{key}", face)
    room = check(
        solve(design(longer), enough=lambda of: of.key == "countershaft").outcomes["countershaft"], "left.between"
    )
    assert (room.limit, room.verdict) == (1.5, verdict)
    assert room.value == pytest.approx(101.5 - face) and ("rear" in room.name or face == 100.0)


# --- several shafts beside the crank
def clear(crank, **shafts):
    found = list(shafts_clear({name: InPlace(*one) for name, one in shafts.items()}, crank))
    return found[0] if found else None


def test_shafts_turn_clear_of_each_other_and_of_the_crank():
    left, right = (-0.06 - 0.095j, 0.03), (-0.06 + 0.095j, 0.03)
    found = clear(0.07, left=left, right=right)
    assert found.id == "countershaft.shafts.clear" and found.verdict == "pass"
    assert found.value == pytest.approx(abs(left[0]) * 1e3) and found.limit == pytest.approx(100.0)
    assert "crank" in str(found.name) and found.moved_by == ("shafts.left.axis_mm",)
    near = clear(0.03, left=left, right=(-0.06 - 0.034j, 0.03))
    assert near.value == pytest.approx(61.0) and near.limit == pytest.approx(62.0) and near.verdict == "fail"
    assert near.moved_by == ("shafts.left.axis_mm", "shafts.right.axis_mm")


def test_what_is_not_known_is_not_verified_unless_something_fails():
    left, right = (-0.06 - 0.095j, 0.03), (-0.06 + 0.095j, 0.03)
    assert clear(0.07, left=left, right=(None, 0.03)).missing == ("shafts.right.axis_mm",)
    fallen = clear(0.07, left=left, right=(*left, "left"))  # a mirror image that has no place yet
    assert fallen.verdict == "not_verified" and "shafts.left.axis_mm a side" in fallen.advice
    on_one_axis = clear(0.07, left=left, right=left)
    assert (on_one_axis.verdict, on_one_axis.value) == ("fail", 0.0)
    assert clear(0.05, left=left, right=(-0.06 - 0.1j, 0.03), third=(None, 0.03)).verdict == "fail"
    assert clear(0.07, left=left, right=(right[0], None)).missing == ("shafts.S.outer_radius_mm",)
    assert clear(0.05, left=(None, 0.03)) is None and clear(0.05, left=left).verdict == "pass"
    assert clear(0.1, left=left).verdict == "fail"


def test_what_a_shaft_sweeps():
    made = design(document(outer_radius_mm=34.0))
    found = solve(made).outcomes["countershaft"].result
    assert swept(made.own, found.outline) == pytest.approx(0.034)
    assert swept(made.own, None) == pytest.approx(0.034)
    assert swept(replace(made.own, outer_radius=None), None) is None
    thick = replace(made.own, bearings=tuple(replace(row, diameter=0.08) for row in made.own.bearings))
    assert swept(thick, None) == pytest.approx(0.04)


# --- what is refused
@pytest.mark.parametrize(
    "keys, key, words",
    [
        (dict(gap_mm=160.0), "gap_mm", "leaves no sectors"),
        (dict(share_percent=0.5), "share_percent", "from 1 to 100"),
        (dict(bore_diameter_mm=22.0), "bore_diameter_mm", "smaller than the core"),
        (dict(bore_diameter_mm=-1.0), "bore_diameter_mm", "from 0"),
        (dict(sector_material="mud"), "sector_material", "is not known"),
        (dict(assembly="glued"), "assembly", '"cartridge"'),
        (dict(assembly="caps", radial_clearance_mm=1.0), "radial_clearance_mm", "nothing has to pass"),
        (dict(assembly="cartridge"), "bearings.0.carrier_bore_mm", "needed"),
        (dict(bearings=CARRIER), "bearings.0.carrier_bore_mm", "belongs to assembly"),
    ],
)
def test_bad_input_is_named(keys, key, words):
    found = errors(**keys)
    assert words in found.pop(f"shafts.0.{key}") and not found


def test_a_carrier_stands_outside_and_is_larger_than_its_journal():
    inner = [{**row, "carrier_bore_mm": 66.0} if row["name"] == "inner-1" else row for row in CARRIER]
    assert set(errors(assembly="cartridge", bearings=inner)) == {"shafts.0.bearings.1.carrier_bore_mm"}
    narrow = [{**row, "carrier_bore_mm": 30.0} if row["name"] == "front" else row for row in CARRIER]
    assert "must be larger" in errors(assembly="cartridge", bearings=narrow)["shafts.0.bearings.0.carrier_bore_mm"]


def test_inner_bearings_without_a_length_need_a_gap():
    bare = [{"name": row["name"], "position_mm": row["position_mm"]} for row in rows((-100.0, 0.0, 100.0))]
    assert set(errors(bearings=bare)) == {"shafts.0.gap_mm"}
    found = result(bearings=bare, gap_mm=30.0)
    assert max(one.z + one.length / 2 for one in found.sector.values() if one.z < 0) == pytest.approx(-0.015)


def test_shares_of_one_ratio_stay_within_the_whole():
    second = {"name": "second", "mode": "size", **KEYS, "bearings": rows((-100.0, 100.0))}
    assert set(errors(share_percent=60.0, others=[second])) == {"shafts.0.share_percent"}  # the other one's half
    design(document(share_percent=60.0, others=[{**second, "share_percent": 40.0}]))
    twin = {"name": "again", "repeats": "left", "axis_mm": [1.0, 2.0]}
    assert "120 %" in errors(share_percent=60.0, others=[twin])["shafts.0.share_percent"]
    mirrors = [{"name": name, "mirrors": "left", "axis_mm": [1.0, y]} for name, y in (("one", 2.0), ("two", 3.0))]
    assert "120 %" in errors(share_percent=60.0, others=mirrors)["shafts.0.share_percent"]  # of the other sense
    design(document(share_percent=60.0, others=[{"name": "right", "mirrors": "left"}]))
    for key, value in (("share_percent", 50.0), ("gap_mm", 3.0), ("bore_diameter_mm", 3.0), ("assembly", "split")):
        found = errors(others=[{"name": "right", "mirrors": "left", key: value}])
        assert "is that of its original" in found[f"shafts.1.{key}"]
