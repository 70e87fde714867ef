# SPDX-License-Identifier: GPL-3.0-or-later
"""With SPRICKA_FULL=1: cmake/package makes the packages of a release as anybody would, lintian has no error to tell,
they are installed, upgraded and removed in a root of their own, and both they and the archive solve a deck where
nothing is compiled. The machine stays as it was but for build/release."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from program import TOP, environment, main
from test_install import build_library_example, call

FULL = bool(os.environ.get("SPRICKA_FULL"))
DECK = "share/spricka/decks/bushed_lug_flaw_solid.deck"
# What a shell of a user has; no compiler is called.
BARE = {"PATH": "/usr/bin:/bin", "HOME": "/nonexistent", "LC_ALL": "C.UTF-8"}


class Root:
    """A root for dpkg: its database, and what is installed."""

    def __init__(self, folder):
        self.folder = folder
        base = folder / "var/lib/dpkg"
        for name in ("info", "updates", "triggers"):
            (base / name).mkdir(parents=True)
        for name in ("status", "available"):
            (base / name).write_text("", encoding="utf-8")

    def dpkg(self, *words):
        # Libraries are those of the machine, which the database does not know of.
        fake = [] if os.geteuid() == 0 else ["fakeroot"]
        return call(*fake, "dpkg", f"--root={self.folder}", "--force-depends", "--force-not-root", "--log=/dev/null",
                    *words, env={**os.environ, "PATH": f"{os.environ['PATH']}:/usr/sbin:/sbin"})

    def status(self, package):
        return call("dpkg-query", f"--admindir={self.folder}/var/lib/dpkg", "-Wf", "${Version} ${db:Status-Status}",
                    package)

    def files(self):
        return [f for f in (self.folder / "usr").rglob("*") if not f.is_dir()] if (self.folder / "usr").exists() else []


@unittest.skipUnless(FULL, "with SPRICKA_FULL=1")
class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls._folder.cleanup)
        cls.folder = Path(cls._folder.name)
        cls.out = cls.folder / "out"
        done = subprocess.run([TOP / "cmake/package", cls.out], capture_output=True, text=True, check=False,
                              env=environment())
        cls.said = done.stdout + done.stderr
        assert done.returncode == 0, cls.said
        cls.debs = {f.name.split("_")[0]: f for f in cls.out.glob("*.deb")}

    def solve(self, prefix, name):
        """A run by the program in `prefix`; its run folder."""
        run = self.folder / name
        printed = call(prefix / "bin/spricka", "run", prefix / DECK, "--out", run, env=BARE, cwd=self.folder)
        self.assertIn("1 of 1 checks passed", printed)
        return run

    def field(self, package, name):
        return call("dpkg-deb", "-f", self.debs[package], name)

    def test_lintian_has_no_error_to_tell(self):
        self.assertNotRegex(self.said, re.compile(r"^E: ", re.M))
        cache = (TOP / "build/release/CMakeCache.txt").read_text(encoding="utf-8")
        library = {"libspricka0", "libspricka-dev"} if "SPRICKA_LIBRARY:BOOL=ON" in cache else set()
        self.assertEqual(set(self.debs), {"spricka"} | library)

    def test_dependencies_are_those_of_the_linked_libraries(self):
        for package in {"spricka", "libspricka0"} & set(self.debs):
            needs = self.field(package, "Depends")
            for library in ("libcholmod3", "libopenblas0", "libfmt9", "libgsl27", "libc6"):
                self.assertIn(library, needs)
        self.assertIn("libgmsh4.8", self.field("spricka", "Depends"))
        if "libspricka0" in self.debs:
            self.assertIn("spricka (= ", self.field("libspricka0", "Depends"))
            self.assertIn("libspricka0 (= ", self.field("libspricka-dev", "Depends"))
        # Engines are there, and nobody must have their libraries.
        inside = call("dpkg-deb", "-c", self.debs["spricka"])
        for module, library in (("mumps", "libmumps-seq-"), ("mumps-mpi", "libopenmpi3"), ("multigrid", "libpetsc-real")):
            if "libspricka0" in self.debs:
                self.assertIn(f"libexec/spricka/spricka-{module}.so", inside)
                self.assertIn(library, self.field("spricka", "Suggests"))
            self.assertNotIn(library, self.field("spricka", "Depends"))
        self.assertGreater(len(self.field("spricka", "Description").splitlines()), 4)
        # apt finds all of them; it only tells what it would do.
        call("apt-get", "install", "--simulate", "--no-install-recommends", *self.debs.values())

    def test_the_page_of_the_archive_names_its_packages(self):
        needs = {re.split(r"[ (|]", item.strip())[0] for package in {"spricka", "libspricka0"} & set(self.debs)
                 for item in self.field(package, "Depends").split(",")}
        page = (TOP / "manual/install.md").read_text(encoding="utf-8")
        told = set(re.search(r"^sudo apt install (lib(?:.*\\\n)*.*)$", page, re.M)[1].replace("\\\n", " ").split())
        if "libspricka0" not in self.debs:
            told.discard("libhdf5-103-1")  # the library alone is linked with it
        self.assertEqual(needs - {"spricka", "libc6", "libgcc-s1", "libstdc++6"}, told)

    def test_installed_upgraded_and_removed(self):
        root = Root(self.folder / "root")
        root.dpkg("-i", *self.debs.values())
        for package in self.debs:
            self.assertRegex(root.status(package), r" installed$")
        usr = root.folder / "usr"
        self.assertTrue((self.solve(usr, "installed.run") / "report.html").exists())
        self.assertIn("AL2024_T3_SHEET_LT", call(usr / "bin/spricka", "help", "materials", env=BARE, cwd=self.folder))
        if "libspricka-dev" in self.debs:
            example = self.folder / "example"
            example.mkdir()
            self.assertIn("FLAW", call(build_library_example(example, usr), usr / DECK))
        # The same files as a version that follows.
        newer = []
        for package, deb in self.debs.items():
            tree = self.folder / package
            call("dpkg-deb", "-R", deb, tree)
            control = tree / "DEBIAN/control"
            control.write_text(re.sub(r"(^Version: |spricka\d* \(= )([0-9.]+)", r"\g<1>\g<2>+1",
                                      control.read_text(encoding="utf-8"), flags=re.M), encoding="utf-8")
            newer.append(self.folder / f"{package}_newer.deb")
            call("dpkg-deb", "--root-owner-group", "-Znone", "-b", tree, newer[-1])
        root.dpkg("-i", *newer)
        self.assertRegex(root.status("spricka"), r"\+1 installed$")
        call(usr / "bin/spricka", "--version", env=BARE)
        root.dpkg("-P", *self.debs)
        self.assertEqual([], root.files())

    def test_the_archive_runs_from_any_folder(self):
        (archive,) = self.out.glob("*.tar.gz")
        call("tar", "-xf", archive, "-C", self.folder)
        place = self.folder / "some where" / "else"
        place.parent.mkdir()
        shutil.move(self.folder / archive.name.removesuffix(".tar.gz"), place)
        self.solve(place, "archive.run")
        link = self.folder / "link"
        link.symlink_to(place / "bin/spricka")
        self.assertIn("quick", call(link, "verify", "--list", env=BARE, cwd=self.folder))


if __name__ == "__main__":
    main()
