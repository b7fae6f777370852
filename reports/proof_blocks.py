# SPDX-License-Identifier: Apache-2.0
"""A proof as blocks: title with verdict and utilisation, the limit, the demand with its numbers, the twins, and what would mend it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from calc.design.addresses import value_at
from calc.studies.explain import shortened
from calc.sheet.check import Check
from calc.sheet.errors import BadInput
from calc.sheet.number import RANGE
from calc.sheet.step import Outcome, Step
from calc.sheet.text import Amount, Text
from calc.sheet.units import UNITS

from .setting.boxes import Colour
from .blocks.checks import name_of, shown_value, sign_style
from .content import Formula
from .context import Context
from .setting.equation import SIGN, column_of_signs, entry_blocks, spoken_numbers
from .setting.flow import Block, paragraph
from .blocks.inputs import exact
from .paper import WIDTH
from .blocks.proof import ALIKE, Known, Proof, Walk, demand, limit, proofs, value
from .setting.prose import GROUP, NOTE, STRONG
from .setting.tables import Cell, Column, Row, table
from .setting.tags import title_tag
from .blocks.words import STATE_COLOURS

if TYPE_CHECKING:
    from .setting.pen import Pen

NAMED = 6  # twins
QUOTED = 14  # values and inputs of a proof
INDENT = 8.0
BAR = 2.2
CLOSE = 2.4  # between formulas
STRIPE: Colour = (0.95, 0.95, 0.95)


def proof_blocks(context: Context, number: int, step: Step, outcome: Outcome[object]) -> list[Block]:
    """The proofs of a step, numbered, and what leads to the value that stands for it."""
    found = proofs(context, outcome.checks)
    known: Known = {}
    made: list[Block] = []
    for n, proof in enumerate(found, 1):
        walk = demand(context, proof, known)
        held = limit(context, proof, known)
        made += _proof(context, f"{number}.{n}", step, proof, walk, held)
        known = walk.derived(f"{number}.{n}") | dict.fromkeys(held.lines, f"{number}.{n}") | known
    return made + _headline(context, step, {check.value_id for proof in found for check in proof.checks}, known)


def _headline(context: Context, step: Step, proven: set[str], known: Known) -> list[Block]:
    """How the value comes about that stands for a step, where no proof shows it."""
    head = next(iter(step.heads(context.values)), None)
    if head is None or head.id in proven or not head.shown or not (walk := value(context, head.id, known)).entries:
        return []
    title = f"{context.say(head.label)}: {context.written(head.shown, head.unit)}"
    made = [_title(context, [(Cell(title, STRONG), "", "", "", "")], (0.35, 0.35, 0.35)), *_walked(context, step, walk)]
    return [*made[:-1], replace(made[-1], keep=False)]


def _proof(context: Context, number: str, step: Step, proof: Proof, walk: Walk, held: Walk) -> list[Block]:
    rows: list[Row] = []
    for n, check in enumerate(proof.checks):
        name = f"{number}  {name_of(context, check)}" if n == 0 else name_of(context, check)
        state = context.state(check)
        found = Cell(f"{shown_value(context, check)} · {context.say(check.limit_text())}", STRONG)
        rows.append(
            (Cell(name, STRONG), found, Cell(context.say(check.margin_text()), STRONG), used(context, check), sign_style(context, state))
        )
    made = [_title(context, rows, STATE_COLOURS[context.state(proof.governing)])]
    for check in proof.checks[:1]:
        context.cite(check.source, step)
        made += _line(context, "limit_is", limit=context.say(check.limit_text()), source=check.source)
    made += _walked(context, step, held, quoting=False)
    if not _reached(proof.governing, walk):
        made += _line(context, "no_formula")
    if not walk.entries:
        moved = [key for key in proof.governing.moved_by if key not in walk.inputs]
        walk = Walk([], [], [*walk.inputs, *moved])
    made += _walked(context, step, walk)
    made += _after(context, proof)
    last = made[-1]
    made[-1] = replace(last, keep=False)
    return made


def _reached(check: Check, walk: Walk) -> bool:
    """Whether a line of the walk gives the number that is judged; a solution over many of them may have none of its own."""
    judged = UNITS[check.unit].inside(check.value)
    values = [line.value for entry in walk.entries for _, line in entry.lines if isinstance(line.value, (int, float, np.ndarray))]
    return any(np.isclose(value, judged, rtol=1e-6, atol=0.0).any() for value in values)


def _after(context: Context, proof: Proof) -> list[Block]:
    """The twins, what the formulas are not made for, and what would mend it."""
    made: list[Block] = []
    if proof.others:
        told = [Text("{name} {value} {limit} ({margin})", name=_short(context, check), value=Amount(check.value, check.unit),
                     limit=check.limit_text(), margin=check.margin_text()) for check in proof.others[:NAMED]]  # fmt: skip
        more = [context.text("more_twins", count=len(proof.others) - NAMED)] if len(proof.others) > NAMED else []
        made += _line(context, "also_judged", checks="; ".join([*map(context.say, told), *more]))
    for method in dict.fromkeys(one for check in proof.checks for one in context.outside(check)):
        made += _line(
            context, "outside_of", name=name_of(context, method), value=shown_value(context, method), limit=context.say(method.limit_text())
        )
    check = proof.governing
    if check.missing:
        made += _line(context, "not_known", keys=", ".join(check.missing))
    if check.accepted:
        made += _line(context, "accepted_because", reason=check.accepted)
    for advice in dict.fromkeys(one.advice for one in proof.checks if one.advice and not one.holds):
        made += paragraph(context.say(advice), NOTE, x=INDENT, gap=1.2)
    return made


def _short(context: Context, check: Check) -> str:
    """What tells a twin from the others."""
    return " ".join(context.belongs(check.id)) or check.name


def used(context: Context, check: Check) -> Cell:
    """Demand over capacity, where both are amounts of one sign."""
    share = check.utilisation
    if share is None and not isinstance(check.limit, tuple) and check.unit != "°C" and check.value > 0 and check.limit > 0:
        share = check.value / check.limit if check.sense in ("<=", "<") else check.limit / check.value
    if share is None or not share < 100:
        return Cell()
    return Cell(context.text("used", share=Amount(share * 100, "%", form=".0f")), STRONG)


def _line(context: Context, key: str, **parts: str) -> list[Block]:
    return [replace(block, keep=True) for block in paragraph(context.text(key, None, **parts), NOTE, x=INDENT, gap=1.2)]


def _title(context: Context, rows: list[Row], colour: Colour) -> Block:
    """The heading of a proof: a grey stripe with a bar in the colour of its verdict."""
    columns = (Column(), *[Column(align="r")] * 4)
    parts = table(columns, rows, header=False)
    tall = sum(part.height for part in parts)

    def draw(pen: Pen, y: float) -> None:
        pen.panel(0.0, y - tall, WIDTH, tall, STRIPE)
        pen.panel(-BAR - 3.0, y - tall, BAR, tall, colour)
        for part in parts:
            part.draw(pen, y)
            y -= part.height

    return Block(tall, draw, 8.0, keep=True, content=parts[0].content, tag=title_tag(GROUP.size))


def _walked(context: Context, step: Step, walk: Walk, *, quoting: bool = True) -> list[Block]:
    """The formulas of a walk, and below them in small type what they take from elsewhere."""
    several = [entry for entry in walk.entries if len(entry.lines) > 1]
    sign = column_of_signs(several) if several else SIGN
    made: list[Block] = []
    for entry in walk.entries:
        source = context.cite(entry.formula.source, step)
        made += entry_blocks(entry, source, sign if entry in several else SIGN, labelled=entry in several, context=context, gap=CLOSE)
    if made and quoting and (walk.quoted or walk.inputs):
        made[-1] = replace(made[-1], keep=True)
    if context.chapter not in context.ranges and any(map(_ranges, made)):
        context.ranges.add(context.chapter)
        made += _line(context, "ranges")
    if quoting and walk.quoted:
        made += _listed(context, "with_values", walk.quoted)
    if quoting and walk.inputs:
        made += _listed(context, "from_inputs", [_given(context, key) for key in _together(shortened(walk.inputs, context.design))])
    return made


def _ranges(block: Block) -> bool:
    """Whether long lists stand in a formula's numbers, by their ends."""
    return isinstance(block.content, Formula) and any(RANGE in spoken_numbers(line) for _, line in block.content.lines)


def _listed(context: Context, key: str, words: list[str]) -> list[Block]:
    more = f" · {context.text('more_twins', count=len(words) - QUOTED)}" if len(words) > QUOTED else ""
    return _line(context, key, values=" · ".join(words[:QUOTED]) + more)


def _together(keys: list[str]) -> list[str]:
    """Keys of one number of many parts as one, `gears.meshes.1.stack.*.field_mm`."""
    kinds = [(key.rpartition(".")[0].rpartition(".")[0], key.rpartition(".")[2]) for key in keys]
    return list(dict.fromkeys(f"{kind[0]}.*.{kind[1]}" if kinds.count(kind) > ALIKE else key for key, kind in zip(keys, kinds)))


def _given(context: Context, key: str) -> str:
    """An input as the design file has it."""
    if "*" in key or " (" in key:
        return key
    try:
        given = value_at(context.document.data, key, whole=True)
    except BadInput:
        return key
    return key if given is None or (isinstance(given, (dict, list)) and len(str(given)) > 40) else f"{key} = {exact(given)}"
