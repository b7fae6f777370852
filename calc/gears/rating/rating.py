# SPDX-License-Identifier: Apache-2.0
"""The rating of every mesh of a train, once its torque is known: load, nominal stresses, influence factors, strength, screening."""

from collections.abc import Mapping
from typing import Any

from ...catalogue import Material
from ...sheet.formula import formula
from ...sheet.quantity import Stated, group, result
from ...sheet.step import Outcome, Table
from ...sheet.trace import about, trace
from ...sheet.units import Newton, NewtonMetre, Number
from ..finite import finite
from ..inputs import GearsInputs
from ..result import MeshResult, TrainResult
from . import nominal, said
from . import stress as s
from .classes import classes_table, hardness_checks
from .desk import Around, Desk, desk
from .influence import influence
from .influence_checks import influence_table
from .life import contacts_per_turn, load_cycles
from .load import Load, Power, loads, mean_torques
from .result import MeshRating
from .root_strength import loading_of, rim_of
from .screening.screen import screening
from .source_sheet import comparison, sheet
from .strength import MeshLoad, Side, mesh_strength, roughness_check, strength_checks, strength_tables
from .tooth_form import ToothForm

ALONE = Around()


@formula("K_H", "ISO 6336-1: product of the load factors, contact", names={"beta": "K_Hβ", "alpha": "K_Hα"})
def contact_load_factor(K_A: Number, K_V: Number, beta: Number, alpha: Number) -> Number:
    return K_A * K_V * beta * alpha


@formula("K_F", "ISO 6336-1: product of the load factors, root", names={"beta": "K_Fβ", "alpha": "K_Fα"})
def root_load_factor(K_A: Number, K_V: Number, beta: Number, alpha: Number) -> Number:
    return K_A * K_V * beta * alpha


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
        laid = desk(gears, train, materials, around)
        rated = {key: _mesh(laid, mesh, load[key], mean) for key, mesh in train.meshes.items()}
    strengths = {key: one.strength for key, one in rated.items() if one.strength is not None}
    influences = {key: one.influence for key, one in rated.items() if one.influence is not None}
    checks = [check for key, one in rated.items() for check in said.checks(train.meshes[key], key, one, load[key])]
    checks += [*strength_checks(strengths), roughness_check(gears.root_rz)]
    for name, strength in laid.classes.items():
        checks += hardness_checks(name, strength)
    tables: list[Table] = [*((influence_table(influences), *strength_tables(strengths)) if influences else ()), classes_table(laid.classes)]
    if gears.source_sheet == "finotti":
        tables.append(comparison(said.beside(train, rated)))
    return finite(
        Outcome(
            "gears", result=RatingResult(meshes=rated), checks=tuple(checks), lines=tuple(lines), curves=said.curves(rated),
            tables=tuple(tables), errata=said.errata(train, rated), notes=said.notes(laid, rated, load),
        )
    )  # fmt: skip


# --- one mesh --------------------------------------------------------------------------------------------------------------
def _mesh(desk: Desk, mesh: MeshResult, load: Load, mean: Mapping[str, NewtonMetre]) -> MeshRating:
    gears, train, system = desk.gears, desk.train, desk.train.system
    driver, driven = wheels = train.wheels[mesh.driver], train.wheels[mesh.driven]
    name, values = f"mesh {mesh.driver}–{mesh.driven}", dict[str, Any]()
    with about(name):
        F_t = s.tangential_force(load.rated, driver.pitch_diameter)
        values |= nominal.contact(system, mesh, driver, driven, F_t, desk.materials)
    forms, roots, factors = dict[str, ToothForm](), dict[str, Stated](), dict[str, Stated]()
    for wheel in wheels:
        with about(f"root of {wheel.name} in {name}"):
            forms[wheel.name], sigma_F, Y_beta = nominal.root(system, mesh, wheel, F_t, gears.iso_6336_edition)
        labels, form = nominal.described(wheel.name), forms[wheel.name]
        roots[f"root_stress_{wheel.name}"] = Stated(labels[0], sigma_F)
        for stem, label, number in zip(nominal.FORM, labels[1:], (form.Y_F, form.Y_S, form.q_s)):
            factors[f"{stem}_{wheel.name}"] = Stated(label, number)
    if gears.source_sheet == "finotti":
        values["sheet"] = sheet(system, mesh, wheels, mean[next(iter(mean))])
    values |= dict(
        mean_torque=load.mean, dynamic_torque=load.dynamic, least_torque=load.least, application_factor=load.K_A, tangential_force=F_t,
        torque=load.rated, root_stress=roots, form=factors, root_helix_factor=Y_beta, forms=forms,
    )  # fmt: skip
    if F_t > 0 and mesh.driver in desk.classes and mesh.driven in desk.classes:
        values |= _loaded(desk, mesh, load, F_t, values)
    return MeshRating(**values)


def _loaded(desk: Desk, mesh: MeshResult, load: Load, F_t: Newton, values: dict[str, Any]) -> dict[str, Any]:
    """Load factors, strength and screening of a mesh that carries something."""
    gears, train, system = desk.gears, desk.train, desk.train.system
    given = next(m for m in gears.meshes if (m.driver, m.driven) == (mesh.driver, mesh.driven))
    of = influence(
        system, mesh, desk.bodies[mesh.driver], desk.bodies[mesh.driven], F_t=F_t, K_A=load.K_A, grade=gears.accuracy_grade,
        f_sh=given.shaft_deflection or 0.0, f_ma=given.mesh_misalignment, C_a=gears.tip_relief, Z_eps=values["contact_ratio_factor"],
    )  # fmt: skip
    with about(f"mesh {mesh.driver}–{mesh.driven}"):
        K_H = contact_load_factor(
            K_A=load.K_A, K_V=of.dynamic_factor, beta=of.face_load_factor_flank, alpha=of.transverse_load_factor_flank
        )
        K_F = root_load_factor(K_A=load.K_A, K_V=of.dynamic_factor, beta=of.face_load_factor_root, alpha=of.transverse_load_factor_root)
        eps_alphan = s.virtual_contact_ratio(mesh.transverse_contact_ratio, system.base_helix_angle)
    strong = mesh_strength(
        _side(desk, mesh.driver, values, load), _side(desk, mesh.driven, values, load),
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
            load_stage=gears.scuffing_load_stage, permissible_film=gears.permissible_film, mesh_stiffness=of.mesh_stiffness,
            structural_factor=min(desk.structural[name] for name in (mesh.driver, mesh.driven)),
        )  # fmt: skip
    return found


def _mates(gears: GearsInputs, wheel: str) -> int:
    return sum(wheel in (mesh.driver, mesh.driven) for mesh in gears.meshes)


def _side(desk: Desk, name: str, values: dict[str, Any], load: Load) -> Side:
    gears, wheel = desk.gears, desk.train.wheels[name]
    given = next(w for w in gears.wheels if w.name == name)
    driven, drives = (sum(getattr(mesh, end) == name for mesh in gears.meshes) for end in ("driven", "driver"))
    cycles, reverses = None, load.least is not None and load.least < 0
    if gears.life is not None:
        with about(f"wheel {name}"):
            cycles = load_cycles(n=abs(wheel.speed), L_h=gears.life, c=float(contacts_per_turn(driven, drives)))
    return Side(
        name, desk.classes[name], wheel.teeth, wheel.tip_diameter, wheel.base_diameter, wheel.tooth_depth,
        rim_of(wheel.root_diameter, given.bore_diameter, given.rim_thickness),
        values["forms"][name].q_s, values["root_stress"][f"root_stress_{name}"].number, loading_of(driven, drives, reverses), cycles,
    )  # fmt: skip
