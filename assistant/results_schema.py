# SPDX-License-Identifier: Apache-2.0
"""The JSON Schema of the results, which `check --json` and `export --json` give: what each field is and may be, for the
programs that read them.  `docs/generate.py` makes a page of it.

What is promised stands in `PROMISE`; `results_text.results_json` makes the object.  Further fields are allowed, so that
one who holds results of a later version to this schema is not refused."""

import json
from collections.abc import Mapping
from typing import Any, get_args

from assistant.results_text import RESULTS
from calc.design.model import STEP_KEYS
from calc.design.schema import DIALECT
from calc.measurements.fit_words import VERDICTS as FIT_VERDICTS
from calc.measurements.words import Judged, Runs
from calc.sheet.check import KINDS, Role
from calc.sheet.verdict import State

Schema = dict[str, Any]

PROMISE = (
    f"Within schema {RESULTS} fields, ids of values and ids of checks are added; none is taken away, renamed, or given "
    "another type, unit or meaning, and no word is added to those that a field may have. Whatever would do that "
    "raises the number in `schema`."
)
SENSES = (">=", ">", "<=", "<", "in")
VERDICTS = ("pass", "accepted", "note", "warn", "not_verified", "fail")  # of a check, from good to bad
FINDINGS = tuple(word for word in VERDICTS if word != "accepted")
ENDS = ("holds", "none")


def schema_text() -> str:
    """The whole of it, as a file."""
    about = {"$schema": DIALECT, "$id": f"urn:contralbero:results:{RESULTS}", "title": "Contralbero results"}
    return json.dumps(about | results_schema(), ensure_ascii=False, indent=1) + "\n"


# --- kinds of fields


def _text(about: str, *words: str) -> Schema:
    return {"description": about, "type": "string"} | ({"enum": list(words)} if words else {})


def _number(about: str) -> Schema:
    """A number, or null where it is none or not finite."""
    return {"description": about, "type": ["number", "null"]}


def _count(about: str) -> Schema:
    return {"description": about, "type": "integer", "minimum": 0}


def _texts(about: str) -> Schema:
    return {"description": about, "type": "array", "items": {"type": "string"}}


def _list(about: str, items: Schema) -> Schema:
    return {"description": about, "type": "array", "items": items}


def _by(about: str, what: str, content: Schema) -> Schema:
    """An object whose names are ids: `what` they are."""
    return {
        "description": about,
        "type": "object",
        "propertyNames": {"description": what},
        "additionalProperties": content,
    }


def _object(about: str, fields: Mapping[str, Schema]) -> Schema:
    """An object that has all of these fields, and perhaps more."""
    return {"description": about, "type": "object", "required": list(fields), "properties": dict(fields)}


# --- the results


def results_schema() -> Schema:
    states = get_args(State)
    return _object(
        "The results of one design, or with `--step` of one step. Numbers stand in the unit beside them; one that is "
        "not finite is null. Sentences (label, name, advice, note, words …) are for people and may be reworded.",
        {
            "schema": {"description": "The number of this schema.", "type": "integer", "const": RESULTS},
            "program": _text("Who wrote it.", "contralbero"),
            "version": _text("Of the program."),
            "design": _object(
                "What was solved.",
                {
                    "name": _text("Its name."),
                    "sha256": _text("Hash of the bytes of its file; empty where it was never in one."),
                    "set": _texts("`--set KEY=VALUE` of this run, in their order."),
                },
            ),
            "verdict": _text("The state of the design, or of the step that was asked for.", *states),
            "counts": _object(
                "How many checks, each counted once.",
                {
                    "limits": _count("Limits that there are."),
                    "failed": _count("Limits that fail."),
                    "not_verified": _count("Limits that can not be judged by what is given."),
                    "cautions": _count("Cautions that are open."),
                    "cautions_held": _count("Cautions that hold."),
                    "narrow": _count("Limits that hold by less than 5 % of their scale."),
                    "accepted": _count("Findings that the user has accepted, with a reason."),
                    "advice": _count("Advice that is open."),
                    "method": _count("Open notes on the calculation."),
                },
            ),
            "steps": _by(
                "The state of each step that is shown.", f"a step: {', '.join(STEP_KEYS)}", _text("", *states)
            ),
            "values": _by("Every result.", "the id of a value: `bearings.front.film`", _value()),
            "tables": _by("Tables of results.", "step and id of a table: `bearings.seats`", _table()),
            "checks": _list("Every check, step by step.", _check()),
            "measurements": _by("Runs of the bench beside what is predicted.", "the name of a run", _run()),
            "fits": _by(
                "Inputs found from runs; with --fits their values and checks stand among the others.",
                "the name of a fit",
                _fit(),
            ),
            "errata": _list("Where a source has another value than is judged here, and why.", _erratum()),
            "proposals": _by("What a step proposes.", "a step", _texts("In sentences.")),
            "notes": _by("What is said of a step: how it was computed, what was chosen.", "a step", _texts("")),
            "unusual": _list("Inputs that are far from what is usual.", _unusual()),
            "reasons": _by("Why a step has no results.", "a step", _text("In a sentence.")),
            "not_counted": _texts("What acts on the parts and no input describes; it touches no state."),
        },
    )


def _value() -> Schema:
    return _object(
        "",
        {
            "value": _number("The number."),
            "unit": _text("Its unit; empty: a plain number."),
            "label": _text("In words."),
        },
    )


def _table() -> Schema:
    column = _object("", {"label": _text("Its head."), "unit": _text("Of the numbers below it.")})
    cell = {"anyOf": [{"type": "string"}, _number("")]}
    return _object(
        "",
        {
            "title": _text("Its title."),
            "columns": _list("From left to right.", column),
            "rows": _list(
                "A cell for each column: words, a number in the unit of the column, or null.", _list("", cell)
            ),
            "note": _text("What stands below it."),
        },
    )


def _check() -> Schema:
    limit = {
        "description": "The limit, or with the sense `in` both ends of what is allowed.",
        "anyOf": [_number(""), {"type": "array", "items": _number(""), "minItems": 2, "maxItems": 2}],
    }
    moved = _object(
        "",
        {
            "key": _text("Of an input; of a list all numbers are moved."),
            "slope": _number("What one unit more of it does to the value; null: not measured."),
            "gain": _number("The same to the gap; positive: the limit is kept more widely."),
            "unit": _text("Of the slope."),
        },
    )
    remedy = _object(
        "",
        {
            "changes": _by("New values.", "the key of an input", {"description": "In its unit; null: left out."}),
            "effect": _text("What that does."),
            "words": _text("Both, in a sentence."),
        },
    )
    return _object(
        "",
        {
            "id": _text("`step.object.name`; the page of the checks has them all."),
            "kind": _text("What it is for a part to pass it over.", *KINDS),
            "role": _text("Of a limit: why it is one. Empty for other kinds.", *get_args(Role)),
            "cause": _text("The id under which it is shown: what has one cause stands together."),
            "name": _text("In words."),
            "value": _number("What is judged."),
            "sense": _text("How the value has to stand to the limit.", *SENSES),
            "limit": limit,
            "unit": _text("Of value, limit, gap, scale and ends."),
            "gap": _number("From the limit, or the nearer end, to the value; negative where it is passed over."),
            "scale": _number("What the margin is a share of."),
            "margin": _number("Gap over scale; negative where the limit is passed over."),
            "utilisation": _number("Demand over capacity, 1 at the limit; null where the check is not on these two."),
            "finding": _text("The verdict before anybody accepts it.", *FINDINGS),
            "verdict": _text("The finding, or `accepted`.", *VERDICTS),
            "outside": _texts("Checks of the method by which a formula behind it is used outside its validity."),
            "source": _text("Of the limit."),
            "advice": _text("What to do; empty where nothing is."),
            "judges": _text("Id of the value that is judged; empty: it is no value of the results."),
            "against": _text("Id of the value that is the limit; empty: it is none."),
            "moved_by": _list("Inputs that move it, measured where it is open.", moved),
            "remedies": _list("What would make it hold.", remedy),
            "missing": _texts("Keys that it needs and the design does not give."),
            "taken": _texts("What was taken for them, in words."),
            "at_best": _end("The value with all that is missing at its favourable end"),
            "at_worst": _end("The value with all that is missing at its unfavourable end"),
            "accepted": _text("The reason that the user gives in `[accepted]`; empty: none."),
        },
    )


def _end(what: str) -> Schema:
    about = f"{what}; `holds`: no limit can be passed over there; `none`: nobody knows; null: nothing is missing."
    return {"description": about, "anyOf": [_number(""), {"enum": list(ENDS)}]}


def _fit() -> Schema:
    about = "identified, at its bound, not identifiable or not converged; null: it is not made, or ended on its way."
    return _object(
        "With more where it is made.",
        {
            "of": _texts("The names of its runs."),
            "free": _texts("The keys of its free inputs."),
            "verdict": {"description": about, "enum": [*FIT_VERDICTS, None]},
        },
    )


def _run() -> Schema:
    return _object(
        "",
        {
            "file": _text("As the design names it."),
            "sha256": _text("Hash of its bytes."),
            "rows": _count("Rows that are used."),
            "rows_left_out": _count("Rows without a speed above 0, or without a condition."),
            "columns": _by("What was measured.", "the name of a column", _run_column()),
        },
    )


def _run_column() -> Schema:
    node = _object(
        "",
        {
            "speed_rpm": _number("Of the crank."),
            "conditions": _by("What inputs were.", "the key of an input", _number("In the unit of the key.")),
            "rows": _count("Of the file."),
            "measured": _number("Their mean."),
            "uncertainty": _number("Standard uncertainty; null: none is given."),
            "common": _number("The error that all nodes share; null: none is given."),
            "predicted": _number("What the design gives there; null: no solution."),
            "residual": _number("Predicted less measured."),
        },
    )
    ends = {"anyOf": [{"type": "array", "items": _number(""), "minItems": 2, "maxItems": 2}, {"type": "null"}]}
    return _object(
        "",
        {
            "value": _texts("Ids of values, or keys of inputs, whose sum was measured."),
            "unit": _text("Of what is measured and predicted."),
            "step": _text("The step that it is of.", *STEP_KEYS),
            "verdict": _text("What it comes to.", *get_args(Judged)),
            "words": _text("In sentences."),
            "accepted": _text("The reason that the user gives in `[accepted]`; empty: none."),
            "rows": _count("Rows with a number."),
            "empty": _count("Rows without one."),
            "used": _count("Nodes that are compared."),
            "not_predicted": _count("Nodes at which the design has no solution."),
            "bias": _number("Mean of the residuals."),
            "rms": _number("Root of the mean of their squares."),
            "chi2_reduced": _number("χ² over the number of nodes; null: no uncertainty is given."),
            "chi2_range": {"description": "From where to where it agrees: 95 % by chance."} | ends,
            "runs_z": _number("Runs of the signs over speed, in standard deviations from chance; null: none."),
            "runs": _text("What they say; below ten nodes nothing.", *get_args(Runs)),
            "nodes": _list("In order of speed.", node),
        },
    )


def _erratum() -> Schema:
    return _object(
        "",
        {
            "about": _text("Id of the value that is judged."),
            "label": _text("What the source calls it."),
            "source_value": _number("What the source has."),
            "unit": _text("Of that."),
            "source": _text("Where it stands."),
            "why": _text("Why it is another."),
            "line": _text("What is printed there; empty: not kept."),
            "who": _text("Who may be wrong."),
        },
    )


def _unusual() -> Schema:
    return _object(
        "",
        {
            "key": _text("Of the input."),
            "value": _number("As it is."),
            "usual": {
                "description": "From, to.",
                "type": "array",
                "items": {"type": "number"},
                "minItems": 2,
                "maxItems": 2,
            },
            "unit": _text("Of all three."),
        },
    )
