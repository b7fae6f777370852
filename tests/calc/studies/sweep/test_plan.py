"""What a sweep computes: grids, lists, hypercubes and tolerances, each design known by its place alone."""

import pickle

import numpy as np
import pytest

from calc.design.toml_file import read
from calc.sheet.errors import BadInput
from calc.studies.sweep import Sweep, grid, listed, sampled, toleranced, varied
from calc.studies.sweep.run import SIZE
from tests.conftest import GAMMA as FILE

GAMMA = read(FILE)


def all_of(plan, size=7):
    return [row for start in range(0, plan.count, size) for row in plan.rows(start, start + size)]


@pytest.mark.parametrize("hypercube", [True, False])
def test_every_design_is_known_by_its_place_alone(hypercube):
    inputs = varied(GAMMA, ["engine.rod_length_mm=150:170", "engine.rated_speed_rpm=1000,2000,2600"], drawn=True)
    plan = sampled(inputs, 50, 3, hypercube=hypercube)
    assert all_of(plan) == all_of(plan, 50) == all_of(sampled(inputs, 50, 3, hypercube=hypercube), 1)
    assert all_of(plan) != all_of(sampled(inputs, 50, 4, hypercube=hypercube))
    assert all_of(grid(varied(GAMMA, ["engine.rod_length_mm=150:170:3", "engine.cylinders=2:3:2"]))) == [
        (150.0, 2),
        (150.0, 3),
        (160.0, 2),
        (160.0, 3),
        (170.0, 2),
        (170.0, 3),
    ]


def test_a_hypercube_has_one_design_in_each_part_of_every_range():
    texts = ["engine.rod_length_mm=150:170", "engine.rated_speed_rpm=1000:3000", "engine.cylinders=2:5"]
    rows = np.array(all_of(sampled(varied(GAMMA, texts, drawn=True), 40, hypercube=True)))
    for column, low, high in ((rows[:, 0], 150, 170), (rows[:, 1], 1000, 3000)):
        assert sorted(((column - low) / (high - low) * 40).astype(int)) == list(range(40))
    assert [list(rows[:, 2]).count(n) for n in (2, 3, 4, 5)] == [10, 10, 10, 10]
    assert abs(np.corrcoef(rows[:, 0], rows[:, 1])[0, 1]) < 0.4


def test_tolerances_scatter_by_three_standard_deviations_to_each_side():
    """As parts of a process do whose tolerance is ±3 σ: the mean, the deviation and the ends of a truncated normal
    distribution."""
    inputs = toleranced(GAMMA, ["engine.bore_mm=0.3", "engine.rod_length_mm=-0.1:0.5"])
    rows = np.array(all_of(sampled(inputs, 20_000, hypercube=False), 20_000))
    bore, rod = rows.T
    assert bore.mean() == pytest.approx(94.0, abs=0.003) and bore.std() == pytest.approx(0.1 * 0.9865, rel=0.02)
    assert rod.mean() == pytest.approx(GAMMA.data["engine"]["rod_length_mm"] + 0.2, abs=0.003)
    assert 93.7 <= bore.min() < 93.75 and 94.25 < bore.max() <= 94.3
    assert abs(np.corrcoef(bore, rod)[0, 1]) < 0.03


def test_a_list_is_a_table_of_designs(tmp_path):
    file = tmp_path / "designs.csv"
    file.write_text("engine.bore_mm, bearings.oil\n90,SAE 30\n,SAE 50\n", encoding="utf-8")
    inputs, rows = listed(GAMMA, str(file))
    assert [one.key for one in inputs] == ["engine.bore_mm", "bearings.oil"] and rows == [
        (90.0, "SAE 30"),
        (None, "SAE 50"),
    ]


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "needs keys"),
        ("engine.bore_mm\n", "needs keys"),
        ("engine.bor_mm\n90\n", "did you mean"),
        ("engine.bore_mm\nwide\n", "2: engine.bore_mm: wide"),
        ("engine.bore_mm\n90,91\n", "has 2 cells; needs 1"),
        ("engine.cylinders\n3.5\n", "whole numbers"),
        ("\x00\xff\n", "is no text in UTF-8"),
    ],
)
def test_what_is_wrong_in_a_list_is_named(tmp_path, text, reason):
    file = tmp_path / "designs.csv"
    file.write_bytes(text.encode("latin-1"))
    with pytest.raises(BadInput, match=reason):
        listed(GAMMA, str(file))


@pytest.mark.parametrize(
    "text",
    [
        "engine.bore_mm",
        "engine.bore_mm=x",
        "engine.bore_mm=1:-1",
        "engine.bore_mm=1:2:3",
        "engine.layout=1",
        "engine.bore_mm=inf",
        "engine.bore_mm=nan",
    ],
)
def test_what_is_no_tolerance_is_named(text):
    with pytest.raises(BadInput, match="--tolerance"):
        toleranced(GAMMA, [text])


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("engine.bore_mm=80:90:inf", "whole NUMBER"),
        ("engine.bore_mm=80:90:nan", "whole NUMBER"),
        ("engine.bore_mm=80:inf:3", "two finite numbers"),
        ("engine.bore_mm=nan:90:3", "two finite numbers"),
        ("engine.bore_mm=-1e308:1e308:3", "two finite numbers"),
        ("engine.cylinders=3,inf", "must be whole numbers here"),
        ("engine.cylinders=nan", "must be whole numbers here"),
    ],
)
def test_what_is_no_grid_is_named(text, reason):
    with pytest.raises(BadInput, match=f"--vary.*{reason}"):
        varied(GAMMA, [text])


def test_no_more_designs_than_a_machine_can_do():
    inputs = varied(GAMMA, ["engine.bore_mm=80:90:2000", "engine.rod_length_mm=150:170:2000"])
    with pytest.raises(BadInput, match="at most 1000000"):
        grid(inputs)
    with pytest.raises(BadInput, match="1 or more"):
        sampled(varied(GAMMA, ["engine.bore_mm=80:90"], drawn=True), 0, hypercube=True)


def test_a_piece_of_a_sweep_is_without_all_other_designs() -> None:
    """It travels to whoever computes it."""
    inputs = varied(GAMMA, ["engine.rated_speed_rpm=1000:3000:1000", "engine.bore_mm=80:99:50"])
    asked = Sweep(GAMMA, grid(inputs))
    piece = asked.piece(7)
    assert piece.plan.rows(0, SIZE) == asked.plan.rows(7 * SIZE, 8 * SIZE) and piece.plan.count == SIZE
    assert len(pickle.dumps(piece)) < len(pickle.dumps(GAMMA)) + 100 * SIZE < len(pickle.dumps(asked))
