# SPDX-License-Identifier: Apache-2.0
"""What keys, ids and choices are called in words: `front length 27.5 → 34 mm, oil 10W-40 → SAE 50`."""

import re
from functools import cache
from typing import TYPE_CHECKING

from ..mounting.inputs import DOF_WORDS, VARIANT_WORDS
from ..sheet.quantity import Published, Quantity
from ..sheet.remedy import Changes
from ..sheet.text import COMMA, Amount, Name, Small, Text
from .addresses import quantity_of, value_at
from .toml_file import Document

if TYPE_CHECKING:
    from ..solve import Results


ARRAYS = ("wheels", "meshes", "masses", "extras", "sections", "unbalances", "crank_bodies", "journals")
BRIEF = {  # where the label of the form is longer than a line can bear
    "clearance_um": Text("clearance"),
    "span_allowance_um": Text("span allowance"),
    "diameter_mm": Text("diameter"),
    "profile_shift": Text("profile shift"),
}
NUMBERED = {"meshes": Text("mesh"), "sections": Text("section"), "journals": Text("journal")}
PLACES = {"front": Text("front"), "rear": Text("rear")}  # tables whose names are the program's
DIGITS = 6


def words(document: Document, results: "Results", changes: Changes) -> Text:
    """`document` and `results` are those before the changes.  A key that only makes room for another is not named."""
    places = {key: _place(key) for key in changes}
    kept = [
        key
        for key, new in changes.items()
        if new is not None or not any(o != key and places[o] == places[key] for o in changes)
    ]
    return COMMA.join(filter(None, (_change(document, results, key, changes[key]) for key in kept)))


def _change(document: Document, results: "Results", key: str, new: object) -> Text | None:
    """None where it only writes down what the program had chosen."""
    about, old = quantity_of(document.data, key), value_at(document.data, key)
    if old is None and (there := published(results, key)) is not None and there.unit == about.unit:
        old = float(f"{there.shown:.4g}")
        if isinstance(new, float) and old == float(f"{new:.4g}"):
            return None
    if (
        isinstance(old, list)
        and isinstance(new, list)
        and len(old) == len(new)
        and sum(a != b for a, b in zip(old, new)) == 1
    ):
        old, new = next((a, b) for a, b in zip(old, new) if a != b)  # the one number of a list that changes
    label, place, last = BRIEF.get(key.rpartition(".")[2], Small(about.label)), _place(key), written(new, about.unit)
    change = Text("{label} {now} → {new}", label=label, now=written(old), new=last)
    if not place:
        return change
    if key.split(".")[1] in ARRAYS:
        return Text("{label} of {place} {now} → {new}", label=label, place=place, now=written(old), new=last)
    return Text("{place} {change}", place=PLACES.get(place, place), change=change)


def named(document: Document, key: str) -> Text:
    """A key as the user knows it: the label of its field, and where it stands."""
    return called(key, quantity_of(document.data, key))


def called(key: str, about: Quantity) -> Text:
    """The same of a key whose quantity is known."""
    label, place = BRIEF.get(key.rpartition(".")[2], Small(about.label)), _place(key)
    if not place:
        return label
    if key.split(".")[1] in ARRAYS:
        return Text("{label} of {place}", label=label, place=place)
    return Text("{place} {change}", place=PLACES.get(place, place), change=label)


def published(results: "Results", key: str) -> Published | None:
    """The result that says what the program chose for a key that is left out: `gears.central.profile_shift`,
    `bearings.front.clearance`."""
    id = ".".join(part for part in key.split(".") if part not in ARRAYS)
    outcome = results.outcomes.get(key.partition(".")[0])
    known = {value.id: value for value in outcome.values()} if outcome is not None else {}
    return known.get(id) or known.get(id.rpartition("_")[0])


def _place(key: str) -> str:
    """The element or the table that a key stands in, without the step: `central`, `front`; a mesh by its number from
    1."""
    inner = [part for part in key.split(".")[1:-1] if part not in ARRAYS]
    if inner and inner[0].isdigit():
        array = key.split(".")[1]
        return Text("{array} {n}", array=NUMBERED.get(array, array), n=int(inner[0]) + 1)
    return " ".join(inner)


def written(value: object, unit: str = "") -> Text | Amount:
    if value is None:
        return Text("left out")
    if isinstance(value, list):
        row = Name("/").join(Text("{x}", x=written(entry)) for entry in value)
        return Text("{row}°", row=row) if unit == "°" else Text("{row} {unit}", row=row, unit=unit) if unit else row
    return (
        Amount(value, unit, digits=DIGITS)
        if isinstance(value, (int, float)) and not isinstance(value, bool)
        else Name(str(value))
    )


# --- what the parts of an id are called: the value `bearings.front.film_edge` belongs to "front"
# A part of the program is a Text, which a language can say; one that the user named (a wheel, a mesh, a sector, a
# scenario) is a Name.

NUMBERED_ID = re.compile(r"(order|mode)_(\d+)(?:_(\d+))?")  # order_1_5 is the order 1.5
ID_WORDS: dict[str, Text] = {  # by the way to them; * stands for a name of the user
    "engine.crank": Text("crank"), "engine.cylinder": Text("cylinder"), "engine.firing": Text("firing"),
    "engine.gas": Text("gas"), "engine.harmonic": Text("harmonic"),
    "engine.inertia_torque": Text("inertia torque"), "engine.reaction_inertia": Text("reaction inertia"),
    "engine.throw": Text("throw"),
    "engine.throw.largest_tangential": Text("largest tangential"),
    "engine.throw.top_dead_centre": Text("top dead centre"),
    "imbalance.bob_mass": Text("bob mass"), "imbalance.counterweight": Text("counterweight"),
    "imbalance.crank": Text("crank"),
    "imbalance.crank.balanced": Text("balanced"), "imbalance.crank.bare": Text("bare"),
    "imbalance.crank.stated": Text("stated"),
    "imbalance.remedy": Text("remedy"), "imbalance.remedy.backward_shaft": Text("backward shaft"),
    "imbalance.remedy.crank": Text("crank"), "imbalance.remedy.crank_and_shafts": Text("crank and shafts"),
    "imbalance.remedy.first_order_pair": Text("first order pair"), "imbalance.remedy.four_shafts": Text("four shafts"),
    "imbalance.remedy.second_order_shafts": Text("second order shafts"), "imbalance.unbalances": Text("unbalances"),
    "imbalance.throw": Text("throw"), "imbalance.counterweight.front": Text("front"),
    "imbalance.counterweight.rear": Text("rear"),
    "countershaft.mass_moment": Text("mass moment"),
    "countershaft.alternative": Text("alternative"), "countershaft.bolts": Text("bolts"),
    "countershaft.drain": Text("drain"),
    "countershaft.further_drains": Text("further drains"),
    "countershaft.holes": Text("holes"), "countershaft.scatter": Text("scatter"), "countershaft.sector": Text("sector"),
    "countershaft.support": Text("support"),
    "bearings.front": Text("front"), "bearings.rear": Text("rear"),
    "gears.train": Text("train"), "gears.*.sheet": Text("sheet"),
    "friction.journals": Text("journals"), "friction.journals.front": Text("front"),
    "friction.journals.rear": Text("rear"),
    "friction.scenarios": Text("scenarios"), "friction.scenarios.*.*.source": Text("source"),
    "friction.train": Text("train"),
    "friction.*.source": Text("source"),
    "mounting.critical": Text("critical speed"), "mounting.decoupling": Text("decoupling"),
    "mounting.energy": Text("energy"),
    "mounting.exposure": Text("exposure"), "mounting.felt_order_1": Text("first order felt"),
    "mounting.focal": Text("leaning pair"),
    "mounting.frequency": Text("frequency"), "mounting.lifted": Text("weight"), "mounting.range": Text("idle to rated"),
    "mounting.road": Text("road frequency"), "mounting.roll_axis": Text("torque roll axis"),
    "mounting.separation": Text("separation"),
    "mounting.static": Text("at rest"), "mounting.window": Text("stiffness"),
    "mounting.with_chassis": Text("engine and frame"),
}  # fmt: skip
INSIDE: dict[str, Text] = {  # wherever they stand below a part of these steps
    "imbalance.backward": Text("backward"),
    "imbalance.backward_2": Text("backward 2"),
    "imbalance.forward": Text("forward"),
    "imbalance.forward_2": Text("forward 2"),
    "imbalance.two_term": Text("two term"),
    "engine.journal": Text("journal"),
    "engine.pin": Text("pin"),
    "bearings.corners": Text("corners"),
    "bearings.dynamics": Text("dynamics"),
    "bearings.din31652": Name("DIN 31652"),
    "mounting.direction": Text("direction"),
    "mounting.share": Text("energy"),
    "mounting.torque": Text("torque"),
    **{f"mounting.{key}": title for key, title in (VARIANT_WORDS | DOF_WORDS).items()},
}


@cache
def _declared() -> dict[str, Text]:
    """Those of the routes to a film and of the models of friction, which say them above their functions."""
    from ..bearings.routes.routes import ROUTES  # with numpy, which a form does not need
    from ..friction.models import MODELS

    words = {f"bearings.{name}": route.brief for name, route in ROUTES.items()}
    return words | {f"friction.{name}": model.brief for name, model in MODELS.items()}


def addressed(key: str) -> list[Text]:
    """The parts of the key of an input before its last one: the tables of the file as they stand there, front and rear
    in words."""
    parts = key.split(".")[:-1]
    return [ID_WORDS.get(".".join(parts[: n + 1])) or Name(part) for n, part in enumerate(parts)]


def belongs(id: str) -> list[Text]:
    """The parts of the id of a value or check between its step and its last word, in words."""
    step, *parts = id.split(".")[:-1]
    way, words = step, []
    for part in parts:
        known = ID_WORDS.get(f"{way}.{part}") or INSIDE.get(f"{step}.{part}") or _declared().get(f"{step}.{part}")
        if known is None and step in ("imbalance", "mounting") and (numbered := NUMBERED_ID.fullmatch(part)):
            kind, whole, more = numbered.groups()
            n = float(f"{whole}.{more}") if more else int(whole)
            known = Text("order {n}", n=n) if kind == "order" else Text("mode {n}", n=n)
        words.append(known or Name(part.replace("_", "–")))
        way = f"{way}.{part if known else '*'}"
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
    "inline": Text("inline"), "vee": Text("vee"), "boxer": Text("boxer"), "exact": Text("exact"),
    "two_term": Text("two terms"),
    "equal": Text("equal"), "per_pin": Text("per pin"), "least_squares": Text("least squares"), "given": Text("given"),
    "size": Text("sized"), "yes": Text("yes"), "no": Text("no"), "vdi": "VDI", "source": Text("as the source"),
    # oil and bearings
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
    "radial": Text("radial"), "runout": Text("run-out"),
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
