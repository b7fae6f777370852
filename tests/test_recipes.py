# SPDX-License-Identifier: Apache-2.0
"""The recipes of CONTRIBUTING.md, performed in a copy of this folder: which files a recipe changes, and what it says to
run then, are read there."""

import json
import math
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from pypdf import PdfReader

from tests.conftest import ROOT
from tests.languages.texts import untranslated

LEFT_OUT = shutil.ignore_patterns(".*", "bench", "build", "dist", "site", "*.egg-info")
GAMMA = "designs/r753ie4_gamma.toml"
HEAD = re.compile(r"\*In (?P<files>.*)\. Then (?P<commands>.*)\.\*")
CODE = re.compile(r"`([^`]+)`")


@dataclass
class Recipe:
    """One section of CONTRIBUTING.md, in a copy.  `changed`: the files that the test has changed so far."""

    files: list[str]
    commands: list[str]
    copy: Path
    changed: set[str] = field(default_factory=set)

    def file(self, name: str) -> Path:
        """One of the files that the recipe names, by the end of its path."""
        (path,) = (path for path in self.files if path.endswith(f"/{name}"))
        self.changed.add(path)
        return self.copy / path

    def insert(self, name: str, before: str, text: str) -> None:
        path = self.file(name)
        whole = path.read_text(encoding="utf-8")
        assert before in whole, f"{name} has no {before!r} any more, before which this test inserts"
        path.write_text(whole.replace(before, text + before, 1), encoding="utf-8")

    def append(self, name: str, text: str) -> None:
        path = self.file(name)
        path.write_text(path.read_text(encoding="utf-8") + text, encoding="utf-8")

    def python(self, *words: str, **more: str) -> "subprocess.CompletedProcess[str]":
        env = {**os.environ, "PYTHONPATH": str(self.copy), **more}
        return subprocess.run([sys.executable, *words], cwd=self.copy, env=env, capture_output=True, text=True)

    def program(self, *words: str) -> str:
        """What a command prints; a verdict that fails is no fault of the command."""
        done = self.python("-m", "assistant", *words)
        assert done.returncode in (0, 1), done.stderr
        return done.stdout

    def solved(self) -> dict[str, Any]:
        return json.loads(self.program("check", GAMMA, "--json"))

    def report(self, *words: str) -> str:
        """The words of a report, each line after the other."""
        self.program("report", GAMMA, "-o", "report.pdf", *words)
        return " ".join(" ".join(page.extract_text().split()) for page in PdfReader(self.copy / "report.pdf").pages)

    def run(self, **more: str) -> str:
        """What the recipe says to run."""
        assert self.changed == set(self.files), "the recipe names other files than were changed"
        printed = ""
        for command in self.commands:
            program, *words = shlex.split(command)
            done = self.python(*(["-m", "pytest"] if program == "pytest" else []), *words, **more)
            assert done.returncode == 0, f"{command}\n{done.stdout[-3000:]}{done.stderr[-3000:]}"
            printed += done.stdout
        return printed


Performed = Callable[..., Recipe]


@pytest.fixture
def recipe(tmp_path: Path) -> Performed:
    """Reads a section of the page; `step`, `kind`: that which `<step>` and KIND stand for."""
    copy = tmp_path / "copy"

    def read(title: str, step: str = "", kind: str = "") -> Recipe:
        shutil.copytree(ROOT, copy, ignore=LEFT_OUT)
        page = (copy / "CONTRIBUTING.md").read_text(encoding="utf-8")
        head = HEAD.match(page.partition(f"\n### {title}\n")[2])
        assert head is not None, f"CONTRIBUTING.md has no recipe for {title}, or not its files and commands"
        files, commands = (
            CODE.findall(head[part].replace("<step>", step).replace("KIND", kind)) for part in ("files", "commands")
        )
        return Recipe(files, commands, copy)

    return read


def headings() -> Iterator[tuple[str, str]]:
    """Every recipe that begins with its files: its title, and that line."""
    for section in (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").split("\n### ")[1:]:
        title, _, rest = section.partition("\n")
        if rest.startswith("*"):
            yield title, rest.partition("\n")[0]


@pytest.mark.parametrize("title, line", list(headings()))
def test_what_a_recipe_names_is_there(title: str, line: str) -> None:
    head = HEAD.match(line)
    assert head is not None
    commands = [word for command in CODE.findall(head["commands"]) for word in command.split()]
    for path in (*CODE.findall(head["files"]), *(word for word in commands if word.startswith(("tests/", "docs/")))):
        wanted = ROOT / path.replace("<step>", "bearings/plain").replace("KIND", "rolling")
        assert (wanted.parent if wanted.name == "NAME.py" else wanted).exists(), (title, path)


def test_the_map_names_what_is_there() -> None:
    """The rooms, and below each what to look at first."""
    rows = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").partition("| look here first |")[2].splitlines()[2:]
    for row in rows[: rows.index("")]:
        rooms, _, first = (CODE.findall(cell) for cell in row.strip("|").split(" | "))
        top = ROOT / rooms[0]
        assert top.exists() and all((ROOT / name).exists() or (ROOT / "calc" / name).exists() for name in rooms), row
        assert all((top / name).exists() for name in first), row


@pytest.mark.slow
def test_an_oil(recipe: Performed) -> None:
    oil = recipe("an oil")
    value = '{{ is = {}, confidence = "low", source = "assumed; a trial" }}\n'
    row = {"base": '"PAO"', "nu40_mm2_s": 60.0, "nu100_mm2_s": 10.5, "rho15_kgm3": 850.0, "conductivity_W_mK": 0.14}
    rows = "".join(f"{key} = " + value.format(is_) for key, is_ in row.items())
    oil.append("oils.toml", f'\n[[row]]\nname = "trial oil"\n{rows}source = "rule of this program: a trial"\n')
    assert "trial oil" in oil.program("oils", "trial oil") and "10.5" in oil.program("oils", "trial oil")
    sheets = [oil.program("check", GAMMA, "--set", f"bearings.oil={name}") for name in ("trial oil", "5W-30")]
    assert "Bearings" in sheets[0] and sheets[0] != sheets[1]
    oil.run()


@pytest.mark.slow
def test_a_kind_of_bearing(recipe: Performed) -> None:
    """A third one, a dry bush in front of a plain bearing: in the file, the balance of power, report and drawing."""
    third = recipe("a kind of bearing", kind="dry")
    assert len(third.files) <= 6
    third.insert("bearings/row.py", '        default="plain",\n        help="plain:', '        "dry",\n')
    third.insert("names.py", '"polyamide": Text(', '"dry": Text("dry"), ')
    third.insert("rows.py", "from ..bearings.plain.row import", "from ..bearings.dry.row import DryRow\n")
    third.insert("rows.py", '"rolling": RollingRow}', '"dry": DryRow, ')
    third.insert("rows.py", "RollingRow, PlainRow, SupportRow):", "DryRow, ")
    third.file("dry/__init__.py").parent.mkdir()
    third.file("dry/__init__.py").write_text("# SPDX-License-Identifier: Apache-2.0\n", encoding="utf-8")
    for name in ("row", "kind"):
        third.file(f"dry/{name}.py").write_bytes((ROOT / "tests" / "third_kind" / f"{name}.txt").read_bytes())
    design, row = "dry.toml", "shafts.shaft.bearings.front"
    (third.copy / design).write_bytes((third.copy / GAMMA).read_bytes())
    third.program("upgrade", design)
    third.program("set", design, *(f"{row}.{key}" for key in ("kind=dry", "bush_bore_mm=40", "bush_length_mm=20")))
    values = json.loads(third.program("check", design, "--json"))["values"]
    turns, power = (values[f"bearings.front.{key}"]["value"] for key in ("load", "friction_power"))
    stands, in_balance = (
        values[f"friction.journals.front.{key}"]["value"] for key in ("standing_load", "friction_power")
    )
    assert power == pytest.approx(0.1 * (turns + stands) * math.pi * 0.040 * 2600 / 60, rel=1e-6)
    assert in_balance == pytest.approx(power, rel=1e-6) and values["friction.total_loss"]["value"] > power
    assert "Coulomb" in third.program("explain", design, "bearings.front.friction_power")
    third.program("report", design, "-o", "dry.pdf", "--depth", "summary")
    third.program("export", design, "--dxf", "-o", "dry.dxf")
    assert (third.copy / "dry.pdf").exists() and (third.copy / "dry.dxf").exists()
    third.run()


@pytest.mark.slow
def test_a_check(recipe: Performed) -> None:
    check = recipe("a check", "bearings/plain")
    check.insert(
        "checks.py",
        "FILM_DOUBLE_LOAD = CheckRule(",
        'TRIAL_LOAD = CheckRule(\n    "bearings.B.trial_load", "advice", "It is a trial.", Text("Trial of the load"), "<=", "N",\n'
        '    source=Text("rule of this program: a trial"), advice=Text("Take a lighter one."),\n)\n',
    )
    check.insert(
        "checks.py",
        "    yield on_bearing(FILM_DOUBLE_LOAD,",
        "    yield on_bearing(TRIAL_LOAD, place, r.load, 1.0)\n",
    )
    check.insert("severities.csv", "bearings.B.film_trumpler,", "bearings.B.trial_load,(new),advice,,,,\n")
    judged = {judged["id"]: judged for judged in check.solved()["checks"]}
    assert judged["bearings.front.trial_load"]["verdict"] == "note"
    assert "Trial of the load" in check.program("check", GAMMA, "--step", "bearings")
    check.run()


@pytest.mark.slow
def test_an_input(recipe: Performed) -> None:
    an_input = recipe("an input", "engine")
    an_input.insert(
        "inputs.py",
        '    bore: float = quantity(\n        "Bore",',
        '    coolant: float | None = quantity(\n        "Coolant temperature", "°C", default=None, low=0, high=130,\n'
        '        help="What leaves the block.",\n    )\n',
    )
    an_input.run()
    assert "coolant_C" in (an_input.copy / "docs" / "contralbero.schema.json").read_text(encoding="utf-8")
    refused = an_input.python("-m", "assistant", "check", GAMMA, "--set", "engine.coolant_C=200")
    assert refused.returncode == 2 and "engine.coolant_C" in refused.stderr and "130" in refused.stderr
    an_input.program("set", GAMMA, "engine.coolant_C=90")
    assert "coolant_C = 90" in (an_input.copy / GAMMA).read_text(encoding="utf-8")
    assert "Coolant temperature" in an_input.report()


@pytest.mark.slow
def test_a_bearing_route(recipe: Performed) -> None:
    route = recipe("a bearing route")
    route.insert(
        "routes.py",
        '@bearing_route("iso7902"',
        """@bearing_route("trial", Text("trial route"), why_off=lambda film, ratio: Text("it is a trial"))
def trial(seat: BearingCase, duty: OperatingPoint, rise: float) -> Film:
    from dataclasses import replace

    own = own_cold(seat, duty, rise)
    return replace(own, film=f.film(g=own.clearance, eps=own.eccentricity / 2))


""",
    )
    solved = route.solved()
    values, table = solved["values"], json.dumps(solved["tables"]["bearings.routes_front"])
    film, own = (values[f"bearings.front.{name}.film"]["value"] for name in ("trial", "reynolds"))
    assert film > 1.2 * own and "trial route: it is a trial." in table
    assert "trial route" in route.program("explain", GAMMA, "bearings.front.trial.film")
    assert "trial route: it is a trial" in route.report("--depth", "audit")
    route.run()
    path = route.file("routes.py")
    counted = path.read_text(encoding="utf-8").replace(
        'Text("trial route"),', 'Text("trial route"), counts=everywhere,'
    )
    path.write_text(counted, encoding="utf-8")
    solved = route.solved()
    before, after = (x["bearings.front.routes_spread"]["value"] for x in (values, solved["values"]))
    assert before < 5 and after == pytest.approx(100 * (film / own - 1))
    advice = {check["id"]: check["advice"] for check in solved["checks"]}["bearings.front.routes_spread"]
    assert re.search(r"trial route is \+\d+ % off: it is a trial", advice)


@pytest.mark.slow
def test_a_friction_model(recipe: Performed) -> None:
    model = recipe("a friction model")
    model.insert(
        "models.py",
        '@friction_model(\n    "benedict_kelley"',
        '@friction_model("trial", Text("A. Trial"), OHLENDORF, Text("any load"))\n'
        "def of_trial(c: MeshCase, P: Watt, H_V: Number) -> Regression:\n"
        "    return Regression(friction_mean=0.05, loss=loss_of_mean_friction(P=P, mu_m=0.05, H_V=H_V))\n\n\n",
    )
    model.insert("checks.py", "Xu and Kahraman 2005, Benedict", "A. Trial, ")
    solved = model.solved()
    assert solved["values"]["friction.idler_shaft.trial.friction_mean"]["value"] == 0.05
    assert "A. Trial × Ohlendorf" in json.dumps(solved["tables"]["friction.models_idler_shaft"], ensure_ascii=False)
    judged = {judged["id"]: judged for judged in solved["checks"]}["friction.train.models"]
    assert judged["limit"] == 5 and "A. Trial" in judged["source"]
    assert "A. Trial" in model.program("check", GAMMA, "--step", "friction")
    model.run()


@pytest.mark.slow
def test_a_figure(recipe: Performed) -> None:
    figure = recipe("a figure", "friction")
    figure.insert(
        "curves.py",
        "    return bars, *of_meshes, *((_shear(d),) if d.cases else ())\n",
        '    way = Series(Text("way"), np.array([0.0, 1.0]), np.array([0.0, 2.0]))\n'
        '    trial = Curve("trial", Text("A trial of a figure"), axis_label("x", "mm"), axis_label("y", "W"), (way,))\n'
        "    of_meshes = (*of_meshes, trial)\n",
    )
    assert "A trial of a figure" in figure.report("--depth", "audit")
    figure.run()


@pytest.mark.slow
def test_a_translation(recipe: Performed) -> None:
    """A sentence of the program that is worded anew: English is enough, then it gets its Italian."""
    translation = recipe("a translation")
    source = translation.copy / "calc" / "bearings" / "plain" / "notes.py"
    old, new = "is taken as given at {reference} and judged", "is a trial at {reference} and judged"
    text = source.read_text(encoding="utf-8")
    assert old in text
    source.write_text(text.replace(old, new), encoding="utf-8")
    tests = ("-m", "pytest", *shlex.split(translation.commands[-1])[1:])
    lacking = len(untranslated("it"))  # before a release others may have none yet
    listed = translation.python(*tests)
    assert listed.returncode == 0 and f"{lacking + 1} without a translation" in listed.stdout
    assert lacking or new in listed.stdout
    assert translation.python(*tests, RELEASE="1").returncode == 1
    translation.python(*shlex.split(translation.commands[0])[1:])
    path = translation.file("contralbero.po")
    entry = re.compile(r'(msgid ""\n(?:"[^\n]*"\n)*?"[^\n]*is a trial(?:[^\n]*"\n"?)*?)msgstr ""\n')
    filled, count = entry.subn(
        r'\1msgstr "Il gioco è una prova a {reference}."' + "\n", path.read_text(encoding="utf-8")
    )
    assert count == 1
    path.write_text(filled, encoding="utf-8")
    translation.run(**({} if lacking else {"RELEASE": "1"}))
    assert "Il gioco è una prova a" in translation.report("--lang", "it")
