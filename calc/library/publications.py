# SPDX-License-Identifier: Apache-2.0
"""The register of sources: the publications that formulas, limits and tables cite, and how we know what each of them
says.

A source is one line: "Finotti 2013, 4.1: cost of the first year", "ISO 898-1: nominal stress area", or, where it names
no publication first, a kind and what follows: "geometry: sector and core", "rule of this program: …".  `resolved` tells
what stands behind it."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from functools import cache

from ..sheet.quantity import unknown
from ..sheet.record import record, replace
from ..sheet.text import EMPTY, SEMICOLON, Text
from .table_file import TABLES, Mistake, bad_table, house_table, parsed, text_of_table

TABLE, PLACES = TABLES / "publications.toml", TABLES / "places.toml"
NEEDED = ("name", "title", "edition", "status", "known")  # keys of a publication
OPTIONAL = ("where", "read", "title_from_memory", "status_from_memory", "witness")
NONE = "none"

# How we know what a publication says: the closed set of `known`.
KNOWN = {
    "read": Text("read in the source"),
    "reprint": Text("read in a public reprint"),
    "code": Text("compared with public code, not with the original"),
    "other": Text("as another source quotes it"),
    "memory": Text("from memory"),
    "computed": Text("computed here"),
}

# Who may be wrong where a document is: the closed set of `who` in errata.toml.  The copy is the text that was read.
WHO = {
    "author": Text("author"),
    "author or copy": Text("author or copy"),
    "author or print": Text("author or print"),
    "print or copy": Text("print or copy"),
    "author, print or copy": Text("author, print or copy"),
}

# What a source begins with that names no publication first, and what it means.
KINDS = {
    "definition": Text("what a quantity is called by convention; there is nothing to prove"),
    "geometry": Text("follows from lengths and angles alone"),
    "kinematics": Text("follows from positions and speeds"),
    "statics": Text("follows from the balance of forces and moments"),
    "dynamics": Text("follows from Newton's laws of motion"),
    "elasticity": Text("follows from Hooke's law: beams, sections, stresses"),
    "hydrodynamics": Text("follows from Reynolds' equation of the oil film"),
    "thermodynamics": Text("follows from the laws of an ideal gas"),
    "conservation of energy": Text("what comes in goes out"),
    "energy": Text("follows from the conservation of energy: heat, work and power"),
    "physics": Text("a law of matter in its common form"),
    "mathematics": Text("follows by calculation alone: sums, extremes, vectors, statistics"),
    "statistics": Text("follows from what was measured by the rules of chance"),
    "computed here": Text("comes out of this program's own solver"),
    "computed apart": Text("computed once by other means, to compare with"),
    "hand calculation": Text("calculated by hand, to compare with"),
    "given in the design": Text("the user's own value"),
    "rule of this program": Text("chosen by us; its text gives the reason"),
    "rule of thumb": Text("what is usual, set by us; no published source"),
    "assumed": Text("taken by us, since no source gives it"),
    "typical": Text("usual of such products, from memory or from what their makers publish"),
    "linear in temperature": Text("a straight line fitted by us to the values that are named"),
    "ranges of": Text("the ranges that the named publications state"),
    "method of": Text("what the method of the named source gives, computed here"),
}


@record
class Publication:
    """One row of the register.  `where`: places in it that are known in another way than the whole.

    `places`: of a publication that was read as a whole, what stands at each place that may be cited; else empty.
    `witness`: of what is from memory and decides a limit, a second source that the public can read and that says the
    same, or "none".
    """

    name: str
    title: str
    edition: str
    status: str
    known: str
    where: Mapping[str, str] = field(default_factory=dict)
    places: Mapping[str, str] = field(default_factory=dict)
    title_from_memory: bool = False
    status_from_memory: bool = False
    witness: str = ""

    @property
    def witness_text(self) -> Text:
        """Whether somebody else says the same; empty where nothing from memory hangs on it."""
        if not self.witness:
            return EMPTY
        if self.witness == NONE:
            return Text("no second witness")
        return Text("second witness: {witness}", witness=self.witness)

    def known_at(self, clause: str) -> Text:
        """How we know what it says there.  A source may say of itself that it is from memory."""
        if "from memory" in clause:
            return KNOWN["memory"]
        return KNOWN[next((known for place, known in self.where.items() if place in clause), self.known)]

    @property
    def status_text(self) -> Text:
        if self.status == "not checked":
            return Text("edition not checked")
        status = Text("current")
        if self.status == "superseded by later editions":
            status = Text("superseded by later editions")
        elif self.status != "current":
            status = Text("superseded by {publication}", publication=self.status.removeprefix("superseded by "))
        return Text("{status} as far as we remember", status=status) if self.status_from_memory else status

    def described(self, known: Sequence[Text] = ()) -> Text:
        """Title, edition, status and how we know, on one line.  `known`: of the places that are meant, where not of the
        whole."""
        parts = dict(title=self.title, edition=self.edition, status=self.status_text)
        knowing = SEMICOLON.join(filter(None, (*(known or [KNOWN[self.known]]), self.witness_text)))
        line = Text("{title} ({edition}); {status}; {known}", known=knowing, **parts)
        return Text("{described}; its title from memory", described=line) if self.title_from_memory else line


@record
class Citation:
    """A publication that a source names.  `name`: as it stands there, a standard perhaps with its year; `clause`: what
    follows it, up to the next publication.

    `places`: those of them that the publication has, by their numbers; `lost`: places that it has not.
    """

    name: str
    publication: Publication
    clause: str
    places: tuple[str, ...]
    lost: tuple[str, ...]

    @property
    def known(self) -> Text:
        return self.publication.known_at(self.clause)


@record
class Origin:
    """What stands behind a source: its kind where it begins with one, and the publications that it names."""

    kind: str
    citations: tuple[Citation, ...]
    unknown: tuple[str, ...]  # what looks like a publication and is not in the register

    @property
    def found(self) -> bool:
        """Whether the register has it: a kind or a publication, nothing unknown, and a place of what was read as a
        whole."""
        placed = all(not c.lost and (c.places or not c.publication.places) for c in self.citations)
        return bool(self.kind or self.citations) and not self.unknown and placed


@cache
def register() -> Mapping[str, Publication]:
    """Every publication by its name."""
    places: dict[str, dict[str, str]] = parsed(PLACES.name, text_of_table(PLACES.name))
    rows = parsed(TABLE.name, text_of_table(TABLE.name))["publication"]
    mistakes = [wrong for n, row in enumerate(rows) for wrong in _mistakes(row, f"publication.{n}")]
    if mistakes:
        raise bad_table(TABLE.name, mistakes)
    known = (Publication(**{key: value for key, value in row.items() if key != "read"}) for row in rows)
    return {row.name: replace(row, places=places.get(row.name, {})) for row in known}


def _mistakes(row: dict[str, object], place: str) -> Iterator[Mistake]:
    """Keys of a row that are not known, and those that are missing."""
    known = NEEDED + OPTIONAL
    yield from ((f"{place}.{key}", "", unknown(key, known)) for key in row if key not in known)
    yield from ((f"{place}.{key}", "", Text("is missing")) for key in NEEDED if key not in row)


def publication(name: str) -> Publication | None:
    """The row of a name; of a standard with a year that has no row of its own, that of the standard."""
    return register().get(name) or register().get(name.partition(":")[0])


def cited(source: str) -> str:
    """The publication of the register that a source names first, with the year of a standard if it gives one; empty
    where it names none."""
    name = _names().search(source)
    return name[0] if name is not None else ""


@cache
def resolved(source: str) -> Origin:
    """What stands behind a source."""
    source = str(source)
    names = list(_names().finditer(source))
    ends = [match.start() for match in names[1:]] + [len(source)]
    citations = tuple(_citation(match[0], source[match.end() : end]) for match, end in zip(names, ends))
    rest = _names().sub("", source)
    unknown = tuple(dict.fromkeys(match[0] for match in LIKELY.finditer(rest)))
    kind = next((kind for kind in KINDS if _begins(source, kind)), "")
    return Origin(kind=kind, citations=citations, unknown=unknown)


def _begins(source: str, kind: str) -> bool:
    source = source[:1].lower() + source[1:]
    return source == kind or (source.startswith(kind) and not source[len(kind)].isalnum())


def _citation(name: str, clause: str) -> Citation:
    row = publication(name)
    assert row is not None, name
    numbers = _numbered(re.split(r"[:;]", clause, maxsplit=1)[0]) if row.places else []
    there = tuple(n for n in numbers if n in row.places)
    lost = tuple(n for n in numbers if n not in row.places)
    return Citation(name=name, publication=row, clause=clause, places=there, lost=lost)


def _numbered(clause: str) -> list[str]:
    """The places of a clause by their numbers: "Tables 4.5 and 4.6, Fig. 4.20" → Table 4.5, Table 4.6, Fig. 4.20."""
    places, word = [], ""
    for match in PLACE.finditer(clause):
        before = clause[: match.start()].rstrip()
        if match[1]:
            word = {"t": "Table ", "f": "Fig. ", "e": "eq. ", "c": "ch. "}[match[1][0].lower()]
        elif not before.endswith((" and", " to")):
            word = ""  # a section of its own, not one more table
        if word or not match[2].isdigit():
            places.append(word + match[2])
    return places


# A place: a section, a table, a figure, an equation or a chapter.  A number alone has a point in it.
PLACE = re.compile(
    r"(?:\b(Tables?|Figs?\.|Figures?|eqs?\.|ch\.|chapter) ?)?(?<![\w.·])(?!0)(\d+(?:[.-]\d+)*)"
    r"(?![\w·]|\.\d| ?(?:mm|N|MPa|kg|%|°|µm|m\b))"
)
# What looks like a publication: names and a year, or a standard with its number.
LIKELY = re.compile(
    r"\b(?!(?:Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec)\b)"
    r"[A-Z][\w.’'-]+(?:(?: |, | & |/| and )(?:[A-Z][\w.’'-]*|et al\.))*,? (?:18|19|20)\d\d\b"
    r"|\b(?:ISO|DIN|AGMA|VDI|FVA|ASTM|API|BS|EN|IACS|JIS|UNI|NASA|NACA)(?:/(?:TR|TS))?"
    r"[ -](?:ISO |EN |UR |TR |TN |TP|Report )?"
    r"[A-Z]?-?\d+(?:-[A-Z]?\d+)*(?::\d{4})?|\bSAE J\d+"
)


@cache
def _names() -> re.Pattern[str]:
    """Matches a name as a whole: "ISO 1" does not stand in "ISO 1328-1"."""
    names = "|".join(re.escape(name) for name in sorted(register(), key=len, reverse=True))
    return re.compile(rf"(?<![\w-])(?:{names})(?::\d{{4}})?(?![\w-])")


def references(sources: Iterable[str]) -> dict[str, tuple[Publication, list[str], list[Text]]]:
    """The publications that sources name, in the order in which they first do: the row, its places that are cited, how
    we know them."""
    cited: dict[str, tuple[Publication, list[str], list[Text]]] = {}
    for source in sources:
        for citation in resolved(source).citations:
            _, places, known = cited.setdefault(citation.name, (citation.publication, [], []))
            places += [place for place in citation.places if place not in places]
            known += [citation.known] if citation.known not in known else []
    return cited


def as_printed(document: str, lines: str) -> tuple[str, Text]:
    """What stands at these lines of a document that is wrong there, ten words at most in its own language, and who may
    be; empty where the table of errata has none."""
    for row in house_table("errata.toml")["row"]:
        if (row["source"], row["lines"]) == (document, lines):
            return row["line"], WHO[row["who"]]
    return "", EMPTY
