# SPDX-License-Identifier: Apache-2.0
"""A counter-shaft to begin with, for an engine whose first order turns backward: envelope, bearings, gear train, friction.

Every rule here is one of this program, and the written file names it beside its number: "assumed".  What can be computed is computed
by the parts that judge the design: the utilisation of the envelope by the sizing, the slopes of the journals by the bending.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

from .countershaft import formulas as f
from .countershaft.inputs import Holes, Journal
from .countershaft.making.holes import calibration
from .countershaft.result import CountershaftResult
from .countershaft.sizing import formulas as sizes
from .countershaft.sizing.sectors import Sized, size
from .design import Design
from .engine.result import EngineResult
from .gears import formulas as g
from .imbalance.result import ImbalanceResult
from .sheet.errors import NoSolution
from .sheet.linked_array import gathered
from .sheet.number import short
from .sheet.record import record
from .sheet.text import Amount, Text
from .sheet.trace import untraced
from .sheet.units import Metre, NewtonPerMetreSecond, Radian
from .solve import Results, solve

BACKWARD = ("imbalance.order_1.backward", "imbalance.order_1.backward_force")  # the advice that asks for a shaft at −1
SECOND_ORDER = {"imbalance.order_2.force": ("force", "N"), "imbalance.order_2.couple": ("couple", "N·m")}
STEEL = "42CrMo4"
UTILISATION = 0.75
CORES = (0.65, 0.70, 0.75, 0.80, 0.85, 0.90)  # of the outer radius
FILLET = 1.5e-3  # m
SLOPE = 0.2e-3  # rad: of the 0.25 mrad that are accepted
OVERDESIGN, DRILLED = 0.015, 0.03  # what the shaft is made stronger, and what the holes take: twice as much
HEAT_INDEX = 400e3 * 1000 / 60  # N/(m·s): of the 500 000 N·rpm/mm that are accepted
BEARING = 0.35, 0.75  # length over diameter: of the rear bearing at least, of both at most
THREADED = 0.2e-3
MODULES = (2.0, 1.75, 1.5, 1.25)  # mm
CRANK_TEETH, CENTRAL_TEETH, IDLER_TEETH = 25, 36, 39  # those of the R753IE4; as many on the shaft as on the crank
STARTER, GIVE = Text("a counter-shaft to begin with"), Text("give [countershaft]")
HELIX: Radian = math.radians(20)


@record
class _Shaft:
    """The envelope and its bearings: radii, diameters, and the length of both; the module in mm."""

    span: Metre
    outer: Metre
    core: Metre
    half_length: Metre
    rear: Metre
    front: Metre
    length: Metre
    heat_index: NewtonPerMetreSecond
    module: float
    sized: Sized


def begun(made: Design, body: str, read: Callable[[str], Design]) -> tuple[str, str]:
    """What is to be said of a counter-shaft for a design of engine and imbalance, and the tables to add: none where none is asked for.

    `body` is the design's text, `read` makes a design of such a text.
    """
    results = solve(made)
    checks = {c.id: c for c in results.outcomes["imbalance"].checks}
    asked = [checks[name] for name in BACKWARD if checks[name].verdict != "pass"]
    if not asked:
        return _none(results), ""
    vectors = " and ".join(f"a {'force' if c.unit == 'N' else 'couple'} of {short(c.value)} {c.unit}" for c in asked)
    turn = "turn" if len(asked) > 1 else "turns"
    said = f"The counter-shaft takes {vectors} of first order that {turn} backward. It is begun by rules of "
    return f"{said}this program; what is assumed is marked so.", _stiff_enough(made, results, body, read)


def _none(results: Results) -> str:
    """Why no shaft is written."""
    said = "No counter-shaft is written: nothing of first order turns backward, so none is needed at −1."
    imbalance = results.outcomes["imbalance"]
    left = [c for c in imbalance.checks if c.id in SECOND_ORDER and c.verdict != "pass"]
    if not left:
        return f"{said} Second order leaves nothing that counts either."
    from .imbalance.checks import shafts_words

    what = " and ".join(f"a {SECOND_ORDER[c.id][0]} of {short(c.value)} {c.unit}" for c in left)
    found = results.result(ImbalanceResult)
    assert found is not None
    how = shafts_words(found.remedy["second_order_shafts"].shafts)
    return f"{said} Second order leaves {what}, which {how} times crank speed would take (speed_ratio)."


# --- the envelope ----------------------------------------------------------------------------------------------------------
def _stiff_enough(made: Design, before: Results, body: str, read: Callable[[str], Design]) -> str:
    """The tables with the thinnest core on which the slopes of the journals stay below 0.2 mrad."""
    for share in CORES:
        found = _envelope(made, before, share)
        tables = _tables(made, found, share, _drill(made, before, found))
        if _slope(read(body + tables)) <= SLOPE:
            return tables
    raise NoSolution(STARTER, Text("cores up to {share} of the outer radius", share=CORES[-1]), GIVE)


def _slope(design: Design) -> Radian:
    """The larger slope of both journals, without the bearings and what comes after them."""
    assert design.countershaft is not None and design.bearings is not None
    journals = tuple(Journal(diameter=b.diameter, length=b.length) for b in (design.bearings.front, design.bearings.rear))
    alone = replace(design, countershaft=replace(design.countershaft, journals=journals), bearings=None, friction=None)
    found = solve(alone).result(CountershaftResult)
    slopes = (found.slope_front, found.slope_rear) if found is not None else (None,)
    return max(math.inf if slope is None else slope for slope in slopes)


def _backward(results: Results) -> tuple[complex, complex, float]:
    """Force and couple of first order that turn backward, cylinder 1 at TDC, and the angular speed."""
    train, imbalance = results.result(EngineResult), results.result(ImbalanceResult)
    assert train is not None and imbalance is not None
    _, F, _, C = imbalance.orders["order_1"].vectors
    return F, C, train.angular_speed


def _envelope(made: Design, results: Results, core: float) -> _Shaft:
    """The smallest outer radius at which the utilisation is comfortable, with the bearings that go with it."""
    engine, train = made.engine, results.result(EngineResult)
    assert engine is not None and train is not None
    (F, C, omega), z = _backward(results), train.crank.z
    span = _up(max(float(max(z) - min(z)) + engine.cylinder_pitch, 1.5 * engine.bore), 2e-3)
    rho = made.materials[STEEL].density
    with untraced():
        U = f.asked_unbalance(x_o=OVERDESIGN, F_like=F, omega=omega)
        P = f.asked_product(x_o=OVERDESIGN, C_like=C, omega=omega)
        R_r = f.reaction_rear(C_S=P * omega**2, z_f=-span / 2, F_S=U * omega**2, z_r=span / 2)
        load = max(abs(R_r), abs(f.reaction_front(F_S=U * omega**2, R_r=R_r)))
        for step in range(37, 400):
            R = step * 0.5e-3
            rear = _up(2 * (R + THREADED), 0.5e-3)
            length = min(_up(max(load * engine.rated_speed / HEAT_INDEX, BEARING[0] * rear), 0.5e-3), _down(BEARING[1] * rear, 0.5e-3))
            half_length, r_0 = _down(span / 2 - length / 2 - 2 * FILLET, 0.5e-3), _down(core * R, 0.5e-3)
            if half_length <= 0:
                break
            k = sizes.unbalance_per_length(rho=rho, R=R, r_0=r_0)
            alpha, product = sizes.force_number(U=U, k=k, z_max=half_length), sizes.product_number(P=P, k=k, z_max=half_length)
            if sizes.utilisation(alpha=alpha, product=product) > UTILISATION:
                continue
            sized = size(U, P, omega, rho, R, r_0, half_length)
            module, tip = _gear(rear)
            front = min(max(tip, _up(length / BEARING[1], 0.5e-3)), rear)
            return _Shaft(span, R, r_0, half_length, rear, front, length, load * engine.rated_speed / length, module, sized)
    raise NoSolution(STARTER, Text("outer radii up to 200 mm on a span of {span}", span=Amount(span * 1e3, "mm")), GIVE)


def _gear(rear: Metre) -> tuple[float, Metre]:
    """The largest module whose wheel on the shaft goes through the rear seat too, and the front journal that it goes through."""
    for module in MODULES:
        with untraced():
            d = g.reference_diameter(float(CRANK_TEETH), g.transverse_module(module * 1e-3, HELIX))
            tip = _up(g.tip_diameter(d, module * 1e-3, 0.0, 0.0) + 1e-3, 0.5e-3)
        if tip <= rear:
            break
    return module, tip


def _drill(made: Design, results: Results, found: _Shaft) -> Holes:
    """The narrowest of four holes that together take 3 % of what the shaft supplies."""
    F, C, omega = _backward(results)
    depth = min(_down(0.8 * (found.outer - found.core), 0.5e-3), 20e-3)
    places = gathered([found.sized.front.z, found.sized.rear.z])
    with untraced():
        for diameter in range(4, 41):
            holes = Holes(diameter=diameter * 1e-3, depth=depth, count=4)
            takes = calibration(holes, made.materials[STEEL].density, found.outer, places, omega, abs(C))
            if takes.hole_range >= DRILLED * abs(C) and holes.count * takes.hole_unbalance * omega**2 >= DRILLED * abs(F):
                return holes
    raise NoSolution(STARTER, Text("four holes of {depth}, up to 40 mm wide", depth=Amount(depth * 1e3, "mm")), GIVE)


def _up(x: float, step: float) -> float:
    return math.ceil(x / step - 1e-6) * step


def _down(x: float, step: float) -> float:
    return math.floor(x / step + 1e-6) * step


# --- the tables ------------------------------------------------------------------------------------------------------------
def _tables(made: Design, found: _Shaft, share: float, holes: Holes) -> str:
    def mm(x: Metre) -> str:
        return f"{x * 1e3:.1f}"

    core = f"{share:g} of the outer radius" + (
        "" if share == CORES[0] else f", not {CORES[0]:g}, to keep the journals' slopes below 0.2 mrad"
    )
    index = f"{found.heat_index * 60 / 1000 / 1e3:.0f} 000 N·rpm/mm"
    if found.heat_index <= HEAT_INDEX * (1 + 1e-9):
        length = f"l/d of at least {BEARING[0]:g} at the rear, and a heat index up to 400 000 N·rpm/mm"
    else:
        length = f"l/d of {BEARING[1]:g}; the heat index is {index}, at this speed a case for rolling bearings"
    return _aligned(f"""
# A counter-shaft to begin with, by rules of this program: what is marked "assumed" belongs to no engine in particular.
[countershaft]
mode = "size"
material = "{STEEL}"  # assumed: a usual shaft steel
speed_ratio = -1
bearing_positions_mm = [{mm(-found.span / 2)}, {mm(found.span / 2)}]  # assumed: as far apart as the row of cylinders is long, or 1.5 bores
outer_radius_mm = {mm(found.outer)}  # assumed: the smallest with a utilisation up to {UTILISATION:g}; here {found.sized.utilisation:.2f}
core_radius_mm = {mm(found.core)}  # assumed: {core}
half_length_mm = {mm(found.half_length)}  # assumed: two fillets short of the journals
radial_clearance_mm = {mm(THREADED)}  # assumed: for threading in
fillet_radius_mm = {mm(FILLET)}  # assumed
overdesign_percent = {OVERDESIGN * 100:g}  # assumed: half of what the holes are to take

[countershaft.holes]
diameter_mm = {mm(holes.diameter)}  # assumed: the narrowest that take {DRILLED * 100:g} %
depth_mm = {mm(holes.depth)}  # assumed: 0.8 of the sectors' height, at most 20 mm
count = 4  # assumed: two in each sector

[bearings]
oil = "5W-40"  # assumed
supply_temperature_C = 90.0  # assumed: gallery of a warm engine
supply_pressure_bar = 4.0  # assumed
supply = "hole"
hole_diameter_mm = 5.0  # assumed
housing_material = "EN-GJL-250"  # assumed: expands like the shaft, so that the clearance stays when cold

[bearings.front]
diameter_mm = {mm(found.front)}  # assumed: 1 mm above the gear's tip, or l/d of {BEARING[1]:g}
length_mm = {mm(found.length)}  # assumed: that of the rear bearing
clearance_factor = 0.75  # assumed: usual 0.4 to 0.8; a fast journal wants the oil
journal_roughness_um = 0.2  # assumed: ground and lapped
housing_roughness_um = 0.4  # assumed: finely bored

[bearings.rear]
diameter_mm = {mm(found.rear)}  # assumed: the sectors and their clearance go through
length_mm = {mm(found.length)}  # assumed: {length}
clearance_factor = 0.75  # assumed
journal_roughness_um = 0.2  # assumed
housing_roughness_um = 0.4  # assumed

[gears]
normal_module_mm = {found.module}  # assumed: the largest up to 2 whose wheel goes through the seats
pressure_angle_deg = 20.0
helix_angle_deg = {math.degrees(HELIX):.1f}  # assumed
face_width_mm = {_up(7.5 * found.module, 0.5)}  # assumed: 7.5 modules, as in the R753IE4
tool_addendum = 1.41  # assumed: the tool of the R753IE4
tool_tip_radius = 0.2  # assumed
{_train()}
[friction]
flank_roughness_um = 0.8  # assumed: ground
load_sharing = "linear"
""")


def _train() -> str:
    """Three meshes, so that the shaft turns against the crank; no shifts, and centre distances without backlash before allowances."""
    wheels = (("crank", CRANK_TEETH), ("central", CENTRAL_TEETH), ("idler", IDLER_TEETH), ("shaft", CRANK_TEETH))
    why = {"crank": "assumed, as in the R753IE4", "shaft": "as many as on the crank: ratio −1 by three meshes"}
    rows = [
        f'\n[[gears.wheels]]\nname = "{name}"\nteeth = {teeth}  # {why.get(name, "assumed")}\n'
        "span_allowance_um = [-20, -30]  # assumed: teeth shaved or ground\n"
        for name, teeth in wheels
    ]
    rows += [
        f'\n[[gears.meshes]]\ndriver = "{driver}"\ndriven = "{driven}"\ntolerance_um = 40  # assumed: the allowances leave it a backlash\n'
        for (driver, _), (driven, _) in pairwise(wheels)
    ]
    return "".join(rows)


def _aligned(text: str) -> str:
    """Comments behind a value from the same column on."""
    rows = (row.split("  # ", 1) for row in text.splitlines())
    return "".join((f"{row[0]:<31} # {row[1]}" if len(row) > 1 else row[0]) + "\n" for row in rows)
