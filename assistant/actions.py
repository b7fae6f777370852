# SPDX-License-Identifier: Apache-2.0
"""Every action of the user, once: its keys, its word in the footer, its title and what it does.

Bindings, footer, help screen and palette read this table, so they can not disagree.  `keys` act anywhere; `letters` act
only while no field is being edited, because a field takes them as text, or moves in its text with them.  The first key
is the one that is shown, so what a message may name while a field is edited has one in `keys`.

A key stands here once, and means the same on every screen: whatever binds it takes it from here, with `bound`.  Only
the keys that move (`MOVING`) do in each place what that place is moved through with.  A user's key map goes by the
ids."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from textual.binding import Binding

from calc.design.model import STEPS
from calc.locale import Language
from calc.sheet.text import EMPTY, Text


@dataclass(frozen=True)
class Action:
    """`id` names the binding, in a key map too.  `call` is an action of the main screen, its method without `action_`,
    and its arguments; left out, it is called like the id.  `first`: the key is not the field's that has the focus."""

    id: str
    keys: str
    letters: str
    footer: Text  # empty: not in the footer
    title: Text
    help: Text
    call: tuple[Any, ...] = ()
    first: bool = False

    @property
    def does(self) -> str:
        """What a binding or a link of the main screen runs."""
        return f"act('{self.id}')"

    @property
    def binding(self) -> str:
        return ",".join(part for part in (self.keys, self.letters) if part)


ACTIONS: tuple[Action, ...] = (
    Action("help", "f1", "question_mark", Text("Help"), Text("Help"),
           Text("Explains the field, the check or the step that you are at, and lists all keys.")),
    Action("back", "f2,pageup", "left_square_bracket", Text("Back"), Text("Previous step"),
           Text("Goes to the step before. Page up scrolls inside a long list."), call=("turn_step", -1)),
    Action("next", "f3,pagedown", "right_square_bracket", Text("Next"), Text("Next step"),
           Text("Goes to the step after. Page down scrolls inside a long list."), call=("turn_step", 1)),
    Action("view", "f4", "v", Text("View"), Text("Other view"),
           Text("Findings, calculation and curve in turn; on a narrow screen the inputs and the picture as well.")),
    Action("enlarge", "shift+f4", "z", EMPTY, Text("Pane large and small"),
           Text("Makes the pane that you are in fill the screen, and small again.")),
    Action("fix", "f5", "m", Text("Remedy"), Text("Remedies: what would help"),
           Text("Lists remedies of different kinds for the finding that you are at, with what each does to every "
                "step, to power and mass. "
                "Undo takes one back."), call=("remedies",)),
    Action("choose", "ctrl+t", "t", Text("Choose"), Text("Choose from a table"),
           Text("Searches for this step: firing orders, counter-shafts, bearings or profile shifts, ranked; shows "
                "what each does to all "
                "steps.")),
    Action("drive", "", "T", EMPTY, Text("Whole drive"),
           Text("Searches every combination of shaft and bearings that keeps what is asked of it: power, mass, seat, "
                "price and margin against each other; one is taken as one step of the undo.")),
    Action("fit", "", "F", EMPTY, Text("Fits"),
           Text("In a design with [[fits]]: finds their inputs from runs of the bench, and says whether the runs "
                "determine them; what is identified is taken as one step of the undo.")),
    Action("guide", "", "G", EMPTY, Text("Guide on and off"),
           Text("Shows below the question of each step what is good there or worth trying, or leaves it out.")),
    Action("pane", "f6", "l", Text("Pane"), Text("Next pane"), Text("Moves to the next pane."), call=("turn_pane", 1)),
    Action("pane_back", "shift+f6", "h", EMPTY, Text("Previous pane"), Text("Moves to the pane before."),
    call=("turn_pane", -1)),
    Action("trouble", "f7", "n", Text("Finding"), Text("Next finding"),
           Text("Goes to the next check that fails or warns, and to its step.")),
    Action("explain", "", "x", EMPTY, Text("Explain"),
           Text("Walks back from the value, the check or the line that you are at, through its formulas to the "
                "inputs. So does Enter.")),
    Action("line", "", "g", EMPTY, Text("Go to the line"), Text("On a check: goes to the line of the calculation that "
                                                                "gives its value.")),
    Action("accept", "shift+f5", "a", EMPTY, Text("Accept a finding"),
           Text("On a finding that is no limit: asks for the reason why it may stay open, which stands in the report; "
                "once more takes it "
                "back.")),
    Action("lock", "ctrl+l", "", EMPTY, Text("Lock an input, or unlock it"),
           Text("In a field: no remedy and no search may change this input then. In the list of remedies: the input "
                "that the row changes.")),
    Action("leave_out", "", "minus", EMPTY, Text("Leave the step out"),
           Text("In a step that the design does not have: asks why it does without it, in your words, which stand in "
                "the report. On the heading of a list or of a part: takes it out.")),
    Action("build_all", "ctrl+g", "B", EMPTY, Text("Build all that is left"),
           Text("Builds every step that is still to do by the rules, as one step of the undo, and shows what it came "
                "to.")),
    Action("ready", "", "D", EMPTY, Text("Ready?"),
           Text("Shows the whole drive with its main numbers, what is assumed and accepted, and what is left to do.")),
    Action("not_counted", "", "i", EMPTY, Text("What is not counted"),
           Text("Shows on the same page what acts on these parts and no input describes: it is in no verdict."),
           call=("ready", "not_counted")),
    Action("report", "f8", "p", Text("PDF"), Text("PDF report"), Text("Writes the calculation report beside the "
                                                                      "design file.")),
    Action("export", "", "E", EMPTY, Text("Export …"),
           Text("Lists the files that a design can be written to, for other programs and the shop, and writes one. In "
                "the list of remedies: its rows as a table.")),
    Action("curve", "f9", "c", Text("Plot"), Text("Next curve"),
           Text("Shows the next curve of the step; after the curves its tables. In the pane itself Space does so too."),
           call=("turn_curve", 1)),
    Action("curve_back", "", "backspace", EMPTY, Text("Curve before"), Text("Shows the curve or table before."),
    call=("turn_curve", -1)),
    Action("curves", "shift+f9", "C", EMPTY, Text("List of curves and tables"),
           Text("Lists all curves and tables of the step, to be found by words.")),
    Action("pixels", "", "P", EMPTY, Text("Curve in pixels"),
           Text("Shows the curve as the report has it, where the terminal can show pixels (Kitty, iTerm2, WezTerm, "
                "Sixel).")),
    Action("read", "", "right", EMPTY, Text("Cursor to the right"),
           Text("On a curve: reads it off at a cursor, with the distance to its limits. ↑ ↓ choose the line, Esc "
                "takes the cursor away. "
                "On a table that is too wide: further columns."), call=("read", 1)),
    Action("read_back", "", "left", EMPTY, Text("Cursor to the left"), Text("The same, to the left."), call=("read",
    -1)),
    Action("read_fine", "", "shift+right", EMPTY, Text("Cursor a little to the right"),
           Text("A tenth of a step; on a locus or an outline the next point."), call=("read", 1, True)),
    Action("read_fine_back", "", "shift+left", EMPTY, Text("Cursor a little to the left"),
           Text("The same, to the left."), call=("read", -1, True)),
    Action("read_first", "", "home", EMPTY, Text("Cursor to the beginning"),
           Text("On a curve: reads it off at its first point."), call=("read_end", False)),
    Action("read_last", "", "end", EMPTY, Text("Cursor to the end"),
           Text("On a curve: reads it off at its last point."), call=("read_end", True)),
    Action("variant", "f10", "b", Text("Variant"), Text("Next variant of the curve"),
           Text("Shows the other variant of the curve, in the same scale: without the counter-shaft, and with it; of "
                "the cycle of a mesh another load.")),
    Action("walk_on", "", "full_stop", EMPTY, Text("Cycle at the next speed"),
           Text("Shows the working cycle of a mesh at the next higher speed, from idle to rated. In the picture's "
                "pane: the next of its pictures. Among whole drives: the next larger seat."), call=("walk", 1)),
    Action("walk_back", "", "comma", EMPTY, Text("Cycle at the speed before"),
           Text("Shows the working cycle of a mesh at the next lower speed. In the picture's pane: the picture "
                "before. Among whole drives: smaller seats alone."), call=("walk", -1)),
    Action("crank_on", "", "greater_than_sign", EMPTY, Text("Turn the crank on"),
           Text("Turns the vectors of a curve on by 10°."), call=("crank", 1)),
    Action("crank_back", "", "less_than_sign", EMPTY, Text("Turn the crank back"),
           Text("Turns the vectors of a curve back by 10°."), call=("crank", -1)),
    Action("shaft_on", "ctrl+right", "", Text("Shaft"), Text("Next shaft"),
           Text("Where there are several balance shafts: puts the next one in view, in steps 3 to 5: its fields, its "
                "picture, its curves and values."), call=("turn_shaft", 1), first=True),
    Action("shaft_back", "ctrl+left", "", EMPTY, Text("Shaft before"),
           Text("Puts the balance shaft before in view."), call=("turn_shaft", -1), first=True),
    Action("undo", "ctrl+z", "u", Text("Undo"), Text("Undo"),
           Text("Takes back the last edit of the design; the edits of one field in a row are one.")),
    Action("redo", "ctrl+y", "r", Text("Redo"), Text("Redo"), Text("Makes the edit again that was taken back.")),
    Action("save", "ctrl+s", "w", Text("Save"), Text("Save"),
           Text("Saves the design; the file as it was stays as .bak. The example is saved under its name in the "
                "current folder.")),
    Action("save_as", "f12", "W", EMPTY, Text("Save as …"), Text("Saves the design under another name and goes on "
                                                                 "with that file.")),
    Action("new", "ctrl+n", "N", EMPTY, Text("New, or another design …"),
           Text("The start page: begin with an engine, open a design, go on with a recent one. Unsaved edits of this "
                "one are kept.")),
    Action("open", "ctrl+o", "o", EMPTY, Text("Open …"), Text("Opens another design.")),
    Action("reload", "ctrl+r", "L", EMPTY, Text("Read the file anew"),
           Text("Takes what another program has written into the file, or drops all unsaved edits. "
                 "Undo takes it back.")),
    Action("record", "shift+f12", "R", EMPTY, Text("Record a replay"),
           Text("Records every edit from here on; pressed again it writes them as a replay file, with what the design "
                "came to.")),
    Action("compare", "shift+f7", "equals_sign", EMPTY, Text("Compare with …"),
           Text("Sets the design beside its saved file, an earlier state or another design, what differs first.")),
    Action("palette", "ctrl+p", "colon", Text("All"), Text("Palette"), Text("Finds any action, step or field by a few "
                                                                            "letters.")),
    Action("down", "down", "j", EMPTY, Text("Next field or line"),
    Text("Moves down: to the next field, check or line."), call=("move", 1)),
    Action("up", "up", "k", EMPTY, Text("Previous field or line"),
           Text("Moves up: to the field, check or line before."), call=("move", -1)),
    Action("go_on", "enter", "", EMPTY, Text("Accept, go there"),
           Text("In a field: accepts it and goes on. On “+ add”: adds. On a check or a line: explains it. On a step: "
                "opens it.")),
    Action("more", "shift+up", "", EMPTY, Text("One step more"),
           Text("In a field: raises the number by one increment."), call=("nudge", 1)),
    Action("less", "shift+down", "", EMPTY, Text("One step less"),
           Text("In a field: lowers the number by one increment."), call=("nudge", -1)),
    Action("leave", "escape", "", EMPTY, Text("Leave the field"),
           Text("Takes back what is being typed; else leaves the field, so that letters act as keys. A value that was "
                "accepted stays.")),
    Action("copy", "", "y", EMPTY, Text("Copy the value"),
           Text("Copies the value that you are at: of the field, the check or the line, or of a curve at its cursor."),
           call=("copy", "value")),
    Action("copy_line", "", "Y", EMPTY, Text("Copy the line"),
           Text("Copies the whole line: of the formula with its numbers and source, of the check, or all that is read "
                "off a curve."),
           call=("copy", "line")),
    Action("quit", "ctrl+q", "", Text("Quit"), Text("Quit"),
           Text("Ends the program. Unsaved edits are kept and come back with the next start.")),
    Action("close", "", "q", EMPTY, Text("Close"),
           Text("Closes what stands over the main screen, as Esc does; there it ends the program."), call=("quit",)),
    *(Action(f"step_{n}", f"alt+{n}", str(n), EMPTY, Text("Step {n}: {title}", n=n, title=step.title),
             Text("Goes to step {n}, {title}.", n=n, title=step.title), call=("to_step", n))
      for n, step in enumerate(STEPS, 1)),
)  # fmt: skip

# of other screens alone
ELSEWHERE: tuple[Action, ...] = (
    Action("add", "", "plus", EMPTY, Text("Add"),
           Text("On the heading of a list of elements, or of a part that may be left out: adds one, as Enter does "
                "where there is none.")),
    Action("sort", "", "s", EMPTY, Text("Sort"), Text("Among whole drives: sorts by the next objective.")),
    Action("across", "", "X", EMPTY, Text("Other axis across"),
           Text("Among whole drives: another objective across.")),
    Action("upright", "", "V", EMPTY, Text("Other axis up"), Text("Among whole drives: another objective up.")),
)  # fmt: skip

BY_ID = {action.id: action for action in (*ACTIONS, *ELSEWHERE)}
# what else an action may be called; the palette finds it by that too
CALLED = {
    "fix": Text("mend repair improve solution"),
    "choose": Text("optimize optimise catalogue candidates select search"),
    "drive": Text("optimize optimise pareto cost price weight light cheap"),
    "build_all": Text("automatic generate complete the rest by rules"),
    "ready": Text("summary overview result finished done"),
    "explain": Text("why formula derivation source"),
    "report": Text("print paper document"),
    "export": Text("drawing CAD DXF print"),
    "compare": Text("difference versus"),
    "curve": Text("graph diagram chart"),
    "curves": Text("graph diagram chart"),
    "new": Text("begin start create"),
    "undo": Text("revert back"),
    "accept": Text("waive"),
    "help": Text("manual keys"),
    "quit": Text("exit"),
}
# in a list, a field, a picture or a text: what they move there, or take, or leave
MOVING = {"up", "down", "left", "right", "home", "end", "pageup", "pagedown", "tab", "enter", "space", "escape"}
MOVING |= {"backspace", "delete"}
OLD_IDS = {"mend": "fix"}  # names that key maps of earlier versions may have


def bound(id: str, does: str = "", keys: str = "") -> Binding:
    """The binding of an action on any screen: `does` is what it runs there, `keys` are those of it that a place has
    room for."""
    action = BY_ID[id]
    return Binding(keys or action.binding, does or action.does, action.title, show=False, id=id, priority=action.first)


# actions that open a screen, on which the keys that follow are meant to be struck
OPENS: tuple[str, ...] = (
    "help",
    "fix",
    "choose",
    "drive",
    "fit",
    "accept",
    "leave_out",
    "ready",
    "not_counted",
    "export",
)
OPENS += ("curves", "save_as", "new", "open", "record", "compare", "palette", "explain")
ANYWHERE = ("quit", "palette", "open")  # actions whose keys come before those of a field, also where one types


def anywhere(id: str) -> str:
    """The binding id of those keys: all that the action has but letters."""
    return f"{id}_anywhere"


KEY_NAMES: dict[str, str] = {
    "question_mark": "?",
    "plus": "+",
    "left_square_bracket": "[",
    "right_square_bracket": "]",
    "colon": ":",
    "minus": "-",
    "equals_sign": "=",
    "greater_than_sign": ">",
    "less_than_sign": "<",
    "full_stop": ".",
    "comma": ",",
    "escape": Text("Esc"),
    "enter": Text("Enter"),
    "pageup": "PgUp",
    "pagedown": "PgDn",
    "up": "↑",
    "down": "↓",
    "left": "←",
    "right": "→",
    "backspace": Text("Backspace"),
    "home": Text("Home"),
    "end": Text("End"),
}


def key_name(key: str) -> str:
    """A key as it is printed on the keyboard: F1, ^s, Shift+F6; a Text where that is a word."""
    *modifiers, name = key.split("+")
    shown = KEY_NAMES.get(name, name.upper() if name[:1] == "f" and name[1:].isdigit() else name)
    if "ctrl" in modifiers:
        shown = f"^{shown}"
    if "alt" in modifiers:
        shown = Text("Alt+{key}", key=shown)
    return Text("Shift+{key}", key=shown) if "shift" in modifiers else shown


def key_names(keys: Iterable[str], say: Language) -> str:
    return " ".join(say(key_name(key)) for key in keys)


def is_typed(key: str) -> bool:
    """Whether a key writes a character into a field."""
    return len(key) == 1 or (key in KEY_NAMES and key not in MOVING)
