# SPDX-License-Identifier: Apache-2.0
"""Forces and couples of one order, of one engine or of many: their vectors, the ellipses these draw, and their peaks."""

from typing import Any

import numpy as np

from ..engine.inputs import EngineInputs
from ..engine.solve import EngineResult
from ..sheet.quantity import group, result, value
from ..sheet.units import Newton, NewtonMetre, Radian
from ..sheet.value import based_on
from . import formulas as f
from . import unlike_masses as u
from .inputs import ImbalanceInputs

DUST = 1e-9  # of one cylinder's m·r·ω²: so little is not worth a figure


@result
class Order:
    """One order: the vectors turning with and against the crank at n times its speed, after the crank's own counterweights.

    Peak, least and axis are half the long axis, half the short axis and the direction of the long axis of the ellipse that the
    two vectors draw; a circle has no axis.
    """

    force_forward: Newton = value("Force turning forward", "N", "F⁺")
    force_forward_phase: Radian = value("its phase", "°")
    force_backward: Newton = value("Force turning backward", "N", "F⁻")
    force_backward_phase: Radian = value("its phase", "°")
    force_peak_vertical: Newton = value("Largest vertical force", "N", "F_V")
    force_peak_horizontal: Newton = value("Largest horizontal force", "N", "F_H")
    force_peak: Newton = value("Largest force", "N", "F_max")
    force_least: Newton = value("Smallest force over the turn", "N", "F_min")
    force_axis: Radian | None = value("Direction of the largest force", "°", "∠F_max")
    couple_forward: NewtonMetre = value("Couple turning forward", "N·m", "C⁺")
    couple_forward_phase: Radian = value("its phase", "°")
    couple_backward: NewtonMetre = value("Couple turning backward", "N·m", "C⁻")
    couple_backward_phase: Radian = value("its phase", "°")
    couple_peak_vertical: NewtonMetre = value("Largest vertical couple", "N·m", "C_V")
    couple_peak_horizontal: NewtonMetre = value("Largest horizontal couple", "N·m", "C_H")
    couple_peak: NewtonMetre = value("Largest couple", "N·m", "C_max")
    couple_least: NewtonMetre = value("Smallest couple over the turn", "N·m", "C_min")
    couple_axis: Radian | None = value("Direction of the largest couple", "°", "∠C_max")
    vectors: tuple[complex, complex, complex, complex]  # F⁺ F⁻ C⁺ C⁻
    unbalanced: tuple[complex, complex, complex, complex]  # the same with no share of the reciprocating masses on the crank
    two_term: "Order | None" = group(default=None)


def order(n: int, c_n: Any, imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult) -> Order:
    """Order n of engines whose crank carries a share of the reciprocating and rotating masses; `c_n`: the harmonic of a/(ω² r)."""
    crank: Any = e.crank  # arrays enter the formulas here
    sums: Any = f if e.unlike is None else u
    place: dict[str, Any] = dict(omega=e.angular_speed, r=engine.crank_radius, theta_0=crank.theta_0, phi=crank.phi)
    common = place | {"m": e.reciprocating_mass if e.unlike is None else e.unlike.reciprocating}
    F_f = F_f0 = sums.force_forward(c_n=c_n, n=float(n), psi=crank.psi, **common)
    F_b = sums.force_backward(c_n=c_n, n=float(n), psi=crank.psi, **common)
    C_f = C_f0 = sums.couple_forward(c_n=c_n, n=float(n), z=crank.z, psi=crank.psi, **common)
    C_b = sums.couple_backward(c_n=c_n, n=float(n), z=crank.z, psi=crank.psi, **common)
    if n == 1:
        kappa, rho = imbalance.crank_balance_fraction, imbalance.rotating_balance_fraction
        M_rot = e.rotating_mass if e.unlike is None else e.unlike.rotating
        if np.any(rho != 1):
            F_f0 = f.with_rotating_force(F_1=F_f, F_rot=sums.rotating_force(rho=rho, M_rot=M_rot, **place))
            C_f0 = f.with_rotating_couple(C_1=C_f, C_rot=sums.rotating_couple(rho=rho, M_rot=M_rot, z=crank.z, **place))
        F_f0, C_f0 = based_on(F_f0, F_f0, rho), based_on(C_f0, C_f0, rho)
        F_f = f.remaining_force(F_f0, sums.counterweight_force(kappa=kappa, **common))
        C_f = f.remaining_couple(C_f0, sums.counterweight_couple(kappa=kappa, z=crank.z, **common))
    return Order(
        force_forward=f.force_length(F=F_f),
        force_forward_phase=f.force_direction(F=F_f),
        force_backward=f.force_length(F=F_b),
        force_backward_phase=f.force_direction(F=F_b),
        force_peak_vertical=f.force_peak_vertical(F_f, F_b),
        force_peak_horizontal=f.force_peak_horizontal(F_f, F_b),
        force_peak=f.force_peak(F_f, F_b),
        force_least=f.force_least(F_f, F_b),
        force_axis=_axis(f.force_axis, F_f, F_b),
        couple_forward=f.couple_length(C=C_f),
        couple_forward_phase=f.couple_direction(C=C_f),
        couple_backward=f.couple_length(C=C_b),
        couple_backward_phase=f.couple_direction(C=C_b),
        couple_peak_vertical=f.couple_peak_vertical(C_f, C_b),
        couple_peak_horizontal=f.couple_peak_horizontal(C_f, C_b),
        couple_peak=f.couple_peak(C_f, C_b),
        couple_least=f.couple_least(C_f, C_b),
        couple_axis=_axis(f.couple_axis, C_f, C_b),
        vectors=(F_f, F_b, C_f, C_b),
        unbalanced=(F_f0, F_b, C_f0, C_b),
    )


def _axis(formula: Any, forward: Any, backward: Any) -> Any:
    """The direction of an ellipse's long axis; None for a circle, NaN for one among many."""
    there: Any = (np.abs(forward) > 0) & (np.abs(backward) > 0)
    if not np.any(there):
        return None
    axis = formula(forward, backward)
    return np.where(there, axis, np.nan) if isinstance(axis, np.ndarray) else axis
