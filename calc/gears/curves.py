# SPDX-License-Identifier: Apache-2.0
"""The figures of a gear train, made only when they are looked at."""

import numpy as np

from ..sheet.arrays import Array
from ..sheet.step import Curve, Series
from . import formulas as f
from .profile.outline import Outline, outline, regions
from .result import MeshResult, ToothSystem, TrainResult, WheelResult

MM = 1e3
TEETH, TEETH_BETWEEN = range(-2, 3), range(-2, 2)  # the teeth that are drawn of the driver, and of the driven wheel around them


def curves(train: TrainResult, mesh_key: str | None = None) -> tuple[Curve, ...]:
    """Profiles in mesh and specific sliding of one mesh, and one tooth of each of its wheels.

    `mesh_key` "driver_driven"; left out, the mesh with the least backlash, which is the one to look at.
    """
    key = mesh_key or min(train.meshes, key=lambda k: train.meshes[k].backlash_min)
    mesh = train.meshes[key]
    driver, driven = train.wheels[mesh.driver], train.wheels[mesh.driven]
    return (
        _in_mesh(train.system, key, mesh, driver, driven), _sliding(train.system, key, mesh, driver, driven),
        _tooth(train.system, driver), _tooth(train.system, driven),
    )  # fmt: skip


def pitch_point_view(
    system: ToothSystem, mesh: MeshResult, driver: WheelResult, driven: WheelResult, roll: float = 0.0
) -> tuple[Outline, Outline]:
    """Teeth of both wheels around the pitch point at the origin, driver below; x to the right, y up.

    With `roll` 0 a tooth of the driver stands in the middle of a space of the driven wheel; `roll` turns the driver, anticlockwise.
    Without allowances and at the centre distance without backlash both flanks of that tooth touch.
    """
    below = outline(system, driver, teeth=TEETH) * 1j * np.exp(1j * roll) - 1j * mesh.working_diameter_driver / 2
    half_pitch = np.pi / driven.teeth
    turned = -1j * np.exp(1j * (half_pitch - roll * driver.teeth / driven.teeth))
    above = outline(system, driven, teeth=TEETH_BETWEEN) * turned + 1j * mesh.working_diameter_driven / 2
    return below, above


def _in_mesh(system: ToothSystem, key: str, mesh: MeshResult, driver: WheelResult, driven: WheelResult) -> Curve:
    below, above = pitch_point_view(system, mesh, driver, driven)
    name = f"{mesh.driver}–{mesh.driven}"
    return Curve(
        f"profile_{key}", f"Tooth profiles in mesh, {name}", "x, mm", "y, mm",
        (_line(mesh.driver, below), _line(mesh.driven, above), _line("path of contact", _path(mesh, driver, driven))), equal=True,
    )  # fmt: skip


def _path(mesh: MeshResult, driver: WheelResult, driven: WheelResult) -> Outline:
    """From the driven wheel's tip to the driver's, on the common tangent of the base circles; the driver turns clockwise."""
    ends = np.array([mesh.sap_curvature_driver, mesh.line_of_action - mesh.sap_curvature_driven])
    pitch_point = mesh.line_of_action * driver.teeth / (driver.teeth + driven.teeth)
    path: Outline = (ends - pitch_point) * np.exp(1j * mesh.working_pressure_angle)
    return path


def _line(label: str, points: Outline) -> Series:
    return Series(label, points.real * MM, points.imag * MM)


def _tooth(system: ToothSystem, wheel: WheelResult) -> Curve:
    flank = regions(system, wheel)
    series = []
    for label, (radius, angle) in (("root", flank.root), ("fillet", flank.fillet), ("involute", flank.involute), ("tip", flank.tip)):
        series.append(_line(label, 1j * radius * np.exp(-1j * angle)))
    return Curve(f"tooth_{wheel.name}", f"Half a tooth of {wheel.name}", "x, mm", "y, mm", tuple(series), equal=True)


def _sliding(system: ToothSystem, key: str, mesh: MeshResult, driver: WheelResult, driven: WheelResult) -> Curve:
    """ζ of both wheels along the path of contact, over its way from the pitch point."""
    T = mesh.line_of_action
    rho: Array = np.linspace(mesh.sap_curvature_driver, T - mesh.sap_curvature_driven, 121)
    way = (rho - T * driver.teeth / (driver.teeth + driven.teeth)) * MM
    zeta_1 = f.specific_sliding(T, rho, driver.teeth, driven.teeth)  # type: ignore[arg-type]
    zeta_2 = f.specific_sliding(T, T - rho, driven.teeth, driver.teeth)  # type: ignore[arg-type]
    return Curve(
        f"sliding_{key}", f"Specific sliding, {mesh.driver}–{mesh.driven}", "way on the line of action from the pitch point, mm", "ζ",
        (Series(mesh.driver, way, zeta_1), Series(mesh.driven, way, zeta_2)), limits=(("rolling", 0.0),),
    )  # fmt: skip
