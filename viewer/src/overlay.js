// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What lies over the picture: the colour bar, the scale bar, the axes, and the note at the pointer.

import { Vector3 } from 'three';
import { element, svg } from './dom.js';
import { niceBelow, significant, ticks } from './format.js';
import { gradient } from './palettes.js';

const barHeight = 150;

export class ColourBar {
  constructor() {
    this.title = element('div', { class: 'bar-title' });
    this.strip = element('div', { class: 'bar-strip' });
    this.scale = svg('svg', { class: 'bar-scale', width: 96, height: barHeight + 12, viewBox: `0 -6 96 ${barHeight + 12}`, 'aria-hidden': 'true' });
    this.root = element('figure', { class: 'colour-bar', 'aria-label': 'Colours of the map' },
      this.title, element('div', { class: 'bar-body' }, this.strip, this.scale));
  }

  // `marks` are [value, name] of values that mean something.
  show({ title, palette, threshold, top, marks }) {
    this.title.replaceChildren(title);
    this.strip.style.background = gradient(palette, 'to top');
    const y = (value) => barHeight * (1 - value / top);
    const nodes = ticks(0, top, 4).map((value) => svg('g', {},
      svg('path', { d: `M0 ${y(value)}h5` }),
      svg('text', { x: 9, y: y(value) + 3.5 }, significant(value, 3))));
    for (const [value, name] of marks)
      if (value < top && value > 0)
        nodes.push(svg('g', { class: 'mark' }, svg('path', { d: `M40 ${y(value)}h5` }), svg('text', { x: 48, y: y(value) + 3.5 }, name)));
    if (threshold > 0 && threshold < top)
      nodes.push(svg('path', { class: 'threshold', d: `M-1 ${y(threshold)}l-6 -4v8z` }));
    this.scale.replaceChildren(...nodes);
  }
}

export class ScaleBar {
  constructor() {
    this.line = svg('path', {});
    this.label = svg('text', { 'text-anchor': 'end', x: 0, y: -8 });
    this.root = svg('svg', { class: 'scale-bar', width: 200, height: 30, viewBox: '-198 -24 200 30', 'aria-hidden': 'true' }, this.line, this.label);
  }

  // As long as a round number of units of the mesh.
  update(pixelsPerLength) {
    const length = niceBelow(120 / pixelsPerLength);
    this.line.setAttribute('d', `M0 -4v4H${-length * pixelsPerLength}v-4`);
    this.label.textContent = significant(length, 3);
  }
}

export class Axes {
  constructor() {
    this.root = svg('svg', { class: 'axes', width: 64, height: 64, viewBox: '-32 -32 64 64', 'aria-hidden': 'true' });
  }

  update(camera) {
    const inverse = camera.quaternion.clone().invert();
    const arms = ['x', 'y', 'z'].map((name, i) => ({ name, v: new Vector3().setComponent(i, 1).applyQuaternion(inverse) }));
    arms.sort((a, b) => a.v.z - b.v.z);
    this.root.replaceChildren(...arms.map(({ name, v }) => svg('g', { class: `axis-${name}`, opacity: 0.55 + 0.45 * Math.max(v.z, 0) },
      svg('path', { d: `M0 0L${19 * v.x} ${-19 * v.y}` }),
      svg('text', { x: 26 * v.x, y: -26 * v.y + 3.5, 'text-anchor': 'middle' }, name))));
  }
}

// Names and values beside the pointer.
export class Note {
  constructor() {
    this.root = element('div', { class: 'note', role: 'status', hidden: true });
  }

  show(title, rows, x, y, width) {
    this.root.replaceChildren(element('b', {}, title),
      element('dl', {}, rows.map(([name, value]) => [element('dt', {}, name), element('dd', {}, value)])));
    this.root.hidden = false;
    this.root.style.left = `${Math.min(x + 14, width - this.root.offsetWidth - 8)}px`;
    this.root.style.top = `${Math.max(y - this.root.offsetHeight - 10, 8)}px`;
  }

  hide() {
    this.root.hidden = true;
  }
}
