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
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from blocks import MANUAL, blocks_of, pages, setup_of
from pictures import drawings_of, pictures_of
from reader import NUMBER, Reader, same_number

PROGRAM = Path(sys.argv[1]).resolve()
ONLY = sys.argv[2:]

# Pages whose commands are run, block by block, each page in a folder of its own.
README = "../README.md"
START = ["quickstart.md", "first_deck.md", "tutorial.md", "own_lug.md"]
RUN = [README, *START, "command_line.md", "restart.md", "sweeps.md",
       "results_file.md", "check.md", "shell.md", "profile.md"]
RUN += sorted(f"howto/{p.name}" for p in (MANUAL / "howto").glob("*.md"))
# Of those the ones whose blocks all say what they are; on the others only marked ones count.
STRICT = [p for p in RUN if p in (README, *START) or p.startswith("howto/")]
# Of those the ones every number of whose text must be in a deck or printed by one (README: or on a page that
# it links to).
CHECKED = [README, "tutorial.md", "own_lug.md"]
# For those who change the program: their commands build and test it.
DEVELOPERS = ["CONTRIBUTING.md", "architecture.md", "new_card.md", "new_element.md", "new_result.md"]

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


LINK = re.compile(r"\]\(([^)#:]+)(?:#[^)]*)?\)")


def numbers_of_linked_pages(page):
    path = MANUAL / page
    linked = {path.parent / link for link in LINK.findall(path.read_text(encoding="utf-8")) if link.endswith(".md")}
    return {n for file in linked for n in NUMBER.findall(file.read_text(encoding="utf-8"))}


class Pages(unittest.TestCase):
    """One test for each page, made below."""


def page_test(page):
    def test(self):
        with tempfile.TemporaryDirectory() as folder:
            reader = Reader(PROGRAM, folder)
            reader.strict = page in STRICT
            code, printed = reader.shell(setup_of(page))
            self.assertEqual(code, 0, printed)
            for block in blocks_of(page):
                self.assertEqual("", reader.do(block), f"{block.place}")
            for picture in pictures_of((MANUAL / page).read_text(encoding="utf-8")):
                report = reader.folder / picture.report
                if report.exists() or reader.full or not any("long" in b.marks for b in blocks_of(page)):
                    self.assertTrue(drawings_of(picture, report.read_text(encoding="utf-8")), picture.file)
            if page in CHECKED:
                known = reader.known | (numbers_of_linked_pages(page) if page == README else set())
                self.assertEqual([], unknown_numbers(page, known), page)

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


class FrontPage(unittest.TestCase):
    TEXT = (MANUAL / README).read_text(encoding="utf-8")

    def test_is_short(self):
        self.assertLessEqual(len(self.TEXT.splitlines()), 90)

    def test_deck_is_one_that_ships(self):
        deck = re.search(r"^```deck\n(.*?)^```$", self.TEXT, flags=re.S | re.M)[1]
        name = re.search(r"decks/\w+\.deck", self.TEXT)[0]
        self.assertEqual(deck, (MANUAL / README).parent.joinpath(name).read_text(encoding="utf-8"))

    def test_links_lead_somewhere(self):
        for link in LINK.findall(self.TEXT):
            self.assertTrue((MANUAL / README).parent.joinpath(link).exists(), link)


class Pictures(unittest.TestCase):
    def test_pictures_are_there(self):
        for page in [README, *pages()]:
            for picture in pictures_of((MANUAL / page).read_text(encoding="utf-8")):
                drawing = (MANUAL / page).parent / picture.file
                self.assertEqual(ElementTree.parse(drawing).getroot().tag, "{http://www.w3.org/2000/svg}svg", page)

    def test_pages_to_begin_with_have_one(self):
        for page in [README, *START, *(p for p in pages() if p.startswith("howto/"))]:
            self.assertTrue(pictures_of((MANUAL / page).read_text(encoding="utf-8")), page)


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
