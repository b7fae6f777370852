# SPDX-License-Identifier: Apache-2.0
"""Whether the wheels reach each other in their places, have room there, and can be put together."""

from ...sheet.check import Check, check
from ...sheet.remedy import by_key
from ...sheet.text import Amount, Text, alternatives
from ...sheet.units import Metre, Number
from ..inputs import Mesh, Wheel
from ..result import MeshResult
from ..words import mm
from .room import Clearance

USUAL_CLEARANCE: Metre = 1e-3  # rule of this program
SWEPT = Text("geometry: tip circle with its upper deviation, half the runout and the tolerance of the axis, at rest and cold")
TWO_CIRCLES = Text("geometry: two circles about the fixed axes, with the working centre distances")


def reach_check(id: str, what: Text, first: str, second: str, c: Metre, low: Metre, high: Metre, tolerance: Metre) -> Check:
    """Of two placed axes `c` apart, which `what` can span from `low` to `high`."""
    limits = max(low - tolerance, 0.0), high + tolerance
    if c > limits[1]:
        do = Text("bring them at least {c} mm closer, or give larger centre distances or more teeth between them", c=mm(c - high))
    elif c < limits[0]:
        do = Text("set them at least {low} mm further apart, or make the centre distances more alike", low=mm(low - c))
    else:
        do = Text("near a limit small errors of the axes move the wheel between them far")
    advice = Text("{first} and {second} must stand {low} to {high} mm apart for {what} to reach both: {do}.", first=first, second=second,
        low=mm(low, digits=6), high=mm(high, digits=6), what=what, do=do)  # fmt: skip
    name = Text("Distance {first} to {second} that {what} spans", first=first, second=second, what=what)
    return check(id, name, c, "in", limits, "mm", TWO_CIRCLES, advice)


def axis_check(last: str, off: Metre, limit: Metre) -> Check:
    """`off`: between the given position of the last wheel and the axis of the counter-shaft."""
    return check(
        f"gears.{last}.axis", Text("Position of {last} from the axis of the counter-shaft", last=last), off, "<=", limit, "µm",
        Text("rule of this program: the last wheel stands on the counter-shaft, within 10⁻³ m_n"),
        remedies=by_key(Wheel, f"gears.wheels.{last}.position_mm", None, place=last, effect=Text("the axis of the counter-shaft gives it")),
    )  # fmt: skip


def distance_check(key: str, index: int, mesh: MeshResult, c: Metre, error: Metre, limit: Metre, given: list[str]) -> Check:
    """Of two axes that stand `c` apart; `given`: which of both wheels have a given position."""
    advice = Text("The axes stand {c} mm apart, the centre distance is {centre_distance} mm.", c=mm(c, ".4f"),
        centre_distance=mm(mesh.centre_distance, ".4f"))  # fmt: skip
    if given:
        advice += Text(" Or move {wrong}.", wrong=alternatives(given))
    return check(f"gears.{key}.position",
        Text("Axes of {driver} and {driven} off their centre distance", driver=mesh.driver, driven=mesh.driven), error, "<=", limit, "µm",
        Text("rule of this program: the tolerance of the centre distance, at least 10⁻³ m_n"), advice, index=index,
        remedies=by_key(Mesh, f"gears.meshes.{index}.centre_distance_mm", round(c * 1e3, 4), place=mesh.title))  # fmt: skip


def clearance_checks(wheel: str, free: dict[str, Clearance], order: list[str], chosen: bool) -> list[Check]:
    """Of the tightest place around a wheel.  Two wheels that come too near each other are judged once, at the later one."""
    own = [c for c in free.values() if c.kind != "wheel" or order.index(c.to) < order.index(wheel)]
    if not own:
        return []
    tight = min(own, key=lambda c: c.g)
    what = {"wall": Text("wall {to}", to=tight.to), "neighbour": tight.to, "wheel": Text("wheel {to}", to=tight.to)}[tight.kind]
    name, id = Text("Clearance of {wheel} to {what}", wheel=wheel, what=what), f"gears.{wheel}.clearance"
    move = Text("give {wheel} another place", wheel=wheel) if chosen else Text("move {wheel} or {what} apart", wheel=wheel, what=what)
    missing = Text(" by {g} mm", g=mm(-tight.g)) if tight.g < 0 else ""
    advice = Text("The tip circle needs more room: {move}{missing}, or give it fewer teeth or a smaller shift.", move=move, missing=missing)
    if chosen and tight.kind != "wheel":
        advice += Text(" `choose FILE gears` tries its teeth.")
    usual, rule = Text("{name}, usual", name=name), Text("rule of this program: 1 mm")
    return [
        check(id, name, tight.g, ">=", 0.0, "mm", SWEPT, advice),
        check(f"{id}_usual", usual, tight.g, ">=", USUAL_CLEARANCE, "mm", rule, advice),
    ]


def hunting_check(key: str, mesh: MeshResult, z_1: int, z_2: int, factor: Number, turns: Number) -> Check:
    """`factor`: common one of both numbers of teeth; `turns`: of the driver until the same teeth meet."""
    advice = Text("Numbers of teeth without a common factor spread the wear.")
    if factor > 1:
        advice = Text(
            "Every tooth of {driver} meets only {z_2} of the {z_22} teeth of {driven}, and one fault returns after {turns} turns of "
            "{driver}: numbers of teeth without a common factor spread the wear (the teeth of an idler do not change the ratio).",
            driver=mesh.driver, z_2=Amount(z_2 / factor, form="g"), z_22=z_2, driven=mesh.driven, turns=Amount(turns, form="g"),
        )  # fmt: skip
    name = Text("Common factor of the teeth {driver} {z_1}, {driven} {z_2}", driver=mesh.driver, z_1=z_1, driven=mesh.driven, z_2=z_2)
    source = Text("mathematics, hunting tooth: every tooth meets every tooth where the numbers have no common factor")
    return check(f"gears.{key}.hunting", name, factor, "<=", 1.0, "", source, advice)


def insertion_check(wheel: str, seat: Text, gap: Metre) -> Check:
    more = Text(", give that journal {gap} mm more", gap=mm(-gap, ".4g")) if gap < 0 else ""
    return check("gears.train.assembly", Text("Gap between {wheel} and the seat of the {seat} journal", wheel=wheel, seat=seat), gap, ">=",
        0.0, "mm", Text("geometry: the wheel passes through the seat of the journal where the shaft is inserted along its axis; diametral"),
        Text("Where {wheel} does not pass through the seat of the {seat} journal{more}, cut its tip, fix it after the shaft is inserted, "
            "or split the support.", wheel=wheel, seat=seat, more=more))  # fmt: skip
