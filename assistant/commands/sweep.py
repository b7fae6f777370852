# SPDX-License-Identifier: Apache-2.0
"""`contralbero sweep`: many designs at once, a row of a CSV table for each."""

import sys
from argparse import Namespace
from collections import Counter
from pathlib import Path

from assistant.commands.check import changed, known_step
from assistant.plain import sign
from assistant.saving import spare, write_asked
from calc.design_file import read
from calc.sheet.check import ORDER
from calc.sweep import sweep, varied


def run(asked: Namespace) -> int:
    known_step(asked.step)
    if asked.output is not None:
        spare(Path(asked.output), asked.file)
    document, _ = changed(read(asked.file), asked.changes)
    swept = sweep(document, varied(document, asked.vary), asked.step, asked.values)
    counts = Counter(swept.verdicts)
    summary = f"{len(swept.rows)} designs: " + ", ".join(f"{counts[v]} {sign(v)}" for v in ORDER if counts[v])
    if asked.output is None:
        swept.write(sys.stdout)
        print(summary, file=sys.stderr)
        return 0
    from io import StringIO

    path = Path(asked.output)
    text = StringIO()
    swept.write(text)
    write_asked(path, text.getvalue(), inputs=[asked.file])
    print(f"{summary}\n{path}: {len(swept.header)} columns")
    return 0
