# SPDX-License-Identifier: Apache-2.0
"""Tables and curves of solved friction: where the power goes, the models side by side, the oil, and what happens along the path."""

from collections.abc import Iterator

import numpy as np

from .. import oils
from ..bearings.inputs import IN_WORDS
from ..sheet.step import Curve, Series, Table, axis_label
from ..sheet.text import EMPTY, Amount, Text
from .balance.closure import Drive
from .models import compared
from .result import FrictionResult, MeshResult, by_regime


# --- tables ----------------------------------------------------------------------------------------------------------------
def tables(result: FrictionResult, d: Drive) -> tuple[Table, ...]:
    """Where the power goes; the models of every mesh; what is known of the oil."""
    models = (
        compared.table(name, mesh.case.mesh.title, by_regime(mesh), mesh.source, mesh.ohlendorf_loss_factor, mesh.published_models)
        for name, mesh in result.meshes.items()
    )
    printed = oils.printed_table(d.lubricant)
    return (_where(result), *models, oils.values_table(d.lubricant.oil), *(() if printed is None else (printed,)))


def _where(r: FrictionResult) -> Table:
    """The balance, from the first driver to the end of the train."""
    rows: list[tuple[str | float | None, ...]] = [(name, P, P / r.total_loss * 100) for name, P in _parts(r)]
    rows.append((Text("all losses"), r.total_loss, 100.0))
    left_out = sum(mesh.judged.rolling_estimate or 0.0 for mesh in r.meshes.values())
    note = (
        Text("Not counted: rolling of EHL films, by Goksem and Hargreaves about {left_out} W.", left_out=Amount(left_out))
        if left_out
        else EMPTY
    )
    return Table("balance", Text("Where the power goes"), ((Text("Loss"), ""), (Text("P"), "W"), (Text("share"), "%")), tuple(rows), note)


def _parts(r: FrictionResult) -> list[tuple[Text, float]]:
    """Every loss by its name."""
    found: list[tuple[Text, float | None]] = []
    for mesh in r.meshes.values():
        m, title = mesh.judged, mesh.case.mesh.title
        found += [
            (Text("mesh {title}, sliding", title=title), m.sliding_loss),
            (Text("mesh {title}, rolling (bound)", title=title), m.rolling_loss or None),
        ]
    found += [(Text("journal {place} of the counter-shaft", place=IN_WORDS[place]), j.friction_power) for place, j in r.journals.items()]
    found += [
        (Text("windage"), r.windage_loss), (Text("churning"), r.churning_loss), (Text("oil thrown onto wheels"), r.thrown_oil_loss),
        (Text("shaft seals"), r.seal_loss), (Text("bearings of the wheels"), r.wheel_bearing_loss),
        (Text("other losses"), r.other_loss or None),
    ]  # fmt: skip
    return [(name, P) for name, P in found if P is not None]


# --- curves ----------------------------------------------------------------------------------------------------------------
def curves(result: FrictionResult) -> tuple[Curve, ...]:
    names, powers = zip(*_parts(result))
    labels = Text(", ").join(f"{i} {name}" for i, name in enumerate(names, 1))
    places = np.arange(1.0, len(names) + 1)
    bars = Curve(
        "losses",
        Text("Where the power goes"),
        labels,
        axis_label("P", "W"),
        (Series(Text("loss"), places, np.array(powers)),),
        bars=True,
        names=names,
    )
    return (bars, *(c for name, mesh in result.meshes.items() for c in _curves(name, mesh)))


def way(mesh: MeshResult) -> Text:
    """The label of the path, with its points."""
    letters = "ABCDE" if mesh.case.mesh.spur else "ACE"
    marks = ", ".join(f"{letter} {x * 1e3:.2f}" for letter, x in zip("ABCDE", mesh.case.path.marks) if letter in letters)
    return Text("x from T₁, mm ({marks})", marks=marks)


def _curves(name: str, mesh: MeshResult) -> Iterator[Curve]:
    """Along the path in the middle of the face, judged and by the other model."""
    title, x_label = Text("Mesh {title}", title=mesh.case.mesh.title), way(mesh)
    models = ((Text("by regime"), mesh.by_regime or mesh.judged), (Text("source: EHL everywhere"), mesh.source))

    def lines(quantity: str, factor: float = 1.0) -> tuple[Series, ...]:
        return tuple(Series(label, np.asarray(m.local.x) * 1e3, m.local.drawn(quantity) * factor) for label, m in models)

    roughness = ((Text("combined roughness"), mesh.case.surfaces.sigma * 1e6),)
    yield Curve(
        f"{name}.friction", Text("{title}: coefficient of friction along the line of action", title=title), x_label, Text("μ"), lines("mu")
    )
    yield Curve(
        f"{name}.film",
        Text("{title}: film along the line of action", title=title),
        x_label,
        axis_label("h", "µm"),
        lines("h", 1e6),
        roughness,
    )
    yield Curve(
        f"{name}.heat",
        Text("{title}: loss along the line of action", title=title),
        x_label,
        axis_label("q", "W/mm of contact line"),
        lines("q", 1e-3),
    )
    yield Curve(
        f"{name}.temperature",
        Text("{title}: film temperature along the line of action", title=title),
        x_label,
        axis_label("T_f", "°C"),
        lines("T_f"),
    )
