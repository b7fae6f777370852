# SPDX-License-Identifier: Apache-2.0
"""A whole session in another language: no English is left on the screen, whatever is opened."""

import re
from collections.abc import AsyncIterator, Iterable, Iterator
from contextlib import asynccontextmanager
from itertools import takewhile
from pathlib import Path
from typing import Any

import pytest
from textual.pilot import Pilot

from assistant.app import ContralberoApp
from assistant.screens.compare import CompareScreen, ComparisonList
from assistant.screens.workbench import Workbench
from assistant.session.calculation import sheet
from assistant.session.recovery import Memory, Settings
from assistant.session.session import Session
from assistant.widgets.calculation import Calculation
from assistant.widgets.checks import Checks
from assistant.widgets.item_list import ItemList
from calc.design.model import STEPS
from calc.design.toml_file import design as design_of
from calc.design.toml_file import read
from calc.gears.rating.classes import class_names
from calc.library.catalogue import base_stocks, materials
from calc.library.publications import register
from calc.locale import language
from calc.locale.language import PLACE, said
from calc.sheet.quantity import keys
from calc.solve import solve
from calc.studies.shipped import DESIGNS
from tests.assistant.conftest import NOON, solved
from tests.assistant.driving import go_to, settled, strike, told, type_in, until, work
from tests.languages.test_catalogue import ENGLISH, QUOTED
from tests.languages.texts import entries, judge_english, of_outcome

CODE = "it"
WORD = re.compile(r"[^\W\d_]{3,}")
# keys of the file, ids, paths and commands, what is cut off, and names: of the parts of a design, of authors, of a
# symbol, of the program
NAMES = re.compile(
    r"\w+_\w+,\w+|"
    r"[\w\-]*[._=/\[`][\w\-./=\[\]]*\w|\w+…|…\w*|\w+/|[\w\-]*\b(central|idler|crank|shaft|front|rear|Raimondi|Boyd|Contralbero|SAE|sense)\b"
)
ASIDE = re.compile(r"\(([\w ]+)\)")  # behind a label: by what of its id it is told from others
TITLES = tuple(f"{name}: " for name in register())  # of publications, which are in their own language
PARTS = re.compile(r"[│┃║╭╮╰╯▏▕▎]|\s{3,}")


def catalogue() -> dict[str, str]:
    """English → Italian, templates without their places."""
    return {
        PLACE.sub("", text): PLACE.sub("", told)
        for (many, one), both in entries(CODE).items()
        for text, told in zip((one, many) if one else (many,), both)
    }


def choices(inputs: Any) -> Iterator[str]:
    """What may be chosen in a form: it stands there as it stands in the file."""
    for key in keys(inputs).values():
        yield from key.about.choices
        if key.about.table is not None:
            yield from choices(key.about.table)


class Ear:
    """Hears English: words that make a sentence, and those of the source that no translation has.  `ids`: of the
    values, which are no words."""

    def __init__(self, ids: Iterable[str]) -> None:
        self.ids = " ".join(ids)
        self.ids += re.sub(r"[._]", " ", self.ids)
        made = catalogue()
        rows = (*base_stocks(), *class_names(), *materials())  # of the program's tables, which a design names
        ours = (*made.values(), *rows, *(choice for step in STEPS for choice in choices(step.inputs)))
        self.foreign = words(made) - words(ours)
        self.known: set[str] = set()
        self.left: dict[str, str] = {}

    def hear(self, rows: Iterable[str], where: str) -> None:
        new = {*rows} - self.known
        self.known |= new
        for part in {part.strip() for row in new for part in PARTS.split(row)}:
            if part.strip("[ ]") in self.ids:  # a piece of one that needs two rows, or more than its field
                continue
            bare = ASIDE.sub(lambda found: "" if found[1].replace("_", " ") in self.ids else found[0], part)
            bare = NAMES.sub("", QUOTED.sub("", bare))
            if ENGLISH.search(bare) or words([bare]) & self.foreign:
                self.left.setdefault(part, where)

    def judge(self) -> None:
        judge_english(CODE, (f"{part} ({where})" for part, where in self.left.items()))


def words(texts: Iterable[str]) -> set[str]:
    return {word.lower() for text in texts for word in WORD.findall(text)}


class Reader(Ear):
    """Hears what is on the screen."""

    def __init__(self, pilot: Pilot[int]) -> None:
        assert isinstance(pilot.app, ContralberoApp) and pilot.app.session.results is not None
        super().__init__((*pilot.app.session.results.values(), pilot.app.session.results.design.name))
        self.pilot = pilot

    def read(self, where: str) -> None:
        """The rows of the screen, what was told, and all rows of its lists, also those that are out of view."""
        screen = self.pilot.app.screen
        self.hear(("".join(segment.text for segment in strip) for strip in screen._compositor.render_strips()), where)
        self.hear((row.plain for shown in screen.query(ItemList) for item in shown.items for row in item.rows), where)
        self.hear(told(self.pilot).splitlines(), where)

    def read_list(self, where: str, until: tuple[str, ...]) -> None:
        """The rows of the list that is open, to the first that begins so."""
        rows = [row.plain for item in self.pilot.app.screen.query_one(ItemList).items for row in item.rows]
        self.hear(takewhile(lambda row: not row.strip().startswith(until), rows), where)


@pytest.fixture(autouse=True)
def quiet(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(Workbench, "_go_ahead", lambda self: None)  # nothing goes on behind the test
    monkeypatch.chdir(tmp_path)


@asynccontextmanager
async def opened(session: Session) -> AsyncIterator[tuple[Pilot[int], Reader]]:
    """The session, solved, with what reads it; at the end nothing English may have been read."""
    session.solve()
    app = ContralberoApp(session, settings=Settings(language=CODE))
    async with app.run_test(size=(120, 40)) as pilot:
        await solved(pilot)
        reader = Reader(pilot)
        yield pilot, reader
    reader.judge()


async def back(pilot: Pilot[int]) -> None:
    """Close what is open."""
    for _ in range(3):
        if isinstance(pilot.app.screen, Workbench):
            break
        await strike(pilot, "escape")
        await pilot.pause()
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))


async def over(pilot: Pilot[int]) -> None:
    """Wait for what a key has opened."""
    await until(pilot, lambda: not isinstance(pilot.app.screen, Workbench))
    await pilot.pause()


async def walked(pilot: Pilot[int], reader: Reader, steps: int) -> None:
    """Open every step, with a curve, its help, and the list of its curves; the values are heard below, without a
    screen."""
    for number, step in enumerate(STEPS[:steps], 1):
        await strike(pilot, "escape", str(number))
        await settled(pilot)
        await until(pilot, lambda: bool(work(pilot).query_one(Checks).items))
        reader.read(f"{step.key}: form, checks")
        await strike(pilot, "f4")  # which is filled only where it is shown
        await until(pilot, lambda: bool(work(pilot).query_one(Calculation).items))
        reader.read(f"{step.key}: calculation")
        await strike(pilot, "f4", "right")
        await pilot.pause()
        reader.read(f"{step.key}: curve")
        for key in ("f1", "shift+f9"):
            await strike(pilot, key)
            await over(pilot)
            reader.read(f"{step.key}: {key}")
            await back(pilot)
        await strike(pilot, "f4")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["r753ie4_gamma", "r753ie4_beta"])
async def test_every_step_of_a_whole_design(name: str, memory: Memory, tmp_path: Path) -> None:
    path = tmp_path / "progetto.toml"
    path.write_bytes((DESIGNS / f"{name}.toml").read_bytes())
    async with opened(Session.open(path, memory=memory, now=lambda: NOON)) as (pilot, reader):
        await walked(pilot, reader, 6)
        for step in ("4", "5"):
            await strike(pilot, "escape", step, "f7")
            await until(
                pilot, lambda: bool(work(pilot).query_one(Checks).has_focus and work(pilot).query_one(Checks).key)
            )
            await strike(pilot, "x")
            await over(pilot)
            reader.read_list("explain", until=TITLES)
            await back(pilot)


@pytest.mark.parametrize("name", ["r753ie4_gamma", pytest.param("r753ie4_beta", marks=pytest.mark.slow)])
def test_all_lists_of_a_whole_design(name: str) -> None:
    """The same lists without a screen: checks, calculation, values."""
    say, results = language(CODE), solve(design_of(read(DESIGNS / f"{name}.toml")))
    ear = Ear(results.values())
    for number, step in enumerate(STEPS, 1):
        outcome = results.outcomes[step.key].whole
        ear.hear(map(say, of_outcome(outcome)), step.key)
        ear.hear((say(check.limit_text()) for check in outcome.checks), f"{step.key}: limits")
        ear.hear((say(value.label) for value in outcome.values()), f"{step.key}: values")
        ear.hear((entry.text() for entry in sheet(said(outcome, say), number, say).entries), f"{step.key}: calculation")
    ear.judge()


@pytest.mark.slow
async def test_the_first_steps_on_the_screen(light: Session) -> None:
    """Forms, checks, calculation, curves, help of steps, fields and keys, the list of curves, and where a number comes
    from."""
    async with opened(light) as (pilot, reader):
        await walked(pilot, reader, 3)
        await strike(pilot, "f1")
        await over(pilot)
        for _ in range(3):  # all keys
            await strike(pilot, "pagedown")
            await pilot.pause()
            reader.read("help")
        await back(pilot)
        await strike(pilot, "escape", "3", "f7", "x")
        await over(pilot)
        reader.read_list("explain", until=TITLES)
        await back(pilot)


async def test_a_field_has_the_decimal_sign_of_the_language(light: Session) -> None:
    """What is typed with a point stands there with a comma, until another language is spoken; the file has a point."""
    key = "engine.crank_radius_mm"
    async with opened(light) as (pilot, _):
        box = await go_to(pilot, key)
        await type_in(pilot, "53.5")
        await strike(pilot, "enter")
        await until(pilot, lambda: light.value(key) == 53.5)
        box = await go_to(pilot, key)
        assert box.value == light.text(key) == "53,5"
        await strike(pilot, "shift+up", "enter")
        await until(pilot, lambda: light.value(key) != 53.5)
        assert not light.reasons()
        await pilot.app.speak("en")
        await settled(pilot)
        assert (await go_to(pilot, key)).value == light.text(key) == f"{light.value(key):g}"


async def test_what_asks(light: Session) -> None:
    """Dialogs, the palette, a table to choose from, two designs side by side."""
    async with opened(light) as (pilot, reader):
        for key in ("f12", "ctrl+o", "E", "ctrl+p", "ctrl+t"):
            await strike(pilot, "escape")
            await strike(pilot, key)
            await over(pilot)
            reader.read(key)
            await back(pilot)
        await go_to(pilot, "engine.crank_radius_mm")
        await type_in(pilot, "54")
        await strike(pilot, "shift+f7")
        await over(pilot)
        reader.read("what to compare with")
        await strike(pilot, "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, CompareScreen))
        await until(pilot, lambda: bool(pilot.app.screen.query_one(ComparisonList).items))
        await pilot.pause()
        reader.read("compare")


@pytest.mark.slow
async def test_what_is_said(light: Session) -> None:
    """Entries that are not valid, saving, recording, a remedy, going back."""
    async with opened(light) as (pilot, reader):
        for key, texts in (
            ("engine.bore_mm", ("abc", "1,234.5", "-5", "3 kg", "1.5e")),
            ("engine.firing_order", ("abc", "1.5, 2.5")),
        ):
            await go_to(pilot, key)
            for text in texts:
                await type_in(pilot, text)
                reader.read(f"{key}: {text}")
                await strike(pilot, "ctrl+z")
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "abc")
        await strike(pilot, "f1")
        await over(pilot)
        reader.read("help of an entry that is not valid")
        await back(pilot)
        await strike(pilot, "f8")
        await pilot.pause()
        reader.read("a report while the input is not valid")
        await strike(pilot, "ctrl+z")
        await strike(pilot, "escape", "escape")  # the first gives the field its old text
        await strike(pilot, "R")
        await go_to(pilot, "countershaft.masses.0.mass_kg")
        await type_in(pilot, "2.5")
        await strike(pilot, "enter")
        await solved(pilot)
        reader.read("recording")
        await strike(pilot, "escape")
        await strike(pilot, "R")
        await over(pilot)
        reader.read("where to write the replay")
        await strike(pilot, "enter")
        await until(pilot, lambda: "Replay" in told(pilot))
        for key in ("ctrl+s", "f5", "u", "r", "L", "g", "y"):
            await strike(pilot, key)
            await pilot.pause()
            reader.read(key)
