# SPDX-License-Identifier: Apache-2.0
"""A check: a value against its limit, with what is known of it said where it is declared, and what follows from both.

A check is declared once, at module level, and made by calling the declaration:

    FILM = CheckRule("bearings.B.film", "limit", "It touches.", Text("Film"), ">=", "µm", role="physics")
    yield FILM(film, least, at="front", source=…)

The letters in an id stand for elements that have names of their own."""

import math
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import cached_property, lru_cache
from typing import Literal

from .deferred import Later, Many
from .record import record, replace
from .remedy import Remedy, sentence
from .text import COMMA, EMPTY, SEMICOLON, SPACE, Amount, Name, Small, Text
from .units import UNITS
from .value import link_of, linked

Kind = Literal["limit", "caution", "advice", "method"]
Role = Literal["", "physics", "chosen", "self"]
KINDS: tuple[Kind, ...] = ("limit", "caution", "advice", "method")  # from what must hold to what is of the calculation

THIN_MARGIN = 0.05  # a limit that holds by less than this is narrow
DEGREES = 100.0  # K: the scale of margins in °C, whose zero is no zero

# --- what stands for what in an id

LETTERS: Mapping[str, str] = {
    "S": "a shaft, by its name; in the keys of inputs alone",
    "B": "a bearing, by its name; behind _ too",
    "M": "a mesh, by its wheels: DRIVER_DRIVEN",
    "W": "a wheel, by its name; behind _ too",
    "D": "a drain of the oil: `drain`, or `further_drains` and its name",
    "J": "a joint of bolts: `bolts`, or `further_bolts` and its name",
    "R": "a run of `[[measurements]]`, by its name",
    "C": "a column of it, by its name",
    "N": "any other element, by its name",
}
INDEX = "#"  # in the key of an input: the place of a mesh in its array
LETTER = re.compile(rf"(?<![^.])(?:[{''.join(LETTERS)}{INDEX}]|DRIVER|DRIVEN)(?![^.])|(?<=_)[BW](?![^_.])")


Elements = tuple[tuple[str, str], ...]  # letter and name


# both once only: a solve asks some two thousand times, and the next one the same
@lru_cache(2**14)
def _elements(id: str, at: tuple[str, ...], index: int | None) -> Elements:
    """What the letters of an id stand for, in their order."""
    names = dict(zip(LETTER.findall(id), at, strict=True))
    if "M" in names:
        names["DRIVER"], names["DRIVEN"] = names["M"].split("_")
    return (*names.items(), *(() if index is None else ((INDEX, str(index)),)))


@lru_cache(2**14)
def _filled(id: str, elements: Elements) -> str:
    names = dict(elements)
    return LETTER.sub(lambda letter: names.get(letter[0], letter[0]), id)


# --- what is not given

End = float | Literal["holds", "none"]


@record
class Missing:
    """What a check needs and the design does not give.

    `keys`: of the inputs; `taken`: what stands for them, empty where nothing can.  `best`, `worst`: the judged value,
    in SI, with all of them at their favourable and at their unfavourable end; "holds": the limit can not be passed over
    there; "none": nobody knows how far it goes."""

    keys: tuple[str, ...]
    taken: tuple[Text, ...]
    best: End
    worst: End


def _shown_end(number: End | None, shown: Callable[[float], float]) -> End:
    if number is None:  # nothing could be computed there, which is no value that holds
        return math.nan
    return shown(number) if isinstance(number, (int, float)) and math.isfinite(number) else number


# --- what is known of a check before it is made

RULES: dict[str, "CheckRule"] = {}  # by id, of all modules that are loaded


@record
class CheckRule:
    """What is known of one check, or of all that differ in the elements that the letters of the id stand for.

    `kind`: a "limit" must hold: else a part breaks, seizes, jams or can not be put together; a "caution" is the same
    less surely; "advice" is a usual figure or a rule of thumb; "method" is about the calculation, not the part. `role`
    of a limit: "physics", "chosen" (by the designer) or "self" (data and program agree with themselves). `why`: the
    reason for its kind.  `sense`: ">=", ">", "<=", "<" or "in" (the limit is then a range). `demand`: value and limit
    are demand and capacity.  `exact`: the limit may be used up.  `zero`: what its margin is a share of where the limit
    is 0, in words. `cause`: the id of the check, or of the group, that it is shown under.  `value_id`, `limit_id`: the
    value that is judged and the one that it is held against. `moved_by`: keys of the inputs that move it most, in the
    order in which a designer uses them; the key of a table stands for the numbers in it. `short`: in a word. `decides`:
    it stands for its step where no limit is open. `proven`: a report proves it whatever its margin, with these symbols
    however far back they stand; `proven_where`: only where this result is not 0. `weakens`: where this check of the
    method is passed over, the margins of these checks are known by these factors less. `of_input`: it doubts a number
    that is given, and stands before all that follows from it."""

    id: str
    kind: Kind
    why: str
    name: Text = EMPTY
    sense: str = ">="
    unit: str = ""
    source: Text = EMPTY
    advice: Text = EMPTY
    role: Role = ""
    demand: bool = False
    exact: bool = False
    zero: str = ""
    cause: str = ""
    value_id: str = ""
    limit_id: str = ""
    moved_by: tuple[str, ...] = ()
    short: Text = EMPTY
    decides: bool = False
    proven: tuple[str, ...] | None = None
    proven_where: object = None
    weakens: tuple[tuple["CheckRule", float], ...] = ()
    of_input: bool = False

    def __post_init__(self) -> None:
        if self.id in RULES:
            raise ValueError(f"the check {self.id} is declared twice")
        if (self.kind == "limit") is not bool(self.role):
            raise ValueError(f"the check {self.id}: a limit has a role, another kind has none")
        RULES[self.id] = self

    @property
    def pattern(self) -> str:
        """The ids of all its checks, with * for what the letters stand for."""
        return _filled(self.id, tuple((letter, "*") for letter in LETTERS))

    def of(self, at: str | Sequence[str]) -> str:
        """The id of its check on these elements."""
        return _filled(self.id, self._at(at))

    def _at(self, at: str | Sequence[str], index: int | None = None) -> Elements:
        return _elements(self.id, (at,) if isinstance(at, str) else tuple(at), index)

    def __call__(
        self,
        value: float | None,
        limit: float | tuple[float, float],
        *,
        at: str | Sequence[str] = (),
        name: Text | None = None,
        source: Text | None = None,
        advice: Text | None = None,
        sense: str | None = None,
        unit: str | None = None,
        scale: float | None = None,
        index: int | None = None,
        value_id: str | None = None,
        moved_by: tuple[str, ...] | None = None,
        missing: Missing | None = None,
        base: float = 0.0,
        remedies: Callable[[], tuple[Remedy, ...]] | Later[Remedy] | None = None,
    ) -> "Check":
        """A check from numbers in SI: value, limit and scale are turned into the shown unit here and nowhere else.

        `at`: the elements that the letters of the id stand for; `index`: of the mesh in its array.  `value`: None, or
        no number, keeps no limit. `scale`: what the margin is a share of where the limit is 0. `advice`: what could be
        done beside the remedies, which are made only where it does not hold; those that take long when they are looked
        at (`Later`). `base`: what the value would be without
        what a stretched formula adds to it.  `unit`, `value_id`, `moved_by`: where the site knows them better.

        A function that gives several is a generator, called `checks` or `…_checks`, and becomes a tuple where the
        Outcome is made; one that gives one, or perhaps none, is called `…_check`."""
        names = self._at(at, index)
        unit = self.unit if unit is None else unit
        shown = UNITS[unit].shown
        value = math.nan if value is None else value
        if isinstance(limit, tuple):
            bound: float | tuple[float, float] = (shown(limit[0]), shown(limit[1]))
        elif limit == 0 and scale is None and unit != "°C":
            raise TypeError(f"{self.id}: a limit of 0 has no margin without a scale")
        else:
            bound = linked(shown(limit), link_of(limit))

        keys = [_filled(key, names) for key in self.moved_by] if moved_by is None else moved_by
        this_check = Check(
            self,
            _filled(self.id, names),
            self.name if name is None else name,
            linked(shown(value) if math.isfinite(value) else value, link_of(value)),
            bound,
            self.sense if sense is None else sense,
            unit,
            self.source if source is None else source,
            self.advice if advice is None else advice,
            cause=_filled(self.cause, names),
            value_id=_filled(self.value_id, names) if value_id is None else value_id,
            limit_id=_filled(self.limit_id, names),
            moved_by=tuple([key for key in keys if INDEX not in key]),
            zero_scale=None if scale is None else abs(shown(scale)),
            missing=missing.keys if missing is not None else (),
            taken=missing.taken if missing is not None else (),
            at_best=_shown_end(missing.best, shown) if missing is not None else None,
            at_worst=_shown_end(missing.worst, shown) if missing is not None else None,
            base=shown(base) if base else 0.0,
        )
        if remedies is None or this_check.holds:
            return this_check
        if isinstance(remedies, Later):
            return replace(this_check, remedies=remedies)
        ways = remedies()
        if not ways:
            return this_check
        repaired = replace(this_check, remedies=ways)
        return replace(repaired, advice=SPACE.join(filter(None, (repaired.ways_text(), this_check.advice))))


# --- one check

SIGNS = {
    "pass": "✓",
    "computed": "✓",
    "warn": "▲",
    "fail": "✗",
    "note": "•",
    "not_verified": "?",
    "not_judged": "?",
    "accepted": "✓",
    "blocked": "○",
    "not_asked": "·",
    "no_solution": "✗",
}
# from good to bad
ORDER: tuple[str, ...] = (
    "not_asked",
    "pass",
    "accepted",
    "computed",
    "note",
    "warn",
    "not_judged",
    "not_verified",
    "blocked",
    "fail",
    "no_solution",
)
URGENT = ("fail", "not_verified", "warn")  # verdicts of checks that somebody has to look at


@record
class Check:
    """`value`, `limit`, `zero_scale`, `base` and the ends stand in the shown unit.  `sense` is ">=", ">", "<=", "<" or
    "in" (limit is then (low, high)).

    `missing`, `taken`, `at_best`, `at_worst`: what is not given, as of `Missing`; None where nothing is missing.
    `remedies`: what would make it hold; `advice`: what to do: the remedies, in the labels and units of the fields, and
    what is no value of a key; without those that are made when they are looked at, which `to_do` has.  `outside`: the
    checks of the method that are passed over and that put this one outside the validity of its formula.  `accepted`:
    the reason that the user gave for leaving it open."""

    rule: CheckRule
    id: str
    name: Text
    value: float
    limit: float | tuple[float, float]
    sense: str
    unit: str = ""
    source: Text = EMPTY
    advice: Text = EMPTY
    cause: str = ""
    value_id: str = ""
    limit_id: str = ""
    moved_by: tuple[str, ...] = ()
    zero_scale: float | None = None
    missing: tuple[str, ...] = ()
    taken: tuple[Text, ...] = ()
    at_best: End | None = None
    at_worst: End | None = None
    base: float = 0.0
    outside: tuple[str, ...] = ()
    remedies: Many[Remedy] = ()
    accepted: str = ""

    def __str__(self) -> str:
        value = Amount(self.value, self.unit)
        return f"{SIGNS[self.verdict]} {self.name}: {value} ({self.limit_text()}, {self.margin_text()})"

    @property
    def kind(self) -> Kind:
        return self.rule.kind

    @property
    def role(self) -> Role:
        return self.rule.role

    @property
    def exact(self) -> bool:
        return self.rule.exact

    @property
    def nearest(self) -> tuple[float, float]:
        """Distance to the nearest limit, negative when passed over, and that limit."""
        return self._from_limit(self.value)

    def _from_limit(self, value: float) -> tuple[float, float]:
        if isinstance(self.limit, tuple):
            low, high = self.limit
            to_low, to_high = value - low, high - value
            return (to_high, high) if to_high < to_low or math.isnan(to_high) else (to_low, low)
        return (value - self.limit if self.sense in (">=", ">") else self.limit - value), self.limit

    @property
    def gap(self) -> float:
        """Distance to the nearest limit in the shown unit, negative when passed over."""
        return self.nearest[0]

    @cached_property
    def scale(self) -> float:
        """What the margin is a share of: the limit, of a range its width, 100 K, or what is said where it is 0."""
        if self.unit == "°C":
            return DEGREES
        if isinstance(self.limit, tuple) and self.limit[1] > self.limit[0]:
            return self.limit[1] - self.limit[0]
        return abs(self.nearest[1]) or self.zero_scale or 0.0

    @cached_property
    def margin(self) -> float:
        """The gap over the scale."""
        return self.gap / self.scale if self.scale else math.copysign(math.inf, self.gap) if self.gap else 0.0

    @property
    def holds(self) -> bool:
        """Whether the limit is kept by what is taken; a value that is no number keeps none."""
        return self._kept(self.value)

    def _kept(self, value: float) -> bool:
        gap = self._from_limit(value)[0]
        return gap > 0 or (gap == 0 and self.sense not in (">", "<"))

    @property
    def narrow(self) -> bool:
        """A limit that is kept, but by so little that it warns."""
        return self.kind == "limit" and not self.exact and self.holds and self.margin < THIN_MARGIN

    @property
    def utilisation(self) -> float | None:
        """Demand over capacity, 1 at the limit; None where the check is not on these two."""
        if not self.rule.demand or isinstance(self.limit, tuple):
            return None
        over, under = (self.value, self.limit) if self.sense in ("<=", "<") else (self.limit, self.value)
        return over / under if under else None

    @property
    def bounds(self) -> tuple[float | None, float | None]:
        """The least and the greatest that is allowed, None where there is none."""
        if isinstance(self.limit, tuple):
            return self.limit
        return (self.limit, None) if self.sense in (">=", ">") else (None, self.limit)

    @property
    def share(self) -> float | None:
        """The value over its nearest limit, 1 at it; None where that says nothing."""
        limit = self.nearest[1]
        ratio = self.value / limit if limit else math.nan
        return ratio if ratio >= 0 else None

    @cached_property
    def finding(self) -> str:
        """The verdict, before anybody accepts it.

        Of what is not given: with all at the favourable end it fails, or with all at the unfavourable one it holds;
        else it is not verified."""
        if self.kind == "method" and self.at_best == "none":
            return "not_verified"
        if self.kind in ("advice", "method"):
            return "pass" if self.holds else "note"
        passed_over = "fail" if self.kind == "limit" else "warn"
        if self.at_best is not None:
            best, worst = self.kept_at_best, self.kept_at_worst
            if best is False:
                return passed_over
            if not (best and worst and self.holds):
                return "not_verified"
        if self.holds:
            return "warn" if self.narrow else "pass"
        return passed_over

    def _end(self, end: End | None) -> bool | None:
        """Whether it holds there; None where nobody knows."""
        return self._kept(end) if isinstance(end, (int, float)) else {"holds": True}.get(end or "")

    @property
    def kept_at_worst(self) -> bool | None:
        """Whether it holds with all that is not given at its unfavourable end; None where nobody knows."""
        return self._end(self.at_worst)

    @property
    def kept_at_best(self) -> bool | None:
        """The same at its favourable end."""
        return self._end(self.at_best)

    @property
    def verdict(self) -> str:
        finding = self.finding
        return "accepted" if self.accepted and self.kind != "limit" and finding != "pass" else finding

    @property
    def open(self) -> bool:
        """Whether something is left to do, or to accept."""
        return self.verdict not in ("pass", "accepted")

    def in_place(self, keys_of: Callable[[str], tuple[str, ...]]) -> "Check":
        """The same by the keys of one design: `keys_of` gives those that a key of the rule stands for there."""
        made = () if isinstance(self.remedies, Later) else self.remedies
        named = (*self.moved_by, *self.missing, *(key for way in made for key, _ in way.changes))
        if all(keys_of(key) == (key,) for key in named):
            return self
        return replace(
            self,
            moved_by=tuple(key for each in self.moved_by for key in keys_of(each)),
            missing=tuple(key for each in self.missing for key in keys_of(each)),
            remedies=_placed(self.remedies, keys_of),
        )

    def of_one(self, name: str, steps: Collection[str]) -> "Check":
        """The same as that of one of several shafts: its name stands behind the step in the ids of `steps`."""

        def placed(id: str) -> str:
            step, dot, rest = id.partition(".")
            return f"{step}.{name}.{rest}" if dot and step in steps else id

        return replace(
            self,
            id=placed(self.id),
            name=Text("{name}: {check}", name=Name(name), check=Small(self.name)),
            cause=self.cause and placed(self.cause),
            value_id=self.value_id and placed(self.value_id),
            limit_id=self.limit_id and placed(self.limit_id),
            outside=tuple(map(placed, self.outside)),
        )

    def limit_text(self) -> Text:
        if isinstance(self.limit, tuple):
            return Text("{low} to {high}", low=Amount(self.limit[0]), high=Amount(self.limit[1], self.unit))
        sign = {">=": "≥", "<=": "≤"}.get(self.sense, self.sense)
        return Text("{sign} {limit}", sign=sign, limit=Amount(self.limit, self.unit))

    @property
    def told_by_gap(self) -> bool:
        """Whether its margin is said as a gap with its unit: of a limit of 0 and of temperatures."""
        return self.limit == 0 or self.unit == "°C"

    def margin_text(self) -> Text:
        """Per cent, or the gap with its unit."""
        gap = self.gap
        if math.isnan(gap):
            return Text("no number")
        if self.told_by_gap:
            form = "+.3g" if abs(gap) < 1000 else "+.0f"
            return Text("{margin}", margin=Amount(gap, {"°C": "K"}.get(self.unit, self.unit), form=form))
        if abs(self.margin) > 1000:  # of a limit that is all but zero
            return Text("beyond {percent}", percent=Amount(math.copysign(1e5 - 1, self.margin), "%", form="+.0f"))
        percent = self.margin * 100
        return Text("{percent}", percent=Amount(percent, "%", form="+.1f" if 0 < abs(percent) < 0.5 else "+.0f"))

    def lack_text(self, label: Callable[[str], str] = Name) -> Text:
        """What is not given, what stands for it, and how far the value goes with it; empty where nothing is missing.

        `label`: what an input is called, by its key."""
        if self.at_best is None:
            return EMPTY
        taken = SEMICOLON.join(self.taken)
        if self.verdict in ("pass", "accepted") and taken:
            return Text("Assumed: {taken}.", taken=taken)
        if not self.missing:
            return self.ends_text()
        keys = COMMA.join(map(label, self.missing))
        if not taken:
            return Text("Not given: {keys}.", keys=keys)
        return Text("Not given: {keys}; taken: {taken}. {ends}", keys=keys, taken=taken, ends=self.ends_text())

    def lack_in_short(self) -> Text:
        """The same; of several keys those that differ by their element stand together, the others without their step,
        and what stands for them is left out."""
        if len(self.missing) < 2 or self.verdict in ("pass", "accepted"):
            return self.lack_text()
        together: dict[str, list[str]] = {}
        for key in self.missing:
            together.setdefault(key.rpartition(".")[2], []).append(key)
        keys = [
            Text("{key} of {elements}", key=last, elements=Name(", ".join(key.split(".")[-2] for key in some)))
            if len(some) > 1
            else Name(some[0].removeprefix(f"{self.id.partition('.')[0]}."))
            for last, some in together.items()
        ]
        return Text("Not given: {keys}. {ends}", keys=SEMICOLON.join(keys), ends=self.ends_text())

    def ways_text(self) -> Text:
        """What would make it hold, with which its advice begins; empty where nothing is known."""
        return sentence(tuple(self.remedies), verified=self.at_worst != "none" or not self.taken)

    @property
    def to_do(self) -> Text:
        """Its advice, with the remedies that are made when they are looked at."""
        if not isinstance(self.remedies, Later):
            return self.advice
        return SPACE.join(filter(None, (self.ways_text(), self.advice)))

    @property
    def waits(self) -> bool:
        """Whether its remedies are not made yet, which may take a while."""
        return isinstance(self.remedies, Later) and not self.remedies.is_made

    def ends_text(self) -> Text:
        """How far the value goes with all that is not given."""
        return Text(
            "At best {best}, at worst {worst}.", best=self._shown(self.at_best), worst=self._shown(self.at_worst)
        )

    def _shown(self, end: End | None) -> Text | Amount:
        if isinstance(end, (int, float)):
            return Amount(end, self.unit)
        return Text("it can not fail") if end == "holds" else Text("nobody knows")


def _placed(remedies: Many[Remedy], keys_of: Callable[[str], tuple[str, ...]]) -> Many[Remedy]:
    """The same by the keys of one design, those that are not made yet as well."""
    if isinstance(remedies, Later):
        return Later(lambda: _placed(remedies.made, keys_of))
    return tuple(
        replace(way, changes=tuple((key, x) for each, x in way.changes for key in keys_of(each))) for way in remedies
    )


# --- checks outside the validity of their formulas


def stretched(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """The checks of a step, those of them known less well that stand on a formula outside its validity.

    What a check of the method says when it is passed over is one thing more that is missing: at the favourable end the
    value is what it is, at the unfavourable one it is weakened by the factor that the method declares."""
    missed = [check for check in checks if check.rule.weakens and not check.holds]
    return tuple([_stretched(check, missed) for check in checks]) if missed else checks


def _stretched(check: Check, missed: Sequence[Check]) -> Check:
    factors = {
        method: factor
        for method in missed
        for rule, factor in method.rule.weakens
        if rule is check.rule and _one_part(method, check.id)
    }
    if not factors:
        return check
    # of several meshes of one wheel the formula is stretched once
    factor = math.prod({method.rule.id: factor for method, factor in factors.items()}.values())
    worst: End = check.value if check.at_worst is None else check.at_worst
    if isinstance(worst, (int, float)):
        over = worst - check.base
        worst = check.base + (over / factor if check.sense in (">=", ">") else over * factor)
    best = check.value if check.at_best is None else check.at_best
    return replace(check, outside=tuple([method.id for method in factors]), at_best=best, at_worst=worst)


def _one_part(method: Check, check: str) -> bool:
    """Whether both are of one bearing, mesh or wheel, or one is of all, or of the whole shaft; a wheel is part of its
    meshes."""
    of, part = method.id.split(".")[1:-1], check.split(".")[1:-1]
    if method.rule.id.endswith("_W"):  # of one wheel of a mesh
        return method.id.endswith(f"_{part[0]}")
    return not of or not part or "train" in of or all(b == a or b in a.split("_") for a, b in zip(of, part))
