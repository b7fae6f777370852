# SPDX-License-Identifier: Apache-2.0
"""A counter-shaft, given or sized: its force and couple, its supports, bending and making.

At the end whether the oil of its bearings drains off."""

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from ..imbalance.curves import DRAWN
from ..imbalance.remedies import roll_torque
from ..imbalance.result import ImbalanceResult
from ..library.catalogue import WEAKEST_TENSILE, Material
from ..library.journal_rules import heat_index, specific_load
from ..sheet.deferred import Later
from ..sheet.errors import NoSolution
from ..sheet.formula import formula
from ..sheet.functions import pi, power, sin, smallest, total
from ..sheet.linked_array import column, elements, gathered, item
from ..sheet.quantity import Described, Stated
from ..sheet.record import replace
from ..sheet.step import Outcome
from ..sheet.text import Amount, Name, Text
from ..sheet.units import (
    CubicMetrePerSecond,
    Metre,
    MetrePerSecond,
    MetrePerSecond2,
    Number,
    Pascal,
    Radian,
    RadPerSecond,
    SquareMetrePerSecond,
)
from ..sheet.value import about, based_on, trace
from . import formulas as f
from . import outline as s
from .bending.formulas import in_series
from .bending.shaft import bending, on_springs, run_up_fatigue
from .checks import FILLET_ROOM, bending_checks, checks, fem_checks
from .curves import curves
from .inputs import EccentricMass, ShaftInputs
from .insertion import rooms
from .making.drain import DrainResult, run_off_check
from .making.parts import ShaftStep, making
from .mass_properties import mass_properties, without_extras
from .notes import SLOPES_GIVEN, bending_notes, notes, outline_note, size_notes, supports_note, tight_fillet_note
from .outline import Journals, NoOutline, Outline, outer_face
from .result import CountershaftResult, SupportResult
from .sizing.choices import front_curve, named
from .sizing.sectors import TooSmall, eccentric_masses, pieces, task
from .sizing.shares import asked_share, need_mirror_images, share_of
from .sizing.stretches import NOT_THE_LIGHTEST, SizedStretches, inner_gaps, size_between
from .sums import SystemShaft
from .supports import Gear, gear_place, phases_of, reactions

if TYPE_CHECKING:
    from ..bearings.result import BearingsResult
    from .sizing.sectors import Sized


def solve(
    shaft: ShaftInputs,
    imbalance: ImbalanceResult,
    omega: RadPerSecond,
    materials: Mapping[str, Material],
    gear: Gear | None,
    fastest: Number = 1.0,
    beside: tuple[SystemShaft, ...] = (),
    *,
    judged: bool,
    alike: int = 1,
    shared: bool = False,
) -> Outcome[CountershaftResult]:
    """A shaft by itself; sized first, where that is asked, for what the engine asks for and shafts `beside` it leave.

    `omega` is the crank's rated angular speed; `fastest`: the highest speed of the crank over the rated one; `judged`:
    the films of its bearings are judged by the step that follows, else their loads are screened here; `alike`: how
    many shafts of its ratio are sized, of which each has its share; `shared`: others turn like it, so that it is made
    for no more than it gives as designed.
    """
    todo, journals = task(shaft.speed_ratio, imbalance, beside), shaft.journals
    slopes = {row.name: row.slope for row in shaft.bearings if row.slope is not None}
    with trace() as lines:
        step = ShaftStep(shaft, todo, materials, journals, f.shaft_speed(i=shaft.speed_ratio, omega=omega))
        masses, sized = shaft.masses, _sized(step, alike)
        if sized is not None:
            masses = eccentric_masses(sized)
        R = shaft.outer_radius
        if R is None and journals and shaft.seat is not None:  # what may be threaded through it
            R = f.widest(d=shaft.seat, c_R=shaft.radial_clearance or 0.0)
        result = _balance(step, masses)
        if shared:
            C_S, F_S = result.couple_vector, result.force_vector
            step.todo = replace(todo, C=based_on(-C_S, C_S), F=based_on(-F_S, F_S))
        if sized is not None:
            result = replace(
                result,
                sector_half_angle=max(one.half_angle for one in sized.by_name.values()),
                sector_length=max(one.length for one in sized.by_name.values()),
                utilisation=sized.utilisation,
                sector_mass=max(one.mass for one in sized.by_name.values()),
                sector=sized.by_name,
            )
        outline = _outline(step, masses, sized, R, gear)
        with about(Text("standing part of the load")):
            result = replace(result, wheel=gear_place(shaft, outline))
        if outline is not None:
            certain = sized is not None or not outline.derived
            result = _with_outline(step, masses, result, outline, certain, fastest)
        elif slopes:
            result = replace(result, slopes=slopes)
            step.notes.append(SLOPES_GIVEN)
        result = making(step, masses, _with_supports(step, masses, result, judged), R)
        if shaft.fem_principal_stress:
            result = replace(result, fem_safety=fem_safety(shaft.fem_principal_stress, step.material))
        step.checks += fem_checks(shaft, step.material, result.fem_safety)
        front, rear = rooms(shaft, outline, journals, shaft.outer_radius) if journals else (None, None)
        result = replace(result, insertion_room_front=front, insertion_room_rear=rear)
    further = step.notes
    return Outcome(
        "countershaft",
        result=result,
        checks=(*checks(shaft, todo, result, journals, gear), *step.checks),
        lines=tuple(lines),
        curves=Later(partial(curves, result, omega, shaft.bearing_positions)) + step.curves,
        tables=step.tables,
        notes=Later(lambda: (*notes(shaft, journals, result.force > DRAWN * todo.one_force), *further)),
    )


def _sized(step: ShaftStep, alike: int) -> "Sized | SizedStretches | None":
    """The lightest sectors in the envelope, where that is asked.  Raises NoSolution where the envelope can not hold
    them."""
    shaft, todo, omega = step.shaft, step.todo, step.omega
    if shaft.mode != "size" or shaft.outer_radius is None or shaft.core_radius is None or shaft.half_length is None:
        return None
    left = todo.F, todo.C
    if shaft.paired:
        need_mirror_images(left, (todo.F_against, todo.C_against), shaft.half_length)
    U, P = asked_share(left, omega, shaft.overdesign, share_of(shaft, alike))
    gaps = inner_gaps(shaft)
    densities = {name: step.materials[name].density for name in named(shaft, step.materials)}
    envelope = shaft.outer_radius, shaft.core_radius, shaft.half_length
    step.curves += Later(lambda: filter(None, [front_curve(U, P, omega, *envelope, densities, shaft.extras, gaps)]))
    try:
        sized = size_between(
            U, P, omega, step.sector_density, *envelope, gaps, shaft.extras, shaft.fillet_radius or 0.0
        )
    except TooSmall as small:
        raise NoSolution(small.what, small.tried, small.advice + _room(shaft, step.journals)) from small
    step.notes += size_notes(shaft)
    if isinstance(sized, SizedStretches) and not sized.lightest:
        step.notes.append(NOT_THE_LIGHTEST)
    return sized


def fem_safety(stress: Pascal, material: Material) -> Number | None:
    """Against fatigue, of a principal stress that finite elements found; a steel of unknown strength is taken as the
    weakest."""
    if material.kind == "steel" and material.tensile_strength is None:
        material = replace(material, tensile_strength=WEAKEST_TENSILE)
    with about(Text("finite elements")):
        return run_up_fatigue(stress, material).get("fatigue_safety")


def _room(shaft: ShaftInputs, journals: Journals) -> str:
    """What the journals leave for the envelope, in words."""
    if not journals:
        return ""
    face = Amount(outer_face(shaft.bearing_positions, journals)[0] * 1000.0, form=".4g")
    if shaft.seat is None:
        return Text(" (the journals as they are leave a half-length of {face} mm)", face=face)
    return Text(
        " (the journals as they are leave an outer radius of {seat} mm and a half-length of {face} mm)",
        seat=Amount((shaft.seat / 2 - (shaft.radial_clearance or 0.0)) * 1000.0, form=".4g"),
        face=face,
    )


def _outline(
    step: ShaftStep,
    masses: tuple[EccentricMass, ...],
    sized: "Sized | SizedStretches | None",
    R: Metre | None,
    gear: Gear | None,
) -> Outline | None:
    """The shaft's outline, given or put together; None where it can not be, and a note says why."""
    shaft, journals = step.shaft, step.journals
    try:
        if shaft.sections and sized is None:
            outline = s.given(shaft, step.heavier)
            s.hollowed(outline, step.material.density, shaft.extras)
            return outline
        outer, core = s.known(shaft, R, journals)
        sectors = s.sectors_of(masses, step.sector_density, outer, core) if sized is None else pieces(sized)
        on_shaft = (gear.diameter, gear.face_width) if gear else None
        outline = s.assembled(shaft, sectors, journals, on_shaft, step.heavier)
        s.hollowed(outline, step.material.density, shaft.extras)
    except NoOutline as none:
        if none.broken is not None:
            step.checks.append(none.broken)
        step.notes.append(
            Text("Mass, balance tolerance, bending and critical speed are not computed: {none}.", none=none.reason)
        )
        return None
    step.notes.append(outline_note(sized is not None, gear is not None))
    return outline


def _with_outline(
    step: ShaftStep,
    masses: tuple[EccentricMass, ...],
    result: CountershaftResult,
    outline: Outline,
    certain: bool,
    fastest: Number,
) -> CountershaftResult:
    """The same result with the mass of the shaft, the slopes of its outer journals and its first critical speed; and
    with how far given sections are from the given masses, since both must be one shaft.

    `certain`: the outline is the designer's or this program's own; else the gaps between its pieces are no more than
    assumed."""
    shaft, steel, omega = step.shaft, step.material, step.omega
    points = (*shaft.extras, *(masses if outline.plain else ()))  # what the outline itself does not hold
    m_S, z_S = s.weighed(outline, steel.density, points)
    z_S = based_on(z_S, z_S, outline.bore)
    J_S = s.turning_inertia(outline, steel.density, points)
    with about(Text("outline of the shaft")):
        known = None if shaft.extras else (m_S, z_S, J_S)
        solid = mass_properties(outline, steel.density, masses if outline.plain else (), known)
    if shaft.extras:
        step.notes.append(without_extras(shaft.extras))
    result = replace(
        result,
        outline=outline,
        mass=m_S,
        centre_of_gravity=z_S,
        moment_of_inertia=J_S,
        centre_of_gravity_up=solid.up,
        centre_of_gravity_side=solid.side,
        inertia=solid.inertia,
    )
    if not outline.derived:
        with about(Text("given sections")):
            F_x, C_x = _of(points, omega) if points else (0j, 0j)
            F_O, C_O = s.vectors_of(outline, steel.density, omega, F_x, C_x)
            result = replace(
                result,
                outline_force_deviation=f.force_deviation(F_O=F_O, F_S=result.force_vector),
                outline_couple_deviation=f.couple_deviation(C_O=C_O, C_S=result.couple_vector),
            )
    positions, names = shaft.bearing_positions, [row.name for row in shaft.bearings]
    bent = bending(outline, steel, omega, positions, points, shaft.sector_effectiveness, shaft.fillet_radius)
    step.checks += [c for c in bending_checks(bent, steel, fastest) if certain or c.rule is not FILLET_ROOM]
    step.notes += bending_notes(bent, steel)
    if not certain and (tight := tight_fillet_note(bent)) is not None:
        step.notes.append(tight)
    return replace(
        result,
        bending=bent,
        slopes=dict(zip(names, elements(bent.slopes))),
        slopes_stiff=dict(zip(names, elements(bent.slopes_stiff))),
        first_critical_speed=bent.natural_frequency,
        first_critical_speed_stiff=bent.natural_frequency_stiff,
        first_critical_speed_without_rotary=bent.natural_frequency_without_rotary,
        first_critical_share=f.critical_share(n_1=bent.natural_frequency, n_max=based_on(fastest * bent.speed, omega)),
    )


def _with_supports(
    step: ShaftStep, masses: tuple[EccentricMass, ...], result: CountershaftResult, judged: bool
) -> CountershaftResult:
    """The same result with what its supports carry: of the bent shaft where its outline is known, and beside it what
    the sources' formulas give, of a shaft that does not bend; support by support where there are more than two or the
    journals are the shaft's own; else [bearings] has them."""
    shaft, journals, bent = step.shaft, step.journals, result.bending
    positions, names = shaft.bearing_positions, [row.name for row in shaft.bearings]
    forces, printed = result.reactions, list(result.loads.values())
    if len(positions) > 2:
        m, e, gamma, z = (column((*masses, *shaft.extras), name) for name in ("mass", "radius", "angle", "z"))
        forces = elements(reactions(f.mass_force(omega=result.omega, m=m, e=e, gamma=gamma), z, positions))
        printed = [f.reaction(R=R) for R in forces]
    loads = printed
    if bent is not None:
        forces = elements(bent.reactions)
        loads = [f.reaction(R=R) for R in forces]
        if len(positions) == 2:
            result = replace(result, loads_by_levers=dict(zip(names, printed)))
    phases = phases_of(names, forces)
    result = replace(result, reactions=forces, loads=dict(zip(names, loads)), load_phases=phases)
    if len(positions) > 2 or bent is not None:
        step.notes.append(supports_note(bent is not None))
    if judged or (len(positions) == 2 and not journals):
        return result
    support = {}
    n_S = f.revolutions(omega=result.omega)
    for n, load in enumerate(loads):
        with about(Text("support {n}", n=n + 1)):
            p = specific_load(F=load, d=journals[n][0], l=journals[n][1]) if journals else None
            W = heat_index(F=load, n=n_S, l=journals[n][1]) if journals else None
            slope = item(bent.slopes[n]) if bent is not None else None
            beside = printed[n] if bent is not None and len(positions) > 2 else None
            support[f"{n + 1}"] = SupportResult(
                reaction=load, reaction_clapeyron=beside, specific_load=p, heat_index=W, slope=slope
            )
    return replace(result, support=support)


def _supplied(step: ShaftStep, masses: tuple[EccentricMass, ...]) -> tuple[complex, complex]:
    """The force and the couple of the shaft, cylinder 1 at TDC."""
    extras, omega = step.shaft.extras, step.omega
    if not extras:
        return _of(masses, omega)
    with about(Text("main masses")):
        F_m, C_m = _of(masses, omega)
    with about(Text("further elements")):
        F_x, C_x = _of(extras, omega)
    return f.whole_force(F_m=F_m, F_x=F_x), f.whole_couple(C_m=C_m, C_x=C_x)


def _of(parts: tuple[EccentricMass, ...], omega: RadPerSecond) -> tuple[complex, complex]:
    """Force and couple of some elements."""
    m, e, gamma, z = (column(parts, name) for name in ("mass", "radius", "angle", "z"))
    C = f.shaft_couple(omega=omega, m=m, e=e, z=z, gamma=gamma)
    return f.shaft_force(omega=omega, m=m, e=e, gamma=gamma), C


def _moments(masses: tuple[EccentricMass, ...], omega: RadPerSecond) -> dict[str, Stated]:
    """What each mass gives of the couple; of masses that share a name each has its number behind it."""
    names = [mass.name for mass in masses]
    return {
        mass.name if names.count(mass.name) == 1 else f"{mass.name}-{n}": Stated(
            Described(Text("Moment of the mass {name} about mid-shaft", name=Name(mass.name)), "N·m", f"M_{n}"),
            f.mass_moment(omega=omega, m=mass.mass, e=mass.radius, z=mass.z),
        )
        for n, mass in enumerate(masses, 1)
        if mass.z
    }


def _balance(step: ShaftStep, masses: tuple[EccentricMass, ...]) -> CountershaftResult:
    """What the shaft supplies, what is left, and what two supports carry."""
    shaft, todo, omega = step.shaft, step.todo, step.omega
    F_S, C_S = _supplied(step, masses)
    first_row, last_row = shaft.bearings[0], shaft.bearings[-1]
    couple, phase, force = f.couple(C_S=C_S), f.couple_phase(C_S=C_S), f.force(F_S=F_S)
    C_against = todo.C_against
    if shaft.paired:
        with about(Text("twin shaft")):
            C_against = f.residual_vector(C_like=C_against, C_S=f.mirrored_couple(C_S=C_S))
    R = tuple(
        f.lever_reaction(C_S=C_S, z_o=other.position, F_S=F_S, z_B=row.position)
        for row, other in ((first_row, last_row), (last_row, first_row))
    )
    return CountershaftResult(
        couple=couple,
        couple_phase=phase,
        mass_moment=_moments(masses, omega),
        static_unbalance=f.static_unbalance(F_S=force, omega=omega),
        force=force,
        loads={row.name: f.reaction(R=R_B) for row, R_B in zip((first_row, last_row), R)},
        load_phases={},
        loads_by_levers={},
        slopes={},
        slopes_stiff={},
        reactions=R,
        support={},
        couple_against=based_on(abs(C_against), C_against),
        eccentric_mass=f.eccentric_mass(m=column(masses, "mass")),
        roll_torque=None if shaft.axis is None else roll_torque(p=based_on(complex(*shaft.axis), shaft.axis), F=F_S),
        masses=masses,
        force_vector=F_S,
        couple_vector=C_S,
        omega=omega,
    )


def with_films(
    outcome: Outcome[CountershaftResult], bearings: "BearingsResult | None", housing: float | None
) -> Outcome[CountershaftResult]:
    """The same outcome with the first critical speed on the films of both bearings as they are at rated speed, and on
    the stiffness of the `housing`; None: rigid."""
    shaft = outcome.result
    if shaft is None or shaft.bending is None or bearings is None:
        return outcome
    with trace() as lines, about(Text("shaft on its films")):
        springs = []
        for bearing in bearings.bearings.values():
            K_f = bearing.spring()
            if K_f is None:
                return outcome
            springs.append(K_f if housing is None else in_series(K_f=K_f, K_H=housing))
        if min(springs) <= 0:  # of a film whose groove lies under its load: it does not hold the journal there
            return outcome
        result = replace(shaft, first_critical_speed_on_films=on_springs(shaft.bending, gathered(springs)))
    return replace(outcome, result=result, lines=(*outcome.lines, *lines))


# --- whether the oil leaves by the support's drains while the machine stands tilted
# The passage to a drain loses of its slope what the machine tilts.  What runs off by the rest is that of a half-full
# pipe of its narrowest bore, with the oil as it leaves the bearings; cold, it runs off far slower, and the film carries
# out as much.

G: MetrePerSecond2 = 9.80665
PIPE = Text("physics, steady flow down a half-full pipe, whose hydraulic diameter is its bore")


@formula("v_l", Text("{pipe}: laminar (Hagen, Poiseuille)", pipe=PIPE), names={"theta": "θ_d", "d": "d_d", "G": "g"})
def laminar_speed(theta: Radian, d: Metre, nu: SquareMetrePerSecond) -> MetrePerSecond:
    return G * sin(theta) * d**2 / (32 * nu)


@formula(
    "v_t",
    Text("{pipe}: turbulent, smooth wall, coefficient of friction 0.316/Re^0.25 (Blasius)", pipe=PIPE),
    names={"theta": "θ_d", "d": "d_d", "G": "g"},
)
def turbulent_speed(theta: Radian, d: Metre, nu: SquareMetrePerSecond) -> MetrePerSecond:
    return power(2 * G * sin(theta) * power(d, 5 / 4) / (0.316 * power(nu, 1 / 4)), 4 / 7)


@formula(
    "Q_d",
    "rule of this program: half full, since air has to come back the same way; of both frictions the larger",
    names={"d": "d_d"},
)
def run_off(d: Metre, v_l: MetrePerSecond, v_t: MetrePerSecond) -> CubicMetrePerSecond:
    return pi / 8 * d**2 * smallest(v_l, v_t)


@formula("Q_o", "given in the design: what of each bearing's oil the drain takes", names={"x": "x_B", "Q": "Q_B"})
def oil_taken(x: Number, Q: CubicMetrePerSecond) -> CubicMetrePerSecond:
    return total(x * Q)


def with_oil(outcome: Outcome[CountershaftResult], bearings: "BearingsResult | None") -> Outcome[CountershaftResult]:
    """The same outcome with the bearings' oil against what runs off, of each drain whose bore is given and that has a
    slope left."""
    shaft = outcome.result
    if shaft is None or bearings is None:
        return outcome
    drains = {} if shaft.drain is None else {"": shaft.drain}
    drains |= shaft.further_drains or {}
    with trace() as lines:
        drains = {name: _with_oil(drain, bearings) for name, drain in drains.items()}
    run_off_checks = tuple(filter(None, map(run_off_check, drains.values())))
    if not run_off_checks:
        return outcome
    result = replace(shaft, drain=drains.pop("", None), further_drains=drains or None)
    return replace(outcome, result=result, checks=outcome.checks + run_off_checks, lines=(*outcome.lines, *lines))


def _with_oil(result: DrainResult, bearings: "BearingsResult") -> DrainResult:
    drain, slope = result.drain, result.drain_slope
    if drain.bore is None or slope is None or slope <= 0:
        return result
    fed = [bearing for bearing in bearings.bearings.values() if bearing.drained() is not None]
    if not fed:
        return result
    with about(Text("oil drain")):
        nu = max(oil.nu for bearing in fed if (oil := bearing.drained()) is not None)
        v_l, v_t = laminar_speed(theta=slope, d=drain.bore, nu=nu), turbulent_speed(theta=slope, d=drain.bore, nu=nu)
        shares: Any = gathered(drain.oil_share)
        flow = oil_taken(x=shares, Q=column(fed, "oil_flow"))
        return replace(result, drain_flow=flow, drain_run_off=run_off(d=drain.bore, v_l=v_l, v_t=v_t))
