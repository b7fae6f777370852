# SPDX-License-Identifier: Apache-2.0
"""The rating of every mesh of a train, once its torque is known: load, nominal stresses, influence factors, strength, screening."""

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

from ...catalogue import Material
from ...lubricant import Lubricant
from ...sheet.check import Check, check
from ...sheet.formula import formula
from ...sheet.quantity import Described, Stated, group, result
from ...sheet.record import record
from ...sheet.step import Curve, Erratum, Outcome, Table
from ...sheet.trace import about, trace, untraced
from ...sheet.units import UNITS, Celsius, Metre, Newton, NewtonMetre, Number, Pascal, SquareMetrePerSecond
from ..finite import finite
from ..inputs import GearsInputs
from ..measures import formulas as m
from ..result import MeshResult, ToothSystem, TrainResult, WheelResult
from . import stress as s
from .classes import StrengthClass, classes_table, hardness_checks, of_wheel
from .influence import Side as Body
from .influence import influence, inner_diameter
from .influence_checks import influence_checks, influence_notes, influence_table
from .life import contacts_per_turn, load_cycles
from .load import Irregularity, Load, Power, least_torque, loads, mean_torques, rattle
from .result import MeshRating
from .root_strength import loading_of
from .screening.load import OilBath, oil_bath
from .screening.screen import checks as screening_checks
from .screening.screen import curves as screening_curves
from .screening.screen import notes as screening_notes
from .screening.screen import screening
from .source_sheet import SheetResult, comparison, sheet
from .strength import MeshLoad, Side, mesh_strength, roughness_check, strength_checks, strength_notes, strength_tables
from .tooth_form import ToothForm, tooth_form

SOURCE = "method of Finotti 2013, Tables 4.5 and 4.6"
CONTACT_OF_SHEET = (
    "Its modulus of 210000 daN/mm² is ten times that of steel, so the stress is √10 too high; it also takes β for β_b in the zone factor, "
    "and √cos β of the withdrawn edition. Its root stresses stand in the table of the sheet."
)
RZ_PER_RA = 6.0  # ISO 6336-2: Ra = Rz/6
USUAL_RZ: Metre = 4e-6  # of ground flanks, where no roughness is given
REFERENCE_NU: SquareMetrePerSecond = 100e-6  # ISO 6336-2: Z_L is 1 at 100 mm²/s at 40 °C


@formula("Ra", "ISO 6336-2, as generally published: mean relation", unit="µm")
def mean_roughness(Rz: Metre) -> Metre:
    return Rz / RZ_PER_RA


@formula("Rz", "ISO 6336-2, as generally published: mean relation", unit="µm")
def peak_to_valley(Ra: Metre) -> Metre:
    return RZ_PER_RA * Ra


@formula("K_H", "ISO 6336-1: product of the load factors, contact", names={"beta": "K_Hβ", "alpha": "K_Hα"})
def contact_load_factor(K_A: Number, K_V: Number, beta: Number, alpha: Number) -> Number:
    return K_A * K_V * beta * alpha


@formula("K_F", "ISO 6336-1: product of the load factors, root", names={"beta": "K_Fβ", "alpha": "K_Fα"})
def root_load_factor(K_A: Number, K_V: Number, beta: Number, alpha: Number) -> Number:
    return K_A * K_V * beta * alpha


@record
class Around:
    """What the rating takes from outside the gears; what is None is not known."""

    uneven: Irregularity | None = None
    lubricant: Lubricant | None = None
    oil_temperature: Celsius | None = None
    flank_ra: tuple[Metre, Metre] | None = None  # Ra of driver and driven wheel


ALONE = Around()


@result
class RatingResult:
    """The rating of every mesh."""

    meshes: dict[str, MeshRating] = group(spread=True)


def rating(
    gears: GearsInputs, train: TrainResult, torque: Mapping[str, NewtonMetre] | NewtonMetre | Power, materials: Mapping[str, Material],
    around: Around = ALONE,
) -> Outcome:  # fmt: skip
    """Stresses, load factors and safeties of every mesh by the edition of the inputs.

    `torque` is the mean of the first driver, handed on without loss, or that of the driver in every mesh: by the mesh ("a_b"), else by
    the driver's name; or the power of the one or the others.
    """
    with trace() as lines:
        mean = mean_torques(train, torque)
        load = loads(gears, train, mean, around.uneven, materials)
        desk = _desk(gears, train, materials, around)
        rated = {key: _mesh(desk, key, mesh, load[key], mean) for key, mesh in train.meshes.items()}
    found = {key: one for key, one in rated.items() if one.influence is not None}
    checks = [check for key, one in rated.items() for check in _checks(train.meshes[key], key, one)]
    strengths = {key: one.strength for key, one in rated.items() if one.strength is not None}
    checks += [*strength_checks(strengths), roughness_check(gears.root_rz)]
    for name, strength in desk.classes.items():
        checks += hardness_checks(name, strength)
    influences = {key: one.influence for key, one in found.items() if one.influence is not None}
    tables: list[Table] = [*((influence_table(influences), *strength_tables(strengths)) if influences else ()), classes_table(desk.classes)]
    tables.append(comparison(_beside(train, rated)))
    return finite(
        Outcome(
            "gears", result=RatingResult(meshes=rated), checks=tuple(checks), lines=tuple(lines), curves=_curves(rated),
            tables=tuple(tables), errata=_errata(train, rated), notes=_notes(desk, rated, load),
        )
    )  # fmt: skip


@record
class _Desk:
    """What stays the same for all meshes."""

    gears: GearsInputs
    train: TrainResult
    materials: Mapping[str, Material]
    classes: dict[str, StrengthClass]
    bodies: dict[str, Body]
    oil: OilBath | None
    nu_40: SquareMetrePerSecond
    flank_ra: tuple[Metre, Metre]
    flank_rz: Metre
    reverses: bool  # whether the torque changes its sign in every mesh


def _desk(gears: GearsInputs, train: TrainResult, materials: Mapping[str, Material], around: Around) -> _Desk:
    classes = {w.name: of_wheel(w, materials[w.material].proof_stress) for w in gears.wheels}
    bodies = {}
    for w in gears.wheels:
        wheel, solid = train.wheels[w.name], materials[w.material]
        inside = inner_diameter(wheel.root_diameter, w.bore_diameter, w.rim_thickness)
        bodies[w.name] = Body(wheel, solid.E, solid.density, classes[w.name].kind, classes[w.name].sigma_Hlim, inside)
    oil, nu_40 = None, REFERENCE_NU
    if around.lubricant is not None:
        nu_40 = around.lubricant.oil.nu40
        if around.oil_temperature is not None:
            oil = oil_bath(around.lubricant, around.oil_temperature, gears.lubrication)
    with about("roughness of the flanks"):
        if gears.flank_rz is not None or around.flank_ra is None:
            flank_rz = gears.flank_rz if gears.flank_rz is not None else USUAL_RZ
            ra = mean_roughness(Rz=flank_rz)
            flank_ra = (ra, ra)
        else:
            flank_ra = around.flank_ra
            flank_rz = peak_to_valley(Ra=max(flank_ra))
    return _Desk(gears, train, materials, classes, bodies, oil, nu_40, flank_ra, flank_rz, around.uneven is not None)


# --- one mesh --------------------------------------------------------------------------------------------------------------
def _mesh(desk: _Desk, key: str, mesh: MeshResult, load: Load, mean: Mapping[str, NewtonMetre]) -> MeshRating:
    gears, train, system = desk.gears, desk.train, desk.train.system
    driver, driven = wheels = train.wheels[mesh.driver], train.wheels[mesh.driven]
    name, values = f"mesh {mesh.driver}–{mesh.driven}", dict[str, Any]()
    with about(name):
        F_t = s.tangential_force(load.rated, driver.pitch_diameter)
        values |= _contact(system, mesh, driver, driven, F_t, desk.materials)
        if load.dynamic is not None:
            values["least_torque"] = least_torque(T_m=load.mean, T_dyn=load.dynamic)
    forms, roots, factors = dict[str, ToothForm](), dict[str, Stated](), dict[str, Stated]()
    for wheel in wheels:
        with about(f"root of {wheel.name} in {name}"):
            forms[wheel.name], sigma_F, Y_beta = _root(system, mesh, wheel, F_t, gears.iso_6336_edition)
        said, form = _described(wheel.name), forms[wheel.name]
        roots[f"root_stress_{wheel.name}"] = Stated(said[0], sigma_F)
        for stem, about_it, number in zip(FORM, said[1:], (form.Y_F, form.Y_S, form.q_s)):
            factors[f"{stem}_{wheel.name}"] = Stated(about_it, number)
    values["sheet"] = sheet(system, mesh, wheels, mean[next(iter(mean))])
    values |= dict(mean_torque=load.mean, dynamic_torque=load.dynamic, application_factor=load.K_A, tangential_force=F_t, torque=load.rated)
    values |= dict(root_stress=roots, form=factors, root_helix_factor=Y_beta, forms=forms)
    if F_t > 0:
        values |= _loaded(desk, mesh, load, F_t, values)
    return MeshRating(**values)


FORM = ("form_factor", "stress_correction", "notch_parameter")


@cache
def _described(wheel: str) -> tuple[Described, ...]:
    """What is said of a wheel's nominal root stress, and of its FORM."""
    return (
        Described(f"Nominal root stress of {wheel}, K = 1", "MPa", "σ_F0"), Described(f"Form factor of {wheel}", "", "Y_F"),
        Described(f"Stress correction factor of {wheel}", "", "Y_S"), Described(f"Notch parameter of {wheel}", "", "q_s"),
    )  # fmt: skip


def _loaded(desk: _Desk, mesh: MeshResult, load: Load, F_t: Newton, values: dict[str, Any]) -> dict[str, Any]:
    """Load factors, strength and screening of a mesh that carries something."""
    gears, train, system = desk.gears, desk.train, desk.train.system
    given = next(m for m in gears.meshes if (m.driver, m.driven) == (mesh.driver, mesh.driven))
    of = influence(
        system, mesh, desk.bodies[mesh.driver], desk.bodies[mesh.driven], F_t=F_t, K_A=load.K_A, grade=gears.accuracy_grade,
        f_sh=given.shaft_deflection or 0.0, f_ma=given.mesh_misalignment, Z_eps=values["contact_ratio_factor"],
    )  # fmt: skip
    with about(f"mesh {mesh.driver}–{mesh.driven}"):
        K_H = contact_load_factor(
            K_A=load.K_A, K_V=of.dynamic_factor, beta=of.face_load_factor_flank, alpha=of.transverse_load_factor_flank
        )
        K_F = root_load_factor(K_A=load.K_A, K_V=of.dynamic_factor, beta=of.face_load_factor_root, alpha=of.transverse_load_factor_root)
        eps_alphan = s.virtual_contact_ratio(mesh.transverse_contact_ratio, system.base_helix_angle)
    strong = mesh_strength(
        _side(desk, mesh.driver, values), _side(desk, mesh.driven, values),
        MeshLoad(
            values["contact_stress"], K_H, K_F, mesh.working_pressure_angle, mesh.transverse_contact_ratio, eps_alphan, mesh.overlap_ratio,
            system.m_n, of.pitch_line_velocity, desk.nu_40, desk.flank_rz, gears.root_rz, gears.accuracy_grade,
        ),
    )  # fmt: skip
    found = dict(influence=of, strength=strong, contact_load_factor=K_H, root_load_factor=K_F)
    if desk.oil is not None:
        mates = max(_mates(gears, mesh.driver), _mates(gears, mesh.driven))
        found["screening"] = screening(
            system, mesh, train.wheels[mesh.driver], train.wheels[mesh.driven], F_t=F_t, oil=desk.oil, materials=desk.materials,
            roughness=desk.flank_ra, load_factor=K_H, application_factor=load.K_A, accuracy_grade=gears.accuracy_grade, mates=mates,
            load_stage=gears.scuffing_load_stage, permissible_film=gears.permissible_film,
        )  # fmt: skip
    return found


def _mates(gears: GearsInputs, wheel: str) -> int:
    return sum(wheel in (mesh.driver, mesh.driven) for mesh in gears.meshes)


def _side(desk: _Desk, name: str, values: dict[str, Any]) -> Side:
    gears, wheel = desk.gears, desk.train.wheels[name]
    given = next(w for w in gears.wheels if w.name == name)
    driven, drives = (sum(getattr(mesh, end) == name for mesh in gears.meshes) for end in ("driven", "driver"))
    cycles = None
    if gears.life is not None:
        with about(f"wheel {name}"):
            cycles = load_cycles(n=abs(wheel.speed), L_h=gears.life, c=float(contacts_per_turn(driven, drives)))
    return Side(
        name, desk.classes[name], wheel.teeth, wheel.tip_diameter, wheel.base_diameter, wheel.tooth_depth, given.rim_thickness,
        values["forms"][name].q_s, values["root_stress"][f"root_stress_{name}"].number, loading_of(driven, drives, desk.reverses), cycles,
    )  # fmt: skip


def _contact(
    system: ToothSystem, mesh: MeshResult, driver: WheelResult, driven: WheelResult, F_t: Newton, materials: Mapping[str, Material]
) -> dict[str, Number]:
    small, large = (driver, driven) if driver.teeth <= driven.teeth else (driven, driver)
    one, two = materials[small.material], materials[large.material]
    Z_H = s.zone_factor(system.base_helix_angle, mesh.working_pressure_angle, system.transverse_pressure_angle)
    Z_eps = s.contact_ratio_factor(mesh.transverse_contact_ratio, mesh.overlap_ratio)
    Z_beta = s.helix_factor_contact(system.beta)
    sigma_H0 = s.contact_stress(
        Z_H=Z_H, E_c=s.contact_modulus(one.poisson, one.E, two.poisson, two.E), Z_eps=Z_eps, Z_beta=Z_beta, F_t=F_t,
        d_1=small.pitch_diameter, b=mesh.face_width, u=large.teeth / small.teeth,
    )  # fmt: skip
    return {"zone_factor": Z_H, "contact_ratio_factor": Z_eps, "helix_factor": Z_beta, "contact_stress": sigma_H0}


def _root(system: ToothSystem, mesh: MeshResult, wheel: WheelResult, F_t: Newton, edition: int) -> tuple[ToothForm, Pascal, Number]:
    """(its form, σ_F0, Y_β) of one wheel of a mesh."""
    form = tooth_form(system, wheel, mesh.transverse_contact_ratio)
    b, eps_beta = mesh.face_width, mesh.overlap_ratio
    if edition < 2019:
        Y_beta = s.helix_factor_root(eps_beta, system.beta)
        return form, s.root_stress(F_t, b, system.m_n, form.Y_F, form.Y_S, Y_beta), Y_beta
    eps_alphan = s.virtual_contact_ratio(mesh.transverse_contact_ratio, system.base_helix_angle)
    f_eps = s.load_distribution(eps_beta, eps_alphan) if eps_alphan < 2 else s.load_distribution_high(eps_beta, eps_alphan)
    Y_beta = s.helix_factor_root_2019(eps_beta, system.beta)
    return form, s.root_stress_2019(F_t, b, system.m_n, form.Y_F, f_eps, form.Y_S, Y_beta), Y_beta


def _curves(rated: Mapping[str, MeshRating]) -> tuple[Curve, ...]:
    """Film and contact temperature of the mesh whose film is thinnest."""
    films = {key: one.screening.specific_film_min for key, one in rated.items() if one.screening is not None}
    known = {key: film for key, film in films.items() if film is not None}
    key = min(known, key=known.__getitem__) if known else next(iter(films), None)
    screened = rated[key].screening if key is not None else None
    return screening_curves(key, screened) if key is not None and screened is not None else ()


# --- what is judged, and said ----------------------------------------------------------------------------------------------
def _checks(mesh: MeshResult, key: str, rated: MeshRating) -> Iterator[Check]:
    for wheel, form in rated.forms.items():
        yield check(
            f"gears.{key}.notch_{wheel}", f"Notch parameter q_s of {wheel}", form.q_s, "in", (1.0, 8.0), "",
            "ISO 6336-3, as generally published: range of Y_S",
            "The stress correction factor is outside its range: choose a larger tip radius of the tool.", kind="advice",
        )  # fmt: skip
    if rated.least_torque is not None:
        yield rattle(key, f"{mesh.driver}–{mesh.driven}", rated.least_torque)
    if rated.influence is not None:
        yield from influence_checks(key, mesh, rated.influence)
    if rated.screening is not None:
        yield from screening_checks(key, rated.screening)


def _notes(desk: _Desk, rated: Mapping[str, MeshRating], load: Mapping[str, Load]) -> tuple[str, ...]:
    gears = desk.gears
    first = next(iter(load.values()))
    found = [f"Rating by ISO 6336:{gears.iso_6336_edition}, method B; contact_stress and root_stress are nominal, K = 1."]
    if gears.application_factor is not None:
        found.append(f"Load: the mean torque times the given application factor {gears.application_factor:g}.")
    elif first.dynamic is not None:
        found.append("Load: the mean torque plus the dynamic torque of the crank's irregularity, its peak; K_A = 1.")
    else:
        found.append(
            f"Application factor: not given; chosen: {first.K_A:g} on the mean torque. The torque by the crank's irregularity is the "
            "larger load of such a train: give gears.speed_irregularity, or engine.gas and engine.flywheel_inertia_kgm2."
        )
    if gears.flank_rz is None:
        found.append(f"Flank roughness: not given; chosen: Rz {desk.flank_rz * 1e6:g} µm.")
    if desk.nu_40 is REFERENCE_NU:
        found.append("No oil is known: the lubricant factor is that of 100 mm²/s at 40 °C, and film and flash temperature have no value.")
    for key, one in rated.items():
        if one.influence is not None:
            found += influence_notes(desk.train.meshes[key], one.influence, gears.accuracy_grade)
        else:
            found.append(f"Mesh {key.replace('_', '–')}: no load, so no load factors and no safety.")
    found += strength_notes({key: one.strength for key, one in rated.items() if one.strength is not None}, gears.iso_6336_edition)
    screened = [one.screening for one in rated.values() if one.screening is not None]
    if screened and desk.oil is not None:
        found += screening_notes(desk.train.system, screened, desk.oil.lubricant.oil.base)
    return tuple(dict.fromkeys(found))


# --- the source's sheet ----------------------------------------------------------------------------------------------------
def _beside(train: TrainResult, rated: Mapping[str, MeshRating]) -> Iterator[tuple[str, SheetResult, dict[str, float | None]]]:
    """What the sheet gives, and what is right in its place."""
    for key, one in rated.items():
        mesh, right = train.meshes[key], dict[str, float | None](
            tangential_force=one.tangential_force, contact_stress=one.contact_stress
        )  # fmt: skip
        for end, name in (("driver", mesh.driver), ("driven", mesh.driven)):
            right[f"form_factor_{end}"] = one.forms[name].Y_F
            right[f"stress_correction_{end}"] = one.forms[name].Y_S
            right[f"root_stress_{end}"] = one.root_stress[f"root_stress_{name}"].number
            right[f"ideal_ball_{end}"] = _ball_at_working_circle(train.system, mesh, train.wheels[name])
        yield f"{mesh.driver}–{mesh.driven}", one.sheet, right


def _ball_at_working_circle(system: ToothSystem, mesh: MeshResult, wheel: WheelResult) -> Metre:
    with untraced():
        return m.ball_for_contact(
            wheel.reference_thickness, wheel.pitch_diameter, system.transverse_pressure_angle, wheel.teeth, wheel.base_diameter,
            system.base_helix_angle, mesh.working_pressure_angle,
        )  # fmt: skip


def _errata(train: TrainResult, rated: Mapping[str, MeshRating]) -> tuple[Erratum, ...]:
    """What the sheet of the source gives for every pair: the torque of the first wheel at each driver, and its own formulas."""
    found = []
    first = train.wheels[next(iter(train.meshes.values())).driver]
    for key, mesh in train.meshes.items():
        id, driver, one = f"gears.{key}", train.wheels[mesh.driver], rated[key]
        speed = ""
        if driver.teeth != first.teeth:
            speed = (
                f" With the first wheel's speed entered for {driver.name}, its tangential force is {one.sheet.tangential_force:.4g} N "
                f"instead of {one.tangential_force:.4g} N."
            )
        found.append(_erratum(f"{id}.contact_stress", "Contact stress", one.sheet.contact_stress, CONTACT_OF_SHEET + speed))
    return tuple(found)


def _erratum(about: str, label: str, sigma: Pascal, why: str) -> Erratum:
    return Erratum(about, f"{label} by the sheet of Finotti 2013", UNITS["MPa"].shown(sigma), "MPa", SOURCE, why)
