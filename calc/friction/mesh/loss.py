# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""The power that one mesh loses: friction along the path summed over all lines in contact, and rolling.

In order: the formulas, what rolling costs, one mesh solved, many operating points at once.

`case` takes a mesh at its speed with its oil, `solve_mesh` the power that it carries.  Speed, power, temperature and
what is assumed of oil and flanks may be arrays: N operating points in one call, whose results are arrays of N."""

from collections.abc import Callable
from dataclasses import field
from typing import Any, Generic, TypeVar

import numpy as np

from ...library import contact
from ...library.lubricant import Lubricant
from ...sheet.arrays import Array, Num, Value
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import along, single_or_many, sqrt
from ...sheet.quantity import result, value
from ...sheet.record import record, replace
from ...sheet.shown import Shown
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.units import (
    Celsius,
    CelsiusArray,
    Kelvin,
    Metre,
    MetrePerSecond,
    Metres,
    MetresPerSecond,
    NewtonsPerMetre,
    Number,
    Numbers,
    Pascal,
    Pascals,
    PascalSecond,
    PerPascal,
    Watt,
    WattPerMetre,
    WattsPerMetre,
)
from ...sheet.value import converged, recorder, unlinked, untraced
from ..inputs import FrictionInputs
from .film import MeshFilm, Oil, film, oil_at
from .geometry import MeshGeometry, column, flat, require
from .mixed import THESIS, Surfaces, surfaces_of
from .path import Motion, Path, line_load, motion, path, transverse_force
from .traction import HOTTEST, Traction, place, skin_temperature, traction

# --- every formula, once


@formula(
    "P_s",
    Text("{thesis}, eq. 3: mean over a mesh cycle of the friction power of all lines in contact", thesis=THESIS),
    names={"s": "Δs", "mu": "μ_z"},
    meanings={"s": "Length of line for which a position stands"},
)
def sliding_loss(s: Metres, mu: Numbers, w: NewtonsPerMetre, V_s: MetresPerSecond) -> Watt:
    """s is the length of line for which a position stands; w is the load without its floor."""
    return along(s * mu * w * V_s)


@formula(
    "P_R",
    "mathematics, mean over a mesh cycle of the rolling power; [IR]: share of Δs where the rigid isoviscous film "
    "governs",
    names={"s": "Δs", "r": "[IR]"},
    meanings={"s": "Length of line for which a position stands", "r": "Share of the rigid isoviscous film"},
)
def rolling_loss(s: Metres, q_R: WattsPerMetre, r: Numbers) -> Watt:
    return along(s * q_R * r)


@formula(
    "P_RE",
    "mathematics: mean over a mesh cycle of the estimated rolling power of an EHL film; shown, not added",
    names={"s": "Δs", "r": "[IR]"},
    meanings={"s": "Length of line for which a position stands", "r": "Share of the rigid isoviscous film"},
)
def rolling_estimate(s: Metres, q_E: WattsPerMetre, r: Numbers) -> Watt:
    return along(s * q_E * (1 - r))


@formula("P_VZ", "mathematics: sum of sliding and rolling")
def mesh_loss(P_s: Watt, P_R: Watt) -> Watt:
    return P_s + P_R


@formula(
    "H_VL",
    Text("{thesis}, eq. 6: loss factor, the load shared along the path", thesis=THESIS),
    names={"s": "Δs"},
    meanings={"s": "Length of line for which a position stands"},
)
def loss_factor(s: Metres, w: NewtonsPerMetre, V_s: MetresPerSecond, P: Watt) -> Number:
    return along(s * w * V_s) / P


@formula("μ_m", "definition of the mean coefficient of friction")
def mean_friction(P_s: Watt, P: Watt, H_VL: Number) -> Number:
    return P_s / (P * H_VL)


@formula("η_Z", "definition of the efficiency")
def efficiency(P_VZ: Watt, P: Watt) -> Number:
    """>>> efficiency(P_VZ=4.55, P=224.8)
    0.9797597...
    """
    return 1 - P_VZ / P


# --- single numbers of a whole path


@formula(
    "P_R",
    "rule of this program: without a rigid isoviscous film no rolling is counted",
    shows="no position has a rigid isoviscous film",
)
def no_rolling_loss() -> Watt:
    return 0.0


def extreme(which: Callable[..., Any], x: Array) -> float:
    """The smallest or largest along the path."""
    return single_or_many(which(x, axis=-1))


@formula("h_min", "definition: smallest along the path", unit="µm", shows="smallest h along the path")
def thinnest_film(h: Metres) -> Metre:
    return extreme(np.min, h)


@formula("λ_min", "definition: smallest along the path", shows="smallest λ along the path")
def least_film_ratio(lam: Numbers) -> Number:
    return extreme(np.min, lam)


@formula("p_H,max", "definition: largest along the path", unit="MPa", shows="largest p_H along the path")
def largest_pressure(p_H: Pascals) -> Pascal:
    return extreme(np.max, p_H)


@formula(
    "p_C",
    "definition: the pressure of a spur pair where it rolls without sliding",
    unit="MPa",
    shows="p_H at the pitch point C",
)
def pressure_at_pitch_point(p_H: Pascal) -> Pascal:
    return p_H


@formula("T_f,max", "definition: largest along the path", shows="largest T_f along the path")
def hottest_film(T_f: CelsiusArray) -> Celsius:
    return extreme(np.max, T_f)


@formula("De_max", "definition: largest along the path", shows="largest De along the path")
def largest_deborah(De: Numbers) -> Number:
    return extreme(np.max, De)


@formula(
    "s_IR",
    "definition: share of the length of line whose film is rigid and isoviscous",
    unit="%",
    names={"s": "Δs", "r": "[IR]"},
    meanings={"s": "Length of line for which a position stands", "r": "Share of the rigid isoviscous film"},
)
def rigid_share(s: Metres, r: Numbers) -> Number:
    return along(s * r) / along(s)


# --- what rolling costs
# Oil is pumped against its own pressure although nothing slides.  The friction source leaves it out.
#
# Between rigid bodies in a full gap the loss follows from the same Reynolds solution as the film; it is an upper bound,
# because a real inlet is seldom full.  For EHL an estimate by Goksem and Hargreaves is shown and not added.


@formula(
    "q_R",
    "hydrodynamics, derived here: rolling of a rigid isoviscous film, fully flooded; its load gives Martin's 4.896",
)
def rigid_rolling_power(eta_0: PascalSecond, u_e: MetrePerSecond, R: Metre, h_0: Metre) -> WattPerMetre:
    return 9.202 * eta_0 * u_e**2 * sqrt(R / h_0)


@formula("q_E", "Goksem and Hargreaves 1978, rolling of a fully flooded EHL film")
def ehl_rolling_power(
    alpha: PerPascal, G: Number, U: Number, W: Number, R: Metre, Phi: Number, u_e: MetrePerSecond
) -> WattPerMetre:
    return 4.318 / alpha * (G * U) ** 0.658 * W**0.0126 * R * Phi * u_e


# --- one mesh

# K: to which the temperature of the skins, where the bodies resist, and that of the teeth, where it is estimated, are
# found
SKIN = 1e-8
PASSES = 100
HOTTER_TEETH = Text("give friction.bulk_temperature_C, less power or speed, or a wider face")
State = TypeVar("State")
LOADED = 0.05  # of the full load, from which film and friction of a place are drawn


@record
class Warming:
    """Where the temperature of the teeth is estimated: oil temperature, and the factors for how oil comes and for tip
    relief."""

    T_oil: Celsius
    X_S: Number
    X_Ca: Number


@record
class MeshCase:
    """A mesh at its speed with its oil: everything but the power that it carries.  `oil` is at the temperature of the
    teeth.

    `surfaces` rub by regime, `source_surfaces` as the friction source has it.
    """

    mesh: MeshGeometry
    path: Path
    motion: Motion
    oil: Oil
    Ra: Metre  # mean of both flanks
    surfaces: Surfaces
    source_surfaces: Surfaces
    warming: Warming
    estimated: bool  # whether the temperature of the teeth is `warming`'s
    # asked untraced
    last: list["tuple[bool, Watt, Lost]"] = field(default_factory=list, init=False, repr=False)

    def rubbing(self, by_regime: bool) -> Surfaces:
        return self.surfaces if by_regime else self.source_surfaces


def case(
    friction: FrictionInputs, mesh: MeshGeometry, oil: Oil, n_1: Num, warming: Warming | None = None, **fineness: int
) -> MeshCase:
    """What does not change with the power.  `fineness` of the path (points, strips) is for tests of convergence."""
    way = path(mesh, friction.load_sharing, **fineness)
    surfaces, source = surfaces_of(friction, mesh)
    return MeshCase(
        mesh=mesh,
        path=way,
        motion=motion(mesh, way, n_1),
        oil=oil,
        Ra=surfaces.Ra,
        surfaces=surfaces,
        source_surfaces=source,
        warming=warming or Warming(oil.T_m, contact.LUBRICATION_FACTOR["spray"], friction.tip_relief_factor),
        estimated=friction.bulk == "estimated" and friction.bulk_temperature is None,
    )


@record
class Local:
    """What the curves show, along the strip in the middle of the face, by rising x."""

    x: Array
    p_H: Array
    h: Array
    lam: Array
    xi: Array
    mu: Array
    q: Array
    T_f: Array
    w: Array
    V_s: Array
    b_H: Array
    De: Array

    def drawn(self, name: str) -> Array:
        """One of them to draw: film and friction only where a place is loaded, nan elsewhere."""
        column, p_H = np.asarray(getattr(self, name)), np.asarray(self.p_H)
        if name not in ("h", "lam", "mu"):
            return column
        least = LOADED**0.5 * np.max(p_H) * (1 - 1e-9)  # pressure goes with the root of the load; less the last digits
        return np.where(p_H >= least, column, np.nan)


@result
class MeshLoss(Shown, Generic[Value]):
    """The loss of one mesh by one model of the film; of many operating points every number is an array."""

    loss: Value = value("Power lost in the mesh", "W", "P_VZ", short=True)
    sliding_loss: Value = value("by sliding", "W", "P_s")
    rolling_loss: Value = value("by rolling", "W", "P_R")
    rolling_estimate: Value | None = value("Rolling of an EHL film, an estimate that is not added", "W", "P_RE")
    efficiency: Value = value("Efficiency of the mesh", "", "η_Z", short=True)
    loss_factor: Value = value("Loss factor", "", "H_VL", short=True)
    friction_mean: Value = value("Mean coefficient of friction", "", "μ_m", short=True)
    film_min: Value = value("Thinnest film", "µm", "h_min", short=True)
    lambda_min: Value = value("Smallest film over roughness", "", "λ_min", short=True)
    pressure_max: Value = value("Largest Hertzian pressure", "MPa", "p_H", short=True)
    pressure_pitch: Value | None = value("Hertzian pressure at the pitch point", "MPa", "p_C")
    temperature_max: Value = value("Hottest film", "°C", "T_f")
    bulk_temperature: Value | None = value("Temperature of the teeth, estimated", "°C", "Θ_M")
    deborah_max: Value = value("Largest Deborah number", "", "De")
    rigid_share: Value = value("Share of the path with a rigid isoviscous film", "%")
    load: Value  # the power that was asked
    local: Local
    lead_at_pitch: Value  # film of the best other regime over the rigid isoviscous one; 0 where not asked
    thermal_reduction_min: Value


@formula(
    "Θ_M",
    "energy, heat of the mesh: the loss warms the teeth, whose oil rubs less",
    shows="Θ_M at which the mesh's loss warms its teeth to Θ_M",
)
def closing_tooth_temperature(T: Celsius) -> Celsius:
    """The temperature itself, found from all that the loss depends on."""
    return T


def solve_mesh(c: MeshCase, P: Any, by_regime: bool) -> MeshLoss:
    """The loss of a mesh that takes in the power P, one or many."""
    require(c.mesh.power, P)
    if not c.estimated:
        return _solved(c, P, by_regime)
    with untraced():
        T_b = _warmed(unlinked(c), unlinked(P), by_regime)

    def last(T: Celsius) -> tuple[MeshLoss, Celsius]:
        trial = _solved(replace(c, oil=c.oil.at(T)), P, by_regime)
        return trial, warming_of(c, P, trial.friction_mean, trial.loss_factor)

    loss, rise = converged(closing_tooth_temperature, T_b, last, lambda both: both[1])
    return replace(loss, bulk_temperature=contact.bulk_temperature(T_oil=flat(c.warming.T_oil), Delta_T=rise))


def warming_of(c: MeshCase, P: Watt, mu_m: Number, H_VL: Number) -> Celsius:
    """How much warmer than the oil the teeth become."""
    a, b, w = c.mesh.centre_distance, c.mesh.face_width, c.warming
    return contact.bulk_rise(P=P, mu_m=mu_m, H_v=H_VL, a=a, b=b, X_S=w.X_S, X_Ca=w.X_Ca)


def _steadied(
    at: Callable[[Any], tuple[Any, State]], T: Any, flattest: float, fail: Callable[[Any, str], NoSolution]
) -> State:
    """Secant steps until the temperature that follows from T is T; what `at` gives there beside its gap.

    `flattest`: the largest slope of what follows that a step may trust; `fail` makes the exception of the last gap and
    its reason."""
    before: tuple[Celsius, Kelvin] | None = None
    for _ in range(PASSES):
        gap, state = at(T)
        if np.all(np.abs(gap) <= SKIN):
            return state
        slope: Any = 0.0
        if before is not None:
            step = T - before[0]
            slope = np.clip(1 + (gap - before[1]) / np.where(step == 0, 1.0, step), -1.0, flattest)
        before = T, gap
        T = T + gap / (1 - slope)
        if not np.all(T < HOTTEST):
            end = Amount(HOTTEST, form="g")
            raise fail(gap, Text("above {hottest} °C, where the laws of the oil end", hottest=end))
        T = T if np.ndim(T) else float(T)
    most = Amount(float(np.max(np.abs(gap))), form=".3g")
    raise fail(gap, Text("off by {max} K after {passes} passes", max=most, passes=PASSES))


def _warmed(c: MeshCase, P: Watt, by_regime: bool) -> Celsius:
    """The temperature of teeth as warm as the loss makes them, as a column where there are many points."""
    T_oil, what = flat(c.warming.T_oil), Text("mesh {title}: temperature of the teeth", title=c.mesh.title)

    def at(T: Celsius) -> tuple[Kelvin, Celsius]:
        loss = _solved(replace(c, oil=c.oil.at(column(T))), P, by_regime)
        return T_oil + warming_of(c, P, loss.friction_mean, loss.loss_factor) - T, column(T)

    def fail(gap: Kelvin, reason: str) -> NoSolution:
        point = Text("operating point {argmax}: ", argmax=int(np.argmax(np.abs(gap)))) if np.ndim(gap) else EMPTY
        return NoSolution(what, point + reason, HOTTER_TEETH)

    return _steadied(at, T_oil + 0.0 * P, 0.9, fail)


def power_lost(c: MeshCase, P: Watt, by_regime: bool, *, rolling: bool = True) -> Watt:
    """The loss alone, for iterations: the power lost of `solve_mesh`, or that by sliding where rolling does not
    count."""
    if c.estimated:
        whole = solve_mesh(c, P, by_regime)
        return whole.loss if rolling else whole.sliding_loss
    require(c.mesh.power, P)
    lost = _lost(c, P, by_regime)
    return mesh_loss(P_s=lost.P_s, P_R=lost.P_R) if rolling else lost.P_s


@record
class Lost:
    """The two parts of the loss, with load, pressure, film and friction at every position, which they come of."""

    P_s: Any
    P_R: Any
    w: Array
    b_H: Array
    p_H: Array
    oil: Oil
    f: MeshFilm
    t: Traction


def _lost(c: MeshCase, P: Watt, by_regime: bool) -> Lost:
    """Sliding and rolling with teeth of the oil's temperature T_m; where no lines are wanted, what was asked last is
    known."""
    if recorder.get() is not None:
        return _found(c, P, by_regime)
    for how, power, lost in c.last:
        if how == by_regime and np.array_equal(power, P):
            return lost
    lost = _found(c, P, by_regime)
    c.last[:] = [(by_regime, P, lost)]
    return lost


def _found(c: MeshCase, P: Watt, by_regime: bool) -> Lost:
    s, m, name = c.path.weight, c.motion, Text("mesh {title}", title=c.mesh.title)
    w, w_f = line_load(c.mesh, c.path, transverse_force(P=column(P), omega_1=m.omega_1, r_b1=c.mesh.driver.base_radius))
    b_H = contact.half_width(w=w_f, rho_n=m.R, E_r=m.E_r)
    p_H = contact.hertz_pressure(w=w_f, E_r=m.E_r, rho_n=m.R)
    p_m = contact.mean_pressure(p_H=p_H)

    def rubbing(oil: Oil) -> tuple[MeshFilm, Traction]:
        f = film(by_regime, oil, m, w_f, p_H, c.path.cells)
        return f, traction(oil, m, f, w, w_f, p_m, b_H, c.rubbing(by_regime), c.path.x, name)

    oil = _skins(c, rubbing)
    f, t = rubbing(oil)
    P_s = sliding_loss(s=s, mu=t.mu, w=w, V_s=m.V_s)
    if np.any(f.rigid > 0):
        P_R = rolling_loss(s=s, q_R=rigid_rolling_power(eta_0=oil.eta_0, u_e=m.u_e, R=m.R, h_0=f.h_0), r=f.rigid)
    else:
        P_R = no_rolling_loss()
    return Lost(P_s=P_s, P_R=P_R, w=w, b_H=b_H, p_H=p_H, oil=oil, f=f, t=t)


def _solved(c: MeshCase, P: Watt, by_regime: bool) -> MeshLoss:
    """The loss with teeth of the oil's temperature T_m, and all that is shown beside it."""
    lost = _lost(c, P, by_regime)
    c.last.clear()  # what a whole path has at every position is large, and nobody asks again
    s, m = c.path.weight, c.motion
    P_s, P_R, w, p_H, oil, f, t = lost.P_s, lost.P_R, lost.w, lost.p_H, lost.oil, lost.f, lost.t
    estimate = None
    if not np.all(f.rigid == 1):
        q_E = ehl_rolling_power(alpha=oil.alpha, G=f.G, U=f.U, W=f.W, R=m.R, Phi=f.Phi, u_e=m.u_e)
        estimate = rolling_estimate(s=s, q_E=q_E, r=f.rigid)
    P_VZ = mesh_loss(P_s=P_s, P_R=P_R)
    H_VL = loss_factor(s=s, w=w, V_s=m.V_s, P=P)
    along_path = c.path.x, p_H, f.h, t.lam, t.xi, t.mu, t.q, t.T_f, w, m.V_s, lost.b_H, t.De
    p_C = pressure_at_pitch_point(p_H=c.path.at_pitch_point(p_H)) if c.mesh.spur else None
    return MeshLoss(
        loss=P_VZ,
        sliding_loss=P_s,
        rolling_loss=P_R,
        rolling_estimate=estimate,
        efficiency=efficiency(P_VZ=P_VZ, P=P),
        loss_factor=H_VL,
        friction_mean=mean_friction(P_s=P_s, P=P, H_VL=H_VL),
        film_min=thinnest_film(h=f.h),
        lambda_min=least_film_ratio(lam=t.lam),
        pressure_max=largest_pressure(p_H=p_H),
        pressure_pitch=p_C,
        bulk_temperature=None,
        temperature_max=hottest_film(T_f=t.T_f),
        deborah_max=largest_deborah(De=t.De),
        rigid_share=rigid_share(s=s, r=f.rigid),
        load=P,
        local=Local(*(c.path.in_the_middle(x) for x in along_path)),
        lead_at_pitch=c.path.at_pitch_point(f.lead),
        thermal_reduction_min=extreme(np.min, f.Phi),
    )


def _skins(c: MeshCase, rubbing: Callable[[Oil], tuple[MeshFilm, Traction]]) -> Oil:
    """The oil at the temperature of the teeth; where their bodies resist the heat, at that of their skins, position by
    position."""
    s, m = c.surfaces, c.motion
    if not (np.any(s.M_1) or np.any(s.M_2)):
        return c.oil
    T_b, what = c.oil.T_m, Text("mesh {title}: temperature of the skins", title=c.mesh.title)

    def skins(t: Traction) -> Any:
        return skin_temperature(T_b=T_b, q=t.q, epsilon=t.epsilon, M_1=s.M_1, M_2=s.M_2, u_1=m.u_1, u_2=m.u_2)

    def at(T: Any) -> tuple[Any, tuple[Oil, Traction]]:
        oil = c.oil if T is T_b else c.oil.at(T)
        _, t = rubbing(oil)
        return skins(t) - T, (oil, t)

    def fail(gap: Any, reason: str) -> NoSolution:
        where = Text("{place}: {reason}", place=place(c.path.x, gap, int(np.argmax(np.abs(gap)))), reason=reason)
        return NoSolution(what, where, Text("less friction.body_resistance_K_W, power or speed"))

    with untraced():
        oil, t = _steadied(at, T_b, 0.5, fail)
    skins(t)  # its line
    return oil


# --- any number of operating points at once
# Speed, power and oil temperature may be arrays, and so are the results then.  They are solved some hundred at a time,
# which keeps the arrays in the processor's cache and the memory small however many there are.

AT_ONCE = 500
COLDEST_OIL, HOTTEST_OIL = -60.0, 400.0  # °C
SPUR_POINTS, HELICAL_POINTS, STRIPS = 12, 2, 5  # some 50 positions of a spur path, 125 of a helical one


def losses(
    friction: FrictionInputs,
    mesh: MeshGeometry,
    lubricant: Lubricant,
    T: Num,
    n_1: Num,
    P: Num,
    *,
    by_regime: bool = True,
    points: int = 0,
    strips: int = STRIPS,
) -> MeshLoss:
    """The loss where the teeth have the temperature T [°C], the driver turns at n_1 [1/s] and takes in the power P [W].

    One number each or arrays of one length.  `by_regime`: False takes the friction source's model.  `points`: of each
    piece of the path, 4 pieces on a spur path; with those left out a spur loss is right to 1e-6, a helical one to 2e-3,
    and where the regime changes on the path to 4e-3 and 2e-2.  NoSolution names the operating point and the place on
    the path where the temperature of the film does not settle, or the quantity that has no meaning."""
    T_all, n_all, P_all = np.broadcast_arrays(*(np.atleast_1d(np.asarray(x, dtype=np.float64)) for x in (T, n_1, P)))
    points = points or (SPUR_POINTS if mesh.spur else HELICAL_POINTS)
    liquid = (T_all > COLDEST_OIL) & (T_all < HOTTEST_OIL)  # NaN is not
    if not liquid.all():
        what, wrong = Text("mesh {title}: temperature of the teeth", title=mesh.title), float(T_all[~liquid][0])
        needed = Text("a temperature of a liquid oil is needed")
        raise NoSolution(what, Text("is {wrong} °C", wrong=Amount(wrong, form="g")), needed)
    friction = replace(friction, bulk="oil")  # the teeth have the temperature that is asked for
    parts = []
    with untraced(), np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        for start in range(0, P_all.size, AT_ONCE):
            some = slice(start, start + AT_ONCE)
            oil = oil_at(lubricant, column(T_all[some]))
            c = case(friction, mesh, oil, n_all[some], points=points, strips=strips)
            try:
                parts.append(solve_mesh(c, P_all[some], by_regime))
            except NoSolution as none:
                if not start:
                    raise
                among = Text("{tried} (counted from operating point {start})", tried=none.tried, start=start)
                raise NoSolution(none.what, among, none.advice) from None
    return _joined(parts)


def _joined(parts: list[MeshLoss]) -> MeshLoss:
    """Results one after the other; a loss that none of some points has is one number for them all."""
    first, locals_ = parts[0], [part.local for part in parts]
    columns: dict[str, Any] = {
        key: np.concatenate([getattr(part, key) for part in locals_]) for key in vars(first.local) if key != "x"
    }
    joined: dict[str, Any] = {
        name: np.concatenate([np.broadcast_to(getattr(part, name), np.shape(part.load)) for part in parts])
        for name, value in vars(first).items()
        if name != "local" and value is not None
    }
    return replace(first, local=replace(first.local, **columns), **joined)
