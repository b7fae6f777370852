# SPDX-License-Identifier: Apache-2.0
"""The balancing sheet in the session: its table is added by a key like any other, and the empty one asks for it."""

from copy import deepcopy

from assistant.session.saving import saved_text
from assistant.widgets.headings import TableHeading
from calc.countershaft.inputs import ShaftInputs
from calc.design.toml_file import parse
from calc.sheet.quantity import dotted
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import go_to, settled, strike, until, work
from tests.conftest import DESIGNS

KEY = dotted(ShaftInputs.balancing)


async def test_the_table_is_added_by_a_key(screen: Screen) -> None:
    async with screen() as pilot:
        session = work(pilot).session
        await go_to(pilot, "shafts.shaft.balance_grade")
        form = work(pilot).form
        form.opened |= set(range(20))
        form.rebuild()
        await settled(pilot)
        heading = next(h for h in form.query(TableHeading) if h.row.place[-1] == KEY)
        heading.focus()
        await until(pilot, lambda: pilot.app.focused is heading)
        await strike(pilot, "plus")
        await solved(pilot)
        assert session.valid and session.value(heading.row.place) == {}
        results = session.results
        assert results is not None and "countershaft.balancing.front.target" in results.values()


def test_the_empty_table_is_saved() -> None:
    text = (DESIGNS / "r754ie4_balance_shafts.toml").read_text(encoding="utf-8")
    before, _, rest = text.partition("[shafts.balancing]")
    raw = f"{before}#{rest.partition('# assumed: the outline;')[2]}".encode()
    data = deepcopy(parse(raw, "").data)
    assert KEY not in data["shafts"][0]
    data["shafts"][0][KEY] = {}
    saved = saved_text(raw, data)
    assert "[shafts.balancing]" in saved and parse(saved.encode(), "").data == data
