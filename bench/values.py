# SPDX-License-Identifier: Apache-2.0
"""Every value of the shipped designs to 9 digits and every check with its verdict, so that a change of the structure can
show that it changed no number.

python bench/values.py OUT.json [FOLDER]         writes them, of the designs in another folder where one is given
python bench/values.py BEFORE.json AFTER.json    says what differs
"""

import json
import sys
from pathlib import Path

from calc.design.toml_file import load_design
from calc.solve import Results, solve
from calc.studies.shipped import designs


def written(results: Results) -> dict[str, list[str]]:
    values = {id: [f"{v.shown:.9g} {v.unit}"] for id, v in results.values().items()}
    checks = {
        f"check {c.id}": [c.verdict, c.kind, f"{c.value:.9g} {c.sense} {c.limit_text()}", c.unit]
        for c in results.checks()
    }
    return values | checks


def main() -> None:
    match sys.argv[1:]:
        case [out, *rest] if not rest or not rest[0].endswith(".json"):
            paths = sorted(Path(*rest).glob("*.toml")) if rest else designs()
            all_ = {path.stem: written(solve(load_design(path)).whole()) for path in paths}
            Path(out).write_text(json.dumps(all_, indent=0, ensure_ascii=False), encoding="utf-8")
        case [before, after]:
            old, new = (json.loads(Path(name).read_text(encoding="utf-8")) for name in (before, after))
            for design in old:
                for id, was in old[design].items():
                    if (now := new[design].get(id)) != was:
                        print(f"{design}: {id}: {was} -> {now}")
                for id in new[design].keys() - old[design].keys():
                    print(f"{design}: {id}: new")


if __name__ == "__main__":
    main()
