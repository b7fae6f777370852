# SPDX-License-Identifier: Apache-2.0
"""What each of several sized shafts takes: the given systems, and pairs that are mirror images."""

import cmath
import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.countershaft import formulas as f
from calc.countershaft.sizing.shares import asked_share, equal_share, need_mirror_images
from calc.countershaft.sizing.stretches import size_stretches, stretches
from calc.design.toml_file import Document, design
from calc.sheet.errors import NoSolution
from calc.solve import solve
from tests.conftest import ROOT

GIVEN = json.loads((ROOT / "tests" / "data" / "shafts.json").read_text(encoding="utf-8"))


def engine(case):
    """The engine's vectors of order 1, F⁺ F⁻ C⁺ C⁻, and its angular speed."""
    tables = {key: GIVEN["cases"][case][key] for key in ("name", "engine", "imbalance")}
    results = solve(design(Document({"schema": 1, **tables}))).outcomes
    return results["imbalance"].result.orders["order_1"].vectors, results["engine"].result.angular_speed


def said(case, name):
    rows = {row["value"]: row for row in GIVEN["given"] if row["case"] == case}
    row = rows[f"countershaft.{name}"]
    return pytest.approx(row["is"], rel=row.get("rel"), abs=row.get("abs"))


def test_two_repeated_shafts_take_half_each():
    """The 45° V-twin: both of its shafts, in their envelopes, carry the given force."""
    case = "v2-45-sized"
    (_, F, _, C), omega = engine(case)
    U, P = asked_share((F, C), omega, share=equal_share(k=2))
    shaft = GIVEN["cases"][case]["shafts"][0]
    R, r_0, half = (shaft[key] * 1e-3 for key in ("outer_radius_mm", "core_radius_mm", "half_length_mm"))
    found = size_stretches(U, P, omega, 7860.0, R, r_0, stretches(half, []))
    unbalance = sum(one.mass * one.radius * cmath.rect(1, one.angle) for one in found.sectors)
    assert omega**2 * abs(unbalance) == said(case, "front.force") == said(case, "back.force")
    assert unbalance == pytest.approx(-F / 2 / omega**2, rel=1e-9)


def test_a_sized_shaft_takes_what_a_given_one_leaves():
    """The 270° twin, 2 % over-designed: force, couple and its direction, and what both leave, as given."""
    case = "twin-270-beside"
    (_, F, _, C), omega = engine(case)
    small, rest = GIVEN["cases"][case]["shafts"]
    (mass,) = small["masses"]
    F_g = omega**2 * mass["mass_kg"] * mass["radius_mm"] * 1e-3 * cmath.rect(1, math.radians(mass["angle_deg"]))
    left = F + F_g, C + F_g * mass["z_mm"] * 1e-3
    U, P = asked_share(left, omega, rest["overdesign_percent"] / 100)
    assert abs(U) * omega**2 == said(case, "rest.force") and abs(P) * omega**2 == said(case, "rest.couple")
    assert math.degrees(cmath.phase(P)) == said(case, "rest.couple_phase")
    assert abs(left[0] + U * omega**2) == pytest.approx(0.02 * abs(left[0]), rel=1e-9)


vectors = st.tuples(*[st.complex_numbers(max_magnitude=1e4, allow_nan=False)] * 2)


@given(vectors, st.floats(0.0, 0.2), st.lists(st.floats(0.05, 1.0), min_size=1, max_size=4))
def test_the_shares_of_all_together_are_the_whole(left, x_o, parts):
    """And of a single shaft the same bits as before there were several."""
    shares = [part / sum(parts) for part in parts]
    taken = [asked_share(left, 300.0, x_o, share) for share in shares]
    whole = (
        f.asked_unbalance(x_o=x_o, F_like=left[0], omega=300.0),
        f.asked_product(x_o=x_o, C_like=left[1], omega=300.0),
    )
    for n in (0, 1):
        assert sum(one[n] for one in taken) == pytest.approx(whole[n], rel=1e-12, abs=1e-15)
    assert asked_share(left, 300.0, x_o) == whole


@given(vectors, st.floats(0.05, 0.3), st.floats(-math.pi, math.pi))
def test_what_a_mirrored_pair_can_take(left, z_max, phase):
    """What turns against the shaft may be 5 % off the mirror image of what turns like it, wherever that points."""
    F, C = left
    most = max(abs(F), abs(C) / z_max)
    off = cmath.rect(1.0, phase) * most
    need_mirror_images(left, (F.conjugate() + 0.045 * off, C.conjugate()), z_max)
    need_mirror_images(left, (F.conjugate(), C.conjugate() + 0.045 * off * z_max), z_max)
    if most > 1e-3:
        for against in (
            (F.conjugate() + 0.06 * off, C.conjugate()),
            (F.conjugate(), C.conjugate() + 0.06 * off * z_max),
        ):
            with pytest.raises(NoSolution, match="no mirror images"):
                need_mirror_images(left, against, z_max)


def test_the_words_of_a_pair_that_is_none():
    with pytest.raises(NoSolution, match=r"differ by 20 %; .* may leave 5 % of them; write two shafts"):
        need_mirror_images((1000.0 + 0j, 0j), (800.0 + 0j, 0j), 0.1)
    (F, F_against, C, C_against), _ = engine("v2-45-sized")
    with pytest.raises(NoSolution, match="write two shafts"):
        need_mirror_images((F_against, C_against), (F, C), 0.04)
