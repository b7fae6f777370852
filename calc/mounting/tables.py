# SPDX-License-Identifier: Apache-2.0
"""What standards say of vibration, from `calc/library/tables/vibration.toml`; each row there names its source and how sure it is."""

import tomllib
from functools import cache
from pathlib import Path
from typing import Any

from ..sheet.record import record

TABLE = Path(__file__).parents[1] / "library" / "tables" / "vibration.toml"


@cache
def table() -> dict[str, Any]:  # Any: what a TOML file holds
    return tomllib.loads(TABLE.read_text(encoding="utf-8"))


@record
class Filter:
    """A frequency weighting by the corner frequencies and quality factors of its transfer function."""

    f_1: float
    f_2: float
    f_3: float
    f_4: float
    Q_4: float
    steps: tuple[float, float, float, float] | None  # f_5, Q_5, f_6, Q_6


@cache
def weighting(name: str) -> Filter:
    row = next(row for row in table()["weighting"] if row["name"] == name)
    f, Q = row["f"], row["Q"]
    steps = (f[4], Q[1], f[5], Q[2]) if len(f) > 4 else None
    return Filter(f_1=f[0], f_2=f[1], f_3=f[2], f_4=f[3], Q_4=Q[0], steps=steps)
