# SPDX-License-Identifier: Apache-2.0
"""`contralbero upgrade`: designs of schema 1 in schema 2.  A file is written only if the whole design is valid, and
none is where one of them is not."""

from argparse import Namespace
from difflib import unified_diff
from functools import partial
from pathlib import Path

from assistant.named_files import STANDARD, files_of, put, read_design, spoken
from assistant.session.saving import asked_for
from calc.design.disk import edit_file
from calc.design.limits import DESIGN_BYTES
from calc.design.toml_file import design, parse
from calc.design.upgrade_text import UpgradedText, upgraded_text
from calc.sheet.text import Text, plural


def run_upgrade(asked: Namespace) -> int:
    """From standard input to standard output, or in place."""
    paths = [Path(name) for name in files_of(asked.files)]
    made = [(path, *_made(path, read_design(str(path)).raw)) for path in paths]
    for path, before, after in made:
        if str(path) == STANDARD and not asked.dry:
            put(STANDARD, after.text)
        elif after.text == before:
            print(Text("{path} is of schema 2 already", path=str(path)))
        elif asked.dry:
            print(_difference(path, before, after.text), end="")
        else:
            with asked_for(path):
                edit_file(path, DESIGN_BYTES, partial(_bytes, path))
            print(Text("{path} is written in schema 2; as it was before: {path}.bak", path=str(path)))
        if not after.kept:
            with spoken(str(path)):
                _print_afresh(path, after)
    return 0


def _bytes(path: Path, raw: bytes) -> bytes:
    return _made(path, raw)[1].text.encode("utf-8")


def _made(path: Path, raw: bytes) -> tuple[str, UpgradedText]:
    """A text as its file has it, and in schema 2."""
    before = raw.decode("utf-8")
    after = upgraded_text(before, str(path))
    if after.text != before:
        design(parse(raw, str(path)))  # what is wrong with it is said as of any design
    return before, after


def _difference(path: Path, before: str, after: str) -> str:
    """As `diff -u` has it; a last line without an end has one there."""
    old, new = (text.split("\n") for text in (before, after))
    return "".join(f"{line}\n" for line in unified_diff(old, new, str(path), str(path), lineterm=""))


def _print_afresh(path: Path, after: UpgradedText) -> None:
    """Says that a notation could not be kept, and which comments went with it."""
    lost = plural("{n} comment is not in it", "{n} comments are not in it", len(after.lost))
    print(
        Text(
            "{path}: its notation does not bear an edit line by line: it is written afresh; {lost}",
            path=str(path),
            lost=lost,
        )
    )
    for comment in after.lost:
        print(f"  # {comment}")
