# SPDX-License-Identifier: Apache-2.0
"""How the bearings of one shaft share what turns with it, and how it lies in them.

Each bearing has its law (`support`), in the frame of the shaft."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from ..countershaft.bending.carried import carried
from ..countershaft.bending.condensed import Condensed
from ..countershaft.bending.formulas import cone, displaced, tilt_along, tilted
from ..countershaft.inputs import ShaftInputs
from ..countershaft.result import CountershaftResult
from ..countershaft.rows import ROW, SHAFT, BearingRow, called
from ..countershaft.supports import on_supports
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.functions import argument, modulus
from ..sheet.linked_array import elements, gathered, item
from ..sheet.quantity import dotted
from ..sheet.record import replace
from ..sheet.text import Text
from ..sheet.units import Metre, Newton
from ..sheet.value import about, based_on, untraced
from .formulas import mirrored_phase, share_of
from .plain.result import PlainResult
from .result import BearingsResult
from .support import Carrying, OnShaftResult, OperatingPoint, Shared, Support, on_bearing

# --- how the bearings of one shaft share what turns with it

NOTHING = 1e-9  # of the largest load: less is rounding
PASSES = 8
MEAN_FROM = 4  # from this pass on the loads are the mean of the last two
SETTLED = 1e-4  # of the largest load: by so little the loads may move in the last pass


def on_films(shaft: Condensed, films: Shared, supports: Sequence[Support], duty: OperatingPoint[Any]) -> Shared:
    """The same laws with what they share by lines of the calculation; what is rounding alone is nothing."""
    laws = [support.told_law(law, duty) for law, support in zip(films.laws, supports)]
    with about(Text("shaft on its films")):
        on = carried(shaft, laws, [support.row.name for support in supports], near=films.carried.x)
    carries = np.abs(on.load) > NOTHING * np.abs(on.load).max()
    load, x = (based_on(np.where(carries, z, 0.0), z) for z in (on.load, on.x))
    return replace(films, carried=replace(on, load=load, x=x))


def shared(shaft: Condensed, supports: Sequence[Support], duty: OperatingPoint[Any], sense: int) -> Shared:
    """Loads, the heat that they make in each bearing, the laws as they are so warm, and what they share: until the
    loads stay, eight passes at most.

    `duty`: speed and oil of all bearings; its load is not asked.  One that finds no balance under its load keeps its
    last state, at first that of the oil as it is supplied."""
    names = [support.row.name for support in supports]
    with untraced():
        supplied = laws = [support.law(duty, sense) for support in supports]
        loads = np.abs(shaft.f_c)
        for n_pass in range(1, PASSES + 1):
            laws = [
                support.warm_law(replace(duty, load=load), cold, before, sense)
                for support, load, cold, before in zip(supports, loads.tolist(), supplied, laws)
            ]
            on = carried(shaft, laws, names)
            now = np.abs(on.load)
            moved = float(np.abs(now - loads).max() / (now.max() or 1.0))
            if moved <= SETTLED:
                break
            loads = now if n_pass < MEAN_FROM else (now + loads) / 2
    return Shared(tuple(laws), on, moved)


# --- how the shaft lies in its bearings

JUDGED = 0.05  # of the largest load of rigid supports: below it a share says nothing


def on_shaft(
    found: BearingsResult,
    shaft: CountershaftResult,
    turning: Condensed | None,
    films: Shared | None,
    sense: int,
    zone: Metre,
) -> BearingsResult:
    """The same bearings with the place and the tilt of their journals, and what stands on more than two of them.

    `turning`: the shaft as its films know it, None where that is not known; `films`: those that share its load;
    `sense`: +1 with the crank, −1 against it; `zone`: the coaxiality of the bores."""
    if turning is not None:
        found = _lying(found, sense, turning, films)
    stiffness = np.inf if films is None else films.carried.stiffness
    positions = tuple(r.row.position for r in found.bearings.values())
    stands = on_supports(shaft, positions, stiffness)
    if stands is None:
        return found
    bearings = found.bearings
    if zone and films is not None:
        with about(Text("bores out of line")):
            loads = elements(based_on(stands.alignment(zone), zone, films.carried.load))
        bearings = {place: _out_of_line(place, r, R_c) for (place, r), R_c in zip(bearings.items(), loads)}
    return replace(found, stands=stands, bearings=bearings)


def turned_over(found: BearingsResult) -> BearingsResult:
    """The bearings of the mirror image of a shaft: as far off and as much aslant, in directions that are conjugate."""
    bearings = {}
    for place, r in found.bearings.items():
        if (lies := r.on_shaft) is not None:
            with about(Text("{place} bearing, in its film", place=called(place))):
                phases = lies.load_phase, lies.displacement_phase
                load, moved = (None if phi is None else mirrored_phase(phi=phi) for phi in phases)
            r = r.lying(replace(lies, load_phase=load, displacement_phase=moved))
        bearings[place] = r
    line = None if found.line is None else (found.line[0], found.line[1].conjugate())
    return replace(found, bearings=bearings, line=line)


def _lying(found: BearingsResult, sense: int, turning: Condensed, films: Shared | None) -> BearingsResult:
    """Two bearings: the loads of pins, the places by the bearings' own films; more: as they share."""
    rows = list(found.bearings.values())
    with about(Text("shaft in its films")):
        if films is None:
            ways, behind = zip(*[r.way() for r in rows])
            P = turning.f_c
            x = displaced(P=P, e=gathered(ways), phi=sense * gathered(behind))
        else:
            P, x = films.carried.load, films.carried.x
        theta = tilted(theta_0=turning.theta_0, Theta=turning.Theta, x=x)
        along = elements(tilt_along(theta=theta, x=x))
        half_angle = cone(x_f=item(x[0]), x_r=item(x[-1]), z_f=item(turning.z[0]), z_r=item(turning.z[-1]))
    pins = based_on(np.abs(turning.f_c), turning.f_c)
    bearings = {}
    for i, ((place, r), P_i, x_i, theta_i) in enumerate(zip(found.bearings.items(), *map(elements, (P, x, theta)))):
        with about(Text("{place} bearing, in its film", place=called(place))):
            share = None
            if films is not None and pins[i] >= JUDGED * pins.max():
                share = share_of(P=r.load, R=item(pins[i]))
            lies = OnShaftResult(
                load_phase=based_on(argument(P_i), P_i) if P_i else None,
                share=share,
                displacement=based_on(modulus(x_i), x_i),
                displacement_phase=based_on(argument(x_i), x_i) if x_i else None,
                tilt=based_on(modulus(theta_i), theta_i),
                tilt_along=along[i],
                film_edge_tilted=r.edge_tilted(along[i]),
                standing_stiffness=None if films is None else item(films.carried.stiffness[i]),
            )
        bearings[place] = r.lying(lies)
    line = turning.nodes, turning.deflection(np.asarray(x))
    return replace(found, bearings=bearings, cone=half_angle, line=line)


def _out_of_line(place: str, r: Carrying, R_c: Newton) -> Carrying:
    """The same bearing with what its bores may add to its load; no film where none carries both."""
    assert r.on_shaft is not None
    with about(Text("{place} bearing, bores out of line", place=called(place))):
        film = r.out_of_line(R_c)
    return r.lying(replace(r.on_shaft, alignment_load=R_c, film_alignment=film))


# --- what is judged

GAPS = dotted(ROW, BearingRow.clearance), dotted(ROW, BearingRow.clearance_factor)
CORE = dotted(SHAFT, ShaftInputs.core_radius)
SHARES = (0.8, 1.25)  # of the load of rigid supports; rule of this program


TOO_SMALL = 0.05  # of the largest load of the shaft; rule of this program


SHARED_LOAD = Text("statics: K_c·x + P(x) = f_c, the films as supports of the shaft that bends")


SHARE = CheckRule(
    "bearings.B.share",
    "method",
    "Films and bending share the load otherwise than rigid supports: it stands on the clearances as they are.",
    Text("Load over that of rigid supports"),
    "in",
    source=Text("{statics}; range: rule of this program", statics=SHARED_LOAD),
    advice=Text("Clearances as they will be made, and the stiffness share of the sectors, decide what each carries."),
    value_id=dotted("bearings", "B", OnShaftResult.share),
    moved_by=(*GAPS, CORE),
)


SHARE_SETTLED = CheckRule(
    "bearings.share_settled",
    "limit",
    "The loads and the heat that they make do not agree: what is said of the bearings is not theirs.",
    Text("Loads of the bearings in the last pass, moved by"),
    "<=",
    "%",
    Text("{statics}, with the heat of each film; rule of this program", statics=SHARED_LOAD),
    Text("Other clearances, or a bearing less."),
    role="self",
    exact=True,
    moved_by=(*GAPS, CORE),
)


UNLOADED = CheckRule(
    "bearings.B.unloaded",
    "advice",
    "A bearing that carries next to nothing costs oil and friction; its film is not judged where the journal runs "
    "centred.",
    Text("Load of the bearing"),
    unit="N",
    source=Text("rule of this program: 5 % of the largest load of its shaft, and what a journal at ε = 0.02 carries"),
    advice=Text("Leave the bearing out, or place it where the shaft has load for it."),
    value_id=dotted("bearings", "B", PlainResult.load),
    moved_by=(dotted(ROW, BearingRow.position),),
)


def support_checks(
    found: BearingsResult, films: Shared | None, shaft: CountershaftResult | None, zone: Metre
) -> Iterator[Check]:
    """What is asked of bearings that carry one shaft together; `zone`: the coaxiality of the bores."""
    loads = {place: r.load for place, r in found.bearings.items()}
    out_of_line = any(zone or any(r.row.offset or ()) for r in found.bearings.values())
    if films is not None:
        yield SHARE_SETTLED(films.moved, SETTLED)
    for place, r in found.bearings.items():
        least = r.least_load
        if len(loads) > 2:
            least = max(least, TOO_SMALL * max(loads.values()))
        if least:
            yield on_bearing(UNLOADED, place, r.load, least)
        lies = r.on_shaft
        if lies is None:
            if len(loads) > 2 and shaft is not None and shaft.bending is None:
                outline = Missing((dotted(SHAFT, ShaftInputs.sections),), (), "none", "none")
                yield on_bearing(SHARE, place, None, SHARES, missing=outline)
                if out_of_line:
                    yield from r.alignment_checks(place, outline)
            continue
        if lies.share is not None:
            yield on_bearing(SHARE, place, lies.share, SHARES)
        yield from r.tilt_checks(place)
        if lies.alignment_load is not None:
            yield from r.alignment_checks(place)
