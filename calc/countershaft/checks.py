# SPDX-License-Identifier: Apache-2.0
"""The checks of the counter-shaft: what it leaves, how it bends, whether it fits.  Those of its making stand with their
subjects."""

from collections.abc import Callable, Iterator

from ..library import fatigue
from ..library.catalogue import Material
from ..library.journal_rules import HEAT_INDEX, SLOPE, SPECIFIC_LOAD
from ..sheet.check import Check
from ..sheet.functions import argument, degrees
from ..sheet.quantity import dotted
from ..sheet.remedy import Remedy, by_key, down
from ..sheet.shim_check import check
from ..sheet.text import SPACE, Amount, Text
from ..sheet.units import Metre
from .bending.shaft import RIGID, Bending
from .inputs import CountershaftInputs
from .outline import Journals
from .result import CountershaftResult
from .sizing.sectors import LEFT_OVER, WORDS, ShaftTask
from .supports import Gear

WEAKEST = 235e6  # Pa: proof stress of the weakest structural steel


def checks(
    shaft: CountershaftInputs, todo: ShaftTask, shaft_result: CountershaftResult, journals: Journals, gear: Gear | None
) -> Iterator[Check]:
    """All checks of the step but those of its bending and its making."""
    yield from _residual_checks(shaft, todo, shaft_result)
    for place, slope in (("front", shaft_result.slope_front), ("rear", shaft_result.slope_rear)):
        if slope is not None:
            name = Text("Slope of the {place} journal", place=Text(place))
            source = Text("Finotti 2013, 4.6 (in chapter 6): target of the engine's maker")
            advice = Text("A stiffer shaft between its bearings: a larger core, or a shorter span.")
            yield check(f"countershaft.slope_{place}", name, slope, "<=", SLOPE, "mrad", source, advice)
    if journals:
        yield from _envelope_checks(shaft, shaft_result, journals, gear)
    yield from _support_checks(shaft_result)
    yield from _outline_checks(todo, shaft_result)


def _residual_checks(shaft: CountershaftInputs, todo: ShaftTask, shaft_result: CountershaftResult) -> Iterator[Check]:
    """The couple and the force of the shaft's order that are left over."""
    each = Text("each of both shafts ") if shaft.pair == "yes" else Text("the shaft ")
    aim_couple = Text(
        "Aim at {couple} N·m at {direction}: the couple of {each}grows with mass, radius and arm.",
        couple=Amount(todo.couple, form=".1f"),
        direction=_opposite(todo.C),
        each=each,
    )
    aim_force = Text(
        "Aim at {f} N at {direction}: the force of {each}grows with mass and radius.",
        f=Amount(abs(todo.F), form=".0f"),
        direction=_opposite(todo.F),
        each=each,
    )
    alike = Text("Balance the masses against each other (mass times radius), so that only a couple remains.")
    force = todo.force_may_be_left
    for key, word, limit, before, unit, source, advice in (
        (
            "residual",
            Text("couple"),
            todo.may_leave,
            abs(todo.C) + abs(todo.C_against),
            "N·m",
            Text("rule of this program: 5 % of the couple to be balanced, or of m·r·ω²·a where there is none"),
            aim_couple,
        ),
        (
            "residual_force",
            Text("force"),
            force,
            abs(todo.F) + abs(todo.F_against),
            "N",
            Text("rule of this program: 5 % of m·r·ω² of one cylinder"),
            aim_force if abs(todo.F) > force else alike,
        ),
    ):
        left = getattr(shaft_result, f"residual_order_{todo.order}_{word}") or 0.0
        if shaft.pair != "yes" and str(word) in todo.out_of_reach:
            against = abs(todo.C_against if key == "residual" else todo.F_against)
            beyond = _beyond(shaft, Amount(against, unit, form=".4g"))
            advice = advice + SPACE + beyond if left - against > limit else beyond
        # shafts at twice crank speed are for comfort and often take a part only; they fail where they make it worse
        kind = "limit" if todo.order == 1 or left > max(before, limit) else "advice"
        yield check(
            f"countershaft.{key}",
            Text("{words}-order {word} left over", words=WORDS[todo.order], word=word),
            left,
            "<=",
            limit,
            unit,
            source,
            advice,
            kind=kind,
            value_id=f"countershaft.residual_order_{todo.order}_{word}",
        )


def _beyond(shaft: CountershaftInputs, against: Amount) -> Text:
    """What takes the part that turns against the shaft."""
    if shaft.speed_ratio == -1:
        return Text(
            "{against} turn against the shaft, and no mass on it takes them: that is for the counterweights of the "
            "crank (see the imbalance).",
            against=against,
        )
    return Text(
        "{against} turn against the shaft, and no mass on it takes them: a mirrored second shaft does (pair).",
        against=against,
    )


def _opposite(engine: complex) -> Amount:
    """The direction opposite to the engine's vector, in degrees."""
    return Amount(degrees(argument(-engine)), "°", form=".1f")


def _envelope_checks(
    shaft: CountershaftInputs, shaft_result: CountershaftResult, journals: Journals, gear: Gear | None
) -> Iterator[Check]:
    """Whether sectors and gear can be threaded in, and the sectors end before the journals begin; also where they can
    not be drawn."""
    seats, outline = shaft.bearing_positions, shaft_result.outline
    parts = [p for p in outline.pieces if p.what in ("sector", "full")] if outline is not None else []
    # those at a bearing are journals
    radii = [p.outer_radius for p in parts if not any(p.start < z < p.end for z in seats)]
    R = max(radii, default=shaft.outer_radius)
    clearance = shaft.radial_clearance if shaft.radial_clearance is not None else 0.0 if shaft.mode == "size" else None
    if clearance is not None and R is not None:
        room = max(d for d, _ in journals) / 2 - R
        smaller = _no_longer(CountershaftInputs.outer_radius, R + room - clearance) if R == shaft.outer_radius else None
        name, room = Text("Room around the sectors in the largest seat"), round(room, 9)
        source = Text("Finotti 2013, 4.1: the shaft is threaded in through its seat")
        advice = Text("A smaller outer radius takes longer or wider sectors; a larger journal helps as well.")
        yield check("countershaft.envelope", name, room, ">=", clearance, "mm", source, advice, remedies=smaller)
    if clearance is not None and gear is not None:
        name, room = Text("Room around the gear's tip in the front seat"), (journals[0][0] - gear.tip_diameter) / 2
        source = Text("Finotti 2013, 4.1: the gear goes through the front seat with the shaft")
        advice = Text("A larger front journal, fewer teeth or a smaller module.")
        yield check("countershaft.gear_seat", name, round(room, 9), ">", 0.0, "mm", source, advice)
    if shaft.mode == "size" and shaft.half_length is not None:
        face = min(abs(z) - l / 2 for z, (_, l) in zip(seats, journals))
        name, room = Text("Room between the sectors and the nearest journal"), round(face - shaft.half_length, 9)
        source = Text("geometry: the sectors end where the journals begin")
        advice, shorter = Text("Or set the bearings further apart."), _no_longer(CountershaftInputs.half_length, face)
        yield check("countershaft.envelope_length", name, room, ">=", 0.0, "mm", source, advice, remedies=shorter)


def _no_longer(field: object, length: Metre) -> Callable[[], tuple[Remedy, ...]]:
    """A length of the shaft, cut down to this."""
    return by_key(CountershaftInputs, dotted("countershaft", field), down(length), bound="<=")


def _support_checks(shaft_result: CountershaftResult) -> Iterator[Check]:
    """Specific load and heat index of journals that are not part of [bearings]: a screening, without their film."""
    for name, support in shaft_result.support.items():
        for what, label, number, limit, unit in (
            ("specific_load", Text("Specific load"), support.specific_load, SPECIFIC_LOAD, "MPa"),
            ("heat_index", Text("Heat index"), support.heat_index, HEAT_INDEX, "N·rpm/mm"),
        ):
            if number is not None:
                label = Text("{label}, support {name}", label=label, name=name)
                source = Text("Finotti 2013, 3.2.3.1: the most that is accepted, with forced oil and cooling")
                advice = Text("A longer journal, or a larger one.")
                yield check(f"countershaft.support.{name}.{what}", label, number, "<=", limit, unit, source, advice)


def _outline_checks(todo: ShaftTask, shaft_result: CountershaftResult) -> Iterator[Check]:
    """Given sections against given masses: both must describe one shaft."""
    couple, force = shaft_result.outline_couple_deviation, shaft_result.outline_force_deviation
    if couple is None or force is None:
        return
    source = Text("rule of this program: within 5 %, else masses and sections are not of one shaft")
    advice = Text("Look at radii, half-angles, angles and places of the sections: the bending is that of the outline.")
    name, most = Text("Couple of the given sections, off that of the masses"), max(shaft_result.couple, todo.may_leave)
    yield check("countershaft.outline", name, couple, "<=", LEFT_OVER * most, "N·m", source, advice)
    name, most = Text("Force of the given sections, off that of the masses"), max(shaft_result.force, todo.one_force)
    yield check("countershaft.outline_force", name, force, "<=", LEFT_OVER * most, "N", source, advice)


def bending_checks(bent: Bending, material: Material) -> Iterator[Check]:
    """Stress and speed of the shaft; the slopes are judged with the journals."""
    name, rigid = Text("First natural frequency of bending, as a speed"), RIGID * bent.speed
    source = Text(
        "rule of this program: up to two thirds of it the shaft counts as rigid, as its balance tolerance takes it"
    )
    advice = Text("A stiffer or lighter shaft: larger core, shorter span.")
    yield check("countershaft.first_critical_speed", name, bent.natural_frequency, ">=", rigid, "rpm", source, advice)
    # the stresses are nominal: of the full sections, whatever their share in the stiffness
    proof, strength = material.proof_stress, Text("elasticity, proof stress of {name}", name=material.name)
    advice = Text("A larger core where the moment is largest, or a shorter span.")
    name, stress = Text("Largest bending stress, nominal"), bent.bending_stress
    if proof is not None:
        source = Text("{source}; the stress stands still in the turning shaft", source=strength)
        yield check("countershaft.bending_stress", name, stress, "<=", proof, "MPa", source, advice)
    elif material.kind == "steel":  # below the weakest any steel bears it, above it depends
        yield check(
            "countershaft.bending_stress",
            name,
            stress,
            "<=",
            WEAKEST,
            "MPa",
            Text(
                "rule of this program: as the weakest structural steels; the strength of {name} is not known",
                name=material.name,
            ),
            Text("Give the strength of {name} as a [[material]] of the design.", name=material.name),
            kind="caution",
            missing=() if stress <= WEAKEST else (dotted("material", Material.proof_stress),),
        )
    larger = Text("A larger fillet. {advice}", advice=advice)
    if proof is not None and bent.notch_stress is not None:
        name = Text("Bending stress at the fillet of a shoulder")
        source = Text("{source}: above it the fillet yields locally", source=strength)
        yield check("countershaft.notch_stress", name, bent.notch_stress, "<=", proof, "MPa", source, larger)
    if bent.fatigue_safety is not None and (bears := fatigue.strength(material)) is not None:
        name = Text("Safety of the fillet against fatigue")
        source = Text(
            "{fkm}: endless life, every run-up a cycle; weight and tooth force, which alternate, are left out",
            fkm=fatigue.FKM,
        )
        yield check("countershaft.fatigue", name, bent.fatigue_safety, ">=", bears.safety, "", source, larger)
    if bent.step_over_fillet is not None:
        name = Text("Height of the governing shoulder over its fillet radius")
        source = Text("range of the notch factor ({peterson})", peterson=fatigue.PETERSON)
        advice = Text("Outside it the notch stress is an extrapolation.")
        yield check("countershaft.fillet", name, bent.step_over_fillet, "in", fatigue.FIT, "", source, advice)
    if bent.fillet is not None and bent.fillet_room is not None:
        name, room = Text("Fillet radius in the gap between two shoulders"), round(bent.fillet_room, 9)
        source = Text("geometry: a fillet takes its radius of the length of the thinner piece")
        advice = Text("Or set the shoulders further apart.")
        smaller = _no_longer(CountershaftInputs.fillet_radius, bent.fillet_room)
        yield check("countershaft.fillet_room", name, bent.fillet, "<=", room, "mm", source, advice, remedies=smaller)
