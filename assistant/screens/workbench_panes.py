# SPDX-License-Identifier: Apache-2.0
"""The main screen's parts, and which of its panes are seen: beside each other, or one alone.

Narrow, one at a time.  Wide, the steps, the inputs, the picture, and below the picture one of findings, calculation and
curve. Very wide, the curve has a place of its own below the picture.

`WorkbenchPanes` ← `WorkbenchResults` ← `WorkbenchMoves` ← `WorkbenchEdits` ← `Workbench`: one screen, a file for each
of its subjects, each of which calls what stands in those before it."""

from collections.abc import Callable
from contextlib import suppress
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Container, Horizontal, Vertical
from textual.content import Content
from textual.css.query import NoMatches
from textual.reactive import Reactive
from textual.screen import Screen
from textual.style import Style
from textual.widget import Widget

from calc.design.addresses import asks
from calc.design.model import STEPS
from calc.locale import Language
from calc.sheet.step import OF_SHAFTS, Step
from calc.sheet.text import EMPTY, Text

from ..actions import ACTIONS, bound
from ..base_app import BaseApp
from ..session.guide import title_of
from ..session.places import OF_SHAFT
from ..session.session import Session
from ..widgets.calculation import Calculation
from ..widgets.checks import Checks
from ..widgets.curve_pane import CurvePane
from ..widgets.form import Form
from ..widgets.lines import FooterLine, MessageLine, TopLine
from ..widgets.pane import Pane
from ..widgets.picture import Picture
from ..widgets.rows import FieldHelp
from ..widgets.steps import StepBar, Steps

VIEWS = {
    "inputs": Text("Inputs"),
    "picture": Text("Picture"),
    "checks": Text("Findings"),
    "calculation": Text("Calc"),
    "curve": Text("Plot"),
}
PANES = ("steps", *VIEWS)
TURNED = ("checks", "calculation", "curve")  # take turns in one place
HUGE = 170  # cells of a screen that has room for the findings beside the picture

FIRST_VALID = Text("First the input has to be valid.")


class WorkbenchPanes(Screen[None]):
    """`step` is the one that is shown.  `pane` has, or had last, the focus; `turned`: the one of those that take turns;
    `large`: the pane stands alone on a wide screen."""

    app: BaseApp
    HORIZONTAL_BREAKPOINTS = [(0, "-tiny"), (60, "-narrow"), (100, "-wide"), (HUGE, "-huge")]  # noqa: RUF012
    BINDINGS: ClassVar[list[BindingType]] = [bound(action.id) for action in ACTIONS]
    AUTO_FOCUS = ""
    # a change of the focus is drawn by the two widgets; the whole screen need not be
    focused: Reactive[Widget | None] = Reactive(None, repaint=False)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._composing = False
        self.begin(session)

    def begin(self, session: Session) -> None:
        """Enter a design, at its first step."""
        self.session = session
        self.step: Step = next((s for s in STEPS if asks(session.data, s.key)), STEPS[0])
        self.reset_panes()

    def reset_panes(self) -> None:
        self.pane, self.turned, self.large = "inputs", TURNED[0], False

    @property
    def enter_leads(self) -> str:
        """The step that Enter leads to now; empty where it does something else."""
        raise NotImplementedError

    # --- the parts
    def compose(self) -> ComposeResult:
        # the classes that the width will give, before there is anything that would have to be styled anew
        self.add_class(
            next(name for least, name in reversed(self.HORIZONTAL_BREAKPOINTS) if self.app.size.width >= least)
        )
        self.set_class(self.app.ascii, "-ascii")
        yield TopLine(self.session)
        yield StepBar(self.session)
        with Horizontal(id="body"):
            yield Pane(Text("Steps"), Steps(self.session), id="steps")
            yield Pane(
                self.form_title(), Container(Form(self.step, self.session), id="forms"), FieldHelp(), id="inputs"
            )
            with Vertical(id="results"):
                with Vertical(id="seen"):
                    yield Pane(Text("Picture"), Picture(), id="picture")
                    yield CurvePane()
                with Vertical(id="judged"):
                    yield Pane(Text("Findings"), Checks(), id="checks")
                    yield Pane(Text("Calculation"), Calculation(), id="calculation")
        yield MessageLine(self.session, lambda: self.enter_leads)
        yield FooterLine()

    async def compose_again(self) -> None:
        self._composing = True
        try:
            await self.recompose()
        finally:
            self._composing = False

    @property
    def stands(self) -> bool:
        """Whether all parts of the screen are there: not while it is composed again, or taken down at the end."""
        return not self._composing and any(isinstance(child, FooterLine) for child in self.children)

    @property
    def checks(self) -> Checks:
        return self.query_one(Checks)

    @property
    def calculation(self) -> Calculation:
        return self.query_one(Calculation)

    @property
    def curve_pane(self) -> CurvePane:
        return self.query_one(CurvePane)

    def pane_named(self, name: str) -> Pane:
        return self.query_one(f"#{name}", Pane)

    @property
    def form(self) -> Form:
        return self.query_one(f"#form-{self.step.key}", Form)

    def form_of(self, step: Step) -> Form | None:
        """That of a step, if the step has been opened, or its form been made ahead."""
        return next((form for form in self.query(Form) if form.step.key == step.key), None)

    @property
    def number(self) -> int:
        """Of the step, from 1."""
        return STEPS.index(self.step) + 1

    def form_title(self) -> str:
        title = f"{self.number} {self.app.say(title_of(self.step, self.session.data))}"
        of_shaft = self.leafs and self.step.key in OF_SHAFTS
        return f"{title}: {self.session.shafts[self.session.shaft]}" if of_shaft else title

    @property
    def leafs(self) -> bool:
        """Whether the step shows one of several shafts at a time."""
        return self.step.key in OF_SHAFT and len(self.session.shafts) > 1

    def refresh_top_line(self) -> None:
        with suppress(NoMatches):  # while another design is being entered
            self.query_one(TopLine).refresh()

    # --- later, or in another thread
    def in_thread(self, group: str, do: Callable[[], None], *, exclusive: bool = True) -> None:
        """Run in another thread; `exclusive` cancels what runs in the same group."""
        self.run_worker(do, group=group, description=group, exit_on_error=False, exclusive=exclusive, thread=True)

    def after_paint(self, do: Callable[[], object]) -> None:
        """What has just been shown is painted first; below a dialog nothing is."""
        if self.is_current:  # the screen knows of a widget that has changed once that has been idle
            self.checks.call_after_refresh(self.call_after_refresh, do)
        else:
            do()

    # --- which panes are seen
    @property
    def wide(self) -> bool:
        """Whether there is room for panes beside each other."""
        return self.has_class("-wide") or self.huge

    @property
    def huge(self) -> bool:
        return self.has_class("-huge")

    @property
    def single(self) -> bool:
        """One pane at a time."""
        return self.large or not self.wide

    @property
    def shown_panes(self) -> tuple[str, ...]:
        """The panes on the screen, in their order."""
        if self.single:
            return ("inputs" if self.pane == "steps" and not self.wide else self.pane,)
        if self.huge:
            return ("steps", "inputs", "picture", "curve", "calculation" if self.turned == "calculation" else "checks")
        return ("steps", "inputs", "picture", self.turned)

    def next_view(self) -> str:
        """The pane that takes the place of the one that is shown: narrow of all, wide of those that take turns."""
        names = list(VIEWS) if not self.wide else list(TURNED[:2] if self.huge else TURNED)
        here = self.pane if not self.wide else self.turned
        return names[(names.index(here) + 1) % len(names)] if here in names else names[0]

    def at_pane(self, name: str) -> None:
        """Make this pane the current one; narrow, or large, it is the only one."""
        if name != self.pane and self.stands:
            self.pane = name
            if name in TURNED and not (self.huge and name == "curve"):
                self.turned = name
            self.set_out()

    def set_out(self) -> None:
        """Show the panes that belong on the screen.  Done here and not by the style sheet, which would restyle every
        field."""
        single, shown = self.single, self.shown_panes
        for pane in self.query(Pane):
            pane.display = pane.id in shown
            pane.set_class(single and pane.id in shown, "-single")
            pane.mark(pane.id == self.pane)
            pane.set_title(views=_views(shown[0], self.app.say) if single and not self.wide else Content(""))
        for name in ("seen", "judged", "results"):
            part = self.query_one(f"#{name}", Vertical)
            part.display = any(pane.display for pane in part.query(Pane))
            part.set_class(single, "-single")
        self.query_one("#seen", Vertical).set_class(not self.query_one("#judged", Vertical).display, "-whole")
        self.query_one(MessageLine).beside = "checks" in shown and not single
        if "curve" in shown:
            self.call_after_refresh(self.curve_pane.draw)

    # --- the search for the whole drive
    _no_drive: tuple[object, str, Text] = (None, "", EMPTY)  # of which results and shaft it is known, and why

    def no_drive(self) -> Text:
        """Why the whole drive can not be searched for now; empty where it can, and where it is offered."""
        session = self.session
        if not session.valid:
            return FIRST_VALID
        if session.results is None or not session.current:
            return session.failure or Text("It is still being solved.")
        results, shaft, why = self._no_drive
        if results is not session.results or shaft != session.original:
            from calc.studies.drive.able import unable

            from .drive import of_shaft

            why = unable(session.document, session.results, of_shaft(session))
            self._no_drive = session.results, session.original, why
        return why


def _views(shown: str, say: Language) -> Content:
    """The names of the views, for a narrow screen."""
    parts = [
        Content.styled(say(word), "bold" if name == shown else "not bold dim").stylize(
            Style.from_meta({"@click": f"screen.to_view('{name}')"})
        )
        for name, word in VIEWS.items()
    ]
    return Content(" · ").join(parts)
