# SPDX-License-Identifier: Apache-2.0
"""Files, reports, recordings and comparisons."""

import re

from textual.pilot import Pilot

from assistant.screens.compare import CompareScreen
from assistant.screens.path_dialogs import CompareWith, ExportDialog, OpenDialog, RecordDialog, SaveDialog
from assistant.screens.start import Start
from assistant.screens.workbench import Workbench
from calc.design.toml_file import load
from tests.assistant.action_tests import SHARE, Do, back, deed, edited, give, over, still, text, titles
from tests.assistant.driving import screen_rows, strike, told, until, work


# --- files
@deed
async def report(pilot: Pilot[int], do: Do) -> None:
    path = work(pilot).session.home.with_suffix(".pdf")
    await do()
    await until(pilot, lambda: f"PDF report: {path}" in told(pilot))
    assert path.read_bytes().startswith(b"%PDF-")


@deed
async def export(pilot: Pilot[int], do: Do) -> None:
    path = work(pilot).session.home.with_name("out.csv")
    await do()
    await give(pilot, ExportDialog, path)
    await until(pilot, lambda: f"Exported: {path}" in told(pilot))
    assert "\nengine.stroke,107" in path.read_text(encoding="utf-8")


@deed
async def save(pilot: Pilot[int], do: Do) -> None:
    session = await edited(pilot)
    before = session.home.read_text(encoding="utf-8")
    await do()
    await until(pilot, lambda: f"Saved: {session.home}" in told(pilot))
    after = session.home.read_text(encoding="utf-8")
    assert load(session.home)[0].data["imbalance"]["crank_balance_fraction"] == 0.4 and after.count(
        "\n"
    ) == before.count("\n")
    assert session.home.with_name("light.toml.bak").read_text(encoding="utf-8") == before
    await pilot.pause()
    assert "edited" not in screen_rows(pilot)[0]


@deed
async def new(pilot: Pilot[int], do: Do) -> None:
    await do()
    start = await over(pilot, Start)
    assert start.here is not None and start.here.kind == "own"
    await strike(pilot, "escape")
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))


@deed
async def save_as(pilot: Pilot[int], do: Do) -> None:
    session = await edited(pilot)
    old, new = session.home, session.home.with_name("other.toml")
    before = old.read_bytes()
    await do()
    await give(pilot, SaveDialog, new)
    await until(pilot, lambda: f"Saved: {new}" in told(pilot))
    assert load(new)[0].data["imbalance"]["crank_balance_fraction"] == 0.4 and old.read_bytes() == before
    await pilot.pause()
    assert session.home == new and " other.toml " in screen_rows(pilot)[0] and "edited" not in screen_rows(pilot)[0]


@deed
async def open_(pilot: Pilot[int], do: Do) -> None:
    home = work(pilot).session.home
    other = home.with_name("other.toml")
    other.write_text(home.read_text(encoding="utf-8").replace("bore_mm = 94.0", "bore_mm = 99.0"), encoding="utf-8")
    await do()
    await give(pilot, OpenDialog, other)
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench) and work(pilot).session.home == other)
    await still(pilot)
    assert " other.toml " in screen_rows(pilot)[0] and titles(pilot) == ["1 Engine"] and "[99       ] mm" in text(pilot)


@deed
async def reload(pilot: Pilot[int], do: Do) -> None:
    session = await edited(pilot)
    theirs = session.home.read_text(encoding="utf-8").replace(
        "crank_balance_fraction = 0.5", "crank_balance_fraction = 0.3"
    )
    session.home.write_text(theirs, encoding="utf-8")
    await do()
    await until(pilot, lambda: "light.toml is read anew. Undo returns to your edits." in told(pilot))
    await still(pilot)
    assert session.value(SHARE) == 0.3 and "[0.3      ]" in text(pilot) and "edited" not in screen_rows(pilot)[0]


@deed
async def record(pilot: Pilot[int], do: Do) -> None:
    session = work(pilot).session
    await do()
    await pilot.pause()
    assert "● rec" in screen_rows(pilot)[0] and "Every edit is recorded" in told(pilot)
    await edited(pilot)
    await do()
    path = session.home.with_name("replay.toml")
    await give(pilot, RecordDialog, path)
    await until(pilot, lambda: f"Replay: {path}" in told(pilot))
    assert f'set = "{SHARE}"' in path.read_text(encoding="utf-8") and session.recording is None
    await pilot.pause()
    assert "rec" not in screen_rows(pilot)[0]


@deed
async def compare(pilot: Pilot[int], do: Do) -> None:
    await edited(pilot)
    await do()
    await over(pilot, CompareWith)
    assert "light.toml as it is saved" in text(pilot) and "another design file" in text(pilot)
    await strike(pilot, "enter")
    await over(pilot, CompareScreen)
    await until(pilot, lambda: "Conclusion" in text(pilot))
    await strike(pilot, "right")  # the inputs, which on a narrow screen stand below
    await until(pilot, lambda: re.search(r"Share balanced on the crank.* 0\.5 +0\.4", text(pilot)) is not None)
    assert "1 input" in text(pilot)
    await back(pilot)
