// SPDX-License-Identifier: GPL-3.0-or-later
// What the page carries for the view, as encoded_array.cpp and view_data.cpp write it.

function bytesOf(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) {
    bytes[i] = letters.charCodeAt(i);
  }
  return bytes;
}

// The text of an element that was packed by zlib.
function unpack(id) {
  const packed = new Blob([bytesOf(document.getElementById(id).textContent)]);
  return new Response(packed.stream().pipeThrough(new DecompressionStream("deflate"))).text();
}

// Whole numbers of one, two or four bytes.
function readCounts(encoded) {
  if ("u8" in encoded) {
    return bytesOf(encoded.u8);
  }
  return "u16" in encoded ? new Uint16Array(bytesOf(encoded.u16).buffer)
                          : new Uint32Array(bytesOf(encoded.u32).buffer);
}

// Numbers in even steps between the least and the largest; NaN where there is none.
function readNumbers(encoded) {
  if ("value" in encoded) {
    return new Float64Array(encoded.count).fill(encoded.value);
  }
  const none = 65535;
  const step = (encoded.high - encoded.low) / (none - 1);
  const steps = new Uint16Array(bytesOf(encoded.u16).buffer);
  return Float64Array.from(steps, (s) => (s === none ? NaN : encoded.low + step * s));
}

// Values of few points among `count`.
function readSparse(encoded, count) {
  const values = new Float64Array(count).fill(NaN);
  const given = readNumbers(encoded.values);
  readCounts(encoded.at).forEach((point, i) => {
    values[point] = given[i];
  });
  return values;
}

// Components one by one become places in space, x y z x y z ..
function joinComponents(components, dim) {
  const count = components[0].length;
  const places = new Float64Array(3 * count);
  for (let c = 0; c < dim; ++c) {
    for (let p = 0; p < count; ++p) {
      places[3 * p + c] = components[c][p];
    }
  }
  return places;
}

// The largest of the lengths of vectors x y z x y z ..
function largestNorm(vectors) {
  let largest = 0;
  for (let i = 0; i < vectors.length; i += 3) {
    largest = Math.max(largest, Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]));
  }
  return largest;
}

// A step whose arrays are read when they are asked for, once.
class Step {
  constructor(raw, dim, count) {
    this.raw = raw;
    this.dim = dim;
    this.count = count;
    this.known = new Map();
  }
  get name() {
    return this.raw.name;
  }
  // Displacements of the points, x y z x y z ..
  get u() {
    return this.once("u", () => joinComponents(this.raw.u.map(readNumbers), this.dim));
  }
  has(key) {
    return key.startsWith("u") || key in this.raw.fields;
  }
  // A value for each point: u is the size of displacements, u0 u1 u2 their components.
  values(key) {
    return this.once(`values ${key}`, () => {
      if (key === "u") {
        const u = this.u;
        return Float64Array.from({ length: this.count },
          (_, p) => Math.hypot(u[3 * p], u[3 * p + 1], u[3 * p + 2]));
      }
      if (key.startsWith("u")) {
        return readNumbers(this.raw.u[Number(key.slice(1))]);
      }
      const encoded = this.raw.fields[key];
      return "at" in encoded ? readSparse(encoded, this.count) : readNumbers(encoded);
    });
  }
  once(name, make) {
    if (!this.known.has(name)) {
      this.known.set(name, make());
    }
    return this.known.get(name);
  }
}

// A crack length: its surface and its steps.
class Length {
  constructor(raw, dim) {
    this.name = raw.name;
    this.fronts = raw.fronts;
    this.raw = raw;
    this.dim = dim;
  }
  get surface() {
    if (!this.made) {
      this.made = new Surface(this.raw, this.dim);
      this.madeSteps = this.raw.steps.map((step) => new Step(step, this.dim, this.made.count));
    }
    return this.made;
  }
  get steps() {
    return this.surface && this.madeSteps;
  }
}

// All fields that a reader may choose: first none, then displacements, then what steps have.
function fieldsOf(data) {
  const length = data.lengthUnit;
  const components = ["x", "y", "z"].slice(0, data.dim);
  return [
    { key: "", name: "none: bodies", unit: "" },
    { key: "u", name: "displacement", unit: length },
    ...components.map((axis, c) => ({ key: `u${c}`, name: `displacement along ${axis}`, unit: length })),
    ...data.fields,
  ];
}

// About four digits, as tables of the page have them.
function shortNumber(value) {
  if (!Number.isFinite(value)) {
    return "–";
  }
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-3)) {
    return value.toExponential(2).replace("e+", "e");
  }
  return String(Number(value.toPrecision(4)));
}
