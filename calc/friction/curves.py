# SPDX-License-Identifier: Apache-2.0
"""Tables and curves of solved friction: where the power goes, the models side by side, the oil, what happens along the
path, and over λ."""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from ..countershaft.rows import called
from ..library import oils
from ..sheet.errors import NoSolution
from ..sheet.functions import pi
from ..sheet.record import replace
from ..sheet.step import Curve, Series, Table, axis_label
from ..sheet.text import EMPTY, Amount, Name, Text
from . import models as loss_models
from .mesh.loss import solve_mesh
from .mesh.mixed import MIXED
from .mesh.path import motion
from .mesh.traction import eyring_stress, roelands_index, slope_under_pressure
from .power_balance import Hung, TrainDrive
from .result import FrictionResult, MeshResult, by_regime

# --- tables


def tables(result: FrictionResult, d: TrainDrive) -> tuple[Table, ...]:
    """Where the power goes; the models of every mesh; what is known of the oil."""
    models = (
        loss_models.table(
            name, mesh.case.mesh.title, by_regime(mesh), mesh.source, mesh.ohlendorf_loss_factor, mesh.published_models
        )
        for name, mesh in result.meshes.items()
        if mesh.source is not None
    )
    printed = oils.printed_table(d.lubricant)
    return (
        _where(result, d.hung),
        *models,
        oils.values_table(d.lubricant.oil),
        *(() if printed is None else (printed,)),
    )


def _where(r: FrictionResult, hung: tuple[Hung, ...]) -> Table:
    """The balance, from the first driver to the end of the train, and what hangs on the shafts."""
    rows: list[tuple[str | float | None, ...]] = [(name, P, P / r.total_loss * 100) for name, P in _parts(r)]
    rows.append((Text("all losses"), r.total_loss, 100.0))
    rows += [(Text("carried and not lost: {name}", name=Name(load.name)), load.power, None) for load in hung]
    left_out, note = sum(mesh.judged.rolling_estimate or 0.0 for mesh in r.meshes.values()), EMPTY
    if left_out:
        rolling = Amount(left_out)
        note = Text("Not counted: rolling of EHL films, by Goksem and Hargreaves about {left_out} W.", left_out=rolling)
    columns = ((Text("Loss"), ""), (Text("P"), "W"), (Text("share"), "%"))
    return Table("balance", Text("Where the power goes"), columns, tuple(rows), note)


def _parts(r: FrictionResult) -> list[tuple[Text, float]]:
    """Every loss by its name."""
    losses: list[tuple[Text, float | None]] = []
    for mesh in r.meshes.values():
        m, title = mesh.judged, mesh.case.mesh.title
        losses += [
            (Text("mesh {title}, sliding", title=title), m.sliding_loss),
            (Text("mesh {title}, rolling (bound)", title=title), m.rolling_loss or None),
        ]
    losses += [(Text("chain or belt {name}", name=name), stage.loss) for name, stage in r.stages.items()]
    for shaft, journals in r.journals.items():
        whose = Name(shaft) if len(r.journals) > 1 else Text("the counter-shaft")
        losses += [
            (Text("journal {place} of {shaft}", place=called(place), shaft=whose), j.friction_power)
            for place, j in journals.items()
        ]
    if (masses := r.masses) is not None:
        between = dict(low=Amount(masses.mass_loss_low), high=Amount(masses.mass_loss_high))
        losses.append((Text("turning masses, of {low} to {high} W", **between), masses.mass_loss))
    losses += [
        (Text("windage"), r.windage_loss),
        (Text("churning"), r.churning_loss),
        (Text("oil thrown onto wheels"), r.thrown_oil_loss),
        (Text("shaft seals"), r.seal_loss),
        (Text("bearings of the wheels"), r.wheel_bearing_loss),
        (Text("other losses"), r.other_loss or None),
    ]
    return [(name, P) for name, P in losses if P is not None]


# --- curves


def curves(result: FrictionResult, d: TrainDrive) -> tuple[Curve, ...]:
    names, powers = zip(*_parts(result))
    labels = Text(", ").join(f"{i} {name}" for i, name in enumerate(names, 1))
    losses = Series(Text("loss"), np.arange(1.0, len(names) + 1), np.array(powers))
    title, P = Text("Where the power goes"), axis_label("P", "W")
    bars = Curve("losses", title, labels, P, (losses,), bars=True, names=names)
    of_meshes = (c for name, mesh in result.meshes.items() for c in (*_curves(name, mesh), *_stribeck(name, mesh)))
    return bars, *of_meshes, *((_shear(d),) if d.cases else ())


def way(mesh: MeshResult) -> Text:
    """The label of the path, with its points."""
    letters = "ABCDE" if mesh.case.mesh.spur else "ACE"
    marks = ", ".join(
        f"{letter} {x * 1e3:.2f}" for letter, x in zip("ABCDE", mesh.case.path.marks) if letter in letters
    )
    return Text("x from T₁, mm ({marks})", marks=marks)


def _curves(name: str, mesh: MeshResult) -> Iterator[Curve]:
    """Along the path in the middle of the face, judged and by the other model."""
    title, x_label = Text("Mesh {title}", title=mesh.case.mesh.title), way(mesh)
    models = ((Text("by regime"), by_regime(mesh)), (Text("source: EHL everywhere"), mesh.source))

    def lines(quantity: str, factor: float = 1.0) -> tuple[Series, ...]:
        there = [(label, model.local) for label, model in models if model is not None]
        return tuple(Series(label, np.asarray(local.x) * 1e3, local.drawn(quantity) * factor) for label, local in there)

    heading = Text("{title}: coefficient of friction along the line of action", title=title)
    yield Curve(f"{name}.friction", heading, x_label, Text("μ"), lines("mu"))
    heading = Text("{title}: film along the line of action", title=title)
    roughness = ((Text("combined roughness"), mesh.case.surfaces.sigma * 1e6),)
    yield Curve(f"{name}.film", heading, x_label, axis_label("h", "µm"), lines("h", 1e6), roughness)
    heading = Text("{title}: loss along the line of action", title=title)
    yield Curve(f"{name}.heat", heading, x_label, axis_label("q", "W/mm of contact line"), lines("q", 1e-3))
    heading = Text("{title}: film temperature along the line of action", title=title)
    yield Curve(f"{name}.temperature", heading, x_label, axis_label("T_f", "°C"), lines("T_f"))
    heading = Text("{title}: Deborah number along the line of action", title=title)
    logarithms = tuple(replace(line, y=np.log10(line.y)) for line in lines("De"))
    limit = ((Text("Eyring's law holds below"), 0.0),)
    yield Curve(f"{name}.deborah", heading, x_label, Text("lg De"), logarithms, limit)


PACES = np.geomspace(1 / 64, 4.0, 33)  # of the speed of the design


def _stribeck(name: str, mesh: MeshResult) -> Iterator[Curve]:
    """Mean friction over λ at the torque of the design, slower and faster; none where a film gets too hot."""
    c, m = mesh.case, mesh.judged
    try:
        at = replace(c, motion=motion(c.mesh, c.path, PACES * c.motion.omega_1 / (2 * pi)))
        sweep = solve_mesh(at, PACES * m.load, mesh.by_regime is None)
    except NoSolution:
        return
    at_speeds, designed = Text("torque of the design, other speeds"), Text("as designed")
    lines = (
        Series(at_speeds, np.log10(sweep.lambda_min), np.asarray(sweep.friction_mean)),
        Series(designed, np.log10([m.lambda_min]), np.array([m.friction_mean])),
    )
    boundary, full = (Amount(math.log10(lam), form=".2f") for lam in MIXED)
    over = Text(
        "lg of the smallest λ (boundary below {boundary}, full film above {full})", boundary=boundary, full=full
    )
    title = Text("Mesh {title}: mean friction over λ (Stribeck)", title=c.mesh.title)
    yield Curve(f"{name}.stribeck", title, over, Text("μ_m"), lines)


def _shear(d: TrainDrive) -> Curve:
    """What shear the oil bears: its limit, and the stress from which it thins, at some temperatures."""
    s, oil, p = next(iter(d.cases.values())).rubbing(d.friction.film == "judged"), d.oil, np.linspace(0.1e9, 2.0e9, 39)
    lines = [Series(Text("limit Λ·p"), p * 1e-9, oil.Lambda * p * 1e-6)]
    for T in (oil.T_m - 40, oil.T_m, oil.T_m + 40):
        eta = oil.lubricant.at(T).mu
        alpha: Any = oil.alpha_at(eta)
        if s.roelands and s.relieved:
            alpha = slope_under_pressure(alpha_f=alpha, Z=roelands_index(alpha_f=alpha, eta_f=eta), p_m=p)
        tau = eyring_stress(Lambda=oil.Lambda, alpha_f=alpha)
        label = Text("Eyring stress at {T}", T=Amount(T, "°C"))
        lines.append(Series(label, p * 1e-9, np.broadcast_to(tau, p.shape) * 1e-6))
    title = Text("Shear stress that the oil bears over pressure")
    return Curve("shear", title, axis_label("p", "GPa"), axis_label("τ", "MPa"), tuple(lines))
