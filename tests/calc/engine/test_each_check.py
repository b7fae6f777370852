"""Each check of the engine just inside and just outside its limit, and what is not known of the crank's material."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from calc.engine import throw
from calc.engine.checks import checks
from calc.engine.gas import GasInputs
from calc.engine.inputs import EngineInputs
from calc.engine.solve import solve
from calc.engine.throw_strength import ThrowFatigue
from calc.library.catalogue import materials
from calc.sheet.check import stretched
from tests.calc.engine.test_gas import DIESEL
from tests.calc.engine.test_throw import SIZES
from tests.calc.engine.test_throw import solved as solved_throw
from tests.calc.imbalance.engines import R753

ENGINE = EngineInputs(**R753, gas=GasInputs(**DIESEL), rated_power=50e3, flywheel_inertia=0.5)
RESULT = solve(ENGINE).result
TURNING = RESULT.torque


def found(engine=ENGINE, turning=(), **changes):
    """The checks by their ids, of the engine with some of its results replaced."""
    made = checks(engine, replace(RESULT, **changes), replace(TURNING, **dict(turning)))
    return {check.id: check for check in made}


def turning(**changes):
    return found(turning=changes)


def table_with_a_gap(degrees):
    """Pressures every 50°, and one gap."""
    corners = np.radians([0.0, *np.arange(degrees, 720.0, 50.0)])
    cycle = SimpleNamespace(corners=corners, length=math.radians(720.0))
    engine = replace(ENGINE, gas=replace(ENGINE.gas, pressure=((0.0, 1e5),)))
    return found(engine, turning=dict(cycle=cycle))


def ratios(*lambdas):
    return found(cylinder={str(i): SimpleNamespace(lambda_=lam) for i, lam in enumerate(lambdas)})


def intervals(shortest, longest):
    even = math.radians(240.0)
    return found(
        firing_interval=even,
        firing_interval_shortest=even - math.radians(shortest),
        firing_interval_longest=even + math.radians(longest),
    )


P_MI = TURNING.indicated_mean_pressure
CASES = [
    (
        "engine.speed_irregularity",
        lambda: turning(speed_irregularity=0.0499),
        lambda: turning(speed_irregularity=0.0501),
        "note",
    ),
    ("engine.gas.work", lambda: turning(indicated_work=1e-9), lambda: turning(indicated_work=0.0), "note"),
    (
        "engine.rated_power",
        lambda: found(brake_mean_pressure=0.949 * P_MI),
        lambda: found(brake_mean_pressure=1.001 * P_MI),
        "fail",
    ),
    (
        "engine.rated_power",
        lambda: found(brake_mean_pressure=0.949 * P_MI),
        lambda: found(brake_mean_pressure=0.951 * P_MI),
        "warn",
    ),
    ("engine.gas.gap", lambda: table_with_a_gap(59.9), lambda: table_with_a_gap(60.1), "note"),
    ("engine.crank.lambda_usual", lambda: ratios(0.2201, 0.26), lambda: ratios(0.26, 0.2199), "note"),
    ("engine.crank.lambda_usual", lambda: ratios(0.26, 0.2999), lambda: ratios(0.3001, 0.23), "note"),
    ("engine.crank.lambda_usual", lambda: found(lambda_=0.2999), lambda: found(lambda_=0.3001), "note"),
    ("engine.firing.even", lambda: intervals(0.99, 0.5), lambda: intervals(1.01, 0.5), "note"),
    ("engine.firing.even", lambda: intervals(0.5, 0.99), lambda: intervals(0.5, 1.01), "note"),
]


@pytest.mark.parametrize("id, inside, outside, verdict", CASES)
def test_inside_and_outside(id, inside, outside, verdict):
    assert (inside()[id].verdict, outside()[id].verdict) == ("pass", verdict)


@pytest.mark.parametrize(
    "id, quoted",
    [
        ("engine.speed_irregularity", "ΔE = J·ω²·δ_s holds for small δ_s; running drives are kept well below 1/20"),
        ("engine.gas.work", "energy: an engine gives work"),
        ("engine.rated_power", "energy: a crank gives no more than its gas"),
        ("engine.crank.lambda_usual", "Finotti 2013, 2.1, and mechanics textbook, 48.3.3: usual 0.22 to 0.30"),
        ("engine.firing.even", "even firing within 1° (Finotti 2013, 2.4"),
    ],
)
def test_sources(id, quoted):
    assert quoted in str(found()[id].source)
    assert "a straight line is taken across a gap" in str(table_with_a_gap(60)["engine.gas.gap"].source)


def test_of_a_gas_that_is_not_given_as_a_table_no_gap_is_judged():
    assert TURNING.cycle is not None and "engine.gas.gap" not in found()
    table = replace(ENGINE, gas=replace(ENGINE.gas, pressure=((0.0, 1e5),)))
    assert "engine.gas.gap" not in found(table, turning=dict(cycle=None))
    assert "engine.gas.gap" not in found(replace(ENGINE, gas=None))


def bores(engine, **changes):
    return {c.id: c.verdict for c in solve(replace(engine, gas=None, **changes)).checks}.get("engine.bores")


def test_bores_of_a_bank_that_overlap_fail():
    pitch = ENGINE.bore * 1.06
    assert [bores(ENGINE, cylinder_pitch=share * pitch) for share in (1.0, 0.97, 0.9)] == [None, "warn", "fail"]
    z = (-pitch, 0.0, pitch)
    assert bores(ENGINE, axial_positions=z) is None
    assert bores(ENGINE, axial_positions=(*z[:2], 0.9 * pitch)) == "fail"  # whatever the pitch
    aside = (0.0, 0.5 * pitch, 0.0)  # as in a row that stands in a zigzag
    assert bores(ENGINE, axial_positions=tuple(0.9 * x for x in z), cylinder_offsets=aside) is None


def test_bores_of_two_banks_stand_side_by_side():
    pair = dict(cylinders=2, layout="vee", bank_angle=math.pi / 2, crank_angles=(0.0, 0.0), firing_order=None)
    assert bores(ENGINE, **pair, axial_positions=(0.0, 0.01)) is None


def test_the_power_is_judged_where_both_pressures_are_known():
    assert "engine.rated_power" not in found(brake_mean_pressure=None)
    assert "engine.rated_power" not in turning(indicated_mean_pressure=None)


@pytest.mark.parametrize("lambdas, furthest", [((0.213, 0.306), 0.213), ((0.214, 0.307), 0.307), ((0.26, 0.25), 0.25)])
def test_the_crank_ratio_furthest_from_the_middle_of_the_usual_is_judged(lambdas, furthest):
    """0.26, in the middle of 0.22 to 0.30."""
    check = ratios(*lambdas)["engine.crank.lambda_usual"]
    assert check.value == furthest and ("A rod longer than usual" in check.advice) == (furthest < 0.22)


@pytest.mark.parametrize("share, shown", [(0.0, 0.0), (0.5, 0.0), (1.2, 1.2)])
def test_what_rounding_makes_of_an_even_firing_is_not_shown(share, shown):
    """Less than a billionth of a turn."""
    dust = 360e-9
    check = intervals(share * dust, 0.0)["engine.firing.even"]
    assert check.value == pytest.approx(shown * dust, rel=1e-6, abs=1e-30) and check.verdict == "pass"


def test_the_work_is_measured_against_a_tenth_of_a_megapascal():
    one_cylinder = math.pi / 4 * 0.094**2 * 0.107
    assert turning(indicated_work=0.1e6 * one_cylinder)["engine.gas.work"].margin == pytest.approx(1.0)


def test_a_gas_without_pressure_gives_a_margin_all_the_same():
    without = found(turning=dict(indicated_mean_pressure=0.0), brake_mean_pressure=0.2e6)["engine.rated_power"]
    assert without.verdict == "fail" and without.margin == pytest.approx(-2.0)


# --- the throw
STEEL = replace(materials()["42CrMo4"], proof_stress=500e6)
PLACES = ("pin", "journal", "pin_fillet", "journal_fillet")


def of_throw(place="", stress=0.0, material=STEEL, span=0.112, fillets=(0.05, 0.05), safety=3.0):
    """The checks of a throw; one place has `stress` [Pa] in one position of one of three cylinders, all else less."""
    worst = np.full((2, 3, 4), 1e6)
    if place:
        worst[1, 1, PLACES.index(place)] = stress
    crank = SimpleNamespace(
        throw=throw.ThrowInputs(**SIZES),
        engine=SimpleNamespace(cylinders=3),
        e=SimpleNamespace(crank=SimpleNamespace(pitch=0.112)),
        span=span,
        notch={place: (ratio, 1.0, 1.0) for place, ratio in zip(("pin", "journal"), fillets)},
        load=(),
    )
    fatigue = None
    if safety is not None:
        numbers = dict.fromkeys(("amplitude", "mean", "equivalent", "strength"), 1.0)
        fatigue = ThrowFatigue(
            **{f"fatigue_{name}": number for name, number in numbers.items()},
            fatigue_safety=safety,
            place="journal",
            cylinder=1,
            wanted=1.5,
        )
    return {check.id: check for check in throw._checks(crank, worst, material, fatigue)}


THROW_CASES = [
    ("engine.throw.stress_pin", lambda: of_throw("pin", 474e6), lambda: of_throw("pin", 500.1e6), "fail"),
    ("engine.throw.stress_pin", lambda: of_throw("pin", 474e6), lambda: of_throw("pin", 476e6), "warn"),
    ("engine.throw.stress_journal", lambda: of_throw("journal", 474e6), lambda: of_throw("journal", 500.1e6), "fail"),
    (
        "engine.throw.notch_stress_pin",
        lambda: of_throw("pin_fillet", 499.9e6),
        lambda: of_throw("pin_fillet", 500.1e6),
        "warn",
    ),
    (
        "engine.throw.notch_stress_journal",
        lambda: of_throw("journal_fillet", 499.9e6),
        lambda: of_throw("journal_fillet", 500.1e6),
        "warn",
    ),
    (
        "engine.throw.fillet_pin",
        lambda: of_throw(fillets=(0.0101, 0.05)),
        lambda: of_throw(fillets=(0.0099, 0.05)),
        "note",
    ),
    (
        "engine.throw.fillet_pin",
        lambda: of_throw(fillets=(0.299, 0.05)),
        lambda: of_throw(fillets=(0.301, 0.05)),
        "note",
    ),
    (
        "engine.throw.fillet_journal",
        lambda: of_throw(fillets=(0.05, 0.0101)),
        lambda: of_throw(fillets=(0.05, 0.0099)),
        "note",
    ),
    (
        "engine.throw.fillet_journal",
        lambda: of_throw(fillets=(0.05, 0.299)),
        lambda: of_throw(fillets=(0.05, 0.301)),
        "note",
    ),
    ("engine.throw.span", lambda: of_throw(span=0.801 * 0.112), lambda: of_throw(span=0.799 * 0.112), "note"),
    ("engine.throw.span", lambda: of_throw(span=1.099 * 0.112), lambda: of_throw(span=1.101 * 0.112), "note"),
    ("engine.throw.fatigue", lambda: of_throw(safety=1.501), lambda: of_throw(safety=1.499), "warn"),
]


@pytest.mark.parametrize("id, inside, outside, verdict", THROW_CASES)
def test_inside_and_outside_at_the_throw(id, inside, outside, verdict):
    assert (inside()[id].verdict, outside()[id].verdict) == ("pass", verdict)


@pytest.mark.parametrize(
    "id, quoted",
    [
        ("engine.throw.stress_pin", "elasticity, proof stress of 42CrMo4"),
        ("engine.throw.stress_journal", "elasticity, proof stress of 42CrMo4"),
        ("engine.throw.notch_stress_pin", "proof stress of 42CrMo4: above it the fillet yields locally"),
        ("engine.throw.notch_stress_journal", "proof stress of 42CrMo4: above it the fillet yields locally"),
        ("engine.throw.fillet_pin", "range of the notch factors (Norton"),
        ("engine.throw.fillet_journal", "range of the notch factors (Norton"),
        ("engine.throw.span", "a main journal between any two throws"),
        ("engine.throw.fatigue", "FKM guideline (from memory): endless life at rated speed"),
    ],
)
def test_sources_of_the_throw(id, quoted):
    assert quoted in str(of_throw()[id].source)


UNKNOWN = replace(STEEL, proof_stress=None)


@pytest.mark.parametrize("place", ["pin", "journal"])
@pytest.mark.parametrize("material", [UNKNOWN, None])
def test_without_proof_stress_the_weakest_steel_stands_for_it(place, material):
    """Below 235 MPa any steel bears it; above it depends on the steel, and nobody knows it to fail."""
    id = f"engine.throw.stress_{place}"
    weak, strong = (of_throw(place, stress, material)[id] for stress in (0.94 * 235e6, 235.1e6))
    assert (weak.verdict, strong.verdict) == ("pass", "not_verified")
    assert strong.limit == pytest.approx(235.0) and strong.missing == ("material.proof_stress_MPa",)
    assert str(strong.taken[0]) == "235 MPa, as the weakest structural steels"
    assert f"engine.throw.notch_stress_{place}" not in of_throw(place, 1e6, material)


@pytest.mark.parametrize(
    "material, wanted, missing",
    [
        (replace(STEEL, tensile_strength=None), 1.5, ["tensile_strength_MPa"]),
        (replace(STEEL, tensile_strength=None, kind="grey iron"), 2.1, ["tensile_strength_MPa"]),
        (replace(STEEL, kind="other"), 2.1, ["kind", "tensile_strength_MPa"]),
        (None, 2.1, ["kind", "tensile_strength_MPa"]),
    ],
)
def test_without_strength_fatigue_is_not_verified(material, wanted, missing):
    check = of_throw(material=material, safety=None)["engine.throw.fatigue"]
    assert check.verdict == "not_verified" and math.isnan(check.value) and check.limit == wanted
    assert list(check.missing) == [f"material.{key}" for key in missing]


def test_without_a_fillet_nobody_asks_for_fatigue():
    *_, (_, made, notes, _) = solved_throw(fillet_radius=None)
    assert "engine.throw.fatigue" not in {check.id for check in made}
    assert any("takes the radius of the fillets" in note for note in notes)


@pytest.mark.parametrize("safety, verdict", [(2.251, "pass"), (2.249, "not_verified"), (1.499, "warn")])
def test_a_notch_factor_outside_its_range_weakens_the_fatigue_by_half(safety, verdict):
    made = stretched(tuple(of_throw(fillets=(0.05, 0.301), safety=safety).values()))
    check = next(check for check in made if check.id == "engine.throw.fatigue")
    assert check.verdict == verdict and check.outside == ("engine.throw.fillet_journal",)
