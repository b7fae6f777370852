# SPDX-License-Identifier: Apache-2.0
"""Load cycles and the life factors Z_NT (flank) and Y_NT (root) of ISO 6336-2 and -3.

The curves are straight lines between knees in log–log scale.  To the left of the first knee the strength is static and constant.  Past the
last knee but one the standard leaves a range: 0.85 at 10¹⁰ cycles, up to 1 with the best material, making, lubrication and experience; the
curves here take 0.85.  Where no life is given the factor is 1: the strength at the knee (5·10⁷ or 2·10⁶ on the flank, 3·10⁶ at the root).
The lubricant, surface and notch factors stay those of the long life on the whole curve; the standard drops them towards static strength.
"""

from ...sheet.formula import formula
from ...sheet.functions import ln, power
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Number, RevPerSecond, Second

FLANK = Text("ISO 6336-2:2006 and 2019, Table 2")
ROOT = Text("ISO 6336-3:2006 and 2019, Table 1")
LONGEST = 1e10  # cycles: the end of the tables

Knees = tuple[tuple[float, float], ...]  # (cycles, factor), rising cycles
STEEL: Knees = ((1e5, 1.6), (5e7, 1.0), (LONGEST, 0.85))
STEEL_PITTING: Knees = ((6e5, 1.6), (1e7, 1.3), (1e9, 1.0), (LONGEST, 0.85))
NITRIDED: Knees = ((1e5, 1.3), (2e6, 1.0), (LONGEST, 0.85))
NITROCARBURISED: Knees = ((1e5, 1.1), (2e6, 1.0), (LONGEST, 0.85))
FLANK_CURVES = {"GG": NITRIDED, "GGG(ferr.)": NITRIDED, "NT(nitr.)": NITRIDED, "NV(nitr.)": NITRIDED, "NV(nitrocar.)": NITROCARBURISED}
ROOT_THROUGH: Knees = ((1e4, 2.5), (3e6, 1.0), (LONGEST, 0.85))  # St, V, GTS, GGG(perl.)
ROOT_HARDENED: Knees = ((1e3, 2.5), (3e6, 1.0), (LONGEST, 0.85))
ROOT_NITRIDED: Knees = ((1e3, 1.6), (3e6, 1.0), (LONGEST, 0.85))
ROOT_NITROCARBURISED: Knees = ((1e3, 1.1), (3e6, 1.0), (LONGEST, 0.85))
ROOT_CURVES = {
    "Eh": ROOT_HARDENED, "IF": ROOT_HARDENED, "GG": ROOT_NITRIDED, "GGG(ferr.)": ROOT_NITRIDED, "NT(nitr.)": ROOT_NITRIDED,
    "NV(nitr.)": ROOT_NITRIDED, "NV(nitrocar.)": ROOT_NITROCARBURISED,
}  # fmt: skip


@formula("N_L", "ISO 6336-6: load cycles of one flank; n_c: loaded contacts in a turn", names={"c": "n_c"})
def load_cycles(n: RevPerSecond, L_h: Second, c: Number) -> Number:
    return abs(n) * L_h * c


@formula("p_N", "mathematics: straight line between two knees of the life curve, log–log")
def life_exponent(Y_1: Number, Y_2: Number, N_1: Number, N_2: Number) -> Number:
    return ln(Y_1 / Y_2) / ln(N_2 / N_1)


@formula("Z_NT", Text("{flank}: life factor, contact; from the knee Z_1 at N_1", flank=FLANK), names={"p": "p_N"})
def flank_life_factor(Z_1: Number, N_1: Number, N_L: Number, p: Number) -> Number:
    return Z_1 * power(N_1 / N_L, p)


@formula("Y_NT", Text("{root}: life factor, root; from the knee Y_1 at N_1", root=ROOT), names={"p": "p_N"})
def root_life_factor(Y_1: Number, N_1: Number, N_L: Number, p: Number) -> Number:
    return Y_1 * power(N_1 / N_L, p)


@record
class Segment:
    """The line of a curve that holds at a number of cycles: from (N_1, Y_1), falling with the power p."""

    N_1: Number
    Y_1: Number
    p: Number


def contacts_per_turn(driven: int, drives: int) -> int:
    """Loaded contacts of the flank that sees most of them, and of the root, in one turn.

    As a driven wheel one flank is loaded, as a driver the other: an idler loads each flank once a turn (and its root once each way), a
    driver of two wheels the same flank twice.
    """
    return max(driven, drives, 1)


def flank_knees(kind: str, pitting: bool = False) -> Knees:
    """The flank's curve; `pitting`: some of it may be borne, which only the curve of steel knows."""
    curve = FLANK_CURVES.get(kind, STEEL)
    return STEEL_PITTING if pitting and curve is STEEL else curve


def root_knees(kind: str) -> Knees:
    return ROOT_CURVES.get(kind, ROOT_THROUGH)


def flank_life(kind: str, N_L: Number | None = None, pitting: bool = False) -> Number:
    """Z_NT; without a number of cycles that of the endurance limit, 1."""
    knees = flank_knees(kind, pitting)
    N_L = endurance(knees) if N_L is None else N_L
    line = segment(knees, N_L)
    return flank_life_factor(Z_1=line.Y_1, N_1=line.N_1, N_L=N_L, p=line.p)


def root_life(kind: str, N_L: Number | None = None) -> Number:
    """Y_NT; without a number of cycles that of the endurance limit, 1."""
    knees = root_knees(kind)
    N_L = endurance(knees) if N_L is None else N_L
    line = segment(knees, N_L)
    return root_life_factor(Y_1=line.Y_1, N_1=line.N_1, N_L=N_L, p=line.p)


def endurance(knees: Knees) -> Number:
    """The cycles at which the factor is 1."""
    return next(N for N, Y in knees if Y == 1.0)


def segment(knees: Knees, N_L: Number) -> Segment:
    """Past the last knee the last line goes on: the tables end at 10¹⁰ cycles."""
    if N_L <= knees[0][0]:
        return Segment(*knees[0], 0.0)
    i = next((i for i, (N, _) in enumerate(knees) if N_L < N), len(knees) - 1)
    (N_1, Y_1), (N_2, Y_2) = knees[i - 1], knees[i]
    return Segment(N_1, Y_1, life_exponent(Y_1=Y_1, Y_2=Y_2, N_1=N_1, N_2=N_2))
