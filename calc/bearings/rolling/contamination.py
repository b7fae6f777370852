# SPDX-License-Identifier: Apache-2.0
"""How clean the oil is: the words of ISO 281 and the classes of ISO 4406.  What each means stands in the table."""

import re

from ...sheet.quantity import meant
from ...sheet.text import Text

WORDS = ("high", "normal", "slight", "typical", "severe", "very-severe")  # ISO 281:2007, table 13
CLASSES = ("-/13/10", "-/15/12", "-/17/14", "-/19/16")  # ISO 4406, behind an on-line filter: ISO 281:2007, annex A


def cleanliness_problem(words: str) -> Text | None:
    """Why words say nothing of how clean an oil is; None where they do."""
    known = [*WORDS, *CLASSES]
    if words in known:
        return None
    near = meant(re.sub(r"\s", "", words.casefold()), known)
    return Text('"{words}" is not known; one of {known}', words=words, known=", ".join(known)) + near
