# SPDX-License-Identifier: Apache-2.0
"""`contralbero replay`: run scripted designs and compare with what they expect.

A replay may be a stranger's: the reports that it asks for are new files beside it, or take the place of reports of this program.
"""

from argparse import Namespace
from pathlib import Path

from assistant.session.saving import asked_for
from calc.design import replay
from calc.design.toml_file import Document
from calc.design.disk import read_file, write_file
from calc.design.limits import PDF_BYTES
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.solve import Results


def run(asked: Namespace) -> int:
    scripts = [replay.load(file) for file in asked.files]
    for script in scripts:
        for step in script.steps:
            if "report" in step:
                _replaced(replay.target(script, step))
    differs = False
    for script in scripts:
        compared = replay.run(script, _report)
        failed = [c for c in compared if not c.agrees]
        differs |= bool(failed) or not compared
        agree = Text("{n} of {all} as expected", n=len(compared) - len(failed), all=len(compared))
        print(f"{script.place}: {agree if compared else Text('nothing was compared: it has no [[expect]]')}")
        for c in failed:
            print(f"  {c.text}")
    return 1 if differs else 0


def _report(document: Document, results: Results, path: Path) -> None:
    import tomli_w

    from reports.report import render

    print(Text("writes {path}", path=str(path)), flush=True)
    old = _replaced(path)
    made = render(document, results, tomli_w.dumps(document.data).encode("utf-8"))
    with asked_for(path):
        write_file(path, made, expected=old, new=old is None)


def _replaced(path: Path) -> bytes | None:
    """The report that stands where one is to be written, None where nothing does.  Raises BadInput for anything else."""
    with asked_for(path):
        if not path.is_symlink() and not path.exists():
            return None
        raw = read_file(path, PDF_BYTES)
    from reports.verify.verify import is_report

    if path.is_symlink() or not is_report(raw):
        reason = Text("is there, and is no report as this program writes it; a replay leaves it alone: move it away, or run it elsewhere")
        raise BadInput(str(path), [InputError(0, "", "", reason)])
    return raw
