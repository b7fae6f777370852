# SPDX-License-Identifier: Apache-2.0
"""What the checks found, as plain text that fits a screen: limits first, then cautions, each group of one cause by its worst check;
advice and what concerns the method by their numbers and the worst of each.  `everything`: all of them in full."""

import os
import sys
import textwrap
from collections.abc import Iterator, Sequence

from calc.design.key_values import outside, stretched
from calc.sheet.check import SIGNS, Check, grouped, named, severity, with_it
from calc.sheet.rules import pattern_of
from calc.sheet.step import no_such_check
from calc.sheet.text import EMPTY, SPACE, Amount, Name, Text, plural
from calc.solve import Results
from calc.design.unusual import SHOWN, Unusual, told

WORDS = {
    "pass": "pass", "warn": "warn", "fail": "FAIL", "note": "note", "not_verified": "not verified", "accepted": "accepted",
    "blocked": "blocked", "not_asked": "not used", "no_solution": "NO SOLUTION", "outside": "outside",
}  # fmt: skip
LINE = 132  # characters of a line, and fewer on a terminal that has not so many
INDENT = " " * 8


def sign(verdict: str) -> str:
    """A sign and a word: `✗ FAIL`.  `outside`: it holds, by a formula outside its validity."""
    return f"{SIGNS['note' if verdict == 'outside' else verdict]} {WORDS[verdict]}"


def finding_lines(checks: Sequence[Check], everything: bool = False, odd: Sequence[Unusual] = ()) -> Iterator[str]:
    """All that is open, and what the user accepted; `odd`: inputs that are not usual, which stand before what are notes."""
    groups = [[check for check in group if check.open] for group in grouped(checks)]
    found = [group for group in groups if group]
    for group in found:
        if everything:
            for check in group:
                yield from _finding(check)
        elif group[0].kind in ("limit", "caution"):
            yield from _finding(group[0])
            if len(group) > 1:
                yield from _wrapped(with_it(group[1:]))
    yield from _unusual(odd, len(odd) if everything else SHOWN)
    if not everything:
        yield from _counts("advice", [group for group in found if group[0].kind == "advice"])
        yield from _counts("method", [group for group in found if group[0].kind == "method"])
        yield from _outside(checks)
    for check in checks:
        if check.verdict == "accepted":
            yield from _wrapped(Text("{what}: {reason}", what=_judged(check), reason=check.accepted), f"{sign('accepted')}  ")


def _finding(check: Check) -> Iterator[str]:
    yield from _wrapped(_judged(check), f"{sign(check.verdict)}  ")
    unknown = [Text("Not known: {keys}.", keys=Name(", ".join(check.missing)))] if check.missing else []
    if unknown or check.advice:
        yield from _wrapped(SPACE.join([*unknown, *([check.advice] if check.advice else [])]))
    yield f"{INDENT}{check.id} · {check.source}" if check.verdict in ("fail", "not_verified") else f"{INDENT}{check.id}"


def _judged(check: Check) -> Text:
    """`Film at the edge, front: 7.411 µm, needs ≥ 9 µm (−18 %)`."""
    template = (
        "{name}: {value}, only just {limit} ({margin})"
        if check.narrow
        else "{name}: {value}, needs {limit} ({margin})"
        if check.kind in ("limit", "caution")
        else "{name}: {value}, should be {limit} ({margin})"
    )
    value = Amount(check.value, check.unit)
    return Text(template, name=check.name, value=value, limit=check.limit_text(), margin=check.margin_text())


def _counts(kind: str, groups: Sequence[Sequence[Check]]) -> Iterator[str]:
    if not groups:
        return
    checks = [check for group in groups for check in group]
    worst = named([min(checks, key=lambda check: (check.margin == check.margin, check.margin))])
    one, many = {
        "advice": ("{n} piece of advice: {worst}", "{n} pieces of advice; the furthest: {worst}"),
        "method": ("{n} note on the calculation: {worst}", "{n} notes on the calculation; the furthest: {worst}"),
    }[kind]
    yield from _wrapped(plural(one, many, n=len(checks), worst=worst), f"{sign('note')}  ")


def _outside(checks: Sequence[Check]) -> Iterator[str]:
    """How many checks hold by a formula outside its validity, and what puts them there: of each kind the furthest."""
    methods = stretched(checks)
    beyond = [found for check in checks if check.verdict == "pass" and (found := outside(check, methods))]
    if beyond:
        furthest: dict[str, Check] = {}
        for method in sorted((one for found in beyond for one in found), key=severity):
            furthest.setdefault(pattern_of(method.id), method)
        one = "{n} check holds by a formula outside its validity: {methods}"
        many = "{n} checks hold by formulas outside their validity: {methods}"
        told = plural(one, many, n=len(beyond), methods=named([*furthest.values()]))
        yield from _wrapped(told, f"{sign('note')}  ")


def _unusual(odd: Sequence[Unusual], most: int) -> Iterator[str]:
    """The inputs outside what is usual, and their keys below."""
    if odd:
        yield from _wrapped(told(odd, most), f"{sign('note')}  ")
        yield from _wrapped(" · ".join(one.key for one in odd[:most]))


def lost_acceptances(results: Results) -> Iterator[str]:
    """What is accepted, and of no check that the design has: of a step that is not solved it may be one."""
    known = {check.id for outcome in results.outcomes.values() for check in outcome.checks}
    waits = {key for key, outcome in results.outcomes.items() if outcome.state != "solved"}
    for id, _ in results.design.accepted:
        if id not in known and id.partition(".")[0] not in waits:
            from difflib import get_close_matches

            near = get_close_matches(id, known, 1)
            meant = Text("; did you mean {near}?", near=near[0]) if near else EMPTY
            yield from _wrapped(no_such_check(id) + meant, f"{sign('note')}  ")


def _wrapped(text: str, start: str = INDENT) -> list[str]:
    """A number keeps its per cent on its line."""
    close = text.replace(" %", "\N{NO-BREAK SPACE}%")
    lines = textwrap.wrap(close, _width(), initial_indent=start, subsequent_indent=INDENT, break_long_words=False, break_on_hyphens=False)
    return [line.replace("\N{NO-BREAK SPACE}%", " %") for line in lines]


def _width() -> int:
    try:
        return max(60, min(LINE, os.get_terminal_size(sys.stdout.fileno()).columns))
    except (ValueError, OSError):  # no terminal
        return LINE
