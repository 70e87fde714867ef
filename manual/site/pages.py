# SPDX-License-Identifier: GPL-3.0-or-later
"""What the site makes of pages that are plain Markdown: navigation from the lists of links that
index pages have, and a theme that needs no web server."""

import posixpath
import re
from pathlib import Path

SECTION = re.compile(r"^## +(.+)$", re.M)
LINK = re.compile(r"\]\(([\w./-]+\.md)\)")
INDEXES = ("index", "theory/index", "gallery/index")


def toctree(caption, pages):
    entries = "\n".join(page.removesuffix(".md") for page in pages)
    head = f":caption: {caption}\n" if caption else ""
    return f"\n```{{toctree}}\n:hidden:\n{head}\n{entries}\n```\n"


def own_pages(text, folder):
    """Pages that lists and tables of an index link to, in order; those above its folder are others'."""
    lines = [line for line in text.splitlines() if line.startswith(("- [", "| ["))]
    links = [link for line in lines for link in LINK.findall(line)[:1]]
    return [link for link in links if not posixpath.normpath(posixpath.join(folder, link)).startswith("..")
            and not link.startswith("..")]


def add_navigation(_app, docname, source):
    """An index gets a hidden toctree for each of its sections."""
    if docname not in INDEXES:
        return
    text = source[0]
    parts = SECTION.split(text)
    trees = []
    for caption, body in zip([""] + parts[1::2], parts[::2]):
        pages = own_pages(body, posixpath.dirname(docname))
        if pages:
            trees.append(toctree(caption if docname == "index" else "", pages))
    source[0] = text + "\n" + "".join(trees)


def mend_theme(app, error):
    """Debian's furo asks the web server's root for normalize.css, which no file has: site.css does it."""
    style = Path(app.outdir) / "_static" / "styles" / "furo.css"
    if error is None and style.exists():
        text = style.read_text(encoding="utf-8")
        style.write_text(re.sub(r"@import url\(/javascript/[^)]*\);", "", text), encoding="utf-8")


def setup(app):
    app.connect("source-read", add_navigation)
    app.connect("build-finished", mend_theme)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
