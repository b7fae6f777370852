# SPDX-License-Identifier: Apache-2.0
"""Random designs: none passes of which something impossible can be computed from its own numbers.

What is impossible is computed here once more, from values and inputs alone, with no look at any check."""

import math
import random
from collections.abc import Iterator
from functools import cache

import pytest

from calc.design.model import Design
from calc.design.toml_file import Document, design, parse, read
from calc.sheet.errors import BadInput, NoSolution
from calc.sheet.quantity import given
from calc.sheet.value import recorded
from calc.solve import Results, solve
from calc.studies.shipped import DESIGNS, engine_design, engines
from tests.conftest import FEW

NUMBERS = ("number", "integer", "series")
CHUNK = 50


# --- what can not be


def impossible(results: Results) -> Iterator[tuple[str, str]]:
    """The step and what can not be in it, all of it from its numbers as they are shown."""
    values = {id: value.shown for id, value in results.values().items()}
    for id, x in values.items():
        if not math.isfinite(x):
            yield id.partition(".")[0], f"{id} is {x}"
    yield from _engine(results.design, values)
    yield from _shaft(results.design, values)
    yield from _bearings(results.design, values)
    yield from _gears(results.design, values)
    yield from _friction(values)


def _engine(asked: Design, values: dict[str, float]) -> Iterator[tuple[str, str]]:
    engine = asked.engine
    if engine is None:
        return
    brake, indicated = values.get("engine.brake_mean_pressure"), values.get("engine.indicated_mean_pressure")
    if brake is not None and indicated is not None and brake > indicated:
        yield "engine", f"the crank gives {brake} bar, its gas {indicated}"
    if engine.throw is not None:
        strength = asked.materials[engine.throw.material].tensile_strength
        stresses = [x for id, x in values.items() if id.startswith("engine.throw.") and id.endswith(".von_mises")]
        if strength is not None and stresses and max(stresses) > strength * 1e-6:
            yield "engine", f"the throw breaks: {max(stresses)} MPa"


def _shaft(asked: Design, values: dict[str, float]) -> Iterator[tuple[str, str]]:
    shaft, bearings = asked.countershaft, asked.bearings
    if shaft is None:
        return
    strength, stress = asked.materials[shaft.material].tensile_strength, values.get("countershaft.bending_stress")
    if strength is not None and stress is not None and stress > strength * 1e-6:
        yield "countershaft", f"the shaft breaks: {stress} MPa"
    for mass in shaft.masses if shaft.outer_radius is not None else ():
        if mass.radius > shaft.outer_radius:
            yield "countershaft", f"the mass {mass.name} lies outside its envelope"
    for id in ("countershaft.mass", "countershaft.moment_of_inertia"):
        if values.get(id, 1.0) <= 0:
            yield "countershaft", f"{id} is {values[id]}"
    if bearings is not None and (shaft.sections or shaft.core_radius is not None) and "countershaft.mass" not in values:
        yield "countershaft", "no shaft can be made of what is given"
    if values.get("countershaft.utilisation", 0.0) > 1 + 1e-9:
        yield "countershaft", "more unbalance than a full half circle has"
    if bearings is not None and "countershaft.sector.front.length" in values:
        lengths = values["countershaft.sector.front.length"], values.get("countershaft.sector.rear.length", 0.0)
        for side, z, bearing in zip(lengths, shaft.bearing_positions, shaft.bearings):
            if side > (abs(z) - bearing.on_shaft[1] / 2) * 1e3 + 1e-6:
                yield "countershaft", f"a sector of {side} mm reaches into the journal at {z * 1e3} mm"


def _bearings(asked: Design, values: dict[str, float]) -> Iterator[tuple[str, str]]:
    if asked.bearings is None:
        return
    for bearing in asked.rows:
        place = bearing.name
        mine = {id.removeprefix(f"bearings.{place}."): x for id, x in values.items() if f"bearings.{place}." in id}
        if bearing.kind == "rolling":
            yield from _rolling(asked, place, mine)
            continue
        for key in ("film", "film_edge", "clearance", "clearance_hot", "clearance_cold", "oil_flow", "friction_power"):
            if mine.get(key, 1.0) <= 0:
                yield "bearings", f"{place}: {key} is {mine[key]}"
        if not 0 <= mine.get("eccentricity", 0.0) < 1:
            yield "bearings", f"{place}: the journal stands outside its bearing"
        roughness = (bearing.journal_roughness + bearing.housing_roughness) * 1e6
        if mine.get("film_edge", math.inf) < roughness:
            yield "bearings", f"{place}: a film of {mine['film_edge']} µm between faces of {roughness} µm"
        if mine.get("film", 0.0) > mine.get("clearance_hot", math.inf) / 2 + 1e-9:
            yield "bearings", f"{place}: the film is thicker than the room for it"
        limit = asked.bearings.outlet_temperature_limit
        if limit is not None and mine.get("outlet_temperature", -math.inf) > limit + 1e-6:
            yield "bearings", f"{place}: the oil leaves at {mine['outlet_temperature']} °C, above its limit"
        if mine.get("temperature_rise", 1.0) < 0:
            yield "bearings", f"{place}: friction cools the oil"


def _rolling(asked: Design, place: str, mine: dict[str, float]) -> Iterator[tuple[str, str]]:
    for key in ("friction_power", "static_rating", "stiffness", "bearing_mass", "minimum_load"):
        if mine.get(key, 1.0) <= 0:
            yield "bearings", f"{place}: {key} is {mine[key]}"
    for key in ("clearance_least", "clearance_start"):
        if mine.get(key, 0.0) < -1e-9:
            yield "bearings", f"{place}: its elements jam, {key} is {mine[key]} µm"
    if mine.get("static_safety", 1.0) < 1:
        yield "bearings", f"{place}: a shock marks its raceways"
    assert asked.bearings is not None
    if asked.bearings.life is not None and mine.get("life", math.inf) < asked.bearings.life / 3600 - 1e-6:
        yield "bearings", f"{place}: it lives {mine['life']} h"
    if mine.get("running_temperature", math.inf) < asked.bearings.supply_temperature - 1e-9:
        yield "bearings", f"{place}: friction cools it"


def _gears(asked: Design, values: dict[str, float]) -> Iterator[tuple[str, str]]:
    if asked.gears is None:
        return
    for wheel in asked.gears.wheels:
        mine = {id.removeprefix(f"gears.{wheel.name}."): x for id, x in values.items() if f"gears.{wheel.name}." in id}
        if mine.get("tip_thickness_normal_min", mine.get("tip_thickness_normal", 1.0)) <= 0:
            yield "gears", f"{wheel.name}: its teeth are pointed below their tips"
        if wheel.bore_diameter is not None and wheel.bore_diameter * 1e3 >= mine.get("root_diameter", math.inf):
            yield "gears", f"{wheel.name}: its bore cuts its teeth off"
    for mesh in asked.gears.meshes:
        name = f"{mesh.driver}_{mesh.driven}"
        mine = {id.removeprefix(f"gears.{name}."): x for id, x in values.items() if f"gears.{name}." in id}
        for key in ("backlash_min", "backlash_cold", "backlash_warmer", "backlash_warming", "backlash_running"):
            if mine.get(key, 1.0) < 0:
                yield "gears", f"{name}: {key} is {mine[key]} µm"
        for key in ("tip_clearance_driver", "tip_clearance_driven", "tip_clearance_min"):
            if mine.get(key, 1.0) < 0:
                yield "gears", f"{name}: a tip runs into a root, {key} is {mine[key]} mm"
        if mine.get("total_contact_ratio", 2.0) < 1:
            yield "gears", f"{name}: no tooth in contact at times"
        for key, x in mine.items():
            if key.startswith(("safety_bending_", "safety_contact_")) and x < 1:
                yield "gears", f"{name}: {key} is {x}"


def _friction(values: dict[str, float]) -> Iterator[tuple[str, str]]:
    mine = {id: x for id, x in values.items() if id.startswith("friction.") and ".source." not in id}
    for id, x in mine.items():
        key = id.rpartition(".")[2]
        if key == "efficiency" and not 0 <= x <= 1:
            yield "friction", f"{id} is {x}"
        if key in ("loss", "sliding_loss", "rolling_loss", "friction_power", "windage", "total_loss") and x < 0:
            yield "friction", f"{id} is {x} W"
    if values.get("friction.delivered_power", 0.0) < 0:
        yield "friction", "the train delivers less than nothing"


# --- random designs


Beginning = tuple[Document, Results]  # what is not edited is taken over


def solved(document: Document) -> Beginning:
    with recorded(False):
        return document, solve(design(document), compared=False)


@cache
def shipped() -> tuple[Beginning, ...]:
    return tuple([solved(read(path)) for path in FEW])


@cache
def begun() -> tuple[Beginning, ...]:
    """What `new` writes, for every engine for which it finds a train."""
    beginnings = []
    for name in engines():
        try:
            beginnings.append(solved(parse(engine_design(name).encode(), name)))
        except NoSolution:
            continue
    return tuple(beginnings)


def edited(document: Document, chance: random.Random) -> tuple[Document, dict[str, object]]:
    """With one to three of its numbers changed: mostly by a little, at times by a digit or to nothing."""
    asked = design(document)
    numbers = [
        (key, about, content)
        for step in asked.asked()
        for key, about, content in given(getattr(asked, step.key), step.key)
        if about.kind in NUMBERS and content not in ((), None)
    ]
    edits: dict[str, object] = {}
    for key, about, content in chance.sample(numbers, min(len(numbers), chance.randint(1, 3))):
        factor = math.exp(chance.gauss(0, 0.4)) if chance.random() < 0.8 else chance.choice((10.0, 0.1, 2.0, 0.5, 0.0))
        series = [about.units.shown(x) * factor for x in content] if isinstance(content, tuple) else None
        new: object = series if series is not None else about.units.shown(content) * factor
        edits[key] = round(new) if about.kind == "integer" and isinstance(new, float) else new
        document = document.with_value(key, edits[key])
    return document, edits


def holes(beginnings: tuple[Beginning, ...], seed: int) -> tuple[int, list[str]]:
    """How many of a chunk of random designs can not be, and of these what passes all the same."""
    chance, found, wrong = random.Random(seed), 0, []
    for _ in range(CHUNK):
        document, before = chance.choice(beginnings)
        try:
            document, edits = edited(document, chance)
            asked = design(document)
        except BadInput:
            continue
        with recorded(False):
            results = solve(asked, before, compared=False)
        reasons = list(impossible(results))
        found += bool(reasons)
        for step, what in reasons:
            if results.verdict == "pass" or results.outcomes[step].verdict in ("pass", "computed"):
                wrong.append(f"{asked.name} with {edits}: {step} passes, and {what}")
    return found, wrong


@pytest.mark.parametrize("seed", [pytest.param(seed, marks=pytest.mark.slow if seed else ()) for seed in range(6)])
def test_no_random_design_passes_that_can_not_be(seed: int) -> None:
    found, wrong = holes(shipped(), seed)
    assert found and not wrong, "\n".join(wrong)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(100, 300))
def test_no_random_design_that_new_begins_passes_that_can_not_be(seed: int) -> None:
    found, wrong = holes((*begun(), *shipped()), seed)
    assert found and not wrong, "\n".join(wrong)


# --- the oracle itself sees what it is there for


HOLE = {"name": "hole", "mass_kg": -1.0, "radius_mm": 1.0, "angle_deg": 0.0, "z_mm": 0.0}


@pytest.mark.parametrize(
    ("name", "changes", "step"),
    [
        ("twin_drive", {"gears.wheels.crank.span_allowance_um": [90, 80]}, "gears"),
        ("twin_drive", {"gears.meshes.0.tolerance_um": 200.0}, "gears"),
        ("twin_drive", {"gears.wheels.central.bore_diameter_mm": 80.0}, "gears"),
        ("twin_drive", {"bearings.slope_mrad": 1.5}, "bearings"),
        ("twin_drive", {"bearings.front.housing_roughness_um": 40.0}, "bearings"),
        ("twin_drive", {"bearings.outlet_temperature_limit_C": 92.0}, "bearings"),
        ("r753ie4_gamma", {"countershaft.masses.front.radius_mm": 41.0}, "countershaft"),
        ("twin_drive", {"countershaft.extras": [HOLE | {"mass_kg": -9.0}]}, "countershaft"),
        ("twin_drive", {"countershaft.extras": [HOLE | {"radius_mm": 90.0}]}, "countershaft"),
        ("generating_set_mounting", {"engine.rated_power_kW": 160.0}, "engine"),
        ("twin_force_shaft", {"engine.throw.pin_diameter_mm": 12.0}, "engine"),
    ],
)
def test_the_oracle_sees_it(name: str, changes: dict[str, object], step: str) -> None:
    document = read(DESIGNS / f"{name}.toml")
    for key, value in changes.items():
        document = document.with_value(key, value)
    with recorded(False):
        results = solve(design(document), compared=False)
    assert step in {where for where, _ in impossible(results)}
    assert results.outcomes[step].verdict not in ("pass", "computed") and results.verdict != "pass"
