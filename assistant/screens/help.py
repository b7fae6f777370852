# SPDX-License-Identifier: Apache-2.0
"""Help: about the field or the check that has the focus and the keys that matter, on one page; behind it the screen and
all keys."""

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Vertical, VerticalScroll
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Static

from calc.design.labels import Place, label_of
from calc.design.model import STEPS
from calc.design.toml_file import REMARKS
from calc.sheet.expression import plain, symbol
from calc.sheet.text import COMMA, Amount, Text

from ..actions import ACTIONS, BY_ID, ELSEWHERE, bound, is_typed, key_names
from ..base_app import BaseApp
from ..session.guide import GUIDES, title_of
from ..widgets.checks import Checks
from ..widgets.headings import ArrayHeading, TableHeading
from ..widgets.rows import allowed, meaning
from ..widgets.text import wrap
from .dialogs import Once
from .workbench_panes import WorkbenchPanes

SCREEN = (
    Text(
        "Seven steps lead from the engine to the friction of the train and, where it is wanted, to what the engine "
        "stands on. Each has inputs, and from them checks, its calculation, and curves."
    ),
    Text(
        "Everything is solved again while you type. Any step can be opened at any time; one that lacks numbers says "
        "what it waits for."
    ),
    Text(
        "A field takes 3,5 or 3.5, 1.2e-3, another unit behind the number (3.7 in, 58 psi, 43 Hz), "
        "and a list with semicolons (-167.5; 167.5)."
    ),
    Text("(auto) stands where the program chooses because a field is empty."),
    Text(
        "What can not be understood, or is not allowed, stays in its field with the reason; the results stay those of "
        "the last valid input."
    ),
    Text(
        "A limit passed over is a FAIL; a caution passed over, or a limit kept narrowly, a warn; advice a note; ? "
        "lacks a number."
    ),
    Text("Enter on a check, a line or a value walks back through its formulas to the inputs."),
    Text(
        "Letters act as keys while no field is being edited: Esc leaves a field, or first takes back what is being "
        "typed."
    ),
    Text(
        "← → read a curve off at a cursor, which stays where it is while the inputs change; a limit is a chain line "
        "with its name on it."
    ),
    Text("Edits are kept aside as you work and come back after a crash; nothing is in the file before you save."),
    Text("The same numbers on the command line: contralbero check, explain, report, set, replay."),
)
INDENT = 27  # cells for the keys
WANTED = (  # what one wants, and the actions that do it
    (Text("Go on"), ("go_on", "next", "back", "palette")),
    (Text("See why"), ("trouble", "explain", "view")),
    (Text("Mend"), ("fix", "choose")),
    (Text("Take back"), ("undo",)),
    (Text("Write"), ("save", "report")),
)
GROUP, KEY = 12, 8  # cells of a group's name, and of a key
TALL = 32  # rows of a screen on which each key has a row of its own

KINDS = {
    "limit": Text("Limit: passed over it fails, and with less than 5 % of margin it is narrow and warns."),
    "caution": Text(
        "Caution: the design holds, but a slightly different one might not; it can be accepted with a reason."
    ),
    "advice": Text("Advice: good practice or a possible improvement. Passed over it is a note."),
    "method": Text("Method: about the calculation, not the part. Passed over it is a note."),
}


class HelpScreen(Once, ModalScreen[None]):
    app: BaseApp
    AUTO_FOCUS = ""
    BINDINGS: ClassVar[list[BindingType]] = [
        *(bound(id, "dismiss_help") for id in ("leave", "close", "go_on")),
        bound("help", "turn"),
        bound("save", "app.save"),
    ]

    def __init__(self, work: WorkbenchPanes) -> None:
        super().__init__()
        self.work = work

    def compose(self) -> ComposeResult:
        self.set_class(self.app.ascii, "-ascii")
        say = self.app.say
        with Vertical(classes="dialog -tall"):
            with VerticalScroll(id="help-text"):
                yield Static(Content("\n").join(self.about_here()), id="help-here")
            yield Static(self.wanted(), id="help-wanted")
            with VerticalScroll(id="help-all"):
                yield Static(
                    Content("\n").join([Content.styled(say(Text("This screen")), "bold"), *self.paragraphs(SCREEN)])
                )
                yield Static(self.keys())
            yield Static(id="help-foot")

    def on_mount(self) -> None:
        self.show_page(False)

    def show_page(self, all: bool) -> None:
        """The one page, or what is behind it."""
        for id, shown in (("#help-text", not all), ("#help-wanted", not all), ("#help-all", all)):
            self.query_one(id).display = shown
        foot = (
            Text("↑ ↓ scroll   {key} goes back to the page before   Esc closes", key=self.app.shown_key("help"))
            if all
            else Text("{key} once more: all keys   ↑ ↓ scroll   Esc closes", key=self.app.shown_key("help"))
        )
        self.query_one("#help-foot", Static).update(Content.styled(self.app.say(foot), "dim"))
        # now, and not after the keys that are waiting
        self.set_focus(self.query_one("#help-all" if all else "#help-text"))

    def action_turn(self) -> None:
        self.show_page(not self.query_one("#help-all").display)

    # --- what it says
    @property
    def room(self) -> int:
        """The cells of a row in the dialog."""
        return max(30, min(110, self.app.size.width * 9 // 10) - 8)

    def paragraphs(self, texts: tuple[Text, ...]) -> list[Content]:
        return [Content(row) for text in texts for row in wrap(f"· {self.app.say(text)}", self.room, 2)]

    def described(self, keys: str, letters: str, text: Text) -> Content:
        """One row of the table of keys, with the text hanging beside them."""
        rows = wrap(" " * INDENT + self.app.say(text), self.room, INDENT)
        start = f"{keys:<16}{letters:<{INDENT - 16}}"
        return Content("\n").join([Content.assemble((start, "bold"), rows[0][INDENT:]), *map(Content, rows[1:])])

    def about_here(self) -> list[Content]:
        """About what has the focus."""
        work, say = self.work, self.app.say
        field = work.form.field
        lines: list[Content] = []
        if field is not None:
            lines = self.about_field(field.place)
        elif isinstance(work.focused, (ArrayHeading, TableHeading)):
            lines = self.about_heading(work.focused)
        elif isinstance(work.focused, Checks) and work.session.results is not None:
            lines = self.about_check(work.focused.key)
        if not lines:
            step, title = work.step, title_of(work.step, work.session.data)
            outcome = work.session.results.outcomes[step.key] if work.session.results is not None else None
            lines = [
                Content.styled(
                    say(Text("Step {n} of {count}: {title}", n=work.number, count=len(STEPS), title=title)), "bold"
                )
            ]
            texts = (*outcome.proposals, *outcome.notes) if outcome is not None else ()
            lines += [Content(f"· {say(text)}") for text in texts]
            if outcome is not None and outcome.reason:
                lines.append(Content(say(outcome.reason)))
        guide = GUIDES[work.step.key]
        lines += [
            Content(""),
            Content.styled(
                say(Text("In step {n}, {title}", n=work.number, title=title_of(work.step, work.session.data))), "bold"
            ),
        ]
        for word, text in ((Text("Decide"), guide.decide), (Text("Good"), guide.good), (Text("Try"), guide.trying)):
            lines += [Content(row) for row in wrap(f"{say(word)}: {say(text)}", self.room, 2)]
        return lines

    def about_field(self, place: Place) -> list[Content]:
        session, say = self.work.session, self.app.say
        about = session.about(place)
        key = ".".join(map(str, place))
        unit = f", {say(Text('in {unit}', unit=about.unit))}" if about.unit else ""
        sign = f"   {say(plain(symbol(about.symbol)))}" if about.symbol else ""
        explanation = f"{meaning(about, say, sourced=False)} {allowed(about, say)}".strip()
        lines = [Content.assemble((say(about.label), "bold"), sign, (f"   {key}{unit}", "dim")), Content(explanation)]
        if about.source:
            lines.append(Content.styled(say(Text("Source: {source}", source=about.source)), "dim"))
        if about.kind == "choice":
            lines.append(Content(say(Text("Allowed: {allowed}.", allowed=about.allowed()))))
        if about.optional:
            lines.append(
                Content(
                    say(Text("May be left empty: the program then chooses and says so, or leaves out what needs it."))
                )
            )
        if remark := session.remark(place):
            lines.append(Content(say(Text(REMARKS.template, remarks=f"“{remark}”"))))
        if reason := session.reason(place):
            lines.append(
                Content.styled(f"{self.app.signs.mark('invalid')} {say(reason)}", self.app.signs.style("invalid"))
            )
        return lines

    def about_heading(self, heading: ArrayHeading | TableHeading) -> list[Content]:
        about, key = heading.row.about, ".".join(map(str, heading.row.place))
        lines = [
            Content.assemble((self.app.say(about.label), "bold"), (f"   {key}", "dim")),
            *([Content(self.app.say(about.help))] if about.help else []),
        ]
        lines.append(Content(self.app.say(heading.does())))
        if heading.reason:
            lines.append(
                Content.styled(
                    f"{self.app.signs.mark('invalid')} {self.app.say(heading.reason)}", self.app.signs.style("invalid")
                )
            )
        return lines

    def about_check(self, id: str) -> list[Content]:
        results, say = self.work.session.results, self.app.say
        check = next((c for c in results.checks() if c.id == id), None) if results is not None else None
        if check is None:
            return []
        judged = Text(
            "{value}, {limit}, margin {margin}: {verdict}",
            value=Amount(check.value, check.unit),
            limit=check.limit_text(),
            margin=check.margin_text(),
            verdict=self.app.signs.word(check.verdict),
        )
        return [
            Content.assemble((say(check.name), "bold"), (f"   {check.id}", "dim")),
            Content(say(judged)),
            *([Content(say(check.to_do))] if check.to_do else []),
            *([Content(say(Text("Accepted: {reason}", reason=check.accepted)))] if check.accepted else []),
            *([Content(say(Text("Not known: {keys}.", keys=", ".join(check.missing))))] if check.missing else []),
            *(
                [
                    Content(
                        say(
                            Text(
                                "Moved most by: {keys}",
                                keys=COMMA.join(label_of(self.app.session.data, key) for key in check.moved_by),
                            )
                        )
                    )
                ]
                if check.moved_by
                else []
            ),
            Content(say(KINDS[check.kind])),
            Content.styled(say(Text("Source: {source}", source=check.source)), "dim"),
        ]

    def key_of(self, id: str) -> str:
        """The first key of an action."""
        return self.app.say(self.app.shown_key(id))

    def wanted(self) -> Content:
        """The keys that matter, by what one wants: a row for each where there is room, else for each group."""
        say, tall = self.app.say, self.app.size.height >= TALL
        lines = [Content.styled(say(Text("What you want")), "bold")]
        for name, ids in WANTED:
            group = f"{say(name):<{GROUP}}"
            actions = [(self.key_of(id), BY_ID[id]) for id in ids]
            if not tall:
                line = "   ".join(f"{key} {say(action.title)}" for key, action in actions)
                rows = wrap(" " * GROUP + line, self.room, GROUP)
                lines += [Content.assemble((group, "$primary bold"), rows[0][GROUP:]), *map(Content, rows[1:])]
                continue
            for n, (key, action) in enumerate(actions):
                help_text = Text("{title}. {help}", title=action.title, help=action.help)
                rows = wrap(" " * (GROUP + KEY) + say(help_text), self.room, GROUP + KEY)
                start = Content.assemble(
                    ("" if n else group, "$primary bold"), " " * (GROUP if n else 0), (f"{key:<{KEY}}", "bold")
                )
                lines += [start + rows[0][GROUP + KEY :], *map(Content, rows[1:])]
        return Content("\n").join(lines)

    def keys(self) -> Content:
        """Every key, from the table of actions and the user's key map."""
        say = self.app.say
        lines = [
            Content(""),
            Content.styled(self.app.say(Text("Keys")), "bold"),
            Content.styled(
                f"{say(Text('anywhere')):<16}{say(Text('no field')):<{INDENT - 16}}{say(Text('does'))}", "dim"
            ),
        ]
        for action in (*ACTIONS, *ELSEWHERE):
            known = self.app.keys_of(action.id)
            typed = [key for key in known if is_typed(key) or key in action.letters.split(",")]
            keys = key_names([key for key in known if key not in typed], say)
            letters = key_names(typed, say)
            lines.append(self.described(keys, letters, Text("{title}. {help}", title=action.title, help=action.help)))
        lines.append(self.described("Tab Shift+Tab", "", Text("Next, previous field or pane.")))
        lines.append(
            self.described(
                "← →",
                "",
                Text("On the heading of a list of elements: leaf through them."),
            )
        )
        return Content("\n").join(lines)

    def action_dismiss_help(self) -> None:
        self.dismiss(None)
