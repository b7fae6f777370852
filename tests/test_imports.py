"""The direction of the imports, and what a headless run may load: proved in a fresh process."""

import ast
import json
import subprocess
import sys
from collections import defaultdict

import pytest

from tests.conftest import DESIGNS, GAMMA, ROOT
from tests.import_scan import circles, graph, imported, modules

HEAVY = ("scipy", "matplotlib", "reportlab", "rich", "textual", "tomlkit", "pypdf", "PIL", "ezdxf", "pandas", "OCP")

# replays of designs that were on a bench or on a balancing machine, of which scipy says what it means
MEASURED = ("r753ie4_measured", "r754ie4_completed")


def loaded(code: str) -> set[str]:
    """The modules and packages that are loaded after running `code` in a fresh process."""
    script = (
        f"import sys, json, io, contextlib\nwith contextlib.redirect_stdout(io.StringIO()):\n    "
        f"{code}\nprint(json.dumps(sorted(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, cwd=ROOT, check=True)
    names = set(json.loads(done.stdout))
    return names | {name.split(".")[0] for name in names}


@pytest.mark.parametrize(
    "arguments",
    [
        ["check", str(GAMMA)],
        pytest.param(["check", str(GAMMA), "--json"], marks=pytest.mark.slow),
        pytest.param(
            [
                "replay",
                *(
                    str(path)
                    for path in sorted((ROOT / "tests" / "replays").glob("*.toml"))
                    if path.stem not in MEASURED
                ),
            ],
            marks=pytest.mark.slow,
        ),
    ],
)
def test_headless_commands_load_numpy_and_no_more(arguments):
    names = loaded(f"from assistant.cli import main; main({arguments!r})")
    assert "numpy" in names
    assert not names & set(HEAVY)
    assert "numpy.ma" not in names  # which `np.unique` of an array alone loads, for 20 ms


def test_help_loads_no_package():
    names = loaded("from assistant.cli import main; main(['--help'])")
    assert "argparse" in names
    assert not names & {*HEAVY, "numpy"}


def test_the_session_begins_without_numpy():
    """It is loaded by the thread that solves first."""
    assert "numpy" not in loaded("import assistant.app, assistant.screens.start")


def test_inputs_can_be_read_without_numpy():
    """The session paints its form from the inputs before anything is solved."""
    assert "numpy" not in loaded(f"from calc.design.toml_file import load; load({str(GAMMA)!r})")


# where results show themselves in a notebook or a script, when that is asked for
SHOWN = {
    "calc.sheet.curve": {"matplotlib"},
    "calc.sheet.shown": {"matplotlib", "pandas"},
    "calc.sheet.step": {"matplotlib", "pandas"},
    "calc.solve": {"matplotlib", "pandas"},
}


@pytest.mark.parametrize(
    "package, forbidden, allowed",
    [
        ("calc", {"assistant", "reports", *HEAVY} - {"scipy", "tomli_w"}, SHOWN),
        ("reports", {"assistant", "textual", "rich"}, {}),
    ],
)
def test_imports_go_one_way(package, forbidden, allowed):
    seen = {name: {n.split(".")[0] for n in imported(name, path)} for name, path in modules(ROOT, package).items()}
    assert package in set.union(*seen.values())  # its own relative imports are resolved
    assert {name: names & forbidden for name, names in seen.items() if names & forbidden} == allowed


def test_what_shows_results_loads_nothing_before_it_is_asked():
    names = loaded("import calc.solve, calc.sheet.shown, calc.bearings; calc.bearings.Film")
    assert not names & set(HEAVY)


def test_scipy_is_loaded_only_where_it_is_used():
    paths = {
        name: path for name, path in modules(ROOT, "calc").items() if "__main__" not in path.read_text(encoding="utf-8")
    }
    assert any("scipy" in n for name, path in paths.items() for n in imported(name, path))
    assert [
        name
        for name, path in paths.items()
        if any(n.split(".")[0] == "scipy" for n in imported(name, path, top_only=True))
    ] == []


STEPS = ("engine", "imbalance", "gears", "countershaft", "bearings", "friction")  # in the order of computing


@pytest.mark.parametrize("step", STEPS)
def test_a_step_knows_neither_the_design_nor_a_later_step(step):
    """A step may read inputs and results that are there before it in the order of computing; it never solves
    another."""
    paths = modules(ROOT, f"calc.{step}")
    later = {f"calc.{other}.solve" for other in STEPS[STEPS.index(step) + 1 :]} | {"calc.design.model", "calc.solve"}
    seen = {name: set(imported(name, path, typing=False)) for name, path in paths.items()}
    assert any(n.startswith("calc.sheet") for names in seen.values() for n in names)
    assert {name: names & later for name, names in seen.items() if names & later} == {}


def test_the_sheet_knows_no_engine():
    seen = {
        name: {n for n in imported(name, path) if n.split(".")[0] == "calc"}
        for name, path in modules(ROOT, "calc.sheet").items()
    }
    assert any(seen.values())
    assert {n for names in seen.values() for n in names if not f"{n}.".startswith("calc.sheet.")} == set()


# --- rooms
# the folders of calc, each above those before it; solve.py stands between the designs and what is asked of them
ROOMS = (
    "sheet",
    "locale",
    "library",
    "draw",
    "engine",
    "imbalance",
    "gears",
    "countershaft",
    "bearings",
    "friction",
    "mounting",
    "measurements",
    "design",
    "solve",
    "exchange",
    "studies",
)


def upwards(paths):
    """module → what it imports from a room above its own.  Imports in functions count, those under TYPE_CHECKING do
    not."""
    arrows = {}
    for name, path in paths.items():
        _, room, *_ = [*name.split("."), ""]
        others = {n.split(".")[1] for n in imported(name, path, typing=False) if n.startswith("calc.")}
        above = {other for other in others & set(ROOMS) if room in ROOMS and ROOMS.index(other) > ROOMS.index(room)}
        if above:
            arrows[name] = above
    return arrows


def test_no_room_of_calc_imports_one_above_it():
    paths = modules(ROOT, "calc")
    assert {name.split(".")[1] for name in paths if "." in name} == set(ROOMS)
    # what the row of a bearing says of each kind stands in the room of that kind, and knows no shaft
    assert upwards(paths) == {"calc.countershaft.rows": {"bearings"}}


def test_an_arrow_that_goes_up_is_found(tmp_path):
    (tmp_path / "calc" / "draw").mkdir(parents=True)
    path = tmp_path / "calc" / "draw" / "sheet.py"
    path.write_text(
        "from ..gears.result import TrainResult\nif TYPE_CHECKING:\n    from ..solve import Results\n", encoding="utf-8"
    )
    assert upwards({"calc.draw.sheet": path}) == {"calc.draw.sheet": {"gears"}}


def test_nothing_lies_loose_in_calc():
    assert sorted(path.name for path in (ROOT / "calc").glob("*.py")) == ["__init__.py", "solve.py"]


def test_a_class_has_a_name_of_its_own():
    """Two modules may call different things alike, more may not: a name that stands in three says nothing."""
    names = defaultdict(set)
    for name, path in modules(ROOT, "calc", "reports", "assistant").items():
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                names[node.name].add(name)
    assert len(names) > 500
    assert {name: sorted(where) for name, where in names.items() if len(where) > 2} == {}


# --- circles
@pytest.fixture(scope="module")
def edges():
    return graph(modules(ROOT, "calc", "reports", "assistant"))


@pytest.mark.parametrize("package", ["calc", "reports", "assistant"])
def test_no_modules_import_each_other(edges, package):
    """Imports inside functions and under TYPE_CHECKING count as well."""
    assert sum(len(others) for name, others in edges.items() if name.startswith(f"{package}.")) > 50
    tied = [circle for circle in circles(edges) if any(name.split(".")[0] == package for name in circle)]
    assert [sorted(circle) for circle in tied] == []


def package_of(tmp_path, **files):
    for name, text in {"__init__": "", **files}.items():
        path = tmp_path / "house" / f"{name.replace('__in__', '/')}.py"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return modules(tmp_path, "house")


@pytest.mark.parametrize(
    "back",
    [
        "from . import door",
        "from .door import knob",
        "import house.door",
        "from house.door import knob",
        "from house import door",
        "def open():\n    from .door import knob",
        "if TYPE_CHECKING:\n    from .door import knob",
        "class Roof:\n    async def lift(self):\n        import house.door",
    ],
)
def test_the_scan_finds_a_circle(tmp_path, back):
    assert circles(graph(package_of(tmp_path, door="from .roof import tile", roof=back))) == [
        {"house.door", "house.roof"}
    ]


def test_the_scan_finds_no_circle_where_there_is_none(tmp_path):
    paths = package_of(
        tmp_path,
        door="from . import roof\nfrom .room import bed",
        roof="",
        room__in__bed="from .. import roof",
        room__in____init__="",
    )
    assert circles(graph(paths)) == []
    assert graph(paths)["house.door"] == {"house.roof", "house.room.bed"}


def test_the_scan_finds_a_long_circle_through_a_package(tmp_path):
    paths = package_of(
        tmp_path,
        door="from .room.bed import pillow",
        room__in__bed="from .sheet import x",
        room__in__sheet="from ..door import knob",
        room__in____init__="",
    )
    assert circles(graph(paths)) == [{"house.door", "house.room.bed", "house.room.sheet"}]


def test_the_scan_tells_what_is_loaded_from_what_is_only_named(tmp_path):
    text = (
        "import a\nif TYPE_CHECKING:\n    import b\nelse:\n    import c\ndef f():\n    import d\nclass C:\n    "
        "import e\ntry:\n    import g\nexcept ImportError:\n    pass"
    )
    path = package_of(tmp_path, door=text)["house.door"]
    assert set(imported("house.door", path, top_only=True)) == {"a", "c", "e", "g"}
    assert set(imported("house.door", path)) == {"a", "b", "c", "d", "e", "g"}


def test_a_scan_of_nothing_fails(tmp_path):
    with pytest.raises(AssertionError, match="no module of calc"):
        modules(tmp_path, "calc")


def test_shipped_designs_are_found_beside_the_package():
    from calc.studies.shipped import DESIGNS as shipped

    assert shipped.resolve() == DESIGNS.resolve()
