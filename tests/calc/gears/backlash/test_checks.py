"""Each check of the backlash just inside and just outside its limit, and with what is not given at both of its ends."""

import math
from dataclasses import replace

import pytest

from calc.gears.backlash import temperature as t
from calc.gears.backlash.case import cases
from calc.gears.backlash.chance import by_chance
from calc.gears.backlash.checks import JudgedMesh, checks
from calc.gears.backlash.solve import play
from tests.calc.gears.backlash.plays import SOLIDS, changed, parts, played
from tests.calc.gears.trains import pair_1, solved

UM = 1e-6
GIVEN = {"housing_material": "EN-GJL-250", "wheels_warmer": 20.0, "lowest_temperature": -30.0}
RUNOUTS = {"central": {"runout": 16e-6}, "idler": {"runout": 20e-6}}
STATES = {"backlash_cold": (0,), "backlash_warm": (1, 2), "backlash_warming": (3,)}
PARTS = parts("position", {"pin": 0.06, "bore": 0.03})


def given(**said):
    """The source's first pair with thinner teeth, of which nothing is left out."""
    gears = changed(pair_1(allowances=((-60, -70), (-60, -70))), wheels=RUNOUTS, stack=PARTS)
    return replace(gears, **{**GIVEN, **said})


def judged(gears=None, *, state=None, mesh=None, **values):
    """The checks by their last words, with `values` of the play in place of those that are solved, `mesh`: of the mesh,
    and `state`: the backlash of the thermal states by their numbers."""
    gears = given() if gears is None else gears
    train = solved(gears)
    (m,) = cases(gears, train)
    m = replace(m, mesh=replace(m.mesh, **(mesh or {})))
    alpha = t.expansions(m, gears, SOLIDS, gears.housing_material)
    at = []
    for i, where in enumerate(t.states(gears, gears.warmer)):
        grown = t.grown(m, alpha, where.housing, where.wheels)
        there = t.at_state(m, grown, m.closest, *(tooth.thickest for tooth in m.teeth))
        at.append(replace(there, backlash=(state or {}).get(i, there.backlash)))
    result = replace(play(gears, train, SOLIDS, gears.housing_material).meshes[m.key], **values)
    chance = by_chance([m], train.tree, ["idler"], {})
    of = JudgedMesh(m, result, at, t.housings(gears, m, alpha, SOLIDS))
    return {c.id.rpartition(".")[2]: c for c in checks(gears, of, gears.housing_material, chance)}


def of(check_id, j_bn):
    """The check with this backlash in its place."""
    if check_id in STATES:
        return judged(state=dict.fromkeys(STATES[check_id], j_bn))[check_id]
    name = {"backlash": "backlash_min_runout", "backlash_chance": "backlash_99", "backlash_worst": "backlash_min_worst"}
    return judged(**{name[check_id]: j_bn})[check_id]


SOURCES = {
    "backlash": "geometry: teeth must not jam at any combination of the tolerances where both wheels stand closest",
    "backlash_cold": "geometry, teeth must not jam at any temperature: cold start, all at −30 °C, with runout",
    "backlash_warm": "geometry, teeth must not jam at any temperature: all at 100 °C, with runout",
    "backlash_warming": "housing still at −30 °C, wheels 20 K warmer, with runout",
    "backlash_chance": "of which 99 % turn freely at 20 °C",
    "backlash_worst": "geometry, worst case: the centres ±45 µm, with runout",
}


@pytest.mark.parametrize(("id", "source"), SOURCES.items())
def test_no_backlash_may_be_below_nothing(id, source):
    """The margin is a share of the recommended backlash: below a twentieth of it a limit is narrow."""
    recommended = judged()["backlash_guide"].limit * UM
    free, little, none, jammed = (of(id, j) for j in (0.051 * recommended, 0.049 * recommended, 0.0, -0.001 * UM))
    kind = "limit" if id in ("backlash", *STATES) else "caution"
    assert {c.kind for c in (free, jammed)} == {kind} and free.role == ("physics" if kind == "limit" else "")
    close, failed = ("warn", "fail") if kind == "limit" else ("pass", "warn")
    assert [c.verdict for c in (free, little, none, jammed)] == ["pass", close, close, failed]
    assert (free.margin, free.limit) == (pytest.approx(0.051), 0.0)
    assert jammed.value == pytest.approx(-0.001) and source in str(free.source)


def test_warm_is_the_tighter_of_both_states():
    for tight, loose, id in ((1, 2, "backlash_running"), (2, 1, "backlash_warmer")):
        check = judged(state={tight: 3 * UM, loose: 4 * UM})["backlash_warm"]
        assert check.value == pytest.approx(3.0) and check.value_id == f"gears.central_idler.{id}"
    assert "wheels 20 K warmer" in check.source


@pytest.mark.parametrize(("low", "verdict"), [(0.107, "pass"), (0.1069, "note")])
def test_the_guide(low, verdict):
    check = judged(mesh={"backlash_min": low * 1e-3}, backlash_recommended=0.107e-3)["backlash_guide"]
    assert (check.verdict, check.kind, str(check.source)) == (verdict, "advice", "ISO/TR 10064-2")
    assert check.value == pytest.approx(low * 1e3) and check.limit == pytest.approx(107)


def test_what_the_guide_advises_just_passes():
    gears = given()
    short = judged(gears)["backlash_guide"]
    ((key, ends),) = short.remedies[0].changes
    thinner = {key.split(".")[2]: {"span_allowance": tuple(end * UM for end in ends)}}
    there = judged(changed(gears, wheels=thinner))["backlash_guide"]
    assert (short.verdict, there.verdict) == ("note", "pass") and there.gap < 1


def test_the_guide_asks_for_whole_micrometres():
    """What is short by 5 µm loses 5 µm of its span, and by a little more than that 6 µm."""
    for low, less in ((102.0, 5), (101.999, 6)):
        check = judged(mesh={"backlash_min": low * UM}, backlash_recommended=107 * UM)["backlash_guide"]
        assert check.remedies[0].changes[0][1] == [-60 - less, -70 - less]


def slope_at(m, T):
    """Backlash per centre distance at 20 °C, all in steel but a housing of cast iron, where the wheels stand closest;
    and how much the wheels grow."""
    wheels, housing = (1 + SOLIDS[name].expansion * (T - 20) for name in ("steel", "EN-GJL-250"))
    angle = math.acos(m.touching * wheels / (m.closest * housing))
    return 2 * math.sin(angle) * math.cos(m.system.base_helix_angle) * housing, wheels


@pytest.mark.parametrize("T, id", [(20.0, "backlash"), (-60.0, "backlash_cold"), (100.0, "backlash_warm")])
def test_what_would_just_pass_is_exact(T, id):
    """To a hundredth of a micrometre: of the span by the growth of the wheels, of the tolerance of 55 µm by the slope
    there; beyond what makes the margin wide enough."""
    gears = replace(changed(given(lowest_temperature=-60.0, wheels_warmer=0.0), stack=()), running_temperature=100.0)
    (m,) = cases(gears, solved(gears))
    slope, growth = slope_at(m, T)
    plain = judged(gears)[id]

    def ways(short):
        j_bn = -short + 0.05 * plain.zero_scale * UM
        values = {"backlash_min_runout": j_bn} if id == "backlash" else {"state": dict.fromkeys(STATES[id], j_bn)}
        return [way.changes[0][1] for way in judged(gears, **values)[id].remedies]

    for over, less in ((-0.01, 41), (0.01, 42)):
        assert ways((41 + over) * growth * UM)[0] == [-60 - less, -70 - less]
    for held, tolerance in ((25.99, 25), (26.01, 26), (1.01, 1)):
        assert ways((55 - held) * slope * UM)[1] == tolerance
    assert len(ways((55 - 0.99) * slope * UM)) == 1  # no tolerance is small enough


def test_the_worst_of_what_is_not_given_is_freed():
    """35.3 µm short in a housing of aluminium, where the one that is taken lacks 14 µm."""
    shaved = {"span_allowance": (-20 * UM, -30 * UM)}
    gears = changed(given(housing_material=None), wheels={"central": shaved, "idler": shaved})
    check = judged(gears)["backlash_cold"]
    assert -check.value + 0.05 * check.zero_scale < 15 and check.at_worst == pytest.approx(-35.27, abs=0.01)
    assert check.remedies[0].changes[0][1] == [-56, -66]


@pytest.mark.parametrize("thin, thick", [("central", "idler"), ("idler", "central")])
def test_the_thicker_of_both_teeth_is_thinned(thin, thick):
    for ends, new in (((-40 * UM, -50 * UM), [-45, -55]), (None, [-5, -5])):
        gears = changed(
            given(), wheels={thin: {"span_allowance": (-60 * UM, -70 * UM)}, thick: {"span_allowance": ends}}
        )
        check = judged(gears, mesh={"backlash_min": 102 * UM}, backlash_recommended=107 * UM)["backlash_guide"]
        assert check.remedies[0].changes == ((f"gears.wheels.{thick}.span_allowance_um", new),)


@pytest.mark.parametrize(("rss", "verdict"), [(55.0, "pass"), (55.01, "warn")])
def test_the_parts_between_the_centres(rss, verdict):
    check = judged(centre_tolerance_rss=rss * UM)["stack"]
    assert (check.verdict, check.kind, check.limit) == (verdict, "caution", pytest.approx(55))
    assert "must hold what its parts add up to" in check.source
    if not check.holds:
        (way,) = check.remedies
        assert way.changes == (("gears.meshes.0.tolerance_um", 56),) and "at least 56 µm" in way.words
    assert "stack" not in judged(changed(given(), tolerance=None))


def test_parts_that_stand_beside_no_tolerance_have_a_margin():
    check = judged(changed(given(), tolerance=0.0), centre_tolerance_rss=20 * UM)["stack"]
    assert (check.verdict, check.margin) == ("warn", pytest.approx(-1))


# --- what is not given


def at_ends(check, best, worst):
    """That a check has the values of these checks at its ends, or these words."""
    assert check.at_best == (best if isinstance(best, str) else pytest.approx(best.value, abs=1e-9))
    assert check.at_worst == (worst if isinstance(worst, str) else pytest.approx(worst.value, abs=1e-9))


ALL = (*SOURCES,)
TEMPERED = (*STATES,)


def test_nothing_is_missing_where_all_is_given():
    assert all(c.missing == () and c.at_best is None for c in judged().values())


def test_a_runout_that_is_not_given():
    """None at best, that of the grade at worst; each wheel by itself."""
    gears = changed(given(), wheels={"idler": {"runout": None}})
    lacking, best = judged(gears), judged(changed(gears, wheels={"idler": {"runout": 0.0}}))
    for id in ALL:
        assert lacking[id].missing == ("gears.wheels.idler.runout_um",) and lacking[id].value < best[id].value
        at_ends(lacking[id], best[id], lacking[id])
        assert lacking[id].verdict == ("pass" if lacking[id].holds else "not_verified")
    assert lacking["backlash"].taken == ("runout 30.5 µm of grade 7",)
    neither = judged(changed(given(), wheels={"central": {"runout": None}, "idler": {"runout": None}}))["backlash"]
    assert neither.missing == ("gears.wheels.central.runout_um", "gears.wheels.idler.runout_um")


def test_a_tolerance_that_is_not_given():
    """Exact at best; how far it goes nobody knows."""
    gears = changed(given(), tolerance=None, stack=())
    lacking, best = judged(gears), judged(changed(gears, tolerance=0.0))
    for id in ALL[:-1]:  # without parts there is no worst case
        assert lacking[id].missing == ("gears.meshes.0.tolerance_um",)
        at_ends(lacking[id], best[id], "none")
        assert lacking[id].holds and lacking[id].verdict == "not_verified"
    for other in ({"contributors": (30e-6, 40e-6)}, {"stack": PARTS}, {"tolerance": 0.0}):
        assert judged(changed(gears, **other))["backlash"].missing == ()


@pytest.mark.parametrize(("thin", "verdict"), [(-40, "not_verified"), (-200, "pass")])
def test_an_allowance_that_is_not_given(thin, verdict):
    """Thinner teeth would hold at best; the nominal tooth is the worst."""
    ends_of = {"span_allowance": (thin * UM, (thin - 10) * UM)}
    gears = changed(given(), wheels={"central": ends_of, "idler": {"span_allowance": None}}, stack=())
    lacking = judged(gears)
    for id in ALL[:-1]:
        assert lacking[id].missing == ("gears.wheels.idler.span_allowance_um",)
        at_ends(lacking[id], "holds", lacking[id])
    assert lacking["backlash"].verdict == verdict
    both = changed(gears, wheels={"central": {"span_allowance": None}}, tolerance=None)
    assert (judged(both)["backlash"].at_best, judged(both)["backlash"].at_worst) == ("holds", "none")


def test_a_housing_that_is_not_given():
    """The better and the worse of one that grows as the driver and one of aluminium, check by check."""
    gears = given(housing_material=None)
    lacking = judged(gears)
    steel, aluminium = (judged(replace(gears, housing_material=name)) for name in ("steel", "EN AC-43100"))
    at_ends(lacking["backlash_cold"], steel["backlash_cold"], aluminium["backlash_cold"])
    at_ends(lacking["backlash_warm"], aluminium["backlash_warm"], steel["backlash_warm"])
    at_ends(lacking["backlash_warming"], steel["backlash_warming"], aluminium["backlash_warming"])
    assert all(lacking[id].missing == ("gears.housing_material",) for id in TEMPERED)
    assert all(lacking[id].missing == () for id in ALL if id not in TEMPERED)
    spanned = replace(changed(gears, support_share=0.5), support_material="steel")
    assert judged(spanned)["backlash_cold"].missing == ()


def test_wheels_of_which_nobody_says_how_warm_they_are():
    """No warmer than the housing at best, 20 K at worst."""
    gears = given(wheels_warmer=None)
    lacking, best = judged(gears), judged(replace(gears, wheels_warmer=0.0))
    for id in ("backlash_warm", "backlash_warming"):
        assert lacking[id].missing == ("gears.wheels_warmer_K",) and lacking[id].taken == ("wheels 20 K warmer",)
        at_ends(lacking[id], best[id], judged()[id])
    assert lacking["backlash_cold"].missing == ()


def test_all_that_is_missing_goes_to_its_ends_together():
    gears = changed(given(housing_material=None, wheels_warmer=None), wheels={"central": {"runout": None}})
    lacking = judged(gears)
    known = {"wheels_warmer": 0.0, "housing_material": "EN AC-43100"}
    best = judged(replace(changed(gears, wheels={"central": {"runout": 0.0}}), **known))
    worst = judged(replace(gears, wheels_warmer=20.0, housing_material="steel"))
    at_ends(lacking["backlash_warm"], best["backlash_warm"], worst["backlash_warm"])
    assert len(lacking["backlash_warm"].missing) == 3


@pytest.mark.parametrize("share, material, idle", [(None, "steel", True), (0.5, "steel", False), (None, None, False)])
def test_a_support_that_carries_no_mesh_is_said(share, material, idle):
    play = played(replace(changed(given(), support_share=share), support_material=material), "EN-GJL-250")
    assert any("acts on no mesh" in note for note in play.notes) is idle


def test_a_train_has_all_of_them():
    ids = [c.id.rpartition(".")[2] for c in played(given(), "EN-GJL-250").checks]
    assert sorted(ids) == sorted([*ALL, "backlash_guide", "stack"])
