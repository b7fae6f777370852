# SPDX-License-Identifier: Apache-2.0
"""At the foot of the form: what the field that has the focus means, and what is usual there."""

from typing import TYPE_CHECKING

from textual.content import Content
from textual.widget import Widget

from calc.languages import Language
from calc.sheet.number import short
from calc.sheet.quantity import Quantity

from .wrap import fit, wrap

if TYPE_CHECKING:
    from ..app import ContralberoApp


def meaning(about: Quantity, say: Language) -> str:
    """What is said about a quantity, in one paragraph."""
    usual = say(f"Usual {short(about.usual[0])} to {short(about.usual[1])}") + f" {about.unit}".rstrip() + "." if about.usual else ""
    allowed = "" if about.kind in ("text", "choice") else say(about.allowed())
    allowed = f"{allowed[:1].upper()}{allowed[1:]}." if allowed else ""
    return " ".join(part for part in (say(about.help), usual, allowed) if part)


class FieldHelp(Widget):
    app: "ContralberoApp"

    def __init__(self) -> None:
        super().__init__(id="field-help")
        self.title = ""
        self.text = ""

    def show(self, title: str, text: str) -> None:
        self.title, self.text = title, text
        self.refresh()

    def render(self) -> Content:
        width, height = max(10, self.size.width - 2), self.size.height
        if not self.title:
            return Content("")
        more = f"  {self.app.say('F1 more')}"
        rows = wrap(f"{self.title}: {self.text}" if self.text else self.title, width)
        if len(rows) > height:
            rows = rows[:height]
            rows[-1] = fit(rows[-1] + " …", width - len(more))
        if len(rows[-1]) + len(more) <= width:
            rows[-1] += more
        return Content.styled("\n".join(" " + row for row in rows), "dim")
