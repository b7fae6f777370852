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
from tests.calc.dimension import Mismatch, check

for path in Path(calc.__file__).parent.rglob("*.py"):
    if (
        "@formula" in (source := path.read_text(encoding="utf-8"))
        and path.parent.name != "sheet"
        and "__main__" not in source
    ):
        import_module(".".join(path.relative_to(Path(calc.__file__).parent.parent).with_suffix("").parts))

OURS = [f for name, f in FORMULAS.items() if name.startswith("calc.")]  # other tests make formulas of their own
# one test a formula would take twice as long
EACH_MODULE = pytest.mark.parametrize("module", dict.fromkeys(f.function.__module__ for f in OURS))


def formulas_of(module, expressions=False):
    """Those of a module; `expressions`: without those that say in words how a number was found."""
    return [f for f in OURS if f.function.__module__ == module and not (expressions and f.shows)]


def test_there_are_formulas():
    assert len(OURS) > 1000


@EACH_MODULE
def test_names_its_source(module):
    assert not [f.__name__ for f in formulas_of(module) if len(f.source) < 8]


@EACH_MODULE
def test_every_argument_and_the_result_have_a_unit(module):
    for f in formulas_of(module):
        assert set(units(f)) == {*f.parameters, "return"}, f.__name__
        assert not f.unit or f.unit in UNITS, f.__name__


@EACH_MODULE
def test_is_one_return_expression_that_renders(module):
    for f in formulas_of(module, expressions=True):
        body = ast.parse(textwrap.dedent(inspect.getsource(f.function))).body[0].body
        assert [type(n) for n in body if not (isinstance(n, ast.Expr) and isinstance(n.value, ast.Constant))] == [
            ast.Return
        ], f.__name__
        assert text(expression(f)), f.__name__


@EACH_MODULE
def test_dimensions_agree(module):
    for f in formulas_of(module, expressions=True):
        check(f)


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
