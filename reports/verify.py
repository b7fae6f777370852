# SPDX-License-Identifier: Apache-2.0
"""Whether a report still says what its design gives: the attached design is solved again, and the pages are set again.

What is attached says how: one design is a report, two are a comparison.
"""

import hashlib
import io
import json
import logging
import re
from dataclasses import dataclass, replace
from typing import Any

from pypdf import PdfReader
from pypdf.errors import DependencyError, PyPdfError

from calc.compare import SAME, compare, relative, size_of_nothing
from calc.design_file import design, parse
from calc.languages import LANGUAGES
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.solve import Results, solve
from calc.version import VERSION

from .attach import NAME, PAIR, RESULTS, pair_bytes, results_bytes
from .comparison import render as render_comparison
from .context import DEPTHS
from .pdf_diff import Difference, about, annotations, attachments, pages, signs
from .report import render

logging.getLogger("pypdf").setLevel(logging.CRITICAL)  # what it finds wrong with a file is said once, by the error
UNREADABLE = (
    PyPdfError, DependencyError, NotImplementedError, ValueError, OSError, KeyError, IndexError, TypeError, AttributeError,
    RecursionError, AssertionError,
)  # what a damaged or forged file makes the reader raise  # fmt: skip
KEYWORD = re.compile(r"(\w+):([0-9a-z]+)")
PARTS = ("steps", "checks", "values")  # of the results inside a report


@dataclass(frozen=True)
class Verification:
    """`changed`: the attachments that are not those which the report was written with.  `version`: of the program that wrote it.

    `same_bytes`: the file is, byte for byte, what this program writes.  `signed`: the pages that carry the field of a signature; what
    that shows is not the report's, and one that covers what is printed is a difference.
    """

    design: str
    version: str
    changed: tuple[str, ...]
    differences: tuple[Difference, ...]
    same_bytes: bool
    signed: tuple[int, ...] = ()

    @property
    def same_version(self) -> bool:
        return self.version == VERSION

    @property
    def kept(self) -> bool:
        """Whether everything is as the program writes it, whatever fields of signatures there are that cover none of it."""
        return not self.changed and not self.differences

    @property
    def identical(self) -> bool:
        return self.kept and not self.signed


def verify(raw: bytes, place: str) -> Verification:
    """Solve the design that is attached to a report, or the two of a comparison, again, and compare values, verdicts and pages.

    `place`: the name of the file, for messages.  A report of another version is compared in its texts, not in how they are drawn.
    Raises BadInput for a file that is no report of this program, or whose design this version does not accept.
    """
    reader, said, attached = _read(raw, place)
    made = (_comparison if "other" in said else _report)(place, said, attached)
    differences = list(made.differences)
    signed: list[int] = []
    if raw != made.raw:
        try:
            fresh = PdfReader(io.BytesIO(made.raw))
            differences += [*about(reader, fresh, said["version"]), *pages(reader, fresh, said["version"])]
            signed = [n for n, page in enumerate(reader.pages, 1) if any(map(signs, annotations(page)))]
        except UNREADABLE as error:
            raise _refused(place, Text("has pages that can not be read ({error}); the report was damaged", error=str(error))) from None
    return Verification(made.name, said["version"], tuple(made.changed), tuple(differences), raw == made.raw, tuple(signed))


@dataclass(frozen=True)
class _Again:
    """What the attachments give: the document set again, and how what it was written with differs from what it gives now."""

    name: str
    changed: list[str]
    differences: list[Difference]
    raw: bytes


def _report(place: str, said: dict[str, str], attached: dict[str, list[bytes]]) -> _Again:
    """The report of one design."""
    _demand(place, attached, (NAME, RESULTS))
    first = _one_with(attached[NAME], said["sha256"])
    document = parse(first, f"{place}: {NAME}")
    made = design(document)
    wanted = {NAME: said["sha256"], RESULTS: said["results"]}
    if name := made.control.logo:
        if name not in attached:
            raise _refused(place, Text("has no attachment {names}, the logo of its design", names=name))
        wanted[name] = said.get("logo", "")
    changed = _changed(attached, wanted)
    results = solve(made)
    try:
        before = json.loads(attached[RESULTS][0])
        differences = _values(before, json.loads(results_bytes(results)), results)
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise _unread(place) from None
    picture = _one_with(attached[name], wanted[name]) if name else None
    again = render(document, results, first, depth=said["depth"], lang=said["lang"], logo_file=picture)
    return _Again(results.design.name, changed, differences, again)


def _comparison(place: str, said: dict[str, str], attached: dict[str, list[bytes]]) -> _Again:
    """The comparison of two designs."""
    _demand(place, attached, (*PAIR, RESULTS))
    wanted = dict(zip((*PAIR, RESULTS), (said["sha256"], said["other"], said["results"])))
    documents = [parse(_one_with(attached[name], wanted[name]), f"{place}: {name}") for name in PAIR]
    first, second = ((document, solve(design(document))) for document in documents)
    try:
        before = json.loads(attached[RESULTS][0])
        names = (str(before["names"][0]), str(before["names"][1]))
        now = json.loads(pair_bytes(names, (first[1], second[1])))
        both = [_values(before[side], now[side], results) for side, (_, results) in zip("ab", (first, second))]
    except UNREADABLE:
        raise _unread(place) from None
    differences = [replace(one, what=f"{name}: {one.what}") for name, found in zip(PAIR, both) for one in found]
    compared = compare(first[0].data, second[0].data, first[1], second[1])
    again = render_comparison(first, second, compared, names, lang=said["lang"], everything=said["depth"] == "audit")
    return _Again(f"{first[1].design.name} – {second[1].design.name}", _changed(attached, wanted), differences, again)


def _demand(place: str, attached: dict[str, list[bytes]], names: tuple[str, ...]) -> None:
    if missing := [name for name in names if name not in attached]:
        raise _refused(
            place, Text("has no attachment {names}; a report of this program has all of them", names=Text(" and none ").join(missing))
        )


def _changed(attached: dict[str, list[bytes]], wanted: dict[str, str]) -> list[str]:
    """The attachments that are not those which the document was written with."""
    found = [name for name, sum in wanted.items() if {hashlib.sha256(one).hexdigest() for one in attached[name]} != {sum}]
    return found + [name for name in attached if name not in wanted]


def _read(raw: bytes, place: str) -> tuple[PdfReader, dict[str, str], dict[str, list[bytes]]]:
    """The document, what it says about itself, and the files inside it."""
    try:
        reader = PdfReader(io.BytesIO(raw))
        if reader.is_encrypted:
            raise _refused(place, Text("is encrypted; give the report as it was written"))
        keywords = str(reader.metadata.keywords or "") if reader.metadata is not None else ""
        attached = attachments(reader)
    except UNREADABLE as error:
        raise _refused(
            place, Text("can not be read as a PDF ({error}); give a report that `contralbero report` wrote", error=str(error))
        ) from None
    said = dict(reversed(KEYWORD.findall(keywords)))  # of one that stands twice the first
    version = re.match(r"Contralbero (\S+?)(?:,|$)", keywords)
    known = said.get("depth") in DEPTHS and said.get("lang") in LANGUAGES and {"sha256", "results"} <= set(said)
    if version is None or not known:
        raise _refused(place, Text("is no report of this program, or was written before reports could be verified; write it anew"))
    return reader, {**said, "version": version[1]}, attached


def _one_with(files: list[bytes], sum: str) -> bytes:
    """Of the files of one name that which the report was written with; where there is none the first."""
    return next((one for one in files if hashlib.sha256(one).hexdigest() == sum), files[0])


def _unread(place: str) -> BadInput:
    return _refused(place, Text("has an attachment {name} that can not be read; the report was damaged", name=RESULTS))


def _refused(place: str, reason: Text) -> BadInput:
    return BadInput(place, [InputError(0, "", "", reason)])


def _values(before: dict[str, Any], now: dict[str, Any], results: Results) -> list[Difference]:
    """What differs by more than rounding, in the order of the report; and what is only on one side."""
    found = []
    floors = {o.key: size_of_nothing((v.unit, v.shown) for v in o.values()) for o in results.outcomes.values()}
    units = {v.id: v.unit for o in results.outcomes.values() for v in o.values()}
    if more := sorted(set(before) - set(PARTS)):
        found.append(Difference(f"the attachment {RESULTS}", ", ".join(more), "nothing of that name"))
    for part in PARTS:
        what = part.removesuffix("s")
        for id in dict.fromkeys([*before[part], *now[part]]):
            was, is_now = (side[part].get(id, "–") for side in (before, now))
            floor = floors.get(id.partition(".")[0], {}).get(units.get(id, ""), 0.0)
            if was != is_now and not _near(was, is_now, floor):
                found.append(Difference(f"{what} {id}", *("no number" if x is None else str(x) for x in (was, is_now))))
    return found


def _near(a: Any, b: Any, floor: float) -> bool:
    return isinstance(a, float) and isinstance(b, float) and relative(a, b, floor) <= SAME
