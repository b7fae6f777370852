# SPDX-License-Identifier: Apache-2.0
"""How clean the oil is: the words of ISO 281 and the classes of ISO 4406, and what each means for e_C."""

import re
from difflib import get_close_matches

from ...sheet.text import Text

# e_C by words, ISO 281:2007 table 13: middle of each band, D_pw below 100 mm and from there
WORDS = {
    "high": (0.7, 0.85),
    "normal": (0.55, 0.7),
    "slight": (0.4, 0.5),
    "typical": (0.2, 0.3),
    "severe": (0.05, 0.05),
    "very-severe": (0.0, 0.0),
}
# a and c of e_C = min(1, a·κ^0.68·D_pw^0.55)·(1 − c/D_pw^⅓) behind an on-line filter, ISO 281:2007 annex A, by the
# class of ISO 4406; from memory, confidence medium
CLASSES = {
    "-/13/10": (0.0864, 0.5663),
    "-/15/12": (0.0432, 0.9987),
    "-/17/14": (0.0288, 1.6329),
    "-/19/16": (0.0216, 2.3362),
}


def cleanliness_problem(words: str) -> Text | None:
    """Why words say nothing of how clean an oil is; None where they do."""
    known = [*WORDS, *CLASSES]
    if words in known:
        return None
    near = get_close_matches(re.sub(r"\s", "", words.casefold()), known, 1)
    meant = Text('; did you mean "{near}"?', near=near[0]) if near else Text("")
    return Text('"{words}" is not known; one of {known}', words=words, known=", ".join(known)) + meant
