# SPDX-License-Identifier: Apache-2.0
"""The line of action of a mesh, the positions on it, the load that each carries, and how the flanks move there.

In order: shares of a stretch, the line of action, the load, both together, the motion of the flanks.

x runs along the transverse line of action from T₁, where it touches the driver's base circle.  Contact lasts from A to
E; two pairs of spur teeth share the load before B and behind D; C is the pitch point, where nothing slides.

A helical wheel is a pile of thin spur slices ("strips"), each a little later than the one before; every slice passes
from A to E, and the load of a position follows from the total length of all contact lines at that moment.  A spur wheel
is one strip.

Positions are Gauss-Legendre points of the pieces between which the load jumps or has a kink, and the sliding its kink
at C; behind them stand A … E themselves with no weight.  Against paths many times finer the power of a spur pair is
right to 1e-7 (1e-5 with smooth load sharing, whose floor makes one more kink), of a helical one to 1e-4
(tests/calc/friction/mesh/test_path.py).  Where the lubrication regime changes on the path, to 1e-3 and
5e-3.  The least film and the highest pressure and temperature of a helical path are those of its positions, right to 1
%."""

import math
from functools import cache
from typing import Any

import numpy as np

from ...library import contact
from ...sheet.arrays import Array, IndexArray, Num
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import acos, cos, largest, pi, sin, single_or_many, sqrt, tan
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Metre,
    MetrePerSecond,
    Metres,
    Newton,
    NewtonPerMetre,
    Number,
    Numbers,
    Pascal,
    Radian,
    RadPerSecond,
    RevPerSecond,
    Watt,
)
from ...sheet.value import based_on
from .geometry import MeshGeometry, column, require, sound

POINTS = 40  # Gauss-Legendre points of each piece of a spur path
HELICAL_POINTS = 3  # and of a helical one, whose pieces are shorter
STRIPS = 21  # slices across a helical face, themselves at Gauss-Legendre points; odd: one is in the middle
FLOOR: Number = 0.01  # share of the full load below which film and pressure see no less

AGMA = Text("AGMA 925-A03")


# --- how much of the stretch for which a position stands has a property that begins or ends between two positions
# A quadrature that counts a position wholly or not at all would make the power of a mesh jump whenever one of its
# positions changes its regime.  Here the stretch around each position, as long as its weight, is cut where the property
# changes, so that the sum changes steadily and is right to the second order of the stretches.


@record
class Cells:
    """The stretch to the left and right of each position, and the neighbours by which a number is continued to its
    ends."""

    left: Array
    right: Array
    before: tuple[IndexArray, IndexArray]
    after: tuple[IndexArray, IndexArray]
    to_left: Array  # of the difference of both neighbours
    to_right: Array

    def below_zero(self, value: Array) -> Array:
        """The share of each stretch in which a number that is known at the positions lies below 0, taken as a line
        between them."""
        there = value < 0
        if there.all() or not there.any():
            return np.where(there, 1.0, 0.0)
        at_left = value - self.to_left * (value[..., self.before[1]] - value[..., self.before[0]])
        at_right = value + self.to_right * (value[..., self.after[1]] - value[..., self.after[0]])
        length = self.left + self.right
        below = _below(at_left, value) * self.left + _below(value, at_right) * self.right
        return np.divide(below, length, out=np.where(there, 1.0, 0.0), where=length > 0)


def _below(a: Array, b: Array) -> Array:
    """The share of a line from a to b that lies below 0."""
    below, size = np.maximum(-a, 0.0) + np.maximum(-b, 0.0), np.abs(a) + np.abs(b)
    share: Array = np.divide(below, size, out=np.zeros_like(size), where=size > 0)
    return share


def cells(x: Array, width: Array, points: int, others: int) -> Cells:
    """Rows of positions: pieces of so many points each, whose widths fill their piece, then `others` that stand for
    nothing."""
    rows, columns = x.shape
    place = np.arange(columns - others)
    in_piece = place % points
    # stretches: those of a piece lie one after the other from its beginning
    dx = width.reshape(rows, -1, points)
    ends = np.cumsum(dx, axis=-1)
    inside = x[:, : columns - others].reshape(dx.shape)
    # Gauss points lie evenly about the middle of their piece
    begin = inside.mean(axis=-1, keepdims=True) - ends[..., -1:] / 2
    left, right = inside - (begin + ends - dx), begin + ends - inside
    nothing = np.zeros((rows, others))
    first = np.where(in_piece > 0, place - 1, place)
    last = np.where(in_piece < points - 1, place + 1, place)
    marks = np.arange(columns - others, columns)
    base = np.arange(rows)[:, None] * columns
    pair_before = first, np.where(in_piece > 0, place, last)
    pair_after = np.where(in_piece < points - 1, place, first), last
    before, after = (
        tuple((base + np.concatenate((indices, marks))).ravel() for indices in pair)
        for pair in (pair_before, pair_after)
    )
    flat = x.ravel()
    lefts, rights = (np.hstack((side.reshape(width.shape), nothing)).ravel() for side in (left, right))

    def share(stretch: Array, pair: tuple[IndexArray, ...]) -> Array:
        apart = flat[pair[1]] - flat[pair[0]]
        return np.divide(stretch, apart, out=np.zeros_like(stretch), where=apart > 0)

    to_left, to_right = share(lefts, before), share(rights, after)
    return Cells(left=lefts, right=rights, before=before, after=after, to_left=to_left, to_right=to_right)


# --- the line of action


@formula(
    "α_wt",
    Text("{agma}: working pressure angle, transverse", agma=AGMA),
    meanings={"r_b1": "Base radius of the driver", "r_b2": "Base radius of the driven wheel"},
)
def working_pressure_angle(r_b1: Metre, r_b2: Metre, a_w: Metre) -> Radian:
    return acos((r_b1 + r_b2) / a_w)


@formula("p_bt", "definition of the transverse base pitch", unit="mm", meanings={"r_b1": "Base radius of the driver"})
def base_pitch(r_b1: Metre, z_1: Number) -> Metre:
    return 2 * pi * r_b1 / z_1


@formula(
    "T_1T_2",
    Text("{agma}: C_F, between the points where the line of action touches the base circles", agma=AGMA),
    unit="mm",
)
def line_of_action(a_w: Metre, alpha_wt: Radian) -> Metre:
    return a_w * sin(alpha_wt)


@formula(
    "ρ_A",
    Text("{agma}: C_A, start of contact at the tip of the driven wheel", agma=AGMA),
    unit="mm",
    names={"T": "T_1T_2"},
    meanings={"r_a2": "Tip radius of the driven wheel", "r_b2": "Base radius of the driven wheel"},
)
def start_of_contact(T: Metre, r_a2: Metre, r_b2: Metre) -> Metre:
    return T - sqrt(r_a2**2 - r_b2**2)


@formula(
    "ρ_E",
    Text("{agma}: C_E, end of contact at the tip of the driver", agma=AGMA),
    unit="mm",
    meanings={"r_a1": "Tip radius of the driver", "r_b1": "Base radius of the driver"},
)
def end_of_contact(r_a1: Metre, r_b1: Metre) -> Metre:
    return sqrt(r_a1**2 - r_b1**2)


@formula("ε_α", "geometry: transverse contact ratio")
def transverse_contact_ratio(epsilon_1: Number, epsilon_2: Number) -> Number:
    return epsilon_1 + epsilon_2


@formula("ε_β", "geometry: overlap ratio on the common face width")
def overlap_ratio(b: Metre, beta_b: Radian, p_bt: Metre) -> Number:
    return b * tan(beta_b) / p_bt


# --- the load


@formula("F_bt", "definition: power over the speed of the base circle", meanings={"r_b1": "Base radius of the driver"})
def transverse_force(P: Watt, omega_1: RadPerSecond, r_b1: Metre) -> Newton:
    return P / (omega_1 * r_b1)


@formula(
    "X_Γ",
    "ISO/TR 15144-1, unmodified profile: two pairs always carry the whole load together",
    shows="1/3 → 2/3 from A to B, 1 from B to D, 2/3 → 1/3 from D to E",
)
def linear_load_sharing(x: Metres, C_A: Metre, C_B: Metre, C_D: Metre, C_E: Metre) -> Numbers:
    falling = np.where(x > C_D, (1 + (C_E - x) / (C_E - C_D)) / 3, 1.0)
    return np.where(x < C_B, (1 + (x - C_A) / (C_B - C_A)) / 3, falling)


@formula(
    "X_Γ",
    "ISO/TR 15144-1, adequate tip relief of both wheels: two pairs always carry the whole load together",
    shows="0 → 1 from A to B, 1 from B to D, 1 → 0 from D to E",
)
def smooth_load_sharing(x: Metres, C_A: Metre, C_B: Metre, C_D: Metre, C_E: Metre) -> Numbers:
    return np.where(x < C_B, (x - C_A) / (C_B - C_A), np.where(x > C_D, (C_E - x) / (C_E - C_D), 1.0))


@formula(
    "L",
    "geometry of the contact lines on the plane of action; the load is taken as uniform along all of them",
    unit="mm",
    governs="min",
    shows="sum over all teeth in contact of the line that lies between A and E and on the face, over the moments of a "
    "mesh cycle",
)
def contact_length(s: Metres, g_alpha: Metre, g_beta: Metre, p_bt: Metre, beta_b: Radian) -> Metres:
    """s: how far the line of one tooth has come since it entered at A; the others follow and precede it by base
    pitches."""
    cycle = np.asarray(s) % p_bt
    teeth = np.arange(math.ceil((g_alpha + g_beta) / p_bt))
    way = cycle[..., None] + teeth * p_bt
    on_face = np.minimum(way, g_alpha) - np.maximum(way - g_beta, 0.0)
    length: Array = np.maximum(on_face, 0.0).sum(axis=-1) / math.sin(beta_b)
    return length


@formula("w", "statics: load per length of the contact line", unit="N/mm", names={"X_Gamma": "X_Γ"})
def spur_line_load(X_Gamma: Number, F_bt: Newton, b: Metre) -> NewtonPerMetre:
    return X_Gamma * F_bt / b


@formula("w", "statics: load per length of the contact lines, uniform along all of them", unit="N/mm")
def helical_line_load(F_bt: Newton, beta_b: Radian, L: Metre) -> NewtonPerMetre:
    return F_bt / (cos(beta_b) * L)


@formula(
    "w_f",
    "rule of this program: film and pressure see at least 1 % of the full load, also at a relieved tip",
    unit="N/mm",
)
def floored_line_load(w: NewtonPerMetre, w_max: NewtonPerMetre) -> NewtonPerMetre:
    return largest(w, FLOOR * w_max)


# --- both together


@record
class Path:
    """The line of action and the positions on it, strip after strip; the last five of each strip are the points A … E.

    `weight` is the mean length of contact line for which a position stands: Σ weight·(power per length) is the mean
    power. `carried` is what the load follows from: the share X_Γ of a spur pair, the contact length L of a helical one.
    """

    C_A: Metre
    C_B: Metre
    C_C: Metre
    C_D: Metre
    C_E: Metre
    C_F: Metre
    p_bt: Metre
    epsilon_1: Number
    epsilon_2: Number
    epsilon_alpha: Number
    epsilon_beta: Number
    x: Array
    weight: Array
    carried: Array
    per_strip: int
    middle: IndexArray  # of the strip in the middle, by rising x
    cells: Cells

    @property
    def marks(self) -> tuple[float, ...]:
        return self.C_A, self.C_B, self.C_C, self.C_D, self.C_E

    def in_the_middle(self, x: Any) -> Any:
        """What an array has along the strip in the middle of the face, by rising x."""
        return x[..., self.middle]

    def at_pitch_point(self, x: Any) -> float:
        """The value that an array has at C: a float, or one for each of many operating points."""
        return based_on(single_or_many(x[..., self.per_strip - 3]), x)


@cache
def _legendre(points: int) -> tuple[Array, Array]:
    """Nodes and weights of Gauss and Legendre on −1 … 1 by the eigenvalues of their recurrence (Golub & Welsch 1969).

    `numpy.polynomial.legendre.leggauss` gives the same; importing it costs a start-up 4 ms.
    """
    k = np.arange(1, points)
    beside = k / np.sqrt(4.0 * k**2 - 1)
    nodes, vectors = np.linalg.eigh(np.diag(beside, 1) + np.diag(beside, -1))
    return nodes, 2 * vectors[0] ** 2


def _gauss(breaks: Array, points: int) -> tuple[Array, Array]:
    """Gauss-Legendre positions and weights, piece by piece along the last axis."""
    at, weight = _legendre(points)
    middle, half = (breaks[..., 1:] + breaks[..., :-1]) / 2, (breaks[..., 1:] - breaks[..., :-1]) / 2
    rows = (*breaks.shape[:-1], -1)
    return (middle[..., None] + half[..., None] * at).reshape(rows), (half[..., None] * weight).reshape(rows)


def path(mesh: MeshGeometry, load_sharing: str = "linear", *, points: int = 0, strips: int = STRIPS) -> Path:
    """The path of contact of a mesh.  NoSolution where the teeth do not mesh, or a spur pair can not share its load as
    assumed."""
    sound(mesh)
    one, two = mesh.driver, mesh.driven
    where = Text("mesh {title}: path of contact", title=mesh.title)
    if mesh.centre_distance <= one.base_radius + two.base_radius:
        a_w = Amount(mesh.centre_distance * 1000.0, form=".6g")
        overlap = Text("the base circles overlap at a_w = {centre_distance} mm", centre_distance=a_w)
        raise NoSolution(where, overlap, Text("more centre distance"))
    for wheel in (one, two):
        if wheel.tip_radius <= wheel.base_radius:
            inside = Text("the tip of {name} lies inside its base circle", name=wheel.name)
            raise NoSolution(where, inside, Text("a larger tip diameter"))
    alpha_wt = working_pressure_angle(r_b1=one.base_radius, r_b2=two.base_radius, a_w=mesh.centre_distance)
    p_bt = base_pitch(r_b1=one.base_radius, z_1=one.teeth)
    C_F = line_of_action(a_w=mesh.centre_distance, alpha_wt=alpha_wt)
    C_A = start_of_contact(T=C_F, r_a2=two.tip_radius, r_b2=two.base_radius)
    C_E = end_of_contact(r_a1=one.tip_radius, r_b1=one.base_radius)
    C_B = contact.sole_contact_begins(rho_E=C_E, p_bt=p_bt)
    C_D = contact.sole_contact_ends(rho_A=C_A, p_bt=p_bt)
    C_C = contact.pitch_point(T=C_F, z_1=one.teeth, z_2=two.teeth)
    if not 0 < C_A < C_C < C_E < C_F:
        order = Text(
            "0 < A {c_a} < C {c_c} < E {c_e} < F {c_f} m does not hold",
            c_a=Amount(C_A, form=".4g"),
            c_c=Amount(C_C, form=".4g"),
            c_e=Amount(C_E, form=".4g"),
            c_f=Amount(C_F, form=".4g"),
        )
        raise NoSolution(where, order, Text("smaller tip diameters, or more centre distance"))
    epsilon_1 = contact.recess_contact_ratio(rho_E=C_E, rho_C=C_C, p_bt=p_bt)
    epsilon_2 = contact.approach_contact_ratio(rho_C=C_C, rho_A=C_A, p_bt=p_bt)
    epsilon_alpha = transverse_contact_ratio(epsilon_1=epsilon_1, epsilon_2=epsilon_2)
    epsilon_beta = overlap_ratio(b=mesh.face_width, beta_b=mesh.base_helix_angle, p_bt=p_bt)
    if mesh.spur and not 1 <= epsilon_alpha <= 2:
        ratio = Text("ε_α = {epsilon_alpha}", epsilon_alpha=Amount(epsilon_alpha, form=".12g"))
        raise NoSolution(where, ratio, Text("the load sharing of a spur pair needs a contact ratio from 1 to 2"))
    if epsilon_alpha + epsilon_beta < 1:
        ratios = Text("ε_α + ε_β = {epsilon_alpha}", epsilon_alpha=Amount(epsilon_alpha + epsilon_beta, form=".4g"))
        raise NoSolution(where, ratios, Text("below 1 the teeth lose contact: a wider face or higher teeth"))
    places: tuple[float, ...] = (C_A, C_B, C_C, C_D, C_E)
    marks = np.clip(places, C_A, C_E)
    if mesh.spur:
        points = points or POINTS
        x, width = _gauss(np.sort(marks)[None, :], points)
        x, weight = np.hstack((x, marks[None, :])), width * mesh.face_width / p_bt
        share = linear_load_sharing if load_sharing == "linear" else smooth_load_sharing
        with np.errstate(divide="ignore", invalid="ignore"):  # at ε_α = 1 or 2 two of the points are one
            carried = share(x=based_on(x.ravel(), *places), C_A=C_A, C_B=C_B, C_D=C_D, C_E=C_E)
    else:
        g_alpha, g_beta = (based_on(ratio * p_bt, ratio, p_bt) for ratio in (epsilon_alpha, epsilon_beta))
        places = (C_A, C_C, C_E, g_alpha, g_beta, p_bt)
        points = points or HELICAL_POINTS
        x, width, part, s = _strips(marks, g_alpha, g_beta, p_bt, points, strips)
        weight = width * part * mesh.face_width / (math.cos(mesh.base_helix_angle) * p_bt)
        carried = contact_length(
            s=based_on(s.ravel(), *places), g_alpha=g_alpha, g_beta=g_beta, p_bt=p_bt, beta_b=mesh.base_helix_angle
        )
    parts = cells(x, width, points, marks.size)
    middle = len(x) // 2 * x.shape[-1] + np.argsort(x[len(x) // 2], kind="stable")
    weight = np.hstack((weight, np.zeros((len(x), marks.size))))
    of_weight = (*places, p_bt, mesh.face_width, mesh.base_helix_angle)
    return Path(
        C_A=C_A,
        C_B=C_B,
        C_C=C_C,
        C_D=C_D,
        C_E=C_E,
        C_F=C_F,
        p_bt=p_bt,
        epsilon_1=epsilon_1,
        epsilon_2=epsilon_2,
        epsilon_alpha=epsilon_alpha,
        epsilon_beta=epsilon_beta,
        x=based_on(x.ravel(), *places),
        weight=based_on(weight.ravel(), *of_weight),
        carried=carried,
        per_strip=x.shape[-1],
        middle=middle,
        cells=parts,
    )


def _strips(
    marks: Array, g_alpha: Metre, g_beta: Metre, p_bt: Metre, points: int, strips: int
) -> tuple[Array, Array, Array, Array]:
    """Positions on each strip of a helical face, their widths, the share of the strip in the face, how far their
    contact line has come.

    The load has a kink wherever the line of some tooth begins or ends to enter at A or leave at E.
    """
    C_A, C_C, C_E = marks[0], marks[2], marks[4]
    y, width = _gauss(np.array([0.0, g_beta]), strips)  # how much later each strip is
    kinks = (np.array([0.0, g_alpha, g_beta, g_alpha + g_beta]) - y[:, None]) % p_bt
    breaks = [np.minimum(C_A + kinks + turn * p_bt, C_E) for turn in range(math.ceil(g_alpha / p_bt))]
    x, width_x = _gauss(np.sort(np.hstack((*breaks, np.broadcast_to([C_A, C_C, C_E], (strips, 3))))), points)
    x = np.hstack((x, np.broadcast_to(marks, (strips, marks.size))))
    return x, width_x, width[:, None] / g_beta, x - C_A + y[:, None]


def line_load(mesh: MeshGeometry, path: Path, F_bt: Any) -> tuple[Array, Array]:
    """The load per length at every position, and the same with its floor for film and pressure."""
    require(Text("mesh {title}: force", title=mesh.title), F_bt)
    if mesh.spur:
        w: Array = spur_line_load(X_Gamma=path.carried, F_bt=F_bt, b=mesh.face_width)
        return w, floored_line_load(w=w, w_max=based_on(F_bt / mesh.face_width, F_bt, mesh.face_width))
    w = helical_line_load(F_bt=F_bt, beta_b=mesh.base_helix_angle, L=path.carried)
    return w, w


# --- two cylinders in place of two flanks: curvature and speeds at every position of the path
# Speeds are those of the transverse section along the flank, as ISO and AGMA use them; the curvature is that of the
# section normal to the contact line.  At the pitch point both surfaces have one speed and nothing slides, to the last
# digit.


@formula("n_2", "kinematics, ratio of the teeth", unit="rpm")
def wheel_speed(n: RevPerSecond, z_1: Number, z_2: Number) -> RevPerSecond:
    return n * z_1 / z_2


@formula("ω_1", "definition of angular speed")
def driver_speed(n_1: RevPerSecond) -> RadPerSecond:
    return 2 * pi * n_1


@formula("ω_2", "kinematics, ratio of the teeth")
def driven_speed(omega_1: RadPerSecond, z_1: Number, z_2: Number) -> RadPerSecond:
    return omega_1 * z_1 / z_2


@formula(
    "V_s",
    "kinematics: |u_1 − u_2|, written by the distance from the pitch point, where it is 0",
    names={"x": "ρ_1"},
    meanings={"x": "Radius of curvature of the driver there"},
)
def sliding_speed(omega_1: RadPerSecond, omega_2: RadPerSecond, x: Metre, rho_C: Metre) -> MetrePerSecond:
    return (omega_1 + omega_2) * abs(x - rho_C)


@formula("u_e", Text("{agma}: entrainment speed, the mean of both surfaces", agma=AGMA))
def entrainment_speed(u_1: MetrePerSecond, u_2: MetrePerSecond) -> MetrePerSecond:
    return (u_1 + u_2) / 2


@formula("S", "definition of the slide-to-roll ratio")
def slide_to_roll(V_s: MetrePerSecond, u_e: MetrePerSecond) -> Number:
    return V_s / u_e


@record
class Motion:
    """What the positions have whatever the load: angular speed of the driver, curvature and surface speeds, common
    modulus."""

    omega_1: Any
    R: Array
    u_1: Array
    u_2: Array
    V_s: Array
    u_e: Array
    S: Array
    E_r: Pascal


def motion(mesh: MeshGeometry, path: Path, n_1: Num) -> Motion:
    """The kinematics of a mesh whose driver turns at n_1, one speed or many."""
    n = column(require(Text("mesh {title}: speed", title=mesh.title), n_1))
    omega_1 = driver_speed(n_1=n)
    n_2 = wheel_speed(n=n, z_1=mesh.driver.teeth, z_2=mesh.driven.teeth)
    omega_2 = driven_speed(omega_1=omega_1, z_1=mesh.driver.teeth, z_2=mesh.driven.teeth)
    rho_2 = contact.driven_curvature(T=path.C_F, rho_1=path.x)
    u_1, u_2 = contact.rolling_speed(n=n, rho=path.x), contact.rolling_speed(n=n_2, rho=rho_2)
    V_s = sliding_speed(omega_1=omega_1, omega_2=omega_2, x=path.x, rho_C=path.C_C)
    u_e = entrainment_speed(u_1=u_1, u_2=u_2)
    return Motion(
        omega_1=omega_1,
        R=contact.normal_relative_radius(
            rho_rel=contact.relative_radius(rho_1=path.x, rho_2=rho_2), beta_b=mesh.base_helix_angle
        ),
        u_1=u_1,
        u_2=u_2,
        V_s=V_s,
        u_e=u_e,
        S=slide_to_roll(V_s=V_s, u_e=u_e),
        E_r=contact.reduced_modulus(
            nu_1=mesh.driver.poisson, E_1=mesh.driver.E, nu_2=mesh.driven.poisson, E_2=mesh.driven.E
        ),
    )
