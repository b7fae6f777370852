# SPDX-License-Identifier: Apache-2.0
"""Figures drawn by a copy of this process, while it makes the rest.

The copy is told what to draw and sends recordings back; what draws them, which takes longest to load, is not loaded
here."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from calc.sheet.deferred import prepared

if TYPE_CHECKING:
    from ..typesetting.pen import Recording
    from .plots import Draughtsman, Job


def draughtsman() -> Draughtsman:
    """One who draws the figures of one report: given its language and all of them, begins; hands them over when they
    are asked for."""
    return prepared(_ready)


def _ready() -> Callable[[tuple[str, list[Job]]], list[Recording]]:
    import matplotlib.backend_bases
    import matplotlib.figure  # noqa: F401

    from calc.locale import language

    from ..typesetting.fonts import FACES, widths
    from .plots import Plots, plot

    for face in FACES:
        widths(face)

    def draw(asked: tuple[str, list[Job]]) -> list[Recording]:
        lang, jobs = asked
        plots = Plots(language(lang))
        return [plot(plots, *job) for job in jobs]

    return draw
