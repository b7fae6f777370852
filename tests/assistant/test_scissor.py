# SPDX-License-Identifier: Apache-2.0
"""What the drive over speed asks in the form: a scissor gear is added to a mesh, the motion of the crank to the train."""

from pathlib import Path

import pytest

from assistant.session.recovery import Memory
from assistant.session.session import Session
from assistant.widgets.field import Field
from assistant.widgets.headings import ArrayHeading, TableHeading
from tests.assistant.conftest import Screen
from tests.assistant.driving import rows, settled, strike, until, work
from tests.conftest import DESIGNS

SCISSOR = ("gears", "meshes", 0, "scissor")


@pytest.mark.slow
async def test_a_scissor_gear_is_added_to_a_mesh(screen: Screen, tmp_path: Path, memory: Memory) -> None:
    path = tmp_path / "pair.toml"
    path.write_bytes((DESIGNS / "timing_pair.toml").read_bytes())  # of gears alone
    session = Session.open(path, memory=memory)
    async with screen(size=(120, 60), session=session) as pilot:
        await strike(pilot, "alt+5")
        await settled(pilot)
        form = work(pilot).form
        form.opened |= set(range(8))
        form.rebuild()
        await settled(pilot)
        heading = next(h for h in form.query(TableHeading) if h.row.place == SCISSOR)
        assert "Scissor gear" in heading.render().plain and "+ add" in heading.render().plain
        heading.focus()
        await settled(pilot)
        await strike(pilot, "plus")
        await settled(pilot)
        assert session.value(SCISSOR) == {}
        shown = [f.place[-1] for f in form.query(Field) if f.display and f.place[:4] == SCISSOR]
        assert shown == ["torque_Nm", "stiffness_Nm_deg", "face_width_mm", "to_rpm", "wheel"]
        assert set(session.reasons()) == {(*SCISSOR, "torque_Nm")}  # all else may be left out
        await until(pilot, lambda: "Spring torque of the" in rows(pilot) and "Rate of its spring" in rows(pilot))
        drive = next(h for h in form.query(TableHeading) if h.row.place == ("gears", "drive"))
        drive.focus()
        await settled(pilot)
        await strike(pilot, "plus")
        await settled(pilot)
        arrays = [h.row.place[-1] for h in form.query(ArrayHeading) if h.row.place[:2] == ("gears", "drive")]
        assert {"irregularity", "drag"} <= set(arrays)
        await until(pilot, lambda: "End of the crank" in rows(pilot))
