# SPDX-License-Identifier: Apache-2.0
"""A rolling bearing by its outline, and what is inside it."""

from typing import Generic, Literal

from ...sheet.arrays import Value
from ...sheet.record import record

Type = Literal["ball", "roller", "needle", "cup", "cage"]  # needle: with machined rings; cup: drawn; cage: no ring


@record
class BearingSize(Generic[Value]):
    """The outline of a bearing, in m: of one, or of many of one type.

    `series`: 60 62 63; 10 2 3 22 23 of cylindrical rollers; NA49, RNA49, HK, K; or own.  `bore`: of the inner ring,
    else the raceway on the shaft, F_w; `outside`: of the outer ring or cup, else that over the elements, E_w."""

    designation: str
    type: Type
    series: str
    bore: Value
    outside: Value
    width: Value
    raceway: Value | None = None  # F_w of needles
    inner_ring: bool = True
    flanged: bool = False  # carries thrust: NJ


@record
class Inside(Generic[Value]):
    """What is inside: the elements of a bearing of one row, in m."""

    elements: Literal["ball", "roller"]
    count: Value  # Z
    diameter: Value  # D_w
    pitch: Value  # D_pw
    length: Value | None = None  # L_we of rollers
    contact_angle: float = 0.0  # rad
    groove_inner: float = 0.52  # radius over D_w, of balls
    groove_outer: float = 0.52
