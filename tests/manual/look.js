// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the look of a page at its present width: a list of sentences.
(() => {
  const faults = [];
  const slack = 1.5; // pixels that rounding may take
  const root = document.documentElement;
  const name = (element) => {
    const words = (element.textContent ?? "").trim().replace(/\s+/g, " ").slice(0, 50);
    return `<${element.tagName.toLowerCase()}> "${words}"`;
  };
  const shown = (element) => {
    for (let e = element; e instanceof Element; e = e.parentElement) {
      const style = getComputedStyle(e);
      if (style.display === "none" || style.visibility === "hidden" || style.opacity === "0" ||
          (e.tagName === "DETAILS" && !e.open)) {
        return false;
      }
      // drawers beside the page, and what only screen readers see
      if (e.matches(".sidebar-drawer, .toc-drawer, .visually-hidden, .katex-mathml, .skip-to-content")) {
        return false;
      }
    }
    return true;
  };

  if (root.scrollWidth > root.clientWidth) {
    faults.push(`the page is ${root.scrollWidth} wide in a window of ${root.clientWidth}`);
  }
  for (const image of document.images) {
    if (!image.complete || image.naturalWidth === 0) {
      faults.push(`picture ${image.getAttribute("src")} is missing`);
    }
  }
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const parent = texts.currentNode.parentElement;
    if (!texts.currentNode.textContent.trim() || !parent || parent.closest("svg, script, style, noscript") ||
        !shown(parent)) {
      continue;
    }
    const range = document.createRange();
    range.selectNodeContents(texts.currentNode);
    const box = range.getBoundingClientRect();
    if (box.width === 0) {
      continue;
    }
    // up to the first element that cuts what it holds, or that can be scrolled
    let held = false;
    for (let e = parent; e && e !== document.body && !held; e = e.parentElement) {
      const overflow = getComputedStyle(e).overflowX;
      held = overflow === "auto" || overflow === "scroll";
      if (overflow === "hidden" || overflow === "clip") {
        const cut = e.getBoundingClientRect();
        if (box.left < cut.left - slack || box.right > cut.right + slack) {
          faults.push(`${name(parent)} is cut by ${e.tagName.toLowerCase()}.${e.className}`);
        }
        held = true;
      }
    }
    if (!held && (box.left < -slack || box.right > root.clientWidth + slack)) {
      faults.push(`${name(parent)} goes from ${box.left.toFixed(0)} to ${box.right.toFixed(0)}`);
    }
  }
  // drawings cut what lies outside of them
  for (const drawing of document.querySelectorAll("svg")) {
    if (!shown(drawing) || drawing.closest("svg svg")) {
      continue;
    }
    const cut = drawing.getBoundingClientRect();
    for (const text of drawing.querySelectorAll("text")) {
      const box = text.getBoundingClientRect();
      if (box.left < cut.left - slack || box.right > cut.right + slack || box.top < cut.top - slack ||
          box.bottom > cut.bottom + slack) {
        faults.push(`text ${name(text)} leaves its drawing`);
      }
    }
  }
  // labels of a drawing can be told from each other
  for (const drawing of document.querySelectorAll("svg")) {
    if (!shown(drawing) || drawing.closest("svg svg")) {
      continue;
    }
    const labels = [...drawing.querySelectorAll("text")].filter((text) => text.textContent.trim());
    const boxes = labels.map((text) => text.getBoundingClientRect());
    for (let i = 0; i < boxes.length; ++i) {
      for (let k = 0; k < i; ++k) {
        const across = Math.min(boxes[i].right, boxes[k].right) - Math.max(boxes[i].left, boxes[k].left);
        const down = Math.min(boxes[i].bottom, boxes[k].bottom) - Math.max(boxes[i].top, boxes[k].top);
        // the box of a text has room above and below its letters
        if (across > slack && down > 0.35 * Math.min(boxes[i].height, boxes[k].height)) {
          faults.push(`${name(labels[k])} and ${name(labels[i])} cover each other`);
        }
      }
    }
  }
  // on a screen no table needs to be scrolled
  if (root.clientWidth >= 1000) {
    for (const table of document.querySelectorAll("table")) {
      if (shown(table) && getComputedStyle(table).overflowX === "auto" && table.scrollWidth > table.clientWidth + slack) {
        faults.push(`table ${name(table)} is ${table.scrollWidth} wide in a box of ${table.clientWidth}`);
      }
    }
  }
  for (const formula of document.querySelectorAll(".tex")) {
    if (!formula.querySelector(".katex")) {
      faults.push(`formula ${name(formula)} is not set`);
    }
  }
  return [...new Set(faults)];
})()
