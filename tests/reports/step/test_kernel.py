# SPDX-License-Identifier: Apache-2.0
"""The kernel: which version is asked for, its silence, and the files that it writes."""

import pytest

pytest.importorskip("OCP")

from reports.step import kernel as k


def cylinder():
    return k.revolved(k.face(k.polygon([(0.0, 0.0, 0.0), (10.0, 0.0, 0.0), (10.0, 0.0, 30.0), (0.0, 0.0, 30.0)])))


def test_another_kernel_is_named_with_its_version(monkeypatch):
    monkeypatch.setitem(k.NAMES, "collections", ("NoSuchArray",))
    with pytest.raises(k.WrongKernel, match=r"installed, 8\..* is not >=8\.0\.1,<9 \(collections: .*NoSuchArray"):
        k.kernel.__wrapped__()


def test_nothing_is_said_on_the_standard_output(capfd):
    k.step_file([k.StepPart("a", (("a", cylinder()),))], "a.step", "2026-01-01", ["a"])
    said = capfd.readouterr()
    assert said.out == said.err == ""


def test_an_assembly_is_the_same_each_time_and_has_its_parts_by_name():
    parts = [
        k.StepPart(name, ((name, cylinder()),), (10.0 * n, 0.0, 0.0), 0.1) for n, name in enumerate(("left", "right"))
    ]
    first, again = (k.step_file(parts, "a.step", "2026-01-01", ["a"], "engine") for _ in range(2))
    assert first == again
    text = first.decode("ascii")
    for n, name in enumerate(("left", "right"), 1):
        assert f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('{n}','{name}'" in text and f"PRODUCT('{name}','{name}'" in text
    assert "PRODUCT('engine','engine'" in text


def test_letters_of_other_alphabets_are_written_as_the_standard_has_them():
    text = k.step_file([k.StepPart("Wälle", (("a", cylinder()),))], "Ü.step", "2026-01-01", ["ein " * 40]).decode(
        "ascii"
    )
    assert r"W\X4\000000E4\X0\lle" in text and r"'\X4\000000DC\X0\.step'" in text
    assert "ein " * 40 in text  # on one line


def test_a_shape_that_is_no_solid_is_a_fault():
    shell = k.face(k.polygon([(0.0, 0.0, 0.0), (10.0, 0.0, 0.0), (10.0, 0.0, 30.0)]))
    with pytest.raises(k.KernelFault, match="the solid of a has 0 bodies"):
        k.demand_valid(shell, "a")
    two = k.compound([cylinder(), k.moved(cylinder(), (50.0, 0.0, 0.0))])
    k.demand_valid(two, "a")
    with pytest.raises(k.KernelFault, match="2 bodies"):
        k.demand_valid(two, "a", 1)


def test_a_cylinder_weighs_what_it_does():
    found = k.properties(k.moved(cylinder(), (0.0, 5.0, -15.0), 0.7))
    assert found.volume == pytest.approx(3000 * 3.141592653589793, rel=1e-12)
    assert found.centre == pytest.approx([0.0, 5.0, 0.0], abs=1e-9)
    assert found.tensor[2, 2] == pytest.approx(found.volume * 50, rel=1e-12)
