"""What several checks come to: counts, states and their words, the closest limit, groups."""

import math

import pytest

from calc.sheet.text import Text
from calc.sheet.verdict import (
    closest,
    colour_state,
    counts,
    design_state,
    findings_of,
    grouped,
    named,
    severity,
    step_state,
    verdict_words,
    with_it,
)
from tests.made_checks import made_check

# a check by kind, role and verdict
VALUE = {"pass": 2.0, "warn": 1.01, "note": 0.5, "fail": 0.5, "accepted": 0.5, "not_verified": 2.0}


def of(kind, role, verdict, **more):
    value = 0.5 if (kind, verdict) == ("caution", "warn") else VALUE[verdict]
    if verdict == "not_verified":
        more |= {"missing": ("a.b",), "at_best": 2.0, "at_worst": 0.5}
    if verdict == "accepted":
        more["accepted"] = "seen"
    check = made_check(value, kind=kind, rule_of={"role": role}, **more)
    assert check.verdict == verdict
    return check


LIMIT, CAUTION, ADVICE = "limit", "caution", "advice"


@pytest.mark.parametrize(
    "checks, computes, state",
    [
        ([(LIMIT, "physics", "pass"), (ADVICE, "", "note")], False, "pass"),
        ([(LIMIT, "physics", "pass"), (CAUTION, "", "warn")], False, "warn"),
        ([(LIMIT, "physics", "pass"), (CAUTION, "", "not_verified")], False, "warn"),
        ([(LIMIT, "physics", "pass"), (CAUTION, "", "accepted")], False, "pass"),
        ([(LIMIT, "physics", "warn")], False, "warn"),
        ([(LIMIT, "chosen", "pass")], False, "pass"),
        ([(LIMIT, "physics", "not_verified"), (CAUTION, "", "warn")], False, "not_verified"),
        ([(LIMIT, "self", "not_verified")], False, "not_verified"),
        ([(LIMIT, "physics", "not_verified"), (LIMIT, "physics", "fail")], False, "fail"),
        ([(CAUTION, "", "pass"), (ADVICE, "", "note")], False, "not_judged"),
        ([(CAUTION, "", "warn")], False, "not_judged"),
        ([(LIMIT, "self", "pass")], False, "not_judged"),
        ([(CAUTION, "", "pass"), (ADVICE, "", "note")], True, "computed"),
        ([(CAUTION, "", "accepted")], True, "computed"),
        ([], True, "computed"),
        ([(CAUTION, "", "warn")], True, "warn"),
        ([(CAUTION, "", "not_verified")], True, "warn"),
        ([(LIMIT, "self", "pass")], True, "computed"),
        ([(LIMIT, "self", "fail")], True, "fail"),
        ([(LIMIT, "self", "warn")], True, "computed"),
    ],
)
def test_the_state_of_a_step(checks, computes, state):
    assert step_state([of(*check) for check in checks], computes=computes) == state


@pytest.mark.parametrize(
    "checks, steps, state, words",
    [
        ([(LIMIT, "physics", "pass")], ["computed", "pass"], "pass", "PASS"),
        ([(LIMIT, "physics", "pass")], ["blocked"], "not_verified", "NOT VERIFIED"),
        ([(LIMIT, "physics", "fail")], ["blocked"], "fail", "FAIL: 1 failed"),
        ([(LIMIT, "physics", "fail")], ["no_solution"], "no_solution", "NO SOLUTION: 1 failed"),
        ([(CAUTION, "", "warn")] * 2, [], "not_judged", "NOT JUDGED: 2 cautions"),
        ([(LIMIT, "self", "pass"), (CAUTION, "", "pass")], [], "not_judged", "NOT JUDGED"),
        ([], ["computed"], "not_judged", "NOT JUDGED"),
        (
            [(LIMIT, "physics", "pass"), (CAUTION, "", "accepted"), (ADVICE, "", "accepted")],
            [],
            "pass",
            "PASS: 2 accepted",
        ),
        (
            [(LIMIT, "physics", "fail"), (LIMIT, "physics", "not_verified"), (CAUTION, "", "not_verified")],
            [],
            "fail",
            "FAIL: 1 failed, 1 not verified, 1 caution",
        ),
        (
            [(LIMIT, "physics", "warn"), (CAUTION, "", "warn"), (CAUTION, "", "warn"), (CAUTION, "", "accepted")],
            [],
            "warn",
            "WARN: 2 cautions, 1 narrow, 1 accepted",
        ),
    ],
)
def test_the_state_of_a_design_and_its_words(checks, steps, state, words):
    made_checks = [of(*check) for check in checks]
    assert design_state(made_checks, steps) == state
    assert verdict_words(state, counts(made_checks)) == words


def test_steps_without_a_solution_are_named() -> None:
    assert verdict_words("no_solution", counts([]), [Text("bearings")]) == "NO SOLUTION: bearings"


def test_what_nobody_judged_looks_open_as_soon_as_something_is() -> None:
    assert colour_state("not_judged", counts([of(CAUTION, "", "warn")])) == "warn"
    assert colour_state("not_judged", counts([])) == "not_judged"
    assert colour_state("fail", counts([of(CAUTION, "", "warn")])) == "fail"


def test_counts_count_each_check() -> None:
    checks = [
        of(LIMIT, "physics", "pass"),
        of(LIMIT, "self", "fail"),
        of(LIMIT, "chosen", "not_verified"),
        of(LIMIT, "physics", "warn"),
        of(CAUTION, "", "warn"),
        of(CAUTION, "", "not_verified"),
        of(CAUTION, "", "accepted"),
        of(ADVICE, "", "note"),
        of(ADVICE, "", "accepted"),
        of("method", "", "note"),
        of("method", "", "pass"),
    ]
    n = counts(checks)
    assert (n.limits, n.failed, n.not_verified, n.narrow, n.held) == (4, 1, 1, 1, 2)
    assert (n.cautions, n.accepted, n.advice, n.method) == (2, 2, 1, 1)
    held = counts([of(CAUTION, "", "pass"), of(CAUTION, "", "warn"), of(LIMIT, "physics", "pass")])
    assert (held.cautions_held, held.held) == (1, 1)
    assert [name for name, _ in n.words] == ["failed", "not_verified", "cautions", "narrow", "accepted"]


def test_the_closest_is_a_limit_or_a_caution_that_was_judged_and_a_limit_that_fails_before_all() -> None:
    far, near = made_check(9.0, id="far"), made_check(1.2, id="near")
    among = [
        far,
        made_check(1.1, id="self", rule_of={"role": "self"}),
        made_check(1.1, id="exact", rule_of={"exact": True}),
        made_check(1.1, id="advice", kind="advice"),
        made_check(1.1, id="unknown", missing=("a.b",), at_best=2.0, at_worst="none"),
        made_check(math.nan, id="nan"),
        near,
    ]
    assert closest(among) is near
    assert closest([among[1]]) is None
    chosen = made_check(1.1, id="chosen", rule_of={"role": "chosen"})
    warns, fails = made_check(0.5, id="warns", kind="caution"), made_check(0.9, id="fails")
    assert closest([*among, chosen]) is chosen and closest([*among, chosen, warns]) is warns
    assert closest([warns, fails, *among]) is fails


def test_a_group_stands_where_its_worst_check_does() -> None:
    checks = [
        made_check(0.5, kind="advice", id="note"),
        made_check(0.2, kind="caution", id="corner", cause="fails"),
        made_check(0.9, id="fails", cause="fails"),
        made_check(0.1, id="far"),
        made_check(9.0, id="holds", cause="fails"),
    ]
    groups = grouped(checks)
    assert [[c.id for c in group] for group in groups] == [["fails", "corner", "holds"], ["far"], ["note"]]
    assert findings_of(groups) == "3 findings (5 checks)"
    assert findings_of(groups[1:2]) == "1 finding"


def test_what_is_worse_stands_first() -> None:
    ordered = [
        made_check(0.9, kind="caution", rule_of={"of_input": True}, id="doubt"),
        made_check(math.nan, id="no number"),
        made_check(0.2, id="missed by far"),
        made_check(0.9, id="missed"),
        of(LIMIT, "physics", "not_verified", id="not verified"),
        made_check(1.01, id="narrow"),
        of(CAUTION, "", "not_verified", id="not verified either"),
        made_check(0.2, kind="caution", id="caution"),
        made_check(0.1, kind="advice", id="note"),
        made_check(2.0, kind="caution", rule_of={"of_input": True}, id="no doubt"),
        made_check(2.0, id="holds"),
        made_check(3.0, id="holds by far"),
        of(CAUTION, "", "accepted", id="accepted"),
    ]
    assert [c.id for c in sorted(reversed(ordered), key=severity)] == [c.id for c in ordered]


def test_of_many_checks_the_rest_is_a_number() -> None:
    checks = [made_check(0.5, name=Text(name)) for name in "abcde"]
    assert with_it(checks[:3]) == "With it 3 failed: a (−50 %); b (−50 %); c (−50 %)"
    assert with_it(checks) == "With it 5 failed: a (−50 %); b (−50 %); c (−50 %); 2 more"
    assert named(checks) == "a (−50 %); b (−50 %); c (−50 %); 2 more"
    assert named(checks[:2], 1) == "a (−50 %); 1 more"
