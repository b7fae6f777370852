# SPDX-License-Identifier: Apache-2.0
"""A headless Chromium, driven over its DevTools protocol, and what the terminal in its page shows."""

import asyncio
import itertools
import json
import shutil
import signal
import time
from base64 import b64decode
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from aiohttp import ClientSession, ClientWebSocketResponse, WSMsgType

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
LIMIT = 60.0  # seconds for anything that a page has to come to
SWITCHES = """--headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking --disable-component-update --disable-sync --disable-quic
--disable-dev-shm-usage --remote-debugging-port=0 --window-size=1200,800""".split()
# The page keeps its terminal to itself; it is caught as it takes on its first part, and read by its own buffer.
CATCH = """Object.defineProperty(Object.prototype, "fitAddon", {configurable: true, set(part) {
  Object.defineProperty(this, "fitAddon", {value: part, writable: true}); window.caught = this.terminal;
}});
window.refused = [];
addEventListener("securitypolicyviolation", (event) => refused.push(`${event.violatedDirective} ${event.blockedURI} ${event.lineNumber}`));"""
READ = """(() => { const b = window.caught && window.caught.buffer.active, lines = [];
  for (let i = 0; b && i < b.length; i++) lines.push(b.getLine(i).translateToString(true));
  return lines.join("\\n"); })()"""
KEYS = {"Tab": 9, "Enter": 13, "Escape": 27, "ArrowDown": 40, "F1": 112, "F3": 114}


class Page:
    """One page, which is told what to do and asked what it holds."""

    def __init__(self, socket: ClientWebSocketResponse) -> None:
        self._socket = socket
        self._numbers = itertools.count(1)
        self._answers: dict[int, asyncio.Future[Any]] = {}
        self._reader = asyncio.create_task(self._read())
        self.asked: list[str] = []  # every address that the page wanted
        self.faults: list[str] = []

    async def _read(self) -> None:
        async for message in self._socket:
            if message.type is not WSMsgType.TEXT:
                continue
            found = json.loads(message.data)
            if found.get("id") in self._answers:
                self._answers.pop(found["id"]).set_result(found)
            elif found.get("method") == "Network.requestWillBeSent":
                self.asked.append(found["params"]["request"]["url"])
            elif found.get("method") == "Runtime.exceptionThrown":
                self.faults.append(str(found["params"]["exceptionDetails"]))

    async def tell(self, method: str, **parameters: Any) -> Any:
        number = next(self._numbers)
        answer = self._answers[number] = asyncio.get_running_loop().create_future()
        await self._socket.send_json({"id": number, "method": method, "params": parameters})
        found = await asyncio.wait_for(answer, LIMIT)
        assert "error" not in found, found
        return found["result"]

    async def open(self, address: str) -> None:
        for domain in ("Page", "Runtime", "Network"):
            await self.tell(f"{domain}.enable")
        await self.tell("Page.addScriptToEvaluateOnNewDocument", source=CATCH)
        await self.tell("Page.navigate", url=address)

    async def value(self, script: str) -> Any:
        return (await self.tell("Runtime.evaluate", expression=script, awaitPromise=True))["result"].get("value")

    async def text(self) -> str:
        """What the terminal shows."""
        return str(await self.value(READ) or "")

    async def until(self, holds: Callable[[str], bool]) -> str:
        """Wait until the terminal shows something; gives all that it shows."""
        end, text = time.monotonic() + LIMIT, ""
        while time.monotonic() < end:
            if holds(text := await self.text()):
                return text
            await asyncio.sleep(0.1)
        raise AssertionError(f"it never came to that; {self.faults}\n{text}")

    async def box(self, selector: str) -> list[float]:
        """Left, top, right and bottom of a part of the page, in its pixels."""
        found = await self.value(
            f"(() => {{ const r = document.querySelector('{selector}').getBoundingClientRect();"
            " return JSON.stringify([r.left, r.top, r.right, r.bottom]); })()"
        )
        return list(json.loads(found))

    async def picture(self, path: Path) -> None:
        path.write_bytes(b64decode((await self.tell("Page.captureScreenshot"))["data"]))

    async def type(self, text: str) -> None:
        await self.tell("Input.insertText", text=text)

    async def press(self, key: str, ctrl: bool = False) -> None:
        code = KEYS.get(key) or ord(key.upper())
        about = {
            "key": key,
            "code": key if key in KEYS else f"Key{key.upper()}",
            "windowsVirtualKeyCode": code,
            "modifiers": 2 if ctrl else 0,
        }
        await self.tell("Input.dispatchKeyEvent", type="rawKeyDown", **about)
        await self.tell("Input.dispatchKeyEvent", type="keyUp", **about)

    async def close(self) -> None:
        self._reader.cancel()
        await self._socket.close()


@asynccontextmanager
async def browser(folder: Path) -> AsyncIterator[Page]:
    """A browser of its own, with nothing remembered, and its one page."""
    assert CHROMIUM is not None
    home = folder / "browser"
    process = await asyncio.create_subprocess_exec(
        CHROMIUM,
        *SWITCHES,
        f"--user-data-dir={home}",
        "about:blank",
        stdin=asyncio.subprocess.DEVNULL,
        stdout=asyncio.subprocess.DEVNULL,
        stderr=asyncio.subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        end = time.monotonic() + LIMIT
        while not (home / "DevToolsActivePort").is_file() or "\n" not in (home / "DevToolsActivePort").read_text():
            assert time.monotonic() < end and process.returncode is None, "the browser does not start"
            await asyncio.sleep(0.05)
        port = (home / "DevToolsActivePort").read_text().split()[0]
        async with ClientSession() as client:
            address = ""
            while not address:
                assert time.monotonic() < end, "the browser has no page"
                async with client.get(f"http://127.0.0.1:{port}/json") as answer:
                    address = next(
                        (page["webSocketDebuggerUrl"] for page in await answer.json() if page["type"] == "page"), ""
                    )
            page = Page(await client.ws_connect(address, max_msg_size=0))
            try:
                yield page
            finally:
                await page.close()
    finally:
        kill_group(process.pid)
        await process.wait()


def kill_group(leader: int) -> None:
    """A process and all that it started."""
    import os

    try:
        os.killpg(leader, signal.SIGKILL)
    except ProcessLookupError:
        pass
