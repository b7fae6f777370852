# SPDX-License-Identifier: Apache-2.0
"""What is left, judged against one cylinder's force, and the remedies that it calls for."""

import math
from collections.abc import Iterator

from ..engine.inputs import EngineInputs
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.functions import argument, degrees
from ..sheet.quantity import declared, dotted
from ..sheet.text import EMPTY, Amount, Text, listed, plural
from ..sheet.units import Newton, NewtonMetre, Number
from .inputs import ImbalanceInputs
from .orders import Order
from .remedies import BalanceShaft
from .result import ImbalanceResult
from .shaft_pair import roll_check
from .webs import WebsResult

FIRST, SECOND = 0.05, 0.5  # shares of one cylinder's first- and second-order force that a good balance may leave
TURNED = math.radians(0.01)
OWN = Text(
    "rule of this program: 5 % (order 1) or 50 % of λ (order 2) of m·r·ω² of one cylinder, couples over one pitch"
)

PINS = math.radians(2)  # a pin of the crank's bodies may stand so far from its throw

FRACTION = dotted("imbalance", ImbalanceInputs.crank_balance_fraction)
AS_DESIGNED = Text(" (as designed)")
TAKEN_BY_A_SHAFT = "What a shaft could take is a possible improvement as long as no shaft is asked for."
TAKEN_BY_THE_CRANK = "The crank's own counterweights could take it and do not; a backward shaft can not."
COMFORT = "Second order is a matter of comfort and takes other shafts than this one."
BACKWARD_COUPLE = CheckRule(
    "imbalance.order_1.backward",
    "advice",
    TAKEN_BY_A_SHAFT,
    Text("First-order couple turning backward"),
    "<=",
    "N·m",
    OWN,
    value_id=dotted("imbalance", "order_1", declared(Order).couple_backward),
    moved_by=(FRACTION,),
)
BACKWARD_FORCE = CheckRule(
    "imbalance.order_1.backward_force",
    "advice",
    TAKEN_BY_A_SHAFT,
    Text("First-order force turning backward"),
    "<=",
    "N",
    OWN,
    Text(
        "A shaft at −ω with this force, in the plane of the engine's middle, takes it; it may carry the couple as well."
    ),
    cause=BACKWARD_COUPLE.id,
    value_id=dotted("imbalance", "order_1", declared(Order).force_backward),
    moved_by=(FRACTION,),
)
FORWARD_COUPLE = CheckRule(
    "imbalance.order_1.forward",
    "caution",
    TAKEN_BY_THE_CRANK,
    Text("First-order couple turning forward"),
    "<=",
    "N·m",
    OWN,
    value_id=dotted("imbalance", "order_1", declared(Order).couple_forward),
    moved_by=(FRACTION,),
)
FORWARD_FORCE = CheckRule(
    "imbalance.order_1.forward_force",
    "caution",
    TAKEN_BY_THE_CRANK,
    Text("First-order force turning forward"),
    "<=",
    "N",
    OWN,
    cause=FORWARD_COUPLE.id,
    value_id=dotted("imbalance", "order_1", declared(Order).force_forward),
    moved_by=(FRACTION,),
)
SECOND_COUPLE = CheckRule(
    "imbalance.order_2.couple",
    "advice",
    COMFORT,
    Text("Second-order couple left"),
    "<=",
    "N·m",
    OWN,
    value_id=dotted("imbalance", "order_2", declared(Order).couple_peak),
    moved_by=(dotted("engine", EngineInputs.rod_length),),
)
SECOND_FORCE = CheckRule(
    "imbalance.order_2.force",
    "advice",
    COMFORT,
    Text("Second-order force left"),
    "<=",
    "N",
    OWN,
    cause=SECOND_COUPLE.id,
    value_id=dotted("imbalance", "order_2", declared(Order).force_peak),
    moved_by=(dotted("engine", EngineInputs.rod_length),),
)
CRANK_FORCE = CheckRule(
    "imbalance.crank.force",
    "caution",
    "The crank turns on its balancing machine, but leaves a force in the engine.",
    sense="<=",
    unit="N",
    source=OWN,
    advice=Text("Other bobs, or other webs: the list of bodies shows where mass is missing."),
    moved_by=(dotted("imbalance", ImbalanceInputs.bob_mass),),
)
CRANK_COUPLE = CheckRule(
    "imbalance.crank.couple",
    "caution",
    "The crank turns on its balancing machine, but leaves a couple in the engine.",
    sense="<=",
    unit="N·m",
    source=OWN,
    advice=Text("Other bobs, or other webs: the list of bodies shows where mass is missing."),
    cause=CRANK_FORCE.id,
    moved_by=(dotted("imbalance", ImbalanceInputs.bob_mass),),
)
CRANK_RESIDUAL = CheckRule(
    "imbalance.crank.residual",
    "advice",
    "A crank that is drilled on the balancing machine may come to it with more.",
    sense="<=",
    unit="kg·mm",
    source=Text("ISO 21940-11, permissible residual unbalance, of the mass that is listed"),
    advice=Text(
        "The balancing machine has it drilled out: give the radius of the balancing holes, and the webs to drill are "
        "found."
    ),
    cause=CRANK_FORCE.id,
    limit_id=dotted("imbalance", WebsResult.permitted_unbalance),
    moved_by=(
        dotted("imbalance", ImbalanceInputs.drill_radius),
        dotted("imbalance", ImbalanceInputs.crank_balance_grade),
    ),
)
COUPLE_LEFT = CheckRule(
    "imbalance.unbalances.couple_left",
    "caution",
    "Pulley and flywheel leave more of the couple that they are there for than a cylinder would.",
    Text("Wanted couple that pulley and flywheel leave"),
    "<=",
    "N·m",
    OWN,
    Text("Their unbalances together must supply the couple that is missing, in its direction."),
    value_id=dotted("imbalance", WebsResult.unbalances_couple_left),
    moved_by=(dotted("imbalance", ImbalanceInputs.unbalances),),
)
THROWS = CheckRule(
    "imbalance.crank.throws",
    "caution",
    "Bodies whose pins do not lie at the throws are those of another crank.",
    Text("Pins of the crank's bodies against the throws"),
    "<=",
    "°",
    Text("rule of this program: within 2°"),
    Text("Look at the throw that stands at TDC, and at x (up) and y (in the sense of rotation) of the pins."),
    value_id=dotted("imbalance", WebsResult.pin_deviation),
    moved_by=(dotted("imbalance", ImbalanceInputs.crank_bodies_throw_at_tdc),),
)


def checks(
    result: ImbalanceResult,
    lam: Number,
    kappa: Number,
    rho: Number,
    taken: frozenset[int],
    offsets_differ: bool = False,
) -> Iterator[Check]:
    """What is left, against the force of one cylinder's reciprocating mass and its couple over one pitch; but for what
    the shafts of the design take, at these times crank speed, of which their own step judges what is left.

    `kappa`, `rho`: shares of the reciprocating and of the rotating masses that the crank's counterweights carry.
    """
    first, second = result.orders["order_1"], result.orders["order_2"]
    forward = Text(
        "A backward shaft can not take it: balance half of the reciprocating mass on the crank (fraction 0.5)."
    )
    if rho != 1:
        forward = Text(
            "A backward shaft can not take it: balance the rotating masses whole and half of the reciprocating mass on "
            "the crank (rotating_balance_fraction 1, crank_balance_fraction 0.5)."
        )
    elif kappa == 0.5 and offsets_differ:
        forward = Text(
            "Half of the reciprocating mass is on the crank already. Offsets that differ turn each cylinder's force "
            "away from its pin by another angle, and counterweights opposite the pins leave that. It turns with the "
            "crank: further masses on it, opposite to the phase of what is left, take it."
        )
    elif (turned := _turned(result)) > TURNED and kappa == 0.5:
        forward = Text(
            "The offset turns it away from the pins: counterweights turned by {degrees}° from opposite them take it.",
            degrees=Amount(degrees(turned)),
        )
    shafts = result.remedy.get("second_order_shafts")
    two = (
        Text(
            "A shaft at crank speed leaves it whole; {shafts_words}ω would take it, a longer rod lowers it.",
            shafts_words=shafts_words(shafts.shafts),
        )
        if shafts
        else EMPTY
    )

    force, couple = FIRST * result.one_force, FIRST * result.one_couple
    if -1 not in taken:
        counter = Text(
            "One shaft at −ω takes it: {required_couple} N·m at {phase}",
            required_couple=Amount(result.required_couple),
            phase=Amount(round(degrees(result.required_couple_phase), 3), "°"),
        ) + Text("; add a shaft.")
        yield BACKWARD_COUPLE(first.couple_backward, couple, advice=counter)
        yield BACKWARD_FORCE(first.force_backward, force)
    if 1 not in taken:
        yield FORWARD_COUPLE(first.couple_forward, couple, advice=forward)
        yield FORWARD_FORCE(first.force_forward, force, advice=forward)
    if not {-2, 2} <= taken:
        yield SECOND_COUPLE(second.couple_peak, SECOND * lam * result.one_couple, advice=two)
        yield SECOND_FORCE(second.force_peak, SECOND * lam * result.one_force, advice=two)
    if result.shaft_pair is not None:
        yield roll_check(result.shaft_pair)
    if result.webs is not None:
        yield from _crank_checks(result.webs, force, couple)


def _crank_checks(webs: WebsResult, force: Newton, couple: NewtonMetre) -> Iterator[Check]:
    """The crank on the balancing machine, and what pulley and flywheel supply: no more than `force` and `couple` may be
    left."""
    if webs.crank is not None:
        name = "stated" if "stated" in webs.crank else "balanced"
        state = webs.crank[name]
        bobs = Text("with the bobs as stated") if name == "stated" else Text("with the bobs found")
        yield CRANK_FORCE(state.force, force, name=Text("Force of the crank {bobs}", bobs=bobs))
        yield CRANK_COUPLE(state.couple, couple, name=Text("Couple of the crank {bobs}", bobs=bobs))
        if webs.permitted_unbalance is not None and webs.drilled_mass is None:
            label = Text("Static unbalance of the crank {bobs}", bobs=bobs)
            yield CRANK_RESIDUAL(state.unbalance, webs.permitted_unbalance, name=label)
    if webs.unbalances_couple_left is not None:
        yield COUPLE_LEFT(webs.unbalances_couple_left, couple)
    elif (wanted := webs.missing_forward_couple) is not None:
        keys, taken = (dotted("imbalance", ImbalanceInputs.unbalances),), (Text("unbalances that leave nothing"),)
        lack = Missing(keys, taken, 0.0, wanted)
        yield COUPLE_LEFT(0.0, couple, value_id="", missing=lack)
    if webs.pin_deviation is not None:
        yield THROWS(webs.pin_deviation, PINS)


def proposals(
    result: ImbalanceResult,
    lam: Number,
    kappa: Number,
    rho: Number,
    taken: frozenset[int],
    offsets_differ: bool = False,
) -> tuple[Text, ...]:
    """The remedies that the residuals of this engine call for, and why: from the engine without any share on the
    crank."""
    F_f, F_b, C_f, C_b = (abs(v) for v in result.orders["order_1"].unbalanced)
    F_p, F_m, C_p, C_m = (abs(v) for v in result.orders["order_2"].vectors)
    first = FIRST * result.one_force, FIRST * result.one_couple
    second = SECOND * lam * result.one_force / 2, SECOND * lam * result.one_couple / 2  # of a pair: half of its peak
    proposed = []
    turns_forward, turns_backward = _what(F_f, C_f, *first), _what(F_b, C_b, *first)
    F_left, C_left = left_of_half(result)
    if turns_forward and 1 in taken:
        proposed.append(
            Text(
                "One shaft at +1 times crank speed{done}: it takes what of first order turns forward, {turns_forward}.",
                done=AS_DESIGNED,
                turns_forward=turns_forward,
            )
        )
    elif turns_forward and offsets_differ and (F_left > F_f + first[0] or C_left > C_f + first[1]):
        proposed.append(
            Text(
                "Counterweights on the crank that do not stand opposite the pins, because offsets that differ turn "
                "what of first order turns forward, {turns_forward}, away from them: opposite the pins, half of the "
                "reciprocating mass leaves {left}.",
                turns_forward=turns_forward,
                left=_what(F_left, C_left, *first),
            )
        )
    elif turns_forward:
        done = Text("as designed")
        if kappa != 0.5:
            done = Text("the design has {kappa}", kappa=Amount(kappa, form="g"))
        proposed.append(
            Text(
                "Counterweights on the crank for half of the reciprocating mass (crank_balance_fraction 0.5; {done}), "
                "because they {taken} of first order that turns forward: {turns_forward}.",
                done=done,
                taken=_taken(result, rho, first, offsets_differ),
                turns_forward=turns_forward,
            )
            + (EMPTY if turns_backward else Text(" Nothing of first order turns backward: no shaft is needed for it."))
        )
    if turns_backward:
        done = AS_DESIGNED if -1 in taken else EMPTY
        text = plural(
            "One shaft at −1 times crank speed{done}, because {turns_backward} of first order turns backward, and "
            "nothing on the crank can take it.",
            "One shaft at −1 times crank speed{done}, because {turns_backward} of first order turn backward, and "
            "nothing on the crank can take it.",
            n=_count(turns_backward),
            done=done,
            turns_backward=turns_backward,
        )
        if (roll := result.remedy["backward_shaft"].roll_torque_at_100_mm) is not None and F_b > first[0]:
            text += Text(
                " It carries a force: each 100 mm beside the crank's axis cost a roll torque of {roll} N·m; two "
                "shafts at ±1 cost none.",
                roll=Amount(roll),
            )
        proposed.append(text)
    plus, minus = _what(F_p, C_p, *second), _what(F_m, C_m, *second)
    shafts = result.remedy.get("second_order_shafts")
    # of a crank that is all but nought, little of λ counts, and no shaft is made for it
    if (plus or minus) and shafts is not None:
        both = _what(F_p + F_m, C_p + C_m, *second)
        left = plural(
            "{both} of second order is left at the peak; neither the crank nor a shaft at crank speed changes it.",
            "{both} of second order are left at the peak; neither the crank nor a shaft at crank speed changes it.",
            n=_count(both),
            both=both,
        )
        proposed.append(_of_second_order(shafts.shafts, taken, left))
    webs = result.webs
    if webs is not None and webs.missing_forward_couple is not None and webs.unbalances_couple is None:
        assert webs.missing_forward_force is not None
        assert webs.missing_forward_couple_phase is not None
        missing = _what(webs.missing_forward_force, webs.missing_forward_couple, *first)
        if missing:
            direction = Amount(round(degrees(webs.missing_forward_couple_phase), 3), "°")
            proposed.append(
                Text(
                    "Unbalances on pulley and flywheel that supply {missing} (the couple at {direction}), because the "
                    "crank's own webs lack it for the share {kappa}; give them as [[imbalance.unbalances]] to see what "
                    "is left.",
                    missing=missing,
                    direction=direction,
                    kappa=Amount(kappa, form="g"),
                )
            )
    return tuple(proposed) or (
        Text("No remedy is called for: neither order 1 nor order 2 leaves a force or couple that counts."),
    )


def _of_second_order(shafts: dict[str, BalanceShaft], taken: frozenset[int], left: Text) -> Text:
    """The shafts against it, and whether the design has them; `left`: what there is without."""
    speed = _one_speed(shafts)
    how = Text("Two shafts at ±2") if speed is None else Text("One shaft at {speed}", speed=speed)
    if {round(shaft.speed_ratio) for shaft in shafts.values()} <= taken:
        return Text("{how} times crank speed{done}: without, {left}", how=how, done=AS_DESIGNED, left=left)
    if speed is None:
        return Text("Two shafts at ±2 times crank speed, where the comfort is worth it, because {left}", left=left)
    return Text(
        "One shaft at {speed} times crank speed, where the comfort is worth it, because {left}", speed=speed, left=left
    )


def _taken(result: ImbalanceResult, rho: Number, least: tuple[float, float], offsets_differ: bool) -> Text:
    """What the half on the crank takes: all, or what an offset cylinder leaves, whose force does not stand opposite the
    pin."""
    rest = _what(*left_of_half(result), *(limit / 50 for limit in least))
    if not rest:
        return Text("take all")
    if rho != 1:
        share = Amount(rho, form="g")
        return Text(
            "take all but {rest} (the rotating masses are balanced to a share of {share} only)", rest=rest, share=share
        )
    if offsets_differ:
        return Text("take all but {rest} (offsets that differ turn it from the pins)", rest=rest)
    turned = Amount(degrees(_turned(result)), "°")
    return Text(
        "take all but {rest} (the offset turns it by {turned} from the pins; counterweights turned as far take that "
        "too)",
        rest=rest,
        turned=turned,
    )


def left_of_half(result: ImbalanceResult) -> tuple[float, float]:
    """Force [N] and couple [N·m] turning forward that half of the reciprocating mass, opposite the pins, leaves."""
    force, couple = (abs(a + b / 2) for a, b in zip(result.orders["order_1"].unbalanced[0::2], result.whole))
    return force, couple


def _turned(result: ImbalanceResult) -> float:
    """The angle between the forward vector of first order and the pins' own [rad]: an offset cylinder's force leads or
    lags its crank."""
    F_f, _, C_f, _ = result.orders["order_1"].unbalanced
    vector, pins = max(((F_f, result.whole[0]), (C_f, result.whole[1])), key=lambda pair: abs(pair[1]))
    return abs(argument(-vector * pins.conjugate()))


def shafts_words(shafts: dict[str, BalanceShaft]) -> Text:
    """The shafts against the second order: a pair, or the one side that there is."""
    speed = _one_speed(shafts)
    return Text("two shafts at ±2") if speed is None else Text("one shaft at {speed}", speed=speed)


def _one_speed(shafts: dict[str, BalanceShaft]) -> Amount | None:
    """The speed of a single shaft over the crank's; None of a pair."""
    return None if len(shafts) > 1 else Amount(next(iter(shafts.values())).speed_ratio, form="+g")


def _count(what: Text) -> int:
    """Of the things that `_what` has named: of two joined ones the text has a part for each."""
    return len(what.parts)


def _what(force: float, couple: float, least_force: float, least_couple: float) -> Text:
    """Force and couple in words, as far as they count."""
    parts = [Text("a force of {force} N", force=Amount(force))] if force > least_force else []
    parts += [Text("a couple of {couple} N·m", couple=Amount(couple))] if couple > least_couple else []
    return listed(parts) if parts else EMPTY
