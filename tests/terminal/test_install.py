# SPDX-License-Identifier: GPL-3.0-or-later
"""`cmake --install` puts all in place that a run needs, wherever that place is."""

import subprocess
from pathlib import Path

from program import CRACKED, PROGRAM, ProgramTest, environment, main

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
            },
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


if __name__ == "__main__":
    main()
