# SPDX-License-Identifier: Apache-2.0
"""The routes to the film: one function each, from an assumed temperature rise to the one that follows; `balanced` closes the loop."""

from collections.abc import Callable
from functools import cache

from ..lubricant import Lubricant, State
from ..root import root
from ..sheet.errors import NoSolution
from ..sheet.record import record
from ..sheet.trace import untraced
from . import din31652 as din
from . import flow
from . import formulas as f
from . import raimondi_boyd as rb
from .film_table import FilmRangeError
from .inputs import BearingInputs, BearingsInputs
from .tabulated import attitude_angle, eccentricity, pressure_ratio, relative_flow, side_flow_share


@record
class Seat:
    """One bearing with all that decides its film but speed, load and supply."""

    bearing: BearingInputs
    inputs: BearingsInputs
    lubricant: Lubricant
    clearance: float  # at the reference temperature
    journal_expansion: float
    housing_expansion: float

    def clearance_at(self, T: float) -> float:
        return f.clearance_at(
            g=self.clearance, d=self.bearing.diameter, alpha_H=self.housing_expansion, chi=self.inputs.expansion_restraint,
            alpha_J=self.journal_expansion, T=T, T_ref=self.inputs.clearance_reference_temperature,
        )  # fmt: skip


@record
class Duty:
    """What a bearing has to do at one moment: load, journal speed and hydrodynamic speed, oil supply."""

    load: float
    speed: float
    effective_speed: float
    supply_temperature: float
    supply_pressure: float


@record
class Film:
    """The state of a film, and the temperature rise that its friction and its flow make."""

    clearance: float
    relative_clearance: float
    sommerfeld: float
    eccentricity: float
    film: float
    friction_coefficient: float
    friction_variable: float
    friction_power: float
    oil_flow: float
    temperature_rise: float
    mean_temperature: float
    oil: State
    attitude: float | None = None
    largest_pressure: float | None = None


class Seized(ValueError):
    """The journal has no clearance left at this temperature."""


class OutsideBalance(ValueError):
    """The heat of the film is not carried away at any temperature that is looked at."""


Route = Callable[[Seat, Duty, float], Film]
HOTTEST = 200.0  # K above the supply: no rise beyond is looked for


def own_cold(seat: Seat, duty: Duty, rise: float) -> Film:
    """The program's own solution of Reynolds' equation on the clearance as given, to compare with the source's methods."""
    return _own(seat, duty, rise, warm=False)


def own_warm(seat: Seat, duty: Duty, rise: float) -> Film:
    """The program's own solution on the clearance at the film's mean temperature: what the design is judged by."""
    return _own(seat, duty, rise, warm=True)


def _own(seat: Seat, duty: Duty, rise: float, warm: bool) -> Film:
    b, inputs = seat.bearing, seat.inputs
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.lubricant.at(T)
    g = seat.clearance_at(T) if warm else seat.clearance
    if g <= 0:
        raise Seized(f"the bearing is seized at {T:.0f} °C: its clearance is {g * 1e6:.1f} µm")
    # a full groove parts the bearing into two lands, each with half the load
    lands, l = (2, (b.length - (inputs.groove_width or 0.0)) / 2) if inputs.supply == "groove" else (1, b.length)
    psi = f.relative_clearance(g=g, d=b.diameter)
    p = f.specific_load(F=duty.load if lands == 1 else duty.load / lands, d=b.diameter, l=l)
    S = f.sommerfeld(mu=oil.mu, n_h=duty.effective_speed, p=p, psi=psi)
    So = f.sommerfeld_din(p=p, psi=psi, mu=oil.mu, omega=f.angular_speed(n=duty.effective_speed))
    ratio = f.length_ratio(l=l, d=b.diameter)
    eps = eccentricity(S=S, b=ratio)
    phi = attitude_angle(eps=eps, b=ratio)
    h_0 = f.film(g=g, eps=eps)
    f_v = f.friction_variable(So=So, eps=eps, phi=phi)
    mu_f = f.friction_coefficient(psi=psi, f_v=f_v)
    power = f.friction_power(f=mu_f, F=duty.load, u=f.surface_speed(d=b.diameter, n=duty.effective_speed))
    q_2, p_s = _supply(seat, duty, eps, oil)
    Q_2 = flow.supply_flow(d=b.diameter, psi=psi, p_s=p_s, mu=oil.mu, q_2=q_2)
    if inputs.supply == "groove":
        Q = Q_2
    else:
        Q_1 = flow.side_flow(
            Q_rel=relative_flow(eps=eps, b=ratio), share=side_flow_share(eps=eps, b=ratio), d=b.diameter, g=g, n_h=duty.effective_speed, l=l
        )
        Q = flow.total_flow(Q_1=Q_1, Q_2=Q_2)
    made = f.temperature_rise(P_f=power, rho=oil.rho, c_p=oil.cp, Q=_flowing(Q))
    p_max = f.largest_pressure(p=p, ratio=pressure_ratio(eps=eps, b=ratio))
    return Film(g, psi, S, eps, h_0, mu_f, f_v, power, Q, made, T, oil, phi, p_max)


def _flowing(Q: float) -> float:
    if Q <= 0:
        raise NoSolution("no oil flows through the bearing", "supply pressure 0", "raise the supply pressure")
    return Q


def _supply(seat: Seat, duty: Duty, eps: float, oil: State, standing_rule: bool = False) -> tuple[float, float]:
    """The factor q₂ of the oil supply and the pressure that drives it.

    The load turns with the shaft, so a hole or pocket in the seat is swept by it.  `standing_rule`: as the source has it, a hole
    that is always opposite the load.
    """
    b, inputs = seat.bearing, seat.inputs
    if inputs.supply == "groove":
        return flow.groove_factor(eps=eps, d=b.diameter, l=b.length, b_G=inputs.groove_width or 0.0), duty.supply_pressure
    p_s = duty.supply_pressure
    E = flow.opposite(eps=eps) if inputs.supply == "shaft" or standing_rule else flow.swept(eps=eps)
    if inputs.supply == "shaft" and not standing_rule:
        p_s = flow.pressure_through_shaft(p_s=p_s, rho=oil.rho, omega=f.angular_speed(n=duty.speed), d=b.diameter)
        if p_s <= 0:
            raise NoSolution(
                "no oil reaches the bearing through the shaft", f"centrifugal head {(duty.supply_pressure - p_s) / 1e5:.2f} bar",
                "raise the supply pressure or feed through the seat",
            )  # fmt: skip
    if inputs.supply == "pocket":
        width = inputs.pocket_width or 0.0
        return flow.supply_factor(E=E, l=b.length, b=width, q=flow.pocket_factor(x=width / b.length)), p_s
    width = inputs.hole_diameter or 0.0
    return flow.supply_factor(E=E, l=b.length, b=width, q=flow.hole_factor(x=width / b.length)), p_s


def raimondi_boyd(seat: Seat, duty: Duty, rise: float) -> Film:
    """The source's first method: charts of 1958 by its l/d formula, flow of a groove over the full length, clearance as given."""
    b, g = seat.bearing, seat.clearance
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.lubricant.at(T)
    psi = f.relative_clearance(g=g, d=b.diameter)
    p = f.specific_load(F=duty.load, d=b.diameter, l=b.length)
    S = f.sommerfeld(mu=oil.mu, n_h=duty.effective_speed, p=p, psi=psi)
    ratio = f.length_ratio(l=b.length, d=b.diameter)
    eps = f.eccentricity_of_relative_film(h_rel=rb.relative_film(S=S, b=ratio))
    f_v = rb.friction_variable(S=S, b=ratio)
    h_0 = f.film(g=g, eps=eps)
    mu_f = f.friction_coefficient(psi=psi, f_v=f_v)
    power = f.friction_power(f=mu_f, F=duty.load, u=f.surface_speed(d=b.diameter, n=duty.effective_speed))
    Q = flow.groove_flow_of_finotti(p_s=duty.supply_pressure, d=b.diameter, g=g, eps=eps, mu=oil.mu, l=b.length)
    made = f.temperature_rise(P_f=power, rho=oil.rho, c_p=oil.cp, Q=_flowing(Q))
    return Film(g, psi, S, eps, h_0, mu_f, f_v, power, Q, made, T, oil)


def din31652(seat: Seat, duty: Duty, rise: float, film: Callable[..., float] = din.film) -> Film:
    """The source's second method: Falz's film, friction polynomial, a hole always opposite the load, clearance as given."""
    b, g = seat.bearing, seat.clearance
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.lubricant.at(T)
    psi = f.relative_clearance(g=g, d=b.diameter)
    p = f.specific_load(F=duty.load, d=b.diameter, l=b.length)
    omega = f.angular_speed(n=duty.effective_speed)
    So = f.sommerfeld_din(p=p, psi=psi, mu=oil.mu, omega=omega)
    ratio = f.length_ratio(l=b.length, d=b.diameter)
    h_0 = film(g=g, So=So, b=ratio)
    eps = f.eccentricity_of_film(h_0=h_0, g=g)
    if not 0 <= eps < 1:
        raise rb.OutsideCharts(f"Falz's film is {h_0 * 1e6:.1f} µm in a gap of {g / 2e-6:.1f} µm at So = {So:.3g}, l/d = {ratio:.3g}")
    if din.polynomial_holds(ratio):
        _, mu_f = din.friction(psi=psi, So=So, b=ratio)
        f_v = f.friction_variable_of(f=mu_f, psi=psi)
    else:
        f_v = f.friction_variable(So=So, eps=eps, phi=attitude_angle(eps=eps, b=ratio))
        mu_f = f.friction_coefficient(psi=psi, f_v=f_v)
    power = f.friction_power(f=mu_f, F=duty.load, u=f.surface_speed(d=b.diameter, n=duty.effective_speed))
    q_2, p_s = _supply(seat, duty, eps, oil, standing_rule=True)
    Q_2 = flow.supply_flow(d=b.diameter, psi=psi, p_s=p_s, mu=oil.mu, q_2=q_2)
    Q = flow.total_flow(Q_1=flow.side_flow_din(d=b.diameter, psi=psi, omega=omega, q_1=flow.side_flow_factor(b=ratio, eps=eps)), Q_2=Q_2)
    made = f.temperature_rise(P_f=power, rho=oil.rho, c_p=oil.cp, Q=_flowing(Q))
    return Film(g, psi, So, eps, h_0, mu_f, f_v, power, Q, made, T, oil)


def balanced(route: Route, seat: Seat, duty: Duty, tolerance: float = 1e-10) -> Film:
    """The film whose heat leaves with the oil: the rise that a route makes is the rise it was given.  Only this state is traced.

    The difference falls with the assumed rise, so that a bracket finds the one answer.  Raises NoSolution where the load can not be
    carried, with what was tried, or where the rise passes 200 K.
    """

    @cache  # the ends of the bracket are asked for more than once
    def excess(rise: float) -> float:
        return route(seat, duty, rise).temperature_rise - rise

    with untraced():
        try:
            high = min(2 * excess(0.0) + 1e-6, HOTTEST)
            rise = root(excess, 0.0, _reachable(excess, high), tolerance=tolerance)
        except (FilmRangeError, Seized, OutsideBalance) as error:
            raise NoSolution(*_reason(duty, error)) from None
    return route(seat, duty, rise)


def _reason(duty: Duty, error: ValueError) -> tuple[str, str, str]:
    """What was looked for, what came out, and what to do: too much load, too little, or a bearing too short or long."""
    at = f"{duty.load:.4g} N at {duty.speed * 60:.4g} rpm"
    if isinstance(error, Seized):
        return str(error), f"under {at}", "give it more clearance"
    if isinstance(error, FilmRangeError) and "l/d" in error.quantity:
        return f"the film of this bearing is not in the table ({error})", f"under {at}", "choose a length between 0.1 and 2 diameters"
    if isinstance(error, FilmRangeError) and error.value > error.high:
        return (
            f"the journal runs nearly centred under {at}",
            str(error),
            "the load is too small for this clearance and oil: more clearance, or a thinner or warmer oil",
        )
    return f"no film carries {at}", str(error), "lower the load, lengthen the bearing, or take a thicker oil"


def _reachable(excess: Callable[[float], float], high: float) -> float:
    """An upper end of the bracket at which the route still has an answer and the excess is negative."""
    low = 0.0
    for _ in range(40):
        try:
            if excess(high) <= 0:
                return high
            low, high = high, min(2 * high, HOTTEST)
            if low == HOTTEST:
                raise OutsideBalance(f"the oil would warm by more than {HOTTEST:g} K")
        except (FilmRangeError, Seized):
            high = (low + high) / 2
    raise OutsideBalance("the film breaks down before its heat is carried away")
