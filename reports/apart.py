# SPDX-License-Identifier: Apache-2.0
"""A task that reads what a stranger has written, in a process of its own with only so much time and memory."""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from typing import Any

from calc.design.limits import APPENDED_MEMORY, APPENDED_SECONDS


class Refused(Exception):
    """Why a file is not what it was asked to be, in words."""


def demand(right: bool, otherwise: str) -> None:
    if not right:
        raise Refused(otherwise)


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
        given, why = None, str(no)[:200]
    except Exception as error:  # whatever a file of a stranger does to its reader
        given, why = None, f"can not be read ({type(error).__name__}: {error})"[:100]
    json.dump([given, why], sys.stdout)
