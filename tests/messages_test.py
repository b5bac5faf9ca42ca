#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""messages_test.py [--insert]: docs/messages.md lists each warning and each fault that stops a run, and no message that the
sources lack; docs/setup_errors.md has the table of all set-up errors, which --insert makes.

Messages are the string literals in the calls that throw or print them, with … for values between them.
"""
import pathlib
import re
import sys
import unittest
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "messages.md"
TABLE_PAGE = ROOT / "docs" / "setup_errors.md"
MARK = "tables: tests/messages_test.py --insert"

TOKEN = re.compile(r"""(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<raw>R"(?P<d>[^(\s"]*)\(.*?\)(?P=d)")|(?P<text>"(?:\\.|[^"\\\n])*")
                       |(?P<char>'(?:\\.|[^'\\\n])+')|(?P<number>\.?\d[\w.']*)|(?P<name>[A-Za-z_]\w*)|(?P<blank>\s+)|(?P<sign>.)""",
                   re.S | re.X)
GAP = "…"
FORMAT = re.compile(r"%[-+#0]*[\d.*]*[a-zA-Z]")


class Token(NamedTuple):
    kind: str
    text: str
    line: int


def tokens_of(text):
    found, line = [], 1
    for match in TOKEN.finditer(text):
        if match.lastgroup not in ("comment", "blank"):
            found.append(Token(next(kind for kind in ("raw", "text", "char", "number", "name", "sign") if match[kind]), match[0],
                               line))
        line += match[0].count("\n")
    return found


def closing(tokens, begin):
    """The place of the bracket that closes the one at `begin`, and the places of the commas between its arguments."""
    depth, commas = 0, []
    for k in range(begin, len(tokens)):
        if tokens[k].kind != "sign":
            continue
        depth += (tokens[k].text in "([{") - (tokens[k].text in ")]}")
        if depth == 0:
            return k, commas
        if tokens[k].text == "," and depth == 1:
            commas.append(k)
    raise ValueError(f"line {tokens[begin].line}: a bracket is not closed")


def literal(token):
    text = re.sub(r"\\(.)", lambda m: {"n": " ", "r": "", "t": " "}.get(m[1], m[1]), token.text[1:-1])
    return FORMAT.sub(GAP, text).replace("%%", "%")


def is_text(tokens, k):
    """Whether a token is part of a message: no key in brackets or in at(), and nothing that is compared."""
    before = "".join(token.text for token in tokens[max(0, k - 2):k])
    return tokens[k].kind == "text" and not before.endswith(("[", "at(", "=="))


def message(tokens):
    """The literals of an expression with … for what is between them; of a choice both texts, with "or" between."""
    text, begins, k = "", [0], 0
    while k < len(tokens):
        sign = tokens[k].text if tokens[k].kind == "sign" else ""
        if sign == "?" and [token.kind for token in tokens[k + 1:k + 4]] == ["text", "sign", "text"]:
            both = [part for part in (literal(tokens[k + 1]), literal(tokens[k + 3])) if part]
            between = "; or: " if any(" or " in part for part in both) else " or "
            text = text[:begins[-1]] + between.join(both)  # without the condition
            k += 3
        elif is_text(tokens, k):
            text += literal(tokens[k])
        elif sign == "(":
            begins.append(len(text))
        elif sign == ")" and len(begins) > 1:
            begins.pop()
        elif sign not in ("+", "(", ")") and not text.endswith(GAP):
            text += GAP
        k += 1
    return re.sub(f"{GAP}+", GAP, text).strip()


class Call(NamedTuple):
    file: str
    line: int
    name: str
    receiver: str  # of a member function
    arguments: list


def sources():
    return {str(file.relative_to(ROOT)): tokens_of(file.read_text(encoding="utf-8"))
            for folder in ("include", "apps") for file in sorted((ROOT / folder).rglob("*.[ch]pp"))}


def calls_in(file, tokens, names):
    for k in range(len(tokens) - 1):
        if tokens[k].kind == "name" and tokens[k].text in names and tokens[k + 1].text in "({":
            end, commas = closing(tokens, k + 1)
            edges = [k + 1, *commas, end]
            arguments = [message(tokens[a + 1:b]) for a, b in zip(edges, edges[1:])]
            receiver = tokens[k - 2].text if k > 1 and tokens[k - 1].text in (".", "->") else ""
            yield Call(file, tokens[k].line, tokens[k].text, receiver, arguments)


def statements(tokens):
    begin = 0
    for k, token in enumerate(tokens):
        if token.kind == "sign" and token.text in ";{}":
            if k > begin:
                yield tokens[begin:k]
            begin = k + 1


# Messages that are printed or stop a run.

# Where "warning: " is printed, and the calls whose texts are warnings.
PRINTERS = {"apps/shot/run.cpp", "apps/ogive/materials/materials.cpp", "apps/study/study.cpp"}
WARNINGS = {("include/ogive/material/doubts.hpp", "push_back", "doubts"),
            ("include/ogive/material/doubts.hpp", "emplace_back", "doubts"),
            ("apps/materials/certificate.cpp", "push_back", "warnings"),
            ("apps/shot/plates.cpp", "push_back", "all"), ("apps/shot/plates.cpp", "add", "")}
NOTES = "messages"  # of ogive calibrate, a list of this name; a lambda `note` adds to it
# Where the line of a fault is streamed into `what`.
FAULT_FILES = ("include/ogive/sim/guard.hpp", "include/ogive/sim/run.hpp")
PROGRESS = "apps/shot/progress.hpp"  # the line that is overwritten all the time


def streamed(file, tokens):
    """(place, text) of each `auto what = text_stream()` with all that goes into it."""
    found = []
    for one in statements(tokens):
        names = [token.text for token in one]
        if names[:3] == ["auto", "what", "="]:
            found.append([f"{file}:{one[0].line}", ""])
        elif names[:3] == ["what", "<", "<"] and found:
            found[-1][1] += message(one)
    return [tuple(one) for one in found]


def reported(all_sources):
    """(place, text) of each warning, fault, line on standard error and failure to write."""
    found = []
    for file, tokens in all_sources.items():
        for call in calls_in(file, tokens, {"push_back", "emplace_back", "note", "add", "write_error", "fprintf", "node_fault",
                                            "Fault"}):
            place = f"{file}:{call.line}"
            if file == PROGRESS:
                continue
            if call.name in ("push_back", "emplace_back", "add") and call.receiver != NOTES and (
                    file, call.name, call.receiver) not in WARNINGS:
                continue
            if call.name == "fprintf":
                found.append((place, re.sub(r"^(?:ogive \w+|…): ", "", call.arguments[1])))
            else:
                found.append((place, max(call.arguments, key=len)))
        if file in FAULT_FILES:
            found += streamed(file, tokens)
    return [(place, text) for place, text in found if re.search(r"[a-z]{3}.* .*[a-z]{3}", text.replace(GAP, ""))]


# The page.

PLACEHOLDER = re.compile(r"\b[A-Z]{3,}(?::[A-Z]{3,})?\b|(?<![\w.])\d+(?:\.\d+)?(?![\w.])")


def spans(page):
    """The messages in the first column of the tables, with … for values."""
    for line in page.splitlines():
        if line.startswith("| ") and not line.startswith(("| message", "| status")):
            for span in re.findall(r"`([^`]+)`", line.split(" | ")[0]):
                yield span


def pieces(span):
    """The words of a message on the page between values, numbers and names in capitals."""
    span = PLACEHOLDER.sub(GAP, re.sub(r"^warning: ", "", span))
    return [piece for piece in (part.strip(" :=,;") for part in span.split(GAP)) if len(piece) > 1]


def is_listed(text, span):
    """Whether a message on the page is an abbreviation of the text, or has all of its longest part."""
    at, parts = 0, pieces(span)
    for part in parts:
        at = text.find(part, at)
        if at < 0:
            break
        at += len(part)
    longest = max((part.strip(" :=,;") for part in text.split(GAP)), key=len)
    return (at >= 0 and sum(map(len, parts)) >= 8) or longest in span


def is_in(piece, texts):
    """Whether the sources have it; an option may be there by its key."""
    return any(piece in text or re.sub("^--", "", piece).replace("-", "_") in text for text in texts)


# Set-up errors.

GROUPS = [
    ("Options and cases", ("apps/options", "apps/shot", "apps/study", "apps/ogive/limit", "apps/ogive/shoot", "apps/ogive/sweep",
                           "apps/ogive/main")),
    ("Metals, material cards and certificates", ("apps/materials", "apps/cards", "apps/ogive/materials", "include/ogive/material")),
    ("Tensile curves and ballistic limits", ("apps/ogive/calibrate", "include/ogive/fit", "include/ogive/perforation/limit")),
    ("Projectiles, plates and their meshes", ("include/ogive/mesh/", "include/ogive/perforation")),
    ("Your own mesh or profile", ("include/ogive/mesh_io", "include/ogive/io/vtk_mesh", "include/ogive/io/read_profile")),
    ("Pictures, pages and results", ("apps/draw", "apps/view", "apps/ogive", "include/ogive/io")),
    ("Bodies and contacts of programs of your own", ("include/ogive", "apps")),
]
REFUSALS = {"require", "refuse", "refuse_value", "refuse_line", "refuse_checkpoint", "SetupError", "read_error"}
DEFINITIONS = ("include/ogive/core/error.hpp", "apps/options/given.hpp:64", "apps/options/given.hpp:69")


# Texts that begin so are about a file or a line.
PREDICATE = re.compile(r"(?:must|needs?|is|has|have|had|was|were|lies|cannot|ends|its|overlaps|straddles|moves|does|no|contradicts|only|belongs|"
                       r"unexpected|unknown|model|a|the|every|takes|holds|gives)\b")


def without_gap(text):
    return re.sub(f"^(?:{GAP}:? ?)+(?=.)", "", text).strip(" ;:=,")


def refusal(call):
    """(thing, what is allowed) of a call; None if both are values."""
    parts = call.arguments[1 if call.name in ("require", "refuse_value") else 0:]
    if call.name in ("require", "refuse", "refuse_value") and len(parts) > 1:
        thing, text = parts[0], parts[-1]
    else:  # "thing = value: allowed" in one text
        thing, text = "", without_gap(parts[-1])
        if not PREDICATE.match(text) and ": " in text:
            thing, text = text.split(": ", 1)
    thing, text = without_gap(re.sub(f" = {GAP}$", "", thing)), without_gap(text)
    thing = re.sub(rf"^(\w+) = {GAP}\1{GAP}$", r"\1", thing.replace(" =  or ", " or "))
    if re.fullmatch(r"[a-z]+(?:_[a-z]+)*", thing) and call.file.startswith("apps/shot"):
        thing = "--" + thing.replace("_", "-")
    is_known = re.search(r"[a-z]{3}", re.sub(rf"must be (?:one of )?{GAP}|{GAP}|or empty", "", text))
    return (thing, text) if is_known else None


def cell(text):
    return re.sub(r"([<>*_#|\[\]])", r"\\\1", text)


def setup_table(all_sources):
    """What is allowed of each thing, by group; things with the same text share a row."""
    groups = {title: {} for title, _ in GROUPS}
    for file, tokens in all_sources.items():
        title = next(title for title, folders in GROUPS if file.startswith(folders))
        for call in calls_in(file, tokens, REFUSALS):
            if call.receiver or f"{file}:{call.line}".startswith(DEFINITIONS) or not (found := refusal(call)):
                continue
            things = groups[title].setdefault(found[1], [])
            if found[0] not in ("", GAP, *things):
                things.append(found[0])
    parts = []
    for title, rows in groups.items():
        lines = [f"| {', '.join(f'`{thing}`' for thing in things) or GAP} | {cell(allowed)} |"
                 for allowed, things in sorted(rows.items(), key=lambda row: not row[1])]
        parts.append("\n".join([f"## {title}", "", "| option, key or quantity | allowed, or what is wrong |", "|---|---|", *lines]))
    return "\n\n".join(["Made by `tests/messages_test.py --insert` from the sources of the version of this page.", *parts])


class Messages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sources = sources()
        cls.page = PAGE.read_text(encoding="utf-8")

    def test_every_message_that_stops_a_run_or_warns_is_listed(self):
        listed = list(spans(self.page))
        found = reported(self.sources)
        self.assertGreater(len(found), 40)
        missing = [f"{place}: {text}" for place, text in found if not any(is_listed(text, span) for span in listed)]
        self.assertEqual([], missing, "\nnot in the first column of a table of docs/messages.md:\n" + "\n".join(missing))

    def test_every_listed_message_is_in_the_sources(self):
        texts = {message(one) for tokens in self.sources.values() for one in statements(tokens)}
        gone = [span for span in spans(self.page) if not all(is_in(piece, texts) for piece in pieces(span))]
        self.assertEqual([], gone)

    def test_warnings_are_printed_where_this_test_reads_them(self):
        printers = {file for file, tokens in self.sources.items()
                    if any(token.kind == "text" and "warning: " in token.text for token in tokens)}
        self.assertEqual(PRINTERS, printers)

    def test_set_up_errors_are_those_of_the_sources(self):
        marked = re.search(rf"(?s)<!-- {MARK} -->\n\n(.*?)\n\n<!-- {MARK} -->", TABLE_PAGE.read_text(encoding="utf-8"))
        self.assertTrue(marked and marked[1] == setup_table(self.sources), "run tests/messages_test.py --insert")

    def test_the_tested_range_of_the_manual_is_that_of_the_warning(self):
        source = (ROOT / "apps" / "shot" / "tested_range.cpp").read_text(encoding="utf-8")
        page = (ROOT / "docs" / "doxygen" / "validation.md").read_text(encoding="utf-8")
        section = re.search(r"(?s)\n## Tested range(.*?)\n## ", page)[1]
        ranges = re.findall(r"constexpr Range \w+\{([\d.]+), ([\d.]+)\}", source)
        self.assertEqual(ranges, re.findall(r"\| ([\d.]+) to ([\d.]+)", section), "must be the same, in the same order")
        metals = re.search(r"string_view, \d+> metals\{(.*?)\}", source, re.S)[1]
        self.assertEqual(re.findall(r'"(\w+)"', metals), re.findall(r"`(\w+)`", section))

    def test_reading(self):
        tokens = tokens_of('require(a < f(b, c), "width (m)" /* m */, w, "must be " + text(x) + " m" +\n"eters"); // require("no")\n'
                           'refuse("--out", s, ok ? "" : "must be \\"new\\"");printf("%.3g us of %d", t, n);')
        first, second, third = calls_in("f", tokens, {"require", "refuse", "printf"})
        self.assertEqual(("width (m)", "must be … meters"), refusal(first))
        self.assertEqual(("--out", 'must be "new"'), refusal(second))
        self.assertEqual("… us of …", third.arguments[0])
        self.assertEqual(["must be", "of the plate"], pieces("warning: METAL: must be … of the plate"))
        self.assertTrue(is_listed("it must be … of the plate", "must be 3 of the plate"))
        self.assertFalse(is_listed("of the plate … it must not be", "must be 3 of the plate"))
        self.assertTrue(is_listed("…: …; they are now in …", "OUT: holds another case; they are now in OTHER"))


if __name__ == "__main__":
    if sys.argv[1:] == ["--insert"]:
        sys.dont_write_bytecode = True
        sys.path.insert(0, str(ROOT / "scripts"))
        from results.insert import insert
        insert(TABLE_PAGE, setup_table(sources()), MARK)
    else:
        unittest.main()
