# SPDX-License-Identifier: Apache-2.0
"""What solved friction rests on: what is taken, what is not counted, where the model leaves its range."""

import numpy as np

from ..library import oils
from ..sheet.text import COMMA, Amount, Name, Text
from .inputs import Carried, FrictionInputs, carrier
from .losses.wheels import has_bearings
from .mesh.film import Oil
from .mesh.geometry import WheelGeometry
from .mesh.loss import LOADED
from .mesh.mixed import FULL, regimes
from .result import FrictionResult, by_regime

JUMP = 1e-6  # of the power
NOTEWORTHY = 0.2  # of the loss


def notes(friction: FrictionInputs, result: FrictionResult, oil: Oil) -> tuple[Text, ...]:
    notes = [rises] if (rises := oils.rising_rows(oil.lubricant.oil)) is not None else []
    if friction.bulk_temperature is None and friction.bulk == "oil":
        notes.append(
            Text(
                "The teeth are taken as warm as the oil, {t_m} °C; their warming is estimated beside.",
                t_m=Amount(oil.T_m),
            )
        )
    for mesh in result.meshes.values():
        share = by_regime(mesh).rigid_share
        m = by_regime(mesh)
        rigid = Text("a rigid isoviscous film on {share} % of the path", share=Amount(share * 100, form=".0f"))
        if share and m.rolling_loss > m.sliding_loss:
            rigid += Text(
                "; at so light a load rolling governs, {rolling_loss} W (bound) against {sliding_loss} W of sliding",
                rolling_loss=Amount(m.rolling_loss),
                sliding_loss=Amount(m.sliding_loss),
            )
        thickest = float(np.max(np.asarray(m.local.lam)))
        notes.append(
            Text(
                "Mesh {title}: λ from {lambda_min} to {thickest}, {regimes} lubrication; {rigid}.",
                title=mesh.case.mesh.title,
                lambda_min=Amount(m.lambda_min),
                thickest=Amount(thickest),
                regimes=regimes(m.lambda_min, thickest),
                rigid=rigid if share else Text("no rigid isoviscous film, the EHL formula holds"),
            )
        )
        left_out = mesh.judged.rolling_estimate if friction.film == "judged" else None
        if left_out is not None and left_out > NOTEWORTHY * mesh.judged.loss:
            notes.append(
                Text(
                    "Mesh {title}: where its film is EHL, rolling is not counted; Goksem and Hargreaves estimate it at "
                    "{left_out} W beside the {loss} W that are. So the loss can fall where more load ends the rigid "
                    "film.",
                    title=mesh.case.mesh.title,
                    left_out=Amount(left_out),
                    loss=Amount(mesh.judged.loss),
                )
            )
    for mesh in result.meshes.values():
        if abs(mesh.power_in - mesh.judged.load) > JUMP * mesh.power_in:
            notes.append(
                Text(
                    "Mesh {title}: its loss jumps where places on the path change their regime, and the balance falls "
                    "into "
                    "the jump: solved for {load} W, while {power_in} W come in.",
                    title=mesh.case.mesh.title,
                    load=Amount(mesh.judged.load),
                    power_in=Amount(mesh.power_in),
                )
            )
    if friction.load_sharing != "linear" and not all(mesh.case.mesh.spur for mesh in result.meshes.values()):
        notes.append(
            Text(
                "The load of a helical mesh is uniform along its contact lines: load_sharing counts for spur pairs "
                "only."
            )
        )
    if friction.load_sharing == "smooth" or any(scenario.load_sharing == "smooth" for scenario in friction.scenarios):
        notes.append(
            Text(
                "Film and friction are drawn where a place carries {loaded} % of the full load or more: a relieved "
                "tip carries none.",
                loaded=Amount(LOADED * 100, form="g"),
            )
        )
    if friction.film == "source":
        notes.append(
            Text("The friction source's model is judged: EHL everywhere, its solid friction, no rolling loss.")
        )
    elif any(mesh.judged.rolling_loss for mesh in result.meshes.values()):
        notes.append(Text("The rolling loss of the rigid film supposes a full inlet: it is an upper bound."))
    if any(mesh.published_models["xu_kahraman"] is None for mesh in result.meshes.values()):
        notes.append(
            Text(
                "Xu and Kahraman's regression is not shown: it does not hold for flanks rougher than 2 µm together, "
                "nor for any pressure."
            )
        )
    if any(by_regime(mesh).lambda_min < FULL for mesh in result.meshes.values()):
        rubbing = next(iter(result.meshes.values())).case.rubbing(friction.film == "judged")
        touching = Text(
            "Where the film is thinner than twice the roughness, the load share by {law} rides on peaks that rub with "
            "{mu_s}.",
            law=rubbing.mixing.title,
            mu_s=Amount(rubbing.mu_s),
        )
        notes.append(touching)
    assumed = next(value for value in oils.judged_values(oil.lubricant.oil) if value.key == "limiting_shear")
    where = Text("{source}; confidence {confidence}", source=assumed.source, confidence=assumed.confidence)
    notes.append(
        Text(
            "Limiting shear {lambda_} of the pressure, by {where}. Steel is taken to conduct 46 W/(m·K).",
            lambda_=Amount(oil.Lambda),
            where=where,
        )
    )
    if not friction.seals:
        notes.append(Text("No shaft seals are counted, unless given ([[friction.seals]])."))
    if not friction.dips:
        notes.append(Text("No wheel dips into oil: churning is not counted ([[friction.dips]])."))
    if not has_bearings(friction):
        notes.append(
            Text(
                "The wheels' own bearings are not counted, unless given ([[friction.rolling_bearings]], "
                "[[friction.plain_bearings]])."
            )
        )
    elif any(b.f_0 is None or b.f_1 is None for b in friction.rolling_bearings if b.method == "palmgren"):
        notes.append(
            Text("Palmgren's factors f_0 and f_1 by type are from memory: give those of the bearing's catalogue.")
        )
    if friction.rolling_bearings:
        many = COMMA.join(
            Text("{name} {count}", name=Name(b.name), count=Amount(b.count, form="d"))
            for b in friction.rolling_bearings
        )
        notes.append(Text("Rolling bearings, and how many share each load: {many}.", many=many))
    if any(wheel.thrown_oil is not None and wheel.thrown_oil < 0 for wheel in result.wheels.values()):
        notes.append(Text("A jet of oil that is faster than the teeth drives its wheel: its loss is below zero."))
    if any(seal.method == "linke" for seal in friction.seals) and 0.0 in [
        wheel.seal_loss for wheel in result.wheels.values()
    ]:
        notes.append(
            Text(
                "Linke's rule has no loss for shaft seals in so thin and hot an oil: it is outside its range; take "
                "simrit."
            )
        )
    if friction.rolling_bearings or friction.plain_bearings:
        notes.append(Text("The wheels' bearings run in oil of friction.oil_temperature_C, or of the bearings' supply."))
    notes.append(
        Text(
            "Windage in {mist_density} kg/m³; air alone has 1.2, the mist of the tests behind its formula about 24.",
            mist_density=Amount(friction.mist_density),
        )
    )
    last = list(result.meshes.values())[-1].case.mesh.driven.name
    entries: tuple[Carried, ...] = (
        *friction.seals,
        *friction.rolling_bearings,
        *friction.plain_bearings,
        *friction.dips,
        *friction.jets,
    )
    strange = [entry.name for entry in entries if not carrier(entry, result.wheels, "")]
    if strange:
        notes.append(
            Text(
                "Carried by wheel {last}, the last, for their names begin with that of no wheel: {strange}; wheel = "
                "tells it.",
                last=last,
                strange=", ".join(strange),
            )
        )
    dry = [
        d.name
        for d in friction.dips
        if (w := _body(result, carrier(d, result.wheels, last))).tip_radius - w.reference_radius >= d.depth
    ]
    if dry:
        notes.append(
            Text(
                "Only teeth dip, not the reference circle, from which churning is counted: no loss is found for {dry}.",
                dry=", ".join(dry),
            )
        )
    deep = [
        dip.name for dip in friction.dips if dip.depth > 2 * _body(result, carrier(dip, result.wheels, last)).tip_radius
    ]
    if deep:
        notes.append(
            Text(
                "Under oil altogether, which the correlation of churning was not made for: {deep}.",
                deep=", ".join(deep),
            )
        )
    for other in friction.other_losses:
        wheel = carrier(other, result.wheels, last)
        why = "" if carrier(other, result.wheels, "") else Text(", the last: its name begins with that of no wheel")
        notes.append(
            Text(
                'Other loss "{name}", {power} W: carried by wheel {wheel}{why}.',
                name=other.name,
                power=Amount(other.power),
                wheel=wheel,
                why=why,
            )
        )
    return tuple(notes)


def _body(result: FrictionResult, wheel: str) -> WheelGeometry:
    return next(
        w for mesh in result.meshes.values() for w in (mesh.case.mesh.driver, mesh.case.mesh.driven) if w.name == wheel
    )
