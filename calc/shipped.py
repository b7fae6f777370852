# SPDX-License-Identifier: Apache-2.0
"""What comes with the program: complete designs, and engines to begin a design with."""

import tomllib
from pathlib import Path

from .catalogue import TABLES

DESIGNS = Path(__file__).parent.parent / "designs"
EXAMPLE = DESIGNS / "r753ie4_gamma.toml"
COMPLETE = {"r753ie4": EXAMPLE}  # engines with a whole design of their own


def engines() -> dict[str, str]:
    """The shipped engines: id → what it is and where its data come from."""
    rows = tomllib.loads((TABLES / "engines.toml").read_text(encoding="utf-8"))
    return {"r753ie4": "VM Motori R753IE4 with its counter-shaft, solution γ; Finotti 2013"} | {
        name: f"{row['engine']['name']}; {row['source']}" for name, row in rows.items()
    }


def engine_design(name: str) -> str:
    """The text of a design for a shipped engine: complete where a counter-shaft is known for it, else engine and imbalance."""
    if name in COMPLETE:
        return COMPLETE[name].read_text(encoding="utf-8")
    import tomli_w

    row = tomllib.loads((TABLES / "engines.toml").read_text(encoding="utf-8"))[name]
    data = {
        "schema": 1,
        "name": row["engine"]["name"],
        "note": f"Engine data: {row['source']}. No counter-shaft is known for it: add [countershaft], [bearings], [gears] and [friction].",
        "engine": row["engine"],
        "imbalance": {"crank_balance_fraction": 0.5, "kinematics": "exact"},
    }
    return tomli_w.dumps(data)
