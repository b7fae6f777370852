# SPDX-License-Identifier: Apache-2.0
"""What follows an edit, besides the results: fields say what is wrong with them, and the edit is kept aside."""

from textual.timer import Timer

from ..session.places import Place
from .host import Host

KEEP = 1.5  # seconds after the first edit that is not kept aside until all of them are: typing does not put it off
COMPLAIN = 0.6  # seconds until a field that is being typed into says what is wrong with it


class EditFeedback:
    def __init__(self, host: Host) -> None:
        self._host = host
        self._keep: Timer | None = None
        self._complain: Timer | None = None
        self._shown: set[Place] = set()  # fields whose mistake is shown

    def begin(self) -> None:
        """Another design is entered."""
        for timer in (self._keep, self._complain):
            if timer is not None:
                timer.stop()
        self._keep = None
        self._shown = set()

    def keep_soon(self) -> None:
        if self._keep is None:
            self._keep = self._host.set_timer(KEEP, self._keep_now)

    def _keep_now(self) -> None:
        """In another thread; a disk may be slow."""
        self._keep = None
        self._host.in_thread("keep", self._keep_aside)

    def _keep_aside(self) -> None:
        self._host.session.autosave()
        self._host.call_later(self._host.refresh_top_line)

    def show(self) -> bool:
        """Show which fields are not accepted, and dim the results; whether that is all that there is to say.

        A field that is being typed into gets a moment before it complains: False.
        """
        host, session = self._host, self._host.session
        reasons = session.reasons()
        here = host.form.here()
        late = {place for place in reasons if place == here and place not in self._shown}
        host.form.refresh_fields({place: reason for place, reason in reasons.items() if place not in late})
        self._shown = set(reasons) - late
        if self._complain is not None:
            self._complain.stop()
        self._complain = host.set_timer(COMPLAIN, self._complain_now) if late else None
        host.set_stale(session.results is not None and not late and (not session.valid or bool(session.failure)))
        return not late

    def _complain_now(self) -> None:
        if self._host.stands:
            self._shown = set(self._host.session.reasons())
            self._host.show_state()
