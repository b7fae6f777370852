# SPDX-License-Identifier: Apache-2.0
"""`contralbero choose`: search for the user; a ranked table, and `--apply N` writes one row into the design file.

What can be chosen for a step stands in `choose_STEP.py`: what it NEEDS and WHY, and `offer()`.
"""

import json
import sys
from argparse import Namespace
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from assistant.commands.set import edit
from assistant.plain import table_json, table_lines
from calc.design_file import design, read
from calc.sheet.errors import BadInput, InputError, NoSolution
from calc.sheet.step import Table

CHOICES = {
    "engine": "firing orders, the one that leaves least first",
    "countershaft": "shafts in the envelope, the lightest first",
    "bearings": "plain bearings that pass at every corner, the nearest and the least power first",
}


@dataclass(frozen=True)
class Offer:
    """What was found: how many rows, the table of the first of them, and for each row (from 1) the keys to write and what is then said."""

    count: int
    table: Callable[[int], Table]
    changes: Callable[[int], list[str]]
    said: Callable[[int], str]
    hint: str
    beside: Callable[[], tuple[Table, ...]] = tuple  # further tables


def run(asked: Namespace) -> int:
    if asked.step not in CHOICES:
        known = ", ".join(f"{step} ({what})" for step, what in CHOICES.items())
        raise BadInput(
            "contralbero choose", [InputError(0, "STEP", asked.step, f"there is nothing to choose here yet; there is for {known}")]
        )
    document = read(asked.file)
    made = design(document)
    step = import_module(f"assistant.commands.choose_{asked.step}")
    missing = next((key for key in step.NEEDS if getattr(made, key) is None), None)
    if missing is not None:
        raise BadInput(asked.file, [InputError(0, missing, "", f"needed: {step.WHY}")])
    if asked.top < 1:
        raise BadInput("--top", [InputError(0, "", str(asked.top), "must be a number of rows, 1 or more")])
    try:
        offer: Offer = step.offer(made, asked.file)
    except NoSolution as none:
        print(f"{asked.file}: {asked.step}: {none}", file=sys.stderr)
        return 3
    if asked.apply is not None:
        if not 1 <= asked.apply <= offer.count:
            raise BadInput("--apply", [InputError(0, "", str(asked.apply), f"must be a row of the table, from 1 to {offer.count}")])
        try:
            changes = offer.changes(asked.apply)
        except NoSolution as none:
            print(f"{asked.file}: {asked.step}: {none}", file=sys.stderr)
            return 3
        edit(Path(asked.file), document, changes)
        print(f"\n{asked.file} {offer.said(asked.apply)}; as it was before: {asked.file}.bak")
        return 0
    table = offer.table(asked.top)
    if asked.json:
        beside = {one.id: table_json(one) for one in offer.beside()}
        found = {"schema": 1, "step": asked.step, **table_json(table), **({"tables": beside} if beside else {})}
        print(json.dumps(found, ensure_ascii=False, indent=1))
        return 0
    print("\n".join(table_lines(table)))
    for one in offer.beside():
        print("\n" + "\n".join(table_lines(one)))
    print(f"\n{offer.hint}")
    return 0
