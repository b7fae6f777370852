"""`contralbero oils`: all oils, one with where its values come from, and what it does not know."""

import json

import pytest

from calc.library.catalogue import oils
from tests.command import run


def test_all_oils_a_row_each():
    done = run("oils")
    assert done.returncode == 0 and done.stderr == ""
    lines = done.stdout.splitlines()
    assert max(map(len, lines)) <= 118
    assert all(any(line.startswith(f"  {name} ") for line in lines) for name in oils())
    assert [line.split()[-1] for line in lines if line.startswith("  SAE 40")] == ["medium"]


def test_one_oil_value_by_value():
    done = run("oils", "friction thesis 10W40")
    assert done.returncode == 0 and done.stderr == ""
    words = " ".join(done.stdout.split())
    for expected in (
        "93.27 mm²/s high",
        "14 mm²/s medium",
        "0.144 W/(m·K) high",
        "viscosity index about 153",
        "Viscosity index 154",
        "40 93.27 78.04",
        "120 9.289 7.361",
        "128.58 78.037",
        "rejected",
        "SAE 50; the oil has 14, SAE 40",
    ):
        assert expected in words, expected
    assert max(map(len, done.stdout.splitlines())) <= 118


def test_an_oil_without_printed_values_has_no_such_table():
    done = run("oils", "5W-30")
    assert done.returncode == 0 and "viscosities printed elsewhere" not in done.stdout and "Λ" not in done.stdout


def test_as_json():
    found = json.loads(run("oils", "--json").stdout)
    assert found["schema"] == 1 and found["program"] == "contralbero" and set(found["tables"]) == {"oils"}
    assert [row[0] for row in found["tables"]["oils"]["rows"]] == list(oils())
    one = json.loads(run("oils", "friction thesis MIL-L-23699E", "--json").stdout)
    assert one["oil"] == "friction thesis MIL-L-23699E" and set(one["tables"]) == {"oil", "oil_law", "oil_printed"}
    assert [row[5] for row in one["tables"]["oil_printed"]["rows"]] == ["rejected", "kept", "kept", "kept"]


@pytest.mark.parametrize(
    "name, words",
    [
        ("5W30", 'did you mean "5W-30"?'),
        ("sae 40", 'did you mean "SAE 40"?'),
        ("water", "known are"),
        ("", "known are"),
    ],
)
def test_an_unknown_oil_is_said_with_the_nearest(name, words):
    done = run("oils", name)
    assert done.returncode == 2 and done.stdout == "" and "Traceback" not in done.stderr
    assert done.stderr.startswith("contralbero oils: ") and words in done.stderr


def test_too_many_names_are_refused():
    assert run("oils", "SAE", "40").returncode == 2
