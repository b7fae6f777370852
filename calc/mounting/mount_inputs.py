# SPDX-License-Identifier: Apache-2.0
"""What an engine stands on: its mounts, and the frame of the machine below them."""

from collections.abc import Iterable

from ..sheet.quantity import THUMB, choice, inputs, quantity, series, tables, text
from ..sheet.text import Text

PLACE = "In engine axes, [up, side, to the flywheel], from mid-engine on the crank's axis."


@inputs
class Mobility:
    """One row of a measured mobility of the foundation: velocity over force, complex, in engine axes."""

    frequency: float = quantity("Frequency", "Hz", above=0, high=10000, symbol="f", help="Rising from row to row.")
    x: tuple[float, ...] = series("Mobility up", "mm/s/N", default=(0.0, 0.0), count=(2, 2), help="[real, imaginary part].")
    y: tuple[float, ...] = series("Mobility to the side", "mm/s/N", default=(0.0, 0.0), count=(2, 2), help="[real, imaginary part].")
    z: tuple[float, ...] = series("Mobility fore and aft", "mm/s/N", default=(0.0, 0.0), count=(2, 2), help="[real, imaginary part].")


@inputs
class Mount:
    """A mount of the engine.  Its stiffness is static; what turns it into the dynamic one stands beside."""

    name: str = text("Name", help="Letters, digits and -.")
    position: tuple[float, ...] = series("Position", "mm", count=(3, 3), low=-10000, high=10000, symbol="r", help=PLACE)
    stiffness: tuple[float, ...] = series(
        "Static stiffness",
        "N/mm",
        count=(3, 3),
        above=0,
        high=1e7,
        symbol="k",
        help="Along the mount's own axes; the first is its compression.",
    )
    dynamic_ratio: float = quantity(
        "Dynamic over static stiffness",
        default=1.3,
        above=0,
        high=10,
        symbol="d",
        usual=(1.1, 1.8),
        source=THUMB,
        help="Natural rubber of 40, 50, 60, 70 Shore A: about 1.1, 1.2, 1.35, 1.6.",
    )
    loss_factor: float | None = quantity(
        "Loss factor",
        default=None,
        low=0,
        high=10,
        symbol="eta",
        usual=(0.03, 0.2),
        source=THUMB,
        help="Natural rubber of 40, 50, 60, 70 Shore A: about 0.05, 0.08, 0.12, 0.16. Left out: 0.1, or none beside damping.",
    )
    damping: float | None = quantity(
        "Viscous damping", "N·s/mm", default=None, low=0, high=1e4, symbol="c", help="Along each own axis, instead of a loss factor."
    )
    turned: tuple[float, ...] | None = series(
        "Turned by",
        "°",
        default=None,
        count=(3, 3),
        low=-360,
        high=360,
        help="[a, b, c] about the fixed axes: first x (up), then y (side), then z (crank).",
    )
    frequency_dependence: str = choice(
        "Frequency dependence",
        "none",
        "fractional",
        default="none",
        help="fractional: the stiffness rises with frequency as much as its constant loss factor asks for.",
    )
    foundation: tuple[float, ...] | None = series(
        "Foundation's stiffness",
        "N/mm",
        default=None,
        count=(1, 3),
        above=0,
        high=1e9,
        symbol="k_f",
        help="Below the mount, along the mount's own axes; one number for all three.",
    )
    foundation_loss: float | None = quantity(
        "Foundation's loss factor", default=None, low=0, high=10, symbol="eta_f", help="Of the foundation itself; left out: 0."
    )
    mobility: tuple[Mobility, ...] = tables(
        "Foundation's mobility",
        Mobility,
        default=(),
        help="Measured at the foot, over frequency; each foot by itself, without cross mobility.",
    )
    deflection_limit: float | None = quantity(
        "Largest deflection",
        "mm",
        default=None,
        above=0,
        high=1000,
        help="Along each own axis, static, mean torque and vibration together.",
    )

    @property
    def eta(self) -> float:
        """The loss factor that counts: given, or that of ordinary rubber where there is no damper."""
        return self.loss_factor if self.loss_factor is not None else 0.0 if self.damping is not None else 0.1

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.loss_factor is not None and self.damping is not None:
            yield "damping_Ns_mm", Text("excludes loss_factor; leave one of the two out")
        if self.frequency_dependence == "fractional" and self.damping is not None:
            yield "frequency_dependence", Text("fractional goes with a loss factor, not with damping_Ns_mm; leave one of the two out")
        yield from loss_problems(self.loss_factor, "loss_factor")
        yield from loss_problems(self.foundation_loss, "foundation_loss")
        if self.foundation is None and self.foundation_loss is not None:
            yield "foundation_loss", Text("needs foundation_N_mm, whose loss it is")
        if self.foundation is not None and len(self.foundation) == 2:
            yield "foundation_N_mm", Text("has 2 entries; needs one, or one for each of the three own axes")
        if self.foundation is not None and self.mobility:
            yield "mobility", Text("excludes foundation_N_mm; leave one of the two out")
        frequencies = [row.frequency for row in self.mobility]
        if frequencies != sorted(set(frequencies)):
            yield "mobility", Text("its frequencies must rise from row to row")


@inputs
class Support:
    """What carries the frame: a tyre, a mount of the cab.  Its stiffness is the dynamic one."""

    name: str = text("Name", help="Letters, digits and -.")
    position: tuple[float, ...] = series("Position", "mm", count=(3, 3), low=-20000, high=20000, symbol="r", help=PLACE)
    stiffness: tuple[float, ...] = series(
        "Dynamic stiffness", "N/mm", count=(3, 3), above=0, high=1e9, symbol="k", help="Along its own axes."
    )
    loss_factor: float | None = quantity(
        "Loss factor", default=None, low=0, high=10, symbol="eta", help="Of the support; left out: 0.1, or none beside damping."
    )
    damping: float | None = quantity(
        "Viscous damping", "N·s/mm", default=None, low=0, high=1e4, symbol="c", help="Instead of a loss factor."
    )
    turned: tuple[float, ...] | None = series(
        "Turned by", "°", default=None, count=(3, 3), low=-360, high=360, help="[a, b, c] about the fixed axes: first x, then y, then z."
    )

    @property
    def eta(self) -> float:
        return self.loss_factor if self.loss_factor is not None else 0.0 if self.damping is not None else 0.1

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.loss_factor is not None and self.damping is not None:
            yield "damping_Ns_mm", Text("excludes loss_factor; leave one of the two out")
        yield from loss_problems(self.loss_factor, "loss_factor")


@inputs
class Move:
    """How far a place moves in a mode of the frame of unit modal mass."""

    name: str = text("Mount, point or support", help="Its name.")
    move: tuple[float, ...] = series("Moves by", count=(3, 3), low=-100, high=100, symbol="phi", help="In engine axes, in 1/√kg.")


@inputs
class FrameMode:
    """A mode of the elastic frame, to unit modal mass.  A place that its shape does not name does not move in it."""

    frequency: float = quantity("Frequency", "Hz", above=0, high=1000, symbol="f", help="Of the frame without the engine.")
    loss_factor: float = quantity("Loss factor", default=0.05, low=0, high=10, symbol="eta", help="Of the mode; left out: 0.05.")
    shape: tuple[Move, ...] = tables("Shape", Move)

    def problems(self) -> Iterable[tuple[str, Text]]:
        yield from loss_problems(self.loss_factor, "loss_factor")


@inputs
class Chassis:
    """The frame of the machine: a second rigid body on its own supports, and what it bends by."""

    mass: float = quantity("Mass", "kg", above=0, high=1e7, symbol="m_c", help="Without the engine.")
    centre_of_gravity: tuple[float, ...] = series("Centre of gravity", "mm", count=(3, 3), low=-20000, high=20000, help=PLACE)
    inertia: tuple[float, ...] = series(
        "Inertia", "kg·m²", count=(3, 3), above=0, high=1e9, symbol="J_c", help="About the axes through its centre of gravity."
    )
    inertia_coupling: tuple[float, ...] | None = series(
        "Coupling entries", "kg·m²", default=None, count=(3, 3), low=-1e9, high=1e9, help="[J_xy, J_yz, J_zx] of the tensor, −∫xy dm."
    )
    supports: tuple[Support, ...] = tables("Supports", Support)
    modes: tuple[FrameMode, ...] = tables("Modes of the frame", FrameMode, default=())

    def problems(self) -> Iterable[tuple[str, Text]]:
        from .tensor import problem  # brings numpy with it

        if (reason := problem(self.inertia, self.inertia_coupling)) is not None:
            yield "inertia_kgm2", reason
        if not self.supports:
            yield "supports", Text("needs at least one support: a frame that nothing carries falls")


def loss_problems(eta: float | None, key: str) -> Iterable[tuple[str, Text]]:
    if eta is not None and eta >= 1:
        yield key, Text("must stay below 1: beyond it a mount is no spring")
