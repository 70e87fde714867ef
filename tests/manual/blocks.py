# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks of the manual's pages and what a test does with them.

A fenced block says in its language what it is: `sh` is run, `deck` and others may be files, `text`
behind an `sh` block is what that printed. A comment on the line before a block says more:

    <!-- file: NAME -->            the block is this file
    <!-- more: NAME -->            it goes on with this file
    <!-- into: NAME before LINE -->  it stands in that file before the line that begins so
    <!-- exit: CODE -->            the commands end with this code (0 if nothing is said)
    <!-- not run: WHY -->          nothing is done with the block
    <!-- long -->                  the commands take minutes: run with SPRICKA_FULL=1 only
    <!-- shown -->                 the block is for reading: part of a file above, or of what a file holds

    <!-- follows: EXPR = NUMBER -->   a number of the text, by arithmetic from known ones (CHECKED pages)

and of a page, anywhere in it: <!-- setup: COMMANDS --> is run before its first block.
"""

import re
from dataclasses import dataclass, field
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
MANUAL = TOP / "manual"
MARK = re.compile(r"<!-- (file|more|into|exit|not run|long|shown|setup)(?:: (.*?))? -->")
FENCE = re.compile(r"^( *)```(\S*)\s*$")


@dataclass
class Block:
    page: str
    line: int
    language: str
    text: str
    marks: dict = field(default_factory=dict)

    @property
    def place(self):
        return f"manual/{self.page}:{self.line}"


def blocks_of(page):
    """The blocks of a page, fenced ones and indented ones (language "")."""
    lines = (MANUAL / page).read_text(encoding="utf-8").splitlines()
    found, marks, at = [], {}, 0
    while at < len(lines):
        mark = MARK.fullmatch(lines[at].strip())
        fence = FENCE.match(lines[at])
        if mark:
            marks[mark[1]] = mark[2] or ""
        elif fence:
            indent, start = len(fence[1]), at + 1
            at = start
            while not FENCE.match(lines[at]):
                at += 1
            text = "".join(line[indent:] + "\n" for line in lines[start:at])
            found.append(Block(page, start, fence[2], text, marks))
            marks = {}
        elif lines[at].startswith("    ") and at > 0 and not lines[at - 1].strip() and not in_list(lines, at):
            start = at
            while at < len(lines) and (lines[at].startswith("    ") or not lines[at].strip()):
                at += 1
            text = "".join(line[4:] + "\n" for line in lines[start:at]).rstrip("\n") + "\n"
            found.append(Block(page, start + 1, "", text, marks))
            marks = {}
            continue
        elif lines[at].strip():
            marks = {}
        at += 1
    return found


def in_list(lines, at):
    """Whether an indented line goes on with an item of a list."""
    while at >= 0 and (lines[at].startswith("  ") or not lines[at].strip()):
        at -= 1
    return at >= 0 and re.match(r"[-*] |\d+\. ", lines[at]) is not None


def setup_of(page):
    text = (MANUAL / page).read_text(encoding="utf-8")
    return "\n".join(m[2] for m in MARK.finditer(text) if m[1] == "setup")


def pages():
    return sorted(str(p.relative_to(MANUAL)) for p in MANUAL.rglob("*.md"))
