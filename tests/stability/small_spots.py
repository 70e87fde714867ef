#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact spots of few elements between solids are told.

    tests/stability/small_spots.py PROGRAM
"""
import re
import sys

from program import Run, text_of


def spots_told(program):
    """A sphere on a half space (Hertz, 1882): where the largest pressure is off by more than a tenth W507 says that few
    elements lie across the spot, and by how much; where it is not, no word."""
    good = True
    for elements, told in ((0.6, True), (1.7, False)):
        run = Run(program, text_of("hertz_sphere_solid"), [f"n={elements}"])
        told_off = re.search(r"W507.*only [\d.]+ elements lie across the spot.*off by (\d+) %", run.messages)
        found = re.search(r"CPRESS\.MAX\(HERTZ,PRESS\)\s+\S+\s+\S+\s+([-+\d.]+) %", run.listing())
        off = abs(float(found.group(1)))
        print(f"sphere, {elements} elements in the radius: largest pressure off by {off:.1f} %, {'told' if told_off else 'no word'}")
        good = good and bool(told_off) == told and off < (float(told_off.group(1)) if told_off else 10.0)
    return good


if __name__ == "__main__":
    sys.exit(0 if spots_told(sys.argv[1]) else 1)
