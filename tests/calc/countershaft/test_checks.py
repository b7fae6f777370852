"""What the step passes and fails: residuals, slopes, envelope, supports, outline, holes; the limits themselves are
crossed."""

import math

import pytest

from calc.design.toml_file import design
from calc.solve import solve
from tests.calc.countershaft.shafts import ENVELOPE, FRONT, REAR, SEATED, outcome, rows, verdicts
from tests.conftest import SCREENED

SIZE = {"mode": "size", **ENVELOPE}
SEATS = [{"diameter_mm": 59.5, "length_mm": 27.5}, {"diameter_mm": 86.4, "length_mm": 29.0}]


def found(made, name):
    (check,) = [c for c in made.checks if c.id == f"countershaft.{name}"]
    return check


# --- what is left over
@pytest.mark.parametrize(
    "share, verdict",
    [(1.0, "pass"), (1.04, "pass"), (1.049, "warn"), (1.051, "fail"), (0.951, "warn"), (0.949, "fail")],
)
def test_five_percent_of_the_couple_may_be_left(share, verdict):
    masses = [{**m, "mass_kg": m["mass_kg"] * share} for m in (FRONT, REAR)]
    check = found(outcome(masses=masses), "residual")
    assert check.verdict == verdict and check.kind == "limit" and "30.0°" in check.advice
    assert check.limit == pytest.approx(0.05 * 572.932, abs=1e-3)


@pytest.mark.parametrize("fraction, aims", [(0.0, False), (0.44, False), (1.0, False), (0.48, True)])
def test_what_turns_against_the_shaft_is_not_asked_of_its_masses(fraction, aims):
    """A shaft as it should be: aiming at what it gives already would mend nothing where the crank's counterweights are
    wrong."""
    made = outcome(
        None, {"crank_balance_fraction": fraction}, **SIZE, overdesign_percent=-10.0 if aims else 0.0, bearings=SEATED
    )
    check = found(made, "residual")
    assert check.verdict == "fail" and ("Aim at" in check.advice) is aims
    assert ("turn against the shaft" in check.advice) is not aims


def test_both_faults_of_a_shaft_are_told():
    masses = [{**m, "mass_kg": m["mass_kg"] * 0.9} for m in (FRONT, REAR)]
    advice = found(outcome(None, {"crank_balance_fraction": 0.4}, masses=masses), "residual").advice
    assert (
        "Aim at 572.9 N·m" in advice
        and "114.6 N·m turn against the shaft" in advice
        and "counterweights of the crank" in advice
    )


def test_of_a_shaft_at_twice_crank_speed_a_second_one_takes_the_rest():
    check = found(outcome(SCREENED, twin=False), "residual_force_share")
    assert "turn against the shaft" in check.advice and "a mirrored second shaft does (mirrors)" in check.advice
    assert "turn against" not in found(outcome(SCREENED), "residual_force_share").advice


def test_a_shaft_where_nothing_is_to_be_balanced_is_judged_by_one_cylinder():
    """Forward vector zero with one half on the crank: 5 % of m·r·ω²·a = 1489.35 g · 53.5 mm · ω² · 112 mm."""
    check = found(outcome(speed_ratio=1, masses=[{**FRONT, "mass_kg": 0.0}]), "residual")
    assert check.limit == pytest.approx(0.05 * 1.48935 * 0.0535 * (math.pi * 2600 / 30) ** 2 * 0.112, rel=1e-5)


def test_second_order_is_a_matter_of_comfort():
    made = outcome(SCREENED)
    couple, force = found(made, "residual_share"), found(made, "residual_force_share")
    assert (couple.kind, couple.verdict, force.kind, force.verdict) == ("advice", "pass", "advice", "note")
    assert force.value_id == "countershaft.residual_order_2_force"
    assert not {"residual", "residual_force"} & verdicts(made).keys()
    assert made.verdict == "not_verified"  # where the shafts stand is not given
    assert str(made.words()) == "NOT VERIFIED: 1 not verified, 2 cautions"


def test_a_shaft_that_makes_the_second_order_worse_fails():
    """Turned by half a turn the pair adds to the engine's 10617.7 N what it should take from it."""
    masses = [{"name": "one", "mass_kg": 0.906, "radius_mm": 11.933, "angle_deg": 0.0, "z_mm": 0.0}]
    made = outcome(SCREENED, masses=masses)
    check = found(made, "residual_force")
    assert (
        check.kind == "limit"
        and check.verdict == "fail"
        and check.value_id == "countershaft.residual_order_2_force"
        and check.value == pytest.approx(10617.73 + 4 * 2134.0647, abs=0.05)
    )


def test_a_force_is_judged_by_one_cylinder():
    made = outcome(masses=[{**FRONT, "mass_kg": 3.0}, REAR])
    check = found(made, "residual_force")
    assert check.verdict == "fail" and "against each other" in check.advice
    assert check.limit == pytest.approx(0.05 * 1.48935 * 0.0535 * (math.pi * 2600 / 30) ** 2, rel=1e-5)


# --- slopes
@pytest.mark.parametrize(
    "slopes, front, rear",
    [
        ([0.25] * 2, "pass", "pass"),
        ([0.2, 0.26], "pass", "warn"),
        ([0.26, 0.23], "warn", "pass"),
        ([0.24] * 2, "pass", "pass"),
    ],
)
def test_given_slopes_against_a_quarter_of_a_milliradian(gamma, slopes, front, rear):
    document = gamma.with_value("shafts.shaft.core_radius_mm", None)
    for row, slope in zip(("front", "rear"), slopes):
        document = document.with_value(f"shafts.shaft.bearings.{row}.slope_mrad", slope)
    made = solve(design(document)).outcomes["countershaft"]
    assert (verdicts(made)["slope_front"], verdicts(made)["slope_rear"]) == (front, rear)


def test_a_thin_core_bends_too_far():
    thick, thin = (
        outcome(core_radius_mm=r, bearings=SEATED, sector_effectiveness=0.2, outer_radius_mm=40.5) for r in (15.0, 11.0)
    )
    assert (
        verdicts(thick)["slope_rear"] == "pass"
        and verdicts(thin)["slope_rear"] == verdicts(thin)["slope_front"] == "warn"
    )
    assert verdicts(thin)["first_critical_speed"] == "pass"
    assert found(thin, "slope_rear").value == pytest.approx(thin.result.slopes["rear"] * 1e3)


# --- envelope
@pytest.mark.parametrize(
    "R, verdict", [(42.5, "pass"), (42.9, "pass"), (43.0, "pass"), (43.01, "fail"), (45.0, "fail")]
)
def test_what_must_go_through_the_seat(R, verdict):
    """Ø86.4 less 0.2 mm all round lets R 43.0 through: the clearance is the designer's own, and may be used up."""
    check = found(outcome(**{**SIZE, "outer_radius_mm": R}, bearings=rows(SEATS), radial_clearance_mm=0.2), "envelope")
    assert check.verdict == verdict and check.kind == "limit"
    assert check.value == pytest.approx(43.2 - R, abs=1e-6) and check.limit == pytest.approx(0.2)


def test_the_clearance_is_the_designers():
    """Without one the sectors must just go through."""
    for R, verdict in ((43.0, "pass"), (43.2, "pass"), (43.21, "fail")):
        assert verdicts(outcome(**{**SIZE, "outer_radius_mm": R}, bearings=rows(SEATS)))["envelope"] == verdict
    assert verdicts(outcome(**SIZE, bearings=rows(SEATS), radial_clearance_mm=0.1))["envelope"] == "pass"
    assert verdicts(outcome(**SIZE, bearings=rows(SEATS), radial_clearance_mm=0.3))["envelope"] == "fail"


def test_a_given_shaft_is_threaded_in_only_where_that_is_asked():
    given = {"core_radius_mm": 15.0, "bearings": SEATED}
    assert "envelope" not in verdicts(outcome(**given, outer_radius_mm=40.5))
    assert verdicts(outcome(**given, outer_radius_mm=40.5, radial_clearance_mm=0.1))["envelope"] == "fail"
    assert verdicts(outcome(**given, outer_radius_mm=40.4, radial_clearance_mm=0.1))["envelope"] == "pass"


@pytest.mark.parametrize("front, rear, room", [(40.0, 41.0, 2.2), (41.0, 40.5, 2.2), (40.0, 40.0, 3.2)])
def test_the_widest_sector_must_go_through(front, rear, room):
    """Two sectors of different radius under journals of 59.5 and 86.4 mm; the journals are no sectors."""
    sides = ((-152.0, -1.0, front, 210.0), (1.0, 152.0, rear, 30.0))
    sections = [
        {
            "from_mm": a,
            "to_mm": b,
            "outer_radius_mm": R,
            "core_radius_mm": 15.0,
            "half_angle_deg": 70.0,
            "angle_deg": angle,
        }
        for a, b, R, angle in sides
    ]
    sections += [
        {"from_mm": a, "to_mm": b, "outer_radius_mm": R}
        for a, b, R in ((-182.0, -152.0, 29.75), (-1.0, 1.0, 15.0), (152.0, 182.0, 43.2))
    ]
    made = outcome(
        sections=sorted(sections, key=lambda one: one["from_mm"]), bearings=rows(SEATS), radial_clearance_mm=0.1
    )
    assert found(made, "envelope").value == pytest.approx(room)


@pytest.mark.parametrize("half_length, verdict", [(150.0, "pass"), (153.0, "pass"), (153.5, "fail"), (160.0, "fail")])
def test_the_sectors_end_where_the_journals_begin(half_length, verdict):
    """The nearer face is that of the rear journal: 167.5 − 29/2 = 153 mm.  Beyond it nothing is drawn, and it is judged
    all the same."""
    made = outcome(**{**SIZE, "half_length_mm": half_length}, bearings=rows(SEATS))
    check = found(made, "envelope_length")
    assert check.verdict == verdict and check.value == pytest.approx(153.0 - half_length)
    assert (made.result.mass is None) == (verdict == "fail") and verdicts(made)["envelope"] == "pass"


def test_masses_too_large_to_stand_side_by_side_are_no_shaft():
    """4.5 kg as a sector of this size is 281 mm long."""
    made = outcome(core_radius_mm=15.0, outer_radius_mm=40.3, bearings=SEATED, masses=[{**FRONT, "mass_kg": 4.5}, REAR])
    assert verdicts(made)["crossing"] == "fail" and found(made, "crossing").kind == "limit" and made.verdict == "fail"


def test_a_mass_that_is_no_sector_leaves_the_bending_not_verified():
    made = outcome(
        core_radius_mm=15.0, outer_radius_mm=40.3, bearings=SEATED, masses=[{**FRONT, "radius_mm": 35.0}, REAR]
    )
    check = found(made, "mass_shape")
    assert check.verdict == "not_verified" and check.missing == ("shafts.shaft.sections",)
    assert check.limit == pytest.approx(2 / 3 * (40.3**3 - 15**3) / (40.3**2 - 15**2))


# --- supports, outline, holes
def test_journals_of_its_own_are_screened():
    """24 × 21 mm at 6000 rpm under 2847.6 N: 5.65 MPa and 813 600 N·rpm/mm are beyond 5 MPa and 500 000."""
    made = verdicts(outcome(SCREENED, twin=False))
    assert made["support.2.specific_load"] == made["support.2.heat_index"] == "warn"
    assert made["support.1.specific_load"] == made["support.3.heat_index"] == "pass"


@pytest.mark.parametrize("half_angle, verdict", [(90.0, "pass"), (73.0, "pass"), (70.0, "fail"), (40.0, "fail")])
def test_sections_and_masses_must_be_one_shaft(half_angle, verdict):
    """The couple of the sections goes with sin γ: 5 % below at 71.8°."""
    sector = {"outer_radius_mm": 40.3, "core_radius_mm": 15.0, "half_angle_deg": half_angle}
    sections = [
        {"from_mm": -200.0, "to_mm": -152.0, "outer_radius_mm": 25.0},
        {"from_mm": -152.0, "to_mm": -1.0, "angle_deg": 210.0, **sector},
        {"from_mm": -1.0, "to_mm": 1.0, "outer_radius_mm": 15.0},
        {"from_mm": 1.0, "to_mm": 152.0, "angle_deg": 30.0, **sector},
        {"from_mm": 152.0, "to_mm": 200.0, "outer_radius_mm": 25.0},
    ]
    masses = [{**m, "mass_kg": 2.608345, "radius_mm": 18.830668, "z_mm": z} for m, z in ((FRONT, -76.5), (REAR, 76.5))]
    made = outcome(sections=sections, masses=masses)
    check = found(made, "outline")
    assert check.verdict == verdict and check.kind == "limit"
    assert check.value == pytest.approx(557.091 * (1 - math.sin(math.radians(half_angle))), abs=1e-3)
    assert verdicts(made)["outline_force"] == "pass"


@pytest.mark.parametrize("beyond, verdict", [(-0.1, "warn"), (0.5, "pass"), (1.5, "pass"), (3.5, "warn")])
def test_drilling_only_takes_away(beyond, verdict):
    """Four holes of 14 mm × 20 mm take 2.9 % of the couple."""
    masses = [
        {**m, "mass_kg": 2.69 * (1 + beyond / 100), "radius_mm": 18.7, "z_mm": z}
        for m, z in ((FRONT, -76.8), (REAR, 76.8))
    ]
    holes = {"diameter_mm": 14.0, "depth_mm": 20.0, "count": 4}
    made = outcome(masses=masses, holes=holes, outer_radius_mm=40.5)
    check = found(made, "holes.range")
    base = outcome(masses=[{**m, "mass_kg": 2.69} for m in masses]).result.couple
    assert check.value == pytest.approx(base * (1 + beyond / 100) - 572.93196, abs=1e-6)
    assert check.verdict == verdict and check.kind == "caution"


def test_holes_end_above_the_core():
    holes = {"diameter_mm": 14.0, "count": 4}
    for depth, verdict in ((25.0, "warn"), (20.0, "pass"), (26.0, "fail")):
        made = outcome(holes={**holes, "depth_mm": depth}, outer_radius_mm=40.5, core_radius_mm=15.0)
        assert verdicts(made)["holes.depth"] == verdict


def test_every_check_names_its_source_and_what_would_help(gamma_results):
    for check in gamma_results.outcomes["countershaft"].checks:
        assert check.source and check.name and (check.advice or check.verdict == "pass"), check.id


def test_holes_fit_into_their_sector():
    """Too wide for its bottom, too many for its length; touching sectors of one angle are one."""
    holes = {"depth_mm": 20.0, "count": 2}
    wide = outcome(**SIZE, bearings=rows(SEATS), holes={**holes, "diameter_mm": 80.0})
    assert verdicts(wide)["holes.width"] == "fail" and verdicts(wide)["holes.row"] == "pass"
    many = outcome(**SIZE, bearings=rows(SEATS), holes={**holes, "diameter_mm": 14.0, "count": 40})
    assert verdicts(many)["holes.row"] == "fail" and verdicts(many)["holes.width"] == "pass"


def test_a_core_of_no_thickness_is_no_shaft():
    made = outcome(**{**SIZE, "core_radius_mm": 0.02}, bearings=rows(SEATS))
    assert verdicts(made)["core"] == "fail" and made.result.mass is None
