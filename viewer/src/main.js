// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The page of mapt report: reads the data, builds what is seen, and says so if the browser cannot show it.

import { Content } from './content.js';
import { defaults } from './defaults.js';
import { element } from './dom.js';
import { lengthFormat } from './format.js';
import { axisView, listenToKeys } from './keys.js';
import { buildPanel } from './panel.js';
import { readReport } from './payload.js';
import { Stage } from './stage.js';
import { State } from './state.js';

const app = document.getElementById('app');

// Why this browser cannot show the page, or nothing.
function whatIsMissing() {
  if (typeof DecompressionStream === 'undefined')
    return 'this browser cannot unpack compressed data (DecompressionStream). Chrome and Edge 94, Firefox 113, Safari 16.4 and newer can.';
  if (!document.createElement('canvas').getContext('webgl2'))
    return 'this browser has no WebGL 2, or it is switched off: see its settings for graphics acceleration.';
  return null;
}

function toolbar(stage, state, name) {
  const button = (text, label, onclick) => element('button', { type: 'button', title: label, 'aria-label': label, onclick }, text);
  return element('div', { class: 'tools', role: 'toolbar', 'aria-label': 'View' },
    element('div', {}, ['x', 'y', 'z'].map((axis, i) => button(axis, `look along ${axis}`, () => stage.view.lookAlong(axisView(i)))),
      button('Reset', 'the view as it was at first', () => state.set({ view: state.default('view'), pan: [0, 0], zoom: 1 }))),
    element('div', {},
      button('◐', 'light or dark', () => state.set({ theme: stage.isDark ? 'light' : 'dark' })),
      button('Save', 'save the picture (PNG)', () => stage.savePicture(`${name}.png`)),
      button('⇥', 'show or hide the panel', () => state.set({ panel: !state.get('panel') }))));
}

function fail(reason) {
  app.replaceChildren(element('p', { class: 'message' }, element('b', {}, 'The report cannot be shown: '), reason));
  document.body.classList.add('failed');
}

async function start() {
  const reason = whatIsMissing();
  if (reason) return fail(reason);
  const { report, arrays } = await readReport();
  document.title = `${report.name} – mapt report`;
  const content = new Content(report, arrays);
  const state = new State(defaults(content));
  const lengths = lengthFormat(Math.max(...report.parameters.radii));
  const stage = new Stage(content, state, lengths);
  stage.root.append(toolbar(stage, state, report.name));
  app.append(stage.root, buildPanel(stage, state, content, lengths));
  const followPanel = () => {
    app.classList.toggle('without-panel', !state.get('panel'));
    app.querySelector('.panel').hidden = !state.get('panel');
  };
  followPanel();
  state.watch((changed) => { if (changed.has('panel')) followPanel(); });
  stage.start();
  listenToKeys(stage, state, content);
  stage.picture.onPass = (isRefined) => {
    document.body.classList.add('ready');
    document.body.classList.toggle('refined', isRefined);
  };
}

start().catch((error) => {
  fail(`${error.message}. The file may be damaged: write it again with mapt report.`);
  throw error;
});
