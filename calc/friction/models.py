# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""Published regressions of tooth friction, beside the model of this program and beside each other.

Nothing is judged by them.

Schlenk: one mean coefficient from the state at the pitch point; from tests of loaded gears.
Niemann and Winter, Michaelis: the same in the form of ISO/TR 15144-1 and ISO/TR 13989-2.
Xu and Kahraman: local, from many runs of a mixed EHL solver with one gear oil.
Benedict and Kelley: local, from disc tests of 1961; kept within 0.01 and 0.2.

A train that only drives a counter-shaft carries far less than any of them was fitted to; each says whether it is inside
its range.  What is known of a model stands above its function (`@friction_model`); table, checks and what is published
read it there."""

from collections.abc import Callable
from functools import reduce
from typing import TypeVar

import numpy as np

from ..library.contact import LUBRICANT_FACTOR, hertz_pressure, mean_friction, roughness_factor, sum_of_speeds
from ..sheet.arrays import Array
from ..sheet.formula import formula
from ..sheet.functions import along, exp, largest, log10, smallest
from ..sheet.quantity import result, value
from ..sheet.record import record
from ..sheet.shown import Shown
from ..sheet.step import Table
from ..sheet.text import EMPTY, SEMICOLON, Amount, Name, Text
from ..sheet.units import Metre, MetrePerSecond, Newton, NewtonPerMetre, Number, Pascal, PascalSecond, Watt
from ..sheet.value import based_on
from .mesh.geometry import column, flat
from .mesh.loss import MeshCase, MeshLoss, loss_factor, sliding_loss
from .mesh.loss import mean_friction as mean_friction_of
from .mesh.path import line_load, transverse_force

MILLIPASCAL_SECOND: PascalSecond = 1e-3
MICROMETRE: Metre = 1e-6
MILLIMETRE: Metre = 1e-3
ONE_METRE: Metre = 1.0
METRE_PER_SECOND: MetrePerSecond = 1.0
NEWTON_PER_MILLIMETRE: NewtonPerMetre = 1e3
NEWTON_PER_METRE: NewtonPerMetre = 1.0
GIGAPASCAL: Pascal = 1e9
SLOWEST: MetrePerSecond = 1e-9  # keeps the logarithm finite at the pitch point
LOWEST_LINE_LOAD: NewtonPerMetre = 150e3
ROUGHEST: Metre = 2e-6
RUNS = (0.5e9, 2.5e9)  # Pa, the pressures of Xu and Kahraman's runs, from memory
SMOOTH: Metre = 1e-6  # roughness up to which they hold, from memory
RUNS_IN_MPA = tuple(Amount(p / 1000000.0, form="g") for p in RUNS)
SMOOTH_IN_UM = Amount(SMOOTH * 1000000.0, form="g")
FASTEST: MetrePerSecond = 50.0  # of the pitch line, ISO/TR 13989-2, as in public code
LEAST: Number = 0.01  # within which Benedict and Kelley's friction is kept
MOST: Number = 0.2
HELD = 0.5  # share of the path on which Benedict and Kelley's bounds may hold

XU = Text("Xu and Kahraman 2005")


@formula(
    "μ_m",
    "Schlenk 1994, ISO/TR 14179-2",
    names={"v_SumC": "v_Σ,C", "rho_C": "ρ_n,C"},
    meanings={"X_L": "Lubricant factor"},
)
def schlenk(
    w_t: NewtonPerMetre, v_SumC: MetrePerSecond, rho_C: Metre, eta_0: PascalSecond, Ra: Metre, X_L: Number
) -> Number:
    """>>> schlenk(w_t=150000, v_SumC=5.19, rho_C=0.006201, eta_0=0.007413, Ra=8e-07, X_L=1)
    0.05587357...
    """
    return (
        0.048
        * (w_t / NEWTON_PER_MILLIMETRE / (v_SumC / METRE_PER_SECOND * rho_C / MILLIMETRE)) ** 0.2
        * (eta_0 / MILLIPASCAL_SECOND) ** -0.05
        * (Ra / MICROMETRE) ** 0.25
        * X_L
    )


@formula("f", Text("{xu}: exponent", xu=XU), names={"S": "SR", "sigma": "σ"})
def xu_kahraman_exponent(S: Number, p_H: Pascal, eta_0: PascalSecond, sigma: Metre) -> Number:
    return (
        -8.916465
        - 0.354068 * S * p_H / GIGAPASCAL * log10(eta_0 / MILLIPASCAL_SECOND)
        + 2.812084 * exp(-S * p_H / GIGAPASCAL * log10(eta_0 / MILLIPASCAL_SECOND))
        + 0.620305 * exp(sigma / MICROMETRE)
    )


@formula("μ_XK", XU, names={"S": "SR"})
def xu_kahraman(f: Number, p_H: Pascal, S: Number, u_e: MetrePerSecond, eta_0: PascalSecond, R: Metre) -> Number:
    return (
        exp(f)
        * (p_H / GIGAPASCAL) ** 1.03303
        * S**1.036077
        * (u_e / METRE_PER_SECOND) ** -0.100601
        * (eta_0 / MILLIPASCAL_SECOND) ** 0.752755
        * (R / ONE_METRE) ** -0.390958
    )


@formula(
    "μ_BK",
    "Benedict and Kelley 1961; kept within 0.01 and 0.2",
    names={"V_T": "V_Σ"},
    meanings={"V_T": "Sum of the velocities of both flanks"},
)
def benedict_kelley(w: NewtonPerMetre, eta_0: PascalSecond, V_s: MetrePerSecond, V_T: MetrePerSecond) -> Number:
    return smallest(
        largest(
            0.0127
            * log10(
                29.66
                * w
                / NEWTON_PER_METRE
                / (
                    eta_0
                    / MILLIPASCAL_SECOND
                    * largest(V_s, SLOWEST)
                    / METRE_PER_SECOND
                    * (V_T / METRE_PER_SECOND) ** 2
                )
            ),
            LEAST,
        ),
        MOST,
    )


@formula("w_t", "ISO/TR 13989-2:2000 (1): line load of the friction, no less than 150 N/mm", unit="N/mm")
def counted_line_load(w_bt: NewtonPerMetre) -> NewtonPerMetre:
    return largest(w_bt, LOWEST_LINE_LOAD)


@formula("w_bt", "definition of the line load", unit="N/mm")
def line_load_of(F_bt: Newton, b: Metre) -> NewtonPerMetre:
    return F_bt / b


@formula("P_VZ", "definition of the mean coefficient of friction")
def loss_of_mean_friction(P: Watt, mu_m: Number, H_V: Number) -> Watt:
    return P * mu_m * H_V


@result
class Regression(Shown):
    """What one model gives; `outside`: by what the mesh lies outside its range, empty where it does not."""

    loss: Watt = value("Power lost in the mesh", "W", "P_VZ")
    friction_mean: Number = value("Mean coefficient of friction", "", "μ_m")
    outside: Text = EMPTY


Estimate = Callable[[MeshCase, Watt, Number], Regression | None]
AnyEstimate = TypeVar("AnyEstimate", bound=Estimate)
TESTS = Text(
    "line load from {lowest_line_load} N/mm (held there below), sum of speeds from 1 m/s, pitch line to {fastest} m/s",
    lowest_line_load=Amount(LOWEST_LINE_LOAD / 1000.0, form="g"),
    fastest=Amount(FASTEST, form="g"),
)
INTEGRATED, OHLENDORF = Text("integrated"), Text("× Ohlendorf")


@record
class Model:
    """A published model: who made it, how its loss is found here, where it holds, and its name between the parts of an
    id.

    `regression`: what it gives for a mesh at the power that loads it, with Ohlendorf's loss factor; None: nothing."""

    authors: Text
    how: Text
    range: Text
    brief: Text
    regression: Estimate


MODELS: dict[str, Model] = {}


def friction_model(
    name: str, authors: Text, how: Text, range: Text, *, brief: Text | None = None
) -> Callable[[AnyEstimate], AnyEstimate]:
    """Declares the function below it as a model that is shown beside the own one; its values are
    `friction.MESH.NAME.loss` and so on."""

    def declared(regression: AnyEstimate) -> AnyEstimate:
        MODELS[name] = Model(authors, how, range, brief or authors, regression)
        return regression

    return declared


def beside(c: MeshCase, P: Watt, H_V: Number) -> dict[str, Regression | None]:
    """All of them, in the order in which they stand here."""
    return {name: model.regression(c, P, H_V) for name, model in MODELS.items()}


# --- with the loss factor of Ohlendorf, for which they were made


@friction_model("schlenk", Text("Schlenk"), OHLENDORF, TESTS)
def of_schlenk(c: MeshCase, P: Watt, H_V: Number) -> Regression:
    def coefficient(w_t: NewtonPerMetre, v_SumC: MetrePerSecond, R_C: Metre) -> Number:
        return schlenk(w_t=w_t, v_SumC=v_SumC, rho_C=R_C, eta_0=flat(_eta(c)), Ra=flat(c.Ra), X_L=_X_L(c))

    return _by_tests(c, P, H_V, coefficient)


@friction_model("niemann", Text("Niemann and Winter, Michaelis"), OHLENDORF, TESTS, brief=Name("Niemann"))
def of_niemann(c: MeshCase, P: Watt, H_V: Number) -> Regression:
    def coefficient(w_t: NewtonPerMetre, v_SumC: MetrePerSecond, R_C: Metre) -> Number:
        eta, X_R = flat(_eta(c)), roughness_factor(Ra=flat(c.Ra), rho_nC=R_C)
        return mean_friction(w_t=w_t, K_Bgamma=1.0, v_SumC=v_SumC, rho_nC=R_C, eta=eta, X_R=X_R, X_L=_X_L(c))

    return _by_tests(c, P, H_V, coefficient)


def _by_tests(
    c: MeshCase, P: Watt, H_V: Number, coefficient: Callable[[NewtonPerMetre, MetrePerSecond, Metre], Number]
) -> Regression:
    """By one mean coefficient, from line load, sum of speeds and curvature at the pitch point."""
    u_C, R_C = c.path.at_pitch_point(c.motion.u_e), c.path.at_pitch_point(c.motion.R)
    F_bt = transverse_force(P=P, omega_1=flat(c.motion.omega_1), r_b1=c.mesh.driver.base_radius)
    w_bt = line_load_of(F_bt=F_bt, b=c.mesh.face_width)
    mu_m = coefficient(counted_line_load(w_bt=w_bt), sum_of_speeds(v_C=u_C), R_C)
    loss = loss_of_mean_friction(P=P, mu_m=mu_m, H_V=H_V)
    return Regression(friction_mean=mu_m, loss=loss, outside=_outside_tests(c, w_bt, u_C))


def _eta(c: MeshCase) -> PascalSecond:
    """Viscosity of the oil as it comes, which all of them take, also where the teeth are warmer."""
    same = np.array_equal(c.warming.T_oil, c.oil.T_m)
    return c.oil.eta_0 if same else c.oil.lubricant.at(c.warming.T_oil).mu


def _X_L(c: MeshCase) -> Number:
    base = c.oil.lubricant.oil.base
    return based_on(LUBRICANT_FACTOR.get(base, 1.0), base)


def _outside_tests(c: MeshCase, w_bt: NewtonPerMetre, u_C: MetrePerSecond) -> Text:
    """Line load from 150 N/mm, sum of the speeds from 1 m/s, pitch line up to 50 m/s."""
    reasons = []
    # C rolls with the part of the pitch line's speed along the line of action
    v_t = u_C * c.mesh.centre_distance / c.path.C_F
    if np.any(w_bt < LOWEST_LINE_LOAD):
        reasons.append(Text("line load {min} N/mm, tests from 150", min=Amount(float(np.min(w_bt)) / 1000.0)))
    if np.any(2 * u_C < 1.0):
        reasons.append(Text("sum of speeds {min} m/s, tests from 1", min=Amount(2 * float(np.min(u_C)))))
    if np.any(v_t > FASTEST):
        most, limit = Amount(float(np.max(v_t))), Amount(FASTEST, form="g")
        reasons.append(Text("pitch line {max} m/s, tests up to {fastest}", max=most, fastest=limit))
    return SEMICOLON.join(reasons) if reasons else EMPTY


# --- integrated along the path


@friction_model(
    "xu_kahraman",
    Text("Xu and Kahraman"),
    INTEGRATED,
    Text(
        "{runs} to {runs2} MPa, roughness to {smooth} µm (from memory); one gear oil, 75W-90",
        runs=RUNS_IN_MPA[0],
        runs2=RUNS_IN_MPA[1],
        smooth=SMOOTH_IN_UM,
    ),
    brief=Name("Xu, Kahraman"),
)
def of_xu_kahraman(c: MeshCase, P: Watt, H_V: Number) -> Regression | None:
    """None where it runs away: flanks so rough that its exponential does, or pressures far outside its runs."""
    sigma = c.surfaces.sigma
    if np.any(sigma > ROUGHEST):
        return None
    w, w_f = _load(c, P)
    p_H = hertz_pressure(w=w_f, E_r=c.motion.E_r, rho_n=c.motion.R)
    eta_0 = _eta(c)
    f = xu_kahraman_exponent(S=c.motion.S, p_H=p_H, eta_0=eta_0, sigma=sigma)
    mu = xu_kahraman(f=f, p_H=p_H, S=c.motion.S, u_e=c.motion.u_e, eta_0=eta_0, R=c.motion.R)
    highest, outside = float(np.max(p_H)), []
    if not RUNS[0] <= highest <= RUNS[1]:
        MPa, (low, high) = Amount(highest / 1000000.0), RUNS_IN_MPA
        outside.append(
            Text("pressure up to {highest} MPa, runs from {runs} to {runs2}", highest=MPa, runs=low, runs2=high)
        )
    if np.any(sigma > SMOOTH):
        most = Amount(float(np.max(sigma)) * 1000000.0)
        outside.append(Text("roughness {max} µm, runs up to {smooth}", max=most, smooth=SMOOTH_IN_UM))
    regression = _summed(c, P, w, mu, SEMICOLON.join(outside) if outside else EMPTY)
    return regression if np.all(np.isfinite(regression.loss)) else None


@friction_model(
    "benedict_kelley",
    Text("Benedict and Kelley"),
    INTEGRATED,
    Text("μ from 0.01 to 0.2 (held there)"),
    brief=Name("Benedict, Kelley"),
)
def of_benedict_kelley(c: MeshCase, P: Watt, H_V: Number) -> Regression:
    w, w_f = _load(c, P)
    mu = benedict_kelley(w=w_f, eta_0=_eta(c), V_s=c.motion.V_s, V_T=based_on(2 * c.motion.u_e, c.motion.u_e))
    bounded = (mu <= LEAST) | (mu >= MOST)
    share = float(np.mean(along(np.where(bounded, c.path.weight, 0.0)) / along(c.path.weight)))
    held = Text("held at its bounds on {share} % of the path", share=Amount(share * 100, form=".0f"))
    return _summed(c, P, w, mu, held if share > HELD else EMPTY)


def _load(c: MeshCase, P: Watt) -> tuple[Array, Array]:
    F_bt = transverse_force(P=column(P), omega_1=c.motion.omega_1, r_b1=c.mesh.driver.base_radius)
    return line_load(c.mesh, c.path, F_bt)


def _summed(c: MeshCase, P: Watt, w: Array, mu: Array, outside: Text) -> Regression:
    P_s = sliding_loss(s=c.path.weight, mu=mu, w=w, V_s=c.motion.V_s)
    H_VL = loss_factor(s=c.path.weight, w=w, V_s=c.motion.V_s, P=P)
    return Regression(friction_mean=mean_friction_of(P_s=P_s, P=P, H_VL=H_VL), loss=P_s, outside=outside)


# --- the loss of a mesh by all models side by side, each with its range; how far they spread


@formula("P_max/P_min", "definition: the largest loss of all models over the smallest")
def spread(P_max: Watt, P_min: Watt) -> Number:
    return P_max / P_min


@formula("P_>/P_<", "definition: the larger of two losses over the smaller")
def factor_apart(P_1: Watt, P_2: Watt) -> Number:
    return largest(P_1 / P_2, P_2 / P_1)


def spread_of(losses: list[Watt]) -> Number | None:
    """None where a model gives no loss at all."""
    most, least = reduce(largest, losses), reduce(smallest, losses)
    return spread(P_max=most, P_min=least) if least > 0 else None


def table(
    key: str, title: str, by_regime: MeshLoss, source: MeshLoss, H_V: Number, published: dict[str, Regression | None]
) -> Table:
    """`key` of the mesh; the own models integrate with the local film."""
    any_load, ehl = Text("any load; rolling an upper bound"), Text("EHL film thicker than a rigid one")
    here = Text("outside: a rigid isoviscous film governs") if by_regime.lead_at_pitch < 1 else ""
    rows: list[tuple[str | float | None, ...]] = [
        (Text("by regime, integrated"), by_regime.loss, by_regime.friction_mean, by_regime.loss_factor, any_load, ""),
        (Text("EHL film, integrated (source)"), source.loss, source.friction_mean, source.loss_factor, ehl, here),
    ]
    for name, model in MODELS.items():
        regression, words = published[name], Text("{authors} {how}", authors=model.authors, how=model.how)
        if regression is None:
            rows.append((words, None, None, None, model.range, Text("runs away: not shown")))
            continue
        here = Text("outside: {outside}", outside=regression.outside) if regression.outside else ""
        H = H_V if model.how is OHLENDORF else by_regime.loss_factor
        rows.append((words, regression.loss, regression.friction_mean, H, model.range, here))
    numbers = (Text("P_VZ"), "W"), (Text("μ_m"), ""), (Text("H"), "")
    columns = ((Text("Model"), ""), *numbers, (Text("Range"), ""), (Text("Here"), ""))
    note = Text(
        "μ_m is that of sliding; the first line also counts rolling in its loss. Only the first two know the local "
        "film."
    )
    heading = Text("Mesh {title}: models of friction side by side", title=title)
    covers = tuple(f"friction.{key}.{name}" for name in published)
    return Table(f"models_{key}", heading, columns, tuple(rows), note, covers=covers)
