#!/usr/bin/env python3
"""split_declarators.py FILE: prints a header in which `T a, b; ///< text` has become one declaration for each name.

Doxygen gives such a comment to one of the names only. Each header becomes a page of its own, too. Lines keep their
numbers.
"""
import re
import sys

NAME = r"\w+(?:\{[^{}]*\}| = [^,;{}]+)?"
DECLARATION = re.compile(
    r"^(?P<indent>\s*)(?P<type>(?:inline |static |constexpr |const )*[\w:]+(?:<.*>)?) "
    rf"(?P<names>{NAME}(?:, {NAME})+); *///< (?P<text>.*)$")


def split(line):
    match = DECLARATION.match(line)
    if not match or match["type"] in ("return", "using", "typedef"):
        return line
    names = re.split(r", (?=\w+(?:\{|,| =|$))", match["names"])
    return match["indent"] + " ".join(f"/** {match['text']} */ {match['type']} {name};" for name in names)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        for line in file.read().splitlines():
            print(r"/** \file */" if line == "#pragma once" else split(line))


if __name__ == "__main__":
    main()
