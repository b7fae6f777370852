"""What of a design stands on the first page."""

from calc.design.key_results import judged, key_results
from calc.design.toml_file import load
from calc.solve import solve
from tests.conftest import DESIGNS


def test_a_pair_of_shafts_shows_what_it_leaves_of_the_second_order() -> None:
    shown = key_results(solve(load(DESIGNS / "r754ie4_balance_shafts.toml")[1]).values())
    assert shown["countershaft.residual_order_2_couple"].shown == 0
    assert 2000 < shown["countershaft.residual_order_2_force"].shown < 2200


def test_an_engine_shows_the_imbalance_that_it_has() -> None:
    four, three = (
        key_results(solve(load(DESIGNS / f"{name}.toml")[1]).values())
        for name in ("generating_set_mounting", "r753ie4_gamma")
    )
    assert {pattern for pattern in four if pattern.startswith("imbalance.")} == {"imbalance.order_2.force_peak"}
    assert {pattern for pattern in three if pattern.startswith("imbalance.")} == {
        "imbalance.required_couple",
        "imbalance.order_2.couple_peak",
        "imbalance.missing_forward_couple",
    }


def test_the_backlash_of_the_first_page_is_that_of_the_states_that_are_judged() -> None:
    shown = key_results(solve(load(DESIGNS / "r753ie4_gamma.toml")[1]).values())
    assert shown["gears.*.backlash_warmer"].id == "gears.central_idler.backlash_warmer"
    assert shown["gears.*.backlash_cold"].shown < 0 and "gears.*.backlash_min" not in shown


def test_what_holds_outside_the_validity_of_its_formula_is_not_called_a_pass() -> None:
    checks = solve(load(DESIGNS / "r753ie4_gamma.toml")[1]).outcomes["gears"].checks
    safety = next(check for check in checks if check.id == "gears.crank_central.safety_contact")
    assert (safety.verdict, judged(safety, checks), judged(safety, [safety])) == ("pass", "outside", "pass")
