# SPDX-License-Identifier: Apache-2.0
"""What is asked about a wheel of the train."""

from collections.abc import Iterable
from typing import ClassVar

from ..sheet.quantity import choice, dotted, inputs, integer, quantity, series, text
from ..sheet.text import Text

INTERNAL = Text(
    "internal gears are not computed: contact, interference, the form of the root and its strength are those of two "
    "external wheels here; external wheels have 5 teeth or more and a positive centre distance"
)

# keys that others have for them
REFUSED = dict.fromkeys(("internal", "internal_teeth", "ring", "ring_gear", "annulus"), INTERNAL)


@inputs
class Wheel:
    """One wheel of the train."""

    REFUSED: ClassVar[dict[str, Text]] = REFUSED

    name: str = text("Name", decides=4)
    teeth: int = integer(
        "Teeth",
        within=(5, 1000),
        symbol="z",
        rule_of_thumb=(17, 100),
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
        rule_of_thumb=(-0.5, 1),
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
        usual=(-80, -20),
        source="Finotti 2013, 4.5.1: −20 to −50; rule of this program: to −80 for wheels with much runout",
        help="[upper, lower] of W: −20, −30 shaved, −40, −50 hobbed; thinner where runout takes up the backlash.",
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
        rule_of_thumb=(5, 80),
        help="Over a turn; half of it to each side of the centre. Left out: by the accuracy grade.",
        change=("less runout", "more runout"),
    )
    measured_span: float | None = quantity(
        "Measured span",
        "mm",
        default=None,
        up_to=5000,
        symbol="W",
        source="ISO 21771",
        help="Over the teeth spanned; gives the tooth that was made.",
    )
    measured_over_balls: float | None = quantity(
        "Measured size over balls",
        "mm",
        default=None,
        up_to=10000,
        symbol="M_dK",
        source="ISO 21771",
        help="Over two balls of gears.ball_diameter_mm; gives the tooth that was made.",
    )
    measured_over_pins: float | None = quantity(
        "Measured size over pins",
        "mm",
        default=None,
        up_to=10000,
        symbol="M_dR",
        source="ISO 21771",
        help="Between faces parallel to the axis: two opposite pins, of an odd helical wheel three.",
    )
    measured_chordal_thickness: float | None = quantity(
        "Measured chordal thickness",
        "mm",
        default=None,
        up_to=500,
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
    z: float | None = quantity(
        "Position along the crank",
        "mm",
        default=None,
        within=(-5000, 5000),
        symbol="z_W",
        help="Middle of its face from mid-engine, + towards the flywheel, for exports. Left out: that of the wheel in "
        "mesh with it. Of a wheel on a shaft: gear_z_mm of that.",
    )
    bore_diameter: float | None = quantity(
        "Bore",
        "mm",
        default=None,
        up_to=2000,
        symbol="d_i",
        rule_of_thumb=(5, 500),
        help="Diameter of the bore of the body, for its inertia. Left out: a solid disc.",
    )
    rim_thickness: float | None = quantity(
        "Rim thickness",
        "mm",
        default=None,
        up_to=500,
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
        up_to=1200,
        symbol="HV",
        usual=(115, 900),
        source="ISO 6336-5:2016, Table 1",
        help="For classes whose strength depends on it.",
        change=("softer teeth", "harder teeth", "stronger teeth"),
        repair="free",
    )

    shaft: str | None = text(
        "Shaft that it carries",
        default=None,
        help="Name of the shaft on which it sits. Left out of all wheels: the last driven one carries the shaft.",
    )

    former_name: str | None = text(
        "Name that it had",
        default=None,
        help="Keys, values and checks of this wheel are found by it too.",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        for key, limits in (
            (dotted(Wheel.span_allowance), self.span_allowance),
            (dotted(Wheel.tip_diameter_tolerance), self.tip_diameter_tolerance),
            (dotted(Wheel.root_diameter_tolerance), self.root_diameter_tolerance),
        ):
            if limits is not None and len(limits) == 2 and limits[0] < limits[1]:
                yield key, Text("is [upper, lower]: the first must not be below the second")
