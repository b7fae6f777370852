# SPDX-License-Identifier: Apache-2.0
"""Whether a report still says what its design gives: the attached design is solved again, and the pages are set again."""

import hashlib
import io
import json
import logging
import math
import re
from dataclasses import dataclass
from typing import Any

from pypdf import PdfReader
from pypdf.errors import PyPdfError

from calc.compare import SAME
from calc.design_file import design, parse
from calc.sheet.errors import BadInput, InputError
from calc.solve import solve
from calc.version import VERSION

from .attach import NAME, RESULTS, results_bytes
from .report import render

logging.getLogger("pypdf").setLevel(logging.CRITICAL)  # what it finds wrong with a file is said once, by the error
KEYWORD = re.compile(r"(\w+):([0-9a-z]+)")


@dataclass(frozen=True)
class Difference:
    """Something that is not as it was: a value, a verdict, the text of a page."""

    what: str
    was: str
    now: str


@dataclass(frozen=True)
class Verification:
    """`changed`: the attachments that are not those which the report was written with.  `version`: of the program that wrote it.

    `same_bytes`: the file is, byte for byte, what this program writes.
    """

    design: str
    version: str
    changed: tuple[str, ...]
    differences: tuple[Difference, ...]
    same_bytes: bool

    @property
    def same_version(self) -> bool:
        return self.version == VERSION

    @property
    def identical(self) -> bool:
        return not self.changed and not self.differences


def verify(raw: bytes, place: str) -> Verification:
    """Solve the design that is attached to a report again, and compare values, verdicts and the text of the pages.

    `place`: the name of the file, for messages.  Raises BadInput for a file that is no report of this program, or whose design this
    version does not accept.
    """
    reader, said = _read(raw, place)
    attached = {name: contents[0] for name, contents in reader.attachments.items()}
    missing = [name for name in (NAME, RESULTS) if name not in attached]
    if missing:
        raise _refused(place, f"has no attachment {' and none '.join(missing)}; a report of this program has both")
    wanted = {NAME: said["sha256"], RESULTS: said["results"]}
    changed = tuple(name for name, sum in wanted.items() if hashlib.sha256(attached[name]).hexdigest() != sum)
    document = parse(attached[NAME], f"{place}: {NAME}")
    results = solve(design(document))
    try:
        before = json.loads(attached[RESULTS])
        differences = _values(before, json.loads(results_bytes(results)))
    except (ValueError, KeyError, TypeError, AttributeError):
        raise _refused(place, f"has an attachment {RESULTS} that can not be read; the report was damaged") from None
    again = render(document, results, attached[NAME], depth=said["depth"], lang=said["lang"])
    if raw != again:
        differences += _pages(reader, PdfReader(io.BytesIO(again)))
    return Verification(results.design.name, said["version"], changed, tuple(differences), raw == again)


def _read(raw: bytes, place: str) -> tuple[PdfReader, dict[str, str]]:
    """The document, and what it says about itself."""
    try:
        reader = PdfReader(io.BytesIO(raw))
        about = reader.metadata
        keywords = str(about.keywords or "") if about is not None else ""
    except (PyPdfError, ValueError, OSError, KeyError, RecursionError) as error:
        raise _refused(place, f"can not be read as a PDF ({error}); give a report that `contralbero report` wrote") from None
    said = dict(KEYWORD.findall(keywords))
    version = re.match(r"Contralbero (\S+?)(?:,|$)", keywords)
    if version is None or not {"depth", "lang", "sha256", "results"} <= set(said):
        raise _refused(place, "is no report of this program, or was written before reports could be verified; write it anew")
    return reader, {**said, "version": version[1]}


def _refused(place: str, reason: str) -> BadInput:
    return BadInput(place, [InputError(0, "", "", reason)])


def _values(before: dict[str, Any], now: dict[str, Any]) -> list[Difference]:
    """What differs by more than rounding, in the order of the report; and what is only on one side."""
    found = []
    for part, what in (("steps", "step"), ("checks", "check"), ("values", "value")):
        for id in dict.fromkeys([*before[part], *now[part]]):
            was, is_now = (side[part].get(id, "–") for side in (before, now))
            if was != is_now and not _near(was, is_now):
                found.append(Difference(f"{what} {id}", *("no number" if x is None else str(x) for x in (was, is_now))))
    return found


def _near(a: Any, b: Any) -> bool:
    return isinstance(a, float) and isinstance(b, float) and math.isclose(a, b, rel_tol=SAME)


def _pages(before: PdfReader, now: PdfReader) -> list[Difference]:
    """The pages whose text is another one."""
    if len(before.pages) != len(now.pages):
        return [Difference("pages", str(len(before.pages)), str(len(now.pages)))]
    found = []
    for number, (old, new) in enumerate(zip(before.pages, now.pages), 1):
        was, is_now = (page.extract_text().split() for page in (old, new))
        if was != is_now:
            first = next((n for n, (a, b) in enumerate(zip(was, is_now)) if a != b), min(len(was), len(is_now)))
            found.append(Difference(f"page {number}", *(" ".join(words[max(0, first - 3) : first + 4]) for words in (was, is_now))))
    return found
