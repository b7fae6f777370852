# SPDX-License-Identifier: Apache-2.0
"""Pairs and trains to test with, as the gear step would hand them over."""

import json
import math
import tomllib
from dataclasses import replace
from pathlib import Path

from calc.friction.inputs import FrictionInputs
from calc.friction.mesh.film import oil_at
from calc.friction.mesh.geometry import MeshGeometry, WheelGeometry
from calc.friction.power_balance import End, drive
from calc.friction.solve import closed as closed_train
from calc.library.catalogue import oils
from calc.library.lubricant import Lubricant
from calc.sheet.value import trace

REFERENCE = Path(__file__).parents[2] / "reference"
RECORDED = Path(__file__).parents[2] / "recorded"

SHAFT_POWER = 277.65  # W, both bearings of the counter-shaft
CRANK_SPEED = 2600 / 60


def reference(name):
    return tomllib.loads((REFERENCE / name).read_text(encoding="utf-8"))


def recorded(name):
    return json.loads((RECORDED / name).read_text(encoding="utf-8"))


class Fixed:
    """A counter-shaft whose loss is known, whatever its gear does."""

    def __init__(self, P_B):
        self.P_B = P_B

    def journals(self, P, loads):
        return {}

    def sum(self, journals):
        return self.P_B


def ends(P_B, meshes):
    """A shaft that loses so much, on the last wheel of these meshes."""
    last = list(meshes.values())[-1].driven.name if meshes else ""
    return {"shaft": End(last, Fixed(P_B))}


def friction(**said):
    return FrictionInputs(**{"flank_roughness": (0.8e-6,), **said})


def lubricant(name="10W-40 Q8 T905"):
    return Lubricant(oils()[name])


def oil(name, T):
    """An oil as a mesh sees it, at the temperature of the teeth."""
    return oil_at(lubricant(name), T)


def wheel(name, z, m_t, alpha_t, tip_radius, b, E=206e9):
    r = m_t * z / 2
    return WheelGeometry(name, z, r, r * math.cos(alpha_t), tip_radius, b, E, 0.3)


def spur_pair():
    """The spur pair of the gear friction thesis; its tips are assumed: r_a = r + m·(1 + X/2 + k), X the sum of the
    shifts."""
    m, alpha, z, X = 2.31e-3, 0.3146, (38, 76), 0.44808
    involute = math.tan(alpha) - alpha + 2 * math.tan(alpha) * X / sum(z)
    alpha_w = alpha
    for _ in range(60):
        alpha_w -= (math.tan(alpha_w) - alpha_w - involute) / math.tan(alpha_w) ** 2
    a_w = m * sum(z) / 2 * math.cos(alpha) / math.cos(alpha_w)
    k = (a_w - m * sum(z) / 2) / m - X
    tips = [m * n / 2 + m * (1 + X / 2 + k) for n in z]
    pinion, gear = (
        wheel("pinion", z[0], m, alpha, tips[0], 30e-3, 219e9),
        wheel("gear", z[1], m, alpha, tips[1], 23e-3, 219e9),
    )
    return MeshGeometry(pinion, gear, a_w, 0.0)


def fzg(b=14e-3, tips=(41.23e-3, 59.18e-3)):
    """The FZG test gears of type C (z 16/24, m 4.5 mm, 91.5 mm)."""
    alpha = math.radians(20)
    return MeshGeometry(
        wheel("pinion", 16, 4.5e-3, alpha, tips[0], b), wheel("gear", 24, 4.5e-3, alpha, tips[1], b), 91.5e-3, 0.0
    )


def inv(angle):
    return math.tan(angle) - angle


def r753():
    """The train of the R753IE4's counter-shaft, 25-36-39-25; the crank wheel is that of the shaft."""
    m_n, alpha_n, beta, b = 2e-3, math.radians(20), math.radians(21.916), 15e-3
    m_t, alpha_t = m_n / math.cos(beta), math.atan(math.tan(alpha_n) / math.cos(beta))
    beta_b = math.asin(math.sin(beta) * math.cos(alpha_n))

    def shift_sum(z, a_w):
        return z * (inv(math.acos(m_t * z / 2 * math.cos(alpha_t) / a_w)) - inv(alpha_t)) / (2 * math.tan(alpha_n))

    x_shaft = shift_sum(64, 68.698e-3) - (shift_sum(75, 80.555e-3) - 0.014)
    tip = m_t * 25 / 2 + m_n * (1 + x_shaft)
    wheels = [
        wheel(name, z, m_t, alpha_t, r_a, b)
        for name, z, r_a in (
            ("crank", 25, tip),
            ("central", 36, 81.665e-3 / 2),
            ("idler", 39, 87.052e-3 / 2),
            ("shaft", 25, tip),
        )
    ]
    meshes = [
        MeshGeometry(one, two, a_w, beta_b)
        for one, two, a_w in zip(wheels, wheels[1:], (65.808e-3, 80.555e-3, 68.698e-3))
    ]
    return {mesh.name: mesh for mesh in meshes}


def closed(shaft_power=SHAFT_POWER, speed=CRANK_SPEED, T=120.0, meshes=None, power=None, oil="10W-40 Q8 T905", **said):
    """The closed train of the R753IE4, unless other meshes are given."""
    meshes = r753() if meshes is None else meshes
    shafts = {} if shaft_power is None else ends(shaft_power, meshes)
    with trace() as lines:
        d = drive(friction(**said), meshes, lubricant(oil), T, speed, shafts)
    found = closed_train(d, power)
    return replace(found, lines=(*lines, *found.lines))


def shown(outcome):
    """The values of an outcome by their address, in the units in which they are shown."""
    return {v.id.removeprefix("friction."): v.shown for v in outcome.values()}
