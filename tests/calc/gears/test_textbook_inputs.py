"""What the gears of textbooks are given by: the transverse module; and what is refused, with the reason."""

import math
import re
from pathlib import Path

import pytest

from calc.design.toml_file import design, parse
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.explain import Chains

TEXT = (Path(__file__).parents[3] / "designs" / "r753ie4_gamma.toml").read_text(encoding="utf-8")
MODULE = re.search(r"normal_module_mm = ([\d.]+)", TEXT)
HELIX = re.search(r"helix_angle_deg = ([\d.]+)", TEXT)


def errors(text):
    with pytest.raises(BadInput) as caught:
        design(parse(text.encode(), "d.toml"))
    return str(caught.value)


def test_a_train_by_its_transverse_module():
    """m_t = m_n/cos β: every value of the gears is the same."""
    m_t = float(MODULE[1]) / math.cos(math.radians(float(HELIX[1])))
    by_normal, by_transverse = (
        solve(design(parse(text.encode(), "d.toml")))
        for text in (TEXT, TEXT.replace(MODULE[0], f"transverse_module_mm = {m_t!r}"))
    )
    one, other = (
        {id: v.shown for id, v in results.values().items() if id.startswith("gears.")}
        for results in (by_normal, by_transverse)
    )
    assert one == pytest.approx(other, rel=1e-6, abs=1e-5) and len(one) > 200
    keys = {key for link in Chains(by_transverse).of("gears.crank.tip_diameter") for key in link.inputs}
    assert "gears.transverse_module_mm" in keys and "gears.normal_module_mm" not in keys


@pytest.mark.parametrize(
    "new, wanted",
    [
        (
            "",
            [
                "gears.normal_module_mm",
                "is missing; needs a number above 0 and up to 100 mm, or transverse_module_mm instead",
            ],
        ),
        (f"{MODULE[0]}\ntransverse_module_mm = 2.4", ["gears.transverse_module_mm: 2.4", "leave one of the two out"]),
        ("transverse_module_mm = -2.0", ["gears.transverse_module_mm: -2.0: must be a number above 0"]),
    ],
)
def test_the_module_is_given_once(new, wanted):
    said = errors(TEXT.replace(MODULE[0], new))
    assert all(part in said for part in wanted), said


@pytest.mark.parametrize(
    "old, new, key",
    [
        (r"teeth = \d+", "teeth = -70", "gears.wheels.crank.teeth: -70: must be a whole number from 5 to 1000; "),
        (r"teeth = \d+", "teeth = 70\ninternal = true", "gears.wheels.crank.internal: "),
        (r"driven = ", "internal = true\ndriven = ", "gears.meshes.0.internal: "),
        (
            r"centre_distance_mm = [\d.]+",
            "centre_distance_mm = -40.0",
            "centre_distance_mm: -40.0: must be a number above 0 and up to 5000 mm; ",
        ),
    ],
)
def test_internal_gears_are_refused_with_the_reason(old, new, key):
    said = errors(re.sub(old, new, TEXT, count=1))
    assert f"{key}internal gears are not computed: contact, interference" in said, said


def test_too_few_teeth_are_no_internal_gear():
    assert "internal" not in errors(re.sub(r"teeth = \d+", "teeth = 3", TEXT, count=1))
