// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of the bodies as triangles and edges between points.

const kink = 0.9; // cosine, 26 degrees: where an edge of the body is seen
const midNodes = 16; // in the kind of a face: every second point is no corner

// Triangles of a face by its points' places in the outline.
function trianglesOf(count, curved) {
  if (curved && count === 6) {
    return [[0, 1, 5], [1, 2, 3], [3, 4, 5], [1, 3, 5]];
  }
  if (curved && count === 8) {
    return [[0, 1, 7], [1, 2, 3], [3, 4, 5], [5, 6, 7], [1, 3, 5], [1, 5, 7]];
  }
  const fan = [];
  for (let i = 1; i + 1 < count; ++i) {
    fan.push([0, i, i + 1]);
  }
  return fan;
}

class Surface {
  constructor(raw, dim) {
    this.x = joinComponents(raw.x.map(readNumbers), dim);
    this.count = this.x.length / 3;
    this.label = readCounts(raw.label);
    this.kind = readCounts(raw.kind);
    this.outline = readCounts(raw.outline);
    this.body = readCounts(raw.body);
    this.readPartners(readCounts(raw.coincident));
    this.cutIntoTriangles();
    this.findNormals();
    this.findEdges();
    this.box();
  }

  // partner[point]: the point on the other face of a crack, or itself.
  readPartners(pairs) {
    this.partner = Uint32Array.from({ length: this.count }, (_, p) => p);
    for (let i = 0; i + 1 < pairs.length; i += 2) {
      this.partner[pairs[i]] = pairs[i + 1];
    }
    this.cracked = pairs.length > 0;
  }

  cutIntoTriangles() {
    const corners = [];
    const faces = [];
    this.first = new Uint32Array(this.kind.length + 1);
    for (let f = 0; f < this.kind.length; ++f) {
      const count = this.kind[f] % midNodes;
      for (const triangle of trianglesOf(count, this.kind[f] >= midNodes)) {
        for (const i of triangle) {
          corners.push(this.outline[this.first[f] + i]);
        }
        faces.push(f);
      }
      this.first[f + 1] = this.first[f] + count;
    }
    this.triangles = Uint32Array.from(corners);
    this.faceOf = Uint32Array.from(faces);
  }

  // Unit normals of faces: the area vector of their outline.
  findNormals() {
    this.normal = new Float64Array(3 * this.kind.length);
    this.area = new Float64Array(this.kind.length);
    const x = this.x;
    for (let f = 0; f < this.kind.length; ++f) {
      const n = [0, 0, 0];
      for (let i = this.first[f]; i < this.first[f + 1]; ++i) {
        const a = 3 * this.outline[i];
        const b = 3 * this.outline[i + 1 < this.first[f + 1] ? i + 1 : this.first[f]];
        n[0] += x[a + 1] * x[b + 2] - x[a + 2] * x[b + 1];
        n[1] += x[a + 2] * x[b] - x[a] * x[b + 2];
        n[2] += x[a] * x[b + 1] - x[a + 1] * x[b];
      }
      const size = Math.hypot(...n);
      this.area[f] = 0.5 * size;
      for (let c = 0; c < 3; ++c) {
        this.normal[3 * f + c] = size > 0 ? n[c] / size : 0;
      }
    }
  }

  cosine(f, g) {
    const n = this.normal;
    return n[3 * f] * n[3 * g] + n[3 * f + 1] * n[3 * g + 1] + n[3 * f + 2] * n[3 * g + 2];
  }

  // Edges as pairs of points, once each, with a face; those at which the body has an end or a kink.
  findEdges() {
    const met = new Map(); // edge -> its number
    const ends = [];
    const owner = [];
    const sharp = [];
    for (let f = 0; f < this.kind.length; ++f) {
      for (let i = this.first[f]; i < this.first[f + 1]; ++i) {
        const a = this.outline[i];
        const b = this.outline[i + 1 < this.first[f + 1] ? i + 1 : this.first[f]];
        const key = Math.min(a, b) * this.count + Math.max(a, b);
        const known = met.get(key);
        if (known === undefined) {
          met.set(key, owner.length);
          ends.push(a, b);
          owner.push(f);
          sharp.push(true);
        } else {
          sharp[known] = this.cosine(owner[known], f) < kink;
        }
      }
    }
    this.edges = { ends: Uint32Array.from(ends), face: Uint32Array.from(owner), sharp };
  }

  box() {
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < this.x.length; ++i) {
      this.low[i % 3] = Math.min(this.low[i % 3], this.x[i]);
      this.high[i % 3] = Math.max(this.high[i % 3], this.x[i]);
    }
    this.centre = this.low.map((v, c) => 0.5 * (v + this.high[c]));
    this.size = Math.hypot(...this.low.map((v, c) => this.high[c] - v));
  }

  // Normals for light, of each corner of each triangle: the mean of the faces there that have no
  // kink between them, so that bores look round and edges sharp.
  cornerNormals() {
    const facesAt = this.facesOfPoints();
    const normals = new Float32Array(3 * this.triangles.length);
    for (let i = 0; i < this.triangles.length; ++i) {
      const own = this.faceOf[(i / 3) | 0];
      const n = [0, 0, 0];
      for (const f of facesAt(this.triangles[i])) {
        if (this.cosine(own, f) > kink) {
          for (let c = 0; c < 3; ++c) {
            n[c] += this.area[f] * this.normal[3 * f + c];
          }
        }
      }
      const size = Math.hypot(...n) || 1;
      for (let c = 0; c < 3; ++c) {
        normals[3 * i + c] = n[c] / size;
      }
    }
    return normals;
  }

  // A function from a point to the faces that have it.
  facesOfPoints() {
    const start = new Uint32Array(this.count + 1);
    for (const p of this.outline) {
      ++start[p + 1];
    }
    for (let p = 0; p < this.count; ++p) {
      start[p + 1] += start[p];
    }
    const next = start.slice();
    const faces = new Uint32Array(this.outline.length);
    for (let f = 0; f < this.kind.length; ++f) {
      for (let i = this.first[f]; i < this.first[f + 1]; ++i) {
        faces[next[this.outline[i]]++] = f;
      }
    }
    return (p) => faces.subarray(start[p], start[p + 1]);
  }

  // Places under magnified displacements. Faces of cracks part by `opening` times what they do, the
  // middle between them moves with the bodies.
  displaced(u, factor, opening) {
    const places = new Float32Array(this.x.length);
    for (let p = 0; p < this.count; ++p) {
      const other = this.partner[p];
      for (let c = 0; c < 3; ++c) {
        const own = u[3 * p + c];
        const mean = 0.5 * (own + u[3 * other + c]);
        places[3 * p + c] = this.x[3 * p + c] + factor * mean + opening * (own - mean);
      }
    }
    return places;
  }

  // The largest way from a face of a crack to the middle between both.
  largestOpening(u) {
    let largest = 0;
    for (let p = 0; p < this.count; ++p) {
      const other = this.partner[p];
      largest = Math.max(largest, 0.5 * Math.hypot(u[3 * p] - u[3 * other],
        u[3 * p + 1] - u[3 * other + 1], u[3 * p + 2] - u[3 * other + 2]));
    }
    return largest;
  }

  // Centre and size of the crack faces, or null.
  crackBox() {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (let p = 0; p < this.count; ++p) {
      for (let c = 0; c < 3 && this.partner[p] !== p; ++c) {
        low[c] = Math.min(low[c], this.x[3 * p + c]);
        high[c] = Math.max(high[c], this.x[3 * p + c]);
      }
    }
    return this.cracked ? { centre: low.map((v, c) => 0.5 * (v + high[c])),
      size: Math.hypot(...low.map((v, c) => high[c] - v)) } : null;
  }

  // Triangles by a point that they have.
  trianglesAt(point) {
    if (!this.trianglesOfPoints) {
      this.trianglesOfPoints = new Map();
      this.triangles.forEach((p, i) => {
        const list = this.trianglesOfPoints.get(p) || [];
        list.push((i / 3) | 0);
        this.trianglesOfPoints.set(p, list);
      });
    }
    return this.trianglesOfPoints.get(point) || [];
  }

  // The point that is nearest to a place, of crack faces where there are some.
  nearestPoint(place) {
    let best = 0;
    let least = Infinity;
    for (let p = 0; p < this.count; ++p) {
      if (this.cracked && this.partner[p] === p) {
        continue;
      }
      const d = Math.hypot(this.x[3 * p] - place[0], this.x[3 * p + 1] - place[1],
        this.x[3 * p + 2] - place[2]);
      if (d < least) {
        least = d;
        best = p;
      }
    }
    return best;
  }

  // What a place of a front moves with: three points and their weights, those of the nearest place
  // of the surface.
  anchorOf(place) {
    const at = new THREE.Vector3(...place);
    const corner = (p) => new THREE.Vector3(...this.x.subarray(3 * p, 3 * p + 3));
    let best = null;
    let least = Infinity;
    for (const t of this.trianglesAt(this.nearestPoint(place))) {
      const points = [...this.triangles.subarray(3 * t, 3 * t + 3)];
      const triangle = new THREE.Triangle(...points.map(corner));
      const foot = triangle.closestPointToPoint(at, new THREE.Vector3());
      const distance = foot.distanceToSquared(at);
      if (distance < least) {
        least = distance;
        best = { points, weights: triangle.getBarycoord(foot, new THREE.Vector3()).toArray() };
      }
    }
    return best;
  }

  // Where a place with that anchor is seen: between the faces of a crack.
  follow(place, anchor, u, factor) {
    return place.map((v, c) => v + 0.5 * factor * anchor.points.reduce((sum, p, i) =>
      sum + anchor.weights[i] * (u[3 * p + c] + u[3 * this.partner[p] + c]), 0));
  }
}

// The value that a part of an area stays below; `weighted`: [value, area], any order.
function levelOf(weighted, part) {
  const sorted = weighted.slice().sort((a, b) => a[0] - b[0]);
  const total = sorted.reduce((sum, [, area]) => sum + area, 0);
  let sum = 0;
  for (const [value, area] of sorted) {
    sum += area;
    if (sum >= part * total) {
      return value;
    }
  }
  return sorted.length > 0 ? sorted[sorted.length - 1][0] : 0;
}
