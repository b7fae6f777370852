# SPDX-License-Identifier: Apache-2.0
"""How bush or shells sit in their housing: the interference, given or chosen, and what follows from it."""

from ....countershaft.rows import BearingRow
from ....library.catalogue import Material
from ....library.tolerances import tolerance
from ....sheet.record import replace
from ....sheet.units import Celsius, Metre, Newton, Number, RadPerSecond, Watt
from ....sheet.value import based_on, untraced
from ...inputs import BearingsInputs
from . import formulas as f
from .result import SeatResult, Temperatures
from .rings import Rings
from .stack import SeatStack

CRUSH_FIELD: Metre = (
    12e-6  # of the interference of shells that are sorted by their crush, assumed; rule of this program
)
BUSH_GRADE = 7  # IT of the interference of a bush, assumed
COLDEST: Celsius = -60.0  # at which a fit is asked whether it is loose
GUESSED = 15.0  # K of the film above its supply, before it is solved
HOLDING_FRICTION: Number = 0.10  # μ_s of steel pressed in metal; from memory


def rings_of(
    row: BearingRow, inputs: BearingsInputs, stack: SeatStack | None, backing: Material, housing: Material, d: Metre
) -> Rings | None:
    """What is pressed into the housing of a bearing of diameter `d`; None: nothing.  An interference that is not given
    is nought until it is chosen."""
    if not row.ringed:
        return None
    walls = stack.walls if stack is not None and stack.walls is not None else row.wall
    assert walls is not None
    bore = row.bore if stack is None or stack.walls is None else stack.bore
    journal = None if stack is None else stack.journal
    rings = Rings(
        backing=backing,
        housing=housing,
        wall=based_on((walls[0] + walls[-1]) / 2, walls),
        restraint=inputs.expansion_restraint,
        reference=inputs.clearance_reference_temperature,
        interference=(0.0, 0.0),
        bore=None if bore is None else based_on((bore[0] + bore[1]) / 2, row.bore),
        journal=None if journal is None else based_on((journal[0] + journal[1]) / 2, row.journal),
        outside=row.housing_outer,
    )
    if row.interference is not None:
        least, most = row.interference
        return replace(rings, interference=(least, most))
    if row.crush is not None:
        d_o = f.outside_of_bush(d_i=d, w=rings.wall) if rings.bore is None else rings.bore
        least, most = (
            f.interference_of_crush(
                c=based_on(c, row.crush), F_c=row.crush_load, d_o=d_o, E_B=backing.E, w=rings.wall, b=row.length
            )
            for c in row.crush
        )
        return replace(rings, interference=(least, most))
    return replace(rings, chosen=True)


def states(inputs: BearingsInputs, hot: Celsius) -> Temperatures:
    """`hot`: of the film and the bush."""
    given = inputs.housing_temperature
    return Temperatures(
        cold=inputs.lowest_temperature,
        reference=inputs.clearance_reference_temperature,
        hot=hot,
        housing=hot if given is None else given,
        cool=inputs.supply_temperature if given is None else None,
    )


def chosen(rings: Rings, row: BearingRow, clearance: Metre, F: Newton, at: Temperatures) -> Rings:
    """With the least interference that keeps the fit shut under the load in every state, and the field in which parts
    are made.  As they stand where it is given."""
    if not rings.chosen:
        return rings
    fit = rings.quiet_fit(row.diameter, clearance)
    p_need = f.press_needed(F=F, d_o=fit.d_o, l=row.length)
    with untraced():
        needs = [(rings.needed(fit, p_need, *state), state) for state in _states(at)]
    _, governing = max(needs)
    least = max(rings.needed(fit, p_need, *governing), 0.0)
    field = CRUSH_FIELD if row.seat == "shells" else tolerance(BUSH_GRADE, fit.d_o)
    return replace(rings, interference=(least, based_on(least + field, least)))


def _states(at: Temperatures) -> tuple[tuple[Celsius, Celsius], ...]:
    """Of bush and housing."""
    return (at.hot, at.housing), (at.cold, at.cold), (at.reference, at.reference)


def seated(
    rings: Rings, row: BearingRow, clearance: Metre, F: Newton, P_f: Watt, omega: RadPerSecond, at: Temperatures
) -> SeatResult:
    """`F`: the largest load; `P_f`: friction of the film on the bush."""
    fit = rings.fit(row.diameter, clearance)
    least, most = rings.interference
    middle = rings.pressed(fit, rings.middle)
    alpha_H = rings.housing.expansion * (1 - rings.restraint)
    s = middle.c / rings.middle if rings.middle else rings.pressed(fit, 1e-6).c / 1e-6
    press, cold = (rings.pressed(fit, least).p, rings.at(fit, least, at.cold, at.cold).p)
    hot = rings.at(fit, least, at.hot, at.housing).p
    cool = None
    if at.cool is not None:
        with untraced():
            cool = rings.at(fit, least, at.hot, at.cool).p
    with untraced():
        tightest = max(_states(at), key=lambda state: rings.at(fit, most, *state).delta)
    p = rings.at(fit, most, *tightest).p
    tension = f.housing_tension(p=p, D=fit.D, d_o=fit.d_o)
    loose = None
    if alpha_H != rings.backing.expansion:  # hot, or cold where the housing grows less
        loose = f.loose_at(
            T_ref=rings.reference,
            delta=least,
            d_o=fit.d_o,
            alpha_H=rings.housing.expansion,
            chi=rings.restraint,
            alpha_B=rings.backing.expansion,
        )
    return SeatResult(
        interference_min=least,
        interference_max=most,
        interference=rings.middle,
        bore=fit.d_i,
        bore_free=based_on(fit.d_i + middle.c, fit.d_i, middle.c),
        bore_closing=middle.c,
        housing_growth=f.housing_growth(p=middle.p, d_o=fit.d_o, k_H=fit.k_H),
        press=press,
        press_cold=cold,
        press_hot=hot,
        press_needed=f.press_needed(F=F, d_o=fit.d_o, l=row.length),
        bush_stress=f.bush_stress(p=p, d_o=fit.d_o, d_i=fit.d_i),
        housing_stress=f.housing_stress(sigma_H=tension, p=p),
        expansion=f.bore_expansion(
            alpha_B=rings.backing.expansion,
            s=s,
            d_o=fit.d_o,
            d_i=fit.d_i,
            alpha_H=rings.housing.expansion,
            chi=rings.restraint,
        ),
        loose_at=loose if loose is not None and loose >= COLDEST else None,
        holding_torque=f.holding_torque(mu_s=HOLDING_FRICTION, p=hot, d_o=fit.d_o, l=row.length),
        drag_torque=f.drag_torque(P_f=P_f, omega=omega),
        rings=rings,
        temperatures=at,
        press_hot_cool=cool,
        tension=tension,
    )
