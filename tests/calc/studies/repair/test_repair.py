"""The parts of the search for a passing design: teeth that are wide or strong enough and no more, masses that leave
nothing, one lever moved."""

import cmath
import math
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from calc.countershaft.inputs import EccentricMass
from calc.design.addresses import quantity_of, value_at
from calc.design.toml_file import Document, design, read
from calc.gears.rating.classes import class_names, strength_class
from calc.sheet.check import THIN_MARGIN, Check
from calc.sheet.search import Budget
from calc.sheet.text import EMPTY
from calc.solve import Results, solve
from calc.studies.repair.levers import (
    Lever,
    called,
    disturbance,
    grid,
    kind_of,
    levers,
    named_keys,
    on_grid,
    settled,
    together,
)
from calc.studies.repair.nearest import nearest
from calc.studies.repair.sizing import _near, _shifted, _single, _wanted
from calc.studies.repair.state import broken, closer_limits, is_mended, state_of
from calc.studies.repair.trials import Trials
from tests.calc.studies.repair.test_remedy import damaged, with_changes
from tests.conftest import DESIGNS
from tests.made_checks import made_check

WEAK = tuple(f'gears.wheels.{name}.gear_material="nitrocarburised"' for name in ("crank", "camshaft"))


# --- teeth
def weak_teeth(document: Document, changes: tuple[str, ...]) -> list[str]:
    """Limits of teeth that do not hold, or only just."""
    limits = (c for c in solve(design(with_changes(document, changes))).checks() if c.kind == "limit")
    return [c.id for c in limits if "safety" in c.id and (not c.holds or c.narrow)]


@pytest.mark.parametrize("power", [60, 80])
def test_no_half_millimetre_more_of_face_width_than_is_needed(power: int) -> None:
    """Both wheels come to one width, the wider one too where it is not wide enough; within 1.5 times it, and beyond
    where no class helps."""
    document = damaged("timing_pair", f"gears.power_kW={power}")
    found = nearest(document)
    keys, widths = zip(*((key, float(b)) for key, b in (change.split("=") for change in found.changes)))
    assert (
        found.nothing_fails
        and set(keys) == {"gears.wheels.crank.face_width_mm", "gears.face_width_mm"}
        and len(set(widths)) == 1
    )
    assert weak_teeth(document, found.changes) == []
    assert weak_teeth(document, tuple(f"{key}={b - 0.5}" for key, b in zip(keys, widths)))


@pytest.mark.parametrize("power", [5, 20])
def test_the_weakest_class_that_is_enough(power: int) -> None:
    """Half as much width again does not help: both wheels take the class and quality of least strength with which the
    pair holds."""
    document = damaged("timing_pair", f"gears.power_kW={power}", *WEAK)
    found = nearest(document)
    made = {key.split(".")[2:][-1]: value for key, value in (change.split("=") for change in found.changes)}
    assert (
        found.nothing_fails
        and {key.split(".")[2] for key in found.changes} == {"crank", "camshaft"}
        and "face_width" not in str(found.changes)
    )

    def both(name: str, quality: str) -> tuple[str, ...]:
        return tuple(
            f'gears.wheels.{w}.{key}="{value}"'
            for w in ("crank", "camshaft")
            for key, value in (("gear_material", name), ("quality", quality))
        )

    now = strength_class("nitrocarburised", "MQ")
    taken = strength_class(made["gear_material"].strip('"'), made.get("quality", "MQ").strip('"'))
    for name in class_names():
        for quality in ("MQ", "ME"):
            one = strength_class(name, quality)
            stronger = one.sigma_Hlim >= now.sigma_Hlim and one.sigma_Flim >= now.sigma_Flim
            if stronger and one.sigma_Hlim + one.sigma_Flim < taken.sigma_Hlim + taken.sigma_Flim:
                assert weak_teeth(document, both(name, quality)), (name, quality)
    assert weak_teeth(document, both(taken.name, taken.quality)) == []


# --- masses
angles = st.floats(-math.pi, math.pi)
masses = st.lists(
    st.tuples(st.floats(0.1, 5), st.floats(0.005, 0.05), angles, st.floats(0.01, 0.1)), min_size=2, max_size=4
)


def row_of(
    said: list[tuple[float, float, float, float]],
) -> tuple[tuple[EccentricMass, ...], list[complex], complex, complex]:
    """Masses one behind the other from −0.1 m on, their unbalances, and U and P of them all."""
    z, made = -0.1, []
    for n, (m, r, angle, gap) in enumerate(said):
        made.append(EccentricMass(name=f"m{n}", mass=m, radius=r, angle=angle, z=z))
        z += gap
    now = [m.mass * m.radius * cmath.exp(1j * m.angle) for m in made]
    return tuple(made), now, sum(now), sum(u * m.z for u, m in zip(now, made))


@given(
    said=masses, U=st.complex_numbers(max_magnitude=0.1), P=st.complex_numbers(min_magnitude=1e-3, max_magnitude=0.02)
)
def test_what_is_wanted_of_the_masses_leaves_nothing(said, U, P):
    """Of the first and the last: force and couple; of all, turned and scaled alike: the couple; never more of the
    others than is said."""
    row, now, _, product = row_of(said)
    # without a couple, as of alike masses about the middle, there is none to turn and scale
    assume(abs(product) > 1e-9)
    ways = list(_wanted(row, now, U, P))
    for way in ways:
        assert sum(u * m.z for u, m in zip(way, row)) == pytest.approx(P, abs=0.1001 * abs(P))
    assert any(
        way[1:-1] == now[1:-1]
        and sum(way) == pytest.approx(U, abs=1e-9)
        and sum(u * m.z for u, m in zip(way, row)) == pytest.approx(P, abs=1e-9)
        for way in ways
    )
    turned = ways[-1]
    assert sum(u * m.z for u, m in zip(turned, row)) == pytest.approx(P, abs=1e-9)
    assert all(u / old == pytest.approx(turned[0] / now[0]) for u, old in zip(turned, now))


def test_what_turns_against_the_shaft_is_not_searched_for_in_its_masses(gamma: Document) -> None:
    """The masses give what they are asked for; what is left is the crank's."""
    (left,) = [
        one
        for one in nearest(with_changes(gamma, ("imbalance.crank_balance_fraction=0.3",)), only="countershaft").left
        if one.id == "countershaft.residual"
    ]
    assert left.why == "what turns against the shaft is more than may be left, and no mass on it takes that"


@given(said=masses, which=st.integers(0, 3), share=st.floats(0.3, 3), turn=angles)
def test_a_single_mass_that_is_wrong_is_found(said, which, share, turn):
    """What all of them gave before one was changed, by that one alone."""
    row, now, U, P = row_of(said)
    n = which % len(row)
    assume(abs(P) > 1e-4)
    wrong = [u * share * cmath.exp(1j * turn) if i == n else u for i, u in enumerate(now)]
    assert any(way == pytest.approx(now, abs=1e-12) for way in _wanted(row, wrong, U, P))


@given(said=masses, which=st.integers(0, 3), away=st.floats(-0.05, 0.05))
def test_a_mass_that_stands_at_a_wrong_place_is_moved_back(said, which, away):
    row, now, U, P = row_of(said)
    n = which % len(row)
    z = row[n].z - away
    moved = P - now[n] * away
    assume(abs(z) > 1e-3)
    found = [way[f"m{n}.z_mm"] for way in _shifted(row, now, U, moved) if f"m{n}.z_mm" in way]
    assert found == [pytest.approx(z * 1e3, abs=0.0501)]  # to a tenth, of which either may be the nearer
    assert not list(_shifted(row, now, U + 0.11 * max(map(abs, now)), moved)), "the force is to be right already"


@given(m=st.floats(0.5, 5), r=st.floats(0.015, 0.05), angle=angles, share=st.floats(0.3, 3), turn=st.floats(0.2, 3))
def test_a_mass_becomes_what_is_wanted_by_its_weight_its_angle_or_both(m, r, angle, share, turn):
    mass = EccentricMass(name="m", mass=m, radius=r, angle=angle, z=0.0)
    wanted = share * m * r * cmath.exp(1j * (angle + turn))

    def made(changes):
        said = {key.rpartition(".")[2]: number for key, number in changes.items()}
        radius, size = said.get("radius_mm", r * 1e3) / 1e3, said.get("mass_kg", m)
        return size * radius * cmath.exp(1j * math.radians(said.get("angle_deg", math.degrees(angle))))

    weight, turned, both, shorter = map(made, _single(mass, wanted))
    # whole grams and tenths of a millimetre, of 150 g and 4.5 mm at the least
    close = pytest.approx(abs(wanted), rel=0.012)
    assert abs(weight) == close and cmath.phase(weight / cmath.exp(1j * angle)) == pytest.approx(0, abs=1e-9)
    assert abs(turned) == pytest.approx(m * r) and abs(cmath.phase(turned / wanted)) < math.radians(0.06)
    for whole in (both, shorter):
        assert abs(whole) == close and abs(cmath.phase(whole / wanted)) < math.radians(0.06)
    assert not any(
        "angle" in key for changes in _single(mass, share * m * r * cmath.exp(1j * angle)) for key in changes
    )


@given(angle=st.floats(-720, 720), old=st.floats(-720, 720))
def test_an_angle_stays_near_its_old_number(angle, old):
    near = _near(angle, old)
    assert abs(near - old) <= 180 + 1e-9 and math.remainder(near - angle, 360) == pytest.approx(0, abs=1e-9)


# --- one lever
def lever(gamma: Document, *keys: str) -> Lever:
    return next(levers(state_of(gamma), list(keys)))


def test_a_number_moves_by_a_share_and_a_whole_one_by_one_at_least(gamma: Document) -> None:
    length = lever(gamma, "shafts.shaft.bearings.front.length_mm")
    assert length.at(length.number(0.02)) == {"shafts.shaft.bearings.front.length_mm": pytest.approx(28.05)}
    assert length.at(length.number(-1.5)) is None, "not allowed"
    teeth = lever(gamma, "gears.wheels.crank.teeth")
    assert [teeth.number(change) - teeth.now for change in (0.02, -0.02, 0.1)] == [1, -1, round(0.1 * teeth.now)]
    places = [f"shafts.shaft.bearings.{name}.position_mm" for name in ("front", "rear")]
    assert lever(gamma, *places).write(-150.75) == dict(zip(places, (-150.75, 150.75)))
    core = "shafts.shaft.core_radius_mm"
    assert list(together([places[0], core, places[1]])) == [places, [core]]


def test_numbers_of_one_kind_in_one_place_move_together(gamma: Document) -> None:
    surfaces = [f"shafts.shaft.bearings.front.{part}_roughness_um" for part in ("journal", "housing")]
    assert len({kind_of(gamma, key) for key in surfaces}) == 1
    assert kind_of(gamma, "bearings.oil") != kind_of(gamma, "friction.oil")
    assert lever(gamma, *surfaces).write(0.4) == dict.fromkeys(surfaces, 0.4)
    allowance = lever(gamma, "gears.wheels.central.span_allowance_um")
    assert allowance.write(allowance.now - 3) == {"gears.wheels.central.span_allowance_um": [-5, -23]}


GAMMA = read(DESIGNS / "r753ie4_gamma.toml")
OFFERED = {  # a field, with the least share of its unit that is written there
    "shafts.shaft.bearings.front.length_mm": 0.5,
    "shafts.shaft.bearings.front.journal_roughness_um": 0.1,
    "shafts.shaft.masses.front.mass_kg": 0.001,
    "gears.meshes.1.centre_distance_mm": 0.1,
    "shafts.shaft.core_radius_mm": 0.5,
}


@given(key=st.sampled_from(sorted(OFFERED)), share=st.floats(-0.9, 3).filter(lambda share: abs(share) > 1e-6))
def test_a_number_is_offered_as_a_workshop_writes_it(key, share):
    """On the grid of its field, and never nearer to the present one than what was found to hold."""
    about, now = quantity_of(GAMMA.data, key), float(value_at(GAMMA.data, key))
    exact = now * (1 + share)
    offered = on_grid(about, now, exact)
    assert grid(about, now) == pytest.approx(OFFERED[key])
    assert round(offered / OFFERED[key]) * OFFERED[key] == pytest.approx(offered)
    assert abs(offered - now) >= abs(exact - now) * (1 - 1e-9) and abs(offered - exact) <= OFFERED[key]
    moved = settled(GAMMA, {key: exact})
    assert moved == {key: offered}


def test_numbers_that_are_whole_stay_so_and_words_are_left_alone(gamma: Document) -> None:
    span, oil = "gears.wheels.central.span_allowance_um", "bearings.oil"
    assert str(settled(gamma, {span: [-5, -23], oil: "5W-30"})) == str({span: [-5, -23], oil: "5W-30"})
    assert settled(gamma, {"shafts.shaft.outer_radius_mm": 40.6123}) == {"shafts.shaft.outer_radius_mm": 41.0}
    assert settled(gamma, {"shafts.shaft.outer_radius_mm": None}) == {"shafts.shaft.outer_radius_mm": None}


@pytest.mark.parametrize("own", [None, [-60.0, 80.0]])
def test_the_axes_of_a_mirrored_pair_move_as_one(own: list[float] | None) -> None:
    pair = read(DESIGNS / "r754ie4_balance_shafts.toml").with_value("shafts.left.axis_mm", [-60.0, -80.0])
    pair = pair.with_value("shafts.right.axis_mm", own)
    state = SimpleNamespace(design=design(pair), document=pair)
    for key in ("shafts.left.axis_mm", "shafts.right.axis_mm"):
        named = named_keys(state, [SimpleNamespace(remedies=(), moved_by=(key,))])
        assert named == ["shafts.left.axis_mm"]
        (axes,) = levers(state, named)
        moved = {"shafts.left.axis_mm": [-66.0, -88.0]} | ({"shafts.right.axis_mm": [-66.0, 88.0]} if own else {})
        assert axes.at(-66.0) == moved


def test_a_number_of_nothing_moves_by_its_step(gamma: Document) -> None:
    key = "gears.wheels.crank.profile_shift"
    nothing = lever(gamma.with_value(key, 0.0), key)
    step = quantity_of(gamma.data, key).step or 0.1
    assert [nothing.at(nothing.number(change)) for change in (0.05, -0.05)] == [
        {key: pytest.approx(0.5 * step)},
        {key: pytest.approx(-0.5 * step)},
    ]


def test_what_a_design_asks_for_is_no_lever(gamma: Document) -> None:
    for key in ("engine.rated_speed_rpm", "gears.power_kW", "bearings.supply_temperature_C"):
        assert not list(levers(state_of(gamma), [key]))


def test_of_several_numbers_the_words_tell_how_far_they_reach(gamma: Document) -> None:
    front, rear = (f"shafts.shaft.bearings.{name}.position_mm" for name in ("front", "rear"))
    assert called(gamma, {front: -165.0, rear: 165.0}, front, -167.5) == "shorter span"
    assert called(gamma, {front: -170.0}, front, -167.5) == called(gamma, {rear: 170.0}, rear, 167.5) == "longer span"
    allowance, oil = "gears.wheels.central.span_allowance_um", "bearings.oil"
    assert called(gamma, {allowance: [-5, -23]}, allowance, [-2, -20]) == "thinner teeth"
    assert called(gamma, {oil: "SAE 50"}, oil, "10W-40") == "another oil"


def test_what_moves_along_a_shaft_is_one_change(gamma: Document) -> None:
    """As one list of places was."""
    ends = {f"shafts.shaft.bearings.{name}": side * 167.5 for name, side in (("front", -1.01), ("rear", 1.01))}
    both = {f"{place}.position_mm": z for place, z in ends.items()}
    assert disturbance(gamma, both) == pytest.approx(0.01)
    assert disturbance(gamma, {f"{place}.length_mm": 27.5 for place in ends}) == pytest.approx(1 / 26.5)


@pytest.mark.parametrize(
    "verdicts, decided",
    [({"a": "pass", "b": "fail"}, True), ({"a": "pass", "b": "pass", "c": "fail"}, True), ({"a": "fail"}, False)],
)
def test_a_trial_ends_where_all_that_is_asked_is_known(verdicts, decided):
    asked = tuple(SimpleNamespace(id=id) for id in "ab")

    def ended(step, checks, outcome):
        return Trials(None, step, checks, Budget(1), None, EMPTY)._decided(outcome)

    checks = [SimpleNamespace(id=id, verdict=verdict) for id, verdict in verdicts.items()]
    outcome = SimpleNamespace(key="gears", checks=checks, state="solved")
    assert ended("gears", asked, outcome) == decided
    assert not ended("friction", asked, outcome)
    assert not ended("gears", (), outcome), "where the step had no solution all of its checks count"
    assert ended("gears", (), SimpleNamespace(key="gears", checks=[], state="no_solution"))
    unsure = SimpleNamespace(key="imbalance", checks=checks, state="solved")
    assert not ended("imbalance", asked, unsure), "its checks change once the shaft is known"
    last = SimpleNamespace(key="mounting", checks=checks, state="solved")
    assert not ended("mounting", asked, last), "all is solved then, and a whole design is wanted next"


def test_a_design_is_tried_once_and_no_more_than_the_budget_allows(gamma: Document, gamma_results: Results) -> None:
    state = state_of(gamma, gamma_results)
    trials = Trials(state, "bearings", state.failing("bearings"), Budget(1), None, EMPTY)
    longer = {"shafts.shaft.bearings.front.length_mm": 40.0}
    after = trials.tried(longer)
    assert after is not None and trials.tried(longer) is after and trials.budget.left == 0
    whole = trials.tried(longer, whole=True)
    assert whole is not None and whole.results.outcomes.keys() == state.results.outcomes.keys()
    assert trials.tried({"shafts.shaft.bearings.front.length_mm": 41.0}) is None


def test_a_design_that_is_tried_whole_has_the_checks_of_every_step() -> None:
    state = state_of(read(DESIGNS / "r753ie4_mounting.toml"))
    trials = Trials(state, "mounting", state.outcome("mounting").checks[:1], Budget(1), None, EMPTY)
    heavier = {"mounting.mass_kg": 300.0}
    assert trials.tried(heavier) is not None
    whole = trials.tried(heavier, whole=True)
    judged = {c.id for c in state.results.checks() if c.kind == "limit"}
    assert whole is not None and judged <= {c.id for c in whole.results.checks()}


def test_what_failed_or_held_by_too_little_is_to_be_no_warning() -> None:
    """A limit that is passed over is looked for beyond the narrow margin, and taken within it where it has to be; one
    that holds narrowly only beyond."""

    def film(value: float) -> Check:
        return made_check(value, unit="µm", id="bearings.front.film")

    def tried(before: Check, after: Check) -> tuple[float, bool]:
        outcome = SimpleNamespace(state="solved", checks=(after,))
        trials = Trials(SimpleNamespace(), "bearings", (before,), Budget(1), None, EMPTY)  # type: ignore[arg-type]
        state: Any = SimpleNamespace(outcome=lambda step: outcome)
        return trials.score(state, (before,)), trials.holds(state, (before,))

    fails, narrow = film(0.9), film(1.02)
    assert not fails.holds and narrow.narrow
    assert tried(fails, film(1.03)) == (pytest.approx(0.03 - THIN_MARGIN), True)
    assert tried(fails, film(1.06)) == (pytest.approx(0.06 - THIN_MARGIN), True)
    assert tried(fails, film(0.99)) == (pytest.approx(-0.01 - THIN_MARGIN), False)
    assert tried(narrow, film(1.03)) == (pytest.approx(0.03 - THIN_MARGIN), False)
    assert tried(narrow, film(1.06)) == (pytest.approx(0.06 - THIN_MARGIN), True)
    caution = made_check(0.9, kind="caution", id="bearings.front.film")
    assert tried(caution, film(1.01)) == (pytest.approx(0.01), True)


ENDS: dict[str, Any] = {"missing": ("a.b",), "at_best": 2.0, "at_worst": 0.5}


def test_a_limit_is_broken_where_it_is_judged_worse_than_before() -> None:
    """It fails, is not verified any more, or does not even hold by what is taken; what is better, or new, is not."""
    kinds = {
        "held": made_check(1.5),
        "narrow": made_check(1.01),
        "unverified": made_check(1.5, **ENDS),
        "open": made_check(0.9, **ENDS),
        "failed": made_check(0.8),
    }

    def state(*checks: Check) -> Any:
        outcome = SimpleNamespace(state="solved", checks=checks)
        return SimpleNamespace(results=SimpleNamespace(outcomes={"bearings": outcome}))

    order = list(kinds)
    for was in order:
        for now in order:
            worse = order.index(now) > max(order.index(was), order.index("narrow"))
            assert broken(state(kinds[was]), state(kinds[now]), ["bearings"]) == ["step.object.name"] * worse, (
                was,
                now,
            )
    new = {name: broken(state(), state(check), ["bearings"]) for name, check in kinds.items()}
    assert [name for name, ids in new.items() if ids] == ["failed"]
    held, warned = (state(made_check(value, kind="caution")) for value in (2.0, 0.5))
    assert broken(held, warned, ["bearings"]) == []


def test_a_limit_that_failed_is_mended_by_what_is_taken() -> None:
    assert is_mended(made_check(1.5)) and is_mended(made_check(1.01)) and is_mended(made_check(1.5, **ENDS))
    assert not is_mended(made_check(0.9)) and not is_mended(made_check(0.9, **ENDS))


def test_a_limit_that_comes_closer_is_named_in_the_same_part_or_where_it_is_narrow_now() -> None:
    def results(*checks: Check) -> Any:
        return SimpleNamespace(checks=lambda: iter(checks))

    def limit(value: float, part: str = "front", **more: Any) -> Check:
        return made_check(value, id=f"bearings.{part}.film", **more)

    def closer(before: Check, after: Check) -> list[str]:
        return [c.id for c in closer_limits(results(before), results(after), "bearings.front")]

    assert closer(limit(0.9), limit(0.8)) == ["bearings.front.film"] and closer(limit(0.8), limit(0.9)) == []
    assert closer(limit(0.9, "rear"), limit(0.8, "rear")) == []
    assert closer(limit(2.0, "rear"), limit(1.01, "rear")) == ["bearings.rear.film"]
    assert closer(limit(2.0), limit(1.2)) == [] and closer(limit(1.03), limit(1.02)) == ["bearings.front.film"]
    assert closer(limit(2.0, kind="caution"), limit(0.5, kind="caution")) == []
