# SPDX-License-Identifier: Apache-2.0
"""What of a design an engineer looks at first: the values, curves and tables of a short report, and what is proven in
it even if it holds.

Values, curves, tables: patterns of ids, where `*` stands for anything.  Checks: the ids of their rows in
`calc/library/tables/checks.md`."""

import re
from collections.abc import Iterable, Mapping
from fnmatch import translate
from functools import cache

from ..sheet.check import Check, pattern_of
from ..sheet.quantity import Published

# The results on the first page: patterns of ids; of several values the one that is worst stands for all
RESULTS: tuple[tuple[str, str], ...] = (
    ("imbalance.required_couple", "max"), ("imbalance.required_force", "max"), ("imbalance.order_2.couple_peak", "max"),
    ("imbalance.order_2.force_peak", "max"), ("imbalance.missing_forward_couple", "max"),
    ("imbalance.missing_forward_force", "max"), ("countershaft.residual_order_1_couple", "max"),
    ("countershaft.residual_order_1_force", "max"), ("countershaft.residual_order_2_couple", "max"),
    ("countershaft.residual_order_2_force", "max"), ("countershaft.mass", "max"), ("countershaft.slope_*", "max"),
    ("bearings.front.film_edge", "min"), ("bearings.rear.film_edge", "min"), ("bearings.*.outlet_temperature", "max"),
    ("gears.*.safety_contact", "min"), ("gears.*.safety_bending_*", "min"), ("gears.*.backlash_cold", "min"),
    ("gears.*.backlash_warmer", "min"), ("gears.*.transverse_contact_ratio", "min"), ("gears.phase_error", "max"),
    ("gears.residual_couple", "max"), ("friction.total_loss", "max"), ("friction.crank_torque", "max"),
    ("mounting.*.felt_seat", "min"), ("mounting.*.felt_force", "min"),
)  # fmt: skip

# The values that stand in the chapter of their step
VALUES: dict[str, tuple[str, ...]] = {
    "engine": ("engine.*_mass", "engine.lambda", "engine.angular_speed", "engine.stroke", "engine.displacement",
    "engine.mean_*",
               "engine.brake_*", "engine.acceleration_max", "engine.speed_irregularity", "engine.throw.*safety*",
               "engine.throw.stress_*"),
    "imbalance": ("imbalance.order_[12].force_forward", "imbalance.order_[12].force_backward",
    "imbalance.order_[12].couple_forward",
                  "imbalance.order_[12].couple_backward", "imbalance.order_[12].couple_peak",
                  "imbalance.order_[12].force_peak",
                  "imbalance.required_*", "imbalance.missing_*", "imbalance.mistiming_*", "imbalance.bob_mass.*"),
    "countershaft": ("countershaft.couple", "countershaft.couple_phase", "countershaft.force",
    "countershaft.residual_order*",
                     "countershaft.reaction_*", "countershaft.mass", "countershaft.moment_of_inertia",
                     "countershaft.slope_front",
                     "countershaft.slope_rear", "countershaft.first_critical_speed", "countershaft.largest_moment*",
                     "countershaft.bending_stress*", "countershaft.notch_*", "countershaft.fatigue_*",
                     "countershaft.sector_*",
                     "countershaft.residual_unbalance_*", "countershaft.permitted_couple_error",
                     "countershaft.bolt_preload",
                     "countershaft.bolt_head_pressure", "countershaft.bolt_tightening_stress",
                     "countershaft.bolt_*_safety",
                     "countershaft.hole_range"),
    "bearings": tuple(f"bearings.[fr]*.{name}" for name in (
        "load", "specific_load", "surface_speed", "heat_index", "clearance", "clearance_hot", "clearance_cold",
        "eccentricity",
        "attitude_angle", "sommerfeld", "film", "film_edge", "film_double_load", "kreisle_film", "trumpler_film",
        "film_pressure_max",
        "friction_coefficient", "friction_power", "oil_flow", "temperature_rise", "outlet_temperature", "least_speed",
    )),
    "gears": ("gears.transverse_module", "gears.transverse_pressure_angle", "gears.base_helix_angle",
    "gears.speed_ratio",
              "gears.phase_error", "gears.residual_couple", *(f"gears.*.{name}" for name in (
        "tip_thickness_normal", "speed", "centre_distance", "working_pressure_angle", "transverse_contact_ratio",
        "overlap_ratio",
        "backlash_min", "backlash_max", "backlash_cold", "backlash_running", "backlash_warmer", "backlash_warming",
        "tangential_force", "contact_stress",
        "dynamic_factor", "face_load_factor_flank", "transverse_load_factor_flank", "safety_contact",
        "safety_bending_*",
        "specific_film_min",
    ))),
    "friction": ("friction.bearing_loss", "friction.mesh_loss", "friction.windage_loss", "friction.total_loss",
    "friction.engine_share",
                 "friction.crank_torque", "friction.fuel", "friction.oil_viscosity",
                 *(f"friction.*.{name}" for name in (
        "loss", "efficiency", "loss_factor", "friction_mean", "lambda_min", "pressure_max", "film_min",
    ))),
    "mounting": ("mounting.frequency.*", "mounting.roll_axis.*", "mounting.*.felt_*", "mounting.felt_order_1.*",
    "mounting.window.*",
                 "mounting.range.*", "mounting.exposure.*", "mounting.static.*.deflection"),
}  # fmt: skip
# Of each pattern the first curve of its step is drawn, beside the sketch; the tables stand as they are
CURVES: dict[str, tuple[str, ...]] = {
    "imbalance": ("couples", "forces", "orders_*"),
    "countershaft": ("loads", "shear_force", "moment", "deflection"),
    "bearings": ("film_front",),
    "gears": ("backlash_temperature_*",),
    "friction": ("open_constants",),
    "mounting": ("seat_*", "orders_*", "mount_forces"),
}
TABLES = ("measured", "felt", "modes")

# Checks that are proven whatever their margin, each with the symbols that its proof must show however far back they
# stand
PROVEN: dict[str, tuple[str, ...]] = {
    "gears.M.safety_contact": ("σ_H0", "K_H", "K_V", "K_Hβ", "K_Hα"),
    "gears.W.safety_bending": ("σ_F0", "K_F", "K_V", "K_Fβ", "K_Fα"),
    "countershaft.bolts.strength": (),
    "countershaft.bolts.pressure": (),
    "countershaft.balance_grade": (),
    "countershaft.bending_stress": (),
    "countershaft.notch_stress": (),
    "countershaft.fatigue": (),
    "countershaft.residual": (),
    "countershaft.residual_force": (),
    "engine.throw.fatigue": (),
    "engine.throw.stress_pin": (),
}

# Of these only where this value is not 0: what a shaft has none of to balance, it needs no proof of
PROVEN_WHERE = {
    "countershaft.residual": "imbalance.required_couple",
    "countershaft.residual_force": "imbalance.required_force",
}

# A check of a method that is passed over → the checks whose numbers are then outside of what their formula is made for
VALIDITY: dict[str, tuple[str, ...]] = {
    "engine.throw.fillet_journal": ("engine.throw.fatigue", "engine.throw.notch_stress_journal"),
    "engine.throw.fillet_pin": ("engine.throw.fatigue", "engine.throw.notch_stress_pin"),
    "countershaft.fillet": ("countershaft.fatigue", "countershaft.notch_stress"),
    "bearings.B.friction_regime": ("bearings.B.film*", "bearings.B.temperature*"),
    "bearings.B.supply_range": ("bearings.B.temperature*",),
    "bearings.B.oil_rows": ("bearings.B.film*", "bearings.B.temperature*"),
    "bearings.B.viscosity_range": ("bearings.B.film*", "bearings.B.temperature*"),
    "gears.M.line_load": ("gears.M.safety_contact*", "gears.W.safety_bending*"),
    "gears.M.notch_W": ("gears.W.safety_bending*",),
    "gears.M.shift_sum": ("gears.M.safety_contact*", "gears.W.safety_bending*", "gears.M.resonance"),
    "gears.train.root_roughness": ("gears.W.safety_bending*",),
}


def like(id: str, patterns: tuple[str, ...]) -> bool:
    """Whether an id is of one of these patterns; a `*` stands for no more than one part of it."""
    return _any_of(patterns).fullmatch(id) is not None


@cache
def _any_of(patterns: tuple[str, ...]) -> re.Pattern[str]:
    # of none: nothing
    return re.compile("|".join(translate(pattern).replace(".*", "[^.]*") for pattern in patterns) or "(?!)")


def key_results(values: Mapping[str, Published]) -> dict[str, Published]:
    """The results of the first page by their patterns, each of the part where it is worst; no imbalance that the engine
    does not have."""
    results = {}
    of_any = {
        id: v for id, v in values.items() if like(id, tuple(pattern for pattern, _ in RESULTS)) and v.shown == v.shown
    }
    for pattern, worst in RESULTS:
        numbers = [v for id, v in of_any.items() if like(id, (pattern,))]
        if numbers:
            results[pattern] = (min if worst == "min" else max)(numbers, key=lambda v: v.shown)
    return {pattern: v for pattern, v in results.items() if v.shown or not pattern.startswith("imbalance.")}


def is_least(pattern: str) -> bool:
    """Whether the least of such results is the worst."""
    return dict(RESULTS)[pattern] == "min"


def is_key_value(id: str) -> bool:
    """Whether a value stands in a short report."""
    return like(id, VALUES.get(id.partition(".")[0], ()))


def concerns(method: str, check: str) -> bool:
    """Whether a check of a method, passed over, puts a check of the same part outside the validity of its formula."""
    return like(pattern_of(check), VALIDITY.get(pattern_of(method), ())) and _same_part(
        method.split(".")[1:-1], check.split(".")[1:-1]
    )


def stretched(checks: Iterable[Check]) -> list[Check]:
    """The checks of the method among these that put others outside the validity of their formulas."""
    return [
        check for check in checks if check.kind == "method" and not check.holds and pattern_of(check.id) in VALIDITY
    ]


def outside(check: Check, checks: Iterable[Check]) -> list[Check]:
    """The checks of the method, among those of its step, that put a check outside the validity of its formula."""
    return [method_check for method_check in stretched(checks) if concerns(method_check.id, check.id)]


def judged(check: Check, checks: Iterable[Check]) -> str:
    """The verdict of a check; one that holds by a formula outside its validity is not called a pass.  `checks`: of its
    step."""
    return "outside" if check.verdict == "pass" and outside(check, checks) else check.verdict


def _same_part(method: list[str], check: list[str]) -> bool:
    """Whether both are of one bearing, mesh or wheel, or one is of all of them; a wheel is part of its meshes."""
    return not method or not check or "train" in method or method[0] == check[0] or check[0] in method[0].split("_")
