# SPDX-License-Identifier: Apache-2.0
"""Small questions over a screen: the word of a field, the reason of a decision, yes or no."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, ClassVar

from textual import events
from textual.app import ComposeResult
from textual.await_complete import AwaitComplete
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.geometry import Region
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from calc.design.model import STEPS
from calc.locale import Language
from calc.sheet.check import Check
from calc.sheet.text import EMPTY, Amount, Text, plural
from calc.studies.ready import OF_PROGRAM

from ..actions import bound
from ..base_app import BaseApp
from ..widgets.line import Line

# --- closing a dialog once
# Enter that repeats, or comes twice before the first is dealt with, must not close what is behind it.

if TYPE_CHECKING:
    from textual.screen import Screen

    Below = Screen[Any]
else:
    Below = object  # style sheets look at the first base that is a widget, which the dialog names itself


class Once(Below):
    """Stands before `ModalScreen` among the bases of a dialog."""

    def dismiss(self, result: Any = None) -> AwaitComplete:
        return super().dismiss(result) if self.is_active else AwaitComplete()


# --- the list of words of a field, beside the field


class Choose(Once, ModalScreen[str | None]):
    """Gives the word, an empty one for "let the program choose", None when nothing was chosen."""

    BINDINGS: ClassVar[list[BindingType]] = [bound("leave", "cancel"), bound("save", "app.save")]

    def __init__(
        self,
        words: tuple[str, ...],
        value: str,
        prompt: str,
        beside: Region,
        typed: str = "",
        said: Callable[[str], str] = str,
    ) -> None:
        """`said`: a word as people read it."""
        super().__init__()
        self.words = (*([""] if prompt else []), *words)
        self.shown = [said(word) if word else prompt for word in self.words]
        self.value, self.prompt, self.beside = value, prompt, beside
        self._typed = typed.lower()

    def compose(self) -> ComposeResult:
        options = OptionList(*[Option(Content(shown)) for shown in self.shown], id="choose", compact=True)
        height = min(len(self.words), max(4, self.app.size.height - 6))
        width = max(self.beside.width, max(map(len, self.shown)) + 4)
        options.styles.width = width
        options.styles.height = height + 2
        top = min(self.beside.y + 1, self.app.size.height - height - 2)
        options.styles.offset = (max(0, min(self.beside.x - 1, self.app.size.width - width)), max(0, top))
        yield options

    def on_mount(self) -> None:
        options = self.query_one(OptionList)
        options.highlighted = self.words.index(self.value) if self.value in self.words else 0
        options.focus()
        if self._typed:
            self._find()

    def on_key(self, event: events.Key) -> None:
        """Letters find a word: typed together, its beginning or a part of it."""
        if event.key == "backspace":
            self._typed = self._typed[:-1]
        elif event.is_printable and event.character and event.key != "enter":
            self._typed += event.character.lower()
        else:
            return
        event.stop()
        event.prevent_default()
        self._find()

    def _find(self) -> None:
        """Put the cursor on the word that begins with, or has in it, what was typed."""
        low = [shown.lower() if word else "" for shown, word in zip(self.shown, self.words)]
        either = [f"{shown}\n{word.lower()}" for shown, word in zip(low, self.words)]  # or as the file has it
        index = next(
            (n for n, w in enumerate(low) if w.startswith(self._typed)),
            next((n for n, w in enumerate(either) if self._typed in w), None),
        )
        if index is not None:
            self.query_one(OptionList).highlighted = index
        else:
            self._typed = self._typed[-1:]

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self.dismiss(self.words[event.option_index])

    def on_click(self, event: events.Click) -> None:
        if event.widget is self:
            self.dismiss(None)

    def action_cancel(self) -> None:
        self.dismiss(None)


# --- the reason of a decision: an empty line to write on, and where a choice of them is common, usual reasons below it

# usual reasons, to be written on
USUAL_TO_ACCEPT = (
    Text("seen on the test bench: it holds"),
    Text("agreed with …"),
    Text("as in the engine that runs"),
    Text("to be settled by the supplier"),
    Text("outside what this design is for"),
)


class Reason(Once, ModalScreen[str | None]):
    """Gives the reason, which has at least a letter, or None."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        bound("leave", "cancel"),
        bound("save", "app.save"),
        Binding("enter", "take", "Take the reason", show=False, priority=True),
        Binding("down", "list(1)", "To the usual reasons", show=False, priority=True),
        Binding("up", "list(-1)", "Back to the reason", show=False, priority=True),
    ]

    def __init__(self, question: Text, about: str, hint: Text, usual: tuple[Text, ...] = ()) -> None:
        super().__init__()
        self.question, self.about, self.hint, self.usual = question, about, hint, usual

    def compose(self) -> ComposeResult:
        say = self.app.say
        with Vertical(classes="dialog"):
            yield Static(Content.styled(say(self.question), "bold"))
            yield Static(Content(self.about))
            yield Line(compact=True, select_on_focus=False, id="words")
            if self.usual:
                yield OptionList(*(Content(say(reason)) for reason in self.usual), compact=True, id="names")
            yield Static("", classes="wrong")
            yield Static(Content.styled(say(self.hint), "dim"))

    @property
    def _chosen(self) -> int | None:
        """The row under the cursor of the usual reasons, while they have the focus."""
        return self.focused.highlighted if isinstance(self.focused, OptionList) else None

    def action_take(self) -> None:
        """The reason that is written; in the list that of the row, to be written on."""
        reason = "".join(letter for letter in self.query_one(Input).value if letter.isprintable()).strip()
        if self._chosen is not None:
            self._write(self._chosen)
        elif any(letter.isalpha() for letter in reason):
            self.dismiss(reason)
        else:
            self.query_one(".wrong", Static).update(
                Content(self.app.say(Text("A reason is needed: it stands in the report.")))
            )

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """By a click."""
        event.stop()
        self._write(event.option_index)

    def _write(self, index: int) -> None:
        box = self.query_one(Input)
        box.value = self.app.say(self.usual[index]).removesuffix("…")
        box.cursor_position = len(box.value)
        self.set_focus(box)

    def action_list(self, by: int) -> None:
        if not self.usual:
            return
        options = self.query_one(OptionList)
        if by > 0 and self.focused is not options:
            self.set_focus(options)
            options.action_first()
        elif by > 0:
            options.action_cursor_down()
        elif options.highlighted in (0, None):
            self.set_focus(self.query_one(Input))
        else:
            options.action_cursor_up()

    def action_cancel(self) -> None:
        self.dismiss(None)


class Accept(Reason):
    """Why findings of one cause stay open, the worst of them first."""

    def __init__(self, checks: Sequence[Check], say: Language) -> None:
        worst, others = checks[0], len(checks) - 1
        what = Text(
            "{check}: {value}, {limit}",
            check=worst.name,
            value=Amount(worst.value, worst.unit),
            limit=worst.limit_text(),
        )
        more = (
            plural("and {n} finding of the same cause", "and {n} findings of the same cause", n=others)
            if others
            else EMPTY
        )
        about = " ".join(part for part in (say(what), say(more)) if part)
        hint = Text("Enter accepts it with this reason, ↓ chooses a usual one, Esc goes back.")
        super().__init__(Text("Leave this open: why is it right?"), about, hint, USUAL_TO_ACCEPT)


class LeaveOut(Reason):
    """Why the design does without a step; `reason`: that which it has already."""

    def __init__(self, step: str, reason: str, say: Language) -> None:
        title = next(candidate.title for candidate in STEPS if candidate.key == step)
        about = Text("{step}: {reason}", step=title, reason=reason) if reason else title
        if reason in OF_PROGRAM:
            about = Text("{step}, left out by the program so far: {reason}", step=title, reason=reason)
        hint = Text("Enter leaves it out with the reason that you type, Esc goes back.")
        super().__init__(Text("Leave this step out: why is it right, in your words?"), say(about), hint)


# --- a question with two answers


class Ask(Once, ModalScreen[bool]):
    """Enter gives True, Esc False."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [bound("go_on", "answer(True)"), bound("leave", "answer(False)")]

    def __init__(self, question: str, yes: str, no: str) -> None:
        super().__init__()
        self.question, self.yes, self.no = question, yes, no

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog"):
            yield Static(Content(self.question))
            yield Static("")
            yes, no = (self.app.say(self.app.shown_key(id)) for id in ("go_on", "leave"))
            yield Static(Content.assemble((yes, "bold"), f" {self.yes}    ", (no, "bold"), f" {self.no}"))

    def action_answer(self, answer: bool) -> None:
        self.dismiss(answer)
