# SPDX-License-Identifier: Apache-2.0
"""How it is said that something needs an extra which is not installed."""

from .text import Text


def needs(extra: str) -> Text:
    return Text("needs the extra `{extra}`: pip install 'contralbero[{extra}]'", extra=extra)
