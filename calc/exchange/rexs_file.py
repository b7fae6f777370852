# SPDX-License-Identifier: Apache-2.0
"""A file of REXS, FVA's exchange format for gear units: components with attributes, and relations between them.

A model takes numbers in SI; the table `library/tables/rexs_1_7.toml` says in which unit, of which kind and in which
range each attribute stands in the file, and which relations there are.  The bytes are held against that table once
more before they leave: what it does not know is a fault of the program."""

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from math import isfinite
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from ..library.table_file import TableRow, house_table
from ..sheet.record import record
from ..sheet.version import VERSION
from ..sheet.visible import visible
from .frame import number

FILE = "rexs_1_7.toml"
DECLARATION = b'<?xml version="1.0" encoding="UTF-8"?>\n'
NUMBER = re.compile(r"-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?\Z")
INTEGER = re.compile(r"-?[0-9]+\Z")
ALONG = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)  # u and w axes of every component: all shafts are parallel
MILLIMETRE = 1e-3
GEAR_UNIT = 1  # the first component, from which all places are reckoned
Place = tuple[float, float, float]  # u, v, w from the gear unit's origin, m
Content = float | bool | str | tuple[float, ...]


class FaultyFile(AssertionError):
    """What is about to be written is no file of REXS: a fault of the program."""


@record
class Component:
    """`attributes`: by their names, numbers in SI."""

    number: int
    kind: str
    name: str
    attributes: Mapping[str, Content]


@record
class Relation:
    """`parts`: the component in each role."""

    kind: str
    parts: Mapping[str, Component]


class RexsModel:
    """Components and relations, numbered in the order in which they come."""

    def __init__(self) -> None:
        self.components: list[Component] = []
        self.relations: list[Relation] = []

    def add(self, kind: str, name: str, /, **attributes: Content | None) -> Component:
        """A component; an attribute of which nothing, or no finite number, is known is left out."""
        given = {id: content for id, content in attributes.items() if content is not None and _known(content)}
        component = Component(len(self.components) + 1, kind, name, given)
        self.components.append(component)
        return component

    def relate(self, kind: str, **parts: Component) -> None:
        self.relations.append(Relation(kind, parts))

    def of_kind(self, kind: str) -> list[Component]:
        return [component for component in self.components if component.kind == kind]


def _known(content: Content) -> bool:
    if isinstance(content, str):
        return bool(content)
    return all(map(isfinite, content if isinstance(content, tuple) else (content,)))


def pose(at: Place) -> dict[str, Content]:
    """Where a component stands in the gear unit; its axes are those of the gear unit."""
    u, w = (tuple(x * MILLIMETRE for x in axis) for axis in ALONG)  # unit vectors are 1 mm long
    places = {"support_vector": at, "u_axis_vector": u, "w_axis_vector": w}
    return {"reference_component_for_position": GEAR_UNIT, **places}


# --- written


def file_of(model: RexsModel, date: str, notes: Iterable[str] = ()) -> bytes:
    """The bytes of the file.  `date`: as ISO 8601 has it; `notes`: what is said of it, as a comment at its head, which
    no reader takes for data.  Raises FaultyFile."""
    head = {"version": _table()["version"], "applicationId": "contralbero", "applicationVersion": VERSION}
    root = Element("model", head | {"date": date, "applicationLanguage": "en"})
    relations, components = SubElement(root, "relations"), SubElement(root, "components")
    for n, relation in enumerate(model.relations, 1):
        inside = SubElement(relations, "relation", id=str(n), type=relation.kind)
        for role, part in relation.parts.items():
            SubElement(inside, "ref", id=str(part.number), role=role, hint=part.kind)
    for component in model.components:
        name = visible(component.name)
        inside = SubElement(components, "component", id=str(component.number), type=component.kind, name=name)
        for id, content in component.attributes.items():
            _attribute(inside, id, content)
    ElementTree.indent(root, " ")
    said = "".join(f" {visible(note)}\n" for note in notes).replace("--", 2 * "\N{NON-BREAKING HYPHEN}")
    comment = f"<!--\n{said}-->\n" if said else ""
    written = DECLARATION + f"{comment}{ElementTree.tostring(root, encoding='unicode')}\n".encode()
    if found := list(faults(written)):
        raise FaultyFile("; ".join(found))
    return written


def _attribute(component: Element, id: str, content: Content) -> None:
    about = _attributes().get(id)
    if about is None:
        raise FaultyFile(f"{id} is no attribute that is known")
    unit = about.get("unit", "none")
    attribute = SubElement(component, "attribute", id=id, unit=unit)
    if isinstance(content, tuple):
        array = SubElement(attribute, "array")
        for x in content:
            SubElement(array, "c").text = number(x / _table()["units"][unit])
    elif isinstance(content, bool):
        attribute.text = "true" if content else "false"
    elif isinstance(content, str):
        attribute.text = visible(content)
    elif about["kind"] in ("integer", "component"):
        attribute.text = str(int(content))
    else:
        attribute.text = number(content / _table()["units"][unit])


# --- held against the table


def faults(file: bytes) -> Iterator[str]:
    """What in a file is not as the table has it, component by component."""
    root = ElementTree.fromstring(file)
    if root.get("version") != _table()["version"]:
        yield f"version {root.get('version')}"
    kinds: dict[str, str] = {}
    for component in root.iterfind("components/component"):
        id, kind = component.get("id", ""), component.get("type", "")
        where = f"component {id}, {kind}"
        if id in kinds:
            yield f"{where}: its id stands twice"
        kinds[id] = kind
        if (about := _table()["components"].get(kind)) is None:
            yield f"{where}: no component that is known"
        else:
            yield from (f"{where}: {fault}" for fault in _of_component(component, about))
    for component in root.iterfind("components/component"):
        for attribute in component.iterfind("attribute"):
            about = _attributes().get(attribute.get("id", ""))
            if about is not None and about["kind"] == "component" and attribute.text not in kinds:
                yield f"component {component.get('id')}: there is no component {attribute.text}"
    ids = set[str]()
    for relation in root.iterfind("relations/relation"):
        id = relation.get("id", "")
        if id in ids:
            yield f"relation {id}: its id stands twice"
        ids.add(id)
        yield from (f"relation {id}: {fault}" for fault in _of_relation(relation, kinds))


def _of_component(component: Element, about: TableRow) -> Iterator[str]:
    pose_ids: list[str] = _table()["pose"] if about["pose"] else []
    ids = [attribute.get("id", "") for attribute in component.iterfind("attribute")]
    for missing in (id for id in pose_ids if id not in ids):
        yield f"{missing} is missing"
    for id in {id for id in ids if ids.count(id) > 1}:
        yield f"{id} stands twice"
    for attribute, id in zip(component.iterfind("attribute"), ids):
        if id not in pose_ids and id not in about["attributes"]:
            yield f"{id} is none of its attributes"
            continue
        row = _attributes()[id]
        if (unit := attribute.get("unit")) != row.get("unit", "none"):
            yield f"{id}: the unit is {row.get('unit', 'none')}, not {unit}"
        if row["kind"] == "vector":
            texts = [part.text or "" for part in attribute.iterfind("array/c")]
            if len(texts) != 3:
                yield f"{id}: {len(texts)} numbers, not 3"
        else:
            texts = [attribute.text or ""]
        yield from (f"{id}: {text!r} {wrong}" for text in texts if (wrong := _wrong(text, row)))


def _wrong(text: str, row: Mapping[str, Any]) -> str:
    """What is wrong with what stands in an attribute; empty: nothing."""
    kind = row["kind"]
    if kind == "text":
        return "is none of its words" if not text or text not in row.get("words", (text,)) else ""
    if kind == "boolean":
        return "" if text in ("true", "false") else "is neither true nor false"
    if not (INTEGER if kind in ("integer", "component") else NUMBER).match(text):
        return "is no number" if kind in ("number", "vector") else "is no whole number"
    x = float(text)
    inside = x > row.get("above", -1e300) and x >= row.get("from", x) and x < row.get("below", 1e300)
    return "" if inside else "is out of its range"


def _of_relation(relation: Element, kinds: Mapping[str, str]) -> Iterator[str]:
    parts = {}
    for ref in relation.iterfind("ref"):
        role, kind = ref.get("role", ""), kinds.get(ref.get("id", ""))
        if kind is None:
            yield f"there is no component {ref.get('id')}"
        elif kind != ref.get("hint"):
            yield f"{ref.get('id')} is a {kind}, not a {ref.get('hint')}"
        if role in parts:
            yield f"the role {role} stands twice"
        parts[role] = kind
    if (relation.get("type"), frozenset(parts.items())) not in _relations():
        yield f"there is none of type {relation.get('type')} between " + ", ".join(f"{r} {k}" for r, k in parts.items())


def _table() -> TableRow:
    return house_table(FILE)


def _attributes() -> Mapping[str, TableRow]:
    rows: TableRow = _table()["attributes"]
    return rows


@cache
def _relations() -> frozenset[tuple[str, frozenset[tuple[str, str]]]]:
    return frozenset((row["type"], frozenset(row["roles"].items())) for row in _table()["relations"])
