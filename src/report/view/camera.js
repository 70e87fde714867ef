// SPDX-License-Identifier: GPL-3.0-or-later
// The eye: turned, moved and drawn nearer by mouse, fingers and keys. Nothing is changed of the page's
// own scrolling but where the picture has been clicked on.

// As the still pictures, from any corner.
const slantedWays = [0.5, -0.5, 0.75, -0.75].flatMap((first) => [-1, 1].flatMap((side) =>
  [0.45, -0.45].map((up) => [first, side * (1.25 - Math.abs(first)), up])));

// Of slanted directions the one that sees best what faces against `way`, from above where that is the same.
function slantedAgainst(way) {
  const seen = ([x, y, z]) => (z > 0 ? 0.1 : 0) - (x * way[0] + y * way[1] + z * way[2]);
  return slantedWays.reduce((best, other) => (seen(other) > seen(best) + 1e-9 ? other : best));
}

const views = { x: [1, 0, 0], "-x": [-1, 0, 0], y: [0, 1, 0], "-y": [0, -1, 0], z: [0, 0, 1], "-z": [0, 0, -1] };

class Eye {
  // `plane`: bodies of the plane are seen from above alone. `changed` is called after each move.
  constructor(canvas, plane, changed) {
    this.canvas = canvas;
    this.plane = plane;
    this.changed = changed;
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
    this.turn = new THREE.Quaternion();
    this.target = new THREE.Vector3();
    this.half = 1; // half height of what is seen [length]
    this.depth = 1; // how far bodies reach from the target [length]
    this.fingers = new Map();
    this.listen();
  }

  // Looks from a direction so that these places (x y z x y z ..) just fill the picture, `margin` times.
  fit(places, towards, margin) {
    this.lookFrom(towards);
    const [right, up, back] = [0, 1, 2].map((c) => new THREE.Vector3().setComponent(c, 1).applyQuaternion(this.turn));
    const reach = [right, up, back].map((way) => {
      let low = Infinity;
      let high = -Infinity;
      for (let i = 0; i < places.length; i += 3) {
        const at = places[i] * way.x + places[i + 1] * way.y + places[i + 2] * way.z;
        low = Math.min(low, at);
        high = Math.max(high, at);
      }
      return { middle: 0.5 * (low + high), half: 0.5 * (high - low) };
    });
    this.target.set(0, 0, 0);
    [right, up, back].forEach((way, c) => this.target.addScaledVector(way, reach[c].middle));
    const aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    this.half = margin * Math.max(reach[1].half, reach[0].half / aspect, 1e-9);
    this.changed();
  }

  lookFrom(towards) {
    const back = new THREE.Vector3(...(this.plane ? [0, 0, 1] : towards)).normalize();
    const upward = Math.abs(back.z) > 0.999 ? new THREE.Vector3(0, 1, 0) : new THREE.Vector3(0, 0, 1);
    const right = upward.cross(back).normalize();
    const up = back.clone().cross(right);
    this.turn.setFromRotationMatrix(new THREE.Matrix4().makeBasis(right, up, back));
    this.changed();
  }

  // The camera as it is to be for a picture.
  update(depth) {
    const aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    const camera = this.camera;
    camera.left = -this.half * aspect;
    camera.right = this.half * aspect;
    camera.top = this.half;
    camera.bottom = -this.half;
    const away = 2 * depth + this.half;
    camera.near = 0.01 * away;
    camera.far = 2 * away;
    camera.quaternion.copy(this.turn);
    camera.position.set(0, 0, away).applyQuaternion(this.turn).add(this.target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld(true);
  }

  // Angles about the upright and the level axis of the screen.
  rotate(across, down) {
    if (this.plane) {
      return;
    }
    const step = new THREE.Quaternion().setFromEuler(new THREE.Euler(-down, -across, 0, "YXZ"));
    this.turn.multiply(step).normalize();
    this.changed();
  }

  // By pixels.
  pan(right, down) {
    const scale = 2 * this.half / Math.max(1, this.canvas.clientHeight);
    this.target.add(new THREE.Vector3(-right * scale, down * scale, 0).applyQuaternion(this.turn));
    this.changed();
  }

  // By a factor, about a place of the canvas that stays where it is.
  zoom(factor, x, y) {
    const right = x - 0.5 * this.canvas.clientWidth;
    const down = y - 0.5 * this.canvas.clientHeight;
    const before = this.half;
    this.half *= factor;
    const scale = 2 * (before - this.half) / Math.max(1, this.canvas.clientHeight);
    this.target.add(new THREE.Vector3(right * scale, -down * scale, 0).applyQuaternion(this.turn));
    this.changed();
  }

  listen() {
    const canvas = this.canvas;
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    for (const end of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(end, (event) => this.fingers.delete(event.pointerId));
    }
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.roll(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  press(event) {
    this.canvas.focus({ preventScroll: true });
    this.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    event.preventDefault();
  }

  get dragging() {
    return this.fingers.size > 0;
  }

  drag(event) {
    const last = this.fingers.get(event.pointerId);
    if (!last) {
      return;
    }
    const dx = event.offsetX - last.x;
    const dy = event.offsetY - last.y;
    if (this.fingers.size === 2) {
      this.pinch(event, dx, dy);
    } else if (this.plane || event.shiftKey || event.buttons !== 1) {
      this.pan(dx, dy);
    } else {
      const full = Math.min(this.canvas.clientWidth, this.canvas.clientHeight);
      this.rotate(Math.PI * dx / full, Math.PI * dy / full);
    }
    this.fingers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
  }

  // Two fingers move and stretch the picture.
  pinch(event, dx, dy) {
    const other = [...this.fingers].find(([id]) => id !== event.pointerId)[1];
    const last = this.fingers.get(event.pointerId);
    const before = Math.hypot(last.x - other.x, last.y - other.y);
    const after = Math.hypot(event.offsetX - other.x, event.offsetY - other.y);
    this.pan(0.5 * dx, 0.5 * dy);
    if (before > 1 && after > 1) {
      this.zoom(before / after, 0.5 * (event.offsetX + other.x), 0.5 * (event.offsetY + other.y));
    }
  }

  // The wheel scrolls the page unless the picture has been clicked on.
  roll(event) {
    if (document.activeElement !== this.canvas && !event.ctrlKey) {
      return;
    }
    event.preventDefault();
    const lines = event.deltaMode === 0 ? event.deltaY / 40 : event.deltaY;
    this.zoom(Math.exp(0.05 * Math.max(-10, Math.min(10, lines))), event.offsetX, event.offsetY);
  }

  key(event) {
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const arrow = arrows[event.key];
    const middle = [0.5 * this.canvas.clientWidth, 0.5 * this.canvas.clientHeight];
    if (arrow && (event.shiftKey || this.plane)) {
      this.pan(30 * arrow[0], 30 * arrow[1]);
    } else if (arrow) {
      this.rotate(0.12 * arrow[0], 0.12 * arrow[1]);
    } else if (event.key === "+" || event.key === "=") {
      this.zoom(1 / 1.15, ...middle);
    } else if (event.key === "-") {
      this.zoom(1.15, ...middle);
    } else {
      return;
    }
    event.preventDefault();
  }
}
