# SPDX-License-Identifier: Apache-2.0
"""The session in a browser: the command, who may reach it, and typing in a real one."""

import asyncio
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
import tomllib
from collections.abc import AsyncIterator, Iterator
from pathlib import Path
from typing import Any
from urllib.error import HTTPError
from urllib.parse import urljoin
from urllib.request import Request, urlopen

import pytest
from aiohttp import WSMsgType, WSServerHandshakeError
from aiohttp.test_utils import TestClient, TestServer

from assistant import server as serving
from assistant.cli import main
from assistant.commands.session import command
from assistant.server import Local
from calc.design.limits import COLUMNS, MESSAGE_BYTES, PASTED, ROWS
from tests.browser import CHROMIUM, browser, kill_group
from tests.conftest import GAMMA, ROOT

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
            [sys.executable, "-m", "assistant", "serve", design.name, "--port", str(port)],
            cwd=design.parent,
            stdout=told,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            text=True,
            env={**os.environ, "PYTHONPATH": str(ROOT), "XDG_STATE_HOME": str(tmp_path / "state")},
        )
        try:
            end = time.monotonic() + 60
            while "Ctrl+C" not in (tmp_path / "told").read_text(encoding="utf-8"):
                assert time.monotonic() < end and process.poll() is None, (tmp_path / "told").read_text(
                    encoding="utf-8"
                )
                time.sleep(0.05)
            yield process, (tmp_path / "told").read_text(encoding="utf-8").split()[5]
        finally:
            kill_group(process.pid)
            process.wait()


# --- the command
def test_the_command_is_words_that_no_shell_reads() -> None:
    path = Path("/tmp/a 'b\" $c/d e.toml")
    assert command(path) == [sys.executable, "-m", "assistant", "session", str(path)]
    assert command(None) == [sys.executable, "-m", "assistant", "session"]


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


def test_a_design_with_mistakes_is_an_error_before_anything_is_served(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
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
def test_the_server_answers_its_own_page_only_and_ends_by_an_interrupt(
    served: tuple[subprocess.Popen[str], str], tmp_path: Path
) -> None:
    process, address = served
    own = address.partition("/?")[0]
    with urlopen(address, timeout=30) as answer:
        page, policy = answer.read().decode("utf-8"), answer.headers["Content-Security-Policy"]
    assert "https://" not in page and "onClick" not in page
    # the style sheet, the program of the page, its fonts
    for part in re.findall(r'(?:href|src)="([^"]*)"|src: url\("([^"]*)"\)', page):
        assert asked(urljoin(address, "".join(part))) == 200
    assert f"{own}/static/css/xterm.css" in page
    nonces = set(re.findall(r"<script([^>]*)>", page))
    (nonce,) = {re.findall(r'nonce="([^"]+)"', one)[0] for one in nonces}
    assert f"'nonce-{nonce}'" in policy and "frame-ancestors 'none'" in policy and "default-src 'none'" in policy
    assert (
        asked(own) == asked(f"{own}/?token=") == asked(f"{own}/?token=guessed") == asked(f"{own}/?token=%C3%A9") == 403
    )
    assert asked(address, Host="example.org") == 403  # a name that was made to point here
    assert asked(address, Origin="https://example.org") == 403
    assert asked(address, Origin=own) == 200
    assert asked(f"{own}/static/") in (403, 404)
    port = int(own.rpartition(":")[2])
    for no_http in (
        b"\0\xff" * 50 + b"\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n",
        b"GET " + b"/" * 100_000,
    ):  # answered, and not told
        with socket.create_connection(("127.0.0.1", port), timeout=30) as line:
            line.sendall(no_http)
            assert b" 400 " in line.recv(100)
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=30) == 0
    told = (tmp_path / "told").read_text(encoding="utf-8")
    assert told.splitlines() == [f"The guided session is at {address} (Ctrl+C ends it)"]


# --- a socket and its session
ECHO = """
import sys
read, write = sys.stdin.buffer.read, sys.stdout.buffer
write.write(b"__GANGLION__\\n")
write.flush()
while head := read(5):
    told = read(int.from_bytes(head[1:]))
    if told == b"hang":
        import time
        time.sleep(1000)
    if told == b"crash" or b'"quit"' in told:
        break
    write.write(b"D" + len(head[:1] + told).to_bytes(4) + head[:1] + told)
    write.flush()
"""  # a session that says what it is told


@pytest.fixture
async def echo() -> AsyncIterator[tuple[TestClient[Any, Any], Local]]:
    server = Local([sys.executable, "-c", ECHO], free_port())
    async with TestClient(TestServer(await server._make_app(), port=server.port)) as client:
        yield client, server


def socket_of(echo: tuple[TestClient[Any, Any], Local], **more: Any) -> Any:
    client, server = echo
    return client.ws_connect(f"/ws/{server.token}?width=90&height=30", **{"origin": f"http://{server.own}", **more})


async def test_the_address_is_a_secret_and_another_each_time(
    echo: tuple[TestClient[Any, Any], Local], capsys: pytest.CaptureFixture[str]
) -> None:
    client, server = echo
    assert len(server.token) >= 32 and Local([], 8000).token != server.token
    for path in ("/ws", "/ws/", "/ws/guessed", f"/ws/{server.token}x"):
        async with client.get(path, headers={"Origin": f"http://{server.own}"}) as answer:
            assert answer.status == 404
            assert "frame-ancestors 'none'" in answer.headers["Content-Security-Policy"]


@pytest.mark.parametrize("origin", [None, "null", "https://example.org", "http://127.0.0.1", "http://localhost:8000"])
async def test_a_socket_needs_the_origin_of_the_page(
    echo: tuple[TestClient[Any, Any], Local], origin: str | None
) -> None:
    with pytest.raises(WSServerHandshakeError) as refused:
        await socket_of(echo, origin=origin)
    assert refused.value.status == 403 and not echo[1].tabs


async def test_a_message_reaches_the_session_and_malformed_ones_do_not(
    echo: tuple[TestClient[Any, Any], Local],
) -> None:
    malformed = [
        "",
        "{",
        "null",
        "1",
        '"stdin"',
        "{}",
        "[]",
        '["stdin"]',
        '["stdin", 1]',
        '["stdin", null]',
        '["stdin", "a", "b"]',
        '["resize"]',
        '["resize", 1]',
        '["resize", {"width": "1", "height": 2}]',
        '["resize", {"width": 1}]',
        '["resize", {"width": 1.5, "height": NaN}]',
        '["ping"]',
        '["ping", {}]',
        '["quit"]',
        '[["stdin"]]',
        "[" * 100_000,
        '["stdin", "' + "a" * (PASTED + 1) + '"]',
        "1" * 5000,
    ]
    async with socket_of(echo) as socket:
        for message in malformed:
            await socket.send_str(message)
        await socket.send_bytes(b'["stdin", "binary"]')
        await socket.send_json(["stdin", "a\ud800ö"])
        assert await socket.receive_bytes() == "Daö".encode()
        await socket.send_json(["ping", "5"])
        assert await socket.receive_json() == ["pong", "5"]


@pytest.mark.parametrize(
    ("asked_for", "got"),
    [((100, 40), (100, 40)), ((10**9, 10**9), (COLUMNS, ROWS)), ((-1, 0), (80, 24)), ((10**400, 1), (COLUMNS, 1))],
)
async def test_a_terminal_has_a_size_that_can_be_laid_out(
    echo: tuple[TestClient[Any, Any], Local], asked_for: tuple[int, int], got: tuple[int, int]
) -> None:
    async with socket_of(echo) as socket:
        await socket.send_json(["resize", {"width": asked_for[0], "height": asked_for[1]}])
        told = json.loads((await socket.receive_bytes())[1:])
        assert (told["width"], told["height"]) == got


async def test_there_are_so_many_sessions_and_no_more(
    echo: tuple[TestClient[Any, Any], Local], monkeypatch: pytest.MonkeyPatch
) -> None:
    client, server = echo
    monkeypatch.setattr(serving, "SESSIONS", 2)
    first, second = await socket_of(echo), await socket_of(echo)
    with pytest.raises(WSServerHandshakeError) as refused:
        await socket_of(echo)
    assert refused.value.status == 503
    async with client.get("/", params={"token": server.token}) as answer:
        assert answer.status == 503 and "close the tab" in await answer.text()
    await first.close()
    await ended(server, 1)
    async with socket_of(echo) as third:
        await third.send_json(["stdin", "x"])
        assert await third.receive_bytes() == b"Dx"
    await second.close()


async def ended(server: Local, left: int = 0) -> None:
    """Wait until no more sessions than this are open."""
    async with asyncio.timeout(60):
        while len(server.tabs) > left:
            await asyncio.sleep(0.01)


@pytest.mark.parametrize("last", ["x", "hang"])
async def test_a_session_ends_with_its_socket(
    echo: tuple[TestClient[Any, Any], Local], monkeypatch: pytest.MonkeyPatch, last: str
) -> None:
    """One that does not listen any more, too."""
    monkeypatch.setattr(serving, "ENDING", 0.2)
    begun: list[serving.Session] = []
    start = serving.Session.start

    async def noted(self: serving.Session, width: int, height: int) -> None:
        begun.append(self)
        await start(self, width, height)

    monkeypatch.setattr(serving.Session, "start", noted)
    socket = await socket_of(echo)
    await socket.send_json(["stdin", last])
    await socket.close()
    await ended(echo[1])
    ((process,),) = [[session._process for session in begun]]
    assert process is not None
    assert await asyncio.wait_for(process.wait(), 60) is not None


async def test_a_socket_ends_with_its_session(echo: tuple[TestClient[Any, Any], Local]) -> None:
    async with socket_of(echo) as socket:
        await socket.send_json(["stdin", "crash"])
        assert (await socket.receive()).type in (WSMsgType.CLOSE, WSMsgType.CLOSED)
    await ended(echo[1])


async def test_a_message_too_long_ends_its_socket(echo: tuple[TestClient[Any, Any], Local]) -> None:
    async with socket_of(echo) as socket:
        await socket.send_str("a" * (MESSAGE_BYTES + 1))
        assert (await socket.receive()).type in (WSMsgType.CLOSE, WSMsgType.CLOSED)
    await ended(echo[1])


# --- in a browser
@posix
@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
async def test_a_design_is_edited_and_saved_in_a_browser(
    served: tuple[subprocess.Popen[str], str], design: Path, tmp_path: Path
) -> None:
    process, address = served
    before = design.read_bytes()
    async with browser(tmp_path) as page:
        await page.open(address)
        await page.until(lambda text: "my design.toml" in text and "solved in" in text and "Bore" in text)
        await page.press("Tab")  # from the engine of the catalogue to the bore
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
        assert page.asked and all(wanted.startswith(address.partition("/?")[0] + "/") for wanted in page.asked)
        assert not page.faults
        process.send_signal(signal.SIGINT)
        assert await asyncio.to_thread(process.wait, 30) == 0
    told = (tmp_path / "told").read_text(encoding="utf-8")
    assert told.splitlines() == [f"The guided session is at {address} (Ctrl+C ends it)"]


@posix
@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
async def test_a_session_that_was_left_begins_again_from_its_page(
    served: tuple[subprocess.Popen[str], str], tmp_path: Path
) -> None:
    """Its button works, and nothing of the page is against its own policy; what somebody puts into the page is."""
    _, address = served
    async with browser(tmp_path) as page:
        await page.open(address)
        await page.until(lambda text: "my design.toml" in text and "solved in" in text)
        await page.press("q", ctrl=True)
        async with asyncio.timeout(60):
            while not await page.value("document.body.classList.contains('-closed')"):
                await asyncio.sleep(0.05)
        assert await page.value("JSON.stringify(refused)") == "[]"
        await page.value("caught = null; document.querySelector('.closed-dialog button').click()")
        await page.until(lambda text: "my design.toml" in text and "solved in" in text)
        await page.value("document.body.insertAdjacentHTML('beforeend', '<img src=x onerror=alert(1)>')")
        async with asyncio.timeout(60):
            while "script-src" not in await page.value("JSON.stringify(refused)"):
                await asyncio.sleep(0.05)


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
    """Letters, rules and colours stand where a terminal has them, from edge to edge, also after the window has
    changed."""
    _, address = served
    async with browser(tmp_path) as page:
        for size in ((width, height), (width - 300, height - 200)):
            await page.tell(
                "Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=1, mobile=False
            )
            if not page.asked:
                await page.open(address)
            await page.until(lambda text: "my design.toml" in text and "solved in" in text and "Bore" in text)
            end = time.monotonic() + 30
            while not _filled(await page.box(".xterm-screen"), size):
                assert time.monotonic() < end, await page.box(".xterm-screen")
                await asyncio.sleep(0.1)
            assert await page.value("document.activeElement.className") == "xterm-helper-textarea"
            assert (
                await page.value("getComputedStyle(document.querySelector('.xterm-viewport')).position") == "absolute"
            )
        assert not page.faults
