# SPDX-License-Identifier: Apache-2.0
"""Editing a design file in place, and putting it on disk whole."""

import tomllib
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from assistant.session.saving import (
    ChangedOnDisk,
    SaveError,
    differences,
    edited_text,
    fresh_text,
    spare,
    write_asked,
    write_atomic,
)
from assistant.session.session import EXAMPLE
from calc.sheet.errors import BadInput

TEXT = EXAMPLE.read_text(encoding="utf-8")


def lines_that_differ(old: str, new: str) -> list[tuple[str, str]]:
    return [(a, b) for a, b in zip(old.splitlines(), new.splitlines(), strict=False) if a != b]


def test_no_change_gives_the_same_text() -> None:
    assert edited_text(TEXT, {}) == TEXT


def test_one_value_changes_one_line_and_keeps_its_comment() -> None:
    made = edited_text(TEXT, {"imbalance.crank_balance_fraction": 0.4})
    assert lines_that_differ(TEXT, made) == [
        (
            "crank_balance_fraction = 0.5    # crank, pulley and flywheel together",
            "crank_balance_fraction = 0.4    # crank, pulley and flywheel together",
        )
    ]


@pytest.mark.parametrize("key", ["gears.wheels.shaft.teeth", "gears.wheels.3.teeth"])
def test_elements_are_addressed_by_name_or_index(key: str) -> None:
    assert tomllib.loads(edited_text(TEXT, {key: 26}))["gears"]["wheels"][3]["teeth"] == 26


def test_inline_tables_are_edited_where_they_stand() -> None:
    made = edited_text(TEXT, {"engine.bench.1.oil_pressure_bar": 4.4})
    assert "    { speed_rpm = 2547.0, oil_temperature_C = 117.2, oil_pressure_bar = 4.4 }," in made.splitlines()
    assert len(lines_that_differ(TEXT, made)) == 1


def test_none_takes_a_key_out() -> None:
    made = edited_text(TEXT, {"bearings.slope_mrad": None})
    assert "slope_mrad" not in made
    assert len(made.splitlines()) == len(TEXT.splitlines()) - 1
    assert edited_text(TEXT, {"bearings.roughness_ratio": None}) == TEXT  # was not there


def test_a_new_key_goes_to_the_end_of_its_own_table() -> None:
    made = edited_text(TEXT, {"bearings.rear.clearance_um": 60.0, "engine.cylinder_offset_mm": 3.0})
    lines = made.splitlines()
    rear, offset = lines.index("clearance_um = 60.0"), lines.index("cylinder_offset_mm = 3.0")
    assert lines.index("[bearings.rear]") < rear < lines.index("[gears]")
    assert lines.index("[engine]") < offset < lines.index("[imbalance]")


def test_a_new_table_and_a_new_element_are_made() -> None:
    made = edited_text(
        "schema = 1\n",
        {"engine.name": "x", "friction.other_losses.0.name": "seal", "friction.other_losses.0.power_W": 3.0},
    )
    assert tomllib.loads(made) == {
        "schema": 1,
        "engine": {"name": "x"},
        "friction": {"other_losses": [{"name": "seal", "power_W": 3.0}]},
    }


def test_whole_numbers_stay_whole() -> None:
    made = edited_text(TEXT, {"gears.meshes.1.tolerance_um": 60.0, "gears.wheels.0.span_allowance_um": [-25.0, -35.0]})
    assert "tolerance_um = 60\n" in made
    assert "span_allowance_um = [-25, -35]  # was [-20, -30], assumed" in made


def test_what_is_said_of_a_value_is_not_said_of_another() -> None:
    key, text = (
        "bearings.front.diameter_mm",
        "[bearings.front]\ndiameter_mm = 80.0  # assumed: usual\nlength_mm = 56.0  # measured\n",
    )
    once = edited_text(text, {key: 78.5, "bearings.front.length_mm": 50.0})
    assert (
        once
        == "[bearings.front]\ndiameter_mm = 78.5  # was 80.0, assumed: usual\nlength_mm = 50.0  # was 56.0, measured\n"
    )
    assert edited_text(once, {key: 77.0}) == once.replace("= 78.5", "= 77.0")
    assert edited_text(once, {key: 80.0, "bearings.front.length_mm": 56.0}) == text
    several = "[a]\nb = [\n  1,\n  2,\n]  # assumed: usual\n"
    assert edited_text(several, {"a.b": [3, 4]}).endswith("# assumed: usual\n")


def test_text_is_quoted() -> None:
    note = 'he said "5 µm" \\ and left\n[engine]'
    assert tomllib.loads(edited_text(TEXT, {"note": note}))["note"] == note


def test_an_unknown_element_is_an_error() -> None:
    with pytest.raises(SaveError, match='no element "nobody"'):
        edited_text(TEXT, {"gears.wheels.nobody.teeth": 3})


@pytest.mark.parametrize("begin", ["", "\ufeff"])
def test_line_ends_and_byte_order_mark_are_kept(begin: str) -> None:
    text = begin + "# mine\r\n[engine]\r\nbore_mm = 94.0  # bore\r\n"
    assert (
        edited_text(text, {"engine.bore_mm": 95.0, "engine.strokes": 4})
        == begin + "# mine\r\n[engine]\r\nbore_mm = 95.0  # bore\r\nstrokes = 4\r\n"
    )


def test_differences_lead_from_one_to_the_other() -> None:
    old = tomllib.loads(TEXT)
    new = tomllib.loads(TEXT)
    new["gears"]["wheels"][2] = {"name": "other", "teeth": 40}
    new["countershaft"]["masses"].append(
        {"name": "middle", "mass_kg": 1.0, "radius_mm": 2.0, "angle_deg": 3.0, "z_mm": 4.0}
    )
    del new["engine"]["bench"][10:]
    del new["bearings"]["front"]["clearance_factor"]
    new["bearings"]["front"]["clearance_um"] = 80.0
    del new["friction"]
    made = edited_text(TEXT, differences(old, new))
    assert tomllib.loads(made) == new
    assert "# piston 785, rings" in made
    assert differences(old, old) == []


@settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])  # a loaded machine is no mistake
@given(
    st.dictionaries(
        st.sampled_from("abcd"),
        st.recursive(st.integers() | st.text(max_size=5), lambda x: st.dictionaries(st.sampled_from("xyz"), x)),
    ),
    st.dictionaries(
        st.sampled_from("abcd"),
        st.recursive(st.integers() | st.text(max_size=5), lambda x: st.dictionaries(st.sampled_from("xyz"), x)),
    ),
)
def test_any_tables_can_be_led_to_any_others(old: dict[str, object], new: dict[str, object]) -> None:
    assert tomllib.loads(edited_text(fresh_text(old), differences(old, new))) == new


# --- the disk
def test_a_folder_that_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(SaveError, match="can not be written"):
        write_atomic(tmp_path / "no" / "a.toml", b"x")


def test_a_file_that_was_changed_since_it_was_read_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    path.write_bytes(b"of another")
    with pytest.raises(ChangedOnDisk, match=r"a\.toml was changed by another program"):
        write_atomic(path, b"mine", expected=b"as it was")
    assert path.read_bytes() == b"of another" and list(tmp_path.iterdir()) == [path]


def test_what_a_command_reads_it_does_not_write(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    path.write_bytes(b"design")
    for refused in (
        lambda: spare(path, path),
        lambda: write_asked(path, "x", inputs=[path]),
        lambda: write_asked(path, "x", new=True),
    ):
        with pytest.raises(BadInput, match=r"an input of this very command|File exists"):
            refused()
    assert path.read_bytes() == b"design" and list(tmp_path.iterdir()) == [path]
