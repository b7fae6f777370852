# SPDX-License-Identifier: Apache-2.0
"""The parts of a design as solids, as they were asked for: shafts, drilled or with their teeth, and wheels."""

import math
from dataclasses import replace
from functools import cached_property

from assistant.exports.kinds import Request
from calc.countershaft.balancing.checks import outside_words
from calc.countershaft.balancing.inputs import Balancing
from calc.countershaft.balancing.result import Drill
from calc.countershaft.balancing.solve import Made as Undrilled
from calc.countershaft.balancing.solve import drills
from calc.countershaft.outline import Outline
from calc.countershaft.twins import Resolved, turned_alike
from calc.exchange.frame import frame_of
from calc.exchange.places import WheelPlace, planes_of, wheel_places
from calc.gears.profile.outline import shifts
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Amount, Name, Text
from calc.sheet.units import Metre, Radian
from calc.solve import Results
from reports.step.shaft import Hole, WeighedPart, mirrored, shaft_solid
from reports.step.teeth import has_blank, seat, toothed_shaft
from reports.step.wheel import opening, wheel_solid

NO_ALLOWANCE = "none"


class Solids:
    """`asked`: with the options --teeth, --drilled, --blank and --allowance."""

    def __init__(self, asked: Request, blank: bool = False) -> None:
        self.asked, self.options, self.results, self.design = asked, asked.options, asked.results, asked.results.design
        self.train, self.gears, self.frame = self.results.train, self.design.gears, frame_of(self.design)
        self.teeth, self.blank = bool(self.options.get("teeth")), blank or bool(self.options.get("blank"))
        end = str(self.options.get("allowance") or NO_ALLOWANCE)
        self.end = "" if end == NO_ALLOWANCE else end

    @cached_property
    def places(self) -> dict[str, WheelPlace]:
        return wheel_places(self.results)

    @cached_property
    def planes(self) -> dict[str, Metre]:
        return planes_of(self.results)

    # --- wheels

    def lacks_end(self, wheels: list[str]) -> list[InputError]:
        """Which wheels have no such end of their allowance."""
        if not self.end or self.train is None:
            return []
        return [
            InputError(0, "--allowance", self.end, Text("wheel {name} has no span_allowance_um", name=Name(name)))
            for name in wheels
            if self.end not in shifts(self.train.system, self.train.wheels[name])
        ]

    def wheel(self, name: str, inside: Metre | None = None) -> WeighedPart:
        """`inside`: the radius inside which it is open, else its own."""
        assert self.train is not None and self.gears is not None
        given = next(one for one in self.gears.wheels if one.name == name)
        density, tooth = self.design.materials[given.material].density, self._tooth(name)
        return wheel_solid(
            self.train,
            self.gears,
            name,
            density,
            self.frame,
            tooth=tooth,
            end=self.end,
            blank=self.blank,
            inside=inside,
        )

    def _tooth(self, name: str) -> Radian:
        """Where its first tooth stands: as the layout has it, else up."""
        if name in self.places:
            return self.places[name].tooth
        laid = self.train.layout.wheels.get(name) if self.train is not None and self.train.layout is not None else None
        return laid.tooth_angle or 0.0 if laid is not None else 0.0

    def beside(self, name: str, shape: Outline) -> WeighedPart:
        """The wheel of a shaft whose outline has no blank of it: open where the shaft runs through."""
        assert self.train is not None and self.gears is not None
        wheel = self.train.wheels[name]
        return self.wheel(name, max(opening(wheel, self.gears), seat(shape, wheel, self.planes[name])))

    # --- shafts

    def wheel_on(self, shaft: Resolved) -> str | None:
        """The wheel that turns a shaft."""
        if self.train is None:
            return None
        turn = self.train.shafts.get(shaft.name)
        return turn.wheel if turn is not None and turn.wheel in self.train.wheels else None

    def drawn(self, shaft: Resolved) -> tuple[Outline, list[Hole]]:
        """The outline of a shaft and its holes, of a mirror image turned over."""
        view = self.results.view(shaft.name)
        shape, holes = outline_of(view), self._holes(view)
        if shaft.how == "mirrors":
            return mirrored(shape), [replace(hole, angle=-hole.angle) for hole in holes]
        return shape, holes

    def same_part(self, shaft: Resolved) -> Text | None:
        """Why a twin needs no file of its own; None: it does.  With its teeth it always does: their hand is another."""
        if shaft.how == "own" or self.teeth:
            return None
        view = self.results.view(shaft.name)
        holes = [hole.angle for hole in self._holes(view)]
        same = 0.0 if shaft.how == "repeats" else turned_alike(outline_of(view), holes)
        if same is None:
            return None
        turned, words = round(math.degrees(same), 9), dict(name=Name(shaft.name), original=Name(shaft.of or ""))
        if shaft.how == "repeats":
            return Text("{name} is the same part as {original}.", **words)
        said = Text("{name} is the mirror image of {original}, which is the same part", **words)
        if self.wheel_on(shaft) is not None:
            said = Text("{name} is the mirror image of {original}, which without its teeth is the same part", **words)
        if turned:
            return Text("{said}, turned by {angle}.", said=said, angle=Amount(turned, "°"))
        return Text("{said}.", said=said)

    def shaft(self, shaft: Resolved) -> WeighedPart:
        shape, holes = self.drawn(shaft)
        rho, name = self.density(shaft), self.wheel_on(shaft)
        if not self.teeth or name is None or self.train is None or self.gears is None:
            return shaft_solid(shaft.name, shape, rho, self.frame, holes)
        wheel, z, straight = self.train.wheels[name], self.planes[name], name not in self.gears.hands()

        def made(inside: Metre | None) -> WeighedPart:
            return self.beside(name, shape) if inside is None else self.wheel(name, inside)

        return toothed_shaft(shaft.name, shape, rho, self.frame, wheel, z, made, straight, holes)

    def with_blank(self, shaft: Resolved) -> WeighedPart:
        """The same shaft with a blank for its wheel."""
        assert self.train is not None
        shape, holes = self.drawn(shaft)
        rho, name = self.density(shaft), self.wheel_on(shaft)
        if name is None or has_blank(shape, self.train.wheels[name], self.planes[name]):
            return shaft_solid(shaft.name, shape, rho, self.frame, holes)
        return Solids(self.asked, blank=True).shaft(shaft)

    def density(self, shaft: Resolved) -> float:
        """Of the core of a shaft."""
        return self.design.materials[shaft.inputs.material].density

    def has_wheel(self, shaft: Resolved) -> bool:
        """Whether the part of a shaft has its wheel, as a blank or with its teeth."""
        name = self.wheel_on(shaft)
        if name is None or self.train is None:
            return False
        return self.teeth or has_blank(self.drawn(shaft)[0], self.train.wheels[name], self.planes[name])

    def _holes(self, view: Results) -> list[Hole]:
        """The holes of the balancing sheet at their greatest depth, but those that would be in the air."""
        asked = (o for o in self._drills(view) if o.outside is None)
        return [Hole(o.name, o.z, o.angle, o.R, o.diameter, o.depth, o.point) for o in asked]

    def not_drilled(self, shaft: Resolved) -> list[Text]:
        """Which holes would be in the air."""
        aside = (drill for drill in self._drills(self.results.view(shaft.name)) if drill.outside is not None)
        return [Text("{hole}: it is not drilled.", hole=outside_words(drill)) for drill in aside]

    def _drills(self, view: Results) -> tuple[Drill, ...]:
        """Where they are asked for: as [shafts.balancing] places them, else the calibration holes, in a row along each
        mass.  Raises BadInput where there are none."""
        if not self.options.get("drilled"):
            return ()
        shaft, solved = view.design.countershaft, view.shaft
        assert shaft is not None and solved is not None
        made = Undrilled(solved.masses, solved.outline, shaft.outer_radius, 0.0, 0.0, None)
        holes = drills(shaft, shaft.balancing or Balancing(), made)
        if not holes:
            reason = Text(
                "needs holes to drill: add [shafts.holes] with diameter_mm, depth_mm and count, or "
                "[[shafts.balancing.holes]]"
            )
            raise BadInput("contralbero export", [InputError(0, "--drilled", "", reason)])
        return holes


def outline_of(view: Results) -> Outline:
    """Of a shaft that has one, as was seen before."""
    assert view.shaft is not None and view.shaft.outline is not None
    return view.shaft.outline
