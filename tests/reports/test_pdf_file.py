# SPDX-License-Identifier: Apache-2.0
"""PDF is read strictly, and no file takes for ever."""

import io
import zlib

import pytest
from pypdf import PdfReader

from reports.verify import pdf_file
from reports.verify.difference import page_references
from reports.verify.pdf_file import Malformed, Pdf
from tests.reports.reading import V12, solved


@pytest.fixture(scope="module")
def made() -> bytes:
    return solved(V12).report("summary")


def file_of(body: bytes) -> bytes:
    return b"%%PDF-1.7\n1 0 obj\n%s\nendobj\nxref\n0 1\ntrailer\n<< /Root 1 0 R >>\nstartxref\n9\n%%%%EOF\n" % body


@pytest.mark.parametrize(
    ("body", "reason"),
    [
        (b"<< /A 1 /A 2 >>", "a key twice"),
        (b"<< /A 1 /#41 2 >>", "a key twice"),
        (b"<< /A >>", "no pairs"),
        (b"<< 1 2 >>", "no pairs"),
        (b"[1 2 >>", "closes something else"),
        (b"(a", "no end"),
        (b"<4 1 x>", "no value"),
        (b"[" * 60 + b"]" * 60, "no value"),
        (b"1.2.3", "no value"),
        (b"<< /A 1 % a comment\n /B 2 >>", "no value"),
        (b"<< /Length 3 >>\nstream\nabcd\nendstream", "as long as it says"),
        (b"<< /Length 9 0 R >>\nstream\nabcd\nendstream", "how long"),
        (b"<< /Length -1 >>\nstream\nabcd\nendstream", "how long"),
    ],
)
def test_what_could_be_read_in_two_ways_is_refused(body: bytes, reason: str) -> None:
    with pytest.raises(Malformed, match=reason):
        Pdf(file_of(body))


def test_values_are_what_they_say() -> None:
    body = b"[/A#42c (a\\(b\\)\\n\\101\\\\) <4\0 14> -.5 +7 1 0 R true null (a(b)c) <<>>]"
    pdf = Pdf(file_of(body))
    name, text, hexed, half, seven, reference, true, null, nested, empty = pdf.items(pdf.trailer["Root"])
    assert (name, text, hexed, half, seven, true, null, nested, empty) == (
        "ABc",
        b"a(b)\nA\\",
        b"A@",
        -0.5,
        7,
        True,
        None,
        b"a(b)c",
        {},
    )
    assert reference == pdf.trailer["Root"]


def test_a_report_is_read_as_another_reader_reads_it(made: bytes) -> None:
    ours, other = Pdf(made), PdfReader(io.BytesIO(made))
    pages = page_references(ours)
    assert len(pages) == len(other.pages)
    for reference, page in zip(pages, other.pages):
        assert ours.data(ours.entries(reference)["Contents"]) == page.get_contents().get_data()  # type: ignore[union-attr]
    assert set(ours.root) == {key.removeprefix("/") for key in other.root_object}


@pytest.mark.parametrize(
    ("limit", "most", "reason"),
    [
        ("PDF_BYTES", 100, "at most 100 are read"),
        ("PDF_VALUES", 10, "more than 10 values"),
        ("PDF_UNPACKED", 50, "more than 50 bytes"),
    ],
)
def test_every_limit_is_kept(monkeypatch: pytest.MonkeyPatch, limit: str, most: int, reason: str) -> None:
    packed = zlib.compress(b"0" * 60)
    numbers = b"[" + b"1 " * 11 + b"]"
    raw = file_of(
        b"<< /Filter /FlateDecode /Length %d /N %s >>\nstream\n%s\nendstream" % (len(packed), numbers, packed)
    )
    whole = Pdf(raw)
    assert whole.data(whole.trailer["Root"]) == b"0" * 60
    monkeypatch.setattr(pdf_file, limit, most)
    with pytest.raises(Malformed, match=reason):
        Pdf(raw).data(whole.trailer["Root"])
