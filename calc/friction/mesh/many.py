# SPDX-License-Identifier: Apache-2.0
"""The loss of one mesh at any number of operating points at once.

Speed, power and oil temperature may be arrays, and so are the results then.  They are solved some hundred at a time, which keeps the
arrays in the processor's cache and the memory small however many there are.
"""

from dataclasses import replace

import numpy as np

from ...library.lubricant import Lubricant
from ...sheet.arrays import each
from ...sheet.errors import NoSolution
from ...sheet.text import Amount, Text
from ...sheet.trace import untraced
from ...sheet.units import Celsius, RevPerSecond, Watt
from ..inputs import FrictionInputs
from .film import oil_at
from .geometry import MeshGeometry, column
from .loss import MeshLoss, case, solve_mesh

AT_ONCE = 500
COLDEST, HOTTEST = -60.0, 400.0  # °C
SPUR_POINTS, HELICAL_POINTS, STRIPS = 12, 2, 5  # some 50 positions of a spur path, 125 of a helical one


def losses(
    friction: FrictionInputs, mesh: MeshGeometry, lubricant: Lubricant, T: Celsius, n_1: RevPerSecond, P: Watt, *, by_regime: bool = True,
    points: int = 0, strips: int = STRIPS,
) -> MeshLoss:  # fmt: skip
    """The loss where the teeth have the temperature T [°C], the driver turns at n_1 [1/s] and takes in the power P [W].

    One number each or arrays of one length.  `by_regime`: False takes the friction source's model.  `points`: of each piece of the path,
    4 pieces on a spur path; with those left out a spur loss is right to 1e-6, a helical one to 2e-3, and where the regime changes on the
    path to 4e-3 and 2e-2.  NoSolution names the operating point and the place on the path where the temperature of the film does not
    settle, or the quantity that has no meaning.
    """
    T_all, n_all, P_all = np.broadcast_arrays(*(np.atleast_1d(np.asarray(x, dtype=np.float64)) for x in (T, n_1, P)))
    points = points or (SPUR_POINTS if mesh.spur else HELICAL_POINTS)
    if not np.all((T_all > COLDEST) & (T_all < HOTTEST)):  # NaN is not
        wrong = float(T_all[~((T_all > COLDEST) & (T_all < HOTTEST))][0])
        raise NoSolution(
            Text("mesh {title}: temperature of the teeth", title=mesh.title),
            Text("is {wrong} °C", wrong=Amount(wrong, form="g")),
            Text("a temperature of a liquid oil is needed"),
        )
    friction = replace(friction, bulk="oil")  # the teeth have the temperature that is asked for
    parts = []
    with untraced(), np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        for start in range(0, P_all.size, AT_ONCE):
            some = slice(start, start + AT_ONCE)
            T, n_1, P = (each(x[some]) for x in (T_all, n_all, P_all))
            c = case(friction, mesh, oil_at(lubricant, column(T)), n_1, points=points, strips=strips)
            try:
                parts.append(solve_mesh(c, P, by_regime))
            except NoSolution as none:
                among = Text("{tried} (counted from operating point {start})", tried=none.tried, start=start) if start else none.tried
                raise NoSolution(none.what, among, none.advice) from None
    return _joined(parts)


def _joined(parts: list[MeshLoss]) -> MeshLoss:
    """Results one after the other; a loss that none of some points has is one number for them all."""
    first, locals_ = parts[0], [part.local for part in parts]
    columns = {key: each(np.concatenate([getattr(part, key) for part in locals_])) for key in vars(first.local) if key != "x"}
    found = {
        name: each(np.concatenate([np.broadcast_to(getattr(part, name), np.shape(part.load)) for part in parts]))
        for name, value in vars(first).items()
        if name != "local" and value is not None
    }
    return replace(first, local=replace(first.local, **columns), **found)
