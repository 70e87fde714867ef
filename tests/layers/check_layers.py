# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules of the house: who includes whom, no circles, no room too big, libraries in their rooms, the field's words.

Usage: check_layers.py TOP [--write]. Prints everything that breaks a rule and ends with 1 if there
is such a thing. manual/architecture.md and its picture are made from the same rooms: --write renews
them, without it they are compared. What pages for developers and comments cite must be there.
"""

import re
import sys
from pathlib import Path

import architecture
from circles import circles
from house import read_house
from pages import lost_citations, lost_names
from wording import wording_errors

LARGEST_SHARE = 0.15  # of all lines of src and grammar, for one room

# Header of a library -> where it may be included, and how to say so.
LIBRARIES = [
    (r"boost/spirit", r"grammar/", "grammar"),
    (r"(suitesparse/)?(cholmod|SuiteSparse_config)", r"src/solve/", "src/solve"),
    (r"gsl/", r"src/life/", "src/life"),
    (r"gmsh", r"src/mesher/[^/]*\.cpp$", "src/mesher/*.cpp"),
    (r"petsc", r"src/engines/multigrid/", "src/engines/multigrid"),
    (r"mpi\.h", r"src/engines/message_passing/", "src/engines/message_passing"),
    (r"(hdf5|H5)", r"src/results/", "src/results"),
]


def room_errors(house):
    """Rooms that do not say who they are, and sources that no room compiles."""
    errors = []
    for room in house.rooms.values():
        if room.called != room.name:
            errors.append(f"{room.cmake}: does not call spricka_room({room.name} ..)")
        if not room.purpose:
            errors.append(f"{room.cmake}: its first line is no comment with the room's purpose")
        errors += [f"{room.cmake}: USES {used}, which is no room"
                   for used in room.uses if used not in house.rooms]
    for source in house.sources.values():
        room = house.rooms.get(source.room)
        if room is None:
            errors.append(f"{source.path}: its folder has no CMakeLists.txt, so it is in no room")
        elif source.path.endswith(".cpp") and Path(source.path).name not in room.sources:
            errors.append(f"{source.path}: not among the sources of {room.cmake}")
    return errors


def library_error(include):
    for header, place, words in LIBRARIES:
        if re.match(header, include.name) and not re.match(place, include.file):
            return [f"{include}: <{include.name}> may be included in {words} only"]
    return []


def include_errors(house):
    """Includes of what is not there, of rooms that USES does not name, of others' libraries."""
    errors = []
    for source in house.sources.values():
        for include in source.includes:
            if not include.quoted:
                errors += library_error(include)
            elif include.name not in house.sources:
                errors.append(f'{include}: "{include.name}" is no file seen from src or the top')
    for (room, used), includes in house.arrows().items():
        if room in house.rooms and used not in house.rooms[room].uses:
            errors += [f'{i}: "{i.name}" is in the room {used}, which USES of '
                       f"{house.rooms[room].cmake} does not name" for i in includes]
    return errors


def idle_errors(house):
    arrows = house.arrows()
    return [f"{room.cmake}: USES {used}, but nothing in {room.name} includes it"
            for room in house.rooms.values() for used in room.uses
            if used in house.rooms and (room.name, used) not in arrows]


def told(circle, arrows):
    """The include lines that make a circle, one a line; arrows {from: {to: [Include ..]}}."""
    return "".join(f'\n    {include} includes "{include.name}"'
                   for name in circle for other in circle
                   for include in arrows.get(name, {}).get(other, []))


def circle_errors(house):
    rooms = {room.name: {} for room in house.rooms.values()}
    for (room, used), includes in house.arrows().items():
        rooms.setdefault(room, {})[used] = includes
    graph = {name: [*found, *(house.rooms[name].uses if name in house.rooms else ())]
             for name, found in rooms.items()}
    errors = [f"circle of rooms: {', '.join(circle)}{told(circle, rooms)}"
              for circle in circles(graph)]
    components = house.component_arrows()
    return errors + [f"circle of components: {', '.join(circle)}{told(circle, components)}"
                     for circle in circles(components)]


def name_errors(house):
    places = {}
    for source in house.sources.values():
        if source.path.endswith(".hpp"):
            places.setdefault(Path(source.path).name, []).append(source.path)
    return [f"headers of one name: {', '.join(paths)}"
            for paths in places.values() if len(paths) > 1]


def size_errors(house):
    lines = house.lines()
    total = sum(lines.values())
    return [f"{house.rooms[name].cmake}: {name} holds {count} of {total} lines, "
            f"more than {LARGEST_SHARE:.0%} of the house"
            for name, count in lines.items()
            if name in house.rooms and count > LARGEST_SHARE * total]


def check(top):
    """Everything in TOP/src and TOP/grammar that breaks a rule of the house."""
    house = read_house(top)
    if not house.sources:
        return [f"{top}: no sources found"]
    rules = (room_errors, include_errors, idle_errors, circle_errors, name_errors, size_errors)
    return [error for rule in rules for error in rule(house)] + wording_errors(top)


def main(arguments):
    top = Path(arguments[0])
    house = read_house(top)
    errors = check(top) + lost_names(top) + lost_citations(top, house)
    if circles(architecture.graph_of(house)):
        errors.append(f"{architecture.PAGE}: rooms in a circle cannot be drawn")
    elif house.rooms and "--write" in arguments:
        architecture.write(house, top)
    else:
        errors += architecture.age_errors(house, top)
    print("\n".join(errors) or "the house keeps its rules")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
