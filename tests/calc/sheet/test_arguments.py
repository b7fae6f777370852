"""What a call from Python is given is held against the ranges of a design file."""

import numpy as np
import pytest

from calc import bearings, countershaft, engine, friction, gears, imbalance, load_design
from calc.sheet.errors import BadInput, NoSolution
from calc.sheet.record import replace
from tests.conftest import GAMMA

FILM = dict(
    diameter=0.0595, length=0.0275, clearance=80e-6, load=1707, speed=43.33, oil="SAE 50", supply_temperature=100
)
PAIR = dict(teeth=(32, 41), normal_module=2.25e-3, face_width=18e-3)
LOSS = dict(power=2000, speed=50, oil="SAE 50", temperature=90)


def refused(call, *given, **arguments):
    with pytest.raises(BadInput) as bad:
        call(*given, **arguments)
    return bad.value.errors


@pytest.mark.parametrize(
    "argument, value, words",
    [
        ("diameter", 59.5, "for 59.5 mm give 0.0595"),
        ("length", 27.5, "up to 1000 mm"),
        ("clearance", 80, "for 80 µm give 8e-05"),
        ("clearance", 0.08, "it is 80000 µm"),
        ("speed", 2600, "for 2600 rpm give 43.3333"),
        ("supply_temperature", 373.15, "for 373.15 K give 100"),
        ("supply_pressure", 3.0, "for 3 bar give 300000"),
        ("load", -1, "above 0"),
        ("load", float("nan"), "finite"),
        ("load", "much", "a number"),
        ("load_speed_ratio", 30, "from −10 to 10"),
        ("oil", "SAE 55", 'did you mean "SAE 50"?'),
        ("housing", "EN AC-4310", 'did you mean "EN AC-43100"?'),
    ],
)
def test_a_film_of_other_units_or_names_is_refused_in_words(argument, value, words):
    (error,) = refused(bearings.solve_film, **FILM | {argument: value})
    assert error.key == argument
    assert words in error.text("solve_film")
    assert error.text("solve_film").startswith(f"solve_film: {argument}: ")


def test_all_mistakes_are_told_at_once():
    errors = refused(bearings.solve_film, **FILM | dict(diameter=59.5, length=27.5, supply_temperature=373))
    assert [error.key for error in errors] == ["diameter", "length", "supply_temperature"]


def test_an_element_of_an_array_is_told_by_its_place():
    (error,) = refused(bearings.solve_film, **FILM | dict(clearance=np.array([70e-6, 80e-6, 90.0])))
    assert error.key == "clearance[2]"
    (error,) = refused(gears.solve_pair, **PAIR | dict(teeth=(32, 2)))
    assert error.key == "teeth[1]"


@pytest.mark.parametrize("pressure", [0.0, 2e4, 3e5, 2e6])
def test_what_a_file_may_have_is_taken(pressure):
    """Also without pressure, and far from usual."""
    assert bearings.solve_film(**FILM, supply_pressure=pressure).film > 0


def test_pairs_and_losses_are_held_to_theirs():
    (error,) = refused(gears.solve_pair, **PAIR | dict(normal_module=2.25))
    assert "for 2.25 mm give 0.00225" in error.text("")
    (error,) = refused(gears.solve_pair, **PAIR | dict(helix_angle=20))
    assert "for 20 ° give 0.349066" in error.text("")
    pair = gears.solve_pair(**PAIR)
    (error,) = refused(friction.solve_loss, pair, **LOSS | dict(temperature=363))
    assert error.key == "temperature" and "for 363 K give 89.85" in error.text("")


def test_sectors_are_held_to_theirs():
    room = dict(omega=272.3, rho=7860, R=0.043, r_0=0.018)
    (error,) = refused(countershaft.size_sectors, C=573, z_max=0.1475, **room | dict(R=43.0))
    assert error.key == "R" and "for 43 mm give 0.043" in error.text("")
    (error,) = refused(countershaft.size_sectors, C=573, z_max=147.5, **room)
    assert error.key == "z_max"
    where = countershaft.stretches(0.13, [(0, 0.036)])
    (error,) = refused(countershaft.size_stretches, U=0, P=0.0025, where=where, **room | dict(rho=7.86))
    assert error.key == "rho"


@pytest.mark.parametrize("call", [engine.solve_engine, imbalance.solve_imbalance])
def test_engines_are_held_to_theirs(call):
    one = load_design(GAMMA).engine
    assert one is not None
    (error,) = refused(call, replace(one, bore=94.0))
    assert error.key == "bore" and "for 94 mm give 0.094" in error.text("")
    (error,) = refused(call, one, piston_mass=np.array([0.5, 500.0]))
    assert error.key == "piston_mass[1]"
    (error,) = refused(call, one, piston_mas=0.5)
    assert error.key == "piston_mas" and 'did you mean "piston_mass"?' in error.text("")
    (error,) = refused(call, replace(one, layout="inlin"))
    assert error.key == "layout" and '"inline"' in error.text("")
    (error,) = refused(call, replace(one, piston_mass=None))  # sound by itself, and not together with the rest
    assert error.key == "piston_mass" and "missing" in error.text("")


def test_a_crank_that_is_no_share_is_refused():
    one = load_design(GAMMA).engine
    assert {error.key for error in refused(imbalance.solve_imbalance, one, 50.0, kinematics="precise")} == {
        "crank_balance_fraction",
        "kinematics",
    }


# --- arrays
@pytest.mark.parametrize("warm", [True, False])
@pytest.mark.parametrize(
    "varied",
    [
        dict(clearance=np.linspace(40e-6, 400e-6, 4)),
        dict(diameter=np.array([0.05, 0.0595]), length=np.array([0.02, 0.0275])),
        dict(load=np.array([1e2, 1707.0, 1e6])),
        dict(speed=np.array([10.0, 43.33]), supply_temperature=np.array([80.0, 100.0])),
        dict(supply_pressure=np.array([0.0, 3e5]), load_speed_ratio=0.0),
    ],
    ids=lambda given: "_".join(given) if isinstance(given, dict) else None,
)
def test_films_of_arrays_are_those_of_their_elements(varied, warm):
    known = FILM | dict(housing="EN AC-43100", warm=warm)
    many = bearings.solve_film(**known | varied)
    for n, film in enumerate(many.film):
        alone = {name: x[n] if np.ndim(x) else x for name, x in varied.items()}
        if np.isnan(film):
            with pytest.raises(NoSolution):
                bearings.solve_film(**known | alone)
        else:
            one = bearings.solve_film(**known | alone)
            assert film == pytest.approx(one.film, rel=1e-9)
            assert many.friction_power[n] == pytest.approx(one.friction_power, rel=1e-9)


def test_arrays_are_broadcast():
    film = bearings.solve_film(**FILM | dict(load=np.array([[1000.0], [1707.0]]), speed=np.array([20.0, 30.0, 40.0])))
    assert film.film.shape == film.attitude.shape == film.oil.mu.shape == (2, 3)


@pytest.mark.parametrize("call", [engine.solve_engine, imbalance.solve_imbalance])
def test_engines_of_arrays_are_those_of_their_elements(call):
    one, masses = load_design(GAMMA).engine, np.linspace(0.3, 0.6, 3)
    many = call(one, piston_mass=masses)
    for n, mass in enumerate(masses.tolist()):
        for of_many, alone in zip(numbers(many), numbers(call(one, piston_mass=mass)), strict=True):
            assert np.broadcast_to(of_many, masses.shape)[n] == pytest.approx(alone, rel=1e-12)


def numbers(result):
    if hasattr(result, "orders"):
        return [getattr(order, name) for order in result.orders.values() for name in ("couple_peak", "force_peak")]
    return [result.reciprocating_mass, result.acceleration_max, result.mean_piston_speed]


SIZES = {"b": 0.16, "R": 0.022, "r_0": 0.008, "omega": 1257.0, "rho": 24.0}
SECTORS = {"C": 573.0, "omega": 272.3, "rho": 7860.0, "R": 0.043, "r_0": 0.018, "z_max": 0.1475}
NOTHING_LEFT = countershaft.OrderVectors(0, 0, 0, 573)


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: friction.mass_loss(**SIZES | {"R": 22.0}), "R: 22: must be .*for 22 mm give 0.022"),
        (lambda: friction.mass_loss(**SIZES | {"rho": "oil"}), "rho: .*must be"),
        (lambda: friction.mass_loss(**SIZES | {"omega": np.inf}), "omega: inf: must be a finite number"),
        (lambda: friction.mass_loss(**SIZES | {"b": np.ones((2, 2))}), "b: .*an array as long as the others"),
        (lambda: countershaft.size_sectors(**SECTORS | {"C": "x"}), "C: .*must be a finite number"),
        (lambda: countershaft.size_sectors(**SECTORS | {"C": np.array([1.0, 2.0])}), "C: .*must be a finite number"),
        (lambda: countershaft.size_sectors(**SECTORS | {"R": 10**400}), "R: .*must be"),
        (lambda: countershaft.size_sectors(**SECTORS | {"R": np.array([1, 2], dtype=object)}), "R: .*must be"),
        (lambda: countershaft.size_sectors(**SECTORS | {"R": np.ones(2)}), "R: .*must be a finite number"),
        (lambda: countershaft.stretches(0.13, [(0.0, None), (np.nan, 0.1)]), r"gaps\[1\].z: nan: must be"),
        (lambda: countershaft.together({1: NOTHING_LEFT}, [countershaft.SystemShaft("a", 2, 0, 1)]), r"shafts\[0\].ratio"),
        (lambda: countershaft.together({3: NOTHING_LEFT}, [countershaft.SystemShaft("a", 3, 0, 1)]), "must be ±1 or ±2"),
        (lambda: friction.solve_loss(gears.solve_pair(**PAIR), **LOSS | {"power": np.ones(2), "speed": np.ones(3)}), "power: .*an array as long as the others"),
        (lambda: bearings.solve_film(**FILM | {"load": np.ones(2), "speed": np.ones(3)}), "speed: .*as long as the others"),
        (lambda: countershaft.size_stretches(0, 0.002, 272, 7860, 0.034, 0.012, [("x", 0.1)]), r"where\[0\]"),
        (lambda: friction.solve_loss(gears.solve_pair(**PAIR), **LOSS | {"oil": 3.0}), "oil: 3.0"),
    ],
)  # fmt: skip
def test_what_a_second_attack_found(call, words):
    with pytest.raises(BadInput, match=words):
        call()
