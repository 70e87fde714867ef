# SPDX-License-Identifier: GPL-3.0-or-later
"""Sphinx configuration of the manual: pages are the Markdown files above this folder (manual/build)."""

import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]
KATEX = Path("/usr/share/javascript/katex")
KATEX_FONTS = Path("/usr/share/fonts/truetype/katex")
sys.path.insert(0, str(HERE))

project = "spricka"
author = "spricka"
copyright = "GPL-3.0-or-later"  # pylint: disable=redefined-builtin
release = re.search(r"project\(spricka VERSION ([\d.]+)",
                    (TOP / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
language = "en"

extensions = ["myst_parser", "pages", "equations", "deck_lexer"]
exclude_patterns = ["site", "editors"]
nitpicky = True
myst_enable_extensions = ["dollarmath"]
myst_dmath_allow_space = False
myst_heading_anchors = 4
highlight_language = "none"
smartquotes = False

# the PDF is printed from one page without anything round it (manual/build)
PRINTED = tags.has("print")  # noqa: F821  Sphinx puts `tags` here
html_theme = "basic" if PRINTED else "furo"
html_title = f"spricka {release}"
html_static_path = ["static", str(KATEX / "katex.min.css"), str(KATEX / "katex.min.js")]
html_css_files = ["katex.min.css", "site.css"] + (["print.css"] if PRINTED else [])
html_js_files = ["katex.min.js", "equations.js"]
html_math_renderer = "katex"
html_copy_source = False
html_show_sphinx = False
html_show_search_summary = False  # it fetches pages, which browsers refuse for files
pygments_style = "friendly"
html_theme_options = {"nosidebar": True} if PRINTED else {
    "light_css_variables": {"color-brand-primary": "#8a1c1c", "color-brand-content": "#8a1c1c"},
    "dark_css_variables": {"color-brand-primary": "#f08a7a", "color-brand-content": "#f08a7a"},
}


def setup(app):
    app.add_config_value("katex_fonts", str(KATEX_FONTS), "env")
