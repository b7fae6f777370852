"""Chunks that are kept: a run goes on where it stood, whoever computes them gives the same table, and damage is
seen."""

import io
import os
import random
from importlib.util import find_spec

import pytest

from calc.design.toml_file import read
from calc.studies.sweep import Sweep, grid, swept, table, varied
from calc.studies.sweep.run import SIZE
from calc.studies.sweep.table import Chunk, InFolder, InMemory, SweepRow, key_of, write_csv, write_parquet
from tests.conftest import GAMMA as FILE

GAMMA = read(FILE)
INPUTS = varied(GAMMA, ["engine.rated_speed_rpm=1000,2000,99999", "friction.oil_temperature_C=70:110:60"])
TASK = Sweep(GAMMA, grid(INPUTS), "friction", ("friction.total_loss",))


def text_of(store):
    file = io.StringIO()
    write_csv(file, GAMMA, INPUTS, store)
    return file.getvalue()


@pytest.fixture(scope="module")
def expected():
    store = InMemory()
    swept(TASK, store)
    return text_of(store)


@pytest.fixture
def kept(tmp_path):
    return InFolder(tmp_path / "parts", key_of(GAMMA, TASK.plan, TASK.step, TASK.wanted))


def test_a_run_goes_on_where_it_stood(expected, kept):
    def interrupted(done):
        if done > 60:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        swept(TASK, kept, interrupted)
    known = len(kept)
    assert 1 < known < -(-TASK.plan.count // SIZE)
    done = []
    swept(TASK, kept, done.append)
    assert done[0] == known * SIZE and done[-1] == TASK.plan.count
    assert text_of(kept) == expected


@pytest.mark.slow
def test_damage_to_a_kept_chunk_is_seen(expected, kept):
    swept(TASK, kept)
    rng = random.Random(5)
    files = sorted(kept.folder.iterdir())
    for file in files:
        file.write_bytes(file.read_bytes()[: rng.randrange(file.stat().st_size)])
    assert not any(kept.has(n) for n in range(len(files)))
    swept(TASK, kept)
    assert text_of(kept) == expected
    kept.clear()
    assert not kept.folder.exists()


ONE = Chunk({"a": "mm"}, ("engine",), (SweepRow((1.0,), (2.0,), ("pass",), "pass"),))


def test_what_two_runs_of_one_sweep_keep_goes_with_the_last_of_them(kept):
    other = InFolder(kept.folder, kept.key)
    with kept.shared():
        kept.keep(0, ONE)
        with other.shared():
            kept.clear()  # the first is done
            assert other.has(0)
        other.clear()  # the first still reads
        assert kept.has(0)
    kept.clear()
    assert not kept.folder.exists()


def test_a_run_that_comes_while_another_takes_its_chunks_away_begins_anew(kept, monkeypatch):
    """The file by which they see each other is gone between opening and locking it."""
    take, gone = table.lock, []

    def late(handle, **how):
        if not gone:
            gone.append(True)
            kept.clear()
        return take(handle, **how)

    monkeypatch.setattr(table, "lock", late)
    with kept.shared():
        assert gone and os.listdir(kept.folder)  # a new one, which others see
        monkeypatch.undo()
        kept.clear()
        assert os.listdir(kept.folder)
    kept.clear()
    assert not kept.folder.exists()


@pytest.mark.parametrize(
    "text",
    [
        b"",
        b"[" * 100_000,
        b"[]",
        b"3",
        b'{"units": 3, "steps": [], "count": 0, "reasons": false}',
        b'{"units": {}, "steps": [], "count": 1, "reasons": false}\n[[], [1.0], [], "pass", ""]',
        b'{"units": {}, "steps": [], "count": 1, "reasons": false}\n{"a": 1}',
        b"\xff",
        None,
    ],
)
def test_what_is_no_chunk_is_computed_again(kept, text):
    kept.keep(0, ONE)
    (file,) = kept.folder.iterdir()
    if text is None:
        file.unlink()
        os.mkfifo(file)
    else:
        file.write_bytes(text)
    assert not kept.has(0)
    kept.keep(0, ONE)
    assert kept.has(0) and [*kept.folder.iterdir()] == [file]


def test_kept_chunks_are_of_one_sweep_alone():
    key = key_of(GAMMA, TASK.plan, "friction", ("friction.total_loss",))
    others = [
        key_of(GAMMA.with_value("engine.bore_mm", 93.0), TASK.plan, "friction", ("friction.total_loss",)),
        key_of(GAMMA, grid(INPUTS[:1]), "friction", ("friction.total_loss",)),
        key_of(GAMMA, TASK.plan, None, ("friction.total_loss",)),
        key_of(GAMMA, TASK.plan, "friction", ()),
    ]
    assert len({key, *others}) == 5


@pytest.mark.skipif(find_spec("pyarrow") is None, reason="an extra")
def test_parquet_holds_the_same_table(expected, kept, tmp_path):
    import csv

    import pyarrow.parquet

    swept(TASK, kept)
    counts = write_parquet(tmp_path / "a.parquet", GAMMA, INPUTS, kept)
    assert counts.total() == TASK.plan.count and counts["bad_input"] == 11
    table = pyarrow.parquet.read_table(tmp_path / "a.parquet")
    header, *rows = csv.reader(expected.splitlines())
    assert table.column_names == header
    for given, row in zip(table.to_pylist(), rows, strict=True):
        assert ["" if value is None else str(value) for value in given.values()] == row
    first = (tmp_path / "a.parquet").read_bytes()
    write_parquet(tmp_path / "a.parquet", GAMMA, INPUTS, kept)
    assert (tmp_path / "a.parquet").read_bytes() == first
