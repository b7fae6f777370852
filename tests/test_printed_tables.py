"""Tables of a step, as `check` prints them and gives them in JSON."""

import json
from dataclasses import replace
from pathlib import Path

from assistant.results_text import print_results, results_json, table_lines
from calc.design.toml_file import design, parse
from calc.sheet.step import Table
from calc.solve import Results, solve
from tests.conftest import GAMMA

LONG = "counterweights on the crank that carry one half of all reciprocating masses"
TABLE = Table(
    "remedies",
    "Before and after",
    (("Remedy", ""), ("Couple left of first order", "N·m"), ("Phase", "°"), ("Said", "")),
    (("none", 572.92134, 30, None), (LONG, float("inf"), -1.25e-7, "turns back"), ("shaft", float("nan"), None, "–")),
    "At rated speed.",
)


def with_table():
    document = parse(Path(GAMMA).read_bytes(), str(GAMMA))
    solved = solve(design(document))
    outcome = replace(solved.outcomes["engine"], tables=(TABLE,))
    return document, Results(solved.design, {**solved.outcomes, "engine": outcome})


def test_a_table_is_printed_with_aligned_columns():
    lines = table_lines(TABLE)
    assert lines[0] == TABLE.title and lines[-1].strip() == TABLE.note
    rule = next(i for i, line in enumerate(lines) if set(line) <= set("─ "))
    assert " ".join(lines[1:rule]).split() == "Couple left of first order Phase Remedy N·m ° Said".split()
    body = lines[rule + 1 : -1]
    edges = [i + 1 for i, c in enumerate(lines[rule]) if c == "─" and lines[rule][i + 1 : i + 2] in (" ", "")]
    starts = [i for i, c in enumerate(lines[rule]) if c == "─" and lines[rule][i - 1] == " "]
    for number, column in (("572.921", 1), ("30", 2), ("−1.25·10⁻⁷", 2), ("∞", 1), ("no value", 1)):
        (line,) = [line for line in body if f" {number}" in line]
        assert line.index(number) + len(number) == edges[column]
    for words, column in (("none", 0), ("turns back", 3), ("shaft", 0), ("–", 3)):
        assert any(line[starts[column] :].startswith(words) for line in body)
    assert " ".join(line[starts[0] : edges[0]].strip() for line in body[1:-1]).split() == LONG.split(), (
        "wrapped, not shortened"
    )
    assert all(len(line) <= 120 for line in lines) and "None" not in "".join(lines)


def test_tables_without_rows_or_of_any_width_are_printed():
    wide = Table("w", "Wide", tuple((f"column {i}", "mm") for i in range(40)), (tuple(1000.5 + i for i in range(40)),))
    assert table_lines(wide)[-1].split() == [str(1000.5 + i) for i in range(40)]
    assert [line.strip() for line in table_lines(replace(wide, rows=(), columns=(("A", "mm"),)))] == [
        "Wide",
        "A",
        "mm",
        "──",
    ]


def test_check_prints_tables_after_the_values_of_their_step(capsys):
    _, results = with_table()
    print_results(results, "engine")
    printed = capsys.readouterr().out
    assert (
        printed.index("engine.lambda")
        < printed.index("\n  Before and after\n")
        < printed.index("turns back")
        < printed.index("At rated speed.")
    )
    print_results(results, "gears")
    assert "Before and after" not in capsys.readouterr().out


def test_tables_in_json():
    document, results = with_table()
    found = json.loads(json.dumps(results_json(document, results, "engine"), allow_nan=False))["tables"]
    assert found == {
        "engine.remedies": {
            "title": "Before and after",
            "columns": [
                {"label": "Remedy", "unit": ""},
                {"label": "Couple left of first order", "unit": "N·m"},
                {"label": "Phase", "unit": "°"},
                {"label": "Said", "unit": ""},
            ],
            "rows": [["none", 572.92134, 30, None], [LONG, None, -1.25e-7, "turns back"], ["shaft", None, None, "–"]],
            "note": "At rated speed.",
        }
    }
    assert "engine.remedies" not in results_json(document, results, "gears")["tables"]


# --- sweep and choose
