# SPDX-License-Identifier: Apache-2.0
"""The drive over speed on the first page of a report, read back from it."""

from calc.studies.headlines import drive_row
from tests.calc.gears.drive.over_speed import known_drive, with_flywheel
from tests.reports.reading import Solved, pages_of, squeezed


def test_the_first_page_names_the_load_that_governs_the_teeth() -> None:
    document, results = with_flywheel(), known_drive()
    page = squeezed(pages_of(Solved(document.raw, document, results).report("summary"))[0])
    for words in (
        "Safety against pitting under strikes, high to low force, idler–shaft",
        "0.94 to 1.08",
        "Safety against tooth breakage under strikes, high to low force",
        "1.10 to 1.49",
        "Drive at idle / largest force",
        "grade B; strikes of 58 / 92 mm/s",
        "force some 1.8 to 3.0 kN / 3.0 to 4.9 kN",
    ):
        assert squeezed(words) in page, words
    assert squeezed("Safety against pitting, on stress") not in page  # that of the torque is larger


def test_a_default_governs_nothing(summary: bytes, example: Solved) -> None:
    page = squeezed(pages_of(summary)[0])
    assert squeezed("Safety against pitting, on stress") in page and squeezed("under strikes, high") not in page
    row = drive_row(example.results)
    assert row is not None and squeezed(row[1][-30:]) in page
