# SPDX-License-Identifier: Apache-2.0
"""One mesh with all that its backlash depends on, and its backlash over the tolerance of the centre distance.

It depends on both wheels, their teeth at the base circle, runout, and the parts between the centres.

Whatever its kind, a part between the centres moves them by at most half its field.  The kinds differ in how it is
spread over that: the zone of a position is a circle, filled evenly; the wheel rests on the wall of its clearance,
somewhere; an eccentricity points anywhere; a radial shift lies evenly between its ends.  Only the part along the line
of centres counts: a direction at random is a projection."""

from collections.abc import Mapping
from functools import cached_property
from math import sqrt

import numpy as np

from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.linked_array import column, gathered
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, Radian
from ...sheet.value import about
from .. import formulas as f
from ..inputs import GearsInputs, Mesh
from ..limits import mm
from ..measures.formulas import generating_shift
from ..result import MeshResult, ToothSystem, TrainResult, WheelResult
from ..stages import StageResult
from ..tree import Tree
from ..wheel_inputs import Wheel
from . import formulas as b

# standard deviation over the largest shift
SPREAD = {"position": 1 / 2, "fit": 1 / sqrt(2), "runout": 1 / sqrt(2), "radial": 1 / sqrt(3)}
EVEN = "radial"  # how a field of no kind, or a bare tolerance, is spread


@record
class Stack:
    """Fields of the parts of one mesh, each with its kind."""

    names: tuple[str, ...]
    kinds: tuple[str, ...]
    fields: Array  # (parts,): it knows its links

    @property
    def spread(self) -> Array:
        """(parts,): standard deviation of each part over half its field."""
        return np.array([SPREAD[kind] for kind in self.kinds])


def stack_of(mesh: Mesh) -> Stack | None:
    """None where the parts are not given."""
    if mesh.stack:
        return Stack(tuple(c.name for c in mesh.stack), tuple(c.kind for c in mesh.stack), column(mesh.stack, "field"))
    if mesh.contributors:
        names = tuple(Text("part {i}", i=i + 1) for i in range(len(mesh.contributors)))
        return Stack(names, (EVEN,) * len(names), gathered(mesh.contributors))
    return None


def centre_tolerance(mesh: Mesh) -> Metre:
    """± tolerance of the centre distance by which a mesh is judged: given, else the root of squares of its parts, else
    none."""
    if mesh.tolerance is not None:
        return mesh.tolerance
    stack = stack_of(mesh)
    return 0.0 if stack is None else b.tolerance_of_contributors(stack.fields)


@record
class Teeth:
    """Transverse thickness at the base circle of a wheel, over its allowance."""

    thickest: Metre
    middle: Metre
    thinnest: Metre


@record
class BacklashCase:
    key: str
    name: str  # driver–driven
    index: int  # of the mesh in the design
    system: ToothSystem
    inputs: Mesh
    mesh: MeshResult
    driver: WheelResult
    driven: WheelResult
    teeth: tuple[Teeth, Teeth]
    runouts: tuple[Metre, Metre]  # given, else of the accuracy grade
    given_runouts: tuple[Metre | None, Metre | None]
    stack: Stack | None
    closest: Metre  # the smallest centre distance within the tolerance and the runout

    @property
    def place(self) -> str:
        return f"gears.meshes.{self.index}"

    @cached_property
    def touching(self) -> Metre:
        """The centre distance at which the base circles would touch."""
        return (self.driver.base_diameter + self.driven.base_diameter) / 2

    @property
    def eccentricity(self) -> Metre:
        return sum(self.runouts) / 2

    @property
    def least_eccentricity(self) -> Metre:
        """By the runouts that are given alone."""
        return sum(F_r or 0.0 for F_r in self.given_runouts) / 2

    def must_mesh(self, a: Metre, by: str) -> None:
        """Nothing can be said of wheels whose base circles overlap."""
        if a <= self.touching:
            raise NoSolution(
                Text(
                    "{place}: {by} leaves {a} mm between {name} and {name2}: they can not mesh",
                    place=self.place,
                    by=by,
                    a=mm(a, ".6g"),
                    name=self.driver.name,
                    name2=self.driven.name,
                ),
                advice=Text(
                    "smaller fields: the centre distance must stay above {touching} mm, where the base circles touch",
                    touching=mm(self.touching, ".6g"),
                ),
            )


def cases(gears: GearsInputs, train: TrainResult) -> list[BacklashCase]:
    """Every mesh of the train, in the order of the inputs."""
    wanted = {w.name: w for w in gears.wheels}
    teeth = {name: _teeth(train.system, wheel) for name, wheel in train.wheels.items()}
    runout = {w.name: _runout(gears, train, w) for w in gears.wheels}
    cases = []
    for i, (inputs, (key, mesh)) in enumerate(zip(gears.meshes, train.meshes.items())):
        driver, driven = train.wheels[mesh.driver], train.wheels[mesh.driven]
        runouts = runout[mesh.driver], runout[mesh.driven]
        given = wanted[mesh.driver].runout, wanted[mesh.driven].runout
        with about(Text("mesh {name}, centres at their closest", name=mesh.title)):
            closest = b.narrowest_with_runout(b.narrowest(mesh.centre_distance, mesh.centre_tolerance), *runouts)
        both, stack, name = (teeth[mesh.driver], teeth[mesh.driven]), stack_of(inputs), mesh.title
        m = BacklashCase(key, name, i, train.system, inputs, mesh, driver, driven, both, runouts, given, stack, closest)
        cases.append(m)
    return cases


def _runout(gears: GearsInputs, train: TrainResult, given: Wheel) -> Metre:
    """Given, else of the accuracy grade."""
    if given.runout is not None:
        return given.runout
    with about(Text("wheel {name}", name=given.name)):
        d = train.wheels[given.name].reference_diameter
        return b.runout_of_grade(m_n=train.system.m_n, d=d, A=gears.accuracy_grade)


def smallest_at(m: BacklashCase, a: Metre) -> Metre:
    """The smallest normal backlash at a centre distance, at 20 °C."""
    d_b1, d_b2 = m.driver.base_diameter, m.driven.base_diameter
    alpha_wt = f.working_pressure_angle(d_b1, d_b2, a)
    s_b1, s_b2 = (teeth.thickest for teeth in m.teeth)
    return b.backlash_of_bases(m.system.base_pitch, s_b1, s_b2, d_b1, d_b2, alpha_wt, m.system.base_helix_angle)


def _teeth(system: ToothSystem, wheel: WheelResult) -> Teeth:
    def thickness(E_W: Metre) -> Metre:
        return b.base_thickness(
            d_b=wheel.base_diameter,
            s_t=wheel.reference_thickness,
            d=wheel.reference_diameter,
            alpha_t=system.transverse_pressure_angle,
            E_W=E_W,
            beta_b=system.base_helix_angle,
        )

    if wheel.allowance is None:
        with about(Text("wheel {name}", name=wheel.name)):
            s_b = thickness(0.0)
        return Teeth(s_b, s_b, s_b)
    upper, lower = wheel.allowance
    ends = []
    for tooth, E_W in ((Text("thickest"), upper), (Text("middle"), None), (Text("thinnest"), lower)):
        with about(Text("wheel {name}, {tooth} tooth", name=wheel.name, tooth=tooth)):
            ends.append(thickness(b.middle_allowance(upper, lower) if E_W is None else E_W))
    return Teeth(*ends)


# --- backlash over the tolerance of the centre distance, and what that of a train means for its last wheel
# Runout and temperature are not part of it; they take the same backlash from the thicknesses at the base circle.


def backlash(
    system: ToothSystem, place: str, driver: WheelResult, driven: WheelResult, a_w: Metre, tolerance: Metre
) -> dict[str, float]:
    """Normal backlash over the tolerance ± of the centre distance and the allowances of both wheels, and the free turn
    at the largest.

    `place`: where the centre distance stands in the design.
    """
    pair = driver, driven
    subject = Text("mesh {name}–{name2}", name=driver.name, name2=driven.name)
    upper, lower = ([w.allowance[end] if w.allowance else 0.0 for w in pair] for end in (0, 1))
    with about(Text("{subject}, backlash at mid-tolerance", subject=subject)):
        middle = [b.middle_allowance(*w.allowance) if w.allowance else 0.0 for w in pair]
        nominal, j_wt, d_w2 = _backlash_at(system, pair, a_w, middle)
    smallest = largest = nominal
    if tolerance or any(upper) or any(lower):
        with about(Text("{subject}, largest backlash", subject=subject)):
            largest, j_wt, d_w2 = _backlash_at(system, pair, b.widest(a_w, tolerance), lower)
        with about(Text("{subject}, smallest backlash", subject=subject)):
            closest = b.narrowest(a_w, tolerance)
            if closest <= (driver.base_diameter + driven.base_diameter) / 2:
                raise NoSolution(
                    Text(
                        "{place} = {a_w}: less its tolerance of {tolerance} mm the wheels can not mesh",
                        place=place,
                        a_w=mm(a_w, ".6g"),
                        tolerance=mm(tolerance, ".6g"),
                    ),
                    advice=Text("give a tolerance_um that leaves the base circles apart"),
                )
            smallest, _, _ = _backlash_at(system, pair, closest, upper)
    with about(Text("{subject}, largest backlash", subject=subject)):
        free = b.play_angle(j_wt, d_w2)
    return dict(backlash_min=smallest, backlash_nominal=nominal, backlash_max=largest, play_angle=free)


def _backlash_at(
    system: ToothSystem, pair: tuple[WheelResult, WheelResult], a: Metre, allowances: list[Metre]
) -> tuple[Metre, Metre, Metre]:
    """(j_bn, j_wt, working diameter of the driven wheel) at one centre distance, with one change of the span for each
    wheel."""
    alpha_wt = f.working_pressure_angle(pair[0].base_diameter, pair[1].base_diameter, a)
    d_w, s_w = [], []
    for wheel, mate, E_W in zip(pair, reversed(pair), allowances):
        x_E = generating_shift(wheel.profile_shift, E_W, system.m_n, system.alpha_n) if E_W else wheel.profile_shift
        d_w.append(f.working_diameter(a, wheel.teeth, mate.teeth))
        s_t = f.reference_thickness(system.m_n, x_E, system.alpha_n, system.beta)
        s_w.append(f.thickness_at(d_w[-1], s_t, wheel.reference_diameter, system.transverse_pressure_angle, alpha_wt))
    j_wt = b.circumferential_backlash(d_w[0], pair[0].teeth, s_w[0], s_w[1])
    j_bn = b.normal_backlash(j_wt, alpha_wt, system.base_helix_angle)
    return j_bn, j_wt, d_w[1]


def free_turn(tree: Tree, end: str, plays: Mapping[str, Radian], lags: Mapping[str, Radian]) -> Radian:
    """The free turns of the driven wheels, by mesh, and the lags behind chains and belts, by stage, reduced to the
    wheel `end` and added up.

    A mesh that is tight adds nothing and takes nothing away.  A worn chain lags by the whole of its elongation in every
    train."""
    angle = b.no_play()
    for link in tree.way(end):
        turn = plays[link.key] if link.toothed else lags.get(link.key, 0.0)
        if turn > 0:
            z, z_end = tree.reduction(link, end)
            angle = b.reduced_play(angle, turn, z, z_end)
    return angle


def lags(stages: Mapping[str, StageResult]) -> dict[str, Radian]:
    """By how much the chains and belts of which it is known let their driven sprocket stay behind."""
    return {name: stage.phase_error for name, stage in stages.items() if stage.phase_error is not None}
