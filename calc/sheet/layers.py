# SPDX-License-Identifier: Apache-2.0
"""The layers of a drawing sheet: how wide the lines of each are, of which dashes, and in which colour of a CAD program.

Line widths 0.5 and 0.25 mm are a line group of ISO 128-2; the frame's 0.7 mm is that of ISO 5457.  Dashes are millimetres on the paper,
above 0 drawn and below 0 left out.
"""

from .record import record

VISIBLE, EDGE, HIDDEN, CENTRE, HATCH, DIMENSION = "VISIBLE", "EDGE", "HIDDEN", "CENTRE", "HATCH", "DIMENSION"
CUT, TEXT, TABLE, FRAME = "CUT", "TEXT", "TABLE", "FRAME"


@record
class Layer:
    """One layer.  `colour`: its number in the palette of DXF; on paper all are black."""

    width: float  # mm
    dashes: tuple[float, ...] = ()
    colour: int = 7


LAYERS = {
    VISIBLE: Layer(0.5),
    EDGE: Layer(0.25, (), 8),  # continuous and narrow: roots of teeth, hands of helices
    HIDDEN: Layer(0.25, (3.0, -0.75), 4),
    CENTRE: Layer(0.25, (7.0, -1.0, 0.6, -1.0), 1),
    HATCH: Layer(0.25, (), 9),
    DIMENSION: Layer(0.25, (), 3),
    CUT: Layer(0.5, (), 6),  # ends of cutting planes
    TEXT: Layer(0.25),
    TABLE: Layer(0.25, (), 8),
    FRAME: Layer(0.7),
}
