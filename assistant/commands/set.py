# SPDX-License-Identifier: Apache-2.0
"""`contralbero set`: edit a design file in place.  The file is written only if the whole design is still valid."""

from argparse import Namespace
from pathlib import Path

from assistant.commands.check import changed
from assistant.plain import print_summary
from assistant.saving import edited_text, write_atomic
from calc.design_file import parse_assignment, read
from calc.sheet.errors import BadInput, InputError
from calc.solve import solve


def run(asked: Namespace) -> int:
    path = Path(asked.file)
    document = read(path)
    _, made = changed(document, asked.changes)
    text = edited_text(document.raw.decode("utf-8"), dict(parse_assignment(change) for change in asked.changes))
    try:
        write_atomic(path, text.encode("utf-8"))
    except OSError as error:
        raise BadInput(str(path), [InputError(0, "", "", f"cannot be written: {error.strerror or error}")]) from None
    print_summary(solve(made))
    print(f"\n{path} is written; as it was before: {path}.bak")
    return 0
