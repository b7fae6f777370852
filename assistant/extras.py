# SPDX-License-Identifier: Apache-2.0
"""What an extra installs, and a command asks for."""

from importlib.util import find_spec

from calc.sheet.errors import BadInput, InputError
from calc.sheet.extras import needs
from calc.sheet.text import Text


def missing(extra: str, module: str, place: str, words: Text | None = None) -> InputError | None:
    """That the module of an extra is not installed, and how it is; `place`: what asked for it; `words`: a whole
    sentence of its own."""
    if find_spec(module) is not None:
        return None
    if words is not None:
        return InputError(0, "", "", words)
    return InputError(0, place, "", needs(extra))


def demand(extra: str, module: str, place: str) -> None:
    """Raises BadInput where the module of an extra is not installed."""
    if (lacking := missing(extra, module, place)) is not None:
        raise BadInput("contralbero", [lacking])
