"""Puts tables into a page, each between the two equal lines that name it, such as <!-- table: NAME --> or
<!-- tables: COMMAND -->. A table that the page has no place for is an error, and then nothing is written."""

import re
import sys

from .data import InputError, write_text

MARK = re.compile(r"<!-- tables?: .+ -->")


def sections(text, where):
    """Text in pieces: (mark, lines between its two lines), and (None, lines) for what is between no marks."""
    pieces, mark, lines = [], None, []
    for line in text.splitlines():
        if line == mark or (mark is None and MARK.fullmatch(line)):
            pieces.append((mark, lines))
            mark, lines = None if line == mark else line, []
        else:
            lines.append(line)
    if mark is not None:
        raise InputError(f"{where}: {mark} occurs once: must be before and behind a table")
    return [*pieces, (None, lines)]


def with_tables(page, tables, where):
    """The page with the tables, mark: text, in their places."""
    pieces = sections(page, where)
    for mark in tables:
        if mark not in [place for place, _ in pieces]:
            raise InputError(f"{where}: has no {mark}: must have two such lines, for the table between them")
    lines = []
    for mark, between in pieces:
        if mark in tables:
            between = ["", *tables[mark].strip("\n").splitlines(), ""]
        lines += [mark, *between, mark] if mark else between
    return "\n".join(lines) + "\n"


def insert(page, text, mark=None):
    """Inserts the marked tables of a text, or all of it at `mark`."""
    tables = ({f"<!-- {mark} -->": text} if mark else
              {found: "\n".join(lines) for found, lines in sections(text, "standard input") if found})
    if not any(table.strip() for table in tables.values()):
        raise InputError("standard input: holds no table: must hold at least one")
    write_text(page, with_tables(page.read_text(encoding="utf-8"), tables, page))


def insert_input(page, mark):
    insert(page, sys.stdin.read(), mark)
