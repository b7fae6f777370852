"""The state of each design: the same words and counts wherever they are said; and of the designs of version 0.1 what
they are by the rules of this one."""

import csv
from pathlib import Path

import pytest
from pypdf import PdfReader

from assistant.cli import main
from calc.design.toml_file import design, parse, read
from calc.sheet.check import SIGNS
from calc.sheet.value import recorded
from calc.solve import Results, solve
from calc.studies.ready import readiness
from calc.studies.shipped import DESIGNS
from reports.blocks.page_one import mended
from reports.blocks.summary import summary_blocks
from reports.report import context_of
from reports.typesetting.pagination import TextContent
from tests.conftest import each_shipped

OLD = Path(__file__).parent / "reference" / "designs_0_1"

STATES = {
    "finotti_gear_sheet": "fail",
    "generating_set_mounting": "pass",
    "r753ie4_alpha": "warn",
    "r753ie4_beta": "fail",
    "r753ie4_drive": "not_verified",
    "r753ie4_gamma": "fail",
    "r753ie4_mounting": "fail",
    "r753ie4_sized": "not_verified",
    "r754ie4_balance_shafts": "not_verified",
    "thesis_oils": "not_verified",
    "thesis_temperatures": "not_verified",
    "thesis_tip_relief": "not_verified",
    "timing_pair": "not_verified",
    "twin_drive": "not_verified",
    "twin_force_shaft": "pass",
    "twin_mounting": "pass",
}
GEARS = "gears.central_idler.backlash"
JAMS = {GEARS, f"{GEARS}_cold", f"{GEARS}_warming"}
FRONT, REAR = ({f"bearings.{place}.film_edge", f"bearings.{place}.film_edge_range"} for place in ("front", "rear"))
GAMMA = FRONT | JAMS | {f"{GEARS}_warm", "gears.idler_shaft.backlash_cold", "gears.idler_shaft.backlash_warming"}
FAILS = {
    "r753ie4_gamma": GAMMA,
    "r753ie4_mounting": GAMMA,  # the same shaft
    "r753ie4_beta": FRONT | REAR | JAMS,
    "finotti_gear_sheet": JAMS,
}
# the words for what is not given, each with the keys that it stands for
WORDS = {
    "runout": {"runout_um"},
    "tolerance": {"tolerance_um"},
    "span": {"span_allowance_um"},
    "housing": {"housing_material", "support_share"},
    "warmer": {"wheels_warmer_K"},
    "irregularity": {"application_factor", "speed_irregularity"},
    "power": {"power_kW"},
    "tensile": {"tensile_strength_MPa"},
    "proof": {"proof_stress_MPa"},
    "slope": {"slope_mrad"},
    "fits": {"journal_fit", "seat_fit"},
    "housing_temperature": {"housing_temperature_C"},
    "hths": {"hths_mPas"},
    "unbalances": {"unbalances"},
    "gas": {"gas"},
    "flywheel": {"flywheel_inertia_kgm2"},
    "inertia": {"inertia_kgm2"},
    "axis": {"axis_mm", "outer_radius_mm", "counterweight_radius_mm"},
    "direction": {"direction_deg"},
}
ROWS = {row["id"]: row["missing"] for row in csv.DictReader((OLD.parent / "severities.csv").open(encoding="utf-8"))}


def solved(name: str) -> Results:
    return solve(design(read(OLD / f"{name}.toml")))


def failing(results: Results) -> set[str]:
    return {check.id for check in results.checks() if check.verdict == "fail"}


def test_all_of_them_are_here() -> None:
    assert {file.stem for file in OLD.glob("*.toml")} == set(STATES)


@pytest.mark.parametrize("name", STATES)
def test_the_state_of_the_designs_of_0_1(name: str) -> None:
    results = solved(name)
    assert results.verdict == STATES[name], [
        c.id for c in results.checks() if c.open and c.kind in ("limit", "caution")
    ]
    assert failing(results) == FAILS.get(name, set())
    for check in results.checks():
        if check.missing and check.kind in ("limit", "caution"):
            known = set[str]().union(*(WORDS[word] for word in ROWS[check.rule.id].split()))
            assert {key.rpartition(".")[2] for key in check.missing} <= known, check.id


def test_what_is_open_of_alpha_and_of_the_balance_shafts() -> None:
    assert solved("r753ie4_alpha").words() == "WARN: 2 cautions"
    shafts = solved("r754ie4_balance_shafts")
    assert shafts.words() == "NOT VERIFIED: 1 not verified, 2 cautions"  # where they stand is not given
    assert (shafts.verdict, shafts.colour) == ("not_verified", "not_verified")


WHEELS = ["crank", "central", "idler", "shaft"]


@pytest.mark.parametrize("given, state", [(WHEELS, "pass"), (WHEELS[2:3], "not_verified")])
def test_the_runout_of_ground_wheels_frees_the_twin(given: list[str], state: str) -> None:
    text = (OLD / "twin_drive.toml").read_text(encoding="utf-8")
    for wheel in given:
        text = text.replace(f'name = "{wheel}"\n', f'name = "{wheel}"\nrunout_um = {16 if len(given) > 1 else 0}\n')
    assert text.count("runout_um") == len(given)
    assert solve(design(parse(text.encode(), "twin_drive.toml"))).verdict == state


LONG = ("r753ie4_beta", "r753ie4_gamma", "r753ie4_drive", "r753ie4_mounting", "r753ie4_sized")


@pytest.mark.parametrize("file", each_shipped(*LONG))
def test_the_session_and_page_one_say_the_state_of_the_program(file: Path) -> None:
    """Of every design the words from which the session's step list and the first page are drawn; what plain text, JSON
    and a replay say `tests/test_findings.py` compares."""
    document = read(file)
    results = solve(design(document))
    words = {state.key: str(state.words) for state in readiness(document.data, results)}
    for key, outcome in results.outcomes.items():
        if outcome.state == "solved":
            checks = outcome.checks
            failed = [c for c in checks if c.kind == "limit" and c.finding == "fail"]
            assert words[key].startswith("FAIL") is bool(failed)
            assert not failed or f"{len(failed)} failed" in words[key]
            open_cautions = [c for c in checks if c.kind == "caution" and c.verdict in ("warn", "not_verified")]
            assert (f"{len(open_cautions)} caution" in words[key]) is bool(open_cautions)
    context = context_of(document, results, document.raw, depth="summary", lang="en")
    page = [
        block.content.words
        for block in summary_blocks(context, mended(context))
        if isinstance(block.content, TextContent)
    ]
    state, _, open_ones = str(results.words()).partition(": ")
    head = f"{SIGNS[results.verdict]} {state}. "
    assert any(text.startswith(head) and open_ones in text for text in page), page


@pytest.mark.parametrize(
    "name",
    [
        "finotti_gear_sheet",
        *(pytest.param(n, marks=pytest.mark.slow) for n in ("r753ie4_sized", "r754ie4_balance_shafts")),
    ],
)
def test_the_report_says_the_state_of_the_program(name: str, tmp_path: Path) -> None:
    results, pdf = solve(design(read(DESIGNS / f"{name}.toml"))), tmp_path / "report.pdf"
    assert main(["report", str(DESIGNS / f"{name}.toml"), "-o", str(pdf), "--depth", "summary"]) == 0
    page = " ".join(PdfReader(pdf).pages[0].extract_text().split())
    state, _, open_ones = str(results.words()).partition(": ")
    assert state in page and open_ones in page


@pytest.mark.parametrize("path", each_shipped())
def test_verdicts_need_neither_lines_nor_other_methods(path):
    """What the session shows ahead of the results."""
    whole = solve(design(read(path)))
    with recorded(False):
        brief = solve(whole.design, compared=False)
    assert brief.words() == whole.words()
    judged = {check.id: (check.verdict, check.value) for check in whole.checks() if "routes_spread" not in check.id}
    assert str({check.id: (check.verdict, check.value) for check in brief.checks()}) == str(judged)  # nan is nan
