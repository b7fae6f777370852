# SPDX-License-Identifier: Apache-2.0
"""The balance shafts in a model of REXS: sections front to rear, what is eccentric on them, and their bearings.

Of a sector the core is a section and the rest an additional mass, so that all of them together weigh what the shaft
does.  The moments of such a mass are about its own axes, in the sector's middle on the shaft's axis: no reader adds its
eccentricity once more.  Angles are those with cylinder 1 at TDC."""

from collections.abc import Iterator
from math import cos, sin

from ..countershaft.inputs import EccentricMass
from ..countershaft.mass_properties import moment_of_squares
from ..countershaft.outline import SECTOR, Outline, Piece, centre_of_gravity, sector_area, sector_mass, sector_moment
from ..countershaft.twins import Resolved, turned_over
from ..sheet.formula import formula
from ..sheet.text import Amount, Text
from ..sheet.units import KilogramMetre2, KilogramPerMetre3, Metre, Metre4, Radian, SquareMetre
from .rexs_bearings import BearingPlace, add_bearing
from .rexs_file import Component, Content, pose
from .rexs_unit import GearUnit

ABOUT_AXIS = Text("geometry: sector without its core, about axes in its middle on the shaft's axis")
SMALLEST: Metre = 1e-9  # of a core: less is none
NO_HOLE = Text("{name} of {shaft}, {less}, is left out: masses in a file of REXS are above zero.")
ON_CRANK = Text("Where the shaft stands is not known: it stands on the crank's axis. axis_mm says it.")


@formula("P", Text("{sector}: its polar moment about the axis", sector=SECTOR), unit="mm⁴")
def sector_polar_moment(gamma: Radian, R: Metre, r_0: Metre) -> Metre4:
    return gamma * (R**4 - r_0**4) / 2


@formula("J_u", ABOUT_AXIS, unit="kg·mm²", meanings={"rho": "Density", "b": "Length of the sector"})
def about_shaft(rho: KilogramPerMetre3, b: Metre, P: Metre4) -> KilogramMetre2:
    return rho * b * P


@formula("J_v", ABOUT_AXIS, unit="kg·mm²", meanings={"rho": "Density", "b": "Length of the sector"})
def across_shaft(rho: KilogramPerMetre3, b: Metre, I: Metre4, A: SquareMetre) -> KilogramMetre2:
    """`I`: second moment of the cross-section about that axis."""
    return rho * b * (I + A * b**2 / 12)


def add_shaft(
    unit: GearUnit, name: str, axis: complex, start: Metre, wheel: str, speed: float | None, mass: float | None
) -> Component:
    """`speed`: in the design's sense.  `wheel`: that turns it."""
    turned = None if speed is None else unit.frame.turn * speed
    shaft = unit.model.add(
        "shaft",
        name,
        defines_speed=unit.heads(wheel),
        rotational_speed=turned,
        **pose(unit.at(axis, start)),
        mass_of_component=mass,
    )
    unit.model.relate("assembly", assembly=unit.gear_unit, part=shaft)
    return shaft


def add_section(
    unit: GearUnit, shaft: Component, name: str, u: Metre, length: Metre, outside: Metre, inside: Metre
) -> None:
    section = unit.model.add(
        "shaft_section",
        name,
        u_coordinate_on_shaft=u,
        length=length,
        outer_diameter_begin=outside,
        outer_diameter_end=outside,
        inner_diameter_begin=inside,
        inner_diameter_end=inside,
    )
    unit.model.relate("assembly", assembly=shaft, part=section)


class WrittenShaft:
    """One of the design's shafts."""

    def __init__(self, unit: GearUnit, shaft: Resolved) -> None:
        self.unit, self.name, self.inputs, self.how = unit, shaft.name, shaft.inputs, shaft.how
        self.solved, self.carrier = unit.solved(shaft), unit.carrier(shaft)
        self.outline = self.solved.outline if self.solved is not None else None
        self.rows = [row for row in self.inputs.bearings if row.position is not None]
        axis = self.inputs.axis
        self.axis = unit.places.get(self.carrier, None if axis is None else complex(*axis))

    def add(self) -> None:
        unit, inputs = self.unit, self.inputs
        if self.axis is None and len(unit.design.resolved) > 1:
            words = Text(
                "Left out, since where {shaft} stands is not known: give axis_mm = [up, side].", shaft=self.name
            )
            unit.notes.append(words)
            return
        if self.axis is None:
            unit.notes.append(ON_CRANK)
        self.place = self.axis or 0j
        points = list(self._points())
        self.start = self._front(points)
        mass = self.solved.mass if self.solved is not None else None
        shaft = add_shaft(unit, self.name, self.place, self.start, self.carrier, self._speed(), mass)
        unit.material(shaft, inputs.material)
        if self.outline is not None:
            self._pieces(shaft, self.outline)
        else:
            words = Text("The outline of {shaft} is not known: it has no sections.", shaft=self.name)
            unit.notes.append(words)
        for point in points:
            self._point(shaft, point)
        for row in self.rows:
            at = BearingPlace(shaft, self.name, row.position - self.start, pose(unit.at(self.place, row.position)))
            add_bearing(unit, row, at)
        if self.carrier:
            unit.carried[self.carrier] = shaft, self.start

    def _speed(self) -> float | None:
        """In the design's sense: as the train turns it, else as it must turn."""
        unit = self.unit
        if unit.train is not None and self.carrier in unit.train.speeds:
            return unit.train.speeds[self.carrier]
        if unit.design.engine is None or self.inputs.speed_ratio is None:
            return None
        return self.inputs.speed_ratio * unit.design.engine.rated_speed

    def _front(self, points: list[EccentricMass]) -> Metre:
        """The front end of all that is on it."""
        rows = [(row.position, row.on_shaft or (0.0, 0.0)) for row in self.rows]
        if self.outline is not None:
            ends = [self.outline.start, *(z for z, _ in rows)]
        else:
            ends = [z - length / 2 for z, (_, length) in rows]
        ends += [point.z for point in points]
        if self.carrier in self.unit.planes:
            ends.append(self.unit.planes[self.carrier])
        return min(ends, default=0.0)

    # --- sections and masses

    def _pieces(self, shaft: Component, outline: Outline) -> None:
        unit, density = self.unit, self.unit.design.materials[self.inputs.material].density
        for piece, name in zip(outline.pieces, self._names(outline)):
            solid = piece.outer_radius if piece.half_angle is None else piece.core_radius
            if solid > SMALLEST:
                add_section(unit, shaft, name, piece.start - self.start, piece.length, 2 * solid, 2 * outline.bore)
            else:
                words = Text("The {sector} of {shaft} has no core: it is no section.", sector=name, shaft=self.name)
                unit.notes.append(words)
            if piece.half_angle is not None:
                self._sector(shaft, piece, name, density * outline.heavier)

    def _sector(self, shaft: Component, piece: Piece, name: str, rho: float) -> None:
        gamma, R, r_0, b = piece.half_angle or 0.0, piece.outer_radius, piece.core_radius, piece.length
        A = sector_area(gamma=gamma, R=R, r_0=r_0)
        e = centre_of_gravity(S=sector_moment(gamma=gamma, R=R, r_0=r_0), A=A)
        phi = self._turned(piece.angle)
        P = sector_polar_moment(gamma=gamma, R=R, r_0=r_0)  # ∫x² + ∫y²
        D = moment_of_squares(gamma=gamma, R=R, r_0=r_0, phi=phi).real  # ∫x² − ∫y²
        about_v, about_w = (across_shaft(rho=rho, b=b, I=I, A=A) for I in ((P - D) / 2, (P + D) / 2))
        self._mass(
            shaft,
            name,
            sector_mass(rho=rho, A=A, b=b),
            (piece.start + piece.end) / 2,
            complex(e * cos(phi), e * sin(phi)),
            moment_of_inertia_u_axis=about_shaft(rho=rho, b=b, P=P),
            moment_of_inertia_v_axis=about_v,
            moment_of_inertia_w_axis=about_w,
            length=b,
        )

    def _point(self, shaft: Component, point: EccentricMass) -> None:
        """A mass whose shape is not known, as a point: its moments about its own axes follow from its eccentricity."""
        if point.mass <= 0:
            if point.mass:
                self.unit.notes.append(Text(NO_HOLE, name=point.name, less=Amount(point.mass, "kg"), shaft=self.name))
            return
        e, phi = point.radius, self._turned(point.angle)
        v, w = e * cos(phi), e * sin(phi)
        self._mass(
            shaft,
            point.name,
            point.mass,
            point.z,
            complex(v, w),
            moment_of_inertia_u_axis=point.mass * e**2,
            moment_of_inertia_v_axis=point.mass * w**2,
            moment_of_inertia_w_axis=point.mass * v**2,
        )

    def _mass(self, shaft: Component, name: str, mass: float, z: Metre, off: complex, **shape: float) -> None:
        unit = self.unit
        place: dict[str, Content] = {**shape, **pose(unit.at(self.place, z))}
        additional = unit.model.add(
            "additional_mass",
            name,
            mass_of_component=mass,
            u_coordinate_on_shaft=z - self.start,
            eccentricity_vector=(0.0, off.real, off.imag),
            **place,
        )
        unit.model.relate("assembly", assembly=shaft, part=additional)

    def _turned(self, angle: float) -> float:
        """An angle of the original about u, from v."""
        return self.unit.frame.angle(-angle if self.how == "mirrors" else angle)

    def _points(self) -> Iterator[EccentricMass]:
        """What the outline does not hold, as the original has it: of a plain or unknown one the masses too."""
        own: tuple[EccentricMass, ...] = self.inputs.extras
        if self.solved is None:
            own = (*self.inputs.masses, *own)
        elif self.outline is None or self.outline.plain:
            yield from self.solved.masses
        yield from map(turned_over, own) if self.how == "mirrors" else own

    def _names(self, outline: Outline) -> Iterator[str]:
        """What its pieces are called: a sector by its mass, a journal by its bearing."""
        masses = list(self.solved.masses) if self.solved is not None else []
        for piece in outline.pieces:
            if piece.half_angle is not None:
                there = [mass.name for mass in masses if piece.start <= mass.z <= piece.end]
                yield f"sector {there[0]}" if len(there) == 1 else "sector"
            else:
                on = [row.name for row in self.rows if piece.start <= row.position <= piece.end]
                yield f"journal {on[0]}" if len(on) == 1 else piece.what
