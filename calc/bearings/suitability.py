# SPDX-License-Identifier: Apache-2.0
"""Journal and seat as a pair: what the journal may run on, what such bearings usually carry, and what runs already.

In order: the formulas, with or without a bush, running examples, what is usual for the application.

Handbook values give advice and never fail a design; the limits of a bearing stand in `checks`.  Read without numpy, so
that a design's words can be checked before anything is solved."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from ..library.journal_rules import USUAL_LENGTH_RATIO, heat_index, specific_load
from ..sheet.check import Check
from ..sheet.formula import formula
from ..sheet.number import short
from ..sheet.shim_check import check
from ..sheet.step import Table
from ..sheet.text import Amount, Text
from ..sheet.units import (
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
from ..sheet.value import untraced
from .inputs import IN_TITLES, IN_WORDS
from .materials import SCALE, Application, BearingMaterial, bearing_materials, running_bearings

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


LEAST_WORD = "fair"  # rule of this program: below, a warning
FIGURE = Text("Chirone & Vullo 1979, after Finotti 2013, Fig. 5.16")


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


def checks(
    place: str,
    material: BearingMaterial,
    p: Pascal,
    pv: PascalMetrePerSecond,
    T_hot: Celsius,
    hardness: Number | None = None,
) -> Iterator[Check]:
    """Advice by the material's own row, where it has the number; p and p·u on the projected area, the journal's
    hardness in HB."""
    at, of = f"bearings.{place}.material", {"material": material.name, "place": IN_WORDS[place]}
    other, source = Text("another bearing material"), Text(material.source)
    load = Text("Specific load allowed for {material}, {place}", **of)
    longer = Text("Lengthen the bearing, take a larger journal or {other}.", other=other)
    heat = Text("p·v allowed for {material}, {place}", **of)
    cooler = Text(
        "Lengthen the bearing or take {other}. p·v stands for the heat of a poor film; with a full film the heat "
        "balance decides.",
        other=other,
    )
    temperature = Text("Temperature allowed for {material}, {place}", **of)
    oiled = Text("Cooler or more oil, or {other}.", other=other)
    surface, harder = Text("Hardness of the journal (HB) on {material}, {place}", **of), Text("Harden the journal.")
    for key, label, value, sense, limit, unit, advice in (
        ("load", load, p, "<=", material.specific_load, "MPa", longer),
        ("pv", heat, pv, "<=", material.pv, "MPa·m/s", cooler),
        ("temperature", temperature, T_hot, "<=", material.temperature, "°C", oiled),
        ("hardness", surface, hardness, ">=", material.journal_hardness, "", harder),
    ):
        if value is not None and limit is not None:
            yield check(f"{at}_{key}", label, value, sense, limit, unit, source, advice)
    label = Text("Emergency running (1 poor to 4 excellent) of {material}, {place}", **of)
    grade, least = (SCALE.index(word) + 1.0 for word in (material.emergency_running, LEAST_WORD))
    basis = Text(
        "{emergency_basis}; the scale and its limit: rule of this program", emergency_basis=material.emergency_basis
    )
    yield check(f"{at}_emergency_running", label, grade, ">=", least, "", basis, _emergency_advice(material))


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
        place=IN_TITLES[place],
        title=material.title,
        units=Amount(UNITS["MPa"].shown(p_max), digits=3),
        often=often,
        fatigue=material.fatigue,
    )


def table(bearings: Mapping[str, Running], chosen: str) -> Table:
    """With or without a bush: what each material allows, and how much of it the harder of the bearings uses.

    `chosen`: the name of the material that the design has (of its housing, where it has no bush).
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
            name = Text("{name}, chosen", name=m.name) if m.name == chosen else m.name
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
    from .formulas import surface_speed  # with numpy

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
            p, u = specific_load(F=F, d=d, l=l), surface_speed(d=d, n=n)
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
    """Advice by what bearings of this application usually carry; nothing where the figure has a dash.  ψ as made, not
    warm."""
    at, where, source = f"bearings.{place}", IN_WORDS[place], Text("{figure} ({row})", figure=FIGURE, row=row.title)
    label = Text("Specific load of the application, {place}", place=where)
    advice = Text("Lengthen the bearing or take a larger journal.")
    yield check(f"{at}.application_load", label, p, "<=", row.specific_load_high, "MPa", source, advice)
    if row.pv is not None:
        label = Text("p·v of the application, {place}", place=where)
        yield check(f"{at}.application_pv", label, pv, "<=", row.pv, "MPa·m/s", source, Text("Lengthen the bearing."))
    if row.duty_low is not None:
        label = Text("µ·n/p of the application, {place}", place=where)
        viscosity = Amount(UNITS["mPa·s"].shown(mu), digits=3)
        advice = Text("A thicker or cooler oil than {units} mPa·s, or a lower specific load.", units=viscosity)
        yield check(f"{at}.application_duty", label, mu_n_over_p, ">=", row.duty_low, "", source, advice)
    if row.relative_clearance is not None:
        label = Text("Relative clearance as made, {place}", place=where)
        advice = Text("Less clearance, as long as the cold clearance stays.")
        yield check(f"{at}.clearance_usual", label, psi, "<=", row.relative_clearance, "‰", source, advice)
    if row.length_ratio_low is not None and row.length_ratio_high is not None:
        label = Text("Length ratio of the application, {place}", place=where)
        ratios = row.length_ratio_low, row.length_ratio_high
        advice = _length_advice(*ratios)
        yield check(f"{at}.length_ratio_application", label, l_over_d, "in", ratios, "", source, advice)


def _length_advice(low: float, high: float) -> Text:
    usual_low, usual_high = USUAL_LENGTH_RATIO
    if low > usual_high or high < usual_low:
        span = Text("{low} to {high}", low=Amount(low), high=Amount(high)) if low < high else short(low)
        return Text(
            "This rule ({span}) and the usual {usual_low} to {usual_high} (Finotti 2013, 5.5.2) exclude each other: "
            "one of the two is noted whatever the length. Short bearings suit a slope of the journal and a large oil "
            "flow, long ones a thick film.",
            span=span,
            usual_low=Amount(usual_low),
            usual_high=Amount(usual_high),
        )
    return Text("A longer bearing on a smaller diameter, or the other way round.")
