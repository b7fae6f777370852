# SPDX-License-Identifier: Apache-2.0
"""Files of strangers beside a design: none is waited for, none is a fault of the program, and none gets into a design
unread."""

import hashlib
import json
import os
import random
from contextlib import suppress
from pathlib import Path

import pytest

from calc.design import disk, replay
from calc.design.limits import DESIGN_BYTES, FRONT_BYTES, LIST_BYTES, LIST_COLUMNS
from calc.design.toml_file import read
from calc.sheet.errors import BadInput
from calc.studies.drive.front import Broken, picked, searched
from calc.studies.sweep.inputs import listed
from tests.command import run
from tests.conftest import DESIGNS, GAMMA, ROOT

REPLAYS = sorted((ROOT / "tests" / "replays").glob("*.toml"))
SIZED = DESIGNS / "r753ie4_sized.toml"
DEEP = b"[" * 100_000

pytestmark = pytest.mark.skipif(os.name != "posix", reason="pipes of POSIX")


def is_bad_input(done: object, *words: str) -> None:
    """Exit 2 with a reason, and no fault."""
    assert done.returncode == 2 and "Traceback" not in done.stderr, done.stderr  # type: ignore[attr-defined]
    assert all(word in done.stderr for word in words), done.stderr  # type: ignore[attr-defined]


def put(path: Path, what: bytes | None) -> Path:
    """A file of these bytes; None: a pipe that nobody ever writes to."""
    path.parent.mkdir(exist_ok=True)
    if what is None:
        os.mkfifo(path)
    else:
        path.write_bytes(what)
    return path


# --- design --pick


@pytest.fixture
def own(tmp_path: Path) -> Path:
    """A design, and a folder with a front that was searched for it, of one drive."""
    path = put(tmp_path / "own.toml", SIZED.read_bytes())
    about = {"design": hashlib.sha256(path.read_bytes()).hexdigest(), "drives": [{}]}
    put(tmp_path / "d" / "front.json", json.dumps(about).encode())
    return path


@pytest.mark.parametrize(
    "row",
    [
        b"",
        b"\xff\xfe",
        b"schema = 2\nname = ",
        b"schema = 2\nname = 'x'\nboer = 3\n",
        SIZED.read_bytes().replace(b"bore_mm = 94", b"bore_mm = -94"),
        b"# " + b"x" * DESIGN_BYTES,
        b"x = " + DEEP,
        None,
    ],
    ids=["empty", "no text", "cut off", "an unknown key", "a bad value", "too large", "too deep", "a pipe"],
)
def test_a_drive_is_read_and_checked_before_it_is_written_over_a_design(own: Path, row: bytes | None) -> None:
    put(own.parent / "d" / "001.toml", row)
    for more in ((), ("-o", own.parent / "other.toml")):
        is_bad_input(run("design", own, "--out", own.parent / "d", "--pick", 1, *more))
        assert own.read_bytes() == SIZED.read_bytes()
        assert sorted(path.name for path in own.parent.iterdir()) == ["d", "own.toml"]


FRONTS = {
    "a pipe": None,
    "too deep": DEEP,
    "deep in a list": b'{"drives": ' + DEEP,
    "a list": b"[]",
    "a word": b'"drives"',
    "drives that are a word": b'{"drives": "' + b"x" * 100_000 + b'"}',
    "drives that are a number": b'{"drives": 3}',
    "many drives": b'{"drives": [' + b"1," * 100_000 + b"1]}",
    "a number of many digits": b'{"drives": ' + b"9" * 10_000 + b"}",
    "a design that is a list": b'{"design": [[]], "drives": [{}]}',
    "too large": b'{"drives": []}' + b" " * FRONT_BYTES,
    "no text": b"\xff" * 9,
}


@pytest.mark.parametrize("what", FRONTS)
def test_a_front_that_is_none_picks_no_drive_and_is_no_fault(own: Path, what: str) -> None:
    folder = own.parent / "d"
    (folder / "front.json").unlink()
    put(folder / "front.json", FRONTS[what])
    put(folder / "001.toml", SIZED.read_bytes())
    is_bad_input(run("design", own, "--out", folder, "--pick", 1), "--pick")
    is_bad_input(run("design", own, "--out", folder, "--rows", 3), "001.toml")  # of no front: left alone
    assert own.read_bytes() == SIZED.read_bytes() == (folder / "001.toml").read_bytes()


def test_a_file_that_is_no_drive_of_the_front_is_not_picked(own: Path) -> None:
    put(own.parent / "d" / "002.toml", SIZED.read_bytes())
    is_bad_input(run("design", own, "--out", own.parent / "d", "--pick", 2), "no such drive")


# --- sweep --list


@pytest.mark.parametrize(
    ("table", "said"),
    [
        (None, "no regular file"),
        (b"engine.bore_mm\n" + b"9" * LIST_BYTES, "too large"),
        (b"," * 100_000 + b"\n1\n", f"at most {LIST_COLUMNS}"),
        (b"engine.bore_mm\n" + b"\n" * 200_000, "at most 100,000"),
        (b"engine.bore_mm\n" + b"x\n" * 90_000, "more mistakes"),
        (b"engine.bore_mm\n" + b'"' + b"9" * 200_000 + b'"\n', "field larger"),
        (b"engine.bore_mm\n90:94:3\n", "one value"),
        (b'engine.bore_mm\n"90,94"\n', "one value"),
        (b"engine.bore_mm\n90:94:1000000\n" * 3, "one value"),
        (b"engine.bore_mm\n\0\n", ""),
    ],
    ids=["pipe", "large", "columns", "lines", "mistakes", "field", "range", "values", "long ranges", "nought"],
)
def test_a_list_of_designs_is_read_to_its_limits(tmp_path: Path, table: bytes | None, said: str) -> None:
    is_bad_input(run("sweep", GAMMA, "--step", "engine", "--list", put(tmp_path / "list.csv", table)), said)


def test_a_device_is_no_list_of_designs() -> None:
    is_bad_input(run("sweep", GAMMA, "--step", "engine", "--list", "/dev/zero"), "no regular file")


# --- names and files that the system has trouble with


HOSTILE_NAMES = ("a" * 256, "a" * 5000, "/".join(["a" * 200] * 40), "a\0b", "\udcff" * 300)
COMMANDS: dict[str, list[str]] = {
    "check": ["check", "{}"],
    "session": ["{}"],
    "new": ["new", "{}"],
    "example": ["new", "{}", "--example", "makers/er6n"],
    "explain": ["explain", "{}", "engine.lambda"],
    "report": ["report", "{}"],
    "report -o": ["report", "GAMMA", "-o", "{}"],
    "verify": ["verify", "{}"],
    "replay": ["replay", "{}"],
    "set": ["set", "{}", "engine.bore_mm=94"],
    "upgrade": ["upgrade", "{}"],
    "compare": ["compare", "GAMMA", "{}"],
    "compare -o": ["compare", "GAMMA", "GAMMA", "-o", "{}"],
    "sweep": ["sweep", "{}", "--vary", "engine.bore_mm=1,2"],
    "sweep -o": ["sweep", "GAMMA", "--vary", "engine.bore_mm=93,94", "--step", "engine", "-o", "{}"],
    "sweep --list": ["sweep", "GAMMA", "--list", "{}"],
    "choose": ["choose", "{}", "engine"],
    "design": ["design", "{}", "--dry"],
    "design --out": ["design", "SIZED", "--out", "{}"],
    "design --pick": ["design", "SIZED", "--out", "{}", "--pick", "1"],
    "export": ["export", "{}", "-o", "x.json"],
    "export -o": ["export", "GAMMA", "-o", "{}.json"],
    "schema": ["schema", "-o", "{}"],
    "scenarios": ["scenarios", "{}"],
    "scenarios -o": ["scenarios", "-o", "{}"],
    "serve": ["serve", "{}"],
}


@pytest.mark.parametrize("command", COMMANDS)
def test_a_name_that_the_system_can_not_have_is_bad_input(tmp_path: Path, command: str) -> None:
    for name in HOSTILE_NAMES:
        words = [word.replace("GAMMA", str(GAMMA)).replace("SIZED", str(SIZED)) for word in COMMANDS[command]]
        is_bad_input(run(*(word.format(name) for word in words), cwd=tmp_path))
        assert not list(tmp_path.iterdir())


def test_a_file_that_has_no_bytes_now_is_not_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As some of the kernel's own are: regular by their looks, and nothing to read yet."""
    path = put(tmp_path / "x.toml", b"schema = 2\n")

    class Nothing:
        def __enter__(self) -> "Nothing":
            return self

        def __exit__(self, *_: object) -> None: ...

        def fileno(self) -> int:
            return handle

        def read(self, _: int) -> None: ...

    with path.open() as file:
        handle = file.fileno()
        monkeypatch.setattr(disk, "open", lambda *_, **__: Nothing(), raising=False)
        is_bad_input(run("check", path), "cannot be read")


# --- by a generator

SIGNS = (b"[", b"]", b"{", b"}", b'"', b"=", b",", b"\n", b"\0", b"\xff", b"1e400", b"nan", b"9" * 400, b"[[step]]", b"*",
         b"schema = 1\n", b"\xe2\x80\xae", b"-1", b"null", b"[]", b"1:2:3", b"true")  # fmt: skip
FRONT = {
    "design": "a",
    "proved": True,
    "classes": 1,
    "classes_done": 1,
    "combinations": 3,
    "objectives": {"power": "W", "mass": "kg"},
    "sizes_mm": {"a": [1, 2], "b": None},
    "choices": {"x": ["a", ["b", "c"]]},
    "drives": [{"objectives": {"power": 1.0, "mass": 2.0}, "changes": {"engine.bore_mm": 94.0}}],
}
LIST = b"engine.rated_speed_rpm,bearings.oil,gears.wheels.shaft.teeth\n2000,SAE 30,30\n,SAE 50,\n99999,,\n"


def mutated(raw: bytes, rng: random.Random) -> bytes:
    """With a few pieces cut out, put in or repeated."""
    changed = bytearray(raw)
    for _ in range(rng.choice((1, 1, 2, 4))):
        at, way = rng.randrange(len(changed) + 1), rng.random()
        if way < 0.3:
            del changed[at : at + rng.choice((1, 3, 20, 200))]
        elif way < 0.7:
            changed[at : at + rng.choice((0, 1, 5))] = rng.choice(SIGNS)
        else:
            other = rng.randrange(len(changed) + 1)
            changed[at:at] = changed[other : other + rng.choice((5, 50, 300))]
    return bytes(changed)


@pytest.mark.slow
def test_a_replay_a_list_and_a_front_that_anything_happened_to_are_read_or_refused(tmp_path: Path) -> None:
    rng, base, file = random.Random(5), read(GAMMA), tmp_path / "x"
    scripts = [path.read_bytes().replace(b"../../designs", str(DESIGNS).encode()) for path in REPLAYS]
    for _ in range(3000):
        file.write_bytes(mutated(rng.choice(scripts), rng))
        with suppress(BadInput):
            replay.load(file)
        file.write_bytes(mutated(LIST, rng))
        with suppress(BadInput):
            listed(base, str(file))
        raw = mutated(json.dumps(FRONT).encode(), rng)
        with suppress(Broken):
            picked(raw, base.data)
        with suppress(Broken):
            searched(raw)
