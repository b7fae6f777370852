# SPDX-License-Identifier: Apache-2.0
"""Counter-shafts to choose from, in the envelope of the design: other materials, other radii, the lightest first."""

import math
import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ...imbalance.result import ImbalanceResult
from ...library.catalogue import Material
from ...library.journal_rules import specific_load
from ...sheet.errors import BadInput, InputError, NoSolution
from ...sheet.progress import Progress, tell
from ...sheet.quantity import dotted, result, value
from ...sheet.record import record
from ...sheet.remedy import Changes, digits
from ...sheet.shown import Shown
from ...sheet.step import Curve, Series, Table, axis_label
from ...sheet.text import SEMICOLON, Amount, Name, Text
from ...sheet.units import (
    Euro,
    Kilogram,
    KilogramPerMetre3,
    Metre,
    Newton,
    Number,
    Pascal,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    RadPerSecond,
)
from ...sheet.value import about, untraced
from ..formulas import shaft_speed
from ..inputs import THREADED, Extra, ShaftInputs
from ..making.inputs import Alternative, Cost
from ..outline import outer_face
from ..sums import SystemShaft
from . import formulas as f
from .formulas import first_year, radius_needed
from .sectors import Sized, TooSmall, remainder, task
from .shares import asked_share, share_of
from .stretches import Gaps, SizedStretches, inner_gaps, least_masses, size_between

if TYPE_CHECKING:
    pass


# --- the design's material beside others
# What they make of the sectors, of the wall beside the seat, and of the cost.


@record
class Seat:
    """The shaft's largest journal, which the sectors pass."""

    diameter: Metre
    length: Metre
    load: Newton


@result
class MaterialResult(Shown):
    """One material; what depends on a size or a cost that is not known is left out."""

    density: KilogramPerMetre3 | None = value("Density", "kg/m³", "ρ'", default=None)
    outer_radius: Metre | None = value(
        "Outer radius of the sectors, same length and half-angle", "mm", "R'", default=None
    )
    bore_growth: Metre | None = value("Growth of the seat's bore", "mm", "ΔD", default=None)
    eccentric_mass: Kilogram | None = value("Eccentric masses together", "kg", "Σm'", default=None)
    wall_left: Metre | None = value("Wall left beside the seat", "mm", "w'", default=None)
    journal: Metre | None = value("Largest journal", "mm", "d'", default=None)
    specific_load: Pascal | None = value("its specific load", "MPa", "p'", default=None)
    shaft_mass: Kilogram | None = value("Mass of the whole shaft", "kg", "m_S'", default=None)
    mass_difference: Kilogram | None = value("Whole shaft against the design's own", "g", "Δm", default=None)
    first_year_cost: Euro | None = value("Cost of the first year", "€", "K_1", default=None)
    break_even: Number | None = value(
        "Pieces at which it costs as much as the design's material", "", "N_e", default=None
    )
    bearable_development: Euro | None = value(
        "Development at which it costs as much in the first year", "€", "K_D,e", default=None
    )
    name: str


def compared(
    shaft: ShaftInputs,
    materials: Mapping[str, Material],
    R: Metre | None,
    r_0: Metre | None,
    eccentric_mass: Kilogram,
    shaft_mass: Kilogram | None = None,
    seat: Seat | None = None,
) -> dict[str, MaterialResult]:
    """The design's own material first, then the others to compare; keys are fit for the names of values.

    `R` and `r_0`: of the design's sectors, None where they are not known; `eccentric_mass`: both together;
    `shaft_mass`: the whole shaft, `seat`: its largest journal, where they are known."""
    costs = {a.material: a for a in shaft.cost.alternatives} if shaft.cost is not None else {}
    own, own_cost = materials[shaft.of_sectors], costs.get(shaft.of_sectors)
    results = {}
    for name in named(shaft, materials):
        with about(Text("material {material}", material=name)):
            sized = _size(shaft, own, materials.get(name), R, r_0, eccentric_mass)
            sized |= _whole(sized, own, eccentric_mass, shaft_mass, seat)
            results[key(name)] = MaterialResult(name=name, **sized, **_cost(shaft, costs.get(name), own_cost))
    return results


def named(shaft: ShaftInputs, materials: Mapping[str, Material]) -> tuple[str, ...]:
    """The materials of the sectors to compare: the design's own, and those of [shafts.cost]; where it is sized without
    one, the ADI grades."""
    if shaft.cost is not None:
        others = [a.material for a in shaft.cost.alternatives]
    else:
        others = [name for name in materials if name.startswith("ADI")] if shaft.mode == "size" else []
    return (shaft.of_sectors, *(name for name in others if name != shaft.of_sectors))


def key(name: str) -> str:
    """A material's name as part of the name of a value: "ADI 800" → "ADI-800"."""
    return re.sub(r"[^A-Za-z0-9]+", "-", name).strip("-")


def _size(
    shaft: ShaftInputs,
    material: Material,
    other: Material | None,
    R: Metre | None,
    r_0: Metre | None,
    mass: Kilogram,
) -> dict[str, float]:
    if other is None:
        return {}
    sizes = {"density": other.density}
    if R is None or r_0 is None:
        return sizes
    wall = shaft.support.wall if shaft.support is not None else None
    if other.name == material.name:
        sizes |= {"outer_radius": R, "bore_growth": 0.0, "eccentric_mass": mass}
        return sizes if wall is None else sizes | {"wall_left": wall}
    R_m = f.radius_for(R=R, r_0=r_0, rho=material.density, rho_m=other.density)
    sizes |= {"outer_radius": R_m, "bore_growth": f.bore_growth(R_m=R_m, R=R)}
    sizes["eccentric_mass"] = f.mass_for(m=mass, rho=material.density, rho_m=other.density, R=R, R_m=R_m, r_0=r_0)
    return sizes if wall is None else sizes | {"wall_left": f.wall_left(w=wall, R_m=R_m, R=R)}


def _whole(
    sized: dict[str, float], material: Material, mass: Kilogram, shaft_mass: Kilogram | None, seat: Seat | None
) -> dict[str, float]:
    """The journal that grows with its seat, and the mass of the whole shaft; the rest of it keeps its shape."""
    if seat is None or "bore_growth" not in sized:
        return {}
    d = f.grown(d=seat.diameter, dD=sized["bore_growth"])
    whole = {"journal": d, "specific_load": specific_load(F=seat.load, d=d, l=seat.length)}
    if shaft_mass is not None:
        m = f.whole_mass(
            m_new=sized["eccentric_mass"],
            m_S=shaft_mass,
            m=mass,
            rho_m=sized["density"],
            rho=material.density,
            d_m=d,
            d=seat.diameter,
            l=seat.length,
        )
        whole |= {"shaft_mass": m, "mass_difference": f.mass_difference(m_new=m, m_S=shaft_mass)}
    return whole


def _cost(shaft: ShaftInputs, alternative: Alternative | None, own_cost: Alternative | None) -> dict[str, float]:
    if shaft.cost is None or alternative is None:
        return {}
    N = shaft.cost.pieces_per_year
    year = f.first_year(K_T=alternative.tooling, K_D=alternative.development, N=N, c=alternative.piece)
    costs = {"first_year_cost": year}
    if own_cost is None or alternative.material == own_cost.material:
        return costs
    theirs = f.first_year(K_T=own_cost.tooling, K_D=own_cost.development, N=N, c=own_cost.piece)
    costs["bearable_development"] = f.bearable_development(K_1=theirs, K_1a=year, K_Da=alternative.development)
    first, other = own_cost.tooling + own_cost.development, alternative.tooling + alternative.development
    if (own_cost.piece - alternative.piece) * (other - first) > 0:  # else the same one is the cheaper at any volume
        K, K_a = (f.before_first_piece(K_T=x.tooling, K_D=x.development) for x in (own_cost, alternative))
        costs["break_even"] = f.break_even(K=K, K_a=K_a, c=own_cost.piece, c_a=alternative.piece)
    return costs


COLUMNS = (
    (Text("density"), "density", "kg/m³"),
    (Text("outer radius"), "outer_radius", "mm"),
    (Text("bore larger by"), "bore_growth", "mm"),
    (Text("eccentric masses"), "eccentric_mass", "kg"),
    (Text("wall left"), "wall_left", "mm"),
    (Text("largest journal"), "journal", "mm"),
    (Text("its specific load"), "specific_load", "MPa"),
    (Text("whole shaft"), "shaft_mass", "kg"),
    (Text("against the design"), "mass_difference", "g"),
    (Text("first year"), "first_year_cost", "k€"),
    (Text("same cost at pieces"), "break_even", ""),
    (Text("development it bears"), "bearable_development", "k€"),
)


def compared_table(shaft: ShaftInputs, results: Mapping[str, MaterialResult], what: Text) -> Table:
    """The materials beside each other; columns that nothing is known of are left out.  `what`: that they all give, the
    couple or the force."""
    rows = list(results.values())
    whole = any(row.shaft_mass is not None for row in rows)  # which says more than the sectors alone
    shown = [
        c
        for c in COLUMNS
        if not (whole and c[1] in ("bore_growth", "eccentric_mass"))
        and any(getattr(row, c[1]) is not None for row in rows)
    ]
    units = [{"mm": 1e-3, "k€": 1e3, "MPa": 1e6, "g": 1e-3}.get(unit, 1.0) for _, _, unit in shown]
    cells = tuple(
        (
            row.name,
            *(
                None if getattr(row, c[1]) is None else float(getattr(row, c[1])) / unit
                for c, unit in zip(shown, units)
            ),
        )
        for row in rows
    )
    note = Text(
        "The same {what} from sectors of the same length and half-angle, so that a lighter material needs a larger "
        "radius.",
        what=what,
    )
    if whole:
        note += Text(" The largest journal grows with them, the rest of the shaft keeps its shape.")
    if shaft.support is not None and shaft.support.wall is not None:
        note += Text(" The wall should keep {wall}.", wall=Amount(shaft.support.least_wall * 1e3, "mm", form="g"))
    if shaft.cost is not None:
        note += Text(
            " First year: tooling, development and {n} pieces; the comparison is with {material}.",
            n=shaft.cost.pieces_per_year,
            material=shaft.of_sectors,
        )
    columns = ((Text("material"), ""), *((label, unit) for label, _, unit in shown))
    return Table(
        "materials", Text("The shaft in other materials"), columns, cells, note, covers=("countershaft.alternative.",)
    )


# --- shafts over outer radius and material

RADII = 9  # of each material; rule of this program
STEP = 1e-4  # m, to which the radii between the two ends are rounded up: a tenth of a millimetre


@record
class Envelope:
    """Where the sectors of a shaft may be, and in words what of it was derived."""

    outer_radius: Metre
    core_radius: Metre
    half_length: Metre
    derived: tuple[Text, ...]
    shaft: str
    gaps: Gaps = ()  # at its inner bearings
    material_key: object = ShaftInputs.material  # of the sectors


@record
class Choice:
    """One shaft to choose: the cost is None where it is not known."""

    material: str
    sized: Sized | SizedStretches
    first_year_cost: Euro | None


@record
class Choices:
    """The shafts, the lightest first, and the materials that do not fit, with the reason."""

    shafts: tuple[Choice, ...]
    refused: dict[str, NoSolution]


def envelope(shaft: ShaftInputs, place: str) -> Envelope:
    """The envelope of a design; what it leaves out is taken from the journals.  Raises BadInput with the keys to
    give."""
    errors: list[InputError] = []
    derived: list[Text] = []
    journals = shaft.journals

    def missing(field: object, what: Text) -> float:
        errors.append(InputError(0, dotted("shafts", shaft.name, field), "", Text("needed: {what}", what=what)))
        return math.nan

    R, z_max, r_0 = shaft.outer_radius, shaft.half_length, shaft.core_radius
    if R is None and journals and shaft.seat is not None:
        clearance = shaft.radial_clearance if shaft.radial_clearance is not None else THREADED
        R = round(shaft.seat / 2 - clearance, 9)
        why = Text(
            "outer radius {R}: the largest journal's, less {clearance} for threading in",
            R=_mm(R),
            clearance=_mm(clearance),
        )
        derived.append(why)
    elif R is None:
        R = missing(
            ShaftInputs.outer_radius,
            Text("the envelope's radius; without journals to thread the shaft through it can not be derived"),
        )
    if z_max is None and journals:
        fillets = 2 * (shaft.fillet_radius or 0.0)  # one at the journal, one at the sector
        z_max = round(outer_face(shaft.bearing_positions, journals)[0] - fillets, 9)
        if z_max <= 0:
            what = Text("a journal stands at mid-shaft, so that it can not be derived; give that of the outer faces")
            z_max = missing(ShaftInputs.half_length, what)
        else:
            up_to = Text("half-length {z}: up to the inner face of the journal nearest to mid-shaft", z=_mm(z_max))
            derived.append(
                Text("{up_to}, less two fillets of {fillet}", up_to=up_to, fillet=_mm(fillets / 2))
                if fillets
                else up_to
            )
    elif z_max is None:
        z_max = missing(
            ShaftInputs.half_length,
            Text("where the outer faces of the sectors stand; without journals it can not be derived"),
        )
    if r_0 is None:
        r_0 = missing(ShaftInputs.core_radius, Text("the radius of the shaft that carries the sectors, 15 mm say"))
    elif R is not None and r_0 >= R:
        reason = Text("must be smaller than the outer radius, {R}", R=_mm(R))
        errors.append(InputError(0, dotted("shafts", shaft.name, ShaftInputs.core_radius), f"{r_0 * 1e3:g}", reason))
    if errors:
        raise BadInput(place, errors)
    with untraced():
        gaps = inner_gaps(shaft)
    of_sectors = ShaftInputs.material if shaft.sector_material is None else ShaftInputs.sector_material
    return Envelope(R, r_0, z_max, tuple(derived), shaft.name, gaps, of_sectors)


def _mm(length: Metre) -> Amount:
    return Amount(length * 1e3, "mm", form="g")


def candidates(
    shaft: ShaftInputs, materials: Mapping[str, Material], place: str
) -> dict[str, tuple[Material, Euro | None]]:
    """The design's material and those to compare it with, each with the cost of its first year where it is known."""
    costs: dict[str, Euro] = {}
    if shaft.cost is not None:
        N = float(shaft.cost.pieces_per_year)
        with untraced():
            costs = {
                a.material: first_year(K_T=a.tooling, K_D=a.development, N=N, c=a.piece)
                for a in shaft.cost.alternatives
            }
    names = named(shaft, materials)
    unknown = [name for name in names if name not in materials]
    if unknown:
        reason = Text("is not in the table of materials; add it as [[material]]")
        alternatives = dotted("shafts", shaft.name, ShaftInputs.cost, Cost.alternatives)
        raise BadInput(place, [InputError(0, alternatives, n, reason) for n in unknown])
    return {name: (materials[name], costs.get(name)) for name in names}


def asked(
    shaft: ShaftInputs,
    imbalance: ImbalanceResult,
    omega: RadPerSecond,
    alike: int = 1,
    beside: Sequence[SystemShaft] = (),
) -> tuple[PhasorKilogramMetre, PhasorKilogramMetre2, RadPerSecond]:
    """Unbalance and unbalance times position that the whole shaft needs, and the speed at which it turns; `alike`:
    how many shafts of its ratio are sized, of which each has its share of what given ones `beside` them leave."""
    todo = task(shaft.speed_ratio, imbalance, beside)
    omega_S = shaft_speed(i=shaft.speed_ratio, omega=omega)
    return *asked_share((todo.F, todo.C), omega_S, shaft.overdesign, share_of(shaft, alike)), omega_S


def choices(
    shaft: ShaftInputs,
    imbalance: ImbalanceResult,
    omega: RadPerSecond,
    room: Envelope,
    materials: Mapping[str, tuple[Material, Euro | None]],
    progress: Progress | None = None,
    alike: int = 1,
    beside: Sequence[SystemShaft] = (),
) -> Choices:
    """Shafts of every material from the smallest radius that serves to that of the envelope, the lightest first.

    Raises NoSolution where no material fits: that of the densest one, which comes nearest.
    """
    shafts: list[Choice] = []
    refused: dict[str, NoSolution] = {}
    with untraced():
        U, P, omega_S = asked(shaft, imbalance, omega, alike, beside)

        def sized(rho: KilogramPerMetre3, R: Metre) -> Sized | SizedStretches:
            return size_between(U, P, omega_S, rho, R, room.core_radius, room.half_length, room.gaps, shaft.extras)

        for n, (name, (material, cost)) in enumerate(materials.items()):
            tell(progress, n / len(materials), Name(name))
            try:
                largest = sized(material.density, room.outer_radius)
            except NoSolution as none:
                refused[name] = none
                continue
            shafts.append(Choice(name, largest, cost))
            for R in _radii(
                radius_needed(R=room.outer_radius, r_0=room.core_radius, u=largest.utilisation), room.outer_radius
            ):
                try:
                    shafts.append(Choice(name, sized(material.density, R), cost))
                except TooSmall:  # the last digit of the smallest radius
                    continue
    if not shafts:
        raise max(refused.items(), key=lambda refusal: materials[refusal[0]][0].density)[1]
    return Choices(tuple(sorted(shafts, key=lambda c: (c.sized.mass, c.sized.outer_radius))), refused)


def _radii(smallest: Metre, largest: Metre) -> list[Metre]:
    """Radii below the largest, the smallest first, on whole tenths of a millimetre."""
    spread = (smallest + (largest - smallest) * i / (RADII - 1) for i in range(RADII - 1))
    tenths = dict.fromkeys(round(math.ceil(R / STEP - 1e-9) * STEP, 9) for R in spread)
    return [R for R in tenths if R < largest - STEP / 2]


def choices_table(listed: Choices, top: int, room: Envelope) -> Table:
    """The first `top` of them.  Of unequal sectors front and rear stand beside each other; of those between inner
    bearings how many there are, and the largest of each size."""
    mm, kg, degree = 1e-3, 1.0, math.pi / 180
    priced = any(c.first_year_cost is not None for c in listed.shafts)
    parts = (
        (Text("half-angle"), "half_angle", "°", degree),
        (Text("length"), "length", "mm", mm),
        (Text("mass"), "mass", "kg", kg),
        (Text("centre of gravity"), "radius", "mm", mm),
    )
    columns = [(Text("no."), ""), (Text("material"), ""), (Text("outer radius"), "mm")]
    if room.gaps:
        sides = [Text("of the largest")]
        columns.append((Text("sectors"), ""))
    else:
        two = [list(c.sized.by_name.values()) for c in listed.shafts]
        equal = all(math.isclose(front.mass, rear.mass, rel_tol=1e-9) for front, rear in two)
        sides = [Text("of each")] if equal else [Text("front"), Text("rear")]
    columns += [(Text("{label} {side}", label=label, side=word), unit) for word in sides for label, _, unit, _ in parts]
    columns += [(Text("eccentric masses"), "kg"), (Text("utilisation"), "")] + (
        [(Text("first year"), "k€")] if priced else []
    )
    rows = []
    for number, choice in enumerate(listed.shafts[:top], 1):
        sectors = list(choice.sized.by_name.values())
        shown = [max(sectors, key=lambda one: one.mass)] if room.gaps else sectors[: len(sides)]
        cells = [getattr(one, name) / factor for one in shown for _, name, _, factor in parts]
        rows.append(
            (str(number), choice.material, choice.sized.outer_radius / mm)
            + ((len(sectors),) if room.gaps else ())
            + (*cells, choice.sized.mass, choice.sized.utilisation)
            + ((None if choice.first_year_cost is None else choice.first_year_cost / 1e3,) if priced else ())
        )
    note = Text(
        "Core radius {core}, outer faces up to ±{half_length}; half-angles to 90°. The least mass of each radius.",
        core=_mm(room.core_radius),
        half_length=_mm(room.half_length),
    )
    if room.derived:
        note += Text(" Derived: {derived}.", derived=SEMICOLON.join(room.derived))
    for name, none in listed.refused.items():
        note += Text(" {material} does not fit: {why}.", material=name, why=none.advice)
    return Table(
        "countershafts", Text("Counter-shafts in the envelope, the lightest first"), tuple(columns), tuple(rows), note
    )


def changes(choice: Choice, room: Envelope) -> Changes:
    """The keys that make a design one of these shafts."""
    written: dict[object, object] = {
        ShaftInputs.mode: "size",
        room.material_key: choice.material,
        ShaftInputs.outer_radius: digits(choice.sized.outer_radius * 1e3),
        ShaftInputs.core_radius: digits(room.core_radius * 1e3),
        ShaftInputs.half_length: digits(room.half_length * 1e3),
    }
    return {dotted("shafts", room.shaft, field): value for field, value in written.items()}


# --- the least mass of the sectors against their outer radius, a line a material
# It shows what a larger seat saves.

POINTS = 25  # of a front


def front_curve(
    U: PhasorKilogramMetre,
    P: PhasorKilogramMetre2,
    omega: float,
    R: Metre,
    r_0: Metre,
    z_max: Metre,
    densities: Mapping[str, float],
    extras: tuple[Extra, ...] = (),
    gaps: Gaps = (),
) -> Curve | None:
    """Least mass of the sectors against their outer radius, from the smallest that serves to that of the envelope; a
    line a material.

    `U`, `P`: asked of the whole shaft.  None where no material fits into the envelope; one that does not has no line.
    """
    names = sorted(densities, key=lambda name: -densities[name])
    heavy = densities[names[0]]
    with untraced():
        left = remainder(U, P, extras)
        try:
            u = size_between(*left, omega, heavy, R, r_0, z_max, gaps).utilisation
        except TooSmall:
            return None
        start = radius_needed(R=R, r_0=r_0, u=u) * (1 + 1e-9)
        ends = [f.radius_for(R=R, r_0=r_0, rho=densities[name], rho_m=heavy) for name in names]
        radii = np.unique([*np.linspace(start, R, POINTS), *(end for end in ends if start < end < R)])
        least = least_masses(*left, heavy, radii, r_0, z_max, gaps)
        series = {}
        for name in names:  # equal ρ·(R³ − r_0³): equal lengths and half-angles
            R_m = f.radius_for(R=radii, r_0=r_0, rho=heavy, rho_m=densities[name])
            m = f.mass_for(m=least, rho=heavy, rho_m=densities[name], R=radii, R_m=R_m, r_0=r_0)
            fits = R_m <= R * (1 + 1e-9)
            if fits.sum() > 1:
                series[name] = Series(Name(name), R_m[fits] * 1e3, m[fits])
    lines = tuple(series[name] for name in densities if name in series)
    return Curve(
        "mass_over_radius",
        Text("Eccentric mass against outer radius"),
        axis_label("outer radius", "mm"),
        axis_label("eccentric masses", "kg"),
        lines,
    )
