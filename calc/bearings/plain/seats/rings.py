# SPDX-License-Identifier: Apache-2.0
"""A bush or shell pressed into its housing, as the film has to know it: the clearance at every temperature.

Every number may be an array (many sizes, corners, temperatures at once)."""

from typing import Any, NamedTuple

from ....library.catalogue import Material
from ....sheet.record import record
from ....sheet.units import Metre, Number, Pascal
from ....sheet.value import based_on, untraced
from . import formulas as f

HOUSING_RATIO = 2.0  # D/d_o where nothing is given; rule of this program


class Fit(NamedTuple):
    """Two rings at the reference temperature: their diameters and compliances."""

    d_i: Any
    d_o: Any
    D: Any
    k_B: Any
    k_H: Any


class State(NamedTuple):
    """The fit at a temperature: interference, pressure, closing of the bore."""

    delta: Any
    p: Any
    c: Any


@record
class Rings:
    """`bore`: of the housing, `journal`: of the shaft, middles of their limits; None: from wall, diameter and
    clearance.  `interference`: least and most at the reference temperature."""

    backing: Material
    housing: Material
    wall: Metre
    restraint: Number  # χ
    reference: float  # °C
    interference: tuple[Metre, Metre]
    chosen: bool = False  # the interference is the program's
    bore: Metre | None = None
    journal: Metre | None = None
    outside: Metre | None = None  # D

    @property
    def middle(self) -> Metre:
        least, most = self.interference
        return based_on((least + most) / 2, least, most)

    def fit(self, diameter: Any, clearance: Any) -> Fit:
        """For a journal of this nominal diameter and the clearance as assembled at the reference temperature."""
        d_i = f.assembled_bore(d_J=diameter if self.journal is None else self.journal, g=clearance)
        return self.fit_of(f.outside_of_bush(d_i=d_i, w=self.wall) if self.bore is None else self.bore, d_i)

    def quiet_fit(self, diameter: Any, clearance: Any) -> Fit:
        """The same without lines, which stand with the seat."""
        with untraced():
            fit = self.fit(diameter, clearance)
        of = diameter, clearance, self.wall, self.bore, self.journal, self.outside
        return fit._replace(d_i=based_on(fit.d_i, *of), d_o=based_on(fit.d_o, *of))

    def fit_of(self, d_o: Any, d_i: Any) -> Fit:
        D = f.housing_outside(D_rel=HOUSING_RATIO, d_o=d_o) if self.outside is None else self.outside
        k_B = f.bush_compliance(d_o=d_o, d_i=d_i, nu_B=self.backing.poisson, E_B=self.backing.E)
        k_H = f.housing_compliance(D=D, d_o=d_o, nu_H=self.housing.poisson, E_H=self.housing.E)
        return Fit(d_i, d_o, D, k_B, k_H)

    def at(self, fit: Fit, delta: Any, T_B: Any, T_H: Any) -> State:
        """The fit with interference `delta` at the reference temperature, once bush and housing are so warm."""
        there = f.interference_at(
            delta=delta,
            d_o=fit.d_o,
            alpha_B=self.backing.expansion,
            T_B=T_B,
            alpha_H=self.housing.expansion,
            chi=self.restraint,
            T_H=T_H,
            T_ref=self.reference,
        )
        return self.pressed(fit, there)

    def pressed(self, fit: Fit, delta: Any) -> State:
        p = f.press(delta=delta, d_o=fit.d_o, k_B=fit.k_B, k_H=fit.k_H)
        return State(delta, p, f.closing(p=p, d_i=fit.d_i, d_o=fit.d_o, E_B=self.backing.E))

    def clearance_at(self, diameter: Any, clearance: Any, journal_expansion: float, T: Any, T_H: Any) -> Any:
        """`T`: of journal and bush, `T_H`: of the housing."""
        fit = self.quiet_fit(diameter, clearance)
        with untraced():
            c_i = self.pressed(fit, self.middle).c
        c_i = based_on(c_i, fit.d_i, self.interference)
        c_T = self.at(fit, self.middle, T, T_H).c
        d_iT = f.bore_at(d_i=fit.d_i, c_i=c_i, alpha_B=self.backing.expansion, T_B=T, T_ref=self.reference, c_T=c_T)
        d_J = based_on(fit.d_i - clearance, diameter if self.journal is None else self.journal)
        return f.clearance_in(d_iT=d_iT, d_J=d_J, alpha_J=journal_expansion, T=T, T_ref=self.reference)

    def rise(self, diameter: Any, clearance: Any) -> Any:
        """By how much the seated bore stands wider than housing bore and walls leave it, at the middle interference."""
        return self.middle - self.pressed(self.fit(diameter, clearance), self.middle).c

    def needed(self, fit: Fit, p_need: Pascal, T_B: float, T_H: float) -> Metre:
        """Interference at the reference temperature that leaves this pressure at others."""
        delta: Metre = f.interference_needed(
            p_need=p_need,
            d_o=fit.d_o,
            k_B=fit.k_B,
            k_H=fit.k_H,
            alpha_B=self.backing.expansion,
            T_B=T_B,
            alpha_H=self.housing.expansion,
            chi=self.restraint,
            T_H=T_H,
            T_ref=self.reference,
        )
        return delta
