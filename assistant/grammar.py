# SPDX-License-Identifier: Apache-2.0
"""What all commands of the command line have in common: how a word is read, and the options that mean the same
everywhere."""

import argparse
import os
import sys
from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from itertools import takewhile
from typing import Any, NoReturn

KEY_VALUE = "KEY=VALUE"


class Help(argparse.HelpFormatter):
    """As wide as the terminal, which argparse asks of shutil for every argument: 4 ms of imports."""

    def __init__(self, prog: str) -> None:
        try:
            columns = int(os.environ.get("COLUMNS") or os.get_terminal_size(sys.__stdout__.fileno()).columns)  # type: ignore[union-attr]
        except (ValueError, OSError, AttributeError):
            columns = 80
        super().__init__(prog, width=max(columns, 20) - 2)


class Parser(argparse.ArgumentParser):
    """No option is abbreviated: a script means the same when another option comes.  One that is not known is said
    before anything that is missing, with the nearest that there is."""

    def __init__(self, **how: Any) -> None:
        super().__init__(allow_abbrev=False, formatter_class=Help, **how)
        self.unknown: list[str] = []

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> tuple[Any, list[str]]:
        if self._subparsers is None and args is not None:
            given = takewhile(lambda word: word != "--", args)
            self.unknown = [
                word for word in given if word.startswith("--") and " " not in word and not self._knows(word)
            ]
        return super().parse_known_args(args, namespace)

    def error(self, message: str) -> NoReturn:
        """What is missing may be what an option that is not known was meant to give."""
        super().error(self._not_known(self.unknown) if self.unknown else message)

    def refuse(self, unknown: Sequence[str]) -> NoReturn:
        """Ends with the words that are too many."""
        super().error(self._not_known(unknown))

    def _not_known(self, unknown: Sequence[str]) -> str:
        near = dict.fromkeys(self._nearest(unknown))
        return f"unrecognized arguments: {' '.join(unknown)}" + (f"; did you mean {', '.join(near)}?" if near else "")

    def _knows(self, word: str) -> bool:
        return word.partition("=")[0] in self._option_string_actions

    def _nearest(self, words: Iterable[str]) -> Iterable[str]:
        options = [option for option in self._option_string_actions if option.startswith("--")]
        for word in words:
            if word.startswith("-"):
                yield from get_close_matches(f"--{word.partition('=')[0].lstrip('-')}", options, 1)


# --- options of one meaning


def set_option(it: argparse.ArgumentParser, help: str = "change inputs for this run") -> None:
    it.add_argument("--set", action="extend", nargs="+", default=[], metavar=KEY_VALUE, dest="changes", help=help)


def output_option(it: argparse.ArgumentParser, metavar: str, help: str, required: bool = False) -> None:
    it.add_argument("-o", "--output", metavar=metavar, help=help, required=required)


def json_option(it: Any, help: str = "print one JSON object") -> None:
    it.add_argument("--json", action="store_true", help=help)


def quiet_option(it: argparse.ArgumentParser, help: str) -> None:
    it.add_argument("-q", "--quiet", action="store_true", help=help)


def all_option(it: argparse.ArgumentParser, help: str) -> None:
    it.add_argument("-v", "--all", "--verbose", action="store_true", dest="all", help=help)
