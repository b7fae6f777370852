# SPDX-License-Identifier: Apache-2.0
"""Changes told in words."""

from assistant.session.editing import locked_text
from calc.design.toml_file import read
from calc.studies.shipped import EXAMPLE


def test_what_is_locked_is_said_of_the_changes_that_touch_it() -> None:
    document = read(EXAMPLE)
    oil = str(document.data["bearings"]["oil"])
    changes = ["bearings.oil='another'", "bearings.front.length_mm=30", "gears.wheels.nowhere.teeth=20"]
    assert str(locked_text(document, changes)) == "changes what is locked: Oil (bearings.oil): the oil is the engine's"
    assert not locked_text(document, [f"bearings.oil='{oil}'", *changes[1:]])
    unlocked = document.with_value("locked", {})
    assert not locked_text(unlocked, changes)
