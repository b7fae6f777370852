# SPDX-License-Identifier: Apache-2.0
"""Mutants of what judges: small faults put in one at a time, in a copy, to see whether the tests die with the code that
they test.

    python bench/mutants.py [COUNT] [SEED] [PROCESSES] [FILE ...]

Drawn at random from the modules that declare checks, from those that hold limits, and from the constants of friction and
rating; or from the files that are named. A number is 5 % larger or smaller, a comparison has the other sense, `min` and
`max` are exchanged, + and -; texts, units, labels and annotations are no such places. Against each, first the tests that
import its module, then those of its folder, then those of its step; a file of tests that fails without any mutant is
left out, and said.  Printed: a line for each (killed, by which file, or survived), then the share that died, and the
survivors."""

import ast
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence, Set
from concurrent.futures import ThreadPoolExecutor
from functools import cache, partial
from itertools import zip_longest
from pathlib import Path
from queue import SimpleQueue
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
LIMITS = ("library/journal_rules.py", "gears/limits.py", "sheet/check.py", "sheet/verdict.py")
CONSTANTS = (
    "friction/losses/",
    "friction/mesh/",
    "friction/models.py",
    "gears/rating/",
)  # of which the numbers alone are drawn
BINARY = {ast.Add: ("+", "-"), ast.Sub: ("-", "+"), ast.Mult: ("*", "/"), ast.Div: ("/", "*")}
COMPARED = {
    ast.Lt: ("<", ">="),
    ast.LtE: ("<=", ">"),
    ast.Gt: (">", "<="),
    ast.GtE: (">=", "<"),
    ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="),
}
SENSES = {">=": "<=", "<=": ">=", ">": "<", "<": ">"}  # of a check, where it is declared
LOGICAL = {ast.And: ("and", "or"), ast.Or: ("or", "and")}
EXTREMES = {"min": "max", "max": "min", "argmin": "argmax", "argmax": "argmin", "minimum": "maximum"}
EXTREMES |= {"maximum": "minimum", "largest": "smallest", "smallest": "largest", "nanmin": "nanmax", "nanmax": "nanmin"}
# take no results
SAYING = {"Text", "quantity", "value", "group", "table", "tables", "Amount", "round", "range", "rounded", "integers"}
TIME = 240  # s of the processor's time, however loaded the machine is; a mutant that loops for ever is dead as well


class Mutant(NamedTuple):
    """`kind`: "number", or what else is exchanged."""

    kind: str
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
        place = gap.find(old.encode())
        if place >= 0 and b"#" not in gap:
            yield Mutant("operator", path, left.end_lineno or 0, start + place, start + place + len(old), new)

    def instead(kind: str, node: ast.expr, *news: str) -> Iterator[Mutant]:
        start, end = at(node.lineno, node.col_offset), at(node.end_lineno or 0, node.end_col_offset or 0)
        for new in news:
            yield Mutant(kind, path, node.lineno, start, end, new)

    def of(node: ast.AST, above: ast.AST) -> Iterator[Mutant]:
        if isinstance(node, ast.BinOp) and type(node.op) in BINARY and not _speaks(node.left):
            yield from between(node.left, node.right, *BINARY[type(node.op)])
        elif isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in COMPARED:
            yield from between(node.left, node.comparators[0], *COMPARED[type(node.ops[0])])
        elif isinstance(node, ast.BoolOp):
            yield from between(node.values[0], node.values[1], *LOGICAL[type(node.op)])
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.Not):
            start = at(node.lineno, node.col_offset)
            yield Mutant("operator", path, node.lineno, start, at(node.operand.lineno, node.operand.col_offset), "")
        elif isinstance(node, ast.Name | ast.Attribute) and _named(node) in EXTREMES and isinstance(above, ast.Call):
            name, end = _named(node), at(node.end_lineno or 0, node.end_col_offset or 0)
            yield Mutant("operator", path, node.end_lineno or 0, end - len(name), end, EXTREMES[name])
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value in SENSES:
            yield from instead("operator", node, f'"{SENSES[node.value]}"')
        elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
            if not node.value:
                yield from instead("number", node, "1" if isinstance(node.value, int) else "0.1")
            elif isinstance(node.value, float) or isinstance(above, ast.BinOp):
                yield from instead("number", node, *(repr(float(f"{node.value * by:.12g}")) for by in (0.95, 1.05)))
            else:
                yield from instead("number", node, repr(node.value + 1))

    def walk(node: ast.AST, above: ast.AST) -> Iterator[Mutant]:
        yield from of(node, above)
        for name, child in ast.iter_fields(node):
            if name in ("annotation", "returns", "decorator_list") or (
                isinstance(node, ast.Call) and _named(node.func) in SAYING
            ):
                continue
            for inner in child if isinstance(child, list) else [child]:
                if isinstance(inner, ast.AST):
                    yield from walk(inner, node)

    module = ast.parse(source)
    yield from walk(module, module)


def judging() -> Iterator[Mutant]:
    """Every mutant of what judges: of checks and limits all, of the constants of their formulas the numbers."""
    for path in sorted((ROOT / "calc").rglob("*.py")):
        inside = path.relative_to(ROOT / "calc").as_posix()
        if inside in LIMITS or "CheckRule(\n" in path.read_text(encoding="utf-8"):
            yield from places(path)
        elif inside.startswith(CONSTANTS):
            yield from (mutant for mutant in places(path) if mutant.kind == "number")


def _named(function: ast.expr) -> str:
    return (
        function.id if isinstance(function, ast.Name) else function.attr if isinstance(function, ast.Attribute) else ""
    )


def _speaks(x: ast.expr) -> bool:
    return isinstance(x, ast.JoinedStr) or (isinstance(x, ast.Constant) and isinstance(x.value, str))


@cache
def stages(path: Path) -> list[tuple[str, ...]]:
    """The files of tests of a module, nearest first, each once: those that import it, those of its folder, those of its
    step."""
    inside = path.relative_to(ROOT / "calc")
    tests = sorted((ROOT / "tests" / "calc").rglob("test_*.py"))
    module = ".".join(("calc", *inside.with_suffix("").parts))
    named = (f"{module} import", f"{module.rpartition('.')[0]} import {inside.stem}")
    near = [x for x in tests if any(name in x.read_text(encoding="utf-8") for name in named)]
    folder = [x for x in tests if x.parent == ROOT / "tests" / "calc" / inside.parent and x not in near]
    step = [x for x in tests if inside.parts[0] in x.parts and x not in near and x not in folder]
    return [tuple(str(x.relative_to(ROOT)) for x in stage) for stage in (near, folder, step) if stage]


def failing(files: Sequence[str], copy: Path, *options: str, seconds: int = TIME) -> tuple[int, list[str]]:
    """What pytest returns for files of tests, and which of them fail."""
    command = [sys.executable, "-m", "pytest", "-q", "--no-header", "-p", "no:cacheprovider", *options, *files]
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": str(copy)}
    run = subprocess.run(
        command, cwd=copy, capture_output=True, text=True, env=environment, preexec_fn=partial(_limit, seconds)
    )
    lines = [line.split()[1] for line in run.stdout.splitlines() if line.startswith(("FAILED ", "ERROR "))]
    return run.returncode, list(dict.fromkeys(line.split("::")[0] for line in lines))


def killer(mutant: Mutant, copy: Path, unsound: Set[str]) -> str:
    """The first file of tests that fails, or nothing.  `unsound`: files that fail without a mutant."""
    target = copy / mutant.path.relative_to(ROOT)
    source = mutant.path.read_bytes()
    times = target.stat()
    target.write_bytes(source[: mutant.start] + mutant.new.encode() + source[mutant.end :])
    try:
        for files in stages(mutant.path):
            code, failed = failing([x for x in files if x not in unsound], copy, "-x")
            if code not in (0, 5):  # 5: no tests
                return "no end" if code < 0 else failed[0] if failed else "does not start"
        return ""
    finally:
        target.write_bytes(source)
        os.utime(target, ns=(times.st_atime_ns, times.st_mtime_ns))


def _limit(seconds: int) -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))


def main() -> None:
    numbers = [int(given) for given in sys.argv[1:] if given.isdigit()]
    count, seed, processes = (given or usual for given, usual in zip_longest(numbers, (200, 1, 2)))
    paths = [ROOT / given for given in sys.argv[1:] if not given.isdigit()]
    everywhere = list(judging()) if not paths else [x for path in paths for x in places(path)]
    drawn = random.Random(seed).sample(everywhere, min(count, len(everywhere)))
    print(f"{len(everywhere)} places, {len(drawn)} drawn", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        copies: SimpleQueue[Path] = SimpleQueue()
        for n in range(processes):
            shutil.copytree(ROOT, Path(folder) / str(n), ignore=shutil.ignore_patterns(".venv", ".git", "__pycache__"))
            copies.put(Path(folder) / str(n))
        files = sorted({x for mutant in drawn for stage in stages(mutant.path) for x in stage})
        unsound = set(failing(files, Path(folder) / "0", seconds=60 * TIME)[1])
        print(*(f"fails without a mutant: {x}" for x in sorted(unsound)), sep="\n", flush=True)

        def tried(mutant: Mutant) -> tuple[Mutant, str]:
            copy = copies.get()
            try:
                by = killer(mutant, copy, unsound)
            finally:
                copies.put(copy)
            print(f"{by or 'SURVIVED':60} {_shown(mutant)}", flush=True)
            return mutant, by

        with ThreadPoolExecutor(processes) as pool:
            results = list(pool.map(tried, drawn))
    survivors = [mutant for mutant, by in results if not by]
    print(
        f"{100 * (1 - len(survivors) / len(drawn)):.1f} % of {len(drawn)} died; survivors:",
        *map(_shown, survivors),
        sep="\n",
    )


def _shown(mutant: Mutant) -> str:
    source = mutant.path.read_bytes()
    line = source.decode().splitlines()[mutant.line - 1].strip()
    return (
        f"{mutant.path.relative_to(ROOT)}:{mutant.line}: {source[mutant.start : mutant.end].decode()!r} → "
        f"{mutant.new!r}   in   {line}"
    )


if __name__ == "__main__":
    main()
