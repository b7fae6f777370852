"""A wheel as a solid: against the area of its section, its hand, and two of them in mesh."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from calc.design.toml_file import load_design
from calc.exchange.frame import Frame
from calc.exchange.places import helix
from calc.gears.profile.section import section
from calc.sheet.errors import NoSolution
from calc.solve import solve
from tests.calc.gears.trains import mesh, solved, train, wheel
from tests.conftest import ROOT

pytest.importorskip("OCP")

from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
from OCP.BRepClass3d import BRepClass3d_SolidClassifier
from OCP.gp import gp_Pnt
from OCP.TopAbs import TopAbs_IN

from assistant.exports.solids import Solids
from reports.step.kernel import moved, properties, solids, step_file
from reports.step.module import module_parts
from reports.step.wheel import toothed, wheel_solid

RHO = 7860.0


def of(z, x, beta, tool, m_n=1.0, b=4.0, hand=None, **more):
    teeth = [wheel("a", z, x, hand=hand, **more), wheel("b", 60, 0.5)]
    given = train(teeth, [mesh("a", "b")], m_n=m_n, beta=beta, tool=tool, b=b)
    return solved(given), given


def test_the_given_wheel():
    """Given volume and inertia, by a rack generation of their own."""
    made = wheel_solid(*of(25, 0.014229850303051, 21.916, (1.41, 0.2), m_n=2.0, b=15.0), "a", RHO, Frame())
    assert made.whole.volume == pytest.approx(33703.99256659126, rel=2e-6)
    assert made.whole.tensor[2, 2] == pytest.approx(96.70699879870187, rel=4e-6)
    assert made.deviation < 1e-7
    assert np.abs(made.whole.centre).max() < 1e-6


@pytest.mark.parametrize(
    "case",
    [
        dict(z=20, x=0.0, beta=0.0, tool=(1.25, 0.38)),
        dict(z=9, x=0.9, beta=0.0, tool=(1.25, 0.3)),  # pointed
        dict(z=8, x=-0.3, beta=15.0, tool=(1.25, 0.2)),  # undercut
        dict(z=12, x=0.0, beta=0.0, tool=(1.25, 0.0), bore_diameter=0.004),  # by a sharp tool
        dict(z=10, x=0.2, beta=-0.0, tool=(1.25, 0.38), rim_thickness=0.001),
        dict(z=9, x=0.3, beta=35.0, tool=(1.25, 0.3), b=12.0),  # twisted by 90°: of more sections
    ],
)
def test_volume_is_the_area_of_the_section_times_the_face(case):
    made = wheel_solid(*of(**case), "a", RHO, Frame())
    assert made.whole.volume == pytest.approx(made.by_program.volume, rel=1e-7)
    assert made.whole.tensor == pytest.approx(made.by_program.tensor, rel=2e-7, abs=1e-9)
    assert len(solids(made.part.bodies[0][1])) == 1


def test_a_blank_weighs_what_the_program_says():
    results = solve(load_design(ROOT / "designs" / "r754ie4_balance_shafts.toml"))
    asked = SimpleNamespace(options={"blank": True}, results=results)
    for name, one in results.train.wheels.items():
        assert Solids(asked).wheel(name).whole.mass == pytest.approx(one.mass, rel=1e-9)


@pytest.mark.parametrize("turn", (1, -1))
@pytest.mark.parametrize("hand", ("left", "right"))
def test_a_right_hand_turns_with_z_whichever_way_the_engine_turns(hand, turn):
    """A point on the end of a tooth, a quarter pitch on: in the solid there, and not on the other side."""
    t, given = of(10, 0.2, 20.0, (1.25, 0.38), b=4.0, hand=hand)
    made = wheel_solid(t, given, "a", RHO, Frame(turn), tooth=0.1)
    sense = 1 if hand == "right" else -1
    z, r = 1.9, t.wheels["a"].tip_diameter * 500 - 0.1
    on = 2 * np.tan(np.radians(20)) / (t.wheels["a"].reference_diameter * 1e3) * z
    for sign, inside in ((1, True), (-1, False)):
        angle = turn * 0.1 + sign * sense * on
        point = gp_Pnt(r * np.cos(angle), r * np.sin(angle), z)
        found = BRepClass3d_SolidClassifier(made.part.bodies[0][1], point, 1e-6).State()
        assert (found == TopAbs_IN) == inside, sign


def test_an_allowance_takes_volume_and_no_length():
    t, given = of(20, 0.0, 0.0, (1.25, 0.38), allowance=(-20, -40))
    none, thick, thin = (wheel_solid(t, given, "a", RHO, Frame(), end=end).whole.volume for end in ("", "max", "min"))
    assert none > thick > thin


def test_a_wheel_without_teeth_is_none():
    t, _ = of(20, 0.0, 0.0, (1.25, 0.38))
    with pytest.raises(NoSolution):
        section(t.system, t.wheels["a"], 3.5)


def test_the_same_wheel_is_the_same_bytes():
    made = (wheel_solid(*of(9, 0.3, 10.0, (1.25, 0.3)), "a", RHO, Frame()).part for _ in range(2))
    first, second = (step_file([part], "a.step", "2026-01-01", ["teeth"]) for part in made)
    assert first == second


def test_a_long_twist_has_more_sections():
    """Seven of them, 20° apart, are 4·10⁻⁶ off."""
    t, _ = of(16, -0.02, 35.0, (1.25, 0.3), m_n=2.0)
    curves, twist = section(t.system, t.wheels["a"]), helix(t, "a") * 1e-3
    volume = properties(toothed(curves, 30.0, twist), splines=True).volume
    assert volume == pytest.approx(curves.area * 1e6 * 30.0, rel=1e-7)


@pytest.mark.slow
@pytest.mark.parametrize("turn", (1, -1))
def test_two_wheels_of_a_module_do_not_enter_each_other(turn):
    """Hand, phase and place at once: with the allowance that leaves them a gap on both flanks they have nothing in
    common, and a good deal
    where one is half a pitch on."""
    results = solve(load_design(Path(ROOT) / "designs" / "r753ie4_drive.toml"))
    made = Solids(SimpleNamespace(options={"allowance": "min"}, results=results))
    made.frame = Frame(turn)
    names = ("idler", "shaft")
    parts = module_parts([], [(made.wheel(name), made.places[name]) for name in names], made.frame)
    (one, other), (at_one, at_other) = ((part.bodies[0][1] for part in parts), (part.place for part in parts))
    assert results.design.gears.hands()["idler"] != results.design.gears.hands()["shaft"]

    def common(turned):
        shape = BRepAlgoAPI_Common(moved(one, at_one), moved(moved(other, turned=turned), at_other)).Shape()
        return properties(shape, splines=True).volume

    assert common(0.0) == pytest.approx(0.0, abs=1e-6)
    assert common(np.pi / results.train.wheels["shaft"].teeth) > 100.0
