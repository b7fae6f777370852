# SPDX-License-Identifier: Apache-2.0
"""Solve a design: one page of explicit calls, read like a recipe.

The order of computing is not quite that of the screen: the journals carry the shaft's reactions, the train carries the
journals' loss, and only then is the torque known that loads the gears.

The type checker holds every call against its signature, and no call has two arguments of one type: values that could be
mistaken for each other go together in a record (`BearingMaterials`, `MeshOil`, `ShaftInTrain`).  `tests/test_types.py`
swaps each pair."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import field
from functools import cache, cached_property, partial
from itertools import chain
from typing import TYPE_CHECKING, Any, TypeVar, cast

from .bearings import solve as bearings
from .bearings.kinds import KINDS
from .bearings.lives import lives_of_all
from .bearings.result import BearingsOfShafts, BearingsResult
from .bearings.standing import of_twin as bearings_of_twin
from .bearings.standing import told as bearings_told
from .bearings.standing import with_standing as bearings_with_standing
from .bearings.support import Kind
from .countershaft import left_over, shafts
from .countershaft import solve as countershaft
from .countershaft.checks import shafts_clear
from .countershaft.making.parts import with_bolts
from .countershaft.result import CountershaftResult
from .countershaft.rows import BearingRow
from .countershaft.solve import with_films, with_oil
from .countershaft.sums import SystemResult
from .countershaft.supports import with_standing
from .countershaft.twins import Resolved
from .design import step_inputs as h
from .design.model import IN_SENTENCES, STEPS, TITLES, Design
from .design.plain_and_rolling import with_comparison
from .design.predicted import Predicted, with_measured
from .design.unusual import doubts, with_doubts
from .engine import solve as engine
from .engine.result import EngineResult
from .friction import solve as friction
from .friction.checks import with_oil_level
from .friction.result import FrictionResult
from .gears import solve as gears
from .gears.curves import curves
from .gears.drive.curves import curves as drive_curves
from .gears.inputs import GearsInputs
from .gears.rating.load import RatingContext
from .gears.result import TrainResult
from .gears.wheel import with_masses
from .imbalance import solve as imbalance
from .imbalance.result import ImbalanceResult
from .mounting import solve as mounting
from .mounting.result import MountingResult
from .sheet.arguments import given_inputs
from .sheet.check import Check
from .sheet.deferred import Later
from .sheet.number import aligned, short
from .sheet.quantity import Published, ValueKey
from .sheet.record import record, replace
from .sheet.reuse import Enough, Kept, Parts
from .sheet.shown import figure, frame, html
from .sheet.step import Outcome, joined, judged
from .sheet.text import Text
from .sheet.units import Watt
from .sheet.value import recorded, recording, trace
from .sheet.verdict import Counts, State, colour_state, counts, design_state, verdict_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from pandas import DataFrame

    from .design.run_results import RunResults
    from .design.toml_file import Document

R = TypeVar("R")
Shafts = dict[str, Outcome[CountershaftResult]]  # by their names


@record
class Results:
    """What a design gives, step by step in the order of the screen."""

    design: Design
    outcomes: dict[str, Outcome[object]]  # by the key of the step, each with a result of its own class
    of_shafts: dict[str, dict[str, Outcome[object]]] = field(default_factory=dict, repr=False)  # by name and step
    parts: dict[str, Kept] = field(default_factory=dict, repr=False)  # arguments and outcomes, for the next solve
    recorded: bool = True  # whether the lines were recorded with the numbers
    viewed: "Results | None" = field(default=None, repr=False)  # those of all shafts, where one of several is in view
    _values: dict[str, Published] = field(default_factory=dict, repr=False)  # as soon as somebody has asked for them
    _of_field: dict[object, list[Published]] = field(default_factory=dict, repr=False)  # the same by what declares them

    def __str__(self) -> str:
        """A line for each step with the value that stands for it, and the limits that fail; an outcome prints all of
        its step."""
        fails = [f"  {check}" for check in self.checks() if check.verdict == "fail"]
        rows = ((f"  {title}", verdict, words) for title, verdict, words in self._rows())
        return "\n".join([aligned(f"{self.design.name}: {self.words()}", rows), *fails])

    def _rows(self) -> Iterator[tuple[str, str, str]]:
        """(title, verdict, what stands for it) of each step."""
        values = self.values()
        for step in (step for step in STEPS if step.key in self.outcomes):
            outcome = self.outcomes[step.key]
            head = next(iter(step.heads(values)), None)
            words = f"{head.label}: {short(head.shown)} {head.unit}" if head else outcome.reason
            yield step.title, outcome.verdict, words

    def _repr_html_(self) -> str:
        """The same as a table in a notebook."""
        fails = [check for check in self.checks() if check.verdict == "fail"]
        return html(f"{self.design.name}: {self.words()}", self._rows(), fails)

    def to_frame(self) -> "DataFrame":
        """Every value of every step by its id, with its unit and label, as a frame of pandas."""
        return frame([value for outcome in self.outcomes.values() for value in outcome.values()])

    def plot(self, curve: str = "", ax: "Axes | None" = None) -> "Axes":
        """One of the curves of all steps, by its id, with matplotlib; left out: the first.  Returns the axes.  BadInput
        with the ids that there are, where there is no such curve."""
        every = (each for outcome in self.outcomes.values() for each in outcome.curves)
        longer = (each for outcome in self.outcomes.values() for each in outcome.whole.curves)
        return figure("plot", chain(every, longer), curve).plot(ax)

    def __getstate__(self) -> dict[str, object]:
        """To another process go the numbers, curves and words; not what only speeds the next solve in this one."""
        return vars(self) | {"parts": {}, "_values": {}, "_of_field": {}}

    def result(self, kind: type[R]) -> R | None:
        """What the step gave whose results are of this class; None where it is not solved."""
        return next((outcome.result for outcome in self.outcomes.values() if isinstance(outcome.result, kind)), None)

    @property
    def engine(self) -> Outcome[EngineResult]:
        """The outcome of the step, as those of the other steps below it."""
        return cast("Outcome[EngineResult]", self.outcomes["engine"])

    @property
    def imbalance(self) -> Outcome[ImbalanceResult]:
        return cast("Outcome[ImbalanceResult]", self.outcomes["imbalance"])

    @property
    def countershaft(self) -> Outcome[CountershaftResult]:
        """Of the only shaft; of one of several `view(name).countershaft`."""
        return cast("Outcome[CountershaftResult]", self._of_one_shaft("countershaft"))

    @property
    def bearings(self) -> Outcome[BearingsResult]:
        """Of the only shaft; of one of several `view(name).bearings`."""
        return cast("Outcome[BearingsResult]", self._of_one_shaft("bearings"))

    @property
    def gears(self) -> Outcome[TrainResult]:
        return cast("Outcome[TrainResult]", self.outcomes["gears"])

    @property
    def friction(self) -> Outcome[FrictionResult]:
        return cast("Outcome[FrictionResult]", self.outcomes["friction"])

    @property
    def mounting(self) -> Outcome[MountingResult]:
        return cast("Outcome[MountingResult]", self.outcomes["mounting"])

    def _of_one_shaft(self, step: str) -> Outcome[object]:
        if len(self.design.shafts) > 1 and self.of_shafts:
            names, first = ", ".join(self.views), next(iter(self.views))
            raise LookupError(f"this design has several shafts ({names}): view({first!r}).{step} is that of the first")
        return self.outcomes[step]

    @property
    def shaft(self) -> CountershaftResult | None:
        return self.result(CountershaftResult)

    def kind_of(self, row: BearingRow) -> Kind[Any]:
        """What kind of bearing a row is."""
        return KINDS[row.kind]

    @property
    def left(self) -> SystemResult | None:
        """What all shafts together leave."""
        every = self.result(shafts.ShaftsResult)
        return every.sums if every is not None else self.shaft.sums if self.shaft is not None else None

    @property
    def train(self) -> TrainResult | None:
        return self.result(TrainResult)

    def values(self) -> dict[str, Published]:
        if not self._values:
            for outcome in self.outcomes.values():
                for value in outcome.values():
                    self._values[value.id] = value
                    if value.former:
                        self._values[value.former] = value
            if self.design.renamed:
                for id, value in list(self._values.items()):
                    self._values.setdefault(self.design.former_id(id), value)
        return self._values

    @property
    def views(self) -> "dict[str, Results]":
        """What the design gives with one of its shafts in view, by the name of each that is no twin: its steps without
        that name in their ids, and without the sums of all."""
        if len(self.design.shafts) == 1 or not self.of_shafts:
            return dict.fromkeys(self.design.views, self)
        return {name: self.view(name) for name in self.design.views if name in self.of_shafts}

    def view(self, name: str) -> "Results":
        """The same of any shaft: of a twin that of its original, with the bearings of the twin where it says something
        of them."""
        if len(self.design.shafts) == 1 or not self.of_shafts:
            return self
        of = next(shaft.of or name for shaft in self.design.resolved if shaft.name == name)
        outcomes = self.outcomes | self.of_shafts[of] | self.of_shafts.get(name, {})
        design = self.design.with_bearings_of(name) if name != of and name in self.of_shafts else self.design.views[of]
        return replace(self, design=design, outcomes=outcomes, of_shafts={}, viewed=self, _values={}, _of_field={})

    def values_of(self, field: object) -> list[Published]:
        """The values of one declared field, `results.values_of(PlainResult.film_edge)`: of each part that has one."""
        assert isinstance(field, ValueKey), field
        if not self._of_field:
            for id, v in self.values().items():
                if v.id == id:  # not by a former name
                    self._of_field.setdefault(v.about, []).append(v)
        return self._of_field.get(field.about, [])

    def value(self, field: object) -> Published | None:
        """The first of them; None where this design has none."""
        return next(iter(self.values_of(field)), None)

    def checks(self) -> Iterator[Check]:
        for outcome in self.outcomes.values():
            yield from outcome.checks

    def check(self, id: str) -> Check | None:
        """The check of this id, else the one that had it formerly."""
        by_former = {self.design.former_id(check.id): check for check in self.checks()}
        return {**by_former, **{check.id: check for check in self.checks()}}.get(id)

    @property
    def predicted(self) -> Predicted:
        """What this design gives at the speeds of measurements."""
        return Predicted(self.design, self.values(), _values_of)

    @cached_property
    def runs(self) -> "RunResults | None":
        """What the runs of [[measurements]] come to, at whose nodes the design is solved now; None where there are
        none."""
        if not self.design.runs:
            return None
        from .design.run_results import run_results  # which a design without runs does not load

        return run_results(self.design, self, solve)

    def runs_with(self, other: "Results") -> "RunResults | None":
        """What its runs and those of another design come to on this one; None where neither has any."""
        if not other.design.runs:
            return self.runs
        from .design.run_results import run_results, with_runs_of

        return run_results(with_runs_of(self.design, [other.design]), self, solve)

    def demand_runs(self, document: "Document") -> None:
        """Raises BadInput where a column of [[measurements]] is of no value that there is, or of another dimension:
        what only the results show."""
        if self.design.runs:
            from .design.predicted_runs import value_problems
            from .design.toml_file import mistaken

            if (wrong := mistaken(document, value_problems(self.design, self))) is not None:
                raise wrong

    def whole(self) -> "Results":
        """The same with all curves, tables and notes, those too that take longer than a keystroke may."""
        return replace(self, outcomes={key: outcome.whole for key, outcome in self.outcomes.items()})

    @cached_property
    def verdict(self) -> State:
        """The state of the design; asked for, as its counts are, several times at every keystroke."""
        return design_state(self.checks(), [outcome.verdict for outcome in self.outcomes.values()])

    @cached_property
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
    methods give beside those that judge; every verdict is the same without, but there is none on how far the methods
    lie apart.  `stop` is asked between the parts whether
    nobody waits for the results any more; then Cancelled is raised.  `enough` is asked after each part: where what
    there is of its step decides all that is asked, the outcomes so far are returned."""
    kept = before.parts if before is not None and before.recorded >= recording.get() else {}
    several = len(design.shafts) > 1
    part = Parts(TITLES, kept, dict(design.without), named=several, stop=stop, enough=enough)
    try:
        solved = steps(part, design, compared)
    except Enough:
        solved = Solved(part.outcomes, part.of_shafts)
    outcomes = solved.steps
    results = Results(design, outcomes, solved.of_shafts, part.kept, recording.get())
    bare = replace(results, outcomes=dict(outcomes))  # does not lead back to the outcomes that ask it
    outcomes |= with_comparison(design, outcomes, lambda: bare, solve)
    if design.measured:
        outcomes |= with_measured(design, outcomes, cache(lambda: bare.predicted))
    return results


def solve_design(design: Design) -> Results:
    """A whole design: every step's outcome, values, checks and verdicts, whatever is missing or fails in it.

    `design`: of `load_design`, or one changed with `dataclasses.replace`, in SI.  BadInput where a number in it lies
    outside of the range that it has in a design file."""
    return solve(given_inputs("solve_design", design))


@record
class Solved:
    """The steps of a design by their keys, and those of each of its shafts, by the shaft's name and the key."""

    steps: dict[str, Outcome[object]]
    of_shafts: dict[str, dict[str, Outcome[object]]]


def steps(part: Parts, design: Design, compared: bool) -> Solved:
    """Each outcome has the first letter of its step: `e`ngine, `i`mbalance, `c`ountershaft, `b`earings, `g`ears,
    `f`riction, those of counter-shaft and bearings by shaft; `h` is what steps hand each other."""
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
            h.orders_taken(design),
            h.shaft_teeth(design, h.only(design)),
            h.shaft_axes(design).get(h.only(design) or ""),
        )
    else:
        i = part.absent("imbalance", design.imbalance, (e,))

    if design.gears is not None and first_speed is not None:
        g = part("gears", gears.at_rest, design.gears, h.driven(design))
    else:
        g = part.absent("gears", design.gears, (e,))

    c = Shafts()
    if e.result is not None and i.result is not None and h.turning(design):
        for shaft in h.in_order(design):
            view = design.views[shaft.name]
            c[shaft.name] = part.of(shaft.name)(
                "countershaft",
                countershaft.solve,
                view.countershaft or shaft.inputs,
                i.result,
                e.result.angular_speed,
                materials,
                h.shaft_gear(design, g.result, shaft.name),
                h.overrun(design),
                h.beside(design, shaft, c),
                judged=design.bearings is not None,
                alike=h.sized_alike(design, shaft.name),
                shared=h.shares(design, shaft.inputs),
            )
            c |= h.twins(design, shaft, c[shaft.name])
        left = _left_over(part, design, e.result, i.result, c)
        i = _with_shafts(i, design, left)
    else:
        left = part.absent("countershaft", h.turning(design) or None, (e, i))

    late = h.unsolved((e, i, *(c.values() if c else (left,))))
    b = dict[str, Outcome[BearingsResult]]()
    if design.bearings is not None and not late:
        for shaft in h.on_own_bearings(design):
            original = shaft.of or shaft.name
            b[shaft.name] = part.of(shaft.name)(
                "bearings",
                bearings.solve,
                design.bearings,
                shaft.inputs.bearings,
                c[original].result if original in c else None,
                design.engine,
                h.bearing_materials(design, design.bearings, shaft.inputs),
                speed_ratio=design.views[original].shafts[0].speed_ratio,
                how=shaft.how,
                assembly=shaft.inputs.assembly,
                life=h.gears_life(design),
                compared=compared,
            )
        for shaft in h.turning(design):
            b.setdefault(shaft.name, b[shaft.of or shaft.name])  # a film does not know left from right
    no_bearings = None if b else part.absent("bearings", design.bearings, late)

    if design.gears is not None and g.result is not None and first_speed is not None:
        g = part("gears", gears.turning, _placed(part, g, design.gears, design, c), design.gears, first_speed)

    oil = h.mesh_oil(design)
    late = h.unsolved(tuple(b.values())) if no_bearings is None else h.unsolved((no_bearings,))
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
            h.on_shafts(design, c, b, g.result),
            first_speed,
            oil,
            materials,
            oils,
            undriven=h.undriven(design),
            compared=compared,
        )
    else:
        f = part.absent("friction", design.friction, (g, *late))
    f = friction.with_rated_power(
        f,
        h.rated_power(design),
        partial(h.on_rolling_instead, design, {name: shaft.result for name, shaft in c.items()}),
    )

    with trace() as lines:
        parts = h.parts_of_power(design, g.result, f)
    g = replace(g, lines=(*g.lines, *lines))
    c, b = _standing(design, c, b, g.result, f, parts)
    if g.result is not None and design.gears is not None:
        g = _rated(part, g, design.gears, design, e, c, f, parts)
        g = _on_engine(part, g, design, c, left)
        if i.result is not None and e.result is not None:
            g = part(
                "gears", left_over.one_tooth_off, g, i.result, h.system_shafts(design, c, teeth=True), h.rolls(e.result)
            )
    e = replace(e, computes=design.engine is None or design.engine.throw is None)
    i = replace(i, computes=True)
    m = _mounted(part, design, e, i, c, g)
    return _told(design, (e, i, g, f, m), c, left, b, no_bearings)


def _left_over(
    part: Parts,
    design: Design,
    e: EngineResult,
    i: ImbalanceResult,
    c: Shafts,
) -> Outcome[SystemResult]:
    """What all shafts together leave; waits where one of them has no solution."""
    if h.unsolved(tuple(c.values())):
        return Outcome("countershaft", "blocked")
    shafts = h.system_shafts(design, c, teeth=True)
    left = part(
        "countershaft",
        left_over.solve,
        i,
        shafts,
        h.rolls(e),
        e.angular_speed,
        h.made_shafts(design, c, shafts),
    )
    return replace(left, checks=(*left.checks, *shafts_clear(h.in_place(design, c), h.crank_sweeps(design))))


def _with_shafts(i: Outcome[ImbalanceResult], design: Design, left: Outcome[SystemResult]) -> Outcome[ImbalanceResult]:
    if left.result is None or design.imbalance is None:
        return i
    by_order = {n: (*found.forces, *found.couples) for n, found in left.result.vectors.items()}
    return imbalance.with_shafts(i, by_order, design.imbalance, several=len(h.turning(design)) > 1)


def _standing(
    design: Design,
    c: Shafts,
    b: dict[str, Outcome[BearingsResult]],
    train: TrainResult | None,
    f: Outcome[FrictionResult],
    parts: dict[str, Watt],
) -> tuple[Shafts, dict[str, Outcome[BearingsResult]]]:
    """Shafts and bearings with what stands still on them, once the balance has the power at each wheel; of twins those
    bearings that are not judged by their originals'."""
    housing = design.bearings.housing_stiffness if design.bearings else None
    for shaft in h.turning(design):
        name = shaft.name
        if name in c and c[name].result is not None:
            gear, drive = h.shaft_gear(design, train, name), h.shaft_drive(design, train, f, parts, name)
            carried = b[name].result if name in b else None
            of_shaft = with_standing(c[name], shaft.inputs, gear, drive, carried)
            of_shaft = with_oil_level(of_shaft, shaft.inputs, design.friction)
            stands = of_shaft.solution.standing
            if shaft.of is not None and not shaft.rows and name in b:
                twin = bearings_of_twin(b[name], stands, c[shaft.of].solution.standing)
                b = {other: each for other, each in b.items() if other != name} | ({name: twin} if twin else {})
            elif name in b:
                b = b | {name: bearings_with_standing(b[name], stands)}
                carried = b[name].result
            if shaft.of is None or shaft.rows:
                of_shaft = with_films(of_shaft, carried, housing)
            if shaft.of is None:
                of_shaft = with_oil(of_shaft, carried)
                of_shaft = with_bolts(of_shaft, shaft.inputs, h.on_support(design, shaft, c))
            c = c | {name: of_shaft}
    return c, b


def _told(
    design: Design,
    others: tuple[Outcome[object], ...],
    c: Shafts,
    left: Outcome[SystemResult],
    b: dict[str, Outcome[BearingsResult]],
    no_bearings: Outcome[object] | None,
) -> Solved:
    """The steps in the order of the screen, with the cautions on their inputs, by the keys of this design; those of
    several shafts joined."""
    e, i, g, f, m = _in_place(design, with_doubts(design, others))
    (sums,) = _in_place(design, (left,))
    of_shafts = dict[str, dict[str, Outcome[object]]]()
    for name, view in design.views.items():
        mine: list[Outcome[object]] = [each[name] for each in (c, b) if name in each]
        of_shafts[name] = {each.key: each for each in _in_place(view, with_doubts(view, mine))}
    own = {
        name: cast("Outcome[CountershaftResult]", of_shafts[name]["countershaft"]) for name in of_shafts if name in c
    }
    ratios = {shaft.name: shaft.inputs.speed_ratio for shaft in h.turning(design)}
    twins = dict[str, Outcome[CountershaftResult]]()
    twins_b = dict[str, Outcome[BearingsResult]]()
    for shaft in h.turning(design):
        if shaft.of is not None and shaft.name in c:
            (twins[shaft.name],) = _in_place(replace(design, shafts=(shaft.inputs,)), (c[shaft.name],))
        if shaft.of is not None and shaft.name in b:
            twins_b[shaft.name] = _of_twin(design, shaft, b[shaft.name])
            if shaft.rows:
                of_shafts[shaft.name] = {"bearings": twins_b[shaft.name]}
    whole = shafts.whole(own, twins, ratios, sums, named=len(design.shafts) > 1) if c else sums
    mine_b = {name: mine["bearings"] for name, mine in of_shafts.items() if "bearings" in mine}
    others_b = {name: twin for name, twin in twins_b.items() if name not in mine_b}
    of_originals = {shaft.name: b[shaft.of] for shaft in h.turning(design) if shaft.of in b}
    every_b = of_originals | b  # of a twin with nothing of its own those of its original
    carried = no_bearings or _joined(design, mine_b, others_b, every_b)
    accepted = design.accepted
    if accepted and (later := design.checked_later):
        accepted = tuple((id, reason) for id, reason in accepted if id not in later)
    if accepted:
        of_ids = {design.former_id(check.id): check.id for each in (whole, carried) for check in each.checks}
        accepted = tuple((of_ids.get(id, id), reason) for id, reason in accepted)
    every = judged((e, i, whole, carried, g, f, m), accepted)
    return Solved(every, of_shafts)


def _of_twin(design: Design, twin: Resolved, found: Outcome[BearingsResult]) -> Outcome[BearingsResult]:
    """The bearings of a twin, with the cautions on what it says of them itself, by the keys of this design."""
    said, keys_of, checks = design.said_by(twin), cache(design.in_twin(twin)), found.checks
    if said:
        far = doubts(design.with_bearings_of(twin.name), found.key)
        checks = (*(check for check in far if not said.isdisjoint(check.moved_by)), *checks)
    return replace(found, checks=tuple([check.in_place(keys_of) for check in checks]))


def _joined(
    design: Design,
    bearings: dict[str, Outcome[object]],
    twins: dict[str, Outcome[BearingsResult]],
    every_shaft: dict[str, Outcome[BearingsResult]],
) -> Outcome[object]:
    """The bearings of the one shaft, or of all of them by their names; `twins` that are not as their originals."""
    named = len(design.shafts) > 1
    solved = {name: each.result for name, each in bearings.items() if isinstance(each.result, BearingsResult)}
    told = {name: bearings_told(each.solution) for name, each in twins.items()}
    every, all_lives = None, tuple[Check, ...]()
    if named and len(solved) == len(bearings):
        there = [each.result for each in every_shaft.values() if each.result is not None]
        life, all_lives = lives_of_all(there)
        every = BearingsOfShafts(shafts={**solved, **told}, system_life=life)
    outcome = joined("bearings", {**bearings, **twins}, every, named=named)
    return replace(outcome, checks=(*outcome.checks, *all_lives)) if all_lives else outcome


def _in_place(design: Design, outcomes: Iterable[Outcome[R]]) -> Iterator[Outcome[R]]:
    """The outcomes with their checks by the keys of this design."""
    keys_of = cache(design.in_place)  # many checks are moved by the same keys
    for outcome in outcomes:
        yield replace(outcome, checks=tuple([check.in_place(keys_of) for check in outcome.checks]))


def _on_engine(
    part: Parts, g: Outcome[TrainResult], design: Design, c: Shafts, left: Outcome[SystemResult]
) -> Outcome[TrainResult]:
    """A train that is complete: what its backlash leaves of what the shafts balance, the window of that backlash,
    whether they turn as they must, and its curves."""
    g = gears.with_residuals(g, h.balanced(c))
    if design.gears is not None:
        g = gears.with_coats(g, design.gears)
        g = gears.with_window(g, design.gears, h.may_leave(c, left))
    g = gears.with_speed_ratios(g, h.ratios(design), design.engine)
    made = Later(partial(drive_curves, g.solution.drive)), Later(partial(curves, g.solution))
    return replace(g, curves=g.curves + made[0] + made[1])


def _mounted(
    part: Parts,
    design: Design,
    e: Outcome[EngineResult],
    i: Outcome[ImbalanceResult],
    c: Shafts,
    g: Outcome[TrainResult],
) -> Outcome[object]:
    """The engine on its mounts, which most designs do not ask for."""
    late = h.unsolved((e, i, *c.values()))
    if design.mounting is None or design.engine is None or e.result is None or i.result is None or late:
        return part.absent("mounting", design.mounting, (e, i, *late))
    on_engine = h.shafts_on_engine(design, c, g)
    return part("mounting", mounting.solve, design.mounting, design.engine, e.result, i.result, on_engine)


def _placed(
    part: Parts, g: Outcome[TrainResult], inputs: GearsInputs, design: Design, c: Shafts
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
    c: Shafts,
    f: Outcome[FrictionResult],
    parts: dict[str, Watt],
) -> Outcome[TrainResult]:
    """Its motion over speed, its rating and its forces, once the closed balance has the power of every mesh."""
    work = h.crank_at_work(design, e, c, g.solution, f)
    if work is not None:
        driven = part("gears", gears.over_speed, inputs, g.solution, work, design.materials)
        if driven.state != "solved":
            g = gears.without(g, gears.DRIVE, driven.reason)
        else:
            g = gears.with_drive(g, driven)
    power = h.power(inputs, f, parts)
    if power is None:
        return _struck(part, gears.not_rated(g, h.not_rated(f)), inputs, None)
    uneven = g.solution.drive.torques if g.solution.drive is not None else None
    rated = part("gears", gears.rating, inputs, g.solution, power, design.materials, h.around_gears(design, uneven))
    if rated.state != "solved":
        return gears.without(g, gears.RATING, rated.reason)
    return _struck(part, gears.with_forces(gears.merge(g, rated), inputs), inputs, rated.solution.context)


def _struck(
    part: Parts, g: Outcome[TrainResult], inputs: GearsInputs, context: RatingContext | None
) -> Outcome[TrainResult]:
    """With what the strikes do to the teeth; the train keeps its values where that has no solution."""
    told = part("gears", gears.struck, g, inputs, context)
    return told if told.state == "solved" else gears.without(g, gears.DRIVE, told.reason)
