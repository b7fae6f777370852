"""The gas of a cylinder: the simple cycle on the true volume of the slider-crank, the table of pressures, and bad
inputs."""

import math
import tomllib

import numpy as np
import pytest

from calc.design.toml_file import Document, _Reader
from calc.engine import cycle as c
from calc.engine import formulas as f
from calc.engine.gas import GasInputs, PressurePoint, cycle_problems
from calc.engine.inputs import EngineInputs
from calc.engine.solve import values
from calc.engine.torque import prepare
from tests.calc.imbalance.test_engines import R753

DEGREE = math.pi / 180
DIESEL = dict(peak_pressure=150e5, compression_ratio=17.5)


def prepared(gas=None, **changes):
    engine = EngineInputs(**{**R753, **changes})
    e = values(engine)
    return engine, e, prepare(engine, e, gas or GasInputs(**DIESEL))


def way(engine, e, epsilon):
    alpha = np.asarray(e.tdc_angle + epsilon)
    return c.piston_way(
        r=engine.crank_radius,
        lam=e.lambda_,
        phi_0=e.tdc_angle,
        alpha=alpha,
        beta=f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta),
    )


def pressure(engine, e, cycle, degrees):
    epsilon = np.asarray(degrees) * DEGREE
    return cycle.pressure(epsilon, way(engine, e, epsilon))


@pytest.mark.parametrize("offset", [-0.01, 0.0, 0.007])
def test_the_way_of_the_piston(offset):
    """0 at TDC, the stroke at BDC, and its slope is the relative speed: true with an offset cylinder as well."""
    engine, e, _ = prepared(cylinder_offset=offset)
    bdc = c.dead_centre_angle(delta=e.delta, lam=e.lambda_)
    assert way(engine, e, 0.0) == pytest.approx(0, abs=1e-15)
    assert way(engine, e, bdc) == pytest.approx(e.stroke, rel=1e-14)
    epsilon = np.linspace(0, 2 * np.pi, 1001)
    alpha = e.tdc_angle + epsilon
    speed = f.relative_speed(alpha=alpha, beta=f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta))
    assert np.gradient(way(engine, e, epsilon), epsilon)[1:-1] == pytest.approx(
        speed[1:-1] * engine.crank_radius, abs=1e-6
    )
    assert way(engine, e, epsilon).max() <= e.stroke * (1 + 1e-12)


def test_down_stroke_of_the_offset_engine():
    """r 53.5, L 163 mm, δ = 0.045: the down-stroke takes 181.899°."""
    _, e, _ = prepared(cylinder_offset=0.045 * 0.163)
    assert math.degrees(c.dead_centre_angle(delta=e.delta, lam=e.lambda_)) == pytest.approx(181.899, abs=5e-4)


@pytest.mark.parametrize("offset", [0.0, 0.007])
def test_the_four_stroke_cycle_stroke_by_stroke(offset):
    engine, e, cycle = prepared(
        GasInputs(**DIESEL, intake_pressure=1.2e5, exhaust_pressure=1.5e5), cylinder_offset=offset
    )
    bdc = math.degrees(c.dead_centre_angle(delta=e.delta, lam=e.lambda_))
    at = lambda degrees: float(pressure(engine, e, cycle, degrees))  # noqa: E731
    assert at(0) == at(9.99) == 150e5
    assert at(10.001) == pytest.approx(150e5, rel=1e-3)
    assert at(bdc + 1) == at(359) == 1.5e5
    assert at(361) == at(360 + bdc - 1) == 1.2e5
    assert at(360 + bdc + 1e-6) == pytest.approx(1.2e5, rel=1e-6)
    assert at(720 - 1e-6) == pytest.approx(1.2e5 * 17.5**1.35, rel=1e-6) == pytest.approx(cycle.compression_end)
    volume = lambda degrees: e.stroke / 16.5 + float(way(engine, e, degrees * DEGREE))  # noqa: E731
    assert at(100) * volume(100) ** 1.28 == pytest.approx(150e5 * volume(10) ** 1.28)
    assert at(650) * volume(650) ** 1.35 == pytest.approx(1.2e5 * volume(bdc) ** 1.35)


def test_the_two_stroke_cycle_has_neither_exhaust_nor_intake():
    engine, e, cycle = prepared(strokes=2)
    assert cycle.length == pytest.approx(2 * math.pi)
    p = pressure(engine, e, cycle, [0.0, 179.0, 180.001, 359.999999])
    assert p[0] == 150e5
    assert p[1] > 3e5
    assert p[2:] == pytest.approx([1e5, 1e5 * 17.5**1.35], rel=1e-4)
    assert any("ports" in note for note in cycle.notes)


def test_what_was_taken_for_numbers_left_out_is_said():
    said = " ".join(prepared()[2].notes)
    for words in (
        "crankcase pressure of 1.0 bar",
        "intake pressure of 1.0 bar",
        "exhaust pressure of 1.1 bar",
        "1.35",
        "1.28",
        "10°",
    ):
        assert words in said
    given = GasInputs(
        **DIESEL,
        intake_pressure=1e5,
        exhaust_pressure=1.1e5,
        crankcase_pressure=1e5,
        compression_exponent=1.35,
        expansion_exponent=1.28,
        constant_pressure_angle=10 * DEGREE,
    )
    assert prepared(given)[2].notes == ()


def table(*points):
    return tuple(PressurePoint(angle=degrees * DEGREE, pressure=bar * 1e5) for degrees, bar in points)


EVERY_90 = ((-270, 1), (-180, 1), (-90, 2), (0, 60), (90, 6), (180, 3), (270, 1.2), (360, 1.0))


def test_a_table_is_linear_between_its_points_and_closes_over_the_cycle():
    engine, e, cycle = prepared(GasInputs(pressure=table(*EVERY_90)))
    assert pressure(engine, e, cycle, [0, 45, 90, 675, 630, 360, 405, 450]) / 1e5 == pytest.approx(
        [60, 33, 6, 31, 2, 1, 1, 1]
    )
    assert any("no point between" in note for note in cycle.notes)


def test_an_angle_a_cycle_away_is_the_same_angle():
    moved = tuple((degrees + 720 if degrees < 0 else degrees, bar) for degrees, bar in EVERY_90)
    one, two = (prepared(GasInputs(pressure=table(*points))) for points in (EVERY_90, moved))
    degrees = np.linspace(0, 719, 300)
    assert pressure(*one, degrees) == pytest.approx(pressure(*two, degrees))


NINE = (*EVERY_90[:-1], (300, 1.1), (350, 1.0))


@pytest.mark.parametrize(
    "gas, key",
    [
        (dict(), "peak_pressure_bar"),
        (dict(), "compression_ratio"),
        (dict(peak_pressure=80e5), "compression_ratio"),
        (dict(compression_ratio=17.5), "peak_pressure_bar"),
        (dict(peak_pressure=40e5, compression_ratio=17.5), "peak_pressure_bar"),
        (dict(peak_pressure=80e5, compression_ratio=17.5, intake_pressure=2e5), "peak_pressure_bar"),
        (dict(peak_pressure=80e5, pressure=table(*NINE)), "peak_pressure_bar"),
        (dict(compression_ratio=17.5, pressure=table(*NINE)), "compression_ratio"),
        (dict(expansion_exponent=1.3, pressure=table(*NINE)), "expansion_exponent"),
        (dict(pressure=table(*NINE[:7])), "pressure"),
        (dict(pressure=table(*NINE, (90, 7))), "pressure.9.angle_deg"),
        (dict(pressure=table(*NINE, (450, 9))), "pressure.9.angle_deg"),
    ],
)
def test_what_makes_no_sense_is_named(gas, key):
    assert key in [k for k, _ in GasInputs(**gas).problems()]


def test_good_gas_has_no_problems():
    for gas in (GasInputs(**DIESEL), GasInputs(pressure=table(*NINE))):
        assert not list(gas.problems())
        assert not list(cycle_problems(gas, 4))


def test_problems_of_a_two_stroke_engine():
    """−270° and 90° are one angle of its cycle; of a four-stroke's they are two."""
    assert [k for k, _ in cycle_problems(GasInputs(pressure=table(*NINE)), 2)] == [
        "pressure.4.angle_deg",
        "pressure.5.angle_deg",
        "pressure.6.angle_deg",
    ]
    assert [k for k, _ in cycle_problems(GasInputs(**DIESEL, exhaust_pressure=1.1e5), 2)] == ["exhaust_pressure_bar"]
    assert not list(cycle_problems(GasInputs(pressure=table(*((45 * i, 1 + i) for i in range(8)))), 2))


def test_numbers_out_of_range_are_named_by_the_file():
    text = (
        "\n".join(f"[[pressure]]\nangle_deg = {90 * i - 360}\npressure_bar = {-1 if i == 3 else 1}" for i in range(8))
        + "\n[extra]\n"
    )
    reader = _Reader(Document(tomllib.loads(text)))
    reader.inputs(GasInputs, tomllib.loads(text), "engine.gas")
    assert {error.key for error in reader.errors} == {"engine.gas.pressure.3.pressure_bar", "engine.gas.extra"}


def test_the_dust_of_a_firing_angle_does_not_make_a_cycle():
    """At its firing TDC a cylinder has the peak pressure, not the end of compression one rounding error before it."""
    assert 0.3 - (0.1 + 0.2) < 0
    assert c.own_angle(epsilon=0.3, fires=0.1 + 0.2, cycle=4 * math.pi) == 0.0
    assert c.own_angle(epsilon=0.0, fires=np.array([0.0, 3.0]), cycle=4 * math.pi).tolist() == [0.0, 4 * math.pi - 3.0]
