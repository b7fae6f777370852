# SPDX-License-Identifier: Apache-2.0
"""The modes of the engine on rigid ground: frequencies, where their energy stands, their names; and how an engine is
free that has none."""

import math
from functools import cache
from itertools import permutations

import numpy as np

from ..sheet.arrays import Array, ComplexArray, IndexArray
from ..sheet.errors import NoSolution
from ..sheet.formula import formula
from ..sheet.functions import pi, sqrt
from ..sheet.record import record
from ..sheet.text import Amount, Text
from ..sheet.units import Hertz, Kilograms, NewtonsPerMetre, Number, Numbers, PerSecond2, PerSeconds2
from .body import DOFS
from .inputs import DOF_WORDS

FREE = 1e-9  # of the largest eigenvalue: a mode so slow has no spring
DUST = 1e-11  # of the largest of its coordinate: a part of a shape so small is none
MIXED = 0.6  # energy below which a name alone says too little


@formula("K", "dynamics: stiffness of all mounts about the centre of gravity", shows="Σ Bᵀ·R·diag(k)·Rᵀ·B")
def stiffness_matrix(k: NewtonsPerMetre, B: Numbers, R: Numbers) -> NewtonsPerMetre:
    """`k` along own axes (mounts, 3), `B` how each mount moves with the body, `R` its axes."""
    D = np.swapaxes(np.asarray(R), 1, 2) @ np.asarray(B)
    stiffness: Array = np.einsum("jai,ja,jab->ib", D, np.asarray(k), D)
    return stiffness


@formula(
    "ω²",
    "dynamics: squared angular frequencies of a rigid body's free vibration on springs",
    shows="eigenvalues of K·φ = ω²·M·φ, ascending",
)
def eigenvalues(K: NewtonsPerMetre, M: Kilograms) -> PerSeconds2:
    return eigen(np.asarray(K), np.asarray(M))[0]


@formula("f", "definition of the frequency", unit="Hz", names={"omega2": "ω²"})
def frequency(omega2: PerSecond2) -> Hertz:
    return sqrt(omega2) / (2 * pi)


@formula(
    "φ",
    "dynamics: squared angular frequencies of a rigid body's free vibration on springs",
    shows="K·φ = ω²·M·φ with φᵀ·M·φ = 1, a column for each mode",
)
def shapes(K: NewtonsPerMetre, M: Kilograms) -> Numbers:
    phi = eigen(np.asarray(K), np.asarray(M))[1]
    return np.where(np.abs(phi) > DUST * np.abs(phi).max(-1, keepdims=True), phi, 0.0)


@formula(
    "E",
    "definition of the kinetic energy of a mode in a coordinate: its share of the whole, φᵀ·M·φ = 1",
    unit="%",
    names={"p": "(M·φ)"},
)
def energy(phi: Number, p: Number) -> Number:
    """Over the coordinates and over the modes it sums to 1; it may be negative where the body has products of
    inertia."""
    return phi * p


@formula("η_i", "definition of the loss factor of a mode", shows="φᵀ·Im K*·φ/ω²")
def mode_loss(K_loss: NewtonsPerMetre, K: NewtonsPerMetre, M: Kilograms) -> Numbers:
    values, phi = eigen(np.asarray(K), np.asarray(M))
    losses: Array = np.einsum("im,ij,jm->m", phi, np.asarray(K_loss), phi) / values
    return losses


@formula(
    "s_i",
    "dynamics: share of a mode in the motion under a torque about the crank",
    shows="(φ_iᵀ·M·q_T)²/(q_Tᵀ·M·q_T)",
    unit="%",
)
def roll_shares(K: NewtonsPerMetre, M: Kilograms) -> Numbers:
    mass = np.asarray(M)
    _, phi = eigen(np.asarray(K), mass)
    q = np.zeros(6)
    q[3:] = np.linalg.solve(mass[3:, 3:], np.array([0.0, 0.0, 1.0]))
    shares: Array = (phi.T @ mass @ q) ** 2 / (q @ mass @ q)
    return shares


def eigen(K: Array, M: Array) -> tuple[Array, Array]:
    """ω² ascending and the shapes as columns, φᵀMφ = 1; of one body or of many at once."""
    inverse = np.linalg.inv(np.linalg.cholesky(M))
    turned = np.swapaxes(inverse, -1, -2)
    values, vectors = np.linalg.eigh(inverse @ K @ turned)
    return values, turned @ vectors


@cache
def assignments() -> IndexArray:
    """All 720 ways to give six modes the names of six coordinates."""
    return np.array(list(permutations(range(6))))


def named(E: Array) -> IndexArray:
    """For each coordinate the mode that has its name: the assignment with the largest sum of energies.  `E`: (…,
    coordinates, modes)."""
    ways = assignments()
    sums = E[..., np.arange(6), ways].sum(-1)
    best: IndexArray = ways[sums.argmax(-1)]
    return best


@record
class Modes:
    """Six modes, slowest first; `of`: the mode of each coordinate, in the order of DOFS."""

    frequencies: Array
    shapes: Array
    energy: Array
    of: tuple[int, ...]

    def name(self, mode: int) -> str:
        return DOFS[self.of.index(mode)]

    def words(self, mode: int) -> Text:
        """The name of a mode, or what it is mixed of."""
        name, E = self.name(mode), self.energy[:, mode]
        if E[DOFS.index(name)] >= MIXED:
            return DOF_WORDS[name]
        first, second = (DOFS[i] for i in np.argsort(-E)[:2])
        a, b = (Amount(100 * float(E[DOFS.index(dof)]), form=".0f") for dof in (first, second))
        return Text("mixed, {first} {a} / {second} {b}", first=DOF_WORDS[first], a=a, second=DOF_WORDS[second], b=b)


def modes(K: Array, M: Array) -> Modes:
    """Raises NoSolution, and says how the engine is free, where the springs leave it a motion."""
    K, M = np.asarray(K), np.asarray(M)
    values, phi = eigen(K, M)
    if not np.isfinite(values).all() or values[0] <= FREE * values[-1]:
        raise NoSolution(
            Text("the mounts do not hold the engine"),
            free_motion(K, M),
            Text("move a mount, or give it stiffness in another direction"),
        )
    E = phi * (M @ phi)
    return Modes(np.sqrt(values) / (2 * math.pi), phi, E, tuple(named(E).tolist()))


def free_motion(K: Array, M: Array) -> Text:
    """How an engine is free whose stiffness is singular: from the motion that no spring resists."""
    _, phi = eigen(K, M)
    u, theta = phi[:3, 0], phi[3:, 0]
    size = float(np.linalg.norm(theta))
    reach = math.sqrt(float(np.trace(M[3:, 3:])) / (3 * float(M[0, 0])))
    if size * reach < 1e-6 * float(np.linalg.norm(u)):
        return Text("it moves freely along [{direction}]", direction=_components(u / np.linalg.norm(u)))
    axis = theta / size
    near = np.cross(theta, u) / size**2  # the point of the axis nearest to the centre of gravity
    return Text(
        "it turns freely about the line through [{place}] mm from its centre of gravity along [{direction}]",
        place=_components(near * 1e3, ".0f"),
        direction=_components(axis),
    )


def _components(x: Array, form: str = ".2f") -> str:
    sign = -1.0 if x[np.argmax(np.abs(x))] < 0 and form == ".2f" else 1.0
    digits = int(form[1])
    return ", ".join(format(round(sign * float(component), digits) + 0.0, form).replace("-", "−") for component in x)


def of_whole(K: ComplexArray, M: Array) -> Array:
    """Frequencies of the engine and the frame together, from the real part of the stiffness."""
    values, _ = eigen(K.real, M)
    frequencies: Array = np.sqrt(np.maximum(values, 0.0)) / (2 * math.pi)
    return frequencies
