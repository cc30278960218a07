// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the page shows: a flat object whose changes are told to whoever watches, and which the fragment of
// the address holds, so that a picture can be had again.

import { mapPalettes, pointPalettes } from './palettes.js';

const number = {
  parse: (text) => (Number.isFinite(Number(text)) && text !== '' ? Number(text) : undefined),
  format: (value) => String(Number(value.toPrecision(5))),
};
const positive = { ...number, parse: (text) => (Number(text) > 0 ? number.parse(text) : undefined) };
const part = { ...number, parse: (text) => (Number(text) >= 0 && Number(text) <= 1 ? number.parse(text) : undefined) };
const whole = { parse: (text) => (/^-?\d{1,9}$/.test(text) ? Number(text) : undefined), format: String };
const matching = (pattern) => ({ parse: (text) => (pattern.test(text) ? text : undefined), format: String });
const oneOf = (...words) => ({ parse: (text) => (words.includes(text) ? text : undefined), format: String });
const flag = {
  parse: (text) => (text === '1' || text === '0' ? text === '1' : undefined),
  format: (value) => (value ? '1' : '0'),
};
const numbers = (length) => ({
  parse: (text) => {
    const values = text.split(',').map(Number);
    return values.length === length && values.every(Number.isFinite) ? values : undefined;
  },
  format: (values) => values.map(number.format).join(','),
});

const kinds = {
  view: numbers(4), // a rotation, as a quaternion
  pan: numbers(2),
  zoom: positive,
  theme: oneOf('auto', 'light', 'dark'),
  panel: flag,
  scale: matching(/^(joint|\d{1,3})$/), // or the number of a radius, from 0
  map: part, // opacity
  threshold: number,
  top: positive, // the value that has the last colour
  mip: flag,
  palette: oneOf(...mapPalettes),
  mesh: part, // opacity
  points: flag,
  pointsize: number, // of the radius
  pointmin: number, // intensity
  pointcolour: oneOf('sphericity', 'intensity', 'radius', 'observed_fraction'),
  pointpalette: oneOf(...pointPalettes),
  select: whole, // the number of a salient point, or -1
  lines: flag,
  linesize: number,
  balls: flag,
  ballsize: number,
  ballmin: number, // importance
  holes: flag,
  clip: numbers(6), // low and high along x, y, z, as parts of the box
};

export class State {
  #values;
  #defaults;
  #watchers = [];
  #timer = 0;

  constructor(defaults) {
    this.#defaults = defaults;
    this.#values = { ...defaults };
    this.readFragment();
    window.addEventListener('hashchange', () => this.readFragment());
  }

  get(key) {
    return this.#values[key];
  }

  default(key) {
    return this.#defaults[key];
  }

  // Calls `watcher(changed keys)`.
  watch(watcher) {
    this.#watchers.push(watcher);
  }

  set(changes) {
    const changed = new Set(Object.keys(changes).filter((key) => !equal(this.#values[key], changes[key])));
    if (changed.size === 0) return;
    Object.assign(this.#values, changes);
    for (const watcher of this.#watchers) watcher(changed);
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#writeFragment(), 250);
  }

  reset() {
    this.set(this.#defaults);
  }

  fragment() {
    return Object.keys(kinds)
      .filter((key) => !equal(this.#values[key], this.#defaults[key]))
      .map((key) => `${key}=${encodeURIComponent(kinds[key].format(this.#values[key])).replace(/%2C/g, ',')}`)
      .join('&');
  }

  // What is not understood, or not named, has its default.
  readFragment() {
    const given = new URLSearchParams(location.hash.slice(1));
    const values = { ...this.#defaults };
    for (const [key, text] of given) {
      const value = Object.hasOwn(kinds, key) ? kinds[key].parse(text) : undefined;
      if (value !== undefined) values[key] = value;
    }
    this.set(values);
  }

  #writeFragment() {
    history.replaceState(null, '', `#${this.fragment()}`);
  }
}

function equal(a, b) {
  return Array.isArray(a) ? a.every((value, i) => value === b[i]) : a === b;
}
