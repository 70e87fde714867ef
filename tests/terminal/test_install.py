# SPDX-License-Identifier: GPL-3.0-or-later
"""`cmake --install` puts all in place that a run needs; the scripts wait while apt is locked."""

import os
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
            | {f"share/spricka/decks/{f.relative_to(TOP / 'decks')}" for f in (TOP / "decks").rglob("*")
               if f.is_file() and f.name != "run"},
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


# An apt-get that finds a lock as often as the file `busy` has lines, and notes how it was called.
APT = """#!/bin/sh
echo "$@" >> calls
if [ -s busy ]; then
  sed -i 1d busy
  echo "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 42 (apt-get)" >&2
  exit 100
fi
echo done
"""


class Locks(ProgramTest):
    """apt_get of cmake/build_tools.sh, with an apt-get of the test's own in front of the system's."""

    def call(self, busy, shell):
        for name, text in (("apt-get", APT), ("sudo", '#!/bin/sh\nexec "$@"\n')):
            (self.folder / name).write_text(text, encoding="utf-8")
            (self.folder / name).chmod(0o755)
        (self.folder / "busy").write_text("x\n" * busy, encoding="utf-8")
        tools = TOP / "cmake/build_tools.sh"
        done = subprocess.run(
            ["bash", "-c", f"set -euo pipefail; . '{tools}'; lock_pause=0.01; {shell}"],
            cwd=self.folder,
            env=environment(PATH=f"{self.folder}:{os.environ['PATH']}"),
            capture_output=True,
            text=True,
            timeout=60,
        )
        calls = (self.folder / "calls").read_text(encoding="utf-8").splitlines()
        return done, calls

    def test_waits_and_says_so_once(self):
        done, calls = self.call(3, "apt_install log one two; update_index log")
        self.assertEqual(done.returncode, 0, done.stderr)
        install = "-q install -y --no-install-recommends one two"
        self.assertEqual(calls, [install] * 4 + ["-q update"])
        self.assertEqual(done.stderr.count("waiting up to"), 1, done.stderr)
        self.assertIn("held by process 42", done.stderr)
        self.assertEqual((self.folder / "log").read_text(encoding="utf-8"), "done\ndone\n")

    def test_says_nothing_without_a_lock(self):
        done, calls = self.call(0, "apt_install log one")
        self.assertEqual((done.returncode, done.stderr, len(calls)), (0, "", 1))

    def test_gives_up_in_the_end(self):
        done, calls = self.call(1000, "lock_patience=1; apt_install log one")
        self.assertEqual(done.returncode, 100)
        self.assertIn("giving up", done.stderr)
        self.assertIn("held by process 42", (self.folder / "log").read_text(encoding="utf-8"))
        self.assertGreater(len(calls), 1)


if __name__ == "__main__":
    main()
