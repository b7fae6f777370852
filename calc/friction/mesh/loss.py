# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""The power that one mesh loses: friction along the path summed over all lines in contact, and rolling where it counts.

`case` takes a mesh at its speed with its oil, `solve_mesh` the power that it carries.  Speed, power, temperature and what is assumed of
oil and flanks may be arrays: N operating points in one call, whose results are arrays of N.
"""

from collections.abc import Callable
from dataclasses import field, replace

import numpy as np

from ...contact.hertz import half_width, hertz_pressure, mean_pressure
from ...library.contact import LUBRICATION_FACTOR, bulk_rise, bulk_temperature
from ...sheet.arrays import Array, anywhere, each, many, most, one
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.quantity import result, value
from ...sheet.record import record
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.trace import recorder, untraced
from ...sheet.units import Celsius, Kelvin, Metre, MetrePerSecond, NewtonPerMetre, Number, Pascal, RevPerSecond, Watt, WattPerMetre
from ...sheet.value import converged, unlinked
from ..inputs import FrictionInputs
from .film import EXPONENT, Film, Oil, film
from .geometry import MeshGeometry, column, flat, require
from .loss_formulas import efficiency, extreme, hottest_film, largest_deborah, largest_pressure, least_film_ratio, loss_factor, mean_friction, mesh_loss, no_rolling_loss, pressure_at_pitch_point, rigid_share, rolling_estimate, rolling_loss, sliding_loss, thinnest_film
from .motion import Motion, motion
from .path import Path, array, line_load, path, transverse_force
from .rolling import ehl_rolling_power, rigid_rolling_power
from .surfaces import Surfaces, surfaces_of
from .traction import HOTTEST, Traction, place, skin_temperature, traction

MICROMETRE: Metre = 1e-6
SKIN = 1e-8  # K: to which the temperature of the skins, where the bodies resist, and that of the teeth, where it is estimated, are found
PASSES = 100
HOTTER_TEETH = Text("give friction.bulk_temperature_C, less power or speed, or a wider face")
LOADED = 0.05  # of the full load, from which film and friction of a place are drawn


@record
class Warming:
    """Where the temperature of the teeth is estimated: oil temperature, and the factors for how oil comes and for tip relief."""

    T_oil: Celsius
    X_S: Number
    X_Ca: Number


@record
class Case:
    """A mesh at its speed with its oil: everything but the power that it carries.  `oil` is at the temperature of the teeth.

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
    last: list["tuple[tuple[bool, Number], Watt, Lost]"] = field(default_factory=list, init=False, repr=False)  # asked untraced

    def rubbing(self, by_regime: bool) -> Surfaces:
        return self.surfaces if by_regime else self.source_surfaces


def case(
    friction: FrictionInputs, mesh: MeshGeometry, oil: Oil, n_1: RevPerSecond, warming: Warming | None = None, **fineness: int
) -> Case:
    """What does not change with the power.  `fineness` of the path (points, strips) is for tests of convergence."""
    way = path(mesh, friction.load_sharing, **fineness)
    surfaces, source = surfaces_of(friction, mesh)
    return Case(
        mesh=mesh, path=way, motion=motion(mesh, way, n_1), oil=oil, Ra=surfaces.Ra, surfaces=surfaces,
        source_surfaces=source, warming=warming or Warming(oil.T_m, LUBRICATION_FACTOR["spray"], friction.tip_relief_factor),
        estimated=friction.bulk == "estimated" and friction.bulk_temperature is None,
    )  # fmt: skip


@record
class Local:
    """What the curves show, along the strip in the middle of the face, by rising x."""

    x: Metre
    p_H: Pascal
    h: Metre
    lam: Number
    xi: Number
    mu: Number
    q: WattPerMetre
    T_f: Celsius
    w: NewtonPerMetre
    V_s: MetrePerSecond
    b_H: Metre
    De: Number

    def drawn(self, name: str) -> Array:
        """One of them to draw: film and friction only where a place is loaded, nan elsewhere."""
        column, p_H = np.asarray(getattr(self, name)), np.asarray(self.p_H)
        if name not in ("h", "lam", "mu"):
            return column
        least = LOADED**0.5 * np.max(p_H) * (1 - 1e-9)  # pressure goes with the root of the load; less the last digits
        return np.where(p_H >= least, column, np.nan)


@result
class MeshLoss:
    """The loss of one mesh by one model of the film."""

    loss: Watt = value("Power lost in the mesh", "W", "P_VZ")
    sliding_loss: Watt = value("by sliding", "W", "P_s")
    rolling_loss: Watt = value("by rolling", "W", "P_R")
    rolling_estimate: Watt | None = value("Rolling of an EHL film, an estimate that is not added", "W", "P_RE")
    efficiency: Number = value("Efficiency of the mesh", "", "η_Z")
    loss_factor: Number = value("Loss factor", "", "H_VL")
    friction_mean: Number = value("Mean coefficient of friction", "", "μ_m")
    film_min: Metre = value("Thinnest film", "µm", "h_min")
    lambda_min: Number = value("Smallest film over roughness", "", "λ_min")
    pressure_max: Pascal = value("Largest Hertzian pressure", "MPa", "p_H")
    pressure_pitch: Pascal | None = value("Hertzian pressure at the pitch point", "MPa", "p_C")
    temperature_max: Celsius = value("Hottest film", "°C", "T_f")
    bulk_temperature: Celsius | None = value("Temperature of the teeth, estimated", "°C", "Θ_M")
    deborah_max: Number = value("Largest Deborah number", "", "De")
    rigid_share: Number = value("Share of the path with a rigid isoviscous film", "%")
    load: Watt  # the power that was asked
    local: Local
    lead_at_pitch: Number  # film of the best other regime over the rigid isoviscous one; 0 where not asked
    thermal_reduction_min: Number


@formula("Θ_M", "energy, heat of the mesh: the loss warms the teeth, whose oil rubs less",
    shows="Θ_M at which the mesh's loss warms its teeth to Θ_M")  # fmt: skip
def closing_tooth_temperature(T: Celsius) -> Celsius:
    """The temperature itself, found from all that the loss depends on."""
    return T


def solve_mesh(c: Case, P: Watt, by_regime: bool, exponent: Number = EXPONENT) -> MeshLoss:
    """The loss of a mesh that takes in the power P, one or many."""
    require(c.mesh.power, P)
    if not c.estimated:
        return _solved(c, P, by_regime, exponent)
    with untraced():
        _, T_b = _warmed(unlinked(c), unlinked(P), by_regime, exponent)

    def last(T: Celsius) -> tuple[MeshLoss, Celsius]:
        found = _solved(replace(c, oil=c.oil.at(T)), P, by_regime, exponent)
        return found, warming_of(c, P, found.friction_mean, found.loss_factor)

    found, rise = converged(closing_tooth_temperature, T_b, last, lambda both: both[1])
    return replace(found, bulk_temperature=bulk_temperature(T_oil=flat(c.warming.T_oil), Delta_T=rise))


def warming_of(c: Case, P: Watt, mu_m: Number, H_VL: Number) -> Celsius:
    """How much warmer than the oil the teeth become."""
    w = c.warming
    return bulk_rise(P=P, mu_m=mu_m, H_v=H_VL, a=c.mesh.centre_distance, b=c.mesh.face_width, X_S=w.X_S, X_Ca=w.X_Ca)


def _steadied(gap_at: Callable[[Celsius], Kelvin], T: Celsius, flattest: float, fail: Callable[[Kelvin, str], NoSolution]) -> None:
    """Secant steps until the temperature that follows from T is T; `gap_at` is called last with that one.

    `flattest`: the largest slope of what follows that a step may trust; `fail` makes the exception of the last gap and its reason.
    """
    before: tuple[Celsius, Kelvin] | None = None
    for _ in range(PASSES):
        gap = gap_at(T)
        if most(np.abs(gap)) <= SKIN:
            return
        slope = 0.0
        if before is not None:
            step = T - before[0]
            slope = each(np.clip(1 + (gap - before[1]) / np.where(step == 0, 1.0, step), -1.0, flattest))
        before = T, gap
        T = T + gap / (1 - slope)
        if not np.all(many(T) < HOTTEST):
            raise fail(gap, Text("above {hottest} °C, where the laws of the oil end", hottest=Amount(HOTTEST, form="g")))
        T = T if np.ndim(T) else one(T)
    raise fail(gap, Text("off by {max} K after {passes} passes", max=Amount(float(np.max(np.abs(gap))), form=".3g"), passes=PASSES))


def _warmed(c: Case, P: Watt, by_regime: bool, exponent: Number) -> tuple[MeshLoss, Celsius]:
    """The loss with teeth as warm as it makes them, and their temperature, as a column where there are many points."""
    T_oil = flat(c.warming.T_oil)
    last: list[tuple[MeshLoss, Celsius]] = []

    def gap_at(T: Celsius) -> Kelvin:
        found = _solved(replace(c, oil=c.oil.at(column(T))), P, by_regime, exponent)
        last[:] = [(found, column(T))]
        return T_oil + warming_of(c, P, found.friction_mean, found.loss_factor) - T

    def fail(gap: Kelvin, reason: str) -> NoSolution:
        point = Text("operating point {argmax}: ", argmax=int(np.argmax(np.abs(gap)))) if np.ndim(gap) else EMPTY
        return NoSolution(Text("mesh {title}: temperature of the teeth", title=c.mesh.title), point + reason, HOTTER_TEETH)

    _steadied(gap_at, T_oil + 0.0 * P, 0.9, fail)
    return last[0]


def power_lost(c: Case, P: Watt, by_regime: bool, *, rolling: bool = True) -> Watt:
    """The loss alone, for iterations: the power lost of `solve_mesh`, or that by sliding where rolling does not count."""
    if c.estimated:
        whole = solve_mesh(c, P, by_regime)
        return whole.loss if rolling else whole.sliding_loss
    require(c.mesh.power, P)
    lost = _lost(c, P, by_regime, EXPONENT)
    return mesh_loss(P_s=lost.P_s, P_R=lost.P_R) if rolling else lost.P_s


@record
class Lost:
    """The two parts of the loss, with load, pressure, film and friction at every position, which they come of."""

    P_s: Watt
    P_R: Watt
    w: NewtonPerMetre
    b_H: Metre
    p_H: Pascal
    oil: Oil
    f: Film
    t: Traction


def _lost(c: Case, P: Watt, by_regime: bool, exponent: Number) -> Lost:
    """Sliding and rolling with teeth of the oil's temperature T_m; where no lines are wanted, what was asked last is known."""
    if recorder.get() is not None:
        return _found(c, P, by_regime, exponent)
    for how, power, found in c.last:
        if how == (by_regime, exponent) and np.array_equal(power, P):
            return found
    found = _found(c, P, by_regime, exponent)
    c.last[:] = [((by_regime, exponent), P, found)]
    return found


def _found(c: Case, P: Watt, by_regime: bool, exponent: Number) -> Lost:
    s, m, name = c.path.weight, c.motion, Text("mesh {title}", title=c.mesh.title)
    w, w_f = line_load(c.mesh, c.path, transverse_force(P=column(P), omega_1=m.omega_1, r_b1=c.mesh.driver.base_radius))
    b_H = half_width(w=w_f, rho_n=m.R, E_r=m.E_r)
    p_H = hertz_pressure(w=w_f, E_r=m.E_r, rho_n=m.R)
    p_m = mean_pressure(p_H=p_H)

    def rubbing(oil: Oil) -> tuple[Film, Traction]:
        f = film(by_regime, oil, m, w_f, p_H, c.path.cells, exponent)
        return f, traction(oil, m, f, w, w_f, p_m, b_H, c.rubbing(by_regime), c.path.x, name)

    oil = _skins(c, rubbing)
    f, t = rubbing(oil)
    P_s = sliding_loss(s=s, mu=t.mu, w=w, V_s=m.V_s)
    if not anywhere(many(f.rigid) > 0):
        P_R = no_rolling_loss()
    else:
        P_R = rolling_loss(s=s, q_R=rigid_rolling_power(eta_0=oil.eta_0, u_e=m.u_e, R=m.R, h_0=f.h_0), r=f.rigid)
    return Lost(P_s=P_s, P_R=P_R, w=w, b_H=b_H, p_H=p_H, oil=oil, f=f, t=t)


def _solved(c: Case, P: Watt, by_regime: bool, exponent: Number) -> MeshLoss:
    """The loss with teeth of the oil's temperature T_m, and all that is shown beside it."""
    lost = _lost(c, P, by_regime, exponent)
    c.last.clear()  # what a whole path has at every position is large, and nobody asks again
    s, m = c.path.weight, c.motion
    P_s, P_R, w, p_H, oil, f, t = lost.P_s, lost.P_R, lost.w, lost.p_H, lost.oil, lost.f, lost.t
    estimate = None
    if not np.all(many(f.rigid) == 1):
        q_E = ehl_rolling_power(alpha=oil.alpha, G=f.G, U=f.U, W=f.W, R=m.R, Phi=f.Phi, u_e=m.u_e)
        estimate = rolling_estimate(s=s, q_E=q_E, r=f.rigid)
    P_VZ = mesh_loss(P_s=P_s, P_R=P_R)
    H_VL = loss_factor(s=s, w=w, V_s=m.V_s, P=P)
    along_path = c.path.x, p_H, f.h, t.lam, t.xi, t.mu, t.q, t.T_f, w, m.V_s, lost.b_H, t.De
    p_C = pressure_at_pitch_point(p_H=c.path.at_pitch_point(p_H)) if c.mesh.spur else None
    return MeshLoss(
        loss=P_VZ, sliding_loss=P_s, rolling_loss=P_R, rolling_estimate=estimate, efficiency=efficiency(P_VZ=P_VZ, P=P), loss_factor=H_VL,
        friction_mean=mean_friction(P_s=P_s, P=P, H_VL=H_VL), film_min=thinnest_film(h=f.h), lambda_min=least_film_ratio(lam=t.lam),
        pressure_max=largest_pressure(p_H=p_H), pressure_pitch=p_C,
        bulk_temperature=None,
        temperature_max=hottest_film(T_f=t.T_f), deborah_max=largest_deborah(De=t.De),
        rigid_share=rigid_share(s=s, r=f.rigid),
        load=P, local=Local(*(array(c.path.in_the_middle(x)) for x in along_path)),
        lead_at_pitch=c.path.at_pitch_point(f.lead), thermal_reduction_min=extreme(np.min, f.Phi),
    )  # fmt: skip


def _skins(c: Case, rubbing: Callable[[Oil], tuple[Film, Traction]]) -> Oil:
    """The oil at the temperature of the teeth; where their bodies resist the heat, at that of their skins, position by position."""
    s, m = c.surfaces, c.motion
    if not (np.any(s.M_1) or np.any(s.M_2)):
        return c.oil
    T_b = c.oil.T_m
    last: list[tuple[Oil, Traction]] = []

    def gap_at(T: Celsius) -> Kelvin:
        oil = c.oil.at(T) if last else c.oil
        _, t = rubbing(oil)
        last[:] = [(oil, t)]
        return skin_temperature(T_b=T_b, q=t.q, epsilon=t.epsilon, M_1=s.M_1, M_2=s.M_2, u_1=m.u_1, u_2=m.u_2) - T

    def fail(gap: Kelvin, reason: str) -> NoSolution:
        where = Text("{place}: {reason}", place=place(c.path.x, many(gap), int(np.argmax(np.abs(gap)))), reason=reason)
        return NoSolution(
            Text("mesh {title}: temperature of the skins", title=c.mesh.title),
            where,
            Text("less friction.body_resistance_K_W, power or speed"),
        )

    with untraced():
        _steadied(gap_at, T_b, 0.5, fail)
    oil, t = last[0]
    skin_temperature(T_b=T_b, q=t.q, epsilon=t.epsilon, M_1=s.M_1, M_2=s.M_2, u_1=m.u_1, u_2=m.u_2)
    return oil
