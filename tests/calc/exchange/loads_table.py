"""The table of loads as somebody else reads it: from its text alone."""

import cmath
import csv
import math
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Row:
    speed: float  # rpm
    kind: str
    place: str
    on: str
    order: float
    at: np.ndarray  # m; an empty cell is not a number
    force: np.ndarray  # N, complex
    moment: np.ndarray  # N·m

    @property
    def key(self):
        return self.speed, self.kind, self.place, self.on, self.order

    def moment_about_origin(self):
        return self.moment + np.cross(np.nan_to_num(self.at), self.force)


def read(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return [_row(cells) for cells in csv.DictReader(lines)]


def _row(cells):
    def vector(letter, unit):
        return np.array([_phasor(cells[f"{letter}{a}_{unit}"], cells[f"{letter}{a}_deg"]) for a in "XYZ"])

    at = np.array([float(cells[f"{a}_mm"] or "nan") / 1e3 for a in "XYZ"])
    names = cells["kind"], cells["place"], cells["on"]
    return Row(float(cells["speed_rpm"]), *names, float(cells["order"]), at, vector("F", "N"), vector("M", "Nm"))


def _phasor(amount, phase):
    return float(amount) * cmath.exp(1j * math.radians(float(phase or 0)))


def signal(rows, epsilon, what=lambda row: row.force):
    """The sum of the rows over angles of the crank (angles, 3)."""
    return sum(np.real(what(row)[None, :] * np.exp(1j * row.order * np.asarray(epsilon))[:, None]) for row in rows)
