# SPDX-License-Identifier: Apache-2.0
"""What keys, ids and choices are called in words: `front length 27.5 → 34 mm, oil 10W-40 → SAE 50`."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import fields
from functools import cache
from types import UnionType
from typing import TYPE_CHECKING, Any, get_args, get_origin

from ..countershaft.inputs import ShaftInputs
from ..countershaft.rows import IN_WORDS
from ..engine.inputs import EngineInputs
from ..imbalance.inputs import ImbalanceInputs
from ..sheet.errors import BadInput
from ..sheet.quantity import Published, dotted, results_of
from ..sheet.remedy import Changes
from ..sheet.step import OF_SHAFTS
from ..sheet.text import COMMA, Amount, Name, Small, Text
from .addresses import ARRAYS, called, declared, in_array, own_shafts, place_words, quantity_of, value_at, within
from .model import STEP_KEYS, Design
from .toml_file import Document

if TYPE_CHECKING:
    from ..solve import Results


DIGITS = 6


def words(document: Document, results: "Results", changes: Changes) -> Text:
    """`document` and `results` are those before the changes.  A key that only makes room for another is not named."""
    return COMMA.join(words_each(document, results, changes))


def words_each(document: Document, results: "Results", changes: Changes) -> tuple[Text, ...]:
    """The same of each change by itself."""
    places = {key: (_shaft(document, key), place_words(key)) for key in changes}
    kept = [
        key
        for key, new in changes.items()
        if new is not None or not any(o != key and places[o] == places[key] for o in changes)
    ]
    told = [(key, _change(document, results, key, changes[key])) for key in kept]
    return tuple(_with_shaft(document, key, change) for key, change in told if change is not None)


def _shaft(document: Document, key: str) -> str:
    """The name of the shaft that a key is of, where there are several that are no twins; else empty."""
    first, *parts = key.split(".")
    return parts[0] if parts and first == dotted(Design.shafts) and len(own_shafts(document.data)) > 1 else ""


def _with_shaft(document: Document, key: str, words: Text) -> Text:
    name = _shaft(document, key)
    return Text("{name}: {reason}", name=Name(name), reason=words) if name else words


def _change(document: Document, results: "Results", key: str, new: object) -> Text | None:
    """None where it only writes down what the program had chosen."""
    about, old = quantity_of(document.data, key), value_at(document.data, key)
    if old is None and (there := published(results, key)) is not None and there.unit == about.unit:
        old = float(f"{there.shown:.4g}")
        if isinstance(new, float) and old == float(f"{new:.4g}"):
            return None
    if isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        changed = [(a, b) for a, b in zip(old, new) if a != b]
        old, new = changed[0] if len(changed) == 1 else (old, new)  # the one number of a list that changes
    label, place = about.brief or Small(about.label), place_words(key)
    parts = dict(label=label, now=written(old), new=written(new, about.unit))
    if place and in_array(key):
        return Text("{label} of {place} {now} → {new}", place=place, **parts)
    change = Text("{label} {now} → {new}", **parts)
    return Text("{place} {change}", place=IN_WORDS.get(place, place), change=change) if place else change


def named(document: Document, key: str) -> Text:
    """A key as the user knows it: the label of its field, and where it stands."""
    return _with_shaft(document, key, called(key, quantity_of(document.data, key)))


def asked(document: Document, key: str) -> Text:
    """The same of what a check lacks, which may be a table, or of an element that is not there yet."""
    try:
        return named(document, key)
    except BadInput:
        about = declared(key.split("."))
        if about is not None and about.table is None:
            return Small(about.label)
        return Name(key.rpartition(".")[2].replace("_", " "))


def published(results: "Results", key: str) -> Published | None:
    """The result that says what the program chose for a key that is left out: `gears.central.profile_shift`,
    `bearings.front.clearance`."""
    step = results.design.step_of(key)
    id = ".".join([step, *(part for part in within(key) if part not in ARRAYS)])
    seen = results.views.get(results.design.shaft_of(key), results)
    outcome = seen.outcomes.get(step)
    known = {value.id: value for value in outcome.values()} if outcome is not None else {}
    return known.get(id) or known.get(id.rpartition("_")[0])


def written(value: object, unit: str = "") -> Text | Amount:
    if value is None:
        return Text("left out")
    if isinstance(value, list):
        row = Name("/").join(Text("{x}", x=written(entry)) for entry in value)
        return Text("{row}°", row=row) if unit == "°" else Text("{row} {unit}", row=row, unit=unit) if unit else row
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return Amount(value, unit, digits=DIGITS)
    if isinstance(value, bool):
        return Text("yes") if value else Text("no")
    return Name(str(value))


# --- what the parts of an id are called: the value `bearings.front.film_edge` belongs to "front"
# A part of the program is a Text, which a language can say; one that the user named (a wheel, a mesh, a sector, a
# scenario) is a Name.

NUMBERED_ID = re.compile(r"(order|mode)_(\d+)(?:_(\d+))?")  # order_1_5 is the order 1.5
NUMBERED_STEPS = ("imbalance", "countershaft", "mounting")
CHECKED = {  # parts that only checks have, and tables of inputs
    "countershaft.shafts": Text("all shafts"),
    "engine.crank": Text("crank"),
    "engine.firing": Text("firing"),
    dotted(Design.engine, EngineInputs.gas): Text("gas"),
    dotted(Design.imbalance, ImbalanceInputs.unbalances): Text("unbalances"),
    dotted("countershaft", ShaftInputs.bolts): Text("bolts"),
    "countershaft.drain": Text("drain"),
    dotted("countershaft", ShaftInputs.holes): Text("holes"),
    dotted("countershaft", "*", ShaftInputs.bolts): Text("bolts"),  # of one of several shafts
    dotted("countershaft", "*.drain"): Text("drain"),
    dotted("countershaft", "*", ShaftInputs.holes): Text("holes"),
    "bearings.**.clearance_at": Text("clearance"),
    "gears.train": Text("train"),
    "friction.train": Text("train"),
    "mounting.decoupling": Text("decoupling"),
    "mounting.lifted": Text("weight"),
    "mounting.road": Text("road frequency"),
    "mounting.separation": Text("separation"),
}


@cache
def _words() -> Mapping[str, Text]:
    """What the parts of ids are called, by the way to them: `*` stands for a key of a dict, `**` for any way."""
    from ..bearings.kinds import KINDS  # with numpy, which a form does not need
    from ..bearings.result import BearingsOfShafts, BearingsResult
    from ..countershaft.result import CountershaftResult
    from ..countershaft.shafts import ShaftsResult
    from ..engine.result import EngineResult
    from ..friction.result import FrictionResult
    from ..gears.result import TrainResult
    from ..imbalance.result import ImbalanceResult
    from ..mounting.result import MountingResult

    assert KINDS  # whose results a bearing may have
    words, first = dict(CHECKED), (EngineResult, ImbalanceResult, CountershaftResult, BearingsResult, TrainResult)
    for step, result in zip(STEP_KEYS, (*first, FrictionResult, MountingResult), strict=True):
        words.update(_of_groups(result, step))
    for step, several in zip(OF_SHAFTS, (ShaftsResult, BearingsOfShafts), strict=True):
        words.update(_of_groups(several, step))
    return words


def _of_groups(result: type, way: str) -> Iterator[tuple[str, Text]]:
    """The words that the groups of a class of results have, and those of the keys of their dicts."""
    for f in fields(result):
        if (group := f.metadata.get("group")) is None:
            continue
        here = way if group.spread else f"{way}.{f.name.rstrip('_')}"
        if group.words:
            yield here, group.words
        content, keys = _first(f.type), [here]
        if get_origin(content) is dict:
            content, keys = _first(get_args(content)[1]), [f"{here}.{key}" for key in ("*", *group.key_words)]
            keys += [here] * group.several
        of_keys = f"{way.partition('.')[0]}.**" if content is Any else here
        yield from ((f"{of_keys}.{key}", words) for key, words in group.key_words.items())
        for kind in results_of(content):  # none of the name of a class that is loaded later
            for key in keys:
                yield from _of_groups(kind, key)


def _first(hint: object) -> object:
    """Of a type that may be None, the other."""
    return get_args(hint)[0] if isinstance(hint, UnionType) else hint


def addressed(key: str) -> list[Text]:
    """The parts of the key of an input before its last one: the tables of the file as they stand there, front and rear
    in words."""
    parts = key.split(".")[:-1]
    return [_words().get(".".join(parts[: n + 1])) or Name(part) for n, part in enumerate(parts)]


def belongs(id: str) -> list[Text]:
    """The parts of the id of a value or check between its step and its last word, in words."""
    step, *parts = id.split(".")[:-1]
    way, known, words = step, _words(), []
    for part in parts:
        word = known.get(f"{way}.{part}") or known.get(f"{step}.**.{part}")
        if step in OF_SHAFTS:  # behind the name of a shaft
            word = word or known.get(f"{way.replace('.*', '', 1)}.{part}")
        way = f"{way}.{part if word else '*'}"
        if word is None and step in NUMBERED_STEPS and (numbered := NUMBERED_ID.fullmatch(part)):
            kind, whole, more = numbered.groups()
            n = float(f"{whole}.{more}") if more else int(whole)
            word = Text("order {n}", n=n) if kind == "order" else Text("mode {n}", n=n)
        words.append(word or Name(part.replace("_", "–")))
    return words


def knows(name: str, whose: str) -> bool:
    """Whether a name says already what it belongs to."""
    letters = re.sub(r"\W", "", name.lower())
    return all(word in letters for word in re.findall(r"\w+", whose.lower()))


def in_context(label: Text, id: str) -> Text:
    """The label of a value or check with the part that it is of, where it does not say that itself: Specific load
    (front)."""
    parts = COMMA.join(belongs(id))
    return label if knows(label, parts) else Text("{label} ({where})", label=label, where=parts)


# --- the words of the choices in a design file, as people read them
# What is not here stands for itself: a name, a grade, a standard.

CHOICE_WORDS: dict[str, str] = {
    # engine, crank and shaft
    "inline": Text("inline"), "vee": Text("vee"), "boxer": Text("boxer"), "w": "W", "exact": Text("exact"),
    "two_term": Text("two terms"), "throttled": Text("by a throttle"), "unthrottled": Text("by the fuel alone"),
    "equal": Text("equal"), "per_pin": Text("per pin"), "least_squares": Text("least squares"), "given": Text("given"),
    "size": Text("sized"),
    "with": Text("with its rotation"), "against": Text("against its rotation"),
    "residual": Text("the residual"), "total": Text("the whole, with the target"),
    "bearings": Text("its bearings alone"), "plain": Text("plain"), "open": Text("open"),
    "shell": Text("in a shell"), "bracket": Text("counted, between its bounds"), "yes": Text("yes"),
    "no": Text("no"), "vdi": "VDI", "source": Text("as the source"),
    "threaded": Text("threaded"), "cartridge": Text("cartridge"), "split": Text("split at the axis"),
    "caps": Text("caps"), "module": Text("module"),
    "front": Text("front"), "rear": Text("rear"), "flywheel": Text("flywheel"), "nose": Text("nose"),
    # oil and bearings
    "direct": Text("in the housing itself"), "bush": Text("pressed bush"), "shells": Text("half shells"),
    "as_pressed": Text("as pressed"), "finished": Text("cut after pressing"), "press": Text("its press"),
    "pin": Text("a pin"),
    "rolling": Text("rolling"), "ball": Text("ball"), "roller": Text("roller"), "polyamide": Text("polyamide"),
    "splash": Text("oil splash"), "insert": Text("cast-in insert"), "adhesive": Text("adhesive"),
    "clamped": Text("clamped"), "true": Text("yes"), "false": Text("no"),
    "mineral": Text("mineral"), "ester": Text("ester"), "forced": Text("forced"),
    "forced_cooled": Text("forced, oil cooled"),
    "grease": Text("grease"), "ring": Text("ring"), "ring_moving_air": Text("ring, in moving air"),
    "ring_fast_air": Text("ring, in fast air"), "hole": Text("hole"), "shaft": Text("through the shaft"),
    "groove": Text("groove"),
    "axial_groove": Text("axial groove"), "pocket": Text("pocket"), "walther": "Walther", "d341": "ASTM D341",
    # materials and gears
    "steel": Text("steel"), "aluminium": Text("aluminium"), "grey iron": Text("grey iron"),
    "ductile iron": Text("ductile iron"),
    "other": Text("other"), "spray": Text("spray"), "dip": Text("dip"), "submerged": Text("submerged"),
    "left": Text("left-hand"),
    "right": Text("right-hand"), "none": Text("none"), "finotti": "Finotti 2013", "position": Text("position"),
    "fit": Text("fit"),
    "radial": Text("radial"), "runout": Text("run-out"), "chain": Text("chain"), "belt": Text("toothed belt"),
    "inner": Text("inner side"), "outer": Text("outer side"),
    # friction
    "linear": Text("linear"), "smooth": Text("smooth"), "barus": "Barus", "roelands": "Roelands",
    "thesis": Text("the thesis"),
    "castro-seabra": "Castro & Seabra", "doleschel": "Doleschel", "olver-spikes": "Olver & Spikes",
    "zhu-hu": "Zhu & Hu",
    "linke": "Linke", "simrit": "Simrit", "palmgren": "Palmgren", "skf": "SKF", "judged": Text("as judged"),
    "estimated": Text("estimated"), "oil": Text("oil"), "bath": Text("oil bath"), "mist": Text("oil mist"),
    "jet": Text("oil jet"),
    "deep-groove-ball": Text("deep-groove ball"), "angular-contact-ball": Text("angular-contact ball"),
    "self-aligning-ball": Text("self-aligning ball"), "cylindrical-roller": Text("cylindrical roller"),
    "needle-roller": Text("needle roller"), "spherical-roller": Text("spherical roller"),
    "tapered-roller": Text("tapered roller"),
    # mounting
    "tensor": Text("tensor"), "integral": Text("integral"), "clockwise": Text("clockwise"),
    "anticlockwise": Text("anticlockwise"),
    "construction-machine": Text("construction machine"), "tractor": Text("tractor"), "road": Text("road"),
    "stationary": Text("stationary"), "generating-set": Text("generating set"), "marine": Text("marine"),
    "inside": Text("inside the body"),
    "off_body": Text("off the body"), "fractional": Text("fractional"), "engine": Text("engine"),
    "chassis": Text("chassis"),
    "seat": Text("driver's seat"), "hand": Text("at the hands"), "machine": Text("machine"),
    # the search for whole drives
    "material": Text("material"), "surface": Text("surface"), "supply": Text("supply"),
}  # fmt: skip


def choice_word(choice: str) -> str:
    """A choice as people read it; a Text where it differs between languages."""
    return CHOICE_WORDS.get(choice, choice)
