# SPDX-License-Identifier: Apache-2.0
"""Signs reports as a signing program does, with a certificate of its own that nobody trusts."""

import asyncio
import hashlib
import io
import logging
from datetime import datetime
from functools import cache
from typing import Any

from asn1crypto import keys
from asn1crypto import x509 as der
from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.x509.oid import NameOID
from pyhanko.pdf_utils.incremental_writer import IncrementalPdfFileWriter
from pyhanko.sign import fields, signers
from pyhanko_certvalidator.registry import SimpleCertificateStore

logging.getLogger("pyhanko").setLevel(logging.CRITICAL)
SIGNER = "Jane Doe"


@cache
def signer() -> signers.SimpleSigner:
    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, SIGNER)])
    certificate = (
        x509.CertificateBuilder(name, name, key.public_key(), 7, datetime(2020, 1, 1), datetime(2060, 1, 1))
        .add_extension(x509.KeyUsage(True, True, *[False] * 7), critical=True)
        .sign(key, hashes.SHA256())
    )
    plain = serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    return signers.SimpleSigner(
        signing_cert=der.Certificate.load(certificate.public_bytes(serialization.Encoding.DER)),
        signing_key=keys.PrivateKeyInfo.load(key.private_bytes(serialization.Encoding.DER, *plain)),
        cert_registry=SimpleCertificateStore(),
    )


def sign(raw: bytes, field: str = "Prepared", box: tuple[int, int, int, int] | None = None, **about: Any) -> bytes:
    """With a signature in a field that is there; `box`: in a new one of that name there, on the first page.  `stamp`:
    what it shows; anything else as pyHanko has it."""
    writer, stamp = IncrementalPdfFileWriter(io.BytesIO(raw)), about.pop("stamp", None)
    new = fields.SigFieldSpec(field, box=box, on_page=0) if box is not None else None
    data = signers.PdfSignatureMetadata(field_name=field, md_algorithm="sha256", **about)
    by = signers.PdfSigner(data, signer(), stamp_style=stamp, new_field_spec=new)
    return bytes(by.sign_pdf(writer, existing_fields_only=box is None).getvalue())


PLACE = b"/ByteRange [@@@@@@@@@@ @@@@@@@@@@ @@@@@@@@@@ @@@@@@@@@@] /Contents <%s>" % (b"0" * 4096)


def sealed(raw: bytes, start: int, begin: int = 0) -> bytes:
    """With its signature in the PLACE that stands in it behind `start`, over all that is there, from `begin` on."""
    at = raw.index(PLACE, start)
    first = raw.index(b"<", at)
    last = first + 4098
    spans = b"/ByteRange [%10d %10d %10d %10d]" % (begin, first - begin, last, len(raw) - last)
    raw = raw[:at] + spans + raw[at + len(spans) :]
    digest = hashlib.sha256(raw[begin:first] + raw[last:]).digest()
    contents = asyncio.run(signer().async_sign(digest, "sha256")).dump().hex().encode()
    return raw[: first + 1] + contents.ljust(4096, b"0") + raw[last - 1 :]
