# SPDX-License-Identifier: Apache-2.0
"""What is to be said about solved friction: checks, where the source is wrong, notes and curves."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from .. import oils
from ..sheet.check import Check, check
from ..sheet.errors import NoSolution
from ..sheet.step import Erratum
from . import pictures, remarks
from .balance.closure import Drive
from .inputs import FrictionInputs
from .mesh.film import ELLIPTICAL, LEAST_FACTOR, Oil
from .mesh.loss import loss_factor, solve_mesh
from .mesh.path import array, line_load
from .mesh.traction import THESIS
from .models.compared import MODELS
from .result import FrictionResult, MeshResult, by_regime

OWN = "rule of this program"
BALANCE_LIMIT = 1e-6  # W
BULK_LIMIT = 10.0  # K
HOT_TEETH = 150.0  # °C


def said(d: Drive, result: FrictionResult) -> dict[str, Any]:
    """Checks, curves, errata and notes of a closed balance."""
    friction = d.friction
    return {
        "checks": checks(friction, result), "curves": pictures.curves(result), "errata": errata(friction, result, d.oil),
        "notes": remarks.notes(friction, result, d.oil), "tables": pictures.tables(result, d),
    }  # fmt: skip


# --- checks ----------------------------------------------------------------------------------------------------------------
def checks(friction: FrictionInputs, result: FrictionResult) -> tuple[Check, ...]:
    balance = check(
        "friction.train.balance",
        "Power balance of the train: what is left over",
        abs(result.residual),
        "<=",
        BALANCE_LIMIT,
        "W",
        "conservation of energy",
        "A fault of the program, not of the design: please report it.",
    )
    delivered = () if result.delivered_power is None else (_delivers(result.delivered_power),)
    return (
        balance,
        *delivered,
        _models(result),
        *(c for name, mesh in result.meshes.items() for c in _of_mesh(f"friction.{name}", friction, mesh)),
    )


def _models(result: FrictionResult) -> Check:
    """How many of the published regressions hold for every mesh."""
    meshes = result.meshes.values()
    outside = [name for name in MODELS if any(one is None or one.outside for one in (m.published_models[name] for m in meshes))]
    return check(
        "friction.train.models",
        "Published regressions inside their range at every mesh",
        float(len(MODELS) - len(outside)),
        ">=",
        float(len(MODELS)),
        "",
        "ranges of Schlenk, Niemann and Winter, Xu and Kahraman, Benedict and Kelley",
        f"Outside: {'; '.join(MODELS[name].authors for name in outside) or 'none'}. The tables of the models say by what. Their losses are "
        "extrapolations; nothing is judged by them.",
        kind="advice",
    )


def _delivers(power: float) -> Check:
    return check(
        "friction.train.delivered",
        "Power that the last wheel delivers: more than nothing",
        power,
        ">",
        0.0,
        "W",
        "conservation of energy",
        "Windage, other losses and the meshes eat all of the power: give more gears.power_kW, or less speed, mist or face width.",
    )


def _of_mesh(id: str, friction: FrictionInputs, mesh: MeshResult) -> Iterator[Check]:
    """One limit, that power comes out at all; else advice: where the model leaves its range, and what the flanks would like."""
    yield check(
        f"{id}.power_out",
        f"Mesh {mesh.case.mesh.title} passes on more than nothing",
        mesh.power_out,
        ">",
        0.0,
        "W",
        "conservation of energy",
        "The loss, whose rolling part is an upper bound, comes up to the power: "
        "give more power (gears.power_kW), less speed, a narrower face, or a thinner oil.",
    )
    yield check(
        f"{id}.regime",
        f"EHL film over rigid isoviscous film at the pitch point, {mesh.case.mesh.title}",
        by_regime(mesh).lead_at_pitch,
        ">=",
        1.0,
        "",
        "Johnson 1970, regimes of fluid-film lubrication",
        "EHL formula outside its validity: the load is so light that the rigid isoviscous film governs. "
        + ("The rolling loss is an upper bound." if friction.film == "judged" else 'Choose film = "judged".'),
        kind="advice",
    )
    yield check(
        f"{id}.lambda",
        f"Smallest film over roughness, {mesh.case.mesh.title}",
        mesh.judged.lambda_min,
        ">=",
        1.0,
        "",
        "mixed friction below about 1 (AGMA 925-A03, as generally published)",
        "The flanks touch: smoother flanks, thicker or cooler oil, more speed. Below 0.8 the mixed law is harsher than Schlenk's tests.",
        kind="advice",
    )
    yield check(
        f"{id}.deborah",
        f"Largest Deborah number, {mesh.case.mesh.title}",
        mesh.judged.deborah_max,
        "<=",
        1.0,
        "",
        f"{THESIS}: range of Eyring's law",
        "The oil answers as a solid: its friction is overestimated.",
        kind="advice",
    )
    yield check(
        f"{id}.inlet_heating",
        f"Smallest thermal reduction of the film, {mesh.case.mesh.title}",
        mesh.judged.thermal_reduction_min,
        ">",
        LEAST_FACTOR,
        "",
        OWN,
        "The inlet is hotter than Gupta's formula allows, the film is held at 5 %: less speed or a thinner oil.",
        kind="advice",
    )
    if friction.bulk_temperature is None and friction.bulk == "oil":
        yield check(
            f"{id}.bulk",
            f"Estimated warming of the teeth above the oil, {mesh.case.mesh.title}",
            mesh.bulk_rise,
            "<=",
            BULK_LIMIT,
            "K",
            OWN,
            'The teeth run hotter than the oil: give friction.bulk_temperature_C, or bulk = "estimated".',
            kind="advice",
        )

    if mesh.judged.bulk_temperature is not None:
        yield check(
            f"{id}.bulk_temperature",
            f"Estimated temperature of the teeth, {mesh.case.mesh.title}",
            mesh.judged.bulk_temperature,
            "<=",
            HOT_TEETH,
            "°C",
            "case-hardened steel loses hardness from about 150 to 180 °C on, as generally published",
            "The teeth run hot: less power or loss, a wider face, more oil on them.",
            kind="advice",
        )


# --- where the source is wrong ---------------------------------------------------------------------------------------------
def errata(friction: FrictionInputs, result: FrictionResult, oil: Oil) -> tuple[Erratum, ...]:
    meshes = [e for name, mesh in result.meshes.items() for e in _of_source(f"friction.{name}", friction, mesh)]
    name, mesh = next(iter(result.meshes.items()))
    meshes += oils.errata(oil.lubricant, oil.T_m, "friction.oil_viscosity")
    if not mesh.case.mesh.spur:
        return tuple(meshes)  # the source's pair is spur: the rest is about its own calculation
    loss_ratio = Erratum(
        f"friction.{name}.efficiency",
        "Efficiency of the mesh",
        1 - mesh.judged.efficiency,
        "",
        f"method of the {THESIS}, eq. 1",
        "The printed quotient is the share that is lost, not the efficiency.",
    )
    return (*meshes, loss_ratio)


def _of_source(id: str, friction: FrictionInputs, mesh: MeshResult) -> Iterator[Erratum]:
    c, P = mesh.case, mesh.judged.load
    if by_regime(mesh).lead_at_pitch < 1 and friction.film == "judged":
        yield Erratum(
            f"{id}.film_min",
            "Thinnest film",
            mesh.source.film_min * 1e6,
            "µm",
            f"method of the {THESIS}, section on film thickness",
            "The source takes the EHL formula everywhere. At this load the flanks stay round and the oil as thin as without pressure: "
            "the rigid isoviscous film is thicker, and it costs rolling power that the source does not count.",
        )
    if not c.mesh.spur:
        return
    try:
        elliptical = solve_mesh(c, P, False, ELLIPTICAL)
    except NoSolution:  # the thinner film of the source can get too hot where the right one does not: then it has no value
        elliptical = None
    if elliptical is not None:
        yield Erratum(
            f"{id}.source.loss",
            "Power lost in the mesh, EHL film",
            elliptical.loss,
            "W",
            f"method of the {THESIS}, eq. 26",
            "The printed exponent of the materials parameter, 0.53, belongs to elliptical contacts; line contacts have 0.56.",
        )
    if friction.load_sharing == "linear":
        share = np.where(np.asarray(c.path.carried) < 1, 0.99, 1.0)
        w, _ = line_load(c.mesh, c.path, P / (c.motion.omega_1 * c.mesh.driver.base_radius))
        short_of_load = loss_factor(s=c.path.weight, w=array(share * w), V_s=c.motion.V_s, P=P)
        yield Erratum(
            f"{id}.loss_factor",
            "Loss factor",
            short_of_load,
            "",
            f"method of the {THESIS}, load sharing",
            "Two pairs that carry 0.33 and 0.66 leave 1 % of the load to nobody.",
        )
