# SPDX-License-Identifier: Apache-2.0
"""Every action of the user, once: its keys, its word in the footer, its title and what it does.

Bindings, footer, help screen and palette read this table, so they can not disagree.  `keys` act anywhere; `letters` act only
while no field is being edited, because a field takes them as text, or moves in its text with them.  The first key is the one that is
shown.
"""

from dataclasses import dataclass

from calc.design import STEPS


@dataclass(frozen=True)
class Action:
    """`id` names the binding, in a key map too.  `call` is the method `action_…` of the main screen; left out, it is called like the id."""

    id: str
    keys: str
    letters: str
    footer: str  # empty: not in the footer
    title: str
    help: str
    call: str = ""

    @property
    def does(self) -> str:
        return self.call or self.id

    @property
    def binding(self) -> str:
        return ",".join(part for part in (self.keys, self.letters) if part)


ACTIONS: tuple[Action, ...] = (
    Action("help", "f1", "question_mark", "Help", "Help",
           "Explains the field, the check or the step that you are at, and lists all keys."),
    Action("back", "f2,pageup", "left_square_bracket", "Back", "Previous step",
           "Goes to the step before. Page up scrolls inside a long list."),
    Action("next", "f3,pagedown", "right_square_bracket", "Next", "Next step",
           "Goes to the step after. Page down scrolls inside a long list."),
    Action("view", "f4", "v", "View", "Other view",
           "Narrow: inputs, checks, calculation, curve in turn. Wide: makes the pane large, and small again."),
    Action("mend", "f5", "m", "Mend", "Mend what fails",
           "Applies the remedy that the message line offers: the nearest change by which the limits of the step hold. Undo takes it back."),
    Action("choose", "ctrl+t", "t", "Choose", "Choose from a table",
           "Searches for this step: firing orders, counter-shafts, bearings or profile shifts, ranked; shows what each does to all steps."),
    Action("guide", "", "G", "", "Guide on and off", "Shows at the head of each form what is to be decided, or leaves it out."),
    Action("pane", "f6", "l", "Pane", "Next pane", "Moves to the next pane.", call="pane(1)"),
    Action("pane_back", "shift+f6", "h", "", "Previous pane", "Moves to the pane before.", call="pane(-1)"),
    Action("trouble", "f7", "n", "Fault", "Next fault", "Goes to the next check that fails or warns, and to its step."),
    Action("explain", "", "x", "", "Explain",
           "Walks back from the value, the check or the line that you are at, through its formulas to the inputs. So does Enter."),
    Action("line", "", "g", "", "Go to the line", "On a check: goes to the line of the calculation that gives its value."),
    Action("report", "f8", "p", "PDF", "PDF report", "Writes the calculation report beside the design file."),
    Action("export", "", "E", "", "Export …",
           "Writes a drawing of the shaft or the gears (.dxf), the values (.csv), all results (.json) or the report (.pdf)."),
    Action("curve", "f9", "c", "Plot", "Next curve",
           "Shows the next curve of the step; after the curves its tables. In the pane itself Space does so too."),
    Action("curve_back", "", "backspace", "", "Curve before", "Shows the curve or table before."),
    Action("curves", "shift+f9", "C", "", "List of curves and tables", "Lists all curves and tables of the step, to be found by words."),
    Action("read", "", "right", "", "Cursor to the right",
           "On a curve: reads it off at a cursor, with the distance to its limits. ↑ ↓ choose the line, Esc takes the cursor away. "
           "On a table that is too wide: further columns.", call="read(1)"),
    Action("read_back", "", "left", "", "Cursor to the left", "The same, to the left.", call="read(-1)"),
    Action("read_fine", "", "shift+right", "", "Cursor a little to the right",
           "A tenth of a step; on a locus or an outline the next point.", call="read(1, True)"),
    Action("read_fine_back", "", "shift+left", "", "Cursor a little to the left", "The same, to the left.", call="read(-1, True)"),
    Action("read_first", "", "home", "", "Cursor to the beginning", "On a curve: reads it off at its first point.", call="read_end(False)"),
    Action("read_last", "", "end", "", "Cursor to the end", "On a curve: reads it off at its last point.", call="read_end(True)"),
    Action("variant", "f10", "b", "Variant", "Next variant of the curve",
           "Shows the other variant of the curve, in the same scale: without the counter-shaft, and with it."),
    Action("crank_on", "", "greater_than_sign", "", "Turn the crank on", "Turns the vectors of a curve on by 10°.", call="crank(1)"),
    Action("crank_back", "", "less_than_sign", "", "Turn the crank back", "Turns the vectors of a curve back by 10°.", call="crank(-1)"),
    Action("undo", "ctrl+z", "u", "Undo", "Undo", "Takes back the last edit of the design; the edits of one field in a row are one."),
    Action("redo", "ctrl+y", "r", "", "Redo", "Makes the edit again that was taken back."),
    Action("save", "ctrl+s", "w", "Save", "Save",
           "Saves the design; the file as it was stays as .bak. The example is saved under its name in the current folder."),
    Action("save_as", "f12", "W", "", "Save as …", "Saves the design under another name and goes on with that file."),
    Action("open", "ctrl+o", "o", "", "Open …", "Opens another design."),
    Action("reload", "", "L", "", "Read the file anew",
           "Takes what another program has written into the file, or drops all unsaved edits. Undo takes it back."),
    Action("record", "", "R", "", "Record a replay",
           "Records every edit from here on; pressed again it writes them as a replay file, with what the design came to."),
    Action("compare", "shift+f7", "equals_sign", "", "Compare with …",
           "Sets the design beside its saved file, an earlier state or another design, what differs first."),
    Action("palette", "ctrl+p", "colon", "palette", "Palette", "Finds any action, step or field by a few letters."),
    Action("down", "down", "j", "", "Next field or line", "Moves down: to the next field, check or line."),
    Action("up", "up", "k", "", "Previous field or line", "Moves up: to the field, check or line before."),
    Action("go_on", "enter", "", "", "Accept, go there",
           "In a field: accepts it and goes on. On “+ add”: adds. On a check or a line: explains it. On a step: opens it."),
    Action("more", "shift+up", "", "", "One step more", "In a field: raises the number by one increment.", call="nudge(1)"),
    Action("less", "shift+down", "", "", "One step less", "In a field: lowers the number by one increment.", call="nudge(-1)"),
    Action("leave", "escape", "", "", "Leave the field",
           "Leaves the field, so that letters act as keys. Takes nothing back; undo does that."),
    Action("copy", "", "y", "", "Copy the value",
           "Copies the value that you are at: of the field, the check or the line, or of a curve at its cursor."),
    Action("copy_line", "", "Y", "", "Copy the line",
           "Copies the whole line: of the formula with its numbers and source, of the check, or all that is read off a curve."),
    Action("quit", "ctrl+q", "q", "Quit", "Quit",
           "Ends the program. Unsaved edits are kept and come back with the next start."),
    *(Action(f"step_{n}", "", str(n), "", f"Step {n}: {step.title}", f"Goes to step {n}, {step.title}.", call=f"step({n})")
      for n, step in enumerate(STEPS, 1)),
)  # fmt: skip

BY_ID = {action.id: action for action in ACTIONS}

KEY_NAMES = {
    "question_mark": "?", "left_square_bracket": "[", "right_square_bracket": "]", "colon": ":", "equals_sign": "=",
    "greater_than_sign": ">", "less_than_sign": "<", "escape": "Esc", "enter": "Enter", "pageup": "PgUp", "pagedown": "PgDn",
    "up": "↑", "down": "↓", "left": "←", "right": "→", "backspace": "Backspace", "home": "Home", "end": "End",
}  # fmt: skip


def key_name(key: str) -> str:
    """A key as it is printed on the keyboard: F1, ^s, Shift+F6."""
    *modifiers, name = key.split("+")
    shown = KEY_NAMES.get(name, name.upper() if name[:1] == "f" and name[1:].isdigit() else name)
    if "ctrl" in modifiers:
        shown = f"^{shown}"
    return "Shift+" + shown if "shift" in modifiers else shown


def key_names(keys: str) -> str:
    return " ".join(key_name(key) for key in keys.split(",") if key)
