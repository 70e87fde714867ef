# SPDX-License-Identifier: GPL-3.0-or-later
"""print_pdf.py PAGE.html OUT.pdf: prints a page by Chromium, with an outline and numbered pages."""

import base64
import sys
from pathlib import Path

from chromium import Browser

FOOT = ('<div style="font-size:8px; width:100%; text-align:center; font-family:sans-serif">'
        '<span class="pageNumber"></span></div>')


def main():
    page, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    with Browser() as browser:
        browser.open(page.as_uri())
        if browser.errors:
            sys.exit("\n".join(browser.errors))
        printed = browser.call("Page.printToPDF", paperWidth=8.27, paperHeight=11.69, marginTop=0.7,
                               marginBottom=0.75, marginLeft=0.75, marginRight=0.75,
                               displayHeaderFooter=True, headerTemplate="<span></span>",
                               footerTemplate=FOOT, printBackground=True,
                               generateDocumentOutline=True, generateTaggedPDF=True,
                               transferMode="ReturnAsStream")
        with out.open("wb") as file:
            while True:
                piece = browser.call("IO.read", handle=printed["stream"], size=1 << 20)
                data = piece["data"]
                file.write(base64.b64decode(data) if piece.get("base64Encoded") else data.encode())
                if piece["eof"]:
                    break


if __name__ == "__main__":
    main()
