# SPDX-License-Identifier: Apache-2.0
"""Text of the user, made harmless where it leaves the program: what a terminal would obey, or nobody would see, is
written out.

A character is written as JSON writes it (`\\u202e`), so that a JSON text stays the same object.  What is written out:
control characters, marks that turn the direction of the text, spaces and fillers without a width, line ends of Unicode,
tags, halves of surrogate pairs (bytes of a file name that are no text)."""

import re

UNSEEN = (
    "\x7f-\x9f\xad\u034f\u061c\u115f\u1160\u17b4\u17b5\u180b-\u180f\u200b-\u200f\u2028-\u202e\u2060-\u206f\u3164\ud800-\udfff\ufeff\uffa0"
    "\ufff0-\ufffb\ufffe\uffff\U000e0000-\U000e0fff"
)
IN_A_LINE = re.compile(f"[\x00-\x1f{UNSEEN}]")
IN_LINES = re.compile(f"[\x00-\x08\x0b-\x1f{UNSEEN}]")


def visible(text: str, *, lines: bool = False) -> str:
    """The text with what can not be seen in it written out.  `lines`: it is a text of the program, whose line ends and
    tabs are meant."""
    hidden = IN_LINES if lines else IN_A_LINE
    return hidden.sub(_written, text) if hidden.search(text) else text


def _written(match: re.Match[str]) -> str:
    pairs = match[0].encode("utf-16-be", "surrogatepass")
    return "".join(f"\\u{pairs[n]:02x}{pairs[n + 1]:02x}" for n in range(0, len(pairs), 2))
