"""The drawing of a wheel and of a train: the DXF file read back, against the exact curves."""

import dataclasses
import math
import time
from io import StringIO
from itertools import pairwise

import ezdxf
import numpy as np
import pytest

from calc.draw.drawing import Arc, Polyline, Words
from calc.gears.layout.solve import ShaftInTrain
from calc.gears.profile.cut import Cut
from calc.gears.profile.drawing import LAYERS, data_table, train_drawing, wheel_drawing
from calc.gears.profile.outline import shifts
from calc.gears.solve import geometry, with_layout
from reports.dxf import dxf
from tests.calc.gears.trains import SPEED, mesh, r753, solved, train, wheel

MM = 1e-3


@pytest.fixture(scope="module")
def whole():
    return solved(r753())


def written(drawing):
    document = ezdxf.read(StringIO(dxf(drawing, LAYERS)))
    assert not document.audit().errors and document.units == 4
    return document.modelspace()


def polyline(space, layer):
    (found,) = space.query(f'LWPOLYLINE[layer=="{layer}"]')
    assert found.closed
    return np.array([complex(x, y) for x, y, *_ in found.get_points()]) * MM


@pytest.fixture(scope="module")
def idler(whole):
    return written(wheel_drawing(whole, "idler", "a train", r753()))


def test_circles_have_the_diameters_of_the_wheel(whole, idler):
    w = whole.wheels["idler"]
    found = {c.dxf.layer: c.dxf.radius * 2 * MM for c in idler.query("CIRCLE") if c.dxf.layer != "WORKING"}
    assert found == pytest.approx(
        {
            "TIP": w.tip_diameter,
            "REFERENCE": w.reference_diameter,
            "BASE": w.base_diameter,
            "ROOT": w.root_diameter,
            "FORM": w.form_diameter,
        },
        rel=1e-12,
    )
    working = sorted(c.dxf.radius * 2 * MM for c in idler.query('CIRCLE[layer=="WORKING"]'))
    assert working == pytest.approx(
        sorted(
            [whole.meshes["central_idler"].working_diameter_driven, whole.meshes["idler_shaft"].working_diameter_driver]
        ),
        rel=1e-12,
    )


def test_the_axes_cross_in_the_middle_and_stand_out_beyond_the_tips(whole):
    for shapes, centre in (
        (wheel_drawing(whole, "idler"), 0j),
        (train_drawing(whole), complex(whole.meshes["crank_central"].centre_distance)),
    ):
        lines = [p.points for p in shapes if p.layer == "AXIS"]
        across = [(complex(*a), complex(*b)) for a, b in lines if abs(complex(*a) + complex(*b) - 2 * centre) < 1e-12]
        radius = whole.wheels["central" if centre else "idler"].tip_diameter / 2
        assert [np.angle(b - a) for a, b in across] == pytest.approx([0.0, math.pi / 2])
        assert all(radius * 1.01 < abs(b - a) / 2 < radius * 1.1 for a, b in across)


@pytest.mark.parametrize("layer, end", [("PROFILE", ""), ("PROFILE_MAX", "max"), ("PROFILE_MIN", "min")])
def test_the_outline_repeats_with_every_tooth_and_goes_round_once(whole, idler, layer, end):
    points, z = polyline(idler, layer), 39
    assert points.size % z == 0
    one = points.size // z
    assert np.abs(np.roll(points, -one) - points * np.exp(2j * np.pi / z)).max() < 1e-12
    turns = np.angle(np.roll(points, -1) / points)
    assert np.all(turns >= -1e-12) and turns.sum() == pytest.approx(2 * np.pi)
    w = whole.wheels["idler"]
    root = w.root_diameter if not end else getattr(w, f"root_diameter_{end}")
    assert np.abs(points).min() * 2 == pytest.approx(root, rel=1e-9)
    assert np.abs(points).max() * 2 == pytest.approx(w.tip_diameter, rel=1e-9)


@pytest.mark.parametrize("error", [1e-7, 1e-6, 1e-5])
def test_no_exact_point_stands_further_off_the_file_than_the_chord_error(whole, error):
    space, w = written(wheel_drawing(whole, "shaft", chord_error=error)), whole.wheels["shaft"]
    for layer, end in (("PROFILE", ""), ("PROFILE_MIN", "min")):
        line = polyline(space, layer) * -1j  # the first tooth along the real axis
        near = line[np.abs(np.angle(line)) < 2 * np.pi / w.teeth]
        near = near[np.argsort(np.angle(near), kind="stable")]
        cut = Cut(whole.system, w.teeth, shifts(whole.system, w)[end])
        radius, angle = cut.fillet(np.linspace(-np.pi / 2, cut.end_of_fillet, 500))
        r = np.linspace(radius[-1], w.tip_diameter / 2, 500)
        exact = np.concatenate([radius * np.exp(1j * angle), r * np.exp(1j * cut.involute(r))])
        gap = exact[:, None] - near[:-1]
        way = np.diff(near)
        along = np.clip((gap * way.conj()).real / np.maximum(np.abs(way) ** 2, 1e-300), 0, 1)
        assert np.abs(gap - along * way).min(axis=1).max() <= error * 1.001


def test_the_table_of_data_stands_on_the_drawing(whole, idler):
    words = [text.dxf.text for text in idler.query('TEXT[layer=="TEXT"]')]
    assert "a train: idler" in words
    w = whole.wheels["idler"]
    rows = dict(data_table(whole, "idler", r753()))
    assert {*rows, *rows.values()} <= set(words)
    assert rows["Teeth z"] == "39" and rows["Profile shift coefficient x"] == "−0.15598"
    spans = {key: stated.number * 1e3 for key, stated in w.span.items()}
    assert rows["Span over 5 teeth W"] == f"{spans['span_5_min']:.4f} to {spans['span_5_max']:.4f}"
    assert rows["Size over balls M, D_M 3.5"] == f"{w.over_balls_min * 1e3:.4f} to {w.over_balls_max * 1e3:.4f}"


@pytest.mark.parametrize("allowance", [(-2e-6, -20e-6), None])
def test_tolerances_of_tip_and_root_stand_once_in_the_table(whole, allowance):
    """The root's own tolerance stands beside what the allowance changes, E_W/sin α_n in diameter: the lowest of both,
    the highest of both."""
    gears = r753()
    central = dataclasses.replace(
        gears.wheels[1],
        span_allowance=allowance,
        tip_diameter_tolerance=(0.0, -1e-4),
        root_diameter_tolerance=(0.0, -3e-4),
    )
    gears = dataclasses.replace(gears, wheels=(gears.wheels[0], central, *gears.wheels[2:]))
    w, rows = whole.wheels["central"], dict(data_table(solved(gears), "central", gears))
    low, high = (float(x) for x in rows["Tip diameter d_a"].split(" to "))
    assert (low, high) == pytest.approx((w.tip_diameter * 1e3 - 0.1, w.tip_diameter * 1e3), abs=5.1e-5)
    low, high = (float(x) for x in rows["Root diameter d_f"].split(" to "))
    upper, lower = (E_W * 1e3 / math.sin(whole.system.alpha_n) for E_W in allowance or (0.0, 0.0))
    assert (low, high) == pytest.approx(
        (w.root_diameter * 1e3 + lower - 0.3, w.root_diameter * 1e3 + upper), abs=5.1e-5
    )


@pytest.mark.parametrize(
    "given, said", [(None, ("right", "left", "right", "left")), ("right", ("left", "right", "left", "right"))]
)
def test_the_hand_of_the_helix_stands_in_the_table(whole, given, said):
    """Given of the central idler, or of no wheel: the hands alternate, and without any the first driver is
    right-handed."""
    gears = r753()
    gears = dataclasses.replace(
        gears, wheels=tuple(dataclasses.replace(w, hand=given if w.name == "central" else None) for w in gears.wheels)
    )
    assert [dict(data_table(whole, name, gears))["Helix angle"] for name in whole.wheels] == [
        f"21.916°, {hand}" for hand in said
    ]


def test_a_spur_wheel_has_no_hand():
    gears = train([wheel("a", 20, 0.1), wheel("b", 30, 0.0)], [mesh("a", "b")], beta=0.0)
    assert dict(data_table(solved(gears), "a", gears))["Helix angle"] == "0°"


def test_circles_that_nothing_touches_are_dash_dotted(idler):
    lines = {layer: idler.doc.layers.get(layer).dxf.linetype.upper() for layer in LAYERS}
    assert {layer for layer, line in lines.items() if line == "CENTER"} == {"AXIS", "REFERENCE", "WORKING"}
    assert all(entity.dxf.linetype.upper() == "BYLAYER" for entity in idler)


def test_a_wheel_without_allowance_has_one_outline():
    t = solved(train([wheel("a", 20, 0.1), wheel("b", 30, 0.0)], [mesh("a", "b")], beta=0.0))
    assert [p.layer for p in wheel_drawing(t, "a") if isinstance(p, Polyline) and p.closed] == ["PROFILE"]


def test_the_same_wheel_gives_the_same_bytes(whole):
    assert dxf(wheel_drawing(whole, "idler", "x", r753()), LAYERS) == dxf(
        wheel_drawing(whole, "idler", "x", r753()), LAYERS
    )


def test_a_wheel_is_drawn_and_written_in_half_a_second(whole):
    begun = time.process_time()
    dxf(wheel_drawing(whole, "idler", "x", r753()), LAYERS)
    assert time.process_time() - begun < 0.5


# --- the train
def placed(t, angle=0.3):
    """Every wheel at its distance from the one before, in a bent line: [up, side]."""
    at, found = 0j, {"crank": 0j}
    for n, m in enumerate(t.meshes.values()):
        at += m.centre_distance * np.exp(1j * (angle + 0.9 * n))
        found[m.driven] = at
    return {name: (z.real, z.imag) for name, z in found.items()}


@pytest.mark.parametrize("bent", [True, False])
def test_in_the_train_every_tooth_stands_in_a_space(whole, bent):
    """At every pitch point: on the line of centres, the driver's nearest tooth and the driven wheel's nearest space
    agree."""
    places = placed(whole) if bent else None
    drawing = train_drawing(whole, "x", places, tooth_angle=0.123)
    outlines = [
        np.array([complex(*p) for p in line.points]) for line in drawing if isinstance(line, Polyline) and line.closed
    ]
    lines = dict(zip(whole.wheels, outlines))
    centres = {name: line.mean() for name, line in lines.items()}
    if places is not None:
        assert centres == pytest.approx({name: complex(side, up) for name, (up, side) in places.items()}, abs=1e-9)
    for m in whole.meshes.values():
        gamma = np.angle(centres[m.driven] - centres[m.driver])
        phase = []
        for name, towards in ((m.driver, gamma), (m.driven, gamma + np.pi)):
            seen = (lines[name] - centres[name]) * np.exp(-1j * towards)
            z = whole.wheels[name].teeth
            # of the teeth, from the line of centres
            phase.append(np.angle((np.abs(seen) * np.exp(1j * z * np.angle(seen))).sum()))
        assert abs(np.angle(np.exp(1j * (phase[0] + phase[1] - np.pi)))) < 1e-6


def test_the_first_tooth_points_where_it_is_said(whole):
    """From up in the sense of crank rotation: clockwise on the sheet."""
    drawing = train_drawing(whole, positions=placed(whole), tooth_angle=math.radians(90))
    line = next(p for p in drawing if isinstance(p, Polyline) and p.closed)
    at = np.array([complex(*p) for p in line.points])
    one = at.size // 25
    middle = at[one // 2]
    assert abs(middle) * 2 == pytest.approx(whole.wheels["crank"].tip_diameter) and np.angle(middle) == pytest.approx(
        0.0, abs=1e-9
    )


def test_a_train_that_is_not_placed_as_a_whole_stands_in_a_row(whole):
    """Nothing given, or not every wheel; the first tooth of the first driver then points up, and the words under the
    drawing say which."""
    places = placed(whole)
    some = {name: places[name] for name in list(places)[1:]}
    all_alike = {
        tuple(map(str, map(vars, shapes)))
        for shapes in (train_drawing(whole), train_drawing(whole, "", some), train_drawing(whole, "", {}))
    }
    assert len(all_alike) == 1
    row, bent = train_drawing(whole), train_drawing(whole, "", places)
    said = [[p.text for p in shapes if isinstance(p, Words)] for shapes in (row, bent)]
    assert (
        "In a row" in said[0][-1]
        and "Drawn up" in said[1][-1]
        and len(said[0]) == len(said[1]) == len(whole.wheels) + 2
    )
    at = np.array([complex(*p) for p in next(p for p in row if isinstance(p, Polyline) and p.closed).points])
    assert np.angle(at[at.size // 25 // 2]) == pytest.approx(math.pi / 2, abs=1e-9)


@pytest.mark.parametrize("bent", [True, False])
def test_the_words_of_a_train_stand_at_their_wheels_and_below_all_of_them(whole, bent):
    """Names beside the axes; the title and what is said below the lowest tip circle, one under the other, from the
    leftmost on."""
    drawing = train_drawing(whole, "A train", placed(whole) if bent else None)
    tips = {p.centre: p.radius for p in drawing if isinstance(p, Arc) and p.layer == "TIP"}
    words = [p for p in drawing if isinstance(p, Words)]
    names, below = words[:-3], words[-3:]
    assert [p.text for p in names] == [f"{name}, z {w.teeth}" for name, w in whole.wheels.items()] and below[
        0
    ].text == "A train"
    for word, (centre, radius) in zip(names, tips.items()):
        assert 0 < word.at[0] - centre[0] < radius / 4 and 0 < word.at[1] - centre[1] < radius / 4
    low, left = min(y - r for (_, y), r in tips.items()), min(x - r for (x, _), r in tips.items())
    assert [p.at[0] for p in below] == pytest.approx([left] * 3)
    heights = [p.at[1] for p in below]
    assert low - 0.02 < heights[0] < low - below[0].height and all(
        b < a - below[0].height for a, b in pairwise(heights)
    )


def test_a_driver_of_two_wheels_has_them_on_different_sides():
    t = solved(
        train(
            [wheel("a", 20, 0.1), wheel("b", 30, 0.0), wheel("c", 30, 0.0)], [mesh("a", "b"), mesh("a", "c")], beta=0.0
        )
    )
    lines = [p for p in train_drawing(t) if isinstance(p, Polyline) and p.closed]
    b, c = (np.mean([complex(*p) for p in line.points]) for line in lines[1:])
    assert abs(b) == pytest.approx(t.meshes["a_b"].centre_distance) and abs(b - c) > t.wheels["b"].tip_diameter * 0.7


@pytest.mark.parametrize("turned", [0.0, 0.05])
def test_a_placed_train_is_drawn_with_the_teeth_of_its_layout(turned):
    """Tooth 1 of every wheel begins its outline: the last wheel's the one nearest the eccentric, at any angle of the
    first driver's."""
    gears = dataclasses.replace(r753(), tooth_angle=turned)
    t = with_layout(geometry(gears, SPEED), gears, {"shaft": ShaftInTrain(0.130 + 0.103j, 2.0)}).result
    places = {name: (w.position.real, w.position.imag) for name, w in t.layout.wheels.items()}
    lines = [p for p in train_drawing(t, "x", places, turned) if isinstance(p, Polyline) and p.closed]
    for line, w, laid in zip(lines, t.wheels.values(), t.layout.wheels.values()):
        at = np.array([complex(y, x) for x, y in line.points]) - laid.position
        one = at[: at.size // w.teeth]
        middle = one[[0, -1]].sum() if one.size % 2 else one[one.size // 2]
        assert math.remainder(np.angle(middle) - laid.tooth_angle, 2 * math.pi) == pytest.approx(0.0, abs=1e-9), w.name
    assert abs(math.remainder(np.angle(middle) - 2.0, 2 * math.pi)) <= math.pi / 25 + 1e-9


def test_a_train_that_stands_elsewhere_than_its_layout_meshes_there():
    gears = r753()
    t = with_layout(geometry(gears, SPEED), gears, {"shaft": ShaftInTrain(0.130 + 0.103j, 2.0)}).result
    places = placed(t)
    assert dxf(train_drawing(t, "x", places), LAYERS) == dxf(
        train_drawing(dataclasses.replace(t, layout=None), "x", places), LAYERS
    )
