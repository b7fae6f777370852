# SPDX-License-Identifier: Apache-2.0
"""What is judged on the gear train, and what to do where it fails."""

import math
from collections.abc import Iterator, Mapping
from functools import partial

from ..sheet.check import Check
from ..sheet.quantity import dotted
from ..sheet.remedy import Change, Remedy, by_key, change, remedy
from ..sheet.shim_check import check
from ..sheet.text import Amount, Text
from ..sheet.units import Metre, Number
from . import limits as p
from .backlash.case import way_to
from .formulas import ISO
from .inputs import GearsInputs, wheel_key
from .measures.solve import contact_checks
from .result import MeshResult, ToothSystem, TrainResult, WheelResult
from .wheel_inputs import Wheel

SAME_RATIO = 1e-9
DUST = 1e-12
AT_THE_END = Text("{iso}: at the end of the tolerances", iso=ISO)


def checks(gears: GearsInputs, train: TrainResult) -> Iterator[Check]:
    cuts = {wheel.name: wheel.tip_shortening for wheel in gears.wheels}
    for i, (given, mesh) in enumerate(zip(gears.meshes, train.meshes.values())):
        pair = train.wheels[mesh.driver], train.wheels[mesh.driven]
        yield from _contact_checks(f"gears.{given.key}", i, mesh)
        yield from _clearance_checks(train.system, f"gears.{given.key}", i, mesh, cuts, *pair)
    for wheel in train.wheels.values():
        yield from _tooth_checks(train.system, wheel)
        assert wheel.measures is not None  # of every wheel, once the geometry is solved
        yield from contact_checks(train.system, wheel, wheel.measures)


# --- the train


def speed_ratio_check(train: TrainResult, wanted: Number, crank: float | None = None) -> Check:
    """Whether the last wheel turns as the shaft must: its speed over that of the first driver, as far as it is off the
    wanted one."""
    along = list(train.meshes.values())
    first, last = train.wheels[along[0].driver], train.wheels[along[-1].driven]
    way = [*(train.wheels[train.meshes[key].driver] for key in way_to(last.name, train.meshes)), last]
    driven_by = abs(first.speed) / crank if crank else 1.0  # of the crank's speed
    ratio, parity = train.speed_ratio * driven_by, Text("an odd") if wanted < 0 else Text("an even")
    teeth, needed = " → ".join(f"{wheel.name} {wheel.teeth}" for wheel in way), first.teeth * driven_by / abs(wanted)
    enough = Text("{needed} teeth", needed=Amount(needed, form="g"))
    if needed != round(needed):
        times = Amount(driven_by / abs(wanted), form="g")
        enough = Text("{driven_by} times the teeth of {name}", driven_by=times, name=first.name)
    to = first.name if driven_by == 1.0 else Text("the crank")
    keys = tuple(wheel_key(wheel.name, Wheel.teeth) for wheel in reversed(way))
    off, shown = abs(ratio - wanted), Amount(ratio, form="+.6g")
    name = Text(
        "Speed ratio {name} to {to}, {ratio}: off the wanted {wanted} by",
        name=last.name,
        to=to,
        ratio=shown,
        wanted=Amount(wanted, form="+g"),
    )
    source = Text(
        "kinematics, counter-rotating shaft: product of the tooth ratios {wanted} and {parity} number of meshes",
        wanted=Amount(abs(wanted), form="g"),
        parity=parity,
    )
    advice = Text(
        "The teeth {teeth} give {ratio} by {count} meshes: give {name} {enough} and {parity} number of meshes "
        "from {name2} to {name}.",
        teeth=teeth,
        ratio=shown,
        count=len(way) - 1,
        name=last.name,
        enough=enough,
        parity=parity,
        name2=first.name,
    )
    return check(
        "gears.train.speed_ratio", name, off if off > DUST else 0.0, "<=", SAME_RATIO, "", source, advice, moved_by=keys
    )


# --- meshes


def _contact_checks(id: str, index: int, mesh: MeshResult) -> Iterator[Check]:
    name, eps_alpha = Text("Transverse contact ratio {pair}", pair=mesh.title), mesh.transverse_contact_ratio
    usual = Text("{name}, usual", name=name)
    advice = Text("Cut less off the tips, bring the wheels closer together, or take more teeth of a smaller module.")
    source = Text(
        "{practice}: above 1 each pair hands over to the next, 0.1 for tolerances; the overlap of a helix is not "
        "counted",
        practice=p.PRACTICE,
    )
    yield check(f"{id}.contact_ratio", name, eps_alpha, ">=", p.CONTACT_RATIO, "", source, advice)
    yield check(f"{id}.contact_ratio_usual", usual, eps_alpha, ">=", p.USUAL_CONTACT_RATIO, "", p.PRACTICE, advice)
    if (eps_min := mesh.transverse_contact_ratio_min) is not None:
        least = Text("{name}, shortest tips, widest centres", name=name)
        yield check(f"{id}.contact_ratio_least", least, eps_min, ">=", 1.0, "", AT_THE_END, advice, index=index)


def _clearance_checks(
    system: ToothSystem,
    id: str,
    index: int,
    mesh: MeshResult,
    cuts: Mapping[str, Metre],
    driver: WheelResult,
    driven: WheelResult,
) -> Iterator[Check]:
    """Tip clearance and start of contact of the tighter wheel, and of the pair at the end of the tolerances where they
    are given."""
    at_root = {"driver": mesh.tip_clearance_driver, "driven": mesh.tip_clearance_driven}
    above = {"driver": mesh.form_margin_driver, "driven": mesh.form_margin_driven}
    low, tight = min(at_root, key=at_root.__getitem__), min(above, key=above.__getitem__)
    wheel, mate = (driver, driven) if tight == "driver" else (driven, driver)
    usual, needed, enough = (share * system.m_n for share in (p.TIP_CLEARANCE, p.ABOVE_FILLET, p.USUAL_ABOVE_FILLET))
    missing = math.ceil(max(0.0, usual - at_root[low]) * 1e6 - 1e-6) / 1e3
    tips = [mesh.driven if side == "driver" else mesh.driver for side, c in at_root.items() if c - at_root[low] < 1e-6]

    def shorter() -> tuple[Remedy, ...]:
        return (remedy(*(_cut(tip, cuts, missing) for tip in tips)),) if missing else ()

    clearance = Text("Tip clearance {pair}", pair=mesh.title)
    start = Text("Start of contact above the fillet {pair}", pair=mesh.title)
    tool = Text("A tool with a larger addendum helps as well.")
    works_low = Text(
        "The tip of {mate} works low on {wheel}: cut it as far as the contact ratio allows; a tool with a larger "
        "addendum or more teeth help as well.",
        mate=mate.name,
        wheel=wheel.name,
    )
    yield check(
        f"{id}.tip_clearance",
        clearance,
        at_root[low],
        ">=",
        usual,
        "mm",
        _modules(p.TIP_CLEARANCE),
        tool,
        value_id=f"{id}.tip_clearance_{low}",
        remedies=shorter,
    )
    for suffix, label, limit, source in (
        ("", start, needed, Text("{iso}: (d_Nf − d_Ff)/2", iso=ISO)),
        ("_usual", Text("{start}, usual", start=start), enough, _modules(p.USUAL_ABOVE_FILLET)),
    ):
        yield check(
            f"{id}.interference{suffix}",
            label,
            above[tight],
            ">=",
            limit,
            "mm",
            source,
            works_low,
            value_id=f"{id}.form_margin_{tight}",
            remedies=partial(_eased, mesh, wheel, mate, cuts, limit),
        )
    if mesh.tip_clearance_min is not None:
        yield check(
            f"{id}.tip_clearance_least",
            Text("{clearance}, longest tips and closest centres", clearance=clearance),
            mesh.tip_clearance_min,
            ">=",
            0.0,
            "mm",
            AT_THE_END,
            tool,
            index=index,
            remedies=shorter,
        )
    if mesh.form_margin_min is not None:
        yield check(
            f"{id}.interference_least",
            Text("{start}, longest tips and closest centres", start=start),
            mesh.form_margin_min,
            ">=",
            needed,
            "mm",
            AT_THE_END,
            works_low,
            index=index,
            remedies=partial(_eased, mesh, wheel, mate, cuts, needed),
        )


def _eased(
    mesh: MeshResult, wheel: WheelResult, mate: WheelResult, cuts: Mapping[str, Metre], enough: float
) -> tuple[Remedy, ...]:
    """How much of the mate's tip has to go, so that it arrives far enough above the fillet."""
    reach = wheel.form_diameter / 2 + enough
    rho = math.sqrt(max(reach**2 - (wheel.base_diameter / 2) ** 2, 0.0))
    left = math.hypot(mate.base_diameter / 2, max(mesh.line_of_action - rho, 0.0))
    cut = math.ceil((mate.tip_diameter / 2 - left) * 1e5 - 1e-6) / 1e2
    return (remedy(_cut(mate.name, cuts, cut)),) if cut > 0 else ()


def _cut(wheel: str, cuts: Mapping[str, Metre], more: float) -> Change:
    """`more` off its tip, in mm, beside what is cut already."""
    deeper, key = round(cuts[wheel] * 1e3 + more, 6), wheel_key(wheel, Wheel.tip_shortening)
    return change(Wheel, key, deeper, place=wheel, bound=">=")


def _modules(limit: Number) -> Text:
    return Text("{practice}: {limit} m_n", practice=p.PRACTICE, limit=Amount(limit, form="g"))


# --- wheels


def _tooth_checks(system: ToothSystem, wheel: WheelResult) -> Iterator[Check]:
    name = wheel.name
    s_an, value_id = wheel.tip_thickness_normal, dotted("gears", name, WheelResult.tip_thickness_normal)
    if wheel.tip_thickness_normal_min is not None:
        s_an, value_id = wheel.tip_thickness_normal_min, f"{value_id}_min"
    enough = math.ceil(wheel.undercut_limit * 1e4 - 1e-9) / 1e4
    yield check(
        f"gears.{name}.undercut",
        Text("Profile shift of {name} against undercut", name=name),
        wheel.profile_shift,
        ">=",
        wheel.undercut_limit,
        "",
        ISO,
        Text("More teeth, or a tool with a smaller addendum, help as well."),
        remedies=by_key(Wheel, wheel_key(name, Wheel.profile_shift), enough, place=name, bound=">="),
    )
    label, least = Text("Normal tip thickness of {name}", name=name), p.TIP_THICKNESS
    source, limit = _modules(least), least * system.m_n
    advice = Text("Cut the tip, or give a smaller profile shift.")
    yield check(f"gears.{name}.tip_thickness", label, s_an, ">=", limit, "mm", source, advice, value_id=value_id)
    label, least = Text("Tip thickness of {name}, if case-hardened", name=name), p.TIP_THICKNESS_HARDENED
    source, limit = Text("{modules} if case-hardened", modules=_modules(least)), least * system.m_n
    advice = Text("A thin tip hardens through: cut it, or give less shift.")
    yield check(
        f"gears.{name}.tip_thickness_hardened", label, s_an, ">=", limit, "mm", source, advice, value_id=value_id
    )
