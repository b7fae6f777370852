"""Life factors of ISO 6336-2 and -3: published points, knees, monotony."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.gears.rating import strength as life

KINDS = ("St", "V", "GTS", "GGG(perl.)", "GGG(ferr.)", "GG", "Eh", "IF", "NT(nitr.)", "NV(nitr.)", "NV(nitrocar.)")


@pytest.mark.parametrize("N_L, printed, digits", [(1.080e9, 0.910, 3), (1.783e8, 0.962, 3)])
def test_example_1_of_iso_tr_6336_30(N_L, printed, digits):
    """Reference values of the example as reprinted in the public code of gfsReboucas/Drivetrain: case-hardened, past
    the knee."""
    assert life.flank_life("Eh", N_L) == pytest.approx(printed, abs=0.5 * 10**-digits)


@pytest.mark.parametrize("N_L, printed", [(4.186e7, 1.0135), (4.5e7, 1.008), (9.0e7, 0.982)])
def test_values_of_another_program(N_L, printed):
    """KISSsoft reports as quoted in the public code of Mekanika, to the digits quoted."""
    digits = len(str(printed).partition(".")[2])
    assert life.flank_life("Eh", N_L) == pytest.approx(printed, abs=0.5 * 10**-digits)


# DIN 3990-11 (equations 4.05 to 4.10, 5.05, 5.06, in the public code of hanslhansl/din3990): exponent =
# factor·lg(static/endurance)
@pytest.mark.parametrize(
    "knees, i, static, factor",
    [
        (life.flank_knees("V"), 0, 1.6, 0.3705),
        (life.flank_knees("NT(nitr.)"), 0, 1.3, 0.7686),
        (life.flank_knees("NV(nitrocar.)"), 0, 1.1, 0.7686),
        (life.root_knees("V"), 0, 2.5, 0.4037),
        (life.root_knees("Eh"), 0, 2.5, 0.2876),
        (life.root_knees("NT(nitr.)"), 0, 1.6, 0.2876),
    ],
)
def test_exponents_of_din_3990(knees, i, static, factor):
    (N_1, Y_1), (N_2, Y_2) = knees[i : i + 2]
    assert Y_1 == static
    assert life.life_exponent(Y_1, Y_2, N_1, N_2) / math.log10(static) == pytest.approx(factor, abs=5e-5)


@pytest.mark.parametrize(
    "kind, knee, static, until",
    [("Eh", 5e7, 1.6, 1e5), ("V", 5e7, 1.6, 1e5), ("NT(nitr.)", 2e6, 1.3, 1e5), ("NV(nitrocar.)", 2e6, 1.1, 1e5)],
)
def test_knees_of_the_flank(kind, knee, static, until):
    assert life.flank_life(kind, knee) == life.flank_life(kind) == 1
    assert life.flank_life(kind, 1.0) == life.flank_life(kind, until) == static
    assert life.flank_life(kind, 1e10) == pytest.approx(0.85)


@pytest.mark.parametrize(
    "kind, static, until",
    [("Eh", 2.5, 1e3), ("IF", 2.5, 1e3), ("V", 2.5, 1e4), ("GG", 1.6, 1e3), ("NV(nitrocar.)", 1.1, 1e3)],
)
def test_knees_of_the_root(kind, static, until):
    assert life.root_life(kind, 3e6) == life.root_life(kind) == 1
    assert life.root_life(kind, 1.0) == life.root_life(kind, until) == static
    assert life.root_life(kind, 1e10) == pytest.approx(0.85)


# ISO 6336-2:2006, Table 2, and ISO 6336-3:2006, Table 1: cycles to the static factor, to 1, and to 0.85
@pytest.mark.parametrize(
    "factor, kinds, until, static, knee",
    [
        (life.flank_life, ("St", "V", "GTS", "GGG(perl.)", "Eh", "IF"), 1e5, 1.6, 5e7),
        (life.flank_life, ("GG", "GGG(ferr.)", "NT(nitr.)", "NV(nitr.)"), 1e5, 1.3, 2e6),
        (life.flank_life, ("NV(nitrocar.)",), 1e5, 1.1, 2e6),
        (life.root_life, ("St", "V", "GTS", "GGG(perl.)"), 1e4, 2.5, 3e6),
        (life.root_life, ("Eh", "IF"), 1e3, 2.5, 3e6),
        (life.root_life, ("GG", "GGG(ferr.)", "NT(nitr.)", "NV(nitr.)"), 1e3, 1.6, 3e6),
        (life.root_life, ("NV(nitrocar.)",), 1e3, 1.1, 3e6),
    ],
)
def test_a_life_curve_is_straight_between_its_knees(factor, kinds, until, static, knee):
    for kind in kinds:
        assert factor(kind, until) == static and factor(kind, knee) == 1
        assert factor(kind, math.sqrt(until * knee)) == pytest.approx(math.sqrt(static), rel=1e-12)
        assert factor(kind, math.sqrt(knee * 1e10)) == pytest.approx(math.sqrt(0.85), rel=1e-12)


@given(st.sampled_from(KINDS), st.floats(1, 1e12), st.floats(1, 1e12))
def test_more_cycles_never_strengthen(kind, a, b):
    few, many = sorted((a, b))
    assert life.flank_life(kind, few) >= life.flank_life(kind, many)
    assert life.root_life(kind, few) >= life.root_life(kind, many)


@given(st.sampled_from(KINDS), st.sampled_from([1e3, 1e4, 1e5, 6e5, 2e6, 3e6, 1e7, 5e7, 1e9, 1e10]))
def test_curves_do_not_jump(kind, N):
    for curve in (life.flank_life, life.root_life):
        assert curve(kind, N * (1 + 1e-9)) == pytest.approx(curve(kind, N * (1 - 1e-9)), rel=1e-8)


def test_cycles_of_a_life():
    """Example 1 of ISO/TR 6336-30: 360 rpm for 50 000 h are 1.080·10⁹ cycles."""
    assert life.load_cycles(n=-360 / 60, L_h=50_000 * 3600.0, c=1.0) == pytest.approx(1.080e9, rel=1e-12)


@pytest.mark.parametrize("driven, drives, contacts", [(0, 1, 1), (1, 0, 1), (1, 1, 1), (0, 2, 2), (1, 3, 3), (0, 0, 1)])
def test_contacts_in_a_turn(driven, drives, contacts):
    assert life.contacts_per_turn(driven, drives) == contacts
