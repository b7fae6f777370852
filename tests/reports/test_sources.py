# SPDX-License-Identifier: Apache-2.0
"""The register of sources: standards apart from literature, each with its edition, its status and how we know it; rules
for themselves."""

import pytest

from calc.library.publications import register
from reports.blocks.contents import STANDARD, _together
from tests.reports.reading import squeezed, text_of


def chapter(pdf: bytes) -> str:
    """The sources as text."""
    read = text_of(pdf)
    return read[read.rindex("Standards and rules") : read.rindex("Nomenclature")]


@pytest.mark.parametrize("depth", ["engineer", pytest.param("audit", marks=pytest.mark.slow)])
def test_every_publication_has_its_row(depth: str, request: pytest.FixtureRequest) -> None:
    read = squeezed(chapter(request.getfixturevalue(depth)))
    for name in ("ISO 6336-2:2006", "VDI 2230-1", "Finotti 2013", "Raimondi & Boyd 1958"):
        one = register()[name]
        assert squeezed(name) in read and squeezed(one.title) in read and squeezed(str(one.edition)) in read, name
    assert read.index(squeezed("ISO 898-1")) < read.index("Booksandpapers") < read.index("Johnson1970")
    assert "asfarasweremember" in read and "readinthesource" in read


def test_definitions_stand_apart_in_the_audit_only(engineer: bytes, audit: bytes) -> None:
    assert "Definitions and rules without a publication" not in text_of(engineer)
    own = chapter(audit).partition("Definitions and rules without a publication")[2]
    assert (
        "kinematics: " in own
        and "mathematics: " in own
        and "ISO 6336-2" not in own.partition("rule of this program")[0]
    )


def test_standards_are_told_from_other_publications() -> None:
    assert {name for name in register() if STANDARD.match(name)} >= {
        "ISO 6336-1",
        "AGMA 925-A03",
        "IACS UR M56",
        "VDI 2230-1",
    }
    assert not any(STANDARD.match(name) for name in ("Finotti 2013", "Isoda 1990", "Shigley"))


def test_clauses_that_begin_alike_stand_on_one_line() -> None:
    clauses = dict.fromkeys(["4.1: couple", "4.1: force", "5.2", "6: mass"])
    assert _together(clauses) == ["4.1: couple · force", "5.2", "6: mass"]
