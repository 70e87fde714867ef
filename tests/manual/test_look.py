# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages as a browser shows them: reports of runs and the manual as a site, at the widths of a screen and
of a telephone. No picture is missing, no script complains, no text is cut (look.js).

test_look.py PROGRAM FOLDER: the site is made in FOLDER. Of its pages one or two of each kind are looked at, of its
pictures every fifth; with SPRICKA_FULL=1 all of them, and the PDF.
"""

import os
import sys
import tempfile
import unittest
from pathlib import Path

from looking import LOOK, TOP, WIDTHS, run
from chromium import Browser

PROGRAM, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
FULL = bool(os.environ.get("SPRICKA_FULL"))

# Text, a deck, printed lines, wide tables, equations, pictures, lists of words: what pages are made of.
SOME = ["index", "quickstart", "tutorial", "command_line", "cards", "verification", "stability", "glossary",
        "solid_crack", "view", "theory/estimate", "gallery/index", "gallery/penalty", "howto/symmetry"]

# A crack on both sides of a bore, a life, fronts in space, a path of loads, a spectrum, contact in the plane and in
# space, many tips, no crack.
DECKS = ["lug_single", "lug_spectrum", "surface_crack_solid", "lug_load_path", "lame_press_fit", "link_up", "kirsch",
         "edge_crack_life", "lug_solid", "lug_corner_crack_solid"]
SWEEP = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Widths'
$PARAMETER
  W = 20
$SWEEP PARAMETER=W
  20  40
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=(W) LY=40 NX=8 NY=12
$MATERIAL NAME=ALU E=70[GPa] NU=0.33
$PROPERTY ESET=BODY MATERIAL=ALU STATE=STRESS THICK=2
$FREEDOM CLASS=SUPPRESSED DOF=XY
  YMIN
$LOAD CASE=PULL TYPE=TRACTION
  YMAX  0  100[MPa]
$STEP NAME=LOAD
  LOAD PULL 1
$CRACK NAME=C1 A0=4 ANGLE=0
  0  20
$END
"""


class Look(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.close)

    def look(self, page):
        """Faults of a page at all widths."""
        faults = []
        for width in WIDTHS:
            self.browser.width(width)
            self.browser.open(page.as_uri())
            self.browser.value("document.querySelectorAll('details').forEach(d => d.open = true)")
            found = self.browser.value(LOOK) + [f"the browser says: {e}" for e in self.browser.errors]
            faults += [f"{page.name} at {width}: {fault}" for fault in found]
        return faults

    def assert_good(self, page):
        with self.subTest(str(page)):
            self.assertEqual([], self.look(page))


class Faults(Look):
    """What must be found."""

    PAGE = """<!DOCTYPE html><meta charset="utf-8"><style>div { white-space: nowrap }</style>
<img src="lost.png"><div style="width: 50px; overflow: hidden">cut off in the middle</div>
<div style="width: 2000px; text-align: right">out on the right</div>
<svg width="50" height="20"><text x="40" y="15">leaves</text></svg>
<svg width="90" height="20"><text x="2" y="15">one over</text><text x="9" y="14">another</text></svg>
<table style="display: block; overflow-x: auto; width: 40px"><tr><td style="white-space: nowrap">a table that is too wide</td></tr></table>
<div style="overflow: auto; width: 50px">this one can be scrolled</div><script>nothing.there()</script>"""

    def test_faults_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "bad.html"
            page.write_text(self.PAGE, encoding="utf-8")
            faults = "\n".join(self.look(page))
        for words in ("is 2008 wide", "lost.png is missing", '"cut off in the middle" is cut', '"out on the right" goes',
                      '"leaves" leaves', "nothing is not defined", "ERR_FILE_NOT_FOUND",
                      '"one over" and <text> "another" cover each other', "wide in a box of 40"):
            self.assertIn(words, faults)
        self.assertNotIn("scrolled", faults)


class Reports(Look):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.runs = Path(folder.name)
        for deck in DECKS:
            run(PROGRAM, "run", TOP / "decks" / f"{deck}.deck", "--out", cls.runs / deck, "--quiet")

    def test_reports(self):
        for deck in DECKS:
            self.assert_good(self.runs / deck / "report.html")

    def test_page_of_a_sweep(self):
        deck = self.runs / "sweep.deck"
        deck.write_text(SWEEP, encoding="utf-8")
        run(PROGRAM, "run", deck, "--out", self.runs / "sweep", "--quiet")
        self.assert_good(self.runs / "sweep" / "sweep.html")

    def test_first_table_of_K_has_its_error_bar(self):
        for deck in ("lug_single", "surface_crack_solid"):
            with self.subTest(deck):
                self.browser.open((self.runs / deck / "report.html").as_uri())
                head, row = self.browser.value(
                    "(() => { const tables = [...document.querySelectorAll('table')];"
                    "const t = tables.find(t => /\\bK1/.test(t.querySelector('thead').textContent));"
                    "const cells = r => [...r.cells].map(c => c.textContent.trim());"
                    "const rows = [...t.querySelectorAll('tbody tr')];"
                    "return [cells(t.querySelector('thead tr')), cells(rows[Math.floor(rows.length / 2)])]; })()")
                at = next(i for i, words in enumerate(head) if words.startswith("K1"))
                self.assertTrue(head[at + 1].startswith(("±", "+-")), head)
                K, bar = abs(float(row[at])), float(row[at + 1])
                self.assertGreater(bar, 1e-6 * K)
                self.assertLess(bar, 0.05 * K)


class Site(Look):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run(TOP / "manual" / "build", *([] if FULL else ["--html"]), FOLDER)
        cls.html = FOLDER.resolve() / "html"

    def test_pages(self):
        pages = sorted(self.html.rglob("*.html"))
        self.assertGreater(len(pages), 50)
        if not FULL:
            pages = [self.html / f"{name}.html" for name in SOME]
        for page in pages:
            if page.name not in ("genindex.html", "search.html"):
                self.assert_good(page)

    def test_pictures(self):
        for picture in sorted((self.html / "_images").glob("*.svg"))[::None if FULL else 5]:
            page = picture.with_suffix(".html")
            page.write_text('<!DOCTYPE html><meta charset="utf-8"><style>svg { max-width: none }</style>'
                            + picture.read_text(encoding="utf-8").partition("?>")[2], encoding="utf-8")
            self.browser.width(1280)
            self.browser.open(page.as_uri())
            found = [f for f in self.browser.value(LOOK) if "drawing" in f]
            page.unlink()
            self.assertEqual([], found, picture.name)

    def test_search_without_a_server(self):
        self.browser.width(1280)
        self.browser.open((self.html / "search.html").as_uri() + "?q=interference")
        titles = self.browser.value(
            "new Promise(done => { const read = () => [...document.querySelectorAll('#search-results li a')]"
            ".map(a => a.textContent); const wait = n => setTimeout(() => read().length > 3 || n == 0 ?"
            "done(read()) : wait(n - 1), 100); wait(100); })")
        self.assertEqual([], self.browser.errors)
        self.assertTrue(any("interference" in title.lower() for title in titles), titles)

    def test_equations_are_numbered_and_linked(self):
        self.browser.open((self.html / "theory/estimate.html").as_uri())
        numbers, lost = self.browser.value(
            "[[...document.querySelectorAll('.eqno')].map(e => e.textContent),"
            "[...document.querySelectorAll('a.eqref')].filter(a => a.getAttribute('href').startsWith('#') &&"
            "!document.getElementById(a.getAttribute('href').slice(1))).map(a => a.textContent)]")
        self.assertIn("(estimate.23)", numbers)
        self.assertEqual([], lost)

    @unittest.skipUnless(FULL, "SPRICKA_FULL=1 only")
    def test_pdf(self):
        data = (FOLDER / "spricka.pdf").read_bytes()
        self.assertTrue(data.startswith(b"%PDF"))
        self.assertGreater(data.count(b"/Type /Page\n"), 100)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"] + sys.argv[3:])
