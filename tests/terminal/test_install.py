# SPDX-License-Identifier: GPL-3.0-or-later
"""`cmake --install` puts all in place that a run needs, wherever that place is."""

import subprocess
from pathlib import Path

from program import CRACKED, PROGRAM, TOP, ProgramTest, environment, main

BUILD = Path(PROGRAM).parents[1]  # build/PRESET/bin/spricka


class Install(ProgramTest):
    def test_an_installed_program_cuts_a_crack_and_explains_itself(self):
        place = self.folder / "usr"
        subprocess.run(
            ["cmake", "--install", BUILD, "--prefix", place], check=True, capture_output=True
        )
        files = {str(f.relative_to(place)) for f in place.rglob("*") if f.is_file()}
        self.assertEqual(
            files,
            {
                "bin/spricka",
                "libexec/spricka/spricka-mesher",
                "share/man/man1/spricka.1",
                "share/bash-completion/completions/spricka",
            }
            | {f"share/spricka/decks/{f.name}" for f in (TOP / "decks").iterdir() if f.name != "run"},
        )
        self.deck(CRACKED)  # its patches are filled by the mesher that was installed
        done = subprocess.run(
            [place / "bin/spricka", "run", "test.deck", "--out", "out", "--quiet"],
            cwd=self.folder,
            env=environment(),
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "out/k.csv").exists())

        # Its decks came with it.
        verified = subprocess.run(
            [place / "bin/spricka", "verify", "le1", "kirsch"],
            cwd=self.folder,
            env=environment(),
            capture_output=True,
            text=True,
        )
        self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)
        self.assertIn("2 decks with a reference", verified.stdout)


if __name__ == "__main__":
    main()
