#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every deck of decks/ and writes the table of their checks, manual/verification.md.

    tests/decks/verification.py PROGRAM
"""
import json
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


def points(run):
    """The listing of a run; of a sweep those of its points, with the values of its parameters."""
    if (run / "listing.txt").exists():
        yield "", run / "listing.txt"
    for folder in sorted(run.glob("*/")):
        if (folder / "point.json").exists() and (folder / "listing.txt").exists():
            values = json.loads((folder / "point.json").read_text(encoding="utf-8"))["parameters"]
            yield "".join(f", {name} = {value:.6g}" for name, value in values.items()), folder / "listing.txt"


def table(rows):
    out = ["| check | found | wanted | error | allowed | source |\n|---|---|---|---|---|---|\n"]
    for row in rows:
        source = row[6] if len(row) > 6 else ""
        failed = " **failed**" if row[5] == "FAILED" else ""
        out.append(f"| `{row[0]}` | {row[1]} | {row[2]} | {row[3]}{failed} | {row[4]} | {source} |\n")
    return "".join(out)


def main():
    program = sys.argv[1]
    out = [HEAD]
    with tempfile.TemporaryDirectory() as folder:
        for deck in sorted((TOP / "decks").glob("*.deck")):
            run = pathlib.Path(folder) / deck.stem
            subprocess.run([program, "run", str(deck), "--quiet", "--out", str(run)], check=False,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            for point, listing in points(run):
                rows = checks(listing.read_text(encoding="utf-8"))
                if rows:
                    out.append(f"## {title(deck)}{point} (`{deck.name}`)\n\n{table(rows)}\n")
    (TOP / "manual" / "verification.md").write_text("".join(out).rstrip() + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
