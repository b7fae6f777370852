# SPDX-License-Identifier: Apache-2.0
"""Ratings, loads and lives against given values, each with its tolerance."""

import json
from pathlib import Path

import numpy as np
import pytest

from calc.bearings.rolling.contact import (
    Springs,
    contact_constant,
    displacement,
    largest_load,
    pass_frequency,
    pressure_of,
    stiffness,
)
from calc.bearings.rolling.geometry import gamma_of, inside_of
from calc.bearings.rolling.life import (
    contamination,
    counted_ratio,
    life_factor,
    life_of_duty,
    lives,
    system_life,
    with_clearance,
)
from calc.bearings.rolling.life import needed_viscosity_of as nu_1
from calc.bearings.rolling.load import equivalent, mean_of, races_of, radial_of, ring_factor_of
from calc.bearings.rolling.load import static_load as P_0
from calc.bearings.rolling.load import static_safety as S_0
from calc.bearings.rolling.ratings import computed
from calc.bearings.rolling.sizes import own_size, size_of
from calc.bearings.rolling.zone import EXPONENTS

GIVEN = json.loads((Path(__file__).parents[3] / "reference" / "rolling.json").read_text(encoding="utf-8"))["given"]
KINDS = ("rating", "own ball", "mean load", "ring factor", "a_ISO", "e_C", "radial", "contact", "passing")
ROWS = [row for row in GIVEN if row["case"].startswith(KINDS)]
RPM, HOUR = 1 / 60, 3600.0


def rated(size, **known):
    return computed(inside_of(size, **known), size.usual.rating)


def found(case, value, given):
    if case.startswith("own ball"):
        size = own_size("ball", *(given[key] / 1e3 for key in ("bore_mm", "outside_diameter_mm", "width_mm")))
        lengths = {key: given[f"{key}_mm"] / 1e3 for key in ("pitch_diameter", "element_diameter")}
        inside = dict(diameter=lengths["element_diameter"], pitch=lengths["pitch_diameter"])
        ratings = rated(size, count=float(given["element_count"]), **inside)
        return {"dynamic_rating": ratings.dynamic, "static_rating": ratings.static}[value] / 1e3
    if case.startswith("mean load"):
        return mean_of(float(given["turning_N"]), float(given["standing_N"]), given["exponent"])
    if case.startswith("a_ISO"):
        return life_factor(given["elements"], counted_ratio(kappa=given["viscosity_ratio"]), given["eC_Cu_P"])
    if case.startswith("e_C"):
        k = counted_ratio(kappa=given["viscosity_ratio"])
        return contamination(given["cleanliness"], given["pitch_diameter_mm"] / 1e3, k)
    size = size_of(given["size"])
    inside = inside_of(size, split_cage=given.get("split_cage", False))
    if case.startswith("rating"):
        ratings = computed(inside, size.usual.rating)
        return {"dynamic_rating": ratings.dynamic, "static_rating": ratings.static}[value] / 1e3
    if case.startswith("ring factor"):
        return ring_factor_of(races_of(inside))
    if case.startswith("contact"):
        return pressure_of(inside, given["element_load_N"])[0] / 1e6
    if case.startswith("passing"):
        return pass_frequency(Z=inside.count, n=given["speed_rpm"] * RPM, gamma=gamma_of(inside))
    springs = dict(Z=inside.count, K_1=contact_constant(inside), s=given["clearance_um"] * 1e-6)
    delta = displacement(F=float(given["load_N"]), elements=inside.elements, **springs)
    if value == "displacement_um":
        return delta * 1e6
    if value == "stiffness_kN_mm":
        return stiffness(delta=delta, elements=inside.elements, **springs) / 1e6
    return largest_load(K_1=springs["K_1"], delta=delta, s=springs["s"], n_c=EXPONENTS[inside.elements].n)


@pytest.mark.parametrize("row", ROWS, ids=[f"{row['case']}, {row['value']}" for row in ROWS])
def test_agrees_with_a_given_value(row):
    assert found(row["case"], row["value"], row["inputs"]) == pytest.approx(row["is"], rel=row["rel"])


def test_every_kind_of_given_value_is_there():
    assert len(ROWS) == 46 and all(any(row["case"].startswith(kind) for row in ROWS) for kind in KINDS)


def whole(case, place):
    values = {row["value"].removeprefix("bearings."): (row["is"], row["rel"]) for row in GIVEN if row["case"] == case}
    return lambda name: pytest.approx(values[f"{place}.{name}"][0], rel=values[f"{place}.{name}"][1])


def test_a_whole_bearing_at_given_oil_and_clearance():
    """NU205 under 1706.81 N that turns and 78.25 N that stands, 2600 rpm, at κ and clearance as they come out."""
    is_ = whole("two rollers", "front")
    size = size_of("NU205")
    inside = inside_of(size)
    ratings, races, n = computed(inside, size.usual.rating), races_of(inside), 2600 * RPM
    F_1, F_2 = 1706.81, 78.2488
    F_m = mean_of(F_1, F_2, 10 / 3)
    assert F_m == pytest.approx(1709.8, abs=0.05)
    P = equivalent(size, ratings, radial_of(races, F_1, F_2, 10 / 3), 0.0)
    assert P == is_("equivalent_load")
    nu = 0.5692547 * nu_1(inside.pitch, n)
    life = lives("roller", inside.pitch, ratings, P, n, nu, "typical")
    assert life.kappa == is_("viscosity_ratio") and life.factor == pytest.approx(0.417, abs=5e-4)
    assert life.basic / HOUR == is_("life_basic") and life.modified / HOUR == is_("life")
    springs = Springs("roller", inside.count, contact_constant(inside), 40.86915e-6)
    loaded = with_clearance(races, springs, P, F_m, True)
    reference = lives("roller", inside.pitch, ratings, loaded, n, nu, "typical")
    assert reference.modified / HOUR == is_("life_reference")
    assert springs.force(springs.displacement(F_m))[1] / 1e6 == is_("stiffness")
    assert S_0(C_0=ratings.static, P_0=P_0(k_s=1.5, F_1=F_1, o=0.1, F_2=F_2)) == is_("static_safety")


@pytest.mark.parametrize("place, size, p, loads", [("front", "6305", 3, (1500.0, 120.0)), ("rear", "HK3020", 10 / 3, (1650.0, 40.0))])  # fmt: skip
def test_a_duty_by_rows(place, size, p, loads):
    """Life by the load alone over three rows, thrust of 60 N on the ball bearing; clearance as it comes out."""
    is_ = whole("ball and cup over a profile", place)
    size = size_of(size)
    inside = inside_of(size)
    ratings, races = computed(inside, size.usual.rating), races_of(inside)
    n = np.array([900.0, 2200.0, 2600.0]) * RPM
    F_1, F_2 = loads[0] * (n / n[-1]) ** 2, np.full(3, loads[1])
    P = equivalent(size, ratings, radial_of(races, F_1, F_2, p), 60.0 if place == "front" else 0.0)
    L = lives(size.elements, inside.pitch, ratings, P, n, 1e-5, "typical")
    assert life_of_duty(w=np.array([0.2, 0.6, 0.2]), L_i=L.basic) / HOUR == is_("life_basic")
    assert S_0(C_0=ratings.static, P_0=P_0(k_s=1.5, F_1=loads[0], o=0.1, F_2=loads[1])) == is_("static_safety")
    clearance = {"front": 13.53502e-6, "rear": 63.76568e-6}[place]
    springs = Springs(size.elements, inside.count, contact_constant(inside), clearance)
    F_m = mean_of(loads[0], loads[1], p)
    assert springs.force(springs.displacement(F_m))[1] / 1e6 == is_("stiffness")


def test_two_bearings_live_together():
    lives_of = [31463.14, 31095.75]  # h, of the two above
    assert system_life(L=lives_of, e=[9 / 8, 9 / 8]) == pytest.approx(16891.21, rel=1e-4)
    assert system_life(L=[35128.62, 41547.04], e=[10 / 9, 9 / 8]) == pytest.approx(20474.58, rel=1e-4)
