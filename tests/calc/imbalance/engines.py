"""Engines for the tests: the R753IE4's numbers in any layout."""

import math

from hypothesis import strategies as st

from calc.engine import solve as engine
from calc.engine.inputs import EngineInputs
from calc.imbalance import solve as imbalance
from calc.imbalance.inputs import ImbalanceInputs

R753 = dict(
    name="R753IE4",
    layout="inline",
    cylinders=3,
    strokes=4,
    bore=0.094,
    crank_radius=0.0535,
    rod_length=0.163,
    cylinder_pitch=0.112,
    firing_order=(1, 3, 2),
    piston_mass=1.178,
    rod_mass=1.015,
    rod_cg_to_big_end=0.05,
    crankpin_bearing_mass=0.055,
    rated_speed=2600 / 60,
)


def solved(given=None, axis=None, **changes):
    """Inputs, engine values and imbalance values of an engine like the R753IE4."""
    inputs = EngineInputs(**{**R753, **changes})
    assert list(inputs.problems()) == []
    e = engine.values(inputs)
    return inputs, e, imbalance.values(given or ImbalanceInputs(), inputs, e, axis=axis)


@st.composite
def fans(draw, offset=True):
    """Changes that make any fan of cylinders: throws, places and banks at random."""
    n = draw(st.integers(1, 8))
    angles = st.floats(0, 2 * math.pi)
    return dict(
        layout="vee",
        cylinders=n,
        firing_order=None,
        crank_angles=(0.0, *draw(st.lists(angles, min_size=n - 1, max_size=n - 1))),
        bank_of_cylinder=tuple(draw(st.lists(st.integers(0, 1), min_size=n, max_size=n))),
        bank_angle=draw(st.floats(0.1, 3.0)),
        axial_positions=tuple(draw(st.lists(st.floats(-1, 1), min_size=n, max_size=n))),
        cylinder_offset=draw(st.floats(-0.02, 0.02)) if offset else 0.0,
        rod_length=draw(st.floats(0.12, 0.3)),
    )
