# SPDX-License-Identifier: Apache-2.0
"""The command line as a test calls it: in a process of its own, as a user does, or in that of the test, which is four
times as fast."""

import io
import os
import subprocess
import sys
from contextlib import chdir, redirect_stderr, redirect_stdout
from pathlib import Path

from assistant.cli import main
from tests.conftest import ROOT

Done = subprocess.CompletedProcess[str]


def run(*arguments: object, cwd: Path = ROOT) -> Done:
    """In this process; an error that nobody expects is that of the test."""
    said = list(map(str, arguments))
    with chdir(cwd), redirect_stdout(io.StringIO()) as out, redirect_stderr(io.StringIO()) as err:
        code = main(said)
    return Done(said, code, out.getvalue(), err.getvalue())


def run_apart(*arguments: object, cwd: Path = ROOT) -> Done:
    """In a process of its own: how it starts, what it imports, and the code that it ends with."""
    said, env = list(map(str, arguments)), {**os.environ, "PYTHONPATH": str(ROOT)}
    return subprocess.run([sys.executable, "-m", "assistant", *said], capture_output=True, text=True, cwd=cwd, env=env)
