# SPDX-License-Identifier: Apache-2.0
"""`contralbero validate`: published reference values beside ours."""

from argparse import Namespace

from assistant.plain import sign
from calc.sheet.number import short
from calc.validate import rows
from calc.version import VERSION


def run(asked: Namespace) -> int:
    found = list(rows())
    failed = [row for row in found if row.verdict == "fail"]
    if asked.json:
        import json

        print(json.dumps({"schema": 1, "program": "contralbero", "version": VERSION, "rows": [
            {"source": r.source, "what": r.what, "published": r.published, "ours": r.ours, "tolerance": r.tolerance, "unit": r.unit,
             "deviation": r.deviation, "verdict": r.verdict} for r in found
        ]}, ensure_ascii=False, indent=1))  # fmt: skip
        return 1 if failed else 0
    source = ""
    for row in found:
        if row.source != source:
            source = row.source
            print(f"\n{source}")
        print(
            f"  {sign(row.verdict):<7} {row.what:<52} published {short(row.published, 6):>10} ± {short(row.tolerance, 2):<8} "
            f"ours {short(row.ours, 6):>10} {row.unit:<8} {row.deviation * 100:+.3f} %".replace("-", "−")
        )
    print(f"\n{len(found) - len(failed)} of {len(found)} published values are met within the tolerance of their source.")
    return 1 if failed else 0
