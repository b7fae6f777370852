# SPDX-License-Identifier: Apache-2.0
"""The title block: what the design says of the document, fields to sign by hand, the logo; and what no logo may do."""

import io
import os
import struct
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest
from pypdf import PdfReader, PdfWriter

from calc.design.toml_file import design, read
from calc.sheet.errors import BadInput
from calc.solve import solve
from reports.report import write
from reports.verify.verify import Verdict, verify
from tests.reports.reading import V12, Solved, pages_of, solved

CONTROL = """
[document]
number = "CS-0042"
project = "Twelve cylinders"
customer = "Customer S.p.A."
company = "Example Works"
revision = "B"
prepared = { name = "Anna Example", date = 2026-03-14 }
checked = { name = "Bruno Example" }
changes = [ { revision = "A", what = "First issue" }, { revision = "B", date = 2026-03-14, what = "Other balancing", by = "A. E." } ]
"""


def png(width: int = 60, height: int = 20) -> bytes:
    """A red picture."""

    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    rows = zlib.compress(b"".join(b"\0" + b"\xff\0\0" * width for _ in range(min(height, 20))))
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


def with_logo(folder: Path, name: str = "logo.png") -> Solved:
    """A design in a folder, which wants a logo."""
    place = folder / "d.toml"
    place.write_text(V12 + CONTROL.replace("[document]", f'[document]\nlogo = "{name}"'), encoding="utf-8")
    document = read(place)
    return Solved(document.raw, document, solve(design(document)))


def test_what_the_design_says_stands_on_the_first_page_and_at_every_foot() -> None:
    pages = pages_of(solved(V12 + CONTROL).report())
    for words in (
        "CS-0042",
        "Twelve cylinders",
        "Customer S.p.A.",
        "Example Works",
        "Anna Example 2026-03-14",
        "Bruno Example",
        "Approved",
    ):
        assert words in pages[0]
    assert any("B 2026-03-14 Other balancing A. E." in page for page in pages)
    for n, page in enumerate(pages, 1):
        assert "CS-0042 · Revision B" in page and f"Page {n} of {len(pages)}" in page


def test_who_is_not_named_has_an_empty_field() -> None:
    first = pages_of(solved(V12).report("summary"))[0].splitlines()
    assert "Name Date Signature" in first and {"Prepared", "Checked", "Approved"} <= set(first)


def test_a_logo_is_drawn_and_goes_with_the_report(tmp_path: Path) -> None:
    (tmp_path / "logo.png").write_bytes(png())
    made = with_logo(tmp_path)
    pdf = write(made.document, made.results, made.raw, tmp_path / "d.pdf", depth="summary").read_bytes()
    (tmp_path / "logo.png").unlink()
    reader = PdfReader(io.BytesIO(pdf))
    assert [image.image.size for image in reader.pages[0].images if image.image is not None] == [(60, 20)]
    assert reader.attachments["logo.png"] == [png()]
    assert verify(pdf, str(tmp_path / "d.pdf")).verdict is Verdict.IDENTICAL
    writer = PdfWriter(clone_from=io.BytesIO(pdf))
    names = writer.root_object["/Names"]["/EmbeddedFiles"]["/Names"]
    names[names.index("logo.png") + 1].get_object()["/EF"]["/F"].get_object().set_data(png(61))
    forged = io.BytesIO()
    writer.write(forged)
    found = verify(forged.getvalue(), "d.pdf")
    assert found.changed == ("logo.png",) and found.verdict is Verdict.NOT_AS_WRITTEN


def linked(path: Path) -> None:
    (path.parent / "other").write_bytes(png())
    path.symlink_to("other")


def damaged(path: Path) -> None:
    raw = bytearray(png())
    raw[45:60] = b"\0" * 15
    path.write_bytes(raw)


@pytest.mark.parametrize(
    ("put", "words"),
    [
        (lambda path: None, "cannot be read beside the design"),
        (Path.mkdir, "is no plain file"),
        (os.mkfifo, "is no plain file"),
        (linked, "is no plain file"),
        (lambda path: path.write_bytes(b"%!PS-Adobe-3.0 EPSF-3.0"), "is no PNG picture"),
        (lambda path: path.write_bytes(png()[:20]), "is no PNG picture"),
        (lambda path: path.write_bytes(png()[:-30]), "is a damaged PNG picture"),
        (damaged, "is a damaged PNG picture"),
        (lambda path: path.write_bytes(png(40_000, 40_000)), "40000 × 40000 pixels"),
        (lambda path: path.write_bytes(png() + bytes(300_000)), "larger than 300 kB"),
    ],
)
def test_a_logo_that_can_not_be_drawn_is_named_and_no_report_is_written(
    put: Callable[[Path], object], words: str, tmp_path: Path
) -> None:
    made = with_logo(tmp_path)
    put(tmp_path / "logo.png")
    with pytest.raises(BadInput, match=words) as bad:
        write(made.document, made.results, made.raw, tmp_path / "d.pdf", depth="summary")
    assert bad.value.errors[0].key == "document.logo" and bad.value.errors[0].line
    assert not list(tmp_path.glob("*.pdf"))
