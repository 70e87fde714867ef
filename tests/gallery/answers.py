# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs spricka on decks where they stand, and takes meshes for the naive methods from its results."""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parents[1]
sys.path[:0] = [str(HERE.parent / "stability"), str(TOP / "manual")]

from program import Run, numbers  # noqa: E402
from spricka_results import Results  # noqa: E402

from plane import Block, Mesh  # noqa: E402

KEPT = {}
ASKED = []  # what scenes have asked for, in order
FULL = bool({"--full", "--write"} & set(sys.argv)) or "SPRICKA_FULL" in os.environ


class Answer(Run):
    """A run of a deck, in its folder."""

    def __init__(self, program, deck, definitions):
        self.folder = tempfile.TemporaryDirectory()
        self.out = pathlib.Path(self.folder.name) / "out"
        self.deck = deck
        command = [str(program), "run", str(deck), "--quiet", "--out", str(self.out), "--threads", "1"]
        for definition in definitions:
            command += ["-D", definition]
        start = time.monotonic()
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.seconds = time.monotonic() - start
        self.code, self.messages = done.returncode, done.stderr

    @property
    def name(self):
        """A link from a page of the gallery."""
        return f"[{self.deck.name}](../../{self.deck.relative_to(TOP)})"

    def results(self):
        return Results(self.out / "results.h5")

    def said(self):
        """The first warning or refusal, without numbers of lines."""
        if self.outcome() == "refusal":
            code = self.refusal()  # without a code of an error nothing is said
            return f"refused, exit {self.code}: {code}" if code.startswith("E") else ""
        warnings = self.warnings()
        return f"warns: {warnings[0][0]} {warnings[0][1]}" if warnings else ""

    def k_row(self, step, crack, a=None):
        """Row of k.csv at the length nearest to a."""
        rows = [r for r in numbers(self.out / "k.csv") if r["step"] == step and r["crack"] == crack]
        return rows[-1] if a is None else min(rows, key=lambda r: abs(float(r["a"]) - a))

    def K(self, step, crack, a=None):
        return float(self.k_row(step, crack, a)["K1"])


def deck(name):
    """Path of a deck of this folder, else of decks/."""
    own = HERE / "decks" / f"{name}.deck"
    return own if own.exists() else TOP / "decks" / f"{name}.deck"


def answer(program, name, *definitions):
    """The run of a deck, done once."""
    key = name, definitions
    ASKED.append(key)
    if key not in KEPT:
        KEPT[key] = Answer(program, deck(name), definitions)
    return KEPT[key]


def commands(asked):
    """How a reader runs decks with their definitions, each once."""
    lines = []
    for name, definitions in dict.fromkeys(asked):
        words = " ".join(f"-D {d}" for d in definitions)
        lines.append(f"decks/run {deck(name).relative_to(TOP)} {words}".rstrip())
    return lines


def text_answer(program, text):
    """The run of a deck's text, for decks that are broken on purpose."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "case.deck"
        path.write_text(text, encoding="utf-8")
        return Answer(program, path, ())


KINDS = {1: ("T6", 6), 2: ("Q4", 4), 3: ("Q8", 8)}  # by the numbers of results.h5


class Given:
    """The mesh of an increment of a run; `parts` are blocks by nets, materials in the order of the nets."""

    def __init__(self, run, materials, increment=1):
        mesh = run.results().mesh(increment)
        self.parts = [[] for _ in materials]
        for net, part in enumerate(np.unique(mesh["element_net"])):
            for code in np.unique(mesh["type"]):
                here = (mesh["type"] == code) & (mesh["element_net"] == part)
                if here.any():
                    kind, count = KINDS[code]
                    nodes = mesh["nodes"][mesh["first"][:-1][here][:, None] + np.arange(count)]
                    self.parts[net].append(Block(kind, nodes.astype(int), materials[net]))
        blocks = [block for part in self.parts for block in part]
        used = np.unique(np.concatenate([block.nodes.ravel() for block in blocks]))
        new = np.full(len(mesh["x"]), -1)  # nodes that a patch has replaced are left out
        new[used] = np.arange(len(used))
        for block in blocks:
            block.nodes = new[block.nodes]
        self.mesh = Mesh(mesh["x"][used, :2].copy(), blocks)
