# SPDX-License-Identifier: Apache-2.0
"""The design file and what it gave, inside the report: embedded files that any reader of PDF can take out again."""

import hashlib
import json
import math
import re
import zlib
from dataclasses import dataclass
from typing import Any

from reportlab.pdfbase.pdfdoc import PDFArray, PDFDictionary, PDFInfo, PDFName, PDFStream, PDFString, PDFZCompress
from reportlab.pdfgen.canvas import Canvas

from calc.design.key_results import judged
from calc.design.limits import PDF_UNPACKED
from calc.design.model import Design
from calc.design.toml_file import Document
from calc.sheet.errors import BadInput, InputError
from calc.sheet.quantity import dotted
from calc.sheet.record import replace
from calc.sheet.text import Text
from calc.solve import Results

from ..apart import Refused
from ..made import MADE

NAME = "design.toml"
RESULTS = "results.json"
FRONT = "front.json"
PAIR = ("a.toml", "b.toml")  # the designs of a comparison
# what a file is to the document, by its ending; any other only belongs to it
RELATIONS = {"toml": "Source", "json": "Data", "csv": "Data"}
KEYWORDS = re.compile(rb"Contralbero ([0-9a-z.+-]{1,30}), (depth:[a-z]+(?:, [a-z0-9]+:[0-9a-z.+-]+)+)")
OCTAL = re.compile(rb"\\([0-3][0-7]{2})")  # as some programs write marks
# what a file looks like, by its ending
RUN = re.compile(r"\b(run([ab]?)([0-9]+))\b")  # keywords of runs
ALIKE = {"csv": rb"\A# rows used of ", "toml": rb"(?m)^\[engine\]", "json": rb"\A\{", "png": rb"\A\x89PNG"}
END = b"\n%%EOF\n"  # with which this program ends a file
STREAM = re.compile(rb"stream\r?\n")
NO_REPORT = Text("is no report of this program, or was written before reports could be verified; write it anew")


def solved_values(results: Results) -> dict[str, Any]:
    """The values and verdicts of a report by their ids; what is not finite is None."""
    outcomes = results.outcomes.values()
    checks = [check for o in outcomes for check in o.checks]
    values = [value for o in outcomes for value in o.values()]
    if results.runs is not None:
        checks, values = [*checks, *results.runs.checks], [*values, *results.runs.values]
    return {
        "steps": {o.key: o.verdict for o in outcomes},
        "checks": {check.id: judged(check) for check in checks},
        "values": {v.id: v.shown if math.isfinite(v.shown) else None for v in values},
    }


# --- runs of the bench
# The rows that are used, in the order of the design; with them nobody needs the file.


def run_files(results: Results, of: str = "") -> dict[str, bytes]:
    """The files by their names; `of`: the letter of a design of two."""
    return {_run_name(n, of): rows.kept for n, rows in enumerate(results.design.runs, 1)}


def run_key(n: int, of: str = "") -> str:
    """The keyword that has the sum of the n-th."""
    return f"run{of}{n}"


def _run_name(n: int | str, of: str) -> str:
    return f"{of}run-{n}.csv"


def with_runs(inside: "Inside", document: Document, of: str = "") -> Document:
    """A design with the runs that are inside the document that it is attached to."""
    runs = document.data.get(dotted(Design.measurements))
    names = [run.get("name") for run in runs if isinstance(run, dict)] if isinstance(runs, list) else []
    files = {
        name: inside.file(_run_name(n, of))
        for n, name in enumerate(names, 1)
        if isinstance(name, str) and run_key(n, of) in inside.said
    }
    return replace(document, files=files)


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


def packed(raw: bytes) -> list[bytes]:
    """Whatever streams a file has, unpacked where they are deflated; nothing else of it is read.  Raises Refused."""
    if b"/Encrypt" in raw:
        raise Refused("is encrypted; give the report as it was written")
    streams, left = [], PDF_UNPACKED
    for piece in raw.split(b"endstream"):
        if (start := STREAM.search(piece)) is None:
            continue
        data = piece[start.end() :]
        try:
            streams.append(zlib.decompressobj().decompress(data, left))
        except zlib.error:
            streams += [data, data.removesuffix(b"\n"), data.removesuffix(b"\r\n")]
        left -= len(streams[-1])
        if left <= 0:
            raise Refused(f"holds more than {PDF_UNPACKED:,} bytes")
    return streams


@dataclass(frozen=True)
class Inside:
    """What a document says of how it was made, by its keywords, and all that is packed in it; `place`: where it
    stands."""

    place: str
    said: dict[str, str]
    packed: list[bytes]

    @property
    def made(self) -> dict[str, str]:
        """The versions that it was made with."""
        return {name: self.said[name] for name in MADE if name in self.said}

    @property
    def sums(self) -> dict[str, str]:
        """The files that it was written with, but for a logo, each with its sum."""
        said = self.said
        designs = {PAIR[0]: said["sha256"], PAIR[1]: said["other"]} if "other" in said else {NAME: said["sha256"]}
        runs = {_run_name(key[2], key[1]): said[key[0]] for key in RUN.findall(" ".join(said))}
        return {**designs, RESULTS: said["results"], **({FRONT: said["front"]} if "front" in said else {}), **runs}

    def file(self, name: str) -> bytes:
        """What it was written with under this name, by its sum; where that is gone, what looks like it.  Raises
        BadInput."""
        sum = self.sums.get(name, self.said.get("logo"))
        alike = re.compile(ALIKE[name.rpartition(".")[2].lower()])
        files = [file for file in self.packed if sha256(file) == sum] or [*filter(alike.search, self.packed)]
        if not files:
            raise refused(self.place, Text("has no attachment {name}; a report of this program has it", name=name))
        return files[-1 if name == PAIR[1] else 0]

    def solved(self) -> Any:
        """The values and verdicts that it was written with."""
        try:
            return json.loads(self.file(RESULTS))
        except (ValueError, RecursionError):
            raise self.damaged() from None

    def damaged(self) -> BadInput:
        reason = Text("has an attachment {name} that can not be read; the report was damaged", name=RESULTS)
        return refused(self.place, reason)


def inside(place: str, raw: bytes, packed: list[bytes]) -> Inside:
    """Of a document and all that is packed in it.  Raises BadInput for one that this program has not written."""
    parts = (text for part in (raw, *packed) for text in (part, OCTAL.sub(lambda mark: bytes([int(mark[1], 8)]), part)))
    words = next(filter(None, map(KEYWORDS.search, parts)), None)
    if words is None:
        raise refused(place, NO_REPORT)
    said = dict(
        reversed([item.split(":") for item in words[2].decode().split(", ")])
    )  # of one that stands twice the first
    if not {"depth", "lang", "sha256", "results"} <= set(said):
        raise refused(place, NO_REPORT)
    return Inside(place, {**said, "program": words[1].decode()}, packed)


def beginning(raw: bytes) -> bytes:
    """The part of a file that this program has written, if it has."""
    return raw[: raw.find(END) + len(END)]


def is_report(raw: bytes) -> bool:
    """Whether a file is a document of this program to which nothing was appended, no signature either."""
    try:
        return bool(inside("", raw, packed(raw))) and beginning(raw) == raw
    except (BadInput, Refused):
        return False


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
    about.producer = "ReportLab"  # which else says of itself what its versions say in other words
    about.invariant = True
    canvas._doc.info = about
