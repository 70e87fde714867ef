# SPDX-License-Identifier: GPL-3.0-or-later
"""The finite shift of the virtual crack extension against the analytic derivative (benchmark S06)."""
from program import Row, Run, changed, ending, text_of, without_checks

LENGTHS = """  (0.2*W) (0.3*W) (0.4*W) (0.5*W) (0.6*W) (0.7*W) (0.8*W) (0.9*W) (0.95*W)
"""


def edge():
    """F01, a/W = 0.5."""
    text = changed(text_of("edge_crack"), (LENGTHS, "  (0.5*W)\n"))
    return text, "C1", "C1", "TENSION", "F01"


def slant():
    """F04, 45 degrees."""
    text = text_of("slant_crack")
    text = text[:text.index("$SWEEP")] + "$END\n"
    return text, "C", "C.2", "PULL", "F04"


def lug():
    """The lug with cracks on both sides, a = 10.8, press fit and load."""
    text = changed(text_of("lug_double"),
                   ("  (0.05*R) (0.10*R) (0.20*R) (0.30*R) (0.50*R) (0.80*R)\n", "  (0.30*R)\n"))
    return text, "TOP", "TOP", "LOAD", "lug"


def allowed(shift):
    """Shift squared, times what the first rings are larger than the tip element; from 1e-3 on none."""
    return {1e-1: 2e-2, 1e-2: 1e-3}.get(shift, 1e-5)


def shifts(program, full):
    """K1 by every shift: within what is allowed of the analytic one, or with a warning."""
    rows = []
    for deck in (edge, slant) + ((lug,) if full else ()):
        text, crack, tip, step, name = deck()
        text = without_checks(text)
        plain = Run(program, text)
        reference = plain.stress_intensity()[step, tip]
        exponents = range(1, 13) if full else (1, 3, 7, 12)
        for exponent in exponents:
            run = Run(program, ending(text, f"$VCE CRACK={crack} SHIFT=1e-{exponent}"))
            found = run.stress_intensity()[step, tip] if run.code == 0 else None
            row = Row("S06", f"{name}, shift 1e-{exponent} of the tip element", run, number=found,
                      reference=reference, allowed=allowed(10.0 ** -exponent))
            said = any("finite shift" in words for _, words in run.warnings())
            row.ok = row.error is not None and (row.error <= row.allowed or (said and row.error <= 2e-2))
            row.ok = row.ok and (said or row.error <= 1e-5)  # without a word only where it is right
            rows.append(row)
    return rows
