#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""check_links.py FOLDER: looks whether all links of a site lead somewhere, without a network.

Every href and src in the .html files of the folder, and every address in Doxygen's menudata.js, must be a file of the
site; a fragment must be an id or name in it. Addresses of other sites are counted, not followed. Prints one line for
each broken link; status 1 if there is one.
"""
import html.parser
import pathlib
import re
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.links, self.anchors = [], set()

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if value and name in ("href", "src"):
                self.links.append((self.getpos()[0], value))
            if value and (name == "id" or (tag == "a" and name == "name")):
                self.anchors.add(value)


def read(path):
    page = Page()
    page.feed(path.read_text(encoding="utf-8", errors="replace"))
    return page


def menu_links(path):
    """(line, address) of the menu, which a script draws on every page."""
    if not path.is_file():
        return []
    return [(1, address) for address in re.findall(r'url:"([^"]+)"', path.read_text(encoding="utf-8"))]


def main():
    if len(sys.argv) != 2 or not pathlib.Path(sys.argv[1]).is_dir():
        sys.exit("check_links: error: give the folder of a site")
    root = pathlib.Path(sys.argv[1]).resolve()
    own = [path for path in sorted(root.rglob("*.html")) if "mathjax" not in path.relative_to(root).parts]
    pages = {path: read(path) for path in own}
    sources = [(path, page.links) for path, page in pages.items()]
    sources.append((root / "menudata.js", menu_links(root / "menudata.js")))
    checked = elsewhere = broken = 0
    for path, links in sources:
        for line, link in links:
            address = urllib.parse.urlsplit(link)
            if address.scheme == "javascript":
                continue
            if address.scheme or address.netloc:
                elsewhere += 1
                continue
            checked += 1
            file = (path.parent / urllib.parse.unquote(address.path)).resolve() if address.path else path
            wrong = None
            if not file.is_relative_to(root) or not file.exists():
                wrong = "no such file"
            elif address.fragment and file in pages:
                if urllib.parse.unquote(address.fragment) not in pages[file].anchors:
                    wrong = "no such place"
            if wrong:
                broken += 1
                print(f"{path.relative_to(root)}:{line}: {link}: {wrong}")
    print(f"{len(pages)} pages, {checked} links checked, {broken} broken; {elsewhere} to other sites not followed")
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()
