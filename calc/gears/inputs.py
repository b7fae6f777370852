# SPDX-License-Identifier: Apache-2.0
"""What the gear train is described by: its wheels, its meshes, one tool, and what stands around them.

Axes of positions: the first is up, the second 90° further in the sense of crank rotation, both from the crank's axis.
"""

import math
from collections.abc import Iterable
from typing import ClassVar

from ..sheet.quantity import THUMB, choice, dotted, inputs, integer, keys, quantity, series, tables, text
from ..sheet.text import Text

__all__ = ["Contributor", "GearsInputs", "Mesh", "Neighbour", "Wall", "Wheel", "mesh_key", "wheel_key"]


# --- a wheel: its teeth, their allowances, what was measured on them, its body and material

INTERNAL = Text(
    "internal gears are not computed: contact, interference, the form of the root and its strength are those of two "
    "external wheels here; "
    "external wheels have 5 teeth or more and a positive centre distance"
)

# keys that others have for them
REFUSED = dict.fromkeys(("internal", "internal_teeth", "ring", "ring_gear", "annulus"), INTERNAL)

# the folds of the form
WHEELS = Text("More of the wheels")
MESHES = Text("More of the meshes")


@inputs
class Wheel:
    """One wheel of the train."""

    REFUSED: ClassVar[dict[str, Text]] = REFUSED

    name: str = text("Name", decides=4)
    teeth: int = integer(
        "Teeth",
        within=(5, 1000),
        symbol="z",
        usual=(17, 100),
        source=THUMB,
        negative=INTERNAL,
        help="Number of teeth; few of them are undercut.",
        change=("fewer teeth", "more teeth"),
        repair="free",
        decides=5,
    )
    profile_shift: float | None = quantity(
        "Profile shift coefficient",
        default=None,
        within=(-3, 3),
        symbol="x",
        step=0.01,
        usual=(-0.5, 1),
        source=THUMB,
        help="In modules. Left out: by centre distance, like wheel, or 0.",
        change=("less profile shift", "more profile shift"),
        repair="free",
        brief="profile shift",
        decides=6,
    )
    tip_shortening: float = quantity(
        "Tip cut (radial)",
        "mm",
        default=0.0,
        within=(0, 50),
        symbol="k",
        source="Finotti 2013, 4.5.1",
        help="Off the tip radius; eases the mate's dedendum.",
        change=("smaller tip cut", "larger tip cut"),
        repair="free",
    )
    face_width: float | None = quantity(
        "Face width",
        "mm",
        default=None,
        within=(0.1, 2000),
        symbol="b",
        help="Width of this wheel. Left out: that of the train.",
        change=("narrower gears", "wider gears"),
    )
    hand: str | None = choice(
        "Hand of the helix",
        "left",
        "right",
        default=None,
        help="Hands alternate. Left out: the first driver is right-handed.",
    )
    material: str = text("Material", default="steel", help="By which it yields and expands.", catalogue="materials")
    span_teeth: int | None = integer(
        "Teeth spanned",
        default=None,
        within=(1, 200),
        symbol="K",
        source="ISO 21771",
        help="Teeth over which the span is measured. Left out: the best number.",
    )
    span_allowance: tuple[float, ...] | None = series(
        "Allowance of the span",
        "µm",
        default=None,
        count=(2, 2),
        within=(-5000, 5000),
        symbol="E_W",
        usual=(-50, -20),
        source="Finotti 2013, 4.5.1",
        help="[upper, lower] of W: −20, −30 shaved, −40, −50 hobbed.",
        change=("thinner teeth", "thicker teeth"),
        repair="free",
        brief="span allowance",
        decides=7,
    )
    tip_diameter_tolerance: tuple[float, ...] | None = series(
        "Tolerance of the tip diameter",
        "µm",
        default=None,
        count=(2, 2),
        within=(-5000, 5000),
        usual=(-100, 0),
        source="Finotti 2013, 4.5.2",
        help="[upper, lower] of the tip diameter.",
        change=("smaller tips", "larger tips"),
        repair="free",
    )
    root_diameter_tolerance: tuple[float, ...] | None = series(
        "Tolerance of the root diameter",
        "µm",
        default=None,
        count=(2, 2),
        within=(-5000, 5000),
        usual=(-300, 0),
        source="Finotti 2013, 4.5.2",
        help="[upper, lower], beside the span's allowance.",
    )
    runout: float | None = quantity(
        "Runout of the teeth",
        "µm",
        default=None,
        within=(0, 2000),
        symbol="F_r",
        usual=(5, 80),
        source=THUMB,
        help="Over a turn; half of it to each side of the centre.",
        change=("less runout", "more runout"),
    )
    measured_span: float | None = quantity(
        "Measured span",
        "mm",
        default=None,
        above=0,
        high=5000,
        symbol="W",
        source="ISO 21771",
        help="Over the teeth spanned; gives the tooth that was made.",
    )
    measured_over_balls: float | None = quantity(
        "Measured size over balls",
        "mm",
        default=None,
        above=0,
        high=10000,
        symbol="M_dK",
        source="ISO 21771",
        help="Over two balls of gears.ball_diameter_mm; gives the tooth that was made.",
    )
    measured_over_pins: float | None = quantity(
        "Measured size over pins",
        "mm",
        default=None,
        above=0,
        high=10000,
        symbol="M_dR",
        source="ISO 21771",
        help="Between faces parallel to the axis: two opposite pins, of an odd helical wheel three.",
    )
    measured_chordal_thickness: float | None = quantity(
        "Measured chordal thickness",
        "mm",
        default=None,
        above=0,
        high=500,
        symbol="s_c",
        source="ISO 21771",
        help="Normal, at the height above the chord.",
    )
    position: tuple[float, ...] | None = series(
        "Position of its axis",
        "mm",
        default=None,
        count=(2, 2),
        within=(-5000, 5000),
        help="[up, side] from the crank's axis, side: 90° on in the sense of crank rotation. Left out: from two "
        "neighbours, if it can be.",
        change=("wheel elsewhere", "wheel elsewhere"),
        repair="asked",
    )
    bore_diameter: float | None = quantity(
        "Bore",
        "mm",
        default=None,
        above=0,
        high=2000,
        symbol="d_i",
        help="Diameter of the bore of the body, for its inertia. Left out: a solid disc.",
    )
    rim_thickness: float | None = quantity(
        "Rim thickness",
        "mm",
        default=None,
        above=0,
        high=500,
        symbol="s_R",
        source="ISO 6336-3",
        help="Below the root circle; from 1.2 tooth depths on it costs no strength. Left out: a solid body.",
        repair="free",
    )
    gear_material: str | None = text(
        "Strength class",
        default=None,
        help="A row of the table of ISO 6336-5; left out: case-hardened steel, and said so.",
        change=("softer teeth", "harder teeth", "stronger teeth"),
        catalogue="strength_classes",
    )
    quality: str = choice(
        "Material quality",
        "ML",
        "MQ",
        "ME",
        default="MQ",
        help="Of ISO 6336-5.",
        change=("softer teeth", "harder teeth", "stronger teeth"),
    )
    hardness: float | None = quantity(
        "Surface hardness",
        "HV",
        default=None,
        above=0,
        high=1200,
        symbol="HV",
        usual=(115, 900),
        source="ISO 6336-5:2016, Table 1",
        help="For classes whose strength depends on it.",
        change=("softer teeth", "harder teeth", "stronger teeth"),
        repair="free",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        for key, limits in (
            (dotted(Wheel.span_allowance), self.span_allowance),
            (dotted(Wheel.tip_diameter_tolerance), self.tip_diameter_tolerance),
            (dotted(Wheel.root_diameter_tolerance), self.root_diameter_tolerance),
        ):
            if limits is not None and len(limits) == 2 and limits[0] < limits[1]:
                yield key, Text("is [upper, lower]: the first must not be below the second")


# --- a mesh: its two wheels, their centre distance, and the parts that make its tolerance


@inputs
class Contributor:
    """One part of the chain between two centres."""

    name: str = text("Name")
    field: float = quantity(
        "Field",
        "mm",
        within=(0, 10),
        symbol="T",
        usual=(0.01, 0.1),
        source=THUMB,
        help="Its whole width, as on the drawing.",
    )
    kind: str = choice(
        "Kind",
        "position",
        "fit",
        "runout",
        "radial",
        default="position",
        help="position: diameter of its zone. fit: largest clearance, diametral. runout: over a turn. radial: whole "
        "width of a shift.",
    )


@inputs
class Mesh:
    """Two wheels in mesh."""

    REFUSED: ClassVar[dict[str, Text]] = REFUSED

    driver: str = text("Driver", help="The wheel nearer to the crank.", decides=8)
    driven: str = text("Driven", help="The wheel that it drives.", decides=9)
    centre_distance: float | None = quantity(
        "Centre distance",
        "mm",
        default=None,
        above=0,
        high=5000,
        symbol="a_w",
        source="ISO 21771",
        negative=INTERNAL,
        help="Distance of the two axes. Left out: without backlash, from the profile shifts.",
        change=("closer centres", "wider centres"),
        repair="free",
        decides=10,
    )
    tolerance: float | None = quantity(
        "Tolerance of the centre distance (±)",
        "µm",
        default=None,
        within=(0, 5000),
        symbol="T_a",
        usual=(10, 100),
        source=THUMB,
        help="Half the field, to either side.",
        change=("closer tolerance", "wider tolerance"),
        repair="free",
        decides=11,
    )
    contributors: tuple[float, ...] | None = series(
        "Contributors to the tolerance",
        "mm",
        default=None,
        within=(0, 10),
        usual=(0.01, 0.1),
        source=THUMB,
        help="Fields of the parts; half their root of squares.",
    )
    support_share: float | None = quantity(
        "Share of the support",
        default=None,
        within=(0, 1),
        symbol="lambda_S",
        help="Share of the distance that gears.support_material spans; the housing spans the rest.",
    )
    mesh_misalignment: float | None = quantity(
        "Mesh misalignment by manufacture",
        "µm",
        default=None,
        within=(0, 500),
        symbol="f_ma",
        usual=(0, 30),
        source=THUMB,
        help="Over the face width. Left out: by the accuracy grade.",
    )
    shaft_deflection: float | None = quantity(
        "Misalignment by bending",
        "µm",
        default=None,
        within=(0, 500),
        symbol="f_sh",
        usual=(0, 30),
        source=THUMB,
        help="Over the face width. Left out: none.",
    )
    stack: tuple[Contributor, ...] = tables(
        "Parts between the centres",
        Contributor,
        default=(),
        help="Each with its kind: worst case, root of squares and by chance, side by side.",
    )

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
            yield dotted(Mesh.contributors), Text("give either tolerance_um or contributors_mm")
        if self.contributors is not None and self.stack:
            yield dotted(Mesh.stack), Text("give either contributors_mm or stack")
        if self.driver == self.driven:
            yield dotted(Mesh.driven), Text("a wheel can not drive itself")


# --- the train, and what stands around it


@inputs
class Neighbour:
    """Something round beside the wheels: a screw, an oil gallery, a hub."""

    name: str = text("Name")
    position: tuple[float, ...] = series(
        "Position",
        "mm",
        count=(2, 2),
        within=(-5000, 5000),
        help="[up, side] from the crank's axis.",
        repair="asked",
    )
    radius: float = quantity(
        "Radius", "mm", above=0, high=5000, symbol="r", help="Radius of the round thing that the wheels must clear."
    )


@inputs
class Wall:
    """A straight wall beside the wheels: a cover, a rib."""

    name: str = text("Name")
    from_: tuple[float, ...] = series(
        "From", "mm", count=(2, 2), within=(-5000, 5000), help="[up, side] from the crank's axis."
    )
    to: tuple[float, ...] = series(
        "Up to", "mm", count=(2, 2), within=(-5000, 5000), help="[up, side] from the crank's axis."
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.from_ == self.to:
            yield dotted(Wall.to), Text("is the same point as from_mm: a wall needs a length")


@inputs
class GearsInputs:
    """The tool, the wheels and the meshes along the flow of power."""

    normal_module: float | None = quantity(
        "Normal module",
        "mm",
        default=None,
        above=0,
        high=100,
        symbol="m_n",
        step=0.25,
        usual=(1, 5),
        source=THUMB,
        help="Pitch over π, normal to the teeth. Left out: by transverse_module_mm.",
        change=("smaller module", "larger module"),
        decides=1,
    )
    transverse_module: float | None = quantity(
        "Transverse module",
        "mm",
        default=None,
        above=0,
        high=100,
        symbol="m_t",
        step=0.25,
        usual=(1, 5),
        source=THUMB,
        help="Pitch over π, square to the axes; instead of the normal one.",
    )
    pressure_angle: float = quantity(
        "Pressure angle (normal)",
        "°",
        within=(10, 35),
        symbol="alpha_n",
        default=math.radians(20),
        usual=(14.5, 25),
        source=THUMB,
        help="Of the tool, normal to the teeth; 20° is common.",
    )
    helix_angle: float = quantity(
        "Helix angle",
        "°",
        within=(0, 35),
        symbol="beta",
        default=0.0,
        usual=(0, 30),
        source=THUMB,
        help="At the reference circle; 0: spur wheels.",
        repair="free",
        decides=2,
    )
    face_width: float = quantity(
        "Face width",
        "mm",
        within=(0.1, 2000),
        symbol="b",
        usual=(5, 80),
        source=THUMB,
        help="Of all wheels that give none of their own; often 6 to 12 modules.",
        change=("narrower gears", "wider gears"),
        decides=3,
    )
    tool_addendum: float = quantity(
        "Tool addendum",
        default=1.25,
        within=(0.5, 3),
        symbol="h_aP0",
        step=0.05,
        usual=(1.2, 1.5),
        source=THUMB,
        help="In modules; makes the root.",
        change=("shallower roots", "deeper roots"),
        repair="free",
    )
    tool_tip_radius: float = quantity(
        "Tool tip radius",
        default=0.38,
        within=(0, 1),
        symbol="rho_aP0",
        step=0.02,
        usual=(0.2, 0.4),
        source=THUMB,
        help="In modules; makes the fillet.",
        repair="free",
    )
    protuberance: float = quantity(
        "Protuberance of the tool",
        "mm",
        default=0.0,
        within=(0, 10),
        symbol="pr_P0",
        usual=(0, 0.4),
        source=THUMB,
        help="How far its tip stands out of its flank.",
    )
    stock: float = quantity(
        "Stock left on the flanks",
        "mm",
        default=0.0,
        within=(0, 10),
        symbol="q",
        usual=(0, 0.3),
        source=THUMB,
        help="Left normal to the flank, to be shaved or ground.",
    )
    ball_diameter: float | None = quantity(
        "Measuring ball",
        "mm",
        default=None,
        above=0,
        high=200,
        symbol="D_M",
        source="DIN 3977",
        help="Diameter of the ball or pin. Left out: for each wheel the preferred one that touches nearest to the "
        "middle of its flank.",
        repair="free",
    )
    iso_6336_edition: int = integer(
        "ISO 6336 edition",
        default=2006,
        within=(2006, 2019),
        source="ISO 6336",
        help="The edition of ISO 6336 that rates the teeth, 2006 or 2019.",
    )
    application_factor: float | None = quantity(
        "Application factor",
        default=None,
        within=(1, 5),
        symbol="K_A",
        step=0.05,
        usual=(1, 2.25),
        source="ISO 6336-6",
        help="For shocks. Left out: 1.25, or 1 with known irregularity.",
        repair="asked",
    )
    accuracy_grade: int = integer(
        "Accuracy grade (ISO 1328-1)",
        default=7,
        within=(1, 11),
        symbol="A",
        usual=(5, 9),
        source="ISO 1328-1, and rule of thumb",
        help="Smaller is finer: 5 ground, 7 shaved, 9 hobbed.",
        change=("better gear quality", "lower gear quality"),
    )
    life: float | None = quantity(
        "Life",
        "h",
        default=None,
        above=0,
        high=1e6,
        symbol="L_h",
        usual=(500, 30000),
        source=THUMB,
        help="Hours at this load. Left out: without end.",
        repair="asked",
    )
    tip_relief: float | None = quantity(
        "Tip relief",
        "µm",
        default=None,
        within=(0, 500),
        symbol="C_a",
        usual=(0, 50),
        source=THUMB,
        help="Ground off the tips. Left out: what running in makes.",
    )
    flank_rz: float | None = quantity(
        "Flank roughness Rz",
        "µm",
        default=None,
        above=0,
        high=100,
        symbol="Rz_H",
        usual=(1, 16),
        source=THUMB,
        help="Peak to valley. Left out: six times Ra of step 6, else 4.",
        change=("smoother flanks", "rougher flanks"),
    )
    root_rz: float = quantity(
        "Root roughness Rz",
        "µm",
        default=16e-6,
        above=0,
        high=200,
        symbol="Rz_F",
        usual=(1, 40),
        source="ISO 6336-3, range of Y_RrelT",
        help="Of the fillets, for the strength of the root.",
        change=("smoother flanks", "rougher flanks"),
    )
    scuffing_load_stage: float | None = quantity(
        "FZG load stage of the oil",
        default=None,
        within=(1, 14),
        symbol="S_FZG",
        usual=(8, 14),
        source=THUMB,
        help="By test A/8.3/90. Left out: stage 10 is assumed.",
    )
    permissible_film: float | None = quantity(
        "Permissible specific film",
        default=None,
        above=0,
        high=10,
        symbol="lambda_GFP",
        usual=(0.06, 0.6),
        source="ISO/TR 15144-1, Annex A",
        help="λ_GFP by a test of the oil. Left out: 0.3.",
    )
    lubrication: str = choice(
        "Lubrication", "spray", "dip", "submerged", default="spray", help="How the oil comes to the teeth."
    )
    housing_material: str | None = text(
        "Housing material",
        default=None,
        help="Between the centres. Left out: that of the bearings, else as the wheels.",
        change=("another housing",),
        catalogue="materials",
    )
    support_material: str | None = text(
        "Support material",
        default=None,
        help="Of the part of a centre distance that a support spans.",
        change=("another housing",),
        catalogue="materials",
    )
    lowest_temperature: float = quantity(
        "Lowest temperature",
        "°C",
        default=-30.0,
        within=(-60, 60),
        symbol="T_min",
        usual=(-40, 0),
        source=THUMB,
        help="Of all parts in a cold start.",
        repair="asked",
    )
    running_temperature: float = quantity(
        "Running temperature of the housing",
        "°C",
        default=100.0,
        within=(0, 200),
        symbol="T_H",
        usual=(60, 120),
        source=THUMB,
        help="At which the warm backlash is taken.",
        repair="asked",
    )
    wheels_warmer: float = quantity(
        "Wheels warmer than the housing",
        "K",
        default=20.0,
        within=(0, 150),
        symbol="Delta_T",
        usual=(0, 40),
        source=THUMB,
        help="They then take backlash away.",
    )
    speed: float | None = quantity(
        "Speed of the first driver",
        "rpm",
        default=None,
        above=0,
        high=100000,
        symbol="n",
        help="How fast the first driver turns. Left out: the crank's rated speed.",
        repair="asked",
    )
    power: float | None = quantity(
        "Power of the first driver",
        "kW",
        default=None,
        above=0,
        high=1e5,
        symbol="P",
        help="What the train takes in at the first driver. Left out: from the closed power balance.",
        repair="asked",
    )
    speed_irregularity: float | None = quantity(
        "Irregularity of the first driver's speed",
        default=None,
        within=(0, 1),
        symbol="delta_s",
        step=0.005,
        usual=(0, 0.05),
        source="rule of thumb, by machine handbooks from memory",
        help="Swing over mean. Left out: the engine's.",
    )
    irregularity_order: float | None = quantity(
        "Order of the irregularity",
        default=None,
        above=0,
        high=50,
        symbol="i",
        help="How often a turn of the first driver it swings. Left out: the engine's firing order.",
    )
    tooth_angle: float = quantity(
        "Tooth of the first driver",
        "°",
        default=0.0,
        within=(-360, 360),
        symbol="gamma_1",
        help="Direction of the middle of one of its teeth, cylinder 1 at TDC, from up in the sense of crank rotation.",
    )
    source_sheet: str = choice(
        "Sheet to compare with",
        "none",
        "finotti",
        default="none",
        help="finotti: what the calculation sheet of Finotti 2013 gives, with what is wrong in it.",
    )
    wheels: tuple[Wheel, ...] = tables("Wheels", Wheel, fold=WHEELS)
    meshes: tuple[Mesh, ...] = tables("Meshes", Mesh, fold=MESHES)
    neighbours: tuple[Neighbour, ...] = tables(
        "Neighbours",
        Neighbour,
        default=(),
        help="Screws, oil galleries: the wheels must clear them.",
        fold=MESHES,
    )
    walls: tuple[Wall, ...] = tables(
        "Walls", Wall, default=(), help="Covers, ribs: the wheels must clear them.", fold=MESHES
    )

    @property
    def module(self) -> float:
        """The normal module, given or by the transverse one."""
        if self.normal_module is not None:
            return self.normal_module
        return (self.transverse_module or math.nan) * math.cos(self.helix_angle)

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.normal_module is None and self.transverse_module is None:
            allowed = keys(GearsInputs)[dotted(GearsInputs.normal_module)].about.allowed()
            yield (
                dotted(GearsInputs.normal_module),
                Text("is missing; needs {allowed}, or transverse_module_mm instead", allowed=allowed),
            )
        if self.normal_module is not None and self.transverse_module is not None:
            yield (
                dotted(GearsInputs.transverse_module),
                Text("normal_module_mm gives it already, with the helix angle; leave one of the two out"),
            )
        if self.iso_6336_edition not in (2006, 2019):
            yield dotted(GearsInputs.iso_6336_edition), Text("must be 2006 or 2019")
        if not self.meshes:
            yield dotted(GearsInputs.meshes), Text("needs at least one [[gears.meshes]]")
        for i, wheel in enumerate(self.wheels):
            for key, size in (
                (Wheel.measured_over_balls, wheel.measured_over_balls),
                (Wheel.measured_over_pins, wheel.measured_over_pins),
            ):
                if size is not None and self.ball_diameter is None:
                    yield (
                        dotted(GearsInputs.wheels, i, key),
                        Text("needs gears.ball_diameter_mm, the ball or pin that was used"),
                    )
            if wheel.measured_span is not None and wheel.span_teeth is None:
                yield (
                    dotted(GearsInputs.wheels, i, Wheel.measured_span),
                    Text("needs span_teeth, over which it was measured"),
                )
        yield from self._flow()
        yield from self._hands()
        if self.support_material is None:
            for i, mesh in enumerate(self.meshes):
                if mesh.support_share:
                    yield dotted(GearsInputs.meshes, i, Mesh.support_share), Text("needs gears.support_material")

    def _flow(self) -> Iterable[tuple[str, Text]]:
        """Every wheel is driven once, and the meshes stand along the flow of power."""
        names = [w.name for w in self.wheels]
        driven: set[str] = set()
        for i, mesh in enumerate(self.meshes):
            for key, name in ((Mesh.driver, mesh.driver), (Mesh.driven, mesh.driven)):
                if name not in names:
                    yield (
                        dotted(GearsInputs.meshes, i, key),
                        Text('there is no wheel "{name}"; the wheels are {names}', name=name, names=", ".join(names)),
                    )
            if i and mesh.driver not in driven | {self.meshes[0].driver}:
                yield (
                    dotted(GearsInputs.meshes, i, Mesh.driver),
                    Text("must be driven by an earlier mesh: meshes are listed along the flow of power"),
                )
            if mesh.driven in driven | {self.meshes[0].driver}:
                yield dotted(GearsInputs.meshes, i, Mesh.driven), Text("is driven already: each wheel has one driver")
            driven.add(mesh.driven)
        for i, name in enumerate(names):
            if self.meshes and name not in driven | {self.meshes[0].driver}:
                yield dotted(GearsInputs.wheels, i, Wheel.name), Text('no mesh uses the wheel "{name}"', name=name)

    def hands(self) -> dict[str, str]:
        """The hand of every helical wheel: they alternate from the first that is given, else the first driver is
        right-handed."""
        if not self.helix_angle or not self.meshes:
            return {}
        turned = {self.meshes[0].driver: 0}
        for mesh in self.meshes:
            turned[mesh.driven] = 1 - turned.get(mesh.driver, 0)
        sides = ("left", "right")
        first = next((w for w in self.wheels if w.hand is not None and w.name in turned), None)
        base = 1 if first is None else (sides.index(str(first.hand)) + turned[first.name]) % 2
        return {name: sides[(base + n) % 2] for name, n in turned.items()}

    def _hands(self) -> Iterable[tuple[str, Text]]:
        """External helical wheels in mesh have opposite hands."""
        hands = self.hands()
        for i, wheel in enumerate(self.wheels):
            if wheel.hand is not None and wheel.hand != hands.get(wheel.name, wheel.hand):
                yield (
                    dotted(GearsInputs.wheels, i, Wheel.hand),
                    Text("must be {hands}: the hands of a train alternate", hands=hands[wheel.name]),
                )


def wheel_key(name: str, field: object) -> str:
    """The dotted key of a field of a wheel: `gears.wheels.central.teeth`."""
    return dotted("gears", GearsInputs.wheels, name, field)


def mesh_key(n: int, field: object) -> str:
    """The dotted key of a field of a mesh, by its place: `gears.meshes.1.centre_distance_mm`."""
    return dotted("gears", GearsInputs.meshes, n, field)
