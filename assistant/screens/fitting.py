# SPDX-License-Identifier: Apache-2.0
"""The fits of a design, made while one waits: what is identified can be taken, of the others it is said why not."""

from collections.abc import Iterator, Mapping

from calc.sheet.progress import Progress
from calc.sheet.step import Table
from calc.sheet.text import COMMA, Name, Text
from calc.solve import solve
from calc.studies.fit_results import DesignFit
from calc.studies.fits import fits_of

from ..offers import Offer
from .selection import Choosing

COLUMNS = ((Text("no."), ""), (Text("Fit"), ""), (Text("Runs"), ""), (Text("Inputs"), ""), (Text("Width"), ""))


class Fitting(Choosing):
    """Gives the changes of the fit that was taken, as KEY=VALUE."""

    @property
    def headline(self) -> Text:
        return Text("Fits to runs of the bench")

    def search(self, progress: Progress) -> Iterator[Offer]:
        session = self.session
        document, known = session.document, session.results if session.current else None
        yield fit_offer(fits_of(document, known or solve(session.design), progress))


def fit_offer(made: Mapping[str, DesignFit | Text]) -> Offer:
    """A row for each fit that is identified; the notes say what each came to."""
    done = [fit for fit in made.values() if isinstance(fit, DesignFit)]
    taken = [fit for fit in done if fit.identified]
    rows = tuple(
        (n, Name(fit.name), COMMA.join(map(Name, fit.runs)), fit.numbers, fit.result.width)
        for n, fit in enumerate(taken, 1)
    )
    table = Table("fits", Text("Identified"), COLUMNS, rows)
    notes = [Text("{name}: {words}", name=Name(fit.name), words=fit.sentence) for fit in done]
    notes += [Text("{name}: {why}", name=Name(name), why=why) for name, why in made.items() if isinstance(why, Text)]
    return Offer(
        count=len(taken),
        table=lambda top: table,
        keys=lambda n: dict(taken[n - 1].changes),
        said=lambda n: taken[n - 1].words,
        hint=Text("Enter takes the values of a fit."),
        notes=tuple(notes),
    )
