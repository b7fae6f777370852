"""Shafts of the reference data (tests/data/shafts.json, from oracles of their own), in SI, and what is given of them."""

import json
import math

import pytest

from calc import countershaft
from calc.countershaft.inputs import EccentricMass
from calc.countershaft.outline import Piece
from calc.library.catalogue import Material
from tests.conftest import ROOT

DATA = json.loads((ROOT / "tests" / "data" / "shafts.json").read_text(encoding="utf-8"))
SHARE, STANDING = DATA["parameters"]["share"], DATA["parameters"]["standing"]
UNITS = {"N": 1.0, "mrad": 1e-3, "µm": 1e-6, "N/µm": 1e6, "°": math.pi / 180, "W": 1.0, "": 1.0}


def material(case):
    return Material(name="steel", E=case["E_GPa"] * 1e9, poisson=case["nu"], density=case["rho"], expansion=11e-6)


def pieces(case):
    made = []
    for start, end, R, *more in case["pieces"]:
        r_0, half, angle = more or (0.0, None, 0.0)
        half = None if half is None else math.radians(half)
        what = "full" if half is None else "sector"
        made.append(Piece(start / 1e3, end / 1e3, R / 1e3, r_0 / 1e3, half, math.radians(angle), what))
    return tuple(made)


def points(case):
    return tuple(
        EccentricMass(name=f"point at {z}", mass=m, radius=e / 1e3, angle=math.radians(angle), z=z / 1e3)
        for z, m, e, angle in case.get("points", ())
    )


def supports(case):
    return tuple(z / 1e3 for z in case["supports_mm"])


def turning(case):
    omega = 2 * math.pi * case["speed_rpm"] / 60
    return countershaft.condensed(
        pieces(case), supports(case), omega, material(case), points(case), case.get("eta", 1.0)
    )


def still(case, wheel=None):
    return countershaft.at_rest(pieces(case), supports(case), material(case), points(case), case.get("eta", 1.0), wheel)


def given(name):
    """(value, in SI, as pytest compares it with that tolerance)."""
    rows = [row for row in DATA["given"] if row["case"] == name]
    assert rows, name
    for row in rows:
        unit = UNITS[row["unit"]]
        near = {"rel": row["rel"], "abs": 0.0} if "rel" in row else {"rel": 0.0, "abs": row["abs"] * unit}
        yield row["value"], pytest.approx(row["is"] * unit, **near)


def compared(name, found):
    """All that is given of a case is found and agrees."""
    wrong = {value: (found[value], wanted) for value, wanted in given(name) if not found[value] == wanted}
    assert wrong == {}
