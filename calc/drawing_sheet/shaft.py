# SPDX-License-Identifier: Apache-2.0
"""The sheet of the counter-shaft."""

from collections.abc import Mapping

from ..draw.shaft_outline import upwards
from ..countershaft.result import CountershaftResult
from ..sheet.text import EMPTY, Text
from ..solve import Results
from ..draw.workshop import end_view, kinds, section
from ..draw.sheet_data import PART_DRAWING, balance_rows, gear_rows, mass_rows, notes
from .facts import shaft_wheel, turned
from ..draw.annotations import Leaf
from .saying import Say, number
from .sheet import COLUMNS, Part, Sheet, composed, tables
from .side_view import OVER, SideView

MASS_COLUMNS = (32.0, 18.0, 20.0, 20.0, 22.0)
APART = 8.0  # one view from another


def shaft_sheet(results: Results, say: Say = str, data: Mapping[str, object] | None = None) -> Sheet | None:
    """The drawing of the counter-shaft; None where its outline is not known.  `data`: of the design's file, for what it leaves out."""
    solved, shaft = results.result(CountershaftResult), results.design.countershaft
    if solved is None or shaft is None or solved.outline is None:
        return None
    mass = say(Text("{m} kg", m=number(solved.mass, 2))) if solved.mass is not None else ""
    wheel = shaft_wheel(results)
    beside = tables((
        (say(Text("Gear data: {name}", name=wheel.name)) if wheel else EMPTY, gear_rows(results, wheel, say) if wheel else [], COLUMNS),
        (say(Text("Balancing")), balance_rows(results, solved, say), COLUMNS),
        (say(Text("Eccentric masses, cylinder 1 at TDC")), mass_rows(results, solved, say), MASS_COLUMNS),
    ))  # fmt: skip
    return composed(
        Part(title=results.design.name, material=shaft.material, mass=mass), lambda scale: _views(results, solved, scale, say), beside,
        notes(results, solved, upwards(solved.outline), data), results.design.control, say, PART_DRAWING,
    )  # fmt: skip


def _views(results: Results, solved: CountershaftResult, scale: float, say: Say) -> Leaf:
    """The side view with the end view to its right, and the sections in rows below them."""
    assert solved.outline is not None and results.design.countershaft is not None
    up, pieces, wheel = upwards(solved.outline), turned(results, solved), shaft_wheel(results)
    gear = wheel.reference_diameter if wheel is not None else None
    cut = kinds(pieces)
    views = Leaf()
    side = SideView(pieces, results.design.countershaft.bearing_positions, up, scale, say)
    views.add(side.draw({letter: (one.start + one.end) / 2 for letter, one in cut.items()}, gear))
    end = end_view(pieces, gear, up, scale)
    views.add(end, side.right + APART + OVER - end.extent[0], 0.0)
    left, y, right, _ = views.extent
    x, lowest = left, y
    for letter, one in cut.items():
        leaf = section(letter, one.piece, up, scale, say)
        box = leaf.extent
        under = scale * 1e3 * (one.start + one.end) / 2  # its cutting plane, if there is room
        at = min(max(x - box[0], under), max(right - box[2], x - box[0]))
        if at + box[2] > right + APART and x > left:
            x, y = left, lowest
            at = x - box[0]
        views.add(leaf, at, y - APART - box[3])
        x, lowest = at + box[2] + APART, min(lowest, y - APART - box[3] + box[1])
    return views
