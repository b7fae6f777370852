# SPDX-License-Identifier: Apache-2.0
"""How long the journals may be beside the sectors, as far as the shaft is known.

A journal grows to both sides of its place.  Its room binds, whether the outline of the shaft is given, sized, or put together from the
masses; what is longer is offered apart, since the sectors would have to give way.
"""

from ...countershaft.inputs import CountershaftInputs
from ...countershaft.result import CountershaftResult
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import Metre
from .words import PLACE

SAME = 1e-6  # m: a stretch of the shaft this much thinner than the journal is still the journal


@record
class Room:
    """The longest journal that fits; None: not known."""

    longest: Metre | None
    why: Text


def room(given: CountershaftInputs | None, shaft: CountershaftResult | None, place: str, d: Metre) -> Room:
    """The room of the front or rear journal, of diameter d.

    The gear stands against the front journal and moves with it, unless its place is given.
    """
    if given is None:
        return Room(None, Text("no counter-shaft is given, so that the room for the journals is not known"))
    at = 0 if place == "front" else -1
    z = given.bearing_positions[at]
    if given.mode == "size" and given.half_length is not None:
        why = Text("the sectors reach to ±{half_length} (half_length_mm)", half_length=Amount(given.half_length * 1e3, "mm", form="g"))
        return Room(2 * (abs(z) - given.half_length), why)
    if given.sections:
        return _of_sections(given, z, d)
    if shaft is None or shaft.outline is None:
        return Room(None, Text("the outline of the shaft is not known, and so neither is the room for the journals"))
    own = next((p for p in shaft.outline.pieces if p.what == "journal" and p.start <= z <= p.end), None)
    fixed = ("sector", "full", "journal") if given.gear_z is None else ("sector", "full", "journal", "gear")
    faces = [min(abs(z - p.start), abs(z - p.end)) for p in shaft.outline.pieces if p.what in fixed and p is not own]
    if not faces:
        return Room(None, Text("nothing stands beside the journal"))
    return Room(
        2 * min(faces),
        Text(
            "a sector drawn from its mass begins {distance} from the {place} one's middle", distance=Amount(min(faces) * 1e3, "mm"),
            place=PLACE[place],
        ),
    )  # fmt: skip


def _of_sections(given: CountershaftInputs, z: Metre, d: Metre) -> Room:
    """Along the given sections: the stretch about the journal's place that is a full cylinder and not thinner than the journal."""
    rows = sorted(given.sections, key=lambda section: section.from_)
    wide = [not row.half_angle and row.outer_radius >= d / 2 - SAME for row in rows]
    here = next((i for i, row in enumerate(rows) if row.from_ <= z <= row.to), None)
    if here is None or not wide[here]:
        return Room(None, Text("the given sections have no cylinder of the journal's diameter at its place"))
    first = last = here
    while first > 0 and wide[first - 1]:
        first -= 1
    while last + 1 < len(rows) and wide[last + 1]:
        last += 1
    return Room(2 * min(z - rows[first].from_, rows[last].to - z), Text("the shaft's sections leave no more"))
