# SPDX-License-Identifier: GPL-3.0-or-later
"""`spricka shell`: commands from a pipe and from a terminal."""

import os
import pty
import re
import select
import signal
import subprocess

from program import CRACKED, PROGRAM, ProgramTest, environment, main, plate

K1 = re.compile(r"K1\(C,NOW\) = (\S+) MPa\*mm\^0\.5")


class Pipe(ProgramTest):
    def shell(self, lines, *options, code=0, deck=CRACKED):
        return self.expect(code, "shell", self.deck(deck), *options, stdin=lines)

    def test_answers_go_to_stdout_alone(self):
        result = self.shell("K1(C,NOW)\n! a comment\n\nLOAD PULL 2\nK1(C,NOW)\n")
        values = [float(v) for v in K1.findall(result.stdout)]
        self.assertEqual(len(values), 2)
        self.assertEqual(len(result.stdout.splitlines()), 2)
        self.assertAlmostEqual(values[1], 2 * values[0], delta=1e-8 * values[0])

    def test_same_k_as_a_run(self):
        self.expect(0, "run", self.deck(CRACKED))
        rows = [r.split(",") for r in (self.folder / "test.run" / "k.csv").read_text().splitlines()
                if not r.startswith("#")]
        k1 = rows[0].index("K1")
        out = self.shell("$CRACK NAME=C A0=1\nK1(C,NOW)\n$CRACK NAME=C A0=2\nK1(C,NOW)\n").stdout
        found = [float(v) for v in K1.findall(out)]
        for row, value in zip((rows[1], rows[3]), found):
            self.assertAlmostEqual(value, float(row[k1]), delta=1e-8 * value)

    def test_mistakes_do_not_end_it(self):
        result = self.shell("laod PULL 2\nLOAD PUL 2\n$CRACK NAME=C A0=1e3\nK1(C,NOW)\n")
        self.assertIn("did you mean 'LOAD'?", result.stderr)
        self.assertIn("did you mean 'PULL'?", result.stderr)
        self.assertIn("error", result.stderr.splitlines()[-2] + result.stderr)
        self.assertEqual(len(K1.findall(result.stdout)), 1)

    def test_lengths_of_growth_are_not_those_of_a_changed_card(self):
        self.assertNotIn("W454", self.shell("$CRACK NAME=C A0=2\n$CRACK NAME=C A0=2.5\n").stderr)

    def test_numbers_beyond_all_range_are_no_answer(self):
        result = self.shell("LOAD PULL 1e300\nK1(C,NOW)\nLOAD PULL 1\nK1(C,NOW)\n")
        self.assertIn("beyond the range of numbers", result.stderr)
        self.assertEqual(len(K1.findall(result.stdout)), 1)

    def test_strict_ends_with_the_first_failure(self):
        result = self.shell("laod PULL 2\nK1(C,NOW)\n", "--strict", code=2)
        self.assertEqual(result.stdout, "")
        self.shell("$CRACK NAME=C A0=1e3\n", "--strict", code=3)
        self.shell("save /no/such/folder/a.deck\n", "--strict", code=7)
        self.shell("K1(C,NOW)\nquit\nlaod\n", "--strict")

    def test_a_deck_that_cannot_be_opened(self):
        self.assertIn("E104", self.shell("", code=3, deck=plate("$FOO\n")).stderr)
        self.expect(7, "shell", "none.deck", stdin="")
        loose = plate().replace("$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMIN\n", "")
        self.assertIn("error", self.shell("", code=4, deck=loose).stderr)

    def test_saved_deck_runs(self):
        out = self.shell("LOAD PULL 3\n$CRACK NAME=C A0=1.5\nK1(C,NOW)\nsave new.deck\n").stdout
        self.expect(0, "run", "new.deck", "--quiet")
        rows = [r.split(",") for r in (self.folder / "new.run" / "k.csv").read_text().splitlines()
                if not r.startswith("#")]
        value = float(K1.findall(out)[0])
        self.assertAlmostEqual(float(rows[-1][rows[0].index("K1")]), value, delta=1e-9 * value)
        self.expect(0, "format", "new.deck")

    def test_pictures(self):
        self.shell("plot mesh m.svg\nplot k k.svg\n$CRACK NAME=C A0=2\nplot k k.svg\n")
        for name in ("m.svg", "k.svg"):
            self.assertTrue((self.folder / name).read_text().startswith("<svg"))

    def test_help_lists_what_the_man_page_has(self):
        out = self.shell("help\n").stdout
        page = self.expect(0, "man").stdout
        for word in ("LOAD", "list", "map", "save", "quit"):
            self.assertRegex(out, rf"(?m)^{word}\b")
            self.assertIn(f"\\fB{word}\\fR", page)


class Terminal(ProgramTest):
    """A session on a terminal of its own, keys as they are pressed."""

    def setUp(self):
        super().setUp()
        self.ours, theirs = pty.openpty()
        self.child = subprocess.Popen(
            [PROGRAM, "shell", self.deck(CRACKED)], cwd=self.folder, stdin=theirs, stdout=theirs,
            stderr=theirs, env=environment(XDG_STATE_HOME=str(self.folder)),
            preexec_fn=self.own_terminal)
        os.close(theirs)
        self.addCleanup(self.end)
        self.until("LOAD> ")

    @staticmethod
    def own_terminal():
        os.setsid()
        import fcntl
        import termios
        fcntl.ioctl(0, termios.TIOCSCTTY, 0)

    def end(self):
        if self.child.poll() is None:
            self.child.send_signal(signal.SIGKILL)
        self.child.wait(timeout=60)
        os.close(self.ours)

    def press(self, keys):
        os.write(self.ours, keys.encode())

    def until(self, text):
        """What is shown until this text has been."""
        shown = ""
        while text not in shown:
            self.assertTrue(select.select([self.ours], [], [], 60)[0], f"waiting: {shown!r}")
            try:
                part = os.read(self.ours, 4096)
            except OSError:
                part = b""
            self.assertTrue(part, f"it ended: {shown!r}")
            shown += part.decode("utf-8", "replace").replace("\x1b[?2004h", "").replace(
                "\x1b[?2004l", "")
        return shown

    def test_prompt_says_what_is_pending(self):
        self.press("LOAD PULL 2\n")
        self.until("LOAD*> ")
        self.press("solve\n")
        self.assertIn("ms CPU)", self.until("LOAD+> "))

    def test_tab_completes_commands_and_names(self):
        self.press("LO\t")
        self.until("LOAD ")
        self.press("\t1.5\n")
        self.until("LOAD*> ")

    def test_ctrl_c_clears_the_line(self):
        self.press("nonsense")
        self.until("nonsense")
        self.press("\x03")
        self.until("LOAD> ")
        self.press("list\n")
        self.assertNotIn("there is no command", self.until("LOAD> "))
        self.assertIsNone(self.child.poll())

    def test_ctrl_c_while_it_computes(self):
        self.press("$CRACK NAME=C A0=2\n")
        self.until("A0=2\r\n")
        self.press("\x03")  # now, or too late: then the answer is there
        shown = self.until("LOAD> ")
        self.press("\n")
        self.press("list\n")
        told = self.until("MPa")
        stopped = "stopped" in shown
        self.assertRegex(told, r"C +a = 1 " if stopped else r"C +a = 2 ")

    def test_ctrl_d_leaves(self):
        self.press("\x04")
        self.assertEqual(self.child.wait(timeout=60), 0)
        self.assertTrue((self.folder / "spricka" / "shell_history").exists())

    def test_history_comes_back(self):
        self.press("K1(C,NOW)\n")
        self.until("LOAD> ")
        self.press("\x1b[A")
        self.until("K1(C,NOW)")
        self.press("\n")
        self.until("MPa")


if __name__ == "__main__":
    main()
