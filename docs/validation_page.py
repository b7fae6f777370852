# SPDX-License-Identifier: Apache-2.0
"""Values of others beside ours as a page: a table for each source, the deviation first."""

from itertools import groupby

from key_pages import plain

from calc.sheet.number import short
from calc.studies.published import VALIDATION_KINDS, Unmet, ValidationRow, rows, unmet

HEAD = """# Values of others beside ours

What `contralbero validate` prints, as tables; made by `python docs/generate.py`. A *share* is the deviation over the tolerance that the source
supports: at 100 % it is used up. No public measurement of strike speed or force of a balance-shaft train was found: forces of strikes
are verified against our own finer model only ([why balance shafts rattle](rattle.md)).

| kind | sources | values | met | largest share of a tolerance |
|---|---|---|---|---|
{kinds}

Printed, and not met: {missed} values, each [with its reason](#printed-and-not-what-this-program-gives).
"""


def validation_page() -> str:
    compared, missed = list(rows()), list(unmet())
    parts, kinds = [], []
    for kind, title in VALIDATION_KINDS.items():
        of_kind = [row for row in compared if row.kind == kind]
        met = sum(row.verdict == "pass" for row in of_kind)
        sources = {row.source for row in of_kind}
        kinds.append(f"| {title} | {len(sources)} | {len(of_kind)} | {met} | {_percent(max(map(_share, of_kind)))} |")
        parts.append(f"\n## {title}\n")
        for source, of_source in groupby(of_kind, lambda row: row.source):
            parts.append(
                f"### {plain(source)}\n\n| deviation | share | value | theirs | ± | ours | unit |\n{'|---' * 7}|"
            )
            parts += [*map(_row, of_source), ""]
    parts.append("\n## Printed, and not what this program gives\n")
    for (source, why), of_source in groupby(missed, lambda entry: (entry.source, entry.why)):
        parts.append(
            f"### {plain(source)}\n\n{plain(why)}\n\n| deviation | value | theirs | ours | unit |\n{'|---' * 5}|"
        )
        parts += [*map(_missed, of_source), ""]
    return HEAD.format(kinds="\n".join(kinds), missed=len(missed)) + "\n".join(parts)


def _share(row: ValidationRow) -> float:
    """The deviation over the tolerance."""
    return abs(row.ours - row.published) / row.tolerance if row.tolerance else 0.0


def _row(row: ValidationRow) -> str:
    met = "" if row.verdict == "pass" else " **not met**"
    numbers = f"{short(row.published, 6)} | {short(row.tolerance, 2)} | {short(row.ours, 6)}"
    deviation = _signed(row.deviation) if row.published else "of nought"
    return f"| {deviation}{met} | {_percent(_share(row))} | `{row.what}` | {numbers} | {row.unit} |"


def _missed(entry: Unmet) -> str:
    numbers = f"{short(entry.printed, 6)} | {short(entry.ours, 6)}"
    return f"| {_signed(entry.deviation)} | `{entry.what}` | {numbers} | {entry.unit} |"


def _percent(share: float) -> str:
    return f"{share:.0%}".replace("%", " %")


def _signed(deviation: float) -> str:
    return f"{100 * deviation:+.3f} %".replace("-", "−")
