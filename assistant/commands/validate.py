# SPDX-License-Identifier: Apache-2.0
"""`contralbero validate`: values of others beside ours, what is met and what is not."""

import textwrap
from argparse import Namespace
from itertools import groupby

from assistant.plain import sign
from calc.sheet.number import short
from calc.studies.validate import KINDS, Row, Unmet, rows, unmet
from calc.version import VERSION

WIDE = 116


def run(asked: Namespace) -> int:
    found, missed = rows(), list(unmet())
    failed = [row for row in found if row.verdict == "fail"]
    if asked.json:
        import json

        print(json.dumps({"schema": 1, "program": "contralbero", "version": VERSION, "rows": [
            {"kind": r.kind, "source": r.source, "what": r.what, "published": r.published, "ours": r.ours, "tolerance": r.tolerance,
             "unit": r.unit, "deviation": r.deviation, "verdict": r.verdict} for r in found
        ], "unmet": [
            {"source": u.source, "what": u.what, "printed": u.printed, "ours": u.ours, "unit": u.unit, "deviation": u.deviation,
             "why": u.why} for u in missed
        ]}, ensure_ascii=False, indent=1))  # fmt: skip
        return 1 if failed else 0
    for kind, of_kind in groupby(found, lambda row: row.kind):
        print(f"\n{KINDS[kind]}\n{'─' * len(KINDS[kind])}")
        for source, of_it in groupby(of_kind, lambda row: row.source):
            print("\n".join([f"\n{source}", *map(_line, of_it)]))
    print(f"\n{(head := 'Printed, and not what this program gives')}\n{'─' * len(head)}")
    for (source, why), of_source in groupby(missed, lambda one: (one.source, one.why)):
        reason = textwrap.wrap(why, WIDE, initial_indent="  ", subsequent_indent="  ", break_long_words=False)
        print("\n".join([f"\n{source}", *map(_missed, of_source), *reason]))
    print()
    for kind, title in KINDS.items():
        verdicts = [row.verdict for row in found if row.kind == kind]
        print(f"{title}: {verdicts.count('pass')} of {len(verdicts)} met within the tolerance of the source.")
    print(f"Printed, and not met: {len(missed)}, each with its reason above.")
    return 1 if failed else 0


def _line(row: Row) -> str:
    return (
        f"  {sign(row.verdict):<7} {row.what:<52} theirs {short(row.published, 6):>10} ± {short(row.tolerance, 2):<8} "
        f"ours {short(row.ours, 6):>10} {row.unit:<8} {row.deviation * 100:+.3f} %"
    ).replace("-", "−")


def _missed(one: Unmet) -> str:
    return (
        f"  differs {one.what:<52} theirs {short(one.printed, 6):>10}   {'':<8} "
        f"ours {short(one.ours, 6):>10} {one.unit:<8} {short(one.deviation * 100, 2)} %"
    ).replace("-", "−")
