# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours for decks and for geometry scripts of gmsh."""

from pygments.lexer import RegexLexer, bygroups
from pygments.lexers.c_cpp import CLexer
from pygments.token import Comment, Keyword, Name, Number, Operator, String, Text


class DeckLexer(RegexLexer):
    name = "spricka deck"
    aliases = ["deck"]
    filenames = ["*.deck"]
    tokens = {
        "root": [
            (r"![^\n]*", Comment),
            (r"'[^'\n]*'", String),
            (r"\$[A-Za-z]+", Keyword),
            (r"([A-Za-z_]\w*)(\s*)(=)", bygroups(Name.Attribute, Text, Operator)),
            (r"(?<![\w.])[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", Number),
            (r"[A-Za-z_][\w.]*", Name),
            (r"[^\S\n]+|\n", Text),
            (r".", Operator),
        ]
    }


class GeoLexer(CLexer):
    """Their syntax is near enough to C."""

    name = "gmsh geometry"
    aliases = ["geo"]
    filenames = ["*.geo"]


def setup(app):
    app.add_lexer("deck", DeckLexer)
    app.add_lexer("geo", GeoLexer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
