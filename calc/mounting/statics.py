# SPDX-License-Identifier: Apache-2.0
"""The engine at rest on its mounts: how far they give, what they carry, and how far it rolls under a torque that leaves
it."""

import numpy as np

from ..sheet.arrays import Array
from ..sheet.formula import formula
from ..sheet.linked_array import elements
from ..sheet.quantity import Described, Stated
from ..sheet.text import Text
from ..sheet.units import Metre, Metres, NewtonMetre, Newtons, NewtonsPerMetre, Number, Numbers, Radian
from ..sheet.value import based_on, link_of, linked
from .inputs import MountingInputs
from .modes import stiffness_matrix
from .result import Rest, StaticMount, Tree
from .system import System
from .wrenches import EngineWrenches

GRAVITY = 9.80665  # m/s²


@formula("q_s", "statics: equilibrium on the static stiffness of the mounts", shows="K_s⁻¹·f")
def rest(K_s: NewtonsPerMetre, f: Newtons) -> Metres:
    q: Array = np.linalg.solve(np.asarray(K_s), np.asarray(f))
    return q


@formula("δ_s", "kinematics: deflection along the mount's own axes", shows="Rᵀ·B·q_s", unit="mm")
def own_deflection(q_s: Metres, B: Numbers, R: Numbers) -> Metres:
    deflection: Array = np.einsum("jba,jbc,c->ja", np.asarray(R), np.asarray(B), np.asarray(q_s))
    return deflection


@formula("δ_1", "definition: amount of the deflection along the first own axis", unit="mm")
def first_axis(delta_s: Metre) -> Metre:
    return abs(delta_s)


@formula("F_s", "statics: upward force of the mount on the engine", shows="−up·R·diag(k)·δ_s")
def load(k: NewtonsPerMetre, delta_s: Metres, R: Numbers, up: Numbers) -> Newtons:
    """Of all mounts; below 0: it is pulled."""
    loads: Array = -np.einsum("jab,jb,a->j", np.asarray(R), np.asarray(k) * np.asarray(delta_s), np.asarray(up))
    return loads


@formula("φ_s", "kinematics: roll about the crank, positive from up to the side", shows="θ_z of q_s")
def roll(q_s: Metres) -> Radian:
    return float(np.asarray(q_s)[5])


def at_rest(mounting: MountingInputs, s: System) -> Rest:
    """`s`: on rigid ground."""
    k = based_on(np.array([mount.stiffness for mount in mounting.mounts], dtype=float), mounting.mounts)
    between = based_on(s.between, mounting.centre_of_gravity)
    up = np.asarray(mounting.up, dtype=float) / np.linalg.norm(mounting.up)
    K_s = stiffness_matrix(k=k, B=between, R=s.axes)
    weight = np.concatenate([-float(mounting.mass) * GRAVITY * up, np.zeros(3)])
    q = rest(K_s=K_s, f=based_on(weight, mounting.mass))
    q_T = rest(K_s=K_s, f=np.array([0, 0, 0, 0, 0, 1.0]))
    delta = own_deflection(q_s=q, B=between, R=s.axes)
    by_torque = own_deflection(q_s=q_T, B=between, R=s.axes)
    carried = load(k=k, delta_s=delta, R=s.axes, up=up)
    return Rest(*(np.asanyarray(x) for x in (delta, by_torque, carried, q, q_T)))


@formula("M_out", "statics: mean torque that the mounts carry where it leaves the body")
def output_moment(T_out: NewtonMetre, i_out: Number) -> NewtonMetre:
    return -T_out * i_out


def output(mounting: MountingInputs, driven: EngineWrenches, speeds: Array) -> tuple[float, ...]:
    """The mean torque on the mounts at each speed: 0 where it stays inside."""
    if mounting.torque_path == "inside":
        return (0.0,) * len(speeds)
    if mounting.output_torque is not None:
        torques = [mounting.output_torque] * len(speeds)
    else:
        torques = [based_on(x, driven.e.torque) for x in driven.mean_torque(speeds).tolist()]
    return tuple(output_moment(T_out=T, i_out=mounting.output_ratio) for T in torques)


def published(mounting: MountingInputs, rest: Rest, out: tuple[float, ...]) -> Tree:
    """Mount by mount, and the roll of the engine under its weight and the largest mean torque."""
    loads = elements(rest.load)
    tree: Tree = {}
    for j, mount in enumerate(mounting.mounts):
        delta_s = linked(float(rest.deflection[j, 0]), link_of(rest.deflection))
        tree[mount.name] = StaticMount(deflection=first_axis(delta_s=delta_s), load=loads[j])
    M_z = max(out, key=abs, default=0.0)
    q = based_on(rest.q + rest.q_by_torque * M_z, rest.q, rest.q_by_torque, M_z)
    tree["roll"] = Stated(Described(Text("Static roll, from up to the side"), "°", "φ_s"), roll(q_s=q))
    return tree


def preload(mounting: MountingInputs, K: Array) -> float:
    """What the weight itself adds to the stiffness against tilting, m·g·h over the lesser of the two; it is left out of
    the model."""
    up = np.asarray(mounting.up, dtype=float) / np.linalg.norm(mounting.up)
    arms = np.asarray(mounting.centre_of_gravity) - np.array([mount.position for mount in mounting.mounts])
    level = np.eye(3) - np.outer(up, up)
    _, least, _ = np.linalg.eigvalsh(level @ K[3:, 3:] @ level)  # the first: about up, which the weight leaves alone
    return float(mounting.mass) * GRAVITY * float(np.abs(arms @ up).max()) / float(least)
