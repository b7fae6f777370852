"""The direction of the imports, and what a headless run may load: proved in a fresh process."""

import ast
import json
import subprocess
import sys

import pytest

from .conftest import DESIGNS, GAMMA, ROOT

HEAVY = ("scipy", "matplotlib", "reportlab", "rich", "textual", "tomlkit", "pypdf", "PIL", "ezdxf")


def loaded(code: str) -> set[str]:
    """The top-level modules that are loaded after running `code` in a fresh process."""
    script = f"import sys, json, io, contextlib\nwith contextlib.redirect_stdout(io.StringIO()):\n    {code}\nprint(json.dumps(sorted(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, cwd=ROOT, check=True)
    return {name.split(".")[0] for name in json.loads(done.stdout)}


@pytest.mark.parametrize(
    "arguments",
    [["check", str(GAMMA)], ["check", str(GAMMA), "--json"], ["replay", *map(str, sorted((ROOT / "tests" / "replays").glob("*.toml")))]],
)
def test_headless_commands_load_numpy_and_no_more(arguments):
    found = loaded(f"from assistant.cli import main; main({arguments!r})")
    assert "numpy" in found
    assert not found & set(HEAVY)


def test_help_loads_nothing_but_argparse():
    found = loaded("from assistant.cli import main; main(['--help'])")
    assert not found & {*HEAVY, "numpy", "tomllib", "json.decoder", "dataclasses"}


def test_inputs_can_be_read_without_numpy():
    """The session paints its form from the inputs before anything is solved."""
    assert "numpy" not in loaded(f"from calc.design_file import load; load({str(GAMMA)!r})")


@pytest.mark.parametrize("package, forbidden", [
    ("calc", {"assistant", "reports", *HEAVY} - {"scipy", "tomli_w"}), ("reports", {"assistant", "textual", "rich"}),
])  # fmt: skip
def test_imports_go_one_way(package, forbidden):
    for path in (ROOT / package).rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = (
                [a.name for a in node.names]
                if isinstance(node, ast.Import)
                else [node.module or ""]
                if isinstance(node, ast.ImportFrom) and not node.level
                else []
            )
            assert not {n.split(".")[0] for n in names} & forbidden, path


def test_scipy_is_loaded_only_where_it_is_used():
    for path in (ROOT / "calc").rglob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        top = [n for n in tree.body if isinstance(n, (ast.Import, ast.ImportFrom))]
        if "__main__" not in path.read_text(encoding="utf-8"):
            assert not any("scipy" in ast.unparse(n) for n in top), path


STEPS = ("engine", "imbalance", "countershaft", "bearings", "gears", "friction")


@pytest.mark.parametrize("step", STEPS)
def test_a_step_knows_neither_the_design_nor_a_later_step(step):
    """A step may read inputs and results that are there before it in the order of computing; it never solves another."""
    order = ("engine", "imbalance", "gears", "countershaft", "bearings", "friction")
    later = order[order.index(step) + 1 :]
    for path in (ROOT / "calc" / step).rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        assert "design import" not in text and "import design" not in text, path
        for other in later:
            assert f"..{other}.solve" not in text, path


def test_the_sheet_knows_no_engine():
    for path in (ROOT / "calc" / "sheet").glob("*.py"):
        assert "from .." not in path.read_text(encoding="utf-8"), path


def test_shipped_designs_are_found_beside_the_package():
    from calc.shipped import DESIGNS as shipped

    assert shipped.resolve() == DESIGNS.resolve()
