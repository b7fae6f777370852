# SPDX-License-Identifier: Apache-2.0
"""What is said about the inputs: every number says what it means, and what is usual stands with its source and fits
what is shipped."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from calc.design.model import STEPS
from calc.design.toml_file import design, parse, read
from calc.design.unusual import told, unusual
from calc.sheet.quantity import Quantity, keys
from calc.studies.shipped import DESIGNS, engine_design, engines, shipped_name
from tests.conftest import RUN_FILES, SHIPPED

NUMBERS = ("number", "integer", "series", "integers")
USUAL = 99  # quantities with a usual range: none of them is to be lost


def quantities(cls: type, prefix: str) -> Iterator[tuple[str, Quantity]]:
    for key in keys(cls).values():
        if key.about.table is not None:
            yield from quantities(key.about.table, f"{prefix}.{key.key}")
        elif key.about.kind in NUMBERS:
            yield f"{prefix}.{key.key}", key.about


ALL = dict(pair for step in STEPS for pair in quantities(step.inputs, step.key))


def unusual_of(text: str) -> dict[str, float]:
    return {one.key: one.number for one in unusual(design(parse(text.encode(), "x.toml", RUN_FILES)))}


@pytest.mark.parametrize("key", ALL)
def test_every_number_says_what_it_means(key: str) -> None:
    said = ALL[key].help
    assert len(said) >= 10 and said.endswith(".") and not said.endswith("..") and "  " not in said
    assert not said.startswith("Left out"), "what it means comes before what is taken instead"
    assert said.count("Left out: ") <= 1  # a report quotes what stands behind it


@pytest.mark.parametrize("key", [key for key, about in ALL.items() if about.usual is not None])
def test_what_is_usual_is_allowed_and_has_a_source(key: str) -> None:
    about = ALL[key]
    assert about.usual is not None and about.source
    low, high = about.usual
    assert low < high
    assert about.low is None or about.low <= low
    assert about.above is None or about.above < low
    assert about.high is None or high <= about.high
    assert (low, high) != (about.low, about.high), "all that is allowed is usual"


def test_no_usual_range_is_lost() -> None:
    assert len({id(about) for about in ALL.values() if about.usual is not None}) >= USUAL


def test_sources_are_named_without_a_stop() -> None:
    """They stand in brackets inside a sentence."""
    assert [
        key
        for key, about in ALL.items()
        if about.source.endswith((".", ",", ":")) or about.source != about.source.strip()
    ] == []


@pytest.mark.parametrize("path", SHIPPED, ids=shipped_name)
def test_what_is_shipped_is_usual(path: Path) -> None:
    """But for the allowance of one wheel, which the thesis prints in two ways; as printed in the table the pair can
    jam."""
    found = unusual_of(path.read_text(encoding="utf-8"))
    assert found.items() <= {"gears.wheels.central.span_allowance_um": -2.0}.items()


LONG = ("twin-180", "twin-270", "twin-360", "v2-45")  # whose rules look at many trains


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.slow) if name in LONG else name
        for name in engines()
        if name not in ("r753ie4", "inline-4-cross")
    ],
)
def test_what_a_design_is_begun_with_is_usual(name: str) -> None:
    """But for the clearance of fast journals, which are wider than usual so as not to grow hot; `check` says it."""
    wide = "clearance_factor"
    assert {key: number for key, number in unusual_of(engine_design(name)).items() if not key.endswith(wide)} == {}


def test_what_is_unusual_is_found() -> None:
    text = (DESIGNS / "r753ie4_gamma.toml").read_text(encoding="utf-8")
    changed = text.replace("clearance_factor = 0.8\n", "clearance_factor = 0.9\n").replace(
        "[0.15625, 0.11501]", "[0.15625, 0.3]"
    )
    found = unusual_of(changed.replace("bore_mm = 94.0", "bore_mm = 0.094"))
    assert found.pop("gears.wheels.central.span_allowance_um") == -2.0  # as in the file
    assert found == {
        "engine.bore_mm": 0.094,
        "shafts.shaft.bearings.rear.slope_mrad": 0.3,
        "shafts.shaft.bearings.front.clearance_factor": 0.9,
    }


def test_what_is_unusual_is_told_with_its_range_and_a_long_list_by_its_first() -> None:
    changed = (
        read(DESIGNS / "r753ie4_sized.toml")
        .with_value("engine.bore_mm", 0.094)
        .with_value("bearings.front.diameter_mm", 360.0)
    )
    found = unusual(design(changed))
    # the furthest first, in ranges
    first, second = ("front diameter 360 mm (usual 15 to 120)", "bore 0.094 mm (usual 50 to 150)")
    assert told(found) == f"2 inputs are not usual: {first}; {second}"
    assert told(found, 1) == f"2 inputs are not usual: {first}; 1 more"
    assert told([]) == ""
    assert unusual(design(changed), ["gears"]) == []
    cold = read(DESIGNS / "r753ie4_gamma.toml").with_value("engine.bench.1.oil_temperature_C", 10.0)
    assert "engine.bench.1.oil_temperature_C" in [one.key for one in unusual(design(cold))]
