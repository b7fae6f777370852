# SPDX-License-Identifier: Apache-2.0
"""The session in a browser: the command, who may reach it, and typing in a real one."""

import asyncio
import os
import re
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import time
import tomllib
from collections.abc import Iterator
from pathlib import Path
from urllib.error import HTTPError
from urllib.parse import urljoin
from urllib.request import Request, urlopen

import pytest

from assistant.cli import main
from assistant.commands.serve import command

from .browser import CHROMIUM, browser, kill_group
from .conftest import GAMMA, ROOT

posix = pytest.mark.skipif(os.name != "posix", reason="ends the server by a signal")


def free_port() -> int:
    with socket.socket() as trial:
        trial.bind(("127.0.0.1", 0))
        return int(trial.getsockname()[1])


@pytest.fixture
def design(tmp_path: Path) -> Path:
    """With all that a shell would stumble over in its path."""
    path = tmp_path / 'it\'s a "$HOME" of `its` own; & more' / "my design.toml"
    path.parent.mkdir()
    shutil.copy(GAMMA, path)
    return path


@pytest.fixture
def served(design: Path, tmp_path: Path) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A server over the design, and its address."""
    port = free_port()
    with open(tmp_path / "told", "w+", encoding="utf-8") as told:
        process = subprocess.Popen(
            [sys.executable, "-m", "assistant", "serve", design.name, "--port", str(port)], cwd=design.parent,
            stdout=told, stderr=subprocess.STDOUT, start_new_session=True, text=True,
            env={**os.environ, "PYTHONPATH": str(ROOT), "XDG_STATE_HOME": str(tmp_path / "state")},
        )  # fmt: skip
        try:
            end = time.monotonic() + 60
            while "Ctrl+C" not in (tmp_path / "told").read_text(encoding="utf-8"):
                assert time.monotonic() < end and process.poll() is None, (tmp_path / "told").read_text(encoding="utf-8")
                time.sleep(0.05)
            yield process, f"http://127.0.0.1:{port}"
        finally:
            kill_group(process.pid)
            process.wait()


# --- the command
def test_the_command_survives_any_path() -> None:
    path = Path("/tmp/a 'b\" $c/d e.toml")
    if os.name == "posix":
        assert shlex.split(command(path)) == [sys.executable, "-m", "assistant", "session", str(path)]
    assert command(None).endswith("-m assistant session")


@pytest.mark.parametrize("port, reason", [(0, "out of range"), (65536, "out of range"), (-1, "out of range")])
def test_a_port_out_of_range_is_an_error(port: int, reason: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["serve", f"--port={port}"]) == 2
    told = capsys.readouterr().err
    assert reason in told and str(port) in told and "65535" in told


def test_a_port_that_is_taken_is_an_error(capsys: pytest.CaptureFixture[str]) -> None:
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        assert main(["serve", "--port", str(port)]) == 2
    told = capsys.readouterr().err
    assert f"{port}: is taken" in told and "--port" in told


def test_a_design_with_mistakes_is_an_error_before_anything_is_served(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "bad.toml").write_text('schema = 1\nname = "bad"\n[engine]\nbore_mm = -1\n')
    assert main(["serve", str(tmp_path / "bad.toml")]) == 2
    assert "bore_mm" in capsys.readouterr().err
    assert main(["serve", str(tmp_path / "missing.toml")]) == 2


# --- the server
def asked(address: str, **headers: str) -> int:
    try:
        with urlopen(Request(address, headers=headers), timeout=30) as answer:
            return int(answer.status)
    except HTTPError as no:
        return no.code


@posix
def test_the_server_answers_its_own_page_only_and_ends_by_an_interrupt(served: tuple[subprocess.Popen[str], str], tmp_path: Path) -> None:
    process, address = served
    with urlopen(address, timeout=30) as answer:
        page = answer.read().decode("utf-8")
    assert "https://" not in page
    for part in re.findall(r'(?:href|src)="([^"]*)"|src: url\("([^"]*)"\)', page):  # the style sheet, the program of the page, its fonts
        assert asked(urljoin(address, "".join(part))) == 200
    assert f"{address}/static/css/xterm.css" in page
    upgrade = {
        "Connection": "Upgrade",
        "Upgrade": "websocket",
        "Sec-WebSocket-Version": "13",
        "Sec-WebSocket-Key": "AAAAAAAAAAAAAAAAAAAAAA==",
    }
    for stranger in ({"Origin": "https://example.org"}, {"Origin": "null"}, {"Origin": address.rpartition(":")[0]}, {}):
        assert asked(f"{address}/ws", **stranger, **upgrade) == 403
    assert asked(address, Host="example.org") == 403  # a name that was made to point here
    assert asked(address, Origin=address) == 200
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=30) == 0
    told = (tmp_path / "told").read_text(encoding="utf-8")
    assert told.splitlines() == [f"The guided session is at {address} (Ctrl+C ends it)"]


# --- in a browser
@posix
@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
async def test_a_design_is_edited_and_saved_in_a_browser(served: tuple[subprocess.Popen[str], str], design: Path, tmp_path: Path) -> None:
    process, address = served
    before = design.read_bytes()
    async with browser(tmp_path) as page:
        await page.open(address)
        await page.until(lambda text: "my design.toml" in text and "solved in" in text and "Bore" in text)
        for _ in range(2):  # design, note: bore
            await page.press("Tab")
        await page.type("95,5")
        await page.until(lambda text: "[95,5 " in text and "= 95.5" in text and "edited" in text)
        await page.press("Enter")
        await page.until(lambda text: "[95.5 " in text)
        assert design.read_bytes() == before
        await page.press("s", ctrl=True)
        await page.until(lambda text: "Saved:" in text)
        assert tomllib.loads(design.read_text(encoding="utf-8"))["engine"]["bore_mm"] == 95.5
        assert design.with_name("my design.toml.bak").read_bytes() == before
        assert await page.value("document.fonts.check(\"16px 'Roboto Mono'\")")
        assert page.asked and all(wanted.startswith(address + "/") for wanted in page.asked)
        assert not page.faults
        process.send_signal(signal.SIGINT)
        assert await asyncio.to_thread(process.wait, 30) == 0
    told = (tmp_path / "told").read_text(encoding="utf-8")
    assert told.splitlines() == [f"The guided session is at {address} (Ctrl+C ends it)"]


def _filled(box: list[float], size: tuple[int, int]) -> bool:
    """Whether what is left of a window is less than a cell."""
    left, top, right, bottom = box
    return (left, top) == (0, 0) and 0 <= size[0] - right < 12 and 0 <= size[1] - bottom < 24


@posix
@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
@pytest.mark.parametrize(("width", "height"), [(1280, 800), (1920, 1080)])
async def test_a_page_is_filled_as_a_terminal_is(
    served: tuple[subprocess.Popen[str], str], tmp_path: Path, width: int, height: int
) -> None:
    """Letters, rules and colours stand where a terminal has them, from edge to edge, also after the window has changed."""
    _, address = served
    async with browser(tmp_path) as page:
        for size in ((width, height), (width - 300, height - 200)):
            await page.tell("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=1, mobile=False)
            if not page.asked:
                await page.open(address)
            await page.until(lambda text: "my design.toml" in text and "solved in" in text and "Bore" in text)
            end = time.monotonic() + 30
            while not _filled(await page.box(".xterm-screen"), size):
                assert time.monotonic() < end, await page.box(".xterm-screen")
                await asyncio.sleep(0.1)
            assert await page.value("document.activeElement.className") == "xterm-helper-textarea"
            assert await page.value("getComputedStyle(document.querySelector('.xterm-viewport')).position") == "absolute"
        assert not page.faults
