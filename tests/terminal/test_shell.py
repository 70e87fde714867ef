# SPDX-License-Identifier: GPL-3.0-or-later
"""Completion in bash and the man page."""

import shutil
import subprocess
import unittest

from program import PROGRAM, ProgramTest, environment, main

ASK = """source <("$1" completion bash)
COMP_WORDS=({words})
COMP_CWORD={last}
_spricka 2>/dev/null
printf '%s\\n' "${{COMPREPLY[@]}}"
"""


class Completion(ProgramTest):
    def completed(self, *words):
        script = ASK.format(words=" ".join(f"'{w}'" for w in ("spricka",) + words), last=len(words))
        done = subprocess.run(["bash", "-c", script, "bash", PROGRAM], cwd=self.folder, text=True,
                              capture_output=True, env=environment(), check=True)
        return done.stdout.split()

    def test_commands_and_options(self):
        self.assertEqual(self.completed("ch"), ["check"])
        self.assertIn("--version", self.completed("--"))
        self.assertEqual(self.completed("run", "--th"), ["--threads"])
        self.assertEqual(self.completed("run", "--log-format", "j"), ["json"])
        self.assertNotIn("--out", self.completed("check", "--"))

    def test_cards_behind_help(self):
        self.assertEqual(self.completed("help", "CONTA"), ["CONTACT"])
        self.assertEqual(self.completed("help", "conta"), ["CONTACT"])
        self.assertEqual(self.completed("help", "quant"), ["quantities"])

    def test_decks(self):
        for name in ("a.deck", "b.txt"):
            (self.folder / name).touch()
        (self.folder / "sub").mkdir()
        for command in ("run", "check", "format"):
            self.assertEqual(sorted(self.completed(command, "")), ["a.deck", "sub"])
        self.assertEqual(self.completed("editor", "v"), ["vim", "vscode"])


class ManPage(ProgramTest):
    def test_has_its_sections(self):
        page = self.expect(0, "man").stdout
        self.assertTrue(page.startswith(".TH SPRICKA 1"))
        for part in (".SH NAME", ".SH SYNOPSIS", ".SS spricka run", ".SS spricka format",
                     "\\fB\\-\\-threads\\fR", ".SH EXIT STATUS", "NO_COLOR"):
            self.assertIn(part, page)

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_groff_takes_it(self):
        page = self.expect(0, "man").stdout
        done = subprocess.run(["groff", "-man", "-Tutf8", "-ww"], input=page, text=True,
                              capture_output=True, check=True)
        self.assertEqual(done.stderr, "")


if __name__ == "__main__":
    main()
