# SPDX-License-Identifier: Apache-2.0
"""What a file is to the design inside it: the report that this program writes from it, that with signatures, that with
something else behind it, or not what this program writes.

Only bytes speak for a report.  What is attached says how its pages are set: one design is a report, two are a
comparison."""

from __future__ import annotations

import hashlib
import io
import json
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from pypdf import PdfReader

from calc.design.toml_file import design, parse
from calc.locale import LANGUAGES
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import EMPTY, Text
from calc.solve import Results, solve
from calc.studies.compare import compare, size_of_nothing

from ..comparison import render as render_comparison
from ..context import DEPTHS
from ..made import MADE, versions
from ..pdf.attach import FRONT, NAME, PAIR, RESULTS, nine, pair_bytes, results_bytes
from ..report import render
from .signature import NotSigned, signers

END = b"\n%%EOF\n"  # with which this program ends a file
KEYWORD = re.compile(r"(\w+):([0-9a-z][0-9a-z.+-]{0,99})")
PARTS = ("steps", "checks", "values")  # of the results inside a report
SAME = 1e-9  # relative: numbers that differ by less are the same, whatever computed them
NOTHING = "–"


class Verdict(Enum):
    """What a file is; the first two speak for what is printed in it."""

    IDENTICAL = "identical"  # byte for byte what this program writes
    SIGNED = "signed"  # that, and behind it signatures in the fields that it foresees, and nothing else
    APPENDED = "appended to"  # that, and behind it something else
    NOT_AS_WRITTEN = "not as written"  # other bytes; what is attached is compared, its pages are not looked at


@dataclass(frozen=True)
class Difference:
    """A value or a verdict that is another one now."""

    what: str
    was: str
    now: str


@dataclass(frozen=True)
class Verification:
    """`made`: the versions that the report was made with, by name.  `why`: it is not signed.  `original`: the part of
    the file that is this program's, where something stands behind it.  `changed`: attachments that are not those which
    the report says that it was written with.  `compared`: how many values, verdicts and files were compared.  `front`:
    it says what a front says that is attached to it, and nobody has searched again for that."""

    design: str
    made: dict[str, str]
    verdict: Verdict
    signers: tuple[Text, ...] = ()
    why: Text = EMPTY
    original: bytes = b""
    appended: int = 0
    changed: tuple[str, ...] = ()
    differences: tuple[Difference, ...] = ()
    compared: int = 0
    front: bool = False

    @property
    def other_versions(self) -> dict[str, tuple[str, str]]:
        """Of what is another version here: that of the report, and that of here."""
        here = versions()
        return {name: (self.made[name], here[name]) for name in MADE if self.made.get(name, "") not in ("", here[name])}


@dataclass(frozen=True)
class _Read:
    """A file: what it says of how it was made, and the files inside it."""

    said: dict[str, str]
    attached: dict[str, list[bytes]]

    @property
    def made(self) -> dict[str, str]:
        return {name: self.said[name] for name in MADE if name in self.said}


def verify(raw: bytes, place: str) -> Verification:
    """Solve the design that is attached to a report, or the two of a comparison, again, write it once more, and say
    what the file is.

    `place`: its name, for messages.  Raises BadInput for a file that is no report of this program, or whose design
    this version does not accept."""
    of_report = again = None
    for end in _ends(raw):  # what this program has written ends here, if it has
        try:
            of_report = _read(raw[:end], place)
            again = _again(place, of_report)
        except BadInput:
            continue
        if again.raw == raw[:end]:
            return _as_written(raw, again, of_report)
    of_file = _read(raw, place)
    if again is None or of_file != of_report:
        again = _again(place, of_file)
    return _compared(again, of_file)


def is_report(raw: bytes) -> bool:
    """Whether a file is a document of this program as it writes them, to which nothing was appended, no signature
    either."""
    try:
        _read(raw, "")
    except BadInput:
        return False
    return list(_ends(raw)) == [len(raw)]


def _ends(raw: bytes) -> Iterator[int]:
    """Where the part of a file may end that this program has written: the first two places that look like it."""
    for place in [match.end() for match in re.finditer(re.escape(END), raw)][:2]:
        if raw[:place].rpartition(b"startxref\n")[2].removesuffix(END).isdigit():
            yield place


def _as_written(raw: bytes, again: _Again, of_report: _Read) -> Verification:
    found = Verification(again.name, of_report.made, Verdict.IDENTICAL, front="front" in of_report.said)
    if raw == again.raw:
        return found
    more = dict(original=again.raw, appended=len(raw) - len(again.raw))
    try:
        return _with(found, verdict=Verdict.SIGNED, signers=tuple(signers(again.raw, raw)), **more)
    except NotSigned as no:
        return _with(found, verdict=Verdict.APPENDED, why=no.why, **more)


def _with(found: Verification, **fields: Any) -> Verification:
    return Verification(**{**vars(found), **fields})


def _compared(again: _Again, of_file: _Read) -> Verification:
    """Of a file that this program does not write so: what is attached beside what it gives now."""
    changed = tuple(
        name
        for name, wanted in again.wanted.items()
        if {hashlib.sha256(file).hexdigest() for file in of_file.attached[name]} != {wanted}
    )
    more = tuple(name for name in of_file.attached if name not in again.wanted)
    count, differences = again.differences()
    return Verification(
        again.name,
        of_file.made,
        Verdict.NOT_AS_WRITTEN,
        changed=changed + more,
        differences=tuple(differences),
        compared=count + len(again.wanted),
        front="front" in of_file.said,
    )


@dataclass(frozen=True)
class _Again:
    """What the attachments give: the document written again, the sums that its files shall have, and how what it was
    written with differs from what it gives now."""

    name: str
    raw: bytes
    wanted: dict[str, str]
    differences: Callable[[], tuple[int, list[Difference]]] = field(repr=False)


def _again(place: str, of_file: _Read) -> _Again:
    try:
        return (_comparison if "other" in of_file.said else _report)(place, of_file)
    except (RecursionError, MemoryError) as error:
        raise _refused(place, Text("can not be solved again ({error})", error=type(error).__name__)) from None


def _report(place: str, of_file: _Read) -> _Again:
    """The report of one design."""
    said, attached = of_file.said, of_file.attached
    _demand(place, attached, (NAME, RESULTS))
    raw = _one_with(attached[NAME], said["sha256"])
    document = parse(raw, f"{place}: {NAME}")
    attached_design = design(document)
    wanted = {NAME: said["sha256"], RESULTS: said["results"]}
    picture = front = None
    if name := attached_design.control.logo:
        _demand(place, attached, (name,))
        wanted[name] = said.get("logo", "")
        picture = _one_with(attached[name], wanted[name])
    if "front" in said:
        _demand(place, attached, (FRONT,))
        wanted[FRONT] = said["front"]
        front = _one_with(attached[FRONT], said["front"])
    results = solve(attached_design)
    how = dict(depth=said["depth"], lang=said["lang"], logo_file=picture, front=front, made=of_file.made or None)
    before, now = _one_with(attached[RESULTS], said["results"]), results_bytes(results)
    return _Again(
        results.design.name,
        render(document, results, raw, **how),  # type: ignore[arg-type]
        wanted,
        lambda: _values(place, before, now, {"": results}),
    )


def _comparison(place: str, of_file: _Read) -> _Again:
    """The comparison of two designs."""
    said, attached = of_file.said, of_file.attached
    _demand(place, attached, (*PAIR, RESULTS))
    wanted = dict(zip((*PAIR, RESULTS), (said["sha256"], said["other"], said["results"])))
    documents = [parse(_one_with(attached[name], wanted[name]), f"{place}: {name}") for name in PAIR]
    first, second = ((document, solve(design(document))) for document in documents)
    before = _one_with(attached[RESULTS], wanted[RESULTS])
    names = _names(place, before)
    now = pair_bytes(names, (first[1], second[1]))
    written = render_comparison(
        first,
        second,
        compare(first[0].data, second[0].data, first[1], second[1]),
        names,
        lang=said["lang"],
        everything=said["depth"] == "audit",
        made=of_file.made or None,
    )
    both = {"a": first[1], "b": second[1]}
    name = f"{first[1].design.name} – {second[1].design.name}"
    return _Again(name, written, wanted, lambda: _values(place, before, now, both))


# --- what is inside a file


def _read(raw: bytes, place: str) -> _Read:
    """What a document says about itself, and the files inside it.  Raises BadInput for one that is no report."""
    try:
        reader = PdfReader(io.BytesIO(raw))
        if reader.is_encrypted:
            raise _refused(place, Text("is encrypted; give the report as it was written"))
        keywords = str(reader.metadata.get("/Keywords", "")) if reader.metadata is not None else ""
        attached = {str(name): [bytes(file) for file in files] for name, files in reader.attachments.items()}
    except BadInput:
        raise
    except Exception as error:  # whatever a file of a stranger does to its reader
        why = f"{type(error).__name__}: {error}"[:80]
        reason = Text("can not be read as a PDF ({why}); give a report that `contralbero report` wrote", why=why)
        raise _refused(place, reason) from None
    said = dict(reversed(KEYWORD.findall(keywords)))  # of one that stands twice the first
    version = re.match(r"Contralbero ([0-9a-z.+-]{1,30})(?:,|$)", keywords)
    known = said.get("depth") in DEPTHS and said.get("lang") in LANGUAGES and {"sha256", "results"} <= set(said)
    if version is None or not known:
        raise _refused(
            place, Text("is no report of this program, or was written before reports could be verified; write it anew")
        )
    return _Read({**said, "program": version[1]}, attached)


def _one_with(files: list[bytes], sum: str) -> bytes:
    """Of the files of one name that which the report was written with; where there is none the first."""
    return next((file for file in files if hashlib.sha256(file).hexdigest() == sum), files[0])


def _demand(place: str, attached: dict[str, list[bytes]], names: tuple[str, ...]) -> None:
    if missing := [name for name in names if not attached.get(name)]:
        names_in_words = Text(" and none ").join(missing)
        reason = Text("has no attachment {names}; a report of this program has all of them", names=names_in_words)
        raise _refused(place, reason)


def _refused(place: str, reason: Text) -> BadInput:
    return BadInput(place, [InputError(0, "", "", reason)])


# --- what differs


def _names(place: str, before: bytes) -> tuple[str, str]:
    """What a comparison calls its designs."""
    match _object(place, before).get("names"):
        case [str(one), str(other)]:
            return one, other
    raise _damaged(place)


def _object(place: str, raw: bytes) -> dict[str, Any]:
    try:
        known = json.loads(raw)
    except (ValueError, RecursionError):
        raise _damaged(place) from None
    if not isinstance(known, dict):
        raise _damaged(place)
    return known


def _damaged(place: str) -> BadInput:
    return _refused(place, Text("has an attachment {name} that can not be read; the report was damaged", name=RESULTS))


def _values(place: str, before: bytes, now: bytes, solved: dict[str, Results]) -> tuple[int, list[Difference]]:
    """How many values and verdicts there are, and those that differ by more than rounding, in the order of the
    report, with those that are only on one side."""
    was, is_now = _object(place, before), _object(place, now)
    count, differences = 0, []
    for side, results in solved.items():
        old, new = was.get(side) if side else was, is_now[side] if side else is_now
        if not isinstance(old, dict) or not all(isinstance(old.get(part), dict) for part in PARTS):
            raise _damaged(place)
        of = f"{side}.toml: " if side else ""
        floors = {o.key: size_of_nothing((v.unit, v.shown) for v in o.values()) for o in results.outcomes.values()}
        units = {v.id: v.unit for o in results.outcomes.values() for v in o.values()}
        if more := sorted(set(old) - {*PARTS, "names"}):
            differences.append(Difference(f"{of}the attachment {RESULTS}", ", ".join(more), NOTHING))
        for part in PARTS:
            for id in dict.fromkeys([*old[part], *new[part]]):
                count += 1
                a, b = (one[part].get(id, NOTHING) for one in (old, new))
                floor = floors.get(id.partition(".")[0], {}).get(units.get(id, ""), 0.0)
                if a != b and not _near(a, b, floor):
                    what = f"{of}{part.removesuffix('s')} {id}"
                    differences.append(Difference(what, *("no number" if x is None else str(x) for x in (a, b))))
    return count, differences


def _near(a: Any, b: Any, floor: float) -> bool:
    """`floor`: what is left of a sum that is zero."""
    numbers = all(isinstance(x, (int, float)) and not isinstance(x, bool) and math.isfinite(x) for x in (a, b))
    return numbers and abs(nine(a) - nine(b)) <= max(2 * SAME * max(abs(a), abs(b)), floor)
