"""The parts between the centres: the source's table, the kinds, runout, the recommended backlash."""

import math
from dataclasses import replace

import pytest

from calc.gears.backlash.case import cases, centre_tolerance
from calc.gears.backlash.formulas import backlash_of_bases, recommended_backlash, runout_of_grade
from calc.gears.formulas import working_pressure_angle
from tests.calc.gears.backlash.plays import CENTRAL, IDLER, SHAVED, alone, changed, parts, played, true
from tests.calc.gears.trains import pair_1, solved


@pytest.mark.parametrize("columns, field", [((CENTRAL, IDLER), 0.1071), ((CENTRAL,), 0.0832), ((IDLER,), 0.0675)])
def test_the_source_s_table(columns, field):
    """Finotti 2013, Table 4.7: root of squares of both columns 0.1071 (stated 0.11, used ±0.055), of each alone 0.0832
    and 0.0675."""
    gears = changed(pair_1(allowances=SHAVED), stack=parts("radial", *columns))
    assert 2e3 * played(gears).meshes["central_idler"].centre_tolerance_rss == pytest.approx(field, abs=0.00005)
    assert centre_tolerance(replace(gears.meshes[0], tolerance=None)) == pytest.approx(field / 2e3, abs=0.00005e-3)


def test_a_given_tolerance_judges_and_else_the_parts():
    (mesh,) = pair_1().meshes
    assert centre_tolerance(mesh) == mesh.tolerance == pytest.approx(55e-6)
    assert centre_tolerance(replace(mesh, tolerance=None)) == 0
    assert centre_tolerance(replace(mesh, tolerance=None, contributors=(30e-6, 40e-6))) == pytest.approx(25e-6)
    assert centre_tolerance(replace(mesh, stack=parts("fit", {"a": 1.0}))) == mesh.tolerance


@pytest.mark.parametrize(
    "kind, share",
    [("position", 1 / 2), ("fit", math.sqrt(1 / 2)), ("runout", math.sqrt(1 / 2)), ("radial", math.sqrt(1 / 3))],
)
def test_one_part_of_each_kind(kind, share):
    """Whatever its kind it moves the centre by half its field at most; its standard deviation is that of its
    distribution."""
    gears = changed(pair_1(allowances=SHAVED), stack=parts(kind, {"part": 0.06}))
    mesh = played(gears).meshes["central_idler"]
    assert mesh.centre_tolerance_worst == mesh.centre_tolerance_rss == pytest.approx(30e-6)
    assert mesh.centre_tolerance_chance == pytest.approx(3 * share * 30e-6)


def test_worst_case_is_the_plain_sum():
    gears = changed(true(pair_1(allowances=SHAVED)), stack=parts("position", CENTRAL, IDLER))
    play = played(gears)
    mesh = play.meshes["central_idler"]
    assert mesh.centre_tolerance_worst == pytest.approx((sum(CENTRAL.values()) + sum(IDLER.values())) / 2e3)
    by_number = solved(changed(gears, stack=(), tolerance=mesh.centre_tolerance_worst)).meshes["central_idler"]
    assert mesh.backlash_min_worst == pytest.approx(by_number.backlash_min, abs=1e-15)
    table = next(table for table in play.tables() if table.id == "centre_stack")
    assert sum(row[6] for row in table.rows if row[6] is not None) == pytest.approx(100)
    assert len(table.rows) == len(CENTRAL) + len(IDLER) + 3


def test_runout_takes_half_of_each_wheel_s():
    """As a centre distance that is closer by both eccentricities; the backlash over the tolerance stays without it."""
    gears = changed(pair_1(allowances=SHAVED), wheels={"central": {"runout": 20e-6}, "idler": {"runout": 30e-6}})
    mesh = played(gears).meshes["central_idler"]
    closer = solved(changed(pair_1(allowances=SHAVED), tolerance=80e-6)).meshes["central_idler"]
    assert mesh.backlash_min_runout == pytest.approx(closer.backlash_min, abs=1e-15)
    assert (
        solved(gears).meshes["central_idler"].backlash_min
        == solved(pair_1(allowances=SHAVED)).meshes["central_idler"].backlash_min
    )
    plain = alone()[0].meshes["central_idler"]
    without = solved(pair_1(allowances=SHAVED)).meshes["central_idler"].backlash_min
    assert plain.backlash_min_runout == pytest.approx(without, abs=1e-15)
    parted = changed(gears, stack=parts("position", CENTRAL, IDLER))
    apart = played(changed(true(gears), stack=parts("position", CENTRAL, IDLER))).meshes["central_idler"]
    both = played(parted).meshes["central_idler"]
    slope = 2 * math.sin(solved(gears).meshes["central_idler"].working_pressure_angle)
    assert apart.backlash_min_worst - both.backlash_min_worst == pytest.approx(slope * 25e-6, rel=0.1)


def test_the_runout_of_the_grade():
    """(0.24 m_n + √d + 5.6)·2^((A − 5)/2) µm, m_n and d in mm."""
    assert runout_of_grade(m_n=2.25e-3, d=72e-3, A=7) == pytest.approx(29.250562748e-6, rel=1e-9)
    assert runout_of_grade(m_n=2e-3, d=89.4e-3, A=6) == pytest.approx(21.97003018e-6, rel=1e-9)


def test_a_runout_that_is_not_given_is_that_of_the_grade():
    """Of each wheel by itself; the finer grade leaves more backlash."""
    gears = changed(pair_1(allowances=SHAVED), wheels={"idler": {"runout": 30e-6}})
    (m,) = cases(gears, solved(gears))
    d = m.driver.reference_diameter
    assert m.runouts == (runout_of_grade(m_n=2e-3, d=d, A=7), 30e-6) and m.given_runouts == (None, 30e-6)
    assert m.least_eccentricity == pytest.approx(15e-6)
    coarse, fine = (played(replace(gears, accuracy_grade=grade)).meshes["central_idler"] for grade in (9, 5))
    assert coarse.backlash_min_runout < fine.backlash_min_runout
    assert any("Runout of the teeth: not given for central" in note for note in played(gears).notes)


def test_a_tolerance_that_its_parts_exceed_is_warned_of():
    def verdict(tolerance):
        play = played(changed(pair_1(allowances=SHAVED), stack=parts("radial", CENTRAL, IDLER), tolerance=tolerance))
        return next(c for c in play.checks if c.id == "gears.central_idler.stack").verdict

    assert (verdict(53e-6), verdict(54e-6)) == ("warn", "pass")


def test_recommended_backlash():
    """⅔(0.06 + 0.0005 a + 0.03 m_n) mm: 0.107 mm for the first pair."""
    assert recommended_backlash(a_w=80.555e-3, m_n=2e-3) == pytest.approx(0.107e-3, abs=0.5e-6)
    play, mesh = alone()
    assert mesh.backlash_recommended == recommended_backlash(a_w=80.555e-3, m_n=2e-3)
    assert next(c for c in play.checks if c.id == "gears.central_idler.backlash_guide").verdict == "note"


def test_kinds_of_backlash_agree_with_each_other():
    """j_t and j_wt stand as their circles; closer by j_r the flanks touch, but for a term of second order."""
    gears = pair_1(allowances=SHAVED)
    train, play = solved(gears), alone()[1]
    (m,) = cases(gears, train)
    circles = m.mesh.working_diameter_driver / train.wheels["central"].reference_diameter
    assert play.backlash_circumferential / play.backlash_transverse == pytest.approx(circles)
    a = m.mesh.centre_distance - play.backlash_radial
    left = backlash_of_bases(
        p_bt=m.system.base_pitch,
        s_b1=m.teeth[0].middle,
        s_b2=m.teeth[1].middle,
        d_b1=m.driver.base_diameter,
        d_b2=m.driven.base_diameter,
        alpha_wt=working_pressure_angle(m.driver.base_diameter, m.driven.base_diameter, a),
        beta_b=m.system.base_helix_angle,
    )
    assert 0 < left < 0.2e-6 < m.mesh.backlash_nominal
