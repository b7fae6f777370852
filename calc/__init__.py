# SPDX-License-Identifier: Apache-2.0
"""The engineering: numbers in, numbers out; the steps, the sheet they are written on, studies of whole designs.

No screen, no paper, no printing."""

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
