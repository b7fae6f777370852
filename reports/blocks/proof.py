# SPDX-License-Identifier: Apache-2.0
"""The proof of a check: what decides it, walked back from the number that it judges, and set as blocks.

Twins, which are one row of the table of checks (front and rear bearing, every mesh), are one proof: those that fail or
come near their limit with their numbers, the others by name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import prod
from operator import attrgetter
from typing import TYPE_CHECKING

import numpy as np

from calc.design.addresses import every, quantity_of, value_at
from calc.design.labels import label_of
from calc.sheet.check import Check, CheckRule
from calc.sheet.errors import BadInput
from calc.sheet.expression import digits_taken, governing, result, symbol_of
from calc.sheet.number import RANGE
from calc.sheet.step import Outcome, Step
from calc.sheet.text import Amount, Text, with_unit
from calc.sheet.units import UNITS
from calc.sheet.value import Line
from calc.sheet.verdict import severity
from calc.studies.explain import shortened

from ..context import Context, Element, Index, near
from ..typesetting.boxes import BETWEEN, Colour
from ..typesetting.equation import SIGN, EquationEntry, Label, Place, column_of_signs, entry_blocks, spoken_numbers
from ..typesetting.fonts import WIDTH
from ..typesetting.pagination import Block, Formula, paragraph
from ..typesetting.prose import BODY, GROUP, NOTE, STRONG, Style
from ..typesetting.tables import Cell, Column, Row, table
from ..typesetting.tags import title_tag
from .checks import lack_of, name_of, shown_value, sign_style
from .inputs import alike, exact
from .nomenclature import noted_result
from .words import STATE_COLOURS

if TYPE_CHECKING:
    from ..typesetting.pen import Pen


# formulas of a demand; a caution is most often the state of a limit at a corner, and that limit's proof has the others
MOST = {"limit": 9, "caution": 2}
ALIKE = 3  # values of one symbol that are quoted
FEW = 3  # elements of an array that are quoted one by one
HELD = 4  # of one that holds, and of a value
USED = 0.1  # of its limit: what holds and comes to less has its lines in the audit
LIMIT = 2  # formulas of a limit
COORDINATES = ("z", "φ", "ξ")  # what a place along an array is named by

Known = dict[str | Line, str]  # formula, and each of its lines that is shown → number of the proof that derives it


@dataclass(frozen=True, slots=True)
class Proof:
    """Checks that are proven together, the worst first, and their twins, which hold with more room."""

    checks: tuple[Check, ...]
    others: tuple[Check, ...]

    @property
    def governing(self) -> Check:
        return self.checks[0]


@dataclass(frozen=True, slots=True)
class Walk:
    """What a number comes from: formulas with their numbers, values that these take from elsewhere, and inputs."""

    entries: list[EquationEntry]
    quoted: list[tuple[str, Line]]  # "F = 1707 N [4.1]", and the line that gave it
    inputs: list[str]  # keys

    @property
    def lines(self) -> list[Line]:
        return [line for entry in self.entries for _, line in entry.lines]

    def derived(self, number: str) -> Known:
        """Its formulas and lines, as those of the proof with this number."""
        return {**{_name(line): number for line in self.lines}, **dict.fromkeys(self.lines, number)}


def proofs(context: Context, checks: Iterable[Check]) -> list[Proof]:
    """The proofs of a step: of what fails, can not be judged or comes near its limit, the worst first; then of what is
    always proven."""
    twins: dict[str, list[Check]] = {}
    for check in checks:
        twins.setdefault(check.rule.id, []).append(check)
    open_ones, kept = [], []
    for group in twins.values():
        if wanted := sorted(filter(near, group), key=severity):
            open_ones.append(Proof(tuple(wanted), tuple(check for check in group if check not in wanted)))
        elif group[0].rule.proven is not None and group[0].kind in MOST and _asked(context, group[0].rule):
            least = min(group, key=lambda check: check.margin)
            if (_share_used(least) or 1.0) < USED:
                continue
            kept.append(Proof((least,), tuple(check for check in group if check is not least)))
    return sorted(open_ones, key=lambda proof: severity(proof.governing)) + kept


def _asked(context: Context, rule: CheckRule) -> bool:
    """Whether there is anything to prove of what is always proven."""
    if rule.proven_where is None:
        return True
    asked = context.results.value(rule.proven_where)
    return asked is not None and asked.shown != 0


def demand(context: Context, proof: Proof, known: Known) -> Walk:
    """What the numbers that are judged come from; what another proof derives is quoted from there."""
    check = proof.governing
    roots = [context.chains.judged(twin) for twin in proof.checks]
    most = HELD if check.verdict == "pass" else MOST[check.kind]
    return _walk(context, roots, most, check.rule.proven or (), known)


def limit(context: Context, proof: Proof, known: Known) -> Walk:
    """What the limits come from; nothing where other proofs derive it."""
    roots = [context.chains.asked(check) for check in proof.checks]
    if all(line in known for root in roots for line in _lines(root)):
        return Walk([], [], [])
    return _walk(context, roots, LIMIT, (), {})


def value(context: Context, id: str, known: Known) -> Walk:
    """What a value comes from that no check judges."""
    return _walk(context, [tuple(link.line for link in context.chains.of(id)[-1:])], HELD, (), known)


def _walk(
    context: Context, roots: Sequence[tuple[Line | str, ...]], most: int, also: tuple[str, ...], known: Known
) -> Walk:
    """The lines nearest to the first of several numbers, `most` formulas and the symbols in `also`, and the same of the
    others."""
    starts = [[(line, governing(line)) for line in _lines(root)] for root in roots]
    shown = _nearest(context, starts[0], most, also, known)
    if not shown:
        return Walk([], [], [leaf for leaf in roots[0] if isinstance(leaf, str)])
    count = {name: sum(_name(line) == name for line in shown) for name in map(_name, shown)}
    for start in starts[1:]:
        left = dict(count)
        for line, index in context.origins.followed(start):
            if left.get(_name(line), 0) > 0 and line not in shown:
                left[_name(line)] -= 1
                shown[line] = index
    places, first = (
        _places(context, shown, [*context.origins.followed(element for start in starts for element in start)]),
        _lines(roots[0]),
    )
    taken = digits_taken({line: places[line].index if line in places else None for line in shown})
    entries: dict[str, EquationEntry] = {}
    for line in shown:
        entry = EquationEntry(line.formula, [], places, taken, parts=1, full=line in first)
        entries.setdefault(_name(line), entry).lines.append((Label(*context.say.halves(line.about)), line))
    return Walk(list(entries.values()), _quoted(context, shown, known, taken), _inputs(context, roots, shown))


def _lines(leaves: Iterable[Line | str]) -> list[Line]:
    return [leaf for leaf in leaves if isinstance(leaf, Line)]


def _nearest(
    context: Context, start: list[Element], most: int, also: tuple[str, ...], known: Known
) -> dict[Line, Index | None]:
    """The lines to be shown, each with the element of it that is followed."""
    names: dict[str, None] = {}
    shown: dict[Line, Index | None] = {}
    roots, wanted = [line for line, _ in start], set(also)
    for line, index in context.origins.followed(start):
        if line.formula.symbol in wanted:
            wanted.discard(line.formula.symbol)
        elif line not in roots and (
            _constant(context, (line, index))
            or _name(line) in known
            or (_name(line) not in names and len(names) >= most)
        ):
            continue
        names[_name(line)] = None
        shown[line] = index
    return shown


def _constant(context: Context, element: Element) -> bool:
    """Whether a line says no more than its value."""
    return bool(element[0].formula.shows) and not any(context.origins.of(element))


def _name(line: Line) -> str:
    return f"{line.formula.function.__module__}.{line.formula.__name__}"


def _quoted(
    context: Context, shown: Mapping[Line, Index | None], known: Known, taken: Mapping[Line, int]
) -> list[tuple[str, Line]]:
    """The values that the shown lines take from lines that are not shown."""
    lines: dict[tuple[str, str], Line] = {}
    values: dict[tuple[str, str], dict[str, str]] = {}  # symbol and where it is derived → numbers, each with its unit
    for element in shown.items():
        for needed, index in context.origins.of(element)[0]:
            if needed not in shown:
                where = known.get(needed) or (
                    context.text("as_in", number=known[_name(needed)]) if _name(needed) in known else ""
                )
                lines.setdefault((symbol_of(needed), where), needed)
                for at in [index] if index else _all(needed):
                    number, unit = result(needed, at, taken.get(needed, 0))
                    values.setdefault((symbol_of(needed), where), {})[context.say.number(number)] = unit
    return [(_quoted_value(*of, numbers), lines[of]) for of, numbers in values.items()]


def _all(line: Line) -> list[Index | None]:
    """Every element of an array of few along one axis; else the one that governs."""
    shape: Index = getattr(line.value, "shape", ())
    return [(i,) for i in range(shape[0])] if len(shape) == 1 and 1 < shape[0] <= FEW else [None]


def _quoted_value(symbol: str, where: str, numbers: dict[str, str]) -> str:
    """The values of a symbol, of many the first and the last, and the number of the proof that derives it."""
    some = list(numbers)
    listed = "; ".join(some) if len(some) <= ALIKE else f"{some[0]} … {some[-1]}"
    return f"{symbol} = {with_unit(listed, numbers[some[-1]])}{f' [{where}]' if where else ''}"


def _inputs(context: Context, roots: Sequence[tuple[Line | str, ...]], shown: Mapping[Line, Index | None]) -> list[str]:
    keys = [leaf for root in roots for leaf in root if isinstance(leaf, str)]
    return list(dict.fromkeys([*keys, *(key for element in shown.items() for key in context.origins.of(element)[1])]))


def _places(context: Context, shown: Mapping[Line, Index | None], reached: list[Element]) -> dict[Line, Place]:
    """The elements of arrays that are followed, each named by where it lies; `reached`: all that the numbers come
    from."""
    coordinates = [(coordinate, at) for coordinate, at in reached if at and coordinate.formula.symbol in COORDINATES]
    places = {}
    for line, index in shown.items():
        shape: Index = getattr(line.value, "shape", ())
        if index is None or prod(shape) < 2:
            continue
        lies = (
            coordinate
            for coordinate, at in coordinates
            if at == index and getattr(coordinate.value, "shape", ()) == shape
        )
        if (coordinate := next(lies, None)) is not None:
            number, unit = result(coordinate, index)
            words = f"({coordinate.formula.symbol} = {with_unit(context.say.number(number), unit)})"
        else:
            words = context.say(Text("(place {number} of {size})", number=index[-1] + 1, size=shape[-1]))
        places[line] = Place(index, words)
    return places


# --- a proof as blocks
# Title with verdict and utilisation, the limit, the demand with its numbers, the twins, and what would mend it.

NAMED = 6  # twins
QUOTED = 14  # values and inputs of a proof
INDENT = 8.0
BAR = 2.2
CLOSE = 2.4  # between formulas
STRIPE: Colour = (0.95, 0.95, 0.95)


def proof_blocks(context: Context, number: str, step: Step, outcome: Outcome[object]) -> list[Block]:
    """The proofs of a step, numbered, and what leads to the value that stands for it."""
    step_proofs = proofs(context, outcome.checks)
    known: Known = {}
    blocks: list[Block] = []
    for n, proof in enumerate(step_proofs, 1):
        walk = demand(context, proof, known)
        held = limit(context, proof, known)
        blocks += _proof(context, f"{number}.{n}", step, proof, walk, held)
        known = walk.derived(f"{number}.{n}") | dict.fromkeys(held.lines, f"{number}.{n}") | known
    return blocks + _headline(context, step, {check.value_id for proof in step_proofs for check in proof.checks}, known)


def _headline(context: Context, step: Step, proven: set[str], known: Known) -> list[Block]:
    """How the value comes about that stands for a step, where no proof shows it."""
    heads = [value for value in step.heads(context.values) if context.tells(value.id)]
    if heads and heads[0].about.worst == "least":  # of the bearings the one with the thinnest film
        heads = sorted((value for value in heads if value.about is heads[0].about), key=attrgetter("shown"))
    head = next(iter(heads), None)
    if head is None or head.id in proven or not head.shown or not (walk := value(context, head.id, known)).entries:
        return []
    if len(walk.lines) == 1 and not walk.quoted:  # one formula of inputs, as the stroke
        return []
    title = f"{context.say(head.label)}: {context.written(head.shown, head.unit)}"
    blocks = [
        _title([(Cell(title, STRONG), "", "", "", "")], (0.35, 0.35, 0.35)),
        *_walked(context, step, walk),
    ]
    return [*blocks[:-1], replace(blocks[-1], keep=False)]


def _proof(context: Context, number: str, step: Step, proof: Proof, walk: Walk, held: Walk) -> list[Block]:
    rows: list[Row] = []
    for n, check in enumerate(proof.checks):
        name = f"{number}  {name_of(context, check)}" if n == 0 else name_of(context, check)
        state = context.state(check)
        judgement = Cell(f"{shown_value(context, check)} · {context.say(check.limit_text())}", STRONG)
        rows.append(
            (
                Cell(name, STRONG),
                judgement,
                Cell(context.say(check.margin_text()), STRONG),
                used(context, check),
                sign_style(context, state),
            )
        )
    blocks = [_title(rows, STATE_COLOURS[context.state(proof.governing)])]
    for check in proof.checks[:1]:
        context.cite(check.source, step)
        blocks += _line(context, "limit_is", limit=context.say(check.limit_text()), source=check.source)
    blocks += _walked(context, step, held, quoting=False)
    if not _reached(proof.governing, walk):
        blocks += _line(context, "no_formula")
    if not walk.entries:
        moved = [key for key in proof.governing.moved_by if key not in walk.inputs]
        walk = Walk([], [], [*walk.inputs, *moved])
    blocks += _walked(context, step, walk)
    blocks += _after(context, proof)
    last = blocks[-1]
    blocks[-1] = replace(last, keep=False)
    return blocks


def _reached(check: Check, walk: Walk) -> bool:
    """Whether a line of the walk gives the number that is judged; a solution over many of them may have none of its
    own."""
    judged = UNITS[check.unit].inside(check.value)
    values = [
        line.value
        for entry in walk.entries
        for _, line in entry.lines
        if isinstance(line.value, (int, float, np.ndarray))
    ]
    return any(np.isclose(value, judged, rtol=1e-6, atol=0.0).any() for value in values)


def _after(context: Context, proof: Proof) -> list[Block]:
    """The twins, what the formulas are not made for, and what would mend it."""
    blocks: list[Block] = []
    if proof.others:
        twins = [
            Text(
                "{name} {value} {limit} ({margin})",
                name=_short(context, check),
                value=Amount(check.value, check.unit),
                limit=check.limit_text(),
                margin=check.margin_text(),
            )
            for check in proof.others[:NAMED]
        ]
        more = [context.text("more_twins", count=len(proof.others) - NAMED)] if len(proof.others) > NAMED else []
        blocks += _line(context, "also_judged", checks="; ".join([*map(context.say, twins), *more]))
    for method in dict.fromkeys(method for check in proof.checks for method in context.outside(check)):
        blocks += _line(
            context,
            "outside_of",
            name=name_of(context, method),
            value=shown_value(context, method),
            limit=context.say(method.limit_text()),
        )
    check = proof.governing
    if lack := lack_of(context, check):
        blocks += paragraph(lack, BODY, x=INDENT, gap=1.2)
    if check.accepted:
        blocks += _line(context, "accepted_because", reason=check.accepted)
    if advice := _advice(context, [twin for twin in proof.checks if not twin.holds]):
        blocks += paragraph(advice, BODY, x=INDENT, gap=1.2)
    return blocks


def _advice(context: Context, checks: Sequence[Check]) -> str:
    """What would mend each of the checks, then what else is advised, each sentence once."""
    remedies, others = [], []
    for check in checks:
        advice, ways = context.say(check.to_do), context.say(check.ways_text())
        if ways and advice.startswith(ways):
            remedies.append(ways)
            advice = advice.removeprefix(ways).strip()
        others.append(advice)
    return " ".join(filter(None, dict.fromkeys([*remedies, *others])))


def _short(context: Context, check: Check) -> str:
    """What tells a twin from the others."""
    return " ".join(context.belongs(check.id)) or check.name


def _share_used(check: Check) -> float | None:
    """Demand over capacity, where both are amounts of one sign."""
    alike = not isinstance(check.limit, tuple) and check.unit != "°C" and check.value > 0 and check.limit > 0
    if check.utilisation is not None or not alike:
        return check.utilisation
    assert not isinstance(check.limit, tuple)
    return check.value / check.limit if check.sense in ("<=", "<") else check.limit / check.value


def used(context: Context, check: Check) -> Cell:
    share = _share_used(check)
    if share is None or not share < 100:
        return Cell()
    return Cell(context.text("used", share=Amount(share * 100, "%", form=".0f")), STRONG)


def _line(context: Context, key: str, style: Style = BODY, **parts: str) -> list[Block]:
    words = context.text(key, None, **parts)
    return [replace(block, keep=True) for block in paragraph(words, style, x=INDENT, gap=1.2)]


def _title(rows: list[Row], colour: Colour) -> Block:
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
    blocks: list[Block] = []
    for entry in walk.entries:
        source = context.cite(entry.formula.source, step)
        blocks += entry_blocks(
            entry, source, sign if entry in several else SIGN, labelled=entry in several, context=context, gap=CLOSE
        )
    if blocks and quoting and (walk.quoted or walk.inputs):
        blocks[-1] = replace(blocks[-1], keep=True)
    if context.chapter not in context.ranges and any(map(_ranges, blocks)):
        context.ranges.add(context.chapter)
        blocks += _line(context, "ranges")
    if quoting and walk.quoted:
        listed = _listed(context, "with_values", [words for words, _ in walk.quoted])
        names = dict.fromkeys(noted_result(context, line) for _, line in walk.quoted[:QUOTED])
        blocks += [replace(listed[0], indexed=BETWEEN.join(filter(None, names))), *listed[1:]]
    if quoting and walk.inputs:
        blocks += _listed(
            context, "from_inputs", [_given(context, key) for key in _together(shortened(walk.inputs, context.design))]
        )
    return blocks


def _ranges(block: Block) -> bool:
    """Whether long lists stand in a formula's numbers, by their ends."""
    return isinstance(block.content, Formula) and any(RANGE in spoken_numbers(line) for _, line in block.content.lines)


def _listed(context: Context, key: str, words: list[str]) -> list[Block]:
    more = f" · {context.text('more_twins', count=len(words) - QUOTED)}" if len(words) > QUOTED else ""
    return _line(context, key, NOTE, values=" · ".join(words[:QUOTED]) + more)


def _together(keys: list[str]) -> list[str]:
    """Keys of one number of many parts as one, `gears.meshes.1.stack.*.field_mm`."""
    kinds = [(key.rpartition(".")[0].rpartition(".")[0], key.rpartition(".")[2]) for key in keys]
    return list(
        dict.fromkeys(f"{kind[0]}.*.{kind[1]}" if kinds.count(kind) > ALIKE else key for key, kind in zip(keys, kinds))
    )


def _given(context: Context, key: str) -> str:
    """An input by its name with its value, in an audit as the design file has it; of elements together what stands at
    each."""
    data = context.document.data
    key, _, material = key.partition(" (")
    if material:  # and what the table has of it
        name = key if context.audit else context.say(_common(label_of(data, every(data, key)[0]), "*" in key))
        return f"{name} ({material}"
    try:
        places = every(data, key)
        each = [value_at(data, one, whole=True) for one in places]
    except BadInput:
        return key if context.audit else context.say(label_of(data, key))
    given = each if "*" in key else each[0]
    name = context.say(_common(label_of(data, places[0]), len(places) > 1))
    if given is None or None in each or (isinstance(given, (dict, list)) and len(str(given)) > 40):
        return key if context.audit else name
    if context.audit:
        return f"{key} = {exact(given)}"
    if isinstance(given, str):
        return f"{name} = {given}"
    numbers = "; ".join(alike([exact(one) for one in (given if isinstance(given, list) else [given])]))
    return f"{name} = {with_unit(context.say.number(numbers), quantity_of(data, places[0]).unit)}"


def _common(label: Text, several: bool) -> Text:
    """Of several elements the label without the one that it names."""
    part = label.parts.get("label")
    return part if several and isinstance(part, Text) else label
