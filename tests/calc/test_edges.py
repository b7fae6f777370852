"""No jump at the edges of tables: just left and just right of every knot the value is the same, or the source itself
jumps, and says so here."""

import math
import tomllib
from collections.abc import Callable, Iterable
from functools import partial
from itertools import pairwise

import numpy as np
import pytest

from calc.bearings.plain import checks as bearing_checks
from calc.bearings.plain.film import grooved as grooved_table
from calc.bearings.plain.film import table
from calc.bearings.plain.film.grooved import Feed, Feeds
from calc.bearings.plain.film.table import film_nodes
from calc.bearings.plain.routes import din31652 as falz
from calc.bearings.plain.routes import raimondi_boyd
from calc.countershaft.making import inputs as thread
from calc.engine.cycle import table_pressure
from calc.gears.rating import classes, distribution, dynamic, stress
from calc.gears.rating import strength as life
from calc.gears.rating import strength as root_strength
from calc.gears.rating.screening import load as screening_load
from calc.library import fatigue as notch
from calc.library import journal_rules
from calc.library import oil_formulas as viscosity_index
from calc.library import tolerances as fits
from calc.library.catalogue import Oil, ViscosityRow, shipped_oils
from calc.library.lubricant import Lubricant
from calc.library.table_file import TABLES
from calc.sheet import functions as erf

BESIDE = 1e-9  # of an edge, to each side
ALIKE = 2e-5  # of the value: what a root, which begins straight up, rises over so short a way; a line moves by far less
Function = Callable[[float], float]


def jump(function: Function, edge: float) -> float:
    """How far the values on both sides are apart, and each from that at the edge itself, as a part of them."""
    step = BESIDE * (abs(edge) or 1.0)
    left, at, right = function(edge - step), function(edge), function(edge + step)
    assert all(map(math.isfinite, (left, at, right)))
    return max(abs(left - right), abs(left - at), abs(at - right)) / max(abs(left), abs(right), 1e-300)


def knots(low: float, high: float, inner: Iterable[float]) -> list[float]:
    return [float(x) for x in inner if low < x < high]


# --- what goes on without a jump
CHARTS = tomllib.loads((TABLES / "raimondi_boyd.toml").read_text(encoding="utf-8"))["row"]
POINTS = ((20.0, 0.2), (40.0, 0.08), (70.0, 0.02), (100.0, 0.009))
ROWS = Oil(
    name="own",
    rho15=880.0,
    base="mineral",
    viscosities=tuple(ViscosityRow(temperature=T, viscosity=mu) for T, mu in POINTS),
)
GROOVES = Feeds(feeds=(Feed(math.pi / 2, 0.35), Feed(-math.pi / 2, 0.35)))
B = dynamic.Excitation(0.6, 0.4, 0.8)
LIVES = {kind: knees for kind, knees in life.ROOT_CURVES.items()} | {"V": life.ROOT_THROUGH}


def film(name: str, l: float) -> Function:
    return lambda eps: getattr(table.film_at(eps, l), name)


def smooth() -> Iterable[tuple[str, Function, list[float]]]:
    nodes = film_nodes()
    eps, ratios = nodes.eccentricities[1:-1].tolist(), nodes.length_ratios[1:-1].tolist()
    for name in ("sommerfeld", "attitude", "friction", "flow", "side_flow_ratio", "pressure_ratio", "radial_damping"):
        yield f"film table, {name} over the eccentricity", film(name, 0.43), eps
        yield f"film table, {name} over l/d", lambda l, name=name: getattr(table.film_at(0.61, l), name), ratios
    yield (
        "film table, turned round",
        lambda S: table.eccentricity_from(S, 0.43),
        [table.film_at(e, 0.43).sommerfeld for e in eps],
    )
    inner = np.tanh(grooved_table.grooved_table(0.5, GROOVES.feeds).x[1:-1]).tolist()
    for name in ("sommerfeld", "attitude", "side_flow", "pressure_ratio", "sheared", "k_xx", "c_yy"):
        yield (
            f"film with grooves, {name}",
            lambda e, name=name: getattr(grooved_table.film_at(e, 0.5, GROOVES), name),
            inner,
        )
    for place in range(6):
        edges = sorted({row["S"] for row in CHARTS})
        low, high = (
            max(min(r["S"] for r in CHARTS if r["length_ratio"] == b) for b in {r["length_ratio"] for r in CHARTS}),
            math.inf,
        )
        yield (
            f"Raimondi and Boyd over S, {place}",
            lambda S, place=place: raimondi_boyd.at(S, 0.4)[place],
            knots(low, high, edges),
        )
        yield f"Raimondi and Boyd over l/d, {place}", lambda b, place=place: raimondi_boyd.at(0.2, b)[place], [0.5, 1.0]
    yield "an oil's own rows", Lubricant(ROWS).nu, [40.0, 70.0]
    yield "an oil's own rows, on arrays", lambda T: float(Lubricant(ROWS).nu(np.array([T]))[0]), [40.0, 70.0]
    for oil in shipped_oils().values():
        if oil.viscosities[2:]:
            yield f"rows of {oil.name}", Lubricant(oil).nu, [row.temperature for row in oil.viscosities[1:-1]]
    cycle = 4 * math.pi
    angles, pressures = np.array([0.0, 1.0, 2.5, 9.0]), np.array([1e5, 60e5, 8e5, 1e5])
    for edge in ("a knot", [1.0, 2.5, 9.0]), ("the end of the cycle", [cycle]):
        yield f"gas pressure at {edge[0]}", lambda e: float(table_pressure(e, angles, pressures, cycle)), edge[1]
    yield (
        "error function",
        lambda x: float(np.asarray(erf.erf(np.array([x])))[0]),
        [n / erf.STEPS for n in (1, 7, 500, 1024, 3000)],
    )
    for kind, knees in LIVES.items():
        yield f"Y_NT of {kind}", partial(life.root_life, kind), [N for N, _ in knees]
    for kind in ("Eh", *life.FLANK_CURVES):
        yield f"Z_NT of {kind}", partial(life.flank_life, kind), [N for N, _ in life.flank_knees(kind)]
    for structural, rows in ((1.0, root_strength.SLIP_ST), (0.0, root_strength.SLIP_V)):
        slip = partial(lambda s, R: root_strength.slip_layer(R_p=R, structural=s), structural)
        yield f"slip layer {structural:g}", slip, [R * 1e6 for R, _ in rows]
    yield "K_Hβ", lambda x: (distribution.face_factor_whole if x <= 1 else distribution.face_factor_part)(xi=x), [1.0]
    yield "share that touches", lambda x: distribution.contact_share(xi=x), [1.0]
    yield (
        "K_α",
        lambda e: (distribution.pair_factor if e <= 2 else distribution.pair_factor_high)(eps_gamma=e, q_alpha=0.7),
        [2.0],
    )
    yield "K_V between the ranges", lambda N: dynamic.dynamic_factor(B, 1.7, N, 0.85), [1.15, 1.5]
    yield "C_v7", lambda e: dynamic._above(dynamic.Excitation(0, 0, 0), e), [1.5, 2.5]
    yield (
        "stiffness under a light load",
        lambda w: dynamic.light_load_stiffness(c=14e9, w=w) if w < dynamic.LIGHT else 14e9,
        [dynamic.LIGHT],
    )
    yield (
        "N_S under a light load",
        lambda w: dynamic.lower_resonance(w=w) if w < dynamic.LIGHT else 0.85,
        [dynamic.LIGHT],
    )
    yield "Z_ε over the overlap", lambda e: stress.contact_ratio_factor(1.6, e), [1.0]
    yield "K_Bγ", lambda e: screening_load.helical_load_factor(eps_gamma=e), [2.0, 3.5]
    yield "factor on the speed of transition", journal_rules.speed_factor, list(journal_rules.SPEED_FACTOR)
    for kind in (*root_strength.SIZE, "Eh"):
        a, b, least = root_strength.SIZE.get(kind, root_strength.SIZE_HARDENED)
        yield (
            f"Y_X of {kind}",
            partial(lambda a, b, Y, m: root_strength.size_factor(a=a, b=b, m_n=m, Y=Y), a, b, least),
            [5e-3, 25e-3, 30e-3],
        )


SMOOTH = {name: (function, edges) for name, function, edges in smooth()}


@pytest.mark.parametrize("name", SMOOTH)
def test_just_left_and_just_right_of_an_edge_the_value_is_the_same(name: str) -> None:
    function, edges = SMOOTH[name]
    found = {edge: far for edge in edges if (far := jump(function, edge)) > ALIKE}
    assert found == {}


# --- where the source itself jumps
def coefficients(eps_gamma: float) -> float:
    return dynamic.dynamic_factor(B, eps_gamma, 0.8, 0.85)


def reference_oils() -> list[float]:
    return [row[0] * 1e-6 for row in viscosity_index.REFERENCE_OILS if math.isfinite(row[0])]


JUMPS: dict[str, tuple[str, Function, list[float], float]] = {
    "notch factor of a shoulder": (
        "Pilkey fits Peterson's chart by two curves that meet at t/r = 2 within 0.1 to 3 %",
        lambda x: (notch.low_shoulder if x <= notch.BRANCH else notch.high_shoulder)(x=x, y=0.5), [notch.BRANCH], 0.03,
    ),
    "Falz's film at So = 1": (
        "Falz's two branches meet at l/d = 1 alone; the source's rule, shown beside the others and never judged by",
        lambda So: falz.film(60e-6, So, 0.5), [1.0], 0.6,
    ),
    "dynamic factor at ε_γ = 2": (
        "ISO 6336-1, Table 8: C_v2 to C_v6 have constants up to 2 and formulas above, rounded apart", coefficients,
        [2.0], 0.03,
    ),
    "dynamic factor at the main resonance": (
        "ISO 6336-1, 6.5.5: the factor of the resonance holds from N_S on at once",
        lambda N: dynamic.dynamic_factor(B, 1.7, N, 0.85), [0.85], 0.4,
    ),
    "load distribution at ε_αn = 2": (
        "ISO 6336-3:2019: two pairs share the load of spur teeth from 2 on at once",
        lambda e: (stress.load_distribution if e < 2 else stress.load_distribution_high)(0.3, e), [2.0], 0.3,
    ),
    "running in of soft flanks": (
        "ISO 6336-1, 8.3.5: above 5 and 10 m/s no more than that of 80 and 40 µm runs in, which a larger deviation "
        "meets at once",
        lambda v: distribution.running_in(100e-6, "V", 600e6, v), [5.0, 10.0], 0.6,
    ),
    "rounding of a tolerance": (
        "ISO 1328-1, 5.2.3 rounds its tolerances", lambda f: distribution.rounded(f=f), [4.95e-6, 7.25e-6, 20.5e-6],
        0.1,
    ),
    "teeth of grade 4 and ε_αn = 2.05": (
        "IACS UR M56: the line of deep teeth begins at 1.00070", lambda e: root_strength.deep_tooth_factor(4, e),
        [2.05], 1e-3,
    ),
    "surface factor at 1 µm": (
        "IACS UR M56: below 1 µm a constant, rounded to three digits", lambda R: root_strength.surface_factor("Eh",
        R), [1e-6], 0.03,
    ),
    "rim of 1.2 tooth depths": (
        "IACS UR M56: 1.6·ln(2.242/1.2) is 1.0001", lambda s: root_strength.rim_factor("w", 1e-3, s), [1.2e-3], 1e-3,
    ),
    "viscosity index, oil of index 0": (
        "ASTM D2270, X2: parabolas with rounded coefficients", lambda Y: viscosity_index.of_index_0(nu_100=Y),
        reference_oils(), 0.005,
    ),
    "viscosity index, oil of index 100": (
        "the same", lambda Y: viscosity_index.of_index_100(nu_100=Y), reference_oils(), 0.005,
    ),
    "least film of ISO 7902-3": (
        "a table by steps of diameter and speed, without anything between them",
        lambda u: bearing_checks.least_film(0.05, u) or 0.0, list(bearing_checks.SPEEDS), 0.5,
    ),
    "tolerance of a grade": (
        "ISO 286-1 gives a tolerance to a range of nominal sizes, each up to and including its end",
        lambda d: fits.tolerance(7, d), [end * 1e-3 for end in (30.0, 50.0, 80.0, 120.0)], 0.3,
    ),
    "coarsest pitch": ("ISO 261 has the threads that it has", thread._coarsest, [6.0, 10.0], 0.4),
}  # fmt: skip


@pytest.mark.parametrize("name", JUMPS)
def test_the_source_itself_jumps_by_no_more_than_is_said(name: str) -> None:
    why, function, edges, most = JUMPS[name]
    assert why and max(jump(function, edge) for edge in edges) <= most


@pytest.mark.parametrize("name", classes.class_names())
def test_strength_classes_go_on_where_one_line_ends(name: str) -> None:
    """ISO 6336-5 gives a class by straight lines over the hardness; they meet to the digits of the standard."""
    row = classes._row(name)
    for key, lines in row.items():
        if key.startswith(("contact_", "bending_")):
            for (A, B_1, _, end), (A_2, B_2, low, _) in pairwise(lines):
                assert low == end and A * end + B_1 == pytest.approx(A_2 * end + B_2, rel=2e-3), key
