# SPDX-License-Identifier: Apache-2.0
"""The R753IE4 on its mounts with a flywheel: gas at idle and at rated speed, so that the drive is known."""

from functools import cache

from calc.design.toml_file import Document, design, parse
from calc.sheet.value import recorded
from calc.solve import Results, solve
from tests.conftest import DESIGNS

BORE = b"bore_mm = 94.0\n"


def with_flywheel() -> Document:
    raw = (DESIGNS / "r753ie4_mounting.toml").read_bytes()
    assert raw.count(BORE) == 1 and b"flywheel_inertia_kgm2" not in raw
    return parse(raw.replace(BORE, BORE + b"flywheel_inertia_kgm2 = 0.9\n"), "design.toml")


@cache
def known_drive() -> Results:
    with recorded(False):
        return solve(design(with_flywheel()), compared=False)
