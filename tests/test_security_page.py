# SPDX-License-Identifier: Apache-2.0
"""SECURITY.md says what is so: its limits are those of the code, and the program asks nobody over the network."""

import re

import pytest

from assistant import server
from assistant.commands.verify import LAST
from calc.design.limits import TABLES
from tests.conftest import ROOT
from tests.import_scan import imported, modules

PAGE = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
OUTWARD = {
    "urllib.request",
    "http.client",
    "http.server",
    "ftplib",
    "smtplib",
    "socketserver",
    "xmlrpc",
    "requests",
    "httpx",
    "urllib3",
}
SERVING = {"assistant.server", "assistant.commands.session"}


@pytest.mark.parametrize("of", TABLES)
def test_the_limits_are_those_of_the_code(of: str) -> None:
    rows = "".join(f"| {what} | {most:,} |\n" for what, most in TABLES[of].items())
    assert f"| limit of {of} | at most |\n|---|---|\n{rows}\n" in PAGE


def test_there_are_no_other_tables_of_limits() -> None:
    assert PAGE.count("| at most |") == len(TABLES) and f"after {server.ENDING:.0f} seconds" in PAGE


def test_every_verdict_is_explained_in_its_own_words() -> None:
    rows = PAGE.partition("| `verify` says |")[2].partition("\n\n")[0]
    told = re.findall(r"^\| ([a-z ]+) \| [014, ]+ \|", rows, re.M)
    assert set(told) == {words.partition(":")[0] for words in LAST.values()}


def test_nobody_is_asked_over_the_network() -> None:
    """The session in a browser alone opens a socket, and on this machine."""
    outward = OUTWARD | {"socket", "aiohttp"}
    found = {
        name: names
        for package in ("calc", "reports", "assistant")
        for name, path in modules(ROOT, package).items()
        if any(
            word.partition(".")[0] in path.read_text(encoding="utf-8") for word in outward
        )  # sooner than parsing all
        and (names := set(imported(name, path)) & outward)
        and (name not in SERVING or names & OUTWARD)
    }
    assert found == {}
    assert server.HOST == "127.0.0.1"
