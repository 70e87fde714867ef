# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts and sketches of the gallery as SVG, narrow enough for a telephone."""
import html
import math
from dataclasses import dataclass, field

WIDTH, FONT = 420, 13
NAIVE, OURS, TRUE, FAIR = "#c2571a", "#1b5e9b", "#555555", "#3f8f4f"
OTHERS = ("#c2571a", "#8a3ab9", "#b58900", "#a01040")


@dataclass
class Curve:
    name: str
    points: list
    colour: str
    marks: bool = True
    line: bool = True
    dashed: bool = False


@dataclass
class Chart:
    title: str
    x_label: str
    y_label: str
    curves: list = field(default_factory=list)
    log_x: bool = False
    log_y: bool = False
    y_range: tuple = None
    height: int = 210


@dataclass
class Sketch:
    """Lines to scale: paths of (colour, width, [(x, y) ..]), and words below."""
    title: str
    paths: list
    words: list = field(default_factory=list)  # (colour, text)


def steps(low, high, log):
    """Round values that divide an axis."""
    if log:
        first, last = math.floor(math.log10(low) + 1e-9), math.ceil(math.log10(high) - 1e-9)
        last = max(last, first + 1)
        if high / low < 30:  # little of a decade or two: 1, 2, 5
            fine = [m * 10.0 ** k for k in range(first - 1, last + 1) for m in (1, 2, 5)]
            return [v for v, after, before in zip(fine, fine[1:] + [math.inf], [0.0] + fine)
                    if after > low * 1.001 and before < high * 0.999]
        every = max(1, math.ceil((last - first) / 7))
        return [10.0 ** k for k in range(first, last + every, every)]
    raw = (high - low or 1.0) / 5
    unit = 10.0 ** math.floor(math.log10(raw))
    step = next(m * unit for m in (1, 2, 2.5, 5, 10) if m * unit >= raw * 0.999)
    first = math.floor(low / step + 1e-9)
    last = math.ceil(high / step - 1e-9)
    return [k * step for k in range(first, max(last, first + 1) + 1)]


def label(value, log):
    if log and not 1e-3 <= value <= 1e5:
        return f"1e{round(math.log10(value))}"
    return f"{value:.6g}"


def text(x, y, words, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}"{more}>{html.escape(words)}</text>'


def axes(chart, left, top, width, height):
    """Lines of the frame, and the two functions to pixels."""
    every = [p for curve in chart.curves for p in curve.points]
    xs = steps(min(p[0] for p in every), max(p[0] for p in every), chart.log_x)
    low, high = chart.y_range or (min(p[1] for p in every), max(p[1] for p in every))
    ys = steps(low, high, chart.log_y)

    def along(values, log):
        f = math.log10 if log else float
        return lambda v: (f(v) - f(values[0])) / (f(values[-1]) - f(values[0]))

    x_of, y_of = along(xs, chart.log_x), along(ys, chart.log_y)

    def px(x):
        return left + width * x_of(x)

    def py(y):
        return top + height * (1 - y_of(y))

    out = []
    for x in xs:
        out.append(f'<path d="M{px(x):.1f} {top}V{top + height}" stroke="#ddd"/>')
        out.append(text(px(x), top + height + 16, label(x, chart.log_x), ' text-anchor="middle"'))
    for y in ys:
        out.append(f'<path d="M{left} {py(y):.1f}H{left + width}" stroke="#ddd"/>')
        out.append(text(left - 5, py(y) + 4, label(y, chart.log_y), ' text-anchor="end"'))
    if ys[0] < 0 < ys[-1] and not chart.log_y:
        out.append(f'<path d="M{left} {py(0):.1f}H{left + width}" stroke="#999"/>')
    return out, px, py


def drawn_curve(curve, px, py, bottom, top):
    points = [(px(x), min(max(py(y), top), bottom)) for x, y in curve.points]
    out = []
    if curve.line and len(points) > 1:
        dash = ' stroke-dasharray="6 4"' if curve.dashed else ""
        out.append(f'<path d="M{"L".join(f"{x:.1f} {y:.1f}" for x, y in points)}" fill="none" '
                   f'stroke="{curve.colour}" stroke-width="1.7"{dash}/>')
    if curve.marks:
        radius = 3.2 if len(points) < 40 else 2
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{curve.colour}"/>' for x, y in points]
    return out


def draw_chart(chart, y):
    """Its SVG from height y on, and where it ends."""
    out = [text(8, y + 18, chart.title, ' font-weight="bold"')]
    y += 26
    for curve in chart.curves:
        dash = ' stroke-dasharray="6 4"' if curve.dashed else ""
        if curve.line:
            out.append(f'<path d="M10 {y + 8}H34" stroke="{curve.colour}" stroke-width="2"{dash}/>')
        if curve.marks:
            out.append(f'<circle cx="22" cy="{y + 8}" r="3.2" fill="{curve.colour}"/>')
        out.append(text(40, y + 12, curve.name))
        y += 18
    out.append(text(8, y + 14, chart.y_label, ' fill="#444"'))
    left, top, width = 62, y + 24, WIDTH - 62 - 22
    lines, px, py = axes(chart, left, top, width, chart.height)
    out += lines
    for curve in chart.curves:
        out += drawn_curve(curve, px, py, top + chart.height, top)
    out.append(text(left + width / 2, top + chart.height + 34, chart.x_label, ' text-anchor="middle" fill="#444"'))
    return out, top + chart.height + 46


def draw_sketch(sketch, y):
    every = [p for _, _, path in sketch.paths for p in path]
    x0, x1 = min(p[0] for p in every), max(p[0] for p in every)
    y0, y1 = min(p[1] for p in every), max(p[1] for p in every)
    scale = (WIDTH - 40) / (x1 - x0)
    out = [text(8, y + 18, sketch.title, ' font-weight="bold"')]
    y += 32
    for colour, width, path in sketch.paths:
        line = "L".join(f"{20 + scale * (a - x0):.1f} {y + scale * (y1 - b):.1f}" for a, b in path)
        out.append(f'<path d="M{line}" fill="none" stroke="{colour}" stroke-width="{width}"/>')
    y += scale * (y1 - y0) + 10
    for colour, words in sketch.words:
        out.append(f'<path d="M10 {y + 8:.1f}H34" stroke="{colour}" stroke-width="2"/>')
        out.append(text(40, y + 12, words))
        y += 18
    return out, y + 6


def sheet(drawings):
    """The text of an SVG file with drawings below each other."""
    body, y = [], 0
    for drawing in drawings:
        lines, y = (draw_sketch if isinstance(drawing, Sketch) else draw_chart)(drawing, y)
        body += lines
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {y:.0f}" width="{WIDTH}" '
            f'height="{y:.0f}" font-family="sans-serif" font-size="{FONT}">')
    return "\n".join([head, '<rect width="100%" height="100%" fill="#fff"/>'] + body + ["</svg>"]) + "\n"
