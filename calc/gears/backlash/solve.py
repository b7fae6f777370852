# SPDX-License-Identifier: Apache-2.0
"""The play of a train: what its backlash is over tolerances, chance, runout and temperature, and how far it lets the
last wheel turn."""

from collections.abc import Mapping

from ...library.catalogue import Material
from ...sheet.check import Check
from ...sheet.linked_array import gathered
from ...sheet.record import record, replace
from ...sheet.step import Curve, Table
from ...sheet.text import Text
from ...sheet.units import NewtonMetre
from ...sheet.value import about
from ..inputs import GearsInputs
from ..result import TrainResult
from . import chance as c
from . import formulas as b
from . import temperature as t
from .case import BacklashCase, cases, free_turn, lags, smallest_at
from .checks import JudgedMesh, checks, notes
from .curves import curves, tables
from .formulas import PlayResult, TrainPlay

WAYS = {
    "nominal": Text("mid-tolerance"),
    "rss": Text("root of squares"),
    "95": Text("95 % of the trains"),
    "running": Text("running temperature"),
}


@record
class Played:
    """What `play` gives; tables and curves are made when they are looked at."""

    meshes: dict[str, PlayResult]
    shafts: dict[str, TrainPlay]
    checks: tuple[Check, ...]
    notes: tuple[Text, ...]
    known: tuple[tuple[BacklashCase, t.Expansions], ...]
    gears: GearsInputs

    def tables(self) -> tuple[Table, ...]:
        return tables(self.gears, self.known, self.meshes)

    def curves(self) -> tuple[Curve, ...]:
        return curves(self.gears, self.known)


def play(
    gears: GearsInputs, train: TrainResult, materials: Mapping[str, Material], housing: str | None = None
) -> Played:
    """`train`: geometry and backlash over the tolerances.  `housing`: the material between the centres, None: it grows
    as the wheels.

    Raises NoSolution where a tolerance or the cold lets the base circles overlap.
    """
    meshes_of = cases(gears, train)
    known = tuple((m, t.expansions(m, gears, materials, housing)) for m in meshes_of)
    with about(Text("train, running")):
        states = t.states(gears, gears.warmer)
    values: dict[str, dict[str, float]] = {}
    coats = {mesh.key: mesh.coat for mesh in gears.meshes}
    smallest: dict[str, tuple[t.AtState, ...]] = {}
    for m, alpha in known:
        values[m.key] = _kinds(m) | _stacked(m)
        if (coat := coats[m.key]) is not None:
            with about(Text("mesh {name}, coat", name=m.name)):
                values[m.key]["coat_backlash"] = b.coat_backlash(s_c=coat)
        warm, smallest[m.key] = _warm(m, alpha, states)
        values[m.key] |= warm
    wheels = tuple(dict.fromkeys(turn.wheel for turn in train.shafts.values()))
    chance = c.by_chance(meshes_of, train.tree, wheels, lags(train.stages))
    meshes = {m.key: PlayResult(**values[m.key], **c.of_mesh(m, chance)) for m in meshes_of}
    shafts = {name: _turn(train, meshes, turn.wheel, chance) for name, turn in train.shafts.items()}
    all_checks: list[Check] = []
    for m, alpha in known:
        of = JudgedMesh(m, meshes[m.key], smallest[m.key], t.housings(gears, m, alpha, materials))
        all_checks += checks(gears, of, housing, chance)
    texts = tuple(notes(gears, known, housing, chance is not None))
    return Played(meshes, shafts, tuple(all_checks), texts, known, gears)


def with_couple(play: TrainPlay, couple: NewtonMetre) -> TrainPlay:
    """The same with what each phase error leaves of a couple that the last wheel should cancel."""
    left: dict[str, NewtonMetre] = {}
    for name, words in WAYS.items():
        error = getattr(play, f"phase_error_{name}")
        if error is not None:
            with about(Text("train, by its backlash, {said}", said=words)):
                left[f"residual_couple_{name}"] = b.residual_couple(couple, error)
    return replace(play, **left)


def _kinds(m: BacklashCase) -> dict[str, float]:
    """The backlash at mid-tolerance along other lines, and what is recommended."""
    alpha_wt, beta_b, j_bn = m.mesh.working_pressure_angle, m.system.base_helix_angle, m.mesh.backlash_nominal
    with about(Text("mesh {name}, backlash at mid-tolerance", name=m.name)):
        j_wt = b.circumferential_of_normal(j_bn=j_bn, alpha_wt=alpha_wt, beta_b=beta_b)
        d, d_w = m.driven.reference_diameter, m.mesh.working_diameter_driven
        return dict(
            backlash_circumferential=j_wt,
            backlash_transverse=b.reference_backlash(j_wt=j_wt, d=d, d_w=d_w),
            backlash_per_centre=b.backlash_per_centre(alpha_wt=alpha_wt, beta_b=beta_b),
            backlash_radial=b.radial_backlash(j_wt=j_wt, alpha_wt=alpha_wt),
            backlash_recommended=b.recommended_backlash(a_w=m.mesh.centre_distance, m_n=m.system.m_n),
            play_angle_nominal=b.play_angle_at_base(j_bn=j_bn, beta_b=beta_b, d_b=m.driven.base_diameter),
        )


def _stacked(m: BacklashCase) -> dict[str, float]:
    """What the parts between the centres add up to, and what runout takes."""
    values: dict[str, float] = {}
    a_w = m.mesh.centre_distance
    reach = m.mesh.centre_tolerance
    if m.stack is not None:
        fields, spread = m.stack.fields, m.stack.spread
        with about(Text("mesh {name}, parts between the centres", name=m.name)):
            T_wc = b.worst_case(T=fields)
            values = dict(
                centre_tolerance_rss=b.tolerance_of_contributors(T=fields),
                centre_tolerance_worst=T_wc,
                centre_tolerance_chance=b.three_deviations(k=spread, T=fields),
            )
            reach = max(reach, T_wc)
            m.must_mesh(
                a_w - reach - m.eccentricity, Text("the worst case of the parts between the centres, with the runout,")
            )
            values["backlash_min_worst"] = smallest_at(m, b.narrowest_with_runout(b.narrowest(a_w, T_wc), *m.runouts))
    with about(Text("mesh {name}, smallest backlash with runout", name=m.name)):
        m.must_mesh(a_w - reach - m.eccentricity, Text("the tolerance of the centre distance with the runout"))
        values["backlash_min_runout"] = smallest_at(m, m.closest)
    return values


def _warm(
    m: BacklashCase, alpha: t.Expansions, states: tuple[t.ThermalState, ...]
) -> tuple[dict[str, float], tuple[t.AtState, ...]]:
    """The smallest backlash of every state, and the largest free turn when all is warm."""
    values: dict[str, float] = {}
    smallest = []
    for state, word in zip(states, ("cold", "running", "warmer", "warming")):
        with about(Text("mesh {name}, smallest backlash, {name2}", name=m.name, name2=state.name)):
            grown = t.grown(m, alpha, state.housing, state.wheels)
            values[f"centre_change_{word}"] = t.change(m, grown)
            at = t.at_state(m, grown, m.closest, *(teeth.thickest for teeth in m.teeth))
        values[f"backlash_{word}"] = at.backlash
        smallest.append(at)
        if word == "running":
            with about(Text("mesh {name}, largest backlash, {name2}", name=m.name, name2=state.name)):
                a = b.widest(m.mesh.centre_distance, m.mesh.centre_tolerance)
                loose = t.at_state(m, grown, a, *(teeth.thinnest for teeth in m.teeth)).backlash
                beta_b, d_b = m.system.base_helix_angle, m.driven.base_diameter
                values["play_angle_running"] = b.play_angle_at_base(loose, beta_b, d_b)
    return values, tuple(smallest)


def _turn(train: TrainResult, meshes: dict[str, PlayResult], end: str, chance: c.Chance | None) -> TrainPlay:
    """The free turns of all meshes on the way to a wheel, reduced to it."""
    tree, behind = train.tree, lags(train.stages)
    with about(Text("train, to {last}, at mid-tolerance", last=end)):
        nominal = free_turn(tree, end, {key: play.play_angle_nominal for key, play in meshes.items()}, behind)
    deviations = []
    with about(Text("train, to {last}, root of squares", last=end)):
        for link in (link for link in tree.way(end) if link.toothed):
            most, mid = train.meshes[link.key].play_angle, meshes[link.key].play_angle_nominal
            if most > 0:
                z, z_last = tree.reduction(link, end)
                deviations.append(b.deviation_at_shaft(phi_max=most, phi_j=max(mid, 0.0), z=z, z_last=z_last))
        rooted = b.phase_error_rss(Delta_phi=nominal, delta=gathered(deviations))
    with about(Text("train, to {last}, running", last=end)):
        warm = free_turn(tree, end, {key: play.play_angle_running for key, play in meshes.items()}, behind)
    return TrainPlay(
        phase_error_nominal=nominal, phase_error_rss=rooted, phase_error_running=warm, **c.of_train(end, chance)
    )
