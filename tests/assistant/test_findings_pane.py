# SPDX-License-Identifier: Apache-2.0
"""The findings of a step: in groups, folded, told in full under the cursor; and how it looks in any width."""

import math
from dataclasses import replace

import pytest
import tomli_w

from assistant.screens.ready import Closing, _joined
from assistant.session.calculation import _slope, _step, slopes_of_check, slopes_of_input
from assistant.session.session import Session
from assistant.session.wording import not_repeated
from assistant.widgets.checks import Checks
from assistant.widgets.lines import MessageLine
from assistant.widgets.signs import Signs
from assistant.widgets.steps import READY, Steps
from assistant.widgets.text import bar
from calc.design.toml_file import read
from calc.sheet.check import Check
from calc.sheet.text import Text
from calc.sheet.verdict import findings_of, open_findings
from calc.studies.explain import effects, moved_by
from calc.studies.headlines import lead
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import settled, strike, until, work
from tests.conftest import DESIGNS
from tests.made_checks import made_check

EDGE = "bearings.front.film_edge"
LENGTH = "shafts.shaft.bearings.front.length_mm"


def rows(checks: Checks) -> dict[str, str]:
    return {item.key: " ".join(row.plain for row in item.rows) for item in checks.items if item.key}


async def test_findings_are_grouped_and_told_under_the_cursor(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        await strike(pilot, "escape", "4", "f7")
        await settled(pilot)
        checks = work(pilot).query_one(Checks)
        await until(pilot, lambda: "per 0.5 mm" in rows(checks)[EDGE])  # the slopes follow
        shown, outcome = rows(checks), work(pilot).session.results.outcomes["bearings"]
        groups = open_findings(outcome.checks)
        assert list(shown) == [*(group[0].id for group in groups), "advice", "method", "hold"]
        assert groups[0][0].id == EDGE and f"({len(groups[0])} checks)" in shown[EDGE]
        assert "7.41 of 9 µm" in shown[EDGE] and "most: length of front +0.2 µm " in shown[EDGE]
        second = groups[1][0]
        await strike(pilot, "down")
        assert checks.key == second.id and len(rows(checks)[second.id]) > len(shown[second.id])
        assert "7.41 of" not in rows(checks)[EDGE]
        # it speaks of what is under the cursor
        assert str(second.name) in work(pilot).query_one(MessageLine).message()[1]
        await strike(pilot, "up", "right", "down")
        assert checks.key == groups[0][1].id
        await strike(pilot, "left")
        assert checks.key == EDGE and len(rows(checks)) == len(shown)
        await strike(pilot, "end", "enter")
        ticks, held = sum("✓" in row for row in rows(checks).values()), sum(not check.open for check in outcome.checks)
        assert rows(checks)["hold"] == f"✓ {held} hold ▾" and ticks == held + 1 > 40
        await strike(pilot, "5")
        await settled(pilot)
        first = " ".join(" ".join(row.plain for row in checks.items[0].rows).split())
        assert str(lead(work(pilot).session.results, "gears", brief=True)) == first and first.startswith("Rattle at")


@pytest.mark.slow
async def test_what_holds_outside_the_validity_of_its_formula_has_no_tick(screen: Screen, session: Session) -> None:
    """What puts it there is said once, where the cursor is."""
    method = made_check(0.5, kind="method", id="gears.a_b.line_load", name=Text("Load per face width"))
    ends = {"at_best": 2.0, "at_worst": 1.5}
    check = made_check(2.0, id="gears.a_b.safety", outside=(method.id,), **ends)  # type: ignore[arg-type]
    async with screen(session=session) as pilot:
        checks = work(pilot).query_one(Checks)
        assert session.results is not None
        checks.show(replace(session.results.outcomes["gears"], checks=(method, check, made_check(2.0, id="gears.x"))))
        checks.focus()
        await settled(pilot)
        assert checks.go_to(check.id)
        shown = rows(checks)
        assert shown[check.id].startswith("•") and shown["gears.x"].startswith("✓")
        told = " ".join(shown[check.id].split())
        assert told.count("outside the validity of its formula: Load per face width (") == 1
        assert "At best 2, at worst 1.5." in told


async def test_a_step_says_its_state_and_how_many_findings_are_listed(screen: Screen, session: Session) -> None:
    """As `check` does; the checks that are not listed stand in the rows that unfold them."""
    async with screen(session=session, size=(120, 40)) as pilot:
        await strike(pilot, "escape", "4")
        await settled(pilot)
        bench = work(pilot)
        checks, outcome = bench.query_one(Checks), bench.session.results.outcomes["bearings"]
        listed = open_findings(outcome.checks)

        def heads() -> list[str]:
            return [item.key for item in checks.items if item.key not in ("", "advice", "method", "hold")]

        # beside other panes the worst by their names, of the rest how many, with the worst margin
        assert [row.plain for row in checks.items[0].rows] == ["✗ FAIL"] and bench.pane_named("checks").right == ""
        assert heads()[0] == listed[0][0].id
        assert sum(row.startswith("▲ 2 cautions ▸") and row.endswith("−39 %") for row in rows(checks).values()) == 1
        notes = sorted((c.margin for c in outcome.checks if c.verdict == "note"), key=float)
        assert rows(checks)["advice"].startswith(f"• {len(notes)} notes ▸ ") and rows(checks)["advice"].endswith(
            "−19 %"
        )
        checks.focus()
        await settled(pilot)
        assert [row.plain for row in checks.items[0].rows] == [f"✗ {outcome.words()}"]
        assert heads() == [group[0].id for group in listed]
        await pilot.resize_terminal(80, 24)
        await settled(pilot)
        assert bench.pane_named("checks").right == findings_of(listed) and heads() == [group[0].id for group in listed]


@pytest.mark.slow
async def test_what_is_not_given_is_told_with_what_was_taken_and_both_ends(screen: Screen, session: Session) -> None:
    key, taken = "bearings.oil", (Text("235 MPa"),)

    def told(**more: object) -> str:
        check = made_check(10.0, limit=9.0, unit="µm", id="bearings.front.x", **more)  # type: ignore[arg-type]
        return " ".join(" ".join(row.plain.split()) for row in checks._detail(check, 100))

    async with screen(session=session) as pilot:
        checks = work(pilot).query_one(Checks)
        unknown = told(missing=(key,), taken=taken, at_best=12.0, at_worst="none")
        assert "Not given: oil; taken: 235 MPa. At best 12 µm, at worst nobody knows." in unknown
        assert "At best it can not fail, at worst 7 µm." in told(
            missing=(key,), taken=taken, at_best="holds", at_worst=7.0
        )
        holds = told(missing=(key,), taken=taken, at_best=12.0, at_worst=9.5)
        assert "Assumed: 235 MPa." in holds and "Not given" not in holds and "at worst" not in holds


async def test_columns_never_collide(screen: Screen, session: Session) -> None:
    """In rows with numbers there are two cells between all of them, and no row is wider than the list."""
    async with screen(session=session, size=(120, 40)) as pilot:
        await strike(pilot, "escape", "5")
        await settled(pilot)
        await solved(pilot)
        checks = work(pilot).query_one(Checks)
        checks.unfolded = {"advice", "method", "hold"}
        found = {check.id: check for check in checks.outcome.checks} if checks.outcome is not None else {}
        say = work(pilot).app.say
        for width in (12, 30, 48, 80, 120, 200):
            items = checks.build(width)
            for item in items:
                for row in item.rows if width >= 30 else ():
                    assert row.cell_length <= width, row.plain
            for item in items[1:] if width >= 120 else ():
                if check := found.get(item.key):
                    assert f"  {say(check.limit_text())}  " in item.rows[0].plain + "  "


@pytest.mark.slow
@pytest.mark.parametrize("size", [(20, 10), (12, 5), (5, 3)])
async def test_a_window_that_is_too_small_says_so(screen: Screen, session: Session, size: tuple[int, int]) -> None:
    async with screen(session=session, size=size) as pilot:
        for key in ("escape", "f7", "down", "right", "f6", "D", "down", "escape", "f4", "6"):
            await strike(pilot, key)
            await settled(pilot)
        top = pilot.app.screen._compositor.render_strips()[0].text
        assert "needs 60" in top or "too small" in top or size[0] < 10


@pytest.mark.slow
async def test_a_step_is_left_for_the_closing_page(screen: Screen, session: Session) -> None:
    """The last row of the steps; it says on its page what is left."""
    async with screen(session=session, size=(120, 40)) as pilot:
        steps = work(pilot).query_one(Steps)
        work(pilot).action_to_view("steps")
        await settled(pilot)
        assert steps.go_to(READY)
        await strike(pilot, "enter")
        await until(pilot, lambda: type(pilot.app.screen).__name__ == "ReadyScreen")
        await settled(pilot)
        told = " ".join(row.plain for item in pilot.app.screen.query_one(Closing).items for row in item.rows)
        assert "not usual (1)" in told and "span allowance of central −2 µm (usual −80 to −20)" in told


def test_slopes_are_told_in_labels_and_units(session: Session) -> None:
    """What moves the limit says so; one unit that does next to nothing is told for more of it."""
    session.solve()
    results = session.results
    assert results is not None
    check = next(check for check in results.checks() if check.id == EDGE)
    found = effects(session.document, results, [check], 5)[EDGE]
    assert (
        str(slopes_of_check(session.data, check, found))
        == "length of front +0.2 µm per 0.5 mm; roughness Ra, journal of front: limit +0.75 µm per 0.1 µm"
    )
    moved = str(slopes_of_input(session.data, LENGTH, moved_by(session.document, results, LENGTH)))
    assert moved.startswith("film at the edge over the speeds, thinnest at 2497 rpm, front +0.21 µm per 0.5 mm; ")


def test_what_lacks_the_same_in_one_step_is_said_once() -> None:
    def lacking(step: str, *missing: str) -> Check:
        return made_check(1.0, id=f"{step}.{missing[0]}", missing=missing)

    groups = [
        [lacking(*each)] for each in (("gears", "a", "b"), ("gears", "c"), ("gears", "b", "d"), ("friction", "a"))
    ]
    assert [[check.id for check in one] for one in _joined(groups)] == [
        ["gears.c"],
        ["gears.a", "gears.b"],
        ["friction.a"],
    ]
    assert not_repeated(["span of central 2 mm", "span of idler 3 mm", "mass 2 kg"]) == [
        "span of central 2 mm",
        "idler 3 mm",
        "mass 2 kg",
    ]


def test_a_bar_shows_on_which_side_of_its_limits_a_value_is_right() -> None:
    signs, plain = Signs(), Signs(ascii=True)

    def drawn(value: float, low: float | None, high: float | None) -> str:
        return bar(value, low, high, signs).plain

    assert drawn(7.41, 9, None) == "╌╌╌╌●┃━━" and drawn(20, 9, None) == "╌╌╌┃━━━●"  # at least 9
    assert drawn(0.5, None, 1) == "━━●━━┃╌╌" and drawn(3, None, 1) == "━━┃╌╌╌╌●"  # at most 1
    assert [drawn(x, 0.25, 0.8) for x in (0.2, 0.64, 0.9)] == ["●┃━━━━┃╌", "╌┃━━●━┃╌", "╌┃━━━━┃●"]
    assert drawn(-7, -5, None) == drawn(7, None, 5)  # below nought more lies farther out
    assert bar(7.41, 9, None, plain).plain == "....o|=="
    for low, high in ((9, None), (None, 1), (None, 0), (0.25, 0.8)):  # what lies far beyond stands at the end
        assert drawn(math.inf, low, high)[-1] == "●" == drawn(-math.inf, low, high)[0]
        assert drawn(1e9, low, high)[-1] == "●" == drawn(-1e9, low, high)[0]
    assert drawn(-math.inf, -5, None) == drawn(math.inf, None, 5)
    for n in range(1, 400):
        value, limit = n / 100, 1.0
        for low, high in ((limit, None), (None, limit)):
            line = drawn(value, low, high)
            beyond = line.index("●") > line.index("┃")
            assert len(line) == 8 and beyond == (value > limit or (value == limit and high is None))
            assert ("━" in line[line.index("┃") :]) == (low is not None)


def test_a_slope_is_told_for_the_step_by_which_one_goes_on() -> None:
    data = {"shafts": [{"name": "a"}], "engine": {"bore_mm": 94.0, "cylinders": 3, "rated_speed_rpm": 2600.0}}
    told = {key: _step(data, key) for key in ("engine.bore_mm", "engine.cylinders", "engine.rated_speed_rpm")}
    assert told == {
        "engine.bore_mm": (10.0, "mm"),
        "engine.cylinders": (1.0, ""),
        "engine.rated_speed_rpm": (100.0, "rpm"),
    }
    moved = _slope(Text("clearance"), -0.05, "µm", (10.0, "µm"))
    assert str(moved) == "clearance −0.5 µm per 10 µm"
    assert str(_slope(Text("film"), 2e-4, "µm", (0.5, "K"))) == "film +0.01 µm per 50 K"
    assert str(_slope(Text("oil"), 0.7, "°C", (1.0, "K"))) == "oil +0.7 K per K"


async def test_nobody_waits_for_remedies_that_take_long(screen: Screen, session: Session) -> None:
    """The line below the panes goes without them; beside the finding they follow once it is looked at."""
    document = read(DESIGNS / "r753ie4_drive_over_speed.toml").with_value("engine.flywheel_inertia_kgm2", 0.3)
    assert session.path is not None
    session.path.write_text(tomli_w.dumps(document.data), encoding="utf-8")
    light = Session.open(session.path, memory=session.memory)
    async with screen(session=light) as pilot:
        await solved(pilot)
        assert light.results is not None
        rattle = light.results.check("gears.crank_central.rattle")
        assert rattle is not None and rattle.open
        await strike(pilot, "escape", "5")
        await settled(pilot)
        assert rattle.waits
        await strike(pilot, "f7")
        checks = work(pilot).query_one(Checks)
        for _ in range(20):
            if checks.key == rattle.id:
                break
            await strike(pilot, "down")
        await until(pilot, lambda: not rattle.waits)
        await until(pilot, lambda: "for this check alone" in rows(checks)[rattle.id])
