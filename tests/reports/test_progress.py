# SPDX-License-Identifier: Apache-2.0
"""How a report says how far it is, and is stopped."""

from pathlib import Path

import pytest

from calc.design.toml_file import load
from calc.sheet.errors import Cancelled
from calc.solve import Results, solve
from reports.report import write
from tests.conftest import DESIGNS

PAIR = DESIGNS / "timing_pair.toml"


@pytest.fixture(scope="module")
def solved() -> Results:
    return solve(load(PAIR)[1])


def test_it_goes_from_nothing_to_one_by_sections_and_pages(solved: Results, tmp_path: Path) -> None:
    told: list[tuple[float, str]] = []
    path = tmp_path / "a.pdf"

    def progress(share: float, what: str) -> None:
        assert path.exists() == (share == 1.0)  # whole when it says so, and not before
        told.append((share, what))

    document = load(PAIR)[0]
    write(document, solved, document.raw, path, progress=progress)
    shares = [share for share, _ in told]
    assert shares == sorted(shares) and shares[0] == 0.0 and shares[-1] == 1.0 and shares.count(1.0) == 1
    said = [what for _, what in told]
    assert "Gears: Proofs" in said and "Friction: Inputs" in said
    pages = [what for what in said if what.startswith("Page ")]
    assert len(pages) == len(set(pages)) == int(pages[0].rpartition(" ")[2]) > 5
    write(document, solved, document.raw, tmp_path / "b.pdf")
    assert path.read_bytes() == (tmp_path / "b.pdf").read_bytes()


@pytest.mark.parametrize("until", [0.0, 0.3, 0.7])
def test_who_listens_can_stop_it_and_nothing_is_left(solved: Results, tmp_path: Path, until: float) -> None:
    def progress(share: float, what: str) -> None:
        if share >= until:
            raise Cancelled

    document = load(PAIR)[0]
    (tmp_path / "a.pdf").write_bytes(b"the report of before")
    with pytest.raises(Cancelled):
        write(document, solved, document.raw, tmp_path / "a.pdf", progress=progress)
    assert [p.name for p in tmp_path.iterdir()] == ["a.pdf"] and (
        tmp_path / "a.pdf"
    ).read_bytes() == b"the report of before"
