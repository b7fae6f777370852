# SPDX-License-Identifier: Apache-2.0
"""The engineering, step by step: engine, imbalance, gears, countershaft, bearings, friction, mounting.

`solve.py` calls them in that order.  Below them `sheet`, `locale`, `library`, `draw`; above them `design` and
`studies`. It draws on no screen and no page, and prints nothing."""

from importlib import import_module
from typing import Any

# what this package offers, each from its module, behind a colon how it is called there; loaded when it is asked for
OFFERED = {
    "Design": ".design.model",
    "load_design": ".design.toml_file",
    "solve_design": ".solve:solve",
}
__all__ = [*OFFERED]


def __getattr__(name: str) -> Any:
    if name not in OFFERED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module, _, called = OFFERED[name].partition(":")
    return getattr(import_module(module, __name__), called or name)


def __dir__() -> list[str]:
    return __all__
