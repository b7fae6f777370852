# SPDX-License-Identifier: Apache-2.0
"""What is judged on the outlines, and what has to be said of the tool that cuts them."""

from collections.abc import Mapping

from ...sheet.check import Check, check
from ...sheet.remedy import by_key
from ...sheet.text import Text
from ...sheet.units import Metre
from ..inputs import GearsInputs
from ..result import MeshResult, TrainResult
from .cut import Cut, finishing_step, protuberance_note
from .outline import CHORD_ERROR


def checks(train: TrainResult, depths: Mapping[str, Metre]) -> tuple[Check, ...]:
    """`depths`: how deep the outlines of each mesh enter each other, by `meshing.penetrations`."""
    checks = [penetration_check(key, mesh, depths[key]) for key, mesh in train.meshes.items()]
    if train.system.stock > 0:
        checks.append(finishing_check(train))
    return tuple(checks)


def penetration_check(key: str, mesh: MeshResult, depth: Metre) -> Check:
    """Whether a tip runs into a fillet or a root, whatever the formulas of form diameter and clearance say."""
    return check(
        f"gears.{key}.penetration", Text("Outlines of {driver} and {driven} inside each other, without backlash", driver=mesh.driver,
            driven=mesh.driven), depth, "<=",
        CHORD_ERROR, "µm", Text("rule of this program: no deeper than the outlines are exact"),
        Text("Cut the tips, or take a tool with a larger addendum, a smaller tip radius, or a protuberance that covers the stock."),
    )  # fmt: skip


def finishing_check(train: TrainResult) -> Check:
    """Whether the tool's protuberance covers the stock, so that finishing runs out into the fillet without a step."""
    s = train.system
    return check("gears.train.finishing_step", Text("Step that finishing leaves above the fillet"), finishing_step(s), "<=", 0.0, "µm",
        Text("rule of this program after the practice of gear handbooks, from memory: the protuberance at least as large as the stock"),
        Text("A step is a notch beside the root."),
        remedies=by_key(GearsInputs, "gears.protuberance_mm", float(f"{s.stock * 1e3:.4g}"), bound=">="))  # fmt: skip


def notes(train: TrainResult) -> tuple[Text, ...]:
    """What the protuberance must be like for each wheel's fillet to be as it is computed."""
    notes = ((name, protuberance_note(Cut(train.system, w.teeth, w.profile_shift))) for name, w in train.wheels.items())
    return tuple(Text("Wheel {name}: {note}.", name=name, note=note) for name, note in notes if note)
