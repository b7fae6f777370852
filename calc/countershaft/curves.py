# SPDX-License-Identifier: Apache-2.0
"""The figures of a shaft: what its bearings carry, and how it bends; of all shafts together what they leave, vector by
vector and one tooth off."""

from collections.abc import Sequence

import numpy as np

from ..draw.shaft_outline import outline_curve
from ..sheet.arrays import Array
from ..sheet.step import Curve, DrawnLoad, Series, Turning, axis_label
from ..sheet.text import EMPTY, Name, Text
from ..sheet.units import Metre, Newton, RadPerSecond
from .bending.shaft import Bending
from .result import CountershaftResult
from .rows import called
from .sums import OrderVectors, SystemShaft, TeethOff

STACK = "bending"


def curves(shaft: CountershaftResult, omega: RadPerSecond, positions: tuple[Metre, ...]) -> tuple[Curve, ...]:
    """All figures of a shaft but those of its making; `omega` of the crank at rated speed, `positions` of the
    bearings."""
    outline = (outline_curve(shaft.outline, positions),) if shaft.outline is not None else ()
    bent = _bent(shaft.bending, positions) if shaft.bending is not None else ()
    if shaft.bending is not None and outline:
        bent = (_loaded(outline[0], shaft.bending, positions, _carried(shaft)), *bent)
    return (*bent, *outline, _reactions(shaft, omega))


def speeds(omega: RadPerSecond) -> tuple[Array, Array]:
    """Crank speeds up to a tenth above rated [rpm], and the square of their ratio to it, by which all inertia forces
    grow."""
    share = np.linspace(0.0, 1.1, 45)
    return share * omega * 30 / np.pi, share**2


def _carried(shaft: CountershaftResult) -> list[tuple[Text, Newton]]:
    """The bearings, front to rear, each with what turns on it."""
    if shaft.support:
        return [(Name(name), support.reaction) for name, support in shaft.support.items()]
    return [(called(row), load) for row, load in shaft.loads.items()]


def _reactions(shaft: CountershaftResult, omega: RadPerSecond) -> Curve:
    """What turns with the shaft, on each of its bearings."""
    rpm, square = speeds(omega)
    series = tuple(Series(name, rpm, load * square) for name, load in _carried(shaft))
    title = Text("Reactions of the bearings over the speed range, the turning part")
    return Curve("reactions", title, axis_label("crank speed", "rpm"), axis_label("reaction", "N"), series)


def _loaded(outline: Curve, bent: Bending, positions: tuple[Metre, ...], carried: list[tuple[Text, Newton]]) -> Curve:
    """The shaft with the resultants of its centrifugal load and what its bearings hold against them, in the plane of
    its couple.

    `carried`: by each bearing, as the tables have it; the bent shaft gives its direction.  (Its own reactions are a
    little larger, as it is thrown outwards while it bends.)
    """
    along = np.cos(np.angle(np.asarray(bent.reactions)) - bent.plane)
    held = zip(positions, (along * [load for _, load in carried]).tolist())
    loads = [DrawnLoad(Text("load"), z * 1e3, F) for z, F in bent.loads] + [
        DrawnLoad(Text("bearing"), z * 1e3, F, held=True) for z, F in held
    ]
    title = Text("The shaft at rated speed: centrifugal load and reactions, shear, bending moment, deflection")
    return Curve(
        "loads",
        title,
        outline.x_label,
        outline.y_label,
        outline.series,
        stack=STACK,
        loads=tuple(loads),
        load_unit="N",
        short=1,
    )


def _bent(bent: Bending, positions: tuple[Metre, ...]) -> tuple[Curve, ...]:
    """Shear, bending moment and deflection line, in the plane of the shaft's couple."""
    z, from_middle = bent.z * 1e3, axis_label("from mid-shaft", "mm")
    lines = (
        Series(Text("with the stiffness share of the sectors"), z, bent.deflection * 1e6),
        Series(Text("at full stiffness"), z, bent.deflection_stiff * 1e6),
        Series(Text("bearings"), np.array(positions) * 1e3, np.zeros(len(positions))),
    )
    shear, moment = Text("Shear force of the shaft at rated speed"), Text("Bending moment of the shaft at rated speed")
    deflection, at = Text("Deflection line of the shaft at rated speed"), bent.largest_moment_z
    largest = float(np.interp(at, bent.moment_z, bent.moment))
    return (
        Curve(
            "shear_force",
            shear,
            from_middle,
            axis_label("shear", "N"),
            (Series(EMPTY, bent.shear_z * 1e3, bent.shear),),
            stack=STACK,
            short=2,
        ),
        Curve(
            "moment",
            moment,
            from_middle,
            axis_label("moment", "N·m"),
            (Series(EMPTY, bent.moment_z * 1e3, bent.moment),),
            point=(at * 1e3, largest),
            stack=STACK,
            short=3,
        ),
        Curve("deflection", deflection, from_middle, axis_label("deflection", "µm"), lines, stack=STACK, short=4),
    )


# --- of all shafts together


def phasor_plane(n: int, unit: str, engine: OrderVectors, shafts: Sequence[SystemShaft]) -> Curve:
    """The vectors of order n, of force or couple (`unit`), tip to tail: the engine's and each shaft's; what is left is
    where they end, which runs along a circle.  Those that turn with the crank, and those that turn against it."""
    force, degrees = unit == "N", np.arange(0, 361, 3.0)
    series, chains = [], []
    for sense, at, words in ((1, 0, Text("with the crank")), (-1, 1, Text("against it"))):
        vectors = {Text("engine"): (engine.forces if force else engine.couples)[at]}
        for shaft in shafts:
            if shaft.ratio == sense * n:
                vectors[Name(shaft.name)] = shaft.force if force else shaft.couple
        if vectors := {name: vector for name, vector in vectors.items() if vector}:
            turned = abs(sum(vectors.values())) * np.exp(1j * np.radians(degrees))
            series.append(Series(Text("left"), turned.imag, turned.real, words))
            chains.append(Turning(tuple(vectors), tuple(vectors.values()), (sense * n,) * len(vectors), words))
    title = Text("Forces of order {n}, engine and shafts tip to tail", n=n)
    return Curve(
        f"phasors_order_{n}_{'force' if force else 'couple'}",
        title if force else Text("Couples of order {n}, engine and shafts tip to tail", n=n),
        Text("horizontal, {unit}", unit=unit),
        Text("vertical, {unit}", unit=unit),
        tuple(series),
        equal=True,
        variants=tuple(chain.variant for chain in chains),
        turning=tuple(chains),
        along=(Text("crank angle, °"), degrees / n),
    )


def teeth_bars(n: int, unit: str, teeth: TeethOff, designed: float) -> Curve:
    """What of order n is left with shafts one tooth off, late beside early, of force or couple (`unit`), its peak over
    a turn; the line: as `designed`."""
    force = unit == "N"
    rows = [
        (words, off.columns[n][0] if force else off.columns[n][1]) for words, off in teeth.rows() if n in off.columns
    ]
    place = np.arange(1, len(rows) + 1, dtype=float)
    title = Text("Force of order {n} left one tooth off", n=n)
    return Curve(
        f"teeth_off_order_{n}_{'force' if force else 'couple'}",
        title if force else Text("Couple of order {n} left one tooth off", n=n),
        Text("one tooth off"),
        axis_label("force" if force else "couple", unit),
        tuple(
            Series(words, place, np.array([peaks[i] for _, peaks in rows]))
            for i, words in enumerate((Text("late"), Text("early")))
        ),
        limits=((Text("as designed"), designed),),
        bars=True,
        names=tuple(words for words, _ in rows),
    )
