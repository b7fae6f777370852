# SPDX-License-Identifier: Apache-2.0
"""What is left, judged against one cylinder's force, and the remedies that it calls for."""

import math
from collections.abc import Iterator

from ..sheet.check import Check
from ..sheet.functions import argument, degrees
from ..sheet.shim_check import check
from ..sheet.text import EMPTY, Amount, Text, listed, plural
from ..sheet.units import Newton, NewtonMetre, Number
from .remedies import BalanceShaft
from .result import ImbalanceResult
from .shaft_pair import roll_check

FIRST, SECOND = 0.05, 0.5  # shares of one cylinder's first- and second-order force that a good balance may leave
TURNED = math.radians(0.01)
OWN = Text(
    "rule of this program: 5 % (order 1) or 50 % of λ (order 2) of m·r·ω² of one cylinder, couples over one pitch"
)


def checks(result: ImbalanceResult, lam: Number, kappa: Number, rho: Number, shaft: bool) -> Iterator[Check]:
    """What is left, against the force of one cylinder's reciprocating mass and its couple over one pitch.

    `kappa`, `rho`: shares of the reciprocating and of the rotating masses that the crank's counterweights carry.
    """
    first, second = result.orders["order_1"], result.orders["order_2"]
    forward = Text(
        "A backward shaft can not take it: balance half of the reciprocating mass on the crank (fraction 0.5)."
    )
    if abs(rho - 1) > 1e-9:
        forward = Text(
            "A backward shaft can not take it: balance the rotating masses whole and half of the reciprocating mass on "
            "the crank (rotating_balance_fraction 1, crank_balance_fraction 0.5)."
        )
    elif (turned := _turned(result)) > TURNED and abs(kappa - 0.5) < 1e-9:
        forward = Text(
            "The offset turns it away from the pins: counterweights turned by {degrees}° from opposite them take it.",
            degrees=Amount(degrees(turned)),
        )
    phase = Amount(round(degrees(result.required_couple_phase), 3), "°")
    counter = Text(
        "One shaft at −ω takes it: {required_couple} N·m at {phase}",
        required_couple=Amount(result.required_couple),
        phase=phase,
    ) + (Text("; add [countershaft].") if not shaft else ".")
    backward = Text(
        "A shaft at −ω with this force, in the plane of the engine's middle, takes it; it may carry the couple as well."
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

    if not shaft:
        yield _couple_check(
            result, "order_1.backward", Text("First-order couple turning backward"), first.couple_backward, counter
        )
        yield _force_check(
            result, "order_1.backward_force", Text("First-order force turning backward"), first.force_backward, backward
        )
    yield _couple_check(
        result, "order_1.forward", Text("First-order couple turning forward"), first.couple_forward, forward
    )
    yield _force_check(
        result, "order_1.forward_force", Text("First-order force turning forward"), first.force_forward, forward
    )
    share = SECOND * lam
    yield _couple_check(result, "order_2.couple", Text("Second-order couple left"), second.couple_peak, two, share)
    yield _force_check(result, "order_2.force", Text("Second-order force left"), second.force_peak, two, share)
    if result.shaft_pair is not None:
        yield roll_check(result.shaft_pair)
    yield from _crank_checks(result)


def _force_check(
    result: ImbalanceResult, name: str, label: Text, force: Newton, advice: Text, share: Number = FIRST
) -> Check:
    """Whether no more is left than a share of the force of one cylinder."""
    return check(f"imbalance.{name}", label, force, "<=", share * result.one_force, "N", OWN, advice)


def _couple_check(
    result: ImbalanceResult, name: str, label: Text, couple: NewtonMetre, advice: Text, share: Number = FIRST
) -> Check:
    """The same of a couple, and of that force over one pitch."""
    return check(f"imbalance.{name}", label, couple, "<=", share * result.one_couple, "N·m", OWN, advice)


def _crank_checks(result: ImbalanceResult) -> Iterator[Check]:
    """The crank on the balancing machine, and what pulley and flywheel supply, by the same measure."""
    webs = result.webs
    if webs is None:
        return
    if webs.crank is not None:
        name = "stated" if "stated" in webs.crank else "balanced"
        state = webs.crank[name]
        bobs = Text("with the bobs as stated") if name == "stated" else Text("with the bobs found")
        advice = Text("Other bobs (bob_mode), or other webs: the list of bodies shows where mass is missing.")
        label = Text("Force of the crank {bobs}", bobs=bobs)
        yield _force_check(result, "crank.force", label, state.force, advice)
        label = Text("Couple of the crank {bobs}", bobs=bobs)
        yield _couple_check(result, "crank.couple", label, state.couple, advice)
        if webs.permitted_unbalance is not None and webs.drilled_mass is None:
            yield check(
                "imbalance.crank.residual",
                Text("Static unbalance of the crank {bobs}", bobs=bobs),
                state.unbalance,
                "<=",
                webs.permitted_unbalance,
                "kg·mm",
                Text("ISO 21940-11, permissible residual unbalance, of the mass that is listed"),
                Text(
                    "The balancing machine has it drilled out: give drill_radius_mm, and the webs to drill are found."
                ),
            )
    if webs.unbalances_couple_left is not None:
        yield _couple_check(
            result,
            "unbalances.couple_left",
            Text("Wanted couple that pulley and flywheel leave"),
            webs.unbalances_couple_left,
            Text("Their unbalances together must supply missing_forward_couple at missing_forward_couple_phase."),
        )
    if webs.pin_deviation is not None:
        yield check(
            "imbalance.crank.throws",
            Text("Pins of the crank's bodies against the throws"),
            webs.pin_deviation,
            "<=",
            math.radians(2),
            "°",
            Text("rule of this program: within 2°"),
            Text("Look at crank_bodies_throw_at_tdc, and at x (up) and y (in the sense of rotation) of the pins."),
        )


def proposals(result: ImbalanceResult, lam: Number, kappa: Number, rho: Number, shaft: bool) -> tuple[Text, ...]:
    """The remedies that the residuals of this engine call for, and why: from the engine without any share on the
    crank."""
    F_f, F_b, C_f, C_b = (abs(v) for v in result.orders["order_1"].unbalanced)
    F_p, F_m, C_p, C_m = (abs(v) for v in result.orders["order_2"].vectors)
    first = FIRST * result.one_force, FIRST * result.one_couple
    second = SECOND * lam * result.one_force / 2, SECOND * lam * result.one_couple / 2  # of a pair: half of its peak
    proposed = []
    turns_forward, turns_backward = _what(F_f, C_f, *first), _what(F_b, C_b, *first)
    if turns_forward:
        done = Text("as designed")
        if abs(kappa - 0.5) >= 1e-9:
            done = Text("the design has {kappa}", kappa=Amount(kappa, form="g"))
        proposed.append(
            Text(
                "Counterweights on the crank for half of the reciprocating mass (crank_balance_fraction 0.5; {done}), "
                "because they {taken} of first order that turns forward: {turns_forward}.",
                done=done,
                taken=_taken(result, rho, first),
                turns_forward=turns_forward,
            )
            + (EMPTY if turns_backward else Text(" Nothing of first order turns backward: no shaft is needed for it."))
        )
    if turns_backward:
        done = Text(" (as designed)") if shaft else EMPTY
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
        speed = _one_speed(shafts.shafts)
        proposed.append(
            Text("Two shafts at ±2 times crank speed, where the comfort is worth it, because {left}", left=left)
            if speed is None
            else Text(
                "One shaft at {speed} times crank speed, where the comfort is worth it, because {left}",
                speed=speed,
                left=left,
            )
        )
    if (
        result.webs is not None
        and result.webs.missing_forward_couple is not None
        and result.webs.unbalances_couple is None
    ):
        missing = _what(result.webs.missing_forward_force or 0.0, result.webs.missing_forward_couple, *first)
        if missing:
            direction = Amount(round(degrees(result.webs.missing_forward_couple_phase or 0.0), 3), "°")
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


def _taken(result: ImbalanceResult, rho: Number, least: tuple[float, float]) -> Text:
    """What the half on the crank takes: all, or what an offset cylinder leaves, whose force does not stand opposite the
    pin."""
    left = (a + b / 2 for a, b in zip(result.orders["order_1"].unbalanced[0::2], result.whole))
    rest = _what(*(abs(x) for x in left), *(limit / 50 for limit in least))
    if not rest:
        return Text("take all")
    if abs(rho - 1) > 1e-9:
        share = Amount(rho, form="g")
        return Text(
            "take all but {rest} (the rotating masses are balanced to a share of {share} only)", rest=rest, share=share
        )
    turned = Amount(degrees(_turned(result)), "°")
    return Text(
        "take all but {rest} (the offset turns it by {turned} from the pins; counterweights turned as far take that "
        "too)",
        rest=rest,
        turned=turned,
    )


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
    """Of the things that `_what` has named: two where they are joined."""
    return 1 if {"force", "couple"} & what.parts.keys() else 2


def _what(force: float, couple: float, least_force: float, least_couple: float) -> Text:
    """Force and couple in words, as far as they count."""
    parts = [Text("a force of {force} N", force=Amount(force))] if force > least_force else []
    parts += [Text("a couple of {couple} N·m", couple=Amount(couple))] if couple > least_couple else []
    return listed(parts) if parts else EMPTY
