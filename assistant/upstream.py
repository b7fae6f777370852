# SPDX-License-Identifier: Apache-2.0
"""What a step takes over from the steps before it.  Names that a design does not have are passed over."""

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
    "friction": ("bearings.oil", "bearings.supply_temperature_C", "bearings.front.friction_power", "bearings.rear.friction_power"),
}

# keys of text fields that hold a name from one of the catalogues
NAMED = {
    "oil": "oils", "material": "materials", "housing_material": "materials", "journal_material": "materials", "bush_material": "bushes",
    "application": "applications", "support_material": "materials", "gear_material": "strength_classes",
}  # fmt: skip
