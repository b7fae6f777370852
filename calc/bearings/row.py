# SPDX-License-Identifier: Apache-2.0
"""What a row of [[shafts.bearings]] says of a bearing of any kind."""

from collections.abc import Iterable
from typing import Any

from ..library import journal_rules as rules
from ..sheet.quantity import choice, inputs, quantity, series, text
from ..sheet.text import Amount, Text

ASKED_ELSEWHERE: Any = None  # left out by the file's own rules; where it is needed, the whole design says so
OF_ITS_OWN = Text("Supply and seat of its own")  # folds of the form
SEAT = Text("Seat")


@inputs
class SupportRow:
    """One bearing in its place."""

    name: str = text("Name", help="front, middle, rear or any other word; not figures alone.", decides=5)
    position: float = quantity(
        "Position",
        "mm",
        default=ASKED_ELSEWHERE,
        within=(-5000, 5000),
        symbol="z_B",
        help="Middle of the journal from mid-shaft, + towards the flywheel; the rows rise from front to rear.",
        change=("shorter span", "longer span"),
        repair="free",
        decides=6,
    )
    kind: str = choice(
        "Kind",
        "plain",
        "rolling",
        default="plain",
        help="plain: a journal in its seat, on a film of oil. rolling: balls, rollers or needles.",
        decides=6,
    )
    load: float | None = quantity(
        "Load",
        "N",
        default=None,
        up_to=1e7,
        symbol="F",
        step=50,
        help="Radial load on the journal. Left out: the reaction of the shaft.",
        repair="asked",
    )
    offset: tuple[float, ...] | None = series(
        "Bore off the line",
        "µm",
        default=None,
        count=(2, 2),
        within=(-1000, 1000),
        symbol="g_B",
        help="Up, and 90° further in the sense of the crank: the bore of an inner bearing off the line of the outer "
        "two.",
    )
    slope: float | None = quantity(
        "Slope of the journal",
        "mrad",
        default=None,
        within=(0, 20),
        symbol="theta",
        usual=(0, rules.SLOPE * 1e3),
        source="Finotti 2013, 4.6 (in chapter 6)",
        help="In its seat. Left out: by bending, else 0.1.",
        change=("smaller slope", "larger slope", "slope of the shaft's bending"),
        repair="asked",
    )
    carrier_bore: tuple[float, ...] | None = series(
        "Bore for its carrier",
        "mm",
        default=None,
        count=(1, 2),
        up_to=2000,
        symbol="D_c",
        step=0.5,
        help='With assembly = "cartridge": the bore of the block that the carrier of an outer bearing fills; through '
        "it the shaft comes in.",
        change=("smaller carrier", "larger carrier"),
        repair="free",
    )
    carrier: tuple[float, ...] | None = series(
        "Outside of its carrier",
        "mm",
        default=None,
        count=(1, 2),
        up_to=2000,
        symbol="D_k",
        help="One number, or least and most. With the bore for it: whether it goes in.",
    )
    bore: tuple[float, ...] | None = series(
        "Limits of the housing's bore",
        "mm",
        default=None,
        count=(1, 2),
        up_to=1000,
        symbol="D_b",
        help='Least and most; with seat = "direct" of the seat itself. Of a rolling bearing of its own size: one '
        "number, its bore.",
        fold=SEAT,
    )
    housing_outer: float | None = quantity(
        "Outside of the housing",
        "mm",
        default=None,
        up_to=2000,
        symbol="D",
        step=1,
        help="Of a ring as stiff as the metal around the bore. Left out: twice the bore.",
        change=("less metal around the bore", "more metal around the bore"),
        repair="free",
        fold=SEAT,
    )
    housing_material: str | None = text(
        "Housing material",
        help="A name from the table of materials or from [[material]].",
        change=("another housing",),
        catalogue="materials",
        default=None,
        fold=OF_ITS_OWN,
    )
    seat_fit: str | None = text(
        "Seat fit",
        help="ISO 286: H7 and the like, or a bare field, IT7.",
        change=("closer fits", "wider fits", "closer fits"),
        default=None,
        fold=OF_ITS_OWN,
    )

    # what its kind says of it

    def place(self) -> tuple[float, float] | None:
        """The diameter that it takes of the shaft, and its width along it, m; None where they are not known."""
        return None

    def opening(self) -> float:
        """Of a place that is known the diameter, m, that its seat leaves to what comes in through it; infinite: nothing
        has to."""
        place = self.place()
        assert place is not None
        return place[0]

    def least_opening(self) -> float:
        """The same by the limits of its parts."""
        return self.opening()

    def size_keys(self) -> tuple[str, ...]:
        """The keys that say its size."""
        return ()

    def size_words(self) -> Text:
        """Its size in words, where it is known."""
        return Text("")

    def fed(self) -> bool:
        """Whether it runs on a film of oil that is brought to it, as [bearings] says of supply and seat."""
        return False

    def kind_problems(self) -> Iterable[tuple[str, Text]]:
        """What is wrong with it by itself, by the keys of its row."""
        return ()


LEAST_METAL = 2e-3  # m, in diameter


def more_metal(bore: float) -> Text:
    """What an outside of the housing is told that leaves next to nothing around this bore."""
    least = Amount((bore + LEAST_METAL) * 1e3, "mm", form="g")
    return Text("must be above {least}: the bore and 1 mm of metal around it", least=least)
