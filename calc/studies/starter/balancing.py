# SPDX-License-Identifier: Apache-2.0
"""Which balancing an engine calls for: what each leaves in numbers, and why.  The numbers are those of the imbalance
step's remedies."""

from ...design.toml_file import Document, design
from ...engine.result import EngineResult
from ...imbalance.checks import FIRST, SECOND, left_of_half
from ...imbalance.inputs import ImbalanceInputs
from ...imbalance.remedies import SIGNIFICANT, BalancingRemedy
from ...imbalance.result import ImbalanceResult
from ...sheet.errors import NoSolution
from ...sheet.quantity import dotted
from ...sheet.record import record
from ...sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Text
from ...sheet.units import Kilogram
from ...solve import Results, solve
from .several import arrangement, estimated_mass, first_pair, second_shafts
from .shaft import before_shaft, envelope, task

REMEDIES = {  # the remedy of the imbalance step behind each balancing
    "half": "crank",
    "shaft": "backward_shaft",
    "repeat": "backward_shaft",
    "pair": "first_order_pair",
    "second": "second_order_shafts",
    "pair_and_second": "four_shafts",
}
WHATS = {
    "order_1_couple": (Text("couple of order 1"), "N·m"),
    "order_1_force": (Text("force of order 1"), "N"),
    "order_2_couple": (Text("couple of order 2"), "N·m"),
    "order_2_force": (Text("force of order 2"), "N"),
}
LABELS = {
    "none": Text("none"),
    "half": Text("half on the crank"),
    "shaft": Text("one shaft at −ω"),
    "repeat": Text("two shafts at −ω"),
    "pair": Text("a pair at ±ω"),
    "second": Text("a pair at ±2ω"),
    "pair_and_second": Text("pairs at ±ω and ±2ω"),
}

ON_CRANK = dotted(ImbalanceInputs.crank_balance_fraction)
IMBALANCE = {ON_CRANK: 0.5, dotted(ImbalanceInputs.kinematics): "exact"}  # where a design has none yet


@record
class Left:
    """A force or couple of one order, peak over a turn: with the rotating masses alone balanced, and with the
    balancing."""

    key: str
    what: Text
    before: float
    after: float
    unit: str


@record
class Balancing:
    """One way to balance an engine.  `mass`: of the eccentric masses of all its shafts, estimated with the usual
    core; None where they are not sized or there are none."""

    id: str
    label: Text
    left: tuple[Left, ...]
    mass: Kilogram | None
    called_for: bool
    why: Text


def options(document: Document, results: Results | None = None) -> tuple[Balancing, ...]:
    """What there is to choose from for a design whose engine is known.  Raises NoSolution where it is not, BadInput
    where it is wrong."""
    known = with_imbalance(document, results)
    imbalance, engine = known.result(ImbalanceResult), known.result(EngineResult)
    if imbalance is None or engine is None:
        raise NoSolution(Text("what shakes is not known"), EMPTY, Text("give [engine] first"))
    best = _called_for(imbalance, engine.lambda_)
    first = _before(imbalance, "order_1_force") or _before(imbalance, "order_1_couple")
    there = [id for id, name in REMEDIES.items() if name in imbalance.remedy and (id != "half" or first)]
    if "repeat" in there and not _backward(imbalance)[0]:
        there.remove("repeat")
    if "pair_and_second" in there and not _roughest(imbalance, engine.lambda_):
        there.remove("pair_and_second")
    return tuple(
        Balancing(
            id, _label(id, imbalance), _left(imbalance, id), _mass(known, id), id == best, _why(id, best, imbalance)
        )
        for id in ("none", *there)
    )


def called_for(results: Results) -> str:
    """The id of the balancing that the engine of a design with an imbalance calls for."""
    imbalance, engine = results.result(ImbalanceResult), results.result(EngineResult)
    if imbalance is None or engine is None:
        raise NoSolution(Text("what shakes is not known"), EMPTY, Text("give [engine] and [imbalance]"))
    return _called_for(imbalance, engine.lambda_)


def what_shakes(results: Results) -> Text:
    """What the engine leaves with its rotating masses alone balanced, in few words."""
    phrases = []
    for n, force, couple in _shaking(results):
        sizes = dict(n=n, force=Amount(force, "N"), couple=Amount(couple, "N·m"))
        if couple and force:
            phrases.append(Text("order {n}: force {force}, couple {couple}", **sizes))
        elif force:
            phrases.append(Text("force of order {n}: {force}", n=n, force=sizes["force"]))
        else:
            phrases.append(Text("couple of order {n}: {couple}", n=n, couple=sizes["couple"]))
    return SEMICOLON.join(phrases) if phrases else Text("nothing of order 1 or 2")


def shakes_briefly(results: Results) -> Text:
    """The same in a column of a table: the unit tells a force from a couple."""
    phrases = []
    for n, force, couple in _shaking(results):
        amounts = [
            Text("{size}", size=Amount(size, unit, digits=3)) for size, unit in ((force, "N"), (couple, "N·m")) if size
        ]
        phrases.append(Text("order {n}: {size}", n=n, size=COMMA.join(amounts)))
    return SEMICOLON.join(phrases) if phrases else Text("nothing of order 1 or 2")


def _shaking(results: Results) -> list[tuple[int, float, float]]:
    """Order, force and couple of what shakes."""
    imbalance = results.result(ImbalanceResult)
    if imbalance is None:
        raise NoSolution(Text("what shakes is not known"), EMPTY, Text("give [engine] first"))
    orders = [(n, _before(imbalance, f"order_{n}_force"), _before(imbalance, f"order_{n}_couple")) for n in (1, 2)]
    return [(n, force, couple) for n, force, couple in orders if force or couple]


def with_imbalance(document: Document, results: Results | None = None) -> Results:
    """Engine and imbalance of a design solved; an imbalance that is missing with its usual values."""
    if results is not None and results.result(ImbalanceResult) is not None:
        return results
    return solve(design(Document({"imbalance": IMBALANCE, **before_shaft(document)})))


# --- the numbers


def _before(imbalance: ImbalanceResult, key: str) -> float:
    """The peak of an order without any balancing but that of the rotating masses; 0 where it is none."""
    _, n, what = key.split("_")
    order = imbalance.orders[f"order_{n}"]
    F_f, F_b, C_f, C_b = order.unbalanced if n == "1" else order.vectors
    if what == "force":
        peak, single = abs(F_f) + abs(F_b), imbalance.one_force
    else:
        peak, single = abs(C_f) + abs(C_b), imbalance.one_couple
    return float(peak) if peak > SIGNIFICANT * single else 0.0


def _left(imbalance: ImbalanceResult, id: str) -> tuple[Left, ...]:
    remedy: BalancingRemedy | None = imbalance.remedy[REMEDIES[id]] if id in REMEDIES else None
    left = []
    for key, (what, unit) in WHATS.items():
        before, leaves = _before(imbalance, key), remedy
        if id == "second" and key.startswith("order_1"):
            leaves = imbalance.remedy["crank"]
        after = before if leaves is None else float(getattr(leaves, key))
        single = imbalance.one_force if unit == "N" else imbalance.one_couple
        after = after if after > SIGNIFICANT * single else 0.0
        if before or after:
            left.append(Left(key, what, before, after, unit))
    return tuple(left)


def _mass(results: Results, id: str) -> Kilogram | None:
    """Of the eccentric masses of all shafts, in the envelope that they would get."""
    imbalance = results.result(ImbalanceResult)
    assert imbalance is not None
    try:
        if id == "shaft":
            return float(envelope(results.design, results, task(results, -1)).sized.mass)
        return sum(estimated_mass(results, one) for one in arrangement(id, imbalance)) or None
    except NoSolution:
        return None


# --- what is called for


def _called_for(imbalance: ImbalanceResult, lam: float) -> str:
    """A shaft where anything of order 1 turns backward; else the crank's half, a pair at ±2 for a force of order 2, or
    nothing."""
    F_f, F_b, C_f, C_b = (abs(v) for v in imbalance.orders["order_1"].unbalanced)
    force, couple = FIRST * imbalance.one_force, FIRST * imbalance.one_couple
    if F_b > force or C_b > couple:
        return "shaft"
    if F_f > force or C_f > couple:
        return "half"
    return "second" if _roughest(imbalance, lam) and second_shafts(imbalance) else "none"


def _roughest(imbalance: ImbalanceResult, lam: float) -> bool:
    """Whether the force of order 2 counts: its couple is lived with."""
    return _before(imbalance, "order_2_force") > SECOND * lam * imbalance.one_force


def _label(id: str, imbalance: ImbalanceResult) -> Text:
    if id == "second" and (shafts := second_shafts(imbalance)) is not None and not shafts[1]:
        return Text("one shaft at +2ω") if shafts[0] > 0 else Text("one shaft at −2ω")
    return LABELS[id]


def _why(id: str, best: str, imbalance: ImbalanceResult) -> Text:
    """One short sentence."""
    force, couple = _backward(imbalance)
    if id == "none" and best == "none":
        return Text("Order 1 cancels, and what is left of order 2 is lived with.")
    if id == "none":
        return Text("What shakes is left to the mounts.")
    if id in ("half", "shaft", "repeat") and _forward_left(imbalance):
        return Text(
            "Half on the crank, opposite the pins, leaves much of what turns forward: the offsets turn it away from "
            "them."
        )
    if id == "half":
        if force or couple:
            return Text("Counterweights take what turns forward; what turns backward stays.")
        return Text("Counterweights take all of order 1: nothing of it turns backward.")
    if id == "shaft":
        if force:
            return Text(
                "With half on the crank it takes order 1 whole; its force rolls the engine where it stands beside the "
                "crank."
            )
        return Text("With half on the crank it takes the couple of order 1 whole.")
    if id == "repeat":
        return Text(
            "Two that turn alike, one on each side of the crank, take order 1 whole and do not roll the engine."
        )
    if id == "pair" and first_pair(imbalance):
        return Text("It takes order 1 without counterweights and without roll.")
    if id == "second" and second_shafts(imbalance) is not None:
        if best == "second":
            return Text("Order 1 cancels; the force of order 2 is what is felt.")
        return Text("It takes order 2, where the comfort is worth it, and no more of order 1 than the crank.")
    if id in ("pair", "second"):
        return Text("Shafts that are no mirror images would take it: write each as a shaft of its own.")
    return Text("Four shafts leave nothing of order 1 or 2.")


def _forward_left(imbalance: ImbalanceResult) -> bool:
    """Whether half on the crank leaves a force or couple that turns forward and counts."""
    force, couple = left_of_half(imbalance)
    return force > FIRST * imbalance.one_force or couple > FIRST * imbalance.one_couple


def _backward(imbalance: ImbalanceResult) -> tuple[bool, bool]:
    """Whether a force, and whether a couple of order 1 turns backward."""
    _, F_b, _, C_b = (abs(v) for v in imbalance.orders["order_1"].unbalanced)
    return F_b > FIRST * imbalance.one_force, C_b > FIRST * imbalance.one_couple
