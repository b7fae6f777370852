"""The examples in the docstrings run and give what they say: those of the formulas, which `help` shows, and all
others."""

import doctest
from importlib import import_module
from pathlib import Path

import pytest

import calc
from calc.sheet.formula import FORMULAS

ROOT = Path(calc.__file__).parent
TEXTS = {path: path.read_text(encoding="utf-8") for path in ROOT.rglob("*.py")}
EXAMPLES = {path: text.count(">>> ") for path, text in TEXTS.items() if ">>> " in text}
NAMES = {
    path: ".".join(("calc", *path.relative_to(ROOT).with_suffix("").parts)).removesuffix(".__init__")
    for path in EXAMPLES
}


@pytest.mark.parametrize("path", EXAMPLES, ids=NAMES.values())
def test_examples_run(path):
    module = import_module(NAMES[path])
    tests = doctest.DocTestFinder(exclude_empty=True).find(module)
    assert sum(len(test.examples) for test in tests) == EXAMPLES[path], "an example that doctest does not find"
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    failures: list[str] = []
    for test in tests:
        runner.run(test, out=failures.append)
    assert not failures, "".join(failures)


def test_the_formulas_that_a_user_calls_have_examples():
    for path in NAMES.values():
        import_module(path)
    with_example = [name for name, formula in FORMULAS.items() if ">>> " in (formula.function.__doc__ or "")]
    assert len(with_example) >= 60
    assert {name.split(".")[1] for name in with_example} >= {
        "engine",
        "imbalance",
        "countershaft",
        "bearings",
        "gears",
        "friction",
    }


def test_a_wrong_example_fails(monkeypatch):
    from calc.bearings.plain.formulas import length_ratio

    monkeypatch.setattr(length_ratio.function, "__doc__", ">>> length_ratio(l=0.02, d=0.04)\n0.6\n")
    test = doctest.DocTestFinder().find(length_ratio, "length_ratio", globs={"length_ratio": length_ratio})
    assert doctest.DocTestRunner(verbose=False).run(test[0], out=lambda text: None).failed == 1
