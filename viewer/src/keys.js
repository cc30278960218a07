// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the keyboard does while the picture has the focus, or nothing has it.

import { element } from './dom.js';
import { lookingAlong } from './view.js';

const turn = Math.PI / 24;
const shift = 24; // pixels

const names = [
  ['← ↑ → ↓', 'turn'], ['Shift ← ↑ → ↓', 'move'], ['+ −', 'zoom'], ['x y z', 'look along an axis; Shift: from behind'],
  ['0', 'as it was at first'], ['[ ]', 'smaller, larger radius; all'], ['m', 'largest value along each ray'],
  ['p l b h', 'points, lines, balls, edges of holes'], ['n', 'next salient point; Shift: previous'],
  ['t', 'light or dark'], ['f', 'picture without the panel'],
];

export function keysOfPage() {
  return element('dl', { class: 'keys' }, names.map(([keys, what]) => [
    element('dt', {}, keys.split(' ').map((key) => [element('kbd', {}, key), ' '])), element('dd', {}, what)]));
}

// Along an axis, with z upward, or y if that is the axis.
export function axisView(axis, isFromBehind = false) {
  return lookingAlong(axis, axis === 2 ? 1 : 2, isFromBehind);
}

export function listenToKeys(stage, state, content) {
  const number = content.maps.ofRadii.length;
  const flip = (key) => state.set({ [key]: !state.get(key) });
  const nextScale = (step) => {
    const scales = ['joint', ...Array.from({ length: number }, (_, k) => String(k))];
    const at = scales.indexOf(String(state.get('scale'))) + step;
    if (scales[at] !== undefined) state.set({ scale: scales[at] });
  };
  const nextPoint = (step) => {
    const points = content.salient?.number ?? 0;
    if (points > 0) state.set({ select: (state.get('select') + step + points) % points });
  };
  const arrow = (right, up) => (event) => (event.shiftKey
    ? stage.view.shift(shift * right, shift * up) : stage.view.turn(turn * right, turn * up));
  const look = (axis) => (event) => stage.view.lookAlong(axisView(axis, event.shiftKey));
  const actions = {
    arrowleft: arrow(-1, 0), arrowright: arrow(1, 0), arrowup: arrow(0, 1), arrowdown: arrow(0, -1),
    '+': () => stage.view.zoomBy(1.2), '=': () => stage.view.zoomBy(1.2), '-': () => stage.view.zoomBy(1 / 1.2),
    x: look(0), y: look(1), z: look(2),
    0: () => state.set({ view: state.default('view'), pan: [0, 0], zoom: 1 }),
    '[': () => nextScale(-1), ']': () => nextScale(1), m: () => flip('mip'),
    p: () => content.salient && flip('points'), l: () => content.lines && flip('lines'),
    b: () => content.medial && flip('balls'), h: () => content.holes && flip('holes'),
    n: (event) => nextPoint(event.shiftKey ? -1 : 1),
    t: () => state.set({ theme: stage.isDark ? 'light' : 'dark' }), f: () => flip('panel'),
  };
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target !== stage.canvas && event.target !== document.body) return;
    const action = actions[event.key.toLowerCase()];
    if (!action) return;
    action(event);
    event.preventDefault();
  });
}
