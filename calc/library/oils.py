# SPDX-License-Identifier: Apache-2.0
"""What is known of an oil: each value with source and confidence, and printed viscosities held against the oil's own
law.

A printed dynamic viscosity is kept where it is within 5 % of the law through the oil's two kinematic viscosities and
its density; else it is rejected, and the reason is found from the numbers: what it implies, its SAE grade, its
neighbours, and what is printed for other oils."""

import re
from collections.abc import Iterator

from ..sheet.expression import symbol
from ..sheet.quantity import Quantity, dotted, keys
from ..sheet.record import record, replace
from ..sheet.step import Erratum, Table
from ..sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Name, Text
from ..sheet.units import UNITS, Celsius, Number, PascalSecond, SquareMetrePerSecond
from ..sheet.value import untraced
from .catalogue import BaseStock, Claim, Oil, PrintedViscosity, ViscosityRow, base_stocks, grades
from .lubricant import Lubricant
from .oil_formulas import LOWEST, implied_viscosity, line_problem

KEPT = 0.05  # how far a printed viscosity may lie from the law
CONFIDENCES = ("given", "high", "medium", "low")  # from sure to unsure; "given": by the user, who answers for it
GIVEN = Text("given")
NO_VALUES = ("name", "source", "printed", "viscosities")
BEYOND_ROWS = Text("rule of this program: beyond its rows the viscosity is that of the outermost line carried on")
VISCOSITIES = (2e-6, 0.1)  # m²/s: between them the lines of ASTM D341 and Walther hold
LAW_RANGE = Text("rule of this program: range of the viscosity law")
OTHER_OIL = Text("Another oil grade or temperature.")
MORE_ROWS = Text("Give rows of viscosity that reach so far, or another temperature.")
SPECIFIC_HEAT = Quantity("number", Text("Specific heat; the program takes one law for all oils"), "J/(kg·K)", "c_p")


@record
class JudgedValue:
    """One value of an oil, in the unit that it is shown in, with where it comes from and how far it can be trusted."""

    key: str
    label: Text
    symbol: str
    value: float | str
    unit: str
    confidence: Text
    source: Text


@record
class JudgedViscosity:
    """One printed viscosity beside the law.  `implied`: its kinematic viscosity; `grade`: the SAE grade of that, at 100
    °C only."""

    temperature: Celsius
    printed: PascalSecond
    law: PascalSecond
    implied: SquareMetrePerSecond
    grade: Text
    kept: bool
    reason: Text

    @property
    def deviation(self) -> Number:
        return self.printed / self.law - 1

    @property
    def verdict(self) -> Text:
        return Text("kept") if self.kept else Text("rejected")


# --- values


def judged_values(oil: Oil) -> tuple[JudgedValue, ...]:
    """Every value of an oil; what the oil does not have itself is that of its base stock."""
    return (*_own(oil), *_of_base(oil))


def _own(oil: Oil) -> Iterator[JudgedValue]:
    claims = {claim.key: claim for claim in oil.claims}
    for key, about in keys(Oil).items():
        value = getattr(oil, about.attribute)
        if key in NO_VALUES or value is None:
            continue
        default = Text("{source}, or left out: the program's usual value", source=oil.source)
        own_claim = Claim(key, value, GIVEN, Name(oil.source) if value != about.field.default else default)
        yield _judged(key, about.about, value, claims.get(key, own_claim))
    row = keys(ViscosityRow)[dotted(ViscosityRow.viscosity)].about
    for point in oil.viscosities:
        here = replace(row, label=Text("Dynamic viscosity at {T} °C", T=Amount(point.temperature, form="g")))
        claim = Claim("viscosities", point.viscosity, GIVEN, Name(oil.source))
        yield _judged(claim.key, here, point.viscosity, claim)
    if "specific_heat_J_kgK" in claims:
        claim = claims["specific_heat_J_kgK"]
        yield _judged(claim.key, SPECIFIC_HEAT, claim.value, claim)


def _of_base(oil: Oil) -> Iterator[JudgedValue]:
    base = base_stocks()[oil.base]
    claims = {claim.key: claim for claim in base.claims}
    replaced = {"limiting_shear": oil.limiting_shear, "k_mm2_N": oil.pressure_viscosity_40}
    for key, about in keys(BaseStock).items():
        if key in claims and replaced.get(key) is None:
            claim = claims[key]
            source = Text("base stock {name}: {source}", name=Text(base.name), source=claim.source)
            yield _judged(key, about.about, getattr(base, about.attribute), replace(claim, source=source))


def _judged(key: str, about: Quantity, value: float | str, claim: Claim) -> JudgedValue:
    shown = about.units.shown(value) if isinstance(value, float) else value
    name = symbol(about.symbol) if about.symbol else "base"
    return JudgedValue(key, Text(about.label), name, shown, about.unit, claim.confidence, claim.source)


def least_sure(oil: Oil) -> tuple[Text, tuple[str, ...]]:
    """The lowest confidence among the values of an oil, and the symbols of those that have it."""
    values = judged_values(oil)
    lowest = max((v.confidence for v in values), key=CONFIDENCES.index)
    return lowest, tuple(v.symbol for v in values if v.confidence == lowest)


def values_table(oil: Oil) -> Table:
    """Every value of an oil with its source and confidence."""
    rows = tuple((v.label, v.value, v.unit, v.confidence, v.source) for v in judged_values(oil))
    heads = Text("Value"), Text("Number"), Text("Unit"), Text("Confidence"), Text("Source")
    columns = tuple((head, "") for head in heads)
    return Table("oil", Text("Oil {name}: what is known of it", name=oil.name), columns, rows)


def rising_rows(oil: Oil) -> Text | None:
    """Where the viscosity rises with the temperature in an oil's own table; None where it falls throughout."""
    rises = [
        Text("from {T} to {warmer} °C", T=Amount(row.temperature, form="g"), warmer=Amount(other.temperature, form="g"))
        for row, other in zip(oil.viscosities, oil.viscosities[1:])
        if other.viscosity > row.viscosity
    ]
    parts = dict(oil=oil.name, where=COMMA.join(rises))
    note = Text(
        "The viscosity of {oil} rises {where}, though oil thins with heat: a misprint? It is taken as given.", **parts
    )
    return note if rises else None


# --- printed viscosities


def printed_at(oil: Oil, T: Celsius) -> PrintedViscosity | None:
    """What is printed for an oil at a temperature."""
    return next((printed for printed in oil.printed if abs(printed.temperature - T) < 1e-9), None)


def printed_viscosities(lubricant: Lubricant) -> tuple[JudgedViscosity, ...]:
    """Each printed viscosity of an oil with its verdict."""
    with untraced():  # a judgement on the source: no part of a step's calculation
        return tuple(_against_law(lubricant, printed) for printed in lubricant.oil.printed)


def _against_law(lubricant: Lubricant, printed: PrintedViscosity) -> JudgedViscosity:
    state = lubricant.at(printed.temperature)
    implied = implied_viscosity(mu=printed.viscosity, rho=state.rho)
    kept = abs(printed.viscosity / state.mu - 1) <= KEPT
    reason = EMPTY if kept else SEMICOLON.join(_reasons(lubricant, printed, implied))
    sae = grade(implied) if printed.temperature == 100 else EMPTY
    return JudgedViscosity(printed.temperature, printed.viscosity, state.mu, implied, sae, kept, reason)


def _reasons(lubricant: Lubricant, printed: PrintedViscosity, implied: SquareMetrePerSecond) -> Iterator[Text]:
    """Why a printed viscosity does not go with its oil, from the numbers alone."""
    oil, T = lubricant.oil, printed.temperature
    nu = lubricant.nu40 if T == 40 else lubricant.nu100 if T == 100 else lubricant.nu(T)
    implies = Text("implies {nu} mm²/s at {T} °C", nu=_mm2_s(implied), T=Amount(T, form="g"))
    if T == 100 and grade(implied) != grade(nu):
        grades_of = dict(grade=grade(implied), own=grade(nu))
        yield Text("{implies}, {grade}; the oil has {nu}, {own}", implies=implies, nu=_mm2_s(nu), **grades_of)
    else:
        parts = dict(implies=implies, times=Amount(implied / nu, digits=2), nu=_mm2_s(nu))
        yield (
            Text("{implies}, {times} times the {nu} that the oil has", **parts)
            if T in (40, 100)
            else Text("{implies}, {times} times the {nu} of its viscosity line", **parts)
        )
    wrong = next((o for o in oil.printed if (o.temperature - T) * (o.viscosity - printed.viscosity) > 0), None)
    if wrong is not None:
        there = dict(mu=_mPas(wrong.viscosity), T=Amount(wrong.temperature, form="g"))
        yield (
            Text("less than the {mu} printed for {T} °C, though oil thins with heat", **there)
            if printed.viscosity < wrong.viscosity
            else Text("more than the {mu} printed for {T} °C, though oil thins with heat", **there)
        )
    yield from _between(lubricant, printed)


def _between(lubricant: Lubricant, printed: PrintedViscosity) -> Iterator[Text]:
    """Whether a value agrees at least with those that are printed at 40 and 100 °C: the line through them."""
    oil = lubricant.oil
    ends = [end for end in (printed_at(oil, 40.0), printed_at(oil, 100.0)) if end is not None]
    if printed.temperature in (40, 100) or len(ends) < 2 or oil.nu40 is None:
        return
    nu40, nu100 = (implied_viscosity(mu=end.viscosity, rho=lubricant.at(end.temperature).rho) for end in ends)
    if not LOWEST / 2 < nu100 < nu40 or line_problem(nu40, nu100) is not None:
        return
    there = Lubricant(replace(oil, nu40=nu40, nu100=nu100), lubricant.law).at(printed.temperature).mu
    mu = _mPas(there)
    if abs(printed.viscosity / there - 1) <= KEPT:
        yield Text(
            "lies on the line through the values printed at 40 and 100 °C, which has {mu}, and shares their fault",
            mu=mu,
        )
    else:
        yield Text("not on the line through the values printed at 40 and 100 °C, which has {mu}, either", mu=mu)


def grade(nu: SquareMetrePerSecond) -> Text:
    """The SAE grade of a kinematic viscosity at 100 °C."""
    known = grades()
    if nu < known[0].from_:
        return Text("thinner than {grade}", grade=known[0].name)
    return next((Name(g.name) for g in known if nu < g.below), Text("thicker than {grade}", grade=known[-1].name))


MULTIGRADE = re.compile(r"\b(\d+)W-?(\d+)\b")
THICK_IN_WINTER = 15  # 15W and thicker


def high_shear(lubricant: Lubricant) -> PascalSecond | None:
    """The viscosity of an oil at 150 °C and 10⁶ 1/s: as given, else the least of the multigrade that its name says, or
    that its viscosity line is as flat as; None where it does not thin by shear, as far as is known."""
    oil = lubricant.oil
    if oil.hths is not None:
        return oil.hths
    by_name = MULTIGRADE.search(oil.name)
    if lubricant.constant or not (by_name or lubricant.polymer_thickened):
        return None
    hot = f"SAE {by_name[2]}" if by_name else grade(lubricant.nu100)
    row = next((row for row in grades() if row.name == hot), None)
    if row is None:
        return None
    return row.hths_thick if by_name and int(by_name[1]) >= THICK_IN_WINTER else row.hths


def _mm2_s(nu: SquareMetrePerSecond) -> Amount:
    return Amount(UNITS["mm²/s"].shown(nu))


def _mPas(mu: PascalSecond) -> Amount:
    return Amount(UNITS["mPa·s"].shown(mu), "mPa·s")


def printed_table(lubricant: Lubricant) -> Table | None:
    """The printed viscosities of an oil beside its law; None where there are none."""
    shown, percent, mm2_s = (UNITS[unit].shown for unit in ("mPa·s", "%", "mm²/s"))
    rows = []
    for v in printed_viscosities(lubricant):
        numbers = round(shown(v.law), 3), round(percent(v.deviation), 1), round(mm2_s(v.implied), 2)
        rows.append((v.temperature, shown(v.printed), *numbers, v.verdict, v.reason))
    if not rows:
        return None
    columns = (
        (Text("T"), "°C"),
        (Text("Printed"), "mPa·s"),
        (Text("Law"), "mPa·s"),
        (Text("Deviation"), "%"),
        (Text("Implied ν"), "mm²/s"),
        (Text("Verdict"), ""),
        (Text("Reason"), ""),
    )
    note = Text(
        "Kept: within {kept} % of the law through the oil's viscosities at 40 and 100 °C and its density.",
        kept=Amount(KEPT * 100),
    )
    title = Text("Oil {name}: viscosities printed elsewhere", name=lubricant.oil.name)
    return Table("oil_printed", title, columns, tuple(rows), note)


def errata(lubricant: Lubricant, T: Celsius, about: str, source: Text = EMPTY) -> tuple[Erratum, ...]:
    """What is printed for an oil at this temperature, where it is rejected; `about`: the value that is judged
    instead."""
    return tuple(
        Erratum(
            about,
            Text("Viscosity of the oil at {temperature} °C", temperature=Amount(v.temperature, form="g")),
            UNITS["mPa·s"].shown(v.printed),
            "mPa·s",
            source or Text("printed viscosity; {source}", source=lubricant.oil.source),
            Text("The printed value {reason}.", reason=v.reason),
        )
        for v in printed_viscosities(lubricant)
        if not v.kept and abs(v.temperature - T) < 1e-9
    )
