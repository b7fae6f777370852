"""The sheet of a shaft: what stands on it is the design's, inside the frame, and clear of what stands beside it."""

import copy
import math
from functools import cache
from itertools import combinations, pairwise

import pytest

from calc.design.toml_file import Document, design, read
from calc.draw.annotations import Leaf, corners
from calc.draw.defaults import general
from calc.draw.drawing import (
    CENTRE,
    DIMENSION,
    FRAME,
    LAYERS,
    TABLE,
    TEXT,
    VISIBLE,
    Area,
    Hatch,
    Measure,
    Polyline,
    Words,
    hatch_lines,
    strokes_of,
)
from calc.draw.lettering import room
from calc.draw.turned import turned
from calc.draw.workshop import shaft_sheet
from calc.draw.workshop_sheet import A3, BLOCK_TOP, COLUMNS, LEFT, LOW, tables
from calc.locale import language
from calc.sheet.record import replace
from calc.solve import solve
from calc.studies.drawings import sheets
from tests.conftest import DESIGNS, GAMMA
from tests.made_checks import made_check

MM = 1e-3
SECTIONS = [
    {"from_mm": -190.0, "to_mm": -150.0, "outer_radius_mm": 12.0},
    {
        "from_mm": -150.0,
        "to_mm": -20.0,
        "outer_radius_mm": 40.0,
        "core_radius_mm": 14.0,
        "half_angle_deg": 60.0,
        "angle_deg": 210.0,
    },
    {"from_mm": -20.0, "to_mm": 25.0, "outer_radius_mm": 14.0},
    {
        "from_mm": 25.0,
        "to_mm": 60.0,
        "outer_radius_mm": 40.0,
        "core_radius_mm": 14.0,
        "half_angle_deg": 180.0,
        "angle_deg": 120.0,
    },
    {
        "from_mm": 60.0,
        "to_mm": 150.0,
        "outer_radius_mm": 40.0,
        "core_radius_mm": 14.0,
        "half_angle_deg": 140.0,
        "angle_deg": 300.0,
    },
    {"from_mm": 150.0, "to_mm": 195.5, "outer_radius_mm": 12.0},
]


def variant(name, **bearings):
    data = copy.deepcopy(read(DESIGNS / f"{name}.toml").data)
    data["bearings"] |= bearings
    return data


def with_sections():
    data = copy.deepcopy(read(GAMMA).data)
    (shaft,) = data["shafts"]
    shaft["sections"] = SECTIONS
    shaft["bearings"] = [{key: row[key] for key in ("name", "position_mm")} for row in shaft["bearings"]]
    return {key: data[key] for key in ("schema", "name", "material", "engine", "imbalance", "shafts")}


def with_seats():
    """Shells by classes under a cap in front, a pressed bush behind."""
    data = copy.deepcopy(read(GAMMA).data)
    (shaft,) = data["shafts"]
    shaft["assembly"] = "caps"
    front, rear = shaft["bearings"]
    for row in (front, rear):
        for key in ("clearance_um", "clearance_factor"):
            row.pop(key, None)
    front["seat"] = "shells"
    rear |= {"seat": "bush", "wall_mm": [2.0, 2.008], "bore_mm": [85.05, 85.085], "journal_mm": [80.97, 81.0]}
    data["bearings"]["select"] = {
        "journal_classes_mm": [[59.485, 59.492], [59.493, 59.5]],
        "bore_classes_mm": [[63.5, 63.51], [63.511, 63.52]],
        "clearance_band_um": [50, 95],
    }
    return data


CASES = {
    "seats": with_seats,
    "gamma": lambda: variant("r753ie4_gamma", journal_fit="h6"),
    "sized": lambda: variant("r753ie4_sized"),
    "sections": with_sections,
}


@cache
def solved(case):
    data = CASES[case]()
    return data, solve(design(Document(data)))


@pytest.fixture(
    scope="module", params=[(case, lang) for case in CASES for lang in ("en", "it")], ids=lambda p: f"{p[0]}-{p[1]}"
)
def drawn(request):
    case, lang = request.param
    data, results = solved(case)
    return results, shaft_sheet(results, language(lang), data)


@pytest.fixture(scope="module")
def sheet(gamma, gamma_results):
    return shaft_sheet(gamma_results, data=gamma.data)


def letters(sheet):
    """All words, those of dimensions as well."""
    marks = [stroke for mark in sheet.marks for stroke in strokes_of(mark)]
    return [mark for mark in marks if isinstance(mark, Words)]


def cut(box, by):
    return box[0] + by, box[1] + by, box[2] - by, box[3] - by


def overlap(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


# --- where it stands
def test_nothing_leaves_the_frame_but_its_grid(drawn):
    paper = drawn[1].paper
    for mark in drawn[1].marks:
        if mark.layer not in (FRAME, TABLE):
            for x, y in corners(mark):
                assert LEFT <= x / MM <= paper.right and LOW <= y / MM <= paper.top, mark


def test_no_two_texts_overlap(drawn):
    boxes = [(cut(room(words), 0.05 * MM), words.text) for words in letters(drawn[1])]
    for (a, text), (b, other) in combinations(boxes, 2):
        assert not overlap(a, b), (text, other)


def test_no_line_of_a_dimension_goes_through_a_number(drawn):
    """Nor does a contour or an axis; a line under a number is its own."""
    numbers = [(cut(room(words), 0.25 * MM), words.text) for words in letters(drawn[1]) if words.layer == DIMENSION]
    marks = [stroke for mark in drawn[1].marks for stroke in strokes_of(mark)]
    for mark in marks:
        if isinstance(mark, Polyline) and mark.layer in (DIMENSION, VISIBLE, CENTRE):
            points = (*mark.points, mark.points[0]) if mark.closed else mark.points
            for (ax, ay), (bx, by) in pairwise(points):
                for share in range(101):
                    x, y = ax + (bx - ax) * share / 100, ay + (by - ay) * share / 100
                    for box, text in numbers:
                        assert not (box[0] < x < box[2] and box[1] < y < box[3]), (text, mark)


def test_the_title_block_stays_free_of_the_rest(drawn):
    paper = drawn[1].paper
    block = (paper.block_left, LOW, paper.right, BLOCK_TOP)
    for mark in drawn[1].marks:
        if isinstance(mark, Measure | Hatch | Area) or mark.layer in (CENTRE, DIMENSION):
            xs, ys = zip(*corners(mark))
            assert not overlap((min(xs) / MM, min(ys) / MM, max(xs) / MM, max(ys) / MM), block)


def test_a_hatch_stays_inside_its_outline(drawn):
    for hatch in (mark for mark in drawn[1].marks if isinstance(mark, Hatch)):
        (outline,) = hatch.outlines
        lines = hatch_lines(hatch)
        assert len(lines) > 5
        for (ax, ay), (bx, by) in lines:
            assert bx - ax == pytest.approx(by - ay, abs=1e-12), "45°"
            for share in (0.001, 0.3, 0.7, 0.999):
                assert winds(outline, (ax + share * (bx - ax), ay + share * (by - ay)))
        apart = sorted({round((y - x) / math.sqrt(2), 9) for (x, y), _ in lines})
        assert all(b - a >= hatch.spacing - 1e-8 for a, b in pairwise(apart))


def winds(outline, point):
    """Whether an outline goes round a point: the sum of the angles under which its sides are seen."""
    turned = 0.0
    for a, b in zip(outline, (*outline[1:], outline[0])):
        first, last = (math.atan2(y - point[1], x - point[0]) for x, y in (a, b))
        turned += math.remainder(last - first, 2 * math.pi)
    return abs(turned) > math.pi


def test_letters_are_large_enough_to_be_read(drawn):
    """2.5 mm high capitals: 9.7 points of the report's letters."""
    assert min(words.height for words in letters(drawn[1])) == pytest.approx(2.5 * MM)
    assert {mark.layer for mark in drawn[1].marks} <= set(LAYERS)


# --- what it says
def lengths(sheet):
    """What is measured along the shaft, in the order in which it is drawn."""
    return [mark for mark in measures(sheet, "length") if not mark.turned]


def measures(sheet, kind):
    """Of the shaft; those of its holes have their number before their sign."""
    found = [mark for mark in sheet.marks if isinstance(mark, Measure) and mark.kind == kind]
    return [mark for mark in found if "×" not in mark.inscription.words]


def labels(sheet):
    return [mark.inscription.words for mark in lengths(sheet)]


def test_dimensions_are_those_of_the_design(drawn):
    results, sheet = drawn
    found = [(abs(mark.points[1][0] - mark.points[0][0]) / MM / sheet.scale, mark) for mark in lengths(sheet)]
    for true, mark in found:
        number = mark.inscription.words.partition(" ±")[0].strip("()").replace(",", ".")
        assert float(number) == pytest.approx(true, abs=0.0501)
    shaft = results.design.countershaft
    span = (shaft.bearing_positions[-1] - shaft.bearing_positions[0]) / MM
    assert any(true == pytest.approx(span) for true, _ in found) and max(true for true, _ in found) > span


def test_every_functional_size_has_its_deviations(drawn):
    """Journals and gear with their lengths, and how far the bearings stand apart: the rest goes by the general
    tolerance."""
    results, sheet = drawn
    across = [mark for mark in measures(sheet, "length") if mark.turned]
    pieces = turned(results, results.shaft)
    functional = [piece for piece in pieces if piece.functional]
    with_limits = [m for m in across if m.inscription.deviations is not None]
    judged = results.design.bearings is not None
    assert len(functional) >= 2 and len(with_limits) == (len(functional) if judged else 0)
    along = {round(m.points[1][0] - m.points[0][0], 9): m.inscription for m in lengths(sheet)}
    asked = [piece.end - piece.start for piece in functional]
    asked += [b - a for a, b in pairwise(results.design.countershaft.bearing_positions)]
    for size in asked:
        lower, upper = along[round(size * sheet.scale, 9)].deviations
        assert upper == -lower == general(size)[1] / MM


def test_the_general_tolerance_of_lengths():
    """ISO 2768-1, class m, at the ends of its ranges; none above 4 m."""
    ends = {6.0: 0.1, 6.1: 0.2, 30.0: 0.2, 120.0: 0.3, 400.0: 0.5, 1000.0: 0.8, 2000.0: 1.2, 4000.0: 2.0}
    for size, deviation in ends.items():
        assert general(size * MM) == pytest.approx((-deviation * MM, deviation * MM))
    assert general(4001 * MM) is None


def test_the_final_design_is_rounded_as_a_drawing_is(sheet):
    assert sheet.scale == 1.0 and sheet.paper.name == "A2"
    assert labels(sheet) == [
        "15 ±0.2",
        "27.5 ±0.2",
        "0.4 ±0.1",
        "151.4",
        "2.1",
        "151.6",
        "(2.5)",
        "26.5 ±0.2",
        "335 ±0.5",
        "(377)",
    ]
    said = [words.text for words in letters(sheet)]
    at = said.index("⌀57.95")
    assert said[at + 1 : at + 3] == ["0", "−0.1"], "the upper deviation over the lower"
    for text in (
        "⌀59.5 ±0.015",
        "⌀81 ±0.0175",
        "R40.5",
        "R15",
        "182.2°",
        "181.7°",
        "A–A",
        "B–B",
        "Ra 0.6",
        "1:1",
        "20CrNi4",
        "9.05 kg",
    ):
        assert text in said, text
    # ends of cutting planes; planes of balancing
    assert said.count("A") >= 2 and said.count("B") >= 2 and "I" in said and "II" in said


def test_the_tables_give_teeth_balancing_and_masses(sheet, gamma_results):
    said = [words.text for words in letters(sheet) if words.layer == TEXT]
    values = gamma_results.values()
    assert (
        "21.551 (−0.02/−0.03)" in said and "68.698 ±0.055" in said and "idler, 39" in said and "21.916°, left" in said
    )
    assert (
        f"{values['countershaft.residual_unbalance_permitted'].shown:.0f} g·mm" in said
        and "G6.3" in said
        and "2600 rpm" in said
    )
    assert "2.691" in said and "210°" in said and "−77.67" in said


def test_a_fillet_that_two_shoulders_leave_no_room_for_is_said(sheet):
    assert "Two shoulders as drawn leave 0.2 for each fillet" in " ".join(words.text for words in letters(sheet))


def test_what_the_grade_permits_the_teeth_and_where_a_tooth_stands_are_in_the_table():
    """Grade 7, m_n 2, d 53.895, b 15 mm, by the formulas of ISO 1328-1:2013 and (runout) ISO 1328-2:1997."""
    said = [words.text for words in letters(shaft_sheet(solve(design(read(DESIGNS / "r753ie4_sized.toml")))))]
    beside = dict(pairwise(said))
    d, b, m = 53.895, 15.0, 2.0
    pitch, total = 0.001 * d + 0.4 * m + 5, 0.002 * d + 0.55 * math.sqrt(d) + 0.7 * m + 12
    profile = math.hypot(0.4 * m + 0.001 * d + 4, 0.55 * m + 5)
    root_d, root_b = math.sqrt(d), math.sqrt(b)
    helix = math.hypot(0.05 * root_d + 0.35 * root_b + 4, 0.07 * root_d + 0.45 * root_b + 4)
    runout = 0.24 * m + root_d + 5.6
    f_p, F_p, F_alpha, F_beta, F_r = (round(2 * x) for x in (pitch, total, profile, helix, runout))
    assert beside["Single pitch ±f_p, total pitch F_p"] == f"{f_p}, {F_p} µm"
    assert beside["Profile F_α, helix F_β"] == f"{F_alpha}, {F_beta} µm"
    assert beside["Runout F_r, ISO 1328-2:1997"] == f"{F_r} µm" and f"{F_r / 1e3:g}" in said, "and in the frame"
    assert beside["Heat treatment, ISO 6336-5"] == "case-hardened, MQ"
    # three standard deviations of the scatter, 10 g, 0.05 mm, 0.1° and 0.1 mm; timing 0.1°
    assert beside["A tooth at, cylinder 1 at TDC"] == "354.22° ±0.3°"
    at = said.index("±, 3 σ")
    assert said[at + 1 : at + 5] == ["0.03", "0.15", "0.3°", "0.3"]


def test_a_tooth_of_the_mirror_image_stands_where_its_own_way_leaves_it():
    """The wheel of `right`, behind two wheels, is no mirror image of that of `left`, behind one."""
    results = solve(design(read(DESIGNS / "r754ie4_balance_shafts.toml")), compared=False)
    said = [words.text for words in letters(shaft_sheet(results.views["left"]))]
    beside, laid = dict(pairwise(said)), results.train.layout.wheels
    for label, wheel in (("A tooth at", "left"), ("A tooth of right at", "right")):
        angle = math.degrees(laid[wheel].tooth_angle) % 360
        assert beside[f"{label}, cylinder 1 at TDC"] == f"{angle:.2f}".rstrip("0") + "°"
    assert (laid["left"].tooth_angle + laid["right"].tooth_angle) % math.radians(15) > math.radians(0.5)
    assert "The masses of right, the mirror image, stand at minus the angles in the table" in " ".join(said)


def test_journals_are_datums_and_what_turns_with_them_runs_true_about_both(sheet):
    """A quarter and half of IT7, 30 µm to 80 mm and 35 µm to 120 mm, in whole micrometres downwards."""
    said = [words.text for words in letters(sheet)]
    for datum, form, runout in (("A", "0.007", "0.015"), ("B", "0.008", "0.017")):
        assert datum in said and form in said and said[said.index(runout) + 1] == "A–B"
    assert said[said.index("0.027") + 1] == "A–B"


def test_a_fit_is_written_with_its_deviations(gamma_results):
    """h6 from 50 to 80 mm: 0/−0.019, from 80 to 120 mm: 0/−0.022 (ISO 286-2)."""
    sheet = shaft_sheet(solve(design(Document(CASES["gamma"]()))))
    said = [words.text for words in letters(sheet)]
    for size, deviation in (("⌀59.5 h6", "−0.019"), ("⌀81 h6", "−0.022")):
        at = said.index(size)
        assert said[at + 1 : at + 3] == ["0", deviation]
    assert not any("fits of the journals" in text for text in said)


def test_a_given_cylinder_in_a_bearing_has_its_fit_and_its_roughness_too():
    data = variant("r753ie4_gamma", journal_fit="f7")
    data["shafts"][0]["sections"] = SECTIONS
    said = [words.text for words in letters(shaft_sheet(solve(design(Document(data)))))]
    # ISO 286-2: f7 from 18 to 30 mm
    at = said.index("⌀24 f7")
    assert said.count("⌀24 f7") == 2 and said[at + 1 : at + 3] == ["−0.020", "−0.041"]
    assert said.count("Ra 0.6") == 2 and "⌀28" in said


def test_limits_of_journals_and_what_they_run_in_stand_on_the_sheet():
    data, results = solved("seats")
    words = [mark.text for mark in letters(shaft_sheet(results, data=data))]
    for size, deviation in (("⌀59.5", "−0.015"), ("⌀81", "−0.03")):  # the limits of all classes; those given
        assert words[words.index(size) + 2] == deviation
    beside = dict(pairwise(words))
    assert beside["Housing bore, front"] == "⌀63.500–63.520" and beside["Housing bore, rear"] == "⌀85.050–85.085"
    assert beside["Bush, wall, rear"] == "2.000–2.008"
    values = results.values()
    low, high = (math.ceil(values[f"bearings.rear.seat.interference_{end}"].shown) for end in ("min", "max"))
    assert beside["Interference, by the program, rear"] == f"{low} to {high} µm"
    least, most = (values[f"bearings.rear.corners.clearance_{end}"].shown / 1e3 for end in ("min", "max"))
    assert beside["Running bore, as pressed, rear"] == f"⌀{81.0 + least:.3f}–{80.97 + most:.3f}"
    at = words.index("Shells by bore and journal, colours by this program, front")
    assert words[at + 1 : at + 9] == [
        "⌀59.485–59.492",
        "⌀59.493–59.500",
        "⌀63.500–63.510",
        "black",
        "brown",
        "⌀63.511–63.520",
        "blue",
        "black",
    ]
    assert not any("fits of the journals" in word for word in words)


def test_a_finished_bush_and_a_seat_of_its_own_say_their_limits():
    data = with_seats()
    (shaft,), select = data["shafts"], data["bearings"].pop("select")
    assert select and shaft
    front, rear = shaft["bearings"]
    front |= {"seat": "direct", "bore_mm": [59.55, 59.58], "journal_mm": [59.48, 59.5]}
    rear |= {"bore": "finished", "finished_mm": [81.05, 81.08], "interference_um": [60, 90]}
    words = [m.text for m in letters(shaft_sheet(solve(design(Document(data))), data=data))]
    beside = dict(pairwise(words))
    assert beside["Bore of the seat, front"] == "⌀59.550–59.580" and beside["Clearance, front"] == "50 to 100 µm"
    assert beside["Running bore, finished, rear"] == "⌀81.050–81.080"
    assert beside["Interference, rear"] == "60 to 90 µm" and words[words.index("⌀59.5") + 2] == "−0.02"


def test_tables_that_have_no_room_above_the_title_block_stand_beside_the_others():
    rows = [("what", "1")] * 20
    one, two = (tables([("head", rows, COLUMNS)] * n) for n in (1, 3))
    assert one.extent[0] == 0.0 and two.extent[0] < -sum(COLUMNS)
    assert all(A3.top + leaf.extent[1] >= BLOCK_TOP for leaf in (one, two))


def test_no_table_stands_on_the_centring_mark():
    data, results = solved("seats")
    sheet = shaft_sheet(results, data=data)
    x, y = sheet.paper.right * MM - 0.005, sheet.paper.high / 2 * MM
    for mark in sheet.around:
        if isinstance(mark, Polyline) and mark.layer == TABLE:
            (left, low), (right, top) = map(min, zip(*mark.points)), map(max, zip(*mark.points))
            of_the_grid = right > (sheet.paper.right + 1) * MM
            assert of_the_grid or not (left < x < right and low < y < top), mark


def test_the_clearance_of_the_journals_is_noted(sheet, gamma_results):
    front, rear = (gamma_results.values()[f"bearings.{place}.clearance"].shown for place in ("front", "rear"))
    said = " ".join(words.text for words in letters(sheet))
    assert f"in their bearings at 20 °C: {front:.0f} µm front, {rear:.0f} µm rear." in " ".join(said.split())


def test_what_the_design_does_not_give_is_said_and_not_put_in(sheet):
    said = " ".join(words.text for words in letters(sheet))
    for text in (
        "Not given by the design: heat treatment of the journals",
        "places of the calibration",
        "Draughtsman's choice elsewhere: general tolerances ISO 2768-mK; Ra 3.2; edges broken 0.3×45°.",
    ):
        assert text in said
    assert (
        "Chosen by the program, not by the design: the grade of balancing, the accuracy grade of the teeth, IT7 of the journals."
        in said
    )
    assert "⌀59.5 ±0.015" in said and "⌀81 ±0.0175" in said  # ISO 286-1: IT7 is 30 µm to 80 mm, 35 µm to 120 mm


def test_the_title_block_says_what_the_document_says():
    document = read(DESIGNS / "r753ie4_sized.toml")
    sheet = shaft_sheet(solve(design(document)), data=document.data)
    said = [words.text for words in letters(sheet)]
    for text in (
        "Counter-shaft",
        "Title, part of R753IE4 counter-shaft, sized",
        "R753IE4-S",
        "Counter-shaft of the R753IE4",
        "The Contralbero founders",
        "G16",
    ):
        assert text in said
    assert "grade of balancing" not in " ".join(said)


def test_the_calibration_holes_stand_in_the_masses_that_they_calibrate(sheet, gamma_results):
    """As deep as they may be, across the middle of each mass."""
    holes = gamma_results.design.countershaft.holes
    found = [mark for mark in sheet.marks if isinstance(mark, Measure) and "×" in mark.inscription.words]
    assert [mark.inscription.words for mark in found] == ["2× ⌀14", "2× ⌀14"]
    for mark in found:
        assert math.dist(*mark.points[:2]) / sheet.scale == pytest.approx(holes.diameter)
    outlines = [mark for mark in sheet.marks if isinstance(mark, Polyline) and mark.layer == "HIDDEN"]
    assert len(outlines) == 2
    for (ax, ay), (bx, by), *_ in (mark.points for mark in outlines):
        top = math.sqrt(40.5**2 - 7**2)  # where the wall of the hole comes out of the round of the mass
        deep = math.dist((ax, ay), (bx, by)) / MM / sheet.scale
        assert deep == pytest.approx(holes.depth / MM - (40.5 - top))


def test_sections_are_lettered_once_for_each_kind_and_a_whole_ring_has_no_angle():
    sheet = shaft_sheet(solve(design(Document(with_sections()))))
    said = [words.text for words in letters(sheet)]
    assert [text for text in said if "–" in text and len(text) == 3] == ["A–A", "B–B", "C–C"]
    assert "120°" in said and "80°" in said and "360°" not in said
    assert "45.5 ±0.3" in said and "385.5" not in said and "(385.5)" in said


def test_a_shaft_without_outline_has_no_sheet():
    data = copy.deepcopy(read(DESIGNS / "twin_force_shaft.toml").data)
    assert shaft_sheet(solve(design(Document(data)))) is None


def test_a_size_is_never_cut_in_a_table():
    """The column of sizes takes of the words what it needs, and no more."""
    size = "15.463 (−0.035/−0.045)"
    for cell, words in ((size, ["Span over 3 teeth", size]), ("15", ["Span over 3 teeth", "15"])):
        leaf = Leaf()
        leaf.table([("Span over 3 teeth", cell)], (68.0, 44.0))
        assert [mark.text for mark in leaf.marks if isinstance(mark, Words)] == words


def released(data, verdict, **who):
    results = solve(design(Document(data | {"document": who})))
    checks = (made_check(5.0 if verdict == "pass" else 11.0, "<=", 10.0, unit="mm", id="engine.fail.x"),)
    outcomes = {key: replace(outcome, checks=()) for key, outcome in results.outcomes.items()}
    outcomes["engine"] = replace(outcomes["engine"], checks=checks)
    (sheet,) = sheets(replace(results, outcomes=outcomes), sha256="0123456789abcdef" * 4)
    return [words.text for words in letters(sheet)]


def test_a_sheet_says_for_what_it_is_good():
    """Not for manufacture unless the design passes and somebody has approved it; of which design it is, and how that
    came out."""
    data, approved = CASES["gamma"](), {"approved": {"name": "A. Rossi", "date": "2026-03-14"}}
    said = released(data, "fail", **approved)
    assert "PRELIMINARY, NOT FOR MANUFACTURE" in said and "design 0123456789abcdef" in said
    assert "Calculation: FAIL: 1 failed" in said
    said = released(data, "pass")
    assert "PRELIMINARY, NOT FOR MANUFACTURE" in said and "Calculation: PASS; not approved" in said
    said = released(data, "pass", **approved)
    assert "Released: A. Rossi 2026-03-14" in said and not any("PRELIMINARY" in text for text in said)
