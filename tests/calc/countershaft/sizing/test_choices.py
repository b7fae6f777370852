"""Other materials beside the design's, and the shafts that the choose command ranks."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.countershaft.making.inputs import Alternative, Cost, ShaftSupport
from calc.countershaft.sizing import formulas as f
from calc.countershaft.sizing.choices import (
    Envelope,
    Seat,
    asked,
    candidates,
    changes,
    choices,
    choices_table,
    compared,
    compared_table,
    envelope,
    front_curve,
    key,
)
from calc.countershaft.sizing.sectors import TooSmall, pair, size
from calc.design.toml_file import design
from calc.engine import solve as engine
from calc.imbalance import solve as imbalance
from calc.library.catalogue import Material
from calc.sheet.errors import BadInput, NoSolution
from calc.sheet.remedy import assignments
from calc.sheet.text import Text
from tests.calc.countershaft.shafts import bearing_rows

STEEL, ADI = 7860.0, 7200.0
OMEGA = 2 * math.pi * 2600 / 60


def material(name, density):
    return Material(name=name, E=206e9, density=density, expansion=11.5e-6)


MATERIALS = {"steel": material("steel", STEEL), "ADI": material("ADI", ADI), "lead": material("lead", 11340.0)}
FINOTTI = Cost(
    pieces_per_year=2000,
    alternatives=(
        Alternative(material="steel", tooling=80e3, piece=65.0),
        Alternative(material="ADI", tooling=60e3, piece=55.0),
    ),
)


@pytest.fixture
def case(gamma):
    """Inputs of the shaft, the imbalance and the crank's speed of the source's final design; materials as here."""
    made = design(gamma)
    e = engine.values(made.engine)
    support = ShaftSupport(material="EN AC-43100", wall=5.5e-3)
    shaft = replace(
        made.countershaft,
        material="steel",
        cost=FINOTTI,
        support=support,
        outer_radius=None,
        core_radius=0.015,
        half_length=None,
        radial_clearance=None,
        extras=(),
        overdesign=0.0,
    )
    return shaft, imbalance.values(made.imbalance, made.engine, e), e.angular_speed


# --- other materials
def test_radius_for_another_density():
    """Ø81 in the source's steel (7900) to ADI (7200 kg/m³) at one length: 83.54 mm without, 83.42 mm with the core of
    radius 15; the source's 83.5, with 'about 7200'."""
    bare = f.radius_for(R=0.0405, r_0=0.0, rho=7900.0, rho_m=ADI)
    cored = f.radius_for(R=0.0405, r_0=0.015, rho=7900.0, rho_m=ADI)
    assert 2e3 * bare == pytest.approx(83.54, abs=5e-3)
    assert 2e3 * cored == pytest.approx(83.42, abs=5e-3)


def test_cost_of_the_source(case):
    """Finotti 2013, 4.1: 2000 a year: 210 against 170 k€, so that ADI stays cheaper while its development costs below
    40 k€."""
    found = compared(case[0], MATERIALS, 0.0405, 0.015, 5.379)
    assert list(found) == ["steel", "ADI"]
    assert (found["steel"].first_year_cost, found["ADI"].first_year_cost) == (210e3, 170e3)
    assert found["ADI"].bearable_development == 40e3
    assert found["ADI"].break_even is None  # cheaper in tooling and by the piece: at any volume
    assert found["steel"].bearable_development is None


def test_the_development_an_alternative_bears_does_not_depend_on_its_own(case):
    shaft = replace(
        case[0],
        cost=replace(
            FINOTTI, alternatives=(FINOTTI.alternatives[0], replace(FINOTTI.alternatives[1], development=55e3))
        ),
    )
    found = compared(shaft, MATERIALS, 0.0405, 0.015, 5.379)["ADI"]
    assert found.first_year_cost == 225e3 and found.bearable_development == 40e3
    assert found.break_even == pytest.approx(3500)  # 35 k€ more before the first piece, 10 € less a piece
    costs = [f.first_year(K_T=t, K_D=d, N=found.break_even, c=c) for t, d, c in ((80e3, 0.0, 65.0), (60e3, 55e3, 55.0))]
    assert costs[0] == pytest.approx(costs[1])


def test_another_material_keeps_the_couple(case):
    """Same length and half-angle at the other radius and density: the same couple, and the mass and wall that are
    said."""
    one = pair(560.0, OMEGA, STEEL, 0.0405, 0.015, 0.154)
    found = compared(case[0], MATERIALS, 0.0405, 0.015, 2 * one.mass)["ADI"]
    other = pair(560.0, OMEGA, ADI, found.outer_radius, 0.015, 0.154)
    assert other.half_angle == pytest.approx(one.half_angle) and other.length == pytest.approx(one.length)
    assert 2 * other.mass == pytest.approx(found.eccentric_mass)
    assert found.bore_growth == pytest.approx(2 * (found.outer_radius - 0.0405))
    assert found.wall_left == pytest.approx(5.5e-3 - found.bore_growth / 2)
    assert found.wall_left < case[0].support.least_wall  # why the source rejected it


def test_the_whole_shaft_in_another_material(case):
    """9.03 kg of steel, 5.379 of it sectors: in iron 5.254 and 3.348 kg and a ring of 0.056 kg around the journal."""
    seat = Seat(0.081, 0.0265, 1713.6)
    found = compared(case[0], MATERIALS, 0.0405, 0.015, 5.379, 9.03351, seat)
    ring = ADI * math.pi / 4 * (0.083284**2 - 0.081**2) * 0.0265
    assert found["ADI"].journal * 1e3 == pytest.approx(83.284, abs=5e-4)
    assert found["ADI"].shaft_mass == pytest.approx(
        found["ADI"].eccentric_mass + (9.03351 - 5.379) * ADI / STEEL + ring, abs=1e-4
    )
    assert found["ADI"].mass_difference == pytest.approx(found["ADI"].shaft_mass - 9.03351)
    assert found["ADI"].specific_load * 0.083284 * 0.0265 == pytest.approx(1713.6, rel=1e-5)
    assert (found["steel"].journal, found["steel"].shaft_mass, found["steel"].mass_difference) == (
        0.081,
        pytest.approx(9.03351),
        pytest.approx(0),
    )


def test_what_is_not_known_is_left_out(case):
    shaft = replace(case[0], cost=None, support=None)
    (only,) = compared(shaft, MATERIALS, None, None, 5.0).values()
    assert only.density == STEEL and only.outer_radius is only.first_year_cost is only.wall_left is None
    assert [label for label, _ in compared_table(shaft, {"steel": only}, Text("couple")).columns] == [
        "material",
        "density",
    ]
    partly = replace(case[0], cost=replace(FINOTTI, alternatives=FINOTTI.alternatives[1:]))
    found = compared(partly, MATERIALS, 0.0405, 0.015, 5.0)
    assert (
        found["steel"].first_year_cost is None
        and found["ADI"].first_year_cost == 170e3
        and found["ADI"].bearable_development is None
    )


def test_the_table_of_materials_is_in_its_units(case):
    table = compared_table(case[0], compared(case[0], MATERIALS, 0.0405, 0.015, 5.379), Text("couple"))
    rows = {row[0]: dict(zip((label for label, _ in table.columns), row)) for row in table.rows}
    assert rows["steel"]["outer radius"] == pytest.approx(40.5) and rows["steel"]["first year"] == 210
    assert rows["ADI"]["development it bears"] == 40 and rows["steel"]["development it bears"] is None
    assert "wall left" in rows["ADI"] and "5 mm" in table.note


def test_names_of_materials_as_names_of_values():
    assert key("ADI 800") == "ADI-800" and key("EN AC-43100") == "EN-AC-43100"


# --- mass over radius
@pytest.mark.parametrize("force", [0j, 2e-3 + 1e-3j])
def test_front(force):
    """From the smallest radius that serves to that of the envelope; every point is the least mass of its radius, and it
    falls."""
    P = 572.932 / OMEGA**2 + 0j
    curve = front_curve(force, P, OMEGA, 0.043, 0.015, 0.152, {"ADI": ADI, "steel": STEEL})
    assert [s.label for s in curve.series] == ["ADI", "steel"]
    for line, density in zip(curve.series, (ADI, STEEL)):
        assert line.x[-1] == pytest.approx(43) and np.all(np.diff(line.x) > 0) and np.all(np.diff(line.y) < 0)
        for i in (1, len(line.x) // 2, -1):
            assert size(force, P, OMEGA, density, line.x[i] * 1e-3, 0.015, 0.152).mass == pytest.approx(
                line.y[i], rel=1e-7
            )
        with pytest.raises(TooSmall):
            size(force, P, OMEGA, density, line.x[0] * 1e-3 * (1 - 1e-6), 0.015, 0.152)
    assert front_curve(force, P, OMEGA, 0.039, 0.015, 0.152, {"ADI": ADI, "steel": STEEL}) is None
    (only,) = front_curve(force, P, OMEGA, 0.0412, 0.015, 0.152, {"ADI": ADI, "steel": STEEL}).series
    assert only.label == "steel"


# --- the envelope
def bare(shaft):
    """Without the sizes of its journals."""
    return replace(shaft, bearings=bearing_rows(shaft.bearing_positions))


def test_the_envelope_is_derived_from_the_journals(case):
    shaft = replace(case[0], fillet_radius=None)
    room = envelope(shaft, "here")
    assert room.outer_radius == pytest.approx(40.3e-3)  # half of 81, less 0.2 mm
    assert room.half_length == pytest.approx(0.1675 - 0.02750 / 2)  # the front journal's inner face is the nearer one
    assert len(room.derived) == 2
    given = envelope(replace(bare(shaft), outer_radius=0.043, half_length=0.15, radial_clearance=1e-3), "here")
    assert (given.outer_radius, given.half_length, given.derived) == (0.043, 0.15, ())
    assert envelope(replace(shaft, radial_clearance=1e-3), "here").outer_radius == pytest.approx(39.5e-3)
    own = replace(shaft, bearings=bearing_rows(shaft.bearing_positions, ((0.06, 0.03), (0.09, 0.04))))
    assert envelope(own, "here").outer_radius == pytest.approx(44.8e-3)
    assert envelope(own, "here").half_length == pytest.approx(0.1475)
    filleted = envelope(replace(own, fillet_radius=0.002), "here")
    assert filleted.half_length == pytest.approx(0.1435) and "two fillets of 2 mm" in filleted.derived[1]


def test_what_the_envelope_lacks_is_named(case):
    shaft = case[0]
    with pytest.raises(BadInput, match=r"core_radius_mm: needed") as caught:
        envelope(replace(shaft, core_radius=None), "here.toml")
    assert len(caught.value.errors) == 1 and "here.toml" in str(caught.value)
    with pytest.raises(BadInput) as caught:
        envelope(replace(bare(shaft), core_radius=None), "here.toml")
    assert {e.key for e in caught.value.errors} == {
        f"shafts.shaft.{n}_mm" for n in ("outer_radius", "half_length", "core_radius")
    }
    with pytest.raises(BadInput, match="smaller than the outer radius"):
        envelope(replace(shaft, core_radius=0.0405), "here")
    with pytest.raises(BadInput, match="at mid-shaft"):
        envelope(replace(shaft, bearings=bearing_rows((0.0, 0.15), ((0.06, 0.03),) * 2)), "here")
    middle = replace(shaft, fillet_radius=1e-3, bearings=bearing_rows((-0.15, 0.01, 0.15), ((0.06, 0.03),) * 3))
    between = envelope(middle, "here")  # the inner one leaves a gap: its journal, and two fillets on either side
    assert between.half_length == pytest.approx(0.133) and between.gaps == ((0.01, pytest.approx(0.034)),)


def test_an_unknown_material_of_the_cost_is_named(case):
    shaft = replace(
        case[0],
        cost=replace(
            FINOTTI, alternatives=(*FINOTTI.alternatives, Alternative(material="mud", tooling=1.0, piece=1.0))
        ),
    )
    with pytest.raises(BadInput, match="mud"):
        candidates(shaft, MATERIALS, "here")


# --- the ranking
ROOM = Envelope(0.043, 0.015, 0.152, (), "shaft")


def test_the_lightest_stands_first_and_each_is_the_least_of_its_radius(case):
    shaft, balance, omega = case
    found = choices(shaft, balance, omega, ROOM, candidates(shaft, MATERIALS, "here"))
    U, P, omega_S = asked(shaft, balance, omega)
    assert abs(U) < 1e-12 and abs(P) * omega_S**2 == pytest.approx(572.932, abs=5e-4)
    masses = [c.sized.mass for c in found.shafts]
    assert masses == sorted(masses) and found.refused == {}
    first = found.shafts[0]
    assert (first.material, first.sized.outer_radius) == ("steel", 0.043)
    assert first.sized.front.mass == pytest.approx(1.591, abs=5e-4)  # as worked out apart from this program
    assert {c.material for c in found.shafts} == {"steel", "ADI"}
    for name, cost in (("steel", 210e3), ("ADI", 170e3)):
        own = [c for c in found.shafts if c.material == name]
        radii = [c.sized.outer_radius for c in own]
        # lighter only by a larger radius
        assert radii == sorted(radii, reverse=True) and len(set(radii)) == len(radii) > 5
        assert {c.first_year_cost for c in own} == {cost}
        smallest = MATERIALS[name].density
        with pytest.raises(TooSmall):
            size(U, P, omega_S, smallest, min(radii) - 1e-4, 0.015, 0.152)


def test_more_couple_is_asked_for_where_drilling_takes_some_away(case):
    shaft, balance, omega = case
    plain, more = asked(shaft, balance, omega)[1], asked(replace(shaft, overdesign=0.015), balance, omega)[1]
    assert more == pytest.approx(1.015 * plain)


def test_a_material_that_does_not_fit_is_said(case):
    shaft, balance, omega = case
    room = Envelope(0.041, 0.015, 0.152, (), "shaft")
    found = choices(shaft, balance, omega, room, candidates(shaft, MATERIALS, "here"))
    assert set(found.refused) == {"ADI"} and {c.material for c in found.shafts} == {"steel"}
    assert "ADI does not fit: it takes an outer radius of" in choices_table(found, 5, room).note


def test_where_nothing_fits_the_reason_is_that_of_the_densest(case):
    shaft, balance, omega = case
    with pytest.raises(NoSolution) as caught:
        choices(
            shaft, balance, omega, Envelope(0.0402, 0.015, 0.152, (), "shaft"), candidates(shaft, MATERIALS, "here")
        )
    assert caught.value.possible_couple == pytest.approx(552.8, abs=0.05)


def test_the_table_and_the_keys_of_a_row(case):
    shaft, balance, omega = case
    found = choices(shaft, balance, omega, ROOM, candidates(shaft, MATERIALS, "here"))
    table = choices_table(found, 3, ROOM)
    assert len(table.rows) == 3 and [row[0] for row in table.rows] == ["1", "2", "3"]
    cells = dict(zip((label for label, _ in table.columns), table.rows[0]))
    assert cells["outer radius"] == pytest.approx(43) and cells["half-angle of each"] == pytest.approx(68.25, abs=5e-3)
    assert cells["length of each"] == pytest.approx(104.62, abs=5e-3) and cells["first year"] == 210
    assert assignments(changes(found.shafts[0], ROOM)) == [
        'shafts.shaft.mode="size"',
        'shafts.shaft.material="steel"',
        "shafts.shaft.outer_radius_mm=43.0",
        "shafts.shaft.core_radius_mm=15.0",
        "shafts.shaft.half_length_mm=152.0",
    ]


def test_unequal_sectors_stand_beside_each_other(case):
    shaft, balance, omega = case
    from calc.countershaft.inputs import Extra

    uneven = replace(shaft, extras=(Extra(name="hole", mass=-0.05, radius=0.02, angle=0.0, z=0.1),))
    table = choices_table(choices(uneven, balance, omega, ROOM, candidates(uneven, MATERIALS, "here")), 3, ROOM)
    assert {"mass front", "mass rear"} <= {label for label, _ in table.columns}
