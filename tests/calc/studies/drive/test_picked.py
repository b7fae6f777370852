# SPDX-License-Identifier: Apache-2.0
"""One drive of a front as its file has it: which it is, what is near, what each objective costs there; and files that
are none."""

import json

import numpy as np
import pytest

from calc.studies.drive.front import Broken, picked

SHAFT = {"name": "shaft", "core_radius_mm": 15.0, "bearings": [{"name": "front", "length_mm": 37.0}]}
DATA = {"shafts": [SHAFT], "bearings": {}}


def front(rows, mine=1, **changed):
    """A front of power, mass and margin, of which the design is drive `mine` (from 0)."""
    drives = [
        {
            "objectives": dict(zip(("power", "mass", "margin"), row)),
            "changes": {
                "shafts.shaft.core_radius_mm": 15.0 if n == mine else 20.0 + n,
                "shafts.shaft.bearings.front.clearance_factor": None,
            },
        }
        for n, row in enumerate(rows)
    ]
    about = {
        "objectives": {"power": "W", "mass": "kg", "margin": "%"},
        "drives": drives,
        "sizes_mm": {"shafts.shaft.bearings.front.length_mm": None},
        "choices": {"bearings.fits": [["IT6", "IT7"]]},
        "proved": True,
        "combinations": 10**11,
        "classes": 2,
        "classes_done": 2,
        "limits": ["bearings.*"],
        "waived": [],
    }
    return json.dumps(about | changed).encode()


ROWS = [(250.0, 9.0, 5.0), (255.0, 8.5, 1.0), (270.0, 8.0, 0.5), (300.0, 8.6, 20.0)]


def test_what_each_objective_costs_is_the_slope_to_the_next_one():
    one = picked(front(ROWS), DATA)
    assert one.number == 2 and one.names == ("power", "mass", "margin")
    costs = {(wanted, paid): (gain, loss) for wanted, gain, paid, loss in one.costs()}
    assert costs["mass", "power"] == pytest.approx((0.5, 15.0))  # half a kilogram for 15 W, to the third
    assert costs["power", "mass"] == pytest.approx((5.0, 0.5))
    assert costs["margin", "mass"] == pytest.approx((19.0, 0.1))
    assert np.allclose(one.line("mass", "power"), [(8.0, 270.0), (8.5, 255.0), (9.0, 250.0)])
    assert one.nearest(2) == [1, 2] and one.choices == {"bearings.fits": ("IT6/IT7",)}


def test_a_design_that_is_none_of_the_drives():
    assert picked(front(ROWS, mine=9), DATA) is None
    assert picked(front(ROWS), {**DATA, "shafts": [{**SHAFT, "core_radius_mm": 15.5}]}) is None
    assert picked(front([]), DATA) is None


def test_a_front_that_was_kept_with_the_keys_of_schema_1_is_understood():
    old = front(ROWS).replace(b"shafts.shaft.bearings.", b"bearings.").replace(b"shafts.shaft.", b"countershaft.")
    assert b"shafts" not in old and picked(old, DATA).number == 2


@pytest.mark.parametrize(
    "raw",
    [
        b"",
        b"[]",
        b"{}",
        b"null",
        b"\xff\xfe",
        b"[" * 5000,
        front(ROWS, objectives={"beauty": "1"}),
        front(ROWS, drives=3),
        front(ROWS, drives=[{}]),
        front([(float("nan"), 1, 1)]),
        front([("x", 1, 1)]),
        front(ROWS, choices=5),
        front(ROWS, sizes_mm=[1]),
        front(ROWS, combinations="many"),
        front(ROWS, limits=7),
        b"x" * 5_000_000,
    ],
)
def test_a_file_that_is_no_front_is_told(raw):
    with pytest.raises(Broken):
        picked(raw, DATA)
