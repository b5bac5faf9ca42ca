#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Puts tables from standard input into a page, each between the two equal lines of the page that name it, such as
<!-- table: NAME --> or <!-- tables: COMMAND -->. The input holds the same pairs of lines, or --mark names the one for all
of it. What the input does not hold stays as it was; a table that the page has no place for is an error, and then nothing
is written."""

import re
import sys
from pathlib import Path

import ogive_results
from ogive_results import InputError, write_text

MARK = re.compile(r"<!-- tables?: .+ -->")


def sections(text, where):
    """Text in pieces: (mark, lines between its two lines), and (None, lines) for what is between no marks."""
    pieces, mark, lines = [], None, []
    for line in text.splitlines():
        if mark is None and MARK.fullmatch(line):
            pieces.append((None, lines))
            mark, lines = line, []
        elif line == mark:
            pieces.append((mark, lines))
            mark, lines = None, []
        else:
            lines.append(line)
    if mark is not None:
        raise InputError(f"{where}: {mark} stands alone: must stand before and behind a table")
    return [*pieces, (None, lines)]


def with_tables(page, tables, where):
    """The page with the tables, mark: text, in their places."""
    pieces = sections(page, where)
    places = [mark for mark, _ in pieces if mark]
    for mark in tables:
        if mark not in places:
            raise InputError(f"{where}: has no {mark}: must have two such lines, for the table to stand between")
    lines = []
    for mark, between in pieces:
        if mark in tables:
            between = ["", *tables[mark].strip("\n").splitlines(), ""]
        lines += [mark, *between, mark] if mark else between
    return "\n".join(lines) + "\n"


def main():
    parser = ogive_results.OneLineParser(prog="insert_tables", description=__doc__)
    parser.add_argument("page", type=Path)
    parser.add_argument("--mark", help="what stands in the two lines around all of the input, 'tables: COMMAND' for example")
    o = parser.parse_args()
    text = sys.stdin.read()
    if o.mark is None:
        tables = {mark: "\n".join(lines) for mark, lines in sections(text, "standard input") if mark}
    else:
        tables = {f"<!-- {o.mark} -->": text}
    if not any(table.strip() for table in tables.values()):
        raise InputError("standard input: holds no table: must hold at least one")
    write_text(o.page, with_tables(o.page.read_text(encoding="utf-8"), tables, o.page))
    return 0


if __name__ == "__main__":
    sys.exit(ogive_results.run_main("insert_tables", main))
