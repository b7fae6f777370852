# SPDX-License-Identifier: Apache-2.0
"""`contralbero serve`: the guided session in a browser, on this machine only; each tab is a session of its own."""

import asyncio
import logging
import os
import re
import shlex
import socket
import subprocess
import sys
from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from calc.design_file import design, read
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text

if TYPE_CHECKING:
    from textual_serve.server import Server

HOST = "127.0.0.1"
OUTSIDE = re.compile(r'<link\b[^>]*href="https://[^>]*>')  # the page would ask a font host for what lies beside it
# The font is there before the terminal counts its columns by it; keys go to the terminal from the first one on, and after every click.
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
      });
    </script>"""
ENDING = 10.0  # seconds that the open sessions have to put their edits aside


def run(asked: Namespace) -> int:
    path = None
    if asked.file is not None:
        design(read(asked.file))  # a design with mistakes is an error here, not an empty page
        path = Path(asked.file).absolute()
    probe(asked.port)
    os.environ["PYTHONIOENCODING"] = "utf-8"  # of the sessions: a browser shows every sign
    try:
        _server(command(path), asked.port).serve()
    except OSError as error:  # somebody else was quicker
        raise _port(asked.port, Text("can not be used: {reason}", reason=error.strerror or str(error))) from None
    return 0


def command(path: Path | None) -> str:
    """The command line of one session, by this very interpreter."""
    words = [sys.executable, "-m", "assistant", "session", *([str(path)] if path is not None else [])]
    return subprocess.list2cmdline(words) if os.name == "nt" else shlex.join(words)


def probe(port: int) -> None:
    """Whether the port can be had.  Raises BadInput."""
    if not 1 <= port <= 65535:
        raise _port(port, Text("is out of range; a port is a whole number from 1 to 65535"))
    with socket.socket() as trial:
        if os.name == "posix":  # elsewhere it would allow a port that is taken
            trial.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            trial.bind((HOST, port))
        except PermissionError:
            raise _port(port, Text("is kept for the administrator; give one from 1024 to 65535")) from None
        except OSError:
            raise _port(port, Text("is taken by another program; give another one with --port")) from None


def _port(port: int, reason: Text) -> BadInput:
    return BadInput("serve", [InputError(0, "--port", str(port), reason)])


def _server(command: str, port: int) -> "Server":
    from aiohttp import web
    from textual_serve.server import Server

    class Local(Server):
        """Quiet, with nothing asked of other hosts, and open to nobody's pages but its own."""

        def __init__(self) -> None:
            super().__init__(command, host=HOST, port=port, title="Contralbero")
            self.tabs: set[asyncio.Task[Any]] = set()

        def initialize_logging(self) -> None:
            logging.basicConfig(level=logging.WARNING, format="%(message)s")

        async def _make_app(self) -> web.Application:
            made = await super()._make_app()
            made.middlewares.append(own_page)
            return made

        async def on_startup(self, app: web.Application) -> None:
            print(f"The guided session is at {self.public_url} (Ctrl+C ends it)", flush=True)

        async def handle_index(self, request: web.Request) -> web.Response:
            page: Any = await super().handle_index(request)
            page.text = OUTSIDE.sub(lambda _: PAGE, page.text)
            return cast(web.Response, page)

        async def handle_websocket(self, request: web.Request) -> web.WebSocketResponse:
            task = asyncio.current_task()
            assert task is not None
            self.tabs.add(task)
            try:
                return await super().handle_websocket(request)
            finally:
                self.tabs.discard(task)

        async def on_shutdown(self, app: web.Application) -> None:
            """The sessions end with the server, and not a minute later."""
            for task in self.tabs:
                task.cancel()
            if self.tabs:
                await asyncio.wait(self.tabs, timeout=ENDING)

    @web.middleware
    async def own_page(request: web.Request, handler: Any) -> web.StreamResponse:
        """There is no login; so a page of another site that is open in the same browser must not reach the session."""
        own = {f"{name}:{port}" for name in (HOST, "localhost")} | ({HOST, "localhost"} if port == 80 else set())
        origin = request.headers.get("Origin")
        stranger = origin is not None and origin not in {f"http://{name}" for name in own}
        if request.host not in own or stranger or (origin is None and request.path == "/ws"):  # a browser names the origin of a socket
            raise web.HTTPForbidden(text="Only the page of this program may talk to it.")
        return cast(web.StreamResponse, await handler(request))

    return Local()
