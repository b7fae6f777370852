# SPDX-License-Identifier: Apache-2.0
"""A few bearings by hand, with the typical geometry and the ratings of the given values, and those values themselves."""

import json
from typing import Any, NamedTuple

from calc.bearings.rolling.torque import Friction, friction_of
from calc.library.catalogue import Oil
from calc.library.lubricant import Lubricant
from tests.conftest import ROOT

GIVEN: list[dict[str, Any]] = json.loads((ROOT / "tests/reference/rolling.json").read_text(encoding="utf-8"))["given"]
OIL = Lubricant(Oil(name="10W-40 given", nu40=95.7e-6, nu100=14.0e-6, rho15=860.0, base="mineral"))


def given(case: str) -> list[dict[str, Any]]:
    """The given values whose case begins with these words."""
    rows = [row for row in GIVEN if row["case"].startswith(case)]
    assert rows
    return rows


class Typical(NamedTuple):
    """Outline in m, F_w and E_w where no inner ring is, raceways by the typical geometry, ratings in N."""

    type: str
    series: str
    d: float
    D: float
    B: float
    element: float
    pitch: float
    C: float
    C_0: float

    @property
    def raceways(self) -> dict[str, float]:
        return dict(inner_raceway=self.pitch - self.element, outer_raceway=self.pitch + self.element)

    def friction(self, **said: Any) -> Friction[float]:
        return friction_of(self.type, self.series, self.d, self.D, self.B, static_rating=self.C_0, **said)


def _ball(series: str, d: float, D: float, B: float, C: float, C_0: float) -> Typical:
    return Typical("ball", series, d / 1e3, D / 1e3, B / 1e3, 0.295 * (D - d) / 1e3, (D + d) / 2e3, C, C_0)


def _roller(series: str, d: float, D: float, B: float, C: float, C_0: float) -> Typical:
    return Typical("roller", series, d / 1e3, D / 1e3, B / 1e3, 0.275 * (D - d) / 1e3, 0.506e-3 * (D + d), C, C_0)


BEARINGS = {
    "6205": _ball("62", 25, 52, 15, 14100.93, 7873.522),
    "6305": _ball("63", 25, 62, 17, 20576.65, 10632.71),
    "NU205": _roller("2", 25, 52, 15, 29299.23, 27845.6),
    "NA4905": Typical("needle", "NA49", 0.025, 0.042, 0.017, 3e-3, 0.033, 22271.78, 34680.0),
    "HK2520": Typical("cup", "HK", 0.025, 0.032, 0.020, 2.5e-3, 0.0275, 18237.74, 32500.0),
    "HK3020": Typical("cup", "HK", 0.030, 0.037, 0.020, 2.5e-3, 0.0325, 20000.0, 39000.0),  # ratings only about
    "K25x30x20": Typical("cage", "K", 0.025, 0.030, 0.020, 2.5e-3, 0.0275, 20382.62, 37440.0),
}
