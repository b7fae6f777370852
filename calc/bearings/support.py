# SPDX-License-Identifier: Apache-2.0
"""What a bearing of any kind is to its shaft: `Support` before its load is known, `Carrying` when it is.

A kind of bearing answers these two; the shaft, the power balance and the drawing ask nothing else.  How one is added
stands in CONTRIBUTING."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Protocol, Self, TypeVar

from ..countershaft.bending.carried import AnyLaw, Carried
from ..countershaft.bending.condensed import Condensed
from ..countershaft.outline import Outline
from ..countershaft.rows import BearingRow, row_key
from ..draw.annotations import SheetTable
from ..draw.drawing import Sketch
from ..draw.sizes import Say
from ..engine.operation import BenchPoint, Operation
from ..library.catalogue import Material
from ..library.journal_rules import named_at
from ..library.lubricant import Lubricant, OilState
from ..library.tolerances import ToleranceField
from ..sheet.arrays import Array, BoolArray, Value
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.quantity import dotted, result, value
from ..sheet.record import record
from ..sheet.shown import Shown
from ..sheet.step import Curve, Erratum, Table
from ..sheet.text import Text
from ..sheet.units import (
    Celsius,
    CubicMetrePerSecond,
    Kilogram,
    Metre,
    Newton,
    NewtonPerMetre,
    Number,
    Radian,
    RevPerSecond,
    Second,
    Watt,
)
from .inputs import BearingsInputs, ruled_by

if TYPE_CHECKING:
    from ..countershaft.result import CountershaftResult


@record
class Task:
    """What all bearings of a shaft are asked: `speed` of the shaft, 1/s, and its `ratio` to the crank, None where there
    is no engine.

    `life`: of the gears, where it is given.  `compared`: with other methods beside those that judge."""

    speed: RevPerSecond
    ratio: Number | None
    bench: tuple[BenchPoint, ...] = ()
    operation: tuple[Operation, ...] = ()
    life: Second | None = None
    compared: bool = True


@record
class OperatingPoint(Generic[Value]):
    """What a bearing has to do at one moment: load, journal speed, hydrodynamic speed and sliding speed over it, oil
    supply."""

    load: Value
    speed: Value
    effective_speed: Value
    sliding_ratio: Value
    supply_temperature: Value
    supply_pressure: Value


@record
class StandingLoads:
    """What does not turn with the shaft on one of its bearings, N: all of it, the weight alone, and along the shaft."""

    all: Newton
    weight: Newton
    axial: Newton


@result
class OnShaftResult(Shown):
    """How a journal lies in its bearing as the shaft turns, in the frame of the shaft, cylinder 1 at TDC; on more than
    two bearings, how the load is shared.  What has no size has no direction."""

    load_phase: Radian | None = value("Direction of the load, cylinder 1 at TDC", "°", "φ_P", default=None)
    share: Number | None = value("Load over that of rigid supports", "", "P/f_c", default=None)
    displacement: Metre = value("Displacement of the journal", "µm", "e")
    displacement_phase: Radian | None = value("its direction, cylinder 1 at TDC", "°", "φ_x", default=None)
    tilt: Radian = value("Tilt of the journal in its bearing", "mrad", "θ")
    tilt_along: Radian = value("of it in the plane of the narrowest gap", "mrad", "θ_x")
    film_edge_tilted: Metre | None = value(
        "Film at the edge, as the journal tilts in the films", "µm", "h_edge,θ", short=True, default=None
    )
    standing_stiffness: NewtonPerMetre | None = value(
        "Stiffness to a load that stands, mean over a turn", "N/mm", "k", default=None
    )
    alignment_load: Newton | None = value("Load of bores out of line, at most", "N", "R_c", default=None)
    film_alignment: Metre | None = value("Film under the load with that of the bores", "µm", "h_c", default=None)


class Answer(Protocol):
    """How the friction of a bearing answers to what stands on it, at one operating point or at many (arrays)."""

    @property
    def load(self) -> Any:
        """That turns, N."""

    @property
    def friction_power(self) -> Any:
        """Without a standing load, W."""

    @property
    def unsteady(self) -> bool:
        """Whether at some point nothing is known of the answer to a standing load."""

    def under(self, R_0: Any) -> Any:
        """The friction over a turn, W, with R_0 standing, N."""

    def only(self, some: BoolArray) -> "Answer":
        """Some of many operating points."""

    def note(self, place: str, R_0: Any) -> Text | None:
        """What is rough in the answer."""


class Support(Protocol):
    """One bearing of a shaft before its load is known.  The laws are those that `countershaft.bending.carried` asks
    for, in the frame of the shaft; `sense`: +1 with the crank, −1 against it."""

    @property
    def row(self) -> BearingRow: ...

    def law(self, duty: OperatingPoint[Any], sense: int) -> AnyLaw:
        """With the oil as it is supplied."""

    def warm_law(self, duty: OperatingPoint[Any], supplied: AnyLaw, before: AnyLaw, sense: int) -> AnyLaw:
        """In the heat that it makes under the load of `duty`, from the law as `supplied`; that `before`, where it finds
        no balance.  Raises NoSolution where it would not even run without a load."""

    def told_law(self, law: AnyLaw, duty: OperatingPoint[Any]) -> AnyLaw:
        """The same with what its numbers were found from."""

    def centred_under(self, duty: OperatingPoint[Any]) -> bool:
        """Whether the load is so small that nothing says where the journal lies."""

    def as_centred(self) -> Self: ...

    def solved(self, load: Newton, slope: Radian | None, share: Array | None, task: Task) -> "Carrying":
        """What it does under the load that turns with the shaft."""


@record
class Shared:
    """The laws of the bearings that share the load of a shaft, front to rear, and how it lies in them.

    `moved`: by how much the loads moved in the last pass, over the largest."""

    laws: tuple[AnyLaw, ...]
    carried: Carried
    moved: Number


class Carrying(ABC):
    """One bearing under its load: what its results tell beside their values."""

    anew: ClassVar[bool] = False  # whether `under` solves all of it again, so that nothing of it is told twice
    load: Newton
    friction_power: Watt
    oil_flow: CubicMetrePerSecond = 0.0  # under pressure
    on_shaft: OnShaftResult | None
    slope: Radian | None  # of the journal; None: not known, and taken

    @property
    @abstractmethod
    def row(self) -> BearingRow: ...

    @property
    @abstractmethod
    def speed(self) -> RevPerSecond:
        """Of the shaft."""

    @property
    @abstractmethod
    def supply_temperature(self) -> Celsius:
        """Of the oil that is brought to it."""

    @property
    @abstractmethod
    def supplied(self) -> OilState:
        """That oil."""

    @property
    @abstractmethod
    def running_clearance(self) -> Metre:
        """Diametral, as it runs."""

    @property
    @abstractmethod
    def least_load(self) -> Newton:
        """Below which it can not be told where its journal lies; 0: always."""

    @abstractmethod
    def lying(self, lies: OnShaftResult) -> Self:
        """The same where its journal lies so."""

    @abstractmethod
    def checks(self) -> Iterator[Check]:
        """What is judged of it alone."""

    @abstractmethod
    def slope_effect(self, bent: Radian) -> Text:
        """What the slope that the shaft takes would do, where a smaller one is given."""

    @abstractmethod
    def way(self) -> tuple[Metre, Radian]:
        """How far from its middle its journal lies, and by what angle behind the load."""

    @abstractmethod
    def edge_tilted(self, theta: Radian) -> Metre | None:
        """Film at the edge where the journal is so much aslant; None of a bearing without a film."""

    @abstractmethod
    def out_of_line(self, R_c: Newton) -> Metre | None:
        """Film under the load with what bores out of line add; None where there is none."""

    def tilt_checks(self, place: str) -> Iterator[Check]:
        """What is judged of how its journal lies."""
        return iter(())

    def alignment_checks(self, place: str, missing: Missing | None = None) -> Iterator[Check]:
        """What is judged of bores out of line."""
        return iter(())

    def survival(self) -> tuple[Second, Number] | None:
        """Its life, and the exponent by which it adds to those of others; None of a kind that does not fatigue."""
        return None

    def seat_size(self) -> Metre:
        """Diameter of the housing's bore in which it sits."""
        return self.row.on_shaft[0] if self.row.on_shaft is not None else 0.0

    def pumped(self) -> Watt:
        """What its oil takes of a pump without losses: its flow from no pressure to that of its supply."""
        return 0.0

    def mass(self) -> Kilogram:
        """Of what is put between shaft and housing."""
        return 0.0

    @abstractmethod
    def spring(self) -> NewtonPerMetre | None:
        """Its stiffness at rated speed, for the critical speed; None where nobody knows it."""

    @abstractmethod
    def drained(self) -> OilState | None:
        """The oil that leaves it and has to run off; None where none is brought to it."""

    @abstractmethod
    def answer(self, *, turns: bool) -> Answer:
        """How its friction answers at the speed and load of the design; `turns`: a standing load passes under the one
        that turns."""

    @abstractmethod
    def answer_at(self, ratio: Any, T: Any, lubricant: Lubricant | None, factor: Any = 1.0) -> Answer:
        """The same at `ratio` times the speed and oil of temperature T, one or arrays; `lubricant`: another oil;
        `factor`: on the load that turns."""

    @abstractmethod
    def under(self, stands: StandingLoads, checks: list[Check], notes: list[Text]) -> tuple[Self, list[Check]]:
        """The same with what does not turn, and the checks of its shaft's bearings with its own as they are then."""

    @abstractmethod
    def beside_original(self) -> object | None:
        """Of a bearing of a twin what is published, since it is not its original's."""


@record
class Solids:
    """What one bearing is made of and runs in: the journal, the metal around it, and the backing of a bush in it."""

    lubricant: Lubricant
    journal: Material
    housing: Material
    backing: Material
    shaft_bore: Metre = 0.0


@record
class TurnedJournal:
    """How the place of a bearing on its shaft is turned: limits of its diameter, m, where these are given, else its
    field; its roughness Ra, m; how far it may be from a cylinder, m.  None: not said.  `assumed`: the field is the
    program's, which judges by it."""

    limits: tuple[Metre, Metre] | None = None
    field: ToleranceField | None = None
    texture: Metre | None = None
    assumed: bool = False
    form: Metre | None = None


R = TypeVar("R", bound=Carrying)


class Kind(ABC, Generic[R]):
    """A kind of bearing: how one is made from its row, and what is shown of all of a shaft together."""

    @abstractmethod
    def support(self, row: BearingRow, inputs: BearingsInputs, solids: Solids, load: Newton, task: Task) -> Support:
        """Of one row, `inputs` as they hold for it.  `load`: as given or of rigid supports; things are chosen by it."""

    def checks(self, results: Mapping[str, R], shaft: "ShaftInView") -> Iterator[Check]:
        """What is judged of all of one shaft together."""
        return iter(())

    def renewed(self, results: Mapping[str, R], system_life: Second | None) -> Iterator[Check]:
        """Of those checks, and of such on all lives together, what hangs on loads that stand."""
        return iter(())

    def shares(
        self, shaft: Condensed, shared: Shared, supports: Sequence[Support], duty: OperatingPoint[Any]
    ) -> dict[str, Array]:
        """By the bearing, its load at the corners of its own tolerances over its load in their middle, of more than two
        that share the load of a shaft; empty: it does not follow its tolerances."""
        return {}

    def curves(self, results: Mapping[str, R]) -> Iterator[Curve]:
        return iter(())

    def seat_curves(self, results: Mapping[str, R]) -> Iterator[Curve]:
        """Those that stand behind the line of the shaft in its bearings."""
        return iter(())

    def charts(self, results: Mapping[str, R]) -> Iterator[Curve]:
        """Further curves, for the report of an engineer."""
        return iter(())

    def tables(self, results: Mapping[str, R], shaft: "ShaftInView") -> Iterator[Table]:
        return iter(())

    def pictures(self, results: Mapping[str, R], checks: dict[str, Check]) -> dict[str, Sketch]:
        """Each bearing as it is drawn."""
        return {place: Sketch((), title=r.row.in_words) for place, r in results.items()}

    def sections(self, results: Mapping[str, R], checks: dict[str, Check]) -> list[list[Sketch]]:
        """Further pictures, those of one view together."""
        return []

    def turned(self, row: BearingRow, inputs: BearingsInputs) -> TurnedJournal:
        """The place of one on the drawing of its shaft."""
        return TurnedJournal()

    def on_drawing(self, results: Mapping[str, R], inputs: BearingsInputs, say: Say) -> Iterator[SheetTable]:
        """What stands beside the views there: of seats, and of bearings that are bought."""
        return iter(())

    def notes(
        self, inputs: BearingsInputs, solved: "CountershaftResult | None", results: Mapping[str, R]
    ) -> Iterable[Text]:
        return ()

    def errata(self, results: Mapping[str, R]) -> Iterable[Erratum]:
        return ()


@record
class ShaftInView:
    """What the bearings of a shaft are told of it: how it comes into its seats, its ratio to the crank, how many
    bearings it has; its outline, None where that is not known."""

    assembly: str | None
    ratio: Number | None
    speed: RevPerSecond
    bearings: int
    outline: Outline | None


@record
class Told:
    """What is shown of the bearings of a shaft is made of, beside themselves.  `spans`: by the bearing, which of the
    lines are its own."""

    inputs: BearingsInputs
    solved: "CountershaftResult | None"
    shaft: ShaftInView
    spans: dict[str, slice]


def on_bearing(
    rule: CheckRule, place: str, value: float | None, limit: float | tuple[float, float], **more: Any
) -> Check:
    """A check on one bearing, under the name of its rule."""
    return rule(value, limit, at=place, name=named_at(rule.name, place), **more)


def by_row(row: BearingRow, found: list[Check]) -> list[Check]:
    """The checks of one bearing; what its row says of supply and seat itself moves them in place of what all share."""
    own = {dotted("bearings", entry): row_key(row.name, entry) for entry in ruled_by(row)}
    return [check.in_place(lambda key: (own.get(key, key),)) for check in found] if own else found
