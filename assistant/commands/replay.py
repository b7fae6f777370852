# SPDX-License-Identifier: Apache-2.0
"""`contralbero replay`: run scripted designs and compare with what they expect."""

from argparse import Namespace
from pathlib import Path

from calc import replay
from calc.design_file import Document
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.solve import Results


def run(asked: Namespace) -> int:
    differs = False
    for script in [replay.load(file) for file in asked.files]:
        compared = replay.run(script, _report)
        failed = [c for c in compared if not c.agrees]
        differs |= bool(failed)
        print(f"{script.place}: {len(compared) - len(failed)} of {len(compared)} as expected")
        for c in failed:
            print(f"  {c.text}")
    return 1 if differs else 0


def _report(document: Document, results: Results, path: Path) -> None:
    import tomli_w

    from reports.report import write

    try:
        write(document, results, tomli_w.dumps(document.data).encode("utf-8"), path)
    except OSError as error:
        raise BadInput(
            str(path), [InputError(0, "", "", Text("cannot be written: {reason}", reason=error.strerror or str(error)))]
        ) from None
