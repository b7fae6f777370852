# SPDX-License-Identifier: Apache-2.0
"""The documents: what is generated is as the program has it now, links lead somewhere, the site builds, every command
line runs."""

import importlib.util
import json
import re
import shlex
import shutil
import subprocess
import sys
import tomllib

import pytest

from assistant.usage import COMMANDS, parser
from calc.design.model import Design
from calc.sheet.quantity import keys
from tests.command import run
from tests.conftest import ROOT

DOCS = ROOT / "docs"
PAGES = [ROOT / "README.md", ROOT / "README.it.md", *sorted(DOCS.glob("*.md")), *sorted(DOCS.glob("reference/*.md"))]
LINK = re.compile(r"\]\(([^)#: ]+)(?:#[^)]*)?\)")
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NEVER = ("serve",)  # stays; the session likewise, which is a line without a command


def blocks(path, *languages):
    """The blocks of code of a page in some languages, in any where none is said."""
    return [
        code for name, code in FENCE.findall(path.read_text(encoding="utf-8")) if name in languages or not languages
    ]


def commands():
    """Every command line of a page, with the page, and with the lines of output that the page shows of it; lines of a
    page follow from one another, since some write what others read."""
    for path in PAGES:
        lines = []
        for code in blocks(path, "sh", "console"):
            prompt = code.startswith("$ ")
            for line in re.sub(r"\\\n\s*", " ", code).splitlines():
                if line.startswith("$ ") or not prompt:
                    lines.append((" ".join(line.removeprefix("$ ").split("   ")[0].split()), []))
                else:
                    lines[-1][1].append(line)
        lines = [(line, shown) for line, shown in lines if "FILE" not in line and "…" not in line]
        if lines:
            yield path.name, lines


@pytest.fixture(scope="module")
def generated():
    spec = importlib.util.spec_from_file_location("generate", DOCS / "generate.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.everything()


def test_what_is_generated_is_as_the_program_has_it(generated):
    assert len(generated) >= 10
    for name, text in generated.items():
        assert (DOCS / name).read_text(encoding="utf-8") == text, f"{name}: `python docs/generate.py` writes it anew"
    for folder in ("theory", "reference"):
        assert {f"{folder}/{path.name}" for path in (DOCS / folder).glob("*.md")} == {
            name for name in generated if name.startswith(f"{folder}/")
        }


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.name)
def test_links_lead_somewhere(path):
    for target in LINK.findall(path.read_text(encoding="utf-8")):
        assert (path.parent / target).exists(), target


def test_the_readme_is_a_page():
    assert all(
        len((ROOT / name).read_text(encoding="utf-8").splitlines()) <= 150 for name in ("README.md", "README.it.md")
    )


def test_the_page_of_the_installation_says_what_is_installed():
    """Its extras are those that there are, its top-level names those that are packed."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    extras, page = project["project"]["optional-dependencies"], (DOCS / "install.md").read_text(encoding="utf-8")
    rows = page.partition("| extra | for |")[2].partition("\n\n")[0]
    assert set(re.findall(r"`(\w+)`", "".join(re.findall(r"^\|([^|]*)\|", rows, re.M)))) == set(extras)
    names = page.partition("| top-level name | holds |")[2].partition("\n\n")[0]
    packed = {name.rstrip("*") for name in project["tool"]["setuptools"]["packages"]["find"]["include"]}
    assert set(re.findall(r"^\| `(\w+)` \|", names, re.M)) == packed
    for path in PAGES:
        for asked in re.findall(r"(?:\.|contralbero)\[([\w,]+)\]'", path.read_text(encoding="utf-8")):
            assert set(asked.split(",")) <= set(extras), f"{path.name}: [{asked}]"


def test_every_command_has_its_section():
    page = (DOCS / "commands.md").read_text(encoding="utf-8")
    assert set(re.findall(r"^## ([a-z]+)$", page, re.M)) == set(COMMANDS) - {"session"}


def test_code_has_a_language_and_is_not_cut():
    """A browser shows some 120 columns of it; what is set in with spaces has no language."""
    for path in PAGES:
        languages = [name for name, _ in FENCE.findall(path.read_text(encoding="utf-8"))]
        assert "" not in languages, path.name
        wide = [line for code in blocks(path) for line in code.splitlines() if len(line) > 120]
        assert wide == [], path.name


def test_a_cell_of_a_table_has_no_bar_in_its_code():
    """Some renderers show the backslash before it, others end the cell there."""
    for path in PAGES:
        prose = FENCE.sub("", path.read_text(encoding="utf-8"))
        rows = [line for line in prose.splitlines() if line.startswith("|")]
        assert [row for row in rows if re.search(r"`[^`|]*\\\|[^`]*`", row)] == [], path.name


def unknown(table, inputs, path=""):
    """The keys of a piece of a design that the program does not know there."""
    for key, value in table.items():
        entry = keys(inputs).get(key)
        if entry is None:
            yield f"{path}{key}"
        elif entry.about.table is not None:
            for part in value if isinstance(value, list) else [value]:
                yield from unknown(part, entry.about.table, f"{path}{key}.")


def test_every_piece_of_a_design_is_one():
    """It is TOML, and its keys are known where they stand; … stands for a number that is left to the reader."""
    pieces = [(path.name, code) for path in PAGES for code in blocks(path, "toml")]
    assert len(pieces) >= 25
    for name, code in pieces:
        table = tomllib.loads(code.replace("= …", "= 0"))
        if "step" not in table:  # no replay, which `contralbero replay` reads
            assert list(unknown(table, Design)) == [], name


def test_every_piece_of_python_is_one():
    """Those of docs/python.md run in tests/test_library.py."""
    pieces = [(path.name, code) for path in PAGES for code in blocks(path, "python")]
    assert pieces
    for name, code in pieces:
        compile(code, name, "exec")


WRITTEN_BY_THE_PROGRAM = {"validation.md", "checks.md", "errata.md", "speed.md", "laws.md"}  # lists and tables, mostly
MOST_WORDS = 40


def sentences(page):
    """Those of the paragraphs and lists of a page; a piece of code or a link counts as a word or as its own words."""
    prose = re.sub(r"^[|#!].*$", "", FENCE.sub("", page), flags=re.MULTILINE)
    for paragraph in re.split(r"\n\s*\n|\n(?=- |\d+\. )", prose):
        words = re.sub(r"\]\([^)]*\)", "]", re.sub(r"`[^`]*`", "CODE", " ".join(paragraph.split())))
        yield from filter(None, re.split(r"(?<=[.!?])\)?\s+(?=[A-Z0-9\[*(])", words))


def test_a_sentence_is_counted_to_its_end():
    page = "One two (three). Four `a b. C d` five\nsix. [Seven eight](a.md). Nine\n\n- ten\n- eleven\n\n| twelve. |\n"
    assert [len(sentence.split()) for sentence in sentences(page)] == [3, 4, 2, 1, 2, 2]


@pytest.mark.parametrize(
    "path",
    [ROOT / "README.md", *(p for p in sorted(DOCS.glob("*.md")) if p.name not in WRITTEN_BY_THE_PROGRAM)],
    ids=lambda path: path.name,
)
def test_sentences_are_short(path):
    long = [s for s in sentences(path.read_text(encoding="utf-8")) if len(s.split()) > MOST_WORDS]
    assert long == [], f"{path.name}: at most {MOST_WORDS} words"


def test_the_site_builds_strictly(tmp_path):
    pytest.importorskip("mkdocs")
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "-q", "-d", str(tmp_path / "site")],
        cwd=ROOT,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "site" / "theory" / "gears.html").is_file()
    found = json.loads((tmp_path / "site" / "search" / "search_index.json").read_text(encoding="utf-8"))["docs"]
    assert any("overdesign_percent" in entry["title"] and "in %" in entry["text"] for entry in found)
    for page in (tmp_path / "site").rglob("*.html"):
        asked = re.findall(r"<(?:script|link|img)[^>]+(?:src|href)=\"(https?:[^\"]+)", page.read_text(encoding="utf-8"))
        assert asked == [], f"{page.name} asks other hosts"


def _run(lines, folder):
    """In a folder with the shipped designs; a limit that fails is no mistake of the page.  What a page shows of the
    output stands there line by line, in that order; … is what it leaves out."""
    shutil.copytree(ROOT / "designs", folder / "designs")
    shutil.copy(ROOT / "designs" / "r753ie4_gamma.toml", folder / "gamma.toml")
    for line, shown in lines:
        program, *arguments = shlex.split(line, comments=True) or [""]
        if program == "cp":
            shutil.copy(folder / arguments[0], folder / arguments[1])
        if program != "contralbero":
            continue
        if not arguments or arguments[0].startswith("-") or arguments[0] in NEVER:
            continue
        if arguments[:1] == ["new"] and arguments[1:]:  # which leaves alone what is there
            (folder / arguments[1]).unlink(missing_ok=True)
        done = run(*arguments, cwd=folder)
        assert done.returncode in (0, 1, 3), f"{line}: {done.stderr}"
        printed = iter(done.stdout.splitlines() + done.stderr.splitlines())
        for part in (part.rstrip() for part in shown if part.strip() != "…"):
            begins = part.endswith(" …")
            wanted = part.removesuffix(" …")
            assert any(said.rstrip() == wanted or (begins and said.startswith(wanted)) for said in printed), (
                f"{line} does not print, or not there: {part}"
            )


@pytest.mark.parametrize("page, lines", list(commands()), ids=lambda x: x if isinstance(x, str) else "")
def test_every_command_line_is_understood(page, lines):
    """Its command and its options are those of today; nothing is run."""
    for line, _ in lines:
        program, first, *rest = [*shlex.split(line, comments=True), "", ""]
        if program != "contralbero":
            continue
        if first in COMMANDS:
            assert parser(first).parse_known_args([first, *filter(None, rest)])[1] == [], line
        else:
            assert first.startswith("-") or first.endswith(".toml") or not first, line


@pytest.mark.slow
@pytest.mark.parametrize("page, lines", list(commands()), ids=lambda x: x if isinstance(x, str) else "")
def test_every_command_line_runs(page, lines, tmp_path):
    _run(lines, tmp_path)
