# SPDX-License-Identifier: Apache-2.0
"""`contralbero fit`: inputs found from runs of the bench, or the sentence why they can not be.

`--apply` writes them into the design file, where they are identified, and shows what then holds."""

import json
import sys
from argparse import Namespace
from pathlib import Path
from typing import Any

from assistant.fits_text import fit_json, print_fit
from assistant.named_files import STANDARD, put, read_design, spoken
from assistant.results_text import LINE, check_json, print_summary, values_json
from assistant.session.editing import locked_text
from assistant.session.fitted import fitted_text, with_fit
from assistant.session.saving import NeedsUpgrade, write_asked
from calc.design.toml_file import Document, design
from calc.sheet.errors import BadInput, InputError, NoSolution
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
            print(fit.words)
        else:
            print_fit(fit)
            if made is not None:
                _print_applied(asked.file, document, fit, made)
            elif fit.identified:
                print(Text("`--apply` writes the values into {file}", file=asked.file))
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


def _print_applied(file: str, document: Document, fit: DesignFit, made: Results) -> None:
    changes = [f"{key}=" if number is None else f"{key}={number!r}" for key, number in fit.changes.items()]
    print(f"\n{file} has them now" + ("" if file == STANDARD else f"; as it was before: {file}.bak"))
    if shut := locked_text(document, changes):
        print(Text("This {changes}", changes=shut))
    print()
    print_summary(made)


def _as_json(document: Document, fit: DesignFit, made: Results | None) -> dict[str, Any]:
    """What `check --fits --json` has of the fit, and whether it is applied."""
    return {
        "schema": 1,
        "program": "contralbero",
        "version": VERSION,
        "design": {"name": str(document.data.get("name", "")), "sha256": document.sha256},
        "fit": fit.name,
        **fit_json(fit),
        "values": values_json(fit.values()),
        "checks": [check_json(fit.check())],
        "applied": made is not None,
        "verdict_then": made.verdict if made is not None else None,
    }
