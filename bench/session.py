# SPDX-License-Identifier: Apache-2.0
"""How quick the guided session feels, measured in a real pseudo-terminal: `python -m bench.session [ROUNDS]`.

First paint of the start page and of a design, the echo of keys while the design is solved again, the findings after the
last key, the first visit of every step with its picture and the way back, and what opens over them; each in
milliseconds and as a multiple of what a bare interpreter takes in the same run, because times depend on the machine.
Where another program takes the processor, the best of several runs says most.  Ceilings: first paint 700 ms, an echo 30
ms at the median, findings 250 ms after the last key.
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
STARTED = re.compile(rb"Open a file")  # a row of the start page
PAINTED = re.compile(rb"Rod length")  # a label of the first form
SOLVED = re.compile(rb"solved in|FAIL: ")  # the latter where there is no room for both
JUDGED = re.compile(rb"(judged|solved) in")  # what an edit paints again with its verdicts, and nothing else does
NEXT, BEFORE, FIX, LEAVE = b"\x1bOR", b"\x1bOQ", b"\x1b[15~", b"\x1b"  # F3, F2, F5, Esc
STEPS = ("imbalance", "countershaft", "bearings", "gears", "friction")  # behind the one that is there at first
TYPED = (("engine.bore", b"94."), ("imbalance.crank_balance_fraction", b"0."))  # a field, and how a number in it begins


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
        environment.pop("PYTHONDONTWRITEBYTECODE", None)  # as a user's, which keeps what it has compiled
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
            if pattern.search(self.seen, start):
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


def report(name: str, seconds: list[float], unit: float) -> None:
    median, best, worst = (1000 * f(seconds) for f in (statistics.median, min, max))
    print(
        f"{name:<60} median {median:5.0f} ms ={median / unit / 1000:6.2f} ×  best {best:5.0f}  worst {worst:5.0f}  "
        f"n = {len(seconds)}"
    )


def typed(terminal: Terminal, keys: bytes, pause: float = 0.06) -> list[float]:
    """Keys one after the other as a quick typist strikes them, each with the time until something is painted; solves
    run all along."""
    echoes = []
    for key in keys:
        begin = time.perf_counter()
        os.write(terminal.file, bytes([key]))
        while not terminal.read(0.5):
            if time.perf_counter() - begin > 10:
                raise TimeoutError(keys)
        echoes.append(time.perf_counter() - begin)
        while (left := begin + pause - time.perf_counter()) > 0:
            terminal.read(left)
    return echoes


def results(terminal: Terminal, key: bytes) -> float:
    """From a single key to the results of it."""
    terminal.drain()
    os.write(terminal.file, key)
    return terminal.until(JUDGED, limit=10)


def starts(rounds: int, unit: float) -> None:
    """The first picture of the start page and of a design, and the first results."""
    pages, paints, solves = [], [], []
    for _ in range(rounds + 1):
        terminal = Terminal(["-m", "assistant.app"])
        terminal.until(STARTED)
        pages.append(time.perf_counter() - terminal.started)
        terminal.end()
        terminal = Terminal(["-m", "assistant.app", str(DESIGN)])
        terminal.until(PAINTED)
        paints.append(time.perf_counter() - terminal.started)
        terminal.until(SOLVED)
        solves.append(time.perf_counter() - terminal.started)
        terminal.end()
    report("start page, first paint", pages[1:], unit)  # the first one compiles
    report("design, first paint", paints[1:], unit)
    report("design, first results", solves[1:], unit)


def opened(columns: int, rows: int) -> Terminal:
    terminal = Terminal(["-m", "assistant.app", str(DESIGN)], columns, rows)
    terminal.until(SOLVED)
    terminal.drain()
    return terminal


def visits(size: str, columns: int, rows: int, rounds: int, unit: float) -> None:
    """Every step for the first time, each round in a session of its own; then back over forms that are there, and the
    list of remedies."""
    first: dict[str, list[float]] = {step: [] for step in STEPS}
    back, fixes = [], []
    for _ in range(rounds):
        terminal = opened(columns, rows)
        for step in STEPS:
            first[step].append(terminal.key(NEXT)[1])
        back += [terminal.key(BEFORE)[1] for _ in STEPS]
        for _ in STEPS[1:-1]:
            terminal.key(NEXT)  # to the gears, which fail
        fixes.append(terminal.key(FIX)[0])
        terminal.key(LEAVE)
        terminal.end()
    for step, seconds in first.items():
        report(f"{size}: first visit, {step}", seconds, unit)
    report(f"{size}: step before, known form", back, unit)
    report(f"{size}: F5, the list opens", fixes, unit)


def main(rounds: int = 5) -> None:
    bares = [bare() for _ in range(rounds)]
    unit = statistics.median(bares)
    report("bare interpreter", bares, unit)
    starts(rounds, unit)
    for columns, rows in ((80, 24), (120, 40), (200, 60)):
        size = f"{columns}x{rows}"
        for field, number in TYPED:
            terminal = opened(columns, rows)
            for keys in (b"\x10", field.encode(), b"\r", b"\x1b[F", b"\x15", number):  # palette, End, delete all
                terminal.key(keys)
            report(f"{size}: {field}, echo while solving", typed(terminal, b"5\x7f" * 20), unit)
            if columns >= 120:  # below there is no room for how long it took
                found = [results(terminal, key) for key in (b"5", b"\x7f") * rounds]
                report(f"{size}: {field}, findings", found, unit)
            if code := terminal.end():
                print(f"ended with {code}")
        visits(size, columns, rows, rounds, unit)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 5)
