# SPDX-License-Identifier: Apache-2.0
"""The train as a model of REXS 1.7, FVA's exchange format, for gear programs; what is not in it is said."""

from assistant.exports.kinds import Made, Request
from calc.exchange.rexs import has_parts, rexs
from calc.sheet.errors import InputError
from calc.sheet.text import Text

NOTHING = Text("needed for a file of REXS: add [gears], or [[shafts]]")


def lacks(asked: Request) -> InputError | None:
    results = asked.results
    if results.design.gears is not None and results.train is None:
        reason = results.outcomes["gears"].reason
        return InputError(0, "gears", "", Text("there is no train to write: {reason}", reason=reason))
    return None if has_parts(results) else InputError(0, "gears", "", NOTHING)


def made(asked: Request) -> Made:
    model = rexs(asked.results)
    return Made({asked.path: model.file()}, model.notes)
