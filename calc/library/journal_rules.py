# SPDX-License-Identifier: Apache-2.0
"""What a plain journal may carry and what is usual: one place for guide texts, checks, screenings and the search."""

from typing import NamedTuple

from ..sheet.formula import formula
from ..sheet.text import EMPTY, Amount, Name, Text
from ..sheet.units import (
    Celsius,
    Kelvin,
    Metre,
    MetrePerSecond,
    Newton,
    NewtonPerMetreSecond,
    Number,
    Pascal,
    Radian,
    RevPerSecond,
)

FINOTTI = Text("Finotti 2013, 3.2.3.1")
TRUMPLER = Text("Trumpler, after Finotti 2013, 5.5.1")
DESIGN_FACTOR = Text(
    "Trumpler, after Shigley, 12-7 (not in Finotti 2013, 5.5.1): a design factor of 2 on the running load"
)

SPECIFIC_LOAD: Pascal = 5e6  # the most that is accepted
USUAL_SPECIFIC_LOAD: Pascal = 2e6
RISE: tuple[Kelvin, Kelvin] = (15.0, 20.0)  # of the oil, for conditions that stay; Finotti 2013, 5.5.2
LENGTH_RATIO: tuple[Number, Number] = (0.2, 1.0)
USUAL_LENGTH_RATIO: tuple[Number, Number] = (0.25, 0.75)  # Finotti 2013, 5.5.2
# as made: least printed clearance (GM L61, rear: 0.033 of 36.733 mm) to largest printed middle (Caterpillar 3304: 0.155
# of 52.895 mm), over d
RELATIVE_CLEARANCE: tuple[Number, Number] = (0.9e-3, 2.9e-3)
MAKERS = Text(
    "rule of this program: makers' least printed clearance (GM L61) to their largest middle (Caterpillar 3304), over d"
)
# of hole or pocket over the length; DIN 31652-2: range of the supply factors
SUPPLY_WIDTH: tuple[Number, Number] = (0.05, 0.7)
TRUMPLER_TEMPERATURE: Celsius = 120.0  # as Finotti 2013, 5.5.1, prints it; Trumpler himself has 250 °F, 121 °C
TRUMPLER_START_LOAD: Pascal = 2e6  # as Finotti 2013, 5.5.1, prints it; Trumpler himself has 300 psi, 2.07 MPa
FULL_FILM_FRICTION: tuple[Number, Number] = (0.002, 0.012)  # Finotti 2013, 5.4.1
SLOPE: Radian = 0.25e-3  # Finotti 2013, 4.6 (in chapter 6): target of the engine's maker
STABLE_FILM: Number = 150.0  # McKee & McKee 1932, cP·rpm/psi
# least speed over that of transition: the surface speed in m/s, within these
SPEED_FACTOR: tuple[Number, Number] = (3.0, 10.0)


@formula(
    "p", "Finotti 2013, 3.2.3.1: specific load on the projected area", unit="MPa", meanings={"l": "Length", "F": "Load"}
)
def specific_load(F: Newton, d: Metre, l: Metre) -> Pascal:
    """>>> specific_load(F=1707, d=0.0595, l=0.0275)
    1043239...
    """
    return F / (d * l)


@formula("W", "Finotti 2013, Table 3.1: heat index P·n/l", unit="N·rpm/mm")
def heat_index(F: Newton, n: RevPerSecond, l: Metre) -> NewtonPerMetreSecond:
    """>>> heat_index(F=1707, n=43.33, l=0.0275)
    2689611...
    """
    return F * n / l


def speed_factor(u: MetrePerSecond) -> Number:
    """The least speed of a journal over its speed of transition; Finotti 2013, 5.5.3."""
    from ..sheet.functions import largest, smallest  # with numpy, without which the rules are read

    return largest(smallest(u, SPEED_FACTOR[1]), SPEED_FACTOR[0])


class Lubrication(NamedTuple):
    """A row of Finotti 2013, Table 3.1 (its text's lines 1375 to 1383): the heat index that a kind of lubrication
    bears, in N·rpm/mm."""

    title: Text
    usual: tuple[int, int]
    most: int | None = None  # where the source lets it go beyond, by how much is cooled

    @property
    def limit(self) -> NewtonPerMetreSecond:
        return N_RPM_MM * (self.usual[1] if self.most is None else self.most)


N_RPM_MM: NewtonPerMetreSecond = 1000 / 60
COOLED = "forced_cooled"  # what a design has that says nothing
LUBRICATIONS = {
    "grease": Lubrication(Text("coarse work, grease by a nipple or wick, still air"), (15_000, 20_000)),
    "ring": Lubrication(Text("fine work, plenty of oil by a ring or the like, still air"), (30_000, 40_000)),
    "ring_moving_air": Lubrication(
        Text("fine work, plenty of oil by a ring or the like, moving air"), (60_000, 70_000)
    ),
    "ring_fast_air": Lubrication(
        Text("plenty of oil by a ring or the like, in a fast stream of air"), (100_000, 200_000)
    ),
    "forced": Lubrication(Text("fine work, plenty of forced oil, still air"), (60_000, 70_000)),
    COOLED: Lubrication(Text("fine work, forced oil and cooling"), (150_000, 240_000), 500_000),
}
HEAT_INDEX = LUBRICATIONS[COOLED].limit

# The same rules in words, for guide texts.
USUAL_LENGTH = Text("usual l/d {low} to {high}", low=Amount(USUAL_LENGTH_RATIO[0]), high=Amount(USUAL_LENGTH_RATIO[1]))
USUAL_CLEARANCE = Text(
    "usual {least} to {most} of d as made",
    least=Amount(RELATIVE_CLEARANCE[0] * 1e3),
    most=Amount(RELATIVE_CLEARANCE[1] * 1e3, "‰"),
)


# --- what bearings are called

IN_WORDS = {"front": Text("front"), "middle": Text("middle"), "rear": Text("rear")}
IN_TITLES = {"front": Text("Front"), "middle": Text("Middle"), "rear": Text("Rear")}


def called(row: str) -> Text:
    """The name of a bearing inside a sentence; those that the program gives speak the reader's language."""
    return IN_WORDS.get(row, EMPTY) or Name(row)


def named_at(what: Text, row: str) -> Text:
    """What is judged or shown, and of which bearing."""
    return Text("{what}, {place}", what=what, place=called(row))


def titled(row: str) -> Text:
    """The same at the beginning of a sentence."""
    return IN_TITLES.get(row, EMPTY) or Name(row)
