# SPDX-License-Identifier: Apache-2.0
"""The direct solution of Reynolds' equation against converged, published and closed-form values."""

import json
import math
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from calc.bearings.plain.film.reynolds import FilmSolution, radial_damping, solve_film, solve_misaligned

REFERENCE = Path(__file__).parents[3] / "reference"
CONVERGED = json.loads((REFERENCE / "bearings_reynolds.json").read_text())["rows"]
PUBLISHED = json.loads((REFERENCE / "raimondi_boyd_1958.json").read_text())["rows"]
# Raimondi and Boyd's Q 0.760 and 0.411; the closed form gives 0.7825 and 0.3891
WRONG_FLOW = {("inf", 0.8), ("inf", 0.9)}


def named(row: dict) -> str:
    return f"{row['ld']}-{row['eps']}"


def as_row(film: FilmSolution) -> dict[str, float]:
    return {
        "S": film.sommerfeld,
        "phi": math.degrees(film.attitude),
        "frc": film.friction,
        "Q": film.flow,
        "QsQ": film.side_flow_ratio,
        "Pr": film.pressure_ratio,
    }


def infinitely_long(eccentricity: float) -> dict[str, float]:
    """Sommerfeld's substitution, the film ending where pressure and gradient vanish; integrals by the trapezoidal
    rule."""

    def gradient_at_end(angle: float) -> float:
        return eccentricity * (math.sin(angle) * math.cos(angle) - angle) + 2.0 * (
            math.sin(angle) - angle * math.cos(angle)
        )

    low, high = math.pi, 1.5 * math.pi
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if gradient_at_end(middle) > 0.0 else (low, middle)
    gamma = np.linspace(0.0, low, 200_001)
    film = (1.0 - eccentricity**2) / (1.0 - eccentricity * np.cos(gamma))
    theta = 2.0 * np.arctan2(math.sqrt((1 + eccentricity) / (1 - eccentricity)) * np.sin(gamma / 2), np.cos(gamma / 2))
    slope = 6.0 * (film - film[-1]) / film**3
    pressure = np.concatenate([[0.0], np.cumsum(0.5 * (slope[1:] + slope[:-1]) * np.diff(theta))])
    between = 0.5 * (pressure[1:] + pressure[:-1])
    cosine, sine = between @ np.diff(np.sin(theta)), -between @ np.diff(np.cos(theta))
    load = math.hypot(cosine, sine)
    return {
        "S": 1.0 / (math.pi * load),
        "phi": math.degrees(math.atan2(sine, -cosine)),
        "Q": math.pi * film[-1],
        "Pr": 0.5 * load / pressure.max(),
    }


@pytest.mark.parametrize("row", CONVERGED, ids=named)
def test_converged_solutions(row):
    film = as_row(solve_film(row["eps"], float(row["ld"])))
    for name in film.keys() & row.keys():
        assert film[name] == pytest.approx(row[name], rel=5e-4 if name == "Pr" else 1e-4), name


@pytest.mark.parametrize("row", PUBLISHED, ids=named)
def test_raimondi_and_boyd(row):
    """Coarse grids of 1958: at ε = 0.97 S is low by up to 3.1 %, P/pmax by up to 6 %."""
    film = as_row(solve_film(row["eps"], float(row["ld"])))
    thin = row["eps"] > 0.9
    assert film["S"] == pytest.approx(row["S"], rel=0.035 if thin else 0.02)
    assert film["frc"] == pytest.approx(row["frc"], rel=0.035 if thin else 0.01)
    assert film["phi"] == pytest.approx(row["phi"], abs=0.6)
    assert film["QsQ"] == pytest.approx(row["QsQ"], abs=0.004)
    assert film["Pr"] == pytest.approx(row["Pr"], rel=0.065 if thin else 0.026)
    if (row["ld"], row["eps"]) not in WRONG_FLOW:
        assert film["Q"] == pytest.approx(row["Q"], rel=0.01 if row["ld"] == "inf" else 0.005)


@pytest.mark.parametrize("eccentricity", [0.02, 0.1, 0.3, 0.5, 0.8, 0.9, 0.98])
def test_infinitely_long_bearing(eccentricity):
    film, exact = as_row(solve_film(eccentricity, math.inf)), infinitely_long(eccentricity)
    assert {name: film[name] for name in exact} == pytest.approx(exact, rel=3e-5)
    assert film["QsQ"] == 0.0


@pytest.mark.parametrize("eccentricity, tolerance", [(0.05, 0.02), (0.2, 0.02), (0.5, 0.03)])
def test_short_bearing(eccentricity, tolerance):
    """Ocvirk, NACA TN 2808 (1952): parabolic across, half a film; the remainder at l/d = 0.1 is a few per cent."""
    film = solve_film(eccentricity, 0.1)
    rest = 1.0 - eccentricity**2
    load = 0.1**2 * eccentricity * math.sqrt(math.pi**2 * rest + 16.0 * eccentricity**2) / (2.0 * rest**2)
    assert 1.0 / (2.0 * math.pi * film.sommerfeld) == pytest.approx(load, rel=tolerance)
    assert film.attitude == pytest.approx(math.atan(math.pi * math.sqrt(rest) / (4.0 * eccentricity)), abs=tolerance)
    assert film.flow == pytest.approx(math.pi * (1.0 + eccentricity), rel=tolerance)
    assert film.side_flow_ratio == pytest.approx(2.0 * eccentricity / (1.0 + eccentricity), rel=tolerance)


def test_the_remainder_of_the_short_bearing_shrinks_with_the_square_of_the_length():
    def remainder(length_ratio: float) -> float:
        film = solve_film(0.5, length_ratio)
        load = length_ratio**2 * 0.5 * math.sqrt(math.pi**2 * 0.75 + 4.0) / (2.0 * 0.75**2)
        return 1.0 - 1.0 / (2.0 * math.pi * film.sommerfeld * load)

    assert remainder(0.1) > 0.0
    assert remainder(0.2) / remainder(0.1) == pytest.approx(4.0, rel=0.25)


def test_a_centred_journal_moves_square_to_the_load():
    """ε → 0: φ → 90° for the short bearing.  A long one keeps part of the film beyond the narrowest place, and falls
    short of it."""
    assert math.degrees(solve_film(0.02, 0.1).attitude) == pytest.approx(90.0, abs=2.0)
    attitudes = [solve_film(0.02, length_ratio).attitude for length_ratio in (0.1, 0.5, 1.0, 2.0, math.inf)]
    assert attitudes == sorted(attitudes, reverse=True)


@pytest.mark.parametrize("length_ratio", [0.1, 0.5, 2.0, math.inf])
def test_a_centred_journal_rubs_as_petroff_says(length_ratio):
    """f* → 2π²·S  (N. P. Petroff 1883)."""
    film = solve_film(0.02, length_ratio)
    assert film.friction == pytest.approx(2.0 * math.pi**2 * film.sommerfeld, rel=3e-3)


def test_more_load_means_thinner_film():
    numbers = [solve_film(eccentricity, 0.5).sommerfeld for eccentricity in np.linspace(0.02, 0.98, 25)]
    assert all(after < before for before, after in pairwise(numbers))


@pytest.mark.parametrize(
    "eccentricity, length_ratio", [(0.02, 2.0), (0.6, 0.5), (0.98, 0.1), (0.98, 2.0), (0.3, math.inf)]
)
def test_finer_grids_change_little(eccentricity, length_ratio):
    usual, fine = (as_row(solve_film(eccentricity, length_ratio, cells=cells)) for cells in ((192, 16), (384, 32)))
    assert usual == pytest.approx(fine, rel=1e-4)


@pytest.mark.parametrize("eccentricity, length_ratio", [(0.1, 0.5), (0.6, 0.46), (0.9, 0.3), (0.98, 0.5), (0.3, 1.7)])
def test_finer_grids_change_the_radial_damping_little(eccentricity, length_ratio):
    usual, fine, finest = (
        radial_damping(eccentricity, length_ratio, cells=cells) for cells in ((192, 16), (384, 32), (768, 64))
    )
    assert usual == pytest.approx(finest, rel=1e-3)
    assert fine == pytest.approx(finest, rel=5e-4)


def test_a_centred_journal_is_damped_all_round_alike():
    """Along the eccentricity as across it, 2·sin φ/ε over the load, for the short bearing; the longer it is the
    less."""
    film = solve_film(0.02, 0.1)
    across = 2.0 * math.sin(film.attitude) / 0.02
    assert 2.0 * math.pi * film.sommerfeld * radial_damping(0.02, 0.1, cells=(384, 32)) == pytest.approx(
        across, rel=0.05
    )


@pytest.mark.parametrize("length_ratio", [0.3, math.inf])
def test_pressure_is_zero_at_the_ends_and_never_below(length_ratio):
    film = solve_film(0.7, length_ratio)
    assert film.theta[0] == 0.0 and film.theta[-1] == pytest.approx(2.0 * math.pi)
    assert np.all(np.diff(film.theta) > 0.0) and film.theta.shape == film.pressure.shape
    assert film.pressure[0] == film.pressure[-1] == 0.0 and film.pressure.min() == 0.0
    assert 0.5 * math.pi < film.theta[film.pressure.argmax()] < math.pi


@pytest.mark.parametrize(
    "eccentricity, length_ratio, words",
    [
        (0.01, 0.5, ("eccentricity", "0.01", "0.02 to 0.98")),
        (0.99, 0.5, ("eccentricity", "0.99", "0.02 to 0.98")),
        (math.nan, 0.5, ("eccentricity", "nan")),
        (0.5, 0.05, ("l/d", "0.05", "0.1 to 2")),
        (0.5, 3.0, ("l/d", "3", "0.1 to 2")),
        (0.5, -math.inf, ("l/d", "-inf", "0.1 to 2")),
    ],
)
def test_outside_the_range(eccentricity, length_ratio, words):
    with pytest.raises(ValueError) as caught:
        solve_film(eccentricity, length_ratio)
    assert all(word in str(caught.value) for word in words)


def test_cells_must_halve_twice():
    with pytest.raises(ValueError, match="multiples of 4"):
        solve_film(0.5, 0.5, cells=(190, 16))


# --- a journal that slopes in its seat
@pytest.mark.parametrize("eps, ld", [(0.3, 0.5), (0.8, 0.46), (0.95, 1.0)])
def test_a_journal_without_slope_is_the_parallel_one(eps, ld):
    parallel, film = solve_film(eps, ld), solve_misaligned(eps, 0.0, ld)
    assert film.sommerfeld == pytest.approx(parallel.sommerfeld, rel=2e-3)
    assert film.pressure_along.max() == pytest.approx(parallel.pressure_along.max(), rel=1e-3)


def test_slope_carries_more_at_the_same_middle_and_its_pressure_moves_to_the_edge():
    films = [solve_misaligned(0.8, tilt, 0.46) for tilt in (0.0, 0.05, 0.1, 0.15)]
    assert all(more.sommerfeld < less.sommerfeld for less, more in pairwise(films))
    places = [film.z[film.pressure_along.argmax()] for film in films]
    assert places == sorted(places) and places[0] == 0 and places[-1] > 0.6
    mirrored = solve_misaligned(0.8, -0.15, 0.46)
    assert np.allclose(mirrored.pressure_along[::-1], films[-1].pressure_along, rtol=1e-9)


def test_a_short_bearing_that_slopes_is_solved_by_quadrature():
    """l/d small: (h³·Π')' = 6·(l/d)²·∂h/∂θ across, at each angle an integral over z; the pressure's own flow around is
    3 % here."""
    eps, tilt, ld, z = 0.5, 0.2, 0.1, np.linspace(-1, 1, 2001)
    peaks = []
    for theta in np.linspace(2.0, 3.0, 201):
        h = 1 + (eps + tilt * z) * math.cos(theta)

        def across(f, h=h):
            return np.append(0.0, np.cumsum((f / h**3)[1:] + (f / h**3)[:-1]) * (z[1] - z[0]) / 2)

        driven, free = across(-6 * ld**2 * math.sin(theta) * (eps * z + tilt * z**2 / 2)), across(np.ones_like(z))
        peaks.append(driven - free * driven[-1] / free[-1])
    exact = max(peaks, key=lambda p: p.max())
    film = solve_misaligned(eps, tilt, ld)
    assert film.pressure_along.max() == pytest.approx(exact.max(), rel=0.04)
    assert film.z[film.pressure_along.argmax()] == pytest.approx(z[exact.argmax()], abs=0.1)


@pytest.mark.parametrize("eps, tilt", [(0.1, 0.2), (0.9, 0.1)])
def test_a_slope_beyond_the_range_is_refused(eps, tilt):
    with pytest.raises(ValueError, match="slopes"):
        solve_misaligned(eps, tilt, 0.5)
