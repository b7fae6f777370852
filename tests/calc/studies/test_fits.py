# SPDX-License-Identifier: Apache-2.0
"""Fits of designs: from files to numbers, with the truth known."""

import numpy as np
import pytest

from calc.design.toml_file import read
from calc.measurements.fit_words import sentence
from calc.sheet.errors import BadInput, Cancelled
from calc.solve import solve
from calc.studies.fits import _Fitting, _named, fit_of
from tests.conftest import DESIGNS
from tests.engine_run import L_ROW, R_ROW, RADIUS, ROD, TRUTH, engine_run, fits


def fit(path, name="engine", **how):
    return fit_of(read(path), name, **how)


@pytest.fixture(scope="module")
def noisy(tmp_path_factory):
    return fit(engine_run(tmp_path_factory.mktemp("engine"), fits(R_ROW, L_ROW), noise=1))


def test_the_truth_is_found(tmp_path):
    found = fit(engine_run(tmp_path, fits(R_ROW, L_ROW)))
    assert found.result.verdict == "identified"
    assert found.result.values == pytest.approx([TRUTH[RADIUS], TRUTH[ROD]], rel=1e-6)
    assert found.rows == {
        "measured.mean-piston-speed.mean-piston-speed": 3,
        "measured.acceleration-max.acceleration-max": 3,
    }
    assert found.result.degrees_of_freedom == 4 and not found.left_out and found.replaced == ()


def test_the_truth_lies_within_four_standard_deviations(noisy):
    assert (np.abs(noisy.result.values - [TRUTH[RADIUS], TRUTH[ROD]]) < 4 * noisy.result.sd).all()


@pytest.mark.slow
def test_the_limits_hold_the_truth_of_designs_too(tmp_path):
    held = 0
    chance = np.random.default_rng(753)
    for seed in range(40):
        truth = {RADIUS: chance.uniform(45, 55), ROD: chance.uniform(150, 200)}
        found = fit(engine_run(tmp_path, fits(R_ROW, L_ROW), noise=seed, truth=truth)).result
        assert found.verdict == "identified"
        held += sum(low <= x <= high for (low, high), x in zip(found.limits, truth.values()))
    assert held >= 80 * 0.95 - 3 * (80 * 0.95 * 0.05) ** 0.5 - 1


def test_acceleration_alone_tells_radius_and_rod_not_apart(tmp_path):
    found = fit(engine_run(tmp_path, fits(R_ROW, L_ROW), {"acceleration_max": 8.0}))
    assert found.result.verdict == "not identifiable" and found.result.width > 100
    words = sentence(found.result, found.names)
    assert "No values are given" in words and ("alone" in words or "in the proportion" in words)
    assert not any(id.endswith((".sd", RADIUS, ROD)) for id in found.values())
    assert found.check().verdict == "note" and "not identifiable" in found.check().name


def test_a_prior_makes_it_identifiable(tmp_path):
    rows = R_ROW, f"{L_ROW}, prior = 170, prior_sd = 4"
    found = fit(engine_run(tmp_path, fits(*rows), {"acceleration_max": 8.0})).result
    assert found.verdict == "identified" and found.sd[1] == pytest.approx(4, rel=1e-3)
    assert found.degrees_of_freedom == 3 + 1 - 2


def test_at_a_bound_the_value_is_shown_and_no_more(tmp_path):
    found = fit(engine_run(tmp_path, fits(f'key = "{RADIUS}", low = 53, high = 60'), {"mean_piston_speed": 0.1}))
    assert found.result.verdict == "at its bound"
    values = found.values()
    assert values[f"fit.engine.{RADIUS}"].shown == pytest.approx(53) and f"fit.engine.{RADIUS}.sd" not in values
    assert "ended at 53 mm" in sentence(found.result, found.names)


def test_without_uncertainties_the_rows_say_their_scatter(tmp_path):
    row = fits(f"{R_ROW}", of='of = ["mean-piston-speed"]\n')
    found = fit(engine_run(tmp_path, row, noise=5, known=False))
    values = found.values()
    residual = values["fit.engine.residual_sd"]
    assert residual.unit == "m/s" and 0.002 < residual.shown < 0.06 and "fit.engine.chi2_reduced" not in values


def test_its_values_and_its_check(noisy):
    found, values = noisy, noisy.values()
    ids = [f"fit.engine.{RADIUS}", f"fit.engine.{RADIUS}.sd", f"fit.engine.{ROD}", f"fit.engine.{ROD}.sd"]
    assert list(values) == [*ids, "fit.engine.chi2_reduced", "fit.engine.width", "fit.engine.correlation"]
    assert values[ids[0]].unit == "mm" and values[ids[0]].shown == found.result.values[0]
    assert -1 < values["fit.engine.correlation"].shown < 1
    check = found.check()
    assert (check.id, check.kind, check.verdict) == ("fit.engine", "method", "pass")
    assert check.value == pytest.approx(found.result.width) and check.limit == 0.25


@pytest.mark.parametrize(
    ("rows", "known", "values", "reason"),
    [
        ((R_ROW, f"{L_ROW}, prior = 170, prior_sd = 4"), False, {"mean_piston_speed": 0.02}, "a prior has no weight"),
        ((R_ROW, L_ROW), False, {"mean_piston_speed": 0.02, "acceleration_max": 8.0}, "unlike units"),
    ],
)
def test_weights_that_are_not_known_are_refused(tmp_path, rows, known, values, reason):
    with pytest.raises(BadInput, match=reason):
        fit(engine_run(tmp_path, fits(*rows), values, known=known))


def test_columns_with_and_without_uncertainty_stand_in_no_fit_together(tmp_path):
    path = engine_run(tmp_path, fits(R_ROW, L_ROW))
    path.write_text(path.read_text().replace(", uncertainty = 8.0", ""))
    with pytest.raises(BadInput, match="with and without uncertainty"):
        fit(path)


def test_no_more_rows_than_inputs_are_refused_with_their_line(tmp_path):
    path = engine_run(tmp_path, fits(R_ROW, L_ROW, of='of = ["mean-piston-speed"]\n'))
    (tmp_path / "mean-piston-speed.csv").write_text("n,x\n1000,3.5\n2000,7.0\n")
    with pytest.raises(BadInput, match="has 2 rows, those of priors among them, for 2 free inputs") as bad:
        fit(path)
    (error,) = bad.value.errors
    assert path.read_text().splitlines()[error.line - 1].startswith("free = ")


def test_no_such_fit(tmp_path):
    with pytest.raises(BadInput, match="there are engine"):
        fit(engine_run(tmp_path, fits(R_ROW)), "drag")
    with pytest.raises(BadInput, match=r"add \[\[fits\]\]"):
        fit(engine_run(tmp_path, ""), "drag")


def test_a_range_that_the_design_can_not_have(tmp_path):
    """A rod as short as the crank's radius is no engine."""
    with pytest.raises(BadInput, match="rod_length_mm") as bad:
        fit(engine_run(tmp_path, fits(f'key = "{ROD}", low = 30, high = 200')))
    assert bad.value.errors[0].key == "fits.0.free.0.low"


def test_it_begins_where_the_design_stands(tmp_path):
    said = []
    fit(engine_run(tmp_path, fits(R_ROW)), progress=lambda share, what: said.append((share, what)))
    assert "53.5 mm" in said[0][1]
    shares = [share for share, _ in said]
    assert shares == sorted(shares) and shares[-1] < 1
    said.clear()
    fit(engine_run(tmp_path, fits(f"{R_ROW}, start = 41")), progress=lambda _, what: said.append(what))
    assert "41 mm" in said[0]


def test_who_does_not_wait_ends_it(tmp_path):
    def tired(share: float, what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        fit(engine_run(tmp_path, fits(R_ROW)), progress=tired)


def test_a_factor_goes_where_the_clearance_is_fitted(tmp_path):
    """What stands in the place of a free input is taken out, and the search begins at what it comes to."""
    text = (DESIGNS / "r753ie4_gamma.toml").read_text()
    key = "shafts.shaft.bearings.front.clearance_um"
    text += RUN_OF_DRAG + f'\n[[fits]]\nname = "drag"\nfree = [{{ key = "{key}", low = 50, high = 140 }}]\n'
    (tmp_path / "design.toml").write_text(text)
    (tmp_path / "drag.csv").write_text("n,P\n900,22\n1500,70\n")
    row, place, base = _named(document := read(tmp_path / "design.toml"), "drag")
    fitting = _Fitting(document, base, row, place, results := solve(base))
    assert fitting.replaced == ("shafts.shaft.bearings.front.clearance_factor",)
    assert fitting.free[0].start == results.values()["bearings.front.clearance"].shown
    bearing = fitting.changed([88.0]).shafts[0].bearings[0]
    assert bearing.clearance == pytest.approx(88e-6) and bearing.clearance_factor is None


RUN_OF_DRAG = """
[[measurements]]
name = "drag-run"
file = "drag.csv"
speed = "n"
columns = [{ column = "P", value = "friction.bearing_loss", unit = "W", uncertainty = 2 }]
"""


@pytest.mark.slow
@pytest.mark.parametrize("name", ["drag-alone", "drag"])
def test_drag_alone_says_nothing_of_two_clearances_and_with_the_oil_flow_both_are_found(name):
    """The shipped run is made with 95 and 75 µm: `python -m bench.measured_run`."""
    found = fit(DESIGNS / "r753ie4_measured.toml", name)
    if name == "drag-alone":
        assert found.result.verdict == "not identifiable" and found.result.correlation < -0.999
        return
    assert found.result.verdict == "identified" and not found.result.scaled
    for truth, (low, high) in zip((95.0, 75.0), found.result.limits):
        assert low < truth < high
    assert [key.rpartition(".")[2] for key in found.replaced] == ["clearance_factor"] * 2


@pytest.mark.slow
@pytest.mark.parametrize(
    ("value", "early"), [("friction.bearing_loss", True), ("gears.idler_shaft.safety_contact", False)]
)
def test_a_solve_ends_early_only_where_nothing_later_is_wanted(tmp_path, value, early):
    run = RUN_OF_DRAG.replace("friction.bearing_loss", value).replace(', unit = "W"', "")
    key = "shafts.shaft.bearings.front.clearance_um"
    row = f'\n[[fits]]\nname = "drag"\nfree = [{{ key = "{key}", low = 50, high = 140 }}]\n'
    (tmp_path / "design.toml").write_text((DESIGNS / "r753ie4_gamma.toml").read_text() + run + row)
    (tmp_path / "drag.csv").write_text("n,P\n900,2\n1500,7\n")
    asked, place, base = _named(document := read(tmp_path / "design.toml"), "drag")
    fitting = _Fitting(document, base, asked, place, solve(base))
    wanted, _ = fitting._wanted()
    assert fitting._same_early([80.0], wanted) is early
