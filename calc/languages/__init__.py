# SPDX-License-Identifier: Apache-2.0
"""The texts of the program in other languages.

The code speaks English.  A catalogue holds, for each English text as it stands in the source, its translation; what an f-string puts
in stands there as {0}, {1} …: "Smallest backlash {0}–{1}" → "Gioco minimo {0}–{1}".  `Language` finds the template that a finished
text was made from, so that the engineering need not know that there are languages.
"""

from .language import LANGUAGES, Language, afresh, language

__all__ = ["LANGUAGES", "Language", "afresh", "language"]
