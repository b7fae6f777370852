# SPDX-License-Identifier: Apache-2.0
"""The same design gives the same bytes: whenever, wherever, in whatever process."""

import os
import subprocess
import sys
import zlib
from pathlib import Path

from tests.reports.reading import EXAMPLE, ROOT, Solved

SCRIPT = """
import sys
from pathlib import Path
from calc.design.toml_file import design, parse
from calc.solve import solve
from reports.report import write
raw = Path(sys.argv[1]).read_bytes()
document = parse(raw, sys.argv[1])
write(document, solve(design(document)), raw, Path(sys.argv[2]))
loaded = {name.split(".")[0] for name in sys.modules}
assert not loaded & {"textual", "rich", "assistant", "scipy"}, loaded
assert "matplotlib.pyplot" not in sys.modules
"""


def elsewhere(folder: Path, **environment: str) -> bytes:
    folder.mkdir()
    source, target = folder / "some other name.toml", folder / "out.pdf"
    source.write_bytes(EXAMPLE.read_bytes())
    settings = {**os.environ, "PYTHONPATH": str(ROOT), **environment}
    subprocess.run([sys.executable, "-c", SCRIPT, str(source), str(target)], cwd=folder, env=settings, check=True)
    return target.read_bytes()


def test_twice_in_one_process(example: Solved, engineer: bytes) -> None:
    assert example.report() == engineer


def test_in_another_folder_zone_and_process(engineer: bytes, tmp_path: Path) -> None:
    made = elsewhere(tmp_path / "a folder with a tell-tale name", TZ="Pacific/Auckland", PYTHONHASHSEED="1", LC_ALL="C")
    assert made == engineer
    for part in (made, *_streams(made)):
        assert b"tell-tale" not in part and str(ROOT).encode() not in part and b"some other name" not in part


def _streams(pdf: bytes) -> list[bytes]:
    found = []
    for piece in pdf.split(b"stream\n")[1:]:
        try:
            found.append(zlib.decompressobj().decompress(piece))
        except zlib.error:
            continue
    assert len(found) > 20
    return found


def test_reports_know_no_single_step() -> None:
    import ast

    rooms = ("calc.sheet.", "calc.draw.", "calc.library.", "calc.locale", "calc.design.", "calc.studies.", "calc.solve")
    paths = list((ROOT / "reports").rglob("*.py"))
    assert len(paths) > 30
    for path in paths:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("calc"):
                assert node.module is not None and node.module.startswith(rooms), path
