# SPDX-License-Identifier: Apache-2.0
"""The nomenclature at the end: every symbol of a chapter with its meaning, unit and first page.

Symbols are noted as they are set, in formulas, tables of values and inputs; nothing is listed by hand."""

from __future__ import annotations

import re
from collections.abc import Mapping
from itertools import takewhile
from math import isclose
from typing import TYPE_CHECKING, Any

import numpy as np

from calc.design.addresses import quantities, quantity_of, step_at, value_at
from calc.sheet.errors import BadInput
from calc.sheet.expression import of_few_numbers, result, symbol, symbol_of
from calc.sheet.formula import units
from calc.sheet.quantity import Quantity
from calc.sheet.text import Text
from calc.sheet.value import Line, leaves, link_of

from ..typesetting.boxes import BETWEEN, Symbol, text
from ..typesetting.fonts import WIDTH
from ..typesetting.pagination import Block, heading, paragraph
from ..typesetting.prose import GROUP, NOTE, lines, run
from ..typesetting.tables import GUTTER
from ..typesetting.typeset import symbol as set_symbol

if TYPE_CHECKING:
    from ..context import Context
    from ..typesetting.pen import Pen


# --- what a formula gives, in words, where its source says no more than where it is from
# By the name of its function.

BY_NAME: dict[str, Text] = {
    "angular_speed": Text("Angular speed"), "attitude": Text("Attitude angle"),
    "attitude_angle": Text("Attitude angle"),
    "attitude_slope": Text("Change of the attitude angle with the eccentricity"), "base_pitch": Text("Transverse base "
                                                                                                     "pitch"),
    "bearings": Text("Bearings of all wheels"), "bearings_on_wheel": Text("Bearings of a wheel"),
    "benedict_kelley": Text("Coefficient of friction by Benedict and Kelley"),
    "brake_mean_pressure": Text("Brake mean effective pressure"), "by_length_ratio": Text("Value between two length "
                                                                                          "ratios"),
    "c_xx": Text("Damping of the film, along the load"), "c_xy": Text("Damping of the film, coupled"),
    "c_yy": Text("Damping of the film, across the load"), "churning": Text("Churning of all wheels"),
    "churning_on_wheel": Text("Churning of a wheel"), "coefficient_C": Text("Coefficient of the approximation"),
    "coefficient_E": Text("Coefficient of the approximation"),
    "coefficient_F": Text("Coefficient of the approximation"),
    "coefficient_G": Text("Coefficient of the approximation"),
    "coefficient_H": Text("Coefficient of the approximation"),
    "contact_length": Text("Length of the contact lines"), "couple": Text("Length of the couple"),
    "couple_direction": Text("Direction of the couple"), "couple_length": Text("Length of the couple"),
    "couple_per_degree": Text("Change of the couple over one degree"), "couple_per_tooth": Text("Change of the couple "
                                                                                                "over one tooth"),
    "couple_phase": Text("Direction of the couple"), "crank_angle": Text("Crank angle"),
    "damping_xx": Text("Dimensionless damping, along the load"), "damping_xy": Text("Dimensionless damping, coupled"),
    "damping_yy": Text("Dimensionless damping, across the load"), "density": Text("Density"),
    "direction": Text("Direction"),
    "displacement": Text("Displacement"), "displacement_of_unlike": Text("Displacement"),
    "driven_speed": Text("Speed of the driven wheel"), "driver_speed": Text("Speed of the driver"),
    "dynamic_stiffness": Text("Dynamic stiffness"), "dynamic_viscosity": Text("Dynamic viscosity"),
    "eccentricity": Text("Eccentricity ratio"), "eccentricity_of_film": Text("Eccentricity ratio"),
    "eccentricity_of_relative_film": Text("Eccentricity ratio"), "efficiency": Text("Efficiency"),
    "ehl_rolling_power": Text("Rolling power of the film, per width"), "exponent": Text("Exponent of the viscosity "
                                                                                        "index"),
    "film": Text("Smallest film"), "film_elastic_piezoviscous": Text("Dimensionless film, elastic and piezoviscous"),
    "film_heavily_loaded": Text("Smallest film"), "film_lightly_loaded": Text("Smallest film"),
    "flash_temperature": Text("Flash temperature"), "force": Text("Length of the force"),
    "force_direction": Text("Direction of the force"), "force_length": Text("Length of the force"),
    "force_per_degree": Text("Change of the force over one degree"), "force_per_tooth": Text("Change of the force "
                                                                                             "over one tooth"),
    "frequency": Text("Natural frequency"), "friction_coefficient": Text("Coefficient of friction"),
    "friction_exponent": Text("Exponent of the friction"), "friction_variable": Text("Friction variable"),
    "front_length": Text("Length of the front sector"), "front_unbalance": Text("Unbalance of the front sector"),
    "fuel": Text("Fuel"),
    "gear_axial": Text("Axial force of the teeth"), "gear_radial": Text("Radial force of the teeth"),
    "gear_tangential": Text("Tangential force of the teeth"), "grade": Text("Grade"),
    "half_angle": Text("Half of the sector's angle"),
    "harmonics": Text("Harmonics of the acceleration"), "implied_viscosity": Text("Kinematic viscosity"),
    "index_above_100": Text("Viscosity index"), "index_up_to_100": Text("Viscosity index"),
    "indicated_power": Text("Indicated power"),
    "inertia_tensor": Text("Inertia tensor"), "lacking_product": Text("Unbalance times arm that is lacking"),
    "lacking_unbalance": Text("Unbalance that is lacking"), "largest_moment": Text("Largest bending moment"),
    "length_ratio": Text("Length ratio"), "line_load_of": Text("Line load"),
    "load_slope": Text("Change of the load with the eccentricity"), "log_sommerfeld": Text("Logarithm of Sommerfeld's "
                                                                                           "number"),
    "longest_interval": Text("Longest firing interval"), "loss_of_mean_friction": Text("Loss of the mesh"),
    "mass_moment": Text("Moment of a mass"), "mean_friction": Text("Mean coefficient of friction"),
    "mean_pressure": Text("Indicated mean pressure"), "mean_stress_factor": Text("Mean stress factor"),
    "mirrored_couple": Text("Couple of the mirrored shaft"), "mirrored_force": Text("Force of the mirrored shaft"),
    "mixed_cycle": Text("Pressure in the cylinder"), "mode_loss": Text("Loss factor of a mode"),
    "moment_place": Text("Place of the largest moment"), "narrow_helical_share": Text("Load share of narrow helical "
                                                                                      "wheels"),
    "natural_frequency": Text("First natural frequency of bending"),
    "natural_frequency_without_rotary": Text("First natural frequency of bending"),
    "nearest_preferred": Text("Measuring piece"),
    "normal_module": Text("Normal module"), "other_losses": Text("Other losses"),
    "other_losses_on_wheel": Text("Other losses of a wheel"), "over_pins_opposite": Text("Size over pins"),
    "pair_half_angle": Text("Half of the sectors' angle"), "pair_length": Text("Length of each sector"),
    "pair_ratio": Text("Ratio of the sectors"), "piece_moments": Text("Bending moment of a piece"),
    "pitch_line_speed": Text("Speed of the reference circle"), "power_in": Text("Power that comes in"),
    "power_out": Text("Power that goes out"), "pressure_ratio": Text("Pressure ratio"),
    "pressure_viscosity_constant": Text("Constant of the pressure-viscosity coefficient"),
    "product_left": Text("Unbalance times arm left for the sectors"), "radial_damping": Text("Radial damping"),
    "reaction": Text("Length of the reaction"), "rear_length": Text("Length of the rear sector"),
    "rear_unbalance": Text("Unbalance of the rear sector"), "relative_clearance": Text("Relative clearance"),
    "relative_film": Text("Relative film"), "relative_flow": Text("Relative flow"),
    "relative_path": Text("Way of the piston over the crank radius"),
    "relative_path_two_term": Text("Way of the piston over the crank radius"),
    "relative_side_flow": Text("Relative side flow"),
    "revolutions": Text("Speed"), "rounded": Text("Tolerance, rounded"), "schlenk": Text("Mean coefficient of "
                                                                                         "friction by Schlenk"),
    "seals": Text("Seals of all wheels"), "seals_on_wheel": Text("Seals of a wheel"),
    "sector_area": Text("Area of the sector"),
    "shaft_couple": Text("Couple of the shaft"), "shaft_force": Text("Force of the shaft"),
    "shaft_product": Text("Unbalance times arm of the shaft"), "shaft_unbalance": Text("Unbalance of the shaft"),
    "share_below_zero": Text("Share of the trains that jam"), "share_of_largest_load": Text("Relative film of the "
                                                                                            "largest load"),
    "share_of_least_friction": Text("Relative film of the least friction"), "shear_modulus": Text("Shear modulus"),
    "sheared_share": Text("Sheared share of the gap"), "shortest_interval": Text("Shortest firing interval"),
    "shoulder_moment": Text("Bending moment at the shoulder"), "side_flow_din": Text("Side flow"),
    "side_flow_factor": Text("Factor of the side flow"), "side_flow_share": Text("Share of the side flow"),
    "slide_to_roll": Text("Slide-to-roll ratio"), "slopes": Text("Slope of the journal"),
    "solid_share_by_square": Text("Share of the load on the roughness"), "sommerfeld": Text("Sommerfeld number"),
    "specific_heat": Text("Specific heat"), "stiffness_xx": Text("Dimensionless stiffness, along the load"),
    "stiffness_xy": Text("Dimensionless stiffness, coupled"), "stiffness_yx": Text("Dimensionless stiffness, coupled"),
    "stiffness_yy": Text("Dimensionless stiffness, across the load"),
    "supply_factor": Text("Factor of the supply flow"),
    "supply_flow": Text("Supply flow"), "surface_speed": Text("Surface speed"), "tangent_angle": Text("Angle of the "
                                                                                                      "tangent at the "
                                                                                                      "root"),
    "thrown_oil": Text("Thrown oil of all wheels"), "thrown_oil_on_wheel": Text("Thrown oil of a wheel"),
    "tool_corner_angle": Text("Angle of the tool's corner"), "torque": Text("Torque"),
    "transmitted_power": Text("Power"),
    "unbalance_left": Text("Unbalance left for the sectors"), "unbalance_length": Text("Length of the unbalance"),
    "velocity_coefficient": Text("Coefficient of the velocity factor"), "wheel_speed": Text("Speed of the wheel"),
    "whole_couple": Text("Couple of the shaft"), "whole_force": Text("Force of the shaft"), "windage": Text("Windage"),
    "xu_kahraman": Text("Coefficient of friction by Xu and Kahraman"),
}  # fmt: skip


# --- the nomenclature

COLUMNS = 2
EACH = (WIDTH - (COLUMNS - 1) * GUTTER) / COLUMNS
SYMBOL, UNIT, PAGE = 30.0, 26.0, 11.0  # width of what stands beside a meaning
MEANING = EACH - SYMBOL - UNIT - PAGE - 4.0
CUTS = (", ", " (", ": ")  # where a meaning may end
PREPOSITION = 3  # letters at most


def noted(context: Context, name: str, label: str, unit: str) -> str:
    """Note a symbol of a table, which says what it means; the engineer's report has only those of formulas."""
    if not context.audit:
        return ""
    return _noted(context, name, _in_common_of(label, _labels(context).get((context.chapter, name), [])), unit)


def _noted(context: Context, name: str, meaning: str, unit: str) -> str:
    """Note a symbol of the chapter at hand; gives the name under which its page is found.  What has another meaning, or
    another unit, is another one."""
    if not name or name.isdecimal() or not context.chapter:  # the number of an order is no symbol
        return ""
    key = (context.chapter, name, meaning.casefold())
    return context.symbols.setdefault(key, Symbol(context.chapter, name, meaning, unit)).indexed


def noted_line(context: Context, line: Line, name: str, put_in: Mapping[str, str]) -> str:
    """Note the symbols of a formula as they are set: that of its result, and those in it; `put_in`: the symbols of
    values that stand there in place of its own."""
    names = [_noted(context, name, *_meaning(context, line))]
    formula = line.formula
    known, declared = units(formula), formula.meanings
    written = not formula.shows or of_few_numbers(line)
    for parameter, value in line.arguments.items() if written else ():
        own = formula.names.get(parameter) or symbol(parameter)
        set_as = own if formula.shows else put_in.get(own, own)
        origin = _origin(context, own, value) if set_as != own or parameter not in declared else None
        if origin is None and parameter in declared:
            origin = context.say(declared[parameter]), known.get(parameter, "")
        if origin is not None:
            names.append(_noted(context, set_as, *origin))
    return BETWEEN.join(filter(None, dict.fromkeys(names)))


def noted_result(context: Context, line: Line) -> str:
    """Note the symbol of a line that is quoted by its value."""
    return _noted(context, symbol_of(line), *_meaning(context, line))


def _meaning(context: Context, line: Line) -> tuple[str, str]:
    """What a line gives: what the values of its formula are called, or what its source says that it is; and its
    unit."""
    unit, meanings = result(line)[1], line.formula.meanings
    if "return" in meanings:
        return context.say(meanings["return"]), unit
    if called := _labels(context).get((_name(line), symbol_of(line))):
        return _in_common_of(called[0][1], called), unit
    _, _, description = context.say(line.formula.source).partition(": ")
    return _short(description) if description else context.say(BY_NAME[line.formula.__name__]), unit


def _name(line: Line) -> str:
    return f"{line.formula.function.__module__}.{line.formula.__name__}"


def _short(words: str) -> str:
    """What a source says first; without what follows a mark, where it is too long for a line."""
    words = words.partition("; ")[0]
    while run(words, NOTE).width > MEANING and (cut := max(map(words.rfind, CUTS))) > 8:
        words = words[:cut]
    return words


def _origin(context: Context, name: str, value: object) -> tuple[str, str] | None:
    """What an argument is, where it comes from lines of one formula, or from inputs of one name."""
    origins = leaves(link_of(value))
    lines, keys = [x for x in origins if isinstance(x, Line)], [x for x in origins if isinstance(x, str)]
    if lines and not keys and len({(_name(line), symbol_of(line)) for line in lines}) == 1:
        return _meaning(context, lines[0]) if _given_by(value, lines) else None
    try:
        inputs = [quantity_of(context.document.data, key) for key in keys]
    except BadInput:
        return None
    if lines or len({about.label for about in inputs}) != 1:
        return None
    here = all(step_at(context.document.data, key) == context.chapter for key in keys)
    own_key = here and inputs[0].symbol and symbol(inputs[0].symbol) == name
    if not own_key and not _same(value, [value_at(context.document.data, key) for key in keys], inputs[0]):
        return None  # what is made of an input is something else: the tolerance of a diameter
    return context.say(inputs[0].label), inputs[0].unit


def _given_by(value: object, lines: list[Line]) -> bool:
    """Whether an argument is what lines gave, or some of it, and not only found from it."""
    given = np.concatenate([np.ravel(np.asarray(line.value)) for line in lines])
    if given.dtype == object or isinstance(value, str):
        return True
    return bool(
        np.isclose(np.ravel(np.asarray(value))[:, None], given, rtol=1e-9, atol=0.0, equal_nan=True).any(1).all()
    )


def _same(value: object, given: list[Any], about: Quantity) -> bool:
    """Whether an argument is inputs as they are given, or some of their numbers; what is left out is not compared.
    A name brings in what a table has under it, which is something else."""
    if any(isinstance(one, str) for one in given):
        return False
    numbers = [n for one in given for n in (one if isinstance(one, list) else [one]) if isinstance(n, (int, float))]
    values = value if isinstance(value, (tuple, list)) else [value]
    compared = [x for x in values if isinstance(x, (int, float))]
    if not numbers or not compared:
        return len(given) == 1
    inside = [about.units.inside(number) for number in numbers]
    return all(any(isclose(x, one, rel_tol=1e-9) for one in inside) for x in compared)


Called = list[tuple[str, str]]  # ids, each with what it is called


def _labels(context: Context) -> dict[tuple[str, str], Called]:
    """What the values and inputs with a symbol are called, by chapter and symbol, and of values by their formula and
    symbol; "its place" goes on from another name."""
    if not context.labels:
        data = context.document.data
        for value in context.values.values():
            line = link_of(value.inside)
            own = isinstance(line, Line) and value.symbol == symbol_of(line)
            for of in (step_at(data, value.id), _name(line) if own and isinstance(line, Line) else ""):
                if of and value.symbol and not value.label[:1].islower():
                    context.labels.setdefault((of, value.symbol), []).append((value.id, context.say(value.label)))
        for key, about in quantities(data):
            if about.symbol:
                of_key = context.labels.setdefault((step_at(data, key), symbol(about.symbol)), [])
                of_key.append((key, context.say(about.label)))
    return context.labels


def _in_common_of(label: str, called: Called) -> str:
    """A label without the part that it is of, where others are called the same but for theirs."""
    for id, other in called:
        label = _in_common(label, other, id)
    return label


def _in_common(label: str, other: str, id: str) -> str:
    """What a symbol is called without the part that it is of, the form factor of each wheel; `id`: of the value that is
    called `other`."""
    label_words, words = label.split(), other.split()
    same = [a for a, b in takewhile(lambda pair: pair[0].strip(",") == pair[1].strip(","), zip(label_words, words))]
    if label == other or len(same) == len(words) or words[len(same)].strip(",") not in re.split(r"[._]", id):
        return label
    while same and len(same[-1]) <= PREPOSITION:
        del same[-1]
    return " ".join(same).rstrip(",") if len(same) > 1 else label


def nomenclature_blocks(context: Context) -> list[Block]:
    """The symbols of each chapter in two columns, row by row."""
    blocks = paragraph(context.words["nomenclature_note"], NOTE, gap=1.0) if context.symbols else []
    for number, step, _ in context.steps():
        symbols = sorted((entry for entry in context.symbols.values() if entry.chapter == step.key), key=_order)
        rows = [_Entry(entry) for entry in symbols]
        if rows:
            blocks += heading(f"{number}  {context.title(step)}", GROUP, gap=3.0, after=0.0)
            blocks += [_row(rows[n : n + COLUMNS]) for n in range(0, len(rows), COLUMNS)]
    return blocks


def _order(entry: Symbol) -> tuple[bool, str, str]:
    """Latin letters before Greek ones, each with its capital."""
    base = entry.name.lstrip("|∠ΔΣ(")
    return base[:1] > "z", base.casefold(), entry.name


class _Entry:
    """One symbol with what it means."""

    def __init__(self, one: Symbol) -> None:
        self.one, self.symbol = one, set_symbol(one.name, NOTE.size)
        self.at = max(SYMBOL, self.symbol.width + 3.0)
        self.unit = text(one.unit, NOTE.size, NOTE.face, NOTE.colour)
        self.right = EACH - PAGE - max(UNIT, self.unit.width + 2.0)
        self.meaning = lines(one.meaning[:1].upper() + one.meaning[1:], NOTE, self.right - 3.0 - self.at)

    def draw(self, pen: Pen, x: float, y: float) -> None:
        base = y - 0.78 * NOTE.leading
        pen.put(self.symbol, x, base)
        for n, line in enumerate(self.meaning):
            pen.put(line, x + self.at, base - n * NOTE.leading)
        pen.put(self.unit, x + self.right, base)
        if pages := pen.places.get(self.one.indexed):
            number = text(str(pages[0]), NOTE.size, NOTE.face, NOTE.colour)
            pen.put(number, x + EACH - number.width, base)
            pen.link(x, base - 2.0, EACH, NOTE.leading, f"page-{pages[0]}", self.one.name)


def _row(entries: list[_Entry]) -> Block:
    def draw(pen: Pen, y: float) -> None:
        for n, entry in enumerate(entries):
            entry.draw(pen, n * (EACH + GUTTER), y)

    return Block(max(len(entry.meaning) for entry in entries) * NOTE.leading, draw)
