# SPDX-License-Identifier: Apache-2.0
"""What is judged on the outlines, and what has to be said of the tool that cuts them."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ...sheet.check import Check, check
from ...sheet.units import Metre
from .cut import Cut, finishing_step, protuberance_note
from .outline import CHORD_ERROR

if TYPE_CHECKING:
    from ..result import MeshResult, TrainResult


def checks(train: "TrainResult", depths: Mapping[str, Metre]) -> tuple[Check, ...]:
    """`depths`: how deep the outlines of each mesh enter each other, by `meshing.penetrations`."""
    found = [penetration_check(key, mesh, depths[key]) for key, mesh in train.meshes.items()]
    if train.system.stock > 0:
        found.append(finishing_check(train))
    return tuple(found)


def penetration_check(key: str, mesh: "MeshResult", depth: Metre) -> Check:
    """Whether a tip runs into a fillet or a root, whatever the formulas of form diameter and clearance say."""
    return check(
        f"gears.{key}.penetration", f"Outlines of {mesh.driver} and {mesh.driven} inside each other, without backlash", depth, "<=",
        CHORD_ERROR, "µm", "rule of this program: no deeper than the outlines are exact",
        f"Cut the tips (gears.wheels.{mesh.driver}.tip_shortening_mm, gears.wheels.{mesh.driven}.tip_shortening_mm), or take a tool with "
        "a larger addendum, a smaller tip radius, or a protuberance that covers the stock.",
    )  # fmt: skip


def finishing_check(train: "TrainResult") -> Check:
    """Whether the tool's protuberance covers the stock, so that finishing runs out into the fillet without a step."""
    s = train.system
    return check(
        "gears.train.finishing_step", "Step that finishing leaves above the fillet", finishing_step(s), "<=", 0.0, "µm",
        "practice for shaved and ground wheels, as generally published: the protuberance at least as large as the stock",
        f"Give the tool a protuberance of at least {s.stock * 1e3:.4g} mm (gears.protuberance_mm): a step is a notch "
        "beside the root.", kind="advice",
    )  # fmt: skip


def notes(train: "TrainResult") -> tuple[str, ...]:
    """What the protuberance must be like for each wheel's fillet to be as it is computed."""
    said = ((name, protuberance_note(Cut(train.system, w.teeth, w.profile_shift))) for name, w in train.wheels.items())
    return tuple(f"Wheel {name}: {note}." for name, note in said if note)
