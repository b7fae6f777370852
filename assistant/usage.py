# SPDX-License-Identifier: Apache-2.0
"""What each command of the command line takes, beside what it is for.  Only argparse is imported; only the command that
is asked for is built, since all of them cost a twelfth of a check."""

import argparse
from collections.abc import Callable
from typing import NamedTuple

from calc.sheet.version import VERSION

from .grammar import KEY_VALUE, Parser, all_option, json_option, output_option, quiet_option, set_option

ABOUT = """From the engine's data to the imbalance, the counter-rotating balance shaft, its plain bearings, its gear train and the
friction it costs.  Without a command: the guided session."""  # noqa: E501
DESIGNS = "a design, - for standard input, or a folder: all .toml files in it"
LANGUAGES = ("en", "it")  # the codes of calc.locale, which --help does not load
Arguments = Callable[[argparse.ArgumentParser], object]


class Command(NamedTuple):
    """The module of `commands` that has its `run_NAME`, what it is for, and what adds its arguments to a parser."""

    module: str
    about: str
    arguments: Arguments


COMMANDS: dict[str, Command] = {}  # in the order of the help


def command(module: str, about: str) -> Callable[[Arguments], Arguments]:
    """Keeps a function that adds arguments as the command of its name."""

    def keep(arguments: Arguments) -> Arguments:
        COMMANDS[arguments.__name__.rstrip("_")] = Command(module, about, arguments)
        return arguments

    return keep


@command("setup", "write a design from a shipped engine, or a shipped design as it is")
def new(it: argparse.ArgumentParser) -> None:
    it.add_argument("file", nargs="?", help="the design file to write; an existing one is left alone")
    begun = it.add_mutually_exclusive_group()
    begun.add_argument("--engine", default="r753ie4", metavar="ID", help="which shipped engine (default: %(default)s)")
    begun.add_argument(
        "--example",
        metavar="NAME",
        help="which shipped design, comments and all, like r753ie4_gamma; a name that there is not lists them",
    )
    it.add_argument(
        "--arrangement",
        default="",
        choices=("none", "half", "shaft", "repeat", "pair", "second", "pair_and_second"),
        metavar="ID",
        help="which shafts (left out: those that the engine is built with): none; half, none, and half of the "
        "reciprocating mass on the crank; shaft, one against the crank at its speed; repeat, two such; pair, one with "
        "the crank and one against it at its speed; second, such a pair at twice its speed; pair_and_second, both",
    )
    set_option(
        it,
        "numbers of an engine of your own, for which all the rest is built: engine.bore_mm=84; crank_radius_mm, "
        "rod_length_mm, piston_mass_g, rod_mass_g, rod_cg_to_big_end_mm, rated_speed_rpm …; and its name=",
    )
    it.add_argument("--mounts", action="store_true", help="put it on four mounts too")
    it.add_argument("--list", action="store_true", help="list the shipped engines")


@command("check", "solve a design and print its verdicts, main values and findings")
def check(it: argparse.ArgumentParser) -> None:
    it.add_argument("files", nargs="*", metavar="FILE", help=DESIGNS)
    set_option(it)
    it.add_argument("--step", help="this step only, with all its values, tables, notes and checks")
    all_option(it, "the same of every step, and every finding in full: advice, method, what shares a cause")
    quiet_option(it, "the state of each design alone")
    it.add_argument("--short", action="store_true", help="with --all or --step: leave out vectors of no length")
    it.add_argument(
        "--fits",
        action="store_true",
        help="make the fits of the design as well, which takes half a minute on two cores",
    )
    it.add_argument("--strict", action="store_true", help="exit 4 where nothing fails, but not all that is asked holds")
    json_option(it, "print one JSON object; of several files a list of them")


@command("explain", "the chain of formulas that leads to one value")
def explain(it: argparse.ArgumentParser) -> None:
    it.add_argument("file")
    it.add_argument("value", metavar="VALUE_ID", help="like bearings.front.film")
    json_option(it, "print the lines as JSON")


@command("report", "write the calculation report as a PDF, or as a Word document to go on writing")
def report(it: argparse.ArgumentParser) -> None:
    it.add_argument("files", nargs="+", metavar="FILE", help=DESIGNS)
    output_option(
        it,
        "OUT",
        "a .pdf or .docx file, - for standard output, or a folder, which several designs need (default: the design's "
        "name with .pdf, in the current folder)",
    )
    it.add_argument(
        "--format",
        choices=("pdf", "docx"),
        help="docx: a Word document, its formulas to be edited; the record is the PDF (default: by the ending of OUT)",
    )
    it.add_argument(
        "--depth", choices=("summary", "engineer", "audit"), default="engineer", help="default: %(default)s"
    )
    it.add_argument("--lang", choices=LANGUAGES, default="en", help="English or Italian (default: %(default)s)")
    it.add_argument("--fail", action="store_true", help="exit as check does: 1 where a limit fails, 3 without solution")
    all_option(it, "print every finding in full")
    quiet_option(it, "print the names of the files alone")


@command("verify", "write the report inside a file again: identical, signed, appended to, or not as written")
def verify(it: argparse.ArgumentParser) -> None:
    it.add_argument("file", metavar="REPORT.pdf")
    all_option(it, "list every difference")
    quiet_option(it, "print the last line alone: which of the four it is")
    it.add_argument("--original", metavar="OUT.pdf", help="write the part of the file that this program wrote")


@command("replays", "write a replay: a design, edits, and what comes of them, to be compared ever after")
def record(it: argparse.ArgumentParser) -> None:
    it.add_argument("files", nargs="+", metavar="FILE", help=DESIGNS)
    set_option(it, "edits, each a step of the replay; an empty value takes the key out: KEY=")
    output_option(
        it,
        "OUT",
        "a .toml file, - for standard output, or a folder, which several designs need (default: the design's name with "
        "-replay.toml, in the current folder); an existing file is left alone",
    )
    quiet_option(it, "print the names of the files alone")


@command("replays", "run scripted designs and compare with what they expect")
def replay(it: argparse.ArgumentParser) -> None:
    it.add_argument(
        "files", nargs="+", metavar="FILE", help="a replay, - for standard input, or a folder: all .toml files in it"
    )
    it.add_argument(
        "--update", action="store_true", help="rewrite the expectations that were recorded, and say which moved"
    )
    it.add_argument("--junit", metavar="OUT.xml", help="write what came out as JUnit XML too, which CI servers show")
    json_option(it)
    all_option(it, "print every comparison, not only what differs")
    quiet_option(it, "print the replays alone in which something differs")


@command("choose", "edit a design file in place, comments kept")
def set_(it: argparse.ArgumentParser) -> None:
    it.add_argument("file")
    it.add_argument("changes", nargs="+", metavar=KEY_VALUE, help="an empty value takes the key out: KEY=")
    quiet_option(it, "print the name of the file alone")


@command("upgrade", "rewrite designs of schema 1 in schema 2, comments kept")
def upgrade(it: argparse.ArgumentParser) -> None:
    it.add_argument("files", nargs="+", metavar="FILE")
    it.add_argument("--dry", action="store_true", help="print what would change, and write nothing")


@command("choose", "search for the user: a ranked table, of which one row can be taken")
def choose(it: argparse.ArgumentParser) -> None:
    it.add_argument("file")
    steps = (
        "engine: firing orders; countershaft: the lightest shafts in the envelope; bearings: the least friction of "
        "plain and rolling ones that pass; "
        "gears: profile shifts and tip cuts by which the flanks slide least"
    )
    it.add_argument("step", metavar="STEP", help=steps)
    it.add_argument(
        "--shaft", metavar="NAME", help="countershaft, bearings: of which of several shafts (default: the worst)"
    )
    it.add_argument(
        "--for",
        dest="aim",
        choices=("loss", "size", "film"),
        help="bearings: least friction (the default), smallest first, or plain ones of ever more film",
    )
    json_option(it)
    it.add_argument("--top", type=int, default=20, metavar="N", help="rows to show (default: %(default)s)")
    it.add_argument("--apply", type=int, metavar="N", help="write row N into the design file")
    quiet_option(it, "print the table alone; with --apply the name of the file alone")


@command("fit", "inputs found from runs of the bench, with what they are worth; or why they can not be")
def fit(it: argparse.ArgumentParser) -> None:
    it.add_argument("file")
    it.add_argument("name", metavar="NAME", help="of a row of [[fits]]")
    it.add_argument(
        "--apply", action="store_true", help="write what is identified into the design file, and show what then holds"
    )
    json_option(it)
    quiet_option(it, "print the verdict alone")


@command(
    "design",
    "the whole drive: the front of all combinations that pass, traded over power, mass, seat, price and margin",
)
def design(it: argparse.ArgumentParser) -> None:
    it.add_argument("file")
    it.add_argument(
        "--out", metavar="FOLDER", help="where the drives are put, and what is known of them; the same again goes on"
    )
    it.add_argument("--shaft", metavar="NAME", help="which of several shafts; its twins follow, others stay")
    it.add_argument(
        "--vary",
        action="extend",
        nargs="+",
        default=[],
        metavar="KEY=LO:HI:N",
        help="N values from LO to HI; also KEY=VALUE,VALUE,… and KEY=fixed",
    )
    it.add_argument(
        "--spaced",
        action="extend",
        nargs="+",
        default=[],
        metavar="KEY=LO:HI:STEP",
        help="values from LO on, STEP apart, up to HI",
    )
    it.add_argument("--most", action="extend", nargs="+", metavar="NAME=X", help="power_W, mass_kg, seat_mm, price_EUR")
    it.add_argument("--least", action="extend", nargs="+", metavar="NAME=X", help="margin_percent")
    it.add_argument(
        "--limit",
        action="extend",
        nargs="+",
        metavar="ID",
        help="findings that are limits beside the usual ones; * for any",
    )
    it.add_argument(
        "--objectives", metavar="NAME,…", help="some of power, mass, seat, price, margin (default: all that are known)"
    )
    it.add_argument("--rows", type=int, metavar="N", help="drives that are solved whole and saved (default: 60)")
    it.add_argument("--processes", type=int, metavar="N", help="default: one for each core")
    it.add_argument(
        "--time",
        "--seconds",
        type=float,
        metavar="SECONDS",
        help="end the search after so long, with the drives known by then",
    )
    it.add_argument(
        "--scheduler", metavar="ADDRESS", help="of dask.distributed, whose workers search instead: tcp://HOST:8786"
    )
    it.add_argument(
        "--evaluations", type=int, metavar="N", help="whole solutions of the search without proof (default: 1600)"
    )
    it.add_argument("--seed", type=int, metavar="N", help="of the search without proof (default: 1)")
    it.add_argument("--dry", action="store_true", help="say what would be searched, and search nothing")
    json_option(it)
    quiet_option(it, "leave out what is said while it searches")
    it.add_argument("--pick", type=int, metavar="N", help="write drive N of the folder into the file")
    output_option(it, "NEW.toml", "with --pick: into this file instead")


@command("compare", "two designs side by side: what got better and worse, the inputs that differ")
def compare(it: argparse.ArgumentParser) -> None:
    it.add_argument("a", metavar="A", help="a design file")
    it.add_argument("b", metavar="B", help="another one, or the same")
    kinds = it.add_mutually_exclusive_group()
    json_option(kinds, "print one JSON object, with all that differs")
    kinds.add_argument(
        "-o", "--output", metavar="OUT.pdf", help="write the comparison as a PDF report, which verify checks"
    )
    all_option(it, "then all checks and values that differ, tables of one design written out")
    quiet_option(it, "print the conclusion alone")
    it.add_argument("--lang", choices=LANGUAGES, default="en", help="of the PDF (default: %(default)s)")


@command("sweep", "many designs at once, a row of a table for each; one that was ended goes on where it stood")
def sweep(it: argparse.ArgumentParser) -> None:
    it.add_argument("file")
    it.add_argument(
        "--vary",
        action="extend",
        nargs="+",
        default=[],
        metavar="KEY=LO:HI:N",
        help="inputs to vary over a grid; also KEY=VALUE,VALUE,…; drawn at random: KEY=LO:HI",
    )
    it.add_argument(
        "--tolerance",
        action="extend",
        nargs="+",
        default=[],
        metavar="KEY=T",
        help="inputs that scatter by ±T, three standard deviations, about what the design has; also KEY=LOWER:UPPER "
        "(with --monte-carlo)",
    )
    ways = it.add_mutually_exclusive_group()
    ways.add_argument(
        "--hypercube", type=int, metavar="N", help="N designs at random that fill every range evenly (Latin hypercube)"
    )
    ways.add_argument("--monte-carlo", type=int, metavar="N", help="N designs at random, each by itself")
    ways.add_argument(
        "--list", metavar="FILE.csv", help="the designs of a table: keys in the first line, a design in each other one"
    )
    it.add_argument(
        "--seed", type=int, default=1, metavar="N", help="of what is drawn at random (default: %(default)s)"
    )
    set_option(it, "change inputs first")
    it.add_argument("--step", help="this step only; imbalance alone computes thousands of designs in a second")
    it.add_argument("--values", action="extend", nargs="+", default=[], metavar="VALUE_ID", help="these columns only")
    output_option(it, "OUT", "a .csv or .parquet file (default: -, CSV to standard output)")
    quiet_option(it, "print no progress and no summary")
    it.add_argument("--processes", type=int, metavar="N", help="default: one for each core")
    it.add_argument(
        "--scheduler", metavar="ADDRESS", help="of dask.distributed, whose workers compute instead: tcp://HOST:8786"
    )


@command("export", "a file for other programs or the shop: values, results, drawings")
def export(it: argparse.ArgumentParser) -> None:
    from .exports.kinds import KINDS  # with texts, which no other command needs to be understood

    it.add_argument("file")
    group = it.add_argument_group("kinds of files").add_mutually_exclusive_group()
    for kind in KINDS.values():
        group.add_argument(
            f"--{kind.name}",
            action="store_const",
            const=kind.name,
            dest="kind",
            help=f"{kind.what} ({', '.join(f'.{ending}' for ending in kind.endings)})",
        )
    drawn = it.add_argument_group("of a drawing (--dxf)")
    which = drawn.add_mutually_exclusive_group()
    which.add_argument("--gear", metavar="WHEEL", help="draw this wheel, with its table of data, instead of the shaft")
    which.add_argument(
        "--gears", action="store_true", help="draw the whole train; so does --dxf where a design has no shaft"
    )
    drawn.add_argument(
        "--chord-error",
        type=float,
        metavar="UM",
        help="how far a tooth's straight pieces may stand off (default: 1 µm)",
    )
    solid = it.add_argument_group("of solids (--step)")
    part = solid.add_mutually_exclusive_group()
    part.add_argument("--shaft", metavar="NAME", help="this shaft alone")
    part.add_argument("--wheel", metavar="NAME", help="this wheel, with its teeth, in place of the shafts")
    part.add_argument("--module", action="store_true", help="all shafts and wheels where they stand, as an assembly")
    solid.add_argument("--drilled", action="store_true", help="with its holes at their greatest depth")
    solid.add_argument("--teeth", action="store_true", help="teeth in place of the blank of a shaft's own wheel")
    solid.add_argument("--blank", action="store_true", help="wheels as cylinders of the reference diameter")
    solid.add_argument(
        "--allowance", choices=("none", "max", "min"), help="teeth at this end of their allowance (default: none)"
    )
    instead = it.add_argument_group("instead of the values (--csv)").add_mutually_exclusive_group()
    instead.add_argument("--transfer", action="store_true", help="the transfer functions of the mounts")
    instead.add_argument("--map", action="store_true", help="the strikes of the gears over speed and load")
    loads = it.add_argument_group("of the loads (--loads)")
    loads.add_argument(
        "--speeds",
        metavar="LO:HI:STEP",
        help="of the crank, in rpm (default: from idle to rated speed in ten steps)",
    )
    loads.add_argument(
        "--variant",
        choices=("half", "shaft", "scatter", "tooth"),
        help="of the balancing: without shafts, as designed, as they scatter, one tooth off (default: shaft)",
    )
    output_option(
        it, "PATH", "the file; without a kind its ending decides; -: standard output, with a kind", required=True
    )
    it.add_argument("--lang", choices=LANGUAGES, default="en", help="of words in the file (default: %(default)s)")
    quiet_option(it, "print the names of the files alone")


@command("session", "the guided session in a browser, on this machine only")
def serve(it: argparse.ArgumentParser) -> None:
    it.add_argument("file", nargs="?")
    it.add_argument(
        "--port", type=int, default=8000, metavar="N", help="of the address 127.0.0.1:N (default: %(default)s)"
    )


@command("scenarios", "a train under several conditions side by side: the friction thesis' three, or a design's own")
def scenarios(it: argparse.ArgumentParser) -> None:
    it.add_argument(
        "files", nargs="*", metavar="FILE", help="designs with [[friction.scenarios]] (default: those of the thesis)"
    )
    it.add_argument(
        "-o", "--output", metavar="FOLDER", help="also write the curves as CSV and a report as PDF for each design"
    )
    json_option(it)


@command("published", "values printed, worked out or measured by others beside ours; what is not met, and why")
def validate(it: argparse.ArgumentParser) -> None:
    json_option(it)


@command("published", "what is wrong in the documents behind this program, with the right values")
def errata(it: argparse.ArgumentParser) -> None:
    it.add_argument(
        "source", nargs="?", metavar="SOURCE", help="one document, by a word of its name: finotti, textbook, friction"
    )
    written = it.add_mutually_exclusive_group()
    json_option(written)
    written.add_argument("--markdown", action="store_true", help="all of it as a page of tables")


@command("published", "the oils a design may name, or one with the source and confidence of every value")
def oils(it: argparse.ArgumentParser) -> None:
    it.add_argument("name", nargs="?", metavar="NAME", help="like '5W-30'; left out: all")
    json_option(it)


@command("published", "the journals of balance shafts that makers print, or all of one engine's sheet with its address")
def makers(it: argparse.ArgumentParser) -> None:
    it.add_argument("name", nargs="?", metavar="NAME", help="an engine, or a word of its name; left out: all")
    json_option(it)


@command("setup", "the JSON Schema of a design file, by which editors complete and check it, or of the results")
def schema(it: argparse.ArgumentParser) -> None:
    of = it.add_mutually_exclusive_group()
    of.add_argument(
        "--schema", type=int, choices=(1, 2), default=2, help="1: of designs as version 0.1 wrote them (default: 2)"
    )
    of.add_argument("--results", action="store_true", help="of the object that check --json and export --json give")
    output_option(it, "OUT.json", "default: -, to standard output")


@command("setup", "the script by which a shell completes commands and options")
def completion(it: argparse.ArgumentParser) -> None:
    it.add_argument("shell", choices=("bash", "zsh", "fish", "tcsh", "powershell"))


@command("published", "the publications behind the program: title, edition, status, and how we know what each says")
def sources(it: argparse.ArgumentParser) -> None:
    it.add_argument(
        "name", nargs="?", metavar="NAME", help="a publication, or a word of its name or title; left out: all"
    )
    json_option(it)


@command("setup", "how a command is used, or which commands there are")
def help_(it: argparse.ArgumentParser) -> None:
    it.add_argument("topic", nargs="?", metavar="COMMAND")


@command("session", "the guided session (the same as no command)")
def session(it: argparse.ArgumentParser) -> None:
    it.add_argument("file", nargs="?")
    it.add_argument("--ascii", action="store_true", help="plain signs for terminals without Unicode")
    it.add_argument("--lang", choices=LANGUAGES, help="English or Italian, this time (default: as set in the session)")


def parser(*only: str) -> Parser:
    """Of these commands, or of all."""
    top = Parser(
        prog="contralbero",
        description=ABOUT,
        epilog="contralbero help COMMAND tells more. contralbero [FILE] [--lang en|it] [--ascii] opens the guided "
        "session.",
    )
    top.add_argument("--version", action="version", version=f"contralbero {VERSION}")
    # saves formatting it
    commands = top.add_subparsers(dest="command", metavar="COMMAND", title="commands", prog="contralbero")
    for name in only or COMMANDS:
        _, about, arguments = COMMANDS[name]
        it = commands.add_parser(name, help=about, description=about[0].upper() + about[1:] + ".")
        arguments(it)
        it.set_defaults(refuse=it.refuse)  # says how this command is used
    return top
