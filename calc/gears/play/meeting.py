# SPDX-License-Identifier: Apache-2.0
"""One mesh with all that its play depends on: both wheels, their teeth at the base circle, runout, the parts between the centres."""

from typing import TYPE_CHECKING, Any

from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.trace import about
from ...sheet.units import Metre
from ..inputs import GearsInputs, Mesh
from . import backlash as b
from .stack import Stack, stack_of

if TYPE_CHECKING:
    from ..result import MeshResult, ToothSystem, TrainResult, WheelResult


@record
class Teeth:
    """Transverse thickness at the base circle of a wheel, over its allowance."""

    thickest: Metre
    middle: Metre
    thinnest: Metre


@record
class Meeting:
    key: str
    name: str  # driver–driven
    place: str  # of the mesh in the design
    system: "ToothSystem"
    inputs: Mesh
    mesh: "MeshResult"
    driver: "WheelResult"
    driven: "WheelResult"
    teeth: tuple[Teeth, Teeth]
    runouts: tuple[Metre, Metre] | None  # None: not given for either wheel
    stack: Stack | None
    closest: Metre  # the smallest centre distance within the tolerance and, where it is given, the runout

    @property
    def touching(self) -> Metre:
        """The centre distance at which the base circles would touch."""
        return (self.driver.base_diameter + self.driven.base_diameter) / 2

    @property
    def eccentricity(self) -> Metre:
        return sum(self.runouts) / 2 if self.runouts else 0.0

    def must_mesh(self, a: Metre, by: str) -> None:
        """Nothing can be said of wheels whose base circles overlap."""
        if a <= self.touching:
            raise NoSolution(
                f"{self.place}: {by} leaves {a * 1e3:.6g} mm between {self.driver.name} and {self.driven.name}: they can not mesh",
                advice=f"smaller fields: the centre distance must stay above {self.touching * 1e3:.6g} mm, where the base circles touch",
            )


def meetings(gears: GearsInputs, train: "TrainResult") -> list[Meeting]:
    """Every mesh of the train, in the order of the inputs."""
    wanted = {w.name: w for w in gears.wheels}
    teeth = {name: _teeth(train.system, wheel) for name, wheel in train.wheels.items()}
    found = []
    for i, (inputs, (key, mesh)) in enumerate(zip(gears.meshes, train.meshes.items())):
        driver, driven = train.wheels[mesh.driver], train.wheels[mesh.driven]
        name, runouts = f"{mesh.driver}–{mesh.driven}", _runouts(wanted[mesh.driver].runout, wanted[mesh.driven].runout)
        with about(f"mesh {name}, centres at their closest"):
            closest = b.narrowest(mesh.centre_distance, mesh.centre_tolerance)
            if runouts is not None:
                closest = b.narrowest_with_runout(closest, *runouts)
        both = teeth[mesh.driver], teeth[mesh.driven]
        found.append(
            Meeting(
                key, name, f"gears.meshes.{i}", train.system, inputs, mesh, driver, driven, both, runouts, stack_of(inputs), closest
            )
        )  # fmt: skip
    return found


def _runouts(one: Metre | None, two: Metre | None) -> tuple[Metre, Metre] | None:
    return None if one is None and two is None else (one or 0.0, two or 0.0)


def _teeth(system: "ToothSystem", wheel: "WheelResult") -> Teeth:
    shape: Any = dict(d_b=wheel.base_diameter, s_t=wheel.reference_thickness, d=wheel.pitch_diameter)
    shape |= dict(alpha_t=system.transverse_pressure_angle, beta_b=system.base_helix_angle)
    if wheel.allowance is None:
        with about(f"wheel {wheel.name}"):
            s_b = b.base_thickness(**shape, E_W=0.0)
        return Teeth(s_b, s_b, s_b)
    upper, lower = wheel.allowance
    ends = []
    for tooth, E_W in (("thickest", upper), ("middle", None), ("thinnest", lower)):
        with about(f"wheel {wheel.name}, {tooth} tooth"):
            ends.append(b.base_thickness(**shape, E_W=b.middle_allowance(upper, lower) if E_W is None else E_W))
    return Teeth(*ends)
