# SPDX-License-Identifier: Apache-2.0
"""The friction step: the meshes of the train, the losses of all that turns, the closed power balance."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any, NamedTuple, overload

import numpy as np

from ..gears.inputs import GearsInputs
from ..gears.layout.forces import axis_forces
from ..gears.result import TrainResult
from ..library.catalogue import Material, Oil, materials, oils
from ..library.lubricant import Lubricant
from ..sheet.arguments import check_arguments, demand_alike, named
from ..sheet.arrays import Array, Num
from ..sheet.deferred import Later
from ..sheet.record import replace
from ..sheet.step import Curve, Further, Outcome, Table, finite
from ..sheet.text import Amount, Name, Text, listed
from ..sheet.units import Celsius, Metre, Newton, RevPerSecond, Watt
from ..sheet.value import about, based_on, trace, untraced
from . import checks, curves
from .inputs import FrictionInputs
from .journals import OnShaft, journals_of
from .mesh.film import oil_at
from .mesh.geometry import Link, MeshGeometry, Sprocket, StageGeometry, WheelGeometry
from .mesh.loss import MeshLoss, case, losses, solve_mesh
from .power_balance import Ends, Forces, TrainDrive, balance, drive, end_of
from .result import FrictionResult, bearing_share, engine_share, torque
from .studies import maps, scenarios, sensitivity

QUIET = partial(np.errstate, over="ignore", divide="ignore", invalid="ignore")  # what is not finite is refused

EXTREME = Text("power, speed, face width or flank roughness are far outside what the formulas are for: give usual ones")


def meshes_of(train: TrainResult, materials: Mapping[str, Material]) -> dict[str, MeshGeometry]:
    """The meshes of a train, with what friction needs of them."""
    wheels = {
        name: WheelGeometry(
            name=name,
            teeth=w.teeth,
            reference_radius=_half(w.pitch_diameter),
            base_radius=_half(w.base_diameter),
            tip_radius=_half(w.tip_diameter),
            face_width=w.face_width,
            E=materials[w.material].E,
            poisson=materials[w.material].poisson,
        )
        for name, w in train.wheels.items()
    }
    beta_b = train.system.base_helix_angle
    return {
        key: MeshGeometry(wheels[m.driver], wheels[m.driven], m.centre_distance, beta_b)
        for key, m in train.meshes.items()
    }


def links_of(gears: GearsInputs, train: TrainResult, materials: Mapping[str, Material]) -> dict[str, Link]:
    """The meshes, chains and belts of a train along the flow of power."""
    meshes, stages = meshes_of(train, materials), {stage.name: stage for stage in gears.stages}
    links: dict[str, Link] = {}
    for link in train.tree.links:
        if link.toothed:
            links[link.key] = meshes[link.key]
        else:
            ends = Sprocket(link.driver, link.z_1), Sprocket(link.driven, link.z_2)
            links[link.key] = StageGeometry(link.key, *ends, stages[link.key].efficiency)
    return links


def _half(diameter: Metre) -> Metre:
    return based_on(diameter / 2, diameter)


def forces_of(gears: GearsInputs, train: TrainResult) -> Forces:
    """The forces of the teeth on the axis of each wheel as the train stands, from powers of the meshes and speeds of
    the wheels."""
    return partial(_forces, gears, train)


def _forces(
    gears: GearsInputs, train: TrainResult, loads: Mapping[str, Watt], speeds: Mapping[str, RevPerSecond]
) -> Mapping[str, Newton]:
    torques = {key: torque(P=loads.get(key, 0.0), n=speeds[mesh.driver]) for key, mesh in train.meshes.items()}
    return axis_forces(gears, train, torques)


class MeshOil(NamedTuple):
    """The oil on the teeth, the law of its viscosity over temperature, and how hot it is there."""

    oil: Oil
    viscosity_law: str
    temperature: Celsius


def solve(
    friction: FrictionInputs,
    gears: GearsInputs,
    train: TrainResult,
    on: Mapping[str, OnShaft],
    first_speed: RevPerSecond,
    oil: MeshOil,
    materials: Mapping[str, Material],
    oils: Mapping[str, Oil],
    *,
    undriven: tuple[str, ...] = (),
    compared: bool = True,
) -> Outcome[FrictionResult]:
    """Losses of all meshes and the closed power balance.  `on`: the shafts by their names; none: a train alone, whose
    first driver's power is given.

    `undriven`: shafts that the train does not turn; `compared`: with the source's model beside the one that judges.
    """
    links = links_of(gears, train, materials)
    with QUIET(), trace() as lines:
        with about(Text("oil")):
            lubricant = Lubricant(oil.oil, oil.viscosity_law)
        ends = {name: end_of(friction, gears.carrier(name), shaft, journals_of(shaft)) for name, shaft in on.items()}
        forces, T, lubrication = forces_of(gears, train), oil.temperature, gears.lubrication
        d = drive(friction, links, lubricant, T, first_speed, ends, forces, lubrication, compared=compared)
    power = None if on else gears.power
    outcome = closed(d, power)
    result = replace(outcome.solution, drive=d, on=on)
    if friction.scenarios:
        with QUIET():
            result = replace(result, scenarios=scenarios.solved(d, friction, oils, oil.viscosity_law, power, on))
        finite(result, "friction", EXTREME)

    def notes() -> Iterator[Text]:
        for name, end in ends.items():
            yield from end.journals.notes(result.journals[name])
        yield from _notes(gears, bool(on))
        yield from _not_counted(friction, ends, undriven)

    return replace(
        outcome,
        result=result,
        lines=(*lines, *outcome.lines),
        notes=outcome.notes + Later(notes),
        further=partial(further, d, result, power, on),
        key_curves=Later(lambda: (*_open_constants(d, result, power)[0], *_side_by_side(result))),
    )


def closed(d: TrainDrive, power: Watt | None = None) -> Outcome[FrictionResult]:
    """The closed balance of a train, and what is to be said about it.

    `power`: what the first driver puts into its mesh, where no counter-shaft says what is needed.
    """
    with QUIET(), trace() as lines:
        result = balance(d, power)
    finite(result, "friction", EXTREME)
    with QUIET(), untraced():
        return checks.outcome(d, result, lines)


def with_rated_power(
    outcome: Outcome[FrictionResult], P_e: Watt | None, rolling: Callable[[], Watt | None]
) -> Outcome[FrictionResult]:
    """The same outcome with its losses as a share of the engine's rated power, where that is given.

    `rolling`: what rolling bearings would lose in the places of all."""
    if (result := outcome.result) is None or P_e is None:
        return outcome
    with trace() as lines, about(Text("train")):
        of_bearings = None
        if result.bearing_loss is not None:
            of_bearings = bearing_share(P_B=result.bearing_loss, P_e=P_e)
        result = replace(result, engine_share=engine_share(P=result.total_loss, P_e=P_e), bearing_share=of_bearings)
    outcome = replace(outcome, result=result, lines=(*outcome.lines, *lines))
    if of_bearings is None:
        return outcome
    judged = (*outcome.checks, checks.BEARING_SHARE(of_bearings, checks.MUCH))
    said = Later(lambda: _instead(result, rolling) if of_bearings > checks.MUCH else ())
    return replace(outcome, checks=judged, notes=outcome.notes + said)


def _instead(result: FrictionResult, rolling: Callable[[], Watt | None]) -> Iterator[Text]:
    with untraced():
        would = rolling()
    if would is not None and result.bearing_loss is not None and would < result.bearing_loss:
        yield Text(
            "The bearings of the shafts lose {P}; balls and rollers in their places would lose about {rolling} (an "
            "estimate: `choose FILE bearings`).",
            P=Amount(result.bearing_loss, "W", digits=3),
            rolling=Amount(would, "W", digits=2),
        )


def further(d: TrainDrive, result: FrictionResult, power: Watt | None, on: Mapping[str, OnShaft]) -> Further:
    """Maps, sensitivity and scenarios: what is asked for when it is shown."""
    with QUIET(), untraced():
        of_map, of_fuel, missing = maps.pictures(maps.over_speed_and_temperature(d, power, on), d)
        bars, table = _open_constants(d, result, power)
        return Further(
            curves=(*of_map, *bars, *_side_by_side(result)),
            tables=(*of_fuel, *table, *scenarios.tables(result)),
            notes=missing,
        )


def _side_by_side(result: FrictionResult) -> Iterator[Curve]:
    ways = {key: curves.way(mesh) for key, mesh in result.meshes.items()}
    return scenarios.curves(result.scenarios or {}, ways)


def _open_constants(
    d: TrainDrive, result: FrictionResult, power: Watt | None
) -> tuple[tuple[Curve, ...], tuple[Table, ...]]:
    """What the constants of meshes and mist change; nothing of chains alone."""
    if not d.cases:
        return (), ()
    with QUIET(), untraced():
        curve, table = sensitivity.tornado(sensitivity.swings(d, power, result.total_loss), result.total_loss)
    return (curve,), (table,)


def _notes(gears: GearsInputs, closed: bool) -> Iterator[Text]:
    """What the given power means."""
    if not closed:
        yield Text(
            "The power at the first driver is gears.power_kW, which its first mesh takes in, plus its own windage "
            "and other losses."
        )
    elif gears.power is not None:
        yield Text("gears.power_kW rates the teeth only; the losses are those of the closed balance.")


def _not_counted(friction: FrictionInputs, ends: Ends, undriven: tuple[str, ...]) -> Iterator[Text]:
    """Shafts without a wheel, and turning masses whose loss is asked and not known."""
    if undriven:
        yield Text(
            "No wheel of the train turns {shafts}: journals, turning masses and pumps there are not counted.",
            shafts=listed(map(Name, undriven)),
        )
    if friction.mass_loss == "none":
        return
    if not ends:
        yield Text("What the turning masses lose is not counted: without [bearings] the power is given.")
    lacking = [Name(name) for name, end in ends.items() if end.sectors is None]
    if lacking:
        yield Text(
            "What the turning masses of {shafts} lose is not counted: no outline with sectors is known.",
            shafts=listed(lacking),
        )


# --- from Python, in SI: `from calc import friction`


@overload
def solve_loss(  # type: ignore[overload-overlap]  # numbers give numbers, one array among them gives arrays
    pair: TrainResult,
    *,
    power: Watt,
    speed: RevPerSecond,
    oil: str | Oil,
    temperature: Celsius,
    flank_roughness: Metre = ...,
) -> MeshLoss[float]: ...
@overload
def solve_loss(
    pair: TrainResult, *, power: Num, speed: Num, oil: str | Oil, temperature: Num, flank_roughness: Metre = ...
) -> MeshLoss[Array]: ...
def solve_loss(
    pair: TrainResult,
    *,
    power: Any,
    speed: Any,
    oil: str | Oil,
    temperature: Any,
    flank_roughness: Metre = 0.8e-6,
) -> MeshLoss[Any]:
    """The loss of the first mesh of a train (`gears.solve_pair` makes one of two wheels), whose teeth have the oil's
    temperature.

    `power` into the driver [W], `speed` of the driver [revolutions per second], `temperature` [°C]: these three may be
    arrays of one length, an operating point each; then every value of the loss is an array of it.  `oil`: a name of the
    table, or an Oil.  `flank_roughness`: Ra of both flanks [m].  BadInput where an argument lies outside of the range
    that it has in a design file."""
    check_arguments(
        "solve_loss",
        power=(GearsInputs.power, power),
        speed=(GearsInputs.speed, speed),
        temperature=(FrictionInputs.oil_temperature, temperature),
        flank_roughness=(FrictionInputs.flank_roughness, flank_roughness),
    )
    demand_alike("solve_loss", power=power, speed=speed, temperature=temperature)
    mesh = next(iter(meshes_of(pair, materials()).values()))
    lubricant = Lubricant(oil if isinstance(oil, Oil) else named("solve_loss", "oil", oil, oils()))
    inputs = FrictionInputs(flank_roughness=(flank_roughness,))
    if np.ndim(power) or np.ndim(speed) or np.ndim(temperature):
        return losses(inputs, mesh, lubricant, T=temperature, n_1=speed, P=power)
    return solve_mesh(case(inputs, mesh, oil_at(lubricant, temperature), speed), power, by_regime=True)
