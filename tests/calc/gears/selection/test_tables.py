"""The tables of the search for shifts: what stands in them is what the trains of their rows are when they are solved
alone."""

from dataclasses import replace

import pytest

from calc.gears.selection import tables
from calc.gears.selection.states import HARDENED
from tests.calc.gears.trains import solved


@pytest.fixture(scope="module")
def found(source):
    return source


@pytest.fixture(scope="module")
def trains(found):
    """Of the rows asked for, solved once."""
    known = {}

    def made(row):
        if id(row) not in known:
            gears = row.freedom.gears if row.freedom else found.case.gears
            shift, cut = row.free, row.cuts
            wheels = (
                replace(
                    w,
                    profile_shift=shift.get(w.name, w.profile_shift),
                    tip_shortening=cut.get(w.name, w.tip_shortening),
                )
                for w in gears.wheels
            )
            known[id(row)] = solved(replace(gears, wheels=tuple(wheels)))
        return known[id(row)]

    return made


def rows_of(table):
    """Each row by its labels."""
    return [dict(zip((str(label) for label, _ in table.columns), row, strict=True)) for row in table.rows]


def sliding(made):
    """The largest of every wheel in each of its meshes, named by it and its mate."""
    meshes = made.meshes.values()
    found = {f"{m.driver}/{m.driven}": abs(m.specific_sliding_driver) for m in meshes}
    return found | {f"{m.driven}/{m.driver}": abs(m.specific_sliding_driven) for m in meshes}


def at(number, digits=3):
    """As a table rounds it."""
    return pytest.approx(number, abs=0.5001 * 10**-digits)


def test_the_choices_show_shifts_and_largest_sliding(found, trains):
    rows = rows_of(tables.choices_table(found, 2))
    assert [row["no."] for row in rows] == ["now", "1", "2"]
    for shown, row in zip(rows, (found.now, *found.optima)):
        made = trains(row)
        assert [shown[f"x {name}"] for name in made.wheels] == [at(w.profile_shift, 5) for w in made.wheels.values()]
        assert [shown["max |ζ_A|"]] * 2 == [at(max(sliding(made).values())), at(sliding(made)[shown["of"]])]
        assert shown["margin"] == at(row.margin * 100, 1) and str(shown["by"]).startswith("ε_α ")


def test_what_each_pair_wants_is_best_for_itself(found, trains):
    rows = rows_of(tables.wants_table(found))
    assert [row["pair"] for row in rows] == ["crank–central", "central–idler", "idler–shaft"]
    for shown, row in zip(rows, found.wants):
        made = trains(row)
        m = made.meshes[row.wants]
        assert shown["its own max |ζ_A|"] == at(max(abs(m.specific_sliding_driver), abs(m.specific_sliding_driven)))
        assert [shown["max |ζ_A|"]] * 2 == [at(max(sliding(made).values())), at(sliding(made)[shown["of"]])] and shown[
            "breaks"
        ] == ""
        assert [shown[f"x {name}"] for name in made.wheels] == [at(w.profile_shift, 5) for w in made.wheels.values()]


def test_the_rows_around_the_optimum_are_round_and_rise_on_both_sides(found):
    rows = rows_of(tables.around_table(found))
    x, sliding = ([row[name] for row in rows] for name in ("x central", "max |ζ_A|"))
    assert x == sorted(x) and all(one == round(one, 4) and round(one / 0.05, 6) % 1 == 0 for one in x)
    least = sliding.index(min(sliding))
    assert 0 < least < len(rows) - 1 and sliding == sorted(sliding[:least], reverse=True) + sorted(sliding[least:])
    assert abs(x[least] - found.exact[0]) < 0.05


def test_the_sliding_of_every_mesh(found, trains):
    """Of the design as it is, of the optima and of what the pairs want, as many as are asked for: a row for each mesh,
    numbered at the first."""
    rows = rows_of(tables.sliding_table(found, len(found.optima) + len(found.wants)))
    first = rows_of(tables.sliding_table(found, 1))
    assert first == rows[: len(first)] and 0 < len(first) < len(rows)
    shown = iter(rows)
    for row in (found.now, *found.optima, *found.wants):
        made, m_n = trains(row), found.case.system.m_n
        for i, m in enumerate(made.meshes.values()):
            one, both = next(shown), (made.wheels[m.driver], made.wheels[m.driven])
            assert (one["no."], one["mesh"]) == (
                ("now" if row is found.now else found.number(row)) if i == 0 else "",
                f"{m.driver}–{m.driven}",
            )
            assert one["a_w"] == at(m.centre_distance * 1e3, 4) and one["ε_α"] == at(m.transverse_contact_ratio)
            assert (one["ζ_A driver"], one["ζ_A driven"]) == (
                at(m.specific_sliding_driver),
                at(m.specific_sliding_driven),
            )
            assert (one["ζ_B driver"], one["ζ_B driven"]) == (
                at(m.specific_sliding_lpstc_driver),
                at(m.specific_sliding_lpstc_driven),
            )
            assert one["s_an/m_n"] == at(min(w.tip_thickness_normal for w in both) / m_n)
            assert one["c/m_n"] == at(min(m.tip_clearance_driver, m.tip_clearance_driven) / m_n)
            active = m.sap_diameter_driver, m.sap_diameter_driven
            thinnest = [w.form_diameter_min or w.form_diameter for w in both]
            assert one["above fillet/m_n"] == at(min(d - d_Ff for d, d_Ff in zip(active, thinnest)) / 2 / m_n)
    assert next(shown, None) is None


def test_tip_cuts_one_by_one(found, trains):
    """Every wheel's cuts from none on, a row for each of its meshes: what they do to it and to its mate."""
    rows = rows_of(tables.cuts_now_table(found))
    cuts = {(name, round(k * 1e3, 6)): row for row in found.cut_now for name, k in row.cuts.items()}
    wheel_of, k, first = "", 0.0, {}
    for shown in rows:
        if shown["cut"]:
            before, wheel_of, k = (wheel_of, k), shown["cut"], shown["k"]
            assert wheel_of != before[0] or k > before[1]
            first[wheel_of] = first.get(wheel_of, 0) + 1
        row = cuts.get((wheel_of, k), found.now)
        made, mate = trains(row), shown["mate"]
        m = next(m for m in made.meshes.values() if {m.driver, m.driven} == {wheel_of, mate})
        own, other = ("driver", "driven") if m.driver == wheel_of else ("driven", "driver")
        assert (shown["ζ_A cut"], shown["ζ_A mate"]) == tuple(
            at(getattr(m, f"specific_sliding_{side}")) for side in (own, other)
        )
        assert (shown["ζ_B cut"], shown["ζ_B mate"]) == tuple(
            at(getattr(m, f"specific_sliding_lpstc_{side}")) for side in (own, other)
        )
        assert shown["ε_α"] == at(m.transverse_contact_ratio) and shown["s_an cut"] == at(
            made.wheels[wheel_of].tip_thickness_normal * 1e3
        )
        assert shown["d_Nf mate"] == at(getattr(m, f"sap_diameter_{other}") * 1e3)
        assert shown["c mate"] == at(getattr(m, f"tip_clearance_{other}") * 1e3)
        assert (shown["max |ζ_A|"], shown["no."]) == (
            (at(max(sliding(made).values())), "now" if row is found.now else found.number(row))
            if shown["cut"]
            else (None, "")
        )
    assert all(first[name] == 1 + sum(name in row.cuts for row in found.cut_now) for name in first) and len(first) == 4


def test_tip_cuts_with_their_best_shift(found, trains):
    rows = rows_of(tables.cuts_best_table(found, 3))
    for shown, row in zip(rows, found.cut_best, strict=False):
        made = trains(row)
        assert (shown["cut"], shown["k"]) == (row.name, at(row.cuts[row.name] * 1e3, 6))
        assert (shown["max |ζ_A|"], shown["no."]) == (at(max(sliding(made).values())), found.number(row))
        assert shown["x central"] == at(made.wheels["central"].profile_shift, 5)
    assert len(rows) == 3 and f"{len(found.cut_best) - 3} more" in tables.cuts_best_table(found, 3).note
    assert "more;" not in tables.cuts_best_table(found, 99).note


def test_what_there_is_to_say(found, monkeypatch):
    """Which shifts are free and what distance is held; the optimum before rounding; tips for hardened teeth or under
    that."""
    assert [words.split(":")[0] for words in tables.summary(found)[:3]] == [
        "crank as shaft",
        "distance held",
        "distance free",
    ]
    held = found.now.states.distances["crank_central"][0] * 1e3
    assert f"Held: crank–central at {held:.3f} mm" in tables.summary(found)[1]
    assert f"{found.exact[0]:.6f}" in tables.summary(found)[3] and f"{found.exact[1]:.5f}" in tables.summary(found)[3]
    assert any("All have tips for case-hardened teeth" in words for words in tables.notes(found))
    monkeypatch.setattr(tables, "HARDENED", replace(HARDENED, limit=0.7))
    thin = [
        n for n, row in enumerate(found.all, 1) if min(s[0] for s in row.states.tip_thickness.values()) < 0.7 * 2e-3
    ]
    said = next(words for words in tables.notes(found) if words.startswith("Tips under 0.7·m_n"))
    assert 1 < len(thin) < len(found.all) and said.endswith(f"rows {', '.join(map(str, thin))}.")


def test_a_row_is_told_by_its_shifts_its_held_distance_and_its_cut(found):
    held = next(row for row in found.optima if row.freedom.key == "held")
    assert tables.changed(held) == f"x central = {held.free['central']:.4f}, crank–central 65.808 mm".replace("-", "−")
    cut = found.cut_best[0]
    assert tables.changed(cut).endswith(f"tip cut {cut.name} {cut.cuts[cut.name] * 1e3:g} mm")
