# SPDX-License-Identifier: Apache-2.0
"""The route through a design: the question of each step, the inputs that decide it, guidance, and what is taken over.

The few inputs that decide a step come first, the rest in folds.

A pattern is the keys from the step on, without names or numbers of elements: `wheels.teeth`; that of a table stands for
all in it. What no fold names is in the last one."""

from collections.abc import Callable
from dataclasses import dataclass

from calc.design.addresses import Table
from calc.library.journal_rules import SLOPE, USUAL_CLEARANCE, USUAL_LENGTH
from calc.sheet.text import Amount, Text

from .places import Place, content_at


@dataclass(frozen=True)
class Leg:
    """`builds`: what Enter makes of a step that the design does not have."""

    question: Text
    deciding: tuple[str, ...]
    folds: tuple[tuple[Text, tuple[str, ...]], ...]
    builds: Text


MORE = Text("More")
STROKE = "stroke_mm"  # twice the crank radius, which the design file has
ROUTE: dict[str, Leg] = {
    "engine": Leg(
        Text("Which engine shakes?"),
        ("bore_mm", STROKE, "rod_length_mm", "piston_mass_g", "rated_speed_rpm", "cylinder_pitch_mm"),
        ((MORE, ()),
         (Text("Cylinders, banks, cranks"), ("layout", "cylinders", "strokes", "firing_order", "crank_angles_deg",
         "bank_angle_deg",
                                             "bank_of_cylinder", "axial_positions_mm", "cylinder_offset_mm",
                                             "crank_radii_mm")),
         (Text("Gas, bench, torque"), ("bench", "gas", "torque", "torque_period_deg", "throw"))),
        Text("build it by rules: an inline engine to begin with"),
    ),
    "imbalance": Leg(
        Text("Which balancing?"),
        ("crank_balance_fraction", "kinematics"),
        ((MORE, ()), (Text("Bodies of the crank"), ("unbalances", "crank_bodies", "crank_bodies_throw_at_tdc",
        "bob_mode", "bob_mass_kg"))),
        Text("build it by rules: the balancing that the engine calls for"),
    ),
    "countershaft": Leg(
        Text("Which shaft: given masses, or sized in an envelope?"),
        ("mode", "outer_radius_mm", "core_radius_mm", "half_length_mm", "bearing_positions_mm", "masses"),
        ((MORE, ()), (Text("Support, drain, cost"),
                      ("bolts", "support", "oil_drain", "further_drains", "cost", "parts", "scatter", "balance_grade",
                      "holes"))),
        Text("build it by rules: a shaft sized for the balancing that was chosen"),
    ),
    "bearings": Leg(
        Text("Do the films carry, at every corner?"),
        ("oil", "supply_temperature_C", *(f"{end}.{key}" for key in ("diameter_mm", "length_mm", "clearance_um",
        "clearance_factor")
                                          for end in ("front", "rear"))),
        ((MORE, ()), (Text("Materials and fits"),
                      ("housing_material", "bush_material", "journal_material", "application", "journal_fit",
                      "seat_fit", "roughness_ratio",
                       "clearance_reference_temperature_C", "expansion_restraint"))),
        Text("build it by rules: bearings that pass"),
    ),
    "gears": Leg(
        Text("Which train turns it, without jamming?"),
        ("normal_module_mm", "helix_angle_deg", "face_width_mm", "wheels.name", "wheels.teeth", "wheels.profile_shift",
         "wheels.span_allowance_um", "meshes.driver", "meshes.driven", "meshes.centre_distance_mm",
         "meshes.tolerance_um"),
        ((MORE, ()), (Text("More of the wheels"), ("wheels",)), (Text("More of the meshes"), ("meshes", "neighbours",
        "walls"))),
        Text("build it by rules: a train for the distance"),
    ),
    "friction": Leg(
        Text("What does it cost the crank?"),
        ("oil", "oil_temperature_C", "flank_roughness_um", "load_sharing", "specific_fuel_consumption_g_kWh"),
        ((MORE, ()), (Text("Seals, rolling bearings, splash"),
                      ("seals", "rolling_bearings", "plain_bearings", "dips", "jets", "other_losses", "scenarios"))),
        Text("build it by rules: ground flanks in the oil of the bearings"),
    ),
    "mounting": Leg(
        Text("What does the driver feel?"),
        ("mass_kg", "centre_of_gravity_mm", "inertia_kgm2", "idle_speed_rpm", "mounts.name", "mounts.position_mm",
         "mounts.stiffness_N_mm"),
        ((MORE, ()), (Text("More of the mounts"), ("mounts",)), (Text("Frame, points, operations"), ("chassis",
        "points", "operation"))),
        Text("build it by rules: four mounts at the corners, masses assumed until they are weighed"),
    ),
}  # fmt: skip
NAME: Place = ("name",)  # of the design itself: asked with its engine, which comes first
NOTE, DOCUMENT = ("note",), ("document",)  # in a fold behind those of its first step
FIRST = "engine"

VEE = ("bank_angle_deg", "bank_of_cylinder")
GIVEN, SIZED = (
    ("masses",),
    ("outer_radius_mm", "core_radius_mm", "half_length_mm", "overdesign_percent", "radial_clearance_mm"),
)


def _only_of_other(key: str, other: str, usual: str) -> Callable[[Table], bool]:
    return lambda step: step.get(key, usual) == other


# step and key → where the input says nothing; it is left out of the form there, unless it has a value
IDLE: dict[tuple[str, str], Callable[[Table], bool]] = {
    **{("engine", key): _only_of_other("layout", "inline", "inline") for key in VEE},
    **{("countershaft", key): _only_of_other("mode", "size", "given") for key in GIVEN},
    **{("countershaft", key): _only_of_other("mode", "given", "given") for key in SIZED},
    ("bearings", "hole_diameter_mm"): lambda step: step.get("supply") not in ("hole", "shaft", None),
    ("bearings", "groove_width_mm"): lambda step: step.get("supply") != "groove",
    ("bearings", "groove_arc_deg"): lambda step: step.get("supply") != "groove",
    ("bearings", "pocket_width_mm"): lambda step: step.get("supply") != "pocket",
    ("bearings", "pocket_length_mm"): lambda step: step.get("supply") != "pocket",
    **{
        ("bearings", f"axial_groove_{key}"): lambda step: step.get("supply") != "axial_groove"
        for key in ("angles_deg", "width_mm", "length_mm")
    },
}


def path_of(place: Place) -> str:
    """The pattern that names a place."""
    return ".".join(part for part in place[1:] if isinstance(part, str))


def covers(pattern: str, path: str) -> bool:
    return path == pattern or path.startswith(f"{pattern}.")


def idle(place: Place, data: Table) -> bool:
    """Whether an input says nothing in this design, and has no value."""
    if len(place) < 2 or (rule := IDLE.get((str(place[0]), str(place[1])))) is None:
        return False
    step = content_at(data, place[:1])
    return isinstance(step, dict) and rule(step) and step.get(str(place[1])) in (None, [])


def step_of(place: Place) -> str:
    """The step whose form asks for an input."""
    return FIRST if place[:1] in (DOCUMENT, NAME, NOTE) else str(place[0]) if place else ""


def document_fold() -> int:
    """The number of the fold of note and document control, behind those of the step."""
    return len(ROUTE[FIRST].folds)


def fold_of(step: str, path: str) -> int | None:
    """The fold that an input lies in; None where it decides."""
    leg = ROUTE[step]
    if any(covers(pattern, path) for pattern in leg.deciding):
        return None
    for n, (_, patterns) in enumerate(leg.folds):
        if any(covers(pattern, path) for pattern in patterns):
            return n
    return 0


def fold_at(step: str, place: Place) -> int | None:
    """The fold of a step's form that a place lies in."""
    if step_of(place) != step:
        return None
    if place[:1] in (DOCUMENT, NAME, NOTE):
        return document_fold()
    return None if len(place) < 2 else fold_of(step, path_of(place))


# --- guidance through the steps
# What is to be decided in each, what a good answer looks like, and what to try when a check fails.


@dataclass(frozen=True)
class Guide:
    decide: Text
    good: Text
    trying: Text


GUIDES: dict[str, Guide] = {
    "engine": Guide(
        Text("Which engine: layout, crank, masses of piston and rod, rated speed. Everything else follows from it."),
        Text("Masses as weighed, the rod's centre of gravity too."),
        Text(
            "Weigh instead of estimating. The firing order can be chosen from a table, the one that leaves least first."
        ),
    ),
    "imbalance": Guide(
        Text(
            "How much of the reciprocating mass the crank's own counterweights carry, and so what is left for a "
            "counter-shaft."
        ),
        Text("Little left, by little mass: the row marked ◀ is what this engine calls for."),
        Text(
            "Second order is out of reach of one shaft: lighter pistons, a longer rod, two shafts at twice the speed, "
            "or good engine mounts."
        ),
    ),
    "countershaft": Guide(
        Text(
            "The shaft that takes the rest: its masses, their radius, angle and place, where it is supported, and "
            "what it is made of."
        ),
        Text(
            "Nothing left of what it is to take, journals at less than {slope}, the first critical speed far above "
            "the running speed.",
            slope=Amount(SLOPE * 1e3, "mrad"),
        ),
        Text(
            "Sectors further apart or further out save mass; a thicker core straightens the shaft. The lightest can "
            "be chosen from a table."
        ),
    ),
    "bearings": Guide(
        Text("Length and clearance of the two bearings, oil and its supply, and on what the journals run."),
        Text(
            "Length: {length}; clearance: {clearance}; a film that holds warm and at twice the load, and clearance "
            "left when cold.",
            length=USUAL_LENGTH,
            clearance=USUAL_CLEARANCE,
        ),
        Text(
            "A tighter fit first, then more length, then smoother surfaces; a thicker oil where the engine allows it. "
            "A table has bearings that pass."
        ),
    ),
    "gears": Guide(
        Text("Teeth, profile shifts, centre distances and allowances of the train that drives the shaft."),
        Text(
            "Backlash that stays above zero at every tolerance, cold and warm; contact ratio well above 1, no "
            "undercut, sliding "
            "shared evenly."
        ),
        Text(
            "Jamming: more span allowance. Undercut, pointed tips, uneven sliding: other profile shifts, from a table. "
            "Strength: face width."
        ),
    ),
    "friction": Guide(
        Text("Roughness of the flanks, oil and its temperature: what the whole train costs the crank."),
        Text(
            "Some hundred watts at rated speed. Under so light a load rolling and the bearings lose more than the "
            "teeth rub away."
        ),
        Text(
            "A thinner or warmer oil costs less in the meshes and thins the films of the bearings: watch step 4 while "
            "you change it."
        ),
    ),
    "mounting": Guide(
        Text("Mass, inertia and mounts of the engine, the frame below them, and where it is felt at which speeds."),
        Text(
            "All modes between the road's frequency and idle, roll and bounce pure. The shaft takes order 1; the "
            "firing torque stays."
        ),
        Text("Softer mounts, other ratios, an inclination: the search for mounts finds those that decouple the modes."),
    ),
}


# --- what a step takes over from the steps before it
# Names that a design does not have are passed over.

# step → values (or inputs) of earlier steps that it uses
TAKEN: dict[str, tuple[str, ...]] = {
    "imbalance": ("engine.rated_speed_rpm", "engine.reciprocating_mass", "engine.lambda"),
    "countershaft": (
        "engine.rated_speed_rpm",
        "imbalance.required_couple",
        "imbalance.required_couple_phase",
        "imbalance.required_force",
        "imbalance.required_force_phase",
    ),
    "bearings": ("engine.rated_speed_rpm", "countershaft.reaction_front", "countershaft.reaction_rear"),
    "gears": (
        "engine.rated_speed_rpm",
        "imbalance.required_couple",
        "imbalance.required_force",
        "countershaft.moment_of_inertia",
        "bearings.housing_material",
    ),
    "friction": (
        "bearings.oil",
        "bearings.supply_temperature_C",
        "bearings.front.friction_power",
        "bearings.rear.friction_power",
    ),
}

# keys of text fields that hold a name from one of the catalogues
NAMED = {
    "oil": "oils",
    "material": "materials",
    "housing_material": "materials",
    "journal_material": "materials",
    "bush_material": "bushes",
    "application": "applications",
    "support_material": "materials",
    "gear_material": "strength_classes",
}

# what can be chosen from a table, by step (`offers.py` searches for it)
CHOICES = {
    "engine": Text("firing orders, the one that leaves least first"),
    "countershaft": Text("shafts in the envelope, the lightest first"),
    "bearings": Text("plain bearings that pass at every corner, the nearest and the least power first"),
    "gears": Text("profile shifts and tip cuts, the least specific sliding first; teeth of an idler between walls"),
    "mounting": Text("mounts that decouple the modes between the road's frequency and idle, the purest first"),
}
