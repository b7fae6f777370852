# SPDX-License-Identifier: Apache-2.0
"""The design file and what it gave, inside the report: embedded files that any reader of PDF can take out again."""

import hashlib
import json
import math
import re
from dataclasses import dataclass
from typing import Any

from reportlab.pdfbase.pdfdoc import PDFArray, PDFDictionary, PDFInfo, PDFName, PDFStream, PDFString, PDFZCompress
from reportlab.pdfgen.canvas import Canvas

from calc.design.key_results import judged
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.solve import Results

from ..made import MADE

NAME = "design.toml"
RESULTS = "results.json"
FRONT = "front.json"
PAIR = ("a.toml", "b.toml")  # the designs of a comparison
# what a file is to the document, by its ending; any other only belongs to it
RELATIONS = {"toml": "Source", "json": "Data"}
KEYWORD = re.compile(r"(\w+):([0-9a-z][0-9a-z.+-]{0,99})")
NO_REPORT = Text("is no report of this program, or was written before reports could be verified; write it anew")
SUMS = ("sha256", "other", "results", "front", "logo")  # keywords that are the sums of files inside


def solved_values(results: Results) -> dict[str, Any]:
    """The values and verdicts of a report by their ids; what is not finite is None."""
    outcomes = results.outcomes.values()
    return {
        "steps": {o.key: o.verdict for o in outcomes},
        "checks": {check.id: judged(check) for o in outcomes for check in o.checks},
        "values": {v.id: v.shown if math.isfinite(v.shown) else None for o in outcomes for v in o.values()},
    }


def pair_values(names: tuple[str, str], a: Results, b: Results) -> dict[str, Any]:
    """The same of a comparison, with what it calls its two designs."""
    return {"names": list(names), "a": solved_values(a), "b": solved_values(b)}


def values_bytes(values: dict[str, Any]) -> bytes:
    """As JSON, the same bytes for the same results."""
    return json.dumps(_rounded(values), separators=(",", ":"), allow_nan=False).encode()


def _rounded(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _rounded(one) for key, one in value.items()}
    return nine(value) if isinstance(value, float) else value


def nine(x: float) -> float:
    """With nine digits: the last of the sixteen depend on processor and libraries, and a report does not."""
    return float(f"{x:.9g}")


def attach(canvas: Canvas, files: dict[str, tuple[bytes, str]]) -> None:
    """Embed files, each with its name, its bytes and what it is."""
    catalog, specifications = canvas._doc.Catalog, {}
    for name, (raw, description) in files.items():
        specifications[name] = _specification(canvas, name, raw, description)
    catalog.__NoDefault__ = [*catalog.__NoDefault__, "AF"]
    catalog.AF = PDFArray(list(specifications.values()))
    names = [item for name in sorted(specifications) for item in (PDFString(name), specifications[name])]
    catalog.Names = PDFDictionary({"EmbeddedFiles": PDFDictionary({"Names": PDFArray(names)})})


def _specification(canvas: Canvas, name: str, raw: bytes, description: str) -> object:
    document = canvas._doc
    sums = {"Size": len(raw), "CheckSum": PDFString(hashlib.md5(raw, usedforsecurity=False).digest(), enc="raw")}
    stream = PDFStream(
        PDFDictionary({"Type": PDFName("EmbeddedFile"), "Params": PDFDictionary(sums)}), raw, filters=[PDFZCompress]
    )
    ending = name.rpartition(".")[2].lower()
    stream.dictionary["Subtype"] = f"/{'image' if ending == 'png' else 'application'}#2F{ending}"
    file = document.Reference(stream)
    return document.Reference(
        PDFDictionary(
            {
                "Type": PDFName("Filespec"),
                "F": PDFString(name),
                "UF": PDFString(name),
                "Desc": PDFString(description),
                "AFRelationship": PDFName(RELATIONS.get(ending, "Supplement")),
                "EF": PDFDictionary({"F": file, "UF": file}),
            }
        )
    )


def keywords(program: str, **provenance: str) -> str:
    """What `verify` needs to know of a report, as its list of keywords: `Contralbero 0.1.0, depth:engineer,
    sha256:…`."""
    return ", ".join([program, *(f"{key}:{value}" for key, value in provenance.items())])


@dataclass(frozen=True)
class Inside:
    """What a document says of how it was made, by its keywords, and the files inside it; `place`: where it stands."""

    place: str
    said: dict[str, str]
    files: dict[str, list[bytes]]

    @property
    def made(self) -> dict[str, str]:
        """The versions that it was made with."""
        return {name: self.said[name] for name in MADE if name in self.said}

    def file(self, name: str, sum: str) -> bytes:
        """Of the files of a name that which it was written with; where there is none the first.  Raises BadInput."""
        if not (files := self.files.get(name)):
            raise refused(self.place, Text("has no attachment {name}; a report of this program has it", name=name))
        return next((file for file in files if sha256(file) == self.said.get(sum)), files[0])

    def solved(self) -> Any:
        """The values and verdicts that it was written with."""
        try:
            return json.loads(self.file(RESULTS, "results"))
        except (ValueError, RecursionError):
            raise self.damaged() from None

    def damaged(self) -> BadInput:
        reason = Text("has an attachment {name} that can not be read; the report was damaged", name=RESULTS)
        return refused(self.place, reason)


def inside(place: str, words: str, files: dict[str, list[bytes]]) -> Inside:
    """Of a document with these keywords and files.  Raises BadInput for one that this program has not written."""
    said = dict(reversed(KEYWORD.findall(words)))  # of one that stands twice the first
    program = re.match(r"Contralbero ([0-9a-z.+-]{1,30})(?:,|$)", words)
    read = Inside(place, {**said, "program": program[1] if program else ""}, files)
    if program is None or not {"depth", "lang", "sha256", "results"} <= set(said):
        raise refused(place, NO_REPORT)
    return read


def refused(place: str, reason: Text) -> BadInput:
    """A file that is not what it was asked to be."""
    return BadInput(place, [InputError(0, "", "", reason)])


def sha256(file: bytes) -> str:
    return hashlib.sha256(file).hexdigest()


class Undated(PDFInfo):  # type: ignore[misc]
    """The document's own description, without the moment at which it was written: the same input gives the same
    bytes."""

    def format(self, document: object) -> object:
        entries = {
            "Title": self.title,
            "Author": self.author,
            "Subject": self.subject,
            "Keywords": self.keywords,
            "Creator": self.creator,
            "Producer": self.producer,
        }
        return PDFDictionary({k: PDFString(v) for k, v in entries.items() if v}).format(document)


def describe(canvas: Canvas, *, title: str, author: str, subject: str, keywords: str, program: str) -> None:
    about = Undated()
    about.title, about.author, about.subject, about.keywords, about.creator = title, author, subject, keywords, program
    about.invariant = True
    canvas._doc.info = about
