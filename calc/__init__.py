# SPDX-License-Identifier: Apache-2.0
"""The engineering, step by step: engine, imbalance, gears, countershaft, bearings, friction, mounting.

`solve.py` calls them in that order.  Below them `sheet`, `locale`, `library`, `draw`; above them `design` and
`studies`. It draws on no screen and no page, and prints nothing."""

from typing import TYPE_CHECKING

from .sheet.offered import offer

if TYPE_CHECKING:
    from . import bearings as bearings
    from . import countershaft as countershaft
    from . import engine as engine
    from . import friction as friction
    from . import gears as gears
    from . import imbalance as imbalance
    from . import library as library
    from . import mounting as mounting
    from .design.model import Design as Design
    from .design.toml_file import load_design as load_design
    from .sheet.errors import BadInput as BadInput
    from .sheet.errors import NoSolution as NoSolution
    from .sheet.step import Outcome as Outcome
    from .solve import Results as Results
    from .solve import solve_design as solve_design

offer(globals())
