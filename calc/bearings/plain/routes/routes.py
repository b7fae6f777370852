# SPDX-License-Identifier: Apache-2.0
"""The routes to the film, side by side: one function each, from an assumed temperature rise to the one that it makes.

The own solution of Reynolds' equation judges; the others are shown beside it on the clearance as given.
`thermal_balance` closes the loop.  What is known of a route stands above its function (`@bearing_route`); the table,
the notes, the spread and what is published read it there, in the order in which the functions stand here."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ....library.journal_rules import specific_load
from ....library.lubricant import OilState
from ....sheet.errors import NoSolution
from ....sheet.record import record, replace
from ....sheet.text import COMMA, EMPTY, Amount, Name, Text
from ....sheet.value import based_on, recorder
from .. import formulas as f
from ..film import grooved, table
from ..film import short_bearing as short
from . import din31652, flow, supply
from . import raimondi_boyd as rb
from .states import BearingCase, Film, OperatingPoint, OutsideCharts, Seized

Route = Callable[[BearingCase[Any], OperatingPoint[Any], Any], Film[Any]]
WhyOff = Callable[[Film, float], Text]
FALZ_MEETS = 1.0  # l/d at which Falz's two branches meet
SHORT_UP_TO, SHORT_ECCENTRICITY = 0.25, 0.5  # where the short bearing stays within a tenth in the load


@record
class BearingRoute:
    """What is known of a route.  Films come with their l/d.

    `name`: that of its values, `bearings.front.NAME.film`; `former`: the name that it had.  `brief`: its title between
    the parts of an id.  `why_off`: why its film may be far off at the same oil.  `counts`: where it claims to solve the
    film, so that the spread counts it.  `whole_length`: it takes the bearing's, where a groove parts the film.
    `listed`: its place among the published values, whose order programs may rely on; a new route comes last."""

    name: str
    title: Text
    film: Route
    why_off: WhyOff
    counts: Callable[[Film, float], bool]
    whole_length: bool
    brief: Text
    former: str
    listed: int


ROUTES: dict[str, BearingRoute] = {}


def nowhere(film: Film, ratio: float) -> bool:
    return False


def everywhere(film: Film, ratio: float) -> bool:
    return True


def bearing_route(
    name: str,
    title: Text,
    *,
    why_off: WhyOff,
    counts: Callable[[Film, float], bool] = nowhere,
    whole_length: bool = False,
    brief: Text = EMPTY,
    former: str = "",
    listed: int = 100,
) -> Callable[[Route], Route]:
    """Declares the function below it as a route that is shown beside the own one, which stands first."""

    def declared(film: Route) -> Route:
        ROUTES[name] = BearingRoute(name, title, film, why_off, counts, whole_length, brief or title, former, listed)
        return film

    return declared


def _cubic_errs(film: Film, ratio: float) -> Text:
    l_d = Amount(ratio, form=".3g")
    return Text("its cubic in d/l errs between the charts of l/d 1, ½, ¼: l/d is {ratio}", ratio=l_d)


def _fit_errs(film: Film, ratio: float) -> Text:
    return Text(
        "its fit of So errs by up to a tenth between B/D {fitted} and 1: B/D is {ratio}",
        fitted=din31652.FITTED_UP_TO,
        ratio=Amount(ratio, form=".3g"),
    )


def _is_short(film: Film, ratio: float) -> bool:
    return ratio <= SHORT_UP_TO and film.eccentricity <= SHORT_ECCENTRICITY


def _leaves_flow_out(film: Film, ratio: float) -> Text:
    parts = []
    if ratio > SHORT_UP_TO:
        l_d, most = Amount(ratio, form=".3g"), Amount(SHORT_UP_TO, form="g")
        parts.append(Text("l/d {ratio} is above {short_up_to}", ratio=l_d, short_up_to=most))
    if film.eccentricity > SHORT_ECCENTRICITY:
        eps, most = Amount(film.eccentricity, form=".3g"), Amount(SHORT_ECCENTRICITY, form="g")
        parts.append(Text("ε {eccentricity} above {short_eccentricity}", eccentricity=eps, short_eccentricity=most))
    why = COMMA.join(parts) if parts else Text("its film is too thick")
    return Text("it leaves the pressure's flow around the shaft out: {parts}", parts=why)


def _branches_meet_once(film: Film, ratio: float) -> Text:
    return Text(
        "Falz's two branches meet only at l/d = {falz_meets}: l/d is {ratio}, So = {sommerfeld} lies {branch} 1",
        falz_meets=Amount(FALZ_MEETS, form="g"),
        ratio=Amount(ratio, form=".3g"),
        sommerfeld=Amount(film.sommerfeld, form=".3g"),
        branch=Text("above") if film.sommerfeld > 1 else Text("below"),
    )


@bearing_route(
    "reynolds", Text("Reynolds' equation"), brief=Name("Reynolds"), why_off=lambda film, ratio: EMPTY, listed=0
)
def own_cold(seat: BearingCase[Any], duty: OperatingPoint[Any], rise: Any) -> Film[Any]:
    """The program's own solution of Reynolds' equation on the clearance as given, to compare with the source's
    methods."""
    return _reynolds(seat, duty, rise, warm=False)


def own_warm(seat: BearingCase[Any], duty: OperatingPoint[Any], rise: Any) -> Film[Any]:
    """The program's own solution on the clearance at the film's mean temperature: what the design is judged by."""
    return _reynolds(seat, duty, rise, warm=True)


def _reynolds(
    seat: BearingCase[Any], duty: OperatingPoint[Any], rise: Any, *, warm: bool, without_length: bool = False
) -> Film[Any]:
    """By the table, or `without_length` in closed form.  Numbers: what has no film raises (Seized, FilmRangeError).
    Arrays: it is nan."""
    b = seat.bearing
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.oil_at(T)
    g = seat.running_clearance(T) if warm else seat.clearance
    lands, l, p = _land(seat, duty)
    ratio = f.length_ratio(l=l, d=b.diameter)
    one_point = isinstance(rise, float)
    if one_point and g <= 0:
        hot, gap = Amount(T, form=".0f"), Amount(g * 1e6, form=".1f")
        raise Seized(Text("the bearing is seized at {t} °C: its clearance is {g} µm", t=hot, g=gap))
    psi = f.relative_clearance(g=g, d=b.diameter)
    if seat.centred:
        F_c = table.centred_load(mu=oil.mu, n_h=duty.effective_speed, d=b.diameter, l=l, psi=psi, b=ratio)
        duty = replace(duty, load=based_on(lands * F_c, F_c))
        lands, l, p = _land(seat, duty)
    S = f.sommerfeld(mu=oil.mu, n_h=duty.effective_speed, p=p, psi=psi)
    So = f.sommerfeld_din(p=p, psi=psi, mu=oil.mu, omega=f.angular_speed(n=duty.effective_speed))
    eps: Any
    p_rel = Q_1 = None
    if seat.grooves is not None and not without_length:
        eps, phi, Q_rel, p_rel, land = _between_grooves(seat, seat.grooves, S, g, ratio)
        f_v = f.friction_variable_grooved(So=So, eps=eps, phi=phi, k_s=duty.sliding_ratio, land=land)
        Q_1 = flow.side_flow_grooved(Q_rel=Q_rel, d=b.diameter, g=g, n_h=duty.effective_speed, l=l)
    else:
        if without_length:
            eps = short.eccentricity(S=S, b=ratio)
            phi, Q_rel = short.attitude_angle(eps=eps), short.relative_flow(eps=eps)
            share = short.side_flow_share(eps=eps)
        elif one_point and recorder.get() is not None:
            eps = table.eccentricity(S=S, b=ratio)
            phi, Q_rel = table.attitude_angle(eps=eps, b=ratio), table.relative_flow(eps=eps, b=ratio)
            share, p_rel = table.side_flow_share(eps=eps, b=ratio), table.pressure_ratio(eps=eps, b=ratio)
        else:
            outside: table.Outside = "raise" if one_point else "nan"
            eps = table.eccentricity_from(S if one_point else np.where(g > 0, S, np.nan), ratio, outside=outside)
            phi, Q_rel, share, p_rel = table.film_parts(eps, ratio, outside=outside)
        f_v = _friction_variable(duty, So, eps, phi)
        if lands == 1:
            Q_1 = flow.side_flow(Q_rel=Q_rel, share=share, d=b.diameter, g=g, n_h=duty.effective_speed, l=l)
    h_0 = f.film(g=g, eps=eps)
    p_max = None if p_rel is None else f.largest_pressure(p=p, ratio=p_rel)
    return _film(seat, duty, T, oil, g, psi, p, S, eps, h_0, f_v, Q_1, phi, p_max)


def _between_grooves(seat: BearingCase, grooves: grooved.Feeds, S: Any, g: Any, ratio: Any) -> tuple[Any, ...]:
    """ε, φ, relative side flow, p/p_max and the share that is sheared, between axial grooves; one l/d, any number of
    states."""
    if isinstance(S, float):
        i = seat.inputs
        b = based_on(ratio, ratio, i.axial_groove_angles, i.axial_groove_width, i.axial_groove_length)
        eps: Any = grooved.eccentricity(S=S, b=b, grooves=grooves)
        return (
            eps,
            grooved.attitude_angle(eps=eps, b=b, grooves=grooves),
            grooved.relative_side_flow(eps=eps, b=b, grooves=grooves),
            grooved.pressure_ratio(eps=eps, b=b, grooves=grooves),
            grooved.sheared_share(eps=eps, b=b, grooves=grooves),
        )
    ratios = np.unique(np.asarray(ratio))
    if ratios.size != 1:
        what = Text("axial grooves are not searched over lengths and diameters")
        raise NoSolution(what, EMPTY, Text("choose sizes with a hole"))
    eps = grooved.eccentricity_from(np.where(np.asarray(g) > 0, S, np.nan), ratios.item(), grooves, outside="nan")
    state = grooved.film_at(eps, ratios.item(), grooves)
    return eps, state.attitude, state.side_flow, state.pressure_ratio, state.sheared


@bearing_route(
    "raimondi_boyd_own_flow", Text("Raimondi & Boyd, own flow"), counts=everywhere, why_off=_cubic_errs, listed=2
)
def raimondi_boyd_own_flow(seat: BearingCase, duty: OperatingPoint, rise: float) -> Film:
    """Raimondi and Boyd's own way: the same charts, of each land where a groove parts the film, and the oil that the
    turning film draws in, whatever the supply pressure."""
    return _by_charts(seat, duty, rise, own_flow=True)


@bearing_route(
    "raimondi_boyd",
    Text("Raimondi & Boyd, supply flow of the thesis"),
    brief=Name("Raimondi & Boyd"),
    why_off=_cubic_errs,
    whole_length=True,
    listed=1,
)
def raimondi_boyd(seat: BearingCase, duty: OperatingPoint, rise: float) -> Film:
    """The source's first method: charts of 1958 by their l/d formula, flow of a groove over the full length, clearance
    as given.

    Without supply pressure, the charts' own flow."""
    return _by_charts(seat, duty, rise, own_flow=False)


def _by_charts(seat: BearingCase, duty: OperatingPoint, rise: float, *, own_flow: bool) -> Film:
    b, g = seat.bearing, seat.clearance
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.oil_at(T)
    psi = f.relative_clearance(g=g, d=b.diameter)
    lands, l, p = _land(seat, duty) if own_flow else (1, b.length, specific_load(F=duty.load, d=b.diameter, l=b.length))
    S = f.sommerfeld(mu=oil.mu, n_h=duty.effective_speed, p=p, psi=psi)
    ratio = f.length_ratio(l=l, d=b.diameter)
    eps = f.eccentricity_of_relative_film(h_rel=rb.relative_film(S=S, b=ratio))
    f_v, phi = rb.friction_variable(S=S, b=ratio), rb.attitude_angle(S=S, b=ratio)
    h_0 = f.film(g=g, eps=eps)
    p_max = f.largest_pressure(p=p, ratio=rb.pressure_ratio(S=S, b=ratio))
    if not own_flow and duty.supply_pressure > 0:
        Q = flow.groove_flow_of_finotti(p_s=duty.supply_pressure, d=b.diameter, g=g, eps=eps, mu=oil.mu, l=b.length)
        return _film(seat, duty, T, oil, g, psi, p, S, eps, h_0, f_v, None, phi, p_max, Q=Q)
    Q_rel, bare = rb.relative_flow(S=S, b=ratio), l if lands == 1 else lands * l
    Q = rb.film_flow(Q_rel=Q_rel, d=b.diameter, g=g, n_h=duty.effective_speed, l=bare)
    Q_s = rb.side_flow(share=rb.side_flow_share(S=S, b=ratio), Q=Q)
    return _film(seat, duty, T, oil, g, psi, p, S, eps, h_0, f_v, Q_s, phi, p_max, Q=Q, drawn_in=True)


@bearing_route("iso7902", Text("ISO 7902"), counts=everywhere, why_off=_fit_errs, listed=3)
def iso7902(seat: BearingCase, duty: OperatingPoint, rise: float) -> Film:
    """ISO 7902: both flows, by geometry and by supply pressure, as the own solution has the supply; clearance as
    given."""
    b, g = seat.bearing, seat.clearance
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.oil_at(T)
    psi = f.relative_clearance(g=g, d=b.diameter)
    lands, l, p = _land(seat, duty)
    omega = f.angular_speed(n=duty.effective_speed)
    So = f.sommerfeld_din(p=p, psi=psi, mu=oil.mu, omega=omega)
    ratio = f.length_ratio(l=l, d=b.diameter)
    eps = din31652.eccentricity(So=So, b=ratio)
    beta = din31652.attitude_angle(eps=eps, b=ratio)
    f_v = _friction_variable(duty, So, eps, beta)
    Q_1 = None
    if lands == 1:
        Q_1 = flow.side_flow_din(d=b.diameter, psi=psi, omega=omega, q_1=flow.side_flow_factor(b=ratio, eps=eps))
    return _film(seat, duty, T, oil, g, psi, p, So, eps, f.film(g=g, eps=eps), f_v, Q_1, beta)


@bearing_route("short_bearing", Text("short bearing"), counts=_is_short, why_off=_leaves_flow_out, listed=5)
def short_bearing(seat: BearingCase, duty: OperatingPoint, rise: float) -> Film:
    """The limit of a bearing without length (Ocvirk), clearance as given: a check of the other routes, good to l/d of
    about ½."""
    return _reynolds(seat, duty, rise, warm=False, without_length=True)


@bearing_route(
    "falz",
    Text("Falz, as the thesis uses it"),
    brief=Name("Falz"),
    why_off=_branches_meet_once,  # a rule of thumb, which claims to solve no film
    whole_length=True,
    former="din31652",
    listed=4,
)
def falz(seat: BearingCase, duty: OperatingPoint, rise: float) -> Film:
    """The source's second method: Falz's film, friction polynomial, a hole always opposite the load, clearance as
    given."""
    b, g = seat.bearing, seat.clearance
    T = f.mean_temperature(T_in=duty.supply_temperature, Delta_T=rise)
    oil = seat.oil_at(T)
    psi = f.relative_clearance(g=g, d=b.diameter)
    p = specific_load(F=duty.load, d=b.diameter, l=b.length)
    omega = f.angular_speed(n=duty.effective_speed)
    So = f.sommerfeld_din(p=p, psi=psi, mu=oil.mu, omega=omega)
    ratio = f.length_ratio(l=b.length, d=b.diameter)
    h_0 = din31652.film(g=g, So=So, b=ratio)
    eps = f.eccentricity_of_film(h_0=h_0, g=g)
    if not 0 <= eps < 1:
        least, gap = Amount(h_0 * 1e6, form=".1f"), Amount(g / 2e-6, form=".1f")
        load, b_d = Amount(So, form=".3g"), Amount(ratio, form=".3g")
        raise OutsideCharts(
            Text(
                "Falz's film is {h_0} µm in a gap of {g} µm at So = {so}, l/d = {ratio}",
                h_0=least,
                g=gap,
                so=load,
                ratio=b_d,
            )
        )
    mu_f = None
    if din31652.polynomial_holds(ratio):
        _, mu_f = din31652.friction(psi=psi, So=So, b=ratio)
        f_v = f.friction_variable_of(f=mu_f, psi=psi)
    else:
        f_v = f.friction_variable(So=So, eps=eps, phi=table.attitude_angle(eps=eps, b=ratio))
    Q_1 = flow.side_flow_din(d=b.diameter, psi=psi, omega=omega, q_1=flow.side_flow_factor(b=ratio, eps=eps))
    return _film(seat, duty, T, oil, g, psi, p, So, eps, h_0, f_v, Q_1, mu_f=mu_f, opposite=True)


def _land(seat: BearingCase, duty: OperatingPoint) -> tuple[int, float, float]:
    """Number, length and specific load of the lands: a groove in the loaded half parts the bearing into two, each with
    half the load."""
    b, inputs = seat.bearing, seat.inputs
    lands, l, load = supply.lands(inputs), b.length, duty.load
    if lands == 2:
        l = based_on((b.length - (inputs.groove_width or 0.0)) / 2, b.length, inputs.groove_width)
        load = based_on(duty.load / 2, duty.load, inputs.groove_arc)
    return lands, l, specific_load(F=load, d=b.diameter, l=l)


def _friction_variable(duty: OperatingPoint, So: float, eps: float, phi: float) -> float:
    if isinstance(duty.sliding_ratio, float) and duty.sliding_ratio == 1.0:
        return f.friction_variable(So=So, eps=eps, phi=phi)
    return f.friction_variable_sliding(So=So, eps=eps, phi=phi, k_s=duty.sliding_ratio)


def _film(
    seat: BearingCase,
    duty: OperatingPoint,
    T: float,
    oil: OilState[Any],
    g: float,
    psi: float,
    p: float,
    S: float,
    eps: float,
    h_0: float,
    f_v: float,
    Q_1: float | None,
    phi: float | None = None,
    p_max: float | None = None,
    *,
    mu_f: float | None = None,
    Q: float | None = None,
    opposite: bool = False,
    drawn_in: bool = False,
) -> Film:
    """Flow and heat of a state.  `Q`: where the route has it as a whole; `Q_1` None: both lands of a groove are fed by
    the supply pressure alone; `drawn_in`: Q is what the film draws in, and Q_1 leaves on the way."""
    Q_2 = None
    if Q is None:
        Q_2 = supply.supply_flow(seat, duty, psi, eps, oil, opposite=opposite)
        Q = Q_2 if Q_1 is None else flow.total_flow(Q_1=Q_1, Q_2=Q_2)
    if mu_f is None:
        mu_f = f.friction_coefficient(psi=psi, f_v=f_v)
    power = f.friction_power(f=mu_f, F=duty.load, u=f.surface_speed(d=seat.bearing.diameter, n=duty.effective_speed))
    if isinstance(Q, float) and Q <= 0:
        what, advice = Text("no oil flows through the bearing"), Text("raise the supply pressure")
        raise NoSolution(what, Text("supply pressure 0"), advice)
    if drawn_in and Q_1 is not None:
        heated = rb.temperature_rise(P_f=power, rho=oil.rho, c_p=oil.cp, Q=Q, Q_s=Q_1)
    else:
        heated = f.temperature_rise(P_f=power, rho=oil.rho, c_p=oil.cp, Q=Q)
    return Film(
        clearance=g,
        relative_clearance=psi,
        specific_load=p,
        sommerfeld=S,
        eccentricity=eps,
        film=h_0,
        friction_coefficient=mu_f,
        friction_variable=f_v,
        friction_power=power,
        oil_flow=Q,
        temperature_rise=heated,
        mean_temperature=T,
        oil=oil,
        attitude=phi,
        largest_pressure=p_max,
        side_flow=Q_1,
        supply_flow=Q_2,
    )
