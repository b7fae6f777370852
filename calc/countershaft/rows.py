# SPDX-License-Identifier: Apache-2.0
"""One bearing of a shaft: a row of [[shafts.bearings]], front to rear.  What a row needs is asked by the whole design:
all of it where [bearings] judges the bearing, else its name, its place and its size alone."""

from collections.abc import Iterable, Mapping

from ..bearings.plain.row import PlainRow
from ..bearings.rolling.row import RollingRow
from ..bearings.row import ASKED_ELSEWHERE as ASKED_ELSEWHERE
from ..bearings.row import SupportRow
from ..library.journal_rules import IN_WORDS as IN_WORDS
from ..library.journal_rules import called as called
from ..library.journal_rules import titled as titled
from ..sheet.quantity import Key, Where, dotted, inputs, keys
from ..sheet.record import replace
from ..sheet.text import Text
from ..sheet.units import Metre

# keys of a shaft's inputs, of those of one of its bearings and of all of them, the names left open
SHAFT, ROW, EACH_ROW = "shafts.S", "shafts.S.bearings.B", "shafts.S.bearings.*"
KIND = keys(SupportRow)["kind"]


def row_key(row: str, field: object = "") -> str:
    """The key of one of the bearings, by its name, or of one of its inputs."""
    return dotted(SHAFT, "bearings", row, field) if field else dotted(SHAFT, "bearings", row)


def sign(row: str) -> str:
    """What stands for it in a symbol: f and r for front and rear."""
    return {"front": "f", "middle": "m", "rear": "r"}.get(row, row)


ROWS: dict[str, type[SupportRow]] = {"plain": PlainRow, "rolling": RollingRow}  # by the word of its kind


@inputs
class BearingRow(RollingRow, PlainRow, SupportRow):
    """One bearing in its place, of any kind."""

    @staticmethod
    def as_read(row: dict[str, object]) -> dict[str, object]:
        """A list under the key of the clearance is that before mounting; a size may be a number, 6205."""
        one, limits, size = map(dotted, (PlainRow.clearance, RollingRow.clearance_limits, RollingRow.size))
        if type(row.get(size)) is int:
            row = {**row, size: str(row[size])}
        if not isinstance(row.get(one), list) or limits in row:
            return row
        return {limits if key == one else key: content for key, content in row.items()}

    def with_own(self, twin: "BearingRow") -> "BearingRow":
        """The bearing of a twin: this one of its original, with what the twin's row says."""
        own = {entry.attribute: getattr(twin, entry.attribute) for entry in said_in(twin)}
        # one clearance, in place of what the original has: a number, or limits, some of which may be the original's
        if not CLEARANCES.isdisjoint(own):
            own = dict.fromkeys(CLEARANCES | LIMITS) | own
        elif not {"journal", "finished"}.isdisjoint(own):
            own = dict.fromkeys(CLEARANCES) | own
        if "clearance_class" in own:
            own = {"clearance_limits": None} | own
        if not PRESSES.isdisjoint(own):
            own = dict.fromkeys(PRESSES) | own
        return replace(self, **own)

    @property
    def in_words(self) -> Text:
        """Its name inside a sentence."""
        return called(self.name)

    @property
    def on_shaft(self) -> tuple[Metre, Metre] | None:
        """The diameter that it takes of the shaft, and its width along it; None where they are not known."""
        return self.place()

    @property
    def sized(self) -> bool:
        """Whether its size is known."""
        return self.on_shaft is not None

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.name.isascii() and self.name.isdigit():
            yield dotted(BearingRow.name), Text("must not be figures alone, by which elements are counted")
        yield from self.kind_problems()

    def of_others(self) -> Iterable[tuple[str, Text]]:
        """What it says that only bearings of other kinds have; the row of a twin is of the kind of its original."""
        for key, entry in keys(BearingRow).items():
            kinds = _kinds(entry.about.where)
            if self.kind and kinds and self.kind not in kinds:
                if getattr(self, entry.attribute) != entry.field.default:
                    yield key, Text('belongs to kind = "{kind}"', kind='" or "'.join(kinds))

    # what its kind answers

    @property
    def _row(self) -> type[SupportRow]:
        return ROWS.get(self.kind, SupportRow)  # of a word that is none nothing is known

    def place(self) -> tuple[Metre, Metre] | None:
        return self._row.place(self)

    def opening(self) -> Metre:
        return self._row.opening(self)

    def least_opening(self) -> Metre:
        return self._row.least_opening(self)

    def size_keys(self) -> tuple[str, ...]:
        return self._row.size_keys(self)

    def size_words(self) -> Text:
        return self._row.size_words(self)

    def fed(self) -> bool:
        return self._row.fed(self)

    def kind_problems(self) -> Iterable[tuple[str, Text]]:
        return self._row.kind_problems(self)


def _kinds(where: Where | None) -> tuple[str, ...]:
    """The kinds of bearings that have an input; empty: all."""
    while where is not None:
        if where.choice.name == KIND.attribute:
            return where.words
        where = where.choice.metadata["quantity"].where
    return ()


def of_new_kind(before: Mapping[str, object], row: Mapping[str, object]) -> dict[str, object]:
    """A row as a file has it, whose kind is another than before: without what only bearings of the former kind have,
    and without what a seat of each kind asks in its own way."""
    kind = row.get(KIND.key, KIND.field.default)
    if kind == before.get(KIND.key, KIND.field.default):
        return dict(row)
    here, known = dict(BearingRow.as_read(dict(row))), keys(BearingRow)
    others = {key for key in here if key in known and kind not in (_kinds(known[key].about.where) or (kind,))}
    return {key: content for key, content in here.items() if key not in others | OF_EACH}


OF_EACH = set(map(dotted, (BearingRow.bore, BearingRow.seat_fit)))  # of its seat, by which each kind means its own
PRESSES = {"interference", "crush"}  # what may say how a bush is pressed
CLEARANCES, LIMITS = {"clearance", "clearance_factor"}, {"journal", "bore", "finished"}  # what may say a clearance


def said_in(row: BearingRow) -> list[Key]:
    """What a row says beside its name."""
    _, *entries = keys(BearingRow).values()
    return [entry for entry in entries if getattr(row, entry.attribute) != entry.field.default]


# what a bearing of a twin has of its original
SIZES = BearingRow.position, BearingRow.kind, BearingRow.diameter, BearingRow.length, BearingRow.size
OF_ORIGINAL = tuple(map(dotted, (*SIZES, BearingRow.offset, BearingRow.carrier_bore, BearingRow.carrier)))
