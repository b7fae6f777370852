# SPDX-License-Identifier: Apache-2.0
"""Does `explain` find every input, and no other?  Moves each number of the shipped designs by 0.1 % (whole numbers by
one) and solves.

    python bench/provenance.py [DESIGN …] [--step STEP]      (2 minutes for all)

An input that moves a value has to stand in its chain (else: MISSING); one that stands there has to move it (else: idle,
listed with `--idle`: a branch that is not taken, a limit that is not reached, or what cancels)."""

import sys
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import is_dataclass
from typing import Any

from calc.design.model import Design
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput
from calc.sheet.quantity import keys
from calc.sheet.value import leaves, link_of
from calc.solve import Results, solve
from calc.studies.explain import Chains
from calc.studies.shipped import DESIGNS, designs, shipped_name

SHARE = 1e-3  # by which a number is moved
DUST = 1e-9  # relative change of a value that is none


def numbers(inputs: Any, prefix: str = "") -> Iterator[tuple[str, str, float]]:
    """Every number of a design: its key, the key of the input as links have it, and the number in the unit of the
    key."""
    cls: Any = type(inputs)
    for key in keys(cls).values():
        content, here = getattr(inputs, key.attribute), f"{prefix}.{key.key}" if prefix else key.key
        shown = key.about.units.shown
        if content is None or here == "schema":
            continue
        if is_dataclass(content):
            yield from numbers(content, here)
        elif key.about.kind == "tables":
            for i, part in enumerate(content):
                yield from numbers(part, f"{here}.{getattr(part, 'name', i)}")
        elif key.about.kind == "number":
            yield here, here, shown(content)
        elif key.about.kind == "integer":
            yield here, here, int(content)
        elif key.about.kind in ("series", "integers"):
            for i, number in enumerate(content):
                yield f"{here}.{i}", here, shown(number) if key.about.kind == "series" else int(number)


def moved(document: Document, key: str, number: float) -> Design | None:
    """The design with one number moved; None where neither direction is allowed."""
    for sign in (1, -1):
        new = number + sign if isinstance(number, int) else number * (1 + sign * SHARE) if number else sign * SHARE
        try:
            return design(document.with_value(key, new))
        except (BadInput, KeyError, TypeError, IndexError):
            continue
    return None


def differs(a: Any, b: Any) -> bool:
    if abs(a - b) <= DUST * max(abs(a), abs(b)) or (a != a and b != b):
        return False
    return True


def compared(name: str, every: int = 1) -> tuple[Results, dict[str, set[str]], dict[str, set[str]], list[str]]:
    """Of one design: value → inputs that move it; value → inputs in its chain; those that can not be moved.  `every`:
    of so many one."""
    document = read(DESIGNS / f"{name}.toml")
    start = design(document)
    results = solve(start)
    chains, values = Chains(results), results.values()
    moves: dict[str, set[str]] = defaultdict(set)
    stuck = []
    for key, link, number in list(numbers(start))[::every]:
        other = moved(document, key, number)
        if other is None:
            stuck.append(key)
            continue
        after = solve(other, results).values()
        for id, value in values.items():
            if id not in after or differs(value.inside, after[id].inside):
                moves[id].add(link)
    chain: dict[str, set[str]] = {}
    for id, value in values.items():
        chain[id] = {key for link in chains.of(id) for key in link.inputs} | {
            leaf for leaf in leaves(link_of(value.inside)) if isinstance(leaf, str)
        }
    return results, moves, chain, stuck


def main() -> None:
    names = [a for a in sys.argv[1:] if not a.startswith("-")] or list(map(shipped_name, designs()))
    for name in names:
        results, moves, chain, stuck = compared(name)
        missing: dict[str, list[str]] = defaultdict(list)
        idle: dict[str, list[str]] = defaultdict(list)
        known = {link for _, link, _ in numbers(results.design)} - set(stuck)
        for id in results.values():
            if id.startswith("friction.scenarios."):
                continue  # many designs at once: explained by solving the one
            for key in moves[id] - chain[id]:
                missing[key].append(id)
            for key in (chain[id] & known) - moves[id]:
                idle[key].append(id)
        counts = f"{sum(map(len, missing.values()))} missing, {sum(map(len, idle.values()))} idle"
        print(f"{name}: {len(results.values())} values, {counts}; can not be moved: {', '.join(stuck)}")
        for word, gaps in (("MISSING", missing), ("idle", idle)):
            if word == "idle" and "--idle" not in sys.argv:
                continue
            for key, ids in sorted(gaps.items()):
                print(f"  {word} {key}: {len(ids)}: {' '.join(ids[:6] if '--all' not in sys.argv else ids)}")


if __name__ == "__main__":
    main()
