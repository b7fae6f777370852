# SPDX-License-Identifier: Apache-2.0
"""Bearings of several shafts to begin with: which oil and clearance are taken."""

from types import SimpleNamespace

import pytest

from calc.studies.starter import several
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
