"""Rolling bearings that jam, creep or flake: they sit otherwise, or are of the next size; their catalogue stays true."""

from pathlib import Path

from calc.design.toml_file import Document, design, read
from calc.solve import solve
from calc.studies.repair.nearest import nearest

ALONE = """
schema = 2
name = "a ball and a roller bearing"

[[shafts]]
name = "shaft"

[[shafts.bearings]]
name = "front"
kind = "rolling"
size = "{size}"
load_N = 1700.0
slope_mrad = 0.2
{more}

[[shafts.bearings]]             # of which nothing fails
name = "rear"
kind = "rolling"
size = "NJ206"
load_N = 500.0
slope_mrad = 0.2
locates = true
cage = "steel"
outer_ring_held = "insert"
clearance_class = "C5"
seat_fit = "N6"

[bearings]
oil = "10W-40"
supply_temperature_C = 110.0
housing_material = "EN AC-43100"
journal_material = "20CrNi4"
speed_rpm = 2600.0
life_h = {life}
"""
CATALOGUE = ("dynamic_rating_kN", "static_rating_kN", "fatigue_limit_kN")


def written(folder: Path, size: str, life: float, more: str = "") -> Document:
    (folder / "alone.toml").write_text(ALONE.format(size=size, more=more, life=life), encoding="utf-8")
    return read(folder / "alone.toml")


def failing(document: Document) -> set[str]:
    return {c.id.rpartition(".")[2] for c in solve(design(document)).checks() if c.verdict == "fail"}


def test_what_jams_and_creeps_sits_otherwise(tmp_path: Path) -> None:
    document = written(tmp_path, "NU206", 2000.0)
    assert failing(document) >= {"clearance_start", "grip_hot"}
    found = nearest(document)
    keys = {change.partition("=")[0].rpartition(".")[2] for change in found.changes}
    assert found.nothing_fails and not keys & {*CATALOGUE, "size", "life_h"}


def test_the_next_size_leaves_the_catalogue_of_the_former(tmp_path: Path) -> None:
    """Nor does a repair write a better rating into a bearing, or ask a shorter life of it."""
    ratings = "dynamic_rating_kN = 20.3\nstatic_rating_kN = 11.2\nfatigue_limit_kN = 0.475"
    document = written(tmp_path, "6206", 30000.0, ratings)
    assert "life" in failing(document)
    found = nearest(document)
    changes = {key.rpartition(".")[2]: value for key, _, value in (change.partition("=") for change in found.changes)}
    assert found.nothing_fails and changes["size"] != '"6206"' and "life_h" not in changes
    assert [changes[key] for key in CATALOGUE] == ["", "", ""]
