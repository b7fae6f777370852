# SPDX-License-Identifier: Apache-2.0
"""`contralbero fit`: inputs found from runs of the bench, or the sentence why they can not be.

`--apply` writes them into the design file, where they are identified, and shows what then holds."""

import json
import sys
import textwrap
from argparse import Namespace
from pathlib import Path
from typing import Any

from assistant.named_files import STANDARD, put, read_design, spoken
from assistant.results_text import LINE, check_json, finite, print_summary
from assistant.session.editing import locked_text
from assistant.session.fitted import fitted_text, with_fit
from assistant.session.saving import NeedsUpgrade, write_asked
from calc.design.toml_file import Document, design
from calc.measurements.fit_words import VERDICTS, sentence
from calc.sheet.errors import BadInput, InputError, NoSolution
from calc.sheet.number import short
from calc.sheet.text import Text
from calc.sheet.version import VERSION
from calc.solve import Results, solve
from calc.studies.fit_results import DesignFit
from calc.studies.fits import fit_of


def run_fit(asked: Namespace) -> int:
    """0 where the inputs are identified, else 3."""
    document = read_design(asked.file)
    telling = sys.stderr.isatty() and not asked.quiet
    try:
        fit = fit_of(document, asked.name, progress=_told if telling else None)
    except NoSolution as none:
        print(f"{asked.file}: fit {asked.name}: {none}", file=sys.stderr)
        return 3
    finally:
        if telling:
            print(END, end="", file=sys.stderr, flush=True)
    applied = asked.apply and fit.identified
    made = _write(asked.file, document, fit) if applied else None
    with spoken(asked.file if applied else None):
        if asked.json:
            print(json.dumps(_as_json(document, fit, made), ensure_ascii=False, indent=1))
        elif asked.quiet:
            print(f"{asked.name}: {VERDICTS[fit.result.verdict]}")
        else:
            _print(asked, document, fit, made)
    return 0 if fit.identified else 3


END = "\r\x1b[K"  # of what is said while it searches


def _told(share: float, what: str) -> None:
    print(f"{END}{100 * share:3.0f} %  {what}"[: LINE + len(END)], end="", file=sys.stderr, flush=True)


def _write(file: str, document: Document, fit: DesignFit) -> Results:
    """Put the fit into the file; gives what the design now comes to."""
    made = design(with_fit(document, fit))
    try:
        text = fitted_text(document, fit)
    except NeedsUpgrade as needed:
        raise BadInput(file, [InputError(0, "schema", "", needed.text)]) from None
    if file == STANDARD:
        put(STANDARD, text)
    else:
        write_asked(Path(file), text, backup=True, expected=document.raw)
    return solve(made)


def _print(asked: Namespace, document: Document, fit: DesignFit, made: Results | None) -> None:
    result, values = fit.result, fit.values()
    runs = ", ".join(fit.runs)
    print(f"fit {fit.name}, of {runs}: {VERDICTS[result.verdict]}")
    for i, name in enumerate(fit.names):
        if (value := values.get(f"{fit.id}.{name.key}")) is None:
            continue
        sd = values.get(f"{fit.id}.{name.key}.sd")
        number = short(fit.applied(i) if sd is not None else value.shown, 6)
        about, ends = "", ""
        if sd is not None:
            low, high = (short(float(end), 4) for end in result.limits[i])
            about, ends = f" ± {short(sd.shown, 3)}", f"   95 %: {low} … {high}"
        print(f"  {name.key:<50} {number}{about} {name.unit}{ends}".rstrip())
    rows = ", ".join(f"{n} of {column}" for column, n in fit.rows.items())
    print(f"  {Text('rows')}: {rows}; {Text('degrees of freedom')}: {result.degrees_of_freedom}")
    told = [value for id, value in values.items() if id.count(".") == 2]
    print("  " + ", ".join(f"{v.id.rpartition('.')[2]} {short(v.shown, 3)} {v.unit}".rstrip() for v in told))
    for words in (*fit.left_out, sentence(result, fit.names)):
        print("\n".join(textwrap.wrap(words, LINE)))
    if made is None:
        if fit.identified:
            print(Text("`--apply` writes the values into {file}", file=asked.file))
        return
    changes = [f"{key}=" if number is None else f"{key}={number!r}" for key, number in fit.changes.items()]
    print(f"\n{asked.file} has them now" + ("" if asked.file == STANDARD else f"; as it was before: {asked.file}.bak"))
    if shut := locked_text(document, changes):
        print(Text("This {changes}", changes=shut))
    print()
    print_summary(made)


def _as_json(document: Document, fit: DesignFit, made: Results | None) -> dict[str, Any]:
    result = fit.result
    return {
        "schema": 1,
        "program": "contralbero",
        "version": VERSION,
        "design": {"name": str(document.data.get("name", "")), "sha256": document.sha256},
        "fit": fit.name,
        "of": list(fit.runs),
        "verdict": result.verdict,
        "words": sentence(result, fit.names),
        "values": {id: {"value": finite(v.shown), "unit": v.unit, "label": v.label} for id, v in fit.values().items()},
        "limits_95": {
            f"{fit.id}.{name.key}": [finite(float(end)) for end in ends]
            for name, ends in zip(fit.names, result.limits)
            if fit.identified
        },
        "degrees_of_freedom": result.degrees_of_freedom,
        "sum_of_squares": finite(result.sum_of_squares),
        "scaled": bool(result.scaled),
        "rows": dict(fit.rows),
        "left_out": list(fit.left_out),
        "checks": [check_json(fit.check())],
        "applied": made is not None,
        "verdict_then": made.verdict if made is not None else None,
    }
