# SPDX-License-Identifier: Apache-2.0
"""Every traced line of a step as it was computed, in its order: what the audit has."""

from __future__ import annotations

from collections.abc import Iterable

from calc.sheet.step import Step
from calc.sheet.trace import Line

from .context import Context
from .setting.equation import SIGN, Entry, Label, Labelled, entry_blocks
from .setting.flow import Block, heading, paragraph
from .setting.prose import GROUP, NOTE


def derivation(context: Context, step: Step, traced: list[Line]) -> list[Block]:
    """The blocks of the formulas of a step."""
    if not traced:
        return []
    made = paragraph(f"{context.words['substitution']} {context.words['ranges']}", NOTE, gap=1.0, keep=True)
    labels = {about: Label(*context.say.halves(about)) for about in dict.fromkeys(line.about for line in traced)}
    for about, entries in _runs([(labels[line.about], line) for line in traced]):
        if about:
            made += heading(about[:1].upper() + about[1:], GROUP, gap=7.0, after=1.0)
        for entry in entries:
            made += entry_blocks(entry, context.cite(entry.formula.source, step), SIGN, labelled=False, context=context)
    return made


def _runs(traced: list[Labelled]) -> Iterable[tuple[str, list[Entry]]]:
    """Every line for itself, under the part whose calculation it is."""
    entries: list[Entry] = []
    about = traced[0][0]
    for label, line in traced:
        if label != about:
            yield about.text(), entries
            entries, about = [], label
        entries.append(Entry(line.formula, [(label, line)]))
    yield about.text(), entries
