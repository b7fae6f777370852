# SPDX-License-Identifier: Apache-2.0
"""Which balancing an engine calls for, and what each leaves: by hand, and against designs that carry it out."""

import pytest

from calc.design.toml_file import Document, design, parse
from calc.solve import solve
from calc.studies.shipped import engine_design
from calc.studies.starter.balancing import options, what_shakes, with_imbalance
from calc.studies.starter.build import built, choice_made

CALLED = {
    "single": "shaft",
    "twin-360": "shaft",
    "twin-180": "shaft",
    "inline-3": "shaft",
    "inline-5": "shaft",
    "v6-90": "shaft",
    "boxer-2": "shaft",
    "inline-4": "second",
    "inline-6": "none",
    "v12-60": "none",
    "boxer-6": "none",
    "v2-90": "half",
    "v8-cross": "half",
    "v6-60": "half",
}


def engine(name: str) -> Document:
    """The engine alone: what its crank carries is not yet said."""
    data = parse(engine_design(name).encode("utf-8"), name).data
    return Document({key: data[key] for key in ("schema", "name", "engine")})


LONG = ("inline-5", "single", "twin-180", "twin-360", "v6-90")


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if name in LONG else name for name in CALLED]
)
def test_one_balancing_is_called_for(name: str) -> None:
    offered = options(engine(name))
    assert [one.id for one in offered if one.called_for] == [CALLED[name]]
    assert offered[0].id == "none" and all(str(one.why).count(".") == 1 or ". " in str(one.why) for one in offered)


def test_a_shaft_takes_what_the_half_on_the_crank_leaves() -> None:
    """Of an inline three: half of the couple by the crank, the other half by the shaft, order 2 by neither."""
    by_id = {one.id: {left.key: left for left in one.left} for one in options(engine("inline-3"))}
    whole = by_id["none"]["order_1_couple"]
    assert whole.before == whole.after and whole.unit == "N·m"
    assert by_id["half"]["order_1_couple"].after == pytest.approx(whole.before / 2)
    assert by_id["shaft"]["order_1_couple"].after == 0
    assert by_id["shaft"]["order_2_couple"].after == by_id["none"]["order_2_couple"].before
    assert "order_1_force" not in whole.key and set(by_id["none"]) == {"order_1_couple", "order_2_couple"}


def test_what_offsets_turn_from_the_pins_is_not_said_to_be_taken() -> None:
    """A VR6: half on the crank leaves more of what turns forward than there was, and the shaft at −ω as much."""
    vr6 = engine("v6-60").with_value("engine.gas", None)  # which is that of cylinders of one motion
    for key, value in {
        "bank_angle_deg": 10.8,
        "bank_of_cylinder": [0, 1, 0, 1, 0, 1],
        "firing_order": [1, 5, 3, 6, 2, 4],
        "axial_positions_mm": [-162.5, -97.5, -32.5, 32.5, 97.5, 162.5],
        "cylinder_offset_mm": -22.0,
        "cylinder_offsets_mm": [-22.0, 22.0] * 3,
    }.items():
        vr6 = vr6.with_value(f"engine.{key}", value)
    by_id = {one.id: one for one in options(vr6)}
    bare, half = (by_id[id].left[0] for id in ("none", "half"))
    assert half.what == "couple of order 1" and half.after > bare.after
    for id in ("half", "shaft"):
        assert "leaves much of what turns forward" in by_id[id].why
    assert "leaves much" not in "".join(one.why for one in options(engine("inline-3")))


SLOW_PAIR = pytest.param("twin-360", "pair", marks=pytest.mark.slow)


@pytest.mark.parametrize(
    "name, id", [("inline-4", "second"), pytest.param("inline-3", "shaft", marks=pytest.mark.slow), SLOW_PAIR]
)
def test_the_mass_is_about_that_of_the_shafts_that_are_built(name: str, id: str) -> None:
    """About, because the core that bending asks for is thicker than the one that is estimated with."""
    there = engine(name)
    option = next(one for one in options(there) if one.id == id)
    made = built(there, "countershaft", id)
    results = solve(design(made))
    shaft = results.outcomes["countershaft"].result
    shafts = len(design(made).shafts)
    if shafts > 1:
        shaft = shaft.shafts["left"]  # type: ignore[attr-defined]
    assert choice_made(made) == id
    assert option.mass == pytest.approx(shafts * shaft.eccentric_mass, rel=0.1)  # type: ignore[attr-defined]
    assert {outcome.verdict for outcome in results.outcomes.values()} == {"computed", "pass", "not_asked"}
    assert results.verdict == "pass"


def test_what_shakes_is_said_in_few_words() -> None:
    assert str(what_shakes(with_imbalance(engine("inline-6")))) == "nothing of order 1 or 2"
    said = str(what_shakes(with_imbalance(engine("inline-4"))))
    assert said.startswith("force of order 2: ") and said.endswith(" N") and "order 1" not in said


def test_shafts_that_are_no_mirror_images_are_offered_and_not_built() -> None:
    """A flat-plane V8 at 90° shakes sideways: its shafts at ±2 are not one and its mirror image about the vertical."""
    second = next(one for one in options(engine("v8-flat")) if one.id == "second")
    assert second.mass is None and "write each as a shaft of its own" in str(second.why)
    assert {left.key: left.after for left in second.left} == {"order_2_force": 0}
