# SPDX-License-Identifier: Apache-2.0
"""`contralbero choose`: search for the user; a ranked table, and `--apply N` writes one row into the design file."""

import json
import sys
from argparse import Namespace
from pathlib import Path

from assistant.commands.set import edit
from assistant.plain import table_json, table_lines
from calc.design_file import Document, design, read
from calc.engine import solve as engine
from calc.imbalance.firing_orders import FiringOrder, as_designed, crank_words, firing_orders, orders_table
from calc.sheet.errors import BadInput, InputError, NoSolution

CHOICES = {"engine": "firing orders, the one that leaves least first"}


def run(asked: Namespace) -> int:
    if asked.step not in CHOICES:
        known = ", ".join(f"{step} ({what})" for step, what in CHOICES.items())
        raise BadInput(
            "contralbero choose", [InputError(0, "STEP", asked.step, f"there is nothing to choose here yet; there is for {known}")]
        )
    document = read(asked.file)
    made = design(document)
    if made.engine is None or made.imbalance is None:
        missing = "engine" if made.engine is None else "imbalance"
        raise BadInput(asked.file, [InputError(0, missing, "", "needed: firing orders are ranked by what they leave of the imbalance")])
    if asked.top < 1:
        raise BadInput("--top", [InputError(0, "", str(asked.top), "must be a number of rows, 1 or more")])
    e = engine.values(made.engine)
    try:
        found = firing_orders(made.imbalance, made.engine, e)
    except NoSolution as none:
        print(f"{asked.file}: engine: {none}", file=sys.stderr)
        return 3
    if asked.apply is not None:
        return _apply(document, Path(asked.file), found, asked.apply)
    table = orders_table(found, asked.top, as_designed(made.imbalance, made.engine, e), made.engine)
    if asked.json:
        print(json.dumps({"schema": 1, "step": "engine", **table_json(table)}, ensure_ascii=False, indent=1))
        return 0
    print("\n".join(table_lines(table)))
    print("\n`--apply N` writes the N-th order into the design, and the crank angles out of it; `--top N` shows more.")
    return 0


def _apply(document: Document, path: Path, found: list[FiringOrder], number: int) -> int:
    if not 1 <= number <= len(found):
        raise BadInput("--apply", [InputError(0, "", str(number), f"must be a row of the table, from 1 to {len(found)}")])
    one = found[number - 1]
    edit(path, document, [f"engine.firing_order={list(one.order)}", "engine.crank_angles_deg="])
    print(
        f"\n{path} now fires {'-'.join(map(str, one.order))} (crank angles {crank_words(one.crank_angles)}°); as it was before: {path}.bak"
    )
    return 0
