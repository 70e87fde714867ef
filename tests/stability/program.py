# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs decks, whole or changed, and reads what a run leaves behind."""
import csv
import pathlib
import re
import subprocess
import tempfile
import time

TOP = pathlib.Path(__file__).resolve().parents[2]
DECKS = TOP / "decks"
OWN = pathlib.Path(__file__).resolve().parent / "decks"


def text_of(name):
    """The deck `name` of decks/ or of this folder."""
    own = OWN / f"{name}.deck"
    return (own if own.exists() else DECKS / f"{name}.deck").read_text(encoding="utf-8")


def changed(text, *pairs):
    """`text` with each (old, new) replaced; an old text that is not there is a mistake."""
    for old, new in pairs:
        if old not in text:
            raise ValueError(f"not in the deck: {old}")
        text = text.replace(old, new)
    return text


def without_checks(text):
    """The deck without $CHECK, so that its exit code speaks of the solution only."""
    return re.sub(r"^\$CHECK.*?(?=^\$)", "", text, flags=re.M | re.S)


def ending(text, cards):
    """The deck with `cards` before its last one."""
    return re.sub(r"^\$END$", lambda _: f"{cards}\n$END", text, flags=re.M)


def asking(text, *quantities):
    """The deck with a $CHECK that always holds for each quantity: the listing then has it."""
    lines = "\n".join(f"  {q} = 0  ABS 1e99" for q in quantities)
    return ending(without_checks(text), f"$CHECK\n{lines}")


def numbers(path):
    """Rows of a CSV file by column names, units left out."""
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


class Run:
    """One run of a deck: exit code, messages, tables."""

    def __init__(self, program, text, definitions=(), threads=1, files=None):
        self.folder = tempfile.TemporaryDirectory()
        place = pathlib.Path(self.folder.name)
        for file in list(DECKS.glob("*.geo")) + list(DECKS.glob("*.inc")):
            if file.name in (files or {}):
                (place / file.name).write_text(files[file.name], encoding="utf-8")
            else:
                (place / file.name).symlink_to(file)
        for name, content in (files or {}).items():
            if not (place / name).exists():
                (place / name).write_text(content, encoding="utf-8")
        deck = place / "case.deck"
        deck.write_text(text, encoding="utf-8")
        self.out = place / "out"
        command = [program, "run", str(deck), "--quiet", "--out", str(self.out), "--threads", str(threads)]
        for definition in definitions:
            command += ["-D", definition]
        start = time.monotonic()
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.seconds = time.monotonic() - start
        self.code = done.returncode
        self.messages = done.stderr

    def listing(self):
        path = self.out / "listing.txt"
        return path.read_text(encoding="utf-8") if path.exists() else ""

    def notes(self):
        return [line for line in self.listing().splitlines() if line.startswith("note:")]

    def warnings(self):
        return re.findall(r"warning (W\d+): ?(.*)", self.messages)

    def refusal(self):
        found = re.search(r"error (E\d+): ?(.*)", self.messages)
        return f"{found.group(1)} {found.group(2)}" if found else f"exit {self.code}"

    def outcome(self):
        """answer, warned answer or refusal."""
        if self.code not in (0, 1):
            return "refusal"
        return "warned answer" if self.warnings() else "answer"

    def asked(self, quantity):
        """A quantity of `asking`, six digits."""
        for line in self.listing().splitlines():
            cells = re.split(r"\s{2,}", line.strip())
            if cells[0].startswith(quantity) and len(cells) > 4 and cells[4 + (len(cells) > 5)] in ("passed", "FAILED"):
                return float(cells[1])
        raise ValueError(f"{quantity} is not in the listing:\n{self.messages}")

    def pressures(self, contact, step):
        return [row for row in numbers(self.out / "pressure.csv")
                if row["contact"] == contact and row["step"] == step]

    def column(self, contact, step, name="p_lumped"):
        return [float(row[name]) for row in self.pressures(contact, step)]

    def stress_intensity(self, column="K1"):
        return {(row["step"], row["crack"]): float(row[column])
                for row in numbers(self.out / "k.csv") if row[column]}

    def values(self, file="u.csv"):
        return [float(row["value"]) for row in numbers(self.out / file)]

    def iterations(self, contact, step):
        """Active-set steps of the listing's table of contacts."""
        for line in self.listing().splitlines():
            cells = line.split()
            if cells[:2] == [step, contact] and "/" in cells[2]:
                return int(cells[-1])
        raise ValueError(f"no contact {contact} in step {step}")


class Row:
    """A row of the table: a number against its reference, or a refusal with its words."""

    def __init__(self, sweep, case, run, number=None, reference=None, allowed=None, error=None, ok=None):
        self.sweep, self.case = sweep, case
        self.outcome = run.outcome()
        self.seconds = run.seconds
        self.number, self.reference, self.allowed = number, reference, allowed
        self.error = error
        if error is None and number is not None and reference is not None:
            self.error = abs(number - reference) / (abs(reference) or 1.0)
        self.words = run.refusal() if self.outcome == "refusal" else ""
        self.ok = ok if ok is not None else (self.error is not None and self.error <= allowed)


def difference(a, b):
    """Largest difference of two lists over the largest entry; infinite where they cannot match."""
    if len(a) != len(b) or not a:
        return float("inf")
    scale = max(max(map(abs, a)), max(map(abs, b))) or 1.0
    return max(abs(x - y) for x, y in zip(a, b)) / scale
