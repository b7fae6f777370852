# SPDX-License-Identifier: Apache-2.0
"""What the gear train is described by: its wheels, its meshes, one tool, and what stands around them.

Axes of positions: the first is up, the second 90° further in the sense of crank rotation, both from the crank's axis.
"""

import math
import re
from collections.abc import Iterable
from typing import ClassVar

from ..sheet.quantity import choice, dotted, inputs, integer, keys, quantity, series, table, tables, text, unknown
from ..sheet.text import Amount, Text
from ..sheet.units import Kelvin
from .drive.inputs import DragRow, DriveInputs
from .drive.scissor_inputs import Scissor
from .tree import TrainLink, Tree, first_of, in_flow
from .wheel_inputs import INTERNAL, REFUSED, Wheel

# the folds of the form
WHEELS = Text("More of the wheels")
MESHES = Text("More of the meshes")
DRIVE = Text("The drive over speed")
ONLY = "shaft"  # what the shaft of a design is called that has one and gives it no name
ASSUMED_WARMER: Kelvin = 20.0  # of the wheels: how much it is while the engine warms up is not published


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
        rule_of_thumb=(0.01, 0.1),
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
        up_to=5000,
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
        rule_of_thumb=(10, 100),
        help="Half the field, to either side.",
        brief="centre tolerance (±)",
        change=("closer tolerance", "wider tolerance"),
        repair="free",
        decides=11,
    )
    contributors: tuple[float, ...] | None = series(
        "Contributors to the tolerance",
        "mm",
        default=None,
        within=(0, 10),
        rule_of_thumb=(0.01, 0.1),
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
        rule_of_thumb=(0, 30),
        help="Over the face width. Left out: by the accuracy grade.",
    )
    shaft_deflection: float | None = quantity(
        "Misalignment by bending",
        "µm",
        default=None,
        within=(0, 500),
        symbol="f_sh",
        rule_of_thumb=(0, 30),
        help="Over the face width. Left out: none.",
    )
    scissor: Scissor | None = table(
        "Scissor gear",
        Scissor,
        default=None,
        help="One wheel is split, and a spring turns its halves apart: the flanks stay closed.",
        fold=MESHES,
    )
    shim_step: float | None = quantity(
        "Step of the shims",
        "µm",
        default=None,
        up_to=1000,
        help="By which the centre distance is set when the engine is put together; for the balancing sheet.",
        fold=MESHES,
    )
    coat: float | None = quantity(
        "Coat on the flanks",
        "µm",
        default=None,
        up_to=1000,
        symbol="s_c",
        help="On both flanks of one of the wheels, which is set without backlash: once it has worn off, twice its "
        "thickness is left.",
        change=("thinner coat", "thicker coat"),
        repair="free",
        fold=MESHES,
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
        if self.scissor is not None and self.scissor.wheel not in (None, self.driver, self.driven):
            of_mesh = Text('must be "{driver}" or "{driven}", of this mesh', driver=self.driver, driven=self.driven)
            yield dotted(Mesh.scissor, Scissor.wheel), of_mesh


# --- a chain or a belt


@inputs
class Stage:
    """A chain or a toothed belt from one axis of the train to another."""

    name: str = text("Name", help="What its values are called by; that of no wheel.")
    kind: str = choice("Kind", "chain", "belt", help="A chain, or a toothed belt.")
    driver: str = text("Driver", help="The wheel beside which its first sprocket turns, or a name for that sprocket.")
    driven: str = text(
        "Driven",
        help="The wheel beside which its second sprocket turns, or a name for that sprocket; one that is called like a "
        "shaft carries it.",
    )
    driver_teeth: int = integer(
        "Teeth of the driving sprocket",
        within=(5, 1000),
        symbol="z_1",
        rule_of_thumb=(19, 60),
        help="Few teeth make a chain run unevenly.",
        repair="free",
    )
    driven_teeth: int = integer(
        "Teeth of the driven sprocket",
        within=(5, 1000),
        symbol="z_2",
        rule_of_thumb=(19, 120),
        help="Over those of the driving one they make the ratio.",
        repair="free",
    )
    side: str = choice(
        "Side that runs on the driven sprocket",
        "inner",
        "outer",
        default="inner",
        help="inner: both sprockets turn in one sense. outer: the back of the chain turns it the other way.",
    )
    pitch: float = quantity(
        "Pitch",
        "mm",
        up_to=200,
        symbol="p",
        rule_of_thumb=(5, 20),
        help="From link to link of the chain, from tooth to tooth of the belt.",
    )
    efficiency: float = quantity(
        "Efficiency",
        default=0.98,
        above=0,
        high=1,
        symbol="eta",
        rule_of_thumb=(0.95, 0.99),
        help="Power that it passes on, over what it takes in.",
    )
    elongation: float = quantity(
        "Elongation",
        "%",
        default=0.003,
        within=(0, 5),
        symbol="epsilon",
        rule_of_thumb=(0, 1),
        help="By wear; 0.3 is a worn timing chain.",
        repair="asked",
    )
    span: float | None = quantity(
        "Free length of the pulling strand",
        "mm",
        default=None,
        up_to=5000,
        symbol="L",
        help="Between both sprockets. Left out: what elongation leaves of the phase is not known.",
    )
    tensioner: float | None = quantity(
        "Force of the tensioner in the slack strand",
        "N",
        default=None,
        up_to=1e5,
        symbol="F_S",
        help="It holds the strand that pulls where the torque reverses. Left out: that is not judged.",
    )

    @property
    def title(self) -> str:
        """What it is called in sentences."""
        return f"{self.driver}–{self.driven}"

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.driver == self.driven:
            yield dotted(Stage.driven), Text("a sprocket can not drive itself")


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
        "Radius", "mm", up_to=5000, symbol="r", help="Radius of the round thing that the wheels must clear."
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
        up_to=100,
        symbol="m_n",
        step=0.25,
        rule_of_thumb=(1, 5),
        help="Pitch over π, normal to the teeth. Left out: by transverse_module_mm.",
        change=("smaller module", "larger module"),
        decides=1,
    )
    transverse_module: float | None = quantity(
        "Transverse module",
        "mm",
        default=None,
        up_to=100,
        symbol="m_t",
        step=0.25,
        rule_of_thumb=(1, 5),
        help="Pitch over π, square to the axes; instead of the normal one.",
    )
    pressure_angle: float = quantity(
        "Pressure angle (normal)",
        "°",
        within=(10, 35),
        symbol="alpha_n",
        default=math.radians(20),
        rule_of_thumb=(14.5, 25),
        help="Of the tool, normal to the teeth; 20° is common.",
    )
    helix_angle: float = quantity(
        "Helix angle",
        "°",
        within=(0, 35),
        symbol="beta",
        default=0.0,
        rule_of_thumb=(0, 30),
        help="At the reference circle; 0: spur wheels.",
        repair="free",
        decides=2,
    )
    face_width: float = quantity(
        "Face width",
        "mm",
        within=(0.1, 2000),
        symbol="b",
        rule_of_thumb=(5, 80),
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
        rule_of_thumb=(1.2, 1.5),
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
        rule_of_thumb=(0.2, 0.4),
        help="In modules; makes the fillet.",
        repair="free",
    )
    protuberance: float = quantity(
        "Protuberance of the tool",
        "mm",
        default=0.0,
        within=(0, 10),
        symbol="pr_P0",
        rule_of_thumb=(0, 0.4),
        help="How far its tip stands out of its flank.",
    )
    stock: float = quantity(
        "Stock left on the flanks",
        "mm",
        default=0.0,
        within=(0, 10),
        symbol="q",
        rule_of_thumb=(0, 0.3),
        help="Left normal to the flank, to be shaved or ground.",
    )
    ball_diameter: float | None = quantity(
        "Measuring ball",
        "mm",
        default=None,
        up_to=200,
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
        up_to=1e6,
        symbol="L_h",
        rule_of_thumb=(500, 30000),
        help="Hours at this load. Left out: without end.",
        repair="asked",
    )
    tip_relief: float | None = quantity(
        "Tip relief",
        "µm",
        default=None,
        within=(0, 500),
        symbol="C_a",
        rule_of_thumb=(0, 50),
        help="Ground off the tips. Left out: what running in makes.",
    )
    flank_rz: float | None = quantity(
        "Flank roughness Rz",
        "µm",
        default=None,
        up_to=100,
        symbol="Rz_H",
        rule_of_thumb=(1, 16),
        help="Peak to valley. Left out: six times Ra of step 6, else 4.",
        change=("smoother flanks", "rougher flanks"),
    )
    root_rz: float = quantity(
        "Root roughness Rz",
        "µm",
        default=16e-6,
        up_to=200,
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
        rule_of_thumb=(8, 14),
        help="By test A/8.3/90. Left out: stage 10 is assumed.",
    )
    permissible_film: float | None = quantity(
        "Permissible specific film",
        default=None,
        up_to=10,
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
        rule_of_thumb=(-40, 0),
        help="Of all parts in a cold start.",
        repair="asked",
    )
    running_temperature: float = quantity(
        "Running temperature of the housing",
        "°C",
        default=100.0,
        within=(0, 200),
        symbol="T_H",
        rule_of_thumb=(60, 120),
        help="At which the warm backlash is taken.",
        repair="asked",
    )
    wheels_warmer: float | None = quantity(
        "Wheels warmer than the housing",
        "K",
        default=None,
        within=(0, 150),
        symbol="Delta_T",
        rule_of_thumb=(0, 40),
        help="They then take backlash away. Left out: 20 K are assumed.",
    )
    speed: float | None = quantity(
        "Speed of the first driver",
        "rpm",
        default=None,
        up_to=100000,
        symbol="n",
        help="How fast the first driver turns. Left out: the crank's rated speed.",
        repair="asked",
    )
    power: float | None = quantity(
        "Power of the first driver",
        "kW",
        default=None,
        up_to=1e5,
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
        up_to=50,
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
    wheels: tuple[Wheel, ...] = tables("Wheels", Wheel, default=(), fold=WHEELS)
    meshes: tuple[Mesh, ...] = tables("Meshes", Mesh, default=(), fold=MESHES)
    stages: tuple[Stage, ...] = tables(
        "Chains and belts",
        Stage,
        default=(),
        help="Each as ratio, loss and phase error; nothing is said of its strength.",
        fold=MESHES,
    )
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
    drive: DriveInputs | None = table(
        "Drive over speed",
        DriveInputs,
        default=None,
        help="Where gas and flywheel of the engine do not say how the crank turns, or drags are measured.",
        fold=DRIVE,
    )

    @property
    def module(self) -> float:
        """The normal module, given or by the transverse one."""
        if self.normal_module is not None:
            return self.normal_module
        return (self.transverse_module or math.nan) * math.cos(self.helix_angle)

    @property
    def warmer(self) -> Kelvin:
        """How much warmer than the housing the wheels are, given or assumed."""
        return ASSUMED_WARMER if self.wheels_warmer is None else self.wheels_warmer

    def former_id(self, id: str) -> str:
        """What a value or check was called while its wheels had their former names: `gears.crank_pump.backlash`."""
        for wheel in self.wheels:
            if wheel.former_name is not None:
                id = re.sub(rf"(?<![A-Za-z0-9-]){wheel.name}(?![A-Za-z0-9-])", wheel.former_name, id)
        return id

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
        if not self.meshes and not self.stages:
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
            others = {w.former_name for w in self.wheels[:i]} | {w.name for w in self.wheels}
            if wheel.former_name is not None and wheel.former_name in others:
                yield dotted(GearsInputs.wheels, i, Wheel.former_name), Text("is the name of a wheel")
            if wheel.measured_span is not None and wheel.span_teeth is None:
                yield (
                    dotted(GearsInputs.wheels, i, Wheel.measured_span),
                    Text("needs span_teeth, over which it was measured"),
                )
        if self.meshes or self.stages:
            yield from self._flow()
            yield from self._drags()
            yield from self._halves()
        yield from self._shafts()
        yield from self._hands()
        if self.support_material is None:
            for i, mesh in enumerate(self.meshes):
                if mesh.support_share:
                    yield dotted(GearsInputs.meshes, i, Mesh.support_share), Text("needs gears.support_material")

    def _flow(self) -> Iterable[tuple[str, Text]]:
        """Every wheel is driven once, and the meshes stand along the flow of power."""
        names = [w.name for w in self.wheels]
        already = Text("is driven already: each wheel has one driver")
        by_stage, driven = {stage.driven for stage in self.stages}, set[str]()
        for i, mesh in enumerate(self.meshes):
            for key, name in ((Mesh.driver, mesh.driver), (Mesh.driven, mesh.driven)):
                if name not in names:
                    yield (
                        dotted(GearsInputs.meshes, i, key),
                        Text('there is no wheel "{name}"; the wheels are {names}', name=name, names=", ".join(names)),
                    )
            if mesh.driver not in driven | by_stage | {self.first}:
                yield (
                    dotted(GearsInputs.meshes, i, Mesh.driver),
                    Text("must be driven by an earlier mesh: meshes are listed along the flow of power"),
                )
            if mesh.driven in driven | {self.first}:
                yield dotted(GearsInputs.meshes, i, Mesh.driven), already
            driven.add(mesh.driven)
        for i, stage in enumerate(self.stages):
            if stage.driven in driven | {self.first}:
                yield dotted(GearsInputs.stages, i, Stage.driven), already
            elif stage.driven not in self.along:
                loose = Text("no mesh and no stage leads there from {first}", first=self.first)
                yield dotted(GearsInputs.stages, i, Stage.driver), loose
            driven.add(stage.driven)
        meshing = {name for mesh in self.meshes for name in (mesh.driver, mesh.driven)}
        for i, name in enumerate(names):
            if name not in meshing:
                yield dotted(GearsInputs.wheels, i, Wheel.name), Text('no mesh uses the wheel "{name}"', name=name)
        taken = {*names, *(mesh.key for mesh in self.meshes), "train"}
        for i, stage in enumerate(self.stages):
            if stage.name in taken:
                yield dotted(GearsInputs.stages, i, Stage.name), Text("is the name of something else in the train")

    def _drags(self) -> Iterable[tuple[str, Text]]:
        """Drags are those of wheels and sprockets."""
        for i, row in enumerate(self.drive.drag if self.drive is not None else ()):
            if row.wheel not in self.along:
                yield dotted(GearsInputs.drive, DriveInputs.drag, i, DragRow.wheel), unknown(row.wheel, self.along)

    def _halves(self) -> Iterable[tuple[str, Text]]:
        """The sprung half of a split wheel leaves a main half."""
        widths = {wheel.name: wheel.face_width or self.face_width for wheel in self.wheels}
        for i, mesh in enumerate(self.meshes):
            given = mesh.scissor.face_width if mesh.scissor is not None else None
            b = min((widths[name] for name in (mesh.driver, mesh.driven) if name in widths), default=math.inf)
            if given is not None and given >= b:
                less = Text("must be below the {b} of the mesh", b=Amount(b * 1e3, "mm", form=".4g"))
                yield dotted(GearsInputs.meshes, i, Mesh.scissor, Scissor.face_width), less

    def _shafts(self) -> Iterable[tuple[str, Text]]:
        """One wheel for each shaft."""
        on: dict[str, str] = {}
        for i, wheel in enumerate(self.wheels):
            if wheel.shaft is not None and on.setdefault(wheel.shaft, wheel.name) != wheel.name:
                there = Text("{other} is on that shaft: each shaft has one wheel", other=on[wheel.shaft])
                yield dotted(GearsInputs.wheels, i, Wheel.shaft), there
            elif wheel.shaft is not None and (self.meshes or self.stages) and wheel.name == self.first:
                crank = Text("is the first driver, which turns with the crank: a shaft needs a driven wheel")
                yield dotted(GearsInputs.wheels, i, Wheel.shaft), crank
        for i, wheel in enumerate(self.wheels):
            if on.get(wheel.name, wheel.name) != wheel.name:
                like = Text("is what the shaft is called on which {other} sits", other=on[wheel.name])
                yield dotted(GearsInputs.wheels, i, Wheel.name), like

    @property
    def _links(self) -> tuple[Mesh | Stage, ...]:
        every: tuple[Mesh | Stage, ...] = (*self.meshes, *self.stages)
        return in_flow(every, first_of(every))

    @property
    def first(self) -> str:
        """The first driver."""
        every: tuple[Mesh | Stage, ...] = (*self.meshes, *self.stages)
        return first_of(every)

    @property
    def along(self) -> tuple[str, ...]:
        """The names of the wheels along the flow of power, in whatever order they are listed, and of sprockets that
        turn beside no wheel."""
        return (self.first, *(link.driven for link in self._links))

    @property
    def tree(self) -> Tree:
        """Meshes and stages along the flow of power."""
        teeth, links = {wheel.name: wheel.teeth for wheel in self.wheels}, list[TrainLink]()
        for link in self._links:
            a, b = link.driver, link.driven
            if isinstance(link, Stage):
                sense = 1 if link.side == "inner" else -1
                links.append(TrainLink(link.name, link.title, a, b, link.driver_teeth, link.driven_teeth, sense, False))
            else:
                links.append(TrainLink(link.key, link.title, a, b, teeth[a], teeth[b], -1, True))
        return Tree(tuple(links))

    def carrier(self, shaft: str = ONLY) -> str:
        """The wheel that carries a shaft: that which says so, or the sprocket that is called like it; where none does,
        the last that is driven."""
        on = {wheel.shaft: wheel.name for wheel in self.wheels if wheel.shaft is not None}
        wheels = {wheel.name for wheel in self.wheels}
        on |= {name: name for name in self.along if name not in wheels}
        return on.get(shaft, self.along[-1])

    @property
    def carriers(self) -> set[str]:
        """The wheels that say on which shaft they sit; where none does, the last that is driven."""
        return {wheel.name for wheel in self.wheels if wheel.shaft is not None} or {self.along[-1]}

    def hands(self) -> dict[str, str]:
        """The hand of every helical wheel: from mesh to mesh they alternate, from the first that is given, else a wheel
        that no mesh drives is right-handed."""
        if not self.helix_angle or not self.meshes:
            return {}
        turned: dict[str, tuple[str, int]] = {}  # the wheel with which its meshes begin, and how many lie between
        for mesh in self.meshes:
            head, n = turned.setdefault(mesh.driver, (mesh.driver, 0))
            turned[mesh.driven] = head, 1 - n
        sides = ("left", "right")
        base: dict[str, int] = {}
        for wheel in self.wheels:
            if wheel.hand is not None and wheel.name in turned:
                head, n = turned[wheel.name]
                base.setdefault(head, (sides.index(wheel.hand) + n) % 2)
        return {name: sides[(base.get(head, 1) + n) % 2] for name, (head, n) in turned.items()}

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
