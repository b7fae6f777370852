# SPDX-License-Identifier: Apache-2.0
"""The bearings: journals that the shaft goes through, then lengths and clearances that hold at every corner, by the
search for bearings."""

from collections.abc import Mapping
from itertools import product

from ...bearings.selection.search import bearing_changes, nearest_row
from ...bearings.selection.variants import Variant
from ...countershaft.result import CountershaftResult
from ...design.model import Design
from ...design.toml_file import Document, design
from ...library.journal_rules import COOLED, LUBRICATIONS, N_RPM_MM
from ...library.lubricant import Lubricant
from ...sheet.check import THIN_MARGIN
from ...sheet.errors import NoSolution
from ...sheet.text import SEMICOLON, Amount, Text
from ...sheet.units import Metre, Newton
from ...solve import Results, solve
from ..bearings_case import bearings_case
from .shaft import BEARING, FILLET, HEAT_INDEX, THREADED
from .train import HOUSING, passing_seat, tip
from .writing import Section, changed, down, mm, table, up

OILS = ("5W-40", "5W-30", "0W-20")  # what engines run on, the thickest first
FITS: tuple[tuple[str, str] | None, ...] = (None, ("IT6", "IT6"))
FOUND = "assumed: by the search for bearings, so that every limit holds at the worst corner of the tolerances"
BEARINGS = Text("bearings to begin with")


class TooFast(NoSolution):
    """A plain journal of usual length carries off less heat than this load and speed make: a case for rolling
    bearings."""


def bearings(document: Document, results: Results) -> list[Section]:
    """The tables of the bearings for the shaft of a design that has none.  Raises NoSolution, TooFast where no plain
    bearing carries it."""
    made, shaft = results.design, results.result(CountershaftResult)
    if made.countershaft is None or shaft is None or made.engine is None:
        raise NoSolution(BEARINGS, Text("the shaft that they carry is not known"), Text("give [countershaft] first"))
    load = max(shaft.reaction_front, shaft.reaction_rear)
    front, rear, room = _sizes(made)
    length = _length(load, made, rear, room)
    narrowest = max(front, min(up(length / BEARING[1], 0.5e-3), rear))
    oils = _oils(made)
    base = document.with_value("countershaft.journals", None)  # the bearings have their sizes
    tried: list[Text] = []
    for fits, oil in [
        *product(FITS[:1], oils),
        *product(FITS[1:], reversed(oils)),
    ]:  # closer fits with the oil that came nearest first
        for front in dict.fromkeys((narrowest, rear)):
            sections = changed(_sections(made, front, rear, length), {"bearings.oil": oil}, "assumed")
            begun = design(Document({**base.data, **table(sections)}))
            own = begun.bearings
            assert own is not None
            only = [Variant(oil, own.supply, Lubricant(own.in_bearings(begun.oils[oil]), own.viscosity_law), fits)]
            try:
                settled = nearest_row(bearings_case(begun, solve(begun, results)), only=only)
            except NoSolution as none:
                tried.append(none.text)
                break  # a wider journal is no cooler
            if (
                settled.row is not None
                and settled.results is not None
                and settled.results.outcomes["bearings"].verdict == "pass"
            ):
                return changed(sections, bearing_changes(settled.row, own), FOUND)
    raise NoSolution(BEARINGS, SEMICOLON.join(tried[:1]), Text("a stiffer shaft, a slower one, or rolling bearings"))


def _oils(made: Design) -> tuple[str, ...]:
    """The oil that the design has for its teeth, else those that engines run on."""
    given = made.friction.oil if made.friction is not None else None
    return (given,) if given is not None else OILS


def _sizes(made: Design) -> tuple[Metre, Metre, Metre]:
    """Diameters of the front and the rear journal, and the longest journal beside the sectors."""
    shaft = made.countershaft
    assert shaft is not None
    z = min(abs(shaft.bearing_positions[0]), abs(shaft.bearing_positions[-1]))
    if shaft.journals:
        one, other = shaft.journals[0], shaft.journals[-1]
        return one.diameter, other.diameter, max(one.length, other.length)
    radii = [section.outer_radius for section in shaft.sections] or [2 * mass.radius for mass in shaft.masses]
    outer = shaft.outer_radius if shaft.outer_radius is not None else max(radii, default=0.0)
    ends = (
        shaft.half_length if shaft.half_length is not None else max((abs(mass.z) for mass in shaft.masses), default=0.0)
    )
    rear = up(2 * (outer + (shaft.radial_clearance or THREADED)), 0.5e-3)
    if made.gears is not None:
        wheel = next(wheel for wheel in made.gears.wheels if wheel.name == made.gears.meshes[-1].driven)
        through = up(tip(wheel.teeth, made.gears.module, made.gears.helix_angle) + 1e-3, 0.5e-3)
    else:
        through = up(tip(*passing_seat(rear)) + 1e-3, 0.5e-3)
    return min(through, rear), rear, max(2 * (z - ends - 2 * FILLET), 0.0)


def _length(load: Newton, made: Design, rear: Metre, room: Metre) -> Metre:
    """As long as the heat index asks, within the usual ratio to the diameter and the room."""
    assert made.engine is not None
    heat = load * made.engine.rated_speed
    most = down(min(BEARING[1] * rear, room), 0.5e-3)
    length = min(up(max(heat / HEAT_INDEX, BEARING[0] * rear), 0.5e-3), most)
    limit = LUBRICATIONS[COOLED].limit * (1 - THIN_MARGIN)
    if length <= 0 or heat / length > limit:
        tried = Text(
            "{load} at {speed} on {length} of journal: a heat index of {index}",
            load=Amount(load, "N"),
            speed=Amount(made.engine.rated_speed * 60, "rpm"),
            length=Amount(length * 1e3, "mm"),
            index=Amount(heat / length / N_RPM_MM if length > 0 else float("inf"), "N·rpm/mm"),
        )
        raise TooFast(BEARINGS, tried, Text("rolling bearings"))
    return length


def _sections(made: Design, front: Metre, rear: Metre, length: Metre) -> list[Section]:
    why = f"assumed: l/d of at least {BEARING[0]:g} at the rear, and a heat index up to 400 000 N·rpm/mm"
    surfaces: Mapping[str, tuple[object, str]] = {
        "journal_roughness_um": (0.2, "assumed: ground and lapped"),
        "housing_roughness_um": (0.4, "assumed: finely bored"),
    }
    through = f"assumed: 1 mm above the gear's tip, or l/d of {BEARING[1]:g}"
    clearance = ("clearance_factor", (0.75, "assumed: usual 0.4 to 0.8; a fast journal wants the oil"))
    return [
        (
            "[bearings]",
            {
                "oil": (OILS[0], "assumed"),
                "supply_temperature_C": (90.0, "assumed: gallery of a warm engine"),
                "supply_pressure_bar": (4.0, "assumed"),
                "supply": ("hole", ""),
                "hole_diameter_mm": (5.0, "assumed"),
                "housing_material": _housing(made),
            },
        ),
        (
            "[bearings.front]",
            {
                "diameter_mm": (mm(front), "assumed: that of the rear" if front == rear else through),
                "length_mm": (mm(length), "assumed: that of the rear bearing"),
                clearance[0]: clearance[1],
                **surfaces,
            },
        ),
        (
            "[bearings.rear]",
            {
                "diameter_mm": (mm(rear), "assumed: the sectors and their clearance go through"),
                "length_mm": (mm(length), why),
                clearance[0]: clearance[1],
                **surfaces,
            },
        ),
    ]


def _housing(made: Design) -> tuple[str, str]:
    own = made.gears.housing_material if made.gears is not None else None
    return (
        (own, "as between the wheels")
        if own
        else (HOUSING, "assumed: expands like the shaft, so that the clearance stays when cold")
    )
