# SPDX-License-Identifier: GPL-3.0-or-later
"""S04: friction from zero to far beyond one."""
import math

from program import Row, Run, asking, changed, numbers, text_of, without_checks


def law_broken(run, mu):
    """Largest |q| - mu p of the pressures that the solution carries, over the largest of them."""
    rows = [(abs(float(r["q_consistent"])), float(r["p_consistent"]))
            for r in numbers(run.out / "pressure.csv") if r["q_consistent"]]
    top = max((p for _, p in rows), default=0.0) or 1.0
    return max((q - mu * p for q, p in rows), default=math.inf) / top


def cattaneo(program, full):
    """Sticking half width over contact half width, c/a = sqrt(1 - Q/(mu P)), for Q = mu P / 2 and for
    other parts of it."""
    rows = []
    a = math.sqrt(4.0 * 500.0 * 10.0 / (math.pi * 210000.0 / (2.0 * (1.0 - 0.09))))
    cases = [(0.5, 0.5)]
    if full:
        cases += [(mu, 0.5) for mu in (0.1, 0.3, 0.8)] + [(0.5, part) for part in (0.2, 0.8)]
    for mu, part in cases:
        text = changed(text_of("cattaneo"), ("mu = 0.5", f"mu = {mu}"),
                       ("Q  = 0.5*mu*P", f"Q  = {part}*mu*P"))
        run = Run(program, asking(text, "STICK.FROM(C,ASIDE)", "STICK.TO(C,ASIDE)"))
        found = reference = None
        if run.code == 0:
            found = 0.5 * (run.asked("STICK.TO") - run.asked("STICK.FROM")) * 20.0 / a
            reference = math.sqrt(1.0 - part)
        rows.append(Row("S04", f"C10, mu = {mu}, Q = {part} mu P: c/a", run, number=found, reference=reference,
                        allowed=0.01, error=None if found is None else abs(found - reference)))
    return rows


def block(program, full):
    """C12: what holds is an answer, what slides a refusal that names the block."""
    rows = []
    cases = [("T=3.96", True), ("T=4.04", False), ("slope=0.58", True), ("slope=0.57", False)]
    if full:
        cases += [("mu=1.2", True), ("mu=0.39", False), ("slope=2", True), ("T=0", True)]
    for definition, holds in cases:
        run = Run(program, without_checks(text_of("friction_block")), [definition])
        named = run.code == 4 and ("slides" in run.messages or "not held" in run.messages)
        rows.append(Row("S04", f"C12, {definition}", run, ok=run.code == 0 if holds else named))
    return rows


def lug(program, full):
    """The lug, pressed and loaded: without friction the limit, halved steps, the law never broken."""
    rows = []
    plain = Run(program, without_checks(text_of("lug_friction")), ["mu=0"])
    limit = plain.stress_intensity()[("LOAD", "TOP")]
    rows.append(Row("S04", "lug, mu = 0: frictionless K1", plain, number=limit, reference=630.62, allowed=0.001))
    for mu in (0.001, 0.1, 0.3, 0.5, 0.8, 1.0, 1.2, 2.0) if full else (0.3,):
        run = Run(program, without_checks(text_of("lug_friction")), [f"mu={mu}"])
        if run.code != 0:
            rows.append(Row("S04", f"lug, mu = {mu}", run, ok=run.code == 5))
            continue
        K = run.stress_intensity()[("LOAD", "TOP")]
        kept = law_broken(run, mu) <= 1e-6
        if mu <= 0.001:
            rows.append(Row("S04", f"lug, mu = {mu}: near frictionless", run, number=K, reference=limit,
                            allowed=mu, ok=kept and abs(K / limit - 1.0) <= mu))
            continue
        half = Run(program, without_checks(text_of("lug_friction")), [f"mu={mu}", "k=2"])
        if half.code != 0:
            rows.append(Row("S04", f"lug, mu = {mu}, steps halved", half, ok=half.code == 5))
            continue
        finer = half.stress_intensity()
        change = max(abs(value - finer[key]) for key, value in run.stress_intensity().items()) / K
        rows.append(Row("S04", f"lug, mu = {mu}: change of K1 over all steps when halved", run,
                        number=change, reference=0.0, allowed=0.002, error=change, ok=kept and change <= 0.002))
    return rows


def friction(program, full):
    return cattaneo(program, full) + block(program, full) + lug(program, full)
