// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The elements of the panel, each bound to one thing of the state.

import { element } from './dom.js';

export class Controls {
  #updates = [];

  constructor(state) {
    this.state = state;
    state.watch((changed) => this.update(changed));
  }

  update(changed) {
    for (const { key, update } of this.#updates) if (!changed || changed.has(key)) update(this.state.get(key));
  }

  #bind(key, update) {
    this.#updates.push({ key, update });
    update(this.state.get(key));
  }

  // `text(value)` is what stands at its right end.
  slider(label, key, { min, max, step, text, toValue = Number, toPlace = Number }) {
    const output = element('output', {});
    const input = element('input', {
      type: 'range', min, max, step, 'data-key': key, 'aria-label': label,
      oninput: () => this.state.set({ [key]: toValue(input.value) }),
    });
    this.#bind(key, (value) => {
      input.value = toPlace(value);
      output.textContent = text(value);
      input.setAttribute('aria-valuetext', output.textContent);
      paintTrack(input);
    });
    return element('label', { class: 'row slider' }, element('span', {}, label), input, output);
  }

  toggle(label, key) {
    const input = element('input', { type: 'checkbox', 'data-key': key, onchange: () => this.state.set({ [key]: input.checked }) });
    this.#bind(key, (value) => { input.checked = value; });
    return element('label', { class: 'toggle' }, input, element('span', {}, label));
  }

  select(label, key, options) {
    const select = element('select', { 'data-key': key, onchange: () => this.state.set({ [key]: select.value }) },
      options.map(([value, text]) => element('option', { value }, text)));
    this.#bind(key, (value) => { select.value = value; });
    return element('label', { class: 'row' }, element('span', {}, label), select);
  }

  // Two handles on one track, for the places 2 axis and 2 axis + 1 of a list of parts from 0 to 1.
  range(label, key, axis, text) {
    const output = element('output', {});
    const handles = [0, 1].map((side) => element('input', {
      type: 'range', min: 0, max: 1, step: 0.005, 'data-key': `${key}${2 * axis + side}`,
      'aria-label': `${label}, ${side === 0 ? 'from' : 'to'}`,
      oninput: (event) => {
        const values = [...this.state.get(key)];
        const wanted = Number(event.target.value);
        values[2 * axis + side] = side === 0 ? Math.min(wanted, values[2 * axis + 1] - 0.005) : Math.max(wanted, values[2 * axis] + 0.005);
        event.target.value = values[2 * axis + side];
        this.state.set({ [key]: values });
      },
    }));
    const track = element('div', { class: 'range' }, handles);
    this.#bind(key, (values) => {
      const [low, high] = [values[2 * axis], values[2 * axis + 1]];
      handles[0].value = low;
      handles[1].value = high;
      track.style.setProperty('--low', `${100 * low}%`);
      track.style.setProperty('--high', `${100 * high}%`);
      output.textContent = text(low, high);
    });
    return element('div', { class: 'row slider' }, element('span', {}, label), track, output);
  }
}

function paintTrack(input) {
  const part = (input.value - input.min) / (input.max - input.min || 1);
  input.style.setProperty('--part', `${100 * part}%`);
}

// A part of the panel that can be closed; `toggle` is in its heading.
export function section(title, { toggle, isOpen = true, note } = {}, ...content) {
  return element('details', { class: 'section', open: isOpen },
    element('summary', {}, element('h2', {}, title), note ? element('span', { class: 'note-right' }, note) : null, toggle ?? null),
    element('div', { class: 'section-body' }, content));
}
