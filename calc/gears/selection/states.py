# SPDX-License-Identifier: Apache-2.0
"""Many trains at once: what the shifts and tip cuts of all wheels make of the teeth, and what a choice has to keep.

Of the teeth: sliding, contact, tips and clearances.  The formulas are those of `formulas.py`, called with arrays: one
element for each combination."""

from collections.abc import Iterable, Mapping

import numpy as np

from ...sheet.arrays import Array, Num
from ...sheet.record import record, replace
from ...sheet.search import Judged, judged, least
from ...sheet.text import Name, Text
from ...sheet.units import Metre, Number
from .. import formulas as f
from .. import limits as p
from ..formulas import ISO
from ..inputs import GearsInputs, Mesh
from ..limits import above_fillet
from ..measures.formulas import generating_shift
from ..profile.cut import Cut, form_diameter_of_undercut
from ..result import ToothSystem
from ..wheel_inputs import Wheel

NODES = 33  # of the form diameter over the shift, where it comes from the tool's trochoid

Place = tuple[str, str]  # (mesh, wheel)
ByWheel = Mapping[str, float | Array]  # numbers or arrays that go together


@record
class States:
    """Arrays over the combinations, by wheel, by mesh, or by mesh and wheel.  Where wheels can not mesh: no number
    (nan).

    `sliding` and `sliding_lpstc`: signed, negative in the dedendum; the latter is no number where ε_α is not from 1 to
    2. `margin`: (d_N − d_Ff)/2 with the fillet of the thinnest tooth (x_E of the lower allowance); d_N: where the
    mate's tip arrives. `clearance`: at the wheel's root.  `tip_thickness`: normal.  `largest`: |ζ| of all at the start
    of contact."""

    shifts: Mapping[str, Array]
    cuts: Mapping[str, Array]
    distances: Mapping[str, Array]
    undercut_limit: Mapping[str, float]
    tip_thickness: Mapping[str, Array]
    contact_ratio: Mapping[str, Array]
    sap_diameter: Mapping[Place, Array]
    sliding: Mapping[Place, Array]
    sliding_lpstc: Mapping[Place, Array]
    margin: Mapping[Place, Array]
    clearance: Mapping[Place, Array]

    @property
    def largest(self) -> Array:
        return worst(self.sliding.values())

    def largest_of(self, mesh: str) -> Array:
        return worst(zeta for (key, _), zeta in self.sliding.items() if key == mesh)


def worst(sliding: Iterable[Array]) -> Array:
    """The largest modulus, element by element; ∞ where wheels can not mesh."""
    largest: Array = np.max(np.abs(np.array(list(sliding))), axis=0)
    return np.where(np.isnan(largest), np.inf, largest)


@record
class _Circles:
    """One wheel of every combination."""

    wheel: Wheel
    d: Metre
    d_b: Metre
    d_a: Array
    d_f: Array
    rho_a: Array
    rho_F: Array
    d_Ff_E: Array  # of the thinnest tooth


def states(system: ToothSystem, gears: GearsInputs, shifts: ByWheel, cuts: ByWheel | None = None) -> States:
    """`shifts` of every wheel and `cuts` (left out: those of the design).

    A mesh of `gears` with a centre distance has it; with any other the distance follows without backlash.  The shifts
    have to agree with the given distances; who makes them so is `freedom`."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return _states(system, gears, shifts, cuts or {})


def _states(system: ToothSystem, gears: GearsInputs, shifts: ByWheel, cuts: ByWheel) -> States:
    names = [w.name for w in gears.wheels]
    given = [shifts[n] for n in names] + [cuts.get(w.name, w.tip_shortening) for w in gears.wheels]
    every = np.broadcast_arrays(*(np.atleast_1d(np.asarray(value, dtype=float)) for value in given))
    x, k = dict(zip(names, every)), dict(zip(names, every[len(names) :]))
    tool = system.h_fP, system.rho_aP0, system.alpha_n
    limits = {
        w.name: f.undercut_limit(*tool, w.teeth, system.transverse_pressure_angle, system.beta) for w in gears.wheels
    }
    circles, tips = {}, {}
    for wheel in gears.wheels:
        circles[wheel.name], tips[wheel.name] = _circles(
            system, wheel, x[wheel.name], k[wheel.name], limits[wheel.name]
        )
    distances: dict[str, Array] = {}
    ratios: dict[str, Array] = {}
    parts: tuple[dict[Place, Array], ...] = ({}, {}, {}, {}, {})
    for mesh in gears.meshes:
        key, a_w = mesh.key, _distance(system, mesh, circles, x)
        distances[key] = np.broadcast_to(np.asarray(a_w, dtype=float), every[0].shape)
        ratios[key] = _mesh(system, key, a_w, (circles[mesh.driver], circles[mesh.driven]), parts)
    sap, sliding, lpstc, margin, clearance = parts
    return States(
        shifts=x,
        cuts=k,
        distances=distances,
        undercut_limit=limits,
        tip_thickness=tips,
        contact_ratio=ratios,
        sap_diameter=sap,
        sliding=sliding,
        sliding_lpstc=lpstc,
        margin=margin,
        clearance=clearance,
    )


def _circles(s: ToothSystem, wheel: Wheel, x: Array, k: Array, x_min: Number) -> tuple[_Circles, Array]:
    alpha_t = s.transverse_pressure_angle
    d = f.reference_diameter(wheel.teeth, s.transverse_module)
    d_b = f.base_diameter(d, alpha_t)
    d_a = f.tip_diameter(d, s.m_n, x, k)
    s_at = f.thickness_at(
        d_a, f.reference_thickness(s.m_n, x, s.alpha_n, s.beta), d, alpha_t, f.pressure_angle_at(d_b, d_a)
    )
    d_Ff = _form_diameter(s, wheel, x, x_min, d, d_b)
    lower = wheel.span_allowance[1] if wheel.span_allowance else None
    thinnest = (
        d_Ff if lower is None else _form_diameter(s, wheel, generating_shift(x, lower, s.m_n, s.alpha_n), x_min, d, d_b)
    )
    circles = _Circles(
        wheel=wheel,
        d=d,
        d_b=d_b,
        d_a=d_a,
        d_f=f.root_diameter(d, s.m_n, x, s.h_fP),
        rho_a=f.curvature_at(d_a, d_b),
        rho_F=f.curvature_at(d_Ff, d_b),
        d_Ff_E=thinnest,
    )
    return circles, f.normal_thickness_at(s_at, s.beta, d_a, d)


def _form_diameter(s: ToothSystem, wheel: Wheel, x: Array, x_min: Number, d: Metre, d_b: Metre) -> Array:
    """By the closed form; below x_min and for a tool with protuberance from the trochoid, of many shifts between a few
    of them."""
    straight = f.form_diameter(
        d, s.transverse_pressure_angle, f.straight_flank_depth(s.m_n, s.h_fP, s.rho_aP0, s.alpha_n, x), d_b
    )
    crossed = np.full(x.shape, True) if s.s_pr > 0 else np.asarray(x < x_min)
    if not crossed.any():
        return straight
    at = np.unique(x[crossed])
    if len(at) > NODES:
        at = np.linspace(at[0], at[-1], NODES)
    known = np.array([form_diameter_of_undercut(Cut(s, wheel.teeth, float(shift))) for shift in at])
    return np.where(crossed, np.interp(x, at, known), straight)


def _distance(s: ToothSystem, mesh: Mesh, circles: dict[str, _Circles], x: dict[str, Array]) -> Num:
    if mesh.centre_distance is not None:
        return mesh.centre_distance
    z_1, z_2 = circles[mesh.driver].wheel.teeth, circles[mesh.driven].wheel.teeth
    alpha_t = s.transverse_pressure_angle
    involute = f.working_involute(alpha_t, s.alpha_n, x[mesh.driver], x[mesh.driven], z_1, z_2)
    return f.centre_distance(z_1, z_2, s.transverse_module, alpha_t, f.angle_of_involute(involute))


def _mesh(
    s: ToothSystem, key: str, a_w: Num, wheels: tuple[_Circles, _Circles], parts: tuple[dict[Place, Array], ...]
) -> Array:
    """Fill the parts of one mesh in; gives its contact ratio."""
    sap, sliding, lpstc, margin, clearance = parts
    one, two = wheels
    T = f.line_of_action(a_w, f.working_pressure_angle(one.d_b, two.d_b, a_w))
    starts = {w.wheel.name: f.start_of_active_profile(T, m.rho_a, w.rho_F) for w, m in ((one, two), (two, one))}
    path = f.path_of_contact(T, starts[one.wheel.name], starts[two.wheel.name])
    eps_alpha = f.transverse_contact_ratio(path, s.base_pitch)
    single = (eps_alpha >= 1) & (eps_alpha < 2)
    for wheel, mate in ((one, two), (two, one)):
        at, z, z_m = (key, wheel.wheel.name), wheel.wheel.teeth, mate.wheel.teeth
        rho_A = starts[wheel.wheel.name]
        rho_B = f.lowest_single_contact(T, starts[mate.wheel.name], s.base_pitch)
        sap[at] = f.diameter_at(wheel.d_b, rho_A)
        sliding[at] = np.where((rho_A > 0) & (path > 0), f.specific_sliding(T, rho_A, z, z_m), np.nan)
        lpstc[at] = np.where(single, f.specific_sliding(T, rho_B, z, z_m), np.nan)
        margin[at] = above_fillet(wheel.d_b, T, mate.rho_a, wheel.d_Ff_E)
        clearance[at] = f.tip_clearance(a_w, wheel.d_f, mate.d_a)
    return eps_alpha


# --- what a choice of shifts has to keep, all without unit: lengths in normal modules


@record
class ShiftRule:
    """`hard`: the limit below which nothing is offered, even where the design itself stands below the usual `limit`."""

    key: str
    name: Text
    symbol: Text
    brief: Text
    limit: float
    hard: float
    source: Text
    advice: Text


UNDERCUT = ShiftRule(
    "undercut",
    Text("Shift above undercut"),
    Name("x − x_min"),
    Text("undercut"),
    0.0,
    0.0,
    ISO,
    Text("take more teeth, or a smaller tool addendum"),
)
TIP = ShiftRule(
    "tip_thickness",
    Text("Normal tip thickness"),
    Name("s_an/m_n"),
    Name("s_an"),
    p.TIP_THICKNESS,
    p.TIP_THICKNESS,
    p.PRACTICE,
    Text("cut the tips"),
)
HARDENED = replace(
    TIP,
    key="tip_thickness_hardened",
    name=Text("Normal tip thickness, case-hardened"),
    limit=p.TIP_THICKNESS_HARDENED,
    hard=p.TIP_THICKNESS_HARDENED,
)
CONTACT = ShiftRule(
    "contact_ratio",
    Text("Transverse contact ratio"),
    Name("ε_α"),
    Name("ε_α"),
    p.USUAL_CONTACT_RATIO,
    p.CONTACT_RATIO,
    p.PRACTICE,
    Text("cut less off the tips, or take more teeth of a smaller module"),
)
FILLET = ShiftRule(
    "above_fillet",
    Text("Start of contact above the fillet of the thinnest tooth"),
    Name("(d_N − d_Ff)/(2·m_n)"),
    Text("fillet"),
    p.USUAL_ABOVE_FILLET,
    p.ABOVE_FILLET,
    p.PRACTICE,
    Text("cut the tip of the mate"),
)
CLEARANCE = ShiftRule(
    "tip_clearance",
    Text("Tip clearance"),
    Name("c/m_n"),
    Name("c"),
    p.USUAL_TIP_CLEARANCE,
    p.TIP_CLEARANCE,
    Text("rule of this program for choosing"),
    Text("cut the tip of the mate, or take a tool with a larger addendum"),
)
HARD_CASE = (UNDERCUT, HARDENED, CONTACT, FILLET, CLEARANCE)
USUAL = (UNDERCUT, TIP, CONTACT, FILLET, CLEARANCE)

# for the shift, the tips, the contact ratio, the start of contact, the clearance
Bar = tuple[ShiftRule, ShiftRule, ShiftRule, ShiftRule, ShiftRule]


@record
class RulePlace:
    """Where a rule is judged: `wheel` or `mesh` is empty where the rule knows none."""

    mesh: str
    wheel: str

    @property
    def name(self) -> str:
        return self.wheel or self.mesh.replace("_", "–")


def judge(states: States, system: ToothSystem, bar: Bar) -> list[Judged]:
    """Every rule at every wheel and mesh; arrays over the combinations."""
    undercut, tip, contact, fillet, clearance = bar
    m_n = system.m_n

    def by(rule: ShiftRule, value: Array, mesh: str = "", wheel: str = "") -> Judged:
        return judged(rule, value, rule.limit, where=RulePlace(mesh, wheel))

    return [
        *(by(undercut, x - states.undercut_limit[w], wheel=w) for w, x in states.shifts.items()),
        *(by(tip, s / m_n, wheel=w) for w, s in states.tip_thickness.items()),
        *(by(contact, eps, mesh) for mesh, eps in states.contact_ratio.items()),
        *(by(fillet, length / m_n, mesh, w) for (mesh, w), length in states.margin.items()),
        *(by(clearance, c / m_n, mesh, w) for (mesh, w), c in states.clearance.items()),
    ]


def eased(now: States, system: ToothSystem) -> Bar | None:
    """For a design that stands below a usual limit: no worse than it, nor below what is hard.  None where it keeps them
    all, or can not."""
    every = judge(now, system, USUAL)
    limits = {}
    for rule in USUAL:
        here = min(float(entry.value[0]) for entry in every if entry.rule is rule)
        limits[rule.key] = max(rule.hard, min(rule.limit, here)) if here == here else rule.hard
    bar = tuple(replace(rule, limit=limits[rule.key]) if limits[rule.key] < rule.limit else rule for rule in USUAL)
    return None if bar == USUAL else (bar[0], bar[1], bar[2], bar[3], bar[4])


def keeps(states: States, system: ToothSystem, bar: Bar) -> Array:
    """The least margin of all rules, combination by combination."""
    return least(judge(states, system, bar))
