# SPDX-License-Identifier: Apache-2.0
"""The design file and what it gave, inside the report: embedded files that any reader of PDF can take out again."""

import hashlib
import json
import math

from reportlab.pdfbase.pdfdoc import PDFArray, PDFDictionary, PDFInfo, PDFName, PDFStream, PDFString, PDFZCompress
from reportlab.pdfgen.canvas import Canvas

from calc.design.key_results import judged
from calc.solve import Results

NAME = "design.toml"
RESULTS = "results.json"
FRONT = "front.json"
PAIR = ("a.toml", "b.toml")  # the designs of a comparison
# what a file is to the document, by its ending; any other only belongs to it
RELATIONS = {"toml": "Source", "json": "Data"}


def results_bytes(results: Results) -> bytes:
    """The values and verdicts of a report as JSON, the same bytes for the same results; what is not finite is null."""
    return _json(_solved(results))


def pair_bytes(names: tuple[str, str], results: tuple[Results, Results]) -> bytes:
    """The same of a comparison, with what it calls its two designs."""
    return _json({"names": list(names), "a": _solved(results[0]), "b": _solved(results[1])})


def _solved(results: Results) -> dict[str, object]:
    outcomes = results.outcomes.values()
    return {
        "values": {v.id: nine(v.shown) if math.isfinite(v.shown) else None for o in outcomes for v in o.values()},
        "checks": {check.id: judged(check) for o in outcomes for check in o.checks},
        "steps": {o.key: o.verdict for o in outcomes},
    }


def nine(x: float) -> float:
    """With nine digits: the last of the sixteen depend on processor and libraries, and a report does not."""
    return float(f"{x:.9g}")


def _json(value: object) -> bytes:
    return json.dumps(value, separators=(",", ":"), allow_nan=False).encode()


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
