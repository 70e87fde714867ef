// SPDX-License-Identifier: GPL-3.0-or-later
// From values to colours: bands, as the still pictures have them, and the bar that tells their values.

const noValue = [0xc9, 0xcd, 0xd3]; // where a field is not known

function rgbOf(colour) {
  return [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
}

// One row of bands (v = 0.75) above one of the colour of what is not known (v = 0.25).
function bandTexture(colours) {
  const row = colours.flatMap((colour) => [...rgbOf(colour), 255]);
  const grey = colours.flatMap(() => [...noValue, 255]);
  const texture = new THREE.DataTexture(Uint8Array.from([...grey, ...row]), colours.length, 2, THREE.RGBAFormat);
  texture.magFilter = texture.minFilter = THREE.NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

// Ends of the colours: of stresses without the highest of the surface, as a crack tip or a sharp
// corner would have all colours for itself. `cut`: some values lie beyond.
function scaleOf(surface, values, key) {
  const weighted = [];
  let low = Infinity;
  let high = -Infinity;
  const corners = surface.triangles;
  for (let t = 0; t < corners.length; t += 3) {
    const all = [values[corners[t]], values[corners[t + 1]], values[corners[t + 2]]];
    if (all.every(Number.isFinite)) {
      weighted.push([(all[0] + all[1] + all[2]) / 3, surface.area[surface.faceOf[t / 3]]]);
    }
    for (const value of all) {
      low = Number.isFinite(value) ? Math.min(low, value) : low;
      high = Number.isFinite(value) ? Math.max(high, value) : high;
    }
  }
  if (!(high >= low)) {
    return { low: 0, high: 0, least: NaN, largest: NaN, cut: false };
  }
  const scale = { low, high, least: low, largest: high, cut: false };
  if (key === "mises" || key === "p1") {
    const most = levelOf(weighted, 0.99);
    const few = key === "p1" ? levelOf(weighted, 0.01) : low;
    scale.cut = most > few && (high > most || low < few);
    [scale.low, scale.high] = most > few ? [few, most] : [low, high];
  }
  if (Math.abs(scale.low) < 1e-3 * scale.high) {
    scale.low = 0; // what is next to nothing
  }
  if (!(scale.high - scale.low > 1e-6 * Math.abs(scale.high))) {
    scale.low = Math.min(0, scale.high); // one value has one colour, not round-off in twelve
    scale.high = Math.max(0, scale.high);
  }
  return scale;
}

// Where a value is between the ends, 0 to 1.
function partOf(scale, value) {
  const part = scale.high > scale.low ? (value - scale.low) / (scale.high - scale.low) : 0;
  return Math.min(0.999, Math.max(0.001, part));
}

// Round numbers between two, five to seven.
function roundTicks(low, high) {
  const raw = (high - low) / 7;
  if (!(raw > 0) || !Number.isFinite(raw)) {
    return [];
  }
  const decade = 10 ** Math.floor(Math.log10(raw));
  const step = decade * [1, 2, 5, 10].find((lead) => lead * decade >= 0.999 * raw);
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) {
    ticks.push(Number((i * step).toPrecision(10)));
  }
  return ticks;
}

function svgElement(name, attributes, words) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) {
    element.setAttribute(key, value);
  }
  if (words !== undefined) {
    element.textContent = words;
  }
  return element;
}

// Draws bands with round numbers below into a drawing of this width.
function drawColourBar(svg, scale, colours, width) {
  const left = 34;
  const room = width - 2 * left;
  svg.replaceChildren();
  svg.setAttribute("viewBox", `0 0 ${width} 34`);
  svg.setAttribute("width", width);
  svg.setAttribute("height", 34);
  if (!(scale.high > scale.low)) {
    svg.append(svgElement("text", { x: left, y: 14, "font-size": 12 },
      Number.isFinite(scale.largest) ? `${shortNumber(scale.largest)} everywhere` : "not known at this step"));
    return;
  }
  colours.forEach((colour, i) => {
    svg.append(svgElement("rect", { x: left + i * room / colours.length, y: 2, height: 12,
      width: room / colours.length + 0.5, fill: colour }));
  });
  let free = -Infinity; // numbers do not touch each other
  for (const tick of roundTicks(scale.low, scale.high)) {
    const x = left + room * (tick - scale.low) / (scale.high - scale.low);
    const words = shortNumber(tick);
    const half = 3.5 * words.length;
    svg.append(svgElement("line", { x1: x, x2: x, y1: 14, y2: 18, stroke: "#333" }));
    if (x - half > free) {
      svg.append(svgElement("text", { x, y: 30, "font-size": 12, "text-anchor": "middle" }, words));
      free = x + half + 4;
    }
  }
}
