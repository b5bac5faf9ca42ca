#!/usr/bin/env python3
"""link_pages.py FILE.md: prints a page of docs/ as Doxygen wants it.

The pages are written for readers of the repository: their links lead to files beside them. On the site, links to other
pages lead to those, links to headers to the headers' pages; others, those to a title of the same page too, become plain text.
"""
import pathlib
import re
import sys

LINK = re.compile(r"(?<!!)\[(?P<text>[^\]]+)\]\((?P<to>[^)\s]+)\)")
PICTURE = re.compile(r"!\[(?P<text>[^\]]*)\]\((?P<to>[^)\s]+)\)")


def linked(match, folder):
    text, to = match["text"], match["to"].split("#")[0]
    if re.match(r"(https?|mailto|@ref|\\ref)", to):
        return match[0]
    if not to:  # a title of the same page, which Doxygen does not know by GitHub's name
        return text
    file = (folder / to).resolve()
    if file.suffix == ".md" and file.is_file() and file.parent == folder:
        return f"[{text}](@ref page_{file.stem})"
    if file.suffix == ".md" and file.is_file() and file.parent == folder / "doxygen":
        name = re.search(r"{#(\w+)}", file.read_text(encoding="utf-8"))[1]
        return f"[{text}](@ref {name})"
    if "/include/ogive/" in str(file):
        return f"[{text}](@ref {file.name})" if is_only(file) else text
    return text


def is_only(header):
    """Whether no other header has this name: else Doxygen could not tell them apart."""
    root = next(p for p in header.parents if p.name == "ogive")
    return sum(1 for _ in root.rglob(header.name)) == 1


def main():
    path = pathlib.Path(sys.argv[1]).resolve()
    text = path.read_text(encoding="utf-8")
    if "{#" not in text.split("\n", 1)[0]:
        text = re.sub(r"\A# (.*)$", rf"# \1 {{#page_{path.stem}}}", text, count=1, flags=re.M)
    text = PICTURE.sub(lambda m: f"![{m['text']}]({pathlib.Path(m['to']).name})", text)
    text = LINK.sub(lambda m: linked(m, path.parent), text)
    print(text, end="")


if __name__ == "__main__":
    main()
