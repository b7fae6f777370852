# SPDX-License-Identifier: Apache-2.0
"""Whether the tables of a PDF lead to the objects that stand in it (ISO 32000-1, 7.5.4 to 7.5.8).

One reader follows the tables, another looks for the objects, and a file can be made so that they find different ones.
"""

from __future__ import annotations

from typing import Any

from .verify.pdf_file import Malformed, Pdf, Stream, Table


def demand_tables(pdf: Pdf) -> None:
    """Raises Malformed if one who follows the tables from the end finds anything but the last object of each number."""
    found: Table = {}
    trailers: list[dict[str, Any]] = []
    at: Any = pdf.sections[-1].start
    while at is not None:
        if type(at) is not int or at not in pdf.tables or len(trailers) == len(pdf.tables):
            raise Malformed("its table of objects is not where it says")
        table, trailer = pdf.tables[at]
        if "XRefStm" in trailer:
            raise Malformed("it has two tables for the same objects")
        for number, place in table.items():
            found.setdefault(number, place)
        trailers.append(trailer)
        at = trailer.get("Prev")
    said = pdf.trailer
    root, info = said.get("Root"), said.get("Info")
    trailer = trailers[0]
    if trailer.get("Root") != root or trailer.get("Info", info) != info:
        raise Malformed("its trailer is not the last one")
    for number in sorted({*found, *pdf.places} - {0}):
        kind = pdf.objects.get(number)
        itself = isinstance(kind, Stream) and kind.entries.get("Type") == "XRef"  # needs not stand in itself
        if found.get(number) != pdf.places.get(number) and not (itself and number not in found):
            raise Malformed(f"object {number} is not where its table says")
