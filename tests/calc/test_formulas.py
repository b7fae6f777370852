"""Every formula of the program: it has a source, it renders, its dimensions agree."""

import ast
import inspect
import textwrap
from importlib import import_module
from pathlib import Path

import pytest

import calc
from calc.sheet.expression import expression, text
from calc.sheet.formula import FORMULAS, formula, units
from calc.sheet.units import UNITS

from .dimension import Mismatch, check

for path in Path(calc.__file__).parent.rglob("*.py"):
    if "@formula" in (source := path.read_text(encoding="utf-8")) and path.parent.name != "sheet" and "__main__" not in source:
        import_module(".".join(path.relative_to(Path(calc.__file__).parent.parent).with_suffix("").parts))

OURS = {name: f for name, f in FORMULAS.items() if name.startswith("calc.")}  # other tests make formulas of their own
EXPRESSIONS = {name: f for name, f in OURS.items() if not f.shows}


def test_there_are_formulas():
    assert len(OURS) > 100


@pytest.mark.parametrize("name", OURS)
def test_names_its_source(name):
    assert len(OURS[name].source) >= 8


@pytest.mark.parametrize("name", OURS)
def test_every_argument_and_the_result_have_a_unit(name):
    found = units(OURS[name])
    assert set(found) == {*OURS[name].parameters, "return"}
    assert not OURS[name].unit or OURS[name].unit in UNITS


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_is_one_return_expression_that_renders(name):
    f = EXPRESSIONS[name]
    body = ast.parse(textwrap.dedent(inspect.getsource(f.function))).body[0].body
    assert [type(n) for n in body if not (isinstance(n, ast.Expr) and isinstance(n.value, ast.Constant))] == [ast.Return]
    assert text(expression(f))


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_dimensions_agree(name):
    check(EXPRESSIONS[name])


def test_a_formula_without_source_does_not_import():
    with pytest.raises(ValueError, match="source"):
        formula("p", "")
    with pytest.raises(ValueError, match="source"):
        formula("", "ISO 7902-1:2020, 4.2")


def test_the_dimension_test_can_fail():
    from calc.sheet.units import Metre, Newton, Pascal

    def wrong(F: Newton, d: Metre) -> Pascal:
        return F / d

    made = formula("p", "a wrong formula, for this test")(wrong)
    made.function.__globals__.setdefault("__annotations__", {})
    del FORMULAS[f"{wrong.__module__}.{wrong.__name__}"]
    with pytest.raises(Mismatch):
        check(made)
