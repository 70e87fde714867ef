#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws manual/work_precision_solid.svg from manual/work_precision_solid.csv: error of pressure and of
the bore's displacement of the solid lug against CPU time, by program.

    tests/bench/solid_chart.py
"""
import csv
import pathlib

import chart

MANUAL = pathlib.Path(__file__).resolve().parents[2] / "manual"
chart.COLOURS.update({"ccx surface to surface": "#c2571a", "ccx mortar": "#8a2be2"})


def main():
    with open(MANUAL / "work_precision_solid.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    panels = []
    for title, column in (("bush, pressure under load", "p_load_bush"),
                          ("bush, pressure of the fit", "p_press_bush"),
                          ("bore, displacement by the fit", "u_press")):
        panel = chart.Panel(title, "CPU  [s]", "error  [%]")
        for row in rows:
            panel.curves.setdefault(row["program"], []).append(
                (float(row["cpu_s"]), abs(float(row[column]))))
        panels.append(panel)
    chart.sheet(MANUAL / "work_precision_solid.svg", [panels])


if __name__ == "__main__":
    main()
