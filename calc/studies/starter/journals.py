# SPDX-License-Identifier: Apache-2.0
"""The bearings to begin with: shells by classes where the shaft is laid in, as makers build them; sizes, clearance and
oil of least friction, by the search for bearings.

A shaft that passes its seats has journals as large as it asks, in the housing itself."""

import math

import numpy as np

from ...bearings.inputs import BearingsInputs
from ...bearings.plain.seats.classes import Select
from ...bearings.plain.selection.grid import clearances, fields_over, lengths
from ...bearings.plain.selection.ranking import CandidateRow, Fields, best, by_power
from ...bearings.plain.selection.search import settle, slopes_of
from ...bearings.plain.selection.variants import STANDARD, SelectionCase, Variant, tasks
from ...bearings.plain.selection.writing import bearing_changes
from ...bearings.row import SupportRow
from ...countershaft.inputs import LAID_IN, ShaftInputs
from ...countershaft.result import CountershaftResult
from ...countershaft.rows import BearingRow
from ...design.addresses import as_list, as_table, own_shafts
from ...design.model import Design
from ...design.step_inputs import bearings_case
from ...design.toml_file import Document, design
from ...library.lubricant import Lubricant
from ...sheet.errors import NoSolution
from ...sheet.quantity import dotted, keys
from ...sheet.record import replace
from ...sheet.text import SEMICOLON, Text
from ...sheet.units import Metre, Number
from ...solve import Results, solve
from .train import HOUSING, passing_seat, tip
from .writing import BEARING_ROW, Rows, Section, changed, mm, parted, table, up
from .writing import head as headed

OILS = ("5W-40", "5W-30", "0W-20")  # what engines run on
BY_SEARCH = "of least friction, by the search for bearings"
FOUND = f"assumed: {BY_SEARCH}; its rules hold at every corner of the tolerances"
BEARINGS = Text("bearings to begin with")
THREADED: Metre = 0.2e-3

# --- shells

RATIO: Number = 0.75  # l/d, before the search
PRESSURE = 3.5e6  # Pa, before the search: about what journals of slow shafts carry that are found
PSI = (1.0e-3, 1.3e-3, 1.6e-3, 2.0e-3)  # the middle of the clearance over the diameter
WALL, THICK_WALL, THICK_FROM = 1.5e-3, 2.0e-3, 40e-3  # m: of a shell, and above which journal it is thicker
JOURNAL_CLASS, BORE_CLASS, BETWEEN = 6e-6, 8e-6, 1e-6  # m: two classes of each, as Kawasaki has them
BAND = 14e-6  # m, to both sides of the middle: ±11 µm of every pair, and how far the walls that are found may be off
LINING = "AlSn20Cu"
LIGHT, CLOSE, FAST = "EN AC-43100", 100e-3, 4000 / 60  # a small fast engine has a light block: pitch in m, rev/s


def estimated(load: float) -> Metre:
    """The diameter of a journal that is looked at first."""
    least = math.sqrt(load / (RATIO * PRESSURE))
    return float(next((d for d in STANDARD if d >= 1000 * least), STANDARD[-1])) / 1000


def estimated_length(d: Metre) -> Metre:
    return up(RATIO * d, 0.5e-3)


def wall_of(d: Metre) -> Metre:
    return WALL if d <= THICK_FROM else THICK_WALL


def select(d: Metre, psi: Number, where: str = "") -> Section:
    """Shells in three walls for two classes of journal and bore; `where` they lie, as it is said."""
    wall = wall_of(d)
    outer, middle = d + 2 * wall, round(psi * d * 1e6)
    rows: Rows = {
        Select.journal_classes_mm: (
            [[mm(d - 2 * JOURNAL_CLASS - BETWEEN), mm(d - JOURNAL_CLASS - BETWEEN)], [mm(d - JOURNAL_CLASS), mm(d)]],
            f"assumed: two classes of 6 µm{where}",
        ),
        Select.bore_classes_mm: (
            [
                [mm(outer), mm(outer + BORE_CLASS)],
                [mm(outer + BORE_CLASS + BETWEEN), mm(outer + 2 * BORE_CLASS + BETWEEN)],
            ],
            f"assumed: two classes of 8 µm; shells of {mm(wall):g} mm in three walls of 4 µm{where}",
        ),
        Select.clearance_band: (
            [middle - BAND * 1e6, middle + BAND * 1e6],
            f"assumed: ±11 µm of every pair, and what the walls leave{where}",
        ),
    }
    return headed(Design.bearings, BearingsInputs.select), rows


def housing_of(made: Design) -> tuple[str, str]:
    """The metal of the block: of the wheels, where it is known."""
    if made.gears is not None and made.gears.housing_material:
        return made.gears.housing_material, "as between the wheels"
    engine = made.engine
    if engine is None or not laid_in(made):
        return HOUSING, "assumed: expands like the shaft, so that the clearance stays when cold"
    pitch = engine.cylinder_pitch if engine.cylinder_pitch is not None else math.inf
    if pitch < CLOSE and engine.rated_speed > FAST:
        return LIGHT, "assumed: cylinders less than 100 mm apart and more than 4000 rpm"
    return HOUSING, "assumed: cylinders 100 mm apart or more, or up to 4000 rpm"


def laid_in(made: Design) -> bool:
    """Whether nothing of the shafts has to pass a seat."""
    return all(view.own is not None and view.own.assembly in LAID_IN for view in made.views.values())


def shared(made: Design, oil: str) -> list[Section]:
    """The table of what all bearings share, without their classes."""
    both: Rows = {
        BearingsInputs.oil: (oil, "assumed"),
        BearingsInputs.supply_temperature: (90.0, "assumed: gallery of a warm engine"),
        BearingsInputs.supply_pressure: (4.0, "assumed"),
        BearingsInputs.supply: ("hole", ""),
        BearingsInputs.hole_diameter: (4.0, "assumed"),
        BearingsInputs.housing_material: housing_of(made),
    }
    if laid_in(made):
        both[BearingsInputs.bush_material] = (LINING, "assumed: the lining of the shells")
    return [(headed(Design.bearings), both)]


SURFACES: Rows = {
    BearingRow.journal_roughness: (0.2, "assumed: ground and lapped"),
    BearingRow.housing_roughness: (0.4, "assumed: finely bored"),
}


def shell(d: Metre, l: Metre) -> Rows:
    """What a row needs beside its name and place."""
    return {
        BearingRow.diameter: (mm(d), "assumed: the thinnest that holds, the same for all bearings"),
        BearingRow.length: (mm(l), f"assumed: l/d of {RATIO:g}"),
        BearingRow.seat: ("shells", "assumed: two halves in the divided housing"),
        **SURFACES,
    }


# --- the bearings of one shaft


def bearings(document: Document, results: Results) -> list[Section]:
    """The tables of the bearings for the shaft of a design that has none, and what its rows have then.

    Raises NoSolution where no plain bearing carries it."""
    made, shaft = results.design, results.result(CountershaftResult)
    if made.countershaft is None or shaft is None or made.engine is None:
        raise NoSolution(BEARINGS, Text("the shaft that they carry is not known"), Text("give [[shafts]] first"))
    oils = oil_of(made, OILS)
    (header, both), *_ = shared(made, oils[0])
    of_all: Section = (header, both | {BearingsInputs.oil: (oils[0], FOUND if len(oils) > 1 else "that of the teeth")})
    if not laid_in(made):
        front, rear, length = threaded_sizes(made)
        return _found(document, results, [of_all, *_threaded(made, front, rear, length)], oils)
    d = estimated(max(shaft.loads.values()))
    for _ in range(2):
        searched: Rows = {BearingRow.diameter: (mm(d), FOUND), BearingRow.length: (mm(estimated_length(d)), FOUND)}
        rows: list[Section] = [
            (BEARING_ROW, {BearingRow.name: (row.name, "")} | shell(d, estimated_length(d)) | searched)
            for row in made.countershaft.bearings
        ]
        sections = _found(document, results, [of_all, select(d, PSI[1], f"; {BY_SEARCH}"), *rows], oils)
        found = design(with_bearings(document, sections)).rows[0].diameter
        if (found <= THICK_FROM) == (d <= THICK_FROM):
            break
        d = found  # with the wall of that size
    return sections


def _found(document: Document, results: Results, sections: list[Section], oils: tuple[str, ...]) -> list[Section]:
    """With the sizes, the clearance and the oil of least friction with which no limit fails, where any have nothing
    to be said of them at all of these."""
    begun = design(with_bearings(document, sections))
    own = begun.bearings
    assert own is not None
    case = bearings_case(begun, solve, solve(begun, results))
    slopes, able, tried = slopes_of(case), [], list[Text]()
    for n, oil in enumerate(oils):
        variant = Variant(oil, own.supply, Lubricant(own.in_bearings(begun.oils[oil]), own.viscosity_law))
        fields = _fields(case, variant)
        picked = best(fields, slopes, by_power) if all(fields.values()) else None
        if picked is not None:
            able.append((sum(pick.power for pick in picked), n, variant, fields))
    able.sort(key=lambda entry: entry[:2])
    for strict in (True, False):  # rather a caution than no bearings
        found: CandidateRow | None = None
        for power, _, variant, fields in able:
            if found is not None and power >= found.power:
                break  # what the whole design asks for more of costs more
            settled = settle(case, variant, fields, slopes, by_power, strict=strict)
            if settled is not None and settled.row is not None:
                found = settled.row if found is None or settled.row.power < found.power else found
            elif settled is not None:
                tried.append(settled.why)
        if found is not None:
            return changed(sections, bearing_changes(found, case), FOUND)
    raise NoSolution(BEARINGS, SEMICOLON.join(tried[:1]), Text("a stiffer shaft, a slower one, or rolling bearings"))


def _fields(case: SelectionCase, variant: Variant) -> Fields:
    """Of each bearing all lengths in its room; of shells by classes the usual clearances alone."""
    found = {}
    for place, some in tasks(case).items():
        grids = []
        for at in (task.with_oil(variant.lubricant, variant.supply) for task in some):
            l, g = lengths(at, in_room=True), clearances(at)
            if at.alike and g.size:
                usual = np.array([round(psi * at.size, 6) for psi in PSI])
                g = usual[usual >= g[0]]
            if l.size and g.size:
                grids.append((at, l, g))
        found[place] = fields_over(grids, variant)
    return found


def with_bearings(document: Document, sections: list[Section]) -> Document:
    """The document with the table of the bearings, and with what the rows of its shafts that are no twins have then:
    one section a row, front to rear, shaft by shaft."""
    rows, others = parted(sections)
    document = replace(document, data={**document.data, **table(others)})
    places = [
        (dotted(Design.shafts, n, ShaftInputs.bearings, i), as_table(before))
        for n, shaft in own_shafts(document.data).items()
        for i, before in enumerate(as_list(shaft.get(dotted(ShaftInputs.bearings))))
    ]
    for (place, before), (_, row) in zip(places, rows):
        said = {dotted(field): value for field, (value, _) in row.items() if dotted(field) != dotted(BearingRow.name)}
        if dotted(BearingRow.kind) in said:  # of another kind than the one before, of which nothing stays
            said = {key: None for key in before if key not in keys(SupportRow)} | said
        for key, value in said.items():
            document = document.with_value(dotted(place, key), value)
    return document


def oil_of(made: Design, oils: tuple[str, ...]) -> tuple[str, ...]:
    """The oil that a design has for its teeth, else what engines run on."""
    return oils if made.friction is None or made.friction.oil is None else (made.friction.oil,)


# --- journals that the shaft goes through

LONGEST: Number = 0.75  # l/d


def threaded_sizes(made: Design) -> tuple[Metre, Metre, Metre]:
    """Diameters of the front and the rear journal, and a length of both beside the sectors."""
    shaft = made.countershaft
    assert shaft is not None
    z = min(abs(shaft.bearing_positions[0]), abs(shaft.bearing_positions[-1]))
    if shaft.journals:
        (d_first, l_first), (d_last, l_last) = shaft.journals[0], shaft.journals[-1]
        return d_first, d_last, max(l_first, l_last)
    radii = [section.outer_radius for section in shaft.sections] or [2 * mass.radius for mass in shaft.masses]
    outer = shaft.outer_radius if shaft.outer_radius is not None else max(radii, default=0.0)
    ends = shaft.half_length
    if ends is None:
        ends = max((abs(mass.z) for mass in shaft.masses), default=0.0)
    rear = up(2 * (outer + (shaft.radial_clearance or THREADED)), 0.5e-3)
    if made.gears is not None:
        wheel = next(wheel for wheel in made.gears.wheels if wheel.name == made.gears.carrier())
        through = up(tip(wheel.teeth, made.gears.module, made.gears.helix_angle) + 1e-3, 0.5e-3)
    else:
        through = up(tip(*passing_seat(rear)) + 1e-3, 0.5e-3)
    front, room = min(through, rear), max(2 * (z - ends), 0.5e-3)
    return front, rear, min(up(LONGEST * front, 0.5e-3), room)


def _threaded(made: Design, front: Metre, rear: Metre, length: Metre) -> list[Section]:
    alike: Rows = {
        BearingRow.clearance_factor: (0.75, "assumed: usual 0.4 to 0.8; a fast journal wants the oil"),
        **SURFACES,
    }
    through = "assumed: that of the rear" if front == rear else "assumed: the gear goes through"
    in_front: Rows = {
        BearingRow.diameter: (mm(front), through),
        BearingRow.length: (mm(length), FOUND),
    }
    behind: Rows = {
        BearingRow.diameter: (mm(rear), "assumed: the sectors and their clearance go through"),
        BearingRow.length: (mm(length), FOUND),
    }
    return [
        (BEARING_ROW, {BearingRow.name: ("front", "")} | in_front | alike),
        (BEARING_ROW, {BearingRow.name: ("rear", "")} | behind | alike),
    ]
