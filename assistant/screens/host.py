# SPDX-License-Identifier: Apache-2.0
"""What the parts of the main screen need of it.

`Workbench` owns its parts (moves, edits, files, curves, readings, the background solve) and hands itself to each as a
`Host`; a part that needs another part is given it.  So nothing below the workbench imports it."""

from collections.abc import Callable
from typing import Any, Protocol, TypeVar

from textual.timer import Timer
from textual.widget import AwaitMount, Widget

from calc.sheet.step import Step

from ..base_app import BaseApp
from ..session.places import Place
from ..session.session import Session
from ..widgets.calculation import Calculation
from ..widgets.checks import Checks
from ..widgets.curve_pane import CurvePane, Pane
from ..widgets.form import Form
from .pane_layout import PaneLayout

W = TypeVar("W", bound=Widget)


class Host(Protocol):
    """The main screen, over one session, with one step shown."""

    session: Session
    step: Step
    pane_layout: PaneLayout

    # --- what there is
    @property
    def app(self) -> BaseApp: ...
    @property
    def stands(self) -> bool:
        """Whether all parts of the screen are there: not while it is composed again, or taken down at the end."""

    @property
    def is_attached(self) -> bool: ...
    @property
    def is_current(self) -> bool:
        """Whether no dialog stands before it."""

    @property
    def focused(self) -> Widget | None: ...
    @property
    def number(self) -> int:
        """Of the step, from 1."""

    @property
    def form(self) -> Form: ...
    @property
    def checks(self) -> Checks: ...
    @property
    def calculation(self) -> Calculation: ...
    @property
    def curve_pane(self) -> CurvePane: ...
    def set_focus(self, widget: Widget | None, scroll_visible: bool = True) -> None:
        """At once, before the keys that wait."""

    def query_one(self, kind: type[W], /) -> W:
        """The one widget of a kind."""

    def pane_named(self, name: str) -> Pane: ...
    def forms(self) -> list[Form]:
        """Of all steps that have been opened."""

    def add_form(self, form: Form) -> AwaitMount:
        """Beside those that there are."""

    # --- what it does
    def close_route(self) -> None:
        """Behind the last step: the closing page."""

    async def open_step(self, step: Step, focus: Place | None = None, *, stay: bool = False) -> None:
        """Show another step, with the focus on a field if one had it before; `stay` leaves the focus where it is."""

    def at_pane(self, name: str) -> None:
        """Make this pane the current one; narrow, or large, it is the only one."""

    def set_out(self) -> None:
        """Show the panes that belong on the screen."""

    def edited(self) -> None:
        """The design has changed: solve it, and keep the edit aside."""

    def show_state(self) -> None:
        """Show everything but the results: mistakes, verdicts of the steps, the message line."""

    def show_verdicts(self) -> None:
        """Show the checks and verdicts: first, and at once."""

    def show_picture(self) -> None:
        """Show the picture of the step."""

    def show_written(self) -> None:
        """Show the calculation, the curves and whatever else takes a moment to be prepared."""

    def show_remedy(self) -> None: ...
    def set_slow(self, slow: bool) -> None:
        """Say in the top line that a solve takes its time."""

    def set_stale(self, stale: bool) -> None:
        """Dim the results that do not belong to what the fields say."""

    def refresh_top_line(self) -> None: ...

    # --- later, or in another thread
    def call_later(self, callback: Callable[..., Any], *args: Any) -> bool:
        """Call back from the screen's own message queue; may be called in any thread."""

    def call_after_refresh(self, callback: Callable[..., Any], *args: Any, **kwargs: Any) -> bool: ...
    def set_timer(self, delay: float, callback: Callable[[], Any]) -> Timer: ...
    def in_thread(self, group: str, do: Callable[[], None], *, exclusive: bool = True) -> None:
        """Run in another thread; `exclusive` cancels what runs in the same group."""
