# SPDX-License-Identifier: Apache-2.0
"""The bearings of a balance shaft in a model of REXS: plain ones with what brings their oil, and rolling ones."""

from ..bearings.plain.bearing import PlainBearing
from ..bearings.rolling.bearing import RollingBearing
from ..countershaft.rows import BearingRow
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import PI, Metre
from .rexs_file import Component, Content
from .rexs_unit import GearUnit

TYPES = {"ball": "radial_grooved_ball_bearing", "roller": "radial_roller_bearing"}
NEEDLES = "radial_needle_roller_bearing"
ROUND = 0.0, 2 * PI  # of a groove that goes all round
NO_ARC = Text("{bearing}: its groove begins and ends at angles from the load, which turns: they are left out.")


@record
class BearingPlace:
    """Where a bearing sits: on which shaft, how far from its front end, and its place in the gear unit."""

    shaft: Component
    of: str  # the name of that shaft
    u: Metre
    pose: dict[str, Content]


def add_bearing(unit: GearUnit, row: BearingRow, seat: BearingPlace) -> None:
    name = row.name if len(unit.design.resolved) == 1 else f"{seat.of} {row.name}"
    outcome = unit.results.view(seat.of).outcomes.get("bearings")
    found = getattr(outcome.result, "bearings", {}).get(row.name) if outcome is not None else None
    bearing = (_rolling if row.kind == "rolling" else _plain)(unit, name, row, seat, found)
    unit.model.relate("side", assembly=bearing, inner_part=seat.shaft, outer_part=unit.casing)


def _plain(unit: GearUnit, name: str, row: BearingRow, seat: BearingPlace, found: object) -> Component:
    given = unit.design.bearings.of(row) if unit.design.bearings is not None else None
    film = found if isinstance(found, PlainBearing) else None
    d, width = row.place() or (None, None)
    bearing = unit.model.add(
        "hydrodynamic_radial_plain_bearing",
        name,
        diameter_clearance_plain_bearing=film.clearance if film else None,
        relative_clearance_plain_bearing=film.clearance / d if film and d else None,
        reference_diameter_relative_clearance_plain_bearing=d if film else None,
        feed_pressure_plain_bearing=given.supply_pressure if given else None,
        lubricant_feed_temperature=given.supply_temperature if given else None,
        lubricant_flow_through_bearing=film.oil_flow if film else None,
        relative_eccentricity_plain_bearing=film.eccentricity if film else None,
        u_coordinate_on_shaft_inner_side=seat.u,
        inner_diameter=d,
        width=width,
        **seat.pose,
    )
    if unit.bearing_oil is not None:
        unit.model.relate("reference", origin=bearing, referenced=unit.bearing_oil)
    if given is not None:
        _supply(unit, name, bearing, given.supply, given.groove_width, given.groove_arc)
    return bearing


def _supply(
    unit: GearUnit,
    name: str,
    bearing: Component,
    supply: str | None,
    groove_width: Metre | None,
    groove_arc: tuple[float, ...] | None,
) -> None:
    if supply == "groove":
        begins, ends = ROUND if groove_arc is None else (None, None)
        if groove_arc is not None:
            unit.notes.append(Text(NO_ARC, bearing=name))
        feature = unit.model.add(
            "radial_plain_bearing_groove",
            "oil groove",
            axial_position_of_plain_bearing_feature=0.0,
            width=groove_width,
            starting_angle_plain_bearing_feature=begins,
            end_angle_plain_bearing_feature=ends,
            is_pressurized=True,
            lubricant_side="outer_side",
        )
    elif supply in ("hole", "shaft"):
        feature = unit.model.add(
            "radial_plain_bearing_hole",
            "oil hole",
            axial_position_of_plain_bearing_feature=0.0,
            is_pressurized=True,
            lubricant_side="inner_side" if supply == "shaft" else "outer_side",
        )
    else:
        if supply is not None:
            unit.notes.append(Text("{bearing}: the pocket of its oil is left out.", bearing=name))
        return
    unit.model.relate("assembly", assembly=bearing, part=feature)


def _rolling(unit: GearUnit, name: str, row: BearingRow, seat: BearingPlace, found: object) -> Component:
    size, solved = row.outline, found if isinstance(found, RollingBearing) else None
    return unit.model.add(
        "rolling_bearing_with_catalog_geometry",
        name,
        catalogue_designation=size.designation if size is not None and not size.own else None,
        bearing_type=TYPES.get(size.type, NEEDLES) if size is not None else None,
        outer_diameter=size.outside if size is not None else None,
        radial_dynamic_load_rating=solved.dynamic_rating if solved else row.dynamic_rating,
        radial_static_load_rating=solved.static_rating if solved else row.static_rating,
        axial_force_absorption="both_directions" if size is not None and size.type == "ball" else "no_direction",
        radial_force_absorption=True,
        u_coordinate_on_shaft_inner_side=seat.u,
        inner_diameter=size.bore if size is not None else None,
        width=size.width if size is not None else None,
        **seat.pose,
    )
