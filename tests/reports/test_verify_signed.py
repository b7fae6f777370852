# SPDX-License-Identifier: Apache-2.0
"""What is signed: signatures in the fields of the report, and nothing else behind it."""

import io
import re
import sys
from pathlib import Path
from typing import Any

import pytest
from pyhanko.sign.fields import SigSeedSubFilter
from pyhanko.stamp import TextStampStyle
from pypdf import PdfReader, PdfWriter

from assistant.cli import main
from reports.apart import Refused
from reports.blocks.title_block import FIELDS
from reports.verify import signature
from reports.verify.verify import Verdict, verify
from tests.reports.forged_structure import in_a_pack
from tests.reports.forgeries import Update, streamed
from tests.reports.signing import SIGNER, sign

pytestmark = pytest.mark.usefixtures("written_once")


def test_the_report_has_a_field_in_each_box_to_sign(made: bytes) -> None:
    """Where the box of its row is, without a look, and said to whoever hears the document."""
    reader = PdfReader(io.BytesIO(made))
    fields = [x.get_object() for x in reader.root_object["/AcroForm"]["/Fields"]]  # type: ignore[index]
    assert [field["/T"] for field in fields] == list(FIELDS)
    assert reader.root_object["/AcroForm"]["/SigFlags"] == 3  # type: ignore[index]
    tops = [float(field["/Rect"][3]) for field in fields]
    assert tops == sorted(tops, reverse=True) and all(field["/FT"] == "/Sig" for field in fields)
    assert all(field["/TU"].startswith("Signature: ") and not field["/AP"]["/N"].get_data() for field in fields)


@pytest.mark.parametrize(
    "names", [FIELDS[::-1], *(pytest.param(names, marks=pytest.mark.slow) for names in (FIELDS[:1], FIELDS[1:]))]
)
def test_signatures_in_its_fields_are_signed(made: bytes, names: tuple[str, ...]) -> None:
    raw = made
    for name in names:
        raw = sign(raw, name)
    found = verify(raw, "x.pdf")
    assert found.verdict is Verdict.SIGNED and found.original == made
    assert [str(line).partition(":")[0] for line in found.signers] == list(names)
    assert all(
        re.search(rf": Common Name: {SIGNER}, 20\d\d-.* by their own clock; pyHanko: INTACT:UNTRUSTED", x)
        for x in found.signers
    )


@pytest.mark.parametrize(
    "about",
    [
        pytest.param({"stamp": TextStampStyle(stamp_text="Signed by %(signer)s\n%(ts)s")}, marks=pytest.mark.slow),
        pytest.param({"subfilter": SigSeedSubFilter.PADES}, marks=pytest.mark.slow),
        {"subfilter": SigSeedSubFilter.PADES, "stamp": TextStampStyle(stamp_text="x")},
        {"reason": "checked", "location": "Turin", "name": "J. Doe", "contact_info": "none"},
    ],
    ids=["stamp", "PAdES", "PAdES with a stamp", "reason"],
)
@pytest.mark.usefixtures("read_here")
def test_what_signing_programs_do_is_signed(made: bytes, about: dict[str, Any]) -> None:
    """Also where others have signed before, and sign after."""
    raw = sign(made, "Checked", **about)
    assert verify(raw, "x.pdf").verdict is Verdict.SIGNED
    assert verify(sign(sign(raw), "Approved", stamp=about.get("stamp")), "x.pdf").verdict is Verdict.SIGNED


@pytest.mark.usefixtures("read_here")
def test_a_signature_with_objects_in_a_stream_is_signed(made: bytes) -> None:
    """As other programs write it; and what is signed after it."""
    raw = in_a_pack(made)
    assert verify(raw, "x.pdf").verdict is verify(sign(raw), "x.pdf").verdict is Verdict.SIGNED


def test_the_command_says_who_signed_and_writes_what_was_signed(
    made: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, original = tmp_path / "signed.pdf", tmp_path / "ours.pdf"
    path.write_bytes(sign(made))
    assert main(["verify", str(path), "--original", str(original)]) == 0
    out, error = capsys.readouterr()
    assert f"Prepared: Common Name: {SIGNER}, 20" in out and out.splitlines()[-1].startswith("signed: ")
    assert original.read_bytes() == made and not error


def appended(made: bytes, raw: bytes, why: str) -> None:
    found = verify(raw, "x.pdf")
    assert (found.verdict, found.original) == (Verdict.APPENDED, made)
    assert why in found.why


def test_a_field_beside_those_of_the_report_is_none(made: bytes) -> None:
    """Over the verdict or beside a number it would say something else than the report."""
    appended(made, sign(made, "Sent", (60, 600, 300, 640)), "no part of a signature")
    appended(made, sign(sign(made), "Sent", (10, 10, 60, 20)), "no part of a signature")


def test_what_stands_behind_a_signature_is_none(made: bytes) -> None:
    appended(made, sign(made) + b"% later\n", "")
    update = Update(sign(made))
    update.entry(update.page(), b"Rotate", b"90")
    appended(made, update.written(), "")


def test_a_broken_signature_is_none(made: bytes) -> None:
    raw = bytearray(sign(made))
    at = raw.index(b"/Contents <", len(made)) + 200
    raw[at] = ord("0") if raw[at] != ord("0") else ord("1")
    appended(made, bytes(raw), "")


def test_other_metadata_are_none(made: bytes) -> None:
    """A program that signs may name itself in them; the title, the keywords and all else must stay."""
    said = PdfReader(io.BytesIO(made)).root_object["/Metadata"].get_data()  # type: ignore[attr-defined]
    for changed in (
        said.replace(b'rdf:about=""', b'rdf:about="" xmp:Label="PASS"'),
        said.replace(b"sha256:", b"sha256:0"),
    ):
        update = Update(made)
        update.put(update.at("/Metadata"), streamed(changed, b"/Type /Metadata /Subtype /XML"))
        assert verify(sign(update.written()), "x.pdf").verdict is Verdict.APPENDED
    update = Update(made)
    update.entry(update.info, b"Title", b"(all checks pass)")
    assert verify(sign(update.written()), "x.pdf").verdict is Verdict.APPENDED
    twice = said.replace(b'rdf:about=""', b'rdf:about="" pdf:Keywords="PASS"')
    assert signature._metadata(twice) != signature._metadata(said)
    with pytest.raises(Refused):
        signature._metadata(said.replace(b"<x:xmpmeta", b'<!DOCTYPE x [<!ENTITY a "PASS">]><x:xmpmeta'))
    named = said.replace(b"<pdf:Producer>", b"<pdf:Producer>Signer; ")
    assert signature._metadata(named) == signature._metadata(said) != []


@pytest.mark.usefixtures("read_here")
def test_without_pyhanko_nothing_is_signed(
    made: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "signed.pdf"
    path.write_bytes(sign(made))
    monkeypatch.setitem(sys.modules, "pyhanko.pdf_utils.reader", None)
    assert main(["verify", str(path)]) == 4
    assert "contralbero[sign]" in capsys.readouterr().out


def test_a_signature_on_a_copy_is_not_of_the_report(made: bytes) -> None:
    out = io.BytesIO()
    PdfWriter(clone_from=io.BytesIO(made)).write(out)
    assert verify(sign(out.getvalue()), "x.pdf").verdict is Verdict.NOT_AS_WRITTEN
