# SPDX-License-Identifier: Apache-2.0
"""What a change of a design does beside what it is made for: the limits that are not kept any more, and what it opens.

Remedies and ranked tables say it in these words alike."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from ...design.model import IN_SENTENCES
from ...sheet.check import Check
from ...sheet.text import COMMA, EMPTY, SEMICOLON, Text
from ...sheet.verdict import counts, named, severity
from ...solve import Results
from .state import ORDER, worse_limits

NAMED = 2  # checks that are named, of more the number


def first_of(names: Sequence[Text]) -> Text:
    """The first names, of more the number."""
    first = COMMA.join(names[:NAMED])
    return first if len(names) <= NAMED else Text("{names} and {more} more", names=first, more=len(names) - NAMED)


@dataclass(frozen=True)
class SideEffects:
    """`breaks`: names of limits that are judged worse then, and of steps without a solution; `opens`: cautions and
    limits that are open then and were not, the worst first."""

    breaks: tuple[Text, ...] = ()
    opens: tuple[Check, ...] = ()

    @property
    def counted(self) -> Text:
        """`opens 2 cautions`; empty where nothing opens."""
        words = COMMA.join([words for _, words in counts(self.opens).words])
        return Text("opens {what}", what=words) if self.opens else EMPTY

    @property
    def words(self) -> Text:
        """`then not kept: Safety of the root; opens 2 cautions: …`; empty where there is nothing to say."""
        parts = []
        if self.breaks:
            parts.append(Text("then not kept: {checks}", checks=first_of(self.breaks)))
        if self.opens:
            parts.append(Text("{opens}: {checks}", opens=self.counted, checks=named(self.opens, NAMED)))
        return SEMICOLON.join(parts) if parts else EMPTY


NO_EFFECTS = SideEffects()


def side_effects(before: Results, after: Results, mine: Collection[str] = ()) -> SideEffects:
    """`mine`: ids of what the change is made for, which is told by itself."""
    worse = [id for id in worse_limits(before, after) if id not in mine]
    names = {
        c.id: Text("{check} (not verified)", check=c.name) if c.verdict == "not_verified" else c.name
        for c in after.checks()
    }
    no_solution = {step: Text("{step} has no solution", step=IN_SENTENCES[step]) for step in ORDER}
    told = {c.id for c in before.checks() if c.open} | {*worse, *mine}
    opens = [
        c
        for c in after.checks()
        if c.kind in ("limit", "caution") and c.verdict in ("warn", "not_verified") and c.id not in told
    ]
    return SideEffects(
        tuple(no_solution[id] if id in no_solution else names[id] for id in worse),
        tuple(sorted(opens, key=severity)),
    )
