# SPDX-License-Identifier: Apache-2.0
"""How the crank is balanced, and with which kinematics the imbalance is judged."""

from collections.abc import Iterable

from ..library.tolerances import BALANCE_GRADES
from ..sheet.quantity import choice, dotted, inputs, integer, quantity, series, tables, text
from ..sheet.text import Text

# the folds of the form
BODIES = Text("Bodies of the crank")


@inputs
class Unbalance:
    """An unbalance that turns with the crank: of the pulley, the flywheel …"""

    name: str = text("Name")
    unbalance: float = quantity(
        "Unbalance",
        "kg·mm",
        within=(0, 1e6),
        symbol="U",
        help="Mass times the radius of its centre of gravity.",
        repair="free",
    )
    angle: float = quantity(
        "Angle",
        "°",
        within=(-720, 720),
        symbol="gamma",
        help="With cylinder 1 at TDC, from up, in the sense of rotation.",
        repair="free",
    )
    z: float = quantity(
        "Position", "mm", within=(-5000, 5000), symbol="z", help="From mid-engine, + towards the flywheel."
    )


@inputs
class CrankBody:
    """A web, a counterweight or a pin of the crank, by its mass and centre of gravity."""

    name: str = text("Name", help="Letters, digits and -.")
    mass: float = quantity("Mass", "kg", within=(0, 1000), symbol="m", help="Mass of this web, counterweight or pin.")
    x: float = quantity(
        "Centre of gravity, up",
        "mm",
        within=(-1000, 1000),
        symbol="x",
        help="Height of its centre of gravity, with the throw named above at TDC.",
    )
    y: float = quantity(
        "Centre of gravity, side",
        "mm",
        within=(-1000, 1000),
        symbol="y",
        help="90° further in the sense of crank rotation.",
    )
    z: float = quantity(
        "Position", "mm", within=(-5000, 5000), symbol="z", help="From mid-engine, + towards the flywheel."
    )
    pin: int | None = integer(
        "Crankpin", default=None, within=(1, 16), help="The number of the pin that this body is: a bob is added to it."
    )


@inputs
class ImbalanceInputs:
    """What the crank takes of the reciprocating masses, and the kinematics that are judged."""

    crank_balance_fraction: float = quantity(
        "Share balanced on the crank",
        default=0.5,
        within=(-1, 2),
        symbol="kappa",
        step=0.05,
        usual=(0, 1),
        source="Finotti 2013, 2.3.2",
        help="Of the reciprocating mass; at ½ one shaft takes the rest.",
        change=("lighter counterweights", "heavier counterweights"),
        repair="free",
        decides=1,
    )
    rotating_balance_fraction: float = quantity(
        "Rotating share balanced",
        default=1.0,
        within=(0, 2),
        symbol="kappa_rot",
        step=0.05,
        rule_of_thumb=(0.5, 1),
        help="Of the rotating masses, by the crank's counterweights.",
    )
    kinematics: str = choice(
        "Kinematics",
        "exact",
        "two_term",
        default="exact",
        help="exact: harmonics of the true slider-crank. two_term: cos α + λ cos 2α, as in the textbooks.",
        decides=2,
    )
    counterweight_span: float | None = quantity(
        "Counterweights apart",
        "mm",
        default=None,
        up_to=10000,
        symbol="l",
        source="Finotti 2013, 2.4",
        help="Axial distance of two counterweights about mid-engine.",
        repair="free",
    )
    counterweight_radius: float | None = quantity(
        "Radius of the counterweights",
        "mm",
        default=None,
        up_to=1000,
        symbol="r_cw",
        source="Finotti 2013, 2.4",
        help="Radius of their centres of gravity from the crank's axis.",
        repair="free",
    )
    forward_shaft_axis: tuple[float, ...] | None = series(
        "Axis of the forward balance shaft",
        "mm",
        default=None,
        count=(2, 2),
        within=(-5000, 5000),
        symbol="p_f",
        help="[up, side] from the crank's, side 90° further in the sense of crank rotation: of the shaft of a pair "
        "that turns "
        "with the crank. At unequal heights the pair raises a roll torque.",
    )
    backward_shaft_axis: tuple[float, ...] | None = series(
        "Axis of the backward balance shaft",
        "mm",
        default=None,
        count=(2, 2),
        within=(-5000, 5000),
        symbol="p_b",
        help="[up, side] from the crank's: of the shaft of a pair that turns against the crank.",
    )
    shaft_pair_order: int = integer(
        "Order of the pair",
        default=2,
        within=(1, 2),
        help="Of the two shafts at these axes: 1 turns at ±1, 2 at ±2 times crank speed.",
    )
    crank_bodies_throw_at_tdc: int = integer(
        "Throw up in the list of bodies",
        default=1,
        within=(1, 16),
        help="The cylinder whose throw stands up while the bodies' x and y are given.",
        fold=BODIES,
    )
    bob_mode: str = choice(
        "Bob masses",
        "equal",
        "per_pin",
        "least_squares",
        default="equal",
        help="equal: one mass that takes the couple across the throw that stands up. per_pin: the smallest change "
        "from it that takes "
        "the whole couple. least_squares: least static unbalance and couple over pitch.",
        fold=BODIES,
    )
    bob_mass: float | None = quantity(
        "Bob mass as stated",
        "kg",
        default=None,
        within=(0, 100),
        symbol="m_b",
        source="Finotti 2013, 2.6",
        help="On each pin, on the balancing machine; left out, it is computed.",
        change=("lighter bob", "heavier bob"),
        repair="free",
        fold=BODIES,
    )
    drill_radius: float | None = quantity(
        "Radius of the balancing holes",
        "mm",
        default=None,
        within=(5, 1000),
        symbol="r_d",
        source="Finotti 2013, 2.6",
        help="From the crank's axis to the middle of what is drilled out of a web: given, the webs to drill are found.",
    )
    crank_balance_grade: str = choice(
        "Balance quality grade of the crank",
        *BALANCE_GRADES,
        default="G16",
        help="ISO 21940-11: crank drives that are inherently balanced G16 (rigidly mounted) and G40 (elastically), "
        "inherently unbalanced ones G250 and G630. Judged where the bodies of the crank are given.",
    )
    unbalances: tuple[Unbalance, ...] = tables(
        "Unbalances on the crank",
        Unbalance,
        default=(),
        help="Of pulley and flywheel: they answer the question what the crank itself lacks.",
        fold=BODIES,
    )
    crank_bodies: tuple[CrankBody, ...] = tables(
        "Bodies of the crank",
        CrankBody,
        default=(),
        help="Webs and pins: what bobs does the crank need on the balancing machine?",
        fold=BODIES,
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        for key, given, other in (
            (dotted(ImbalanceInputs.counterweight_radius), self.counterweight_radius, self.counterweight_span),
            (dotted(ImbalanceInputs.counterweight_span), self.counterweight_span, self.counterweight_radius),
        ):
            if given is None and other is not None:
                reason = Text("needed with the other of the two: span and radius give the masses of the counterweights")
                yield key, reason
        for key, axis, beside in (
            (dotted(ImbalanceInputs.forward_shaft_axis), self.forward_shaft_axis, self.backward_shaft_axis),
            (dotted(ImbalanceInputs.backward_shaft_axis), self.backward_shaft_axis, self.forward_shaft_axis),
        ):
            if axis is None and beside is not None:
                yield key, Text("needed with the other of the two: the places of both shafts give the roll of the pair")
        pins = [body.pin for body in self.crank_bodies if isinstance(body.pin, int)]
        if self.crank_bodies and not pins:
            reason = Text("at least one body must say which crankpin it is (pin = 1): the bobs are put there")
            yield dotted(ImbalanceInputs.crank_bodies), reason
        if sorted(pins) != list(range(1, len(pins) + 1)):
            yield (
                dotted(ImbalanceInputs.crank_bodies),
                Text(
                    "the pins must be numbered from 1 without gaps, each once; they are {map}",
                    map=", ".join(map(str, pins)),
                ),
            )
