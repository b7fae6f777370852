# SPDX-License-Identifier: Apache-2.0
"""`contralbero`, and `python -m contralbero`: begins the program, once its packages are its own.

They have short names, `assistant`, `calc` and `reports`; Python takes the first that it finds of each, which may be
somebody else's.  That is told in words here, where nothing of them is loaded yet.  The library is `calc`."""

import os
import sys
from importlib.util import find_spec

PACKAGES = ("assistant", "calc", "reports")
HERE = os.path.dirname(os.path.abspath(__file__))


def main() -> int:
    try:
        if others := in_the_way():
            print("\n".join(f"contralbero: {words}" for words in others), file=sys.stderr)
            return 2
        from assistant.__main__ import main as command_line
    except KeyboardInterrupt:
        return 130
    return command_line()


def in_the_way() -> list[str]:
    """What is said of each package that is not the one beside this file."""
    said = []
    for name in PACKAGES:
        own, found = os.path.join(HERE, name, "__init__.py"), _place(name)
        if not os.path.exists(own):
            said.append(f"its package {name} is missing beside {HERE}: install it again")
        elif found is None or not os.path.samefile(found, own):
            said.append(
                f"another package called {name} stands in the way: {found or 'of no file'}; move it, start elsewhere, "
                "or give the program an environment of its own (pipx install, uv tool install)"
            )
    return said


def _place(name: str) -> str | None:
    """The file that Python takes for a package; None where it has none."""
    try:
        spec = find_spec(name)
    except ValueError:  # loaded already, by whoever hides where from
        return None
    if spec is None:
        return None
    places = [spec.origin, *(spec.submodule_search_locations or ())]
    return next((place for place in places if place is not None and os.path.exists(place)), None)


if __name__ == "__main__":
    sys.exit(main())
