# SPDX-License-Identifier: GPL-3.0-or-later
"""`cmake --install` puts all in place that a run, and a program of others, needs, wherever the place is moved;
decks/run takes a program of the same sources; the scripts wait while apt is locked."""

import csv
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from program import CRACKED, PROGRAM, TOP, ProgramTest, environment, main

sys.path.append(str(TOP / "tests/manual"))
from blocks import blocks_of  # noqa: E402

BUILD = Path(PROGRAM).parents[1]  # build/PRESET/bin/spricka
LIBRARY = (BUILD / "lib/libspricka.so").exists()  # not under the sanitizers, where nothing is linked to it


def call(*words, **more):
    """stdout of a command that must end well."""
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, check=False, timeout=600, **more)
    if done.returncode != 0:
        raise AssertionError(f"{words} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def build_library_example(folder, prefix):
    """The program of manual/library.md, compiled against what is installed in `prefix`."""
    for name, language in (("k_of_deck.cpp", "cpp"), ("CMakeLists.txt", "cmake")):
        text = next(b.text for b in blocks_of("library.md") if b.language == language)
        (folder / name).write_text(text, encoding="utf-8")
    call("cmake", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    call("cmake", "--build", folder / "build")
    return folder / "build/k_of_deck"


class Install(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """Installed to one place, and then moved."""
        cls._tree = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls._tree.cleanup)
        first = Path(cls._tree.name) / "first"
        part = [] if LIBRARY else ["--component", "program"]
        call("cmake", "--install", BUILD, "--prefix", first, "--strip", *part)
        cls.place = Path(cls._tree.name) / "moved to"
        first.rename(cls.place)

    def installed(self, *words):
        return call(self.place / "bin/spricka", *words, cwd=self.folder, env=environment(PATH="/nowhere"))

    def test_everything_is_in_its_place(self):
        files = {str(f.relative_to(self.place)) for f in self.place.rglob("*") if not f.is_dir()}
        manual = {f for f in files if f.startswith("share/doc/spricka/manual/")}
        library = {f for f in files if f.startswith(("lib/", "include/", "share/doc/libspricka"))}
        engines = {f"libexec/spricka/{f.name}" for f in Path(BUILD).glob("libexec/spricka/*.so")} if LIBRARY else set()
        self.assertLessEqual(engines, files)
        self.assertEqual(
            files - manual - library - engines,
            {
                "bin/spricka",
                "libexec/spricka/spricka-mesher",
                "share/man/man1/spricka.1.gz",
                "share/bash-completion/completions/spricka",
                "share/doc/spricka/README.md",
                "share/spricka/materials/materials.deck",
            }
            | {f"share/spricka/decks/{f.relative_to(TOP / 'decks')}" for f in (TOP / "decks").rglob("*")
               if f.is_file() and f.name != "run"}
            | {f"share/doc/spricka/{name}" for name in ("copyright", "changelog.gz")},
        )
        if LIBRARY:
            self.assertEqual(
                {Path(f).name for f in library},
                {"libspricka.so", "libspricka.so.0", "libspricka.so.0.1.0", "spricka-config.cmake",
                 "spricka-config-version.cmake", "spricka.hpp", "copyright", "changelog.gz"},
            )
        self.assertIn("share/doc/spricka/manual/pictures/readme.svg", manual)
        self.assertFalse([f for f in manual if f.endswith((".pyc", "manual/build"))])
        page = call("gzip", "-dc", self.place / "share/man/man1/spricka.1.gz")
        self.assertIn(".TH", page)

    def test_an_installed_program_cuts_a_crack_and_verifies_its_decks(self):
        self.deck(CRACKED)  # its patches are filled by the mesher that was installed
        self.installed("run", "test.deck", "--out", "out", "--quiet")
        self.assertTrue((self.folder / "out/k.csv").exists())
        # Its growth laws and its decks came with it.
        self.assertIn("AL2024_T3_SHEET_LT", self.installed("help", "materials"))
        self.assertIn("2 decks with a reference", self.installed("verify", "le1", "kirsch"))

    @unittest.skipUnless(LIBRARY, "without the library")
    def test_a_program_of_others_finds_the_same_K(self):
        example = build_library_example(self.folder, self.place)
        deck = self.place / "share/spricka/decks/edge_crack.deck"
        found = list(csv.reader(call(example, deck).splitlines()))
        self.installed("run", deck, "--out", "out", "--quiet")
        table = [line for line in (self.folder / "out/k.csv").read_text(encoding="utf-8").splitlines()
                 if not line.startswith("#")]
        rows = list(csv.DictReader(table))
        self.assertEqual(len(found), len(rows))
        self.assertGreater(len(rows), 0)
        for ours, row in zip(found, rows):
            self.assertEqual(ours[1:3], [row["step"], row["crack"]])
            for value, name in ((ours[4], "K1"), (ours[5], "K1_bar"), (ours[6], "K2")):
                self.assertAlmostEqual(float(value), float(row[name]), delta=1e-6 * abs(float(row["K1"])), msg=name)
        # Mistakes come with their places.
        self.deck(CRACKED.replace("STATE=STRESS", "STATE=STRES"))
        done = subprocess.run([example, "test.deck"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 3)
        self.assertIn("test.deck:4: E108", done.stderr)

    @unittest.skipUnless(LIBRARY, "without the library")
    def test_the_library_shows_nothing_but_its_header(self):
        library = next(self.place.glob("lib/**/libspricka.so.0"))
        names = {line.split(" ", 2)[2] for line in call("nm", "-DC", "--defined-only", library).splitlines()}
        self.assertEqual({n.split("(")[0].split("[")[0] for n in names}, {"spricka::solve_deck", "spricka::version"})


class Sources(ProgramTest):
    """decks/run and the digest of the sources, in a small tree with a build of the test's own."""

    DIGEST = call(TOP / "cmake/source_digest").strip()

    def test_the_program_tells_its_sources(self):
        self.assertIn(f"source         {self.DIGEST}\n", self.expect(0, "--version").stdout)

    def setUp(self):
        super().setUp()
        self.top = self.folder / "top"
        for name in ("cmake/build_tools.sh", "cmake/source_digest", "decks/run", "CMakeLists.txt",
                     "CMakePresets.json"):
            (self.top / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(TOP / name, self.top / name)
        for name in ("src/a.cpp", "grammar/b.cpp", "cmake/packages/build.txt"):
            (self.top / name).parent.mkdir(parents=True, exist_ok=True)
            (self.top / name).write_text("", encoding="utf-8")
        self.bin = self.folder / "bin"
        self.bin.mkdir()
        self.tool(self.bin / "cmake", "touch build/release/build.ninja")
        built = self.top / "build/release/bin/spricka"
        self.tool(self.bin / "ninja", f"mkdir -p {built.parent}; printf '#!/bin/sh\\necho built $@\\n' > {built}\n"
                                      f"chmod +x {built}")

    def tool(self, path, text):
        path.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
        path.chmod(0o755)

    def digest(self):
        return call(self.top / "cmake/source_digest").strip()

    def run_deck(self):
        done = subprocess.run([self.top / "decks/run", "x.deck"], capture_output=True, text=True, check=False,
                              cwd=self.folder, env=environment(PATH=f"{self.bin}:/usr/bin:/bin"))
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def test_a_program_of_the_same_sources_is_taken(self):
        answer = f"echo '  source         {self.digest()}'"
        self.tool(self.bin / "spricka", f"[ $1 = --version ] && {answer} || echo ours $@")
        done = self.run_deck()
        self.assertEqual(done.stdout, "ours run x.deck\n")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn(f"using {self.bin}/spricka", done.stderr)
        # Not when a source has changed.
        (self.top / "src/a.cpp").write_text("int a;\n", encoding="utf-8")
        done = self.run_deck()
        self.assertEqual(done.stdout, "built run x.deck\n")
        self.assertIn(f"not using {self.bin}/spricka", done.stderr)

    def test_without_a_program_it_is_built(self):
        done = self.run_deck()
        self.assertEqual(done.stdout, "built run x.deck\n")
        self.assertIn(f"using {self.top}/build/release/bin/spricka", done.stderr)

    def test_the_digest_follows_names_and_contents(self):
        known = {self.digest()}
        (self.top / "src/a.cpp").rename(self.top / "src/c.cpp")
        known.add(self.digest())
        (self.top / "grammar/b.cpp").write_text("int b;\n", encoding="utf-8")
        known.add(self.digest())
        self.assertEqual(len(known), 3)
        (self.top / "decks/mine.deck").write_text("", encoding="utf-8")
        self.assertIn(self.digest(), known)


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
