# SPDX-License-Identifier: Apache-2.0
"""Over what is searched: the values of every variable, by [optimise.vary] or by rule, and what is wrong with those that are given."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from ...design.addresses import quantity_of, value_at
from ...bearings.selection.variants import SUPPLIES, placed
from ...countershaft.inputs import THREADED
from ...design.model import Design
from ...design.toml_file import Document, design
from ...library.fits import problem as fit_problem
from ...design.locks import locked
from ...sheet.errors import BadInput, InputError
from ...sheet.search import multiples
from ...sheet.text import Name, Text
from ...optimise.inputs import OptimiseInputs

CORE_SHARE = (0.25, 0.55)  # of the outer radius, and a tenth of it about the design's own; rule of this program
SEAT_REACH = 6.0  # mm beyond the design's; rule of this program
LEAST_SEAT = 0.75  # of the design's; rule of this program
STEP = 0.5  # mm
ROOM = 0.1  # mm about the gear's tip in its seat
LEAST_SHARE = 0.6  # of the design's smaller journal, where no gear goes through its seat; rule of this program
MOST_CLASSES = 500
MOST_VALUES = 1000  # of one range
CORE, FITS, SURFACES = "countershaft.core_radius_mm", "bearings.fits", "bearings.surfaces"
SIZES = (CORE, *(f"bearings.{place}.{name}_mm" for place in ("front", "rear") for name in ("diameter", "length")))
TIED = {
    "countershaft.outer_radius_mm": Text("follows from the largest journal, less the clearance for threading in"),
    "countershaft.half_length_mm": Text("follows from the longer journal, less two fillets"),
    "bearings.front.clearance_um": Text("is chosen in steps of 5 µm between what is left cold and the usual factor"),
    "bearings.rear.clearance_um": Text("is chosen in steps of 5 µm between what is left cold and the usual factor"),
}
WITHIN = {  # keys that a drive is given with another one
    "bearings.journal_fit": FITS, "bearings.seat_fit": FITS,
    **{f"bearings.{place}.{part}_roughness_um": SURFACES for place in ("front", "rear") for part in ("journal", "housing")},
    **{f"bearings.{place}.clearance_factor": f"bearings.{place}.clearance_um" for place in ("front", "rear")},
}  # fmt: skip
WIDTHS = Text('must be pairs of widths, journal and seat: ["IT6", "IT7"]; the clearance is searched for, and a fit with a place makes it')


class Variables:
    """The values of every variable, and what is wrong with those that are given."""

    def __init__(self, start: Document, made: Design, own: OptimiseInputs, tip: float | None) -> None:
        assert made.countershaft is not None and made.bearings is not None
        self.start, self.shaft, self.bearings, self.own, self.tip = start, made.countershaft, made.bearings, own, tip
        self.vary: dict[str, Any] = dict(own.vary) if isinstance(own.vary, dict) else {}
        self.errors: list[InputError] = []
        self.said: list[Text] = []
        self.seat = "rear" if self.bearings.rear.diameter >= self.bearings.front.diameter else "front"
        for key in self.vary:
            if key in TIED:
                self.wrong(key, Text("can not be varied: it {why}", why=TIED[key]))
            elif key == "bearings.slope_mrad":
                self.wrong(key, Text("can not be varied: it is that of each shaft's own bending"))
            elif (within := WITHIN.get(key)) is not None and (within != SURFACES or self._surfaces_vary()):
                self.wrong(key, Text("can not be varied: it is set with {key}", key=Name(within)))

    def wrong(self, key: str, why: Text, value: object = "") -> None:
        name = f"optimise.vary.{key}"
        self.errors.append(InputError(self.start.lines.get(name, self.start.lines.get("optimise.vary", 0)), name, str(value), why))

    def values(self, key: str, otherwise: Sequence[float]) -> tuple[float, ...]:
        """Numbers of a key: those that are given, else those of the rule."""
        said = self.vary.get(key)
        if said is None:
            return tuple(otherwise)
        if said == "fixed":
            now = value_at(self.start.data, key)
            return (float(now),) if isinstance(now, (int, float)) else ()
        numbers = said if isinstance(said, list) else _range(said)
        if not all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in numbers):
            self.wrong(key, Text("must be numbers"), said)
            return tuple(otherwise)
        if len(numbers) > MOST_VALUES:
            self.wrong(key, Text("asks for {n} values; at most {most}", n=len(numbers), most=MOST_VALUES))
            return tuple(otherwise)
        for x in (min(numbers), max(numbers)):
            self._allowed(key, x)
        return tuple(sorted(set(map(float, numbers))))

    def _allowed(self, key: str, value: object) -> None:
        """A value as the design file would take it."""
        try:
            design(self.start.with_value(key, value))
        except BadInput as bad:
            own = [e for e in bad.errors if e.key == key]
            if own or not key.startswith(("countershaft", "bearings")):
                self.wrong(key, (own or bad.errors)[0].reason, value)

    def sizes(self) -> dict[str, tuple[float, ...] | None]:
        own = {place: getattr(self.bearings, place).diameter * 1e3 for place in ("front", "rear")}
        small = "front" if self.seat == "rear" else "rear"
        threaded = (THREADED if self.shaft.radial_clearance is None else self.shaft.radial_clearance) * 1e3
        R = own[self.seat] / 2 - threaded
        core = (self.shaft.core_radius or 0.0) * 1e3 / R
        most = min(own[self.seat] + SEAT_REACH, self._widest_seat(), (self.own.most or {}).get("seat_mm", float("inf")))
        through = self.tip if self.tip is not None and small == "front" else None  # the gear goes through the front seat
        least = through + 2 * ROOM if through is not None else LEAST_SHARE * own[small]
        seats = self.values(f"bearings.{self.seat}.diameter_mm", _steps(LEAST_SEAT * own[self.seat], most))
        seats = tuple(d for d in seats if d <= most + 1e-9)
        found: dict[str, tuple[float, ...] | None] = {
            CORE: self.values(CORE, _steps(max(min(CORE_SHARE[0], core - 0.1), 0.05) * R, min(max(CORE_SHARE[1], core + 0.1), 0.95) * R)),
            f"bearings.{self.seat}.diameter_mm": seats,
            f"bearings.{small}.diameter_mm": self.values(f"bearings.{small}.diameter_mm", _steps(least, max(seats, default=0.0))),
        }
        for place in ("front", "rear"):
            key = f"bearings.{place}.length_mm"
            found[key] = self.values(key, ()) if key in self.vary else None
        for key in SIZES:
            if (why := locked(self.start.data, key)) and key not in self.vary:
                found[key] = self.values(key, ()) if self.vary.setdefault(key, "fixed") else None
                self.said.append(Text("{key} stays, as locked: {why}.", key=key, why=why))
        return found

    def bounded(self) -> dict[str, tuple[bool, bool]]:
        small = "front" if self.seat == "rear" else "rear"
        most = min(self._widest_seat(), (self.own.most or {}).get("seat_mm", float("inf")))
        through = self.tip is not None and small == "front" and f"bearings.{small}.diameter_mm" not in self.vary
        return {CORE: (False, False), f"bearings.{self.seat}.diameter_mm": (False, most < float("inf")),
            f"bearings.{small}.diameter_mm": (through, True)}  # fmt: skip

    def _widest_seat(self) -> float:
        support = self.shaft.support
        if support is None or support.wall is None or support.wall_at_seat is None:
            return float("inf")
        return (support.wall_at_seat + 2 * (support.wall - support.least_wall)) * 1e3

    def choices(self) -> dict[str, tuple[Any, ...]]:
        shaft, bearings = self.shaft, self.bearings
        others = [a.material for a in shaft.cost.alternatives] if shaft.cost is not None else []
        fits = [str(bearings.journal_fit), str(bearings.seat_fit)]
        supplies = [s for s, width in SUPPLIES.items() if getattr(bearings, width) is not None and s != bearings.supply]
        rules: dict[str, list[Any]] = {
            "countershaft.material": [shaft.material, *(m for m in others if m != shaft.material)],
            "bearings.oil": [bearings.oil],
            "bearings.supply": [bearings.supply, *supplies],
            FITS: [fits, *(p.value for p in self.own.price if p.what == "fit" and p.value != fits)],
        }
        for key, values in rules.items():
            if key != FITS and (why := locked(self.start.data, key)):
                del values[1:]
                if key != "bearings.oil":
                    self.said.append(Text("{key} stays, as locked: {why}.", key=key, why=why))
        found: dict[str, tuple[Any, ...]] = {}
        for key in (*rules, *(k for k in self.vary if k not in (*rules, *SIZES, *TIED, SURFACES))):
            said = self.vary.get(key)
            if said == "fixed" or said is None:
                found[key] = tuple(rules.get(key, ())[: 1 if said == "fixed" else None])
                if not found[key]:
                    continue
            else:
                found[key] = tuple(said if isinstance(said, list) else _range(said))
            for value in found[key] if said is not None or key == FITS else ():
                self._one(key, value)
        found = {key: values for key, values in found.items() if values}
        count = math.prod(map(len, found.values()))
        if count > MOST_CLASSES:
            self.wrong("", Text("makes {n} classes; at most {most}: vary less at once", n=count, most=MOST_CLASSES))
        if len(rules[FITS]) == 1 and FITS not in self.vary:
            self.said.append(Text("The fits stay: no price says what closer ones cost."))
        return found

    def _one(self, key: str, value: object) -> None:
        if key == FITS:
            if not (isinstance(value, list) and len(value) == 2 and all(isinstance(x, str) for x in value)):
                self.wrong(key, WIDTHS, value)
            elif (why := fit_problem(value[0], "shaft") or fit_problem(value[1], "hole")) is not None:
                self.wrong(key, why, value)
            elif placed(replace(self.bearings, journal_fit=value[0], seat_fit=value[1])) is not None:
                self.wrong(key, WIDTHS, value)
            return
        try:
            quantity_of(self.start.data, key)
        except BadInput as bad:
            self.wrong(key, bad.errors[0].reason)
            return
        self._allowed(key, value)

    def _surfaces_vary(self) -> bool:
        said = self.vary.get(SURFACES)
        return said != "fixed" and (said is not None or any(p.what == "surface" for p in self.own.price))

    def surfaces(self) -> tuple[tuple[float, float] | None, ...]:
        said = self.vary.get(SURFACES)
        if said == "fixed":
            return (None,)
        priced = [p.value for p in self.own.price if p.what == "surface"]
        pairs: list[Any] = said if isinstance(said, list) else priced
        for pair in pairs:
            if not (isinstance(pair, list) and len(pair) == 2 and all(isinstance(x, (int, float)) and 0 < x <= 50 for x in pair)):
                self.wrong(SURFACES, Text("must be pairs of Ra in µm, journal and seat: [0.4, 0.6]"), pair)
                return (None,)
        if not pairs:
            self.said.append(Text("The surfaces stay: no price says what smoother ones cost."))
        own = self.bearings.front, self.bearings.rear
        as_designed = [(b.journal_roughness * 1e6, b.housing_roughness * 1e6) for b in own]
        found: list[tuple[float, float] | None] = [] if isinstance(said, list) else [None]
        same = as_designed[0] == as_designed[1]
        for a, b in pairs:
            pair = (float(a), float(b))
            if not (same and None in found and all(abs(x - y) < 1e-9 for x, y in zip(pair, as_designed[0]))):
                found.append(pair)
        return tuple(found)


def _range(said: Mapping[str, float]) -> list[float]:
    count = (said["to"] - said["from"]) / said["step"]
    if count > MOST_VALUES:
        return [said["from"]] * (MOST_VALUES + 1)
    return [round(said["from"] + n * said["step"], 9) for n in range(int(count + 1e-9) + 1)]


def _steps(low: float, high: float) -> tuple[float, ...]:
    return tuple(round(x, 6) for x in multiples(STEP, low, high).tolist()) if high >= low else ()
