# SPDX-License-Identifier: Apache-2.0
"""Names that a package offers and loads only when they are asked for (PEP 562): importing the package costs nothing."""

from collections.abc import Callable, Mapping
from importlib import import_module


def lazy(package: str, where: Mapping[str, str]) -> Callable[[str], object]:
    """The `__getattr__` of a package: of each name the module that has it; behind a colon how it is called there."""

    def get(name: str) -> object:
        if name not in where:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        module, _, other = where[name].partition(":")
        return getattr(import_module(module, package), other or name)

    return get
