# SPDX-License-Identifier: GPL-3.0-or-later
"""Log-log charts as SVG, several panels on one sheet."""
import math
from dataclasses import dataclass, field

COLOURS = {"spricka": "#1b5e9b", "ccx": "#c2571a", "limit": "#777"}


@dataclass
class Panel:
    title: str
    x_label: str
    y_label: str
    curves: dict = field(default_factory=dict)  # name -> [(x, y)]
    floor: float = 0.0                          # below it y says nothing; 0: no such line
    names_beside: bool = False                  # of the curves, right of the panel


def decades(values):
    return math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)) + 1e-9)


def number(power):
    return f"{10.0 ** power:g}" if -3 <= power <= 5 else f"1e{power}"


def draw(panel, left, top, width, height):
    points = [p for curve in panel.curves.values() for p in curve]
    if not points:
        return [f'<text x="{left}" y="{top + 20}">{panel.title}: no data</text>']
    x0, x1 = decades([p[0] for p in points])
    y0, y1 = decades([p[1] for p in points])
    x1, y1 = max(x1, x0 + 1), max(y1, y0 + 1)

    def px(x):
        return left + width * (math.log10(x) - x0) / (x1 - x0)

    def py(y):
        return top + height * (y1 - math.log10(y)) / (y1 - y0)

    out = [f'<text x="{left}" y="{top - 10}" font-weight="bold">{panel.title}</text>',
           f'<text x="{left + width / 2}" y="{top + height + 34}" text-anchor="middle">'
           f'{panel.x_label}</text>',
           f'<text transform="translate({left - 48},{top + height / 2}) rotate(-90)" '
           f'text-anchor="middle">{panel.y_label}</text>']
    for power in range(x0, x1 + 1):
        x = px(10.0 ** power)
        out.append(f'<path d="M{x:.1f} {top}V{top + height}" stroke="#ddd"/>')
        out.append(f'<text x="{x:.1f}" y="{top + height + 16}" text-anchor="middle">'
                   f'{number(power)}</text>')
    for power in range(y0, y1 + 1):
        y = py(10.0 ** power)
        out.append(f'<path d="M{left} {y:.1f}H{left + width}" stroke="#ddd"/>')
        out.append(f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{number(power)}</text>')
    if 10.0 ** y0 < panel.floor < 10.0 ** y1:
        out.append(f'<path d="M{left} {py(panel.floor):.1f}h{width}" stroke="#888" '
                   f'stroke-dasharray="5 4"/>')
        out.append(f'<text x="{left + 6}" y="{py(panel.floor) + 14:.1f}" fill="#888">'
                   f'the reference is no better</text>')
    for row, (name, curve) in enumerate(panel.curves.items()):
        colour = COLOURS.get(name, "#444")
        line = "L".join(f"{px(x):.1f} {py(y):.1f}" for x, y in curve)
        out.append(f'<path d="M{line}" fill="none" stroke="{colour}" stroke-width="1.6"/>')
        out += [f'<circle cx="{px(x):.1f}" cy="{py(y):.1f}" r="3.5" fill="{colour}"/>'
                for x, y in curve]
        place, anchor = (width + 10, "start") if panel.names_beside else (width - 6, "end")
        out.append(f'<text x="{left + place}" y="{top + 16 + 16 * row}" text-anchor="{anchor}" '
                   f'fill="{colour}">{name}</text>')
    return out


def sheet(path, rows):
    """Writes rows of panels."""
    width, height, gap_y = 330, 220, 80
    gap_x = 230 if any(panel.names_beside for row in rows for panel in row) else 100
    columns = max(len(row) for row in rows)
    total_w, total_h = 70 + columns * (width + gap_x), 40 + len(rows) * (height + gap_y)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{total_w}" height="{total_h}" '
           f'font-family="sans-serif" font-size="12">', '<rect width="100%" height="100%" fill="#fff"/>']
    for r, row in enumerate(rows):
        for c, panel in enumerate(row):
            out += draw(panel, 70 + c * (width + gap_x), 40 + r * (height + gap_y), width, height)
    path.write_text("\n".join(out + ["</svg>"]) + "\n")
