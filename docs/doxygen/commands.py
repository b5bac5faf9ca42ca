#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""commands.py FOLDER [OGIVE]: writes a page for each subcommand of ogive, and one that lists them, for Doxygen.

The pages are made of `ogive --help` and `ogive COMMAND --help-all`. Where there is no program the only
page names the option that prints them.
"""
import pathlib
import re
import subprocess
import sys

TEXT = 34  # column at which the meanings begin; a longer flag has a line of its own
DEFAULT = re.compile(r"^(.*?)\s*\[([^\[\]]*)\]$")
LIMITS = re.compile(r"^(.*); ((?:numbers )?-?[\d.e+-]+ to -?[\d.e+-]+\b[^;]*)$")
STATUS = re.compile(r"(\d+(?:(?:, | or )\d+)*) (.*)")


def marked(text):
    """Text for Markdown: flags, names and signs that would be marks are code."""
    def word(match):
        if match[0].startswith("<("):
            return f"`{match[0]}`"
        before, inner, after = re.fullmatch(r"([(\"]*)(.*?)([),.;:\"]*)", match[0]).groups()
        return f"{before}`{inner}`{after}" if re.search(r"--|[_*<>@\\#^~|$\[]", inner) else match[0]

    return re.sub(r"<\([^)]*\)|\S+", word, text).replace("|", "\\|")


def table(header, rows):
    return "\n".join(["| " + " | ".join(row) + " |" for row in (header, ["---"] * len(header), *rows)])


def paragraphs(text):
    """(title, lines) of the groups of a help text: those before the first title have an empty one."""
    groups = [("", [])]
    for line in text.splitlines():
        title = re.fullmatch(r"([A-Z][A-Za-z ]*):", line)
        if title:
            groups.append((title[1], []))
        elif line:
            groups[-1][1].append(line)
    return groups


def options_of(lines):
    """(flag, meaning, limits, default, source) of each option; a meaning may take several lines."""
    options = []
    for line in lines:
        if line.startswith("  --"):
            alone = line[TEXT - 1:TEXT].strip()
            options.append([line.strip(), ""] if alone else [line[:TEXT].strip(), line[TEXT:]])
        elif options and line.startswith("   "):
            options[-1][1] += " " + line.strip()
    rows = []
    for flag, meaning in options:
        given = DEFAULT.match(meaning.strip())
        meaning, given = given.groups() if given else (meaning.strip(), "")
        limits = LIMITS.match(meaning)
        meaning, limits = (limits[1], limits[2]) if limits else (meaning, "")
        default, _, source = given.partition(": ")
        rows.append([f"`{flag}`".replace("|", "\\|"), *map(marked, (meaning, limits, default, source))])
    return rows


def page_of(command, summary, text):
    """The page of a command; one whose --help-all is no help has its summary only."""
    page = [f"# ogive {command} {{#command_{command}}}", marked(summary[:1].upper() + summary[1:] + ".")]
    if not text.startswith(f"ogive {command}"):
        return "\n\n".join(page) + "\n"
    exits = re.search(r"(?ms)^Exit status: (.*)", text)
    groups = paragraphs(text[:exits.start()] if exits else text)
    syntax, *purpose = [line for line in groups[0][1] if not line.startswith(("In brackets", "  "))]
    page += ["```\n" + syntax + "\n```", marked(" ".join(purpose))]
    for title, lines in groups:
        if title == "Examples":
            page += ["## Examples", "```\n" + "\n".join(line[2:] for line in lines) + "\n```"]
        elif rows := options_of(lines):
            page += [f"## {title or 'Options'}", table(["option", "meaning", "limits", "default", "source or note"], rows)]
    if exits:
        found = [STATUS.match(part) for part in re.split(r"; (?=\d)", " ".join(exits[1].split()).rstrip("."))]
        page += ["## Exit status", table(["status", "meaning"], [[match[1], marked(match[2])] for match in found])]
    return "\n\n".join(page) + "\n"


def pages(run):
    """Pages by name of file. `run` gives what the program prints for its arguments."""
    commands = re.findall(r"^  ([a-z]+)  +(\S.*)$", run("--help"), re.M)
    rows = [[f"[ogive {command}](@ref command_{command})", marked(summary)] for command, summary in commands]
    index = ["# Commands {#commands}", "Each page lists the options of a command by group, with limits, default and source. The "
             "programs print the same with `--help-all`.", table(["command", "task"], rows)]
    return {"commands.md": "\n\n".join(index) + "\n",
            **{f"command_{command}.md": page_of(command, summary, run(command, "--help-all")) for command, summary in commands}}


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.md"):
        old.unlink()
    if len(sys.argv) > 2 and pathlib.Path(sys.argv[2]).is_file():
        found = pages(lambda *arguments: subprocess.run([sys.argv[2], *arguments], capture_output=True, encoding="utf-8",
                                                        check=True).stdout)
    else:
        found = {"commands.md": "# Commands {#commands}\n\nThis site was built without the programs. They print their options "
                                "with `--help-all`.\n"}
    for name, text in found.items():
        (folder / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
