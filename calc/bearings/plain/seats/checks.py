# SPDX-License-Identifier: Apache-2.0
"""What a seat is judged by: does the bush hold, what it does to its housing and itself, do the classes fit."""

from collections.abc import Iterator
from math import pi

from ....countershaft.rows import ROW, BearingRow, called, row_key
from ....library.catalogue import Material, materials, proof_of
from ....library.journal_rules import named_at
from ....sheet.check import Check, CheckRule, Missing
from ....sheet.quantity import dotted
from ....sheet.remedy import Remedy, by_key, up_um
from ....sheet.text import Amount, Text
from ....sheet.units import Celsius, Metre, Pascal
from ....sheet.value import based_on, untraced
from ...inputs import BearingsInputs
from . import formulas as f
from .classes import Select
from .result import SeatResult, SelectResult
from .rings import Fit, Rings
from .seat import HOLDING_FRICTION

LAME = Text("elasticity: thick rings in plane stress (Lamé)")
CAUSE = "bearings.B.seat"
INTERFERENCE, WALL = dotted(ROW, BearingRow.interference), dotted(ROW, BearingRow.wall)
OUTER, RETAINED = dotted(ROW, BearingRow.housing_outer), dotted(ROW, BearingRow.retained)
OF_SEAT = dotted("bearings", "B", "seat")
T_HOUSING = dotted("bearings", BearingsInputs.housing_temperature)

SEAT_PRESS = CheckRule(
    "bearings.B.seat_press",
    "caution",
    "The bush creeps under a load that turns once its fit opens; how much pressure that takes is an estimate.",
    Text("Pressure of the fit where the film is hottest"),
    unit="MPa",
    source=Text("statics, an estimate: pressure q·cos θ around the seat; {lame}", lame=LAME),
    advice=Text("More interference, a thicker wall, or a pin that holds the bush."),
    zero="1 MPa",
    cause=CAUSE,
    value_id=dotted(OF_SEAT, SeatResult.press_hot),
    limit_id=dotted(OF_SEAT, SeatResult.press_needed),
    moved_by=(INTERFERENCE, WALL, RETAINED, OUTER),
    short=Text("press"),
)
SEAT_FRETTING = CheckRule(
    "bearings.B.seat_fretting",
    "caution",
    "A pin holds the bush; where its fit opens under the turning load it frets.",
    Text("Pressure of the fit where the film is hottest"),
    unit="MPa",
    source=SEAT_PRESS.source,
    advice=Text("More interference, or a thicker wall."),
    zero="1 MPa",
    cause=CAUSE,
    value_id=dotted(OF_SEAT, SeatResult.press_hot),
    limit_id=dotted(OF_SEAT, SeatResult.press_needed),
    moved_by=(INTERFERENCE, WALL, OUTER),
    short=Text("press"),
)
SEAT_TURN = CheckRule(
    "bearings.B.seat_turn",
    "limit",
    "The bush turns with the film and shuts its oil hole.",
    Text("Torque that holds the bush, against twice that of the film"),
    unit="N·m",
    source=Text("statics: friction of the press with μ_s 0.10, from memory, against the film's own drag"),
    advice=Text("More interference, or a pin that holds the bush."),
    role="physics",
    zero="1 N·m",
    cause=CAUSE,
    value_id=dotted(OF_SEAT, SeatResult.holding_torque),
    moved_by=(INTERFERENCE, WALL, RETAINED, OUTER),
    short=Text("hold"),
)
SEAT_STRESS = CheckRule(
    "bearings.B.seat_stress",
    "limit",
    "The housing yields or cracks around the bush.",
    Text("Stress of the housing around the bush"),
    "<=",
    "MPa",
    LAME,
    Text("More metal around the bore, or less interference."),
    role="physics",
    zero="1 MPa",
    cause=CAUSE,
    value_id=dotted(OF_SEAT, SeatResult.housing_stress),
    moved_by=(OUTER, INTERFERENCE, WALL, dotted("bearings", BearingsInputs.housing_material)),
    short=Text("housing"),
)
BUSH_STRESS = CheckRule(
    "bearings.B.bush_stress",
    "caution",
    "The bush yields when pressed in; a shell that sets once keeps its press less the set.",
    Text("Hoop stress of the bush"),
    "<=",
    "MPa",
    LAME,
    Text("Less interference, a thicker wall or a stronger backing."),
    cause=CAUSE,
    moved_by=(INTERFERENCE, WALL, dotted(ROW, BearingRow.backing)),
    short=Text("bush"),
)
SELECT = CheckRule(
    "bearings.B.select",
    "caution",
    "A pair of classes has another clearance than was asked for.",
    unit="µm",
    source=Text("geometry: least and most clearance of every pair of classes"),
    advice=Text("Narrower classes, more of them, or a wider band."),
    sense="in",
    moved_by=(
        dotted("bearings", BearingsInputs.select, Select.bore_classes_mm),
        dotted("bearings", BearingsInputs.select, Select.journal_classes_mm),
    ),
)
SPREAD = CheckRule(
    "bearings.B.spread",
    "advice",
    "Shells without spread do not hold themselves in the housing while it is put together.",
    Text("Free spread of the shells"),
    sense=">",
    unit="µm",
    source=Text("rule of thumb: a shell is a little wider than its bore"),
    zero="100 µm",
    moved_by=(dotted(ROW, BearingRow.spread),),
)
BORE_CLEARANCE = CheckRule(
    "bearings.B.bore_clearance",
    "limit",
    "A carrier that is larger than its bore can not be put in.",
    Text("Least clearance of the carrier in its bore"),
    unit="µm",
    source=Text("geometry"),
    advice=Text("A larger bore, or a smaller carrier."),
    role="chosen",
    zero="10 µm",
    exact=True,
    moved_by=(dotted(ROW, BearingRow.carrier), dotted(ROW, BearingRow.carrier_bore)),
)
SEAT_UNKNOWN = CheckRule(
    "bearings.B.seat_unknown",
    "method",
    "A bush of unknown wall: its bore is taken to grow like the housing, which a pressed one does in part.",
    Text("Warm clearance that a steel bush of 2 mm would not have"),
    "<=",
    "µm",
    Text("{lame}; rule of this program: a twentieth of the clearance", lame=LAME),
    Text('Say how it sits: seat = "bush" or "shells", with its wall.'),
    moved_by=(dotted(ROW, BearingRow.seat),),
)
STEEL_BUSH: Metre = 2e-3  # wall of the bush that is held against one of unknown wall
UNKNOWN_SHARE = 0.05  # of the clearance, up to which its wall does not matter

MEGAPASCAL, NEWTON_METRE, HUNDRED_MICRONS, TEN_MICRONS = 1e6, 1.0, 100e-6, 10e-6  # what margins from nought are of


WHEN_COLD = Text("Pressure of the fit at the lowest temperature")
OF_SHELLS = {  # what they are called of shells, which are no bush
    SEAT_TURN: Text("Torque that holds the shells, against twice that of the film"),
    SEAT_STRESS: Text("Stress of the housing around the shells"),
    BUSH_STRESS: Text("Hoop stress of the shells"),
}


def seat_checks(
    place: str,
    row: BearingRow,
    seat: SeatResult | None,
    select: SelectResult | None,
    band: tuple[Metre, ...] | None,
) -> Iterator[Check]:
    """`band`: of the clearance that classes shall make; None: there are none."""
    if seat is not None:
        yield from pressed_checks(place, row, seat)
    if select is not None and band is not None:
        yield _worst_pair(place, select, (band[0], band[-1]))
    if row.spread is not None:
        yield SPREAD(row.spread, 0.0, at=place, name=named_at(SPREAD.name, place), scale=HUNDRED_MICRONS)
    if row.carrier is not None and row.carrier_bore is not None:
        room = row.carrier_bore[0] - row.carrier[-1]
        yield BORE_CLEARANCE(room, 0.0, at=place, name=named_at(BORE_CLEARANCE.name, place), scale=TEN_MICRONS)


def pressed_checks(place: str, row: BearingRow, seat: SeatResult) -> Iterator[Check]:
    """Of what is pressed in."""
    if not seat.rings.chosen:  # so that it holds
        yield from _press_checks(place, row, seat)
    yield from _stress_checks(place, row, seat)


def _press_checks(place: str, row: BearingRow, seat: SeatResult) -> Iterator[Check]:
    """Whether the bush stays where it is."""
    rule = SEAT_FRETTING if row.retained == "pin" else SEAT_PRESS
    hot, best, need = seat.press_hot, seat.press_hot_cool, seat.press_needed
    if seat.press_cold < hot:  # the housing grows less than the bush
        yield rule(
            seat.press_cold,
            need,
            at=place,
            name=named_at(WHEN_COLD, place),
            value_id=dotted("bearings", place, "seat", SeatResult.press_cold),
            scale=MEGAPASCAL,
        )
    else:
        yield rule(
            hot,
            need,
            at=place,
            name=named_at(rule.name, place),
            missing=_housing(seat, hot, best),
            scale=MEGAPASCAL,
            remedies=lambda: _tighter(place, row, seat, need),
        )
    if row.retained == "pin":
        return
    held, drag = seat.holding_torque, 2 * seat.drag_torque
    with untraced():
        fit = _fit(seat)
        each = f.holding_torque(mu_s=HOLDING_FRICTION, p=1.0, d_o=fit.d_o, l=row.length)  # of each Pa
    yield SEAT_TURN(
        held,
        drag,
        at=place,
        name=named_at(_named(SEAT_TURN, row), place),
        missing=_housing(seat, held, None if best is None else each * best),
        scale=NEWTON_METRE,
        remedies=lambda: _tighter(place, row, seat, drag / each),
    )


def _fit(seat: SeatResult) -> Fit:
    rings = seat.rings
    return rings.fit_of(seat.bore + 2 * rings.wall if rings.bore is None else rings.bore, seat.bore)


def _housing(seat: SeatResult, value: float, best: float | None) -> Missing | None:
    if best is None:
        return None
    taken = Text("the housing as warm as the film, {T}", T=Amount(seat.temperatures.hot, "°C", form=".0f"))
    return Missing((T_HOUSING,), (taken,), best, value)


def _tighter(place: str, row: BearingRow, seat: SeatResult, p: Pascal) -> tuple[Remedy, ...]:
    """The interference, as wide as it is, that leaves this pressure where the film is hottest; of shells by their
    crush, where that is given."""
    rings = seat.rings
    with untraced():
        needed = rings.needed(_fit(seat), p, seat.temperatures.hot, seat.temperatures.housing)
    more = needed - rings.interference[0]
    field, given = BearingRow.interference, rings.interference
    if row.crush is not None:
        field, given, more = BearingRow.crush, (row.crush[0], row.crush[-1]), more * pi / 2
    ends = [up_um(end + more) for end in given]
    return by_key(BearingRow, row_key(place, field), ends, place=called(place), bound=">=")()


def _stress_checks(place: str, row: BearingRow, seat: SeatResult) -> Iterator[Check]:
    housing, backing = seat.rings.housing, seat.rings.backing
    stress, value_id, missing = seat.housing_stress, None, None
    source = Text("{lame}; proof stress of {name}", lame=LAME, name=housing.name)
    if housing.proof_stress is None and housing.tensile_strength is not None:
        stress, limit = seat.tension, housing.tensile_strength
        value_id = dotted("bearings", place, "seat", SeatResult.tension)
        source = Text("{lame}; hoop tension, tensile strength of {name}", lame=LAME, name=housing.name)
    else:
        limit, missing = proof_of(housing.proof_stress, stress)
    yield SEAT_STRESS(
        stress,
        limit,
        at=place,
        name=named_at(_named(SEAT_STRESS, row), place),
        source=source,
        value_id=value_id,
        missing=missing,
        advice=_as_chosen(seat, SEAT_STRESS),
    )
    limit, missing = proof_of(backing.proof_stress, abs(seat.bush_stress))
    yield BUSH_STRESS(
        based_on(abs(seat.bush_stress), seat.bush_stress),
        limit,
        at=place,
        name=named_at(_named(BUSH_STRESS, row), place),
        source=Text("{lame}; proof stress of {name}", lame=LAME, name=backing.name),
        missing=missing,
        advice=_as_chosen(seat, BUSH_STRESS),
    )


def _as_chosen(seat: SeatResult, rule: CheckRule) -> Text:
    """What to do; of an interference that is not given, which one it stands on."""
    if not seat.rings.chosen:
        return rule.advice
    return Text(
        "No interference is given: this is of {least} to {most}, the least that holds and its field; give a closer "
        "one. {advice}",
        least=Amount(seat.interference_min * 1e6, form=".0f"),
        most=Amount(seat.interference_max * 1e6, "µm", form=".0f"),
        advice=rule.advice,
    )


def _worst_pair(place: str, select: SelectResult, band: tuple[Metre, Metre]) -> Check:
    """The pair of classes that stands furthest outside the band, else nearest to its ends."""
    ends = [(pair, g) for pair, of_pair in select.pair.items() for g in (of_pair.min, of_pair.max)]
    pair, g = min(ends, key=lambda end: min(end[1] - band[0], band[1] - end[1]))
    bore, _, journal = pair.partition("_")
    name = Text(
        "Clearance of bore class {bore} with journal class {journal}, {place}",
        bore=bore,
        journal=journal,
        place=called(place),
    )
    return SELECT(g, band, at=place, name=name)


def unknown_check(
    place: str, row: BearingRow, housing: Material, inputs: BearingsInputs, clearance: Metre, T: Celsius
) -> Check | None:
    """Of a lining whose bush is not known: by how much a steel bush of 2 mm would be narrower when warm."""
    if row.ringed or inputs.bush_material is None:
        return None
    steel = materials()["strip"]
    rings = Rings(
        backing=steel,
        housing=housing,
        wall=STEEL_BUSH,
        restraint=inputs.expansion_restraint,
        reference=inputs.clearance_reference_temperature,
        interference=(0.0, 0.0),
    )
    fit = rings.fit(row.diameter, clearance)
    alpha_H = housing.expansion * (1 - rings.restraint)
    s = rings.pressed(fit, 1e-6).c / 1e-6
    eff = f.bore_expansion(
        alpha_B=steel.expansion, s=s, d_o=fit.d_o, d_i=fit.d_i, alpha_H=housing.expansion, chi=rings.restraint
    )
    less = abs(fit.d_i * (alpha_H - eff) * (T - rings.reference))
    return SEAT_UNKNOWN(less, UNKNOWN_SHARE * clearance, at=place, name=named_at(SEAT_UNKNOWN.name, place))


def _named(rule: CheckRule, row: BearingRow) -> Text:
    return OF_SHELLS.get(rule, rule.name) if row.seat == "shells" else rule.name
