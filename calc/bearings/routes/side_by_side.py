# SPDX-License-Identifier: Apache-2.0
"""The four routes side by side on the clearance as given: how far each is from Reynolds' equation, and where it leaves its range."""

from math import pi

from ...sheet.errors import NoSolution, text_of
from ...sheet.record import record
from ...sheet.step import Table
from ...sheet.text import COMMA, Amount, Text
from ...sheet.trace import about
from .. import formulas as f
from ..film.table import eccentricity_from
from ..inputs import IN_WORDS
from .balance import balanced
from .routes import Route, falz, own_cold, raimondi_boyd, raimondi_boyd_own_flow, short_bearing
from .states import BearingCase, Film, OperatingPoint, OutsideCharts

SPREAD = 0.10  # rule of this program
ROUTES: dict[str, tuple[Text, Route]] = {
    "reynolds": (Text("Reynolds' equation"), own_cold),
    "raimondi_boyd": (Text("Raimondi & Boyd, supply flow of the thesis"), raimondi_boyd),
    "raimondi_boyd_own_flow": (Text("Raimondi & Boyd, own flow"), raimondi_boyd_own_flow),
    "falz": (Text("Falz, as the thesis uses it"), falz), "short_bearing": (Text("short bearing"), short_bearing),
}  # fmt: skip
FALZ_MEETS = 1.0  # l/d at which Falz's two branches meet
SHORT_UP_TO, SHORT_ECCENTRICITY = 0.25, 0.5  # where the short bearing stays within a tenth in the load


@record
class Side:
    """The routes that have an answer, the distance of each film from the own one, and what is to be said of those without."""

    films: dict[str, Film]
    deviations: dict[str, float]
    spread: float | None
    silent: dict[str, Text]

    @property
    def outside(self) -> dict[str, str]:
        """The routes further off than the spread that is allowed, each with the reason."""
        return {name: reason(name, self) for name, far in self.deviations.items() if far > SPREAD}

    ratio: float  # l/d of the film
    whole: float  # l/d of the bearing, which the source's methods take


def side_by_side(place: str, seat: BearingCase, duty: OperatingPoint, ratio: float) -> Side:
    """`ratio`: l/d of the film."""
    films: dict[str, Film] = {}
    silent: dict[str, Text] = {}
    for name, (title, route) in ROUTES.items():
        words = Text("clearance as given") if name == "reynolds" else title
        with about(Text("{place} bearing, {title}", place=IN_WORDS[place], title=words)):
            try:
                films[name] = balanced(route, seat, duty)
            except (NoSolution, OutsideCharts) as outside:
                silent[name] = text_of(outside)
    own = films.get("reynolds")
    deviations = {} if own is None else {n: f.film_deviation(h_0=r.film, reference=own.film) for n, r in films.items() if n != "reynolds"}
    whole = seat.bearing.length / seat.bearing.diameter
    return Side(films, deviations, max(deviations.values(), default=None), silent, ratio, whole)


def reason(name: str, side: Side) -> Text:
    """Why a route is far off here: in its film at the same Sommerfeld number, or else in its flow and so its oil's temperature."""
    film, ratio = side.films[name], side.ratio
    if name != "short_bearing" and ratio < side.whole * (1 - 1e-9):
        return Text("it takes the whole length, where the groove parts the film")
    own = side.films["reynolds"]
    S = 1 / (2 * pi * film.sommerfeld) if name == "falz" else film.sommerfeld
    exact = 1 - float(eccentricity_from(S, ratio, outside="nan"))
    l_d, So = Amount(ratio, form=".3g"), Amount(film.sommerfeld, form=".3g")
    if exact > 0 and abs((1 - film.eccentricity) / exact - 1) < side.deviations[name] / 2:
        hotter = Text("hotter") if film.temperature_rise > own.temperature_rise else Text("cooler")
        flow, own_flow = (Amount(Q * 6e4, form=".3g") for Q in (film.oil_flow, own.oil_flow))
        return Text(
            "its flow is {oil_flow} against {oil_flow2} L/min, which leaves its oil {hotter}",
            oil_flow=flow,
            oil_flow2=own_flow,
            hotter=hotter,
        )
    if name.startswith("raimondi_boyd"):
        return Text("its cubic in d/l errs between the charts of l/d 1, ½, ¼: l/d is {ratio}", ratio=l_d)
    if name == "falz":
        return Text(
            "Falz's two branches meet only at l/d = {falz_meets}: l/d is {ratio}, So = {sommerfeld} lies {branch} 1",
            falz_meets=Amount(FALZ_MEETS, form="g"), ratio=l_d, sommerfeld=So,
            branch=Text("above") if film.sommerfeld > 1 else Text("below"),
        )  # fmt: skip
    parts = []
    if ratio > SHORT_UP_TO:
        parts.append(Text("l/d {ratio} is above {short_up_to}", ratio=l_d, short_up_to=Amount(SHORT_UP_TO, form="g")))
    if film.eccentricity > SHORT_ECCENTRICITY:
        eps, most = Amount(film.eccentricity, form=".3g"), Amount(SHORT_ECCENTRICITY, form="g")
        parts.append(Text("ε {eccentricity} above {short_eccentricity}", eccentricity=eps, short_eccentricity=most))
    why = COMMA.join(parts) if parts else Text("its film is too thick")
    return Text("it leaves the pressure's flow around the shaft out: {parts}", parts=why)


def routes_table(place: str, side: Side) -> Table:
    """All that have an answer; the note says why the others have none."""
    rows: list[tuple[str | float | None, ...]] = []
    own = side.films.get("reynolds")
    for name, film in side.films.items():
        far = None if own is None else (film.film / own.film - 1) * 100
        rows.append((
            ROUTES[name][0], film.film * 1e6, None if name == "reynolds" else far, film.eccentricity, film.sommerfeld,
            film.friction_variable, film.friction_power, film.temperature_rise, film.oil_flow * 6e4,
        ))  # fmt: skip
    columns = (
        (Text("route"), ""), (Text("h_0"), "µm"), (Text("Δ"), "%"), (Text("ε"), ""), (Text("S (Falz: So)"), ""), (Text("f*"), ""),
        (Text("P_f"), "W"), (Text("ΔT"), "K"), (Text("Q"), "L/min"),
    )  # fmt: skip
    note = Text("On the clearance as given. The own solution of Reynolds' equation judges, on the warm clearance.")
    for name, why in side.outside.items():
        note += Text(" {route}: {why}.", route=ROUTES[name][0], why=why)
    for name, why in side.silent.items():
        note += Text(" {routes} gives no value here: {why}.", routes=ROUTES[name][0], why=why)
    covers = tuple(f"bearings.{place}.{name}." for name in ROUTES)
    title = Text("Four routes side by side, {place} bearing", place=IN_WORDS[place])
    return Table(f"routes_{place}", title, columns, tuple(rows), note, covers)
