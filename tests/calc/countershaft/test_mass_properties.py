# SPDX-License-Identifier: Apache-2.0
"""Centre of gravity and tensor of inertia: given values, the same by quadrature, and what they leave out."""

import json
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.countershaft.mass_properties import mass_properties
from calc.countershaft.outline import Piece, outline, turning_inertia
from tests.calc.countershaft.shafts import FRONT, REAR, SEATED, outcome, result
from tests.conftest import ROOT

GIVEN = json.loads((ROOT / "tests" / "data" / "mass_properties.json").read_text(encoding="utf-8"))["given"]
CASES = {row["case"]["shaft"]: row["case"] for row in GIVEN if isinstance(row["case"], dict)}
CORE = {"core_radius_mm": 15.0, "outer_radius_mm": 40.5}
NAMES = ("xx", "yy", "zz", "xy", "yz", "zx")
RHO = 7860.0


def shape_of(case):
    """The outline of a given case."""
    pieces = []
    for p in case["pieces"]:
        half = p["half_angle_deg"]
        pieces.append(
            Piece(
                *(p[key] * 1e-3 for key in ("from_mm", "to_mm", "outer_radius_mm", "core_radius_mm")),
                None if half is None else math.radians(half),
                math.radians(p["angle_deg"]),
                "full" if half is None else "sector",
            )
        )
    return outline(tuple(pieces), False, pieces and case["pieces"][0]["bore_diameter_mm"] / 2e3)


def shown(solid):
    """The values by their names, in the units in which they are shown."""
    across = {"mass": solid.mass, "up": solid.up * 1e3, "side": solid.side * 1e3, "along": solid.along * 1e3}
    return across | {name: getattr(solid.inertia, name) * 1e6 for name in NAMES}


PLACES = {"centre_of_gravity_up": "up", "centre_of_gravity_side": "side", "centre_of_gravity": "along"}


@pytest.mark.parametrize("row", GIVEN, ids=lambda row: row["quantity"])
def test_given_values(row):
    case = row["case"]["shaft"] if isinstance(row["case"], dict) else row["case"]
    solid = shown(mass_properties(shape_of(CASES[case]), CASES[case]["density_kgm3"]))
    name = row["quantity"].split(" ")[0].removeprefix("countershaft.").removeprefix("inertia.")
    assert solid[PLACES.get(name, name)] == pytest.approx(row["is"], rel=row["rel"], abs=row.get("abs", 0.0))


# --- against quadrature

GAUSS = np.polynomial.legendre.leggauss(12)


def stretch(low, high):
    """Points and weights of Gauss' quadrature from low to high."""
    x, weights = GAUSS
    return (low + high) / 2 + (high - low) / 2 * x, (high - low) / 2 * weights


def points_of(p, rho, heavier, bore):
    """Where the mass of a piece lies: x, y, z and the mass of every point."""
    angles = np.arange(24) * math.pi / 12, np.full(24, math.pi / 12)
    rings = [(bore, p.outer_radius if p.half_angle is None else p.core_radius, *angles, 1.0)]
    if p.half_angle is not None:
        rings.append((p.core_radius, p.outer_radius, *stretch(p.angle - p.half_angle, p.angle + p.half_angle), heavier))
    for inner, outer, phi, width, times in rings:
        (r, thick), (z, long) = stretch(inner, outer), stretch(p.start, p.end)
        r, phi, z = (part.ravel() for part in np.meshgrid(r, phi, z, indexing="ij"))
        m = np.einsum("i,j,k->ijk", thick, width, long).ravel() * r * rho * times
        yield np.array([r * np.cos(phi), r * np.sin(phi), z]), m


def by_quadrature(pieces, rho, heavier, bore):
    xyz, m = map(np.hstack, zip(*(part for p in pieces for part in points_of(p, rho, heavier, bore))))
    centre = xyz @ m / m.sum()
    away = xyz - centre[:, None]
    spread = (away * m) @ away.T
    J = (np.trace(spread) * np.eye(3) - spread) * 1e6
    (x, y, z), values = centre * 1e3, (J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[1, 2], J[2, 0])
    return {"mass": m.sum(), "up": x, "side": y, "along": z} | dict(zip(NAMES, values))


def a_shaft(bore=0.0, heavier=1.0):
    pieces = (
        Piece(-0.06, -0.05, 0.012, 0.0, None, 0.0, "full"),
        Piece(-0.05, -0.01, 0.03, 0.01, 1.2, 0.7, "sector"),
        Piece(-0.01, 0.005, 0.011, 0.0, None, 0.0, "full"),
        Piece(0.005, 0.06, 0.026, 0.0095, 2.3, -2.0, "sector"),
        Piece(0.06, 0.09, 0.014, 0.0, None, 0.0, "full"),
    )
    return outline(pieces, False, bore, heavier)


@pytest.mark.parametrize("bore, heavier", [(0.0, 1.0), (0.006, 1.0), (0.0, 2.3), (0.006, 0.4)])
def test_by_quadrature(bore, heavier):
    shape = a_shaft(bore, heavier)
    expected = by_quadrature(shape.pieces, RHO, heavier, bore)
    assert shown(mass_properties(shape, RHO)) == pytest.approx(expected, rel=1e-9, abs=1e-9)


LENGTHS = st.floats(1e-3, 0.2)
A_PIECE = st.tuples(
    LENGTHS, st.floats(0.01, 0.06), st.floats(0.1, 0.9), st.none() | st.floats(0.05, math.pi), st.floats(-4, 4)
)


@settings(max_examples=60, deadline=None)
@given(st.lists(A_PIECE, min_size=1, max_size=6), st.sampled_from([0.0, 0.0005]), st.sampled_from([1.0, 1.7]))
def test_about_the_axis_and_about_the_centre_of_gravity(pieces, bore, heavier):
    """Steiner: the moment of inertia about the axis is J_zz and the mass times the square of its distance."""
    here, row = -0.2, []
    for length, R, share, half, angle in pieces:
        row.append(Piece(here, here + length, R, share * R if half else 0.0, half, angle, "sector" if half else "full"))
        here += length
    shape = outline(tuple(row), False, bore, heavier)
    solid = mass_properties(shape, RHO)
    assert solid.inertia.zz + solid.mass * (solid.up**2 + solid.side**2) == pytest.approx(
        turning_inertia(shape, RHO, ()), rel=1e-12
    )


# --- of designs


def test_static_unbalance_is_the_mass_times_the_place_of_its_centre():
    made = result(bearings=SEATED, **CORE)
    away = math.hypot(made.centre_of_gravity_up, made.centre_of_gravity_side)
    assert made.mass * away == pytest.approx(made.static_unbalance, rel=1e-9)
    assert made.inertia.zz + made.mass * away**2 == pytest.approx(made.moment_of_inertia, rel=1e-12)


def test_further_elements_are_left_out_and_said():
    extra = {"name": "pulley", "mass_kg": 1.25, "radius_mm": 10.0, "angle_deg": 45.0, "z_mm": 100.0}
    bare, more = (outcome(bearings=SEATED, extras=extras, **CORE) for extras in ([], [extra]))
    assert more.result.moment_of_inertia > bare.result.moment_of_inertia
    assert vars(more.result.inertia) == vars(bare.result.inertia)
    assert more.result.centre_of_gravity_up == bare.result.centre_of_gravity_up
    assert any("1.25 kg" in note and "leave them out" in note for note in map(str, more.notes))
    assert not any("leave them out" in note for note in map(str, bare.notes))


def test_masses_on_a_plain_outline_are_points():
    """A cylinder of 20 mm with the source's two masses on it."""
    sections = [{"from_mm": -190.0, "to_mm": 190.0, "outer_radius_mm": 20.0}]
    made = result(sections=sections)
    masses = [(m["mass_kg"], m["radius_mm"], math.radians(m["angle_deg"]), m["z_mm"]) for m in (FRONT, REAR)]
    bare = by_quadrature([Piece(-0.19, 0.19, 0.02, 0.0, None, 0.0, "full")], 7860.0, 1.0, 0.0)
    m = np.array([bare["mass"], *(mass[0] for mass in masses)])
    xyz = np.array([[0, 0, 0], *([r * math.cos(a), r * math.sin(a), z] for _, r, a, z in masses)]).T
    centre = xyz @ m / m.sum()
    away = xyz - centre[:, None]
    spread = (away * m) @ away.T
    J = np.trace(spread) * np.eye(3) - spread + np.diag([bare[name] for name in ("xx", "yy", "zz")])
    values = [getattr(made.inertia, name) * 1e6 for name in NAMES]
    assert values == pytest.approx([J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[1, 2], J[2, 0]], rel=1e-9)
    assert (made.centre_of_gravity_up * 1e3, made.centre_of_gravity_side * 1e3) == pytest.approx(tuple(centre[:2]))
    away = math.hypot(made.centre_of_gravity_up, made.centre_of_gravity_side)
    assert made.inertia.zz + made.mass * away**2 == pytest.approx(made.moment_of_inertia, rel=1e-12)


def test_a_mirror_image_has_the_other_side():
    made = result(bearings=SEATED, twin=1, **CORE)
    own, twin = made.shafts["shaft"], made.shafts["twin"]
    assert twin.centre_of_gravity_up == own.centre_of_gravity_up != 0
    assert twin.centre_of_gravity_side == -own.centre_of_gravity_side != 0
    for name in NAMES:
        turned = -1 if name in ("xy", "yz") else 1
        assert getattr(twin.inertia, name) == turned * getattr(own.inertia, name) != 0
    ids = {value.id for value in outcome(bearings=SEATED, twin=1, **CORE).values()}
    assert {"countershaft.shaft.inertia.xx", "countershaft.twin.inertia.zx"} <= ids
