"""What of a design stands on the first page."""

from calc.design_file import load
from calc.key_values import key_results
from calc.solve import solve
from tests.conftest import DESIGNS


def test_a_pair_of_shafts_shows_what_it_leaves_of_the_second_order() -> None:
    shown = key_results(solve(load(DESIGNS / "r754ie4_balance_shafts.toml")[1]).values())
    assert shown["countershaft.residual_order_2_couple"].shown == 0
    assert 2000 < shown["countershaft.residual_order_2_force"].shown < 2200
