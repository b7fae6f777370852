# SPDX-License-Identifier: Apache-2.0
"""The same design gives the same bytes: whenever, wherever, in whatever process."""

import os
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest

from calc.locale import language
from calc.sheet.expression import governing
from calc.sheet.formula import formula
from calc.sheet.number import short
from calc.sheet.step import Curve, Series
from calc.sheet.text import Text
from calc.sheet.value import Line
from reports.figures.spoken import in_words
from reports.typesetting.pen import _path
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
    rooms += ("calc.exchange.", "calc.measurements.")
    own = ROOT / "reports" / "step"  # a solid is made of the shaft's own outline, and of the wheel's own profile
    paths = [path for path in (ROOT / "reports").rglob("*.py") if own not in path.parents]
    assert len(paths) > 30
    for path in paths:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("calc"):
                assert node.module is not None and node.module.startswith(rooms), path


@pytest.mark.slow
def test_with_the_kernels_of_another_processor(engineer: bytes, tmp_path: Path) -> None:
    """Names that a library or a processor does not know change nothing there."""
    plain = dict(OPENBLAS_CORETYPE="Prescott", GLIBC_TUNABLES="glibc.cpu.hwcaps=-AVX2,-FMA")
    assert (
        elsewhere(tmp_path / "other", NPY_DISABLE_CPU_FEATURES="X86_V4 X86_V3 AVX512F FMA3 AVX2", **plain) == engineer
    )


def test_its_own_words_are_of_no_version_of_reportlab(engineer: bytes) -> None:
    assert engineer.startswith(b"%PDF-1.7\n%\x93\x8c\x8b\x9e\n")
    assert not any(b"opensource" in part or b"www.reportlab" in part for part in (engineer, *_streams(engineer)))


def test_halves_ties_and_noise_are_not_told_by_the_last_digits() -> None:
    """Of a place on the page, a number, the element that governs, and a line whose sum is zero."""
    for x in (654.765, -0.0, 0.125):
        near = [(a, b) for a in (x, x * (1 + 1e-15) + 1e-14) for b in (x, x * (1 - 1e-15) - 1e-14)]
        assert len({_path([place, place]) for place in near}) == 1
    assert short(1.2345 * (1 - 1e-15)) == short(1.2345 * (1 + 1e-15)) == short(1.2345)

    @formula("x", "mathematics: as given")
    def same(x: np.ndarray) -> np.ndarray:
        return x

    for largest in ([2.0, 1.0, 2.0 + 1e-15], [2.0, 1.0, 2.0 - 1e-15]):
        assert governing(Line(same, {}, np.array(largest))) == (0,)
    assert governing(Line(same, {}, np.array([np.nan, 1.0, np.inf]))) == (2,)
    curve = Curve(
        "", Text(), Text("z"), Text("M, N·m"), (Series(Text("M"), np.arange(3.0), np.array([2.3e-10, 263.0, -2e-11])),)
    )
    assert "largest, 263 N·m, at 1, and smallest, 0 N·m, at 0" in in_words(curve, language("en"))
