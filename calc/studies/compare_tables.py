# SPDX-License-Identifier: Apache-2.0
"""A comparison as tables, which terminal, screen and paper draw alike, and what it comes to in sentences.

A number is written with as many digits as it takes to tell it from the other one."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from math import log10

from ..design.model import STEPS
from ..design.names import addressed, belongs, in_context
from ..sheet.check import ORDER, Check
from ..sheet.number import short
from ..sheet.quantity import FLAGS
from ..sheet.step import Table
from ..sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Name, Text, plural
from .compare import (
    NOTABLE,
    RANKS,
    CheckDifference,
    Comparison,
    InputDifference,
    Judged,
    KeyResult,
    ValueDifference,
    turn,
)

DIGITS, MOST_DIGITS = 4, 12
LEFT_OUT = Text("left out")
NOT_HERE = Name("–")
Names = tuple[str, str]
Sign = Callable[[str], str]  # how a verdict is written


# --- inputs


def input_table(differences: Sequence[InputDifference], names: Names, *, ids: bool = True, full: bool = False) -> Table:
    """`ids`: by their keys, which say the unit too, else by their labels.  `full`: tables that only one design has are
    written out."""
    if ids:
        by_key = tuple((d.key, *input_texts(d, full=full)) for d in differences)
        return Table("inputs", Text("Inputs that differ"), columns((Text("Key"), ""), names), by_key)
    rows = tuple(
        (named(d.key, d.label, step=True, within=d.within), *input_texts(d, full=full), d.unit) for d in differences
    )
    return Table("inputs", Text("Inputs that differ"), columns((Text("Input"), ""), names, (Text("Unit"), "")), rows)


def input_texts(d: InputDifference, *, full: bool = False) -> tuple[Text, Text]:
    """Both sides of an input in words."""
    missing = Text("not used") if d.key in {step.key for step in STEPS} else LEFT_OUT
    return _content(d.a, missing, full), _content(d.b, missing, full)


def _content(content: object, missing: Text, full: bool) -> Text:
    if content is None:
        return missing
    if isinstance(content, dict):
        if not full:
            return plural("{n} key", "{n} keys", n=len(content))
        items = ((key, _content(item, missing, full)) for key, item in content.items())
        return COMMA.join(Text("{key} = {value}", key=key, value=item) for key, item in items)
    if isinstance(content, list):
        if content and isinstance(content[0], dict) and not full:
            return plural("{n} element", "{n} elements", n=len(content))
        return SEMICOLON.join(_content(item, missing, full) for item in content)
    if isinstance(content, bool):
        return Name(FLAGS[content])
    return _number(content, MOST_DIGITS) if isinstance(content, (int, float)) else Name(str(content))


def _number(number: float, digits: int) -> Text:
    return Text("{number}", number=Amount(number, digits=digits))


def named(id: str, label: Text, *, step: bool = False, within: str = "") -> Text:
    """A label with the part of the design that it belongs to: Length (front); `step`: Length (bearings, front).

    `within`: what the element is called that the id has by its index.
    """
    if not step:
        return in_context(label, id)
    parts = [Name(within) if within and part.isdigit() else part for part in addressed(id)]
    return Text("{label} ({where})", label=label, where=COMMA.join(parts)) if parts else label


# --- verdicts and checks


def verdict_table(compared: Comparison, names: Names, sign: Sign) -> Table:
    rows = tuple((v.title, judged_text(v.a, sign), judged_text(v.b, sign)) for v in compared.verdicts)
    return Table("verdicts", Text("Verdicts of the steps"), columns((Text("Step"), ""), names), rows)


def judged_text(judged: Judged, sign: Sign) -> Text:
    verdict = Name(sign(judged.verdict))
    if judged.reason:
        return Text("{verdict}: {reason}", verdict=verdict, reason=judged.reason)
    open_ = COMMA.join(words for _, words in judged.counts.words)
    return Text("{verdict}: {open}", verdict=verdict, open=open_) if open_ else verdict


def check_table(
    differences: Sequence[CheckDifference], names: Names, sign: Sign, *, ids: bool = True, margins: bool = True
) -> Table:
    """`ids`: checks by their ids, else by their names."""
    rows = []
    for d in differences:
        beside = [check.margin_text() if check else "" for check in (d.a, d.b)] if margins else []
        rows.append((*check_row(d, sign, ids=ids), *beside))
    heads = [(Text("Margin, {name}", name=name), "") for name in names] if margins else []
    return Table("checks", Text("Checks that differ"), (*check_columns(names), *heads), tuple(rows))


def check_columns(names: Names) -> tuple[tuple[Text, str], ...]:
    return columns((Text("Check"), ""), names, (Text("Limit"), ""))


def check_row(d: CheckDifference, sign: Sign, *, ids: bool = False) -> tuple[str, Text, Text, Text]:
    """The check with the part that it judges, its verdict and value in both designs, its limit."""
    values = pair(d.a.value if d.a else None, d.b.value if d.b else None)
    sides = zip((d.a, d.b), (d.before, d.after), values)
    a, b = (_judged_value(check, verdict, value, sign) for check, verdict, value in sides)
    return d.id if ids else in_context(d.name, d.id), a, b, limit_text(d)


def _judged_value(check: Check | None, verdict: str, value: Text, sign: Sign) -> Text:
    if check is None:
        return NOT_HERE
    text = Text("{verdict} {value}", verdict=sign(verdict), value=value)
    return Text("{value} {unit}", value=text, unit=check.unit) if check.unit else text


def limit_text(d: CheckDifference) -> Text:
    """The limit; where it has moved, both."""
    there = [c for c in (d.a, d.b) if c is not None]
    texts = [c.limit_text() for c in there]
    if len({c.kind for c in there}) > 1:
        marked = zip(there, texts)
        texts = [Text("{limit} (advice)", limit=text) if c.kind == "advice" else text for c, text in marked]
    return texts[0] if len(set(texts)) == 1 else Text("{before} → {after}", before=texts[0], after=texts[1])


# --- values


def value_table(
    step: str, title: Text, differences: Sequence[ValueDifference], names: Names, *, ids: bool = True
) -> Table:
    """The values of one step; `ids`: by their ids with the labels last, else by their labels."""
    rows = []
    for d in differences:
        cells = (*pair(d.a, d.b), d.unit, change_text(d))
        rows.append((d.id, *cells, d.label) if ids else (named(d.id, d.label), *cells))
    head = columns((Text("Value"), ""), names, (Text("Unit"), ""), (Text("Change"), ""))
    return Table(f"values_{step}", title, (*head, (EMPTY, "")) if ids else head, tuple(rows))


def pair(a: float | None, b: float | None) -> tuple[Text, Text]:
    """Two numbers with as many digits as tell them apart."""
    if a is None or b is None:
        return (NOT_HERE if a is None else _number(a, DIGITS), NOT_HERE if b is None else _number(b, DIGITS))
    for digits in range(DIGITS, MOST_DIGITS + 1):
        if short(a, digits) != short(b, digits):
            return _number(a, digits), _number(b, digits)
    return _number(a, DIGITS), _number(b, DIGITS)


def change_text(d: ValueDifference) -> Text:
    """From A to B: in degrees for a phase, in K for a temperature, else in percent of A."""
    if d.a is None or d.b is None:
        return EMPTY
    if d.phase:
        return _signed(turn(d.a, d.b), "°")
    if d.unit == "°C":
        return _signed(d.b - d.a, "K")
    if d.a == 0:
        return Text("from 0")
    percent = (d.b - d.a) / abs(d.a) * 100
    if abs(percent) > 99999:  # of next to nothing
        return Name("> +99999 %" if percent > 0 else "< −99999 %")
    return _signed(percent, "%")


def _signed(number: float, unit: str) -> Text:
    return Text("{change}", change=Amount(number, unit, form="+.0f" if abs(number) >= 100 else "+.2g"))


def columns(first: tuple[Text, str], names: Names, *more: tuple[Text, str]) -> tuple[tuple[Text, str], ...]:
    return (first, (Name(names[0]), ""), (Name(names[1]), ""), *more)


# --- what a comparison comes to
# Which verdicts moved and which way, and which of the key results got better or worse.

HARD = ("limit", "caution")  # kinds of checks that make a verdict of a step
BETTER, WORSE, SAME, NEW, GONE = Text("better"), Text("worse"), Text("the same"), Text("new"), Text("gone")
ACCEPTED, NOT_ACCEPTED = Text("accepted"), Text("no longer accepted")
WAYS = (WORSE, NEW, NOT_ACCEPTED, BETTER, ACCEPTED, GONE)  # in the order in which they are read


def sentences(comparison: Comparison, names: Names, sign: Sign) -> list[Text]:
    """The conclusion in a few sentences; `names`: of the two designs."""
    texts = [_whole(comparison, names)]
    if comparison.steps_moved:
        sides = [(v.title, sign(v.a.verdict), sign(v.b.verdict)) for v in comparison.steps_moved]
        steps = (Text("{step} {before} → {after}", step=step, before=a, after=b) for step, a, b in sides)
        texts.append(Text("Steps: {moves}.", moves=COMMA.join(steps)))
    return [
        *texts,
        *_of_moved([d for d in comparison.checks_moved if _hard(d)], sign),
        *_of_lone([d for d in comparison.checks_lone if _hard(d)], names),
        *_of_unusual(comparison.unusual, names),
        *_of_results(comparison.results),
        *_of_strikes(comparison.strikes),
    ]


def _of_moved(differences: Sequence[CheckDifference], sign: Sign) -> Iterator[Text]:
    """Limits and cautions that both designs have."""
    if not differences:
        yield Text("No limit and no caution changes its verdict.")
    if worse := [d for d in differences if _way(d) == WORSE]:
        yield Text("Limits and cautions to the worse: {moves}.", moves=_moves(worse, sign))
    if better := [d for d in differences if _way(d) == BETTER]:
        yield Text("Limits and cautions to the better: {moves}.", moves=_moves(better, sign))
    if accepted := [d for d in differences if d.accepted]:
        yield Text("Accepted in one of them only: {moves}.", moves=_moves(accepted, sign))


def _of_lone(differences: Sequence[CheckDifference], names: Names) -> Iterator[Text]:
    """Those that one design only has."""
    counts = sum(d.b is None for d in differences), sum(d.a is None for d in differences)
    for name, n in zip(names, counts):
        if n:
            yield plural(
                "Only in {name}: {n} limit or caution that does not pass.",
                "Only in {name}: {n} limits or cautions that do not pass.",
                n=n,
                name=name,
            )


def _of_unusual(unusual: tuple[Text, Text], names: Names) -> Iterator[Text]:
    if unusual[0] and unusual[0] == unusual[1]:
        yield Text("In both {inputs}.", inputs=unusual[0])
        return
    for name, inputs in zip(names, unusual):
        if inputs:
            yield Text("In {name} {inputs}.", name=name, inputs=inputs)


def _of_results(results: Sequence[KeyResult]) -> Iterator[Text]:
    """How many got better and worse, of those that both designs have."""
    ways = Counter(result.better for result in results if result.a is not None and result.b is not None)
    if ways:
        counts = dict(better=ways[True], worse=ways[False], same=ways[None], share=Amount(NOTABLE * 100, "%"))
        yield Text("Key results: {better} better, {worse} worse, {same} the same within {share}.", **counts)


def _of_strikes(strikes: tuple[float, float] | None) -> Iterator[Text]:
    """The tendency of the rattle at idle."""
    if strikes is None or not any(strikes):
        return
    if not all(strikes):
        before, after = (Text("open and strike") if F else Text("stay closed") for F in strikes)
        yield Text("At idle the flanks {before} → {after}.", before=before, after=after)
        return
    yield Text(
        "Rattle at idle, tendency: the teeth strike with up to {before} → {after}, {level}; that is no sound level, "
        "for no structure is known.",
        before=Amount(strikes[0], "N", digits=3),
        after=Amount(strikes[1], "N", digits=3),
        level=Amount(20 * log10(strikes[1] / strikes[0]), "dB", form="+.1f"),
    )


def _whole(comparison: Comparison, names: Names) -> Text:
    before, after = comparison.whole
    parts = dict(zip(("a", "b", "before", "after"), (*names, *comparison.words)))
    if before == after:
        if len(set(comparison.words)) == 1:
            return Text("{a} → {b}: the whole stays {before}.", **parts)
        return Text("{a} → {b}: the whole goes from {before} to {after}.", **parts)
    if comparison.only_accepted:
        return Text("{a} → {b}: the whole goes from {before} to {after}, by what is accepted.", **parts)
    if ORDER.index(after) > ORDER.index(before):
        return Text("{a} → {b}: the whole goes from {before} to {after}, to the worse.", **parts)
    return Text("{a} → {b}: the whole goes from {before} to {after}, to the better.", **parts)


def _hard(d: CheckDifference) -> bool:
    return any(check is not None and check.kind in HARD for check in (d.a, d.b))


def _moves(differences: Sequence[CheckDifference], sign: Sign) -> Text:
    """`✗ FAIL → ✓ pass 2, ▲ warn → ✓ pass 4`, the worst first."""
    counts = Counter((d.before, d.after) for d in differences)
    ordered = sorted(counts, key=lambda move: [-max(map(RANKS.index, move)), -RANKS.index(move[1])])
    return COMMA.join(Text("{before} → {after} {n}", before=sign(a), after=sign(b), n=counts[a, b]) for a, b in ordered)


# --- the two tables


def moved(comparison: Comparison) -> list[CheckDifference]:
    """The limits and cautions whose verdict moved, what got worse first, and those of one design only that do not
    pass."""
    return sorted((d for d in (*comparison.checks_moved, *comparison.checks_lone) if _hard(d)), key=_urgency)


def differing(comparison: Comparison) -> list[KeyResult]:
    """The key results that differ, or that one design does not have."""
    return [result for result in comparison.results if not _same(result)]


def moved_table(comparison: Comparison, names: Names, sign: Sign, most: int = 0) -> Table:
    """What moved; `most`: of it, the others as a number; 0: all."""
    rows = moved(comparison)
    shown = rows[:most] if most else rows
    left = len(rows) - len(shown)
    note = plural("{n} more limit or caution moved.", "{n} more limits or cautions moved.", n=left) if left else EMPTY
    head, cells = (*check_columns(names), (EMPTY, "")), tuple((*check_row(d, sign), _way(d)) for d in shown)
    return Table("moved", Text("Limits and cautions that moved"), head, cells, note)


def _urgency(d: CheckDifference) -> tuple[int, int, bool]:
    now = d.b or d.a
    return WAYS.index(_way(d)), -RANKS.index(d.after or d.before), now is None or now.kind != "limit"


def _way(d: CheckDifference) -> Text:
    if d.accepted:
        return NOT_ACCEPTED if d.worse else ACCEPTED
    if d.both:
        return WORSE if d.worse else BETTER
    return NEW if d.a is None else GONE


def result_table(comparison: Comparison, names: Names) -> Table:
    """The key results that differ, each of the part where it is worst; which are the same stands below."""
    rows = tuple(map(_row, differing(comparison)))
    same = [in_context(r.either.label, r.either.id) for r in comparison.results if _same(r)]
    note = Text("The same in both: {names}.", names=COMMA.join(same)) if same else EMPTY
    head = columns((Text("Key result"), ""), names, (Text("Unit"), ""), (Text("Change"), ""), (EMPTY, ""))
    return Table("key_results", Text("Key results"), head, rows, note)


def _same(result: KeyResult) -> bool:
    return result.better is None and result.a is not None and result.b is not None


def _row(result: KeyResult) -> tuple[Text, ...]:
    a, b = result.a, result.b
    numbers = (a.shown if a else None, b.shown if b else None)
    texts = pair(*numbers)
    label = result.either.label
    if a is not None and b is not None and a.id != b.id:  # the worst part is another one
        texts = (_at(texts[0], a.id), _at(texts[1], b.id))
        label = label if a.label == b.label else Text("{before} / {after}", before=a.label, after=b.label)
    else:
        label = in_context(label, result.either.id)
    difference = ValueDifference(result.either.id, label, result.either.unit, *numbers, result.relative)
    way = {True: BETTER, False: WORSE, None: NOT_HERE if a is None or b is None else SAME}[result.better]
    return label, *texts, Name(result.either.unit), change_text(difference), way


def _at(number: Text, id: str) -> Text:
    return Text("{number} ({where})", number=number, where=COMMA.join(belongs(id)) or Name(id.rpartition(".")[2]))
