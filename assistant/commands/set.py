# SPDX-License-Identifier: Apache-2.0
"""`contralbero set`: edit a design file in place.  The file is written only if the whole design is still valid."""

from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path

from assistant.commands.check import changed
from assistant.plain import print_summary
from assistant.saving import edited_text, write_asked
from calc.addresses import parse_assignment
from calc.design_file import Document, read
from calc.solve import solve


def run(asked: Namespace) -> int:
    path = Path(asked.file)
    edit(path, read(path), asked.changes)
    print(f"\n{path} is written; as it was before: {path}.bak")
    return 0


def edit(path: Path, document: Document, changes: Sequence[str]) -> None:
    """Put KEY=VALUE changes into the file of a document, and print the verdicts of the design that it is then."""
    _, made = changed(document, changes)
    write_asked(path, edited_text(document.raw.decode("utf-8"), dict(parse_assignment(change) for change in changes)))
    print_summary(solve(made))
