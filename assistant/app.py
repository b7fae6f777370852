# SPDX-License-Identifier: Apache-2.0
"""The guided session: one screen over one `Session`.  Only what the first picture needs is imported here."""

import os
import sys
from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

os.environ.setdefault("TEXTUAL_ANIMATIONS", "none")  # read when textual is imported

from textual.app import App, SystemCommand
from textual.await_complete import AwaitComplete
from textual.binding import Binding, BindingType
from textual.command import CommandList, CommandPalette
from textual.screen import Screen

from calc.languages import LANGUAGES, language
from calc.sheet.errors import BadInput

from .actions import BY_ID, key_name
from .recovery import Settings
from .screens.workbench import Workbench
from .session import Session
from .widgets.item_list import ItemList
from .widgets.signs import Signs


def _palette() -> Any:
    from .screens.palette import Palette

    return Palette


LOOK = 2.0  # seconds between two looks at the file, whether another program has changed it


class Search(CommandPalette):
    """The palette; its list may be asked to turn a page before it has a place on the screen, and would fail."""

    def _action_command_list(self, command: str) -> None:
        if self.query_one(CommandList).size.height:
            super()._action_command_list(command)


class ContralberoApp(App[int]):
    """`ascii`: plain signs.  `key_map`: other keys for some actions, by their ids.  `settings`: what the user chose in earlier sessions."""

    CSS_PATH = "contralbero.tcss"
    TITLE = "Contralbero"
    COMMANDS = App.COMMANDS | {_palette}
    BINDINGS: ClassVar[list[BindingType]] = [Binding("ctrl+q", "quit", "Quit", show=False, priority=True, id="quit_anywhere")]

    def __init__(
        self, session: Session, *, ascii: bool = False, key_map: dict[str, str] | None = None, settings: Settings | None = None
    ) -> None:
        self.ascii = ascii
        settings = settings or Settings()
        self.say = language(settings.language if settings.language in LANGUAGES else "en")
        self.signs = Signs(ascii, say=self.say)
        self.key_map = {id: keys for id, keys in (key_map or {}).items() if id in BY_ID}
        super().__init__()
        self.session = session
        self.warned_of: Path | None = None  # the file of which was said that another program has changed it
        self.writing = ""  # a file that is being written, and how far it is
        self.guiding = settings.guide  # each form begins with what is to be decided in its step
        if settings.theme in self.available_themes:
            self.theme = settings.theme
        self._theme_kept = self.theme

    def on_mount(self) -> None:
        if self.key_map:
            self.set_keymap(self.key_map)
        self.signs = Signs(self.ascii, self.current_theme.dark, not self.no_color, self.say)
        self.theme_changed_signal.subscribe(self, self._theme_changed)
        self.set_interval(LOOK, self.look)

    def get_default_screen(self) -> Screen[None]:
        """The main screen from the start: there is no other one below it that would be styled and painted for nothing."""
        return Workbench(self.session)

    def _theme_changed(self, theme: Any) -> None:
        self.signs = Signs(self.ascii, theme.dark, not self.no_color, self.say)
        if isinstance(self.screen, Workbench) and self.screen.stands:
            self.screen.show_step()
            for shown in self.screen.query(ItemList):  # their rows have colours of their own
                shown.rebuild()
        if theme.name != self._theme_kept:
            self._theme_kept = theme.name
            self.session.memory.set_setting("theme", theme.name)

    def on_app_focus(self) -> None:
        self.look()

    def look(self) -> None:
        """Say, once, that another program has changed the file."""
        if self.session.look():
            text = f"{self.session.name} was changed by another program: {self.shown_key('reload')} takes it over, and undo would return."
            self.tell(text, "warning")

    async def speak(self, code: str) -> None:
        """Go on in another language."""
        self.say = language(code)
        self.session.memory.set_setting("language", code)
        self.signs = Signs(self.ascii, self.current_theme.dark, not self.no_color, self.say)
        if isinstance(self.screen, Workbench):
            await self.screen.speak()

    def pop_screen(self) -> AwaitComplete:
        """The main screen stays, also where a key that repeats closes the palette twice."""
        return super().pop_screen() if len(self.screen_stack) > 1 else AwaitComplete()

    async def enter(self, session: Session) -> None:
        """Go on with another design; unsaved edits of this one are kept aside."""
        self.session.autosave()
        if self.session.recording is not None:
            self.tell("The recording is given up: it was one of the design before.", "warning")
        self.session = session
        if isinstance(self.screen, Workbench):
            await self.screen.enter(session)

    def shown_key(self, id: str) -> str:
        """The first key of an action, as the table and the user's key map have it."""
        return key_name((self.key_map.get(id) or BY_ID[id].binding).split(",")[0])

    def forget(self, *texts: str) -> None:
        """Take back what was said, if it still stands there."""
        said = {*texts, *map(self.say, texts)}
        for notification in [n for n in self._notifications if n.message in said]:
            self._unnotify(notification)

    def tell(self, text: str, severity: Any = "information") -> None:
        """Say something for a moment; the text is never read as markup."""
        text = self.say(text)
        self.forget(text)  # the same thing is not said twice at a time
        self.notify(text, severity=severity, markup=False, timeout=10 if severity == "error" else 5)

    def action_command_palette(self) -> None:
        """The palette, asking in the user's language."""
        if not isinstance(self.screen, CommandPalette):
            self.push_screen(Search(placeholder=self.say("Search for commands…"), id="--command-palette"))

    def search_themes(self) -> None:
        from textual.theme import ThemeProvider

        self.push_screen(Search([ThemeProvider], placeholder=self.say("Search for themes…")))

    def get_system_commands(self, screen: Screen[Any]) -> Iterable[SystemCommand]:
        say = self.say
        yield SystemCommand(
            say("Theme"), say("Other colours; ansi-dark and ansi-light take those of the terminal"), self.action_change_theme
        )
        for code, name in LANGUAGES.items():
            if code != say.code:
                yield SystemCommand(f"{say('Language')}: {name}", say("The session in this language"), partial(self.speak, code))

    def on_unmount(self) -> None:
        """However the program ends, a closed page of a browser too: edits are kept aside."""
        self.session.autosave()

    async def action_quit(self) -> None:
        """Edits are kept aside; only where that fails, or something would be lost, is there something to ask."""
        self.session.autosave()
        if self.session.safe and self.session.recording is None and not self.writing:
            self.exit(0)
            return
        from .screens.ask import Ask

        why = self.session.autosave_failure or "what was added last is not complete, and such a part is not kept"
        question = "The recorded replay is not written." if self.session.recording is not None else ""
        if self.writing:
            question = f"{self.writing} is still being written: it would be lost."
        if not self.session.safe:
            question = f"The edits are not saved: {why}."
        if not isinstance(self.screen, Ask):
            say = self.say
            self.push_screen(Ask(f"{say(question)}\n{say('End all the same?')}", say("end"), say("go back")), self._quit_anyway)

    def _quit_anyway(self, yes: bool | None) -> None:
        if yes:
            self.exit(0)


def run(path: Path | None, ascii: bool = False, lang: str | None = None) -> int:
    """Open a design, or the last one, or the example; gives the exit code."""
    import gc

    from .recovery import Memory

    gc.set_threshold(50_000, 20, 50)  # a screen is many small objects that stay; they need not be looked through so often
    sys.setswitchinterval(0.001)  # a key waits no longer than that for the thread that solves
    memory = Memory()
    try:
        session = Session.open(path, memory=memory)
    except BadInput as bad:
        print(bad, file=sys.stderr)
        return 2
    encoding = (getattr(sys.stdout, "encoding", None) or "").lower().replace("-", "")
    settings = memory.settings()
    if lang is not None:  # this time; the session's palette changes it for good
        settings = replace(settings, language=lang)
    app = ContralberoApp(session, ascii=ascii or not encoding.startswith("utf"), key_map=memory.keys(), settings=settings)
    result = app.run()
    return app.return_code or result or 0


def main(arguments: list[str]) -> int:
    names = [a for a in arguments if not a.startswith("-")]
    return run(Path(names[0]) if names else None, ascii="--ascii" in arguments)


__all__ = ["ContralberoApp", "run"]

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
