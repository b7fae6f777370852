# SPDX-License-Identifier: Apache-2.0
"""`contralbero set`: edit a design file in place.  The file is written only if the whole design is still valid."""

from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path

from assistant.commands.check import changed
from assistant.plain import print_summary
from assistant.session.saving import asked_for, edited_text
from calc.design.addresses import parse_assignment
from calc.design.model import Design
from calc.design.toml_file import parse, read
from calc.design.disk import edit_file
from calc.design.limits import DESIGN_BYTES
from calc.solve import solve


def run(asked: Namespace) -> int:
    path = Path(asked.file)
    read(path)  # what is wrong with it is said as of any design
    edit(path, asked.changes)
    print(f"\n{path} is written; as it was before: {path}.bak")
    return 0


def edit(path: Path, changes: Sequence[str]) -> None:
    """Put KEY=VALUE changes into a design as its file has it when nobody else writes, and print the verdicts that it has then."""
    made: Design

    def edited(raw: bytes) -> bytes:
        nonlocal made
        _, made = changed(parse(raw, str(path)), changes)
        return edited_text(raw.decode("utf-8"), dict(parse_assignment(change) for change in changes)).encode("utf-8")

    with asked_for(path):
        edit_file(path, DESIGN_BYTES, edited)
    print_summary(solve(made))
