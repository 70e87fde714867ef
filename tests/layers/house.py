# SPDX-License-Identifier: GPL-3.0-or-later
"""The house as its files tell it: rooms, sources, includes.

A room is a folder of src/, or grammar/, with a CMakeLists.txt that calls spricka_room. The first
comment there is the room's purpose, USES the rooms it may include. A component is a header with
the source of its name.
"""

import re
from dataclasses import dataclass, field
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
ROOM_CALL = re.compile(r"\bspricka_room\(\s*(\S+)([^)]*)\)")
KEYWORDS = {"SOURCES", "ALONE", "USES", "LINKS", "HIDES"}


@dataclass(frozen=True)
class Include:
    """One include line; name as it stands between the quotes or angle brackets."""

    file: str
    line: int
    name: str
    quoted: bool

    def __str__(self):
        return f"{self.file}:{self.line}"


@dataclass(frozen=True)
class Source:
    """A .cpp or .hpp: path from the top, name as others include it, the room of its folder."""

    path: str
    name: str
    room: str
    lines: int
    includes: tuple

    @property
    def component(self):
        return self.name.rsplit(".", 1)[0]


@dataclass(frozen=True)
class Room:
    """What a room's CMakeLists.txt says of it."""

    name: str
    called: str
    purpose: str
    sources: tuple
    uses: tuple
    cmake: str


@dataclass
class House:
    rooms: dict = field(default_factory=dict)  # by folder: base, mesh/cut, grammar
    sources: dict = field(default_factory=dict)  # by include name: mesh/cut/patch.hpp

    def lines(self):
        """Lines of each room, its own folder only."""
        count = dict.fromkeys(self.rooms, 0)
        for source in self.sources.values():
            count[source.room] = count.get(source.room, 0) + source.lines
        return count

    def arrows(self):
        """The include lines from room to room: {(from, to): [Include ..]}."""
        found = {}
        for source in self.sources.values():
            for include in source.includes:
                target = self.sources.get(include.name) if include.quoted else None
                if target and target.room != source.room:
                    found.setdefault((source.room, target.room), []).append(include)
        return found

    def component_arrows(self):
        """The include lines from component to component: {from: {to: [Include ..]}}."""
        found = {source.component: {} for source in self.sources.values()}
        for source in self.sources.values():
            for include in source.includes:
                target = self.sources.get(include.name) if include.quoted else None
                if target and target.component != source.component:
                    found[source.component].setdefault(target.component, []).append(include)
        return found


def arguments(text):
    """{keyword: words behind it} of a call of spricka_room."""
    found, keyword = {}, None
    for word in text.split():
        if word in KEYWORDS:
            keyword = word
        elif keyword:
            found.setdefault(keyword, []).append(word)
    return found


def read_room(name, path, cmake):
    """The room of one CMakeLists.txt; purpose and called are empty where it has none."""
    text = path.read_text(encoding="utf-8")
    comment = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        comment.append(line.lstrip("# ").rstrip())
    code = re.sub(r"#.*", "", text)
    call = ROOM_CALL.search(code)
    given = arguments(call[2]) if call else {}
    programs = re.findall(r"\badd_executable\(\s*\S+([^)]*)\)", code)
    compiled = given.get("SOURCES", []) + " ".join(programs).split()
    return Room(name, call[1] if call else "", " ".join(comment), tuple(compiled),
                tuple(given.get("USES", [])), cmake)


def read_source(path, relative, name):
    """One source with its include lines."""
    text = path.read_text(encoding="utf-8").splitlines()
    includes = []
    for number, line in enumerate(text, 1):
        found = INCLUDE.match(line)
        if found:
            includes.append(Include(relative, number, found[2], found[1] == '"'))
    return Source(relative, name, name.rpartition("/")[0], len(text), tuple(includes))


def read_house(top):
    """All rooms and sources below TOP/src and TOP/grammar, in a fixed order."""
    house = House()
    for base, root in ((top / "src", top / "src"), (top / "grammar", top)):
        for path in sorted(base.rglob("*")):
            name = path.relative_to(root).as_posix()
            relative = path.relative_to(top).as_posix()
            if path.name == "CMakeLists.txt":
                room = name.rpartition("/")[0]
                house.rooms[room] = read_room(room, path, relative)
            elif path.suffix in (".cpp", ".hpp"):
                house.sources[name] = read_source(path, relative, name)
    return house
