# SPDX-License-Identifier: Apache-2.0
"""The pictures of the documents, from the program itself: `python docs/pictures/make.py`.

The session as it stands on a terminal (SVG), the first page of a report and a balancing sheet (PNG; need pypdfium2, of
the extra `docx`), and the plots of the tutorials (PNG), each a curve of a solved design as the report draws it."""

import asyncio
import subprocess
import sys
import tempfile
from importlib.util import find_spec
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


def sheet(target: Path) -> None:
    """The page for the balancing machine."""
    import pypdfium2

    from calc.design.toml_file import design, read
    from calc.solve import solve
    from reports.balancing_sheet import render

    document = read(ROOT / "designs" / "r754ie4_balance_shafts.toml")
    pdf = pypdfium2.PdfDocument(render(document, solve(design(document))))
    pdf[0].render(scale=1.4, grayscale=True).to_pil().save(target, optimize=True)


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


def frame() -> bytes:
    """The axes of all files, from the front of an engine that turns clockwise and of one that turns anticlockwise, and
    from the side."""
    from io import BytesIO

    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from matplotlib.patches import Circle, FancyArrowPatch, Rectangle

    ink, blue, grey = "#222222", "#1f5fa8", "#8a8a8a"
    figure = Figure(figsize=(7.6, 2.7), dpi=150, facecolor="white")
    FigureCanvasAgg(figure)
    views = figure.subplots(1, 3, gridspec_kw={"width_ratios": [1, 1, 1.35]})

    def arrow(
        ax: object, start: tuple[float, float], end: tuple[float, float], name: str, at: tuple[float, float]
    ) -> None:
        ax.add_patch(
            FancyArrowPatch(start, end, arrowstyle="-|>", mutation_scale=13, color=blue, lw=1.6, shrinkA=0, shrinkB=0)
        )
        ax.text(*at, name, color=blue, fontsize=11, ha="center", va="center", weight="bold")

    for ax, side, title in ((views[0], 1, "turns clockwise"), (views[1], -1, "turns anticlockwise")):
        ax.add_patch(Circle((0, 0), 0.62, fc="#f1f1f1", ec=grey, lw=1.0))
        arrow(ax, (0, 0), (0, 1.15), "X", (0.17, 1.12))
        arrow(ax, (0, 0), (1.15, 0), "Y", (1.18, 0.17))
        ax.plot(0, 0, "o", ms=9, mfc="white", mec=blue, mew=1.4)
        ax.plot(0, 0, "x", ms=5, color=blue, mew=1.4)
        ax.text(-0.2, -0.2, "Z", color=blue, fontsize=11, ha="center", va="center", weight="bold")
        ax.add_patch(
            FancyArrowPatch(
                (-0.62 * side, 0.55),
                (0.62 * side, 0.55),
                connectionstyle=f"arc3,rad={-0.42 * side}",
                arrowstyle="-|>",
                mutation_scale=11,
                color=ink,
                lw=1.2,
            )
        )
        ax.text(0, -1.0, f"from the front: {title}", ha="center", fontsize=8.5, color=ink)
        ax.set(xlim=(-1.25, 1.45), ylim=(-1.2, 1.35))
    ax = views[2]
    ax.add_patch(Rectangle((-1.2, -0.16), 2.4, 0.32, fc="#f1f1f1", ec=grey, lw=1.0))
    ax.add_patch(Rectangle((1.2, -0.62), 0.16, 1.24, fc="#e2e2e2", ec=grey, lw=1.0))
    ax.plot([-1.5, 1.75], [0, 0], color=grey, lw=0.8, dashes=(9, 2, 2, 2))
    ax.plot([0, 0], [-0.5, 0.5], color=grey, lw=0.8, dashes=(9, 2, 2, 2))
    arrow(ax, (0, 0), (0, 1.15), "X", (0.17, 1.12))
    arrow(ax, (0, 0), (0.98, 0), "Z", (0.86, 0.3))
    ax.text(1.28, 0.78, "flywheel", ha="center", fontsize=8.5, color=ink)
    ax.text(-1.45, 0.3, "front", ha="left", fontsize=8.5, color=ink)
    ax.text(0.06, -0.42, "mid-engine", ha="left", fontsize=8.5, color=ink)
    ax.text(0.1, -1.0, "from the side", ha="center", fontsize=8.5, color=ink)
    ax.set(xlim=(-1.6, 1.85), ylim=(-1.2, 1.35))
    for ax in views:
        ax.set_aspect("equal")
        ax.axis("off")
    figure.subplots_adjust(0.005, 0.01, 0.995, 0.99, wspace=0.02)
    out = BytesIO()
    figure.savefig(out, format="png", metadata={"Software": None})
    return out.getvalue()


def measured() -> bytes:
    """A run of the bench on the curve that is predicted, the residuals below it."""
    from io import BytesIO

    from PIL import Image

    from calc.design.toml_file import load_design
    from calc.locale import Language
    from calc.solve import solve
    from reports.figures.pixels import png

    runs = solve(load_design(ROOT / "designs" / "r753ie4_measured.toml")).runs
    assert runs is not None
    column = runs.columns[0]
    parts = [(column.curve, HEIGHT), (column.strip, HEIGHT / 2)]
    drawn = [Image.open(BytesIO(png(curve, WIDTH, height, Language("en")))) for curve, height in parts]
    whole, top = Image.new("RGB", (drawn[0].width, sum(part.height for part in drawn)), "white"), 0
    for part in drawn:
        whole.paste(part, (0, top))
        top += part.height
    written = BytesIO()
    whole.save(written, "PNG", optimize=True)
    return written.getvalue()


def module(target: Path) -> None:
    """All shafts and wheels of the pair, drawn from the STEP file itself (needs the extra `cad`)."""
    import matplotlib.image
    import numpy as np
    from solids import drawn, triangles

    with tempfile.TemporaryDirectory() as folder:
        step = Path(folder) / "module.step"
        command = [sys.executable, "-m", "assistant", "export", ROOT / "designs" / "r754ie4_balance_shafts.toml"]
        subprocess.run([*command, "--step", "--module", "--teeth", "-q", "-o", step], check=True, cwd=ROOT)
        parts = triangles(step)
    aside, above = np.radians(35.0), np.radians(22.0)  # from the front of the engine
    toward = np.array([np.sin(above), np.cos(above) * np.sin(aside), -np.cos(above) * np.cos(aside)])
    up = np.array([1.0, 0.0, 0.0]) - toward * toward[0]
    shaft, its_wheel, crank, idler = "#8fa3b8", "#c9a15b", "#7f8c99", "#b5bdc6"
    colours = [shaft, its_wheel, shaft, its_wheel, crank, idler, idler, idler]
    matplotlib.image.imsave(target, drawn(parts, colours, (toward, up / np.linalg.norm(up)), 820))


if __name__ == "__main__":
    if find_spec("OCP") is not None:  # of the extra `cad`
        module(HERE / "module.png")
    (HERE / "frame.png").write_bytes(frame())
    (HERE / "session.svg").write_text(asyncio.run(session()), encoding="utf-8")
    page(HERE / "report.png")
    sheet(HERE / "balancing_sheet.png")
    for name, picture in plots().items():
        (HERE / f"{name}.png").write_bytes(picture)
    (HERE / "measured.png").write_bytes(measured())
