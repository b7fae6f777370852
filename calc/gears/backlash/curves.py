# SPDX-License-Identifier: Apache-2.0
"""Tables and the figure of the play of a train, made only when they are looked at."""

from collections.abc import Mapping, Sequence

import numpy as np

from ...sheet.arrays import Value
from ...sheet.step import Curve, Series, Table, axis_label
from ...sheet.text import Amount, Text
from ...sheet.units import Metre
from ...sheet.value import untraced
from ..inputs import GearsInputs
from . import formulas as b
from . import temperature as t
from .case import BacklashCase
from .formulas import PlayResult

UM = 1e6
POINTS = 61
Known = Sequence[tuple[BacklashCase, t.Expansions]]
Row = tuple[str | float | None, ...]
KINDS = {"position": Text("position"), "fit": Text("fit"), "runout": Text("runout"), "radial": Text("radial")}
LIMITS = {"smallest": Text("smallest"), "nominal": Text("nominal"), "largest": Text("largest")}


def tables(gears: GearsInputs, known: Known, play: Mapping[str, PlayResult]) -> tuple[Table, ...]:
    with untraced():
        tables = [_kinds(known), _states(gears, known)]
        if any(m.stack is not None for m, _ in known):
            tables.append(_stack(known, play))
    return tuple(tables)


def curves(gears: GearsInputs, known: Known) -> tuple[Curve, ...]:
    """Backlash over the temperature of the housing, a figure for each mesh, the tightest first."""
    low, high = sorted((gears.lowest_temperature, gears.running_temperature))
    T = np.linspace(low, high, POINTS)
    drawn = []
    with untraced():
        for m, alpha in sorted(known, key=lambda pair: pair[0].mesh.backlash_min):
            warmer = Text("smallest, wheels {wheels_warmer} K warmer", wheels_warmer=Amount(gears.warmer, form="g"))
            lines = [(LIMITS["nominal"], T, "nominal"), (warmer, T + gears.warmer, "smallest")]
            lines += [(LIMITS[limit], T, limit) for limit in ("smallest", "largest")]  # the band
            series = tuple(Series(label, T, _at(m, alpha, T, wheels, limit) * UM) for label, wheels, limit in lines)
            _, warmest, smallest, _ = (line.y for line in series)
            ends = ((low, smallest[0]), (high, smallest[-1]), (high, warmest[-1]), (low, warmest[0]))  # what is judged
            states = tuple((at, float(j_bn)) for at, j_bn in ends)
            least = min(states, key=lambda state: state[1])
            drawn.append(
                Curve(
                    f"backlash_temperature_{m.key}",
                    Text("Normal backlash over temperature, {name}", name=m.name),
                    axis_label("temperature of the housing", "°C"),
                    axis_label("j_bn", "µm"),
                    series,
                    limits=((Text("jam"), 0.0),),
                    point=least,
                    fails=least[1] < 0,
                    band=True,
                    short=1,
                )
            )
    return tuple(drawn)


def _ends(m: BacklashCase) -> dict[str, tuple[Metre, Metre, Metre]]:
    """Centre distance and both thicknesses at the base circle, by the limit of the backlash; runout in the smallest
    alone."""
    (one, two), a = m.teeth, m.mesh.centre_distance
    return {
        "smallest": (m.closest, one.thickest, two.thickest),
        "nominal": (a, one.middle, two.middle),
        "largest": (a + m.mesh.centre_tolerance, one.thinnest, two.thinnest),
    }


def _at(m: BacklashCase, alpha: t.Expansions, housing: Value, wheels: Value, limit: str) -> Value:
    """Normal backlash at temperatures."""
    a, s_b1, s_b2 = _ends(m)[limit]
    grown = t.grown(m, alpha, housing, wheels)
    a_eff = b.effective_centre(a=a, eps_a=grown.centres, eps_g=grown.wheels)
    with np.errstate(invalid="ignore"):  # where the base circles overlap the curve has a gap
        alpha_wt: Value = np.arccos(m.touching / a_eff)
    return t.warm(m, grown, alpha_wt, s_b1, s_b2)


def _kinds(known: Known) -> Table:
    """The backlash of every mesh along other lines, over its tolerances."""
    rows: list[Row] = []
    for m, _ in known:
        backlashes = m.mesh.backlash_min, m.mesh.backlash_nominal, m.mesh.backlash_max
        for limit, j_bn, shift in zip(LIMITS, backlashes, (-1, 0, 1)):
            alpha_wt = float(np.arccos(m.touching / (m.mesh.centre_distance + shift * m.mesh.centre_tolerance)))
            d_w = m.driven.base_diameter / float(np.cos(alpha_wt))
            j_wt = b.circumferential_of_normal(j_bn=j_bn, alpha_wt=alpha_wt, beta_b=m.system.base_helix_angle)
            j_t = b.reference_backlash(j_wt=j_wt, d=m.driven.reference_diameter, d_w=d_w)
            j_r = b.radial_backlash(j_wt=j_wt, alpha_wt=alpha_wt)
            turn = np.degrees(j_wt / (d_w / 2))
            rows.append((m.name, LIMITS[limit], j_bn * UM, j_wt * UM, j_t * UM, j_r * UM, float(turn)))
    columns = (
        (Text("mesh"), ""),
        (Text("backlash"), ""),
        (Text("j_bn"), "µm"),
        (Text("j_wt"), "µm"),
        (Text("j_t"), "µm"),
        (Text("j_r"), "µm"),
        (Text("free turn"), Text("°")),
    )
    return Table(
        "backlash_kinds",
        Text("Backlash of the meshes"),
        columns,
        tuple(rows),
        Text(
            "Normal, at the working circle, at the reference circle, radial; free turn of the driven wheel. At 20 °C, "
            "without runout."
        ),
    )


def _states(gears: GearsInputs, known: Known) -> Table:
    reference = t.ThermalState(Text("reference"), b.REFERENCE, b.REFERENCE)
    rows: list[Row] = []
    for m, alpha in known:
        for state in (reference, *t.states(gears, gears.warmer)):
            change = t.change(m, t.grown(m, alpha, state.housing, state.wheels))
            numbers = (float(_at(m, alpha, state.housing, state.wheels, limit)) * UM for limit in LIMITS)
            rows.append((m.name, state.name, state.housing, state.wheels, change * UM, *numbers))
    columns = (
        (Text("mesh"), ""),
        (Text("state"), ""),
        (Text("housing"), "°C"),
        (Text("wheels"), "°C"),
        (Text("Δa_eff"), "µm"),
        *((label, "µm") for label in LIMITS.values()),
    )
    note = Text("Normal backlash over tolerances and allowances; the smallest with the runout of the teeth.")
    return Table("backlash_states", Text("Backlash over temperature"), columns, tuple(rows), note)


def _stack(known: Known, play: Mapping[str, PlayResult]) -> Table:
    """Every part with what it can shift and its share of the variance, then the sums of each mesh."""
    rows: list[Row] = []
    for m, _ in known:
        if (stack := m.stack) is None:
            continue
        deviation = stack.spread * stack.fields / 2
        variance = float(np.sum(deviation**2))
        for name, kind, field, part in zip(stack.names, stack.kinds, stack.fields.tolist(), deviation.tolist()):
            of_variance = 100 * part**2 / variance if variance else None
            rows.append((m.name, name, KINDS.get(kind, ""), field * 1e3, field / 2 * UM, part * UM, of_variance))
        sums = play[m.key]
        for label, number in (
            (Text("worst case (±)"), sums.centre_tolerance_worst),
            (Text("root of squares (±)"), sums.centre_tolerance_rss),
            (Text("3 standard deviations (±)"), sums.centre_tolerance_chance),
        ):
            rows.append((m.name, label, "", None, None if number is None else number * UM, None, None))
    columns = (
        (Text("mesh"), ""),
        (Text("part"), ""),
        (Text("kind"), ""),
        (Text("field"), "mm"),
        (Text("shift (±)"), "µm"),
        (Text("deviation"), "µm"),
        (Text("of the variance"), "%"),
    )
    note = Text(
        "Root of squares as the source takes it: of the whole fields, half to each side. Deviation: standard "
        "deviation by the kind."
    )
    return Table("centre_stack", Text("Parts between the centres"), columns, tuple(rows), note)
