# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks that are broken in small ways, as in the users' list, section 4."""
import subprocess

from answers import answer, deck, text_answer
from meshes import grid
from naive_lenient_reader import stretched_block
from scene import Row, Scene, Table

# what is changed, in words; how; what CalculiX 2.20 did with the like: words, exit code
BROKEN = (("a card misspelt: `$FREDOM`", "$FREEDOM", "$FREDOM", "free body solved, displacements 1e10 to 1e12; exit 0"),
          ("a card with a letter too many: `$MATERIALL`", "$MATERIAL", "$MATERIALL",
           "taken as the card it begins with; exit 0"),
          ("junk in a data line", "YMAX  0  1", "YMAX  0  1x", "error; exit 201"),
          ("the supports left out", "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  YMIN\n", "",
           "solved, or stopped with 255 and no word"))


def broken(program):
    text = deck("broken_block").read_text(encoding="utf-8")
    good = answer(program, "broken_block")
    right, _ = stretched_block(text, grid)
    lost, passed = stretched_block(text.replace("$FREEDOM", "$FREDOM"), grid)
    rows = [Row("other", "a reader that passes over what it does not know, good deck",
                f"largest displacement {right:.3g}"),
            Row("naive", f"the same, `$FREDOM`: {passed} card passed over, exit 0", f"{lost:.3g}", lost / right - 1,
                at_least=1e6, note="CalculiX with `*BOUNDRY`: 1e10 to 1e12, exit 0")]
    peers = []
    for words, old, new, peer in BROKEN:
        assert old in text
        run = text_answer(program, text.replace(old, new))
        refused = run.outcome() == "refusal"
        peers.append(Row("spricka", words, peer, said=run.said() if refused else "", error=None, allowed=0.0))
    inside_out = answer(program, "folded_strip")
    peers.append(Row("spricka", f"an element turned inside out ({inside_out.name})", "error; exit 201",
                     said=inside_out.said(), allowed=0.0))
    for words, arguments, peer in (("the deck is not there", ["run", "no_such.deck"], "error; exit 0"),
                                   ("`--help`", ["--help"], "error, no such file; exit 0"),
                                   ("`--version`", ["--version"], "error, no such file; exit 0")):
        done = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
        said = (done.stderr or done.stdout).strip().splitlines()[0]
        wanted = (done.returncode == 0) == arguments[0].startswith("--")
        peers.append(Row("spricka", words, peer, said=f"exit {done.returncode}: {said}" if wanted else "", allowed=0.0))
    value = float(good.results().table("checks")["found"][0])
    rows.append(Row("spricka", f"spricka, {good.name}, the good deck", f"{value:.3g}", value / right - 1, allowed=1e-2,
                    said=good.said()))
    return Scene(
        "broken_decks",
        [Table("A block that is held at its foot and pulled by 1:", rows),
         Table("Small mistakes in that deck:", peers, ["mistake", "CalculiX with the like", "error", "measured before",
                                                   "spricka"])],
        [], "peer traps: words, exit codes")


SCENES = {"broken_decks": broken}
