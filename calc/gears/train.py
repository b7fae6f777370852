# SPDX-License-Identifier: Apache-2.0
"""The profile shifts and centre distances that a design leaves open, found along the meshes of the train.

One wheel has one shift, whatever it meshes with: a centre distance and one shift fix the mate's, two shifts fix a
centre distance without backlash.  Where both shifts and the distance are given, they make the backlash.  Nothing is
rounded on the way."""

from ..sheet.errors import NoSolution
from ..sheet.text import Amount, Text
from ..sheet.units import Metre, Number, RevPerSecond
from ..sheet.value import about, based_on, untraced
from . import formulas as f
from .inputs import GearsInputs, Mesh
from .limits import mm
from .profile.cut import tool_problem
from .result import ToothSystem
from .stages import speed_behind_stage
from .wheel_inputs import Wheel

MOST_SHIFT = 6  # rule of this program: a distance that asks for more is wrong, or the teeth are
CONTRADICTION = 1e-3  # two given shifts that differ by no more from those without backlash are meant to have none


def tooth_system(gears: GearsInputs) -> ToothSystem:
    alpha_n, beta = gears.pressure_angle, gears.helix_angle
    with about(Text("tooth system")):
        m_n = gears.normal_module
        if m_n is None:
            assert gears.transverse_module is not None
            m_n = f.normal_module(m_t=gears.transverse_module, beta=beta)
        m_t = f.transverse_module(m_n, beta)
        alpha_t = f.transverse_pressure_angle(alpha_n, beta)
        h_fP = f.finished_dedendum(gears.tool_addendum, gears.stock, m_n, alpha_n)
        s_pr = f.residual_undercut(gears.protuberance, gears.stock)
        system = ToothSystem(
            transverse_module=m_t,
            transverse_pressure_angle=alpha_t,
            base_helix_angle=f.base_helix_angle(beta, alpha_n),
            base_pitch=f.base_pitch(m_t, alpha_t),
            h_fP=h_fP,
            s_pr=s_pr,
            m_n=m_n,
            alpha_n=alpha_n,
            beta=beta,
            h_aP0=gears.tool_addendum,
            rho_aP0=gears.tool_tip_radius,
            stock=gears.stock,
        )
        if (problem := tool_problem(system)) is not None:
            raise problem
        return system


class Train:
    """Circles and shifts by wheel, centre distances by mesh, and what was chosen on the way."""

    def __init__(self, system: ToothSystem, wheels: dict[str, Wheel], shifts: dict[str, Number]) -> None:
        self.system, self.wheels, self.shifts = system, wheels, shifts
        self.d: dict[str, Metre] = {}
        self.d_b: dict[str, Metre] = {}
        self.distances: dict[str, Metre] = {}
        self.notes: list[Text] = []


def settle(gears: GearsInputs, system: ToothSystem) -> Train:
    """Every shift and every centre distance of the train.

    In this order: a centre distance with one known shift gives the mate's; a wheel that is still open takes the shift
    of a wheel with as many teeth; else the first open one takes 0, and what follows from that is derived again."""
    wheels = {w.name: w for w in gears.wheels}
    train = Train(system, wheels, {w.name: w.profile_shift for w in gears.wheels if w.profile_shift is not None})
    for wheel in gears.wheels:
        with about(Text("wheel {name}", name=wheel.name)):
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
        with about(Text("mesh {pair}", pair=mesh.title)):
            a_w = mesh.centre_distance
            train.distances[mesh.key] = a_w if a_w is not None else _distance(train, mesh, i)
    return train


def _derive(gears: GearsInputs, train: Train, compared: set[int]) -> None:
    """Shifts from centre distances, until no mesh gives another one; two known shifts are compared with the distance
    once."""
    progress = True
    while progress:
        progress = False
        for i, mesh in enumerate(gears.meshes):
            known = [name for name in (mesh.driver, mesh.driven) if name in train.shifts]
            a = mesh.centre_distance
            if a is None or not known or i in compared:
                continue
            compared.add(i)
            progress = True
            mate = mesh.driver if known == [mesh.driven] else mesh.driven
            with about(Text("mesh {pair}", pair=mesh.title)):
                x = f.mate_shift(_shift_sum(train, mesh, i, a), train.shifts[known[0]])
            if len(known) == 2:
                x = _compare(train, mesh, i, a, x)
            elif abs(x) > MOST_SHIFT:
                raise _too_much(train, mesh, i, a, known[0], mate, x)
            train.shifts[mate] = x


def _too_much(train: Train, mesh: Mesh, i: int, a: Metre, known: str, mate: str, x: Number) -> NoSolution:
    """A centre distance that asks for a shift which no key would allow."""
    s, z = train.system, (train.wheels[mesh.driver].teeth, train.wheels[mesh.driven].teeth)
    ends, alpha_t = [], s.transverse_pressure_angle
    with untraced():
        for end in (-MOST_SHIFT, MOST_SHIFT):
            involute = f.working_involute(alpha_t, s.alpha_n, train.shifts[known], end, *z)
            ends.append(f.centre_distance(*z, s.transverse_module, alpha_t, f.angle_of_involute(involute)))
    return NoSolution(
        Text(
            "gears.meshes.{i}.centre_distance_mm = {centre_distance}: with the shift {shifts} of {known} it needs {x} "
            "of {mate}; −{most_shift} to {most_shift} is the most that is tried",
            i=i,
            centre_distance=mm(a, "g"),
            shifts=Amount(train.shifts[known], form=".6g"),
            known=known,
            x=Amount(x, form=".4g"),
            mate=mate,
            most_shift=MOST_SHIFT,
        ),
        advice=Text(
            "a distance from {ends} to {ends2} mm, other numbers of teeth, or another shift of {known}",
            ends=mm(ends[0], ".3f"),
            ends2=mm(ends[1], ".3f"),
            known=known,
        ),
    )


def _compare(train: Train, mesh: Mesh, i: int, a: Metre, x: Number) -> Number:
    """The shift of the driven wheel where both are known; `x`: the one that leaves no backlash.

    One that nearly agrees is taken for it; with another the teeth have backlash, unless they would jam.
    """
    given = train.shifts[mesh.driven]
    if abs(x - given) <= CONTRADICTION:
        if x != given:
            train.notes.append(
                Text(
                    "Profile shift of {driven}: {given} is given; {x} follows from the distance to {driver} and is "
                    "used.",
                    driven=mesh.driven,
                    given=Amount(given, form="g"),
                    x=Amount(x, form=".6g"),
                    driver=mesh.driver,
                )
            )
        return x
    with untraced():
        j_bn = f.backlash_of_shifts(m_n=train.system.m_n, alpha_n=train.system.alpha_n, x_0=x, x_2=given)
    values = dict(
        driver=mesh.driver,
        x_1=Amount(train.shifts[mesh.driver], form=".6g"),
        driven=mesh.driven,
        given=Amount(given, form=".6g"),
        x=Amount(x, form=".6g"),
        j_bn=Amount(abs(j_bn) * 1e6, "µm"),
    )
    if j_bn > 0:
        train.notes.append(
            Text(
                "Mesh {driver}–{driven}: centre distance and both profile shifts are given, {x_1} and {given}; before "
                "allowances they leave a normal backlash of {j_bn}, none with {driven} {x}.",
                **values,
            )
        )
        return given
    raise NoSolution(
        Text(
            "gears.meshes.{i}.centre_distance_mm = {centre_distance}: contradicts the profile shifts {driver} {x_1} "
            "and {driven} {given}; the teeth jam by {j_bn}, and without backlash it needs {driven} {x}",
            i=i,
            centre_distance=mm(a, "g"),
            **values,
        ),
        tried=Text(
            "shifts that agree within {contradiction}, or leave backlash", contradiction=Amount(CONTRADICTION, form="g")
        ),
        advice=Text(
            "lower gears.wheels.{driven}.profile_shift, or leave it out, or the centre distance: it then follows",
            driven=mesh.driven,
        ),
    )


def _choose(train: Train, still_open: list[Wheel]) -> None:
    """One open wheel gets a shift that nothing in the design gives."""
    for wheel in still_open:
        for name, x in train.shifts.items():
            if train.wheels[name].teeth == wheel.teeth:
                train.shifts[wheel.name] = based_on(x, x, wheel.teeth, train.wheels[name].teeth)
                train.notes.append(
                    Text(
                        "Profile shift of {name}: not given; chosen: {x}, that of {name2}, which has as many teeth.",
                        name=wheel.name,
                        x=Amount(x, form=".6g"),
                        name2=name,
                    )
                )
                return
    with about(Text("wheel {name}", name=still_open[0].name)):
        train.shifts[still_open[0].name] = f.no_shift()
    train.notes.append(Text("Profile shift of {name}: not given; chosen: 0.", name=still_open[0].name))


def _shift_sum(train: Train, mesh: Mesh, i: int, a: Metre) -> Number:
    system, z_1, z_2 = train.system, train.wheels[mesh.driver].teeth, train.wheels[mesh.driven].teeth
    d_b1, d_b2 = train.d_b[mesh.driver], train.d_b[mesh.driven]
    if a <= (d_b1 + d_b2) / 2:
        unshifted = (train.d[mesh.driver] + train.d[mesh.driven]) / 2
        raise NoSolution(
            Text(
                "gears.meshes.{i}.centre_distance_mm = {centre_distance}: {driver} ({z_1} teeth) and {driven} ({z_2}) "
                "can not mesh so close: their base circles overlap",
                i=i,
                centre_distance=mm(a, "g"),
                driver=mesh.driver,
                z_1=z_1,
                driven=mesh.driven,
                z_2=z_2,
            ),
            advice=Text(
                "it must exceed {d_b1} mm; without profile shift it is {unshifted} mm",
                d_b1=mm((d_b1 + d_b2) / 2, ".4f"),
                unshifted=mm(unshifted, ".4f"),
            ),
        )
    alpha_wt = f.working_pressure_angle(d_b1, d_b2, a)
    return f.shift_sum(z_1, z_2, alpha_wt, system.transverse_pressure_angle, system.alpha_n)


def _distance(train: Train, mesh: Mesh, i: int) -> Metre:
    """The centre distance without backlash from both shifts."""
    system, z_1, z_2 = train.system, train.wheels[mesh.driver].teeth, train.wheels[mesh.driven].teeth
    x_1, x_2 = train.shifts[mesh.driver], train.shifts[mesh.driven]
    involute = f.working_involute(system.transverse_pressure_angle, system.alpha_n, x_1, x_2, z_1, z_2)
    if involute <= 0:
        raise NoSolution(
            Text(
                "gears.meshes.{i}: with the profile shifts {driver} {x_1} and {driven} {x_2} no centre distance is "
                "free of backlash: the base circles would overlap",
                i=i,
                driver=mesh.driver,
                x_1=Amount(x_1, form=".6g"),
                driven=mesh.driven,
                x_2=Amount(x_2, form=".6g"),
            ),
            advice=Text("give larger (less negative) profile shifts"),
        )
    a_w = f.centre_distance(
        z_1, z_2, system.transverse_module, system.transverse_pressure_angle, f.angle_of_involute(involute)
    )
    chosen = Text(
        "Centre distance {name}: not given; chosen: {a_w} mm, without backlash before allowances.",
        name=mesh.title,
        a_w=mm(a_w, ".4f"),
    )
    train.notes.append(chosen)
    return a_w


def speeds(gears: GearsInputs, first_speed: RevPerSecond) -> dict[str, RevPerSecond]:
    """Speed of every wheel, + in the sense of the first driver."""
    tree = gears.tree
    n = {tree.first: first_speed}
    for link in tree.links:
        with about(Text("wheel {driven}", driven=link.driven)):
            if link.toothed:
                n[link.driven] = f.driven_speed(n[link.driver], link.z_1, link.z_2)
            else:
                n[link.driven] = speed_behind_stage(n[link.driver], link.z_1, link.z_2, link.sense)
    return n
