# SPDX-License-Identifier: Apache-2.0
"""What would make a train quiet at idle, or its teeth stand their strikes: each remedy with its number, by the same
motion, strikes and rating as the drive itself.

Nothing is offered that does not reach what is asked.  More drag is never offered: it wastes power at every speed, and
hardly slows a strike down unless it closes the flanks."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import combinations
from typing import Protocol

import numpy as np

from ...engine.inputs import EngineInputs
from ...engine.load import CrankTorque
from ...sheet.arrays import Array
from ...sheet.check import THIN_MARGIN
from ...sheet.deferred import Later
from ...sheet.functions import cos, inv, sin
from ...sheet.quantity import described, dotted
from ...sheet.record import record, replace
from ...sheet.remedy import Change, Remedy, change, digits, remedy, whole
from ...sheet.text import Amount, Text, listed
from ...sheet.units import Metre, MetrePerSecond, Number
from ...sheet.value import untraced
from .. import formulas as f
from ..inputs import GearsInputs, Mesh, mesh_key, wheel_key
from ..rating.load import RatingContext
from ..rating.mesh_strength import S_F_LEAST, S_H_LEAST
from ..result import TrainResult
from ..train import CONTRADICTION
from ..wheel_inputs import Wheel
from .checks import DRIVEN_FROM, FLYWHEEL, grade_letter, grade_limits, grade_of
from .inputs import DriveInputs
from .line import TrainOnLine
from .motion import Motion
from .result import HARDEST, IDLE, DriveResult
from .scissor_inputs import Scissor
from .source import Source
from .spring import Spring
from .strength import StrikeRate, struck
from .strikes import quiet_backlashes
from .survey import Survey, survey
from .window import smallest_normal

HALVINGS = 10
RESERVE = 1e-3  # of a speed: the drag of the closed balance moves a little with what is changed
HEAVIEST = 10.0  # times the inertia on the crank that is still looked at
UNTIL = 1.5  # times idle: how far a scissor gear is asked to hold where nothing is said


@record
class ChangedDrive:
    """The same drive with another motion, backlash or split gears."""

    source: Source
    line: TrainOnLine
    springs: Mapping[int, Spring]


class Goal(Protocol):
    """What is asked of a variant."""

    def reached(self, of: ChangedDrive) -> bool: ...
    def effect(self, of: ChangedDrive) -> Text: ...


# --- variants of a drive


class Workshop:
    """A drive and what can be changed of it."""

    def __init__(self, gears: GearsInputs, train: TrainResult, drive: DriveResult) -> None:
        self.gears, self.train, self.drive = gears, train, drive
        self.now = ChangedDrive(drive.drive.source, drive.drive.line, drive.drive.springs)

    @cached_property
    def _torque(self) -> CrankTorque | None:
        source = self.now.source
        return None if source.J_E is None else source.torque(*self._idle)

    @property
    def _idle(self) -> tuple[Array, Array]:
        return np.array([float(self.drive.idle_speed)]), np.zeros(1)

    def at_idle(self, of: ChangedDrive, corner: str = "nominal") -> Survey:
        return self.surveyed(of, self._idle, self._torque, corner)

    def surveyed(
        self, of: ChangedDrive, points: tuple[Array, Array], torque: CrankTorque | None, corner: str = "nominal"
    ) -> Survey:
        def moved(speeds: Array, loads: Array) -> Motion:
            return of.source.moved(speeds, loads, torque)

        with untraced():
            return survey(moved, of.line, self.drive.drive.drags, of.springs, *points, corner)

    def hardest(self, of: ChangedDrive, corner: str = "nominal") -> MetrePerSecond:
        """The hardest strike of any mesh at idle without load."""
        return float(self.at_idle(of, corner).impacts.speed.max())

    def with_inertia(self, factor: Number) -> ChangedDrive:
        source = self.now.source
        assert source.J_E is not None
        return replace(self.now, source=replace(source, J_E=float(source.J_E) * factor))

    def with_less(self, less: Sequence[Metre]) -> ChangedDrive:
        """`less` backlash of every mesh, along the line of action."""
        play = {
            corner: tuple(float(j) - off for j, off in zip(plays, less)) for corner, plays in self.now.line.play.items()
        }
        return replace(self.now, line=replace(self.now.line, play=play))

    def with_springs(self, torques: Mapping[int, float]) -> ChangedDrive:
        line = self.now.line
        more = {
            i: Spring(Scissor(torque=T), float(line.radius[i]), float(line.play["most"][i])) for i, T in torques.items()
        }
        return replace(self.now, springs={**self.now.springs, **more})

    @cached_property
    def parting(self) -> list[int]:
        """The meshes that part of themselves at idle without load, or where that is not known at their hardest."""
        return [int(i) for i in np.flatnonzero(self.drive.survey.closed.parts[self._point])]

    @property
    def _point(self) -> int:
        return self.drive.at.get(IDLE, self.drive.at[HARDEST])

    @property
    def separation(self) -> Number:
        """Inertia over drag of the mesh in which it is largest; infinite where no drag is known."""
        of = self.drive.survey.closed
        return float(of.separation[self._point, self.parting].max(initial=0.0))

    def title(self, i: int) -> str:
        return self.train.meshes[self.now.line.links[i].key].title

    def place(self, i: int) -> int:
        """Of a mesh in the design."""
        return [mesh.key for mesh in self.gears.meshes].index(self.now.line.links[i].key)


# --- what is asked


@record
class Quiet:
    """Speeds of the hardest strike at idle without load: as designed, and where asked at the largest backlash."""

    shop: Workshop
    nominal: MetrePerSecond
    most: MetrePerSecond | None = None

    def reached(self, of: ChangedDrive) -> bool:
        return self.shop.hardest(of) <= self.nominal and (
            self.most is None or self.shop.hardest(of, "most") <= self.most
        )

    def effect(self, of: ChangedDrive) -> Text:
        u = self.shop.hardest(of)
        if u == 0:
            return Text("closed flanks at idle")
        grade = Text("grade {grade}, {u}", grade=grade_letter(grade_of(u)), u=Amount(u * 1e3, "mm/s", form=".0f"))
        if self.most is None:
            return grade
        most = self.shop.hardest(of, "most")
        return Text(
            "{grade}; {letter}, {u} at the largest backlash",
            grade=grade,
            letter=grade_letter(grade_of(most)),
            u=Amount(most * 1e3, "mm/s", form=".0f"),
        )


@record
class Open:
    """Room for the nominal backlash on every way: none of which is so long that it rattles before it is safe from
    jamming."""

    shop: Workshop

    def ends(self, of: ChangedDrive) -> tuple[Metre, Metre]:
        """Of the way with the least room, along the line of action; an infinite upper end where nothing strikes."""
        shop, line = self.shop, of.line
        at = shop.at_idle(of)
        strikes, parts, bodies = at.strikes.orbit[0] > 0, at.closed.parts[0], at.bodies
        least, along = (0.0, math.inf), cos(shop.train.system.base_helix_angle)
        for i in np.flatnonzero(strikes):
            if (strikes & bodies.before[i])[i + 1 :].any():
                continue  # another one strikes behind it
            low = wider = 0.0
            for k in line.path(int(i)):
                j, lever = float(line.play["nominal"][k]), float(bodies.lever[k, i]) * parts[k]
                if lever:
                    low += lever * (j - float(smallest_normal(shop.train, line.links[k].key)) / along)
                    wider += lever * (float(line.play["most"][k]) - j)
            with untraced():
                quiet = quiet_backlashes(at.motion, bodies, int(i), grade_limits()[1:])[0]
            high = math.inf if quiet is None else quiet - wider
            least = min(least, (low, high), key=lambda ends: ends[1] - ends[0])
        return least

    def reached(self, of: ChangedDrive) -> bool:
        low, high = self.ends(of)
        return low <= high

    def effect(self, of: ChangedDrive) -> Text:
        low, high = self.ends(of)
        if high == math.inf:
            return Text("no upper end")
        return Text(
            "window {low} to {high}",
            low=Amount(low * 1e6, form=".0f"),
            high=Amount(high * 1e6, "µm", form=".0f"),
        )


@record
class Strong:
    """A safety under strikes, which `of_variant` gives."""

    of_variant: Callable[[ChangedDrive], Number]
    least: Number

    def reached(self, of: ChangedDrive) -> bool:
        return self.of_variant(of) >= self.least

    def effect(self, of: ChangedDrive) -> Text:
        return Text("safety {S}", S=Amount(self.of_variant(of), form=".3g"))


# --- the same under strikes


class Strikes:
    """The safeties of meshes and wheels under their strikes, of any variant."""

    def __init__(self, shop: Workshop, context: RatingContext, rate: Callable[[float], StrikeRate]) -> None:
        self.shop, self.context, self.rate = shop, context, rate
        self._known: dict[object, list[tuple[float, dict[str, Array]]]] = {}

    @cached_property
    def _torque(self) -> CrankTorque | None:
        source, of = self.shop.now.source, self.shop.drive.survey
        return None if source.J_E is None else source.torque(of.speeds, of.loads)

    def _forces(self, of: ChangedDrive) -> list[tuple[float, dict[str, Array]]]:
        """At idle and where they strike hardest: the speed of the crank, and the forces of all meshes."""
        what = float(of.source.J_E or 0.0), of.source.nose, of.line.play["nominal"]
        if what not in self._known:
            points = self.shop.drive.survey.speeds, self.shop.drive.survey.loads
            every = self.shop.surveyed(of, points, self._torque)
            largest = self.shop.surveyed(of, points, self._torque, "most").impacts.high
            hardest = int(np.argmax(every.impacts.high.max(axis=1)))
            self._known[what] = [
                (float(points[0][p]), {"low": every.impacts.low[p], "most": largest[p]})
                for p in dict.fromkeys((hardest, self.shop.drive.at.get(IDLE, hardest)))
            ]
        return self._known[what]

    def safety(self, of: ChangedDrive, name: str, estimate: str) -> Number:
        """The least of a mesh, by its key, against pitting, or of a wheel against tooth breakage."""
        found, line = [], self.shop.now.line
        for n, forces in self._forces(of):
            ratio = n / float(self.shop.now.source.work.engine.rated_speed)
            for i, link in enumerate(line.links):
                if not link.toothed or (name in self.shop.train.meshes and name != link.key):
                    continue
                if name in self.shop.train.wheels and name not in (link.driver, link.driven):
                    continue
                with untraced():
                    loaded = struck(self.context, link.key, float(forces[estimate][i]), ratio, self.rate(n))
                if loaded is not None:
                    S = loaded.contact if name == link.key else loaded.bending.get(name)
                    found += [] if S is None else [float(S)]
        return min(found, default=math.inf)

    def remedies(self, name: str, estimate: str) -> Later[Remedy]:
        least = S_H_LEAST if name in self.shop.train.meshes else S_F_LEAST
        if estimate == "low":  # a limit, which is to hold by no narrow margin
            least *= 1 + THIN_MARGIN
        goal = Strong(lambda of: self.safety(of, name, estimate), least)
        return Later(lambda: strong_remedies(self.shop, goal))


# --- the remedies


def quiet_remedies(shop: Workshop, nominal: MetrePerSecond, most: MetrePerSecond | None = None) -> Iterator[Remedy]:
    goal = Quiet(shop, nominal * (1 - RESERVE), most and most * (1 - RESERVE))
    yield from by_allowance(shop, goal)
    yield from by_centre_distance(shop, goal)
    yield from by_flywheel(shop, goal)
    yield from by_closed_flanks(shop, goal)
    yield from by_scissor(shop, goal)
    yield from by_other_end(shop, goal)
    yield from in_words(shop, goal)


def opening_remedies(shop: Workshop) -> Iterator[Remedy]:
    """What makes room from above; narrower tolerances do so from both ends."""
    goal = Open(shop)
    if shop.drive.window is not None and not shop.drive.window.by_phase:
        yield from by_flywheel(shop, goal)
        yield from by_closed_flanks(shop, goal)
        yield from by_scissor(shop, goal)


def strong_remedies(shop: Workshop, goal: Strong) -> Iterator[Remedy]:
    yield from by_allowance(shop, goal)
    yield from by_centre_distance(shop, goal)
    yield from by_flywheel(shop, goal)
    yield from by_other_end(shop, goal)


# less backlash, shared out over the meshes that part so that each keeps some of its own smallest


def _least_share(shop: Workshop, goal: Goal, less: Callable[[Number], Sequence[Metre]]) -> Number | None:
    """The least share of what could go by which the goal is reached; None where all of it does not."""
    if not any(less(1.0)) or not goal.reached(shop.with_less(less(1.0))):
        return None
    low, high = 0.0, 1.0
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if goal.reached(shop.with_less(less(middle))) else (middle, high)
    return high


def _room(shop: Workshop, i: int) -> Metre:
    """By how much the normal backlash of a mesh may be less, and its smallest still holds by no narrow margin."""
    key, train = shop.now.line.links[i].key, shop.train
    usual = train.play[key].backlash_recommended if train.play is not None else 0.0
    return max(0.0, float(smallest_normal(train, key)) - THIN_MARGIN * float(usual))


def by_allowance(shop: Workshop, goal: Goal) -> Iterator[Remedy]:
    """Thicker teeth: an allowance of the span acts on the normal backlash micrometre for micrometre."""
    line, along = shop.now.line, cos(shop.train.system.base_helix_angle)
    room = {i: math.floor(_room(shop, i) * 1e6) for i in shop.parting}

    def less(share: Number) -> list[Metre]:
        of = {i: math.ceil(share * room[i] - 1e-9) for i in shop.parting}
        return [of.get(i, 0) * 1e-6 / along for i in range(len(line.links))]

    share = _least_share(shop, goal, less)
    if share is None:
        return
    off = _by_wheel(shop, {i: math.ceil(share * room[i] - 1e-9) for i in shop.parting})
    changes = []
    for wheel in shop.gears.wheels:
        if off.get(wheel.name):
            now = [E * 1e6 for E in wheel.span_allowance or (0.0, 0.0)]
            key = wheel_key(wheel.name, Wheel.span_allowance)
            changes.append(change(Wheel, key, [whole(E + off[wheel.name]) for E in now], place=wheel.name))
    yield remedy(*changes, effect=goal.effect(shop.with_less(less(share))))


def _by_wheel(shop: Workshop, less: Mapping[int, int]) -> dict[str, int]:
    """By how much the span of each wheel grows in µm, so that each mesh has as much less backlash as it should, and no
    other mesh any; no wheel by more than that takes."""
    line, start = shop.now.line, shop.train.tree.first
    rise, sign = {start: 0}, {start: 1}  # of each wheel: rise + sign·x, x that of the first one
    for i, link in enumerate(line.links):
        if link.toothed:
            rise[link.driven] = less.get(i, 0) - rise[link.driver]
            sign[link.driven] = -sign[link.driver]
        else:
            rise[link.driven], sign[link.driven] = 0, 0  # nothing of a chain reaches behind it

    def moved(x: int) -> dict[str, int]:
        return {name: rise[name] + sign[name] * x for name in rise}

    most = max(map(abs, rise.values()))
    x = min(range(-most, most + 1), key=lambda x: (max(map(abs, moved(x).values())), sum(map(abs, moved(x).values()))))
    return moved(x)


def by_centre_distance(shop: Workshop, goal: Goal) -> Iterator[Remedy]:
    """Closer centres, where the shifts leave room for that.  Shifts that follow from the distance are written down, so
    that they stay."""
    line, along = shop.now.line, cos(shop.train.system.base_helix_angle)
    slope = {i: 2 * sin(shop.train.meshes[line.links[i].key].working_pressure_angle) for i in shop.parting}  # of j
    room = {i: min(_room(shop, i) / along / slope[i], _closer(shop, i)) for i in shop.parting}

    def closer(share: Number) -> dict[int, Metre]:
        return {i: math.ceil(share * room[i] * 1e6 - 1e-6) * 1e-6 for i in room if room[i] > 1e-6}

    def less(share: Number) -> list[Metre]:
        of = closer(share)
        return [_with_closer(shop, i, of[i]) if i in of else 0.0 for i in range(len(line.links))]

    share = _least_share(shop, goal, less)
    if share is None:
        return
    changes, open_ = list[Change](), dict[str, None]()
    wheels = {wheel.name: wheel for wheel in shop.gears.wheels}
    for i, da in closer(share).items():
        mesh = shop.train.meshes[line.links[i].key]
        a = digits((float(mesh.centre_distance) - da) * 1e3, 7)
        changes.append(change(Mesh, mesh_key(shop.place(i), Mesh.centre_distance), a, place=mesh.title))
        open_ |= dict.fromkeys(name for name in (mesh.driver, mesh.driven) if wheels[name].profile_shift is None)
    for name in open_:
        x = digits(float(shop.train.wheels[name].profile_shift), 7)
        changes.append(change(Wheel, wheel_key(name, Wheel.profile_shift), x, place=name))
    yield remedy(*changes, effect=goal.effect(shop.with_less(less(share))))


def _with_closer(shop: Workshop, i: int, da: Metre) -> Metre:
    """By how much less the backlash of a mesh is along the line of action where its centres stand closer."""
    mesh = shop.train.meshes[shop.now.line.links[i].key]
    d_b1, d_b2 = (float(shop.train.wheels[name].base_diameter) for name in (mesh.driver, mesh.driven))
    a = float(mesh.centre_distance)
    with untraced():
        now, then = (f.working_pressure_angle(d_b1, d_b2, distance) for distance in (a, a - da))
    return (d_b1 + d_b2) * (inv(now) - inv(then))


def _closer(shop: Workshop, i: int) -> Metre:
    """By how much two wheels may come closer before their teeth, without allowances, have no backlash left; below 0
    where they have none."""
    system, mesh = shop.train.system, shop.train.meshes[shop.now.line.links[i].key]
    pair = [shop.train.wheels[name] for name in (mesh.driver, mesh.driven)]
    z_1, z_2 = (wheel.teeth for wheel in pair)
    x_1, x_2 = (float(wheel.profile_shift) + CONTRADICTION for wheel in pair)
    alpha_t = system.transverse_pressure_angle
    with untraced():
        involute = f.working_involute(alpha_t, system.alpha_n, x_1, x_2, z_1, z_2)
        a = f.centre_distance(z_1, z_2, system.transverse_module, alpha_t, f.angle_of_involute(involute))
    return float(mesh.centre_distance - a)


# a heavier flywheel


def _with_flywheel(shop: Workshop, factor: Number, goal: Goal) -> Iterator[Remedy]:
    """So heavy that the inertia on the crank is `factor` times as large, to three digits above."""
    J_E, flywheel = shop.now.source.J_E, shop.now.source.work.engine.flywheel_inertia
    assert J_E is not None and flywheel is not None
    wanted = float(flywheel) + (factor - 1) * float(J_E)
    size = 10.0 ** (math.floor(math.log10(wanted)) - 2)
    J = digits(math.ceil(wanted / size - 1e-9) * size, 6)
    if described(EngineInputs.flywheel_inertia).allows(J):
        of = shop.with_inertia(1 + (J - float(flywheel)) / float(J_E))
        if goal.reached(of):
            yield remedy(change(EngineInputs, FLYWHEEL, J, bound=">="), effect=goal.effect(of))


def by_flywheel(shop: Workshop, goal: Goal) -> Iterator[Remedy]:
    """By halving between today's and one so heavy that it is reached."""
    if shop.now.source.J_E is None:
        return
    low, high = 1.0, HEAVIEST
    if not goal.reached(shop.with_inertia(high)):
        return
    for _ in range(HALVINGS):
        middle = math.sqrt(low * high)
        low, high = (low, middle) if goal.reached(shop.with_inertia(middle)) else (middle, high)
    yield from _with_flywheel(shop, high, goal)


def by_closed_flanks(shop: Workshop, goal: Goal) -> Iterator[Remedy]:
    """So heavy that no mesh parts: inertia over drag falls as the inertia on the crank grows.  The weight of a force
    shaft parts flanks all the same; then none beyond `HEAVIEST` is offered."""
    Gamma = shop.separation
    if shop.now.source.J_E is None or not 1 < Gamma < math.inf:
        return
    if Gamma <= HEAVIEST or not shop.hardest(shop.with_inertia(Gamma * (1 + 1e-6))):
        yield from _with_flywheel(shop, Gamma * (1 + 1e-6), goal)


# a split gear


def by_scissor(shop: Workshop, goal: Goal) -> Iterator[Remedy]:
    """In as few meshes as are enough, with the weakest springs; and in all that part, which closes every flank.  A
    spring holds from idle without load up to 1.5 times idle at any load."""
    torques = {i: _holding(shop, i) for i in shop.parting if i not in shop.now.springs}
    few = sorted(
        (way for n in (1, 2) for way in combinations(torques, n)), key=lambda way: sum(torques[i] for i in way)
    )
    enough = (way for way in few if len(way) < len(torques) and goal.reached(_sprung(shop, torques, way)))
    for way in filter(None, (next(enough, None), tuple(torques))):
        if goal.reached(of := _sprung(shop, torques, way)):
            keys = {i: dotted("gears", GearsInputs.meshes, shop.place(i), Mesh.scissor, Scissor.torque) for i in way}
            changes = [change(Scissor, keys[i], torques[i], place=shop.title(i), bound=">=") for i in way]
            yield remedy(*changes, effect=goal.effect(of))


def _sprung(shop: Workshop, torques: Mapping[int, float], way: Sequence[int]) -> ChangedDrive:
    return shop.with_springs({i: torques[i] for i in way})


def _holding(shop: Workshop, i: int) -> float:
    """The torque of a spring that holds a mesh closed up to 1.5 times idle at any load, in N·m to two digits above."""
    of = shop.drive.survey
    slow = of.speeds <= UNTIL * float(shop.drive.idle_speed) * (1 + 1e-9)
    beyond = of.speeds == of.speeds[~slow].min() if not slow.all() else slow  # the range ends between two speeds
    T = float((-of.closed.least[slow | beyond, i]).max()) * float(shop.now.line.radius[i])
    size = 10.0 ** (math.floor(math.log10(T)) - 1)
    return digits(math.ceil(T / size) * size, 6)


# the other end of the crank


def by_other_end(shop: Workshop, goal: Goal) -> Iterator[Remedy]:
    source = shop.now.source
    if source.J_E is None or source.work.engine.crank_twist is None:
        return
    of = replace(shop.now, source=replace(source, nose=not source.nose))
    if goal.reached(of):
        end = "flywheel" if source.nose else "nose"
        yield remedy(change(DriveInputs, DRIVEN_FROM, end), effect=goal.effect(of))


# what no key does


def without_idlers(shop: Workshop) -> Iterator[tuple[int, ...]]:
    """One or two meshes that part, by whose driven wheels the train may be shorter and no shaft turns the other way:
    every wheel less between two meshes turns the sense of all behind it."""
    line, shafts = shop.now.line, {turn.wheel for turn in shop.train.shafts.values()}
    behind = {i: [link for link, parent in zip(line.links, line.parent) if parent == i] for i in shop.parting}
    idlers = [
        i
        for i, driven in behind.items()
        if driven and all(link.toothed for link in driven) and line.links[i].driven not in shafts
    ]
    ways = [set(line.path(i)) for i, link in enumerate(line.links) if link.driven in shafts]
    for fewer in (few for n in (1, 2) for few in combinations(idlers, n)):
        if all(len(way.intersection(fewer)) % 2 == 0 for way in ways):
            yield fewer


def in_words(shop: Workshop, goal: Goal) -> Iterator[Remedy]:
    """Fewer idlers, and a lighter train."""
    line = shop.now.line
    for fewer in without_idlers(shop):
        of = shop.with_less([float(line.play["most"][k]) if k in fewer else 0.0 for k in range(len(line.links))])
        if goal.reached(of):
            names, effect = listed([line.links[i].driven for i in fewer]), goal.effect(of)
            yield Remedy((), effect, Text("a train without {idler} ({effect})", idler=names, effect=effect))
    if 1 < (Gamma := shop.separation) < math.inf and not any(shop.drive.drive.line.gravity):
        effect = Text("closed flanks at idle; before that the grade hardly moves")
        words = Text(
            "{share} of the masses behind the crank ({effect})",
            share=Amount(100 / Gamma, "%", form=".0f"),
            effect=effect,
        )
        yield Remedy((), effect, words)


# --- what is said beside


def notes(shop: Workshop) -> Iterator[Text]:
    """What a resin rim would do, and why more drag is none; nothing where the flanks stay closed at idle."""
    if IDLE not in shop.drive.at or not shop.parting:
        return
    before = shop.at_idle(shop.now)
    if not before.impacts.high.any():  # flanks that would part, were they not jammed
        return
    i = int(np.argmax(before.impacts.high[0]))
    stiffness = list(shop.now.line.stiffness)
    e = _resin_share()
    stiffness[i] *= e
    after = shop.at_idle(replace(shop.now, line=replace(shop.now.line, stiffness=tuple(stiffness))))
    share = float(after.impacts.high[0, i] / before.impacts.high[0, i])
    yield Text(
        "A rim of resin ({E} on steel) in {mesh} would take the force of its strikes at idle to {share} ({level}); "
        "their speed and the grade stay, and its strength is not verified: ISO 6336 rates no resin.",
        E=Amount(RESIN * 1e-9, "GPa", form="g"),
        mesh=shop.title(i),
        share=Amount(100 * share, "%", form=".0f"),
        level=Amount(20 * math.log10(share), "dB", form="+.1f"),
    )
    Gamma = shop.separation
    if 1 < Gamma < math.inf:
        of, line = shop.drive.survey, shop.now.line
        p = shop.drive.at[IDLE]
        v = (
            2
            * math.pi
            * float(shop.drive.idle_speed)
            * abs(float(shop.now.source.work.ratio))
            * float(line.first_radius)
        )
        watts = float((of.bodies.drag[p] * of.bodies.ratio).sum()) * v
        yield Text(
            "More drag is no remedy: only {Gamma} times today's would close the flanks at idle, {watts} in place of "
            "{now}, and at rated speed far more; less than that hardly slows a strike down.",
            Gamma=Amount(Gamma, form=".2g"),
            watts=Amount(Gamma * watts, "W", form=".0f"),
            now=Amount(watts, "W", form=".0f"),
        )


RESIN, STEEL = 5e9, 206e9  # Pa: an aramid resin, typical


def _resin_share() -> Number:
    """Of the stiffness of steel on steel, ISO 6336-1: 2·E₁·E₂/(E₁ + E₂)/E_St."""
    return 2 * RESIN * STEEL / (RESIN + STEEL) / STEEL
