# SPDX-License-Identifier: Apache-2.0
"""What is measured on one wheel beside its span and its size over balls, and the tooth that a measured size means."""

from ...sheet.quantity import Stated, group, result, value
from ...sheet.record import record
from ...sheet.shown import Shown
from ...sheet.units import Metre, Number, Radian


@record
class Seat:
    """A ball between two flanks.  `alpha_K`: pressure angle at its centre, on the circle `d_K`; `d_y`: the circle on
    which it touches."""

    alpha_K: Radian
    d_K: Metre
    d_y: Metre


@result
class Measured(Shown):
    """The tooth that a measured size means."""

    generating_shift: Number = value("Generating shift", "", "x_E")
    span_change: Metre = value("Change of the span, the allowance met", "µm", "E_W")
    thickness_change: Metre = value("Change of the normal tooth thickness", "µm", "E_sn")
    normal_thickness: Metre = value("Normal tooth thickness", "mm", "s_n")
    transverse_thickness: Metre = value("Transverse tooth thickness", "mm", "s_t")


@result
class MeasuresResult(Shown):
    """Values ending in _min and _max belong to the two ends of the allowance of the span.  Allowances are changes,
    thinner is negative."""

    normal_thickness: Metre = value("Normal tooth thickness at the reference circle", "mm", "s_n")
    thickness_allowance_upper: Metre | None = value(
        "Upper allowance of the normal tooth thickness", "µm", "E_sns", default=None
    )
    thickness_allowance_lower: Metre | None = value(
        "Lower allowance of the normal tooth thickness", "µm", "E_sni", default=None
    )
    transverse_allowance_upper: Metre | None = value(
        "Upper allowance of the transverse tooth thickness", "µm", "E_sts", default=None
    )
    transverse_allowance_lower: Metre | None = value(
        "Lower allowance of the transverse tooth thickness", "µm", "E_sti", default=None
    )
    best_span_teeth: Number | None = value("Teeth spanned, best", "", "K", default=None)
    span_contact_diameter: Metre = value("Circle on which the span touches", "mm", "d_W")
    span_width: Metre = value("Face width that the span needs", "mm", "b_W")
    ideal_balls: dict[str, Stated] = group(spread=True)  # ideal_ball_at_MATE
    ball_contact_diameter: Metre | None = value("Circle on which the measuring ball touches", "mm", "d_M", default=None)
    over_one_ball: Metre | None = value("Size over one ball or pin, from the axis", "mm", "M_r", default=None)
    over_one_ball_min: Metre | None = value("Size over one ball or pin, thinnest tooth", "mm", "M_r", default=None)
    over_one_ball_max: Metre | None = value("Size over one ball or pin, thickest tooth", "mm", "M_r", default=None)
    over_pins: Metre | None = value("Size over pins, faces parallel to the axis", "mm", "M_dR", default=None)
    over_pins_min: Metre | None = value("Size over pins, thinnest tooth", "mm", "M_dR", default=None)
    over_pins_max: Metre | None = value("Size over pins, thickest tooth", "mm", "M_dR", default=None)
    over_two_pins: Metre | None = value("Smallest size over two pins, free faces", "mm", "M_2R", default=None)
    over_two_pins_min: Metre | None = value("Smallest size over two pins, thinnest tooth", "mm", "M_2R", default=None)
    over_two_pins_max: Metre | None = value("Smallest size over two pins, thickest tooth", "mm", "M_2R", default=None)
    pins_width: Metre | None = value("Face width that two opposite pins need", "mm", "b_R", default=None)
    chordal_thickness_min: Metre | None = value("Chordal thickness, thinnest tooth", "mm", "s_c", default=None)
    chordal_thickness_max: Metre | None = value("Chordal thickness, thickest tooth", "mm", "s_c", default=None)
    constant_chord: Metre = value("Constant chord, normal", "mm", "s_cc")
    constant_chord_min: Metre | None = value("Constant chord, thinnest tooth", "mm", "s_cc", default=None)
    constant_chord_max: Metre | None = value("Constant chord, thickest tooth", "mm", "s_cc", default=None)
    constant_chord_height: Metre = value("Height above the constant chord", "mm", "h_cc")
    constant_chord_diameter: Metre = value("Circle of the ends of the constant chord", "mm", "d_cc")
    measured_span: Measured | None = group(default=None)
    measured_over_balls: Measured | None = group(default=None)
    measured_over_pins: Measured | None = group(default=None)
    measured_chordal_thickness: Measured | None = group(default=None)
    measured_spread: Metre | None = value(
        "Tooth thickness, difference between the measured routes", "µm", "Δs_n", default=None
    )
