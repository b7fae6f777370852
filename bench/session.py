# SPDX-License-Identifier: Apache-2.0
"""How quick the guided session feels, measured in a real pseudo-terminal: `python -m bench.session`.

First paint beside a bare interpreter, a key's echo while the design is solved again, the results after the last key, and the
change of step.  Times depend on the machine; the bare interpreter is there to compare with.
"""

import fcntl
import os
import pty
import re
import select
import signal
import statistics
import struct
import sys
import tempfile
import termios
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DESIGN = ROOT / "designs" / "r753ie4_gamma.toml"
PAINTED = re.compile(rb"Crank radius")  # a label of the first form
SOLVED = re.compile(rb"solved in")


class Terminal:
    """A program in a pseudo-terminal of its own."""

    def __init__(self, arguments: list[str], columns: int = 120, rows: int = 40) -> None:
        self.state = tempfile.TemporaryDirectory()
        environment = {
            **os.environ,
            "XDG_STATE_HOME": self.state.name,
            "TERM": "xterm-256color",
            "COLUMNS": str(columns),
            "LINES": str(rows),
        }
        self.started = time.perf_counter()
        self.pid, self.file = pty.fork()
        if self.pid == 0:
            os.chdir(ROOT)
            os.execve(sys.executable, [sys.executable, *arguments], environment)
        fcntl.ioctl(self.file, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
        self.seen = b""

    def read(self, wait: float) -> bytes:
        ready, _, _ = select.select([self.file], [], [], wait)
        if not ready:
            return b""
        try:
            got = os.read(self.file, 1 << 16)
        except OSError:
            return b""
        self.seen += got
        return got

    def until(self, pattern: re.Pattern[bytes], limit: float = 15.0) -> float:
        """Seconds until something was written that matches."""
        begin, start = time.perf_counter(), len(self.seen)
        while time.perf_counter() - begin < limit:
            self.read(0.05)
            if pattern.search(self.seen, max(0, start - 200)):
                return time.perf_counter() - begin
        raise TimeoutError(pattern)

    def key(self, keys: bytes, quiet: float = 0.25) -> tuple[float, float]:
        """Seconds until the first and until the last byte that a key causes."""
        self.drain()
        begin = time.perf_counter()
        os.write(self.file, keys)
        first = last = 0.0
        while time.perf_counter() - begin < 5:
            if self.read(quiet):
                last = time.perf_counter() - begin
                first = first or last
            elif last:
                break
        return first, last

    def drain(self, quiet: float = 0.3) -> None:
        while self.read(quiet):
            pass

    def end(self) -> int:
        os.write(self.file, b"\x11")  # ctrl+q
        deadline = time.perf_counter() + 5
        while time.perf_counter() < deadline:
            self.read(0.05)
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                return os.waitstatus_to_exitcode(status)
        os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)
        return -1


def bare() -> float:
    """Seconds for an interpreter that does nothing."""
    begin = time.perf_counter()
    os.waitpid(os.spawnv(os.P_NOWAIT, sys.executable, [sys.executable, "-c", "pass"]), 0)
    return time.perf_counter() - begin


def report(name: str, seconds: list[float]) -> None:
    median, best, worst = (1000 * f(seconds) for f in (statistics.median, min, max))
    print(f"{name:<34} median {median:7.0f} ms   best {best:7.0f}   worst {worst:7.0f}   n = {len(seconds)}")


def main(rounds: int = 5) -> None:
    report("bare interpreter", [bare() for _ in range(rounds)])
    paints, solves = [], []
    for _ in range(rounds):
        terminal = Terminal(["-m", "assistant.app", str(DESIGN)])
        terminal.until(PAINTED)
        paints.append(time.perf_counter() - terminal.started)
        terminal.until(SOLVED)
        solves.append(time.perf_counter() - terminal.started)
        terminal.end()
    report("start to first paint", paints)
    report("start to first results", solves)
    for columns, rows in ((80, 24), (120, 40), (200, 60)):
        terminal = Terminal(["-m", "assistant.app", str(DESIGN)], columns, rows)
        terminal.until(SOLVED)
        terminal.drain()
        for _ in range(4):
            terminal.key(b"\x1b[B")  # down: to a number
        echoes, ends = zip(*(terminal.key(digit) for digit in (b"9", b"4", b".", b"5", b"\x7f", b"6", b"\x7f", b"\x7f")))
        report(f"{columns}x{rows}: key to echo", list(echoes))
        report(f"{columns}x{rows}: key to results, last paint", list(ends))
        report(f"{columns}x{rows}: next step, new form", [terminal.key(b"\x1bOR")[1] for _ in range(5)])
        report(f"{columns}x{rows}: step before, known form", [terminal.key(b"\x1bOQ")[1] for _ in range(5)])
        if code := terminal.end():
            print(f"ended with {code}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 5)
