# SPDX-License-Identifier: Apache-2.0
"""What a session may begin with: the last design, an engine that comes with the program, a file, the worked example."""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from calc.design.model import SCHEMA
from calc.design.names import choice_word
from calc.design.toml_file import Document, design, read
from calc.engine.inputs import EngineInputs
from calc.locale import Language
from calc.sheet.errors import BadInput
from calc.sheet.quantity import dotted
from calc.sheet.text import EMPTY, Amount, Text
from calc.sheet.verdict import grouped
from calc.studies.ready import limits_hold
from calc.studies.shipped import EXAMPLE, ShippedEngine, engine_table, engines

from .inherited import STANDS, begun_note
from .recovery import Memory, is_file
from .saving import free_name

if TYPE_CHECKING:
    from calc.design.addresses import Table
    from calc.draw.drawing import Sketch
    from calc.solve import Results

RECENT = 4  # designs that are listed beside the last one


@dataclass(frozen=True)
class Beginning:
    """One way to begin.  `id`: of an engine, or a path.  `about` and `size` stand beside the title, `edited` of a
    design that has unsaved edits."""

    kind: Literal["file", "engine", "own", "open", "example"]
    id: str
    title: Text | str
    about: Text | str = EMPTY
    size: Text = EMPTY
    edited: bool = False
    words: tuple[Text | str, ...] = ()  # what else finds it
    sought: bool = False  # it is listed only where words find it

    def found_by(self, say: Language) -> str:
        """Words that find it beside its title, in a language and as they are written here."""
        return " ".join([self.id, *(f"{say(words)} {words}" for words in (self.about, *self.words))])

    @property
    def key(self) -> str:
        return f"{self.kind}:{self.id}"


def groups(memory: Memory, missing: Path | None = None) -> list[tuple[Text, list[Beginning]]]:
    """All ways to begin, under their headings; for a file that is not there, those that make it."""
    begin = (Text("Begin with an engine: every number of it can be replaced by your own"), with_engines())
    example = Beginning(
        "example", str(EXAMPLE), Text("The worked example"), Text("a published design that fails: see where, and why")
    )
    if missing is not None:
        return [begin]
    designs = [_of_file(path, memory) for path in memory.recent()[: RECENT + 1]]
    files = [Beginning("open", "", Text("Open a file …"), Text("a design that is there already")), example]
    sections = [(Text("Go on with"), designs[:1]), (Text("Recent"), designs[1:]), (Text("Open"), files), begin]
    return [(heading, rows) for heading, rows in sections if rows]


# --- engines
# Blank ones, of which nothing is known but how the cylinders stand and fire, and those that come with the program.

OWN_WORDS = Text("own new blank mine diesel petrol gasoline")  # of any blank engine: it burns what one likes
OWN = Beginning(
    "own",
    "",
    Text("Own engine"),
    Text("blank: say layout and number (own 4, v 6)"),
    words=(OWN_WORDS,),
)
LAYOUTS = {  # what an engine is called, and how else: `{n}` is its number of cylinders, as a figure and in words
    "inline": (Text("inline {n}"), Text("i{n} i-{n} l{n} r{n} straight-{n} in-line in line parallel {n}")),
    "vee": (Text("V{n}"), Text("vee v {n} v-{n}")),
    "boxer": (Text("boxer {n}"), Text("flat {n} flat-{n} h{n} opposed")),
    "w": (Text("W{n}"), Text("w {n} w-{n}")),
    "radial": (Text("radial {n}"), Text("star {n}")),
}
NUMBERS = {
    1: Text("single"), 2: Text("twin"), 3: Text("triple"), 4: Text("four"), 5: Text("five"), 6: Text("six"),
    8: Text("eight"), 10: Text("ten"), 12: Text("twelve"),
}  # fmt: skip
ALSO = {2: Text("two"), 3: Text("three")}
# engines of which none is listed: the crank is to be filled in
FURTHER = {"inline": range(1, 13), "vee": (2, 4, 6, 8, 10, 12, 16), "boxer": (2, 4, 6, 8), "w": (8, 12, 16),
           "radial": (3, 5, 7, 9)}  # fmt: skip


def with_engines() -> list[Beginning]:
    """Own engines first, then those that come with the program."""
    blank_rows = [
        Beginning("own", id, _own_name(table), what, words=(Text("own blank"), *_words(table)), sought=True)
        for id, (what, table) in _blanks().items()
    ]
    listed = [
        Beginning("engine", id, engine.name, engine.what, _size(table), words=(*_words(table), *_of_listed(engine)))
        for id, engine in engines().items()
        for table in (engine_table(id),)
    ]
    return [OWN, *blank_rows, *listed]


@cache
def _blanks() -> "dict[str, tuple[Text, Table]]":
    """What each blank engine is, and all that it has: how the cylinders of the listed ones stand and fire, and what no
    listed one has."""
    blanks: dict[str, tuple[Text, Table]] = {}
    for id, engine in engines().items():
        stands = {key: value for key, value in engine_table(id).items() if key in STANDS}
        # of two alike the one that says no more than that
        alike = next((other for other, (_, table) in blanks.items() if table == stands), None)
        if alike is None or len(engine.what) < len(blanks[alike][0]):
            blanks.pop(alike or "", None)
            blanks[id] = engine.what, stands
    there = {(table["layout"], table["cylinders"]) for _, table in blanks.values()}
    for layout, numbers in FURTHER.items():
        for n in (n for n in numbers if (layout, n) not in there):
            table: Table = {"layout": layout, "cylinders": n, "strokes": 4}
            blanks[f"{layout}-{n}"] = Text(LAYOUTS[layout][0].template, n=n), table
    return dict(sorted(blanks.items(), key=_order))


def _order(blank: "tuple[str, tuple[Text, Table]]") -> tuple[int, int]:
    """Inline engines first, each layout by its number of cylinders."""
    table = blank[1][1]
    return list(LAYOUTS).index(str(table["layout"])), int(str(table["cylinders"]))


def _own_name(engine: "Table") -> Text:
    return Text("Own {engine}", engine=Text(LAYOUTS[str(engine["layout"])][0].template, n=engine["cylinders"]))


def _words(engine: "Table") -> Iterator[Text | str]:
    """What an engine is called beside its name."""
    layout, n = str(engine["layout"]), int(str(engine["cylinders"]))
    yield Text("{n} cylinders", n=n)
    for number in filter(None, (n, NUMBERS.get(n), ALSO.get(n))):
        yield from (Text(words.template, n=number) for words in LAYOUTS[layout])


def _of_listed(engine: ShippedEngine) -> Iterator[Text | str]:
    """What it burns, and on what its balance shafts run, in words."""
    yield engine.kind
    yield Text("diesel") if "diesel" in engine.kind else Text("petrol gasoline")
    if rolling := [kind for kind in engine.bearings if kind != "plain"]:
        yield from (choice_word("rolling"), *map(choice_word, rolling))


def _of_file(path: Path, memory: Memory) -> Beginning:
    edited = bool(memory.kept(path))
    if not is_file(path):
        return Beginning(
            "file", str(path), path.name, Text("never saved, kept in {folder}", folder=shown(path.parent)), edited=True
        )
    about = (
        Text("edits not saved, in {folder}", folder=shown(path.parent))
        if edited
        else Text("in {folder}", folder=shown(path.parent))
    )
    return Beginning("file", str(path), path.name, about, edited=edited)


def shown(folder: Path) -> str:
    """A folder as short as it can be said."""
    try:
        return str(Path("~") / folder.relative_to(Path.home()))
    except (ValueError, RuntimeError):
        return str(folder)


def _size(engine: dict[str, Any]) -> Text:
    bore, stroke = float(engine[dotted(EngineInputs.bore)]), 2 * float(engine[dotted(EngineInputs.crank_radius)])
    return Text("{bore} × {stroke}", bore=Amount(bore, form="g"), stroke=Amount(stroke, "mm", form="g"))


def own_file(id: str, folder: Path) -> Path:
    """The name that a design of an engine is offered: that of its layout, never of another's engine."""
    table = _blanks()[id][1] if id in _blanks() else engine_table(id)
    name = id if id.startswith(tuple(LAYOUTS)) or id in _blanks() else f"{table['layout']}-{table['cylinders']}"
    return free_name(folder / f"own-{name}.toml")


def blank(id: str, path: Path) -> "Table":
    """A design with nothing but a blank engine, whose numbers are all to be filled in."""
    return {"schema": SCHEMA, "name": path.stem, "engine": {"name": path.stem, **_blanks()[id][1]}}


def engine_only(id: str, path: Path) -> "Table":
    """A design with nothing but an engine, both named like its file: its steps are built one by one, its numbers are
    replaced, and its note says which are not yet."""
    engine = {**engine_table(id), "name": path.stem}
    return {"schema": SCHEMA, "name": path.stem, "note": begun_note(id), "engine": engine}


@dataclass(frozen=True)
class Finding:
    """What is known of a way to begin once it was solved, and its picture; of an engine what shakes and the balancing
    that it calls for."""

    lines: tuple[Text, ...]
    sketch: "Sketch | None" = None
    shakes: Text = EMPTY
    balancing: Text = EMPTY


def finding(row: Beginning, memory: Memory) -> Finding:
    """Solve it; takes from 20 ms for an engine to a second for a design.  Raises BadInput."""
    return _shaking(row.id) if row.kind == "engine" else Finding(tuple(_verdicts(_solved(Path(row.id), memory))))


def _solved(path: Path, memory: Memory) -> "Results":
    """A design as it would be opened: with the edits that were kept."""
    from calc.solve import solve

    for kept in memory.left(path)[:1]:
        with suppress(BadInput):
            return solve(design(Document(kept.data)))
    return solve(design(read(path)))


def _verdicts(results: "Results") -> list[Text]:
    """What a design comes to, in a few lines: its state, and what fails by its name; else what was judged."""
    lost = [outcome.reason for outcome in results.outcomes.values() if outcome.state == "no_solution"]
    fails = [group[0] for group in grouped(results.checks()) if group[0].verdict == "fail"]
    lines = [results.words(), *(Text("No solution: {reason}", reason=reason) for reason in lost)]
    lines += [
        Text("{name}: {value}, {limit}", name=c.name, value=Amount(c.value, c.unit), limit=c.limit_text())
        for c in fails
    ]
    return lines if len(lines) > 1 else [*lines, limits_hold(results)]


def _shaking(id: str) -> Finding:
    """What the crank train of a shipped engine leaves, and what balancing it calls for."""
    from calc.engine.sketch import icon
    from calc.studies.starter.balancing import options, shakes_briefly, what_shakes, with_imbalance

    document = Document({"schema": SCHEMA, "name": id, "engine": engine_table(id)})
    results = with_imbalance(document)
    best = next(option for option in options(document, results) if option.called_for)
    lines = (
        Text("Shakes: {what}.", what=what_shakes(results)),
        Text("It calls for: {balancing}.", balancing=best.label),
        best.why,
    )
    engine = design(document).engine
    return Finding(
        tuple(filter(None, lines)), icon(engine) if engine is not None else None, shakes_briefly(results), best.label
    )
