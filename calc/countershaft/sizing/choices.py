# SPDX-License-Identifier: Apache-2.0
"""Counter-shafts to choose from: in the envelope of the design, over outer radius and material, the lightest first."""

import math
from collections.abc import Mapping

from ...bearings.inputs import BearingsInputs
from ...library.catalogue import Material
from ...imbalance.result import ImbalanceResult
from ...sheet.changes import Changes, digits
from ...sheet.errors import BadInput, InputError, NoSolution
from ...sheet.progress import Progress, tell
from ...sheet.record import record
from ...sheet.step import Table
from ...sheet.text import SEMICOLON, Amount, Name, Text
from ...sheet.trace import untraced
from ...sheet.units import Euro, Metre, PhasorKilogramMetre, PhasorKilogramMetre2, RadPerSecond
from ..formulas import asked_product, asked_unbalance, shaft_speed
from ..inputs import THREADED, CountershaftInputs
from ..task import task
from .alternatives import named
from .cost_formulas import first_year
from .formulas import radius_needed
from .sectors import Sized, TooSmall, size

RADII = 9  # of each material; rule of this program
STEP = 1e-4  # m, to which the radii between the two ends are rounded up: a tenth of a millimetre


@record
class Envelope:
    """Where the sectors may be, and in words what of it was derived."""

    outer_radius: Metre
    core_radius: Metre
    half_length: Metre
    derived: tuple[Text, ...]


@record
class Choice:
    """One shaft to choose: the cost is None where it is not known."""

    material: str
    sized: Sized
    first_year_cost: Euro | None


@record
class Choices:
    """The shafts, the lightest first, and the materials that do not fit, with the reason."""

    shafts: tuple[Choice, ...]
    refused: dict[str, NoSolution]


def envelope(shaft: CountershaftInputs, bearings: BearingsInputs | None, place: str) -> Envelope:
    """The envelope of a design; what it leaves out is taken from the journals.  Raises BadInput with the keys to give."""
    errors: list[InputError] = []
    derived: list[Text] = []
    if shaft.journals:
        journals = [(j.diameter, j.length) for j in shaft.journals]
    else:
        journals = [(b.diameter, b.length) for b in (bearings.front, bearings.rear)] if bearings is not None else []
    if len(journals) != len(shaft.bearing_positions):
        journals = []

    def missing(name: str, what: Text) -> float:
        errors.append(InputError(0, f"countershaft.{name}_mm", "", Text("needed: {what}", what=what)))
        return math.nan

    R, z_max, r_0 = shaft.outer_radius, shaft.half_length, shaft.core_radius
    if R is None and journals:
        clearance = shaft.radial_clearance if shaft.radial_clearance is not None else THREADED
        R = round(max(d for d, _ in journals) / 2 - clearance, 9)
        why = Text("outer radius {R}: the largest journal's, less {clearance} for threading in", R=_mm(R), clearance=_mm(clearance))
        derived.append(why)
    elif R is None:
        R = missing("outer_radius", Text("the envelope's radius; without journals to thread the shaft through it can not be derived"))
    if z_max is None and journals:
        fillets = 2 * (shaft.fillet_radius or 0.0)  # one at the journal, one at the sector
        z_max = round(min(abs(z) - l / 2 for z, (_, l) in zip(shaft.bearing_positions, journals)) - fillets, 9)
        if z_max <= 0:
            what = Text("a journal stands at mid-shaft, so that it can not be derived; give that of the outer faces")
            z_max = missing("half_length", what)
        else:
            up_to = Text("half-length {z}: up to the inner face of the journal nearest to mid-shaft", z=_mm(z_max))
            derived.append(Text("{up_to}, less two fillets of {fillet}", up_to=up_to, fillet=_mm(fillets / 2)) if fillets else up_to)
    elif z_max is None:
        z_max = missing("half_length", Text("where the outer faces of the sectors stand; without journals it can not be derived"))
    if r_0 is None:
        what = Text("the radius of the shaft that carries the sectors; `contralbero set FILE countershaft.core_radius_mm=15`")
        r_0 = missing("core_radius", what)
    elif R is not None and r_0 >= R:
        reason = Text("must be smaller than the outer radius, {R}", R=_mm(R))
        errors.append(InputError(0, "countershaft.core_radius_mm", f"{r_0 * 1e3:g}", reason))
    if errors:
        raise BadInput(place, errors)
    return Envelope(R, r_0, z_max, tuple(derived))


def _mm(length: Metre) -> Amount:
    return Amount(length * 1e3, "mm", form="g")


def candidates(shaft: CountershaftInputs, materials: Mapping[str, Material], place: str) -> dict[str, tuple[Material, Euro | None]]:
    """The design's material and those to compare it with, each with the cost of its first year where it is known."""
    costs: dict[str, Euro] = {}
    if shaft.cost is not None:
        N = float(shaft.cost.pieces_per_year)
        with untraced():
            costs = {a.material: first_year(K_T=a.tooling, K_D=a.development, N=N, c=a.piece) for a in shaft.cost.alternatives}
    names = named(shaft, materials)
    unknown = [name for name in names if name not in materials]
    if unknown:
        reason = Text("is not in the table of materials; add it as [[material]]")
        raise BadInput(place, [InputError(0, "countershaft.cost.alternatives", n, reason) for n in unknown])
    return {name: (materials[name], costs.get(name)) for name in names}


def asked(
    shaft: CountershaftInputs, imbalance: ImbalanceResult, omega: RadPerSecond
) -> tuple[PhasorKilogramMetre, PhasorKilogramMetre2, RadPerSecond]:
    """Unbalance and unbalance times position that the whole shaft needs, and the speed at which it turns."""
    todo = task(shaft, imbalance)
    omega_S = shaft_speed(i=shaft.speed_ratio, omega=omega)
    U = asked_unbalance(F_like=todo.F, x_o=shaft.overdesign, omega=omega_S)
    return U, asked_product(C_like=todo.C, x_o=shaft.overdesign, omega=omega_S), omega_S


def choices(shaft: CountershaftInputs, imbalance: ImbalanceResult, omega: RadPerSecond, room: Envelope,
    materials: Mapping[str, tuple[Material, Euro | None]], progress: Progress | None = None) -> Choices:  # fmt: skip
    """Shafts of every material from the smallest radius that serves to that of the envelope, the lightest first.

    Raises NoSolution where no material fits: that of the densest one, which comes nearest.
    """
    shafts: list[Choice] = []
    refused: dict[str, NoSolution] = {}
    with untraced():
        U, P, omega_S = asked(shaft, imbalance, omega)
        for n, (name, (material, cost)) in enumerate(materials.items()):
            tell(progress, n / len(materials), Name(name))
            try:
                largest = size(U, P, omega_S, material.density, room.outer_radius, room.core_radius, room.half_length, shaft.extras)
            except NoSolution as none:
                refused[name] = none
                continue
            shafts.append(Choice(name, largest, cost))
            for R in _radii(radius_needed(R=room.outer_radius, r_0=room.core_radius, u=largest.utilisation), room.outer_radius):
                try:
                    one = size(U, P, omega_S, material.density, R, room.core_radius, room.half_length, shaft.extras)
                except TooSmall:  # the last digit of the smallest radius
                    continue
                shafts.append(Choice(name, one, cost))
    if not shafts:
        raise max(refused.items(), key=lambda one: materials[one[0]][0].density)[1]
    return Choices(tuple(sorted(shafts, key=lambda c: (c.sized.mass, c.sized.outer_radius))), refused)


def _radii(smallest: Metre, largest: Metre) -> list[Metre]:
    """Radii below the largest, the smallest first, on whole tenths of a millimetre."""
    spread = (smallest + (largest - smallest) * i / (RADII - 1) for i in range(RADII - 1))
    tenths = dict.fromkeys(round(math.ceil(R / STEP - 1e-9) * STEP, 9) for R in spread)
    return [R for R in tenths if R < largest - STEP / 2]


def choices_table(listed: Choices, top: int, room: Envelope) -> Table:
    """The first `top` of them.  Of unequal sectors front and rear stand beside each other."""
    mm, kg, degree = 1e-3, 1.0, math.pi / 180
    equal = all(math.isclose(c.sized.front.mass, c.sized.rear.mass, rel_tol=1e-9) for c in listed.shafts)
    priced = any(c.first_year_cost is not None for c in listed.shafts)
    parts = ((Text("half-angle"), "half_angle", "°", degree), (Text("length"), "length", "mm", mm), (Text("mass"), "mass", "kg", kg),
        (Text("centre of gravity"), "radius", "mm", mm))  # fmt: skip
    sides = ((Text("of each"), "front"),) if equal else ((Text("front"), "front"), (Text("rear"), "rear"))
    columns = [(Text("no."), ""), (Text("material"), ""), (Text("outer radius"), "mm")]
    columns += [(Text("{label} {side}", label=label, side=word), unit) for word, _ in sides for label, _, unit, _ in parts]
    columns += [(Text("eccentric masses"), "kg"), (Text("utilisation"), "")] + ([(Text("first year"), "k€")] if priced else [])
    rows = []
    for number, choice in enumerate(listed.shafts[:top], 1):
        sized = choice.sized
        cells = [getattr(getattr(sized, side), name) / factor for _, side in sides for _, name, _, factor in parts]
        rows.append(
            (str(number), choice.material, sized.outer_radius / mm, *cells, sized.mass, sized.utilisation)
            + ((None if choice.first_year_cost is None else choice.first_year_cost / 1e3,) if priced else ())
        )
    note = Text("Core radius {core}, outer faces up to ±{half_length}; half-angles to 90°. The least mass of each radius.",
        core=_mm(room.core_radius), half_length=_mm(room.half_length))  # fmt: skip
    if room.derived:
        note += Text(" Derived: {derived}.", derived=SEMICOLON.join(room.derived))
    for name, none in listed.refused.items():
        note += Text(" {material} does not fit: {why}.", material=name, why=none.advice)
    return Table("countershafts", Text("Counter-shafts in the envelope, the lightest first"), tuple(columns), tuple(rows), note)


def changes(choice: Choice, room: Envelope) -> Changes:
    """The keys that make a design one of these shafts."""
    lengths = (("outer_radius", choice.sized.outer_radius), ("core_radius", room.core_radius), ("half_length", room.half_length))
    return {
        "countershaft.mode": "size", "countershaft.material": choice.material,
        **{f"countershaft.{name}_mm": digits(x * 1e3) for name, x in lengths},
    }  # fmt: skip
