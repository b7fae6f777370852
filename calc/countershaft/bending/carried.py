# SPDX-License-Identifier: Apache-2.0
"""How the supports share what turns with the shaft: each gives way by its own law, and the shaft bends between them.

Every support is round: what it does to a journal depends on how far that is off its middle, and turns with it.  Of a
journal displaced by x = e·û it takes the load P = F(e)·e^{iφ(e)}·û (`Law`); K_c·x + P(x) = f_c is solved by Newton's
method on the real and imaginary parts.  All numbers stand in the frame of the shaft, in SI."""

import cmath
import math
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, Generic, NamedTuple, Protocol, TypeAlias

import numpy as np

from ...sheet.arrays import Array, BoolArray, ComplexArray, IndexArray, Value
from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.text import COMMA, Amount, Text
from ...sheet.units import Metre, Newton, NewtonPerMetre, Number
from ...sheet.value import based_on, recorder
from . import formulas as f
from .condensed import Condensed

# --- what a support is


class Hold(NamedTuple, Generic[Value]):
    """What a support does to a journal at a distance e from its middle: its load F, dF/de, and F/e, N/m, at the middle
    the limit of it; the angle by which the load is ahead of the displacement, rad, and its slope, rad/m."""

    force: Value
    slope: Value
    secant: Value
    attitude: Value | float = 0.0
    turning: Value | float = 0.0


class Law(Protocol):
    """What Newton's method asks of a support."""

    def hold(self, e: Metre) -> Hold: ...

    def hold_many(self, e: Array) -> Hold[Array]:
        """The same at many distances, nan where there is no answer."""

    def begin(self, F: Newton) -> Metre:
        """Where a journal that it may have to hold with F is looked for first."""

    def farthest(self, e: Metre) -> Metre:
        """How far from the middle a step from e may lead."""

    def softer(self, share: Number) -> "Law":
        """The same with a share of its stiffness; itself, if it holds the journal wherever that is."""

    def said(self, name: str, e: Metre) -> Text:
        """What a user knows it by, and what is wrong where the journal is at e."""


@record
class Spring:
    """A support that gives way by its load over k, N/m."""

    k: NewtonPerMetre

    def hold(self, e: Metre) -> Hold:
        return Hold(self.k * e, self.k, self.k)

    def hold_many(self, e: Array) -> Hold[Array]:
        k = np.full(e.shape, self.k)
        return Hold(self.k * e, k, k, np.zeros(e.shape), np.zeros(e.shape))

    def begin(self, F: Newton) -> Metre:
        return F / self.k

    def farthest(self, e: Metre) -> Metre:
        return math.inf

    def softer(self, share: Number) -> "Spring":
        return self

    def said(self, name: str, e: Metre) -> Text:
        return Text("support {name}: {k}", name=name, k=Amount(self.k / 1e3, "N/mm"))


@record
class Rigid:
    """A support that does not give way."""


AnyLaw: TypeAlias = Law | Rigid


# --- the shaft on them

LEAST = 0.01  # of the largest f_c: where there is less, the journal begins in the middle of its support
SETTLED = 1e-10  # of the largest f_c: what may be missing to equilibrium
STEPS = 60
HALVINGS = 40  # a step that has to be shorter than this leads nowhere
SOFTENED = (1e-3, 1e-2, 0.1, 1.0)  # of their stiffness, one after the other: supports with play, where all else fails


@record
class Carried:
    """The shaft on its N supports: displacements x of its journals, loads, tilts θ of its sections there.

    `stiffness`, N/m: of each support to a load that stands, infinite of a rigid one, 0 of one that does not touch.
    `steps`: Newton's, of the last attempt."""

    x: ComplexArray
    load: ComplexArray
    theta: ComplexArray
    stiffness: Array
    steps: int


def carried(
    shaft: Condensed,
    laws: Sequence[AnyLaw],
    names: Sequence[str] = (),
    name: str = "the shaft",
    near: ComplexArray | None = None,
) -> Carried:
    """The loads of the supports [N], displacements [m] and tilts [rad] of the journals there, complex as they turn with
    the shaft (`Carried`).

    `shaft`: of `condensed`; `laws`: what holds each support, front to rear: `Rigid()`, a `Spring` of k > 0
    [N/m], or a law with play.  `names` of the supports and `name` of the shaft are what an error calls them; `near`:
    displacements [m] from which is looked first, where they are known.

    Raises NoSolution where no equilibrium is found: by Newton's method from the loads of rigid supports, from there
    with all supports that have play made soft and stiff again."""
    rows = [i for i, law in enumerate(laws) if not isinstance(law, Rigid)]
    free = [law for law in laws if not isinstance(law, Rigid)]
    equation = _equation(shaft, rows)
    begun = _begun(equation, free) if near is None else _now(equation, free, near[rows].tolist())
    now, found = _newton(equation, free, begun)
    for share in () if found else SOFTENED:
        softened = [law.softer(share) for law in free]
        now, found = _newton(equation, softened, _now(equation, softened, now.x))
    if not found:
        called = [names[i] if names else str(i + 1) for i in rows]
        raise NoSolution(
            Text("bearings of {name} find no common place", name=name),
            COMMA.join(law.said(row, abs(x)) for law, row, x in zip(free, called, now.x)),
        )
    x = np.zeros(len(laws), dtype=complex)
    x[rows] = now.x
    load = shaft.f_c - shaft.K_c @ x
    load[rows] = now.load
    if recorder.get() is not None:  # of the passes to the heat nobody asks what they were found from
        x = based_on(x, shaft.f_c, *laws)
    load = f.shared_load(K_c=shaft.K_c, f_c=shaft.f_c, x=x, P=load)
    tangents = np.full((2, len(laws)), math.inf)
    tangents[:, rows] = [[held.slope for held in now.held], [held.secant for held in now.held]]
    return Carried(
        x=based_on(x, load),
        load=load,
        theta=f.tilted(theta_0=shaft.theta_0, Theta=shaft.Theta, x=x),
        stiffness=based_on(f.mean_stiffness(k_t=tangents[0], k_s=tangents[1]), load),
        steps=now.step,
    )


def carried_near(
    shaft: Condensed, hold: Callable[[Array], Hold[Array]], x: ComplexArray
) -> tuple[ComplexArray, BoolArray]:
    """The loads in many cases at once, a row each, whose displacements are close to x; and which of them are found.

    `hold`: of all cases at the distances from the middle, nan where a support has no answer."""
    equation = _equation(shaft, list(range(x.shape[-1])))
    rows, columns = equation.at
    for _ in range(STEPS):
        held, angle = hold(np.abs(x)), np.angle(x)
        turned = np.exp(1j * (held.attitude + angle))
        load = held.force * turned
        missing = shaft.f_c - x @ shaft.K_c.T - load
        worst = np.abs(missing).max(axis=-1)
        if not (worst > SETTLED * equation.largest).any():
            break
        J = np.tile(equation.K, (len(x), 1, 1))
        J[:, rows, columns] += np.stack(_tangent(held, np.exp(1j * angle), turned), -1).reshape(len(x), -1)
        x = x + np.linalg.solve(J, missing.view(np.float64)[..., None])[..., 0].view(np.complex128)
    return load, worst <= SETTLED * equation.largest


@record
class _Equation:
    """K_c·x + P(x) = f_c of n supports that give way; of each first the real part, then the imaginary one."""

    K: Array
    f: Array
    at: tuple[IndexArray, IndexArray]  # rows and columns of the four derivatives of each P
    largest: Newton  # |f_c| of all supports, rigid ones too


class _Now(NamedTuple):
    """Where Newton's method stands."""

    step: int
    x: list[complex]
    held: list[Hold]
    load: list[complex]
    missing: Array  # f_c − K_c·x − P
    worst: Newton


def _equation(shaft: Condensed, rows: list[int]) -> _Equation:
    n = len(rows)
    K = np.zeros((n, 2, n, 2))
    K[:, 0, :, 0] = K[:, 1, :, 1] = shaft.K_c[rows][:, rows]
    return _Equation(K.reshape(2 * n, 2 * n), _parts(shaft.f_c[rows]), _blocks(n), float(np.abs(shaft.f_c).max()))


@cache
def _blocks(n: int) -> tuple[IndexArray, IndexArray]:
    real = np.arange(0, 2 * n, 2)
    return np.stack([real, real, real + 1, real + 1], 1).ravel(), np.stack([real, real + 1] * 2, 1).ravel()


def _parts(numbers: Sequence[complex] | ComplexArray) -> Array:
    return np.array(numbers, dtype=np.complex128).view(np.float64)


def _begun(equation: _Equation, laws: Sequence[Law]) -> _Now:
    """Where each support carries what a rigid one would."""
    loads: list[complex] = equation.f.view(np.complex128).tolist()
    least = LEAST * equation.largest
    e = [law.begin(abs(F)) if abs(F) > least else 0.0 for law, F in zip(laws, loads)]
    held = [law.hold(e_i) for law, e_i in zip(laws, e)]
    x = [cmath.rect(e_i, cmath.phase(F) - h.attitude) for e_i, h, F in zip(e, held, loads)]
    return _now(equation, laws, x, held=held)


def _now(
    equation: _Equation, laws: Sequence[Law], x: list[complex], step: int = 0, held: list[Hold] | None = None
) -> _Now:
    held = held or [law.hold(abs(x_i)) for law, x_i in zip(laws, x)]
    load = [cmath.rect(h.force, h.attitude + cmath.phase(x_i)) for h, x_i in zip(held, x)]
    missing = equation.f - equation.K @ _parts(x) - _parts(load)
    return _Now(step, x, held, load, missing, max(map(abs, missing.view(np.complex128).tolist()), default=0.0))


def _tangent(held: Hold[Any], u: Any, turned: Any) -> tuple[Any, Any, Any, Any]:
    """By how much the real part of P moves with the real and with the imaginary part of x; and the imaginary part of P.
    u and `turned`: the directions of x and of P, of length 1."""
    outward = turned * (held.slope + 1j * (held.force * held.turning))
    sideways = turned * (1j * held.secant)
    real, imag = outward * u.real - sideways * u.imag, outward * u.imag + sideways * u.real
    return real.real, imag.real, real.imag, imag.imag


def _newton(equation: _Equation, laws: Sequence[Law], now: _Now) -> tuple[_Now, bool]:
    """Where it ends, and whether that is an equilibrium."""
    while now.worst > SETTLED * equation.largest and now.step < STEPS:
        J = equation.K.copy()
        phases = map(cmath.phase, now.x)
        ways = [(h, cmath.rect(1.0, phi), cmath.rect(1.0, h.attitude + phi)) for h, phi in zip(now.held, phases)]
        J[equation.at] += [part for way in ways for part in _tangent(*way)]
        try:
            way = np.linalg.solve(J, now.missing).view(np.complex128).tolist()
        except np.linalg.LinAlgError:
            return now, False
        limits = [law.farthest(abs(x_i)) for law, x_i in zip(laws, now.x)]
        part = 1.0
        for _ in range(HALVINGS):
            x = [x_i + part * dx for x_i, dx in zip(now.x, way)]
            if all([abs(x_i) <= limit for x_i, limit in zip(x, limits)]):
                nearer = _now(equation, laws, x, now.step + 1)
                if nearer.worst < now.worst:
                    break
            part /= 2
        else:
            return now, False
        now = nearer
    return now, now.worst <= SETTLED * equation.largest
