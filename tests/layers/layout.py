# SPDX-License-Identifier: GPL-3.0-or-later
"""Places for a layered drawing of a graph without circles (Sugiyama, Tagawa, Toda 1981).

Rows by longest way down; an arrow over more than one row gets a bend in each row between; rows are
ordered by the mean place of their neighbours while crossings fall; places are the least squares of
short arrows at a least distance.
"""

from circles import levels

SWEEPS = 40


class Layout:
    """rows: node or bend names, top row first; links: one step each; x: the place of each name."""

    def __init__(self, graph, width):
        self.width = width  # of a name, with the room round it
        self.rows, self.links, self.ways = [], [], {}
        self.make_rows(graph)
        self.order_rows()
        self.place()

    def make_rows(self, graph):
        level = levels(graph)
        top = max(level.values())
        self.rows = [[n for n in graph if level[n] == top - row] for row in range(top + 1)]
        for node, followers in graph.items():
            for follower in followers:
                way = [node]
                for row in range(top - level[node] + 1, top - level[follower]):
                    way.append((node, follower, row))
                    self.rows[row].append(way[-1])
                way.append(follower)
                self.ways[node, follower] = way
                self.links += zip(way, way[1:])
        self.above = {name: [] for row in self.rows for name in row}
        self.below = {name: [] for row in self.rows for name in row}
        for upper, lower in self.links:
            self.below[upper].append(lower)
            self.above[lower].append(upper)

    def crossings(self):
        count = 0
        for upper, lower in zip(self.rows, self.rows[1:]):
            at = {name: i for i, name in enumerate(lower)}
            ends = [sorted(at[n] for n in self.below[name]) for name in upper]
            flat = [end for part in ends for end in part]
            count += sum(a > b for i, a in enumerate(flat) for b in flat[i + 1:])
        return count

    def order_rows(self):
        best, fewest = self.rows, self.crossings()
        for sweep in range(SWEEPS):
            down = sweep % 2 == 0
            near = self.above if down else self.below
            self.rows = [list(row) for row in self.rows]
            steps = range(1, len(self.rows))
            for i in steps if down else reversed(steps):
                fixed, free = (i - 1, i) if down else (i, i - 1)
                at = {name: j for j, name in enumerate(self.rows[fixed])}
                now = {name: j for j, name in enumerate(self.rows[free])}
                self.rows[free].sort(key=lambda n: mean([at[m] for m in near[n]], now[n]))
            if self.crossings() < fewest:
                best, fewest = self.rows, self.crossings()
        self.rows = best

    def place(self):
        self.x = {}
        for row in self.rows:
            for name, x in zip(row, self.spread(row, [0.0] * len(row))):
                self.x[name] = x
        for sweep in range(8 * SWEEPS):
            for row in self.rows if sweep % 2 == 0 else reversed(self.rows):
                wanted = [mean([self.x[m] for m in self.pulls(n)], self.x[n]) for n in row]
                for name, x in zip(row, self.spread(row, wanted)):
                    self.x[name] = x
        left = min(self.x[n] - self.width(n) / 2 for n in self.x)
        self.x = {name: x - left for name, x in self.x.items()}

    def pulls(self, name):
        """The neighbours of a name, bends as often as keeps long arrows straight."""
        near = self.above[name] + self.below[name]
        return near if isinstance(name, str) else [m for m in near for _ in range(weight(m))]

    def spread(self, row, wanted):
        """Places nearest to wanted in the squares, in order and apart (pool adjacent violators)."""
        offset, offsets = 0.0, []
        for i, name in enumerate(row):
            offset += (self.width(row[i - 1]) + self.width(name)) / 2 if i else 0.0
            offsets.append(offset)
        pools = []
        for i, x in enumerate(wanted):
            pools.append([x - offsets[i], weight(row[i]), 1])
            while len(pools) > 1 and pools[-2][0] > pools[-1][0]:
                x1, w1, n1 = pools.pop()
                x0, w0, n0 = pools.pop()
                pools.append([(x0 * w0 + x1 * w1) / (w0 + w1), w0 + w1, n0 + n1])
        shifts = [x for x, _, n in pools for _ in range(n)]
        return [s + o for s, o in zip(shifts, offsets)]


def weight(name):
    return 1 if isinstance(name, str) else 6


def mean(values, otherwise):
    return sum(values) / len(values) if values else otherwise
