# SPDX-License-Identifier: Apache-2.0
"""What the documents have from the program itself: `python docs/generate.py` writes the theory pages from the formulas
of the code, the validation, the errata and the schemas of designs and results."""

import math
import sys
from contextlib import chdir, redirect_stdout
from importlib import import_module
from io import StringIO
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
ROOT = HERE.parent
sys.path[:0] = [str(ROOT), str(HERE)]

from exchange_page import exchange_page  # noqa: E402
from key_pages import key_pages  # noqa: E402
from validation_page import validation_page  # noqa: E402

from assistant.results_schema import PROMISE, results_schema  # noqa: E402
from calc.design.model import STEPS  # noqa: E402
from calc.sheet.check import LETTERS, RULES  # noqa: E402
from calc.sheet.expression import expression, text  # noqa: E402
from calc.sheet.formula import FORMULAS, Equation, units  # noqa: E402
from calc.sheet.number import short  # noqa: E402
from calc.sheet.step import Table  # noqa: E402

WIDE = 120  # columns of a block of code
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


def load_checks() -> None:
    for path in sorted((ROOT / "calc").rglob("*.py")):
        if "CheckRule(" in path.read_text(encoding="utf-8") and path.parent.name != "sheet":
            import_module(".".join(path.relative_to(ROOT).with_suffix("").parts))


def checks() -> str:
    """Every declared check, step by step; all are to be loaded."""
    letters = "; ".join(f"**{letter}** in an id stands for {words}" for letter, words in LETTERS.items())
    parts = [CHECKS.format(letters=letters)]
    of_runs = (("measured", "Runs of the bench"), ("fit", "Fits"))
    for key, title in (*((step.key, step.title) for step in STEPS), *of_runs):
        parts += [
            f"\n## {title}\n",
            "| check | kind | why | scale | shown under | moved by |",
            "|---|---|---|---|---|---|",
        ]
        for rule in sorted((r for r in RULES.values() if r.id.startswith(f"{key}.")), key=lambda r: r.id):
            kind = ", ".join(filter(None, (f"{rule.kind} {rule.role}".strip(), "exact" if rule.exact else "")))
            moved = " ".join(f"`{moving}`" for moving in rule.moved_by)
            cause = f"`{rule.cause}`" if rule.cause else ""
            parts.append(f"| `{rule.id}` | {kind} | {rule.why} | {rule.zero} | {cause} | {moved} |")
    return "\n".join(parts) + "\n"


def written(one: Equation) -> str:
    """Symbol = formula, as plain text."""
    return f"{one.symbol} = {str(one.shows) or text(expression(one))}"


def _line(one: Equation) -> str:
    unit = one.unit or units(one).get("return", "")
    about = " ".join((one.function.__doc__ or "").split(">>>")[0].split())
    in_unit = f" ({unit})" if unit else ""
    tail = f"  \n    {about}" if about else ""
    return f"- `{written(one)}`{in_unit}  \n    *{one.source}*{tail}"


def spoken(*arguments: str) -> str:
    """What a command prints."""
    from assistant.cli import main

    with redirect_stdout(StringIO()) as out:
        main(arguments)
    return out.getvalue()


def console(line: str, *begin: str) -> str:
    """A command as it is typed in a terminal, with its first line of output and those that begin so; … for others, and for
    the end of a long one."""
    with chdir(ROOT):
        first, *others = spoken(*line.split()[1:]).splitlines()
    shown, cut = [f"$ {line}", first], False
    for said in others:
        if said.lstrip().startswith(begin):
            shown += ["…", said] if cut else [said]
            cut = False
        else:
            cut = True
    shown = [said if len(said) <= WIDE else f"{said[: said.rindex(' ', 0, WIDE - 2)].rstrip()} …" for said in shown]
    return "\n".join(["```console", *shown, *["…"] * cut, "```"])


def markdown_table(table: Table) -> str:
    """A table of results: its title, its columns with their units, its note."""

    def cell(content: str | float | None) -> str:
        return "" if content is None else str(content) if isinstance(content, str) else short(content)

    heads = [f"{label}, {unit}" if unit else str(label) for label, unit in table.columns]
    lines = [heads, ["---"] * len(heads), *([cell(content) for content in row] for row in table.rows)]
    rows = "\n".join(f"| {' | '.join(cells)} |" for cells in lines)
    return f"**{table.title}**\n\n{rows}\n\n{table.note}"


PAIR = """# The pair under an inline four

The crank of an inline four balances its own first order. What is left shakes straight up and down, twice a turn: no mass that turns with the crank takes
it, two shafts at twice its speed do, one with the crank and one against it. Their sideways forces cancel. Made by `python docs/generate.py`.

## One that was built

{check}

![The force of second order over speed, without the shafts and with them](pictures/pair_force.png)

The diesel R754IE4, with the crank train of its sister of three cylinders, leaves {whole:.0f} N of order 2 at 3000 rpm. Each of its shafts takes {force:.0f} N; {left:.0f} N
stay. One shaft a tooth of 24 off, and {tooth:.0f} N stay.

Each shaft runs in three bearings. On rigid supports the middle one would carry {pin:.0f} N and the outer ones {end:.0f} N; in their films they carry {middle:.0f} and
{outer:.0f} N, because a film that is loaded more gives way more. A middle bore that is wider gives still more of its load to its neighbours, {wide_middle:.0f} and {wide_outer:.0f} N,
and fails: its own film is then {wide_film:.1f} µm of {wide_needs:.1f}:

```sh
contralbero check designs/r754ie4_balance_shafts.toml --set shafts.left.bearings.middle.clearance_um=90
```

Of the mirror image alone it is `shafts.right.bearings.middle.clearance_um=90`: its bearings are then solved, judged and reported by themselves.

Only what the source prints of these shafts is known: journals, distances, masses. Crank train, oil, clearance, wheels and the place of the shafts are assumed, and the
file says so. At 90 °C of oil every limit holds; with 120 °C, as in its sister of three cylinders, the film of the middle bearing is {hot:.1f} µm of {needs:.1f}.

```sh
contralbero check designs/r754ie4_balance_shafts.toml --set bearings.supply_temperature_C=120
```

Both shafts stand at one height, so they do not roll the engine; {roll:.0f} N·m of inertia roll stay as they were. Heights a rod's length apart would take most of
it: the shaft that turns with the crank the higher one (`axis_mm` is [up, side] from the crank's axis; `speed_ratio` above 0). The other way
round the roll doubles.

## One of your own

A diesel of bore 84, stroke 90 and rod 145 at 4500 rpm, from nothing to shafts, bearings, gears, friction and mounts:

```sh
contralbero new pair.toml --engine inline-4 --arrangement second --mounts \\
    --set engine.bore_mm=84 engine.crank_radius_mm=45 engine.rod_length_mm=145 engine.cylinder_pitch_mm=92 \\
    engine.piston_mass_g=620 engine.rod_mass_g=680 engine.rated_speed_rpm=4500
contralbero check pair.toml
contralbero report pair.toml
```

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
    steps = ("Imbalance", "Balance shafts", "Bearings", "Friction")
    return PAIR.format(
        check=console("contralbero check designs/r754ie4_balance_shafts.toml", *steps),
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


PLAIN_OR_ROLLING = """# Plain or rolling?

A balance shaft runs on films of oil or on balls, rollers, needles. `contralbero check FILE --step bearings` puts both side by side for any shaft: what each loses
hot and cold, weighs, lasts, needs of seat and oil, and which of its checks are open. This page works the shaft of the R753IE4 through. Made by `python docs/generate.py`.

## What each is good at

| | plain | rolling |
|---|---|---|
| friction | grows with the journal's diameter, and in cold oil by much | about a third of that of a journal as small as can be, a tenth of one made large; less again in cold oil |
| oil | under pressure, through a gallery | a splash that reaches it; no pressure oil |
| life | as long as the film holds | counted in hours: load, cleanliness, viscosity |
| small load | any | an element that carries too little slips: see `minimum_load` |
| seat | the journal and a bush | larger, and in aluminium a sleeve of iron or steel |
| noise | none of its own | hums at `pass_frequency` |
| assembly | journals so large that the shaft passes them, or divided seats | a ring on its end, or a cage in two halves |

The load of a balance shaft **turns with it**: it stands on the inner ring and sweeps the outer one. So the outer ring needs the tight fit and the inner one may be
loose, the other way round than for most machines.

## The friction of one shaft

Solution gamma of the R753IE4 is threaded through its seats, and its journals are Ø59.5 and Ø81 mm. What both lose, and what two NU205 would lose in their
place, in W:

| oil | bearings | {heads} |
|---|---|{rule}|
{rows}

Of the ratio most belongs to the journals' size, not to their kind. The best plain pair of a shaft that is **not** threaded through has {plain_sizes} mm and loses {plain_loss:.0f} W
at rated speed in hot oil, where two {ball_sizes} lose {ball_loss:.0f} W.

![The loss of the sized shaft on plain and on rolling bearings over speed, cold, warm and hot](pictures/loss.png)

## The same shaft on ball bearings

{check}

It is `r753ie4_sized.toml` with other bearings: {size} at both ends, of which that beside the gear locates it, the rear one in a flange through which the shaft comes in.

| | on films | on balls |
|---|---|---|
| bearings, at rated speed, W | {film_loss:.0f} | {roll_loss:.1f} |
| all losses of the train, W | {film_total:.0f} | {roll_total:.0f} |
| shaft, kg | {film_mass:.2f} | {roll_mass:.2f} |
| pressure oil, L/min | {film_oil:.2f} | 0 |
| life of both bearings, h | by film | {life:.0f} |

What the program says of it, for each kind that passes:

{table}

{risks}

## What decides

- **Grip**: aluminium grows away from the ring. In a bare seat no fit holds hot (`grip_hot`): `outer_ring_held = "insert"`, or a pin, an adhesive, a clamp.
- **Clearance at the start**: in the cold, tight housing the shaft warms first (`clearance_start`). Larger classes up to C5, a looser shaft.
- **Idle**: the load falls with the square of the speed. Rollers and needles then carry too little to roll (`minimum_load`), balls rarely.
- **Slope**: needles stand 0.29 mrad, rollers 1.16, balls 2.9.
- **Heat**: polyamide cages end at 120 °C, where some oils begin: `cage = "steel"`.

`contralbero choose FILE bearings` ranks both kinds. Ratings are those of the standards with a typical inside, an estimate: a catalogue's (`dynamic_rating_kN` …) rule
where they are given.
"""


def plain_or_rolling() -> str:
    import numpy as np

    from calc.bearings import comparison as c
    from calc.bearings.result import BearingsResult
    from calc.bearings.rolling.search import as_rolling
    from calc.design.step_inputs import rolling_places
    from calc.design.toml_file import load_design
    from calc.sheet.text import EMPTY
    from calc.solve import solve
    from calc.studies.shipped import DESIGNS

    gamma, sized, rolling = (load_design(DESIGNS / f"r753ie4_{name}.toml") for name in ("gamma", "sized", "rolling"))
    done = solve(gamma)
    places = rolling_places(gamma, done, "shaft")
    carried = done.result(BearingsResult)
    assert carried is not None
    rated = next(iter(places.values())).task.speed
    case = c.ComparisonCase(places, carried.bearings, (), rated, False, c.Costs())
    rollers = {name: c.carried(place, as_rolling(place, "NU205"), place.inputs)[0] for name, place in places.items()}
    sets = {"plain": carried.bearings, "2 × NU205": rollers}

    def three(P: float) -> str:
        return f"{P:.0f}" if P >= 100 else f"{P:.3g}"

    speeds, rows = (900.0, 1500.0, 2200.0, 2600.0), []
    for T in (20.0, 80.0, 120.0):
        for name, bearings in sets.items():
            watts = c.BearingSet(EMPTY, bearings, ()).loss(case, np.array(speeds) / 60, T)
            rows.append(f"| {T:.0f} °C | {name} | {' | '.join(map(three, watts.tolist()))} |")
    a, b = solve(sized), solve(rolling)
    of_film, of_balls = ({id: v.shown for id, v in one.values().items()} for one in (a, b))
    tables = {table.id: table for table in b.outcomes["bearings"].tables}
    offered = {str(row[0]): row for row in tables["plain_and_rolling"].rows}
    best, ball = offered["plain, the least loss"], offered["ball"]

    def both(values: dict[str, float], what: str) -> float:
        return values[f"bearings.front.{what}"] + values[f"bearings.rear.{what}"]

    def printed(name: str) -> str:
        return markdown_table(tables[name])

    lives = tuple(
        f"bearings.{end}.{what} " for end in ("front", "rear") for what in ("life", "friction_power", "clearance")
    )
    return PLAIN_OR_ROLLING.format(
        check=console("contralbero check designs/r753ie4_rolling.toml --step bearings", *lives),
        heads=" | ".join(f"{n:.0f} rpm" for n in speeds),
        rule="|".join("---" for _ in speeds),
        rows="\n".join(rows),
        plain_sizes=str(best[1]).replace("⌀", "Ø"),
        plain_loss=best[2],
        ball_sizes=ball[1],
        ball_loss=ball[2],
        size="6207",
        film_loss=both(of_film, "friction_power"),
        roll_loss=both(of_balls, "friction_power"),
        film_total=of_film["friction.total_loss"],
        roll_total=of_balls["friction.total_loss"],
        film_mass=of_film["countershaft.mass"],
        roll_mass=of_balls["countershaft.mass"],
        film_oil=both(of_film, "oil_flow"),
        life=of_balls["bearings.system_life"],
        table=printed("plain_and_rolling"),
        risks=printed("plain_and_rolling_costs"),
    )


RATTLE = """# Why balance shafts rattle

The wheels of a balance shaft carry next to nothing: the friction of the shaft, some newtons on a tooth. Behind every wheel hangs a heavy shaft, and the crank does
not turn evenly. So the flanks part, cross the backlash and strike, several times a cycle. At idle, where nothing else is loud, one hears it; at full load it is
what the teeth have to bear. Made by `python docs/generate.py` from the train of the R753IE4 (γ), with gas and flywheel as is usual, not measured:

{check}

## One cycle at idle

At {idle:.0f} rpm without load the gas turns the crank unevenly by {delta:.1f} %: it gains up to {up:.0f} rad/s² after each firing and loses up to {down:.0f} while the next
cylinder compresses. The shaft behind the wheels wants to keep its speed. To slow it with the crank the teeth would have to push it backwards, and friction alone
is too weak for that: **Γ**, inertia over drag, M·max(−x″)/D, is {gamma_1:.1f}, {gamma_2:.1f} and {gamma_3:.1f} in the three meshes. Above 1 the flanks part. In each working cycle every
mesh of γ then

1. lets go of the driving flank, when the crank slows;
2. flies across its backlash, that of the meshes before it added: {share:.0%} of what the crank swings, at mid-tolerance {backlash:.0f} µm in the last mesh;
3. strikes the coast flank, with up to {u:.0f} mm/s, and stays there until the crank gains;
4. comes back to the driving flank: {impacts:.0f} strikes a cycle on {flanks:.0f} flanks.

![The way of the shaft's wheel between its flanks over two turns of the crank at idle](pictures/strikes_cycle.png)

While it strikes, a tooth carries some {low:.1f} to {high:.1f} kN; while it drives, at rated speed, {mean:.0f} N. That is where the strength of such a train is decided, not by its mean torque.
The largest force of a strike at the 12 speeds and 3 loads that are judged is that at {hard_n:.0f} rpm at full load, {hard_u:.0f} mm/s and some {hard_low:.1f} to {hard_high:.1f} kN. It leaves a safety against pitting of {S_H_low:.2f} with the low force and
{S_H:.2f} with the high one, against breakage {S_F_low:.2f}.

![The hardest strike over speed: without load, at half load and at full load](pictures/strikes_speed.png)

## Grade

By the hardest strike of the train **at idle, without load, at mid-tolerance**: **A** up to {a:.0f} mm/s, **B** up to {b:.0f}, **C** above. γ is {letter}; at the largest running backlash of its
tolerances it strikes with {most:.0f} mm/s. The yardstick comes from the backlash that makers print, all put on one typical engine (irregularity 0.03 of order 2, 750 rpm, a wheel of
55 mm base radius on the crank, one mesh) and struck as here:

| engine | backlash, mm | strikes, mm/s |
|---|---|---|
| Audi 2.0 TDI | {audi} | 21 to 33 |
| Toyota 5S-FE | {toyota} | 29 to 41, of the first |
| GM 2.4 LD9 | {ld9} | 34 to 52 |
| Ford 6.8 V10 | {ford} | 7 to 49 |
| Mitsubishi 4M41 | {mitsubishi} | 22 to 67 over its meshes; 76 to 96 at 0.3 to 0.4, its wear limit (from memory) |
| AGCO Power 44 49 | {agco} | 76 at 0.3 |

The titles and addresses of these sheets stand in `calc/library/tables/makers.toml`. Whether a printed backlash is normal or at the pitch circle is mostly not said, which is 7 %.
A is about the tightest window of a maker; C lies outside nearly all of them when new. It is no sound level: how the housing answers is not known. Between two variants of one
engine the force tells a tendency, 20·lg(F/F₀) dB.

## The window of the backlash

*From below*: no wheel may jam, so the nominal backlash needs what tolerance, runout, cold and heat can take. *From above*: it may not rattle (B at most), less what the largest running
backlash has above the nominal one, and it turns the shaft against the crank, which leaves some of the couple. Of γ at idle A would need {quiet_a:.0f} µm along the line of action over all three
meshes together, B {quiet_b:.0f}. Jamming asks for {low_exact:.0f} of wheels without runout, for {window_low:.0f} with the runout of their grade, and with the tolerances as they are rattle allows {window_high:.0f}.
The window is empty: closer tolerances or another remedy, not another nominal value.

## What helps

| remedy | γ at idle, no load |
|---|---|
| less backlash: span allowance, centre distance (where the profile shifts are given: else they follow it), shims, a coated idler | strikes go with the ⅔ power of a small backlash: half of it leaves 0.63 of speed and force |
| a heavier flywheel | twice as heavy: {heavy:.0f} mm/s, {heavy_letter}; three times: {heavier:.0f} mm/s, {heavier_letter}; so that the flanks never part: {gamma_1:.0f} times, no remedy |
| a scissor gear in every mesh | closed with {T_1:.1f}, {T_2:.1f} and {T_3:.1f} N·m; in the last mesh alone, with 5.5 N·m, {one:.0f} mm/s are left of the others, and it costs {loss:.0f} W at rated speed |
| a resin rim | speed and grade stay; the force falls to about a quarter (5 GPa on steel: −12.6 dB; a maker prints about −15). Its strength is not rated here |
| two idlers less on the way to a shaft: one alone would turn it the other way | their backlash is gone from the sum |
| the other end of the crank | with `[engine.crank_twist]`: the nose swings otherwise than the flywheel |
| a lighter shaft | Γ falls, the grade hardly: forces go with the root of the mass |
| more drag | none: {gamma_3:.0f} times today's, all of it lost, would close the flanks |

## How good the forces are

The motion of the crank and every strike agree with an independent recomputation ([values of others](validation.md)). Strikes are reckoned without rebound, of rigid bodies, at steady speed. Held against a chain of elastic teeth (240 random trains, three dampings), the low force fits a train whose heavy shaft
is the last, and is no lower bound. The high one is passed in 12 % of the meshes, then by 13 % in the median. So every sentence says *some … to …*. **No public measurement of strike speed or
force of a balance-shaft train was found: forces are verified against our own finer model only.** The energy lost in strikes is *about … at most*. Where the backlash is larger than the swing of
the driver, rebound may double a strike, and a check of the method says so.

Without gas or flywheel a usual irregularity by the number of cylinders stands for the motion of the crank, and whatever fails by it is *not verified*. It has one order and knows no
load: γ strikes with {default:.0f} mm/s by it and with {u:.0f} by its gas, so that what holds by a default is assumed and no more. `new` writes a usual gas for the
kind of engine and the flywheel with which it idles as unevenly as is usual, both marked `assumed`.

## What is not computed

Sound, the housing, oil squeezed between the flanks (it takes speed off light wheels), sliding friction on the flight, torsion of long shafts and of more than two masses on the crank, the
strength of resin, starts, stops and misfires. The train does not act back on the crank but by its inertia.
"""


def rattle() -> str:
    from calc.design.toml_file import design, read
    from calc.gears.drive.checks import grade_letter, grade_limits
    from calc.library.makers import maker_sheets
    from calc.solve import solve
    from calc.studies.shipped import DESIGNS

    document = read(DESIGNS / "r753ie4_drive_over_speed.toml")

    def values(**changes: object) -> dict[str, float]:
        made = document
        for key, value in changes.items():
            made = made.with_value(key.replace("__", "."), value)
        return {id: value.shown for id, value in solve(design(made)).values().items()}

    meshes = ("crank_central", "central_idler", "idler_shaft")
    last, speed, grade = f"gears.{meshes[-1]}", "gears.drive.impact_speed", "gears.drive.grade"
    of = values()
    heavy, heavier = (values(engine__flywheel_inertia_kgm2=0.9 * times) for times in (2, 3))
    sprung = values(**{f"gears__meshes__{i}__scissor": {"torque_Nm": 8.0} for i in range(3)})
    one = values(gears__meshes__2__scissor={"torque_Nm": 5.5})
    a, b = grade_limits()
    printed = {row.name: row.backlash for row in maker_sheets().values()}
    T = [sprung[f"gears.{mesh}.scissor.needed"] for mesh in meshes]
    gammas = [of[f"gears.{mesh}.idle.separation"] for mesh in meshes]
    low, high = (max(of[f"gears.{mesh}.idle.impact_force{end}"] for mesh in meshes) / 1e3 for end in ("_low", ""))
    hard_low, hard_high = (
        max(of[f"gears.{mesh}.hardest.impact_force{end}"] for mesh in meshes) / 1e3 for end in ("_low", "")
    )
    wheels = ("crank", "central", "idler", "shaft")
    exact = values(**{f"gears__wheels__{i}__runout_um": 0.0 for i in range(len(wheels))})
    at_idle = tuple(f"{last}.idle.{what} " for what in ("separation", "impact_speed", "impacts", "backlash_share"))
    return RATTLE.format(
        check=console(
            "contralbero check designs/r753ie4_drive_over_speed.toml --step gears", "Rattle at idle", *at_idle
        ),
        default=values(engine__flywheel_inertia_kgm2=None)[speed],
        backlash=sum(of[f"gears.{mesh}.backlash_nominal"] for mesh in meshes)
        / math.cos(math.radians(of["gears.base_helix_angle"])),
        quiet_a=of["gears.drive.backlash_quiet_a"],
        quiet_b=of["gears.drive.backlash_quiet_b"],
        low_exact=exact["gears.drive.window_low"],
        window_low=of["gears.drive.window_low"],
        window_high=of["gears.drive.window_high"],
        idle=of["gears.drive.idle_speed"],
        delta=of["gears.drive.idle.irregularity"],
        up=of["gears.drive.idle.acceleration_up"],
        down=-of["gears.drive.idle.acceleration_down"],
        gamma_1=gammas[0],
        gamma_2=gammas[1],
        gamma_3=gammas[2],
        share=of[f"{last}.idle.backlash_share"],
        u=of[speed],
        impacts=of[f"{last}.idle.impacts"],
        flanks=of[f"{last}.idle.flanks"],
        low=low,
        high=high,
        mean=2e3 * of[f"{last}.mean_torque"] / of["gears.idler.reference_diameter"],
        hard_n=of["gears.drive.hardest_speed"],
        hard_u=max(of[f"gears.{mesh}.hardest.impact_speed"] for mesh in meshes),
        hard_low=hard_low,
        hard_high=hard_high,
        S_H_low=min(of[f"gears.{mesh}.strike_safety_contact_low"] for mesh in meshes),
        S_H=min(of[f"gears.{mesh}.strike_safety_contact"] for mesh in meshes),
        S_F_low=min(of[f"gears.{wheel}.strike_safety_bending_low"] for wheel in wheels),
        a=a * 1e3,
        b=b * 1e3,
        letter=grade_letter(of[grade]),
        most=max(of[f"gears.{mesh}.idle.impact_speed_most"] for mesh in meshes),
        audi=printed["Audi 2.0 TDI"],
        toyota=printed["Toyota 5S-FE"],
        ld9=printed["GM 2.4 LD9"],
        ford=printed["Ford 6.8 V10"],
        mitsubishi=printed["Mitsubishi 4M41"],
        agco=printed["AGCO Power 44 49"],
        heavy=heavy[speed],
        heavy_letter=grade_letter(heavy[grade]),
        heavier=heavier[speed],
        heavier_letter=grade_letter(heavier[grade]),
        T_1=T[0],
        T_2=T[1],
        T_3=T[2],
        one=one[speed],
        loss=one[f"{last}.scissor.loss"],
    )


RESULTS_PAGE = """# The results as JSON

`contralbero check FILE --json` prints one object, and `contralbero export FILE --json -o PATH` writes it. Its
[schema](contralbero.results.schema.json), which `contralbero schema --results` prints, is a JSON Schema (draft-07) by which programs
check what they read. A report has the same object inside, as `results.json`.

    contralbero check FILE --json | jq -r '.checks[] | select(.verdict == "fail") | [.id, .value, .unit] | @tsv'
    contralbero check FILE --json | jq '.values["bearings.front.film"].value'

{promise} Sentences for people may be reworded at any time; take ids. The order of fields and of ids says nothing. The results of `--set` and `--step` have
the same fields. [Exit codes](commands.md) say the verdict without JSON. Objects of other commands (`compare`, `choose`, `sources` …) have a
number of their own in `schema` and no such promise. Made by `python docs/generate.py`.
"""


def results_page() -> str:
    """The fields with their meaning: a table for each object, the outermost first."""
    tables = [RESULTS_PAGE.format(promise=PROMISE)]
    waiting = [("", results_schema())]
    for path, schema in waiting:  # grows on the way
        heading = f"## `{path}`" if path else "## The object"
        rows = []
        for name, field in schema["properties"].items():
            inner, kind = _inside(field)
            rows.append(f"| `{name}` | {kind} | {field['description']} |")
            if inner is not None:
                waiting.append((f"{path}.{name}".removeprefix(".") + ("" if inner is field else "[]"), inner))
        about = schema["description"]
        tables.append(
            "\n".join(filter(None, (heading, about and f"\n{about}", "\n| field | is | |\n|---|---|---|", *rows)))
        )
    return "\n\n".join(tables) + "\n"


def _inside(field: dict[str, Any]) -> tuple[dict[str, Any] | None, str]:
    """The object that a field holds or holds several of, and what it is in words."""
    if "properties" in field:
        return field, "object"
    if "items" in field:
        inner, kind = _inside(field["items"])
        return inner, f"list of {kind}"
    if "propertyNames" in field:
        inner, kind = _inside(field["additionalProperties"])
        return inner, f"by {field['propertyNames']['description']}: {kind}"
    if "anyOf" in field:
        return None, " or ".join(_inside(one)[1] for one in field["anyOf"])
    if "const" in field:
        return None, str(field["const"])
    if "enum" in field:
        return None, ", ".join(f"`{word}`" if word else "empty" for word in field["enum"])
    kinds = field.get("type", "anything")
    return None, kinds if isinstance(kinds, str) else " or ".join(kinds)


def everything() -> dict[str, str]:
    load_checks()
    return (
        pages()
        | key_pages()
        | {
            "exchange.md": exchange_page(),
            "validation.md": validation_page(),
            "checks.md": checks(),
            "pair.md": pair(),
            "plain_or_rolling.md": plain_or_rolling(),
            "rattle.md": rattle(),
            "errata.md": spoken("errata", "--markdown"),
            "contralbero.schema.json": spoken("schema"),
            "contralbero.results.schema.json": spoken("schema", "--results"),
            "json.md": results_page(),
        }
    )


if __name__ == "__main__":
    for folder in ("theory", "reference"):
        (HERE / folder).mkdir(exist_ok=True)
    for name, page in everything().items():
        (HERE / name).write_text(page, encoding="utf-8")
