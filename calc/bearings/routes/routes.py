# SPDX-License-Identifier: Apache-2.0
"""Four routes to the film, side by side: one function each, from an assumed temperature rise to the one that it makes.

The own solution of Reynolds' equation judges; the others are shown beside it on the clearance as given.  `balance` closes the loop.
"""

from collections.abc import Callable
from typing import Any, cast

import numpy as np

from ...lubricant import State
from ...sheet.errors import NoSolution
from .. import formulas as f
from ..film import short_bearing as short
from ..film.table import eccentricity_from, film_at
from ..film.tabulated import attitude_angle, eccentricity, pressure_ratio, relative_flow, side_flow_share
from . import din31652 as din
from . import flow, supply
from . import raimondi_boyd as rb
from .states import Duty, Film, Seat, Seized

Route = Callable[[Seat, Duty, float], Film]


def own_cold(seat: Seat, duty: Duty, rise: float) -> Film:
    """The program's own solution of Reynolds' equation on the clearance as given, to compare with the source's methods."""
    return _own(seat, duty, rise, warm=False)


def own_warm(seat: Seat, duty: Duty, rise: float) -> Film:
    """The program's own solution on the clearance at the film's mean temperature: what the design is judged by."""
    return _own(seat, duty, rise, warm=True)


def _own(seat: Seat, duty: Duty, rise: float, warm: bool) -> Film:
    """Numbers: what has no film raises (Seized, FilmRangeError).  Arrays: it is nan."""
    b, inputs = seat.bearing, seat.inputs
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.oil_at(T)
    g = seat.clearance_at(T) if warm else seat.clearance
    # a groove in the loaded half parts the bearing into two lands, each with half the load
    lands = supply.lands(inputs)
    l = b.length if lands == 1 else (b.length - (inputs.groove_width or 0.0)) / 2
    p = f.specific_load(F=duty.load if lands == 1 else duty.load / lands, d=b.diameter, l=l)
    ratio = f.length_ratio(l=l, d=b.diameter)
    one = isinstance(rise, float)
    if one and g <= 0:
        raise Seized(f"the bearing is seized at {T:.0f} °C: its clearance is {g * 1e6:.1f} µm")
    psi = f.relative_clearance(g=g, d=b.diameter)
    S = f.sommerfeld(mu=oil.mu, n_h=duty.effective_speed, p=p, psi=psi)
    So = f.sommerfeld_din(p=p, psi=psi, mu=oil.mu, omega=f.angular_speed(n=duty.effective_speed))
    if one:
        eps = eccentricity(S=S, b=ratio)
        phi, Q_rel, share = attitude_angle(eps=eps, b=ratio), relative_flow(eps=eps, b=ratio), side_flow_share(eps=eps, b=ratio)
        p_rel = pressure_ratio(eps=eps, b=ratio)
    else:
        many: Any = np.where(np.asarray(g) > 0, S, np.nan)
        eps = cast(Any, eccentricity_from(many, ratio, outside="nan"))
        state: Any = film_at(eps, ratio, outside="nan")
        phi, Q_rel, share, p_rel = state.attitude, state.flow, state.side_flow_ratio, state.pressure_ratio
    f_v = _friction_variable(duty, So, eps, phi)
    Q_1 = flow.side_flow(Q_rel=Q_rel, share=share, d=b.diameter, g=g, n_h=duty.effective_speed, l=l) if lands == 1 else None
    return _film(seat, duty, T, oil, g, psi, p, S, eps, f.film(g=g, eps=eps), f_v, Q_1, phi, f.largest_pressure(p=p, ratio=p_rel))


def raimondi_boyd(seat: Seat, duty: Duty, rise: float) -> Film:
    """The source's first method: charts of 1958 by its l/d formula, flow of a groove over the full length, clearance as given."""
    b, g = seat.bearing, seat.clearance
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.oil_at(T)
    psi = f.relative_clearance(g=g, d=b.diameter)
    p = f.specific_load(F=duty.load, d=b.diameter, l=b.length)
    S = f.sommerfeld(mu=oil.mu, n_h=duty.effective_speed, p=p, psi=psi)
    ratio = f.length_ratio(l=b.length, d=b.diameter)
    eps = f.eccentricity_of_relative_film(h_rel=rb.relative_film(S=S, b=ratio))
    f_v = rb.friction_variable(S=S, b=ratio)
    h_0 = f.film(g=g, eps=eps)
    Q = flow.groove_flow_of_finotti(p_s=duty.supply_pressure, d=b.diameter, g=g, eps=eps, mu=oil.mu, l=b.length)
    return _closing(seat, duty, T, oil, g, psi, p, S, eps, h_0, f_v, Q)


def din31652(seat: Seat, duty: Duty, rise: float) -> Film:
    """The source's second method: Falz's film, friction polynomial, a hole always opposite the load, clearance as given."""
    b, g = seat.bearing, seat.clearance
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.oil_at(T)
    psi = f.relative_clearance(g=g, d=b.diameter)
    p = f.specific_load(F=duty.load, d=b.diameter, l=b.length)
    omega = f.angular_speed(n=duty.effective_speed)
    So = f.sommerfeld_din(p=p, psi=psi, mu=oil.mu, omega=omega)
    ratio = f.length_ratio(l=b.length, d=b.diameter)
    h_0 = din.film(g=g, So=So, b=ratio)
    eps = f.eccentricity_of_film(h_0=h_0, g=g)
    if not 0 <= eps < 1:
        raise rb.OutsideCharts(f"Falz's film is {h_0 * 1e6:.1f} µm in a gap of {g / 2e-6:.1f} µm at So = {So:.3g}, l/d = {ratio:.3g}")
    mu_f = None
    if din.polynomial_holds(ratio):
        _, mu_f = din.friction(psi=psi, So=So, b=ratio)
        f_v = f.friction_variable_of(f=mu_f, psi=psi)
    else:
        f_v = f.friction_variable(So=So, eps=eps, phi=attitude_angle(eps=eps, b=ratio))
    Q_1 = flow.side_flow_din(d=b.diameter, psi=psi, omega=omega, q_1=flow.side_flow_factor(b=ratio, eps=eps))
    return _film(seat, duty, T, oil, g, psi, p, So, eps, h_0, f_v, Q_1, mu_f=mu_f, opposite=True)


def short_bearing(seat: Seat, duty: Duty, rise: float) -> Film:
    """The limit of a bearing without length (Ocvirk), clearance as given: a check of the other routes, good to l/d of about ½."""
    b, inputs, g = seat.bearing, seat.inputs, seat.clearance
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.oil_at(T)
    psi = f.relative_clearance(g=g, d=b.diameter)
    lands = supply.lands(inputs)
    l = b.length if lands == 1 else (b.length - (inputs.groove_width or 0.0)) / 2
    p = f.specific_load(F=duty.load if lands == 1 else duty.load / lands, d=b.diameter, l=l)
    S = f.sommerfeld(mu=oil.mu, n_h=duty.effective_speed, p=p, psi=psi)
    So = f.sommerfeld_din(p=p, psi=psi, mu=oil.mu, omega=f.angular_speed(n=duty.effective_speed))
    ratio = f.length_ratio(l=l, d=b.diameter)
    eps = short.eccentricity(S=S, b=ratio)
    phi = short.attitude_angle(eps=eps)
    f_v = _friction_variable(duty, So, eps, phi)
    Q_rel, share = short.relative_flow(eps=eps), short.side_flow_share(eps=eps)
    Q_1 = flow.side_flow(Q_rel=Q_rel, share=share, d=b.diameter, g=g, n_h=duty.effective_speed, l=l) if lands == 1 else None
    return _film(seat, duty, T, oil, g, psi, p, S, eps, f.film(g=g, eps=eps), f_v, Q_1, phi)


def _friction_variable(duty: Duty, So: float, eps: float, phi: float) -> float:
    if isinstance(duty.sliding_ratio, float) and duty.sliding_ratio == 1.0:
        return f.friction_variable(So=So, eps=eps, phi=phi)
    return f.friction_variable_sliding(So=So, eps=eps, phi=phi, k_s=duty.sliding_ratio)


def _film(
    seat: Seat, duty: Duty, T: float, oil: State, g: float, psi: float, p: float, S: float, eps: float, h_0: float, f_v: float,
    Q_1: float | None, phi: float | None = None, p_max: float | None = None, *, mu_f: float | None = None, opposite: bool = False,
) -> Film:  # fmt: skip
    """Flow and heat of a state.  `Q_1` None: both lands of a groove are fed by the supply pressure alone."""
    Q_2 = supply.supply_flow(seat, duty, psi, eps, oil, opposite=opposite)
    Q = Q_2 if Q_1 is None else flow.total_flow(Q_1=Q_1, Q_2=Q_2)
    return _closing(seat, duty, T, oil, g, psi, p, S, eps, h_0, f_v, Q, phi, p_max, Q_1, Q_2, mu_f)


def _closing(
    seat: Seat, duty: Duty, T: float, oil: State, g: float, psi: float, p: float, S: float, eps: float, h_0: float, f_v: float, Q: float,
    phi: float | None = None, p_max: float | None = None, Q_1: float | None = None, Q_2: float | None = None,
    mu_f: float | None = None,
) -> Film:  # fmt: skip
    if mu_f is None:
        mu_f = f.friction_coefficient(psi=psi, f_v=f_v)
    power = f.friction_power(f=mu_f, F=duty.load, u=f.surface_speed(d=seat.bearing.diameter, n=duty.effective_speed))
    if isinstance(Q, float) and Q <= 0:
        raise NoSolution("no oil flows through the bearing", "supply pressure 0", "raise the supply pressure")
    made = f.temperature_rise(P_f=power, rho=oil.rho, c_p=oil.cp, Q=Q)
    return Film(g, psi, p, S, eps, h_0, mu_f, f_v, power, Q, made, T, oil, phi, p_max, Q_1, Q_2)
