# SPDX-License-Identifier: Apache-2.0
"""`contralbero design`: the whole drive by one command; `--pick N` writes one of its front into the design file."""

import hashlib
import json
import os
import re
import sys
import time
from argparse import Namespace
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np

from assistant.commands.check import changed
from assistant.extras import demand
from assistant.named_files import STANDARD, put, read_design
from assistant.results_text import print_summary, table_json, table_lines
from assistant.session.saving import asked_for, make_folder, saved_text, spare, write_asked
from calc.design.disk import read_file
from calc.design.limits import DESIGN_BYTES, FRONT_BYTES
from calc.design.toml_file import Document, design, parse
from calc.sheet.errors import BadInput, InputError, NoSolution, text_of
from calc.sheet.text import Text, plural
from calc.solve import solve
from calc.studies.drive.classes import NotClosed, without_proof
from calc.studies.drive.evolve import EVALUATIONS, evolved
from calc.studies.drive.front import NAME as FRONT
from calc.studies.drive.front import Broken, searched
from calc.studies.drive.output import csv_text, json_text, power_of_ten, said, stood, table
from calc.studies.drive.problem import MOST_VALUES, Problem
from calc.studies.drive.refusal import refusal
from calc.studies.drive.search import FrontFound, FrontTable, asked, named, search
from calc.studies.drive.solved_drive import Whole

DRIVE = r"\d{3,4}\.toml"  # names of drives
SECONDS = 2.0  # a class, about
SOLVING = 0.1  # s: a drive, whole, about
SEARCHING = 0.7  # of the time that is given is for the classes, the rest for solving drives whole


def run_design(given: Namespace) -> int:
    if given.scheduler:
        demand("farm", "distributed", "--scheduler")
    document, _ = changed(read_design(given.file), [])
    if given.out is None and not given.dry:
        raise BadInput(
            "contralbero design",
            [InputError(0, "", "", Text("needs --out FOLDER, where the drives are put; or --dry"))],
        )
    try:
        problem, _ = asked(document, own_keys(given))
        if given.pick is not None:
            return _pick(given, document, problem)
        if given.dry:
            return _dry(given, problem)
        return _search(given, problem)
    except NoSolution as none:
        print(f"{given.file}: {none}", file=sys.stderr)
        return 3


def own_keys(given: Namespace) -> dict[str, object]:
    """The keys of [optimise] that stand on the command line."""
    keys: dict[str, object] = {}
    if given.objectives:
        keys["objectives"] = [objective.strip() for objective in given.objectives.split(",")]
    if given.limit:
        keys["limits"] = list(given.limit)
    if given.shaft is not None:
        keys["shaft"] = given.shaft
    if given.rows is not None:
        keys["rows"] = given.rows
    if given.seed is not None:
        keys["seed"] = given.seed
    errors: list[InputError] = []
    for name in ("most", "least"):
        if getattr(given, name):
            keys[name] = dict(_bound(bound, f"--{name}", errors) for bound in getattr(given, name))
    if given.vary or given.spaced:
        keys["vary"] = _varied(given, errors)
    if given.rows is not None and not 1 <= given.rows <= 2000:
        errors.append(InputError(0, "--rows", str(given.rows), Text("must be a whole number from 1 to 2000")))
    if given.time is not None and not 0 < given.time < float("inf"):
        errors.append(InputError(0, "--time", f"{given.time:g}", Text("must be a number of seconds above 0")))
    if errors:
        raise BadInput("contralbero design", errors)
    return keys


def _bound(text: str, option: str, errors: list[InputError]) -> tuple[str, float]:
    name, _, number = text.partition("=")
    try:
        return name.strip(), float(number)
    except ValueError:
        errors.append(InputError(0, option, text, Text("must be NAME=NUMBER, like seat_mm=82")))
        return name.strip(), 0.0


def _varied(given: Namespace, errors: list[InputError]) -> dict[str, object]:
    """What --vary and --spaced say, by their keys; each may be said once."""
    keys: dict[str, object] = {}
    for option, texts, read_range in (("--vary", given.vary, _vary), ("--spaced", given.spaced, _spaced)):
        for text in texts:
            key, _, rest = (part.strip() for part in text.partition("="))
            try:
                if key in keys:
                    raise ValueError(Text("stands twice; give all its values at once"))
                keys[key] = read_range(rest)
            except ValueError as wrong:
                errors.append(InputError(0, option, text, text_of(wrong)))
                keys.setdefault(key, ["?"])
    return keys


def _vary(rest: str) -> object:
    """LO:HI:N, A,B or fixed; pairs of fits or surfaces are joined by a stroke: IT6/IT7."""
    if rest == "fixed":
        return rest
    if rest and ":" not in rest:
        return [_value(value.strip()) for value in rest.split(",")]
    low, high, number = _three(rest, Text("must be KEY=LO:HI:N, KEY=VALUE,VALUE,… or KEY=fixed"))
    if not (number.is_integer() and (number > 1 if high > low else number == 1)):
        reason = "N must be a whole number of values, 2 or more; values a step apart are --spaced KEY=LO:HI:STEP"
        raise ValueError(Text(reason))
    if number > MOST_VALUES:
        raise ValueError(Text("N must be at most {most} values", most=MOST_VALUES))
    return [round(value, 9) for value in np.linspace(low, high, int(number)).tolist()]


def _spaced(rest: str) -> object:
    """LO:HI:STEP."""
    low, high, step = _three(rest, Text("must be KEY=LO:HI:STEP"))
    return {"from": low, "to": high, "step": step}


def _three(rest: str, form: Text) -> tuple[float, float, float]:
    try:
        low, high, third = map(float, rest.split(":"))
    except ValueError:
        raise ValueError(form) from None
    if not low <= high < float("inf") or not np.isfinite(low):
        raise ValueError(Text("must go from a lower number to a higher one"))
    return low, high, third


def _value(text: str) -> Any:
    if "/" in text:
        return [_value(part) for part in text.split("/")]
    try:
        return int(text) if text.lstrip("+-").isdigit() else float(text)
    except ValueError:
        return text


def _dry(given: Namespace, problem: Problem) -> int:
    for line in said(problem):
        print(line)
    if (why := without_proof(problem)) is not None:
        evaluations = given.evaluations or EVALUATIONS
        print(_no_proof(why, evaluations), end="; ")
        print(Text("about {seconds} s", seconds=f"{SOLVING * evaluations:.0f}"))
        return 0
    classes, seconds = len(problem.classes), SECONDS * len(problem.classes) + 5
    print(
        plural(
            "{n} class, about {seconds} s for one process",
            "{n} classes, about {seconds} s for one process",
            n=classes,
            seconds=f"{seconds:.0f}",
        )
    )
    return 0


def _no_proof(why: Text, evaluations: int) -> Text:
    return Text("{why}: its front can not be proved; a search over {n} whole solutions instead", why=why, n=evaluations)


def _search(given: Namespace, problem: Problem) -> int:
    folder = Path(given.out)
    if os.path.exists(folder) and not os.path.isdir(folder):
        raise BadInput(str(folder), [InputError(0, "--out", "", Text("is a file; give the name of a folder"))])
    if os.path.isdir(folder):
        _spare_others(folder, Path(given.file))
    quiet = given.json or given.quiet
    if given.processes is not None and given.processes < 1:
        raise BadInput(
            "contralbero design", [InputError(0, "--processes", str(given.processes), Text("must be 1 or more"))]
        )
    processes = (
        given.processes if given.processes is not None else min(os.cpu_count() or 1, max(1, len(problem.classes)))
    )
    make_folder(folder, "--out")
    if not quiet:
        print(plural("{n} class", "{n} classes", n=len(problem.classes)), end=", ")
        print(plural("{n} process", "{n} processes", n=processes), end="; ")
        print(Text("Ctrl-C keeps what there is by then"), flush=True)

    def told(done: int, known: FrontTable, name: str) -> None:
        if quiet:
            return
        best = _best(problem, known)
        print(
            f"  {done}/{len(problem.classes)}  {name}: {power_of_ten(known.combinations)}, "
            f"{Text('front {n}', n=len(known))}{best}",
            flush=True,
        )

    def first(drive: Whole) -> None:
        if not quiet:
            print(
                Text(
                    "  first drive that passes: {drive}, after {seconds} s",
                    drive=_numbers(problem, drive.objectives),
                    seconds=f"{time.monotonic() - began:.0f}",
                ),
                flush=True,
            )

    began, most = time.monotonic(), given.time or float("inf")
    stop, enough = (lambda share=share: time.monotonic() - began > share * most for share in (SEARCHING, 1.0))
    try:
        with asked_for(folder):
            front = search(problem, processes, folder / "parts", told, None, given.scheduler or "", stop, first, enough)
    except NotClosed as why:
        front = _without_proof(given, problem, why, enough)
    if not front.drives and not front.whole:
        print(
            Text(
                "no drive that passes is known yet: stopped at {done} of {classes} classes; the same command goes on",
                done=front.done,
                classes=len(problem.classes),
            ),
            file=sys.stderr,
        )
        return 3
    if not front.drives:
        return nothing(given, front)
    write(folder, front)
    if given.json:
        print(
            json.dumps(json.loads(json_text(front)) | {"table": table_json(table(front))}, ensure_ascii=False, indent=1)
        )
        return 0
    title, *lines = table_lines(table(front))
    print(f"\n{title}")
    print("\n".join(lines))
    print(f"\n{stood(front)}")
    check, pick = (
        f"contralbero check {given.out}/001.toml",
        f"contralbero design {given.file} --out {given.out} --pick 1",
    )
    print(Text("`{check}` is one of them; `{pick}` writes it into the file.", check=check, pick=pick))
    return 0


def _without_proof(given: Namespace, problem: Problem, why: NotClosed, enough: Callable[[], bool]) -> FrontFound:
    """Where the closed form does not hold: said at once, with what it means."""
    evaluations, quiet = given.evaluations or EVALUATIONS, given.json or given.quiet
    if not quiet:
        print(_no_proof(why.text, evaluations), flush=True)

    def told(done: int, most: int, passing: int) -> None:
        if not quiet:
            print(Text("  {done} of {most} solved, {passing} pass", done=done, most=most, passing=passing), flush=True)

    return evolved(problem, evaluations, problem.seed, told, enough)


def _best(problem: Problem, known: FrontTable) -> str:
    finite = known.objectives[np.isfinite(known.objectives).all(1)]
    if not len(finite):
        return ""
    return f"; {_numbers(problem, dict(zip(problem.objectives, finite.min(0))))}"


def _numbers(problem: Problem, objectives: Mapping[str, float]) -> str:
    """Power, mass and seat, as far as they are wanted."""
    units = {"power": "W", "mass": "kg", "seat": "mm"}
    return " · ".join(f"{objectives[name]:.4g} {units[name]}" for name in problem.objectives if name in units)


def _front(folder: Path) -> tuple[str, list[Path]]:
    """The hash of the design that the front in a folder was searched for, and the files of its drives, and no other
    file of the folder.  Raises OSError, Broken."""
    design, count = searched(read_file(folder / FRONT, FRONT_BYTES))
    return design, [path for n in range(1, count + 1) if (path := folder / f"{n:03d}.toml").exists()]


def _drives(folder: Path) -> list[Path]:
    """Those files; none where there is no front."""
    try:
        return _front(folder)[1]
    except (OSError, Broken):
        return []


def _hashes(drives: Iterable[Path]) -> Iterator[str]:
    for drive in drives:
        with suppress(OSError):
            yield hashlib.sha256(read_file(drive, DESIGN_BYTES)).hexdigest()


def _spare_others(folder: Path, source: Path) -> None:
    """Raises BadInput where drives would be written over a file that is not of an earlier front, or over the design
    itself."""
    known = {path.name for path in _drives(folder) if not (source.exists() and path.samefile(source))}
    others = [
        path.name for path in sorted(folder.glob("*.toml")) if re.fullmatch(DRIVE, path.name) and path.name not in known
    ]
    if others:
        why = Text("exists already and is left alone; choose another name")
        raise BadInput(str(folder), [InputError(0, "--out", name, why) for name in others])


def write(folder: Path, front: FrontFound) -> None:
    """Every drive as a design of its own, then the front."""
    old = _drives(folder)
    for n, drive in enumerate(front.drives, 1):
        write_asked(folder / f"{n:03d}.toml", drive_text(front.problem, drive.document))
    write_asked(folder / "front.csv", csv_text(front))
    write_asked(folder / FRONT, json_text(front))
    now = {f"{n:03d}.toml" for n in range(1, len(front.drives) + 1)}
    for path in old:
        if path.name not in now:
            with asked_for(path):
                path.unlink(missing_ok=True)


def drive_text(problem: Problem, drive: Document) -> str:
    """A drive as an ordinary design file: the user's own with its keys changed, comments kept."""
    return saved_text(problem.start.raw, drive.data)


def _pick(given: Namespace, document: Document, problem: Problem) -> int:
    """Drive N of the folder into the file, or into another; it is read, checked and solved before."""
    folder, source = Path(given.out or "."), Path(given.file)
    row = folder / f"{given.pick:03d}.toml"
    try:
        searched_for, drives = _front(folder)
        raw = read_file(row, DESIGN_BYTES) if row in drives else None
    except (OSError, Broken):
        raw = None
    if raw is None:
        why = Text("there is no such drive in {folder}", folder=str(folder))
        raise BadInput("--pick", [InputError(0, "", str(given.pick), why)])
    if document.sha256 not in (searched_for, *_hashes(drives)):  # the design that was searched, or one of its drives
        why = Text("was searched for another version of {file}: run the search again", file=given.file)
        raise BadInput(str(folder), [InputError(0, "--pick", str(given.pick), why)])
    results = solve(design(parse(raw, str(row))))
    target = Path(given.output) if given.output else source
    if str(target) == STANDARD:
        put(STANDARD, raw)
        return 0
    if given.output:
        spare(target, given.file)
    write_asked(target, raw.decode("utf-8"), backup=True, expected=None if given.output else document.raw)
    print(Text("{target} is now drive {n} of {folder}", target=str(target), n=given.pick, folder=str(folder)), end="")
    print("" if given.output else Text("; as it was before: {file}.bak", file=str(target)))
    print_summary(results)
    return 0


def nothing(given: Namespace, front: FrontFound) -> int:
    """Exit 3: what stops the search, and what alone would have to give way."""
    print(
        Text("nothing passes: {n} combinations", n=power_of_ten(front.table.combinations)), file=sys.stderr, flush=True
    )
    for why, first in {str(why): n for n, why in reversed(front.table.refused)}.items():
        print(f"  {named(front.problem.classes[first])}: {why}", file=sys.stderr)
    why_not = refusal(front)
    if why_not.always:
        print(Text("every drive that was solved whole breaks {ids}", ids=", ".join(why_not.always)), file=sys.stderr)
        print(
            Text("nothing that is varied moves it: `contralbero check {file}` says how to repair it", file=given.file),
            file=sys.stderr,
        )
        return 3
    if why_not.miss is not None:
        print(
            Text("the nearest lacks a margin of {miss} % on its films or slopes", miss=f"{why_not.miss * 100:.1f}"),
            file=sys.stderr,
        )
    if why_not.lines:
        print(Text("One requirement alone would have to give way, all else as it is:"), file=sys.stderr)
    width = max((len(line.key) for line in why_not.lines), default=0)
    for line in why_not.lines:
        beside = [str(note) for note in (line.beside,) if note]
        beside += [str(Text("then breaks {ids}", ids=", ".join(line.broken)))] if line.broken else []
        print(f"  {line.key:<{width}} {line.change}" + (f"   ({'; '.join(beside)})" if beside else ""), file=sys.stderr)
    if why_not.also:
        print(
            Text("every one of them then breaks {ids}: repair these first", ids=", ".join(why_not.also)),
            file=sys.stderr,
        )
    if why_not.useless:
        print(Text("No help alone: {ways}.", ways=", ".join(map(str, why_not.useless))), file=sys.stderr)
    return 3
