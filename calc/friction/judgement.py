# SPDX-License-Identifier: Apache-2.0
"""What is to be said about solved friction: checks, where the source is wrong, notes and curves."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from .. import oils
from ..sheet.check import Check, check
from ..sheet.errors import NoSolution
from ..sheet.number import short
from ..sheet.step import Curve, Erratum, Series, Table
from .balance.closure import Drive
from .inputs import FrictionInputs, carrier
from .losses.wheels import has_bearings
from .mesh.film import ELLIPTICAL, LEAST_FACTOR, Oil
from .mesh.loss import LOADED, THESIS, MeshLoss, loss_factor, solve_mesh
from .mesh.path import array, line_load
from .models import compared
from .result import FrictionResult, MeshResult

OWN = "rule of this program"
BALANCE_LIMIT = 1e-6  # W
BULK_LIMIT = 10.0  # K
JUMP = 1e-6  # of the power
HOT_TEETH = 150.0  # °C
NAMES = {"schlenk": "Schlenk", "niemann": "Niemann and Winter", "xu_kahraman": "Xu and Kahraman", "benedict_kelley": "Benedict and Kelley"}


def said(d: Drive, result: FrictionResult) -> dict[str, Any]:
    """Checks, curves, errata and notes of a closed balance."""
    friction = d.friction
    return {
        "checks": checks(friction, result), "curves": curves(result), "errata": errata(friction, result, d.oil),
        "notes": notes(friction, result, d.oil), "tables": tables(result, d),
    }  # fmt: skip


def by_regime(mesh: MeshResult) -> MeshLoss:
    return mesh.by_regime or mesh.judged


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
    outside = [name for name in NAMES if any(one is None or one.outside for one in (m.published_models[name] for m in meshes))]
    return check(
        "friction.train.models",
        "Published regressions inside their range at every mesh",
        float(len(NAMES) - len(outside)),
        ">=",
        float(len(NAMES)),
        "",
        "ranges of Schlenk, Niemann and Winter, Xu and Kahraman, Benedict and Kelley",
        f"Outside: {', '.join(NAMES[name] for name in outside) or 'none'}; the tables of the models say by what. Their losses are "
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
    return (*meshes, loss_ratio, *oils.errata(oil.lubricant, oil.T_m, source=f"printed in the {THESIS}, table of oils"))


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


# --- notes -----------------------------------------------------------------------------------------------------------------
def notes(friction: FrictionInputs, result: FrictionResult, oil: Oil) -> tuple[str, ...]:
    found = []
    if friction.bulk_temperature is None and friction.bulk == "oil":
        found.append(f"The teeth are taken as warm as the oil, {short(oil.T_m)} °C; their warming is estimated beside.")
    for mesh in result.meshes.values():
        share = by_regime(mesh).rigid_share
        m = by_regime(mesh)
        rigid = f"a rigid isoviscous film on {share * 100:.0f} % of the path"
        if share and m.rolling_loss > m.sliding_loss:
            rigid += f"; at so light a load rolling governs, {short(m.rolling_loss)} W (bound) against {short(m.sliding_loss)} W of sliding"
        found.append(f"Mesh {mesh.case.mesh.title}: {rigid if share else 'no rigid isoviscous film, the EHL formula holds'}.")
    for mesh in result.meshes.values():
        if abs(mesh.power_in - mesh.judged.load) > JUMP * mesh.power_in:
            found.append(
                f"Mesh {mesh.case.mesh.title}: its loss jumps where places on the path change their regime, and the balance falls into the "
                f"jump: solved for {short(mesh.judged.load)} W, while {short(mesh.power_in)} W come in."
            )
    if friction.load_sharing != "linear" and not all(mesh.case.mesh.spur for mesh in result.meshes.values()):
        found.append("The load of a helical mesh is uniform along its contact lines: load_sharing counts for spur pairs only.")
    if friction.load_sharing == "smooth" or any(scenario.load_sharing == "smooth" for scenario in friction.scenarios):
        found.append(
            f"Film and friction are drawn where a place carries {LOADED * 100:g} % of the full load or more: a relieved tip carries none."
        )
    if friction.film == "source":
        found.append("The friction source's film is judged: EHL everywhere, no rolling loss.")
    elif any(mesh.judged.rolling_loss for mesh in result.meshes.values()):
        found.append("The rolling loss of the rigid film supposes a full inlet: it is an upper bound.")
    if any(mesh.xu_kahraman is None for mesh in result.meshes.values()):
        found.append(
            "Xu and Kahraman's regression is not shown: it does not hold for flanks rougher than 2 µm together, nor for any pressure."
        )
    assumed = next(value for value in oils.judged_values(oil.lubricant.oil) if value.key == "limiting_shear")
    where = f"{assumed.source}; confidence {assumed.confidence}"
    found.append(f"Limiting shear {short(oil.Lambda)} of the pressure, by {where}. Steel is taken to conduct 46 W/(m·K).")
    if not friction.seals:
        found.append("No shaft seals are counted, unless given ([[friction.seals]]).")
    if not friction.dips:
        found.append("No wheel dips into oil: churning is not counted ([[friction.dips]]).")
    if not has_bearings(friction):
        found.append("The wheels' own bearings are not counted, unless given ([[friction.rolling_bearings]], [[friction.plain_bearings]]).")
    elif any(b.f_0 is None or b.f_1 is None for b in friction.rolling_bearings if b.method == "palmgren"):
        found.append("Palmgren's factors f_0 and f_1 by type are from memory: give those of the bearing's catalogue.")
    if any(wheel.thrown_oil is not None and wheel.thrown_oil < 0 for wheel in result.wheels.values()):
        found.append("A jet of oil that is faster than the teeth drives its wheel: its loss is below zero.")
    if any(seal.method == "linke" for seal in friction.seals) and 0.0 in [wheel.seal_loss for wheel in result.wheels.values()]:
        found.append("Linke's rule has no loss for shaft seals in so thin and hot an oil: it is outside its range; take simrit.")
    if friction.rolling_bearings or friction.plain_bearings:
        found.append("The wheels' bearings run in oil as warm as that of the teeth.")
    found.append(f"Windage in {short(friction.mist_density)} kg/m³; air alone has 1.2, the mist of the tests behind its formula about 24.")
    last = list(result.meshes.values())[-1].case.mesh.driven.name
    entries: tuple[Any, ...] = (*friction.seals, *friction.rolling_bearings, *friction.plain_bearings, *friction.dips, *friction.jets)
    strange = [entry.name for entry in entries if not carrier(entry.name, result.wheels, "")]
    if strange:
        found.append(f"Carried by wheel {last}, the last, for their names begin with that of no wheel: {', '.join(strange)}.")
    for other in friction.other_losses:
        wheel = carrier(other.name, result.wheels, last)
        why = "" if carrier(other.name, result.wheels, "") else ", the last: its name begins with that of no wheel"
        found.append(f'Other loss "{other.name}", {short(other.power)} W: carried by wheel {wheel}{why}.')
    return tuple(found)


# --- tables ----------------------------------------------------------------------------------------------------------------
def tables(result: FrictionResult, d: Drive) -> tuple[Table, ...]:
    """Where the power goes; the models of every mesh; what is known of the oil."""
    models = (
        compared.table(name, mesh.case.mesh.title, by_regime(mesh), mesh.source, mesh.ohlendorf_loss_factor, mesh.published_models)
        for name, mesh in result.meshes.items()
    )
    printed = oils.printed_table(d.lubricant)
    return (_where(result), *models, oils.values_table(d.lubricant.oil), *(() if printed is None else (printed,)))


def _where(r: FrictionResult) -> Table:
    """The balance, from the first driver to the end of the train."""
    rows: list[tuple[str | float | None, ...]] = []
    for mesh in r.meshes.values():
        m, title = mesh.judged, mesh.case.mesh.title
        rows.append((f"mesh {title}, sliding", m.sliding_loss, m.sliding_loss / r.total_loss * 100))
        if m.rolling_loss:
            rows.append((f"mesh {title}, rolling (bound)", m.rolling_loss, m.rolling_loss / r.total_loss * 100))
    kinds = (
        ("windage", r.windage_loss), ("churning", r.churning_loss), ("oil thrown onto wheels", r.thrown_oil_loss),
        ("shaft seals", r.seal_loss), ("bearings of the wheels", r.wheel_bearing_loss), ("other losses", r.other_loss or None),
    )  # fmt: skip
    rows += [
        (f"journal {place} of the counter-shaft", j.friction_power, j.friction_power / r.total_loss * 100)
        for place, j in r.journals.items()
    ]
    rows += [(kind, P, P / r.total_loss * 100) for kind, P in kinds if P is not None]
    rows.append(("all losses", r.total_loss, 100.0))
    return Table("balance", "Where the power goes", (("Loss", ""), ("P", "W"), ("share", "%")), tuple(rows))


# --- curves ----------------------------------------------------------------------------------------------------------------
def curves(result: FrictionResult) -> tuple[Curve, ...]:
    return tuple(c for name, mesh in result.meshes.items() for c in _curves(name, mesh))


def way(mesh: MeshResult) -> str:
    """The label of the path, with its points."""
    letters = "ABCDE" if mesh.case.mesh.spur else "ACE"
    marks = ", ".join(f"{letter} {x * 1e3:.2f}" for letter, x in zip("ABCDE", mesh.case.path.marks) if letter in letters)
    return f"x from T₁, mm ({marks})"


def _curves(name: str, mesh: MeshResult) -> Iterator[Curve]:
    """Along the path in the middle of the face, judged and by the other model."""
    title, x_label = f"Mesh {mesh.case.mesh.title}", way(mesh)
    models = (("by regime", mesh.by_regime or mesh.judged), ("source: EHL everywhere", mesh.source))

    def lines(quantity: str, factor: float = 1.0) -> tuple[Series, ...]:
        return tuple(Series(label, np.asarray(m.local.x) * 1e3, m.local.drawn(quantity) * factor) for label, m in models)

    roughness = (("combined roughness", mesh.case.surfaces.sigma * 1e6),)
    yield Curve(f"{name}.friction", f"{title}: coefficient of friction along the path", x_label, "μ", lines("mu"))
    yield Curve(f"{name}.film", f"{title}: film along the path", x_label, "h, µm", lines("h", 1e6), roughness)
    yield Curve(f"{name}.heat", f"{title}: friction power along the path", x_label, "q, W/mm of contact line", lines("q", 1e-3))
    yield Curve(f"{name}.temperature", f"{title}: film temperature along the path", x_label, "T_f, °C", lines("T_f"))
