# SPDX-License-Identifier: Apache-2.0
"""What every wheel loses besides its meshes.

Most of it follows from speed and oil alone (`unloaded`); the bearings of a wheel also from the force of its teeth
(`carrying`).  A loss is carried by the wheel that its name begins with, else by the last, through all meshes."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TypeVar, TypeVarTuple

from ...bearings.plain.formulas import angular_speed
from ...library.lubricant import Lubricant, OilState
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import acos, atan, cos, tan
from ...sheet.quantity import result, value
from ...sheet.shown import Shown
from ...sheet.text import Text
from ...sheet.units import (
    Celsius,
    Metre,
    Newton,
    Number,
    Radian,
    RevPerSecond,
    Watt,
)
from ...sheet.value import about
from ..inputs import Carried, Dip, FrictionInputs, Jet, PlainBearing, RollingBearing, Seal, carrier
from ..mesh.geometry import Link, MeshGeometry, WheelGeometry, require
from ..mesh.path import wheel_speed
from . import bearings as bearing_losses
from . import oil_and_air, sums
from .oil_and_air import AIR_VISCOSITY, mist_of_the_tests, mist_viscosity, oil_share, windage

Entry = TypeVar("Entry", bound=Carried)
Asked = TypeVarTuple("Asked")


@result
class WheelResult(Shown):
    """One wheel; what it does not have is None."""

    speed: RevPerSecond = value("Speed of the wheel", "rpm", "n")
    windage: Watt | None = value("Windage of the wheel", "W", "P_W")
    churning: Watt | None = value("Churning of the wheel", "W", "P_C", default=None)
    thrown_oil: Watt | None = value("Oil thrown onto the wheel", "W", "P_J", default=None)
    seal_loss: Watt | None = value("Shaft seals of the wheel", "W", "P_D", default=None)
    bearing_force: Newton | None = value("Load of the wheel's bearings", "N", "F", default=None)
    bearing_loss: Watt | None = value("Bearings of the wheel", "W", "P_L", default=None)
    other_loss: Watt = value("Other losses carried by the wheel", "W", "P_X")

    def parts(self) -> tuple[Watt, ...]:
        """All that the wheel loses, part by part."""
        losses = (self.windage, self.churning, self.thrown_oil, self.seal_loss, self.bearing_loss, self.other_loss)
        return tuple(part for part in losses if part is not None)


@formula("α_t", "geometry: transverse pressure angle, by reference and base circle")
def transverse_angle(r_b: Metre, r: Metre) -> Radian:
    return acos(r_b / r)


@formula("β", "geometry: helix angle at the reference circle")
def helix_angle(beta_b: Radian, alpha_t: Radian) -> Radian:
    return atan(tan(beta_b) / cos(alpha_t))


@formula("m_n", "definition of the normal module", unit="mm")
def normal_module(r: Metre, beta: Radian, z: Number) -> Metre:
    return 2 * r * cos(beta) / z


def speeds_of(links: Mapping[str, Link], first_speed: RevPerSecond) -> dict[str, RevPerSecond]:
    """The speed of every wheel and sprocket, all positive."""
    speeds = {next(iter(links.values())).driver.name: require(Text("speed of the first driver"), first_speed)}
    for mesh in links.values():
        if mesh.driver.name not in speeds:
            undriven = Text("nothing drives {name}", name=mesh.driver.name)
            advice = Text("list the meshes along the flow of power")
            raise NoSolution(Text("mesh {title}", title=mesh.title), undriven, advice)
        n, z_1, z_2 = speeds[mesh.driver.name], mesh.driver.teeth, mesh.driven.teeth
        with about(Text("wheel {name}", name=mesh.driven.name)):
            speeds[mesh.driven.name] = wheel_speed(n=n, z_1=z_1, z_2=z_2)
    return speeds


def carried_by(entries: Iterable[Entry], wheels: Iterable[str], last: str) -> dict[str, list[Entry]]:
    """The entries of a table of losses by the wheel that carries them."""
    carried: dict[str, list[Entry]] = {}
    for entry in entries:
        carried.setdefault(carrier(entry, wheels, last), []).append(entry)
    return carried


def unloaded(
    friction: FrictionInputs,
    links: Mapping[str, Link],
    lubricant: Lubricant,
    T: Celsius,
    first_speed: RevPerSecond,
    last: str,
) -> dict[str, WheelResult]:
    """Every wheel with what does not depend on its load; speeds and temperatures may be arrays.  A sprocket that turns
    beside no wheel has neither windage nor churning.  `last` carries what names no wheel."""
    speeds = speeds_of(links, first_speed)
    meshes = [link for link in links.values() if isinstance(link, MeshGeometry)]
    bodies = {wheel.name: (wheel, mesh.base_helix_angle) for mesh in meshes for wheel in (mesh.driver, mesh.driven)}
    others, dips = carried_by(friction.other_losses, speeds, last), carried_by(friction.dips, speeds, last)
    thrown, sealed = carried_by(friction.jets, speeds, last), carried_by(friction.seals, speeds, last)
    with about(Text("mist")):
        state = lubricant.at(T)
        rho_m = require(Text("density of the mist"), friction.mist_density)
        rho_0 = mist_of_the_tests(rho_oil=state.rho)
        eta_m = mist_viscosity(s_oil=oil_share(rho_m=rho_m, rho_oil=state.rho), eta_oil=state.mu, eta_air=AIR_VISCOSITY)
    results: dict[str, WheelResult] = {}
    for name, n in speeds.items():
        with about(Text("wheel {name}", name=name)):
            P_X = sums.no_other_loss()
            for other in others.get(name, ()):
                given = require(Text("other loss {name}", name=other.name), other.power, zero=True)
                with about(Text("wheel {name}, {name2}", name=name, name2=other.name)):
                    P_X = sums.other_losses_on_wheel(P=P_X, P_i=given)
            if name not in bodies:
                if name in dips or name in thrown:
                    no_wheel = Text("a sprocket that turns beside no wheel has no churning here")
                    raise NoSolution(Text("oil on {name}", name=name), no_wheel, Text("name another wheel"))
                P_D = _sum(name, sealed.get(name, ()), sums.seals_on_wheel, _sealed, n, lubricant, T)
                results[name] = WheelResult(speed=n, windage=None, other_loss=P_X, seal_loss=P_D)
                continue
            wheel, beta_b = bodies[name]
            P_W = windage(b=wheel.face_width, r=wheel.reference_radius, n=n, eta_m=eta_m, rho_m=rho_m, rho_0=rho_0)
        results[name] = WheelResult(
            speed=n,
            windage=P_W,
            other_loss=P_X,
            churning=_sum(name, dips.get(name, ()), sums.churning_on_wheel, _churned, wheel, beta_b, n, state),
            thrown_oil=_sum(name, thrown.get(name, ()), sums.thrown_oil_on_wheel, _thrown, wheel, n, state),
            seal_loss=_sum(name, sealed.get(name, ()), sums.seals_on_wheel, _sealed, n, lubricant, T),
        )
    return results


def _sum(
    name: str,
    entries: Sequence[Entry],
    adding: Callable[..., Watt],
    power: Callable[[Entry, *Asked], Watt],
    *asked: *Asked,
) -> Watt | None:
    """The losses of several entries of one kind on one wheel; None where there is none."""
    total: Watt | None = None
    for entry in entries:
        with about(Text("wheel {name}, {name2}", name=name, name2=entry.name)):
            P = power(entry, *asked)
            total = P if total is None else adding(P=total, P_i=P)
    return total


def _churned(dip: Dip, wheel: WheelGeometry, beta_b: Radian, n: RevPerSecond, oil: OilState) -> Watt:
    r, b = wheel.reference_radius, wheel.face_width
    h = oil_and_air.depth_of_reference_circle(h_t=dip.depth, r_a=wheel.tip_radius, r=r)
    alpha_t = transverse_angle(r_b=wheel.base_radius, r=r)
    beta = helix_angle(beta_b=beta_b, alpha_t=alpha_t)
    m_n = normal_module(r=r, beta=beta, z=wheel.teeth)
    omega = angular_speed(n=n)
    theta = oil_and_air.wetted_angle(h=h, r=r)
    S_m = oil_and_air.wetted_surface(r=r, theta=theta, b=b, z=wheel.teeth, m_n=m_n, alpha_t=alpha_t, beta=beta)
    Re_c, Fr = oil_and_air.reynolds(omega=omega, r=r, b=b, nu=oil.nu), oil_and_air.froude(omega=omega, r=r)
    C_m1 = oil_and_air.calm(h=h, r=r, V=dip.oil_volume, Fr=Fr, Re_c=Re_c, b=b)
    C_m2 = oil_and_air.wild(h=h, r=r, V=dip.oil_volume, Fr=Fr, Re_c=Re_c, b=b)
    C_m = oil_and_air.torque_number(C_m1=C_m1, C_m2=C_m2, gamma=oil_and_air.centrifugal(omega=omega, r=r, b=b, m_n=m_n))
    return oil_and_air.churning(
        T_C=oil_and_air.churning_torque(rho=oil.rho, omega=omega, r=r, S_m=S_m, C_m=C_m), omega=omega
    )


def _thrown(jet: Jet, wheel: WheelGeometry, n: RevPerSecond, oil: OilState) -> Watt:
    v_t = oil_and_air.pitch_line_speed(r=wheel.reference_radius, n=n)
    return oil_and_air.thrown_oil(rho=oil.rho, Q=jet.flow, v_t=v_t, v_j=jet.jet_speed)


def _sealed(seal: Seal, n: RevPerSecond, lubricant: Lubricant, T: Celsius) -> Watt:
    if seal.method == "simrit":
        loss = bearing_losses.simrit(d_sh=seal.diameter, n=n)
    else:
        loss = bearing_losses.linke(T_oil=T, nu_40=lubricant.nu40, d_sh=seal.diameter, n=n)
    return loss if seal.count == 1 else bearing_losses.several(N=seal.count, P=loss)


def has_bearings(friction: FrictionInputs) -> bool:
    return bool(friction.rolling_bearings or friction.plain_bearings)


def carrying(
    friction: FrictionInputs,
    wheels: Mapping[str, WheelResult],
    last: str,
    lubricant: Lubricant,
    T: Celsius,
    forces: Mapping[str, Newton],
) -> dict[str, tuple[Newton, Watt]]:
    """Load and friction of the bearings of every wheel that has some; `forces` of the teeth on each wheel."""
    rolling = carried_by(friction.rolling_bearings, wheels, last)
    plain = carried_by(friction.plain_bearings, wheels, last)
    with about(Text("oil of the wheels' bearings")):
        state = lubricant.at(T)
    bearings: dict[str, tuple[Newton, Watt]] = {}
    for name, wheel in wheels.items():
        here = (*rolling.get(name, ()), *plain.get(name, ()))
        if not here:
            continue
        of_teeth, given = forces.get(name, 0.0), [bearing.load for bearing in here if bearing.load is not None]
        F = sum(given) if len(given) == len(here) else of_teeth
        P = _sum(name, here, sums.bearings_on_wheel, _borne, of_teeth, wheel.speed, state, lubricant.oil.base)
        assert P is not None
        bearings[name] = F, P
    return bearings


def _borne(bearing: RollingBearing | PlainBearing, F: Newton, n: RevPerSecond, oil: OilState, base: str) -> Watt:
    F = F if bearing.load is None else bearing.load
    if isinstance(bearing, RollingBearing):
        return bearing_losses.power(bearing, F, n, oil.nu, base)
    return bearing_losses.plain_bearing_power(bearing, F, n, oil.mu)
