# SPDX-License-Identifier: Apache-2.0
"""The parts between two centres: how far they can move them, at worst, as root of squares, and by chance.

Whatever its kind, a part moves the centre by at most half its field.  The kinds differ in how it is spread over that: the zone of a
position is a circle, filled evenly; the wheel rests on the wall of its clearance, somewhere; an eccentricity points anywhere; a radial
shift lies evenly between its ends.  Only the part along the line of centres counts, so that a direction at random is a projection.
"""

from math import sqrt
from typing import Any

from ...sheet.arrays import column
from ...sheet.formula import formula
from ...sheet.functions import rss, total
from ...sheet.record import record
from ...sheet.units import Metre, Number
from ..inputs import Mesh
from .backlash import tolerance_of_contributors

SPREAD = {"position": 1 / 2, "fit": 1 / sqrt(2), "runout": 1 / sqrt(2), "radial": 1 / sqrt(3)}  # standard deviation over the largest shift
EVEN = "radial"  # how a field of no kind, or a bare tolerance, is spread


@formula("T_wc", "worst case: every part at the end of its field, on the line of centres", unit="µm")
def worst_case(T: Metre) -> Metre:
    return total(T) / 2


@formula("3σ_a", "root of squares of the standard deviations; k: that of each part over half its field, by its kind", unit="µm")
def three_deviations(k: Number, T: Metre) -> Metre:
    """k is 1/2 for a position, 1/√2 for a fit and a runout, 1/√3 for a radial shift: elementary, after their distributions."""
    return 3 * rss(k * T) / 2


@record
class Stack:
    """Fields of the parts of one mesh, each with its kind."""

    names: tuple[str, ...]
    kinds: tuple[str, ...]
    fields: Any  # an array, or the tuple of the inputs

    @property
    def spread(self) -> Any:
        from numpy import array

        return array([SPREAD[kind] for kind in self.kinds])


def stack_of(mesh: Mesh) -> Stack | None:
    """None where the parts are not given."""
    if mesh.stack:
        return Stack(tuple(c.name for c in mesh.stack), tuple(c.kind for c in mesh.stack), column(mesh.stack, "field"))
    if mesh.contributors:
        count = len(mesh.contributors)
        return Stack(tuple(f"part {i + 1}" for i in range(count)), (EVEN,) * count, column_of(mesh.contributors))
    return None


def column_of(numbers: tuple[float, ...]) -> Any:
    from numpy import array

    return array(numbers)


def centre_tolerance(mesh: Mesh) -> Metre:
    """± tolerance of the centre distance by which a mesh is judged: given, else the root of squares of its parts, else none."""
    if mesh.tolerance is not None:
        return mesh.tolerance
    stack = stack_of(mesh)
    return 0.0 if stack is None else tolerance_of_contributors(stack.fields)
