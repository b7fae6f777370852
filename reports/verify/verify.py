# SPDX-License-Identifier: Apache-2.0
"""Whether a report still says what its design gives: the attached design is solved again, and the pages are set again.

Identical is only what has the same bytes; whatever else a file may be is another verdict.  What is attached says how
the pages are set: one design is a report, two are a comparison."""

from __future__ import annotations

import hashlib
import json
import re
from dataclasses import dataclass, replace
from enum import Enum
from typing import Any

from calc.design.toml_file import design, parse
from calc.locale import LANGUAGES
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.sheet.version import VERSION
from calc.solve import Results, solve
from calc.studies.compare import SAME, compare, relative, size_of_nothing

from ..comparison import render as render_comparison
from ..context import DEPTHS
from ..pdf.attach import FRONT, NAME, PAIR, RESULTS, pair_bytes, results_bytes
from ..report import render
from .difference import Difference, about, attachments, covered, page_references, pages, printed
from .pdf_file import Malformed, Pdf, demand_tables, words
from .signature import fields

KEYWORD = re.compile(r"(\w+):([0-9a-z]+)")
PARTS = ("steps", "checks", "values")  # of the results inside a report
# what results of any shape raise
BROKEN = (ValueError, KeyError, TypeError, AttributeError, IndexError, RecursionError)


class Verdict(Enum):
    """What a report is; only the first two speak for it."""

    IDENTICAL = "identical"  # byte for byte what this program writes
    SIGNED = "signed"  # that, and after it nothing but fields of signatures, which cover nothing of it
    COVERED = "covered"  # that, but a field covers something that is printed
    OTHER_VERSION = "another version"  # of the program has written it; its texts and values are the same
    SAVED_ANEW = "saved anew"  # by another program: other bytes, in which nothing different was found
    DIFFERS = "differs"


@dataclass(frozen=True)
class Verification:
    """`changed`: the attachments that are not those which the report was written with.  `version`: of the program that
    wrote it.

    `signed`: the pages that carry the field of a signature; what that shows is not the report's.  `front`: it says what
    a front says that is attached to it, and nobody has searched again for that."""

    design: str
    version: str
    verdict: Verdict
    changed: tuple[str, ...] = ()
    differences: tuple[Difference, ...] = ()
    signed: tuple[int, ...] = ()
    front: bool = False

    @property
    def identical(self) -> bool:
        return self.verdict is Verdict.IDENTICAL


def verify(raw: bytes, place: str) -> Verification:
    """Solve the design that is attached to a report, or the two of a comparison, again, and compare it with the report
    that they give.

    `place`: the name of the file, for messages.  Raises BadInput for a file that is no report of this program, or whose
    design this version does not accept."""
    pdf, provenance, attached = _read(raw, place)
    return replace(_verified(raw, place, pdf, provenance, attached), front="front" in provenance)


def _verified(
    raw: bytes, place: str, pdf: Pdf, provenance: dict[str, str], attached: dict[str, list[bytes]]
) -> Verification:
    again = (_comparison if "other" in provenance else _report)(place, provenance, attached)
    version = provenance["version"]
    if raw == again.raw:
        return Verification(again.name, version, Verdict.IDENTICAL)
    differences = list(again.differences)
    fresh = Pdf(again.raw)
    if raw.startswith(again.raw):
        try:
            return _signed(again, fresh, raw, version)
        except Malformed as error:
            differences.append(
                Difference("what was appended to the report", str(error), "nothing, or fields of signatures alone")
            )
    try:
        differences += [*about(pdf, fresh, version), *pages(pdf, fresh, version)]
    except Malformed as error:
        raise _unreadable(place, error) from None
    verdict = Verdict.SAVED_ANEW if version == VERSION else Verdict.OTHER_VERSION
    if again.changed or differences:
        verdict = Verdict.DIFFERS
    return Verification(again.name, version, verdict, tuple(again.changed), tuple(differences))


def is_report(raw: bytes) -> bool:
    """Whether a file is a document of this program as it writes them, to which nothing was appended, no signature
    either."""
    try:
        pdf, *_ = _read(raw, "")
    except BadInput:
        return False
    return len(pdf.sections) == 1


def _signed(again: _Again, fresh: Pdf, raw: bytes, version: str) -> Verification:
    """A report to which fields of signatures were appended.  Raises Malformed for anything else."""
    sheets = page_references(fresh)
    laid = fields(again.raw, raw, sheets)
    under = {n: list(printed(fresh, sheets[n - 1])) for n, _ in laid}
    passages = [(n, covered(place, under[n])) for n, place in laid]
    hidden = tuple(
        Difference(f"page {n}, under the field of a signature", "covered", f"“{text}”") for n, text in passages if text
    )
    numbers = tuple(sorted({n for n, _ in passages}))
    return Verification(
        again.name, version, Verdict.COVERED if hidden else Verdict.SIGNED, differences=hidden, signed=numbers
    )


@dataclass(frozen=True)
class _Again:
    """What the attachments give: the document set again, and how what it was written with differs from what it gives
    now."""

    name: str
    changed: list[str]
    differences: list[Difference]
    raw: bytes


def _report(place: str, provenance: dict[str, str], attached: dict[str, list[bytes]]) -> _Again:
    """The report of one design."""
    _demand(place, attached, (NAME, RESULTS))
    first = _one_with(attached[NAME], provenance["sha256"])
    document = parse(first, f"{place}: {NAME}")
    attached_design = design(document)
    wanted = {NAME: provenance["sha256"], RESULTS: provenance["results"]}
    if name := attached_design.control.logo:
        if name not in attached:
            raise _refused(place, Text("has no attachment {names}, the logo of its design", names=name))
        wanted[name] = provenance.get("logo", "")
    front = None
    if "front" in provenance:
        _demand(place, attached, (FRONT,))
        wanted[FRONT] = provenance["front"]
        front = _one_with(attached[FRONT], provenance["front"])
    changed = _changed(attached, wanted)
    results = solve(attached_design)
    try:
        before = json.loads(attached[RESULTS][0])
        differences = _values(before, json.loads(results_bytes(results)), results)
    except BROKEN:
        raise _unread(place) from None
    picture = _one_with(attached[name], wanted[name]) if name else None
    again = render(
        document, results, first, depth=provenance["depth"], lang=provenance["lang"], logo_file=picture, front=front
    )
    return _Again(results.design.name, changed, differences, again)


def _comparison(place: str, provenance: dict[str, str], attached: dict[str, list[bytes]]) -> _Again:
    """The comparison of two designs."""
    _demand(place, attached, (*PAIR, RESULTS))
    wanted = dict(zip((*PAIR, RESULTS), (provenance["sha256"], provenance["other"], provenance["results"])))
    documents = [parse(_one_with(attached[name], wanted[name]), f"{place}: {name}") for name in PAIR]
    first, second = ((document, solve(design(document))) for document in documents)
    try:
        before = json.loads(attached[RESULTS][0])
        names = (str(before["names"][0]), str(before["names"][1]))
        now = json.loads(pair_bytes(names, (first[1], second[1])))
        both = [_values(before[side], now[side], results) for side, (_, results) in zip("ab", (first, second))]
    except BROKEN:
        raise _unread(place) from None
    differences = [
        replace(difference, what=f"{name}: {difference.what}")
        for name, of_side in zip(PAIR, both)
        for difference in of_side
    ]
    compared = compare(first[0].data, second[0].data, first[1], second[1])
    again = render_comparison(
        first, second, compared, names, lang=provenance["lang"], everything=provenance["depth"] == "audit"
    )
    return _Again(f"{first[1].design.name} – {second[1].design.name}", _changed(attached, wanted), differences, again)


def _demand(place: str, attached: dict[str, list[bytes]], names: tuple[str, ...]) -> None:
    if missing := [name for name in names if name not in attached]:
        raise _refused(
            place,
            Text(
                "has no attachment {names}; a report of this program has all of them",
                names=Text(" and none ").join(missing),
            ),
        )


def _changed(attached: dict[str, list[bytes]], wanted: dict[str, str]) -> list[str]:
    """The attachments that are not those which the document was written with."""
    names = [
        name for name, sum in wanted.items() if {hashlib.sha256(file).hexdigest() for file in attached[name]} != {sum}
    ]
    return names + [name for name in attached if name not in wanted]


def _read(raw: bytes, place: str) -> tuple[Pdf, dict[str, str], dict[str, list[bytes]]]:
    """The document, what it says about itself, and the files inside it."""
    try:
        pdf = Pdf(raw)
        demand_tables(pdf)
        if any("Encrypt" in section.trailer for section in pdf.sections):
            raise _refused(place, Text("is encrypted; give the report as it was written"))
        keywords = words(pdf.info.get("Keywords"))
        attached = attachments(pdf)
    except Malformed as error:
        raise _unreadable(place, error) from None
    provenance = dict(reversed(KEYWORD.findall(keywords)))  # of one that stands twice the first
    version = re.match(r"Contralbero (\S+?)(?:,|$)", keywords)
    known = (
        provenance.get("depth") in DEPTHS
        and provenance.get("lang") in LANGUAGES
        and {"sha256", "results"} <= set(provenance)
    )
    if version is None or not known:
        raise _refused(
            place, Text("is no report of this program, or was written before reports could be verified; write it anew")
        )
    return pdf, {**provenance, "version": version[1]}, attached


def _one_with(files: list[bytes], sum: str) -> bytes:
    """Of the files of one name that which the report was written with; where there is none the first."""
    return next((file for file in files if hashlib.sha256(file).hexdigest() == sum), files[0])


def _unread(place: str) -> BadInput:
    return _refused(place, Text("has an attachment {name} that can not be read; the report was damaged", name=RESULTS))


def _unreadable(place: str, error: Malformed) -> BadInput:
    return _refused(
        place,
        Text("can not be read as a PDF ({error}); give a report that `contralbero report` wrote", error=str(error)),
    )


def _refused(place: str, reason: Text) -> BadInput:
    return BadInput(place, [InputError(0, "", "", reason)])


def _values(before: dict[str, Any], now: dict[str, Any], results: Results) -> list[Difference]:
    """What differs by more than rounding, in the order of the report; and what is only on one side."""
    differences = []
    floors = {o.key: size_of_nothing((v.unit, v.shown) for v in o.values()) for o in results.outcomes.values()}
    units = {v.id: v.unit for o in results.outcomes.values() for v in o.values()}
    if more := sorted(set(before) - set(PARTS)):
        differences.append(Difference(f"the attachment {RESULTS}", ", ".join(more), "nothing of that name"))
    for part in PARTS:
        what = part.removesuffix("s")
        for id in dict.fromkeys([*before[part], *now[part]]):
            was, is_now = (side[part].get(id, "–") for side in (before, now))
            floor = floors.get(id.partition(".")[0], {}).get(units.get(id, ""), 0.0)
            if was != is_now and not _near(was, is_now, floor):
                differences.append(
                    Difference(f"{what} {id}", *("no number" if x is None else str(x) for x in (was, is_now)))
                )
    return differences


def _near(a: Any, b: Any, floor: float) -> bool:
    return isinstance(a, float) and isinstance(b, float) and relative(a, b, floor) <= SAME
