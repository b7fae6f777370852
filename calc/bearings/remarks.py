# SPDX-License-Identifier: Apache-2.0
"""What is said beside the numbers: assumptions, what the program chose, and where the source is wrong."""

from collections.abc import Mapping

from ..countershaft.result import CountershaftResult
from ..sheet.step import Erratum
from ..sheet.trace import untraced
from ..sheet.units import UNITS
from .checks import POLYMER_THICKENED
from .inputs import BearingsInputs
from .pairing.data import running_surface
from .pairing.pairing import fatigue_note
from .result import BearingResult
from .routes import supply
from .routes.din31652 import film_heavily_loaded
from .routes.side_by_side import ROUTES

TURNS = (
    "The load turns with the shaft: in its frame the seat turns backwards, so Sommerfeld's number is that of a standing load, and the "
    "narrowest film lies on the other side of the load. The journal is loaded on one fixed arc: there it wears, and is hottest."
)
NO_RULE = 10.0  # m/s


def notes(inputs: BearingsInputs, shaft: CountershaftResult | None, results: Mapping[str, BearingResult]) -> tuple[str, ...]:
    found = [_load(inputs)]
    reference = f"{inputs.clearance_reference_temperature:g} °C"
    found.append(f"The clearance is taken as given at {reference} and judged at the film's mean temperature.")
    if not inputs.fits_given:
        found.append(
            "No fits are given: the corners take IT7 for journal and seat, half of it to either side of the clearance, and the oil "
            f"within ±{inputs.viscosity_tolerance * 100:g} % of its viscosity. Corners that are assumed advise; those of journal_fit "
            "and seat_fit judge."
        )
    found.append(_slope(inputs, shaft))
    found += _feed(inputs, results)
    if any(r.seat.lubricant.C_1 > POLYMER_THICKENED for r in results.values()):
        found.append(
            "The viscosity laws do not know the thinning of multigrade oils at high shear rate (25 to 30 % at 150 °C and 10⁶ 1/s): "
            "see the check on the shear rate, and the corners with thinner oil."
        )
    fast = [place for place, r in results.items() if r.surface_speed > NO_RULE]
    if fast:
        found.append(
            f"The journal's surface runs faster than 10 m/s at the {' and '.join(fast)} bearing: the rule for the speed above mixed "
            "friction ends there. It is held at 10·n_T and, beside it, carried on as u·n_T."
        )
    for place, r in results.items():
        found += [f"{place.capitalize()} bearing: {ROUTES[name][0]} gives no value here ({why})." for name, why in r.side.silent.items()]
        if r.film_double_load is None:
            found.append(f"{place.capitalize()} bearing: no film carries twice the load.")
    surface = running_surface(inputs.bush_material, inputs.housing_material)
    passes = abs(inputs.load_speed_ratio - inputs.bush_speed_ratio)  # of the load over a point of the seat, for one turn of the journal
    if passes and surface is not None:
        found += [fatigue_note(place, surface, r.film_pressure_max, passes * r.duty.speed, None) for place, r in results.items()]
    if surface is None:
        found.append(f"What a journal may carry on bare {inputs.housing_material} is not known here.")
    found += [words for place, r in results.items() if (words := r.sweep.why(place))]
    found += [words for place, r in results.items() if (words := r.sweep.gaps(place))]
    if any(r.sweep.bench and r.thinnest_film is not None and r.thinnest_film > r.film * (1 + 1e-6) for r in results.values()):
        found.append(
            "The film at the design's own supply is thinner than anywhere on the bench run, whose oil is cooler or whose load is smaller: "
            "the design's supply is the harder case, and it is judged."
        )
    return tuple(dict.fromkeys(words for words in found if words))


def _load(inputs: BearingsInputs) -> str:
    if inputs.load_speed_ratio == 1 and not inputs.bush_speed_ratio:
        return TURNS
    if inputs.load_speed_ratio == 0 and not inputs.bush_speed_ratio:
        return "The load stands still."
    return f"The load turns at {inputs.load_speed_ratio:g} times the journal's speed; the film is that of the speed |n_J + n_B − 2·n_F|."


def _slope(inputs: BearingsInputs, shaft: CountershaftResult | None) -> str:
    if inputs.slope is not None:
        return "The slope of the journals is the one given here (slope_mrad), not that of the counter-shaft's bending."
    if shaft is not None and shaft.slope_front is not None:
        return "The slope of the journals is that of the counter-shaft's bending, with the stiffness share of its sectors."
    return "No slope of the journals is given: it is taken as zero, and the film at the edge is that of the middle."


def _feed(inputs: BearingsInputs, results: Mapping[str, BearingResult]) -> list[str]:
    part = "shaft" if inputs.supply == "shaft" else "seat"
    if inputs.supply == "groove":
        if inputs.groove_arc is None:
            return ["The groove runs all round and parts the bearing into two lands; their oil comes by the supply pressure alone."]
        if supply.lands(inputs) == 2:
            return ["The load comes over the groove: the bearing is taken as two lands throughout, the lower bound of its film."]
        return ["The groove lies in the unloaded half and keeps its angle to the load: the film is that of the whole length."]
    what = "pocket" if inputs.supply == "pocket" else "hole"
    if supply.keeps_its_angle(inputs):
        degrees = UNITS["°"].shown(inputs.supply_angle)
        found = f"The {what} in the {part} keeps its angle to the load, {degrees:.0f}°."
        return [found + (" It lies in the loaded half, where the film's pressure holds the oil back." if degrees < 90 else "")]
    arcs = ", ".join(f"{UNITS['°'].shown(r.feed_blocked_arc):.0f}° {place}" for place, r in results.items() if r.feed_blocked_arc)
    return [
        f"The load sweeps over the {what} in the {part}: its flow is the mean over the turn, and not that of a place opposite the load."
        + (f" Over an arc of {arcs} the film's own pressure is above that of the supply, so that the true flow is smaller." if arcs else "")
    ]


def errata(place: str, r: BearingResult) -> tuple[Erratum, ...]:
    """What the source's methods give for this bearing, where they leave out or mistake what matters."""
    found = []
    if r.raimondi_boyd is not None:
        found.append(
            Erratum(
                f"bearings.{place}.film",
                f"Smallest film, {place}",
                r.raimondi_boyd.film * 1e6,
                "µm",
                "method of Finotti 2013, 5.5.1, on the clearance as given",
                f"The thesis leaves thermal expansion out: its clearance of {r.clearance * 1e6:.1f} µm becomes "
                f"{r.clearance_hot * 1e6:.1f} µm when warm and {r.clearance_cold * 1e6:.1f} µm at the lowest temperature."
                + (" Nor does it know that a groove parts the film." if supply.lands(r.seat.inputs) == 2 else ""),
            )
        )
    if r.din31652 is not None and 0.9 < r.din31652.sommerfeld <= 1:
        with untraced():
            wrong = film_heavily_loaded(r.clearance, r.din31652.sommerfeld, r.seat.bearing.length / r.seat.bearing.diameter)
        found.append(
            Erratum(
                f"bearings.{place}.din31652.film",
                f"Film by DIN 31652, {place}",
                wrong * 1e6,
                "µm",
                "method of Finotti 2013, Table 5.4: the branch of the first pass",
                f"So = {r.din31652.sommerfeld:.3f} is below 1, but the thesis keeps the formula for So > 1 of its first pass.",
            )
        )
    return tuple(found)
