"""How the backlash is set: by the centre distance, by shims, by a coat that wears off."""

import math

import pytest

from calc.design.toml_file import design, parse
from calc.gears.backlash.case import cases, smallest_at
from calc.sheet.value import recorded
from calc.solve import solve
from calc.studies.balancing import shim, wanted_backlashes
from tests.conftest import DESIGNS

TEXT = (DESIGNS / "r753ie4_drive_over_speed.toml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def coated():
    """The first mesh with a coat, the others as they are."""
    text = TEXT.replace("[[gears.meshes]]", "[[gears.meshes]]\ncoat_um = 23.0", 1)
    with recorded(False):
        return solve(design(parse(text.encode(), "coated.toml")))


def test_backlash_for_the_centres(coated):
    """Of its given value, and as the backlash over a small change of the centres."""
    train = coated.train
    for key, play in train.play.items():
        mesh = train.meshes[key]
        exact = 2 * math.sin(mesh.working_pressure_angle) * math.cos(train.system.base_helix_angle)
        assert play.backlash_per_centre == pytest.approx(exact, rel=1e-12)
    for m in cases(coated.design.gears, train):
        a = m.mesh.centre_distance
        slope = (smallest_at(m, a + 1e-6) - smallest_at(m, a - 1e-6)) / 2e-6
        assert slope == pytest.approx(train.play[m.key].backlash_per_centre, rel=1e-4)


def test_a_coat_is_held_against_its_share_of_the_window(coated):
    train = coated.train
    check = coated.check("gears.crank_central.coat")
    share = train.drive.window.taken["crank_central"] * math.cos(train.system.base_helix_angle)
    assert train.play["crank_central"].coat_backlash == pytest.approx(46e-6)
    assert check.limit == pytest.approx(share * 1e6, rel=1e-9)
    assert check.verdict == "warn" and check.holds  # 46 over 45.6 µm: narrow
    assert coated.check("gears.central_idler.coat") is None


def test_a_thinner_coat_fails_and_says_what_would_do():
    text = TEXT.replace("[[gears.meshes]]", "[[gears.meshes]]\ncoat_um = 22.0", 1)
    with recorded(False):
        check = solve(design(parse(text.encode(), "thin.toml")), compared=False).check("gears.crank_central.coat")
    ((key, thickness),) = check.remedies[0].changes
    assert check.verdict == "fail" and key == "gears.meshes.0.coat_um"
    assert thickness == pytest.approx(check.limit / 2, rel=1e-3)


def test_the_wanted_backlashes_bring_the_way_to_the_middle(coated):
    train = coated.train
    way, line = train.drive.window, train.drive.drive.line
    wanted = wanted_backlashes(train)
    middle = sum(
        wanted[line.links[i].key]
        / math.cos(train.system.base_helix_angle)
        * float(train.drive.survey.bodies.lever[i, way.body])
        for i in line.path(way.body)
        if line.links[i].key in way.taken
    )
    assert middle == pytest.approx((way.low + way.high) / 2, rel=1e-9)


def test_shims_come_in_whole_steps():
    assert shim(60e-6, 40e-6, 0.684, 10e-6) == pytest.approx(30e-6)
    assert shim(40e-6, 60e-6, 0.684, 50e-6) == pytest.approx(-50e-6)
