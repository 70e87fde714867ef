# SPDX-License-Identifier: GPL-3.0-or-later
"""`spricka verify`: decks against their references, side by side, and what has changed since the last time."""

import csv
import os
import signal
import subprocess
import time
import unittest
from pathlib import Path

from program import PROGRAM, SANITIZED, TOP, ProgramTest, environment, main, plate

BUILD = Path(PROGRAM).parents[1]  # build/PRESET/bin/spricka
GOOD = "$CHECK\n  S.XX.AT(5,2.5,LOAD) = 100 REL {} SOURCE 'the load'\n"
SLOW = plate(GOOD.format("1e-2")).replace("NX=4 NY=2", "NX=400 NY=200")


def rows(path):
    with open(path, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


class Verify(ProgramTest):
    def decks(self, **texts):
        folder = self.folder / "decks"
        folder.mkdir(exist_ok=True)
        for name, text in texts.items():
            (folder / f"{name}.deck").write_text(text, encoding="utf-8")
        return folder

    def verify(self, code, *arguments):
        return self.expect(code, "verify", "--decks", self.folder / "decks", *arguments)

    def test_table_page_and_exit_codes(self):
        self.decks(good=plate(GOOD.format("1e-2")), bare=plate())
        done = self.verify(0, "all", "--jobs", 2)
        self.assertIn("passed good", done.stdout)
        self.assertIn("1 without a check", done.stdout)
        table = rows(self.folder / "verification/verification.csv")
        self.assertEqual([row["deck"] for row in table], ["bare", "good"])
        good = table[1]
        self.assertEqual(good["quantity"], "S.XX.AT(5,2.5,LOAD)")
        self.assertEqual(float(good["reference"]), 100.0)
        self.assertAlmostEqual(float(good["result"]), 100.0, delta=1.0)
        self.assertEqual(good["source"], "the load")
        # 4 x 2 elements of eight nodes, 37 nodes, 5 of them held
        self.assertEqual(int(good["freedoms"]), 2 * 37 - 2 * 5)
        self.assertGreater(float(good["cpu"]), 0.0)
        self.assertGreater(float(good["memory"]), 5.0)
        self.assertIn("spricka", good["program"])
        page = (self.folder / "verification/verification.html").read_text(encoding="utf-8")
        self.assertIn("S.XX.AT(5,2.5,LOAD)", page)
        self.assertNotIn("<script src", page)  # nothing is loaded from elsewhere
        self.assertEqual(
            {f.name for f in (self.folder / "verification").iterdir()},
            {"verification.csv", "verification.html"},
        )

        # The same again: nothing has changed; then one tolerance is missed and a deck has a mistake.
        self.assertIn("nothing has changed", self.verify(0, "all").stdout)
        self.decks(good=plate(GOOD.format("1e-9")))
        missed = self.verify(1, "all")
        self.assertIn("FAILED good", missed.stdout)
        self.assertIn("missed now: 1", missed.stdout)
        self.decks(broken="$DECK VERSION=1 LENGTH=MM FORCE=N\n$MESCH SHAPE=BLOCK\n$END\n")
        broken = self.verify(3, "broken", "good")
        self.assertIn("$MESCH", broken.stdout)

    def test_a_deck_that_dies_takes_none_along(self):
        # more memory than it is allowed: the system or the program ends it
        if SANITIZED:
            self.skipTest("no limit of memory binds")
        self.decks(good=plate(GOOD.format("1e-2")), huge=SLOW)
        limited = subprocess.run(
            ["bash", "-c", f"ulimit -v 600000; exec {PROGRAM} verify all --decks decks --jobs 1"],
            cwd=self.folder, env=environment(), text=True, capture_output=True, timeout=120, check=False,
        )
        self.assertNotIn(limited.returncode, (0, 1), limited.stdout + limited.stderr)
        self.assertIn("passed good", limited.stdout)
        self.assertIn("FAILED huge", limited.stdout)

    def test_names_patterns_and_what_there_is(self):
        self.decks(hertz_line=plate(), hertz_sphere=plate(), kirsch=plate())
        listed = self.verify(0, "hertz*", "--list").stdout
        self.assertIn("hertz_line", listed)
        self.assertNotIn("kirsch", listed)
        self.assertFalse((self.folder / "verification").exists())
        wrong = self.verify(2, "kirch")
        self.assertIn("did you mean 'kirsch'", wrong.stderr)

    def test_costs_make_tiers(self):
        self.decks(one=plate())
        self.assertIn("no deck 'quick'", self.verify(2).stderr)  # none has a cost yet
        self.verify(0, "all", "--costs")
        self.assertIn("one", (self.folder / "decks/costs.csv").read_text(encoding="utf-8"))
        self.verify(0)

    def test_sweeps_are_rows_by_point(self):
        self.decks(sweep=plate(GOOD.format("(s/10)") + "$SWEEP PARAMETER=s\n  1 2\n").replace(
            "$MESH", "$PARAMETER\n  s = 1\n$MESH", 1))
        self.verify(0, "all")
        table = rows(self.folder / "verification/verification.csv")
        self.assertEqual([row["point"] for row in table], ["s = 1", "s = 2"])
        self.assertEqual([float(row["allowed"]) for row in table], [0.1, 0.2])

    def test_ctrl_c_leaves_nothing_behind(self):
        self.decks(**{f"slow{i}": SLOW for i in range(6)})
        for stop in (signal.SIGINT, signal.SIGTERM):
            child = subprocess.Popen(
                [PROGRAM, "verify", "all", "--decks", "decks", "--jobs", "2"],
                cwd=self.folder, env=environment(), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            )
            while not list(self.folder.glob("verification/runs.*/*.part")):  # until decks run
                self.assertIsNone(child.poll())
                time.sleep(0.02)
            child.send_signal(stop)
            _, said = child.communicate(timeout=60)
            self.assertEqual(child.returncode, 128 + stop)
            self.assertIn(b"nothing is written", said)
            self.assertEqual(list((self.folder / "verification").iterdir()), [])
            mine = subprocess.run(["pgrep", "-f", str(self.folder)], capture_output=True, text=True, check=False)
            self.assertEqual(mine.stdout, "")

    def test_page_of_the_manual_has_its_table_beside_it(self):
        self.decks(good=plate(GOOD.format("1e-2")))
        self.verify(0, "all", "--markdown", self.folder / "page.md")
        page = (self.folder / "page.md").read_text(encoding="utf-8")
        self.assertIn("| `good` |", page)
        self.assertIn("[page.csv](page.csv)", page)
        self.assertEqual((self.folder / "page.csv").read_bytes(),
                         (self.folder / "verification/verification.csv").read_bytes())

    def test_no_table_of_its_own_is_no_comparison(self):
        self.decks(good=plate(GOOD.format("1e-2")))
        (self.folder / "verification").mkdir()
        (self.folder / "verification/verification.csv").write_text("a,b\n1,2\n", encoding="utf-8")
        self.assertNotIn("Since", self.verify(0, "all").stdout)


class Problems(unittest.TestCase):
    def test_tests_that_problems_name_are_there(self):
        known = subprocess.run(["ctest", "--test-dir", BUILD, "-N"], capture_output=True, text=True, check=True).stdout
        for row in rows(TOP / "decks/problems.csv"):
            for name in row["tests"].split():
                if f"test_{name.partition('.')[0]}_NOT_BUILT" not in known:
                    self.assertTrue(f": {name}" in known, f"{row['problem']}: there is no test {name}")


if __name__ == "__main__":
    main()
