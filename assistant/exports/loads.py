# SPDX-License-Identifier: Apache-2.0
"""The loads of a design for finite elements and multi-body programs, as a table or as JSON."""

import math

from assistant.exports.kinds import Made, Request
from calc.exchange.loads import CLOSES, Loads, default_speeds, loads, variants
from calc.exchange.loads_text import csv_text, json_text
from calc.locale.language import language
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import COMMA, Amount, Name, Text

MOST_SPEEDS, OVERSPEED = 200, 2.0  # of rated speed
ROUNDING = 1e-9  # of a step


def lacks(asked: Request) -> InputError | None:
    results = asked.results
    for key, given in (("engine", results.design.engine), ("imbalance", results.design.imbalance)):
        outcome = results.outcomes[key]
        if given is None:
            return InputError(0, key, "", Text("needed for loads: add [{key}]", key=Name(key)))
        if outcome.result is None:
            return InputError(0, key, "", Text("there are no loads: {reason}", reason=outcome.reason))
    return None


def made(asked: Request) -> Made:
    design, results = asked.document, asked.results
    speeds, variant, wrong = default_speeds(results.design), str(asked.options.get("variant", "shaft")), []
    try:
        if isinstance(given := asked.options.get("speeds"), str):
            engine = results.design.engine
            assert engine is not None
            speeds = speeds_of(given, engine.rated_speed * 60)
    except BadInput as bad:
        wrong += bad.errors
    if "variant" in asked.options and variant not in (known := variants(results)):
        words = Text(
            "is not known of this design: it has {known} (scatter needs [mounting], and the errors there or "
            "[shafts.scatter]; tooth needs gears)",
            known=COMMA.join(map(Name, known)),
        )
        wrong.append(InputError(0, "--variant", variant, words))
    if wrong:
        raise BadInput("contralbero export", wrong)
    found = loads(results, speeds, variant)
    text = json_text if asked.ending == "json" else csv_text
    return Made({asked.path: text(found, results.design.name, design.sha256, language(asked.lang))}, (summary(found),))


def summary(found: Loads) -> Text:
    """How many rows of which kinds, and whether the sums close."""
    kinds = dict.fromkeys(row.kind for row in found.rows)
    counted = (Name(f"{kind} {sum(row.kind == kind for row in found.rows)}") for kind in kinds)
    worst = max(found.sums.values(), default=0.0)
    closed = Text("sums close to {off}", off=Name(f"{worst:.1e}"))
    if not found.closes:
        closed = Text("A SUM DOES NOT CLOSE: {off}, limit {limit}", off=Name(f"{worst:.1e}"), limit=Name(f"{CLOSES:g}"))
    return Text("{n} rows ({kinds}); {closed}", n=len(found.rows), kinds=COMMA.join(counted), closed=closed)


def speeds_of(given: str, rated: float) -> tuple[float, ...]:
    """`LO:HI:STEP`, rpm, as speeds in 1/s; the last is HI where a step reaches it.  Raises BadInput."""

    def refused(reason: Text) -> BadInput:
        return BadInput("contralbero export", [InputError(0, "--speeds", given, reason)])

    try:
        lowest, highest, step = map(float, given.split(":"))
    except ValueError:
        raise refused(Text("must be LO:HI:STEP, three numbers in rpm, like 900:2600:100")) from None
    if not all(map(math.isfinite, (lowest, highest, step))) or lowest <= 0 or highest < lowest or step <= 0:
        raise refused(Text("must be LO:HI:STEP with 0 < LO, LO not above HI, and a STEP above 0"))
    if highest > OVERSPEED * rated * (1 + ROUNDING):
        most = Amount(OVERSPEED * rated, "rpm", form="g")
        raise refused(Text("goes beyond twice the rated speed; HI is at most {most}", most=most))
    count = math.floor((highest - lowest) / step + ROUNDING) + 1
    if count > MOST_SPEEDS:
        raise refused(Text("are {count} speeds; at most {most}: take a larger STEP", count=count, most=MOST_SPEEDS))
    return tuple((lowest + k * step) / 60 for k in range(count))
