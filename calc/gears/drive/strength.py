# SPDX-License-Identifier: Apache-2.0
"""What the force of a strike means for the teeth: the rating of the step once more, with that force, at that speed.

A strike's force acts along the transverse line of action and is a peak: K_A = 1, and K_V, K_Hβ, K_Hα are those of its
load and its speed.  Where flanks part, both flanks of a tooth are struck in turn: every root is loaded from both
sides."""

from collections.abc import Mapping
from fractions import Fraction

from ...sheet.formula import formula
from ...sheet.functions import cos, floor
from ...sheet.record import record, replace
from ...sheet.text import Text
from ...sheet.units import Metre, Newton, Number, Radian, RevPerSecond, Second
from ...sheet.value import about
from ..formulas import overlap_ratio, total_contact_ratio
from ..rating.load import RatingContext, factor_of_peak
from ..rating.solve import Loaded, Nominal, contact_cycles, loaded, nominal_stresses, side, speed_there
from ..result import MeshResult
from ..tree import Tree


@formula(
    "F_t",
    "geometry: of a force along the transverse line of action, what acts along the reference circle",
    meanings={"F": "Force along the line of action"},
)
def tangential_force_of(F: Newton, alpha_t: Radian) -> Newton:
    """Not on the working circle: the rating reckons with reference diameters.

    >>> tangential_force_of(F=1765.0, alpha_t=0.3739)
    1643.0...
    """
    return F * cos(alpha_t)


# --- load cycles


@formula(
    "c_Z",
    "rule of this program: the hardest strike of each firing counts, and a tooth meets its share of them in a working "
    "cycle; q_Z: denominator of the turns of its wheel from firing to firing, in lowest terms",
    names={"q": "q_Z"},
    meanings={
        "s": "Firings of a working cycle that are alike",
        "q": "Denominator of the wheel's turns from firing to firing",
        "z": "Teeth",
    },
)
def strikes_of_tooth(s: Number, q: Number, z: Number) -> Number:
    """`s`: firings of a working cycle that are alike; `z`: teeth.  The wheel stands in q places at the strikes; where
    these are more than its teeth, ⌈q/z⌉ of them are one tooth's.

    >>> strikes_of_tooth(s=3.0, q=117.0, z=39.0)
    0.0769...
    """
    return s * (floor((q - 1) / z) + 1) / q


@formula(
    "N_L",
    "ISO 6336-6: strikes on one flank of one tooth over the life, c_Z in a working cycle of i/2 turns of the crank",
    names={"n": "n_C", "c": "c_Z"},
)
def strike_cycles(n: RevPerSecond, L_h: Second, i: Number, c: Number) -> Number:
    """`i`: strokes of the working cycle.

    >>> strike_cycles(n=15.0, L_h=3.6e6, i=4.0, c=1.0)
    27000000.0
    """
    return n * L_h * 2 / i * c


@record
class StrikeRate:
    """How often strikes come: speed of the crank, and how often one tooth of each wheel meets the hardest one in a
    working cycle."""

    crank_speed: RevPerSecond
    strokes: int
    per_tooth: Mapping[str, Number]


def turns_between(tree: Tree, wheel: str, strokes: int, alike: int, of_first: Fraction = Fraction(1)) -> Fraction:
    """Turns of a wheel from firing to firing, exact.

    `alike`: firings of a working cycle that turn the crank alike: all those of an engine that fires evenly, else 1.
    `of_first`: turns of the first driver in a turn of the crank."""
    turns = abs(of_first) * Fraction(strokes, 2 * alike)
    for link in tree.way(wheel):
        turns *= Fraction(link.z_1, link.z_2)
    return turns


def strike_rate(
    tree: Tree, crank_speed: RevPerSecond, strokes: int, alike: int, of_first: Fraction = Fraction(1)
) -> StrikeRate:
    """Of every wheel in a mesh; the rest as in `turns_between`."""
    per_tooth: dict[str, Number] = {}
    for link in tree.links:
        for wheel, z in ((link.driver, link.z_1), (link.driven, link.z_2)):
            if link.toothed and wheel not in per_tooth:
                q = turns_between(tree, wheel, strokes, alike, of_first).denominator
                with about(Text("wheel {name}", name=wheel)):
                    per_tooth[wheel] = strikes_of_tooth(s=float(alike), q=float(q), z=float(z))
    return StrikeRate(crank_speed, strokes, per_tooth)


# --- a mesh under a force


def struck(
    context: RatingContext,
    key: str,
    F: Newton,
    speed_ratio: Number = 1.0,
    rate: StrikeRate | None = None,
    like: Loaded | None = None,
) -> Loaded | None:
    """A mesh under the force F of a strike along the transverse line of action, where the crank turns `speed_ratio`
    times as fast as in the rating; None where no force acts or a wheel has no strength class.

    `rate`: counted where a life is given; without it, or without a life, the endurance limits hold.  `like`: what this
    gave at the same speed and rate under another force; what no force changes is taken from it."""
    if not F > 0:
        return None
    mesh, cycles = context.train.meshes[key], dict[str, Number | None]()
    if like is not None:
        cycles = {of.name: of.cycles for of in like.strength.sides}
        return _under(like.at, mesh, F, cycles, like, reverses=True)
    for name in (mesh.driver, mesh.driven):
        cycles[name] = None
        if context.gears.life is not None and rate is not None:
            with about(Text("wheel {name}", name=name)):
                c, i = rate.per_tooth[name], float(rate.strokes)
                cycles[name] = strike_cycles(n=rate.crank_speed, L_h=context.gears.life, i=i, c=c)
    there = _at_speed(context, mesh, speed_ratio)
    return None if there is None else _under(there, mesh, F, cycles, reverses=True)


def held(
    context: RatingContext, key: str, F: Newton, split: str, width: Metre, speed_ratio: Number = 1.0
) -> Loaded | None:
    """A mesh that a split wheel holds closed: one half of that wheel, of a width of its own, under the force F."""
    mesh = context.train.meshes[key]
    with about(Text("half of {name}, {b} mm wide", name=split, b=round(width * 1e3, 3))):
        eps_beta = overlap_ratio(width, context.train.system.beta, context.train.system.m_n)
        eps_gamma = total_contact_ratio(mesh.transverse_contact_ratio, eps_beta)
    mesh = replace(mesh, face_width=width, overlap_ratio=eps_beta, total_contact_ratio=eps_gamma)
    if (body := context.bodies.get(split)) is not None:
        narrow = replace(body, wheel=replace(body.wheel, face_width=width))
        context = replace(context, bodies=context.bodies | {split: narrow})
    cycles = {name: contact_cycles(context, name, speed_ratio) for name in (mesh.driver, mesh.driven)}
    there = _at_speed(context, mesh, speed_ratio) if F > 0 else None
    return None if there is None else _under(there, mesh, F, cycles, reverses=False)


def _at_speed(context: RatingContext, mesh: MeshResult, speed_ratio: Number) -> RatingContext | None:
    """With the wheels of a mesh `speed_ratio` times as fast; None where one has no strength class."""
    if not {mesh.driver, mesh.driven} <= context.classes.keys():
        return None
    bodies = dict(context.bodies)
    for name in (mesh.driver, mesh.driven):
        with about(Text("wheel {name}", name=name)):
            n = speed_there(n=bodies[name].wheel.speed, r=speed_ratio)
        bodies[name] = replace(bodies[name], wheel=replace(bodies[name].wheel, speed=n))
    return replace(context, bodies=bodies)


def _under(
    there: RatingContext,
    mesh: MeshResult,
    F: Newton,
    cycles: Mapping[str, Number | None],
    like: Loaded | None = None,
    *,
    reverses: bool,
) -> Loaded:
    driver, driven = mesh.driver, mesh.driven
    with about(Text("mesh {pair}", pair=mesh.title)):
        F_t = tangential_force_of(F=F, alpha_t=there.train.system.transverse_pressure_angle)
        K_A = factor_of_peak()
    contact, roots = stresses = nominal_stresses(there, mesh, F_t, None if like is None else like.nominal)
    sides = (
        side(there, driver, roots[driver], cycles[driver], reverses),
        side(there, driven, roots[driven], cycles[driven], reverses),
    )
    under = loaded(there, mesh, Nominal(F_t, contact.sigma_H0, contact.Z_eps), K_A, sides, like)
    return replace(under, nominal=stresses)
