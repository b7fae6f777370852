# SPDX-License-Identifier: Apache-2.0
"""The report's own words, in English.  What the calculation says (labels, advice, sources) comes from the sheet."""

from calc.compare import EQUAL
from calc.sheet.check import SIGNS

from .boxes import Colour

WORDS = {
    "page": "Page {page} of {pages}",
    "report": "Calculation report",
    "author": "Author", "checker": "Checked by", "revision": "Revision", "date": "Date", "file": "Design file, SHA-256",
    "solved": "Values and verdicts of the report",
    "program": "Program", "attached": "The design file is attached to this document as design.toml.",
    "pass": "pass", "warn": "warn", "fail": "fail", "blocked": "blocked", "not_asked": "not asked", "no_solution": "no solution",
    "step": "Step", "verdict": "Verdict", "worst": "Closest check", "value": "Value", "limit": "Limit", "margin": "Margin",
    "check": "Check", "unit": "Unit", "quantity": "Quantity", "symbol": "Symbol", "key": "Key in the design file",
    "id": "Name of the value", "source": "Source", "advice": "advice",
    "steps": "Steps", "attention": "Failures and warnings", "errata": "Where the source is wrong",
    "source_value": "Its method", "our_value": "This report", "deviation": "Deviation", "contents": "Contents",
    "inputs": "Inputs", "notes": "Assumptions", "formulas": "Formulas", "results": "Results",
    "proposals": "Proposed remedies", "tables": "Tables", "checks": "Checks",
    "figures": "Figures", "figure": "Figure", "summary": "Summary",
    "defaults": "* default of the program, not given in the design file.",
    "left_out": "Left out, chosen by the program where it is needed: {names}.",
    "substitution": "Numbers are substituted in SI units (m, kg, s, N, Pa, W; angles in rad, temperatures in °C); a vector in the "
    "plane is written length∠angle. The result stands in the unit given.",
    "zero_lines": "Lines whose value is exactly zero are left out here; the audit report has every line.",
    "resting": "Here stand the formulas that lead to the value of this step, to its closest limit and to what fails; {count} more lines "
    "stand in the audit report.",
    "nearest": "`contralbero check` ends with the nearest design that passes, as a command with all that it changes; in the session F5 "
    "applies it.",
    "further": "Further figures and tables of this step stand in the audit report.",
    "zero_values": "Zero throughout, not shown: {names}.",
    "more": "and {count} more, in the audit report", "others": "further: {values}",
    "more_proposals": "and {count} more, in the engineer report",
    "drawing": "Drawing sheet", "index": "Index of values", "materials": "Oils and materials",
    "oil": "Oil", "material": "Material", "note": "Note", "sources": "Sources", "used_in": "Used in",
    "sources_note": "Clauses, equations and tables by publication; beside each formula stands the one it was taken from.",
    "sources_rest": "Publications are those of the whole calculation; clauses of lines that only the audit report shows stand there.",
    "own": "Definitions and rules without a publication",
    "not_asked_text": "the design file has no table [{key}].",
    "blocked_text": "this step {reason}.", "no_solution_text": "{reason}.",
    "no_checks": "no checks",
    "count": "{fail} failed, {warn} warnings, {pass} passed of {total} checks", "waiting": "; not solved: {steps}",
    "missing_glyphs": "▯ stands for a character that this report's font does not have; the attached file has it.",
    "comparison": "Comparison of two designs", "design": "Design", "verdicts": "Verdicts of the steps",
    "equal": EQUAL,
    "inputs_differ": "Inputs that differ: {count}.", "steps_move": "Steps that change their verdict: {count}.",
    "checks_move": "Checks that change their verdict: {count}, of them {worse} to the worse and {better} to the better.",
    "values_differ": "Values that differ: {count}; in one design only: {lone}.",
    "moved": "Checks whose verdict moved", "lone": "Checks of one design only that do not pass",
    "kept": "Checks that keep their verdict at another value or limit",
    "more_values": "{count} more values differ less; `contralbero compare --all` lists them.",
    "lone_values": "What stands in one design only is counted above; `contralbero compare --all` lists it.",
    "two": "{name} (continued)", "between": "{count} more; {total} in all",
}  # fmt: skip

STATE_COLOURS: dict[str, Colour] = {
    "pass": (0.0, 0.42, 0.31), "warn": (0.66, 0.40, 0.0), "fail": (0.75, 0.16, 0.0), "blocked": (0.35, 0.35, 0.35),
    "not_asked": (0.45, 0.45, 0.45), "no_solution": (0.75, 0.16, 0.0),
}  # fmt: skip
STATE_PANELS: dict[str, Colour] = {"pass": (0.92, 0.97, 0.94), "warn": (0.99, 0.96, 0.88), "fail": (0.99, 0.93, 0.90)}


def verdict(words: dict[str, str], state: str) -> str:
    """Sign and word: readable without colour."""
    return f"{SIGNS[state]} {words[state]}"
