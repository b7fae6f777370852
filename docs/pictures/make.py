# SPDX-License-Identifier: Apache-2.0
"""The pictures of the documents, from the program itself: `python docs/pictures/make.py`.

The session as it stands on a terminal (SVG), and the first page of a report (PNG; needs pypdfium2, of the extra
`docx`)."""

import asyncio
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT))


async def session() -> str:
    """The bearings of the source's design, whose film is too thin."""
    from assistant.app import ContralberoApp
    from assistant.session.recovery import Memory
    from assistant.session.session import Session

    with tempfile.TemporaryDirectory() as folder:
        opened = Session.open(ROOT / "designs" / "r753ie4_gamma.toml", memory=Memory(Path(folder)))
        opened.solve()
        app = ContralberoApp(opened)
        async with app.run_test(size=(120, 36)) as pilot:
            await pilot.pause(1.0)
            await pilot.press("escape", "4")
            await pilot.pause(3.0)
            return app.export_screenshot(title="contralbero designs/r753ie4_gamma.toml")


def page(target: Path) -> None:
    import pypdfium2

    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.pdf"
        design = ROOT / "designs" / "r753ie4_gamma.toml"
        subprocess.run(
            [sys.executable, "-m", "assistant", "report", design, "--depth", "summary", "-o", report],
            check=True,
            cwd=ROOT,
        )
        pypdfium2.PdfDocument(report)[0].render(scale=1.2, grayscale=True).to_pil().save(target, optimize=True)


if __name__ == "__main__":
    (HERE / "session.svg").write_text(asyncio.run(session()), encoding="utf-8")
    page(HERE / "report.png")
