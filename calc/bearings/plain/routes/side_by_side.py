# SPDX-License-Identifier: Apache-2.0
"""The routes side by side on the clearance as given: how far each is from Reynolds' equation, and where it leaves its
range.

Two distances.  In thermal balance every route warms its oil by its own friction and flow: that is what it would have
told its user.  Like with like the film of each is taken at the oil's temperature of Reynolds' solution: what is left is
how well it solves the film.  The spread of the routes is of the second kind and of those that claim to solve it here.
"""

from ....countershaft.rows import called
from ....sheet.errors import NoSolution, text_of
from ....sheet.record import record
from ....sheet.step import Table
from ....sheet.text import Amount, Text
from ....sheet.value import about, untraced
from .. import formulas as f
from ..film.table import FilmRangeError
from .routes import ROUTES
from .states import BearingCase, Film, OperatingPoint, OutsideCharts
from .thermal_balance import balanced

SPREAD = 0.10  # rule of this program
OWN = "reynolds"  # the route that the others are held against


@record
class RouteResultBeside:
    """The routes that have an answer, the distance of each film from the own one, and what is to be said of those
    without."""

    films: dict[str, Film]
    deviations: dict[str, float]  # in thermal balance
    alike: dict[str, float]  # at the oil's temperature of the own solution
    spread: float | None
    silent: dict[str, Text]
    ratio: float  # l/d of the film
    whole: float  # l/d of the bearing, which the source's methods take

    @property
    def outside(self) -> dict[str, Text]:
        """The routes further off in thermal balance than the spread that is allowed, each with the reason."""
        return {name: reason(name, self) for name, far in self.deviations.items() if far > SPREAD}

    @property
    def compared(self) -> dict[str, float]:
        """Those that the spread is of."""
        if self.spread is None:
            return {}
        return {
            name: self.alike[name]
            for name, route in ROUTES.items()
            if name in self.alike and route.counts(self.films[name], self.ratio)
        }


# the values of a bearing that the routes give, of which none judges it
COMPARED = frozenset({"routes_spread", *ROUTES})


def judged_alone(seat: BearingCase, ratio: float) -> RouteResultBeside:
    """No routes beside the one that judges."""
    return RouteResultBeside({}, {}, {}, None, {}, ratio, _whole(seat))


def _whole(seat: BearingCase) -> float:
    return seat.bearing.length / seat.bearing.diameter


def side_by_side(place: str, seat: BearingCase, duty: OperatingPoint, ratio: float) -> RouteResultBeside:
    """`ratio`: l/d of the film."""
    films: dict[str, Film] = {}
    silent: dict[str, Text] = {}
    for name, route in ROUTES.items():
        words = Text("clearance as given") if name == OWN else route.title
        with about(Text("{place} bearing, {title}", place=called(place), title=words)):
            try:
                films[name] = balanced(route.film, seat, duty)
            except (NoSolution, OutsideCharts) as outside:
                silent[name] = text_of(outside)
    whole = _whole(seat)
    own_film = films.get(OWN)
    if own_film is None:
        return RouteResultBeside(films, {}, {}, None, silent, ratio, whole)
    deviations = {name: abs(film.film / own_film.film - 1) for name, film in films.items() if name != OWN}
    alike: dict[str, float] = {}
    spread: float | None = None
    for name in deviations:
        counts = seat.grooves is None and ROUTES[name].counts(films[name], ratio)
        same = _at_the_same_oil(place, name, seat, duty, own_film, shown=counts)
        if same is None:
            continue
        alike[name] = same.film / own_film.film - 1
        if counts:
            far = f.film_deviation(h_0=same.film, reference=own_film.film)
            spread = far if spread is None or far > spread else spread
    return RouteResultBeside(films, deviations, alike, spread, silent, ratio, whole)


def _at_the_same_oil(
    place: str, name: str, seat: BearingCase, duty: OperatingPoint, own_film: Film, *, shown: bool
) -> Film | None:
    """The route's film with the oil as warm as in the own solution; `shown`: by lines of the calculation."""
    route = ROUTES[name]
    try:
        if not shown:
            with untraced():
                return route.film(seat, duty, own_film.temperature_rise)
        with about(Text("{place} bearing, {title}, at the same oil", place=called(place), title=route.title)):
            return route.film(seat, duty, own_film.temperature_rise)
    except (NoSolution, OutsideCharts, FilmRangeError):
        return None


def reason(name: str, side: RouteResultBeside) -> Text:
    """Why a route is far off here: in its film with the same oil, or else in its flow and so its oil's temperature."""
    film, ratio = side.films[name], side.ratio
    if ROUTES[name].whole_length and ratio < side.whole * (1 - 1e-9):
        return Text("it takes the whole length, where the groove parts the film")
    own_film = side.films[OWN]
    if name in side.alike and abs(side.alike[name]) < side.deviations[name] / 2:
        hotter = Text("hotter") if film.temperature_rise > own_film.temperature_rise else Text("cooler")
        flow, own_flow = (Amount(Q * 6e4, form=".3g") for Q in (film.oil_flow, own_film.oil_flow))
        return Text(
            "its flow is {oil_flow} against {oil_flow2} L/min, which leaves its oil {hotter}",
            oil_flow=flow,
            oil_flow2=own_flow,
            hotter=hotter,
        )
    return ROUTES[name].why_off(film, ratio)


def routes_table(place: str, side: RouteResultBeside) -> Table:
    """All that have an answer; the note says why the others have none."""
    rows: list[tuple[str | float | None, ...]] = []
    own_film = side.films.get(OWN)
    for name, film in side.films.items():
        far = None if own_film is None or name == OWN else (film.film / own_film.film - 1) * 100
        same = side.alike.get(name)
        rows.append(
            (
                ROUTES[name].title,
                film.film * 1e6,
                far,
                None if same is None else same * 100,
                film.eccentricity,
                film.sommerfeld,
                film.friction_variable,
                film.friction_power,
                film.temperature_rise,
                film.oil_flow * 6e4,
            )
        )
    columns = (
        (Text("route"), ""),
        (Text("h_0"), "µm"),
        (Text("Δ"), "%"),
        (Text("Δ, same oil"), "%"),
        (Text("ε"), ""),
        (Text("S (ISO, Falz: So)"), ""),
        (Text("f*"), ""),
        (Text("P_f"), "W"),
        (Text("ΔT"), "K"),
        (Text("Q"), "L/min"),
    )
    note = Text(
        "On the clearance as given. The own solution of Reynolds' equation judges, on the warm clearance. Δ: in "
        "thermal balance, each "
        "route with its own flow. Δ, same oil: the film alone, with the oil as warm as in the own solution."
    )
    for name, why in side.outside.items():
        note += Text(" {route}: {why}.", route=ROUTES[name].title, why=why)
    for name, why in side.silent.items():
        note += Text(" {routes} gives no value here: {why}.", routes=ROUTES[name].title, why=why)
    covers = tuple(f"bearings.{place}.{name}." for name in ROUTES)
    title = Text("The routes side by side, {place} bearing", place=called(place))
    return Table(f"routes_{place}", title, columns, tuple(rows), note, covers)
