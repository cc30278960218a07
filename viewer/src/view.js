// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the viewer stands: a rotation, a shift and a zoom, in parallel projection, so that lengths can be read off
// the scale bar. One finger or the left button turns; two fingers, the right button or shift move; wheel and pinch zoom.

import { OrthographicCamera, Quaternion, Vector3 } from 'three';

const far = 4; // the scene is in a ball of radius 1 (medial balls a little beyond), the camera 2 away

export class View {
  constructor(state, canvas) {
    this.state = state;
    this.canvas = canvas;
    this.camera = new OrthographicCamera(-1, 1, 1, -1, 0, far);
    this.pointers = new Map();
    canvas.addEventListener('pointerdown', (event) => this.#down(event));
    canvas.addEventListener('pointermove', (event) => this.#move(event));
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  get isDragged() {
    return this.pointers.size > 0;
  }

  // Pixels of the page for a unit of the scene.
  get pixelsPerUnit() {
    const { clientWidth, clientHeight } = this.canvas;
    return (Math.min(clientWidth, clientHeight) / 2 / 1.02) * this.state.get('zoom');
  }

  // Sets up the camera as the state has it.
  update() {
    const { clientWidth, clientHeight } = this.canvas;
    const [panX, panY] = this.state.get('pan');
    const scale = this.pixelsPerUnit;
    const camera = this.camera;
    camera.left = -clientWidth / 2 / scale - panX;
    camera.right = clientWidth / 2 / scale - panX;
    camera.top = clientHeight / 2 / scale - panY;
    camera.bottom = -clientHeight / 2 / scale - panY;
    camera.quaternion.set(...this.state.get('view')).normalize();
    camera.position.set(0, 0, far / 2).applyQuaternion(camera.quaternion);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  // Turns about the axes of the screen, in radians.
  turn(right, up) {
    const q = new Quaternion(...this.state.get('view'));
    q.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), -right));
    q.multiply(new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), up));
    this.state.set({ view: q.normalize().toArray() });
  }

  // Moves by pixels.
  shift(right, up) {
    const [x, y] = this.state.get('pan');
    this.state.set({ pan: [x + right / this.pixelsPerUnit, y + up / this.pixelsPerUnit] });
  }

  // Zooms so that what is under a place of the canvas stays there.
  zoomBy(factor, x = this.canvas.clientWidth / 2, y = this.canvas.clientHeight / 2) {
    const zoom = Math.min(Math.max(this.state.get('zoom') * factor, 0.2), 40);
    const fromCentre = [x - this.canvas.clientWidth / 2, this.canvas.clientHeight / 2 - y];
    const before = this.pixelsPerUnit;
    const after = (before * zoom) / this.state.get('zoom');
    const pan = this.state.get('pan').map((p, i) => p + fromCentre[i] * (1 / after - 1 / before));
    this.state.set({ zoom, pan });
  }

  lookAlong(rotation) {
    this.state.set({ view: rotation, pan: [0, 0] });
  }

  // The ray through a place of the canvas: its first point and its direction, in the scene.
  ray(x, y) {
    const clip = new Vector3((2 * x) / this.canvas.clientWidth - 1, 1 - (2 * y) / this.canvas.clientHeight, -1);
    return { origin: clip.unproject(this.camera), direction: new Vector3(0, 0, -1).applyQuaternion(this.camera.quaternion) };
  }

  // Where on the canvas a point of the scene is.
  place(point) {
    const clip = point.clone().project(this.camera);
    return [((clip.x + 1) / 2) * this.canvas.clientWidth, ((1 - clip.y) / 2) * this.canvas.clientHeight];
  }

  #down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, event);
  }

  #move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    this.pointers.set(event.pointerId, event);
    const dx = event.clientX - before.clientX, dy = event.clientY - before.clientY;
    const other = [...this.pointers.values()].find((pointer) => pointer.pointerId !== event.pointerId);
    if (other) {
      this.shift(dx / 2, -dy / 2);
      const length = (pointer) => Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY);
      if (length(before) > 0) this.zoomBy(length(event) / length(before));
    } else if (event.buttons & 6 || event.shiftKey) {
      this.shift(dx, -dy);
    } else {
      const perPixel = Math.PI / Math.min(this.canvas.clientWidth, this.canvas.clientHeight);
      this.turn(dx * perPixel, -dy * perPixel);
    }
  }

  #wheel(event) {
    event.preventDefault();
    const box = this.canvas.getBoundingClientRect();
    this.zoomBy(Math.exp(-0.0015 * event.deltaY * (event.deltaMode === 1 ? 30 : 1)), event.clientX - box.left, event.clientY - box.top);
  }
}

// The rotation that looks against an axis, from its end towards its origin; against y from the other end, so that x
// runs to the right.
export function lookingAlong(axis, up, isFromBehind = false) {
  const towards = new Vector3().setComponent(axis, (axis === 1) === isFromBehind ? 1 : -1);
  const upward = new Vector3().setComponent(up, 1);
  return quaternionOf([upward.clone().cross(towards), upward, towards]);
}

// The rotation whose columns are three axes.
function quaternionOf([x, y, z]) {
  const trace = x.x + y.y + z.z;
  if (trace > -0.99) {
    const w = Math.sqrt(1 + trace) / 2;
    return [(y.z - z.y) / (4 * w), (z.x - x.z) / (4 * w), (x.y - y.x) / (4 * w), w];
  }
  // A half turn: about the axis that stays where it was, or between two that change places.
  const about = [x.x, y.y, z.z].map((d) => Math.sqrt(Math.max((1 + d) / 2, 0)));
  if (x.y + y.x < 0) about[1] *= -1;
  if (x.z + z.x < 0) about[2] *= -1;
  return [...about, 0];
}

// From the side that shows most of a box, a little from the left and above.
export function defaultView(low, high) {
  const extent = low.map((x, i) => high[i] - x);
  const axis = extent.indexOf(Math.min(...extent));
  const up = axis === 1 ? 2 : 1;
  const q = new Quaternion(...lookingAlong(axis, up));
  q.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), -0.35));
  q.multiply(new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -0.2));
  return q.normalize().toArray().map((x) => Number(x.toPrecision(5)));
}
