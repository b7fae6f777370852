# SPDX-License-Identifier: Apache-2.0
"""Chains and toothed belts between two axes of the train: what they are to its speeds, its phase and its smoothness.

Its inside turns both sprockets in one sense; a sprocket on its outside turns against the other.  Its pull stands on the
bearings of the shafts (countershaft/supports.py); its strength and its noise are not computed."""

from collections.abc import Iterator, Mapping

from ..engine.inputs import EngineInputs
from ..sheet.check import Check, CheckRule
from ..sheet.formula import formula
from ..sheet.functions import pi, sin
from ..sheet.quantity import dotted, result, value
from ..sheet.shown import Shown
from ..sheet.text import Amount, Text
from ..sheet.units import Metre, Newton, NewtonMetre, Number, Radian, RevPerSecond
from ..sheet.value import about
from .inputs import GearsInputs, Stage
from .tree import Tree

KINDS = {"chain": Text("chain"), "belt": Text("belt")}
TEETH = 19  # rule of thumb of the makers of chains


@result
class StageResult(Shown):
    """One chain or belt; what is None is not known, or is nothing that a belt has."""

    pitch_diameter_driver: Metre = value("Pitch diameter of the driving sprocket", "mm", "d_1")
    pitch_diameter_driven: Metre = value("Pitch diameter of the driven sprocket", "mm", "d_2")
    phase_error: Radian | None = value("Lag of the driven sprocket by elongation", "°", "Δφ_K", default=None)
    polygon_ripple: Number | None = value("Ripple of the speed by the polygon of the links", "%", "δ_K", default=None)
    polygon_order: Number | None = value("Order of that ripple, by turns of the first driver", "", "i_K", default=None)
    least_strand_force: Newton | None = value(
        "Least force in the pulling strand, beside the tensioner's", "N", "F_min", default=None
    )
    driver: str
    driven: str


@formula("n", "kinematics: ratio of the teeth; s = −1 where the outside of the chain turns the sprocket", unit="rpm")
def speed_behind_stage(n_1: RevPerSecond, z_1: Number, z_2: Number, s: Number) -> RevPerSecond:
    return s * n_1 * z_1 / z_2


@formula("d", "geometry: the pins of a chain stand at the corners of a polygon of as many sides as teeth", unit="mm")
def chain_pitch_diameter(p: Metre, z: Number) -> Metre:
    """>>> chain_pitch_diameter(p=9.525e-3, z=19)
    0.057869...
    """
    return p / sin(pi / z)


@formula("d", "geometry: the cords of a toothed belt lie on a circle of as many pitches as teeth", unit="mm")
def belt_pitch_diameter(p: Metre, z: Number) -> Metre:
    return p * z / pi


@formula("Δφ_K", "geometry: the longer strand lets the driven sprocket stay behind", names={"epsilon": "ε"})
def lag_by_elongation(epsilon: Number, L: Metre, d: Metre) -> Radian:
    """`L`: of the strand that pulls; `d`: pitch diameter of the driven sprocket.

    >>> lag_by_elongation(epsilon=0.003, L=0.4, d=0.06)
    0.0400...
    """
    return epsilon * L / (d / 2)


@formula(
    "δ_K",
    "kinematics of the polygon: a link lies at d/2 or at d/2·cos(π/z) from the axis; the swing over the mean, to the "
    "second order in π/z",
    unit="%",
)
def polygon_ripple(z: Number) -> Number:
    """>>> polygon_ripple(z=19)
    0.013669...
    """
    return (pi / z) ** 2 / 2


@formula("i_K", "kinematics: links that run onto a sprocket in a turn of the first driver", names={"i": "i_1"})
def polygon_order(z: Number, i: Number) -> Number:
    """`i`: turns of that sprocket."""
    return z * i


@formula("F_min", "statics: least force in the strand that pulls, beside what the tensioner gives both", unit="N")
def least_strand_force(T_min: NewtonMetre, d: Metre) -> Newton:
    """Below 0 the other strand takes the load."""
    return T_min / (d / 2)


def stages(gears: GearsInputs, tree: Tree) -> dict[str, StageResult]:
    """Every chain and belt of a train, by its name."""
    results = {}
    for stage in gears.stages:
        with about(Text("stage {name}", name=stage.name)):
            results[stage.name] = _stage(stage, tree.turns(stage.driver))
    return results


def _stage(stage: Stage, turns: Number) -> StageResult:
    diameter = chain_pitch_diameter if stage.kind == "chain" else belt_pitch_diameter
    d_1, d_2 = diameter(p=stage.pitch, z=stage.driver_teeth), diameter(p=stage.pitch, z=stage.driven_teeth)
    lag = ripple = order = None
    if stage.span is not None:
        lag = lag_by_elongation(epsilon=stage.elongation, L=stage.span, d=d_2)
    if stage.kind == "chain":
        ripple = polygon_ripple(z=min(stage.driver_teeth, stage.driven_teeth))
        order = polygon_order(z=stage.driver_teeth, i=turns)
    return StageResult(
        pitch_diameter_driver=d_1,
        pitch_diameter_driven=d_2,
        phase_error=lag,
        polygon_ripple=ripple,
        polygon_order=order,
        driver=stage.driver,
        driven=stage.driven,
    )


# --- what is judged, and what is not known

SPROCKET_TEETH = CheckRule(
    "gears.N.sprocket_teeth",
    "advice",
    "Few teeth make a coarse polygon: the chain runs unevenly and wears.",
    source=Text("rule of thumb, makers of chains: 19 teeth and more"),
    moved_by=(
        dotted("gears", GearsInputs.stages, "N", Stage.driver_teeth),
        dotted("gears", GearsInputs.stages, "N", Stage.driven_teeth),
    ),
)
SLACK = CheckRule(
    "gears.N.slack",
    "advice",
    "The slack strand takes the load, and the shaft leaves its phase.",
    sense="<=",
    unit="N",
    source=Text("statics: where the torque reverses, the tensioner alone holds the strand that pulls then"),
    moved_by=(
        dotted("gears", GearsInputs.stages, "N", Stage.tensioner),
        dotted("engine", EngineInputs.flywheel_inertia),
    ),
)


def checks(gears: GearsInputs) -> Iterator[Check]:
    for stage in gears.stages:
        if stage.kind == "chain":
            name = Text("Teeth of the smaller sprocket, {name}", name=stage.name)
            yield SPROCKET_TEETH(min(stage.driver_teeth, stage.driven_teeth), TEETH, at=stage.name, name=name)


def slack_checks(gears: GearsInputs, least: Mapping[str, Newton]) -> Iterator[Check]:
    """`least`: least force in the strand that pulls, by stage, of all speeds and loads that are known."""
    for stage in gears.stages:
        if stage.name in least and stage.tensioner is not None:
            name = Text("Force in the slack strand where the torque reverses, {name}", name=stage.name)
            yield SLACK(max(-least[stage.name], 0.0), stage.tensioner, at=stage.name, name=name)


def slack_notes(gears: GearsInputs, least: Mapping[str, Newton]) -> Iterator[Text]:
    """What of a chain or belt whose torque reverses is not judged; `least` as in `slack_checks`."""
    for stage in gears.stages:
        if stage.tensioner is None and least.get(stage.name, 0.0) < 0:
            yield Text(
                "The torque of {name} reverses: its slack strand takes up to {F}, and what its tensioner holds is not "
                "known; give gears.stages.{name}.tensioner_N.",
                name=stage.name,
                F=Amount(-least[stage.name], "N", digits=3),
            )


def notes(gears: GearsInputs) -> Iterator[Text]:
    for stage in gears.stages:
        yield Text(
            "{name} is a {kind}: its strength and its noise are not computed, nor what it pulls at wheels between.",
            name=stage.name,
            kind=KINDS[stage.kind],
        )
        if stage.tensioner is None:
            yield Text(
                "The pull of {name} is that of its power alone: give gears.stages.{name}.tensioner_N.", name=stage.name
            )
        if stage.span is None:
            yield Text(
                "What its elongation leaves of the phase behind {name} is not known: give gears.stages.{name}.span_mm.",
                name=stage.name,
            )
