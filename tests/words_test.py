#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""words_test.py [OGIVE]: the documents and the help of the program are in the English of technical reports, and links work.

Reads README.md, CONTRIBUTING.md, the pages in docs/, the comments of the sources and, with a program, `ogive --help` and
`ogive COMMAND --help-all`. Code, addresses and generated tables are not read. Each find is reported with its file, its line and the remedy.
"""
import bisect
import functools
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[1]
OGIVE = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None

# What is out, and what to write instead. A blank stands for any white space; patterns begin and end at words.
WORDS = [
    (r"stands?|stood", "is, is listed"),
    (r"(?:tells?|telling|told)(?!(?: \S+){0,3} apart)", "reports, shows"),
    (r"says?|saying|said", "reports, states, shows"),
    (r"(?:is|are|was|were|be) off(?! by default)|off by(?! default)", "the error is; disabled"),
    (r"(?:go|goes|going|went|gone) on(?! (?:to|the|a|an|each|its|this|that))", "resumes, continues"),
    (r"as (?:it is|they are)(?=\s*(?:[.,;:)|]|$))|as usual", "default; unchanged"),
    (r"(?:of|than|as) (?:before|now)", "name the version"),
    (r"ask(?:s|ed|ing)? for", "target, needs"),
    (r"let(?:s|ting)? go", "deactivated"),
    (r"look(?:s|ed|ing)?(?!-up| up)", "check, sample, search, appear"),
    (r"mend(?:s|ed|ing)?", "fix, correct"),
    (r"that is how far|the whole of it", "name the thing"),
    (r"the team|an earlier prototype|not kept|seen before these", "only insiders understand that"),
    (r"without further ado|has nothing to decide", "plain words"),
]
# "What" may begin a question and a title, but not be the subject of a statement.
WHAT = re.compile(r"(?:\A|\n\n|[.!?:;]\s+|\*\*\s+|(?:\A|\n)(?:[-*]|\d+\.) +|\| *)(What\b[^.!?\n|]*(?:\n[^.!?\n|]+)*[.!?|])")

# Whole sentences that may keep such a word, each with the reason.
EXCEPTIONS = {}

# Prose with many numbers is not read: compared numbers belong into a table.
FEW_NUMBERS = ["README.md", "docs/beyond.md", "docs/sensitivity.md", "docs/performance.md",
               "docs/calibration.md", "docs/doxygen/guide.md", "docs/doxygen/tutorials.md", "docs/doxygen/theory.md"]
MOST_NUMBERS = 3
NAMES_WITH_NUMBERS = re.compile(
    r"C\+\+\d+|\b2×2×2\b|\b[a-z] [=≥≤] 0\b|\b(?:Weldox|Hardox|Arne|Armox) \d+(?: [ET])?|\bAA\d+(?:-\w+)?|\b\d-node\b|\b(?:Figs?|Eqs?|Tables?|Version|version)\.? "
    r"[\d.]+(?:(?: to | and |, |–)\d+)*|\b(?:18|19|20)\d\d\b|\(\d{4}[^)]*\)|\b\d+:\d+(?:–\d+)?|\b10\.\d{4,}/\S+"
    r"|\b(?:Debian|GCC|g\+\+|clang|CMake|Eigen|VTK|Catch|Catch2|Python|Firefox|Chromium|Safari|WebGL|AVX|AVX-|status) ?[\d.]+")
COMMAND = re.compile(r"^  ([a-z]+)  +\S", re.M)
NUMBER = re.compile(r"(?<![\w.^_/{\\-])[−+-]?\d+(?:[.,]\d+)*(?![\w}])")


def blank(match):
    """As many characters as it has, in as many lines."""
    return re.sub(r"[^\n]", "§", match[0])


def prose(text):
    """The text without code, generated tables, formulas and addresses; places and lines are those of the text."""
    for pattern in (r"(?s)<!-- (tables?: [^>]*) -->.*?<!-- \1 -->", r"(?ms)^ *```.*?^ *```$", r"(?s)<!--.*?-->",
                    r"(?s)\\f\[.*?\\f\]|\\f\$.*?\\f\$", r"``[^`]+``|`[^`]+`", r"(?<=\])\((?!@ref)[^)\s]+\)", r"https?://\S+",
                    r"(?<=\])\(@ref [^)]*\)", r"\{#\w+\}", r"\\(?:include|snippet|image) \S+"):
        text = re.sub(pattern, blank, text)
    return text


def line_of(text, place):
    ends = [match.start() for match in re.finditer("\n", text)]
    return bisect.bisect_left(ends, place) + 1


def sentence_at(text, place):
    """The sentence around a place, with single blanks."""
    begin = max((match.end() for match in re.finditer(r"[.!?|]\s+|\n\n|\n *[-*] |\A", text) if match.end() <= place), default=0)
    end = re.search(r"[.!?|](?=\s|$)|\n\n|\Z", text[place:])
    return " ".join(text[begin:place + end.end()].split())


def bad_words(text):
    """(place, words, remedy) of each find in prose."""
    finds = []
    for pattern, remedy in WORDS:
        for match in re.finditer(rf"(?i)(?<![\w-])(?:{pattern})(?![\w-])".replace(" ", r"\s+"), text):
            finds.append((match.start(), match[0], remedy))
    for match in WHAT.finditer(text):
        if not match[1].endswith("?"):
            finds.append((match.start(1), "What", "the subject first"))
    return sorted(finds)


def paragraphs(text):
    """(place, text) of each paragraph and item of a list; neither tables nor titles."""
    for block in re.finditer(r"(?:[^\n]+\n?)+", text):
        for item in re.finditer(r"(?:\A|^ *(?:[-*]|\d+\.) )(?:.|\n(?! *(?:[-*]|\d+\.) ))*", block[0], re.M):
            if item[0].strip() and not item[0].lstrip().startswith(("|", "#", "§")):
                yield block.start() + item.start(), re.sub(r"\A\s*\d+\. ", "", item[0])


def documents():
    pages = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
    return {str(page.relative_to(ROOT)): prose(page.read_text(encoding="utf-8")) for page in pages}


def comments():
    """The comments of headers, programs and examples, in their lines."""
    files = [file for folder in ("include", "apps", "examples") for file in sorted((ROOT / folder).rglob("*.[ch]pp"))]
    comment = re.compile(r'^(?:[^"]|"(?:\\.|[^"\\])*")*?//[/!]?<? ?(.*)')
    return {str(file.relative_to(ROOT)): "\n".join(found[1] if (found := comment.match(line)) else "" for line in
                                                   file.read_text(encoding="utf-8").splitlines()) for file in files}


@functools.cache
def help_texts():
    def text_of(*arguments):
        return subprocess.run([OGIVE, *arguments], capture_output=True, text=True, check=True).stdout

    overview = text_of("--help")
    commands = COMMAND.findall(overview)
    return {"ogive --help": overview,
            **{f"ogive {command} --help-all": text_of(command, "--help-all") for command in commands if command != "completion"}}


class Words(unittest.TestCase):
    def assert_plain(self, texts):
        finds = [f"{name}:{line_of(text, place)}: \"{' '.join(words.split())}\": {remedy}"
                 for name, text in texts.items() for place, words, remedy in bad_words(text)
                 if sentence_at(text, place) not in EXCEPTIONS]
        self.assertEqual([], finds, "\n" + "\n".join(finds))

    def test_documents(self):
        self.assert_plain(documents())

    def test_comments(self):
        finds = [f"{name}:{line_of(text, place)}: \"{' '.join(words.split())}\": {remedy}" for name, text in comments().items()
                 for place, words, remedy in bad_words(text) if words != "What"]  # which may begin a title
        self.assertEqual([], finds, "\n" + "\n".join(finds))

    @unittest.skipUnless(OGIVE, "needs the program")
    def test_help(self):
        texts = help_texts()
        self.assertGreater(len(texts), 8)
        self.assert_plain(texts)

    @unittest.skipUnless(OGIVE, "needs the program")
    def test_guide_lists_every_command(self):
        guide = (ROOT / "docs/doxygen/guide.md").read_text(encoding="utf-8")
        for command in COMMAND.findall(help_texts()["ogive --help"]):
            self.assertIn(f"| `ogive {command}` |", guide)

    def test_numbers(self):
        finds = []
        for name, text in documents().items():
            for place, paragraph in paragraphs(text) if name in FEW_NUMBERS else ():
                numbers = NUMBER.findall(NAMES_WITH_NUMBERS.sub(blank, paragraph))
                if len(numbers) > MOST_NUMBERS:
                    finds.append(f"{name}:{line_of(text, place)}: {len(numbers)} numbers: {' '.join(numbers)}")
        self.assertEqual([], finds, "\n" + "\n".join(finds))

    def test_exceptions_are_needed(self):
        kept = {sentence_at(text, place) for text in documents().values() for place, *_ in bad_words(text)}
        self.assertEqual(set(), set(EXCEPTIONS) - kept)

    def test_links_lead_to_files_and_titles(self):
        def anchors(page):
            titles = re.findall(r"(?m)^#+ (.*)$", page.read_text(encoding="utf-8"))
            return {re.sub(r"[^\w\- ]", "", title.lower()).strip().replace(" ", "-") for title in titles}

        broken, checked = [], 0
        for name in documents():
            page = ROOT / name
            text = re.sub(r"(?ms)^ *```.*?^ *```$|`[^`\n]+`", blank, page.read_text(encoding="utf-8"))
            for match in re.finditer(r"\]\((?!@ref|https?:)([^)\s#]*)(?:#([^)\s]+))?\)", text):
                file = page.parent / match[1] if match[1] else page
                # Doxygen finds pictures of docs/ by their names.
                found = file.exists() or (page.parent.name == "doxygen" and (ROOT / "docs" / match[1]).exists())
                checked += 1
                if not found or (match[2] and match[2] not in anchors(file)):
                    broken.append(f"{name}:{line_of(text, match.start())}: {match[0][2:-1]}")
        self.assertGreater(checked, 50)
        self.assertEqual([], broken)

    def test_readme_program_is_the_example(self):
        program = re.search(r"```cpp\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.S)[1]
        example = (ROOT / "examples/01_perforate.cpp").read_text(encoding="utf-8")
        self.assertEqual(re.sub(r"(?m)^//.*\n", "", example), program)

    def test_readme_is_short(self):
        self.assertLessEqual(len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()), 120)

    def test_rules(self):
        for text in ("It stands in\nthe table.", "The error tells us.", "As the paper\nsays, so.", "It is off by 3.", "It goes on.",
                     "Run as usual.", "Take it as it is.", "the result of\nbefore", "ten were asked for", "let go", "have a look", "it was mended",
                     "Good.\nWhat fails is the plug.", "- What is left is noise.", "**Plug.** What is left is noise."):
            self.assertEqual(1, len(bad_words(text)), text)
        for text in ("It tells them apart.", "A look-up.", "They are off by default.", "I understand.", "What fails?",
                     "## What fails\n\nThe plug.", "Say `it stands`: no.".replace("Say", "Write"), "It goes on the node."):
            self.assertEqual([], bad_words(prose(text)), text)

    def test_prose(self):
        text = "a\n<!-- tables: x -->\n| stands |\n<!-- tables: x -->\n```\nlook\n```\nIt stands."
        self.assertEqual([(len(text) - 7, "stands", "is, is listed")], bad_words(prose(text)))
        self.assertEqual(8, line_of(text, len(text) - 7))


if __name__ == "__main__":
    unittest.main()
