"""What a design is about, in a line for each of its steps: the same lengths as its values, in words that fit the
number."""

import pytest

from calc.design.key_results import key_results
from calc.design.toml_file import Document, design, read
from calc.draw.drawing import Dimension
from calc.engine.sketch import sketch
from calc.locale import language
from calc.solve import solve
from calc.studies.described import described, not_counted
from calc.studies.load_cases import load_cases
from calc.studies.shipped import EXAMPLE
from tests.conftest import DESIGNS

ENGINE = {
    "name": "one",
    "layout": "inline",
    "cylinders": 1,
    "strokes": 4,
    "bore_mm": 85.0,
    "crank_radius_mm": 36.0,
    "rod_length_mm": 112.0,
    "cylinder_pitch_mm": 100.0,
    "reciprocating_masses_kg": [0.42],
    "rotating_masses_kg": [0.3],
    "rated_speed_rpm": 8000.0,
}


def document(**engine: object) -> Document:
    return Document({"schema": 1, "name": "d", "engine": {**ENGINE, **engine}})


@pytest.mark.parametrize("offset", [0.0, -30.0, 70.0])
def test_the_stroke_of_an_offset_cylinder_is_not_twice_the_crank_radius(offset: float) -> None:
    asked = design(document(cylinder_offset_mm=offset))
    found = f"{solve(asked).values()['engine.stroke'].shown:.4g}"
    (line,) = (str(words) for _, words in described(asked) if "stroke" in words)
    assert line.endswith(f"stroke {found} mm")
    assert f"s {found}" in [str(mark.label) for mark in sketch(asked).primitives if isinstance(mark, Dimension)]
    assert (found == "72") == (offset == 0)


@pytest.mark.parametrize("told", [("en", "1 cylinder, ", "3 cylinders, "), ("it", "1 cilindro, ", "3 cilindri, ")])
def test_one_cylinder_is_not_several(told: tuple[str, str, str]) -> None:
    code, one, three = told
    say = language(code)
    assert one in say(next(iter(described(design(document()))))[1])
    assert three in say(next(iter(described(design(document(cylinders=3)))))[1])


def test_what_is_not_counted_is_of_the_steps_that_are_asked_and_leaves_with_its_key() -> None:
    example = read(EXAMPLE)
    every = not_counted(design(example))
    assert {"alignment of the bores", "torsion of the shaft", "slope of the shaft at its wheel"} <= set(every)
    assert len(set(every)) == len(every) == 10
    assert not_counted(design(document())) == ()
    no_shaft = Document({key: table for key, table in example.data.items() if key in ("schema", "name", "gears")})
    gears = ("slope of the shaft at its wheel", "wear of the teeth")
    assert not_counted(design(no_shaft.with_value("gears.speed_rpm", 2600.0))) == gears
    part = example.with_value("gears.meshes.0.shaft_deflection_um", 1.0)
    assert not_counted(design(part)) == every  # of one mesh of several
    whole = example
    for n in range(len(example.data["gears"]["meshes"])):
        whole = whole.with_value(f"gears.meshes.{n}.shaft_deflection_um", 1.0)
    assert set(every) - set(not_counted(design(whole))) == {"slope of the shaft at its wheel"}


def test_what_mounts_leave_out_and_which_severity_nobody_judges_is_told() -> None:
    of_set = read(DESIGNS / "generating_set_mounting.toml")
    every = not_counted(design(of_set))
    assert "bending of engine and frame" in every and any("class of the machine" in words for words in every)
    classed = of_set.with_value("mounting.machine_class", 5)
    assert not any("class of the machine" in words for words in not_counted(design(classed)))
    assert not any("no standard" in words for words in every)
    assert any("no standard" in words for words in not_counted(design(read(DESIGNS / "twin_mounting.toml"))))


def test_mounts_load_by_their_worst_operation_with_the_severity_and_its_limit() -> None:
    results = solve(design(read(DESIGNS / "generating_set_mounting.toml")))
    told = {str(title): str(words) for title, words in load_cases(results)}["Mounting"]
    assert told == (
        "at rated, 1500 rpm, order 2 drives most; the mounts pass on 186.7 N, rms; "
        "severity at head-front, rated: 40.59 mm/s, at most 45 mm/s (ISO 8528-9)"
    )
    severity = [check.value for check in results.checks() if check.id.endswith("severity")]
    assert max(severity) == pytest.approx(40.59 / 45, rel=1e-3)
    known = {str(value.label): value for value in key_results(results.values()).values()}
    assert known["Velocity, rms"].id == "mounting.rated.half.head-front.velocity"
