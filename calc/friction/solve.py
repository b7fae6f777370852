# SPDX-License-Identifier: Apache-2.0
"""The friction of all meshes and the power balance of the train, closed.

The counter-shaft needs the power of its bearings; each mesh towards the crank adds what it loses at the power that it takes in.
A design without counter-shaft gives the power that the first driver puts into its mesh, and the balance runs the other way.
"""

from collections.abc import Mapping

from ..lubricant import Lubricant
from ..sheet.errors import NoSolution
from ..sheet.step import Outcome
from ..sheet.trace import about, trace, untraced
from ..sheet.units import Celsius, RevPerSecond, Watt
from . import judgement, regressions
from .contact import wheel_speed
from .film import Oil, oil_at
from .inputs import FrictionInputs
from .loss import bulk_rise, case, ohlendorf_loss_factor, solve_mesh
from .mesh import MeshGeometry, require
from .power import downstream, power_in, power_out, upstream
from .result import FrictionResult, MeshResult, WheelResult, fuel, torque, total_loss
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
    first, last = _ends(meshes)
    with trace() as lines:
        with about("oil"):
            T_m = oil_temperature if friction.bulk_temperature is None else friction.bulk_temperature
            oil = oil_at(lubricant, require_temperature(T_m))
        wheels = _wheels(friction, meshes, lubricant, require_temperature(oil_temperature), first_speed)
        needed = {name: wheel.windage + wheel.other_loss for name, wheel in wheels.items()}
        if shaft_power is not None:
            needed[last] += require("losses of the counter-shaft's bearings", shaft_power, zero=True)
        loads = _loads(friction, meshes, oil, wheels, needed, None if shaft_power is not None else power)
        solved, carried = _converged(friction, meshes, oil, wheels, needed, loads, upstream=shaft_power is not None)
        with about("train"):
            crank_power = carried[first] if shaft_power is not None else loads[next(iter(meshes))] + needed[first]
            mesh_sum = sum(mesh.judged.loss for mesh in solved.values())
            windage_sum = sum(wheel.windage for wheel in wheels.values())
            other_sum = sum(wheel.other_loss for wheel in wheels.values())
            total = total_loss(P_B=shaft_power or 0.0, P_VZ=mesh_sum, P_W=windage_sum, P_X=other_sum)
            crank_torque = torque(P=crank_power, n=first_speed)
            b_e = friction.specific_fuel_consumption
            burnt = None if b_e is None else fuel(b_e=b_e, P=total)
    delivered = None if shaft_power is not None else solved[list(meshes)[-1]].power_out - needed[last]
    result = FrictionResult(
        meshes=solved, wheels=wheels, oil_viscosity=oil.eta_0, bearing_loss=shaft_power, mesh_loss=mesh_sum, windage_loss=windage_sum,
        other_loss=other_sum, total_loss=total, crank_power=crank_power, crank_torque=crank_torque, delivered_power=delivered, fuel=burnt,
        residual=crank_power - total - (delivered or 0.0),
    )  # fmt: skip
    with untraced():
        return Outcome(
            "friction", result=result, checks=judgement.checks(friction, result), lines=tuple(lines), curves=judgement.curves(result),
            errata=judgement.errata(friction, result, oil), notes=judgement.notes(friction, result, oil),
        )  # fmt: skip


def require_temperature(T: Celsius) -> Celsius:
    if not -60 < T < 400:  # NaN is not
        raise NoSolution("temperature of the oil", f"is {T} °C", "a temperature of a liquid oil is needed")
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
    others = dict.fromkeys(speeds, 0.0)
    for other in friction.other_losses:
        named = [name for name in speeds if other.name.startswith(name)]
        others[max(named, key=len, default=last)] += require(f"other loss {other.name}", other.power, zero=True)
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


def _converged(
    friction: FrictionInputs,
    meshes: Meshes,
    oil: Oil,
    wheels: Wheels,
    needed: Mapping[str, Watt],
    loads: Mapping[str, Watt],
    *,
    upstream: bool,
) -> tuple[dict[str, MeshResult], dict[str, Watt]]:
    """Every mesh at its load once more, with its lines, and what each wheel carries."""
    carried = dict(needed)
    found: dict[str, MeshResult] = {}
    for name, mesh in reversed(list(meshes.items())):
        P_out = carried[mesh.driven.name] if upstream else None
        with about(f"mesh {mesh.title}"):
            found[name] = _mesh(friction, mesh, oil, wheels[mesh.driver.name].speed, loads[name], P_out)
        carried[mesh.driver.name] += found[name].power_in
    return {name: found[name] for name in meshes}, carried


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
