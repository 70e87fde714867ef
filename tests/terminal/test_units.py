# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks run twice, with and without units of output: all numbers differ by the factors of the units beside them."""

import csv
import html.parser
import json
import re
import tempfile
import unittest
from pathlib import Path

from program import CRACKED, TOP, ProgramTest, main

IN = 25.4  # mm
KSI = 6.894757293168361  # MPa
KIP = 4448.2216152605  # N
KSI_ROOT_IN = KSI * IN**0.5  # MPa mm^0.5
CYCLES = 1000.0  # in a pass of the lug's spectrum

OUT = "OUTK='ksi*sqrt(in)' OUTLENGTH='in' OUTFORCE='kip' OUTSTRESS='ksi' OUTLIFE=KCYCLES"
# Unit of the deck as files write it: what it becomes, and how many of the deck's make one of them.
BECOMES = {
    "mm": ("in", IN),
    "mm^2": ("in^2", IN**2),
    "N": ("kip", KIP),
    "MPa": ("ksi", KSI),
    "MPa*mm^0.5": ("ksi*in^0.5", KSI_ROOT_IN),
    "N*mm": ("kip*in", KIP * IN),
    "N mm": ("kip in", KIP * IN),
    "N/mm": ("kip/in", KIP / IN),
    "pass": ("1000 cycles", 1000.0 / CYCLES),
    "passes": ("thousand cycles", 1000.0 / CYCLES),
    "mm/pass": ("in/pass", IN),
    "mm/cycle": ("in/cycle", IN),
}
# The same as pages print them.
PRINTED = {
    "mm²": "mm^2", "in²": "in^2", "MPa √mm": "MPa*mm^0.5", "ksi √in": "ksi*in^0.5", "N mm": "N*mm", "kip in": "kip*in",
}
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d*)?(?:e[-+]?\d+)?", re.IGNORECASE)

LUG = (TOP / "decks/lug_spectrum.deck").read_text().replace("FILE='lug", f"FILE='{TOP}/decks/lug")
LUG = LUG.replace("$END", """$OUTPUT FILE='asked.csv' FORMAT=CSV EVERY=STEP
  K TOP
  CPRESS PIN
  U LUG.END
  S LUG.END
  REACTION LUG.END
$END""")


def with_output_units(deck, out=OUT):
    return re.sub(r"(\$DECK[^\n]*)", rf"\1\n & {out}", deck, count=1)


def last_place(number):
    """Half a unit of the last digit of a number as it is written."""
    mantissa, _, exponent = number.lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 0.51 * 10.0 ** (int(exponent or 0) - decimals)


class Tables(html.parser.HTMLParser):
    """The tables of a page as lists of rows of texts, the head first; names and units are parted by a tab."""

    def __init__(self, page):
        super().__init__()
        self.tables = []
        self.cell = None
        self.feed(page)

    def handle_starttag(self, tag, attributes):
        if tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in ("td", "th"):
            self.cell = ""
        elif tag == "br" and self.cell is not None:
            self.cell += "\t"

    def handle_endtag(self, tag):
        if tag in ("td", "th"):
            self.tables[-1][-1].append(self.cell)
            self.cell = None

    def handle_data(self, data):
        if self.cell is not None:
            self.cell += data


class OutputUnits(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.runs = None

    def run_twice(self):
        """Folders of the lug in units of the deck and in others, run once for all tests."""
        if OutputUnits.runs is None:
            folder = tempfile.TemporaryDirectory()
            self.addClassCleanup(folder.cleanup)
            runs, OutputUnits.said = [], []
            for name, text in (("deck", LUG), ("other", with_output_units(LUG))):
                runs.append(Path(folder.name) / name)
                done = self.expect(0, "run", self.deck(text, f"{name}.deck"), "--out", runs[-1])
                OutputUnits.said.append(done.stdout)
            OutputUnits.runs = runs
        return OutputUnits.runs

    def texts(self, name):
        return [(run / name).read_text(encoding="utf-8") for run in self.run_twice()]

    def same(self, a, b, factor, where):
        """Two numbers as texts, of which b times factor is a but for their last digits."""
        room = last_place(a) + factor * last_place(b)
        self.assertLessEqual(abs(float(a) - factor * float(b)), room, f"{a} and {b} times {factor}: {where}")

    def exact(self, a, b, factor, where):
        self.assertLessEqual(abs(float(a) - factor * float(b)), 1e-14 * abs(float(a)), f"{a}, {b}: {where}")

    def factor(self, unit, other, where):
        """What makes a number in the other unit one in the unit of the deck."""
        unit, other = PRINTED.get(unit, unit), PRINTED.get(other, other)
        becomes, factor = BECOMES.get(unit, (unit, 1.0))
        self.assertEqual(becomes, other, where)
        return factor

    def columns(self, name, units):
        """All numbers of a CSV file by the units of their columns."""
        one, other = ([line for line in text.splitlines() if line[0] != "#"] for text in self.texts(name))
        rows, others = list(csv.DictReader(one)), list(csv.DictReader(other))
        self.assertEqual(len(rows), len(others))
        self.assertTrue(rows)
        self.assertEqual(rows[0].keys(), others[0].keys())
        for column in rows[0]:
            factor = BECOMES[units[column]][1] if column in units else 1.0
            for a, b in zip(rows, others):
                if column in units and a[column]:
                    self.exact(a[column], b[column], factor, f"{name} {column}")
                else:
                    self.assertEqual(a[column], b[column], f"{name} {column}")

    def test_csv_files_and_their_heads(self):
        K, length, stress = "MPa*mm^0.5", "mm", "MPa"
        ks = {k + end: K for k in ("K1", "K2") for end in ("", "_bar", "_raw", "_eta", "_sum", "_flip")}
        self.columns("k.csv", {**ks, "a": length, "x": length, "y": length, "T": stress, "G": "N/mm", "G_from_K": "N/mm"})
        self.columns("pressure.csv", {"x": length, "y": length, "arc": length, "p_lumped": stress,
                                      "p_consistent": stress})
        self.columns("beta.csv", {"a": length, "K1": K, "K2": K, "beta": stress})
        self.columns("life_curve.csv", {"N": "pass", "a_TOP": length, "N_scaled": "pass", "N_secant": "pass",
                                        "N_line": "pass"})
        self.columns("life.csv", {"N": "pass", "a": length, "K_max": K, "K_min": K, "delta_K": K, "K2_max": K,
                                  "da_dN": "mm/pass", "x": length, "y": length})
        paths = {f"TOP.{k}": K for k in ("K1", "K2", "dK1_before", "dK1_after", "dK2_before", "dK2_after")}
        self.columns("load_path.csv", paths)
        for name, head in (("k.csv", "K1 K2"), ("beta.csv", "K1 K2 [ksi*in^0.5], beta [ksi]"),
                           ("life.csv", "da_dN [in/pass], turn [deg], N [1000 cycles]"),
                           ("life_curve.csv", "N [1000 cycles], a of each tip [in]"),
                           ("load_path.csv", "slopes by t [ksi*in^0.5], from to [deg] on circles, else [in]")):
            self.assertIn(head, self.texts(name)[1].splitlines()[0])

    def test_derivatives_are_over_the_unit_of_their_value(self):
        one, other = (list(csv.DictReader(text.splitlines()[1:])) for text in self.texts("sensitivity.csv"))
        of_value = {"LOAD": 1.0, "FIT": IN, "A": IN, "E": KSI}
        self.assertEqual({row["cause"] for row in one} - of_value.keys(), set())
        for a, b in zip(one, other):
            self.exact(a["value"], b["value"], of_value[a["cause"]], "value")
            for column in ("dK1_below", "dK1_above"):
                if a[column]:
                    self.exact(a[column], b[column], KSI_ROOT_IN / of_value[a["cause"]], column)

    def test_what_the_deck_asks_for(self):
        one, other = (list(csv.DictReader(text.splitlines()[1:])) for text in self.texts("asked.csv"))
        units = {"U": IN, "S": KSI, "REACTION": KIP}
        of_k = {"A": IN, "G": KIP / IN, "T": KSI, "SPREAD": 1.0}
        of_contact = {"GAP": IN, "P_LUMPED": KSI, "P_CONSISTENT": KSI}
        self.assertEqual(len(one), len(other))
        for a, b in zip(one, other):
            quantity, component = a["quantity"], a["component"]
            factor = units.get(quantity) or (of_k if quantity == "K" else of_contact).get(component, KSI_ROOT_IN)
            self.exact(a["value"], b["value"], factor, f"{quantity} {component}")
            if a["x"]:
                self.exact(a["x"], b["x"], IN, "x")

    def test_tables_of_the_report(self):
        one, other = (Tables(text).tables for text in self.texts("report.html"))
        self.assertEqual(len(one), len(other))
        converted = set()
        for table, alike in zip(one, other):
            if table[0][0] == "check":
                continue  # has a column more
            self.assertEqual([len(row) for row in table], [len(row) for row in alike])
            for c, (head, head_there) in enumerate(zip(table[0], alike[0])):
                name, _, unit = head.partition("\t")
                factor = self.factor(unit, head_there.partition("\t")[2], name)
                converted.update({unit} if factor != 1.0 else ())
                for a, b in zip((row[c] for row in table[1:]), (row[c] for row in alike[1:])):
                    self.cell(a, b, factor, name)
        self.assertLessEqual({"mm", "N", "MPa", "MPa √mm", "mm/pass", "N mm"}, converted)

    def cell(self, a, b, factor, where):
        """Numbers of a cell; one with a unit behind it has that one."""
        numbers, alike = list(NUMBER.finditer(a)), list(NUMBER.finditer(b))
        self.assertEqual(len(numbers), len(alike), f"{a} and {b}: {where}")
        for n, m in zip(numbers, alike):
            own = re.match(r" (mm|MPa|N)\b", a[n.end():])
            self.same(n[0], m[0], BECOMES[own[1]][1] if own else factor, f"{where}: {a} and {b}")

    def test_curves_of_the_report(self):
        pieces = r'data-x-name="([^"]*)" data-y-name="([^"]*)"|data-points="([^"]*)"'
        one, other = (re.findall(pieces, text) for text in self.texts("report.html"))
        self.assertEqual(len(one), len(other))
        seen = set()
        x = y = 1.0
        for (x_name, y_name, points), (x_there, y_there, alike) in zip(one, other):
            if x_name or y_name:
                unit = [re.findall(r"\[(.*)\]", name) or [""] for name in (x_name, x_there, y_name, y_there)]
                x, y = self.factor(unit[0][0], unit[1][0], x_name), self.factor(unit[2][0], unit[3][0], y_name)
                seen.update((unit[0][0], unit[2][0]))
                continue
            for a, b in zip(points.split(), alike.split()):
                for number, there, factor in zip(a.split(","), b.split(","), (x, y)):
                    self.same(number, there, factor, f"{x_name} {y_name}")
        self.assertLessEqual({"mm", "MPa √mm", "mm/pass", "passes"}, seen)

    def test_listing_says_both_units_and_the_answer(self):
        plain, listing = self.texts("listing.txt")
        self.assertIn("Units: length in, force kip, stress ksi, K ksi*in^0.5", listing)
        self.assertIn("The deck itself, and with it warnings and notes, are in mm, N, MPa, MPa*mm^0.5.", listing)
        self.assertNotIn("The deck itself", plain)
        ours, theirs = (text[text.index("\nAnswer\n"):text.index("Cost")] for text in (plain, listing))
        for word in ("MPa", " mm", "passes of the spectrum"):
            self.assertIn(word, ours)
            self.assertNotIn(word, theirs.partition("ended by")[0])
        for name in ("TOP", "PIN", "Life"):
            a, b = (re.search(rf"^  {name} +(.*)$", text, re.MULTILINE)[1] for text in (ours, theirs))
            for before, after in (("MPa*mm^0.5", "ksi*in^0.5"), ("MPa", "ksi"), (" mm", " in"),
                                  ("passes of the spectrum", "thousand cycles")):
                a = a.replace(before, after)
            self.assertEqual(*(NUMBER.sub("#", text.partition("; ended")[0]) for text in (a, b)))

    def test_terminal_and_checks(self):
        self.run_twice()
        one, other = OutputUnits.said
        for a, b in zip(one.splitlines(), other.splitlines()):
            for key, factor in (("K1", KSI_ROOT_IN), ("K2", KSI_ROOT_IN), ("a", IN), ("N", 1000.0 / CYCLES)):
                found = [re.search(rf"\b{key} = (\S+)", text) for text in (a, b)]
                self.assertEqual(found[0] is None, found[1] is None)
                if found[0]:
                    self.same(found[0][1], found[1][1], factor, a)
        self.assertIn("thousand cycles, ended by AMAX", other)
        listing = self.texts("listing.txt")[1]
        line = next(line for line in listing.splitlines() if line.lstrip().startswith("LIFE()") and "passed" in line)
        self.assertIn(" 1000 cycles ", line)

    def test_results_for_programs_stay_in_units_of_the_deck(self):
        try:
            import h5py
        except ImportError:
            self.skipTest("h5py is not installed")
        one, other = (h5py.File(run / "results.h5") for run in self.run_twice())
        for table in ("k", "growth.stations", "load_path"):
            self.assertEqual(one[table][()].tobytes(), other[table][()].tobytes(), table)
        for key in ("length_unit", "force_unit", "stress_unit", "K_unit"):
            self.assertEqual(one.attrs[key], other.attrs[key])


class OfChecks(ProgramTest):
    def found(self, deck, *checks):
        """K1 and what else these lines find, as the listing has them, with whether they pass."""
        lines = "".join(f"  {check}\n" for check in checks)
        run = self.folder / "run"
        done = self.run_program("run", self.deck(deck.replace("$END", f"$CHECK\n{lines}$END")), "--out", run)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        listing = (run / "listing.txt").read_text()
        table = listing[listing.index("\nChecks of the deck\n"):].partition("\n\n")[2].splitlines()[1:]
        return [row.split() for row in table[:len(checks)]], done

    def test_a_bare_number_is_in_the_unit_of_output(self):
        rows, _ = self.found(CRACKED, "K1(C,LOAD,2) = 1 REL 0.5", "S.YY.MAX(YMAX,LOAD) = 1 REL 0.5")
        K, stress = float(rows[0][1]), float(rows[1][1])
        deck = with_output_units(CRACKED, "OUTK='MPa*sqrt(m)' OUTSTRESS='ksi'").replace(
            "$MESH", f"$PARAMETER\n  K0 = {K}\n$MESH", 1)
        rows, done = self.found(
            deck,
            f"K1(C,LOAD,2) = {K / 1000.0**0.5:.8g} REL 1e-4",  # in OUTK
            f"K1(C,LOAD,2) = {K}[MPa*mm^0.5] REL 1e-4",  # what it says
            f"K1(C,LOAD,2) = {K / KSI_ROOT_IN:.8g}[ksi*in^0.5] REL 1e-4",
            "K1(C,LOAD,2) = (K0) REL 1e-4",  # made of the deck's numbers
            f"K1(C,LOAD,2) = {K / 1000.0**0.5:.8g} ABS 0.001",
            f"K1(C,LOAD,2) = {K / 1000.0**0.5 + 0.9:.8g} ABS 1",
            f"K1(C,LOAD,2) = {K / 1000.0**0.5 + 0.9:.8g} ABS 1[MPa*mm^0.5]",
            f"K1(C,LOAD,2) = {K:.8g} REL 0.5",
            f"S.YY.MAX(YMAX,LOAD) = {stress / KSI:.8g} REL 1e-4",
        )
        verdicts = ["passed" in row for row in rows]
        self.assertEqual(verdicts, [True] * 6 + [False, False, True], done.stderr)
        for row in rows[:4]:  # found, wanted, unit
            self.assertAlmostEqual(float(row[1]), K / 1000.0**0.5, delta=1e-4)
            self.assertAlmostEqual(float(row[2]), K / 1000.0**0.5, delta=1e-3)
            self.assertEqual(row[3], "MPa*m^0.5")
        self.assertIn("7 of 9 checks passed", done.stdout)
        wrong = f"check failed: K1(C,LOAD,2) = {rows[7][1][:5]}"
        self.assertEqual(done.stderr.count(wrong), 2, done.stderr)

    def test_lives_in_thousands_of_cycles(self):
        deck = CRACKED.replace("$GROW LAW=INCREMENT KMAX=LOAD\n  1  1.5  2\n", """$STEP NAME=ZERO
  LOAD PULL 0
$GROW LAW=PARIS KMAX=LOAD KMIN=ZERO C=1e-12 M=3 AMAX=2 KUNIT='MPa*mm^0.5' AUNIT='mm'
""")
        rows, _ = self.found(deck, "LIFE() = 1 REL 0.5", "N(1.5) = 1 REL 0.5")
        life, to_length = float(rows[0][1]), float(rows[1][1])
        rows, _ = self.found(with_output_units(deck, "OUTLIFE=KCYCLES"), f"LIFE() = {life / 1000:.8g} REL 1e-4",
                             f"N(1.5) = {to_length / 1000:.8g} REL 1e-4", f"LIFE() = ({life}) REL 1e-4")
        self.assertTrue(all("passed" in row for row in rows), rows)

    def test_a_product_has_no_blank(self):
        done = self.run_program("check", self.deck(with_output_units(CRACKED, "OUTK='ksi sqrt(in)'")))
        self.assertEqual(done.returncode, 3)
        self.assertIn("E204: OUTK: 'ksi sqrt(in)' is not a unit", done.stderr)
        self.assertIn("'ksi*in^0.5', without blanks", done.stderr)


class Elsewhere(ProgramTest):
    def test_shell(self):
        out = []
        for deck in (CRACKED, with_output_units(CRACKED)):
            done = self.expect(0, "shell", self.deck(deck), stdin="K1(C,NOW)\nlist K\nstatus\nquit\n")
            out.append(done.stdout)
        a, b = (re.search(r"K1\(C,NOW\) = (\S+) (\S+)", text) for text in out)
        self.assertEqual((a[2], b[2]), ("MPa*mm^0.5", "ksi*in^0.5"))
        self.assertAlmostEqual(float(a[1]) / float(b[1]), KSI_ROOT_IN, delta=1e-7)
        self.assertIn("ksi*in^0.5", out[1].partition("K1(C,NOW)")[2])
        self.assertNotIn("MPa", out[1])

    def test_check_lists_loads_in_them_and_json_in_those_of_the_deck(self):
        one, other = (self.expect(0, "check", self.deck(deck)).stdout
                      for deck in (CRACKED, with_output_units(CRACKED)))
        load = [re.search(r"PULL +(\S+) +(\S+)", text)[2] for text in (one, other)]
        self.same_force(*load)
        one, other = (json.loads(self.expect(0, "check", "--json", self.deck(deck)).stdout)
                      for deck in (CRACKED, with_output_units(CRACKED)))
        self.assertEqual(one["loads"], other["loads"])
        self.assertEqual(other["length_unit"], "mm")

    def same_force(self, newtons, kips):
        self.assertAlmostEqual(float(newtons) / float(kips), KIP, delta=1e-5 * KIP)

    def test_a_sweep(self):
        deck = CRACKED.replace("$MESH", "$PARAMETER\n  f = 1\n$MESH", 1).replace("LOAD PULL 1", "LOAD PULL (f)")
        deck = deck.replace("$END", "$SWEEP PARAMETER=f\n  1 2\n$END")
        tables = []
        for name, text in (("a", deck), ("b", with_output_units(deck))):
            self.expect(0, "run", self.deck(text), "--out", self.folder / name)
            lines = (self.folder / name / "sweep.csv").read_text().splitlines()
            tables.append(list(csv.DictReader(lines[1:])))
        self.assertIn("[ksi*in^0.5]", lines[0])
        for a, b in zip(*tables):
            self.assertAlmostEqual(float(a["K1:C:LOAD:1"]) / float(b["K1:C:LOAD:1"]), KSI_ROOT_IN, delta=1e-9)
            self.assertAlmostEqual(float(a["a:1"]) / float(b["a:1"]), IN, delta=1e-9)

    def test_a_restart_goes_on_in_other_units(self):
        deck = CRACKED.replace("$END", "$RESTART WRITE='state.rst'\n$END")
        self.expect(0, "run", self.deck(deck), "--restart", "--out", self.folder / "run")
        self.expect(0, "run", self.deck(with_output_units(deck)), "--restart", "--out", self.folder / "run")
        self.assertIn("3 of 3 increments taken over", (self.folder / "run" / "listing.txt").read_text())
        self.assertIn("ksi*in^0.5", (self.folder / "run" / "k.csv").read_text().splitlines()[0])


if __name__ == "__main__":
    main()
