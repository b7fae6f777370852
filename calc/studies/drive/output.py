# SPDX-License-Identifier: Apache-2.0
"""The front as a table, as CSV and as JSON, and the problem in words: what is varied, what follows, what must hold."""

import csv
import io
import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from ...countershaft.rows import BearingRow, called
from ...sheet.step import Table
from ...sheet.text import COMMA, Amount, Name, Text
from ...sheet.version import VERSION
from .problem import FITS, LIMITS, OIL, SUPPLY_KEY, Problem
from .search import FrontFound, key
from .solved_drive import Whole

LABELS = {
    "power": Text("power at the crank"),
    "mass": Text("shaft and wheels"),
    "seat": Text("largest seat"),
    "price": Text("price of a piece"),
    "margin": Text("least margin"),
}
UNIT = {"power": "W", "mass": "kg", "seat": "mm", "price": "€", "margin": "%"}
CHOICES = {
    OIL: Text("oil"),
    SUPPLY_KEY: Text("supply"),
    FITS: Text("fits"),
}
END = "⊣"  # a size at the end of its range: beyond it may be better


def proof(front: FrontFound) -> Text:
    """What the front is the front of."""
    return proof_of(front.proved, front.table.combinations, front.done, len(front.problem.classes))


def proof_of(proved: bool, count: int, done: int, classes: int) -> Text:
    if done < classes:
        return Text(
            "Not exhaustive: the search was stopped at {done} of {classes} classes, and better drives may exist.",
            done=done,
            classes=classes,
        )
    if not proved:
        return Text("A search without proof (NSGA-II over {n} whole solutions): better drives may exist.", n=count)
    return Text("Exhaustive over the stated ranges and steps; nothing is said of what lies beyond or between them.")


def label(problem: Problem, name: str) -> Text:
    """The name of an objective: over a duty cycle the power is a mean."""
    return Text("mean power over the duty cycle") if name == "power" and problem.cycle else LABELS[name]


def table(front: FrontFound, drives: Iterable[int] | None = None) -> Table:
    """The drives by number; columns that are the same in all are left out."""
    problem, keys = front.problem, front.problem.keys
    words = {keys.material: Text("material"), **CHOICES}
    varied = [name for name in problem.choices if len({str(drive.sized.choices[name]) for drive in front.drives}) > 1]
    surfaces = len({drive.sized.surface for drive in front.drives}) > 1
    columns = [(Text("no."), ""), *((label(problem, name), UNIT[name]) for name in problem.objectives)]
    columns += [(words.get(name, Text("{key}", key=Name(name))), "") for name in varied]
    columns += [(Text("Ra"), "µm")] if surfaces else []
    columns += [(Text("{row} Ø×l/g", row=called(place)), "mm/µm") for place in keys.places]
    columns += [(Text("core"), "mm"), (Text("open"), "")]
    rows = []
    for n, drive in enumerate(front.drives, 1):
        if drives is not None and n not in drives:
            continue
        s = drive.sized
        cells: list[str | float | None] = [
            float(n),
            *(round(drive.objectives[name], DIGITS[name]) for name in problem.objectives),
        ]
        cells += [Name(word(s.choices[name])) for name in varied]
        cells += [Name(_surfaces(problem, s.surface))] if surfaces else []
        cells += [Name(_size(problem, s, place)) for place in keys.places]
        cells += [Name(f"{s.core:g}{END if keys.core in at_end(problem, drive) else ''}"), float(drive.open)]
        rows.append(tuple(cells))
    note = Text("{proof} Every row was solved whole, and no limit of it fails.", proof=proof(front))
    if any(at_end(problem, drive) for drive in front.drives):
        note = Text("{note} {end}: at the end of its range, beyond may be better.", note=note, end=Name(END))
    return Table("drives", Text("Front of the whole drive"), tuple(columns), tuple(rows), note)


DIGITS = {"power": 1, "mass": 3, "seat": 2, "price": 2, "margin": 1}


def word(choice: object) -> str:
    return "/".join(map(str, choice)) if isinstance(choice, (list, tuple)) else str(choice)


def _size(problem: Problem, s: Any, place: str) -> str:
    end = END if _ends(problem, {problem.keys.of_bearing(place, BearingRow.diameter): s.diameter[place]}) else ""
    if place in problem.rolling:
        return next(row.size_words() for row in problem.base.rows if row.name == place)
    return f"{s.diameter[place]:g}{end}×{s.length[place]:g}/{s.clearance[place]:g}"


def _surfaces(problem: Problem, pair: tuple[float, float] | None) -> str:
    """Journal and seat; as designed, where both bearings have the same."""
    if pair is None:
        fed = (row for row in problem.base.rows if row.fed())
        pairs = {(row.journal_roughness * 1e6, row.housing_roughness * 1e6) for row in fed}
        pair = pairs.pop() if len(pairs) == 1 else None
    return "/".join(f"{x:g}" for x in pair) if pair is not None else "–"


def at_end(problem: Problem, drive: Whole) -> list[str]:
    """The keys whose range ends at this drive, where the range is a rule or the user's and no limit of the design."""
    keys = problem.keys
    diameters = {keys.of_bearing(place, BearingRow.diameter): d for place, d in drive.sized.diameter.items()}
    return _ends(problem, {keys.core: drive.sized.core, **diameters})


def _ends(problem: Problem, sizes: Mapping[str, float]) -> list[str]:
    ended = []
    for name, number in sizes.items():
        values = problem.sizes[name]
        if values is None or len(values) < 2:
            continue
        low, high = problem.bounded[name]
        if (number <= values[0] + 1e-9 and not low) or (number >= values[-1] - 1e-9 and not high):
            ended.append(name)
    return ended


# --- the files


def csv_text(front: FrontFound) -> str:
    """front.csv: what it is the front of, then a row for each drive, units in the head."""
    problem, out = front.problem, io.StringIO()
    for line in said(problem):
        out.write(f"# {line}\n")
    out.write(f"# {proof(front)}\n# {stood(front)}\n")
    writer = csv.writer(out, lineterminator="\n")
    keys = list(dict.fromkeys(k for drive in front.drives for k in drive.changes))
    writer.writerow(["no", *(f"{name} [{UNIT[name]}]" for name in problem.objectives), "open", "at_end", *keys])
    for n, drive in enumerate(front.drives, 1):
        row = [f"{drive.objectives[name]:.9g}" for name in problem.objectives]
        values = ["" if drive.changes.get(k) is None else drive.changes[k] for k in keys]
        writer.writerow([n, *row, drive.open, " ".join(at_end(problem, drive)), *values])
    return out.getvalue()


def json_text(front: FrontFound) -> str:
    """front.json: the problem and the drives, with the keys that make each of them."""
    problem = front.problem
    about = {
        "schema": 1,
        "program": VERSION,
        "key": key(problem),
        "design": problem.start.sha256,
        "proof": str(proof(front)),
        "proved": front.proved and front.whole,
        "classes": len(problem.classes),
        "classes_done": front.done,
        "combinations": front.table.combinations,
        "front_rows": len(front.table),
        "objectives": {name: UNIT[name] for name in problem.objectives},
        "sizes_mm": {name: list(values) if values is not None else None for name, values in problem.sizes.items()},
        "choices": {name: list(values) for name, values in problem.choices.items()},
        "surfaces_um": [list(pair) if pair else None for pair in problem.surfaces],
        "margins": list(problem.margins),
        "most": problem.most,
        "limits": list(problem.limits),
        "waived": list(problem.waived),
        "said": [str(line) for line in problem.said],
        "ties": {name: str(why) for name, why in problem.keys.tied.items()},
        "refused": [[n, str(why)] for n, why in front.table.refused],
        "dropped": [{"changes": drive.changes, "broken": list(drive.broken)} for drive in front.dropped],
    }
    about["drives"] = [
        {
            "no": n,
            "objectives": drive.objectives,
            "open": drive.open,
            "at_end": at_end(problem, drive),
            "changes": drive.changes,
        }
        for n, drive in enumerate(front.drives, 1)
    ]
    return json.dumps(about, ensure_ascii=False, indent=1, default=str) + "\n"


def stood(front: FrontFound) -> Text:
    """How far the search came."""
    done, classes = front.done, len(front.problem.classes)
    if not front.proved:
        return Text(
            "{n} drives solved whole, {drives} of their front shown",
            n=front.table.combinations,
            drives=len(front.drives),
        )
    words = Text(
        "{n} combinations in {classes} classes, front of {rows}, {drives} of them solved whole",
        n=power_of_ten(front.table.combinations),
        classes=done,
        rows=len(front.table),
        drives=len(front.drives),
    )
    return (
        words
        if done == classes
        else Text("{words}; stopped at {done} of {classes} classes", words=words, done=done, classes=classes)
    )


def power_of_ten(count: int) -> Name:
    if count < 100_000:
        return Name(str(count))
    digits = len(str(count)) - 1
    return Name(f"{count / 10**digits:.1f}·10{str(digits).translate(str.maketrans('0123456789', '⁰¹²³⁴⁵⁶⁷⁸⁹'))}")


# --- the problem in words


def said(problem: Problem) -> list[Text]:
    """The ranges, ties, requirements and objectives, a line each."""
    lines = [Text("objectives: {names}", names=COMMA.join([_objective(problem, name) for name in problem.objectives]))]
    lines += ranges(problem.sizes, problem.choices)
    if len(problem.surfaces) > 1 or problem.surfaces[0] is not None:
        pairs = Name(
            ", ".join("/".join(f"{x:g}" for x in pair) if pair else "as designed" for pair in problem.surfaces)
        )
        lines.append(Text("surfaces, journal and seat: {pairs} µm", pairs=pairs))
    lines += [Text("{key}: {why}", key=Name(name), why=why) for name, why in problem.keys.tied.items()]
    more = [limit for limit in problem.limits if limit not in LIMITS]
    lines.append(
        Text(
            "asked: that no limit fails, and that these hold: {ids}",
            ids=Name(", ".join(limit for limit in (*LIMITS, *more) if problem.binds(limit))),
        )
    )
    return [*lines, *problem.said]


def ranges(sizes: Mapping[str, Sequence[float] | None], choices: Mapping[str, Sequence[object]]) -> list[Text]:
    """What every size and choice may be."""
    lines = []
    for name, values in sizes.items():
        if values is None:
            lines.append(Text("{key}: in steps of 0.5 mm, by l/d and the room that the sectors leave", key=Name(name)))
        elif len(values) > 1:
            lines.append(
                Text(
                    "{key}: {n} values from {low} to {high} mm",
                    key=Name(name),
                    n=len(values),
                    low=Amount(values[0], form="g"),
                    high=Amount(values[-1], form="g"),
                )
            )
        else:
            lines.append(Text("{key}: {value}", key=Name(name), value=Name(", ".join(f"{x:g}" for x in values) or "–")))
    return lines + [
        Text("{key}: {values}", key=Name(name), values=Name(", ".join(map(word, values))))
        for name, values in choices.items()
    ]


def _objective(problem: Problem, name: str) -> Text:
    bound = problem.most.get(name)
    if not bound:
        return label(problem, name)
    amount = Amount(bound, UNIT[name], form="g")
    if name == "margin":
        return Text("{name} of {bound} at least", name=label(problem, name), bound=amount)
    return Text("{name} of {bound} at most", name=label(problem, name), bound=amount)
