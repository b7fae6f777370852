# SPDX-License-Identifier: Apache-2.0
"""The guided session: one screen over one `Session`.  Only what the first picture needs is imported here."""

import gc
import os
import signal
import sys
import time
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, ClassVar, Protocol, runtime_checkable

os.environ.setdefault("TEXTUAL_ANIMATIONS", "none")  # read when textual is imported

from textual import events
from textual.app import ScreenStackError
from textual.await_complete import AwaitComplete
from textual.binding import Binding, BindingType
from textual.screen import ModalScreen, Screen
from textual.timer import Timer
from textual.widgets import Input

from calc.locale import language
from calc.sheet.errors import BadInput
from calc.sheet.text import EMPTY, Text

from .actions import ANYWHERE, BY_ID, OPENS, anywhere, is_typed
from .base_app import BaseApp
from .output import told
from .screens.workbench import Workbench
from .session.recovery import Memory, Settings
from .session.session import Session
from .widgets.entry import AT_ONCE, Choice
from .widgets.item_list import ItemList
from .widgets.line import EDITS


@runtime_checkable
class Speaking(Protocol):
    """A screen that can be shown anew in another language."""

    async def speak(self) -> None: ...


HELD = 3.0  # seconds that keys wait at most
CALM, CALM_STEP = 2, 0.004  # looks in a row that find nothing going on, and seconds between them
LOOK = 2.0  # seconds between two looks at the file, whether another program has changed it


class ContralberoApp(BaseApp):
    """One main screen over one session, which may be exchanged for another design.  Without a session: the start page,
    for a file that is `missing` where one was asked for."""

    CSS_PATH = "contralbero.tcss"
    TITLE = "Contralbero"
    ENABLE_COMMAND_PALETTE = False  # there is one of our own
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("ctrl+q", "quit", "Quit", show=False, priority=True, id=anywhere("quit")),
    ]

    def __init__(
        self,
        session: Session | None,
        *,
        ascii: bool = False,
        key_map: dict[str, str] | None = None,
        settings: Settings | None = None,
        memory: Memory | None = None,
        missing: Path | None = None,
    ) -> None:
        settings = settings or Settings()
        super().__init__(session, ascii=ascii, key_map=key_map, settings=settings, memory=memory)
        self.missing = missing
        if session is not None:
            session.decimal = self.say.decimal
        if settings.theme in self.available_themes:
            self.theme = settings.theme
        self._theme_kept = self.theme
        self._held: list[events.Key] | None = None
        self._hold: Timer | None = None  # ends their wait at the latest

    def on_mount(self) -> None:
        # what goes before the field's own keys must not take its letters
        first = {anywhere(id): ",".join(k for k in self.keys_of(id) if not is_typed(k)) for id in ANYWHERE}
        self.set_keymap({**self.key_map, **first})
        self.fit_signs()
        self.theme_changed_signal.subscribe(self, self._theme_changed)
        self.set_interval(LOOK, self.look)
        if self._session is not None:
            self.session.attend()
            self.look()

    def get_default_screen(self) -> Screen[None]:
        """The first screen from the start: there is no other one below it that would be styled and painted for
        nothing."""
        if self._session is not None:
            return Workbench(self._session)
        from .screens.start import Start

        return Start(self.memory, self.missing)

    def begin(self, *, engines: bool = False) -> None:
        """The start page, over the design that is open."""
        from .screens.start import Start

        if not isinstance(self.screen, Start):
            self.push_screen(Start(self.memory, engines=engines))

    def _theme_changed(self, theme: Any) -> None:
        self.fit_signs()
        if isinstance(self.screen, Workbench) and self.screen.stands:
            self.screen.show_step()
            for shown in self.screen.query(ItemList):  # their rows have colours of their own
                shown.rebuild()
        if theme.name != self._theme_kept:
            self._theme_kept = theme.name
            self.memory.set_setting("theme", theme.name)

    def on_app_focus(self) -> None:
        self.look()

    def look(self) -> None:
        """Say, once, that another program has changed the file, or that another session is at it."""
        if self._session is not None and self.session.joined():
            text = Text(
                "{name} is open in another session too: each keeps its own edits, and none overwrites the other's "
                "unasked.",
                name=self.session.name,
            )
            self.tell(text)
        if self._session is not None and self.session.look():
            text = Text(
                "{name} was changed by another program: {key} takes it over, and undo would return.",
                name=self.session.name,
                key=self.shown_key("reload"),
            )
            self.tell(text, "warning")

    async def speak(self, code: str) -> None:
        """Go on in another language."""
        self.say = language(code, self.ascii)
        if self._session is not None:
            self._session.decimal = self.say.decimal
        self.memory.set_setting("language", code)
        self.fit_signs()
        for screen in self.screen_stack:
            if isinstance(screen, Speaking):
                await screen.speak()

    def pop_screen(self) -> AwaitComplete:
        """The main screen stays, also where a key that repeats closes the palette twice."""
        return super().pop_screen() if len(self.screen_stack) > 1 else AwaitComplete()

    async def enter(self, session: Session) -> None:
        """Go on with a design, or with another one; unsaved edits of this one are kept aside."""
        before, self._session = self._session, session
        session.decimal = self.say.decimal
        if before is not None:
            before.autosave()
            before.leave()
            if before.recording is not None:
                self.tell(Text("The recording is given up: it was one of the design before."), "warning")
        while len(self.screen_stack) > 1:
            await self.pop_screen()
        if isinstance(self.screen, Workbench):
            await self.screen.enter(session)
        else:
            self.add_mode("work", lambda: Workbench(session))  # a first screen can not be exchanged
            await self.switch_mode("work")
        session.attend()
        self.look()

    async def action_save(self) -> None:
        """Save the design that is open, on whatever screen; but where it is asked how."""
        from .screens.dialogs import Ask
        from .screens.path_dialogs import TargetDialog

        if isinstance(self.screen, (Ask, TargetDialog)):
            return
        work = next((screen for screen in self.screen_stack if isinstance(screen, Workbench)), None)
        if work is not None and work.stands:
            await work.run_action(BY_ID["save"].does)

    def action_command_palette(self) -> None:
        from .screens.palette import Palette

        if not isinstance(self.screen, ModalScreen):
            self.push_screen(Palette())

    async def on_event(self, event: events.Event) -> None:
        with suppress(ScreenStackError):  # the program has ended while it was on its way
            await self._take(event)

    async def _take(self, event: events.Event) -> None:
        """Keys that follow one that leads away wait until that is done, and are for where it leads: what opens a
        screen, Enter and Escape on every screen but the main one, and in a field any key of an action that it does
        not take itself."""
        if not isinstance(event, events.Key) or event.is_forwarded:
            await super().on_event(event)
            return
        self.struck, self.struck_key = time.monotonic(), event.key
        if event.key.startswith("alt+"):
            # a terminal that sends Esc before it writes the digit too, which no field is to take
            event.character = None
        if self._held is not None:
            self._held.append(event)
            return
        if self._leads_away(event):
            self._held = []
            self._hold = hold = self.set_timer(HELD, self._held_long_enough)
            await super().on_event(event)
            if not getattr(self.screen, "HOLDS", False):  # which lets them go itself
                self.call_after_refresh(self._release_when_calm, hold)
            return
        await super().on_event(event)

    def _leads_away(self, key: events.Key) -> bool:
        """Whether what follows a key may be meant for another screen or field than that which has the focus."""
        if not isinstance(self.screen, Workbench) and key.key in ("enter", "escape"):
            return True
        typing = isinstance(self.focused, (Input, Choice))
        if typing and (key.is_printable or key.key in EDITS):
            return False
        inside = typing and isinstance(self.screen, Workbench)
        ids = [id for id in BY_ID if id not in AT_ONCE] if inside else OPENS
        return any(key.key in self.keys_of(id) for id in ids)

    def _release_when_calm(self, hold: Timer, calm: int = 0) -> None:
        """Let the keys go that wait for what the one before them does, once nobody has a message left of that."""
        if hold is not self._hold:
            return
        nodes = (self, *self.screen.walk_children(with_self=True))
        calm = 0 if any(node.message_queue_size for node in nodes) else calm + 1
        if calm < CALM:
            self.set_timer(CALM_STEP, partial(self._release_when_calm, hold, calm))
        else:
            self.release(hold)

    def _held_long_enough(self) -> None:
        self.release(self._hold)

    @property
    def holding(self) -> Timer | None:
        return self._hold

    def release(self, hold: Timer | None) -> None:
        if hold is not None and hold is self._hold:
            hold.stop()  # or it would end the wait of other keys
            self.call_later(self._let_go, hold)  # behind the keys that have come: they keep their order

    async def _let_go(self, hold: Timer) -> None:
        if hold is not self._hold:  # of another wait, which has ended
            return
        held, self._held, self._hold = self._held, None, None
        for event in held or ():
            await self.on_event(event)

    def on_unmount(self) -> None:
        """However the program ends, a closed page of a browser too: edits are kept aside."""
        if self._session is not None:
            self._session.autosave()
            self._session.leave()

    async def action_quit(self) -> None:
        """Edits are kept aside; only where that fails, or something would be lost, is there something to ask."""
        if self._session is None:
            self.exit(0)
            return
        self.session.autosave()
        if self.session.safe and self.session.recording is None and not self.writing:
            self.exit(0)
            return
        from .screens.dialogs import Ask

        why = self.session.autosave_failure or Text("what was added last is not complete, and such a part is not kept")
        question = Text("The recorded replay is not written.") if self.session.recording is not None else EMPTY
        if self.writing:
            question = Text("{writing} is still being written: it would be lost.", writing=self.writing)
        if not self.session.safe:
            question = Text("The edits are not saved: {why}.", why=why)
        if not isinstance(self.screen, Ask):
            say = self.say
            self.push_screen(
                Ask(f"{say(question)}\n{say(Text('End all the same?'))}", say(Text("end")), say(Text("go back"))),
                self._quit_anyway,
            )

    def _quit_anyway(self, yes: bool | None) -> None:
        if yes:
            self.exit(0)


def _read_alt_digits() -> None:
    """Esc and a digit is Alt and the digit, as nearly every terminal sends it; for one on macOS textual makes another
    sign of it (`∞`)."""
    with suppress(ImportError, AttributeError):
        from textual._ansi_sequences import ANSI_SEQUENCES_KEYS

        for digit in "123456789":
            ANSI_SEQUENCES_KEYS.pop(f"\x1b{digit}", None)  # type: ignore[attr-defined]


def run(path: Path | None, ascii: bool = False, lang: str | None = None) -> int:
    """Open a design, or the start page; gives the exit code."""
    # between two of the twenty turns that a key takes, the thread that solves has no more than that
    sys.setswitchinterval(0.0002)
    gc.freeze()  # a look through all that there is already stops both threads for a tenth of a second
    _read_alt_digits()
    memory = Memory()
    missing = path.expanduser().absolute() if path is not None and not memory.there(path.expanduser()) else None
    try:
        session = Session.open(path, memory=memory) if path is not None and missing is None else None
    except BadInput as bad:
        print(bad, file=sys.stderr)
        return 2
    encoding = (getattr(sys.stdout, "encoding", None) or "").lower().replace("-", "")
    settings = memory.settings()
    if lang is not None:  # this time; the session's palette changes it for good
        settings = replace(settings, language=lang)
    plain = ascii or not encoding.startswith("utf")
    app = ContralberoApp(session, ascii=plain, key_map=memory.keys(), settings=settings, memory=memory, missing=missing)
    # of which nohup makes nothing: without its terminal a session would only keep a core busy
    if hasattr(signal, "SIGHUP"):
        signal.signal(signal.SIGHUP, signal.SIG_DFL)
    result = app.run()
    # textual would show its trace with the values of all variables, and end as a failed check does
    if app._exception is not None:
        return told(app._exception)
    return app.return_code or result or 0


def main(arguments: list[str]) -> int:
    names = [a for a in arguments if not a.startswith("-")]
    return run(Path(names[0]) if names else None, ascii="--ascii" in arguments)


__all__ = ["ContralberoApp", "run"]

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
