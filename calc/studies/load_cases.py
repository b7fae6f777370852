# SPDX-License-Identifier: Apache-2.0
"""The load cases that govern a design, each with its values, in a line for each step that has one."""

from collections.abc import Callable, Iterator

from ..bearings.plain.result import PlainResult
from ..bearings.result import BearingsResult
from ..countershaft.rows import called
from ..design.model import TITLES
from ..gears.rating.result import MeshRating
from ..mounting.notes import loads
from ..mounting.result import MountingResult
from ..sheet.text import COMMA, SEMICOLON, Amount, Text
from ..solve import Results
from .described import of_shaft

DUST = 0.05  # of what a bearing carries: what the whole shaft makes below is left by the rounding of its masses


def load_cases(results: Results) -> Iterator[tuple[Text, Text]]:
    """A title and the numbers of what loads the parts hardest."""
    design = results.design

    def of_shafts(told: Callable[[Results], Iterator[Text]]) -> Text:
        words = [of_shaft(design, name, each) for name, view in results.views.items() for each in told(view)]
        return SEMICOLON.join(words)

    if turning := of_shafts(_turning):
        yield design.title("countershaft"), turning
    if carried := of_shafts(_carried):
        yield TITLES["bearings"], SEMICOLON.join([carried, *_oil(results)])
    if teeth := SEMICOLON.join(_teeth(results)):
        yield TITLES["gears"], teeth
    mounts, engine = results.result(MountingResult), design.engine
    if design.mounting is not None and engine is not None and mounts is not None:
        yield TITLES["mounting"], SEMICOLON.join(loads(design.mounting, engine, mounts))


def _turning(view: Results) -> Iterator[Text]:
    """What the masses of a shaft make."""
    shaft, given = view.shaft, view.design.countershaft
    if shaft is None or given is None or view.design.engine is None:
        return
    carried = view.result(BearingsResult)
    least = DUST * max((bearing.load for bearing in carried.bearings.values()), default=0.0) if carried else 0.0
    span = given.bearing_positions[-1] - given.bearing_positions[0]
    parts = []
    if shaft.couple > least * span:
        parts.append(Text("couple {couple}", couple=Amount(shaft.couple, "N·m")))
    if shaft.force > least:
        parts.append(Text("force {force}", force=Amount(shaft.force, "N")))
    speed = Amount(abs(given.speed_ratio) * view.design.engine.rated_speed * 60, "rpm")
    yield Text("{loads} at {speed}", loads=COMMA.join(parts), speed=speed)


def _carried(view: Results) -> Iterator[Text]:
    """What each bearing of a shaft carries that turns with it."""
    bearings = view.result(BearingsResult)
    if bearings is not None:
        loads = bearings.bearings.items()
        yield COMMA.join(Text("{row} {load}", row=called(name), load=Amount(one.load, "N")) for name, one in loads)


def _oil(results: Results) -> Iterator[Text]:
    given = results.design.bearings
    if given is not None:
        outlets = [value.shown for value in results.values_of(PlainResult.outlet_temperature)]
        words = Text("oil {supplied} in", supplied=Amount(given.supply_temperature, "°C"))
        if outlets:
            words = Text("{oil}, {out} out", oil=words, out=Amount(max(outlets), "°C", form=".0f"))
        yield Text("{oil}; cold start at {lowest}", oil=words, lowest=Amount(given.lowest_temperature, "°C"))


def _teeth(results: Results) -> Iterator[Text]:
    """The force that drives them."""
    train, gears = results.train, results.design.gears
    if train is None or gears is None:
        return
    if driving := [value.shown for value in results.values_of(MeshRating.tangential_force)]:
        yield Text("driving with {force} at rated speed", force=Amount(max(driving), "N"))
    if gears.life is not None:
        yield Text("life {hours}", hours=Amount(gears.life / 3600, "h"))
