# SPDX-License-Identifier: Apache-2.0
"""What of a solved design is drawn: the shaft, and beside it the data of its wheels."""

from collections.abc import Mapping
from math import pi

from ..draw.drawing import Arc, Primitive, Words
from ..draw.shaft_outline import shaft_drawing
from ..draw.sizes import Say
from ..draw.wheel_sheet import wheel_sheets
from ..draw.workshop import shaft_sheet
from ..draw.workshop_sheet import Release, WorkshopSheet
from ..gears.profile.drawing import data_table, in_row, reach
from ..gears.result import TrainResult
from ..sheet.step import Table
from ..sheet.text import EMPTY, Name, Text
from ..solve import Results

__all__ = ["WorkshopSheet", "drawable", "shafts", "sheets", "train", "wheel_sheet", "wheels"]
NONE = Text("–")


def shafts(results: Results) -> list[tuple[Primitive, ...]]:
    """The side view of each shaft that is no twin as lines; without those whose outline is not known."""
    drawn = []
    for view in drawable(results).values():
        asked, solved = view.design.countershaft, view.shaft
        if asked is not None and solved is not None and solved.outline is not None:
            drawn.append(shaft_drawing(solved.outline, asked.bearing_positions))
    return drawn


def drawable(results: Results) -> dict[str, Results]:
    """Each shaft that is no twin in view, by its name; without those whose outline is not known."""
    return {
        name: view
        for name, view in results.views.items()
        if view.design.countershaft is not None and view.shaft is not None and view.shaft.outline is not None
    }


DIGITS = 16  # of the SHA-256 of a design that are printed


def release_of(results: Results, sha256: str = "") -> Release:
    """Whether the sheets of a design may be used: it passes, and somebody has approved it."""
    signature = dict(results.design.control.signatures())["approved"]
    approved = " ".join(filter(None, (signature.name, signature.date)))
    return Release(results.verdict == "pass", results.words(), approved, sha256[:DIGITS])


def sheets(
    results: Results, say: Say = str, data: Mapping[str, object] | None = None, sha256: str = ""
) -> list[WorkshopSheet]:
    """The workshop drawings of what the design has: each shaft that is no twin, or its wheels where it is of gears
    alone.

    `data`: of the design's file, for what it leaves to the program; `sha256`: of that file.
    """
    release = release_of(results, sha256)
    if results.design.countershaft is None:
        return list(wheel_sheets(results, say, data, release).values())
    views = drawable(results)
    drawn = []
    for n, (name, view) in enumerate(views.items(), 1):
        alone = len(results.design.shafts) == 1 and results.of_shafts  # which one of several in view does not have
        title = "" if alone else say(titled(view, name))
        sheet = shaft_sheet(view, say, data, title=title, sheet=f"{n}/{len(views)}", release=release)
        drawn += [] if sheet is None else [sheet]
    return drawn


def wheel_sheet(
    results: Results, wheel: str, data: Mapping[str, object] | None = None, sha256: str = ""
) -> WorkshopSheet:
    """The workshop drawing of one wheel of a train that is solved, also where it sits on a shaft."""
    return wheel_sheets(results, str, data, release_of(results, sha256))[wheel]


def titled(view: Results, name: str) -> Text:
    """What the title block says of one of several shafts: whose drawing it is, and for which others it stands."""
    words = {"mirrors": Text("{title}; {name} is its mirror image"), "repeats": Text("{title}; {name} is its like")}
    title = Text("Balance shaft {name}", name=Name(name))
    for shaft in view.design.resolved:
        if shaft.how in words:
            title = Text(words[shaft.how], title=title, name=Name(shaft.name))
    return title


def wheels(results: Results) -> Table | None:
    """The data of every wheel as they stand on its drawing, with limits where the design gives them; lengths in mm."""
    train, gears = results.result(TrainResult), results.design.gears
    if train is None or gears is None:
        return None
    data = {name: dict(data_table(train, name, gears)) for name in train.wheels}
    labels = dict.fromkeys(label for rows in data.values() for label in rows)
    rows = tuple((label, *(rows.get(label, NONE) for rows in data.values())) for label in labels)
    return Table(
        "drawing_data",
        Text("Data of the wheels, lengths in mm"),
        ((EMPTY, ""), *((Name(name), "") for name in data)),
        rows,
    )


def train(results: Results) -> tuple[Primitive, ...]:
    """The wheels of a train as circles, each beside its driver and with its name."""
    solved = results.result(TrainResult)
    if solved is None:
        return ()
    drawn: list[Primitive] = []
    for name, centre in in_row(solved).items():
        x, y, radius = centre.real, centre.imag, reach(solved, name)
        drawn += [Arc("OUTLINE", (x, y), radius, 0.0, 2 * pi), Arc("AXIS", (x, y), radius / 12, 0.0, 2 * pi)]
        drawn.append(Words("TEXT", (x, y - radius), Name(name), radius / 4))
    return tuple(drawn)
