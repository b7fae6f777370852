"""Which module imports which, read from the source: every import counts, inside a function or under TYPE_CHECKING
too."""

import ast
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

Graph = Mapping[str, frozenset[str]]


def modules(root: Path, *packages: str) -> dict[str, Path]:
    """The modules of packages ("calc", "calc.sheet") below `root`, by their full names; a package is the module of its
    `__init__.py`."""
    paths = {}
    for package in packages:
        for path in root.joinpath(*package.split(".")).rglob("*.py"):
            parts = path.relative_to(root).with_suffix("").parts
            paths[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
        assert any(f"{name}.".startswith(f"{package}.") for name in paths), f"no module of {package} below {root}"
    return paths


@cache
def imported(name: str, path: Path, top_only: bool = False, typing: bool = True) -> tuple[str, ...]:
    """The full names that the module `name` imports: of `from a import b` both `a` and `a.b`, which may be a module.

    `top_only`: only what is imported when the module is loaded, outside of functions and of `if TYPE_CHECKING`.
    Not `typing`: all but what stands under `if TYPE_CHECKING`.
    """
    return tuple(_imported(name, path, top_only, typing))


def _imported(name: str, path: Path, top_only: bool, typing: bool) -> Iterator[str]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    package = name.split(".") if path.name == "__init__.py" else name.split(".")[:-1]
    for node in _loaded(tree, not top_only) if top_only or not typing else ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            source = ".".join([*base, *([node.module] if node.module else [])])
            yield source
            yield from (f"{source}.{alias.name}" for alias in node.names)


def _loaded(node: ast.AST, functions: bool = False) -> Iterator[ast.AST]:
    """The statements that run when a module is loaded; with `functions` those that run at any time."""
    for child in ast.iter_child_nodes(node):
        if not functions and isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)):
            continue
        if isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test):
            for statement in child.orelse:
                yield statement
                yield from _loaded(statement, functions)
            continue
        yield child
        yield from _loaded(child, functions)


def graph(paths: Mapping[str, Path]) -> Graph:
    """module → the modules among these that it imports.  `from package import module` is an import of the module
    alone."""
    edges = {}
    for name, path in paths.items():
        names = {n for n in imported(name, path) if n in paths and n != name}
        # of `from a.b import c` with a module a.b.c the package a.b only passes it on, unless it has names of its own
        edges[name] = frozenset(
            n for n in names if not (paths[n].name == "__init__.py" and any(m.startswith(n + ".") for m in names))
        )
    return edges


def circles(edges: Graph) -> list[frozenset[str]]:
    """The sets of modules that reach each other (strongly connected components of more than one), largest first."""
    index: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    components = []

    def visit(name: str) -> None:
        index[name] = low[name] = len(index)
        stack.append(name)
        for other in edges[name]:
            if other not in index:
                visit(other)
                low[name] = min(low[name], low[other])
            elif other in stack:
                low[name] = min(low[name], index[other])
        if low[name] == index[name]:
            component = frozenset(stack[stack.index(name) :])
            del stack[stack.index(name) :]
            if len(component) > 1:
                components.append(component)

    for name in edges:
        if name not in index:
            visit(name)
    return sorted(components, key=lambda c: (-len(c), min(c)))
