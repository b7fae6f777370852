# SPDX-License-Identifier: Apache-2.0
"""What a column of a run comes to, in words."""

from typing import Literal

from ..sheet.text import Text

Judged = Literal["agrees", "does not agree", "uncertainty too large", "not verified"]
Runs = Literal["random", "run", "one side", "not judged"]

WORDS: dict[str, Text] = {
    "agrees": Text("agrees"),
    "does not agree": Text("does not agree"),
    "uncertainty too large": Text("uncertainty too large"),
    "not verified": Text("not verified"),
}
RUN_WORDS: dict[str, Text] = {
    "run": Text("the residuals run: the shape over speed is another"),
    "one side": Text("the residuals are all on one side"),
}
