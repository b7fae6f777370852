# SPDX-License-Identifier: Apache-2.0
"""The commands about what the program stands on: `contralbero sources`, `oils`, `makers`, `errata` and `validate`.

sources: the register of publications and kinds of sources, and what of the program rests on one of them.  oils: the
oils that a design may name, and what is known of each.  makers: the journals that makers print.  errata: what is wrong
in the documents that this program grew out of.  validate: values of others beside ours."""

import json
import textwrap
from argparse import Namespace
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields
from difflib import get_close_matches
from itertools import groupby
from typing import Any

from assistant.results_text import sign, table_json, table_lines
from calc.library.catalogue import Oil, oils
from calc.library.lubricant import Lubricant
from calc.library.makers import CONFIDENCE, MakerJournal, MakerSheet, maker_sheets
from calc.library.oil_formulas import viscosity_index
from calc.library.oils import least_sure, printed_table, values_table
from calc.library.publications import KINDS, KNOWN, Publication, references, register, resolved
from calc.sheet.errors import BadInput, InputError
from calc.sheet.formula import FORMULAS
from calc.sheet.number import short
from calc.sheet.quantity import keys
from calc.sheet.step import Table
from calc.sheet.text import SEMICOLON, Amount, Name, Text
from calc.sheet.units import UNITS
from calc.sheet.version import VERSION
from calc.studies.published import (
    VALIDATION_KINDS,
    Misprint,
    Unmet,
    ValidationRow,
    caveat,
    documents,
    misprints,
    rows,
    unmet,
)

WIDE = 116
MOST = 12  # formulas that are named


def run_sources(asked: Namespace) -> int:
    if asked.name is None:
        lines = [*_all(register().values()), "", *_kinds()]
        chosen = list(register().values())
    else:
        publication = _meant(asked.name)
        lines, chosen = list(_one(publication)), [publication]
    if asked.json:
        rows = [_json(entry) for entry in chosen]
        about: dict[str, Any] = {"schema": 1, "program": "contralbero", "version": VERSION, "publications": rows}
        if asked.name is None:
            about["kinds"] = {kind: str(meaning) for kind, meaning in KINDS.items()}
        print(json.dumps(about, ensure_ascii=False, indent=1))
    else:
        print("\n".join(lines))
    return 0


def reference_lines(sources: Iterable[str]) -> Iterator[str]:
    """The publications that sources name: what each is, how we know it, and what stands at the places that are
    cited."""
    for name, (publication, places, known) in references(sources).items():
        yield from _wrapped(f"{name}: {publication.described(known)}")
        for place in places:
            yield from _wrapped(f"{place}: {publication.places[place]}", 8)


def _wrapped(line: str, indent: int = 4) -> list[str]:
    return textwrap.wrap(
        line, WIDE, initial_indent=" " * indent, subsequent_indent=" " * (indent + 4), break_on_hyphens=False
    )


def _all(rows: Iterable[Publication]) -> Iterator[str]:
    for known, words in KNOWN.items():
        some = [row for row in rows if row.known == known]
        if some:
            yield f"{str(words)[:1].upper()}{str(words)[1:]}"
            for row in sorted(some, key=lambda row: row.name.casefold()):
                told = SEMICOLON.join(filter(None, (row.status_text, row.witness_text)))
                yield from _wrapped(f"{row.name}: {row.title} ({row.edition}); {told}")


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
    used = {place for publication, cited_at, _ in cited.values() if publication is row for place in cited_at}
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
        "name": row.name,
        "title": row.title,
        "edition": row.edition,
        "status": row.status,
        "known": str(KNOWN[row.known]),
        "known_at": {place: str(KNOWN[known]) for place, known in row.where.items()},
        "title_from_memory": row.title_from_memory,
        "status_from_memory": row.status_from_memory,
        "formulas": [name for name, _ in _users(row)],
    }


# --- contralbero oils
# The oils that a design may name, and what is known of each of their values.

TEMPERATURES = (40.0, 60.0, 80.0, 100.0, 120.0)  # °C


def run_oils(asked: Namespace) -> int:
    known = oils()
    if asked.name is not None and asked.name not in known:
        near = get_close_matches(asked.name, list(known), 1, 0.4)
        hint = Text('did you mean "{oil}"?', oil=near[0]) if near else Text("known are {oils}", oils=", ".join(known))
        raise BadInput(
            "contralbero oils", [InputError(0, "", f'"{asked.name}"', Text("is not known; {hint}", hint=hint))]
        )
    tables = _list(known.values()) if asked.name is None else _one_oil(known[asked.name])
    if asked.json:
        about: dict[str, Any] = {"schema": 1, "program": "contralbero", "version": VERSION}
        if asked.name is not None:
            about |= {"oil": asked.name, "source": known[asked.name].source}
        print(
            json.dumps(
                {**about, "tables": {table.id: table_json(table) for table in tables}}, ensure_ascii=False, indent=1
            )
        )
        return 0
    for n, table in enumerate(tables):
        print(("\n" if n else "") + "\n".join(table_lines(table)))
    return 0


def _list(known: Any) -> list[Table]:
    """All oils, a row each."""
    columns = (
        (Text("Oil"), ""),
        (Text("Base"), ""),
        (Name("ν40"), "mm²/s"),
        (Name("ν100"), "mm²/s"),
        (Name("VI"), ""),
        (Name("ρ15"), "kg/m³"),
        (Name("η40"), "mPa·s"),
        (Name("η100"), "mPa·s"),
        (Name("α40"), "1/GPa"),
        (Name("Λ"), ""),
        (Text("Confidence"), "at least"),
    )
    note = Text(
        "At 40, 100 and 15 °C. VI: viscosity index; α: rise of the viscosity with pressure; Λ: limiting shear stress "
        "over pressure. "
        "`contralbero oils NAME` tells where each value comes from."
    )
    return [Table("oils", Text("Oils that a design may name"), columns, tuple(_row(oil) for oil in known), note)]


def _row(oil: Oil) -> tuple[str | float | None, ...]:
    lubricant = Lubricant(oil)
    cold, hot = lubricant.at(40.0), lubricant.at(100.0)
    index = viscosity_index(lubricant.nu40, lubricant.nu100)
    return (
        oil.name,
        oil.base,
        _shown(lubricant.nu40, "mm²/s"),
        _shown(lubricant.nu100, "mm²/s"),
        index if index is None else float(round(index)),
        oil.rho15,
        _shown(cold.mu, "mPa·s"),
        _shown(hot.mu, "mPa·s"),
        _shown(lubricant.alpha(cold.mu), "1/GPa"),
        lubricant.limiting_shear,
        least_sure(oil)[0],
    )


def _one_oil(oil: Oil) -> list[Table]:
    """One oil: its values, its viscosity over temperature, what is printed for it elsewhere."""
    lubricant = Lubricant(oil)
    states = [(T, lubricant.at(T)) for T in TEMPERATURES]
    rows = tuple(
        (
            T,
            _shown(s.nu, "mm²/s"),
            _shown(s.mu, "mPa·s"),
            _shown(s.rho, "kg/m³"),
            _shown(lubricant.alpha(s.mu), "1/GPa"),
            round(lubricant.beta(T), 5),
        )
        for T, s in states
    )
    units = {"T": "°C", "ν": "mm²/s", "η": "mPa·s", "ρ": "kg/m³", "α": "1/GPa", "β": "1/K"}
    columns = tuple((Name(symbol), unit) for symbol, unit in units.items())
    index = viscosity_index(lubricant.nu40, lubricant.nu100)
    note = Text("Walther's law through the two viscosities.")
    if index is not None:
        note = Text("{law} Viscosity index {index}.", law=note, index=Amount(index, form=".0f"))
    law = Table("oil_law", Text("Oil {oil}: viscosity over temperature", oil=oil.name), columns, rows, note)
    printed = printed_table(lubricant)
    return [values_table(oil), law, *([printed] if printed is not None else [])]


def _shown(inside: float, unit: str) -> float:
    """Four digits, which is more than any of these is known to."""
    return float(f"{UNITS[unit].shown(inside):.4g}")


# --- contralbero makers
# The journals of balance shafts as makers print them; of one engine all that its sheet says, with its address.


def run_makers(asked: Namespace) -> int:
    known = maker_sheets()
    sheet = None if asked.name is None else _sheet_meant(asked.name, known)
    tables = [_all_sheets(known.values())] if sheet is None else _one_sheet(sheet)
    if asked.json:
        about: dict[str, Any] = {"schema": 1, "program": "contralbero", "version": VERSION}
        if sheet is not None:
            about |= {"engine": sheet.name, "title": sheet.title, "address": sheet.address, "confidence": CONFIDENCE}
        shown = {table.id: table_json(table) for table in tables}
        print(json.dumps({**about, "tables": shown}, ensure_ascii=False, indent=1))
        return 0
    for n, table in enumerate(tables):
        print(("\n" if n else "") + "\n".join(table_lines(table)))
    if sheet is not None:  # whole, to be copied: in a table it would be as wide as all of it
        print(f"\n{sheet.title}\n{sheet.address}\n{str(CONFIDENCE)[:1].upper()}{str(CONFIDENCE)[1:]}.")
    return 0


def _sheet_meant(word: str, known: Mapping[str, MakerSheet]) -> MakerSheet:
    """The sheet of that engine, or the one whose engine holds the word, however it is written: er6n is ER-6n."""
    meant = [name for name in known if _letters(word) in _letters(name)] if word not in known else [word]
    if len(meant) == 1:
        return known[meant[0]]
    if meant:
        hint = Text("may be {names}", names=", ".join(f'"{name}"' for name in meant))
    else:
        hint = Text("is not known; `contralbero makers` lists all")
    raise BadInput("contralbero makers", [InputError(0, "", f'"{word}"', hint)])


def _letters(name: str) -> str:
    return "".join(filter(str.isalnum, name.casefold()))


def _all_sheets(sheets: Iterable[MakerSheet]) -> Table:
    """A row for each journal; engines of which no journal is printed have one row."""
    columns = (
        (Text("Engine"), ""),
        (Text("Place"), ""),
        (Text("Ratio"), ""),
        (Text("Assembly"), ""),
        (Name("d"), "mm"),
        (Text("Wall"), "mm"),
        (Text("Clearance"), "µm"),
        (Name("ψ"), "‰"),
    )
    rows = tuple(
        (
            sheet.name,
            journal.place,
            sheet.ratio,
            sheet.assembly,
            _maybe(journal.diameter, "mm", 5),
            _maybe(journal.wall_middle, "mm", 5),
            _range(journal.stated_clearance[0] if journal.stated_clearance else (), "µm"),
            _maybe(journal.relative_clearance, "‰", 3),
        )
        for sheet in sheets
        for journal in sheet.journals or (MakerJournal(),)
    )
    note = Text(
        "d and wall: middles of their limits. Clearance: as printed, else by the diameters that are printed; ψ: its "
        "middle over d. Empty: not printed. `contralbero makers NAME` tells all of a sheet, with its address."
    )
    return Table("makers", Text("Journals of balance shafts as makers print them"), columns, rows, note)


def _one_sheet(sheet: MakerSheet) -> list[Table]:
    """All that a sheet prints: of the engine, then of each journal."""
    said = [
        (about.about.label, _fact(getattr(sheet, about.attribute), about.about.unit), about.about.unit)
        for about in keys(MakerSheet).values()
        if about.about.kind != "tables" and about.key not in ("name", "title", "address")
    ]
    heads = tuple((head, "") for head in (Text("Value"), Text("Printed"), Text("Unit")))
    rows = tuple((label, fact, unit) for label, fact, unit in said if fact)
    tables = [Table("maker", Text("{engine}: what its sheet says", engine=sheet.name), heads, rows)]
    if sheet.journals:
        tables.append(_journals(sheet))
    return tables


def _journals(sheet: MakerSheet) -> Table:
    """A column for each number that is printed of a journal, and a row for each journal."""
    printed = [
        about
        for about in keys(MakerJournal).values()
        if any(_fact(getattr(journal, about.attribute), about.about.unit) for journal in sheet.journals)
    ]
    columns = (
        *((about.about.label, about.about.unit) for about in printed),
        (Text("Clearance is"), ""),
        (Name("ψ"), "‰"),
    )
    rows = tuple(
        (
            *(_fact(getattr(journal, about.attribute), about.about.unit) for about in printed),
            journal.stated_clearance[1] if journal.stated_clearance else None,
            _maybe(journal.relative_clearance, "‰", 3),
        )
        for journal in sheet.journals
    )
    return Table("maker_journals", Text("{engine}: journals", engine=sheet.name), columns, rows)


def _fact(value: Any, unit: str) -> str:
    """What a sheet prints: a number or limits in its unit, or words; empty where it prints nothing."""
    if isinstance(value, tuple):
        return _range(value, unit)
    return f"{UNITS[unit].shown(value):g}" if isinstance(value, float) else str(value or "")


def _range(limits: tuple[float, ...], unit: str) -> str:
    """The limits of each class in turn."""
    ends = [f"{UNITS[unit].shown(x):.6g}" for x in limits]
    return ", ".join(f"{low}–{high}" for low, high in zip(ends[::2], ends[1::2]))


def _maybe(inside: float | None, unit: str, digits: int) -> float | None:
    return None if inside is None else float(f"{UNITS[unit].shown(inside):.{digits}g}")


# --- contralbero errata
# What is wrong in the documents that this program grew out of, with the right values computed.


def run_errata(asked: Namespace) -> int:
    source = _document_meant(asked.source) if asked.source else ""
    errata = list(misprints(source))
    if asked.json:
        rows = [
            {**{f.name: getattr(erratum, f.name) for f in fields(Misprint)}, "command": erratum.command}
            for erratum in errata
        ]
        print(
            json.dumps(
                {"schema": 1, "program": "contralbero", "version": VERSION, "errata": rows},
                ensure_ascii=False,
                indent=1,
            )
        )
    elif asked.markdown:
        print(markdown())
    else:
        for name, title in documents().items():
            if of_it := [erratum for erratum in errata if erratum.source == name]:
                print(f"{title} ({name}): {len(of_it)} error{'s' if len(of_it) != 1 else ''}\n")
                for erratum in of_it:
                    print("\n".join(_lines(erratum)))
    return 0


def _document_meant(word: str) -> str:
    """The document whose short name holds a word, like `finotti`."""
    meant = [name for name in documents() if word.casefold() in name.casefold()]
    if len(meant) == 1:
        return meant[0]
    known = Text("give one of {names}, or a word of it", names=", ".join(f'"{name}"' for name in documents()))
    raise BadInput("contralbero errata", [InputError(0, "", f'"{word}"', known)])


def _lines(erratum: Misprint) -> list[str]:
    at = (
        f"{erratum.place}, line {erratum.lines}"
        if "," not in erratum.lines and "-" not in erratum.lines
        else f"{erratum.place}, lines {erratum.lines}"
    )
    shown = [
        f"  {erratum.about}  [{at}]",
        *_wrapped_erratum("printed", erratum.as_printed),
        *_wrapped_erratum("right", erratum.right),
        *_wrapped_erratum("", erratum.why),
    ]
    return [*shown, *([f"    {'':<8}> {erratum.command}"] if erratum.command else []), ""]


def _wrapped_erratum(head: str, text: str) -> list[str]:
    return textwrap.wrap(
        text, WIDE, initial_indent=f"    {head:<8}", subsequent_indent=" " * 12, break_long_words=False
    )


def markdown() -> str:
    """All errata as the page docs/errata.md."""
    out = [
        "# Errors in the sources",
        "",
        "What is wrong in the three documents that this program grew out of: what is printed, what is right, and why. "
        "Right numbers are",
        "the program's own; the command below a row shows how each is worked out. Lines are those of the plain text "
        "of the document.",
        "",
        f"{caveat()} Below",
        "what is printed stands the line itself, ten words at most, and who may be wrong: author, print, or copy, "
        "which is that plain text.",
        "",
        "The table behind this page is `calc/library/tables/errata.toml`; `contralbero errata --markdown > "
        "docs/errata.md` writes the page.",
    ]
    for name, title in documents().items():
        of_it = list(misprints(name))
        out += [
            "",
            f"## {title} ({name}): {len(of_it)} error{'s' if len(of_it) != 1 else ''}",
            "",
            "| where | what | printed | right | why |",
            "|---|---|---|---|---|",
        ]
        for erratum in of_it:
            why = f"{erratum.why}<br>`{erratum.command}`" if erratum.command else erratum.why
            cells = f"{erratum.place}; {erratum.lines}", erratum.about, erratum.as_printed, erratum.right, why
            out.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(out)


# --- contralbero validate
# Values of others beside ours, what is met and what is not.


def run_validate(asked: Namespace) -> int:
    compared, missed = rows(), list(unmet())
    failed = [row for row in compared if row.verdict == "fail"]
    if asked.json:
        print(
            json.dumps(
                {
                    "schema": 1,
                    "program": "contralbero",
                    "version": VERSION,
                    "rows": [
                        {
                            "kind": r.kind,
                            "source": r.source,
                            "what": r.what,
                            "published": r.published,
                            "ours": r.ours,
                            "tolerance": r.tolerance,
                            "unit": r.unit,
                            "deviation": r.deviation,
                            "verdict": r.verdict,
                        }
                        for r in compared
                    ],
                    "unmet": [
                        {
                            "source": u.source,
                            "what": u.what,
                            "printed": u.printed,
                            "ours": u.ours,
                            "unit": u.unit,
                            "deviation": u.deviation,
                            "why": u.why,
                        }
                        for u in missed
                    ],
                },
                ensure_ascii=False,
                indent=1,
            )
        )
        return 1 if failed else 0
    for kind, of_kind in groupby(compared, lambda row: row.kind):
        print(f"\n{VALIDATION_KINDS[kind]}\n{'─' * len(VALIDATION_KINDS[kind])}")
        for source, of_it in groupby(of_kind, lambda row: row.source):
            print("\n".join([f"\n{source}", *map(_line, of_it)]))
    print(f"\n{(head := 'Printed, and not what this program gives')}\n{'─' * len(head)}")
    for (source, why), of_source in groupby(missed, lambda entry: (entry.source, entry.why)):
        reason = textwrap.wrap(why, WIDE, initial_indent="  ", subsequent_indent="  ", break_long_words=False)
        print("\n".join([f"\n{source}", *map(_missed, of_source), *reason]))
    print()
    for kind, title in VALIDATION_KINDS.items():
        verdicts = [row.verdict for row in compared if row.kind == kind]
        print(f"{title}: {verdicts.count('pass')} of {len(verdicts)} met within the tolerance of the source.")
    print(f"Printed, and not met: {len(missed)}, each with its reason above.")
    return 1 if failed else 0


def _line(row: ValidationRow) -> str:
    return (
        f"  {sign(row.verdict):<7} {row.what:<52} theirs {short(row.published, 6):>10} ± {short(row.tolerance, 2):<8} "
        f"ours {short(row.ours, 6):>10} {row.unit:<8} {row.deviation * 100:+.3f} %"
    ).replace("-", "−")


def _missed(entry: Unmet) -> str:
    return (
        f"  differs {entry.what:<52} theirs {short(entry.printed, 6):>10}   {'':<8} "
        f"ours {short(entry.ours, 6):>10} {entry.unit:<8} {short(entry.deviation * 100, 2)} %"
    ).replace("-", "−")
