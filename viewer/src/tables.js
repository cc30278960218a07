// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is told in rows: the salient points, and pairs of names and values.

import { element } from './dom.js';
import { fixed, lengthFormat, percent, uncertainty } from './format.js';

export class PointTable {
  // `onPoint(index)` is called with the row under the pointer (or -1), `onSelect(index)` with the one that is chosen.
  constructor(points, { onPoint, onSelect }) {
    const lengths = lengthFormat(Math.max(...points.map(({ radius }) => radius ?? 0)));
    this.columns = [
      { name: '#', of: (p) => p.index + 1, text: String },
      { name: 'type', of: (p) => p.type, text: String },
      { name: 'R', of: (p) => p.radius, text: lengths, title: 'radius of the fitted shape' },
      { name: '±', of: uncertainty, text: (half) => (half === null ? '–' : lengths(half)), title: 'half of the interval that holds the radius with a probability of 95 %' },
      { name: 'MAPT', of: (p) => p.intensity, text: fixed, title: 'intensity: the largest value over the radii' },
      { name: 'sph.', of: (p) => p.sphericity, text: fixed, title: 'sphericity: 1 if the map extends as far in all directions' },
      { name: 'seen', of: (p) => p.observed_fraction, text: percent, title: 'the part of the shape that is there' },
    ];
    this.points = points.map((point, index) => ({ ...point, index }));
    this.order = { column: 0, sign: 1 };
    this.body = element('tbody', {});
    this.heads = this.columns.map(({ name, title }, i) => element('th', { scope: 'col', title },
      element('button', { type: 'button', onclick: () => this.sortBy(i) }, name)));
    this.rows = this.points.map((point) => element('tr', {
      tabindex: 0,
      onpointerenter: () => onPoint(point.index),
      onpointerleave: () => onPoint(-1),
      onclick: () => onSelect(point.index),
      onkeydown: (event) => this.#key(event, point.index, onSelect),
    }, this.columns.map((column) => element('td', {}, column.text(column.of(point))))));
    this.body.append(...this.rows);
    this.root = element('div', { class: 'table-scroll' },
      element('table', {}, element('thead', {}, element('tr', {}, this.heads)), this.body));
  }

  sortBy(column) {
    this.order = { column, sign: this.order.column === column ? -this.order.sign : column < 2 ? 1 : -1 };
    const { of } = this.columns[column];
    const sorted = [...this.points].sort((a, b) => {
      const [x, y] = [of(a), of(b)];
      return this.order.sign * (typeof x === 'string' ? x.localeCompare(y) : (x ?? -Infinity) - (y ?? -Infinity)) || a.index - b.index;
    });
    this.body.append(...sorted.map(({ index }) => this.rows[index]));
    this.heads.forEach((head, i) => head.setAttribute('aria-sort', i !== column ? 'none' : this.order.sign > 0 ? 'ascending' : 'descending'));
  }

  select(index) {
    this.rows.forEach((row, i) => row.setAttribute('aria-selected', i === index));
    const row = this.rows[index];
    if (!row) return;
    // Not scrollIntoView(), which would scroll the panel and the page, too.
    if (row.offsetTop < this.root.scrollTop + 28) this.root.scrollTop = row.offsetTop - 28;
    const bottom = row.offsetTop + row.offsetHeight;
    if (bottom > this.root.scrollTop + this.root.clientHeight) this.root.scrollTop = bottom - this.root.clientHeight;
  }

  // Which points are shown, so that the others are faint.
  show(isShown) {
    this.rows.forEach((row, i) => row.classList.toggle('faint', !isShown(i)));
  }

  #key(event, index, onSelect) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === 'Enter' || event.key === ' ') onSelect(index);
    else if (step) {
      const rows = [...this.body.rows];
      const next = rows[rows.indexOf(this.rows[index]) + step];
      next?.focus();
      if (next) onSelect(this.rows.indexOf(next));
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }
}

export function pairs(rows) {
  return element('dl', { class: 'pairs' },
    rows.filter(([, value]) => value !== null && value !== undefined && value !== '')
      .map(([name, value]) => [element('dt', {}, name), element('dd', {}, value)]));
}

// Times as bars, so that one sees what takes long.
export function timings(steps, format) {
  const longest = Math.max(...steps.map(([, value]) => value), 1e-9);
  return element('table', { class: 'timings' }, element('tbody', {}, steps.map(([name, value]) => {
    const bar = element('meter', { min: 0, max: longest, value, 'aria-hidden': 'true' });
    return element('tr', {}, element('th', { scope: 'row' }, name), element('td', {}, bar), element('td', {}, format(value)));
  })));
}
