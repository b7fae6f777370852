# SPDX-License-Identifier: Apache-2.0
"""What a mesh is described by: its two wheels, their centre distance, and the parts that make its tolerance."""

from collections.abc import Iterable
from typing import ClassVar

from ..sheet.quantity import THUMB, choice, inputs, quantity, series, tables, text
from ..sheet.text import Text
from .wheel_inputs import INTERNAL, REFUSED


@inputs
class Contributor:
    """One part of the chain between two centres."""

    name: str = text("Name")
    field: float = quantity("Field", "mm", low=0, high=10, symbol="T", usual=(0.01, 0.1), source=THUMB,
        help="Its whole width, as on the drawing.")  # fmt: skip
    kind: str = choice("Kind", "position", "fit", "runout", "radial", default="position",
        help="position: diameter of its zone. fit: largest clearance, diametral. runout: over a turn. radial: whole width of a shift."
    )  # fmt: skip


@inputs
class Mesh:
    """Two wheels in mesh."""

    REFUSED: ClassVar[dict[str, Text]] = REFUSED

    driver: str = text("Driver", help="The wheel nearer to the crank.")
    driven: str = text("Driven", help="The wheel that it drives.")
    centre_distance: float | None = quantity("Centre distance", "mm", default=None, above=0, high=5000, symbol="a_w", source="ISO 21771",
        negative=INTERNAL, help="Distance of the two axes. Left out: without backlash, from the profile shifts.")  # fmt: skip
    tolerance: float | None = quantity("Tolerance of the centre distance (±)", "µm", default=None, low=0, high=5000, symbol="T_a",
        usual=(10, 100), source=THUMB, help="Half the field, to either side.")  # fmt: skip
    contributors: tuple[float, ...] | None = series("Contributors to the tolerance", "mm", default=None, low=0, high=10, usual=(0.01, 0.1),
        source=THUMB, help="Fields of the parts; half their root of squares.")  # fmt: skip
    support_share: float | None = quantity("Share of the support", default=None, low=0, high=1, symbol="lambda_S",
        help="Share of the distance that gears.support_material spans; the housing spans the rest.")  # fmt: skip
    mesh_misalignment: float | None = quantity("Mesh misalignment by manufacture", "µm", default=None, low=0, high=500, symbol="f_ma",
        usual=(0, 30), source=THUMB, help="Over the face width. Left out: by the accuracy grade.")  # fmt: skip
    shaft_deflection: float | None = quantity("Misalignment by bending", "µm", default=None, low=0, high=500, symbol="f_sh", usual=(0, 30),
        source=THUMB, help="Over the face width. Left out: none.")  # fmt: skip
    stack: tuple[Contributor, ...] = tables("Parts between the centres", Contributor, default=(),
        help="Each with its kind: worst case, root of squares and by chance, side by side.")  # fmt: skip

    @property
    def key(self) -> str:
        """What its values are called by."""
        return f"{self.driver}_{self.driven}"

    @property
    def title(self) -> str:
        """What it is called in sentences."""
        return f"{self.driver}–{self.driven}"

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.tolerance is not None and self.contributors is not None:
            yield "contributors_mm", Text("give either tolerance_um or contributors_mm")
        if self.contributors is not None and self.stack:
            yield "stack", Text("give either contributors_mm or stack")
        if self.driver == self.driven:
            yield "driven", Text("a wheel can not drive itself")
