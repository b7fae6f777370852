# SPDX-License-Identifier: Apache-2.0
"""SECURITY.md says what is so: its limits are those of the code, and the program asks nobody over the network."""

import re

import pytest

from assistant import server
from assistant.commands.verify import LAST
from reports import pdf_file

from .conftest import ROOT
from .import_scan import imported, modules

PAGE = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
OUTWARD = {"urllib.request", "http.client", "http.server", "ftplib", "smtplib", "socketserver", "xmlrpc", "requests", "httpx", "urllib3"}
SERVING = {"assistant.server", "assistant.commands.serve"}


@pytest.mark.parametrize(
    ("row", "limit"),
    [
        ("bytes, of a regular file", pdf_file.MOST_BYTES), ("bytes of all its streams, unpacked", pdf_file.MOST_UNPACKED),
        ("values in it", pdf_file.MOST_VALUES), ("lists in lists", pdf_file.DEEPEST), ("sessions at a time", server.MOST_SESSIONS),
        ("columns of a terminal", server.WIDEST), ("rows of a terminal", server.HIGHEST), ("letters pasted at once", server.MOST_PASTED),
        ("bytes of a message", server.MOST_RECEIVED),
    ],
)  # fmt: skip
def test_the_limits_are_those_of_the_code(row: str, limit: int) -> None:
    assert f"| {row} | {limit:,} |" in PAGE
    assert f"after {server.ENDING:.0f} seconds" in PAGE


def test_every_verdict_is_explained_in_its_own_words() -> None:
    told = re.findall(r"^\| ([a-z, ]+) \| ([01]) \|", PAGE, re.M)
    assert {verdict for verdict, _ in told} == {words.partition(":")[0].partition(", byte")[0] for words in LAST.values()}


def test_nobody_is_asked_over_the_network() -> None:
    """The session in a browser alone opens a socket, and on this machine."""
    found = {
        name: names
        for package in ("calc", "reports", "assistant")
        for name, path in modules(ROOT, package).items()
        if (names := set(imported(name, path)) & (OUTWARD | {"socket", "aiohttp"})) and (name not in SERVING or names & OUTWARD)
    }
    assert found == {}
    assert server.HOST == "127.0.0.1"
