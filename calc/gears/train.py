# SPDX-License-Identifier: Apache-2.0
"""The profile shifts and centre distances that a design leaves open, found along the meshes of the train.

One wheel has one shift, whatever it meshes with: a centre distance and one shift fix the mate's, two shifts fix a centre distance
without backlash.  Nothing is rounded on the way.
"""

from dataclasses import dataclass, field

from ..sheet.errors import NoSolution
from ..sheet.trace import about, untraced
from ..sheet.units import Metre, Number, RevPerSecond
from . import formulas as f
from .inputs import GearsInputs, Mesh, Wheel
from .profile.cut import tool_problem
from .result import ToothSystem

MOST_SHIFT = 6  # rule of this program: a distance that asks for more is wrong, or the teeth are
CONTRADICTION = 1e-3  # two given shifts may differ from the centre distance by this, in modules


def tooth_system(gears: GearsInputs) -> ToothSystem:
    m_n, alpha_n, beta = gears.normal_module, gears.pressure_angle, gears.helix_angle
    with about("tooth system"):
        m_t = f.transverse_module(m_n, beta)
        alpha_t = f.transverse_pressure_angle(alpha_n, beta)
        h_fP = f.finished_dedendum(gears.tool_addendum, gears.stock, m_n, alpha_n)
        s_pr = f.residual_undercut(gears.protuberance, gears.stock)
        system = ToothSystem(
            transverse_module=m_t, transverse_pressure_angle=alpha_t, base_helix_angle=f.base_helix_angle(beta, alpha_n),
            base_pitch=f.base_pitch(m_t, alpha_t), h_fP=h_fP, s_pr=s_pr, m_n=m_n, alpha_n=alpha_n, beta=beta,
            h_aP0=gears.tool_addendum, rho_aP0=gears.tool_tip_radius, stock=gears.stock,
        )  # fmt: skip
        if (problem := tool_problem(system)) is not None:
            raise problem
        return system


@dataclass(slots=True)
class Train:
    """Circles and shifts by wheel, centre distances by mesh, and what was chosen on the way."""

    system: ToothSystem
    wheels: dict[str, Wheel]
    shifts: dict[str, Number]
    d: dict[str, Metre] = field(default_factory=dict)
    d_b: dict[str, Metre] = field(default_factory=dict)
    distances: dict[str, Metre] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)


def settle(gears: GearsInputs, system: ToothSystem) -> Train:
    """Every shift and every centre distance of the train.

    In this order: a centre distance with one known shift gives the mate's; a wheel that is still open takes the shift of a wheel
    with as many teeth; else the first open one takes 0, and what follows from that is derived again.
    """
    wheels = {w.name: w for w in gears.wheels}
    train = Train(system, wheels, {w.name: w.profile_shift for w in gears.wheels if w.profile_shift is not None})
    for wheel in gears.wheels:
        with about(f"wheel {wheel.name}"):
            train.d[wheel.name] = f.reference_diameter(wheel.teeth, system.transverse_module)
            train.d_b[wheel.name] = f.base_diameter(train.d[wheel.name], system.transverse_pressure_angle)
    compared: set[int] = set()
    while True:
        _derive(gears, train, compared)
        still_open = [w for w in gears.wheels if w.name not in train.shifts]
        if not still_open:
            break
        _choose(train, still_open)
    for i, mesh in enumerate(gears.meshes):
        with about(f"mesh {mesh.driver}–{mesh.driven}"):
            train.distances[mesh.key] = mesh.centre_distance if mesh.centre_distance is not None else _distance(train, mesh, i)
    return train


def _derive(gears: GearsInputs, train: Train, compared: set[int]) -> None:
    """Shifts from centre distances, until no mesh gives another one; two known shifts are compared with the distance once."""
    found = True
    while found:
        found = False
        for i, mesh in enumerate(gears.meshes):
            known = [name for name in (mesh.driver, mesh.driven) if name in train.shifts]
            if mesh.centre_distance is None or not known or i in compared:
                continue
            compared.add(i)
            found = True
            mate = mesh.driver if known == [mesh.driven] else mesh.driven
            with about(f"mesh {mesh.driver}–{mesh.driven}"):
                x = f.mate_shift(_shift_sum(train, mesh, i), train.shifts[known[0]])
            if len(known) == 2:
                _compare(train, mesh, i, x)
            elif abs(x) > MOST_SHIFT:
                raise _too_much(train, mesh, i, known[0], mate, x)
            train.shifts[mate] = x


def _too_much(train: Train, mesh: Mesh, i: int, known: str, mate: str, x: Number) -> NoSolution:
    """A centre distance that asks for a shift which no key would allow."""
    s, z = train.system, (train.wheels[mesh.driver].teeth, train.wheels[mesh.driven].teeth)
    ends = []
    with untraced():
        for end in (-MOST_SHIFT, MOST_SHIFT):
            involute = f.working_involute(s.transverse_pressure_angle, s.alpha_n, train.shifts[known], end, *z)
            ends.append(f.centre_distance(*z, s.transverse_module, s.transverse_pressure_angle, f.angle_of_involute(involute)))
    return NoSolution(
        f"gears.meshes.{i}.centre_distance_mm = {mesh.centre_distance * 1e3:g}: with the shift {train.shifts[known]:.6g} of {known} it "
        f"needs {x:.4g} of {mate}; −{MOST_SHIFT} to {MOST_SHIFT} is the most that is tried",
        advice=f"a distance from {ends[0] * 1e3:.3f} to {ends[1] * 1e3:.3f} mm, other numbers of teeth, or another shift of {known}",
    )


def _compare(train: Train, mesh: Mesh, i: int, x: Number) -> None:
    """Both shifts are known: the driver's holds, and the driven wheel's must agree with the centre distance."""
    given = train.shifts[mesh.driven]
    if abs(x - given) <= CONTRADICTION:
        if x != given:
            train.notes.append(
                f"Profile shift of {mesh.driven}: {given:g} is given; {x:.6g} follows from the distance to {mesh.driver} and is used."
            )
        return
    raise NoSolution(
        f"gears.meshes.{i}.centre_distance_mm = {mesh.centre_distance * 1e3:g}: contradicts the profile shifts {mesh.driver} "
        f"{train.shifts[mesh.driver]:.6g} and {mesh.driven} {given:.6g}; without backlash it needs {mesh.driven} {x:.6g}",
        tried=f"shifts that agree within {CONTRADICTION:g}",
        advice=f"leave out gears.wheels.{mesh.driven}.profile_shift, or the centre distance: it then follows",
    )


def _choose(train: Train, still_open: list[Wheel]) -> None:
    """One open wheel gets a shift that nothing in the design gives."""
    for wheel in still_open:
        for name, x in train.shifts.items():
            if train.wheels[name].teeth == wheel.teeth:
                train.shifts[wheel.name] = x
                train.notes.append(f"Profile shift of {wheel.name}: not given; chosen: {x:.6g}, that of {name}, which has as many teeth.")
                return
    with about(f"wheel {still_open[0].name}"):
        train.shifts[still_open[0].name] = f.no_shift()
    train.notes.append(f"Profile shift of {still_open[0].name}: not given; chosen: 0.")


def _shift_sum(train: Train, mesh: Mesh, i: int) -> Number:
    system, z_1, z_2 = train.system, train.wheels[mesh.driver].teeth, train.wheels[mesh.driven].teeth
    d_b1, d_b2 = train.d_b[mesh.driver], train.d_b[mesh.driven]
    if mesh.centre_distance <= (d_b1 + d_b2) / 2:
        unshifted = (train.d[mesh.driver] + train.d[mesh.driven]) / 2
        raise NoSolution(
            f"gears.meshes.{i}.centre_distance_mm = {mesh.centre_distance * 1e3:g}: {mesh.driver} ({z_1} teeth) and {mesh.driven} ({z_2}) "
            "can not mesh so close: their base circles overlap",
            advice=f"it must exceed {(d_b1 + d_b2) / 2 * 1e3:.4f} mm; without profile shift it is {unshifted * 1e3:.4f} mm",
        )
    alpha_wt = f.working_pressure_angle(d_b1, d_b2, mesh.centre_distance)
    return f.shift_sum(z_1, z_2, alpha_wt, system.transverse_pressure_angle, system.alpha_n)


def _distance(train: Train, mesh: Mesh, i: int) -> Metre:
    """The centre distance without backlash from both shifts."""
    system, z_1, z_2 = train.system, train.wheels[mesh.driver].teeth, train.wheels[mesh.driven].teeth
    x_1, x_2 = train.shifts[mesh.driver], train.shifts[mesh.driven]
    involute = f.working_involute(system.transverse_pressure_angle, system.alpha_n, x_1, x_2, z_1, z_2)
    if involute <= 0:
        raise NoSolution(
            f"gears.meshes.{i}: with the profile shifts {mesh.driver} {x_1:.6g} and {mesh.driven} {x_2:.6g} no centre distance is free of "
            "backlash: the base circles would overlap",
            advice="give larger (less negative) profile shifts",
        )
    a_w = f.centre_distance(z_1, z_2, system.transverse_module, system.transverse_pressure_angle, f.angle_of_involute(involute))
    name = f"{mesh.driver}–{mesh.driven}"
    train.notes.append(f"Centre distance {name}: not given; chosen: {a_w * 1e3:.4f} mm, without backlash before allowances.")
    return a_w


def speeds(gears: GearsInputs, first_speed: RevPerSecond) -> dict[str, RevPerSecond]:
    """Speed of every wheel, + in the sense of the first driver."""
    wheels = {w.name: w for w in gears.wheels}
    found = {gears.meshes[0].driver: first_speed}
    for mesh in gears.meshes:
        with about(f"wheel {mesh.driven}"):
            found[mesh.driven] = f.driven_speed(found[mesh.driver], wheels[mesh.driver].teeth, wheels[mesh.driven].teeth)
    return found
