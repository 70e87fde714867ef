# SPDX-License-Identifier: GPL-3.0-or-later
"""How the code reads, in numbers.

    tests/layers/measures.py [TOP] [--names | --types | --branches | --classes | --words N SEED]

Code lines without comments and blanks, lines that branch on the dimension, files that handle tips
beside fronts, types of one name, classes by their lines over all sources, public functions with a
comment, and the lengths of their names. --words draws N names of functions and types with the place
each stands in, to be explained by a reader who has not seen the code.
"""

import random
import re
import sys
from collections import Counter, defaultdict
from pathlib import Path

from cpp_text import code_lines, read_declarations, tokens_of

# Lines that ask whether a model is plane or solid.
BRANCH = re.compile(r"\bdim(?:ension)?(?:\(\))? *(?:==|!=|<=?|>=?) *[123]\b|\bin_space\b|\bspace\.faces\.empty\(\)")
# Names that the standard library asks for.
STANDARD = set("begin end cbegin cend size empty data at find count contains front back insert erase clear push_back "
               "emplace_back reserve resize swap get reset value what open close read write flush put".split())
LARGEST_CLASS = 300
SHORT = 5


def sources(top):
    """{path from the top: text} of all C++ of src and grammar."""
    return {path.relative_to(top).as_posix(): path.read_text(encoding="utf-8")
            for room in ("src", "grammar") for path in sorted((top / room).rglob("*.[ch]pp"))}


def code_by_line(tokens):
    """{line: its code}, without comments, quoted text and directives."""
    lines = defaultdict(list)
    for token in tokens:
        if token.kind not in ("comment", "text", "directive"):
            lines[token.line].append(token.text)
    return {number: " ".join(words).replace(" . ", ".").replace(" ( )", "()").replace(" -> ", "->")
            for number, words in lines.items()}


class Measures:
    """What is counted, over one tree."""

    def __init__(self, top):
        self.lines, self.branches, self.both = 0, [], []
        self.types, self.class_lines, self.functions = defaultdict(list), Counter(), []
        self.identifiers = {}  # {name: where it is first}
        for path, text in sources(top).items():
            tokens = tokens_of(text)
            self.lines += len(code_lines(tokens))
            code = code_by_line(tokens)
            self.branches += [f"{path}:{n}" for n, line in sorted(code.items()) if BRANCH.search(line)]
            for token in tokens:
                if token.kind == "name":
                    self.identifiers.setdefault(token.text, f"{path}:{token.line}")
            words = {t.text for t in tokens if t.kind == "name"}
            if {"tips", "fronts"} <= words:
                self.both.append(path)
            found = read_declarations(text)
            room = path.rpartition("/")[0]
            for one in found.types:
                self.types[one.name].append(f"{path}:{one.line}")
                self.class_lines[room, one.name] += one.last - one.line + 1
            for owner, first, last in found.members:
                self.class_lines[room, owner] += last - first + 1
            if path.endswith(".hpp"):
                self.functions += [(path, f) for f in found.functions]

    def named_twice(self):
        return {name: places for name, places in sorted(self.types.items()) if len(places) > 1}

    def large_classes(self):
        return {f"{room}/{name}": n for (room, name), n in self.class_lines.most_common() if n > LARGEST_CLASS}

    def names(self):
        return sorted({f.name for _, f in self.functions} - STANDARD)

    def commented(self):
        """(functions with a comment that says more than the name, functions asked)."""
        asked = [f for _, f in self.functions if not f.getter]
        says = [f for f in asked
                if len(set(re.findall(r"[a-z]{3,}", f.comment.lower())) - set(f.name.lower().split("_"))) >= 3]
        return len(says), len(asked)

    def rows(self):
        says, asked = self.commented()
        names = self.names()
        short = sum(len(n) <= SHORT for n in names)
        twice = self.named_twice()
        return [
            ("code lines of src and grammar", self.lines),
            ("lines that branch on the dimension", f"{len(self.branches)} in {len({b.split(':')[0] for b in self.branches})} files"),
            ("of these in contact, crack, results, report", sum(bool(re.match(r"src/(contact|crack|results|report)/", b)) for b in self.branches)),
            ("files with tips and fronts", f"{len(self.both)}, {sum(not re.match(r'src/growth/|grammar/', b) for b in self.both)} outside growth and grammar"),
            ("names of several types", f"{len(twice)}, up to {max(map(len, twice.values()), default=1)} of one"),
            (f"classes over {LARGEST_CLASS} lines", len(self.large_classes())),
            ("public functions with a comment", f"{says} of {asked}, {100 * says / max(asked, 1):.0f} %"),
            ("distinct names of public functions", f"{len(names)}, mean {sum(map(len, names)) / max(len(names), 1):.2f} letters, "
             f"{100 * short / max(len(names), 1):.1f} % of {SHORT} or fewer"),
        ]

    def drawn(self, number, seed):
        """Names with their places, by chance."""
        functions = [(f"{f.owner + '::' if f.owner else ''}{f.name}()", path) for path, f in self.functions if f.name not in STANDARD]
        types = [(name, place.split(":")[0]) for name, places in self.types.items() for place in places if ".hpp" in place]
        return random.Random(seed).sample(sorted(set(functions + types)), number)


def main(words):
    flags = [w for w in words if w.startswith("--")]
    numbers = [int(w) for w in words if w.isdigit()]
    top = next((Path(w) for w in words if not w.startswith("--") and not w.isdigit()), Path(__file__).parents[2])
    measures = Measures(top)
    if "--names" in flags:
        by_name = defaultdict(list)
        for path, f in measures.functions:
            by_name[f.name].append(f"{path}:{f.line}")
        for name in measures.names():
            print(name, *by_name[name])
    elif "--types" in flags:
        for name, places in measures.named_twice().items():
            print(name, *places)
    elif "--branches" in flags:
        print(*measures.branches, sep="\n")
    elif "--classes" in flags:
        for name, lines in measures.large_classes().items():
            print(lines, name)
    elif "--words" in flags:
        for name, place in measures.drawn(*numbers):
            print(f"{name:40} {place}")
    else:
        for name, value in measures.rows():
            print(f"{name:46} {value}")


if __name__ == "__main__":
    main(sys.argv[1:])
