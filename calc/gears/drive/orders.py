# SPDX-License-Identifier: Apache-2.0
"""Orders of the meshes on the crank, where they whine, and by how much the load alone makes their transmission uneven.

No level of sound: that is the housing's.  All meshes of one gear chain have one order."""

from collections.abc import Iterator, Mapping

from ...sheet.formula import formula
from ...sheet.quantity import dotted
from ...sheet.step import Table
from ...sheet.text import Amount, Name, Text, listed
from ...sheet.units import Hertz, Metre, NewtonPerMetre, Number, Pascal, RevPerSecond
from ...sheet.value import untraced
from ..inputs import GearsInputs
from ..rating.result import Influence
from ..result import TrainResult
from .result import MeshOverSpeed

HARMONICS = (1, 2, 3)


@formula(
    "o_Z",
    "kinematics: teeth that come into mesh in a turn of the crank",
    names={"i": "i_1"},
    meanings={"i": "Turns of the driver in a turn of the crank"},
)
def mesh_order(z: Number, i: Number) -> Number:
    """`z`: teeth of the driver, `i`: its turns in a turn of the crank.

    >>> mesh_order(z=25, i=1.0)
    25.0
    """
    return z * i


@formula(
    "f_Z",
    "definition: a harmonic of the mesh, of so many to a turn of the crank",
    unit="Hz",
    names={"k": "k_Z", "o": "o_Z", "n": "n_C"},
)
def mesh_frequency(k: Number, o: Number, n: RevPerSecond) -> Hertz:
    """`k`: harmonic, `n`: speed of the crank.

    >>> mesh_frequency(k=1, o=25, n=15.0)
    375.0
    """
    return k * o * n


@formula(
    "Δ_F",
    "ISO 6336-1 and elasticity: by its mesh stiffness two pairs of a spur mesh are 1.75 times as stiff as one; what "
    "the load bends them by, from one pair to two",
    unit="µm",
    names={"c": "c'"},
)
def error_by_load(w: NewtonPerMetre, c: Pascal) -> Metre:
    """Peak to peak, spur gears below ε_α = 2; `c`: single stiffness at this load.

    >>> error_by_load(w=20e3, c=7.57e9) * 1e6
    1.132289...
    """
    return 3 / 7 * w / c


def orders_table(
    train: TrainResult,
    found: Mapping[str, MeshOverSpeed],
    idle: RevPerSecond,
    rated: RevPerSecond,
    cylinders: int | None = None,
    strokes: int = 4,
) -> Table:
    """Every order with its harmonics at two speeds of the crank, the firings of an engine beside; meshes of one order
    stand in one row."""
    by_order: dict[float, list[str]] = {}
    for key, mesh in found.items():
        by_order.setdefault(round(float(mesh.order), 9), []).append(train.meshes[key].title)
    whats: list[tuple[Text, float]] = [(Name(", ".join(titles)), order) for order, titles in by_order.items()]
    if cylinders is not None:
        whats.append((Text("firing"), 2 * cylinders / strokes))
    with untraced():
        rows = tuple(
            (what, k, k * order, mesh_frequency(k=k, o=order, n=idle), mesh_frequency(k=k, o=order, n=rated))
            for what, order in whats
            for k in HARMONICS
        )
    return Table(
        "gear_orders",
        Text("Orders of the meshes on the crank"),
        ((Text("what"), ""), (Text("harmonic"), ""), (Text("order"), ""), (Text("idle"), "Hz"), (Text("rated"), "Hz")),
        rows,
        Text("Where a harmonic meets a frequency of the structure it can be heard; its level is not computed."),
        tuple(dotted("gears", key, MeshOverSpeed.order) for key in found),
    )


def notes(
    gears: GearsInputs, train: TrainResult, found: Mapping[str, MeshOverSpeed], influences: Mapping[str, Influence]
) -> Iterator[Text]:
    """What the error by load means beside what the flanks are made to, both along the line of action."""
    helical = [Name(train.meshes[key].title) for key in found if train.meshes[key].overlap_ratio > 0]
    if helical:
        yield Text(
            "Transmission error by load of {pairs}: the overlap of helical teeth makes it less than that of spur ones; "
            "it is not computed.",
            pairs=listed(helical),
        )
    for key, order in found.items():
        if (error := order.error_by_load) is not None:
            f_pb = influences[key].base_pitch_deviation
            yield Text(
                "Transmission of {pair}: the load makes {error} peak to peak, and grade {grade} lets the base pitch "
                "deviate by {pitch}: {rules}.",
                pair=train.meshes[key].title,
                error=Amount(error * 1e6, "µm", digits=2),
                grade=Amount(gears.accuracy_grade, form="g"),
                pitch=Amount(f_pb * 1e6, "µm", digits=2),
                rules=Text("the grade rules") if f_pb >= error else Text("the load rules"),
            )
