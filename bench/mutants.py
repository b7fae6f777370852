# SPDX-License-Identifier: Apache-2.0
"""Mutants of calc/: small faults put in one at a time, in a copy, to see whether the tests die with the code that they
test.

    python bench/mutants.py [COUNT] [SEED] [PROCESSES]

Drawn at random over all places where an operator, a comparison, a number, a sign, `min` or `max` can be exchanged;
texts, units, labels and annotations are no such places.  Against each, first the tests that import its module, then
those of its step (of calc/locale: tests/languages), then those of the whole of calc/. Printed: a line for each
(killed, by which file, or survived), then the share that died, and the survivors."""

import ast
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import SimpleQueue
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
BINARY = {ast.Add: ("+", "-"), ast.Sub: ("-", "+"), ast.Mult: ("*", "/"), ast.Div: ("/", "*"), ast.Pow: ("**", "*")}
COMPARED = {
    ast.Lt: ("<", ">="),
    ast.LtE: ("<=", ">"),
    ast.Gt: (">", "<="),
    ast.GtE: (">=", "<"),
    ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="),
}
LOGICAL = {ast.And: ("and", "or"), ast.Or: ("or", "and")}
EXTREMES = {"min": "max", "max": "min", "minimum": "maximum", "maximum": "minimum", "sin": "cos", "cos": "sin"}
# take no results
SAYING = {"Text", "quantity", "value", "group", "table", "tables", "Amount", "round", "range", "rounded", "integers"}
TIME = 240  # s of the processor's time, however loaded the machine is; a mutant that loops for ever is dead as well


class Mutant(NamedTuple):
    path: Path
    line: int
    start: int  # in bytes from the start of the file
    end: int
    new: str


def places(path: Path) -> Iterator[Mutant]:
    """Every mutant of a file."""
    source = path.read_bytes()
    starts = [0]
    for line in source.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))

    def at(line: int, column: int) -> int:
        return starts[line - 1] + column

    def between(left: ast.expr, right: ast.expr, old: str, new: str) -> Iterator[Mutant]:
        start, end = at(left.end_lineno or 0, left.end_col_offset or 0), at(right.lineno, right.col_offset)
        gap = source[start:end]
        found = gap.find(old.encode())
        if found >= 0 and b"#" not in gap:
            yield Mutant(path, left.end_lineno or 0, start + found, start + found + len(old), new)

    def of(node: ast.AST) -> Iterator[Mutant]:
        if isinstance(node, ast.BinOp) and type(node.op) in BINARY and not _speaks(node.left):
            yield from between(node.left, node.right, *BINARY[type(node.op)])
        elif isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in COMPARED:
            yield from between(node.left, node.comparators[0], *COMPARED[type(node.ops[0])])
        elif isinstance(node, ast.BoolOp):
            yield from between(node.values[0], node.values[1], *LOGICAL[type(node.op)])
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.Not):
            start = at(node.lineno, node.col_offset)
            yield Mutant(path, node.lineno, start, at(node.operand.lineno, node.operand.col_offset), "")
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in EXTREMES:
            start, end = at(node.lineno, node.col_offset), at(node.lineno, node.func.end_col_offset or 0)
            yield Mutant(path, node.lineno, start, end, EXTREMES[node.func.id])
        elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
            start, end = at(node.lineno, node.col_offset), at(node.end_lineno or 0, node.end_col_offset or 0)
            new = node.value + 1 if isinstance(node.value, int) else node.value * 1.1 or 0.1
            yield Mutant(path, node.lineno, start, end, repr(new))

    def walk(node: ast.AST) -> Iterator[Mutant]:
        yield from of(node)
        for name, child in ast.iter_fields(node):
            if name in ("annotation", "returns", "decorator_list") or (
                isinstance(node, ast.Call) and _named(node.func) in SAYING
            ):
                continue
            for inner in child if isinstance(child, list) else [child]:
                if isinstance(inner, ast.AST):
                    yield from walk(inner)

    yield from walk(ast.parse(source))


def _named(function: ast.expr) -> str:
    return (
        function.id if isinstance(function, ast.Name) else function.attr if isinstance(function, ast.Attribute) else ""
    )


def _speaks(x: ast.expr) -> bool:
    return isinstance(x, ast.JoinedStr) or (isinstance(x, ast.Constant) and isinstance(x.value, str))


def stages(mutant: Mutant) -> list[list[str]]:
    """The files of tests, nearest first, each once."""
    inside = mutant.path.relative_to(ROOT / "calc")
    stem, folder = inside.stem, inside.parts[0]
    tests = sorted((ROOT / "tests" / "calc").rglob("test_*.py"))
    module = ".".join(("calc", *inside.with_suffix("").parts))
    named = (f"{module} import", f"{module.rpartition('.')[0]} import {stem}")
    near = [x for x in tests if any(name in x.read_text(encoding="utf-8") for name in named)]
    said = sorted((ROOT / "tests" / "languages").glob("test_*.py")) if folder == "languages" else []
    step = [x for x in tests if x.parent != ROOT / "tests" / "calc" and folder in x.parts and x not in near] + said
    rest = [x for x in tests if x not in near and x not in step and x.parent == ROOT / "tests" / "calc"]
    rest += [] if len(inside.parts) > 1 and folder != "sheet" else [x for x in tests if x not in near and x not in rest]
    return [[str(x.relative_to(ROOT)) for x in some] for some in (near, step, rest) if some]


def killer(mutant: Mutant, copy: Path) -> str:
    """The first file of tests that fails, or nothing."""
    target = copy / mutant.path.relative_to(ROOT)
    source = mutant.path.read_bytes()
    times = target.stat()
    target.write_bytes(source[: mutant.start] + mutant.new.encode() + source[mutant.end :])
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    try:
        for files in stages(mutant):
            command = [sys.executable, "-m", "pytest", "-x", "-q", "--no-header", "-p", "no:cacheprovider", *files]
            run = subprocess.run(
                command, cwd=copy, capture_output=True, text=True, env=environment, preexec_fn=_limited
            )
            if run.returncode < 0:
                return "no end"
            if run.returncode:
                failed = [
                    line.split()[1].split("::")[0]
                    for line in run.stdout.splitlines()
                    if line.startswith(("FAILED ", "ERROR "))
                ]
                return failed[0] if failed else "does not start"
        return ""
    finally:
        target.write_bytes(source)
        os.utime(target, ns=(times.st_atime_ns, times.st_mtime_ns))


def _limited() -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (TIME, TIME))


def main() -> None:
    count, seed, processes = (
        int(given) if given else usual for given, usual in zip([*sys.argv[1:], "", "", ""], (400, 1, 2))
    )
    everywhere = [x for path in sorted((ROOT / "calc").rglob("*.py")) for x in places(path)]
    drawn = random.Random(seed).sample(everywhere, count)
    print(f"{len(everywhere)} places, {count} drawn", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        copies: SimpleQueue[Path] = SimpleQueue()
        for n in range(processes):
            shutil.copytree(ROOT, Path(folder) / str(n), ignore=shutil.ignore_patterns(".venv", ".git", "__pycache__"))
            copies.put(Path(folder) / str(n))

        def tried(mutant: Mutant) -> tuple[Mutant, str]:
            copy = copies.get()
            try:
                by = killer(mutant, copy)
            finally:
                copies.put(copy)
            print(f"{by or 'SURVIVED':60} {_shown(mutant)}", flush=True)
            return mutant, by

        with ThreadPoolExecutor(processes) as pool:
            results = list(pool.map(tried, drawn))
    survivors = [mutant for mutant, by in results if not by]
    print(f"{100 * (1 - len(survivors) / count):.1f} % of {count} died; survivors:", *map(_shown, survivors), sep="\n")


def _shown(mutant: Mutant) -> str:
    source = mutant.path.read_bytes()
    line = source.decode().splitlines()[mutant.line - 1].strip()
    return (
        f"{mutant.path.relative_to(ROOT)}:{mutant.line}: {source[mutant.start : mutant.end].decode()!r} → "
        f"{mutant.new!r}   in   {line}"
    )


if __name__ == "__main__":
    main()
