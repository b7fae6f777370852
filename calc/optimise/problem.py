# SPDX-License-Identifier: Apache-2.0
"""What is searched over, what must hold and what is wanted: read off the design and its [optimise], with the rules of this program beside.

A class is one choice of everything that changes films or loads as a whole: material, oil, supply, fits, and any other key that is varied.
Within it core, diameters, lengths, clearances and surfaces are combined.  Outer radius and half-length of the sectors follow from the
journals (ties).
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fnmatch import fnmatchcase
from itertools import product
from typing import Any

from ..bearings.selection.variants import placed
from ..countershaft.inputs import THREADED, CountershaftInputs
from ..design.model import Design
from ..design.toml_file import Document, design
from ..sheet.changes import Changes
from ..sheet.check import Check
from ..sheet.errors import BadInput, InputError
from ..sheet.record import record
from ..sheet.text import Name, Text
from .inputs import OBJECTIVES, OptimiseInputs
from ..studies.drive.problem import FITS, Variables

LIMITS = (
    "bearings.*.film_edge_corner", "bearings.*.film_double_load_corner", "bearings.*.temperature_corner",
    "bearings.*.clearance_cold_corner", "bearings.*.film_edge_speeds", "bearings.*.film_edge_standing", "bearings.*.film_trumpler",
    "bearings.*.length_ratio_usual", "bearings.*.supply_range", "countershaft.gear_seat", "countershaft.fillet_room",
    "countershaft.holes.range", "countershaft.scatter.residual", "gears.*.backlash_chance", "gears.*.contact_ratio_usual",
    "gears.*.span_width", "gears.*.safety_*_usual",
)  # fmt: skip
MARGIN_OF = (
    "bearings.*.film_edge_corner", "bearings.*.film_double_load_corner", "bearings.*.film_edge_standing", "countershaft.slope_*",
)  # fmt: skip
MARGINS = (0.0, 0.05, 0.1, 0.2, 0.3)
UNITS = {"power": ("W", 10.0), "mass": ("kg", 0.5), "seat": ("mm", 1.0), "price": ("EUR", 3.0), "margin": ("%", 10.0)}


@record
class Problem:
    """`start`: the document with a shaft that is sized, by the changes `began` of the one that is asked about.  `sizes`: the values of
    every size by its key, mm, None: by the rule of lengths.

    `choices`: the values of everything else; `surfaces`: pairs of Ra, journal and seat, µm; None: as designed.  `seat`: the place of the
    largest journal.  `most`: hard ends by objective, in its unit; margin is a least.  `said`: what was chosen here.
    """

    start: Document
    began: Changes
    base: Design
    sizes: dict[str, tuple[float, ...] | None]
    choices: dict[str, tuple[Any, ...]]
    surfaces: tuple[tuple[float, float] | None, ...]
    seat: str
    objectives: tuple[str, ...]
    margins: tuple[float, ...]
    most: dict[str, float]
    limits: tuple[str, ...]
    waived: tuple[str, ...]
    units: dict[str, float]
    cycle: tuple[tuple[float, float], ...]  # speed over the rated one, and share of the time; empty: the rated speed alone
    bounded: dict[str, tuple[bool, bool]]  # whether the low and the high end of a range of sizes is a limit of the design itself
    rows: int
    seed: int
    said: tuple[Text, ...]

    @property
    def classes(self) -> list[Changes]:
        """The choices of every class, in the order of their lists."""
        return [dict(zip(self.choices, values)) for values in product(*self.choices.values())]

    @property
    def shaft(self) -> CountershaftInputs:
        assert self.base.countershaft is not None
        return self.base.countershaft

    @property
    def threaded(self) -> float:
        """The clearance for threading in, mm."""
        clearance = self.shaft.radial_clearance
        return (THREADED if clearance is None else clearance) * 1e3

    @property
    def fillet(self) -> float:
        """mm; 0: none is asked."""
        return (self.shaft.fillet_radius or 0.0) * 1e3

    def binds(self, id: str) -> bool:
        """Whether a finding is a limit here."""
        return any(fnmatchcase(id, one) for one in self.limits) and not any(fnmatchcase(id, one) for one in self.waived)

    def broken(self, checks: Iterable[Check]) -> list[Check]:
        """What a drive does not keep: limits that fail, and findings that are limits here."""
        return [c for c in checks if c.verdict == "fail" or (self.binds(c.id) and not c.margin >= 0)]

    def margin(self, checks: Iterable[Check]) -> float:
        """The least margin of the films and the slopes, %."""
        return min((c.margin * 100 for c in checks if any(fnmatchcase(c.id, one) for one in MARGIN_OF)), default=float("nan"))

    def price(self, choices: Mapping[str, Any], surface: tuple[float, float] | None) -> float | None:
        """Of a piece, in EUR: its material with the tooling over a year, and what the rest adds; None: nothing is known of it."""
        return price(self.base, choices, surface)


def price(made: Design, choices: Mapping[str, Any], surface: tuple[float, float] | None) -> float | None:
    assert made.countershaft is not None
    cost = made.countershaft.cost
    material = choices.get("countershaft.material", made.countershaft.material)
    own = next((a for a in cost.alternatives if a.material == material), None) if cost is not None else None
    if own is None or cost is None:
        return None
    total = own.piece + own.tooling / cost.pieces_per_year
    chosen = {
        "fit": choices.get(FITS), "surface": list(surface) if surface is not None else None, "material": [material],
        "supply": [choices.get("bearings.supply")], "oil": [choices.get("bearings.oil")],
    }  # fmt: skip
    return total + sum(one.piece for one in _optimise(made).price if chosen[one.what] == one.value)


def _optimise(made: Design) -> OptimiseInputs:
    return made.optimise or OptimiseInputs()


# --- reading --------------------------------------------------------------------------------------------------------------
def problem(document: Document, tip: float | None, said: Mapping[str, object] = {}) -> Problem:
    """`tip`: diameter of the gear on the shaft in mm, None where there is none; `said`: the command line's own keys of [optimise], which go
    before the file's.  Raises BadInput with everything that is wrong."""
    made = design(document)
    file = _optimise(made)
    merged: dict[str, Any] = {key: {**(getattr(file, key) or {}), **one} if isinstance(one, dict) else one for key, one in said.items()}
    own: OptimiseInputs = replace(file, **merged)
    errors = [InputError(document.lines.get(f"optimise.{key}", 0), f"optimise.{key}", "", why) for key, why in own.problems()]
    errors += [InputError(0, step, "", Text("is needed: a drive has a shaft on two bearings")) for step in ("countershaft", "bearings")
        if getattr(made, step) is None]  # fmt: skip
    if errors:
        raise BadInput(document.place, errors)
    began, words = _sized(made)
    start = document
    for key, value in began.items():
        start = start.with_value(key, value)
    made = design(start)
    assert made.countershaft is not None and made.bearings is not None
    variables = Variables(start, made, own, tip)
    sizes, choices, surfaces = variables.sizes(), variables.choices(), variables.surfaces()
    if variables.errors:
        raise BadInput(document.place, variables.errors)
    objectives = tuple(one for one in OBJECTIVES if own.objectives is None or one in own.objectives)
    known = [dict(zip(choices, values)) for values in product(*choices.values())]
    most = {key.rpartition("_")[0]: float(bound) for key, bound in (own.most or {}).items()}
    if "price" in (*objectives, *most) and any(price(made, one, None) is None for one in known):
        objectives = _without_price(document, objectives, most)
        variables.said.append(Text("The price is left out: [countershaft.cost] does not have it of every material."))
    least = (own.least or {}).get("margin_percent", 0.0) / 100
    margins = tuple(dict.fromkeys([least, *(m for m in MARGINS if m > least)])) if "margin" in objectives else (least,)
    limits, waived = (*LIMITS, *(own.limits or ())), tuple(own.waive or ())
    return Problem(
        start=start, began=began, base=made, sizes=sizes, choices=choices, surfaces=surfaces, seat=variables.seat, objectives=objectives,
        margins=margins, most=most | {"margin": least * 100}, limits=limits, waived=waived,
        units={key: UNITS[key][1] for key in objectives}, cycle=_cycle(made, own), bounded=variables.bounded(),
        rows=own.rows, seed=own.seed, said=(*words, *variables.said),
    )  # fmt: skip


def _without_price(document: Document, objectives: tuple[str, ...], most: Mapping[str, float]) -> tuple[str, ...]:
    """Where the price of some material is not known.  Raises BadInput where nothing else is wanted, or the price is bounded."""
    left = tuple(one for one in objectives if one != "price")
    wrong = [key for key, needed in (("objectives", not left), ("most.price_EUR", "price" in most)) if needed]
    if wrong:
        why = Text("needs the price of every material: give each a row in countershaft.cost.alternatives")
        raise BadInput(document.place, [InputError(document.lines.get(f"optimise.{key}", 0), f"optimise.{key}", "", why) for key in wrong])
    return left


def _cycle(made: Design, own: OptimiseInputs) -> tuple[tuple[float, float], ...]:
    """Raises BadInput where the speed of the drive is not the engine's to change."""
    if not own.cycle:
        return ()
    bearings, gears, engine = made.bearings, made.gears, made.engine
    if engine is None or (bearings is not None and bearings.speed is not None) or (gears is not None and gears.speed is not None):
        why = Text("needs [engine], and no speed of its own in [bearings] or [gears]")
        raise BadInput("design", [InputError(0, "optimise.cycle", "", why)])
    hours = sum(point.hours for point in own.cycle)
    return tuple((point.speed / engine.rated_speed, point.hours / hours) for point in own.cycle)


def _sized(made: Design) -> tuple[Changes, list[Text]]:
    """What makes of it a design with a shaft that is sized, its fits written so that their corners are judged; and in words."""
    shaft, bearings = made.countershaft, made.bearings
    assert shaft is not None and bearings is not None
    said: list[Text] = []
    start: Changes = {}
    R = max(bearings.front.diameter, bearings.rear.diameter) / 2 - (THREADED if shaft.radial_clearance is None else shaft.radial_clearance)
    half = min(abs(z) - b.length / 2 for z, b in zip(shaft.bearing_positions, (bearings.front, bearings.rear)))
    given = {"outer_radius_mm": R, "core_radius_mm": 0.4 * R, "half_length_mm": half - 2 * (shaft.fillet_radius or 0.0)}
    if shaft.mode != "size" and not shaft.sections:
        for key, number in given.items():
            if getattr(shaft, key.removesuffix("_mm")) is None or key != "core_radius_mm":
                start[f"countershaft.{key}"] = round(number * 1e3, 6)
        start["countershaft.mode"] = "size"
        said.append(Text("The masses are sized anew within the envelope of the journals (mode = size)."))
    if bearings.slope is not None:
        start["bearings.slope_mrad"] = None
        said.append(Text("The slopes that are given are left out: those of each shaft's own bending are taken."))
    own = (str(bearings.journal_fit), str(bearings.seat_fit))
    widths = placed(bearings)
    start |= dict(zip(("bearings.journal_fit", "bearings.seat_fit"), widths or own))
    if widths:
        said.append(Text("The fits {own} make the clearance; here it is searched for, with their widths, {widths}.",
            own=Name("/".join(own)), widths=Name("/".join(widths))))  # fmt: skip
    support = shaft.support
    if support is not None and support.wall is not None and support.wall_at_seat is None:
        seat = max(bearings.front.diameter, bearings.rear.diameter) * 1e3
        start["countershaft.support.wall_at_seat_mm"] = round(seat, 6)
        said.append(Text("The wall beside the largest seat is taken as that of the design's own seat, {seat} mm.", seat=f"{seat:g}"))
    return start, said
