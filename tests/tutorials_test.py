#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""tutorials_test.py <ogive> <folder>: runs the commands of docs/doxygen/tutorials.md and compares their output with it.

A comment before a block of code in the page marks it:

    <!-- file NAME -->   the block is written to that file
    <!-- run -->         bash runs the block; it must succeed
    <!-- prints -->      the block that ran before printed these lines; `...` replaces any number of lines

Words must be equal. Numbers may differ by 3 %, or by one unit of the last decimal place: other processors and compilers
round differently, which changes the last bits of a run and, near a limit, more. Numbers below 1e-6 are round-off and count
as equal. Times, speeds of the computation, memory and threads depend on the machine and are not compared.
Skipped where a program is missing that the page needs.
"""
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

SKIPPED = 77
TOLERANCE = 0.03
ROUND_OFF = 1e-6
ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs/doxygen/tutorials.md"
MARKED = re.compile(r"^<!-- (file \S+|run|prints) -->\n```\w*\n(.*?)^```$", re.M | re.S)
ANY = "..."
MACHINE = re.compile(r"\d[\d.]*(?= (?:s|steps/s|ns|MB|threads)\b)")
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
# The page compiles for speed; the test for a short compilation.
FAST, QUICKLY_COMPILED = "-O3 -march=native", "-O1"
ogive, folder = sys.argv[1:3]


def blocks(page):
    """(kind, text, line) of each marked block, in the order of the page."""
    return [(match[1], match[2], page.count("\n", 0, match.start()) + 1) for match in MARKED.finditer(page)]


def is_close(expected, printed):
    """Whether two numbers, as written, are equal within the tolerance."""
    a, b = float(expected), float(printed)
    if max(abs(a), abs(b)) < ROUND_OFF:
        return True
    decimals = re.search(r"\.(\d+)$", expected)
    last_place = 10.0 ** -len(decimals[1]) if decimals else 0.0
    return abs(a - b) <= TOLERANCE * abs(a) + last_place * (1 + 1e-9)


def is_same(expected, printed):
    """Whether a line has the expected words, and numbers within the tolerance."""
    expected, printed = (MACHINE.sub("§", line) for line in (expected, printed))
    if [part.split() for part in NUMBER.split(expected)] != [part.split() for part in NUMBER.split(printed)]:
        return False
    return all(map(is_close, NUMBER.findall(expected), NUMBER.findall(printed)))


def first_missing(expected, printed):
    """The first expected line that is not printed in its place, or else one that is printed and not expected, or None."""
    printed = [line for line in printed.splitlines() if line.strip()]
    k, skips = 0, False
    for line in expected.splitlines():
        if line.strip() == ANY:
            skips = True
        elif line.strip():
            while skips and k < len(printed) and not is_same(line, printed[k]):
                k += 1
            if k == len(printed) or not is_same(line, printed[k]):
                return line
            k, skips = k + 1, False
    return None if skips or k == len(printed) else f"(nothing more, but printed is) {printed[k]}"


def missing_needs():
    """Names of what the page needs and this machine lacks."""
    programs = [name for name in ("bash", "g++", "gnuplot") if not shutil.which(name)]
    files = [name for name in ("/usr/include/eigen3/Eigen/Core", "/usr/share/javascript/three/three.min.js")
             if not Path(name).exists()]
    return programs + files


def prepare(where):
    """Makes a folder with `bin/ogive` and the project's folders that the page names; the environment to run in it."""
    shutil.rmtree(where, ignore_errors=True)
    (where / "bin").mkdir(parents=True)
    (where / "bin/ogive").symlink_to(Path(ogive).resolve())
    for name in ("examples", "include", "scripts"):
        (where / name).symlink_to(ROOT / name)
    return {**os.environ, "PATH": f"{where / 'bin'}:{os.environ['PATH']}", "OMP_NUM_THREADS": "1"}


class Tutorials(unittest.TestCase):
    def test_page(self):
        where = Path(folder).resolve()
        environment = prepare(where)
        printed = compared = ""
        for kind, text, line in blocks(PAGE.read_text(encoding="utf-8")):
            place = f"{PAGE.name}:{line}"
            if kind.startswith("file "):
                (where / kind.split()[1]).write_text(text, encoding="utf-8")
            elif kind == "run":
                commands = text.replace(FAST, QUICKLY_COMPILED)
                done = subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=where, env=environment, text=True,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
                printed = done.stdout
                self.assertEqual(0, done.returncode, f"{place}: the commands failed:\n{printed}")
            else:
                compared += text
                missing = first_missing(text, printed)
                self.assertIsNone(missing, f"{place}: not printed: {missing}\nPrinted was:\n{printed}")
        self.assertGreater(len(compared.splitlines()), 50)

    def test_every_marker_has_a_block(self):
        page = PAGE.read_text(encoding="utf-8")
        self.assertEqual(page.count("<!-- "), len(blocks(page)))

    def test_comparison(self):
        page = "a 1.00 m/s\n...\nlimit 166.0 +- 5.0, 3 s\n"
        for printed in ("a 1.00 m/s\nlimit 166.0 +- 5.0, 3 s", "a 1.03 m/s\n\nx\ny\nlimit   163.0 +- 5.1, 900 s\n"):
            self.assertIsNone(first_missing(page, printed), printed)
        for printed in ("", "a 1.00 m/s", "b 1.00 m/s\nlimit 166.0 +- 5.0, 3 s", "a 1.1 m/s\nlimit 166.0 +- 5.0, 3 s",
                        "a 1.00 m/s\nlimit 150.0 +- 5.0, 3 s", "a 1.00 m/s\nlimit 166.0 +- 5.0, 3 s\nmore",
                        "x\na 1.00 m/s\nlimit 166.0 +- 5.0, 3 s"):
            self.assertIsNotNone(first_missing(page, printed), printed)
        self.assertTrue(is_same("error 5.0e-10", "error 1.7e-09"))
        self.assertFalse(is_same("7 shots run", "8 shots run"))


if __name__ == "__main__":
    lacking = missing_needs()
    if lacking:
        print("SKIPPED: missing", ", ".join(lacking))
        sys.exit(SKIPPED)
    # One processor: shots of a study end in the same order everywhere, and other tests keep theirs.
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    unittest.main(argv=sys.argv[:1])
