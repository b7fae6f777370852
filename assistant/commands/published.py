# SPDX-License-Identifier: Apache-2.0
"""`contralbero sources`: the register of publications and kinds of sources, and what of the program rests on one of them."""

import json
import textwrap
from argparse import Namespace
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from calc.library.publications import KINDS, KNOWN, Publication, references, register, resolved
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.version import VERSION

WIDE = 116
MOST = 12  # formulas that are named


def run(asked: Namespace) -> int:
    if asked.name is None:
        lines = [*_all(register().values()), "", *_kinds()]
        chosen = list(register().values())
    else:
        one = _meant(asked.name)
        lines, chosen = list(_one(one)), [one]
    if asked.json:
        rows = [_json(one) for one in chosen]
        about: dict[str, Any] = {"schema": 1, "program": "contralbero", "version": VERSION, "publications": rows}
        if asked.name is None:
            about["kinds"] = {kind: str(meaning) for kind, meaning in KINDS.items()}
        print(json.dumps(about, ensure_ascii=False, indent=1))
    else:
        print("\n".join(lines))
    return 0


def reference_lines(sources: Iterable[str]) -> Iterator[str]:
    """The publications that sources name: what each is, how we know it, and what stands at the places that are cited."""
    for name, (publication, places, known) in references(sources).items():
        yield from _wrapped(f"{name}: {publication.described(known)}")
        for place in places:
            yield from _wrapped(f"{place}: {publication.places[place]}", 8)


def _wrapped(line: str, indent: int = 4) -> list[str]:
    return textwrap.wrap(line, WIDE, initial_indent=" " * indent, subsequent_indent=" " * (indent + 4), break_on_hyphens=False)


def _all(rows: Iterable[Publication]) -> Iterator[str]:
    for known, words in KNOWN.items():
        some = [row for row in rows if row.known == known]
        if some:
            yield f"{str(words)[:1].upper()}{str(words)[1:]}"
            for row in sorted(some, key=lambda row: row.name.casefold()):
                yield from _wrapped(f"{row.name}: {row.title} ({row.edition}); {row.status_text}")


def _kinds() -> Iterator[str]:
    yield "What a source begins with that names no publication first"
    for kind, meaning in KINDS.items():
        yield from _wrapped(f"{kind}: {meaning}")


def _one(row: Publication) -> Iterator[str]:
    yield from textwrap.wrap(f"{row.name}: {row.described()}", WIDE, break_on_hyphens=False)
    for place, known in row.where.items():
        yield from _wrapped(f"{place}: {KNOWN[known]}")
    users = list(_users(row))
    cited = references(source for _, source in users)
    used = {place for publication, found, _ in cited.values() if publication is row for place in found}
    if places := [place for place in row.places if place in used]:
        yield "Cited"
        for place in places:
            yield from _wrapped(f"{place}: {row.places[place]}")
    yield f"{len(users)} formulas" if len(users) != 1 else "1 formula"
    for name, source in users[:MOST]:
        yield from _wrapped(f"{name}   {source}")
    if len(users) > MOST:
        yield f"    and {len(users) - MOST} more"


def _users(row: Publication) -> Iterator[tuple[str, str]]:
    """The formulas that cite a publication, with their sources."""
    for name, source in _formulas().items():
        if any(citation.publication is row for citation in resolved(source).citations):
            yield name, source


def _formulas() -> Mapping[str, str]:
    """The sources of all formulas: those of the modules that a solve loads, and of the searches."""
    import calc.solve  # noqa: F401  (it registers the formulas)
    from calc.sheet.formula import FORMULAS

    return {name.removeprefix("calc."): str(formula.source) for name, formula in sorted(FORMULAS.items())}


def _meant(word: str) -> Publication:
    """The publication of that name, or the one whose name or title holds the word."""
    known = register()
    if word in known:
        return known[word]
    meant = [row for row in known.values() if word.casefold() in row.name.casefold()]
    meant = meant or [row for row in known.values() if word.casefold() in row.title.casefold()]
    if len(meant) == 1:
        return meant[0]
    if meant:
        hint = Text("may be {names}", names=", ".join(f'"{row.name}"' for row in meant))
    else:
        hint = Text("is not in the register; `contralbero sources` lists all")
    raise BadInput("contralbero sources", [InputError(0, "", f'"{word}"', hint)])


def _json(row: Publication) -> dict[str, Any]:
    return {
        "name": row.name, "title": row.title, "edition": row.edition, "status": row.status, "known": str(KNOWN[row.known]),
        "known_at": {place: str(KNOWN[known]) for place, known in row.where.items()}, "title_from_memory": row.title_from_memory,
        "status_from_memory": row.status_from_memory,
        "formulas": [name for name, _ in _users(row)],
    }  # fmt: skip
