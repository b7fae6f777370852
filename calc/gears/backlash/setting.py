# SPDX-License-Identifier: Apache-2.0
"""Whether a mesh that is set without backlash on a coat keeps enough of it once the coat has worn off."""

from collections.abc import Mapping

from ...sheet.check import Check, CheckRule
from ...sheet.quantity import dotted
from ...sheet.remedy import by_key, digits
from ...sheet.step import Outcome
from ...sheet.text import Text
from ...sheet.units import UNITS, Metre
from ...sheet.value import about, trace
from ..drive.window import smallest_normal
from ..inputs import GearsInputs, Mesh
from ..result import TrainResult
from .formulas import PlayResult, needed_backlash

KEY = dotted("gears", GearsInputs.meshes, "#", Mesh.coat)
COAT = CheckRule(
    "gears.M.coat",
    "limit",
    "The teeth jam: the coat that wears off is all the backlash that they have.",
    unit="µm",
    source=Text(
        "rule of this program: what the coat leaves must be what tolerance, runout and temperature take of this mesh, "
        "its share of the window of the backlash"
    ),
    advice=Text("A thicker coat, or a looser setting."),
    role="physics",
    zero="the backlash that the coat leaves",
    value_id=dotted("gears", "M", PlayResult.coat_backlash),
    moved_by=(KEY, dotted("gears", GearsInputs.meshes, "#", Mesh.tolerance)),
)


def coat_checks(gears: GearsInputs, train: TrainResult) -> Outcome[object]:
    """Lines and checks of the meshes with a coat."""
    made: list[Check] = []
    plays: Mapping[str, PlayResult] = train.play or {}
    with trace() as lines:
        for i, mesh in enumerate(gears.meshes):
            play = plays.get(mesh.key)
            if play is None or play.coat_backlash is None:
                continue
            name = Text("mesh {name}", name=mesh.title)
            with about(name):
                j = train.meshes[mesh.key].backlash_nominal
                need: Metre = needed_backlash(j_bn=j, j_least=smallest_normal(train, mesh.key))
            thicker = digits(UNITS["µm"].shown(need / 2), 4)
            made.append(
                COAT(
                    play.coat_backlash,
                    need,
                    at=mesh.key,
                    index=i,
                    name=Text("Backlash {name} once its coat has worn off", name=mesh.title),
                    scale=play.coat_backlash,
                    remedies=by_key(Mesh, KEY.replace("#", str(i)), thicker, place=mesh.title, bound=">="),
                )
            )
    return Outcome("gears", checks=tuple(made), lines=tuple(lines))
