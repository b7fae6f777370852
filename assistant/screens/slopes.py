# SPDX-License-Identifier: Apache-2.0
"""How far the inputs move a check, and what an input moves: asked for by what is shown, found in another thread, kept
while it holds."""

import math
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from textual.worker import get_current_worker

from calc.design.addresses import quantity_of, value_at
from calc.sheet.check import Check
from calc.sheet.errors import BadInput, Cancelled
from calc.sheet.text import EMPTY, SEMICOLON, Amount, Name, Small, Text

from ..session.places import label_of
from .background_solve import rest
from .host import Host

if TYPE_CHECKING:
    from calc.design.addresses import Table
    from calc.design.toml_file import Document
    from calc.solve import Results
    from calc.studies.explain import Effect

MOST = 2  # inputs that are named for a check, and checks for an input
MOVED = 5  # inputs that are moved for a check
LEAST, GREATEST = 0.01, 1000.0  # a slope is told for so much of the input that it lies between these
WAIT = 0.25  # seconds for which nothing else may be wanted: who runs through a list does not want all of it


class Slopes:
    """Nothing is known at first; who asks is told as soon as it is."""

    def __init__(self, host: Host) -> None:
        self._host = host
        self._results: Results | None = None
        self._known: dict[str, Text] = {}  # id of a check, or key of an input
        self._wanted = {"check": "", "key": ""}  # what is looked at now
        self._then: Callable[[Text], None] | None = None  # shows what an input moves

    def want(self, check: Check) -> None:
        """Show the findings how far the inputs move this check, now or soon."""
        if (known := self._look_up(check.id)) is not None:
            self._host.checks.show_slopes(check.id, known)
        elif self._current:
            self._soon("check", check.id)

    def of_key(self, key: str, then: Callable[[Text], None]) -> Text:
        """What an input moves most, "film at the edge, front +0.45 µm per mm"; where it is not known it is looked for,
        and `then` told."""
        if (known := self._look_up(key)) is not None:
            return known
        if self._current:
            self._then = then
            self._soon("key", key)
        return EMPTY

    def _soon(self, kind: str, name: str) -> None:
        self._wanted[kind] = name
        self._host.set_timer(WAIT, partial(self._begin, kind, name))

    @property
    def _current(self) -> bool:
        session = self._host.session
        return session.current and session.results is not None

    def _look_up(self, name: str) -> Text | None:
        results = self._host.session.results
        if results is not self._results:
            self._results, self._known = results, {}
        return self._known.get(name)

    def _begin(self, kind: str, name: str) -> None:
        host = self._host
        if (
            host.stands
            and self._wanted[kind] == name
            and self._current
            and (results := host.session.results) is not None
        ):
            host.in_thread(f"slopes of a {kind}", partial(self._find, name, host.session.document, results))

    def _find(self, name: str, document: "Document", results: "Results") -> None:
        """Runs in another thread."""
        from calc.studies.explain import effects, moved_by  # which brings the solver with it

        worker = get_current_worker()

        def stop() -> bool:
            rest(self._host)
            return worker.is_cancelled or results is not self._host.session.results

        check = next((check for check in results.checks() if check.id == name), None)
        try:
            if check is not None:
                words = of_check(document.data, check, effects(document, results, [check], MOVED, stop)[name])
            else:
                words = of_input(document.data, name, moved_by(document, results, name, stop))
        except Cancelled:
            return
        except Exception as error:  # a mistake of the program must not stop the session
            self._host.app.log(f"no slopes: {type(error).__name__}: {error}")
            return
        self._host.call_later(self._found, name, check is not None, results, words)

    def _found(self, name: str, check: bool, results: "Results", words: Text) -> None:
        host = self._host
        if not host.stands or results is not host.session.results:
            return
        self._look_up(name)
        self._known[name] = words
        if check and words:
            host.checks.show_slopes(name, words)
        elif words and self._then is not None and self._wanted["key"] == name:
            self._then(words)


def of_check(data: "Table", check: Check, effects: "tuple[Effect, ...]") -> Text:
    """`clearance −0.32 µm per µm; length +0.45 µm per mm`: the inputs that move a check most, over what they are."""
    known = [effect for effect in effects if effect.gain]
    known.sort(key=lambda effect: -abs((effect.gain or 0.0) * _size(data, effect.key)))
    return SEMICOLON.join(_effect(data, check, effect) for effect in known[:MOST])


def _effect(data: "Table", check: Check, effect: "Effect") -> Text:
    """What an input does to the value that is judged, or, where it leaves that alone, to its limit."""
    unit, words = quantity_of(data, effect.key).unit, label_of(data, effect.key)
    if effect.slope:
        return slope(words, effect.slope, check.unit, unit)
    gain = effect.gain or 0.0
    below = check.nearest[1] == check.limit[0] if isinstance(check.limit, tuple) else check.sense in (">=", ">")
    return slope(Text("{input}: limit", input=words), -gain if below else gain, check.unit, unit)


def of_input(data: "Table", key: str, moved: "tuple[tuple[Check, Effect], ...]") -> Text:
    """`film at the edge, front +0.45 µm per mm`: what an input moves most of the limits that it is meant for."""
    seen: dict[str, tuple[Check, Effect]] = {}
    for check, effect in moved:
        if (
            check.kind == "limit"
            and effect.slope
            and any(f"{key}.".startswith(f"{prefix}.") for prefix in check.moved_by)
        ):
            seen.setdefault(check.cause or check.id, (check, effect))
    unit = quantity_of(data, key).unit
    return SEMICOLON.join(
        slope(Small(check.name), response.slope or 0.0, check.unit, unit)
        for check, response in list(seen.values())[:MOST]
    )


def slope(what: Text, slope: float, unit: str, of: str) -> Text:
    """`length +0.45 µm per mm`, or per 10 or 100 of it, where one unit does next to nothing."""
    size = 1.0
    if not LEAST <= abs(slope) < GREATEST:
        size = 10.0 ** -math.floor(math.log10(abs(slope)))
    per = Name(of) if size == 1 and of else Amount(size, of)
    return Text(
        "{what} {slope} per {per}", what=what, slope=Amount(float(f"{slope * size:.2g}"), unit, form="+.3g"), per=per
    )


def _size(data: "Table", key: str) -> float:
    try:
        value = value_at(data, key)
    except BadInput:
        return 0.0
    numbers = [abs(x) for x in (value if isinstance(value, list) else [value]) if isinstance(x, (int, float))]
    return max(numbers, default=0.0)
