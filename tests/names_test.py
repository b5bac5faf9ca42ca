#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""names_test.py OGIVE [--accept]: the commands, options and choices of the program are those of tests/apps/names.txt.

Scripts of users hold these names. Where one is removed or renamed on purpose, note it in CHANGELOG.md (docs/stable.md has the
rule), then --accept writes the list anew; so it does for new names.
"""
import pathlib
import re
import subprocess
import sys
import unittest

NAMES = pathlib.Path(__file__).resolve().parent / "apps" / "names.txt"
OGIVE = sys.argv.pop(1)


def names_in(completion):
    """'command', 'command --option' and '--option choice' from the completion for bash."""
    commands, rest = completion.split("case ${COMP_WORDS[1]} in", 1)
    names = [word for word in re.search(r"words='([^']+)'", commands)[1].split() if not word.startswith("-")]
    for command, flags, choices in re.findall(r"(?ms)^  ([a-z]+)\)\n    words='([^']*)'\n(.*?)^    ;;", rest):
        names += [f"{command} {flag}" for flag in flags.split()]
        names += [f"{flag} {word}" for flag, words in re.findall(r"(--[\w-]+)\) words='([^']*)' ;;", choices)
                  for word in words.split()]
    return sorted(set(names))


def names():
    return names_in(subprocess.run([OGIVE, "completion"], capture_output=True, text=True, check=True).stdout)


class Names(unittest.TestCase):
    def test_names_are_those_of_the_list(self):
        now, listed = set(names()), set(NAMES.read_text(encoding="utf-8").splitlines())
        self.assertGreater(len(now), 300)
        self.assertEqual((sorted(listed - now), sorted(now - listed)), ([], []), "removed and new names: --accept, see above")


if __name__ == "__main__":
    if sys.argv[1:] == ["--accept"]:
        NAMES.write_text("\n".join(names()) + "\n", encoding="utf-8")
    else:
        unittest.main()
