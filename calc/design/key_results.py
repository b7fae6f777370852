# SPDX-License-Identifier: Apache-2.0
"""What of a design an engineer looks at first: the results of the first page, and which of its verdicts
stand on a formula outside its validity.

Which results, curves and tables stand in a short report, they say themselves (`short=`, `page_one=`)."""

from collections.abc import Iterable, Mapping
from operator import attrgetter

from ..sheet.check import Check
from ..sheet.quantity import Described, Published, ValueKey, dotted
from .model import STEP_KEYS, Design

Line = tuple[str, int, str]  # a line of the first page: its step, its place there, and the part that it is of


def key_results(values: Mapping[str, Published]) -> dict[Line, Published]:
    """The results of the first page by its lines, each of the part where it is worst; no imbalance that the engine does
    not have, and no couple that shafts of forces have not."""
    from ..countershaft.sums import NOTHING, SystemResult  # with numpy, which the session begins without
    from ..gears.result import ShaftTurn

    lines: dict[Line, list[Published]] = {}
    for v in values.values():
        if v.page_one and v.shown == v.shown:
            part = v.id.rpartition(".")[0] if v.about.each else ""
            lines.setdefault((v.id.partition(".")[0], v.page_one, part), []).append(v)
    worst = {}
    for line in sorted(lines, key=lambda line: (STEP_KEYS.index(line[0]), line[1])):  # of one place each as it comes
        values_of_line = lines[line]
        worst[line] = (min if is_least(values_of_line[0]) else max)(values_of_line, key=attrgetter("shown"))
    nothing = {v.about for v in worst.values() if abs(v.inside) <= NOTHING}
    silent = nothing.intersection(map(_about, (SystemResult.roll_left_order_1, SystemResult.roll_left_order_2)))
    for couple, force in (
        (SystemResult.residual_order_1_couple, SystemResult.residual_order_1_force),
        (SystemResult.residual_order_2_couple, SystemResult.residual_order_2_force),
        (ShaftTurn.residual_couple, ShaftTurn.residual_force),
    ):
        if _about(couple) in nothing and _about(force) not in nothing:
            silent.add(_about(couple))
    if _about(ShaftTurn.residual_couple) not in silent:  # one of both is enough
        silent.add(_about(ShaftTurn.residual_force))
    return {
        line: v
        for line, v in worst.items()
        if v.about not in silent and (v.shown or line[0] != dotted(Design.imbalance))
    }


def _about(field: object) -> Described:
    assert isinstance(field, ValueKey), field
    return field.about


def is_least(v: Published) -> bool:
    """Whether the least of such results is the worst."""
    return v.about.worst == "least"


def outside(check: Check, checks: Iterable[Check]) -> list[Check]:
    """The checks of the method, among those of its step, that put a check outside the validity of its formula."""
    return [method for method in checks if method.id in check.outside] if check.outside else []


def judged(check: Check) -> str:
    """The verdict of a check; one that holds by a formula outside its validity is not called a pass."""
    return "outside" if check.verdict == "pass" and check.outside else check.verdict
