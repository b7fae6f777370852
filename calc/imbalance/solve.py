# SPDX-License-Identifier: Apache-2.0
"""Forces and couples of orders 1 to 8, what the crank takes of them, what the counter-shaft must supply, and what other remedies would."""

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from typing import TypedDict

import numpy as np

from ..engine.inputs import EngineInputs
from ..engine.result import EngineResult
from ..engine.solve import ORDERS
from ..sheet.arrays import each
from ..sheet.later import Later
from ..sheet.quantity import group, result, value
from ..sheet.step import Erratum, Outcome, Table
from ..sheet.text import Text
from ..sheet.trace import about, trace, untraced
from ..sheet.units import KilogramMetre, KilogramMetre2, Newton, NewtonMetre, Radian, RadPerSecond
from ..sheet.value import based_on
from . import formulas as f
from . import unlike as u
from .checks import checks, proposals
from .curves import Shaft, pictures, remedy_table
from .drilling import UNDRILLED
from .firing_orders import cranks_table, firing_orders
from .inputs import ImbalanceInputs
from .orders import Order, order
from .remedies import Counterweight, Remedy, counterweights, crank_masses, remedies
from .shaft_pair import ShaftPair, pair_table, roll_notes, shaft_pair
from .throws import Throws, polygons, systems_table, throws, verdict
from .webs import WebsResult, bob_table, webs

LISTED = 6  # cylinders up to which all firing orders are tried in every solution
ALWAYS = (1, 2, 4, 6)  # orders that are shown even where they are zero


@result
class ImbalanceResult:
    """All orders, what the counter-shaft must supply, and the remedies."""

    orders: dict[str, Order] = group(spread=True)
    required_couple: NewtonMetre = value("Couple that the counter-shaft must supply", "N·m", "C_S")
    required_couple_phase: Radian = value("its phase, cylinder 1 at TDC", "°")
    required_unbalance_product: KilogramMetre2 = value("Unbalance times arm of the counter-shaft", "kg·mm²", "U·Δz")
    required_force: Newton | None = value("Force that the counter-shaft must supply", "N", "F_S", default=None)
    required_force_phase: Radian | None = value("its phase, cylinder 1 at TDC", "°", default=None)
    required_unbalance: KilogramMetre | None = value("Unbalance of the counter-shaft", "kg·mm", "U", default=None)
    mistiming_force_per_degree: Newton | None = value("Force left per degree of mistiming", "N", default=None)
    mistiming_force_per_tooth: Newton | None = value("Force left per tooth of mistiming at the shaft's wheel", "N", default=None)
    mistiming_per_degree: NewtonMetre = value("Couple left per degree of mistiming", "N·m")
    mistiming_per_tooth: NewtonMetre | None = value("Couple left per tooth of mistiming at the shaft's wheel", "N·m", default=None)
    remedy: dict[str, Remedy] = group()
    shaft_pair: ShaftPair | None = group(default=None)
    counterweight: dict[str, Counterweight] | None = group(default=None)
    throw: Throws = group()
    webs: WebsResult | None = group(spread=True, default=None)
    required: complex  # the vector
    whole: tuple[complex, complex]  # force and couple of counterweights for the whole reciprocating mass
    one_force: Newton  # m·r·ω² of one cylinder, and its couple over one pitch: what is left is measured against them
    one_couple: NewtonMetre


def values(
    imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult, shaft_teeth: int | None = None, axis: complex | None = None
) -> ImbalanceResult:
    """Every number of this step.  Numbers of the engine, and the share on the crank, may be arrays, an engine each: so are the results.

    `shaft_teeth`: of the wheel on the counter-shaft; `axis`: where the shaft stands [m], real up, imaginary to the side.
    """
    orders: dict[str, Order] = {}
    kappa = imbalance.crank_balance_fraction
    judged = u.harmonics(e, imbalance.kinematics)
    for n in ORDERS:
        c_n = judged[n - 1]
        if not np.any(c_n) and n not in ALWAYS:
            continue
        with about(Text("order {n}", n=n)):
            solved = order(n, c_n, imbalance, engine, e)
        if n <= 2:
            with about(Text("order {n}, two terms", n=n)):
                solved = replace(solved, two_term=order(n, u.harmonics(e)[n - 1], imbalance, engine, e))
        orders[f"order_{n}"] = solved
    first, second = orders["order_1"], orders["order_2"]
    with about(Text("counter-shaft")):
        required = f.required_couple(first.vectors[3])
        length = f.couple_length(C=required)
        phase = f.couple_direction(C=required)
        product = f.unbalance_product(C_S=length, omega=e.angular_speed)
        mistiming = f.couple_per_degree(C_S=length)
        by_tooth = f.couple_per_tooth(C_S=length, z=based_on(float(shaft_teeth), shaft_teeth)) if shaft_teeth else None
        forces = _force_shaft(first.vectors[1], e.angular_speed, shaft_teeth) if np.any(first.vectors[1]) else _Force()
    crank = e.crank
    r, radius = u.radius(engine, e), u.measures(engine, e)[0]
    one_force = e.reciprocating_mass * radius * e.angular_speed**2
    one_couple = one_force * engine.cylinder_pitch
    one_force = based_on(one_force, e.reciprocating_mass, radius, e.angular_speed)
    one_couple = based_on(one_couple, one_force, engine.cylinder_pitch)
    with untraced():
        of = 1.0, e.angular_speed, u.masses(e)[0], r, crank.theta_0
        phi, z = each(crank.phi), each(crank.z)
        whole_force = (f.counterweight_force if e.unlike is None else u.counterweight_force)(*of, phi)
        whole_couple = (f.counterweight_couple if e.unlike is None else u.counterweight_couple)(*of, z, phi)
    whole = based_on(whole_force, *of, phi), based_on(whole_couple, z, *of, phi)
    weights = None
    if imbalance.counterweight_span is not None and imbalance.counterweight_radius is not None:
        pins = crank_masses(imbalance, e), r, crank.theta_0, phi, z
        weights = counterweights(*pins, imbalance.counterweight_span, imbalance.counterweight_radius, e.unlike is not None)
    with about(Text("throws by themselves")):
        bare = throws(kappa, engine, e)
    found = remedies(e.angular_speed, kappa, first.unbalanced, second.vectors, whole, one_force, one_couple, axis)
    return ImbalanceResult(
        orders=orders,
        required_couple=length,
        required_couple_phase=phase,
        required_unbalance_product=product,
        mistiming_per_degree=mistiming,
        mistiming_per_tooth=by_tooth,
        **forces,
        remedy=found,
        shaft_pair=shaft_pair(imbalance, e, found),
        counterweight=weights,
        throw=bare,
        webs=webs(imbalance, engine, e),
        required=required,
        whole=whole,
        one_force=one_force,
        one_couple=one_couple,
    )


class _Force(TypedDict, total=False):
    required_force: Newton
    required_force_phase: Radian
    required_unbalance: KilogramMetre
    mistiming_force_per_degree: Newton
    mistiming_force_per_tooth: Newton | None


def _force_shaft(backward: complex, omega: RadPerSecond, teeth: int | None) -> _Force:
    """What a shaft must supply of force, where the engine has a first-order force that turns backward."""
    wanted = f.required_force(backward)
    length = f.force_length(F=wanted)
    return {
        "required_force": length,
        "required_force_phase": f.force_direction(F=wanted),
        "required_unbalance": f.required_unbalance(F_S=length, omega=omega),
        "mistiming_force_per_degree": f.force_per_degree(F_S=length),
        "mistiming_force_per_tooth": f.force_per_tooth(F_S=length, z=based_on(float(teeth), teeth)) if teeth else None,
    }


MIDDLE = Text(
    "Couples are taken about the middle of the engine; where a force is left as well, they hold about that "
    "plane only. A vertical "
    "couple is a pair of vertical forces, one at either end."
)


def solve(
    imbalance: ImbalanceInputs,
    engine: EngineInputs,
    e: EngineResult,
    shaft: bool = True,
    shaft_teeth: int | None = None,
    axis: complex | None = None,
) -> Outcome[ImbalanceResult]:
    """The imbalance of an engine whose crank carries the given share of the reciprocating masses.

    `shaft`: the design has a counter-shaft, whose own step judges what is left of the backward couple.
    """
    with trace() as lines:
        found, lam = values(imbalance, engine, e, shaft_teeth, axis), u.measures(engine, e)[1]
    bobs = cache(lambda: bob_table(imbalance, engine, e))  # with notes

    undrilled = imbalance.drill_radius is not None and (found.webs is None or found.webs.drilled_mass is None)

    def cranks() -> Iterator[Table]:
        if 2 < engine.cylinders <= LISTED:
            yield cranks_table(firing_orders(imbalance, engine, e), engine)

    def places() -> Iterator[Table]:
        if found.shaft_pair:
            yield pair_table(found.shaft_pair, imbalance.shaft_pair_order, found.remedy)

    return Outcome(
        "imbalance",
        result=found,
        checks=checks(found, lam, imbalance.crank_balance_fraction, shaft),
        lines=tuple(lines),
        curves=Later(lambda: (*pictures(found), *polygons(engine, e, found.throw))),
        tables=Later(
            lambda: (
                remedy_table(found, imbalance.crank_balance_fraction),
                systems_table(found.throw, found.orders, found.one_force, found.one_couple, engine, e),
                *places(),
                *bobs()[0],
                *cranks(),
            )
        ),
        errata=_errata(imbalance, found) if shaft else (),
        proposals=proposals(found, lam, imbalance.crank_balance_fraction, shaft),
        notes=Later(
            lambda: (
                verdict(found.throw, engine),
                *bobs()[1],
                *((UNDRILLED,) if undrilled else ()),
                MIDDLE,
                *roll_notes(imbalance, found.shaft_pair),
            )
        ),
    )


def with_shaft(outcome: Outcome[ImbalanceResult], shaft: Shaft, imbalance: ImbalanceInputs) -> Outcome[ImbalanceResult]:
    """The same outcome, its figures and its table of remedies with the design's own counter-shaft: force and couple, cylinder 1 at TDC."""
    found = outcome.solution
    tables = Later(lambda: (remedy_table(found, imbalance.crank_balance_fraction, shaft), *outcome.tables[1:]))
    others = Later(lambda: (curve for curve in outcome.curves if curve.id.startswith("polygon")))
    return replace(outcome, curves=Later(lambda: (*pictures(found, shaft), *others)), tables=tables)


def _errata(imbalance: ImbalanceInputs, result: ImbalanceResult) -> tuple[Erratum, ...]:
    """Where the thesis goes wrong that this chain follows: for designs with its kind of shaft."""
    second = result.orders.get("order_2")
    if second is None or second.two_term is None or not second.two_term.couple_peak_vertical or not imbalance.crank_balance_fraction:
        return ()
    theirs = f.second_order_couple_of_finotti(kappa=imbalance.crank_balance_fraction, C_2=second.two_term.couple_peak_vertical)
    return (
        Erratum(
            "imbalance.order_2.couple_peak_vertical",
            Text("Second-order couple"),
            float(theirs),
            "N·m",
            Text("method of Finotti 2013, 2.5.3.4"),
            Text(
                "The source takes only the mass that is not balanced on the crank. Counterweights turn at crank speed and leave order 2 "
                "untouched: the whole reciprocating mass acts."
            ),
        ),
    )
