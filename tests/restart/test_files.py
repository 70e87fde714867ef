# SPDX-License-Identifier: GPL-3.0-or-later
"""Restart files that are cut off, changed, foreign, of another version, or have no room."""

import resource
import shutil
import signal

from run_folders import CRACKED, RestartTest, keeping, main

READ = "$RESTART READ='state.rst'\n"


class Files(RestartTest):
    def setUp(self):
        super().setUp()
        self.expect(0, "run", self.deck(keeping()), "--out", "whole.run", "--quiet")
        self.reader = self.deck(keeping(CRACKED, READ), "reader.deck")
        self.state = self.folder / "state.rst"
        self.before = self.folder / "state.rst.1"

    def read(self, code):
        return self.expect(code, "run", self.reader, "--out", "read.run", "--quiet")

    def test_reading_all_of_it(self):
        result = self.read(0)
        self.assertEqual(result.stderr, "")
        # the decks differ in their texts, which results.h5 holds
        for name in ("k.csv", "sensitivity.csv", "results_003_LOAD.vtu"):
            self.assertEqual(
                (self.folder / "whole.run" / name).read_bytes(),
                (self.folder / "read.run" / name).read_bytes(),
            )
        listing = (self.folder / "read.run" / "listing.txt").read_text(encoding="utf-8")
        self.assertIn("3 of 3 increments taken over from", listing)

    def test_the_first_line_says_what_it_is(self):
        self.assertRegex(
            self.state.read_bytes()[:512].decode("ascii"),
            r"^spricka state 2 of 0\.1\.0 , [0-9]+ bytes [0-9a-f]{32} +\n$",
        )

    def test_cut_off_anywhere(self):
        whole = self.state.read_bytes()
        sizes = sorted({0, 1, 100, 511, 512, 513, len(whole) - 1, *range(700, len(whole), 7919)})
        self.before.unlink()
        for size in sizes:
            self.state.write_bytes(whole[:size])
            self.assertIn("error E560", self.read(7).stderr, size)
        self.state.write_bytes(whole)
        self.read(0)

    def test_cut_off_the_one_before_is_taken(self):
        self.state.write_bytes(self.state.read_bytes()[:1000])
        result = self.read(0)
        self.assertIn("warning W560", result.stderr)
        self.assertIn("state.rst.1", result.stderr)
        self.assertEqual(
            (self.folder / "whole.run" / "k.csv").read_bytes(),
            (self.folder / "read.run" / "k.csv").read_bytes(),
        )

    def test_the_newest_is_gone(self):
        self.state.unlink()
        self.assertIn("warning W560", self.read(0).stderr)

    def test_an_increment_is_damaged(self):
        first, _, last = self.increments()
        folder = self.folder / "state.rst.d"
        data = bytearray((folder / last).read_bytes())
        data[len(data) // 2] ^= 1
        (folder / last).write_bytes(data)
        self.assertIn("warning W560", self.read(0).stderr)  # the list before does not need it
        (folder / first).write_bytes((folder / first).read_bytes()[:-1])
        result = self.read(7)
        self.assertIn("error E560", result.stderr)
        self.assertIn(first, result.stderr)
        self.assertFalse((self.folder / "read.run.part").exists())

    def test_every_bit_counts(self):
        whole = self.state.read_bytes()
        self.before.unlink()
        for at in (0, 9, 14, 40, 600, len(whole) // 2, len(whole) - 1):
            data = bytearray(whole)
            data[at] ^= 1
            self.state.write_bytes(data)
            self.read(7)

    def test_foreign(self):
        self.before.unlink()
        for content in (b"PK\x03\x04" * 500, b"$DECK VERSION=1\n" * 100, bytes(4096)):
            self.state.write_bytes(content)
            self.assertIn("error E564", self.read(7).stderr)
            # nor is it overwritten
            result = self.expect(7, "run", "test.deck", "--quiet")
            self.assertIn("is not overwritten", result.stderr)
            self.assertEqual(self.state.read_bytes(), content)
        self.state.unlink()
        self.assertIn("error E560", self.read(7).stderr)

    def test_results_are_no_state(self):
        self.before.unlink()
        shutil.copy(self.folder / "whole.run" / "results.h5", self.state)
        self.assertIn("error E564", self.read(7).stderr)

    def test_another_version(self):
        self.before.unlink()
        whole = self.state.read_bytes()
        for old, new in (
            (b"state 2 of", b"state 1 of"),
            (b"state 2 of", b"state 3 of"),
            (b"of 0.1.0 ", b"of 0.0.9 "),
        ):
            self.state.write_bytes(whole.replace(old, new, 1))
            result = self.read(7)
            self.assertIn("error E565", result.stderr)
            self.assertIn("this is 0.1.0 with format 2", result.stderr)

    def test_no_room(self):
        """A limit on the size of files stands for a disk that is full."""
        sizes = [(self.folder / "state.rst.d" / f).stat().st_size for f in self.increments()]
        kept = {f.name: f.read_bytes() for f in self.folder.glob("state.rst*") if f.is_file()}
        for limit in (0, 1000, min(sizes) - 1):

            def no_room(limit=limit):
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

            child = self.start("run", "test.deck", "--quiet", preexec_fn=no_room)
            _, errors = child.communicate(timeout=60)
            self.assertEqual(child.returncode, 7, errors)
            # with no room at all it is the run folder that is missed first
            self.assertIn("error E563" if limit > 0 else "error E530", errors)
            self.assertFalse((self.folder / "test.run").exists())
            for name, data in kept.items():
                self.assertEqual((self.folder / name).read_bytes(), data)
            self.read(0)
            parts = list(self.folder.rglob("*.part"))
            self.assertEqual(parts, [])

    def test_no_room_for_the_results(self):
        largest = (self.folder / "whole.run" / "results.h5").stat().st_size

        def no_room():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (largest - 1000, largest - 1000))

        self.deck(CRACKED, "plain.deck")
        child = self.start("run", "plain.deck", "--quiet", preexec_fn=no_room)
        _, errors = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 7, errors)
        self.assertIn("results.h5", errors)
        self.assertFalse((self.folder / "plain.run").exists())

    def test_a_folder_that_cannot_be_written(self):
        text = keeping(CRACKED, "$RESTART WRITE='none/deep/state.rst'\n")
        (self.folder / "none").write_text("a file where a folder should be", encoding="utf-8")
        self.assertIn("error E563", self.expect(7, "run", self.deck(text)).stderr)

    def test_nothing_is_left_over(self):
        self.expect(0, "run", "test.deck", "--quiet")
        self.assertEqual(len(self.increments()), 3)
        self.assertEqual(
            sorted(f.name for f in self.folder.glob("state.rst*")),
            ["state.rst", "state.rst.1", "state.rst.d"],
        )


if __name__ == "__main__":
    main()
