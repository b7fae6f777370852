# SPDX-License-Identifier: Apache-2.0
"""What can not be of a seat: told in words, by its key and line, all at once."""

import copy
from dataclasses import replace

import pytest

from assistant.cli import main
from calc.countershaft.rows import BearingRow
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput
from tests.conftest import DESIGNS

SHELL = {
    "name": "front",
    "position_mm": -60,
    "diameter_mm": 28.0,
    "length_mm": 18,
    "seat": "shells",
    "load_N": 2473,
    "journal_roughness_um": 0.2,
    "housing_roughness_um": 0.4,
}
BUSH = {
    "name": "rear",
    "position_mm": 60,
    "diameter_mm": 29.96,
    "length_mm": 20,
    "seat": "bush",
    "wall_mm": [1.500, 1.508],
    "bore_mm": [33.025, 33.05],
    "journal_mm": [29.95, 29.975],
    "load_N": 3300,
    "journal_roughness_um": 0.2,
    "housing_roughness_um": 0.4,
}
CLASSES = {
    "journal_classes_mm": [[27.987, 27.993], [27.994, 28.0]],
    "bore_classes_mm": [[31.0, 31.008], [31.009, 31.016]],
    "clearance_band_um": [23, 50],
}
TABLE = {
    "oil": "10W-40 Q8 T905",
    "supply_temperature_C": 100,
    "supply_pressure_bar": 3,
    "supply": "hole",
    "hole_diameter_mm": 3,
    "housing_material": "EN AC-43100",
    "journal_material": "42CrMo4",
    "bush_material": "AlSn20Cu",
    "speed_rpm": 8500,
}
DIRECT = {"seat": "direct", "clearance_um": 40}  # the front bearing in the housing itself


def document(*, front=None, rear=None, shaft=None, select=None, **shared):
    """Shells by classes in front, a bush by its limits behind; None takes a key out."""

    def with_(table, changes):
        return {key: value for key, value in {**table, **(changes or {})}.items() if value is not None}

    rows = [with_(SHELL, front), with_(BUSH, rear)]
    if select is not False:
        shared["select"] = with_(CLASSES, select)
    shafts = [with_({"name": "shaft", "mode": "bearings", "assembly": "split", "bearings": rows}, shaft)]
    data = {"schema": 2, "name": "seats", "shafts": shafts, "bearings": with_(TABLE, shared)}
    return Document(copy.deepcopy(data), "seats.toml")


def told(made):
    """By the key as a reader says it."""
    with pytest.raises(BadInput) as bad:
        design(made)
    return {error.called or error.key: str(error.reason) for error in bad.value.errors}


def test_it_is_well_as_it_stands():
    design(document())


CLEARANCE, MADE = "the bore make the clearance", "the classes of [bearings.select] make the clearance"
CASES = [
    # what is changed, the key that is told of, what it is told
    ({"rear": {"clearance_um": 77}}, "rear.clearance_um", CLEARANCE),
    ({"rear": {"clearance_factor": 0.5}}, "rear.clearance_factor", CLEARANCE),
    ({"rear": {"journal_fit": "f7"}}, "rear.journal_fit", CLEARANCE),
    ({"rear": {"seat_fit": "IT7"}}, "rear.seat_fit", CLEARANCE),
    ({"front": {"clearance_um": 40}}, "front.clearance_um", MADE),
    ({"front": {"clearance_factor": 0.5}}, "front.clearance_factor", MADE),
    ({"front": {"journal_fit": "f7"}}, "front.journal_fit", MADE),
    ({"front": {"seat_fit": "H7"}}, "front.seat_fit", MADE),
    ({"front": {"wall_mm": 1.5}}, "front.wall_mm", "the walls are those of [bearings.select]"),
    ({"front": {"diameter_mm": 30}}, "front.diameter_mm", "not the size of the journal classes"),
    ({"front": {"journal_mm": [27.99, 28.0]}}, "front.journal_mm", "the classes of [bearings.select] must lie within"),
    ({"front": {"bore_mm": [31.0, 31.01]}}, "front.bore_mm", "the classes of [bearings.select] must lie within"),
    ({"front": {"housing_outer_mm": 33}}, "front.housing_outer_mm", "above 33.016 mm"),
    ({"rear": {"bore_mm": None}}, "rear.journal_mm", "needs bore_mm beside it"),
    ({"rear": {"journal_mm": None}}, "rear.clearance_um", "give clearance_um or clearance_factor, or journal_mm"),
    ({"rear": {"wall_mm": None}}, "rear.wall_mm", 'needed with seat = "bush"'),
    ({"front": {"clearance_um": 35}, "select": False}, "front.wall_mm", 'needed with seat = "shells"'),
    ({"rear": {"wall_mm": [1.508, 1.5]}}, "rear.wall_mm", "least before most"),
    ({"rear": {"wall_mm": 0.4}}, "rear.wall_mm", "0.5 to 10"),
    ({"rear": {"bore_mm": [33.05, 33.025]}}, "rear.bore_mm", "least before most"),
    ({"rear": {"bore_mm": [30.0, 30.01]}}, "rear.bore_mm", "leaves no clearance"),
    ({"rear": {"bore_mm": [32.9, 32.92]}}, "rear.bore_mm", "leaves no clearance"),
    ({"rear": {"bore_mm": [34.0, 34.01]}}, "rear.bore_mm", "diameter_mm and two walls, 32.976 mm"),
    ({"rear": {"journal_mm": [29.975, 29.95]}}, "rear.journal_mm", "least before most"),
    ({"rear": {"journal_mm": [28.0, 28.01]}}, "rear.journal_mm", "not the size of diameter_mm, 29.96 mm"),
    ({"rear": {"interference_um": [40, 30]}}, "rear.interference_um", "least before most"),
    ({"rear": {"interference_um": [-5, 30]}}, "rear.interference_um", "0 to 1000"),
    ({"rear": {"interference_um": 30}}, "rear.interference_um", "2"),
    ({"rear": {"bore": "finished"}}, "rear.finished_mm", 'needed with bore = "finished"'),
    ({"rear": {"finished_mm": [30.0, 30.02]}}, "rear.finished_mm", 'belongs to bore = "finished"'),
    (
        {"rear": {"bore": "finished", "finished_mm": [29.9, 29.92]}},
        "rear.finished_mm",
        "must be larger than journal_mm",
    ),
    (
        {"rear": {"bore": "finished", "finished_mm": [30.0, 30.02], "journal_mm": None, "clearance_um": 50}},
        "rear.finished_mm",
        "needs journal_mm beside it",
    ),
    ({"front": {"finished_mm": [28.03, 28.04]}}, "front.finished_mm", 'seat = "bush"'),
    ({"front": {"bore": "finished", "finished_mm": [28.03, 28.04]}}, "front.finished_mm", 'seat = "bush"'),
    ({"front": {"crush_um": [30, 45], "interference_um": [30, 40]}}, "front.crush_um", "one of the two"),
    ({"rear": {"crush_um": [30, 45]}}, "rear.crush_um", 'belongs to seat = "shells"'),
    ({"rear": {"crush_load_N": 3000}}, "rear.crush_load_N", 'belongs to seat = "shells"'),
    ({"rear": {"spread_um": 300}}, "rear.spread_um", 'belongs to seat = "shells"'),
    ({"rear": {"relief_um": 8}}, "rear.relief_um", 'belongs to seat = "shells"'),
    ({"rear": {"relief_length_mm": 2}}, "rear.relief_length_mm", 'belongs to seat = "shells"'),
    ({"rear": {"housing_outer_mm": 35}}, "rear.housing_outer_mm", "above 35.05 mm"),
    ({"rear": {"backing": "cheese"}}, "rear.backing", '"cheese" is not known'),
    ({"rear": {"retained": "glue"}}, "rear.retained", "pin"),
    ({"rear": {"seat": "floating"}}, "rear.seat", "shells"),
    ({"front": {**DIRECT, "wall_mm": 1.5}}, "front.wall_mm", 'belongs to seat = "bush" or seat = "shells"'),
    ({"front": {**DIRECT, "backing": "steel"}}, "front.backing", 'belongs to seat = "bush"'),
    ({"front": {**DIRECT, "retained": "pin"}}, "front.retained", 'belongs to seat = "bush"'),
    ({"front": {**DIRECT, "interference_um": [1, 2]}}, "front.interference_um", 'belongs to seat = "bush"'),
    ({"front": {**DIRECT, "housing_outer_mm": 60}}, "front.housing_outer_mm", 'belongs to seat = "bush"'),
    ({"front": {**DIRECT, "bore_mm": [28.03, 28.04]}}, "front.bore_mm", "needs journal_mm beside it"),
    (
        {"front": {"seat": "direct", "journal_mm": [27.98, 28.0], "bore_mm": [27.95, 27.97]}},
        "front.bore_mm",
        "must be larger than journal_mm",
    ),
    (
        {"front": {"seat": "direct", "journal_mm": [27.98, 28.0], "bore_mm": [31.0, 31.02]}},
        "front.bore_mm",
        "not the size of diameter_mm, 28 mm",
    ),
    ({"shaft": {"assembly": "threaded"}}, "front.seat", 'assembly = "split", "caps" or "module"'),
    ({"rear": {"carrier_bore_mm": 42}}, "rear.carrier_bore_mm", 'belongs to assembly = "cartridge"'),
    ({"rear": {"carrier_mm": 41.98}}, "rear.carrier_mm", "needs carrier_bore_mm beside it"),
    (
        {"front": DIRECT, "rear": {"carrier_bore_mm": 29}, "shaft": {"assembly": "cartridge"}},
        "rear.carrier_bore_mm",
        "must be larger than 33.05 mm",
    ),
    (
        {"front": DIRECT, "rear": {"carrier_bore_mm": 42, "carrier_mm": 10}, "shaft": {"assembly": "cartridge"}},
        "rear.carrier_mm",
        "must be larger than 33.05 mm",
    ),
    (
        {"front": DIRECT, "rear": {"carrier_bore_mm": [42.1, 42]}, "shaft": {"assembly": "cartridge"}},
        "rear.carrier_bore_mm",
        "least before most",
    ),
    (
        {"front": DIRECT, "rear": {"carrier_bore_mm": 42, "carrier_mm": [42, 41]}, "shaft": {"assembly": "cartridge"}},
        "rear.carrier_mm",
        "least before most",
    ),
    ({"front": DIRECT, "shaft": {"assembly": "cartridge"}}, "front.carrier_bore_mm", "needed with assembly"),
    ({"front": {"crush_um": [45, 30]}}, "front.crush_um", "least before most"),
    (
        {"rear": {"bore": "finished", "finished_mm": [30.02, 30.0]}},
        "rear.finished_mm",
        "least before most",
    ),
    ({"select": {"pick": [[0, 1], [1, 2]]}}, "bearings.select.pick", "needs walls_mm"),
    ({"select": {"clearance_band_um": None}}, "bearings.select.clearance_band_um", "is missing"),
    ({"select": {"journal_classes_mm": None}}, "bearings.select.journal_classes_mm", "is missing"),
    ({"shaft": {"radial_clearance_mm": 0.5}}, "shafts.shaft.radial_clearance_mm", "leave it out"),
    ({"housing_temperature_C": 300}, "bearings.housing_temperature_C", "-40 to 200"),
]


@pytest.mark.parametrize(("changes", "key", "words"), CASES, ids=[f"{key}-{n}" for n, (_, key, _) in enumerate(CASES)])
def test_what_can_not_be_is_told_by_its_key(changes, key, words):
    errors = told(document(**changes))
    key = f"shafts.shaft.bearings.{key}" if key.startswith(("front", "rear")) else key
    assert words in errors[key].replace("−", "-"), errors
    alone = "bore" not in changes.get("front", ())  # two keys that say nothing of shells
    assert len(errors) == (1 if alone else 2), "nothing else follows from it"


@pytest.mark.parametrize(
    "changes",
    [
        {"front": {"journal_mm": [27.98, 28.01]}},
        {"front": {"journal_mm": [27.987, 28.0], "bore_mm": [31.0, 31.016]}},
        {"front": {"crush_um": [30, 45], "crush_load_N": 3000, "spread_um": 300, "relief_um": 10}},
        {"rear": {"bore": "finished", "finished_mm": [30.0, 30.02], "bore_mm": None}},
        {"rear": {"bore": "finished", "finished_mm": [30.0, 30.02]}},
        {"rear": {"journal_mm": None, "bore_mm": None, "clearance_um": 77}},
        {"rear": {"journal_mm": None, "clearance_um": 77}},
        {"rear": {"journal_mm": None, "bore_mm": None, "journal_fit": "f7", "seat_fit": "H7"}},
        {"rear": {"wall_mm": 1.504, "retained": "pin", "backing": "CuSn10P", "housing_outer_mm": 60}},
        {"front": DIRECT, "shaft": {"assembly": "threaded"}},
        {"front": DIRECT, "rear": {"carrier_bore_mm": [42.0, 42.016]}, "shaft": {"assembly": "cartridge"}},
        {"shaft": {"assembly": None}},
        {"front": {"wall_mm": 1.49, "clearance_um": 35}, "select": False},
    ],
)
def test_what_can_be(changes):
    design(document(**changes))


@pytest.mark.parametrize(
    ("own", "assembly", "key", "words"),
    [
        ({"seat": "bush"}, "split", "wall_mm", 'needed with seat = "bush"'),
        ({"seat": "shells", "wall_mm": 1.5}, "threaded", "seat", "half shells go in with a divided housing"),
        ({"wall_mm": 1.5}, "split", "wall_mm", 'belongs to seat = "bush"'),
        ({"seat": "bush", "wall_mm": 2.0, "bore_mm": [33.0, 33.01]}, "split", "bore_mm", "and two walls, 28 mm"),
        ({"seat": "bush", "wall_mm": 2.0}, "threaded", None, None),
        ({"seat": "shells", "wall_mm": 1.5}, "split", None, None),
    ],
)
def test_the_seat_of_a_twin_is_its_own(own, assembly, key, words):
    """In place of the one of its original, as far as its row says; what is wrong is told there."""
    pair = read(DESIGNS / "r754ie4_balance_shafts.toml")
    left, right = pair.data["shafts"]
    twin = {**right, "bearings": [{"name": "front", **own}]}
    made = replace(pair, data={**pair.data, "shafts": [{**left, "assembly": assembly}, twin]})
    if key is None:
        design(made)
    else:
        ((where, why),) = told(made).items()
        assert where == f"shafts.right.bearings.front.{key}" and words in why


def test_the_clearance_of_a_twin_is_its_own():
    """A number in place of limits, limits in place of a number, one limit in place of one."""
    limits = {"clearance": None, "journal": (0.02995, 0.02997), "bore": (0.033025, 0.03305), "wall": (0.0015,)}
    sized = dict(name="front", diameter=0.02996, length=0.02)
    number = BearingRow(**sized, seat="bush", clearance=77e-6, wall=(0.0015,))
    limited = BearingRow(**sized, seat="bush", **limits)

    def of_twin(original, **own):
        made = original.with_own(BearingRow(name="front", **own))
        return made.clearance, made.journal, made.bore

    assert of_twin(number, bore=(0.033, 0.03301)) == (77e-6, None, (0.033, 0.03301))
    assert of_twin(number, journal=(1, 2), bore=(3, 4)) == (None, (1, 2), (3, 4))
    assert of_twin(limited, clearance=50e-6) == (50e-6, None, None)
    assert of_twin(limited, journal=(0.02994, 0.02995)) == (None, (0.02994, 0.02995), limits["bore"])
    assert of_twin(limited, retained="pin") == (None, limits["journal"], limits["bore"])


def test_the_command_tells_all_at_once_with_line_and_key(tmp_path, capsys):
    path = tmp_path / "seats.toml"
    rows = [
        {**SHELL, "crush_um": [30, 45], "interference_um": [30, 40], "clearance_um": 40},
        {**BUSH, "wall_mm": [1.508, 1.5], "spread_um": 300},
    ]
    tables = [
        "schema = 2",
        'name = "seats"',
        "[[shafts]]",
        'name = "shaft"',
        'mode = "bearings"',
        'assembly = "threaded"',
    ]
    for row in rows:
        tables += ["[[shafts.bearings]]", *(f"{key} = {_toml(value)}" for key, value in row.items())]
    tables += ["[bearings]", *(f"{key} = {_toml(value)}" for key, value in TABLE.items()), "[bearings.select]"]
    classes = {**CLASSES, "pick": [[0, 1]], "walls_mm": [[1.484, 1.488], [1.488, 1.492]]}
    tables += [f"{key} = {value}" for key, value in classes.items()]
    path.write_text("\n".join(tables), encoding="utf-8")
    assert main(["check", str(path)]) == 2
    said = capsys.readouterr()
    said = said.out + said.err
    lines = {key: n for n, text in enumerate(tables, 1) if (key := text.partition(" = ")[0])}
    front = tables.index("[[shafts.bearings]]")
    for key in ("seat", "crush_um", "clearance_um"):
        line = next(n for n, text in enumerate(tables, 1) if n > front and text.startswith(f"{key} = "))
        assert f"seats.toml:{line}: shafts.shaft.bearings.front.{key}" in said
    for key in ("wall_mm", "spread_um"):
        assert f"seats.toml:{lines[key]}: shafts.shaft.bearings.rear.{key}" in said
    assert f"seats.toml:{lines['pick']}: bearings.select.pick" in said


def _toml(value):
    return f'"{value}"' if isinstance(value, str) else str(value)
