# SPDX-License-Identifier: Apache-2.0
"""What a package offers from Python: what it imports for the type checker, loaded when it is asked for (PEP 562).

    if TYPE_CHECKING:
        from .plain.solve import solve_film as solve_film

    offer(globals())

so that checkers and editors know every name, `dir` shows these names and no others, and a start loads none of them."""

import ast
from importlib import import_module
from typing import Any


def offer(package: dict[str, Any]) -> None:
    """Gives a package, by its globals, the attributes that it imports under TYPE_CHECKING."""
    name: str = package["__name__"]
    places = _imported(package["__spec__"].loader.get_source(name))

    def __getattr__(attribute: str) -> Any:
        if attribute not in places:
            raise AttributeError(f"module {name!r} has no attribute {attribute!r}")
        place = places[attribute]
        if place.strip("."):
            content = getattr(import_module(place, name), attribute)
        else:
            content = import_module(place + attribute, name)
        package[attribute] = content
        return content

    package["__all__"] = sorted(places)
    package["__dir__"] = lambda: sorted(places)
    package["__getattr__"] = __getattr__


def _imported(source: str) -> dict[str, str]:
    """name → the module that has it, or the package whose module it is."""
    blocks = [node.body for node in ast.parse(source).body if isinstance(node, ast.If)]
    lines = [line for block in blocks for line in block if isinstance(line, ast.ImportFrom)]
    return {alias.name: "." * line.level + (line.module or "") for line in lines for alias in line.names}
