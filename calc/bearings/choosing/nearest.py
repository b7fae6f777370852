# SPDX-License-Identifier: Apache-2.0
"""The one row that is nearest to the design, found as `search` finds its first, without all the others beside it."""

from dataclasses import replace

from ...sheet.errors import NoSolution
from ...sheet.progress import Progress, part, tell
from .case import Case
from .ranking import Row
from .search import as_given, nearest_settled, nothing, short_fields
from .settling import slopes_of
from .variants import closer_fits, tasks, variants


def nearest_row(case: Case, progress: Progress | None = None) -> Row:
    """The nearest bearings that fit the room and hold in the whole design, in the order of `search`: at every corner of the tolerances,
    with closer fits, then as given where the tolerances are only assumed.

    Raises NoSolution with what comes nearest and what stops it.
    """
    tell(progress, 0.0, "bearings")
    bearings, offered, slopes = tasks(case), variants(case), slopes_of(case)
    closer = [[replace(one, fits=fits) for one in offered] for fits in closer_fits(case.bearings)]
    ways = [(offered, bearings), *((some, bearings) for some in closer)]
    if not case.bearings.fits_given:
        ways.append((offered, as_given(bearings)))
    dropped: list[str] = []
    for n, (some, asked) in enumerate(ways):
        every = short_fields(some, asked, slopes, part(progress, n / len(ways), (n + 0.8) / len(ways)))
        settled = nearest_settled(case, every, slopes, dropped)
        if settled is not None and settled.row is not None:
            return settled.row
    if dropped:
        raise NoSolution("no bearings pass in the whole design", "; ".join(dropped[:2]), "stiffen the shaft, or widen its envelope")
    raise nothing(every, slopes)
