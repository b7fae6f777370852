# SPDX-License-Identifier: Apache-2.0
"""The guided session in a browser: a page, a socket for each tab, and a session behind each socket.

The sessions read and write the files of whoever started the server.  So the way to them is a secret: whoever has the
address may use it, other users of the machine and pages of other sites may not.  What comes through a socket is checked
before a session gets it."""

from __future__ import annotations

import asyncio
import json
import logging
import re
import secrets
from asyncio.subprocess import PIPE, Process
from collections.abc import Awaitable, Callable
from typing import Any, cast

import aiohttp_jinja2
import jinja2
from aiohttp import WSMsgType, web
from aiohttp.http_exceptions import HttpProcessingError
from aiohttp.log import server_logger
from textual_serve.app_service import AppService
from textual_serve.server import Server

from calc.design.limits import COLUMNS, HOST, MESSAGE_BYTES, PASTED, ROWS, SESSIONS

ENDING = 10.0  # seconds that a session has to put its edits aside
LAST = 1.0  # and its process after that
OUTSIDE = re.compile(r'<link\b[^>]*href="https://[^>]*>')  # the page would ask a font host for what lies beside it
CLICKED = ' onClick="refresh()"'  # which a page of this policy does not obey
# The font is there before the terminal counts its columns by it; keys go to the terminal from the first one on, and
# after every click.
PAGE = """<style>
      @font-face { font-family: "Roboto Mono"; font-weight: 100 700; src: url("/static/fonts/RobotoMono-VariableFont_wght.ttf"); }
      @font-face {
        font-family: "Roboto Mono"; font-weight: 100 700; font-style: italic;
        src: url("/static/fonts/RobotoMono-Italic-VariableFont_wght.ttf");
      }
      html, body { height: 100%; overflow: hidden; background: #121212 !important; }
    </style>
    <script>
      addEventListener("DOMContentLoaded", () => {
        const begin = window.onload;
        const focus = () => document.querySelector(".xterm-helper-textarea")?.focus();
        window.onload = async (event) => {
          await Promise.all(["", "bold ", "italic "].map((style) => document.fonts.load(style + "16px 'Roboto Mono'")));
          begin(event);
          focus();
        };
        addEventListener("focus", focus);
        document.querySelectorAll("button").forEach((button) => button.addEventListener("click", refresh));
      });
    </script>"""  # noqa: E501
# Nothing from elsewhere; of what stands in the page itself only the scripts that carry this answer's number.  The
# terminal makes styles.
POLICY = (
    "default-src 'none'; script-src 'self' 'nonce-{nonce}'; style-src 'self' 'unsafe-inline'; font-src 'self'; "
    "img-src 'self' data:; "
    "connect-src 'self' ws://{host}; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
HEADERS = {
    "Content-Security-Policy": "default-src 'none'; frame-ancestors 'none'",
    "X-Frame-Options": "DENY",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cache-Control": "no-store",
}


class Session(AppService):
    """A session in a process of its own, which is told of what happens in its tab."""

    def __init__(self, words: list[str], socket: web.WebSocketResponse, server: Local) -> None:
        close = cast(Callable[[], Awaitable[None]], socket.close)
        super().__init__(
            "",
            write_bytes=socket.send_bytes,
            write_str=socket.send_str,
            close=close,
            download_manager=server.download_manager,
        )
        self.words = words

    async def _open_app_process(self, width: int = 80, height: int = 24) -> Process:
        environment = self._build_environment(width=width, height=height)
        process = await asyncio.create_subprocess_exec(
            *self.words, stdin=PIPE, stdout=PIPE, stderr=PIPE, env=environment
        )
        self._process, self._stdin = process, process.stdin
        return process

    async def run(self) -> None:
        """Until it ends, and its tab with it."""
        try:
            await super().run()
        finally:
            await self.remote_close()

    async def stop(self) -> None:
        """Its edits are put aside; one that does not end is ended."""
        try:
            await asyncio.wait_for(super().stop(), ENDING)
            if self._process is not None:
                await asyncio.wait_for(self._process.wait(), LAST)
        except TimeoutError:
            pass
        finally:
            if self._process is not None:
                if self._process.returncode is None:
                    self._process.kill()
                self.stdin.close()
                await self._process.wait()

    async def take(self, message: list[Any]) -> None:
        """One message of the page; one that says nothing that is known is dropped."""
        match message:
            case ["stdin", str(text)] if len(text) <= PASTED:
                await self.send_bytes(text.encode("utf-8", "ignore"))
            case ["resize", {"width": int(width), "height": int(height)}]:
                await self.set_terminal_size(*_size(width, height))
            case ["blur", *_]:
                await self.blur()
            case ["focus", *_]:
                await self.focus()


class Local(Server):
    """Quiet, with nothing asked of other hosts, and open to nobody but who has its address."""

    def __init__(self, words: list[str], port: int) -> None:
        super().__init__("", host=HOST, port=port, title="Contralbero")
        self.words = words
        self.token = secrets.token_urlsafe(32)
        self.own = HOST if port == 80 else f"{HOST}:{port}"
        self.tabs: set[asyncio.Task[Any]] = set()

    @property
    def address(self) -> str:
        return f"{self.public_url}/?token={self.token}"

    def serve(self, debug: bool = False) -> None:
        """Until an interrupt; the address is said as soon as it can be used."""

        def told(_: str) -> None:
            print(f"The guided session is at {self.address} (Ctrl+C ends it)", flush=True)

        server_logger.addFilter(_own)
        web.run_app(self._make_app(), host=HOST, port=self.port, access_log=None, print=told)

    async def _make_app(self) -> web.Application:
        app = web.Application(middlewares=[self._only_own])
        aiohttp_jinja2.setup(app, loader=jinja2.FileSystemLoader(self.templates_path))
        app.add_routes(
            [
                web.get("/", self.handle_index, name="index"),
                web.get(f"/ws/{self.token}", self.handle_websocket, name="websocket"),
                web.static("/static", self.statics_path, name="static"),
            ]
        )
        app.on_shutdown.append(self.on_shutdown)
        app.on_response_prepare.append(_guarded)
        return app

    @web.middleware
    async def _only_own(self, request: web.Request, handler: Any) -> web.StreamResponse:
        """A page of another site that is open in the same browser must not reach a session, nor a name that was made to
        point here."""
        origin = request.headers.get("Origin")  # which a browser names with every socket
        stranger = origin != f"http://{self.own}" if origin is not None else request.path.startswith("/ws")
        if request.host != self.own or stranger:
            raise web.HTTPForbidden(text="Only the page of this program may talk to it.")
        return cast(web.StreamResponse, await handler(request))

    async def handle_index(self, request: web.Request) -> web.Response:
        if not secrets.compare_digest(request.query.get("token", "").encode(), self.token.encode()):
            raise web.HTTPForbidden(
                text="The address lacks its token; take the whole address that `contralbero serve` printed."
            )
        self._demand_room()
        page: Any = await super().handle_index(request)
        nonce = secrets.token_urlsafe(16)
        text = OUTSIDE.sub(lambda _: PAGE, page.text).replace(CLICKED, "")
        page.text = text.replace("<script", f'<script nonce="{nonce}"')
        page.headers["Content-Security-Policy"] = POLICY.format(nonce=nonce, host=self.own)
        return cast(web.Response, page)

    def _demand_room(self) -> None:
        if len(self.tabs) >= SESSIONS:
            raise web.HTTPServiceUnavailable(
                text=f"{SESSIONS} sessions are open, and no more are allowed; close the tab of one."
            )

    async def handle_websocket(self, request: web.Request) -> web.WebSocketResponse:
        """A session for as long as its socket is open."""
        self._demand_room()
        task = asyncio.current_task()
        assert task is not None
        self.tabs.add(task)
        socket = web.WebSocketResponse(heartbeat=15, max_msg_size=MESSAGE_BYTES)
        session = Session(self.words, socket, self)
        try:
            await socket.prepare(request)
            await session.start(*_size(*(_number(request.query.get(key, "")) for key in ("width", "height"))))
            async for message in socket:
                decoded = _decoded(message)
                if decoded[:1] == ["ping"] and len(decoded) == 2 and isinstance(decoded[1], str):
                    await socket.send_json(["pong", decoded[1][:100]])
                else:
                    await asyncio.wait_for(session.take(decoded), ENDING)
        except asyncio.CancelledError:
            await socket.close()
        except (ConnectionError, TimeoutError):
            pass  # the tab was closed while something was on the way to it, or its session takes nothing any more
        finally:
            try:
                await session.stop()
            finally:
                self.tabs.discard(task)
        return socket

    async def on_shutdown(self, app: web.Application) -> None:
        """The sessions end with the server, and not a minute later."""
        for task in self.tabs:
            task.cancel()
        if self.tabs:
            await asyncio.wait(self.tabs, timeout=ENDING + 2 * LAST)


def _own(record: logging.LogRecord) -> bool:
    """Whether it is a fault of this program, to be told: a request that is no HTTP is answered, and any user of the
    machine can send a thousand."""
    return record.exc_info is None or not isinstance(record.exc_info[1], HttpProcessingError)


async def _guarded(request: web.Request, response: web.StreamResponse) -> None:
    for name, value in HEADERS.items():
        response.headers.setdefault(name, value)


def _decoded(message: Any) -> list[Any]:
    """What a message says; nothing, if it is no list in JSON."""
    if message.type is not WSMsgType.TEXT:
        return []
    try:
        decoded = json.loads(message.data)
    except (ValueError, RecursionError):
        return []
    return decoded if isinstance(decoded, list) else []


def _number(digits: str) -> int:
    """Of an address; 0 for anything else."""
    return int(digits) if digits.isascii() and digits.isdigit() and len(digits) < 10 else 0


def _size(width: int, height: int) -> tuple[int, int]:
    """A terminal that a session can be laid out in; of one without a size the usual."""
    return min(width, COLUMNS) if width > 0 else 80, min(height, ROWS) if height > 0 else 24
