# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings where other steps ask of them: how a row becomes one, what passes its seat, what a drawing says."""

from itertools import pairwise

import pytest

from assistant.session.editing import Editing
from calc.countershaft.insertion import rooms
from calc.design.toml_file import Document, design, read
from calc.draw.workshop import shaft_sheet
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.sweep.inputs import varied
from tests.calc.draw.test_sheet import letters
from tests.conftest import DESIGNS

FRONT, REAR = "shafts.shaft.bearings.front", "shafts.shaft.bearings.rear"
PLAIN = read(DESIGNS / "r753ie4_gamma.toml")
BALL = {"kind": "rolling", "size": 6205, "locates": True, "outer_ring_held": "insert"}


def mixed(front=BALL, rear=None):
    """The source's shaft on other bearings; None: as it is."""
    document = PLAIN
    for place, row in ((FRONT, front), (REAR, rear)):
        for key, value in (row or {}).items():
            document = document.with_value(f"{place}.{key}", value)
    return document


def row_of(document, place=0):
    return document.data["shafts"][0]["bearings"][place]


def test_another_kind_leaves_out_what_only_the_former_kind_has():
    there = PLAIN.with_value(f"{FRONT}.seat_fit", "H7").with_value(f"{FRONT}.housing_outer_mm", 120.0)
    row = row_of(there.with_value(f"{FRONT}.kind", "rolling"))
    assert {"diameter_mm", "length_mm", "clearance_factor", "journal_roughness_um"} <= row_of(there).keys()
    assert row.keys() == {"name", "position_mm", "slope_mrad", "kind", "housing_outer_mm"}
    back = there.with_value(f"{FRONT}.kind", "rolling").with_value(f"{FRONT}.size", "NU205")
    assert "size" not in row_of(back.with_value(f"{FRONT}.kind", "plain"))
    assert row_of(there.with_value(f"{FRONT}.kind", "plain")).items() >= row_of(there).items()  # it was that already


def test_limits_of_the_clearance_before_mounting_go_with_their_kind():
    rolling = mixed().with_value(f"{FRONT}.clearance_um", [10.0, 20.0])
    assert design(rolling).rows[0].clearance_limits == pytest.approx((10e-6, 20e-6))
    assert "clearance_um" not in row_of(rolling.with_value(f"{FRONT}.kind", "plain"))


def test_in_the_form_it_is_one_step_of_the_undo():
    editing = Editing(PLAIN.raw, DESIGNS / "r753ie4_gamma.toml")
    before = row_of(editing.document)
    editing.edit(f"{FRONT}.kind", "rolling")
    assert set(editing.reasons()) == {("shafts", 0, "bearings", 0, "size")}
    editing.edit(f"{FRONT}.size", "6205")
    assert editing.valid and not editing.edit(f"{FRONT}.locates", "yes") and editing.text(f"{FRONT}.locates") == "true"
    for _ in range(3):
        editing.undo()
    assert row_of(editing.document) == before and editing.valid


def test_a_size_may_be_a_number_and_a_flag_is_varied():
    assert design(mixed()).rows[0].size == "6205"
    (locates,) = varied(mixed(), [f"{FRONT}.locates=true,false"])
    assert locates.values == (True, False)
    with pytest.raises(BadInput, match="true or false"):
        varied(mixed(), [f"{FRONT}.locates=1:2:3"])


def test_the_row_of_a_twin_is_of_the_kind_of_its_original():
    data = mixed(rear={"kind": "rolling", "size": "NU205"}).data
    told = {"name": "front", "clearance_class": "C4"}
    twin = {"name": "twin", "mirrors": "shaft", "bearings": [told]}
    both = {key: data[key] for key in ("schema", "name", "material", "engine", "imbalance", "bearings")}
    both["shafts"] = [*data["shafts"], twin]
    own = design(Document(both)).resolved[1].inputs
    assert own.bearings[0].clearance_class == "C4" and own.bearings[0].size == "6205"
    told["clearance_um"] = 40.0
    with pytest.raises(BadInput, match='belongs to kind = "plain"'):
        design(Document(both))


def test_what_comes_in_passes_the_opening_of_the_seat():
    plain, rolling = design(PLAIN).own, design(mixed()).own
    assert plain.openings == tuple(d for d, _ in plain.journals)
    assert rolling.openings == pytest.approx((0.052, 0.081)) and rolling.journals[0][0] == pytest.approx(0.025)
    clamped = design(mixed(BALL | {"outer_ring_held": "clamped"})).own
    assert clamped.openings[0] == float("inf") and clamped.seat is None
    # from the front: the sectors, of 40.5 mm, through 52 mm; through a flange nothing has to
    asked = [
        design(mixed(row).with_value("shafts.shaft.assembly", "threaded")).own
        for row in (BALL, BALL | {"outer_ring_held": "clamped"})
    ]
    (front, rear), (free, _) = (rooms(shaft, None, shaft.journals, shaft.outer_radius) for shaft in asked)
    assert front == pytest.approx(0.026 - 0.0405) and rear == pytest.approx(0.0) and free is None


def test_the_wheel_passes_the_seat_and_the_drawing_has_fits_seats_and_what_is_bought():
    cage = {"kind": "rolling", "size": "K30x35x20", "split_cage": True, "case_depth_mm": 0.8}
    results = solve(design(mixed(BALL | {"clearance_class": "C4"}, cage)))
    values = results.values()
    tip = values["gears.shaft.tip_diameter_max"].shown
    assert values["gears.insertion_gap"].shown == pytest.approx(52.0 - tip)  # through the seat without its bearing
    words = [mark.text for mark in letters(shaft_sheet(results))]
    beside = dict(pairwise(words))
    at = words.index("⌀30 h5")
    assert words[at + 1 : at + 3] == ["0", "−0.009"] and "⌀25 js6 ±0.0065" in words and "Ra 0.2" in words
    # cylindricity: half of IT5 under the ring, IT3 under the needles (ISO 286-1: 9 and 4 µm)
    assert "0.0045" in words and "0.004" in words
    assert beside["Seat in the housing, front"] == "⌀52 N7 (−0.009/−0.039)"  # ISO 286-2: N7 of 50 to 80 mm
    assert beside["Raceway in the housing, rear"].startswith("⌀35 G6")
    assert beside["Raceway on the shaft, rear"] == "at least 700 HV, 0.8 mm deep"
    assert beside["6205"] == "C4" and beside["K30x35x20"] == "by the fits"
    assert not any("Diametral clearance" in word for word in words)
