# SPDX-License-Identifier: Apache-2.0
"""The files that a design under edit can be written to: the report and every kind, each with what keeps it from being
written; and their writing."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.exports.kinds import KINDS, FileKind, Request, exported, in_the_way
from assistant.session.saving import Draft, write_asked
from calc.sheet.progress import Progress
from calc.sheet.text import Text

if TYPE_CHECKING:
    from calc.design.toml_file import Document
    from calc.solve import Results

REPORT = Text("the calculation report")


@dataclass(frozen=True)
class FileRow:
    """A file that may be written: of a kind, or (None) the report; `option`: a further file of the kind; `reason`: what
    is in the way."""

    kind: FileKind | None = None
    option: str = ""
    reason: Text | None = None

    @property
    def what(self) -> Text:
        return REPORT if self.kind is None else self.kind.rows[self.option] if self.option else self.kind.what

    @property
    def endings(self) -> tuple[str, ...]:
        return ("pdf",) if self.kind is None else self.kind.endings

    @property
    def alone(self) -> bool:
        """Whether an ending says by itself that this file is meant."""
        return self.kind is None or (self.kind.alone and not self.option)

    @property
    def tail(self) -> str:
        return ".pdf" if self.kind is None else self.kind.tail(self.option)

    @property
    def options(self) -> Mapping[str, object]:
        return {self.option: True} if self.option else {}


def rows(known: "tuple[Document, Results] | None" = None) -> tuple[FileRow, ...]:
    """All of them; with the solved design each says what keeps it from being written."""
    every = [FileRow()]
    for kind in KINDS.values():
        for option in ("", *kind.rows):
            row = FileRow(kind, option)
            wrong = in_the_way(kind, Request(Path(row.tail), *known, row.options)) if known is not None else None
            every.append(FileRow(kind, option, wrong.reason) if wrong is not None else row)
    return tuple(every)


def write_draft(path: Path, draft: Draft, row: FileRow, progress: Progress | None = None, lang: str = "en") -> None:
    """Write the file that was asked for.  Raises BadInput, OSError, Cancelled."""
    document, results = draft.solved()
    if row.kind is None:
        from reports.report import write  # with matplotlib and reportlab

        write(document, results, document.raw, path, depth="engineer", lang=lang, progress=progress)
        return
    for target, content in exported(row.kind, Request(path, document, results, row.options, lang)).files.items():
        write_asked(target, content, inputs=[document.place])
