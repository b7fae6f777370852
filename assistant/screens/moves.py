# SPDX-License-Identifier: Apache-2.0
"""Actions that go somewhere: to a step, a pane, a field, a check or a line."""

from calc.design.model import STEPS
from calc.sheet.check import URGENT, severity
from calc.sheet.errors import BadInput
from calc.sheet.text import Text

from ..session.places import Place
from ..session.route import step_of
from ..widgets.curve_pane import CurvePane
from ..widgets.form import Form
from ..widgets.headings import ArrayHeading, TableHeading
from ..widgets.item_list import ItemList
from ..widgets.radio import Radio
from ..widgets.steps import nothing_left, states_of
from .background_solve import BackgroundSolve
from .host import Host
from .pane_layout import VIEWS

WRITING = Text("The calculation is still being written out.")
FIRST = Text("This is the first step.")

LAID_OUT = 0.1  # s after which a form that was just made has its size


class Moves:
    def __init__(self, host: Host, background: BackgroundSolve) -> None:
        self._host, self._background = host, background

    # --- to a step, a field, a check, a line
    async def to_step(self, n: int) -> None:
        await self._host.open_step(STEPS[n - 1])

    async def turn_step(self, by: int) -> None:
        host = self._host
        host.app.forget(FIRST)
        n, idle = host.number - 1 + by, isinstance(host.focused, Form)
        while 0 <= n < len(STEPS) and STEPS[n].optional and STEPS[n].key not in host.session.data:
            n += by  # nobody is led into what the design does without
        if 0 <= n < len(STEPS):
            await host.open_step(STEPS[n])
            if idle and not self._done and isinstance(next(iter(host.form.stops()), None), Radio):
                host.form.focus_place(None)  # what is to be chosen stands under the cursor; letters stay keys there
        elif by > 0:
            host.close_route()
        else:
            host.app.tell(FIRST)

    async def lead_on(self) -> None:
        """The step after; where nothing is left to do in it, no field of it is edited, so that the next Enter leads on
        again."""
        host = self._host
        before = host.step
        await self.turn_step(1)
        if host.step is not before and self._done:
            host.set_focus(host.form, scroll_visible=False)

    @property
    def _done(self) -> bool:
        """Whether nothing is left to do in the step, or what is waits for a later one."""
        return nothing_left(states_of(self._host.session), self._host.step.key)

    async def trouble(self) -> None:
        """The next check that fails; after those, the next that warns."""
        host, session = self._host, self._host.session
        if session.reasons():
            await self.to_field(next(iter(session.reasons())))
            return
        if session.results is None:
            return
        outcomes = session.results.outcomes
        faults = [(s, group[0]) for s in STEPS for group in outcomes[s.key].causes if group[0].verdict in URGENT]
        faults.sort(key=lambda f: severity(f[1])[:3])
        if not faults:
            host.app.tell(Text("No check fails or warns."))
            return
        checks = host.checks
        here = next((n for n, (s, c) in enumerate(faults) if s is host.step and c.id == checks.key), None)
        if here is not None and checks.has_focus:
            step, check = faults[(here + 1) % len(faults)]
        else:
            step, check = next(
                (f for f in faults if f[0] is host.step and f[1].verdict == faults[0][1].verdict), faults[0]
            )
        host.at_pane("checks")
        await host.open_step(step, stay=True)
        host.set_focus(checks)
        host.call_after_refresh(checks.go_to, check.id)

    def line(self) -> None:
        """From a check to the line of the calculation that gives its value."""
        host = self._host
        if host.focused is host.checks and host.checks.key:
            self.to_line(host.checks.key)
        else:
            host.app.tell(Text("Go to a check first (F7, or F6 to the checks)."))

    def to_line(self, check: str) -> None:
        """The line of the calculation that a check comes from."""
        host = self._host
        calculation = host.calculation
        if self._background.page is None:
            host.app.tell(WRITING)
            return
        index = calculation.sheet.line_of.get(check)
        if index is None:
            host.app.tell(Text("No single line of the calculation gives this value."))
            return
        host.at_pane("calculation")
        host.set_focus(calculation)
        host.call_after_refresh(calculation.go_to, calculation.sheet.entries[index].number, top=True)

    async def to_value(self, id: str) -> None:
        """The field of an input, or the step of a result."""
        host = self._host
        step = next((s for s in STEPS if s.key == id.partition(".")[0]), host.step)
        try:
            place: Place | None = host.session.place(id)
        except BadInput:
            place = None
        host.at_pane("inputs")
        await host.open_step(step, place)

    async def to_field(self, place: Place) -> None:
        """Open the step of a field and put the focus there."""
        host = self._host
        step = next((s for s in STEPS if s.key == step_of(place)), host.step)
        host.at_pane("inputs")
        await host.open_step(step, place)
        host.form.focus_place(place, at_once=True)
        host.set_timer(LAID_OUT, host.form.bring_into_view)

    # --- between panes, and in them
    def move(self, by: int) -> None:
        """To the next field, check or line."""
        host = self._host
        focused = host.focused
        if isinstance(focused, CurvePane):
            focused.read_line(by)
        elif isinstance(focused, ItemList):
            before = focused.cursor
            focused.move(by)
            if focused.cursor == before and host.pane_layout.pane == "inputs":
                host.form.go(by)
        elif host.pane_layout.pane == "inputs":
            host.form.go(by)

    def turn_pane(self, by: int) -> None:
        """The next pane that is shown; narrow, the panes follow each other."""
        host = self._host
        names = (
            list(VIEWS)
            if not host.pane_layout.wide
            else ["steps", *VIEWS]
            if host.pane_layout.large
            else list(host.pane_layout.shown)
        )
        here = names.index(host.pane_layout.pane) if host.pane_layout.pane in names else 0
        self.to_view(names[(here + by) % len(names)])

    def view(self) -> None:
        """Narrow: the next view.  Wide: findings, calculation and curve in turn."""
        self.to_view(self._host.pane_layout.next_view())

    def enlarge(self) -> None:
        """This pane alone, or all of them again."""
        host = self._host
        host.pane_layout.large = host.pane_layout.wide and not host.pane_layout.large
        host.set_out()

    def to_view(self, name: str) -> None:
        host = self._host
        host.at_pane(name)
        if name == "inputs":
            host.form.focus_place(None, at_once=True)
        else:
            host.set_focus(host.pane_named(name).target)

    def leave(self) -> None:
        """Out of the field; the cursor off the curve; out of a large pane; back to the form."""
        host = self._host
        if host.form.restore():
            pass
        elif host.focused in host.form.stops():
            host.set_focus(host.form, scroll_visible=False)
        elif host.pane_layout.pane == "curve" and host.curve_pane.put_away():
            pass
        elif host.pane_layout.large:
            host.pane_layout.large = False
            host.set_out()
        elif host.pane_layout.pane != "inputs":
            host.at_pane("inputs")
            host.set_focus(host.form, scroll_visible=False)

    async def go_on(self) -> None:
        """Enter: choose in a list, go into the form, add an element, or on to the next field; from a finished step to
        the next."""
        host = self._host
        if isinstance(host.focused, ItemList):
            host.focused.choose()
        elif host.focused is host.form and not self._done:
            host.form.focus_place(None)
        elif host.focused is host.form:
            await self.lead_on()
        elif isinstance(host.focused, (ArrayHeading, TableHeading)) and host.focused.adds:
            host.focused.action_add()
        elif host.pane_layout.pane == "inputs":
            host.form.go_on()
