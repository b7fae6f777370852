# SPDX-License-Identifier: Apache-2.0
"""Forces and couples of orders 1 to 8, what the crank takes of them, what the counter-shaft must supply.

What other remedies would do stands beside it."""

from collections.abc import Iterator
from functools import cache
from typing import Any, TypedDict, overload

import numpy as np

from ..engine.inputs import EngineInputs
from ..engine.result import EngineResult
from ..engine.solve import ORDERS
from ..engine.solve import values as engine_values
from ..sheet.arguments import given_inputs
from ..sheet.arrays import Array, Num
from ..sheet.deferred import Later
from ..sheet.record import replace
from ..sheet.step import Outcome, Table
from ..sheet.text import Text
from ..sheet.units import KilogramMetre, Newton, Radian, RadPerSecond
from ..sheet.value import about, based_on, trace, untraced
from . import formulas as f
from . import orders as u
from .checks import checks, proposals
from .curves import Left, pictures, remedy_table
from .firing_orders import cranks_table, firing_orders
from .inputs import ImbalanceInputs
from .notes import errata, notes
from .orders import Order, order
from .remedies import counterweights, crank_masses, remedies
from .result import ImbalanceResult
from .shaft_pair import pair_table, shaft_pair
from .throws import polygons, systems_table, throws
from .webs import bob_table, webs

LISTED = 6  # cylinders up to which all firing orders are tried in every solution
ALWAYS = (1, 2, 4, 6)  # orders that are shown even where they are zero


def values(
    imbalance: ImbalanceInputs,
    engine: EngineInputs,
    e: EngineResult,
    shaft_teeth: int | None = None,
    axis: complex | None = None,
) -> ImbalanceResult:
    """Every number of this step.  Numbers of the engine, and the share on the crank, may be arrays, an engine each: so
    are the results.

    `shaft_teeth`: of the wheel on the counter-shaft; `axis`: where the shaft stands [m], real up, imaginary to the
    side."""
    orders: dict[str, Order] = {}
    kappa = imbalance.crank_balance_fraction
    judged = u.harmonics(e, imbalance.kinematics)
    for n, c_n in zip(ORDERS, judged):
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
    one_couple = one_force * crank.pitch
    one_force = based_on(one_force, e.reciprocating_mass, radius, e.angular_speed)
    one_couple = based_on(one_couple, one_force, crank.pitch)
    with untraced():
        of = 1.0, e.angular_speed, u.masses(e)[0], r, crank.theta_0
        phi, z = crank.phi, crank.z
        whole_force = (f.counterweight_force if e.unlike is None else u.counterweight_force)(*of, phi)
        whole_couple = (f.counterweight_couple if e.unlike is None else u.counterweight_couple)(*of, z, phi)
    whole = based_on(whole_force, *of, phi), based_on(whole_couple, z, *of, phi)
    weights = None
    if imbalance.counterweight_span is not None and imbalance.counterweight_radius is not None:
        pins = crank_masses(imbalance, e), r, crank.theta_0, phi, z
        weights = counterweights(
            *pins, imbalance.counterweight_span, imbalance.counterweight_radius, e.unlike is not None
        )
    with about(Text("throws by themselves")):
        bare = throws(kappa, engine, e)
    remedy = remedies(e.angular_speed, kappa, first.unbalanced, second.vectors, whole, one_force, one_couple, axis)
    return ImbalanceResult(
        orders=orders,
        required_couple=length,
        required_couple_phase=phase,
        required_unbalance_product=product,
        mistiming_per_degree=mistiming,
        mistiming_per_tooth=by_tooth,
        **forces,
        remedy=remedy,
        shaft_pair=shaft_pair(imbalance, e, remedy),
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


def solve(
    imbalance: ImbalanceInputs,
    engine: EngineInputs,
    e: EngineResult,
    taken: frozenset[int] = frozenset((-1,)),
    shaft_teeth: int | None = None,
    axis: complex | None = None,
) -> Outcome[ImbalanceResult]:
    """The imbalance of an engine whose crank carries the given share of the reciprocating masses.

    `taken`: at how many times crank speed the shafts of the design turn, below zero against the crank: what is left of
    that their own step judges.  `shaft_teeth`, `axis`: of a single shaft.
    """
    with trace() as lines:
        result, lam = values(imbalance, engine, e, shaft_teeth, axis), u.measures(engine, e)[1]
    shares = imbalance.crank_balance_fraction, imbalance.rotating_balance_fraction
    bobs = cache(lambda: bob_table(imbalance, engine, e))  # with notes

    def tables() -> Iterator[Table]:
        yield remedy_table(result, *shares)
        yield systems_table(result.throw, result.orders, result.one_force, result.one_couple, engine, e)
        if result.shaft_pair:
            yield pair_table(result.shaft_pair, imbalance.shaft_pair_order, result.remedy)
        yield from bobs()[0]
        if 2 < engine.cylinders <= LISTED:
            yield cranks_table(firing_orders(imbalance, engine, e), engine)

    return Outcome(
        "imbalance",
        result=result,
        checks=tuple(checks(result, lam, *shares, taken, engine.unlike_offsets)),
        lines=tuple(lines),
        curves=Later(lambda: (*pictures(result), *polygons(engine, e, result.throw))),
        tables=Later(tables),
        errata=Later(lambda: errata(imbalance, result) if -1 in taken else ()),
        proposals=proposals(result, lam, *shares, taken, engine.unlike_offsets),
        notes=Later(lambda: notes(imbalance, e.crank.pitch, result, bobs()[1])),
    )


def with_shafts(
    outcome: Outcome[ImbalanceResult], left: Left, imbalance: ImbalanceInputs, *, several: bool = False
) -> Outcome[ImbalanceResult]:
    """The same outcome, its figures and its table of remedies with what the design's own shafts leave, by order: F⁺ F⁻
    C⁺ C⁻, cylinder 1 at TDC; `several`: of more than one shaft."""
    result = outcome.solution
    shares = imbalance.crank_balance_fraction, imbalance.rotating_balance_fraction
    tables = Later(lambda: (remedy_table(result, *shares, left, several=several), *outcome.tables[1:]))
    others = Later(lambda: (curve for curve in outcome.curves if curve.id.startswith("polygon")))
    return replace(outcome, curves=Later(lambda: (*pictures(result, left, several=several), *others)), tables=tables)


# --- from Python, in SI: `from calc import imbalance`


@overload
def solve_imbalance(
    engine: EngineInputs, crank_balance_fraction: float = ..., kinematics: str = ...
) -> ImbalanceResult[float]: ...
@overload
def solve_imbalance(
    engine: EngineInputs, crank_balance_fraction: float = ..., kinematics: str = ..., **varied: Num
) -> ImbalanceResult[Array]: ...
def solve_imbalance(
    engine: EngineInputs, crank_balance_fraction: float = 0.5, kinematics: str = "exact", **varied: Any
) -> ImbalanceResult[Any]:
    """Forces and couples of orders 1 to 8, and what a counter-shaft must supply.

    `engine`: in SI, as EngineInputs say.  `crank_balance_fraction`: share of the reciprocating mass that the crank's
    own counterweights carry.  `kinematics`: "exact" or "two_term".  `varied`: numbers of the engine that are others, by
    their names; they may be arrays of one length, an engine each: so are the results.  BadInput where a number lies
    outside of the range that it has in a design file."""
    inputs = ImbalanceInputs(crank_balance_fraction=crank_balance_fraction, kinematics=kinematics)
    inputs = given_inputs("solve_imbalance", inputs)
    engine = given_inputs("solve_imbalance", engine, varied)
    return values(inputs, engine, engine_values(engine))
