# SPDX-License-Identifier: Apache-2.0
"""`contralbero scenarios`: a train under several conditions side by side, by the judged model and by the friction
source's.

Without a file: the three scenarios of the gear friction thesis.  With -o, the curves of each design as CSV, and its
report as PDF."""

import csv
import json
import sys
from argparse import Namespace
from io import StringIO
from pathlib import Path
from typing import Any

from assistant.named_files import read_design
from assistant.results_text import table_json, table_lines
from assistant.session.saving import asked_for, make_folder, spare, write_asked
from calc.design.model import Design
from calc.design.toml_file import Document, design
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
    document = read_design(str(path))
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
