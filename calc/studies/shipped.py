# SPDX-License-Identifier: Apache-2.0
"""What comes with the program: complete designs, and engines to begin a design with."""

import json
import tomllib
from copy import deepcopy
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, TypedDict

from ..design.model import SCHEMA
from ..design.toml_file import design, parse
from ..imbalance.inputs import ImbalanceInputs
from ..library.table_file import parsed, text_of_table
from ..sheet.quantity import dotted
from ..sheet.text import Text
from ..sheet.value import recorded

if TYPE_CHECKING:
    from ..design.addresses import Table
    from ..engine.inputs import EngineInputs

DESIGNS = Path(__file__).parents[2] / "designs"
EXAMPLE = DESIGNS / "r753ie4_gamma.toml"
# of the gear friction thesis
SCENARIOS = tuple(DESIGNS / f"thesis_{name}.toml" for name in ("temperatures", "oils", "tip_relief"))


class _Row(TypedDict, total=False):
    """An engine as the table has it; `design`: the file that has it instead."""

    what: str
    source: str
    design: str
    engine: "Table"
    imbalance: "Table"


@dataclass(frozen=True)
class ShippedEngine:
    """An engine to begin with: its name, how its crank stands and fires, and where its data come from."""

    name: str
    what: Text
    source: str


def engines() -> dict[str, ShippedEngine]:
    """The shipped engines by their id, the example first."""
    return {
        name: ShippedEngine(str(_engine(row)["name"]), Text(row["what"]), row["source"])
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


def engine_design(name: str) -> str:
    """The text of a design for a shipped engine: ready, with a shaft where first order asks for one at −1, else
    without, and why."""
    row = _rows()[name]
    if "design" in row:
        return (DESIGNS / row["design"]).read_text(encoding="utf-8")
    engine, title = row["engine"], str(row["engine"]["name"])
    usual = {dotted(ImbalanceInputs.crank_balance_fraction): 0.5, dotted(ImbalanceInputs.kinematics): "exact"}
    imbalance = usual | row.get("imbalance", {})
    body = f"[engine]\n{_lines(engine)}\n[imbalance]\n{_lines(imbalance)}"
    from .starter.build import begun  # numpy, which a list of the engines does not need

    document = parse(_text(title, "", body).encode("utf-8"), name)
    # no number of what shakes: it would stay when the engine is edited
    words = dict(what=row["what"], source=row["source"])
    note = Text("{what}. Data: {source}. What rules of this program have added is marked as assumed.", **words)
    with recorded(False):
        return _text(title, note, body + begun(document))


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
    """Key by key in TOML, a list on one line; texts, numbers and lists of numbers are written there as in JSON."""
    return "".join(f"{key} = {json.dumps(value, ensure_ascii=False)}\n" for key, value in table.items())
