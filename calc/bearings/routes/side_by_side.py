# SPDX-License-Identifier: Apache-2.0
"""The four routes side by side on the clearance as given: how far each is from Reynolds' equation, and where it leaves its range."""

from math import pi

from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.step import Table
from ...sheet.trace import about
from .. import formulas as f
from ..film.table import eccentricity_from
from .balance import balanced
from .raimondi_boyd import OutsideCharts
from .routes import Route, din31652, own_cold, raimondi_boyd, short_bearing
from .states import Duty, Film, Seat

SPREAD = 0.10  # rule of this program
ROUTES: dict[str, tuple[str, Route]] = {
    "reynolds": ("Reynolds' equation", own_cold),
    "raimondi_boyd": ("Raimondi & Boyd", raimondi_boyd),
    "din31652": ("DIN 31652", din31652),
    "short_bearing": ("short bearing", short_bearing),
}
FALZ_MEETS = 1.0  # l/d at which Falz's two branches meet
SHORT_UP_TO, SHORT_ECCENTRICITY = 0.25, 0.5  # where the short bearing stays within a tenth in the load


@record
class Side:
    """The routes that have an answer, the distance of each film from the own one, and what is to be said of those without."""

    films: dict[str, Film]
    deviations: dict[str, float]
    spread: float | None
    silent: dict[str, str]

    @property
    def outside(self) -> dict[str, str]:
        """The routes further off than the spread that is allowed, each with the reason."""
        return {name: reason(name, self) for name, far in self.deviations.items() if far > SPREAD}

    ratio: float  # l/d of the film
    whole: float  # l/d of the bearing, which the source's methods take


def side_by_side(place: str, seat: Seat, duty: Duty, ratio: float) -> Side:
    """`ratio`: l/d of the film."""
    films: dict[str, Film] = {}
    silent: dict[str, str] = {}
    for name, (title, route) in ROUTES.items():
        with about(f"{place} bearing, {title if name != 'reynolds' else 'clearance as given'}"):
            try:
                films[name] = balanced(route, seat, duty)
            except (NoSolution, OutsideCharts) as outside:
                silent[name] = str(outside)
    own = films.get("reynolds")
    deviations = {} if own is None else {n: f.film_deviation(h_0=r.film, reference=own.film) for n, r in films.items() if r is not own}
    whole = seat.bearing.length / seat.bearing.diameter
    return Side(films, deviations, max(deviations.values(), default=None), silent, ratio, whole)


def reason(name: str, side: Side) -> str:
    """Why a route is far off here: in its film at the same Sommerfeld number, or else in its flow and so its oil's temperature."""
    film, ratio = side.films[name], side.ratio
    if name != "short_bearing" and ratio < side.whole * (1 - 1e-9):
        return "it takes the whole length, where the groove parts the film"
    own = side.films["reynolds"]
    S = 1 / (2 * pi * film.sommerfeld) if name == "din31652" else film.sommerfeld
    exact = 1 - float(eccentricity_from(S, ratio, outside="nan"))
    if exact > 0 and abs((1 - film.eccentricity) / exact - 1) < side.deviations[name] / 2:
        hotter = "hotter" if film.temperature_rise > own.temperature_rise else "cooler"
        return f"its flow is {film.oil_flow * 6e4:.3g} against {own.oil_flow * 6e4:.3g} L/min, which leaves its oil {hotter}"
    if name == "raimondi_boyd":
        return f"its cubic in d/l errs between the charts of l/d 1, ½, ¼: l/d is {ratio:.3g}"
    if name == "din31652":
        branch = "above" if film.sommerfeld > 1 else "below"
        return f"Falz's two branches meet only at l/d = {FALZ_MEETS:g}: l/d is {ratio:.3g}, So = {film.sommerfeld:.3g} lies {branch} 1"
    parts = []
    if ratio > SHORT_UP_TO:
        parts.append(f"l/d {ratio:.3g} is above {SHORT_UP_TO:g}")
    if film.eccentricity > SHORT_ECCENTRICITY:
        parts.append(f"ε {film.eccentricity:.3g} above {SHORT_ECCENTRICITY:g}")
    return f"it leaves the pressure's flow around the shaft out: {', '.join(parts) or 'its film is too thick'}"


def routes_table(place: str, side: Side) -> Table:
    """All that have an answer; the note says why the others have none."""
    rows: list[tuple[str | float | None, ...]] = []
    own = side.films.get("reynolds")
    for name, film in side.films.items():
        far = None if own is None else (film.film / own.film - 1) * 100
        rows.append((
            ROUTES[name][0], film.film * 1e6, None if film is own else far, film.eccentricity, film.sommerfeld, film.friction_variable,
            film.friction_power, film.temperature_rise, film.oil_flow * 6e4,
        ))  # fmt: skip
    columns = (
        ("route", ""), ("h_0", "µm"), ("Δ", "%"), ("ε", ""), ("S (DIN: So)", ""), ("f*", ""), ("P_f", "W"), ("ΔT", "K"), ("Q", "L/min"),
    )  # fmt: skip
    note = "On the clearance as given. The own solution of Reynolds' equation judges, on the warm clearance."
    for name, why in side.outside.items():
        note += f" {ROUTES[name][0]}: {why}."
    for name, why in side.silent.items():
        note += f" {ROUTES[name][0]} gives no value here: {why}."
    covers = tuple(f"bearings.{place}.{name}." for name in ROUTES)
    return Table(f"routes_{place}", f"Four routes side by side, {place} bearing", columns, tuple(rows), note, covers)
