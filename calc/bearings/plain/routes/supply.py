# SPDX-License-Identifier: Apache-2.0
"""How the oil comes in: through the seat or the shaft, by a hole, a pocket or a groove, at rest beside the load or
swept by it."""

from math import pi
from typing import Any

from ....library.lubricant import OilState
from ....sheet.arrays import Value
from ....sheet.errors import NoSolution
from ....sheet.text import Amount, Text
from ....sheet.value import based_on
from ...inputs import BearingsInputs
from .. import formulas as f
from . import flow
from .states import BearingCase, OperatingPoint

LOADED_HALF = pi / 2  # on either side of the load; rule of this program


def keeps_its_angle(inputs: BearingsInputs) -> bool:
    """Whether the feed turns with the load, so that the angle between them stays; else the load sweeps over it."""
    carrier = 1.0 if inputs.supply == "shaft" else inputs.bush_speed_ratio
    return bool(inputs.load_speed_ratio == carrier)


def lands(inputs: BearingsInputs) -> int:
    """Into how many bearings the oil supply parts the film: two where a groove lies in the loaded half, else one."""
    if inputs.supply != "groove":
        return 1
    if inputs.groove_arc is None or not keeps_its_angle(inputs):
        return 2
    start, end = inputs.groove_arc
    return 1 if start >= LOADED_HALF and end <= 2 * pi - LOADED_HALF else 2


def bare_length(inputs: BearingsInputs, l: Value) -> Value:
    """The lengths that carry, of any shape: without the groove where it parts the film into two lands."""
    return l if lands(inputs) == 1 else l - _given(inputs.groove_width)


def supply_flow(
    seat: BearingCase[Any], duty: OperatingPoint[Any], psi: Any, eps: Any, oil: OilState[Any], *, opposite: bool = False
) -> Any:
    """Q₂, what the supply pressure drives through the bearing.

    `opposite`: as the source has it, a hole in the seat that is always opposite the load, even where the load turns.
    Raises NoSolution where the pressure does not reach the film (numbers; in arrays nan).
    """
    b, inputs = seat.bearing, seat.inputs
    d, l, p_s = b.diameter, b.length, duty.supply_pressure
    if inputs.supply == "groove":
        q_2 = _groove_factor(inputs, eps, d, l)
    elif inputs.supply == "axial_groove":
        long: float = _given(inputs.axial_groove_length)
        q = flow.pocket_factor(x=flow.share_of_length(b=long, l=l))
        q_2 = flow.supply_factor(E=_at_grooves(inputs, eps), l=l, b=long, q=q)
    else:
        if opposite:
            E = flow.opposite(eps=eps)
        elif keeps_its_angle(inputs):
            E = flow.at_angle(eps=eps, delta=inputs.supply_angle)
        else:
            E = flow.swept(eps=eps)
        if inputs.supply == "pocket":
            width: float = _given(inputs.pocket_width)
            q = flow.pocket_factor(x=flow.share_of_length(b=width, l=l))
        else:
            width = _given(inputs.hole_diameter)
            q = flow.hole_factor(x=flow.share_of_length(b=width, l=l))
        q_2 = flow.supply_factor(E=E, l=l, b=width, q=q)
        if inputs.supply == "shaft" and not opposite:
            p_s = _through_shaft(duty, oil, d)
    return flow.supply_flow(d=d, psi=psi, p_s=p_s, mu=oil.mu, q_2=q_2)


def _at_grooves(inputs: BearingsInputs, eps: Any) -> Any:
    """E of all axial grooves, each as a pocket of its length at its angle."""
    angles = inputs.axial_groove_angles or ()
    first, *others = (flow.at_angle(eps=eps, delta=based_on(delta, angles)) for delta in angles)
    for more in others:
        first = flow.together(one=first, more=more)
    return first


def _groove_factor(inputs: BearingsInputs, eps: Any, d: Any, l: Any) -> Any:
    width = _given(inputs.groove_width)
    if inputs.groove_arc is None:
        return flow.groove_factor(eps=eps, d=d, l=l, b_G=width)
    start, end = inputs.groove_arc
    if keeps_its_angle(inputs):
        return flow.part_groove_factor(
            eps=eps, phi_A=flow.from_widest(delta=start), phi_E=flow.from_widest(delta=end), d=d, l=l, b_G=width
        )
    return flow.swept_part_groove_factor(eps=eps, delta_A=start, delta_E=end, d=d, l=l, b_G=width)


def _given(x: float | None) -> float:
    return 0.0 if x is None else x


def _through_shaft(duty: OperatingPoint[Any], oil: OilState[Any], d: Any) -> Any:
    p = flow.pressure_through_shaft(p_s=duty.supply_pressure, rho=oil.rho, omega=f.angular_speed(n=duty.speed), d=d)
    if isinstance(p, float):
        if p <= 0:
            raise NoSolution(
                Text("no oil reaches the bearing through the shaft"),
                Text(
                    "centrifugal head {supply_pressure} bar",
                    supply_pressure=Amount((duty.supply_pressure - p) / 100000.0, form=".2f"),
                ),
                Text("raise the supply pressure or feed through the seat"),
            )
        return p
    arrives = p > 0
    return p * arrives / arrives  # nan where nothing arrives
