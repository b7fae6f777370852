# SPDX-License-Identifier: Apache-2.0
"""What a name on the command line stands for: a file; `-`, standard input or output; a folder, all designs in it."""

import contextlib
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

from assistant.output import Outlet
from assistant.session.saving import asked_for, spare, write_asked
from calc.design.disk import demand_writable
from calc.design.limits import DESIGN_BYTES
from calc.design.toml_file import Document, parse, read
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text

STANDARD = "-"
WORST = (0, 4, 1, 3, 2)  # exit codes, from the best on: of what is no design nothing is known


# --- read


def read_design(name: str) -> Document:
    """The design of that name, from a file or from standard input."""
    return parse(standard_input(DESIGN_BYTES), STANDARD) if name == STANDARD else read(name)


def standard_input(most: int) -> bytes:
    """All that comes in.  Raises BadInput where nothing does, or more than `most` bytes."""
    stream = getattr(sys.stdin, "buffer", None)
    raw = stream.read(most + 1) if stream is not None else sys.stdin.read(most + 1).encode() if sys.stdin else b""
    if not raw:
        raise BadInput(STANDARD, [InputError(0, "", "", Text("nothing came in by standard input"))])
    if len(raw) > most:
        reason = Text("it is too large: at most {most} bytes are read", most=f"{most:,}")
        raise BadInput(STANDARD, [InputError(0, "", "", reason)])
    return raw


def files_of(names: Sequence[str]) -> list[str]:
    """The names with every folder replaced by the .toml files in it, in their order, none of deeper folders.  Raises
    BadInput for a folder without any."""
    files: list[str] = []
    for name in names:
        if name == STANDARD or not os.path.isdir(name):  # a name that can not be is no folder
            files.append(name)
            continue
        inside = sorted(str(path) for path in Path(name).glob("*.toml"))
        if not inside:
            raise BadInput(name, [InputError(0, "", "", Text("is a folder without a .toml file in it"))])
        files += inside
    if files.count(STANDARD) > 1:
        raise BadInput(STANDARD, [InputError(0, "", "", Text("standard input can be read once; name it once"))])
    return files


def many(names: Sequence[str], files: Sequence[str]) -> bool:
    """Whether several files were asked for: a folder is several, however many are in it."""
    return len(files) > 1 or list(names) != list(files)


def each(files: Iterable[str], work: Callable[[str], int], failed: Callable[[str, BadInput], object]) -> int:
    """Every file by itself, so that one with mistakes does not keep the others waiting; the worst of the exit codes.
    `failed` is told what was wrong with one."""
    code = 0
    for file in files:
        try:
            code = worst(code, work(file))
        except BadInput as bad:
            sys.stdout.flush()
            print(bad, file=sys.stderr)
            failed(file, bad)
            code = 2
    return code


def worst(*codes: int) -> int:
    return max(codes, key=WORST.index)


# --- written


def demand_ending(name: str, *endings: str, option: str = "-o") -> str:
    """The ending of an output, which says what is written: one of these (`pdf`).  Raises BadInput for another, and for
    what can not be written whatever its ending."""
    with asked_for(Path(name)):
        demand_writable(name)
    ending = Path(name).suffix
    if ending.lower().removeprefix(".") in endings:
        return ending.lower().removeprefix(".")
    fault = Text("the ending {ending} is not known", ending=ending) if ending else Text("has no ending")
    known = ", ".join(f".{known}" for known in endings)
    reason = Text("{fault}; known are {endings}", fault=fault, endings=known)
    raise BadInput(option, [InputError(0, "", name, reason)])


def is_folder(name: str, several: bool) -> bool:
    """A folder that is there, or is asked for with a / at its end; for several files a name without an ending is one
    too."""
    if name == STANDARD:
        return False
    return name.endswith(("/", os.sep)) or os.path.isdir(name) or (several and not Path(name).suffix)


def targets_in(folder: str | None, files: Sequence[str], tail: str) -> dict[str, str]:
    """A file for each design, of its name with another tail; in a folder, which is made, or (None) in the current one.
    Raises BadInput where two designs would have the same."""
    targets: dict[str, str] = {}
    for file in files:
        if file == STANDARD:
            raise BadInput(STANDARD, [InputError(0, "-o", "", Text("a design of standard input has no name; give -o"))])
        target = str(Path(folder or "") / f"{Path(file).stem}{tail}")
        if target.startswith("-"):  # whoever names it next asks for an option
            reason = Text("would be taken for an option; give -o another name, or a folder")
            raise BadInput(file, [InputError(0, "-o", target, reason)])
        if target in targets.values():
            reason = Text("would be written for two designs; give them different names")
            raise BadInput(target, [InputError(0, "-o", "", reason)])
        targets[file] = target
    try:
        if folder is not None:
            Path(folder).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = Text("is no folder to write to: {reason}", reason=error.strerror or str(error))
        raise BadInput(folder or "", [InputError(0, "-o", "", reason)]) from None
    return targets


@contextlib.contextmanager
def spoken(output: str | None) -> Iterator[None]:
    """What a command says goes to stderr where stdout is its output."""
    with contextlib.redirect_stdout(sys.stderr) if output == STANDARD else contextlib.nullcontext():
        yield


def put(name: str, content: str | bytes, inputs: Iterable[str | Path] = (), new: bool = False) -> None:
    """Write what a command was asked for, to a file or to standard output: to that byte by byte, and so that nothing is
    obeyed where it is a terminal.  `new`: an existing file is left alone."""
    data = content if isinstance(content, bytes) else content.encode("utf-8")
    if name == STANDARD:
        _to_standard_output(content)
    else:
        spare(Path(name), *inputs)
        write_asked(Path(name), data, inputs=inputs, new=new)


def _to_standard_output(content: str | bytes) -> None:
    out = sys.stdout
    if isinstance(out, Outlet) and not out.isatty() and hasattr(out.stream, "buffer"):
        out.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8"))
    elif isinstance(content, str):
        print(content, end="")
    else:
        reason = Text("is a terminal, which can not show this file; write it with -o FILE, or into a pipe")
        raise BadInput("-o", [InputError(0, "", STANDARD, reason)])
