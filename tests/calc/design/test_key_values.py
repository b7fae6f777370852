"""What of a design stands on the first page."""

from calc.design.key_results import judged, key_results
from calc.design.toml_file import load
from calc.sheet.quantity import Published
from calc.sheet.record import replace
from calc.solve import solve
from tests.conftest import DESIGNS


def first_page(name: str) -> dict[str, Published]:
    return {v.id: v for v in key_results(solve(load(DESIGNS / f"{name}.toml")[1]).values()).values()}


def test_a_pair_of_shafts_shows_what_it_leaves_of_the_second_order() -> None:
    shown = first_page("r754ie4_balance_shafts")
    assert 2000 < shown["countershaft.residual_order_2_force"].shown < 2200
    assert 800 < shown["countershaft.roll_left_order_2"].shown < 900  # at equal heights that of the inertia
    assert shown["gears.right.residual_force"].shown > 0  # by the phase error
    assert not any("couple" in id for id in shown)  # nought: these shafts have none


def test_an_engine_shows_the_imbalance_that_it_has() -> None:
    four, three = (first_page(name) for name in ("generating_set_mounting", "r753ie4_gamma"))
    assert [id for id in four if id.startswith("imbalance.")] == ["imbalance.order_2.force_peak"]
    assert [id for id in three if id.startswith("imbalance.")] == [
        "imbalance.required_couple",
        "imbalance.order_2.couple_peak",
        "imbalance.missing_forward_couple",
    ]
    assert "gears.residual_couple" in three and "gears.residual_force" not in three


def test_the_backlash_of_the_first_page_is_that_of_the_states_that_are_judged() -> None:
    shown = first_page("r753ie4_gamma")
    assert "gears.central_idler.backlash_warmer" in shown and not any(id.endswith("backlash_min") for id in shown)
    assert [v.shown < 0 for id, v in shown.items() if id.endswith("backlash_cold")] == [True]


def test_each_bearing_has_a_line_of_its_film_and_both_one_of_their_temperature() -> None:
    shown = [id for id in first_page("r753ie4_gamma") if id.startswith("bearings.")]
    assert shown[:2] == ["bearings.front.film_edge", "bearings.rear.film_edge"] and len(shown) == 3


def test_what_holds_outside_the_validity_of_its_formula_is_not_called_a_pass() -> None:
    checks = solve(load(DESIGNS / "r753ie4_gamma.toml")[1]).outcomes["gears"].checks
    safety = next(check for check in checks if check.id == "gears.crank_central.safety_contact")
    assert (safety.verdict, judged(safety)) == ("pass", "outside")
    assert judged(replace(safety, outside=())) == "pass"
