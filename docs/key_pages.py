# SPDX-License-Identifier: Apache-2.0
"""The reference of every key of the design file, from the declarations that the schema, the form and the reader share."""

import re
from collections import defaultdict
from collections.abc import Iterator

from calc.design.model import SCHEMA, STEPS, Design
from calc.design.toml_file import load_design
from calc.sheet.check import RULES
from calc.sheet.number import short
from calc.sheet.quantity import REQUIRED, Key, Quantity, keys
from calc.solve import solve
from calc.studies.explain import needs
from calc.studies.shipped import DESIGNS

# pages by the first parts of their tables, the longest first; what lies in none of them is of the design as a whole
PAGES = {
    "shafts.bearings": ("keys_shaft_bearings", "Keys: the bearings of a shaft"),
    "engine": ("keys_engine", "Keys: engine"),
    "imbalance": ("keys_imbalance", "Keys: imbalance"),
    "shafts": ("keys_shafts", "Keys: balance shafts"),
    "bearings": ("keys_bearings", "Keys: bearings in common"),
    "gears": ("keys_gears", "Keys: gears"),
    "friction": ("keys_friction", "Keys: friction"),
    "mounting": ("keys_mounting", "Keys: mounting"),
    "": ("keys_design", "Keys: the design as a whole"),
}
STEP_OF = {"shafts": "countershaft"}  # the step that a table belongs to, where it is called otherwise
MADE = "Made by `python docs/generate.py` from the declarations in the code."
INDEX = """# Every key of a design file

What each key is called, its unit, and where it is described: {count} keys, in the order of their labels. Search this page for a word of
the trade (*hole*, *runout*, *roughness*) or for a part of the key. The [guide to the file](../design_file.md) tells how the tables
go together. {made}

| page | tables |
|---|---|
{pages}

| label | unit | key |
|---|---|---|
{rows}
"""
HEAD = """# {title}

Each key with its label and unit, what is allowed, and what stands for it where it is left out. It is used by the step of its table, by those
whose formulas take it as it stands (in the shipped designs), and by those whose checks it moves. [All keys by their labels](keys.md); [the kinds of checks](../checks.md). {made}
"""
ELEMENT = re.compile(r"\.(?:\*|#|[A-Z]+)(?=\.)")  # the place of a name in a key: shafts.S.bearings.B.length_mm


def declared(table: type = Design, path: str = "", kind: str = "") -> Iterator[tuple[str, str, list[tuple[str, Key]]]]:
    """Every table with its keys, then the tables in it: its path, how it is opened in a file, its keys by their paths."""
    opened = {"": "The head of the file", "tables": f"`[[{path}]]`"}.get(kind, f"`[{path}]`")
    entries = [(f"{path}.{key}".removeprefix("."), entry) for key, entry in keys(table).items()]
    yield path, opened, entries
    for inner, entry in entries:
        if entry.about.table is not None:
            yield from declared(entry.about.table, inner, entry.about.kind)


def readers() -> dict[str, set[str]]:
    """The steps whose formulas take a key as it stands, by its path: as the lines of all shipped designs have it."""
    found: dict[str, set[str]] = defaultdict(set)
    for design in sorted(DESIGNS.glob("*.toml")):
        for step, outcome in solve(load_design(design)).outcomes.items():
            for line in outcome.lines:
                for key in needs(line)[1]:
                    found[_path(key)].add(step)
    return found


def _path(address: str) -> str:
    """The key of an address, without the names of elements in it, and without what a name brings in."""
    table: type | None = Design
    path, parts = [], address.partition(" ")[0].split(".")
    while parts and table is not None and (entry := keys(table).get(parts[0])) is not None:
        path.append(parts[0])
        table, many = entry.about.table, entry.about.kind == "tables"
        parts = parts[2 if many else 1 :]
    return ".".join(path)


def key_pages() -> dict[str, str]:
    """The text of each page by the name of its file; all checks are to be loaded."""
    moves: dict[str, list[str]] = defaultdict(list)
    for rule in RULES.values():
        for key in rule.moved_by:
            moves[ELEMENT.sub("", key)].append(rule.id)
    read = readers()
    parts = {page: [HEAD.format(title=title, made=MADE)] for page, title in PAGES.values()}
    tables: dict[str, list[str]] = {page: [] for page in parts}
    rows = []
    for table, opened, entries in declared():
        page = next(page for start, (page, _) in PAGES.items() if f"{table}.".startswith(f"{start}.") or not start)
        tables[page].append(opened)
        parts[page].append(f"\n## {opened}\n")
        for path, entry in entries:
            about = entry.about
            parts[page].append(_entry(path, entry, read[path], sorted(set(moves[path]))))
            row = f"| {plain(about.label)} | {about.units.symbol} | [`{path}`]({page}.md#{path}) |"
            rows.append((str(about.label).casefold(), row))
    index = INDEX.format(
        count=len(rows),
        made=MADE,
        pages="\n".join(f"| [{title}]({page}.md) | {' '.join(tables[page])} |" for page, title in PAGES.values()),
        rows="\n".join(row for _, row in sorted(rows)),
    )
    return {"reference/keys.md": index} | {f"reference/{page}.md": "\n".join(some) for page, some in parts.items()}


def _entry(path: str, entry: Key, read: set[str], moved: list[str]) -> str:
    """One key: a heading with its anchor, then what is known of it.  The key stands there by itself, dotted and in
    words, since a search takes each of them whole."""
    about = entry.about
    unit = f", in {about.units.symbol}" if about.units.symbol else ""
    words = f" ({said})" if (said := _said(entry)) else ""
    lines = [
        f'### <a id="{path}"></a>`{entry.key}`\n',
        f"`{path}`: **{plain(about.label)}**{words}{unit}.",
    ]
    if about.help:
        lines.append(_sentence(plain(about.help)))
    lines.append(f"\n- Allowed: {plain(about.allowed())}.")
    if about.catalogue:
        shipped = getattr(Design(schema=SCHEMA, name=""), about.catalogue)
        lines.append("- Shipped: " + ", ".join(f'`"{name}"`' for name in shipped) + ".")
    lines.append(f"- {_left_out(entry)}")
    if about.usual:
        source = f" ({plain(about.source)})" if about.source else ""
        lines.append(
            f"- Usual: {short(about.usual[0], 10)} to {short(about.usual[1], 10)}{_after(about.units.symbol)}{source}."
        )
    elif about.source:
        lines.append(f"- Source: {plain(about.source)}.")
    if about.where is not None:
        choice = about.where.choice.name.rstrip("_")
        words = " or ".join(f'`"{word}"`' for word in about.where.words)
        lines.append(f"- Only with `{choice}` = {words}.")
    lines.append(f"- Used by: {_users(path, about, read, moved)}.")
    if moved:
        lines.append(f"- Checks that it moves: {', '.join(f'`{id}`' for id in moved)}.")
    return "\n".join(lines) + "\n"


def _said(entry: Key) -> str:
    """The words of a key, where its label and help have others: whoever looks for one of them shall find it."""
    words = entry.key.removesuffix(entry.about.units.suffix).replace("_", " ")
    there = f"{entry.about.label} {entry.about.help}".casefold()
    return "" if all(word.casefold() in there for word in words.split()) else words


def _after(unit: str) -> str:
    return f" {unit}" if unit else ""


def _left_out(entry: Key) -> str:
    about, default = entry.about, entry.field.default
    if default is REQUIRED:
        return "Must be given."
    if default is None or default in ("", ()):
        return "May be left out."
    if isinstance(default, bool):
        return f"Left out: `{str(default).lower()}`."
    if isinstance(default, str):
        return f'Left out: `"{default}"`.'
    if isinstance(default, tuple):
        return f"Left out: {', '.join(short(about.units.shown(x), 10) for x in default)}{_after(about.units.symbol)}."
    return f"Left out: {short(about.units.shown(default), 10)}{_after(about.units.symbol)}."


def _users(path: str, about: Quantity, read: set[str], moved: list[str]) -> str:
    """The steps that a key serves: that of its table, those in whose form it stands too, those whose formulas take it
    as it stands and those whose checks it moves."""
    first = path.partition(".")[0]
    if first == "optimise":
        return "[the search for a whole drive](../drive.md)"
    if first in ("oil", "material"):
        return f"whatever names this {first}"
    wanted = {STEP_OF.get(first, first), *about.taken_by, *read, *(id.partition(".")[0] for id in moved)}
    steps = [f"[{str(step.title).lower()}](../theory/{step.key}.md)" for step in STEPS if step.key in wanted]
    return ", ".join(steps) or "the design as a whole"


def plain(words: object) -> str:
    """Words of the program as Markdown has them; of its own signs it has only code."""
    return str(words).replace("|", "\\|").replace("*", "\\*").replace("<", "&lt;")


def _sentence(words: str) -> str:
    return words if words.endswith((".", "!", "?")) else f"{words}."
