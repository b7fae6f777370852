"""Film and flash temperature: limits, symmetries, where the methods end, what is said."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.gears.rating.checks import MARGIN
from calc.gears.rating.checks import screening_checks as checks
from calc.gears.rating.curves import screening_curves as curves
from calc.gears.rating.notes import screening_notes
from calc.gears.rating.screening import load, scuffing
from calc.gears.rating.screening.path import Path
from calc.gears.rating.screening.scuffing import screening
from calc.gears.solve import geometry
from calc.library.catalogue import materials, oils
from calc.library.lubricant import Lubricant
from calc.sheet.errors import NoSolution
from calc.sheet.value import link_of, trace
from tests.calc.gears.trains import SPEED, mesh, r753, solved, train, wheel

OIL = oils()["10W-40 Q8 T905"]
BATH = load.oil_bath(Lubricant(OIL), 90.0)
STEEL = materials()


def notes(system, screened, base):
    return tuple(screening_notes(system, screened, base))


def spur(z_1=24, z_2=36, beta=0.0, x=(0.2, 0.1), b=15.0, **said):
    """A pair whose tool is that of ISO 53 A; ε_α below 2."""
    return train(
        [wheel("a", z_1, x[0]), wheel("b", z_2, x[1])],
        [mesh("a", "b")],
        m_n=3.0,
        beta=beta,
        b=b,
        tool=(1.25, 0.38),
        ball=None,
        **said,
    )


def screened(gears, key="a_b", speed=None, **said):
    t = solved(gears) if speed is None else geometry(gears, speed).result
    m = t.meshes[key]
    asked = dict(
        F_t=2000.0,
        oil=BATH,
        materials=STEEL,
        roughness=(0.6e-6, 0.6e-6),
        load_factor=1.5,
        application_factor=1.0,
        accuracy_grade=7,
        mates=1,
        load_stage=None,
        structural_factor=1.0,
        mesh_stiffness=20e9,
        permissible_film=None,
    )
    asked |= said
    return screening(t.system, m, t.wheels[m.driver], t.wheels[m.driven], **asked)


def path_of(gears, key="a_b", grade=7):
    t = solved(gears)
    m = t.meshes[key]
    return Path(t.system, m, t.wheels[m.driver], t.wheels[m.driven], grade)


def flash_at(p, rho, mu=0.06, w_t=150e3, b_M=13756.0**2, E_r=226e9):
    at = p.at(rho)
    w = at.X * w_t
    b_H = scuffing.half_width(w, at.rho_n, E_r)
    return scuffing.flash_temperature(mu, 1.0, w, at.v_1, at.v_2, b_M, b_M, b_H)


# --- limits and symmetries
@pytest.mark.parametrize("gears, key", [(spur(), "a_b"), (r753(), "central_idler")])
def test_no_flash_at_the_pitch_point(gears, key):
    """There the flanks roll: ζ = 0."""
    p = path_of(gears, key)
    assert flash_at(p, p.C) == pytest.approx(0.0, abs=1e-9)
    found = screened(gears, key)
    assert np.interp(0.0, found.way, found.flash) < 0.03 * found.flash_temperature_max


@pytest.mark.parametrize("n", [50.0, -50.0])
def test_the_power_that_is_sent_through_is_torque_times_angular_velocity(n):
    assert load.transmitted_power(F_t=2000.0, d=0.072, n=n) == pytest.approx(2000.0 * 0.036 * 2 * math.pi * 50)


def test_double_load_is_flash_times_two_to_the_three_quarters():
    p = path_of(spur())
    assert flash_at(p, p.E, w_t=300e3) / flash_at(p, p.E, w_t=150e3) == pytest.approx(2**0.75)


def test_load_speed_and_roughness_act_as_they_should():
    """With friction: flash ∝ F^0.95 without tip shock (∝ n^0.5·n^-0.2); roughness ∝ Ra^0.25; film falls by each of load
    and roughness."""
    once, twice = screened(spur(), mesh_stiffness=1e25), screened(spur(), F_t=4000.0, mesh_stiffness=1e25)
    fast, rough = (
        screened(spur(), speed=2 * SPEED, mesh_stiffness=1e25),
        screened(spur(), roughness=(1.2e-6, 1.2e-6), mesh_stiffness=1e25),
    )
    flash = once.flash_temperature_max
    assert twice.flash_temperature_max / flash == pytest.approx(2**0.95)
    assert fast.flash_temperature_max / flash == pytest.approx(2**0.3)
    assert rough.flash_temperature_max / flash == pytest.approx(2**0.25)
    assert twice.specific_film_min < once.specific_film_min < fast.specific_film_min
    assert rough.specific_film_min < once.specific_film_min / 2


def test_hotter_oil_makes_a_thinner_film_and_less_margin():
    cool, hot = screened(spur()), screened(spur(), oil=load.oil_bath(Lubricant(OIL), 120.0))
    assert hot.specific_film_min < cool.specific_film_min
    assert hot.scuffing_margin < cool.scuffing_margin


def test_swapped_wheels_mirror():
    """The other wheel drives, at the speed that keeps the mesh: film and flash run backwards; without the shock of the
    approach."""
    there = spur(beta=15.0)
    back = replace(there, wheels=there.wheels[::-1], meshes=(mesh("b", "a"),))
    one = screened(there, mesh_stiffness=1e25)
    two = screened(back, "b_a", speed=SPEED * 24 / 36, mesh_stiffness=1e25)
    assert two.flash_temperature_max == pytest.approx(one.flash_temperature_max)
    assert two.specific_film_min == pytest.approx(one.specific_film_min)
    assert (one.film_place, two.film_place) in {
        ("A", "E"),
        ("E", "A"),
        ("B", "D"),
        ("D", "B"),
        ("C", "C"),
        ("AB", "DE"),
        ("DE", "AB"),
    }
    assert list(two.flash[::-1]) == pytest.approx(list(one.flash), abs=1e-9)
    assert list(two.specific_film[::-1]) == pytest.approx(list(one.specific_film))
    for name in ("friction_film", "friction_flash", "bulk_temperature_film", "bulk_temperature_flash"):
        assert getattr(two, name) == pytest.approx(getattr(one, name))


def test_the_shock_of_the_approach_is_before_the_pitch_point():
    soft, stiff = screened(spur(), mesh_stiffness=5e9), screened(spur(), mesh_stiffness=1e25)
    ratio = soft.flash[np.abs(soft.way) > 1e-5] / stiff.flash[np.abs(soft.way) > 1e-5]
    way = soft.way[np.abs(soft.way) > 1e-5]
    assert np.all(ratio[way > 0] == pytest.approx(1.0))
    assert ratio[0] > 1.01
    assert np.all(np.diff(ratio[way < 0]) <= 1e-12)


def test_a_small_change_makes_a_small_change():
    """Temperature is continuous in place within each part of the path, and in the load."""
    p = path_of(spur())
    for a, b in ((p.A, p.B * (1 - 1e-12)), (p.B, p.D), (p.D * (1 + 1e-12), p.E)):
        along = np.array([flash_at(p, float(rho)) for rho in np.linspace(a, b, 400)])
        assert np.max(np.abs(np.diff(along))) < 0.02 * np.max(along)
    assert screened(spur(), F_t=2000.002).contact_temperature_max == pytest.approx(
        screened(spur()).contact_temperature_max, abs=1e-4
    )


def test_mean_flash_is_an_integral():
    """Halving the steps changes little, and a straight line has its middle as mean, jumps and all."""
    assert scuffing.mean_flash_temperature([0.0, 1.0, 1.0, 2.0], [0.0, 1.0, 1.0, 2.0]) == pytest.approx(1.0)
    found, p = screened(spur()), path_of(spur())
    fine = np.array([flash_at(p, float(rho)) for rho in np.linspace(p.A, p.E, 4001)])
    coarse = np.array([flash_at(p, float(rho)) for rho in p.samples()])
    assert scuffing.mean_flash_temperature(coarse, p.samples()) == pytest.approx(fine.mean(), rel=5e-3)
    assert len(found.flash) == len(p.samples())


def test_what_is_given_out_is_the_extreme_of_the_curves():
    t = solved(r753())
    for key in ("crank_central", "central_idler", "idler_shaft"):
        found = screened(r753(), key, F_t=184.0)
        assert found.flash_temperature_max == pytest.approx(np.max(found.flash))
        assert found.contact_temperature_max == found.bulk_temperature_flash + found.flash_temperature_max
        assert found.specific_film_min * 0.6e-6 == pytest.approx(found.film_min)
        # at the points A … E only: between them the film of a helical pair can be a little thinner
        for curve in curves(key, found):  # over the whole path of contact, in mm
            x = curve.series[0].x
            assert x[-1] - x[0] == pytest.approx(t.meshes[key].transverse_contact_ratio * t.system.base_pitch * 1e3)
        assert 0.97 * found.specific_film_min < np.min(found.specific_film) <= found.specific_film_min * (1 + 1e-9)


def test_an_idler_is_heated_by_both_mates():
    one, two = screened(r753(), "central_idler"), screened(r753(), "central_idler", mates=2)
    assert (two.bulk_temperature_flash - 90) / (one.bulk_temperature_flash - 90) == pytest.approx(1.5)


@settings(max_examples=40, deadline=None)
@given(
    F_t=st.floats(1.0, 2e5),
    b=st.floats(5.0, 80.0),
    beta=st.floats(0.0, 30.0),
    z=st.tuples(st.integers(18, 60), st.integers(18, 60)),
    T=st.floats(20.0, 140.0),
    Ra=st.floats(0.05e-6, 3e-6),
)
def test_always_numbers(F_t, b, beta, z, T, Ra):
    found = screened(spur(*z, beta=beta, b=b), F_t=F_t, oil=load.oil_bath(Lubricant(OIL), T), roughness=(Ra, Ra))
    numbers = [found.flash_temperature_max, found.contact_temperature_max, found.scuffing_safety, found.scuffing_margin]
    assert all(math.isfinite(x) for x in numbers)
    assert found.contact_temperature_max > found.bulk_temperature_flash > T
    assert found.specific_film_min is None or (
        0 < found.specific_film_min < 1000 and np.all(np.isfinite(found.specific_film))
    )


# --- the ends of the methods, and what is said
@pytest.mark.parametrize("wrong", [{"F_t": 0.0}, {"roughness": (0.6e-6, 0.0)}, {"F_t": float("nan")}])
def test_nothing_to_screen(wrong):
    with pytest.raises(NoSolution, match="a–b"):
        screened(spur(), **wrong)


def test_a_contact_too_hot_for_the_oil_has_no_film():
    found = screened(spur(), F_t=5e5)
    assert found.specific_film_min is found.film_min is found.specific_film is None
    assert [c.id for c in checks("a_b", found)] == ["gears.a_b.scuffing"]
    assert [c.id for c in curves("a_b", found)] == ["contact_temperature_a_b"]
    assert any("500 °C" in note for note in notes(solved(spur()).system, [found], "mineral"))


def test_a_screening_fails_nothing():
    good = screened(spur(), F_t=200.0, roughness=(0.1e-6, 0.1e-6), load_stage=12)
    bad = screened(spur(), F_t=8000.0, load_stage=5, permissible_film=0.5)
    for found, verdicts in ((good, ("pass", "pass")), (bad, ("note", "warn"))):
        film, heat = checks("a_b", found)
        assert (film.kind, heat.kind) == ("advice", "caution")
        assert (film.verdict, heat.verdict) == verdicts
        assert film.limit == found.permissible_film and heat.limit == MARGIN
    _, heat = checks("a_b", bad)
    assert "rule of this program" not in heat.source
    _, heat = checks("a_b", screened(spur()))
    assert "assumed" in heat.source


def test_light_load_is_said():
    t = solved(r753())
    light = [screened(r753(), key, F_t=184.0, load_factor=1.0) for key in t.meshes]
    said = notes(t.system, light, "ester")
    assert "far below those of the tests" in said[0] and "12.3 N/mm" in said[0]
    assert any("ester" in note for note in said)
    heavy = notes(
        t.system, [screened(r753(), "central_idler", F_t=6000.0, load_stage=10, permissible_film=0.3)], "mineral"
    )
    assert len(heavy) == 1 and "far below" not in heavy[0]
    for line_load, far in ((99e3, True), (101e3, False)):
        assert ("far below" in notes(t.system, [replace(light[0], line_load=line_load)], "mineral")[0]) == far


def test_a_thin_film_at_low_pressure_is_put_in_its_place():
    film, _ = checks("central_idler", screened(r753(), "central_idler", F_t=184.0))
    assert "need not harm" in film.advice
    film, _ = checks("a_b", screened(spur(), F_t=8000.0))
    assert "Have the oil tested" in film.advice


MANY = train(
    [wheel("a", 80, 0.0), wheel("b", 90, 0.0)],
    [mesh("a", "b")],
    m_n=2.0,
    alpha_n=15.0,
    beta=0.0,
    tool=(1.25, 0.2),
    ball=None,
)


def test_many_teeth_in_contact_are_said():
    """ε_α of 2 and more without a helix: one pair is taken to carry all."""
    assert solved(MANY).meshes["a_b"].transverse_contact_ratio > 2
    found = screened(MANY)
    assert not found.method_applies
    assert any("one pair" in note for note in notes(solved(MANY).system, [found], "mineral"))


def test_lines_are_those_of_the_governing_points():
    with trace() as lines:
        found = screened(spur())
    for number, symbol in ((found.specific_film_min, "λ_GF"), (found.scuffing_safety, "S_B")):
        line = link_of(number)
        assert line in lines and (line.formula.symbol, line.value) == (symbol, number)
    assert not any(isinstance(line.value, np.generic | np.ndarray) for line in lines)
    assert len(lines) < 80
