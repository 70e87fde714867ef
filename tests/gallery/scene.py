# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene of the gallery: rows of naive methods and of spricka, what is asked of each, and its page."""
import textwrap
from dataclasses import dataclass
from pathlib import Path


@dataclass
class Row:
    """One line of a table. `error` is relative unless `unit` says otherwise.

    A naive method must still fail as it did where it was measured, `measured`, within a factor of two, or by
    `at_least`. spricka must be right to `allowed`; rows without an error, and those at its limit, must say
    something (`said`: the words of a warning, a note or a refusal). Other rows, exact or for comparison, are right to
    `allowed`."""
    who: str            # "naive", "spricka" or "other"
    method: str
    value: str
    error: float = None
    measured: float = None
    at_least: float = None
    allowed: float = None
    said: str = ""
    unit: str = "%"
    note: str = ""
    limit: bool = False

    def ok(self):
        if self.who == "naive":
            if self.measured is not None:
                low, high = self.measured if isinstance(self.measured, tuple) else 2 * (self.measured,)
                return 0.5 * abs(low) <= abs(self.error) <= 2.0 * abs(high)
            return self.at_least is None or (self.error is not None and abs(self.error) >= self.at_least)
        if self.error is not None and self.allowed is not None and not self.limit:
            return abs(self.error) <= self.allowed
        return self.who == "other" or bool(self.said)

    def shown(self, value):
        if value is None:
            return ""
        if isinstance(value, tuple):
            unit = f" {self.unit}".rstrip()
            return " to ".join(self.shown(v).removesuffix(unit) for v in value) + unit
        if self.unit != "%":
            return f"{value:.3g} {self.unit}".strip()
        if abs(value) < 5e-6:
            return f"{abs(value):.0e}" if value else "0"
        percent = 100.0 * value
        if abs(percent) >= 1e5:
            return f"{value:.0e} times"
        form = "+.2g" if abs(percent) < 9.95 else "+.1f" if abs(percent) < 1000 else "+.0f"
        return f"{percent:{form}} %"

    def cells(self):
        # measured figures are sizes where they have no sign
        measured = self.shown(self.measured).replace("+", "")
        return [self.method, self.value, self.shown(self.error), measured, self.said or self.note]


def folded(text):
    return textwrap.fill(text, 110, break_long_words=False, break_on_hyphens=False)


HEADS = ["method", "answer", "error", "measured before", "remark"]


@dataclass
class Table:
    caption: str
    rows: list
    heads: list = None

    def text(self):
        heads = self.heads or HEADS
        cells = [row.cells() for row in self.rows]
        keep = [i for i in range(len(heads)) if any(c[i] for c in cells)]
        lines = [folded(self.caption), ""] if self.caption else []
        lines += ["| " + " | ".join(heads[i] for i in keep) + " |", "|" + "---|" * len(keep)]
        for row, line in zip(self.rows, cells):
            words = [line[i] for i in keep]
            if row.who == "spricka":
                words = [f"**{w}**" if i == 0 else w for i, w in enumerate(words)]
            lines.append("| " + " | ".join(words) + " |")
        return "\n".join(lines) + "\n"


@dataclass
class Scene:
    """What a scene found. Its words are in pages/NAME.md of this folder, with {tables} and {commands} in them."""
    name: str
    tables: list
    drawings: list
    covers: str  # sweeps and benchmarks

    def rows(self):
        return [row for table in self.tables for row in table.rows]

    def words(self):
        return (Path(__file__).resolve().parent / "pages" / f"{self.name}.md").read_text(encoding="utf-8")

    def title(self):
        return self.words().splitlines()[0].removeprefix("# ")

    def page(self, variants, commands):
        """Markdown: `variants` are files of the naive methods, `commands` run spricka's decks."""
        tables = "\n\n".join(table.text().rstrip() for table in self.tables)
        text = self.words().replace("{tables}", tables)
        text = text.replace("{commands}", "\n".join(f"    {line}" for line in commands))
        if variants:
            files = ", ".join(f"`{name}`" for name in variants)
            text += "\n" + folded(f"Naive methods: {files} in `tests/gallery`.") + "\n"
        return text + "\n" + folded(f"Numbers of this page: `tests/gallery/gallery.py PROGRAM --write {self.name}`. "
                                    "[All scenes](index.md).") + "\n"
