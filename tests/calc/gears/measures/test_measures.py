"""The measures of the source's wheels, their limits, their table of spans, the preferred ball, and the verdict on
measured sizes."""

import math
from dataclasses import replace

import pytest

from calc.gears.measures.formulas import PREFERRED, thickness_allowance
from calc.gears.measures.solve import checks, measures
from calc.gears.solve import geometry
from calc.sheet.quantity import published
from calc.sheet.value import leaves, link_of, trace
from tests.calc.gears.trains import SPEED, mesh, pair_1, train, wheel


def of(gears, name, **said):
    found = geometry(gears, SPEED).result
    given = next(w for w in gears.wheels if w.name == name)
    sizes, table = measures(found.system, replace(given, **said), found.wheels[name], working(found, name))
    return sizes, tuple(checks(found.system, found.wheels[name], sizes)), table()


def working(found, name):
    pair = next(iter(found.meshes.values()))
    return [("mate", pair.working_diameter_driver if pair.driver == name else pair.working_diameter_driven)]


@pytest.mark.parametrize(
    ("name", "size", "printed"),
    [
        # Finotti 2013, Table 4.22, the allowances as they are printed: largest and smallest size over pieces of 3.5 mm
        ("central", "over_pins_max", "82.665"),
        ("central", "over_pins_min", "82.618"),
    ],
)
def test_printed_sizes(name, size, printed):
    found, _, _ = of(pair_1(), name)
    assert getattr(found, size) * 1e3 == pytest.approx(float(printed), abs=0.5e-3)


@pytest.mark.parametrize(("name", "exact"), [("central", 3.236), ("idler", 3.492)])
def test_ball_at_the_working_circle(name, exact):
    """The source's sheet takes this ball; solved exactly where the sheet multiplies two angles (recorded: 3.236 and
    3.492 mm)."""
    found, _, _ = of(pair_1(), name)
    assert found.ideal_balls["ideal_ball_at_mate"].number * 1e3 == pytest.approx(exact, abs=0.5e-3)


def test_no_ball_touches_where_the_flanks_have_met():
    gears = pair_1()
    found = geometry(gears, SPEED).result
    idler, low = found.wheels["idler"], ("deep", found.wheels["idler"].base_diameter * 1.001)
    deep, _ = measures(found.system, gears.wheels[1], idler, [low])
    assert deep.ideal_balls["ideal_ball_at_deep"].number > 0
    thick = train([wheel("a", 12, 2.2), wheel("mate", 40)], [mesh("a", "mate")], beta=0.0)
    a = geometry(thick, SPEED).result.wheels["a"]
    none, _ = measures(geometry(thick, SPEED).result.system, thick.wheels[0], a, [("deep", a.base_diameter * 1.001)])
    assert none.ideal_balls == {}


def test_allowances_are_thickness_over_the_cosines():
    """E_sn = E_W/cos α_n, and transverse at d the same as E_W/(cos α_t·cos β_b)."""
    found, _, _ = of(pair_1(), "idler")
    system = geometry(pair_1(), SPEED).result.system
    assert found.thickness_allowance_upper == pytest.approx(-20e-6 / math.cos(system.alpha_n), rel=1e-12)
    across = math.cos(system.transverse_pressure_angle) * math.cos(system.base_helix_angle)
    assert found.transverse_allowance_lower == pytest.approx(-30e-6 / across, rel=1e-12)


def test_each_limit_says_of_which_tooth_it_is():
    with trace() as lines:
        of(pair_1(), "idler")
    allowances = {line.about: line.value for line in lines if line.formula is thickness_allowance}
    assert allowances["measures of idler, thickest tooth"] == pytest.approx(-20e-6 / math.cos(math.radians(20)))
    assert allowances["measures of idler, thinnest tooth"] == pytest.approx(-30e-6 / math.cos(math.radians(20)))


def test_sizes_at_the_limits_are_those_of_the_thinned_wheel():
    gears = pair_1()
    thin = replace(gears.wheels[1], profile_shift=None)
    found, _, _ = of(replace(gears, wheels=(gears.wheels[0], thin)), "idler")
    system = geometry(gears, SPEED).result.system
    x = geometry(gears, SPEED).result.wheels["idler"].profile_shift
    x_E = x - 30e-6 / (2 * system.m_n * math.sin(system.alpha_n))
    mate = wheel("mate", 36)
    other = train([wheel("idler", 39, x_E, cut=0.2, span=5), mate], [mesh("idler", "mate")])
    nominal, _, _ = of(other, "idler")
    for size in ("over_one_ball", "over_pins", "over_two_pins", "constant_chord"):
        assert getattr(found, f"{size}_min") == pytest.approx(getattr(nominal, size), abs=1e-15)
    assert found.chordal_thickness_min == pytest.approx(
        geometry(other, SPEED).result.wheels["idler"].chordal_thickness, abs=1e-15
    )


def test_spans_of_the_idler():
    """Best 6, chosen 5 as on the source's drawing (Fig. 4.21); both printed spans are in the table."""
    gears = pair_1(span=(5, 5))
    found, _, table = of(gears, "idler")
    assert found.best_span_teeth == 6
    rows = {row[0]: row for row in table.rows}
    assert rows["5"][1] == pytest.approx(27.708, abs=0.5e-3) and rows["5"][-1] == "chosen"  # Finotti 2013, Table 4.4
    assert rows["6"][1] == pytest.approx(33.613, abs=0.5e-3) and rows["6"][-1] == "best"  # Table 4.20
    assert rows["5"][2:4] == pytest.approx((rows["5"][1] - 0.03, rows["5"][1] - 0.02), abs=1e-12)
    d_b = geometry(gears, SPEED).result.wheels["idler"].base_diameter
    base = math.asin(math.sin(math.radians(21.916)) * math.cos(math.radians(20)))
    assert rows["5"][4] == pytest.approx(math.hypot(d_b * 1e3, rows["5"][1] * math.cos(base)))
    assert rows["5"][5] == pytest.approx(rows["5"][1] * math.sin(base))
    assert rows["3"][-1] == "touches below the form circle" and rows["8"][-1] == "misses the tip circle"


def test_a_narrow_face_leaves_fewer_spans():
    found, _, table = of(pair_1(b=9.72), "idler")  # the width that K = 5 needs is 9.718 mm
    assert found.best_span_teeth == 5
    assert next(row[-1] for row in table.rows if row[0] == "6") == "chosen, needs a wider face"
    none, _, _ = of(pair_1(b=2.0), "idler")
    assert none.best_span_teeth is None


def test_odd_spur_and_even_wheels_have_no_loose_pins():
    even, _, _ = of(pair_1(), "central")
    assert even.over_two_pins is even.pins_width is None
    odd, checks, _ = of(pair_1(), "idler")
    assert odd.over_two_pins < odd.over_pins and "gears.idler.pins_width" in {c.id for c in checks}
    spur, checks, _ = of(train([wheel("a", 25), wheel("mate", 30)], [mesh("a", "mate")], beta=0.0), "a")
    assert spur.over_two_pins is spur.pins_width is None and "gears.a.pins_width" not in {c.id for c in checks}


def test_a_ball_that_lies_on_the_root_has_no_sizes():
    found, _, _ = of(pair_1(ball=1.0), "idler")
    assert found.over_one_ball is found.over_pins is found.over_one_ball_min is None
    assert geometry(pair_1(ball=1.0), SPEED).result.wheels["idler"].preferred_ball == 3.25e-3


@pytest.mark.parametrize(("z", "beta", "m_n", "x"), [(25, 21.9, 2.0, 0.0), (60, 0.0, 1.0, 0.4), (18, 30.0, 6.0, 0.3)])
def test_the_preferred_ball_is_the_nearest_that_suits(z, beta, m_n, x):
    gears = train(
        [wheel("a", z, x), wheel("mate", 40)], [mesh("a", "mate")], m_n=m_n, beta=beta, ball=None, tool=(1.25, 0.3)
    )
    a = geometry(gears, SPEED).result.wheels["a"]
    assert a.ball_diameter == a.preferred_ball  # chosen where none is given
    chosen, _, _ = of(replace(gears, ball_diameter=a.preferred_ball), "a")
    assert a.form_diameter < chosen.ball_contact_diameter < a.tip_diameter < 2 * chosen.over_one_ball
    nearer = [D for D in PREFERRED if abs(D - a.ideal_ball) < abs(a.preferred_ball - a.ideal_ball)]
    for D in nearer:
        other, _, _ = of(replace(gears, ball_diameter=D), "a")
        low, high = a.form_diameter, a.tip_diameter
        assert other.ball_contact_diameter is None or not (
            low < other.ball_contact_diameter < high < 2 * other.over_one_ball
        )


def test_no_preferred_ball_is_small_enough():
    a = geometry(
        train([wheel("a", 30), wheel("mate", 40)], [mesh("a", "mate")], m_n=0.3, ball=None), SPEED
    ).result.wheels["a"]
    assert a.preferred_ball is None and a.ball_diameter == a.ideal_ball


# --- measured sizes
def verdicts(**sizes):
    found, checks, _ = of(pair_1(span=(5, 5)), "idler", **sizes)
    return found, {c.id.removeprefix("gears.idler."): c for c in checks}


@pytest.mark.parametrize(
    ("span", "verdict"), [(27.683e-3, "pass"), (27.6883e-3, "warn"), (27.6780e-3, "warn"), (27.700e-3, "warn")]
)
def test_a_measured_span_is_judged_by_its_allowance(span, verdict):
    """Limits 27.6783 to 27.6883 mm."""
    found, checks = verdicts(measured_span=span)
    assert checks["measured_span"].verdict == verdict
    assert found.measured_span.span_change == pytest.approx(span - 27.708263573e-3, abs=1e-11)
    assert "measured_spread" not in checks and found.measured_spread is None


def test_routes_that_contradict_each_other_are_named():
    found, checks = verdicts(measured_span=27.683e-3, measured_over_balls=88.3832e-3, measured_over_pins=88.4521e-3)
    assert checks["measured_over_balls"].verdict == checks["measured_over_pins"].verdict == "pass"
    assert found.measured_spread < 1e-6 and checks["measured_spread"].verdict == "pass"
    found, checks = verdicts(measured_span=27.683e-3, measured_over_pins=88.40e-3)
    assert (checks["measured_over_pins"].verdict, checks["measured_spread"].verdict) == ("warn", "note")
    assert found.measured_spread == pytest.approx(
        found.measured_span.normal_thickness - found.measured_over_pins.normal_thickness, abs=1e-15
    )
    assert "read 0.083 mm less" in checks["measured_over_pins"].advice


def test_the_height_of_a_measured_chord_is_said():
    found, checks = verdicts(measured_chordal_thickness=2.8875e-3)
    advice = checks["measured_chordal_thickness"].advice
    height = geometry(pair_1(), SPEED).result.wheels["idler"].chordal_height
    assert (
        f"{height * 1e3:.4f} mm below a tip circle of 87.0521 mm" in advice
        and checks["measured_chordal_thickness"].verdict == "pass"
    )
    assert found.measured_chordal_thickness.normal_thickness > 2.8875e-3  # the arc


def test_without_an_allowance_sizes_are_turned_but_not_judged():
    found, checks, _ = of(pair_1(allowances=(None, None)), "idler", measured_span=33.60e-3)
    assert found.measured_span.span_change == pytest.approx(-0.0125e-3, abs=1e-6)
    assert not [c for c in checks if "measured" in c.id] and found.over_pins_min is None


def test_ids_are_unique_and_every_line_has_its_wheel():
    gears = pair_1()
    whole = geometry(gears, SPEED)
    train_ = whole.result
    sizes = dict(
        measured_span=33.59e-3,
        measured_over_balls=88.38e-3,
        measured_over_pins=88.45e-3,
        measured_chordal_thickness=2.89e-3,
    )
    with trace() as lines:
        found, _ = measures(
            train_.system, replace(gears.wheels[1], **sizes), train_.wheels["idler"], working(train_, "idler")
        )
    ids = [v.id for v in published(found, "gears.idler")]
    assert len(ids) == len(set(ids)) and "gears.idler.measured_span.normal_thickness" in ids
    judged = [check.id for check in checks(train_.system, train_.wheels["idler"], found)]
    assert len(set(judged)) == len(judged)
    assert len(lines) > 40 and all("idler" in line.about for line in lines)
    returned = {*lines, *whole.lines}  # where a ball sits the wheel has found before
    for v in published(found, "gears.idler"):
        assert leaves(link_of(v.inside)) and set(leaves(link_of(v.inside))) <= returned, v.id
