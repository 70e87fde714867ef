# SPDX-License-Identifier: GPL-3.0-or-later
"""What solves the equations: the same answers by each engine, the next one where memory is short, and a word where one
cannot be had."""

import csv
import os
import re
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from program import PROGRAM, SANITIZED, TOP, ProgramTest, environment, main

MODULES = Path(PROGRAM).parents[1] / "libexec/spricka"
HAS_MUMPS = (MODULES / "spricka-mumps.so").exists()
HAS_MULTIGRID = (MODULES / "spricka-multigrid.so").exists()

# A solid block on its foot, whose factor is large beside everything else.
BLOCK = """$DECK VERSION=1 LENGTH=MM FORCE=N TITLE='Block'
$MESH SHAPE=BLOCK TYPE=HEXEC20 LX=10 LY=10 LZ=10 NX={n} NY={n} NZ={n}
$MATERIAL NAME=STEEL E=210[GPa] NU=0.3
$PROPERTY ESET=BODY MATERIAL=STEEL STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  ZMIN
$LOAD CASE=PULL TYPE=TRACTION
  ZMAX  0  0  100
$STEP NAME=LOAD
  LOAD PULL 1
$END
"""

CRACK = "$CRACK NAME=C1 A=3 C=3 X0=0 Y0=0 Z0=5 NORMAL=Z\n"
CRACKED_BLOCK = BLOCK.format(n=3).replace("HEXEC20", "TET10").replace("$LOAD", CRACK + "$LOAD")

FULL = bool(os.environ.get("SPRICKA_FULL"))


def numbers(file):
    """The numbers of a table by column, and its other words."""
    columns, words = {}, []
    with open(file, encoding="utf-8", newline="") as stream:
        for row in csv.DictReader(line for line in stream if not line.startswith("#")):
            for name, text in row.items():
                try:
                    columns.setdefault(name, []).append(float(text))
                except (TypeError, ValueError):
                    words.append(text)
    return columns, words


class Engines(ProgramTest):
    def limited(self, mebibytes, *arguments, **env):
        return subprocess.run(
            ["bash", "-c", f'ulimit -v {mebibytes * 1024}; exec "$0" "$@"', PROGRAM, *map(str, arguments)],
            cwd=self.folder, env=environment(OPENBLAS_NUM_THREADS="1", **env), capture_output=True, text=True,
            timeout=300, check=False,
        )

    def copied_program(self, module=None):
        """The program with no engine beside it but that which is given."""
        (self.folder / "bin").mkdir()
        (self.folder / "libexec/spricka").mkdir(parents=True)
        copy = self.folder / "bin/spricka"
        shutil.copy(PROGRAM, copy)
        if module is not None:
            shutil.copy(module, self.folder / "libexec/spricka/spricka-mumps.so")
        return copy

    def run_copy(self, copy, *arguments):
        return subprocess.run([copy, *arguments], cwd=self.folder, env=environment(), capture_output=True, text=True,
                              timeout=120, check=False)

    def test_an_engine_that_is_not_there_is_named(self):
        self.deck(BLOCK.format(n=2))
        copy = self.copied_program()
        for method in ([], ["--forecast"]):
            checked = self.run_copy(copy, "check", "test.deck", "--engine", "mumps", *method)
            self.assertIn("this spricka was built without MUMPS", checked.stdout)
        result = self.run_copy(copy, "run", "test.deck", "--engine", "mumps", "--quiet")
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("this spricka was built without MUMPS", result.stderr)
        self.assertIn("libmumps-seq-dev", result.stderr)
        self.assertFalse((self.folder / "test.run/k.csv").exists())

    def test_a_module_of_other_sources_is_refused(self):
        self.deck(BLOCK.format(n=2))
        source = self.folder / "other.c"
        source.write_text('const char *spricka_engine_abi(void) { return "0.0.1 0123456789abcdef"; }\n', encoding="utf-8")
        subprocess.run(["gcc", "-shared", "-fPIC", "-o", self.folder / "other.so", source], check=True)
        copy = self.copied_program(self.folder / "other.so")
        result = self.run_copy(copy, "run", "test.deck", "--engine", "mumps", "--quiet")
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("is of another spricka (0.0.1 0123456789abcdef", result.stderr)

    def test_a_word_that_is_no_engine(self):
        self.deck(BLOCK.format(n=2))
        result = self.expect(2, "run", "test.deck", "--engine", "mump")
        self.assertIn("mumps", result.stderr)

    def compared(self, deck, other="mumps", defines=()):
        """One deck by Cholesky and by MUMPS: the largest difference of K and G, as part of the largest of the column."""
        for engine in ("cholesky", other):
            self.expect(0, "run", deck, "--engine", engine, "--out", engine, "--quiet", "--threads", "2", *defines)
        listing = (self.folder / other / "listing.txt").read_text(encoding="utf-8")
        self.assertRegex(listing, rf"CONDENSE .*: .*{other}" if other == "multigrid" else r"CONDENSE .*: MUMPS")
        worst = 0.0
        ours, words = numbers(self.folder / other / "k.csv")
        theirs, other_words = numbers(self.folder / "cholesky/k.csv")
        self.assertEqual(words, other_words)
        self.assertEqual(ours.keys(), theirs.keys())
        for column in ("K1", "K2", "K3", "G"):
            values = theirs.get(column, [])
            size = max(map(abs, values), default=0.0)
            self.assertEqual(len(values), len(ours.get(column, [])), column)
            for a, b in zip(ours.get(column, []), values):
                worst = max(worst, abs(a - b) / size if size else abs(a))
        return worst

    @unittest.skipUnless(HAS_MUMPS, "built without MUMPS")
    def test_a_press_fit_without_loads(self):
        # Its decks check the pressure.
        self.expect(0, "run", TOP / "decks/press_fit_solid.deck", "--engine", "mumps", "--out", "out", "--quiet")

    @unittest.skipUnless(HAS_MUMPS, "built without MUMPS")
    def test_the_same_K_of_a_crack_in_a_solid_with_contact(self):
        coarser = () if FULL else ("-D", "fine=0.5")
        self.assertLess(self.compared(TOP / "decks/lug_slice_crack_solid.deck", defines=coarser), 1e-10)

    @unittest.skipUnless(HAS_MULTIGRID, "built without PETSc")
    def test_the_same_K_by_iterations(self):
        deck = TOP / "decks/penny_solid.deck" if FULL else self.deck(CRACKED_BLOCK)
        self.assertLess(self.compared(deck, "multigrid"), 1e-6)

    @unittest.skipUnless(HAS_MULTIGRID, "built without PETSc")
    def test_every_command_that_runs_decks_takes_an_engine(self):
        # In the plane multigrid has nothing to say, so whoever was given it says so.
        deck = TOP / "decks/edge_crack.deck"
        for words in (("study", deck, "--vary", "a=1"), ("ladder", deck), ("shell", deck)):
            with self.subTest(words[0]):
                result = subprocess.run([PROGRAM, *words, "--engine", "multigrid"], cwd=self.folder, env=environment(),
                                        input="list K\n", capture_output=True, text=True, timeout=120, check=False)
                self.assertIn("multigrid solves bodies in space only", result.stdout + result.stderr)

    @unittest.skipUnless(HAS_MULTIGRID, "built without PETSc")
    def test_multigrid_is_for_bodies_in_space(self):
        result = self.run_copy(PROGRAM, "run", TOP / "decks/kirsch.deck", "--engine", "multigrid", "--quiet")
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("multigrid solves bodies in space only", result.stderr)

    @unittest.skipUnless(HAS_MULTIGRID and "SPRICKA_FULL" in os.environ, "built without PETSc, or SPRICKA_FULL not set")
    def test_iterations_where_they_take_less(self):
        deck = self.deck(BLOCK.format(n=20))
        checked = self.expect(0, "check", deck, "--forecast")
        self.assertIn("multigrid", checked.stdout)
        self.expect(0, "run", deck, "--out", "chosen", "--quiet")
        listing = (self.folder / "chosen/listing.txt").read_text(encoding="utf-8")
        self.assertRegex(listing, r"CONDENSE .*multigrid, error at most 1e-08.*takes less time than a factor")

    @unittest.skipUnless(HAS_MULTIGRID and "SPRICKA_FULL" in os.environ, "built without PETSc, or SPRICKA_FULL not set")
    def test_a_net_that_iterations_give_up(self):
        # Elements a thousand times as wide as they are thick, nearly incompressible.
        deck = self.deck(BLOCK.format(n=20).replace("LZ=10", "LZ=0.01").replace("NU=0.3", "NU=0.499"))
        result = self.expect(0, "run", deck, "--out", "handed_on", "--quiet")
        self.assertRegex(result.stderr, r"W510.*MODEL was solved by Cholesky: .*more than 1000 iterations")
        listing = (self.folder / "handed_on/listing.txt").read_text(encoding="utf-8")
        self.assertRegex(listing, r"CONDENSE .*MODEL: Cholesky: .*more than 1000 iterations")
        stored = (self.folder / "handed_on/results.h5").read_bytes()
        self.assertIn(b"MODEL was solved by Cholesky", stored)

    def test_the_deck_names_an_engine_and_the_command_line_overrules_it(self):
        deck = self.deck(BLOCK.format(n=2).replace("$STEP", "$CONTROL ENGINE=CHOLESKY\n$STEP"))
        for words, said in (((), "cholesky for all nets, as $CONTROL asks"), (("--engine", "cholesky"), "cholesky for all nets, as --engine asks"),
                            (("--engine", "auto"), None)):
            self.expect(0, "run", deck, "--out", "out", "--quiet", *words)
            listing = (self.folder / "out/listing.txt").read_text(encoding="utf-8")
            if said:
                self.assertIn(said, listing)
            else:
                self.assertNotIn("for all nets", listing)

    @unittest.skipUnless(HAS_MUMPS, "built without MUMPS")
    @unittest.skipUnless(FULL, "SPRICKA_FULL is not set")
    def test_the_same_growth_with_a_part_that_is_kept(self):
        self.assertLess(self.compared(TOP / "decks/lug_single.deck"), 1e-10)

    @unittest.skipUnless(HAS_MUMPS and not SANITIZED, "built without MUMPS, or with a shadow beyond any limit")
    def test_the_next_engine_where_memory_is_short(self):
        deck = self.deck(BLOCK.format(n=14))
        # So little that a factor in core does not fit, as a user would meet it: no option is given.
        mebibytes = 520
        refused = self.limited(mebibytes, "run", deck, "--out", "refused", "--quiet", "--engine", "cholesky")
        self.assertEqual(refused.returncode, 4, refused.stderr)
        self.assertRegex(refused.stderr, "E466|E510.*memory")
        checked = self.limited(mebibytes, "check", deck, "--forecast")
        self.assertIn("MUMPS out of core", checked.stdout)
        result = self.limited(mebibytes, "run", deck, "--out", "limited", "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        listing = (self.folder / "limited/listing.txt").read_text(encoding="utf-8")
        self.assertRegex(listing, r"CONDENSE .*: MUMPS out of core: in core would need .* can be had")

    @unittest.skipUnless(HAS_MUMPS and not SANITIZED, "built without MUMPS, or with a shadow beyond any limit")
    def test_a_disk_without_room(self):
        deck = self.deck(BLOCK.format(n=14))
        for folder, word in ((str(self.folder / "missing"), "no folder for temporary files"),):
            result = self.limited(520, "run", deck, "--quiet", "--engine", "mumps", TMPDIR=folder)
            self.assertEqual(result.returncode, 4, result.stderr)
            self.assertIn(word, result.stderr)
        small = self.folder / "small"
        small.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4m", "none", small], capture_output=True, check=False)
        if mounted.returncode != 0:
            return  # not root
        try:
            result = self.limited(520, "run", deck, "--quiet", "--engine", "mumps", TMPDIR=str(small))
            self.assertEqual(result.returncode, 4, result.stderr)
            self.assertIn("of disk in", result.stderr)
            self.assertEqual(list(small.iterdir()), [])
        finally:
            subprocess.run(["umount", small], check=False)

    @unittest.skipUnless(HAS_MUMPS and not SANITIZED, "built without MUMPS, or with a shadow beyond any limit")
    def test_nothing_is_left_behind_by_a_signal(self):
        deck = self.deck(BLOCK.format(n=14))
        scratch = self.folder / "scratch"
        scratch.mkdir()
        limit = f'ulimit -v {520 * 1024}; exec "$0" "$@"'
        child = subprocess.Popen(
            ["bash", "-c", limit, PROGRAM, "run", deck, "--quiet"], cwd=self.folder,
            env=environment(OPENBLAS_NUM_THREADS="1", TMPDIR=str(scratch)), stderr=subprocess.DEVNULL,
        )
        for _ in range(3000):
            if child.poll() is not None or any(scratch.glob("spricka-scratch-*/factor*")):
                break
            time.sleep(0.01)
        child.send_signal(signal.SIGTERM)
        self.assertEqual(child.wait(timeout=60), 128 + signal.SIGTERM)
        self.assertEqual(list(scratch.iterdir()), [])


if __name__ == "__main__":
    main()
