# SPDX-License-Identifier: Apache-2.0
"""The gear train: one tool, its wheels, its meshes, and what stands around them.

Axes of positions: the first is up, the second 90° further in the sense of crank rotation, both from the crank's axis.
"""

import math
from collections.abc import Iterable

from ..sheet.quantity import choice, inputs, integer, quantity, series, tables, text


@inputs
class Wheel:
    """One wheel of the train."""

    name: str = text("Name")
    teeth: int = integer("Teeth", low=5, high=1000, symbol="z")
    profile_shift: float = quantity(
        "Profile shift coefficient", optional=True, low=-3, high=3, symbol="x", step=0.01,
        help="In normal modules. Left out: from a centre distance, else that of a wheel with as many teeth, else 0.",
    )  # fmt: skip
    tip_shortening: float = quantity(
        "Tip cut (radial)", "mm", default=0.0, low=0, high=50, symbol="k", help="Off the tip radius; eases the mate's dedendum."
    )
    face_width: float = quantity("Face width", "mm", optional=True, above=0, high=2000, symbol="b", help="Left out: that of the train.")
    hand: str | None = choice(
        "Hand of the helix",
        "left",
        "right",
        optional=True,
        help="Hands alternate. Left out: the first driver is right-handed.",
    )
    material: str = text("Material", default="steel", help="By which it yields and expands.")
    span_teeth: int = integer("Teeth spanned", optional=True, low=1, high=200, symbol="K", help="Left out: the best number.")
    span_allowance: tuple[float, ...] | None = series(
        "Allowance of the span", "µm", optional=True, count=(2, 2), low=-5000, high=5000, symbol="E_W",
        help="[upper, lower]: change of the base tangent length; −20, −30 shaved or ground, −40, −50 hobbed only. Left out: none.",
    )  # fmt: skip
    tip_diameter_tolerance: tuple[float, ...] | None = series(
        "Tolerance of the tip diameter", "µm", optional=True, count=(2, 2), low=-5000, high=5000, help="[upper, lower]; 0, −100 is usual."
    )
    root_diameter_tolerance: tuple[float, ...] | None = series(
        "Tolerance of the root diameter", "µm", optional=True, count=(2, 2), low=-5000, high=5000,
        help="[upper, lower]; 0, −300 is usual. Beside what the allowance of the span changes.",
    )  # fmt: skip
    runout: float = quantity(
        "Runout of the teeth",
        "µm",
        optional=True,
        low=0,
        high=2000,
        symbol="F_r",
        help="Over a turn; half of it to each side of the centre.",
    )
    measured_span: float = quantity(
        "Measured span", "mm", optional=True, above=0, high=5000, symbol="W", help="Over the teeth spanned; gives the tooth that was made."
    )
    measured_over_balls: float = quantity(
        "Measured size over balls", "mm", optional=True, above=0, high=10000, symbol="M_dK", help="Over gears.ball_diameter_mm."
    )
    measured_over_pins: float = quantity("Measured size over pins", "mm", optional=True, above=0, high=10000, symbol="M_dR",
        help="Between faces parallel to the axis: two opposite pins, of an odd helical wheel three.",
    )  # fmt: skip
    measured_chordal_thickness: float = quantity(
        "Measured chordal thickness", "mm", optional=True, above=0, high=500, symbol="s_c", help="Normal, at the height above the chord."
    )
    position: tuple[float, ...] | None = series(
        "Position of its axis", "mm", optional=True, count=(2, 2), low=-5000, high=5000,
        help="[up, side] from the crank's axis, side: 90° on in the sense of crank rotation. Left out: from two neighbours, if it can be.",
    )  # fmt: skip
    bore_diameter: float = quantity(
        "Bore", "mm", optional=True, above=0, high=2000, symbol="d_i", help="Of the body, for its inertia. Left out: a solid disc."
    )
    rim_thickness: float = quantity(
        "Rim thickness", "mm", optional=True, above=0, high=500, symbol="s_R", help="Below the root circle. Left out: a solid body."
    )
    gear_material: str | None = text(
        "Strength class", optional=True, help="A row of the table of ISO 6336-5; left out: case-hardened steel, and said so."
    )
    quality: str = choice("Material quality", "ML", "MQ", "ME", default="MQ", help="Of ISO 6336-5.")
    hardness: float = quantity(
        "Surface hardness", "HV", optional=True, above=0, high=1200, symbol="HV", help="For classes whose strength depends on it."
    )

    def problems(self) -> Iterable[tuple[str, str]]:
        for key, limits in (
            ("span_allowance_um", self.span_allowance), ("tip_diameter_tolerance_um", self.tip_diameter_tolerance),
            ("root_diameter_tolerance_um", self.root_diameter_tolerance),
        ):  # fmt: skip
            if limits is not None and len(limits) == 2 and limits[0] < limits[1]:
                yield key, "is [upper, lower]: the first must not be below the second"


@inputs
class Contributor:
    """One part of the chain between two centres."""

    name: str = text("Name")
    field: float = quantity("Field", "mm", low=0, high=10, symbol="T", help="Its whole width, as on the drawing.")
    kind: str = choice(
        "Kind", "position", "fit", "runout", "radial", default="position",
        help="position: diameter of its zone. fit: largest clearance, diametral. runout: over a turn. radial: whole width of a shift.",
    )  # fmt: skip


@inputs
class Mesh:
    """Two wheels in mesh."""

    driver: str = text("Driver", help="The wheel nearer to the crank.")
    driven: str = text("Driven", help="The wheel that it drives.")
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
        "Contributors to the tolerance", "mm", optional=True, low=0, high=10,
        help="Fields of the parts between the centres; half their root of squares is the tolerance.",
    )  # fmt: skip
    support_share: float | None = quantity(
        "Share of the support", optional=True, low=0, high=1, symbol="lambda_S",
        help="Of the centre distance, that the support (gears.support_material) spans; the housing spans the rest.",
    )  # fmt: skip
    mesh_misalignment: float = quantity(
        "Mesh misalignment by manufacture", "µm", optional=True, low=0, high=500, symbol="f_ma", help="Left out: from the accuracy grade."
    )
    shaft_deflection: float | None = quantity(
        "Misalignment by bending",
        "µm",
        optional=True,
        low=0,
        high=500,
        symbol="f_sh",
        help="Over the face width, under load. Left out: none.",
    )
    stack: tuple[Contributor, ...] = tables(
        "Parts between the centres",
        Contributor,
        optional=True,
        help="Each with its kind: worst case, root of squares and by chance, side by side.",
    )

    def problems(self) -> Iterable[tuple[str, str]]:
        if self.tolerance is not None and self.contributors is not None:
            yield "contributors_mm", "give either tolerance_um or contributors_mm"
        if self.contributors is not None and self.stack:
            yield "stack", "give either contributors_mm or stack"
        if self.driver == self.driven:
            yield "driven", "a wheel can not drive itself"


@inputs
class Neighbour:
    """Something round beside the wheels: a screw, an oil gallery, a hub."""

    name: str = text("Name")
    position: tuple[float, ...] = series("Position", "mm", count=(2, 2), low=-5000, high=5000, help="[up, side] from the crank's axis.")
    radius: float = quantity("Radius", "mm", above=0, high=5000, symbol="r")


@inputs
class Wall:
    """A straight wall beside the wheels: a cover, a rib."""

    name: str = text("Name")
    from_: tuple[float, ...] = series("From", "mm", count=(2, 2), low=-5000, high=5000, help="[up, side] from the crank's axis.")
    to: tuple[float, ...] = series("To", "mm", count=(2, 2), low=-5000, high=5000, help="[up, side] from the crank's axis.")

    def problems(self) -> Iterable[tuple[str, str]]:
        if self.from_ == self.to:
            yield "to_mm", "is the same point as from_mm: a wall needs a length"


@inputs
class GearsInputs:
    """The tool, the wheels and the meshes along the flow of power."""

    normal_module: float = quantity(
        "Normal module", "mm", above=0, high=100, symbol="m_n", step=0.25, help="Pitch over π, normal to the teeth."
    )
    pressure_angle: float = quantity("Pressure angle (normal)", "°", low=10, high=35, symbol="alpha_n", default=math.radians(20))
    helix_angle: float = quantity(
        "Helix angle", "°", low=0, high=35, symbol="beta", default=0.0, help="At the reference circle; 0: spur wheels."
    )
    face_width: float = quantity("Face width", "mm", above=0, high=2000, symbol="b", help="Of all wheels that give none of their own.")
    tool_addendum: float = quantity(
        "Tool addendum", default=1.25, low=0.5, high=3, symbol="h_aP0", step=0.05, help="In modules; makes the root."
    )
    tool_tip_radius: float = quantity(
        "Tool tip radius", default=0.38, low=0, high=1, symbol="rho_aP0", step=0.02, help="In modules; makes the fillet."
    )
    protuberance: float = quantity(
        "Protuberance of the tool", "mm", default=0.0, low=0, high=10, symbol="pr_P0", help="How far its tip stands out of its flank."
    )
    stock: float = quantity(
        "Stock left on the flanks",
        "mm",
        default=0.0,
        low=0,
        high=10,
        symbol="q",
        help="Normal to the flank, for shaving or grinding; the root keeps it.",
    )
    ball_diameter: float = quantity(
        "Measuring ball",
        "mm",
        optional=True,
        above=0,
        high=200,
        symbol="D_M",
        help="Or pin. Left out: for each wheel the preferred one that touches nearest to the middle of its flank.",
    )
    iso_6336_edition: int = integer("ISO 6336 edition", default=2006, low=2006, high=2019, help="2006 or 2019.")
    application_factor: float = quantity(
        "Application factor", optional=True, low=1, high=5, symbol="K_A", step=0.05,
        help="Left out: 1 where the torque of the crank's irregularity is known and added, else 1.25.",
    )  # fmt: skip
    accuracy_grade: int = integer(
        "Accuracy grade (ISO 1328-1)",
        default=7,
        low=1,
        high=11,
        symbol="A",
        help="Of pitch, profile and helix; smaller is finer: 5 ground, 7 shaved, 9 hobbed.",
    )
    life: float = quantity(
        "Life", "h", optional=True, above=0, high=1e6, symbol="L_h", help="Left out: without end; life factors of the endurance limit."
    )
    tip_relief: float = quantity(
        "Tip relief", "µm", optional=True, low=0, high=500, symbol="C_a",
        help="Ground off the tips, for the dynamic factor of grades up to 5. Left out: what running in makes.",
    )  # fmt: skip
    flank_rz: float = quantity(
        "Flank roughness Rz",
        "µm",
        optional=True,
        above=0,
        high=100,
        symbol="Rz_H",
        help="Left out: six times friction.flank_roughness_um, else 4.",
    )
    root_rz: float = quantity(
        "Root roughness Rz", "µm", default=16e-6, above=0, high=200, symbol="Rz_F", help="Of the fillets, for the strength of the root."
    )
    scuffing_load_stage: float = quantity(
        "FZG load stage of the oil", optional=True, low=1, high=14, symbol="S_FZG",
        help="Scuffing test A/8.3/90. Left out: stage 10 is assumed.",
    )  # fmt: skip
    permissible_film: float = quantity(
        "Permissible specific film",
        optional=True,
        above=0,
        high=10,
        symbol="lambda_GFP",
        help="λ_GFP from a micropitting test of the oil. Left out: 0.3, a rule.",
    )
    lubrication: str = choice("Lubrication", "spray", "dip", "submerged", default="spray", help="How the oil comes to the teeth.")
    housing_material: str | None = text(
        "Housing material", optional=True, help="Between the centres. Left out: that of the bearings, else as the wheels."
    )
    support_material: str | None = text("Support material", optional=True, help="Of the part of a centre distance that a support spans.")
    lowest_temperature: float = quantity(
        "Lowest temperature", "°C", default=-30.0, low=-60, high=60, symbol="T_min", help="All parts, cold start."
    )
    running_temperature: float = quantity(
        "Running temperature of the housing",
        "°C",
        default=100.0,
        low=0,
        high=200,
        symbol="T_H",
        help="At which the warm backlash is taken.",
    )
    wheels_warmer: float = quantity(
        "Wheels warmer than the housing",
        "K",
        default=20.0,
        low=0,
        high=150,
        symbol="Delta_T",
        help="They take backlash where the housing grows less.",
    )
    speed: float = quantity(
        "Speed of the first driver", "rpm", optional=True, above=0, high=100000, symbol="n", help="Left out: the crank's rated speed."
    )
    power: float = quantity(
        "Power of the first driver", "kW", optional=True, above=0, high=1e5, symbol="P", help="Left out: from the closed power balance."
    )
    speed_irregularity: float = quantity(
        "Irregularity of the first driver's speed", optional=True, low=0, high=1, symbol="delta_s", step=0.005,
        help="(largest − smallest)/mean. Left out: the engine's, where its gas and flywheel_inertia_kgm2 are given.",
    )  # fmt: skip
    irregularity_order: float = quantity(
        "Order of the irregularity",
        optional=True,
        above=0,
        high=50,
        symbol="i",
        help="Of the turns of the first driver. Left out: the engine's firing order.",
    )
    tooth_angle: float = quantity(
        "Tooth of the first driver", "°", default=0.0, low=-360, high=360, symbol="gamma_1",
        help="Direction of the middle of one of its teeth, cylinder 1 at TDC, from up in the sense of crank rotation.",
    )  # fmt: skip
    source_sheet: str = choice(
        "Sheet to compare with", "none", "finotti", default="none",
        help="finotti: what the calculation sheet of Finotti 2013 gives, with what is wrong in it.",
    )  # fmt: skip
    wheels: tuple[Wheel, ...] = tables("Wheels", Wheel)
    meshes: tuple[Mesh, ...] = tables("Meshes", Mesh)
    neighbours: tuple[Neighbour, ...] = tables(
        "Neighbours", Neighbour, optional=True, help="Screws, oil galleries: the wheels must clear them."
    )
    walls: tuple[Wall, ...] = tables("Walls", Wall, optional=True, help="Covers, ribs: the wheels must clear them.")

    def problems(self) -> Iterable[tuple[str, str]]:
        if self.iso_6336_edition not in (2006, 2019):
            yield "iso_6336_edition", "must be 2006 or 2019"
        if not self.meshes:
            yield "meshes", "needs at least one [[gears.meshes]]"
        for i, wheel in enumerate(self.wheels):
            for key, size in (("measured_over_balls_mm", wheel.measured_over_balls), ("measured_over_pins_mm", wheel.measured_over_pins)):
                if size is not None and self.ball_diameter is None:
                    yield f"wheels.{i}.{key}", "needs gears.ball_diameter_mm, the ball or pin that was used"
            if wheel.measured_span is not None and wheel.span_teeth is None:
                yield f"wheels.{i}.measured_span_mm", "needs span_teeth, over which it was measured"
        yield from self._flow()
        yield from self._hands()
        if self.support_material is None:
            for i, mesh in enumerate(self.meshes):
                if mesh.support_share:
                    yield f"meshes.{i}.support_share", "needs gears.support_material"

    def _flow(self) -> Iterable[tuple[str, str]]:
        """Every wheel is driven once, and the meshes stand along the flow of power."""
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

    def hands(self) -> dict[str, str]:
        """The hand of every helical wheel: they alternate from the first that is given, else the first driver is right-handed."""
        if not self.helix_angle or not self.meshes:
            return {}
        turned = {self.meshes[0].driver: 0}
        for mesh in self.meshes:
            turned[mesh.driven] = 1 - turned.get(mesh.driver, 0)
        sides = ("left", "right")
        first = next((w for w in self.wheels if w.hand is not None and w.name in turned), None)
        base = 1 if first is None else (sides.index(str(first.hand)) + turned[first.name]) % 2
        return {name: sides[(base + n) % 2] for name, n in turned.items()}

    def _hands(self) -> Iterable[tuple[str, str]]:
        """External helical wheels in mesh have opposite hands."""
        hands = self.hands()
        for i, wheel in enumerate(self.wheels):
            if wheel.hand is not None and wheel.hand != hands.get(wheel.name, wheel.hand):
                yield f"wheels.{i}.hand", f"must be {hands[wheel.name]}: the hands of a train alternate"
