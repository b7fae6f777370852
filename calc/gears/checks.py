# SPDX-License-Identifier: Apache-2.0
"""What is judged on the gear train, and what to do where it fails."""

import math

from ..sheet.check import Check, check
from ..sheet.units import Number
from . import practice as p
from .formulas import ISO
from .measures import formulas as m
from .play.backlash import way_to
from .play.judge import freed
from .result import MeshResult, ToothSystem, TrainResult, WheelResult

SAME_RATIO = 1e-9
DUST = 1e-12


def checks(train: TrainResult) -> tuple[Check, ...]:
    found: list[Check] = []
    for i, (key, mesh) in enumerate(train.meshes.items()):
        id, pair = f"gears.{key}", (train.wheels[mesh.driver], train.wheels[mesh.driven])
        found.append(_backlash(train.system, id, f"gears.meshes.{i}", mesh, *pair))
        found += _contact(id, mesh)
        found += _clearance(train.system, id, mesh, *pair)
    for wheel in train.wheels.values():
        found += _tooth(train.system, wheel)
        found += _measures(train.system, wheel)
    return tuple(found)


# --- the train -------------------------------------------------------------------------------------------------------------
def speed_ratio(train: TrainResult, wanted: Number, crank: float | None = None) -> Check:
    """Whether the last wheel turns as the shaft must: its speed over that of the first driver, as far as it is off the wanted one."""
    along = list(train.meshes.values())
    first, last = train.wheels[along[0].driver], train.wheels[along[-1].driven]
    way = [*(train.wheels[train.meshes[key].driver] for key in way_to(last.name, train.meshes)), last]
    driven_by = abs(first.speed) / crank if crank else 1.0  # of the crank's speed
    ratio, parity = train.speed_ratio * driven_by, "an odd" if wanted < 0 else "an even"
    teeth, needed = " → ".join(f"{wheel.name} {wheel.teeth}" for wheel in way), first.teeth * driven_by / abs(wanted)
    enough = f"{needed:g} teeth" if needed == round(needed) else f"{driven_by / abs(wanted):g} times the teeth of {first.name}"
    to = first.name if driven_by == 1.0 else "the crank"
    return check(
        "gears.train.speed_ratio", f"Speed ratio {last.name} to {to}, {ratio:+.6g}: off the wanted {wanted:+g} by",
        off if (off := abs(ratio - wanted)) > DUST else 0.0, "<=", SAME_RATIO, "",
        f"counter-rotating shaft: product of the tooth ratios {abs(wanted):g} and {parity} number of meshes",
        f"The teeth {teeth} give {ratio:+.6g} by {len(way) - 1} meshes: give {last.name} {enough} "
        f"and {parity} number of meshes from {first.name} to {last.name}.",
    )  # fmt: skip


# --- meshes ----------------------------------------------------------------------------------------------------------------
def _backlash(system: ToothSystem, id: str, place: str, mesh: MeshResult, driver: WheelResult, driven: WheelResult) -> Check:
    closest = mesh.centre_distance - mesh.centre_tolerance  # where the slope is least: what it asks for is enough
    touching = (driver.base_diameter + driven.base_diameter) / 2
    slope = 2 * math.sqrt(1 - (touching / closest) ** 2) * math.cos(system.base_helix_angle)
    return check(
        f"{id}.backlash", f"Smallest backlash {mesh.driver}–{mesh.driven} by its tolerances", mesh.backlash_min, ">=", 0.0, "µm",
        "teeth must not jam at any combination of the tolerances; without runout, all at 20 °C",
        freed((driver, driven), mesh.centre_tolerance, f"{place}.tolerance_um", -mesh.backlash_min, slope),
    )  # fmt: skip


def _contact(id: str, mesh: MeshResult) -> list[Check]:
    name, eps_alpha = f"Transverse contact ratio {mesh.driver}–{mesh.driven}", mesh.transverse_contact_ratio
    advice = "Cut less off the tips, give smaller profile shifts, or take more teeth of a smaller module."
    return [
        check(
            f"{id}.contact_ratio", name, eps_alpha, ">=", p.CONTACT_RATIO, "",
            f"{p.PRACTICE}: above 1 each pair hands over to the next, 0.1 for tolerances; the overlap of a helix is not counted", advice,
        ),
        check(f"{id}.contact_ratio_usual", f"{name}, usual", eps_alpha, ">=", p.USUAL_CONTACT_RATIO, "", p.PRACTICE, advice, kind="advice"),
        *_least(f"{id}.contact_ratio_least", f"{name}, shortest tips, widest centres", mesh.transverse_contact_ratio_min, 1.0, "", advice),
    ]  # fmt: skip


def _least(id: str, name: str, value: float | None, limit: float, unit: str, advice: str) -> list[Check]:
    """What must hold at the end of the tolerances too, where they are given."""
    return [] if value is None else [check(id, name, value, ">=", limit, unit, f"{ISO}: at the end of the tolerances", advice)]


def _clearance(system: ToothSystem, id: str, mesh: MeshResult, driver: WheelResult, driven: WheelResult) -> list[Check]:
    at_root = {mesh.driver: mesh.tip_clearance_driver, mesh.driven: mesh.tip_clearance_driven}
    low = min(at_root, key=at_root.__getitem__)
    usual = p.TIP_CLEARANCE * system.m_n
    missing = math.ceil(max(0.0, usual - at_root[low]) * 1e6 - 1e-6) / 1e3
    tips = " and ".join(_mate(mesh, name) for name, c in at_root.items() if c - at_root[low] < 1e-6)
    more = f"Cut the tip of {tips} by {missing:.3f} mm more, or take a tool with a larger addendum." if missing else "It holds."
    needed, enough = p.ABOVE_FILLET * system.m_n, p.USUAL_ABOVE_FILLET * system.m_n
    above = {driver.name: mesh.form_margin_driver, driven.name: mesh.form_margin_driven}
    tight = min(above, key=above.__getitem__)
    own, other = (driver, driven) if tight == driver.name else (driven, driver)
    free, free_usual = (_eased(mesh, own, other, reach) for reach in (needed, enough))
    clearance, start = (f"{what} {mesh.driver}–{mesh.driven}" for what in ("Tip clearance", "Start of contact above the fillet"))
    return [
        check(f"{id}.tip_clearance", clearance, at_root[low], ">=", usual, "mm", _modules(p.TIP_CLEARANCE), more, kind="advice"),
        check(f"{id}.interference", start, above[tight], ">=", needed, "mm", f"{ISO}: (d_Nf − d_Ff)/2", free),
        check(
            f"{id}.interference_usual", f"{start}, usual", above[tight], ">=", enough, "mm", _modules(p.USUAL_ABOVE_FILLET), free_usual,
            kind="advice",
        ),
        *_least(f"{id}.tip_clearance_least", f"{clearance}, longest tips and closest centres", mesh.tip_clearance_min, 0.0, "mm", more),
        *_least(f"{id}.interference_least", f"{start}, longest tips and closest centres", mesh.form_margin_min, needed, "mm", free),
    ]  # fmt: skip


def _eased(mesh: MeshResult, own: WheelResult, mate: WheelResult, enough: float) -> str:
    """How much of the mate's tip has to go, so that it arrives far enough above the fillet."""
    reach = own.form_diameter / 2 + enough
    rho = math.sqrt(max(reach**2 - (own.base_diameter / 2) ** 2, 0.0))
    left = math.hypot(mate.base_diameter / 2, max(mesh.line_of_action - rho, 0.0))
    cut = math.ceil((mate.tip_diameter / 2 - left) * 1e5 - 1e-6) / 1e2
    if cut <= 0:
        return "It holds."
    return (
        f"The tip of {mate.name} works low on {own.name}: cut {cut:g} mm more off it (gears.wheels.{mate.name}.tip_shortening_mm), as far "
        "as the contact ratio allows, take a tool with a larger addendum, or more teeth."
    )


def _modules(limit: Number) -> str:
    return f"{p.PRACTICE}: {limit:g} m_n"


def _mate(mesh: MeshResult, name: str) -> str:
    return mesh.driven if name == mesh.driver else mesh.driver


# --- wheels ----------------------------------------------------------------------------------------------------------------
def _tooth(system: ToothSystem, wheel: WheelResult) -> list[Check]:
    name, place = wheel.name, f"gears.wheels.{wheel.name}"
    s_an = wheel.tip_thickness_normal if wheel.tip_thickness_normal_min is None else wheel.tip_thickness_normal_min
    return [
        check(
            f"gears.{name}.undercut", f"Profile shift of {name} against undercut", wheel.profile_shift, ">=", wheel.undercut_limit, "", ISO,
            f"Give {place}.profile_shift at least {wheel.undercut_limit:.4f}, more teeth, or a tool with a smaller addendum.",
        ),
        check(
            f"gears.{name}.tip_thickness", f"Normal tip thickness of {name}", s_an, ">=", p.TIP_THICKNESS * system.m_n, "mm",
            _modules(p.TIP_THICKNESS),
            f"Cut the tip ({place}.tip_shortening_mm), or give a smaller {place}.profile_shift.",
        ),
        check(
            f"gears.{name}.tip_thickness_hardened", f"Tip thickness of {name}, if case-hardened", s_an, ">=",
            p.TIP_THICKNESS_HARDENED * system.m_n, "mm", f"{_modules(p.TIP_THICKNESS_HARDENED)} if case-hardened",
            "A thin tip hardens through: cut it, or give less shift.", kind="advice",
        ),
    ]  # fmt: skip


def _measures(system: ToothSystem, wheel: WheelResult) -> list[Check]:
    """Whether span and balls touch where they should."""
    id, name, flank = f"gears.{wheel.name}", wheel.name, (wheel.form_diameter, wheel.tip_diameter)
    balls = (_ball(system, wheel, wheel.form_diameter), _ball(system, wheel, wheel.tip_diameter))
    measured = wheel.measures
    assert measured is not None  # of every wheel, once the geometry is solved
    fits = wheel.preferred_ball if wheel.preferred_ball is not None else wheel.ideal_ball
    ball = f"Choose a ball of {fits * 1e3:.4g} mm (gears.ball_diameter_mm), or leave it out: each wheel then has its own."
    kind = "advice" if wheel.ball_diameter is fits else "limit"  # a ball that is given must fit
    found = [
        check(
            f"{id}.span_contact", f"Circle on which the span of {name} touches", measured.span_contact_diameter, "in", flank, "mm",
            f"{ISO}: the anvils must touch the involute", f"Choose another gears.wheels.{name}.span_teeth.", kind="advice",
        ),
        check(
            f"{id}.ball", f"Measuring ball of {name}", wheel.ball_diameter, "in", balls, "mm",
            "the ball must touch between form and tip circle", ball, kind=kind,
        ),
    ]  # fmt: skip
    if wheel.over_balls is not None:
        found.append(
            check(
                f"{id}.ball_proud", f"Balls of {name} above its tip", (wheel.over_balls - wheel.tip_diameter) / 2, ">", 0.0, "mm",
                "the balls must stand proud of the tip circle", ball, kind=kind,
            )
        )  # fmt: skip
    if measured.over_one_ball is not None:
        free = measured.over_one_ball - wheel.ball_diameter - wheel.root_diameter / 2
        found.append(
            check(
                f"{id}.ball_root",
                f"Ball of {name} above the root",
                free,
                ">=",
                0.0,
                "mm",
                "the ball must not lie on the root",
                ball,
                kind=kind,
            )
        )
    if system.beta:
        found.append(
            check(
                f"{id}.span_width", f"Face width of {name} for its span", wheel.face_width, ">=", measured.span_width, "mm",
                f"{ISO}: W·sin β_b, the width of the anvils apart", "Span fewer teeth, or measure over balls.", kind="advice",
            )
        )  # fmt: skip
    return found


def _ball(system: ToothSystem, wheel: WheelResult, d_y: float) -> float:
    """The ball that touches on a circle."""
    s_t = wheel.reference_thickness
    alpha_yt = math.acos(min(wheel.base_diameter / d_y, 1.0))
    alpha_t, beta_b = system.transverse_pressure_angle, system.base_helix_angle
    return m.ball_for_contact(s_t, wheel.pitch_diameter, alpha_t, wheel.teeth, wheel.base_diameter, beta_b, alpha_yt)
