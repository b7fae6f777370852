# SPDX-License-Identifier: Apache-2.0
"""A design as it stands at one moment of its editing, to be written out while the editing goes on."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from calc.design.addresses import Table
from calc.design.toml_file import Document, design, parse

from .session.saving import SaveError, differences, edited_text, fresh_text
from .session.solving import Job, run

if TYPE_CHECKING:
    from calc.solve import Results


@dataclass(frozen=True)
class Draft:
    """`raw` and `saved`: the file as it is, and its tables; `data`: the tables as they are now.  `results`: where they are known."""

    raw: bytes = field(repr=False)
    saved: Table = field(repr=False)
    data: Table = field(repr=False)
    home: Path
    results: "Results | None" = field(repr=False)

    def bytes(self) -> tuple[bytes, bool]:
        """The file as it would be saved, and whether it kept its comments."""
        changes = differences(self.saved, self.data)
        if not changes:
            return self.raw, True
        try:
            return edited_text(self.raw.decode("utf-8"), changes).encode("utf-8"), True
        except SaveError:  # a notation that can not be edited in place
            return fresh_text(self.data).encode("utf-8"), False

    def solved(self) -> "tuple[Document, Results]":
        """The document and its results, solved here where they are not known.  Raises RuntimeError with the program's mistake."""
        document = parse(self.bytes()[0], str(self.home))
        if self.results is not None:
            return document, self.results
        answer = run(Job(0, design(document), None))
        if answer.results is None:
            raise RuntimeError(answer.failure)
        return document, answer.results
