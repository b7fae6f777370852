# SPDX-License-Identifier: Apache-2.0
"""A row of the search as it stands in the file: the keys that put its bearings into a design."""

from collections.abc import Iterable

from ....countershaft.rows import BearingRow
from ....sheet.quantity import dotted
from ....sheet.remedy import Changes, applied, digits
from ....sheet.units import Metre
from ...inputs import BearingsInputs
from ..seats.classes import Select
from .ranking import CandidateRow, Pick
from .variants import SelectionCase, placed


def with_row(case: SelectionCase, row: CandidateRow) -> tuple[BearingsInputs, tuple[BearingRow, ...]]:
    """The design's bearings as a row has them: as they then stand in the file."""
    shared, own = _changes(row, case.bearings)
    return applied(case.bearings, shared), tuple(applied(there, own.get(there.name, {})) for there in case.rows)


def bearing_changes(row: CandidateRow, case: SelectionCase) -> Changes:
    """The keys that put a row into a design; a clearance that stays keeps its key."""
    shared, own = _changes(row, case.bearings)
    written = {f"{case.place}.{name}.{key}": value for name, some in own.items() for key, value in some.items()}
    return written | {dotted("bearings", key): value for key, value in shared.items()}


def _changes(row: CandidateRow, bearings: BearingsInputs) -> tuple[Changes, dict[str, Changes]]:
    """Of what all bearings share, and of each by its name; without the tables that they stand in."""
    own: dict[str, Changes] = {}
    fits = fits_to_write(row, bearings)
    whole = dict[object, object]()
    for pick in row.picks:
        b, here = pick.task.seat.bearing, dict[object, object]()
        if pick.diameter != pick.task.diameter:
            here[BearingRow.diameter] = _in_mm(pick.diameter)
            rings = pick.task.seat.rings
            if rings is not None and rings.outside is not None:  # as much metal around it
                here[BearingRow.housing_outer] = _in_mm(rings.outside)
        if pick.length != pick.task.length:
            here[BearingRow.length] = _in_mm(pick.length)
        if pick.task.alike:
            whole |= _classes(pick, bearings) if _moved(pick) else {}
        elif b.limited:
            here |= _limits(pick) if _moved(pick) else {}
        elif _moved(pick) or fits is not None:  # factor K or fits would make another clearance of a new diameter or fit
            here |= {BearingRow.clearance_factor: None, BearingRow.clearance: digits(pick.clearance / 1e-6)}
        if pick.task.level:
            here[BearingRow.journal_roughness] = digits(b.journal_roughness / 1e-6)
            here[BearingRow.housing_roughness] = digits(b.housing_roughness / 1e-6)
        own[pick.task.place] = {dotted(field): value for field, value in here.items()}
    if fits is not None:
        whole |= {BearingsInputs.journal_fit: fits[0], BearingsInputs.seat_fit: fits[1]}
    if row.variant.oil != bearings.oil:
        whole[BearingsInputs.oil] = row.variant.oil
    if row.variant.supply != bearings.supply:
        whole[BearingsInputs.supply] = row.variant.supply
    return {key if isinstance(key, str) else dotted(key): value for key, value in whole.items()}, own


def _in_mm(length: Metre) -> float:
    return digits(length / 1e-3)


def _limits(pick: Pick) -> dict[object, object]:
    """Limits of journal and bore, as wide as they are: both go with the diameter, the journal makes the clearance."""
    task, b = pick.task, pick.task.seat.bearing
    larger, wider = pick.diameter - task.diameter, pick.clearance - task.clearance
    moves = ((BearingRow.journal, b.journal, larger - wider), (BearingRow.bore, b.bore, larger))
    return {
        key: [_in_mm(round(end + by, 9)) for end in ends]
        for key, ends, by in (*moves, (BearingRow.finished, b.finished, larger))
        if ends is not None and by
    }


def _classes(pick: Pick, bearings: BearingsInputs) -> dict[object, object]:
    """Classes, as wide as they are: they go with the diameter; walls that are found make the clearance, where they are
    given the journal does."""
    task, select = pick.task, bearings.select
    assert select is not None
    larger, wider = pick.diameter - task.diameter, pick.clearance - task.clearance
    by_journal = wider if select.walls_mm is not None else 0.0
    keys: dict[object, object] = {
        Select.journal_classes_mm: _moved_classes(select.journals, larger - by_journal),
        Select.bore_classes_mm: _moved_classes(select.bores, larger),
        Select.clearance_band: [digits(round(end + wider, 9) / 1e-6) for end in select.clearance_band],
    }
    return {dotted(BearingsInputs.select, key): value for key, value in keys.items()}


def _moved_classes(classes: Iterable[tuple[Metre, Metre]], by: Metre) -> list[list[float]]:
    return [[_in_mm(round(end + by, 9)) for end in ends] for ends in classes]


def fits_to_write(row: CandidateRow, bearings: BearingsInputs) -> tuple[str, str] | None:
    """Closer fits; or widths for fits with a place, which would make another clearance than the row's.  None: they
    stay, or make no clearance of these bearings."""
    by_fits = [pick for pick in row.picks if pick.task.field is None]
    if not by_fits:
        return None
    return row.variant.fits or (placed(bearings) if any(map(_moved, by_fits)) else None)


def _moved(pick: Pick) -> bool:
    return pick.clearance != pick.task.clearance or pick.diameter != pick.task.diameter
