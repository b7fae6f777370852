"""A mistake in a table that comes with the program is told with file, line and key, and what may stand there."""

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from assistant.cli import main
from calc.gears.rating import classes
from calc.library import catalogue, publications, table_file, tolerances
from calc.library.catalogue import CatalogueRows, Material, Oil
from calc.sheet.errors import BadInput, BadTable, Mistakes
from tests.conftest import GAMMA

CACHES = (
    catalogue.shipped_oils,
    table_file.house_table,
    tolerances._lines,
    classes._rows,
    classes._row,
)
Edit = Callable[[str, str, str], tuple[str, int]]


@pytest.fixture
def edited(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Edit]:
    """Changes the first place of a text in a copy of a table; gives the path of the copy and the line."""
    tables = shutil.copytree(table_file.TABLES, tmp_path / "tables")
    monkeypatch.setattr(table_file, "TABLES", tables)
    for cached in CACHES:
        cached.cache_clear()

    def change(file: str, old: str, new: str) -> tuple[str, int]:
        path = tables / file
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new, 1), encoding="utf-8")
        return str(path), text[: text.index(old)].count("\n") + 1

    yield change
    for cached in CACHES:
        cached.cache_clear()


def told(bad: pytest.ExceptionInfo[BadTable]) -> str:
    return str(bad.value)


def test_a_misspelt_key_of_a_row(edited: Edit) -> None:
    path, line = edited("oils.toml", "rho15_kgm3 =", "roh15_kgm3 =")
    with pytest.raises(BadTable) as bad:
        list(CatalogueRows("oils.toml", "row", Oil).values())
    assert f'{path}:{line}: row.0.roh15_kgm3: is not known; did you mean "rho15_kgm3"?' in told(bad)
    assert "row.0.rho15_kgm3: is missing; needs a number from 600 to 1300 kg/m³" in told(bad)


@pytest.mark.parametrize(
    "file, kind, cls, old, new, says",
    [
        ("oils.toml", "row", Oil, 'rho15_kgm3 = { is = ', 'rho15_kgm3 = { si = ', "needs is, confidence, source"),
        ("materials.toml", "row", Material, "E_GPa = 206.0", 'E_GPa = "206"', "must be a number"),
        ("materials.toml", "row", Material, "E_GPa = 206.0", "E_GPa = = 206.0", "is not TOML"),
        ("materials.toml", "row", Material, 'name = "steel"', 'nmae = "steel"', "must begin with its name"),
    ],
)  # fmt: skip
def test_other_mistakes_of_a_row(
    edited: Edit, file: str, kind: str, cls: type[Oil | Material], old: str, new: str, says: str
) -> None:
    path, line = edited(file, old, new)
    with pytest.raises(BadTable) as bad:
        list(CatalogueRows(file, kind, cls).values())
    assert says in told(bad)
    assert any(told(bad).startswith(f"{path}:{at}: ") for at in (line - 1, line))  # of the row, or of the key


def test_a_whole_number_is_in_the_unit_of_its_key_too(edited: Edit) -> None:
    edited("materials.toml", "E_GPa = 206.0", "E_GPa = 206")
    assert CatalogueRows("materials.toml", "row", Material)["steel"].E == 206e9


def test_a_key_that_is_asked_for_and_misspelt(edited: Edit) -> None:
    path, line = edited("clamps.toml", "{ nominal_mm = 13.0", "{ nominall_mm = 13.0")
    with pytest.raises(BadTable) as bad:
        _ = table_file.house_table("clamps.toml")["company"]["clamps"][0]["nominal_mm"]
    assert f"{path}:{line}: " in told(bad) or f"{path}:{line - 1}: " in told(bad)
    assert "company.clamps.0.nominal_mm: is missing; what stands here is nominall_mm, opening_mm" in told(bad)


def test_a_strength_class_and_a_fit(edited: Edit) -> None:
    edited("gear_materials.toml", 'kind = "Eh"', 'kidn = "Eh"')
    with pytest.raises(BadTable, match=r"row\.0\.kind: is missing"):
        classes.strength_class()
    edited("iso_286.toml", "IT7 =", "IT77 =")
    with pytest.raises(BadTable, match=r"tolerance_um\.IT7: is missing"):
        tolerances._row.__wrapped__("tolerance_um", "IT7")


def test_a_publication(edited: Edit) -> None:
    path, line = edited("publications.toml", "edition =", "editoin =")
    with pytest.raises(BadTable) as bad:
        publications.register.__wrapped__()
    assert f'{path}:{line}: publication.0.editoin: is not known; did you mean "edition"?' in told(bad)


def test_the_command_line_says_it(edited: Edit, capsys: pytest.CaptureFixture[str]) -> None:
    path, line = edited("oils.toml", "rho15_kgm3 =", "roh15_kgm3 =")
    assert main(["check", str(GAMMA)]) == 2
    err = capsys.readouterr().err
    assert f"{path}:{line}: row.0.roh15_kgm3: is not known" in err and "fault" not in err


def test_a_search_does_not_take_it_for_a_wrong_input() -> None:
    assert not issubclass(BadTable, BadInput) and issubclass(BadTable, Mistakes)
