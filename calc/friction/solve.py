# SPDX-License-Identifier: Apache-2.0
"""The friction of all meshes and the power balance of the train, closed.

The counter-shaft needs the power of its bearings; each mesh towards the crank adds what it loses at the power that it takes in.
A design without counter-shaft gives the power that the first driver puts into its mesh, and the balance runs the other way.
"""

import math
from collections.abc import Mapping
from functools import reduce

import numpy as np

from ..lubricant import Lubricant
from ..sheet.errors import NoSolution
from ..sheet.number import short
from ..sheet.quantity import published
from ..sheet.step import Outcome
from ..sheet.trace import about, trace, untraced
from ..sheet.units import Celsius, RevPerSecond, Watt
from . import judgement, regressions
from .contact import wheel_speed
from .film import Oil, oil_at
from .inputs import FrictionInputs, carrier
from .loss import bulk_rise, case, ohlendorf_loss_factor, solve_mesh
from .mesh import MeshGeometry, require
from .power import delivered as delivered_power
from .power import (
    downstream,
    no_other_loss,
    own_need,
    passed_on,
    power_in,
    power_out,
    upstream,
    with_bearings,
    with_mesh,
    with_other_loss,
)  # fmt: skip
from .result import FrictionResult, MeshResult, WheelResult, and_mesh, and_other_loss, and_windage, fuel, torque, total_loss
from .windage import mist_of_the_tests, mist_viscosity, oil_share, windage

Meshes = Mapping[str, MeshGeometry]
Wheels = Mapping[str, WheelResult]


def closure(
    friction: FrictionInputs,
    meshes: Meshes,
    lubricant: Lubricant,
    oil_temperature: Celsius,
    shaft_power: Watt | None,
    first_speed: RevPerSecond,
    power: Watt | None = None,
) -> Outcome:
    """The losses of a train whose meshes are listed along the flow of power, the crank's first.

    `shaft_power` is what the last wheel must deliver, the losses of the counter-shaft's bearings; None where there is no
    counter-shaft and `power` is what the first driver puts into its mesh.  `first_speed` is that of the first driver.
    """
    if not meshes:
        raise NoSolution("power balance of the train", "there is no mesh", "give at least one [[gears.meshes]]")
    if shaft_power is None and power is None:
        unknown = "neither the losses of a counter-shaft nor the power of the first driver is known"
        raise NoSolution("power balance of the train", unknown, "give gears.power_kW")
    _, last = _ends(meshes)
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"), trace() as lines:  # what is not finite is refused below
        with about("oil"):
            T_m = oil_temperature if friction.bulk_temperature is None else friction.bulk_temperature
            oil = oil_at(lubricant, require_temperature(T_m))
        wheels = _wheels(friction, meshes, lubricant, require_temperature(oil_temperature), first_speed)
        needed = _needed(wheels, last, shaft_power)
        loads = _loads(friction, meshes, oil, wheels, needed, None if shaft_power is not None else power)
        if shaft_power is not None:
            solved, crank_power = _upstream(friction, meshes, oil, wheels, needed, loads)
            delivered = None
        else:
            solved, crank_power = _downstream(friction, meshes, oil, wheels, needed, loads)
            with about(f"wheel {last}"):
                delivered = delivered_power(P_out=solved[list(meshes)[-1]].power_out, P=needed[last])
        with about("train"):
            mesh_sum = reduce(lambda P, P_VZ: and_mesh(P=P, P_VZ=P_VZ), (mesh.judged.loss for mesh in solved.values()))
            windage_sum = reduce(lambda P, P_W: and_windage(P=P, P_W=P_W), (wheel.windage for wheel in wheels.values()))
            other_sum = reduce(lambda P, P_X: and_other_loss(P=P, P_X=P_X), (wheel.other_loss for wheel in wheels.values()))
            total = total_loss(P_B=shaft_power or 0.0, P_VZ=mesh_sum, P_W=windage_sum, P_X=other_sum)
            crank_torque = torque(P=crank_power, n=first_speed)
            b_e = friction.specific_fuel_consumption
            burnt = None if b_e is None else fuel(b_e=b_e, P=total)
    result = FrictionResult(
        meshes=solved, wheels=wheels, oil_viscosity=oil.eta_0, bearing_loss=shaft_power, mesh_loss=mesh_sum, windage_loss=windage_sum,
        other_loss=other_sum, total_loss=total, crank_power=crank_power, crank_torque=crank_torque, delivered_power=delivered, fuel=burnt,
        residual=crank_power - total - (delivered or 0.0),
    )  # fmt: skip
    _finite(result)
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"), untraced():
        return Outcome(
            "friction", result=result, checks=judgement.checks(friction, result), lines=tuple(lines), curves=judgement.curves(result),
            errata=judgement.errata(friction, result, oil), notes=judgement.notes(friction, result, oil),
        )  # fmt: skip


def _finite(result: FrictionResult) -> None:
    """No value that is no number, or infinite, is handed out."""
    for value in published(result, "friction"):
        if not math.isfinite(value.shown):
            found = f"{value.id} is {short(value.shown)}"
            advice = "power, speed, face width or flank roughness are far outside what the formulas are for: give usual ones"
            raise NoSolution(value.label, found, advice)


def _needed(wheels: Wheels, last: str, shaft_power: Watt | None) -> dict[str, Watt]:
    """What each wheel needs besides its meshes."""
    needed: dict[str, Watt] = {}
    for name, wheel in wheels.items():
        with about(f"wheel {name}"):
            needed[name] = own_need(P_W=wheel.windage, P_X=wheel.other_loss)
            if name == last and shaft_power is not None:
                require("losses of the counter-shaft's bearings", shaft_power, zero=True)
                needed[name] = with_bearings(P=needed[name], P_B=shaft_power)
    return needed


def require_temperature(T: Celsius) -> Celsius:
    if not -60 < T < 400:  # NaN is not
        raise NoSolution("temperature of the oil", f"is {short(T)} °C", "a temperature of a liquid oil is needed")
    return T


def _ends(meshes: Meshes) -> tuple[str, str]:
    """The names of the first driver and of the last driven wheel."""
    along = list(meshes.values())
    return along[0].driver.name, along[-1].driven.name


def _wheels(
    friction: FrictionInputs, meshes: Meshes, lubricant: Lubricant, T: Celsius, first_speed: RevPerSecond
) -> dict[str, WheelResult]:
    """Speed, windage and other losses of every wheel; a loss that names no wheel is carried by the last, through all meshes."""
    first, last = _ends(meshes)
    speeds = {first: require("speed of the first driver", first_speed)}
    for mesh in meshes.values():
        if mesh.driver.name not in speeds:
            raise NoSolution(f"mesh {mesh.title}", f"nothing drives {mesh.driver.name}", "list the meshes along the flow of power")
        with about(f"wheel {mesh.driven.name}"):
            speeds[mesh.driven.name] = wheel_speed(n=speeds[mesh.driver.name], z_1=mesh.driver.teeth, z_2=mesh.driven.teeth)
    others: dict[str, Watt] = {}
    for name in speeds:
        with about(f"wheel {name}"):
            others[name] = no_other_loss()
    for other in friction.other_losses:
        require(f"other loss {other.name}", other.power, zero=True)
        name = carrier(other.name, speeds, last)
        with about(f"wheel {name}, {other.name}"):
            others[name] = with_other_loss(P_X=others[name], P=other.power)
    with about("mist"):
        state = lubricant.at(T)
        rho_m = require("density of the mist", friction.mist_density)
        rho_0 = mist_of_the_tests(rho_oil=state.rho)
        eta_m = mist_viscosity(s_oil=oil_share(rho_m=rho_m, rho_oil=state.rho), eta_oil=state.mu)
    bodies = {wheel.name: wheel for mesh in meshes.values() for wheel in (mesh.driver, mesh.driven)}
    found: dict[str, WheelResult] = {}
    for name, n in speeds.items():
        with about(f"wheel {name}"):
            P_W = windage(b=bodies[name].face_width, r=bodies[name].reference_radius, n=n, eta_m=eta_m, rho_m=rho_m, rho_0=rho_0)
        found[name] = WheelResult(speed=n, windage=P_W, other_loss=others[name])
    return found


def _loads(
    friction: FrictionInputs, meshes: Meshes, oil: Oil, wheels: Wheels, needed: Mapping[str, Watt], power: Watt | None
) -> dict[str, Watt]:
    """The power that loads each mesh, from what the last wheel must deliver, or from that of the first driver where it is given."""
    with untraced():
        cases = {name: case(friction, mesh, oil, wheels[mesh.driver.name].speed) for name, mesh in meshes.items()}

        def loss(name: str, P: Watt) -> Watt:
            return solve_mesh(cases[name], P, friction.film == "judged").loss

        if power is None:
            return upstream(meshes, loss, needed)
        return downstream(meshes, loss, needed, require("power of the first driver", power))


def _upstream(
    friction: FrictionInputs, meshes: Meshes, oil: Oil, wheels: Wheels, needed: Mapping[str, Watt], loads: Mapping[str, Watt]
) -> tuple[dict[str, MeshResult], Watt]:
    """Every mesh at its load once more, with its lines, from the last to the first; and the power at the first driver."""
    carried = dict(needed)
    found: dict[str, MeshResult] = {}
    for name, mesh in reversed(list(meshes.items())):
        with about(f"mesh {mesh.title}"):
            found[name] = _mesh(friction, mesh, oil, wheels[mesh.driver.name].speed, loads[name], carried[mesh.driven.name])
        with about(f"wheel {mesh.driver.name}"):
            carried[mesh.driver.name] = with_mesh(P=carried[mesh.driver.name], P_in=found[name].power_in)
    return {name: found[name] for name in meshes}, carried[_ends(meshes)[0]]


def _downstream(
    friction: FrictionInputs, meshes: Meshes, oil: Oil, wheels: Wheels, needed: Mapping[str, Watt], loads: Mapping[str, Watt]
) -> tuple[dict[str, MeshResult], Watt]:
    """The same along the flow, of one chain whose first mesh has the power that is given."""
    first = _ends(meshes)[0]
    found: dict[str, MeshResult] = {}
    P = loads[next(iter(meshes))]
    with about(f"wheel {first}"):
        crank_power = with_mesh(P=needed[first], P_in=P)
    for name, mesh in meshes.items():
        if found:
            with about(f"wheel {mesh.driver.name}"):
                P = passed_on(P_out=P, P=needed[mesh.driver.name])
        with about(f"mesh {mesh.title}"):
            found[name] = _mesh(friction, mesh, oil, wheels[mesh.driver.name].speed, P, None)
        P = found[name].power_out
    return found, crank_power


def _mesh(friction: FrictionInputs, mesh: MeshGeometry, oil: Oil, n_1: RevPerSecond, P: Watt, P_out: Watt | None) -> MeshResult:
    """One mesh at the power that loads it, with everything that is shown beside; P_out where it is known, else it follows."""
    regimes = friction.film == "judged"
    c = case(friction, mesh, oil, n_1)
    judged = solve_mesh(c, P, regimes)
    if P_out is None:
        P_in, P_out = P, power_out(P_in=P, P_VZ=judged.loss)
    else:
        P_in = power_in(P_out=P_out, P_VZ=judged.loss)
    rise = bulk_rise(P=P, mu_m=judged.friction_mean, H_VL=judged.loss_factor, a=mesh.centre_distance, b=mesh.face_width)
    H_V = ohlendorf_loss_factor(
        u=mesh.driven.teeth / mesh.driver.teeth, z_1=mesh.driver.teeth, beta_b=mesh.base_helix_angle,
        epsilon_alpha=c.path.epsilon_alpha, epsilon_1=c.path.epsilon_1, epsilon_2=c.path.epsilon_2,
    )  # fmt: skip
    with about(f"mesh {mesh.title}, {'source model' if regimes else 'by regime'}"):
        beside = solve_mesh(c, P, not regimes)
    with about(f"mesh {mesh.title}, regressions"):
        schlenk, xu_kahraman = regressions.of_schlenk(c, P, H_V), regressions.of_xu_kahraman(c, P)
        benedict_kelley = regressions.of_benedict_kelley(c, P)
    return MeshResult(
        judged=judged, power_in=P_in, power_out=P_out, ohlendorf_loss_factor=H_V, bulk_rise=rise,
        source=beside if regimes else judged, by_regime=None if regimes else beside,
        schlenk=schlenk, xu_kahraman=xu_kahraman, benedict_kelley=benedict_kelley, case=c,
    )  # fmt: skip
