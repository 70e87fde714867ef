# SPDX-License-Identifier: GPL-3.0-or-later
"""What pages and comments name must be there: files, rooms, equations of the theory.

Pages are those for developers; in comments of sources it is names of files, as fe/element.hpp, and
tags of equations, as fe.9, which stands in manual/theory/fe.md.
"""

import re
from pathlib import Path

PAGES = ("architecture.md", "glossary.md", "new_card.md", "new_element.md", "new_result.md",
         "CONTRIBUTING.md")
# `fe/element.hpp`, `tests/unit/fe/test_element.cpp`, `mesh/cut`
NAMED = re.compile(r"`([\w/]+\.(?:cpp|hpp|py)|[a-z_]+(?:/[a-z_]+)+)`")
COMMENT = re.compile(r"//(.*)")
FILE = re.compile(r"\b[\w/]+\.(?:cpp|hpp)\b")


def is_there(top, name):
    """Whether NAME is below TOP or TOP/src; what a build makes is not, as a clone has none."""
    if name.startswith("build/"):
        return False
    return (top / name).exists() or (top / "src" / name).exists()


def lost_names(top):
    """Names in backquotes of a page that are neither below TOP nor below TOP/src."""
    errors = []
    for page in PAGES:
        path = top / "manual" / page
        if not path.exists():
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            errors += [f"manual/{page}:{number}: there is no {name}"
                       for name in NAMED.findall(line) if not is_there(top, name)]
    return errors


def equations(top):
    """{page of the theory: tags that it has, by \\tag or in the text}."""
    return {page.stem: set(re.findall(rf"[({{]({page.stem}\.\d+)[)}}]", page.read_text("utf-8")))
            for page in sorted((top / "manual" / "theory").glob("*.md"))}


def lost_citations(top, house):
    """Files and equations that comments name and that are not there."""
    known = equations(top)
    tag = re.compile(rf"\b(({'|'.join(known) or '-'})\.\d+)\b")
    plain = {Path(name).name for name in house.sources}
    errors = []
    for source in house.sources.values():
        text = (top / source.path).read_text(encoding="utf-8")
        for number, line in enumerate(text.splitlines(), 1):
            comment = COMMENT.search(line)
            if comment is None:
                continue
            lost = [n for n in FILE.findall(comment[1]) if n not in plain and not is_there(top, n)]
            lost += [whole for whole, page in tag.findall(comment[1]) if whole not in known[page]]
            errors += [f"{source.path}:{number}: there is no {name}" for name in lost]
    return errors
