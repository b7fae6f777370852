# SPDX-License-Identifier: Apache-2.0
"""What is to be said about solved friction: checks, where the source is wrong, notes and curves."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from ..library import oils
from ..sheet.check import Check, check
from ..sheet.deferred import Later
from ..sheet.errors import NoSolution
from ..sheet.quantity import dotted
from ..sheet.remedy import by_key
from ..sheet.step import Erratum, Outcome
from ..sheet.text import EMPTY, SEMICOLON, Amount, Text
from ..sheet.units import Watt
from ..sheet.value import Line
from . import curves, notes
from .inputs import FrictionInputs
from .mesh.film import ELLIPTICAL, LEAST_FACTOR, Oil
from .mesh.loss import MeshLoss, loss_factor, solve_mesh
from .mesh.mixed import THESIS
from .mesh.path import line_load
from .models import MODELS, factor_apart
from .power_balance import TrainDrive
from .result import FrictionResult, MeshResult, by_regime

OWN = Text("rule of this program")
BALANCE_LIMIT = 1e-6  # W
BULK_LIMIT = 10.0  # K
HOT_TEETH = 150.0  # °C
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
        notes=Later(partial(notes.notes, friction, result, d.oil)),
        tables=Later(partial(curves.tables, result, d)),
    )


# --- checks


def checks(friction: FrictionInputs, result: FrictionResult, oil: Oil) -> Iterator[Check]:
    yield check(
        "friction.train.balance",
        Text("Power balance of the train: what is left over"),
        abs(result.residual),
        "<=",
        BALANCE_LIMIT,
        "W",
        Text("conservation of energy"),
        Text("A fault of the program, not of the design: please report it."),
    )
    if result.delivered_power is not None:
        yield _delivered_check(result.delivered_power)
    yield _models_check(result)
    for name, mesh in result.meshes.items():
        yield from _mesh_checks(f"friction.{name}", friction, mesh)
    yield from _oil_checks(oil)


def _models_check(result: FrictionResult) -> Check:
    """How many of the published regressions hold for every mesh."""
    meshes = result.meshes.values()
    outside = [
        name
        for name in MODELS
        if any(regression is None or regression.outside for regression in (m.published_models[name] for m in meshes))
    ]
    return check(
        "friction.train.models",
        Text("Published regressions inside their range at every mesh"),
        float(len(MODELS) - len(outside)),
        ">=",
        float(len(MODELS)),
        "",
        Text("ranges of Schlenk 1994, Niemann & Winter, Xu and Kahraman 2005, Benedict and Kelley 1961"),
        Text(
            "Outside: {authors}. The tables of the models say by what. Their losses are extrapolations; nothing is "
            "judged by them.",
            authors=SEMICOLON.join(MODELS[name].authors for name in outside) if outside else Text("none"),
        ),
    )


def _oil_checks(oil: Oil) -> Iterator[Check]:
    """Whether the oil's own table of viscosities, where it has one, reaches to its temperature, and whether its law
    does."""
    nu = oil.lubricant.nu(oil.T_m)
    if not (oil.lubricant.constant or oils.VISCOSITIES[0] <= nu <= oils.VISCOSITIES[1]):
        yield check(
            "friction.train.viscosity_range",
            Text("Oil viscosity"),
            nu,
            "in",
            oils.VISCOSITIES,
            "mm²/s",
            oils.LAW_RANGE,
            oils.OTHER_OIL,
        )
    if (reach := oil.lubricant.reach) is not None:
        yield check(
            "friction.train.oil_rows",
            Text("Oil temperature within the rows of the oil"),
            oil.T_m,
            "in",
            reach,
            "°C",
            oils.BEYOND_ROWS,
            oils.MORE_ROWS,
        )


def _delivered_check(power: float) -> Check:
    return check(
        "friction.train.delivered",
        Text("Power that the last wheel delivers: more than nothing"),
        power,
        ">",
        0.0,
        "W",
        Text("conservation of energy"),
        Text(
            "Windage, other losses and the meshes eat all of the power: give more power, or less speed, mist or face "
            "width."
        ),
    )


def _published_check(id: str, mesh: MeshResult, inside: dict[str, Watt]) -> Check:
    """How far the sliding loss that is judged lies from that of the published model that is farthest from it."""
    P_s = mesh.judged.sliding_loss
    factors = {name: factor_apart(P_1=P_s, P_2=P) for name, P in inside.items()}
    worst = max(factors, key=lambda name: factors[name])
    each = Text("; ").join(
        Text("{authors} {P_of} W", authors=MODELS[name].authors, P_of=Amount(P)) for name, P in inside.items()
    )
    return check(
        f"{id}.models",
        Text("Sliding loss as judged against published models inside their range, {title}", title=mesh.case.mesh.title),
        factors[worst],
        "<=",
        APART,
        "",
        Text("rule of this program; published models of tooth friction differ by as much among themselves"),
        Text(
            "Factor of the farthest. Judged: {P_s} W; {each}. Take the loss as known to this factor.",
            P_s=Amount(P_s),
            each=each,
        ),
    )


def _mesh_checks(id: str, friction: FrictionInputs, mesh: MeshResult) -> Iterator[Check]:
    """One limit, that power comes out at all; else advice: where the model leaves its range, and what the flanks would
    like."""
    yield check(
        f"{id}.power_out",
        Text("Mesh {title} passes on more than nothing", title=mesh.case.mesh.title),
        mesh.power_out,
        ">",
        0.0,
        "W",
        Text("conservation of energy"),
        Text(
            "The loss, whose rolling part is an upper bound, comes up to the power: "
            "give more power, less speed, a narrower face, or a thinner oil."
        ),
    )
    yield check(
        f"{id}.regime",
        Text("EHL film over rigid isoviscous film at the pitch point, {title}", title=mesh.case.mesh.title),
        by_regime(mesh).lead_at_pitch,
        ">=",
        1.0,
        "",
        Text("Johnson 1970, regimes of fluid-film lubrication"),
        Text("EHL formula outside its validity: the load is so light that the rigid isoviscous film governs. ")
        + (Text("The rolling loss is an upper bound.") if friction.film == "judged" else EMPTY),
        remedies=None
        if friction.film == "judged"
        else by_key(FrictionInputs, dotted("friction", FrictionInputs.film), "judged"),
    )
    yield check(
        f"{id}.lambda",
        Text("Smallest film over roughness, {title}", title=mesh.case.mesh.title),
        mesh.judged.lambda_min,
        ">=",
        1.0,
        "",
        Text("AGMA 925-A03: mixed friction below about 1"),
        Text("The flanks touch: smoother flanks, thicker or cooler oil, more speed."),
    )
    inside = {
        name: regression.loss
        for name, regression in mesh.published_models.items()
        if regression is not None and not regression.outside and regression.loss > 0
    }
    elastic = by_regime(mesh).lead_at_pitch >= 1  # all of them come from loaded teeth and discs, whose films are EHL
    if inside and elastic and mesh.judged.sliding_loss > 0:
        yield _published_check(id, mesh, inside)
    yield check(
        f"{id}.deborah",
        Text("Largest Deborah number, {title}", title=mesh.case.mesh.title),
        mesh.judged.deborah_max,
        "<=",
        1.0,
        "",
        Text("{thesis}, 4.4: range of Eyring's law", thesis=THESIS),
        Text("The oil answers as a solid: its friction is overestimated."),
    )
    yield check(
        f"{id}.inlet_heating",
        Text("Smallest thermal reduction of the film, {title}", title=mesh.case.mesh.title),
        mesh.judged.thermal_reduction_min,
        ">",
        LEAST_FACTOR,
        "",
        OWN,
        Text("The inlet is hotter than Gupta's formula allows, the film is held at 5 %: less speed or a thinner oil."),
    )
    if friction.bulk_temperature is None and friction.bulk == "oil":
        yield check(
            f"{id}.bulk",
            Text("Estimated warming of the teeth above the oil, {title}", title=mesh.case.mesh.title),
            mesh.bulk_rise,
            "<=",
            BULK_LIMIT,
            "K",
            OWN,
            Text("The teeth run hotter than the oil: estimate their temperature, or give it."),
            remedies=by_key(FrictionInputs, dotted("friction", FrictionInputs.bulk), "estimated"),
        )
    if mesh.judged.bulk_temperature is not None:
        yield check(
            f"{id}.bulk_temperature",
            Text("Estimated temperature of the teeth, {title}", title=mesh.case.mesh.title),
            mesh.judged.bulk_temperature,
            "<=",
            HOT_TEETH,
            "°C",
            Text("rule of this program: case-hardened steel loses hardness from about 150 to 180 °C on, from memory"),
            Text("The teeth run hot: less power or loss, a wider face, more oil on them."),
        )


# --- where the source is wrong


def errata(friction: FrictionInputs, result: FrictionResult, oil: Oil) -> tuple[Erratum, ...]:
    meshes = [e for name, mesh in result.meshes.items() for e in _of_source(f"friction.{name}", friction, mesh)]
    name, mesh = next(iter(result.meshes.items()))
    meshes += oils.errata(oil.lubricant, oil.T_m, dotted("friction", FrictionResult.oil_viscosity))
    if not mesh.case.mesh.spur:
        return tuple(meshes)  # the source's pair is spur: the rest is about its own calculation
    loss_ratio = Erratum(
        dotted("friction", name, MeshLoss.efficiency),
        Text("Efficiency of the mesh"),
        1 - mesh.judged.efficiency,
        "",
        Text("method of the {thesis}, eq. 1", thesis=THESIS),
        Text("The printed quotient is the share that is lost, not the efficiency."),
    )
    return (*meshes, loss_ratio)


def _of_source(id: str, friction: FrictionInputs, mesh: MeshResult) -> Iterator[Erratum]:
    c, P = mesh.case, mesh.judged.load
    if mesh.source is None:
        return
    if by_regime(mesh).lead_at_pitch < 1 and friction.film == "judged":
        yield Erratum(
            f"{id}.film_min",
            Text("Thinnest film"),
            mesh.source.film_min * 1e6,
            "µm",
            Text("method of the {thesis}, 4.3", thesis=THESIS),
            Text(
                "The source takes the EHL formula everywhere. At this load the flanks stay round and the oil as thin "
                "as without pressure: "
                "the rigid isoviscous film is thicker, and it costs rolling power that the source does not count."
            ),
        )
    if not c.mesh.spur:
        return
    own_law = friction.film == "judged" and friction.solid_friction is None and friction.load_share != "thesis"
    if own_law and by_regime(mesh).lead_at_pitch >= 1:
        yield Erratum(
            f"{id}.friction_mean",
            Text("Mean coefficient of friction"),
            mesh.source.friction_mean,
            "",
            Text("method of the {thesis}, section on mixed lubrication", thesis=THESIS),
            Text(
                "Peaks that rub as those of rollers do, and too many of them: measured gears have half of that and "
                "less, and so has the "
                "paper that the source follows (Arana, Larrañaga and Ulacia 2018: 0.065 to 0.07 where it takes 0.135)."
            ),
        )
    try:
        elliptical = solve_mesh(c, P, False, ELLIPTICAL)
    except NoSolution:
        # the thinner film of the source can get too hot where the right one does not: then it has no value
        elliptical = None
    if elliptical is not None:
        yield Erratum(
            dotted(id, "source", MeshLoss.loss),
            Text("Power lost in the mesh, EHL film"),
            elliptical.loss,
            "W",
            Text("method of the {thesis}, eq. 26", thesis=THESIS),
            Text(
                "The printed exponent of the materials parameter, 0.53, belongs to elliptical contacts; line contacts "
                "have 0.56."
            ),
        )
    if friction.load_sharing == "linear":
        share = np.where(np.asarray(c.path.carried) < 1, 0.99, 1.0)
        w, _ = line_load(c.mesh, c.path, P / (c.motion.omega_1 * c.mesh.driver.base_radius))
        short_of_load = loss_factor(s=c.path.weight, w=share * w, V_s=c.motion.V_s, P=P)
        yield Erratum(
            f"{id}.loss_factor",
            Text("Loss factor"),
            short_of_load,
            "",
            Text("method of the {thesis}, 5.1, load sharing", thesis=THESIS),
            Text("Two pairs that carry 0.33 and 0.66 leave 1 % of the load to nobody."),
        )
