# SPDX-License-Identifier: GPL-3.0-or-later
"""Input that never ends, and the limits of the machine: each is named, none is waited for."""

import os
import resource
import subprocess
import time
import unittest

from program import PROGRAM, SANITIZED, ProgramTest, environment, main, plate

SPECTRUM = """$STEP NAME=ZERO
  LOAD PULL 0
$LOADPATH NAME=P FROM=ZERO TO=LOAD
$SPECTRUM NAME=A PATH=P TYPE=SEQUENCE FILE='{}'
"""


class Limits(ProgramTest):
    def setUp(self):
        super().setUp()
        self.deck(plate())

    def soon(self, code, *arguments, seconds=20, **more):
        """The program ends in that time by itself."""
        result = subprocess.run(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            env=environment(),
            capture_output=True,
            text=True,
            timeout=seconds,
            check=False,
            **more,
        )
        self.assertEqual(result.returncode, code, result.stdout[-500:] + result.stderr[-500:])
        return result.stderr

    def shell(self, code, line):
        result = subprocess.run(
            line.replace("PROGRAM", PROGRAM),
            shell=True,
            executable="/bin/bash",
            cwd=self.folder,
            env=environment(OPENBLAS_NUM_THREADS="1"),
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )
        self.assertEqual(result.returncode, code, result.stderr[-800:])
        return result.stderr

    def strange_files(self):
        os.mkfifo(self.folder / "pipe")
        (self.folder / "folder").mkdir()
        with open(self.folder / "huge", "wb") as file:
            file.truncate(1 << 40)
        return (("pipe", "a pipe"), ("/dev/zero", "a device"), ("folder", "a folder"), ("huge", "too large"))

    def test_what_is_no_file_is_not_read(self):
        for name, word in self.strange_files():
            for text in (plate(f"$INCLUDE FILE='{name}'\n"), plate(SPECTRUM.format(name))):
                self.assertIn(word, self.soon(3, "check", self.deck(text)))
            inp = plate().replace(
                "$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=4 NY=2", f"$IMPORT FILE='{name}' FORMAT=INP"
            )
            self.assertIn("E3", self.soon(3, "check", self.deck(inp)))
            for command in ("check", "run", "format"):
                self.assertIn(word, self.soon(7, command, name))
            reading = plate(f"$RESTART READ='{name}'\n")
            self.assertIn("E56", self.soon(7, "run", self.deck(reading)))

    def test_includes_that_branch(self):
        for i in range(15):
            (self.folder / f"y{i}.inc").write_text(f"$INCLUDE FILE='y{i + 1}.inc'\n" * 10, encoding="utf-8")
        (self.folder / "y15.inc").write_text("! nothing\n", encoding="utf-8")
        errors = self.soon(3, "check", self.deck(plate("$INCLUDE FILE='y0.inc'\n")))
        self.assertIn("more than 1000 files are included", errors)
        for i in range(15):
            (self.folder / f"y{i}.inp").write_text(f"*INCLUDE, INPUT=y{i + 1}.inp\n" * 10, encoding="utf-8")
        (self.folder / "y15.inp").write_text("** nothing\n", encoding="utf-8")
        inp = plate().replace(
            "$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=4 NY=2", "$IMPORT FILE='y1.inp' FORMAT=INP"
        )
        self.assertIn("more than 1000 files", self.soon(3, "check", self.deck(inp)))

    def test_standard_input_without_an_end(self):
        with open("/dev/zero", "rb") as zero:
            self.assertIn("line without an end", self.soon(7, "shell", "test.deck", stdin=zero))

    def test_many_mistakes_take_linear_time(self):
        kinds = {
            "card": "$FOO\n",
            "key": "$CONTROL FOO=1\n",
            "set": "$FREEDOM CLASS=SUPPRESSED DOF=X\n  NOWHERE\n",
            "parameter": "$MATERIAL NAME=M{} E=(nothing) NU=0.3\n",
            "long line": None,
        }
        for kind, card in kinds.items():
            times = []
            for count in (2000, 8000):
                if card is None:
                    more = "$NSET NAME=A\n  " + "@ " * count + "\n"
                else:
                    more = "".join(card.format(i) for i in range(count))
                self.deck(plate(more))
                begin = time.monotonic()
                for log in ("json", "text"):
                    self.soon(3, "check", "test.deck", "--log-format", log, seconds=60)
                times.append(time.monotonic() - begin)
            self.assertLess(times[1], 8 * times[0] + 1.0, (kind, times))

    def test_a_full_disk_is_no_success(self):
        for arguments in (
            "format test.deck",
            "run test.deck",
            "check test.deck",
            "check test.deck --json",
            "help",
            "help contact",
            "--help",
            "--version",
            "schema",
            "man",
            "completion bash",
            "editor vim",
        ):
            errors = self.shell(7, f"PROGRAM {arguments} > /dev/full")
            self.assertIn("E468", errors)
        self.shell(7, "PROGRAM shell test.deck > /dev/full <<< 'list'")
        self.assertTrue((self.folder / "test.run" / "k.csv").exists())
        # what matters more than the full disk stays the exit code
        self.deck(plate("$FOO\n"))
        self.shell(3, "PROGRAM check test.deck > /dev/full")

    def test_messages_that_cannot_be_written(self):
        self.deck(plate("$FOO\n"))
        self.shell(3, "PROGRAM check test.deck 2> /dev/full")
        self.shell(3, "PROGRAM check test.deck --log-format json 2> /dev/full")
        self.shell(2, "PROGRAM nonsense 2> /dev/full")
        self.shell(3, "PROGRAM check test.deck >&- 2>&-")

    def test_closed_streams_do_not_get_the_results(self):
        self.shell(7, "PROGRAM run test.deck >&-")
        self.shell(0, "PROGRAM run test.deck --quiet >&- <&-")
        text = (self.folder / "test.run" / "listing.txt").read_text(encoding="utf-8")
        self.assertNotIn("results in test.run", text)

    def test_a_limit_on_the_size_of_files(self):
        errors = self.shell(7, "ulimit -f 8; PROGRAM run test.deck --quiet")
        self.assertIn("File too large", errors)
        self.assertFalse((self.folder / "test.run").exists())
        self.assertEqual(sorted(f.name for f in self.folder.iterdir()), ["test.deck"])

    @unittest.skipIf(SANITIZED, "under the sanitizer: its shadow is larger than any limit")
    def test_too_little_memory(self):
        """From nothing at all to enough: never a hang, never a crash, and the amount is named."""
        big = plate().replace("NX=4 NY=2", "NX=150 NY=75")
        self.deck(big)
        codes = []
        for mebibytes in (420, 480, 560, 700, 4000):
            result = subprocess.run(
                ["bash", "-c", f"ulimit -v {mebibytes * 1024}; exec {PROGRAM} run test.deck --threads 2"],
                cwd=self.folder,
                env=environment(OPENBLAS_NUM_THREADS="1"),
                capture_output=True,
                text=True,
                timeout=120,
                check=False,
            )
            codes.append(result.returncode)
            if result.returncode == 4:
                self.assertRegex(result.stderr, "E466.*MiB|E510.*memory")
        self.assertTrue(set(codes) <= {0, 4}, codes)
        self.assertEqual(codes[-1], 0)

    def test_limit_of_open_files(self):
        def few():
            resource.setrlimit(resource.RLIMIT_NOFILE, (5, 5))

        result = self.start_limited(few)
        self.assertIn(result.returncode, (0, 7), result.stderr)

    def start_limited(self, limit):
        return subprocess.run(
            [PROGRAM, "run", "test.deck", "--quiet"],
            cwd=self.folder,
            env=environment(OPENBLAS_NUM_THREADS="1"),
            capture_output=True,
            text=True,
            timeout=60,
            preexec_fn=limit,
            check=False,
        )


if __name__ == "__main__":
    main()
