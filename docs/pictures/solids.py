# SPDX-License-Identifier: Apache-2.0
"""A picture of solids from their STEP file: read and cut into triangles by the geometry kernel (extra `cad`), and drawn
point by point, the nearest in front."""

from pathlib import Path

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_FACE, TopAbs_REVERSED, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS

CHORD, ANGLE = 0.06, 0.3  # mm and radians: of the triangles to the surface
FINER = 2  # points a pixel each way, of which a pixel is the mean
CLOSER = 0.45  # of such a point: how far apart a triangle is sampled
LONGEST = 12.0  # side of a triangle in such points
PAPER = np.array([1.0, 1.0, 1.0])
INK = np.array([0.13, 0.15, 0.19])
LIGHT, GLANCE, SHADE = np.array([-0.5, 0.6, 0.62]), 0.25, 0.42


def triangles(step: Path) -> list[tuple[np.ndarray, np.ndarray]]:
    """Of each solid of a file: corners (n, 3, 3) in mm, and the normals of the surface there."""
    reader = STEPControl_Reader()
    reader.ReadFile(str(step))
    reader.TransferRoots()
    whole = reader.OneShape()
    BRepMesh_IncrementalMesh(whole, CHORD, False, ANGLE, True)
    return [_of_solid(solid) for solid in _parts(whole, TopAbs_SOLID)]


def _parts(shape, kind):
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def _of_solid(solid) -> tuple[np.ndarray, np.ndarray]:
    corners, normals = [], []
    for face in _parts(solid, TopAbs_FACE):
        at = TopLoc_Location()
        mesh = BRep_Tool.Triangulation_s(TopoDS.Face(face), at)
        if mesh is None:
            continue
        move = at.Transformation()
        nodes = [mesh.Node(i).Transformed(move) for i in range(1, mesh.NbNodes() + 1)]
        points = np.array([(p.X(), p.Y(), p.Z()) for p in nodes])
        index = np.array([mesh.Triangle(i).Get() for i in range(1, mesh.NbTriangles() + 1)]) - 1
        if face.Orientation() == TopAbs_REVERSED:
            index = index[:, ::-1]
        flat = np.cross(points[index[:, 1]] - points[index[:, 0]], points[index[:, 2]] - points[index[:, 0]])
        smooth = np.zeros_like(points)
        for corner in range(3):  # of a face alone: between faces it stays an edge
            np.add.at(smooth, index[:, corner], flat)
        smooth /= np.linalg.norm(smooth, axis=1, keepdims=True) + 1e-30
        corners.append(points[index])
        normals.append(smooth[index])
    return np.concatenate(corners), np.concatenate(normals)


def drawn(
    parts: list[tuple[np.ndarray, np.ndarray]], colours: list[str], view: tuple[np.ndarray, np.ndarray], width: int
) -> np.ndarray:
    """Pixels (rows, columns, RGB) from 0 to 1.  `view`: unit vectors to the viewer, and up on the picture."""
    toward, up = view
    right = np.cross(up, toward)
    axes = np.stack([right, up, toward])
    every = np.concatenate([corners.reshape(-1, 3) for corners, _ in parts]) @ axes.T
    low, high = every.min(axis=0), every.max(axis=0)
    margin = 0.03 * (high[0] - low[0])
    scale = width * FINER / (high[0] - low[0] + 2 * margin)
    rows = round((high[1] - low[1] + 2 * margin) * scale / FINER) * FINER
    depth = np.full((rows, width * FINER), -np.inf)
    normal, part = np.zeros((*depth.shape, 3)), np.full(depth.shape, -1)
    for n, (corners, normals) in enumerate(parts):
        seen = (corners @ axes.T - [low[0] - margin, low[1] - margin, 0.0]) * [scale, scale, 1.0]
        _cast(*_halved(seen, normals @ axes.T), n, depth, normal, part)
    return _shaded(depth, normal, part, colours, 1 / scale)[::-1]


def _halved(seen, normals):
    """Triangles of which no side is longer than LONGEST points: a narrow one takes no more of them than it covers."""
    while True:
        sides = np.linalg.norm((seen[:, [1, 2, 0]] - seen)[:, :, :2], axis=2)
        longest = sides.argmax(axis=1)
        large = sides.max(axis=1) > LONGEST
        if not large.any():
            return seen, normals
        which, first = np.flatnonzero(large), longest[large]
        second, third = (first + 1) % 3, (first + 2) % 3
        made = []
        for of in (seen, normals):
            a, b, c = of[which, first], of[which, second], of[which, third]
            m = (a + b) / 2
            made.append(np.concatenate([of[~large], np.stack([a, m, c], axis=1), np.stack([m, b, c], axis=1)]))
        seen, normals = made


def _cast(seen, normals, n, depth, normal, part) -> None:
    """The points of the triangles of a part, where they are the nearest."""
    ways = seen[:, [1, 2, 0], :2] - seen[:, :, :2]
    sides = np.ceil(np.linalg.norm(ways, axis=2).max(axis=1) / CLOSER).astype(int) + 1
    for count in np.unique(sides):
        mine = np.flatnonzero(sides == count)
        i, j = np.meshgrid(np.arange(count + 1), np.arange(count + 1))
        inside = i + j <= count
        weights = np.stack([i[inside], j[inside], count - i[inside] - j[inside]], axis=1) / count
        for some in np.array_split(mine, max(1, len(mine) * len(weights) // 2_000_000)):
            points = np.einsum("wc,tck->twk", weights, seen[some]).reshape(-1, 3)
            turned = np.einsum("wc,tck->twk", weights, normals[some]).reshape(-1, 3)
            column, row = points[:, 0].astype(int), points[:, 1].astype(int)
            order = np.argsort(points[:, 2], kind="stable")  # of those on one pixel the nearest is the last to be set
            column, row, z = column[order], row[order], points[order, 2]
            front = z > depth[row, column]
            column, row, order, z = column[front], row[front], order[front], z[front]
            depth[row, column], part[row, column], normal[row, column] = z, n, turned[order]


def _shaded(depth, normal, part, colours, pixel) -> np.ndarray:
    normal = normal / (np.linalg.norm(normal, axis=2, keepdims=True) + 1e-30)
    light = LIGHT / np.linalg.norm(LIGHT)
    half = light + np.array([0.0, 0.0, 1.0])
    half /= np.linalg.norm(half)
    lit = np.clip(normal @ light, 0.0, 1.0)
    glance = np.clip(normal @ half, 0.0, 1.0) ** 40
    tints = np.array([[int(c[k : k + 2], 16) / 255 for k in (1, 3, 5)] for c in colours])
    body = tints[np.clip(part, 0, None)]
    picture = body * (SHADE + (1 - SHADE) * lit)[..., None] + GLANCE * glance[..., None]
    picture[part < 0] = PAPER
    line = _lines(depth, normal, part, pixel)
    picture = picture * (1 - line[..., None]) + INK * line[..., None]
    rows, columns = picture.shape[0] // FINER, picture.shape[1] // FINER
    return np.clip(picture, 0, 1).reshape(rows, FINER, columns, FINER, 3).mean(axis=(1, 3))


def _lines(depth, normal, part, pixel) -> np.ndarray:
    """Where an outline or an edge is to be seen: beside another part, behind a step in depth, at a crease."""
    line, far = np.zeros(depth.shape), np.where(np.isfinite(depth), depth, -1e6)
    for low, high in (
        ((slice(None, -1), slice(None)), (slice(1, None), slice(None))),
        ((slice(None), slice(None, -1)), (slice(None), slice(1, None))),
    ):
        other = part[low] != part[high]
        step = np.abs(far[low] - far[high]) > max(12 * pixel, 1.0)
        crease = (1 - np.sum(normal[low] * normal[high], axis=2) > 0.12) & (part[low] >= 0)
        here = np.where(other | step, 0.9, np.where(crease, 0.45, 0.0))
        for place in (low, high):
            line[place] = np.maximum(line[place], here)
    return line
