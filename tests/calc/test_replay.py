"""Replay files: what they may say, and what is refused."""

import pytest

from calc import replay
from calc.sheet.errors import BadInput

from ..conftest import GAMMA, ROOT

HEAD = f'schema = 1\ndesign = "{GAMMA}"\n'
EXPECT = '[[expect]]\nvalue = "engine.lambda"\nis = 0.3282\nunit = ""\nabs = 1e-4\nkind = "recorded"\n'


def written(tmp_path, text):
    path = tmp_path / "r.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_edits_undo_and_moments(tmp_path):
    text = HEAD + '[[step]]\nset = "engine.rod_length_mm"\nto = 200.0\n[[step]]\nundo = true\n' + EXPECT
    text += EXPECT.replace("0.3282", "0.2675") + "after = 1\n"
    compared = replay.run(replay.load(written(tmp_path, text)))
    assert [c.agrees for c in compared] == [True, True]


@pytest.mark.parametrize("bad", [
    EXPECT.replace("abs = 1e-4", 'rel = "x"\nabs = 1'), EXPECT.replace("0.3282", "1" + "0" * 400), EXPECT + 'after = "x"\n',
    EXPECT + "after = 0.5\n", EXPECT + "after = 7\n", EXPECT.replace("abs = 1e-4", "rel = inf"), EXPECT.replace('"engine.lambda"', '["a"]'),
    EXPECT.replace('kind = "recorded"', 'kind = "reference"'), EXPECT.replace('unit = ""', 'units = ""'),
    '[[step]]\nset = 5\nto = 1\n' + EXPECT, "[[step]]\nreport = 5\n" + EXPECT, "[[step]]\nundo = false\n" + EXPECT, '[[step]]\nset = "a"\n' + EXPECT,
    '[[expect]]\ncheck = "x"\nverdict = "bogus"\n', "", "expect = 3\n", "surprise = 1\n" + EXPECT,
])  # fmt: skip
def test_what_is_no_replay_is_refused(tmp_path, bad):
    with pytest.raises(BadInput):
        replay.load(written(tmp_path, HEAD + bad))


def test_an_edit_that_can_not_be_made_is_named_in_the_replay(tmp_path):
    path = written(tmp_path, HEAD + '[[step]]\nset = "engine.bore_mm"\nto = -1\n' + EXPECT)
    with pytest.raises(BadInput, match=r"r\.toml:3: engine\.bore_mm"):
        replay.run(replay.load(path))


def test_every_shipped_design_has_a_replay():
    assert {p.stem for p in (ROOT / "tests" / "replays").glob("*.toml")} == {p.stem for p in (ROOT / "designs").glob("*.toml")}
