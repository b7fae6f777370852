"""The lines of docs/loads.md that make cards for solvers from the table."""

import csv
import math
import re

import numpy as np
import pytest

from calc.design.toml_file import load_design
from calc.exchange.loads import loads
from calc.exchange.loads_text import csv_text
from calc.sheet.record import replace
from calc.solve import solve
from tests.calc.exchange.loads_table import read
from tests.conftest import GAMMA, ROOT


def test_the_cards_have_the_forces_of_the_table(tmp_path, monkeypatch):
    design = replace(load_design(GAMMA), gears=None, bearings=None, friction=None)
    text = csv_text(loads(solve(design), (2600 / 60,)), "gamma", "")
    (tmp_path / "loads.csv").write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    (code,) = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "loads.md").read_text(encoding="utf-8"), re.S)
    exec(compile(code, "loads.md", "exec"), {})
    nodes = {"origin": 1000, "front": 1001, "rear": 1002}
    wanted = {
        (row.order, nodes[row.place], dof): amount * (1e3 if dof > 3 else 1)
        for row in read(text)
        if row.on == "block" and row.order
        for dof, amount in enumerate((*row.force, *row.moment), 1)
    }
    assert of_nastran((tmp_path / "loads.bdf").read_text()) == about(wanted)
    assert of_calculix((tmp_path / "loads.inp").read_text()) == about(wanted)


def about(wanted):
    return {key: pytest.approx(amount, rel=1e-7, abs=1e-6) for key, amount in wanted.items()}


def of_nastran(text):
    """By order, node and component: amplitude times e^(i·phase), as RLOAD1 takes DAREA and DPHASE."""
    cards = list(csv.reader(text.splitlines()))
    orders = {card[1]: float(card[2]) * 60 / 2600 for card in cards if card[0] == "FREQ*"}
    assert {card[1] for card in cards if card[0] == "RLOAD1" and card[1] == card[2] == card[4]} == set(orders)
    phases = {tuple(card[1:4]): float(card[4]) for card in cards if card[0] == "DPHASE*"}
    assert all(len(cell) <= 16 for card in cards for cell in card)
    return {
        (round(orders[card[1]], 6), int(card[2]), int(card[3])): float(card[4])
        * np.exp(1j * math.radians(phases[tuple(card[1:4])]))
        for card in cards
        if card[0] == "DAREA*"
    }


def of_calculix(text):
    """The same from the real and the imaginary loads of each step."""
    found = {}
    for step in text.split("*STEP")[1:]:
        frequency = float(step.splitlines()[2].split(",")[0])
        assert "OP=NEW, LOAD CASE=1" in step and "*STEADY STATE DYNAMICS" in step
        for unit, part in zip((1, 1j), re.findall(r"LOAD CASE=\d\n(.*?)\n\*", step, re.S)):
            for line in part.splitlines():
                node, dof, amount = line.split(",")
                key = round(frequency * 60 / 2600, 6), int(node), int(dof)
                found[key] = found.get(key, 0) + unit * float(amount)
    return found
