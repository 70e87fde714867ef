# SPDX-License-Identifier: GPL-3.0-or-later
"""The view of reports in a browser that draws in space: no script complains, no text is cut, labels do not overlap;
it is turned, cut and painted anew, and its picture changes each time; plots tell the numbers of their curves.

test_view.py PROGRAM: one deck; with SPRICKA_FULL=1 ten.
test_view.py PROGRAM --pictures FOLDER DECK ..: pictures of the reports' views, to be looked at.
"""

import csv
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

from looking import LOOK, TOP, WIDTHS, run
from report_view import Browser, Report

PROGRAM = Path(sys.argv[1]).resolve()
FULL = bool(os.environ.get("SPRICKA_FULL"))
OVERLAPS = (Path(__file__).parent / "overlaps.js").read_text(encoding="utf-8")

# Bodies in contact with a crack in space; in --full planes and solids, lives, and bodies without a crack, too.
DECKS = ["lug_slice_crack_solid"]
MORE = ["lug_single", "lug_corner_crack_solid", "lug_corner_life", "penny_solid", "lug_solid", "edge_crack_life",
        "link_up", "lame_press_fit", "kirsch"]
LARGEST = 3_000_000  # bytes of a report of a solid of a few ten thousand unknowns


class Views(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.close)
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.runs = Path(folder.name)
        cls.decks = DECKS + (MORE if FULL else [])
        for deck in cls.decks:
            run(PROGRAM, "run", TOP / "decks" / f"{deck}.deck", "--out", cls.runs / deck, "--quiet")

    def page(self, deck):
        return self.runs / deck / "report.html"

    def each(self, act, widths=WIDTHS):
        """Does it with the report of each deck at these widths."""
        for deck in self.decks:
            for width in widths:
                with self.subTest(f"{deck} at {width}"):
                    act(Report(self.browser, self.page(deck), width))

    def assert_changes(self, report, what, act):
        """The picture after it is not the one before."""
        before = report.last or report.picture()
        act()
        report.last = report.picture()
        self.assertNotEqual(before, report.last, f"{what} changes nothing")

    def test_nothing_complains_is_cut_or_overlaps(self):
        def look(report):
            self.assertTrue(self.browser.value("document.querySelector('.view-works') !== null"), "no view")
            self.assertEqual([], self.browser.value(LOOK) + self.browser.value(OVERLAPS) + self.browser.errors)

        self.each(look)

    def test_paper_has_the_still_pictures_alone(self):
        Report(self.browser, self.page(self.decks[0]), 1280)
        self.browser.call("Emulation.setEmulatedMedia", media="print")
        shown = self.browser.value(
            "['#view', 'figure svg'].map(e => document.querySelector(e).getClientRects().length > 0)")
        self.browser.call("Emulation.setEmulatedMedia", media="")
        self.assertEqual([False, True], shown)

    def test_without_webgl_a_word_says_why_pictures_are_still(self):
        with Browser(webgl=False) as browser:
            report = Report(browser, self.page(self.decks[0]), 1280)
            self.assertIn("WebGL", report.text("view-word"))
            self.assertEqual([], browser.errors)

    def test_size(self):
        for deck in [d for d in self.decks if d.endswith("_solid")]:
            self.assertLess(self.page(deck).stat().st_size, LARGEST, deck)

    def test_everything_that_is_set_changes_the_picture(self):
        self.each(self.set_all, WIDTHS if FULL else WIDTHS[1:])

    def move(self, report):
        left, top, width, height = report.canvas()
        middle = (left + 0.5 * width, top + 0.5 * height)
        first = report.last = report.picture()
        self.assert_changes(report, "dragging", lambda: self.browser.drag(middle, (middle[0] + 60, middle[1] + 25)))
        self.assert_changes(report, "the wheel",
                            lambda: self.browser.mouse("mouseWheel", *middle, deltaX=0, deltaY=-240))
        self.browser.mouse("mouseMoved", 1, 1)
        report.press("reset")
        report.last = report.picture()
        self.assertEqual(first, report.last, "reset is not the first picture")

    def set_all(self, report):
        self.move(report)
        fields, chosen = report.options("field")
        for field in fields[:: 1 if FULL else 3]:
            if field != chosen:
                self.assert_changes(report, f"field {field}", lambda: report.set("field", field))
                chosen = field
        report.set("field", "1")  # displacement
        report.last = None
        for control in ("step", "length"):
            entries, chosen = report.options(control) if report.has(control) else ([], "")
            for other in [e for e in entries if e != chosen][:1]:
                self.assert_changes(report, control, lambda: report.set(control, other))
                report.set(control, chosen)
                report.last = None
        self.assert_changes(report, "displacement", lambda: report.set("displacement", 90))
        def set_one(control, value):
            if report.has(control):
                self.assert_changes(report, control, lambda: report.set(control, value))

        set_one("cut-axis", 2)
        if report.has("crack"):  # one within a body is seen where that is cut, and from near by
            self.assert_changes(report, "crack", lambda: report.press("crack"))
        set_one("opening", 100)
        set_one("mark", 0)
        report.press("reset")
        report.last = None
        set_one("cut", 30)
        if report.has("cut-axis"):
            report.set("cut-axis", 0)
        bodies = self.browser.value("[...document.querySelectorAll('[id^=view-body-]')].map(e => e.id.slice(5))")
        report.last = None
        for body in bodies[:1]:
            self.assert_changes(report, body, lambda: report.set(body, False))
            self.assert_changes(report, body, lambda: report.set(body, True))
        self.assert_changes(report, "edges", lambda: report.press("edges"))
        if report.has("from-x"):
            self.assert_changes(report, "from-x", lambda: report.press("from-x"))
        self.assertEqual([], self.browser.errors)

    def test_the_pointer_reads_places_and_values(self):
        def read(report):
            report.set("field", "1")
            left, top, width, height = report.canvas()
            texts = []
            for part in range(1, 10):  # along a slanted line over the bodies
                self.browser.mouse("mouseMoved", left + width * part / 10, top + height * (0.3 + 0.04 * part))
                self.browser.settle()
                texts.append(report.text("view-tip"))
            found = [t for t in texts if t]
            self.assertGreater(len(found), 2, texts)
            self.assertTrue(any(re.search(r"node \d+\nat [-\d.e]+, [-\d.e]+.*\ndisplacement [-\d.e]+ \w+", t)
                                for t in found), found)

        self.each(read, WIDTHS if FULL else WIDTHS[1:])

    def test_plots_tell_what_k_csv_has(self):
        deck = DECKS[0]
        report = Report(self.browser, self.page(deck), 1280)
        with (self.runs / deck / "k.csv").open(encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        known = {(r["step"], f"{float(r['phi'] or r['s']):.6g}", f"{float(r['K1']):.6g}") for r in rows}
        places = self.browser.value(
            "(() => { const p = [...document.querySelectorAll('g.plot')].find(p => /^K/.test(p.dataset.yName));"
            "p.scrollIntoView({ block: 'center' }); return [...p.querySelectorAll('g.curve path')]"
            ".filter(c => c.parentNode.dataset.name.endsWith('K1')).map(c => { const m = c.getScreenCTM();"
            "const at = new DOMPoint(...c.getAttribute('d').match(/[-\\d.]+/g).slice(0, 2).map(Number))"
            ".matrixTransform(m); return [at.x, at.y]; }); })()")
        self.assertGreater(len(places), 0)
        for x, y in places:
            self.browser.mouse("mouseMoved", x + 1, y + 1)
            name, across, up = report.text("curve-tip").split("\n")
            number = [words.split(" = ")[1].split(" ")[0] for words in (across, up)]
            self.assertIn((name.partition(":")[0], *number), known)


def take_pictures(folder, decks):
    """Screens of the views of these decks, at both widths."""
    folder = Path(folder)
    with Browser() as browser:
        for deck in decks:
            run(PROGRAM, "run", TOP / "decks" / f"{deck}.deck", "--out", folder / deck, "--quiet")
            for width in WIDTHS:
                report = Report(browser, folder / deck / "report.html", width)
                (folder / f"{deck}_{width}.png").write_bytes(report.stage())


if __name__ == "__main__":
    if "--pictures" in sys.argv:
        take_pictures(sys.argv[3], sys.argv[4:])
    else:
        unittest.main(argv=[sys.argv[0], "-v"] + sys.argv[2:])
