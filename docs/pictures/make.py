# SPDX-License-Identifier: Apache-2.0
"""The pictures of the documents, from the program itself: `python docs/pictures/make.py`.

The session as it stands on a terminal (SVG), the first page of a report (PNG; needs pypdfium2, of the extra `docx`),
and the plots of the tutorials (PNG), each a curve of a solved design as the report draws it."""

import asyncio
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT))

# the plots: name of the picture, design, id of the curve
PLOTS = (
    ("gamma_film", "r753ie4_gamma.toml", "film_front"),
    ("pair_force", "r754ie4_balance_shafts.toml", "residual_force_over_speed"),
    ("loss", "r753ie4_rolling.toml", "plain_and_rolling_loss"),
    ("strikes_cycle", "r753ie4_drive_over_speed.toml", "cycle_way_idle"),
    ("strikes_speed", "r753ie4_drive_over_speed.toml", "strikes_over_speed"),
    ("shells", "twin-180", "press_over_temperature_front"),  # a starter
)
WIDTH, HEIGHT = 490.0, 240.0  # points


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


def plots() -> dict[str, bytes]:
    """Each plot as a file of pixels, by the name of its picture."""
    from calc.design.toml_file import design, load_design, parse
    from calc.locale import Language
    from calc.solve import solve
    from calc.studies.shipped import DESIGNS, engine_design
    from reports.figures.pixels import png

    drawn = {}
    for name, origin, curve_id in PLOTS:
        path = DESIGNS / origin
        given = load_design(path) if path.is_file() else design(parse(engine_design(origin).encode("utf-8"), origin))
        outcomes = solve(given).outcomes.values()
        curve = next(curve for outcome in outcomes for curve in outcome.curves if curve.id == curve_id)
        drawn[name] = png(curve, WIDTH, HEIGHT, Language("en"))
    return drawn


if __name__ == "__main__":
    (HERE / "session.svg").write_text(asyncio.run(session()), encoding="utf-8")
    page(HERE / "report.png")
    for name, picture in plots().items():
        (HERE / f"{name}.png").write_bytes(picture)
