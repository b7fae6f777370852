# SPDX-License-Identifier: Apache-2.0
"""A design file with a fit in it: the fitted inputs, each with what it was fitted to beside it."""

import re
import tomllib
from typing import Any

from calc.design.addresses import address, value_at
from calc.design.labels import Place
from calc.design.toml_file import Document, parse
from calc.design.upgrade import own_key
from calc.sheet.number import short
from calc.studies.fit_results import DesignFit

from .saving import saved_text

FITTED = "fitted to "
EARLIER = re.compile(rf"(?:was [^,;]+, )?{FITTED}[^;]*(?:; )?")  # what an earlier fit has written


def with_fit(document: Document, fit: DesignFit) -> Document:
    """The design once the fit is applied."""
    for key, number in fit.changes.items():
        document = document.with_value(key, number)
    return document


def fitted_text(document: Document, fit: DesignFit) -> str:
    """The text of its file then: comments stay, and beside each fitted value stands `# fitted to RUN: ± sd`.

    Raises SaveError where the file can not be edited in place, NeedsUpgrade where its schema has no words for it."""
    text = saved_text(document.raw, with_fit(document, fit).data)
    made = parse(text.encode("utf-8"), "")
    remarks = {}
    for i, name in enumerate(fit.names):
        said = [f"{FITTED}{', '.join(fit.runs)}: ± {short(float(fit.result.sd[i]), 3)}"]
        said += [_was(document, key) for key in fit.replaced if key.rpartition(".")[0] == name.key.rpartition(".")[0]]
        remarks[_place(made, name.key)] = "; ".join(said)
    return _remarked(text, remarks)


def _was(document: Document, key: str) -> str:
    """What stood in the place of an input, with the comment beside it."""
    remark = document.remarks.get(".".join(map(str, address(document.data, key))), "").lstrip("# \t")
    return f"{key.rpartition('.')[2]} was {value_at(document.data, key)}" + (f" ({remark})" if remark else "")


def _place(made: Document, key: str) -> Place:
    """Where a key stands in the file as it is written."""
    place = address(made.data, key)
    if made.former is None:
        return place
    own = own_key(made.former.was, ".".join(map(str, place)))
    return tuple(int(part) if part.isdigit() else part for part in own.split("."))


def _remarked(text: str, remarks: dict[Place, str]) -> str:
    """With a comment beside values; what stood there stays behind it.  A value in a table on one line has no place for
    one."""
    import tomlkit

    crlf = text.count("\r\n") > 0 and text.count("\r\n") == text.count("\n")
    mark = "\ufeff" if text.startswith("\ufeff") else ""
    body = text.removeprefix(mark)
    edited = tomlkit.parse(body.replace("\r\n", "\n") if crlf else body)
    for (*way, last), remark in remarks.items():
        here: Any = edited
        inline = False
        for part in way:
            here = here[part]
            inline = inline or isinstance(here, tomlkit.items.InlineTable)
        if inline:
            continue
        trivia = here[last].trivia
        before = trivia.comment.lstrip("# \t")
        before = EARLIER.sub("", before)
        trivia.comment = f"# {remark}; {before}" if before else f"# {remark}"
        trivia.comment_ws = trivia.comment_ws or "  "
    made = tomlkit.dumps(edited)
    assert tomllib.loads(made) == tomllib.loads(body)
    return mark + (made.replace("\n", "\r\n") if crlf else made)
