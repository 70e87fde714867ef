# SPDX-License-Identifier: GPL-3.0-or-later
"""Equations of the theory: \\tag{fe.9} in a $$ block becomes its number and the place that links lead
to, and every (fe.9) in the text a link to it. KaTeX sets the formulas in the browser."""

import re
import shutil
from pathlib import Path

from docutils import nodes
from sphinx.transforms import SphinxTransform
from sphinx.util import logging

TAG = re.compile(r"\\tag\{([a-z_]+\.\d+)\}")
NOT_IN = (nodes.literal, nodes.literal_block, nodes.math, nodes.math_block, nodes.reference, nodes.title)
log = logging.getLogger(__name__)


def anchor(tag):
    return "eq-" + tag.replace(".", "-").replace("_", "-")


def collect(app):
    """{tag: page} of all pages of the theory."""
    app.equation_pages = {}
    for page in sorted((Path(app.srcdir) / "theory").glob("*.md")):
        for tag in TAG.findall(page.read_text(encoding="utf-8")):
            if tag in app.equation_pages:
                log.warning("theory/%s: equation %s is there twice", page.name, tag)
            app.equation_pages[tag] = "theory/" + page.stem


class Numbers(SphinxTransform):
    """The tag of an equation becomes its id and number."""

    default_priority = 500

    def apply(self, **_kwargs):
        for block in self.document.findall(nodes.math_block):
            tag = TAG.search(block.astext())
            if tag:
                text = TAG.sub("", block.astext()).strip()
                block.children = []
                block += nodes.Text(text)
                block["equation"] = tag[1]
                block["ids"] = [anchor(tag[1])]


def pieces_of(app, docname, text, pattern):
    at = 0
    for found in pattern.finditer(text):
        tag = found[0]
        page = app.equation_pages.get(tag)
        if page is None:
            log.warning("there is no equation %s", tag, location=docname)
            continue
        yield nodes.Text(text[at:found.start()])
        uri = "" if page == docname else app.builder.get_relative_uri(docname, page)
        yield nodes.reference("", tag, internal=True, refuri=f"{uri}#{anchor(tag)}", classes=["eqref"])
        at = found.end()
    yield nodes.Text(text[at:])


def link(app, doctree, docname):
    """(fe.9) in running text becomes a link."""
    stems = sorted({tag.split(".")[0] for tag in app.equation_pages})
    pattern = re.compile(rf"(?<![\w./-])(?:{'|'.join(stems)})\.\d+\b(?!\.\d)")
    for text in list(doctree.findall(nodes.Text)):
        parent = text.parent
        while parent is not None and not isinstance(parent, NOT_IN):
            parent = parent.parent
        if parent is None and pattern.search(text.astext()):
            text.parent.replace(text, list(pieces_of(app, docname, text.astext(), pattern)))


def inline(self, node):
    self.body.append(f'<span class="tex">{self.encode(node.astext())}</span>')
    raise nodes.SkipNode


def display(self, node):
    tag = node.get("equation")
    mark = f' id="{anchor(tag)}"' if tag else ""
    number = f'<a class="eqno" href="#{anchor(tag)}">({tag})</a>' if tag else ""
    self.body.append(f'<div class="equation"{mark}><div class="tex display">'
                     f"{self.encode(node.astext())}</div>{number}</div>\n")
    raise nodes.SkipNode


def copy_fonts(app, error):
    if error is None and app.builder.format == "html":
        fonts = Path(app.outdir) / "_static" / "fonts"
        fonts.mkdir(exist_ok=True)
        for font in Path(app.config.katex_fonts).glob("*.woff2"):
            shutil.copy(font, fonts)


def setup(app):
    app.add_html_math_renderer("katex", (inline, None), (display, None))
    app.add_transform(Numbers)
    app.connect("builder-inited", collect)
    app.connect("doctree-resolved", link)
    app.connect("build-finished", copy_fonts)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
