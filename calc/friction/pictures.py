# SPDX-License-Identifier: Apache-2.0
"""Tables and curves of solved friction: where the power goes, the models side by side, the oil, and what happens along the path."""

from collections.abc import Iterator

import numpy as np

from .. import oils
from ..sheet.number import short
from ..sheet.step import Curve, Series, Table
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
    rows.append(("all losses", r.total_loss, 100.0))
    left_out = sum(mesh.judged.rolling_estimate or 0.0 for mesh in r.meshes.values())
    note = f"Not counted: rolling of EHL films, by Goksem and Hargreaves about {short(left_out)} W." if left_out else ""
    return Table("balance", "Where the power goes", (("Loss", ""), ("P", "W"), ("share", "%")), tuple(rows), note)


def _parts(r: FrictionResult) -> list[tuple[str, float]]:
    """Every loss by its name."""
    found: list[tuple[str, float | None]] = []
    for mesh in r.meshes.values():
        m, title = mesh.judged, mesh.case.mesh.title
        found += [(f"mesh {title}, sliding", m.sliding_loss), (f"mesh {title}, rolling (bound)", m.rolling_loss or None)]
    found += [(f"journal {place} of the counter-shaft", j.friction_power) for place, j in r.journals.items()]
    found += [
        ("windage", r.windage_loss), ("churning", r.churning_loss), ("oil thrown onto wheels", r.thrown_oil_loss),
        ("shaft seals", r.seal_loss), ("bearings of the wheels", r.wheel_bearing_loss), ("other losses", r.other_loss or None),
    ]  # fmt: skip
    return [(name, P) for name, P in found if P is not None]


# --- curves ----------------------------------------------------------------------------------------------------------------
def curves(result: FrictionResult) -> tuple[Curve, ...]:
    names, powers = zip(*_parts(result))
    labels = ", ".join(f"{i} {name}" for i, name in enumerate(names, 1))
    places = np.arange(1.0, len(names) + 1)
    bars = Curve("losses", "Where the power goes", labels, "P, W", (Series("loss", places, np.array(powers)),), bars=True, names=names)
    return (bars, *(c for name, mesh in result.meshes.items() for c in _curves(name, mesh)))


def way(mesh: MeshResult) -> str:
    """The label of the path, with its points."""
    letters = "ABCDE" if mesh.case.mesh.spur else "ACE"
    marks = ", ".join(f"{letter} {x * 1e3:.2f}" for letter, x in zip("ABCDE", mesh.case.path.marks) if letter in letters)
    return f"x from T₁, mm ({marks})"


def _curves(name: str, mesh: MeshResult) -> Iterator[Curve]:
    """Along the path in the middle of the face, judged and by the other model."""
    title, x_label = f"Mesh {mesh.case.mesh.title}", way(mesh)
    models = (("by regime", mesh.by_regime or mesh.judged), ("source: EHL everywhere", mesh.source))

    def lines(quantity: str, factor: float = 1.0) -> tuple[Series, ...]:
        return tuple(Series(label, np.asarray(m.local.x) * 1e3, m.local.drawn(quantity) * factor) for label, m in models)

    roughness = (("combined roughness", mesh.case.surfaces.sigma * 1e6),)
    yield Curve(f"{name}.friction", f"{title}: coefficient of friction along the line of action", x_label, "μ", lines("mu"))
    yield Curve(f"{name}.film", f"{title}: film along the line of action", x_label, "h, µm", lines("h", 1e6), roughness)
    yield Curve(f"{name}.heat", f"{title}: loss along the line of action", x_label, "q, W/mm of contact line", lines("q", 1e-3))
    yield Curve(f"{name}.temperature", f"{title}: film temperature along the line of action", x_label, "T_f, °C", lines("T_f"))
