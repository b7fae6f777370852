# SPDX-License-Identifier: Apache-2.0
"""What the parts of an id are called: the value `bearings.front.film_edge` belongs to "front".

A part of the program is a Text, which a language can say; one that the user named (a wheel, a mesh, a sector, a scenario) is a Name.
"""

import re

from .mounting.words import DOF_WORDS, VARIANT_WORDS
from .sheet.text import COMMA, Name, Text

NUMBERED = re.compile(r"(order|mode)_(\d+)(?:_(\d+))?")  # order_1_5 is the order 1.5
WORDS: dict[str, Text] = {  # by the way to them; * stands for a name of the user
    "engine.crank": Text("crank"), "engine.cylinder": Text("cylinder"), "engine.firing": Text("firing"),
    "engine.gas": Text("gas"), "engine.harmonic": Text("harmonic"),
    "engine.inertia_torque": Text("inertia torque"), "engine.reaction_inertia": Text("reaction inertia"), "engine.throw": Text("throw"),
    "engine.throw.largest_tangential": Text("largest tangential"), "engine.throw.top_dead_centre": Text("top dead centre"),
    "imbalance.bob_mass": Text("bob mass"), "imbalance.counterweight": Text("counterweight"), "imbalance.crank": Text("crank"),
    "imbalance.crank.balanced": Text("balanced"), "imbalance.crank.bare": Text("bare"), "imbalance.crank.stated": Text("stated"),
    "imbalance.remedy": Text("remedy"), "imbalance.remedy.backward_shaft": Text("backward shaft"),
    "imbalance.remedy.crank": Text("crank"), "imbalance.remedy.crank_and_shafts": Text("crank and shafts"),
    "imbalance.remedy.first_order_pair": Text("first order pair"), "imbalance.remedy.four_shafts": Text("four shafts"),
    "imbalance.remedy.second_order_shafts": Text("second order shafts"), "imbalance.unbalances": Text("unbalances"),
    "imbalance.throw": Text("throw"), "imbalance.counterweight.front": Text("front"), "imbalance.counterweight.rear": Text("rear"),
    "countershaft.mass_moment": Text("mass moment"),
    "countershaft.alternative": Text("alternative"), "countershaft.bolts": Text("bolts"), "countershaft.drain": Text("drain"),
    "countershaft.further_drains": Text("further drains"),
    "countershaft.holes": Text("holes"), "countershaft.scatter": Text("scatter"), "countershaft.sector": Text("sector"),
    "countershaft.support": Text("support"),
    "bearings.front": Text("front"), "bearings.rear": Text("rear"),
    "gears.train": Text("train"), "gears.*.sheet": Text("sheet"),
    "friction.journals": Text("journals"), "friction.journals.front": Text("front"), "friction.journals.rear": Text("rear"),
    "friction.scenarios": Text("scenarios"), "friction.scenarios.*.*.source": Text("source"), "friction.train": Text("train"),
    "friction.*.source": Text("source"), "friction.*.schlenk": Name("Schlenk"), "friction.*.niemann": Name("Niemann"),
    "friction.*.xu_kahraman": Name("Xu, Kahraman"), "friction.*.benedict_kelley": Name("Benedict, Kelley"),
    "mounting.critical": Text("critical speed"), "mounting.decoupling": Text("decoupling"), "mounting.energy": Text("energy"),
    "mounting.exposure": Text("exposure"), "mounting.felt_order_1": Text("first order felt"), "mounting.focal": Text("leaning pair"),
    "mounting.frequency": Text("frequency"), "mounting.lifted": Text("weight"), "mounting.range": Text("idle to rated"),
    "mounting.road": Text("road frequency"), "mounting.roll_axis": Text("torque roll axis"), "mounting.separation": Text("separation"),
    "mounting.static": Text("at rest"), "mounting.window": Text("stiffness"), "mounting.with_chassis": Text("engine and frame"),
}  # fmt: skip
INSIDE: dict[str, Text] = {  # wherever they stand below a part of these steps
    "imbalance.backward": Text("backward"), "imbalance.backward_2": Text("backward 2"), "imbalance.forward": Text("forward"),
    "imbalance.forward_2": Text("forward 2"), "imbalance.two_term": Text("two term"),
    "engine.journal": Text("journal"), "engine.pin": Text("pin"),
    "bearings.corners": Text("corners"), "bearings.dynamics": Text("dynamics"), "bearings.falz": Name("Falz"),
    "bearings.iso7902": Name("ISO 7902"),
    "bearings.raimondi_boyd": Name("Raimondi & Boyd"), "bearings.raimondi_boyd_own_flow": Text("Raimondi & Boyd, own flow"),
    "bearings.reynolds": Name("Reynolds"), "bearings.short_bearing": Text("short bearing"), "bearings.din31652": Name("DIN 31652"),
    "mounting.direction": Text("direction"), "mounting.share": Text("energy"), "mounting.torque": Text("torque"),
    **{f"mounting.{key}": title for key, title in (VARIANT_WORDS | DOF_WORDS).items()},
}  # fmt: skip


def addressed(key: str) -> list[Text]:
    """The parts of the key of an input before its last one: the tables of the file as they stand there, front and rear in words."""
    parts = key.split(".")[:-1]
    return [WORDS.get(".".join(parts[: n + 1])) or Name(part) for n, part in enumerate(parts)]


def belongs(id: str) -> list[Text]:
    """The parts of the id of a value or check between its step and its last word, in words."""
    step, *parts = id.split(".")[:-1]
    way, words = step, []
    for part in parts:
        known = WORDS.get(f"{way}.{part}") or INSIDE.get(f"{step}.{part}")
        if known is None and step in ("imbalance", "mounting") and (numbered := NUMBERED.fullmatch(part)):
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
    """The label of a value or check with the part that it is of, where it does not say that itself: Specific load (front)."""
    parts = COMMA.join(belongs(id))
    return label if knows(label, parts) else Text("{label} ({where})", label=label, where=parts)
