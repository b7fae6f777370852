# SPDX-License-Identifier: Apache-2.0
"""What a comparison comes to: which verdicts moved and which way, and which of the key results got better or worse."""

from collections import Counter
from collections.abc import Sequence

from .studies.compare import NOTABLE, RANKS, CheckDifference, Comparison, KeyResult, StepVerdicts, ValueDifference
from .studies.compare_tables import NOT_HERE, Names, Sign, change_text, check_columns, check_row, columns, pair
from .id_words import belongs, in_context
from .sheet.check import ORDER
from .sheet.step import Table
from .sheet.text import COMMA, EMPTY, Amount, Name, Text, plural

HARD = ("limit", "caution")  # kinds of checks that make a verdict of a step
BETTER, WORSE, SAME, NEW, GONE = Text("better"), Text("worse"), Text("the same"), Text("new"), Text("gone")
ACCEPTED, NOT_ACCEPTED = Text("accepted"), Text("no longer accepted")
WAYS = (WORSE, NEW, NOT_ACCEPTED, BETTER, ACCEPTED, GONE)  # in the order in which they are read


def sentences(found: Comparison, names: Names, sign: Sign) -> list[Text]:
    """The conclusion in a few sentences; `names`: of the two designs."""
    both = [d for d in found.checks_moved if _hard(d)]
    lone = [d for d in found.checks_lone if _hard(d)]
    made = [_whole(found, names, sign)]
    if found.steps_moved:
        steps = [
            Text("{step} {before} → {after}", step=v.title, before=sign(v.a.verdict), after=sign(v.b.verdict)) for v in found.steps_moved
        ]
        made.append(Text("Steps: {moves}.", moves=COMMA.join(steps)))
    if not both:
        made.append(Text("No limit and no caution changes its verdict."))
    if some := [d for d in both if _way(d) == WORSE]:
        made.append(Text("Limits and cautions to the worse: {moves}.", moves=_moves(some, sign)))
    if some := [d for d in both if _way(d) == BETTER]:
        made.append(Text("Limits and cautions to the better: {moves}.", moves=_moves(some, sign)))
    if some := [d for d in both if d.accepted]:
        made.append(Text("Accepted in one of them only: {moves}.", moves=_moves(some, sign)))
    for name, some in zip(names, ([d for d in lone if d.b is None], [d for d in lone if d.a is None])):
        if some:
            made.append(
                plural(
                    "Only in {name}: {n} limit or caution that does not pass.",
                    "Only in {name}: {n} limits or cautions that do not pass.",
                    n=len(some),
                    name=name,
                )
            )
    if found.unusual[0] and found.unusual[0] == found.unusual[1]:
        made.append(Text("In both {inputs}.", inputs=found.unusual[0]))
    else:
        made += [Text("In {name} {inputs}.", name=name, inputs=odd) for name, odd in zip(names, found.unusual) if odd]
    ways = Counter(result.better for result in found.results if result.a is not None and result.b is not None)
    if ways:
        counts = dict(better=ways[True], worse=ways[False], same=ways[None], share=Amount(NOTABLE * 100, "%"))
        made.append(Text("Key results: {better} better, {worse} worse, {same} the same within {share}.", **counts))
    return made


def _whole(found: Comparison, names: Names, sign: Sign) -> Text:
    before, after = found.whole
    if before == after:
        return Text("{a} → {b}: the whole stays {verdict}.", a=names[0], b=names[1], verdict=sign(before))
    parts = dict(a=names[0], b=names[1], before=sign(before), after=sign(after))
    if found.only_accepted:
        return Text("{a} → {b}: the whole goes from {before} to {after}, by what is accepted.", **parts)
    if ORDER.index(after) > ORDER.index(before):
        return Text("{a} → {b}: the whole goes from {before} to {after}, to the worse.", **parts)
    return Text("{a} → {b}: the whole goes from {before} to {after}, to the better.", **parts)


def _step_move(v: StepVerdicts, sign: Sign) -> Text:
    return Text("{step} {before} → {after}", step=v.title, before=sign(v.a.verdict), after=sign(v.b.verdict))


def _hard(d: CheckDifference) -> bool:
    return any(check is not None and check.kind in HARD for check in (d.a, d.b))


def _moves(some: Sequence[CheckDifference], sign: Sign) -> Text:
    """`✗ FAIL → ✓ pass 2, ▲ warn → ✓ pass 4`, the worst first."""
    counts = Counter((d.before, d.after) for d in some)
    ordered = sorted(counts, key=lambda move: [-max(map(RANKS.index, move)), -RANKS.index(move[1])])
    return COMMA.join(Text("{before} → {after} {n}", before=sign(a), after=sign(b), n=counts[a, b]) for a, b in ordered)


# --- the two tables ---------------------------------------------------------------------------------------------------------
def moved(found: Comparison) -> list[CheckDifference]:
    """The limits and cautions whose verdict moved, what got worse first, and those of one design only that do not pass."""
    return sorted((d for d in (*found.checks_moved, *found.checks_lone) if _hard(d)), key=_urgency)


def differing(found: Comparison) -> list[KeyResult]:
    """The key results that differ, or that one design does not have."""
    return [result for result in found.results if not _same(result)]


def moved_table(found: Comparison, names: Names, sign: Sign, most: int = 0) -> Table:
    """What moved; `most`: of it, the others as a number; 0: all."""
    rows = moved(found)
    shown = rows[:most] if most else rows
    left = len(rows) - len(shown)
    note = plural("{n} more limit or caution moved.", "{n} more limits or cautions moved.", n=left) if left else EMPTY
    head = (*check_columns(names), (EMPTY, ""))
    return Table("moved", Text("Limits and cautions that moved"), head, tuple((*check_row(d, sign), _way(d)) for d in shown), note)


def _urgency(d: CheckDifference) -> tuple[int, int, bool]:
    now = d.b or d.a
    return WAYS.index(_way(d)), -RANKS.index(d.after or d.before), now is None or now.kind != "limit"


def _way(d: CheckDifference) -> Text:
    if d.accepted:
        return NOT_ACCEPTED if d.worse else ACCEPTED
    if d.both:
        return WORSE if d.worse else BETTER
    return NEW if d.a is None else GONE


def result_table(found: Comparison, names: Names) -> Table:
    """The key results that differ, each of the part where it is worst; which are the same stands below."""
    rows = tuple(map(_row, differing(found)))
    same = [in_context(r.either.label, r.either.id) for r in found.results if _same(r)]
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
