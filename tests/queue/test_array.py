# SPDX-License-Identifier: GPL-3.0-or-later
"""Tasks of a job array, started by hand: each runs its share, in any order, at the same time, killed and run again;
whoever collects gets the files of one process to the byte, and what is missing by name."""

import csv
import signal
import unittest

from sweeps import FULL, POINTS, PROGRAM, SweepTest, environment, keeping, main, sweep_deck  # noqa: F401

from program import plate

TASKS = 3
SLOW = ("NX=4 NY=2", "NX=60 NY=30" if FULL else "NX=40 NY=20")


class Array(SweepTest):
    def task(self, number, deck, **more):
        return self.start("sweep", deck, "--out", "shared", "--array", f"{number}/{TASKS}", "--quiet", **more)

    def points(self, folder="shared"):
        return sorted(f.name for f in (self.folder / folder).iterdir() if f.name.isdigit())

    def test_tasks_at_the_same_time(self):
        deck = self.deck(sweep_deck())
        self.whole_sweep(deck)
        early = self.expect(6, "sweep", deck, "--out", "shared", "--collect")
        self.assertIn("E553", early.stderr)
        self.assertFalse((self.folder / "shared").exists())
        for child in [self.task(n, deck) for n in range(1, TASKS + 1)]:
            _, errors = child.communicate(timeout=300)
            self.assertIn(child.returncode, (0, 3), errors)
            self.assertTrue(child.returncode == 0 or "E550" in errors, errors)
        self.expect(3, "sweep", deck, "--out", "shared", "--collect")
        files = self.same_sweeps("whole", "shared")
        self.assertIn(f"{POINTS - 1:03}.failed/point.json", files)
        self.assertEqual(files["sweep.csv"].count(b"\n"), POINTS + 2)

        # Tasks that are started again compute the failed point alone; a table is as it was.
        again = self.expect(0, "sweep", deck, "--out", "shared", "--array", "1/1000")
        self.assertIn("done earlier", again.stdout)
        self.expect(3, "run", deck, "--out", "shared", "--quiet")
        self.same_sweeps("whole", "shared")

    def test_a_killed_task_is_found_and_run_again(self):
        deck = self.deck(sweep_deck().replace(*SLOW))
        self.whole_sweep(deck)
        child = self.task(1, deck)
        self.until(self.folder.joinpath("shared/004.part").exists, child)
        child.kill()
        child.communicate()
        for number in (2, 3):
            self.task(number, deck).communicate(timeout=600)
        short = self.expect(6, "sweep", deck, "--out", "shared", "--collect")
        own = [f"{n:03}" for n in range(4, POINTS + 1, TASKS)]
        self.assertIn(f"missing in shared: {', '.join(own)};", short.stderr)
        # A table of what is there.
        table = (self.folder / "shared/sweep.csv").read_text()
        self.assertEqual(table.count("\n"), POINTS + 2 - len(own))
        _, errors = self.task(1, deck).communicate(timeout=600)
        self.expect(3, "sweep", deck, "--out", "shared", "--collect", "--quiet")
        self.same_sweeps("whole", "shared")

    def test_a_signal_ends_a_task_as_not_finished(self):
        deck = self.deck(sweep_deck().replace(*SLOW))
        child = self.task(2, deck)
        self.until(self.points_begun, child)
        child.send_signal(signal.SIGTERM)
        _, errors = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 6, errors)
        self.assertIn("E551", errors)
        self.assertFalse(any(f.name.endswith(".part") for f in (self.folder / "shared").iterdir()))

    def points_begun(self):
        place = self.folder / "shared"
        return place.exists() and any(f.name.endswith(".part") and f.name[0].isdigit() for f in place.iterdir())

    def test_a_signal_keeps_the_lengths_of_a_point(self):
        # Many lengths, to be stopped between.
        lengths = "  ".join(f"{1 + 0.1 * i:g}" for i in range(12))
        text = sweep_deck(4 if FULL else 3, "$RESTART WRITE='state.rst'\n").replace(*SLOW)
        deck = self.deck(text.replace("  1  1.5  2\n", f"  {lengths}\n"))
        child = self.task(1, deck)
        state = self.folder / "shared/001.restart/state.rst"
        self.until(state.exists, child)
        child.send_signal(signal.SIGTERM)
        _, errors = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 6, errors)
        self.expect(0, "sweep", deck, "--out", "shared", "--array", f"1/{TASKS}", "--restart", "--quiet")
        self.assertIn("taken over", (self.folder / "shared/001/listing.txt").read_text())
        self.expect(3, "sweep", deck, "--out", "whole", "--quiet")
        for name in ("k.csv", "results.h5"):
            for point in ("001", "004") if FULL else ("001",):
                self.assertEqual((self.folder / "shared" / point / name).read_bytes(),
                                 (self.folder / "whole" / point / name).read_bytes())

    def test_two_of_the_same_number(self):
        deck = self.deck(sweep_deck(6).replace(*SLOW))
        children = [self.task(1, deck) for _ in range(2)]
        codes = []
        for child in children:
            _, errors = child.communicate(timeout=300)
            codes.append(child.returncode)
            self.assertTrue(child.returncode == 0 or "another process computes" in errors, errors)
        self.assertIn(0, codes)
        self.assertLessEqual(set(codes), {0, 6})
        self.assertEqual(self.points(), ["001", "004"])

    def test_a_whole_sweep_and_tasks_keep_apart(self):
        deck = self.deck(sweep_deck(6).replace(*SLOW))
        child = self.start("run", deck, "--out", "shared", "--quiet")
        self.until(self.points_begun, child)
        refused = self.expect(7, "sweep", deck, "--out", "shared", "--array", "1/2", "--quiet")
        self.assertIn("E465", refused.stderr)
        child.terminate()
        child.communicate(timeout=60)
        child = self.task(1, deck)
        self.until(self.points_begun, child)
        self.assertIn("E465", self.expect(7, "run", deck, "--out", "shared", "--quiet").stderr)
        child.terminate()
        child.communicate(timeout=60)

    def test_what_slurm_says(self):
        deck = self.deck(sweep_deck(6))
        says = {f"SLURM_ARRAY_TASK_{k}": str(v) for k, v in
                {"ID": 14, "MIN": 10, "MAX": 14, "STEP": 2, "COUNT": 3}.items()}
        done = self.expect(0, "sweep", deck, "--out", "shared", "--array", "slurm", SLURM_CPUS_PER_TASK="2", **says)
        self.assertIn("task 3 of 3: 2 of 6 points", done.stdout)
        self.assertEqual(self.points(), ["003", "006"])
        for changes, why in (({"ID": "13"}, "no plain range"), ({"COUNT": "2"}, "no plain range")):
            more = says | {f"SLURM_ARRAY_TASK_{k}": v for k, v in changes.items()}
            self.assertIn(why, self.expect(2, "sweep", deck, "--array", "slurm", **more).stderr)
        self.assertIn("SLURM_ARRAY_TASK_ID", self.expect(2, "sweep", deck, "--array", "slurm").stderr)

    def test_wrong_calls(self):
        deck = self.deck(sweep_deck(3))
        for text in ("0/3", "4/3", "3", "1/0", "a/b", "-1/2", "1/2/3"):
            self.assertIn("--array", self.expect(2, "sweep", deck, f"--array={text}").stderr)
        self.expect(2, "sweep", deck, "--array", "1/2", "--collect")
        self.assertIn("E552", self.expect(2, "sweep", self.deck(plate(), "plain.deck")).stderr)
        # As spricka run has it.
        self.expect(3, "sweep", deck, "--out", "one", "--quiet")
        self.expect(3, "run", deck, "--out", "whole", "--quiet")
        self.same_sweeps("one", "whole")
        # More tasks than points.
        idle = self.expect(0, "sweep", deck, "--out", "idle", "--array", "5/7")
        self.assertIn("0 of 3 points", idle.stdout)

    def test_a_changed_deck_is_computed_anew(self):
        # Of the point that fails in the new deck the results of the old one stay, as in a whole sweep.
        self.expect(3, "sweep", self.deck(sweep_deck(4)), "--out", "shared", "--array", "1/1", "--quiet")
        self.expect(3, "sweep", self.deck(sweep_deck(4)), "--out", "whole", "--quiet")
        deck = self.deck(sweep_deck(3))
        missing = self.expect(6, "sweep", deck, "--out", "shared", "--collect", "--quiet")
        self.assertIn("001, 002, 003", missing.stderr)
        self.expect(3, "sweep", deck, "--out", "shared", "--array", "1/1", "--quiet")
        self.expect(3, "sweep", deck, "--out", "shared", "--collect", "--quiet")
        self.whole_sweep(deck)
        self.same_sweeps("whole", "shared")


GOOD = "$CHECK\n  S.XX.AT(5,2.5,LOAD) = 100 REL {} SOURCE 'the load'\n"


def answers(path):
    """Rows of a table without what the runs cost, and where."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    cost = ("cpu", "wall", "memory", "peak_memory", "machine")
    return [{k: v for k, v in row.items() if k not in cost} for row in csv.DictReader(lines)]


class ManyDecks(SweepTest):
    """The same road for verify, study and ladder."""

    def decks(self):
        folder = self.folder / "decks"
        folder.mkdir()
        for name, text in (("good", plate(GOOD.format("1e-2"))), ("bare", plate()), ("bad", plate(GOOD.format("1e-9"))),
                           ("broken", plate("$NONSENSE\n")), ("good2", plate(GOOD.format("1e-2")))):
            (folder / f"{name}.deck").write_text(text, encoding="utf-8")
        return folder

    def checks_of(self, folder):
        return answers(self.folder / folder / "verification.csv")

    def test_verify(self):
        folder = self.decks()
        whole = self.expect(3, "verify", "--decks", folder, "all", "--out", "whole", "--quiet")
        shared = ("verify", "--decks", folder, "all", "--out", "shared", "--quiet")
        codes = [self.run_program(*shared, "--array", f"{n}/3").returncode for n in (1, 3)]
        short = self.expect(6, *shared, "--collect")
        self.assertRegex(short.stderr, "E553.* of 5 decks are missing")
        codes.append(self.run_program(*shared, "--array", "2/3").returncode)
        self.assertEqual(max(codes), 3)
        self.expect(3, *shared, "--collect")
        self.assertEqual(self.checks_of("whole"), self.checks_of("shared"))
        self.assertIn("did not end with exit code 0", whole.stdout)
        # A deck that changes is run again, as every deck may include it.
        (folder / "bad.deck").write_text(plate(GOOD.format("1e-2")), encoding="utf-8")
        self.assertIn("5 of 5 decks are missing", self.expect(6, *shared, "--collect").stderr)

    @unittest.skipUnless(FULL, "SPRICKA_FULL is not set")
    def test_a_task_of_verify_is_stopped_and_goes_on(self):
        folder = self.decks()
        slow = plate(GOOD.format("1e-2")).replace("NX=4 NY=2", "NX=300 NY=150")
        (folder / "slow.deck").write_text(slow, encoding="utf-8")
        call = ("verify", "--decks", folder, "all", "--out", "shared", "--quiet", "--jobs", 1)
        child = self.start(*call, "--array", "1/1")
        kept = self.folder / "shared/runs"
        self.until((kept / "slow.part").exists, child)
        child.terminate()
        _, errors = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 6, errors)
        self.assertIn("what has ended is kept", errors)
        ended = {f.name for f in kept.glob("*.end")}
        self.assertFalse(kept.joinpath("slow.part").exists())
        self.assertNotIn("slow.end", ended)
        self.expect(3, *call, "--array", "1/1")
        self.expect(3, *call, "--collect")
        # Nothing but runs and records is left beside page and table.
        self.assertEqual({f.name for f in (self.folder / "shared").iterdir()},
                         {"runs", "verification.csv", "verification.html"})

    @unittest.skipUnless(FULL, "SPRICKA_FULL is not set")
    def test_study_and_ladder(self):
        deck = self.deck(plate("$CHECK\n  U.X.MAX(BODY,LOAD) = 1 ABS 10 SOURCE 'a guess'\n"))
        for command in ("study", "ladder"):
            call = (command, deck, "--out", f"shared.{command}", "--quiet")
            missing = self.expect(6, *call, "--collect")
            self.assertIn("E553", missing.stderr)
            self.expect(0, *call, "--array", "2/2")
            self.assertFalse((self.folder / f"shared.{command}").exists())
            self.expect(0, *call, "--array", "1/2")
            self.expect(0, *call, "--collect")
            self.expect(0, command, deck, "--out", f"whole.{command}", "--quiet", PATH=str(self.folder))  # without CalculiX
            tables = [answers(self.folder / f"{n}.{command}" / f"{command}.csv") for n in ("whole", "shared")]
            self.assertEqual(*tables)
            self.assertGreater(len(tables[0]), 1)


if __name__ == "__main__":
    main()
