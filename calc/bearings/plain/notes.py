# SPDX-License-Identifier: Apache-2.0
"""Notes beside the numbers: assumptions, what the program chose, and where the source is wrong."""

from collections.abc import Iterator, Mapping

from ...countershaft.result import CountershaftResult
from ...countershaft.rows import called, titled
from ...library.oils import rising_rows
from ...sheet.quantity import dotted
from ...sheet.step import Erratum
from ...sheet.text import COMMA, EMPTY, Amount, Text, listed
from ...sheet.units import UNITS
from ...sheet.value import untraced
from ..inputs import BearingsInputs
from .inputs import SLOPE_TAKEN
from .materials import running_surface
from .result import PlainResult, RouteResult
from .routes import supply
from .routes.din31652 import film_heavily_loaded
from .routes.routes import ROUTES
from .routes.thermal_balance import HOTTEST
from .row import RELIEF, RELIEF_LENGTH
from .suitability import fatigue_note

TURNS = Text(
    "The load turns with the shaft: in its frame the seat turns backwards, so Sommerfeld's number is that of a "
    "standing load, and the "
    "narrowest film lies on the other side of the load. The journal is loaded on one fixed arc: there it wears, and "
    "is hottest."
)
NO_RULE = 10.0  # m/s


def notes(
    inputs: BearingsInputs, shaft: CountershaftResult | None, results: Mapping[str, PlainResult]
) -> tuple[Text, ...]:
    return tuple(dict.fromkeys(note for note in _all_notes(inputs, shaft, results) if note))


def _all_notes(
    inputs: BearingsInputs, shaft: CountershaftResult | None, results: Mapping[str, PlainResult]
) -> Iterator[Text]:
    yield _load(inputs)
    reference = f"{inputs.clearance_reference_temperature:g} °C"
    yield Text(
        "The clearance is taken as given at {reference} and judged at the film's mean temperature.", reference=reference
    )
    by_fits = [r.seat for r in results.values() if r.seat.stack is None]
    if by_fits and not any(seat.inputs.fits_given for seat in by_fits):
        yield Text(
            "No fits are given: the corners take IT7 for journal and seat, half of it to either side of the "
            "clearance, and the oil within "
            "±{viscosity_tolerance} % of its viscosity.",
            viscosity_tolerance=Amount(inputs.viscosity_tolerance * 100, form="g"),
        )
    yield from _seats(results)
    if inputs.select is not None and all(r.seat.bearing.seat != "shells" for r in results.values()):
        yield Text("The classes of [bearings.select] are not used: no bearing of this shaft runs in shells.")
    yield _slope(results, shaft)
    yield from _on_shaft(results, shaft)
    yield from _feeds(results)
    for r in results.values():
        yield rising_rows(r.seat.lubricant.oil) or EMPTY
    for place, r in results.items():
        if r.seat.centred:
            yield Text(
                "{place} bearing: it carries next to nothing, and its journal runs centred. Heat and friction are "
                "those under {load}, with which the film table begins; the film is not judged.",
                place=titled(place),
                load=Amount(r.duty.load, "N"),
            )
            continue
        if r.shear_factor is not None and r.film_sheared is None:
            yield Text("{place} bearing: no film is found for an oil thinned by shear.", place=titled(place))
        if r.film_overspeed is None:
            yield Text("{place} bearing: no film is found at overspeed.", place=titled(place))
    if fast := [place for place, r in results.items() if r.surface_speed > NO_RULE]:
        yield Text(
            "The journal's surface runs faster than 10 m/s at the {fast} bearing: the rule for the speed above mixed "
            "friction ends there. "
            "It is held at 10·n_T and, beside it, carried on as u·n_T.",
            fast=listed(called(place) for place in fast),
        )
    for place, r in results.items():
        bearing = titled(place)
        for name, why in r.side.silent.items():
            title = ROUTES[name].title
            yield Text("{place} bearing: {routes} gives no value here ({why}).", place=bearing, routes=title, why=why)
        if r.temperature_rise > HOTTEST:
            yield Text(
                "{place} bearing: the heat has no balance: as the viscosity is the same at every temperature, the film "
                "is the one with the clearance at a rise of {hottest} K.",
                place=bearing,
                hottest=Amount(HOTTEST, form="g"),
            )
        if r.film_double_load is None and not r.seat.centred:
            yield Text("{place} bearing: no film carries twice the load.", place=bearing)
    yield from _surfaces(inputs, results)
    yield from (r.sweep.why(place) for place, r in results.items())
    yield from (r.sweep.gaps(place) for place, r in results.items())
    if any(
        r.sweep.bench and r.thinnest_film is not None and r.thinnest_film > r.film * (1 + 1e-6)
        for r in results.values()
    ):
        yield Text(
            "The film at the design's own supply is thinner than anywhere on the bench run, whose oil is cooler or "
            "whose load is smaller: "
            "the design's supply is the harder case, and it is judged."
        )


def _surfaces(inputs: BearingsInputs, results: Mapping[str, PlainResult]) -> Iterator[Text]:
    """What the journals run on, as often as the load passes a point of it."""
    passes = abs(inputs.load_speed_ratio - inputs.bush_speed_ratio)  # for one turn of the journal
    for place, r in results.items():
        bush, housing = r.seat.inputs.bush_material, r.seat.inputs.housing_material
        if (surface := running_surface(bush, housing)) is None:
            yield Text(
                "What a journal may carry on bare {housing_material} is not known here.", housing_material=housing
            )
        elif passes:
            yield fatigue_note(place, surface, r.film_pressure_max, passes * r.duty.speed, None)


def _seats(results: Mapping[str, PlainResult]) -> Iterator[Text]:
    """What is taken of bushes and shells."""
    for place, r in results.items():
        row, seat = r.seat.bearing, r.seat_
        if seat is None:
            continue
        rings = seat.rings
        if rings.chosen:
            yield Text(
                "{place} bearing: no interference is given; the one shown is the least that keeps the fit shut under "
                "the load, cold and hot, with the field that such parts are made in: whether it holds is not judged.",
                place=titled(place),
            )
        if row.crush is not None and not row.crush_load:
            yield Text(
                "{place} bearing: the crush counts as measured without a checking load; under one it is more by what "
                "the load shortens the shell.",
                place=titled(place),
            )
        if r.seat.inputs.bush_material is None:
            yield Text(
                "{place} bearing: the lining is not given; what it bears, and whether it runs in, is not judged.",
                place=titled(place),
            )
        if rings.outside is None:
            yield Text("The metal around the bore is taken as a ring of twice its diameter.")
        if r.split is not None and (row.relief is None or row.relief_length is None):
            yield Text(
                "Relief of the shells at their split, where it is not given: {depth} over {length} to each side (from "
                "memory).",
                depth=Amount(RELIEF * 1e6, "µm"),
                length=Amount(RELIEF_LENGTH * 1e3, "mm"),
            )
        elif row.seat == "shells" and r.split is None and not r.seat.centred and _sweeps(r.seat.inputs):
            yield Text(
                "{place} bearing: what the split does to the film is known of a load that turns with the journal in a "
                "seat that stands, and not of this one.",
                place=titled(place),
            )


def _sweeps(inputs: BearingsInputs) -> bool:
    """Whether the load passes along the seat."""
    return inputs.load_speed_ratio != inputs.bush_speed_ratio


def _load(inputs: BearingsInputs) -> Text:
    if inputs.load_speed_ratio == 1 and not inputs.bush_speed_ratio:
        return TURNS
    if inputs.load_speed_ratio == 0 and not inputs.bush_speed_ratio:
        return Text("The load stands still.")
    return Text(
        "The load turns at {load_speed_ratio} times the journal's speed; the film is that of the speed |n_J + n_B − "
        "2·n_F|.",
        load_speed_ratio=Amount(inputs.load_speed_ratio, form="g"),
    )


def _slope(results: Mapping[str, PlainResult], shaft: CountershaftResult | None) -> Text:
    if any(r.seat.bearing.slope is not None for r in results.values()):
        return Text("The slope of the journals is the one given here, not that of the counter-shaft's bending.")
    if shaft is not None and shaft.slopes:
        return Text(
            "The slope of the journals is that of the counter-shaft's bending, with the stiffness share of its sectors."
        )
    return Text(
        "No slope of the journals is given: the film at the edge is that of {slope}.",
        slope=Amount(SLOPE_TAKEN * 1e3, "mrad"),
    )


def _on_shaft(results: Mapping[str, PlainResult], shaft: CountershaftResult | None) -> Iterator[Text]:
    """How the bearings carry the shaft together, and what is left out of that."""
    if any(r.on_shaft is not None for r in results.values()):
        yield Text(
            "The tilt of the journals in their films leaves out the moment of a film against it, which holds the "
            "journal straighter, and the rotary inertia of the shaft's sections. The film at the edge is that of the "
            "slope on pins; the one with the tilt stands beside it."
        )
    for place, r in results.items():
        edge = r.on_shaft.film_edge_tilted if r.on_shaft is not None else None
        if r.seat.bearing.slope is not None and edge is not None and edge < r.kreisle_film:
            yield Text(
                "{place} bearing: the slope that is given is judged, not the tilt; with that the film at the edge is "
                "{edge}, less than the {least} that it needs. Leave that slope out and it is judged.",
                place=titled(place),
                edge=Amount(edge * 1e6, "µm"),
                least=Amount(r.kreisle_film * 1e6, "µm"),
            )
    if len(results) == 2 or shaft is None:
        return
    if any(r.on_shaft is not None for r in results.values()):
        yield Text(
            "More than two bearings share the load by their films and the bending of the shaft; at other speeds each "
            "keeps its share, at the corners of its own tolerances it has its own."
        )
    elif any(r.seat.bearing.load is not None for r in results.values()):
        yield Text("A load is given, which rules: the other bearings carry what rigid supports would.")
    else:
        yield Text(
            "How the bearings share the load is not known without the outline of the shaft: they carry what rigid "
            "supports of a shaft of one stiffness would."
        )


def _feeds(results: Mapping[str, PlainResult]) -> Iterator[Text]:
    """How the oil comes to the bearings: to all of them, or to those that are fed alike by their names."""
    alike: list[dict[str, PlainResult]] = []
    for place, r in results.items():
        there = next((some for some in alike if next(iter(some.values())).seat.inputs == r.seat.inputs), None)
        if there is None:
            alike.append(there := {})
        there[place] = r
    said: dict[Text, list[str]] = {}
    for some in alike:
        said.setdefault(_feed(next(iter(some.values())).seat.inputs, some), []).extend(some)
    for note, places in said.items():
        yield note if len(said) == 1 else Text("{places}: {note}", places=listed(map(titled, places)), note=note)


def _feed(inputs: BearingsInputs, results: Mapping[str, PlainResult]) -> Text:
    part = Text("shaft") if inputs.supply == "shaft" else Text("seat")
    if inputs.supply == "groove":
        if inputs.groove_arc is None:
            return Text(
                "The groove runs all round and parts the bearing into two lands; their oil comes by the supply "
                "pressure alone."
            )
        if supply.lands(inputs) == 2:
            return Text(
                "The load comes over the groove: the bearing is taken as two lands throughout, the lower bound of its "
                "film."
            )
        return Text(
            "The groove lies in the unloaded half and keeps its angle to the load: the film is that of the whole "
            "length."
        )
    if inputs.supply == "axial_groove":
        return Text(
            "The film begins and ends at its axial grooves, which keep their angle to the load; the other methods do "
            "not know them."
        )
    what = Text("pocket") if inputs.supply == "pocket" else Text("hole")
    if supply.keeps_its_angle(inputs):
        degrees = UNITS["°"].shown(inputs.supply_angle)
        angle = Amount(degrees, form=".0f")
        note = Text(
            "The {what} in the {part} keeps its angle to the load, {degrees}°.", what=what, part=part, degrees=angle
        )
        return note + (
            Text(" It lies in the loaded half, where the film's pressure holds the oil back.") if degrees < 90 else ""
        )
    note = Text(
        "The load sweeps over the {what} in the {part}: its flow is the mean over the turn, and not that of a place "
        "opposite the load.",
        what=what,
        part=part,
    )
    arcs = COMMA.join(
        Text("{arc} {place}", arc=Amount(UNITS["°"].shown(r.feed_blocked_arc), "°", form=".0f"), place=called(place))
        for place, r in results.items()
        if r.feed_blocked_arc
    )
    if not arcs:
        return note
    return note + Text(
        " Over an arc of {arcs} the film's own pressure is above that of the supply, so that the true flow is smaller.",
        arcs=arcs,
    )


def errata(place: str, r: PlainResult) -> Iterator[Erratum]:
    """What the source's film rule gives for this bearing by the branch that it keeps."""
    falz = r.routes.get("falz")
    if falz is not None and 0.9 < falz.sommerfeld <= 1:
        with untraced():
            wrong = film_heavily_loaded(r.clearance, falz.sommerfeld, r.seat.bearing.length / r.seat.bearing.diameter)
        So = Amount(falz.sommerfeld, form=".3f")
        yield Erratum(
            dotted("bearings", place, "falz", RouteResult.film),
            Text("Film by Falz, {place}", place=called(place)),
            wrong * 1e6,
            "µm",
            Text("method of Finotti 2013, 5.5.3: the branch of the first pass"),
            Text(
                "So = {sommerfeld} is below 1, but the thesis keeps the formula for So > 1 of its first pass.",
                sommerfeld=So,
            ),
            ("Finotti 2013", "3279-3281"),
        )
