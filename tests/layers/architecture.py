# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of the rooms in manual/architecture.md, and its picture, made from the house itself."""

import re

from circles import levels, without_shortcuts
from layout import Layout

PAGE = "manual/architecture.md"
PICTURE = "manual/architecture.svg"
BEGIN = "<!-- rooms: made by tests/layers/check_layers.py --write -->"
END = "<!-- rooms end -->"
STALE = 0.1  # lines of a room that the table may be off by before it has aged
ROW = re.compile(r"^\| `([^`]+)` \|.*\| (\d+) \|[^|]*\|$", re.M)

HEIGHT, STEP, MARGIN = 30, 74, 16  # of a box, from row to row, round the picture
STEEPEST = 0.3  # sideways by down where an arrow passes between boxes
COLOURS = {"program": "#f4d6cc", "analysis": "#fbe8b6", "mesh": "#d7ecd0", "report": "#e3dcf3"}
OTHERS = "#dbe7f4"


def graph_of(house):
    """{room: rooms that it says it uses}."""
    return {name: sorted(u for u in room.uses if u in house.rooms)
            for name, room in house.rooms.items()}


def table(house, lines):
    """The rooms from the top of the picture to its bottom."""
    level = levels(graph_of(house))
    rows = ["| room | purpose | lines | uses |", "|---|---|---:|---|"]
    for name in sorted(level, key=lambda n: (-level[n], n)):
        room = house.rooms[name]
        uses = ", ".join(sorted(room.uses)) or "-"
        rows.append(f"| `{name}` | {room.purpose} | {lines[name]} | {uses} |")
    rooms, total = len(lines), sum(lines.values())
    largest = max(lines, key=lines.get)
    rows.append("")
    rows.append(f"{rooms} rooms; the largest, `{largest}`, holds "
                f"{100 * lines[largest] / total:.0f} % of the lines.")
    return "\n".join(rows)


def box_width(name):
    return 26 + 8.7 * len(name) if isinstance(name, str) else 0


def path(points):
    """A smooth line down through the bends of an arrow, upright where it leaves and comes."""
    lean = [0.0] * len(points)
    for i in range(1, len(points) - 1):
        (x0, y0), (x1, y1) = points[i - 1], points[i + 1]
        lean[i] = max(-STEEPEST, min(STEEPEST, (x1 - x0) / (y1 - y0)))
    text = f"M{points[0][0]:.0f},{points[0][1]:.0f}"
    for i in range(1, len(points)):
        (x0, y0), (x1, y1) = points[i - 1], points[i]
        third = (y1 - y0) / 3
        text += (f" C{x0 + lean[i - 1] * third:.0f},{y0 + third:.0f}"
                 f" {x1 - lean[i] * third:.0f},{y1 - third:.0f} {x1:.0f},{y1:.0f}")
    return text


def box(name, room, x, y):
    width = box_width(name)
    fill = COLOURS.get(name.split("/")[0], OTHERS)
    return (f'<g><title>{room.purpose}</title><rect x="{x - width / 2:.0f}" y="{y:.0f}" '
            f'width="{width:.0f}" height="{HEIGHT}" rx="5" fill="{fill}" stroke="#44505c"/>'
            f'<text x="{x:.0f}" y="{y + 20:.0f}">{name}</text></g>')


def svg(house):
    """Every room in a box, arrows down to what it uses; an arrow that others make up is left out."""
    layout = Layout(without_shortcuts(graph_of(house)),
                    lambda n: box_width(n) + 22 if isinstance(n, str) else 22)
    top = {name: MARGIN + i * STEP for i, row in enumerate(layout.rows) for name in row}
    x = {name: place + MARGIN for name, place in layout.x.items()}
    width = max(x[n] + box_width(n) / 2 for n in x) + MARGIN
    height = max(top.values()) + HEIGHT + MARGIN
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" '
             f'width="{width:.0f}" height="{height:.0f}" font-family="sans-serif" font-size="15" '
             'text-anchor="middle">',
             '<defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="8" '
             'markerHeight="8" orient="auto"><path d="M0,0L8,4L0,8z" fill="#44505c"/></marker></defs>',
             f'<rect width="{width:.0f}" height="{height:.0f}" fill="#ffffff"/>',
             '<g fill="none" stroke="#44505c" stroke-width="1.3">']
    for way in layout.ways.values():
        bends = [(x[n], top[n] + y) for n in way[1:-1] for y in (2, HEIGHT - 2)]
        points = [(x[way[0]], top[way[0]] + HEIGHT), *bends, (x[way[-1]], top[way[-1]])]
        parts.append(f'<path marker-end="url(#tip)" d="{path(points)}"/>')
    parts.append("</g>")
    parts += [box(n, house.rooms[n], x[n], top[n]) for row in layout.rows for n in row
              if isinstance(n, str)]
    return "\n".join([*parts, "</svg>", ""])


def page(text, house, lines):
    """The text of the page with the part between the marks made anew."""
    before, rest = text.split(BEGIN)
    return f"{before}{BEGIN}\n\n{table(house, lines)}\n\n{END}{rest.split(END)[1]}"


def write(house, top):
    file = top / PAGE
    text = file.read_text(encoding="utf-8")
    file.write_text(page(text, house, house.lines()), encoding="utf-8")
    (top / PICTURE).write_text(svg(house), encoding="utf-8")


def age_errors(house, top):
    """Whether page and picture are still those of the house; lines may be off by a tenth."""
    errors = []
    if not house.rooms:
        return errors
    file = top / PAGE
    text = file.read_text(encoding="utf-8") if file.exists() else ""
    if BEGIN not in text or END not in text:
        errors.append(f"{PAGE}: not there, or without the lines '{BEGIN}' and '{END}'")
    else:
        lines = house.lines()
        for name, told in ROW.findall(text):
            if name in lines and abs(int(told) - lines[name]) <= STALE * lines[name]:
                lines[name] = int(told)
        if page(text, house, lines) != text:
            errors.append(f"{PAGE}: aged, check_layers.py TOP --write makes its table anew")
    picture = top / PICTURE
    if not picture.exists() or picture.read_text(encoding="utf-8") != svg(house):
        errors.append(f"{PICTURE}: aged, check_layers.py TOP --write draws it anew")
    return errors
