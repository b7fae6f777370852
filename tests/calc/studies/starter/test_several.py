# SPDX-License-Identifier: Apache-2.0
"""Bearings of several shafts to begin with: which oil and clearance are taken, and which needles."""

from types import SimpleNamespace

import pytest

from calc.bearings.rolling.sizes import size_of
from calc.design.toml_file import Document, design
from calc.solve import solve
from calc.studies.starter import build, rolling, several
from calc.studies.starter.journals import OILS, PSI

SOLVED = []


def answers(oil, psi):
    """Power falls with a thinner oil and a wider clearance; narrow ones of the thinnest oil alone hold beside the thick
    oil."""
    thin = OILS.index(oil)
    holds = (thin == 0 and psi < 1.9e-3) or (thin == 2 and psi < 1.2e-3)
    return 100 - 30 * thin - 1e4 * psi, 0 if holds else 1


@pytest.fixture
def faked(monkeypatch):
    SOLVED.clear()

    def solved(tried, *_, **__):
        SOLVED.append(tried)
        power, worse = answers(*tried)
        bearing = SimpleNamespace(friction_power=power)
        view = SimpleNamespace(result=lambda _: SimpleNamespace(bearings={"front": bearing}))
        outcome = SimpleNamespace(checks=[SimpleNamespace(kind="caution", open=True)] * worse, verdict="pass")
        return SimpleNamespace(outcomes={"countershaft": outcome, "bearings": outcome}, views={"left": view})

    monkeypatch.setattr(several, "solve", solved)
    monkeypatch.setattr(several, "design", lambda tried: tried)
    monkeypatch.setattr(several, "judged_document", lambda document, made, oil, psi: (oil, psi))
    return SimpleNamespace(design=SimpleNamespace(friction=None))


def test_of_those_without_a_caution_the_least_friction_is_taken(faked):
    worse, power, taken = several._best(None, faked, OILS)
    assert (worse, taken) == (0, (OILS[2], PSI[0])) and power == pytest.approx(30)
    assert (OILS[0], PSI[0]) not in SOLVED, "narrower ones of an oil than one that holds lose more"


def test_for_a_core_it_is_enough_that_one_holds(faked):
    assert several._best(None, faked, OILS, first=True)[2] == (OILS[0], PSI[2])
    assert len(SOLVED) == 2


FOUR = {
    "name": "own four",
    "layout": "inline",
    "cylinders": 4,
    "strokes": 4,
    "firing_order": [1, 3, 4, 2],
    "bore_mm": 75.0,
    "crank_radius_mm": 45.25,
    "rod_length_mm": 140.0,
    "cylinder_pitch_mm": 84.0,
    "piston_mass_g": 320.0,
    "rod_mass_g": 430.0,
    "rated_speed_rpm": 6000.0,
    "rated_power_kW": 95.0,
}


def pair(speed: float, masses: float) -> Document:
    """With the shafts that its second order calls for."""
    own = FOUR | {"rated_speed_rpm": speed}
    own |= {key: masses * FOUR[key] for key in ("piston_mass_g", "rod_mass_g")}
    return build.built(Document({"schema": 1, "name": "own", "engine": own}), "countershaft", "second")


@pytest.fixture
def quick(monkeypatch):
    """Of the journals of plain bearings, which come first, few are tried, and one core for needles."""
    monkeypatch.setattr(several, "JOURNALS", (0.03, 0.032))
    monkeypatch.setattr(rolling, "BORES", (0.04,))


def on_needles(document: Document) -> tuple[list, list[str]]:
    """The rows that the rules give it, and the limits that fail with them, or of which nothing is known."""
    results = solve(design(build.built(document, "bearings", "needle")))
    fails = [c.id for c in results.checks() if c.kind == "limit" and c.verdict in ("fail", "not_verified")]
    assert {results.outcomes[step].verdict for step in ("countershaft", "bearings")} <= {"pass", "warn"}
    return results.design.rows, fails


def test_where_no_needles_with_rings_live_long_enough_wider_ones_roll_on_the_shaft(quick):
    """At 6000 rpm every NA lives too short, or its cage turns too fast."""
    rows, fails = on_needles(pair(6000.0, 1.0))
    assert fails == [] and len(rows) == 2
    for row in rows:
        size = size_of(row.size)
        assert size.type == "cage" and row.split_cage and row.outer_ring_held == "insert"
        assert size.bore <= 0.04 and row.case_depth >= 0.078 * (size.outside - size.bore) / 2


@pytest.mark.slow
@pytest.mark.parametrize("speed", [5000.0, 5500.0, 6000.0, 6500.0])
@pytest.mark.parametrize("masses", [0.85, 1.0, 1.15])
def test_needles_carry_the_pair_of_an_own_four(speed, masses):
    document = pair(speed, masses)
    rows, fails = on_needles(document)
    assert fails == [] and {size_of(row.size).type for row in rows} <= {"needle", "cage"}


def test_where_no_needles_do_the_sentence_says_how_long_they_live(quick, monkeypatch):
    """In words, without keys of a design file; and nothing else is then built in their place unasked."""
    monkeypatch.setattr(rolling, "listed_cages", lambda: (size_of("K25x30x17"),))
    document = pair(6000.0, 1.0)
    made, why = build.all_built(document, {"bearings": "needle"})
    said = str(why)
    assert made.data == document.data
    assert "front" in said and "K25x30x17" in said and "of the 5000 h" in said and "[" not in said
