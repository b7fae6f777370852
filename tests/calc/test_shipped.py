# SPDX-License-Identifier: Apache-2.0
"""The shipped engines: designs that solve, cranks that balance and fire as published, data in plausible ranges."""

import cmath
import math
import tomllib
from pathlib import Path

import numpy as np
import pytest

from assistant.cli import main
from calc.design_file import design, parse
from calc.shipped import engine_design, engines
from calc.solve import solve

ENGINES = engines()
ROWS = tomllib.loads((Path(__file__).parents[1] / "reference" / "balance.toml").read_text(encoding="utf-8"))["row"]
PUBLISHED = {row["engine"]: (row["first"], row["second"]) for row in ROWS}

# Which published engine each of ours is: tests/reference/balance.toml.
LAYOUT = {
    "r753ie4": "inline-3", "single": "single", "twin-360": "inline-2, pins together", "twin-180": "inline-2, 180°", "inline-3": "inline-3",
    "two-stroke-3": "inline-3", "r754ie4": "inline-4, flat", "inline-4": "inline-4, flat", "inline-4-cross": "inline-4, cross-plane",
    "inline-5": "inline-5, 1-2-4-5-3", "inline-6": "inline-6", "v6-60": "V6 60°, pins split by 60°", "v6-90-uneven": "V6 90°, three pins",
    "v8-cross": "V8 90°, cross-plane", "boxer-2": "boxer-2", "boxer-4": "boxer-4",
}  # fmt: skip


def cos(degrees: float) -> float:
    return math.cos(math.radians(degrees))


# The others by the sums of their few unit vectors, worked out by hand: force forward, backward, couple forward, backward.
ROOT3, NONE = math.sqrt(3), (0, 0, 0, 0)
BY_HAND = {
    "twin-270": ((cos(45), cos(45), cos(45) / 2, cos(45) / 2), (0, 0, 0.5, 0.5)),  # pins at a right angle, opposed in order 2
    "v2-45": ((1, cos(45), 0, 0), (cos(22.5), cos(67.5), 0, 0)),  # cylinders at ±V/2 on one pin: cos V, cos V/2, cos 3V/2
    "v2-90": ((1, 0, 0, 0), (cos(45), cos(45), 0, 0)),
    "v6-90": ((0, 0, ROOT3 * cos(15), ROOT3 * cos(75)), (0, 0, ROOT3 * cos(75), ROOT3 * cos(15))),  # three pairs, pins 30° apart
    "v8-flat": (NONE, (2 * math.sqrt(2), 2 * math.sqrt(2), 0, 0)),  # horizontal: √2 of each of four pairs, half of it each way
    "v12-60": (NONE, NONE),
    "boxer-6": (NONE, NONE),
}


def solved(name, **changes):
    document = parse(engine_design(name).encode("utf-8"), name)
    for key, value in changes.items():
        document = document.with_value(f"imbalance.{key}", value)
    made = design(document)
    return made, solve(made)


def dead_centres(name):
    """Degrees after TDC of cylinder 1 at which each piston stands at TDC, from 0 up to a turn."""
    crank = solved(name)[1].outcomes["engine"].result.crank
    angle = np.degrees(crank.psi - crank.phi) - math.degrees(crank.psi[0] - crank.phi[0])
    return np.round(angle, 6) % 360


def test_there_are_many_and_each_says_where_it_comes_from():
    assert len(ENGINES) >= 18 and next(iter(ENGINES)) == "r753ie4"
    for engine in ENGINES.values():
        assert engine.name and engine.what
        assert engine.source.startswith(("typical", "Finotti 2013"))


def test_the_list_is_aligned_and_fits_the_screen(capsys):
    assert main(["new", "--list"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == list(ENGINES)
    assert max(map(len, lines)) <= 120
    for line, engine in zip(lines, ENGINES.values()):
        assert [line.index(engine.name), line.index(engine.what)] == [lines[0].index("VM Motori"), lines[0].index("inline 3")]
        assert line.endswith(engine.source)


@pytest.mark.parametrize("name", ENGINES)
def test_the_design_solves_and_nothing_fails(name):
    made, results = solved(name)
    for key in ("engine", "imbalance"):
        outcome = results.outcomes[key]
        assert outcome.state == "solved" and outcome.verdict in ("pass", "warn")
        assert all(check.verdict in ("pass", "warn") for check in outcome.checks)
    assert made.engine.name == ENGINES[name].name


def test_every_engine_has_its_vectors():
    assert sorted([*LAYOUT, *BY_HAND]) == sorted(ENGINES)
    assert set(LAYOUT.values()) == set(PUBLISHED), "a published engine is not shipped"


@pytest.mark.parametrize("name", ENGINES)
def test_what_is_left_is_what_is_published(name):
    """Without a share on the crank, two-term kinematics, about mid-engine: it takes the pins, the banks and the positions."""
    made, results = solved(name, crank_balance_fraction=0.0, kinematics="two_term")
    e, imbalance = results.outcomes["engine"].result, results.outcomes["imbalance"].result
    first, second = PUBLISHED[LAYOUT[name]] if name in LAYOUT else BY_HAND[name]
    unit = e.reciprocating_mass * made.engine.crank_radius * e.angular_speed**2
    couple = unit * made.engine.cylinder_pitch
    for order, expected, share in (("order_1", first, 1.0), ("order_2", second, e.lambda_)):
        vectors = imbalance.orders[order].vectors
        found = [abs(vector) / share / scale for vector, scale in zip(vectors, (unit, unit, couple, couple))]
        assert found == pytest.approx(list(expected), abs=1e-4), order


@pytest.mark.parametrize("name", ENGINES)
def test_the_crank_carries_half_unless_its_throws_cancel(name):
    """Half of the reciprocating mass on the crank takes all that turns forward; a crank that is even already carries none."""
    made, results = solved(name)
    crank = results.outcomes["engine"].result.crank
    throws = sum(cmath.exp(1j * phi) for phi in crank.phi), sum(z * cmath.exp(1j * phi) for phi, z in zip(crank.phi, crank.z))
    even = abs(throws[0]) < 1e-6 and abs(throws[1]) < 1e-6 * made.engine.cylinder_pitch
    assert made.imbalance.crank_balance_fraction == (0.0 if even else 0.5)
    first = results.outcomes["imbalance"].result.orders["order_1"]
    assert first.force_forward == pytest.approx(0) and first.couple_forward == pytest.approx(0)


@pytest.mark.parametrize("name", ENGINES)
def test_the_dead_centres_fit_even_firing_just_where_it_is_claimed(name):
    made, _ = solved(name)
    n = made.engine.cylinders
    even = np.sort(np.arange(n) * 180.0 * made.engine.strokes / n % 360)
    fits = np.allclose(np.sort(dead_centres(name)), even, atol=1e-4)
    claim = ENGINES[name].what
    assert fits == ("uneven firing" not in claim)
    assert n == 1 or "even firing" in claim


@pytest.mark.parametrize(
    "name, order, intervals",
    [
        ("inline-4-cross", (1, 3, 2, 4), (270, 180, 90, 180)),  # Yamaha 2009
        ("v6-90-uneven", (1, 6, 3, 5, 2, 4), (150, 90) * 3),  # PRV 1974
        ("v2-90", (1, 2), (450, 270)),
        ("v2-45", (1, 2), (405, 315)),
        ("twin-180", (1, 2), (180, 540)),
        ("twin-270", (1, 2), (270, 450)),
        ("v8-cross", (1, 8, 7, 2, 6, 5, 4, 3), (90,) * 8),  # GM 1997
        ("two-stroke-3", (1, 3, 2), (120,) * 3),
    ],
)
def test_an_engine_fires_in_its_order_at_its_intervals(name, order, intervals):
    at = np.concatenate(([0.0], np.cumsum(intervals)))
    assert at[-1] == 180 * solved(name)[0].engine.strokes
    assert dead_centres(name)[np.array(order) - 1] == pytest.approx(at[:-1] % 360, abs=1e-4)


@pytest.mark.parametrize("name", ["v8-cross", "v8-flat", "v12-60"])
def test_neighbours_across_the_vee_share_a_pin(name):
    """The firing orders of the makers give these cranks only with the banks the right way round."""
    crank = solved(name)[1].outcomes["engine"].result.crank
    for z in set(crank.z):
        one, other = crank.phi[crank.z == z]
        assert math.cos(one - other) == pytest.approx(1)


@pytest.mark.parametrize("name, split", [("v6-60", 60), ("v6-90", 30)])
def test_the_split_pin_of_bank_1_lags(name, split):
    crank = solved(name)[1].outcomes["engine"].result.crank
    for z in set(crank.z):
        row = crank.z == z
        lead, lag = crank.phi[row & (crank.psi < 0)][0], crank.phi[row & (crank.psi > 0)][0]
        assert math.degrees(lead - lag) % 360 == pytest.approx(split)


@pytest.mark.parametrize("name", ENGINES)
def test_dimensions_and_masses_are_plausible(name):
    engine = solved(name)[0].engine
    assert 0.22 <= engine.crank_radius / engine.rod_length <= 0.33
    if name != "boxer-2":  # one cylinder on either side: no neighbour; in the others the throws alternate between the sides
        assert 1.05 < engine.cylinder_pitch * (2 if engine.layout == "boxer" else 1) / engine.bore < 1.5
    assert 400 < engine.piston_mass / engine.bore**3 < 1600  # kg/m³: light petrol piston to heavy Diesel
    assert 0.7 < engine.rod_mass / engine.piston_mass < 1.5
    assert 6 < 4 * engine.crank_radius * engine.rated_speed < 26  # mean piston speed, m/s
