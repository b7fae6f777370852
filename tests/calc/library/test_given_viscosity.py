# SPDX-License-Identifier: Apache-2.0
"""An oil by one dynamic viscosity, or by rows of temperature and viscosity, beside the two kinematic ones."""

import re
from pathlib import Path

import numpy as np
import pytest

from calc.design.toml_file import design, parse, read
from calc.library.catalogue import Oil, ViscosityRow, oils
from calc.library.lubricant import Lubricant
from calc.library.oil_formulas import ZERO_CELSIUS
from calc.library.oils import rising_rows
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.explain import Chains

DESIGNS = Path(__file__).parents[3] / "designs"
# Gear friction thesis, table of oils (read): T in °C → dynamic viscosity in mPa·s, as our copy has it.
PRINTED = {
    "10W40": {40.0: 128.58, 50.0: 20.10, 60.0: 70.22, 100.0: 16.797},
    "0W30": {40.0: 27.18, 50.0: 20.10, 60.0: 16.14, 100.0: 4.29},
    "10W40 synthetic": {40.0: 225.79, 50.0: 150.31, 60.0: 100.25, 100.0: 40.09},
    "MIL-L-23699E": {40.0: 22.56, 50.0: 18.14, 60.0: 13.54, 100.0: 4.59},
}


def tabulated(rows, rho15=850.5):
    given = tuple(ViscosityRow(temperature=T, viscosity=mu * 1e-3) for T, mu in rows.items())
    return Oil(name="x", viscosities=given, rho15=rho15, base="mineral")


def written(name, rows):
    """An oil of the friction thesis as printed, as a user writes it into a design."""
    shipped = oils()[f"friction thesis {name}"]
    head = f'[[oil]]\nname = "{name} as printed"\nrho15_kgm3 = {shipped.rho15}\nbase = "{shipped.base}"\nconductivity_W_mK = {shipped.conductivity}\n'
    return head + "".join(
        f"[[oil.viscosities]]\ntemperature_C = {T}\nviscosity_mPas = {mu}\n" for T, mu in rows.items()
    )


def errors(text):
    with pytest.raises(BadInput) as caught:
        design(parse(text.encode(), "d.toml"))
    return str(caught.value)


@pytest.mark.parametrize("name", PRINTED)
def test_every_row_is_met(name):
    lubricant = Lubricant(tabulated(PRINTED[name]))
    for T, mu in PRINTED[name].items():
        assert lubricant.at(T).mu * 1e3 == pytest.approx(mu, rel=1e-10)
    at_once = lubricant.at(np.array([30.0, 40.0, 45.0, 50.0, 55.0, 80.0, 100.0, 120.0])).mu
    assert at_once.tolist() == pytest.approx(
        [lubricant.at(T).mu for T in (30.0, 40.0, 45.0, 50.0, 55.0, 80.0, 100.0, 120.0)], rel=1e-12
    )


@pytest.mark.parametrize("law", ["walther", "d341"])
def test_two_rows_are_the_law_of_two_viscosities(law):
    by_points = Lubricant(oils()["SAE 30"], law)
    rows = {T: by_points.at(T).mu * 1e3 for T in (40.0, 100.0)}
    by_rows = Lubricant(tabulated(rows, rho15=889.0), law)
    for T in (0.0, 40.0, 70.0, 100.0, 130.0):
        assert by_rows.at(T).mu == pytest.approx(by_points.at(T).mu, rel=1e-9)
        assert by_rows.beta(T) == pytest.approx(by_points.beta(T), rel=1e-9)
    assert by_rows.nu40 == pytest.approx(by_points.oil.nu40) and by_rows.nu100 == pytest.approx(by_points.oil.nu100)


def test_between_two_rows_by_hand():
    """lg lg(ν + 0.6) is linear in lg T between the rows at 60 and 100 °C of the thesis' 10W-40."""
    rho = {T: 850.5 * (1 - 0.00065 * (T - 15)) for T in (60.0, 80.0, 100.0)}
    y = {T: np.log10(np.log10(PRINTED["10W40"][T] * 1e3 / rho[T] + 0.6)) for T in (60.0, 100.0)}
    x = {T: np.log10(T + ZERO_CELSIUS) for T in rho}
    there = y[60.0] + (y[100.0] - y[60.0]) * (x[80.0] - x[60.0]) / (x[100.0] - x[60.0])
    assert Lubricant(tabulated(PRINTED["10W40"])).at(80.0).mu * 1e6 == pytest.approx(
        (10 ** (10**there) - 0.6) * rho[80.0]
    )


@pytest.mark.parametrize("T", [45.0, 70.0, 110.0])
def test_the_fall_with_temperature_is_the_derivative(T):
    lubricant = Lubricant(tabulated(PRINTED["10W40 synthetic"]))
    slope = (np.log(lubricant.at(T + 1e-3).mu) - np.log(lubricant.at(T - 1e-3).mu)) / 2e-3
    assert lubricant.beta(T) == pytest.approx(-slope, rel=1e-6)


def test_a_constant_viscosity_is_one_at_every_temperature():
    lubricant = Lubricant(Oil(name="x", viscosity=0.0276, rho15=860.0, base="mineral"))
    assert [lubricant.at(T).mu for T in (-20.0, 40.0, 100.0)] == [0.0276] * 3 and lubricant.beta(60.0) == 0
    assert lubricant.at(np.array([20.0, 90.0])).mu.tolist() == [0.0276, 0.0276]
    assert lubricant.nu40 == pytest.approx(0.0276 / (860 * (1 - 0.00065 * 25))) and not lubricant.polymer_thickened
    assert lubricant.reach is None


@pytest.mark.parametrize("name", PRINTED)
@pytest.mark.parametrize("T", [40.0, 60.0, 100.0])
def test_the_oils_of_the_thesis_run_as_printed(name, T):
    text = (DESIGNS / "thesis_oils.toml").read_text(encoding="utf-8")
    head, _, _ = text.partition("[[friction.scenarios]]")
    text = head.replace('oil = "friction thesis 10W40"', f'oil = "{name} as printed"').replace(
        "oil_temperature_C = 40.0", f"oil_temperature_C = {T}"
    )
    results = solve(design(parse((text + written(name, PRINTED[name])).encode(), "d.toml")))
    values = {v.id: v.shown for v in results.values().values()}
    assert values["friction.oil_viscosity"] == pytest.approx(PRINTED[name][T], rel=1e-9)
    keys = {key for link in Chains(results).of("friction.crank_camshaft.loss") for key in link.inputs}
    row = list(PRINTED[name]).index(T)
    assert f"oil.{name} as printed.viscosities.{row}.viscosity_mPas" in keys


def test_figures_and_tables_of_such_an_oil_are_made_too():
    """What is made later asks for the oil at many points at once."""
    text = (DESIGNS / "timing_pair.toml").read_text(encoding="utf-8")
    name = re.search(r'^oil = "(.*)"$', text, re.MULTILINE)[1]
    text = text.replace(f'oil = "{name}"', 'oil = "10W40 as printed"') + written("10W40", PRINTED["10W40"])
    results = solve(design(parse(text.encode(), "d.toml")))
    drawn = results.outcomes["friction"].whole
    assert drawn.tables and drawn.curves and not [note for note in drawn.notes if "Not everything" in note]


def test_the_bearings_take_a_viscosity_of_their_own():
    document = read(DESIGNS / "r753ie4_gamma.toml").with_value("bearings.viscosity_mPas", 7.5)
    results = solve(design(document))
    films = results.outcomes["bearings"].result.bearings
    assert all(r.hot.oil.mu == 0.0075 for r in films.values())
    keys = {key for link in Chains(results).of("bearings.front.film") for key in link.inputs}
    assert "bearings.viscosity_mPas" in keys
    assert not any(c.id.endswith(("viscosity_range", "shear_rate")) for c in results.outcomes["bearings"].checks)


def test_beyond_the_rows_is_said():
    text = (DESIGNS / "thesis_oils.toml").read_text(encoding="utf-8").partition("[[friction.scenarios]]")[0]
    text = text.replace('"friction thesis 10W40"', '"0W30 as printed"').replace(
        "_temperature_C = 40.0", "_temperature_C = 120.0"
    )
    outcome = solve(design(parse((text + written("0W30", PRINTED["0W30"])).encode(), "d.toml"))).outcomes["friction"]
    (found,) = [c for c in outcome.checks if c.id == "friction.train.oil_rows"]
    assert found.limit == (40.0, 100.0) and found.verdict == "note"
    (about,) = [table for table in outcome.tables if table.id == "oil"]
    assert [row[1] for row in about.rows if "Dynamic viscosity at" in row[0]] == list(PRINTED["0W30"].values())


def test_a_rise_with_temperature_is_said_and_heats_no_inlet():
    """20.10 mPa·s at 50 °C between 128.58 and 70.22: the 0W-30's value, copied, or 90.10 misread."""
    lubricant = Lubricant(tabulated(PRINTED["10W40"]))
    assert "rises from 50 to 60 °C" in rising_rows(lubricant.oil) and rising_rows(tabulated(PRINTED["0W30"])) is None
    assert lubricant.beta(50.0) == lubricant.beta(55.0) == 0 and lubricant.beta(60.0) > 0


HEAD = 'schema = 1\nname = "x"\n[[oil]]\nname = "mine"\nrho15_kgm3 = 860.0\nbase = "mineral"\n'


@pytest.mark.parametrize(
    "more, wanted",
    [
        ("", ["oil.0.nu40_mm2_s", "oil.0.nu100_mm2_s", "viscosity_mPas, or rows of viscosities"]),
        ("nu40_mm2_s = 90.0\n", ["oil.0.nu100_mm2_s", "needed with the viscosity at 40 °C"]),
        ("nu100_mm2_s = 9.0\n", ["oil.0.nu40_mm2_s", "needed with the viscosity at 100 °C"]),
        (
            "nu40_mm2_s = 90.0\nnu100_mm2_s = 9.0\nviscosity_mPas = 20.0\n",
            ["oil.0.viscosity_mPas: 20.0: the viscosity of this oil is given by nu40_mm2_s"],
        ),
        ("viscosity_mPas = 0.0\n", ["d.toml:7: oil.0.viscosity_mPas: 0.0: must be a number above 0"]),
        (
            "[[oil.viscosities]]\ntemperature_C = 40\nviscosity_mPas = 30\n",
            ["oil.0.viscosities", "has one row; needs two or more"],
        ),
        (
            "viscosities = [{ temperature_C = 60, viscosity_mPas = 30 }, { temperature_C = 60, viscosity_mPas = 20 }]\n",
            ["oil.0.viscosities.1.temperature_C", "must be above that of the row before"],
        ),
    ],
)
def test_what_is_refused(more, wanted):
    said = errors(HEAD + more)
    assert all(part in said for part in wanted), said


def test_the_textbook_bearing_of_shigley():
    """Shigley, Examples 12-1 and 12-2 (from memory): 4 µreyn, 30 rev/s, 500 lbf, r = l/2 = 0.75 in, c = 0.0015 in give
    S = 0.135, h_0/c = 0.42 and (r/c)·f = 3.50, read from the charts of Raimondi and Boyd."""
    inch, reyn, pound = 25.4, 6894.757, 4.4482216
    row = (
        f"diameter_mm = {1.5 * inch}\nlength_mm = {1.5 * inch}\nclearance_um = {3.0 * inch}\n"
        f"load_N = {500 * pound}\njournal_roughness_um = 0.2\nhousing_roughness_um = 0.2\n"
    )
    text = f"""schema = 2
name = "textbook"
[bearings]
oil = "SAE 20"
viscosity_mPas = {4e-6 * reyn * 1e3}
supply_temperature_C = 40.0
supply_pressure_bar = 0.0
supply = "hole"
hole_diameter_mm = 4.0
housing_material = "steel"
journal_material = "steel"
speed_rpm = 1800.0
load_speed_ratio = 0.0
[[shafts]]
name = "shaft"
mode = "bearings"
[[shafts.bearings]]
name = "front"
position_mm = 0.0
{row}[[shafts.bearings]]
name = "rear"
position_mm = 1000.0
{row}"""
    values = {id: v.inside for id, v in solve(design(parse(text.encode(), "d.toml"))).values().items()}
    c = 0.0015 * inch * 1e-3
    assert values["bearings.front.reynolds.sommerfeld"] == pytest.approx(0.135, rel=1e-3)
    assert values["bearings.front.reynolds.film"] / c == pytest.approx(0.42, rel=0.02)
    assert values["bearings.front.reynolds.friction_variable"] == pytest.approx(3.50, rel=0.02)


@pytest.mark.parametrize("lowest, verdict", [(-20.0, "pass"), (-24.0, "pass"), (-25.0, "warn")])
def test_an_oil_has_to_be_pumped_at_a_cold_start(lowest, verdict):
    """Q8 T905: borderline pumping temperature −24 °C, pour point −27 °C (Finotti 2013, Fig. 5.20, read)."""
    document = read(DESIGNS / "r753ie4_gamma.toml").with_value("bearings.lowest_temperature_C", lowest)
    found = next(c for c in solve(design(document)).checks() if c.id == "bearings.oil_pumping")
    assert found.source == oils()["10W-40 Q8 T905"].source != "given in the design"
    assert found.limit == -24.0 and found.verdict == verdict and found.kind == "caution"


def test_an_oil_of_unknown_pumping_limit_is_not_judged():
    document = read(DESIGNS / "r753ie4_gamma.toml").with_value("bearings.oil", "SAE 30")
    assert not [c for c in solve(design(document)).checks() if c.id == "bearings.oil_pumping"]
