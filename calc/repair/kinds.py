# SPDX-License-Identifier: Apache-2.0
"""What kind of remedy a changed input is, in the words of the trade: a smaller clearance, a longer journal, a thicker core."""

import re
from dataclasses import dataclass

from ..design.addresses import quantity_of
from ..design.toml_file import Document
from ..sheet.text import EMPTY, Small, Text


@dataclass(frozen=True)
class Kind:
    """`less`, `more`: the words for a smaller and a larger number; `other`: for another word, or a number that is taken out."""

    less: Text
    more: Text
    other: Text = EMPTY


# Patterns of keys, the first that fits counts.  Keys of one row that stand in the same bearing, mass or mesh move together.
KINDS: tuple[tuple[str, Kind], ...] = (
    (r".*\.(front|rear)\.clearance_(um|factor)", Kind(Text("smaller clearance"), Text("larger clearance"))),
    (r"bearings\.(front|rear)\.length_mm", Kind(Text("shorter journal"), Text("longer journal"))),
    (r"bearings\.(front|rear)\.(journal|housing)_roughness_um", Kind(Text("smoother surfaces"), Text("rougher surfaces"))),
    (r"bearings\.(front|rear)\.diameter_mm", Kind(Text("smaller journal"), Text("larger journal"))),
    (r"bearings\.(journal|seat)_fit", Kind(Text("closer fits"), Text("wider fits"), Text("closer fits"))),
    (r"bearings\.slope_mrad", Kind(Text("smaller slope"), Text("larger slope"), Text("slope of the shaft's bending"))),
    (r"(bearings|friction)\.oil", Kind(Text("thinner oil"), Text("thicker oil"), Text("another oil"))),
    (r"bearings\.(hole_diameter|groove_width|pocket_width)_mm", Kind(Text("narrower oil supply"), Text("wider oil supply"))),
    (r"bearings\.supply_pressure_bar", Kind(Text("less oil pressure"), Text("more oil pressure"))),
    (r"bearings\.housing_material", Kind(EMPTY, EMPTY, Text("another housing"))),
    (r"gears\.(housing|support)_material", Kind(EMPTY, EMPTY, Text("another housing"))),
    (r"countershaft\.material", Kind(EMPTY, EMPTY, Text("another steel"))),
    (r"countershaft\.core_radius_mm", Kind(Text("thinner core"), Text("stiffer shaft"))),
    (r"countershaft\.fillet_radius_mm", Kind(Text("smaller fillet"), Text("larger fillet"))),
    (r"countershaft\.outer_radius_mm", Kind(Text("smaller envelope"), Text("larger envelope"))),
    (r"countershaft\.half_length_mm", Kind(Text("shorter shaft"), Text("longer shaft"))),
    (r"countershaft\.bearing_positions_mm", Kind(Text("shorter span"), Text("longer span"))),
    (r"countershaft\.masses\.[^.]+\.mass_kg", Kind(Text("lighter mass"), Text("heavier mass"))),
    (r"countershaft\.masses\.[^.]+\.radius_mm", Kind(Text("mass further in"), Text("mass further out"))),
    (r"countershaft\.masses\.[^.]+\.z_mm", Kind(Text("mass elsewhere"), Text("mass elsewhere"))),
    (r"countershaft\.masses\.[^.]+\.angle_deg", Kind(Text("mass turned"), Text("mass turned"))),
    (r"countershaft\.overdesign_percent", Kind(Text("less beyond what is asked"), Text("more beyond what is asked"))),
    (r"countershaft\.holes\.depth_mm", Kind(Text("shallower holes"), Text("deeper holes"))),
    (r"countershaft\.holes\.count", Kind(Text("fewer holes"), Text("more holes"))),
    (r"countershaft\.bolts\.torque_Nm", Kind(Text("less bolt torque"), Text("more bolt torque"))),
    (r"countershaft\.bolts\.head_diameter_mm", Kind(Text("smaller bolt heads"), Text("larger bolt heads"))),
    (r"countershaft\.bolts\.hole_diameter_mm", Kind(Text("closer bolt holes"), Text("wider bolt holes"))),
    (r"countershaft\.bolts\.count", Kind(Text("fewer bolts"), Text("more bolts"))),
    (r"countershaft\.support\.wall_mm", Kind(Text("thinner wall"), Text("thicker wall"))),
    (r"gears\.wheels\..*\.span_allowance_um", Kind(Text("thinner teeth"), Text("thicker teeth"))),
    (r"gears\.wheels\..*\.teeth", Kind(Text("fewer teeth"), Text("more teeth"))),
    (r"gears\.wheels\..*\.profile_shift", Kind(Text("less profile shift"), Text("more profile shift"))),
    (r"gears\.wheels\..*\.tip_shortening_mm", Kind(Text("smaller tip cut"), Text("larger tip cut"))),
    (r"gears\.wheels\..*\.tip_diameter_tolerance_um", Kind(Text("smaller tips"), Text("larger tips"))),
    (r"gears\.wheels\..*\.position_mm", Kind(Text("wheel elsewhere"), Text("wheel elsewhere"))),
    (r"gears\.wheels\..*\.runout_um", Kind(Text("less runout"), Text("more runout"))),
    (r"gears\.wheels\..*\.(gear_material|quality|hardness_HV)", Kind(Text("softer teeth"), Text("harder teeth"), Text("stronger teeth"))),
    (r"gears\.meshes\..*\.centre_distance_mm", Kind(Text("closer centres"), Text("wider centres"))),
    (r"gears\.meshes\..*\.tolerance_um", Kind(Text("closer tolerance"), Text("wider tolerance"))),
    (r"gears\.(wheels\..*\.)?face_width_mm", Kind(Text("narrower gears"), Text("wider gears"))),
    (r"gears\.normal_module_mm", Kind(Text("smaller module"), Text("larger module"))),
    (r"gears\.accuracy_grade", Kind(Text("better gear quality"), Text("lower gear quality"))),
    (r"gears\.tool_addendum", Kind(Text("shallower roots"), Text("deeper roots"))),
    (r"gears\.(flank|root)_rz_um|friction\.flank_roughness_um", Kind(Text("smoother flanks"), Text("rougher flanks"))),
    (r"engine\.flywheel_inertia_kgm2", Kind(Text("lighter flywheel"), Text("heavier flywheel"))),
    (r"engine\.rod_length_mm", Kind(Text("shorter rods"), Text("longer rods"))),
    (r"imbalance\.crank_balance_fraction", Kind(Text("lighter counterweights"), Text("heavier counterweights"))),
    (r"imbalance\.bob_mass_kg", Kind(Text("lighter bob"), Text("heavier bob"))),
)  # fmt: skip
CALLED = tuple((re.compile(pattern), kind) for pattern, kind in KINDS)


def row_of(key: str) -> int | None:
    """The row of the table that a key belongs to; None: it has none of its own."""
    return next((n for n, (pattern, _) in enumerate(CALLED) if pattern.fullmatch(key)), None)


def kind_of(document: Document, key: str) -> Kind:
    """Where the table has no words of its own, those of the field."""
    if (row := row_of(key)) is not None:
        return CALLED[row][1]
    label = Small(quantity_of(document.data, key).label)
    return Kind(Text("smaller {label}", label=label), Text("larger {label}", label=label), Text("another {label}", label=label))


def called(document: Document, key: str, now: object, new: object) -> Text:
    """The words for one change; of several numbers those of the first that changes."""
    kind = kind_of(document, key)
    pairs = zip(now, new) if isinstance(now, list) and isinstance(new, list) else [(now, new)]
    for old, value in pairs:
        if isinstance(old, (int, float)) and isinstance(value, (int, float)) and old != value:
            return kind.less if value < old else kind.more
    return kind.other or kind.less
