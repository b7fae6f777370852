# SPDX-License-Identifier: Apache-2.0
"""What a step takes over from the steps before it: plain text, not fields.  Typing on one goes to the step that owns it."""

from textual import events
from textual.content import Content

from calc.design.addresses import quantity_of, value_at
from calc.design.model import STEPS
from calc.sheet.errors import BadInput
from calc.sheet.number import short
from calc.sheet.text import COMMA, Text

from ..session import numbers
from ..session.session import Session
from ..upstream import TAKEN
from .field import LABEL, LABEL_NARROW, NARROW
from .item_list import Item, ItemList
from .text import fit, wrap

NUMBERS = {step.key: n for n, step in enumerate(STEPS, 1)}


class Taken(ItemList):
    """The key of an item is the id of the value, or of the input, that is taken over."""

    def __init__(self, session: Session, step: str) -> None:
        super().__init__(id=f"taken-{step}")
        self.session = session
        self.step = step

    def explained(self) -> tuple[str, str]:
        """What the foot of the form says about it."""
        say = self.app.say
        return say(Text("From earlier steps")), say(Text("Enter, or typing a number, goes to the step that owns the value."))

    def build(self, width: int) -> list[Item]:
        found = []
        values, say = self.session.values(), self.app.say
        label_width = LABEL_NARROW if width >= NARROW else LABEL  # as in the fields above
        for id in TAKEN.get(self.step, ()):
            owner = id.partition(".")[0]
            if (known := values.get(id)) is not None:
                _, *part, _ = id.split(".")  # front or rear
                label = say(COMMA.join((known.label, *part)))
                text, unit = say.number(short(known.shown)), known.unit
            else:
                try:
                    about = quantity_of(self.session.data, id)
                except BadInput:
                    continue
                content = value_at(self.session.data, id) if owner in self.session.data else None
                if content is None:
                    continue
                label, text, unit = say(about.label), numbers.written(content, about), about.unit
            labels = wrap(label, label_width - 1)
            origin = f"{self.app.signs.mark('from')} {NUMBERS[owner]}"
            value = f"{text} {unit}".rstrip()
            room = max(1, min(18, width - label_width - len(origin) - 1))
            first = f"{labels[0]:<{label_width}}{fit(value, room):<{room}} {origin}"
            found.append(Item(id, [Content.styled(row, "dim") for row in (first, *labels[1:])], value, f"{label} {value}"))
        if found:
            found.insert(0, Item("", [Content(""), Content.styled(self.app.say(Text("From earlier steps")), "bold dim")]))
        return found

    def on_key(self, event: events.Key) -> None:
        """A value that another step owns is changed there."""
        if event.is_printable and event.character and event.character in "0123456789,.-":
            event.stop()
            event.prevent_default()
            self.choose()
