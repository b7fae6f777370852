"""Whether the arguments of a part are those of before."""

import numpy as np
import pytest

from calc.sheet.record import record
from calc.sheet.reuse import Parts, alike
from calc.sheet.step import Outcome


@record
class Size:
    length: float
    places: object = None


@pytest.mark.parametrize(
    ("a", "b", "same"),
    [
        (Size(length=1.0), Size(length=1.0), True),
        (Size(length=1.0), Size(length=2.0), False),
        (max, min, False),
        (max, max, True),
        (Size(length=1.0, places=max), Size(length=1.0, places=min), False),
        (lambda: 1, lambda: 1, False),
        (Size(length=1.0, places=np.ones(2)), Size(length=1.0, places=np.ones(2)), True),
        ({"a": (1.0, 2.0)}, {"a": (1.0, 2.0)}, True),
        (Size(length=1.0, places=np.ones(2)), Size(length=1.0, places=np.ones(3)), False),
        ((1.0,), (1.0, 2.0), False),
        (1.0, 1, False),
        (Size(length=1.0, places=None), Size(length=1.0, places=0.0), False),
        (float("nan"), float("nan"), False),
    ],
)
def test_records_are_alike_where_all_their_parts_are(a, b, same):
    assert alike(a, b) is same


def test_what_was_compared_serves_where_that_is_not_asked():
    called = []

    def solve(x: float, *, compared: bool) -> Outcome[float]:
        called.append(compared)
        return Outcome("bearings", result=x)

    before = {}
    for compared, times in ((False, 1), (True, 2), (False, 2), (True, 2)):
        part = Parts({}, before, {}, stop=bool, enough=None)
        part("bearings", solve, 1.0, compared=compared)
        before = part.kept
        assert len(called) == times
