# SPDX-License-Identifier: Apache-2.0
"""What a choice of shifts has to keep, all without unit: lengths in normal modules."""

from dataclasses import replace

from ...sheet.arrays import Array
from ...sheet.record import record
from ...sheet.search import Judged, judged, least
from ...sheet.text import Name, Text
from .. import practice as p
from ..formulas import ISO
from ..result import ToothSystem
from .states import States


@record
class Rule:
    """`hard`: the limit below which nothing is offered, even where the design itself stands below the usual `limit`."""

    key: str
    name: Text
    symbol: Text
    brief: Text
    limit: float
    hard: float
    source: Text
    advice: Text


UNDERCUT = Rule(
    "undercut", Text("Shift above undercut"), Name("x − x_min"), Text("undercut"), 0.0, 0.0, ISO,
    Text("take more teeth, or a smaller tool addendum"),
)  # fmt: skip
TIP = Rule(
    "tip_thickness", Text("Normal tip thickness"), Name("s_an/m_n"), Name("s_an"), p.TIP_THICKNESS, p.TIP_THICKNESS, p.PRACTICE,
    Text("cut the tips"),
)  # fmt: skip
HARDENED = replace(
    TIP, key="tip_thickness_hardened", name=Text("Normal tip thickness, case-hardened"), limit=p.TIP_THICKNESS_HARDENED,
    hard=p.TIP_THICKNESS_HARDENED,
)  # fmt: skip
CONTACT = Rule(
    "contact_ratio", Text("Transverse contact ratio"), Name("ε_α"), Name("ε_α"), p.USUAL_CONTACT_RATIO, p.CONTACT_RATIO, p.PRACTICE,
    Text("cut less off the tips, or take more teeth of a smaller module"),
)  # fmt: skip
FILLET = Rule(
    "above_fillet", Text("Start of contact above the fillet of the thinnest tooth"), Name("(d_N − d_Ff)/(2·m_n)"), Text("fillet"),
    p.USUAL_ABOVE_FILLET, p.ABOVE_FILLET, p.PRACTICE, Text("cut the tip of the mate"),
)  # fmt: skip
CLEARANCE = Rule(
    "tip_clearance", Text("Tip clearance"), Name("c/m_n"), Name("c"), p.USUAL_TIP_CLEARANCE, p.TIP_CLEARANCE,
    Text("rule of this program for choosing"), Text("cut the tip of the mate, or take a tool with a larger addendum"),
)  # fmt: skip
HARD_CASE = (UNDERCUT, HARDENED, CONTACT, FILLET, CLEARANCE)
USUAL = (UNDERCUT, TIP, CONTACT, FILLET, CLEARANCE)

Bar = tuple[Rule, Rule, Rule, Rule, Rule]  # for the shift, the tips, the contact ratio, the start of contact, the clearance


@record
class Place:
    """Where a rule is judged: `wheel` or `mesh` is empty where the rule knows none."""

    mesh: str
    wheel: str

    @property
    def name(self) -> str:
        return self.wheel or self.mesh.replace("_", "–")


def judge(found: States, system: ToothSystem, bar: Bar) -> list[Judged]:
    """Every rule at every wheel and mesh; arrays over the combinations."""
    undercut, tip, contact, fillet, clearance = bar
    m_n = system.m_n

    def by(rule: Rule, value: Array, mesh: str = "", wheel: str = "") -> Judged:
        return judged(rule, value, rule.limit, where=Place(mesh, wheel))

    return [
        *(by(undercut, x - found.undercut_limit[w], wheel=w) for w, x in found.shifts.items()),
        *(by(tip, s / m_n, wheel=w) for w, s in found.tip_thickness.items()),
        *(by(contact, eps, mesh) for mesh, eps in found.contact_ratio.items()),
        *(by(fillet, length / m_n, mesh, w) for (mesh, w), length in found.margin.items()),
        *(by(clearance, c / m_n, mesh, w) for (mesh, w), c in found.clearance.items()),
    ]


def eased(now: States, system: ToothSystem) -> Bar | None:
    """For a design that stands below a usual limit: no worse than it, nor below what is hard.  None where it keeps them all, or can not."""
    every = judge(now, system, USUAL)
    limits = {}
    for rule in USUAL:
        here = min(float(one.value[0]) for one in every if one.rule is rule)
        limits[rule.key] = max(rule.hard, min(rule.limit, here)) if here == here else rule.hard
    bar = tuple(replace(rule, limit=limits[rule.key]) if limits[rule.key] < rule.limit else rule for rule in USUAL)
    return None if bar == USUAL else (bar[0], bar[1], bar[2], bar[3], bar[4])


def keeps(found: States, system: ToothSystem, bar: Bar) -> Array:
    """The least margin of all rules, combination by combination."""
    return least(judge(found, system, bar))
