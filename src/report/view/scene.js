// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies, edges, fronts and marks as three.js draws them.

const tints = ["#b4c7dd", "#e3cda6", "#b5d3b8", "#d3bad3", "#c9c9c9"];
const frontColour = 0xd55e00;
const markColour = 0x0072b2;
const chosenColour = 0x7b1fa2;

// Copies the places of points into an attribute.
function fillPlaces(attribute, points, places) {
  const array = attribute.array;
  for (let i = 0; i < points.length; ++i) {
    array[3 * i] = places[3 * points[i]];
    array[3 * i + 1] = places[3 * points[i] + 1];
    array[3 * i + 2] = places[3 * points[i] + 2];
  }
  attribute.needsUpdate = true;
}

function emptyGeometry(points) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * points.length), 3));
  return geometry;
}

// Numbers of the entries of a list that a rule holds for.
function chosen(count, rule) {
  const list = [];
  for (let i = 0; i < count; ++i) {
    if (rule(i)) {
      list.push(i);
    }
  }
  return list;
}

// One net: its faces, all edges of elements, its own edges, and what fills it where it is cut.
class Body {
  constructor(surface, normals, number, plane) {
    this.surface = surface;
    this.number = number;
    this.triangles = chosen(surface.faceOf.length, (t) => surface.body[surface.faceOf[t]] === number);
    this.points = Uint32Array.from(this.triangles.flatMap((t) => [0, 1, 2].map((i) => surface.triangles[3 * t + i])));
    const geometry = emptyGeometry(this.points);
    const light = new Float32Array(3 * this.points.length);
    this.triangles.forEach((t, i) => light.set(normals.subarray(9 * t, 9 * t + 9), 9 * i));
    geometry.setAttribute("normal", new THREE.BufferAttribute(light, 3));
    geometry.setAttribute("uv", new THREE.BufferAttribute(new Float32Array(2 * this.points.length), 2));
    const Material = plane ? THREE.MeshBasicMaterial : THREE.MeshLambertMaterial;
    this.material = new Material({ side: THREE.DoubleSide, polygonOffset: true,
      polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.mesh = new THREE.Mesh(geometry, this.material);
    this.mesh.frustumCulled = false;
    this.edges = this.makeEdges(() => true, 0x1b2733, 0.17);
    this.outline = this.makeEdges((e) => surface.edges.sharp[e], 0x10161d, 0.9);
    this.group = new THREE.Group();
    this.group.add(this.mesh, this.edges, this.outline);
    this.addFilling();
  }

  makeEdges(rule, colour, opacity) {
    const edges = this.surface.edges;
    const kept = chosen(edges.face.length, (e) => this.surface.body[edges.face[e]] === this.number && rule(e));
    const ends = kept.flatMap((e) => [edges.ends[2 * e], edges.ends[2 * e + 1]]);
    const lines = new THREE.LineSegments(emptyGeometry(ends),
      new THREE.LineBasicMaterial({ color: colour, transparent: true, opacity }));
    lines.frustumCulled = false;
    lines.userData.points = ends;
    return lines;
  }

  // A cut shows the inside of a body as solid: where more of its back than of its front is seen
  // behind the plane, the plane is drawn (stencil buffer).
  addFilling() {
    const count = (side, operation) => {
      const mesh = new THREE.Mesh(this.mesh.geometry, new THREE.MeshBasicMaterial({ side, colorWrite: false,
        depthWrite: false, depthTest: false, stencilWrite: true, stencilFunc: THREE.AlwaysStencilFunc,
        stencilFail: operation, stencilZFail: operation, stencilZPass: operation }));
      mesh.frustumCulled = false;
      return mesh;
    };
    const cap = new THREE.Mesh(new THREE.PlaneBufferGeometry(1, 1), new THREE.MeshBasicMaterial({
      color: tints[this.number % tints.length], side: THREE.DoubleSide, stencilWrite: true, stencilRef: 0,
      stencilFunc: THREE.NotEqualStencilFunc, stencilFail: THREE.ReplaceStencilOp,
      stencilZFail: THREE.ReplaceStencilOp, stencilZPass: THREE.ReplaceStencilOp }));
    cap.onAfterRender = (renderer) => renderer.clearStencil();
    this.counters = [count(THREE.BackSide, THREE.IncrementWrapStencilOp),
      count(THREE.FrontSide, THREE.DecrementWrapStencilOp)];
    this.cap = cap;
    [...this.counters, cap].forEach((part, i) => {
      part.renderOrder = 10 * this.number + (i < 2 ? 1 : 2);
      part.visible = false;
      this.group.add(part);
    });
    this.mesh.renderOrder = this.edges.renderOrder = this.outline.renderOrder = 1000;
  }

  place(places) {
    fillPlaces(this.mesh.geometry.attributes.position, this.points, places);
    for (const lines of [this.edges, this.outline]) {
      fillPlaces(lines.geometry.attributes.position, lines.userData.points, places);
    }
  }

  // Colours of a field, or the tint of the body.
  paint(values, scale, texture) {
    const map = values ? texture : null;
    this.material.color.set(values ? "#ffffff" : tints[this.number % tints.length]);
    if (this.material.map !== map) {
      this.material.map = map;
      this.material.needsUpdate = true;
    }
    const uv = this.mesh.geometry.attributes.uv;
    for (let i = 0; values && i < this.points.length; i += 3) {
      const own = [0, 1, 2].map((k) => values[this.points[i + k]]);
      const known = own.every(Number.isFinite);
      own.forEach((value, k) => uv.setXY(i + k, known ? partOf(scale, value) : 0.5, known ? 0.75 : 0.25));
    }
    uv.needsUpdate = true;
  }

  // Shows one side of a plane; null: all.
  cut(plane, size) {
    const planes = plane ? [plane] : null;
    for (const part of [this.mesh, this.edges, this.outline, ...this.counters]) {
      part.material.clippingPlanes = planes;
    }
    for (const part of [...this.counters, this.cap]) {
      part.visible = Boolean(plane);
    }
    if (plane) {
      plane.coplanarPoint(this.cap.position);
      this.cap.scale.set(size, size, 1);
      this.cap.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), plane.normal);
    }
  }
}

// Lines of several pixels through lists of places; points where a list has one place only.
class Strokes {
  // `order`: later ones lie above those before.
  constructor(colour, width, hidden, order) {
    this.order = order;
    this.group = new THREE.Group();
    const line = (opacity, depthTest) => new THREE.LineMaterial({ color: colour, linewidth: width,
      transparent: true, opacity, depthTest });
    // what lies behind a body is seen through it, faintly
    this.materials = [line(hidden, false), line(1, true)];
    this.dot = new THREE.PointsMaterial({ color: colour, size: 2.2 * width + 3, sizeAttenuation: false,
      depthTest: false, transparent: true, map: discTexture(), alphaTest: 0.5 });
  }

  draw(lists) {
    for (const part of this.group.children.splice(0)) {
      part.parent = null;
      part.geometry.dispose();
    }
    const ends = lists.flatMap((places) => places.slice(1).flatMap((place, i) => [...places[i], ...place]));
    if (ends.length > 0) {
      const geometry = new THREE.LineSegmentsGeometry().setPositions(new Float32Array(ends));
      this.materials.forEach((material) => this.add(new THREE.LineSegments2(geometry, material)));
    }
    const alone = lists.filter((places) => places.length === 1).flatMap((places) => places[0]);
    if (alone.length > 0) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(alone), 3));
      this.add(new THREE.Points(geometry, this.dot));
    }
  }

  add(part) {
    part.frustumCulled = false;
    part.renderOrder = this.order;
    this.group.add(part);
  }

  cut(plane) {
    for (const material of [...this.materials, this.dot]) {
      material.clippingPlanes = plane ? [plane] : null;
    }
  }

  resize(width, height) {
    this.materials.forEach((material) => material.resolution.set(width, height));
  }
}

function discTexture() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 32;
  const pen = canvas.getContext("2d");
  pen.fillStyle = "#fff";
  pen.beginPath();
  pen.arc(16, 16, 15, 0, 2 * Math.PI);
  pen.fill();
  return new THREE.CanvasTexture(canvas);
}

class BodyScene {
  constructor(canvas, context, data) {
    this.data = data;
    this.plane = data.dim === 2;
    this.renderer = new THREE.WebGLRenderer({ canvas, context, antialias: true, alpha: true });
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.localClippingEnabled = true;
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.AmbientLight(0xffffff, 0.74));
    this.lamp = new THREE.DirectionalLight(0xffffff, 0.36);
    this.scene.add(this.lamp, this.lamp.target);
    this.texture = bandTexture(data.colours);
    this.fronts = new Strokes(frontColour, 4, 0.45, 2002);
    this.marks = new Strokes(markColour, 1.5, 0.5, 2000);
    this.mark = new Strokes(chosenColour, 4, 0.8, 2001);
    this.pressed = new THREE.Group(); // values along edges of plane bodies
    this.scene.add(this.fronts.group, this.marks.group, this.mark.group, this.pressed);
    this.bodies = [];
    this.ray = new THREE.Raycaster();
  }

  // Another surface in place of the one before.
  build(surface) {
    for (const body of this.bodies) {
      this.scene.remove(body.group);
      body.group.traverse((part) => part.geometry && part.geometry.dispose());
    }
    this.surface = surface;
    this.anchors = new Map(); // places of fronts -> what they move with
    const normals = surface.cornerNormals();
    const numbers = [...new Set(surface.body)].sort((a, b) => a - b);
    this.bodies = numbers.map((number) => new Body(surface, normals, number, this.plane));
    this.bodies.forEach((body) => this.scene.add(body.group));
  }

  place(places) {
    this.places = places;
    this.bodies.forEach((body) => body.place(places));
    this.depth = largestNorm(places.map((v, i) => v - this.surface.centre[i % 3]));
  }

  // Where a place of a front is seen: it moves with the surface.
  seenPlace(place, u, factor) {
    if (!this.anchors.has(place)) {
      this.anchors.set(place, this.surface.anchorOf(place));
    }
    return this.surface.follow(place, this.anchors.get(place), u, factor);
  }

  paint(values, scale) {
    this.values = values;
    this.bodies.forEach((body) => body.paint(values, scale, this.texture));
    this.drawPressed(values, scale);
  }

  // Along edges of plane bodies a field that stands there alone is a line in its colours.
  drawPressed(values, scale) {
    for (const part of this.pressed.children.splice(0)) {
      part.geometry.dispose();
      part.material.dispose();
    }
    if (!this.plane || !values || values.every(Number.isFinite)) {
      return;
    }
    const { ends, sharp } = this.surface.edges;
    const places = [];
    const colours = [];
    for (let e = 0; e < sharp.length; ++e) {
      const pair = [ends[2 * e], ends[2 * e + 1]];
      if (sharp[e] && pair.every((p) => Number.isFinite(values[p]))) {
        for (const p of pair) {
          places.push(...this.places.subarray(3 * p, 3 * p + 3));
          const band = Math.floor(partOf(scale, values[p]) * this.data.colours.length);
          colours.push(...rgbOf(this.data.colours[band]).map((v) => v / 255));
        }
      }
    }
    if (places.length > 0) {
      const geometry = new THREE.LineSegmentsGeometry().setPositions(new Float32Array(places));
      geometry.setColors(new Float32Array(colours));
      const material = new THREE.LineMaterial({ color: 0xffffff, linewidth: 6, vertexColors: THREE.VertexColors,
        depthTest: false, transparent: true });
      material.resolution.copy(this.fronts.materials[0].resolution);
      const lines = new THREE.LineSegments2(geometry, material);
      lines.frustumCulled = false;
      lines.renderOrder = 1500;
      this.pressed.add(lines);
    }
  }

  show(hidden, withEdges) {
    for (const body of this.bodies) {
      body.group.visible = !hidden.has(body.number);
      body.edges.visible = withEdges;
    }
  }

  cut(plane) {
    this.clip = plane;
    for (const strokes of [this.fronts, this.marks, this.mark]) {
      strokes.cut(plane);
    }
    this.bodies.forEach((body) => body.cut(plane, 4 * this.surface.size));
  }

  resize(width, height) {
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.renderer.setSize(width, height, false);
    for (const strokes of [this.fronts, this.marks, this.mark]) {
      strokes.resize(width, height);
    }
    this.pressed.children.forEach((part) => part.material.resolution.set(width, height));
  }

  draw(eye) {
    eye.update(this.depth + eye.target.distanceTo(new THREE.Vector3(...this.surface.centre)));
    this.lamp.position.set(-0.5, 0.8, 1.2).applyQuaternion(eye.turn).add(eye.target);
    this.lamp.target.position.copy(eye.target);
    this.renderer.render(this.scene, eye.camera);
  }

  // What is under a place of the canvas (-1 to 1 both ways), or null: net, nearest point and the
  // value between the points.
  pick(eye, x, y) {
    this.ray.setFromCamera(new THREE.Vector2(x, y), eye.camera);
    const everything = new THREE.Sphere(new THREE.Vector3(), Infinity);
    for (const body of this.bodies) {
      body.mesh.geometry.boundingSphere = everything;
    }
    const seen = this.bodies.filter((body) => body.group.visible);
    const hits = this.ray.intersectObjects(seen.map((body) => body.mesh))
      .filter((hit) => !this.clip || this.clip.distanceToPoint(hit.point) >= 0);
    if (hits.length === 0) {
      return null;
    }
    const hit = hits[0];
    const body = seen.find((candidate) => candidate.mesh === hit.object);
    if (this.clip && !this.plane && hit.face.normal.dot(this.ray.ray.direction) > 0) {
      return { body: body.number, inside: true }; // where it is cut
    }
    const points = [0, 1, 2].map((i) => body.points[3 * hit.faceIndex + i]);
    const corners = points.map((p) => new THREE.Vector3(...this.places.subarray(3 * p, 3 * p + 3)));
    const weights = new THREE.Triangle(...corners).getBarycoord(hit.point, new THREE.Vector3()).toArray();
    const nearest = points[weights.indexOf(Math.max(...weights))];
    const value = this.values ? points.reduce((sum, p, i) => sum + weights[i] * this.values[p], 0) : NaN;
    return { body: body.number, point: nearest, value };
  }

  // The list and the place in it of what is within ten pixels of the pointer, or null; places as
  // fronts have them, `seen` says where they are.
  nearestOf(lists, seen, eye, x, y, width, height) {
    let best = null;
    let least = 10;
    lists.forEach((places, list) => places.forEach((place, at) => {
      const p = new THREE.Vector3(...seen(place)).project(eye.camera);
      const d = Math.hypot((p.x - x) * width / 2, (p.y - y) * height / 2);
      if (d < least) {
        least = d;
        best = { list, at };
      }
    }));
    return best;
  }
}
