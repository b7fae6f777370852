# SPDX-License-Identifier: Apache-2.0
"""The tables of the pairing: bearing materials, applications, journals that run.

Read without numpy: a design's words are checked against them before anything is solved.
"""

from difflib import get_close_matches
from functools import cache
from typing import cast

from ...library.catalogue import CatalogueRows
from ...library.catalogue import rows_of as rows
from ...sheet.quantity import choice, inputs, quantity, text
from ...sheet.text import Text
from ...sheet.units import Celsius, Metre, Newton, Number, Pascal, PascalMetrePerSecond, RevPerSecond

SCALE = ("poor", "fair", "good", "excellent")  # emergency running, from bad to good
DEFAULT_APPLICATION = "balance-shaft"


@inputs
class BearingMaterial:
    """What a steel journal runs on.  A number that no source gives is None."""

    name: str = text("Name")
    title: str = text("What it is")
    form: str = choice(
        "Form", "bare", "shell", "solid", help="bare: the housing itself; shell: a thin lining on steel; solid: a bush."
    )
    specific_load: Pascal | None = quantity("Allowable specific load", "MPa", default=None, above=0, symbol="p_zul")
    pv: PascalMetrePerSecond | None = quantity("Allowable p·v", "MPa·m/s", default=None, above=0, symbol="(p·v)_zul")
    temperature: Celsius | None = quantity("Highest temperature", "°C", default=None, symbol="T_zul")
    journal_hardness: Number | None = quantity("Least hardness of the journal, HB", default=None, above=0)
    emergency_running: str = choice("Emergency running", *SCALE)
    emergency_basis: str = text("What the word rests on")
    fatigue: str = text("Fatigue")
    source: str = text("Source")
    yield_: Pascal | None = quantity("Yield stress of the lining", "MPa", default=None, above=0)


@inputs
class Application:
    """What the bearings of one application usually carry.  None: the source prints nothing there."""

    name: str = text("Name")
    title: str = text("What it is")
    specific_load_low: Pascal | None = quantity("Specific load, from", "MPa", default=None)
    specific_load_high: Pascal | None = quantity("Specific load, to", "MPa", default=None)
    pv: PascalMetrePerSecond | None = quantity("p·v", "MPa·m/s", default=None)
    duty_low: Number | None = quantity("µ·n/p, from", default=None)
    duty_high: Number | None = quantity("µ·n/p, to", default=None)
    length_ratio_low: Number | None = quantity("Length ratio, from", default=None)
    length_ratio_high: Number | None = quantity("Length ratio, to", default=None)


@inputs
class RunningBearing:
    """A journal that the source compares with others."""

    name: str = text("Name")
    diameter: Metre = quantity("Journal diameter", "mm")
    length: Metre = quantity("Length", "mm")
    speed: RevPerSecond = quantity("Speed", "rpm")
    load: Newton = quantity("Load", "N")
    status: str = text("Status")
    source: str = text("Source")


@cache
def bearing_materials() -> CatalogueRows[BearingMaterial]:
    return CatalogueRows("bearing_materials.toml", "row", BearingMaterial)


@cache
def applications() -> dict[str, Application]:
    return cast(dict[str, Application], rows("applications.toml", Application))


def application(name: str) -> Application:
    """One of them, by a name that is known."""
    return cast(Application, rows("applications.toml", Application, name)[name])


@cache
def running_bearings() -> dict[str, RunningBearing]:
    return cast(dict[str, RunningBearing], rows("running_bearings.toml", RunningBearing))


def running_surface(bush: str | None, housing: str) -> BearingMaterial | None:
    """What the journal runs on: the bush, else the housing itself; None for a housing that the table does not know."""
    return bearing_materials().get(housing if bush is None else bush)


def bushes() -> tuple[str, ...]:
    """The materials that a bush may be of."""
    return tuple(m.name for m in bearing_materials().values() if m.form != "bare")


def bush_problem(name: str) -> Text | None:
    """Why a word is no bush; None where it is one."""
    return _unknown(name, list(bushes()))


def application_problem(name: str) -> Text | None:
    """Why a word is no application; None where it is one."""
    if name == DEFAULT_APPLICATION:
        return None
    return _unknown(name, list(applications()))


def _unknown(name: str, known: list[str]) -> Text | None:
    if name in known:
        return None
    near = get_close_matches(name, known, n=1)
    return Text("must be one of {known}", known=", ".join(known)) + (
        Text("; did you mean {near}?", near=near[0]) if near else ""
    )
