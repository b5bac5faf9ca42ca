#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""link_results.py PAGE.html: lets the page of results, copied into the site, lead to the site's pages.

In the repository it lies beside the pages of docs/ and leads to those.
"""
import pathlib
import re
import sys

page = pathlib.Path(sys.argv[1])
text = page.read_text(encoding="utf-8")
page.write_text(re.sub(r'href="\.\./(\w+)\.md"', r'href="../page_\1.html"', text), encoding="utf-8")
