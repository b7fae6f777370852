# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""Mixed friction: which share ξ of the load rides on the roughness, what both parts rub together, and the surfaces.

All depends on the film over the roughness, λ.  Where λ is small the peaks carry and rub through what the oil has left
on them; from about λ = 2 on the film carries all, and the friction is the film's.

The program judges by the load share of Zhu and Hu, full numerical solutions of contacts with measured roughness, and by
the load-sharing concept of Johnson, Greenwood and Poon: the film that carries 1 − ξ of the load has that part of the
pressure only, so that its oil is less thick (`traction.py`).  μ_s is that of *lubricated* peaks, 0.08.  Published for
ground gears and steel are 0.065 (FZG gears at the lowest speed) and 0.07 (both in Arana, Larrañaga and Ulacia 2018,
read), 0.08 (Robbe-Valloire 2002, read in the gear friction thesis), 0.09 and
0.1 (public programs of FEUP, read).  No constant was fitted here; what the four gears of FEUP, their fit on others, and
Schlenk say of the
choice, and of 240 others, stands in tests/calc/friction/models/test_measured_gears.py and designs/friction_source.md.

The gear friction thesis takes 1 − erf λ, the whole pressure for the film, and μ_s = 0.135 of rollers: beside,
unchanged.  The paper that it follows (Arana et al. 2018) has the same share with μ_s = 0.065 to 0.07, λ over the rms
roughness, and α under pressure.

Each law with where it comes from and where it holds; the ends are held, so that λ → 0 is all solid and λ → ∞ all film:

    zhu-hu          Zhu and Hu 2001, from memory                                   λ 0.05 to 2, all film above
    castro-seabra   Castro and Seabra 2007, from memory                            λ 0.1 to 2, all film above
    olver-spikes    Smeeth and Spikes 1996; Olver and Spikes 1998     any λ; 4 % still ride at λ = 4
    doleschel       Doleschel 2003, read in the thesis and in Arana et al.         λ over the mean Ra, 0 to 2
    thesis          after Diab 2006, changed; read in both                         λ 0 to 2

Matsumoto's law of the same table needs the peaks' height Rz and the least film, λ = h_min/(Rz_1 + Rz_2); it is not
offered."""

from collections.abc import Callable
from typing import Annotated, Any

import numpy as np

from ...library.contact import mean_roughness
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import cos, erf, largest, smallest, sqrt
from ...sheet.record import record, replace
from ...sheet.text import Amount, Text
from ...sheet.units import KelvinPerWatt, Metre, Number, Pascal, Radian
from ..inputs import FrictionInputs
from .geometry import MeshGeometry, require

THESIS = Text("gear friction thesis")
ZHU_HU = Text("Zhu and Hu 2001")
CASTRO = Text("Castro and Seabra 2007")
SHARING = Text("Johnson, Greenwood and Poon 1972, load-sharing concept")

BOUNDARY: Number = 0.08  # friction of lubricated peaks
PUBLISHED = (0.065, 0.10)  # its published values
DRY: Number = 0.135  # the gear friction thesis', after Masjedi and Khonsari's rollers
# λ below which lubrication is called boundary, above which full film: the widest that authors take, thesis 4.1
MIXED = (0.3, 3.5)
FULL: Number = 2.3  # λ above which the law of Zhu and Hu would fall again: the film carries all from 2.02 on


@formula("σ", Text("{thesis}, eq. 30: both roughnesses together", thesis=THESIS), unit="µm")
def combined_roughness(Ra_1: Metre, Ra_2: Metre) -> Metre:
    """>>> combined_roughness(Ra_1=8e-07, Ra_2=8e-07)
    1.131370...e-06
    """
    return sqrt(Ra_1**2 + Ra_2**2)


@formula("λ", Text("{thesis}, eq. 30: film over roughness", thesis=THESIS), governs="min")
def film_ratio(h: Metre, sigma: Metre) -> Number:
    return h / sigma


def regimes(lowest: Number, highest: Number) -> Text:
    """The kinds of lubrication from one λ to another."""
    kinds = Text("boundary"), Text("mixed"), Text("full-film")
    first, last = (sum(lam > limit for limit in MIXED) for lam in (lowest, highest))
    return kinds[first] if first == last else Text("{first} to {last}", first=kinds[first], last=kinds[last])


# --- how the load is shared


@formula(
    "ξ",
    Text("{thesis}, eq. 23, after Diab: share of the load on the roughness; it fades at λ = 2", thesis=THESIS),
    names={"lam": "λ"},
)
def solid_share(lam: Number) -> Number:
    return 1 - erf(lam)


@formula(
    "f_λ",
    Text("{zhu_hu}: share of the load on the film; all of it from λ = 2.02 on", zhu_hu=ZHU_HU),
    names={"lam": "λ"},
)
def film_share(lam: Number) -> Number:
    """>>> film_share(lam=0.4)
    0.6028...
    """
    return smallest(1.21 * smallest(lam, FULL) ** 0.64 / (1 + 0.37 * smallest(lam, FULL) ** 1.26), 1.0)


@formula(
    "f_λ",
    Text("{castro}: share of the load on the film; all of it from λ = 2.04 on", castro=CASTRO),
    names={"lam": "λ"},
)
def film_share_by_power(lam: Number) -> Number:
    """>>> film_share_by_power(lam=0.4)
    0.6344...
    """
    return smallest(0.82 * lam**0.28, 1.0)


@formula("ξ", "statics: what the film does not carry", names={"f": "f_λ"})
def solid_rest(f: Number) -> Number:
    return 1 - f


@formula("ξ", "Smeeth and Spikes 1996; Olver and Spikes 1998", names={"lam": "λ"})
def solid_share_by_square(lam: Number) -> Number:
    """>>> solid_share_by_square(lam=1.0)
    0.25
    """
    return 1 / (1 + lam) ** 2


@formula(
    "ξ", Text("Doleschel 2003; {thesis}, 3.4: λ over the mean roughness, up to 2", thesis=THESIS), names={"lam": "λ"}
)
def solid_share_by_parabola(lam: Number, sigma: Metre, Ra: Metre) -> Number:
    """>>> solid_share_by_parabola(lam=1.0, sigma=1e-06, Ra=1e-06)
    0.25
    """
    return largest(1 - lam * sigma / (2 * Ra), 0.0) ** 2


@formula("p_f", Text("{sharing}: mean pressure of the film", sharing=SHARING), unit="MPa")
def film_pressure(xi: Number, p_m: Pascal) -> Pascal:
    """>>> film_pressure(xi=0.3, p_m=800000000.0)
    560000000.0
    """
    return (1 - xi) * p_m


# --- what both rub together


@formula(
    "μ_z",
    Text("{thesis}, eq. 25: mixed friction", thesis=THESIS),
    meanings={"mu_s": "Coefficient of friction of the roughness"},
)
def friction(xi: Number, mu_s: Number, mu_f: Number) -> Number:
    return xi * mu_s + (1 - xi) * mu_f


@record
class LoadShare:
    """One law: its authors, and the share of the roughness from λ, the combined and the mean roughness."""

    title: Text
    solid: Callable[[Any, Metre, Metre], Any]


LOAD_SHARES = {
    "zhu-hu": LoadShare(Text("Zhu and Hu"), lambda lam, sigma, Ra: solid_rest(f=film_share(lam=lam))),
    "castro-seabra": LoadShare(
        Text("Castro and Seabra"), lambda lam, sigma, Ra: solid_rest(f=film_share_by_power(lam=lam))
    ),
    "olver-spikes": LoadShare(Text("Olver and Spikes"), lambda lam, sigma, Ra: solid_share_by_square(lam=lam)),
    "doleschel": LoadShare(
        Text("Doleschel"), lambda lam, sigma, Ra: solid_share_by_parabola(lam=lam, sigma=sigma, Ra=Ra)
    ),
    "thesis": LoadShare(THESIS, lambda lam, sigma, Ra: solid_share(lam=lam)),
}


# --- what of the flanks rubs, by the model that is judged and by the friction source's

KelvinMetrePerWatt = Annotated[float, "K·m/W"]
MICROMETRE: Metre = 1e-6


@formula("M", "definition: resistance of a wheel's body, per length of contact line")
def body_resistance(R_K: KelvinPerWatt, b: Metre, beta_b: Radian) -> KelvinMetrePerWatt:
    return R_K * b / cos(beta_b)


@record
class Surfaces:
    """How the flanks rub by one model: combined and mean roughness, friction of the solids and their share of the load;
    the viscosity law under pressure, and whether the film has only the pressure that it carries, by which α falls;
    resistance of the bodies."""

    sigma: Metre
    Ra: Metre
    mu_s: Number
    load_share: str
    roelands: bool
    relieved: bool
    M_1: KelvinMetrePerWatt
    M_2: KelvinMetrePerWatt

    @property
    def mixing(self) -> LoadShare:
        return LOAD_SHARES[self.load_share]


def surfaces_of(friction: FrictionInputs, mesh: MeshGeometry) -> tuple[Surfaces, Surfaces]:
    """As judged and as the friction source has them.  What the design says of solid friction and viscosity law counts
    for both."""
    Ra_1, Ra_2 = friction.flank_roughness[0], friction.flank_roughness[-1]
    for Ra in (Ra_1, Ra_2):
        require(Text("flank roughness"), Ra)
    sigma = combined_roughness(Ra_1=Ra_1, Ra_2=Ra_2)
    if np.any(sigma == 0):
        smooth = Text("{ra_1} µm is so small that its square is 0", ra_1=Amount(Ra_1 / MICROMETRE))
        raise NoSolution(
            Text("flank roughness"), smooth, Text("give friction.flank_roughness_um of a real flank: 0.1 to 2 µm")
        )
    mu_s, law = friction.solid_friction, friction.pressure_law
    if mu_s is not None:
        require(Text("friction of the solids"), mu_s, zero=True)
    M_1 = M_2 = 0.0
    if (bodies := friction.body_resistance) is not None:
        M_1, M_2 = (
            body_resistance(R_K=R_K, b=mesh.face_width, beta_b=mesh.base_helix_angle) for R_K in (bodies[0], bodies[-1])
        )
    judged = Surfaces(
        sigma=sigma,
        Ra=mean_roughness(Ra_1=Ra_1, Ra_2=Ra_2),
        mu_s=BOUNDARY if mu_s is None else mu_s,
        load_share=friction.load_share,
        roelands=law != "barus",
        relieved=True,
        M_1=M_1,
        M_2=M_2,
    )
    mu_s = DRY if mu_s is None else mu_s
    return judged, replace(judged, mu_s=mu_s, load_share="thesis", roelands=law == "roelands", relieved=False)
