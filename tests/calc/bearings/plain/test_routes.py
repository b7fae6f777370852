"""The routes side by side: what each finds, how far off it is, and why."""

import pytest

from calc.bearings.plain.routes.routes import ROUTES
from tests.calc.bearings.documents import outcome


@pytest.mark.parametrize(
    "changes, place, film, rise, power",
    [
        # 1710 N, clearance as given; film [µm], rise [K], power [W] from an independent solution of Reynolds' equation
        # and of the balance
        ({}, "rear", 12.22, 8.56, 186.2),
        ({"supply": "groove", "groove_width_mm": 0.0}, "rear", 6.71, 3.90, 251.4),
        ({}, "front", 10.38, 6.22, 91.6),
        ({"supply": "groove", "groove_width_mm": 0.0}, "front", 5.81, 3.68, 119.5),
    ],
)
def test_the_own_solution_on_the_clearance_as_given(gamma, changes, place, film, rise, power):
    r = outcome(gamma, front__load_N=1710.0, rear__load_N=1710.0, **changes).result.bearings[place].routes["reynolds"]
    assert r.film * 1e6 == pytest.approx(film, abs=0.006)
    assert r.temperature_rise == pytest.approx(rise, abs=0.006)
    assert r.friction_power == pytest.approx(power, abs=0.06)


def test_all_have_their_row(gamma_results):
    found = gamma_results.outcomes["bearings"]
    table = next(t for t in found.tables if t.id == "routes_front")
    assert [row[0] for row in table.rows] == [route.title for route in ROUTES.values()]
    r = found.result.bearings["front"]
    for name, row in zip(ROUTES, table.rows):
        assert row[1] == pytest.approx(r.routes[name].film * 1e6)


def test_the_spread_is_the_farthest_of_those_that_solve_the_film_at_the_same_oil(gamma_results):
    """Clearance, load and oil are the own solution's: what is left is how each method solves the film."""
    for place in ("front", "rear"):
        r = gamma_results.outcomes["bearings"].result.bearings[place]
        assert set(r.side.compared) == {"raimondi_boyd_own_flow", "iso7902"}
        assert r.routes_spread == pytest.approx(max(abs(far) for far in r.side.compared.values()))
        assert abs(r.side.alike["iso7902"]) < 0.01
        # only their flows differ
        assert r.side.alike["raimondi_boyd"] == pytest.approx(r.side.alike["raimondi_boyd_own_flow"])


def test_the_note_says_who_is_off_and_why(gamma_results):
    found = {c.id: c for c in gamma_results.outcomes["bearings"].checks}
    assert found["bearings.front.routes_spread"].verdict == "pass"
    rear = found["bearings.rear.routes_spread"]
    assert rear.verdict == "note" and "Raimondi & Boyd, own flow is −15 % off: its cubic in d/l" in rear.advice
    assert "ISO" not in rear.advice and "Falz" not in rear.advice
    note = next(t for t in gamma_results.outcomes["bearings"].tables if t.id == "routes_front").note
    assert "Falz, as the thesis uses it: Falz's two branches" in note and "short bearing: it leaves" in note


def test_a_route_whose_flow_is_another_is_told_by_its_flow(gamma):
    """At l/d = ½ the cubic is the chart itself: what is off is the flow of a groove alone, and so the oil's
    temperature."""
    document = gamma.with_value("shafts.shaft.bearings.front.length_mm", 29.75).with_value(
        "bearings.supply_pressure_bar", 0.4
    )
    found = outcome(document)
    note = next(t for t in found.tables if t.id == "routes_front").note
    assert "Raimondi & Boyd, supply flow of the thesis: its flow is" in note and "cubic" not in note
    assert found.result.bearings["front"].routes_spread < 0.02


def test_a_groove_is_unknown_to_the_thesis_methods_only(gamma):
    found = outcome(gamma, supply="groove", groove_width_mm=4.0)
    note = next(t for t in found.tables if t.id == "routes_front").note
    for title in ("supply flow of the thesis", "as the thesis uses it"):
        assert f"{title}: it takes the whole length, where the groove parts the film" in note
    r = found.result.bearings["front"]
    assert (
        r.routes["iso7902"].film == pytest.approx(r.routes["reynolds"].film, rel=0.06)
        and r.routes["iso7902"].side_flow is None
    )
    wrong = next(e for e in found.errata if e.about == "bearings.front.falz.film")
    assert wrong.source_value == pytest.approx(13.2, abs=0.05)


def test_a_route_outside_its_charts_has_no_value_and_a_note(gamma):
    found = outcome(gamma, front__length_mm=12.0)
    assert "raimondi_boyd" not in found.result.bearings["front"].routes
    assert any("Raimondi & Boyd, own flow gives no value here" in note for note in found.notes)


def test_the_short_bearing_counts_where_it_holds(gamma):
    r = outcome(gamma, rear__length_mm=20.0, rear__load_N=200.0).result.bearings["rear"]
    assert r.routes["short_bearing"].eccentricity < 0.5 and "short_bearing" in r.side.compared and r.routes_spread < 0.1
