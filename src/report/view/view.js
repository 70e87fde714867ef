// SPDX-License-Identifier: GPL-3.0-or-later
// The view of a report: puts data, picture and panel together.

const fewFaces = 8000; // up to which edges of elements do not hide the colours

class View {
  constructor(data, stage, parts, context) {
    this.data = data;
    this.parts = parts;
    this.lengths = data.lengths.map((raw) => new Length(raw, data.dim));
    this.fields = fieldsOf(data);
    this.scene = new BodyScene(parts.canvas, context, data);
    this.eye = new Eye(parts.canvas, data.dim === 2, () => this.drawSoon());
    const last = this.lengths.length - 1;
    const steps = this.lengths[last].steps;
    this.state = { length: last, step: Math.max(0, steps.findIndex((s) => s.name === data.startStep)),
      field: 0, displacement: 50, opening: 40, hidden: new Set(), axis: 0, cut: 50, side: 1, flip: false,
      edges: this.lengths[last].surface.kind.length <= fewFaces, mark: data.marks.length - 1, range: null };
    this.state.field = this.firstField();
    this.fillPanel();
    this.showLength();
    this.resize();
    this.home();
    new ResizeObserver(() => this.resize()).observe(parts.screen);
    this.readings = new Readings(this);
    parts.canvas.addEventListener("keydown", (event) => this.key(event));
  }

  get length() {
    return this.lengths[this.state.length];
  }
  get step() {
    return this.length.steps[Math.min(this.state.step, this.length.steps.length - 1)];
  }
  get field() {
    return this.fields[this.state.field];
  }

  // Stresses where the step has them, else how far the bodies move.
  firstField() {
    const key = this.step.has("mises") ? "mises" : "u";
    return this.fields.findIndex((field) => field.key === key);
  }

  set(change) {
    Object.assign(this.state, change);
    this.refresh();
  }

  fillPanel() {
    const add = (...rows) => this.parts.panel.append(...rows);
    add(row("Field", this.fieldChoice()));
    if (this.lengths.length > 1) {
      const select = choice("view-length", this.lengths.map((l) => l.name),
        (length) => { this.state.length = length; this.showLength(); });
      select.value = String(this.state.length);
      add(row("Length", select));
    }
    add(row("Step", this.stepChoice = choice("view-step", [], (step) => this.set({ step, range: null }))));
    add(this.colourRow());
    this.factorWords = element("output");
    add(row("Displacements", slider("view-displacement", this.state.displacement,
      (displacement) => this.set({ displacement })), this.factorWords));
    if (this.lengths.some((length) => length.raw.coincident && Object.values(length.raw.coincident)[0] !== "")) {
      this.openingWords = element("output");
      add(row("Crack faces", slider("view-opening", this.state.opening,
        (opening) => this.set({ opening })), this.openingWords));
    }
    if (this.data.dim === 3) {
      add(this.cutRow());
    }
    this.addMarks();
    add(this.bodyBoxes());
    add(this.buttons());
    add(element("p", { className: "view-help", textContent: this.help() }));
  }

  help() {
    const turn = this.data.dim === 3 ? "Drag to turn, with shift or the right button to move" : "Drag to move";
    return `${turn}. After a click the wheel zooms, and the arrow keys, + and - work.`;
  }

  fieldChoice() {
    this.fieldSelect = choice("view-field", this.fields.map((f) => f.name),
      (field) => this.set({ field, range: null }));
    this.fieldSelect.value = String(this.state.field);
    return this.fieldSelect;
  }

  // Ends of the colours, which a reader may set.
  colourRow() {
    const end = (id) => {
      const input = element("input", { id, type: "number", step: "any", className: "view-end" });
      input.addEventListener("change", () => this.set({ range: [Number(this.low.value), Number(this.high.value)] }));
      return input;
    };
    this.low = end("view-low");
    this.high = end("view-high");
    this.low.setAttribute("aria-label", "colours from");
    this.high.setAttribute("aria-label", "colours to");
    return element("div", { className: "view-row" }, element("span", { textContent: "Colours" }), this.low,
      "to", this.high,
      button("view-auto", "auto", "ends of the colours by the values", () => this.set({ range: null })));
  }

  cutRow() {
    const select = choice("view-cut-axis", ["none", "x", "y", "z"],
      (axis) => this.set({ axis, side: this.farSide(axis - 1) }));
    select.setAttribute("aria-label", "axis of the cut");
    const where = slider("view-cut", this.state.cut, (cut) => this.set({ cut }));
    where.setAttribute("aria-label", "place of the cut");
    return element("div", { className: "view-row" }, element("span", { textContent: "Cut along" }), select, where,
      box("view-flip", "other side", false, (flip) => this.set({ flip })));
  }

  bodyBoxes() {
    const name = (number) => this.data.bodies[number] || (this.data.bodies.length > 1 ? `body ${number + 1}` : "body");
    const numbers = [...new Set(this.length.surface.body)].sort((a, b) => a - b);
    const toggle = (number) => box(`view-body-${number}`, name(number), true, (on) => {
      this.state.hidden[on ? "delete" : "add"](number);
      this.refresh();
    });
    const boxes = numbers.length < 2 ? [] : numbers.map(toggle);
    this.bodyName = name;
    return element("div", { className: "view-boxes" }, ...boxes,
      box("view-edges", "element edges", this.state.edges, (edges) => this.set({ edges })));
  }

  buttons() {
    const look = (axis) => button(`view-from-${axis}`, axis, `look from ${axis}`, () => this.eye.lookFrom(views[axis]));
    const near = this.length.fronts.length > 0
      ? [button("view-crack", "crack", "look at the crack", () => this.lookAtCrack())] : [];
    return element("div", { className: "view-buttons" },
      button("view-reset", "reset", "as at first", () => this.home()), ...near, ...(this.data.dim === 3 ? Object.keys(views).map(look) : []));
  }

  addMarks() {
    const marks = this.data.marks;
    if (marks.length < 2) {
      return;
    }
    const input = slider("view-mark", marks.length - 1, (mark) => this.set({ mark }));
    input.max = String(marks.length - 1);
    this.markSlider = input;
    this.markWords = element("output", { className: "view-mark-words" });
    this.playButton = button("view-play", "play", "the fronts one after another", () => this.play());
    this.parts.panel.append(element("div", { className: "view-row" }, element("span", { textContent: "Fronts" }), input,
      this.playButton), this.markWords);
  }

  // One front after another, twice a second at most, eight seconds for all.
  play() {
    if (this.timer) {
      clearInterval(this.timer);
      this.timer = 0;
      this.playButton.textContent = "play";
      return;
    }
    const count = this.data.marks.length;
    let mark = -1;
    this.playButton.textContent = "stop";
    this.timer = setInterval(() => {
      mark += 1;
      if (mark >= count) {
        this.play();
        return;
      }
      this.markSlider.value = String(mark);
      this.set({ mark });
    }, Math.min(500, 8000 / count));
  }

  // A surface is shown, with its steps to choose from.
  showLength() {
    const before = this.stepChoice.selectedOptions[0];
    const name = before ? before.textContent : this.data.startStep;
    const names = this.length.steps.map((step) => step.name);
    const option = (words, i) => element("option", { value: String(i), textContent: words });
    this.stepChoice.replaceChildren(...names.map(option));
    this.state.step = Math.max(0, names.indexOf(name));
    this.stepChoice.value = String(this.state.step);
    this.stepChoice.disabled = names.length < 2;
    const surface = this.length.surface;
    this.scene.build(surface);
    this.refresh();
  }

  // Largest displacement a fifteenth of the size where the slider is in its middle.
  get factor() {
    const largest = largestNorm(this.step.u);
    const natural = largest > 0 ? this.length.surface.size / 15 / largest : 0;
    return natural * (this.state.displacement / 50) ** 2;
  }

  // With the slider at its left the faces part as the bodies deform; at its right by a third of the
  // crack's size more.
  get openingFactor() {
    const surface = this.length.surface;
    const box = surface.crackBox();
    const largest = box ? surface.largestOpening(this.step.u) : 0;
    const widest = largest > 0 ? box.size / 6 / largest : 0;
    return this.factor + widest * (this.state.opening / 100) ** 2;
  }

  refresh() {
    const { surface } = this.length;
    for (const [i, field] of this.fields.entries()) {
      this.fieldSelect.options[i].disabled = field.key !== "" && !this.step.has(field.key);
    }
    const factor = this.factor;
    const opening = surface.cracked ? this.openingFactor : factor;
    this.factorWords.textContent = `× ${shortNumber(Number(factor.toPrecision(2)))}`;
    if (this.openingWords) {
      this.openingWords.textContent = `× ${shortNumber(Number(opening.toPrecision(2)))}`;
    }
    this.scene.place(surface.displaced(this.step.u, factor, opening));
    this.paint(surface);
    this.scene.show(this.state.hidden, this.state.edges);
    this.scene.cut(this.cutPlane(surface));
    this.drawFronts(factor);
    const shown = [`step ${this.step.name}`, this.length.name, this.largestK()];
    this.parts.place.textContent = shown.filter(Boolean).join(", ");
    this.drawSoon();
  }

  // Of all points of fronts that have a K.
  largestK() {
    const all = this.step.raw.K1.flat().filter((K) => K !== null);
    const most = all.length > 1 ? "up to " : "";
    return all.length > 0 ? `K₁ ${most}${shortNumber(Math.max(...all))} ${this.data.kUnit}` : "";
  }

  paint(surface) {
    const field = this.field;
    const known = field.key !== "" && this.step.has(field.key);
    const values = known ? this.step.values(field.key) : null;
    let scale = values ? scaleOf(surface, values, field.key) : { low: 0, high: 0, largest: NaN, cut: false };
    if (values && this.state.range && this.state.range[1] > this.state.range[0]) {
      scale = { ...scale, low: this.state.range[0], high: this.state.range[1] };
      scale.cut = scale.least < scale.low || scale.largest > scale.high;
    }
    this.scale = scale;
    this.scene.paint(values, scale);
    this.low.value = values ? Number(scale.low.toPrecision(3)) : "";
    this.high.value = values ? Number(scale.high.toPrecision(3)) : "";
    this.low.disabled = this.high.disabled = !values;
    this.drawLegend();
  }

  drawLegend() {
    const field = this.field;
    const known = this.scene.values !== null;
    const beyond = this.scale.cut
      ? `; values from ${shortNumber(this.scale.least)} to ${shortNumber(this.scale.largest)}` : "";
    const missing = field.key === "" ? "" : `${field.name}: not known at this step`;
    this.parts.field.textContent = known ? `${field.name}, ${field.unit}${beyond}` : missing;
    this.parts.bar.style.display = known ? "" : "none";
    drawColourBar(this.parts.bar, this.scale, this.data.colours, Math.min(560, this.parts.screen.clientWidth));
  }

  // Of a cut the side that is farther from the eye: so the cut is seen.
  farSide(c) {
    const towards = new THREE.Vector3(0, 0, 1).applyQuaternion(this.eye.turn);
    return c >= 0 && towards.getComponent(c) > 0 ? -1 : 1;
  }

  cutPlane(surface) {
    if (this.state.axis === 0) {
      return null;
    }
    const c = this.state.axis - 1;
    const at = surface.low[c] + (surface.high[c] - surface.low[c]) * (0.002 + 0.996 * this.state.cut / 100);
    const side = this.state.flip ? -this.state.side : this.state.side;
    return new THREE.Plane(new THREE.Vector3().setComponent(c, side), -side * at);
  }

  // Fronts of the length, and of a growth all others as marks with the chosen one heavy.
  drawFronts(factor) {
    const closed = (front) => (front.loop ? [...front.x, front.x[0]] : front.x);
    const seen = (place) => this.scene.seenPlace(place, this.step.u, factor);
    const lists = (fronts) => fronts.map((front) => closed(front).map(seen));
    const marks = this.data.marks;
    this.scene.fronts.draw(lists(this.length.fronts));
    this.scene.marks.draw(marks.flatMap((mark) => lists(mark.fronts)).concat(this.ways(seen)));
    this.scene.mark.draw(marks.length > 1 ? lists(marks[this.state.mark].fronts) : []);
    if (marks.length > 1) {
      const mark = marks[this.state.mark];
      const cycles = mark.N === undefined ? "" : `N = ${shortNumber(mark.N)} ${this.data.cycleUnits}, `;
      this.markWords.textContent = `${cycles}a = ${shortNumber(mark.a)} ${this.data.lengthUnit}`;
    }
  }

  // The lines that tips in the plane have gone along.
  ways(seen) {
    const names = new Map();
    for (const front of this.data.marks.flatMap((mark) => mark.fronts)) {
      if (front.x.length === 1) {
        names.set(front.name, [...(names.get(front.name) || []), seen(front.x[0])]);
      }
    }
    return [...names.values()].filter((places) => places.length > 1);
  }

  home() {
    this.eye.fit(this.scene.places, slantedAgainst(this.wayOfGrowth()), 1.08);
  }

  // The mean way in which fronts grow: the eye stands behind them, where the mouth is.
  wayOfGrowth() {
    const fronts = this.length.fronts;
    return [0, 1, 2].map((c) => fronts.reduce((sum, front) => sum + front.way[c], 0) / Math.max(1, fronts.length));
  }

  // The crack and as much again round it.
  lookAtCrack() {
    const { surface } = this.length;
    const box = surface.crackBox() || this.frontBox();
    const half = Math.max(0.6 * box.size, 1e-3 * surface.size);
    const seen = this.scene.seenPlace(box.centre, this.step.u, this.factor);
    const corners = [-half, half].flatMap((dx) => [-half, half].flatMap((dy) => [-half, half].flatMap((dz) =>
      [seen[0] + dx, seen[1] + dy, seen[2] + (this.data.dim === 3 ? dz : 0)])));
    this.eye.fit(corners, slantedAgainst(this.wayOfGrowth()), 1);
  }

  // Round the fronts of all lengths.
  frontBox() {
    const all = [...this.length.fronts, ...this.data.marks.flatMap((mark) => mark.fronts)];
    const places = all.flatMap((front) => front.x);
    const low = [0, 1, 2].map((c) => Math.min(...places.map((x) => x[c])));
    const high = [0, 1, 2].map((c) => Math.max(...places.map((x) => x[c])));
    const size = Math.hypot(...low.map((v, c) => high[c] - v));
    return { centre: low.map((v, c) => 0.5 * (v + high[c])), size: Math.max(size, 0.05 * this.length.surface.size) };
  }

  key(event) {
    if (event.key === "0" || event.key === "Home") {
      this.home();
      event.preventDefault();
    }
  }

  resize() {
    const width = this.parts.screen.clientWidth;
    const height = this.parts.screen.clientHeight;
    if (width > 0 && height > 0) {
      this.scene.resize(width, height);
      this.drawLegend();
      this.drawSoon();
    }
  }

  // At most once in a frame.
  drawSoon() {
    if (!this.waiting && this.scene.surface) {
      this.waiting = true;
      requestAnimationFrame(() => {
        this.waiting = false;
        this.scene.draw(this.eye);
        drawAxes(this.parts.axes, this.eye.turn, this.data.dim);
      });
    }
  }
}

// A drawing context, or null where the browser has none; three.js would complain aloud.
function contextOf(canvas) {
  const wanted = { alpha: true, antialias: true, stencil: true };
  return canvas.getContext("webgl2", wanted) || canvas.getContext("webgl", wanted);
}

// three.js, which runs as soon as it stands in the page.
async function loadLibrary() {
  document.head.append(element("script", { textContent: await unpack("view-library") }));
}

function stayStill(why) {
  document.getElementById("view-stage").remove();
  document.getElementById("view-word").textContent = `${why}: the pictures of this page are still.`;
}

async function begin() {
  if (typeof DecompressionStream === "undefined") {
    stayStill("This browser is too old for the view");
    return;
  }
  const stage = document.getElementById("view-stage");
  const parts = makeStage(stage, "The bodies, to be turned; the pictures of this page show the same");
  const context = contextOf(parts.canvas);
  if (!context) {
    stayStill("This browser does not draw in space (WebGL)");
    return;
  }
  await loadLibrary();
  const data = JSON.parse(await unpack("view-data"));
  stage.classList.add("view-works");
  window.spricka = { view: new View(data, stage, parts, context) };
}

begin();
