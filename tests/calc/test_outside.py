"""The world outside: values of publications beside the public functions, what is met and what is not
(tests/reference/outside.toml)."""

import math
import tomllib
from pathlib import Path

import numpy as np
import pytest

from calc.bearings.plain.film import dynamics as d
from calc.bearings.plain.film import short_bearing as short
from calc.bearings.plain.film.dynamics import coefficients
from calc.bearings.plain.film.table import eccentricity_from, film_at
from calc.countershaft.bending.beam import beam, bend, natural_frequency
from calc.countershaft.making.unbalance import lever_front, lever_rear, plane_unbalance
from calc.gears import formulas as g
from calc.gears.measures import formulas as m
from calc.library.catalogue import Oil
from calc.library.lubricant import Lubricant
from calc.library.oil_formulas import density, viscosity_index
from calc.library.table_file import TABLES
from calc.library.tolerances import permitted_unbalance

CASES = tomllib.loads((Path(__file__).parents[1] / "reference" / "outside.toml").read_text(encoding="utf-8"))["case"]
STIFF = np.inf  # Bernoulli's beam: no shear


def half_digit(printed):
    return 0.5 * 10.0 ** -len(printed.partition(".")[2])


# --- what a case asks for
def sommerfeld(c):
    return (
        (c["diameter"] / 2 / c["clearance"]) ** 2
        * c["viscosity"]
        * c["speed"]
        / (c["load"] / c["diameter"] / c["length"])
    )


def in_units(k, c):
    """Coefficients over the load in MN/m and kN·s/m."""
    F, g_, omega = c["load"], c["clearance"], 2 * math.pi * c["speed"]
    stiff = {f"K_{ij}": k[f"k_{ij}"] * F / g_ / 1e6 for ij in ("xx", "xy", "yx", "yy")}
    return stiff | {f"C_{ij}": abs(k[f"c_{ij}"]) * F / g_ / omega / 1e3 for ij in ("xx", "xy", "yy")}


def short_bearing(c):
    """The formulas of this program on the closed forms of the short bearing; its slopes by differences."""
    b = c["length"] / c["diameter"]
    e, step = float(short.eccentricity(sommerfeld(c), b)), 1e-6
    q = math.log(short.sommerfeld_din(eps=e + step, b=b) / short.sommerfeld_din(eps=e - step, b=b)) / (2 * step)
    a = (short.attitude_angle(eps=e + step) - short.attitude_angle(eps=e - step)) / (2 * step)
    phi, c_rr = short.attitude_angle(eps=e), short.radial_damping(eps=e)
    k = {
        "k_xx": d.k_xx(q=q, phi=phi),
        "k_xy": d.k_xy(q=q, phi=phi),
        "k_yx": d.k_yx(eps=e, phi=phi, a=a),
        "k_yy": d.k_yy(eps=e, phi=phi, a=a),
        "c_xx": d.c_xx(c_rr=c_rr, eps=e, phi=phi),
        "c_xy": d.c_xy(c_rr=c_rr, eps=e, phi=phi),
        "c_yy": d.c_yy(c_rr=c_rr, eps=e, phi=phi),
    }
    return {"eps": e} | in_units(k, c)


def finite_bearing(c):
    b = c["length"] / c["diameter"]
    e = float(eccentricity_from(sommerfeld(c), b))
    return {"eps": e} | in_units(vars(coefficients(e, b)), c)


def full_film(eps, length_ratio):
    film = film_at(eps, length_ratio)
    return vars(coefficients(eps, length_ratio)) | {
        "S": film.sommerfeld,
        "eps": eps,
        "phi": math.degrees(film.attitude),
    }


def viscosity(c):
    oil = Oil(
        name="oil", nu40=c["nu_40"] * 1e-6, nu100=c["nu_100"] * 1e-6, rho15=c.get("rho_15", 900.0), base="mineral"
    )
    state = Lubricant(oil, c.get("law", "walther")).at(c.get("T", 40.0))
    return {"nu": state.nu * 1e6, "mu": state.mu * 1e3, "index": viscosity_index(oil.nu40, oil.nu100)}


def measured_oils(rho_15, row):
    """Of an oil by its viscosity at 30 and 100 °C: that at 60, and the rise with pressure from the viscosities as
    measured, in 1/GPa."""
    mu, c = [float(x) for x in row[:3]], 0.6

    def straight(nu):
        return math.log10(math.log10(nu + c))

    cold, hot = (mu[i] / density(rho_15=rho_15, T=T) * 1e3 for i, T in ((0, 30.0), (2, 100.0)))
    share = math.log(313.15 / 303.15) / math.log(373.15 / 303.15)
    nu_40 = 10**10 ** (straight(cold) + share * (straight(hot) - straight(cold))) - c
    oil = Lubricant(Oil(name="oil", nu40=nu_40 * 1e-6, nu100=hot * 1e-6, rho15=rho_15, base="mineral"))
    rise = {f"alpha_{T}": oil.alpha(mu=x * 1e-3) * 1e9 for T, x in zip((30, 60, 100), mu)}
    return {"mu_60": oil.at(60.0).mu * 1e3} | rise


def continuous(c):
    """Reactions on, and moments over, the supports; the largest moment between them and the largest deflection, E·I =
    1."""
    ends = [0.0, *np.cumsum(c["spans"])]
    n = len(c["spans"])
    forces = tuple(zip(*c["forces"])) if "forces" in c else ((), ())
    bent = bend(beam(ends, [1.0] * n, [STIFF] * n, [0.0] * n, c["load"], ends, forces=forces, longest=0.02))
    found = {f"R_{i}": -float(R.real) for i, R in enumerate(bent.reactions)}
    found |= {f"M_{i}": float(bent.moment_at(z).real) for i, z in enumerate(ends)}
    return found | {"M_most": float(bent.moment.real.max()), "w_most": float(bent.w.real.max())}


def shaft_of_shigley(_):
    """In inches and pounds; influence coefficients in 10⁻⁴ in/lbf."""
    EI, length, places, weights = 30e6 * math.pi / 64, 31.0, [7.0, 20.0], [35.0, 55.0]

    def deflection(forces):
        bent = bend(
            beam([0, length], [EI], [STIFF], [0.0], [0.0], [0, length], forces=(places, forces), longest=length)
        )
        return [float(bent.w[np.abs(bent.z - z).argmin()].real) for z in places]

    (a, b), (_, e), y = deflection([1.0, 0.0]), deflection([0.0, 1.0]), deflection(weights)
    masses = (places, [w / 386.1 for w in weights])
    omega = natural_frequency(beam([0, length], [EI], [STIFF], [1e-6], [0.0], [0, length], masses=masses, longest=1.0))
    return {"delta_11": a * 1e4, "delta_12": b * 1e4, "delta_22": e * 1e4, "y_1": y[0], "y_2": y[1], "omega": omega}


def unbalance(c):
    omega = 2 * math.pi * c["speed"]
    U = permitted_unbalance(G=c["grade"] * 1e-3, m_S=c["mass"], omega=omega)
    z = dict(z_f=0.0, z_S=c["to_A"], z_r=c["to_A"] + c["to_B"])
    planes = {
        plane: plane_unbalance(U=U, q=q, q_max=0.7) * 1e3
        for plane, q in (("U_A", lever_front(**z)), ("U_B", lever_rear(**z)))
    }
    return {"U_per": U * 1e3, "e_per": U / c["mass"] * 1e6} | planes


def over_wires(c):
    """Pitch 1, 20°; by number of teeth."""
    alpha, found = math.radians(20), {}
    for z in range(6, 42, 2):
        d_b = z * math.cos(alpha)
        inv = m.ball_involute(s_t=math.pi / 2, d=z, alpha_t=alpha, D_M=c["wire"], d_b=d_b, beta_b=0.0, z=z)
        found[str(z)] = m.over_balls_even(
            d_K=m.ball_centre_diameter(d_b=d_b, alpha_K=g.angle_of_involute(inv)), D_M=c["wire"]
        )
    return found


def chordal_radial(c):
    """The transverse system of a wheel made the normal one."""
    beta = math.radians(c["beta"])
    alpha_n, m_n, x = (
        math.atan(math.tan(math.radians(c["alpha_t"])) * math.cos(beta)),
        c["m_t"] * math.cos(beta),
        c["x_t"] / math.cos(beta),
    )
    z_v = m.virtual_teeth(z=c["teeth"], beta=beta)
    psi = m.half_tooth_angle(z_v=z_v, x=x, alpha_n=alpha_n)
    return {"s_n": m.normal_thickness(m_n=m_n, x=x, alpha_n=alpha_n), "z_v": z_v, "psi": math.degrees(psi)}


CHECKS = {
    f.__name__: f
    for f in (
        short_bearing,
        finite_bearing,
        viscosity,
        continuous,
        shaft_of_shigley,
        unbalance,
        over_wires,
        chordal_radial,
    )
}


# --- the tests
@pytest.mark.parametrize("case", [c for c in CASES if c["check"] in CHECKS], ids=lambda c: c["name"])
def test_what_is_published(case):
    found = CHECKS[case["check"]](case["inputs"])
    for name, printed in case["expect"].items():
        assert found[name] == pytest.approx(
            float(printed), abs=case.get("tolerance", {}).get(name, half_digit(printed))
        ), name
    for unmet in case.get("unmet", ()):
        for name, printed in unmet["printed"].items():
            assert abs(found[name] - float(printed)) > half_digit(printed), f"{name} is met now: move it to `expect`"
            assert found[name] == pytest.approx(unmet["ours"][name], rel=1e-4), name


@pytest.mark.parametrize("case", [c for c in CASES if c["check"] == "full_film"], ids=lambda c: c["name"])
def test_how_far_a_bearing_with_grooves_is_from_the_whole_film(case):
    """The film of a bearing with two axial grooves beside the load begins behind a groove and not at its widest
    place."""
    columns = case["columns"]
    theirs = {name: np.array([float(row[i]) for row in case["rows"]]) for i, name in enumerate(columns)}
    ours = [full_film(eps, case["inputs"]["length_ratio"]) for eps in theirs["eps"]]
    for name, (least, most) in case["apart"].items():
        kind = name[:2]  # stiffness over the largest of its row, damping too
        of = (
            np.max([abs(theirs[c]) for c in columns if c[:2] == kind], axis=0) if kind in ("k_", "c_") else theirs[name]
        )
        share = 100 * (np.array([one[name] for one in ours]) - theirs[name]) / of
        assert (share.min(), share.max()) == pytest.approx((least, most), abs=0.06), name
    assert set(case["apart"]) == set(columns) - {"eps"} and case["why"]


@pytest.mark.parametrize("case", [c for c in CASES if c["check"] == "measured_oils"], ids=lambda c: c["name"])
def test_how_far_the_oils_are_from_measured_ones(case):
    for name, (least, most) in case["apart"].items():
        i = case["columns"].index(name)
        both = [(measured_oils(case["inputs"]["rho_15"], row)[name], float(row[i])) for row in case["rows"] if row[i]]
        share = [100 * (ours / theirs - 1) for ours, theirs in both]
        assert (min(share), max(share)) == pytest.approx((least, most), abs=0.06), name


def test_every_case_says_where_it_is_from_and_whether_it_was_read():
    assert len({c["name"] for c in CASES}) == len(CASES)
    for case in CASES:
        assert case["status"] in ("read", "from memory") and len(case["source"]) > 40, case["name"]
        assert ("tolerance" in case) == ("because" in case), case["name"]
        assert all(unmet["why"] and set(unmet["printed"]) == set(unmet["ours"]) for unmet in case.get("unmet", ())), (
            case["name"]
        )


def test_there_are_many_of_them():
    """At least 25 cases in 120 numbers, with those of the table of validation that say so too."""
    table = tomllib.loads((TABLES / "validation.toml").read_text(encoding="utf-8"))
    there = [c for c in table["case"] + table["oil"] if "; read" in c["source"] or "; from memory" in c["source"]]
    numbers = [len(c.get("expect", "1")) for c in there]
    numbers += [
        len(c.get("expect", ())) + sum(len(u["printed"]) for u in c.get("unmet", ())) + sum(map(len, c.get("rows", ())))
        for c in CASES
    ]
    assert len(numbers) >= 25 and sum(numbers) >= 120
