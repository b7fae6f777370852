# SPDX-License-Identifier: Apache-2.0
"""Where the lists of the main screen lead: a row that is moved to, and one that is chosen."""

from calc.design.model import STEPS

from ..widgets.calculation import Calculation
from ..widgets.checks import Checks
from ..widgets.form import Taken
from ..widgets.item_list import ItemList
from ..widgets.radio import Radio
from ..widgets.steps import READY, Steps
from ..widgets.table_list import TableList
from .host import Host
from .moves import Moves
from .reading_actions import ReadingActions
from .results_view import ResultsView


class Lists:
    def __init__(self, host: Host, moves: Moves, readings: ReadingActions, results_view: ResultsView) -> None:
        self._host, self._moves, self._readings, self._results_view = host, moves, readings, results_view

    def moved(self, source: ItemList) -> None:
        """What belongs to the row is shown beside it."""
        if isinstance(source, Radio):
            self._results_view.show_help()
        elif isinstance(source, Checks) and self._host.stands:
            self._results_view.show_finding()
        elif isinstance(source, Calculation) and self._host.stands:
            self._host.pane_named("calculation").set_title(right=source.position())

    async def chosen(self, event: ItemList.Chosen) -> None:
        """A step is opened; a check and a line are explained, and a click on a check goes to its line; a value that was
        taken over leads to its owner."""
        source = event.source
        if event.key == READY:
            self._host.close_route()
        elif isinstance(source, Steps):
            self._host.at_pane("inputs")
            await self._host.open_step(next(s for s in STEPS if s.key == event.key))
        elif isinstance(source, Checks) and event.clicked:
            self._moves.to_line(event.key)
        elif isinstance(source, Checks) or (isinstance(source, (Calculation, TableList)) and not event.clicked):
            self._readings.explain()
        elif isinstance(source, Taken):
            await self._moves.to_value(event.key)
