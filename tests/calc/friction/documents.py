# SPDX-License-Identifier: Apache-2.0
"""Design files with keys and tables changed, as they would be read."""

import copy
from dataclasses import replace
from pathlib import Path

from calc.design.toml_file import design, read

DESIGNS = Path(__file__).parents[3] / "designs"


def gamma():
    """The counter-shaft of the R753IE4."""
    return read(DESIGNS / "r753ie4_gamma.toml")


def pair():
    """The spur pair of the gear friction thesis."""
    return read(DESIGNS / "timing_pair.toml")


def changed(document, **tables):
    """The document with keys of its tables set, those that `--set` can not reach too: `friction={"seals": [...]}`."""
    data = copy.deepcopy(document.data)
    for table, keys in tables.items():
        data.setdefault(table, {} if isinstance(keys, dict) else [])
        data[table] = {**data[table], **keys} if isinstance(keys, dict) else keys
    return replace(document, data=data)


__all__ = ["DESIGNS", "changed", "design", "gamma", "pair", "read"]
