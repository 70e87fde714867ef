# SPDX-License-Identifier: GPL-3.0-or-later
"""S10 bodies held by contact only, S11 redundant constraints."""
from program import Row, Run, asking, changed, difference, text_of, without_checks


LUG = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Shaft and sleeve in the lug'
$INCLUDE FILE='lug_model.inc'
$CONTACT NAME=BUSH SLAVE=SLEEVE.OUTER MASTER=LUG.BORE     {bush}
$CONTACT NAME=PIN  SLAVE=SHAFT.OUTER  MASTER=SLEEVE.INNER {pin}
$STEP NAME=LOAD
  LOAD SHAFTLOAD {load}
$END
"""


def answered(sweep, case, run, number, reference, allowed):
    """A row that must be an answer; `number` is asked only of one."""
    found = number() if run.code == 0 else None
    error = None if found is None else abs(found - reference) / (abs(reference) or 1.0)
    return Row(sweep, case, run, number=found, reference=reference, allowed=allowed, error=error,
               ok=error is not None and error <= allowed)


def refused(sweep, case, run, *words):
    """A row that must be refused with these words."""
    said = run.refusal()
    return Row(sweep, case, run, ok=run.code == 4 and all(w in said for w in words))


def floating(program, full):
    """Loaded bodies find their seat, unloaded ones rest with a note, pulled ones are named."""
    rows = []
    cases = [("shaft with clearance 0.01, net fit of the sleeve", "GAP=0", "GAP=0.01", 1),
             ("gaps everywhere", "GAP=0.01", "GAP=0.01", 1),
             ("gaps everywhere, load reversed", "GAP=0.01", "GAP=0.01", -1),
             ("net fits", "GAP=0", "GAP=0", 1)]
    for case, bush, fit, load in cases if full else cases[1:2]:
        run = Run(program, asking(LUG.format(bush=bush, pin=fit, load=load), "SUM(BUSH,LOAD,X)"))
        # the check's six digits; the listing's balance has the rest
        rows.append(answered("S10", case, run, lambda run=run: run.asked("SUM(BUSH"), -97100.0 * load, 1e-6))
    for case, bush, fit in (("net fits, no load", "GAP=0", "GAP=0"),
                            ("gaps everywhere, no load", "GAP=0.01", "GAP=0.01")):
        run = Run(program, LUG.format(bush=bush, pin=fit, load=0))
        largest = max(map(abs, run.column("PIN", "LOAD")), default=1.0) if run.code == 0 else None
        noted = any("rest" in note for note in run.notes())
        rows.append(Row("S10", case + ": zero pressure and a note", run, number=largest, reference=0.0,
                        allowed=1e-9, error=largest, ok=noted and largest is not None and largest <= 1e-9))
    free = changed(without_checks(text_of("contact_layer")), ("  LAYER.XMIN\n", ""))
    load = changed(free, ("LOADED  0  (-P/2)", "LOADED  0  (-P)"),
                   ("FROM=LAYER.YMAX WHERE=(abs(x) < 1e-9)", "FROM=LAYER.YMAX WHERE=(abs(x - 4) < 0.01)"),
                   ("BIAS=8", "BIAS=1"))
    run = Run(program, asking(load, "SUM(REST,PRESS,Y)"))
    rows.append(answered("S10", "layer lying free, a line load in its middle", run,
                         lambda: run.asked("SUM(REST"), 1.0, 1e-6))
    run = Run(program, changed(free, ("LOADED  0  (-P/2)", "LOADED  0  (P/2)")))
    rows.append(refused("S10", "layer pulled up", run, "LAYER", "not held"))
    apart = text_of("apart")
    for case, values, words in (("block pulled off", ["up=1"], ("UPPER", "not held")),
                                ("block pushed aside", ["up=-1", "aside=0.1"], ("UPPER", "not held")),
                                ("block tipped over", ["up=-1", "turn=0.9"], ("UPPER", "not held"))):
        rows.append(refused("S10", case, Run(program, apart, values), *words))
    for case, values, total in (("block pressed", ["up=-1"], 10.0), ("block nearly tipped", ["up=-1", "turn=0.55"], 10.0)):
        run = Run(program, asking(apart, "SUM(FACE,LOAD,Y)"), values)
        rows.append(answered("S10", case, run, lambda run=run, total=total: run.asked("SUM(FACE"), total, 1e-6))
    run = Run(program, apart)
    rows.append(Row("S10", "block let alone: zero pressure and a note", run, number=0.0, reference=0.0,
                    allowed=1e-12, ok=run.code == 0 and any("rest" in n for n in run.notes())
                    and max(map(abs, run.column("FACE", "LOAD"))) == 0.0))
    return rows


def same(program, case, text, plain, contacts, allowed=1e-9):
    """A row: displacements of the deck are those of the irredundant one, pressures add up to its."""
    run = Run(program, text)
    if run.code != 0:
        return Row("S11", case, run, ok=False)
    error = difference(run.values(), plain.values())
    total = [sum(p) for p in zip(*(run.column(c, "PRESS", "p_consistent") for c in contacts))]
    error = max(error, difference(total, plain.column("FACE", "PRESS", "p_consistent")))
    return Row("S11", case, run, number=error, reference=0.0, allowed=allowed, error=error)


def redundant(program, _full):
    """Constraints that say the same twice change nothing; those that contradict are refused."""
    blocks = text_of("blocks")
    plain = Run(program, blocks)
    twice = "$CONTACT NAME=MORE SLAVE=UPPER.YMIN MASTER=LOWER.YMAX\n$LOAD CASE=ALL"
    back = "$CONTACT NAME=MORE SLAVE=LOWER.YMAX MASTER=UPPER.YMIN\n$LOAD CASE=ALL"
    rows = [same(program, "duplicate pairs", changed(blocks, ("$LOAD CASE=ALL", twice)), plain, ["FACE", "MORE"]),
            same(program, "both surfaces slave", changed(blocks, ("$LOAD CASE=ALL", back)), plain,
                 ["FACE", "MORE"]),
            same(program, "three pairs alike", changed(blocks, ("$LOAD CASE=ALL", twice),
                                                       ("$LOAD CASE=ALL", back.replace("MORE", "THIRD"))),
                 plain, ["FACE", "MORE", "THIRD"])]
    bonded = changed(blocks, ("MASTER=LOWER.YMAX", "MASTER=LOWER.YMAX TYPE=BONDED"))
    both = changed(bonded, ("$LOAD CASE=ALL", twice.replace("NAME=MORE", "NAME=MORE TYPE=BONDED")))
    rows.append(same(program, "bonded pair doubled", both, Run(program, bonded), ["FACE", "MORE"]))
    supported = changed(blocks, ("  LOWER.YMIN\n", "  LOWER.YMIN\n  LOWER.YMAX\n"))
    matched = changed(supported, ("$LOAD CASE=ALL", twice))
    rows.append(same(program, "surface on a suppressed line, doubled", matched, Run(program, supported),
                     ["FACE", "MORE"]))
    for name, case, contacts in (("corner", "node in two pairs at a corner", ("DOWN", "SIDE")),
                                 ("tied_surface", "contact node that is a slave of a tie", ("FACE",))):
        run = Run(program, text_of(name))
        found = [p for c in contacts for p in run.column(c, "PRESS")] if run.code == 0 else []
        error = max((abs(p / 1000.0 - 1.0) for p in found), default=None)
        rows.append(Row("S11", f"{case}: patch test", run, number=error, reference=0.0, allowed=1e-9, error=error))
    tied = text_of("tied_surface")
    twice = ("$MPC TYPE=EQUATION\n  1 FINE.20 X  -1 UPPER.1 X\n$MPC TYPE=EQUATION RHS=0.1\n"
             "  1 FINE.20 X  -1 UPPER.1 X\n$FSET NAME=TOP")
    for case, card in (("node tied to faces it does not lie on", "$MPC TYPE=TRANSITION SLAVE=FINE.XMIN "
                        "MASTER=UPPER.XMIN\n$FSET NAME=TOP"),
                       ("slave of two ties that contradict each other", twice)):
        run = Run(program, changed(tied, ("$FSET NAME=TOP", card)))
        rows.append(Row("S11", case, run, ok=run.code in (3, 4) and "E41" in run.refusal()))
    return rows


ASSEMBLY = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Assembly undone'
$INCLUDE FILE='lug_model.inc'
$CONTACT NAME=BUSH SLAVE=SLEEVE.OUTER MASTER=LUG.BORE     DIAMETRAL=0.084
$CONTACT NAME=PIN  SLAVE=SHAFT.OUTER  MASTER=SLEEVE.INNER TYPE=BONDED GAP=0
$STEP NAME=PRESS SUBSTEPS={parts}
  FIT BUSH 1
$STEP NAME=ASSEMBLE
  MOUNT PIN
$STEP NAME=LOAD SUBSTEPS={parts}
  LOAD SHAFTLOAD 1
$STEP NAME=UNLOAD
  LOAD SHAFTLOAD 0
$STEP NAME=APART
  DISMOUNT PIN
$STEP NAME=SECOND
  MOUNT PIN
$STEP NAME=RELOAD
  LOAD SHAFTLOAD 1
$CRACK NAME=TOP NET=LUG A0=(0.3*R) ANGLE=90[deg] STATE=STRESS
  0  (R)
$END
"""


def assembly(program, _full):
    """Sleeve first, shaft mounted, loaded, and all undone: the first state comes back."""
    rows = []
    run = Run(program, ASSEMBLY.format(parts=1))
    if run.code != 0:
        return [Row("ASM", "assembly of the lug", run, ok=False)]
    k = run.stress_intensity("K1_raw")  # what is estimated of its error knows of the parts that are there
    for step, first in (("ASSEMBLE", "PRESS"), ("UNLOAD", "ASSEMBLE"), ("APART", "PRESS"), ("SECOND", "PRESS"),
                        ("RELOAD", "LOAD")):
        error = max(difference(run.column("BUSH", step), run.column("BUSH", first)),
                    abs(k[step, "TOP"] / k[first, "TOP"] - 1.0))
        rows.append(Row("ASM", f"{step} is {first}: pressures and K1", run, number=error, reference=0.0,
                        allowed=1e-10, error=error))
    parts = Run(program, ASSEMBLY.format(parts=7))
    error = difference(parts.column("BUSH", "LOAD"), run.column("BUSH", "LOAD"))
    rows.append(Row("ASM", "fit and load in seven parts", parts, number=error, reference=0.0, allowed=1e-10,
                    error=error))
    return rows
