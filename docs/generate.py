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


def everything() -> dict[str, str]:
    validation = (
        "# Values of others beside ours\n\nWhat `contralbero validate` prints; made by `python docs/generate.py`.\n\n"
    )
    return pages() | {
        "validation.md": validation
        + "".join(f"    {line}\n" if line else "\n" for line in spoken("validate").splitlines()),
        "checks.md": checks(),
        "errata.md": spoken("errata", "--markdown"),
        "contralbero.schema.json": spoken("schema"),
    }


if __name__ == "__main__":
    (HERE / "theory").mkdir(exist_ok=True)
    for name, page in everything().items():
        (HERE / name).write_text(page, encoding="utf-8")
