# SPDX-License-Identifier: Apache-2.0
"""What comes with the program: complete designs, and engines to begin a design with."""

import json
import tomllib
from copy import deepcopy
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, TypedDict

from ..design.addresses import as_table
from ..design.model import SCHEMA, Design
from ..design.toml_file import Document, design, parse
from ..imbalance.inputs import ImbalanceInputs
from ..library.table_file import parsed, text_of_table
from ..sheet.errors import BadInput, InputError
from ..sheet.quantity import dotted
from ..sheet.text import Text
from ..sheet.value import recorded

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ..design.addresses import Table
    from ..engine.inputs import EngineInputs

DESIGNS = Path(__file__).parents[2] / "designs"
MAKERS = "makers"  # the folder in it of journals as makers of engines print them
EXAMPLE = DESIGNS / "r753ie4_gamma.toml"
# of the gear friction thesis
SCENARIOS = tuple(DESIGNS / f"thesis_{name}.toml" for name in ("temperatures", "oils", "tip_relief"))


def designs() -> list[Path]:
    """The files of the complete designs; the journals of makers last."""
    return [*sorted(DESIGNS.glob("*.toml")), *sorted((DESIGNS / MAKERS).glob("*.toml"))]


def is_shipped(path: Path) -> bool:
    return path.resolve().is_relative_to(DESIGNS.resolve())


def shipped_name(path: Path) -> str:
    """r753ie4_gamma, makers/er6n."""
    return path.resolve().relative_to(DESIGNS.resolve()).with_suffix("").as_posix()


class _Row(TypedDict, total=False):
    """An engine as the table has it; `design`: the file that has it instead; `kind`: whose usual gas and flywheel it
    is given."""

    kind: str
    what: str
    source: str
    design: str
    engine: "Table"
    imbalance: "Table"
    arrangement: "Arrangement"


class Arrangement(TypedDict, total=False):
    """The shafts with which an engine is built: the balancing that they are and how they are carried and driven, or
    `without`, why it has none.  `bearings`: the kind of each, front to rear."""

    balancing: str
    bearings: list[str]
    built: str
    without: str
    source: str
    confidence: str


@dataclass(frozen=True)
class ShippedEngine:
    """An engine to begin with: its name, how its crank stands and fires, where its data come from, of what kind it is
    (as engine_motion.toml has them): petrol-charged, diesel-industrial, motorcycle …; `bearings`: on which its balance
    shafts run: plain, ball, roller, needle; empty where it has none."""

    name: str
    what: Text
    source: str
    kind: str
    bearings: tuple[str, ...]


@cache
def engines() -> "Mapping[str, ShippedEngine]":
    """The shipped engines by their id, the example first."""
    return {
        name: ShippedEngine(
            str(_engine(row)["name"]),
            Text(row["what"]),
            row["source"],
            row["kind"],
            tuple(row.get("arrangement", Arrangement()).get("bearings", ())),
        )
        for name, row in _rows().items()
    }


def engine_inputs(name: str) -> "EngineInputs":
    """The inputs of a shipped engine, without a design around them."""
    row = _rows()[name]
    if "design" in row:
        text = (DESIGNS / row["design"]).read_text(encoding="utf-8")
    else:
        text = _text(str(row["engine"]["name"]), "", f"[engine]\n{_lines(row['engine'])}")
    engine = design(parse(text.encode("utf-8"), name)).engine
    assert engine is not None, name
    return engine


def engine_design(
    name: str, balancing: str = "", changes: "Mapping[str, object] | None" = None, mounts: bool = False
) -> str:
    """The text of a design for a shipped engine: ready, with the shafts that it is built with, else without, and why.

    `balancing`: another one, by the id of an option; `changes`: keys of the engine that are others, for which all the
    rest is then built; `mounts`: with the engine on four mounts.  Raises NoSolution where the engine has nothing that
    the balancing takes."""
    row = _rows()[name]
    arrangement = row.get("arrangement", Arrangement())
    if "design" in row and not (balancing or changes or mounts):
        return (DESIGNS / row["design"]).read_text(encoding="utf-8")
    document = engine_alone(name, changes or {})
    own = [key for key in changes or {} if key not in (NAME, ENGINE_NAME)]
    half = {dotted(ImbalanceInputs.crank_balance_fraction): 0.5, dotted(ImbalanceInputs.kinematics): "exact"}
    document = document.with_value(dotted(Design.imbalance), half | row.get("imbalance", {}))
    from ..solve import solve
    from .starter.bearings import share_said
    from .starter.build import begun, built, mounting  # numpy, which a list of the engines does not need
    from .starter.gas import usual
    from .starter.writing import lines, written

    why = "" if balancing else arrangement.get("without", "")
    balancing = balancing or arrangement.get("balancing", "")
    if balancing not in ("", "shaft"):
        document = built(document, "imbalance", balancing)
    engine, imbalance = as_table(document.data["engine"]), as_table(document.data["imbalance"])
    title = str(document.data[NAME] if NAME in (changes or {}) else engine[NAME])
    given = design(document).engine
    assert given is not None
    with recorded(False):
        runs = usual(given, document, row["kind"])
    rest = f"{written(runs.gas)}\n[imbalance]\n{_lines(imbalance)}"
    body = f"[engine]\n{_lines(engine)}{lines(runs.rows)}{rest}"
    document = parse(_text(title, "", body).encode("utf-8"), name)
    # no number of what shakes: it would stay when the engine is edited
    words = dict(what=row["what"], source=row["source"], engine=name, keys=", ".join(own))
    kinds: tuple[str, ...] = ()
    note = Text("{what}. Data: {source}. What rules of this program have added is marked as assumed.", **words)
    if own:
        note = Text(
            "An engine of its own, by {keys}; all else of [engine] is that of the shipped {engine}, to be replaced. "
            "What rules of this program have added is marked as assumed.",
            **words,
        )
    elif balancing == arrangement.get("balancing") and "built" in arrangement:
        there = dict(note=note, built=arrangement["built"], source=arrangement["source"])
        note = Text("{note} Built with: {built} ({source}); here wheels drive it.", **there)
        kinds = tuple(arrangement.get("bearings", ()))
    with recorded(False):
        tables = begun(document, balancing, why, kinds)
        more = "".join(_assumed_rows(key, rows) for key, rows in tables.engine.items())
        body = f"[engine]\n{_lines(engine)}{lines(runs.rows)}{more}{rest}{tables.text}"
        text = _text(title, note, body)
        share = share_said(solve(design(parse(text.encode("utf-8"), name)), compared=False))
        text = _text(title, Text("{note} {share}", note=note, share=share), body) if share else text
        if mounts:
            document = parse(text.encode("utf-8"), name)
            text += written(mounting(document, solve(design(document))))
    return text


NAME = dotted(Design.name)
ENGINE_NAME = f"{dotted(Design.engine)}.{NAME}"


def engine_alone(name: str, changes: "Mapping[str, object]") -> Document:
    """A design of the engine alone with keys that are others; one with numbers of its own has a name of its own.

    Raises BadInput with all that is wrong of them."""
    engine = engine_table(name)
    document = Document({"schema": SCHEMA, "name": name, "engine": engine}, name)
    if not changes:
        return document
    errors: list[InputError] = []
    called = changes.get(NAME, engine[NAME] if set(changes) <= {ENGINE_NAME} else f"own-{name}")
    for key, value in {ENGINE_NAME: called, **changes}.items():
        try:
            document = document.with_value(key, value)
        except BadInput as bad:
            errors += bad.errors
    try:
        design(document)
    except BadInput as bad:
        errors += bad.errors
    if errors:
        raise BadInput("--set", errors)
    return document


def engine_table(name: str) -> "Table":
    """A shipped engine as the tables of a design have it."""
    return deepcopy(_engine(_rows()[name]))


def _text(name: str, note: str, tables: str) -> str:
    """The text of a whole design."""
    return f"{_lines({'schema': SCHEMA, 'name': name, 'note': note})}\n{tables}"


def _engine(row: _Row) -> "Table":
    """The engine of a row, which may stand in a complete design."""
    if "design" not in row:
        return row["engine"]
    engine: Table = tomllib.loads((DESIGNS / row["design"]).read_text(encoding="utf-8"))["engine"]
    return engine


@cache
def _rows() -> dict[str, _Row]:
    rows: dict[str, _Row] = parsed("engines.toml", text_of_table("engines.toml"))
    return rows


def _lines(table: "Table") -> str:
    """Key by key in TOML, each on one line."""
    return "".join(f"{key} = {_inline(value)}\n" for key, value in table.items())


def _assumed_rows(key: str, rows: "list[Table]") -> str:
    """A list of tables, each on one line."""
    return "".join(
        (
            f"{f'{key} = [':<31} # assumed: a usual share of the hours\n",
            *(f"    {_inline(row)},\n" for row in rows),
            "]\n",
        )
    )


def _inline(value: object) -> str:
    """Texts and numbers are written in TOML as in JSON."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_inline(part)}" for key, part in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_inline, value)) + "]"
    return json.dumps(value, ensure_ascii=False)
