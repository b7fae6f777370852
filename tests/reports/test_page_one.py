# SPDX-License-Identifier: Apache-2.0
"""The page on which somebody decides, read back."""

import pytest

from calc.design.key_results import key_results
from calc.locale import language
from calc.sheet.verdict import open_findings
from calc.studies.load_cases import load_cases
from reports.blocks.inputs import alike
from reports.blocks.page_one import LONGEST, mended
from reports.blocks.values import in_column
from reports.blocks.words import WORDS
from reports.report import context_of
from tests.conftest import DESIGNS
from tests.reports.reading import EXAMPLE, Solved, pages_of, solved, squeezed

TEXT = EXAMPLE.read_text()
ASKED = """[document]
purpose = "To release the counter-shaft for prototypes."
scope = "Shaft and bearings; not the block."

[[requirements]]
name = "Couple left over, first order"
value = "at most 20 N·m"
owner = "Vehicle comfort"

[engine]"""


def first_of(made: Solved, depth: str = "engineer") -> str:
    return squeezed(pages_of(made.report(depth))[0])


def test_it_says_what_fails_what_it_takes_what_loads_and_what_is_not_known(example: Solved, summary: bytes) -> None:
    context = context_of(example.document, example.results, example.raw, depth="engineer", lang="en")
    repair = mended(context)
    assert repair is not None and repair.nothing_fails
    for page in (first_of(example), squeezed(pages_of(summary)[0])):
        assert squeezed("As it stands it does not hold: 8 failed, 7 not verified, 14 cautions.") in page
        assert squeezed("With the changes below none fails; then 5 not verified, 8 cautions.") in page
        assert squeezed(str(repair.changes)) in page
        for worst, *_ in open_findings(list(example.results.checks())):
            if worst.verdict in ("fail", "not_verified"):
                assert squeezed(str(worst.name)) in page
        for title, words in load_cases(example.results):
            assert squeezed(str(title)) in page and squeezed(str(words)) in page
        for words in (
            "runout of the teeth of crank, central",
            "viscosity at high shear (HTHS)",
            "alignment of the bores",
        ):
            assert squeezed(words) in page
        known = [*key_results(example.results.values()).values()]
        assert sum(squeezed(str(value.label)) in page for value in known) > 0.9 * len(known)
        assert "_um" not in page and "_mPas" not in page, "no key of the file in a sentence"


def test_the_loads_are_those_of_the_results(example: Solved) -> None:
    told = {str(title): str(words) for title, words in load_cases(example.results)}
    assert told == {
        "Counter-shaft": "couple 572.9 N·m at 2600 rpm",
        "Bearings": "front 1707 N, rear 1715 N; oil 120 °C in, 122 °C out; cold start at −20 °C",
        "Gears": "driving with 31.17 N at rated speed",
    }


def test_purpose_scope_and_requirements_are_printed_as_they_are_given(example: Solved) -> None:
    made = solved(TEXT.replace("[engine]", ASKED, 1))
    page = first_of(made)
    for words in ("To release the counter-shaft for prototypes.", "Shaft and bearings; not the block."):
        assert squeezed(words) in page and squeezed(words) not in first_of(example)
    assert squeezed("Couple left over, first order at most 20 N·m Vehicle comfort") in page
    long = solved(TEXT.replace("[engine]", ASKED.replace("prototypes.", "prototypes, " * 200), 1))
    page = first_of(long)
    assert "FAIL" in page and "…" in page and len(page) < len(first_of(made)) + LONGEST


def test_where_nothing_fails_it_says_what_warns() -> None:
    made = solved((DESIGNS / "r753ie4_sized.toml").read_bytes())
    page = first_of(made, "summary")
    assert squeezed("Every limit that is judged holds; 2 cautions.") in page and squeezed("What warns") in page
    assert squeezed("Film at the edge, as the journal tilts in the films, front") in page
    assert squeezed("What fails") not in page


def test_each_cause_that_warns_is_told_with_what_it_takes_and_the_step_by_its_closest() -> None:
    made = solved((DESIGNS / "r754ie4_balance_shafts.toml").read_bytes())
    first, second = [squeezed(page) for page in pages_of(made.report("engineer"))[:2]]
    warned = first[first.index(squeezed("What warns")) : first.index(squeezed("Load cases"))]
    turn, numbers = "left: film at the edge over a turn, with the standing load, middle", "4.336 µm ≥ 4.5 µm −4 %"
    assert squeezed(turn) in warned, "it warns under a cause whose worst is not verified"
    assert squeezed(numbers) in warned
    assert squeezed("To pass: Length of middle at least 21.31 mm.") in warned
    assert squeezed(turn + numbers) in second[second.index(squeezed("Steps")) : second.index(squeezed("What is open"))]
    held = [check for check in made.results.checks() if check.kind == "caution" and check.verdict == "pass"]
    assert squeezed(f"{len(held)} cautions hold") in first


def test_no_error_that_is_none_here_is_told_and_twins_have_the_least_margin_that_is_said() -> None:
    made = solved((DESIGNS / "twin_drive.toml").read_bytes())
    read = squeezed(" ".join(pages_of(made.report("engineer"))))
    assert any(outcome.errata for outcome in made.results.outcomes.values())
    assert squeezed(WORDS["errata"]) not in read
    assert squeezed("171.6 to 186.8 µm > 0 µm +172 µm") in read


@pytest.mark.parametrize(
    ("numbers", "written"),
    [
        ([0.344523, 5.173e-3], ["0.34452", "0.00517"]),
        ([68.698, 80.555, 65.81], ["68.70", "80.56", "65.81"]),
        ([2600.0, 1251.0], ["2600", "1251"]),
        ([110.5, 117.2, 111.0], ["110.5", "117.2", "111.0"]),
        ([572.9214, 0.0], ["572.9", "0.0"]),
        ([1e9, 2e9], ["1·10⁹", "2·10⁹"]),
        ([4567.8, 1e-7], ["4567.800", "1·10⁻⁷"]),
        ([None, 12.25], ["", "12.25"]),
    ],
)
def test_numbers_of_one_quantity_have_the_same_decimals(
    example: Solved, numbers: list[float | None], written: list[str]
) -> None:
    context = context_of(example.document, example.results, example.raw, depth="engineer", lang="en")
    assert [text for text in in_column(context, numbers)] == written
    context.say = language("it")
    assert [text.replace(",", ".") for text in in_column(context, numbers)] == written


def test_given_numbers_keep_what_the_file_has_and_no_nought_is_invented() -> None:
    assert alike(["68.698", "65.81", "80.555"]) == ["68.698", "65.810", "80.555"]
    assert alike(["2600.0"]) == ["2600"] and alike(["94.0", "−1.50"]) == ["94.0", "−1.5"]
    assert alike(["1·10⁻⁹", "steel", "2.5"]) == ["1·10⁻⁹", "steel", "2.5"]
