# SPDX-License-Identifier: Apache-2.0
"""At the foot of the form: what the field that has the focus means, and what is usual there."""

from textual.content import Content
from textual.widget import Widget

from calc.locale import Language
from calc.sheet.quantity import Quantity
from calc.sheet.text import Amount, Text

from ..base_app import BaseApp
from .text import fit, wrap


def meaning(about: Quantity, say: Language, *, sourced: bool = True) -> str:
    """What a quantity means and what is usual; `sourced`: with the source in brackets, behind the usual range or else
    the meaning."""
    source = f" ({say(about.source)})" if sourced and about.source else ""
    said, usual = say(about.help), ""
    if about.usual:
        low, high = about.usual
        usual = f"{say(Text('Usual {low} to {high}', low=Amount(low), high=Amount(high, about.unit)))}{source}."
    elif said and source:
        said = f"{said.removesuffix('.')}{source}."
    return " ".join(part for part in (said, usual) if part)


def allowed(about: Quantity, say: Language) -> str:
    """What a number may be, as a sentence."""
    words = "" if about.kind in ("text", "choice") else say(about.allowed())
    return f"{words[:1].upper()}{words[1:]}." if words else ""


def heading_help(about: Quantity, keys: Text, reason: Text, app: BaseApp) -> tuple[str, str]:
    """Of a part that may be left out or repeated: why it is not accepted, what it is, and its keys."""
    text = f"{about.help} {app.say(keys)}".strip()
    return about.label, f"{app.signs.mark('invalid')} {app.say(reason)}. {text}" if reason else text


def foot(said: str, rest: str, more: str, width: int, height: int) -> list[str]:
    """What is said in so many rows; `rest` behind it where all of it has room, `more` where the last row has."""
    rows = wrap(said, width)
    if rest and len(longer := wrap(f"{said} {rest}", width)) <= height:
        rows = longer
    if len(rows) > height:
        rows = rows[:height]
        rows[-1] = fit(rows[-1] + " …", width - len(more))
    if len(rows[-1]) + len(more) <= width:
        rows[-1] += more
    return rows


class FieldHelp(Widget):
    app: BaseApp

    def __init__(self) -> None:
        super().__init__(id="field-help")
        self.title = ""
        self.text = ""
        self.rest = ""
        self.moves = ""

    def show(self, title: str, text: str, rest: str = "", moves: str = "") -> None:
        """`moves`, what the field moves, stands behind what it means and what is usual; `rest` where there is room for
        all of it."""
        self.title, self.text, self.rest, self.moves = title, text, rest, moves
        self.refresh()

    def render(self) -> Content:
        if not self.title:
            return Content("")
        said = ": ".join(filter(None, (self.title, " ".join(filter(None, (self.text, self.moves))))))
        rows = foot(
            said, self.rest, f"  {self.app.say(Text('F1 more'))}", max(10, self.size.width - 2), self.size.height
        )
        return Content.styled("\n".join(" " + row for row in rows), "dim")
