# SPDX-License-Identifier: Apache-2.0
"""The PDF of a stranger: its streams, and what a reader of PDF says of it, in a process of its own."""

import json
import os
import re
import subprocess
import sys
import zlib
from collections.abc import Callable
from typing import Any

from calc.design.limits import APPENDED_MEMORY, APPENDED_SECONDS, PDF_UNPACKED

STREAM = re.compile(rb"stream\r?\n")


class Refused(Exception):
    """Why a file is not what it was asked to be, in words."""


def packed(raw: bytes) -> list[bytes]:
    """Whatever streams a file has, unpacked where they are deflated; nothing else of it is read.  Raises Refused."""
    if b"/Encrypt" in raw:
        raise Refused("is encrypted; give the report as it was written")
    streams, left = [], PDF_UNPACKED
    for piece in raw.split(b"endstream"):
        if (start := STREAM.search(piece)) is None:
            continue
        data = piece[start.end() :]
        try:
            streams.append(zlib.decompressobj().decompress(data, left))
        except zlib.error:
            streams += [data, data.removesuffix(b"\n"), data.removesuffix(b"\r\n")]
        left -= len(streams[-1])
        if left <= 0:
            raise Refused(f"holds more than {PDF_UNPACKED:,} bytes")
    return streams


def apart(task: Callable[..., Any], raw: bytes, *numbers: int) -> Any:
    """What `task(raw, *numbers)` gives in another process, with so much time and memory.  Raises Refused, whatever
    breaks there."""
    code = f"from {task.__module__} import {task.__name__} as task; import {__name__} as it; it.answer(task, {numbers})"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    try:
        run = subprocess.run(
            [sys.executable, "-c", code], input=raw, capture_output=True, timeout=APPENDED_SECONDS, env=environment
        )
        given, why = json.loads(run.stdout)
    except subprocess.TimeoutExpired:
        raise Refused(f"takes more than {APPENDED_SECONDS} s to read") from None
    except ValueError:
        raise Refused("can not be read: it broke its reader") from None
    if why:
        raise Refused(why)
    return given


def answer(task: Callable[..., Any], numbers: tuple[int, ...]) -> None:
    """In the other process: of the file that comes in, what the task gives, or why it does not."""
    try:
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (APPENDED_MEMORY, APPENDED_MEMORY))
    except (ImportError, OSError, ValueError):  # not every system limits memory; time is limited everywhere
        pass
    try:
        given, why = task(sys.stdin.buffer.read(), *numbers), ""
    except Refused as no:
        given, why = None, str(no)
    except Exception as error:  # whatever a file of a stranger does to its reader
        given, why = None, f"can not be read ({type(error).__name__}: {error})"[:100]
    json.dump([given, why], sys.stdout)
