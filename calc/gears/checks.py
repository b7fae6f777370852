# SPDX-License-Identifier: Apache-2.0
"""What is judged on the gear train, and what to do where it fails."""

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import partial

from ..sheet.check import Check, CheckRule, Missing
from ..sheet.quantity import dotted
from ..sheet.remedy import Change, Remedy, by_key, change, remedy, up, up_um
from ..sheet.text import COMMA, Amount, Name, Text
from ..sheet.units import Metre, Number
from . import limits as p
from .formulas import ISO
from .inputs import GearsInputs, Mesh, Stage, wheel_key
from .measures.solve import contact_checks
from .result import MeshResult, ToothSystem, TrainResult, WheelResult
from .tree import TrainLink
from .wheel_inputs import Wheel

SAME_RATIO = 1e-9
DUST = 1e-12
AT_THE_END = Text("{iso}: at the end of the tolerances", iso=ISO)


def _modules(limit: Number) -> Text:
    return Text("{practice}: {limit} m_n", practice=p.PRACTICE, limit=Amount(limit, form="g"))


# --- what is known of each check

# the inputs that move a mesh and a wheel
DRIVER_CUT = dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.tip_shortening)
DRIVEN_CUT = dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.tip_shortening)
DRIVER_SHIFT = dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.profile_shift)
DRIVEN_SHIFT = dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.profile_shift)
DRIVER_TIP = dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.tip_diameter_tolerance)
DRIVEN_TIP = dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.tip_diameter_tolerance)
TOLERANCE = dotted("gears", GearsInputs.meshes, "#", Mesh.tolerance)
TOOL = dotted("gears", GearsInputs.tool_addendum)
CUT = dotted("gears", GearsInputs.wheels, "W", Wheel.tip_shortening)
SHIFT = dotted("gears", GearsInputs.wheels, "W", Wheel.profile_shift)

LONGER_CONTACT = Text(
    "Cut less off the tips, bring the wheels closer together, or take more teeth of a smaller module."
)
LARGER_TOOL = Text("A tool with a larger addendum helps as well.")
SPEED_RATIO = CheckRule(
    "gears.train.speed_ratio",
    "limit",
    "The shaft does not turn as it must to balance the engine.",
    sense="<=",
    role="self",
)
SHAFT_RATIO = CheckRule("gears.N.speed_ratio", "limit", SPEED_RATIO.why, sense="<=", role="self")  # of one of several
CONTACT_RATIO = CheckRule(
    "gears.M.contact_ratio",
    "limit",
    "Below 1 a pair leaves before the next one carries.",
    source=Text(
        "{practice}: above 1 each pair hands over to the next, 0.1 for tolerances; the overlap of a helix is not "
        "counted",
        practice=p.PRACTICE,
    ),
    advice=LONGER_CONTACT,
    role="physics",
    value_id=dotted("gears", "M", MeshResult.transverse_contact_ratio),
    moved_by=(DRIVER_CUT, DRIVEN_CUT, DRIVER_SHIFT, DRIVEN_SHIFT),
    short=Text("contact"),
)
CONTACT_RATIO_USUAL = CheckRule(
    "gears.M.contact_ratio_usual",
    "advice",
    "The usual range.",
    source=p.PRACTICE,
    advice=LONGER_CONTACT,
    cause=CONTACT_RATIO.id,
    value_id=CONTACT_RATIO.value_id,
    moved_by=CONTACT_RATIO.moved_by,
)
CONTACT_RATIO_LEAST = CheckRule(
    "gears.M.contact_ratio_least",
    "caution",
    "The ends of the tolerances hand over late, the wheels of the drawing do not.",
    source=AT_THE_END,
    advice=LONGER_CONTACT,
    cause=CONTACT_RATIO.id,
    value_id=dotted("gears", "M", MeshResult.transverse_contact_ratio_min),
    moved_by=(DRIVER_CUT, DRIVEN_CUT, DRIVER_TIP, DRIVEN_TIP, TOLERANCE),
)
TIP_CLEARANCE = CheckRule(
    "gears.M.tip_clearance",
    "advice",
    "The usual clearance; whether tip and root touch is judged by itself.",
    unit="mm",
    source=_modules(p.TIP_CLEARANCE),
    advice=LARGER_TOOL,
    moved_by=(DRIVER_CUT, DRIVEN_CUT, TOOL),
)
TIP_CLEARANCE_LEAST = CheckRule(
    "gears.M.tip_clearance_least",
    "limit",
    "At the ends of its tolerances, where the smallest backlash is judged as well, the tip jams in the root.",
    unit="mm",
    source=AT_THE_END,
    advice=LARGER_TOOL,
    role="physics",
    zero=p.QUARTER_MODULE,
    cause=TIP_CLEARANCE.id,
    value_id=dotted("gears", "M", MeshResult.tip_clearance_min),
    moved_by=(DRIVER_CUT, DRIVEN_CUT, TOOL, DRIVER_TIP, DRIVEN_TIP),
    short=Text("tip gap"),
)
INTERFERENCE = CheckRule(
    "gears.M.interference",
    "limit",
    "The tip works in the fillet of its mate: it jams or cuts.",
    unit="mm",
    source=Text("{iso}: (d_Nf − d_Ff)/2", iso=ISO),
    role="physics",
    zero=p.QUARTER_MODULE,
    moved_by=(DRIVEN_CUT, DRIVER_CUT, TOOL, dotted("gears", GearsInputs.tool_tip_radius)),
)
INTERFERENCE_USUAL = CheckRule(
    "gears.M.interference_usual",
    "advice",
    "The usual distance above the fillet.",
    unit="mm",
    source=_modules(p.USUAL_ABOVE_FILLET),
    zero=p.QUARTER_MODULE,
    cause=INTERFERENCE.id,
    moved_by=(DRIVEN_CUT, DRIVER_CUT, TOOL),
)
INTERFERENCE_LEAST = CheckRule(
    "gears.M.interference_least",
    "limit",
    "At the ends of its tolerances, where the smallest backlash is judged as well, the tip works in the fillet.",
    unit="mm",
    source=AT_THE_END,
    role="physics",
    zero=p.QUARTER_MODULE,
    cause=INTERFERENCE.id,
    value_id=dotted("gears", "M", MeshResult.form_margin_min),
    moved_by=(DRIVEN_CUT, DRIVER_CUT, TOOL, TOLERANCE),
)
UNDERCUT = CheckRule(
    "gears.W.undercut",
    "limit",
    "The tool cuts the root of the teeth away.",
    source=ISO,
    advice=Text("More teeth, or a tool with a smaller addendum, help as well."),
    role="physics",
    zero="a shift of 0.25",
    value_id=dotted("gears", "W", WheelResult.profile_shift),
    limit_id=dotted("gears", "W", WheelResult.undercut_limit),
    moved_by=(SHIFT, dotted("gears", GearsInputs.wheels, "W", Wheel.teeth), TOOL),
)
TIP_THICKNESS = CheckRule(
    "gears.W.tip_thickness",
    "limit",
    "The tip breaks off.",
    unit="mm",
    source=_modules(p.TIP_THICKNESS),
    advice=Text("Cut the tip, or give a smaller profile shift."),
    role="physics",
    value_id=dotted("gears", "W", WheelResult.tip_thickness_normal_min),
    moved_by=(CUT, SHIFT),
)
TIP_THICKNESS_HARDENED = CheckRule(
    "gears.W.tip_thickness_hardened",
    "advice",
    "It holds for case-hardened teeth only, and the program does not know whether the tip is.",
    unit="mm",
    source=Text("{modules} if case-hardened", modules=_modules(p.TIP_THICKNESS_HARDENED)),
    advice=Text("A thin tip hardens through: cut it, or give less shift."),
    cause=TIP_THICKNESS.id,
    value_id=TIP_THICKNESS.value_id,
    moved_by=TIP_THICKNESS.moved_by,
)


def checks(gears: GearsInputs, train: TrainResult) -> Iterator[Check]:
    cuts = {wheel.name: wheel.tip_shortening for wheel in gears.wheels}
    for i, (given, mesh) in enumerate(zip(gears.meshes, train.meshes.values())):
        pair = train.wheels[mesh.driver], train.wheels[mesh.driven]
        yield from _contact_checks(given.key, i, mesh)
        yield from _clearance_checks(train.system, given.key, i, mesh, cuts, *pair)
    for wheel in train.wheels.values():
        yield from _tooth_checks(train.system, wheel)
        assert wheel.measures is not None  # of every wheel, once the geometry is solved
        yield from contact_checks(train.system, wheel, wheel.measures)


# --- the train


def speed_ratio_check(train: TrainResult, shaft: str, wanted: Number, crank: float | None = None) -> Check:
    """Whether the wheel of a shaft turns as the shaft must: its speed over that of the first driver, as far as it is
    off the wanted one."""
    turn, tree = train.shafts[shaft], train.tree
    way, last = tree.way(turn.wheel), turn.wheel
    # of the crank's speed; a first driver that is no wheel is a sprocket on the crank
    driven_by = abs(train.wheels[tree.first].speed) / crank if crank and tree.first in train.wheels else 1.0
    ratio, parity = turn.speed_ratio * driven_by, Text("an odd") if wanted < 0 else Text("an even")
    first = way[0].z_1
    needed = first * driven_by / abs(wanted)
    enough = Text("{needed} teeth", needed=Amount(needed, form="g"))
    if needed != round(needed):
        times = Amount(driven_by / abs(wanted), form="g")
        enough = Text("{driven_by} times the teeth of {name}", driven_by=times, name=tree.first)
    to = tree.first if driven_by == 1.0 else Text("the crank")
    off, shown = abs(ratio - wanted), Amount(ratio, form="+.6g")
    name = Text(
        "Speed ratio {name} to {to}, {ratio}: off the wanted {wanted} by",
        name=last,
        to=to,
        ratio=shown,
        wanted=Amount(wanted, form="+g"),
    )
    source = Text(
        "kinematics, counter-rotating shaft: product of the tooth ratios {wanted} and {parity} number of meshes",
        wanted=Amount(abs(wanted), form="g"),
        parity=parity,
    )
    if all(link.toothed for link in way):
        teeth = " → ".join([f"{tree.first} {first}", *(f"{link.driven} {link.z_2}" for link in way)])
        advice = Text(
            "The teeth {teeth} give {ratio} by {count} meshes: give {name} {enough} and {parity} number of meshes "
            "from {name2} to {name}.",
            teeth=teeth,
            ratio=shown,
            count=len(way),
            name=last,
            enough=enough,
            parity=parity,
            name2=tree.first,
        )
    else:
        advice = Text(
            "The teeth {teeth} give {ratio}: the product of the ratios must be {wanted}, and {parity} number of meshes "
            "and of chains that run on their outer side must lie between {name2} and {name}.",
            teeth=COMMA.join(Text("{title} {z_1}:{z_2}", title=x.title, z_1=x.z_1, z_2=x.z_2) for x in way),
            ratio=shown,
            wanted=Amount(abs(wanted), form="g"),
            parity=parity,
            name2=tree.first,
            name=last,
        )
    off = off if off > DUST else 0.0
    rule, at = (SHAFT_RATIO, (shaft,)) if len(train.shafts) > 1 else (SPEED_RATIO, ())
    keys = tuple(_teeth_of(way))
    return rule(off, SAME_RATIO, at=at, name=name, source=source, advice=advice, moved_by=keys)


def no_wheel_check(train: TrainResult, shaft: str, wanted: Number, crank: float | None = None) -> Check:
    """Of a shaft that no wheel of the train carries, with the wheel that would turn it as it must."""
    lack = Missing((dotted("gears", GearsInputs.wheels),), (), "none", "none")
    name = Text("Speed ratio of {shaft}: no wheel of the train carries it", shaft=Name(shaft))
    advice = Text('Give its wheel: shaft = "{shaft}" under the name of a wheel.', shaft=Name(shaft))
    speed = wanted * (crank or train.speeds[train.tree.first])
    for driver in train.wheels.values():
        teeth = driver.teeth * abs(driver.speed / speed)
        if driver.speed * speed < 0 and abs(teeth - round(teeth)) < SAME_RATIO:
            advice = Text(
                'Add a wheel and its mesh: name = "{shaft}", teeth = {teeth}, shaft = "{shaft}" under '
                '[[gears.wheels]], and driver = "{driver}", driven = "{shaft}" under [[gears.meshes]].',
                shaft=Name(shaft),
                teeth=round(teeth),
                driver=Name(driver.name),
            )
            break
    source = Text("definition: without a wheel nothing turns the shaft")
    return SHAFT_RATIO(None, SAME_RATIO, at=(shaft,), name=name, source=source, advice=advice, missing=lack)


def _teeth_of(way: Sequence[TrainLink]) -> Iterator[str]:
    """The keys of the numbers of teeth on a way, the last first."""
    for link in reversed(way):
        if link.toothed:
            yield wheel_key(link.driven, Wheel.teeth)
        else:
            yield dotted("gears", GearsInputs.stages, link.key, Stage.driven_teeth)
            yield dotted("gears", GearsInputs.stages, link.key, Stage.driver_teeth)
    if way[0].toothed:
        yield wheel_key(way[0].driver, Wheel.teeth)


# --- meshes


def _contact_checks(key: str, index: int, mesh: MeshResult) -> Iterator[Check]:
    name, eps_alpha = Text("Transverse contact ratio {pair}", pair=mesh.title), mesh.transverse_contact_ratio
    usual = Text("{name}, usual", name=name)
    yield CONTACT_RATIO(eps_alpha, p.CONTACT_RATIO, at=key, name=name)
    yield CONTACT_RATIO_USUAL(eps_alpha, p.USUAL_CONTACT_RATIO, at=key, name=usual)
    if (eps_min := mesh.transverse_contact_ratio_min) is not None:
        least = Text("{name}, shortest tips, widest centres", name=name)
        yield CONTACT_RATIO_LEAST(eps_min, 1.0, at=key, name=least, index=index)


def _clearance_checks(
    system: ToothSystem,
    key: str,
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
    quarter = p.QUARTER * system.m_n
    missing = up_um(usual - at_root[low]) / 1e3
    tips = [mesh.driven if side == "driver" else mesh.driver for side, c in at_root.items() if c - at_root[low] < 1e-6]

    def shorter() -> tuple[Remedy, ...]:
        return (remedy(*(_cut(tip, cuts, missing) for tip in tips)),) if missing > 0 else ()

    clearance = Text("Tip clearance {pair}", pair=mesh.title)
    start = Text("Start of contact above the fillet {pair}", pair=mesh.title)
    works_low = Text(
        "The tip of {mate} works low on {wheel}: cut it as far as the contact ratio allows; a tool with a larger "
        "addendum or more teeth help as well.",
        mate=mate.name,
        wheel=wheel.name,
    )
    gap_id, form_id = f"gears.{key}.tip_clearance_{low}", f"gears.{key}.form_margin_{tight}"
    yield TIP_CLEARANCE(at_root[low], usual, at=key, name=clearance, value_id=gap_id, remedies=shorter)
    for rule, name, limit in (
        (INTERFERENCE, start, needed),
        (INTERFERENCE_USUAL, Text("{start}, usual", start=start), enough),
    ):
        yield rule(
            above[tight],
            limit,
            at=key,
            name=name,
            advice=works_low,
            scale=quarter,
            value_id=form_id,
            remedies=partial(_eased, mesh, wheel, mate, cuts, limit),
        )
    if mesh.tip_clearance_min is not None:
        name = Text("{clearance}, longest tips and closest centres", clearance=clearance)
        yield TIP_CLEARANCE_LEAST(
            mesh.tip_clearance_min, 0.0, at=key, name=name, scale=quarter, index=index, remedies=shorter
        )
    if mesh.form_margin_min is not None:
        yield INTERFERENCE_LEAST(
            mesh.form_margin_min,
            needed,
            at=key,
            name=Text("{start}, longest tips and closest centres", start=start),
            advice=works_low,
            scale=quarter,
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
    cut = up(mate.tip_diameter / 2 - left)
    return (remedy(_cut(mate.name, cuts, cut)),) if cut > 0 else ()


def _cut(wheel: str, cuts: Mapping[str, Metre], more: float) -> Change:
    """`more` off its tip, in mm, beside what is cut already."""
    deeper, key = round(cuts[wheel] * 1e3 + more, 6), wheel_key(wheel, Wheel.tip_shortening)
    return change(Wheel, key, deeper, place=wheel, bound=">=")


# --- wheels


def _tooth_checks(system: ToothSystem, wheel: WheelResult) -> Iterator[Check]:
    name = wheel.name
    s_an, value_id = wheel.tip_thickness_normal, dotted("gears", name, WheelResult.tip_thickness_normal)
    if wheel.tip_thickness_normal_min is not None:
        s_an, value_id = wheel.tip_thickness_normal_min, f"{value_id}_min"
    enough = math.ceil(wheel.undercut_limit * 1e4) / 1e4
    yield UNDERCUT(
        wheel.profile_shift,
        wheel.undercut_limit,
        at=name,
        name=Text("Profile shift of {name} against undercut", name=name),
        scale=p.QUARTER,
        remedies=by_key(Wheel, wheel_key(name, Wheel.profile_shift), enough, place=name, bound=">="),
    )
    label = Text("Normal tip thickness of {name}", name=name)
    yield TIP_THICKNESS(s_an, p.TIP_THICKNESS * system.m_n, at=name, name=label, value_id=value_id)
    label, limit = Text("Tip thickness of {name}, if case-hardened", name=name), p.TIP_THICKNESS_HARDENED * system.m_n
    yield TIP_THICKNESS_HARDENED(s_an, limit, at=name, name=label, value_id=value_id)
