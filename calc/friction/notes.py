# SPDX-License-Identifier: Apache-2.0
"""What solved friction rests on: what is taken, what is not counted, where the model leaves its range."""

from collections.abc import Iterator

import numpy as np

from ..library import oils
from ..sheet.text import COMMA, Amount, Name, Text
from .inputs import Carried, FrictionInputs, carrier
from .losses.wheels import has_bearings
from .mesh.film import Oil
from .mesh.geometry import WheelGeometry
from .mesh.loss import LOADED, MeshLoss
from .mesh.mixed import FULL, regimes
from .result import FrictionResult, MeshResult, by_regime

JUMP = 1e-6  # of the power
NOTEWORTHY = 0.2  # of the loss


def notes(friction: FrictionInputs, result: FrictionResult, oil: Oil, last: str) -> tuple[Text, ...]:
    """`last`: the wheel that carries what names none."""
    return (
        *_of_temperatures(friction, oil),
        *(note for mesh in result.meshes.values() for note in _of_regime(friction, mesh)),
        *_of_jumps(result),
        *_of_load_sharing(friction, result),
        *_of_mesh_models(friction, result),
        *_of_rubbing(friction, result),
        _of_limiting_shear(oil),
        *_of_turning_masses(friction, result),
        *_not_counted(friction),
        *_of_rolling_bearings(friction),
        *_outside_models(friction, result),
        *_of_surroundings(friction),
        *_without_wheel(friction, result, last),
        *_of_dips(friction, result, last),
        *_of_other_losses(friction, result, last),
    )


# --- oil and meshes
def _of_temperatures(friction: FrictionInputs, oil: Oil) -> Iterator[Text]:
    """What the oil's viscosity does with them, and how warm the teeth are."""
    if (rises := oils.rising_rows(oil.lubricant.oil)) is not None:
        yield rises
    if friction.bulk_temperature is None and friction.bulk == "oil":
        yield Text(
            "The teeth are taken as warm as the oil, {t_m} °C; their warming is estimated beside.", t_m=Amount(oil.T_m)
        )


def _of_regime(friction: FrictionInputs, mesh: MeshResult) -> Iterator[Text]:
    """The lubrication of one mesh, and the rolling that its model leaves out."""
    loss = by_regime(mesh)
    thickest = float(np.max(np.asarray(loss.local.lam)))
    yield Text(
        "Mesh {title}: λ from {lambda_min} to {thickest}, {regimes} lubrication; {rigid}.",
        title=mesh.case.mesh.title,
        lambda_min=Amount(loss.lambda_min),
        thickest=Amount(thickest),
        regimes=regimes(loss.lambda_min, thickest),
        rigid=_rigid_film(loss),
    )
    left_out = mesh.judged.rolling_estimate if friction.film == "judged" else None
    if left_out is not None and left_out > NOTEWORTHY * mesh.judged.loss:
        yield Text(
            "Mesh {title}: where its film is EHL, rolling is not counted; Goksem and Hargreaves estimate it at "
            "{left_out} W beside the {loss} W that are. So the loss can fall where more load ends the rigid "
            "film.",
            title=mesh.case.mesh.title,
            left_out=Amount(left_out),
            loss=Amount(mesh.judged.loss),
        )


def _rigid_film(loss: MeshLoss) -> Text:
    """On how much of the path it stands, and whether rolling then governs."""
    share = loss.rigid_share
    if not share:
        return Text("no rigid isoviscous film, the EHL formula holds")
    rigid = Text("a rigid isoviscous film on {share} % of the path", share=Amount(share * 100, form=".0f"))
    if loss.rolling_loss > loss.sliding_loss:
        rigid += Text(
            "; at so light a load rolling governs, {rolling_loss} W (bound) against {sliding_loss} W of sliding",
            rolling_loss=Amount(loss.rolling_loss),
            sliding_loss=Amount(loss.sliding_loss),
        )
    return rigid


def _of_jumps(result: FrictionResult) -> Iterator[Text]:
    """Meshes whose balance does not close, since their loss is no steady function of the power."""
    for mesh in result.meshes.values():
        if abs(mesh.power_in - mesh.judged.load) > JUMP * mesh.power_in:
            yield Text(
                "Mesh {title}: its loss jumps where places on the path change their regime, and the balance falls into "
                "the jump: solved for {load} W, while {power_in} W come in.",
                title=mesh.case.mesh.title,
                load=Amount(mesh.judged.load),
                power_in=Amount(mesh.power_in),
            )


def _of_load_sharing(friction: FrictionInputs, result: FrictionResult) -> Iterator[Text]:
    if friction.load_sharing != "linear" and not all(mesh.case.mesh.spur for mesh in result.meshes.values()):
        yield Text(
            "The load of a helical mesh is uniform along its contact lines: the sharing of the load counts for "
            "spur pairs only."
        )
    if friction.load_sharing == "smooth" or any(scenario.load_sharing == "smooth" for scenario in friction.scenarios):
        yield Text(
            "Film and friction are drawn where a place carries {loaded} % of the full load or more: a relieved "
            "tip carries none.",
            loaded=Amount(LOADED * 100, form="g"),
        )


def _of_mesh_models(friction: FrictionInputs, result: FrictionResult) -> Iterator[Text]:
    """Which model is judged, and where those beside it do not hold."""
    meshes = result.meshes.values()
    if friction.film == "source":
        yield Text("The friction source's model is judged: EHL everywhere, its solid friction, no rolling loss.")
    elif any(mesh.judged.rolling_loss for mesh in meshes):
        yield Text("The rolling loss of the rigid film supposes a full inlet: it is an upper bound.")
    if any(mesh.published_models["xu_kahraman"] is None for mesh in meshes):
        yield Text(
            "Xu and Kahraman's regression is not shown: it does not hold for flanks rougher than 2 µm together, "
            "nor for any pressure."
        )


def _of_rubbing(friction: FrictionInputs, result: FrictionResult) -> Iterator[Text]:
    """What the peaks of the flanks carry where the film is thin, and how they rub."""
    if any(by_regime(mesh).lambda_min < FULL for mesh in result.meshes.values()):
        rubbing = next(iter(result.meshes.values())).case.rubbing(friction.film == "judged")
        yield Text(
            "Where the film is thinner than twice the roughness, the load share by {law} rides on peaks that rub with "
            "{mu_s}.",
            law=rubbing.mixing.title,
            mu_s=Amount(rubbing.mu_s),
        )


def _of_limiting_shear(oil: Oil) -> Text:
    assumed = next(value for value in oils.judged_values(oil.lubricant.oil) if value.key == "limiting_shear")
    where = Text("{source}; confidence {confidence}", source=assumed.source, confidence=assumed.confidence)
    return Text(
        "Limiting shear {lambda_} of the pressure, by {where}. Steel is taken to conduct 46 W/(m·K).",
        lambda_=Amount(oil.Lambda),
        where=where,
    )


# --- losses beside the meshes
def _of_turning_masses(friction: FrictionInputs, result: FrictionResult) -> Iterator[Text]:
    """How well the loss of the sectors in the mist is known."""
    if result.masses is not None:
        yield Text(
            "No measurement of what half-moon masses lose in mist was found: between {low} W, as closed cylinders, and "
            "{high} W, as plates in air at rest besides, {counted} W are counted.",
            low=Amount(result.masses.mass_loss_low),
            high=Amount(result.masses.mass_loss_high),
            counted=Amount(result.masses.mass_loss),
        )
    elif friction.mass_loss == "none":
        if result.journals:
            yield Text("What the turning masses lose in the mist is not counted, unless their loss is asked for.")
    else:
        yield Text(
            "What the turning masses lose is not counted: {why}.",
            why=Text("the outline of the shaft is not known, or has no sector")
            if result.journals
            else Text("no bearings close the balance, the power is given"),
        )


def _not_counted(friction: FrictionInputs) -> Iterator[Text]:
    """Losses of which the design says nothing."""
    if not friction.seals:
        yield Text("No shaft seals are counted, unless given.")
    if not friction.dips:
        yield Text("No wheel dips into oil: churning is not counted.")
    if not has_bearings(friction):
        yield Text("The wheels' own bearings are not counted, unless given.")


def _of_rolling_bearings(friction: FrictionInputs) -> Iterator[Text]:
    bearings = friction.rolling_bearings
    if any(bearing.f_0 is None or bearing.f_1 is None for bearing in bearings if bearing.method == "palmgren"):
        yield Text("Palmgren's factors f_0 and f_1 by type are from memory: give those of the bearing's catalogue.")
    if bearings:
        counts = COMMA.join(
            Text("{name} {count}", name=Name(bearing.name), count=Amount(bearing.count, form="d"))
            for bearing in bearings
        )
        yield Text("Rolling bearings, and how many share each load: {many}.", many=counts)


def _outside_models(friction: FrictionInputs, result: FrictionResult) -> Iterator[Text]:
    """Losses of jets and seals that come out below zero, or as none."""
    wheels = result.wheels.values()
    if any(wheel.thrown_oil is not None and wheel.thrown_oil < 0 for wheel in wheels):
        yield Text("A jet of oil that is faster than the teeth drives its wheel: its loss is below zero.")
    if any(seal.method == "linke" for seal in friction.seals) and 0.0 in [wheel.seal_loss for wheel in wheels]:
        yield Text(
            "Linke's rule has no loss for shaft seals in so thin and hot an oil: it is outside its range; take simrit."
        )


def _of_surroundings(friction: FrictionInputs) -> Iterator[Text]:
    """The oil in which bearings run, and the mist in which wheels turn."""
    if has_bearings(friction):
        yield Text("The wheels' bearings run in oil of friction.oil_temperature_C, or of the bearings' supply.")
    yield Text(
        "Windage in {mist_density} kg/m³; air alone has 1.2, the mist of the tests behind its formula about 24.",
        mist_density=Amount(friction.mist_density),
    )


# --- which wheel carries what
def _without_wheel(friction: FrictionInputs, result: FrictionResult, last: str) -> Iterator[Text]:
    """Losses that the last wheel carries, since they name none."""
    entries: tuple[Carried, ...] = (
        *friction.seals,
        *friction.rolling_bearings,
        *friction.plain_bearings,
        *friction.dips,
        *friction.jets,
    )
    strange = [entry.name for entry in entries if not carrier(entry, result.wheels, "")]
    if strange:
        yield Text(
            "Carried by wheel {last}, the last, for their names begin with that of no wheel: {strange}; wheel = "
            "tells it.",
            last=last,
            strange=", ".join(strange),
        )


def _of_dips(friction: FrictionInputs, result: FrictionResult, last: str) -> Iterator[Text]:
    """Wheels that dip too little, or too deep, for the correlation of churning."""
    dipping = [(dip, _geometry(result, carrier(dip, result.wheels, last))) for dip in friction.dips]
    dry = [dip.name for dip, wheel in dipping if wheel.tip_radius - wheel.reference_radius >= dip.depth]
    if dry:
        yield Text(
            "Only teeth dip, not the reference circle, from which churning is counted: no loss is found for {dry}.",
            dry=", ".join(dry),
        )
    deep = [dip.name for dip, wheel in dipping if dip.depth > 2 * wheel.tip_radius]
    if deep:
        yield Text(
            "Under oil altogether, which the correlation of churning was not made for: {deep}.", deep=", ".join(deep)
        )


def _of_other_losses(friction: FrictionInputs, result: FrictionResult, last: str) -> Iterator[Text]:
    for other in friction.other_losses:
        why = "" if carrier(other, result.wheels, "") else Text(", the last: its name begins with that of no wheel")
        yield Text(
            'Other loss "{name}", {power} W: carried by wheel {wheel}{why}.',
            name=other.name,
            power=Amount(other.power),
            wheel=carrier(other, result.wheels, last),
            why=why,
        )


def _geometry(result: FrictionResult, wheel: str) -> WheelGeometry:
    meshes = [mesh.case.mesh for mesh in result.meshes.values()]
    return next(body for mesh in meshes for body in (mesh.driver, mesh.driven) if body.name == wheel)
