# SPDX-License-Identifier: Apache-2.0
"""What is left, judged against one cylinder's force, and the remedies that it calls for."""

import math
from typing import TYPE_CHECKING

from ..sheet.check import Check, check
from ..sheet.functions import argument
from ..sheet.number import short
from ..sheet.units import Number
from .remedies import BalanceShaft

if TYPE_CHECKING:
    from .solve import ImbalanceResult

FIRST, SECOND = 0.05, 0.5  # shares of one cylinder's first- and second-order force that a good balance may leave
TURNED = math.radians(0.01)
OWN = "rule of this program: 5 % (order 1) or 50 % of λ (order 2) of m·r·ω² of one cylinder, couples over one pitch"


def checks(result: "ImbalanceResult", lam: Number, kappa: Number, shaft: bool) -> tuple[Check, ...]:
    """What is left, against the force of one cylinder's reciprocating mass and its couple over one pitch."""
    force, couple = result.one_force, result.one_couple
    first, second = result.orders["order_1"], result.orders["order_2"]
    forward = "A backward shaft can not take it: balance half of the reciprocating mass on the crank (fraction 0.5)."
    if (turned := _turned(result)) > TURNED and abs(kappa - 0.5) < 1e-9:
        forward = (
            f"The offset turns it away from the pins: counterweights turned by {short(math.degrees(turned))}° from opposite them take it."
        )
    phase = short(round(math.degrees(result.required_couple_phase), 3))
    counter = f"One shaft at −ω takes it: {short(result.required_couple)} N·m at {phase}°" + ("; add [countershaft]." if not shaft else ".")
    backward = "A shaft at −ω with this force, in the plane of the engine's middle, takes it; it may carry the couple as well."
    shafts = result.remedy.get("second_order_shafts")
    two = f"A shaft at crank speed leaves it whole; {shafts_words(shafts.shafts)}ω would take it, a longer rod lowers it." if shafts else ""

    def advice(name: str, label: str, value: float, limit: float, unit: str, what: str) -> Check:
        return check(f"imbalance.{name}", label, value, "<=", limit, unit, OWN, what, kind="advice")

    alone = (
        advice("order_1.backward", "First-order couple turning backward", first.couple_backward, FIRST * couple, "N·m", counter),
        advice("order_1.backward_force", "First-order force turning backward", first.force_backward, FIRST * force, "N", backward),
    )
    return (
        *(() if shaft else alone),
        advice("order_1.forward", "First-order couple turning forward", first.couple_forward, FIRST * couple, "N·m", forward),
        advice("order_1.forward_force", "First-order force turning forward", first.force_forward, FIRST * force, "N", forward),
        advice("order_2.couple", "Second-order couple left", second.couple_peak, SECOND * lam * couple, "N·m", two),
        advice("order_2.force", "Second-order force left", second.force_peak, SECOND * lam * force, "N", two),
        *_crank_checks(result),
    )


def _crank_checks(result: "ImbalanceResult") -> tuple[Check, ...]:
    """The crank on the balancing machine, and what pulley and flywheel supply, by the same measure."""
    webs, force, couple = result.webs, result.one_force, result.one_couple
    if webs is None:
        return ()
    made = []
    if webs.crank is not None:
        name = "stated" if "stated" in webs.crank else "balanced"
        state = webs.crank[name]
        bobs = "with the bobs as stated" if name == "stated" else "with the bobs found"
        what = "Other bobs (bob_mode), or other webs: the list of bodies shows where mass is missing."
        made += [
            check("imbalance.crank.force", f"Force of the crank {bobs}", state.force, "<=", FIRST * force, "N", OWN, what, kind="advice"),
            check(
                "imbalance.crank.couple", f"Couple of the crank {bobs}", state.couple, "<=", FIRST * couple, "N·m", OWN, what, kind="advice"
            ),
        ]
    if webs.unbalances_couple_left is not None:
        made.append(
            check(
                "imbalance.unbalances.couple_left", "Wanted couple that pulley and flywheel leave", webs.unbalances_couple_left, "<=",
                FIRST * couple, "N·m", OWN,
                "Their unbalances together must supply missing_forward_couple at missing_forward_couple_phase.", kind="advice",
            )
        )  # fmt: skip
    if webs.pin_deviation is not None:
        made.append(
            check(
                "imbalance.crank.throws", "Pins of the crank's bodies against the throws", webs.pin_deviation, "<=", math.radians(2), "°",
                "rule of this program: within 2°",
                "Look at crank_bodies_throw_at_tdc, and at x (up) and y (in the sense of rotation) of the pins.", kind="advice",
            )
        )  # fmt: skip
    return tuple(made)


def proposals(result: "ImbalanceResult", lam: Number, kappa: Number, shaft: bool) -> tuple[str, ...]:
    """The remedies that the residuals of this engine call for, and why: from the engine without any share on the crank."""
    F_f, F_b, C_f, C_b = (abs(v) for v in result.orders["order_1"].unbalanced)
    F_p, F_m, C_p, C_m = (abs(v) for v in result.orders["order_2"].vectors)
    first = FIRST * result.one_force, FIRST * result.one_couple
    second = SECOND * lam * result.one_force / 2, SECOND * lam * result.one_couple / 2  # of a pair: half of its peak
    said = []
    turns_forward, turns_backward = _what(F_f, C_f, *first), _what(F_b, C_b, *first)
    if turns_forward:
        done = "as designed" if abs(kappa - 0.5) < 1e-9 else f"the design has {kappa:g}"
        said.append(
            f"Counterweights on the crank for half of the reciprocating mass (crank_balance_fraction 0.5; {done}), because they "
            f"{_taken(result, first)} of first order that turns forward: {turns_forward}."
            + ("" if turns_backward else " Nothing of first order turns backward: no shaft is needed for it.")
        )
    if turns_backward:
        turn = "turn" if " and " in turns_backward else "turns"
        done = " (as designed)" if shaft else ""
        text = f"One shaft at −1 times crank speed{done}, because {turns_backward} of first order {turn} backward, "
        text += "and nothing on the crank can take it."
        if (roll := result.remedy["backward_shaft"].roll_torque_at_100_mm) is not None and F_b > first[0]:
            text += f" It carries a force: each 100 mm beside the crank's axis cost a roll torque of {short(roll)} N·m; "
            text += "two shafts at ±1 cost none."
        said.append(text)
    plus, minus = _what(F_p, C_p, *second), _what(F_m, C_m, *second)
    if plus or minus:
        how = shafts_words(result.remedy["second_order_shafts"].shafts)
        how = how[0].upper() + how[1:]
        both = _what(F_p + F_m, C_p + C_m, *second)
        said.append(
            f"{how} times crank speed, where the comfort is worth it, because {both} of second order "
            f"{'are' if ' and ' in both else 'is'} left at the peak; "
            "neither the crank nor a shaft at crank speed changes it."
        )
    if result.webs is not None and result.webs.missing_forward_couple is not None and result.webs.unbalances_couple is None:
        missing = _what(result.webs.missing_forward_force or 0.0, result.webs.missing_forward_couple, *first)
        if missing:
            direction = short(round(math.degrees(result.webs.missing_forward_couple_phase or 0.0), 3))
            said.append(
                f"Unbalances on pulley and flywheel that supply {missing} (the couple at {direction}°), because the crank's own webs "
                f"lack it for the share {kappa:g}; give them as [[imbalance.unbalances]] to see what is left."
            )
    return tuple(said) or ("No remedy is called for: neither order 1 nor order 2 leaves a force or couple that counts.",)


def _taken(result: "ImbalanceResult", least: tuple[float, float]) -> str:
    """What the half on the crank takes: all, or what an offset cylinder leaves, whose force does not stand opposite the pin."""
    left = (a + b / 2 for a, b in zip(result.orders["order_1"].unbalanced[0::2], result.whole))
    rest = _what(*(abs(x) for x in left), *(limit / 50 for limit in least))
    if not rest:
        return "take all"
    turned = short(math.degrees(_turned(result)))
    return f"take all but {rest} (the offset turns it by {turned}° from the pins; counterweights turned as far take that too)"


def _turned(result: "ImbalanceResult") -> float:
    """The angle between the forward vector of first order and the pins' own [rad]: an offset cylinder's force leads or lags its crank."""
    F_f, _, C_f, _ = result.orders["order_1"].unbalanced
    vector, pins = max(((F_f, result.whole[0]), (C_f, result.whole[1])), key=lambda pair: abs(pair[1]))
    return abs(argument(-vector * pins.conjugate()))


def shafts_words(shafts: dict[str, BalanceShaft]) -> str:
    """The shafts against the second order: a pair, or the one side that there is."""
    return "two shafts at ±2" if len(shafts) > 1 else f"one shaft at {next(iter(shafts.values())).speed_ratio:+g}".replace("-", "−")


def _what(force: float, couple: float, least_force: float, least_couple: float) -> str:
    """Force and couple in words, as far as they count."""
    parts = [f"a force of {short(force)} N"] if force > least_force else []
    parts += [f"a couple of {short(couple)} N·m"] if couple > least_couple else []
    return " and ".join(parts)
