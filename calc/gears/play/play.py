# SPDX-License-Identifier: Apache-2.0
"""The play of a train: what its backlash is over tolerances, chance, runout and temperature, and how far it lets the last wheel turn."""

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from ...catalogue import Material
from ...sheet.check import Check
from ...sheet.formula import formula
from ...sheet.functions import rss
from ...sheet.record import record
from ...sheet.step import Curve, Table
from ...sheet.trace import about
from ...sheet.units import Metre, NewtonMetre, Number, Radian
from .. import formulas as f
from ..inputs import GearsInputs
from . import backlash as b
from . import chance as c
from . import temperature as t
from .judge import checks, notes
from .meeting import Meeting, meetings
from .result import PlayResult, TrainPlay
from .shown import curves, tables
from .stack import three_deviations, worst_case

if TYPE_CHECKING:
    from ..result import TrainResult


@formula("δφ", "what the tolerances of one mesh add to its play at mid-tolerance, reduced to the last wheel", names={"phi_max": "φ_j,max"})
def deviation_at_shaft(phi_max: Radian, phi_j: Radian, z: Number, z_last: Number) -> Radian:
    return (phi_max - phi_j) * z / z_last


@formula("Δφ_rss", "play at mid-tolerance and the root of squares of the meshes' deviations", names={"Delta_phi": "Δφ", "delta": "δφ"})
def phase_error_rss(Delta_phi: Radian, delta: Radian) -> Radian:
    return Delta_phi + rss(delta)


@record
class Played:
    """What `play` found; tables and curves are made when they are looked at."""

    meshes: dict[str, PlayResult]
    train: TrainPlay
    checks: tuple[Check, ...]
    notes: tuple[str, ...]
    known: tuple[tuple[Meeting, t.Expansions], ...]
    gears: GearsInputs

    def tables(self) -> tuple[Table, ...]:
        return tables(self.gears, self.known, self.meshes)

    def curves(self) -> tuple[Curve, ...]:
        return curves(self.gears, self.known)


def play(gears: GearsInputs, train: "TrainResult", materials: Mapping[str, Material], housing: str | None = None) -> Played:
    """`train`: geometry and backlash over the tolerances.  `housing`: the material between the centres, None: it grows as the wheels.

    Raises NoSolution where a tolerance or the cold lets the base circles overlap.
    """
    met = meetings(gears, train)
    known = tuple((m, t.expansions(m, gears, materials, housing)) for m in met)
    last = gears.meshes[-1].driven
    with about("train, running"):
        states = t.states(gears)
    way = b.way_to(last, train.meshes)
    found: dict[str, dict[str, Any]] = {}
    smallest: dict[str, tuple[t.AtState, ...]] = {}
    for m, alpha in known:
        found[m.key] = _kinds(m) | _stacked(m)
        at, smallest[m.key] = _warm(m, alpha, states)
        found[m.key] |= at
    chance = c.by_chance(met, train.wheels, way, last)
    meshes = {m.key: PlayResult(**found[m.key], **c.of_mesh(m, chance)) for m in met}
    whole = _train(train, meshes, way, last, chance)
    judged = tuple(check for m in met for check in checks(gears, m, meshes[m.key], smallest[m.key]))
    return Played(meshes, whole, judged, notes(gears, known, housing, chance is not None), known, gears)


def with_couple(play: TrainPlay, couple: NewtonMetre) -> TrainPlay:
    """The same with what each phase error leaves of a couple that the last wheel should cancel."""
    left: dict[str, NewtonMetre] = {}
    for name, said in (
        ("nominal", "mid-tolerance"),
        ("rss", "root of squares"),
        ("95", "95 % of the trains"),
        ("running", "running temperature"),
    ):
        error = getattr(play, f"phase_error_{name}")
        if error is not None:
            with about(f"train, by its backlash, {said}"):
                left[f"residual_couple_{name}"] = b.residual_couple(couple, error)
    return replace(play, **left)


def _kinds(m: Meeting) -> dict[str, Any]:
    """The backlash at mid-tolerance along other lines, and what is recommended."""
    alpha_wt, beta_b, j_bn = m.mesh.working_pressure_angle, m.system.base_helix_angle, m.mesh.backlash_nominal
    with about(f"mesh {m.name}, backlash at mid-tolerance"):
        j_wt = b.circumferential_of_normal(j_bn=j_bn, alpha_wt=alpha_wt, beta_b=beta_b)
        return dict(
            backlash_circumferential=j_wt,
            backlash_transverse=b.reference_backlash(j_wt=j_wt, d=m.driven.pitch_diameter, d_w=m.mesh.working_diameter_driven),
            backlash_radial=b.radial_backlash(j_wt=j_wt, alpha_wt=alpha_wt),
            backlash_recommended=b.recommended_backlash(a_w=m.mesh.centre_distance, m_n=m.system.m_n),
            play_angle_nominal=b.play_angle_at_base(j_bn=j_bn, beta_b=beta_b, d_b=m.driven.base_diameter),
        )


def _at(m: Meeting, a: Metre) -> Metre:
    """The smallest normal backlash at a centre distance, at 20 °C."""
    d_b1, d_b2 = m.driver.base_diameter, m.driven.base_diameter
    alpha_wt = f.working_pressure_angle(d_b1, d_b2, a)
    s_b1, s_b2 = (teeth.thickest for teeth in m.teeth)
    j = b.backlash_of_bases(
        p_bt=m.system.base_pitch, s_b1=s_b1, s_b2=s_b2, d_b1=d_b1, d_b2=d_b2, alpha_wt=alpha_wt, beta_b=m.system.base_helix_angle
    )
    return b.settled(j)


def _stacked(m: Meeting) -> dict[str, Any]:
    """What the parts between the centres add up to, and what runout takes."""
    values: dict[str, Any] = {}
    a_w = m.mesh.centre_distance
    reach = m.mesh.centre_tolerance
    if m.stack is not None:
        fields, spread = m.stack.fields, m.stack.spread
        with about(f"mesh {m.name}, parts between the centres"):
            T_wc = worst_case(T=fields)
            values = dict(
                centre_tolerance_rss=b.tolerance_of_contributors(T=fields), centre_tolerance_worst=T_wc,
                centre_tolerance_chance=three_deviations(k=spread, T=fields),
            )  # fmt: skip
            reach = max(reach, T_wc)
            m.must_mesh(a_w - reach - m.eccentricity, "the worst case of the parts between the centres, with the runout,")
            values["backlash_min_worst"] = _at(m, b.narrowest(a_w, T_wc))
    if m.runouts:
        with about(f"mesh {m.name}, smallest backlash with runout"):
            m.must_mesh(a_w - reach - m.eccentricity, "the tolerance of the centre distance with the runout")
            values["backlash_min_runout"] = _at(m, m.closest)
    return values


def _warm(m: Meeting, alpha: t.Expansions, states: tuple[t.State, ...]) -> tuple[dict[str, Any], tuple[t.AtState, ...]]:
    """The smallest backlash of every state, and the largest free turn when all is warm."""
    values: dict[str, Any] = {}
    smallest = []
    for state, word in zip(states, ("cold", "running", "warmer")):
        with about(f"mesh {m.name}, smallest backlash, {state.name}"):
            grown = t.grown(m, alpha, state.housing, state.wheels)
            values[f"centre_change_{word}"] = t.change(m, grown)
            at = t.at_state(m, grown, m.closest, *(teeth.thickest for teeth in m.teeth))
        values[f"backlash_{word}"] = at.backlash
        smallest.append(at)
        if word == "running":
            with about(f"mesh {m.name}, largest backlash, {state.name}"):
                a = b.widest(m.mesh.centre_distance, m.mesh.centre_tolerance)
                loose = t.at_state(m, grown, a, *(teeth.thinnest for teeth in m.teeth)).backlash
                values["play_angle_running"] = b.play_angle_at_base(
                    j_bn=loose, beta_b=m.system.base_helix_angle, d_b=m.driven.base_diameter
                )
    return values, tuple(smallest)


def _train(train: "TrainResult", meshes: dict[str, PlayResult], way: list[str], last: str, chance: c.Chance | None) -> TrainPlay:
    """The free turns of all meshes, reduced to the last wheel."""
    wheels = train.wheels
    with about(f"train, to {last}, at mid-tolerance"):
        nominal = b.free_turn(wheels, train.meshes, last, {key: meshes[key].play_angle_nominal for key in way})
    deviations = []
    with about(f"train, to {last}, root of squares"):
        for key in way:
            most, mid = train.meshes[key].play_angle, meshes[key].play_angle_nominal
            if most > 0:
                z = wheels[train.meshes[key].driven].teeth
                deviations.append(deviation_at_shaft(phi_max=most, phi_j=max(mid, 0.0), z=z, z_last=wheels[last].teeth))
        delta: Any = tuple(deviations)
        rooted = phase_error_rss(Delta_phi=nominal, delta=delta)
    with about(f"train, to {last}, running"):
        warm = b.free_turn(wheels, train.meshes, last, {key: meshes[key].play_angle_running for key in way})
    return TrainPlay(phase_error_nominal=nominal, phase_error_rss=rooted, phase_error_running=warm, **c.of_train(last, chance))
