# SPDX-License-Identifier: Apache-2.0
"""The list of remedies: number, kind, change, how far it comes, and what it does to the rest."""

from textual.content import Content

from calc.repair.way import ALL_CORNERS, AS_GIVEN, NEAR, Way
from calc.sheet.text import Text

from .item_list import Item, ItemList
from .text import pad, wrap

SIGN = {ALL_CORNERS: "pass", AS_GIVEN: "pass", NEAR: "warn"}  # of the verdicts; one that breaks something else is a fail
ROOMY = 96  # cells from which the change, the result and the rest stand beside each other
GAP = 2


class WayList(ItemList):
    """The key of an item is the number of its row."""

    def __init__(self) -> None:
        super().__init__(id="way-list")
        self.ways: tuple[Way, ...] = ()

    def show(self, ways: tuple[Way, ...]) -> None:
        """The cursor stays on its remedy, which may have another number now; on the first row until it was moved from there."""
        here, before = self.key if self.key != "1" else "", self.ways
        self.ways = ways
        self.rebuild()
        if here and (now := next((n for n, way in enumerate(ways, 1) if way == before[int(here) - 1]), None)) is not None:
            self.go_to(str(now))
        elif ways:
            self.go_to("1")

    def build(self, width: int) -> list[Item]:
        return [Item(str(n), self._columns(n, way, width), self.app.say(way.words), self._line(way)) for n, way in enumerate(self.ways, 1)]

    def _line(self, way: Way) -> str:
        return self.app.say(Text("{kind}: {change}; {result}", kind=way.kind, change=way.words, result=self.result(way)))

    def result(self, way: Way) -> Text:
        return Text("locked: {reason} (k unlocks)", reason=way.locked) if way.locked else way.effect

    def _columns(self, number: int, way: Way, width: int) -> list[Content]:
        say, signs = self.app.say, self.app.signs
        arrow = signs.mark("then")
        kind, change, rest = say(way.kind), say(way.words).replace("→", arrow), say(way.rest)
        state = "blocked" if way.locked else SIGN.get(way.quality, "fail")
        result, style = f"{signs.mark(state)} {say(self.result(way))}", signs.style(state)
        kinds = max(len(say(one.kind)) for one in self.ways)
        start = f" {number} "
        if width >= ROOMY:
            left = width - len(start) - kinds - 3 * GAP
            sizes = (left * 2 // 5, left // 3, left - left * 2 // 5 - left // 3)
            columns = [wrap(kind, kinds), wrap(change, sizes[0]), wrap(result, sizes[1], 2), wrap(rest, sizes[2])]
            rows = []
            for i in range(max(map(len, columns))):
                cells = [column[i] if i < len(column) else "" for column in columns]
                rows.append(Content.assemble(
                    start if i == 0 else " " * len(start), (pad(cells[0], kinds), "bold"), " " * GAP, pad(cells[1], sizes[0]), " " * GAP,
                    (pad(cells[2], sizes[1]), style), " " * GAP, (cells[3], "dim"),
                ))  # fmt: skip
            return rows
        lead = " " * len(start)
        first = wrap(result, width - len(start) - kinds - GAP, 2)
        rows = [Content.assemble(start, (pad(kind, kinds), "bold"), " " * GAP, (first[0], style))]
        rows += [Content.assemble(lead, " " * (kinds + GAP), (row, style)) for row in first[1:]]
        rows += [Content(lead + row) for row in wrap(change, width - len(lead), 2)]
        return rows + [Content.styled(lead + row, "dim") for row in (wrap(rest, width - len(lead), 2) if rest else [])]
