# SPDX-License-Identifier: Apache-2.0
"""What a step offers first, one row each: ↑ ↓ choose, Enter or Space takes."""

from functools import partial
from typing import TYPE_CHECKING, ClassVar

from textual.binding import Binding, BindingType
from textual.content import Content
from textual.worker import get_current_worker

from calc.sheet.errors import BadInput, NoSolution
from calc.sheet.text import Amount, Text

from ..session.guide import GUIDES
from ..session.session import Session
from .item_list import Item, ItemList
from .text import pad, wrap

if TYPE_CHECKING:
    from calc.design.toml_file import Document
    from calc.solve import Results
    from calc.studies.starter.balancing import Balancing

LABEL = 22  # cells
WAYS = {  # of a step: what its rules may be told to take, one of `KINDS` of `calc/studies/starter/build.py`
    "bearings": {
        "rolling": Text("on rolling bearings: a ball bearing beside the wheel, rollers behind it"),
        "needle": Text("on needle bearings"),
    }
}


class Radio(ItemList, inherit_bindings=False):
    BINDINGS: ClassVar[list[BindingType]] = [Binding("space", "take", "Take it", show=False)]

    def __init__(self, session: Session, step: str, id: str) -> None:
        super().__init__(id=f"{id}-{step}")
        self.session, self.step = session, step

    def explained(self) -> tuple[str, str]:
        """What the foot of the form says about it."""
        return "", self.app.say(self.enter())  # its question stands above it

    def enter(self) -> Text:
        """What Enter does with the row under the cursor."""
        return Text("↑ ↓ choose, Enter takes it.")

    def action_take(self) -> None:
        self.choose()

    def button(self, on: bool) -> str:
        return f"({'*' if self.app.signs.ascii else '•'}) " if on else "( ) "


class Todo(Radio):
    """Of a step that the design does not have: it is built by rules, in one of some ways, or left out."""

    BUILD, LEAVE = "build", "leave"

    def __init__(self, session: Session, step: str) -> None:
        super().__init__(session, step, "todo")

    def build(self, width: int) -> list[Item]:
        from calc.studies.starter.build import hindrance

        say = self.app.say
        without = self.session.data.get("without", {})
        reason = without.get(self.step, "") if isinstance(without, dict) else ""
        more: list[Item] = []
        if hindered := hindrance(self.session.document, self.step):
            words = say(Text("not built by rules: {why}", why=hindered))
            rows = [Content.styled(row, "dim") for row in wrap(f"    {words}", width - 1, 4)]
            first = Item(
                self.BUILD, rows, line=words
            )  # under the cursor at first, as what leaves the step out never is
        else:
            first = self._offer(self.BUILD, say(GUIDES[self.step].builds), False, width)
            more = [self._offer(kind, say(words), False, width) for kind, words in WAYS.get(self.step, {}).items()]
        leave = say(Text("leave it out"))
        return [first, *more, self._offer(self.LEAVE, f"{leave}: {reason}" if reason else leave, bool(reason), width)]

    def _offer(self, key: str, words: str, on: bool, width: int) -> Item:
        rows = wrap(self.button(on) + words, width - 1, 4)
        return Item(key, [Content(row) for row in rows], line=words)

    def enter(self) -> Text:
        return Text("↑ ↓ choose, Enter asks for the reason.") if self.key == self.LEAVE else super().enter()

    def explained(self) -> tuple[str, str]:
        title, text = super().explained()
        leave = Text("{key} leaves the step out, for a reason that you type.", key=self.app.shown_key("leave_out"))
        return title, f"{text} {self.app.say(leave)}"


class Balance(Radio):
    """The ways to balance the engine, with what each leaves."""

    def __init__(self, session: Session, step: str) -> None:
        super().__init__(session, step, "balance")
        self._known: tuple[Balancing, ...] = ()
        self._of: object = None  # the results that they are of

    def on_mount(self) -> None:
        self.refresh_options()

    def refresh_options(self) -> None:
        """Find them anew where the engine, or what is chosen, is another; in another thread."""
        results = self.session.results
        if results is not None and self.session.current and results is not self._of:
            self._of = results
            find = partial(self._find, self.session.document, results)
            self.run_worker(find, group="balance", exclusive=True, thread=True, exit_on_error=False)

    def _find(self, document: "Document", results: "Results") -> None:
        """Runs in another thread."""
        from calc.studies.starter.balancing import options

        worker = get_current_worker()
        try:
            balancings = options(document, results)
        except (BadInput, NoSolution):
            balancings = ()
        if not worker.is_cancelled:
            self.call_later(self._show, balancings)

    def _show(self, balancings: "tuple[Balancing, ...]") -> None:
        first = not self._known
        self._known = balancings
        self.rebuild()
        if first and (
            wanted := self.made() or next((balancing.id for balancing in balancings if balancing.called_for), "")
        ):
            self.go_to(wanted)

    def made(self) -> str:
        from calc.studies.starter.build import choice_made

        return choice_made(self.session.document)

    @property
    def taken(self) -> bool:
        """Whether the design has what is under the cursor: Enter goes on from there."""
        return bool(self.key) and self.key == self.made()

    def enter(self) -> Text:
        return Text("↑ ↓ choose. The design has this one: Enter goes on.") if self.taken else super().enter()

    def explained(self) -> tuple[str, str]:
        known = next((balancing for balancing in self._known if balancing.id == self.key), None)
        title, text = super().explained()
        return title, f"{self.app.say(known.why)} {text}" if known is not None else text

    def build(self, width: int) -> list[Item]:
        say = self.app.say
        if not self._known:
            waits = Text("What each balancing leaves is being computed …")
            wrong = Text("What each balancing leaves is told as soon as every input is understood.")
            return [Item("", [Content.styled(say(waits if self.session.valid else wrong), "dim")])]
        what = [Content.styled(" " * LABEL + say(left.what), "dim") for left in self._known[0].left]
        items, built = [Item("", [*what])] if what else [], self.made()
        for balancing in self._known:
            left = [
                say(
                    Text(
                        "{before} → {after}", before=Amount(x.before, digits=3), after=Amount(x.after, x.unit, digits=3)
                    )
                )
                if x.before != x.after
                else say(Text("{after}", after=Amount(x.after, x.unit, digits=3)))
                for x in balancing.left
            ]
            mass = (
                say(Text("{mass}", mass=Amount(balancing.mass, "kg", digits=3))) if balancing.mass is not None else ""
            )
            first = pad(self.button(balancing.id == built) + say(balancing.label), LABEL) + (left[0] if left else "")
            sign = f" {self.app.signs.mark('here')}" if balancing.called_for else ""
            end = f"{mass}{sign}"
            if len(first) + 1 + len(end) > width:
                end = sign.strip()  # the guide speaks of the mark: the mass gives way
            head = Content.assemble(f"{first:<{max(len(first) + 1, width - len(end) - 1)}}", end)
            more = [Content.styled(" " * LABEL + text, "dim") for text in left[1:]]
            items.append(
                Item(balancing.id, [head.stylize("bold") if balancing.called_for else head, *more], line=head.plain)
            )
        return items
