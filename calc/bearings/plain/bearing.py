# SPDX-License-Identifier: Apache-2.0
"""A plain bearing under its load: what its shaft, the power balance and a report ask of a bearing of any kind."""

import math
from collections.abc import Iterator
from contextlib import suppress
from typing import Any, Self

from ...countershaft.bending.formulas import film_stiffness
from ...countershaft.rows import BearingRow, called
from ...library.catalogue import Material
from ...library.lubricant import Lubricant, OilState
from ...sheet.check import Check, CheckRule, Missing
from ...sheet.errors import NoSolution
from ...sheet.quantity import dotted, group, result
from ...sheet.record import replace
from ...sheet.shown import Shown
from ...sheet.text import Amount, Text
from ...sheet.units import Celsius, Kilogram, Metre, Newton, NewtonPerMetre, Radian, RevPerSecond, Watt
from ...sheet.value import about, based_on, untraced
from ..support import Carrying, OnShaftResult, OperatingPoint, StandingLoads, on_bearing
from . import formulas as f
from .as_support import runs_centred
from .checks import ASKED, CLEARANCE, CORE, FILM_EDGE, KREISLE, checks
from .inputs import PlainInputs
from .loads import PRESSED, Response, answered, more_pressed, response, standing, standing_checks
from .materials import application, running_surface
from .result import PlainResult, StandingResult
from .routes.routes import own_warm
from .routes.thermal_balance import balanced
from .seats.checks import pressed_checks
from .speeds import TURNING
from .suitability import LENGTH, application_checks, material_checks

AS_EDGE = Text("As for the film at the edge; or a stiffer core, which bends less, or less clearance, which tilts less.")

FILM_EDGE_TILTED = CheckRule(
    "bearings.B.film_edge_tilted",
    "caution",
    "The shaft goes round in its clearances as a cone: the journal may stand more aslant than by its bending alone.",
    Text("Film at the edge, as the journal tilts in the films"),
    unit="µm",
    source=Text("{kreisle}; the tilt by the places of the journals in their films", kreisle=KREISLE),
    advice=AS_EDGE,
    cause=FILM_EDGE.id,
    value_id=dotted("bearings", "B", OnShaftResult.film_edge_tilted),
    limit_id=ASKED,
    moved_by=(*CLEARANCE, LENGTH, CORE),
)
ALIGNMENT = CheckRule(
    "bearings.B.alignment",
    "caution",
    "Bores that lie off the line of the others load the shaft's bearings, each as far as its tolerance lets it.",
    Text("Film at the edge under the load with that of the bores"),
    unit="µm",
    source=Text("{kreisle}; the load of the bores: statics, a bound", kreisle=KREISLE),
    advice=Text("A closer tolerance of the bores, or more clearance, which gives way."),
    cause=FILM_EDGE.id,
    limit_id=ASKED,
    moved_by=(dotted("bearings", PlainInputs.coaxiality), *CLEARANCE, LENGTH),
)


@result
class TwinBearing(Shown):
    """Of a bearing of a twin what is not its original's."""

    standing: StandingResult = group(spread=True)


@result
class PlainBearing(PlainResult, Carrying):
    """One plain bearing under its load."""

    metal: Material  # around it

    @property
    def row(self) -> BearingRow:
        return self.seat.bearing

    @property
    def speed(self) -> RevPerSecond:
        return self.duty.speed

    @property
    def supply_temperature(self) -> Celsius:
        return self.duty.supply_temperature

    @property
    def supplied(self) -> OilState:
        return self.seat.lubricant.at(self.supply_temperature)

    @property
    def running_clearance(self) -> Metre:
        return self.clearance_hot

    @property
    def least_load(self) -> Newton:
        return self.duty.load if self.seat.centred else 0.0

    def lying(self, lies: OnShaftResult) -> Self:
        return replace(self, on_shaft=lies)

    def checks(self) -> Iterator[Check]:
        place = self.row.name
        yield from checks(place, self, self.metal)
        yield from self._material_checks()

    def slope_effect(self, bent: Radian) -> Text:
        with untraced():
            edge = f.film_at_edge(h_0=self.film, theta=bent, l=self.row.length)
        return Text(
            "then that of the bending: film at the edge {edge}, needs {least}",
            edge=Amount(edge * 1e6, "µm"),
            least=Amount(self.kreisle_film * 1e6, "µm"),
        )

    def way(self) -> tuple[Metre, Radian]:
        e = f.displacement(eps=self.eccentricity, g=self.clearance_hot)
        return (e * (self.load / self.duty.load) if self.seat.centred else e), self.attitude_angle

    def edge_tilted(self, theta: Radian) -> Metre:
        return f.film_at_edge(h_0=self.film, theta=theta, l=self.row.length)

    def out_of_line(self, R_c: Newton) -> Metre | None:
        duty, seat = replace(self.duty, load=f.load_peak(F=self.load, R_0=R_c)), self.seat
        with untraced(), suppress(NoSolution):  # its check fails
            film = balanced(own_warm, replace(seat, centred=seat.centred and runs_centred(seat, duty)), duty).film
            return based_on(film, R_c, self.film)
        return None

    def tilt_checks(self, place: str) -> Iterator[Check]:
        if self.on_shaft is not None and self.row.slope is None and not self.seat.centred:
            yield on_bearing(FILM_EDGE_TILTED, place, self.on_shaft.film_edge_tilted, self.kreisle_film)

    def alignment_checks(self, place: str, missing: Missing | None = None) -> Iterator[Check]:
        if missing is not None:
            yield on_bearing(ALIGNMENT, place, None, self.kreisle_film, missing=missing)
            return
        edge, lies = None, self.on_shaft
        if lies is not None and lies.film_alignment is not None:
            with untraced():
                edge = f.film_at_edge_of_another(h_x=lies.film_alignment, h_0=self.film, h_edge=self.film_edge)
        yield on_bearing(ALIGNMENT, place, edge, self.kreisle_film)

    def seat_size(self) -> Metre:
        rings = self.seat.rings
        return self.row.diameter + (2 * rings.wall if rings is not None else 0.0)

    def pumped(self) -> Watt:
        return self.duty.supply_pressure * self.oil_flow

    def mass(self) -> Kilogram:
        rings = self.seat.rings
        if rings is None:
            return 0.0
        outside, inside = self.seat_size(), self.row.diameter
        return math.pi / 4 * (outside**2 - inside**2) * self.row.length * rings.backing.density

    def spring(self) -> NewtonPerMetre:
        return film_stiffness(K_xx=self.dynamics.stiffness_xx, K_yy=self.dynamics.stiffness_yy)

    def drained(self) -> OilState:
        return self.seat.oil_at(self.outlet_temperature)

    def answer(self, *, turns: bool) -> Response[Any]:
        if turns:
            with about(Text("{place} bearing, over a turn", place=called(self.row.name))):
                return answered(self.beside, self.duty, self.friction_power)
        return Response(load=self.load, friction_power=self.friction_power, slope=0.0, curvature=0.0)

    def answer_at(self, ratio: Any, T: Any, lubricant: Lubricant | None, factor: Any = 1.0) -> Response[Any]:
        turns = self.seat.inputs.load_speed_ratio == TURNING
        duty: OperatingPoint[Any] = self.duty
        duty = replace(
            duty,
            load=duty.load * (ratio**2 if turns else ratio**0) * factor,
            speed=duty.speed * ratio,
            effective_speed=duty.effective_speed * ratio,
            supply_temperature=T,
        )
        return response(self.seat if lubricant is None else replace(self.seat, lubricant=lubricant), duty)

    def under(self, stands: StandingLoads, checks: list[Check], notes: list[Text]) -> tuple[Self, list[Check]]:
        place = self.row.name
        with about(Text("{place} bearing, standing part of the load", place=called(place))):
            part = standing(self, stands.all, place, notes)
            bearing = replace(self, standing=part, seat_=more_pressed(self, part.load_peak))
        checks = [check for check in checks if not (check.rule in PRESSED and f".{place}." in check.id)]
        if bearing.seat_ is not None:
            checks += pressed_checks(place, bearing.seat.bearing, bearing.seat_)
        return bearing, [*checks, *standing_checks(place, bearing, part)]

    def beside_original(self) -> TwinBearing | None:
        return TwinBearing(standing=self.standing) if self.standing is not None else None

    def _material_checks(self) -> Iterator[Check]:
        """Advice by what the journal runs on, and by what bearings of this application usually carry."""
        inputs, bearing = self.seat.inputs, self.seat.bearing
        surface = running_surface(inputs.bush_material, inputs.housing_material)
        if surface is not None and (inputs.bush_material is not None or not bearing.ringed):
            T_in = inputs.supply_temperature
            yield from material_checks(
                self.row.name, surface, self.specific_load, self.pressure_velocity, self.outlet_temperature, T_in
            )
        yield from application_checks(
            self.row.name,
            application(inputs.application),
            p=self.specific_load,
            pv=self.pressure_velocity,
            mu=self.hot.oil.mu,
            mu_n_over_p=self.duty_number,
            psi=self.clearance / bearing.diameter,
            l_over_d=self.length_ratio,
        )
