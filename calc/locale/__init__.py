# SPDX-License-Identifier: Apache-2.0
"""The texts of the program in other languages.

The code speaks English: a sentence is a `Text` (`calc.sheet.text`), a template with named parts.  A language looks the
template up in its catalogue, `calc/locale/<code>/LC_MESSAGES/contralbero.po`, and puts the parts in; what it does not
find it shows whole in English. Catalogues are those of gettext: any of its editors opens them, and the library of
Python reads them, compiled (`.mo`), in 10 ms."""

from .language import FOLDER, LANGUAGES, Language, language

__all__ = ["FOLDER", "LANGUAGES", "Language", "language"]
