# SPDX-License-Identifier: Apache-2.0
"""The text of schema 1 in schema 2: what it says is what `upgraded` says, and no comment is lost."""

import random
import tomllib
from collections import Counter
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.design.upgrade import upgraded
from calc.design.upgrade_text import upgraded_text
from calc.sheet.errors import BadInput
from tests.conftest import ROOT

OLD, NEW = (ROOT / "tests" / "data" / name for name in ("designs_0_1", "upgraded"))
SHIPPED = sorted(path.name for path in OLD.glob("*.toml"))
WITH_SHAFT = [name for name in SHIPPED if b"[countershaft]" in (OLD / name).read_bytes()]


def text_of(path: Path) -> str:
    return path.read_bytes().decode("utf-8")


def comments(text: str) -> Counter[str]:
    """By what stands behind a # in each line; no string of these texts has one."""
    return Counter(
        line[line.index("#") :].strip("# \r") for line in text.splitlines() if line.strip("# \r") and "#" in line
    )


@pytest.mark.parametrize("name", SHIPPED)
def test_a_shipped_text_is_upgraded_to_the_byte(name: str) -> None:
    made = upgraded_text(text_of(OLD / name))
    assert made.text == text_of(NEW / name)
    assert made.kept and not made.lost


@pytest.mark.parametrize("name", SHIPPED)
def test_upgraded_once_it_stays(name: str) -> None:
    text = text_of(NEW / name)
    assert upgraded_text(text).text == text


@pytest.mark.parametrize("name", WITH_SHAFT)
def test_mark_line_ends_and_the_end_of_the_last_line_stay(name: str) -> None:
    old, new = text_of(OLD / name), text_of(NEW / name)
    for before, after in (
        ("\ufeff" + old, "\ufeff" + new),
        (old.replace("\n", "\r\n"), new.replace("\n", "\r\n")),
        (old.removesuffix("\n"), new.removesuffix("\n")),
        (old + "\n\n# the end\n", None),
    ):
        made = upgraded_text(before)
        assert made.kept and not made.lost
        assert after is None or made.text == after
        assert made.text.endswith("\n") == before.endswith("\n")


# --- of any notation

LINES = ["# {}", "", '# {} [x] = "y"', "   # {}"]


def blocks_of(text: str) -> tuple[list[str], list[list[str]]]:
    """The lines before the first head, and those of each table, the comments above its head with it."""
    root: list[str] = []
    blocks: list[list[str]] = []
    above: list[str] = []
    for line in text.split("\n"):
        if line.startswith("["):
            blocks.append([*above, line])
            above = []
        elif not line.strip() or line.startswith("#"):
            above.append(line)
        else:
            (blocks[-1] if blocks else root).extend([*above, line])
            above = []
    blocks[-1].extend(above)
    return root, blocks


def with_comments(lines: list[str], chance: random.Random) -> list[str]:
    made, n = [], 0
    for line in lines:
        if chance.random() < 0.2:
            n += 1
            made.append(chance.choice(LINES).format(f"remark {n}"))
        plain = "#" not in line and not line.endswith('"""')
        made.append(f"{line}  # beside {len(made)}" if plain and line.strip() and chance.random() < 0.2 else line)
    return made


def parents_first(blocks: list[list[str]]) -> bool:
    """Whether [countershaft] stands before its own tables."""
    heads = [line for block in blocks for line in block if line.lstrip("[").startswith("countershaft")]
    return heads[0].startswith("[countershaft]")


@pytest.mark.slow
@given(st.sampled_from(WITH_SHAFT), st.randoms(use_true_random=False), st.booleans())
def test_tables_in_any_order_and_comments_everywhere(name: str, chance: random.Random, shuffled: bool) -> None:
    root, blocks = blocks_of(text_of(OLD / name))
    if shuffled:
        chance.shuffle(blocks)
    blocks = [with_comments(block, chance) for block in blocks]
    text = "\n".join([*root, *(line for block in blocks for line in block)]) + "\n"
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return  # a table of an element, before it
    wanted = upgraded(data, {})
    assert not wanted.errors
    made = upgraded_text(text)
    assert tomllib.loads(made.text) == wanted.data
    assert made.kept == parents_first(blocks)
    assert not comments(text) - comments(made.text) - Counter(made.lost)
    assert not (made.kept and made.lost)
    assert upgraded_text(made.text).text == made.text


NOTATIONS = [
    # inline, dotted, quoted, in another order
    'schema = 1\ncountershaft = { material = "steel", bearing_positions_mm = [-1, 1] } # all\n',
    'schema = 1\ncountershaft.material = "steel"\ncountershaft.bearing_positions_mm = [-1, 1] # places\n',
    'schema = 1\n[countershaft.bolts]\ncount = 2\n[countershaft]\nbearing_positions_mm = [-1, 1]\n',
    'schema = 1\n[countershaft]\nbearing_positions_mm = [-1, 1]\n[bearings]\nfront = { length_mm = 1 }\nrear = { length_mm = 2 }\n',
    'schema = 1\n[countershaft]\nbearing_positions_mm = [-1, 1]\n[bearings]\nfront.length_mm = 1\nrear.length_mm = 2\n',
    'schema = 1\n[bearings]\n[bearings.front]\n[bearings.rear]\n[gears]\nwheels = [{ name = "a" }]\nmeshes = [{ driven = "a" }]\n',
    'schema = 1\n[bearings.front]\n[bearings.rear]\n',
    'schema = 1\nlocked = { "countershaft.pair" = "x", "bearings.front.length_mm" = "y" }\n',
    'schema = 1\n[measured]\nvalue = "bearings.front.length_mm"\n',
    'schema = 1\nx = """a\u2028b\n# no comment\n"""\ncountershaft.bearing_positions_mm = [1, 2]\n',
]  # fmt: skip


@pytest.mark.parametrize("text", NOTATIONS)
def test_what_can_not_be_edited_is_written_afresh(text: str) -> None:
    made = upgraded_text(text)
    assert tomllib.loads(made.text) == upgraded(tomllib.loads(text), {}).data
    assert made.kept == (text == NOTATIONS[8])
    assert not made.lost or "#" in text


KEPT = [
    (
        'schema = 1 # one\n[ "countershaft" ] # shaft\n# which\nmaterial = "steel"\n# where\n  # exactly\n'
        "bearing_positions_mm = [ # mm\n  -1.0, # front\n  +1_0.0,\n] # from mid-shaft\n\n[countershaft . bolts]\ncount = 2",
        'schema = 2 # one\n[[shafts]] # shaft\nname = "shaft"\n# which\nmaterial = "steel"\nspeed_ratio = -1\n\n[shafts . bolts]\n'
        'count = 2\n\n[[shafts.bearings]]\nname = "front"\n# where\n  # exactly\n# mm\n# front\n'
        'position_mm = -1.0   # from mid-shaft\n\n[[shafts.bearings]]\nname = "rear"\nposition_mm = 10.0',
    ),
    (
        'schema = 1\n[bearings]\noil = "x"\n# both\nslope_mrad = 0.1 # given\n\n# the front one\n[bearings.front] # F\nload_N = 1\n'
        "[bearings.rear]\nload_N = 2\n# the end\n",
        'schema = 2\n[bearings]\noil = "x"\n\n[[shafts]]\nname = "shaft"\nmode = "bearings"\n\n# the front one\n[[shafts.bearings]] # F\n'
        'name = "front"\nload_N = 1\n# both\nslope_mrad = 0.1   # given\n\n[[shafts.bearings]]\nname = "rear"\nload_N = 2\n'
        "slope_mrad = 0.1   # given\n# the end\n",
    ),
    (
        "schema = 1\n[countershaft]\nspeed_ratio = 2\nbearing_positions_mm = [0, 1]\npair = 'no' # alone\n\n[[countershaft.journals]] # A\n"
        "diameter_mm = 5 # a\nlength_mm = 4\n\n[[countershaft.journals]]\nlength_mm = 3\ndiameter_mm = 5\n[gears]\n",
        'schema = 2\n[[shafts]]\nname = "shaft"\nspeed_ratio = 2\n# alone\n\n[[shafts.bearings]] # A\nname = "front"\nposition_mm = 0\n'
        'diameter_mm = 5 # a\nlength_mm = 4\n\n[[shafts.bearings]]\nname = "rear"\nposition_mm = 1\nlength_mm = 3\ndiameter_mm = 5\n[gears]\n',
    ),
    (
        "schema = 1\n[countershaft]\nspeed_ratio = -1\nbearing_positions_mm = [0, 1]\naxis_mm = [1.0, 2.0]\n# two\npair = 'yes'\n"
        '[locked]\n"countershaft.bearing_positions_mm" = "x" # both\n\'countershaft.speed_ratio\' = "y"\ncountershaft = "z"\n'
        '[optimise.vary]\n"bearings.front.length_mm" = [1]\n[accepted]\n"countershaft.force" = "w"\n'
        '[[measured]]\nvalue = "countershaft.speed_ratio" # m\n[[measured]]\nvalue = "countershaft.couple"\n',
        'schema = 2\n[[shafts]]\nname = "shaft"\nspeed_ratio = -1\naxis_mm = [1.0, 2.0]\n\n[[shafts.bearings]]\nname = "front"\nposition_mm = 0\n'
        '\n[[shafts.bearings]]\nname = "rear"\nposition_mm = 1\n\n[[shafts]]\nname = "twin"\n# two\nmirrors = "shaft"\naxis_mm = [1.0, -2.0]\n'
        '[locked]\n"shafts.shaft.bearings.front.position_mm" = "x" # both\n"shafts.shaft.bearings.rear.position_mm" = "x" # both\n'
        '"shafts.shaft.speed_ratio" = "y"\ncountershaft = "z"\n[optimise.vary]\n"shafts.shaft.bearings.front.length_mm" = [1]\n'
        '[accepted]\n"countershaft.force" = "w"\n'
        '[[measured]]\nvalue = "shafts.shaft.speed_ratio" # m\n[[measured]]\nvalue = "countershaft.couple"\n',
    ),
]  # fmt: skip


@pytest.mark.parametrize("before, after", KEPT)
def test_comments_go_where_their_values_go(before: str, after: str) -> None:
    made = upgraded_text(before)
    assert made.text == after
    assert made.kept and not made.lost


def test_what_is_lost_is_said() -> None:
    made = upgraded_text("schema = 1\n# above\ncountershaft.bearing_positions_mm = [0, 1] # beside\n")
    assert not made.kept and made.lost == ("above",)
    assert made.text.count("   # beside\n") == 1


@pytest.mark.parametrize(
    "text, reason",
    [
        ("schema = 3\n", "needs a newer program"),
        ("", "must be 1, or 2, which stays as it is"),
        ("schema = true\n", "must be 1, or 2, which stays as it is"),
        ("schema = 1\n[countershaft]\n", "is missing; needs a list of numbers from −5000 to 5000 mm"),
    ],
)
def test_what_is_no_design_of_schema_1_is_told(text: str, reason: str) -> None:
    with pytest.raises(BadInput) as error:
        upgraded_text(text, "x.toml")
    assert error.value.place == "x.toml" and str(error.value.errors[0].reason) == reason
