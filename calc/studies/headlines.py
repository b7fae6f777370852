# SPDX-License-Identifier: Apache-2.0
"""What stands for a step, and for a whole drive: the check that decides, in a word with its limit, or what it gives."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence

from ..bearings.plain.result import PlainResult
from ..countershaft.result import CountershaftResult
from ..countershaft.rows import called
from ..countershaft.shafts import ShaftsResult
from ..countershaft.sums import NOTHING, SystemResult
from ..design.model import STEPS, Design
from ..engine.result import EngineResult
from ..friction.result import FrictionResult
from ..gears.drive.checks import grade_letter, grade_limits
from ..gears.drive.curves import MM_S
from ..gears.drive.result import HARDEST, IDLE, DriveResult, MeshOverSpeed, WheelStruck
from ..gears.drive.tables import kilonewtons, point_words, sentence, worst
from ..gears.rating.result import MeshStrength
from ..gears.result import MeshResult
from ..imbalance.orders import Order
from ..imbalance.result import ImbalanceResult
from ..imbalance.webs import WebsResult
from ..mounting.inputs import MountingInputs
from ..mounting.result import Mode, PointLevel
from ..mounting.wrenches import running
from ..sheet.check import Check
from ..sheet.quantity import Published, declared, dotted
from ..sheet.record import record
from ..sheet.text import COMMA, SPACE, Amount, Name, Text
from ..sheet.verdict import closest
from ..solve import Results

# what the shaft leaves of an order's couple and force, and what there is before
LEFT = (
    (1, SystemResult.residual_order_1_couple, declared(Order).couple_peak),
    (1, SystemResult.residual_order_1_force, declared(Order).force_peak),
    (2, SystemResult.residual_order_2_couple, declared(Order).couple_peak),
    (2, SystemResult.residual_order_2_force, declared(Order).force_peak),
)
ROLLS = ((1, SystemResult.roll_left_order_1), (2, SystemResult.roll_left_order_2))


@record
class Headline:
    """`brief`: the same in fewer cells.  `share`: the value over the limit, 1 at it; None where there is none to hold
    it against."""

    text: Text
    brief: Text
    share: float | None = None
    check: Check | None = None


def headline(results: Results, key: str) -> Headline | None:
    """What stands for a step: of the limits that are open the worst, else what the step gives, else the nearest of its
    limits."""
    outcome = results.outcomes[key]
    if outcome.state != "solved":
        return None
    first = next((group[0] for group in outcome.causes), None)
    if first is not None and first.kind == "limit" and first.verdict in ("fail", "not_verified"):
        return of_check(first, results.design)
    if key in GIVES and (text := GIVES[key](results)) is not None:
        return Headline(text, text)
    deciding = [check for check in outcome.checks if check.rule.decides]
    return of_check(min(deciding, key=lambda c: c.margin), results.design) if deciding else None


def heads(results: Results, key: str) -> list[Published]:
    """The values that stand for a step, those that say most first: of several shafts the force, the roll and the couple
    that all leave, and the thinnest films."""
    if len(results.design.shafts) > 1 and key == "countershaft":
        left = [results.value(field) for _, field, _ in LEFT]
        rolls = [results.value(field) for _, field in ROLLS]
        forces, couples = ([v for v in left if v is not None and v.unit == unit] for unit in ("N", "N·m"))
        return [v for v in (*forces, *rolls, *couples) if v is not None and v.inside > NOTHING]
    if len(results.design.shafts) > 1 and key == "bearings":
        return sorted(results.values_of(PlainResult.film_edge), key=lambda v: v.shown)
    own = {value.id: value for value in results.outcomes[key].values()}
    return next(step for step in STEPS if step.key == key).heads(own)


def of_check(check: Check, design: Design | None = None) -> Headline:
    """`film 7.41 of 9 µm`, of one of several shafts `left front film 7.41 of 9 µm`; `fatigue not verified` of a check
    that has no value."""
    word, limit = check.rule.short or check.name, check.nearest[1]
    if design is not None and (name := design.shaft_of(check.id)) and len(design.shafts) > 1 and check.rule.short:
        where = check.id.removeprefix(f"{check.id.partition('.')[0]}.{name}.").split(".")[:-1]
        word = SPACE.join([Name(name), *map(called, where), word])
    if math.isnan(check.value):
        words = Text("{word} not verified", word=word)
        return Headline(words, words, None, check)
    if not limit:
        long, brief = (
            Text("{word} {value}", word=word, value=Amount(check.value, check.unit, digits=n)) for n in (3, 2)
        )
        return Headline(long, brief, None, check)
    three, two = (
        dict(word=word, value=Amount(check.value, digits=n), limit=Amount(limit, check.unit, digits=n)) for n in (3, 2)
    )
    return Headline(
        Text("{word} {value} of {limit}", **three), Text("{word} {value}/{limit}", **two), check.share, check
    )


# --- what a step gives


def _engine(results: Results) -> Text | None:
    engine, volume = results.design.engine, results.value(declared(EngineResult).displacement)
    if engine is None or volume is None:
        return None
    return Text("{n} cyl, {volume}", n=engine.cylinders, volume=Amount(volume.inside * 1e3, "L", digits=3))


def _imbalance(results: Results) -> Text | None:
    balance = _balance(results)
    if balance is None or len(results.design.shafts) > 1:  # which say it themselves
        return None
    return Text("shaft {size}", size=balance[1])


def _countershaft(results: Results) -> Text | None:
    """Of several shafts what they leave: `force 10618 → 2081 N`."""
    balance = _balance(results)
    if balance is None or len(results.design.shafts) < 2:
        return None
    return Text("{word} {size}", word=balance[0], size=balance[1])


def _balance(results: Results) -> tuple[Text, Text] | None:
    """What the crank asks for, a couple or a force, and what the shaft leaves of it; of several shafts what most is
    taken of."""
    if len(results.design.shafts) > 1:
        return _balance_of_shafts(results)
    couple = declared(ImbalanceResult).required_couple, SystemResult.residual_order_1_couple
    force = declared(ImbalanceResult).required_force, SystemResult.residual_order_1_force
    for kind, word in ((couple, Text("couple for the shaft")), (force, Text("force for the shaft"))):
        before, after = (results.value(field) for field in kind)
        if before is not None and before.shown:
            if after is None:
                return word, Text("{value}", value=Amount(before.shown, before.unit, digits=3))
            left = Amount(after.shown, before.unit, form=".0f" if before.shown >= 10 * after.shown else ".3g")
            return word, Text("{before} → {after}", before=Amount(before.shown, digits=3), after=left)
    return None


def _balance_of_shafts(results: Results) -> tuple[Text, Text] | None:
    taken = []
    for n, field, peak in LEFT:
        before, after = results.values().get(dotted(Design.imbalance, f"order_{n}", peak)), results.value(field)
        if before is not None and after is not None and before.shown:
            size = Text(
                "{before} → {after}",
                before=Amount(before.shown, form=".0f"),
                after=Amount(after.shown, after.unit, form=".0f"),
            )
            word = Text("force") if after.unit == "N" else Text("couple")
            taken.append((after.unit != "N", after.shown - before.shown, word, size))
    return min(taken, key=lambda way: way[:2])[2:] if taken else None


def _backlash(results: Results) -> Text | None:
    """From the tightest mesh to the widest."""
    least, most = results.values_of(MeshResult.backlash_min), results.values_of(MeshResult.backlash_max)
    if not least or not most:
        return None
    low = Amount(min(v.shown for v in least), form=".0f")
    high = Amount(max(v.shown for v in most), least[0].unit, form=".0f")
    return Text("{low} … {high}", low=low, high=high)


def _rattle(results: Results) -> Text | None:
    """Its grade at idle, and how hard the flanks strike."""
    u = results.value(DriveResult.impact_speed)
    drive = results.train.drive if results.train is not None else None
    if drive is None or drive.grade is None or u is None:
        return None
    return Text("{grade} {u}", grade=grade_letter(drive.grade), u=Amount(u.shown, u.unit, form=".0f"))


def _graded(results: Results) -> Text | None:
    """The same beside what the grades are: `B 58 mm/s (A ≤ 35, B ≤ 70)`."""
    strikes, (A, B) = _rattle(results), (Amount(u * MM_S, form=".0f") for u in grade_limits())
    return Text("{strikes} (A ≤ {A}, B ≤ {B})", strikes=strikes, A=A, B=B) if strikes is not None else None


def _gears(results: Results) -> Text | None:
    """`rattle B 58 mm/s` where the motion of the crank is known, else the backlash."""
    drive, strikes = results.train.drive if results.train is not None else None, _rattle(results)
    if drive is not None and not drive.assumed and strikes is not None:
        return Text("rattle {strikes}", strikes=strikes)
    backlash = _backlash(results)
    return Text("backlash {range}", range=backlash) if backlash is not None else None


def _friction(results: Results) -> Text | None:
    loss = results.value(FrictionResult.total_loss)
    return Text("{loss}", loss=Amount(loss.shown, loss.unit, digits=3)) if loss is not None else None


def _mounting(results: Results) -> Text | None:
    """What the foremost seat has at the first operation, half on the crank and with the shaft; where nobody sits, from
    the slowest mode to the fastest."""
    mounting, modes = results.design.mounting, results.values_of(Mode.frequency)
    if mounting is not None and (felt := _felt(mounting, results)) is not None:
        return felt
    if not modes:
        return None
    low, high = (which(v.shown for v in modes) for which in (min, max))
    return Text("modes {low} … {high}", low=Amount(low, digits=2), high=Amount(high, modes[0].unit, digits=2))


def _felt(mounting: MountingInputs, results: Results) -> Text | None:
    if mounting.seat is None:
        return None
    rows = running(mounting, results.design.engine) if results.design.engine is not None else ()
    first = rows[0].name if rows else "idle"
    half, shaft = (
        results.values().get(dotted(Design.mounting, first, variant, mounting.seat.name, PointLevel.weighted))
        for variant in ("half", "shaft")
    )
    if half is None:
        return None
    if shaft is None:
        return Text("seat {half}", half=Amount(half.shown, half.unit, digits=2))
    return Text(
        "seat {half} → {shaft}", half=Amount(half.shown, digits=2), shaft=Amount(shaft.shown, shaft.unit, digits=2)
    )


GIVES: Mapping[str, Callable[[Results], Text | None]] = {
    "engine": _engine,
    "imbalance": _imbalance,
    "countershaft": _countershaft,
    "gears": _gears,
    "friction": _friction,
    "mounting": _mounting,
}


LEADS: Mapping[str, Callable[[Results, bool], Text | None]] = {
    "gears": lambda results, brief: sentence(results.train, brief=brief) if results.train is not None else None,
}


def lead(results: Results, key: str, *, brief: bool = False) -> Text | None:
    """The sentence with which a step begins; None: it has none.  `brief`: without what it rests on."""
    return LEADS[key](results, brief) if key in LEADS else None


# --- the teeth under their strikes


@record
class StruckSafety:
    """The least safety of the teeth under their strikes, by the high and by the low estimate of the force."""

    high: Published
    low: Published

    @property
    def label(self) -> Text:
        if self.high.symbol.startswith("S_H"):
            return Text("Safety against pitting under strikes, high to low force")
        return Text("Safety against tooth breakage under strikes, high to low force")

    @property
    def words(self) -> Text:
        """`0.94 to 1.08`."""
        return Text("{high} to {low}", high=Amount(self.high.shown, form=".2f"), low=Amount(self.low.shown, form=".2f"))


UNDER_STRIKES = (
    (MeshOverSpeed.strike_safety_contact, MeshOverSpeed.strike_safety_contact_low),
    (WheelStruck.strike_safety_bending, WheelStruck.strike_safety_bending_low),
)


def struck_safeties(results: Results) -> dict[str, StruckSafety]:
    """Under their symbols S_H and S_F."""
    found = {}
    for high_field, low_field in UNDER_STRIKES:
        high, low = (min(results.values_of(f), key=lambda v: v.shown, default=None) for f in (high_field, low_field))
        if high is not None and low is not None:
            found[high.symbol.removesuffix(",u")] = StruckSafety(high, low)
    return found


def governing_safeties(results: Results) -> dict[str, StruckSafety]:
    """Those that are less than what the torque leaves.  A motion of the crank that is assumed governs nothing: what
    does not hold with it is not verified."""
    train = results.train
    if train is None or train.drive is None or train.drive.assumed:
        return {}
    rated = {"S_H": results.values_of(MeshStrength.safety_contact), "S_F": _roots(results)}
    return {
        symbol: struck
        for symbol, struck in struck_safeties(results).items()
        if struck.high.shown < min((v.shown for v in rated[symbol]), default=math.inf)
    }


def _roots(results: Results) -> list[Published]:
    """The safeties of all wheels against breakage, under the torque."""
    gears = results.design.gears
    names = {f"safety_bending_{wheel.name}" for wheel in gears.wheels} if gears is not None else ()
    return [v for id, v in results.values().items() if id.rpartition(".")[2] in names]


def drive_row(results: Results) -> tuple[Text, Text] | None:
    """The drive at idle and where it strikes hardest, for the first page; None where it is not known."""
    drive = results.train.drive if results.train is not None else None
    if drive is None or not drive.meshes:
        return None
    title, ops = Text("Drive at idle / largest force"), [op for op in (IDLE, HARDEST) if op in drive.at]
    at = [worst(drive, op) for op in ops]
    if not any(of.u for of in at):
        return title, Text("The flanks stay closed at every speed and load.")
    words = Text(
        "grade {grade}; strikes of {u} mm/s at {points}; force some {force}; power about {power} W at most",
        grade=grade_letter(drive.grade) if drive.grade is not None else "–",
        u=_both([Text("{u}", u=Amount(of.u * 1e3, form=".0f")) for of in at]),
        points=_both([point_words(drive, op) for op in ops]),
        force=_both([kilonewtons(of.low, of.high) if of.high else Text("0") for of in at]),
        power=_both([Text("{W}", W=Amount(of.power, digits=2)) for of in at]),
    )
    struck = [
        Text("{symbol} {range}", symbol=Name(symbol), range=s.words) for symbol, s in struck_safeties(results).items()
    ]
    if struck:
        words = Text("{words}; under strikes {safeties}", words=words, safeties=COMMA.join(struck))
    if drive.assumed:
        words = Text(
            "{words}; with {taken}, a default that knows no load: give the gas and the flywheel",
            words=words,
            taken=drive.drive.taken,
        )
    return title, words


def _both(texts: Sequence[Text]) -> Text:
    return Text("{idle} / {hardest}", idle=texts[0], hardest=texts[1]) if len(texts) > 1 else texts[0]


# --- the whole drive


def main_numbers(results: Results) -> tuple[tuple[Text, Text], ...]:
    """What is said of a drive in ten numbers, each with its word; those that this design has."""
    design = results.design

    def shown(field: object) -> Amount | None:
        return extreme(max, results.values_of(field)[:1])

    def extreme(which: Callable[[list[float]], float], matching: list[Published]) -> Amount | None:
        return Amount(which([value.shown for value in matching]), matching[0].unit, digits=3) if matching else None

    numbers: list[tuple[Text, Text | Amount | None]] = []
    if (balance := _balance(results)) is not None:
        numbers.append(balance)
    alone = design.countershaft if len(design.shafts) == 1 else None
    if alone is not None and (mass := shown(CountershaftResult.mass)) is not None:
        outer = alone.outer_radius
        size = Text("{mass}, Ø{diameter}", mass=mass, diameter=Amount(outer * 2e3, "mm", digits=3)) if outer else mass
        numbers.append((Text("shaft"), size))
    elif (mass := shown(ShaftsResult.shaft_mass)) is not None:
        numbers.append((Text("all shafts"), mass))
    slopes = results.values_of(CountershaftResult.slopes)
    numbers += [
        (Text("slope"), extreme(max, slopes)),
        (Text("first critical speed"), shown(CountershaftResult.first_critical_speed)),
    ]
    edges = results.values_of(PlainResult.film_edge)
    if len(edges) == 2:
        front, rear = Amount(edges[0].shown, digits=3), Amount(edges[1].shown, edges[1].unit, digits=3)
        numbers.append((Text("films at the edge"), Text("{front} / {rear}", front=front, rear=rear)))
    elif edges:
        numbers.append((Text("least film at the edge"), extreme(min, edges)))
    governing = governing_safeties(results)
    rated = {"S_H": results.values_of(MeshStrength.safety_contact), "S_F": _roots(results)}
    numbers += [
        (Text("oil leaves with"), extreme(max, results.values_of(PlainResult.outlet_temperature))),
        (Text("backlash"), _backlash(results)),
        (Text("rattle at idle"), _graded(results)),
    ]
    for symbol, values in rated.items():
        under = governing.get(symbol)
        strikes = Text("{range} under strikes", range=under.words) if under is not None else None
        numbers.append((Text(symbol), strikes or extreme(min, values)))
    if (loss := shown(FrictionResult.total_loss)) is not None:
        rpm = Amount(design.engine.rated_speed * 60, "rpm", form=".0f") if design.engine is not None else None
        numbers.append((Text("loss"), Text("{loss} at {speed}", loss=loss, speed=rpm) if rpm is not None else loss))
    return tuple(
        (word, value if isinstance(value, Text) else Text("{value}", value=value))
        for word, value in numbers
        if value is not None
    )


def closest_limit(results: Results) -> Text:
    """The limit of physics that is nearest, by name and margin; a dash where none was judged."""
    check = closest([check for check in results.checks() if check.role == "physics"])
    return Text("{name}, {margin}", name=check.name, margin=check.margin_text()) if check is not None else Name("–")


def felt(results: Results) -> Iterator[tuple[str, Text]]:
    """What of all this reaches the driver, each with the step that has it."""
    mounting = results.outcomes["mounting"]
    if mounting.state == "solved":
        yield mounting.key, mounting.reason
    elif mounting.state == "not_asked":
        yield mounting.key, Text("not known without step 7, mounting")


_SUPPLIED_ELSEWHERE = (
    (WebsResult.missing_forward_couple, WebsResult.unbalances_couple_left),
    (WebsResult.missing_forward_force, None),
)


def remaining(results: Results) -> Iterator[tuple[str, Text]]:
    """What the design leaves to shake, in numbers, each with the step that has it: of order 1 and 2, and what pulley
    and flywheel must supply."""
    values = results.values()
    for n, field, peak in LEFT:
        before, left = values.get(dotted(Design.imbalance, f"order_{n}", peak)), results.value(field)
        if left is not None and left.shown:
            alone = len(results.design.shafts) == 1
            of_shaft = Text("of order {n} the shaft leaves {value}", n=n, value=_three(left))
            of_shafts = Text("of order {n} the shafts leave {value}", n=n, value=_three(left))
            yield "countershaft", of_shaft if alone else of_shafts
        elif left is None and before is not None and before.shown:
            yield dotted(Design.imbalance), Text("of order {n} stay {value}", n=n, value=_three(before))
    for n, field in ROLLS:
        if (roll := results.value(field)) is not None and roll.inside > NOTHING:
            yield "countershaft", Text("of the roll of order {n} stay {value}", n=n, value=_three(roll))
    for field, left_field in _SUPPLIED_ELSEWHERE:
        wanted, left = results.value(field), results.value(left_field) if left_field is not None else None
        if wanted is None or not wanted.shown:
            continue
        words = Text("{what}: {value}", what=wanted.label, value=_three(wanted))
        if left is not None:
            words = Text("{words}; what is given leaves {left}", words=words, left=_three(left))
        yield dotted(Design.imbalance), words


def _three(value: Published) -> Amount:
    return Amount(value.shown, value.unit, digits=3)
