# SPDX-License-Identifier: GPL-3.0-or-later
"""What the manual tells its readers to type: every command of the pages for users is run, every deck
on them too, and what a page shows as printed is what is printed, to the digits shown. Pieces of decks
on other pages are read, as the examples of the cards are.

test_pages.py PROGRAM [PAGE ..]
"""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from blocks import MANUAL, TOP, blocks_of, pages, setup_of

PROGRAM = Path(sys.argv[1]).resolve()
ONLY = sys.argv[2:]

# Pages whose commands are run, block by block, each page in a folder of its own.
RUN = ["quickstart.md", "first_deck.md", "tutorial.md", "command_line.md", "restart.md", "sweeps.md",
       "results_file.md", "check.md", "shell.md", "profile.md"]
RUN += sorted(f"howto/{p.name}" for p in (MANUAL / "howto").glob("*.md"))
# Of those the ones whose blocks all say what they are; on the others only marked ones count.
STRICT = [p for p in RUN if p in ("quickstart.md", "first_deck.md", "tutorial.md") or p.startswith("howto/")]
# Of those the ones every number of whose text must be in a deck or printed by one.
CHECKED = ["tutorial.md"]
# For those who change the program: their commands build and test it.
DEVELOPERS = ["CONTRIBUTING.md", "architecture.md", "new_card.md", "new_element.md", "new_result.md"]

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w.]*\w)")
# What differs from run to run and from machine to machine.
VARIES = re.compile(r"\b\d+\.\d+ s CPU|\b\d+ MiB|\b[\d.]+ m?s\b")


def same_number(shown, found):
    """Whether a number agrees with the one that is shown, to half a unit of its last digit (and, as
    machines differ in theirs, one more)."""
    mantissa, _, exponent = shown.lower().partition("e")
    digits = len(mantissa.partition(".")[2])
    unit = 10.0 ** (int(exponent or 0) - digits)
    return abs(float(found) - float(shown)) <= 1.5 * unit


def same_line(shown, found):
    """A line that ends with two dots is the beginning of one."""
    shown, found = (VARIES.sub("<varies>", line) for line in (shown, found))
    words, printed = NUMBER.sub("#", shown).split(), NUMBER.sub("#", found).split()
    if words[-1] == "..":
        words.pop()
        printed = printed[:len(words)]
    if words != printed:
        return False
    return all(same_number(a, b) for a, b in zip(NUMBER.findall(shown), NUMBER.findall(found)))


def first_lost(shown, printed):
    """The first line that is shown and not printed, in order; a line of dots passes over others."""
    at = 0
    lines = printed.splitlines()
    for line in shown.splitlines():
        if line.strip() in ("..", "...", ""):
            continue
        while at < len(lines) and not same_line(line, lines[at]):
            at += 1
        if at == len(lines):
            return line
        at += 1
    return None


class Reader:
    """Does what a page says, in a folder that looks like the top of a checkout."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.printed = None
        self.known = set()  # numbers of files and of what was printed
        bin_folder = self.folder / "build/release/bin"
        bin_folder.mkdir(parents=True)
        (bin_folder / "spricka").symlink_to(PROGRAM)
        self.bin = bin_folder
        decks = self.folder / "decks"
        decks.mkdir()
        for file in (TOP / "decks").iterdir():
            if file.name != "run":
                (decks / file.name).symlink_to(file)
        # decks/run installs, builds, and is then nothing but `spricka run`
        run = decks / "run"
        run.write_text("#!/bin/sh\n[ $# -gt 0 ] || set -- decks/lug_single.deck\nexec spricka run \"$@\"\n")
        run.chmod(0o755)
        (self.folder / "manual").symlink_to(MANUAL)
        (self.folder / "tmp").mkdir()

    def shell(self, text):
        text = text.replace("/tmp/", f"{self.folder}/tmp/")
        done = subprocess.run(["bash", "-euc", text], cwd=self.folder, text=True, capture_output=True,
                              timeout=300, check=False,
                              env={"PATH": f"{self.bin}:/usr/bin:/bin", "HOME": str(self.folder),
                                   "OPENBLAS_NUM_THREADS": "1", "LC_ALL": "C.UTF-8"})
        return done.returncode, done.stdout + done.stderr

    def write(self, block):
        marks = block.marks
        if "file" in marks:
            (self.folder / marks["file"]).write_text(block.text, encoding="utf-8")
        elif "more" in marks:
            with (self.folder / marks["more"]).open("a", encoding="utf-8") as file:
                file.write(block.text)
        else:
            name, line = marks["into"].split(" before ")
            path = self.folder / name
            text = path.read_text(encoding="utf-8")
            assert f"\n{line}" in text, f"{block.place}: {name} has no line {line}"
            path.write_text(text.replace(f"\n{line}", f"\n{block.text}{line}", 1), encoding="utf-8")

    def do(self, block):
        """Empty, or what is wrong."""
        result = self.do_it(block)
        self.known |= set(NUMBER.findall(block.text if "shown" not in block.marks else ""))
        self.known |= set(NUMBER.findall(self.printed or ""))
        return result

    def do_it(self, block):
        if {"not run", "shown"} & set(block.marks):
            return ""
        if {"file", "more", "into"} & set(block.marks):
            self.write(block)
            return ""
        if block.language == "sh":
            code, self.printed = self.shell(block.text)
            wanted = int(block.marks.get("exit", 0))
            return "" if code == wanted else f"ended with {code}, not {wanted}:\n{self.printed[-3000:]}"
        if block.language == "text" and self.printed is not None:
            lost = first_lost(block.text, self.printed)
            return "" if lost is None else f"not printed: {lost}\nbut:\n{self.printed[-3000:]}"
        if block.page in STRICT:
            return "a block without a mark: tests/manual/blocks.py has them"
        return ""


FOLLOWS = re.compile(r"<!-- follows: (.+) = (\S+) -->")


def prose_of(page):
    """The text of a page without blocks, code, links, comments and headings."""
    text = re.sub(r"^```.*?^```$", "", (MANUAL / page).read_text(encoding="utf-8"), flags=re.S | re.M)
    for gone in (r"<!--.*?-->", r"`[^`]*`", r"\]\([^)]*\)", r"^#.*$"):
        text = re.sub(gone, "", text, flags=re.M)
    return text


def unknown_numbers(page, known):
    """Numbers of the text, of three digits or with decimals, that nothing gives."""
    text = (MANUAL / page).read_text(encoding="utf-8")
    results = []
    for expression, value in FOLLOWS.findall(text):
        for number in re.findall(r"\d+\.\d+|\d{3,}", expression):
            if not any(same_number(number, k) for k in known):
                results.append(f"{number} in {expression}")
        found = eval(expression, {"__builtins__": {}})  # arithmetic of our own pages
        if not same_number(value, found):
            results.append(f"{expression} is {found}, not {value}")
        known = known | {value}
    told = re.findall(r"(?<![\w.])-?(?:\d+\.\d+|\d{3,})(?!\w)", prose_of(page))
    return results + [n for n in told if not any(same_number(n, k) for k in known)]


class Pages(unittest.TestCase):
    """One test for each page, made below."""


def page_test(page):
    def test(self):
        with tempfile.TemporaryDirectory() as folder:
            reader = Reader(folder)
            code, printed = reader.shell(setup_of(page))
            self.assertEqual(code, 0, printed)
            for block in blocks_of(page):
                self.assertEqual("", reader.do(block), f"{block.place}")
            if page in CHECKED:
                self.assertEqual([], unknown_numbers(page, reader.known), page)

    return test


def is_cards(text):
    return re.match(r"\s*(?:!.*\n\s*)*\$[A-Z]+\b", text) is not None


class Decks(unittest.TestCase):
    def test_pieces_of_decks_are_read_without_a_mistake_of_language(self):
        for page in pages():
            if page in STRICT or page in DEVELOPERS:
                continue
            for block in blocks_of(page):
                if block.language not in ("", "deck") or not is_cards(block.text) or "not run" in block.marks:
                    continue
                with self.subTest(block.place):
                    self.assertEqual([], self.mistakes(block.text))

    def mistakes(self, text):
        """Messages of codes E1.. and E2..: cards, keys, values, units, lines. Files and parameters
        stand elsewhere."""
        if not text.startswith("$DECK"):
            text = "$DECK VERSION=1 LENGTH=MM FORCE=N\n" + text
        if "$END\n" not in text:
            text += "$END\n"
        with tempfile.TemporaryDirectory() as folder:
            deck = Path(folder) / "piece.deck"
            deck.write_text(text, encoding="utf-8")
            done = subprocess.run([str(PROGRAM), "check", str(deck)], text=True, capture_output=True,
                                  timeout=100, check=False)
        return [line for line in done.stderr.splitlines() if re.search(r"error E(?!113|201)[12]\d\d", line)]


class Names(unittest.TestCase):
    def test_index_names_every_page(self):
        index = (MANUAL / "index.md").read_text(encoding="utf-8")
        for page in pages():
            if page != "index.md" and not page.startswith(("theory/", "gallery/")):
                self.assertIn(f"]({page})", index)
        scenes = (MANUAL / "gallery/index.md").read_text(encoding="utf-8")
        for page in pages():
            if page.startswith("gallery/") and page != "gallery/index.md":
                self.assertIn(f"]({page.removeprefix('gallery/')})", scenes)
        self.assertIn("](gallery/index.md)", index)

    def test_blocks_that_are_not_run_say_why(self):
        for page in pages():
            for block in blocks_of(page):
                if "not run" in block.marks:
                    self.assertGreater(len(block.marks["not run"]), 8, block.place)
                    print(f"not run: {block.place}: {block.marks['not run']}")


for name in RUN:
    if not ONLY or name in ONLY:
        setattr(Pages, "test_" + re.sub(r"\W", "_", name.removesuffix(".md")), page_test(name))

if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"] + (["Pages"] if ONLY else []))
