# SPDX-License-Identifier: Apache-2.0
"""The report's own words, in English.  What the calculation says (labels, advice, sources) comes from the sheet."""

from calc.design.toml_file import REMARKS
from calc.sheet.check import SIGNS
from calc.sheet.text import Text, plural
from calc.studies.compare import EQUAL

from ..typesetting.boxes import Colour

WORDS: dict[str, Text] = {
    "page": Text("Page {page} of {pages}"), "report": Text("Calculation report"),
    "number": Text("Number"), "revision": Text("Revision"), "project": Text("Project"), "customer": Text("Customer"),
    "company": Text("Company"), "name": Text("Name"), "date": Text("Date"), "signature": Text("Signature"),
    "prepared": Text("Prepared"),
    "checked": Text("Checked"), "approved": Text("Approved"), "changes": Text("Change record"),
    "what": Text("What changed"),
    "by": Text("Author"), "logo": Text("Logo"), "file": Text("Design file, SHA-256"),
    "solved": Text("Values and verdicts of the report"), "program": Text("Program"),
    "made_with": Text("Computed with Python {python}, numpy {numpy}, scipy {scipy}."),
    "attached": Text("The design file is attached to this document as design.toml."), "pass": Text("pass"),
    "warn": Text("warn"),
    "fail": Text("fail"), "note": Text("note"), "not_verified": Text("not verified"), "accepted": Text("accepted"),
    "computed": Text("computed"), "not_judged": Text("not judged"),
    "blocked": Text("blocked"), "not_asked": Text("not used"), "no_solution": Text("no solution"),
    "step": Text("Step"), "verdict": Text("Verdict"), "worst": Text("Closest limit or caution"), "value": Text("Value"),
    "limit": Text("Limit"),
    "margin": Text("Margin"), "check": Text("Check"), "unit": Text("Unit"), "quantity": Text("Quantity"),
    "symbol": Text("Symbol"),
    "key": Text("Key in the design file"), "id": Text("Name of the value"), "source": Text("Source"),
    "advice": Text("advice"),
    "steps": Text("Steps"), "errata": Text("Where the source is wrong"),
    "source_value": Text("Its method"), "our_value": Text("This report"), "deviation": Text("Deviation"),
    "contents": Text("Contents"),
    "inputs": Text("Inputs"), "notes": Text("Assumptions"), "formulas": Text("Formulas"), "results": Text("Results"),
    "proposals": Text("Proposed remedies"), "tables": Text("Tables"), "checks": Text("Checks"),
    "figures": Text("Figures"),
    "figure": Text("Figure"), "summary": Text("Summary"), "defaults": Text("* default of the program, not given in "
                                                                           "the design file."),
    "remarks": REMARKS,
    "left_out": Text("Left out, chosen by the program where it is needed: {names}."),
    "substitution": Text(
        "Numbers are substituted in SI units (m, kg, s, N, Pa, W; angles in rad, temperatures in °C); a vector in the "
        "plane is "
        "written length∠angle. The result stands in the unit given."
    ),
    "ranges": Text("(a … b: n) stands for n values, a the first and b the last of them."),
    "limit_is": Text("Limit {limit}: {source}."), "also_judged": Text("Also judged: {checks}."),
    "no_formula": Text("The number comes from a solution, or from inputs, and from no one formula."),
    "more_twins": Text("{count} more"), "used": Text("used {share}"),
    "soft_hold": plural(
        "{n} check of good practice or of the method holds as well; it stands in the audit report.",
        "{n} checks of good practice or of the method hold as well; they stand in the audit report.",
        n=0,
    ),
    "kinds": Text(
        "Limits not kept fail; kept by less than {margin} they warn, unless chosen to be used up. Cautions not kept "
        "warn; advice and "
        "method give notes."
    ),
    "outside_of": Text("Not called a pass: the formula is used outside what it is made for ({name}: {value}, should "
                       "be {limit})."),
    "counted_outside": plural("{n} holds outside the validity of its formula", "{n} hold outside the validity of "
                                                                               "their formulas", n=0),
    "accepted_because": Text("Accepted: {reason}"),
    "with_values": Text("With {values}."),
    "as_in": Text("as in {number}"),
    "from_inputs": Text("Inputs: {values}."), "outside": Text("kept, outside validity"), "proofs": Text("Proofs"),
    "kept_checks": Text("What holds"), "verdicts_of": Text("Findings"), "key_values": Text("Key values"),
    "key_results": Text("Key results"),
    "purpose": Text("Purpose"), "scope": Text("Scope"),
    "judges": Text("To judge {steps} of {engine}."),
    "judges_alone": Text("To judge {steps}."), "requirement": Text("Requirement"), "asked": Text("Asked"),
    "owner": Text("Owner"),
    "assumptions": Text("Assumptions, and what they put at risk"), "no": Text("No."), "assumed": Text("Assumed"),
    "at_worst": Text("At its worst"),
    "load_cases": Text("Load cases that govern"), "failures": Text("What fails, and what it takes"),
    "warnings": Text("What warns"), "warns_most": Text("Warns most"),
    "worst_warning": Text("{name}: {value}, needs {limit}"), "it_takes": Text("It takes"),
    "with_more": Text("{name}; {n} more with it"),
    "further": plural("and {n} more, which is less bad", "and {n} more, which are less bad", n=0),
    "more_left": plural("For {n} more nothing was found.", "For {n} more nothing was found.", n=0),
    "not_verified_title": Text("Not verified"), "to_give": Text("To be given"), "not_covered": Text("Not covered"),
    "concluded": Text("Every limit that is judged holds; {open}."),
    "concluded_pass": Text("Every limit that is judged holds."),
    "concluded_fail": Text("As it stands it does not hold: {open}."),
    "concluded_not_verified": Text("No limit fails, but not every one is judged: {open}."),
    "concluded_blocked": Text("Not every step could be calculated: {open}."),
    "concluded_no_solution": Text("Not every step has a solution: {open}."),
    "once_given": Text("It can be called a pass or a failure once what is missing is given."),
    "mended_whole": Text("With the changes below none fails; then {state}."),
    "mended_part": Text("The changes below mend a part of it; then {state}."),
    "mended_nothing": Text("No change was found that mends it."),
    "nearest_left": Text("{name}: nothing was found, {why}."),
    "errata_count": plural(
        "{n} value of a source is corrected; the engineer report says where the source is wrong, and why.",
        "{n} values of sources are corrected; the engineer report says where the sources are wrong, and why.",
        n=0,
    ),
    "zero_values": Text("Zero throughout, not shown: {names}."), "more": Text("and {count} more, in the audit report"),
    "others": Text("further: {values}"), "more_proposals": Text("and {count} more, in the engineer report"),
    "balancing": Text("Balancing sheet"),
    "drawing": Text("Drawing sheet"), "index": Text("Index of values"), "nomenclature": Text("Nomenclature"),
    "in_si": Text("Formulas take SI units: m, kg, s, N, Pa, W, rad."),
    "nomenclature_note": Text("Symbol, meaning, unit and first page, by chapter; the value stands there."),
    "materials": Text("Oils and materials"), "oil": Text("Oil"),
    "material": Text("Material"), "design_note": Text("Note"), "sources": Text("Sources"),
    "measured": Text("Measured"), "run": Text("Rows of the run of the bench that are used"),
    "drive": Text("Whole drive"), "front": Text("The front that this drive is one of"), "used_in": Text("Used in"),
    "sources_note": Text("Clauses, equations and tables by publication; beside each formula stands the one it was "
                         "taken from."),
    "sources_rest": Text(
        "The publications behind what stands in this report; the clause stands beside each formula. The audit report "
        "has all of them."
    ),
    "standards": Text("Standards and rules"), "literature": Text("Books and papers"),
    "title": Text("Title and edition"),
    "status": Text("Status"), "how_known": Text("How we know it"), "remembered": Text("* as far as we remember."),
    "own": Text("Definitions and rules without a publication"), "not_asked_text": Text("the design file has no table "
                                                                                       "[{key}]."),
    "blocked_text": Text("this step {reason}."), "no_solution_text": Text("{reason}."), "no_checks": Text("no checks"),
    "no_limits": Text("no limits"),
    "held": plural("{n} limit holds", "{n} limits hold", n=0), "of_judged": Text("of {count} judged"),
    "held_cautions": plural("{n} caution holds", "{n} cautions hold", n=0),
    "unused": Text("not used: {steps}"), 
    "open_advice": plural("{n} piece of advice", "{n} pieces of advice", n=0),
    "open_method": plural("{n} note on the method", "{n} notes on the method", n=0),
    "counted_attention": Text("What is open: {findings}"),
    "missing_glyphs": Text("▯ stands for a character that this report's font does not have; the attached file has it."),
    "comparison": Text("Comparison of two designs"), "design": Text("Design"),
    "verdicts": Text("Verdicts of the steps"), "equal": EQUAL,
    "moved": Text("Checks whose verdict moved"), "lone": Text("Checks of one design only that do not pass"),
    "kept": Text("Checks that keep their verdict at another value or limit"),
    "attached_pair": Text(
        "Both design files are attached to this document, as a.toml and b.toml; `contralbero verify` solves them "
        "again and compares."
    ),
    "more_differ": Text("What differs in all: {checks}, {values}; `contralbero compare --all` lists them."),
    "lone_values": plural(
        "{n} check or value stands in one design only and is not shown; `contralbero compare --all` lists it.",
        "{n} checks and values stand in one design only and are not all shown; `contralbero compare --all` lists them.",
        n=0,
    ),
    "docx_note": Text(
        "{program}, design file sha256 {sum}. A copy to go on writing with: anybody can change it. The record is the "
        "PDF report, which "
        "`contralbero verify` checks."
    ),
    "together": Text("All shafts together"),
    "mirrors": Text(
        "The mirror image of {of}, at {ratio} × crank speed. Its drawing, bearings and bending are those of {of}, as "
        "is all that is not said here."
    ),
    "repeats": Text(
        "{of} once more about an axis of its own, at {ratio} × crank speed. Its drawing, bearings and bending are "
        "those of {of}, as is all that is not said here."
    ),
    "mirrors_own": Text(
        "The mirror image of {of}, at {ratio} × crank speed, in bearings of its own. Its drawing is that of {of}, as "
        "is all that is not said here."
    ),
    "repeats_own": Text(
        "{of} once more about an axis of its own, at {ratio} × crank speed, in bearings of its own. Its drawing is "
        "that of {of}, as is all that is not said here."
    ),
    "two": Text("{name} (continued)"), "between": Text("{count} more; {total} in all"),
}  # fmt: skip

STATE_COLOURS: dict[str, Colour] = {
    "pass": (0.0, 0.42, 0.31),
    "warn": (0.66, 0.40, 0.0),
    "fail": (0.75, 0.16, 0.0),
    "computed": (0.0, 0.42, 0.31),
    "not_judged": (0.35, 0.35, 0.35),
    "blocked": (0.35, 0.35, 0.35),
    "not_asked": (0.45, 0.45, 0.45),
    "no_solution": (0.75, 0.16, 0.0),
    "note": (0.35, 0.35, 0.35),
    "not_verified": (0.66, 0.40, 0.0),
    "accepted": (0.0, 0.42, 0.31),
    "outside": (0.35, 0.35, 0.35),
}
STATE_PANELS: dict[str, Colour] = {
    "pass": (0.92, 0.97, 0.94),
    "warn": (0.99, 0.96, 0.88),
    "not_verified": (0.99, 0.96, 0.88),
    "fail": (0.99, 0.93, 0.90),
    "no_solution": (0.99, 0.93, 0.90),
}


def verdict(words: dict[str, str], state: str) -> str:
    """Sign and word: readable without colour."""
    return f"{SIGNS.get(state, SIGNS['note'])} {words[state]}"
