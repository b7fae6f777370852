# SPDX-License-Identifier: Apache-2.0
"""What is said of parts that are written as solids: what each weighs, beside the program's own numbers."""

from collections.abc import Iterable, Iterator, Sequence

from calc.sheet.text import Amount, Name, Text
from reports.step.shaft import Weighed, WeighedPart

ATOM = 1e-7  # mm
COLUMNS = ("cm³", "kg", "X mm", "Y mm", "Z mm", "J_XX kg·mm²", "J_YY", "J_ZZ", "J_XY", "J_YZ", "J_ZX")


def table(parts: Sequence[tuple[WeighedPart, str]]) -> Iterator[Text]:
    """A line for each solid, the whole of a part, and the same by the program; then how far they are apart.  `parts`:
    each with what it is called in the file."""
    lines = [line for part, called in parts for line in _lines(part, called, len(parts) > 1)]
    cells = [("", *COLUMNS), *((name, *(f"{x:.6g}" for x in row)) for name, row in lines)]
    widths = [max(map(len, column)) for column in zip(*cells)]
    for name, *numbers in cells:
        row = (number.rjust(width) for number, width in zip(numbers, widths[1:]))
        yield Name("  ".join((name.ljust(widths[0]), *row)))
    worst = max((part.deviation for part, _ in parts), default=0.0)
    words = Text("Deviation {share}; J about the centre of gravity, its products −∫XY dm.", share=f"{worst:.1e}")
    yield (
        Text("{words} Each about its own axis, before it is set in its place.", words=words)
        if len(parts) > 1
        else words
    )


def _lines(part: WeighedPart, called: str, several: bool) -> Iterator[tuple[str, list[float]]]:
    """`several`: other parts stand in the same table."""

    def of_part(words: Text) -> str:
        return str(Text("{part}, {words}", part=Name(called), words=words) if several else words)

    single = len(part.solids) == 1
    for one in part.solids:
        yield called if single else one.name, _numbers(one)
    if not single:
        yield of_part(Text("together")), _numbers(part.whole)
    if part.holes:
        yield of_part(Text("undrilled")), _numbers(part.undrilled)
    yield of_part(Text("by the program")), _numbers(part.by_program)


def _numbers(one: Weighed) -> list[float]:
    """As the columns have them; what is nothing beside its like is 0, and so is a centre that is off by no atom."""
    J = one.tensor
    tensor = [J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[1, 2], J[2, 0]]
    return [one.volume * 1e-3, one.mass, *_rounded(one.centre, ATOM), *_rounded(tensor)]


def _rounded(numbers: Iterable[float], least: float = 0.0) -> list[float]:
    numbers = [float(x) for x in numbers]
    dust = max(1e-9 * max(map(abs, numbers)), least)
    return [x if abs(x) > dust else 0.0 for x in numbers]


def changed(toothed: WeighedPart, blank: WeighedPart) -> Iterator[Text]:
    """What teeth in place of a blank change: the mass, and the moment of inertia about the axis."""
    (m, J), (m_0, J_0) = ((one.whole.mass, one.whole.tensor[2, 2]) for one in (toothed, blank))
    yield Text(
        "Teeth in place of the blank change the mass by {mass} ({of_mass} %), J_ZZ by {inertia} ({of_inertia} %).",
        mass=Amount((m - m_0) * 1e3, "g", form="+.4g"),
        of_mass=Amount((m / m_0 - 1) * 100, form="+.3g"),
        inertia=Amount(float(J - J_0), "kg·mm²", form="+.4g"),
        of_inertia=Amount(float(J / J_0 - 1) * 100, form="+.3g"),
    )
