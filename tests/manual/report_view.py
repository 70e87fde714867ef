# SPDX-License-Identifier: GPL-3.0-or-later
"""The view of a report in a browser that draws in space, and what a reader does with it. Pictures of it for pages:

    <!-- view: my_lug.run/report.html: field=von Mises stress, opening=80, crack -->
    ![the crack in its lug](pictures/my_view.png)

that is, the view after these controls of its panel have been set or pressed, in this order.
"""

import hashlib
import re
from pathlib import Path

import looking  # noqa: F401 (where chromium is)
from chromium import Browser

MARK = re.compile(r"<!-- view: (\S+):([^\n]*?) -->\s*\n!\[[^\]]*\]\(([^)]+\.png)\)")


class Report:
    """A report in a browser, and what a reader does with its view."""

    def __init__(self, browser, page, width):
        self.browser = browser
        self.last = None  # what picture() was after all that was done
        browser.width(width)
        browser.open(page.as_uri())
        browser.value("new Promise(done => { const wait = (n) => n === 0 || window.spricka ||"
                      " document.getElementById('view-word').textContent ? done(true)"
                      " : setTimeout(() => wait(n - 1), 50); wait(400); })")
        browser.settle()

    def has(self, control):
        return self.browser.value(f"document.getElementById('view-{control}') !== null")

    def canvas(self):
        return self.box("view-canvas")

    def picture(self):
        """Something that is the same for the same pixels of the view alone."""
        return hashlib.sha256(self.browser.picture(*self.canvas())).hexdigest()

    def stage(self):
        """The view with its panel, PNG."""
        self.browser.value("document.activeElement.blur()")
        return self.browser.picture(*self.box("view-stage"))

    def box(self, name):
        """Of an element in the window, scrolled to: left, top, width, height."""
        return self.browser.value(
            f"(() => {{ const e = document.getElementById('{name}'); e.scrollIntoView({{ block: 'center' }});"
            "const b = e.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()")

    def set(self, control, value):
        """A form element gets a value, as by a hand: True and False tick boxes, lists take the words of an entry
        too."""
        assign = (f"e.checked = {str(value).lower()}" if isinstance(value, bool) else
                  f"e.value = ([...(e.options || [])].find(o => o.text === '{value}') || {{ value: '{value}' }}).value")
        self.browser.value(f"(() => {{ const e = document.getElementById('view-{control}'); {assign};"
                           "e.dispatchEvent(new Event('input', { bubbles: true }));"
                           "e.dispatchEvent(new Event('change', { bubbles: true })); })()")

    def options(self, control):
        """Values of the entries of a list that can be chosen, and the one that is."""
        return self.browser.value(f"(() => {{ const e = document.getElementById('view-{control}'); return"
                                  " [[...e.options].filter(o => !o.disabled).map(o => o.value), e.value]; })()")

    def text(self, name):
        """What an element says; empty if it is hidden."""
        return self.browser.value(f"(e => e.hidden ? '' : e.innerText)(document.getElementById('{name}'))")

    def press(self, control):
        self.browser.value(f"(e => {{ e.focus(); e.click(); }})(document.getElementById('view-{control}'))")


def views_of(text):
    """(report, what is set, file) of each picture of a page."""
    return [(m[1], [c.strip() for c in m[2].split(",") if c.strip()], m[3]) for m in MARK.finditer(text)]


def write_views(text, folder, page_folder):
    """Makes the pictures of views that a page links to from the reports in the folder in which it was run."""
    views = views_of(text)
    if not views:
        return
    with Browser() as browser:
        for name, controls, file in views:
            report = Report(browser, Path(folder) / name, 1060)
            for control in controls:
                what, given, value = control.partition("=")
                report.set(what, {"on": True, "off": False}.get(value, value)) if given else report.press(what)
            (Path(page_folder) / file).write_bytes(report.stage())
