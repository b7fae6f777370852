"""What must hold for any gears: lengths scale with the module, driver and driven may be exchanged, sums close."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.gears import formulas as f
from calc.gears import solve
from calc.gears.measures import formulas as m
from calc.gears.result import MeshResult
from calc.library.catalogue import materials
from calc.sheet.quantity import published
from tests.calc.gears.trains import SPEED, mesh, train, wheel

LENGTHS_OF_WHEEL = (
    "reference_diameter",
    "base_diameter",
    "tip_diameter",
    "root_diameter",
    "form_diameter",
    "tip_thickness",
    "tip_thickness_normal",
    "over_balls",
    "chordal_thickness",
    "chordal_height",
    "span_length",
)
LENGTHS_OF_MESH = (
    "centre_distance",
    "working_diameter_driver",
    "sap_diameter_driven",
    "tip_clearance_driver",
    "backlash_min",
    "backlash_max",
    "line_of_action",
)
NUMBERS_OF_MESH = (
    "transverse_contact_ratio",
    "overlap_ratio",
    "working_pressure_angle",
    "specific_sliding_driver",
    "specific_sliding_driven",
)


@st.composite
def pairs(draw):
    """Two wheels that mesh well, as keywords."""
    z = draw(st.tuples(st.integers(18, 70), st.integers(18, 70)))
    x = draw(st.tuples(st.floats(0.0, 0.4), st.floats(0.0, 0.4)))
    return dict(z=z, x=x, beta=draw(st.floats(0, 30)), m_n=draw(st.floats(0.8, 8)), b=draw(st.floats(5, 25)))


def gears(pair, scale=1.0, swapped=False, allowance=(-20, -30)):
    names = ["a", "b"][:: -1 if swapped else 1]
    thin = tuple(e * scale * pair["m_n"] for e in allowance)
    wheels = [
        wheel(n, z, x, cut=0.05 * scale * pair["m_n"], allowance=thin) for n, z, x in zip("ab", pair["z"], pair["x"])
    ]
    meshes = [mesh(*names, tolerance=10 * scale * pair["m_n"])]
    m_n = scale * pair["m_n"]
    return train(
        wheels, meshes, m_n=m_n, beta=pair["beta"], b=scale * pair["m_n"] * pair["b"], tool=(1.25, 0.3), ball=1.75 * m_n
    )


def one(train_):
    t = solve.geometry(train_, SPEED).result
    return t, next(iter(t.meshes.values()))


@given(pairs(), st.floats(0.1, 10))
@settings(max_examples=30, deadline=None)
def test_lengths_scale_with_the_module(pair, scale):
    small, mesh_s = one(gears(pair))
    large, mesh_l = one(gears(pair, scale))
    for name in ("a", "b"):
        for length in LENGTHS_OF_WHEEL:
            assert getattr(large.wheels[name], length) == pytest.approx(
                scale * getattr(small.wheels[name], length), rel=1e-9, abs=1e-12
            )
    for length in LENGTHS_OF_MESH:
        assert getattr(mesh_l, length) == pytest.approx(scale * getattr(mesh_s, length), rel=1e-9, abs=1e-11)
    for number in NUMBERS_OF_MESH:
        assert getattr(mesh_l, number) == pytest.approx(getattr(mesh_s, number), rel=1e-9)


@given(pairs())
@settings(max_examples=30, deadline=None)
def test_driver_and_driven_may_be_exchanged(pair):
    t, mesh_ = one(gears(pair))
    u, back = one(gears(pair, swapped=True))
    for one_, other in zip(published(t.wheels["a"], "a"), published(u.wheels["a"], "a")):
        assert one_.id == other.id and (one_.shown == other.shown or one_.id == "a.speed")
    for name in MeshResult.__dataclass_fields__:
        if name not in ("driver", "driven", "rating", "over_speed", "play_angle"):
            other = {"driver": "driven", "driven": "driver"}.get(name.rpartition("_")[2])
            mirrored = f"{name.rpartition('_')[0]}_{other}" if other else name
            assert getattr(mesh_, name) == pytest.approx(getattr(back, mirrored), rel=1e-12, abs=1e-15)
    force = 100.0
    loads = [force * w.reference_diameter / 2 for w in (t.wheels["a"], u.wheels["b"])]
    rated, mirror = (
        solve.rating(gears(pair, swapped=x is u), x, load, materials()).result for x, load in zip((t, u), loads)
    )
    assert rated.meshes["a_b"].contact_stress == pytest.approx(mirror.meshes["b_a"].contact_stress, rel=1e-12)


@given(pairs())
@settings(max_examples=30, deadline=None)
def test_thicknesses_fill_the_pitch_without_backlash(pair):
    t, mesh_ = one(gears(pair))
    alpha_t = t.system.transverse_pressure_angle
    total = 0.0
    for w, d_w in ((t.wheels["a"], mesh_.working_diameter_driver), (t.wheels["b"], mesh_.working_diameter_driven)):
        total += f.thickness_at(d_w, w.reference_thickness, w.reference_diameter, alpha_t, mesh_.working_pressure_angle)
    assert total == pytest.approx(math.pi * mesh_.working_diameter_driver / t.wheels["a"].teeth, rel=1e-12)


@given(pairs())
@settings(max_examples=30, deadline=None)
def test_contact_ratio_by_the_roll_of_either_wheel(pair):
    """From start to end of the active profile a wheel rolls ε_α pitches."""
    t, mesh_ = one(gears(pair))
    for w, rho_A in ((t.wheels["a"], mesh_.sap_curvature_driver), (t.wheels["b"], mesh_.sap_curvature_driven)):
        other = mesh_.sap_curvature_driven if w.name == "a" else mesh_.sap_curvature_driver
        roll = ((mesh_.line_of_action - other) - rho_A) / (w.base_diameter / 2)
        assert roll * w.teeth / (2 * math.pi) == pytest.approx(mesh_.transverse_contact_ratio, rel=1e-12)
        assert mesh_.line_of_action - other <= w.tip_curvature * (1 + 1e-12)
    assert mesh_.total_contact_ratio == pytest.approx(mesh_.transverse_contact_ratio + mesh_.overlap_ratio)


@given(pairs())
@settings(max_examples=30, deadline=None)
def test_sliding_is_that_of_the_two_flanks(pair):
    """ζ = (v_own − v_mate)/v_own with speeds ω·ρ, and 0 in the pitch point."""
    _, mesh_ = one(gears(pair))
    T, z_1, z_2 = mesh_.line_of_action, *pair["z"]
    own, mate = mesh_.sap_curvature_driver / z_1, (T - mesh_.sap_curvature_driver) / z_2
    assert mesh_.specific_sliding_driver == pytest.approx(1 - mate / own)
    assert f.specific_sliding(T, T * z_1 / (z_1 + z_2), z_1, z_2) == pytest.approx(0, abs=1e-12)


@given(pairs(), st.integers(1, 10))
@settings(max_examples=30, deadline=None)
def test_one_more_tooth_in_the_span_is_one_base_pitch(pair, k):
    t, _ = one(gears(pair))
    s, w = t.system, t.wheels["a"]
    spans = [m.span(s.m_n, s.alpha_n, n, w.teeth, s.transverse_pressure_angle, w.profile_shift) for n in (k, k + 1)]
    assert spans[1] - spans[0] == pytest.approx(math.pi * s.m_n * math.cos(s.alpha_n), rel=1e-12)


@given(pairs(), st.floats(-60, -1))
@settings(max_examples=30, deadline=None)
def test_a_thinned_tooth_measures_as_one_with_less_shift(pair, E):
    """Span and balls at an allowance are those of a wheel made with x_E."""
    t, _ = one(gears(pair, allowance=(0, E)))
    w, s = t.wheels["a"], t.system
    x_E = m.generating_shift(w.profile_shift, w.allowance[1], s.m_n, s.alpha_n)
    direct = m.span(s.m_n, s.alpha_n, w.span_teeth, w.teeth, s.transverse_pressure_angle, x_E)
    assert w.span[f"span_{w.span_teeth:.0f}_min"].number == pytest.approx(direct, rel=1e-12)
    other, _ = one(gears({**pair, "x": (x_E, pair["x"][1])}, allowance=(0, 0)))
    assert w.over_balls_min == pytest.approx(other.wheels["a"].over_balls, rel=1e-12)
    assert w.root_diameter_min == pytest.approx(other.wheels["a"].root_diameter, rel=1e-12)


@given(pairs(), st.floats(0.1, 0.9))
@settings(max_examples=30, deadline=None)
def test_the_ball_touches_where_it_should(pair, share):
    t, _ = one(gears(pair))
    w, s = t.wheels["a"], t.system
    d_y = w.form_diameter + share * (w.tip_diameter - w.form_diameter)
    alpha_t, beta_b, z = s.transverse_pressure_angle, s.base_helix_angle, w.teeth
    alpha_y = f.pressure_angle_at(w.base_diameter, d_y)
    D = m.ball_for_contact(w.reference_thickness, w.reference_diameter, alpha_t, z, w.base_diameter, beta_b, alpha_y)
    alpha_K = f.angle_of_involute(
        m.ball_involute(w.reference_thickness, w.reference_diameter, alpha_t, D, w.base_diameter, beta_b, z)
    )
    assert m.ball_contact_diameter(w.base_diameter, alpha_K, D, beta_b) == pytest.approx(d_y, rel=1e-11)


@given(pairs(), st.floats(-20, 20))
@settings(max_examples=30, deadline=None)
def test_backlash_of_small_changes(pair, E):
    """j_bn = −ΣE_W ± 2·T_a·sin α_wt·cos β_b, for a tolerance of a ten-thousandth of the module."""
    E, T_a = E * 1e-6 * pair["m_n"], 1e-7 * pair["m_n"]
    wheels = [wheel(n, z, x, allowance=(E * 1e6, E * 1e6)) for n, z, x in zip("ab", pair["z"], pair["x"])]
    t, mesh_ = one(
        train(
            wheels,
            [mesh("a", "b", tolerance=T_a * 1e6)],
            m_n=pair["m_n"],
            beta=pair["beta"],
            tool=(1.25, 0.3),
            ball=None,
        )
    )
    slope = 2 * math.sin(mesh_.working_pressure_angle) * math.cos(t.system.base_helix_angle)
    assert mesh_.backlash_min == pytest.approx(-2 * E - slope * T_a, abs=2e-5 * T_a + 1e-12)
    assert mesh_.backlash_max == pytest.approx(-2 * E + slope * T_a, abs=2e-5 * T_a + 1e-12)


@given(st.floats(1e-9, 50))
def test_inverse_involute(involute):
    alpha = f.angle_of_involute(involute)
    assert math.tan(alpha) - alpha == pytest.approx(involute, rel=1e-9, abs=1e-16)


@pytest.mark.parametrize("alpha", [0.001, 0.05, math.radians(20), 1.2, 1.5])
def test_inverse_involute_of_an_angle(alpha):
    assert f.angle_of_involute(math.tan(alpha) - alpha) == pytest.approx(alpha, rel=1e-9)
