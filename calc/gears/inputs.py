# SPDX-License-Identifier: Apache-2.0
"""The gear train: one reference profile, its wheels, its meshes."""

import math
from collections.abc import Iterable

from ..sheet.quantity import inputs, integer, quantity, series, tables, text


@inputs
class Wheel:
    """One wheel of the train."""

    name: str = text("Name")
    teeth: int = integer("Teeth", low=5, high=1000, symbol="z")
    profile_shift: float = quantity(
        "Profile shift coefficient", optional=True, low=-3, high=3, symbol="x", step=0.01,
        help="In normal modules. Left out: from a centre distance, else that of a wheel with as many teeth, else 0.",
    )  # fmt: skip
    tip_shortening: float = quantity("Tip cut (radial)", "mm", default=0.0, low=0, high=50, symbol="k")
    face_width: float = quantity("Face width", "mm", optional=True, above=0, high=2000, symbol="b", help="Left out: that of the train.")
    material: str = text("Material", default="steel")
    span_teeth: int = integer("Teeth spanned", optional=True, low=1, high=200, symbol="K", help="Left out: the best number.")
    span_allowance: tuple[float, ...] | None = series(
        "Allowance of the span", "µm", optional=True, count=(2, 2), low=-5000, high=5000, symbol="E_W",
        help="[upper, lower]: change of the base tangent length; −20, −30 shaved or ground, −40, −50 hobbed only. Left out: none.",
    )  # fmt: skip

    def problems(self) -> Iterable[tuple[str, str]]:
        if self.span_allowance is not None and len(self.span_allowance) == 2 and self.span_allowance[0] < self.span_allowance[1]:
            yield "span_allowance_um", "is [upper, lower]: the first must not be below the second"


@inputs
class Mesh:
    """Two wheels in mesh."""

    driver: str = text("Driver")
    driven: str = text("Driven")
    centre_distance: float = quantity(
        "Centre distance",
        "mm",
        optional=True,
        above=0,
        high=5000,
        symbol="a_w",
        help="Left out: without backlash, from the profile shifts.",
    )
    tolerance: float = quantity(
        "Tolerance of the centre distance (±)", "µm", optional=True, low=0, high=5000, symbol="T_a", help="Half the field."
    )
    contributors: tuple[float, ...] | None = series(
        "Contributors to the tolerance",
        "mm",
        optional=True,
        low=0,
        high=10,
        help="Fields of the parts between the centres; half their root of squares is the tolerance.",
    )

    def problems(self) -> Iterable[tuple[str, str]]:
        if self.tolerance is not None and self.contributors is not None:
            yield "contributors_mm", "give either tolerance_um or contributors_mm"
        if self.driver == self.driven:
            yield "driven", "a wheel can not drive itself"


@inputs
class GearsInputs:
    """The reference profile, the wheels and the meshes along the flow of power."""

    normal_module: float = quantity("Normal module", "mm", above=0, high=100, symbol="m_n", step=0.25)
    pressure_angle: float = quantity("Pressure angle (normal)", "°", low=10, high=35, symbol="alpha_n", default=math.radians(20))
    helix_angle: float = quantity("Helix angle", "°", low=0, high=35, symbol="beta", default=0.0)
    face_width: float = quantity("Face width", "mm", above=0, high=2000, symbol="b")
    tool_addendum: float = quantity(
        "Tool addendum", default=1.25, low=0.5, high=3, symbol="h_aP0", step=0.05, help="In modules; makes the root."
    )
    tool_tip_radius: float = quantity(
        "Tool tip radius", default=0.38, low=0, high=1, symbol="rho_aP0", step=0.02, help="In modules; makes the fillet."
    )
    ball_diameter: float = quantity(
        "Measuring ball", "mm", optional=True, above=0, high=200, symbol="D_M", help="Left out: the ideal ball of each wheel."
    )
    iso_6336_edition: int = integer("ISO 6336 edition", default=2006, low=2006, high=2019, help="2006 or 2019.")
    speed: float = quantity(
        "Speed of the first driver", "rpm", optional=True, above=0, high=100000, symbol="n", help="Left out: the crank's rated speed."
    )
    power: float = quantity(
        "Power of the first driver", "kW", optional=True, above=0, high=1e5, symbol="P", help="Left out: from the closed power balance."
    )
    wheels: tuple[Wheel, ...] = tables("Wheels", Wheel)
    meshes: tuple[Mesh, ...] = tables("Meshes", Mesh)

    def problems(self) -> Iterable[tuple[str, str]]:
        if self.iso_6336_edition not in (2006, 2019):
            yield "iso_6336_edition", "must be 2006 or 2019"
        if not self.meshes:
            yield "meshes", "needs at least one [[gears.meshes]]"
        names = [w.name for w in self.wheels]
        driven: set[str] = set()
        for i, mesh in enumerate(self.meshes):
            for key, name in (("driver", mesh.driver), ("driven", mesh.driven)):
                if name not in names:
                    yield f"meshes.{i}.{key}", f'there is no wheel "{name}"; the wheels are {", ".join(names)}'
            if i and mesh.driver not in driven | {self.meshes[0].driver}:
                yield f"meshes.{i}.driver", "must be driven by an earlier mesh: meshes are listed along the flow of power"
            if mesh.driven in driven | {self.meshes[0].driver}:
                yield f"meshes.{i}.driven", "is driven already: each wheel has one driver"
            driven.add(mesh.driven)
        for i, name in enumerate(names):
            if self.meshes and name not in driven | {self.meshes[0].driver}:
                yield f"wheels.{i}.name", f'no mesh uses the wheel "{name}"'
