"""The figures of a train: every mesh can be looked at, both wheels of the tightest by themselves."""

import math

import numpy as np
import pytest

from calc.gears.curves import curves
from tests.calc.gears.trains import mesh, pair_1, r753, solved, train, wheel


@pytest.fixture(scope="module")
def whole():
    return solved(r753())


@pytest.fixture(scope="module")
def drawn(whole):
    return {curve.id: curve for curve in curves(whole)}


def test_every_mesh_is_drawn_and_the_tightest_comes_first(whole, drawn):
    assert list(drawn)[:4] == ["profile_central_idler", "sliding", "tooth_central", "tooth_idler"]
    assert {f"profile_{key}" for key in whole.meshes} <= set(drawn) and len(drawn) == 6
    assert list(c.id for c in curves(whole, "idler_shaft"))[:4] == [
        "profile_idler_shaft",
        "sliding",
        "tooth_idler",
        "tooth_shaft",
    ]


def test_curves_are_small_and_in_true_scale(drawn):
    for curve in drawn.values():
        assert sum(len(s.x) for s in curve.series) < 1500
        assert curve.equal == (curve.id != "sliding")
        assert all(np.isfinite(s.x).all() and np.isfinite(s.y).all() for s in curve.series)


def test_the_path_of_contact_is_as_long_as_the_contact_ratio_says(whole, drawn):
    for key, m in whole.meshes.items():
        path = drawn[f"profile_{key}"].series[-1]
        assert path.label == "path of contact"
        length = math.hypot(path.x[1] - path.x[0], path.y[1] - path.y[0]) * 1e-3
        assert length / whole.system.base_pitch == pytest.approx(m.transverse_contact_ratio)


def test_the_tip_circles_stand_about_their_wheels_and_end_the_path_of_contact(whole, drawn):
    """Contact begins on the driven wheel's tip circle and ends on the driver's."""
    for key, m in whole.meshes.items():
        below, _, *tips, path = drawn[f"profile_{key}"].series
        centres = -1j * m.working_diameter_driver / 2, 1j * m.working_diameter_driven / 2
        for name, circle, centre, touched in zip((m.driver, m.driven), tips, centres, (-1, 0)):
            assert circle.label == f"tip circle of {name}"
            radius = whole.wheels[name].tip_diameter / 2
            assert np.abs(circle.x + 1j * circle.y - centre * 1e3) == pytest.approx(radius * 1e3)
            assert np.abs(circle.x + 1j * circle.y).min() == pytest.approx(abs(radius - abs(centre)) * 1e3), (
                "at the pitch point"
            )
            assert abs(path.x[touched] + 1j * path.y[touched] - centre * 1e3) == pytest.approx(radius * 1e3)
            assert min(circle.x) < min(path.x) and max(path.x) < max(circle.x)
        assert max(np.abs(below.x + 1j * below.y - centres[0] * 1e3)) == pytest.approx(
            whole.wheels[m.driver].tip_diameter * 500
        )


def test_sliding_shows_one_mesh_at_a_time(whole, drawn):
    curve = drawn["sliding"]
    assert curve.variants == ("central–idler", "crank–central", "idler–shaft")
    for key, m in whole.meshes.items():
        own = [s for s in curve.series if s.variant == f"{m.driver}–{m.driven}"]
        assert [s.label for s in own] == [m.driver, m.driven], key
        assert [min(s.y[0], s.y[-1]) for s in own] == pytest.approx(
            [m.specific_sliding_driver, m.specific_sliding_driven]
        )
    single = {c.id: c for c in curves(solved(pair_1()))}["sliding"]
    assert single.variants == () and "central–idler" in single.title


def test_a_tooth_has_its_four_regions_joined_and_a_mirrored_flank(whole, drawn):
    curve, w = drawn["tooth_idler"], whole.wheels["idler"]
    assert [s.label for s in curve.series] == ["root", "fillet", "involute", "tip", "other flank"]
    for one, following in zip(curve.series[:3], curve.series[1:4]):
        assert (one.x[-1], one.y[-1]) == pytest.approx((following.x[0], following.y[0]), abs=1e-9)
    radius = [float(np.hypot(s.x[0], s.y[0])) for s in curve.series[:4]]
    circles = [w.root_diameter, w.root_diameter, w.form_diameter, w.tip_diameter]
    assert radius == pytest.approx([d / 2 * 1e3 for d in circles], rel=1e-9)
    right = np.concatenate([s.x for s in curve.series[:4]])
    assert np.allclose(curve.series[4].x, -right) and right.min() >= -1e-12


def test_a_pair_of_one_mesh_has_one_view_of_it():
    t = solved(train([wheel("a", 20, 0.1), wheel("b", 30, 0.0)], [mesh("a", "b")], beta=0.0))
    assert [c.id for c in curves(t)] == ["profile_a_b", "sliding", "tooth_a", "tooth_b"]
