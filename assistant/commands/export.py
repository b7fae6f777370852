# SPDX-License-Identifier: Apache-2.0
"""`contralbero export`: the results of a design as JSON or CSV, its shaft or its gears as a DXF drawing."""

from argparse import Namespace
from pathlib import Path

from assistant.session.exporting import KINDS, drawing_text, draws_gears, exported, gears_text, transfer_text
from assistant.plain import print_summary
from assistant.session.saving import spare, write_asked
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import COMMA, Amount, Text
from calc.solve import Results, solve

FINEST, COARSEST = 1e-3, 1e3  # chord error, µm: below, the file grows without use; above, no tooth is left


def run(asked: Namespace) -> int:
    target = Path(asked.output)
    kind = asked.kind or target.suffix.lower().removeprefix(".")
    document = read(asked.file)
    spare(target, asked.file)
    wrong = _target_errors(kind, target) + _drawing_errors(asked, kind)
    try:
        made = design(document)
    except BadInput as bad:
        raise BadInput(document.place, wrong + bad.errors) from None
    if wrong:
        raise BadInput("contralbero export", wrong)
    results = solve(made)
    if asked.transfer:
        text = transfer_text(document, results)
    else:
        text = _drawing(asked, document, results) if kind == "dxf" else exported(kind, document, results)
    write_asked(target, text, inputs=[asked.file])
    print_summary(results)
    print(f"\n{target}")
    return 0


def _target_errors(kind: str, target: Path) -> list[InputError]:
    """What is wrong with the file that was asked for: its ending says what stands in it."""
    known = COMMA.join(Text(".{kind} ({what})", kind=name, what=what) for name, what in KINDS.items())
    ending = target.suffix
    if kind not in KINDS:
        fault = Text("the ending {ending} is not known", ending=ending) if ending else Text("has no ending")
        return [InputError(0, "-o", str(target), Text("{fault}; known are {endings}", fault=fault, endings=known))]
    if ending.lower() != f".{kind}":
        fault = Text("ends in {ending}", ending=ending) if ending else Text("has no ending")
        return [InputError(0, "-o", str(target), Text("{fault}, but --{kind} writes .{kind}", fault=fault, kind=kind))]
    return []


def _drawing_errors(asked: Namespace, kind: str) -> list[InputError]:
    """What is wrong with the options of a drawing."""
    given = {"--gear": asked.gear, "--gears": asked.gears or None, "--chord-error": asked.chord_error}
    errors = []
    if kind in KINDS and kind != "dxf":
        reason = Text("is for a drawing (--dxf), not for .{kind}", kind=kind)
        errors = [InputError(0, key, "", reason) for key, what in given.items() if what is not None]
    if asked.transfer and kind != "csv":
        errors.append(InputError(0, "--transfer", "", Text("is for a table (--csv), not for .{kind}", kind=kind)))
    error = asked.chord_error
    if error is not None and not FINEST <= error <= COARSEST:
        reason = Text("must lie between {finest} and {coarsest}", finest=Amount(FINEST), coarsest=Amount(COARSEST, "µm"))
        errors.append(InputError(0, "--chord-error", f"{error:g}", reason))
    return errors


def _drawing(asked: Namespace, document: Document, results: Results) -> str:
    """The shaft, or the gears where they are asked for or are all there is."""
    if asked.gear is not None or asked.gears or draws_gears(results):
        return gears_text(document, results, asked.gear, asked.chord_error)
    if asked.chord_error is not None:
        raise BadInput("contralbero export", [InputError(0, "--chord-error", "", Text("is for gears: ask for --gear WHEEL or --gears"))])
    return drawing_text(document, results)
