"""What `help` says of the fields of inputs and of results: each with the unit in which Python has it."""

import pint
import pytest

from calc.bearings import Film
from calc.design.model import Design
from calc.engine import EngineInputs
from calc.sheet.quantity import keys, result, value
from calc.sheet.units import UNITS
from tests.calc.dimension import SPELL

UREG = pint.UnitRegistry()


def spelled(unit):
    for symbol, words in SPELL.items():
        unit = unit.replace(symbol, words)
    return unit.replace("kelvin", "delta_degC")


@pytest.mark.parametrize("symbol", sorted(set(UNITS) - {"€", "HV", "%", "‰", "°C", "10⁻⁶/K"}))
def test_a_unit_is_inside_what_its_factor_says(symbol):
    unit = UNITS[symbol]
    shown, inside = (UREG.Quantity(1, spelled(name)) for name in (symbol.replace("rpm", "1/min"), unit.inside_symbol))
    assert shown.to(inside.units).magnitude == pytest.approx(unit.factor * inside.magnitude, rel=1e-12)


def test_an_input_is_told_with_its_unit_and_its_range():
    assert "    bore [m]: Bore; a number above 0 and up to 1000 mm. Diameter" in EngineInputs.__doc__
    assert '    layout: Layout; one of "inline", "vee"' in EngineInputs.__doc__
    assert (
        "    cylinder_offset [m]: Cylinder offset; a number from −500 to 500 mm (left out: 0)." in EngineInputs.__doc__
    )


def test_a_result_is_told_with_its_unit():
    assert Film.__doc__.startswith("The state of a film, and the temperature rise")
    assert "    oil_flow [m³/s]: Oil flow\n" in Film.__doc__
    assert "oil:" not in Film.__doc__  # nothing is said of it


def test_every_table_of_a_design_can_be_told():
    seen, classes = set(), [Design]
    while classes:
        cls = classes.pop()
        seen.add(cls)
        lines = cls.__doc__.splitlines()
        for key in keys(cls).values():
            assert any(line.startswith(f"    {key.attribute}") for line in lines), key.key
            if key.about.table is not None and key.about.table not in seen:
                classes.append(key.about.table)
    assert len(seen) > 20


def test_a_class_of_results_made_here_has_it_too():
    @result
    class Small:
        """A small one."""

        share: float = value("Share", "%", "q")

    assert Small.__doc__ == Small(share=0.5).__doc__ == "A small one.\n\n    share [-]: Share"
