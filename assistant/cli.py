# SPDX-License-Identifier: Apache-2.0
"""The command line.  Nothing but argparse is imported here; each command imports what it needs when it runs.

Exit codes: 0 done · 1 a limit check fails, or a replay or a report differs · 2 bad input or usage · 3 no solution found ·
70 a fault of the program itself · 130 ended by Ctrl-C · 141 nobody reads the output any more.
"""

import argparse
import gc
import os
import sys
from collections.abc import Sequence
from importlib import import_module

from calc.version import VERSION

ABOUT = """From the engine's data to the imbalance, the counter-rotating balance shaft, its plain bearings, its gear train and the
friction it costs.  Without a command: the guided session."""
LANGUAGES = ("en", "it")  # the codes of calc.languages, which --help does not load
COMMANDS = {
    "new": "write a design from a shipped engine",
    "check": "solve a design and print its verdicts, main values and findings",
    "explain": "the chain of formulas that leads to one value",
    "report": "write the calculation report as a PDF, or as a Word document to go on writing",
    "verify": "solve what is inside a report or a comparison again: identical, signed, or what differs",
    "replay": "run scripted designs and compare with what they expect",
    "set": "edit a design file in place, comments kept",
    "choose": "search for the user: a ranked table, of which one row can be taken",
    "design": "the whole drive: the front of all combinations that pass, traded over power, mass, seat, price and margin",
    "compare": "two designs side by side: what got better and worse, the inputs that differ",
    "sweep": "many designs at once, a row of a table for each; one that was ended goes on where it stood",
    "export": "results as JSON or CSV, the shaft or the gears as a DXF drawing",
    "serve": "the guided session in a browser, on this machine only",
    "scenarios": "a train under several conditions side by side: the friction thesis' three, or a design's own",
    "validate": "values printed, worked out or measured by others beside ours; what is not met, and why",
    "errata": "what is wrong in the documents behind this program, with the right values",
    "oils": "the oils a design may name, or one with the source and confidence of every value",
    "schema": "the JSON Schema of a design file, by which editors complete and check it",
    "completion": "the script by which a shell completes commands and options",
    "sources": "the publications behind the program: title, edition, status, and how we know what each says",
}
KEY_VALUE = "KEY=VALUE"
THREADS = ("OPENBLAS_NUM_THREADS", "1")  # of numpy's algebra: starting a second takes a fifth of a check, and small matrices need none
CLOSED = 141  # as the system itself would end it: no verdict
SELDOM = (200_000, 20, 100)  # new objects between two looks for garbage, of which a solve leaves next to none: a twelfth of a check


class Help(argparse.HelpFormatter):
    """As wide as the terminal, which argparse asks of shutil for every argument: 4 ms of imports."""

    def __init__(self, prog: str) -> None:
        try:
            columns = int(os.environ.get("COLUMNS") or os.get_terminal_size(sys.__stdout__.fileno()).columns)  # type: ignore[union-attr]
        except (ValueError, OSError, AttributeError):
            columns = 80
        super().__init__(prog, width=max(columns, 20) - 2)


def parser() -> argparse.ArgumentParser:
    top = argparse.ArgumentParser(
        prog="contralbero", description=ABOUT, formatter_class=Help,
        epilog="contralbero COMMAND --help tells more. contralbero [FILE] [--lang en|it] [--ascii] opens the guided session.",
    )  # fmt: skip
    top.add_argument("--version", action="version", version=f"contralbero {VERSION}")
    commands = top.add_subparsers(dest="command", metavar="COMMAND", title="commands", prog="contralbero")  # saves formatting it
    add = {
        name: commands.add_parser(name, help=about, description=about[0].upper() + about[1:] + ".", formatter_class=Help)
        for name, about in COMMANDS.items()
    }

    add["new"].add_argument("file", nargs="?", help="the design file to write; an existing one is left alone")
    add["new"].add_argument("--engine", default="r753ie4", metavar="ID", help="which shipped engine (default: %(default)s)")
    add["new"].add_argument("--list", action="store_true", help="list the shipped engines")

    add["check"].add_argument("file", nargs="?")
    add["check"].add_argument(
        "--set", action="extend", nargs="+", default=[], metavar=KEY_VALUE, dest="changes", help="change inputs for this run"
    )
    add["check"].add_argument("--step", help="this step only, with all its values, tables, notes and checks")
    add["check"].add_argument(
        "--all", action="store_true", help="the same of every step, and every finding in full: advice, method, what shares a cause"
    )
    add["check"].add_argument("--short", action="store_true", help="with --all or --step: leave out vectors of no length")
    add["check"].add_argument("--json", action="store_true", help="print one JSON object")

    add["explain"].add_argument("file")
    add["explain"].add_argument("value", metavar="VALUE_ID", help="like bearings.front.film")
    add["explain"].add_argument("--json", action="store_true", help="print the lines as JSON")

    add["report"].add_argument("file")
    add["report"].add_argument("-o", "--output", metavar="OUT", help="default: the design's name with .pdf, in the current folder")
    add["report"].add_argument(
        "--format",
        choices=("pdf", "docx"),
        help="docx: a Word document, its formulas to be edited; the record is the PDF (default: by the ending of OUT)",
    )
    add["report"].add_argument("--depth", choices=("summary", "engineer", "audit"), default="engineer", help="default: %(default)s")
    add["report"].add_argument("--lang", choices=LANGUAGES, default="en", help="English or Italian (default: %(default)s)")

    add["verify"].add_argument("file", metavar="REPORT.pdf")
    add["verify"].add_argument("--all", action="store_true", help="list every difference")

    add["replay"].add_argument("files", nargs="+", metavar="FILE")

    add["set"].add_argument("file")
    add["set"].add_argument("changes", nargs="+", metavar=KEY_VALUE, help="an empty value takes the key out: KEY=")

    add["choose"].add_argument("file")
    steps = (
        "engine: firing orders; countershaft: the lightest shafts in the envelope; bearings: those that pass at every corner; "
        "gears: profile shifts and tip cuts by which the flanks slide least"
    )
    add["choose"].add_argument("step", metavar="STEP", help=steps)
    add["choose"].add_argument("--json", action="store_true", help="print one JSON object")
    add["choose"].add_argument("--top", type=int, default=20, metavar="N", help="rows to show (default: %(default)s)")
    add["choose"].add_argument("--apply", type=int, metavar="N", help="write row N into the design file")

    one = add["design"]
    one.add_argument("file")
    one.add_argument("--out", metavar="FOLDER", help="where the drives are put, and what is known of them; the same again goes on")
    one.add_argument("--vary", action="extend", nargs="+", metavar="KEY=LO:HI:STEP", help="also KEY=VALUE,VALUE,… and KEY=fixed")
    one.add_argument("--most", action="extend", nargs="+", metavar="NAME=X", help="power_W, mass_kg, seat_mm, price_EUR")
    one.add_argument("--least", action="extend", nargs="+", metavar="NAME=X", help="margin_percent")
    one.add_argument("--limit", action="extend", nargs="+", metavar="ID", help="findings that are limits beside the usual ones; * for any")
    one.add_argument("--objectives", metavar="NAME,…", help="some of power, mass, seat, price, margin (default: all that are known)")
    one.add_argument("--rows", type=int, metavar="N", help="drives that are solved whole and saved (default: 60)")
    one.add_argument("--processes", type=int, metavar="N", help="default: one for each core")
    one.add_argument(
        "--time", "--seconds", type=float, metavar="SECONDS", help="end the search after so long, with the drives known by then"
    )
    one.add_argument("--scheduler", metavar="ADDRESS", help="of dask.distributed, whose workers search instead: tcp://HOST:8786")
    one.add_argument("--evaluations", type=int, metavar="N", help="whole solutions of the search without proof (default: 1600)")
    one.add_argument("--seed", type=int, metavar="N", help="of the search without proof (default: 1)")
    one.add_argument("--dry", action="store_true", help="say what would be searched, and search nothing")
    one.add_argument("--json", action="store_true", help="print one JSON object")
    one.add_argument("--pick", type=int, metavar="N", help="write drive N of the folder into the file")
    one.add_argument("-o", "--output", metavar="NEW.toml", help="with --pick: into this file instead")

    add["compare"].add_argument("a", metavar="A", help="a design file")
    add["compare"].add_argument("b", metavar="B", help="another one, or the same")
    kinds = add["compare"].add_mutually_exclusive_group()
    kinds.add_argument("--json", action="store_true", help="print one JSON object, with all that differs")
    kinds.add_argument("-o", "--output", metavar="OUT.pdf", help="write the comparison as a PDF report, which verify checks")
    add["compare"].add_argument(
        "--all", action="store_true", help="then all checks and values that differ, tables of one design written out"
    )
    add["compare"].add_argument("--lang", choices=LANGUAGES, default="en", help="of the PDF (default: %(default)s)")

    add["sweep"].add_argument("file")
    add["sweep"].add_argument(
        "--vary", action="extend", nargs="+", default=[], metavar="KEY=LO:HI:N",
        help="inputs to vary over a grid; also KEY=VALUE,VALUE,…; drawn at random: KEY=LO:HI",
    )  # fmt: skip
    add["sweep"].add_argument(
        "--tolerance", action="extend", nargs="+", default=[], metavar="KEY=T",
        help="inputs that scatter by ±T, three standard deviations, about what the design has; also KEY=LOWER:UPPER (with --monte-carlo)",
    )  # fmt: skip
    ways = add["sweep"].add_mutually_exclusive_group()
    ways.add_argument("--hypercube", type=int, metavar="N", help="N designs at random that fill every range evenly (Latin hypercube)")
    ways.add_argument("--monte-carlo", type=int, metavar="N", help="N designs at random, each by itself")
    ways.add_argument("--list", metavar="FILE.csv", help="the designs of a table: keys in the first line, a design in each other one")
    add["sweep"].add_argument("--seed", type=int, default=1, metavar="N", help="of what is drawn at random (default: %(default)s)")
    add["sweep"].add_argument(
        "--set", action="extend", nargs="+", default=[], metavar=KEY_VALUE, dest="changes", help="change inputs first"
    )
    add["sweep"].add_argument("--step", help="this step only; imbalance alone computes thousands of designs in a second")
    add["sweep"].add_argument("--values", action="extend", nargs="+", default=[], metavar="VALUE_ID", help="these columns only")
    add["sweep"].add_argument("-o", "--output", metavar="OUT", help="a .csv or .parquet file (default: CSV to the terminal)")
    add["sweep"].add_argument("--processes", type=int, metavar="N", help="default: one for each core")
    add["sweep"].add_argument("--scheduler", metavar="ADDRESS", help="of dask.distributed, whose workers compute instead: tcp://HOST:8786")

    add["export"].add_argument("file")
    kinds = add["export"].add_mutually_exclusive_group()
    kinds.add_argument("--dxf", action="store_const", const="dxf", dest="kind", help="the shaft, or the gears, in mm")
    kinds.add_argument("--csv", action="store_const", const="csv", dest="kind", help="the values, a row each; checks stand in --json")
    kinds.add_argument("--json", action="store_const", const="json", dest="kind", help="the object of check --json")
    drawn = add["export"].add_mutually_exclusive_group()
    drawn.add_argument("--gear", metavar="WHEEL", help="draw this wheel, with its table of data, instead of the shaft")
    drawn.add_argument("--gears", action="store_true", help="draw the whole train; so does --dxf where a design has no shaft")
    add["export"].add_argument(
        "--chord-error", type=float, metavar="UM", help="how far a tooth's straight pieces may stand off (default: 1 µm)"
    )
    add["export"].add_argument("--transfer", action="store_true", help="the transfer functions of the mounts instead of the values (--csv)")
    add["export"].add_argument("-o", "--output", required=True, metavar="PATH", help="the file; without a format its ending decides")

    add["serve"].add_argument("file", nargs="?")
    add["serve"].add_argument("--port", type=int, default=8000, metavar="N", help="of the address 127.0.0.1:N (default: %(default)s)")

    add["scenarios"].add_argument(
        "files", nargs="*", metavar="FILE", help="designs with [[friction.scenarios]] (default: those of the thesis)"
    )
    add["scenarios"].add_argument(
        "-o", "--output", metavar="FOLDER", help="also write the curves as CSV and a report as PDF for each design"
    )
    add["scenarios"].add_argument("--json", action="store_true", help="print one JSON object")

    add["validate"].add_argument("--json", action="store_true", help="print one JSON object")

    add["errata"].add_argument(
        "source", nargs="?", metavar="SOURCE", help="one document, by a word of its name: finotti, textbook, friction"
    )
    written = add["errata"].add_mutually_exclusive_group()
    written.add_argument("--json", action="store_true", help="print one JSON object")
    written.add_argument("--markdown", action="store_true", help="all of it as a page of tables")

    add["oils"].add_argument("name", nargs="?", metavar="NAME", help="like '5W-30'; left out: all")
    add["oils"].add_argument("--json", action="store_true", help="print one JSON object")
    add["sources"].add_argument("name", nargs="?", metavar="NAME", help="a publication, or a word of its name or title; left out: all")
    add["sources"].add_argument("--json", action="store_true", help="print one JSON object")

    add["schema"].add_argument("-o", "--output", metavar="OUT.json", help="default: to the terminal")
    add["completion"].add_argument("shell", choices=("bash", "zsh", "fish", "tcsh", "powershell"))

    session = commands.add_parser(
        "session", help="the guided session (the same as no command)", description="The guided session.", formatter_class=Help
    )
    session.add_argument("file", nargs="?")
    session.add_argument("--ascii", action="store_true", help="plain signs for terminals without Unicode")
    session.add_argument("--lang", choices=LANGUAGES, help="English or Italian, this time (default: as set in the session)")
    for command in commands.choices.values():
        command.set_defaults(error=command.error)  # says how this command is used
    return top


def _meant(word: str | None) -> str | None:
    """The command that a word comes close to, which is none, and no file either."""
    if word is None or os.path.exists(word):
        return None
    from difflib import get_close_matches

    return next(iter(get_close_matches(word, COMMANDS, 1)), None)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; gives the exit code.  Without arguments it is that of this process, which ends with it."""
    from .outlet import Unwritable, outlets

    with outlets():
        try:
            code = command(list(sys.argv[1:] if arguments is None else arguments), own=arguments is None)
            sys.stdout.flush()
            return code
        except Unwritable as full:
            if full.closed:
                return CLOSED
            print(f"contralbero: the output cannot be written: {full}", file=sys.stderr)
            return 2
        except Exception as error:
            if isinstance(error.__cause__, KeyboardInterrupt):  # it came while a class was being made
                raise error.__cause__ from None
            if arguments is not None:
                raise
            from .fault import told

            return told(error)


def command(given: list[str], own: bool) -> int:
    """The command that the words ask for.  `own`: the process is for it alone."""
    if own and "_ARGCOMPLETE" in os.environ:  # a shell asks what could come next
        from argcomplete import autocomplete

        autocomplete(parser())
    first = next((a for a in given if not a.startswith("-")), None)
    if not {"-h", "--help", "--version"} & set(given[:1]) and first not in (*COMMANDS, "session"):
        if (meant := _meant(first)) is not None:
            print(f"contralbero: {first}: is neither a command nor a file; did you mean {meant}?", file=sys.stderr)
            return 2
        given = ["session", *given]  # no command: the guided session
    try:
        asked, unknown = parser().parse_known_args(given)
        if unknown:
            asked.error(f"unrecognized arguments: {' '.join(unknown)}")  # with the usage of the command
        if own:
            os.environ.setdefault(*THREADS)
            if asked.command not in ("session", "serve"):
                gc.set_threshold(*SELDOM)
        return int(import_module(f"assistant.commands.{asked.command}").run(asked))
    except SystemExit as usage:
        return int(usage.code or 0)
    except KeyboardInterrupt:
        return 130
    except Exception as error:
        from calc.sheet.errors import BadInput

        if isinstance(error, BadInput):
            print(error, file=sys.stderr)
            return 2
        raise
    finally:
        if own:
            gc.freeze()  # the process ends: looking through all that it holds for garbage takes a tenth of a report
