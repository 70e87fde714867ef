# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings README and manual up to date: runs what a page says, and writes the numbers that the page shows as
printed, to as many digits as it shows, and its pictures. Words stay as they are: a line that is not printed
any more is named.

write_pages.py PROGRAM [PAGE ..]: pages as manual/ has them, quickstart.md or ../README.md; without one all
that are run or have pictures.
"""

import sys
import tempfile
from pathlib import Path

from blocks import MANUAL, blocks_of, pages, setup_of
from pictures import pictures_of, write_picture
from reader import NUMBER, VARIES, Reader, same_line, same_number
from report_view import views_of, write_views


def words_of(line):
    return NUMBER.sub("#", VARIES.sub("<varies>", line)).split()


def begins_alike(shown, printed):
    words, found = words_of(shown), words_of(printed)
    if words[-1] == "..":
        words.pop()
        found = found[:len(words)]
    return words == found


def numbers_kept(shown, printed):
    """How many numbers of a line are as they were: rows of a table differ in their first ones."""
    return sum(same_number(a, b) for a, b in zip(NUMBER.findall(shown), NUMBER.findall(printed)))


def rounded(shown, found):
    """A number to as many digits as the page shows of it; 001 is a name."""
    if shown.isdigit() and shown.startswith("0"):
        return found
    mantissa, letter, _ = shown.partition("e")
    digits = len(mantissa.partition(".")[2])
    if letter:
        return f"{float(found):.{digits}e}"
    text = f"{float(found):.{digits}f}"
    return f"+{text}" if shown.startswith("+") and not text.startswith("-") else text


def line_with_numbers_of(shown, printed):
    """The line that is shown with the numbers that were printed; columns stay where they are."""
    found = iter(NUMBER.findall(VARIES.sub("<varies>", printed)))
    kept = [m.span() for m in VARIES.finditer(shown)]
    result, at = "", 0
    for m in NUMBER.finditer(shown):
        if any(a <= m.start() < b for a, b in kept):
            continue
        number = rounded(m[0], next(found))
        result += shown[at:m.start()] + number
        at = m.end()
        room = len(m[0]) - len(number)
        if room > 0 and shown[at:at + 1] == " ":
            result += " " * room
        while room < 0 and shown[at:at + 2] == "  ":
            at, room = at + 1, room + 1
    return result + shown[at:]


def refreshed(shown, printed):
    """What a page shows, with the numbers that were printed, and the lines that were not."""
    lines, at, result, lost = printed.splitlines(), 0, [], []
    for line in shown.splitlines():
        if line.strip() in ("..", "...", ""):
            result.append(line)
            continue
        alike = [i for i in range(at, len(lines)) if lines[i].split() and begins_alike(line, lines[i])]
        if not alike:
            lost.append(line)
            result.append(line)
            continue
        at = max(alike, key=lambda i, shown=line: numbers_kept(shown, lines[i]))
        result.append(line if same_line(line, lines[at]) else line_with_numbers_of(line, lines[at]))
        at += 1
    return "\n".join(result) + "\n", lost


def write_page(program, page):
    path = MANUAL / page
    text = path.read_text(encoding="utf-8")
    pictures = pictures_of(text)
    with tempfile.TemporaryDirectory() as folder:
        reader = Reader(program, folder)
        reader.full = True
        code, printed = reader.shell(setup_of(page))
        if code != 0:
            print(f"{page}: its setup ended with {code}: {printed[-500:]}")
        for block in blocks_of(page):
            if block.language == "text" and not {"shown", "not run"} & set(block.marks) and reader.printed is not None:
                new, lost = refreshed(block.text, reader.printed)
                for line in lost:
                    print(f"{block.place}: not printed: {line}")
                text = text.replace(block.text, new, 1)
            else:
                reader.do(block)
        for picture in pictures:
            try:
                write_picture(picture, folder, path.parent)
            except (LookupError, OSError) as error:
                print(f"{page}: {error}")
        write_views(text, folder, path.parent)
    if text != path.read_text(encoding="utf-8"):
        path.write_text(text, encoding="utf-8")
        print(f"{page}: numbers changed")


def main():
    program = Path(sys.argv[1]).resolve()
    chosen = sys.argv[2:]
    if not chosen:
        texts = {p: (MANUAL / p).read_text(encoding="utf-8") for p in pages()}
        chosen = ["../README.md"] + [p for p, text in texts.items() if pictures_of(text) or views_of(text)]
    for page in chosen:
        write_page(program, page)


if __name__ == "__main__":
    main()
