# SPDX-License-Identifier: Apache-2.0
"""Reports of the shipped example, made once."""

from collections.abc import Callable, Iterator
from typing import Any

import pytest

from calc.design.toml_file import Document
from calc.solve import Results
from reports import report as reporting
from reports.apart import Refused
from reports.report import render
from reports.verify import verify as verifying
from tests.reports.reading import EXAMPLE, V12, Solved, solved


@pytest.fixture(scope="session")
def example() -> Solved:
    return solved(EXAMPLE.read_bytes())


@pytest.fixture(scope="session")
def engineer(example: Solved) -> bytes:
    return example.report()


@pytest.fixture(scope="session")
def audit(example: Solved) -> bytes:
    return example.report("audit")


@pytest.fixture(scope="session")
def relazione(example: Solved) -> bytes:
    """The engineer report in Italian."""
    return example.report(lang="it")


@pytest.fixture(scope="session")
def summary(example: Solved) -> bytes:
    return example.report("summary")


@pytest.fixture(scope="module")
def made() -> bytes:
    return solved(V12).report()


@pytest.fixture(scope="module")
def written_once() -> Iterator[None]:
    """The same design at the same depth gives the same report, byte for byte (test_same_bytes): it is written for
    comparison once."""
    known: dict[tuple[object, ...], bytes] = {}

    def again(
        document: Document,
        results: Results,
        raw: bytes,
        *,
        depth: str,
        lang: str,
        logo_file: bytes | None,
        front: bytes | None,
        made: dict[str, str] | None,
    ) -> bytes:
        asked = (raw, depth, lang, front, tuple(sorted((made or {}).items())))
        if asked not in known:
            more = dict(depth=depth, lang=lang, logo_file=logo_file, front=front, made=made)
            known[asked] = render(document, results, raw, **more)  # type: ignore[arg-type]
        return known[asked]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(reporting, "render", again)
        yield


@pytest.fixture
def read_here() -> Iterator[None]:
    """Files are read in this process, for tests of very many."""

    def here(task: Callable[..., Any], raw: bytes, *numbers: int) -> Any:
        try:
            return task(raw, *numbers)
        except Refused:
            raise
        except Exception as error:
            raise Refused(str(error)) from None

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(verifying, "apart", here)
        yield
