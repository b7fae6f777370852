# SPDX-License-Identifier: Apache-2.0
"""Missing steps built by rules: a design with one step more, or with all that the balancing of its engine asks for."""

import math
from collections.abc import Callable, Mapping
from functools import cache
from itertools import product

from ...countershaft.inputs import ShaftInputs
from ...countershaft.rows import BearingRow
from ...design.addresses import Table, as_list, as_table, asks, own_shafts
from ...design.model import IN_SENTENCES, STEPS, Design
from ...design.toml_file import Document, design
from ...engine.crank import crank
from ...engine.inputs import EngineInputs
from ...engine.result import EngineResult
from ...gears.inputs import GearsInputs
from ...imbalance.checks import BACKWARD_COUPLE, BACKWARD_FORCE, FORWARD_COUPLE, FORWARD_FORCE
from ...imbalance.result import ImbalanceResult
from ...mounting.inputs import Mount, MountingInputs, Point
from ...mounting.result import MountingResult
from ...sheet.errors import BadInput, NoSolution, text_of
from ...sheet.quantity import dotted, keys
from ...sheet.record import record, replace
from ...sheet.text import EMPTY, Text
from ...sheet.units import Metre
from ...sheet.value import recorded
from ...solve import Results, solve
from ..ready import CRANK_ALONE, NO_BEARINGS, NO_TRAIN, NONE, NOTHING
from . import balancing as which
from . import bearings, rolling, several, shaft, train
from .writing import Rows, Section, head, mm, table, up, written

# --- the engine on four mounts at its corners
# Mass and size by rule of thumb, to be weighed and measured; stiffness for its six modes to lie between the road's
# frequency and what shakes at idle.

PER_LITRE = 110.0  # kg
IDLE, SLOWEST, FASTEST = 0.33, 700.0, 1000.0  # share of the rated speed; rpm
SHEAR = 0.45  # stiffness across a mount of rubber over that in compression
FIRST = 100.0  # N/mm, to be scaled: every frequency goes with the root


def mounting(document: Document, results: Results) -> list[Section]:
    """Raises NoSolution where the engine is not known."""
    engine, known = results.design.engine, results.result(EngineResult)
    if engine is None or known is None:
        raise NoSolution(Text("what stands on the mounts is not known"), EMPTY, Text("give [engine] first"))
    mass = up(PER_LITRE * known.displacement * 1e3, 5.0)
    sections = _sections(engine, mass, FIRST)
    solved = solve(design(Document({**document.data, **table(sections)})), results).result(MountingResult)
    return _sections(engine, mass, up(FIRST * _scale(solved), 1.0)) if solved is not None else sections


def _scale(solved: MountingResult) -> float:
    """From the first stiffness to the middle of the window, as it is seen on a scale of ratios."""
    window = solved.window
    highest = [ceiling.highest_factor for ceiling in (window.half, window.shaft) if ceiling is not None]
    return math.sqrt(window.lowest_factor * min(highest)) if highest else window.lowest_factor


def _size(engine: EngineInputs) -> tuple[Metre, Metre, Metre]:
    """Up, to the side, along the crank; a bank that leans gives of its height to the side."""
    placed = crank(engine, 0.0)
    upright, leaning = max(map(math.cos, placed.psi)), max(abs(math.sin(psi)) for psi in placed.psi)
    reach = 2.5 * (2 * engine.crank_radius + engine.rod_length)
    height = max(reach * upright, 4 * engine.bore)
    width, length = 5 * engine.bore + reach * leaning, float(max(placed.z) - min(placed.z)) + 3 * placed.pitch
    return up(height, 10e-3), up(width, 10e-3), up(length, 10e-3)


def _sections(engine: EngineInputs, mass: float, stiffness: float) -> list[Section]:
    height, width, length = _size(engine)
    idle = min(FASTEST, max(SLOWEST, up(IDLE * engine.rated_speed * 60, 50.0)))
    across = up(SHEAR * stiffness, 1.0)
    sections: list[Section] = []
    engine_rows: Rows = {
        MountingInputs.mass: (mass, "assumed: 110 kg a litre, with liquids and flywheel; weigh it"),
        MountingInputs.centre_of_gravity: ([mm(up(0.12 * height, 5e-3)), 0.0, 0.0], "assumed: above the crank, midway"),
        MountingInputs.dimensions: (
            [mm(height), mm(width), mm(length)],
            "assumed from stroke, rod, bore and pitch; the inertia follows",
        ),
        MountingInputs.idle_speed: (idle, "assumed: a third of the rated speed, 700 to 1000 rpm"),
    }
    sections.append((head(Design.mounting), engine_rows))
    for (end, z), (side, y) in product((("front", -1), ("rear", 1)), (("left", -1), ("right", 1))):
        corner = [mm(-2 * engine.crank_radius), mm(y * width / 2), mm(z * 0.4 * length)]
        mount: Rows = {
            Mount.name: (f"{end}-{side}", ""),
            Mount.position: (corner, "assumed: corners, below the crank"),
            Mount.stiffness: (
                [stiffness, across, across],
                "assumed: the modes between the road and what shakes at idle",
            ),
        }
        sections.append((head(Design.mounting, MountingInputs.mounts), mount))
    top = [mm(up(0.7 * height, 5e-3)), 0.0, 0.0]
    point: Rows = {Point.name: ("top", ""), Point.position: (top, "assumed: on the head")}
    return [*sections, (head(Design.mounting, MountingInputs.points), point)]


# --- the steps built

SHAFT_STEPS = ("countershaft", "bearings", "gears", "friction")
TABLES = (dotted(Design.shafts), *SHAFT_STEPS[1:])
ROWS, NAME = dotted(ShaftInputs.bearings), dotted(BearingRow.name)
SHAFTS = dotted(Design.shafts)
KINDS = (rolling.ROLLING, rolling.NEEDLE)  # of which all bearings may be asked for
# needles have rings, or, where none with rings live long enough, roll on the shaft itself, wider and on less
TRIED = {rolling.NEEDLE: (rolling.NEEDLE, rolling.CAGE)}
NO_CHOICE: Mapping[str, str] = {}
KEPT = {
    "none": 0.0,
    "half": 0.5,
    "shaft": 0.5,
    "repeat": 0.5,
    "pair": 0.0,
    "pair_and_second": 0.0,
}  # the share of the reciprocating masses on the crank
LEFT = "left to the mounts by the balancing that was chosen"
TAKEN = "the pair of shafts at crank speed takes it"


def built(document: Document, step: str, choice: str = "") -> Document:
    """The document with the tables of a step, by the rules behind `new`.

    For "imbalance" and "countershaft" `choice` is the id of one of `options`; left out, the one that the engine
    calls for.  It takes the place of the one before: what no longer fits the shaft goes.  For "bearings" it is the kind
    of all of them, one of `KINDS`; left out, the one that the rules take.  Raises NoSolution with what was tried,
    BadInput where the design that there is can not be understood."""
    builders: dict[str, Callable[[], Document]] = {
        "imbalance": lambda: _imbalance(document, choice),
        "countershaft": lambda: _balanced(document, choice),
        "bearings": lambda: _bearings(document, choice) if choice else _bearings_by_rule(document),
        "gears": lambda: _with(document, train.gears(_put(document, {}, ("friction",)), _results(document))),
        "friction": lambda: _with(document, train.friction(document, _results(document))),
        "mounting": lambda: _with(document, mounting(document, _results(document))),
    }
    if step not in builders:
        raise NoSolution(Text("the step {step} is not built by rules", step=IN_SENTENCES.get(step, step)))
    if why := hindrance(document, step):
        raise NoSolution(why)
    if step in SHAFT_STEPS[1:]:
        document = _put(document, {}, (step,))  # one that was left out comes back
    with recorded(False):
        return builders[step]()


def to_build(data: Table) -> list[str]:
    """The steps that a design has still to do, in their order, and that rules build: those that nobody has left out."""
    without = as_table(data.get("without"))
    return [s.key for s in STEPS if not (s.optional or asks(data, s.key) or s.key in without or s.key == "engine")]


def all_built(document: Document, choices: Mapping[str, str] = NO_CHOICE) -> tuple[Document, Text]:
    """With all that is still to do, step by step; as far as the rules come, and why they come no further.

    `choices`: of a step what was asked for, as `built` takes it; nothing else is built instead."""
    while steps := to_build(document.data):
        # the balancing builds crank and shaft in one
        step = "countershaft" if steps[:2] == ["imbalance", "countershaft"] else steps[0]
        try:
            document = built(document, step, choices.get(step, ""))
        except (BadInput, NoSolution) as error:
            return document, text_of(error)
        if to_build(document.data) == steps:  # the balancing that was chosen has no shaft
            return document, Text("the step {step} is not built by rules", step=IN_SENTENCES[step])
    return document, EMPTY


def hindrance(document: Document, step: str) -> Text:
    """Why the rules can not build a step for the shaft that the design has, or has not; empty where nothing stands
    against it."""
    if step not in SHAFT_STEPS[1:]:
        return EMPTY
    if own_shaft(document.data):
        pass
    elif step == "bearings" or "countershaft" in as_table(document.data.get("without")):
        return Text("there is no shaft yet: the step Counter-shaft comes first")
    if step == "friction" and "gears" not in document.data:
        return Text("there are no wheels yet: the step Gears comes first")
    return EMPTY


@record
class Begun:
    """The text of all tables after engine and imbalance, and the rows that [engine] has more, by their key."""

    text: str
    engine: dict[str, list[Table]]


def begun(document: Document, balancing: str = "", why: str = "", kinds: tuple[str, ...] = ()) -> Begun:
    """All tables after engine and imbalance that a design to begin with has, what it does without among them.

    `balancing`: the id of one of `options`, left out the one that the engine calls for; `why`: of an engine that has no
    shaft, the reason; `kinds`: of the bearings with which it is built, as `bearings.carried` takes them.  Raises
    NoSolution where the engine has nothing that it takes."""
    results = _results(document)
    balancing = _option(results, balancing or which.called_for(results)).id
    if why or balancing in ("none", "half"):
        none: list[Section] = [
            ("[without]", {step: (why or _none_reason(results, balancing), "") for step in SHAFT_STEPS})
        ]
        return Begun(written([*none, *_accepting(document, LEFT)]), {})
    accepted = [] if balancing in ("shaft", "repeat") else _accepting(document, TAKEN if "pair" in balancing else LEFT)
    missing: Rows = {}
    before = document

    def shafts(kinds: tuple[str, ...]) -> bearings.Unborne:
        if balancing == "shaft":
            own = shaft.countershaft(before, results, -1)
        else:
            own = several.shafts(before, results, _arranged(balancing, results), kinds)
        made = _with(before, own)
        return bearings.Unborne(made, _results(made, results), own)

    try:
        found = bearings.carried(cache(shafts), kinds)
        document, own = found.document, found.sections
    except bearings.NoBearings as no_bearings:
        missing["bearings"] = (NO_BEARINGS, f"stopped by {no_bearings.tried}")
        without_them = shafts(())
        document, own = _without(without_them.document, {"bearings": NO_BEARINGS}), without_them.shafts
    train_of: list[Section] = []
    try:
        train_of = train.gears_and_friction(document, _results(document, results))
    except NoSolution as no_train:
        missing |= {"gears": (NO_TRAIN, f"stopped by {no_train.tried}"), "friction": (NO_TRAIN, "")}
    without = [("[without]", missing)] if missing else []
    text = "".join(written(sections) for sections in (accepted, without, own, train_of))
    engine, known = (as_table(each.data[dotted(Design.engine)]) for each in (document, before))
    more = {key: [as_table(row) for row in as_list(rows)] for key, rows in engine.items() if key not in known}
    return Begun(text, more)


def own_shaft(data: Table) -> Table:
    """The shaft of a document that is no twin; empty where there is none, or only its bearings."""
    shafts = own_shafts(data).values() if asks(data, "countershaft") else ()
    return next(iter(shafts), {})


def choice_made(document: Document) -> str:
    """The id of the balancing that the design has now; "" where nothing is chosen yet."""
    shafts = own_shafts(document.data).values() if own_shaft(document.data) else ()
    ratios = {shaft.get(dotted(ShaftInputs.speed_ratio)) for shaft in shafts}
    if ratios == {-1}:
        twins = map(as_table, as_list(document.data.get(dotted(Design.shafts))))
        return "repeat" if any(dotted(ShaftInputs.repeats) in shaft for shaft in twins) else "shaft"
    if ratios:
        return "pair_and_second" if len(ratios) > 1 else "pair" if ratios == {1} else "second"
    if "countershaft" not in as_table(document.data.get("without")):
        return ""
    return "half" if as_table(document.data.get("imbalance")).get(which.ON_CRANK, 0.5) else "none"


# --- one step


def _imbalance(document: Document, balancing: str) -> Document:
    """With the share of the reciprocating masses that the balancing has on the crank."""
    known = which.with_imbalance(document)
    share = _share(balancing or which.called_for(known), known)
    given = as_table(document.data.get("imbalance")) or which.IMBALANCE
    return _put(document, {"imbalance": {**given, which.ON_CRANK: share}})


def _share(balancing: str, known: Results) -> float:
    """Against order 2 the crank keeps what takes order 1: half, unless its throws cancel and it has nothing to take."""
    if balancing in KEPT:
        return KEPT[balancing]
    return 0.5 if any(remainder.key.startswith("order_1") for remainder in _option(known, balancing).left) else 0.0


def _option(known: Results, balancing: str) -> which.Balancing:
    """Raises NoSolution where the engine has nothing that it takes."""
    option = next((option for option in which.options(Document({}), known) if option.id == balancing), None)
    if option is None:
        raise NoSolution(Text('the balancing "{id}" has nothing to take in this engine', id=balancing))
    return option


def _balanced(document: Document, balancing: str) -> Document:
    """Crank and shaft of one balancing, and what is then done without."""
    known = which.with_imbalance(document)
    balancing = _option(known, balancing or which.called_for(known)).id
    # what another balancing accepted
    others = {id: why for id, why in as_table(document.data.get("accepted")).items() if why not in (LEFT, TAKEN)}
    document = _imbalance(_put(document, {"accepted": others or None}), balancing)
    if balancing in ("none", "half"):
        why = NONE if balancing == "none" else _none_reason(known, balancing)
        return _accepted(_without(document, dict.fromkeys(SHAFT_STEPS, why)), LEFT)
    bare = _put(document, dict.fromkeys(TABLES), SHAFT_STEPS)
    imbalanced = which.with_imbalance(bare)
    if balancing != "shaft":
        bare = _with(bare, several.shafts(bare, imbalanced, _arranged(balancing, known)))
        return _accepted(bare, TAKEN if "pair" in balancing else LEFT) if balancing != "repeat" else bare
    bare = _with(bare, shaft.countershaft(bare, imbalanced, -1))
    there = _carried(bare, document) if dotted(Design.bearings) in document.data else bare
    kept = _put(there, {step: document.data[step] for step in SHAFT_STEPS[1:] if step in document.data})
    return kept if _holds(kept) else bare


def _carried(document: Document, before: Document) -> Document:
    """With the bearings of the design before, of the same names, where those of this one's shaft stand."""
    rows = {row.get(NAME): row for row in map(as_table, as_list(own_shaft(before.data).get(ROWS)))}
    there = map(as_table, as_list(own_shaft(document.data).get(ROWS)))
    bearings = [{**rows.get(row.get(NAME), {}), **row} for row in there]
    return document.with_value(dotted(Design.shafts, 0, ShaftInputs.bearings), bearings)


def _arranged(balancing: str, known: Results) -> tuple[several.Arranged, ...]:
    imbalance = known.result(ImbalanceResult)
    assert imbalance is not None
    return several.arrangement(balancing, imbalance)


def _holds(document: Document) -> bool:
    """Whether no limit of a design fails: what was made for another shaft may not fit this one."""
    try:
        verdicts = {outcome.verdict for outcome in _results(document).outcomes.values()}
    except BadInput:
        return False
    return verdicts.isdisjoint(("fail", "no_solution", "blocked"))


def _bearings(document: Document, kind: str) -> Document:
    """With bearings of one kind; shafts that are still as the rules have them for plain ones are made for it.  Raises
    NoSolution where none of it carry, with what the nearest comes to."""
    alone = _put(document, {"gears": None, "friction": None})
    made_for = _ruled(alone)
    none: NoSolution | None = None
    for form in TRIED.get(kind, (kind,)):
        try:
            on_it = made_for(form) if made_for is not None else alone
            found = bearings.on_rolling(bearings.Unborne(on_it, _results(on_it), []), (form, form)).document
        except NoSolution as error:
            none = error if none is None or _nearest(error) > _nearest(none) else none
            continue
        same = on_it.data.get(SHAFTS) == document.data.get(SHAFTS)
        return _put(found, _train_of(document) if same else {}, (dotted(Design.bearings),))
    assert none is not None
    raise none


def _nearest(none: NoSolution) -> float:
    return none.nearest if isinstance(none, rolling.NoneCarries) else 0.0


def _ruled(document: Document) -> Callable[[str], Document] | None:
    """The document with its shafts made for bearings of a kind, where they are still as the rules have them."""
    if (balancing := choice_made(document)) not in ("second", "repeat", "pair", "pair_and_second"):
        return None
    bare = _put(document, dict.fromkeys(TABLES))
    known = which.with_imbalance(bare)
    arranged = _arranged(balancing, known)
    if _with(bare, several.shafts(bare, known, arranged)).data[SHAFTS] != document.data[SHAFTS]:
        return None
    return lambda kind: _with(bare, several.shafts(bare, known, arranged, (kind, kind)))


def _bearings_by_rule(document: Document) -> Document:
    """With bearings by the rule behind `new`, or the word that there are none."""
    # which asks for the oil of the bearings, as the wheels ask for their loss
    alone = _put(document, {"gears": None, "friction": None})
    if _is_one_at_minus_one(document) and "gears" in document.data:
        alone = _put(document, {"friction": None}).with_value(dotted(Design.gears, GearsInputs.power), 1.0)
    try:
        found = bearings.carried(lambda _: bearings.Unborne(alone, _results(alone), [])).document
    except bearings.NoBearings:
        return _without(document, {"bearings": NO_BEARINGS})
    return _put(found, _train_of(document), (dotted(Design.bearings),))


def _train_of(document: Document) -> Table:
    return {step: document.data[step] for step in ("gears", "friction") if step in document.data}


def _is_one_at_minus_one(document: Document) -> bool:
    return len(as_list(document.data.get(dotted(Design.shafts)))) == 1 and choice_made(document) == "shaft"


def _none_reason(known: Results, balancing: str) -> str:
    return NOTHING if which.called_for(known) != "shaft" else CRANK_ALONE if balancing == "half" else NONE


FIRST_ORDER = (BACKWARD_COUPLE, BACKWARD_FORCE, FORWARD_COUPLE, FORWARD_FORCE)


def _accepted(document: Document, why: str) -> Document:
    """With what the balancing leaves, or takes otherwise, accepted for its reason: it was chosen."""
    left = dict.fromkeys(_open_of_first(document), why)
    return _put(document, {"accepted": {**as_table(document.data.get("accepted")), **left} or None})


def _accepting(document: Document, why: str) -> list[Section]:
    """The same as a table to be written."""
    rows: Rows = {f'"{id}"': (why, "") for id in _open_of_first(document)}
    return [("[accepted]", rows)] if rows else []


def _open_of_first(document: Document) -> list[str]:
    checks = _results(Document(shaft.before_shaft(document))).checks()
    return [c.id for c in checks if c.open and c.rule in FIRST_ORDER]


# --- documents


def _results(document: Document, before: Results | None = None) -> Results:
    return solve(design(document), before)


def _with(document: Document, sections: list[Section]) -> Document:
    """With these tables, which are then no longer left out."""
    tables = table(sections)
    steps = ["countershaft" if key == dotted(Design.shafts) else key for key in tables]
    return _put(document, tables, tuple(steps))


def _without(document: Document, reasons: dict[str, str]) -> Document:
    """Without these steps, each for its reason."""
    given = {key: value for key, value in as_table(document.data.get("without")).items() if key not in reasons}
    gone = [dotted(Design.shafts) if step == "countershaft" else step for step in reasons]
    return _put(document, {**dict.fromkeys(gone), "without": {**given, **reasons}})


def _put(document: Document, tables: Mapping[str, object], asked: tuple[str, ...] = ()) -> Document:
    """With tables put in or taken out (None), in the order of a design file; steps that are asked for are not left out
    any more."""
    data = {**document.data, **tables}
    without = {key: why for key, why in as_table(data.get("without")).items() if key not in asked}
    data["without"] = without or None
    order = [*keys(Design), *data]  # keys that are not known last
    known = sorted((key for key, value in data.items() if value is not None), key=order.index)
    return replace(document, data={key: data[key] for key in known})
