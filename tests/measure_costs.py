#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""measure_costs.py [TESTS.XML]: writes costs.txt, what each test takes [s], from the record that
tests/run leaves in build/dev/tests.xml. CTest starts long tests first and labels them by it."""
import sys
import xml.etree.ElementTree as tree
from pathlib import Path

here = Path(__file__).resolve().parent
record = Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent / "build/dev/tests.xml"
costs = {case.get("name"): float(case.get("time")) for case in tree.parse(record).iter("testcase")}
lines = [f"{seconds:.1f} {name}" for name, seconds in sorted(costs.items())]
head = "# seconds and name of each test, measured at its daily size (measure_costs.py)\n"
(here / "costs.txt").write_text(head + "\n".join(lines) + "\n")
print(f"{len(costs)} tests, {sum(costs.values()):.0f} s")
