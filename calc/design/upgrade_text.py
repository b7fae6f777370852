# SPDX-License-Identifier: Apache-2.0
"""The text of a design file of schema 1 as schema 2 has it, line by line, so that comments and order stay.

tomlkit can rename no table and keep its place: the text is cut into blocks at the heads of its tables, which are
renamed, moved and taken apart.  What comes out is proved: it says what `upgraded` says, and no comment is missing.  A
notation that does not bear this is written afresh."""

import tomllib
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from ..sheet.errors import BadInput, InputError, written
from ..sheet.record import record, replace
from ..sheet.text import Text
from ..sheet.toml_scan import TOKEN, key_lines, remarks
from .upgrade import (
    FRONT,
    JOURNAL_KEYS,
    JOURNALS,
    PAIR,
    POSITIONS,
    REAR,
    SHAFT,
    SLOPES,
    Table,
    Upgraded,
    elements,
    own_key,
    renamed,
    upgraded,
)


@record
class UpgradedText:
    """A text of schema 2.  `kept`: it is the old one but for what had to change; else it was written afresh, and the
    comments `lost` are not in it."""

    text: str
    kept: bool = True
    lost: tuple[str, ...] = ()


def upgraded_text(text: str, place: str = "design") -> UpgradedText:
    """The text of a design file in schema 2; one that is of schema 2, as it is.  Byte order mark, line ends and the end
    of the last line stay.

    Raises BadInput where the schema is neither, or what goes elsewhere is not well formed; tomllib.TOMLDecodeError
    where the text is no TOML."""
    mark = "\ufeff" if text.startswith("\ufeff") else ""
    crlf = text.count("\r\n") > 0 and text.count("\r\n") == text.count("\n")
    body = text.removeprefix(mark).replace("\r\n", "\n") if crlf else text.removeprefix(mark)
    data, lines = tomllib.loads(body), key_lines(body)
    schema = data.get("schema")
    if type(schema) is int and schema == 2:
        return UpgradedText(text)
    if type(schema) is not int or schema != 1:
        newer = isinstance(schema, int) and schema > 2
        reason = Text("needs a newer program") if newer else Text("must be 1, or 2, which stays as it is")
        raise BadInput(place, [InputError(lines.get("schema", 1), "schema", written(schema), reason)])
    new = upgraded(data, lines)
    if new.errors:
        raise BadInput(place, list(new.errors))
    closed = body if body.endswith("\n") else body + "\n"
    made = _Edited(closed, data, new).text()
    missing = _comments(closed) - _comments(made)
    if kept := not missing and _says(made, new.data):
        made = made if body.endswith("\n") else made.removesuffix("\n")
    else:
        made = _afresh(closed, new)
        missing = _comments(closed) - _comments(made)
    return UpgradedText(mark + (made.replace("\n", "\r\n") if crlf else made), kept, tuple(missing.elements()))


def _says(text: str, data: Table) -> bool:
    try:
        return tomllib.loads(text) == data
    except tomllib.TOMLDecodeError:
        return False


def _afresh(text: str, new: Upgraded) -> str:
    """The design as a program writes it, with the comments that stood beside a key or a head."""
    import tomli_w

    fresh = tomli_w.dumps(new.data)
    beside = renamed(remarks(text), new.data, new.was)
    words = {line: f"   # {beside[key]}" for key, line in key_lines(fresh).items() if key in beside}
    return "\n".join(line + words.get(n, "") for n, line in enumerate(fresh.split("\n"), 1))


# --- the text in pieces


@record
class Piece:
    """Whole lines of a text: the head of a table (`name` is its), a key with its value (`key`), or neither.

    `tail`: of a head what stands behind its brackets.  `inside`: the comments before the last line of a value,
    `behind`: the one on it."""

    text: str
    name: tuple[str, ...] = ()
    key: tuple[str, ...] = ()
    tail: str = ""
    inside: tuple[str, ...] = ()
    behind: str = ""


@record
class Block:
    """A table: the lines of comment or of nothing right above its head, the head, and what follows.  What stands before
    the first head is one without."""

    above: list[Piece]
    head: Piece
    body: list[Piece]


def _pieces(text: str) -> Iterator[Piece]:
    """The pieces of a text that ends with the end of a line."""
    start = depth = opened = tail = 0
    parts, comments = list[str](), list[tuple[int, str]]()
    reading = True  # the name or the key, and not what follows
    for token in TOKEN.finditer(text):
        kind, end = token.lastgroup, token.end()
        if kind == "newline" and not depth:
            last_line = text.rfind("\n", start, end - 1)
            inside = tuple(comment for at, comment in comments if at < last_line)
            behind = "".join(comment for at, comment in comments if at > last_line)
            name, key = (tuple(parts), ()) if opened else ((), tuple(parts))
            yield Piece(text[start:end], name, key, text[tail:end] if opened else "", inside, behind)
            start, opened, parts, comments, reading = end, 0, [], [], True
        elif kind == "comment":
            comments.append((token.start(kind), token[kind].strip()))
        elif kind in ("word", "string") and reading:
            parts.append(token[kind].strip("\"'"))
        elif kind == "sign":
            sign = token[kind]
            if reading and sign == "[" and not parts:
                opened += 1
            elif opened and sign == "]":
                tail, reading = end, False
            elif reading and sign == "=":
                reading = False
            elif not reading and not opened:
                depth += (sign in "[{") - (sign in "]}")


def _blocks(pieces: Iterable[Piece]) -> list[Block]:
    """What stands above a head, without a key between, goes with it."""
    blocks = [Block([], Piece(""), [])]
    for piece in pieces:
        body = blocks[-1].body
        if piece.name:
            n = _keys_end(body)
            blocks.append(Block(body[n:], piece, []))
            del body[n:]
        else:
            body.append(piece)
    return blocks


def _keys_end(body: Sequence[Piece]) -> int:
    """How many pieces of a body there are up to its last key."""
    return next((n for n in range(len(body), 0, -1) if body[n - 1].key), 0)


def _comments(text: str) -> Counter[str]:
    """All comments of a text."""
    pieces = list(_pieces(text))
    return Counter(words for piece in pieces for comment in _said(piece) if (words := comment.strip("# \t\r")))


def _said(piece: Piece) -> tuple[str, ...]:
    return (*piece.inside, piece.behind) if piece.behind else piece.inside


# --- the text of schema 2


class _Edited:
    """The blocks of a text of schema 1, and what is made of them."""

    def __init__(self, text: str, data: Table, new: Upgraded) -> None:
        self.blocks = _blocks(_pieces(text))
        self.data, self.new = data, new
        self.taken: dict[str, tuple[str, str]] = {}  # by old key: comments as lines, and the one behind
        self.seen: Counter[tuple[str, ...]] = Counter()  # of the heads so far
        self.own: dict[int, Block] = {}  # the blocks that become rows, by the place of their row
        self.shafts = elements(new.data, "shafts")
        self.wheels = elements(_table(new.data, "gears"), "wheels")
        self.measured = elements(data, "measured"), elements(new.data, "measured")
        self.names = {table: self._names(table) for table in ("locked", "optimise.vary")}

    def _names(self, table: str) -> Mapping[str, list[str]]:
        """The new keys of a table that go by others now, by their old ones."""
        names: dict[str, list[str]] = {}
        for key in _table(self.new.data, table):
            names.setdefault(own_key(self.new.was, f"{table}.{key}").removeprefix(f"{table}."), []).append(key)
        return names

    def text(self) -> str:
        rows = self._rows()
        edited = [(block, self._block(block)) for block in self.blocks if block not in rows]
        heads = [n for n, (block, _) in enumerate(edited) if block.head.name[:1] == ("countershaft",)]
        heads = heads or [n for n, (block, _) in enumerate(edited) if block.head.name == ("bearings",)]
        parts = [words for _, words in edited]
        if self.shafts and heads:
            parts.insert(heads[-1] + 1, "".join(self._shaft()))
        return "".join(parts)

    def _rows(self) -> Collection[Block]:
        """The blocks that become rows; `own` has them by the place of their row."""
        journals = [block for block in self.blocks if ".".join(block.head.name) == JOURNALS]
        ends = {("bearings", FRONT): 0, ("bearings", REAR): 1}
        self.own = dict(enumerate(journals))
        self.own |= {ends[block.head.name]: block for block in self.blocks if block.head.name in ends}
        return list(self.own.values())

    def _block(self, block: Block) -> str:
        """A block that stays in its place."""
        name, n = block.head.name, self.seen[block.head.name]
        self.seen[name] += 1
        table = ".".join(name)
        body = list[Piece]()
        for piece in block.body:
            key = ".".join((*name, *piece.key)) if piece.key else ""
            if key in (POSITIONS, JOURNALS, PAIR, SLOPES):
                body = self._without(body, key, piece)
            elif key == "schema":
                body.append(replace(piece, text=piece.text.replace("1", "2", 1)))
            elif table in self.names and len(piece.key) == 1:
                body += [_worded(piece, piece.key[0], new) for new in self.names[table].get(piece.key[0], [])]
                body += [] if piece.key[0] in self.names[table] else _lines(_said(piece))
            elif key == "measured.value":
                old, new = (_nth(rows, n).get("value") for rows in self.measured)
                body.append(_worded(piece, str(old), str(new)))
            else:
                body.append(piece)
            if key == "gears.wheels.name" and "shaft" in _nth(self.wheels, n):
                indent = piece.text[: len(piece.text) - len(piece.text.lstrip())]
                body.append(Piece(f'{indent}shaft = "{SHAFT}"\n', key=("shaft",)))
        if table == "countershaft" and "speed_ratio" not in _table(self.data, table):
            body = _behind_keys(body, "speed_ratio = -1\n")
        return _text((*block.above, replace(block.head, text=_head(block.head)), *body))

    def _without(self, body: list[Piece], key: str, piece: Piece) -> list[Piece]:
        """A body without the value that ends it, whose comments go where it goes; they stay where it goes nowhere."""
        sized = JOURNAL_KEYS[0] in _nth(elements(_nth(self.shafts, 0), "bearings"), 0)
        if (key == PAIR and len(self.shafts) < 2) or (key == JOURNALS and not sized):
            return [*body, *_lines(_said(piece))]
        n = next((n for n in range(len(body), 0, -1) if not _is_comment(body[n - 1])), 0)
        self.taken[key] = _text((*body[n:], *_lines(piece.inside))), piece.behind
        return body[:n]

    def _shaft(self) -> Iterator[str]:
        """What follows the blocks of the shaft: its head, where it had none, its bearings, and its twin."""
        shaft = self.shafts[0]
        if "countershaft" not in self.data:
            yield "\n" + _shaft_head() + self._given("", 0, shaft, ("mode",))
        for n, row in enumerate(elements(shaft, "bearings")):
            block = self.own.get(n, Block([], Piece("", tail="\n"), []))
            yield _text(block.above) or "\n"
            yield f"[[shafts.bearings]]{block.head.tail}"
            yield self._given("", n, row, ("name",)) + self._given(POSITIONS, n, row, ("position_mm",))
            yield self._given(JOURNALS, n, row, JOURNAL_KEYS if JOURNALS in self.taken else ())
            yield _text(_behind_keys(block.body, self._given(SLOPES, n, row, ("slope_mrad",))))
        for twin in self.shafts[1:]:
            yield "\n[[shafts]]\n" + self._given("", 0, twin, ("name",))
            yield self._given(PAIR, 0, twin, ("mirrors",)) + self._given("", 0, twin, ("axis_mm",))

    def _given(self, old: str, n: int, table: Table, keys: Iterable[str]) -> str:
        """Some keys of a table, of the row n; with the first of them the comments of the old key that said them: those
        above only in the first row, the one behind there and beside each slope."""
        above, behind = self.taken.get(old, ("", ""))
        there = [key for key in table if key in keys]
        beside = behind if n == 0 or old == SLOPES else ""
        lines = [f"{key} = {_toml(table[key])}{_spaced(beside) if key == there[0] else ''}\n" for key in there]
        return (above if n == 0 and there else "") + "".join(lines)


def _text(pieces: Iterable[Piece]) -> str:
    return "".join(piece.text for piece in pieces)


def _head(piece: Piece) -> str:
    """The head of a table that stays in its place."""
    if piece.name[:1] != ("countershaft",):
        return piece.text
    return piece.text.replace("countershaft", "shafts", 1) if piece.name[1:] else _shaft_head(piece.tail)


def _shaft_head(tail: str = "\n") -> str:
    return f'[[shafts]]{tail}name = "{SHAFT}"\n'


def _behind_keys(body: Sequence[Piece], text: str) -> list[Piece]:
    """A body with a text behind its last key."""
    n = _keys_end(body)
    return [*body[:n], Piece(text), *body[n:]]


def _is_comment(piece: Piece) -> bool:
    return not piece.key and piece.text.lstrip().startswith("#")


def _lines(comments: Iterable[str]) -> list[Piece]:
    return [Piece(f"{comment}\n") for comment in comments]


def _worded(piece: Piece, old: str, new: str) -> Piece:
    """A piece with a word in quotes for another."""
    quoted = next((word for word in (f'"{old}"', f"'{old}'") if word in piece.text), "")
    return replace(piece, text=piece.text.replace(quoted, f'"{new}"', 1)) if quoted and old != new else piece


def _toml(value: object) -> str:
    """A word, a number, or a list of numbers as TOML has them."""
    return f'"{value}"' if isinstance(value, str) else repr(value)


def _spaced(comment: str) -> str:
    return f"   {comment}" if comment else ""


def _table(data: Table, key: str) -> Table:
    """The table at a dotted key; an empty one where there is none."""
    here: object = data
    for part in key.split("."):
        here = here.get(part) if isinstance(here, dict) else None
    return here if isinstance(here, dict) else {}


def _nth(rows: Sequence[Table], n: int) -> Table:
    """One of several tables; an empty one where there are not so many."""
    return rows[n] if n < len(rows) else {}
