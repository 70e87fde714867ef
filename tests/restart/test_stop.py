# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals and the time limit leave a state and exit 6; going on gives the same bits."""

import signal
import time

from run_folders import CRACKED, RestartTest, keeping, main

def lengths(count):
    values = "  ".join(f"{1 + 0.05 * i:g}" for i in range(count))
    return CRACKED.replace("  1  1.5  2\n", f"  {values}\n")


# Slow enough for a signal to meet it.
LONG = lengths(24).replace("NX=4 NY=2", "NX=40 NY=20")


class Stop(RestartTest):
    def wait_for_state(self, increments=1):
        for _ in range(600):
            if len(self.increments()) >= increments and (self.folder / "state.rst").exists():
                return
            time.sleep(0.05)
        self.fail("no state was written")

    def test_a_signal_leaves_a_state(self):
        deck = self.deck(keeping(LONG))
        for sign, name in ((signal.SIGTERM, "SIGTERM"), (signal.SIGINT, "SIGINT")):
            child = self.start("run", deck, "--restart", "--quiet")
            self.wait_for_state(len(self.increments()) + 1)
            child.send_signal(sign)
            _, errors = child.communicate(timeout=60)
            self.assertEqual(child.returncode, 6, errors)
            self.assertRegex(errors, f"stopped by {name}: [0-9]+ increments? (is|are) kept in .*state.rst")
            self.assertFalse((self.folder / "test.run").exists())
            # K of what is finished stays to be read.
            self.assertEqual([f.name for f in (self.folder / "test.run.part").iterdir() if f.name[0] != "."], ["k.csv"])
        self.expect(0, "run", deck, "--restart", "--quiet")
        self.assertFalse((self.folder / "test.run.part").exists())
        self.expect(0, "run", deck, "--out", "whole.run", "--quiet")
        self.same_folders(self.folder / "whole.run", self.folder / "test.run")

    def test_a_signal_keeps_what_every_left_out(self):
        deck = self.deck(keeping(LONG, "$RESTART WRITE='state.rst' EVERY=3\n"))
        child = self.start("run", deck, "--quiet")
        self.wait_for_state(3)
        time.sleep(0.3)
        child.terminate()
        _, errors = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 6, errors)
        self.assertIn(f"{len(self.increments())} increments are kept", errors)

    def test_time(self):
        deck = self.deck(keeping(lengths(8)))
        self.expect(0, "run", deck, "--out", "whole.run", "--quiet")
        for f in self.folder.glob("state.rst*"):
            f.is_file() and f.unlink()
        sessions = 0
        while True:
            result = self.run_program("run", deck, "--restart", "--time", "0.001", "--quiet")
            if result.returncode != 6:
                break
            sessions += 1
            self.assertIn("stopped by --time 0.001", result.stderr)
            self.assertLess(sessions, 8)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreater(sessions, 3)  # each session solves one increment at least
        self.same_folders(self.folder / "whole.run", self.folder / "test.run")

    def test_time_enough(self):
        self.expect(0, "run", self.deck(keeping()), "--time", "1000", "--quiet")

    def test_without_a_place_for_the_state(self):
        deck = self.deck(CRACKED)
        for option in (("--restart",), ("--time", "5")):
            result = self.expect(2, "run", deck, *option)
            self.assertIn("error E567", result.stderr)
            self.assertIn("$RESTART WRITE", result.stderr)
        self.assertIn("--time", self.expect(2, "run", deck, "--time", "-1").stderr)

    def test_a_sweep_keeps_each_point(self):
        text = CRACKED.replace("$MESH", "$PARAMETER\n  s = 100\n$MESH").replace("0  100", "0  (s)")
        sweep = "$SWEEP PARAMETER=s\n  100 110 120\n"
        deck = self.deck(keeping(text, sweep + "$RESTART WRITE='state.rst'\n"))
        self.expect(0, "run", deck, "--out", "whole.run", "--quiet")
        codes = []
        while not codes or codes[-1] == 6:
            result = self.run_program(
                "run", deck, "--restart", "--time", "0.001", "--quiet", "--out", "parts.run"
            )
            codes.append(result.returncode)
            self.assertLess(len(codes), 20, result.stderr)
        self.assertEqual(codes[-1], 0, result.stderr)
        self.assertGreater(codes.count(6), 5)
        for point in ("001", "002", "003"):
            self.same_folders(
                self.folder / "whole.run" / point, self.folder / "parts.run" / point
            )
            self.assertTrue((self.folder / "parts.run" / f"{point}.restart" / "state.rst").exists())


if __name__ == "__main__":
    main()
