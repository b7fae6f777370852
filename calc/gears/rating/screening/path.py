# SPDX-License-Identifier: Apache-2.0
"""The points on the path of contact: curvatures, speeds, and the share of the load that one pair of teeth carries
there.

A place is told by ρ_1, the radius of curvature of the driver's flank: 0 where the line of action touches its base
circle, T_1T_2 at that of the driven wheel.  A: contact begins; B: the pair before leaves; C: pitch point; D: the next
pair comes; E: contact ends. The pair is loaded alone from B to D."""

from itertools import pairwise
from typing import Generic

import numpy as np

from ....library import contact as line
from ....sheet.arrays import Array, Value
from ....sheet.formula import formula
from ....sheet.functions import largest, sin, smallest
from ....sheet.record import record
from ....sheet.text import Text
from ....sheet.units import Metre, Number, Radian
from ....sheet.value import based_on
from ...result import MeshResult, ToothSystem, WheelResult

ISO_PATH = Text("ISO/TR 13989-1:2000 and ISO/TR 15144-1:2014")
POINTS = 21  # samples of each of the three parts of the path
ALONE: Number = 1.0  # share of the load of a pair that nothing helps
LIGHTEST = 1e-9  # share of the load
BESIDE = 1e-12  # how far beside B and D, of their place, the samples of the shared load stand
FINEST: Number = 7.0  # the finest accuracy grade of which the load sharing still takes notice
BUTTRESS: Number = 0.2  # of sin β_b, in radii of curvature at the pitch point


@formula(
    "ρ_E",
    Text("{geometry}: the driver's radius of curvature at the end of contact", geometry=line.GEOMETRY),
    unit="mm",
    names={"T": "T_1T_2", "rho_A2": "ρ_A2"},
)
def end_of_contact(T: Metre, rho_A2: Metre) -> Metre:
    return T - rho_A2


@formula(
    "X_Γ",
    Text("{iso_path}: unmodified profile; two pairs share the load as their accuracy lets them", iso_path=ISO_PATH),
    shows="(Q − 2)/15 + 1/3·way from A to B; 1 from B to D; (Q − 2)/15 + 1/3·way from E to D; Q the accuracy grade, "
    "at least 7; at most 1",
)
def load_share(rho_1: Metre, rho_A: Metre, rho_B: Metre, rho_D: Metre, rho_E: Metre, Q: Number) -> Number:
    """Of spur and narrow helical wheels (ε_γ below 2).  Transverse contact ratios of 2 and more are outside the method:
    1."""
    base = (max(Q, FINEST) - 2) / 15
    if not rho_A < rho_B <= rho_D:
        return ALONE + 0.0 * rho_1
    before, after = base + (rho_1 - rho_A) / (rho_B - rho_A) / 3, base + (rho_E - rho_1) / (rho_E - rho_D) / 3
    if isinstance(rho_1, float):
        return min(before if rho_1 < rho_B else after if rho_1 > rho_D else ALONE, ALONE)
    share = np.where(rho_1 < rho_B, before, np.where(rho_1 > rho_D, after, ALONE))
    return np.clip(share, LIGHTEST, ALONE)  # the last digits of a contact ratio of 1 would make it nothing, or less


@formula(
    "ρ_AU − ρ_A",
    "ISO/TR 13989-1:2000 (49): way on which the ends of oblique contact lines are stiffer; ρ_C of the smaller wheel",
    unit="mm",
)
def buttressed_way(rho_C: Metre, beta_b: Radian) -> Metre:
    return BUTTRESS * sin(beta_b) * rho_C


@formula(
    "X_but",
    "ISO/TR 13989-1:2000 (51) to (56): buttressing of helical teeth at the ends of the path",
    shows="1 + 0.3·min(ε_β, 1) at A and E, falling to 1 over the way ρ_AU − ρ_A",
)
def buttressing(rho_1: Metre, rho_A: Metre, rho_E: Metre, way: Metre, eps_beta: Number) -> Number:
    near = largest(1 - (rho_1 - rho_A) / way, 0.0) + largest(1 - (rho_E - rho_1) / way, 0.0)
    return 1 + 0.3 * min(eps_beta, 1.0) * smallest(near, 1.0)


@formula("X_Γ", "ISO/TR 13989-1:2000, narrow helical wheels (ε_γ below 2)", names={"X": "X_Γ,spur"})
def narrow_helical_share(X: Number, X_but: Number) -> Number:
    return X * X_but


@formula("X_Γ", "ISO/TR 13989-1:2000 (76), wide helical wheels (ε_γ of 2 and more): the mean load of a pair")
def wide_helical_share(X_but: Number, eps_alpha: Number) -> Number:
    return X_but / eps_alpha


@record
class PathPoint(Generic[Value]):
    """One point of the path, or many: curvatures [m], rolling speeds [m/s], load share."""

    rho_1: Value
    rho_2: Value
    rho_rel: Value
    rho_n: Value
    v_1: Value
    v_2: Value
    X: Value


class Path:
    """The path of contact of a mesh; Q the accuracy grade."""

    def __init__(
        self, system: ToothSystem, mesh: MeshResult, driver: WheelResult, driven: WheelResult, Q: Number
    ) -> None:
        self.mesh, self.driver, self.driven = mesh, driver, driven
        self.beta_b, self.n_1, self.n_2, self.Q = system.base_helix_angle, driver.speed, driven.speed, Q
        self.T, self.eps_alpha, self.eps_beta = mesh.line_of_action, mesh.transverse_contact_ratio, mesh.overlap_ratio
        self.A = mesh.sap_curvature_driver
        self.C = line.pitch_point(T=self.T, z_1=driver.teeth, z_2=driven.teeth)
        self.E = end_of_contact(T=self.T, rho_A2=mesh.sap_curvature_driven)
        self.B = line.sole_contact_begins(rho_E=self.E, p_bt=system.base_pitch)
        self.D = line.sole_contact_ends(rho_A=self.A, p_bt=system.base_pitch)
        self.wide = system.beta > 0 and mesh.total_contact_ratio >= 2
        self.eps_1 = line.recess_contact_ratio(rho_E=self.E, rho_C=self.C, p_bt=system.base_pitch)
        self.eps_2 = line.approach_contact_ratio(rho_C=self.C, rho_A=self.A, p_bt=system.base_pitch)
        rho_2C = line.driven_curvature(T=self.T, rho_1=self.C)
        smaller = self.C if driver.teeth <= driven.teeth else rho_2C
        self.way = buttressed_way(rho_C=smaller, beta_b=self.beta_b) if system.beta else 0.0
        self.rho_relC = line.relative_radius(rho_1=self.C, rho_2=rho_2C)
        self.rho_nC = line.normal_relative_radius(rho_rel=self.rho_relC, beta_b=self.beta_b)
        self.v_C = line.rolling_speed(n=self.n_1, rho=self.C)  # of both flanks: there they roll
        contact = self.A, self.B, self.C, self.D, self.E, self.T, self.eps_alpha, self.eps_beta
        self.depends_on = (*contact, self.n_1, self.n_2, self.beta_b, self.way, Q)

    @property
    def shared_by_two(self) -> bool:
        """Whether the load sharing of the methods holds: one pair, then two, then one."""
        return self.wide or self.eps_alpha < 2

    def marks(self) -> dict[str, Metre]:
        """A, AB, B, C, D, DE, E: the points of method B, those that lie on the path."""
        A, B, D, E = self.A, self.B, self.D, self.E
        places = {
            "A": A,
            "AB": based_on((A + B) / 2, A, B),
            "B": B,
            "C": self.C,
            "D": D,
            "DE": based_on((D + E) / 2, D, E),
            "E": E,
        }
        return {name: rho for name, rho in places.items() if A <= rho <= E}

    def samples(self) -> Array:
        """Places from A to E, close beside B and D on both sides, where the load jumps."""
        inner = sorted((min(max(self.B, self.A), self.E), min(max(self.D, self.A), self.E)))
        ends = (self.A, *inner, self.E)
        parts = [np.linspace(a, b, POINTS) for a, b in pairwise(ends)]
        # to the last digit: on which side of B and D a sample stands decides its load
        parts[0][-1] *= 1 - BESIDE
        parts[2][0] *= 1 + BESIDE
        return based_on(np.concatenate(parts), self.A, self.B, self.D, self.E)

    def at(self, rho_1: Value) -> PathPoint[Value]:
        """A point, or an array of them."""
        rho_2 = line.driven_curvature(T=self.T, rho_1=rho_1)
        rho_rel = line.relative_radius(rho_1=rho_1, rho_2=rho_2)
        rho_n = line.normal_relative_radius(rho_rel=rho_rel, beta_b=self.beta_b)
        v_1, v_2 = line.rolling_speed(n=self.n_1, rho=rho_1), line.rolling_speed(n=self.n_2, rho=rho_2)
        return PathPoint(rho_1, rho_2, rho_rel, rho_n, v_1, v_2, self._share(rho_1))

    def _share(self, rho_1: Value) -> Value:
        if self.way <= BESIDE * self.T:  # spur, or a helix too small to count
            return load_share(rho_1=rho_1, rho_A=self.A, rho_B=self.B, rho_D=self.D, rho_E=self.E, Q=self.Q)
        X_but = buttressing(rho_1=rho_1, rho_A=self.A, rho_E=self.E, way=self.way, eps_beta=self.eps_beta)
        if self.wide:
            return wide_helical_share(X_but=X_but, eps_alpha=self.eps_alpha)
        X = load_share(rho_1=rho_1, rho_A=self.A, rho_B=self.B, rho_D=self.D, rho_E=self.E, Q=self.Q)
        return narrow_helical_share(X=X, X_but=X_but)
