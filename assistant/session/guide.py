# SPDX-License-Identifier: Apache-2.0
"""The route through a design: the question of each step, where its inputs lie in the form, guidance, and what is taken
over.

The few inputs that decide a step come first, the rest in folds; the inputs themselves say which, and what they do not
say, the table that they stand in does.  What is in no fold of its own is in the first one."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache

from calc.countershaft.rows import BearingRow
from calc.design.addresses import Table, as_table, asks, quantities, step_at
from calc.design.labels import SHAFTS, Place, content_at, with_bearings
from calc.design.model import IN_SENTENCES, STEP_KEYS, STEPS, Design
from calc.design.upgrade import is_twin
from calc.library.journal_rules import SLOPE, USUAL_CLEARANCE, USUAL_LENGTH
from calc.sheet.quantity import Published, Quantity, dotted, keys
from calc.sheet.step import Step
from calc.sheet.text import COMMA, EMPTY, Amount, Text

from .places import described, owner, row_of_original

MORE = Text("More")
STROKE = "stroke_mm"  # twice the crank radius, which the design file has
NAME: Place = ("name",)  # of the design itself: asked with its engine, which comes first
NOTE, DOCUMENT = ("note",), ("document",)  # in a fold behind those of its first step
FIRST, BEARINGS = "engine", dotted(Design.bearings)


@cache
def folds(step: str) -> tuple[Text, ...]:
    """The folds of a step's form, in the order in which its inputs name them."""
    inputs = [known.inputs for known in STEPS if known.key == step]
    inputs += [BearingRow] if step == BEARINGS else []
    return MORE, *dict.fromkeys(about.fold for cls in inputs for about in _all_in(cls) if about.fold)


def _all_in(inputs: type) -> Iterator[Quantity]:
    for key in keys(inputs).values():
        yield key.about
        if key.about.table is not None:
            yield from _all_in(key.about.table)


FOLD = "+"  # with which the place of a fold itself begins, behind its step: no place in a design


def layout_of(place: Place) -> Quantity | None:
    """What says where an input of a step lies in the form: the innermost on the way to it that decides or names a
    fold."""
    way = (described(place[:end]) for end in range(len(place), 1, -1) if isinstance(place[end - 1], str))
    return next((about for about in way if about.decides or about.fold), None)


def idle(place: Place, data: Table) -> bool:
    """Whether an input says nothing in this design: it has no value, or the only one there is."""
    if len(place) < 2:
        return False
    about = described(place)
    if about.kind == "choice" and len(about.choices) == 1:
        return content_at(data, place) in (None, *about.choices)
    if (where := about.where) is None:
        return False
    table = content_at(with_bearings(data, place), place[:-1])
    if isinstance(table, dict) and owner(place) is BearingRow:  # of which rules what it says itself
        table = as_table(data.get(BEARINGS)) | row_of_original(data, place[:-1]) | table
    return isinstance(table, dict) and not where.holds(table) and content_at(data, place) in (None, [])


def of_twin(place: Place, data: Table) -> bool:
    """Whether a place is that of a shaft that mirrors or repeats another, or lies in it."""
    return len(place) > 1 and place[:1] == SHAFTS and is_twin(as_table(content_at(data, place[:2])))


def all_decides(step: str, place: Place, data: Table) -> bool:
    """Whether a place is in a twin, which has little of its own; what it says of its bearings lies as that of any."""
    return of_twin(place, data) and (step != BEARINGS or owner(place) is not BearingRow)


def step_of(place: Place, data: Table) -> str:
    """The step whose form asks for an input."""
    return FIRST if place[:1] in (DOCUMENT, NAME, NOTE) else step_at(data, ".".join(map(str, place)))


def title_of(step: Step, data: Table) -> Text:
    """What a step is called in this design."""
    several = step.key == "countershaft" and len(content_at(data, SHAFTS) or ()) > 1
    return Text("Balance shafts") if several else step.title


def document_fold() -> int:
    """The number of the fold of note and document control, behind those of the step."""
    return len(folds(FIRST))


def fold_at(step: str, place: Place, data: Table) -> int | None:
    """The fold of a step's form that a place lies in; None where it decides, and of what is not in the form."""
    if not str(place[-1]).startswith(FOLD) and step_of(place, data) != step:
        return None
    if place[:1] in (DOCUMENT, NAME, NOTE):
        return document_fold()
    if len(place) < 2 or str(place[1]).startswith(FOLD) or all_decides(step, place, data):
        return None
    about = layout_of(place)
    return 0 if about is None else None if about.decides else folds(step).index(about.fold)


# --- guidance through the steps


@dataclass(frozen=True)
class Guide:
    """The question of a step, what Enter makes of it where the design does not have it (`builds`), what is to be
    decided, what a good answer looks like, what to try when a check fails, and what else one may call what it is about
    (`words`)."""

    question: Text
    builds: Text
    decide: Text
    good: Text
    trying: Text
    words: Text


GUIDES: dict[str, Guide] = {
    "engine": Guide(
        Text("Which engine shakes?"),
        Text("build it by rules: an inline engine to begin with"),
        Text("Which engine: layout, crank, masses of piston and rod, rated speed. Everything else follows from it."),
        Text("Masses as weighed, the rod's centre of gravity too."),
        Text(
            "Weigh instead of estimating. The firing order can be chosen from a table, the one that leaves least first."
        ),
        Text("layout conrod connecting rod cylinders"),
    ),
    "imbalance": Guide(
        Text("Which balancing?"),
        Text("build it by rules: the balancing that the engine calls for"),
        Text(
            "How much of the reciprocating mass the crank's own counterweights carry, and so what is left for a "
            "counter-shaft."
        ),
        Text("Little left, by little mass: the row marked ◀ is what this engine calls for."),
        Text(
            "Second order is out of reach of one shaft: lighter pistons, a longer rod, two shafts at twice the speed, "
            "or good engine mounts."
        ),
        Text("vibration vibrate shaking shake smooth inertia forces moments"),
    ),
    "countershaft": Guide(
        Text("Which shaft: given masses, or sized in an envelope?"),
        Text("build it by rules: a shaft sized for the balancing that was chosen"),
        Text(
            "The shaft that takes the rest: its masses, their radius, angle and place, where it is supported, and "
            "what it is made of."
        ),
        Text(
            "Nothing left of what it is to take, journals at less than {slope}, the first critical speed far above "
            "the running speed.",
            slope=Amount(SLOPE * 1e3, "mrad"),
        ),
        Text(
            "Sectors further apart or further out save mass; a thicker core straightens the shaft. The lightest can "
            "be chosen from a table."
        ),
        Text("balancer balance shaft lanchester eccentric"),
    ),
    "bearings": Guide(
        Text("Do the bearings carry, at every corner?"),
        Text("build it by rules: bearings that pass"),
        Text(
            "Plain or rolling, each bearing by itself. Of plain ones length and clearance, oil and its supply, and on "
            "what the journals run; of rolling ones the size, and how their rings sit."
        ),
        Text(
            "Plain: {length}; clearance {clearance}; a film that holds warm, some clearance when cold. Rolling: life "
            "and clearance that last, an outer ring that keeps its grip.",
            length=USUAL_LENGTH,
            clearance=USUAL_CLEARANCE,
        ),
        Text(
            "Plain: a tighter fit, more length, smoother surfaces. Rolling: another class or fit, an insert, the next "
            "size. A table has bearings of both kinds that pass."
        ),
        Text("rolling needle roller ball plain journal sleeve bearing film"),
    ),
    "gears": Guide(
        Text("Which train turns it, without jamming?"),
        Text("build it by rules: a train for the distance"),
        Text("Teeth, profile shifts, centre distances and allowances of the train that drives the shaft."),
        Text(
            "Backlash that stays above zero at every tolerance, cold and warm; contact ratio well above 1, no "
            "undercut, sliding "
            "shared evenly."
        ),
        Text(
            "Jamming: more span allowance. Undercut, pointed tips, uneven sliding: other profile shifts, from a table. "
            "Strength: face width."
        ),
        Text("noise whine rattle knock hum jamming gearing train"),
    ),
    "friction": Guide(
        Text("What does it cost the crank?"),
        Text("build it by rules: ground flanks in the oil of the bearings"),
        Text("Roughness of the flanks, oil and its temperature: what the whole train costs the crank."),
        Text(
            "Some hundred watts at rated speed. Under so light a load rolling and the bearings lose more than the "
            "teeth rub away."
        ),
        Text(
            "A thinner or warmer oil costs less in the meshes and thins the films of the bearings: watch step 4 while "
            "you change it."
        ),
        Text("losses efficiency watts drag consumption"),
    ),
    "mounting": Guide(
        Text("What does the driver feel?"),
        Text("build it by rules: four mounts at the corners, masses assumed until they are weighed"),
        Text("Mass, inertia and mounts of the engine, the frame below them, and where it is felt at which speeds."),
        Text(
            "All modes between the road's frequency and idle, roll and bounce pure. What no shaft takes stays, and "
            "the firing torque with it."
        ),
        Text("Softer mounts, other ratios, an inclination: the search for mounts finds those that decouple the modes."),
        Text("vibration vibrate shaking shake noise comfort NVH harshness boom rubber engine mounts feel isolation"),
    ),
}


# --- what a step takes over from the steps before it
def taken_over(step: str, data: Table, values: Mapping[str, Published]) -> Iterator[str]:
    """The inputs and values of earlier steps that it uses, by key or id."""
    for step_before in STEP_KEYS[: STEP_KEYS.index(step)]:
        yield from (
            key for key, about in quantities(data) if step in about.taken_by and step_at(data, key) == step_before
        )
        mine = (id for id, v in values.items() if step in v.about.taken_by and id == v.id)  # not by a former name
        yield from (id for id in mine if id.startswith(f"{step_before}."))


# what can be chosen from a table, by step (`offers.py` searches for it)
CHOICES = {
    "engine": Text("firing orders, the one that leaves least first"),
    "countershaft": Text("shafts in the envelope, the lightest first"),
    "bearings": Text("plain and rolling bearings that pass, the least power first"),
    "gears": Text("profile shifts and tip cuts, the least specific sliding first; teeth of an idler between walls"),
    "mounting": Text("mounts that decouple the modes between the road's frequency and idle, the purest first"),
}
CHOICE_NEEDS = {  # the steps without which nothing can be sought
    "engine": ("engine", "imbalance"),
    "countershaft": ("engine", "imbalance", "countershaft"),
    "bearings": ("bearings",),
    "gears": ("gears",),
    "mounting": ("engine", "imbalance", "mounting"),
}


def no_choice(step: str, data: Table) -> Text:
    """Why there is no table for a step of this design; empty where there is one."""
    if step not in CHOICES:
        steps = COMMA.join(known.title for known in STEPS if known.key in CHOICES)
        return Text("There is nothing to choose in this step; there is in {steps}.", steps=steps)
    if missing := [IN_SENTENCES[key] for key in CHOICE_NEEDS[step] if not asks(data, key)]:
        return Text("There is something to choose once the design has these steps: {steps}.", steps=COMMA.join(missing))
    return EMPTY
