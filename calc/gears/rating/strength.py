# SPDX-License-Identifier: Apache-2.0
"""Safety against pitting and tooth breakage of one mesh, ISO 6336-2, -3 and -5: its values, checks, tables and notes.

The stresses come in as nominal ones (K = 1) with the product of their load factors; the strength of every wheel follows from its class,
its life and its surface.  S_H and S_F are on stress; on load, S_H counts squared and S_F as it is.
"""

from collections.abc import Mapping
from functools import cache

from ...sheet.check import Check, check
from ...sheet.number import short
from ...sheet.quantity import Described, Stated, group, result, value
from ...sheet.record import record
from ...sheet.step import Table
from ...sheet.trace import about
from ...sheet.units import UNITS, Metre, MetrePerSecond, Number, Pascal, Radian, SquareMetrePerSecond
from . import flank_strength as flank
from . import root_strength as root
from .classes import StrengthClass
from .flank_strength import ContactStrength
from .life import LONGEST, endurance, flank_knees, root_knees
from .root_strength import RootStrength

S_H_LEAST, S_H_USUAL = 1.0, 1.2
S_F_LEAST, S_F_USUAL = 1.4, 1.6
MINIMUM = (
    "ISO 6336-1 leaves the minimum to agreement; rule of this program: limit at the lower, advice at the upper end of the usual {} to {} "
    "(IACS UR M56 for auxiliary gears: {})"
)
MINIMUM_H = MINIMUM.format(S_H_LEAST, S_H_USUAL, "1.15 to 1.2")
MINIMUM_F = MINIMUM.format(S_F_LEAST, S_F_USUAL, "1.4 to 1.45")


@record
class Side:
    """One wheel as its strength in one mesh needs it.

    `sigma_F0`: nominal root stress, K = 1.  `cycles` None: no life is given.  `loading`: pulsating or reversed.
    `tooth_depth` and `rim` (None: solid body) give the rim factor.
    """

    name: str
    strength: StrengthClass
    teeth: int
    tip_diameter: Metre
    base_diameter: Metre
    tooth_depth: Metre
    rim: Metre | None
    q_s: Number
    sigma_F0: Pascal
    loading: str
    cycles: Number | None


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


@result
class MeshStrength:
    """The strength of one mesh; a safety of None: no load."""

    safety_contact: Number | None = value("Safety against pitting, on stress", "", "S_H", default=None)
    safety_contact_load: Number | None = value("Safety against pitting, on load", "", "S_H²", default=None)
    lubricant_factor: Number = value("Lubricant factor", "", "Z_L")
    velocity_factor: Number = value("Velocity factor", "", "Z_v")
    roughness_factor: Number = value("Roughness factor", "", "Z_R")
    wheels: dict[str, Stated] = group(spread=True)  # NAME_WHEEL
    sides: tuple[Side, Side]
    contact: dict[str, ContactStrength]
    bending: dict[str, RootStrength]


# (name, label, unit, symbol, attribute) of what is shown of each wheel
CONTACT = (
    ("safety_contact", "Safety against pitting of {}, on stress", "", "S_H", "S_H"),
    ("rated_contact_stress", "Contact stress of {}", "MPa", "σ_H", "sigma_H"),
    ("pitting_limit", "Pitting stress limit of {}", "MPa", "σ_HG", "sigma_HG"),
    ("permissible_contact_stress", "Permissible contact stress of {}", "MPa", "σ_HP", "sigma_HP"),
    ("single_pair_factor", "Single pair factor of {}", "", "Z_BD", "Z_BD"),
    ("flank_life_factor", "Life factor of {}, flank", "", "Z_NT", "Z_NT"),
    ("work_hardening_factor", "Work hardening factor of {}", "", "Z_W", "Z_W"),
)
BENDING = (
    ("safety_bending", "Safety against tooth breakage of {}", "", "S_F", "S_F"),
    ("rated_root_stress", "Tooth root stress of {}", "MPa", "σ_F", "sigma_F"),
    ("root_limit", "Tooth root stress limit of {}", "MPa", "σ_FG", "sigma_FG"),
    ("permissible_root_stress", "Permissible root stress of {}", "MPa", "σ_FP", "sigma_FP"),
    ("rim_factor", "Rim thickness factor of {}", "", "Y_B", "Y_B"),
    ("deep_tooth_factor", "Deep tooth factor of {}", "", "Y_DT", "Y_DT"),
    ("root_life_factor", "Life factor of {}, root", "", "Y_NT", "Y_NT"),
    ("notch_sensitivity", "Relative notch sensitivity of {}", "", "Y_δrelT", "Y_drelT"),
    ("surface_factor", "Relative surface factor of {}", "", "Y_RrelT", "Y_RrelT"),
    ("size_factor", "Size factor of {}, root", "", "Y_X", "Y_X"),
    ("mean_stress_factor", "Factor of reversed load of {}", "", "Y_M", "Y_M"),
)


def mesh_strength(driver: Side, driven: Side, load: MeshLoad) -> MeshStrength:
    """The strength of both wheels of a mesh, each line under the wheel's name."""
    sides, pair = (driver, driven), f"mesh {driver.name}–{driven.name}"
    softer = min(driver.strength.sigma_Hlim, driven.strength.sigma_Hlim)
    with about(f"{pair}, film"):
        film = flank.film_factors(
            softer, load.nu_40, load.v, load.flank_rz, load.flank_rz, driver.base_diameter, driven.base_diameter, load.alpha_wt
        )
    contact, bending = {}, {}
    for own, mate in (sides, sides[::-1]):
        with about(f"flank of {own.name} in {pair}"):
            contact[own.name] = _contact(own, mate, load, film)
        with about(f"root of {own.name} in {pair}, strength"):
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
    found = {}
    for wheel in contact:
        parts = vars(contact[wheel]), vars(bending[wheel])
        for name, attribute, part, said in _described(wheel):
            if (number := parts[part][attribute]) is not None:
                found[name] = Stated(said, number)
    return found


@cache
def _described(wheel: str) -> tuple[tuple[str, str, int, Described], ...]:
    return tuple(
        (f"{name}_{wheel}", attribute, part, Described(label.format(wheel), unit, symbol))
        for part, rows in enumerate((CONTACT, BENDING))
        for name, label, unit, symbol, attribute in rows
    )


# --- checks ----------------------------------------------------------------------------------------------------------------
def strength_checks(meshes: Mapping[str, MeshStrength]) -> tuple[Check, ...]:
    """Of every mesh its flanks, of every wheel the weakest of its roots; none where there is no load."""
    found: list[Check] = []
    roots: dict[str, tuple[Number, str]] = {}
    for key, mesh in meshes.items():
        found += _contact_checks(key, mesh)
        for wheel, strength in mesh.bending.items():
            if strength.S_F is not None and (wheel not in roots or strength.S_F < roots[wheel][0]):
                roots[wheel] = (strength.S_F, key)
    for wheel, (S_F, key) in roots.items():
        name, advice = f"Safety of {wheel} against tooth breakage", _advice(wheel, S_F_USUAL / S_F)
        found.append(
            check(
                f"gears.{wheel}.safety_bending",
                f"{name}, in {_pair(meshes[key])}",
                S_F,
                ">=",
                S_F_LEAST,
                "",
                MINIMUM_F,
                _advice(wheel, S_F_LEAST / S_F),
            )
        )
        found.append(
            check(f"gears.{wheel}.safety_bending_usual", f"{name}, usual", S_F, ">=", S_F_USUAL, "", MINIMUM_F, advice, kind="advice")
        )
    return tuple(found)


def _contact_checks(key: str, mesh: MeshStrength) -> list[Check]:
    if (S_H := mesh.safety_contact) is None:
        return []
    weak = next(wheel for wheel, c in mesh.contact.items() if c.S_H is S_H)
    name = f"Safety against pitting {mesh.sides[0].name}–{mesh.sides[1].name}, on stress (on load {S_H**2:.3g}), weaker: {weak}"
    id = f"gears.{key}.safety_contact"
    return [
        check(id, name, S_H, ">=", S_H_LEAST, "", MINIMUM_H, _advice(weak, (S_H_LEAST / S_H) ** 2)),
        check(
            f"{id}_usual", f"{name}, usual", S_H, ">=", S_H_USUAL, "", MINIMUM_H, _advice(weak, (S_H_USUAL / S_H) ** 2), kind="advice"
        ),
    ]  # fmt: skip


def _advice(wheel: str, width: Number) -> str:
    """`width`: by how much the face width, or the load, would have to change."""
    better = f"a stronger class (gears.wheels.{wheel}.gear_material) or quality"
    if width <= 1:
        return "It holds."
    return (
        f"Give more than {width:.3g} times the face width, or bring the load to less than {1 / width:.3g} of it (the load factors rise as "
        f"the load per width falls), {better}, or finer teeth (gears.accuracy_grade)."
    )


def roughness_check(root_rz: Metre) -> Check:
    """Whether the surface factor of the root holds."""
    return check(
        "gears.train.root_roughness", "Roughness Rz of the roots", root_rz, "<=", root.ROUGHEST, "µm",
        "ISO 6336-3, as generally published: Y_RrelT was found up to 40 µm", "Give a finer gears.root_rz_um.", kind="advice",
    )  # fmt: skip


# --- what is shown ---------------------------------------------------------------------------------------------------------
def strength_tables(meshes: Mapping[str, MeshStrength]) -> tuple[Table, Table]:
    """Flanks and roots of all meshes, every factor in its column."""
    return _table("gear_flank_strength", "Flanks: stress and strength", CONTACT, "contact", meshes, _film_note(meshes)), _table(
        "gear_root_strength", "Tooth roots: stress and strength", BENDING, "bending", meshes,
        "σ_FG = σ_Flim·Y_ST·Y_NT·Y_δrelT·Y_RrelT·Y_X·Y_M, Y_ST = 2; Y_M 0.7 where a wheel is driven by one and drives "
        "another, or the torque changes its sign.",
    )  # fmt: skip


def _table(
    id: str, title: str, columns: tuple[tuple[str, str, str, str, str], ...], part: str, meshes: Mapping[str, MeshStrength], note: str
) -> Table:
    rows: list[tuple[str | float | None, ...]] = []
    for mesh in meshes.values():
        for wheel, strength in getattr(mesh, part).items():
            numbers = ((getattr(strength, attribute), UNITS[unit].factor) for _, _, unit, _, attribute in columns)
            rows.append((_pair(mesh), wheel, *(None if n is None else n / factor for n, factor in numbers)))
    hidden = tuple(f"gears.{key}.{name}_{wheel}" for key, mesh in meshes.items() for wheel in mesh.contact for name, *_ in columns[1:])
    return Table(
        id, title, (("mesh", ""), ("wheel", ""), *((symbol, unit) for _, _, unit, symbol, _ in columns)), tuple(rows), note, hidden
    )


def _pair(mesh: MeshStrength) -> str:
    return f"{mesh.sides[0].name}–{mesh.sides[1].name}"


def _film_note(meshes: Mapping[str, MeshStrength]) -> str:
    film = "; ".join(
        f"{_pair(m)}: Z_L {m.lubricant_factor:.4g}, Z_v {m.velocity_factor:.4g}, Z_R {m.roughness_factor:.4g}" for m in meshes.values()
    )
    return f"σ_HG = σ_Hlim·Z_NT·Z_L·Z_v·Z_R·Z_W, Z_X = 1. {film}. S_H is on stress; on load it counts squared."


def strength_notes(meshes: Mapping[str, MeshStrength], edition: int) -> tuple[str, ...]:
    """What was assumed: classes, life, and what an edition or a range leaves open."""
    sides = [side for mesh in meshes.values() for side in mesh.sides]
    notes = list(dict.fromkeys(f"Wheel {side.name}: {note}." for side in sides for note in side.strength.notes))
    if any(side.cycles is None for side in sides):
        knees = sorted({endurance(flank_knees(side.strength.kind)) for side in sides})
        notes.append(
            f"No life is given: flanks by their strength at {' or '.join(map(short, knees))} cycles (Z_NT = 1), roots at 3·10⁶ "
            "(Y_NT = 1). A given life past these takes up to 15 % off, down to 0.85 at 10¹⁰ cycles."
        )
    brief = dict.fromkeys(s.name for s in sides if s.cycles is not None and s.cycles < endurance(root_knees(s.strength.kind)))
    if brief:
        notes.append(
            f"Short life of {', '.join(brief)}: film, notch and surface factors are kept as for long life, "
            "which the standard lets fade towards static strength."
        )
    if beyond := dict.fromkeys(s.name for s in sides if s.cycles is not None and s.cycles > LONGEST):
        notes.append(
            f"More than 10¹⁰ cycles of {', '.join(beyond)}: the life curves of ISO 6336 end there; their last lines are continued."
        )
    notes.append(
        "Safety: S_H ≥ 1.0 and S_F ≥ 1.4 are limits, 1.2 and 1.6 advice: a rule of this program from the usual values; "
        "ISO 6336 leaves them to agreement."
    )
    if edition >= 2019:
        notes.append(
            "ISO 6336-2:2019 adds f_ZCa to the flanks of helical wheels without tip relief (from memory up to 1.2 on the square of the "
            "contact stress): not applied."
        )
    return tuple(notes)
