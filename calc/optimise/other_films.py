# SPDX-License-Identifier: Apache-2.0
"""Films beside those of the corners: over the speeds of the engine, and over a turn with what stands still (weight and gear force).

Both are those of the nominal clearance.  Where they are thinner than at the corners, they say what slope a journal bears.
"""

from dataclasses import replace

import numpy as np

from ..bearings import formulas as f
from ..bearings.film import dynamics as d
from ..bearings.film.dynamics import Dynamics, coefficients, orbit
from ..bearings.film.nodes import FilmRangeError
from ..bearings.routes import supply
from ..bearings.routes.balance import settled
from ..bearings.routes.states import BearingCase, Film, OperatingPoint
from ..bearings.selection.grid import field_over, over_lengths
from ..bearings.selection.states import BALANCED, HOT, Task
from ..bearings.selection.variants import Variant
from ..bearings.loads import SMALL
from ..bearings.speeds import sweep_points
from ..engine.inputs import BenchPoint
from ..sheet.arrays import Array, each, many
from ..sheet.record import record
from ..sheet.units import Metre, Newton, Watt

NEAR = 1.05  # of the film at the corners: speeds whose film is thicker than that at a few sizes are not looked at; rule of this program


@record
class Stands:
    """What stands still on a bearing of one shaft: of its weight and of its gear, whose force goes with the power of the journals."""

    weight: Newton
    gear: Newton
    power: Watt  # of this journal

    def at(self, power: Array) -> Array:
        """With another power of it, the other journal's in proportion."""
        load: Array = self.weight + self.gear * power / self.power
        return load


@record
class Beside:
    """`bench`: rows of the engine, None: films over the speeds are no limit; `standing`: what stands still, None: likewise."""

    bench: tuple[BenchPoint, ...] | None = None
    standing: Stands | None = None


def over_speeds(task: Task, variant: Variant, length: Array, g: Array, corners: Array, bench: tuple[BenchPoint, ...]) -> Array | None:
    """The thinnest film over the speeds that govern; None where that of the corners is thinner at every one of a few sizes."""
    rows, columns = (np.unique(np.linspace(0, n - 1, 2).astype(int)) for n in (g.size, length.size))
    seat, at = sweep_points(task.seat, task.duty.speed, bench, task.duty)
    rated = task.duty.speed if task.seat.inputs.speed_range is None else np.inf
    governs = many(at.speed) <= rated * (1 + 1e-9)
    sizes = _sized(seat, length[columns][None, :, None], g[rows][:, None, None])
    with np.errstate(all="ignore"):
        films = np.where(governs, many(settled(sizes, at, hottest=HOT, tolerance=BALANCED).film), np.nan)
    films = np.where(np.isnan(films), np.inf, films)
    held = corners[np.ix_(rows, columns)]
    near = np.isfinite(films.min(-1)) & (films.min(-1) < NEAR * held) & np.isfinite(held)
    if not near.any():
        return None
    thinnest = np.full(corners.shape, np.inf)
    for n in np.unique(films.argmin(-1)[near]).tolist():
        one = OperatingPoint(**{name: float(np.broadcast_to(x, governs.shape)[n]) for name, x in vars(at).items()})
        field = field_over(replace(task, duty=one, corners=False), variant, length, g)
        assert field is not None
        film = np.broadcast_to(field.states.film[0], corners.shape)
        thinnest = np.fmin(thinnest, film)
    return thinnest


def over_a_turn(task: Task, length: Array, g: Array, stands: Stands) -> Array:
    """The film over the orbit, as bearings/stationary_load has it; where that is not known, under the largest load of the turn."""
    few, between = over_lengths(length)
    seat, load = _sized(task.seat, few[None, :], g[:, None]), task.duty.load
    with np.errstate(all="ignore"):
        film = settled(seat, task.duty, hottest=HOT, tolerance=BALANCED)
        standing = np.where(np.isfinite(many(film.film)), stands.at(many(film.friction_power)), 0.0)
        over = _over_orbit(film, task, seat, np.broadcast_to(few, standing.shape), standing)
        over = np.where(standing < SMALL * load, over, np.nan)
        if (unknown := np.isnan(over) & np.isfinite(many(film.film))).any():
            peak = settled(seat, replace(task.duty, load=each(load + standing)), hottest=HOT, tolerance=BALANCED)
            over = np.where(unknown, many(peak.film), over)
    return between(over)


def _over_orbit(film: Film, task: Task, seat: BearingCase, length: Array, standing: Array) -> Array:
    """Not a number where there is no film, or none of which stiffness and damping are known."""
    inputs, duty = seat.inputs, task.duty
    there = np.isfinite(many(film.film))
    over = np.full(there.shape, np.nan)
    eps, phi, h_0, g = (each(np.broadcast_to(many(x), there.shape)[there]) for x in (
        film.eccentricity, film.attitude if film.attitude is not None else np.nan, film.film, film.clearance))  # fmt: skip
    bare = supply.bare_length(inputs, length[there])
    ratio = f.length_ratio(l=each(bare / 2 if supply.lands(inputs) == 2 else bare), d=task.diameter)
    try:
        k = coefficients(eps, ratio, phi)
    except FilmRangeError:
        return over
    F, omega = duty.load, f.angular_speed(n=duty.effective_speed)
    across = d.damping_xy(c_xy=k.c_xy, F=F, g=g, omega=omega)
    moving = Dynamics(
        stiffness_xx=d.stiffness_xx(k_xx=k.k_xx, F=F, g=g), stiffness_xy=d.stiffness_xy(k_xy=k.k_xy, F=F, g=g),
        stiffness_yx=d.stiffness_yx(k_yx=k.k_yx, F=F, g=g), stiffness_yy=d.stiffness_yy(k_yy=k.k_yy, F=F, g=g),
        damping_xx=d.damping_xx(c_xx=k.c_xx, F=F, g=g, omega=omega), damping_xy=across, damping_yx=across,
        damping_yy=d.damping_yy(c_yy=k.c_yy, F=F, g=g, omega=omega),
    )  # fmt: skip
    over[there] = f.film_over_turn(h_0=h_0, a_n=orbit(moving, each(standing[there]), phi, duty, seat).film_loss)
    return over


def _sized(seat: BearingCase, l: Array, g: Array) -> BearingCase:
    clearance: Metre = each(g)
    return replace(seat, bearing=replace(seat.bearing, length=each(l)), clearance=clearance)
