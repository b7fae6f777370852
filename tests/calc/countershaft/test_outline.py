"""The outline: given as sections, or put together from what is known; and what is said where it can not be."""

import math

import pytest

from calc.countershaft.inputs import EccentricMass
from calc.countershaft.outline import MASS_SHAPE, NoOutline, Piece, half_angle, narrowness, outline, sectors_of
from calc.design.toml_file import design
from calc.sheet.errors import BadInput
from calc.solve import solve
from tests.calc.countershaft.shafts import FRONT, JOURNALS, REAR, document, outcome, result, verdicts

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
    "slope_front",
    "slope_rear",
    "slope_front_stiff",
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
    derived = result(masses=HALVES, journals=JOURNALS, sector_effectiveness=share, **CORE)
    assert derived.outline.derived and not given.outline.derived
    assert [p.what for p in derived.outline.pieces] == "journal core sector core sector core journal".split()
    for name in SAME:
        assert value(derived, name) == pytest.approx(value(given, name), rel=1e-5), name
    assert given.outline_couple_deviation < 1e-4 and given.outline_force_deviation < 1e-3
    assert derived.outline_couple_deviation is derived.outline_force_deviation is None


def test_the_order_of_the_sections_in_the_file_does_not_matter():
    forward, backward = result(masses=HALVES, sections=SECTIONS), result(masses=HALVES, sections=SECTIONS[::-1])
    assert forward.slope_rear == backward.slope_rear and forward.mass == backward.mass


@pytest.mark.parametrize(
    "shaft, words",
    [
        ({"journals": JOURNALS, "outer_radius_mm": 40.5}, "core_radius_mm"),
        ({**CORE}, "[bearings] or [[countershaft.journals]]"),
        ({}, "outer_radius_mm and [bearings]"),
        ({**CORE, "core_radius_mm": 0.0, "journals": JOURNALS, "masses": HALVES}, "too thin"),
        ({**CORE, "journals": JOURNALS, "masses": [{**FRONT, "mass_kg": 4.0}, REAR]}, "crosses"),
        (
            {**CORE, "journals": JOURNALS, "masses": [{**FRONT, "radius_mm": 40.0}, REAR]},
            "mass front: no sector from 15 to 40.3 mm",
        ),
        ({**CORE, "journals": JOURNALS, "masses": [{**FRONT, "z_mm": 0.0}, REAR]}, "crosses"),
        (
            {**CORE, "journals": JOURNALS, "masses": HALVES, "extras": [{**FRONT, "mass_kg": -20.0}]},
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
    assert r.mass is r.slope_front is r.first_critical_speed is r.tolerance is r.scatter is None
    assert r.couple > 250 and r.bolts.bolt_preload > 2e4
    assert not {"slope_front", "first_critical_speed", "balance_grade"} & set(verdicts(made))


@pytest.mark.parametrize("core, clearance", [(40.5, None), (39.0, 1.5)])
def test_a_core_leaves_room_for_sectors_in_the_largest_journal(core, clearance):
    """Of 81 mm, where no outer radius is given."""
    asked = {"journals": JOURNALS, "radial_clearance_mm": clearance}
    assert outcome(**asked, core_radius_mm=core - 1e-3).state == "solved"
    with pytest.raises(BadInput) as bad:
        design(document(**asked, core_radius_mm=core))
    (error,) = bad.value.errors
    assert error.key == "countershaft.core_radius_mm"
    assert error.reason == f"must be smaller than what the largest journal leaves to the sectors, {core:g} mm"


def test_a_section_is_no_thicker_than_the_journal_that_it_is():
    thin = [{**JOURNALS[0], "diameter_mm": 59.4}, JOURNALS[1]]
    assert outcome(masses=HALVES, sections=SECTIONS, journals=JOURNALS).state == "solved"
    with pytest.raises(BadInput) as bad:
        design(document(masses=HALVES, sections=SECTIONS, journals=thin))
    (error,) = bad.value.errors
    assert error.key == "countershaft.bearing_positions_mm.0"
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
    shaft = {**CORE, "journals": JOURNALS, "masses": HALVES}
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
    bare, made = (result(masses=HALVES, journals=JOURNALS, extras=x, **CORE) for x in ([], [extra]))
    assert bare.outline.start == pytest.approx(-0.18125) and made.outline.start == pytest.approx(2 * -0.20225 + 0.18125)
    stub = 7860 * math.pi * 0.015**2 * 0.042
    assert made.mass - bare.mass == pytest.approx(stub + 0.01, rel=1e-9)


def test_a_mass_of_nothing_is_no_sector():
    made = result(masses=[*HALVES, {**FRONT, "name": "none", "mass_kg": 0.0, "z_mm": 0.0}], journals=JOURNALS, **CORE)
    assert made.slope_front == pytest.approx(result(masses=HALVES, journals=JOURNALS, **CORE).slope_front, rel=1e-12)


@pytest.mark.parametrize("degrees", [0.5, 10, 45, 90, 135, 179])
def test_a_sector_is_found_from_its_centre_of_gravity(degrees):
    gamma, R, r_0 = math.radians(degrees), 0.043, 0.015
    e = 2 / 3 * math.sin(gamma) * (R**3 - r_0**3) / (gamma * (R**2 - r_0**2))
    assert half_angle(t=narrowness(e=e, R=R, r_0=r_0)) == pytest.approx(gamma, rel=1e-9)
    mass = EccentricMass(name="a", mass=1.5, radius=e, angle=0.3, z=0.02)
    (piece,) = sectors_of((mass,), 7860.0, R, r_0)
    assert 7860 * gamma * (R**2 - r_0**2) * (piece.end - piece.start) == pytest.approx(1.5, rel=1e-9)
    assert (piece.start + piece.end) / 2 == pytest.approx(0.02) and piece.angle == 0.3


def test_a_hairline_is_no_shaft():
    piece = Piece(0.0, 0.1, 0.05, 0.0, None, 0.0, "full")
    with pytest.raises(NoOutline, match="too thin"):
        outline((piece, Piece(0.1, 0.2, 0.00009, 0.0, None, 0.0, "core")), True)
    assert outline((piece, Piece(0.1, 0.2, 0.00011, 0.0, None, 0.0, "core")), True).area[1] == pytest.approx(
        math.pi * 0.00011**2
    )


def test_the_gear_stands_where_it_is_put_or_against_the_front_journal(gamma):
    for place, start in ((None, -167.5 - 27.5 / 2 - 15.0), (-200.0, -207.5)):
        document = gamma if place is None else gamma.with_value("countershaft.gear_z_mm", place)
        pieces = solve(design(document)).outcomes["countershaft"].result.outline.pieces
        (gear,) = [p for p in pieces if p.what == "gear"]
        assert gear.start * 1e3 == pytest.approx(start) and (gear.end - gear.start) * 1e3 == pytest.approx(15.0)
        assert gear.outer_radius * 1e3 == pytest.approx(2 * 25 / math.cos(math.radians(21.916)) / 2, rel=1e-9)


def test_outer_radius_of_a_given_shaft_is_that_of_the_largest_seat():
    left_out, said = (result(core_radius_mm=15.0, journals=JOURNALS, outer_radius_mm=R) for R in (None, 40.5))
    assert max(p.outer_radius for p in left_out.outline.pieces if p.what == "sector") == 0.0405
    assert left_out.slope_front == said.slope_front
    threaded = result(core_radius_mm=14.0, journals=JOURNALS, radial_clearance_mm=0.1)
    assert max(p.outer_radius for p in threaded.outline.pieces if p.what == "sector") == pytest.approx(0.0404)
