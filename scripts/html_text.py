"""Pieces of HTML, and Markdown as the files in docs/ use it turned into them."""

import html
import re

STYLE = """
:root { color-scheme: light; --line: #d8dee4; --grey: #57606a; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 72rem; padding: 1rem; font: 16px/1.5 system-ui, sans-serif; color: #1f2328;
  background: #fff; }
h1 { font-size: 1.6rem; line-height: 1.25; }
h2 { font-size: 1.25rem; margin: 2.5rem 0 .75rem; padding-top: .5rem; border-top: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1rem 0 .25rem; }
a { color: #0550ae; }
ul { margin: .25rem 0; padding-left: 1.2rem; }
img { max-width: 100%; height: auto; display: block; }
figure { margin: 0 0 1rem; }
figcaption, .note { color: var(--grey); font-size: .875rem; }
.beside { display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); gap: 1.5rem; }
.scroll { overflow-x: auto; margin: .5rem 0; }
table { border-collapse: collapse; font-size: .875rem; }
th, td { border-bottom: 1px solid var(--line); padding: .3rem .6rem; text-align: left; vertical-align: top; }
th { background: #f6f8fa; }
td.number, th.number { text-align: right; }
td.number, td.whole { white-space: nowrap; }
code { font-size: .875em; background: #f6f8fa; padding: 0 .2em; }
summary { cursor: pointer; color: #0550ae; }
.status { display: inline-block; padding: 0 .5em; border-radius: 1em; font-size: .8125rem; font-weight: 600;
  white-space: nowrap; background: #eaeef2; color: #424a53; }
.good { background: #d4f4dd; color: #116329; }
.partly { background: #fff3c4; color: #6f4e00; }
.bad { background: #ffdcd7; color: #a40e26; }
.empty { border: 1px dashed var(--line); padding: 1rem; color: var(--grey); }
@media (max-width: 48rem) {
  body { padding: .75rem; }
  .beside { grid-template-columns: minmax(0, 1fr); gap: 0; }
  td.whole { white-space: normal; min-width: 6rem; }
  .stack thead { display: none; }
  .stack tr { display: block; border-bottom: 1px solid var(--line); padding: .4rem 0; }
  .stack td, .stack td.number { display: block; border: 0; padding: .1rem 0; text-align: left; white-space: normal; }
  .stack td::before { content: attr(data-column) ": "; color: var(--grey); }
}
"""

GRADES = {"reproduced": "good", "pass": "good", "partly": "partly", "not": "bad", "FAIL": "bad"}


def escape(text):
    return html.escape(str(text), quote=True)


def status(word):
    return f'<span class="status {GRADES.get(word, "")}">{escape(word)}</span>'


def table(header, rows, numbers=(), stack=False):
    """A table of cells that are HTML already; columns in `numbers` are flush right, and the first column of such a
    table is not broken. Wide ones scroll by themselves, or with `stack` show their cells one below the other on a
    phone."""
    def cell(tag, k, text):
        grade = "number" if k in numbers else "whole" if k == 0 and numbers and not stack else ""
        attributes = (f' class="{grade}"' if grade else "") + (
            f' data-column="{header[k]}"' if stack and tag == "td" else "")
        return f"<{tag}{attributes}>{text}</{tag}>"

    lines = [f'<div class="scroll"><table{" class=stack" if stack else ""}>', "<thead><tr>" +
             "".join(cell("th", k, h) for k, h in enumerate(header)) +
             "</tr></thead>", "<tbody>"]
    lines += ["<tr>" + "".join(cell("td", k, text) for k, text in enumerate(row)) + "</tr>" for row in rows]
    return "\n".join(lines + ["</tbody></table></div>"])


def unordered(items):
    return "<ul>\n" + "\n".join(f"<li>{item}</li>" for item in items) + "\n</ul>"


def from_markdown_line(text, link_prefix):
    """Code, bold, italics and links within a line. Links to files get `link_prefix`; if it is None they are dropped and
    their text is kept."""
    pieces = []
    for k, piece in enumerate(re.split(r"`([^`]*)`", text)):
        if k % 2:
            pieces.append(f"<code>{escape(piece)}</code>")
            continue
        piece = escape(piece)
        piece = re.sub(r"\*\*([^*]+)\*\*", r"<strong>\1</strong>", piece)
        piece = re.sub(r"(?<![\w*])\*([^*\s][^*]*)\*(?![\w*])", r"<em>\1</em>", piece)
        pieces.append(piece)

    def link(match):
        text, target = match[1], match[2]
        if target.startswith(("http:", "https:")):
            return f'<a href="{target}">{text}</a>'
        return text if link_prefix is None else f'<a href="{escape(link_prefix)}{target}">{text}</a>'

    return re.sub(r"\[([^\]]*)\]\(([^)\s]+)\)", link, "".join(pieces))


def cells_of(line):
    """The cells of a Markdown table's row; a bar after a backslash belongs to the text."""
    parts = re.split(r"(?<!\\)\|", line.strip())[1:]
    if parts and not parts[-1].strip():
        parts = parts[:-1]
    return [part.strip().replace("\\|", "|") for part in parts]


def from_markdown(text, link_prefix=None, heading=3):
    """Headings (the first line's is left out, further ones become h`heading`), paragraphs, lists and tables."""
    def line(one):
        return from_markdown_line(one, link_prefix)

    out, block = [], []

    def flush():
        if not block:
            return
        if block[0].startswith("|"):
            rows = [cells_of(one) for one in block]
            body = [row for k, row in enumerate(rows) if k != 1]
            out.append(table([line(c) for c in body[0]], [[line(c) for c in row] for row in body[1:]]))
        elif block[0].startswith("- "):
            items = []
            for one in block:
                if one.startswith("- "):
                    items.append(one[2:])
                else:
                    items[-1] += " " + one.strip()
            out.append(unordered(line(item) for item in items))
        else:
            out.append(f"<p>{line(' '.join(block))}</p>")
        block.clear()

    for one in text.splitlines():
        if one.startswith("#"):
            flush()
            if not one.startswith("# "):
                out.append(f"<h{heading}>{line(one.lstrip('#').strip())}</h{heading}>")
            continue
        if not one.strip() or (block and one.startswith("|") != block[0].startswith("|")):
            flush()
        if one.strip():
            block.append(one)
    flush()
    return "\n".join(out)


def signed(value, decimals=1):
    return "–" if value is None else f"{value:+.{decimals}f}".replace("-", "−")


def plus_minus(value, error, decimals=1):
    if value is None:
        return "–"
    return f"{value:.{decimals}f}" + ("" if error is None else f" ± {error:.{decimals}f}")
