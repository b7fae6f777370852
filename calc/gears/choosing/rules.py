# SPDX-License-Identifier: Apache-2.0
"""What a choice of shifts has to keep, all without unit: lengths in normal modules."""

from dataclasses import replace
from typing import Any

import numpy as np

from ...sheet.arrays import Array
from ...sheet.record import record
from .. import practice as p
from ..formulas import ISO
from ..result import ToothSystem
from .states import States

OWN = "rule of this program for choosing"
DUST = 1e-9  # a margin that is negative by rounding only


@record
class Rule:
    """`hard`: the limit below which nothing is offered, even where the design itself stands below the usual `limit`."""

    key: str
    name: str
    symbol: str
    brief: str
    limit: float
    hard: float
    source: str
    advice: str


UNDERCUT = Rule("undercut", "Shift above undercut", "x − x_min", "undercut", 0.0, 0.0, ISO, "take more teeth, or a smaller tool addendum")
TIP = Rule("tip_thickness", "Normal tip thickness", "s_an/m_n", "s_an", p.TIP_THICKNESS, p.TIP_THICKNESS, p.PRACTICE, "cut the tips")
HARDENED = replace(
    TIP, key="tip_thickness_hardened", name="Normal tip thickness, case-hardened", limit=p.TIP_THICKNESS_HARDENED,
    hard=p.TIP_THICKNESS_HARDENED,
)  # fmt: skip
CONTACT = Rule(
    "contact_ratio", "Transverse contact ratio", "ε_α", "ε_α", p.USUAL_CONTACT_RATIO, p.CONTACT_RATIO, p.PRACTICE,
    "cut less off the tips, or take more teeth of a smaller module",
)  # fmt: skip
FILLET = Rule(
    "above_fillet", "Start of contact above the fillet of the thinnest tooth", "(d_N − d_Ff)/(2·m_n)", "fillet", p.USUAL_ABOVE_FILLET,
    p.ABOVE_FILLET, p.PRACTICE, "cut the tip of the mate",
)  # fmt: skip
CLEARANCE = Rule(
    "tip_clearance", "Tip clearance", "c/m_n", "c", 0.2, p.TIP_CLEARANCE, OWN,
    "cut the tip of the mate, or take a tool with a larger addendum",
)  # fmt: skip
HARD_CASE = (UNDERCUT, HARDENED, CONTACT, FILLET, CLEARANCE)
USUAL = (UNDERCUT, TIP, CONTACT, FILLET, CLEARANCE)

Bar = tuple[Rule, Rule, Rule, Rule, Rule]  # for the shift, the tips, the contact ratio, the start of contact, the clearance


@record
class Judged:
    """One rule at one place.  `wheel` or `mesh` is empty where the rule knows none.  `margin`: as of a check; no number: −∞."""

    rule: Rule
    mesh: str
    wheel: str
    value: Array
    margin: Array

    @property
    def place(self) -> str:
        return self.wheel or self.mesh.replace("_", "–")


def judged(found: States, system: ToothSystem, bar: Bar) -> list[Judged]:
    """Every rule at every wheel and mesh."""
    undercut, tip, contact, fillet, clearance = bar
    m_n = system.m_n
    made = [_judged(undercut, "", w, x - found.undercut_limit[w]) for w, x in found.shifts.items()]
    made += [_judged(tip, "", w, s / m_n) for w, s in found.tip_thickness.items()]
    made += [_judged(contact, mesh, "", eps) for mesh, eps in found.contact_ratio.items()]
    made += [_judged(fillet, mesh, w, length / m_n) for (mesh, w), length in found.margin.items()]
    made += [_judged(clearance, mesh, w, c / m_n) for (mesh, w), c in found.clearance.items()]
    return made


def eased(now: States, system: ToothSystem) -> Bar | None:
    """For a design that stands below a usual limit: no worse than it, nor below what is hard.  None where it keeps them all, or can not."""
    made = judged(now, system, USUAL)
    limits = {}
    for rule in USUAL:
        here = min(float(one.value[0]) for one in made if one.rule is rule)
        limits[rule.key] = max(rule.hard, min(rule.limit, here)) if here == here else rule.hard
    bar = tuple(replace(rule, limit=limits[rule.key]) if limits[rule.key] < rule.limit else rule for rule in USUAL)
    return None if bar == USUAL else (bar[0], bar[1], bar[2], bar[3], bar[4])


def _judged(rule: Rule, mesh: str, wheel: str, value: Any) -> Judged:
    margin = (value - rule.limit) / (abs(rule.limit) or 1.0)
    margin = np.where(np.isnan(margin), -np.inf, np.where(np.abs(margin) <= DUST, 0.0, margin))
    return Judged(rule, mesh, wheel, value, margin)


def least(made: list[Judged]) -> Array:
    """The least margin of all, element by element."""
    margin: Array = np.min(np.array([one.margin for one in made]), axis=0)
    return margin
