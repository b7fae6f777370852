"""Strength of a mesh: a published example, safety over load, checks, tables, notes."""

import math
from dataclasses import replace

import pytest

from calc.gears.rating import mesh_strength as s
from calc.gears.rating.checks import roughness_check, strength_checks
from calc.gears.rating.classes import strength_class
from calc.gears.rating.curves import strength_tables
from calc.gears.rating.mesh_strength import MeshLoad, mesh_strength
from calc.gears.rating.notes import strength_notes
from calc.gears.rating.result import WheelStrength
from calc.sheet.quantity import published
from calc.sheet.value import link_of, trace

EH, QT = strength_class("case-hardened"), strength_class("quenched and tempered alloy steel", "MQ", 300.0)


# --- example 1 of ISO/TR 6336-30, reference values as reprinted in the public code of gfsReboucas/Drivetrain
def example_1():
    """m_n 8, z 17/103, β 15.8°, a 500 mm; 9 kN·m at 360 rpm for 50 000 h; VG 320, Rz 6 µm; printed v, tip diameters as
    of the example."""
    beta, alpha_n = math.radians(15.8), math.radians(20)
    alpha_t = math.atan(math.tan(alpha_n) / math.cos(beta))
    d = [z * 8e-3 / math.cos(beta) for z in (17, 103)]
    d_b = [x * math.cos(alpha_t) for x in d]
    alpha_wt = math.acos(sum(d_b) / 2 / 0.5)
    d_a = (159.66e-3, 872.35e-3)
    rho = [math.sqrt(a**2 - b**2) / 2 for a, b in zip(d_a, d_b)]
    eps_alpha = (sum(rho) - 0.5 * math.sin(alpha_wt)) / (math.pi * 8e-3 / math.cos(beta) * math.cos(alpha_t))
    eps_beta = 0.1 * math.sin(beta) / (math.pi * 8e-3)
    load = MeshLoad(
        sigma_H0=1206.58207e6,
        K_H=(1301.35343 / 1206.58207) ** 2,
        K_F=1.0,
        alpha_wt=alpha_wt,
        eps_alpha=eps_alpha,
        eps_alphan=1.6,
        eps_beta=eps_beta,
        m_n=8e-3,
        v=2.664,
        nu_40=320e-6,
        flank_rz=6e-6,
        root_rz=10e-6,
        grade=5,
    )
    sides = [
        WheelStrength(
            name=name,
            strength=EH,
            teeth=z,
            tip_diameter=a,
            base_diameter=b,
            tooth_depth=18e-3,
            rim=None,
            q_s=2.5,
            sigma_F0=200e6,
            loading="pulsating",
            cycles=N,
        )
        for name, z, a, b, N in zip(("pinion", "wheel"), (17, 103), d_a, d_b, (1.080e9, 1.783e8))
    ]
    return *sides, load


def test_example_1_of_iso_tr_6336_30():
    found = mesh_strength(*example_1())
    assert found.lubricant_factor == pytest.approx(1.04739, abs=5e-6)
    assert found.velocity_factor == pytest.approx(0.96911, abs=5e-6)
    assert found.roughness_factor == pytest.approx(0.96599, abs=5e-6)
    pinion, wheel = (found.contact[name] for name in ("pinion", "wheel"))
    assert (pinion.Z_BD, wheel.Z_BD, pinion.Z_W, wheel.Z_W) == (1, 1, 1, 1)
    assert pinion.sigma_HP / 1e6 == pytest.approx(1338.48, abs=0.05)  # S_Hmin = 1; cycles are printed to four digits
    assert wheel.sigma_HP / 1e6 == pytest.approx(1414.53, abs=0.05)
    assert pinion.S_H == pytest.approx(1.0285, abs=5e-5) and wheel.S_H == pytest.approx(1.0870, abs=5e-5)
    assert found.safety_contact == pinion.S_H
    assert found.safety_contact_load == pinion.S_H**2


# --- a mesh
def test_root_safety_is_the_product_of_its_factors():
    pinion, wheel, load = example_1()
    found = mesh_strength(pinion, wheel, replace(load, K_F=1.3)).bending["pinion"]
    assert found.sigma_FG == pytest.approx(425e6 * 2 * found.Y_NT * found.Y_drelT * found.Y_RrelT * found.Y_X)
    assert (found.Y_X, found.Y_drelT) == (pytest.approx(1.05 - 0.08), pytest.approx(1))
    assert found.S_F == pytest.approx(found.sigma_FG / (1.3 * 200e6))
    assert found.sigma_FP == pytest.approx(found.sigma_FG / 1.4)  # S_F,min of this program


def test_an_idler_is_weaker_at_its_root_only():
    pinion, wheel, load = example_1()
    one, two = mesh_strength(pinion, wheel, load), mesh_strength(replace(pinion, loading="reversed"), wheel, load)
    assert two.bending["pinion"].S_F == pytest.approx(0.7 * one.bending["pinion"].S_F)
    assert two.safety_contact == one.safety_contact


def test_safety_falls_with_the_load_and_its_root():
    pinion, wheel, load = example_1()
    one, four = (
        mesh_strength(pinion, wheel, load),
        mesh_strength(pinion, wheel, replace(load, K_H=4 * load.K_H, K_F=4 * load.K_F)),
    )
    assert four.safety_contact == pytest.approx(one.safety_contact / 2)
    assert four.safety_contact_load == pytest.approx(one.safety_contact_load / 4)
    assert four.bending["wheel"].S_F == pytest.approx(one.bending["wheel"].S_F / 4)


def test_the_order_of_the_wheels_does_not_matter():
    pinion, wheel, load = example_1()
    wheel = replace(wheel, strength=QT)
    one, two = mesh_strength(pinion, wheel, load), mesh_strength(wheel, pinion, load)
    assert vars(one.contact["wheel"]) == vars(two.contact["wheel"]) and vars(one.bending["pinion"]) == vars(
        two.bending["pinion"]
    )
    assert one.safety_contact == two.safety_contact == one.contact["wheel"].S_H


def test_the_film_is_that_of_the_softer_wheel():
    pinion, wheel, load = example_1()
    assert (
        mesh_strength(pinion, replace(wheel, strength=QT), load).lubricant_factor
        > mesh_strength(pinion, wheel, load).lubricant_factor
    )


def test_values_have_the_contract_names():
    found = {v.id: v for v in published(mesh_strength(*example_1()), "gears.pinion_wheel")}
    assert found["gears.pinion_wheel.safety_contact"].symbol == "S_H"
    assert found["gears.pinion_wheel.safety_bending_wheel"].label == "Safety against tooth breakage of wheel"
    assert found["gears.pinion_wheel.rated_contact_stress_pinion"].shown == pytest.approx(1301.35343)
    assert len(found) == 5 + 2 * (len(s.CONTACT) + len(s.BENDING))


def test_without_load_there_is_no_safety_and_no_check():
    pinion, wheel, load = example_1()
    idle = mesh_strength(replace(pinion, sigma_F0=0.0), replace(wheel, sigma_F0=0.0), replace(load, sigma_H0=0.0))
    assert idle.safety_contact is None and idle.safety_contact_load is None
    assert not tuple(strength_checks({"pinion_wheel": idle}))
    assert not any("safety" in v.id for v in published(idle, "gears.m"))
    assert strength_tables({"pinion_wheel": idle})[0].rows[0][2] is None


def test_checks():
    meshes = {"pinion_wheel": mesh_strength(*example_1())}
    found = {c.id: c for c in strength_checks(meshes)}
    assert set(found) == {
        "gears.pinion_wheel.safety_contact",
        "gears.pinion_wheel.safety_contact_usual",
        "gears.pinion.safety_bending",
        "gears.pinion.safety_bending_usual",
        "gears.wheel.safety_bending",
        "gears.wheel.safety_bending_usual",
    }
    contact = found["gears.pinion_wheel.safety_contact"]
    assert (
        contact.verdict == "warn"
        and contact.limit == 1.0
        and "weaker: pinion" in contact.name
        and "on load 1.06" in contact.name
    )
    assert found["gears.pinion_wheel.safety_contact_usual"].verdict == "note"
    assert "1.36 times the face width" in found["gears.pinion_wheel.safety_contact_usual"].advice  # (1.2/1.0285)²
    assert found["gears.pinion.safety_bending"].verdict == "pass"


def test_advice_on_width_would_just_pass():
    pinion, wheel, load = example_1()
    weak = mesh_strength(pinion, wheel, replace(load, K_H=2 * load.K_H, K_F=4.0))
    need = {c.id: c for c in strength_checks({"pinion_wheel": weak})}
    width = (1 / weak.safety_contact) ** 2
    assert (
        f"{width:.3g} times" in need["gears.pinion_wheel.safety_contact"].advice
        and need["gears.pinion_wheel.safety_contact"].verdict == "fail"
    )
    assert mesh_strength(pinion, wheel, replace(load, K_H=2 * load.K_H / width)).safety_contact == pytest.approx(1)
    assert need["gears.pinion.safety_bending"].verdict == "fail"


def test_bending_is_judged_by_the_weakest_mesh_of_a_wheel():
    pinion, wheel, load = example_1()
    light, heavy = (
        mesh_strength(pinion, wheel, load),
        mesh_strength(replace(pinion, name="other"), wheel, replace(load, K_F=1.5)),
    )
    found = {c.id: c for c in strength_checks({"pinion_wheel": light, "other_wheel": heavy})}
    assert found["gears.wheel.safety_bending"].value == pytest.approx(heavy.bending["wheel"].S_F)
    assert "in other–wheel" in found["gears.wheel.safety_bending"].name


def test_tables_cover_the_factors_and_not_the_safeties():
    meshes = {"pinion_wheel": mesh_strength(*example_1())}
    flanks, roots = strength_tables(meshes)
    assert [row[:2] for row in flanks.rows] == [("pinion–wheel", "pinion"), ("pinion–wheel", "wheel")]
    assert flanks.columns[3] == ("σ_H", "MPa") and flanks.rows[0][3] == pytest.approx(1301.35343)
    shown = {v.id for v in published(meshes["pinion_wheel"], "gears.pinion_wheel")}
    of_wheels = {id for id in shown if id.endswith(("_pinion", "_wheel")) and "safety" not in id}
    assert {*flanks.covers, *roots.covers} == of_wheels
    assert len(roots.columns) == len(roots.rows[0])


def test_notes_say_what_was_assumed():
    pinion, wheel, load = example_1()
    endless = replace(pinion, cycles=None, strength=strength_class())
    notes = " ".join(strength_notes({"m": mesh_strength(endless, wheel, load)}, 2006))
    assert "5·10⁷ cycles" in notes and "Wheel pinion: strength class not given" in notes and "f_ZCa" not in notes
    brief = " ".join(
        strength_notes({"m": mesh_strength(replace(pinion, cycles=1e5), replace(wheel, cycles=1e11), load)}, 2019)
    )
    assert (
        "Short life of pinion" in brief
        and "10¹⁰ cycles of wheel" in brief
        and "f_ZCa" in brief
        and "No life" not in brief
    )


def test_rough_roots_are_out_of_range():
    assert roughness_check(16e-6).verdict == "pass" and roughness_check(63e-6).verdict == "note"


def test_every_line_belongs_to_a_wheel_or_the_mesh():
    with trace() as lines:
        found = mesh_strength(*example_1())
    assert all("pinion" in line.about for line in lines)
    for number, symbol in ((found.safety_contact, "S_H"), (found.lubricant_factor, "Z_L")):
        line = link_of(number)
        assert line in lines and (line.formula.symbol, line.value) == (symbol, number)
