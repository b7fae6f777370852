# SPDX-License-Identifier: Apache-2.0
"""What a signature covers: nothing that is printed, or it is said."""

import io
from pathlib import Path

import pytest
from pypdf import PdfReader

from assistant.cli import main
from reports.blocks import title_block
from reports.typesetting.fonts import LEFT, WIDTH
from reports.verify.difference import covered, page_references, printed
from reports.verify.pdf_file import Pdf
from reports.verify.verify import Verdict, verify
from tests.reports.forgeries import EMPTY, Update, streamed
from tests.reports.reading import spans

pytestmark = pytest.mark.usefixtures("written_once")


def stamped(made: bytes, rect: tuple[float, ...], page: int = 0) -> bytes:
    """The report with the field of a signature appended."""
    update = Update(made)
    update.sign(rect=rect, page=page)
    return update.written()


def test_a_signature_over_what_is_printed_is_a_word_of_its_own(
    made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A green PASS set over the verdict as the look of a signature is no signature."""
    verdict = next(span for span in spans(made) if span.size == 15.0)
    path = tmp_path / "stamped.pdf"
    path.write_bytes(stamped(made, (verdict.x, verdict.y, verdict.end, verdict.y + 12)))
    assert main(["verify", str(path)]) == 1
    out = capsys.readouterr().out
    assert f"page 1, under the field of a signature: covered in the report, “{verdict.text}" in out
    assert out.splitlines()[-1].startswith("covered: ")


def test_a_signature_over_a_figure_covers_it(made: bytes) -> None:
    pdf = Pdf(made)
    page, box = next(
        (n, box) for n, one in enumerate(page_references(pdf)) for box, text in printed(pdf, one) if text == "figure"
    )
    found = verify(stamped(made, (box[0] + 1, box[1] + 1, box[0] + 9, box[1] + 9), page), "x.pdf")
    assert found.verdict is Verdict.COVERED
    assert [one.what for one in found.differences] == [f"page {page + 1}, under the field of a signature"]


def test_the_bar_of_a_fraction_belongs_to_its_formula(engineer: bytes) -> None:
    """Between the letters above and below it a field of no height would make another formula of it."""
    pdf = Pdf(engineer)
    boxes = [box for page in page_references(pdf) for box, text in printed(pdf, page) if text == "formula"]
    left, low, right, top = max(boxes, key=lambda box: box[3] - box[1])
    assert covered((left, (low + top) / 2, right, (low + top) / 2 + 0.1), [((left, low, right, top), "formula")])


def test_a_signature_in_its_box_is_said_and_no_difference(
    made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A field that fills the box to sign in, whichever row it is, covers nothing."""
    for row in ("Prepared", "Checked", "Approved"):
        label = next(span for span in spans(made) if span.text == row)
        top = label.y + 0.64 * title_block.SIGN
        path = tmp_path / f"{row}.pdf"
        path.write_bytes(stamped(made, (LEFT + title_block.SIGN_AT[3], top - title_block.SIGN, LEFT + WIDTH, top)))
        found = verify(path.read_bytes(), "x.pdf")
        assert (found.verdict, found.signed) == (Verdict.SIGNED, (1,))
    assert main(["verify", str(path)]) == 0
    out = capsys.readouterr().out
    assert "page 1 carries the field of a signature" in out and out.splitlines()[-1].startswith(
        "signed, or prepared for it"
    )


def test_a_field_is_prepared_first_and_signed_later(made: bytes) -> None:
    """Each program appends what is its own."""
    update = Update(stamped(made, EMPTY))
    field = update.at("/AcroForm", "/Fields", 0)
    update.swap(
        field,
        rb"/F 132",
        b"/F 132 /V %d 0 R" % update.add(b"<< /Type /Sig /Filter /Adobe.PPKLite /ByteRange [0 1 2 3] >>"),
    )
    update.entry(update.info, b"ModDate", b"(D:20260314)")
    assert verify(update.written(), "x.pdf").verdict is Verdict.SIGNED


def test_a_signing_program_may_name_itself_in_the_metadata(made: bytes) -> None:
    """Programs that sign write them anew, in another of the ways that there are; what they say must stay."""
    said = PdfReader(io.BytesIO(made)).root_object["/Metadata"].get_data()  # type: ignore[attr-defined]
    date = b'rdf:about="" xmp:ModifyDate="2026-03-14T00:00:00Z"'
    for changed, verdict in (
        (said.replace(b'rdf:about=""', date).replace(b"<pdf:Producer>", b"<pdf:Producer>Signer; "), Verdict.SIGNED),
        (said.replace(b'rdf:about=""', b'rdf:about="" xmp:Label="PASS"'), Verdict.DIFFERS),
        (said.replace(b"</dc:title>", b"</dc:title><dc:title>PASS</dc:title>"), Verdict.DIFFERS),
        (said.replace(b"<x:xmpmeta", b'<!DOCTYPE x [<!ENTITY a "PASS">]><x:xmpmeta'), Verdict.DIFFERS),
    ):
        update = Update(made)
        update.sign()
        update.put(update.at("/Metadata"), streamed(changed, b"/Type /Metadata /Subtype /XML"))
        assert verify(update.written(), "x.pdf").verdict is verdict
