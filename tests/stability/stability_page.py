# SPDX-License-Identifier: GPL-3.0-or-later
"""What manual/ has of the sweeps: stability.csv, a row for each case, and stability.md, a summary of that table."""
import csv
import io

from program import TOP, numbers

TABLE = TOP / "manual" / "stability.csv"
PAGE = TOP / "manual" / "stability.md"
COLUMNS = ("family", "case", "outcome", "message", "found", "reference", "error", "allowed", "seconds", "passed")

# {name: (heading, what is swept and why methods fail there)} in the order of the page
FAMILIES = {
    "LAW": ("pressure along the surface", """\
Pressures along the contact surface are compared with closed forms: Hertz line contact (C03), a Lamé press fit and two
rings (C02), on several meshes. The error is the L2 norm. The total force can be right while the pressure swings from
node to node."""),
    "S02": ("no penalty", """\
Three contact decks run with other limits of iterations (`MAXITER`) and with two threads, and the pressures must not
change. With a penalty method the pressures depend on the stiffness that the user chooses."""),
    "S03": ("clearance through zero", """\
A pin in a hole goes from clearance through a neat fit (zero clearance) to interference. The half angle of contact, in
degrees, must grow without a step. Hertz's formula takes the contact to be narrow, and fails at small clearances."""),
    "S04": ("friction from zero to far beyond one", """\
The coefficient of friction goes from 0 to 2: partial slip (C10), blocks that stick or slide (C12), and a lug that is
pressed and loaded. Iterations for stick and slip may not converge, or end where Coulomb's law does not hold. A block
that slides must be refused by name."""),
    "S05": ("cracks near the edge of a contact", """\
Bending closes a crack step by step from one tip (F11; F is K1 over that of uniform tension). In a square lug (X01) the
load turns past the mouths of two cracks. A method that opens and closes whole elements makes K jump."""),
    "C07": ("neat fit", """\
The contact angle of a neat fit does not depend on the load. Loads of 1e-6 and 1e6 must give the same pressures over
the load, a reversed load the mirrored ones. A penalty, or a tolerance with a unit, makes them differ."""),
    "S07": ("contrast of moduli and units", """\
One part of a press fit, of two rings or of a pin joint is up to a million times stiffer or softer than the other, and
a press fit is written in other units. A stiffness or a tolerance that was chosen for one modulus is wrong for
another."""),
    "S10": ("bodies held by contact only", """\
Shaft, sleeve, layer and block have no supports of their own, so that their stiffness matrix is singular until contact
is found. Loaded parts must find their seat, parts without load must rest with a note, and parts that nothing holds
must be refused by name."""),
    "S11": ("redundant constraints", """\
Contact pairs stand twice in the deck, or a node is in two pairs or in a tie as well. Equations that say the same twice
have no unique forces, and springs that are given twice are twice as stiff. Ties that contradict each other must be
refused."""),
    "ASM": ("assembly in steps and undone", """\
A sleeve is pressed in, a shaft is mounted, loaded, unloaded, dismounted and mounted again. Each state must come back,
in its pressures and in K1. A method that gathers errors from step to step does not return."""),
    "S01": ("cracks in distorted meshes", """\
An edge crack (F01) and a slant crack (F04) are cut into meshes whose nodes are moved by up to d of an element's side,
and which are turned or stretched 20:1. Bad elements beside the tip spoil K. Elements that fold over must be refused
with their number."""),
    "S08": ("thin ligaments", """\
Edge and centre cracks leave a ligament down to 0.001 of the width, and a crack comes near a hole
(F = K / sqrt(pi a)). The ligament becomes thinner than an element and leaves no room for a mesh at the tip. A lost net
section must be refused."""),
    "S09": ("cracks shorter than an element", """\
A crack at a hole of radius R is 0.05 R down to 1e-5 R long, in elements of 0.1 R and 0.2 R, with its mouth at a node
or between nodes (F = K / sqrt(pi a)). A method that releases nodes of the mesh cannot have a crack shorter than an
element."""),
    "S12": ("elements at the tip", """\
The number of elements and of rings round the tip changes (F = K / sqrt(pi a)), and middle nodes lie beside the
quarter points. Quarter points out of place spoil K: the program must warn of them or put them right. Too few elements
round the tip and folded elements must be refused."""),
    "S06": ("step of the virtual crack extension", """\
A finite `SHIFT` of `$VCE` takes the place of the analytic derivative, from 0.1 to 1e-12 of the tip element. Large steps
have an error of their own, small ones lose their digits to round-off. The allowed error holds for answers without a
warning. Where the program warns of the step, the test allows 2 % of K1, so that the last column may exceed 1."""),
    "ANY": ("random cracks", """\
Sets of one to three random cracks are cut into three meshes, of which one is joined by ties. K must be the same in
all of them, or all must refuse in the same way. Cracks at random places meet the special cases of cutting a mesh."""),
    "X01": ("square lug", """\
Mean pressures on sleeve and shaft over an arc, without cracks and with two, and the angle over which lug and sleeve
separate. The three parts have two contacts, and each contact changes the other."""),
    "TOL": ("K to a tolerance", """\
`$TIPNET TOL` asks for K of a lug to 1 % and to 0.1 %, from meshes that are far too coarse for it. The error of K, over
K1, must lie within its error bar, in few solutions. An error estimate on a coarse mesh can be much too small.
The allowed error is the error bar plus the uncertainty of the reference."""),
    "LUG": ("pairings, mirrors, turns and sizes", """\
Sleeves and shafts have any number of elements and are turned by angles down to 1e-12; loads are mirrored, the lug and a
pin are turned and scaled from 1e-6 to 1e6. K1 and pressures must not change. Nodes that nearly match, and tolerances
with a unit, make answers jump. Each of the first rows is the worst of 20 decks."""),
}

HEAD = """# Stability

Sweeps over cases in which contact and crack methods are known to fail. Each case ends as an answer with an error
that is allowed, as an answer with a warning, or as a refusal that says why. A wrong answer without a word is a failure
of the test. The tests run a part of the cases daily, and all of them with `tests/run --full`.

All cases are in the file [stability.csv](stability.csv), a row for each: family, case, outcome, message of a
refusal, value found, reference, error, allowed error, wall seconds of the run on one thread, and 1 where the test
passed. The error is relative to the reference, and absolute where the reference is 0. S03, S05 and the ratios c/a of
S04 have absolute errors, TOL has errors over K1. A case without a reference is judged by its outcome, or by the cases
beside it. `tests/stability/stability.py PROGRAM --full --write` writes the file and this page.

The last two columns of the table are the largest error over the allowed error, first of answers without a warning,
then of answers with one. Most warnings are of the numbers of a case, not of its answer: moduli of 1 with loads of the
same order strain a part by tens of per cent (W507, W508), a crack starts just below a surface (W345), a contact pairs
what another pairs already (W354), or a part that touches nothing is mounted (W571).

"""


def record(name, row):
    """A row of the table, as words."""
    def cell(value):
        return "" if value is None else f"{value:.6g}"
    return {"family": name, "case": row.case, "outcome": row.outcome, "message": row.words, "found": cell(row.number),
            "reference": cell(row.reference), "error": cell(row.error), "allowed": cell(row.allowed),
            "seconds": f"{row.seconds:.2f}", "passed": "1" if row.ok else "0"}


def largest_share(rows):
    """The largest error over what is allowed; empty where no row has both."""
    shares = [float(r["error"]) / float(r["allowed"]) for r in rows if r["error"] and r["allowed"]]
    return f"{max(shares):.2f}" if shares else ""


def slug(heading):
    """The anchor of a heading."""
    return "".join(c for c in heading.lower().replace(" ", "-") if c.isalnum() or c in "-_")


def summary_line(name, rows):
    heading = f"{name}: {FAMILIES[name][0]}"
    by = {outcome: [r for r in rows if r["outcome"] == outcome] for outcome in ("answer", "warned answer", "refusal")}
    wrong = sum(r["passed"] != "1" for r in rows)
    cells = [f"[{heading}](#{slug(heading)})", f"{len(rows)}" + (f", **{wrong} wrong**" if wrong else ""),
             *(str(len(part)) for part in by.values()), largest_share(by["answer"]), largest_share(by["warned answer"])]
    return "| " + " | ".join(cells) + " |\n"


def page_of(records):
    """The page of all records of the table."""
    families = {name: [r for r in records if r["family"] == name] for name in FAMILIES}
    families = {name: rows for name, rows in families.items() if rows}
    table = ("| family | cases | answers | answers with a warning | refusals | error / allowed | with a warning |\n"
             "|---|---:|---:|---:|---:|---:|---:|\n") + "".join(summary_line(*item) for item in families.items())
    sections = "".join(f"\n## {name}: {FAMILIES[name][0]}\n\n{FAMILIES[name][1]}\n" for name in families)
    return HEAD + table + sections


def write(records):
    """Puts the families of these records into table and page, beside those that are there, in the order of FAMILIES."""
    new = {r["family"] for r in records}
    kept = [r for r in numbers(TABLE) if r["family"] not in new] if TABLE.exists() else []
    every = [r for name in FAMILIES for r in kept + records if r["family"] == name]
    text = io.StringIO()
    out = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    out.writeheader()
    out.writerows(every)
    TABLE.write_text(text.getvalue(), encoding="utf-8")
    PAGE.write_text(page_of(every), encoding="utf-8")
