# SPDX-License-Identifier: Apache-2.0
"""What is to be said about solved friction: checks, where the source is wrong, notes and curves."""

from collections.abc import Iterator
from functools import partial

from ..bearings.inputs import BearingsInputs
from ..countershaft.inputs import ShaftInputs
from ..countershaft.outline import Outline
from ..countershaft.result import CountershaftResult
from ..countershaft.rows import EACH_ROW, SHAFT, BearingRow
from ..gears.inputs import GearsInputs
from ..gears.rating.checks import LINE_LOAD, MICROPITTING_FILM
from ..library import oils
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.deferred import Later
from ..sheet.quantity import declared, dotted
from ..sheet.record import replace
from ..sheet.remedy import by_key
from ..sheet.step import Erratum, Outcome
from ..sheet.text import EMPTY, SEMICOLON, Amount, Text
from ..sheet.units import Metre, Watt
from ..sheet.value import Line
from . import curves, notes
from .inputs import FrictionInputs
from .mesh.film import LEAST_FACTOR, Oil
from .mesh.loss import MeshLoss
from .mesh.mixed import THESIS
from .models import MODELS, factor_apart
from .power_balance import TrainDrive
from .result import FrictionResult, MeshResult, by_regime

OWN = Text("rule of this program")
CONSERVATION = Text("conservation of energy")
BALANCE_LIMIT = 1e-6  # W
BULK_LIMIT = 10.0  # K
HOT_TEETH = 150.0  # °C
APART_OF_MASSES = 0.1  # of all losses
APART = 1.3  # between the loss that is judged and a published model inside its range


def outcome(d: TrainDrive, result: FrictionResult, lines: list[Line]) -> Outcome[FrictionResult]:
    """A closed balance with its checks, curves, errata and notes."""
    friction = d.friction
    return Outcome(
        "friction",
        result=result,
        lines=tuple(lines),
        checks=tuple(checks(friction, result, d.oil)),
        curves=Later(partial(curves.curves, result, d)),
        errata=Later(lambda: errata(friction, result, d.oil)),
        notes=Later(partial(notes.notes, friction, result, d.oil, d.last)),
        tables=Later(partial(curves.tables, result, d)),
    )


# --- checks

TEMPERATURES = (
    dotted("friction", FrictionInputs.oil_temperature),
    dotted("bearings", BearingsInputs.supply_temperature),
)
BALANCE = CheckRule(
    "friction.train.balance",
    "limit",
    "Energy is conserved: else the program is wrong, and nothing that it says of the train holds.",
    Text("Power balance of the train: what is left over"),
    "<=",
    "W",
    CONSERVATION,
    Text("A fault of the program, not of the design: please report it."),
    role="self",
)
DELIVERED = CheckRule(
    "friction.train.delivered",
    "limit",
    "Nothing comes out of the train.",
    Text("Power that the last wheel delivers: more than nothing"),
    ">",
    "W",
    CONSERVATION,
    Text(
        "Windage, other losses and the meshes eat all of the power: give more power, or less speed, mist or face width."
    ),
    role="physics",
    zero="power of the first driver",
    value_id=dotted("friction", FrictionResult.delivered_power),
    moved_by=(
        dotted("gears", GearsInputs.power),
        dotted("friction", FrictionInputs.mist_density),
        dotted("gears", GearsInputs.face_width),
    ),
)
TRAIN_MODELS = CheckRule(
    "friction.train.models",
    "method",
    "Published regressions outside their range judge nothing.",
    Text("Published regressions inside their range at every mesh"),
    source=Text("ranges of Schlenk 1994, Niemann & Winter, Xu and Kahraman 2005, Benedict and Kelley 1961"),
)
MASS_BRACKET = CheckRule(
    "friction.train.mass_bracket",
    "method",
    "No measurement says where in this bracket the loss lies; the sum of the losses is known no better.",
    Text("Bracket of the loss of the turning masses"),
    "<=",
    "W",
    Text("rule of this program: a tenth of all losses; no measurement of half-moon masses was found"),
    Text("Cover the sectors by a close shell, or measure."),
    moved_by=(
        dotted(SHAFT, ShaftInputs.covered),
        dotted("friction", FrictionInputs.mist_density),
        dotted("friction", FrictionInputs.mass_loss),
    ),
)
BEARING_SHARE = CheckRule(
    "friction.train.bearing_share",
    "advice",
    "What carries the shafts burns more fuel than is usual.",
    Text("Losses of the bearings over the engine's rated power"),
    "<=",
    "%",
    OWN,
    Text("Smaller journals, thinner oil, or rolling bearings: `choose FILE bearings` ranks both kinds."),
    value_id=dotted("friction", FrictionResult.bearing_share),
    moved_by=(
        dotted("bearings", BearingsInputs.oil),
        dotted(EACH_ROW, BearingRow.kind),
        dotted(EACH_ROW, BearingRow.diameter),
        dotted(EACH_ROW, BearingRow.length),
    ),
)
MUCH = 0.01  # of the rated power
OIL_LEVEL = CheckRule(
    "countershaft.oil_level",
    "caution",
    "Sectors that dip throw the oil at every turn, which can cost more than all else.",
    Text("Lowest point that the sectors sweep, up from the crank, above the oil at rest"),
    unit="mm",
    source=Text("geometry; rule of this program: sectors run dry"),
    advice=Text("Less oil, a higher shaft, or a shell that keeps it out and drains."),
    zero="the outer radius of the sectors",
    moved_by=(
        dotted("friction", FrictionInputs.oil_level),
        dotted(SHAFT, ShaftInputs.axis),
    ),
)
VISCOSITY_RANGE = CheckRule(
    "friction.train.viscosity_range",
    "method",
    "Outside it the viscosity is an extrapolation.",
    Text("Oil viscosity"),
    "in",
    "mm²/s",
    oils.LAW_RANGE,
    oils.OTHER_OIL,
    moved_by=TEMPERATURES,
)
OIL_ROWS = CheckRule(
    "friction.train.oil_rows",
    "method",
    "Beyond the rows of the oil its viscosity is an extrapolation.",
    Text("Oil temperature within the rows of the oil"),
    "in",
    "°C",
    oils.BEYOND_ROWS,
    oils.MORE_ROWS,
    moved_by=TEMPERATURES,
)
POWER_OUT = CheckRule(
    dotted("friction", "M", MeshResult.power_out),
    "limit",
    "Nothing comes out of the mesh.",
    sense=">",
    unit="W",
    source=CONSERVATION,
    advice=Text(
        "The loss, whose rolling part is an upper bound, comes up to the power: "
        "give more power, less speed, a narrower face, or a thinner oil."
    ),
    role="physics",
    zero="power that the mesh takes in",
    value_id=dotted("friction", "M", MeshResult.power_out),
    moved_by=(dotted("gears", GearsInputs.power), dotted("gears", GearsInputs.face_width)),
)
REGIME = CheckRule(
    "friction.M.regime",
    "method",
    "The EHL film is used outside its validity.",
    source=Text("Johnson 1970, regimes of fluid-film lubrication"),
    cause=LINE_LOAD.cause,
    moved_by=(dotted("friction", FrictionInputs.film),),
)
LAMBDA = CheckRule(
    "friction.M.lambda",
    "advice",
    "Mixed friction is usual between the teeth of such trains; it costs loss and wear, not the part.",
    source=Text("AGMA 925-A03: mixed friction below about 1"),
    advice=Text("The flanks touch: smoother flanks, thicker or cooler oil, more speed."),
    cause=MICROPITTING_FILM.cause,
    value_id=dotted("friction", "M", declared(MeshLoss).lambda_min),
    moved_by=(dotted("friction", FrictionInputs.flank_roughness), *TEMPERATURES),
)
MESH_MODELS = CheckRule(
    "friction.M.models",
    "caution",
    "The loss is known no better than the models agree; the teeth hold.",
    sense="<=",
    source=Text("rule of this program; published models of tooth friction differ by as much among themselves"),
    value_id=dotted("friction", "M", declared(MeshLoss).sliding_loss),
    moved_by=(
        dotted("friction", FrictionInputs.load_share),
        dotted("friction", FrictionInputs.solid_friction),
        dotted("friction", FrictionInputs.flank_roughness),
    ),
)
DEBORAH = CheckRule(
    "friction.M.deborah",
    "method",
    "Outside it the law of the oil overestimates its friction.",
    sense="<=",
    source=Text("{thesis}, 4.4: range of Eyring's law", thesis=THESIS),
    advice=Text("The oil answers as a solid: its friction is overestimated."),
    value_id=dotted("friction", "M", declared(MeshLoss).deborah_max),
)
INLET_HEATING = CheckRule(
    "friction.M.inlet_heating",
    "method",
    "The formula of the film is held at its lower end.",
    sense=">",
    source=OWN,
    advice=Text(
        "The inlet is hotter than Gupta's formula allows, the film is held at 5 %: less speed or a thinner oil."
    ),
)
BULK = CheckRule(
    "friction.M.bulk",
    "method",
    "The oil between the flanks is taken at a temperature that the teeth do not have.",
    sense="<=",
    unit="K",
    source=OWN,
    advice=Text("The teeth run hotter than the oil: estimate their temperature, or give it."),
    value_id=dotted("friction", "M", MeshResult.bulk_rise),
    moved_by=(dotted("friction", FrictionInputs.bulk_temperature),),
)
BULK_TEMPERATURE = CheckRule(
    dotted("friction", "M", declared(MeshLoss).bulk_temperature),
    "caution",
    "The teeth lose their hardness; the temperature is an estimate.",
    sense="<=",
    unit="°C",
    source=Text("rule of this program: case-hardened steel loses hardness from about 150 to 180 °C on, from memory"),
    advice=Text("The teeth run hot: less power or loss, a wider face, more oil on them."),
    demand=True,
    value_id=dotted("friction", "M", declared(MeshLoss).bulk_temperature),
    moved_by=(dotted("gears", GearsInputs.power), dotted("gears", GearsInputs.face_width)),
)


def checks(friction: FrictionInputs, result: FrictionResult, oil: Oil) -> Iterator[Check]:
    # to a thousandth of the limit: what the last digits of a sum leave depends on the processor
    yield BALANCE(round(abs(result.residual), 9), BALANCE_LIMIT)
    if result.delivered_power is not None:
        yield DELIVERED(result.delivered_power, 0.0, scale=result.crank_power)
    if (masses := result.masses) is not None:
        yield MASS_BRACKET(masses.mass_loss_high - masses.mass_loss_low, APART_OF_MASSES * result.total_loss)
    yield _models_check(result)
    for name, mesh in result.meshes.items():
        yield from _mesh_checks(name, friction, mesh)
    yield from _oil_checks(oil)


def with_oil_level(
    outcome: Outcome[CountershaftResult], shaft: ShaftInputs, friction: FrictionInputs | None
) -> Outcome[CountershaftResult]:
    """The same outcome with whether its sectors turn above the oil at rest."""
    level = friction.oil_level if friction is not None else None
    if outcome.result is None or level is None or shaft.covered == "shell":
        return outcome
    return replace(outcome, checks=(*outcome.checks, *oil_level_checks(shaft, outcome.result.outline, level)))


def oil_level_checks(shaft: ShaftInputs, outline: Outline | None, level: Metre) -> Iterator[Check]:
    """Of a shaft; where its radius or its axis is not given, nobody knows."""
    radii = [piece.outer_radius for piece in outline.pieces if piece.what == "sector"] if outline is not None else []
    R = max(radii, default=shaft.outer_radius)
    if R is None or shaft.axis is None:
        lacks = ((ShaftInputs.outer_radius, R), (ShaftInputs.axis, shaft.axis))
        keys = tuple(dotted(SHAFT, field) for field, given in lacks if given is None)
        yield OIL_LEVEL(None, level, scale=R or 1.0, missing=Missing(keys, (), "none", "none"))
    else:
        yield OIL_LEVEL(round(shaft.axis[0] - R, 9), level, scale=R)


def _models_check(result: FrictionResult) -> Check:
    """How many of the published regressions hold for every mesh."""
    meshes = result.meshes.values()
    outside = [
        name
        for name in MODELS
        if any(regression is None or regression.outside for regression in (m.published_models[name] for m in meshes))
    ]
    advice = Text(
        "Outside: {authors}. The tables of the models say by what. Their losses are extrapolations; nothing is "
        "judged by them.",
        authors=SEMICOLON.join(MODELS[name].authors for name in outside) if outside else Text("none"),
    )
    return TRAIN_MODELS(float(len(MODELS) - len(outside)), float(len(MODELS)), advice=advice)


def _oil_checks(oil: Oil) -> Iterator[Check]:
    """Whether the oil's own table of viscosities, where it has one, reaches to its temperature, and whether its law
    does."""
    nu, usual = oil.lubricant.nu(oil.T_m), oils.VISCOSITIES
    if not (oil.lubricant.constant or usual[0] <= nu <= usual[1]):
        yield VISCOSITY_RANGE(nu, usual)
    if (reach := oil.lubricant.reach) is not None:
        yield OIL_ROWS(oil.T_m, reach)


def _published_check(mesh_name: str, mesh: MeshResult, inside: dict[str, Watt]) -> Check:
    """How far the sliding loss that is judged lies from that of the published model that is farthest from it."""
    P_s = mesh.judged.sliding_loss
    factors = {name: factor_apart(P_1=P_s, P_2=P) for name, P in inside.items()}
    each = Text("; ").join(
        Text("{authors} {P_of} W", authors=MODELS[name].authors, P_of=Amount(P)) for name, P in inside.items()
    )
    title = mesh.case.mesh.title
    label = Text("Sliding loss as judged against published models inside their range, {title}", title=title)
    known = Text(
        "Factor of the farthest. Judged: {P_s} W; {each}. Take the loss as known to this factor.",
        P_s=Amount(P_s),
        each=each,
    )
    return MESH_MODELS(max(factors.values()), APART, at=mesh_name, name=label, advice=known)


def _mesh_checks(mesh_name: str, friction: FrictionInputs, mesh: MeshResult) -> Iterator[Check]:
    """One limit, that power comes out at all; else where the model leaves its range, and what the flanks would like."""
    judged, title, by_film = mesh.judged, mesh.case.mesh.title, friction.film == "judged"
    label = Text("Mesh {title} passes on more than nothing", title=title)
    yield POWER_OUT(mesh.power_out, 0.0, at=mesh_name, name=label, scale=mesh.power_in)
    lead = by_regime(mesh).lead_at_pitch
    label = Text("EHL film over rigid isoviscous film at the pitch point, {title}", title=title)
    advice = Text("EHL formula outside its validity: the load is so light that the rigid isoviscous film governs. ")
    advice += Text("The rolling loss is an upper bound.") if by_film else EMPTY
    ways = None if by_film else by_key(FrictionInputs, dotted("friction", FrictionInputs.film), "judged")
    yield REGIME(lead, 1.0, at=mesh_name, name=label, advice=advice, remedies=ways)
    label = Text("Smallest film over roughness, {title}", title=title)
    yield LAMBDA(judged.lambda_min, 1.0, at=mesh_name, name=label)
    inside = {
        name: regression.loss
        for name, regression in mesh.published_models.items()
        if regression is not None and not regression.outside and regression.loss > 0
    }
    # all of them come from loaded teeth and discs, whose films are EHL
    if inside and lead >= 1 and judged.sliding_loss > 0:
        yield _published_check(mesh_name, mesh, inside)
    label = Text("Largest Deborah number, {title}", title=title)
    yield DEBORAH(judged.deborah_max, 1.0, at=mesh_name, name=label)
    label = Text("Smallest thermal reduction of the film, {title}", title=title)
    yield INLET_HEATING(judged.thermal_reduction_min, LEAST_FACTOR, at=mesh_name, name=label)
    if friction.bulk_temperature is None and friction.bulk == "oil":
        label = Text("Estimated warming of the teeth above the oil, {title}", title=title)
        ways = by_key(FrictionInputs, dotted("friction", FrictionInputs.bulk), "estimated")
        yield BULK(mesh.bulk_rise, BULK_LIMIT, at=mesh_name, name=label, remedies=ways)
    if judged.bulk_temperature is not None:
        label = Text("Estimated temperature of the teeth, {title}", title=title)
        yield BULK_TEMPERATURE(judged.bulk_temperature, HOT_TEETH, at=mesh_name, name=label)


# --- where the source is wrong


def errata(friction: FrictionInputs, result: FrictionResult, oil: Oil) -> tuple[Erratum, ...]:
    films = [e for name, mesh in result.meshes.items() for e in _film_of_source(name, friction, mesh)]
    return (*films, *oils.errata(oil.lubricant, oil.T_m, dotted("friction", FrictionResult.oil_viscosity)))


def _film_of_source(name: str, friction: FrictionInputs, mesh: MeshResult) -> Iterator[Erratum]:
    if mesh.source is not None and by_regime(mesh).lead_at_pitch < 1 and friction.film == "judged":
        yield Erratum(
            dotted("friction", name, declared(MeshLoss).film_min),
            Text("Thinnest film"),
            mesh.source.film_min * 1e6,
            "µm",
            Text("method of the {thesis}, 4.3", thesis=THESIS),
            Text(
                "The source takes the EHL formula everywhere. At this load the flanks stay round and the oil as thin "
                "as without pressure: the rigid isoviscous film is thicker, and it costs rolling power that the source "
                "does not count."
            ),
            (str(THESIS), "974-979, 1457"),
        )
