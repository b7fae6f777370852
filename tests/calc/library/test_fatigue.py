"""Endless life at fillets: the Haigh line, a shaft from standstill to full speed, a throw over its cycle (numbers by
hand)."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from calc.countershaft.bending import shaft as b
from calc.countershaft.checks import FATIGUE, FATIGUE_RESERVE, bending_checks
from calc.engine import throw
from calc.engine.gas import GasInputs
from calc.engine.inputs import ThrowInputs
from calc.library import fatigue
from calc.library.catalogue import Material, materials
from tests.calc.countershaft.bending.test_bending import FRONT, OMEGA, REAR, STEEL, example, further
from tests.calc.engine.test_throw import SIZES
from tests.calc.engine.test_torque import engine_of, single

ROWS = materials()
HARD = replace(STEEL, kind="steel", tensile_strength=1000e6)


def test_the_line_of_haigh():
    """M = 0.25: no mean stress, 100; mean = amplitude, 100·1.25; from there on a third of the slope, up to half of
    R."""
    at = lambda mean: fatigue.equivalent_amplitude(sigma_a=100.0, sigma_m=mean, M=0.25)  # noqa: E731
    assert (at(0.0), at(100.0)) == (100.0, pytest.approx(125.0))
    assert at(200.0) == pytest.approx(1.25 * (100 + 200 / 12) / (1 + 1 / 12))
    rising = [at(mean) for mean in np.linspace(0, 400, 41)]
    assert all(later > before for before, later in pairwise(rising))


def test_strength_of_the_source_s_metals():
    """42CrMo4, R_m 1026 MPa: 0.40·1026 = 410 MPa, less 12.5 % for Rz 6.3 µm; iron bears less and asks for more."""
    steel, iron = fatigue.strength(ROWS["42CrMo4"]), fatigue.strength(ROWS["ADI 1050"])
    assert steel.bearable == pytest.approx(359.2e6, abs=0.1e6) and steel.sensitivity == pytest.approx(0.259, abs=5e-4)
    assert iron.bearable == pytest.approx(0.34 * 1110e6 * (1 - 0.16 * 0.79934 * np.log10(5.55)), rel=1e-4)
    assert (steel.safety, iron.safety) == (1.5, 2.1)
    assert fatigue.strength(replace(ROWS["42CrMo4"], alternating_strength=500e6)).bearable == pytest.approx(
        500 / 410.4 * steel.bearable
    )


@pytest.mark.parametrize(
    "unknown, missing",
    [
        (ROWS["20CrNi4"], ("material.tensile_strength_MPa",)),
        (replace(HARD, kind="other"), ("material.kind",)),
        (replace(HARD, kind="other", tensile_strength=None), ("material.tensile_strength_MPa", "material.kind")),
    ],
)
def test_what_is_not_known_is_not_verified(unknown, missing):
    assert fatigue.strength(unknown) is None
    bent = b.bending(
        example(),
        unknown,
        omega=OMEGA,
        positions=(FRONT, REAR),
        extras=further(),
        effectiveness=1.0,
        fillet_radius=2e-3,
    )
    assert bent.fatigue_safety is None
    (judged,) = [c for c in bending_checks(bent, unknown, 1.0) if c.rule in (FATIGUE, FATIGUE_RESERVE)]
    assert (judged.rule, judged.verdict, judged.missing) == (FATIGUE, "not_verified", missing)


def test_a_shaft_between_standstill_and_full_speed():
    """R = 0: amplitude = mean = σ_k/2, as hard as (1 + M)·σ_k/2; it falls with the square of the speed."""

    def bent(omega: float, metal: Material = HARD) -> b.Bending:
        return b.bending(
            example(),
            metal,
            omega=omega,
            positions=(FRONT, REAR),
            extras=further(),
            effectiveness=1.0,
            fillet_radius=2e-3,
        )

    one = bent(OMEGA)
    assert one.fatigue_amplitude == pytest.approx(1.25 * one.notch_stress / 2)
    assert one.fatigue_safety == pytest.approx(one.fatigue_strength / one.fatigue_amplitude)
    # the bent shaft loads itself a little
    assert bent(2 * OMEGA).fatigue_safety == pytest.approx(one.fatigue_safety / 4, rel=1e-3)
    judged = {c.rule: c for c in bending_checks(one, HARD, 1.0)}
    assert (judged[FATIGUE].verdict, judged[FATIGUE].kind, judged[FATIGUE].limit) == ("pass", "limit", 1.0)
    reserve = judged[FATIGUE_RESERVE]
    assert (reserve.verdict, reserve.kind, reserve.limit) == ("pass", "caution", 1.5)


def fatigued(p_max=101e5, **sizes):
    gas = GasInputs(peak_pressure=p_max, compression_ratio=12.0, crankcase_pressure=1e5)
    engine, e, fires = engine_of(**single(bore=0.1, rated_speed=1e-6))
    return throw.solve(engine, e, fires, gas, ThrowInputs(**{**SIZES, **sizes}), ROWS)


def test_a_throw_under_slow_gas_pulsates():
    """At rest but for the gas: hardly any stress between two firings, so that amplitude and mean are both about half of
    the largest."""
    found, checks, notes, _ = fatigued()
    tired = found.fatigue
    assert tired.place == "pin" and tired.cylinder == 1
    largest = max(p.pin.notch_stress for p in (found.largest_tangential, found.top_dead_centre))
    assert 0.5 * largest < tired.fatigue_amplitude < 0.62 * largest
    assert 0.8 < tired.fatigue_mean / tired.fatigue_amplitude <= 1.0
    assert tired.fatigue_safety == pytest.approx(tired.fatigue_strength / tired.fatigue_equivalent)
    assert "engine.throw.fatigue" in {c.id for c in checks}
    assert not any("fatigue is not judged" in note for note in notes)


def test_a_throw_tires_as_its_stress_grows():
    """The pin's stress falls with the cube of its diameter at the same ρ/d; a larger fillet bears more."""
    base = fatigued(pin_diameter=0.04, fillet_radius=0.003, journal_diameter=0.2)[0].fatigue
    thick = fatigued(pin_diameter=0.08, fillet_radius=0.006, journal_diameter=0.2)[0].fatigue
    assert (base.place, thick.place) == ("pin", "pin")
    assert thick.fatigue_amplitude == pytest.approx(base.fatigue_amplitude / 8, rel=1e-9)
    assert (
        fatigued(fillet_radius=0.005)[0].fatigue.fatigue_safety
        > fatigued(fillet_radius=0.003)[0].fatigue.fatigue_safety
    )
    found, _, notes, _ = fatigued(fillet_radius=None)
    assert found.fatigue is None and any("fatigue is not judged" in note for note in notes)
