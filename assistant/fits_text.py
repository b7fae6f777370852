# SPDX-License-Identifier: Apache-2.0
"""Fits of a design as the command line prints them, and as JSON."""

import textwrap
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from calc.design.model import Design
from calc.measurements.fit_inputs import FitInputs
from calc.sheet.number import short
from calc.sheet.quantity import Published
from calc.sheet.text import Text, plural

from .results_text import LINE, check_json, finite, values_json

if TYPE_CHECKING:
    from calc.studies.fit_results import DesignFit  # with numpy and what else a fit takes

INDENT = "  "


def print_fit(fit: "DesignFit") -> None:
    """The verdict, each value with its standard deviation and its limits, what was fitted, what the verdict means."""
    result, values = fit.result, fit.values()
    print(f"fit {fit.name}, of {', '.join(fit.runs)}: {fit.verdict}")
    for i, name in enumerate(fit.names):
        if (value := values.get(f"{fit.id}.{name.key}")) is None:
            continue
        about, ends, number = "", "", value.shown
        if (sd := values.get(f"{fit.id}.{name.key}.sd")) is not None:
            low, high = (short(float(end)) for end in result.limits[i])
            about, ends, number = f" ± {short(sd.shown, 3)}", f"   95 %: {low} … {high}", fit.applied(i)
        print(f"  {name.key:<50} {short(number, 6)}{about} {name.unit}{ends}".rstrip())
    rows = ", ".join(f"{n} of {column}" for column, n in fit.rows.items())
    print(f"  rows: {rows}; degrees of freedom: {result.degrees_of_freedom}")
    told = [value for id, value in values.items() if id.count(".") == 2]
    print("  " + ", ".join(f"{v.id.rpartition('.')[2]} {_told(v)} {v.unit}".rstrip() for v in told))
    for words in (*fit.left_out, fit.sentence):
        print("\n".join(textwrap.wrap(words, LINE)))


def _told(value: Published) -> str:
    """A number; of a correlation so many digits that it is not taken for 1."""
    return short(value.shown, 5 if value.id.endswith("correlation") else 3)


def print_fits(design: Design, made: Mapping[str, "DesignFit | Text"], *, whole: bool) -> None:
    """A line for each fit of a design: what it came to, and of one that is not made how it is.  `whole`: in full."""
    for fit in design.fits:
        if fit is design.fits[0]:
            print()
        match made.get(fit.name):
            case None:
                print(Text("{name}: {how}", name=fit.name, how=_unmade(design, fit)))
            case str() as why:
                print(Text("{name}: {why}", name=fit.name, why=why))
            case done if whole:
                print_fit(done)
            case done:
                print(*textwrap.wrap(done.words, LINE, subsequent_indent=INDENT), sep="\n")


def _unmade(design: Design, fit: FitInputs) -> Text:
    what = plural("{n} input", "{n} inputs", len(fit.free))
    how = Text("`contralbero fit FILE {name}`, or --fits here", name=fit.name)
    return Text("{what} to be found from {runs}: {how}", what=what, runs=", ".join(design.runs_of(fit)), how=how)


def with_fits(found: dict[str, Any], made: Mapping[str, "DesignFit | Text"]) -> dict[str, Any]:
    """The object of `check --json` with fits that are made: themselves, their values, their checks."""
    done = [fit for fit in made.values() if not isinstance(fit, str)]
    fits = {name: {"words": fit} if isinstance(fit, str) else fit_json(fit) for name, fit in made.items()}
    return found | {
        "fits": {name: about | fits.get(name, {}) for name, about in found["fits"].items()},
        "values": found["values"] | values_json({id: value for fit in done for id, value in fit.values().items()}),
        "checks": [*found["checks"], *(check_json(fit.check()) for fit in done)],
    }


def fit_json(fit: "DesignFit") -> dict[str, Any]:
    """A fit beside its values and its check, which stand with those of the design."""
    result = fit.result
    limits = {f"{fit.id}.{name.key}": [*map(finite, map(float, ends))] for name, ends in zip(fit.names, result.limits)}
    return {
        "of": list(fit.runs),
        "free": [name.key for name in fit.names],
        "verdict": result.verdict,
        "words": fit.sentence,
        "limits_95": limits if fit.identified else {},
        "degrees_of_freedom": result.degrees_of_freedom,
        "sum_of_squares": finite(result.sum_of_squares),
        "scaled": result.scaled,
        "rows": dict(fit.rows),
        "left_out": list(fit.left_out),
    }
