# SPDX-License-Identifier: Apache-2.0
"""Solids out of the text of a STEP file (ISO 10303-21), without the kernel that wrote it: faces that are planes or
cylinders, edges that are lines or circles, and what the bodies weigh by Gauss' theorem and Green's.

A body's integral of a homogeneous f of degree k is ∮ f·(r·n) dA/(3 + k); that of a face is one along its edges, which
the orientation of the face does not change: it turns its normal and its loops both."""

import re
from dataclasses import dataclass

import numpy as np

TOKEN = re.compile(
    r"\s*(?:(#\d+)|('(?:[^']|'')*')|(\.[A-Z0-9_]+\.)|(-?\d+\.?\d*(?:E[-+]?\d+)?)|([A-Z_0-9]+)|([(),$*]))"
)
X, WEIGHTS = np.polynomial.legendre.leggauss(40)
POWERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (2, 0, 0), (0, 2, 0), (0, 0, 2), (1, 1, 0), (0, 1, 1), (1, 0, 1)]


@dataclass(frozen=True)
class Ref:
    number: str


def entities(text):
    """What stands behind each number: (type, arguments), of several types at once a list of them."""
    data = text[text.index("DATA;") + 5 : text.rindex("ENDSEC;")]
    found = {}
    for number, body in re.findall(r"(#\d+)\s*=\s*((?:[^;']|'(?:[^']|'')*')*);", data):
        tokens = [token.groups() for token in TOKEN.finditer(body)]
        parsed, _ = _list([*tokens, (None,) * 5 + (")",)], 0)
        found[number] = parsed
    return found


def _list(tokens, here):
    row = []
    while here < len(tokens):
        reference, string, word, number, kind, sign = tokens[here]
        here += 1
        if sign == ")":
            break
        if sign == "(":
            part, here = _list(tokens, here)
            row.append(part)
        elif sign == ",":
            continue
        elif kind:
            arguments, here = _list(tokens, here + 1)
            row.append((kind, arguments))
        else:
            row.append(
                Ref(reference) if reference else string[1:-1] if string else float(number) if number else word or sign
            )
    return row, here


class File:
    """The bodies of a file by their names, and what they weigh at unit density."""

    def __init__(self, content):
        self.text = content.decode("ascii")
        self.known = entities(self.text)

    def of(self, what):
        ((kind, arguments),) = self.known[what.number]
        return kind, arguments

    def named(self, wanted):
        """The arguments of all of a type."""
        return [row[0][1] for row in self.known.values() if row and row[0][:1] == (wanted,)]

    def bodies(self):
        """Of each: its name, and the sums of its faces."""
        return [(name, self.integrals(shell)) for name, shell in self.named("MANIFOLD_SOLID_BREP")]

    def integrals(self, shell):
        kind, (_, faces) = self.of(shell)
        assert kind == "CLOSED_SHELL", kind
        sums = sum(self.face(face) for face in faces)
        return sums / (3 + np.sum(POWERS, axis=1))

    def face(self, face):
        kind, (_, bounds, surface, _) = self.of(face)
        assert kind == "ADVANCED_FACE", kind
        kind, arguments = self.of(surface)
        place = self.place(arguments[1])
        if kind == "PLANE":
            along = lambda edge: self.on_plane(place, *edge)  # noqa: E731
        elif kind == "CYLINDRICAL_SURFACE":
            along = lambda edge: self.on_cylinder(place, arguments[2], *edge)  # noqa: E731
        else:
            raise AssertionError(kind)
        return sum(sign * along(edge) for bound in bounds for sign, edge in self.edges(bound))

    def edges(self, bound):
        """The edges of a loop: in which sense it runs along each, and the points of each with their rates."""
        _, (_, loop, same) = self.of(bound)
        _, (_, oriented) = self.of(loop)
        for one in oriented:
            _, (_, _, _, edge, forward) = self.of(one)
            _, (_, start, end, curve, sense) = self.of(edge)
            sign = (1 if same == ".T." else -1) * (1 if forward == ".T." else -1)
            yield sign, self.points(start, end, curve, sense == ".T.")

    def points(self, start, end, curve, forward):
        """Points along an edge, and the way to the next by Gauss' weights."""
        kind, arguments = self.of(curve)
        if kind in ("SURFACE_CURVE", "SEAM_CURVE"):
            kind, arguments = self.of(arguments[1])
        a, b = (self.point(self.of(vertex)[1][1]) for vertex in (start, end))
        if kind == "LINE":
            return a + np.outer((1 + X) / 2, b - a), np.outer(WEIGHTS / 2, b - a)
        assert kind == "CIRCLE", kind
        (centre, u, v, _), radius = self.place(arguments[1]), arguments[2]
        first, last = (np.arctan2((p - centre) @ v, (p - centre) @ u) for p in (a, b))
        turn = (last - first) % (2 * np.pi) if forward else -((first - last) % (2 * np.pi))
        if start == end or abs(turn) < 1e-9:
            turn = 2 * np.pi if forward else -2 * np.pi
        t = first + turn * (1 + X) / 2
        around = np.outer(np.cos(t), u) + np.outer(np.sin(t), v)
        ahead = np.outer(-np.sin(t), u) + np.outer(np.cos(t), v)
        return centre + radius * around, radius * ahead * (turn * WEIGHTS / 2)[:, None]

    def place(self, what):
        """Origin and axes of a placement."""
        _, (_, origin, axis, across) = self.of(what)
        w = self.point(axis)
        u = self.point(across)
        u = u - (u @ w) * w
        u = u / np.linalg.norm(u)
        return self.point(origin), u, np.cross(w, u), w

    def point(self, what):
        return np.array(self.of(what)[1][1])

    def on_plane(self, place, points, steps):
        """−∮ (∫ f·(r·n) dv) du, with u and v in the plane."""
        origin, u, v, w = place
        high = (points - origin) @ v
        inner = points[:, None, :] - np.multiply.outer(np.outer(high, (1 - X) / 2), v)
        weights = -np.outer(high * (steps @ u), WEIGHTS / 2)
        return self.summed(inner, weights * (inner @ w))

    def on_cylinder(self, place, radius, points, steps):
        """−∮ (∫ f·(r·n) R dh) dθ, with h along the axis and θ about it."""
        origin, _, _, w = place
        away = points - origin
        high = away @ w
        normal = (away - np.outer(high, w)) / radius
        turn = np.einsum("ij,ij->i", steps, np.cross(w, normal)) / radius
        inner = points[:, None, :] - np.multiply.outer(np.outer(high, (1 - X) / 2), w)
        weights = -np.outer(high * turn * radius, WEIGHTS / 2)
        return self.summed(inner, weights * np.einsum("ijk,ik->ij", inner, normal))

    @staticmethod
    def summed(points, weights):
        return np.array([np.sum(weights * np.prod(points**power, axis=-1)) for power in POWERS])


def weighed(sums):
    """Mass, centre and tensor about it (−∫ab dm) from the sums of bodies, each times its density."""
    mass, centre = sums[0], sums[1:4] / sums[0]
    xx, yy, zz, xy, yz, zx = sums[4:]
    origin = np.array([[yy + zz, -xy, -zx], [-xy, zz + xx, -yz], [-zx, -yz, xx + yy]])
    return mass, centre, origin - mass * (centre @ centre * np.eye(3) - np.outer(centre, centre))
