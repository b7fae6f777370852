# SPDX-License-Identifier: Apache-2.0
"""Mounts to choose from: stiffness, shear ratio and inclination of the front and of the rear ones, which decouple the
modes best.

A candidate keeps all modes between the road's frequency and what isolates at idle; of those that do, the one counts
whose modes are purest.  The lattice of whole steps and the way through it are those of every search of the program
(`sheet/search.py`)."""

import math
from functools import cache

import numpy as np

from ..sheet.arrays import Array, BoolArray
from ..sheet.errors import NoSolution
from ..sheet.progress import Progress, tell
from ..sheet.quantity import dotted
from ..sheet.record import record, replace
from ..sheet.remedy import Changes
from ..sheet.search import judged, least, narrowed
from ..sheet.step import Table
from ..sheet.text import Amount, Text
from .body import DOFS, own_foundation
from .inputs import Mount, MountingInputs
from .modes import assignments, eigen
from .result import MountingResult

STEPS = np.array([5e3, 0.05, math.radians(1.0)])  # static stiffness [N/m], shear over compression, inclination [rad]
LOW, HIGH = np.array([16, 5, 0]), np.array([80, 20, 50])  # in steps: 80 … 400 N/mm, 0.25 … 1, 0 … 50°
TARGETS = np.array([0.95, 0.85, 0.85, 0.85, 0.85, 0.95])  # of the energies, in the order of DOFS
STARTS = ((34, 10, 15), (24, 6, 30), (50, 14, 25))  # in steps, front and rear alike
SIDE = 3  # points of the grid along each axis
FIRST_STEP = 4
ISOLATES = math.sqrt(2.0)


@record
class MountRoom:
    """What does not change from candidate to candidate; places from the centre of gravity."""

    B: Array  # (mounts, 3, 6)
    M: Array
    side: Array  # (mounts,): −1, 1 beside the crank, 0 on it
    rear: BoolArray  # (mounts,): whether it stands behind the middle of all
    ratio: Array  # dynamic over static
    ground: Array  # (mounts, 3) of the foundation; infinite where it is rigid
    lowest: float  # Hz
    highest: float


@record
class Candidate:
    """One row: front and rear (stiffness, shear ratio, inclination), and what it gives."""

    variables: Array  # (2, 3) in SI
    frequencies: Array  # of the named modes, in the order of DOFS
    energies: Array
    missed: float  # Σ max(0, target − E)²
    inside: bool

    def mounts(self, mounting: MountingInputs, room: MountRoom) -> MountingInputs:
        """The design with it."""
        mounts = []
        for mount, at, side in zip(mounting.mounts, room.rear, room.side):
            k, s, phi = self.variables[int(at)].tolist()
            mounts.append(replace(mount, stiffness=(k, k * s, k * s), turned=(0.0, 0.0, -float(side) * phi)))
        return replace(mounting, mounts=tuple(mounts))


def room(mounting: MountingInputs, result: MountingResult) -> MountRoom:
    """Raises NoSolution where nothing drives the engine, or where no frequency is left between the road's and what
    drives it."""
    ceiling = result.window.shaft if result.has_shaft else result.window.half
    if ceiling is None:
        raise NoSolution(Text("there is nothing to isolate from"), Text("no order drives the engine"))
    highest = float(ceiling.lowest_order) * float(mounting.idle_speed) / ISOLATES
    if highest <= mounting.road_frequency:
        what = Text("no frequency is left between the road's and what isolates at idle")
        tried = Text("{low} to {high}", low=Amount(mounting.road_frequency, "Hz"), high=Amount(highest, "Hz"))
        raise NoSolution(what, tried, Text("raise idle_speed_rpm or lower road_frequency_Hz"))
    places = np.array([mount.position for mount in mounting.mounts])
    ground = np.array([own_foundation(mount) for mount in mounting.mounts])
    middle = float((places[:, 2].min() + places[:, 2].max()) / 2)
    return MountRoom(
        result.system.between[:, :, :6],
        result.stiffness[1],
        np.sign(places[:, 1]),
        places[:, 2] > middle,
        np.array([mount.dynamic_ratio for mount in mounting.mounts]),
        ground,
        float(mounting.road_frequency),
        highest,
    )


def evaluated(at: MountRoom, points: Array) -> tuple[Array, Array, Array, Array]:
    """Of many candidates (n, 6 in steps): margin, what is missed of the targets, frequencies and energies of the named
    modes."""
    x = points.reshape(len(points), 2, 3) * STEPS
    mine = x[:, at.rear.astype(int)]  # (n, mounts, 3)
    k, s, phi = mine[..., 0], mine[..., 1], -at.side * mine[..., 2]
    stiffness = np.stack([k, k * s, k * s], -1) * at.ratio[:, None]
    stiffness = stiffness / (1 + stiffness / at.ground)
    c, d = np.cos(phi), np.sin(phi)
    along = np.stack([c, d, 0 * c], -1)[..., None, :] @ at.B  # (n, mounts, 1, 6): compression, then the two shears
    across = np.stack([-d, c, 0 * c], -1)[..., None, :] @ at.B
    flat = np.broadcast_to(at.B[:, 2:3], across.shape)
    D = np.concatenate([along, across, flat], -2)
    K = np.einsum("nmai,nma,nmaj->nij", D, stiffness, D)
    values, phi_ = eigen(K, at.M)
    E = phi_ * (at.M @ phi_)
    of = assignments()[(E.reshape(-1, 36) @ _indicator()).argmax(-1)]  # (n, 6): the mode of each coordinate
    rows = np.arange(len(points))[:, None]
    f = np.sqrt(np.maximum(values, 0.0)) / (2 * math.pi)
    energy = E[rows, np.arange(6), of]
    margin = least([judged("road", f[:, 0], at.lowest), judged("separation", f[:, -1], at.highest, "<=")])
    missed = (np.maximum(0.0, TARGETS - energy) ** 2).sum(-1)
    return margin, missed, f[rows, of], energy


@cache
def _indicator() -> Array:
    """Which entries of an energy table each of the 720 assignments adds up (36, 720)."""
    indicator = np.zeros((36, len(assignments())))
    for j in range(6):
        indicator[6 * j + assignments()[:, j], np.arange(len(assignments()))] = 1.0
    return indicator


def choices(
    mounting: MountingInputs, result: MountingResult, progress: Progress | None = None
) -> tuple[MountRoom, tuple[Candidate, ...]]:
    """The best of each start, each once: those inside the window first, the purest modes first."""
    at = room(mounting, result)
    low, high = np.tile(LOW, 2), np.tile(HIGH, 2)

    def evaluate(points: Array) -> tuple[Array, Array]:
        margin, missed, _, _ = evaluated(at, points)
        return margin, missed

    candidates: dict[tuple[int, ...], Candidate] = {}
    for n, start in enumerate(STARTS):
        tell(progress, n / len(STARTS), Text("start {n} of {count}", n=n + 1, count=len(STARTS)))
        best, _, _ = narrowed(evaluate, low, high, np.tile(start, 2), np.full(6, FIRST_STEP), SIDE)
        margin, missed, f, E = evaluated(at, best[None])
        variables = best.reshape(2, 3) * STEPS
        candidate = Candidate(variables, f[0], E[0], float(missed[0]), bool(margin[0] >= 0))
        candidates.setdefault(tuple(best.tolist()), candidate)
    return at, tuple(
        sorted(candidates.values(), key=lambda row: (not row.inside, row.missed, -float(row.energies.min())))
    )


def changes(candidate: Candidate, mounting: MountingInputs, at: MountRoom) -> Changes:
    """What writes it into the design."""
    design = candidate.mounts(mounting, at)
    changed: Changes = {}
    for mount in design.mounts:
        assert mount.turned is not None
        stiffness = dotted("mounting", MountingInputs.mounts, mount.name, Mount.stiffness)
        changed[stiffness] = [round(k / 1e3, 6) for k in mount.stiffness]
        turned = dotted("mounting", MountingInputs.mounts, mount.name, Mount.turned)
        changed[turned] = [round(math.degrees(angle), 6) + 0.0 for angle in mount.turned]
    return changed


def table(candidates: tuple[Candidate, ...], at: MountRoom, top: int) -> Table:
    leaning = (Text("shear"), ""), (Text("leans"), "°")
    front, rear = (Text("front"), "N/mm"), (Text("rear"), "N/mm")
    frequencies = (Text("lowest"), "Hz"), (Text("highest"), "Hz")
    energies = (Text("bounce"), "%"), (Text("roll"), "%"), (Text("least"), "%")
    columns = ((Text("number"), ""), front, *leaning, rear, *leaning, *frequencies, *energies)
    rows = []
    for n, candidate in enumerate(candidates[:top], 1):
        mounts = (candidate.variables / (1e3, 1.0, math.pi / 180)).round(6).ravel().tolist()
        f, E = candidate.frequencies.tolist(), candidate.energies.tolist()
        percent = (100 * energy for energy in (E[DOFS.index("bounce")], E[DOFS.index("roll")], min(E)))
        rows.append((n, *mounts, min(f), max(f), *percent))
    note = Text(
        "Static stiffness in compression, shear over compression, inclination inwards; all modes from {low} to {high}: "
        "the road's, and what isolates at idle.",
        low=Amount(at.lowest, "Hz"),
        high=Amount(at.highest, "Hz", digits=3),
    )
    return Table("mounts", Text("Mounts that decouple the modes"), columns, tuple(rows), note)
