# SPDX-License-Identifier: GPL-3.0-or-later
"""S02 no penalty, S03 clearance to interference, S07 contrast and units, C07 load."""
import math
import re

from program import Row, Run, asking, changed, difference, ending, text_of, without_checks

DEGREE = math.pi / 180.0


def no_penalty(program, full):
    """Settings and threads change nothing: there is no penalty to choose."""
    rows = []
    for name, contact, step in (("lame_strain", "OUT2", "PRESS"), ("contact_patch_meshes", "K", "PRESS"),
                                ("contact_layer", "REST", "PRESS")):
        text = without_checks(text_of(name))
        first = Run(program, text)
        plain = first.column(contact, step)
        for control in ("MAXITER=1", "MAXITER=3", "MAXITER=1000", "THREADS=2") if full else ("MAXITER=1",):
            run = Run(program, ending(text, f"$CONTROL {control}"))
            error = difference(run.column(contact, step), plain) if run.code == 0 else None
            rows.append(Row("S02", f"{name}, {control}", run, number=error, reference=0.0, allowed=1e-12,
                            error=error))
    return rows


def pin(dR):
    """The pin of decks/pin_in_hole.deck with clearance dR, below 0 interference; R = Q = 1, run with E = 1."""
    text = text_of("pin_in_hole")
    if dR < 0.0:
        text = changed(text, ("GAP=(dR/E)", f"INTERFERENCE=({-dR:.17g}/E)"))
    else:
        text = changed(text, ("dR = 0 ", f"dR = {dR:.17g} "))
    return asking(text, "ARC.TO(FIT,ONE)", "CPRESS.MAX(FIT,ONE)")


def clearance(program, full):
    """Clearance through zero into interference: the half angle goes on without a step."""
    some = [1.0, 1e-1, 1e-6, 0.0, -1e-6, -1e-1]
    sizes = [10.0**-k for k in range(13)]
    all_of_them = sizes + [0.0] + [-s for s in reversed(sizes[1:])]
    known = {1.0: 60.92, 0.1: 80.91, 0.01: 84.39, 0.0: 84.80}
    rows, angle = [], {}
    size = ["E=1"] if full else ["E=1", "n=0.5"]
    for dR in all_of_them if full else some:
        run = Run(program, pin(dR), size)
        if run.code != 0:
            rows.append(Row("S03", f"E dR/Q = {dR:g}", run, ok=False))
            continue
        angle[dR] = run.asked("ARC.TO") / DEGREE
        rising = all(angle[dR] >= other - 1e-4 for other in angle.values())
        quick = run.iterations("FIT", "ONE") <= 25
        reference = known.get(dR, angle.get(0.0) if abs(dR) <= 1e-6 else None)
        allowed = 0.3 if dR in known else 0.05
        error = None if reference is None else abs(angle[dR] - reference)
        rows.append(Row("S03", f"E dR/Q = {dR:g}", run, number=angle[dR], reference=reference,
                        allowed=allowed, error=error,
                        ok=rising and quick and (error is None or error <= allowed)))
    run = Run(program, asking(changed(text_of("pin_in_hole"), ("TYPE=QUAMC8", "TYPE=QUAM4")),
                              "ARC.TO(FIT,ONE)"))
    found = run.asked("ARC.TO") / DEGREE
    rows.append(Row("S03", "E dR/Q = 0, linear edges", run, number=found, reference=84.80, allowed=0.6,
                    error=abs(found - 84.80)))
    return rows


def load_independence(program, _full):
    """C07: the arc of a net fit is the same to the last node for loads 1e-6, 1 and 1e6 and reversed."""
    run = Run(program, without_checks(text_of("pin_in_hole")))
    one = run.column("FIT", "ONE")
    rows = []
    for step, factor in (("TINY", 1e-6), ("HUGE", 1e6)):
        error = difference([p / factor for p in run.column("FIT", step)], one)
        rows.append(Row("C07", f"net fit, load {factor:g}", run, number=error, reference=0.0, allowed=1e-9,
                        error=error))
    error = difference(list(reversed(run.column("FIT", "BACK"))), one)
    rows.append(Row("C07", "net fit, load reversed", run, number=error, reference=0.0, allowed=1e-6,
                    error=error))
    return rows


def lame(stiffness):
    """Pressure of C05 (i) in plane stress: shaft 20 in ring 20 to 40, interference 0.02."""
    (E1, n1), (E2, n2) = stiffness
    return 0.02 / 20.0 / ((1.0 - n1) / E1 + ((40.0**2 + 20.0**2) / (40.0**2 - 20.0**2) + n2) / E2)


def rings_A(E_in, E_out):
    """Interface pressure of C02 A: rings 0.5 to 1 and 1 to 2, outer pressure 1, plane stress, nu 0.3."""
    def unit(a, b, p_in, p_out, r, E):
        A = (p_in * a * a - p_out * b * b) / (b * b - a * a)
        B = (p_in - p_out) * a * a * b * b / (b * b - a * a)
        return ((1.0 - 0.3) * A * r + (1.0 + 0.3) * B / r) / E
    give = unit(1.0, 2.0, 0.0, 1.0, 1.0, E_out)
    return give / (unit(0.5, 1.0, 0.0, 1.0, 1.0, E_in) - unit(1.0, 2.0, 1.0, 0.0, 1.0, E_out))


def contrast(program, full):
    """S07: one body a million times stiffer or softer."""
    rows = []
    text = without_checks(text_of("lame_press_fit"))
    factors = [10.0**k for k in (range(-6, 7, 2) if full else (-6, 6))]
    for f in factors:
        run = Run(program, asking(changed(text, ("E=210e3 ", f"E={210e3 * f:g} ")), "CPRESS.MIN(FIT1,PRESS)",
                                  "CPRESS.MAX(FIT1,PRESS)"))
        reference = lame(((210e3 * f, 0.3), (70e3, 0.33)))
        for which in ("MIN", "MAX"):
            found = run.asked(f"CPRESS.{which}") if run.code == 0 else None
            rows.append(Row("S07", f"C05 (i), E of the shaft x {f:g}, {which}", run, number=found,
                            reference=reference, allowed=1e-3))
    rings = without_checks(text_of("contact_rings"))
    for body in ("IN", "OUT"):
        for f in factors:
            text = changed(rings, (f"ESET={body}.BODY ", f"ESET={body}.BODY "),
                           ("$MATERIAL NAME=UNIT E=5000 NU=0.3", "$MATERIAL NAME=UNIT E=5000 NU=0.3\n"
                            f"$MATERIAL NAME=OTHER E={5000 * f:g} NU=0.3"))
            for end in ("", "160", "GEO"):
                line = f"$PROPERTY ESET={body}{end}.BODY"
                at = text.index(line)
                text = text[:at] + text[at:].replace("MATERIAL=UNIT", "MATERIAL=OTHER", 1)
            run = Run(program, asking(text, "CPRESS.MIN(FEW,A)", "CPRESS.MAX(FEW,A)"))
            reference = rings_A(f, 1.0) if body == "IN" else rings_A(1.0, f)
            for which in ("MIN", "MAX"):
                found = run.asked(f"CPRESS.{which}") if run.code == 0 else None
                rows.append(Row("S07", f"C02 A, E of ring {body} x {f:g}, {which}", run, number=found,
                                reference=reference, allowed=2e-3))
    return rows + rigid_limit(program, full) + units(program)


def rigid_limit(program, full):
    """C06 with a pin ever stiffer: pressure and angle come to rest by 1e4."""
    rows, last = [], None
    for f in (1e2, 1e4, 1e6) if full else (1e4, 1e6):
        text = asking(changed(text_of("pin_in_hole"), ("E1 = 1 ", f"E1 = {f:g} ")), "CPRESS.MAX(FIT,ONE)",
                      "ARC.TO(FIT,ONE)")
        run = Run(program, text, [] if full else ["n=0.5"])
        found = run.asked("CPRESS.MAX")
        settled = last is not None and f > 1e4
        rows.append(Row("S07", f"C06 net fit, pin x {f:g}, pressure", run, number=found,
                        reference=last if settled else None, allowed=1e-3 if settled else None,
                        ok=None if settled else True))
        last = found
    return rows


def units(program):
    """The same press fit in other units: Pa or GPa, mm or m."""
    text = without_checks(text_of("lame_press_fit"))
    plain = Run(program, text).column("FIT1", "PRESS")
    rows = []
    for words, stress, length in (("LENGTH=m FORCE=N", 1e6, 1e-3), ("LENGTH=mm FORCE=kN", 1e-3, 1.0),
                                  ("LENGTH=in FORCE=lbf", 0.0254**2 * 1e6 / 4.4482216152605, 1.0 / 25.4)):
        run = Run(program, in_units(text, words, stress, length))
        error = difference([p / stress for p in run.column("FIT1", "PRESS")], plain) if run.code == 0 else None
        rows.append(Row("S07", f"C05 in {words}", run, number=error, reference=0.0, allowed=1e-9, error=error))
    return rows


def in_units(text, words, stress, length):
    """decks/lame_press_fit.deck in other units: one of its own is `stress`, `length` of those."""

    def scaled(match):
        return f"{match.group(1)}{float(match.group(2)) * length:.17g}"

    text = changed(text, ("LENGTH=mm FORCE=N", words))
    text = re.sub(r"(\b(?:RI|RO|X0|THICK|INTERFERENCE|DIAMETRAL|GAP)=)(-?[0-9.]+)", scaled, text)
    return re.sub(r"( E=)([0-9.e]+)", lambda m: f"{m.group(1)}{float(m.group(2)) * stress:.17g}", text)


def law_error(places, found, exact):
    """L2 norm of found - exact over that of exact, trapezes between `places`."""
    def norm(values):
        return math.sqrt(sum(0.5 * (a * a + b * b) * (t - s) for s, t, a, b in
                             zip(places, places[1:], values, values[1:])))
    wanted = [exact(s) for s in places]
    return norm([f - w for f, w in zip(found, wanted)]) / norm(wanted)


def pressure_laws(program, full):
    """Pressures along the surface against closed forms, L2."""
    rows = []
    a = math.sqrt(4.0 * 500.0 * 10.0 / (math.pi * 210000.0 / (1.0 - 0.09) / 2.0))
    peak = 2.0 * 500.0 / (math.pi * a)
    for n, elements, allowed in ((1.0, 24, 0.02), (0.5, 12, 0.04), (2.0, 47, 0.01)) if full else ((1.0, 24, 0.02),):
        run = Run(program, without_checks(text_of("hertz_line")), [f"n={n}"])
        part = [r for r in run.pressures("LINE", "PRESS") if float(r["x"]) < 1.2 * a]
        error = law_error([float(r["x"]) for r in part], [float(r["p_lumped"]) for r in part],
                          lambda x: peak * math.sqrt(max(0.0, 1.0 - (x / a) ** 2)))
        rows.append(Row("LAW", f"C03 Hertz, {elements} elements over the half width", run, number=error,
                        reference=0.0, allowed=allowed, error=error))
    run = Run(program, without_checks(text_of("lame_strain")))
    points = run.pressures("FITC", "PRESS")
    error = law_error([-math.radians(float(r["theta"])) for r in points],
                      [float(r["p_lumped"]) for r in points], lambda _: 25.080902)
    rows.append(Row("LAW", "Lame, triangles of 6 mm, plane strain", run, number=error, reference=0.0,
                    allowed=2e-3, error=error))
    for n, allowed in ((1, 2e-3), (4, 1e-4)) if full else ((1, 2e-3),):
        run = Run(program, without_checks(text_of("contact_rings")), [f"n={n}"])
        for contact in ("FEW", "GEO"):
            for step, wanted in (("A", 0.8), ("B", 0.2)):
                points = run.pressures(contact, step)
                error = law_error([math.radians(float(r["theta"])) for r in points],
                                  [float(r["p_lumped"]) for r in points], lambda _, w=wanted: w)
                around = (16 if contact == "FEW" else 60) * n
                rows.append(Row("LAW", f"C02 {step}, pair {contact}, {around} elements round", run,
                                number=error, reference=0.0, allowed=allowed, error=error))
    return rows
