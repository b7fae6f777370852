# SPDX-License-Identifier: Apache-2.0
"""The torque that the teeth are rated with: the mean of the power balance, and what the crank's irregularity adds by inertia.

The crank speeds up and slows down; whatever it drives has to follow through the teeth.  For a counter-shaft that is far more than its
friction: the flanks then leave each other and hit (rattle).  Either the peak of mean and dynamic torque is rated, with K_A = 1, or K_A
times the mean; never both.
"""

from collections.abc import Mapping

from ...catalogue import Material
from ...sheet.check import Check, check
from ...sheet.formula import formula
from ...sheet.functions import pi
from ...sheet.record import record
from ...sheet.trace import about
from ...sheet.units import KilogramMetre2, KilogramPerMetre3, Metre, NewtonMetre, Number, RadPerSecond, RadPerSecond2, RevPerSecond, Watt
from ..inputs import GearsInputs
from ..result import TrainResult

USUAL = 1.25


@record
class Power:
    """What the mean torque comes from: the power of the first driver, or that of the driver in every mesh."""

    of: Mapping[str, Watt] | Watt


@record
class Irregularity:
    """How unevenly the first driver turns, and what hangs on the last wheel."""

    delta_s: Number  # (ω_max − ω_min)/ω
    order: Number  # of the crank
    shaft_inertia: KilogramMetre2 | None  # on the axis of the last wheel, with that wheel where `with_wheel`
    with_wheel: bool


@record
class Load:
    """Torques at the driver of one mesh."""

    mean: NewtonMetre
    dynamic: NewtonMetre | None
    rated: NewtonMetre  # that of F_t
    K_A: Number


@formula("K_A", "usual for a combustion engine that drives a uniform load through a balanced train (ISO 6336-6, from memory)", shows="1.25")
def usual_application_factor() -> Number:
    return float(str(USUAL))


@formula("K_A", "the peak torque holds what the application adds", shows="1")
def factor_of_peak() -> Number:
    return float("1")


@formula("T_m", "mean torque of a power")
def mean_torque(P: Watt, n: RevPerSecond) -> NewtonMetre:
    return P / (2 * pi * abs(n))


@formula("T_2", "torque handed on without loss")
def torque_of_driven(T: NewtonMetre, z_2: Number, z_1: Number) -> NewtonMetre:
    return T * z_2 / z_1


@formula("ω", "definition of the angular speed")
def angular_speed(n: RevPerSecond) -> RadPerSecond:
    return 2 * pi * n


@formula("ω'", "harmonic irregularity of one order: ω·(1 + δ_s/2·sin(i·ω·t)), its largest acceleration")
def angular_acceleration(delta_s: Number, i: Number, omega: RadPerSecond) -> RadPerSecond2:
    return delta_s / 2 * i * omega**2


@formula("J_i", "disc of the reference diameter, with its bore", unit="kg·mm²")
def wheel_inertia(rho: KilogramPerMetre3, b: Metre, d: Metre, d_i: Metre) -> KilogramMetre2:
    return pi / 32 * rho * b * (d**4 - d_i**4)


@formula("J", "sum of what turns on one axis", unit="kg·mm²")
def with_shaft(J: KilogramMetre2, J_S: KilogramMetre2) -> KilogramMetre2:
    return J + J_S


@formula("J", "kinetic energy: what a mesh drives, by the square of the ratio", unit="kg·mm²")
def with_driven(J: KilogramMetre2, J_2: KilogramMetre2, z_1: Number, z_2: Number) -> KilogramMetre2:
    return J + J_2 * (z_1 / z_2) ** 2


@formula("T_dyn", "torque at the driver that accelerates all that its mesh drives", names={"alpha": "ω'", "z_d": "z_1,train"})
def dynamic_torque(J_2: KilogramMetre2, z_1: Number, z_2: Number, alpha: RadPerSecond2, z_d: Number) -> NewtonMetre:
    """The acceleration of a wheel is that of the first driver (z_d teeth) over the ratio of their teeth."""
    return J_2 * alpha * z_d / z_2 * z_1 / z_2


@formula("T", "peak torque: the mean with the largest dynamic torque, K_A = 1")
def peak_torque(T_m: NewtonMetre, T_dyn: NewtonMetre) -> NewtonMetre:
    return abs(T_m) + T_dyn


@formula("T_min", "least torque over the cycle; below 0 the flanks leave each other")
def least_torque(T_m: NewtonMetre, T_dyn: NewtonMetre) -> NewtonMetre:
    return abs(T_m) - T_dyn


def mean_torques(train: TrainResult, torque: Mapping[str, NewtonMetre] | NewtonMetre | Power) -> dict[str, NewtonMetre]:
    """Torque at the driver of every mesh; one number is handed on from the first driver, whole into each branch."""
    if isinstance(torque, Power):
        torque = _torques(train, torque.of)
    if isinstance(torque, Mapping):
        return {key: torque[key] if key in torque else torque[mesh.driver] for key, mesh in train.meshes.items()}
    on = {next(iter(train.meshes.values())).driver: torque}
    found = {}
    for key, mesh in train.meshes.items():
        found[key] = on[mesh.driver]
        with about(f"wheel {mesh.driven}"):
            on[mesh.driven] = torque_of_driven(on[mesh.driver], train.wheels[mesh.driven].teeth, train.wheels[mesh.driver].teeth)
    return found


def _torques(train: TrainResult, power: Mapping[str, Watt] | Watt) -> dict[str, NewtonMetre] | NewtonMetre:
    if not isinstance(power, Mapping):
        first = train.wheels[next(iter(train.meshes.values())).driver]
        with about(f"wheel {first.name}"):
            return mean_torque(P=power, n=first.speed)
    found = {}
    for key, P in power.items():
        mesh = train.meshes[key]
        with about(f"mesh {mesh.driver}–{mesh.driven}"):
            found[key] = mean_torque(P=P, n=train.wheels[mesh.driver].speed)
    return found


def loads(
    gears: GearsInputs, train: TrainResult, mean: Mapping[str, NewtonMetre], uneven: Irregularity | None, materials: Mapping[str, Material]
) -> dict[str, Load]:
    """What every mesh is rated with.  A given application factor is taken with the mean; else the dynamic torque where it is known."""
    dynamic = _dynamic(gears, train, uneven, materials) if uneven is not None else {}
    found = {}
    for key, T_m in mean.items():
        T_dyn = dynamic.get(key)
        if gears.application_factor is not None:
            found[key] = Load(T_m, T_dyn, T_m, gears.application_factor)
        elif T_dyn is None:
            with about(_name(train, key)):
                found[key] = Load(T_m, None, T_m, usual_application_factor())
        else:
            with about(_name(train, key)):
                found[key] = Load(T_m, T_dyn, peak_torque(T_m=T_m, T_dyn=T_dyn), factor_of_peak())
    return found


def _name(train: TrainResult, key: str) -> str:
    return f"mesh {train.meshes[key].driver}–{train.meshes[key].driven}"


def _dynamic(gears: GearsInputs, train: TrainResult, uneven: Irregularity, materials: Mapping[str, Material]) -> dict[str, NewtonMetre]:
    """Dynamic torque at the driver of every mesh, from the last mesh to the first."""
    meshes = list(train.meshes.items())
    first, last = train.wheels[meshes[0][1].driver], train.wheels[meshes[-1][1].driven]
    bores = {w.name: w.bore_diameter or 0.0 for w in gears.wheels}
    with about("irregularity of the first driver"):
        alpha = angular_acceleration(delta_s=uneven.delta_s, i=uneven.order, omega=angular_speed(n=abs(first.speed)))
    behind: dict[str, KilogramMetre2] = {}
    for name, wheel in train.wheels.items():
        with about(f"wheel {name}, inertia"):
            if wheel is last and uneven.shaft_inertia is not None and uneven.with_wheel:
                behind[name] = uneven.shaft_inertia
                continue
            rho = materials[wheel.material].density
            behind[name] = wheel_inertia(rho=rho, b=wheel.face_width, d=wheel.pitch_diameter, d_i=bores[name])
            if wheel is last and uneven.shaft_inertia is not None:
                behind[name] = with_shaft(J=behind[name], J_S=uneven.shaft_inertia)
    found: dict[str, NewtonMetre] = {}
    for key, mesh in reversed(meshes):
        z_1, z_2 = train.wheels[mesh.driver].teeth, train.wheels[mesh.driven].teeth
        with about(f"mesh {mesh.driver}–{mesh.driven}, inertia"):
            found[key] = dynamic_torque(J_2=behind[mesh.driven], z_1=z_1, z_2=z_2, alpha=alpha, z_d=first.teeth)
            behind[mesh.driver] = with_driven(J=behind[mesh.driver], J_2=behind[mesh.driven], z_1=z_1, z_2=z_2)
    return found


def rattle(key: str, name: str, least: NewtonMetre) -> Check:
    return check(
        f"gears.{key}.flank_reversal", f"Least torque of {name} over the cycle", least, ">=", 0.0, "N·m",
        "the flanks stay in touch while the torque does not change its sign",
        "The teeth rattle: hold the backlash small, prefer helical teeth with a large overlap, or take a heavier flywheel "
        "(engine.flywheel_inertia_kgm2) or a wheel that is sprung against play.",
        kind="advice",
    )  # fmt: skip


def firing_order(cylinders: int, strokes: int) -> Number:
    """The lowest order in which the gas torque of equal cylinders, fired evenly, does not cancel."""
    return 2 * cylinders / strokes
