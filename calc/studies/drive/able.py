# SPDX-License-Identifier: Apache-2.0
"""Whether the whole drive of a design can be searched here: asked before anybody is offered it."""

from collections.abc import Mapping

from ...design.model import IN_SENTENCES
from ...design.toml_file import Document
from ...sheet.errors import BadInput, NoSolution
from ...sheet.text import COMMA, EMPTY, Text
from ...solve import Results
from .classes import without_proof
from .evolve import NEEDS, installed, may
from .search import asked_of


def unable(document: Document, results: Results, overrides: Mapping[str, object] = {}) -> Text:
    """Why the whole drive of a design can not be searched, in words for whoever wants to; empty where it can."""
    whole_design = results.design
    needed = {"engine": whole_design.engine, "imbalance": whole_design.imbalance, "bearings": whole_design.bearings}
    missing = [key for key, table in needed.items() if table is None]
    missing += ["countershaft"] if not whole_design.shafts else []
    if missing:
        steps = COMMA.join(IN_SENTENCES[step] for step in IN_SENTENCES if step in missing)
        return Text("The whole drive is searched once the design has these steps: {steps}.", steps=steps)
    lost = next((key for key in ("engine", "imbalance") if results.outcomes[key].state != "solved"), None)
    if lost is not None:
        return Text("The whole drive is searched once this step has a solution: {step}.", step=IN_SENTENCES[lost])
    most = max(len(view.rows) for view in whole_design.views.values())
    if most > 2:
        return Text("The whole drive is searched on two bearings, and the shaft has {n}.", n=most)
    try:
        asked_for = asked_of(document, results, overrides)
    except BadInput as bad:
        return Text("The whole drive can not be searched: {why}.", why=bad.errors[0].reason)
    except NoSolution as none:
        return Text("The whole drive can not be searched: {why}.", why=none.text)
    if (why := may(asked_for)) is not None:
        return Text("The whole drive can not be searched: {why}.", why=why)
    if not installed() and without_proof(asked_for) is not None:
        return Text("This drive is searched by trying whole solutions, which {needs}.", needs=NEEDS)
    return EMPTY
