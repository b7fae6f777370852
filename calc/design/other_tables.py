# SPDX-License-Identifier: Apache-2.0
"""Document control: number, people, revision and change record of a design, as the title block of its report prints them.

[document]
number = "CS-0042"
project = "Counter-shaft of the small industrial engine"
customer = "…"
company = "…"
logo = "logo.png"                      # a PNG file beside the design
revision = "B"
prepared = { name = "…", date = 2026-03-14 }
checked = { name = "…" }               # a date that is left out is written by hand

[[document.changes]]
revision = "B"
date = 2026-03-14
what = "Longer bearings"
by = "…"
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from .disk import bare_name
from ..sheet.quantity import day, inputs, table, tables, text
from ..sheet.text import Text

SIGNED = ("prepared", "checked", "approved")


@inputs
class Signature:
    """One who signs.  What is left empty is a field to fill in by hand."""

    name: str = text("Name", default="")
    date: str = day("Date", default="")


@inputs
class Change:
    """One row of the change record."""

    revision: str = text("Revision")
    date: str = day("Date", default="")
    what: str = text("What changed")
    by: str = text("By", default="")


@inputs
class DocumentControl:
    """What the title block says."""

    number: str = text("Number", default="", help="Of the document, as its company files it.")
    project: str = text("Project", default="")
    customer: str = text("Customer", default="")
    company: str = text("Company", default="")
    logo: str = text("Logo", default="", help="The name of a PNG file beside the design; the report prints it.")
    revision: str = text("Revision", default="")
    prepared: Signature | None = table("Prepared", Signature, default=None)
    checked: Signature | None = table("Checked", Signature, default=None)
    approved: Signature | None = table("Approved", Signature, default=None)
    changes: tuple[Change, ...] = tables("Change record", Change, default=(), help="One row for each revision, the oldest first.")

    def problems(self) -> Iterable[tuple[str, Text]]:
        if not self.logo:
            return
        if not bare_name(self.logo):
            yield "logo", Text("must be the bare name of a file beside the design, like logo.png")
        elif not self.logo.lower().endswith(".png"):
            yield "logo", Text("must be a PNG file (.png); other pictures, SVG among them, are not drawn: export it as PNG")

    def signatures(self) -> list[tuple[str, Signature]]:
        """Who signs, in order, by the keys of the table."""
        return [(key, getattr(self, key) or Signature()) for key in SIGNED]

    def words(self) -> Iterable[str]:
        """All that is printed of it."""
        yield from (self.number, self.project, self.customer, self.company, self.revision)
        for _, one in self.signatures():
            yield from (one.name, one.date)
        for change in self.changes:
            yield from (change.revision, change.date, change.what, change.by)


# Where the keys at the top of old files stand now
FORMER = {"author": ("prepared", "name"), "date": ("prepared", "date"), "checker": ("checked", "name"), "revision": ("revision", "")}


def control(own: DocumentControl | None, former: Mapping[str, str]) -> DocumentControl:
    """The table of a design, and what an old file says at its top in its place."""
    made = own or DocumentControl()
    prepared, checked = made.prepared or Signature(), made.checked or Signature()
    return replace(
        made,
        revision=made.revision or former["revision"],
        prepared=Signature(name=prepared.name or former["author"], date=prepared.date or former["date"]),
        checked=Signature(name=checked.name or former["checker"], date=checked.date),
        approved=made.approved or Signature(),
    )


def said_twice(own: DocumentControl | None, former: Mapping[str, str]) -> Iterable[tuple[str, Text]]:
    """Keys of old files whose content stands in the table as well."""
    for key, (place, part) in FORMER.items():
        there = getattr(own, place, None)
        if former[key] and (getattr(there, part, "") if part else there):
            yield key, Text("stands as {place} too; keep that and leave this out", place=".".join(filter(None, ("document", place, part))))
