# SPDX-License-Identifier: GPL-3.0-or-later
"""Circles and levels of a directed graph {node: iterable of nodes}."""


def circles(graph):
    """The strongly connected sets of two and more nodes, each sorted (Tarjan 1972, unrolled)."""
    order, low, stack, found = {}, {}, [], []
    for start in graph:
        work = [] if start in order else [(start, None, iter(graph[start]))]
        if work:
            order[start] = low[start] = len(order)
            stack.append(start)
        while work:
            node, parent, ways = work[-1]
            follower = next((n for n in ways if n in graph), None)
            if follower is None:
                work.pop()
                if parent is not None:
                    low[parent] = min(low[parent], low[node])
                if low[node] == order[node]:
                    at = stack.index(node)
                    if len(stack) - at > 1:
                        found.append(sorted(stack[at:]))
                    del stack[at:]
            elif follower not in order:
                order[follower] = low[follower] = len(order)
                stack.append(follower)
                work.append((follower, node, iter(graph[follower])))
            elif follower in stack:
                low[node] = min(low[node], order[follower])
    return sorted(found)


def reached(graph, node):
    """All that can be reached from node, without itself if there is no circle."""
    seen, pending = set(), list(graph[node])
    while pending:
        follower = pending.pop()
        if follower not in seen:
            seen.add(follower)
            pending.extend(graph.get(follower, ()))
    return seen


def without_shortcuts(graph):
    """The arrows that no chain of other arrows stands for; the graph has no circle."""
    below = {node: reached(graph, node) for node in graph}
    return {
        node: [f for f in followers if not any(f in below[other] for other in followers)]
        for node, followers in graph.items()
    }


def levels(graph):
    """{node: longest way down from it}; the graph has no circle."""
    level = {}
    while len(level) < len(graph):
        for node, followers in graph.items():
            if all(f in level for f in followers):
                level[node] = 1 + max((level[f] for f in followers), default=-1)
    return level
