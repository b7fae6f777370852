"""Checks for tests that need one which no part of the program makes."""

from typing import Any

from calc.sheet.check import RULES, Check, CheckRule
from calc.sheet.text import EMPTY, Text

NAME = Text("A check")


def rule(kind: str = "limit", unit: str = "", *, id: str = "step.object.name", **more: Any) -> CheckRule:
    """A declaration that the program does not know of."""
    role = more.pop("role", "physics" if kind == "limit" else "")
    declared = CheckRule(id, kind, "A rule of this test.", unit=unit, role=role, **more)
    del RULES[id]
    return declared


def made_check(
    value: float,
    sense: str = ">=",
    limit: float | tuple[float, float] = 1.0,
    kind: str = "limit",
    unit: str = "",
    *,
    id: str = "step.object.name",
    name: Text = NAME,
    source: Text = EMPTY,
    rule_of: dict[str, Any] | None = None,
    **more: Any,
) -> Check:
    """A check in shown units; `rule_of`: what else its declaration says."""
    return Check(rule(kind, unit, id=id, **(rule_of or {})), id, name, value, limit, sense, unit, source, **more)
