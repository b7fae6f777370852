# SPDX-License-Identifier: Apache-2.0
"""Whether an untouched report is `identical` wherever it is verified: that of each shipped design, written here, by each
Python that is given, with the kernels of other processors, in other zones and languages.

python bench/environments.py [PYTHON ...]      each with the dependencies; left out: the one that runs this

A kernel that the processor lacks may crash, which is said.  Names that a library does not know change nothing there."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parent.parent
ENVIRONMENTS = [
    {},
    *({"OPENBLAS_CORETYPE": name} for name in ("Prescott", "Nehalem", "Sandybridge", "Haswell", "Zen", "SkylakeX")),
    {"NPY_DISABLE_CPU_FEATURES": "X86_V4 AVX512_ICL AVX512_SPR AVX512F AVX512CD AVX512_SKX"},
    {"NPY_DISABLE_CPU_FEATURES": "X86_V3 X86_V4 AVX512_ICL AVX512_SPR AVX2 FMA3 AVX512F AVX512CD AVX512_SKX"},
    {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA"},  # other sines and powers
    {"PYTHONHASHSEED": "77", "TZ": "Asia/Tokyo", "LC_ALL": "C"},
    {"PYTHONHASHSEED": "0", "TZ": "America/St_Johns", "LC_ALL": "tr_TR.UTF-8"},
]
VERIFY = """
import sys, zlib
from pathlib import Path
from reports.made import versions
from reports.verify.verify import verify
if len(sys.argv) == 1:
    print(*(" ".join(pair) for pair in versions().items()), "zlib " + zlib.ZLIB_RUNTIME_VERSION, sep=", ")
for name in sys.argv[1:]:
    print(Path(name).stem + ": " + verify(Path(name).read_bytes(), name).verdict.value, flush=True)
"""


def run(python: str, environment: dict[str, str], *arguments: str) -> tuple[int, list[str]]:
    free = {name: x for name, x in os.environ.items() if not any(name in one for one in ENVIRONMENTS)}
    settings = {**free, "PYTHONPATH": str(ROOT), **environment}
    done = subprocess.run([python, *arguments], cwd=ROOT, env=settings, stdout=subprocess.PIPE, text=True)
    return done.returncode, done.stdout.splitlines()


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        reports = {path: f"{folder}/{path.stem}.pdf" for path in sorted((ROOT / "designs").glob("*.toml"))}
        for path, report in reports.items():
            run(sys.executable, {}, "-m", "assistant", "report", str(path), "-o", report)
        for python in sys.argv[1:] or [sys.executable]:
            print(*run(python, {}, "-c", VERIFY)[1], flush=True)
            for environment in ENVIRONMENTS:
                code, lines = run(python, environment, "-c", VERIFY, *reports.values())
                other = [line for line in lines if not line.endswith(": identical")]
                count = f"{len(lines) - len(other)} of {len(reports)} identical, ended with {code}"
                print(f"  {count}: {environment or 'as it is'}", *other, sep="\n    ", flush=True)


if __name__ == "__main__":
    main()
