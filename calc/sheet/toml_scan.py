# SPDX-License-Identifier: Apache-2.0
"""A look over a TOML text before it is taken apart: where each key stands, and that it is neither too deep nor too
long.

Every letter is looked at once, whatever stands there; what takes a TOML text apart may take the square of the time for
a hostile one."""

import re

from .text import Text

ENTRIES = 20_000  # values, elements of lists and headers, at most
DEPTH = 16  # tables in tables, at most
STRING = r'''"""(?:[^"\\]|\\(?:.|\Z)|"(?!""))*+(?:"{3,5})?|"(?:[^"\\\n]|\\[^\n])*+"?'''
LITERAL = r"""'''(?:[^']|'(?!''))*+(?:'{3,5})?|'[^'\n]*+'?"""
TOKEN = re.compile(  # what is not closed goes on to the end, so that nothing is tried twice
    r"[ \t\r]*+(?:(?P<newline>\n)|(?P<comment>#[^\n]*+)|(?P<word>[A-Za-z0-9_+:-]++)|(?P<sign>[^\"'])"
    rf"|(?P<string>{STRING}|{LITERAL})|\Z)",
    re.DOTALL,
)
KEY, HEADER, VALUE = range(3)  # what a line is read as


class Beyond(ValueError):
    """The text is deeper or longer than a design or a table of this program is."""

    def __init__(self, line: int, text: Text) -> None:
        self.line, self.text = line, text
        super().__init__(text)


def key_lines(text: str) -> dict[str, int]:
    """The line of every key and table of a TOML text; elements of arrays of tables by index (`gears.wheels.0.teeth`).
    Raises Beyond."""
    return _scanned(text).found


def remarks(text: str) -> dict[str, str]:
    """The comments that stand on the line of a key or of the head of a table, by the same keys.  Raises Beyond."""
    return _scanned(text).remarks


def _scanned(text: str) -> "_Lines":
    lines = _Lines()
    last = ""
    line, depth, entries, dots = 1, 0, 0, 0
    reads, parts, opened = KEY, list[str](), 0
    for token in TOKEN.finditer(text):
        kind = token.lastgroup
        if kind == "newline":
            line += 1
            if not depth:
                reads, parts, opened, dots = KEY, [], 0, 0
        elif kind == "word" or kind == "string":
            word = token[kind]
            if reads != VALUE:
                parts.append(word.strip("\"'"))
            if kind == "string" and "\n" in word:
                line += word.count("\n")
                lines.ends(depth, line)
        elif kind == "sign":
            word = token[kind]
            dots = dots + 1 if word == "." else 0
            entries += word in "=,["
            if reads != VALUE and word == "[" and not parts:
                reads, opened = HEADER, opened + 1
            elif reads == HEADER and word == "]":
                lines.header(parts, opened > 1, line)
                reads = VALUE
            elif reads == KEY and word == "=":
                lines.key(parts, line)
                reads = VALUE
            elif word in "[{":
                depth += 1
            elif word in "]}":
                depth = max(0, depth - 1)
                lines.ends(depth, line)
            if depth > DEPTH or dots > DEPTH:
                raise Beyond(line, Text("is nested deeper than {most} tables", most=DEPTH))
            if entries > ENTRIES:
                raise Beyond(line, Text("has more than {most} entries", most=f"{ENTRIES:,}"))
        elif kind == "comment" and (not depth or last in ("[", "{")):  # else that of an element
            lines.remark(token[kind], line)
        last = token[kind] if kind == "sign" else ""
    return lines


class _Lines:
    """Keys with their lines, and the comments beside them, as they come."""

    def __init__(self) -> None:
        self.found: dict[str, int] = {}
        self.remarks: dict[str, str] = {}
        self._last = ("", 0)  # the key that came last, and its line
        self._counts: dict[str, int] = {}  # of the arrays of tables, their last index
        self._prefix = ""

    def header(self, parts: list[str], array: bool, line: int) -> None:
        here = ""
        for i, part in enumerate(parts):
            here = f"{here}.{part}" if here else part
            if array and i == len(parts) - 1:
                self.found.setdefault(here, line)
                self._counts[here] = self._counts.get(here, -1) + 1
            if here in self._counts:
                here = f"{here}.{self._counts[here]}"
            self.found.setdefault(here, line)
        self._prefix, self._last = here, (here, line)

    def key(self, parts: list[str], line: int) -> None:
        here = ".".join([self._prefix, *parts] if self._prefix else parts)
        self.found.setdefault(here, line)
        self._last = here, line

    def ends(self, depth: int, line: int) -> None:
        """The value of the last key goes on, or ends, on this line."""
        if not depth:
            self._last = self._last[0], line

    def remark(self, comment: str, line: int) -> None:
        key, stands = self._last
        if stands == line and (words := comment.strip("# \t\r")):
            self.remarks.setdefault(key, words)
