# SPDX-License-Identifier: BSD-3-Clause
"""results COMMAND [option]...: each command calls a function of one module."""

import argparse
import os
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path

from .data import PAGE, ROOT, InputError


class OneLineParser(argparse.ArgumentParser):
    """Refuses a wrong command line in one line with status 2."""

    def error(self, message):
        message = re.sub(r"^argument ([^:]*): ", r"\1: ", message).replace(": = ", " = ")
        self.exit(2, f"{self.prog}: error: {message}\n")


def positive(text):
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"= {text}: must be a whole number from 1")
    return int(text)


def read_options():
    parser = OneLineParser(prog="results", description="Checks, page, pictures and tables of the results.")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    def command(name, module, function, about):
        added = commands.add_parser(name, help=about, description=f"{about[0].upper()}{about[1:]}.", prog=name)
        added.set_defaults(call=(module, function))
        return added.add_argument

    def checked(option):
        option("--checks", type=Path, action="append",
               help="a file with checks; may be repeated [docs/results/acceptance.toml and acceptance_beyond.toml]")
        option("--spacing-mm", type=float, help="particle distance of all runs [as in apps/data/figure_shots.csv]")

    def inserted(option):
        option("--insert", action="store_true", dest="put_in", help="put the tables into their page in docs/, too")

    option = command("accept", "verdicts", "accept", "check results; status 1 if a check fails or lacks its data")
    option("folder", nargs="?", type=Path, default=PAGE / "data", help="of a page or a campaign [docs/results/data]")
    option("--figures", action="store_true", help="print the verdicts on each figure, in Markdown, instead")
    option("--reasons", action="store_true", help="print the reason for each bound, too")
    checked(option)

    option = command("page", "page", "make_page", "make the page of the results of a campaign")
    option("folder", type=Path, help="of a campaign, vtk_out/figures for example")
    option("out", type=Path, help="folder for the page, docs/results for example")
    checked(option)

    option = command("published", "published", "take_published",
                     "put the shots of a page where the programs of the figures find them as done")
    option("page", type=Path, help="docs/results for example")
    option("folder", type=Path, help="of a campaign, vtk_out/figures for example")

    option = command("figures", "figures", "make_figures",
                     "run or resume all shots of the paper's figures, draw them and make the page. What is done is not done "
                     "again. FIGURES, PAGE and PROGRAMS name other folders for shots, page and programs")
    option("--quick", action="store_true", help="particles 1.5 mm apart, in vtk_out/figures_quick and its page/")
    option("--page", action="store_true", dest="page_only", help="run no shots; draw what is missing and make the page")
    option("--published", action="store_true", help="take shots and pictures of the page as done; run no shots for pictures")
    option("--method", choices=("paper", "stabilised"), default="paper", help="of the shots, beside those there [paper]")
    option("--jobs", type=positive, help="shots at a time [as many as cores]")

    option = command("tables", "tables", "make_tables", "print the tables of a page in docs/ that have this name")
    option("name", help="a wrong name lists all")
    option("--run", dest="run_missing", action="store_true", help="run the cases that vtk_out/bench lacks, first")
    option("--jobs", type=positive, help="cases at a time, with --run")
    inserted(option)

    option = command("validate", "tables", "validate",
                     "run or resume all comparisons with tests, put their tables into docs/ and the README and draw measured "
                     "and computed limits. What is done is not done again")
    option("--page", action="store_true", dest="page_only", help="run nothing; make tables and plot of what is known")
    option("--jobs", type=positive, help="cases at a time")

    option = command("gallery", "gallery", "make_gallery", "print the gallery of docs/gallery.md")
    option("--run", dest="run_missing", action="store_true", help="run and draw the shots that bench/rows lacks, first")
    option("--program", type=Path, help="[build/release/apps/ogive, which is built]")
    inserted(option)

    option = command("fits", "fits", "make_fits", "fit the laws to synthetic curves (Figs. 1 to 3) and print their tables")
    option("--curves", type=Path, help="folder with measured curves instead: weldox_460e.csv, aa5083_h116.csv or both")
    option("--folder", type=Path, default=ROOT / "build" / "figures_1_to_3", help="for the fits [build/figures_1_to_3]")
    option("--program", type=Path, help="[build/release/apps/ogive, which is built]")
    inserted(option)

    option = command("performance", "performance", "make_tables", "print the tables of docs/performance.md")
    option("file", type=Path, help="what bench_step has printed")
    option("--before", type=Path, help="what that of an earlier version printed: to be compared with")
    inserted(option)

    option = command("insert", "insert", "insert_input",
                     "put tables from standard input between the two equal lines of a page that name them")
    option("page", type=Path)
    option("--mark", help="the two lines around all of the input, 'tables: COMMAND' for example")
    return vars(parser.parse_args())


def main():
    options = read_options()
    module, function = options.pop("call")
    os.environ.setdefault("GOMP_SPINCOUNT", "3000")  # as the programs do for themselves
    try:
        return getattr(import_module(f".{module}", __package__), function)(**options)
    except InputError as error:
        print(f"results: error: {error}", file=sys.stderr)
        return 2
    except subprocess.CalledProcessError as error:
        print(f"results: error: {error.cmd[0]} ended with status {error.returncode}", file=sys.stderr)
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        print(f"results: error: {where}{error.strerror or error}", file=sys.stderr)
    return 3


sys.exit(main())
