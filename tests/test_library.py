"""The program as a library: what the table of docs/python.md says of it, and what its packages offer."""

import re
from importlib import import_module

import numpy as np
import pytest

import calc
from calc.sheet.arguments import given_inputs
from calc.sheet.record import replace
from tests.conftest import ROOT, SHIPPED
from tests.test_imports import loaded

SECTION = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```python\n(.*?)^```$", SECTION, flags=re.MULTILINE | re.DOTALL)
ROWS = re.findall(r"^\| `(.+?)` \| .+? \| (\S*).*\|$", SECTION, flags=re.MULTILINE)
STEPS = ("engine", "imbalance", "countershaft", "bearings", "gears", "friction")
PACKAGES = ("calc", *(f"calc.{name}" for name in (*STEPS, "mounting", "library")), "reports")


@pytest.fixture(scope="module")
def names():
    known: dict[str, object] = {}
    exec(BLOCKS[0], known)
    return known


@pytest.mark.parametrize("call, number", ROWS, ids=[row[0].split("(")[0] for row in ROWS])
def test_a_row_of_the_page_runs(names, call, number):
    got = eval(call, names)
    assert str(got)
    if number:
        assert float(got) == pytest.approx(float(number), rel=6e-4)


def test_every_step_has_rows():
    assert len(ROWS) >= 13
    assert all(any(call.startswith(f"{step}.") for call, _ in ROWS) for step in STEPS if step != "gears")


def test_the_arrays_of_the_readme_run(names):
    (block,) = [block for block in BLOCKS if "masses" in block]
    lines = block.strip().splitlines()
    exec("\n".join(lines[:-2]), names)
    couples, losses = (eval(line, names) for line in lines[-2:])
    assert np.shape(couples) == np.shape(losses) == (10_000,)


@pytest.mark.parametrize("name", PACKAGES)
def test_a_package_offers_what_it_lists(name):
    package = import_module(name)
    assert package.__all__ == sorted(package.__all__) == dir(package)
    for offered in package.__all__:
        assert getattr(package, offered).__doc__, offered
    assert dir(package) == package.__all__  # also when its modules are loaded


def test_an_unknown_name_is_no_attribute():
    with pytest.raises(AttributeError, match="has no attribute 'solve_flim'"):
        calc.bearings.solve_flim  # noqa: B018
    with pytest.raises(ImportError):
        from calc import solve_desing  # noqa: F401


def test_what_is_not_loaded_yet_is_there():
    assert "calc.gears.formulas" in loaded("import calc; calc.gears.tip_diameter")


def test_the_steps_of_results_have_types_of_their_own(gamma_results):
    for step in (*STEPS, "mounting"):
        assert getattr(gamma_results, step) is gamma_results.outcomes[step]


def test_of_several_shafts_one_is_asked_for():
    both = calc.solve_design(calc.load_design(ROOT / "designs" / "r754ie4_balance_shafts.toml"))
    with pytest.raises(LookupError, match=r"several shafts .*view\('(.+)'\).bearings"):
        both.bearings  # noqa: B018
    name = next(iter(both.views))
    assert both.view(name).bearings.solution.bearings


def test_a_design_that_was_changed_is_held_to_the_ranges_of_its_file(gamma_results):
    one = gamma_results.design
    with pytest.raises(calc.BadInput, match=r"solve_design: engine.bore: 94: .* for 94 mm give 0.094"):
        calc.solve_design(replace(one, engine=replace(one.engine, bore=94.0)))


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_no_shipped_design_is_refused(path):
    design = calc.load_design(path)
    assert given_inputs("solve_design", design) is design


def test_packages_cost_nothing_until_something_is_asked_of_them():
    assert "numpy" not in loaded("from calc import bearings, countershaft, engine, friction, gears, imbalance")


def test_a_pair_from_a_distance_has_the_shifts_of_that_distance():
    wheels = calc.gears.solve_pair(
        (32, 41), normal_module=2.25e-3, face_width=18e-3, centre_distance=82.3e-3, profile_shift=(0.1, None)
    ).wheels
    assert wheels["driver"].profile_shift == 0.1
    assert wheels["driven"].profile_shift == pytest.approx(-0.0209, abs=1e-3)


def test_one_operating_point_and_an_array_agree():
    pair = calc.gears.solve_pair((32, 41), normal_module=2.25e-3, face_width=18e-3)
    given = {"speed": 50.0, "oil": "SAE 50", "temperature": 90.0}
    one = calc.friction.solve_loss(pair, power=2000.0, **given).loss
    many = calc.friction.solve_loss(pair, power=np.array([2000.0, 4000.0]), **given).loss
    assert many[0] == pytest.approx(one, rel=1e-3)
    assert many[1] > many[0]


def test_a_film_that_is_warm_has_the_clearance_of_its_temperature():
    given = dict(
        diameter=0.0595,
        length=0.0275,
        clearance=80e-6,
        load=1707.0,
        speed=43.33,
        oil="SAE 50",
        supply_temperature=100.0,
        journal="20CrNi4",
        housing="EN AC-43100",
    )
    cold, warm = calc.bearings.solve_film(**given, warm=False), calc.bearings.solve_film(**given)
    assert cold.clearance == 80e-6 < warm.clearance
    assert warm.eccentricity > cold.eccentricity
    assert warm.oil_flow > cold.oil_flow and warm.temperature_rise < cold.temperature_rise
