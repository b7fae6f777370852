# SPDX-License-Identifier: Apache-2.0
"""`contralbero errata`: what is wrong in the documents that this program grew out of, with the right values computed."""

import textwrap
from argparse import Namespace
from dataclasses import fields

from calc.studies.errata import Misprint, documents, misprints
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.version import VERSION

WIDE = 116


def run(asked: Namespace) -> int:
    source = _meant(asked.source) if asked.source else ""
    found = list(misprints(source))
    if asked.json:
        import json

        rows = [{**{f.name: getattr(one, f.name) for f in fields(Misprint)}, "command": one.command} for one in found]
        print(json.dumps({"schema": 1, "program": "contralbero", "version": VERSION, "errata": rows}, ensure_ascii=False, indent=1))
    elif asked.markdown:
        print(markdown())
    else:
        for name, title in documents().items():
            if of_it := [one for one in found if one.source == name]:
                print(f"{title} ({name}): {len(of_it)} errors\n")
                for one in of_it:
                    print("\n".join(_lines(one)))
    return 0


def _meant(word: str) -> str:
    """The document whose short name holds a word, like `finotti`."""
    meant = [name for name in documents() if word.casefold() in name.casefold()]
    if len(meant) == 1:
        return meant[0]
    known = Text("give one of {names}, or a word of it", names=", ".join(f'"{name}"' for name in documents()))
    raise BadInput("contralbero errata", [InputError(0, "", f'"{word}"', known)])


def _lines(one: Misprint) -> list[str]:
    at = f"{one.place}, line {one.lines}" if "," not in one.lines and "-" not in one.lines else f"{one.place}, lines {one.lines}"
    shown = [f"  {one.about}  [{at}]", *_wrapped("printed", one.printed), *_wrapped("right", one.right), *_wrapped("", one.why)]
    return [*shown, *([f"    {'':<8}> {one.command}"] if one.command else []), ""]


def _wrapped(head: str, text: str) -> list[str]:
    return textwrap.wrap(text, WIDE, initial_indent=f"    {head:<8}", subsequent_indent=" " * 12, break_long_words=False)


def markdown() -> str:
    """All errata as the page docs/errata.md."""
    out = [
        "# Errors in the sources",
        "",
        "What is wrong in the three documents that this program grew out of: what is printed, what is right, and why. Right numbers are",
        "the program's own; the command below a row shows how each is worked out. Lines are those of the plain text of the document.",
        "",
        "The table behind this page is `calc/library/tables/errata.toml`; `contralbero errata --markdown > docs/errata.md` writes the page.",
    ]
    for name, title in documents().items():
        of_it = list(misprints(name))
        out += ["", f"## {title} ({name}): {len(of_it)} errors", "", "| where | what | printed | right | why |", "|---|---|---|---|---|"]
        for one in of_it:
            why = f"{one.why}<br>`{one.command}`" if one.command else one.why
            cells = f"{one.place}; {one.lines}", one.about, one.printed, one.right, why
            out.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(out)
