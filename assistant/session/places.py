# SPDX-License-Identifier: Apache-2.0
"""Places in the tables of a design: names of keys and indices of arrays, which hold while an element is being renamed;
and how an array gets an element more, or less."""

import re
from collections.abc import Callable, Collection, Sequence
from itertools import pairwise
from typing import Any

from calc.countershaft.inputs import ShaftInputs, ShaftLoad
from calc.countershaft.making.inputs import Bolts
from calc.countershaft.rows import BearingRow
from calc.design.addresses import Table, as_list, as_table, changed
from calc.design.labels import BEARINGS, SHAFTS, Place, content_at, with_bearings
from calc.design.model import Design
from calc.design.other_tables import Measured, OptimiseInputs
from calc.design.upgrade import TWIN, is_twin, twin, without
from calc.gears.inputs import GearsInputs, Mesh, Stage
from calc.gears.wheel_inputs import Wheel
from calc.sheet.quantity import Quantity, dotted, keys
from calc.sheet.text import EMPTY, Name, Text

OF_SHAFT = ("countershaft", "bearings", "gears")  # the steps that have something of each shaft
CARRIES = (dotted(ShaftInputs.bolts), dotted(Bolts.carries))
NAME, MIRRORS, REPEATS = "name", dotted(ShaftInputs.mirrors), dotted(ShaftInputs.repeats)


def described(where: Place) -> Quantity:
    """The description of the quantity at a place."""
    cls: type = Design
    about: Quantity | None = None
    for part in where:
        if isinstance(part, str):
            about = keys(cls)[part].about
            cls = about.table or cls
    if about is None:
        raise KeyError(where)
    return about


def without_empty(data: Table, where: Place) -> Table:
    """A table that may be left out and has lost its last key is left out."""
    while (outer := optional_table(where)) is not None and content_at(data, outer) in ({}, None):
        data = changed(data, outer, None)
        where = outer
    return data


def optional_table(where: Place) -> Place | None:
    """The innermost table around a place, inside its step, that may be left out."""
    for end in range(len(where) - 1, 1, -1):
        if (
            isinstance(where[end - 1], str)
            and described(where[:end]).kind == "table"
            and described(where[:end]).optional
        ):
            return where[:end]
    return None


def error_place(data: Any, key: str) -> Place:
    """The place that an error names; elements of arrays by index."""
    place: list[str | int] = []
    here = data
    for part in key.split(".") if key else ():
        if isinstance(here, list) and part.isdigit():
            place.append(int(part))
            here = here[int(part)] if int(part) < len(here) else {}
        else:
            place.append(part)
            here = here.get(part, {}) if isinstance(here, dict) else {}
    return tuple(place)


def key_at(where: Place) -> str:
    """A place as its last key: what the design file calls it."""
    return str(where[-1]) if where else ""


def named_key(data: Table, where: Place) -> str:
    """A place as a dotted key, in which elements of arrays go by their names where they have one."""
    parts: list[str] = []
    here: Any = with_bearings(data, where)
    for part in where:
        here = content_at(here, (part,))
        name = here.get("name") if isinstance(part, int) and isinstance(here, dict) else None
        parts.append(name if isinstance(name, str) and name else str(part))
    return ".".join(parts)


def first_key(where: Place) -> str:
    """The first key of a table, or of an element of an array of tables."""
    return next(iter(keys(described(where).table)), "")


def owner(where: Place) -> type:
    """The Inputs class that the last key of a place belongs to."""
    cls: type = Design
    for part in where[:-1]:
        if isinstance(part, str):
            cls = keys(cls)[part].about.table or cls
    return cls


# --- several shafts


def original_of(shaft: Table) -> str:
    """The name of the shaft that a twin is of; of any other its own."""
    return str(shaft.get(MIRRORS) or shaft.get(REPEATS) or shaft.get(NAME, ""))


def twin_words(shaft: Table) -> Text:
    """`mirrors left`, `repeats left`; empty of a shaft of its own."""
    if MIRRORS in shaft:
        return Text("mirrors {name}", name=Name(original_of(shaft)))
    return Text("repeats {name}", name=Name(original_of(shaft))) if REPEATS in shaft else EMPTY


def row_of_original(data: Table, row: Place) -> Table:
    """Of the row of a twin that of its original, whose kind it is of; empty of any other."""
    shaft, name = as_table(content_at(data, row[:2])), as_table(content_at(with_bearings(data, row), row)).get(NAME)
    if not is_twin(shaft):
        return {}
    shafts = [as_table(there) for there in as_list(content_at(data, SHAFTS))]
    bearings = [as_list(one.get(str(BEARINGS[0]))) for one in shafts if one.get(NAME) == original_of(shaft)]
    rows = [as_table(there) for of_original in bearings for there in of_original]
    return next((there for there in rows if there.get(NAME) == name), {})


def without_silent(data: Table, where: Place) -> Table:
    """The tables once a twin says nothing of any bearing: without a row for each."""
    if where[:1] != SHAFTS or where[2:3] != BEARINGS or where[-1] == NAME or not is_twin(content_at(data, where[:2])):
        return data
    silent = all(as_table(row).keys() == {NAME} for row in as_list(content_at(data, where[:3])))
    return changed(data, where[:3], None) if silent else data


# --- elements of arrays of tables

POSITION = dotted(BearingRow.position)
AXIS, PLACE = dotted(ShaftInputs.axis), dotted(Wheel.position)
VALUE = dotted(Measured.value)
GEARS = dotted(Design.gears)
WHEELS: Place = (GEARS, dotted(GearsInputs.wheels))
MESHES: Place = (GEARS, dotted(GearsInputs.meshes))
STAGES: Place = (GEARS, dotted(GearsInputs.stages))
FRICTION, LOADS, CARRIED_BY = dotted(Design.friction), dotted(ShaftInputs.loads), dotted(ShaftLoad.wheel)
SITS_ON, DRIVER, DRIVEN = dotted(Wheel.shaft), dotted(Mesh.driver), dotted(Mesh.driven)


def names_of(there: list[Table]) -> list[object]:
    return [element.get(NAME) for element in there]


def further(where: Place, there: list[Table], of_twin: Sequence[str] = ()) -> tuple[list[Table], int]:
    """An array with one element more, and its index.

    It is like the last one but with a name of its own; a bearing stands in the middle of the widest gap between two,
    one of a twin, whose original has the bearings `of_twin`, is the first of them of which nothing is said yet."""
    about, index = described(where), len(there)
    element = dict(there[-1]) if there else {}
    names = names_of(there)
    if of_twin:
        element = {NAME: next((name for name in of_twin if name not in names), "")}
    elif about.table is BearingRow and (gap := _widest(there)) is not None:
        index, place = gap
        before = without(there[index - 1], *map(dotted, (BearingRow.load, BearingRow.slope)))
        element = {**before, NAME: _free("middle", names), POSITION: place}
    elif isinstance(name := element.get(NAME), str):
        element[NAME] = _free(name, names)
    return [*there[:index], element, *there[index:]], index


OWN = "own"  # beside MIRRORS and REPEATS: what a further shaft is
FACING = {"left": "right", "right": "left", "upper": "lower", "lower": "upper"}


def further_shaft(there: list[Table], name: str, what: str, taken: Collection[object] = ()) -> Table:
    """A shaft more: the mirror image of the one of that name, the same on the other side, or further out where another
    stands there, or one of its own that is like it, with no place yet.  `taken`: names that it can not have beside
    those of the shafts."""
    shaft, names = next(shaft for shaft in there if shaft.get(NAME) == name), [*names_of(there), *taken]
    if what == OWN:
        return {**without(shaft, AXIS), NAME: _free(name, names)}
    made: dict[str, Any] = {**twin(shaft, name), NAME: _free(FACING.get(name, TWIN), names)}
    if what == MIRRORS:
        return made
    start = made.get(AXIS)
    by_name = {other.get(NAME): other for other in there}
    places = [twin(by_name[other[MIRRORS]], "").get(AXIS) for other in there if other.get(MIRRORS) in by_name]
    places += [other.get(AXIS) for other in there]
    while start and made[AXIS] in places:
        up, side = made[AXIS]
        made[AXIS] = [up, side + (start[1] or up or 1.0)]
    return {**without(made, MIRRORS), REPEATS: name}


def mirror_image(place: list[Any]) -> list[Any]:
    """Of a place beside the crank, up and to the side."""
    up, side = place
    return [up, 0 - side]  # not −0.0


def ways_to_add(there: list[Table], name: str) -> dict[str, Text]:
    """What a further shaft may be beside the one of that name, in words; no second mirror image of it."""
    ways = {
        MIRRORS: Text("mirror image of {name}", name=Name(name)),
        REPEATS: Text("{name} once more, on an axis of its own", name=Name(name)),
        OWN: Text("a shaft of its own, to begin with like {name}", name=Name(name)),
    }
    return {
        what: words
        for what, words in ways.items()
        if what != MIRRORS or all(shaft.get(MIRRORS) != name for shaft in there)
    }


# what is of one wheel alone, and no further one is like
OF_ONE = (
    *(Wheel.position, Wheel.hand, Wheel.former_name, Wheel.measured_span),
    *(Wheel.measured_over_balls, Wheel.measured_over_pins, Wheel.measured_chordal_thickness),
)


def with_wheel(data: Table, name: str, of: str, carrier: str, what: str, *, meets: bool = True) -> Table:
    """The tables with what turns a twin as `carrier`, a wheel or a sprocket, turns the shaft that it is a twin of.

    A mirror image has the like wheel, in mesh with that one; where both do not meet, at the end of the like wheels as
    lead to that one, and one more.  What repeats a shaft has the like wheel on the same driver.  Where a chain alone
    turns the shaft, one more turns the twin, a mirror image by its other side."""
    wheels, meshes, stages = (list(map(dict, content_at(data, array) or [])) for array in (WHEELS, MESHES, STAGES))
    on = next((wheel for wheel in wheels if wheel.get(NAME) == carrier), None)
    way = _toothed(meshes, carrier)
    if on is not None and (way or what == MIRRORS):
        on[SITS_ON] = of
        if what == REPEATS:
            driver, further = way[-1].get(DRIVER), [(name, on, way[-1])]
        else:
            driver = carrier
            further = [(name, on, without(way[-1], dotted(Mesh.centre_distance)) if way else Table())]
            if way and not meets:
                driver, by_name = way[0].get(DRIVER), {wheel.get(NAME): wheel for wheel in wheels}
                further = [(f"{name}-idler", by_name[mesh.get(DRIVEN)], mesh) for mesh in way] + further
        for wanted, like, mesh in further:
            called = (
                wanted
                if wanted == name
                else _free(wanted, [name, *names_of(content_at(data, SHAFTS) or []), *names_of(wheels)])
            )
            wheels.append({**without(like, *map(dotted, OF_ONE), SITS_ON), NAME: called})
            if like is not on and isinstance(place := like.get(PLACE), list):
                wheels[-1][PLACE] = mirror_image(place)
            meshes.append({**mesh, DRIVER: driver, DRIVEN: called})
            driver = called
        wheels[-1][SITS_ON] = name
        return changed(changed(data, WHEELS, wheels), MESHES, meshes)
    stage = next((link for link in stages if link.get(DRIVEN) == carrier), None)
    if stage is None:
        return data
    side = dotted(Stage.side)
    like = {**stage, NAME: _free(str(stage.get(NAME)), [link.get(NAME) for link in stages]), DRIVEN: name}
    if what == MIRRORS:
        like[side] = "inner" if stage.get(side) == "outer" else "outer"
    return changed(data, STAGES, [*stages, like])


def _toothed(meshes: list[Table], end: str) -> list[Table]:
    """The meshes that lead to a wheel, from the first driver or from a chain."""
    way: list[Table] = []
    while (mesh := next((link for link in meshes if link.get(DRIVEN) == end), None)) is not None and mesh not in way:
        way, end = [mesh, *way], str(mesh.get(DRIVER))
    return way


def driver_of(data: Table, shaft: str) -> str:
    """What drives the wheel or sprocket of a shaft; empty where nothing turns it."""
    on = {wheel.get(NAME) for wheel in content_at(data, WHEELS) or [] if wheel.get(SITS_ON) == shaft} | {shaft}
    links = [*(content_at(data, MESHES) or []), *(content_at(data, STAGES) or [])]
    return next((str(link.get(DRIVER)) for link in links if link.get(DRIVEN) in on), "")


def _without_leaves(data: Table, gone: Collection[object]) -> Table:
    """Less the wheels and sprockets of shafts that are gone, and the wheels that turn these alone; what a loss names
    stays, and one mesh or stage."""
    losses = [as_table(loss) for table in as_table(data.get(FRICTION)).values() for loss in as_list(table)]
    losses += [as_table(load) for shaft in content_at(data, SHAFTS) or [] for load in as_list(shaft.get(LOADS))]
    idle = set[object]()  # wheels that drove what is taken out
    while True:
        wheels = content_at(data, WHEELS) or []
        links = [(array, link) for array in (MESHES, STAGES) for link in content_at(data, array) or []]
        carries = {wheel.get(NAME): wheel.get(SITS_ON) for wheel in wheels}
        used = {link.get(DRIVER) for _, link in links} | {loss.get(CARRIED_BY) for loss in losses}
        ends = {link.get(DRIVEN) for _, link in links} - used
        loose = {end for end in ends & idle if carries.get(end, end) is None}
        loose |= {end for end in ends if carries.get(end, end) in gone}  # a sprocket is called like its shaft
        leaf = next(((array, link) for array, link in links if link.get(DRIVEN) in loose), None)
        if leaf is None or len(links) < 2:
            return data
        array, last = leaf
        idle.add(last.get(DRIVER))
        data = changed(data, array, [link for link in content_at(data, array) if link is not last] or None)
        data = changed(data, WHEELS, [wheel for wheel in wheels if wheel.get(NAME) != last.get(DRIVEN)] or None)


def _free(name: str, names: list[object]) -> str:
    """The name, or the first with a number behind it that no element has."""
    base = name.rstrip("0123456789").rstrip("-") or name
    return (
        name
        if name not in names
        else next(free for n in range(2, len(names) + 3) if (free := f"{base}-{n}") not in names)
    )


def _widest(bearings: list[Table]) -> tuple[int, float] | None:
    """The index of a bearing in the middle of the widest gap, and its place; None where places are not known."""
    places = [place for row in bearings if isinstance(place := row.get(POSITION), (int, float))]
    if len(places) < max(2, len(bearings)):
        return None
    width, i = max((b - a, i) for i, (a, b) in enumerate(pairwise(places)))
    return i + 1, places[i] + width / 2


def less(where: Place, there: list[Table], index: int) -> list[Table]:
    """An array without one of its elements; a shaft takes its twins with it."""
    gone, left = there[index].get(NAME), [item for n, item in enumerate(there) if n != index]
    return [item for item in left if original_of(item) != gone] if described(where).table is ShaftInputs else left


def without_row(data: Table, shaft: Place, bearing: object) -> Table:
    """The tables in which no twin of a shaft says anything of a bearing that the shaft has no more."""
    of, rows = content_at(data, (*shaft, NAME)), dotted(ShaftInputs.bearings)
    for i, item in enumerate(content_at(data, SHAFTS)):
        if is_twin(item) and original_of(item) == of:
            left = [row for row in item.get(rows, []) if row.get(NAME) != bearing]
            data = changed(data, (*SHAFTS, i, rows), left or None)
    return data


def with_shafts(data: Table, shafts: list[Table], of_shaft: Collection[str]) -> Table:
    """The tables with other shafts: the wheel of one that is gone goes with it, or sits on none where it drives
    something, bolts carry none, and where one becomes several, or one of them is left, the ids of what is accepted and
    measured have that one's name or lose it.

    `of_shaft`: the ids, without that name, of what each shaft has for itself."""
    was, now = _names(data, SHAFTS), [shaft.get(NAME) for shaft in shafts]
    data = changed(data, SHAFTS, shafts or None)
    if now:
        data = _without_leaves(data, [name for name in was if name not in now])
    for i, wheel in enumerate(content_at(data, WHEELS) or []):
        if (name := wheel.get(SITS_ON)) in was and name not in now:
            data = changed(data, (*WHEELS, i, SITS_ON), None)
    for i in range(len(now)):
        held = content_at(data, (*SHAFTS, i, *CARRIES)) or []
        if (kept := [name for name in held if name in now or name not in was]) != held:
            data = changed(data, (*SHAFTS, i, *CARRIES), kept or None)
    if len(was) == 1 < len(now):
        return _with_ids(data, lambda id: _named(id, str(was[0])) if id in of_shaft else id)
    if len(now) == 1 < len(was):
        before = f"{now[0]}."
        return _with_ids(data, lambda id: id.replace(before, "", 1) if id.split(".", 1)[-1].startswith(before) else id)
    return data


def _named(id: str, name: str) -> str:
    step, _, rest = id.partition(".")
    return f"{step}.{name}.{rest}"


def followed(valid: Table, data: Table, where: Place) -> Table:
    """The tables after an element of an array was given another name: what is locked, varied or measured in it goes by
    that name, and so does what mirrors a shaft, sits on it or turns it, or is accepted of a bearing.  `valid`: the
    tables before.

    While the name is none, or that of another one, all that stays as it was."""
    if where[-1:] != (NAME,) or len(where) < 3:
        return data
    others, old_others = (_names(tables, where[:-2]) for tables in (data, valid))
    n = where[-2]
    if not isinstance(n, int) or len(others) != len(old_others) or n >= len(others):
        return data
    old, new = old_others.pop(n), others.pop(n)
    if old_others != others or new in (None, "", old, *others) or not isinstance(old, str):
        return data
    was, now = named_key(valid, where[:-1]), named_key(data, where[:-1])
    for table in ((dotted(Design.locked),), (dotted(Design.optimise), dotted(OptimiseInputs.vary))):
        if isinstance(there := content_at(data, table), dict):
            data = changed(data, table, {_renamed(key, was, now): content for key, content in there.items()})
    of_row, of_shaft = (described(where[:-2]).table is table for table in (BearingRow, ShaftInputs))
    others_too = len(content_at(data, SHAFTS) or ()) > 1
    shaft, twins = named_key(data, where[:2]).rpartition(".")[2], list[int]()
    if of_row:
        twins = [i for i, item in enumerate(content_at(data, SHAFTS)) if is_twin(item) and original_of(item) == shaft]
    named_too = "|".join(map(re.escape, [shaft, *(str(content_at(data, (*SHAFTS, i, NAME))) for i in twins)]))
    shaft = rf"(?:{named_too})\." if others_too else ""
    ids = re.compile(  # of what is judged of a bearing, and of the values of a shaft beside another
        rf"(bearings\.{shaft}|countershaft\.{shaft}(?:reaction|slope)_){re.escape(old)}(?![^._])"
        if of_row
        else rf"((?:{'|'.join(OF_SHAFT)})\.){re.escape(old)}(?=\.)"
    )

    def called(name: str) -> str:
        """A key or an id once the element is called otherwise."""
        named = of_row or (of_shaft and others_too)
        return ids.sub(rf"\g<1>{new}", name, count=1) if named and ids.match(name) else _renamed(name, was, now)

    data = _with_ids(data, called)
    for i in twins:
        rows = content_at(data, bearings := (*SHAFTS, i, dotted(ShaftInputs.bearings))) or []
        if old in [row.get(NAME) for row in rows]:
            data = changed(data, bearings, [{**row, NAME: new} if row.get(NAME) == old else row for row in rows])
    if where[:-2] == SHAFTS:
        for array, key in ((SHAFTS, MIRRORS), (SHAFTS, REPEATS), (WHEELS, SITS_ON)):
            for i, item in enumerate(content_at(data, array) or []):
                if item.get(key) == old:
                    data = changed(data, (*array, i, key), new)
        if old not in _names(data, WHEELS):  # else a sprocket turns beside the wheel of that name
            for i, stage in enumerate(content_at(data, STAGES) or []):
                for key in (DRIVER, DRIVEN):
                    if stage.get(key) == old:
                        data = changed(data, (*STAGES, i, key), new)
        for i in range(len(others) + 1):
            held = content_at(data, (*SHAFTS, i, *CARRIES)) or []
            if old in held:
                data = changed(data, (*SHAFTS, i, *CARRIES), [new if name == old else name for name in held])
    return data


def _with_ids(data: Table, called: Callable[[str], str]) -> Table:
    """The tables with what is accepted and measured by other ids."""
    if isinstance(accepted := content_at(data, (dotted(Design.accepted),)), dict):
        data = changed(data, (dotted(Design.accepted),), {called(id): reason for id, reason in accepted.items()})
    for i, row in enumerate(content_at(data, (dotted(Design.measured),)) or []):
        if isinstance(value := row.get(VALUE), str) and called(value) != value:
            data = changed(data, (dotted(Design.measured), i, VALUE), called(value))
    return data


def _names(data: Table, array: Place) -> list[object]:
    return names_of(content_at(data, array) or [])


def _renamed(key: str, was: str, now: str) -> str:
    """A key once the element that it is of, or stands in, is called otherwise."""
    return f"{now}{key.removeprefix(was)}" if f"{key}.".startswith(f"{was}.") else key
