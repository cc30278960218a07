// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The picture with what lies over it: keeps what is drawn in step with the state, and answers the pointer.

import { Vector3 } from 'three';
import { element, svg } from './dom.js';
import { fixed, lengthFormat, percent, significant, uncertainty } from './format.js';
import { Axes, ColourBar, Note, ScaleBar } from './overlay.js';
import { colour } from './palettes.js';
import { Field, pickBall, pickLine, strongestAlong } from './picking.js';
import { Picture } from './picture.js';
import { View } from './view.js';

const colours = {
  light: { ground: [0.965, 0.969, 0.973], mesh: [0.5, 0.55, 0.6], line: [0.78, 0.16, 0.2], points: [0.4, 0.45, 0.5] },
  dark: { ground: [0.078, 0.09, 0.102], mesh: [0.78, 0.82, 0.86], line: [0.98, 0.36, 0.34], points: [0.6, 0.65, 0.7] },
};

export class Stage {
  constructor(content, state, lengths) {
    this.content = content;
    this.state = state;
    this.lengths = lengths;
    this.coordinates = lengthFormat(content.frame.unit);
    this.canvas = element('canvas', { tabindex: 0, 'aria-label': 'The shape, in three dimensions; keys are listed in the panel' });
    this.colourBar = new ColourBar();
    this.scaleBar = new ScaleBar();
    this.axes = new Axes();
    this.note = new Note();
    this.halo = svg('svg', { class: 'halo', 'aria-hidden': 'true' });
    this.root = element('section', { class: 'stage', 'aria-label': 'Picture' },
      this.canvas, this.halo, this.colourBar.root, this.axes.root, this.scaleBar.root, this.note.root);
    this.hovered = -1; // the salient point under the pointer
    this.dark = window.matchMedia('(prefers-color-scheme: dark)');
  }

  // Needs the canvas in the page.
  start() {
    const { content, state } = this;
    this.view = new View(state, this.canvas);
    this.picture = new Picture(this.canvas, this.view, content.volume, content.surface);
    for (const part of [content.cloud, content.holes, content.lines, content.medial, content.salient])
      if (part) this.picture.opaque.add(part.object);
    state.watch((changed) => this.#follow(changed));
    this.#follow(null);
    this.dark.addEventListener('change', () => this.#follow(new Set(['theme'])));
    new ResizeObserver(() => this.#redraw()).observe(this.canvas);
    this.canvas.addEventListener('pointermove', (event) => this.#hover(event));
    this.canvas.addEventListener('pointerleave', () => this.#leave());
    this.canvas.addEventListener('click', (event) => this.#click(event));
  }

  get isDark() {
    const theme = this.state.get('theme');
    return theme === 'dark' || (theme !== 'light' && this.dark.matches);
  }

  // The corners of what the clip planes leave, in the scene.
  get clip() {
    const { low, high } = this.content.frame;
    const parts = this.state.get('clip');
    const at = (axis, part) => low[axis] + part * (high[axis] - low[axis]);
    return [[0, 1, 2].map((i) => at(i, parts[2 * i])), [0, 1, 2].map((i) => at(i, parts[2 * i + 1]))];
  }

  // What of the state each part depends on; all of it at first.
  #follow(changed) {
    const has = (...keys) => !changed || keys.some((key) => changed.has(key));
    if (has('theme')) this.#followTheme();
    if (has('scale')) this.content.volume.show(this.content.maps.get(this.state.get('scale')));
    if (has('scale', 'map', 'threshold', 'top', 'mip', 'palette')) this.#followMap(has('palette'));
    if (has('mesh')) this.#followSurface();
    if (has('clip')) this.#followClip();
    if (has('points', 'pointsize', 'pointmin', 'pointcolour', 'pointpalette')) this.#followPoints();
    if (has('lines', 'linesize')) this.#followLines();
    if (has('balls', 'ballsize', 'ballmin', 'palette', 'top')) this.#followBalls();
    if (has('map', 'balls')) this.colourBar.root.hidden = this.state.get('map') === 0 && !(this.content.medial && this.state.get('balls'));
    if (has('holes') && this.content.holes) this.content.holes.object.visible = this.state.get('holes');
    this.#redraw();
  }

  #followTheme() {
    document.documentElement.classList.toggle('dark', this.isDark);
    const { ground, mesh, line, points } = this.isDark ? colours.dark : colours.light;
    this.picture.background.setRGB(...ground);
    this.content.surface?.setColour(mesh);
    this.content.lines?.uniforms.colour.value.setRGB(...line);
    this.content.cloud?.paint(() => points, () => true);
  }

  #followMap(isOtherPalette) {
    const { state } = this;
    const { volume } = this.content;
    const palette = state.get('palette');
    if (isOtherPalette) volume.setPalette(palette);
    volume.uniforms.opacity.value = state.get('map');
    volume.uniforms.threshold.value = state.get('threshold');
    volume.uniforms.top.value = state.get('top');
    volume.uniforms.isMaximum.value = state.get('mip');
    this.colourBar.show({ title: this.#titleOfMap(), palette, threshold: state.get('threshold'), top: state.get('top'), marks: this.content.marksOf(state.get('scale')) });
  }

  #titleOfMap() {
    const map = this.content.maps.get(this.state.get('scale'));
    const name = map.radius === undefined ? 'MAPT, joint map' : `MAPT, R = ${this.lengths(map.radius)}`;
    return this.state.get('mip') ? `${name}\nlargest along the ray` : name;
  }

  // Points are the smaller, the less a surface would be seen.
  #followSurface() {
    const { surface, cloud } = this.content;
    const opacity = this.state.get('mesh');
    surface?.setOpacity(opacity);
    if (!cloud) return;
    cloud.object.visible = opacity > 0;
    cloud.uniforms.least.value = 0.035 * opacity;
  }

  #followClip() {
    const [low, high] = this.clip;
    this.content.surface?.setClip(low, high);
    this.content.volume.setClip(low.map((x, i) => (this.state.get('clip')[2 * i] === 0 ? -9 : x)),
      high.map((x, i) => (this.state.get('clip')[2 * i + 1] === 1 ? 9 : x)));
  }

  isPointShown(index) {
    return this.content.report.salient[index].intensity >= this.state.get('pointmin');
  }

  #followPoints() {
    const { salient, report } = this.content;
    if (!salient) return;
    salient.object.visible = this.state.get('points');
    salient.uniforms.scale.value = this.state.get('pointsize');
    salient.uniforms.least.value = 0.008;
    const key = this.state.get('pointcolour');
    const [low, high] = this.rangeOfPoints(key);
    salient.paint((i) => colour(this.state.get('pointpalette'), (report.salient[i][key] - low) / (high - low || 1)), (i) => this.isPointShown(i));
  }

  // The values that have the first and the last colour.
  rangeOfPoints(key) {
    if (key === 'sphericity') return [0, 1];
    const values = this.content.report.salient.map((point) => point[key]);
    return [key === 'intensity' ? 0 : Math.min(...values), Math.max(...values)];
  }

  #followLines() {
    if (!this.content.lines) return;
    this.content.lines.object.visible = this.state.get('lines');
    this.content.lines.uniforms.scale.value = this.state.get('linesize');
  }

  #followBalls() {
    const { medial } = this.content;
    if (!medial) return;
    medial.object.visible = this.state.get('balls');
    medial.uniforms.scale.value = this.state.get('ballsize');
    medial.uniforms.least.value = 0.004;
    const [palette, top] = [this.state.get('palette'), this.state.get('top')];
    medial.paint((i) => colour(palette, medial.mapt[i] / top), (i) => medial.importance[i] >= this.state.get('ballmin'));
  }

  #redraw() {
    this.view.update();
    this.scaleBar.update(this.view.pixelsPerUnit / this.content.frame.unit);
    this.axes.update(this.view.camera);
    this.#drawHalo();
    this.picture.request();
  }

  // A circle of the radius of the point that is selected or under the pointer, and the axis of a tube.
  #drawHalo() {
    const { salient, report, frame } = this.content;
    const marked = [this.hovered, this.state.get('select')].filter((i, k, all) => salient && i >= 0 && i < salient.number && all.indexOf(i) === k);
    this.halo.replaceChildren(...marked.flatMap((i) => {
      const point = report.salient[i];
      const centre = new Vector3().fromArray(salient.centres, 3 * i);
      const [cx, cy] = this.view.place(centre);
      const circle = svg('circle', { cx, cy, r: salient.radii[i] * this.view.pixelsPerUnit });
      if (point.axis_x === null || !point.length) return [circle];
      const along = new Vector3(point.axis_x, point.axis_y, point.axis_z).multiplyScalar(point.length / 2 / frame.unit);
      const [a, b] = [1, -1].map((sign) => this.view.place(centre.clone().addScaledVector(along, sign)));
      return [circle, svg('path', { d: `M${a}L${b}`, 'stroke-dasharray': '5 4' })];
    }));
  }

  markPoint(index) {
    this.hovered = index;
    this.#drawHalo();
  }

  // The salient point, ball, line or value at a place of the canvas: { title, rows, point }.
  #under(x, y) {
    const ray = this.view.ray(x, y);
    const pixel = 1 / this.view.pixelsPerUnit;
    const { salient, medial, lines } = this.content;
    const found = [];
    const add = (part, key, hit, describe) => {
      if (part && this.state.get(key)) {
        const best = hit();
        if (best) found.push({ depth: best.depth, describe: () => describe(best) });
      }
    };
    add(salient, 'points', () => pickBall(salient, ray, 2 * pixel), ({ index }) => this.#describePoint(index));
    add(medial, 'balls', () => pickBall(medial, ray, pixel), ({ index }) => this.#describeBall(index));
    add(lines, 'lines', () => pickLine(lines.polylines, ray, 5 * pixel), (hit) => this.#describeLine(hit));
    found.sort((a, b) => a.depth - b.depth);
    return found[0]?.describe() ?? this.#describeMap(ray);
  }

  #radiusOf(point) {
    const half = uncertainty(point);
    return half === null ? this.lengths(point.radius) : `${this.lengths(point.radius)} ± ${significant(half, 2)}`;
  }

  #describePoint(index) {
    const p = this.content.report.salient[index];
    return {
      point: index,
      title: `Salient point ${index + 1}: ${p.type}`,
      rows: [['R', this.#radiusOf(p)],
        ['MAPT', fixed(p.intensity, 3)], ['sphericity', fixed(p.sphericity)], ['seen', percent(p.observed_fraction)],
        ['raw scale', this.lengths(p.scale)], ['at', this.#place([p.x, p.y, p.z])]],
    };
  }

  #describeBall(i) {
    const { medial, frame } = this.content;
    return {
      title: 'Medial ball',
      rows: [['R', this.lengths(medial.radii[i] * frame.unit)], ['MAPT', fixed(medial.mapt[i], 3)], ['importance', this.lengths(medial.importance[i])]],
    };
  }

  #describeLine({ branch, radius }) {
    const { length, mean_radius: mean, score } = this.content.report.lines.branches[branch];
    return {
      title: `Centreline, branch ${branch}`,
      rows: [['R here', this.lengths(radius * this.content.frame.unit)], ['R, mean', this.lengths(mean)], ['length', significant(length)], ['score', fixed(score)]],
    };
  }

  #describeMap(ray) {
    if (this.state.get('map') === 0) return null;
    const { maps, volume, frame } = this.content;
    const map = maps.get(this.state.get('scale'));
    const best = strongestAlong(new Field(map), volume, ray, ...this.clip);
    if (!best || best.value < 0.01 * maps.largest) return null;
    return {
      title: 'Largest value of the map on this ray',
      rows: [['MAPT', fixed(best.value, 3)], ['R', this.lengths(map.radius ?? this.#radiusAt(best.voxel))],
        ['at', this.#place(best.point.map((x, i) => frame.fromScene(x, i)))]],
    };
  }

  // The radius whose map is largest at a voxel.
  #radiusAt(voxel) {
    const { maps } = this.content;
    const values = maps.ofRadii.map((_, k) => new Field(maps.get(k)).at(...voxel));
    return maps.ofRadii[values.indexOf(Math.max(...values))].radius;
  }

  #place(coordinates) {
    return coordinates.map(this.coordinates).join(', ');
  }

  #hover(event) {
    if (this.view.isDragged) return this.note.hide();
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const found = this.#under(x, y);
    this.markPoint(found?.point ?? -1);
    if (found) this.note.show(found.title, found.rows, x, y, box.width);
    else this.note.hide();
  }

  #leave() {
    this.note.hide();
    this.markPoint(-1);
  }

  #click(event) {
    const box = this.canvas.getBoundingClientRect();
    const found = this.#under(event.clientX - box.left, event.clientY - box.top);
    if (found?.point !== undefined) this.state.set({ select: found.point });
  }

  savePicture(name) {
    this.canvas.toBlob((blob) => {
      const link = element('a', { href: URL.createObjectURL(blob), download: name });
      link.click();
      URL.revokeObjectURL(link.href);
    });
  }
}
