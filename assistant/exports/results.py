# SPDX-License-Identifier: Apache-2.0
"""All results, as the object that `check --json` prints."""

import json

from assistant.exports.kinds import Made, Request
from assistant.results_text import results_json


def lacks(asked: Request) -> None:
    """Nothing: every design has results."""


def made(asked: Request) -> Made:
    results = results_json(asked.document, asked.results, measured=True)
    return Made({asked.path: json.dumps(results, ensure_ascii=False, indent=1) + "\n"})
