# SPDX-License-Identifier: Apache-2.0
"""Trains as the given values have them, and plain ones to try."""

import json
import math
from functools import cache

import numpy as np

from calc.gears.drive.motion import Bodies, Motion
from tests.calc.gears.trains import REFERENCE


@cache
def golden():
    return json.loads((REFERENCE / "drive.json").read_text(encoding="utf-8"))["given"]


def given_of(case):
    """The parameters of a case, in the units of the file."""
    return next(row["given"] for row in golden() if row["case"] == case and "see" not in row["given"])


def lane(given):
    """(motion of one point, bodies) of a case that gives the motion of its driver."""
    a = np.array(given["a_re"]) + 1j * np.array(given["a_im"])
    motion = Motion(np.array(given["orders"]), a[None], np.array([given["omega"]]), 2 * math.pi * given["strokes"] / 2)
    return motion, train(
        parent=given["parent"],
        rho=given["radius_ratio"],
        mass=given["mass_kg"],
        drag=[given["drag_N"]],
        backlash=np.array(given["backlash_um"]) * 1e-6,
        width=np.array(given["face_width_mm"]) * 1e-3,
        stiffness=np.array(given["c_gamma_100_GPa"]) * 1e9,
    )


def train(parent=(-1,), mass=(1.0,), drag=((1.0,),), backlash=(70e-6,), **said):
    """Wheels of 12 mm and 16 GPa on radii of one size, where nothing else is said."""
    B = len(parent)
    said = dict(rho=np.ones(B), toothed=(True,) * B, width=np.full(B, 12e-3), stiffness=np.full(B, 16e9)) | said
    arrays = dict(mass=mass, drag=drag, backlash=backlash, rho=said.pop("rho"))
    return Bodies(parent=tuple(parent), **{name: np.array(of, float) for name, of in arrays.items()}, **said)


def motion(a, orders=(2.0,), omega=80.0, cycle=4 * math.pi):
    """Of the points in the rows of `a`, m/s²."""
    a = np.atleast_2d(np.array(a, complex))
    return Motion(np.array(orders), a, np.broadcast_to(np.asarray(omega, float), a.shape[:1]), cycle)
