# SPDX-License-Identifier: Apache-2.0
"""The throws by themselves: the centrifugal force of each, their polygons of forces and couples, and the balance of six
systems.

Vectors as in `formulas`: real up, imaginary 90° further in the sense of crank rotation, cylinder 1 at TDC, z from
mid-engine.  A couple lies in the plane of its throw; turned by 90° it is the vector of the moment that the textbooks
draw."""

from collections.abc import Mapping

import numpy as np

from ..engine.crank import Crank, column
from ..engine.inputs import EngineInputs
from ..engine.result import EngineResult
from ..sheet.arrays import ComplexArray
from ..sheet.formula import formula
from ..sheet.functions import cis, modulus, resultant
from ..sheet.quantity import result, value
from ..sheet.shown import Shown
from ..sheet.step import Curve, Series, Table
from ..sheet.text import Amount, Text
from ..sheet.units import Kilogram, Metre, Metres, Newton, NewtonMetre, Number, Radians, RadPerSecond
from .orders import DUST, Order, harmonics, masses, measures, radius
from .remedies import equivalent_mass

SMALL = 0.05  # of one throw's force, and of its couple over one pitch
POLYGON = Text("Finotti 2013, 2.3.1: polygon of the centrifugal forces, polygon of their moments")


@formula("F_c", "Finotti 2013, 2.2.3: centrifugal force of a mass on the crankpin")
def centrifugal(m: Kilogram, omega: RadPerSecond, r: Metre) -> Newton:
    """>>> centrifugal(m=0.74467, omega=272.2714, r=0.0535)
    2953.39...
    """
    return m * omega**2 * r


@formula("ΣF_c", POLYGON)
def together(F_c: Newton, phi: Radians) -> Newton:
    """`F_c` of every throw, or the one that all have."""
    return modulus(resultant(F_c * cis(phi)))


@formula("ΣM_c", POLYGON)
def couple_together(F_c: Newton, z: Metres, phi: Radians) -> NewtonMetre:
    return modulus(resultant(F_c * z * cis(phi)))


@formula(
    "M_rot,ne",
    "Finotti 2013, 2.5.3.1: rotating mass not balanced: what the crank carries beyond the rotating mass",
    unit="g",
)
def rotating_not_balanced(M_eq: Kilogram, M_rot: Kilogram) -> Kilogram:
    return M_eq - M_rot


@formula("M_alt,ne", "Finotti 2013, 2.5.3.1: reciprocating mass not balanced", unit="g")
def reciprocating_not_balanced(M_alt: Kilogram, M_rot: Kilogram, M_eq: Kilogram) -> Kilogram:
    return M_alt + M_rot - M_eq


@result
class Throws(Shown):
    """The throws with nothing balanced, and with what the crank carries of the reciprocating masses."""

    force: Newton = value("Centrifugal force of one throw's rotating mass", "N", "F_c")
    force_together: Newton = value("Centrifugal forces of all throws together", "N", "ΣF_c")
    couple_together: NewtonMetre = value("Centrifugal couple of all throws", "N·m", "ΣM_c")
    rotating_not_balanced: Kilogram = value(
        "Mass that a throw's counterweight has beyond the rotating one", "g", "M_rot,ne"
    )
    reciprocating_not_balanced: Kilogram = value(
        "Reciprocating mass that the crank leaves, per cylinder", "g", "M_alt,ne"
    )
    force_not_balanced: Newton = value("Centrifugal force of that mass, one throw", "N", "F_c")
    couple_not_balanced: NewtonMetre = value("Centrifugal couple of that mass, all throws", "N·m", "ΣM_c")


def throws(kappa: Number, engine: EngineInputs, e: EngineResult) -> Throws:
    """Forces and couples of the throws.  Numbers of the engine may be arrays, an engine each."""
    phi, z = e.crank.phi, e.crank.z
    r, omega, M_rot, M_alt = measures(engine, e)[0], e.angular_speed, e.rotating_mass, e.reciprocating_mass
    M_eq = equivalent_mass(M_rot=M_rot, kappa=kappa, M_alt=M_alt)
    beyond = rotating_not_balanced(M_eq=M_eq, M_rot=M_rot)
    force, more = centrifugal(m=M_rot, omega=omega, r=r), centrifugal(m=beyond, omega=omega, r=r)
    every, rest = column(force), column(more)
    if e.unlike is not None:  # `force` and `more` are then those of the means
        (M_a, M_r), r = masses(e), radius(engine, e)
        every = centrifugal(m=M_r, omega=omega, r=r)
        carried = equivalent_mass(M_rot=M_r, kappa=kappa, M_alt=M_a)
        rest = centrifugal(m=rotating_not_balanced(M_eq=carried, M_rot=M_r), omega=omega, r=r)
    return Throws(
        force=force,
        force_together=together(F_c=every, phi=phi),
        couple_together=couple_together(F_c=every, z=z, phi=phi),
        rotating_not_balanced=beyond,
        reciprocating_not_balanced=reciprocating_not_balanced(M_alt=M_alt, M_rot=M_rot, M_eq=M_eq),
        force_not_balanced=more,
        couple_not_balanced=couple_together(F_c=rest, z=z, phi=phi),
    )


def polygons(engine: EngineInputs, e: EngineResult, throws: Throws) -> tuple[Curve, ...]:
    """The vectors of the cylinders tip to tail: a closed polygon is balanced.  Inline also those of second order, at
    double angles.  A short report has none whose vectors all lie on one line, as those of a flat crank do."""
    crank = e.crank
    if engine.cylinders < 2 or not throws.force:
        return ()
    (M_alt, M_rot), r, c_2 = masses(e), radius(engine, e), harmonics(e, "exact")[1]
    angles = crank.theta_0 + crank.phi
    first = throws.force if e.unlike is None else M_rot * r * e.angular_speed**2
    kinds = [(Text("throws: rotating masses, and order 1"), first * np.exp(1j * angles))]
    if not np.ptp(crank.psi) and np.any(c_2):
        second = M_alt * r * e.angular_speed**2 * c_2
        kinds.append((Text("double angles: order 2"), second * np.exp(2j * angles)))
    forces = "polygon_forces", Text("Polygon of the cylinders' forces, cylinder 1 at TDC"), "N"
    couples = "polygon_couples", Text("Polygon of the cylinders' couples about mid-engine, cylinder 1 at TDC"), "N·m"
    flat = all(np.all(np.abs((v * v[0].conj()).imag) <= DUST * abs(v[0]) ** 2) for _, v in kinds)
    moments = [(name, vectors * crank.z) for name, vectors in kinds]
    drawn = _polygon(*forces, kinds, 0 if flat else 4), _polygon(*couples, moments, 0 if flat else 5)
    return tuple(curve for curve in drawn if curve.series)


def _polygon(id: str, title: Text, unit: str, kinds: list[tuple[Text, ComplexArray]], short: int) -> Curve:
    """Each cylinder's vector from the end of the one before; the resultant from the start to the end of the last.
    `short`: its place among the figures of a short report."""
    series = []
    for variant, vectors in kinds:
        tips = np.concatenate([[0j], np.cumsum(vectors)])
        size = float(np.max(np.abs(vectors)))
        for k, vector in enumerate(vectors):
            if abs(vector) > DUST * size > 0:
                ends = tips[k : k + 2]
                series.append(Series(Text("cylinder {n}", n=k + 1), ends.imag, ends.real, variant))
        if abs(tips[-1]) > DUST * size:
            ends = tips[[0, -1]]
            series.append(Series(Text("resultant"), ends.imag, ends.real, variant))
    variants = tuple(variant for variant, _ in kinds) if len(kinds) > 1 else ()
    return Curve(
        id,
        title,
        Text("horizontal, {unit}", unit=unit),
        Text("vertical, {unit}", unit=unit),
        tuple(series),
        equal=True,
        variants=variants,
        short=short,
    )


def balanced(throws: Throws, pitch: Metre) -> tuple[bool, bool]:
    """Whether the bare throws are balanced statically, and whether dynamically."""
    couple = throws.couple_together <= SMALL * throws.force * pitch
    return throws.force_together <= SMALL * throws.force, couple


def verdict(throws: Throws, pitch: Metre, rho: Number) -> Text:
    """Static and dynamic balance of the throws by themselves: whether the crank needs counterweights for its rotating
    masses.

    `pitch`: of the cylinders; `rho`: the share of these masses that the counterweights are taken to carry.
    """
    force, couple = Amount(throws.force_together), Amount(throws.couple_together)
    static, dynamic = balanced(throws, pitch)
    if static and dynamic:
        return Text(
            "The bare throws are balanced statically and dynamically: their rotating masses need no counterweights."
        )
    if static:
        text = Text(
            "The bare throws are balanced statically, not dynamically: counterweights must take a couple of "
            "{couple} N·m of the rotating masses, and are taken to do so.",
            couple=couple,
        )
    elif dynamic:
        text = Text(
            "The bare throws are not balanced statically: counterweights must take a force of {force} N of the "
            "rotating masses, and are taken to do so.",
            force=force,
        )
    else:
        text = Text(
            "The bare throws are balanced neither statically nor dynamically: counterweights must take a force of "
            "{force} N and a couple of {couple} N·m of the rotating masses, and are taken to do so.",
            force=force,
            couple=couple,
        )
    if abs(rho - 1) > 1e-9:
        text += Text(" To a share of {rho} only (rotating_balance_fraction).", rho=Amount(rho, form="g"))
    return text


def systems_table(
    throws: Throws,
    orders: Mapping[str, Order],
    one_force: Newton,
    one_couple: NewtonMetre,
    engine: EngineInputs,
    e: EngineResult,
) -> Table:
    """The six systems of forces and couples of this engine with nothing balanced: which are balanced by themselves, and
    why."""
    crank, lam = e.crank, measures(engine, e)[1]
    first, second = orders["order_1"].unbalanced, orders["order_2"].vectors
    closed, mirrored = throws.force_together <= SMALL * throws.force, _mirrored(crank)
    inline = not np.ptp(crank.psi)
    as_throws = Text("like those of the rotating masses") if inline else Text("by throws and banks together")
    rows = (
        (
            Text("centrifugal forces"),
            throws.force_together,
            throws.force,
            True,
            Text("the polygon of their vectors closes"),
            Text("the polygon of their vectors stays open"),
        ),
        (
            Text("couples of the centrifugal forces"),
            throws.couple_together,
            throws.force * crank.pitch,
            False,
            Text("the throws mirror each other about mid-engine")
            if mirrored
            else Text("the polygon of their couples closes"),
            Text("the throws have no plane of symmetry across the axis")
            if closed
            else Text("about mid-engine; a force is left as well"),
        ),
        (Text("forces of order 1"), abs(first[0]) + abs(first[1]), one_force, True, as_throws, as_throws),
        (Text("couples of order 1"), abs(first[2]) + abs(first[3]), one_couple, False, as_throws, as_throws),
        (
            Text("forces of order 2"),
            abs(second[0]) + abs(second[1]),
            lam * one_force,
            True,
            Text("the polygon of the doubled angles closes"),
            Text("the polygon of the doubled angles stays open"),
        ),
        (
            Text("couples of order 2"),
            abs(second[2]) + abs(second[3]),
            lam * one_couple,
            False,
            Text("the polygon of couples at the doubled angles closes"),
            Text("the polygon of couples at the doubled angles stays open"),
        ),
    )
    return Table(
        "systems",
        Text("The six systems with nothing balanced"),
        (
            (Text("system"), ""),
            (Text("force"), "N"),
            (Text("couple"), "N·m"),
            (Text("state"), ""),
            (Text("because"), ""),
        ),
        tuple(
            (
                name,
                amount if is_force else None,
                None if is_force else amount,
                Text("balanced by themselves") if amount <= SMALL * reference else Text("not balanced"),
                why if amount <= SMALL * reference else why_not,
            )
            for name, amount, reference, is_force, why, why_not in rows
        ),
        Text("Peaks over the turn; balanced: within 5 % of one cylinder's, the couple over one pitch."),
    )


def _mirrored(crank: Crank) -> bool:
    """Whether every throw has one at the same angle on the other side of mid-engine."""
    vectors = np.exp(1j * crank.phi)
    return all(np.any((np.abs(crank.z + z) < 1e-9) & (np.abs(vectors - v) < 1e-9)) for z, v in zip(crank.z, vectors))
