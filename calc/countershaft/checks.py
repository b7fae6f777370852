# SPDX-License-Identifier: Apache-2.0
"""The checks of the counter-shaft: what it leaves, how it bends, whether it fits.  Those of its making stand with their
subjects, those of its outline where it is put together."""

import math
from collections.abc import Callable, Iterator, Mapping
from itertools import combinations

from ..gears.inputs import GearsInputs
from ..gears.layout.room import ASSEMBLY
from ..library import fatigue
from ..library.catalogue import WEAKEST_TENSILE, Material, proof_of
from ..library.journal_rules import HEAT_INDEX, SLOPE, SPECIFIC_LOAD
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.quantity import dotted
from ..sheet.record import record, replace
from ..sheet.remedy import Remedy, by_key, down
from ..sheet.text import EMPTY, SPACE, Amount, Name, Text
from ..sheet.units import Metre, Number
from .bending.shaft import Bending
from .inputs import ShaftInputs
from .insertion import way_in
from .outline import Journals, Outline, outer_face
from .result import CountershaftResult, SupportResult
from .rows import EACH_ROW, SHAFT, BearingRow, called, row_key
from .sizing.sectors import LEFT_OVER, ShaftTask
from .supports import Gear

# --- how it bends

STIFFNESS = (
    dotted(SHAFT, ShaftInputs.core_radius),
    dotted(EACH_ROW, BearingRow.position),
)
FILLET_RADIUS = (dotted(SHAFT, ShaftInputs.fillet_radius),)
FILLET_AND_CORE = (*FILLET_RADIUS, dotted(SHAFT, ShaftInputs.core_radius))
LARGER_CORE = Text("A larger core where the moment is largest, or a shorter span.")
LARGER_FILLET = Text("A larger fillet. {advice}", advice=LARGER_CORE)

JOURNAL_SLOPE = CheckRule(
    "countershaft.slope_B",
    "caution",
    "The journal stands on the edge of its seat; a target of one maker: the film at the edge is what judges it.",
    sense="<=",
    unit="mrad",
    source=Text("Finotti 2013, 4.6 (in chapter 6): target of the engine's maker"),
    advice=Text("A stiffer shaft between its bearings: a larger core, or a shorter span."),
    demand=True,
    cause="countershaft.slope",
    value_id=dotted("countershaft", CountershaftResult.slopes),
    moved_by=STIFFNESS,
    short=Text("slope"),
    decides=True,
)
FIRST_CRITICAL_SPEED = CheckRule(
    "countershaft.first_critical_speed",
    "limit",
    "A shaft that turns near its critical speed bends out.",
    Text("First natural frequency of bending, as a speed"),
    unit="rpm",
    source=Text(
        "dynamics: at 1/1.2 of its critical speed a shaft bends out 1/(1 − 1/1.44) = 3.3 times as far; highest speed "
        "of the engine"
    ),
    advice=Text("A stiffer or lighter shaft: larger core, shorter span."),
    role="physics",
    value_id=dotted("countershaft", CountershaftResult.first_critical_speed),
    moved_by=STIFFNESS,
    short=Text("critical speed"),
)
RIGID = CheckRule(
    "countershaft.rigid",
    "caution",
    "Nearer to its critical speed a shaft is not balanced as the rigid one that is computed.",
    Text("First natural frequency of bending, for a rigid shaft"),
    unit="rpm",
    source=Text(
        "rule of this program: up to two thirds of it the shaft counts as rigid, as its balance tolerance takes it"
    ),
    advice=FIRST_CRITICAL_SPEED.advice,
    cause=FIRST_CRITICAL_SPEED.id,
    value_id=FIRST_CRITICAL_SPEED.value_id,
    moved_by=STIFFNESS,
)
BENDING_STRESS = CheckRule(
    "countershaft.bending_stress",
    "limit",
    "The shaft yields.",
    Text("Largest bending stress, nominal"),
    "<=",
    "MPa",
    advice=LARGER_CORE,
    role="physics",
    demand=True,
    value_id=dotted("countershaft", Bending.bending_stress),
    moved_by=STIFFNESS,
    short=Text("stress"),
    proven=(),
)
NOTCH_STRESS = CheckRule(
    "countershaft.notch_stress",
    "caution",
    "The fillet yields locally where the section as a whole holds.",
    Text("Bending stress at the fillet of a shoulder"),
    "<=",
    "MPa",
    advice=LARGER_FILLET,
    demand=True,
    cause=BENDING_STRESS.id,
    value_id=dotted("countershaft", Bending.notch_stress),
    moved_by=FILLET_AND_CORE,
    proven=(),
)
FATIGUE = CheckRule(
    "countershaft.fatigue",
    "limit",
    "A crack at the fillet ends the shaft's life.",
    Text("Safety of the fillet against fatigue"),
    source=Text(
        "{fkm}: endless life, every run-up a cycle; weight and tooth force, which alternate, are left out",
        fkm=fatigue.FKM,
    ),
    advice=LARGER_FILLET,
    role="physics",
    demand=True,
    cause=BENDING_STRESS.id,
    short=Text("fatigue"),
    value_id=dotted("countershaft", Bending.fatigue_safety),
    moved_by=FILLET_AND_CORE,
    proven=(),
)
FATIGUE_RESERVE = CheckRule(
    "countershaft.fatigue_reserve",
    "caution",
    "The fillet, the notch and the constants are estimates, and strengths scatter.",
    Text("Safety of the fillet against fatigue, with a reserve"),
    source=Text("{fkm}: safety of 1.5 for what is estimated", fkm=fatigue.FKM),
    advice=LARGER_FILLET,
    demand=True,
    cause=BENDING_STRESS.id,
    value_id=FATIGUE.value_id,
    moved_by=FILLET_AND_CORE,
)
FEM_STRESS = CheckRule(
    "countershaft.fem_stress",
    "caution",
    "The shaft yields where its stress is largest, and may hold as a whole.",
    Text("Largest stress of the shaft, von Mises, by finite elements"),
    "<=",
    "MPa",
    advice=LARGER_FILLET,
    demand=True,
    moved_by=(dotted(SHAFT, ShaftInputs.fem_stress),),
)
FEM_FATIGUE = CheckRule(
    "countershaft.fem_fatigue",
    "limit",
    "A crack where the stress is largest ends the shaft's life.",
    Text("Safety against fatigue of the largest principal stress by finite elements"),
    source=Text("{fkm}: endless life, every run-up a cycle", fkm=fatigue.FKM),
    advice=LARGER_FILLET,
    role="physics",
    demand=True,
    value_id=dotted("countershaft", CountershaftResult.fem_safety),
    moved_by=(dotted(SHAFT, ShaftInputs.fem_principal_stress),),
)
FILLET = CheckRule(
    "countershaft.fillet",
    "method",
    "Outside its range the notch factor is an extrapolation.",
    Text("Height of the governing shoulder over its fillet radius"),
    "in",
    source=Text("range of the notch factor ({peterson})", peterson=fatigue.PETERSON),
    advice=Text("Outside it the notch stress is an extrapolation."),
    moved_by=FILLET_RADIUS,
    weakens=((FATIGUE, 1.5), (FATIGUE_RESERVE, 1.5)),
)
FILLET_ROOM = CheckRule(
    "countershaft.fillet_room",
    "caution",
    "The fillet as given can not be cut there, and a smaller one has more stress.",
    Text("Fillet radius in the gap between two shoulders"),
    "<=",
    "mm",
    Text("geometry: a fillet takes its radius of the length of the thinner piece"),
    Text("Or set the shoulders further apart."),
    zero="the fillet radius",
    moved_by=FILLET_RADIUS,
)
BENDS_OUT, RIGID_FROM = 1.2, 1.5  # first critical speed over the highest of the shaft
ENDLESS, RESERVE = 1.0, 1.5  # safety against fatigue

# --- whether it fits

ENVELOPE = CheckRule(
    "countershaft.envelope",
    "limit",
    "The shaft can not be threaded through its seats.",
    Text("Room around the sectors in the largest seat"),
    unit="mm",
    source=Text("Finotti 2013, 4.1: the shaft is threaded in through its seat"),
    advice=Text("A smaller outer radius takes longer or wider sectors; a larger journal helps as well."),
    role="chosen",
    exact=True,
    zero="outer radius",
    moved_by=(
        dotted(SHAFT, ShaftInputs.outer_radius),
        dotted(SHAFT, ShaftInputs.radial_clearance),
        dotted(EACH_ROW, BearingRow.diameter),
    ),
    short=Text("radius"),
)
GEAR_SEAT = CheckRule(
    "countershaft.gear_seat",
    "caution",
    "The gear does not pass the seat; it may be fixed after the shaft is inserted.",
    Text("Room around the gear's tip in the front seat"),
    ">",
    "mm",
    Text("Finotti 2013, 4.1: the gear goes through the front seat with the shaft"),
    Text("A larger front journal, fewer teeth or a smaller module."),
    zero="1 mm",
    cause=ASSEMBLY.id,
)
ENVELOPE_LENGTH = CheckRule(
    "countershaft.envelope_length",
    "limit",
    "The sectors run into the journals.",
    Text("Room between the sectors and the nearest journal"),
    unit="mm",
    source=Text("geometry: the sectors end where the journals begin"),
    advice=Text("Or set the bearings further apart."),
    role="chosen",
    exact=True,
    zero="length of the nearest bearing",
    moved_by=(
        dotted(SHAFT, ShaftInputs.half_length),
        dotted(EACH_ROW, BearingRow.position),
    ),
    short=Text("length"),
)
BETWEEN = CheckRule(
    "countershaft.between",
    "limit",
    "The sectors run into a bearing, or leave no room for the fillet beside it.",
    Text("Room between the sectors and a bearing"),
    unit="mm",
    source=Text("geometry: one fillet beside the journal, and half of gap_mm from its middle where that is given"),
    advice=Text("Shorter sectors."),
    role="chosen",
    exact=True,
    zero="length of the bearing",
    moved_by=(
        dotted(SHAFT, ShaftInputs.gap),
        dotted(SHAFT, ShaftInputs.masses),
        dotted(SHAFT, ShaftInputs.sections),
        dotted(EACH_ROW, BearingRow.length),
    ),
)
SHAFTS_CLEAR = CheckRule(
    "countershaft.shafts.clear",
    "limit",
    "Two shafts, or a shaft and the crank, run into each other.",
    Text("Distance of the axes of the shafts"),
    unit="mm",
    source=Text("geometry: what they sweep, and 2 mm between two shafts (rule of this program)"),
    advice=Text("Move an axis."),
    role="chosen",
)
OUTER = dotted(SHAFT, ShaftInputs.outer_radius)
APART = 2e-3  # m between what two shafts sweep; rule of this program
SUPPORT_SPECIFIC_LOAD = CheckRule(
    "countershaft.support.N.specific_load",
    "caution",
    "A screening of journals that are not part of [bearings], whose film is not known.",
    sense="<=",
    unit="MPa",
    source=Text("Finotti 2013, 3.2.3.1: the most that is accepted, with forced oil and cooling"),
    advice=Text("A longer journal, or a larger one."),
    demand=True,
    value_id=dotted("countershaft", "support", "N", SupportResult.specific_load),
    moved_by=(dotted(EACH_ROW, BearingRow.diameter), dotted(EACH_ROW, BearingRow.length)),
)
SUPPORT_HEAT_INDEX = CheckRule(
    "countershaft.support.N.heat_index",
    "caution",
    SUPPORT_SPECIFIC_LOAD.why,
    sense="<=",
    unit="N·rpm/mm",
    source=SUPPORT_SPECIFIC_LOAD.source,
    advice=SUPPORT_SPECIFIC_LOAD.advice,
    demand=True,
    cause=SUPPORT_SPECIFIC_LOAD.id,
    value_id=dotted("countershaft", "support", "N", SupportResult.heat_index),
    moved_by=SUPPORT_SPECIFIC_LOAD.moved_by,
)

# --- whether its sections are the shaft of its masses

SECTIONS = (dotted(SHAFT, ShaftInputs.sections),)
OUTLINE = CheckRule(
    "countershaft.outline",
    "limit",
    "Sections and masses describe two shafts: the one that is drawn does not give the couple.",
    Text("Couple of the given sections, off that of the masses"),
    "<=",
    "N·m",
    Text("rule of this program: within 5 %, else masses and sections are not of one shaft"),
    Text("Look at radii, half-angles, angles and places of the sections: the bending is that of the outline."),
    role="self",
    moved_by=SECTIONS,
)
OUTLINE_FORCE = CheckRule(
    "countershaft.outline_force",
    "limit",
    "Sections and masses describe two shafts: the one that is drawn does not give the force.",
    Text("Force of the given sections, off that of the masses"),
    "<=",
    "N",
    OUTLINE.source,
    OUTLINE.advice,
    role="self",
    cause=OUTLINE.id,
    moved_by=SECTIONS,
)


def checks(
    shaft: ShaftInputs, todo: ShaftTask, shaft_result: CountershaftResult, journals: Journals, gear: Gear | None
) -> Iterator[Check]:
    """All checks of the step but those of its bending and its making."""
    for n, (row, slope) in enumerate(shaft_result.slopes.items()):
        if n in (0, len(shaft.bearings) - 1):
            yield JOURNAL_SLOPE(slope, SLOPE, at=row, name=Text("Slope of the {row} journal", row=called(row)))
    if journals:
        yield from _envelope_checks(shaft, shaft_result, journals, gear)
        yield from _between_check(shaft, shaft_result, journals)
    yield from _support_checks(shaft_result)
    yield from _outline_checks(todo, shaft_result)


def _envelope_checks(
    shaft: ShaftInputs, shaft_result: CountershaftResult, journals: Journals, gear: Gear | None
) -> Iterator[Check]:
    """Whether sectors and gear can be threaded in, and the sectors end before the journals begin; also where they can
    not be drawn."""
    seats, clearance = shaft.bearing_positions, shaft.room_asked
    room = way_in(shaft, shaft_result.insertion_room_front, shaft_result.insertion_room_rear)
    if clearance is not None and room is not None:
        outline, R = shaft_result.outline, shaft.outer_radius
        parts = [p for p in outline.pieces if p.what in ("sector", "full")] if outline is not None else []
        wider = any(R is None or p.outer_radius > R for p in parts if not any(p.start < z < p.end for z in seats))
        smaller = None if R is None or wider else _no_longer(ShaftInputs.outer_radius, R + room - clearance)
        cartridge = shaft.assembly == "cartridge"
        name = Text("Room around the shaft in the bore of its carrier") if cartridge else None
        keys = (dotted(SHAFT, ShaftInputs.outer_radius), dotted(EACH_ROW, BearingRow.carrier_bore))
        moved_by = keys if cartridge else None
        scale = R if R is not None else max(d for d, _ in journals) / 2
        yield ENVELOPE(round(room, 9), clearance, scale=scale, remedies=smaller, name=name, moved_by=moved_by)
    if clearance is not None and gear is not None and shaft.passes_seats:
        row = shaft.bearings[0]
        keys = row_key(row.name, row.size_keys()[0]), dotted("gears", GearsInputs.normal_module)
        gap = (row.opening() - gear.tip_diameter) / 2
        if math.isfinite(gap):
            yield GEAR_SEAT(round(gap, 9), 0.0, scale=1e-3, moved_by=keys)
    if shaft.mode == "size" and shaft.half_length is not None:
        face, length = outer_face(seats, journals)
        shorter = _no_longer(ShaftInputs.half_length, face)
        yield ENVELOPE_LENGTH(round(face - shaft.half_length, 9), 0.0, scale=length, remedies=shorter)


def _between_check(shaft: ShaftInputs, shaft_result: CountershaftResult, journals: Journals) -> Iterator[Check]:
    """Whether the sectors keep away from the inner bearings, given ones from the outer ones too: of others
    `ENVELOPE_LENGTH` has the ends, or their places are no more than assumed.  A sector at a bearing is its journal,
    with a recess; rings of a rolling one may stand against it."""
    outline, supports = shaft_result.outline, list(zip(shaft.bearings, journals))
    if outline is not None:
        faces = [(p.start, p.end) for p in outline.pieces if p.half_angle is not None]
    else:
        sectors = shaft_result.sector.values() if shaft_result.sector is not None else ()
        faces = [(one.z - one.length / 2, one.z + one.length / 2) for one in sectors]
    gap, rooms = shaft.gap or 0.0, []
    for row, (_, l) in supports if outline is not None and not outline.derived else supports[1:-1]:
        ways = [a - row.position if a >= row.position else row.position - b for a, b in faces]
        inner, fillet = row not in (shaft.bearings[0], shaft.bearings[-1]), shaft.fillet_radius or 0.0
        needed = max(fillet if inner or row.kind == "plain" else 0.0, (gap - l) / 2 if inner else 0.0)
        rooms += [(way - l / 2, needed, l, row) for way, (a, b) in zip(ways, faces) if not a < row.position < b]
    if rooms:
        room, needed, length, row = min(rooms, key=lambda one: one[0] - one[1])
        name = Text("Room between the sectors and the {row} bearing", row=row.in_words)
        yield BETWEEN(round(room, 9), round(needed, 9), scale=length, name=name)


# --- whether several shafts and the crank turn clear of each other


@record
class InPlace:
    """A shaft beside the crank: its axis (real up, imaginary 90° further in the sense of crank rotation) and the radius
    that it sweeps, None where one is not known.  `placed_by`: the shaft whose mirror image it is, where that alone says
    where it stands."""

    axis: complex | None
    radius: Metre | None
    placed_by: str = ""


def swept(shaft: ShaftInputs, outline: Outline | None) -> Metre | None:
    """The radius that the sectors and journals of a shaft sweep, its wheel apart; None where it is not known."""
    radii = [] if shaft.outer_radius is None else [shaft.outer_radius]
    if outline is not None:
        radii = [piece.outer_radius for piece in outline.pieces if piece.half_angle is not None]
    return max(*radii, *(d / 2 for d, _ in shaft.journals), 0.0) if radii else None


def shafts_clear(shafts: Mapping[str, InPlace], crank_sweeps: Metre) -> Iterator[Check]:
    """Whether all shafts of a design, twins too, turn clear of each other and of what the crank sweeps at least: the
    pair that comes nearest.

    Not verified where a place or a radius is not known, and where a mirror image falls on its original, which has no
    side yet; of a single shaft nothing is asked then."""
    bodies = [(Name(name), one, dotted("shafts", name, ShaftInputs.axis)) for name, one in shafts.items()]
    crank = InPlace(0j, crank_sweeps)
    found: list[tuple[Metre, Metre, Text, tuple[str, ...]]] = []
    lacking: list[str] = []
    fallen: list[Text] = []
    for (name, one, key), (name_2, other, key_2) in combinations(
        [*bodies, (Text("the crank (at least its pins)"), crank, "")], 2
    ):
        lacking += [axis for axis, body in ((key, one), (key_2, other)) if body.axis is None]
        lacking += [OUTER for body in (one, other) if body.radius is None]
        if one.axis is None or other.axis is None or one.radius is None or other.radius is None:
            continue
        if one.axis == other.axis and key == dotted("shafts", other.placed_by, ShaftInputs.axis):
            lacking.append(key_2)
            fallen.append(Text("The mirror image falls on its original's axis: give {key} a side.", key=key))
            continue
        words = Text("Distance of the axes of {one} and {other}", one=name, other=name_2)
        needed = one.radius + other.radius + APART * (other is not crank)
        found.append((abs(one.axis - other.axis), needed, words, tuple(filter(None, (key, key_2)))))
    distance, needed, words, keys = min(found, key=lambda pair: pair[0] - pair[1], default=(0.0, 0.0, EMPTY, ()))
    if found and (distance < needed or not lacking):
        yield SHAFTS_CLEAR(distance, needed, name=words, moved_by=keys)
    elif len(shafts) > 1:
        missing = Missing(tuple(dict.fromkeys(lacking)), (), "holds", "none")
        yield SHAFTS_CLEAR(None, APART, missing=missing, advice=SPACE.join(fallen) if fallen else None)


def _no_longer(field: object, length: Metre) -> Callable[[], tuple[Remedy, ...]]:
    """A length of the shaft, cut down to this."""
    return by_key(ShaftInputs, dotted(SHAFT, field), down(length), bound="<=")


def _support_checks(shaft_result: CountershaftResult) -> Iterator[Check]:
    """Specific load and heat index of journals that are not part of [bearings]: a screening, without their film."""
    for name, support in shaft_result.support.items():
        for rule, label, number, limit in (
            (SUPPORT_SPECIFIC_LOAD, Text("Specific load"), support.specific_load, SPECIFIC_LOAD),
            (SUPPORT_HEAT_INDEX, Text("Heat index"), support.heat_index, HEAT_INDEX),
        ):
            if number is not None:
                yield rule(number, limit, at=name, name=Text("{label}, support {name}", label=label, name=name))


def _outline_checks(todo: ShaftTask, shaft_result: CountershaftResult) -> Iterator[Check]:
    """Given sections against given masses: both must describe one shaft."""
    couple, force = shaft_result.outline_couple_deviation, shaft_result.outline_force_deviation
    if couple is None or force is None:
        return
    yield OUTLINE(couple, LEFT_OVER * max(shaft_result.couple, todo.may_leave))
    yield OUTLINE_FORCE(force, LEFT_OVER * max(shaft_result.force, todo.one_force))


def bending_checks(bent: Bending, material: Material, fastest: Number) -> Iterator[Check]:
    """Stress and speed of the shaft; the slopes are judged with the journals.

    `fastest`: the highest speed of the engine over that at which the shaft is bent."""
    highest = fastest * bent.speed
    yield FIRST_CRITICAL_SPEED(bent.natural_frequency, BENDS_OUT * highest)
    yield RIGID(bent.natural_frequency, RIGID_FROM * highest)
    # the stresses are nominal: of the full sections, whatever their share in the stiffness
    proof, unknown = proof_of(material.proof_stress, bent.bending_stress)
    strength = Text("elasticity, proof stress of {name}", name=material.name)
    if unknown is None:
        source = Text("{source}; the stress stands still in the turning shaft", source=strength)
        yield BENDING_STRESS(bent.bending_stress, proof, source=source)
    else:
        source = Text(
            "rule of this program: as the weakest structural steels; the strength of {name} is not known",
            name=material.name,
        )
        yield BENDING_STRESS(bent.bending_stress, proof, source=source, advice=_give(material), missing=unknown)
    if unknown is None and bent.notch_stress is not None:
        source = Text("{source}: above it the fillet yields locally", source=strength)
        yield NOTCH_STRESS(bent.notch_stress, proof, source=source)
    if bent.bending_stress:
        yield from _fatigue_checks(bent, material)
    if bent.step_over_fillet is not None:
        yield FILLET(bent.step_over_fillet, fatigue.FIT)
    if bent.fillet is not None and bent.fillet_room is not None:
        smaller = _no_longer(ShaftInputs.fillet_radius, bent.fillet_room)
        yield FILLET_ROOM(bent.fillet, round(bent.fillet_room, 9), scale=bent.fillet, remedies=smaller)


def _fatigue_checks(bent: Bending, material: Material) -> Iterator[Check]:
    """Of a shaft that bends at all: not verified where strength, kind of metal or fillet are not given."""
    if bent.fatigue_safety is not None:
        yield FATIGUE(bent.fatigue_safety, ENDLESS)
        yield FATIGUE_RESERVE(bent.fatigue_safety, RESERVE)
        return
    lacking = {
        dotted("material", Material.tensile_strength): material.tensile_strength is None,
        dotted("material", Material.kind): str(material.kind) not in fatigue.KINDS,
    }
    keys = [key for key, lacks in lacking.items() if lacks]
    advice = _give(material) if keys else Text("Give the radius of the fillets.")
    missing = Missing(tuple(keys) or FILLET_RADIUS, (), "none", "none")
    yield FATIGUE(None, ENDLESS, advice=advice, missing=missing)


def fem_checks(shaft: ShaftInputs, material: Material, safety: Number | None) -> Iterator[Check]:
    """Stresses that finite elements found.  `safety`: against fatigue, of the weakest structural steel where the
    strength is not known; None of other metals then."""
    if shaft.fem_stress is not None:
        proof, unknown = proof_of(material.proof_stress, shaft.fem_stress)
        if unknown is not None and material.kind != "steel":
            unknown = replace(unknown, worst="none")  # how far iron goes nobody says
        source = Text("elasticity, proof stress of {name}", name=material.name)
        yield FEM_STRESS(shaft.fem_stress, proof, source=source, missing=unknown)
    if shaft.fem_principal_stress:
        missing = None
        if material.tensile_strength is None or safety is None:
            taken = Text("{R_m}, as the weakest structural steels", R_m=Amount(WEAKEST_TENSILE * 1e-6, "MPa"))
            bracket = ((), "none", "none") if safety is None else ((taken,), "holds", safety)
            missing = Missing((dotted("material", Material.tensile_strength),), *bracket)
        yield FEM_FATIGUE(safety, ENDLESS, missing=missing)


def _give(material: Material) -> Text:
    return Text("Give the strength of {name} among the materials of the design.", name=material.name)
