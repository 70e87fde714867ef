# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run may replace: its own files, and nothing else, whatever becomes of the run."""

import fcntl
import os
import signal
import socket
import subprocess
import time

from program import CRACKED, PROGRAM, ProgramTest, content_without_cost, environment, main, plate

LOOSE = plate().replace("$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMIN\n", "")
# Some seconds of work, so that a signal or a second run meets it.
LONG = CRACKED.replace("  1  1.5  2\n", "  " + " ".join(f"{1 + 0.02 * i:g}" for i in range(60)) + "\n")
LONG = LONG.replace("NX=4 NY=2", "NX=40 NY=20")


def contents(folder):
    """Every file below a folder but for the listing, which tells times."""
    return {
        str(f.relative_to(folder)): content_without_cost(f)
        for f in sorted(folder.rglob("*"))
        if f.is_file() and f.name != "listing.txt"
    }


class Folders(ProgramTest):
    def setUp(self):
        super().setUp()
        self.deck(plate())
        self.out = self.folder / "out"

    def run_out(self, code, deck="test.deck"):
        return self.expect(code, "run", deck, "--out", "out", "--quiet")

    def start(self, deck, *more):
        return subprocess.Popen(
            [PROGRAM, "run", str(deck), "--out", "out", "--quiet", *more],
            cwd=self.folder,
            env=environment(),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def wait_for(self, path):
        for _ in range(1200):
            if path.exists():
                return
            time.sleep(0.05)
        self.fail(f"{path} never came")

    def nothing_else(self, *names):
        """In the folder there are these only, and nothing half."""
        found = sorted(f.name for f in self.folder.iterdir())
        self.assertEqual(found, sorted(["test.deck", *names]))

    def test_foreign_folders_stay(self):
        for name, text in (
            ("listing.txt", "mine"),
            ("sweep.csv", "mine"),
            (".spricka", "mine"),
            (".spricka", "spricka"),
            ("thesis.txt", "years of work"),
        ):
            folder = self.folder / "old"
            (folder / "deep").mkdir(parents=True)
            (folder / name).write_text(text, encoding="utf-8")
            (folder / "deep" / "x").write_text("y", encoding="utf-8")
            before = contents(folder)
            for deck in (plate(), plate("$PARAMETER\n  s = 1\n$SWEEP PARAMETER=s\n  1 2\n")):
                self.deck(deck)
                result = self.expect(7, "run", "test.deck", "--out", "old")
                self.assertIn("error E464", result.stderr)
                self.assertIn("--out", result.stderr)
                self.assertTrue(contents(folder) == before, "it is not as it was")
            for f in sorted(folder.rglob("*"), reverse=True):
                f.rmdir() if f.is_dir() else f.unlink()
            folder.rmdir()
        self.nothing_else()

    def test_a_foreign_folder_beside_stays(self):
        (self.folder / "out.part").mkdir()
        (self.folder / "out.part" / "thesis.txt").write_text("years", encoding="utf-8")
        self.assertIn("thesis.txt", self.run_out(7).stderr)
        self.assertEqual((self.folder / "out.part" / "thesis.txt").read_text("utf-8"), "years")
        self.assertFalse(self.out.exists())

    def test_a_file_stays(self):
        self.out.write_text("mine", encoding="utf-8")
        self.assertIn("error E464", self.run_out(7).stderr)
        self.assertEqual(self.out.read_text("utf-8"), "mine")

    def test_an_empty_folder_is_taken(self):
        self.out.mkdir(mode=0o750)
        self.run_out(0)
        self.assertEqual(self.out.stat().st_mode & 0o777, 0o750)
        self.nothing_else("out")

    def test_a_link_and_a_slash(self):
        (self.folder / "real").mkdir()
        self.out.symlink_to("real")
        self.expect(0, "run", "test.deck", "--out", "out/", "--quiet")
        self.assertTrue(self.out.is_symlink())
        self.assertTrue((self.folder / "real" / "k.csv").exists())
        self.nothing_else("out", "real")

    def test_a_mark_that_was_made_by_hand_reaches_no_other_file(self):
        self.run_out(0)
        (self.folder / "victim").write_text("precious", encoding="utf-8")
        (self.out / "kept").mkdir()
        (self.out / "kept" / "x").write_text("precious", encoding="utf-8")
        with open(self.out / ".spricka", "a", encoding="utf-8") as mark:
            mark.write(f"../victim\n{self.folder}/victim\nkept\nkept/x\n..\n.\n\n")
        self.run_out(0)
        self.assertEqual((self.folder / "victim").read_text("utf-8"), "precious")
        self.assertEqual((self.out / "kept" / "x").read_text("utf-8"), "precious")

    def test_foreign_files_in_a_run_folder_go_on(self):
        self.run_out(0)
        (self.out / "notes.txt").write_text("mine", encoding="utf-8")
        (self.out / "view").mkdir()
        (self.out / "view" / "state.pvsm").write_text("mine", encoding="utf-8")
        (self.out / "u.csv").write_text("mine", encoding="utf-8")
        self.deck(plate("$OUTPUT FILE='u.csv' FORMAT=CSV\n  U XMAX\n"))
        self.run_out(0)
        self.assertEqual((self.out / "notes.txt").read_text("utf-8"), "mine")
        self.assertEqual((self.out / "view" / "state.pvsm").read_text("utf-8"), "mine")
        self.assertIn(",U,XMAX", (self.out / "u.csv").read_text("utf-8"))
        self.assertEqual((self.out / "u.csv.kept").read_text("utf-8"), "mine")
        self.deck(plate())
        self.run_out(0)  # what a run wrote goes, what it did not stays
        self.assertFalse((self.out / "u.csv").exists())
        self.assertTrue((self.out / "u.csv.kept").exists())
        self.nothing_else("out")

    def test_a_run_without_results_keeps_the_last_ones(self):
        self.run_out(0)
        before = contents(self.out)
        for code, text in ((4, LOOSE), (3, plate("$FOO\n"))):
            result = self.run_out(code, self.deck(text, "bad.deck"))
            self.assertTrue(contents(self.out) == before, "it is not as it was")
            if code == 4:
                self.assertIn("still holds the results of an earlier run", result.stderr)
        (self.folder / "bad.deck").unlink()
        self.nothing_else("out")

    def test_results_that_cannot_be_written_keep_the_last_ones(self):
        self.run_out(0)
        before = contents(self.out)
        result = subprocess.run(
            f"ulimit -f 8; exec {PROGRAM} run test.deck --out out --quiet",
            shell=True,
            cwd=self.folder,
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(result.returncode, 7, result.stderr)
        self.assertIn("File too large", result.stderr)
        self.assertTrue(contents(self.out) == before, "it is not as it was")
        self.nothing_else("out")

    def test_killed_runs_keep_the_last_results(self):
        self.run_out(0)
        before = contents(self.out)
        deck = self.deck(LONG, "long.deck")
        for sign, code in (
            (signal.SIGTERM, 143),
            (signal.SIGINT, 130),
            (signal.SIGHUP, 129),
            (signal.SIGXCPU, 128 + signal.SIGXCPU),
        ):
            child = self.start(deck)
            self.wait_for(self.folder / "out.part" / ".spricka.owner")
            child.send_signal(sign)
            _, errors = child.communicate(timeout=60)
            self.assertEqual(child.returncode, code, errors)
            self.assertTrue(contents(self.out) == before, "it is not as it was")
            self.assertFalse((self.folder / "out.part").exists(), sign)
        child = self.start(deck)
        self.wait_for(self.folder / "out.part" / ".spricka.owner")
        child.kill()
        child.communicate()
        self.assertTrue(contents(self.out) == before, "it is not as it was")
        deck.unlink()
        self.run_out(0)  # and what the killed one left is removed
        self.nothing_else("out")

    def test_a_second_run_is_refused(self):
        deck = self.deck(LONG, "long.deck")
        child = self.start(deck)
        try:
            self.wait_for(self.folder / "out.part" / ".spricka.owner")
            result = self.run_out(7)
            self.assertIn("error E465", result.stderr)
            self.assertIn(f"process {child.pid} on {socket.gethostname()}", result.stderr)
        finally:
            child.terminate()
            child.communicate()
        self.run_out(0)

    def test_a_second_sweep_is_refused(self):
        text = plate("$SWEEP PARAMETER=s\n  100 110\n").replace("$MESH", "$PARAMETER\n  s = 1\n$MESH")
        self.deck(text)
        self.run_out(0)
        held = os.open(self.out, os.O_RDONLY)
        fcntl.flock(held, fcntl.LOCK_EX)
        self.assertIn("error E465", self.run_out(7).stderr)
        os.close(held)
        self.run_out(0)
        self.nothing_else("out")

    def test_races(self):
        """Of two runs into one folder each is done or refused, and the folder is of one of them."""
        self.deck(plate().replace("NX=4", "NX=8"), "wide.deck")
        sizes = {}
        for name in ("test.deck", "wide.deck"):
            self.run_out(0, name)
            sizes[name] = contents(self.out)
        for attempt in range(24 if os.environ.get("SPRICKA_FULL") else 6):
            children = [self.start("test.deck")]
            time.sleep(0.02 * attempt)
            children.append(self.start("wide.deck"))
            codes = [(c.communicate(timeout=120), c.returncode)[1] for c in children]
            self.assertTrue(set(codes) <= {0, 7}, codes)
            self.assertIn(0, codes)
            self.assertTrue(contents(self.out) in sizes.values(), "a mixture")
            self.assertFalse((self.folder / "out.part").exists())

    def test_a_sweep_keeps_what_is_not_its_own(self):
        text = plate("$SWEEP PARAMETER=s\n  100 110\n").replace("$MESH", "$PARAMETER\n  s = 1\n$MESH")
        self.deck(text)
        self.run_out(0)
        (self.out / "003").mkdir()
        (self.out / "003" / "listing.txt").write_text("mine", encoding="utf-8")
        (self.out / "009.part").mkdir()
        (self.out / "009.part" / "mine").write_text("mine", encoding="utf-8")
        (self.out / "002" / "notes").write_text("mine", encoding="utf-8")
        self.deck(text.replace("  100 110\n", "  100\n"))
        self.run_out(0)
        for name in ("003/listing.txt", "009.part/mine", "002/notes"):
            self.assertEqual((self.out / name).read_text("utf-8"), "mine")
        self.assertFalse((self.out / "002" / "k.csv").exists())

    def test_a_state_in_the_run_folder_is_refused(self):
        for path in ("out/state.rst", "./out/../out/deep/state.rst", "out"):
            self.deck(plate(f"$RESTART WRITE='{path}'\n"))
            self.assertIn("error E469", self.run_out(7).stderr)
            self.assertFalse(self.out.exists())

    def test_convert_leaves_what_it_reads(self):
        self.expect(0, "convert", "test.deck", "a.msh")
        before = (self.folder / "a.msh").read_bytes()
        self.assertIn("error E464", self.expect(7, "convert", "a.msh", "./a.msh").stderr)
        self.assertEqual((self.folder / "a.msh").read_bytes(), before)

    def test_temporary_names_of_others_stay(self):
        """A file a.msh.part beside a.msh is somebody's."""
        (self.folder / "a.msh.part").write_text("mine", encoding="utf-8")
        self.expect(0, "convert", "test.deck", "a.msh")
        self.assertEqual((self.folder / "a.msh.part").read_text("utf-8"), "mine")
        (self.folder / "test.deck.part").write_text("mine", encoding="utf-8")
        self.deck(plate().replace("$STEP", "$step"))
        self.expect(0, "format", "--in-place", "test.deck")
        self.assertEqual((self.folder / "test.deck.part").read_text("utf-8"), "mine")
        self.nothing_else("a.msh", "a.msh.part", "test.deck.part")

    def test_the_shell_overwrites_when_told(self):
        victim = self.folder / "victim"
        for command in ("save victim", "plot pressure victim", "plot mesh victim", "save ./test.deck"):
            victim.write_text("precious", encoding="utf-8")
            result = self.expect(0, "shell", "test.deck", stdin=command + "\n")
            self.assertIn("error", result.stderr + result.stdout)
            self.assertEqual(victim.read_text("utf-8"), "precious")
        result = self.expect(0, "shell", "test.deck", stdin="save victim\nsave victim replace\n")
        self.assertIn("write replace behind it", result.stderr + result.stdout)
        self.assertIn("$DECK", victim.read_text("utf-8"))


if __name__ == "__main__":
    main()
