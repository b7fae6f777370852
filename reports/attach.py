# SPDX-License-Identifier: Apache-2.0
"""The design file inside the report: an embedded file that any reader of PDF can take out again."""

import hashlib

from reportlab.pdfbase.pdfdoc import PDFArray, PDFDictionary, PDFInfo, PDFName, PDFStream, PDFString, PDFZCompress
from reportlab.pdfgen.canvas import Canvas

NAME = "design.toml"


def attach(canvas: Canvas, raw: bytes, description: str) -> None:
    """Embed the bytes of the design file as `design.toml`."""
    document = canvas._doc
    sums = {"Size": len(raw), "CheckSum": PDFString(hashlib.md5(raw, usedforsecurity=False).digest(), enc="raw")}
    stream = PDFStream(PDFDictionary({"Type": PDFName("EmbeddedFile"), "Params": PDFDictionary(sums)}), raw, filters=[PDFZCompress])
    stream.dictionary["Subtype"] = "/application#2Ftoml"
    file = document.Reference(stream)
    specification = document.Reference(
        PDFDictionary(
            {
                "Type": PDFName("Filespec"), "F": PDFString(NAME), "UF": PDFString(NAME), "Desc": PDFString(description),
                "AFRelationship": PDFName("Source"), "EF": PDFDictionary({"F": file, "UF": file}),
            }
        )
    )  # fmt: skip
    catalog = document.Catalog
    catalog.__NoDefault__ = [*catalog.__NoDefault__, "AF"]
    catalog.AF = PDFArray([specification])
    catalog.Names = PDFDictionary({"EmbeddedFiles": PDFDictionary({"Names": PDFArray([PDFString(NAME), specification])})})


class Undated(PDFInfo):  # type: ignore[misc]
    """The document's own description, without the moment at which it was written: the same input gives the same bytes."""

    def format(self, document: object) -> object:
        said = {
            "Title": self.title, "Author": self.author, "Subject": self.subject, "Keywords": self.keywords, "Creator": self.creator,
            "Producer": self.producer,
        }  # fmt: skip
        return PDFDictionary({k: PDFString(v) for k, v in said.items() if v}).format(document)


def describe(canvas: Canvas, *, title: str, author: str, subject: str, keywords: str, program: str) -> None:
    about = Undated()
    about.title, about.author, about.subject, about.keywords, about.creator = title, author, subject, keywords, program
    about.invariant = True
    canvas._doc.info = about
