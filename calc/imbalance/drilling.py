# SPDX-License-Identifier: Apache-2.0
"""Which webs of the crank to drill, by how many grams and where: what the screen of a balancing machine says (Finotti 2013, 2.6).

A web is drilled away from its pin only, within `WITHIN` of the direction opposite to it: that is a rule of this program.  A mass along
any direction there is the sum of shares along the two ends of that range, so that the least mass that leaves neither force nor couple is
the best corner of a small linear programme.
"""

import math
from itertools import combinations

import numpy as np

from ..sheet.arrays import Array, ComplexArray, each, many, phasors
from ..sheet.formula import formula
from ..sheet.functions import argument, modulus, total
from ..sheet.linked_array import gathered
from ..sheet.quantity import result, value
from ..sheet.text import Text
from ..sheet.trace import about
from ..sheet.units import Kilogram, Metre, PhasorKilogramMetre, PhasorKilogramMetre2, Radian
from ..sheet.value import based_on
from .inputs import ImbalanceInputs
from .orders import DUST

WITHIN = math.radians(75.0)  # to either side of the direction opposite to the pin
MOST = 16  # webs of which the best choice is looked for
UNDRILLED = Text(
    "Which webs to drill is not found: it takes the bodies of the crank with at least two webs, and an unbalance that holes within "
    "{degrees}° of the side away from the pins can take; else bobs or webs must change.", degrees=round(math.degrees(WITHIN)),
)  # fmt: skip
SOURCE = Text(
    "Finotti 2013, 2.6: the machine says which webs to drill and how much; here the least mass in all that leaves S = 0 and C = 0"
)


@formula("U_k", SOURCE, shows="least Σ|U_k|/r_d with ΣU_k = S, ΣU_k·z_k = C, U_k on the web's side away from its pin", unit="kg·mm")
def removed(S: PhasorKilogramMetre, C: PhasorKilogramMetre2, z: Metre, psi: Radian) -> PhasorKilogramMetre:
    """The unbalance to take away at every web; ψ are the directions opposite to the pins.  No numbers where it can not be done."""
    ends = np.concatenate([np.exp(1j * (psi - WITHIN)), np.exp(1j * (psi + WITHIN))])
    places = np.tile(np.asarray(many(z)), 2)
    arm = float(np.max(np.abs(places))) or 1.0
    rows = np.array([ends.real, ends.imag, ends.real * places / arm, ends.imag * places / arm])
    wanted = np.array([S.real, S.imag, C.real / arm, C.imag / arm])
    chosen = np.array(list(combinations(range(ends.size), 4)))
    systems = np.moveaxis(rows[:, chosen], 0, 1)  # (choices, 4, 4)
    sound = np.abs(np.linalg.det(systems)) > 1e-9
    shares = np.linalg.solve(systems[sound], np.broadcast_to(wanted, (int(sound.sum()), 4))[..., None])[..., 0]
    possible = np.flatnonzero(np.all(shares >= -1e-12, axis=1))
    found: ComplexArray = np.full(places.size // 2, np.nan, complex)
    if possible.size:
        best = possible[np.argmin(np.sum(shares[possible], axis=1))]
        share = np.zeros(ends.size)
        share[chosen[sound][best]] = np.maximum(shares[best], 0.0)
        found = np.sum((share * ends).reshape(2, -1), axis=0)
    return each(found)


@formula("m_k", "Finotti 2013, 2.6: mass to drill out of a web", unit="g")
def drilled(U: PhasorKilogramMetre, r_d: Metre) -> Kilogram:
    return modulus(U) / r_d


@formula("Σm_k", "mathematics: sum over the webs", unit="g")
def in_all(m_k: Kilogram) -> Kilogram:
    return total(m_k)


@formula("∠U_k", "mathematics: direction of the hole, while the throw that the list of bodies names stands up")
def direction(U: PhasorKilogramMetre) -> Radian:
    return argument(U)


@result
class WebDrilling:
    """One web."""

    mass: Kilogram = value("Mass to drill out", "g", "m_k")
    angle: Radian = value("Direction of the hole, the named throw up", "°")


def drilling(
    imbalance: ImbalanceInputs, S: complex, C: complex, p: ComplexArray, z: Array
) -> tuple[dict[str, WebDrilling] | None, Kilogram | None]:
    """The webs to drill, by name and together, for a crank with the unbalance S and the couple product C; none where it can not be done.

    `p`, `z`: centres of gravity of the bodies.
    """
    radius, bodies = imbalance.drill_radius, imbalance.crank_bodies
    webs = [k for k, body in enumerate(bodies) if body.pin is None]
    pins = [k for k, body in enumerate(bodies) if body.pin is not None]
    if radius is None or not 2 <= len(webs) <= MOST:
        return None, None
    nearest = [min(pins, key=lambda pin: abs(bodies[pin].z - bodies[k].z)) for k in webs]
    away = based_on(np.angle(-np.asarray(p)[nearest]), p)
    with about(Text("webs to drill")):
        U = phasors(removed(S=S, C=C, z=each(based_on(np.asarray(z)[webs], z)), psi=each(away)))
        if not np.all(np.isfinite(U)):
            return None, None
        found = {
            bodies[k].name: WebDrilling(mass=drilled(U=u, r_d=radius), angle=direction(U=u))
            for k, u in zip(webs, (based_on(complex(u), U) for u in U))
            if abs(u) > DUST * float(np.sum(np.abs(U)))
        }
        return found, in_all(m_k=each(gathered(web.mass for web in found.values())))
