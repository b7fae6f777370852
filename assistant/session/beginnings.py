# SPDX-License-Identifier: Apache-2.0
"""What a session may begin with: the last design, an engine that comes with the program, a file, the worked example."""

from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from calc.design.model import SCHEMA
from calc.design.toml_file import Document, design, read
from calc.engine.inputs import EngineInputs
from calc.sheet.errors import BadInput
from calc.sheet.quantity import dotted
from calc.sheet.text import EMPTY, Amount, Text
from calc.sheet.verdict import grouped
from calc.studies.ready import limits_hold
from calc.studies.shipped import EXAMPLE, engine_table, engines

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

    kind: Literal["file", "engine", "open", "example"]
    id: str
    title: Text | str
    about: Text | str = EMPTY
    size: Text = EMPTY
    edited: bool = False
    words: str = ""  # what else finds it

    @property
    def key(self) -> str:
        return f"{self.kind}:{self.id}"


def groups(memory: Memory, missing: Path | None = None) -> list[tuple[Text, list[Beginning]]]:
    """All ways to begin, under their headings; for a file that is not there, those that make it."""
    engine_rows = [
        Beginning("engine", id, engine.name, engine.what, _size(engine_table(id)), words=_words(engine_table(id)))
        for id, engine in engines().items()
    ]
    begin = (Text("Begin with an engine: every number of it can be replaced by your own"), engine_rows)
    example = Beginning(
        "example", str(EXAMPLE), Text("The worked example"), Text("a published design that fails: see where, and why")
    )
    if missing is not None:
        return [begin]
    designs = [_of_file(path, memory) for path in memory.recent()[: RECENT + 1]]
    files = [Beginning("open", "", Text("Open a file …"), Text("a design that is there already")), example]
    sections = [(Text("Go on with"), designs[:1]), (Text("Recent"), designs[1:]), (Text("Open"), files), begin]
    return [(heading, rows) for heading, rows in sections if rows]


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


def _words(engine: dict[str, Any]) -> str:
    """What an engine is called beside its name: any of them may become one's own, of either fuel."""
    parallel = "parallel twin" if (engine["layout"], engine["cylinders"]) == ("inline", 2) else ""
    return f"own new engine diesel petrol gasoline {engine['layout']} {engine['cylinders']} cylinders {parallel}"


def own_file(id: str, folder: Path) -> Path:
    """The name that a design of an engine is offered."""
    return free_name(folder / f"own-{id}.toml")


def engine_only(id: str, path: Path) -> "Table":
    """A design with nothing but an engine, both named like its file: its steps are built one by one, its numbers are
    replaced."""
    engine = engines()[id]
    note = f"{_begun_with(engine.name)} {engine.what}. They are from: {engine.source}."
    return {"schema": SCHEMA, "name": path.stem, "note": note, "engine": {**engine_table(id), "name": path.stem}}


def _begun_with(name: str) -> str:
    return f"Begun with the data of {name}:"


@cache
def sample(note: str) -> "tuple[str, Table]":
    """The name and the table of the engine that a design began with, as its note says; empty where it says none."""
    of = next((id for id, engine in engines().items() if note.startswith(_begun_with(engine.name))), None)
    return ("", {}) if of is None else (engines()[of].name, engine_table(of))


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
