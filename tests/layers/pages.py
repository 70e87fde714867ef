# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages for those who carry on: files and rooms that they name must be there."""

import re

PAGES = ("architecture.md", "glossary.md", "new_card.md", "new_element.md", "new_result.md",
         "CONTRIBUTING.md")
# `fe/element.hpp`, `tests/unit/fe/test_element.cpp`, `mesh/cut`
NAMED = re.compile(r"`([\w/]+\.(?:cpp|hpp|py)|[a-z_]+(?:/[a-z_]+)+)`")


def lost_names(top):
    """Names in backquotes that are neither below TOP nor below TOP/src."""
    errors = []
    for page in PAGES:
        path = top / "manual" / page
        if not path.exists():
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            errors += [f"manual/{page}:{number}: there is no {name}"
                       for name in NAMED.findall(line)
                       if not (top / name).exists() and not (top / "src" / name).exists()]
    return errors
