# SPDX-License-Identifier: Apache-2.0
"""With which versions a report is made: of this program, and of what computes its numbers."""

import platform
from importlib.metadata import version

from calc.sheet.version import VERSION

MADE = ("program", "python", "numpy", "scipy")
NAME = "Contralbero"


def program(made: dict[str, str]) -> str:
    """The program that made a report, with its version."""
    return f"{NAME} {made['program']}"


def versions() -> dict[str, str]:
    """Of here."""
    others = {name: version(name) for name in MADE[2:]}
    return {"program": VERSION, "python": platform.python_version(), **others}


def others(made: dict[str, str]) -> dict[str, tuple[str, str]]:
    """Of what is another version here: that which something was made with, and that of here."""
    here = versions()
    return {name: (version, here[name]) for name, version in made.items() if version != here[name]}
