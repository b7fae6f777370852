"""The chain of formulas behind a value goes back to the inputs, and to the right ones."""

from pathlib import Path

import pytest

from calc.design_file import design, read
from calc.explain import chain
from calc.solve import solve

DESIGNS = Path(__file__).parents[2] / "designs"
RESULTS = {name: solve(design(read(DESIGNS / f"{name}.toml"))) for name in ("r753ie4_gamma", "twin_force_shaft")}


@pytest.mark.parametrize("name, value, expected", [
    ("twin_force_shaft", "engine.mean_torque", {"engine.cylinders", "engine.strokes", "engine.gas.peak_pressure_bar", "engine.bore_mm"}),
    ("twin_force_shaft", "engine.speed_irregularity", {"engine.flywheel_inertia_kgm2", "engine.rated_speed_rpm"}),
    ("twin_force_shaft", "engine.throw.top_dead_centre.pin.von_mises", {"engine.throw.pin_diameter_mm", "engine.gas.peak_pressure_bar"}),
    ("twin_force_shaft", "engine.harmonic.order_2", {"engine.rod_length_mm", "engine.crank_radius_mm"}),
    ("twin_force_shaft", "engine.piston_speed_max", {"engine.rod_length_mm", "engine.rated_speed_rpm"}),
    ("twin_force_shaft", "engine.energy_fluctuation", {"engine.piston_mass_g", "engine.rated_speed_rpm", "engine.gas.peak_pressure_bar"}),
    ("twin_force_shaft", "engine.gas_torque_peak", {"engine.gas.peak_pressure_bar", "engine.bore_mm"}),
    ("twin_force_shaft", "imbalance.order_1.force_forward", {"imbalance.crank_balance_fraction", "engine.piston_mass_g"}),
    ("r753ie4_gamma", "engine.firing_interval_shortest", {"engine.firing_order", "engine.strokes"}),
    ("r753ie4_gamma", "imbalance.crank.balanced.unbalance", {"imbalance.crank_bodies.*.mass_kg"}),
    ("twin_force_shaft", "engine.delta", {"engine.cylinder_offset_mm", "engine.rod_length_mm"}),
    ("twin_force_shaft", "engine.inertia_torque.order_2", {"engine.crank_radius_mm", "engine.piston_mass_g", "engine.rated_speed_rpm"}),
    ("twin_force_shaft", "imbalance.counterweight.front.mass", {"imbalance.counterweight_span_mm", "imbalance.counterweight_radius_mm"}),
    ("twin_force_shaft", "countershaft.roll_torque", {"countershaft.masses.*.mass_kg", "countershaft.masses.*.radius_mm"}),
    ("r753ie4_gamma", "imbalance.order_4.couple_peak", {"engine.rod_length_mm", "engine.crank_radius_mm", "engine.cylinder_pitch_mm"}),
    ("r753ie4_gamma", "imbalance.bob_mass.1", {"imbalance.crank_bodies.*.mass_kg", "imbalance.crank_bodies.*.z_mm"}),
    ("r753ie4_gamma", "imbalance.missing_forward_couple", {"imbalance.crank_balance_fraction", "imbalance.bob_mass_kg"}),
    ("r753ie4_gamma", "imbalance.mistiming_per_degree", {"engine.piston_mass_g", "engine.rated_speed_rpm"}),
    ("r753ie4_gamma", "imbalance.remedy.backward_shaft.backward.unbalance_product", {"engine.cylinder_pitch_mm", "engine.rod_cg_to_big_end_mm"}),
])  # fmt: skip
def test_it_reaches_the_inputs(name, value, expected):
    found = {key for link in chain(RESULTS[name], value) for key in link.inputs}
    assert expected <= found, found


def test_a_number_that_no_formula_made_has_no_chain():
    assert chain(RESULTS["twin_force_shaft"], "engine.throw.cylinder") == []


@pytest.mark.parametrize("name", RESULTS)
def test_inputs_of_other_steps_do_not_creep_in(name):
    """Numbers that are equal by chance are told apart: the engine's own values depend on the engine alone."""
    for value in RESULTS[name].values():
        if value.startswith("engine."):
            for link in chain(RESULTS[name], value):
                assert all(key.startswith("engine.") for key in link.inputs), (value, link.inputs)


def test_a_force_that_cancels_is_not_mistaken_for_a_couple():
    """Both are 0 here; the force has no arm in its chain."""
    found = {key for link in chain(RESULTS["twin_force_shaft"], "imbalance.order_1.two_term.force_peak") for key in link.inputs}
    assert "engine.cylinder_pitch_mm" not in found and "imbalance.crank_balance_fraction" in found
