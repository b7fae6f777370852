# SPDX-License-Identifier: Apache-2.0
"""`contralbero scenarios` and `contralbero replay`: several conditions side by side, and scripted designs run again.

scenarios: a train under several conditions, by the judged model and by the friction source's.  Without a file: the
three scenarios of the gear friction thesis.  With -o, the curves of each design as CSV, and its report as PDF.  replay:
runs scripted designs and compares with what they expect."""

import csv
import json
import sys
from argparse import Namespace
from io import StringIO
from pathlib import Path
from typing import Any

import tomli_w

from assistant.results_text import table_json, table_lines
from assistant.session.saving import asked_for, edited_text, make_folder, spare, write_asked
from calc.design import replay
from calc.design.disk import read_file, write_file
from calc.design.limits import PDF_BYTES
from calc.design.model import Design
from calc.design.toml_file import Document, design, read
from calc.friction.inputs import FrictionInputs
from calc.friction.result import FrictionResult
from calc.friction.studies.scenarios import ALONG, MODELS, tables
from calc.sheet.errors import BadInput, InputError
from calc.sheet.quantity import dotted
from calc.sheet.step import Outcome, Table
from calc.sheet.text import Text
from calc.sheet.version import VERSION
from calc.solve import Results, solve
from calc.studies.shipped import SCENARIOS

HOW = "give [[friction.scenarios]]: name, and oil, oil_temperature_C, load_sharing, flank_roughness_um or power_kW"


def run_scenarios(asked: Namespace) -> int:
    """Exit code 3 where a design has no solution; nothing is judged."""
    files = [Path(name) for name in asked.files] or list(SCENARIOS)
    solved = [(path, *_solved(path)) for path in files]
    unsolved = [
        (path, outcome) for path, _, results in solved if (outcome := results.outcomes["friction"]).result is None
    ]
    cases = [
        (path, document, results, f)
        for path, document, results in solved
        if (f := results.result(FrictionResult)) is not None
    ]
    shown = [(path, results.design.name, _tables(f, results.outcomes["friction"])) for path, _, results, f in cases]
    written = _write(Path(asked.output), cases) if asked.output else []
    if asked.json:
        designs = [
            {"file": path.name, "name": name, "tables": {t.id: table_json(t) for t in shown_tables}}
            for path, name, shown_tables in shown
        ]
        print(
            json.dumps(
                {"schema": 1, "program": "contralbero", "version": VERSION, "designs": designs},
                ensure_ascii=False,
                indent=1,
            )
        )
    else:
        for n, (_, name, shown_tables) in enumerate(shown):
            print(("\n" if n else "") + name)
            for table in shown_tables:
                print("\n" + "\n".join(f"  {line}".rstrip() for line in table_lines(table)))
        for path in written:
            print(("\n" if path is written[0] else "") + str(path))
        if not asked.files:
            print("\ndesigns/friction_source.md tells what of the thesis' statements holds, with these numbers.")
        if not asked.output:
            print("-o FOLDER writes nine curves of each design as CSV, and a report that draws them.")
    for path, outcome in unsolved:
        print(f"{path}: friction: {outcome.reason or outcome.state}", file=sys.stderr)
    return 3 if unsolved else 0


def _solved(path: Path) -> tuple[Document, Results]:
    document = read(path)
    parsed = design(document)
    if parsed.friction is None or not parsed.friction.scenarios:
        key = dotted(Design.friction, FrictionInputs.scenarios)
        raise BadInput(str(path), [InputError(0, key, "", Text("there are none; {how}", how=HOW))])
    return document, solve(parsed)


def _tables(friction: FrictionResult, outcome: Outcome[object]) -> tuple[Table, ...]:
    """The scenarios, then what other models say at the design's own conditions."""
    return *tables(friction), *(table for table in outcome.tables if table.id.startswith("models_"))


def _write(folder: Path, cases: list[tuple[Path, Document, Results, FrictionResult]]) -> list[Path]:
    """The files that were written."""
    from reports.report import write

    make_folder(folder, "-o")
    written: list[Path] = []
    inputs = [path for path, *_ in cases]
    for path, document, results, friction in cases:
        curves, report = folder / f"{path.stem}_curves.csv", folder / f"{path.stem}.pdf"
        for target in (curves, report):
            if target in written:
                raise BadInput(
                    str(target),
                    [InputError(0, "-o", "", Text("would be written for two designs; give them different names"))],
                )
            spare(target, *inputs)
        write_asked(curves, curves_text(friction.scenarios or {}), inputs=inputs)
        with asked_for(report):
            write(document, results, document.raw, report)
        written += [curves, report]
    return written


def curves_text(scenarios: dict[str, Any]) -> str:
    """Along the path of every mesh: a row a position, for each scenario and model, in the units that the heads tell."""
    file = StringIO()
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(("mesh", "model", "scenario", "x, mm", *(label for _, _, label, _ in ALONG)))
    for name, scenario in scenarios.items():
        for key, mesh in scenario.meshes.items():
            for model, words in MODELS:
                local = getattr(mesh, model).local
                columns = [getattr(local, attribute) * factor for attribute, _, _, factor in ALONG]
                for x, *values in zip(local.x * 1e3, *columns):
                    rows.writerow((key, words, name, f"{x:.6g}", *(f"{value:.6g}" for value in values)))
    return file.getvalue()


# --- contralbero replay
# A replay may be a stranger's: the reports that it asks for are new files beside it, or take the place of reports of
# this program.


def run_replay(asked: Namespace) -> int:
    scripts = [replay.load(file) for file in asked.files]
    for script in scripts:
        for step in script.steps:
            if "report" in step:
                _replaced(replay.target(script, step))
    differs = False
    for script in scripts:
        compared = replay.run(script, solve, _report)
        updated = _update(script, replay.moved(compared)) if asked.update else []
        failed = [c for c in compared if not c.agrees and c not in updated]
        differs |= bool(failed) or not compared
        agree = Text("{n} of {all} as expected", n=len(compared) - len(failed), all=len(compared))
        print(f"{script.place}: {agree if compared else Text('nothing was compared: it has no [[expect]]')}")
        for c in updated:
            print(f"  {c.about}: {c.expected} → {c.found}")
        for c in failed:
            print(f"  {c.text}")
    return 1 if differs else 0


def _update(script: replay.Script, moved: dict[int, replay.Compared]) -> list[replay.Compared]:
    """Writes into the replay what its recorded expectations have come to; comments stay."""
    if moved:
        changes = [(("expect", n, c.under), c.now) for n, c in moved.items()]
        write_asked(Path(script.place), edited_text(script.raw.decode("utf-8"), changes), expected=script.raw)
    return [*moved.values()]


def _report(document: Document, results: Results, path: Path) -> None:
    from reports.report import render

    print(Text("writes {path}", path=str(path)), flush=True)
    old = _replaced(path)
    pdf = render(document, results, tomli_w.dumps(document.data).encode("utf-8"))
    with asked_for(path):
        write_file(path, pdf, expected=old, new=old is None)


def _replaced(path: Path) -> bytes | None:
    """The report that stands where one is to be written, None where nothing does.  Raises BadInput for anything
    else."""
    with asked_for(path):
        if not path.is_symlink() and not path.exists():
            return None
        raw = read_file(path, PDF_BYTES)
    from reports.pdf.attach import is_report

    if path.is_symlink() or not is_report(raw):
        reason = Text(
            "is there, and is no report as this program writes it; a replay leaves it alone: move it away, or run it "
            "elsewhere"
        )
        raise BadInput(str(path), [InputError(0, "", "", reason)])
    return raw
