# SPDX-License-Identifier: Apache-2.0
"""The report read back: what must stand in it, and where."""

import io
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from pypdf import PdfReader

from calc.library.publications import cited, register
from calc.locale import language
from calc.sheet.check import URGENT, Check
from calc.sheet.expression import plain
from calc.sheet.formula import formula
from calc.sheet.remedy import sentence
from calc.sheet.step import Outcome
from calc.sheet.text import Amount, Text
from calc.sheet.units import Newton
from calc.sheet.value import Line
from calc.sheet.verdict import grouped
from calc.sheet.version import VERSION
from calc.solve import Results
from calc.studies.explain import Chains
from reports.blocks.words import WORDS
from reports.context import Context, near
from reports.report import write
from reports.typesetting.equation import EquationEntry, Label, _others, shown, spoken_numbers
from reports.typesetting.equation import spoken as spoken_formula
from reports.typesetting.fonts import BOTTOM, HEIGHT, LEFT, PAGE, RIGHT, TOP
from reports.typesetting.pagination import paginate
from reports.typesetting.prose import NOTE
from tests.conftest import each_shipped
from tests.languages.texts import judge_english
from tests.made_checks import made_check
from tests.reports.reading import V12, Solved, pages_of, solved, spans, spoken, squeezed, text_of, with_outcome


def test_every_check_stands_in_the_audit_with_its_verdict(example: Solved, audit: bytes) -> None:
    read = squeezed(text_of(audit))
    for check in example.results.checks():
        assert squeezed(check.name) in read
        assert squeezed(check.limit_text()) in read
        assert squeezed(check.source) in read
    for outcome in example.results.outcomes.values():
        assert squeezed(WORDS[outcome.verdict]) in read


def test_the_summary_proposes_remedies_where_there_is_room() -> None:
    made = solved(V12)

    def summary(count: int, depth: str = "summary") -> str:
        proposals = tuple(f"Remedy number {n}, because something of order {n} is left over." for n in range(count))
        checks = (made_check(11.0, "<=", 10.0, unit="mm", id="engine.fail.x", advice=Text("Do something.")),)
        told = with_outcome(made, "imbalance", proposals=proposals, checks=checks)
        pages = pages_of(told.report(depth))
        assert depth != "summary" or len(pages) == 1
        return pages[0]

    page = summary(3)
    assert page.index("What fails, and what it takes") < page.index("Proposed remedies") < page.index("Remedy number 0")
    assert "Remedy number 2" in page and "more, in the engineer report" not in page
    page = summary(100)
    shown = page.count("Remedy number")
    assert 10 < shown < 100 and f"and {100 - shown} more, in the engineer report" in page
    assert "Proposed remedies" not in summary(0)
    assert "Proposed remedies" not in summary(3, "engineer"), "there they stand with their step"


def test_every_state_and_verdict_has_its_sign_and_word() -> None:
    example = solved(V12)

    def check(verdict: str, value: float, kind: str = "limit", **more: Any) -> Check:
        name = Text(f"a check that should {verdict}")
        return made_check(value, "<=", 10.0, kind, "mm", id=f"engine.{verdict}.x", name=name, **more)

    checks = (
        check("pass", 1.0),
        check("warn", 9.9),
        check("fail", float("nan")),
        check("note", 11.0, "advice"),
        check("unknown", 1.0, missing=("gears.power_kW",), at_best="none", at_worst="none"),
        check("open", 11.0, "caution", accepted="seen on the bench"),
    )
    outcomes = dict(example.results.outcomes)
    outcomes["engine"] = replace(outcomes["engine"], checks=checks)
    outcomes["gears"] = Outcome("gears", "no_solution", reason="no centre distance; tried 60 to 90 mm")
    outcomes["friction"] = Outcome("friction", "blocked", reason="waits for Gears")
    outcomes["bearings"] = Outcome("bearings", "not_asked")
    read = text_of(Solved(example.raw, example.document, Results(example.results.design, outcomes)).report())
    for words in (
        "✓ pass",
        "▲ warn",
        "✗ fail",
        "✗ no solution",
        "○ blocked",
        "· not used",
        "no value",
        "no number",
        "• note",
        "? not verified",
        "✓ accepted",
        "Not given: power of the first driver.",
        "Accepted: seen on the bench",
    ):
        assert words in read
    assert "no centre distance; tried 60 to 90 mm" in read and "waits for Gears" in read


def test_failures_come_first_with_their_advice(example: Solved, engineer: bytes) -> None:
    read = squeezed(" ".join(pages_of(engineer)[1:4]))
    rules, read = read.split(squeezed("What is open: "))
    read, assumed = read.split(squeezed("Assumptions, and what they put at risk"))
    assert "A1" in assumed and squeezed("all hold at its worst too") in assumed
    places = []
    for group in grouped(example.results.checks()):
        urgent = [check for check in group if check.verdict in URGENT]
        for worst in urgent[:1]:
            assert squeezed(worst.advice) in read and all(squeezed(check.name) in read for check in urgent[:4])
            places.append((read.rindex(squeezed(worst.name)), worst.verdict))
    assert len(places) > 5
    verdicts = [v for _, v in sorted(places)]
    assert verdicts == sorted(verdicts), "fail before warn"
    assert squeezed("kept by less than 5 % they warn") in rules, "it says by which rules it judges"


def test_the_source_is_corrected_beside_its_value(example: Solved, engineer: bytes, audit: bytes) -> None:
    read, whole = squeezed(text_of(engineer)), squeezed(text_of(audit))
    errata = [e for o in example.results.outcomes.values() for e in o.errata]
    assert errata
    for erratum in errata:
        assert squeezed(erratum.label) in read and squeezed(erratum.why.partition(". ")[0]) in read
        assert squeezed(erratum.why) in whole and squeezed(erratum.source) in whole


def test_every_formula_stands_in_the_audit_and_can_be_copied(example: Solved, audit: bytes) -> None:
    whole, said = squeezed(text_of(audit)), spoken(audit)
    for outcome in example.results.outcomes.values():
        for line in outcome.lines:
            read_out = shown(line, language("en"), EquationEntry(line.formula, []))
            assert spoken_formula(read_out) in said and spoken_numbers(read_out) in said
    for source in {line.formula.source for outcome in example.results.outcomes.values() for line in outcome.lines}:
        assert squeezed(cited(source) or source) in whole


def test_a_chapter_says_once_how_a_long_list_is_written(engineer: bytes) -> None:
    assert len(re.findall(r"\(\S+ … \S+: 17\)", spoken(engineer))) > 1, "the fields of the parts between two centres"
    assert squeezed(text_of(engineer)).count(squeezed(WORDS["ranges"])) == 1


LONG = ("r753ie4_beta", "r753ie4_gamma", "r753ie4_drive", "r753ie4_mounting", "r753ie4_sized", "thesis_temperatures")


@pytest.mark.parametrize("path", each_shipped(*LONG, "l61"))
def test_what_fails_or_comes_near_its_limit_is_proven(path: Path) -> None:
    """Each such check of each shipped design has its block: its own number, limit, source, the formula behind it, and a
    remedy."""
    made = solved(path.read_bytes())
    pdf = made.report()
    read, said, chains = squeezed(text_of(pdf)), spoken(pdf), Chains(made.results)
    for check in filter(near, made.results.checks()):
        own = check.name.removeprefix(f"{check.id.split('.')[1]}: ")  # of several shafts the section has the name
        name, found = squeezed(own), squeezed(f"{Amount(check.value, check.unit)} · {check.limit_text()}")
        assert re.search(rf"(?i){re.escape(name)}\D*{re.escape(found)}", read), check.id
        assert squeezed(check.source) in read, check.id
        for line in chains.judged(check):
            if isinstance(line, Line):
                assert spoken_formula(shown(line, language("en"), EquationEntry(line.formula, []))) in said, check.id
                assert spoken_numbers(shown(line, language("en"), EquationEntry(line.formula, []))) in said, check.id
        if check.advice and not check.holds:
            parts = check.advice.rpartition(sentence(check.remedies) or check.advice)  # what several advise stands once
            assert all(squeezed(part) in read for part in parts), check.id


def test_a_value_outside_its_formula_is_not_called_a_pass(example: Solved, engineer: bytes) -> None:
    """The load of these teeth is below what the load factors of ISO 6336 are made for."""
    words = next(words for words in pages_of(engineer) if "Safety against pitting crank–central" in words)
    assert (
        "kept, outside" in words
        and "✓ pass" not in words[words.index("Safety against pitting") :].partition("Also judged")[0]
    )
    said = spoken(engineer)
    for symbol in ("S_H", "σ_H", "K_V", "K_Hβ", "S_F", "K_Fβ", "σ_red"):
        assert f"{plain(symbol)} = " in said, symbol


def test_inputs_that_are_not_usual_stand_in_the_verdict(summary: bytes, engineer: bytes, audit: bytes) -> None:
    for pdf in (summary, engineer, audit):
        assert "1 input is not usual: span allowance of central −2 µm (usual −80 to −20)" in " ".join(
            pages_of(pdf)[0].split()
        )


def test_what_the_design_file_calls_assumed_is_said(engineer: bytes, audit: bytes) -> None:
    assumed = "Half-length “assumed: up to the front journal”"
    mesh = "Share of the support, idler–shaft “assumed: half of the distance is spanned by the support of the shaft”"
    short, whole = (squeezed(text_of(pdf)) for pdf in (engineer, audit))
    for said in (assumed, mesh):
        assert squeezed(said) in short and squeezed(said) in whole
    source = squeezed("Outlet temperature limit “engine manual”")
    assert source in whole and source not in short, "where a number is from stands in the audit"


def test_every_input_and_value_stands_in_the_audit(example: Solved, audit: bytes) -> None:
    read = squeezed(text_of(audit))
    for value in example.results.values().values():
        assert squeezed(value.label) in read
    for key in ("engine.bore_mm", "engine.rated_speed_rpm", "imbalance.kinematics"):
        assert squeezed(key) in read
    assert "118.6" in read and "18.676" in read, "numbers as the file gives them"


def test_depths(example: Solved, summary: bytes, engineer: bytes, relazione: bytes, audit: bytes) -> None:
    count = [len(PdfReader(io.BytesIO(pdf)).pages) for pdf in (summary, engineer, audit)]
    assert count[0] == 1 < count[1] <= 36 < count[2] and len(engineer) < 700_000
    assert len(PdfReader(io.BytesIO(relazione)).pages) <= 38  # Italian is longer
    with pytest.raises(ValueError, match="depth"):
        example.report("deep")


def test_write_leaves_one_file(example: Solved, tmp_path: Path) -> None:
    path = tmp_path / "report é.pdf"
    assert write(example.document, example.results, example.raw, path, depth="summary") == path
    assert [p.name for p in tmp_path.iterdir()] == [path.name] and path.read_bytes().startswith(b"%PDF-1.7")
    with pytest.raises(ValueError, match="lang"):
        write(example.document, example.results, example.raw, path, lang="tlh")


def test_the_design_file_comes_out_as_it_went_in(example: Solved, engineer: bytes) -> None:
    reader = PdfReader(io.BytesIO(engineer))
    assert reader.attachments["design.toml"] == [example.raw]
    assert reader.trailer["/Root"]["/AF"][0].get_object()["/AFRelationship"] == "/Source"
    raw = example.raw.replace(b"\n", b"\r\n") + "# ✗ ♞\n".encode()
    reader = PdfReader(io.BytesIO(solved(raw).report("summary")))
    assert reader.attachments["design.toml"] == [raw]


def test_what_the_document_says_of_itself(example: Solved, engineer: bytes) -> None:
    about = PdfReader(io.BytesIO(engineer)).metadata
    assert (
        about is not None
        and example.document.sha256 in about["/Subject"]
        and example.document.sha256 in about["/Keywords"]
    )
    assert about["/Creator"] == f"Contralbero {VERSION}" and about["/Title"] == example.document.data["name"]
    assert "/CreationDate" not in about


def test_outline_and_contents_lead_to_their_pages(example: Solved, engineer: bytes) -> None:
    reader = PdfReader(io.BytesIO(engineer))
    pages = pages_of(engineer)
    top = [entry for entry in reader.outline if not isinstance(entry, list)]
    contents = next(n for n, words in enumerate(pages) if "Contents" in words)
    for entry in top[1:]:
        number = reader.get_destination_page_number(entry)
        assert squeezed(str(entry.title)) in squeezed(pages[number])
        assert squeezed(f"{entry.title}") in squeezed(pages[contents])
    links = [a.get_object()["/Dest"] for a in reader.pages[contents].get("/Annots", [])]
    assert len(links) >= len(top) - 1
    assert all(f"Page {n} of {len(pages)}" in words for n, words in enumerate(pages, 1))


def test_another_reader_finds_the_same_text(engineer: bytes) -> None:
    """What the tests read by themselves is what pypdf copies out of the pages; of each fifth one, since it is slow."""
    for page, words in list(zip(PdfReader(io.BytesIO(engineer)).pages, pages_of(engineer)))[::5]:
        assert squeezed(page.extract_text()) == squeezed(words) != ""


@pytest.mark.parametrize("depth", ["summary", "engineer", "relazione", "audit"])
def test_nothing_leaves_the_margins(depth: str, request: pytest.FixtureRequest) -> None:
    pdf = request.getfixturevalue(depth)
    sheets = {
        n for n, page in enumerate(PdfReader(io.BytesIO(pdf)).pages) if page.mediabox.width > page.mediabox.height
    }
    for span in (span for span in spans(pdf) if span.page not in sheets):
        assert LEFT - 1 <= span.x and 24 < span.y < PAGE[1] - 24, span
        if span.upright:
            assert span.end <= PAGE[0] - RIGHT + 1, span
        if not span.upright or span.size > NOTE.size:
            assert BOTTOM - 14 < span.y < PAGE[1] - TOP + 2, span


@pytest.mark.parametrize("depth", ["summary", "engineer", "relazione", "audit"])
def test_nothing_overlaps(depth: str, request: pytest.FixtureRequest) -> None:
    """The middle of the letters of one piece of text never lies in those of another."""
    by_page: dict[int, list[tuple[float, float, float, float]]] = {}
    for s in spans(request.getfixturevalue(depth)):
        if s.upright and not s.hidden and s.end - s.x > 0.3 * s.size:
            by_page.setdefault(s.page, []).append(
                (s.x + 0.1 * s.size, s.y + 0.12 * s.size, s.end - 0.1 * s.size, s.y + 0.48 * s.size)
            )
    for page, boxes in by_page.items():
        boxes.sort()
        for i, (x, y, end, top) in enumerate(boxes):
            for x2, y2, end2, top2 in boxes[i + 1 :]:
                if x2 >= end:
                    break
                assert y2 >= top or top2 <= y or end2 <= x2, (
                    f"page {page + 1}: {(x, y, end, top)} and {(x2, y2, end2, top2)}"
                )


@cache
def titles_by_threes() -> set[tuple[str, ...]]:
    titles = [f"{row.title} ({row.edition})".split() for row in register().values()]
    return {tuple(word.strip(".,") for word in title[n : n + 3]) for title in titles for n in range(len(title) - 2)}


def without_titles(line: str) -> str:
    """A line without what it holds of the title of a publication: three words of one that follow each other."""
    words, threes = line.split(), titles_by_threes()
    held = {
        n + k
        for n in range(len(words) - 2)
        for k in range(3)
        if tuple(word.strip(".,") for word in words[n : n + 3]) in threes
    }
    return " ".join(word for n, word in enumerate(words) if n not in held)


def test_the_italian_report_says_the_same_in_italian(example: Solved, engineer: bytes, relazione: bytes) -> None:
    """The same verdicts and numbers; and no English sentence but what the design file says, symbols and titles of
    books."""
    english, italian = text_of(engineer), text_of(relazione)
    for words in (
        "Relazione di calcolo",
        "Dati d'ingresso",
        "Ipotesi",
        "Verifica",
        "Foglio di disegno",
        "Fonti",
        "Pagina 1 di",
    ):
        assert squeezed(words) in squeezed(italian) and squeezed(words) not in squeezed(english)
    for sign in "✓▲✗":
        assert english.count(sign) == italian.count(sign) > 0
    symbols, simboli = (set(re.findall(r"^[^\s:=]+(?= = )", spoken(pdf), re.M)) for pdf in (engineer, relazione))
    assert symbols == simboli and len(symbols) > 60
    own = re.sub("“[^”]*”", "", italian)  # without what the design file says
    left = [
        line
        for line in map(without_titles, own.splitlines())
        if len(re.findall(r"\b(the|of|with|and|is|for|which)\b", line)) > 1
    ]
    allowed = ("The source's final design", "shear coefficient", "film at the edge", "Schlenk, Niemann and Winter")
    design = example.results.design
    quoted = squeezed(" ".join(entry.source for entry in (*design.oils.values(), *design.materials.values())))
    judge_english(
        "it", [line for line in left if squeezed(line) not in quoted and not any(words in line for words in allowed)]
    )


def test_every_value_stands_in_the_index_with_its_page(audit: bytes) -> None:
    pages = pages_of(audit)
    first = next(n for n, words in enumerate(pages) if re.search(r"^\d+  ?Index of values", words, re.M) and n > 3)
    entry = re.search(r"Sommerfeld number\s+(\d+)", "\n".join(pages[first:]))
    assert entry is not None and "Sommerfeld number" in pages[int(entry[1]) - 1]
    links = [a.get_object() for a in PdfReader(io.BytesIO(audit)).pages[first].get("/Annots", [])]
    assert len(links) > 50


def test_the_drawing_sheet_has_the_shaft_and_the_data_of_the_wheels(engineer: bytes, example: Solved) -> None:
    read = squeezed(text_of(engineer))
    for words in (
        "Drawing sheet",
        "Data of the wheels",
        "A–A",
        "Normal module",
        "Size over balls",
        "21.916°, left",
        "(377)",
        "1:2",
    ):
        assert squeezed(words) in read
    over = example.results.values()["gears.central.over_balls_max"].shown
    assert f"{over:.4f}".rstrip("0") in read


@pytest.mark.slow
def test_headings_are_never_last_on_a_page(example: Solved) -> None:
    from reports.report import blocks

    context = Context(example.document, example.results, "0" * 64, "audit", language("en"))
    pages = paginate(blocks(context))
    for page in pages:
        assert not page.blocks[-1][1].keep
        assert page.filled <= HEIGHT + 1e-6


def test_publications_and_standards_are_told_from_their_clauses() -> None:
    for source, name in (
        ("AGMA 925-A03: working pressure angle", "AGMA 925-A03"),
        ("ISO/TR 15144-1:2014 (84)", "ISO/TR 15144-1:2014"),
        ("ISO 6336-2, 5", "ISO 6336-2"),
        ("DIN 31652-1: Sommerfeld number", "DIN 31652-1"),
        ("Xu and Kahraman 2005: exponent", "Xu and Kahraman 2005"),
    ):
        assert cited(source) == name


def test_what_a_variant_has_in_common_with_its_part_is_not_repeated() -> None:
    @formula("F", "a formula for this test")
    def force(F: Newton) -> Newton:
        return F

    def line(value: float) -> Line:
        return Line(force, {"F": value}, value)

    values = (("mesh a", "", 34.0), ("mesh a", "source", 34.0), ("mesh b", "", 35.0), ("mesh b", "source", 36.0))
    said = _others(
        [(Label(part, variant), line(value)) for part, variant, value in values],
        [],
        [],
        SimpleNamespace(say=language("en"), text=lambda key, **parts: str(Text(WORDS[key].template, **parts))),  # type: ignore[arg-type]
    )
    assert said == "further: mesh a 34; mesh b 35, source 36 N"


def test_a_name_keeps_its_comma_where_part_and_variant_are_told_apart() -> None:
    bearing = Text("{place} bearing", place="front, left")
    assert language("en").halves(Text("{bearing}, thinnest corner", bearing=bearing)) == (
        "front, left bearing",
        "thinnest corner",
    )
    assert language("en").halves(bearing) == ("front, left bearing", "")
    assert language("it").halves(Text("mesh {pair}, forces", pair="a, b–c")) == ("ingranamento a, b–c", "forze")


def test_a_proof_whose_formulas_do_not_give_the_number_says_so(engineer: bytes) -> None:
    """A couple of unbalances that nobody gives is that of no formula."""
    read = squeezed(text_of(engineer))
    proof = read[read.index(squeezed("2.1 Wanted couple that pulley and flywheel leave")) :]
    assert squeezed("from no one formula") in proof[:400]


def test_what_uses_less_than_a_tenth_of_its_limit_is_not_proven(engineer: bytes) -> None:
    title = r"3\.\d+" + squeezed("Couple that the balance quality grade permits")
    assert not re.search(title, squeezed(text_of(engineer)))
    assert re.search(title.replace("Couple", "Stress").partition("that")[0], squeezed(text_of(engineer)))
    assert "s = √((L + r)² − d²)" not in spoken(engineer), "a formula of inputs alone"
