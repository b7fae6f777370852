# SPDX-License-Identifier: Apache-2.0
"""How the shaft bends under its own centrifugal load: slopes of the journals, natural frequency, moments, stresses.

In order: the stresses, the load as few forces for a sketch, the bending.

The shaft stands still in the frame that turns with it, where its load is constant; weight and gear force are left out.
The finite-element results of Finotti 2013, ch. 6, are not reproduced: the true shape is not given there.  The share η
of the sectors' stiffness makes the bracket.  Sections at other angles than the load's are taken as if they bent in
their plane of symmetry. Ribs along the core have no section of their own: what they lend depends on how they join core
and sectors, as with η, in whose bracket they stay (they only stiffen); the share at which a slope reaches its limit
says whether they are needed."""

import math
from collections import Counter
from itertools import pairwise
from typing import TypedDict

import numpy as np

from ...library import fatigue
from ...library.catalogue import Material
from ...library.journal_rules import SLOPE
from ...sheet.arrays import Array, BoolArray, ComplexArray, Num
from ...sheet.errors import NoSolution
from ...sheet.linked_array import column, gathered, item, where
from ...sheet.quantity import result, value
from ...sheet.record import record, replace
from ...sheet.shown import Shown
from ...sheet.text import COMMA, Amount, Text
from ...sheet.units import (
    Metre,
    Newton,
    NewtonMetre,
    Number,
    Pascal,
    Radian,
    RadPerSecond,
    RevPerSecond,
)
from ...sheet.value import about, based_on, link_of, untraced
from .. import outline as s
from ..formulas import mass_force
from ..inputs import EccentricMass
from ..outline import Outline
from . import formulas as f
from .beam import Beam, Bent, beam, bend, displaced, sprung

# --- the stresses of the bent shaft: nominal in each piece, and at the fillet of the shoulder that governs
# The bending moment turns with the shaft, so that these stresses stand still in it.

STEP = 1e-6  # m: radii that differ by less make no shoulder


def stresses(
    shaft: "_Shaft", bent: Bent, M_max: NewtonMetre, fillet: Metre | None
) -> tuple[dict[str, float], tuple[Text, ...]]:
    """Nominal stresses of the pieces, and the shoulder whose fillet is stressed most; notes on it."""
    outline = shaft.outline
    c: Array = column(outline.pieces, "outer_radius")
    sector = np.array([p.half_angle is not None for p in outline.pieces])
    if sector.any():
        R, r_0 = (column(outline.pieces, name)[sector] for name in ("outer_radius", "core_radius"))
        gamma = gathered(p.half_angle for p in outline.pieces if p.half_angle is not None)
        S = based_on(np.abs(outline.moment[sector]), outline.moment[sector])
        A = outline.area[sector]
        c = where(sector, f.farthest_fibre(R=R, y=s.whole_centre(S=S, A_tot=A), r_0=r_0, gamma=gamma), c[~sector])
    start, end = column(outline.pieces, "start"), column(outline.pieces, "end")
    I = outline.inertia
    with untraced():
        k = int(f.bending_stress(M=f.piece_moments(z_1=start, z_2=end, u=bent, M_s=0.0), c=c, I=I).argmax())
    size = np.abs(bent.moment)
    indices = np.flatnonzero((bent.moment_z >= start[k] - STEP) & (bent.moment_z <= end[k] + STEP))
    z_k = based_on(float(bent.moment_z[indices[size[indices].argmax()]]), bent)
    M = f.piece_moments(z_1=start, z_2=end, u=bent, M_s=_by_statics(shaft, bent, z_k))
    stress = f.bending_stress(M=M, c=c, I=I)
    z_M = f.moment_place(u=bent)
    here = [i for i in range(start.size) if start[i] - STEP <= z_M <= end[i] + STEP]
    i = max(here, key=lambda i: float(c[i] / I[i]))
    known = dict(
        largest_moment_z=z_M,
        stress_at_largest_moment=f.bending_stress(M=M_max, c=item(c[i]), I=item(I[i])),
        bending_stress=item(stress[k]),
        bending_stress_z=z_k,
    )
    notch_of, notes = ({}, ()) if fillet is None else _notch(shaft, bent, c, fillet)
    return known | notch_of, notes


def _by_statics(shaft: "_Shaft", bent: Bent, z_s: Metre) -> NewtonMetre:
    """The moment at a section from the forces on that side of it where there are fewer: the beam's, proven by hand."""
    z, q = np.asarray(shaft.given["z"]), np.asarray(shaft.given["q"])
    sides = []
    for side, a, b in ((1.0, np.maximum(z[:-1], z_s), z[1:]), (-1.0, z[:-1], np.minimum(z[1:], z_s))):
        P = np.concatenate([q * np.maximum(b - a, 0.0), shaft.given["F"], bent.reactions])
        places = np.concatenate([(a + b) / 2, shaft.places, shaft.given["z_B"]])
        there = (side * (places - z_s) > 0) & (P != 0)
        sides.append((P[there], places[there]))
    P, places = min(sides, key=lambda one: one[0].size)
    moment: float = f.moment_by_statics(F=based_on(P, bent), z=based_on(places, *shaft.given["z_B"]), z_s=z_s)
    return moment


def _notch(shaft: "_Shaft", bent: Bent, c: Array, r: Metre) -> tuple[dict[str, float], tuple[Text, ...]]:
    """The shoulder with the largest stress at its fillet: the round one from the larger diameter down to that of the
    weaker section.

    A sector counts there with its core, at whose back its shoulder to a full section lies; of two sectors on one core,
    with its edge. Shoulders lower than a tenth of the fillet, where the fit ends, are left out and said."""
    outline, shoulders = shaft.outline, []
    low = 0
    for i, k in pairwise(range(len(outline.pieces))):
        weak = min(i, k, key=lambda n: float(outline.inertia[n]))
        piece, other = outline.pieces[weak], outline.pieces[i + k - weak]
        at_core = piece.half_angle is not None and 0 < piece.core_radius != (
            other.core_radius if other.half_angle is not None else 0.0
        )
        radius = piece.core_radius if at_core else piece.outer_radius
        d = based_on(2 * radius, radius)
        D = based_on(2 * max(piece.outer_radius, other.outer_radius), piece.outer_radius, other.outer_radius)
        weaker, stronger = ((p.half_angle, p.core_radius, p.outer_radius) for p in (piece, other))
        if D - d < 2 * STEP or weaker == stronger:
            continue
        if (D - d) / (2 * r) < fatigue.FIT[0]:
            low += 1
            continue
        shoulders.append((piece.start if weak == k else piece.end, weak, D, d))
    notes: tuple[Text, ...] = (
        (Text("Notch stress: the shoulder of a sector is taken as a round one."),) if shoulders else ()
    )
    if low:
        notes += (
            Text(
                "Notch stress: {low} of the shoulders lower than a tenth of the fillet radius left out: the fit ends "
                "there.",
                low=low,
            ),
        )
    if not shoulders:
        return {}, notes

    carried = Counter(weak for _, weak, *_ in shoulders)
    room = min(outline.pieces[weak].length / times for weak, times in carried.items())

    def stressed(shoulder: tuple[Metre, int, Metre, Metre]) -> dict[str, float]:
        z, weak, D, d = shoulder
        M = f.shoulder_moment(z=z, u=bent, M_s=_by_statics(shaft, bent, z))
        sigma = f.bending_stress(M=M, c=item(c[weak]), I=item(outline.inertia[weak]))
        x, K_t = fatigue.shoulder_bending(D=D, d=d, r=r)
        return dict(
            notch_z=z, notch_factor=K_t, notch_stress=fatigue.notch_stress(K_t=K_t, sigma=sigma), step_over_fillet=x
        )

    with untraced():
        governs = max(shoulders, key=lambda shoulder: stressed(shoulder)["notch_stress"])
    with about(Text("shoulder at {governs} mm", governs=Amount(governs[0] * 1000.0))):
        z, weak, D, d = governs
        governs = based_on(z, z, bent), weak, based_on(D, D, bent), based_on(d, d, bent)
        return {**stressed(governs), "fillet": r, "fillet_room": room}, notes


# --- the centrifugal load of a shaft as the few forces that a sketch of it shows

LEAST = 5e-3  # of the largest: a smaller force is not shown


def resultants(
    ends: Array, q: ComplexArray, forces: tuple[Array, ComplexArray], back: complex
) -> tuple[tuple[Metre, Newton], ...]:
    """Place and size of the loads along a plane: of neighbouring pieces that are loaded to the same side one together,
    at its middle.

    `q` per length of the pieces between `ends`; `forces`: places and amounts; `back` turns the plane into the real
    axis."""
    ends = np.asarray(ends, float)
    middles, each = (ends[1:] + ends[:-1]) / 2, (np.asarray(q) * back).real * np.diff(ends)
    largest = float(np.abs(each).max(initial=0.0))
    groups: list[list[tuple[float, float]]] = []
    side = 0
    for z, F in zip(middles.tolist(), each.tolist()):
        now = 0 if abs(F) < LEAST * largest else 1 if F > 0 else -1
        if now and now != side:
            groups.append([])
        if now:
            groups[-1].append((z, F))
        side = now
    groups += [
        [(z, F)] for z, F in zip(np.ravel(forces[0]).tolist(), np.ravel((np.asarray(forces[1]) * back).real).tolist())
    ]
    sums = [(sum(z * F for z, F in group), sum(F for _, F in group)) for group in groups]
    loads = [(moment / F, F) for moment, F in sums if F]
    largest = max((abs(F) for _, F in loads), default=0.0)
    return tuple((z, F) for z, F in loads if abs(F) >= LEAST * largest)


# --- the bending

LEAST_SHARE = 0.05  # the share of stiffness below which none is looked for
FINE = 15e-3  # m: elements; the frequency of a stout shaft is then right to 2·10⁻⁵
LONG = 40e-3  # m: elements where only slopes are wanted
SAME = 1e-6  # m: so far a bearing may lie beyond the shaft's end


@result
class Bending(Shown):
    """The shaft's bending, with the sectors' stiffness at its share η where nothing else is said; `_stiff`: with all of
    it.

    `deflection`, `moment`, `shear` and `loads` stand along the plane of the load, that at the angle `plane`;
    `vectors` are the deflections in both planes.
    """

    largest_moment: NewtonMetre = value("Largest bending moment", "N·m", "M_max", short=True)
    largest_moment_z: Metre = value("its place from mid-shaft", "mm", "z_M", short=True)
    stress_at_largest_moment: Pascal = value("Bending stress there, nominal", "MPa", "σ_M")
    bending_stress: Pascal = value("Largest bending stress, nominal", "MPa", "σ", short=True)
    bending_stress_z: Metre = value("its place from mid-shaft", "mm", "z_σ", short=True)
    notch_factor: Number | None = value(
        "Notch factor of the shoulder that governs", "", "K_t", default=None, short=True
    )
    notch_stress: Pascal | None = value("Bending stress at its fillet", "MPa", "σ_k", default=None, short=True)
    notch_z: Metre | None = value("its place from mid-shaft", "mm", "z_k", default=None, short=True)
    fatigue_amplitude: Pascal | None = value(
        "Alternating stress there that equals a run-up", "MPa", "σ_eq", default=None, short=True
    )
    fatigue_strength: Pascal | None = value(
        "Alternating stress that the fillet bears", "MPa", "σ_A", default=None, short=True
    )
    fatigue_safety: Number | None = value("Safety of that fillet against fatigue", "", "j", default=None, short=True)
    effectiveness_at_limit: Number | None = value(
        "Stiffness share at which a slope reaches its limit", "", "η_lim", default=None
    )
    slopes: Array  # of the journals, front to rear
    slopes_stiff: Array
    natural_frequency: RevPerSecond
    natural_frequency_stiff: RevPerSecond
    natural_frequency_without_rotary: RevPerSecond
    speed: RevPerSecond
    reactions: ComplexArray
    plane: Radian
    z: Array
    deflection: Array
    deflection_stiff: Array
    vectors: ComplexArray
    moment_z: Array
    moment: Array
    shear_z: Array
    shear: Array
    loads: tuple[tuple[Metre, Newton], ...]  # place and size of the resultants
    vibrating: "_Vibrating"  # of the first natural frequency
    model: Beam  # that bends
    material: Material
    points: tuple[EccentricMass, ...]  # what the outline does not hold
    effectiveness: Number
    step_over_fillet: Number | None = None  # of the shoulder that governs
    fillet: Metre | None = None
    fillet_room: Metre | None = None  # length of the shortest piece that carries fillets, for each of them
    notes: tuple[Text, ...] = ()


class _Given(TypedDict):
    """What the solution is found from, beside E·I."""

    S_s: Array
    mu: Array
    q: ComplexArray
    F: ComplexArray
    m: Array
    omega: RadPerSecond
    z: Array
    z_B: tuple[Metre, ...]


@record
class _Shaft:
    """What the variants of stiffness have in common."""

    outline: Outline
    sector: BoolArray
    places: Array  # of the further elements
    given: _Given

    def model(self, EI: Array, longest: Metre = FINE, rotary: Num = 0.0) -> Beam:
        x, places = self.given, self.places
        forces, masses = (places, x["F"]), (places, x["m"])
        return beam(x["z"], EI, x["S_s"], x["mu"], x["q"], x["z_B"], forces, masses, rotary, longest)


@record
class _Vibrating:
    """A shaft with the bending stiffness of its weaker plane, and the rotary inertia of its sections."""

    shaft: _Shaft
    EI: Array
    j: Array


def on_springs(bent: Bending, K_B: Array) -> RevPerSecond:
    """The first natural frequency with the bearings on springs in place of pins."""
    shaft, EI, j = bent.vibrating.shaft, bent.vibrating.EI, bent.vibrating.j
    x, model = shaft.given, sprung(shaft.model(EI, rotary=j), K_B)
    return f.natural_frequency_on_springs(
        EI=EI, S_s=x["S_s"], mu=x["mu"], j=j, m=x["m"], z=x["z"], z_B=x["z_B"], K_B=K_B, model=model
    )


def bending(
    outline: Outline,
    material: Material,
    omega: RadPerSecond,
    positions: tuple[Metre, ...],
    extras: tuple[EccentricMass, ...] = (),
    effectiveness: Number = 1.0,
    fillet_radius: Metre | None = None,
) -> Bending:
    """The bending of a shaft that turns at `omega` on journals whose middles lie at `positions`.

    Raises NoSolution where a journal or a further element lies beyond the shaft's ends.
    """
    within_shaft(outline, positions, extras)
    with about(Text("bending of the shaft")):
        shaft = prepared(outline, material, omega, positions, extras)
        I = outline.inertia
        EI = f.bending_stiffness(E=material.E, I=I)
        core = f.core_inertia(I=I, r_0=column(outline.pieces, "core_radius"), sector=shaft.sector)
        if outline.bore:
            core = np.where(shaft.sector, s.bored_inertia(I=core, r_b=outline.bore), core)
        EI_s = shared_stiffness(material, core, effectiveness, I)
    given = shaft.given
    with about(Text("bending of the shaft, full stiffness")):
        stiff = shaft.model(EI)
        bent_stiff = replace(bend(stiff, omega), link=link_of((EI, given)))
        slopes_stiff = f.slopes(EI=EI, **given, u=bent_stiff)
    with about(Text("bending of the shaft")):
        model = stiff if effectiveness == 1 else shaft.model(EI_s)
        bent = bent_stiff if effectiveness == 1 else replace(bend(model, omega), link=link_of((EI_s, given)))
        slopes = f.slopes(EI=EI_s, **given, u=bent)
        M_max = f.largest_moment(EI=EI_s, **given, u=bent)
        vibrating, frequencies = _frequencies(shaft, material, core, effectiveness, (EI_s, EI))
        stressed, notes = stresses(shaft, bent, M_max, fillet_radius)
        if fillet_radius is not None:  # a shaft without a shoulder is judged by its sections
            stressed |= run_up_fatigue(stressed.get("notch_stress") or stressed["bending_stress"], material)
        at_limit = _share_at_limit(
            shaft, material.E, core, (effectiveness, float(slopes.max())), (1.0, float(slopes_stiff.max()))
        )
    plane = _plane(shaft)
    back = np.exp(-1j * plane)
    return Bending(
        largest_moment=M_max,
        **stressed,
        notes=notes,
        effectiveness_at_limit=at_limit,
        slopes=slopes,
        slopes_stiff=slopes_stiff,
        natural_frequency=frequencies[0],
        natural_frequency_stiff=frequencies[1],
        natural_frequency_without_rotary=frequencies[2],
        speed=based_on(abs(omega) / (2 * math.pi), omega),
        reactions=f.reactions(EI=EI_s, **given, u=bent),
        plane=plane,
        z=bent.z,
        deflection=(bent.w * back).real,
        deflection_stiff=(bent_stiff.w * back).real,
        vectors=bent.w,
        moment_z=bent.moment_z,
        moment=(bent.moment * back).real,
        shear_z=bent.shear_z,
        shear=(bent.shear * back).real,
        vibrating=vibrating,
        model=model,
        material=material,
        points=extras,
        effectiveness=effectiveness,
        loads=resultants(given["z"], given["q"], (shaft.places, given["F"]), back),
    )


def run_up_fatigue(stress: Pascal, material: Material) -> dict[str, float]:
    """The largest stress, from standstill to full speed and back; it stands still in the turning shaft."""
    bears = fatigue.strength(material)
    if bears is None or not stress:
        return {}
    half = fatigue.run_up_amplitude(sigma_k=stress)
    equal = fatigue.equivalent_amplitude(sigma_a=half, sigma_m=half, M=bears.sensitivity)
    return {
        "fatigue_amplitude": equal,
        "fatigue_strength": bears.bearable,
        "fatigue_safety": fatigue.safety(sigma_A=bears.bearable, sigma_eq=equal),
    }


def within_shaft(outline: Outline, positions: tuple[Metre, ...], extras: tuple[EccentricMass, ...]) -> None:
    """Raises NoSolution where a journal or a further element lies beyond the shaft's ends."""
    elements = [(z, Text("{z} mm (a bearing)", z=Amount(z * 1000.0, form="g"))) for z in positions]
    elements += [(x.z, Text("{z} mm ({name})", z=Amount(x.z * 1000.0, form="g"), name=x.name)) for x in extras]
    outside = [text for z, text in elements if not outline.start - SAME <= z <= outline.end + SAME]
    if outside:
        raise NoSolution(
            Text("bending of the shaft"),
            Text(
                "{outside}: beyond the shaft, from {start} to {end} mm",
                outside=COMMA.join(outside),
                start=Amount(outline.start * 1000.0, form=".4g"),
                end=Amount(outline.end * 1000.0, form=".4g"),
            ),
            Text("Let [[shafts.sections]] reach that far."),
        )


def prepared(
    outline: Outline,
    material: Material,
    omega: RadPerSecond,
    positions: tuple[Metre, ...],
    extras: tuple[EccentricMass, ...],
) -> _Shaft:
    """Mass, shear stiffness and load of each piece at `omega`; the bending stiffness is the variants' own."""
    G = f.shear_modulus(E=material.E, nu=material.poisson)
    kappa = f.shear_coefficient(nu=material.poisson)
    masses, e, gamma, z = (column(extras, name) for name in ("mass", "radius", "angle", "z"))
    forces = mass_force(omega=omega, m=masses, e=e, gamma=gamma) if extras else np.zeros(0, dtype=complex)
    given = _Given(
        S_s=f.shear_stiffness(kappa=kappa, G=G, A=outline.area),
        mu=f.line_mass(rho=material.density, A=outline.weighing_area),
        q=f.line_load(omega=omega, rho=material.density, S=outline.weighing_moment),
        F=forces,
        m=masses,
        omega=omega,
        z=gathered([*column(outline.pieces, "start"), outline.end]),
        z_B=positions,
    )
    sector = np.array([p.half_angle is not None for p in outline.pieces])
    return _Shaft(outline=outline, sector=sector, places=z, given=given)


def sideways(outline: Outline) -> Array:
    """The second moments of area of the sections that bend across their plane of symmetry."""
    # π: the full cylinder
    gamma = gathered(math.pi if p.half_angle is None else p.half_angle for p in outline.pieces)
    R, r_0 = column(outline.pieces, "outer_radius"), column(outline.pieces, "core_radius")
    side = f.sideways_inertia(R=R, r_0=r_0, gamma=gamma)
    return s.bored_inertia(I=side, r_b=outline.bore) if outline.bore else side


def shared_stiffness(material: Material, core: Array, eta: Number, inertia: Array) -> Array:
    """The bending stiffness with a share of what the sectors add to the core."""
    return f.bending_stiffness(E=material.E, I=f.shared_inertia(I_0=core, eta=eta, I=inertia))


def _frequencies(
    shaft: _Shaft, material: Material, core: Array, eta: Number, stiffnesses: tuple[Array, Array]
) -> tuple[_Vibrating, tuple[RevPerSecond, RevPerSecond, RevPerSecond]]:
    """The shaft as it vibrates; its lowest natural frequency with the shared and with the whole stiffness, and the
    first without rotary inertia.

    Each in the weaker plane of the sections.
    """
    outline = shaft.outline
    inertia = outline.inertia
    if shaft.sector.any():
        side = sideways(outline)
        weaker = f.weaker_inertia(I=inertia, I_side=side)
        if np.any(weaker < inertia * (1 - 1e-9)):
            stiffnesses = shared_stiffness(material, core, eta, weaker), f.bending_stiffness(E=material.E, I=weaker)
            inertia = weaker
    if outline.heavier == 1:
        j = f.rotary_inertia(rho=material.density, I=inertia)
    else:
        j = f.heavier_rotary_inertia(rho=material.density, I=inertia, I_0=core, nu=outline.heavier)
    shared, whole = stiffnesses
    x = shaft.given
    S_s, mu, m, z, z_B = x["S_s"], x["mu"], x["m"], x["z"], x["z_B"]

    def frequency(EI: Array) -> RevPerSecond:
        return f.natural_frequency(EI=EI, S_s=S_s, mu=mu, j=j, m=m, z=z, z_B=z_B, model=shaft.model(EI, rotary=j))

    first = frequency(shared)
    stiff = first if eta == 1 else frequency(whole)
    bare = f.natural_frequency_without_rotary(EI=shared, S_s=S_s, mu=mu, m=m, z=z, z_B=z_B, model=shaft.model(shared))
    return _Vibrating(shaft, shared, j), (first, stiff, bare)


def _share_at_limit(
    shaft: _Shaft,
    E: Pascal,
    core: Array,
    design: tuple[Number, Radian],
    whole: tuple[Number, Radian],
    limit: Radian = SLOPE,
) -> Number | None:
    """The share η at which the largest slope of a journal reaches its limit; None where it does not between 0.05 and 1.

    `design`, `whole`: two shares and the largest slopes found with them.  1/θ is nearly a straight line of η, so that a
    secant takes a few steps; statics are exact with any elements, and long ones serve."""
    added = np.asarray(shaft.outline.inertia) - core

    def stiffer(eta: float) -> float:
        model = shaft.model(E * (core + eta * added), LONG)
        slopes = np.abs(displaced(model, shaft.given["omega"])[model.pinned + 1])
        return 1 / float(slopes.max()) - 1 / limit if slopes.any() else math.inf

    if not shaft.sector.any() or whole[1] > limit or (least := stiffer(LEAST_SHARE)) >= 0:
        return None
    a, f_a = LEAST_SHARE, least
    b, f_b = design[0], 1 / design[1] - 1 / limit
    for _ in range(20):
        if b == a or f_b == f_a:
            break
        a, f_a, b = b, f_b, min(max(b - f_b * (b - a) / (f_b - f_a), LEAST_SHARE), 1.0)
        if abs(b - a) < 1e-5:  # the step after it is far smaller
            return f.limiting_share(theta_lim=limit, E=E, I_0=core, I=shaft.outline.inertia, **shaft.given, eta=b)
        f_b = stiffer(b)
    return None


def _plane(shaft: _Shaft) -> Radian:
    """The direction of the load's couple about the middle of the journals, or of its force where there is no couple."""
    given = shaft.given
    ends, q, F, span_middle = given["z"], given["q"], given["F"], (given["z_B"][0] + given["z_B"][-1]) / 2
    l, arm = np.diff(ends), shaft.places - span_middle
    middle = (ends[1:] + ends[:-1]) / 2 - span_middle
    couple = complex(np.sum(q * l * middle) + np.sum(F * arm))
    force = complex(np.sum(q * l) + np.sum(F))
    size = float(np.sum(np.abs(q) * l * np.abs(middle)) + np.sum(np.abs(F * arm)))
    vector = couple if abs(couple) > 1e-6 * size else force
    return math.atan2(vector.imag, vector.real)
