# SPDX-License-Identifier: Apache-2.0
"""The geometry kernel (OCCT, by the extra `cad`) as far as this program needs it: edges, faces, solids, what they
weigh, and their STEP file.  Lengths in millimetres; nothing else imports the kernel.

A shape is an object of the kernel's, which only the functions here take apart."""

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from io import BytesIO
from itertools import count
from types import SimpleNamespace
from typing import Any

import numpy as np

from calc.sheet.arrays import Array
from calc.sheet.text import Text
from calc.sheet.version import VERSION

Shape = Any  # of the kernel
Edge = Any
Point = tuple[float, float, float]

MODULE = "OCP"
ASKED = ">=8.0.1,<9"
NAMES = {
    "APIHeaderSection": ("APIHeaderSection_MakeHeader",),
    "BRep": ("BRep_Builder",),
    "BRepAlgoAPI": ("BRepAlgoAPI_Cut", "BRepAlgoAPI_Fuse"),
    "BRepBuilderAPI": (
        "BRepBuilderAPI_MakeEdge", "BRepBuilderAPI_MakeFace", "BRepBuilderAPI_MakeWire", "BRepBuilderAPI_NurbsConvert",
        "BRepBuilderAPI_Transform",
    ),
    "BRepCheck": ("BRepCheck_Analyzer",),
    "BRepGProp": ("BRepGProp",),
    "BRepOffsetAPI": ("BRepOffsetAPI_ThruSections",),
    "BRepPrimAPI": ("BRepPrimAPI_MakePrism", "BRepPrimAPI_MakeRevol"),
    "GC": ("GC_MakeArcOfCircle",),
    "GProp": ("GProp_GProps",),
    "GeomAPI": ("GeomAPI_Interpolate",),
    "IFSelect": ("IFSelect_RetDone",),
    "Interface": ("Interface_Static",),
    "Message": ("Message", "Message_PrinterOStream"),
    "STEPCAFControl": ("STEPCAFControl_Writer",),
    "STEPControl": ("STEPControl_AsIs",),
    "TCollection": ("TCollection_ExtendedString", "TCollection_HAsciiString"),
    "TDataStd": ("TDataStd_Name",),
    "TDocStd": ("TDocStd_Document",),
    "TopAbs": ("TopAbs_SOLID",),
    "TopExp": ("TopExp_Explorer",),
    "TopLoc": ("TopLoc_Location",),
    "TopoDS": ("TopoDS", "TopoDS_Compound", "TopoDS_Wire"),
    "XCAFApp": ("XCAFApp_Application",),
    "XCAFDoc": ("XCAFDoc_DocumentTool",),
    "collections": ("HArray1_TCollection_HAsciiString", "HArray1_gp_Pnt"),
    "gp": ("gp_Ax1", "gp_Circ", "gp_Dir", "gp_Pnt", "gp_Trsf", "gp_Vec"),
}  # fmt: skip


class KernelFault(RuntimeError):
    """The kernel made what it should not: a fault of this program."""


class WrongKernel(Exception):
    """Another kernel is installed than this program knows."""

    def __init__(self, reason: Text) -> None:
        super().__init__(reason)
        self.reason = reason


@cache
def kernel() -> Any:
    """The names of the kernel, loaded (about a second) when the first shape is made; from then on it is silent: what it
    says else goes to the standard output.  Raises WrongKernel where the one installed has other names."""
    from importlib import import_module

    found = SimpleNamespace()
    for module, names in NAMES.items():
        try:
            part = import_module(f"{MODULE}.{module}")
            for name in names:
                setattr(found, name, getattr(part, name))
        except (ImportError, AttributeError) as error:
            there = getattr(import_module(MODULE), "__version__", "unknown")
            raise WrongKernel(
                Text(
                    "the geometry kernel that is installed, {there}, is not {asked} ({module}: {error}); cadquery "
                    "brings another one and can't live beside it: take an environment of its own",
                    there=there,
                    asked=ASKED,
                    module=module,
                    error=str(error),
                )
            ) from error
    messenger = found.Message.DefaultMessenger_s()
    messenger.RemovePrinters(found.Message_PrinterOStream.get_type_descriptor_s())
    return found


# --- edges, faces, solids


def line(start: Point, end: Point) -> Edge:
    k = kernel()
    return k.BRepBuilderAPI_MakeEdge(k.gp_Pnt(*start), k.gp_Pnt(*end)).Edge()


def arc(start: Point, through: Point, end: Point) -> Edge:
    """Of the circle through three points."""
    k = kernel()
    circle = k.GC_MakeArcOfCircle(*(k.gp_Pnt(*point) for point in (start, through, end)))
    return k.BRepBuilderAPI_MakeEdge(circle.Value()).Edge()


def spline(points: Sequence[Point]) -> Edge:
    """The smooth curve through points, in their order."""
    k = kernel()
    row = k.HArray1_gp_Pnt(1, len(points))
    for n, point in enumerate(points, 1):
        row.SetValue(n, k.gp_Pnt(*point))
    curve = k.GeomAPI_Interpolate(row, False, 1e-9)
    curve.Perform()
    return k.BRepBuilderAPI_MakeEdge(curve.Curve()).Edge()


def wire(edges: Sequence[Edge]) -> Shape:
    """Edges, or wires, that follow one another, joined."""
    k = kernel()
    joined = k.BRepBuilderAPI_MakeWire()
    for edge in edges:
        joined.Add(edge)
    return joined.Wire()


def polygon(points: Sequence[Point]) -> list[Edge]:
    """The edges of a closed polygon."""
    return [line(start, end) for start, end in zip(points, (*points[1:], points[0]))]


def face(edges: Sequence[Edge]) -> Shape:
    """What a closed outline in a plane encloses."""
    return face_of(wire(edges))


def face_of(outline: Shape) -> Shape:
    """The same of one that is joined already."""
    return kernel().BRepBuilderAPI_MakeFace(outline, True).Face()


def prism(section: Shape, length: float) -> Shape:
    """A face drawn along Z."""
    k = kernel()
    return k.BRepPrimAPI_MakePrism(section, k.gp_Vec(0.0, 0.0, length)).Shape()


def revolved(section: Shape) -> Shape:
    """A face in a plane through the Z axis, turned about it."""
    k = kernel()
    return k.BRepPrimAPI_MakeRevol(section, k.gp_Ax1(k.gp_Pnt(0.0, 0.0, 0.0), k.gp_Dir(0.0, 0.0, 1.0))).Shape()


def lofted(wires: Sequence[Shape]) -> Shape:
    """A solid through closed outlines of the same edges, smooth along its length."""
    k = kernel()
    through = k.BRepOffsetAPI_ThruSections(True, False)
    through.CheckCompatibility(False)
    for outline in wires:
        through.AddWire(outline)
    through.Build()
    return through.Shape()


def fused(first: Shape, *others: Shape) -> Shape:
    k = kernel()
    for other in others:
        first = _done(k.BRepAlgoAPI_Fuse(first, other), "fuse")
    return first


def cut(solid: Shape, *tools: Shape) -> Shape:
    """What the tools leave of a solid."""
    k = kernel()
    for tool in tools:
        solid = _done(k.BRepAlgoAPI_Cut(solid, tool), "cut")
    return solid


def _done(operation: Any, what: str) -> Shape:
    if not operation.IsDone():
        raise KernelFault(f"the geometry kernel could not {what} two solids")
    return operation.Shape()


def compound(shapes: Sequence[Shape]) -> Shape:
    """Shapes as one, not joined."""
    k = kernel()
    builder, whole = k.BRep_Builder(), k.TopoDS_Compound()
    builder.MakeCompound(whole)
    for shape in shapes:
        builder.Add(whole, shape)
    return whole


def solids(shape: Shape) -> list[Shape]:
    """The single bodies of a shape."""
    k = kernel()
    explorer, bodies = k.TopExp_Explorer(shape, k.TopAbs_SOLID), []
    while explorer.More():
        bodies.append(explorer.Current())
        explorer.Next()
    return bodies


def moved(shape: Shape, by: Point = (0.0, 0.0, 0.0), turned: float = 0.0) -> Shape:
    """A shape turned about the Z axis (radians), then moved; its geometry is made anew."""
    k = kernel()
    made = k.BRepBuilderAPI_Transform(shape, _motion(by, turned), True).Shape()
    return k.TopoDS.Wire(made) if isinstance(shape, k.TopoDS_Wire) else made


def along(shape: Shape, start: Point, axis: Point) -> Shape:
    """A shape that was made along Z from the origin, set on a point and along another axis."""
    k = kernel()
    onto = k.gp_Vec(*axis)
    motion, turn, shift = k.gp_Trsf(), k.gp_Trsf(), k.gp_Trsf()
    across = k.gp_Vec(0.0, 0.0, 1.0).Crossed(onto)
    if across.Magnitude() > 1e-12:
        line_of_turn = k.gp_Ax1(k.gp_Pnt(0.0, 0.0, 0.0), k.gp_Dir(across))
        turn.SetRotation(line_of_turn, k.gp_Vec(0.0, 0.0, 1.0).Angle(onto))
    shift.SetTranslation(k.gp_Vec(*start))
    motion.Multiply(shift)
    motion.Multiply(turn)
    return k.BRepBuilderAPI_Transform(shape, motion, True).Shape()


def _motion(by: Point, turned: float) -> Any:
    k = kernel()
    turn, shift = k.gp_Trsf(), k.gp_Trsf()
    if turned:
        turn.SetRotation(k.gp_Ax1(k.gp_Pnt(0.0, 0.0, 0.0), k.gp_Dir(0.0, 0.0, 1.0)), turned)
    shift.SetTranslation(k.gp_Vec(*by))
    return shift.Multiplied(turn)


# --- what a solid is


@dataclass(frozen=True)
class SolidProperties:
    """Volume in mm³, centre in mm, tensor of inertia about it of unit density in mm⁵, with −∫ab dV off its diagonal."""

    volume: float
    centre: Array
    tensor: Array


CLOSE = 1e-9


def properties(shape: Shape, splines: bool = False, close: float = CLOSE) -> SolidProperties:
    """`splines`: whether it has surfaces or edges that are no planes, cylinders and cones, straight lines and circles.
    The kernel's plain integration is exact without, and wrong by 1e-5 with them; its adaptive one (to
    `close`) watches the volume alone, and at 1e-9 moments are off by 6e-8 on a cylinder."""
    k = kernel()
    found = k.GProp_GProps()
    k.BRepGProp.VolumeProperties_s(shape, found, *((close, False, False) if splines else ()))
    centre, matrix = found.CentreOfMass(), found.MatrixOfInertia()
    tensor = np.array([[matrix.Value(i, j) for j in (1, 2, 3)] for i in (1, 2, 3)])
    return SolidProperties(found.Mass(), np.array([centre.X(), centre.Y(), centre.Z()]), tensor)


def in_splines(shape: Shape) -> Shape:
    """The same shape with its surfaces as splines, for `properties` to integrate: on a surface that is a spline drawn
    along a line the adaptive integration is wrong by 1e-4 however close it is asked to be, on this one it is not."""
    return kernel().BRepBuilderAPI_NurbsConvert(shape).Shape()


def demand_valid(shape: Shape, name: str, bodies: int | None = None) -> None:
    """Raises KernelFault where a shape is none that other programs would take; `bodies`: how many it is to have."""
    if not kernel().BRepCheck_Analyzer(shape).IsValid():
        raise KernelFault(f"the solid of {name} is not valid")
    if (found := len(solids(shape))) == 0 or (bodies is not None and found != bodies):
        raise KernelFault(f"the solid of {name} has {found} bodies")


# --- the file

USED = re.compile(r"(NEXT_ASSEMBLY_USAGE_OCCURRENCE\(')\d+'")
WORDS = re.compile("'[^']*'")
OTHER_LETTERS = re.compile(r"[^\x00-\x7f]+")


@dataclass(frozen=True)
class StepPart:
    """A part of a file: its solids, each with its name, and where its origin stands, turned about Z (radians)."""

    name: str
    bodies: tuple[tuple[str, Shape], ...]
    place: Point = (0.0, 0.0, 0.0)
    turned: float = 0.0


def step_file(parts: Sequence[StepPart], file: str, date: str, words: Sequence[str], assembly: str = "") -> bytes:
    """The STEP file of parts, of AP214 in millimetres.  `file`: its name, without the folder; `date`: YYYY-MM-DD;
    `words`: what its header says; `assembly`: the name of what holds several parts, each where it stands."""
    k = kernel()
    document = k.TDocStd_Document(_wide("XmlOcaf"))
    k.XCAFApp_Application.GetApplication_s().InitDocument(document)
    tool = k.XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    whole = tool.NewShape() if assembly else None
    for part in parts:
        label = _labelled(tool, part)
        if whole is not None:
            place = k.TopLoc_Location(_motion(part.place, part.turned))
            k.TDataStd_Name.Set_s(tool.AddComponent(whole, label, place), _wide(part.name))
    if whole is not None:
        k.TDataStd_Name.Set_s(whole, _wide(assembly))
        tool.UpdateAssemblies()
    with _settings({"write.step.schema": "AP214IS", "write.step.unit": "MM"}, {"write.stepcaf.subshapes.name": 1}):
        writer = k.STEPCAFControl_Writer()
        if not writer.Transfer(document, k.STEPControl_AsIs):
            raise KernelFault(f"the geometry kernel could not write {file}")
        _head(writer, file, date, words)
        stream = BytesIO()
        if writer.WriteStream(stream) != k.IFSelect_RetDone:
            raise KernelFault(f"the geometry kernel could not write {file}")
    return _plain(stream.getvalue())


def _plain(content: bytes) -> bytes:
    """A file as the standard has it, the same each time: the kernel counts the parts of all assemblies that it ever
    wrote, breaks the lines of long texts, and leaves letters beyond ASCII as they are."""
    counts = count(1)
    text = USED.sub(lambda found: f"{found[1]}{next(counts)}'", content.decode())
    text = WORDS.sub(lambda found: found[0].replace("\n", ""), text)
    return OTHER_LETTERS.sub(_escaped, text).encode("ascii")


def _escaped(found: re.Match[str]) -> str:
    letters = found[0].encode("utf-32-be").hex().upper()
    return f"\\X4\\{letters}\\X0\\"


def _labelled(tool: Any, part: StepPart) -> Any:
    """The label of a part, and of each of its solids where it has several."""
    k = kernel()
    single = [solid for _, body in part.bodies for solid in solids(body)]
    alone = len(single) == 1
    shape = single[0] if alone else compound(single)
    label = tool.AddShape(shape, False)
    k.TDataStd_Name.Set_s(label, _wide(part.name))
    if not alone:
        for name, body in part.bodies:
            for solid in solids(body):
                k.TDataStd_Name.Set_s(tool.AddSubShape(label, solid), _wide(name))
    return label


def _head(writer: Any, file: str, date: str, words: Sequence[str]) -> None:
    """The header: nothing of it is of the machine or the hour."""
    k = kernel()
    text = k.TCollection_HAsciiString
    head = k.APIHeaderSection_MakeHeader(writer.ChangeWriter().Model())
    head.SetName(text(file))
    head.SetTimeStamp(text(f"{date}T00:00:00"))
    head.SetAuthorValue(1, text(""))
    head.SetOrganizationValue(1, text(""))
    head.SetOriginatingSystem(text(f"contralbero {VERSION}"))
    head.SetPreprocessorVersion(text(f"contralbero {VERSION}"))
    head.SetAuthorisation(text(""))
    row = k.HArray1_TCollection_HAsciiString(1, len(words))
    for n, sentence in enumerate(words, 1):
        row.SetValue(n, text(sentence))
    head.SetDescription(row)


def _wide(words: str) -> Any:
    return kernel().TCollection_ExtendedString(words, True)


@contextmanager
def _settings(words: dict[str, str], numbers: dict[str, int]) -> Iterator[None]:
    """The kernel's settings of a file, which are those of the whole process, for as long as one is written."""
    static = kernel().Interface_Static
    before = {key: static.CVal_s(key) for key in words}, {key: static.IVal_s(key) for key in numbers}
    try:
        for key, word in words.items():
            static.SetCVal_s(key, word)
        for key, number in numbers.items():
            static.SetIVal_s(key, number)
        yield
    finally:
        for key, word in before[0].items():
            static.SetCVal_s(key, word)
        for key, number in before[1].items():
            static.SetIVal_s(key, number)
