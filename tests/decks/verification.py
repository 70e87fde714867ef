#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every deck of decks/ and writes the table of their checks, manual/verification.md.

    tests/decks/verification.py PROGRAM
"""
import pathlib
import re
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parents[2]

HEAD = """# Verification

Every deck in `decks/` carries its reference values and the error that is allowed (`$CHECK`). This table is
what they found, made by `tests/decks/verification.py PROGRAM`; the tests run the same decks. A source
`RECORDED` is a value of this program itself and proves nothing but that it stayed the same.

"""


def cells(line):
    """The columns of a line of the listing's table: two blanks and more part them."""
    return re.split(r"\s{2,}", line.strip())


def checks(listing):
    """Rows of the table of checks."""
    part = listing.partition("Checks of the deck\n")[2].splitlines()
    rows = [cells(line) for line in part if "passed" in line or "FAILED" in line]
    return [row for row in rows if len(row) >= 6 and row[5] in ("passed", "FAILED")]


def title(deck):
    found = re.search(r"TITLE='([^']*)'", deck.read_text(encoding="utf-8"))
    return found.group(1) if found else deck.stem


def main():
    program = sys.argv[1]
    out = [HEAD]
    with tempfile.TemporaryDirectory() as folder:
        for deck in sorted((TOP / "decks").glob("*.deck")):
            run = pathlib.Path(folder) / deck.stem
            subprocess.run([program, "run", str(deck), "--quiet", "--out", str(run)], check=False,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            listing = run / "listing.txt"
            rows = checks(listing.read_text(encoding="utf-8")) if listing.exists() else []
            if not rows:
                continue
            out.append(f"## {title(deck)} (`{deck.name}`)\n\n")
            out.append("| check | found | wanted | error | allowed | source |\n|---|---|---|---|---|---|\n")
            for row in rows:
                source = row[6] if len(row) > 6 else ""
                failed = " **failed**" if row[5] == "FAILED" else ""
                out.append(f"| `{row[0]}` | {row[1]} | {row[2]} | {row[3]}{failed} | {row[4]} | {source} |\n")
            out.append("\n")
    (TOP / "manual" / "verification.md").write_text("".join(out).rstrip() + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
