# SPDX-License-Identifier: Apache-2.0
"""What the documents have from the program itself: `python docs/generate.py` writes the theory pages from the formulas
of the code, the validation, the errata and the schema of designs."""

import sys
from contextlib import redirect_stdout
from importlib import import_module
from io import StringIO
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parent
sys.path.insert(0, str(ROOT))

from calc.design.model import STEPS  # noqa: E402
from calc.sheet.check import LETTERS, RULES  # noqa: E402
from calc.sheet.expression import expression, text  # noqa: E402
from calc.sheet.formula import FORMULAS, Equation, units  # noqa: E402

SHARED = ("shared", "What several steps use")
HEAD = """# {title}

Every equation of this step as the program computes it, rendered from its code: symbol, expression, source, and what the formula says of its
range. `contralbero explain FILE VALUE_ID` shows the same lines with the numbers of a design. Made by `python docs/generate.py`.
"""


def loaded() -> list[Equation]:
    for path in sorted((ROOT / "calc").rglob("*.py")):
        if (
            "@formula" in (source := path.read_text(encoding="utf-8"))
            and path.parent.name != "sheet"
            and "__main__" not in source
        ):
            import_module(".".join(path.relative_to(ROOT).with_suffix("").parts))
    return [one for name, one in FORMULAS.items() if name.startswith("calc.")]


def pages() -> dict[str, str]:
    """The text of each page by the name of its file."""
    known = {step.key: str(step.title) for step in STEPS}
    rooms: dict[str, dict[str, list[Equation]]] = {}
    for one in loaded():
        module = one.function.__module__
        step = module.split(".")[1]
        rooms.setdefault(step if step in known else SHARED[0], {}).setdefault(module, []).append(one)
    made = {}
    for step, title in [*known.items(), SHARED]:
        parts = [HEAD.format(title=title)]
        for module, some in sorted(rooms.get(step, {}).items()):
            doc = (sys.modules[module].__doc__ or "").strip().split("\n\n")[0].replace("\n", " ")
            parts.append(f"\n## {module.removeprefix('calc.').replace('.', ' · ').replace('_', ' ')}\n\n{doc}\n")
            parts += [_line(one) for one in some]
        made[f"theory/{step}.md"] = "\n".join(parts) + "\n"
    return made


CHECKS = """# What is checked, and of which kind

Every check of the program, as its declaration in the code has it. A **limit** must hold: else a part breaks, seizes, jams or can not be put together
(its role: physics, chosen by the designer, or self: data and program agree with themselves). A **caution** is the same less surely; **advice** is a usual
figure or a rule of thumb; **method** is about the calculation, not the part. *Exact*: the limit may be used up. The scale is what the margin of a limit of
nought is a share of. {letters}. Made by `python docs/generate.py`.
"""


def checks() -> str:
    """Every declared check, step by step."""
    for path in sorted((ROOT / "calc").rglob("*.py")):
        if "CheckRule(" in path.read_text(encoding="utf-8") and path.parent.name != "sheet":
            import_module(".".join(path.relative_to(ROOT).with_suffix("").parts))
    letters = "; ".join(f"**{letter}** in an id stands for {words}" for letter, words in LETTERS.items())
    parts = [CHECKS.format(letters=letters)]
    for step in STEPS:
        parts += [
            f"\n## {step.title}\n",
            "| check | kind | why | scale | shown under | moved by |",
            "|---|---|---|---|---|---|",
        ]
        for rule in sorted((r for r in RULES.values() if r.id.startswith(f"{step.key}.")), key=lambda r: r.id):
            kind = ", ".join(filter(None, (f"{rule.kind} {rule.role}".strip(), "exact" if rule.exact else "")))
            moved = " ".join(f"`{key}`" for key in rule.moved_by)
            cause = f"`{rule.cause}`" if rule.cause else ""
            parts.append(f"| `{rule.id}` | {kind} | {rule.why} | {rule.zero} | {cause} | {moved} |")
    return "\n".join(parts) + "\n"


def _line(one: Equation) -> str:
    shown = str(one.shows) or text(expression(one))
    unit = one.unit or units(one).get("return", "")
    about = " ".join((one.function.__doc__ or "").split(">>>")[0].split())
    in_unit = f" ({unit})" if unit else ""
    tail = f"  \n    {about}" if about else ""
    return f"- `{one.symbol} = {shown}`{in_unit}  \n    *{one.source}*{tail}"


def spoken(*arguments: str) -> str:
    """What a command prints."""
    from assistant.cli import main

    with redirect_stdout(StringIO()) as out:
        main(arguments)
    return out.getvalue()


PAIR = """# The pair under an inline four

The crank of an inline four balances its own first order. What is left shakes straight up and down, twice a turn: no mass that turns with the crank takes
it, two shafts at twice its speed do, one with the crank and one against it. Their sideways forces cancel. Made by `python docs/generate.py`.

## One that was built

    contralbero check designs/r754ie4_balance_shafts.toml

The diesel R754IE4, with the crank train of its sister of three cylinders, leaves {whole:.0f} N of order 2 at 3000 rpm. Each of its shafts takes {force:.0f} N; {left:.0f} N
stay. One shaft a tooth of 24 off, and {tooth:.0f} N stay.

Each shaft runs in three bearings. On rigid supports the middle one would carry {pin:.0f} N and the outer ones {end:.0f} N; in their films they carry {middle:.0f} and
{outer:.0f} N, because a film that is loaded more gives way more. A middle bore that is wider gives still more of its load to its neighbours, {wide_middle:.0f} and {wide_outer:.0f} N,
and fails: its own film is then {wide_film:.1f} µm of {wide_needs:.1f}:

    contralbero check designs/r754ie4_balance_shafts.toml --set shafts.left.bearings.middle.clearance_um=90

Of the mirror image alone it is `shafts.right.bearings.middle.clearance_um=90`: its bearings are then solved, judged and reported by themselves.

Only what the source prints of these shafts is known: journals, distances, masses. Crank train, oil, clearance, wheels and the place of the shafts are assumed, and the
file says so. At 90 °C of oil every limit holds; with 120 °C, as in its sister of three cylinders, the film of the middle bearing is {hot:.1f} µm of {needs:.1f}.

    contralbero check designs/r754ie4_balance_shafts.toml --set bearings.supply_temperature_C=120

Both shafts stand at one height, so they do not roll the engine; {roll:.0f} N·m of inertia roll stay as they were. Heights a rod's length apart would take most of
it: the shaft that turns with the crank the higher one (`axis_mm` is [up, side] from the crank's axis; `speed_ratio` above 0). The other way
round the roll doubles.

## One of your own

A diesel of bore 84, stroke 90 and rod 145 at 4500 rpm, from nothing to shafts, bearings, gears, friction and mounts:

    contralbero new pair.toml --engine inline-4 --arrangement second --mounts --set engine.bore_mm=84 engine.crank_radius_mm=45 engine.rod_length_mm=145 engine.cylinder_pitch_mm=92 engine.piston_mass_g=620 engine.rod_mass_g=680 engine.rated_speed_rpm=4500
    contralbero check pair.toml
    contralbero report pair.toml

It leaves {own_whole:.0f} N without shafts and {own_left:.0f} N with them. Every number that a rule has put there is marked `assumed`; change what you know better, and
`check` says what no longer holds. What else an engine can be given: `--arrangement pair` (two at crank speed), `repeat` (two that turn alike), `pair_and_second`
(four), `shaft`, `half`, `none`.
"""


def pair() -> str:
    from calc.design.toml_file import design, parse, read
    from calc.solve import solve
    from calc.studies.shipped import DESIGNS, engine_design

    document = read(DESIGNS / "r754ie4_balance_shafts.toml")

    def values(**changes: float) -> dict[str, float]:
        made = document
        for key, value in changes.items():
            made = made.with_value(key.replace("__", "."), value)
        return {id: value.shown for id, value in solve(design(made)).values().items()}

    as_built, wide = values(), values(shafts__left__bearings__middle__clearance_um=90.0)
    results = solve(design(document.with_value("bearings.supply_temperature_C", 120.0)))
    film = next(c for c in results.checks() if c.id == "bearings.left.middle.film_edge")
    own = {"bore_mm": 84.0, "crank_radius_mm": 45.0, "rod_length_mm": 145.0, "cylinder_pitch_mm": 92.0}
    own |= {"piston_mass_g": 620.0, "rod_mass_g": 680.0, "rated_speed_rpm": 4500.0}
    text = engine_design("inline-4", "second", {f"engine.{key}": value for key, value in own.items()}, mounts=True)
    of_own = {id: value.shown for id, value in solve(design(parse(text.encode("utf-8"), "own"))).values().items()}
    force, left = "imbalance.order_2.force_peak", "countershaft.residual_order_2_force"
    return PAIR.format(
        whole=as_built[force],
        force=as_built["countershaft.left.force"],
        left=as_built[left],
        tooth=as_built["gears.left.tooth_late.order_2_force"],
        pin=as_built["countershaft.left.reaction_middle"],
        end=as_built["countershaft.left.reaction_front"],
        middle=as_built["bearings.left.middle.load"],
        outer=as_built["bearings.left.front.load"],
        wide_middle=wide["bearings.left.middle.load"],
        wide_outer=wide["bearings.left.front.load"],
        wide_film=wide["bearings.left.middle.film_edge"],
        wide_needs=film.limit,
        hot=results.values()[film.id].shown,
        needs=film.limit,
        roll=as_built["countershaft.roll_left_order_2"],
        own_whole=of_own[force],
        own_left=of_own[left],
    )


def everything() -> dict[str, str]:
    validation = (
        "# Values of others beside ours\n\nWhat `contralbero validate` prints; made by `python docs/generate.py`.\n\n"
    )
    return pages() | {
        "validation.md": validation
        + "".join(f"    {line}\n" if line else "\n" for line in spoken("validate").splitlines()),
        "checks.md": checks(),
        "pair.md": pair(),
        "errata.md": spoken("errata", "--markdown"),
        "contralbero.schema.json": spoken("schema"),
    }


if __name__ == "__main__":
    (HERE / "theory").mkdir(exist_ok=True)
    for name, page in everything().items():
        (HERE / name).write_text(page, encoding="utf-8")
