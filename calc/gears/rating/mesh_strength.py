# SPDX-License-Identifier: Apache-2.0
"""Strength against pitting and tooth breakage of one mesh, ISO 6336-2, -3 and -5.

The stresses come in as nominal ones (K = 1) with the product of their load factors; the strength of every wheel follows from its class,
its life and its surface.  S_H and S_F are on stress; on load, S_H counts squared and S_F as it is.
"""

from collections.abc import Mapping
from functools import cache

from ...sheet.quantity import Described, Stated
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.trace import about
from ...sheet.units import Metre, MetrePerSecond, Number, Pascal, Radian, SquareMetrePerSecond
from . import strength as flank
from . import root_strength as root
from .strength import ContactStrength
from .result import MeshStrength, Side
from .root_strength import RootStrength

S_H_LEAST, S_F_LEAST = 1.0, 1.4  # limits: the lower end of the usual range


@record
class MeshLoad:
    """What both wheels of a mesh share.

    `v`: at the pitch circle; `K_H`, `K_F`: products of the load factors; `nu_40`: the oil at 40 °C.
    """

    sigma_H0: Pascal
    K_H: Number
    K_F: Number
    alpha_wt: Radian
    eps_alpha: Number
    eps_alphan: Number
    eps_beta: Number
    m_n: Metre
    v: MetrePerSecond
    nu_40: SquareMetrePerSecond
    flank_rz: Metre
    root_rz: Metre
    grade: int


Row = tuple[str, Text, str, str, str]  # id, label, unit, symbol and attribute of what is shown of each wheel
CONTACT: tuple[Row, ...] = (
    ("safety_contact", Text("Safety against pitting of {wheel}, on stress"), "", "S_H", "S_H"),
    ("rated_contact_stress", Text("Contact stress of {wheel}"), "MPa", "σ_H", "sigma_H"),
    ("pitting_limit", Text("Pitting stress limit of {wheel}"), "MPa", "σ_HG", "sigma_HG"),
    ("permissible_contact_stress", Text("Permissible contact stress of {wheel}"), "MPa", "σ_HP", "sigma_HP"),
    ("single_pair_factor", Text("Single pair factor of {wheel}"), "", "Z_BD", "Z_BD"),
    ("flank_life_factor", Text("Life factor of {wheel}, flank"), "", "Z_NT", "Z_NT"),
    ("work_hardening_factor", Text("Work hardening factor of {wheel}"), "", "Z_W", "Z_W"),
)
BENDING: tuple[Row, ...] = (
    ("safety_bending", Text("Safety against tooth breakage of {wheel}"), "", "S_F", "S_F"),
    ("rated_root_stress", Text("Tooth root stress of {wheel}"), "MPa", "σ_F", "sigma_F"),
    ("root_limit", Text("Tooth root stress limit of {wheel}"), "MPa", "σ_FG", "sigma_FG"),
    ("permissible_root_stress", Text("Permissible root stress of {wheel}"), "MPa", "σ_FP", "sigma_FP"),
    ("rim_factor", Text("Rim thickness factor of {wheel}"), "", "Y_B", "Y_B"),
    ("deep_tooth_factor", Text("Deep tooth factor of {wheel}"), "", "Y_DT", "Y_DT"),
    ("root_life_factor", Text("Life factor of {wheel}, root"), "", "Y_NT", "Y_NT"),
    ("notch_sensitivity", Text("Relative notch sensitivity of {wheel}"), "", "Y_δrelT", "Y_drelT"),
    ("surface_factor", Text("Relative surface factor of {wheel}"), "", "Y_RrelT", "Y_RrelT"),
    ("size_factor", Text("Size factor of {wheel}, root"), "", "Y_X", "Y_X"),
    ("mean_stress_factor", Text("Factor of reversed load of {wheel}"), "", "Y_M", "Y_M"),
)


def mesh_strength(driver: Side, driven: Side, load: MeshLoad) -> MeshStrength:
    """The strength of both wheels of a mesh, each line under the wheel's name."""
    sides, pair = (driver, driven), Text("mesh {name}–{name2}", name=driver.name, name2=driven.name)
    softer = min(driver.strength.sigma_Hlim, driven.strength.sigma_Hlim)
    with about(Text("{pair}, film", pair=pair)):
        film = flank.film_factors(
            softer, load.nu_40, load.v, load.flank_rz, load.flank_rz, driver.base_diameter, driven.base_diameter, load.alpha_wt
        )
    contact, bending = {}, {}
    for own, mate in (sides, sides[::-1]):
        with about(Text("flank of {name} in {pair}", name=own.name, pair=pair)):
            contact[own.name] = _contact(own, mate, load, film)
        with about(Text("root of {name} in {pair}, strength", name=own.name, pair=pair)):
            bending[own.name] = _bending(own, load)
    with about(pair):
        S_H = min((c.S_H for c in contact.values() if c.S_H is not None), default=None)
        on_load = None if S_H is None else flank.contact_safety_on_load(S_H=S_H)
    return MeshStrength(
        safety_contact=S_H, safety_contact_load=on_load, lubricant_factor=film.Z_L, velocity_factor=film.Z_v, roughness_factor=film.Z_R,
        wheels=_stated(contact, bending), sides=sides, contact=contact, bending=bending,
    )  # fmt: skip


def _contact(own: Side, mate: Side, load: MeshLoad, film: flank.Film) -> ContactStrength:
    Z_BD = flank.single_pair(
        load.alpha_wt, own.tip_diameter, own.base_diameter, own.teeth, mate.tip_diameter, mate.base_diameter, mate.teeth,
        load.eps_alpha, load.eps_beta,
    )  # fmt: skip
    Z_W = flank.work_hardening(
        own.strength, mate.strength, load.flank_rz, load.flank_rz, film.rho_red, load.v, load.nu_40, own.teeth / mate.teeth
    )
    return flank.contact_strength(
        own.strength, sigma_H0=load.sigma_H0, K_H=load.K_H, Z_BD=Z_BD, film=film, Z_W=Z_W, cycles=own.cycles, S_Hmin=S_H_LEAST
    )


def _bending(own: Side, load: MeshLoad) -> RootStrength:
    return root.root_strength(
        own.strength, sigma_F0=own.sigma_F0, K_F=load.K_F, Y_B=root.rim_factor(own.name, own.tooth_depth, own.rim),
        Y_DT=root.deep_tooth_factor(load.grade, load.eps_alphan), q_s=own.q_s, Rz_F=load.root_rz, m_n=load.m_n, loading=own.loading,
        cycles=own.cycles, S_Fmin=S_F_LEAST,
    )  # fmt: skip


def _stated(contact: Mapping[str, ContactStrength], bending: Mapping[str, RootStrength]) -> dict[str, Stated]:
    """Every number of each wheel under its name; a safety without load is left out."""
    stated = {}
    for wheel in contact:
        for strength, rows in ((contact[wheel], CONTACT), (bending[wheel], BENDING)):
            for id, described, attribute in _described(wheel, rows):
                if (number := getattr(strength, attribute)) is not None:
                    stated[id] = Stated(described, number)
    return stated


@cache
def _described(wheel: str, rows: tuple[Row, ...]) -> tuple[tuple[str, Described, str], ...]:
    return tuple(
        (f"{id}_{wheel}", Described(Text(label.template, wheel=wheel), unit, symbol), attribute)
        for id, label, unit, symbol, attribute in rows
    )
