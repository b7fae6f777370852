# SPDX-License-Identifier: Apache-2.0
"""Names that a package offers and loads only when they are asked for (PEP 562), so that importing the package costs
nothing."""

from collections.abc import Callable, Collection
from importlib import import_module


def lazy(package: str, names: Collection[str]) -> Callable[[str], object]:
    """The `__getattr__` of a package whose `names` stand in its module `public`."""

    def get(name: str) -> object:
        if name in names:
            return getattr(import_module(f"{package}.public"), name)
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    return get
