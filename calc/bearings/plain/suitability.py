# SPDX-License-Identifier: Apache-2.0
"""Journal and seat as a pair: what the journal may run on, what such bearings usually carry, and what runs already.

In order: the formulas, with or without a bush, running examples, what is usual for the application.

Handbook values never fail a design; the limits of a bearing stand in `checks`."""

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import NamedTuple

from ...countershaft.rows import ROW, BearingRow, called, titled
from ...library.journal_rules import MAKERS, RELATIVE_CLEARANCE, heat_index, specific_load
from ...sheet.check import Check, CheckRule
from ...sheet.formula import formula
from ...sheet.quantity import dotted
from ...sheet.step import Table
from ...sheet.text import Amount, Text
from ...sheet.units import (
    UNITS,
    Celsius,
    Metre,
    MetrePerSecond,
    Newton,
    Number,
    Pascal,
    PascalMetrePerSecond,
    PascalSecond,
    RevPerSecond,
    Second,
)
from ...sheet.value import based_on, untraced
from ..inputs import BearingsInputs
from . import formulas as f
from .materials import SCALE, Application, BearingMaterial, bearing_materials, running_bearings, running_surface
from .result import PlainResult

# --- what the pairing of journal and seat is judged by
# p·v, the share of what is allowed, the turns of the load, the duty of a full film.


@formula("p·u", "definition of p·v: specific load times surface speed", unit="MPa·m/s")
def load_times_speed(p: Pascal, u: MetrePerSecond) -> PascalMetrePerSecond:
    return p * u


@formula("p/p_zul", "definition: share of the allowable specific load of the bearing material", unit="%")
def load_share(p: Pascal, p_zul: Pascal) -> Number:
    return p / p_zul


@formula(
    "p·u/(p·v)_zul",
    "definition: share of the allowable p·v of the bearing material",
    unit="%",
    names={"pu": "(p·u)", "pv_zul": "(p·v)_zul"},
)
def load_times_speed_share(pu: PascalMetrePerSecond, pv_zul: PascalMetrePerSecond) -> Number:
    return pu / pv_zul


@formula(
    "N_L", "kinematics: a load that turns with the shaft passes every point of the seat once a turn", names={"L": "L_h"}
)
def load_cycles(n: RevPerSecond, L: Second) -> Number:
    """How often each point of the seat sees the largest film pressure in a life."""
    return n * L


@formula(
    "μ·n/p",
    "Chirone & Vullo 1979, after Finotti 2013, Fig. 5.16: duty of a full film; a pure number with n in revolutions "
    "per second",
)
def film_duty(mu: PascalSecond, n_h: RevPerSecond, p: Pascal) -> Number:
    """Not the source's 1.7·10⁻⁶, which it quotes for McKee's limit by a wrong conversion; 30 cP·rpm/psi are
    7.25·10⁻⁸."""
    return mu * n_h / p


LEAST_WORD = "fair"  # rule of this program: below it, advice
RUNS_IN = ("good", "excellent")  # words of emergency running
SMOOTHEST: Metre = 0.01e-6  # Ra of a polished journal; rule of this program
FIGURE = Text("Chirone & Vullo 1979, after Finotti 2013, Fig. 5.16")

LENGTH = dotted(ROW, BearingRow.length)
DIAMETER = dotted(ROW, BearingRow.diameter)
OIL = dotted("bearings", BearingsInputs.oil)
SUPPLY_TEMPERATURE = dotted("bearings", BearingsInputs.supply_temperature)
BUSH = dotted("bearings", BearingsInputs.bush_material)

MATERIAL_LOAD = CheckRule(
    "bearings.B.material_load",
    "caution",
    "Beyond it the seat's material creeps or fatigues; such figures are general ones.",
    sense="<=",
    unit="MPa",
    advice=Text("Lengthen the bearing, take a larger journal or another bearing material."),
    demand=True,
    value_id=dotted("bearings", "B", PlainResult.specific_load),
    moved_by=(LENGTH, DIAMETER, BUSH),
)
MATERIAL_PV = CheckRule(
    "bearings.B.material_pv",
    "advice",
    "It stands for the heat of a poor film; with a full film the heat balance decides.",
    sense="<=",
    unit="MPa·m/s",
    advice=Text(
        "Lengthen the bearing or take another bearing material. p·v stands for the heat of a poor film; with a full "
        "film the heat balance decides."
    ),
    demand=True,
    value_id=dotted("bearings", "B", PlainResult.pressure_velocity),
    moved_by=(LENGTH, BUSH),
)
MATERIAL_TEMPERATURE = CheckRule(
    "bearings.B.material_temperature",
    "caution",
    "Beyond it the seat's material softens; such figures are general ones.",
    sense="<=",
    unit="°C",
    advice=Text("Cooler or more oil, or another bearing material."),
    demand=True,
    value_id=dotted("bearings", "B", PlainResult.outlet_temperature),
    moved_by=(SUPPLY_TEMPERATURE, dotted("bearings", BearingsInputs.hole_diameter), BUSH),
)
MATERIAL_HARDNESS = CheckRule(
    "bearings.B.material_hardness",
    "caution",
    "A softer journal wears on this seat when the film is thin.",
    advice=Text("Harden the journal."),
    moved_by=(dotted("bearings", BearingsInputs.journal_material),),
)
MATERIAL_EMERGENCY_RUNNING = CheckRule(
    "bearings.B.material_emergency_running",
    "advice",
    "It counts only where the film breaks.",
    cause="bearings.material_emergency_running",
    moved_by=(BUSH,),
)
APPLICATION_LOAD = CheckRule(
    "bearings.B.application_load",
    "advice",
    "What bearings of this application usually carry.",
    sense="<=",
    unit="MPa",
    advice=Text("Lengthen the bearing or take a larger journal."),
    demand=True,
    value_id=dotted("bearings", "B", PlainResult.specific_load),
    moved_by=(LENGTH, DIAMETER),
)
APPLICATION_PV = CheckRule(
    "bearings.B.application_pv",
    "advice",
    "What bearings of this application usually carry.",
    sense="<=",
    unit="MPa·m/s",
    advice=Text("Lengthen the bearing."),
    demand=True,
    value_id=dotted("bearings", "B", PlainResult.pressure_velocity),
    moved_by=(LENGTH,),
)
APPLICATION_DUTY = CheckRule(
    "bearings.B.application_duty",
    "advice",
    "What bearings of this application usually have.",
    value_id=dotted("bearings", "B", PlainResult.duty_number),
    moved_by=(OIL, SUPPLY_TEMPERATURE, LENGTH),
)
LENGTH_RATIO_APPLICATION = CheckRule(
    "bearings.B.length_ratio_application",
    "advice",
    "What bearings of this application usually have.",
    sense="in",
    advice=Text("A longer bearing on a smaller diameter, or the other way round."),
    value_id=dotted("bearings", "B", PlainResult.length_ratio),
    moved_by=(LENGTH, DIAMETER),
)
CLEARANCE_USUAL = CheckRule(
    "bearings.B.clearance_usual",
    "advice",
    "What makers print for their balance shafts; film, heat and cold clearance decide.",
    sense="in",
    unit="‰",
    source=MAKERS,
    advice=Text("Less or more clearance, as long as film, heat and cold clearance allow it."),
    cause="bearings.clearance_usual",
    moved_by=(
        dotted(ROW, BearingRow.clearance),
        dotted(ROW, BearingRow.clearance_factor),
    ),
)


class Journal(NamedTuple):
    """One journal of this design, to set beside the references."""

    name: str
    diameter: Metre
    length: Metre
    speed: RevPerSecond
    load: Newton


class Running(NamedTuple):
    """What a bearing asks of its material: specific load, p·u, and the hottest temperature."""

    p: Pascal
    pv: PascalMetrePerSecond
    temperature: Celsius


# --- with or without a bush


def film_asked(inputs: BearingsInputs, journal: Metre, seat: Metre) -> Metre:
    """The film that keeps the peaks of both surfaces apart, by their roughnesses Ra.  On a lining that runs in the seat
    counts as no rougher than its journal; bare metal keeps its peaks.  A journal of no roughness is one of the finest
    that are made, and so is the film that is asked for."""
    if journal < SMOOTHEST:
        journal = based_on(SMOOTHEST, journal)
    surface = running_surface(inputs.bush_material, inputs.housing_material)
    if surface is not None and surface.form != "bare" and surface.emergency_running in RUNS_IN:
        seat = f.roughness_run_in(Ra_1=journal, Ra_2=seat)
    return f.kreisle_film(k_R=inputs.roughness_ratio, Ra_1=journal, Ra_2=seat)


def material_checks(
    place: str,
    material: BearingMaterial,
    p: Pascal,
    pv: PascalMetrePerSecond,
    T_hot: Celsius,
    T_in: Celsius,
    hardness: Number | None = None,
) -> Iterator[Check]:
    """By the material's own row, where it has the number; p and p·u on the projected area, the journal's hardness in
    HB; `T_in`: of the oil that is supplied."""
    of = {"material": material.name, "place": called(place)}
    # what a bare seat carries is the source's limit, which has a check of its own
    allowed = None if material.form == "bare" else material.specific_load
    for rule, label, value, limit, base in (
        (MATERIAL_LOAD, Text("Specific load allowed for {material}, {place}", **of), p, allowed, 0.0),
        (MATERIAL_PV, Text("p·v allowed for {material}, {place}", **of), pv, material.pv, 0.0),
        (
            MATERIAL_TEMPERATURE,
            Text("Temperature allowed for {material}, {place}", **of),
            T_hot,
            material.temperature,
            T_in,
        ),
        (
            MATERIAL_HARDNESS,
            Text("Hardness of the journal (HB) on {material}, {place}", **of),
            hardness,
            material.journal_hardness,
            0.0,
        ),
    ):
        if value is not None and limit is not None:
            yield rule(value, limit, at=place, name=label, source=Text(material.source), base=base)
    label = Text("Emergency running (1 poor to 4 excellent) of {material}, {place}", **of)
    grade, least = (SCALE.index(word) + 1.0 for word in (material.emergency_running, LEAST_WORD))
    basis = Text(
        "{emergency_basis}; the scale and its limit: rule of this program", emergency_basis=material.emergency_basis
    )
    advice = _emergency_advice(material)
    yield MATERIAL_EMERGENCY_RUNNING(grade, least, at=place, name=label, source=basis, advice=advice)


def _emergency_advice(material: BearingMaterial) -> Text:
    if material.form != "bare":
        return Text("A softer running surface, or an overlay; else filtered oil at every start.")
    return Text(
        "Without a bush nothing forgives a broken film: a hardened, finely ground journal and clean oil at every "
        "start, or a lined shell (see the table with or without a bush)."
    )


def fatigue_note(place: str, material: BearingMaterial, p_max: Pascal, n: RevPerSecond, life: Second | None) -> Text:
    """How often the load that comes round at `n` presses on the seat, how hard, and what is known of the material's
    fatigue."""
    often = Text("{n} times an hour", n=Amount(n * 3600.0, digits=3))
    if life is not None:
        cycles, hours = Amount(load_cycles(n=n, L=life), digits=3), Amount(UNITS["h"].shown(life))
        often = Text("{cycles} times in {units} h", cycles=cycles, units=hours)
    return Text(
        "{place} bearing: the load passes every point of the seat ({title}), which sees the largest film "
        "pressure, {units} MPa, once a round: {often}. Fatigue: {fatigue}.",
        place=titled(place),
        title=material.title,
        units=Amount(UNITS["MPa"].shown(p_max), digits=3),
        often=often,
        fatigue=material.fatigue,
    )


def table(bearings: Mapping[str, Running], chosen: Collection[str]) -> Table:
    """With or without a bush: what each material allows, and how much of it the harder of the bearings uses.

    `chosen`: the names of the materials that the design has (of its housing, where a bearing has no bush).
    """

    running = bearings.values()
    columns = (
        (Text("material"), ""),
        (Text("what it is"), ""),
        (Text("p allowed"), "MPa"),
        (Text("p used"), "%"),
        (Text("p·v allowed"), "MPa·m/s"),
        (Text("p·v used"), "%"),
        (Text("up to"), "°C"),
        (Text("in reserve"), "K"),
        (Text("journal, HB"), ""),
        (Text("emergency running"), ""),
    )
    rows: list[tuple[str | float | None, ...]] = []
    with untraced():
        for m in bearing_materials().values():
            name = Text("{name}, chosen", name=m.name) if m.name in chosen else m.name
            p, pv, T = m.specific_load, m.pv, m.temperature
            load = None if p is None else max(load_share(p=b.p, p_zul=p) for b in running)
            heat = None if pv is None else max(load_times_speed_share(pu=b.pv, pv_zul=pv) for b in running)
            reserve = None if T is None else T - max(b.temperature for b in running)
            numbers = p, load, pv, heat, T, reserve, m.journal_hardness
            shown = (None if x is None else UNITS[unit].shown(x) for x, (_, unit) in zip(numbers, columns[2:]))
            rows.append((name, m.title, *shown, Text(m.emergency_running)))
    note = Text(
        "Used: by the harder of the bearings. Handbook values at the lower end of their range; empty where no source "
        "was found. The "
        "load allowed for the bare casting is the source's limit for its journals, not a value of the alloy. A bush "
        "buys a surface that "
        "forgives a broken film and yields to dirt and edges. It adds no film; and a thin shell, while it is held "
        "tight, follows the "
        "housing, so that the warm clearance stays."
    )
    return Table("bushes", Text("With or without a bush"), columns, tuple(rows), note)


# --- what runs already


def reference_table(journals: Iterable[Journal]) -> Table:
    """This design's journals beside those by which the source argues that steel may run in bare aluminium.

    p, W and u of all rows by the same formulas on the whole length: a groove is left out.
    """
    columns = (
        (Text("journal"), ""),
        (Text("status"), ""),
        (Text("d"), "mm"),
        (Text("l"), "mm"),
        (Text("n"), "rpm"),
        (Text("F"), "N"),
        (Text("p"), "MPa"),
        (Text("W"), "N·rpm/mm"),
        (Text("u"), "m/s"),
        (Text("p·u"), "MPa·m/s"),
    )
    rows: list[tuple[str | float | None, ...]] = []
    with untraced():
        for name, status, d, l, n, F in (
            *((j.name, Text("this design"), j.diameter, j.length, j.speed, j.load) for j in journals),
            *((r.name, r.status, r.diameter, r.length, r.speed, r.load) for r in running_bearings().values()),
        ):
            p, u = specific_load(F=F, d=d, l=l), f.surface_speed(d=d, n=n)
            numbers = d, l, n, F, p, heat_index(F=F, n=n, l=l), u, load_times_speed(p=p, u=u)
            rows.append((name, status, *(UNITS[unit].shown(float(x)) for x, (_, unit) in zip(numbers, columns[2:]))))
    note = Text(
        "The source argues that steel may run in bare aluminium here, since it does in the R754IE4. What the table "
        "shows: a like size of "
        "load, p and W. What it does not: film, roughness and warm clearance, which are not in p and W. The centre "
        "journal of the R754IE4 "
        "goes beyond the very limits it is quoted for (5 MPa and 500 000 N·rpm/mm): either they are no limits, or its "
        "load, here by the "
        "three-moment equation on rigid supports in line, is not the true one."
    )
    return Table("running_bearings", Text("Journals in bare aluminium, and this design's"), columns, tuple(rows), note)


# --- what is usual


def application_checks(
    place: str,
    row: Application,
    p: Pascal,
    pv: PascalMetrePerSecond,
    mu: PascalSecond,
    mu_n_over_p: Number,
    psi: Number,
    l_over_d: Number,
) -> Iterator[Check]:
    """Advice by what bearings of this application usually carry, where their row has it, and by the clearances that
    makers print.  ψ as made, not warm."""
    at: dict[str, Text] = {"place": called(place)}
    source = Text("{figure} ({row})", figure=FIGURE, row=row.title)
    if row.specific_load_high is not None:
        label = Text("Specific load of the application, {place}", **at)
        yield APPLICATION_LOAD(p, row.specific_load_high, at=place, name=label, source=source)
    if row.pv is not None:
        label = Text("p·v of the application, {place}", **at)
        yield APPLICATION_PV(pv, row.pv, at=place, name=label, source=source)
    if row.duty_low is not None:
        label, viscosity = Text("µ·n/p of the application, {place}", **at), Amount(UNITS["mPa·s"].shown(mu), digits=3)
        advice = Text("A thicker or cooler oil than {units} mPa·s, or a lower specific load.", units=viscosity)
        yield APPLICATION_DUTY(mu_n_over_p, row.duty_low, at=place, name=label, source=source, advice=advice)
    if row.length_ratio_low is not None and row.length_ratio_high is not None:
        label, ratios = (
            Text("Length ratio of the application, {place}", **at),
            (row.length_ratio_low, row.length_ratio_high),
        )
        yield LENGTH_RATIO_APPLICATION(l_over_d, ratios, at=place, name=label, source=source)
    yield CLEARANCE_USUAL(psi, RELATIVE_CLEARANCE, at=place, name=Text("Relative clearance as made, {place}", **at))
