# SPDX-License-Identifier: GPL-3.0-or-later
"""Does what a page of the manual says: runs its commands, writes its files, compares what is printed."""

import os
import re
import subprocess
from pathlib import Path

from blocks import MANUAL, TOP

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w.]*\w)")
# What differs from run to run and from machine to machine.
VARIES = re.compile(r"\b\d+\.\d+ s CPU|\b\d+ MiB|\b[\d.]+ m?s\b")


def same_number(shown, found):
    """Whether a number agrees with the one that is shown, to half a unit of its last digit (and, as
    machines differ in theirs, one more)."""
    mantissa, _, exponent = shown.lower().partition("e")
    digits = len(mantissa.partition(".")[2])
    unit = 10.0 ** (int(exponent or 0) - digits)
    return abs(float(found) - float(shown)) <= 1.5 * unit


def same_line(shown, found):
    """A line that ends with two dots is the beginning of one."""
    shown, found = (VARIES.sub("<varies>", line) for line in (shown, found))
    words, printed = NUMBER.sub("#", shown).split(), NUMBER.sub("#", found).split()
    if words[-1] == "..":
        words.pop()
        printed = printed[:len(words)]
    if words != printed:
        return False
    return all(same_number(a, b) for a, b in zip(NUMBER.findall(shown), NUMBER.findall(found)))


def first_lost(shown, printed):
    """The first line that is shown and not printed, in order; a line of dots passes over others."""
    at = 0
    lines = printed.splitlines()
    for line in shown.splitlines():
        if line.strip() in ("..", "...", ""):
            continue
        while at < len(lines) and not same_line(line, lines[at]):
            at += 1
        if at == len(lines):
            return line
        at += 1
    return None


# mpirun in a container, where the user is root, and on a machine with fewer cores than ranks.
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}


class Reader:
    """Does what a page says, in a folder that looks like the top of a checkout."""

    def __init__(self, program, folder):
        self.folder = Path(folder)
        self.printed = None
        self.known = set()  # numbers of files and of what was printed
        self.full = bool(os.environ.get("SPRICKA_FULL"))
        self.strict = False  # whether a block without a mark is a mistake
        bin_folder = self.folder / "build/release/bin"
        bin_folder.mkdir(parents=True)
        (bin_folder / "spricka").symlink_to(program)
        self.bin = bin_folder
        decks = self.folder / "decks"
        decks.mkdir()
        for file in (TOP / "decks").iterdir():
            if file.name != "run":
                (decks / file.name).symlink_to(file)
        # decks/run installs, builds, and is then nothing but `spricka run`
        run = decks / "run"
        run.write_text("#!/bin/sh\n[ $# -gt 0 ] || set -- decks/lug_single.deck\nexec spricka run \"$@\"\n")
        run.chmod(0o755)
        (self.folder / "manual").symlink_to(MANUAL)
        (self.folder / "tmp").mkdir()

    def shell(self, text):
        text = text.replace("/tmp/", f"{self.folder}/tmp/")
        done = subprocess.run(["bash", "-euc", text], cwd=self.folder, text=True, capture_output=True,
                              timeout=1800 if self.full else 300, check=False,
                              env={"PATH": f"{self.bin}:/usr/bin:/bin", "HOME": str(self.folder), **MPI,
                                   "OPENBLAS_NUM_THREADS": "1", "LC_ALL": "C.UTF-8"})
        return done.returncode, done.stdout + done.stderr

    def write(self, block):
        marks = block.marks
        if "file" in marks:
            (self.folder / marks["file"]).write_text(block.text, encoding="utf-8")
        elif "more" in marks:
            with (self.folder / marks["more"]).open("a", encoding="utf-8") as file:
                file.write(block.text)
        else:
            name, line = marks["into"].split(" before ")
            path = self.folder / name
            text = path.read_text(encoding="utf-8")
            assert f"\n{line}" in text, f"{block.place}: {name} has no line {line}"
            path.write_text(text.replace(f"\n{line}", f"\n{block.text}{line}", 1), encoding="utf-8")

    def do(self, block):
        """Empty, or what is wrong."""
        result = self.do_it(block)
        self.known |= set(NUMBER.findall(block.text if "shown" not in block.marks else ""))
        self.known |= set(NUMBER.findall(self.printed or ""))
        return result

    def do_it(self, block):
        if {"not run", "shown"} & set(block.marks) or ("long" in block.marks and not self.full):
            return ""
        if {"file", "more", "into"} & set(block.marks):
            self.write(block)
            return ""
        if block.language == "sh":
            code, self.printed = self.shell(block.text)
            wanted = int(block.marks.get("exit", 0))
            return "" if code == wanted else f"ended with {code}, not {wanted}:\n{self.printed[-3000:]}"
        if block.language == "text" and self.printed is not None:
            lost = first_lost(block.text, self.printed)
            return "" if lost is None else f"not printed: {lost}\nbut:\n{self.printed[-3000:]}"
        if self.strict:
            return "a block without a mark: tests/manual/blocks.py has them"
        return ""
