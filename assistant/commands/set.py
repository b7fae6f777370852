# SPDX-License-Identifier: Apache-2.0
"""`contralbero set`: edit a design file in place.  The file is written only if the whole design is still valid."""

from argparse import Namespace
from pathlib import Path

from assistant.commands.check import with_changes
from assistant.plain import print_summary
from assistant.saving import edited_text, write_atomic
from calc.design_file import design, parse_assignment, read
from calc.solve import solve


def run(asked: Namespace) -> int:
    path = Path(asked.file)
    document = read(path)
    made = design(with_changes(document, asked.changes))
    text = edited_text(path.read_text(encoding="utf-8"), dict(parse_assignment(change) for change in asked.changes))
    write_atomic(path, text.encode("utf-8"))
    print_summary(solve(made))
    return 0
