# SPDX-License-Identifier: Apache-2.0
"""`contralbero export`: one file, or one for each shaft, for other programs and the shop."""

from argparse import Namespace
from pathlib import Path

from assistant.exports.kinds import KINDS, FileKind, Request, exported, kind_of
from assistant.named_files import STANDARD, put, read_design, spoken
from assistant.results_text import print_steps
from assistant.session.saving import spare
from calc.design.toml_file import design
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import COMMA, Name, Text
from calc.solve import solve


def run_export(asked: Namespace) -> int:
    target = Path(asked.output)
    to_standard = asked.output == STANDARD
    kind = KINDS[asked.kind] if asked.kind else kind_of(target.suffix.lower().removeprefix("."))
    document = read_design(asked.file)
    if not to_standard:
        spare(target, asked.file)
    wrong = _target_errors(asked.kind, kind, target) + _option_errors(asked, kind)
    try:
        parsed = design(document)
    except BadInput as bad:
        raise BadInput(document.place, wrong + bad.errors) from None
    if wrong or kind is None:
        raise BadInput("contralbero export", wrong)
    results = solve(parsed)
    path = target.with_name(f"{target.name}.{kind.endings[0]}") if to_standard else target
    options = {name: given for name in kind.options if _given(given := getattr(asked, name))}
    made = exported(kind, Request(path, document, results, options, asked.lang))
    if to_standard and len(made.files) > 1:
        reason = Text("takes one file, and this design has {n} shafts; give a file", n=len(made.files))
        raise BadInput("contralbero export", [InputError(0, "-o", STANDARD, reason)])
    for file, content in made.files.items():
        put(STANDARD if to_standard else str(file), content, [asked.file])
    with spoken(asked.output):
        if not asked.quiet:
            print(results.words())
            print_steps(results)
            print()
            for said in made.said:
                print(said)
        if not to_standard:
            print(*made.files, sep="\n")
    return 0


def _given(option: object) -> bool:
    return option is not None and option is not False


def _target_errors(option: str | None, kind: FileKind | None, target: Path) -> list[InputError]:
    """What is wrong with the file that was asked for: its ending says what stands in it."""
    ending = target.suffix.lower().removeprefix(".")
    if str(target) == STANDARD:
        if kind is not None:
            return []
        options = COMMA.join(Name(f"--{name}") for name in KINDS)
        return [InputError(0, "-o", STANDARD, Text("has no ending; give one of {options}", options=options))]
    if kind is not None and ending in kind.endings:
        return []
    fault = Text("ends in .{ending}", ending=ending) if ending else Text("has no ending")
    if kind is not None:
        written = ", ".join(f".{known}" for known in kind.endings)
        reason = Text("{fault}, but --{kind} writes {written}", fault=fault, kind=kind.name, written=written)
    elif named := [kind.name for kind in KINDS.values() if ending in kind.endings]:
        reason = Text("{fault}: say with --{kind} that this is meant", fault=fault, kind=named[0])
    else:
        if ending:
            fault = Text("the ending {ending} is not known", ending=target.suffix)
        known = COMMA.join(
            Text(".{kind} ({what})", kind=kind.endings[0], what=kind.what) for kind in KINDS.values() if kind.alone
        )
        reason = Text("{fault}; known are {endings}", fault=fault, endings=known)
    return [InputError(0, "-o", str(target), reason)]


def _option_errors(asked: Namespace, kind: FileKind | None) -> list[InputError]:
    """Options that are for another kind of file."""
    return [
        InputError(
            0,
            f"--{name.replace('_', '-')}",
            "",
            Text("is for --{kind}, not for --{other}", kind=other.name, other=kind.name),
        )
        for other in KINDS.values()
        for name in other.options
        if kind is not None and name not in kind.options and _given(getattr(asked, name))
    ]
