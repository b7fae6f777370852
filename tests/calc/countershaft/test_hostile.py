"""What a design file may say of the counter-shaft and should not: every error named with its line, all at once, and
never a traceback."""

import math
import re
from itertools import pairwise

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from calc.design.toml_file import Document, design, parse
from calc.sheet.errors import BadInput
from calc.solve import solve

HEAD = """schema = 2
name = "d"
[engine]
name = "three"
layout = "inline"
cylinders = 3
strokes = 4
bore_mm = 94.0
crank_radius_mm = 53.5
rod_length_mm = 163.0
cylinder_pitch_mm = 112.0
firing_order = [1, 3, 2]
piston_mass_g = 1178.0
rod_mass_g = 1015.0
rated_speed_rpm = 2600.0
[imbalance]
crank_balance_fraction = 0.5
kinematics = "exact"
[[shafts]]
name = "shaft"
mode = "given"
material = "20CrNi4"
speed_ratio = -1
masses = [{ name = "front", mass_kg = 2.6, radius_mm = 18.8, angle_deg = 210.0, z_mm = -76.5 }]
"""
REAR_ROW = """[[shafts.bearings]]
name = "rear"
position_mm = 167.5
"""
ROWS = (
    """[[shafts.bearings]]
name = "front"
position_mm = -167.5
"""
    + REAR_ROW
)
# what is told where it stands, not where something was added
ELSEWHERE = {
    "bearings.0.position_mm": "position_mm = -167.5",
    "bearings.1.position_mm": "position_mm = 167.5",
    "material": 'material = "20CrNi4"',
}
FIRST = HEAD.count("\n") + 1  # line of what is added


def errors(text):
    with pytest.raises(BadInput) as bad:
        design(parse(text.encode(), "d.toml"))
    return str(bad.value).splitlines()


SECTION = "sections = [{ from_mm = %s, to_mm = %s, outer_radius_mm = %s%s }]\n"
BOLTS = """[shafts.bolts]
thread = "%s"
torque_Nm = %s
friction = 0.12
head_diameter_mm = %s
hole_diameter_mm = %s
count = %s
"""
DRAIN = '[shafts.oil_drain]\nhose_min_mm = %s\nhose_max_mm = %s\nthread = "%s"\n'
SCATTER = "[shafts.scatter]\nmass_g = %s\nradius_mm = 0.05\nangle_deg = 0.1\nz_mm = 0.1\nshafts = %s\n"


@pytest.mark.parametrize(
    "added, key, words",
    [
        (SECTION % (-200, 200, -15, ""), "sections.0.outer_radius_mm", "above 0"),
        (SECTION % (200, -200, 15, ""), "sections.0.to_mm", "behind from_mm"),
        (SECTION % (-200, -200, 15, ""), "sections.0.to_mm", "behind from_mm"),
        (SECTION % ("nan", 200, 15, ""), "sections.0.from_mm", "finite"),
        (SECTION % (-200, 200, "inf", ""), "sections.0.outer_radius_mm", "finite"),
        (SECTION % (-200, 200, 15, ", half_angle_deg = 90.0"), "sections.0.angle_deg", "needed with half_angle_deg"),
        (
            SECTION % (-200, 200, 15, ", half_angle_deg = 190.0, angle_deg = 0.0"),
            "sections.0.half_angle_deg",
            "up to 180",
        ),
        (
            SECTION % (-200, 200, 15, ", half_angle_deg = 90.0, angle_deg = 0.0, core_radius_mm = 15.0"),
            "sections.0.core_radius_mm",
            "smaller",
        ),
        (SECTION % (-200, 200, 15, ", core_radius_mm = 5.0"), "sections.0.core_radius_mm", "belongs to a sector"),
        (SECTION % (-160, 200, 15, ""), "bearings.0.position_mm", "outside the shaft's sections"),
        (SECTION % (-200, 100, 15, ""), "bearings.1.position_mm", "outside the shaft's sections"),
        (
            "sections = [{ from_mm = -200.0, to_mm = 10.0, outer_radius_mm = 15.0 }, { from_mm = 0.0, to_mm = 200.0, "
            "outer_radius_mm = 15.0 }]\n",
            "sections.1.from_mm",
            "crosses section 0",
        ),
        (
            "sections = [{ from_mm = 5.0, to_mm = 200.0, outer_radius_mm = 15.0 }, { from_mm = -200.0, to_mm = 0.0, "
            "outer_radius_mm = 15.0 }]\n",
            "sections.0.from_mm",
            "leaves a gap behind section 1",
        ),
        (
            SECTION % (-180, 180, 15, "")
            + 'extras = [{ name = "x", mass_kg = 0.1, radius_mm = 1.0, angle_deg = 0.0, z_mm = 300.0 }]\n',
            "extras.0.z_mm",
            "outside the shaft's sections",
        ),
        ("outer_radius_mm = 40.0\ncore_radius_mm = 40.0\n", "core_radius_mm", "smaller than outer_radius_mm"),
        ("sector_effectiveness = 0.0\n", "sector_effectiveness", "from 0.1 to 1"),
        ('balance_grade = "G5"\n', "balance_grade", '"G6.3"'),
        ('pair = "yes"\n', "pair", "is not known"),
        ('mirrors = "other"\n', "material", "is that of its original, other: leave it out here"),
        ("outer_radius_mm = " + "9" * 400 + "\n", "outer_radius_mm", "up to 1000"),
        ("radial_clearance_mm = -0.1\n", "radial_clearance_mm", "from 0 to 50"),
        ("fillet_radius_mm = 0\n", "fillet_radius_mm", "above 0"),
        ("holes = { diameter_mm = 14.0, depth_mm = 20.0, count = 0 }\n", "holes.count", "from 1 to 1000"),
        ("holes = { diameter_mm = 14.0, depth_mm = 20.0, count = 2.0 }\n", "holes.count", "whole number"),
        (
            "outer_radius_mm = 20.0\nholes = { diameter_mm = 14.0, depth_mm = 20.0, count = 2 }\n",
            "holes.depth_mm",
            "must stay below outer_radius_mm",
        ),
        (BOLTS % ("10", 45, 15, 11, 4), "bolts.thread", "metric thread"),
        (BOLTS % ("M10x9", 45, 15, 11, 4), "bolts.thread", "pitch of M10"),
        (BOLTS % ("M999", 45, 15, 11, 4), "bolts.thread", "ISO 261"),
        (BOLTS % ("", 45, 15, 11, 4), "bolts.thread", "metric thread"),
        (BOLTS % ("M10", 0, 15, 11, 4), "bolts.torque_Nm", "above 0"),
        (BOLTS % ("M10", 45, 11, 11, 4), "bolts.hole_diameter_mm", "bears on nothing"),
        (BOLTS % ("M10", 45, 15, 10, 4), "bolts.hole_diameter_mm", "larger than the thread"),
        (BOLTS % ("M10", 45, 15, 11, 1), "bolts.count", "from 2 to 64"),
        (DRAIN % (24.0, 22.5, "M18x1.5"), "oil_drain.hose_max_mm", "not be below hose_min_mm"),
        (DRAIN % (22.5, 24.0, "G1/2"), "oil_drain.thread", "metric thread"),
        (
            DRAIN % (22.5, 24.0, "M18") + "clamps = [{ nominal_mm = 22.0, opening_mm = 22.0 }]\n",
            "oil_drain.clamps.0.opening_mm",
            "larger",
        ),
        (SCATTER % (-1, 100), "scatter.mass_g", "from 0"),
        (SCATTER % (10, 0), "scatter.shafts", "from 100"),
        ('support = { material = "cheese" }\n', "support.material", "is not known"),
        (
            'cost = { pieces_per_year = 0, alternatives = [{ material = "steel", tooling_EUR = 1.0, piece_EUR = 1.0 '
            "}] }\n",
            "cost.pieces_per_year",
            "1",
        ),
        (
            'cost = { pieces_per_year = 1, alternatives = [{ material = "stell", tooling_EUR = 1.0, piece_EUR = 1.0 '
            "}] }\n",
            "cost.alternatives.0.material",
            '"steel"',
        ),
        (
            'cost = { pieces_per_year = 1, alternatives = [{ material = "steel", tooling_EUR = 1.0, piece_EUR = 1.0 }, '
            '{ material = "steel", tooling_EUR = 1.0, piece_EUR = 1.0 }] }\n',
            "cost.alternatives",
            "once",
        ),
    ],
)
def test_it_is_refused_by_its_key_and_line(added, key, words):
    text = HEAD + added + ROWS
    found = [line for line in errors(text) if f"shafts.0.{key}:" in line]
    assert found and words in found[0], errors(text)
    named = int(found[0].split(":")[1])
    if key in ELSEWHERE:
        assert text.splitlines()[named - 1] == ELSEWHERE[key]
    else:
        assert FIRST <= named < FIRST + added.count("\n")


@pytest.mark.parametrize(
    "old, new, key, words",
    [
        ("mass_kg = 2.6", "mass_kg = -2.6", "masses.0.mass_kg", "from 0"),
        ("mass_kg = 2.6", "mass_kg = nan", "masses.0.mass_kg", "finite"),
        ("z_mm = -76.5", "z_mm = -376.5", "masses.0.z_mm", "outside the span of the bearings"),
        ("z_mm = -76.5", "z_mm = 1e308", "masses.0.z_mm", "from −5000 to 5000"),
        ("position_mm = 167.5", "position_mm = -168.5", "bearings.1.position_mm", "rise"),
        (REAR_ROW, "", "bearings", "needs 2 to 9"),
        ("position_mm = 167.5", "position_mm = inf", "bearings.1.position_mm", "finite"),
        (
            REAR_ROW,
            REAR_ROW + "diameter_mm = 40.0\nlength_mm = 20.0\n",
            "bearings.1.diameter_mm",
            "of all bearings, or of none",
        ),
        ("speed_ratio = -1", "speed_ratio = -1.5", "speed_ratio", "-1, 1, -2 or 2"),
        ("speed_ratio = -1", "speed_ratio = 0", "speed_ratio", "-1, 1, -2 or 2"),
        ("speed_ratio = -1\n", "", "speed_ratio", "is missing"),
        ('"20CrNi4"', '"20CrNi5"', "material", '"20CrNi4"'),
        ('mode = "given"', 'mode = "guess"', "mode", '"given", "size"'),
    ],
)
def test_what_the_head_says_wrongly(old, new, key, words):
    assert (HEAD + ROWS).count(old) == 1
    found = [line for line in errors((HEAD + ROWS).replace(old, new)) if f"shafts.0.{key}:" in line]
    assert found and words in found[0]


def test_a_journal_ends_within_the_sections():
    seated = re.sub(r"(position_mm = -?167.5\n)", r"\1diameter_mm = 40.0\nlength_mm = 20.0\n", ROWS)
    text = HEAD + SECTION % (-170, 170, 15, "") + seated
    front, rear = errors(text)
    for i, line in enumerate((front, rear)):
        key = f"bearings.{i}.position_mm"
        assert f"shafts.0.{key}:" in line and "reaches beyond" in line
        assert text.splitlines()[int(line.split(":")[1]) - 1] == ELSEWHERE[key]


def test_one_row_is_told_once():
    (only,) = errors((HEAD + ROWS).replace(REAR_ROW, ""))
    assert "shafts.0.bearings: needs 2 to 9 rows [[shafts.bearings]]; has 1" in only


def test_size_without_envelope_names_all_three_at_once():
    found = errors((HEAD + ROWS).replace('mode = "given"', 'mode = "size"'))
    assert [line.split(": ")[1] for line in found] == [
        f"shafts.0.{name}_mm" for name in ("outer_radius", "core_radius", "half_length")
    ]


def test_all_errors_come_at_once_each_with_its_line():
    text = HEAD.replace("mass_kg = 2.6", "mass_kg = -1") + "outer_radius_mm = -1\n" + 'balance_grade = "G5"\n'
    text += BOLTS % ("M", 45, 15, 11, 0) + DRAIN % (24.0, 22.5, "x") + ROWS
    found = {line.split(": ")[1]: int(line.split(":")[1]) for line in errors(text)}
    lines = text.splitlines()
    assert {key.removeprefix("shafts.0.") for key in found} == {
        "masses.0.mass_kg",
        "outer_radius_mm",
        "balance_grade",
        "bolts.thread",
        "bolts.count",
        "oil_drain.hose_max_mm",
        "oil_drain.thread",
    }
    for key, number in found.items():
        assert key.rsplit(".", 1)[1] in lines[number - 1]


# --- by chance
ODD = st.sampled_from([0.0, -1.0, 1e-9, 1e9, math.inf, math.nan, "x", True, None, [], {}])
MATERIALS = st.sampled_from(["20CrNi4", "steel", "EN AC-43100", "42CrMo4"])
number = st.floats


def table(parts, **optional):
    return st.fixed_dictionaries(parts, optional=optional)


def rows(most, **parts):
    return st.lists(st.fixed_dictionaries(parts), max_size=most, unique_by=lambda row: row["name"])


def elements(low, high, reach=140):
    return rows(
        3,
        name=st.sampled_from(["one", "two", "three"]),
        mass_kg=number(low, high),
        radius_mm=number(0, 40),
        angle_deg=number(-360, 360),
        z_mm=number(-reach, reach),
    )


@st.composite
def sections(draw):
    """Touching stretches from end to end, some of them sectors."""
    ends = [-220.0, *sorted(draw(st.lists(number(-219, 219), max_size=4, unique_by=round))), 220.0]
    made = []
    for start, end in pairwise(ends):
        made.append({"from_mm": start, "to_mm": end, "outer_radius_mm": draw(number(16, 60))})
        if draw(st.booleans()):
            made[-1] |= {
                "core_radius_mm": draw(number(0, 15)),
                "half_angle_deg": draw(number(1, 180)),
                "angle_deg": draw(number(-360, 360)),
            }
    return made


def rows_at(positions):
    return [{"name": f"seat-{n}", "position_mm": z} for n, z in enumerate(positions)]


def seats(positions):
    sizes = {"diameter_mm": number(10, 120), "length_mm": number(5, 40)}
    return st.tuples(*(table({key: st.just(x) for key, x in row.items()} | sizes) for row in rows_at(positions))).map(
        list
    )


@st.composite
def shafts(draw):
    """A shaft that may be, but for one place where something may stand that may not."""
    positions = draw(st.sampled_from([[-167.5, 167.5], [-150.0, 0.0, 160.0], [-145.0, -50.0, 50.0, 145.0]]))
    shaft = draw(
        table(
            {
                "mode": st.sampled_from(["given", "given", "size"]),
                "material": MATERIALS,
                "name": st.just("shaft"),
                "speed_ratio": st.sampled_from([-1, 1, 2, -2]),
                "bearings": st.one_of(st.just(rows_at(positions)), seats(positions)),
                "masses": elements(0, 5).filter(bool),
                "outer_radius_mm": number(31, 80),
                "core_radius_mm": number(0, 30),
                "half_length_mm": number(20, 180),
            },
            axis_mm=st.lists(number(-200, 200), min_size=2, max_size=2),
            extras=elements(-0.1, 0.1, 240),
            overdesign_percent=number(-50, 50),
            radial_clearance_mm=number(0, 2),
            gap_mm=number(0, 100),
            share_percent=number(1, 100),
            assembly=st.sampled_from(["threaded", "threaded", "split", "cartridge"]),
            bore_diameter_mm=number(0, 40),
            sector_material=MATERIALS,
            sections=sections(),
            sector_effectiveness=number(0.1, 1),
            fillet_radius_mm=number(0.1, 5),
            gear_z_mm=number(-250, 250),
            balance_grade=st.sampled_from(["G6.3", "G16", "G4000", "G0.4"]),
            holes=table({"diameter_mm": number(1, 30), "depth_mm": number(1, 30), "count": st.just(6)}),
            scatter=table(
                {
                    "mass_g": number(0, 500),
                    "radius_mm": number(0, 5),
                    "angle_deg": number(0, 20),
                    "z_mm": number(0, 20),
                    "shafts": st.just(100),
                },
                timing_deg=number(0, 5),
                seed=st.integers(0, 99),
            ),
            bolts=table(
                {
                    "thread": st.sampled_from(["M10", "M8x1"]),
                    "torque_Nm": number(1, 200),
                    "friction": number(0.02, 0.5),
                    "head_diameter_mm": number(16, 30),
                    "hole_diameter_mm": number(10.1, 15),
                    "count": st.integers(2, 9),
                },
                method=st.sampled_from(["vdi", "source"]),
                row_span_mm=number(1, 500),
            ),
            support=table(
                {"material": MATERIALS},
                wall_mm=number(0.1, 10),
                bolt_stress_MPa=number(0, 300),
                load_stress_MPa=number(0, 30),
            ),
            oil_drain=table(
                {
                    "hose_min_mm": number(10, 30),
                    "hose_max_mm": number(30, 40),
                    "thread": st.sampled_from(["M18x1.5", "M20"]),
                },
                slope_deg=number(1, 90),
                tilt_deg=number(0, 90),
                bore_mm=number(1, 30),
            ),
            cost=table(
                {
                    "pieces_per_year": st.integers(1, 10**9),
                    "alternatives": st.lists(
                        table({"material": MATERIALS, "tooling_EUR": number(0, 1e6), "piece_EUR": number(0, 1e3)}),
                        min_size=1,
                        max_size=3,
                        unique_by=lambda row: row["material"],
                    ),
                }
            ),
        )
    )
    if draw(st.integers(0, 4)) == 4:
        spoiled(draw, shaft)
    return shaft


def spoiled(draw, here):
    """One leaf of the tables is replaced by something odd."""
    while True:
        key = draw(st.sampled_from(sorted(here) if isinstance(here, dict) else range(len(here))))
        if isinstance(here[key], (dict, list)) and here[key] and draw(st.integers(0, 3)):
            here = here[key]
            continue
        here[key] = draw(ODD)
        return


BASE = parse((HEAD + ROWS).encode(), "d.toml").data


@settings(derandomize=True, max_examples=110, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(shafts(), st.booleans())
def test_any_table_is_solved_or_refused_in_words(shaft, paired):
    """Solved, no solution with its reason, or bad input with its keys: nothing else; and what is solved is a number."""
    document = Document({**BASE, "shafts": [shaft, *[{"name": "twin", "mirrors": "shaft"}] * paired]})
    try:
        made = design(document)
    except BadInput as bad:
        assert bad.errors and all(error.reason and error.key for error in bad.errors)
        return
    results = solve(made)
    outcome = results.outcomes["countershaft"]
    assert outcome.state in ("solved", "no_solution")
    assert (outcome.state == "no_solution") == bool(outcome.reason)
    assert "arithmetic breaks down" not in outcome.reason
    for value in results.values().values():
        assert math.isfinite(value.shown), value


def test_a_section_without_a_place_says_only_that():
    said = errors(HEAD + "sections = [{ outer_radius_mm = 20 }]\n" + ROWS)
    assert len(said) == 2 and all("is missing" in line for line in said) and not any("nan" in line for line in said)
