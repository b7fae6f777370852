# SPDX-License-Identifier: Apache-2.0
"""Journal and seat as a pair: what the journal may run on, what such bearings usually carry, and what runs already.

Handbook values give advice and never fail a design; the limits of a bearing stand in `checks`.  Read without numpy, so that a design's
words can be checked before anything is solved.
"""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from ...sheet.check import Check, check
from ...sheet.number import short
from ...sheet.step import Table
from ...sheet.trace import untraced
from ...sheet.units import UNITS, Celsius, Metre, Newton, Number, Pascal, PascalMetrePerSecond, PascalSecond, RevPerSecond, Second
from .data import DEFAULT_APPLICATION as DEFAULT_APPLICATION
from .data import SCALE, Application, BearingMaterial, bearing_materials, running_bearings
from .data import application_problem as application_problem
from .data import applications as applications
from .data import bush_problem as bush_problem
from .data import running_surface as running_surface

LEAST_WORD = "fair"  # rule of this program: below, a warning
FIGURE = "Chirone & Vullo 1979, after Finotti 2013, Fig. 5.16"
USUAL_LENGTH_RATIO = (0.25, 0.75)  # Finotti 2013, 5.5.2


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


# --- with or without a bush ---------------------------------------------------------------------------------------------
def checks(
    place: str, material: BearingMaterial, p: Pascal, pv: PascalMetrePerSecond, T_hot: Celsius, hardness: Number | None = None
) -> Iterator[Check]:
    """Advice by the material's own row, where it has the number; p and p·u on the projected area, the journal's hardness in HB."""
    at, where = f"bearings.{place}", f" {material.name}, {place}"
    other = "another bearing material (bush_material)"
    if material.specific_load is not None:
        yield check(
            f"{at}.material_load", "Specific load allowed for" + where, p, "<=", material.specific_load, "MPa", material.source,
            f"Lengthen the bearing, take a larger journal or {other}.", kind="advice",
        )  # fmt: skip
    if material.pv is not None:
        yield check(
            f"{at}.material_pv", "p·v allowed for" + where, pv, "<=", material.pv, "MPa·m/s", material.source,
            f"Lengthen the bearing or take {other}. p·v stands for the heat of a poor film; with a full film the heat balance decides.",
            kind="advice",
        )  # fmt: skip
    if material.temperature is not None:
        yield check(
            f"{at}.material_temperature", "Temperature allowed for" + where, T_hot, "<=", material.temperature, "°C",
            material.source, f"Cooler or more oil, or {other}.", kind="advice",
        )  # fmt: skip
    if material.journal_hardness is not None and hardness is not None:
        yield check(
            f"{at}.material_hardness", "Hardness of the journal (HB) on" + where, hardness, ">=", material.journal_hardness, "",
            material.source, "Harden the journal.", kind="advice",
        )  # fmt: skip
    yield check(
        f"{at}.material_emergency_running", "Emergency running (1 poor to 4 excellent) of" + where,
        SCALE.index(material.emergency_running) + 1.0, ">=", SCALE.index(LEAST_WORD) + 1.0, "",
        f"{material.emergency_basis}; the scale and its limit: rule of this program",
        _emergency_advice(material), kind="advice",
    )  # fmt: skip


def _emergency_advice(material: BearingMaterial) -> str:
    if material.form != "bare":
        return "A softer running surface, or an overlay; else filtered oil at every start."
    return (
        "Without a bush nothing forgives a broken film: a hardened, finely ground journal and clean oil at every start, or a lined shell "
        "(see the table with or without a bush)."
    )


def fatigue_note(place: str, material: BearingMaterial, p_max: Pascal, n: RevPerSecond, life: Second | None) -> str:
    """How often the load that comes round at `n` presses on the seat, how hard, and what is known of the material's fatigue."""
    from .formulas import load_cycles

    often = f"{short(n * 3600.0, 3)} times an hour"
    if life is not None:
        cycles = load_cycles(n=n, L=life)
        often = f"{short(cycles, 3)} times in {short(UNITS['h'].shown(life))} h"
    return (
        f"{place.capitalize()} bearing: the load passes every point of the seat ({material.title}), which sees the largest film "
        f"pressure, {short(UNITS['MPa'].shown(p_max), 3)} MPa, once a round: {often}. Fatigue: {material.fatigue}."
    )


def table(bearings: Mapping[str, Running], chosen: str) -> Table:
    """With or without a bush: what each material allows, and how much of it the harder of the bearings uses.

    `chosen`: the name of the material that the design has (of its housing, where it has no bush).
    """
    from .formulas import load_share, load_times_speed_share

    hottest = max(b.temperature for b in bearings.values())
    found: list[tuple[str | float | None, ...]] = []
    with untraced():
        for m in bearing_materials().values():
            load = None if m.specific_load is None else max(load_share(p=b.p, p_zul=m.specific_load) for b in bearings.values())
            pv = None if m.pv is None else max(load_times_speed_share(pu=b.pv, pv_zul=m.pv) for b in bearings.values())
            found.append(
                (
                    f"{m.name}, chosen" if m.name == chosen else m.name, m.title, _shown(m.specific_load, "MPa"), _shown(load, "%"),
                    _shown(m.pv, "MPa·m/s"), _shown(pv, "%"), m.temperature, None if m.temperature is None else m.temperature - hottest,
                    m.journal_hardness, m.emergency_running,
                )
            )  # fmt: skip
    return Table(
        "bushes", "With or without a bush",
        (
            ("material", ""), ("what it is", ""), ("p allowed", "MPa"), ("p used", "%"), ("p·v allowed", "MPa·m/s"),
            ("p·v used", "%"),
            ("up to", "°C"), ("in reserve", "K"), ("journal, HB", ""), ("emergency running", ""),
        ),
        tuple(found),
        "Used: by the harder of the bearings. Handbook values at the lower end of their range; empty where no source was found. The "
        "load allowed for the bare casting is the source's limit for its journals, not a value of the alloy. A bush buys a surface that "
        "forgives a broken film and yields to dirt and edges. It adds no film; and a thin shell, while it is held tight, follows the "
        "housing, so that the warm clearance stays.",
    )  # fmt: skip


def _shown(inside: float | None, unit: str) -> float | None:
    return None if inside is None else UNITS[unit].shown(inside)


# --- what runs already --------------------------------------------------------------------------------------------------
def reference_table(own: Iterable[Journal]) -> Table:
    """This design's journals beside those by which the source argues that steel may run in bare aluminium.

    p, W and u of all rows by the same formulas on the whole length: a groove is left out.
    """
    from .. import formulas as f  # loads numpy: not needed to read a design
    from .formulas import load_times_speed

    found: list[tuple[str | float | None, ...]] = []
    with untraced():
        for name, status, d, l, n, F in (
            *((j.name, "this design", j.diameter, j.length, j.speed, j.load) for j in own),
            *((r.name, r.status, r.diameter, r.length, r.speed, r.load) for r in running_bearings().values()),
        ):
            p, u = f.specific_load(F=F, d=d, l=l), f.surface_speed(d=d, n=n)
            cells: tuple[tuple[Any, str], ...] = (
                (d, "mm"), (l, "mm"), (n, "rpm"), (F, "N"), (p, "MPa"), (f.heat_index(F=F, n=n, l=l), "N·rpm/mm"), (u, "m/s"),
                (load_times_speed(p=p, u=u), "MPa·m/s"),
            )  # fmt: skip
            found.append((name, status, *(UNITS[unit].shown(float(x)) for x, unit in cells)))
    return Table(
        "running_bearings", "Journals in bare aluminium, and this design's",
        (
            ("journal", ""), ("status", ""), ("d", "mm"), ("l", "mm"), ("n", "rpm"), ("F", "N"), ("p", "MPa"), ("W", "N·rpm/mm"),
            ("u", "m/s"), ("p·u", "MPa·m/s"),
        ),
        tuple(found),
        "The source argues that steel may run in bare aluminium here, since it does in the R754IE4. What the table shows: a like size of "
        "load, p and W. What it does not: film, roughness and warm clearance, which are not in p and W. The centre journal of the R754IE4 "
        "goes beyond the very limits it is quoted for (5 MPa and 500 000 N·rpm/mm): either they are no limits, or its load, here by the "
        "three-moment equation on rigid supports in line, is not the true one.",
    )  # fmt: skip


# --- what is usual ------------------------------------------------------------------------------------------------------
def application_checks(
    place: str, row: Application, p: Pascal, pv: PascalMetrePerSecond, mu: PascalSecond, mu_n_over_p: Number, psi: Number, l_over_d: Number
) -> Iterator[Check]:
    """Advice by what bearings of this application usually carry; nothing where the figure has a dash.  ψ as made, not warm."""
    at, where, source = f"bearings.{place}", f", {place}", f"{FIGURE} ({row.title})"
    yield check(
        f"{at}.application_load", "Specific load of the application" + where, p, "<=", row.specific_load_high, "MPa", source,
        "Lengthen the bearing or take a larger journal.", kind="advice",
    )  # fmt: skip
    if row.pv is not None:
        yield check(
            f"{at}.application_pv", "p·v of the application" + where, pv, "<=", row.pv, "MPa·m/s", source,
            "Lengthen the bearing.", kind="advice",
        )  # fmt: skip
    if row.duty_low is not None:
        yield check(
            f"{at}.application_duty", "µ·n/p of the application" + where, mu_n_over_p, ">=", row.duty_low, "", source,
            f"A thicker or cooler oil than {short(UNITS['mPa·s'].shown(mu), 3)} mPa·s, or a lower specific load.", kind="advice",
        )  # fmt: skip
    if row.relative_clearance is not None:
        yield check(
            f"{at}.clearance_usual", "Relative clearance" + where, psi, "<=", row.relative_clearance, "‰", source,
            "Less clearance, as long as the cold clearance stays.", kind="advice",
        )  # fmt: skip
    if row.length_ratio_low is not None and row.length_ratio_high is not None:
        low, high = row.length_ratio_low, row.length_ratio_high
        yield check(
            f"{at}.length_ratio_application", "Length ratio of the application" + where, l_over_d, "in", (low, high), "", source,
            _length_advice(low, high), kind="advice",
        )  # fmt: skip


def _length_advice(low: float, high: float) -> str:
    usual_low, usual_high = USUAL_LENGTH_RATIO
    if low > usual_high or high < usual_low:
        span = f"{short(low)} to {short(high)}" if low < high else short(low)
        return (
            f"This rule ({span}) and the usual {short(usual_low)} to {short(usual_high)} (Finotti 2013, 5.5.2) exclude each other: one "
            "of the two warns whatever the length. Short bearings suit a slope of the journal and a large oil flow, long ones a thick film."
        )
    return "A longer bearing on a smaller diameter, or the other way round."
