# SPDX-License-Identifier: Apache-2.0
"""The whole drive: the front of all combinations that pass, as points and as a table, to walk along.

The row under the cursor is solved and may be taken as one step of the undo."""

import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.widget import Widget
from textual.widgets import Static

from calc.countershaft.result import CountershaftResult
from calc.design.names import asked as input_asked
from calc.sheet.errors import NoSolution
from calc.sheet.progress import Progress
from calc.sheet.remedy import Changes
from calc.sheet.step import Table
from calc.sheet.text import EMPTY, SEMICOLON, Name, Text
from calc.studies.drive.classes import NotClosed
from calc.studies.drive.evolve import EVALUATIONS, evolved
from calc.studies.drive.output import UNIT, label, said, stood, table
from calc.studies.drive.refusal import refusal
from calc.studies.drive.refusal import said as broken_words
from calc.studies.drive.search import FrontTable as Known
from calc.studies.drive.search import asked, search
from calc.studies.drive.solved_drive import mass, power

from ..actions import bound
from ..base_app import BaseApp
from ..offers import Offer
from ..session.session import Session
from ..widgets.item_list import ItemList
from ..widgets.text import fit, pad
from .selection import Choosing, OfferList

if TYPE_CHECKING:
    from calc.studies.drive.search import FrontFound


# --- points of two objectives in character cells
# The drives of a front, the design as it is, and the one under the cursor.

DOT, NOW, PICKED = "·", "+", "◆"
PLAIN = {DOT: ".", NOW: "+", PICKED: "@"}
LEFT = 9  # cells of the numbers beside the frame


@dataclass(frozen=True)
class Points:
    """`x` and `y` of every drive by its number; `now`: of the design as it is, where it has them; `fails`: whether a
    limit of it does."""

    across: str
    up: str
    drives: dict[int, tuple[float, float]]
    now: tuple[float, float] | None = None
    fails: bool = False


class Scatter(Widget):
    """Redrawn whole: a front has a few dozen points."""

    app: BaseApp

    def __init__(self) -> None:
        super().__init__(id="scatter")
        self.points: Points | None = None
        self.picked = 0

    def show(self, points: Points, picked: int) -> None:
        self.points, self.picked = points, picked
        self.refresh()

    def render(self) -> Content:
        points, (width, height) = self.points, self.size
        columns, rows = width - LEFT - 1, height - 2
        if points is None or not points.drives or columns < 8 or rows < 3:
            return Content("")
        every = [*points.drives.values(), *([points.now] if points.now is not None else [])]
        (left, right), (low, high) = (_ends([p[n] for p in every]) for n in (0, 1))
        cells: dict[tuple[int, int], tuple[str, str]] = {}

        def put(at: tuple[float, float], sign: str, style: str) -> None:
            column = round((at[0] - left) / (right - left) * (columns - 1))
            row = rows - 1 - round((at[1] - low) / (high - low) * (rows - 1))
            cells[row, column] = PLAIN[sign] if self.app.ascii else sign, style

        for at in points.drives.values():
            put(at, DOT, "")
        if points.now is not None:
            put(points.now, NOW, self.app.signs.style("fail") if points.fails else "bold")
        if self.picked in points.drives:
            put(points.drives[self.picked], PICKED, self.app.signs.style("pass"))
        bar = "|" if self.app.ascii else "│"
        lines = [Content.styled(fit(f"{pad('', LEFT - 1)}{points.up}", width), "dim")]
        for row in range(rows):
            number = high if row == 0 else low if row == rows - 1 else None
            start = Content.styled((f"{number:.4g} " if number is not None else "").rjust(LEFT) + bar, "dim")
            lines.append(Content.assemble(start, *(cells.get((row, column), (" ", "")) for column in range(columns))))
        foot = f"{left:.4g}".ljust(columns - len(f"{right:.4g}")) + f"{right:.4g}"
        middle = (columns - len(points.across)) // 2
        if middle > len(f"{left:.4g}") + 1:
            foot = foot[:middle] + points.across + foot[middle + len(points.across) :]
        lines.append(Content.styled(" " * LEFT + foot, "dim"))
        return Content("\n").join(lines[:height])


def _ends(numbers: list[float]) -> tuple[float, float]:
    low, high = min(numbers), max(numbers)
    room = (high - low) * 0.04 or abs(low) * 0.01 or 1.0
    return low - room, high + room


# --- the screen

SHARE = 0.85  # of the progress, until all classes are done
ALMOST = 0.9  # of a class, until it is done
PROCESSES = 2
TALL = 30  # rows of a screen with room for points and table
HINT = Text(
    "Enter takes the drive (undo takes it back) · {across} {upright} axes · {sort} sort · {view} points · {compare} "
    "now → drive · {walk_back} {walk_on} largest seat · {help} what is searched · Esc back"
)
STOPS = Text("Enter keeps the drives so far · Esc stops")
ENDING = Text("ending with the drives so far …")


def of_shaft(session: Session) -> dict[str, object]:
    """Of several shafts that in view, where the design does not say which."""
    optimise = session.design.optimise
    several = len(session.design.originals) > 1 and (optimise is None or optimise.shaft is None)
    return {"shaft": session.original} if several else {}


class Driving(Choosing):
    """Gives the changes of the drive that was taken, as KEY=VALUE."""

    BEHIND = STOPS
    BINDINGS: ClassVar[list[BindingType]] = [
        bound("across", "axis(0)"),
        bound("upright", "axis(1)"),
        bound("sort", "sort"),
        bound("walk_back", "narrow(-1)"),
        bound("walk_on", "narrow(1)"),
        bound("help", "about"),
        bound("view", "view"),
    ]

    def __init__(self, session: Session) -> None:
        super().__init__(session, "drive")
        self.front: FrontFound | None = None
        self.axes = [0, 1]  # of the objectives
        self.sorted = 0
        self.widest: float | None = None  # seat up to which drives are shown
        self.about = False
        self.points = False  # on a low screen: they stand in the place of the table
        self._enough = False

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog -tall -whole"):
            yield Static(Content.styled(self.app.say(Text("Whole drive")), "bold"), id="choosing-title")
            yield Static(id="choosing-state")
            yield Scatter()
            yield OfferList()
            yield Static(id="choosing-preview")
            names = ("across", "upright", "sort", "view", "compare", "walk_back", "walk_on", "help")
            hint = Text(HINT.template, **{id: self.app.shown_letter(id) for id in names})
            yield Static(Content.styled(self.app.say(hint), "dim"))

    def on_resize(self) -> None:
        """Points and table below each other where there is room for both, else one of them."""
        low = self.app.size.height < TALL
        self.query_one(Scatter).display = not low or self.points
        self.query_one(Scatter).set_class(low, "-alone")
        self.query_one(OfferList).display = not (low and self.points)

    # --- searching
    def search(self, progress: Progress) -> Iterator[Offer]:
        problem, _ = asked(self.session.document, of_shaft(self.session))
        count, tries, begun = len(problem.classes), 0, time.monotonic()
        last = 0, 0.0  # classes that are done, and seconds until then

        def enough() -> bool:
            return self._enough

        def tell(now: float, what: Text) -> None:
            progress(now, ENDING if self._enough else what)

        def told(done: int, known: Known, name: str) -> None:
            nonlocal last
            last = done, time.monotonic() - begun
            tell(SHARE * done / count, Text("{name}: front {n}", name=Name(name), n=len(known)))

        def waiting() -> None:
            """Of the next class as much as those before it let expect."""
            done, then = last
            seconds = time.monotonic() - begun
            grown = min(ALMOST, (seconds - then) * done / then) if done else 0.0
            words = Text("{done} of {count} classes of drives, {n} s", done=done, count=count, n=round(seconds))
            tell(SHARE * (done + grown) / count, words)

        def solving(done: int, of: int) -> None:
            if not done:
                self._enough = False  # Enter has ended the classes; another one ends this
            tell(SHARE + (1 - SHARE) * done / of, Text("{n} of {of} drives solved whole", n=done, of=of))

        def trying() -> bool:
            nonlocal tries
            tries += 1
            tell(min(1.0, tries / EVALUATIONS), Text("{done} of {most} solved", done=tries, most=EVALUATIONS))
            return self._enough

        waiting()
        try:
            front = search(problem, PROCESSES, None, told, solving, stop=enough, enough=enough, pulse=waiting)
        except NotClosed:
            front = evolved(problem, EVALUATIONS, problem.seed, enough=trying)
        if not front.drives:
            raise NoSolution(self._nothing(front, progress))
        self.front = front
        yield self.offered()

    def _nothing(self, front: "FrontFound", progress: Progress) -> Text:
        """What alone would have to give way."""
        why, document, results = refusal(front, progress), self.session.document, self.session.results
        if why.always:
            broken = broken_words(why.always, document, results.checks() if results is not None else ())
            return Text("every drive that was solved whole breaks {checks}", checks=broken)
        if why.lines:
            ways = SEMICOLON.join(
                [Text("{key} {change}", key=input_asked(document, line.key), change=line.change) for line in why.lines]
            )
            return Text("nothing passes; one of these alone would have to give way: {ways}", ways=ways)
        return Text("nothing passes")

    def offered(self) -> Offer:
        """The drives that are shown, in the order that is asked for."""
        front = self.front
        assert front is not None
        numbers = self.shown
        whole = table(front, numbers)
        rows = sorted(whole.rows, key=lambda row: self._key(int(row[0])))  # type: ignore[arg-type]
        return Offer(
            count=len(front.drives),
            table=lambda top: Table(whole.id, whole.title, whole.columns, tuple(rows[:top]), whole.note),
            keys=self._changes,
            said=lambda n: Text("drive {n}", n=n),
            hint=EMPTY,
            summary=self._summary(),
        )

    @property
    def shown(self) -> list[int]:
        front = self.front
        drives = front.drives if front is not None else ()
        return [
            n
            for n, drive in enumerate(drives, 1)
            if self.widest is None or drive.objectives["seat"] <= self.widest + 1e-9
        ]

    def _key(self, n: int) -> tuple[float, int]:
        assert self.front is not None
        name = self.front.problem.objectives[self.sorted]
        value = self.front.drives[n - 1].objectives[name]
        return (-value if name == "margin" else value), n

    def _changes(self, n: int) -> Changes:
        assert self.front is not None
        return {**self.front.problem.began, **self.front.drives[n - 1].changes}

    def _summary(self) -> tuple[Text, ...]:
        front = self.front
        assert front is not None
        by = Text("sorted by {name}", name=label(front.problem, front.problem.objectives[self.sorted]))
        if self.widest is not None:
            by = Text("{by}; seats up to {seat} mm", by=by, seat=Name(f"{self.widest:g}"))
        return (stood(front), by, *(said(front.problem) if self.about else ()))

    def show_found(self, result: Offer) -> None:
        super().show_found(result)
        self._draw()

    def show_end(self, failure: Text) -> None:
        self.show_state(self.app.say(failure) if failure else "")

    # --- the points
    def _draw(self) -> None:
        front = self.front
        if front is None:
            return
        names = [front.problem.objectives[n % len(front.problem.objectives)] for n in self.axes]
        across, up = (f"{self.app.say(label(front.problem, name))}, {UNIT[name]}" for name in names)
        drives = {
            n: (front.drives[n - 1].objectives[names[0]], front.drives[n - 1].objectives[names[1]]) for n in self.shown
        }
        now, fails = self._now(names)
        self.query_one(Scatter).show(Points(across, up, drives, now, fails), self.number)

    def _now(self, names: list[str]) -> tuple[tuple[float, float] | None, bool]:
        """The design as it is, and whether a limit of it fails."""
        results, rows, front = self.session.results, self.session.design.rows, self.front
        shaft = results.result(CountershaftResult) if results is not None else None
        if results is None or not rows or front is None or shaft is None or shaft.mass is None:
            return None, False
        if results.outcomes["bearings"].state != "solved" or front.problem.cycle:
            return None, False
        checks = list(results.checks())
        known = {
            "power": power(results),
            "mass": mass(results),
            "margin": front.problem.margin(checks),
            "seat": max(row.diameter for row in rows) * 1e3,
            "price": front.problem.price({}, None),
        }
        x, y = known[names[0]], known[names[1]]
        return ((x, y) if x is not None and y is not None else None), any(c.verdict == "fail" for c in checks)

    def on_item_list_moved(self, event: ItemList.Moved) -> None:
        super().on_item_list_moved(event)
        self._draw()

    # --- what the keys do
    def action_axis(self, which: int) -> None:
        if self.front is not None:
            count, other = len(self.front.problem.objectives), self.axes[1 - which]
            following = ((self.axes[which] + by) % count for by in (1, 2))
            self.axes[which] = next((n for n in following if n != other), self.axes[which])
            self._draw()

    def row_name(self, number: int) -> Text:
        return Text("drive {n}", n=number)

    def action_sort(self) -> None:
        if self.front is not None:
            self.sorted = (self.sorted + 1) % len(self.front.problem.objectives)
            self._again()

    def action_narrow(self, way: int) -> None:
        """The largest seat that is still shown, one step of those there are down or up."""
        if self.front is None:
            return
        seats = sorted({drive.objectives["seat"] for drive in self.front.drives})
        at = len(seats) - 1 if self.widest is None else seats.index(self.widest)
        at = max(0, at + way)
        self.widest = None if at >= len(seats) - 1 else seats[at]
        self._again()

    def action_view(self) -> None:
        self.points = not self.points
        self.on_resize()
        if self.query_one(OfferList).display:
            self.query_one(OfferList).focus()

    def action_about(self) -> None:
        self.about = not self.about
        if self.front is not None:
            self._again()

    def _again(self) -> None:
        self.offer = self.offered()
        self.query_one(OfferList).show(self.offer)
        self._draw()

    def action_take(self) -> None:
        """While it is searched: keep what there is by then; what the classes gave is still solved whole."""
        if self.searching:
            self._enough = True
        else:
            super().action_take()
