# SPDX-License-Identifier: Apache-2.0
"""Whether the outlines of two wheels enter each other when they roll, and what is judged on the outlines.

Only drawn teeth can tell: tips, fillets and roots too.

Points of a flank of each wheel are carried past the other, through every position in which they lie inside its tip
circle.  Their angle there is compared with that of the tooth at the same radius.  A point on the involute side stands
off it by r_b times the angle that is missing, which is exact; one inside a fillet by its distance to that.  Teeth are
alike and their flanks mirrored, so one flank past all teeth is the whole mesh."""

import math
from collections.abc import Iterator, Mapping
from functools import cached_property

import numpy as np

from ...sheet.arrays import Array
from ...sheet.check import Check, CheckRule
from ...sheet.formula import formula
from ...sheet.quantity import dotted
from ...sheet.record import record
from ...sheet.remedy import by_key
from ...sheet.text import Text
from ...sheet.units import Metre, Number
from ...sheet.value import about, based_on, untraced
from ..backlash.formulas import circumferential_backlash
from ..inputs import GearsInputs
from ..result import MeshResult, ToothSystem, TrainResult, WheelResult
from ..wheel_inputs import Wheel
from .cut import ROOT, Cut, finishing_step, protuberance_note
from .outline import CHORD_ERROR

FILLET, FLANK = 129, 12  # places of the fillet's table, and points of the flank that are carried past the mate
CORNER, ROLL = 181, 21  # positions in which the tip's corner is looked at, and the other points
DUST: Metre = 1e-12  # below it a distance is of the last digits


@record
class Flank:
    """One wheel as its mate feels it."""

    cut: Cut
    tip_radius: Metre

    @cached_property
    def fillet(self) -> tuple[Array, Array]:
        """Radius and angle from root to form circle."""
        return self.cut.fillet(np.linspace(ROOT, self.cut.end_of_fillet, FILLET))

    @cached_property
    def points(self) -> tuple[Array, Array]:
        """Points of the flank, radius and angle: of the involute evenly along the line of action, the tip's corner
        first."""
        base, form = self.cut.base_radius, float(self.fillet[0][-1])
        rho = np.linspace(math.sqrt(self.tip_radius**2 - base**2), math.sqrt(max(form**2 - base**2, 0.0)), FLANK)
        radius = np.hypot(base, rho)
        return radius, self.cut.involute(radius)

    def tooth_angle(self, radius: Array) -> Array:
        """Half the tooth at a radius."""
        r, angle = self.fillet
        return np.where(radius >= r[-1], self.cut.involute(radius), np.interp(radius, r, angle))


def flank(system: ToothSystem, wheel: WheelResult, shift: Number | None = None) -> Flank:
    """`shift`: another one than that without allowance.  A pointed tooth ends where its flanks meet."""
    cut = Cut(system, wheel.teeth, wheel.profile_shift if shift is None else shift)
    pointed = wheel.pointed_diameter / 2 if shift is None else cut.base_radius / math.cos(cut.pointed_angle)
    return Flank(cut, based_on(min(wheel.tip_diameter / 2, pointed), wheel.tip_diameter, wheel.pointed_diameter))


def _seen(a_w: Metre, flank: Flank, mate: Flank, carried: Array, share: Array, turn: float) -> tuple[Array, ...]:
    """Points of the mate as the wheel sees them: radius, angle from its nearest tooth, and how far inside that they
    are, along the circle.

    `carried`: which of the mate's points; `share`: where each stands, −1 to 1 of the way that it has inside the wheel's
    tip circle. The mate's tooth stands at β from the line of centres; at β = 0 a space of the wheel stands there,
    turned by `turn`."""
    radius, theta = mate.points
    reach = np.arccos(np.minimum((a_w**2 + radius**2 - flank.tip_radius**2) / (2 * a_w * radius), 1.0))
    r, place = radius[carried], reach[carried] * share  # of the point, from the line of centres
    X, Y = a_w - r * np.cos(place), -r * np.sin(place)
    pitch = 2 * math.pi / flank.cut.teeth
    space = turn - (place - theta[carried]) * (mate.cut.teeth / flank.cut.teeth)
    off, radius = np.arctan2(Y, X) - space, np.hypot(X, Y)
    angle = pitch / 2 - np.abs(off - pitch * np.rint(off / pitch))
    return radius, angle, (flank.tooth_angle(radius) - angle) * radius


def _places(corner: int, flank: int) -> tuple[Array, Array]:
    """Point and share of its way: the tip's corner in many positions, every point in some."""
    carried = np.concatenate([np.zeros(corner, int), np.repeat(np.arange(FLANK), flank)])
    return carried, np.concatenate([np.linspace(-1.0, 1.0, corner), np.tile(np.linspace(-1.0, 1.0, flank), FLANK)])


PLACES = _places(CORNER, ROLL)
BESIDE = 4 / (CORNER - 1)  # the share of two positions


@formula(
    "δ_p",
    "rule of this program: points of both flanks carried past the other wheel without backlash, through every position",
    unit="µm",
    shows="largest depth of a point of one outline inside the other, over a whole engagement",
)
def penetration(a_w: Metre, driver: Flank, driven: Flank, j_wt: Metre = 0.0) -> Metre:
    """In the transverse plane; 0 where the outlines only touch.  `j_wt`: backlash of these outlines, one flank of which
    is in contact: that which is carried past the other wheel."""
    pairs, a_t = ((driver, driven), (driven, driver)), a_w / (driver.cut.teeth + driven.cut.teeth)
    return max(_deepest(a_w, wheel, mate, j_wt / 2 / (a_t * wheel.cut.teeth)) for wheel, mate in pairs)


def _deepest(a_w: Metre, flank: Flank, mate: Flank, turn: float) -> Metre:
    """How deep points of the mate lie inside the wheel: its tip's corner in many positions, the flank in fewer.

    A corner passes a fillet in a loop as narrow as that: where it comes closest to one it is looked at once more.
    """
    radius, _, deep = seen = _seen(a_w, flank, mate, *PLACES, turn)
    radii = flank.fillet[0]
    near = np.where((radius < radii.max()) | (deep > DUST), deep, -np.inf)[:CORNER]
    at = PLACES[1][int(np.argmax(near))]
    closer = np.linspace(at - BESIDE, at + BESIDE, 41)
    more = _seen(a_w, flank, mate, np.zeros(closer.size, int), closer, turn)
    radius, angle, deep = (np.concatenate(both) for both in zip(seen, more))
    inside = (radius < flank.tip_radius) & ((deep > DUST) | (radius < radii.min() - DUST))
    return _depth(flank, radius[inside], angle[inside], deep[inside]) if inside.any() else 0.0


def _depth(flank: Flank, radius: Array, angle: Array, deep: Array) -> Metre:
    """The deepest of points inside a tooth: the way out is over the flank, the tip, the fillet or the root arc."""
    r, theta = flank.fillet
    over_flank = np.minimum(deep / radius * flank.cut.base_radius, flank.tip_radius - radius)
    to_fillet = _distances(radius * np.exp(1j * angle), r * np.exp(1j * theta))
    to_root = np.where(angle >= theta.max(), np.abs(radius - r.min()), np.inf)
    depth = np.where(radius >= r.max(), over_flank, np.minimum(to_fillet, to_root))
    return float(depth.max())


def _distances(points: Array, line: Array) -> Array:
    """From each point to a polyline."""
    start, way = line[:-1], np.diff(line)
    gap = points[:, None] - start
    along = np.clip((gap / way).real, 0.0, 1.0)
    nearest: Array = np.abs(gap - along * way).min(axis=1)
    return nearest


def penetrations(train: TrainResult) -> dict[str, Metre]:
    """Of every mesh of a train, by its key."""
    flanks = {name: flank(train.system, wheel) for name, wheel in train.wheels.items()}
    depths = {}
    for key, m in train.meshes.items():
        with about(Text("mesh {pair}", pair=m.title)):
            pair, z_1 = (m.centre_distance, flanks[m.driver], flanks[m.driven]), train.wheels[m.driver].teeth
            sizes = m.working_diameter_driver, z_1, m.working_thickness_driver, m.working_thickness_driven
            with untraced():
                # before allowances: the shifts were given with the centre distance
                loose = circumferential_backlash(*sizes) > DUST
            depths[key] = penetration(*pair, circumferential_backlash(*sizes)) if loose else penetration(*pair)
    return depths


# --- what is judged on the outlines, and what has to be said of the tool that cuts them


PENETRATION = CheckRule(
    "gears.M.penetration",
    "limit",
    "The outlines as they are cut run into each other: it jams.",
    sense="<=",
    unit="µm",
    source=Text("rule of this program: no deeper than the outlines are exact"),
    advice=Text(
        "Cut the tips, or take a tool with a larger addendum, a smaller tip radius, or a protuberance that covers the "
        "stock."
    ),
    role="physics",
    value_id=dotted("gears", "M", MeshResult.penetration),
    moved_by=(
        dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.tip_shortening),
        dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.tip_shortening),
        dotted("gears", GearsInputs.tool_addendum),
        dotted("gears", GearsInputs.tool_tip_radius),
        dotted("gears", GearsInputs.protuberance),
    ),
)
FINISHING_STEP = CheckRule(
    "gears.train.finishing_step",
    "caution",
    "A notch beside the root, which the safety against breakage does not count.",
    Text("Step that finishing leaves above the fillet"),
    "<=",
    "µm",
    Text(
        "rule of this program after the practice of gear handbooks, from memory: the protuberance at least as "
        "large as the stock"
    ),
    Text("A step is a notch beside the root."),
    zero="largest of protuberance, stock, 10 µm",
    moved_by=(dotted("gears", GearsInputs.protuberance), dotted("gears", GearsInputs.stock)),
)
LEAST_STEP: Metre = 10e-6  # no protuberance is ground finer


def checks(train: TrainResult, depths: Mapping[str, Metre]) -> Iterator[Check]:
    """`depths`: how deep the outlines of each mesh enter each other, by `meshing.penetrations`."""
    for key, mesh in train.meshes.items():
        yield penetration_check(key, mesh, depths[key])
    system = train.system
    if system.stock > 0:  # whether finishing runs out into the fillet without a step
        key, covering = dotted("gears", GearsInputs.protuberance), float(f"{system.stock * 1e3:.4g}")
        yield FINISHING_STEP(
            finishing_step(system),
            0.0,
            scale=max(system.stock + system.s_pr, system.stock, LEAST_STEP),
            remedies=by_key(GearsInputs, key, covering, bound=">="),
        )


def penetration_check(key: str, mesh: MeshResult, depth: Metre) -> Check:
    """Whether a tip runs into a fillet or a root, whatever the formulas of form diameter and clearance say."""
    pair = {"driver": mesh.driver, "driven": mesh.driven}
    name = Text("Outlines of {driver} and {driven} inside each other, without backlash", **pair)
    return PENETRATION(depth, CHORD_ERROR, at=key, name=name)


def notes(train: TrainResult) -> tuple[Text, ...]:
    """What the protuberance must be like for each wheel's fillet to be as it is computed."""
    notes = ((name, protuberance_note(Cut(train.system, w.teeth, w.profile_shift))) for name, w in train.wheels.items())
    return tuple(Text("Wheel {name}: {note}.", name=name, note=note) for name, note in notes if note)
