# SPDX-License-Identifier: Apache-2.0
"""What was assumed of the shaft, left out or not computed, in sentences."""

from collections.abc import Iterator

from ..library.catalogue import Material
from ..sheet.text import Amount, Text
from .bending.shaft import Bending
from .inputs import ShaftInputs
from .outline import Journals

SLOPES_GIVEN = Text("The slopes of the journals are those given with them, not computed.")


def notes(shaft: ShaftInputs, journals: Journals, force: bool) -> Iterator[Text]:
    """What holds for every shaft; `journals`: (diameter, length) of each, empty where they are not known; `force`:
    whether it carries one."""
    yield (
        Text("The middle of the shaft is taken as the middle of the engine.")
        if force
        else Text(
            "The middle of the shaft is taken as the middle of the engine; for a pure couple its place does not matter."
        )
    )
    yield Text(
        "The reactions turn with the shaft. Its weight and the gear force stand still: they are given beside, where "
        "known."
    )
    if shaft.mode == "given" and shaft.radial_clearance is None and journals:
        yield Text(
            "Whether the shaft can be threaded through its seats is not judged: give the clearance for threading "
            "in where it has to be."
        )


def size_notes(shaft: ShaftInputs) -> Iterator[Text]:
    """What of the design a sized shaft does not use."""
    for word, given in ((Text("masses"), shaft.masses), (Text("sections"), shaft.sections)):
        if given:
            yield Text("Mode size: the {word} that are given are left aside; the sectors are found.", word=word)


def outline_note(sized: bool, gear: bool) -> Text:
    """What an outline that is not given as sections was put together from."""
    text = Text(" and the gear") if gear else ""
    if sized:
        return Text("The outline is put together from the sectors, the core, the journals{text}.", text=text)
    return Text(
        "The outline is put together: each eccentric mass as a sector of its mass, centre of gravity and place, "
        "the core, the journals{text}; the true shape may be given as sections.",
        text=text,
    )


def tight_fillet_note(bent: Bending) -> Text | None:
    """That a fillet has no room between shoulders whose places are assumed, which no check holds against the shaft."""
    if bent.fillet is None or bent.fillet_room is None or bent.fillet_room >= bent.fillet:
        return None
    return Text(
        "The outline as put together leaves {room} for each fillet where two shoulders are nearest, less than the "
        "{fillet} of the fillet that is given: not judged, since their places are assumed; give the sections.",
        room=Amount(bent.fillet_room * 1e3, "mm", digits=2),
        fillet=Amount(bent.fillet * 1e3, "mm"),
    )


def bending_notes(bent: Bending, steel: Material) -> Iterator[Text]:
    yield from bent.notes
    yield Text(
        "Bending stresses are nominal, of the full sections; sectors across the load's plane are bent as if they "
        "stood in it."
    )
    if steel.proof_stress is None:
        yield Text(
            "No strength of {name} is known: its bending stress is held against the weakest steels; notch and fatigue "
            "are not verified.",
            name=steel.name,
        )


def supports_note(stepped: bool) -> Text:
    """How the reactions of the supports were found; `stepped`: by the bending of the outline."""
    stiffness = (
        Text("the stepped shaft as it bends while it turns, with the stiffness share of its sectors"),
        Text("a shaft of one stiffness throughout"),
    )
    return Text(
        "Supports: the reactions are those of {how}, on rigid supports in line; weight and gear force are left out.",
        how=stiffness[0 if stepped else 1],
    )
