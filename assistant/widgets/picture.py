# SPDX-License-Identifier: Apache-2.0
"""The picture of the step."""

from textual.content import Content
from textual.widget import Widget


class Picture(Widget, can_focus=True):
    """Stands empty until the step has a sketch."""

    def render(self) -> Content:
        return Content("")
