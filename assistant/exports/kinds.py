# SPDX-License-Identifier: Apache-2.0
"""The kinds of files that a design is exported to: of each its option, its endings, what it is, and which options are
its own.

The kind `loads` is the option --loads, made by a module of this folder, which is loaded when it is asked for and has
two functions: `lacks(asked)`, why this design has no such file, at once, or None; and `made(asked)`, its files."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, cast

from assistant.extras import missing
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text

if TYPE_CHECKING:
    from calc.design.toml_file import Document
    from calc.solve import Results


@dataclass(frozen=True)
class FileKind:
    """`module`: of this folder, that makes it.  `endings`: of its files, without the dot, the usual one first; `alone`:
    whether such an ending says by itself that this kind is meant.  `options`: of the command line, that are for this
    kind alone; `rows`: those of them that ask for another file of this kind, which the session offers as a row of its
    own, with what it is.  `extra`: what has to be installed for it, and the module by which that is seen; `without`:
    what is said where it is not there, instead of the usual."""

    name: str
    module: str
    endings: tuple[str, ...]
    what: Text
    alone: bool = True
    options: tuple[str, ...] = ()
    rows: Mapping[str, Text] = field(default_factory=dict)
    extra: tuple[str, str] | None = None
    without: Text | None = None

    @property
    def works(self) -> "Works":
        return cast(Works, import_module(f"assistant.exports.{self.module}"))

    def tail(self, row: str = "") -> str:
        """What the name of a design's file has behind it: -loads.csv."""
        middle = row or ("" if self.alone else self.name)
        return f"{'-' if middle else ''}{middle}.{self.endings[0]}"


@dataclass(frozen=True)
class Request:
    """One export that was asked for: of which solved design, to which file, and the options given for its kind."""

    path: Path
    document: "Document"
    results: "Results"
    options: Mapping[str, object] = field(default_factory=dict)
    lang: str = "en"

    @property
    def ending(self) -> str:
        return self.path.suffix.lower().removeprefix(".")


@dataclass(frozen=True)
class Made:
    """The content of each file, and what is said once they are written."""

    files: Mapping[Path, str | bytes]
    said: tuple[Text, ...] = ()


class Works(Protocol):
    """The module of a kind."""

    def lacks(self, asked: Request) -> InputError | None:
        """Why this design has no such file, and what to add, at the key where it is missing.  Takes no time."""

    def made(self, asked: Request) -> Made:
        """Of a design that lacks nothing.  Raises BadInput for options that are not to be had."""


KINDS: dict[str, FileKind] = {
    kind.name: kind
    for kind in (
        FileKind(
            "dxf",
            "drawing",
            ("dxf",),
            Text("a drawing of the shaft or of the gears"),
            options=("gear", "gears", "chord_error"),
            rows={"gears": Text("a drawing of the whole train")},
            extra=("dxf", "ezdxf"),
        ),
        FileKind(
            "step",
            "step",
            ("step", "stp"),
            Text("the shafts as solids for CAD"),
            options=("shaft", "wheel", "module", "teeth", "blank", "allowance", "drilled"),
            rows={"module": Text("all shafts and wheels where they stand, as an assembly for CAD")},
            extra=("cad", "OCP"),
            without=Text('a STEP file needs the extra "cad": pip install "contralbero[cad]" (380 MB)'),
        ),
        FileKind("rexs", "rexs", ("rexs",), Text("the train for gear programs, REXS 1.7")),
        FileKind(
            "loads",
            "loads",
            ("csv", "json"),
            Text("the loads for finite elements and multi-body programs"),
            alone=False,
            options=("speeds", "variant"),
        ),
        FileKind(
            "balancing",
            "balancing",
            ("pdf", "csv"),
            Text("the sheet for the balancing machine"),
            alone=False,
        ),
        FileKind(
            "xlsx",
            "spreadsheet",
            ("xlsx",),
            Text("a workbook: inputs, results, checks, tables"),
            extra=("xlsx", "xlsxwriter"),
        ),
        FileKind(
            "csv",
            "values",
            ("csv",),
            Text("the values"),
            options=("transfer", "map"),
            rows={
                "map": Text("the strikes of the gears over speed and load"),
                "transfer": Text("the transfer functions of the mounts"),
            },
        ),
        FileKind("json", "results", ("json",), Text("all results")),
    )
}


def kind_of(ending: str) -> FileKind | None:
    """The kind that an ending (`csv`) stands for by itself."""
    return next((kind for kind in KINDS.values() if kind.alone and ending in kind.endings), None)


def in_the_way(kind: FileKind, asked: Request) -> InputError | None:
    """Why a kind can not be written: its extra is not installed, or the design lacks something."""
    lacking = missing(*kind.extra, kind.name, kind.without) if kind.extra is not None else None
    return lacking or kind.works.lacks(asked)


def exported(kind: FileKind, asked: Request) -> Made:
    """The files of one kind.  Raises BadInput where there is nothing to write, with what to add."""
    if (lacking := in_the_way(kind, asked)) is not None:
        raise BadInput(asked.document.place, [lacking])
    return kind.works.made(asked)
