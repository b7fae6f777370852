"""Each check of the balancing sheet just inside and just outside, and what the table refuses."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.countershaft.balancing.checks import checks, least_room, segments_apart
from calc.countershaft.balancing.inputs import Balancing, from_to
from calc.countershaft.balancing.solve import Made, drills
from calc.countershaft.balancing.told import notes
from calc.countershaft.inputs import Holes
from calc.countershaft.outline import Outline, Piece
from calc.design.toml_file import design, load_design, parse
from calc.sheet.errors import BadInput
from calc.solve import solve
from tests.calc.countershaft.balancing.sheets import hole, reading, shaft, sheet_of, tolerance
from tests.conftest import DESIGNS

R754 = (DESIGNS / "r754ie4_balance_shafts.toml").read_text(encoding="utf-8")
PER = tolerance(shaft())
LEAST = min(PER.residual_unbalance_permitted_front, PER.residual_unbalance_permitted_rear)


def judged(**table):
    return {check.id.rpartition(".")[2]: check for check in checks(sheet_of(shaft(), Balancing(**table), PER))}


def test_the_force_on_a_pedestal():
    """63.4 N at 500 rpm, by the target in the rear plane."""
    assert judged(machine_force=63.5)["machine"].verdict == "pass"
    over = judged(machine_force=63.3)["machine"]
    ((key, slower),) = over.remedies[0].changes
    assert over.verdict == "warn" and key.endswith("balancing.speed_rpm")
    assert slower == math.floor(500 * math.sqrt(63.3 / over.value))
    assert judged(machine_force=63.3, speed=slower / 60)["machine"].verdict == "pass"


@pytest.mark.parametrize("key, rule, share", [("ring_tolerance", "ring", 0.2), ("measurement_error", "error", 0.3)])
def test_errors_of_ring_and_machine(key, rule, share):
    assert judged(**{key: (0.99 * share * LEAST,)})[rule].verdict == "pass"
    assert judged(**{key: (0.0, 1.01 * share * LEAST)})[rule].verdict == "warn"
    assert rule not in judged()


@pytest.mark.parametrize(
    "share, error, verdict",
    [
        (0.89, 0.1, "pass"),
        (0.91, 0.1, "not_verified"),
        (1.09, 0.1, "not_verified"),
        (1.11, 0.1, "fail"),
        (0.99, 0.0, "pass"),
        (1.01, 0.0, "fail"),
        (0.99, 0.049, "pass"),
    ],
)
def test_a_reading(share, error, verdict):
    U = PER.residual_unbalance_permitted_rear
    read = reading("7", (0.0, 0.0), (share * U * 1e6, 77.0))
    found = judged(readings=(read,), measurement_error=(0.0, error * U))["7"]
    assert found.verdict == verdict and found.id == "countershaft.balancing.reading.7"
    assert not found.missing and not found.taken  # the machine's error is given, whatever it can tell
    assert (found.at_best is not None) is (verdict == "not_verified")
    if verdict == "not_verified":
        assert str(found.advice).startswith("This machine can't tell: what is left is within its error, ± ")
        assert "Not given" not in str(found.lack_text())


# --- room around the holes


def outlined(half=70.0, start=-50.0, end=50.0):
    piece = Piece(start * 1e-3, end * 1e-3, 0.0405, 0.015, math.radians(half), 0.0, "sector")
    empty = np.zeros(1)
    return Outline((piece,), False, empty, empty, empty.astype(complex), empty, empty.astype(complex))


def room(*holes, **outline):
    table = Balancing(holes=holes)
    found = sheet_of(shaft([(1.0, 20.0, 0.0, 0.0)]), table, PER, outline=outlined(**outline))
    least, words, _ = least_room([each.drill for each in found.hole.values()])
    return least * 1e3, str(words)


def test_the_cone_ends_above_the_core():
    """40.5 − 15 = 25.5 mm, of which the cone takes 4.206."""
    assert room(hole("a", 0.0, 0.0)) == (pytest.approx(1.294, abs=1e-3), "Metal under hole a, below its cone")
    assert room(hole("a", 0.0, 0.0, depth=21.3))[0] == pytest.approx(-0.006, abs=1e-3)
    assert room(hole("a", 0.0, 0.0, depth=21.3, point=math.pi))[0] == pytest.approx(4.2)


def test_a_hole_stays_in_its_sector():
    assert room(hole("a", 43.1, 0.0, depth=8.0)) == (pytest.approx(-0.1), "Metal beside hole a, along its sector")
    across = room(hole("a", 0.0, 55.0, depth=8.0))
    assert across[0] == pytest.approx(32.5 * math.sin(math.radians(15.0)) - 7.0)
    assert across[1] == "Metal beside hole a, across its sector"


def test_a_hole_in_the_air_is_not_drilled():
    """It fails whatever else has room, takes nothing, and no reading asks for it."""
    holes = hole("a", 0.0, 0.0, depth=8.0), hole("b", 0.0, 75.0, depth=8.0), hole("c", 60.0, 0.0, depth=8.0)
    table = Balancing(holes=holes, readings=(reading("7", (300.0, 75.0), (300.0, 75.0)),))
    found = sheet_of(shaft([(1.0, 20.0, 0.0, 0.0)]), table, PER, outline=outlined())
    assert [*found.hole] == ["a"] and [drill.name for drill in found.outside] == ["b", "c"]
    assert found.reading["7"].hole.keys() == {"a"}
    room = {check.id: check for check in checks(found)}["countershaft.balancing.holes"]
    assert room.verdict == "fail" and str(room.name) == (
        "Hole b is outside of its sector, which goes from -70° to 70°; "
        "Hole c is outside of the shaft, which goes from -50 to 50 mm"
    ).replace("-", "−")
    assert room.value == pytest.approx(-40.5 * math.sin(math.radians(5.0)) - 7.0)
    said = [str(note) for note in notes(shaft(), found)]
    assert any(note.startswith("Hole b is outside of its sector") and "is not drilled" in note for note in said)


@pytest.mark.parametrize(
    "middle, words", [(0.0, "−70° to 70°"), (210.0, "140° to 280°"), (-20.0, "−90° to 50°"), (700.0, "−90° to 50°")]
)
def test_from_where_to_where_a_sector_goes(middle, words):
    assert str(from_to(math.radians(middle), math.radians(70.0))) == f"from {words}"


def test_holes_do_not_cross():
    beside = room(hole("a", 0.0, 0.0, depth=8.0), hole("b", 13.9, 0.0, depth=8.0))
    assert beside == (pytest.approx(-0.1), "Metal between holes a and b")
    fan = room(hole("a", 0.0, 20.0, depth=8.0), hole("b", 0.0, -20.0, depth=8.0))
    assert fan[0] == pytest.approx(2 * 32.5 * math.sin(math.radians(20.0)) - 14.0)  # at their bottoms


def test_segments_by_a_search():
    luck = np.random.default_rng(3)
    t = np.linspace(0, 1, 201)[:, None]
    for p, q, r, s in luck.normal(size=(20, 4, 3)):
        one, other = p + t * (q - p), r + t * (s - r)
        least = np.min(np.linalg.norm(one[:, None] - other[None], axis=-1))
        assert (
            segments_apart(p, q, r, s) == pytest.approx(least, abs=0.02) and segments_apart(p, q, r, s) <= least + 1e-12
        )


def test_the_calibration_holes_stand_in_a_row_along_each_mass():
    inputs = shaft([(1.0, 20.0, 0.0, 0.0)], holes=Holes(diameter=0.014, depth=0.02, count=3))
    found = sheet_of(inputs, Balancing(), PER, outline=outlined(start=-60.0, end=60.0))
    assert [(d.name, pytest.approx(d.z)) for d in (each.drill for each in found.hole.values())] == [
        ("front-1", -0.04),
        ("front-2", 0.0),
        ("front-3", 0.04),
    ]


def test_masses_whose_sectors_touch_have_a_row_each():
    """Of the shipped twin: two sectors in one direction that meet at mid-shaft."""
    solved = solve(load_design(DESIGNS / "twin_drive.toml")).shaft
    inputs = shaft(holes=Holes(diameter=0.008, depth=0.012, count=4))
    made = Made(solved.masses, solved.outline, None, 7860.0, 7860.0, PER)
    z = [drill.z * 1e3 for drill in drills(inputs, Balancing(), made)]
    assert z == pytest.approx([-41.25, -13.75, 13.75, 41.25])


@pytest.mark.parametrize("z", [-75.0, 80.0])
def test_a_hole_beyond_the_shaft_is_in_the_air(z):
    drilled = hole("a", z, 0.0, 8.0, 5.0, radius=0.04)
    found = sheet_of(shaft(), Balancing(holes=(drilled,)), PER, outline=outlined(start=-60.0, end=60.0))
    assert not found.hole
    least, words, _ = least_room(found.outside)
    assert least == pytest.approx(-0.004) and words == "Hole a is outside of the shaft, which goes from −60 to 60 mm"


@pytest.mark.parametrize("z", [-65.0, 68.0])
def test_a_hole_in_a_journal_breaks_out_of_the_nearest_sector(z):
    sector = outlined(start=-60.0, end=60.0)
    ends = [Piece(*at, 0.03, 0.0, None, 0.0, "journal") for at in ((-0.09, -0.06), (0.06, 0.09))]
    whole = replace(sector, pieces=(ends[0], *sector.pieces, ends[1]))
    drilled = hole("a", z, 0.0, 8.0, 5.0, radius=0.03)
    (each,) = sheet_of(shaft(), Balancing(holes=(drilled,)), PER, outline=whole).hole.values()
    assert least_room([each.drill])[0] == pytest.approx(0.06 - abs(z) * 1e-3 - 0.004)


# --- bad input


def errors(table):
    text = (
        R754.partition("[shafts.balancing]")[0]
        + f"[shafts.balancing]\n{table}\n# assumed: the outline;"
        + (R754.partition("# assumed: the outline;")[2])
    )
    with pytest.raises(BadInput) as bad:
        design(parse(text.encode(), "bad.toml"))
    return {error.key.partition("balancing.")[2]: str(error.reason) for error in bad.value.errors}


@pytest.mark.parametrize("angle, wrong", [(94.0, True), (96.0, False), (265.0, False), (-94.0, True), (540.0, False)])
def test_an_angle_is_in_a_sector_at_its_place(angle, wrong):
    """Those of the shipped design go from 94.9° to 265.1°."""
    row = f'[[shafts.balancing.holes]]\nname = "a"\nz_mm = 60\nangle_deg = {angle}\ndiameter_mm = 8\n'
    found = errors(row + "depth_max_mm = 8\n" + "[[shafts.balancing.holes]]\n")  # the second row lacks all
    assert ("holes.0.angle_deg" in found) is wrong
    if wrong:
        assert found["holes.0.angle_deg"] == (
            "must lie in the sector there, which goes from 94.9° to 265.1°: outside of it is air"
        )


def test_all_that_is_wrong_is_said_at_once():
    rows = 'name = "a"\nangle_deg = 180\ndiameter_mm = 8\ndepth_max_mm = 8\n'
    holes = "".join(f"[[shafts.balancing.holes]]\nz_mm = {z}\n{rows}" for z in (0.0, 50.0))
    deep = "[[shafts.balancing.holes]]\nz_mm = 60\n" + rows.replace("max_mm = 8", "max_mm = 24").replace('"a"', '"b"')
    read = '[[shafts.balancing.readings]]\nserial = "1"\nfront_gmm = 3\nfront_deg = 0\n'
    both = read + "rear_gmm = 2\nrear_deg = 0\n"
    table = 'zero = "mass rar"\nring_positions_mm = [5, 5]\nmeasurement_error_gmm = -1\n' + holes + deep + read + both
    found = errors(table)
    assert found.keys() == {
        "zero",
        "ring_positions_mm",
        "measurement_error_gmm",
        "holes.0.z_mm",
        "holes.1.name",
        "holes.2.depth_max_mm",
        "readings.0.rear_gmm",
        "readings.0.rear_deg",
        "readings.1.serial",
    }
    assert '"mass front", "mass rear"' in found["zero"] and "−100 … −16" in found["holes.0.z_mm"].replace("-", "−")
    assert errors("ring_positions_mm = [5]").keys() == {"ring_positions_mm"}
    assert "from -720 to 720 degrees" in errors("zero = 1e308")["zero"]
