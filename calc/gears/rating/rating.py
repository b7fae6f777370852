# SPDX-License-Identifier: Apache-2.0
"""Nominal stresses of every mesh of a train, once its torque is known."""

from collections.abc import Mapping

from ...catalogue import Material
from ...sheet.check import Check, check
from ...sheet.errors import NoSolution
from ...sheet.quantity import Described, Stated, group, result
from ...sheet.step import Erratum, Outcome
from ...sheet.trace import about, trace
from ...sheet.units import UNITS, Newton, NewtonMetre, Number, Pascal
from ..finite import finite
from ..inputs import GearsInputs
from ..result import MeshRating, MeshResult, ToothSystem, TrainResult, WheelResult
from . import stress as s
from .source_sheet import sheet_contact, sheet_root
from .tooth_form import tooth_form

CONTACT_OF_SHEET = (
    "Its modulus of 210000 daN/mm² is ten times that of steel, so the stress is √10 too high; it also takes β for β_b in the zone factor, "
    "and √cos β of the withdrawn edition."
)
ROOT_OF_SHEET = (
    "It carries the outer single contact from the transverse to the virtual wheel without 1/cos² β_b and has cos α_t for cos α_n: "
    "its form factor is too high."
)

ALIKE = 0.01  # a value of the sheet that comes this near is not called wrong


@result
class RatingResult:
    """The nominal stresses of every mesh."""

    meshes: dict[str, MeshRating] = group(spread=True)


def rating(
    gears: GearsInputs, train: TrainResult, torque: Mapping[str, NewtonMetre] | NewtonMetre, materials: Mapping[str, Material]
) -> Outcome:
    """Nominal contact and root stresses, K = 1, by the edition of the inputs.

    `torque` is that of the first driver, handed on without loss, or that of the driver in every mesh: by the mesh ("a_b"), else by
    the driver's name.
    """
    rated: dict[str, MeshRating] = {}
    found: list[Check] = []
    with trace() as lines:
        torques = _torques(train, torque)
        for key, mesh in train.meshes.items():
            driver, driven = train.wheels[mesh.driver], train.wheels[mesh.driven]
            with about(f"mesh {mesh.driver}–{mesh.driven}"):
                F_t = s.tangential_force(torques[key], driver.pitch_diameter)
                sigma_H = _contact(train.system, mesh, driver, driven, F_t, materials)
            roots: dict[str, Stated] = {}
            for wheel in (driver, driven):
                with about(f"root of {wheel.name} in mesh {mesh.driver}–{mesh.driven}"):
                    sigma_F, q_s = _root(train.system, mesh, wheel, F_t, gears.iso_6336_edition)
                roots[f"root_stress_{wheel.name}"] = Stated(
                    Described(f"Nominal root stress of {wheel.name}, K = 1", "MPa", "σ_F0"), sigma_F
                )
                found.append(_range_check(f"gears.{key}.notch_{wheel.name}", wheel, q_s))
            rated[key] = MeshRating(tangential_force=F_t, contact_stress=sigma_H, root_stress=roots, torque=torques[key])
    edition = gears.iso_6336_edition
    note = f"Stresses by ISO 6336:{edition}, method B, nominal: every influence factor K is 1, nothing is said yet about safety."
    errata = _errata(train, torques[next(iter(train.meshes))], rated)
    return finite(
        Outcome("gears", result=RatingResult(meshes=rated), checks=tuple(found), lines=tuple(lines), errata=errata, notes=(note,))
    )


def _torques(train: TrainResult, torque: Mapping[str, NewtonMetre] | NewtonMetre) -> dict[str, NewtonMetre]:
    """Torque at the driver of every mesh; one number is handed on from the first driver, whole into each branch."""
    if isinstance(torque, Mapping):
        return {key: torque[key] if key in torque else torque[mesh.driver] for key, mesh in train.meshes.items()}
    on = {next(iter(train.meshes.values())).driver: torque}
    found = {}
    for key, mesh in train.meshes.items():
        found[key] = on[mesh.driver]
        with about(f"wheel {mesh.driven}"):
            on[mesh.driven] = s.torque_of_driven(on[mesh.driver], train.wheels[mesh.driven].teeth, train.wheels[mesh.driver].teeth)
    return found


def _contact(
    system: ToothSystem, mesh: MeshResult, driver: WheelResult, driven: WheelResult, F_t: Newton, materials: Mapping[str, Material]
) -> Pascal:
    small, large = (driver, driven) if driver.teeth <= driven.teeth else (driven, driver)
    one, two = materials[small.material], materials[large.material]
    return s.contact_stress(
        Z_H=s.zone_factor(system.base_helix_angle, mesh.working_pressure_angle, system.transverse_pressure_angle),
        E_c=s.contact_modulus(one.poisson, one.E, two.poisson, two.E),
        Z_eps=s.contact_ratio_factor(mesh.transverse_contact_ratio, mesh.overlap_ratio),
        Z_beta=s.helix_factor_contact(system.beta), F_t=F_t, d_1=small.pitch_diameter, b=mesh.face_width, u=large.teeth / small.teeth,
    )  # fmt: skip


def _root(system: ToothSystem, mesh: MeshResult, wheel: WheelResult, F_t: Newton, edition: int) -> tuple[Pascal, Number]:
    """(σ_F0, q_s) of one wheel of a mesh."""
    form = tooth_form(system, wheel, mesh.transverse_contact_ratio)
    b, eps_beta = mesh.face_width, mesh.overlap_ratio
    if edition < 2019:
        Y_beta = s.helix_factor_root(eps_beta, system.beta)
        return s.root_stress(F_t, b, system.m_n, form.Y_F, form.Y_S, Y_beta), form.q_s
    eps_alphan = s.virtual_contact_ratio(mesh.transverse_contact_ratio, system.base_helix_angle)
    f_eps = s.load_distribution(eps_beta, eps_alphan) if eps_alphan < 2 else s.load_distribution_high(eps_beta, eps_alphan)
    Y_beta = s.helix_factor_root_2019(eps_beta, system.beta)
    return s.root_stress_2019(F_t, b, system.m_n, form.Y_F, f_eps, form.Y_S, Y_beta), form.q_s


def _range_check(id: str, wheel: WheelResult, q_s: Number) -> Check:
    return check(
        id, f"Notch parameter q_s of {wheel.name}", q_s, "in", (1.0, 8.0), "", "ISO 6336-3, as generally published: range of Y_S",
        "The stress correction factor is outside its range: choose a larger tip radius of the tool.", kind="advice",
    )  # fmt: skip


def _errata(train: TrainResult, T: NewtonMetre, rated: Mapping[str, MeshRating]) -> tuple[Erratum, ...]:
    """What the sheet of the source gives for every pair: the torque T of the first wheel at each driver, and its own formulas."""
    found = []
    first = train.wheels[next(iter(train.meshes.values())).driver]
    for key, mesh in train.meshes.items():
        id, driver, driven = f"gears.{key}", train.wheels[mesh.driver], train.wheels[mesh.driven]
        F_t = s.tangential_force(T, driver.pitch_diameter)
        speed = ""
        if driver.teeth != first.teeth:
            true = rated[key].tangential_force
            speed = f" With the first wheel's speed entered for {driver.name}, its tangential force is {F_t:.4g} N instead of {true:.4g} N."
        sigma_H = sheet_contact(train.system, mesh, driver, driven, F_t)
        found.append(_erratum(f"{id}.contact_stress", "Contact stress", sigma_H, CONTACT_OF_SHEET + speed))
        for wheel, rho in ((driver, mesh.sap_curvature_driver), (driven, mesh.sap_curvature_driven)):
            try:
                sigma_F = sheet_root(train.system, mesh, wheel, rho, F_t)
            except NoSolution:  # the sheet's load circle can miss the tooth where the right one does not: then it has no value
                continue
            if abs(sigma_F / rated[key].root_stress[f"root_stress_{wheel.name}"].number - 1) < ALIKE:
                continue
            found.append(_erratum(f"{id}.root_stress_{wheel.name}", f"Root stress of {wheel.name}", sigma_F, ROOT_OF_SHEET + speed))
    return tuple(found)


def _erratum(about: str, label: str, sigma: Pascal, why: str) -> Erratum:
    source = "method of Finotti 2013, Tables 4.5 and 4.6"
    return Erratum(about, f"{label} by the sheet of Finotti 2013", UNITS["MPa"].shown(sigma), "MPa", source, why)
