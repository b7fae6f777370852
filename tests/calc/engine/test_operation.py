"""The one table of speed, load, gas, oil and hours: what it refuses, and who reads it."""

import re
from dataclasses import replace

import pytest

from calc.bearings.plain.speeds import of_journals
from calc.design.toml_file import design, parse
from calc.mounting.wrenches import operating, running
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.drive.problem import _cycle
from tests.conftest import DESIGNS

MOUNTED = (DESIGNS / "r753ie4_mounting.toml").read_text(encoding="utf-8")
GAS = """peak_pressure_bar = 62.0
intake_pressure_bar = 1.0
exhaust_pressure_bar = 1.05
constant_pressure_angle_deg = 4.0
"""


def row(name, speed, more=""):
    return f'\n[[engine.operation]]\nname = "{name}"\nspeed_rpm = {speed}\n{more}'


def made(text):
    return design(parse(text.encode(), "d.toml"))


def without_operations(text=MOUNTED):
    """The design without the operations of its mounts."""
    return re.sub(r"\[\[mounting\.operation\]\][^\[]*", "", text)


@pytest.mark.parametrize(
    ("rows", "key", "words"),
    [
        (row("a", 900) + row("b", 900), "engine.operation.1.speed_rpm", 'speed and load are those of "a"'),
        (row("a", 900, "load_percent = 101"), "engine.operation.0.load_percent", "from 0 to 100"),
        (row("a", 900, "load_percent = -1"), "engine.operation.0.load_percent", "from 0 to 100"),
        (row("range", 900), "engine.operation.0.name", "take another"),
        ("\n[engine.crank_twist]\nfrequency_Hz = 300\nnose_inertia_kgm2 = 0.1\ndamping_ratio = 0.4", "engine.crank_twist.damping_ratio", "from 0 to 0.3"),
    ],
)  # fmt: skip
def test_refused(rows, key, words):
    with pytest.raises(BadInput) as caught:
        made(without_operations() + rows)
    (error,) = caught.value.errors
    assert error.key == key and words in error.reason


def test_two_loads_at_one_speed_are_two_rows():
    rows = made(without_operations() + row("a", 900, "load_percent = 0") + row("b", 900)).engine.operation
    assert [part.load for part in rows] == [0.0, 1.0]


def test_an_idle_speed_stays_below_the_rated_one():
    with pytest.raises(BadInput, match=r"engine.idle_speed_rpm.*must stay below the rated speed, 2600 rpm"):
        made(MOUNTED.replace("rated_speed_rpm", "idle_speed_rpm = 2600\nrated_speed_rpm", 1))


def test_pressures_of_a_row_need_the_gas():
    twin = (DESIGNS / "twin_force_shaft.toml").read_text(encoding="utf-8")
    head, _, rest = twin.partition("[engine.gas]")
    bare = head + rest[rest.index("[engine.throw]") :]
    with pytest.raises(BadInput, match=r"its pressures need \[engine.gas\]"):
        made(bare + row("a", 900, "peak_pressure_bar = 50"))
    assert made(bare + row("a", 900)).engine.operation


def test_rows_with_temperature_and_pressure_of_the_oil_are_the_bench_run():
    rows = row("a", 900, "load_percent = 0\noil_temperature_C = 70\noil_pressure_bar = 1") + row(
        "b", 900, "oil_temperature_C = 80\noil_pressure_bar = 1.5"
    )
    rows += row("c", 2000, "oil_temperature_C = 90") + row("d", 2600, "oil_temperature_C = 110\noil_pressure_bar = 3")
    measured = made(without_operations() + rows).engine
    assert measured.gallery == measured.bench  # which rules where it is given
    engine = replace(measured, bench=())
    assert [(round(p.speed * 60), p.oil_temperature, p.oil_pressure) for p in engine.gallery] == [
        (900, 80, 1.5e5),
        (2600, 110, 3e5),
    ]
    assert of_journals(engine, 2.0)[1][0].speed == pytest.approx(30)


def test_the_mounts_read_the_table():
    """The same four operations in the one table: the same vibration, without hours no exposure.  Near idle speed the
    row of least load counts, elsewhere that of most."""
    rated = GAS.replace("62.0", "130.0").replace("1.0\n", "1.75\n").replace("1.05", "1.65").replace("4.0", "14.0")
    rows = row("under-load", 900, "peak_pressure_bar = 90\n") + row("idle", 900, "load_percent = 0\n" + GAS)
    rows += row("slow", 1500, "hours = 3\n") + row("work", 2200) + row("rated", 2600, rated)
    rows += row("half", 2600, "load_percent = 50\npeak_pressure_bar = 70\n")
    here, there = made(MOUNTED), made(without_operations() + rows)
    names = [part.name for part in running(there.mounting, there.engine)]
    assert names == ["idle", "slow", "work", "rated"] == [part.name for part in here.mounting.operation]
    assert all(hours == 0 for _, _, hours in operating(there.mounting, there.engine))
    before, after = (
        {id: v.inside for id, v in solve(each).values().items() if id.startswith("mounting.")} for each in (here, there)
    )
    gone = set(before) - set(after)
    assert gone and all("exposure" in id for id in gone) and len(after) > 500
    for id, number in after.items():
        assert number == pytest.approx(before[id], rel=1e-12, abs=1e-15), id


def test_the_search_reads_its_cycle_there():
    rows = row("a", 650, "hours = 30") + row("b", 2600, "hours = 10") + row("c", 1300)

    class Left:
        cycle = ()

    assert _cycle(made(without_operations() + rows), Left()) == (
        (pytest.approx(0.25), 0.75),
        (pytest.approx(1.0), 0.25),
    )
    assert _cycle(made(without_operations()), Left()) == ()
