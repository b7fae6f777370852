# SPDX-License-Identifier: Apache-2.0
"""`contralbero schema`: the JSON Schema of a design file, by which editors complete and check it."""

import json
from argparse import Namespace
from pathlib import Path

from assistant.session.saving import write_asked
from calc.design.schema import schema


def run(asked: Namespace) -> int:
    text = json.dumps(schema(), ensure_ascii=False, indent=1) + "\n"
    if asked.output is None:
        print(text, end="")
    else:
        write_asked(Path(asked.output), text)
        print(asked.output)
    return 0
