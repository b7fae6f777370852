# SPDX-License-Identifier: Apache-2.0
"""What the constants do that the literature leaves open: one by one to the ends of what they may be, the whole balance
closed anew.

A range is what the sources support: the spread of published values where there are several, else a rule of this
program, and it says which."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.record import record, replace
from ...sheet.step import Curve, Series, Table, axis_label
from ...sheet.text import Amount, Text, listed
from ...sheet.units import Number, Watt
from ...sheet.value import untraced
from ..inputs import FrictionInputs
from ..losses.oil_and_air import AIR_DENSITY
from ..mesh.geometry import column
from ..mesh.mixed import LOAD_SHARES, PUBLISHED, Surfaces
from ..power_balance import TrainDrive, drive, losses_of

WARMER = 10.0  # K
DUST = 1e-9  # of the losses: what the last digits make
# the two laws of each kind in words
LAWS = {"barus": Text("Barus"), "roelands": Text("Roelands")}
SHARINGS = {"linear": Text("linear"), "smooth": Text("smooth")}
FILMS = {"judged": Text("by regime, with rolling"), "source": Text("EHL everywhere, no rolling")}


@record
class Swing:
    """One constant: what it is, its symbol, its two ends in words, the power at each end (None: no solution there), and
    why this far."""

    name: Text
    symbol: str
    low: Text
    high: Text
    at_low: Watt | None
    at_high: Watt | None
    why: Text

    def span(self, nominal: Watt) -> Watt:
        ends = [P for P in (self.at_low, self.at_high) if P is not None]
        span = max((*ends, nominal)) - min((*ends, nominal))
        return span if span > DUST * abs(nominal) else 0.0


def swings(d: TrainDrive, power: Watt | None, nominal: Watt) -> tuple[Swing, ...]:
    """The losses of the train with each constant at its ends, the widest first."""
    with untraced(), np.errstate(all="ignore"):
        swings = [*_numbers(d, power), *_laws(d, power, nominal)]
    return tuple(sorted(swings, key=lambda swing: -swing.span(nominal)))


def _numbers(d: TrainDrive, power: Watt | None) -> list[Swing]:
    """The constants that are numbers: all ends of all of them at once."""
    f = d.friction
    Lambda, mu_s, rho_m = d.oil.Lambda, _rubbing(d).mu_s, f.mist_density
    shown = listed(Text("{Ra}", Ra=Amount(Ra * 1e6)) for Ra in f.flank_roughness)
    mist = min(AIR_DENSITY, rho_m), 2 * rho_m
    # each with its nominal value, its ends, what it is, its symbol, its ends in words, and why this far
    open_: list[tuple[str, float, tuple[float, float], Text, str, tuple[Text, Text], Text]] = []
    ends, words = _about(Lambda, 0.4), _both(*_about(Lambda, 0.4))
    why = Text("as given, ±40 %") if d.lubricant.oil.limiting_shear is not None else Text("by base stock, ±40 %")
    open_.append(("Lambda", Lambda, ends, Text("limiting shear Λ"), "Λ", words, why))
    words, why = (Text("−20 %"), Text("+20 %")), Text("published laws for one oil differ so much")
    open_.append(("thickening", 1.0, _about(1.0, 0.2), Text("pressure-viscosity α"), "α", words, why))
    words, why = (Text("{shown} µm −30 %", shown=shown), Text("+30 %")), Text("new to run-in flanks, own rule")
    open_.append(("rough", 1.0, _about(1.0, 0.3), Text("flank roughness Ra"), "Ra", words, why))
    ends, why = _about(mu_s, 0.2), Text("±20 %, the spread of the literature")
    if f.solid_friction is None and f.film == "judged":
        ends, why = PUBLISHED, Text("published for lubricated steel")
    open_.append(("mu_s", mu_s, ends, Text("friction of the solids μ_s"), "μ_s", _both(*ends), why))
    words = Text("{low} kg/m³", low=Amount(mist[0])), Text("{high} kg/m³", high=Amount(mist[1]))
    why = Text("air alone to twice what is assumed")
    open_.append(("mist", rho_m, mist, Text("density of the oil mist"), "mist", words, why))
    if f.bulk_temperature is None and f.bulk == "oil":
        T, hot = d.T_oil, d.T_oil + WARMER
        words = Text("{t} °C", t=Amount(T)), Text("{t} °C", t=Amount(hot))
        why = Text("taken as the oil's; often some 10 K above")
        open_.append(("bulk", T, (T, hot), Text("temperature of the teeth"), "T_b", words, why))
    at = {key: np.full(2 * len(open_), nominal) for key, nominal, *_ in open_}
    for i, (key, _, ends, *_) in enumerate(open_):
        at[key][2 * i : 2 * i + 2] = ends
    together = _ends(d, power, at)
    P: list[Watt | None]
    if together is not None:
        P = list(together)
    else:  # some end has no solution: one by one then
        P = [_ends(d, power, {key: values[k : k + 1] for key, values in at.items()}) for k in range(2 * len(open_))]
    return [
        Swing(name, symbol, *words, _number(P[2 * i]), _number(P[2 * i + 1]), why)
        for i, (_, _, _, name, symbol, words, why) in enumerate(open_)
    ]


def _ends(d: TrainDrive, power: Watt | None, at: Mapping[str, Array]) -> Any:
    """The losses at many ends at once, `at` holding every constant at each of them; None where one has no
    solution."""
    f = d.friction
    open_: dict[str, Any] = {
        "flank_roughness": tuple(column(Ra * at["rough"]) for Ra in f.flank_roughness),
        "solid_friction": column(at["mu_s"]),
        "mist_density": at["mist"],
        "bulk_temperature": at.get("bulk", f.bulk_temperature),
    }
    return _power(d, replace(f, **open_), power, Lambda=column(at["Lambda"]), thickening=column(at["thickening"]))


def _number(P: Watt | None) -> Watt | None:
    return None if P is None else float(np.squeeze(P))


def _about(x: float, share: float) -> tuple[float, float]:
    return x * (1 - share), x * (1 + share)


def _both(low: float, high: float) -> tuple[Text, Text]:
    return Text("{low}", low=Amount(low)), Text("{high}", high=Amount(high))


def _rubbing(d: TrainDrive) -> Surfaces:
    """How the flanks rub in the model that is judged."""
    return next(iter(d.cases.values())).rubbing(d.friction.film == "judged")


def _laws(d: TrainDrive, power: Watt | None, nominal: Watt) -> list[Swing]:
    """The laws between which one has to choose: the one that is taken stands at the nominal value."""
    f = d.friction
    swings = []

    def other(name: Text, symbol: str, laws: tuple[Text, Text], why: Text, changed: FrictionInputs) -> None:
        swings.append(Swing(name, symbol, *laws, nominal, _number(_power(d, changed, power)), why))

    if all(mesh.spur for mesh in d.meshes.values()):
        why, sharing = Text("flanks as generated, or both tips relieved"), _other(SHARINGS, f.load_sharing)
        laws = SHARINGS[f.load_sharing], SHARINGS[sharing]
        other(Text("load sharing of two pairs"), "X_Γ", laws, why, replace(f, load_sharing=sharing))
    taken = "roelands" if _rubbing(d).roelands else "barus"
    law = _other(LAWS, taken)
    laws, changed = (LAWS[taken], LAWS[law]), replace(f, pressure_law=law)
    other(Text("viscosity under pressure"), "η(p)", laws, Text("two laws"), changed)
    if f.film == "judged":
        swings.append(_shares(d, power, nominal))
    why, film = Text("the friction source's model, or by Johnson's regimes"), _other(FILMS, f.film)
    other(Text("film"), "film", (FILMS[f.film], FILMS[film]), why, replace(f, film=film))
    if f.film == "judged":
        P, why = _number(_power(d, f, power, rolling=False)), Text("the bound supposes a full inlet")
        name, ends = Text("rolling of the rigid film"), (Text("none: a starved inlet"), Text("full inlet"))
        swings.append(Swing(name, "rolling", *ends, P, nominal, why))
    if d.masses:
        why, name = Text("no measurement was found"), Text("loss of the turning masses")
        least, most = ({s: (m.mass_loss_low, m.mass_loss_high)[end] for s, m in d.masses.items()} for end in (0, 1))
        ends = Text("closed cylinders"), Text("with plates in air at rest")
        swings.append(Swing(name, "P_M", *ends, _with_masses(d, power, least), _with_masses(d, power, most), why))
    return swings


def _with_masses(d: TrainDrive, power: Watt | None, losses: Mapping[str, Watt]) -> Watt | None:
    """The power of the train's losses where the turning masses lose so much; None where it has no solution."""
    masses = {name: replace(loss, mass_loss=losses[name]) for name, loss in d.masses.items()}
    try:
        return losses_of(replace(d, masses=masses), power).total
    except NoSolution:
        return None


def _other(laws: Mapping[str, Text], taken: str) -> str:
    return next(law for law in laws if law != taken)


def _shares(d: TrainDrive, power: Watt | None, nominal: Watt) -> Swing:
    """All published load shares: the ends are those that cost least and most."""
    f, title = d.friction, LOAD_SHARES[d.friction.load_share].title
    costs = {f.load_share: nominal}
    for name in LOAD_SHARES:
        P = nominal if name == f.load_share else _number(_power(d, replace(f, load_share=name), power))
        if P is not None:
            costs[name] = P
    low, high = min(costs, key=lambda name: costs[name]), max(costs, key=lambda name: costs[name])
    why = Text("the five published laws; taken is that of {title}", title=title)
    ends = LOAD_SHARES[low].title, LOAD_SHARES[high].title
    return Swing(Text("load share of the roughness"), "ξ(λ)", *ends, costs[low], costs[high], why)


def _power(
    d: TrainDrive,
    friction: FrictionInputs,
    power: Watt | None,
    *,
    Lambda: Number | None = None,
    thickening: Number | None = None,
    rolling: bool = True,
) -> Watt | None:
    """The power of the train's losses under other constants; None where one of them has no solution."""
    first_speed = d.wheels[d.first].speed
    try:
        other = drive(
            friction, d.links, d.lubricant, d.T_oil, first_speed, d.ends, d.forces, d.lubrication, Lambda, thickening
        )
        return losses_of(replace(other, rolling=rolling), power).total
    except NoSolution:
        return None


# --- shown


def tornado(swings: tuple[Swing, ...], nominal: Watt) -> tuple[Curve, Table]:
    """Bars of what each constant changes, the widest first, and the numbers behind them."""
    places = np.arange(1.0, len(swings) + 1)
    low = np.array([0.0 if s.at_low is None else s.at_low - nominal for s in swings])
    high = np.array([0.0 if s.at_high is None else s.at_high - nominal for s in swings])
    series = Series(Text("low end"), places, low), Series(Text("high end"), places, high)
    names = tuple(s.name for s in swings)
    x_label = Text(", ").join(f"{i} {s.symbol}" for i, s in enumerate(swings, 1))
    title = Text("What the open constants of mesh and mist change in the power lost")
    curve = Curve("open_constants", title, x_label, axis_label("ΔP", "W"), series, bars=True, names=names, short=1)
    rows = tuple((s.name, s.low, s.high, s.at_low, s.at_high, s.span(nominal), s.why) for s in swings)
    columns = (
        (Text("Constant"), ""),
        (Text("Low end"), ""),
        (Text("High end"), ""),
        (Text("P at low"), "W"),
        (Text("P at high"), "W"),
        (Text("Span"), "W"),
        (Text("Why this far"), ""),
    )
    note = Text(
        "One constant at a time, the whole balance closed anew; as assumed {nominal} W. The ends are no "
        "tolerances: no probability is implied.",
        nominal=Amount(nominal),
    )
    if any(s.at_low is None or s.at_high is None for s in swings):
        note += Text(" An empty cell: no solution with the constant there.")
    return curve, Table("tornado", Text("Sensitivity to what the literature leaves open"), columns, rows, note)
