# SPDX-License-Identifier: Apache-2.0
"""Parts that are kept between runs: one that anything happened to is done again, or is what it was."""

import os
import random
import zipfile
from dataclasses import replace

import numpy as np
import pytest

import calc.studies.drive.search as running
from calc.sheet.text import EMPTY
from calc.studies.drive.classes import ClassFront
from calc.studies.drive.combinations import DriveRows, no_rows
from calc.studies.drive.search import FrontTable, classes, key, solved


def rows(count):
    rng = np.random.default_rng(3)
    shapes = {name: (count, *column.shape[1:]) for name, column in vars(no_rows()).items()}
    return DriveRows(**{name: rng.random(shape) for name, shape in shapes.items()})


@pytest.fixture
def kept(few, tmp_path):
    running._keep(few, 0, ClassFront(rows(40), 10**12, (3.0, 1.05), 1.5, EMPTY), tmp_path)
    (path,) = tmp_path.glob("*.npz")
    return path


def test_a_part_comes_back_as_it_was(few, kept):
    one = running._kept(few, 0, kept.parent)
    assert (
        one is not None
        and one.combinations == 10**12
        and one.crank == (3.0, 1.05)
        and one.wheels == 1.5
        and not one.why
    )
    assert all(np.array_equal(column, vars(rows(40))[name]) for name, column in vars(one.rows).items())


def test_whatever_happens_to_a_part_it_is_refused_or_what_it_was(few, kept):
    good, rng, refused = kept.read_bytes(), random.Random(5), 0
    for _ in range(400):
        broken = bytearray(good)
        if rng.random() < 0.3:
            del broken[rng.randrange(len(good)) :]
        for _ in range(rng.choice((1, 1, 3, 20)) if broken else 0):
            broken[rng.randrange(len(broken))] = rng.randrange(256)
        kept.write_bytes(broken)
        one = running._kept(few, 0, kept.parent)
        refused += one is None
        assert one is None or all(
            np.array_equal(column, vars(rows(40))[name]) for name, column in vars(one.rows).items()
        )
    assert refused > 300


@pytest.mark.skipif(os.name != "posix", reason="pipes of POSIX")
def test_a_part_that_never_ends_or_is_packed_by_somebody_else_is_done_again(few, kept, monkeypatch):
    with zipfile.ZipFile(kept) as file:
        members = {name: file.read(name) for name in file.namelist()}
    with zipfile.ZipFile(kept, "w", zipfile.ZIP_DEFLATED) as file:
        for name, content in members.items():
            file.writestr(name, content)
        file.writestr("more", bytes(2**20))
    monkeypatch.setattr(running, "PART_BYTES", 2**19)
    assert kept.stat().st_size < 2**19 and running._kept(few, 0, kept.parent) is None
    kept.unlink()
    os.mkfifo(kept)
    assert running._kept(few, 0, kept.parent) is None


@pytest.mark.parametrize(
    "change",
    [
        {"margins": (0.0,)},
        {"surfaces": ((0.4, 0.4),)},
        {"limits": ()},
        {"waived": ("bearings.*",)},
        {"cycle": ((0.5, 1.0),)},
        {"sizes": {}},
        {"choices": {}},
    ],
)
def test_a_part_is_of_one_problem_alone(few, change):
    assert key(replace(few, **change)) != key(few)


def test_another_design_is_another_problem(few):
    assert key(replace(few, start=few.start.with_value("engine.rated_speed_rpm", 2601.0))) != key(few)


def test_an_interrupt_while_drives_are_solved_keeps_those_that_are(few, tmp_path):
    """As Ctrl-C has it while rows are solved whole, the longest time of a small search."""
    known = running.table(few, dict(classes(few, 1, tmp_path)))
    assert isinstance(known, FrontTable)

    def told(count, of):
        if count == 3:
            raise KeyboardInterrupt

    drives, _ = solved(few, known, told)
    assert 1 <= len(drives) <= 3 and all(one.broken == () for one in drives)

    def at_once(count, of):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        solved(few, known, at_once)
