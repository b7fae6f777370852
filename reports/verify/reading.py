# SPDX-License-Identifier: Apache-2.0
"""What stands in the PDF of a stranger, read in a process of its own that has only so much time and memory."""

import base64
import io
import json
import os
import subprocess
import sys
from collections.abc import Callable
from typing import Any

from calc.design.limits import PDF_MEMORY


class Refused(Exception):
    """Why a file is not what it was asked to be, in words."""


def apart(seconds: float, task: Callable[..., Any], raw: bytes, *numbers: int) -> Any:
    """What `task(raw, *numbers)` gives, computed in another process.  Raises Refused, whatever breaks there."""
    code = f"from {task.__module__} import {task.__name__} as task; import {__name__} as it; it.answer(task, {numbers})"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    try:
        run = subprocess.run(
            [sys.executable, "-c", code], input=raw, capture_output=True, timeout=seconds, env=environment
        )
        given, why = json.loads(run.stdout)
    except subprocess.TimeoutExpired:
        raise Refused(f"takes more than {seconds} s to read") from None
    except ValueError:
        raise Refused("can not be read: it broke its reader") from None
    if why:
        raise Refused(why)
    return given


def answer(task: Callable[..., Any], numbers: tuple[int, ...]) -> None:
    """In the other process: of the file that comes in, what the task gives, or why it does not."""
    try:
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (PDF_MEMORY, PDF_MEMORY))
    except (ImportError, OSError, ValueError):  # not every system limits memory; time is limited everywhere
        pass
    try:
        given, why = task(sys.stdin.buffer.read(), *numbers), ""
    except Refused as no:
        given, why = None, str(no)
    except Exception as error:  # whatever a file of a stranger does to its reader
        given, why = None, f"can not be read ({type(error).__name__}: {error})"[:100]
    json.dump([given, why], sys.stdout)


def keywords_and_files(raw: bytes) -> tuple[str, dict[str, list[str]]]:
    """What a PDF says of itself, and the files inside it by their names, in base 64."""
    from pypdf import PdfReader

    reader = PdfReader(io.BytesIO(raw))
    if reader.is_encrypted:
        raise Refused("is encrypted; give the report as it was written")
    keywords = str(reader.metadata.get("/Keywords", "")) if reader.metadata is not None else ""
    files = {str(name): [base64.b64encode(one).decode() for one in some] for name, some in reader.attachments.items()}
    return keywords, files
