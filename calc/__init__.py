# SPDX-License-Identifier: Apache-2.0
"""The engineering, step by step: engine, imbalance, gears, countershaft, bearings, friction, mounting.

`solve.py` calls them in that order.  Below them `sheet`, `locale`, `library`, `draw`; above them `design` and
`studies`. It draws on no screen and no page, and prints nothing."""

from typing import TYPE_CHECKING

from .sheet.lazy import lazy

__all__ = ["Design", "load_design", "solve_design"]

if TYPE_CHECKING:
    from .design.model import Design
    from .design.toml_file import load_design
    from .solve import solve as solve_design
else:
    __getattr__ = lazy(
        __name__,
        {
            "Design": ".design.model",
            "load_design": ".design.toml_file",
            "solve_design": ".solve:solve",
        },
    )
