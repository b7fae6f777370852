# SPDX-License-Identifier: Apache-2.0
"""The checks of what is felt: the day of a driver, comfort at the seat, severity at the machine."""

import math
from collections.abc import Iterator

from ..engine.inputs import EngineInputs
from ..sheet.check import Check, check
from ..sheet.text import Name, Text
from .inputs import MountingInputs
from .result import MountingResult
from .standards import scope, zone_limit
from .tables import table

DIRECTIVE = Text("Directive 2002/44/EC; the engine's share only, travel over ground comes on top")
COMFORT = Text("ISO 2631-1, annex C: not uncomfortable")


def exposure_checks(result: MountingResult) -> Iterator[Check]:
    day = (result.exposure or {}).get(result.own, {})
    limits = table()["exposure"]
    for id, words in (("whole_body", Text("Daily exposure of the whole body")), ("hand_arm", Text("Daily exposure of hand and arm"))):
        if result.exposure is None or (id not in day and not _asked(result, id)):
            continue
        a = day[id].number if id in day else math.nan
        value_id = f"mounting.exposure.{result.own}.{id}"
        yield check(f"mounting.exposure.{id}", words, a, "<=", limits[f"{id}_limit"], "m/s²", DIRECTIVE, value_id=value_id)
        yield check(
            f"mounting.exposure.{id}_action",
            Text("{words}, action value", words=words),
            a,
            "<=",
            limits[f"{id}_action"],
            "m/s²",
            DIRECTIVE,
            value_id=value_id,
        )


def _asked(result: MountingResult, id: str) -> bool:
    role = "seat" if id == "whole_body" else "hand"
    return any(point.role == role for point in result.system.mounting.points)


def severity_checks(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Check]:
    judged = scope(mounting.application, mounting.power or engine.rated_power, engine.rated_speed, mounting.machine_class)
    machine = [point.name for point in mounting.points if point.on == "engine" and point.role == "machine"]
    for name in result.speeds:
        for point in machine:
            words = Text("Severity at {point}, {name}", point=Name(point), name=Name(name))
            place = f"{name}.{result.own}.{point}"
            if judged.iso_10816 and mounting.machine_class is not None:
                grade = result.leaf(f"{place}.grade")
                yield check(
                    f"mounting.{name}.{point}.severity",
                    words,
                    math.nan if grade is None else grade,
                    "<=",
                    zone_limit(mounting.machine_class),
                    "",
                    Text("ISO 10816-6:1995, zone A/B of the class (from memory)"),
                    value_id=f"mounting.{place}.grade",
                )
            elif judged.iso_8528:
                t = table()["generating_set"]
                sizes = [
                    (result.leaf(f"{place}.{kind}"), limit)
                    for kind, limit in (
                        ("displacement", t["displacement_mm"] * 1e-3),
                        ("velocity", t["velocity_mm_s"] * 1e-3),
                        ("acceleration", t["acceleration_m_s2"]),
                    )
                ]
                worst = max((x / limit for x, limit in sizes if x is not None), default=math.nan)
                yield check(
                    f"mounting.{name}.{point}.severity",
                    words,
                    worst if all(x is not None for x, _ in sizes) else math.nan,
                    "<=",
                    1.0,
                    "",
                    Text("ISO 8528-9:1995 as reprinted by Lloyd's Register: the largest of three over its limit"),
                    value_id="",
                )


def comfort_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    seats = [point.name for point in mounting.points if point.role == "seat"]
    limit = next(row["above_m_s2"] for row in table()["comfort"] if row["above_m_s2"])
    for name in result.speeds if seats else ():
        levels = [(result.leaf(f"{name}.{result.own}.{seat}.weighted"), seat) for seat in seats]
        a, seat = max(((math.nan if a is None else a, seat) for a, seat in levels), key=lambda row: (row[0] != row[0], row[0]))
        yield check(
            f"mounting.{name}.comfort",
            Text("Weighted acceleration at {seat}, {name}", seat=Name(seat), name=Name(name)),
            a,
            "<=",
            limit,
            "m/s²",
            COMFORT,
            value_id=f"mounting.{name}.{result.own}.{seat}.weighted",
        )
