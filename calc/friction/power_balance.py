# SPDX-License-Identifier: Apache-2.0
"""The power balance of the train: how the power flows, what all meshes, bearings and journals lose, closed.

In order: what a wheel needs, the fixed point of the powers, the train at its speed, its balance traced.

Every shaft needs the power of its bearings, of its turning masses and of what hangs on it; each mesh, chain and belt
towards the crank adds what it loses at the power that it takes in, the sum of all that lies behind it.  A design
without counter-shaft gives the power that the first driver puts into its mesh, and the balance runs the other way.

`TrainDrive` is the train at its speed with its oil, one operating point or many at once; `loads_of` finds the powers,
`balance` traces them."""

from collections.abc import Callable, Mapping
from functools import cached_property, partial, reduce
from typing import Any, NamedTuple, TypeVar

import numpy as np

from ..bearings.plain.formulas import angular_speed
from ..library.contact import LUBRICATION_FACTOR, ohlendorf_loss_factor, ohlendorf_loss_factor_high
from ..library.lubricant import Lubricant
from ..sheet.errors import NoSolution
from ..sheet.formula import formula
from ..sheet.functions import power
from ..sheet.record import record, replace
from ..sheet.text import Amount, Text
from ..sheet.units import Celsius, KilogramPerMetre3, Metre, Newton, Number, RevPerSecond, Watt
from ..sheet.value import about, based_on, converged, unlinked, untraced
from . import models
from .inputs import FrictionInputs
from .journals import NO_LOADS, Journals, OnShaft
from .losses import sums
from .losses.turning_masses import MassLoss, Sectors, dip_loss_most, sectors_loss, sectors_of
from .losses.wheels import WheelResult, carrying, has_bearings, unloaded
from .mesh.film import Oil, oil_at
from .mesh.geometry import Link, MeshGeometry, StageGeometry, column, require
from .mesh.loss import MeshCase, Warming, case, power_lost, solve_mesh, warming_of
from .mesh.path import driver_speed, transverse_force
from .models import spread_of
from .result import FrictionResult, JournalResult, MeshResult, ShaftLoss, StageLoss, carbon_dioxide, fuel, torque

# --- how the power flows: from what the last wheel must deliver up to the first driver, or the other way round
# A mesh that must put out P_out takes in P_in = P_out + P_loss(P_in).  A wheel needs what its meshes take in, its own
# losses, and what else it drives.  Links (meshes, chains and belts) are listed along the flow; a wheel may drive
# several.
#
# What a wheel needs may itself follow from the power: the force of the teeth loads the bearings of the idlers and the
# journals of the shafts.  All of it is one fixed point, of one operating point or of many at once.

TOLERANCE = 1e-9  # of the power
PASSES = 40
TRAIN = Text("power balance of the train")
MORE_POWER = Text("give more gears.power_kW, less speed, a narrower face, or a thinner oil")
# of the power: what a jump of the loss may leave between the power that loads a mesh and the one it takes in
LEFT: Number = 1e-2
FINE = 1e-9  # of the power: steps below it say nothing about a slope

Loss = Callable[[str, Watt], Watt]
Needs = Callable[[Mapping[str, Watt]], dict[str, Watt]]
Part = TypeVar("Part", Watt, Watt | None)


@formula("P_in", "conservation of energy")
def power_in(P_out: Watt, P_VZ: Watt) -> Watt:
    return P_out + P_VZ


@formula("P_out", "conservation of energy")
def power_out(P_in: Watt, P_VZ: Watt) -> Watt:
    return P_in - P_VZ


@formula(
    "P_in",
    "conservation of energy: what the mesh before passes on, less what the wheel between them needs itself",
    names={"P": "P_Σ"},
)
def passed_on(P_out: Watt, P: Watt) -> Watt:
    return P_out - P


@formula(
    "P_out",
    "conservation of energy: what the last mesh passes on, less what the last wheel needs itself",
    names={"P_out": "P_mesh", "P": "P_Σ"},
)
def delivered(P_out: Watt, P: Watt) -> Watt:
    return P_out - P


# --- what a wheel needs


@formula("P_Σ", "mathematics: sum over what the wheel needs, one after the other", names={"P": "P_Σ,0"})
def and_need(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_Σ", "energy: the last wheel also carries the bearings of the counter-shaft", names={"P": "P_Σ,0"})
def with_bearings(P: Watt, P_B: Watt) -> Watt:
    return P + P_B


@formula("P_Σ", "energy: the wheel also carries the turning masses of its shaft", names={"P": "P_Σ,0"})
def with_masses(P: Watt, P_M: Watt) -> Watt:
    return P + P_M


@formula(
    "P_C",
    "given in the design: P at the speed of the design, and with a power of the speed",
    names={"n": "n_S", "m": "m_C"},
)
def power_of_load(P: Watt, n: RevPerSecond, n_0: RevPerSecond, m: Number) -> Watt:
    return P * power(n / n_0, m)


@formula("P_Σ", "energy: the wheel also drives what is carried on, which is not lost", names={"P": "P_Σ,0"})
def with_carried(P: Watt, P_C: Watt) -> Watt:
    return P + P_C


@formula("P_Σ", "energy: the wheel also drives a mesh", names={"P": "P_Σ,0"})
def with_mesh(P: Watt, P_in: Watt) -> Watt:
    return P + P_in


@formula(
    "P_T",
    "rule of this program: the teeth of a wheel push its shaft as what it takes in and what it passes on, all one way",
    names={"P": "P_T,0"},
)
def and_teeth(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_K", "given in the design: what a chain or a belt loses of the power that it takes in", names={"eta": "η"})
def stage_loss(P_in: Watt, eta: Number) -> Watt:
    """>>> stage_loss(P_in=500.0, eta=0.98)
    10.000...
    """
    return (1 - eta) * P_in


@formula("P_in", "conservation of energy: what a chain or a belt takes in to pass on a power", names={"eta": "η"})
def power_into_stage(P_out: Watt, eta: Number) -> Watt:
    return P_out / eta


# --- the fixed point


class Guess:
    """The power of one mesh: P solves P = P_out + P_loss(P), the loss taken as a straight line through the last two
    passes, and after the first through none at no power."""

    def __init__(self) -> None:
        self.P: Any = None  # one number or, of many operating points, an array: so are the others
        self.loss: Any = 0.0
        self.slope: Any = 0.0

    def at(self, P_out: Any) -> Any:
        if self.P is None:
            return P_out
        return (P_out + self.loss - self.slope * self.P) / (1 - self.slope)

    def learn(self, P: Any, loss: Any) -> None:
        if self.P is not None:
            step = P - self.P
            slope = (loss - self.loss) / np.where(step == 0, 1.0, step)
            self.slope = np.where(np.abs(step) > FINE * np.abs(P), np.clip(slope, -0.5, 0.9), self.slope)
        else:
            self.slope = np.clip(loss / P, 0.0, 0.9)  # most of a loss grows with the power
        self.P, self.loss = P, loss


def upstream(links: Mapping[str, Link], loss: Loss, needs: Needs) -> dict[str, Watt]:
    """The power that loads each mesh and stage; `needs` tells what each wheel needs besides them, at the powers of the
    pass before.

    Where a position changes its regime the loss jumps by what it rolls, and P = P_in may fall into the jump, which no
    power solves; then the last pass stands if it is within 1 %, and a note says so.  The balance loses nothing by that:
    P_in always is P_out plus the loss that is published."""
    guesses = {name: Guess() for name in links}
    loads: dict[str, Watt] = {}
    with untraced():
        for _ in range(PASSES):
            carried, off, moved = needs(loads), {}, 0.0
            for name, link in reversed(list(links.items())):
                P_out = require(link.power, carried[link.driven.name])
                P = require(link.power, guesses[name].at(P_out))
                lost = loss(name, P)
                off[name] = float(np.max(np.abs(P_out + lost - P) / P))
                moved = max(moved, float(np.max(np.abs(P - loads.get(name, np.inf)) / P)))
                guesses[name].learn(P, lost)
                loads[name] = P
                carried[link.driver.name] += P_out + lost
            if max(moved, *off.values()) <= TOLERANCE:
                break
    name, worst = max(off.items(), key=lambda item: item[1])
    if not worst <= LEFT:
        share, most = Amount(worst * 100, form=".3g"), Amount(float(np.max(loads[name])), form=".6g")
        tried = Text("off by {worst} % of {max} W after {passes} passes", worst=share, max=most, passes=PASSES)
        raise NoSolution(Text("power balance of mesh {name}", name=name), tried, Text("less friction, or more power"))
    return {name: loads[name] if np.ndim(loads[name]) else float(loads[name]) for name in links}


def downstream(links: Mapping[str, Link], loss: Loss, needs: Needs, P: Watt) -> dict[str, Watt]:
    """The same for a train whose first driver puts the power P into its mesh; each wheel drives one mesh or stage."""
    before: dict[str, Watt] = {}
    with untraced():
        for _ in range(PASSES):
            loads = _powers_down(links, loss, needs(before), P)
            if all(np.all(np.abs(loads[name] - before.get(name, np.nan)) <= TOLERANCE * P) for name in links):
                return loads
            before = loads
    raise NoSolution(TRAIN, Text("not settled after {passes} passes", passes=PASSES), MORE_POWER)


def _powers_down(links: Mapping[str, Link], loss: Loss, needed: Mapping[str, Watt], P: Watt) -> dict[str, Watt]:
    wheel = next(iter(links.values())).driver.name
    loads: dict[str, Watt] = {}
    for name, link in links.items():
        if link.driver.name != wheel:
            branches = Text("the train branches, and the power of its first driver does not say how it divides")
            raise NoSolution(Text("mesh {title}", title=link.title), branches, Text("give one chain of wheels"))
        if np.any(P <= 0):
            least = Amount(float(np.min(P)), form=".4g")
            nothing = Text("{min} W come in: what lies before it loses more than it gets", min=least)
            raise NoSolution(Text("mesh {title}: power", title=link.title), nothing, MORE_POWER)
        loads[name] = require(link.power, P)
        wheel = link.driven.name
        P = loads[name] - loss(name, loads[name]) - needed[wheel]
    return loads


# --- the train at its speed

Meshes = Mapping[str, MeshGeometry]
Links = Mapping[str, Link]  # along the flow of power
Forces = Callable[[Mapping[str, Watt], Mapping[str, RevPerSecond]], Mapping[str, Newton]]


class Hung(NamedTuple):
    """What hangs on a shaft, a pump: the wheel that drives it, and the power that it takes, which is carried and not
    lost."""

    name: str
    wheel: str
    power: Watt


@record
class End:
    """A shaft at the end of a way through the train, at one operating point or at many: the wheel on it, its journals,
    what hangs on it, and its sectors where their loss is asked; `rho_oil`: of the oil into which they may dip."""

    wheel: str
    journals: Journals
    hung: tuple[Hung, ...] = ()
    sectors: Sectors | None = None
    rho_oil: KilogramPerMetre3 | None = None


Ends = Mapping[str, End]  # by the names of the shafts
NO_ENDS: Ends = {}


def end_of(friction: FrictionInputs, wheel: str, on: OnShaft, journals: Journals) -> End:
    """A shaft at the operating points of its journals."""
    if on.inputs is None:
        return End(wheel, journals)
    n, hung, sectors, rho_oil = journals.speed, [], None, None
    for load in on.inputs.loads:
        with about(Text("load {name}", name=load.name)):
            P = power_of_load(P=load.power, n=n, n_0=on.speed, m=load.speed_exponent)
        hung.append(Hung(load.name, load.wheel or wheel, P))
    if friction.mass_loss != "none" or friction.oil_level is not None:
        with about(Text("turning masses of shaft {name}", name=on.inputs.name)):
            outline = on.shaft.outline if on.shaft is not None else None
            sectors = sectors_of(on.inputs, outline, angular_speed(n=n))
    if friction.oil_level is not None:
        rho_oil = next(iter(on.bearings.bearings.values())).supplied.rho
    return End(wheel, journals, tuple(hung), sectors, rho_oil)


def shaft_loss(shaft: Journals, P: Watt | None, loads: Mapping[str, Watt] = NO_LOADS) -> Watt:
    """What the journals of a shaft lose when the teeth of its gear carry P, meshes, chains and belts the `loads`."""
    return shaft.sum(shaft.journals(P, loads))


@record
class TrainDrive:
    """A train at its speed with its oil: everything but the powers.  Many operating points: arrays, see
    `mesh.geometry.column`."""

    friction: FrictionInputs
    links: Links
    cases: dict[str, MeshCase]
    wheels: dict[str, WheelResult]  # without their own bearings
    lubricant: Lubricant
    T_oil: Celsius
    oil: Oil
    ends: Ends
    masses: Mapping[str, MassLoss]  # what the sectors of each shaft lose, where that is counted
    forces: Forces
    lubrication: str
    rolling: bool = True  # whether the balance counts what the rigid film rolls
    compared: bool = True  # whether the source's model stands beside the one that judges

    @cached_property
    def meshes(self) -> Meshes:
        return meshes_of(self.links)

    @property
    def first(self) -> str:
        return next(iter(self.links.values())).driver.name

    @property
    def last(self) -> str:
        return last_of(self.links, self.ends)

    def bearings(self, loads: Mapping[str, Watt]) -> dict[str, tuple[Newton, Watt]]:
        """Load and loss of the wheels' own bearings at the powers of the meshes."""
        if not has_bearings(self.friction):
            return {}
        forces = self.forces(loads, {name: wheel.speed for name, wheel in self.wheels.items()})
        return carrying(self.friction, self.wheels, self.last, self.lubricant, self.T_oil, forces)

    @property
    def hung(self) -> tuple[Hung, ...]:
        """What hangs on all shafts."""
        return tuple(hung for end in self.ends.values() for hung in end.hung)

    def loss(self, name: str, P: Watt) -> Watt:
        link = self.links[name]
        if isinstance(link, StageGeometry):
            return stage_loss.function(P, link.efficiency)
        return power_lost(self.cases[name], P, self.friction.film == "judged", rolling=self.rolling)

    def loss_on(self, name: str, P: Watt, b: Metre) -> Watt:
        """Of a mesh on the width b of its teeth, with the oil and at the speed that it has here."""
        whole, link = self.cases[name], self.cases[name].mesh
        narrow = replace(link, driver=replace(link.driver, face_width=b), driven=replace(link.driven, face_width=b))
        part = case(self.friction, narrow, whole.oil, self.wheels[link.driver.name].speed, whole.warming)
        return power_lost(part, P, self.friction.film == "judged", rolling=self.rolling)

    def at_teeth(self, wheel: str, P: Watt, loads: Mapping[str, Watt]) -> Watt | None:
        """What the teeth of a wheel carry that needs P besides what it drives: all that it takes in by a mesh, and what
        its meshes pass on, as if all pushed one way; None where it has no mesh that is loaded."""
        on = [name for name, link in self.links.items() if link.driver.name == wheel]
        of_teeth = [loads[name] for name in on if name in self.meshes]
        if any(mesh.driven.name == wheel for mesh in self.meshes.values()):
            return reduce(lambda P, P_i: and_teeth(P=P, P_i=P_i), [*(loads[name] for name in on), *of_teeth], P)
        return reduce(lambda P, P_i: and_teeth(P=P, P_i=P_i), of_teeth) if of_teeth else None


def meshes_of(links: Links) -> Meshes:
    return {name: link for name, link in links.items() if isinstance(link, MeshGeometry)}


def last_of(links: Links, ends: Ends) -> str:
    """The wheel that carries what names no other: that of the last shaft, else the last that is driven."""
    return list(ends.values())[-1].wheel if ends else list(links.values())[-1].driven.name


def drive(
    friction: FrictionInputs,
    links: Links,
    lubricant: Lubricant,
    T_oil: Celsius,
    first_speed: RevPerSecond,
    ends: Ends = NO_ENDS,
    forces: Forces | None = None,
    lubrication: str = "spray",
    Lambda: Number | None = None,
    thickening: Number | None = None,
    compared: bool = True,
    **fineness: int,
) -> TrainDrive:
    """A train at its speed.  `forces` of the teeth on each wheel, from powers of the meshes and speeds; left out, the
    largest they can be.

    `Lambda` and `thickening` as `oil_at` takes them, of many operating points as columns.
    """
    if not links:
        raise NoSolution(TRAIN, Text("there is no mesh"), Text("give at least one [[gears.meshes]]"))
    T_b = column(require_temperature(T_oil if friction.bulk_temperature is None else friction.bulk_temperature))
    with about(Text("oil")):
        oil = oil_at(lubricant, T_b, Lambda, thickening)
    last = last_of(links, ends)
    wheels = unloaded(friction, links, lubricant, require_temperature(T_oil), first_speed, last)
    warming = Warming(column(T_oil), LUBRICATION_FACTOR[lubrication], friction.tip_relief_factor)
    cases = {}
    for name, mesh in meshes_of(links).items():
        with about(Text("mesh {title}", title=mesh.title)):
            cases[name] = case(friction, mesh, oil, wheels[mesh.driver.name].speed, warming, **fineness)
    masses = masses_of(friction, ends)
    return TrainDrive(
        friction=friction,
        links=links,
        cases=cases,
        wheels=wheels,
        lubricant=lubricant,
        T_oil=T_oil,
        oil=oil,
        ends=ends,
        masses=masses,
        forces=forces or partial(most_force, meshes_of(links)),
        lubrication=lubrication,
        compared=compared,
    )


def masses_of(friction: FrictionInputs, ends: Ends) -> dict[str, MassLoss]:
    """What the sectors of each shaft lose, where that is counted."""
    masses = {}
    for name, end in ends.items():
        if friction.mass_loss == "none" or (s := end.sectors) is None:
            continue
        with about(Text("turning masses of shaft {name}", name=name)):
            sizes, omega, rho = (s.lengths, s.outer_radii, s.core_radii), column(s.omega), column(friction.mist_density)
            masses[name] = sectors_loss(*sizes, omega, rho, shell_gap=s.shell_gap)
    return masses


def require_temperature(T: Celsius) -> Celsius:
    good = (T > -60) & (T < 400)  # NaN is not
    if not np.all(good):
        wrong = float(np.ravel(T)[int(np.argmin(np.ravel(good)))])
        needed = Text("a temperature of a liquid oil is needed")
        raise NoSolution(Text("temperature of the oil"), Text("is {wrong} °C", wrong=Amount(wrong)), needed)
    return T


def most_force(meshes: Meshes, loads: Mapping[str, Watt], speeds: Mapping[str, RevPerSecond]) -> dict[str, Newton]:
    """The forces of the teeth on each wheel if all push the same way; at no power, none."""
    forces = {name: 0.0 for mesh in meshes.values() for name in (mesh.driver.name, mesh.driven.name)}
    for name, mesh in meshes.items():
        if name not in loads:
            continue
        P = loads[name]
        F_bt = transverse_force(P=P, omega_1=driver_speed(n_1=speeds[mesh.driver.name]), r_b1=mesh.driver.base_radius)
        for wheel in (mesh.driver.name, mesh.driven.name):
            forces[wheel] = forces[wheel] + F_bt
    return forces


# --- the powers


def loads_of(d: TrainDrive, power: Watt | None = None) -> tuple[dict[str, Watt], dict[str, Watt]]:
    """The power that loads each mesh and stage, and what each wheel needs besides them.

    `power`: of the first driver into its mesh, of a design without counter-shaft.
    """
    needed: dict[str, Watt] = {}

    def needs(loads: Mapping[str, Watt]) -> dict[str, Watt]:
        teeth = {name: d.at_teeth(end.wheel, needed[end.wheel], loads) if needed else None for name, end in shafts}
        bearings = d.bearings(loads)
        for name, wheel in d.wheels.items():
            needed[name] = sum(wheel.parts()) + (bearings[name][1] if name in bearings else 0.0)
        for name, end in shafts:
            what = Text("losses of the counter-shaft's bearings")
            needed[end.wheel] += require(what, shaft_loss(end.journals, teeth[name], loads), zero=True)
            needed[end.wheel] += d.masses[name].mass_loss if name in d.masses else 0.0
        for hung in d.hung:
            needed[hung.wheel] += hung.power
        return dict(needed)

    shafts = d.ends.items()
    if not shafts:
        if power is None:
            unknown = Text("neither the losses of a counter-shaft nor the power of the first driver is known")
            raise NoSolution(TRAIN, unknown, Text("give gears.power_kW"))
        return downstream(d.links, d.loss, needs, require(Text("power of the first driver"), power)), needed
    return upstream(d.links, d.loss, needs), needed


@record
class Losses:
    """What a train loses, of one operating point or of many: its meshes, its wheels, the counter-shaft's journals, its
    turning masses."""

    mesh: Watt
    wheels: Watt
    journals: Watt
    masses: Watt

    @property
    def total(self) -> Watt:
        return self.mesh + self.wheels + self.journals + self.masses


def losses_of(d: TrainDrive, power: Watt | None = None) -> Losses:
    """The losses of the closed balance, nothing traced; `power` as in `loads_of`."""
    with untraced(), np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        loads, needed = loads_of(d, power)
        of_wheels = [sum(wheel.parts()) for wheel in d.wheels.values()]
        return Losses(
            mesh=sum(d.loss(name, P) for name, P in loads.items()),
            wheels=sum(of_wheels) + sum(P for _, P in d.bearings(loads).values()),
            journals=sum(
                shaft_loss(end.journals, d.at_teeth(end.wheel, needed[end.wheel], loads), loads)
                for end in d.ends.values()
            ),
            masses=sum(masses.mass_loss for masses in d.masses.values()),
        )


def balance(d: TrainDrive, power: Watt | None = None) -> FrictionResult:
    """The closed balance of one operating point, with every line that leads to it."""
    with untraced():
        loads, needed = loads_of(unlinked(d), unlinked(power))
        teeth = {name: d.at_teeth(end.wheel, needed[end.wheel], loads) for name, end in d.ends.items()}
    if power is not None:
        loads[next(iter(d.links))] = power
    if has_bearings(d.friction) or len(d.ends) > 1:
        of = based_on(0.0, d.friction, d.links, d.wheels, d.lubricant.oil, d.T_oil, power)
        loads = {name: based_on(P, of) for name, P in loads.items()}
    wheels = dict(d.wheels)
    for name, (force, loss) in d.bearings(loads).items():
        wheels[name] = replace(wheels[name], bearing_force=force, bearing_loss=loss)
    for name, wheel in wheels.items():
        with about(Text("wheel {name}", name=name)):
            needed[name] = reduce(lambda P, P_i: and_need(P=P, P_i=P_i), wheel.parts())
    for hung in d.hung:
        with about(Text("wheel {name}", name=hung.wheel)):
            needed[hung.wheel] = with_carried(P=needed[hung.wheel], P_C=hung.power)
    dips = {name: _dip(d.friction, name, end) for name, end in d.ends.items()}
    shafts = {name: _shaft(d, name, needed, teeth[name], loads) for name in d.ends}
    P_2: Watt | None = None
    if shafts:
        meshes, stages, P_1 = _up(d, needed, loads)
    else:
        meshes, stages, P_1, P_2 = _down(d, needed, loads)
    with about(Text("train")):
        P_B = _total(sums.shafts, [shaft.bearing_loss for shaft in shafts.values()]) if shafts else None
        P_VZ = _total(sums.meshes, [mesh.judged.loss for mesh in meshes.values()]) if meshes else None
        P_W = _total(sums.windage, [wheel.windage for wheel in wheels.values()])
        P_C = _total(sums.churning, [wheel.churning for wheel in wheels.values()])
        P_J = _total(sums.thrown_oil, [wheel.thrown_oil for wheel in wheels.values()])
        P_D = _total(sums.seals, [wheel.seal_loss for wheel in wheels.values()])
        P_L = _total(sums.bearings, [wheel.bearing_loss for wheel in wheels.values()])
        P_X = _total(sums.other_losses, [wheel.other_loss for wheel in wheels.values()])
        P_B0, P_C0, P_J0, P_D0, P_L0 = (0.0 if part is None else part for part in (P_B, P_C, P_J, P_D, P_L))
        P_W0, P_VZ0 = (0.0 if part is None else part for part in (P_W, P_VZ))
        P = sums.total_loss(P_B=P_B0, P_VZ=P_VZ0, P_W=P_W0, P_C=P_C0, P_J=P_J0, P_D=P_D0, P_L=P_L0, P_X=P_X)
        P_K = _total(sums.stages, [stage.loss for stage in stages.values()]) if stages else None
        P = P if P_K is None else sums.with_stages(P=P, P_K=P_K)
        masses = _all_masses(list(d.masses.values())) if d.masses else None
        P = P if masses is None else sums.with_masses(P=P, P_M=masses.mass_loss)
        carried = _total(sums.carried, [hung.power for hung in d.hung]) if d.hung else None
        P_D_most = _total(sums.dips, list(dips.values())) if dips else None
        T_1 = torque(P=P_1, n=wheels[d.first].speed)
        b_e = d.friction.specific_fuel_consumption
        m_B = None if b_e is None else fuel(b_e=b_e, P=P)
        m_CO2 = None if m_B is None else carbon_dioxide(e_CO2=d.friction.co2_per_fuel, m_B=m_B)
    each = {
        name: ShaftLoss(bearing_loss=shaft.bearing_loss, masses=d.masses.get(name), dip_loss_most=dips[name])
        for name, shaft in shafts.items()
    }
    return FrictionResult(
        meshes=meshes,
        stages=stages,
        wheels=wheels,
        shafts=each if len(each) > 1 else None,
        journals={name: shaft.journals for name, shaft in shafts.items()},
        oil_viscosity=d.oil.eta_0,
        bearing_loss=P_B,
        masses=masses,
        dip_loss_most=P_D_most,
        mesh_loss=P_VZ,
        stage_loss=P_K,
        windage_loss=P_W,
        churning_loss=P_C,
        thrown_oil_loss=P_J,
        seal_loss=P_D,
        wheel_bearing_loss=P_L,
        other_loss=P_X,
        total_loss=P,
        crank_power=P_1,
        crank_torque=T_1,
        delivered_power=P_2,
        carried_power=carried,
        fuel=m_B,
        co2=m_CO2,
        residual=based_on(P_1 - P - (P_2 or 0.0) - (carried or 0.0), P_1, P, P_2, carried),
    )


@formula(
    "P",
    "energy, power balance: what comes in is what is lost and what goes out",
    shows="P that is passed on together with the loss which it makes",
)
def closing_power(P: Watt) -> Watt:
    """The power itself, found from all that the losses depend on."""
    return P


def _total(adding: Callable[..., Watt], parts: list[Part]) -> Part:
    """The sum of what is there, line by line; None where nothing is."""
    there = [part for part in parts if part is not None]
    return reduce(lambda P, P_i: adding(P=P, P_i=P_i), there) if there else parts[0]


def _all_masses(each: list[MassLoss]) -> MassLoss:
    """Of all shafts together."""
    return MassLoss(
        mass_loss_low=_total(sums.least_of_masses, [masses.mass_loss_low for masses in each]),
        mass_loss_high=_total(sums.most_of_masses, [masses.mass_loss_high for masses in each]),
        mass_loss=_total(sums.masses, [masses.mass_loss for masses in each]),
    )


def _dip(friction: FrictionInputs, name: str, end: End) -> Watt | None:
    """The most that the sectors of a shaft lose to oil at rest; None where they stand in a shell, or where something of
    it is not known."""
    s, level = end.sectors, friction.oil_level
    if s is None or level is None or end.rho_oil is None or s.up is None or s.shell_gap is not None:
        return None
    with about(Text("turning masses of shaft {name}, in oil", name=name)):
        return dip_loss_most(s.lengths, s.outer_radii, s.omega, end.rho_oil, level, s.up)


class TurningShaft(NamedTuple):
    """One shaft in the balance: its journals, what they lose, and what its teeth carry."""

    journals: dict[str, JournalResult]
    bearing_loss: Watt
    at_teeth: Watt | None


def _shaft(
    d: TrainDrive, name: str, needed: dict[str, Watt], at_gear: Watt | None, loads: Mapping[str, Watt]
) -> TurningShaft:
    """The journals of a shaft at the power that closes with them; `needed` is then what its wheel needs with them."""
    end, masses = d.ends[name], d.masses.get(name)
    wheel_need = needed[end.wheel]
    if masses is not None:
        with about(Text("wheel {last}", last=end.wheel)):
            wheel_need = with_masses(P=wheel_need, P_M=masses.mass_loss)

    def last(P: Watt | None) -> TurningShaft:
        journals = end.journals.journals(P, loads)
        P_B = end.journals.sum(journals)
        with about(Text("wheel {last}", last=end.wheel)):
            needed[end.wheel] = with_bearings(P=wheel_need, P_B=P_B)
            return TurningShaft(journals, P_B, d.at_teeth(end.wheel, needed[end.wheel], loads))

    return last(None) if at_gear is None else converged(closing_power, at_gear, last, lambda state: state.at_teeth)


def _up(
    d: TrainDrive, needed: Mapping[str, Watt], loads: Mapping[str, Watt]
) -> tuple[dict[str, MeshResult], dict[str, StageLoss], Watt]:
    """Every mesh at its load once more, with its lines, from the last to the first, and every stage; and the power at
    the first driver."""
    carried = dict(needed)
    meshes: dict[str, MeshResult] = {}
    stages: dict[str, StageLoss] = {}
    for name, link in reversed(list(d.links.items())):
        P_out = carried[link.driven.name]
        if isinstance(link, StageGeometry):
            with about(Text("stage {name}", name=name)):
                P_in = power_into_stage(P_out=P_out, eta=link.efficiency)
                stages[name] = StageLoss(
                    power_in=P_in, power_out=P_out, loss=stage_loss(P_in=P_in, eta=link.efficiency)
                )
        else:
            with about(Text("mesh {title}", title=link.title)):
                meshes[name] = converged(
                    closing_power, loads[name], partial(_mesh, d, name, P_out=P_out), lambda result: result.power_in
                )
            P_in = meshes[name].power_in
        with about(Text("wheel {name}", name=link.driver.name)):
            carried[link.driver.name] = with_mesh(P=carried[link.driver.name], P_in=P_in)
    return {name: meshes[name] for name in d.meshes}, dict(reversed(stages.items())), carried[d.first]


def _down(
    d: TrainDrive, needed: Mapping[str, Watt], loads: Mapping[str, Watt]
) -> tuple[dict[str, MeshResult], dict[str, StageLoss], Watt, Watt]:
    """The same along the flow, of one chain whose first mesh has the power that is given; and what is delivered at its
    end."""
    meshes: dict[str, MeshResult] = {}
    stages: dict[str, StageLoss] = {}
    P = loads[next(iter(d.links))]
    with about(Text("wheel {first}", first=d.first)):
        P_1 = with_mesh(P=needed[d.first], P_in=P)
    for name, link in d.links.items():
        if link.driver.name != d.first:
            with about(Text("wheel {name}", name=link.driver.name)):
                P = passed_on(P_out=P, P=needed[link.driver.name])
        if isinstance(link, StageGeometry):
            with about(Text("stage {name}", name=name)):
                lost = stage_loss(P_in=P, eta=link.efficiency)
                stages[name] = StageLoss(power_in=P, power_out=power_out(P_in=P, P_VZ=lost), loss=lost)
                P = stages[name].power_out
        else:
            with about(Text("mesh {title}", title=link.title)):
                meshes[name] = _mesh(d, name, P, None)
            P = meshes[name].power_out
    with about(Text("wheel {last}", last=d.last)):
        return meshes, stages, P_1, delivered(P_out=P, P=needed[d.last])


def _mesh(d: TrainDrive, name: str, P: Watt, P_out: Watt | None) -> MeshResult:
    """One mesh at the power that loads it, with what is shown beside; P_out where it is known, else it follows."""
    regimes, c = d.friction.film == "judged", d.cases[name]
    mesh = c.mesh
    judged = solve_mesh(c, P, regimes)
    if P_out is None:
        P_in, P_out = P, power_out(P_in=P, P_VZ=judged.loss)
    else:
        P_in = power_in(P_out=P_out, P_VZ=judged.loss)
    rise = warming_of(c, P, judged.friction_mean, judged.loss_factor)
    z_1, z_2, beta_b, eps_alpha = mesh.driver.teeth, mesh.driven.teeth, mesh.base_helix_angle, c.path.epsilon_alpha
    if eps_alpha < 2:
        eps_1, eps_2 = c.path.epsilon_1, c.path.epsilon_2
        H_V = ohlendorf_loss_factor(eps_1=eps_1, eps_2=eps_2, eps_alpha=eps_alpha, z_1=z_1, z_2=z_2, beta_b=beta_b)
    else:
        H_V = ohlendorf_loss_factor_high(eps_alpha=eps_alpha, z_1=z_1, z_2=z_2, beta_b=beta_b)
    beside = None
    if d.compared or not regimes:
        other = Text("source model") if regimes else Text("by regime")
        with about(Text("mesh {title}, {text}", title=mesh.title, text=other)):
            beside = solve_mesh(c, P, not regimes)
    with about(Text("mesh {title}, regressions", title=mesh.title)):
        published = models.beside(c, P, H_V)
        losses = [judged.loss, *(model.loss for model in (beside, *published.values()) if model is not None)]
        apart = spread_of(losses) if d.compared else None
    return MeshResult(
        judged=judged,
        model_spread=apart,
        power_in=P_in,
        power_out=P_out,
        ohlendorf_loss_factor=H_V,
        bulk_rise=rise,
        source=beside if regimes else judged,
        by_regime=None if regimes else beside,
        case=c,
        published_models=published,
    )
