# SPDX-License-Identifier: Apache-2.0
"""Trains on the engine of the R753, as far as the drive asks: by an irregularity that is given, or by its gas."""

from dataclasses import replace
from functools import cache

from calc.design.operations import operations
from calc.design.toml_file import design, read
from calc.engine import solve as engine
from calc.gears.drive.inputs import DragRow, DriveInputs
from calc.gears.drive.line import ShaftBody
from calc.gears.drive.solve import over_speed
from calc.gears.drive.source import CrankAtWork
from calc.library.catalogue import materials
from tests.calc.gears.trains import r753, solved
from tests.conftest import DESIGNS

IDLE = 15.0  # 1/s


@cache
def r753_engine(flywheel=None):
    """Inputs and result; with a flywheel it has gas too, that of the design of its mounts."""
    inputs = replace(mounted().engine, flywheel_inertia=flywheel)
    if flywheel is None:
        inputs = replace(inputs, gas=None)
    return inputs, engine.solve(inputs, materials()).solution


@cache
def mounted():
    return design(read(DESIGNS / "r753ie4_mounting.toml"))


def on_shaft(J, with_wheel=True, **said):
    """A shaft of this inertia on the wheel "shaft"."""
    return {"shaft": ShaftBody(J=J, with_wheel=with_wheel, **said)}


def work(shafts, flywheel=None, **said):
    inputs, e = r753_engine(flywheel)
    rows = () if flywheel is None else operations(inputs, mounted().mounting)
    known = dict(rows=rows, idle=IDLE, ratio=1.0, front=None, shafts=shafts, friction=None) | said
    return CrankAtWork(engine=inputs, e=e, **known)


def with_drag(gears, *rows):
    """With measured drags: wheel, rpm, N·m."""
    said = tuple(DragRow(wheel=wheel, speed=rpm / 60, torque=T) for wheel, rpm, T in rows)
    return replace(gears, drive=DriveInputs(drag=said))


def driven(shafts, gears=None, delta=0.02, order=1.5, **said):
    """The drive of a train by an irregularity at rated speed; by gas or default where `delta` is None."""
    gears = replace(r753() if gears is None else gears, speed_irregularity=delta, irregularity_order=order)
    return over_speed(gears, solved(gears), work(shafts, **said), materials())
