// SPDX-License-Identifier: GPL-3.0-or-later
// What the pointer reads in the picture: K of a front, or the value of a body.

class Readings {
  constructor(view) {
    this.view = view;
    const canvas = view.parts.canvas;
    canvas.addEventListener("pointermove", (event) => this.readLater(event));
    canvas.addEventListener("pointerleave", () => this.hideTip());
  }

  readLater(event) {
    const place = { x: event.offsetX, y: event.offsetY };
    if (this.view.eye.dragging) {
      this.hideTip();
      return;
    }
    if (!this.reading) {
      requestAnimationFrame(() => {
        this.tell(this.reading);
        this.reading = null;
      });
    }
    this.reading = place;
  }

  hideTip() {
    this.view.parts.tip.hidden = true;
  }

  // K of a front's point, or net, node, place and value of a body, under the pointer.
  tell(at) {
    const { clientWidth: width, clientHeight: height } = this.view.parts.canvas;
    const [x, y] = [2 * at.x / width - 1, 1 - 2 * at.y / height];
    const lines = this.wordsOfFront(x, y, width, height) ||
      this.wordsOfBody(this.view.scene.pick(this.view.eye, x, y));
    const tip = this.view.parts.tip;
    tip.hidden = !lines;
    if (lines) {
      tip.replaceChildren(...lines.filter(Boolean).map((words) => element("div", { textContent: words })));
      const left = at.x + 14 + tip.offsetWidth > width ? Math.max(0, at.x - 14 - tip.offsetWidth) : at.x + 14;
      const top = at.y + 14 + tip.offsetHeight > height ? Math.max(0, at.y - 14 - tip.offsetHeight) : at.y + 14;
      Object.assign(tip.style, { left: `${left}px`, top: `${top}px` });
    }
  }

  wordsOfFront(x, y, width, height) {
    const fronts = this.view.length.fronts;
    const seen = (place) => this.view.scene.seenPlace(place, this.view.step.u, this.view.factor);
    const hit = this.view.scene.nearestOf(fronts.map((front) => front.x), seen, this.view.eye, x, y, width, height);
    if (!hit) {
      return null;
    }
    const front = fronts[hit.list];
    const K = this.view.step.raw.K1[hit.list][hit.at];
    return [front.x.length > 1 ? `${front.name}, point ${hit.at + 1}` : front.name,
      `at ${this.placeWords(front.x[hit.at])}`,
      K === null ? "K here depends on the mesh" : `K₁ ${shortNumber(K)} ${this.view.data.kUnit}`];
  }

  placeWords(x) {
    return `${[...x].slice(0, this.view.data.dim).map(shortNumber).join(", ")} ${this.view.data.lengthUnit}`;
  }

  wordsOfBody(hit) {
    if (!hit || hit.inside) {
      return hit && [`${this.view.bodyName(hit.body)}, cut`];
    }
    const { surface } = this.view.length;
    const value = Number.isFinite(hit.value) ? `${shortNumber(hit.value)} ${this.view.field.unit}` : "not known here";
    return [`${this.view.bodyName(hit.body)}, node ${surface.label[hit.point]}`,
      `at ${this.placeWords(surface.x.subarray(3 * hit.point, 3 * hit.point + 3))}`,
      this.view.scene.values ? `${this.view.field.name} ${value}` : ""];
  }
}
