# SPDX-License-Identifier: Apache-2.0
"""Solve a design: one page of explicit calls, read like a recipe.

The order of computing is not quite that of the screen: the journals carry the shaft's reactions, the train carries the
journals' loss, and only then is the torque known that loads the gears.

The type checker holds every call against its signature, and no call has two arguments of one type: values that could be
mistaken for each other go together in a record (`BearingMaterials`, `MeshOil`, `ShaftInTrain`).  `tests/test_types.py`
swaps each pair."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import field, replace
from functools import cache, partial
from typing import TypeVar

from .bearings import solve as bearings
from .bearings.loads import with_standing as bearings_with_standing
from .countershaft import solve as countershaft
from .countershaft.result import CountershaftResult
from .countershaft.solve import with_films, with_oil
from .countershaft.supports import with_standing
from .design import step_inputs as h
from .design.model import IN_SENTENCES, STEPS, TITLES, Design
from .design.predicted import Predicted, with_measured
from .design.unusual import with_doubts
from .engine import solve as engine
from .engine.result import EngineResult
from .friction import solve as friction
from .friction.result import FrictionResult
from .gears import solve as gears
from .gears.curves import curves
from .gears.inputs import GearsInputs
from .gears.result import TrainResult
from .gears.wheel import with_masses
from .imbalance import solve as imbalance
from .imbalance.result import ImbalanceResult
from .mounting import solve as mounting
from .sheet.check import Check
from .sheet.deferred import Later
from .sheet.number import aligned, short
from .sheet.quantity import Published, ValueKey
from .sheet.record import record
from .sheet.reuse import Enough, Kept, Parts
from .sheet.step import Outcome, judged
from .sheet.text import Text
from .sheet.value import recorded, recording
from .sheet.verdict import Counts, State, colour_state, counts, design_state, verdict_words

R = TypeVar("R")


@record
class Results:
    """What a design gives, step by step in the order of the screen."""

    design: Design
    outcomes: dict[str, Outcome[object]]  # by the key of the step, each with a result of its own class
    parts: dict[str, Kept] = field(default_factory=dict, repr=False)  # arguments and outcomes, for the next solve
    recorded: bool = True  # whether the lines were recorded with the numbers
    _values: dict[str, Published] = field(default_factory=dict, repr=False)  # as soon as somebody has asked for them

    def __str__(self) -> str:
        """A line for each step with the value that stands for it, and the limits that fail; an outcome prints all of
        its step."""
        values, rows = self.values(), []
        for step in (step for step in STEPS if step.key in self.outcomes):
            outcome = self.outcomes[step.key]
            head = next(iter(step.heads(values)), None)
            words = f"{head.label}: {short(head.shown)} {head.unit}" if head else outcome.reason
            rows.append((f"  {step.title}", outcome.verdict, words))
        fails = [f"  {check}" for check in self.checks() if check.verdict == "fail"]
        return "\n".join([aligned(f"{self.design.name}: {self.words()}", iter(rows)), *fails])

    def result(self, kind: type[R]) -> R | None:
        """What the step gave whose results are of this class; None where it is not solved."""
        return next((outcome.result for outcome in self.outcomes.values() if isinstance(outcome.result, kind)), None)

    @property
    def shaft(self) -> CountershaftResult | None:
        return self.result(CountershaftResult)

    @property
    def train(self) -> TrainResult | None:
        return self.result(TrainResult)

    def values(self) -> dict[str, Published]:
        if not self._values:
            published = (value for outcome in self.outcomes.values() for value in outcome.values())
            self._values.update((id, value) for value in published for id in value.ids)
            for id, value in list(self._values.items()):
                self._values.setdefault(self.former_id(id), value)
        return self._values

    def former_id(self, id: str) -> str:
        """What a value or check was called while wheels had other names; the id itself where none had."""
        return self.design.gears.former_id(id) if self.design.gears is not None else id

    def values_of(self, field: object) -> list[Published]:
        """The values of one declared field, `results.values_of(BearingResult.film_edge)`: of each part that has one."""
        assert isinstance(field, ValueKey), field
        return [v for id, v in self.values().items() if v.about is field.about and v.id == id]  # not by a former name

    def value(self, field: object) -> Published | None:
        """The first of them; None where this design has none."""
        return next(iter(self.values_of(field)), None)

    def checks(self) -> Iterator[Check]:
        for outcome in self.outcomes.values():
            yield from outcome.checks

    def check(self, id: str) -> Check | None:
        """The check of this id, else the one that had it while wheels had other names."""
        by_former = {self.former_id(check.id): check for check in self.checks()}
        return {**by_former, **{check.id: check for check in self.checks()}}.get(id)

    @property
    def predicted(self) -> Predicted:
        """What this design gives at the speeds of measurements."""
        return Predicted(self.design, self.values(), _values_of)

    def whole(self) -> "Results":
        """The same with all curves, tables and notes, those too that take longer than a keystroke may."""
        return replace(self, outcomes={key: outcome.whole for key, outcome in self.outcomes.items()})

    @property
    def verdict(self) -> State:
        """The state of the design."""
        return design_state(self.checks(), [outcome.verdict for outcome in self.outcomes.values()])

    @property
    def counts(self) -> Counts:
        return counts(self.checks())

    @property
    def colour(self) -> str:
        """The state whose colour its verdict has."""
        return colour_state(self.verdict, self.counts)

    def words(self) -> Text:
        """`FAIL: 2 failed, 3 cautions`; of steps without a solution, or that wait, their names."""
        state = self.verdict
        lost = [IN_SENTENCES[key] for key, o in self.outcomes.items() if o.verdict == "no_solution"]
        waiting = [key for key, o in self.outcomes.items() if o.verdict == "blocked"]
        waiting_words = [Text("{step} waits", step=IN_SENTENCES[key]) for key in waiting]
        return verdict_words(state, self.counts, lost if state == "no_solution" else [*lost, *waiting_words])


def _values_of(design: Design) -> dict[str, Published]:
    """Of a design that nobody looks at itself."""
    with recorded(False):
        return solve(design).values()


def solve(
    design: Design,
    before: Results | None = None,
    stop: Callable[[], bool] = bool,
    enough: Callable[[Outcome[object]], bool] | None = None,
    *,
    compared: bool = True,
) -> Results:
    """All steps of a design, with the lines of the calculation; a loop over designs, whose lines nobody reads, runs
    inside `recorded(False)`.

    `before`: the results of an earlier version, of which unchanged parts are taken over.  `compared`: with what other
    methods give beside those that judge; every verdict is the same without.  `stop` is asked between the parts whether
    nobody waits for the results any more; then Cancelled is raised.  `enough` is asked after each part: where what it
    gave decides all that is asked, the outcomes so far are returned."""
    kept = before.parts if before is not None and before.recorded >= recording.get() else {}
    part = Parts(TITLES, kept, dict(design.without), stop=stop, enough=enough)
    try:
        outcomes = steps(part, design, compared)
    except Enough:
        outcomes = part.outcomes
    results = Results(design, outcomes, part.kept, recording.get())
    if design.measured:
        bare = replace(results, outcomes=dict(outcomes))  # does not lead back to the outcomes that ask it
        outcomes |= with_measured(design, outcomes, cache(lambda: bare.predicted))
    return results


def steps(part: Parts, design: Design, compared: bool) -> dict[str, Outcome[object]]:
    """Each outcome has the first letter of its step: `e`ngine, `i`mbalance, `c`ountershaft, `b`earings, `g`ears,
    `f`riction; `h` is what steps hand each other."""
    materials, oils, first_speed = design.materials, design.oils, h.first_speed(design)

    if design.engine is not None:
        e = part("engine", engine.solve, design.engine, materials)
    else:
        e = part.absent("engine", design.engine, ())

    if design.imbalance is not None and design.engine is not None and e.result is not None:
        i = part(
            "imbalance",
            imbalance.solve,
            design.imbalance,
            design.engine,
            e.result,
            h.takes_first_order(design),
            h.shaft_teeth(design),
            h.shaft_axis(design),
        )
    else:
        i = part.absent("imbalance", design.imbalance, (e,))

    if design.gears is not None and first_speed is not None:
        g = part("gears", gears.at_rest, design.gears, h.shafts(design))
    else:
        g = part.absent("gears", design.gears, (e,))
    gear = h.shaft_gear(design, g.result)

    if design.countershaft is not None and e.result is not None and i.result is not None:
        c = part(
            "countershaft",
            countershaft.solve,
            design.countershaft,
            i.result,
            e.result.angular_speed,
            materials,
            gear,
            h.overrun(design),
            judged=design.bearings is not None,
        )
    else:
        c = part.absent("countershaft", design.countershaft, (e, i))
    if i.result is not None and c.result is not None and design.imbalance is not None and h.takes_first_order(design):
        i = imbalance.with_shaft(i, c.result.vectors, design.imbalance)

    late = h.unsolved((e, i, c))
    if design.bearings is not None and not late:
        b = part(
            "bearings",
            bearings.solve,
            design.bearings,
            design.rows,
            c.result,
            design.engine,
            h.bearing_materials(design, design.bearings),
            speed_ratio=design.own.speed_ratio if design.own is not None else None,
            compared=compared,
        )
    else:
        b = part.absent("bearings", design.bearings, late)

    if design.gears is not None and g.result is not None and first_speed is not None:
        g = part("gears", gears.turning, _placed(part, g, design.gears, design, c), design.gears, first_speed)

    oil, late = h.mesh_oil(design), h.unsolved((b,))
    if (
        design.friction is not None
        and design.gears is not None
        and g.result is not None
        and first_speed
        and oil is not None
        and not late
    ):
        f = part(
            "friction",
            friction.solve,
            design.friction,
            design.gears,
            g.result,
            h.on_shafts(design, c, b, gear),
            first_speed,
            oil,
            materials,
            oils,
            compared=compared,
        )
    else:
        f = part.absent("friction", design.friction, (g, *late))
    f = friction.with_rated_power(f, h.rated_power(design))

    if c.result is not None and design.countershaft is not None:
        c = with_standing(c, design.countershaft, gear, h.shaft_drive(design, g.result, f), b.result)
        b = bearings_with_standing(b, c.solution.standing)
        c = with_oil(with_films(c, b.result, design.bearings.housing_stiffness if design.bearings else None), b.result)
    if g.result is not None and design.gears is not None:
        g = _rated(part, g, design.gears, design, e, c, f)
        g = _on_engine(g, design, c)
    e = replace(e, computes=design.engine is None or design.engine.throw is None)
    i = replace(i, computes=True)
    outcomes = (e, i, c, b, g, f, _mounted(part, design, e, i, c, g))
    return judged(_in_place(design, with_doubts(design, outcomes)), design.accepted)


def _in_place(design: Design, outcomes: Iterable[Outcome[object]]) -> Iterator[Outcome[object]]:
    """The outcomes with their checks by the keys of this design."""
    for outcome in outcomes:
        yield replace(outcome, checks=tuple([check.in_place(design.in_place) for check in outcome.checks]))


def _on_engine(g: Outcome[TrainResult], design: Design, c: Outcome[CountershaftResult]) -> Outcome[TrainResult]:
    """A train that is complete: what its backlash leaves of what the shafts balance, whether they turn as they must,
    and its curves."""
    g = gears.with_residuals(g, h.balanced(c))
    g = gears.with_speed_ratios(g, h.ratios(design), design.engine)
    return replace(g, curves=g.curves + Later(partial(curves, g.solution)))


def _mounted(
    part: Parts,
    design: Design,
    e: Outcome[EngineResult],
    i: Outcome[ImbalanceResult],
    c: Outcome[CountershaftResult],
    g: Outcome[TrainResult],
) -> Outcome[object]:
    """The engine on its mounts, which most designs do not ask for."""
    late = h.unsolved((e, i, c))
    if design.mounting is None or design.engine is None or e.result is None or i.result is None or late:
        return part.absent("mounting", design.mounting, (e, i, *late))
    return part(
        "mounting", mounting.solve, design.mounting, design.engine, e.result, i.result, h.shaft_on_engine(design, c, g)
    )


def _placed(
    part: Parts, g: Outcome[TrainResult], inputs: GearsInputs, design: Design, c: Outcome[CountershaftResult]
) -> Outcome[TrainResult]:
    """A train whose geometry is known: its masses, its backlash and its place.  What finds no solution fails, the rest
    stays."""
    g = part("gears", with_masses, g, inputs, design.materials)
    played = part("gears", gears.with_play, g, inputs, design.materials, h.housing(design))
    g = played if played.state == "solved" else gears.without(g, gears.BACKLASH, played.reason)
    placed = part("gears", gears.with_layout, g, inputs, h.shafts_in_train(design, c))
    return placed if placed.state == "solved" else gears.without(g, gears.LAYOUT, placed.reason)


def _rated(
    part: Parts,
    g: Outcome[TrainResult],
    inputs: GearsInputs,
    design: Design,
    e: Outcome[EngineResult],
    c: Outcome[CountershaftResult],
    f: Outcome[FrictionResult],
) -> Outcome[TrainResult]:
    """Its rating and its forces, once the closed balance has the power of every mesh."""
    power = h.power(inputs, f)
    if power is None:
        return gears.not_rated(g, h.not_rated(f))
    rated = part("gears", gears.rating, inputs, g.solution, power, design.materials, h.around_gears(design, e, c))
    if rated.state != "solved":
        return gears.without(g, gears.RATING, rated.reason)
    return gears.with_forces(gears.merge(g, rated), inputs)
