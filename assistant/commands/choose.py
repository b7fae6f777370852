# SPDX-License-Identifier: Apache-2.0
"""`contralbero choose` and `contralbero set`: the commands that write into a design file, and show what then holds.

choose: a search for the user; a ranked table, and `--apply N` writes one row into the design file.  set: edits a design
file in place."""

import json
import sys
import textwrap
from argparse import Namespace
from collections import Counter
from collections.abc import Sequence
from difflib import get_close_matches
from pathlib import Path

from assistant.commands.check import changed
from assistant.named_files import STANDARD, put, read_design, spoken
from assistant.offers import Offer
from assistant.offers import offer as offer_for
from assistant.results_text import LINE, check_line, print_findings, print_summary, sign, table_json, table_lines
from assistant.session.editing import locked_text
from assistant.session.guide import CHOICES
from assistant.session.saving import NeedsUpgrade, asked_for, saved_text, write_asked
from calc.design.disk import edit_file
from calc.design.limits import DESIGN_BYTES
from calc.design.model import TITLES, Design
from calc.design.toml_file import Document, design, parse
from calc.sheet.check import URGENT
from calc.sheet.errors import BadInput, InputError, NoSolution
from calc.sheet.text import COMMA, EMPTY, Text
from calc.solve import solve


def run_choose(asked: Namespace) -> int:
    if asked.step not in CHOICES:
        known = COMMA.join(Text("{step} ({what})", step=step, what=what) for step, what in CHOICES.items())
        reason = Text("there is nothing to choose here yet; there is for {steps}", steps=known)
        if near := get_close_matches(asked.step, CHOICES, 1, 0.75):
            reason = Text("did you mean {near}? {reason}", near=near[0], reason=reason)
        raise BadInput("contralbero choose", [InputError(0, "STEP", asked.step, reason)])
    document = read_design(asked.file)
    parsed = design(document)
    if asked.top < 1:
        raise BadInput("--top", [InputError(0, "", str(asked.top), Text("must be a number of rows, 1 or more"))])
    try:
        offer = offer_for(asked.step, parsed, asked.file, shaft=asked.shaft, aim=asked.aim)
    except NoSolution as none:
        print(f"{asked.file}: {asked.step}: {none}", file=sys.stderr)
        return 3
    if asked.apply is not None:
        if not 1 <= asked.apply <= offer.count:
            raise BadInput(
                "--apply",
                [InputError(0, "", str(asked.apply), Text("must be a row of the table, from 1 to {n}", n=offer.count))],
            )
        try:
            changes = offer.changes(asked.apply)
        except NoSolution as none:
            print(f"{asked.file}: {asked.step}: {none}", file=sys.stderr)
            return 3
        text, made = _write(asked.file, document, changes)
        with spoken(asked.file):
            if not asked.quiet:
                _print_applied(asked, document, text, made, changes, offer.said(asked.apply))
            elif asked.file != STANDARD:
                print(asked.file)
        return 0
    table = offer.table(asked.top)
    if asked.json:
        beside = {side_table.id: table_json(side_table) for side_table in offer.beside(asked.top)}
        answer = {"schema": 1, "step": asked.step, **table_json(table), **({"tables": beside} if beside else {})}
        answer |= {key: text for key, text in (("summary", offer.summary), ("notes", offer.notes)) if text}
        print(json.dumps(answer, ensure_ascii=False, indent=1))
        return 0
    title, *lines = table_lines(table)
    if asked.quiet:
        print("\n".join([title, *lines]))
        return 0
    print(title)
    for words in offer.summary:
        print("\n".join(textwrap.wrap(words, LINE)))
    print("\n".join(([""] if offer.summary else []) + lines))
    if hidden := offer.hidden(asked.top):
        print(f"  {hidden}")
    for side_table in offer.beside(asked.top):
        print("\n" + "\n".join(table_lines(side_table)))
    if offer.notes:
        print()
    for words in offer.notes:
        print(
            "\n".join(textwrap.wrap(words, LINE, initial_indent="- ", subsequent_indent="  ", break_long_words=False))
        )
    if shut := _locked(document, offer):
        print("", Text("Row 1 {changes}", changes=shut), sep="\n")
    print(f"\n{offer.hint}")
    return 0


def _locked(document: Document, offer: Offer) -> Text:
    """What is locked that the first row changes."""
    try:
        return locked_text(document, offer.changes(1))
    except NoSolution:  # it does not hold after all, which applying it says
        return EMPTY


def _write(file: str, document: Document, changes: list[str]) -> tuple[str, Design]:
    """Put a row into the file; gives its text and the design that it is now."""
    changed_document, made = changed(document, changes)
    text = _saved(document.raw, changed_document, Path(file))
    if file == STANDARD:
        put(STANDARD, text)
    else:
        write_asked(Path(file), text, backup=True, expected=document.raw)
    return text, made


def _print_applied(
    asked: Namespace, document: Document, text: str, made: Design, changes: list[str], words: str
) -> None:
    """What was written; then the verdicts, the warnings of this step, and of the others what fails or is worse than
    before."""
    before, step = document.raw.decode("utf-8"), asked.step
    print(f"{asked.file} {words}" + (f"; as it was before: {asked.file}.bak" if asked.file != STANDARD else ""))
    if shut := locked_text(document, changes):
        print(Text("This {changes}", changes=shut))
    for comment in (Counter(_comments(before)) - Counter(_comments(text))).elements():
        print(f"A comment went with its key: {comment}")
    results, former = solve(made), solve(design(document))
    words, were = results.words(), former.words()
    print("", words if words == were else Text("{words} (before: {were})", words=words, were=were), sep="\n")
    known = {c.id: c.verdict for c in former.checks()}
    for key, outcome in results.outcomes.items():
        if key != step and outcome.state != "not_asked":
            reason = f"  {outcome.reason}" if outcome.reason else ""
            print(f"{TITLES[key]:<14} {sign(outcome.verdict)}{reason}")
            for c in outcome.checks:
                if c.verdict == "fail" or (c.verdict in URGENT and c.verdict != known.get(c.id)):
                    print(f"  {check_line(c, c.verdict)}")
    print_findings(results, step)


def _saved(raw: bytes, document: Document, path: Path) -> str:
    """The file as it would be written.  Raises BadInput where its schema has no words for what changed."""
    try:
        return saved_text(raw, document.data)
    except NeedsUpgrade as needed:
        raise BadInput(str(path), [InputError(0, "schema", "", needed.text)]) from None


def _comments(text: str) -> list[str]:
    """What stands behind a # in each line, wherever the line itself is a string."""
    return [line[line.index("#") :].strip() for line in text.splitlines() if "#" in line]


# --- contralbero set
# The file is written only if the whole design is still valid.


def run_set(asked: Namespace) -> int:
    """In place, or from standard input to standard output."""
    path = Path(asked.file)
    document = read_design(asked.file)  # what is wrong with it is said as of any design
    if asked.file == STANDARD:
        document, made = changed(document, asked.changes)
        put(STANDARD, _saved(document.raw, document, path))
    else:
        made = edit(path, asked.changes)
    with spoken(asked.file):
        if not asked.quiet:
            print_summary(solve(made))
        if asked.file != STANDARD:
            print(path if asked.quiet else f"\n{path} is written; as it was before: {path}.bak")
    return 0


def edit(path: Path, changes: Sequence[str]) -> Design:
    """Put KEY=VALUE changes into a design as its file has it when nobody else writes."""
    made: Design

    def edited(raw: bytes) -> bytes:
        nonlocal made
        document, made = changed(parse(raw, str(path)), changes)
        return _saved(raw, document, path).encode("utf-8")

    with asked_for(path):
        edit_file(path, DESIGN_BYTES, edited)
    return made
