"""Balancing sheets of shafts that stand in words: the masses [kg, mm, °, mm], and what the table says."""

import math

from calc.countershaft.balancing.inputs import Balancing, BalancingHole, MachineReading
from calc.countershaft.balancing.solve import Made, sheet
from calc.countershaft.inputs import EccentricMass, Extra, ShaftInputs
from calc.countershaft.making.unbalance import permitted
from calc.countershaft.rows import BearingRow

GAMMA = ((2.691, 18.676, 210.0, -77.671), (2.688, 18.731, 30.0, 75.968))


def masses(rows, kind=EccentricMass):
    names = ("front", "rear", *map(str, range(3, 9)))
    return tuple(
        kind(name=name, mass=m, radius=e * 1e-3, angle=math.radians(phi), z=z * 1e-3)
        for name, (m, e, phi, z) in zip(names, rows)
    )


def shaft(rows=GAMMA, bearings=(-167.5, 167.5), ratio=-1, extras=(), **more):
    names = ["front", *(f"b{n}" for n in range(len(bearings) - 2)), "rear"]
    rows_of = tuple(BearingRow(name=name, position=z * 1e-3) for name, z in zip(names, bearings))
    return ShaftInputs(
        name="shaft",
        material="steel",
        speed_ratio=ratio,
        masses=masses(rows),
        extras=masses(extras, Extra),
        bearings=rows_of,
        **more,
    )


def tolerance(inputs, mass=9.03351012376, z_S=2.6525491920202, rpm=2600.0):
    omega = 2 * math.pi * rpm / 60 * abs(inputs.speed_ratio)
    z = inputs.bearing_positions
    return permitted("G6.3", mass, omega, z_S * 1e-3, z[0], z[-1], 0.0)


def sheet_of(inputs, table=None, per=None, R=0.0405, outline=None):
    per = tolerance(inputs) if per is None else per
    table = Balancing() if table is None else table
    return sheet(inputs, table, Made(inputs.masses, outline, R, 7860.0, 7860.0, per))


def hole(name, z, angle, diameter=14.0, depth=20.0, **more):
    size = dict(diameter=diameter * 1e-3, depth_max=depth * 1e-3, **more)
    return BalancingHole(name=name, z=z * 1e-3, angle=math.radians(angle), **size)


def reading(serial, front, rear, kind="residual"):
    """Of unbalances in g·mm at angles in degrees."""
    (a, alpha), (b, beta) = front, rear
    ends = dict(front=a * 1e-6, front_=math.radians(alpha), rear=b * 1e-6, rear_=math.radians(beta))
    return MachineReading(serial=serial, kind=kind, **ends)
