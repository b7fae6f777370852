# SPDX-License-Identifier: Apache-2.0
"""What an accuracy grade permits the teeth of a wheel, as its drawing says it: pitch, profile, helix, runout.

Form of the profile, slope of the helix and single pitch are those of the load distribution (rating/distribution.py),
the runout that of the backlash."""

from ..sheet.formula import formula
from ..sheet.functions import sqrt
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import Metre, Number
from ..sheet.value import untraced
from .backlash.formulas import runout_of_grade
from .rating.distribution import (
    helix_slope_tolerance,
    out_of_range,
    profile_form_tolerance,
    rounded,
    single_pitch_tolerance,
)

MILLIMETRE: Metre = 1e-3
MICROMETRE: Metre = 1e-6
ISO_1328 = Text("ISO 1328-1:2013, clause 5, from memory")


@formula("F_pT", Text("{iso_1328}: total pitch, before rounding", iso_1328=ISO_1328), unit="µm", names={"A": "Q"})
def total_pitch_tolerance(d: Metre, m_n: Metre, A: Number) -> Metre:
    return (
        MICROMETRE
        * (0.002 * d / MILLIMETRE + 0.55 * sqrt(d / MILLIMETRE) + 0.7 * m_n / MILLIMETRE + 12)
        * 2 ** ((A - 5) / 2)
    )


@formula(
    "f_HαT", Text("{iso_1328}: slope of the profile, before rounding", iso_1328=ISO_1328), unit="µm", names={"A": "Q"}
)
def profile_slope_tolerance(d: Metre, m_n: Metre, A: Number) -> Metre:
    return MICROMETRE * (0.4 * m_n / MILLIMETRE + 0.001 * d / MILLIMETRE + 4) * 2 ** ((A - 5) / 2)


@formula(
    "f_fβT", Text("{iso_1328}: form of the helix, before rounding", iso_1328=ISO_1328), unit="µm", names={"A": "Q"}
)
def helix_form_tolerance(d: Metre, b: Metre, A: Number) -> Metre:
    return MICROMETRE * (0.07 * sqrt(d / MILLIMETRE) + 0.45 * sqrt(b / MILLIMETRE) + 4) * 2 ** ((A - 5) / 2)


@formula("F_T", Text("{iso_1328}: total of profile or helix, before rounding", iso_1328=ISO_1328), unit="µm")
def total_tolerance(f_H: Metre, f_f: Metre) -> Metre:
    return sqrt(f_H**2 + f_f**2)


@formula(
    "F_z",
    "ISO/TR 10064-3:1996, from memory: run-out of a face by which the wheel is clamped",
    unit="µm",
    names={"F_beta": "F_β"},
)
def face_runout(F_beta: Metre, d_a: Metre, b: Metre) -> Metre:
    return 0.2 * F_beta * d_a / b


@record
class ToothTolerances:
    """What the flanks of a wheel may deviate [m], and a face that clamps it; the runout is the wheel's own where the
    design gives one."""

    single_pitch: Metre
    total_pitch: Metre
    profile: Metre
    helix: Metre
    runout: Metre
    face: Metre
    extrapolated: tuple[Text, ...]  # sizes for which ISO 1328-1 has no tolerance


def tooth_tolerances(
    m_n: Metre, d: Metre, d_a: Metre, b: Metre, A: Number, runout: Metre | None = None
) -> ToothTolerances:
    """Of one wheel; nothing of the calculation hangs on them."""
    with untraced():
        form, slope = profile_form_tolerance(m_n=m_n, A=A), profile_slope_tolerance(d=d, m_n=m_n, A=A)
        helix_form, helix_slope = helix_form_tolerance(d=d, b=b, A=A), helix_slope_tolerance(d=d, b=b, A=A)
        helix = rounded(f=total_tolerance(f_H=helix_slope, f_f=helix_form))
        return ToothTolerances(
            single_pitch=rounded(f=single_pitch_tolerance(d=d, m_n=m_n, A=A)),
            total_pitch=rounded(f=total_pitch_tolerance(d=d, m_n=m_n, A=A)),
            profile=rounded(f=total_tolerance(f_H=slope, f_f=form)),
            helix=helix,
            runout=rounded(f=runout_of_grade(m_n=m_n, d=d, A=A)) if runout is None else runout,
            face=rounded(f=face_runout(F_beta=helix, d_a=d_a, b=b)),
            extrapolated=tuple(out_of_range(m_n, b, d)),
        )
