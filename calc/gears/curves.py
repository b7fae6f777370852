# SPDX-License-Identifier: Apache-2.0
"""The figures of a gear train: every mesh with tip circles and path of contact, one tooth of each wheel of one mesh,
sliding."""

import numpy as np

from ..sheet.arrays import Array
from ..sheet.step import Curve, Series, axis_label
from ..sheet.text import EMPTY, Name, Text
from ..sheet.units import Metre, Radian
from . import formulas as f
from .profile.outline import Outline, Regions, regions, repeated, whole_tooth
from .result import MeshResult, TrainResult, WheelResult

MM = 1e3
# the teeth that are drawn of the driver, and of the driven wheel around them
TEETH, TEETH_BETWEEN = (range(-2, 3), range(-2, 2))
DRAWN = 1e-3  # chord error of a figure in modules, rule of this program: finer than a line is wide
ARC = 41  # points of a tip circle, which is drawn over two pitches
ALONG = 61  # points of a curve of sliding


def curves(train: TrainResult, mesh_key: str | None = None) -> tuple[Curve, ...]:
    """First one mesh: profiles in mesh, sliding (of all meshes, this one first), one tooth of each of its wheels; then
    the other meshes.

    `mesh_key` "driver_driven"; left out, the mesh with the least backlash, which is the one to look at.
    """
    if not train.meshes:  # chains alone
        return ()
    key = mesh_key or min(train.meshes, key=lambda k: train.meshes[k].backlash_min)
    chosen = train.meshes[key]
    flanks = {name: regions(train.system, wheel, DRAWN * train.system.m_n) for name, wheel in train.wheels.items()}
    order = [key, *(other for other in train.meshes if other != key)]
    first, *others = (_in_mesh(train, each, flanks) for each in order)
    teeth = (_tooth(name, flanks[name]) for name in (chosen.driver, chosen.driven))
    return first, _sliding(train, order), *teeth, *others


def pitch_point_view(
    mesh: MeshResult, below: tuple[WheelResult, Regions], above: tuple[WheelResult, Regions], roll: Radian = 0.0
) -> tuple[Outline, Outline]:
    """Teeth of both wheels around the pitch point at the origin, driver below; x to the right, y up.

    With `roll` 0 a tooth of the driver stands in the middle of a space of the driven wheel; `roll` turns the driver,
    anticlockwise. Without allowances and at the centre distance without backlash both flanks of that tooth touch."""
    (driver, driver_regions), (driven, mate) = below, above
    turned = 1j * np.exp(1j * roll)
    under = repeated(whole_tooth(driver_regions), driver.teeth, TEETH) * turned - 1j * mesh.working_diameter_driver / 2
    turned = -1j * np.exp(1j * (np.pi / driven.teeth - roll * driver.teeth / driven.teeth))
    over = repeated(whole_tooth(mate), driven.teeth, TEETH_BETWEEN) * turned + 1j * mesh.working_diameter_driven / 2
    return under, over


def _in_mesh(train: TrainResult, key: str, flanks: dict[str, Regions]) -> Curve:
    mesh = train.meshes[key]
    driver, driven = train.wheels[mesh.driver], train.wheels[mesh.driven]
    below, above = pitch_point_view(mesh, (driver, flanks[driver.name]), (driven, flanks[driven.name]))
    return Curve(
        f"profile_{key}",
        Text("Tooth profiles in mesh, {pair}", pair=mesh.title),
        axis_label("x", "mm"),
        axis_label("y", "mm"),
        (
            _line(Name(mesh.driver), below),
            _line(Name(mesh.driven), above),
            _line(
                Text("tip circle of {driver}", driver=mesh.driver),
                _tips(driver, -1j * mesh.working_diameter_driver / 2),
            ),
            _line(
                Text("tip circle of {driven}", driven=mesh.driven), _tips(driven, 1j * mesh.working_diameter_driven / 2)
            ),
            _line(Text("path of contact"), _path(mesh, driver, driven)),
        ),
        equal=True,
    )


def _tips(wheel: WheelResult, centre: complex) -> Outline:
    """The tip circle from a pitch before the pitch point to a pitch behind it, which is more than the path of contact
    takes."""
    pitch = 2 * np.pi / wheel.teeth
    towards = -centre / abs(centre)
    arc: Outline = centre + towards * wheel.tip_diameter / 2 * np.exp(1j * np.linspace(-pitch, pitch, ARC))
    return arc


def _path(mesh: MeshResult, driver: WheelResult, driven: WheelResult) -> Outline:
    """From the driven wheel's tip to the driver's, on the common tangent of the base circles; the driver turns
    clockwise."""
    ends = np.array([mesh.sap_curvature_driver, mesh.line_of_action - mesh.sap_curvature_driven])
    path: Outline = (ends - _pitch_point(mesh, driver, driven)) * np.exp(1j * mesh.working_pressure_angle)
    return path


def _pitch_point(mesh: MeshResult, driver: WheelResult, driven: WheelResult) -> Metre:
    """Its place on the line of action, from the driver's base circle."""
    return mesh.line_of_action * driver.teeth / (driver.teeth + driven.teeth)


def _line(label: Text, points: Outline) -> Series:
    return Series(label, points.real * MM, points.imag * MM)


def _tooth(name: str, flank: Regions) -> Curve:
    """One whole tooth, upright: the regions of its right flank, and its left flank as one line."""
    parts = (
        (Text("root"), flank.root),
        (Text("fillet"), flank.fillet),
        (Text("involute"), flank.involute),
        (Text("tip"), flank.tip),
    )
    right = [1j * radius * np.exp(-1j * angle) for _, (radius, angle) in parts]
    series = [_line(label, points) for (label, _), points in zip(parts, right)]
    series.append(_line(Text("other flank"), -np.concatenate(right).conj()))
    return Curve(
        f"tooth_{name}",
        Text("One tooth of {name}", name=name),
        axis_label("x", "mm"),
        axis_label("y", "mm"),
        tuple(series),
        equal=True,
    )


def _sliding(train: TrainResult, keys: list[str]) -> Curve:
    """ζ of both wheels along the path of contact, over its way from the pitch point; each mesh is a variant, if there
    are several."""
    titles = [Name(train.meshes[key].title) for key in keys]
    variants = tuple(titles) if len(keys) > 1 else ()
    series = []
    for mesh, variant in zip((train.meshes[key] for key in keys), variants or (EMPTY,)):
        driver, driven = train.wheels[mesh.driver], train.wheels[mesh.driven]
        z_1, z_2, T = driver.teeth, driven.teeth, mesh.line_of_action
        rho: Array = np.linspace(mesh.sap_curvature_driver, T - mesh.sap_curvature_driven, ALONG)
        way = (rho - _pitch_point(mesh, driver, driven)) * MM
        zeta_1 = f.specific_sliding(T, rho, z_1, z_2)
        zeta_2 = f.specific_sliding(T, T - rho, z_2, z_1)
        series += [Series(Name(mesh.driver), way, zeta_1, variant), Series(Name(mesh.driven), way, zeta_2, variant)]
    title = Text("Specific sliding") if variants else Text("Specific sliding, {said}", said=titles[0])
    along = axis_label("way on the line of action from the pitch point", "mm")
    return Curve("sliding", title, along, Text("ζ"), tuple(series), limits=((Text("rolling"), 0.0),), variants=variants)
