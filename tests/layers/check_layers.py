# SPDX-License-Identifier: GPL-3.0-or-later
"""Who may include whom: data flows down this table, and some libraries have one room only.

Usage: check_layers.py TOP. Prints every include that breaks a rule and ends with 1 if there is one.
"""

import re
import sys
from pathlib import Path

MAY_INCLUDE = {
    "base": "",
    "shape": "base",
    "grammar": "base",
    "model": "base",
    "mesh": "base shape model",
    "mesher": "base mesh",
    "deck": "base grammar model mesh",
    "fe": "base shape model",
    "solve": "base",
    "contact": "base shape model mesh fe solve",
    "crack": "base shape model mesh fe",
    "estimate": "base shape model mesh fe solve contact crack",
    "life": "base",
    "growth": "base shape model mesh fe crack life",
    "results": "base model",
    "report": "base model results",
    "run": "base shape grammar model mesh deck fe solve contact crack estimate life growth results"
    " report",
}

# Header of a library -> where it may be included, and how to say so.
LIBRARIES = [
    (r"boost/spirit", r"grammar/", "grammar"),
    (r"(suitesparse/)?(cholmod|SuiteSparse_config)", r"src/solve/", "src/solve"),
    (r"gsl/", r"src/life/", "src/life"),
    (r"gmsh", r"src/mesher/[^/]*\.cpp$", "src/mesher/*.cpp"),
    (r"(hdf5|H5)", r"src/results/", "src/results"),
]

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def sources(top):
    """(room, file) of every source, in a fixed order."""
    for folder in sorted((top / "src").iterdir()) + [top / "grammar"]:
        if folder.is_dir():
            for file in sorted(folder.rglob("*")):
                if file.suffix in (".cpp", ".hpp"):
                    yield folder.name, file


def table_errors(table):
    """A table with a cycle could not be obeyed by any program that is built room by room."""
    done = set()

    def visit(room, path):
        if room in path:
            return ["the table has a cycle: " + " -> ".join([*path, room])]
        if room in done:
            return []
        done.add(room)
        return [e for used in table.get(room, "").split() for e in visit(used, [*path, room])]

    return [error for room in table for error in visit(room, [])]


def include_error(room, name, quoted, relative):
    """What is wrong with one include, or nothing."""
    if quoted:
        target = name.split("/")[0]
        if "/" not in name or target not in MAY_INCLUDE:
            return f'"{name}" does not start with the name of a room'
        if target != room and target not in MAY_INCLUDE[room].split():
            return f"{room} may not include {target}"
        return None
    for header, place, words in LIBRARIES:
        if re.match(header, name) and not re.match(place, relative):
            return f"<{name}> may be included in {words} only"
    return None


def check(top):
    errors = table_errors(MAY_INCLUDE)
    count = 0
    for room, file in sources(top):
        count += 1
        relative = file.relative_to(top).as_posix()
        if room not in MAY_INCLUDE:
            errors.append(f"{relative}: no room of the table")
            continue
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            found = INCLUDE.match(line)
            if found:
                error = include_error(room, found[2], found[1] == '"', relative)
                if error:
                    errors.append(f"{relative}:{number}: {error}")
    if count == 0:
        errors.append(f"{top}: no sources found")
    return errors


def main():
    errors = check(Path(sys.argv[1]))
    print("\n".join(errors) if errors else "every include obeys the table")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
