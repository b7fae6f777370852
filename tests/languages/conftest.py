# SPDX-License-Identifier: Apache-2.0
"""A design in a folder of its own, as for the other tests of the session."""

import io
from collections.abc import Callable
from gettext import GNUTranslations

import pytest
from babel.messages.catalog import Catalog
from babel.messages.mofile import write_mo

from calc.locale import Language
from tests.assistant.conftest import design, light, memory, session
from tests.languages.texts import PLURALS

__all__ = ["catalogue", "design", "light", "memory", "session"]


@pytest.fixture
def catalogue() -> Callable[[dict[str | tuple[str, str], str | tuple[str, str]]], Language]:
    """A language from a few entries: template → translation, or (one, many) → both."""

    def made(entries: dict[str | tuple[str, str], str | tuple[str, str]]) -> Language:
        catalog, data = Catalog(locale="it"), io.BytesIO()
        catalog.mime_headers = [PLURALS]
        for template, translation in entries.items():
            catalog.add(template, translation)
        write_mo(data, catalog)
        data.seek(0)
        return Language("it", GNUTranslations(data))

    return made
