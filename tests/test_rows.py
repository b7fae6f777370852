"""What stands for a bearing is a row of its shaft: nothing is made twice, once for a front one and once for a rear one."""

import re

from tests.conftest import ROOT

TWICE = re.compile(r"\b\w*_(?:front|rear)\b")
# planes of balancing, as ISO 21940-11 has two of them whatever carries the shaft
PLANES = {"lever", "permitted", "residual_unbalance_permitted", "ring", "target"}
# what no bearing is: the bolts at both ends of a support, throws of a crank ahead of another, who looks from the front,
# the two sides from which a shaft comes in
OTHERS = {"force", "in", "insertion_room", "torque_in", "rotation_seen_from", "z"}
# a front of Pareto
OF_PARETO = {"class", "_exact", "drive", ""}


def test_no_name_stands_for_one_bearing_of_a_shaft():
    found = {
        f"{path.relative_to(ROOT)}: {name}"
        for room in ("calc", "assistant", "reports")
        for path in sorted((ROOT / room).rglob("*.py"))
        for name in TWICE.findall(path.read_text(encoding="utf-8"))
        if name.rpartition("_")[0] not in PLANES | OTHERS | OF_PARETO
    }
    assert found == set()
