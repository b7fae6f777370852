# SPDX-License-Identifier: Apache-2.0
"""Whole designs from Python: `from calc import load_design, solve_design`."""

from pathlib import Path

from .design.model import Design
from .design.toml_file import load
from .solve import solve as solve_design

__all__ = ["Design", "load_design", "solve_design"]


def load_design(path: Path | str) -> Design:
    """The design in a file; all that is wrong in it is raised at once, as BadInput."""
    return load(path)[1]
