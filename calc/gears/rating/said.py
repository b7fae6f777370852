# SPDX-License-Identifier: Apache-2.0
"""What is judged and said of the rating of all meshes: checks, curves, notes, and the source's sheet beside."""

import math
from collections.abc import Iterator, Mapping

from ...sheet.check import Check, check
from ...sheet.step import Curve, Erratum
from ...sheet.trace import untraced
from ...sheet.units import UNITS, Metre, Pascal
from ..measures import formulas as m
from ..result import MeshResult, ToothSystem, TrainResult, WheelResult
from .classes import classes_of
from .desk import REFERENCE_NU, Desk
from .influence_checks import influence_checks, influence_notes
from .load import Load, overlooked, rattle
from .result import MeshRating
from .screening.screen import checks as screening_checks
from .screening.screen import curves as screening_curves
from .screening.screen import notes as screening_notes
from .source_sheet import SheetResult
from .strength import strength_notes

SOURCE = "method of Finotti 2013, Tables 4.5 and 4.6"
CONTACT_OF_SHEET = (
    "Its modulus of 210000 daN/mm² is ten times that of steel, so the stress is √10 too high; it also takes β for β_b in the zone factor, "
    "and √cos β of the withdrawn edition. Its root stresses stand in the table of the sheet."
)


def curves(rated: Mapping[str, MeshRating]) -> tuple[Curve, ...]:
    """Film and contact temperature of the mesh whose film is thinnest."""
    films = {key: one.screening.specific_film_min for key, one in rated.items() if one.screening is not None}
    known = {key: film for key, film in films.items() if film is not None}
    key = min(known, key=known.__getitem__) if known else next(iter(films), None)
    screened = rated[key].screening if key is not None else None
    return screening_curves(key, screened) if key is not None and screened is not None else ()


def checks(mesh: MeshResult, key: str, rated: MeshRating, load: Load) -> Iterator[Check]:
    for wheel, form in rated.forms.items():
        yield check(
            f"gears.{key}.notch_{wheel}", f"Notch parameter q_s of {wheel}", form.q_s, "in", (1.0, 8.0), "",
            "ISO 6336-3, as generally published: range of Y_S",
            "The stress correction factor is outside its range: choose a larger tip radius of the tool.", kind="advice",
        )  # fmt: skip
    yield from overlooked(key, f"{mesh.driver}–{mesh.driven}", load)
    if rated.least_torque is not None:
        yield rattle(key, f"{mesh.driver}–{mesh.driven}", rated.least_torque)
    if rated.influence is not None:
        yield from influence_checks(key, mesh, rated.influence)
    if rated.screening is not None:
        yield from screening_checks(key, rated.screening)


def notes(desk: Desk, rated: Mapping[str, MeshRating], load: Mapping[str, Load]) -> tuple[str, ...]:
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
    for w in gears.wheels:
        if w.name not in desk.classes:
            found.append(
                f"Wheel {w.name}: no strength class is given, and that of {w.material} is not plain: its meshes have no load factors and "
                f"no safety. Give gears.wheels.{w.name}.gear_material{_choices(w.material)}."
            )
    for key, one in rated.items():
        if one.influence is not None:
            found += influence_notes(desk.train.meshes[key], one.influence, gears.accuracy_grade)
        elif not one.tangential_force:
            found.append(
                f"Mesh {desk.train.meshes[key].driver}–{desk.train.meshes[key].driven}: no load, so no load factors and no safety."
            )
    found += strength_notes({key: one.strength for key, one in rated.items() if one.strength is not None}, gears.iso_6336_edition)
    screened = [one.screening for one in rated.values() if one.screening is not None]
    if screened and desk.oil is not None:
        found += screening_notes(desk.train.system, screened, desk.oil.lubricant.oil.base)
    return tuple(dict.fromkeys(found))


def _choices(steel: str) -> str:
    usual = classes_of(steel)
    return f" ({' or '.join(usual)})" if usual else ""


# --- the source's sheet ----------------------------------------------------------------------------------------------------
def beside(train: TrainResult, rated: Mapping[str, MeshRating]) -> Iterator[tuple[str, SheetResult, dict[str, float | None]]]:
    """What the sheet gives, and what is right in its place, at the mean torque that the sheet knows."""
    for key, one in rated.items():
        mesh = train.meshes[key]
        share = abs(one.mean_torque / one.torque) if one.torque else 1.0
        right: dict[str, float | None] = {
            "tangential_force": one.tangential_force * share, "contact_stress": one.contact_stress * math.sqrt(share),
        }  # fmt: skip
        for end, name in (("driver", mesh.driver), ("driven", mesh.driven)):
            right[f"form_factor_{end}"] = one.forms[name].Y_F
            right[f"stress_correction_{end}"] = one.forms[name].Y_S
            right[f"root_stress_{end}"] = one.root_stress[f"root_stress_{name}"].number * share
            right[f"ideal_ball_{end}"] = _ball_at_working_circle(train.system, mesh, train.wheels[name])
        assert one.sheet is not None
        yield f"{mesh.driver}–{mesh.driven}", one.sheet, right


def _ball_at_working_circle(system: ToothSystem, mesh: MeshResult, wheel: WheelResult) -> Metre:
    with untraced():
        return m.ball_for_contact(
            wheel.reference_thickness, wheel.pitch_diameter, system.transverse_pressure_angle, wheel.teeth, wheel.base_diameter,
            system.base_helix_angle, mesh.working_pressure_angle,
        )  # fmt: skip


def errata(train: TrainResult, rated: Mapping[str, MeshRating]) -> tuple[Erratum, ...]:
    """What the sheet of the source gives for every pair: the torque of the first wheel at each driver, and its own formulas."""
    found = []
    first = train.wheels[next(iter(train.meshes.values())).driver]
    for key, mesh in train.meshes.items():
        driver, one = train.wheels[mesh.driver], rated[key]
        if one.sheet is None:
            continue
        speed = ""
        if driver.teeth != first.teeth:
            force = one.tangential_force * abs(one.mean_torque / one.torque) if one.torque else 0.0
            speed = (
                f" With the first wheel's speed entered for {driver.name}, its tangential force is {one.sheet.tangential_force:.4g} N "
                f"instead of {force:.4g} N."
            )
        found.append(_erratum(f"gears.{key}.contact_stress", "Contact stress", one.sheet.contact_stress, CONTACT_OF_SHEET + speed))
    return tuple(found)


def _erratum(about: str, label: str, sigma: Pascal, why: str) -> Erratum:
    return Erratum(about, f"{label} by the sheet of Finotti 2013", UNITS["MPa"].shown(sigma), "MPa", SOURCE, why)
