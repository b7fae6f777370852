"""Gear trains to test with, in the units of a drawing."""

import math
import tomllib
from pathlib import Path

from calc.gears.inputs import GearsInputs, Mesh
from calc.gears.solve import geometry
from calc.gears.wheel_inputs import Wheel

REFERENCE = Path(__file__).parents[2] / "reference"
SPEED = 2600 / 60


def reference(name):
    return tomllib.loads((REFERENCE / name).read_text(encoding="utf-8"))


def wheel(name, teeth, x=None, *, cut=0.0, span=None, allowance=None, **more):
    allowance = None if allowance is None else tuple(e * 1e-6 for e in allowance)
    said = dict(profile_shift=x, tip_shortening=cut * 1e-3, span_teeth=span, span_allowance=allowance)
    return Wheel(name=name, teeth=teeth, **said, **more)


def mesh(driver, driven, a=None, *, tolerance=None, contributors=None):
    return Mesh(
        driver=driver,
        driven=driven,
        centre_distance=None if a is None else a * 1e-3,
        tolerance=None if tolerance is None else tolerance * 1e-6,
        contributors=None if contributors is None else tuple(c * 1e-3 for c in contributors),
    )


def train(wheels, meshes, *, m_n=2.0, alpha_n=20.0, beta=21.916, b=15.0, tool=(1.41, 0.2), ball=3.5, edition=2006):
    return GearsInputs(
        source_sheet="finotti",
        normal_module=m_n * 1e-3,
        pressure_angle=math.radians(alpha_n),
        helix_angle=math.radians(beta),
        face_width=b * 1e-3,
        tool_addendum=tool[0],
        tool_tip_radius=tool[1],
        ball_diameter=None if ball is None else ball * 1e-3,
        iso_6336_edition=edition,
        wheels=tuple(wheels),
        meshes=tuple(meshes),
    )


def pair_1(cut=0.2, allowances=((-2, -20), (-20, -30)), span=(5, 6), **said):
    """The source's first pair: the central idler drives the idler."""
    central = wheel("central", 36, 0.014, span=span[0], allowance=allowances[0])
    idler = wheel("idler", 39, cut=cut, span=span[1], allowance=allowances[1])
    return train([central, idler], [mesh("central", "idler", 80.555, tolerance=55)], **said)


def r753(**said):
    """The whole train of the source's design; what it does not give is left open."""
    wheels = (
        wheel("crank", 25, allowance=(-20, -30)),
        wheel("central", 36, 0.014, span=5, allowance=(-2, -20)),
        wheel("idler", 39, cut=0.2, span=5, allowance=(-20, -30)),
        wheel("shaft", 25, allowance=(-20, -30)),
    )
    meshes = (
        mesh("crank", "central"),
        mesh("central", "idler", 80.555, tolerance=55),
        mesh("idler", "shaft", 68.698, tolerance=55),
    )
    return train(wheels, meshes, **said)


def solved(gears):
    return geometry(gears, SPEED).result


def shown(outcome):
    """The values of an outcome by their address, in the units in which they are shown."""
    return {v.id.removeprefix("gears."): v.shown for v in outcome.values()}
