# SPDX-License-Identifier: Apache-2.0
"""`contralbero report`: the PDF calculation report, and the verdicts on the screen."""

import gc
from argparse import Namespace
from pathlib import Path

from assistant.plain import print_summary
from assistant.saving import spare
from calc.design_file import design, read
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.solve import solve


def run(asked: Namespace) -> int:
    source = Path(asked.file)
    document = read(source)
    target = Path(asked.output) if asked.output else Path(source.stem + ".pdf")
    spare(target, asked.file)
    gc.disable()  # looking for garbage takes a tenth of a report, and hardly any is made
    try:
        results = solve(design(document), traced=True)
        from reports.report import write

        write(document, results, document.raw, target, depth=asked.depth, lang=asked.lang)
    except OSError as error:
        raise BadInput(
            str(target),
            [InputError(0, "", "", Text("cannot be written: {reason}; choose another place with -o", reason=error.strerror or str(error)))],
        ) from None
    finally:
        gc.enable()
    print_summary(results)
    print(f"\n{target}")
    return 0
