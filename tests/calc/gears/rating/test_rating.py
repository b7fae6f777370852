"""Nominal stresses: recomputed values of the source's pair, Hertz's own formula, the editions, the source's sheet."""

import math
from dataclasses import replace

import pytest

from calc.design.key_results import key_results
from calc.gears import solve
from calc.gears.rating import source_sheet as sheet
from calc.gears.rating import stress as s
from calc.gears.rating.load import RatingLoad, Surroundings, rating_context
from calc.gears.rating.mesh_strength import nominal_root
from calc.gears.rating.solve import side
from calc.library.catalogue import Material, materials
from tests.calc.gears.trains import SPEED, mesh, pair_1, r753, shown, solved, train, wheel

TORQUE = 1350 / (2 * math.pi * SPEED)  # 1.35 kW at 2600 rpm


def whole(gears, torque, solids=None):
    outcome = solve.geometry(gears, SPEED)
    return solve.merge(outcome, solve.rating(gears, outcome.result, torque, solids or materials()))


def stresses(*given):
    return shown(whole(*given))


def test_source_train_at_a_consistent_load():
    """4.958 N·m at crank and shaft are 184.0 N in every mesh; first pair 214.98, 15.746 and 15.156 MPa with the right
    factors of 2006."""
    v = stresses(r753(), TORQUE)
    assert TORQUE == pytest.approx(4.958, abs=5e-4)
    assert [v[f"{m}.tangential_force"] for m in ("crank_central", "central_idler", "idler_shaft")] == pytest.approx(
        [184.0] * 3, abs=0.05
    )
    assert v["central_idler.contact_stress"] == pytest.approx(214.98, abs=5e-3)
    assert v["central_idler.root_stress_central"] == pytest.approx(15.746, abs=5e-4)
    assert v["central_idler.root_stress_idler"] == pytest.approx(15.156, abs=5e-4)


def test_right_factors_at_the_source_torque():
    """Finotti 2013 enters 2600 rpm for the 36: 4.958 N·m at the driver.  With the right factors 179.15, 10.935 and
    10.525 MPa."""
    v = stresses(pair_1(), TORQUE)
    assert v["central_idler.contact_stress"] == pytest.approx(179.15, abs=5e-3)
    assert v["central_idler.root_stress_central"] == pytest.approx(10.935, abs=5e-4)
    assert v["central_idler.root_stress_idler"] == pytest.approx(10.525, abs=5e-4)


def test_steel_has_the_usual_elasticity_factor():
    assert math.sqrt(s.contact_modulus(0.3, 206e9, 0.3, 206e9) / 1e6) == pytest.approx(189.81, abs=5e-3)


@pytest.mark.parametrize("pair", ["crank_central", "central_idler", "idler_shaft"])
def test_contact_stress_is_hertz_at_the_pitch_point(pair):
    """Without Z_ε and Z_β: line contact of two cylinders with the normal radii of the pitch point, load F_bn over b/cos
    β_b."""
    gears = r753()
    t = solved(gears)
    mesh_, system = t.meshes[pair], t.system
    rated = solve.rating(gears, t, TORQUE, materials()).result.meshes[pair]
    sin_w, cos_b = math.sin(mesh_.working_pressure_angle), math.cos(system.base_helix_angle)
    r_1, r_2 = (d / 2 * sin_w / cos_b for d in (mesh_.working_diameter_driver, mesh_.working_diameter_driven))
    w = rated.tangential_force / math.cos(system.transverse_pressure_angle) / mesh_.face_width
    E_r = 206e9 / (1 - 0.3**2)  # 2/E_r = 2·(1 − ν²)/E
    hertz = math.sqrt(w * E_r / (2 * math.pi) * (1 / r_1 + 1 / r_2))
    factors = s.contact_ratio_factor(mesh_.transverse_contact_ratio, mesh_.overlap_ratio) / math.sqrt(
        math.cos(system.beta)
    )
    assert rated.contact_stress == pytest.approx(hertz * factors, rel=1e-12)


def test_softer_wheels_touch_softer():
    iron = {**materials(), "iron": Material(name="iron", E=206e9 / 4, poisson=0.3, density=7100.0, expansion=1e-5)}
    both = [wheel("a", 30, 0.0, material="iron"), wheel("b", 40, 0.0, material="iron")]
    steel, soft = train([wheel("a", 30, 0.0), wheel("b", 40, 0.0)], [mesh("a", "b")]), train(both, [mesh("a", "b")])
    assert stresses(soft, 1.0, iron)["a_b.contact_stress"] == pytest.approx(
        stresses(steel, 1.0)["a_b.contact_stress"] / 2
    )


def test_stress_grows_with_load_and_its_root():
    one, four = stresses(r753(), 2.0), stresses(r753(), -8.0)
    assert four["idler_shaft.contact_stress"] == pytest.approx(2 * one["idler_shaft.contact_stress"])
    assert four["idler_shaft.root_stress_shaft"] == pytest.approx(4 * one["idler_shaft.root_stress_shaft"])


def test_an_oil_that_nobody_names_has_100_at_40_degrees():
    """ISO 6336-2: C_ZL + 4·(1 − C_ZL)/(1.2 + 134/ν_40)², C_ZL 0.91 of hard flanks."""
    rated = solve.rating(r753(), solved(r753()), 60.0, materials()).result
    assert [mesh_.strength.lubricant_factor for mesh_ in rated.meshes.values()] == pytest.approx(
        [0.91 + 0.36 / (1.2 + 1.34) ** 2] * 3
    )


def test_torque_by_wheel_or_by_mesh_is_the_same():
    gears = r753()
    t = solved(gears)
    handed_on = solve.rating(gears, t, TORQUE, materials()).result
    by_wheel = {"crank": TORQUE, "central": TORQUE * 36 / 25, "idler": TORQUE * 39 / 25}
    by_mesh = {"crank_central": TORQUE, "central_idler": TORQUE * 36 / 25, "idler_shaft": TORQUE * 39 / 25}
    for given in (by_wheel, by_mesh):
        rated = solve.rating(gears, t, given, materials()).result
        for key, mesh_ in rated.meshes.items():
            assert mesh_.contact_stress == pytest.approx(handed_on.meshes[key].contact_stress, rel=1e-12)


def test_the_edition_changes_the_root_stress_only():
    old, new = stresses(pair_1(), TORQUE), stresses(pair_1(edition=2019), TORQUE)
    assert new["central_idler.contact_stress"] == old["central_idler.contact_stress"]
    eps_alphan = old["central_idler.transverse_contact_ratio"] / math.cos(math.radians(old["base_helix_angle"])) ** 2
    eps_beta = old["central_idler.overlap_ratio"]
    factor = math.sqrt(1 - eps_beta + eps_beta / eps_alphan) / math.cos(math.radians(21.916)) ** 3
    assert new["central_idler.root_stress_central"] == pytest.approx(factor * old["central_idler.root_stress_central"])


@pytest.mark.parametrize("eps_beta, expected", [(0.0, 1.0), (1.0, 1.5**-0.5), (2.5, 1.5**-0.5)])
def test_load_distribution_of_2019_at_its_ends(eps_beta, expected):
    assert s.load_distribution(eps_beta, 1.5) == pytest.approx(expected)


@pytest.mark.parametrize("eps_alphan, share", [(1.98, 1.0), (2.02, math.sqrt(0.5)), (2.9, math.sqrt(0.5))])
def test_the_root_of_a_spur_pair_by_2019_carries_alone_up_to_two_pairs(eps_alphan, share):
    gears = train([wheel("a", 30, 0.1), wheel("b", 40, 0.1)], [mesh("a", "b")], beta=0.0, ball=None)
    t = solved(gears)
    pair = replace(t.meshes["a_b"], transverse_contact_ratio=eps_alphan)
    old, new = (nominal_root(t.system, pair, t.wheels["a"], 1000.0, edition) for edition in (2006, 2019))
    assert new.sigma_F0 == pytest.approx(share * old.sigma_F0)


@pytest.mark.parametrize("overlap, beta, reduction", [(0.5, 30, 0.125), (1, 30, 0.25), (2, 20, 1 / 6), (1, 35, 0.25)])
def test_helix_angle_factor_of_the_root(overlap, beta, reduction):
    """ISO 6336-3: ε_β·β/120°, ε_β up to 1 and β up to 30°; 2019 besides over cos³ β."""
    angle = math.radians(beta)
    assert s.helix_factor_root(overlap, angle) == pytest.approx(1 - reduction)
    assert s.helix_factor_root_2019(overlap, angle) == pytest.approx((1 - reduction) / math.cos(angle) ** 3)


@pytest.mark.parametrize("least, loading", [(None, "pulsating"), (0.01, "pulsating"), (-0.01, "reversed")])
def test_a_root_is_reversed_where_the_torque_changes_its_sign(least, loading):
    gears = r753()
    t = solved(gears)
    load = RatingLoad(4.0, 2.0, least, 6.0, 1.0)
    context = rating_context(gears, t, materials(), Surroundings())
    root = nominal_root(t.system, t.meshes["crank_central"], t.wheels["crank"], 100.0, 2006)
    assert side(context, "crank", root, None, load.reverses).loading == loading


def test_the_safeties_are_the_first_lines_of_the_first_page():
    values = {v.id: v for v in whole(r753(), TORQUE).values()}
    lines = {place: v.symbol for (_, place, _), v in key_results(values).items()}
    assert lines == {1: "S_H", 2: "S_F", 5: "ε_α", 6: "Δφ"}  # 3 and 4: the backlash


@pytest.mark.parametrize(
    "eps_beta, low, high",
    [
        (0.0, 1.0, math.sqrt(0.5)),
        (1.0, 1 / math.sqrt(2.3), 1 / math.sqrt(2.3)),
        (2.0, 1 / math.sqrt(2.3), 1 / math.sqrt(2.3)),
    ],
)
def test_the_load_of_the_root_at_the_ends_of_the_overlap(eps_beta, low, high):
    """A spur pair: by one tooth, from ε_αn 2 on by two; with an overlap of 1 or more the lines of contact share it
    evenly."""
    assert s.load_distribution(eps_beta, 2.3) == pytest.approx(low) and s.load_distribution_high(
        eps_beta, 2.3
    ) == pytest.approx(high)


@pytest.mark.parametrize("h, rho, s_pr", [(1.25, 0.38, 0.0), (1.4, 0.2, 0.0), (1.4, 0.3, 0.05e-3)])
def test_the_corner_of_the_tool_touches_its_flank(h, rho, s_pr):
    """E is the distance of its centre from the middle of the tool's tooth: ρ away, at right angles, from the flank that
    stands s_pr out."""
    m_n, alpha = 2e-3, math.radians(20)
    x = s.tool_half_width(m_n=m_n, h_fP=h, alpha_n=alpha, s_pr=s_pr, rho_aP0=rho)
    flank = m_n * (math.pi / 4 - (h - rho) * math.tan(alpha)) + s_pr / math.cos(alpha)  # at the height of the centre
    assert (flank - x) * math.cos(alpha) == pytest.approx(rho * m_n)


@pytest.mark.parametrize(
    "eps_beta, Z_eps", [(0.0, math.sqrt(2.5 / 3)), (1.0, math.sqrt(1 / 1.5)), (3.0, math.sqrt(1 / 1.5))]
)
def test_contact_ratio_factor_at_its_ends(eps_beta, Z_eps):
    assert s.contact_ratio_factor(1.5, eps_beta) == pytest.approx(Z_eps)


def test_where_the_sheet_has_no_value_it_is_left_out(monkeypatch):
    gears = pair_1()
    monkeypatch.setattr("calc.gears.rating.source_sheet.load_diameter", lambda m_n, z_n, d_D, d: 0.5 * m_n * z_n)
    rated = solve.rating(gears, solved(gears), TORQUE, materials())
    found = rated.result.meshes["central_idler"].sheet
    assert found.root_stress_driver is None and found.contact_stress > 0
    (table,) = (t for t in rated.tables if t.id == "source_sheet")
    assert not any("root stress" in str(row[1]) for row in table.rows)


def test_the_formulas_of_the_sheet_by_hand():
    assert sheet.transverse_addendum(h_aP0=1.4, beta=math.radians(60)) == pytest.approx(0.7)
    assert sheet.load_diameter(m_n=2e-3, z_n=45.0, d_D=81e-3, d=78e-3) == pytest.approx(93e-3)
    form = sheet.form_factor(h=1.2, alpha_en=math.radians(70), gamma_e=math.radians(10), s=2.0, alpha_t=math.pi / 3)
    assert form == pytest.approx(6 * 1.2 * 0.5 / (4 * 0.5))
    eta = sheet.space_angle(z=36, s_w=3e-3, d_w=75e-3)
    assert eta == pytest.approx(math.pi / 36 - 0.04)
    assert sheet.ball_angle(alpha_wt=0.4, eta=0.05) == pytest.approx(math.degrees(0.4) * 0.05)
    assert sheet.ball(d_w=75e-3, beta_b=math.pi / 3, eta=math.pi / 6, alpha_tr=math.pi / 3) == pytest.approx(37.5e-3)


@pytest.mark.parametrize("angle, found", [(0.001, True), (1.55, True), (1.58, False)])
def test_a_ball_of_the_sheet_needs_an_angle_below_a_right_one(angle, found):
    t = solved(pair_1())
    mesh_ = t.meshes["central_idler"]
    eta = math.pi / 36 - mesh_.working_thickness_driver / mesh_.working_diameter_driver
    there = replace(mesh_, working_pressure_angle=math.radians(angle / eta))
    result = sheet.sheet(t.system, there, (t.wheels["central"], t.wheels["idler"]), TORQUE)
    assert result.ball_angle_driver == pytest.approx(angle)
    assert (result.ideal_ball_driver is not None) is found


@pytest.mark.parametrize("off, fault", [(0.99e-3, ""), (-0.99e-3, ""), (1.01e-3, "speed"), (-1.01e-3, "speed")])
def test_a_value_of_the_sheet_is_called_wrong_from_a_thousandth_on(off, fault):
    gears = r753()
    t = solved(gears)
    rated = solve.rating(gears, t, TORQUE, materials()).result.meshes["idler_shaft"]
    near = replace(rated, sheet=replace(rated.sheet, tangential_force=rated.tangential_force * (1 + off)))
    row = next(row for row in sheet.comparison(t, {"idler_shaft": near}).rows if row[1] == "tangential force")
    assert (fault in str(row[5]) if fault else row[5] == "") and row[3] == pytest.approx(row[4], rel=2e-3)


def test_a_train_without_torque_has_a_sheet_of_nothing():
    gears = r753()
    rated = solve.rating(gears, solved(gears), 0.0, materials())
    erratum = next(e for e in rated.errata if e.about == "gears.central_idler.contact_stress")
    assert erratum.source_value == 0.0 and "0 N instead of 0 N" in erratum.why


def test_what_the_source_prints_is_an_erratum():
    """Table 4.5: 52.833, 1.191 and 1.146 daN/mm²; the contact stress is √10 too high."""
    gears = r753()
    rated = solve.rating(gears, solved(gears), TORQUE, materials())
    (erratum,) = (e for e in rated.errata if e.about == "gears.central_idler.contact_stress")
    assert erratum.source_value == pytest.approx(528.33, abs=5e-3)
    assert "127.8 N instead of 184 N" in erratum.why
    (table,) = (t for t in rated.tables if t.id == "source_sheet")
    rows = {row[1]: row[3] for row in table.rows if row[0] == "central–idler"}
    assert rows["root stress of central"] == pytest.approx(11.91, abs=5e-3)
    assert rows["root stress of idler"] == pytest.approx(11.46, abs=5e-3)
    assert "2006" in rated.notes[0]
