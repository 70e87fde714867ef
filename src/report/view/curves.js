// SPDX-License-Identifier: GPL-3.0-or-later
// Plots answer the pointer: the nearest point of a curve with its numbers. Curves carry the numbers
// themselves (data-points), a plot the box of its axes and what they run from and to.

const reach = 30; // pixels of the drawing, from the pointer to a point

// "low high log" of an axis and the pixels it takes, as a function from a value to a pixel.
function axisOf(words, first, last) {
  const [low, high, log] = words.split(" ").map(Number);
  return (value) => first + (last - first) * ((log ? Math.log10(value) : value) - low) / (high - low);
}

// Points of all curves of a plot, in pixels and as they are.
function pointsOf(plot) {
  const [left, top, width, height] = plot.dataset.box.split(" ").map(Number);
  const across = axisOf(plot.dataset.x, left, left + width);
  const up = axisOf(plot.dataset.y, top + height, top);
  return [...plot.querySelectorAll("g.curve")].flatMap((curve) => curve.dataset.points.split(" ")
    .filter(Boolean).map((pair) => {
      const [x, y] = pair.split(",");
      return { name: curve.dataset.name, x, y, at: across(Number(x)), down: up(Number(y)) };
    }));
}

// "a  [mm]" -> name and unit.
function partsOf(title) {
  const found = /^(.*?)\s*\[(.*)\]\s*$/.exec(title);
  return found ? { name: found[1], unit: found[2] } : { name: title, unit: "" };
}

// As it is written in data-points, powers of ten only where a number is very long without.
function readable(text) {
  const size = Math.abs(Number(text));
  return size === 0 || (size >= 1e-4 && size < 1e9) ? String(Number(text)) : text;
}

function wordsOf(plot, point) {
  const one = (title, value) => {
    const { name, unit } = partsOf(title);
    return `${name} = ${readable(value)}${unit ? ` ${unit}` : ""}`;
  };
  return [point.name, one(plot.dataset.xName, point.x), one(plot.dataset.yName, point.y)].filter(Boolean);
}

function makeTip() {
  const tip = document.createElement("div");
  tip.id = "curve-tip";
  tip.hidden = true;
  tip.style.cssText = "position:absolute;z-index:9;pointer-events:none;background:#fffffff2;border:1px solid #8a939e;" +
    "border-radius:3px;padding:.25em .55em;font-size:.82em;line-height:1.35;max-width:18em";
  document.body.append(tip);
  return tip;
}

function makeMark(plot) {
  const mark = document.createElementNS("http://www.w3.org/2000/svg", "circle");
  const ring = { r: 5, fill: "none", stroke: "#000", "stroke-width": 1.6, visibility: "hidden" };
  for (const [key, value] of Object.entries(ring)) {
    mark.setAttribute(key, value);
  }
  plot.append(mark);
  return mark;
}

// Beside the pointer, within the window.
function showTip(tip, words, event) {
  tip.replaceChildren(...words.map((line) => {
    const div = document.createElement("div");
    div.textContent = line;
    return div;
  }));
  tip.hidden = false;
  const room = document.documentElement.clientWidth - tip.offsetWidth - 4;
  tip.style.left = `${window.scrollX + Math.max(4, Math.min(event.clientX + 14, room))}px`;
  tip.style.top = `${window.scrollY + event.clientY + 14}px`;
}

function listen(svg, tip) {
  const plot = svg.querySelector("g.plot");
  let points = null;
  let mark = null;
  const hide = () => {
    tip.hidden = true;
    if (mark) {
      mark.setAttribute("visibility", "hidden");
    }
  };
  const show = (event) => {
    points = points || pointsOf(plot);
    mark = mark || makeMark(plot);
    const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    const distance = (p) => Math.hypot(p.at - place.x, p.down - place.y);
    const best = points.reduce((a, b) => (a && distance(a) <= distance(b) ? a : b), null);
    if (!best || !(distance(best) < reach)) {
      hide();
      return;
    }
    mark.setAttribute("cx", best.at);
    mark.setAttribute("cy", best.down);
    mark.setAttribute("visibility", "visible");
    showTip(tip, wordsOf(plot, best), event);
  };
  svg.addEventListener("pointermove", show);
  svg.addEventListener("pointerdown", show); // a finger does not move before
  svg.addEventListener("pointerleave", hide);
}

const plots = [...document.querySelectorAll("svg")].filter((svg) => svg.querySelector("g.plot"));
const tip = makeTip();
plots.forEach((svg) => listen(svg, tip));
