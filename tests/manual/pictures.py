# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the manual's pages: figures of reports that the pages' own runs wrote.

A page says above a picture where it comes from:

    <!-- picture: my_lug.run/report.html: Stress intensity -->
    ![K over the length](pictures/my_lug.svg)

that is, the figure of this report whose caption begins with these words; several captions, with | between
them, are drawn from left to right, and [2] behind the words takes the second drawing of a figure alone.
test_pages.py PROGRAM --write makes the files.
"""

import re
from dataclasses import dataclass
from html import unescape
from pathlib import Path

MARK = re.compile(r"<!-- picture: (\S+): ([^\n]+?) -->\s*\n!\[[^\]]*\]\(([^)]+\.svg)\)")
FIGURE = re.compile(r"<figure>(.*?)<figcaption>(?:<b>[^<]*</b>)?\s*(.*?)</figcaption>", re.S)
DRAWING = re.compile(r"<svg .*?</svg>", re.S)
SIZE = re.compile(r'<svg [^>]*?width="([\d.]+)"[^>]*?height="([\d.]+)"')
GAP = 16  # between drawings, in pixels of the picture
WIDEST = 960


@dataclass
class Picture:
    report: str  # as the page has it, from the folder in which it is run
    captions: list
    file: str  # as the page links to it


def pictures_of(text):
    return [Picture(m[1], [c.strip() for c in m[2].split("|")], m[3]) for m in MARK.finditer(text)]


def figures_of(html):
    """(caption, drawings) of each figure of a report, its legend last."""
    return [(unescape(re.sub(r"<[^>]*>", "", caption)), DRAWING.findall(body))
            for body, caption in FIGURE.findall(html)]


def drawings_of(picture, html):
    """The drawings that a picture is made of; a LookupError names what the report has."""
    figures = figures_of(html)
    chosen = []
    for wanted in picture.captions:
        number = re.search(r"\s*\[(\d+)\]$", wanted)
        words = wanted[:number.start()] if number else wanted
        found = [drawings for caption, drawings in figures if caption.startswith(words)]
        if not found or (number and int(number[1]) > len(found[0])):
            raise LookupError(f"{picture.report} has no figure '{wanted}', but: "
                              + "; ".join(f"{c[:60]} ({len(d)})" for c, d in figures))
        chosen += [found[0][int(number[1]) - 1]] if number else found[0]
    return chosen


def nested(drawing, x, y, scale, tag):
    """A drawing as a part of another one, its ids made its own."""
    width, height = (float(v) for v in SIZE.match(drawing).groups())
    drawing = re.sub(r'\bid="', f'id="{tag}', drawing)
    drawing = re.sub(r"url\(#", f"url(#{tag}", drawing)
    drawing = re.sub(r' data-[a-z-]+="[^"]*"', "", drawing)  # for the pointer on curves, which has no script here
    head, body = drawing.split(">", 1)
    head = re.sub(r' width="[^"]*"', f' width="{width * scale:.1f}"', head, count=1)
    head = re.sub(r' height="[^"]*"', f' height="{height * scale:.1f}"', head, count=1)
    if "viewBox" not in head:
        head += f' viewBox="0 0 {width:g} {height:g}"'
    return f'{head} x="{x:.1f}" y="{y:.1f}">{body}'


def rows_of(sizes):
    """Numbers of the drawings in each row: as many side by side as stay readable."""
    rows, width = [[]], 0.0
    for i, (w, _) in enumerate(sizes):
        if rows[-1] and width + GAP + w > 1.5 * WIDEST:
            rows.append([])
            width = 0.0
        rows[-1].append(i)
        width += w + GAP
    return rows


def compose(drawings):
    """One SVG of them on white: rows of equal height."""
    sizes = [tuple(float(v) for v in SIZE.match(d).groups()) for d in drawings]
    parts, y, right = [], 0.0, 0.0
    for row in rows_of(sizes):
        height = max(sizes[i][1] for i in row)
        scales = [min(1.0, height / sizes[i][1]) for i in row]
        width = sum(sizes[i][0] * s for i, s in zip(row, scales)) + GAP * (len(row) - 1)
        shrink = min(1.0, WIDEST / width)
        x = 0.0
        for i, scale in zip(row, scales):
            lower = 0.5 * (height - sizes[i][1] * scale) * shrink
            parts.append(nested(drawings[i], x, y + lower, scale * shrink, f"d{i}-"))
            x += (sizes[i][0] * scale + GAP) * shrink
        right = max(right, x - GAP * shrink)
        y += height * shrink + GAP
    height = y - GAP
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{right:.0f}" height="{height:.0f}" '
            f'viewBox="0 0 {right:.0f} {height:.0f}">\n'
            f'<rect width="100%" height="100%" fill="#fff"/>\n' + "\n".join(parts) + "</svg>\n")


def write_picture(picture, folder, page_folder):
    """Makes the file that a page links to from the report in the folder in which the page was run."""
    html = (Path(folder) / picture.report).read_text(encoding="utf-8")
    target = Path(page_folder) / picture.file
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(compose(drawings_of(picture, html)), encoding="utf-8")
