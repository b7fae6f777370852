# SPDX-License-Identifier: Apache-2.0
"""Backlash of a pair over the tolerance of its centre distance, and what the backlash of a train means for its last wheel.

Runout and temperature are not part of it: they stand in the other files of this folder, which take the same backlash from the
thicknesses at the base circle.
"""

from collections.abc import Mapping

from ...sheet.errors import NoSolution
from ...sheet.text import Text
from ...sheet.trace import about
from ...sheet.units import Metre, Radian
from .. import formulas as f
from ..measures.formulas import generating_shift
from ..result import MeshResult, ToothSystem, WheelResult
from ..words import mm
from . import formulas as b


def backlash(system: ToothSystem, place: str, driver: WheelResult, driven: WheelResult, a_w: Metre, tolerance: Metre) -> dict[str, float]:
    """Normal backlash over the tolerance ± of the centre distance and the allowances of both wheels, and the free turn at the largest.

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
                    Text("{place} = {a_w}: less its tolerance of {tolerance} mm the wheels can not mesh", place=place,
                        a_w=mm(a_w, ".6g"), tolerance=mm(tolerance, ".6g")),
                    advice=Text("give a tolerance_um that leaves the base circles apart"),
                )  # fmt: skip
            smallest, _, _ = _backlash_at(system, pair, closest, upper)
    with about(Text("{subject}, largest backlash", subject=subject)):
        free = b.play_angle(j_wt, d_w2)
    return dict(backlash_min=smallest, backlash_nominal=nominal, backlash_max=largest, play_angle=free)


def _backlash_at(
    system: ToothSystem, pair: tuple[WheelResult, WheelResult], a: Metre, allowances: list[Metre]
) -> tuple[Metre, Metre, Metre]:
    """(j_bn, j_wt, working diameter of the driven wheel) at one centre distance, with one change of the span for each wheel."""
    alpha_wt = f.working_pressure_angle(pair[0].base_diameter, pair[1].base_diameter, a)
    d_w, s_w = [], []
    for wheel, mate, E_W in zip(pair, reversed(pair), allowances):
        x_E = generating_shift(wheel.profile_shift, E_W, system.m_n, system.alpha_n) if E_W else wheel.profile_shift
        d_w.append(f.working_diameter(a, wheel.teeth, mate.teeth))
        s_t = f.reference_thickness(system.m_n, x_E, system.alpha_n, system.beta)
        s_w.append(f.thickness_at(d_w[-1], s_t, wheel.reference_diameter, system.transverse_pressure_angle, alpha_wt))
    j_wt = b.circumferential_backlash(d_w[0], pair[0].teeth, *s_w)
    j_bn = b.normal_backlash(j_wt, alpha_wt, system.base_helix_angle)
    return j_bn, j_wt, d_w[1]


def way_to(last_wheel: str, meshes: Mapping[str, MeshResult]) -> list[str]:
    """Keys of the meshes between the first driver and a wheel, along the flow of power."""
    above = {mesh.driven: key for key, mesh in meshes.items()}
    way: list[str] = []
    while last_wheel in above:
        way.insert(0, above[last_wheel])
        last_wheel = meshes[way[0]].driver
    return way


def backlash_at_shaft(wheels: Mapping[str, WheelResult], meshes: Mapping[str, MeshResult], last_wheel: str) -> Radian:
    """How far the last wheel can turn while the first driver stands: the largest play of every mesh on the way to it."""
    return free_turn(wheels, meshes, last_wheel, {key: mesh.play_angle for key, mesh in meshes.items()})


def free_turn(wheels: Mapping[str, WheelResult], meshes: Mapping[str, MeshResult], last_wheel: str, plays: Mapping[str, Radian]) -> Radian:
    """The free turns of the driven wheels, by mesh, reduced to the last wheel and added up.

    A mesh that is tight adds nothing and takes nothing away.
    """
    angle = b.no_play()
    for key in way_to(last_wheel, meshes):
        if plays[key] > 0:
            angle = b.reduced_play(angle, plays[key], wheels[meshes[key].driven].teeth, wheels[last_wheel].teeth)
    return angle
