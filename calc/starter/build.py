# SPDX-License-Identifier: Apache-2.0
"""Missing steps built by rules: a design with one step more, or with all that the balancing asks for which its engine calls."""

from collections.abc import Callable
from dataclasses import replace

from ..addresses import Table, as_table
from ..design import Design
from ..design_file import Document, design
from ..imbalance.result import ImbalanceResult
from ..sheet.errors import NoSolution
from ..sheet.quantity import keys
from ..sheet.text import Text
from ..solve import Results, solve
from . import balancing as which
from . import journals, shaft, train
from .writing import Section, table, written

SHAFT_STEPS = ("countershaft", "bearings", "gears", "friction")
KEPT = {"none": 0.0, "half": 0.5, "shaft": 0.5, "pair": 0.0}  # the share of the reciprocating masses on the crank
ROLLING = "rolling bearings carry the shaft: a plain journal of usual length passes the heat index at this load and speed"
APART = "not designed here for shafts that do not turn at -1 times crank speed"
NONE = "no shaft: what shakes is left to the mounts"
NOTHING = "nothing of order 1 turns backward, so no shaft at -1 is needed"
CRANK_ALONE = "no shaft: the counterweights of the crank are all the balancing"


def built(document: Document, step: str, balancing: str = "") -> Document:
    """The document with the tables of a step, by the rules behind `new`.

    For "imbalance" and "countershaft" `balancing` is the id of one of `options`; left out, the one that the engine calls for.  It takes
    the place of the one before: what no longer fits the shaft goes.  Raises NoSolution with what was tried, BadInput where the design
    that there is can not be understood.
    """
    builders: dict[str, Callable[[], Document]] = {
        "imbalance": lambda: _imbalance(document, balancing),
        "countershaft": lambda: _balanced(document, balancing),
        "bearings": lambda: _bearings(document),
        "gears": lambda: _with(document, train.gears(document, _results(document))),
        "friction": lambda: _with(document, train.friction(document, _results(document))),
    }
    if step not in builders:
        raise NoSolution(Text("the step {step} is not built by rules", step=step))
    return builders[step]()


def begun(document: Document) -> str:
    """The text of all tables after engine and imbalance that a design to begin with has, what it does without among them."""
    results = _results(document)
    best = which.called_for(results)
    if best != "shaft":
        return written([("[without]", {step: (_none_reason(results, best), "") for step in SHAFT_STEPS})])
    text, without = [shaft.countershaft(document, results, -1)], {}
    document = _with(document, text[0])
    results = _results(document, results)
    try:
        text.append(journals.bearings(document, results))
    except NoSolution:
        without["bearings"] = (ROLLING, "")
        document = _without(document, {"bearings": ROLLING})
    else:
        document = _with(document, text[-1])
    text.append(train.gears_and_friction(document, _results(document, results)))
    return "".join(written(sections) for sections in ([("[without]", without)] if without else [], *text))


def choice_made(document: Document) -> str:
    """The id of the balancing that the design has now; "" where nothing is chosen yet."""
    if (given := as_table(document.data.get("countershaft"))):
        ratio = given.get("speed_ratio", -1)
        return "shaft" if ratio == -1 else "pair" if ratio == 1 else "second"
    if "countershaft" not in as_table(document.data.get("without")):
        return ""
    return "half" if as_table(document.data.get("imbalance")).get("crank_balance_fraction", 0.5) else "none"


# --- one step -------------------------------------------------------------------------------------------------------------
def _imbalance(document: Document, balancing: str) -> Document:
    """With the share of the reciprocating masses that the balancing has on the crank."""
    known = which.with_imbalance(document)
    share = _share(balancing or which.called_for(known), known)
    own = as_table(document.data.get("imbalance")) or which.IMBALANCE
    return _put(document, {"imbalance": {**own, "crank_balance_fraction": share}})


def _share(balancing: str, known: Results) -> float:
    """Against order 2 the crank keeps what takes order 1: half, unless its throws cancel and it has nothing to take."""
    if balancing in KEPT:
        return KEPT[balancing]
    imbalance = known.result(ImbalanceResult)
    assert imbalance is not None
    left = {one.key: one for one in next(o for o in which.options(Document({}), known) if o.id == "none").left}
    return 0.5 if {"order_1_force", "order_1_couple"} & left.keys() else 0.0


def _balanced(document: Document, balancing: str) -> Document:
    """Crank and shaft of one balancing, and what is then done without."""
    known = which.with_imbalance(document)
    balancing = balancing or which.called_for(known)
    if balancing not in {one.id for one in which.options(document, known)}:
        raise NoSolution(Text('the balancing "{id}" has nothing to take in this engine', id=balancing))
    document = _imbalance(document, balancing)
    if balancing in ("none", "half"):
        why = NONE if balancing == "none" else _none_reason(known, balancing)
        return _without(document, dict.fromkeys(SHAFT_STEPS, why))
    ratio, pair = _speed(balancing, known)
    kept = SHAFT_STEPS[1:] if ratio == -1 else ()
    bare = _put(document, {step: None for step in SHAFT_STEPS if step not in kept}, SHAFT_STEPS)
    sections = shaft.countershaft(bare, which.with_imbalance(bare), ratio, pair)
    bare = _with(bare, sections)
    return bare if ratio == -1 else _without(bare, dict.fromkeys(SHAFT_STEPS[1:], APART))


def _speed(balancing: str, known: Results) -> tuple[int, bool]:
    """Of the shaft that the design has, and whether a mirrored one turns against it."""
    if balancing in ("shaft", "pair"):
        return (-1, False) if balancing == "shaft" else (1, True)
    imbalance = known.result(ImbalanceResult)
    assert imbalance is not None
    speed = which.second_shafts(imbalance) if balancing == "second" else None
    if speed is None:
        raise NoSolution(Text("a design has one shaft or a mirrored pair of them; this balancing asks for others"))
    return speed


def _bearings(document: Document) -> Document:
    """Plain bearings, or the word that rolling ones carry the shaft."""
    try:
        sections = journals.bearings(document, _results(document))
    except journals.TooFast:
        return _without(document, {"bearings": ROLLING})
    return _with(document.with_value("countershaft.journals", None), sections)


def _none_reason(known: Results, balancing: str) -> str:
    return NOTHING if which.called_for(known) != "shaft" else CRANK_ALONE if balancing == "half" else NONE


# --- documents ------------------------------------------------------------------------------------------------------------
def _results(document: Document, before: Results | None = None) -> Results:
    return solve(design(document), before)


def _with(document: Document, sections: list[Section]) -> Document:
    """With these tables, which are then no longer left out."""
    made = table(sections)
    return _put(document, made, tuple(made))


def _without(document: Document, reasons: dict[str, str]) -> Document:
    """Without these steps, each for its reason."""
    given = {key: value for key, value in as_table(document.data.get("without")).items() if key not in reasons}
    return _put(document, {**dict.fromkeys(reasons), "without": {**given, **reasons}})


def _put(document: Document, tables: "dict[str, Table | None] | Table", asked: tuple[str, ...] = ()) -> Document:
    """With tables put in or taken out (None), in the order of a design file; steps that are asked for are not left out any more."""
    data = {**document.data, **tables}
    without = {key: why for key, why in as_table(data.get("without")).items() if key not in asked}
    data["without"] = without or None
    order = [field.key for field in keys(Design).values()]
    known = {key: value for key, value in data.items() if value is not None}
    return replace(document, data={key: known[key] for key in sorted(known, key=lambda key: order.index(key) if key in order else len(order))})
