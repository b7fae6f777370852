"""Published gears: every printed value of the source's first pair, and the worked examples of others."""

import math

import pytest

from calc.gears import formulas as f
from calc.gears.backlash.formulas import tolerance_of_contributors
from calc.gears.measures import formulas as m
from calc.gears.rating import source_sheet as sheet
from calc.gears.rating import stress as s
from calc.gears.rating.mesh_strength import section, tooth_form
from calc.gears.solve import geometry
from tests.calc.gears.trains import SPEED, mesh, pair_1, reference, shown, solved, train, wheel

FINOTTI = reference("gears_finotti_pair_1.toml")
EXAMPLES = reference("gears_examples.toml")["example"]


def half_digit(printed):
    return 0.5 * 10.0 ** -len(printed.partition(".")[2])


# --- the source's first pair
def printed(quantity, wheel):
    return next(float(r["printed"]) for r in FINOTTI["row"] if r["quantity"] == quantity and r.get("wheel") == wheel)


def of_pair(row):
    """Values of the pair as a whole."""
    t = solved(pair_1())
    x = sum(w.profile_shift for w in t.wheels.values())
    mesh_ = t.meshes["central_idler"]
    values = shown(geometry(pair_1(), SPEED))
    return {
        "m_t": values["transverse_module"],
        "alpha_t": values["transverse_pressure_angle"],
        "beta_b": values["base_helix_angle"],
        "alpha_wt": values["central_idler.working_pressure_angle"],
        "beta_w": values["central_idler.working_helix_angle"],
        "m_wt": values["central_idler.working_diameter_driver"] / 36,
        "x_sum": x,
        "k*m_n": values["central_idler.standard_tip_shortening"],
        "eps_alpha": mesh_.transverse_contact_ratio,
        "eps_beta": mesh_.overlap_ratio,
        "eps_gamma": mesh_.total_contact_ratio,
        "H_0": sheet_of(t).tool_addendum,
        "sigma_H": sheet_of(t).contact_stress / 1e7,
        "Y_beta": s.helix_factor_root(mesh_.overlap_ratio, t.system.beta),
        "RSS": 2e3
        * tolerance_of_contributors(
            [c * 1e-3 for k in ("36", "39") for c in FINOTTI["inputs"][f"contributors_{k}_mm"]]
        ),
    }[row["quantity"]]


def sheet_of(t):
    """The sheet with 1.35 kW at 2600 rpm on the driver, as the source enters them."""
    wheels = t.wheels["central"], t.wheels["idler"]
    return sheet.sheet(t.system, t.meshes["central_idler"], wheels, 1350.0 / (2 * math.pi * SPEED))


def of_wheel(row):
    """Values of one wheel of the pair."""
    z, allowance = row["wheel"], [row.get("allowance_mm", 0.0) * 1e3] * 2
    span = (5, 5) if row["quantity"] == "W_5" else (5, 6)
    gears = pair_1(row.get("tip_cut_mm", 0.2), (allowance, allowance), span)
    t, name, side = solved(gears), {36: "central", 39: "idler"}[z], {36: "driver", 39: "driven"}[z]
    values = shown(geometry(gears, SPEED))
    w, pair, system = t.wheels[name], t.meshes["central_idler"], t.system
    alpha_t, d_w = system.transverse_pressure_angle, getattr(pair, f"working_diameter_{side}")

    def thickness(d_y):
        return 1e3 * f.thickness_at(
            d_y, w.reference_thickness, w.reference_diameter, alpha_t, f.pressure_angle_at(w.base_diameter, d_y)
        )

    d_Ff = printed("d_Ff", z) * 1e-3
    return {
        "x_min": lambda: w.undercut_limit,
        "x": lambda: w.profile_shift,
        "x m_n": lambda: 2 * w.profile_shift,
        "d_a": lambda: values[f"{name}.tip_diameter"],
        "d": lambda: values[f"{name}.reference_diameter"],
        "d_w": lambda: values[f"central_idler.working_diameter_{side}"],
        "d_Nf": lambda: values[f"central_idler.sap_diameter_{side}"],
        "d_Ff": lambda: values[f"{name}.form_diameter"],
        "TIF margin": lambda: (values[f"central_idler.sap_diameter_{side}"] - d_Ff * 1e3) / 2,
        "d_f": lambda: values[f"{name}.root_diameter"],
        "c": lambda: values[f"central_idler.tip_clearance_{side}"],
        "d_b": lambda: values[f"{name}.base_diameter"],
        "s_at": lambda: values[f"{name}.tip_thickness"],
        "s_wt": lambda: thickness(d_w),
        "zeta_LPSTC": lambda: -values[f"central_idler.specific_sliding_lpstc_{side}"],
        "zeta_SAP": lambda: -values[f"central_idler.specific_sliding_{side}"],
        "s_Ft": lambda: thickness(d_Ff),
        "W_5": lambda: values[f"{name}.span_5"],
        "W_6": lambda: values[f"{name}.span_6"],
        "M_dK": lambda: values[f"{name}.over_balls_max"],
        "alpha_tr": lambda: math.degrees(getattr(sheet_of(t), f"ball_angle_{side}")),
        "ball": lambda: 1e3 * getattr(sheet_of(t), f"ideal_ball_{side}"),
        "Y_F": lambda: getattr(sheet_of(t), f"form_factor_{side}"),
        "Y_S": lambda: getattr(sheet_of(t), f"stress_correction_{side}"),
        "q_s": lambda: section(system, w).q_s,
        "sigma_F": lambda: getattr(sheet_of(t), f"root_stress_{side}") / 1e7,
    }[row["quantity"]]()


@pytest.mark.parametrize(
    "row", FINOTTI["row"], ids=lambda r: f"{r['place']} {r['quantity']} {r.get('wheel', '')}".strip()
)
def test_first_pair_of_finotti(row):
    tolerance = 0.016 if row["quantity"] == "d_Ff" else half_digit(row["printed"])
    computed = of_wheel(row) if "wheel" in row else of_pair(row)
    assert computed == pytest.approx(float(row["printed"]), abs=tolerance)


@pytest.mark.parametrize(
    "quantity, cut, printed",
    [
        ("specific_sliding_driver", 0.0, -0.952),
        ("specific_sliding_driver", 0.2, -0.818),
        ("transverse_contact_ratio", 0.0, 1.556),
        ("transverse_contact_ratio", 0.2, 1.485),
        ("sap_diameter_driver", 0.0, 74.565),
        ("sap_diameter_driver", 0.2, 74.794),
        ("tip_clearance_driver", 0.0, 0.817),
        ("tip_clearance_driver", 0.2, 1.017),
        ("specific_sliding_lpstc_driven", 0.0, -0.274),
        ("specific_sliding_lpstc_driven", 0.2, -0.358),
    ],
)
def test_what_a_tip_cut_on_the_idler_changes(quantity, cut, printed):
    """Finotti 2013, Table 4.4 and Fig. 4.20: a cut on one wheel changes the other."""
    assert shown(geometry(pair_1(cut), SPEED))[f"central_idler.{quantity}"] == pytest.approx(printed, abs=5e-4)


@pytest.mark.parametrize(
    "name, side, chord, exact", [("central", "driver", 3.309, 3.236), ("idler", "driven", 3.570, 3.492)]
)
def test_the_ball_that_the_source_meant(name, side, chord, exact):
    """With the sum of the two angles the source's formula gives 3.309 and 3.570 mm, right for spur teeth; the helix
    takes 2 % off."""
    t = solved(pair_1())
    w, pair, system = t.wheels[name], t.meshes["central_idler"], t.system
    d_w, alpha_wt, alpha_t = (
        getattr(pair, f"working_diameter_{side}"),
        pair.working_pressure_angle,
        system.transverse_pressure_angle,
    )
    s_w = f.thickness_at(d_w, w.reference_thickness, w.reference_diameter, alpha_t, alpha_wt)
    eta = math.pi / w.teeth - s_w / d_w
    assert 1e3 * sheet.ball(d_w, system.base_helix_angle, eta, alpha_wt + eta) == pytest.approx(chord, abs=5e-4)
    ball = m.ball_for_contact(
        w.reference_thickness,
        w.reference_diameter,
        alpha_t,
        w.teeth,
        w.base_diameter,
        system.base_helix_angle,
        alpha_wt,
    )
    assert ball * 1e3 == pytest.approx(exact, abs=5e-4)


# --- examples of others
def inputs_of(example):
    """The gears of an example; a single wheel is paired with itself."""
    given = example["inputs"]
    teeth, x = given["teeth"], [*given.get("x", []), None, None][:2]
    if "x_driven" in given:
        x[1] = given["x_driven"]
    if len(teeth) == 1:
        teeth, x = teeth * 2, [x[0], x[0]]

    def made(cut=0.0):
        wheels = [wheel(name, z, shift, cut=cut) for name, z, shift in zip("ab", teeth, x)]
        return train(
            wheels,
            [mesh("a", "b", given.get("a"))],
            m_n=given["m_n"],
            beta=given.get("beta", 0.0),
            b=given.get("face_width", 10.0),
            tool=given.get("tool", (1.25, 0.38)),
            ball=given.get("ball"),
        )

    if given.get("standard_tip_shortening"):
        return made(solved(made()).meshes["a_b"].standard_tip_shortening * 1e3)
    return made()


def quantities(example):
    """Every quantity that an example may print: name → value."""
    gears = inputs_of(example)
    outcome = geometry(gears, SPEED)
    t, v = outcome.result, shown(outcome)
    a, b, pair, system = t.wheels["a"], t.wheels["b"], t.meshes["a_b"], t.system
    m_n, alpha_n, alpha_t, z = system.m_n, system.alpha_n, system.transverse_pressure_angle, a.teeth
    alpha_V = f.pressure_angle_at(a.base_diameter, a.reference_diameter + 2 * a.profile_shift * m_n)
    s_t, beta_b = a.reference_thickness, system.base_helix_angle
    inv_phi = m.ball_involute(s_t, a.reference_diameter, alpha_t, a.ball_diameter, a.base_diameter, beta_b, z)
    z_v = m.virtual_teeth(z, system.beta)
    cut = section(system, a)
    form = tooth_form(system, a, 1.0)
    inv_wt = f.working_involute(alpha_t, alpha_n, a.profile_shift, b.profile_shift, z, b.teeth)
    return {
        "inv_aw": inv_wt,
        "inv_awt": inv_wt,
        "aw": v["a_b.working_pressure_angle"],
        "awt": v["a_b.working_pressure_angle"],
        "a": v["a_b.centre_distance"],
        "y": (pair.centre_distance - (a.reference_diameter + b.reference_diameter) / 2) / m_n,
        "x1": a.profile_shift,
        "x_sum": a.profile_shift + b.profile_shift,
        "eps_alpha": pair.transverse_contact_ratio,
        "dw1": v["a_b.working_diameter_driver"],
        "dw2": v["a_b.working_diameter_driven"],
        "h": (v["a.tip_diameter"] - v["a.root_diameter"]) / 2,
        **{
            f"{key}{i}": v[f"{name}.{long}_diameter"]
            for i, name in ((1, "a"), (2, "b"))
            for key, long in (("d", "reference"), ("db", "base"), ("da", "tip"), ("d_a", "tip"), ("df", "root"))
        },
        "ha1": (v["a.tip_diameter"] - v["a.reference_diameter"]) / 2,
        "ha2": (v["b.tip_diameter"] - v["b.reference_diameter"]) / 2,
        "mt": v["transverse_module"],
        "d": v["a.reference_diameter"],
        "db": v["a.base_diameter"],
        "at": v["transverse_pressure_angle"],
        "bb": v["base_helix_angle"],
        "st": s_t * 1e3,
        "sn": s_t * 1e3 * math.cos(system.beta),
        "s": s_t * 1e3,
        "s_n": s_t * 1e3 * math.cos(system.beta),
        "k_th": m.span_teeth(z, alpha_V, beta_b, alpha_t, a.profile_shift, alpha_n),
        "W4": v.get("a.span_4"),
        "W5": v.get("a.span_5"),
        "inv_phi": inv_phi,
        "phi": math.degrees(f.angle_of_involute(inv_phi)),
        "M": v.get("a.over_balls"),
        "z_v": z_v,
        "psi": math.degrees(m.half_tooth_angle(z_v, a.profile_shift, alpha_n)),
        "s_c": v["a.chordal_thickness"],
        "h_c": v["a.chordal_height"],
        "YF": form.Y_F,
        "YS": form.Y_S,
        "sFn": cut.chord,
        "rhoF": cut.chord / (2 * cut.q_s),
    }


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda e: e["name"])
def test_published_examples(example):
    computed = quantities(example)
    for name, text in example["published"].items():
        tolerance = max(min(half_digit(text), 5e-3), 1e-13 * float(text), example.get("tolerance", {}).get(name, 0.0))
        assert computed[name] == pytest.approx(float(text), abs=tolerance), name
