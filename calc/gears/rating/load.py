# SPDX-License-Identifier: Apache-2.0
"""The torque that the teeth are rated with, and what else the rating of a train works with.

The torque is the mean of the power balance, and what the crank's irregularity adds by inertia.

The crank speeds up and slows down; whatever it drives has to follow through the teeth.  For a counter-shaft that is far
more than its friction: the flanks then leave each other and hit (rattle).  Either the peak of mean and dynamic torque
is rated, with K_A = 1, or K_A times the mean; never both."""

from collections.abc import Mapping

from ...library.catalogue import Material
from ...library.lubricant import Lubricant
from ...sheet.formula import formula
from ...sheet.functions import pi
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import (
    Celsius,
    Metre,
    NewtonMetre,
    Number,
    RevPerSecond,
    SquareMetrePerSecond,
    Watt,
)
from ...sheet.value import about, based_on
from ..inputs import GearsInputs
from ..result import TrainResult
from .classes import StrengthClass, of_wheel
from .influence import WheelOfPair as Body
from .influence import inner_diameter
from .irregular import Irregular, MeshTorques
from .screening.load import OilBath, oil_bath, structural_factor

USUAL = 1.25
UNEVEN = 5.0  # rule of this program: K_A of an engine whose irregularity is not known, at its worst


@record
class Power:
    """What the mean torque comes from: the power of the first driver, or that of the driver in every mesh."""

    of: Mapping[str, Watt] | Watt


@record
class RatingLoad:
    """Torques at the driver of one mesh."""

    mean: NewtonMetre
    dynamic: NewtonMetre | None  # where the crank speeds up
    least: NewtonMetre | None  # over the cycle
    rated: NewtonMetre  # that of F_t
    K_A: Number
    of_peak: bool = False  # rated with the peak of mean and dynamic torque, not with K_A times the mean
    assumed: bool = False  # K_A is the usual one: neither it nor the irregularity is known
    at_worst: Number = UNEVEN  # K_A then, at its worst
    worst_reverses: bool = False  # whether the torque changes its sign then

    @property
    def reverses(self) -> bool:
        """Whether the torque changes its sign over the cycle, as far as that is known."""
        return self.least is not None and self.least < 0


@formula(
    "K_A", "ISO 6336-6: usual for a combustion engine that drives a uniform load through a balanced train", shows="1.25"
)
def usual_application_factor() -> Number:
    return USUAL


@formula("K_A", "definition: the peak torque holds what the application adds", shows="1")
def factor_of_peak() -> Number:
    return 1.0


@formula("T_m", "definition: mean torque of a power")
def mean_torque(P: Watt, n: RevPerSecond) -> NewtonMetre:
    return P / (2 * pi * abs(n))


@formula(
    "P_in",
    "rule of this program: of the given power each mesh, chain and belt carries what it does of that of the balance",
    names={"P_i": "P_in,f", "P_1": "P_1,f"},
)
def power_by_balance(P: Watt, P_i: Watt, P_1: Watt) -> Watt:
    """`P_i`: what it takes in by the balance of the friction, where the first driver passes on `P_1`.

    >>> power_by_balance(P=1000.0, P_i=120.0, P_1=400.0)
    300.0
    """
    return P * P_i / P_1


@formula(
    "P_in",
    "rule of this program: where no friction is asked, every shaft takes an equal part of the given power",
    names={"k": "k_S", "n": "n_S"},
)
def power_by_shafts(P: Watt, k: Number, n: Number) -> Watt:
    """`k` of all `n` shafts lie behind it; all of them count where an end lies there that is no shaft.

    >>> power_by_shafts(P=1000.0, k=1, n=4)
    250.0
    """
    return P * k / n


@formula("T_2", "energy: torque handed on without loss")
def torque_of_driven(T: NewtonMetre, z_2: Number, z_1: Number) -> NewtonMetre:
    return T * z_2 / z_1


@formula("T", "rule of this program, peak torque: the mean with the largest dynamic torque, K_A = 1")
def peak_torque(T_m: NewtonMetre, T_dyn: NewtonMetre) -> NewtonMetre:
    return abs(T_m) + T_dyn


@formula(
    "T_min",
    "mathematics: least torque over the cycle, at the speed and load where it is least; below 0 the flanks part",
    names={"k": "k_D"},
    meanings={"k": "Share of the mean torque that the drag has at that speed", "T_dyn": "Dynamic torque"},
)
def least_torque(T_m: NewtonMetre, k: Number, T_dyn: NewtonMetre) -> NewtonMetre:
    """`k`: share of the mean torque that the drag has at that speed."""
    return abs(T_m) * k - T_dyn


def mean_torques(train: TrainResult, torque: Mapping[str, NewtonMetre] | NewtonMetre | Power) -> dict[str, NewtonMetre]:
    """Torque at the driver of every mesh; one number is handed on from the first driver, whole into each branch."""
    if isinstance(torque, Power):
        torque = _torques(train, torque.of)
    if isinstance(torque, Mapping):
        return {
            key: torque[key] if key in torque else torque[link.driver]
            for key, link in train.tree.by_key.items()
            if link.toothed or key in torque
        }
    at_wheel = {train.tree.first: torque}
    for link in train.tree.links:
        with about(Text("wheel {driven}", driven=link.driven)):
            at_wheel[link.driven] = torque_of_driven(at_wheel[link.driver], link.z_2, link.z_1)
    return {link.key: at_wheel[link.driver] for link in train.tree.links}


def _torques(train: TrainResult, power: Mapping[str, Watt] | Watt) -> dict[str, NewtonMetre] | NewtonMetre:
    tree = train.tree
    if not isinstance(power, Mapping):
        with about(Text("wheel {name}", name=tree.first)):
            return mean_torque(P=power, n=train.speeds[tree.first])
    torques = {}
    for key, P in power.items():
        with about(Text("mesh {pair}", pair=tree.by_key[key].title)):
            torques[key] = mean_torque(P=P, n=train.speeds[tree.by_key[key].driver])
    return torques


def loads(
    gears: GearsInputs, train: TrainResult, mean: Mapping[str, NewtonMetre], uneven: Irregular | None
) -> dict[str, RatingLoad]:
    """What every mesh is rated with.  A given application factor is taken with the mean; else the dynamic torque where
    it is known; where a default stands for it, the usual factor."""
    rated = {}
    for key, T_m in mean.items():
        with about(Text("mesh {pair}", pair=train.tree.by_key[key].title)):
            swing = uneven.of.get(key) if uneven is not None else None
            T_dyn = T_min = None
            if swing is not None and uneven is not None and not uneven.assumed:
                T_dyn, T_min = swing.dynamic, least_over(T_m, swing)
            if gears.application_factor is not None:
                rated[key] = RatingLoad(T_m, T_dyn, T_min, T_m, gears.application_factor)
            elif T_dyn is None:
                worst = UNEVEN if swing is None or not T_m else max(USUAL, 1 + swing.dynamic / abs(T_m))
                turns = swing is not None and _least_of(T_m, swing)[0] < 0
                rated[key] = RatingLoad(
                    T_m,
                    None,
                    None,
                    T_m,
                    usual_application_factor(),
                    assumed=True,
                    at_worst=worst,
                    worst_reverses=turns,
                )
            else:
                peak = peak_torque(T_m=T_m, T_dyn=T_dyn)
                rated[key] = RatingLoad(T_m, T_dyn, T_min, peak, factor_of_peak(), of_peak=True)
    return rated


def least_over(T_m: NewtonMetre, swing: MeshTorques) -> NewtonMetre:
    """The least torque over the range of speeds and loads."""
    _, at = _least_of(T_m, swing)
    return least_torque(T_m=T_m, k=swing.share[at], T_dyn=based_on(swing.slowing[at], swing.dynamic))


def _least_of(T_m: NewtonMetre, swing: MeshTorques) -> tuple[float, int]:
    """The same as a number, and at which operating point it is."""
    return min((abs(float(T_m)) * k - T, at) for at, (k, T) in enumerate(zip(swing.share, swing.slowing)))


# --- what the rating of a train works with: what is known around the gears, and what is the same for all meshes

RZ_PER_RA = 6.0  # ISO 6336-2: Ra = Rz/6
USUAL_RZ: Metre = 4e-6  # of ground flanks, where no roughness is given
REFERENCE_NU: SquareMetrePerSecond = 100e-6  # of an engine oil; Z_L is 1 at 167.5 mm²/s, which is 100 mm²/s at 50 °C


@formula("Ra", "ISO 6336-2: mean relation", unit="µm")
def mean_roughness(Rz: Metre) -> Metre:
    return Rz / RZ_PER_RA


@formula("Rz", "ISO 6336-2: mean relation", unit="µm")
def peak_to_valley(Ra: Metre) -> Metre:
    return RZ_PER_RA * Ra


@record
class Surroundings:
    """What the rating takes from outside the gears; what is None is not known."""

    uneven: Irregular | None = None
    lubricant: Lubricant | None = None
    oil_temperature: Celsius | None = None
    flank_ra: tuple[Metre, Metre] | None = None  # Ra of driver and driven wheel


@record
class RatingContext:
    """What stays the same for all meshes.  A wheel without a strength class has no body: it is not rated."""

    gears: GearsInputs
    train: TrainResult
    materials: Mapping[str, Material]
    classes: dict[str, StrengthClass]  # by wheel, as are the bodies and X_W of scuffing
    bodies: dict[str, Body]
    structural: dict[str, Number]
    oil: OilBath | None
    nu_40: SquareMetrePerSecond | None  # of the oil at 40 °C; None: not known, REFERENCE_NU is taken
    flank_ra: tuple[Metre, Metre]
    flank_rz: Metre


def rating_context(
    gears: GearsInputs, train: TrainResult, materials: Mapping[str, Material], around: Surroundings
) -> RatingContext:
    classes, bodies = dict[str, StrengthClass](), dict[str, Body]()
    for w in gears.wheels:
        wheel, solid = train.wheels[w.name], materials[w.material]
        strength = of_wheel(w, solid.E, solid.proof_stress)
        if strength is not None:
            classes[w.name] = strength
            inside = inner_diameter(wheel.root_diameter, w.bore_diameter, w.rim_thickness)
            bodies[w.name] = Body(wheel, solid.E, solid.density, strength.kind, strength.sigma_Hlim, inside)
    oil, structural, lubricant = None, dict[str, Number](), around.lubricant
    if lubricant is not None and around.oil_temperature is not None:
        oil = oil_bath(lubricant, around.oil_temperature, gears.lubrication)
        for name, strength in classes.items():
            with about(Text("wheel {name}, strength class", name=name)):
                structural[name] = structural_factor(kind=strength.kind)
    with about(Text("roughness of the flanks")):
        if gears.flank_rz is None and around.flank_ra is not None:
            flank_ra, flank_rz = around.flank_ra, peak_to_valley(Ra=max(around.flank_ra))
        else:
            flank_rz = gears.flank_rz if gears.flank_rz is not None else USUAL_RZ
            flank_ra = (mean_roughness(Rz=flank_rz),) * 2
    nu_40 = lubricant.nu40 if lubricant is not None else None
    return RatingContext(gears, train, materials, classes, bodies, structural, oil, nu_40, flank_ra, flank_rz)
