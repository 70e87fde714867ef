#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The gallery of failures: scenes at which usual methods fail, what they answer and what spricka answers.

    tests/gallery/gallery.py PROGRAM [--full] [--write] [SCENE ..]

Every naive method must still fail as it was measured before, and spricka be right or say that it is not. --full (or
SPRICKA_FULL in the environment) adds the rows on fine meshes; --write does so too and makes manual/gallery/ of the
scenes named, or of all.
"""
import re
import sys

import answers
import pictures
import scenes_body
import scenes_closure
import scenes_contact
import scenes_joint
import scenes_limit
import scenes_reader
import scenes_tip
from answers import FULL, TOP

PAGES = TOP / "manual" / "gallery"
SCENES = {name: make for room in (scenes_contact, scenes_body, scenes_joint, scenes_closure, scenes_tip, scenes_reader,
                                 scenes_limit) for name, make in room.SCENES.items()}


HEAD = """# Gallery of failures

These pages show where usual methods for contact and cracks fail: what they answer, how far that is off, and what spricka
answers for the same problem. Read them to see whether a method that you use now has such a trap, and what to check.

The usual (naive) methods are written out in `tests/gallery/naive_*.py`, on a small finite-element program beside them,
mostly on the very mesh that spricka solved. `tests/gallery/gallery.py PROGRAM --write` runs all of them and makes these
pages from that run.

*Measured before* are figures of CalculiX 2.20 (Debian 12) and of plain prototypes, from comparisons that are older than this
program. The benchmarks F01, C02, .. and the sweeps S01 to S12 are those that decks name as SOURCE and that
[stability](../stability.md) runs. A naive method here has to fail as much as it did there, to a factor of two, or the page
says why it does not. spricka's rows have to be right, or say that they are not.

| scene | naive method, worst row | its error | spricka, worst row | covers |
|---|---|---|---|---|
"""
SLOW = ("limit_solid_friction",)
VARIANTS = {name: [f"naive_{word}.py" for word in words.split()] for name, words in (
    ("penalty", "penalty"), ("one_pass", "one_pass"), ("corner_nodes", "corner_nodes"),
    ("consistent_recovery", "consistent_recovery"), ("averaged_normals", "averaged_normals"), ("facets", "faceted_gap"),
    ("floating", "soft_springs"), ("doubled_pair", "doubled_pair penalty"), ("hertz_pin", "hertz_pin"),
    ("huge_modulus", "huge_modulus"),
    ("superposition", "superposition"), ("assumed_pressure", "assumed_pressure"), ("one_beta", "one_beta"),
    ("uncracked_stress", "uncracked_stress"), ("open_faces", "open_faces"), ("friction_history", "total_friction"),
    ("tip_only_extension", "tip_only_extension"), ("opening", "extrapolated_opening"), ("snapped_length",
                                                                                        "snapped_length"),
    ("ligament", "handbook_polynomial"), ("folded", "unlooked_mesh"), ("broken_decks", "lenient_reader soft_springs"),
    ("limit_lip", "largest_stress"))}
LINE = re.compile(r"<!-- index: (.*) -->")


def index_line(scene):
    """What the index says of a scene: kept in the page, so that it can be made anew from the pages."""
    naive = [row for row in scene.rows() if row.who == "naive" and row.error is not None]
    worst = max(naive, key=lambda row: (row.unit == "%", abs(row.error)), default=None)
    own = [row for row in scene.rows() if row.who == "spricka"]
    right = [row for row in own if row.error is not None and not row.said and row.unit == "%"]
    words = []
    worst_right = max((abs(row.error) for row in right), default=0.0)
    if worst_right > 1e-6:
        words.append(right[0].shown(max(right, key=lambda row: abs(row.error)).error))
    elif right:
        words.append("right")
    words += [name for name in ("refuses", "warns", "notes") if any(row.said.startswith(name[:4]) for row in own)]
    return (f"[{scene.title()}]({scene.name}.md) | {worst.method if worst else ''} | "
            f"{worst.shown(worst.error) if worst else ''} | {', '.join(words) or 'right'} | {scene.covers}")


def write_index():
    lines = []
    for name in SCENES:
        page = PAGES / f"{name}.md"
        if page.exists():
            lines += [f"| {line} |" for line in LINE.findall(page.read_text(encoding="utf-8"))]
    (PAGES / "index.md").write_text(HEAD + "\n".join(lines) + "\n", encoding="utf-8")


def write(scene, commands):
    PAGES.mkdir(exist_ok=True)
    page = scene.page(VARIANTS.get(scene.name, ()), commands) + f"\n<!-- index: {index_line(scene)} -->\n"
    (PAGES / f"{scene.name}.md").write_text(page, encoding="utf-8")
    if scene.drawings:
        (PAGES / f"{scene.name}.svg").write_text(pictures.sheet(scene.drawings), encoding="utf-8")


def main():
    words = [w for w in sys.argv[2:] if not w.startswith("--")]
    for word in words:
        if word not in SCENES:
            sys.exit(f"there is no scene {word}; there are {', '.join(SCENES)}")
    wrong, covered = 0, set()
    for name, make in SCENES.items():
        if words and name not in words or name in SLOW and not FULL and not words:
            continue
        answers.ASKED.clear()
        scene = make(sys.argv[1])
        assert scene.name == name
        print(f"{scene.title()}\n")
        for table in scene.tables:
            print(table.text())
        bad = [row for row in scene.rows() if not row.ok()]
        wrong += len(bad)
        for row in bad:
            print(f"WRONG: {row}")
        if "--write" in sys.argv:
            write(scene, answers.commands(answers.ASKED))
        covered |= set(re.findall(r"S\d\d", scene.covers))
    if not words and covered != {f"S{n:02d}" for n in range(1, 13)}:
        print(f"WRONG: not all of S01 to S12 have a scene: {sorted(covered)}")
        wrong += 1
    if "--write" in sys.argv:
        write_index()
    print(f"{wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
