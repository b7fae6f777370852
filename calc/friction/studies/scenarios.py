# SPDX-License-Identifier: Apache-2.0
"""The same train under other conditions, side by side: another oil, temperature, load sharing, roughness, power.

Each scenario is a whole balance of its own; what it does not say is that of the design.  Shown are the judged model and
the friction source's, mesh by mesh, in a table and in nine curves along the path of contact; those of one figure are
drawn together."""

from collections.abc import Iterator, Mapping
from itertools import product

import numpy as np

from ...bearings.inputs import BearingsInputs
from ...gears.inputs import GearsInputs
from ...library.catalogue import Oil
from ...library.lubricant import Lubricant
from ...sheet.errors import NoSolution
from ...sheet.quantity import dotted
from ...sheet.record import replace
from ...sheet.step import Curve, Series, Table, axis_label
from ...sheet.text import COMMA, EMPTY, Amount, Name, Text, listed
from ...sheet.units import Celsius, Watt
from ...sheet.value import untraced
from ..inputs import FrictionInputs, Scenario
from ..journals import OnShaft, journals_at
from ..mesh.loss import MeshLoss
from ..power_balance import TrainDrive, balance, drive, shaft_loss
from ..result import FrictionResult, ScenarioMesh, ScenarioResult

# What is drawn along the path: attribute of `Local`, title, label of the axis, factor.
ALONG = (
    ("V_s", Text("sliding speed"), axis_label("V_s", "m/s"), 1.0),
    ("w", Text("normal force per length of the contact line, as the pairs share it"), axis_label("w", "N/mm"), 1e-3),
    ("b_H", Text("half width of the contact"), axis_label("b_H", "µm"), 1e6),
    ("p_H", Text("Hertzian pressure"), axis_label("p_H", "MPa"), 1e-6),
    ("h", Text("film"), axis_label("h", "µm"), 1e6),
    ("lam", Text("film over roughness"), Text("λ"), 1.0),
    ("mu", Text("coefficient of friction"), Text("μ"), 1.0),
    ("T_f", Text("film temperature"), axis_label("T_f", "°C"), 1.0),
    ("q", Text("friction power"), axis_label("q", "W/mm of contact line"), 1e-3),
)

BEHIND = 2  # their first place among the figures of a short report: behind that of the open constants

# What is tabulated of every mesh: label and unit of the column, attribute of `MeshLoss`, factor.
TABULATED = (
    (Text("P_VZ"), "W", "loss", 1.0),
    (Text("sliding"), "W", "sliding_loss", 1.0),
    (Text("rolling"), "W", "rolling_loss", 1.0),
    (Text("η_Z"), "%", "efficiency", 100.0),
    (Text("μ_m"), "", "friction_mean", 1.0),
    (Text("H_VL"), "", "loss_factor", 1.0),
    (Text("h_min"), "µm", "film_min", 1e6),
    (Text("λ_min"), "", "lambda_min", 1.0),
    (Text("p_H"), "MPa", "pressure_max", 1e-6),
    (Text("T_f max"), "°C", "temperature_max", 1.0),
)


def solved(
    d: TrainDrive,
    friction: FrictionInputs,
    oils: Mapping[str, Oil],
    law: str,
    power: Watt | None,
    on: Mapping[str, OnShaft],
) -> dict[str, ScenarioResult]:
    """All scenarios of a design by their names.  NoSolution names the scenario that has none.

    Where the teeth have the oil of the journals, a scenario's oil and temperature are those of the journals too.
    """
    results: dict[str, ScenarioResult] = {}
    for scenario in friction.scenarios:
        try:
            with untraced():
                results[scenario.name] = _one(d, scenario, oils, law, power, on)
        except NoSolution as none:
            raise NoSolution(
                Text("scenario {name}: {what}", name=scenario.name, what=none.what), none.tried, none.advice
            ) from None
    return results


def _one(
    d: TrainDrive, s: Scenario, oils: Mapping[str, Oil], law: str, power: Watt | None, on: Mapping[str, OnShaft]
) -> ScenarioResult:
    ends, f = dict(d.ends), d.friction
    friction = replace(
        f,
        load_sharing=s.load_sharing or f.load_sharing,
        flank_roughness=s.flank_roughness or f.flank_roughness,
        bulk_temperature=f.bulk_temperature if s.oil_temperature is None else None,
    )
    name = s.oil or d.lubricant.oil.name
    T = d.T_oil if s.oil_temperature is None else s.oil_temperature
    lubricant = Lubricant(oils[name], law) if s.oil else d.lubricant
    shared = (s.oil_temperature is not None and f.oil_temperature is None, s.oil is not None and f.oil is None)
    for shaft in on if any(shared) else ():
        supply = T if shared[0] else next(iter(on[shaft].bearings.bearings.values())).supply_temperature
        ends[shaft] = replace(
            ends[shaft], journals=journals_at(on[shaft], 1.0, supply, lubricant if shared[1] else None)
        )
        if not np.isfinite(shaft_loss(ends[shaft].journals, None)):
            what, advice = (
                Text("friction of the counter-shaft's journals"),
                Text("another oil or temperature for this scenario"),
            )
            tried = Text(
                "with {name} supplied at {supply} °C a journal has no film in the range of its table",
                name=name,
                supply=Amount(supply, form="g"),
            )
            raise NoSolution(what, tried, advice)
    other = drive(friction, d.links, lubricant, T, d.wheels[d.first].speed, ends, d.forces, d.lubrication)
    r = balance(other, None if ends else s.power or power)
    meshes = {
        key: ScenarioMesh(judged=mesh.by_regime or mesh.judged, source=mesh.source) for key, mesh in r.meshes.items()
    }
    share = None if ends else r.total_loss / r.crank_power  # with a shaft all is loss
    return ScenarioResult(
        meshes=meshes,
        oil_viscosity=r.oil_viscosity,
        bearing_loss=r.bearing_loss,
        mass_loss=r.mass_loss,
        mesh_loss=r.mesh_loss,
        total_loss=r.total_loss,
        share=share,
        crank_torque=r.crank_torque,
        delivered_power=r.delivered_power,
        about=_conditions(s, name, T, friction),
        figure=s.figure or "",
        oil=name,
        temperature=T,
    )


def _conditions(s: Scenario, oil: str, T: Celsius, friction: FrictionInputs) -> Text:
    """Oil and temperature always, the rest where the scenario tells it."""
    conditions = [Name(oil), Text("{T}", T=Amount(T, "°C"))]
    if s.load_sharing is not None:
        conditions.append(Name(friction.load_sharing))
    if s.flank_roughness is not None:
        both = listed(Text("{Ra}", Ra=Amount(Ra * 1e6)) for Ra in s.flank_roughness)
        conditions.append(Text("Ra {both} µm", both=both))
    if s.power is not None:
        conditions.append(Text("{power}", power=Amount(s.power / 1e3, "kW")))
    return COMMA.join(conditions)


# --- shown

MODELS = (("judged", Text("by regime")), ("source", Text("source: EHL everywhere")))


def tables(result: FrictionResult) -> tuple[Table, ...]:
    """The whole balance; and one table a mesh and model: what the source tabulates, a row a scenario."""
    scenarios: dict[str, ScenarioResult] = result.scenarios or {}
    if not scenarios:
        return ()
    meshes = next(iter(scenarios.values())).meshes
    by_mesh = (_table(scenarios, key, model, words) for key in meshes for model, words in MODELS)
    return _balance(scenarios, result), *by_mesh


def _balance(scenarios: Mapping[str, ScenarioResult], design: FrictionResult) -> Table:
    """What each costs, the design first where no scenario is the same; columns that none has are left out."""
    columns = (
        (Text("Scenario"), ""),
        (Text("Conditions"), ""),
        (Text("journals"), "W"),
        (Text("meshes"), "W"),
        (Text("masses"), "W"),
        (Text("wheels"), "W"),
        (Text("all losses"), "W"),
        (Text("T_1"), "N·m"),
        (Text("delivered"), "W"),
    )
    rows: list[tuple[str | float | None, ...]] = []
    compared: list[tuple[str, str, ScenarioResult | FrictionResult]]
    compared = [(name, s.about, s) for name, s in scenarios.items()]
    if all(s.total_loss != design.total_loss for s in scenarios.values()):
        compared.insert(0, (Text("as designed"), "", design))
    for name, about, s in compared:
        wheels = s.total_loss - (s.mesh_loss or 0.0) - (s.bearing_loss or 0.0) - (s.mass_loss or 0.0)
        torque = s.crank_torque if s.delivered_power is None else None  # given, where the power is
        rows.append(
            (name, about, s.bearing_loss, s.mesh_loss, s.mass_loss, wheels, s.total_loss, torque, s.delivered_power)
        )
    title = Text("Scenarios: the whole balance, as judged")
    note = Text("wheels: windage, churning, seals and bearings of the wheels, other losses.")
    whole = Table("scenarios", title, columns, tuple(rows), note, covers=("friction.scenarios.",))
    return _narrowed(whole, [i for i in range(len(columns)) if any(row[i] is not None for row in rows)])


def as_design(friction: FrictionInputs, s: Scenario, shared: bool) -> dict[str, str | float | list[float] | None]:
    """The keys of the design, in the units of the file, that make a scenario of it.  `shared`: with [bearings], whose
    oil and temperature the teeth have too where the design says so."""
    changes: dict[str, str | float | list[float] | None] = {}
    if s.oil is not None:
        of_bearings, of_teeth = dotted("bearings", BearingsInputs.oil), dotted("friction", FrictionInputs.oil)
        changes[of_bearings if shared and friction.oil is None else of_teeth] = s.oil
    if s.oil_temperature is not None:
        if friction.bulk_temperature is not None:  # it was measured at another temperature
            changes[dotted("friction", FrictionInputs.bulk_temperature)] = None
        of_bearings = dotted("bearings", BearingsInputs.supply_temperature)
        of_teeth = dotted("friction", FrictionInputs.oil_temperature)
        changes[of_bearings if shared and friction.oil_temperature is None else of_teeth] = s.oil_temperature
    if s.load_sharing is not None:
        changes[dotted("friction", FrictionInputs.load_sharing)] = s.load_sharing
    if s.flank_roughness is not None:
        changes[dotted("friction", FrictionInputs.flank_roughness)] = [round(Ra * 1e6, 9) for Ra in s.flank_roughness]
    if s.power is not None:
        changes[dotted("gears", GearsInputs.power)] = s.power / 1e3
    return changes


def _table(scenarios: Mapping[str, ScenarioResult], key: str, model: str, words: Text) -> Table:
    """What differs stands in columns, what is the same in all scenarios in the note."""
    columns = (
        *((Text("Scenario"), ""), (Text("Oil"), ""), (Text("T_oil"), "°C"), (Text("η_0"), "mPa·s")),
        *((label, unit) for label, unit, _, _ in TABULATED),
    )
    rows: list[tuple[str | float | None, ...]] = []
    for name, s in scenarios.items():
        loss: MeshLoss = getattr(s.meshes[key], model)
        numbers = (getattr(loss, attribute) * factor for _, _, attribute, factor in TABULATED)
        rows.append((name, s.oil, s.temperature, s.oil_viscosity * 1e3, *numbers))
    same = [i for i in range(1, len(columns)) if len(rows) > 1 and all(row[i] == rows[0][i] for row in rows)]
    cells = [(*columns[i], rows[0][i]) for i in same]
    note = COMMA.join(
        Text("{label} {value}", label=label, value=Amount(cell, unit) if isinstance(cell, float) else cell or "")
        for label, unit, cell in cells
    )
    heading = Text("Scenarios, mesh {key}, {words}", key=key.replace("_", "–"), words=words)
    note = Text("The same in all: {note}.", note=note) if note else EMPTY
    whole = Table(f"scenarios_{key}_{model}", heading, columns, tuple(rows), note)
    return _narrowed(whole, [i for i in range(len(columns)) if i not in same])


def _narrowed(table: Table, kept: list[int]) -> Table:
    """The table with some of its columns."""
    rows = tuple(tuple(row[i] for i in kept) for row in table.rows)
    return replace(table, columns=tuple(table.columns[i] for i in kept), rows=rows)


def curves(scenarios: Mapping[str, ScenarioResult], marks: Mapping[str, Text]) -> Iterator[Curve]:
    """Nine curves a mesh and figure along its path, a line a scenario; both models as variants.  `marks`: the label of
    the path of each mesh."""
    meshes = next(iter(scenarios.values())).meshes if scenarios else {}
    figures = dict.fromkeys(s.figure for s in scenarios.values())
    for place, (key, figure, along) in enumerate(product(meshes, figures, ALONG), BEHIND):
        attribute, title, label, factor = along
        series = tuple(
            Series(Name(name), np.asarray(local.x) * 1e3, local.drawn(attribute) * factor, words)
            for model, words in MODELS
            for name, s in scenarios.items()
            if s.figure == figure
            for local in [getattr(s.meshes[key], model).local]
        )
        of = Text("{mesh}, {figure}", mesh=key.replace("_", "–"), figure=figure) if figure else key.replace("_", "–")
        heading = Text("Scenarios, mesh {key}: {title} along the path", key=of, title=title)
        variants = tuple(words for _, words in MODELS)
        number = f"_{list(figures).index(figure) + 1}" if figure else ""
        id = f"scenarios_{key}_{attribute}{number}"
        yield Curve(id, heading, marks[key], label, series, variants=variants, short=place)
