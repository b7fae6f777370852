"""A torque that is given as a diagram over the crank angle: mean, fluctuation of the energy, irregularity."""

import math
from pathlib import Path

import numpy as np
import pytest

from calc.design.toml_file import design, parse
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.explain import Chains

TWIN = (Path(__file__).parents[3] / "designs" / "twin_force_shaft.toml").read_text(encoding="utf-8")
HEAD, _, REST = TWIN.partition("[engine.gas]")
WITHOUT_GAS = HEAD + REST[REST.index("[engine.throw]") :]


def with_diagram(rows, period=None, text=WITHOUT_GAS):
    own = f"torque_period_deg = {period}\n" if period is not None else ""
    table = "".join(f"[[engine.torque]]\nangle_deg = {angle}\ntorque_Nm = {torque}\n" for angle, torque in rows)
    return text.replace("flywheel_inertia_kgm2", own + "flywheel_inertia_kgm2") + "\n" + table


def results(*args, **kwargs):
    return solve(design(parse(with_diagram(*args, **kwargs).encode(), "d.toml")))


def errors(*args, **kwargs):
    with pytest.raises(BadInput) as caught:
        results(*args, **kwargs)
    return str(caught.value)


def test_a_triangle_by_hand():
    """T rises from 0 to 400 N·m over 180° and falls back to 0 over 180°, once a turn: T_m = 200 N·m; above it stands a
    triangle over 180° of 200 N·m height, ΔE = 200·π/2 = 100·π J."""
    found = results([(0, 0), (180, 400), (360, 0)], 360)
    value = {id: v.inside for id, v in found.values().items()}
    assert value["engine.mean_torque"] == pytest.approx(200) and value["engine.energy_fluctuation"] == pytest.approx(
        100 * math.pi
    )
    omega = 2 * math.pi * 5500 / 60
    assert value["engine.speed_irregularity"] == pytest.approx(100 * math.pi / (0.11 * omega**2))
    assert value["engine.indicated_power"] == pytest.approx(200 * omega)
    assert (value["engine.torque_highest"], value["engine.torque_lowest"], value["engine.torque_peak"]) == (400, 0, 400)
    assert (
        math.degrees(value["engine.torque_peak_angle"]) == pytest.approx(180) and "engine.gas_torque_peak" not in value
    )


@pytest.mark.parametrize("start", [0, -90, 37.5])
def test_a_turning_moment_of_khurmis_kind(start):
    """T = 20000 + 9500 sin 2θ − 5700 cos 2θ N·m: the wave of amplitude √(9500² + 5700²) stands 90° above the mean, ΔE =
    its amplitude."""
    theta = start + np.arange(0, 180, 0.5)
    T = 20000 + 9500 * np.sin(np.radians(2 * theta)) - 5700 * np.cos(np.radians(2 * theta))
    value = {id: v.inside for id, v in results(list(zip(theta.tolist(), T.tolist())), 180).values().items()}
    assert value["engine.mean_torque"] == pytest.approx(20000, rel=1e-9)
    assert value["engine.energy_fluctuation"] == pytest.approx(math.hypot(9500, 5700), rel=2e-4)


def test_the_period_is_the_cycle_where_none_is_given():
    value = {id: v.inside for id, v in results([(0, 0), (90, 400), (180, 0)]).values().items()}
    assert value["engine.mean_torque"] == pytest.approx(400 * math.pi / 2 / (4 * math.pi))


def test_the_diagram_stands_in_the_chain_and_in_a_figure():
    found = results([(0, 0), (180, 400), (360, 0)], 360)
    chains = Chains(found)
    for id in ("engine.mean_torque", "engine.speed_irregularity", "engine.torque_peak"):
        keys = {key for link in chains.of(id) for key in link.inputs}
        assert "engine.torque.1.torque_Nm" in keys, id
    assert {"engine.torque.1.angle_deg", "engine.torque_period_deg"} <= {
        key for link in chains.of("engine.mean_torque") for key in link.inputs
    }
    assert "engine.torque.1.angle_deg" in {key for link in chains.of("engine.torque_peak_angle") for key in link.inputs}
    curve = next(c for c in found.outcomes["engine"].curves if c.id == "torque")
    assert curve.series[0].y.tolist() == [0, 400, 0] and curve.limits[0][1] == pytest.approx(200)


@pytest.mark.parametrize(
    "rows, period, wanted",
    [
        ([(0, 1), (10, 2)], None, ["engine.torque", "has 2 rows; needs at least 3"]),
        ([(0, 1), (10, 2), (10, 3)], None, ["engine.torque.2.angle_deg: 10: must be above that of the row before"]),
        (
            [(0, 1), (100, 2), (361, 1)],
            360,
            ["engine.torque.2.angle_deg: 361: lies more than the period of 360° behind the first row"],
        ),
        (
            [(0, 1), (100, 2), (360, 5)],
            360,
            ["engine.torque.2.torque_Nm: 5: must be that of the first row, 360° before it"],
        ),
        ([], 360, ["engine.torque_period_deg", "belongs to a torque diagram"]),
    ],
)
def test_what_is_refused(rows, period, wanted):
    said = errors(rows, period)
    assert all(part in said for part in wanted), said


def test_gas_and_diagram_are_not_given_together():
    assert "engine.torque: the gas gives the torque already" in errors([(0, 0), (180, 400), (360, 0)], 360, text=TWIN)
