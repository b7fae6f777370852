# SPDX-License-Identifier: Apache-2.0
"""`contralbero report`: the PDF calculation report, and the verdicts on the screen."""

import gc
from argparse import Namespace
from pathlib import Path

from assistant.plain import print_summary
from calc.design_file import design, read
from calc.sheet.errors import BadInput, InputError
from calc.solve import solve


def run(asked: Namespace) -> int:
    gc.disable()  # the process ends with the report; looking for garbage took a tenth of it
    source = Path(asked.file)
    document = read(source)
    results = solve(design(document))
    target = Path(asked.output) if asked.output else Path(source.stem + ".pdf")
    from reports.report import write

    try:
        write(document, results, source.read_bytes(), target, depth=asked.depth, lang=asked.lang)
    except OSError as error:
        raise BadInput(
            str(target), [InputError(0, "", "", f"cannot be written: {error.strerror or error}; choose another place with -o")]
        ) from None
    print_summary(results)
    print(f"\n{target}")
    return 0
