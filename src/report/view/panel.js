// SPDX-License-Identifier: GPL-3.0-or-later
// What the reader sets: plain form elements, all of which the keyboard reaches.

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

// A row of the panel: words before a control.
function row(words, ...controls) {
  return element("label", { className: "view-row" }, element("span", { textContent: words }), ...controls);
}

function choice(id, names, change) {
  const select = element("select", { id });
  names.forEach((name, i) => select.append(element("option", { value: String(i), textContent: name })));
  select.addEventListener("change", () => change(Number(select.value)));
  return select;
}

function slider(id, value, change) {
  const input = element("input", { id, type: "range", min: "0", max: "100", step: "1", value: String(value) });
  input.addEventListener("input", () => change(Number(input.value)));
  return input;
}

function box(id, words, checked, change) {
  const input = element("input", { id, type: "checkbox", checked });
  input.addEventListener("change", () => change(input.checked));
  return element("label", { className: "view-box" }, input, ` ${words}`);
}

function button(id, words, title, press) {
  const made = element("button", { id, type: "button", textContent: words, title });
  made.addEventListener("click", press);
  return made;
}

// The stage: picture with axes and tip of the pointer, colour bar and readings below, panel beside.
function makeStage(stage, label) {
  const canvas = element("canvas", { id: "view-canvas", tabIndex: 0 });
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", label);
  const axes = svgElement("svg", { class: "view-axes", width: 66, height: 66, viewBox: "-42 -42 84 84",
    "aria-hidden": "true" });
  const tip = element("div", { id: "view-tip", className: "view-tip", hidden: true });
  const bar = svgElement("svg", { id: "view-bar", "aria-label": "values of the colours", role: "img" });
  const field = element("div", { id: "view-field-name", className: "view-field-name" });
  const place = element("div", { id: "view-place", className: "view-place" });
  const screen = element("div", { className: "view-screen" }, canvas, axes, place, tip);
  const legend = element("div", { className: "view-legend" }, field, bar);
  const panel = element("form", { className: "view-panel" });
  panel.addEventListener("submit", (event) => event.preventDefault());
  stage.append(element("div", { className: "view-left" }, screen, legend), panel);
  return { canvas, axes, tip, bar, field, place, screen, panel };
}

// Draws where the axes point; one that points to the reader has no letter.
function drawAxes(svg, turn, dim) {
  svg.replaceChildren();
  const back = turn.clone().inverse();
  ["x", "y", "z"].slice(0, dim).forEach((name, c) => {
    const way = new THREE.Vector3().setComponent(c, 1).applyQuaternion(back);
    const [x, y] = [22 * way.x, -22 * way.y];
    const colour = ["#b3261e", "#1d7a33", "#1f4fa8"][c];
    svg.append(svgElement("line", { x1: 0, y1: 0, x2: x, y2: y, stroke: colour, "stroke-width": 2.2 }));
    if (Math.hypot(x, y) > 6) {
      const long = 31 / Math.hypot(x, y);
      svg.append(svgElement("text", { x: x * long, y: y * long + 4, fill: colour, "font-size": 13,
        "text-anchor": "middle", "font-weight": "bold" }, name));
    }
  });
}
