"""The outline: given as sections, or put together from what is known; and what is said where it can not be."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.countershaft import outline as o
from calc.countershaft.bending.formulas import shear_coefficient, shear_modulus
from calc.countershaft.bending.shaft import bending
from calc.countershaft.inputs import EccentricMass, Extra
from calc.countershaft.outline import MASS_SHAPE, NoOutline, Piece, half_angle, narrowness, outline, sectors_of
from calc.design.toml_file import design
from calc.library.catalogue import materials
from calc.sheet.errors import BadInput
from calc.sheet.value import trace
from calc.solve import solve
from tests.calc.countershaft.shafts import (
    FRONT,
    JOURNALS,
    POSITIONS,
    REAR,
    SEATED,
    UP,
    document,
    drawn_shaft,
    outcome,
    piece,
    result,
    rows,
    verdicts,
)

CORE = {"core_radius_mm": 15.0, "outer_radius_mm": 40.3}
HALVES = [{**m, "mass_kg": 2.608345, "radius_mm": 18.830668, "z_mm": z} for m, z in ((FRONT, -76.5), (REAR, 76.5))]


def section(start, end, R, **more):
    return {"from_mm": start, "to_mm": end, "outer_radius_mm": R, **more}


SECTOR = {"core_radius_mm": 15.0, "half_angle_deg": 90.0}
SECTIONS = [
    section(-181.25, -153.75, 29.75),
    section(-153.75, -152.0, 15.0),
    section(-152.0, -1.0, 40.3, angle_deg=210.0, **SECTOR),
    section(-1.0, 1.0, 15.0),
    section(1.0, 152.0, 40.3, angle_deg=30.0, **SECTOR),
    section(152.0, 154.25, 15.0),
    section(154.25, 180.75, 40.5),
]
SAME = (
    "mass",
    "centre_of_gravity",
    "slopes",
    "slopes_stiff",
    "first_critical_speed",
    "bending_stress",
)


def value(made, name):
    return getattr(made, name) if hasattr(made, name) else getattr(made.bending, name)


@pytest.mark.parametrize("share", [1.0, 0.2])
def test_masses_and_the_sections_that_they_stand_for_are_one_shaft(share):
    """Half-annuli of R 40.3 on a core of 15, from 1 to 152 mm: 2.608345 kg at 18.830668 mm (by hand from the
    section)."""
    given = result(masses=HALVES, sections=SECTIONS, sector_effectiveness=share)
    derived = result(masses=HALVES, bearings=SEATED, sector_effectiveness=share, **CORE)
    assert derived.outline.derived and not given.outline.derived
    assert [p.what for p in derived.outline.pieces] == "journal core sector core sector core journal".split()
    for name in SAME:
        assert value(derived, name) == pytest.approx(value(given, name), rel=1e-5), name
    assert given.outline_couple_deviation < 1e-4 and given.outline_force_deviation < 1e-3
    assert derived.outline_couple_deviation is derived.outline_force_deviation is None


def test_the_order_of_the_sections_in_the_file_does_not_matter():
    forward, backward = result(masses=HALVES, sections=SECTIONS), result(masses=HALVES, sections=SECTIONS[::-1])
    assert forward.slopes["rear"] == backward.slopes["rear"] and forward.mass == backward.mass


@pytest.mark.parametrize(
    "shaft, words",
    [
        ({"bearings": SEATED, "outer_radius_mm": 40.5}, "core_radius_mm"),
        ({**CORE}, "diameter and length of the bearings"),
        ({}, "outer_radius_mm and diameter"),
        ({**CORE, "core_radius_mm": 0.0, "bearings": SEATED, "masses": HALVES}, "too thin"),
        ({**CORE, "bearings": SEATED, "masses": [{**FRONT, "mass_kg": 4.0}, REAR]}, "crosses"),
        (
            {**CORE, "bearings": SEATED, "masses": [{**FRONT, "radius_mm": 40.0}, REAR]},
            "mass front: no sector from 15 to 40.3 mm",
        ),
        ({**CORE, "bearings": SEATED, "masses": [{**FRONT, "z_mm": 0.0}, REAR]}, "crosses"),
        (
            {**CORE, "bearings": SEATED, "masses": HALVES, "extras": [{**FRONT, "mass_kg": -20.0}]},
            "the further elements take away 20 kg, needs < 8.602 kg",
        ),
    ],
)
def test_where_it_can_not_be_drawn_a_note_says_why_and_the_rest_is_solved(shaft, words):
    scatter = {"mass_g": 10.0, "radius_mm": 0.05, "angle_deg": 0.1, "z_mm": 0.1}
    bolts = {
        "thread": "M10",
        "torque_Nm": 45.0,
        "friction": 0.12,
        "head_diameter_mm": 15.0,
        "hole_diameter_mm": 11.0,
        "count": 4,
    }
    made = outcome(**shaft, scatter=scatter, bolts=bolts)
    (note,) = [
        note
        for note in made.notes
        if note.startswith("Mass, balance tolerance, bending and critical speed are not computed")
    ]
    assert words in note
    assert any(note.startswith("Scatter is not computed") for note in made.notes)
    r = made.result
    assert r.mass is r.first_critical_speed is r.tolerance is r.scatter is None and r.slopes == {}
    assert r.couple > 250 and r.bolts.bolt_preload > 2e4
    assert not {"slope_front", "slope_rear", "first_critical_speed", "balance_grade"} & set(verdicts(made))


@pytest.mark.parametrize("core, clearance", [(40.5, None), (39.0, 1.5)])
def test_a_core_leaves_room_for_sectors_in_the_largest_journal(core, clearance):
    """Of 81 mm, where no outer radius is given."""
    asked = {"bearings": SEATED, "radial_clearance_mm": clearance}
    assert outcome(**asked, core_radius_mm=core - 1e-3).state == "solved"
    with pytest.raises(BadInput) as bad:
        design(document(**asked, core_radius_mm=core))
    (error,) = bad.value.errors
    assert error.key == "shafts.0.core_radius_mm"
    assert error.reason == f"must be smaller than what the largest journal leaves to the sectors, {core:g} mm"


def test_a_section_is_no_thicker_than_the_journal_that_it_is():
    thin = [{**JOURNALS[0], "diameter_mm": 59.4}, JOURNALS[1]]
    assert outcome(masses=HALVES, sections=SECTIONS, bearings=SEATED).state == "solved"
    with pytest.raises(BadInput) as bad:
        design(document(masses=HALVES, sections=SECTIONS, bearings=rows(thin)))
    (error,) = bad.value.errors
    assert error.key == "shafts.0.bearings.0.position_mm"
    assert error.reason == "its journal has a diameter of 59.4 mm, the shaft's section there of 59.5 mm"


@pytest.mark.parametrize(
    "field, unit, hole",
    [
        ("mass", "kg", lambda mass: {"mass_kg": -mass, "radius_mm": 1.0}),
        ("moment_of_inertia", "kg·mm²", lambda J: {"mass_kg": -1.0, "radius_mm": math.sqrt(J) * 1e3}),
    ],
)
def test_no_more_is_taken_away_than_stands_there(field, unit, hole):
    """A hole of nearly all of it is a hole, one of all of it is none."""
    shaft = {**CORE, "bearings": SEATED, "masses": HALVES}
    whole = getattr(result(**shaft), field)

    def holed(share):
        return outcome(**shaft, extras=[{**FRONT, **hole(share * whole)}])

    left = holed(0.999)
    assert getattr(left.result, field) == pytest.approx(0.001 * whole, rel=1e-3) and "mass_shape" not in verdicts(left)
    beyond = holed(1.001)
    (check,) = [check for check in beyond.checks if check.rule is MASS_SHAPE]
    assert check.verdict == beyond.verdict == "fail" and beyond.result.mass is None
    assert check.unit == unit and check.value / check.limit == pytest.approx(1.001)


def test_an_overhung_element_gets_a_stub_of_the_core_around_it():
    extra = {"name": "ahead", "mass_kg": 0.01, "radius_mm": 10.0, "angle_deg": 0.0, "z_mm": -202.25}
    bare, made = (result(masses=HALVES, bearings=SEATED, extras=x, **CORE) for x in ([], [extra]))
    assert bare.outline.start == pytest.approx(-0.18125) and made.outline.start == pytest.approx(2 * -0.20225 + 0.18125)
    stub = 7860 * math.pi * 0.015**2 * 0.042
    assert made.mass - bare.mass == pytest.approx(stub + 0.01, rel=1e-9)


def test_a_mass_of_nothing_is_no_sector():
    made = result(masses=[*HALVES, {**FRONT, "name": "none", "mass_kg": 0.0, "z_mm": 0.0}], bearings=SEATED, **CORE)
    assert made.slopes["front"] == pytest.approx(
        result(masses=HALVES, bearings=SEATED, **CORE).slopes["front"], rel=1e-12
    )


@pytest.mark.parametrize("degrees", [0.5, 10, 45, 90, 135, 179])
def test_a_sector_is_found_from_its_centre_of_gravity(degrees):
    gamma, R, r_0 = math.radians(degrees), 0.043, 0.015
    e = 2 / 3 * math.sin(gamma) * (R**3 - r_0**3) / (gamma * (R**2 - r_0**2))
    assert half_angle(t=narrowness(e=e, R=R, r_0=r_0)) == pytest.approx(gamma, rel=1e-9)
    mass = EccentricMass(name="a", mass=1.5, radius=e, angle=0.3, z=0.02)
    (piece,) = sectors_of((mass,), 7860.0, R, r_0)
    assert 7860 * gamma * (R**2 - r_0**2) * (piece.end - piece.start) == pytest.approx(1.5, rel=1e-9)
    assert (piece.start + piece.end) / 2 == pytest.approx(0.02) and piece.angle == 0.3


@pytest.mark.parametrize("t", [1e-300, 1e-9, 0.5, 1 - 1e-9, 1 - 2**-53])
def test_any_share_has_its_half_angle(t):
    """From all but the whole circle to all but nothing: sin γ/γ = 1 − γ²/6 + …"""
    gamma = half_angle(t=t)
    assert 0 < gamma <= math.pi and math.sin(gamma) / gamma == pytest.approx(t, abs=1e-15)


def test_a_hairline_is_no_shaft():
    """0.2 % of the largest radius."""
    piece = Piece(0.0, 0.1, 0.05, 0.0, None, 0.0, "full")
    with pytest.raises(NoOutline, match="too thin"):
        outline((piece, Piece(0.1, 0.2, 0.0000999, 0.0, None, 0.0, "core")), True)
    assert outline((piece, Piece(0.1, 0.2, 0.0001001, 0.0, None, 0.0, "core")), True).area[1] == pytest.approx(
        math.pi * 0.0001001**2
    )


@pytest.mark.parametrize("short, plain", [(1.4999e-9, True), (1.5001e-9, False)])
def test_a_sector_all_but_closed_is_no_eccentric_one(short, plain):
    """2/3·sin γ·R³ against a billionth of R³, of the largest piece."""
    pieces = (
        Piece(0.0, 0.1, 0.03, 0.0, None, 0.0, "full"),
        Piece(0.1, 0.2, 0.04, 0.0, math.pi - short, 0.0, "sector"),
        Piece(0.2, 0.3, 0.02, 0.0, None, 0.0, "full"),
    )
    assert outline(pieces, False).plain is plain


# --- what its pieces weigh, by quadrature
RINGS, RAYS = 400, 720
RHO = 7860.0


def section(R, r_0=0.0, half=180):
    """Of a sector of half angle `half` [°] on a core: area, static moment, second moment about its own centre in the
    plane of symmetry, polar moment about the axis; from rings and rays."""
    r = (np.arange(RINGS) + 0.5) * R / RINGS
    ray = (np.arange(RAYS) + 0.5) * 360 / RAYS - 180
    there = (np.abs(ray) < half) | (r[:, None] < r_0)
    dA = there * r[:, None] * R / RINGS * 2 * math.pi / RAYS
    x = r[:, None] * np.cos(np.radians(ray))
    area, moment = dA.sum(), (dA * x).sum()
    return area, moment, (dA * x**2).sum() - moment**2 / area, (dA * r[:, None] ** 2).sum()


SHAFT = (
    Piece(-0.06, -0.03, 0.02, 0.0, None, 0.0, "full"),
    Piece(-0.03, 0.02, 0.04, 0.015, math.radians(70), 0.7, "sector"),
    Piece(0.02, 0.09, 0.032, 0.012, math.radians(110), -2.0, "sector"),
)
SLICED = [section(0.02), section(0.04, 0.015, 70), section(0.032, 0.012, 110)]
LENGTHS, MIDDLES = np.array([0.03, 0.05, 0.07]), np.array([-0.045, -0.005, 0.055])
AREA, MOMENT, INERTIA, POLAR = (np.array(column) for column in zip(*SLICED))
MOMENT = MOMENT * np.exp(1j * np.array([0.0, 0.7, -2.0]))
FURTHER = (
    Extra(name="a", mass=0.2, radius=0.03, angle=0.0, z=0.05),
    Extra(name="b", mass=-0.1, radius=0.02, angle=1.0, z=-0.04),
)


def test_sections_of_the_pieces():
    shape = outline(SHAFT, False)
    assert shape.area == pytest.approx(AREA, rel=1e-4)
    assert shape.inertia == pytest.approx(INERTIA, rel=1e-4)
    assert shape.moment[1:] == pytest.approx(MOMENT[1:], rel=1e-4) and shape.moment[0] == 0
    assert (shape.start, shape.end, shape.plain) == (-0.06, 0.09, False)
    assert [piece.length for piece in SHAFT] == pytest.approx(LENGTHS)


@pytest.mark.parametrize("extras", [(), FURTHER])
def test_mass_centre_inertia_force_and_couple(extras):
    shape = outline(SHAFT, False)
    m, e, z = (np.array([getattr(extra, name) for extra in extras]) for name in ("mass", "radius", "z"))
    mass = RHO * (AREA * LENGTHS).sum() + m.sum()
    centre = (RHO * (AREA * LENGTHS * MIDDLES).sum() + (m * z).sum()) / mass
    inertia = RHO * (POLAR * LENGTHS).sum() + (m * e**2).sum()
    assert o.weighed(shape, RHO, extras) == pytest.approx((mass, centre), rel=1e-4)
    assert o.turning_inertia(shape, RHO, extras) == pytest.approx(inertia, rel=1e-4)
    omega, F_x, C_x = 100.0, 30 - 20j, 1 + 2j
    force = omega**2 * RHO * (MOMENT * LENGTHS).sum() + F_x
    couple = omega**2 * RHO * (MOMENT * LENGTHS * MIDDLES).sum() + C_x
    assert o.vectors_of(shape, RHO, omega, F_x, C_x) == pytest.approx((force, couple), rel=1e-4)


def test_a_sector_by_itself():
    """Without the core."""
    half, R, r_0, b = math.radians(70), 0.04, 0.015, 0.05
    (area, moment, *_), (core, *_) = SLICED[1], section(0.015)
    A, S = o.sector_area(gamma=half, R=R, r_0=r_0), o.sector_moment(gamma=half, R=R, r_0=r_0)
    assert o.sector_mass(rho=RHO, A=A, b=b) == pytest.approx(RHO * (area - core) * b, rel=1e-4)
    assert o.sector_unbalance(rho=RHO, S=S, b=b) == pytest.approx(RHO * moment * b, rel=1e-4)
    assert o.centre_of_gravity(S=S, A=A) == pytest.approx(moment / (area - core), rel=1e-4)


@pytest.mark.parametrize(
    "mass, radius, words",
    [
        (0.999, 0.0, None),
        (1.001, 0.0, "the further elements take away 1.236 kg, needs < 1.235 kg"),
        (0.1, math.sqrt(0.999 / 2 / 0.1), None),
        (0.1, math.sqrt(1.001 / 2 / 0.1), "the further elements take away 617.9 kg·mm², needs < 617.3 kg·mm²"),
    ],
)
@pytest.mark.parametrize("beside", [(), (Extra(name="a", mass=0.5, radius=0.05, angle=0.0, z=0.0),)])
def test_holes_of_a_plain_shaft(mass, radius, words, beside):
    """A cylinder of m and m·R²/2; what is added elsewhere fills no hole."""
    R = math.sqrt(1e-3)
    shape = outline((Piece(0.0, 0.05, R, 0.0, None, 0.0, "full"),), False)
    whole = 7860 * math.pi * 1e-3 * 0.05
    share = mass / 2
    holes = [Extra(name="h", mass=-share * whole, radius=radius * R, angle=0.0, z=0.0)] * 2
    if words is None:
        o.hollowed(shape, 7860.0, (*holes, *beside))
        return
    with pytest.raises(NoOutline) as none:
        o.hollowed(shape, 7860.0, (*holes, *beside))
    assert none.value.reason == words


# --- put together, piece by piece
INPUTS = design(document(core_radius_mm=15.0)).countershaft
SEATS = (0.0595, 0.0275), (0.081, 0.0265)


def core(start, end):
    return Piece(start, end, 0.015, 0.0, None, 0.0, "core")


def turned(start, end, R, what):
    return Piece(start, end, R, 0.0, None, 0.0, what)


def sector(start, end):
    return Piece(start, end, 0.0403, 0.015, 1.2, 0.3, "sector")


JOURNAL_1, JOURNAL_2 = turned(-0.18125, -0.15375, 0.02975, "journal"), turned(0.15425, 0.18075, 0.0405, "journal")
MIDDLE = (core(-0.15375, -0.152), sector(-0.152, -0.001), core(-0.001, 0.15425))


def at(*places):
    return {"extras": tuple(Extra(name="x", mass=0.1, radius=0.01, angle=0.0, z=z) for z in places)}


def told(pieces):
    return [(round(p.start, 9), round(p.end, 9), round(p.outer_radius, 9), *list(vars(p).values())[3:]) for p in pieces]


@pytest.mark.parametrize(
    "sectors, changes, gear, pieces",
    [
        ([sector(-0.152, -0.001)], {}, None, [JOURNAL_1, *MIDDLE, JOURNAL_2]),
        # without a place the gear stands against the front journal
        (
            [sector(-0.152, -0.001)],
            {},
            (0.058, 0.015),
            [turned(-0.19625, -0.18125, 0.029, "gear"), JOURNAL_1, *MIDDLE, JOURNAL_2],
        ),
        (
            [sector(-0.152, -0.001)],
            {"gear_z": -0.2},
            (0.058, 0.015),
            [turned(-0.2075, -0.1925, 0.029, "gear"), core(-0.1925, -0.18125), JOURNAL_1, *MIDDLE, JOURNAL_2],
        ),
        (
            [sector(-0.152, -0.001)],
            {"gear_z": 0.2},
            (0.058, 0.015),
            [JOURNAL_1, *MIDDLE, JOURNAL_2, core(0.18075, 0.1925), turned(0.1925, 0.2075, 0.029, "gear")],
        ),
        # a stub around what is overhung, as far beyond as before it
        (
            [sector(-0.152, -0.001)],
            at(-0.19, 0.2),
            None,
            [core(-0.19875, -0.18125), JOURNAL_1, *MIDDLE, JOURNAL_2, core(0.18075, 0.21925)],
        ),
        ([sector(-0.152, -0.001)], at(-0.18, 0.0, 0.18), None, [JOURNAL_1, *MIDDLE, JOURNAL_2]),
        ([], {}, None, [JOURNAL_1, core(-0.15375, 0.15425), JOURNAL_2]),
        # what is nearer than a micrometre touches, and may reach in as far
        (
            [sector(-0.1537492, 0.1542508)],
            {},
            None,
            [JOURNAL_1, sector(-0.1537492, 0.1542508), JOURNAL_2],
        ),
        (
            [sector(-0.1537508, 0.1542492)],
            {},
            None,
            [JOURNAL_1, sector(-0.1537508, 0.1542492), JOURNAL_2],
        ),
        (
            [sector(-0.1537488, 0.1542488)],
            {},
            None,
            [JOURNAL_1, core(-0.15375, -0.1537488), sector(-0.1537488, 0.1542488), core(0.1542488, 0.15425), JOURNAL_2],
        ),
    ],
)
def test_pieces_of_an_assembled_shaft(sectors, changes, gear, pieces):
    with trace() as lines:
        shape = o.assembled(replace(INPUTS, **changes), sectors, SEATS, gear)
    assert told(shape.pieces) == told(pieces) and shape.derived
    subjects = ["journal 1", "journal 2"] + (["gear on the shaft"] if gear else [])
    assert list(dict.fromkeys(line.about for line in lines if line.about))[: len(subjects)] == subjects


def test_pieces_of_given_sections():
    """In their order along the shaft; what is not said is none."""
    shape = o.given(design(document(masses=HALVES, sections=SECTIONS[::-1])).countershaft)
    half = math.radians(90.0)
    assert told(shape.pieces) == told(
        [
            turned(-0.18125, -0.15375, 0.02975, "full"),
            turned(-0.15375, -0.152, 0.015, "full"),
            Piece(-0.152, -0.001, 0.0403, 0.015, half, math.radians(210.0), "sector"),
            turned(-0.001, 0.001, 0.015, "full"),
            Piece(0.001, 0.152, 0.0403, 0.015, half, math.radians(30.0), "sector"),
            turned(0.152, 0.15425, 0.015, "full"),
            turned(0.15425, 0.18075, 0.0405, "full"),
        ]
    )


@pytest.mark.parametrize(
    "core_radius, R, journals, missing",
    [
        (None, 0.04, SEATS, "core_radius_mm"),
        (0.015, None, SEATS, "outer_radius_mm"),
        (0.015, 0.04, (), "diameter and length of the bearings"),
        (None, None, (), "core_radius_mm and outer_radius_mm and diameter and length of the bearings"),
    ],
)
def test_what_an_outline_needs(core_radius, R, journals, missing):
    with pytest.raises(NoOutline) as none:
        o.known(replace(INPUTS, core_radius=core_radius), R, journals)
    assert none.value.reason == f"give [[shafts.sections]], or {missing}"
    assert o.known(INPUTS, 0.04, SEATS) == (0.04, 0.015)


@pytest.mark.parametrize(
    "radius, within",
    [(0.0, ""), (0.03, " (it stays below 29.39 mm)"), (0.0294, " (it stays below 29.39 mm)"), (0.0293, None)],
)
def test_a_mass_that_no_sector_has(radius, within):
    """2/3·(40³ − 15³)/(40² − 15²) = 29.39 mm for the narrowest."""
    mass = EccentricMass(name="a", mass=1.0, radius=radius, angle=0.0, z=0.0)
    if within is None:
        assert sectors_of((mass,), RHO, 0.04, 0.015)
        return
    with pytest.raises(NoOutline) as none:
        sectors_of((mass,), RHO, 0.04, 0.015)
    place = f"from 15 to 40 mm has its centre of gravity at {radius * 1e3:g} mm{within}"
    assert none.value.reason == f"mass a: no sector {place}"


def test_the_gear_stands_where_it_is_put_or_against_the_front_journal(gamma):
    for place, start in ((None, -167.5 - 27.5 / 2 - 15.0), (-200.0, -207.5)):
        document = gamma if place is None else gamma.with_value("shafts.shaft.gear_z_mm", place)
        pieces = solve(design(document)).outcomes["countershaft"].result.outline.pieces
        (gear,) = [p for p in pieces if p.what == "gear"]
        assert gear.start * 1e3 == pytest.approx(start) and (gear.end - gear.start) * 1e3 == pytest.approx(15.0)
        assert gear.outer_radius * 1e3 == pytest.approx(2 * 25 / math.cos(math.radians(21.916)) / 2, rel=1e-9)


def test_outer_radius_of_a_given_shaft_is_that_of_the_largest_seat():
    left_out, said = (result(core_radius_mm=15.0, bearings=SEATED, outer_radius_mm=R) for R in (None, 40.5))
    assert max(p.outer_radius for p in left_out.outline.pieces if p.what == "sector") == 0.0405
    assert left_out.slopes["front"] == said.slopes["front"]
    threaded = result(core_radius_mm=14.0, bearings=SEATED, radial_clearance_mm=0.1)
    assert max(p.outer_radius for p in threaded.outline.pieces if p.what == "sector") == pytest.approx(0.0404)


# --- hollow shafts, and sectors of a heavier material
BORE, HEAVIER, RHO = 0.009, 17600 / 7860, 7860.0


def fibres(piece, bore=0.0, heavier=1.0):
    """The section of a piece cut into small patches: their areas, places and densities over that of the core."""
    r = (np.arange(1500) + 0.5) / 1500 * piece.outer_radius
    phi = (np.arange(1440) + 0.5) / 1440 * 2 * math.pi
    dA = r[:, None] * (piece.outer_radius / 1500) * (2 * math.pi / 1440) * np.ones_like(phi)
    z = r[:, None] * np.exp(1j * phi)
    core = r[:, None] < (piece.outer_radius if piece.half_angle is None else piece.core_radius)
    around = np.angle(np.exp(1j * (phi - piece.angle)))
    sector = ~core & (np.abs(around) < (piece.half_angle or 0.0))
    there = (core | sector) & (r[:, None] > bore)
    return np.where(there, dA, 0.0).ravel(), z.ravel(), np.where(sector, heavier, 1.0).ravel()


@pytest.mark.parametrize("bore, heavier", [(0.0, HEAVIER), (BORE, 1.0), (BORE, HEAVIER)])
def test_a_bore_and_heavy_sectors_against_the_patches_of_each_section(bore, heavier):
    solid = drawn_shaft(60.0, 110.0)
    shape = outline(solid.pieces, derived=True, bore=bore, heavier=heavier)
    lengths = np.array([part.length for part in shape.pieces])
    middles = np.array([(part.start + part.end) / 2 for part in shape.pieces])
    weights, moments, inertias = [], [], []
    for n, part in enumerate(shape.pieces):
        dA, z, density = fibres(part, bore, heavier)
        assert shape.area[n] == pytest.approx(dA.sum(), rel=2e-3)
        assert shape.moment[n] == pytest.approx((dA * z).sum(), abs=3e-3 * part.outer_radius**3)
        own = z * np.exp(-1j * part.angle)
        own -= (dA * own).sum() / dA.sum()
        assert shape.inertia[n] == pytest.approx((dA * own.real**2).sum(), rel=5e-3)
        weights.append((dA * density).sum())
        moments.append((dA * density * z).sum())
        inertias.append((dA * density * abs(z) ** 2).sum())
    m, z_S = o.weighed(shape, RHO, ())
    assert m == pytest.approx(RHO * np.dot(weights, lengths), rel=2e-3)
    assert z_S == pytest.approx(np.dot(weights, lengths * middles) / np.dot(weights, lengths), abs=1e-4)
    assert o.turning_inertia(shape, RHO, ()) == pytest.approx(RHO * np.dot(inertias, lengths), rel=2e-3)
    F, C = o.vectors_of(shape, RHO, 300.0, 0j, 0j)
    force = 300.0**2 * RHO * np.dot(moments, lengths)
    assert F == pytest.approx(force, abs=5e-3 * abs(force))
    assert C == pytest.approx(300.0**2 * RHO * np.dot(moments, lengths * middles), rel=5e-3)


def test_a_bore_takes_nothing_of_the_force_and_heavy_sectors_give_in_proportion():
    solid = drawn_shaft()
    hollow, heavy = (outline(solid.pieces, True, **kind) for kind in ({"bore": BORE}, {"heavier": HEAVIER}))
    whole = np.array(o.vectors_of(solid, RHO, 300.0, 0j, 0j))
    assert np.array(o.vectors_of(hollow, RHO, 300.0, 0j, 0j)) == pytest.approx(whole, rel=1e-12)
    assert np.array(o.vectors_of(heavy, RHO, 300.0, 0j, 0j)) == pytest.approx(HEAVIER * whole, rel=1e-12)
    bore = math.pi * BORE**2 * (solid.end - solid.start)
    assert o.weighed(solid, RHO, ())[0] - o.weighed(hollow, RHO, ())[0] == pytest.approx(RHO * bore, rel=1e-9)


@pytest.mark.parametrize("bar", [piece(-500, 500, 12, "full"), piece(-500, 500, 12, "sector", 40.0, 0.0, 11)])
def test_a_tube_is_stiffer_for_its_mass(bar):
    """The first natural frequency of a slender one goes with √(I/A), of a narrow sector with that of bending sideways;
    of a full one that makes √(1 + (r_b/R)²) of the solid bar's."""
    first = [
        bending(outline((bar,), False, bore=bore), materials()["20CrNi4"], 100.0, (-0.49, 0.49)).natural_frequency
        for bore in (0.0, BORE)
    ]
    dA, z, _ = fibres(bar)
    tube = abs(z) > BORE
    I, A = (dA * z.imag**2)[tube].sum() / (dA * z.imag**2).sum(), dA[tube].sum() / dA.sum()
    assert first[1] / first[0] == pytest.approx(math.sqrt(I / A), rel=3e-3)
    if bar.half_angle is None:
        assert first[1] / first[0] == pytest.approx(math.sqrt(1 + (BORE / 0.012) ** 2), rel=3e-3)


def test_heavy_sectors_slow_the_shaft_down():
    bar = piece(-500, 500, 12, "sector", 100.0, 0.0, 9)
    plain, heavy = (outline((bar,), False, heavier=ratio) for ratio in (1.0, HEAVIER))
    first = [bending(x, materials()["20CrNi4"], 100.0, (-0.49, 0.49)).natural_frequency for x in (plain, heavy)]
    assert first[1] / first[0] == pytest.approx(math.sqrt(plain.area.item() / heavy.weighing_area.item()), rel=3e-3)


def sag(shape, steel, omega):
    """The largest deflection between its supports by moments and shears, both integrated along the shaft."""
    z, dz = np.linspace(shape.start, shape.end, 200_001, retstep=True)
    n = np.searchsorted([part.end for part in shape.pieces[:-1]], z)
    q = omega**2 * steel.density * (shape.weighing_moment * np.exp(-1j * UP)).real[n]
    front, rear = POSITIONS
    R_r = -np.sum(q * (z - front)) * dz / (rear - front)
    V = np.cumsum(q) * dz + (-q.sum() * dz - R_r) * (z >= front) + R_r * (z >= rear)
    slope = np.cumsum(np.cumsum(V) * dz / (steel.E * shape.inertia[n])) * dz
    G = shear_modulus(E=steel.E, nu=steel.poisson)
    w = np.cumsum(slope - V / (shear_coefficient(nu=steel.poisson) * G * shape.area[n])) * dz
    ends = np.interp(POSITIONS, z, w)
    return np.abs(w - np.interp(z, POSITIONS, ends))[(z > front) & (z < rear)].max()


def test_a_hollow_shaft_with_heavy_sectors_bends_as_its_moments_say():
    solid, steel, omega = drawn_shaft(), materials()["20CrNi4"], 10.0  # so slow that it is bent by its sectors alone
    for kind in ({}, {"bore": BORE}, {"heavier": HEAVIER}, {"bore": BORE, "heavier": HEAVIER}):
        shape = outline(solid.pieces, True, **kind)
        between = slice(*np.searchsorted(bending(shape, steel, omega, POSITIONS).z, POSITIONS))
        found = np.abs(bending(shape, steel, omega, POSITIONS).vectors)[between].max()
        assert found == pytest.approx(sag(shape, steel, omega), rel=1e-2)


def test_where_sectors_lend_no_stiffness_the_ring_of_the_core_bends():
    solid, steel = drawn_shaft(), materials()["20CrNi4"]
    plain, hollow = (
        np.abs(bending(outline(solid.pieces, True, bore=bore), steel, 10.0, POSITIONS, effectiveness=0.0).vectors).max()
        for bore in (0.0, BORE)
    )
    ring = 1 / (1 - (BORE / 0.015) ** 4)
    assert 1 + 0.8 * (ring - 1) < hollow / plain < 1.05 * ring


def test_a_bore_that_leaves_nothing_is_told():
    with pytest.raises(NoOutline, match=r"a bore of 30 mm leaves nothing of the core"):
        outline(drawn_shaft().pieces, True, bore=0.015)
    with pytest.raises(NoOutline, match="leaves nothing of the sector"):
        outline((piece(-10, 10, 20, "sector", 90.0, 0.0, 8),), False, bore=0.008)


def test_a_fillet_without_room_in_an_outline_put_together_is_said_and_not_judged(gamma_results):
    """Gamma's front sector ends 0.4 mm before its journal, with a fillet of 1.5 mm at either end of that."""
    told = [str(note) for note in gamma_results.outcomes["countershaft"].notes if "for each fillet" in note]
    room = gamma_results.shaft.bending.fillet_room * 1e3
    assert len(told) == 1 and f"leaves {room:.2g} mm for each fillet" in told[0] and "less than the 1.5 mm" in told[0]
    assert not any("fillet_room" in c.id for c in gamma_results.checks())
