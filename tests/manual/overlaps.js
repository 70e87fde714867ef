// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of drawings that lie on each other: a list of sentences.
(() => {
  const faults = [];
  const slack = 2; // pixels of empty room that a line of text has above and below it
  for (const drawing of document.querySelectorAll("svg")) {
    const labels = [...drawing.querySelectorAll("text")].map((text) => ({ words: text.textContent,
      box: text.getBoundingClientRect() })).filter((label) => label.box.width > 0);
    labels.forEach((a, i) => labels.slice(i + 1).forEach((b) => {
      const wide = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
      const high = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
      if (wide > slack && high > slack) {
        faults.push(`"${a.words}" and "${b.words}" overlap in "${drawing.getAttribute("aria-label")}"`);
      }
    }));
  }
  return [...new Set(faults)];
})()
