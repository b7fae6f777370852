"""What is open, on one screen."""

from dataclasses import asdict

import pytest

from assistant.results_text import check_json, finding_lines, print_results, results_json
from calc.design import replay
from calc.design.toml_file import design, read
from calc.sheet.check import SIGNS
from calc.sheet.record import replace
from calc.sheet.text import Text
from calc.sheet.verdict import TITLES
from calc.solve import solve
from calc.studies.shipped import DESIGNS
from tests.conftest import ROOT, each_shipped
from tests.made_checks import made_check


def made(id, kind, value, **more):
    rule_of = {key: more.pop(key) for key in ("demand",) if key in more}
    return made_check(
        value,
        kind=kind,
        unit="mm",
        id=id,
        name=Text("The size of {id}", id=id),
        source=Text("a source"),
        advice=Text("Do something."),
        rule_of=rule_of,
        **more,
    )


LACK = {"missing": ("gears.housing_material",), "taken": (Text("aluminium"),), "at_best": 3.0, "at_worst": 0.5}


def printed(*checks, everything=False):
    return "\n".join(finding_lines(checks, everything))


@pytest.mark.parametrize("file", each_shipped())
def test_what_is_open_fits_on_a_screen(file):
    lines = list(finding_lines(list(solve(design(read(file))).checks())))
    assert len(lines) <= 1 + 48 and max(map(len, lines), default=0) <= 160


def test_limits_stand_first_and_a_cause_by_its_worst_check():
    text = printed(
        made("a.note", "advice", 0.5),
        made("a.caution", "caution", 0.5),
        made("a.limit", "limit", 0.9),
        made("a.corner", "caution", 0.2, cause="a.limit"),
        made("a.holds", "limit", 9.0),
    )
    assert [line for line in text.splitlines() if not line.startswith(" ")] == [
        "2 findings (3 checks)",
        "✗ FAIL  The size of a.limit: 0.9 mm, needs ≥ 1 mm (−10 %)  [a.limit]",
        "▲ warn  The size of a.caution: 0.5 mm, needs ≥ 1 mm (−50 %)  [a.caution]",
        "• note  1 piece of advice: The size of a.note (−50 %)",
    ]
    assert "With it 1 caution: a.corner (−80 %)" in text and "a source" not in text and "a.holds" not in text


def test_everything_is_every_finding_in_full():
    checks = [
        made("a.note", "advice", 0.5),
        made("a.limit", "limit", 0.9),
        made("a.corner", "caution", 0.2, cause="a.limit"),
    ]
    text = printed(*checks, everything=True)
    assert text.count("Do something.") == 3 and "With it" not in text and "piece of advice" not in text
    assert text.count("a source") == 3
    assert text.startswith("1 finding (2 checks)\n")


def test_what_is_missing_and_what_is_accepted_is_said():
    text = printed(
        made("a.limit", "limit", 2.0, **LACK), made("a.caution", "caution", 0.5, accepted="seen on the bench")
    )
    lines = " ".join(text.split())
    assert "? not verified The size of a.limit" in lines
    assert "Not given: gears.housing_material; taken: aluminium. At best 3 mm, at worst 0.5 mm." in lines
    assert "✓ accepted  The size of a.caution: 0.5 mm, needs ≥ 1 mm (−50 %): seen on the bench" in text


def test_several_that_are_not_given_are_named_without_what_they_share():
    keys = ("gears.wheels.a.runout_um", "gears.wheels.b.runout_um", "gears.wheels_warmer_K")
    lack = LACK | {"missing": keys, "taken": (Text("runout 30 µm"), Text("runout 31 µm"), Text("20 K"))}
    check = made("gears.a_b.backlash", "limit", 2.0, **lack)
    short = "Not given: runout_um of a, b; wheels_warmer_K. At best 3 mm, at worst 0.5 mm. Do something."
    assert short in printed(check) and "taken" not in printed(check)
    whole = " ".join(printed(check, everything=True).split())
    assert f"Not given: {', '.join(keys)}; taken: {'; '.join(lack['taken'])}. At best 3 mm" in whole


def test_what_holds_by_what_is_assumed_is_counted_once_for_each_check():
    held = [made(f"a.n{n}", "limit", 2.0, **LACK | {"at_worst": 1.5}) for n in range(2)]
    assert printed(held[0]) == "• note  1 check holds by what is assumed: aluminium"
    assert printed(*held) == "• note  2 checks hold by what is assumed: aluminium"
    many = [made(f"a.m{n}", "limit", 2.0, **LACK | {"at_worst": 1.5, "taken": (Text(f"t{n}"),)}) for n in range(6)]
    assert "assumed: t0; t1; t2; t3; 2 more" in printed(*many) and "assumed" not in printed(made("a.b", "limit", 2.0))


def test_many_of_one_cause_are_counted():
    many = [made(f"a.{'n' * 25}{n}", "caution", 0.5, cause="a.limit") for n in range(5)]
    text = printed(made("a.limit", "limit", 0.9), *many)
    assert text.endswith(f"a.{'n' * 25}1 (−50 %); 3 more")
    alone = replace(made("a.b", "caution", 0.5, cause="a.limit"), name=Text("The size of"))
    assert "With it 1 caution: The size of (−50 %)" in printed(made("a.limit", "limit", 0.9), alone)


def test_a_row_of_the_json_has_all_that_a_check_knows():
    check = made("a.limit", "limit", 2.0, demand=True, moved_by=("gears.power_kW",), outside=("a.method",), **LACK)
    row = check_json(check)
    assert (row["kind"], row["role"], row["cause"], row["utilisation"]) == ("limit", "physics", "a.limit", 0.5)
    assert (row["gap"], row["scale"], row["margin"]) == (1.0, 1.0, 1.0)
    assert (row["finding"], row["verdict"], row["outside"]) == ("not_verified", "not_verified", ["a.method"])
    assert (row["missing"], row["taken"]) == (["gears.housing_material"], ["aluminium"])
    assert (row["at_best"], row["at_worst"]) == (3.0, 0.5)
    assert row["moved_by"] == [{"key": "gears.power_kW", "slope": None, "gain": None, "unit": ""}]
    assert row["remedies"] == []
    ends = [
        check_json(made("a.b", "limit", 2.0, **LACK | {"at_best": "holds", "at_worst": end})) for end in ("none", 1)
    ]
    assert [(row["at_best"], row["at_worst"]) for row in ends] == [("holds", "none"), ("holds", 1)]
    plain = check_json(made("a.caution", "caution", 0.5, accepted="seen"))
    assert (plain["at_best"], plain["at_worst"], plain["role"]) == (None, None, "")
    assert (plain["finding"], plain["verdict"], plain["accepted"]) == ("warn", "accepted", "seen")


def test_what_holds_by_a_formula_outside_its_validity_is_counted():
    method = made("gears.a_b.line_load", "method", 0.5)
    outside = {"outside": (method.id,), "at_best": 2.0, "at_worst": 1.5}
    held = made("gears.a_b.safety_contact", "limit", 2.0, **outside)
    line = "1 check holds by a formula outside its validity: The size of gears.a_b.line_load (−50 %)"
    assert line in printed(method, held) and "outside" not in printed(method, replace(held, outside=()))
    lost = replace(held, at_worst=0.9)
    text = " ".join(printed(method, lost).split())
    assert "? not verified The size of gears.a_b.safety_contact" in text and "holds by" not in text
    assert "Outside validity: gears.a_b.line_load. At best 2 mm, at worst 0.9 mm." in text


# --- one object, one screen

OLD = sorted((ROOT / "tests" / "reference" / "designs_0_1").glob("*.toml"))


@pytest.mark.parametrize(
    "file", [*each_shipped(), *(pytest.param(file, id=f"{file.parent.name}/{file.stem}") for file in OLD)]
)
def test_plain_text_json_and_replay_give_one_state(file, tmp_path, capsys):
    document = read(file)
    results = solve(design(document))
    found = results_json(document, results)
    print_results(results)
    first, *rest = capsys.readouterr().out.split("\n")
    assert first == results.words() and (found["schema"], found["verdict"]) == (2, results.verdict)
    assert found["counts"] == asdict(results.counts)
    (state, words) = (first.partition(": ")[0], dict(results.counts.words))
    assert state == TITLES[results.verdict] and all(text in first for text in words.values())
    verdicts = [(row["kind"], row["verdict"]) for row in found["checks"]]
    assert found["counts"]["failed"] == verdicts.count(("limit", "fail"))
    assert found["counts"]["not_verified"] == verdicts.count(("limit", "not_verified"))
    listed = [line for line in rest if line.startswith(tuple(SIGNS.values()))]
    if found["counts"]["failed"]:
        assert sum(line.startswith("✗ FAIL") for line in listed) > 0
    script = f'schema = 1\ndesign = "{file}"\n[[expect]]\ndesign = "{results.verdict}"\n'
    script += "".join(f'[[expect]]\nstep = "{key}"\nverdict = "{verdict}"\n' for key, verdict in found["steps"].items())
    (tmp_path / "r.toml").write_text(script, encoding="utf-8")
    assert all(c.agrees for c in replay.run(replay.load(tmp_path / "r.toml"), lambda d, before: results))


def test_one_step_has_its_own_state(capsys):
    document = read(DESIGNS / "r753ie4_gamma.toml")
    results = solve(design(document))
    for key, outcome in results.outcomes.items():
        found = results_json(document, results, key)
        assert (found["verdict"], found["counts"]) == (outcome.verdict, asdict(outcome.counts))
        print_results(results, key)
        assert capsys.readouterr().out.split("\n")[0] == outcome.words()
