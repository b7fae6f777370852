# SPDX-License-Identifier: Apache-2.0
"""Shafts on arrays against the same shafts solved by the step."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.countershaft.result import CountershaftResult
from calc.design.toml_file import design, read
from calc.solve import solve
from calc.studies.drive.classes import drive_of
from calc.studies.drive.shafts import journal_mass, journal_slopes, shafts
from tests.conftest import DESIGNS

# no fixture: a failure would print it whole
SIZED = read(DESIGNS / "r753ie4_sized.toml").with_value("shafts.shaft.fillet_radius_mm", 1.5)
SIZES = st.fixed_dictionaries(
    {
        "core": st.floats(12, 22),
        "seat": st.floats(84, 90),
        "other": st.floats(58.5, 84),
        "l_f": st.floats(20, 44),
        "l_r": st.floats(20, 44),
        "eta": st.sampled_from([0.1, 0.2, 1.0]),
        "off": st.floats(-3, 3),
        "front_is_seat": st.booleans(),
    }
)


def _solved(x):
    """The sized design with these sizes, its shaft alone, and what its arrays are made of."""
    d_f, d_r = (x["seat"], x["other"]) if x["front_is_seat"] else (x["other"], x["seat"])
    z = (-167.5 + x["off"], 167.5 + x["off"])
    half = min(abs(z[0]) - x["l_f"] / 2, abs(z[1]) - x["l_r"] / 2) - 3.0
    document = SIZED
    for key, value in {
        "shafts.shaft.core_radius_mm": x["core"],
        "shafts.shaft.outer_radius_mm": x["seat"] / 2 - 0.2,
        "shafts.shaft.half_length_mm": half,
        "shafts.shaft.sector_effectiveness": x["eta"],
        "countershaft.bearing_positions_mm": list(z),
        "shafts.shaft.bearings.front.diameter_mm": d_f,
        "shafts.shaft.bearings.rear.diameter_mm": d_r,
        "shafts.shaft.bearings.front.length_mm": x["l_f"],
        "shafts.shaft.bearings.rear.length_mm": x["l_r"],
    }.items():
        document = document.with_value(key, value)
    made = design(document)
    return made, solve(made, enough=lambda outcome: outcome.key == "countershaft"), (d_f * 1e-3, d_r * 1e-3)


@settings(max_examples=25, deadline=None)
@given(SIZES)
def test_slopes_and_mass_are_those_of_the_step(x):
    made, results, (d_f, d_r) = _solved(x)
    solved = results.result(CountershaftResult)
    if solved is None or not solved.slopes:  # the envelope is too small, or the pieces cross
        return
    drive = drive_of(made, results)
    l_f, l_r = np.array([x["l_f"] * 1e-3]), np.array([x["l_r"] * 1e-3])
    found = shafts(drive, np.array([x["core"] * 1e-3]), (l_f, l_r), max(d_f, d_r))
    own = [journal_slopes(drive, n, d, l) for n, (d, l) in enumerate(((d_f, l_f), (d_r, l_r)))]
    mass = float(found.mass[0, 0, 0] + journal_mass(drive, d_f, l_f)[0] + journal_mass(drive, d_r, l_r)[0])
    slopes = [float(found.slopes[n][0, 0, 0] + own[0][n][0] + own[1][n][0]) for n in (0, 1)]
    assert found.fits[0, 0, 0]
    for n, (still, turning) in enumerate(zip(slopes, solved.slopes.values(), strict=True)):
        # what the mass adds or takes as it turns: -0.6 to 2.9 % at the corners of these sizes
        assert -0.01 < still / turning - 1 < 0.03
        assert turning <= drive.turning(n, mass, still) * (1 + 1e-9)  # which the tables take
    # both look for the least mass, whose bottom is flat: 1.6e-7 apart where the shaft is far from its middle (off 1.74)
    assert mass == pytest.approx(solved.mass, rel=5e-7)
    assert found.face[0, 0, 0] == pytest.approx(made.countershaft.half_length, abs=1e-9)


def test_an_envelope_that_does_not_hold_the_couple_does_not_fit():
    made, results, _ = _solved(
        {"core": 14, "seat": 86, "other": 60, "l_f": 30, "l_r": 30, "eta": 0.2, "off": 0, "front_is_seat": False}
    )
    drive = drive_of(made, results)
    long = np.array([0.03, 0.12])  # a journal that leaves the sectors no room
    found = shafts(drive, np.array([0.014]), (np.array([0.03]), long), 0.086)
    assert found.fits[0, 0].tolist() == [True, False]
    assert drive.longest(1, 0.086 / 2 - drive.clearance, 0.014) < long[1]


def test_sectors_that_nearly_meet_are_closed_on_arrays_as_by_the_step():
    """An envelope that the couple fills but for 0.01 mm: the gap of half a millimetre that the least mass has would
    hold no fillets."""
    x = {"core": 14, "seat": 84, "other": 60, "l_f": 36.53, "l_r": 36.53, "eta": 0.2, "off": 0, "front_is_seat": False}
    made, results, (d_f, d_r) = _solved(x)
    solved = results.result(CountershaftResult)
    assert solved.sector_length == pytest.approx(made.countershaft.half_length, abs=1e-12)
    assert "countershaft.fillet_room" not in {c.id: c for c in results.checks() if c.margin < 0}
    drive, l = drive_of(made, results), np.array([36.53e-3])
    found = shafts(drive, np.array([0.014]), (l, l), d_r)
    assert found.fits[0, 0, 0]
    mass = found.mass[0, 0, 0] + journal_mass(drive, d_f, l)[0] + journal_mass(drive, d_r, l)[0]
    assert mass == pytest.approx(solved.mass, rel=1e-7)
    own = journal_slopes(drive, 0, d_f, l)[1][0] + journal_slopes(drive, 1, d_r, l)[1][0]
    assert found.slopes[1][0, 0, 0] + own == pytest.approx(solved.slopes["rear"], rel=0.02)
