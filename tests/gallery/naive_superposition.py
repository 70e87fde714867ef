# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: K of the load without the fit, plus K of the fit without the load."""


def superposed(lug, a):
    """K1 of load alone, of the fit alone, and their sum."""
    load = lug.K1(lug.state(1.0, 0.0)[0], a)[0]
    fit = lug.K1(lug.state(0.0)[0], a)[0]
    return load, fit, load + fit
