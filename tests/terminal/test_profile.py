# SPDX-License-Identifier: GPL-3.0-or-later
"""run --profile: what it prints, the two files it leaves, and that it changes no result."""

import csv
import json

from program import CRACKED, TOP, ProgramTest, content_without_cost, main, plate

def rows_of(file):
    lines = file.read_text(encoding="utf-8").splitlines()
    assert lines[0].startswith("#"), lines[0]
    return list(csv.DictReader(lines[1:]))


class Profile(ProgramTest):
    def profiled(self, text, *more):
        deck = self.deck(text)
        result = self.expect(0, "run", deck, "--profile", "--out", "profiled", *more)
        return result, self.folder / "profiled"

    def check_trace(self, file):
        """Valid, in the run, and on each thread one within another or one after another, exactly: a viewer orders ends and
        beginnings by their sums."""
        events = json.loads(file.read_text(encoding="utf-8"))["traceEvents"]
        complete = [e for e in events if e["ph"] == "X"]
        for event in complete:
            self.assertGreaterEqual(event["ts"], 0.0)
            self.assertGreaterEqual(event["dur"], 0.0)
            self.assertIsInstance(event["args"], dict)
        for track in {(e["pid"], e["tid"]) for e in complete}:
            here = [e for e in complete if (e["pid"], e["tid"]) == track]
            here.sort(key=lambda e: (e["ts"], -e["dur"]))
            open_ends = []
            for event in here:
                end = event["ts"] + event["dur"]
                while open_ends and open_ends[-1] <= event["ts"]:
                    open_ends.pop()
                if open_ends:
                    self.assertLessEqual(end, open_ends[-1], event)
                open_ends.append(end)
        return complete

    def test_a_crack_that_grows_by_given_lengths(self):
        result, folder = self.profiled(CRACKED)
        for word in ("Profile by processor", "TOPOLOGY", "STIFFNESS", "CONDENSE", "MESHER", "VCE", "ADJOINT",
                     "OUTPUT", "not accounted for", "Nets", "Crack lengths", "The floor", "The run took"):
            self.assertIn(word, result.stdout)
        rows = rows_of(folder / "profile.csv")
        lengths = [row for row in rows if row["kind"] == "length"]
        self.assertEqual([float(row["a"]) for row in lengths], [1, 1.5, 2])
        self.assertEqual(lengths[0]["name"], "increment 1")
        nets = [row for row in rows if row["kind"] == "net"]
        self.assertTrue(nets)
        for net in nets:
            self.assertGreater(int(net["freedoms"]), 0)
            self.assertEqual(int(net["condensed"]) + int(net["reused"]), 1)
        (floor,) = (row for row in rows if row["kind"] == "floor")
        self.assertGreater(float(floor["flops"]), 0.0)
        self.assertEqual(floor["why"], "")
        complete = self.check_trace(folder / "trace.json")
        names = {event["name"] for event in complete}
        self.assertLessEqual({"run", "DECK", "TOPOLOGY", "CONTACT", "increment 3, a = 2"}, names)

    def test_a_lug_with_its_nets_that_grows_by_a_law(self):
        # Nets beside each other on two threads, contact between them, a rest that is condensed once.
        self.expect(0, "run", TOP / "decks" / "lug_life.deck", "--profile", "--out", "life", "--threads", "2")
        rows = rows_of(self.folder / "life" / "profile.csv")
        processors = {row["name"] for row in rows if row["kind"] == "processor"}
        self.assertLessEqual({"DECK", "MESHER", "STIFFNESS", "CONDENSE", "CONTACT", "GROW"}, processors)
        nets = [row for row in rows if row["kind"] == "net"]
        self.assertGreater(len({row["name"] for row in nets}), 2)
        self.assertIn("1", [row["reused"] for row in nets])
        stations = [row for row in rows if row["kind"] == "length"]
        self.assertGreater(len(stations), 2)
        self.assertEqual([row["length"] for row in stations], [str(i + 1) for i in range(len(stations))])
        complete = self.check_trace(self.folder / "life" / "trace.json")
        self.assertIn(2, {event["pid"] for event in complete})  # the mesher

    def test_rows_add_up_to_the_run(self):
        _, folder = self.profiled(CRACKED)
        rows = rows_of(folder / "profile.csv")
        (whole,) = (row for row in rows if row["kind"] == "all")
        parts = [row for row in rows if row["kind"] == "processor"]
        self.assertIn("not accounted for", [row["name"] for row in parts])
        for column in ("cpu", "wall"):
            total = sum(float(row[column]) for row in parts)
            self.assertAlmostEqual(total, float(whole[column]), delta=1e-6 * float(whole[column]))
        self.assertAlmostEqual(sum(float(row["share"]) for row in parts), 1.0, places=6)
        written = sum(file.stat().st_size for file in folder.iterdir()
                      if file.name not in ("profile.csv", "trace.json", ".spricka"))
        self.assertEqual(int(whole["bytes_written"]), written)
        self.assertEqual(int(whole["bytes_read"]), (self.folder / "test.deck").stat().st_size)

    def test_what_is_not_counted_is_unknown_and_not_nothing(self):
        result, folder = self.profiled(CRACKED)
        (line,) = (l for l in result.stdout.splitlines() if l.strip().startswith("ADJOINT"))
        self.assertIn("unknown", line)
        for row in rows_of(folder / "profile.csv"):
            if row["name"] in ("ADJOINT", "MESHER", "OUTPUT"):
                self.assertEqual(row["flops"], "")

    def test_no_result_depends_on_it(self):
        deck = self.deck(CRACKED)
        self.expect(0, "run", deck, "--out", "plain")
        self.expect(0, "run", deck, "--out", "profiled", "--profile", "--threads", "2")
        plain = {file.name: content_without_cost(file) for file in (self.folder / "plain").iterdir()}
        profiled = {file.name: content_without_cost(file) for file in (self.folder / "profiled").iterdir()}
        self.assertEqual(set(profiled) - set(plain), {"profile.csv", "trace.json"})
        for name, content in plain.items():
            if name not in ("listing.txt", ".spricka"):  # times, and the names of the two files
                self.assertEqual(content, profiled[name], name)

    def test_quiet_writes_the_files_alone(self):
        result, folder = self.profiled(plate(), "--quiet")
        self.assertEqual(result.stdout, "")
        self.assertTrue((folder / "profile.csv").exists())
        self.check_trace(folder / "trace.json")

    def test_the_next_run_without_it_leaves_none(self):
        _, folder = self.profiled(plate())
        self.expect(0, "run", "test.deck", "--out", "profiled")
        self.assertFalse((folder / "profile.csv").exists())
        self.assertFalse((folder / "trace.json").exists())

    def test_each_point_of_a_sweep_has_its_own(self):
        text = plate("$SWEEP PARAMETER=n\n  2  3\n").replace("$MESH", "$PARAMETER\n  n = 1\n$MESH", 1)
        result, folder = self.profiled(text.replace("NX=4", "NX=(n)"))
        self.assertNotIn("Profile by processor", result.stdout)
        for point in ("001", "002"):
            rows = rows_of(folder / point / "profile.csv")
            self.assertIn("DECK", [row["name"] for row in rows])
            self.check_trace(folder / point / "trace.json")


if __name__ == "__main__":
    main()
