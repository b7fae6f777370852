# SPDX-License-Identifier: Apache-2.0
"""Times of the friction step:  python -m bench.friction [--gearpie FOLDER]

One mesh at 200 positions, ten thousand operating points at 50 positions in one call against the plain loop over a part
of them, the closed balance of the shipped train, its map and its sensitivity; against np.exp of 100 000 numbers in the
same run.

With a checkout of GEARpie (github.com/cfernandesFEUP/GEARpie), the same FZG pair by both, in one run: 200 positions
each."""

import math
import sys
from argparse import ArgumentParser
from pathlib import Path
from typing import Any

import numpy as np

from bench.film import best
from calc.design.toml_file import design, read
from calc.friction.inputs import FrictionInputs
from calc.friction.mesh.film import oil_at
from calc.friction.mesh.geometry import MeshGeometry, WheelGeometry, column
from calc.friction.mesh.loss import MeshCase, case, losses, solve_mesh
from calc.friction.models import of_schlenk
from calc.friction.power_balance import balance
from calc.friction.studies.maps import over_speed_and_temperature
from calc.friction.studies.sensitivity import swings
from calc.library.catalogue import Oil, oils
from calc.library.contact import ohlendorf_loss_factor
from calc.library.lubricant import Lubricant
from calc.solve import solve
from calc.studies.shipped import DESIGNS, EXAMPLE

MANY, LOOPED = 10_000, 300
FLANKS = FrictionInputs(flank_roughness=(0.8e-6,))


def pair() -> MeshGeometry:
    """The spur pair of the friction thesis, as shipped."""
    found = solve(design(read(DESIGNS / "timing_pair.toml"))).outcomes["friction"].result
    mesh: MeshGeometry = found.meshes["crank_pump"].case.mesh
    return mesh


def fzg_c40() -> MeshGeometry:
    """FZG gears of type C, 40 mm wide, tips as in GEARpie."""
    alpha = math.radians(20)
    wheels = [
        WheelGeometry(name, z, 4.5e-3 * z / 2, 4.5e-3 * z / 2 * math.cos(alpha), r_a, 40e-3, 206e9, 0.3)
        for name, z, r_a in (("pinion", 16, 41.3177e-3), ("gear", 24, 59.2717e-3))
    ]
    return MeshGeometry(*wheels, 91.5001e-3, 0.0)


def of(
    mesh: MeshGeometry, lubricant: Lubricant, T: Any, n: Any, points: int, flanks: FrictionInputs = FLANKS
) -> MeshCase:
    return case(flanks, mesh, oil_at(lubricant, column(T)), n, points=points)


def main() -> None:
    asked = ArgumentParser()
    asked.add_argument("--gearpie", metavar="FOLDER", help="a checkout of GEARpie")
    gearpie = asked.parse_args().gearpie
    mesh, lubricant = pair(), Lubricant(oils()["friction thesis 10W40"])
    random = np.random.default_rng(0)
    P, n, T = random.uniform(100, 20e3, MANY), random.uniform(10, 60, MANY), random.uniform(40, 120, MANY)
    one = of(mesh, lubricant, 60.0, 25.0, 49)
    exponents = random.uniform(-1.0, 1.0, 100_000)

    def together() -> Any:
        return losses(FLANKS, mesh, lubricant, T, n, P, by_regime=False).loss  # type: ignore[arg-type]

    def alone(i: int) -> float:
        return solve_mesh(of(mesh, lubricant, float(T[i]), float(n[i]), 12), float(P[i]), False).loss

    made = design(read(EXAMPLE))
    friction = solve(made).outcomes["friction"]
    assert friction.further is not None
    drive, result, power, on = friction.further.args  # type: ignore[attr-defined]
    worst = float(np.max(np.abs(together()[:LOOPED] / [alone(i) for i in range(LOOPED)] - 1)))
    baseline = best(lambda: np.exp(exponents), 20)
    call = best(together, 1, 3)
    loop = best(lambda: [alone(i) for i in range(LOOPED)], 1, 3) / LOOPED * MANY
    rows = (
        (f"one mesh, {np.size(one.path.x)} positions, to 1e-9 K", best(lambda: solve_mesh(one, 10e3, False), 20)),
        ("the same by regime", best(lambda: solve_mesh(one, 10e3, True), 20)),
        (
            f"{MANY} operating points, {np.size(of(mesh, lubricant, 60.0, 25.0, 12).path.x)} positions each, one call",
            call,
        ),
        (f"the same in a plain loop (from {LOOPED})", loop),
        ("closed balance of the shipped train, three helical meshes", best(lambda: balance(drive, power), 3, 3)),
        ("its map, 28 points", best(lambda: over_speed_and_temperature(drive, power, on), 1, 3)),
        ("its sensitivity, each constant at both ends", best(lambda: swings(drive, power, result.total_loss), 1, 3)),
    )
    print(f"{'np.exp of 100 000 numbers (baseline)':66s}{baseline * 1e6:12.1f} µs")
    for title, seconds in rows:
        print(f"{title:66s}{seconds * 1e6:12.1f} µs{seconds / baseline:12.3f}")
    print(f"{'plain loop over one call':66s}{loop / call:12.1f} ×   largest difference {worst:.1e}")
    if gearpie:
        beside(Path(gearpie))


def beside(folder: Path) -> None:
    """C40 of GEARpie, PAO of ISO VG 320 at 80 °C, 215.5 N·m at 1800 rpm of the pinion."""
    sys.path.insert(0, str(folder))
    from CLASSES import (
        CALC_GEOMETRY,
        CONTACT,
        FORCES_SPEEDS,
        GEAR_LIBRARY,
        LUBRICANT_LIBRARY,
        MATERIAL_LIBRARY,
        RIGID_LOAD_SHARING,
    )  # type: ignore

    torque, speed = 215.513, 1800.0
    theirs = LUBRICANT_LIBRARY.LUBRICANT("P", "320", 80.0)

    def their_loss() -> Any:
        geometry = CALC_GEOMETRY.MAAG(GEAR_LIBRARY.GEAR("C40"))
        lines = RIGID_LOAD_SHARING.LINES(200, geometry)
        forces = FORCES_SPEEDS.OPERATION("P", torque, speed, geometry, lines)
        return CONTACT.HERTZ(MATERIAL_LIBRARY.MATERIAL("STEEL", "STEEL"), theirs, geometry, lines, forces)

    def nu(T: float) -> float:
        return float(10 ** (10 ** (theirs.m - theirs.n * math.log10(T + 273.15))) - theirs.c) * 1e-6

    oil = Oil(name="VG 320", nu40=nu(40.0), nu100=nu(100.0), rho15=theirs.rho0 * 1e3, base="PAO")
    flanks = FrictionInputs(flank_roughness=(0.4e-6, 0.31e-6))
    P = 2 * math.pi * speed / 60 * torque

    def ours() -> Any:
        return solve_mesh(of(fzg_c40(), Lubricant(oil, "d341"), 80.0, speed / 60, 49, flanks), P, False)

    them, us = their_loss(), ours()
    c = of(fzg_c40(), Lubricant(oil, "d341"), 80.0, speed / 60, 49, flanks)
    H_V = ohlendorf_loss_factor(
        eps_1=c.path.epsilon_1, eps_2=c.path.epsilon_2, eps_alpha=c.path.epsilon_alpha, z_1=16, z_2=24, beta_b=0.0
    )
    schlenk = of_schlenk(c, P, H_V)
    print(f"\nFZG C40{'GEARpie':>20s}{'here':>20s}")
    p_C = float(np.interp(c.path.C_C, us.local.x, us.local.p_H))
    print(f"pressure at C, MPa{them.p0I:9.2f}{p_C / 1e6:20.2f}")
    print(f"loss factor{them.HVL:16.5f}{H_V:20.5f}   (50/50 sharing)")
    print(f"Schlenk, μ_m{them.CoF:15.6f}{schlenk.friction_mean:20.6f}   (their X_L is 0.65, the standard's 0.8)")
    print(f"loss, W{them.Pvzp:20.3f}{schlenk.loss:20.3f}   (by local EHL friction {us.loss:.1f} W)")
    t, u = best(their_loss, 1, 3), best(ours, 5)
    print(f"time, ms{t * 1e3:19.2f}{u * 1e3:20.2f}   ratio {t / u:.1f}")


if __name__ == "__main__":
    main()
